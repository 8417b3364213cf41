//! Mechanisms and their scenes, prepared and run. This library offers the functions of the `tripos` command to
//! programs.
//!
//! ```
//! use tripos::{Overrides, Scene};
//!
//! let mut scene = Scene::read("../models/pendulum/scenes/over.toml")?;
//! assert!(scene.prove()?.is_equivalent());
//! scene.set_number("g", 1.62)?;
//! let run = scene.simulate(&Overrides { rtol: Some(1e-9), ..Overrides::default() })?;
//! println!("theta ends at {} rad", run.column_of_quantity("theta")?.last().unwrap());
//! run.events().iter().for_each(|event| println!("{} at t = {} s", event.name, event.t));
//! run.drifts.iter().for_each(|drift| println!("{} changes by {:e}", drift.integral, drift.change));
//! run.objections().iter().for_each(|warning| println!("do not trust it: {warning}"));
//! # Ok::<(), tripos::Error>(())
//! ```
//!
//! A program begins with [`Scene`] and [`Mechanism`]. The modules contain the parts of both, for special
//! needs. The library never prints, never ends the process, and knows no command line.
//!
//! A scene runs by compiled equations if the program contains them ([`Scene::with_compiled_equations`]).
//! Otherwise the equations are interpreted. The results of both agree up to rounding.

// The examples of the README are tested too.
#![cfg_attr(doctest, doc = include_str!("../README.md"))]

pub mod code;
pub mod equations_name;
mod error;
#[cfg(feature = "files")]
pub mod fit;
mod integration_options;
mod interpreted_equations;
mod mechanism;
pub mod observer;
mod overrides;
pub mod pictures;
pub mod preparation;
mod rigorous;
mod scene;
mod scratch_pool;
mod simulation;
pub mod state_arrays;
pub mod studies;
pub mod trust;

pub use equations_name::EquationsName;
pub use error::Error;
pub use integration_options::integration_method_words;
pub use mechanism::Mechanism;
pub use overrides::Overrides;
pub use preparation::near_divisors::near_divisors;
pub use preparation::problem::Problem;
pub use preparation::reduced_equations::ReducedScene;
pub use rigorous::claims::ClaimVerdict;
pub use rigorous::crossings::{Crossing, CrossingCount};
pub use rigorous::enclosed_run::{EnclosedInstants, RigorousRequest, RigorousScene, enclose_scene};
pub use scene::Scene;
pub use simulation::run::Run;
pub use simulation::run_problem::{run_code, run_problem, set_whole_model_energies};
pub use simulation::sampled_inputs::{ControllerSample, HeldSignal, InputDecision, SampledRun};
pub use simulation::shown_quantities::state_names;
pub use simulation::simulate::simulate;
pub use studies::sensitivity::gradient::{Gradient, gradient};
pub use studies::sensitivity::{DerivativeInstants, Sensitivities, sensitivities};
pub use tripos_derive::scene::{AccelerationSolution, Integrator, ProjectionTarget};
pub use tripos_sim::Method;
pub use trust::constraint_residuals::Residual;
pub use trust::correct_digits::CorrectDigits;
pub use trust::reference_solution::ReferenceSolution;
pub use trust::watched_invariants::{ConservedQuantity, Drift, InvariantValues, WatchedInvariants};
