//! Spacing of floating-point numbers on the time axis, which bounds step sizes from below, and the exact
//! equality of two numbers.

/// Distance from |t| to the next larger `f64` (unit in the last place), as MATLAB's `eps(t)`.
pub(crate) fn rounding_unit(t: f64) -> f64 {
    t.abs().next_up() - t.abs()
}

/// Smallest step size that a run tries at time `t`, s: 16 units in the last place of t.
pub(crate) fn smallest_step_beyond_rounding(t: f64) -> f64 {
    16.0 * rounding_unit(t)
}

/// True if two numbers are exactly equal; 0 equals −0.
#[expect(clippy::float_cmp, reason = "asks for identity, not for nearness")]
pub(crate) fn exactly_equal(a: f64, b: f64) -> bool {
    a == b
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ulp_is_the_spacing_of_numbers() {
        assert_eq!(rounding_unit(1.0), f64::EPSILON);
        assert_eq!(rounding_unit(-3.0), 2.0 * f64::EPSILON);
        assert_eq!(rounding_unit(0.0), f64::from_bits(1));
    }
}
