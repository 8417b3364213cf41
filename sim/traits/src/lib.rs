//! Traits of generated equations of motion, and the numeric types in which the simulator runs them.
//!
//! [`Scalar`] is the arithmetic that a generated function body needs, so that the same text serves
//! `f64`, `f32` and all other numeric types. [`System`] is a formulation of a model as mass matrix,
//! forcing and kinematic equations.
//!
//! Further scalars are [`DoubleDouble`] (a number with 32 digits), [`Lanes`] (several f64 side by
//! side), [`Dual`] (a number with a derivative), [`Tangent`] (an f64 with several derivatives), and
//! [`Enclosure`] (ranges of a function's values and derivatives).
//!
//! The feature `std`, on by default, lets lanes use the vector instructions that the processor has,
//! and adds [`AbsoluteTolerance`], which scene files and the simulator share. Without it, the crate
//! needs no standard library, and lanes give equal numbers more slowly.
//!
//! Scenes and the simulator also share [`Method`], [`Direction`], absolute tolerances, and maxima
//! that respect NaN ([`larger`]). Names, units and files are not in this crate: they belong to the
//! model, not to its numbers.
// The examples of the README are tested too.
#![cfg_attr(doctest, doc = include_str!("../README.md"))]
#![no_std]

// Only the standard library detects the instructions of a processor, and has a fused product and sum.
#[cfg(feature = "std")]
#[macro_use]
extern crate std;
#[cfg(feature = "std")]
extern crate alloc;

mod compiled;
mod direction;
mod dispatch;
mod method;
mod numbers;
mod points;

mod system;
#[cfg(feature = "std")]
mod tolerance;

pub use compiled::{
    CompiledModel, CompiledScene, CompiledSystem, Derivative, Flow, InLanes, InTangents, Rates, Series,
};
pub use direction::Direction;
pub use dispatch::lane_width;
pub use method::Method;
pub use numbers::ball::{Ball, Centre};
pub use numbers::double_double::DoubleDouble;
pub use numbers::dual::Dual;
pub use numbers::enclosure::Enclosure;
pub use numbers::interval::Interval;
pub use numbers::lanes::Lanes;
pub use numbers::maxima::{larger, larger_or_second, largest};
pub use numbers::scalar::{Real, Scalar, series};
pub use numbers::tangent::Tangent;
pub use points::{AtPoints, Integrands};
pub use system::{Lengths, System, by_columns};
#[cfg(feature = "std")]
pub use tolerance::{ATOL, AbsoluteTolerance, RTOL};
