//! Forms of terms: the normal form, forms with fewer operations, and readable forms.

pub(super) mod fraction;
pub mod normal_form;
pub mod polynomial;
pub mod readable;
pub(super) mod ring;
pub mod sharing;
pub mod simplify;
pub(super) mod sum_atoms;
