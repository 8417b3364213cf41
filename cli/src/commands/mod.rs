//! Subcommands of `tripos`, one file for each.

pub mod chart;
pub mod check;
pub mod derive;
pub mod diff;
pub mod emit;
pub mod equilibria;
pub mod evaluate;
pub mod fmu;
pub mod grade;
pub mod identify;
pub mod inverse;
pub mod linearise;
pub mod manual;
pub mod new;
pub mod page;
pub mod plot;
pub mod prove;
pub mod regenerate;
pub mod scene;
pub mod schema;
pub mod shelf;
pub mod simulate;
pub mod sketch;
pub mod stability;
pub mod sweep;
pub mod view;
