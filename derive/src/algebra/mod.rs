//! Exact computer algebra. It knows no mechanics.

pub mod arena;
mod atoms;
pub mod blocks;
mod bound;
pub mod calculus;
pub mod compare;
mod construct;
pub mod divided;
mod elementary;
pub mod elimination;
pub mod evaluate;
pub(crate) mod exact;
pub(crate) mod field;
pub mod fold;
mod fraction;
pub(crate) mod interval;
pub mod linear;
pub mod modular;
pub mod normal;
pub mod parse;
mod points;
pub mod polynomial;
pub mod primitive;
pub mod print;
pub mod range;
pub mod rank;
mod rational;
pub mod relations;
mod ring;
pub mod sharing;
pub mod simplify;
pub mod steps;
pub mod view;

pub use arena::{Arena, Expr, Function, Node, PowerError};
pub use rational::Rational;
