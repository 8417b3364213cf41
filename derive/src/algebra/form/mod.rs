//! Forms of terms: the normal form, forms with fewer operations, and readable forms.

pub(super) mod fraction;
pub mod normal_form;
pub mod polynomial;
pub(super) mod ring;
mod ring_point;
pub(super) mod ring_polynomial;
pub mod sharing;
pub mod simplify;
pub(super) mod sum_atoms;
pub mod written_out_formula;
