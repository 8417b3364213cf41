//! Corners of a run: instants at which its equations have a jump or a kink, and the derivatives of
//! these instants.
//!
//! If a varied number moves the instant of a jump, the derivatives of the state jump there. A step
//! ends at this instant, and the integrator adds the jump ([`tripos_sim::Corner`]). A moved kink
//! causes no such jump. Two cases are refused: a jump without a derivative, and steps of equal length
//! that cross a moved instant.

use super::varied_start::VariedStart;
use crate::error::Error;
use crate::preparation::impacts::ContactCrossing;
use crate::preparation::problem::Problem;
use tripos_sim::{Corner, Options, SLOPE_DIRECTIONS};
use tripos_traits::Tangent;

/// Shift of an instant below which it counts as fixed, relative to the instant plus 1 s. The shift is
/// the derivative of the instant by a varied number, times the size of this number.
const MOVED: f64 = 1e-9;
/// Relative difference below which two instants count as equal.
const ONE: f64 = 64.0 * f64::EPSILON;

/// Lists the corners of a run: the instants at which its equations have a jump or a kink. Each corner
/// has its derivatives by the varied numbers.
pub fn corners<const K: usize>(problem: &Problem<'_>, parameters: &[Tangent<K>]) -> Vec<Corner> {
    let of = |(at, jumps): (Tangent<K>, bool)| {
        let mut moves = [0.0; SLOPE_DIRECTIONS];
        moves.iter_mut().zip(at.slopes).for_each(|(to, from)| *to = from);
        Corner { at: at.value, jumps, moves }
    };
    problem.model.corner_instants(parameters).into_iter().map(of).collect()
}

/// Checks that derivatives by the varied number `seed` exist although it may move jumps and kinks of the
/// equations.
///
/// # Errors
/// [`Error::Request`] with the reason if the derivatives do not exist.
pub fn check_moved_corners(problem: &Problem<'_>, seed: &VariedStart, options: &Options) -> Result<(), Error> {
    let values = problem.scene.parameters.iter().zip(&seed.parameters);
    let parameters: Vec<Tangent<1>> = values.clone().map(|(p, by)| Tangent { value: *p, slopes: [*by] }).collect();
    let sizes = values.filter(|(_, by)| **by != 0.0).map(|(p, by)| (p / by).abs());
    let size = sizes.filter(|size| size.is_finite() && *size > 0.0).fold(0.0, f64::max);
    let size = if size > 0.0 { size } else { 1.0 };
    let span = problem.scene.span;
    let (low, high) = (span.0.min(span.1), span.0.max(span.1));
    let is_one = |a: f64, b: f64| (a - b).abs() <= ONE * a.abs().max(b.abs());
    let differ = |a: f64, b: f64, at: f64| (a - b).abs() * size > MOVED * (1.0 + at.abs());
    let mut inside = corners(problem, &parameters);
    inside.retain(|corner| (low..=high).contains(&corner.at) || is_one(corner.at, low) || is_one(corner.at, high));
    let moved: Vec<&Corner> = inside.iter().filter(|corner| differ(corner.moves[0], 0.0, corner.at)).collect();
    let name = &seed.name;
    let refuse = |what: String, help: &str| Err(Error::request(what, help));
    if let (Some(first), Some(_)) = (moved.first(), options.step) {
        let what = format!(
            "`{name}` moves the instant {} s of a jump or kink of the equations, and steps of equal length cross this instant",
            first.at
        );
        return refuse(what, "leave `step` out: adaptive steps end at jumps and kinks");
    }
    let is_end = |corner: &&&Corner| corner.jumps && (is_one(corner.at, low) || is_one(corner.at, high));
    if let Some(end) = moved.iter().find(is_end) {
        let what = format!("`{name}` moves the jump of the equations at {} s into the span or out of it", end.at);
        return refuse(what, "let the span begin or end elsewhere");
    }
    let jumps: Vec<&Corner> = inside.iter().filter(|corner| corner.jumps).collect();
    let apart = jumps.iter().enumerate().find_map(|(at, one)| {
        let others = jumps[at + 1..].iter().filter(|other| is_one(one.at, other.at));
        others.into_iter().find(|other| differ(one.moves[0], other.moves[0], one.at)).map(|_| one.at)
    });
    if let Some(at) = apart {
        let what = format!("two jumps of the equations are at {at} s, and a change of `{name}` separates the jumps");
        return refuse(what, "put the two jumps at different instants: the derivative depends on their order");
    }
    Ok(())
}

/// Checks that contacts do not change at the instant of a jump of the drive. The order of the two events
/// would not be known.
///
/// # Errors
/// Text that says why the derivative does not exist.
pub fn check_no_corner(corners: &[Corner], crossing: &ContactCrossing<'_>) -> Result<(), String> {
    let t = crossing.t;
    let meets = |corner: &Corner| corner.jumps && (corner.at - t).abs() <= 64.0 * f64::EPSILON * t.abs();
    if crossing.contact_change.is_some() && corners.iter().any(meets) {
        return Err("contacts change where the drive jumps".to_owned());
    }
    Ok(())
}
