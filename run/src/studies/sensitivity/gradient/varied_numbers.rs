//! Numbers of a scene by which a gradient is taken: all parameters, and the numbers that the scene
//! states for its start.

use crate::error::Error;
use crate::preparation::problem::Problem;
use crate::studies::sensitivity::corners;
use crate::studies::sensitivity::varied_start::VariedStart;
use tripos_derive::Model;
use tripos_derive::model::TIME;
use tripos_derive::scene::{InitialMotion, Scene};
use tripos_sim::Options;
use tripos_sim::adjoint::MovingJump;
use tripos_traits::Tangent;

/// Number of a scene by which a gradient is taken.
pub struct VariedNumber {
    /// Name of the number.
    pub name: String,
    /// Derivatives of the parameters and the start by the number, or the reason why they do not exist.
    pub seed: Result<VariedStart, String>,
}

/// Lists all numbers of a problem's scene by which a gradient is taken. `set` has the names and values
/// of the numbers that differ from the scene file.
pub fn varied_numbers(problem: &Problem<'_>, set: &[(String, f64)], options: &Options) -> Vec<VariedNumber> {
    let number = |name: String| {
        let seed = VariedStart::new(problem, set, &name);
        let seed = seed.and_then(|seed| {
            corners::check_moved_corners(problem, &seed, options)
                .and_then(|()| seed.check_friction_from_zero(problem.scene))
                .map(|()| seed)
        });
        VariedNumber { name, seed: seed.map_err(|error| Error::first_line(&error)) }
    };
    varied_number_names(problem.model, problem.scene).into_iter().map(number).collect()
}

/// Names of the parameters in the order of the model, followed by the coordinates and the rates or
/// speeds that the scene states for its start. Numbers that are computed from other numbers, as in
/// closed loops, are left out.
pub fn varied_number_names(model: &Model, scene: &Scene) -> Vec<String> {
    let coordinates = || model.coordinates.iter().map(|c| c.name.clone()).filter(|name| name != TIME);
    let motion: Vec<String> = match &scene.exact.motion {
        InitialMotion::Rates(_) => coordinates().map(|name| format!("{name}'")).collect(),
        InitialMotion::Speeds(_) => model.speeds.iter().map(|s| s.name.clone()).collect(),
    };
    let follows = |name: &String| {
        scene.closed.iter().any(|closed| closed.name == *name) || model.constraints.iter().any(|c| c.fixes == *name)
    };
    let start = coordinates().chain(motion).filter(|name| !follows(name));
    model.parameters.iter().map(|p| p.name.clone()).chain(start).collect()
}

/// Lists the instants at which the equations of a problem jump, each with its derivatives by all
/// parameters, s per unit.
pub fn moved_jumps(problem: &Problem<'_>) -> Vec<MovingJump> {
    let parameters = &problem.scene.parameters;
    let mut list: Vec<MovingJump> = Vec::new();
    for first in (0..parameters.len()).step_by(4) {
        let slopes = |at: usize| std::array::from_fn(|k| f64::from(u8::from(first + k == at)));
        let along: Vec<Tangent<4>> =
            parameters.iter().enumerate().map(|(at, p)| Tangent { value: *p, slopes: slopes(at) }).collect();
        let jumps = corners::corners(problem, &along).into_iter().filter(|corner| corner.jumps);
        for (place, jump) in jumps.enumerate() {
            if list.len() <= place {
                list.push(MovingJump { at: jump.at, by: Vec::with_capacity(parameters.len()) });
            }
            list[place].by.extend(jump.moves.iter().take(parameters.len() - first));
        }
    }
    list
}
