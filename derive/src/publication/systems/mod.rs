//! Reading of printed systems of equations and of Coriolis matrices, and assembly of the text of rows.

pub(super) mod coriolis_matrix;
pub(super) mod printed_system;
pub(super) mod row_text;
