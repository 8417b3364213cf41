//! Solvers for linear systems of the small orders that occur in mechanics, with determinants and
//! condition numbers.
//!
//! Invariant: an order up to 12 is solved on the stack, without an allocation. Absent on purpose:
//! structure (bands, blocks) and iteration; both belong to the equations, not here.

mod condition_number;
pub(crate) mod least_vector_solver;
pub(crate) mod linear_conditions;
mod linear_solver;
pub(crate) mod lu;
pub(crate) mod metric;
pub(crate) mod singular_value;
pub(crate) mod vector_arithmetic;

pub use condition_number::{plain_reciprocal_condition, reciprocal_condition};
pub use linear_solver::{MatrixKind, UnsolvableSystem, matrix_determinant, solve_linear_system};
pub use lu::solve_extended;
