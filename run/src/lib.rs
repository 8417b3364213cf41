//! Mechanisms and their scenes, prepared and run. The library offers the functions of the `tripos`
//! command to programs.
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
//! A program begins with [`Scene`] and [`Mechanism`]. The modules contain the parts of both, for
//! special needs. The library never prints, never ends the process, and knows no command line. A
//! scene runs by compiled equations if the program contains them ([`Scene::with`]). Otherwise the
//! equations are interpreted; the results agree to rounding.

// The examples of the README are tested too.
#![cfg_attr(doctest, doc = include_str!("../README.md"))]

pub mod code;
mod equations_name;
mod error;
pub mod follow;
mod interpreted;
mod mechanism;
mod options;
mod overrides;
pub mod pictures;
pub mod preparation;
mod scene;
mod scratch_pool;
mod simulation;
pub mod studies;
pub mod trust;

pub use equations_name::EquationsName;
pub use error::Error;
pub use mechanism::Mechanism;
pub use options::method_words;
pub use overrides::Overrides;
pub use preparation::near_divisors::near_divisors;
pub use preparation::problem::Problem;
pub use preparation::reduced::Reduced;
pub use scene::Scene;
pub use simulation::outputs::state_names;
pub use simulation::run::Run;
pub use simulation::run_problem::{run_code, run_problem, whole_energies};
pub use simulation::sampled::{Decision, Held, Sample, SampledRun};
pub use simulation::simulate::simulate;
pub use studies::sensitivity::gradient::{Gradient, gradient};
pub use studies::sensitivity::{At, Sensitivities, sensitivities};
pub use tripos_derive::scene::{Integrator, Project, Solve};
pub use tripos_sim::Method;
pub use trust::digits::Digits;
pub use trust::invariants::{Conserved, Course, Drift, Watch};
pub use trust::reference::Reference;
pub use trust::residuals::Residual;
