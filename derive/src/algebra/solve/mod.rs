//! Solvers of equations: linear systems, least quadratic forms, relations, closed forms, antiderivatives.

pub mod blocks;
pub mod closed;
pub mod elimination;
pub mod least;
pub mod linear;
pub mod primitive;
pub mod relations;
