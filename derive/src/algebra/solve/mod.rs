//! Solvers of equations: linear systems, minimization of quadratic forms, linear relations, closed
//! forms, antiderivatives.

pub mod blocks;
pub mod closed;
pub mod elimination;
pub mod least;
pub mod linear;
pub mod primitive;
pub mod relations;
