//! Bounds of meshes in files: STL in text and binary form, and OBJ.
//!
//! A model shows a mesh as the box at its bounds. Only the vertices are read, from files of at most 256 MiB.

use nalgebra::{Matrix3, Vector3};
use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Largest size of a file that is read, in bytes.
const LARGEST_FILE: u64 = 256 << 20;
/// Largest size of all files of one robot that are read, in bytes.
const LARGEST_SUM: u64 = 1 << 30;
/// Part of the longest edge of a box that a flat mesh is thick.
const FLAT: f64 = 1e-3;

/// Smallest box along the axes that contains a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    /// Smallest coordinates, m.
    lower: Vector3<f64>,
    /// Largest coordinates, m.
    upper: Vector3<f64>,
}

impl Bounds {
    /// Bounds of points; the reason why there are none: a coordinate is not finite, or there is no point.
    fn of(points: impl Iterator<Item = Option<Vector3<f64>>>) -> Result<Self, String> {
        let mut found: Option<Self> = None;
        for point in points {
            let point = point.ok_or("a vertex has no three numbers")?;
            if point.iter().any(|coordinate| !coordinate.is_finite()) {
                return Err("a coordinate of a vertex is not finite".to_owned());
            }
            found = Some(match found {
                None => Self { lower: point, upper: point },
                Some(known) => Self { lower: known.lower.inf(&point), upper: known.upper.sup(&point) },
            });
        }
        found.ok_or_else(|| "it has no vertex".to_owned())
    }

    /// Middle of the box, m.
    pub fn middle(&self) -> Vector3<f64> {
        self.lower / 2.0 + self.upper / 2.0
    }

    /// Edges of the box, m. A flat mesh has the thickness of a thousandth of its longest edge. The reason why there is
    /// no box: the mesh is a point, or too large for a double.
    pub fn edges(&self) -> Result<Vector3<f64>, String> {
        let edges = self.upper - self.lower;
        let longest = edges.amax();
        if !longest.is_finite() {
            return Err("its size is not finite".to_owned());
        }
        let thinnest = longest * FLAT;
        if thinnest == 0.0 { Err("it is a point".to_owned()) } else { Ok(edges.map(|edge| edge.max(thinnest))) }
    }
}

/// Map from the coordinates of a file to those of the mesh: p is taken to S Rᵀ (p − p₀).
#[derive(Clone, Debug)]
pub struct MeshFrame {
    /// Origin p₀ of the mesh in the coordinates of the file.
    pub origin: Vector3<f64>,
    /// Axes R of the mesh in those of the file, as a rotation matrix.
    pub axes: Matrix3<f64>,
    /// Scale factors S along the axes of the mesh, m.
    pub scale: Vector3<f64>,
}

impl Default for MeshFrame {
    fn default() -> Self {
        Self { origin: Vector3::zeros(), axes: Matrix3::identity(), scale: Vector3::repeat(1.0) }
    }
}

impl MeshFrame {
    /// Bounds, in the coordinates of the mesh, of points in those of the file. The reason if there are none.
    pub fn bounds(&self, points: impl Iterator<Item = Option<Vector3<f64>>>) -> Result<Bounds, String> {
        let back = self.axes.transpose();
        Bounds::of(points.map(|point| Some((back * (point? - self.origin)).component_mul(&self.scale))))
    }
}

/// Bounds of the meshes of one robot.
#[derive(Default)]
pub struct Meshes {
    /// Folder of the robot description.
    folder: PathBuf,
    /// Bounds by file and frame, or the reasons why there are none.
    known: RefCell<BTreeMap<(PathBuf, String), Result<Bounds, String>>>,
    /// Number of bytes read so far.
    read: Cell<u64>,
}

impl Meshes {
    /// Creates a set of meshes of the robot description in a file.
    pub fn new(description: &Path) -> Self {
        let folder = description.parent().filter(|folder| !folder.as_os_str().is_empty());
        Self { folder: folder.unwrap_or(Path::new(".")).to_owned(), ..Self::default() }
    }

    /// Place of a mesh that a URDF file names. `package://NAME/…` and `model://NAME/…` are in the folder NAME that
    /// contains the description or is beside one of the folders around it; other names are relative to the description.
    pub fn place_in_packages(&self, name: &str) -> PathBuf {
        if let Some(path) = name.strip_prefix("file://") {
            return PathBuf::from(path);
        }
        let Some(path) = name.strip_prefix("package://").or_else(|| name.strip_prefix("model://")) else {
            return self.folder.join(name);
        };
        let folder = std::fs::canonicalize(&self.folder).unwrap_or_else(|_| self.folder.clone());
        let place = folder.ancestors().map(|around| around.join(path)).find(|place| place.is_file());
        place.unwrap_or_else(|| folder.join(path))
    }

    /// Place of a mesh that an MJCF file names, in the folder for meshes that the compiler sets.
    pub fn place_in_folder(&self, folder: &str, name: &Path) -> PathBuf {
        self.folder.join(folder).join(name)
    }

    /// Bounds of the mesh in a file, in a frame. The reason if there are none: the file is absent, too large, of
    /// another kind, or not complete.
    pub fn bounds(&self, file: &Path, frame: &MeshFrame) -> Result<Bounds, String> {
        let key = (file.to_owned(), format!("{frame:?}"));
        if let Some(known) = self.known.borrow().get(&key) {
            return known.clone();
        }
        let found = self.read(file).and_then(|(bytes, kind)| kind.bounds(&bytes, frame));
        self.known.borrow_mut().insert(key, found.clone());
        found
    }

