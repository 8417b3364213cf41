//! Motions by wrong printed equations of a publication, compared with the motion by the derived equations.
//!
//! The start and the span are those of the first scene of the publication's model. Both motions are runs of this scene,
//! one by Kane's equations and one by the equations exactly as printed.

use crate::files::judged_publication::JudgedPublication;
use crate::terminal::failure::Failure;
use serde_json::{Value, json};
use std::path::Path;
use tripos::{EquationsName, Overrides, Scene};
use tripos_codegen::model_folders::{scene_path_in_model_folder, scenes_in_model_folder};
use tripos_derive::Formulation;
use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::plain_text::with_significant_digits;

/// Number of significant digits of the shown values.
const DIGITS: usize = 3;

/// Motion by wrong printed equations, compared with the right motion.
pub struct ShelvedMotion {
    /// Id of the publication's printed system of equations.
    pub system: String,
    /// Path of the scene file that defines the start, relative to the model.
    pub scene: String,
    /// Time at the end of the run by the derived equations, s.
    pub time: f64,
    /// Difference of the two motions at the end, or the reason why the printed run stops.
    pub outcome: Outcome,
}

/// Outcome of a run by printed equations.
pub enum Outcome {
    /// The run reaches the end. The coordinate is the one farthest from the right motion, with its printed and its
    /// right value.
    Apart { coordinate: String, printed: f64, right: f64 },
    /// The run does not reach the end. The text is the reason.
    Stopped(String),
}

impl ShelvedMotion {
    /// Returns a sentence about the motion, without its full stop.
    pub fn words(&self) -> String {
        let Self { system, scene, time, outcome } = self;
        match outcome {
            Outcome::Apart { coordinate, printed, right } => {
                let [printed, right] = [printed, right].map(|x| with_significant_digits(*x, DIGITS));
                format!("{system}: after {time} s of {scene}, {coordinate} is {printed} instead of {right}")
            }
            Outcome::Stopped(why) => format!("{system}: its run of {scene} does not reach {time} s: {why}"),
        }
    }

    /// Returns the comparison of the two motions as JSON.
    pub fn json(&self) -> Value {
        let mut value = json!({ "system": self.system, "scene": self.scene, "time": self.time });
        match &self.outcome {
            Outcome::Apart { coordinate, printed, right } => {
                value["coordinate"] = json!(coordinate);
                value["printed"] = json!(printed);
                value["right"] = json!(right);
            }
            Outcome::Stopped(why) => value["stopped"] = json!(why),
        }
        value
    }
}

/// Runs all printed systems of a publication whose accelerations are wrong. The list is empty if
/// the model has no scene.
///
/// # Errors
/// [`Failure`] if the scene cannot be read, or if the derived equations cannot run it to its end.
pub fn motions(folder: &Path, judged: &JudgedPublication) -> Result<Vec<ShelvedMotion>, Failure> {
    let model = folder.join("model.toml");
    let wrong = judged.difference.consequences.iter().filter(|c| matches!(c.accelerations, Verdict::Different(_)));
    let systems: Vec<&str> = wrong.map(|c| c.system.as_str()).collect();
    let Some(file) = scenes_in_model_folder(&model).into_iter().next().filter(|_| !systems.is_empty()) else {
        return Ok(Vec::new());
    };
    let scene = Scene::read(&file)?;
    let by = |by: EquationsName| Overrides { by: Some(by), ..Overrides::default() };
    let right = scene.simulate(&by(EquationsName::Derived(Formulation::Kane)))?;
    if let Some(why) = right.failure() {
        return Err(Failure::request(
            format!("{}: {why}", scene_path_in_model_folder(&model, &file)),
            "choose another start or span",
        ));
    }
    let count = scene.mechanism().coordinates.len();
    let mut list = Vec::new();
    for system in systems {
        let run = scene.simulate(&by(EquationsName::Printed(system.to_owned())))?;
        let outcome = match run.failure() {
            Some(why) => Outcome::Stopped(why),
            None => shelved_motion_outcome(&right.names[..count], &right.states, &run.end, &right.end),
        };
        let (scene, time) = (scene_path_in_model_folder(&model, &file), right.solution.t_end);
        list.push(ShelvedMotion { system: system.to_owned(), scene, time, outcome });
    }
    Ok(list)
}

/// Returns the coordinate whose final value by printed equations is farthest from the right value. The distance is
/// relative to the coordinate's largest absolute value in the right motion.
fn shelved_motion_outcome(names: &[String], states: &[Vec<f64>], printed: &[f64], right: &[f64]) -> Outcome {
    let range = |at: usize| states.iter().map(|state| state[at].abs()).fold(f64::MIN_POSITIVE, f64::max);
    let off = |at: usize| (printed[at] - right[at]).abs() / range(at);
    let at = (0..names.len()).max_by(|a, b| off(*a).total_cmp(&off(*b))).unwrap_or(0);
    Outcome::Apart { coordinate: names[at].clone(), printed: printed[at], right: right[at] }
}

#[cfg(test)]
mod tests {
    use super::{Outcome, shelved_motion_outcome};

    #[test]
    fn the_farthest_coordinate_is_farthest_in_relation_to_its_range() {
        let names = ["x".to_owned(), "theta".to_owned()];
        let states = [vec![100.0, 0.1], vec![90.0, 0.2]];
        let found = shelved_motion_outcome(&names, &states, &[95.0, 0.4], &[90.0, 0.2]);
        assert!(matches!(found, Outcome::Apart { coordinate, printed, right }
            if coordinate == "theta" && (printed, right) == (0.4, 0.2)));
    }
}
