//! Eigenvalues, modes and controllability of linear systems, in doubles and in 32 digits.

pub(super) mod controllability;
pub(super) mod eigenvalue_groups;
pub(super) mod eigenvalues;
pub(super) mod mode;
pub(super) mod nilpotent_part;
pub(super) mod schur_form;
pub(super) mod wide_complex;
pub(super) mod wide_matrix;
