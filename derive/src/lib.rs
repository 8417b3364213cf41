//! Derives the equations of motion of a mechanism from its model file, by several independent
//! formulations.
//!
//! ```
//! use tripos_derive::algebra::text::print::print_text;
//! use tripos_derive::diagnostic::Source;
//! use tripos_derive::{Formulation, derive, model};
//!
//! let source = Source::from_text("pendulum.toml", r#"
//!     name = "Pendulum"
//!     [parameters]
//!     m = { unit = "kg", positive = true }
//!     l = { unit = "m", positive = true }
//!     g = { unit = "m/s^2", positive = true }
//!     [coordinates]
//!     q1 = { unit = "rad", about = "from hanging" }
//!     [speeds]
//!     u1 = "q1'"
//!     [inertial]
//!     frame = "N"
//!     origin = "O"
//!     [frames]
//!     A = { from = "N", axis = 3, angle = "q1" }
//!     [points]
//!     P = { from = "O", frame = "A", position = [0, "-l", 0] }
//!     [particles]
//!     bob = { point = "P", mass = "m" }
//!     [gravity]
//!     frame = "N"
//!     acceleration = [0, "-g", 0]
//! "#);
//! let model = model::load(&source)?;
//! let kane = derive(&model, Formulation::Kane)?;
//! assert_eq!(print_text(&kane.arena, kane.equations.matrix[0][0]), "m*l^2");
//! assert_eq!(print_text(&kane.arena, kane.equations.forcing[0]), "-m*l*g*sin(q1)");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Data flow in one direction: [`diagnostic::Source`] → [`model::Model`] →
//! [`mechanics::Kinematics`] → [`mechanics::Equations`] by Kane, Lagrange or Newton–Euler. No stage
//! changes the result of an earlier stage. The formulations share the kinematics and nothing else.

// The examples of the README are tested too.
#![cfg_attr(doctest, doc = include_str!("../README.md"))]

pub mod algebra;
pub mod check;
#[cfg(feature = "files")]
mod csv_text;
pub mod diagnostic;
pub mod diff;
pub mod flow;
pub mod geometry;
pub mod identify;
pub mod mechanics;
pub mod model;
pub mod plain_text;
pub mod prove;
pub mod publication;
pub mod reduce;
pub mod reference;
pub mod scene;
pub mod schema;
pub mod toml_reader;

pub use mechanics::{Equations, Formulation, derive};
pub use model::Model;
pub use toml_reader::SCHEMA;
