//! Markup of the page: shapes of HTML, formulas as MathML, transcribed formulas.

pub mod html;
pub(super) mod math;
#[cfg(test)]
pub(super) mod math_tests;
pub(super) mod typeset;
