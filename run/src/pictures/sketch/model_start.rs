//! Parameters and pose of a mechanism that is sketched without a scene.

use super::drawn_pose::ANGLES;
use crate::error::Error;
use crate::mechanism::Mechanism;
use tripos_derive::diagnostic::Source;
use tripos_derive::model::TIME;
use tripos_derive::scene::load;

/// Chooses the parameters and coordinates of a mechanism without a scene. The parameters have the values of
/// the model file, and all coordinates are 0. If the model has loops, they are closed from a guess in
/// which no coordinate is 0.
///
/// # Errors
/// [`Error::Request`] if a parameter has no value, or if the loops cannot be closed from the guess.
pub fn start_without_scene(mechanism: &Mechanism) -> Result<(Vec<f64>, Vec<f64>), Error> {
    let help = "give a scene, or --at with a state file, which gives it one";
    let value = |p: &tripos_derive::model::Parameter| {
        let none = || Error::request(format!("the parameter `{}` has no value", p.name), help);
        p.value.as_ref().map(tripos_derive::algebra::Rational::to_f64).or(p.is_input.then_some(0.0)).ok_or_else(none)
    };
    let parameters = mechanism.parameters.iter().map(value).collect::<Result<Vec<f64>, Error>>()?;
    if mechanism.loops.is_empty() {
        return Ok((parameters, vec![0.0; mechanism.coordinates.len()]));
    }
    let inputs: Vec<String> =
        mechanism.parameters.iter().filter(|p| p.is_input).map(|p| format!("\"{}\" = 0\n", p.name)).collect();
    let inputs = if inputs.is_empty() { String::new() } else { format!("[inputs]\n{}", inputs.concat()) };
    let speeds: Vec<String> = mechanism.speeds.iter().map(|speed| format!("\"{}\" = 0\n", speed.name)).collect();
    let guesses = mechanism.coordinates.iter().filter(|c| c.name != TIME).zip(ANGLES.iter().cycle());
    let guesses: Vec<String> = guesses.map(|(c, angle)| format!("\"{}\" = {}\n", c.name, angle.to_radians())).collect();
    let text = format!("span = [0, 1]\n{inputs}[start]\n{}[guess]\n{}", speeds.concat(), guesses.concat());
    let scene = load(&Source::from_text("start", &text), &mut mechanism.model.clone()).map_err(|_| {
        let help = "give a scene, or --at with a state file, which closes them";
        Error::request("no pose was found that closes the loops of this model", help)
    })?;
    Ok((scene.parameters, scene.q))
}
