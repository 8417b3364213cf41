//! Mechanisms and their scenes, made ready and run: what the `tripos` command does, for programs.
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
//! [`Scene`] and [`Mechanism`] are where a program begins; the modules are the parts that they are made of, for who needs more.
//! Nothing here prints, ends the process, or knows a command line. Equations run compiled if a program brings them along
//! ([`Scene::with`]), else interpreted, with the same results to rounding.

pub mod chart;
pub mod code;
pub mod error;
pub mod figure;
pub mod follow;
pub mod interpreted;
pub mod invariants;
pub mod mechanism;
pub mod near;
pub mod overrides;
pub mod problem;
pub mod reduced;
pub mod reference;
pub mod run;
pub mod scene;
pub mod shown;
pub mod stability;
mod start;
pub mod study;
pub mod sweep;
pub mod trust;

pub use error::Error;
pub use mechanism::Mechanism;
pub use overrides::Overrides;
pub use run::Run;
pub use scene::Scene;
