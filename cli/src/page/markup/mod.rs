//! Markup of the page: pieces of HTML, formulas as MathML, and typeset formulas of publications.

pub mod html;
pub(super) mod math;
#[cfg(test)]
pub(super) mod math_tests;
pub(super) mod typeset;
