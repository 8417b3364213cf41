//! Command `tripos view`: writes a scene's motion as an animated view in one HTML file.

use crate::arguments::View as Request;
use crate::files::output_files::{refuse_overwriting_inputs, write_text_file};
use crate::files::scene_file::{SceneWithSetValues, read_scene_with, scene_title};
use crate::terminal::failure::{Failure, Output, print_result, status, warn};
use crate::terminal::interruption;
use crate::view::{LiveEquations, ViewContent, ViewPlace, document, turns_truly};
use serde_json::json;
use tripos::Mechanism;
use tripos::pictures::view::{View, ViewMotion};
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::scene::Scene;

/// Runs `tripos view`: runs the scene and the motions to compare with, and writes the HTML file.
/// Returns the exit status.
///
/// # Errors
/// `Failure` if a scene has errors or cannot be run, the file cannot be written, or the user
/// interrupts.
pub fn view(request: &Request) -> Result<u8, Failure> {
    let SceneWithSetValues { model: mechanism, mut scene, .. } = read_scene_with(&request.scene, &request.set.set)?;
    let how = request.how.overrides()?;
    how.apply_to_scene(&mut scene)?;
    refuse_overwriting_inputs(&mechanism, Some(&scene), [request.out.as_path()])?;
    interruption::listen_for_interruption();
    let mut motions = vec![ViewMotion::of_scene(&mechanism, &scene, how.by.as_ref())?];
    for against in &request.against {
        motions.push(ghost_motion(&mechanism, &scene, request, against)?);
    }
    if interruption::is_interrupted() {
        return Err(Failure::Interrupted(String::new()));
    }
    let view = View::new(&mechanism, &scene, &motions.iter().collect::<Vec<_>>())?;
    for objection in motions.iter().flat_map(|motion| &motion.objections) {
        warn(objection);
    }
    let stopped = motions.iter().any(|motion| motion.failed);
    let title = scene_title(&scene);
    let seen = ViewContent { mechanism: &mechanism, scene: &scene, view, motions, title };
    if !turns_truly(&seen, ViewPlace::Alone) {
        warn(
            "a body turns faster than the pictures of it follow: what is seen of its turning is not true; a shorter `--until` \
             leaves more pictures of it",
        );
    }
    let live = LiveEquations::of(&seen, how.by.as_ref(), ViewPlace::Alone)?;
    write_text_file(&request.out, &document(&seen, &live))?;
    let objections: Vec<&String> = seen.motions.iter().flat_map(|motion| &motion.objections).collect();
    let value = json!({ "files": [path_as_plain_text(&request.out)], "stopped": stopped, "warnings": objections });
    print_result(Output::of_flag(request.json), &format!("{}\n", request.out.display()), &value)?;
    Ok(if stopped { status::STOPPED } else { 0 })
}

/// Returns a motion for comparison, which is shown as a transparent ghost. `against` names other equations for the
/// scene, or another scene of the same model.
///
/// # Errors
/// `Failure` if the scene belongs to another model, or if it cannot be read or run.
fn ghost_motion(mechanism: &Mechanism, scene: &Scene, request: &Request, against: &str) -> Result<ViewMotion, Failure> {
    let path = std::path::Path::new(against);
    if !path.is_file() {
        return Ok(ViewMotion::of_scene(mechanism, scene, Some(&against.into()))?);
    }
    let SceneWithSetValues { model: other, scene: mut own, .. } = read_scene_with(path, &request.set.set)?;
    if other.source.text != mechanism.source.text {
        let what = format!(
            "the scene `{}` belongs to another model than the scene `{}`",
            path_as_plain_text(path),
            path_as_plain_text(&request.scene)
        );
        return Err(Failure::request(what, "give a scene of the same model, or equations such as lagrange".to_owned()));
    }
    let how = request.how.overrides()?;
    how.apply_to_scene(&mut own)?;
    let mut motion = ViewMotion::of_scene(&other, &own, how.by.as_ref())?;
    motion.title = if own.title.is_empty() { path_as_plain_text(path) } else { own.title };
    Ok(motion)
}
