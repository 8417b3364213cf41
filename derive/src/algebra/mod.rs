//! Exact computer algebra. It knows no mechanics.

pub mod arena;
pub mod blocks;
pub mod calculus;
mod construct;
mod elementary;
pub mod evaluate;
pub mod linear;
pub mod modular;
pub mod parse;
pub mod polynomial;
pub mod print;
mod rational;
pub mod simplify;
pub mod view;

pub use arena::{Arena, Expr, Function, Node, PowerError};
pub use rational::Rational;
