//! What generated equations of motion implement, and what the simulator runs.
//!
//! Two traits: [`Scalar`], the arithmetic a generated function body needs, so that one text serves
//! `f64`, `f32` and every wider or narrower type; and [`System`], one formulation of one model as
//! mass matrix, forcing and kinematic equations. And one wider number, [`DoubleDouble`], of 32 digits.
//!
//! Absent on purpose: names, units and files. They belong to the model, not to its numbers.
#![no_std]

// A fused product and sum is an instruction, but only the standard library has a name for it.
#[cfg(target_feature = "fma")]
extern crate std;

mod double_double;
mod scalar;
mod system;

pub use double_double::DoubleDouble;
pub use scalar::{Real, Scalar};
pub use system::{CompiledModel, CompiledSystem, System};
