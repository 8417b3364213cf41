//! `tripos sketch`: a mechanism as textbooks draw it, as SVG or LaTeX.

use super::simulate::read_scene;
use crate::failure::{Failure, print};
use crate::output::{keep_inputs, text};
use crate::sketch::{document, picture};
use crate::workspace::{model_file, read_model};
use std::path::Path;
use tripos::Mechanism;
use tripos::pictures::sketch::Sketch;
use tripos_codegen::scene_files::scene_files;
use tripos_derive::diagnostic::Source;
use tripos_derive::model::is_model;
use tripos_derive::plain::path_in_line;
use tripos_derive::scene::{Scene, load_bound, load_state};

/// Kind of picture file, by the ending of its name.
#[derive(Clone, Copy)]
enum Kind {
    Svg,
    Latex,
}

/// Sketches a model, or the start of a scene, and writes the picture. Returns the exit status.
///
/// # Errors
/// [`Failure`] if a file cannot be read or written, `out` names no kind of picture, or no body has a place.
pub fn sketch(what: &Path, at: Option<&Path>, out: &Path) -> Result<u8, Failure> {
    let kind = kind(out)?;
    let (mut mechanism, scene) = read(what)?;
    keep_inputs(&mechanism, scene.as_ref(), [out])?;
    let sketch = match (at, &scene) {
        (Some(at), _) => {
            let state = load_state(&Source::read(at)?, &mut mechanism)?;
            if tripos_codegen::files::would_change(out, at) {
                let what =
                    format!("`{}` would be written over `{}`, which is read", path_in_line(out), path_in_line(at));
                return Err(Failure::request(what, "give another file".to_owned()));
            }
            Sketch::at_state(&mechanism, &state)?
        }
        (None, Some(scene)) => Sketch::of_scene(&mechanism, scene)?,
        (None, None) => Sketch::of_model(&mechanism)?,
    };
    let picture = match kind {
        Kind::Svg => document(&sketch),
        Kind::Latex => picture(&sketch),
    };
    text(out, &picture)?;
    print(&format!("{}\n{}\n{}\n", path_in_line(out), sketch.about, sketch.drawn))?;
    Ok(0)
}

fn kind(out: &Path) -> Result<Kind, Failure> {
    match out.extension().and_then(|end| end.to_str()) {
        Some("svg") => Ok(Kind::Svg),
        Some("tex") => Ok(Kind::Latex),
        _ => Err(Failure::request(
            format!("`{}` names no kind of sketch", path_in_line(out)),
            "give a file that ends in .svg, or in .tex for LaTeX".to_owned(),
        )),
    }
}

/// Reads the model, and the scene whose start is drawn: the given one, or else the first of the model, if it has one.
fn read(what: &Path) -> Result<(Mechanism, Option<Scene>), Failure> {
    let is_scene = !what.is_dir() && what.exists() && !is_model(&Source::read(what)?);
    if is_scene {
        let (mechanism, scene) = read_scene(what)?;
        return Ok((mechanism, Some(scene)));
    }
    let mut mechanism = read_model(what)?;
    let Some(first) = scene_files(&model_file(what)).into_iter().next() else { return Ok((mechanism, None)) };
    let scene = load_bound(&Source::read(&first)?, &mut mechanism)?;
    Ok((mechanism, Some(scene)))
}
