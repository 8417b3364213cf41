//! Judgement of single printed formulas and numbers.

pub(super) mod constant_terms;
pub(super) mod entry_judge;
pub(super) mod expansion_near_point;
pub(super) mod finding;
pub(super) mod formula_reading;
mod free_parts_of_energies;
pub(super) mod printed_numbers;
pub(super) mod ratio;
pub(super) mod rounded_numbers;
pub(super) mod swapped_lists;
pub(super) mod wrong_terms;
