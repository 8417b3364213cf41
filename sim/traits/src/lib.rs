//! Traits of generated equations of motion, and the numbers that the simulator runs them in.
//!
//! Two traits: [`Scalar`], the arithmetic that a generated function body needs, so that one text serves `f64`, `f32`
//! and every wider or narrower type; and [`System`], one formulation of one model as mass matrix, forcing and kinematic
//! equations. And five more scalars: [`DoubleDouble`], a number of 32 digits, [`Lanes`], several doubles side by side,
//! [`Dual`], a number with its slope, [`Tangent`], a double with several slopes, and [`Enclosure`], the ranges of a
//! function's values and slopes.
//!
//! The feature `std`, on by default, lets lanes use the vector instructions that the processor turns out to have, and
//! brings [`AbsoluteTolerance`], which scene files and the simulator have in common; without it the crate needs no
//! standard library, and lanes give the same numbers more slowly.
//!
//! Beside these: names that scenes and the simulator share, [`Method`], [`Direction`] and absolute tolerances, and
//! maxima that know what NaN is ([`larger`]).
//!
//! Absent on purpose: names, units and files. They belong to the model, not to its numbers.
// The examples of the README are tested too.
#![cfg_attr(doctest, doc = include_str!("../README.md"))]
#![no_std]

// Only the standard library detects the instructions of a processor, and has a fused product and sum.
#[cfg(feature = "std")]
#[macro_use]
extern crate std;
#[cfg(feature = "std")]
extern crate alloc;

mod circular;
mod compiled;
mod direction;
mod dispatch;
mod double_double;
mod dual;
mod enclosure;
mod interval;
mod lanes;
mod maxima;
mod method;
mod points;
mod scalar;

mod system;
mod tangent;
#[cfg(feature = "std")]
mod tolerance;

pub use compiled::{
    CompiledModel, CompiledScene, CompiledSystem, Derivative, Flow, InLanes, InTangents, Rates, Series,
};
pub use direction::Direction;
pub use dispatch::lane_width;
pub use double_double::DoubleDouble;
pub use dual::Dual;
pub use enclosure::Enclosure;
pub use interval::Interval;
pub use lanes::Lanes;
pub use maxima::{larger, larger_or_second, largest};
pub use method::Method;
pub use points::{AtPoints, Integrands};
pub use scalar::{Real, Scalar, series};
pub use system::{Lengths, System, by_columns};
pub use tangent::Tangent;
#[cfg(feature = "std")]
pub use tolerance::{ATOL, AbsoluteTolerance, RTOL};
