//! Equations of motion, compiled: one module a model, one file a formulation.
//!
//! Generated from the files under `models/`. Do not edit; run `tripos regenerate`.
//! When a model file is newer than this text, the build derives its equations afresh and this
//! crate is built from those instead.

#![no_std]
#![allow(non_snake_case)]
#![allow(clippy::pedantic, clippy::let_and_return)]
#[cfg(not(stale))]
#[rustfmt::skip]
pub mod cart_pendulum_3;

#[cfg(not(stale))]
#[rustfmt::skip]
pub mod chaotic_pendulum;

#[cfg(not(stale))]
#[rustfmt::skip]
pub mod disk;

#[cfg(not(stale))]
#[rustfmt::skip]
pub mod euler_top;

#[cfg(not(stale))]
#[rustfmt::skip]
pub mod floating_chain;

#[cfg(not(stale))]
#[rustfmt::skip]
pub mod free_body;

#[cfg(not(stale))]
#[rustfmt::skip]
pub mod heavy_top;

#[cfg(not(stale))]
#[rustfmt::skip]
pub mod pendulum;

#[cfg(not(stale))]
#[rustfmt::skip]
pub mod spherical_pendulum;

/// Every compiled model, by name.
#[cfg(not(stale))]
#[rustfmt::skip]
pub static MODELS: &[tripos_traits::CompiledModel] = &[
    cart_pendulum_3::MODEL,
    chaotic_pendulum::MODEL,
    disk::MODEL,
    euler_top::MODEL,
    floating_chain::MODEL,
    free_body::MODEL,
    heavy_top::MODEL,
    pendulum::MODEL,
    spherical_pendulum::MODEL,
];

#[cfg(stale)]
include!(concat!(env!("OUT_DIR"), "/stale.rs"));
