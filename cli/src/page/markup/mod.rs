//! Markup of the page: pieces of HTML, formulas as MathML, and typeset formulas of publications.

pub(super) mod formula_mathml;
pub mod html;
#[cfg(test)]
pub(super) mod math_tests;
pub(super) mod typeset;
