//! Mechanisms and their scenes, made ready and run: the functions of the `tripos` command, for programs.
//!
//! ```
//! use tripos::{Overrides, Scene};
//!
//! let mut scene = Scene::read("../models/pendulum/scenes/over.toml")?;
//! assert!(scene.prove()?.is_equivalent());
//! scene.set("g", 1.62)?;
//! let run = scene.simulate(&Overrides { rtol: Some(1e-9), ..Overrides::default() })?;
//! println!("theta ends at {} rad", run.column("theta")?.last().unwrap());
//! run.events().iter().for_each(|event| println!("{} at t = {} s", event.name, event.t));
//! run.drifts.iter().for_each(|drift| println!("{} changes by {:e}", drift.integral, drift.change));
//! run.objections().iter().for_each(|warning| println!("do not trust it: {warning}"));
//! # Ok::<(), tripos::Error>(())
//! ```
//!
//! A program begins with [`Scene`] and [`Mechanism`]. The modules contain the parts of these, for more special needs.
//! The library never prints, ends the process, or knows a command line. Equations run compiled if a program contains
//! them ([`Scene::with`]), else interpreted, with the same results to rounding.

pub mod case;
#[cfg(feature = "clock")]
pub mod chart;
pub mod code;
pub mod compared;
mod digits;
mod error;
pub mod figure;
pub mod follow;
mod how;
pub mod identify;
mod impacts;
mod interpreted;
mod invariants;
pub mod inverse;
mod mechanism;
mod near;
mod overrides;
pub mod passage;
mod power;
mod problem;
mod reduced;
mod reference;
mod residuals;
mod room;
mod run;
mod sampled;
mod scene;
pub mod sensitivity;
mod shown;
mod simulate;
pub mod sketch;
pub mod stability;
mod start;
pub mod steady;
mod stiffness;
pub mod study;
pub mod sweep;
mod trust;
mod turned;
pub mod view;
mod watched;

pub use digits::Digits;
pub use error::Error;
pub use how::method_words;
pub use invariants::{Conserved, Course, Drift, Watch};
pub use mechanism::Mechanism;
pub use near::near_divisors;
pub use overrides::Overrides;
pub use problem::Problem;
pub use reduced::Reduced;
pub use reference::Reference;
pub use residuals::Residual;
pub use run::Run;
pub use sampled::{Decision, Held, Sample, SampledRun};
pub use scene::Scene;
pub use sensitivity::gradient::{Gradient, gradient};
pub use sensitivity::{At, Sensitivities, sensitivities};
pub use shown::state_names;
pub use simulate::{run_code, run_problem, simulate, whole_energies};
