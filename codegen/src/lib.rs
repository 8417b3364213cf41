//! Equations to readable code, the same bytes for the same model text on every machine.
//!
//! The flow: [`tripos_derive::Equations`] → a plan of functions ([`plan`], [`taylor`]), which knows no language → the
//! text of a target (`rust`, `js`, each behind the feature of that name) → files (`workspace`, `emit`). The recurrences
//! of [`taylor`] can be interpreted as well. Nothing here reads a clock, an environment variable or a hash map's order.

#[cfg(any(feature = "rust", feature = "js"))]
pub mod emit;
#[cfg(feature = "rust")]
mod extras;
#[cfg(feature = "files")]
pub mod files;
#[cfg(feature = "js")]
pub mod js;
#[cfg(any(feature = "rust", feature = "js"))]
mod lines;
#[cfg(any(feature = "rust", feature = "js"))]
mod origin;
pub mod plan;
#[cfg(feature = "rust")]
pub mod rust;
#[cfg(feature = "files")]
pub mod scene_files;
#[cfg(any(feature = "rust", feature = "js"))]
pub mod target;
pub mod taylor;
#[cfg(feature = "rust")]
pub mod workspace;

#[cfg(feature = "rust")]
pub use extras::Extras;
#[cfg(feature = "rust")]
pub use workspace::{Difference, Freshness, Generated, freshness};
