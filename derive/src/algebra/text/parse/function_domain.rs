//! Domains of elementary functions: the arguments for which they have real values.

use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr, Function, Rational};

/// True if the function has no real value for some real arguments.
pub(super) fn has_limited_domain(f: Function) -> bool {
    matches!(f, Function::Sqrt | Function::Log | Function::Asin | Function::Acos)
}

/// True if the argument is a constant outside the domain of the function. The test is exact for
/// rational numbers, and to rounding for other constants. False for an argument with symbols.
pub(super) fn is_outside_domain(arena: &Arena, f: Function, argument: Expr) -> bool {
    if !has_limited_domain(f) {
        return false;
    }
    if let Some(value) = arena.as_number(argument) {
        let size = if value.is_negative() { value.neg() } else { value.clone() };
        return match f {
            Function::Sqrt => value.is_negative(),
            Function::Log => value.is_negative() || value.is_zero(),
            _ => size > Rational::ONE,
        };
    }
    // A constant argument is evaluated in doubles; an argument with symbols may have any value.
    let Ok(tape) = Tape::new(arena, &[], &[argument]) else { return false };
    let value = tape.evaluate(&[])[0];
    match f {
        Function::Sqrt => value < -ROUNDING,
        Function::Log => value <= 0.0,
        _ => value.abs() > 1.0 + ROUNDING,
    }
}

/// Rounding error that is allowed in the value of a constant such as sin(1)^2 + cos(1)^2.
const ROUNDING: f64 = 1e-12;