    /// Content and kind of a file. The reason if it cannot be read.
    fn read(&self, file: &Path) -> Result<(Vec<u8>, MeshKind), String> {
        let extension = file.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        let kind = match extension.as_deref() {
            Some("stl") => MeshKind::Stl,
            Some("obj") => MeshKind::Obj,
            _ => return Err("only STL and OBJ files are read".to_owned()),
        };
        let metadata = std::fs::metadata(file).map_err(|error| match error.kind() {
            std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
            _ => format!("it cannot be read: {error}"),
        })?;
        if !metadata.is_file() {
            return Err("it is no file".to_owned());
        }
        let left = LARGEST_SUM.saturating_sub(self.read.get());
        if metadata.len() > LARGEST_FILE.min(left) {
            return Err("files of more than 256 MiB, or of 1 GiB together, are not read".to_owned());
        }
        let mut bytes = Vec::new();
        let length = std::fs::File::open(file)
            .and_then(|file| file.take(LARGEST_FILE).read_to_end(&mut bytes))
            .map_err(|error| format!("it cannot be read: {error}"))?;
        self.read.set(self.read.get().saturating_add(length as u64));
        Ok((bytes, kind))
    }
}

/// Kind of a file with a mesh.
#[derive(Clone, Copy)]
enum MeshKind {
    /// Triangles, in text or binary form.
    Stl,
    /// Vertices and faces in text.
    Obj,
}

/// Number of bytes before the triangles of a binary STL file: a comment of 80 bytes, and the number of triangles.
const HEADER: usize = 84;
/// Number of bytes of a triangle in a binary STL file: a normal and three vertices of four bytes a number, and two
/// more.
const TRIANGLE: usize = 50;

impl MeshKind {
    /// Bounds of the mesh that bytes state, in a frame. The reason if there are none.
    fn bounds(self, bytes: &[u8], frame: &MeshFrame) -> Result<Bounds, String> {
        match self {
            Self::Obj => frame.bounds(text_points(bytes, "v")),
            Self::Stl => match binary_triangles(bytes) {
                Some(triangles) => frame.bounds(triangles.flat_map(triangle_points).map(Some)),
                // The comment of a binary file may begin with `solid`, too: only its length tells the forms apart.
                None if bytes.trim_ascii_start().starts_with(b"solid")
                    && bytes.windows(5).any(|word| word == b"facet") =>
                {
                    let bounds = frame.bounds(text_points(bytes, "vertex"))?;
                    if is_whole_text(bytes) {
                        Ok(bounds)
                    } else {
                        Err("the file is cut off: its last line is not `endsolid`".to_owned())
                    }
                }
                None => Err("the file is neither STL in text form nor as long as its number of triangles".to_owned()),
            },
        }
    }
}

/// True if a text STL file is complete: its last line that is not empty begins with `endsolid`.
fn is_whole_text(bytes: &[u8]) -> bool {
    let last = lines(bytes).filter(|line| !line.is_empty()).last();
    let word = last.and_then(|line| line.split(u8::is_ascii_whitespace).next());
    word.is_some_and(|word| word.eq_ignore_ascii_case(b"endsolid"))
}

/// Lines of a text, without the spaces before them.
fn lines(bytes: &[u8]) -> impl Iterator<Item = &[u8]> {
    bytes.split(|byte| matches!(byte, b'\n' | b'\r')).map(<[u8]>::trim_ascii_start)
}

/// Triangles of a binary STL file; `None` if the file is not as long as the stated number of triangles.
fn binary_triangles(bytes: &[u8]) -> Option<std::slice::ChunksExact<'_, u8>> {
    let count = bytes.get(80..HEADER)?.try_into().ok().map(u32::from_le_bytes)?;
    let triangles = &bytes[HEADER..];
    let length = usize::try_from(count).ok()?.checked_mul(TRIANGLE)?;
    (triangles.len() == length).then(|| triangles.chunks_exact(TRIANGLE))
}

/// Vertices of a triangle of a binary STL file.
fn triangle_points(triangle: &[u8]) -> [Vector3<f64>; 3] {
    let number = |at: usize| {
        let bytes = triangle.get(4 * at..4 * at + 4).and_then(|bytes| bytes.try_into().ok());
        f64::from(bytes.map_or(f32::NAN, f32::from_le_bytes))
    };
    [3, 6, 9].map(|first| Vector3::new(number(first), number(first + 1), number(first + 2)))
}

/// Points of the lines of a text that begin with a word; `None` for a line without three numbers.
fn text_points<'b>(bytes: &'b [u8], word: &'static str) -> impl Iterator<Item = Option<Vector3<f64>>> + 'b {
    lines(bytes).filter_map(move |line| {
        let numbers =
            line.strip_prefix(word.as_bytes()).filter(|rest| rest.first().is_some_and(u8::is_ascii_whitespace))?;
        let text = String::from_utf8_lossy(numbers.get(..400).unwrap_or(numbers));
        let mut numbers = text.split_ascii_whitespace().map(|word| word.parse::<f64>().ok());
        let mut next = || numbers.next().flatten();
        let (x, y, z) = (next(), next(), next());
        Some(x.zip(y).zip(z).map(|((x, y), z)| Vector3::new(x, y, z)))
    })
}
