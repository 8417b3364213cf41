//! Figure of the motion of a scene on the page, drawn by the viewer of `tripos view`.

use crate::page::{MotionFigure, SceneSection, Standing, Viewer};
use crate::terminal::failure::Failure;
use crate::terminal::interruption;
use crate::view::{LiveEquations, LiveView, STYLE, ViewContent, ViewPlace, figure, script, turns_truly};
use tripos::Mechanism;
use tripos::pictures::view::{View, ViewMotion};
use tripos_derive::scene::Scene;

/// Returns the figure of the motion of the most suitable scene. `None` if no scene was finished, or after an
/// interruption.
pub fn page_motion_figure(model: &Mechanism, scenes: &[Scene], sections: &[SceneSection]) -> Option<MotionFigure> {
    if interruption::is_interrupted() {
        return None;
    }
    let scene = motion_figure_scene(scenes, sections)?;
    let viewer =
        motion_figure_viewer(model, &scenes[scene], &sections[scene].title).map_err(|failure| failure.first_line());
    Some(MotionFigure { scene, viewer })
}

/// Returns the index of the scene to show; `None` without a scene. Scenes whose run is right and reaches its end are
/// preferred, then the longest scene.
fn motion_figure_scene(scenes: &[Scene], sections: &[SceneSection]) -> Option<usize> {
    let rank = |at: usize| {
        let first = sections[at].runs.iter().find(|run| run.printed.is_none());
        let standing = first.map_or(3, |run| match run.standing {
            Standing::Right => 0,
            Standing::Loose { .. } => 1,
            _ => 2,
        });
        (standing, first.is_none_or(|run| !run.arrived))
    };
    let length = |at: usize| (scenes[at].span.1 - scenes[at].span.0).abs();
    (0..sections.len()).min_by(|a, b| rank(*a).cmp(&rank(*b)).then(length(*b).total_cmp(&length(*a))))
}

/// Returns the viewer of a scene's motion as parts of an HTML page: figure, style and script.
/// `Err` if the motion cannot be computed.
fn motion_figure_viewer(model: &Mechanism, scene: &Scene, title: &str) -> Result<Viewer, Failure> {
    let motions = vec![ViewMotion::of_scene(model, scene, None)?];
    let view = View::new(model, scene, &motions.iter().collect::<Vec<_>>())?;
    let seen = ViewContent { mechanism: model, scene, view, motions, title: title.to_owned() };
    let live = LiveEquations::of(&seen, None, ViewPlace::Page)?;
    let shown = LiveView { seen: &seen, live: &live };
    let is_fast = !turns_truly(&seen, ViewPlace::Page);
    let doubt = "a body turns so fast that the pictures show a wrong turning.";
    Ok(Viewer {
        figure: figure(shown, ViewPlace::Page),
        style: STYLE,
        script: script(&[shown]),
        doubt: is_fast.then(|| doubt.to_owned()),
    })
}
