//! Plan of generated code: its functions and their programs, before they are written in a language.
//!
//! The flow: equations → a [`Planner`] → [`Function`]. A function has a name, arguments, a return
//! value, and a [`Program`] of ordered, shared and named lines, each with its formula as a comment.
//! The cost of a call is counted over the program. A target, such as `rust`, writes the function
//! and decides nothing. The target only states a [`Language`]: the names that it cannot use. The
//! plan contains no syntax.

mod arguments;
mod cost;
mod form;
mod formulation;
mod function;
mod module;
mod motion;
mod names;
mod parts;
mod program;
mod regressor;
mod scene;
mod scene_outputs;
mod taylor;

pub use arguments::{Argument, Entry};
pub use cost::Cost;
pub use form::{constant_and_factors, is_flat, is_plain_product, led};
pub use formulation::{FormulationPlan, Jacobian, derivative};
pub use function::{Arguments, Explanation, Function, Planner, Returns, Sharing, Value};
pub use module::{ModulePlan, Solution};
pub use motion::{MotionPlan, Watched};
pub use names::{Allocator, Language, Names, Variables, identifier, module_name, spelled, type_name};
pub use parts::{Part, Parts};
pub use program::{Line, Output, Program, Statement, program};
pub use regressor::Regression;
pub use scene::{Costs, SceneEquations, ScenePlan, Taylor, costs};
#[cfg(feature = "languages")]
pub(crate) use scene_outputs::numbered;
pub use scene_outputs::{Hidden, Shown};
pub use taylor::TaylorPlan;
