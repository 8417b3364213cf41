//! Meshes that an MJCF file declares under `<asset>`.

use super::element::{Defaults, Element};
use crate::meshes::{Bounds, MeshFrame, Meshes};
use crate::pose::quaternion_turn;
use crate::xml::elements;
use nalgebra::Vector3;
use roxmltree::Node;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Meshes of a file by name.
#[derive(Default)]
pub struct MeshAssets(BTreeMap<String, MeshAsset>);

/// A mesh: its vertices, and the frame in which they are read. `Err` is the reason why the mesh is not read.
struct MeshAsset {
    /// Vertices of the mesh.
    vertices: Result<Vertices, String>,
    /// Frame of the mesh in the coordinates of its vertices.
    frame: Result<MeshFrame, String>,
}

/// Vertices of a mesh.
enum Vertices {
    /// Vertices in a file.
    File(PathBuf),
    /// Numbers of the description, three for each vertex.
    Stated(Vec<f64>),
}

impl MeshAssets {
    /// Reads the meshes of all `<asset>` elements. A later mesh replaces an earlier one with the same name.
    pub fn new(root: Node<'_, '_>, defaults: &Defaults<'_>, meshes: &Meshes) -> Self {
        let folders = Folders::new(root);
        let assets = elements(root).filter(|node| node.has_tag_name("asset"));
        let nodes = assets.flat_map(elements).filter(|node| node.has_tag_name("mesh"));
        let found = nodes.filter_map(|node| {
            let element = defaults.known_element(node);
            let file = element.text("file");
            let stem = || Path::new(file?).file_stem().map(|stem| stem.to_string_lossy().into_owned());
            let name = node.attribute("name").map(str::to_owned).or_else(stem)?;
            Some((name, MeshAsset { vertices: folders.vertices(&element, meshes), frame: frame(&element) }))
        });
        Self(found.collect())
    }

    /// Bounds of a mesh in its frame, m. The reason if there are none.
    pub fn bounds(&self, name: &str, meshes: &Meshes) -> Result<Bounds, String> {
        let asset = self.0.get(name).ok_or("the file has no such mesh")?;
        let frame = asset.frame.as_ref().map_err(Clone::clone)?;
        match asset.vertices.as_ref().map_err(Clone::clone)? {
            Vertices::File(path) => meshes.bounds(path, frame),
            Vertices::Stated(numbers) => {
                frame.bounds(numbers.chunks(3).map(|part| <[f64; 3]>::try_from(part).ok().map(Vector3::from)))
            }
        }
    }
}

/// Settings of the compiler for the files of meshes.
struct Folders {
    /// Folder of meshes, relative to the description; may be empty.
    meshes: String,
    /// True if the folders in the names of files are left out.
    strips_folders: bool,
}

impl Folders {
    /// Reads the settings of all `<compiler>` elements; the last value of a setting counts.
    fn new(root: Node<'_, '_>) -> Self {
        let compilers: Vec<Node<'_, '_>> = elements(root).filter(|node| node.has_tag_name("compiler")).collect();
        let last = |name: &str| compilers.iter().filter_map(|node| node.attribute(name)).next_back();
        let folder = last("meshdir").or_else(|| last("assetdir")).unwrap_or_default();
        Self { meshes: folder.to_owned(), strips_folders: last("strippath") == Some("true") }
    }

    /// Vertices that an element of a mesh states, in a file or in the description. The reason if there are none.
    fn vertices(&self, element: &Element<'_, '_, '_>, meshes: &Meshes) -> Result<Vertices, String> {
        if let Some(file) = element.text("file") {
            let path = Path::new(file);
            let name = if self.strips_folders { path.file_name().map_or(path, Path::new) } else { path };
            return Ok(Vertices::File(meshes.place_in_folder(&self.meshes, name)));
        }
        let text = element.text("vertex").ok_or("it has no file and no vertices")?;
        let numbers = finite_numbers(text).ok_or("a coordinate of a vertex is no finite number")?;
        Ok(Vertices::Stated(numbers))
    }
}

/// Frame of a mesh: `scale`, `refpos` and `refquat`. The reason if one of these is wrong.
fn frame(element: &Element<'_, '_, '_>) -> Result<MeshFrame, String> {
    let mut frame = MeshFrame::default();
    let read = |name: &str, count: usize| match element.text(name).map(finite_numbers) {
        None => Ok(None),
        Some(Some(numbers)) if numbers.len() == count => Ok(Some(numbers)),
        Some(_) => Err(format!("its `{name}` is not {count} finite numbers")),
    };
    if let Some([x, y, z]) = read("scale", 3)?.as_deref() {
        frame.scale = Vector3::new(*x, *y, *z);
    }
    if let Some([x, y, z]) = read("refpos", 3)?.as_deref() {
        frame.origin = Vector3::new(*x, *y, *z);
    }
    if let Some([w, x, y, z]) = read("refquat", 4)?.as_deref() {
        if [w, x, y, z].iter().all(|part| **part == 0.0) {
            return Err("its `refquat` is 0".to_owned());
        }
        frame.axes = quaternion_turn(*w, *x, *y, *z);
    }
    Ok(frame)
}

/// Finite numbers of a text, separated by white space. `None` if a word is no finite number.
fn finite_numbers(text: &str) -> Option<Vec<f64>> {
    text.split_whitespace().map(|word| word.parse::<f64>().ok().filter(|number| number.is_finite())).collect()
}
