//! Judgement of single printed formulas and numbers.

pub(super) mod constant;
mod energies;
pub(super) mod entries;
pub(super) mod finding;
pub(super) mod initial;
pub(super) mod near;
pub(super) mod ratio;
pub(super) mod rounding;
pub(super) mod swapped_lists;
pub(super) mod terms;
