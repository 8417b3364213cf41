//! Equations of motion, compiled: one module a model, one file a formulation.
//!
//! Generated from the files under `models/`. Do not edit; run `tripos regenerate`.
//! `build.rs` says which are compiled: those whose features are on, and those that have none. A model that is not, or that
//! was edited since, is run interpreted: compiled equations carry the hash of their text.

#![no_std]
#![allow(clippy::pedantic)]
#[cfg(compiled = "bricard")]
/// The model `bricard`.
#[rustfmt::skip]
pub mod bricard;

#[cfg(compiled = "cart_pendulum_3")]
/// The model `cart_pendulum_3`.
#[rustfmt::skip]
pub mod cart_pendulum_3;

#[cfg(compiled = "cart_with_spring")]
/// The model `cart_with_spring`.
#[rustfmt::skip]
pub mod cart_with_spring;

#[cfg(compiled = "cartesian_pendulum")]
/// The model `cartesian_pendulum`.
#[rustfmt::skip]
pub mod cartesian_pendulum;

#[cfg(compiled = "chaotic_pendulum")]
/// The model `chaotic_pendulum`.
#[rustfmt::skip]
pub mod chaotic_pendulum;

#[cfg(compiled = "disk")]
/// The model `disk`.
#[rustfmt::skip]
pub mod disk;

#[cfg(compiled = "driven_pendulum")]
/// The model `driven_pendulum`.
#[rustfmt::skip]
pub mod driven_pendulum;

#[cfg(compiled = "elastic_pendulum")]
/// The model `elastic_pendulum`.
#[rustfmt::skip]
pub mod elastic_pendulum;

#[cfg(compiled = "euler_top")]
/// The model `euler_top`.
#[rustfmt::skip]
pub mod euler_top;

#[cfg(compiled = "floating_chain")]
/// The model `floating_chain`.
#[rustfmt::skip]
pub mod floating_chain;

#[cfg(compiled = "four_bar")]
/// The model `four_bar`.
#[rustfmt::skip]
pub mod four_bar;

#[cfg(compiled = "free_body")]
/// The model `free_body`.
#[rustfmt::skip]
pub mod free_body;

#[cfg(compiled = "furuta")]
/// The model `furuta`.
#[rustfmt::skip]
pub mod furuta;

#[cfg(compiled = "gimbals")]
/// The model `gimbals`.
#[rustfmt::skip]
pub mod gimbals;

#[cfg(compiled = "governor")]
/// The model `governor`.
#[rustfmt::skip]
pub mod governor;

#[cfg(compiled = "heavy_top")]
/// The model `heavy_top`.
#[rustfmt::skip]
pub mod heavy_top;

#[cfg(compiled = "knife_edge")]
/// The model `knife_edge`.
#[rustfmt::skip]
pub mod knife_edge;

#[cfg(compiled = "pendulum")]
/// The model `pendulum`.
#[rustfmt::skip]
pub mod pendulum;

#[cfg(compiled = "puma560")]
/// The model `puma560`.
#[rustfmt::skip]
pub mod puma560;

#[cfg(compiled = "rolling_disc")]
/// The model `rolling_disc`.
#[rustfmt::skip]
pub mod rolling_disc;

#[cfg(compiled = "satellite")]
/// The model `satellite`.
#[rustfmt::skip]
pub mod satellite;

#[cfg(compiled = "slider_crank")]
/// The model `slider_crank`.
#[rustfmt::skip]
pub mod slider_crank;

#[cfg(compiled = "spherical_pendulum")]
/// The model `spherical_pendulum`.
#[rustfmt::skip]
pub mod spherical_pendulum;

#[cfg(compiled = "squeezer")]
/// The model `squeezer`.
#[rustfmt::skip]
pub mod squeezer;

#[cfg(compiled = "whipple_bicycle")]
/// The model `whipple_bicycle`.
#[rustfmt::skip]
pub mod whipple_bicycle;

#[cfg(compiled = "window_linkage")]
/// The model `window_linkage`.
#[rustfmt::skip]
pub mod window_linkage;

/// Every compiled model, by name.
#[rustfmt::skip]
pub static MODELS: &[tripos_traits::CompiledModel] = &[
    #[cfg(compiled = "bricard")]
    bricard::MODEL,
    #[cfg(compiled = "cart_pendulum_3")]
    cart_pendulum_3::MODEL,
    #[cfg(compiled = "cart_with_spring")]
    cart_with_spring::MODEL,
    #[cfg(compiled = "cartesian_pendulum")]
    cartesian_pendulum::MODEL,
    #[cfg(compiled = "chaotic_pendulum")]
    chaotic_pendulum::MODEL,
    #[cfg(compiled = "disk")]
    disk::MODEL,
    #[cfg(compiled = "driven_pendulum")]
    driven_pendulum::MODEL,
    #[cfg(compiled = "elastic_pendulum")]
    elastic_pendulum::MODEL,
    #[cfg(compiled = "euler_top")]
    euler_top::MODEL,
    #[cfg(compiled = "floating_chain")]
    floating_chain::MODEL,
    #[cfg(compiled = "four_bar")]
    four_bar::MODEL,
    #[cfg(compiled = "free_body")]
    free_body::MODEL,
    #[cfg(compiled = "furuta")]
    furuta::MODEL,
    #[cfg(compiled = "gimbals")]
    gimbals::MODEL,
    #[cfg(compiled = "governor")]
    governor::MODEL,
    #[cfg(compiled = "heavy_top")]
    heavy_top::MODEL,
    #[cfg(compiled = "knife_edge")]
    knife_edge::MODEL,
    #[cfg(compiled = "pendulum")]
    pendulum::MODEL,
    #[cfg(compiled = "puma560")]
    puma560::MODEL,
    #[cfg(compiled = "rolling_disc")]
    rolling_disc::MODEL,
    #[cfg(compiled = "satellite")]
    satellite::MODEL,
    #[cfg(compiled = "slider_crank")]
    slider_crank::MODEL,
    #[cfg(compiled = "spherical_pendulum")]
    spherical_pendulum::MODEL,
    #[cfg(compiled = "squeezer")]
    squeezer::MODEL,
    #[cfg(compiled = "whipple_bicycle")]
    whipple_bicycle::MODEL,
    #[cfg(compiled = "window_linkage")]
    window_linkage::MODEL,
];
