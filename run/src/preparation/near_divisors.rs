//! Names the divisors of the equations of motion that are nearly zero at a configuration.

use crate::code::compile_tape;
use crate::error::Error;
use rustc_hash::FxHashMap;
use tripos_derive::Model;
use tripos_derive::algebra::term::fold::{Fold, Values, fold};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Numeric;
use tripos_derive::algebra::{Arena, Expr, Function, Node, Rational};
use tripos_derive::mechanics::load_divisors;
use tripos_derive::model::{Coordinate, Unit};
use tripos_derive::plain_text::with_significant_digits;

/// Fraction of the size of a divisor's terms below which the divisor counts as nearly zero.
const NEAR: f64 = 1e-6;

/// Names the divisors of the equations of motion that are nearly zero at a configuration `q`. The text
/// is the end of a sentence, such as ", where sin(theta) = 1.2e-16". A divisor of a load is followed
/// by its meaning. The text is empty if no divisor is nearly zero.
///
/// # Errors
/// [`Error::Request`] if a divisor contains a symbol that has no value during a run.
pub fn near_divisors(model: &Model, parameters: &[f64], q: &[f64]) -> Result<String, Error> {
    let inputs = [model.p(), model.q()].concat();
    // A reduced system may divide by symbols that the reduction itself defines. Such a divisor is left
    // out, because a reader could not find the configurations at which it is zero.
    let is_place = |arena: &Arena, e: Expr| {
        let symbols = arena.reachable(&[e]).into_iter();
        symbols.filter(|e| matches!(arena.node(*e), Node::Symbol(_))).all(|e| inputs.contains(&e))
    };
    let mut arena = model.arena.clone();
    let loads = load_divisors(&mut arena, model);
    let speeds = model.kinematic_equations.divisors.iter().copied().map(|e| (e, None));
    let loads = loads.iter().map(|divisor| (divisor.value, Some(divisor.zero_divisor_meaning())));
    let divisors: Vec<(Expr, Option<String>)> = speeds.chain(loads).filter(|(e, _)| is_place(&arena, *e)).collect();
    let terms: Vec<Expr> = divisors.iter().map(|(e, _)| *e).collect();
    let values = compile_tape(&arena, &inputs, &terms, "a divisor of the equations")?;
    let values = values.evaluate(&[parameters, q].concat());
    let symbols: FxHashMap<Expr, f64> = inputs.iter().copied().zip(typical_sizes(model, parameters, q)).collect();
    let size = |e: Expr| fold(&arena, e, &mut TermSizes(&symbols)).filter(|size| size.is_finite());
    let is_near = |e: Expr, value: f64| size(e).is_some_and(|size| value.abs() <= NEAR * size);
    let near = divisors.iter().zip(&values).filter(|((e, _), value)| is_near(*e, **value));
    let list: Vec<String> = near
        .map(|((e, meaning), value)| {
            let meaning = meaning.as_ref().map_or_else(String::new, |meaning| format!(" ({meaning})"));
            format!("{} = {}{meaning}", print_text(&arena, *e), with_significant_digits(*value, 2))
        })
        .collect();
    Ok(if list.is_empty() { String::new() } else { format!(", where {}", list.join(" and ")) })
}

/// Typical sizes of the parameters, followed by the typical sizes of the coordinates, each in its own
/// unit. The size of a coordinate is at least the largest parameter of the same unit, or 1 if no
/// parameter has this unit. The size of an angle is at least 1 rad.
fn typical_sizes(model: &Model, parameters: &[f64], q: &[f64]) -> Vec<f64> {
    let alike = |coordinate: &Coordinate| {
        let of = model.parameters.iter().zip(parameters).filter(|(p, _)| p.unit == coordinate.unit);
        of.map(|(_, value)| value.abs()).reduce(f64::max).filter(|_| coordinate.unit != Unit::default()).unwrap_or(1.0)
    };
    let coordinates = model.coordinates.iter().zip(q).map(|(coordinate, value)| value.abs().max(alike(coordinate)));
    parameters.iter().map(|value| value.abs()).chain(coordinates).collect()
}

/// Computes the typical size of an expression from the sizes of its symbols. All summands count as
/// positive, so nothing cancels. Sines and cosines count as 1.
struct TermSizes<'a>(&'a FxHashMap<Expr, f64>);

impl Fold for TermSizes<'_> {
    type Value = f64;
    fn number(&mut self, value: &Rational) -> Option<f64> {
        Some(value.to_f64().abs())
    }
    fn pi(&mut self) -> Option<f64> {
        Some(std::f64::consts::PI)
    }
    fn symbol(&mut self, symbol: Expr) -> Option<f64> {
        self.0.get(&symbol).copied()
    }
    fn sum(&mut self, constant: &Rational, terms: &[(Expr, Rational)], of: &Values<'_, f64>) -> Option<f64> {
        Some(terms.iter().fold(constant.to_f64().abs(), |sum, (term, k)| sum + k.to_f64().abs() * of[*term]))
    }
    fn product(&mut self, factors: &[(Expr, i32)], of: &Values<'_, f64>) -> Option<f64> {
        Some(factors.iter().map(|(base, n)| of[*base].powi(*n)).product())
    }
    fn apply(&mut self, f: Function, argument: Expr, of: &Values<'_, f64>) -> Option<f64> {
        Some(if matches!(f, Function::Sin | Function::Cos) { 1.0 } else { of[argument].apply(f).abs() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tripos_derive::diagnostic::Source;

    /// Model of a bead on the end of a massless arm, in polar coordinates with speeds along and across the arm. Only
    /// the divisors matter.
    const BEAD: &str = r#"
name = "bead"
[parameters]
m = { unit = "kg", value = 1 }
l = { unit = "m", value = 1 }
[coordinates]
r = { unit = "m" }
theta = { unit = "rad" }
[speeds]
along = "r'"
across = "l*sin(theta)*r*theta'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "theta" }
[points]
P = { from = "O", frame = "A", position = ["r", 0, 0] }
[particles]
b = { point = "P", mass = "m" }
"#;

    fn near(l: f64, r: f64, theta: f64) -> String {
        let model = tripos_derive::model::load(&Source::from_text("bead.toml", BEAD)).unwrap();
        near_divisors(&model, &[1.0, l], &[r, theta]).unwrap()
    }

    #[test]
    fn nearness_does_not_depend_on_the_unit_of_lengths() {
        for scale in [1.0, 1e-9, 1e9] {
            assert_eq!(near(scale, 0.7 * scale, 1.2), "", "nothing is near at {scale}");
            assert!(near(scale, 1e-8 * scale, 1.2).starts_with(", where "), "r is next to 0 at {scale}");
            assert!(near(scale, 0.7 * scale, 1e-8).contains("sin(theta)"), "the angle is next to 0 at {scale}");
        }
    }
}
