//! Solvers of equations: linear systems, minimization of quadratic forms, linear relations, closed
//! forms, antiderivatives.

pub mod antiderivative;
pub mod block_systems;
pub mod closed;
pub mod elimination;
pub mod linear;
pub mod linear_relations;
mod minors;
pub mod pivot_values;
pub(crate) mod quadratic_equation;
pub mod quadratic_minimum;
mod sparse_block;
pub mod system_labels;
