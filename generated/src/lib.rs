//! Equations of motion, compiled: one module a model, one file a formulation.
//!
//! Generated from the files under `models/`. Do not edit; run `tripos regenerate`.
//! A model that was edited since is run interpreted: compiled equations carry the hash of their text.

#![no_std]
#![allow(clippy::pedantic)]
/// The model `bricard`.
#[rustfmt::skip]
pub mod bricard;

/// The model `cart_pendulum_3`.
#[rustfmt::skip]
pub mod cart_pendulum_3;

/// The model `cart_with_spring`.
#[rustfmt::skip]
pub mod cart_with_spring;

/// The model `cartesian_pendulum`.
#[rustfmt::skip]
pub mod cartesian_pendulum;

/// The model `chaotic_pendulum`.
#[rustfmt::skip]
pub mod chaotic_pendulum;

/// The model `disk`.
#[rustfmt::skip]
pub mod disk;

/// The model `driven_pendulum`.
#[rustfmt::skip]
pub mod driven_pendulum;

/// The model `elastic_pendulum`.
#[rustfmt::skip]
pub mod elastic_pendulum;

/// The model `euler_top`.
#[rustfmt::skip]
pub mod euler_top;

/// The model `floating_chain`.
#[rustfmt::skip]
pub mod floating_chain;

/// The model `four_bar`.
#[rustfmt::skip]
pub mod four_bar;

/// The model `free_body`.
#[rustfmt::skip]
pub mod free_body;

/// The model `furuta`.
#[rustfmt::skip]
pub mod furuta;

/// The model `gimbals`.
#[rustfmt::skip]
pub mod gimbals;

/// The model `governor`.
#[rustfmt::skip]
pub mod governor;

/// The model `heavy_top`.
#[rustfmt::skip]
pub mod heavy_top;

/// The model `knife_edge`.
#[rustfmt::skip]
pub mod knife_edge;

/// The model `pendulum`.
#[rustfmt::skip]
pub mod pendulum;

/// The model `puma560`.
#[rustfmt::skip]
pub mod puma560;

/// The model `rolling_disc`.
#[rustfmt::skip]
pub mod rolling_disc;

/// The model `satellite`.
#[rustfmt::skip]
pub mod satellite;

/// The model `slider_crank`.
#[rustfmt::skip]
pub mod slider_crank;

/// The model `spherical_pendulum`.
#[rustfmt::skip]
pub mod spherical_pendulum;

/// The model `squeezer`.
#[rustfmt::skip]
pub mod squeezer;

/// The model `whipple_bicycle`.
#[rustfmt::skip]
pub mod whipple_bicycle;

/// The model `window_linkage`.
#[rustfmt::skip]
pub mod window_linkage;

/// Every compiled model, by name.
#[rustfmt::skip]
pub static MODELS: &[tripos_traits::CompiledModel] = &[
    bricard::MODEL, cart_pendulum_3::MODEL, cart_with_spring::MODEL, cartesian_pendulum::MODEL,
    chaotic_pendulum::MODEL, disk::MODEL, driven_pendulum::MODEL, elastic_pendulum::MODEL,
    euler_top::MODEL, floating_chain::MODEL, four_bar::MODEL, free_body::MODEL, furuta::MODEL,
    gimbals::MODEL, governor::MODEL, heavy_top::MODEL, knife_edge::MODEL, pendulum::MODEL,
    puma560::MODEL, rolling_disc::MODEL, satellite::MODEL, slider_crank::MODEL,
    spherical_pendulum::MODEL, squeezer::MODEL, whipple_bicycle::MODEL, window_linkage::MODEL,
];
