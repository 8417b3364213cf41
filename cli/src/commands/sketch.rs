//! Command `tripos sketch`: draws a mechanism as textbooks do, as a picture or in LaTeX.

use crate::files::output_files::{refuse_overwriting_inputs, write_text_file};
use crate::files::scene_file::read_scene;
use crate::files::workspace::{model_file, read_model};
use crate::picture;
use crate::sketch::{sketch_svg_file, tikz_picture as tikz};
use crate::terminal::failure::{Failure, Output, print_result};
use serde_json::json;
use std::path::Path;
use tripos::Mechanism;
use tripos::pictures::sketch::Sketch;
use tripos_codegen::model_folders::scenes_in_model_folder;
use tripos_derive::diagnostic::Source;
use tripos_derive::model::is_model;
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::scene::{Scene, load_scene_with_inputs, load_state};

/// File format of a sketch, chosen by the extension of its file name.
#[derive(Clone, Copy)]
enum SketchFormat {
    /// Picture in a format such as SVG, PNG or PDF.
    Figure(picture::PictureFormat),
    /// LaTeX text that draws the picture with the package TikZ.
    Latex,
}

/// Runs `tripos sketch`: sketches a model, or the start of a scene, and writes the picture. `at` is a state file with
/// another pose. Returns the exit status.
///
/// # Errors
/// [`Failure`] if a file cannot be read or written, if the extension of `out` is that of no format, or if no body has a
/// place.
pub fn sketch(what: &Path, at: Option<&Path>, out: &Path, output: Output) -> Result<u8, Failure> {
    let kind = sketch_format(out)?;
    let (mut mechanism, scene) = read_sketched_scene(what)?;
    refuse_overwriting_inputs(&mechanism, scene.as_ref(), [out])?;
    let sketch = match (at, &scene) {
        (Some(at), _) => {
            let state = load_state(&Source::read(at)?, &mut mechanism)?;
            if tripos_codegen::draft_file::draft_would_change(out, at) {
                let what = format!(
                    "the output `{}` would overwrite the input `{}`",
                    path_as_plain_text(out),
                    path_as_plain_text(at)
                );
                return Err(Failure::request(what, "give another file".to_owned()));
            }
            Sketch::at_state(&mechanism, &state)?
        }
        (None, Some(scene)) => Sketch::of_scene(&mechanism, scene)?,
        (None, None) => Sketch::of_model(&mechanism)?,
    };
    match kind {
        SketchFormat::Figure(kind) => picture::write_picture(out, kind, &sketch_svg_file(&sketch), picture::DPI)?,
        SketchFormat::Latex => write_text_file(out, &tikz(&sketch))?,
    }
    let lines = format!("{}\n{}\n{}\n", path_as_plain_text(out), sketch.about, sketch.drawn);
    let value = json!({ "files": [path_as_plain_text(out)], "about": sketch.about, "drawn": sketch.drawn });
    print_result(output, &lines, &value)?;
    Ok(0)
}

/// Returns the file format of a sketch, by the extension of its file name.
///
/// # Errors
/// [`Failure`] for an unknown extension.
fn sketch_format(out: &Path) -> Result<SketchFormat, Failure> {
    if out.extension().is_some_and(|end| end == "tex") {
        return Ok(SketchFormat::Latex);
    }
    picture::picture_format(out, ", or in .tex for LaTeX").map(SketchFormat::Figure)
}

/// Reads the model, and the scene whose start is drawn: the given scene, or else the first scene of the model. The
/// scene is `None` if the model has no scene. `Err` if a file has errors.
fn read_sketched_scene(what: &Path) -> Result<(Mechanism, Option<Scene>), Failure> {
    let is_scene = !what.is_dir() && what.exists() && !is_model(&Source::read(what)?);
    if is_scene {
        let (mechanism, scene) = read_scene(what)?;
        return Ok((mechanism, Some(scene)));
    }
    let mut mechanism = read_model(what)?;
    let Some(first) = scenes_in_model_folder(&model_file(what)).into_iter().next() else {
        return Ok((mechanism, None));
    };
    let scene = load_scene_with_inputs(&Source::read(&first)?, &mut mechanism)?;
    Ok((mechanism, Some(scene)))
}
