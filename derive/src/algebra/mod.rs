//! Exact computer algebra: terms, their values, normal forms, comparison, solution and text. No
//! part of it depends on mechanics.

pub mod form;
pub mod meaning;
pub mod solve;
pub mod term;
pub mod text;
pub mod value;

pub use term::arena::{Arena, Expr, Function, Node, PowerError};
pub use term::rational::Rational;
