//! Plan of generated code: its functions and their programs, before they are written in a language.
//!
//! The flow: equations → a [`Planner`] → [`Function`]. A function has a name, arguments, a return
//! value, and a [`Program`] of ordered, shared and named lines, each with its formula as a comment.
//! The cost of a call is counted over the program. A target, such as `rust`, writes the function
//! and decides nothing. The target only states a [`Language`]: the names that it cannot use. The
//! plan contains no syntax.

mod arguments;
mod cost;
mod equation_functions;
mod formulation_plan;
mod function;
mod fusion;
mod module_plan;
mod motion_plan;
mod planner;
mod program;
mod program_parts;
mod regressor;
mod scene_outputs;
mod scene_plan;
mod taylor_plan;
mod variable_names;

pub use arguments::{Argument, Entry};
pub use cost::OperationCount;
pub use equation_functions::derivative;
pub use formulation_plan::{FormulationPlan, Jacobian};
#[cfg(feature = "languages")]
pub(crate) use function::result_matrix_size;
pub use function::{Arguments, Function, LineComments, Returns, Value};
pub use fusion::{is_fusible_product, order_sum_for_fusion};
pub use module_plan::{ModulePlan, Solution};
pub use motion_plan::{MotionPlan, WatchedQuantity};
pub use planner::{Planner, Sharing};
pub use program::{Output, Program, ProgramLine, Statement, program};
pub use program_parts::{Part, Parts};
pub use regressor::RegressorFunctions;
#[cfg(feature = "languages")]
pub(crate) use scene_outputs::numbered_values;
pub use scene_outputs::{MissingOutputReason, SceneOutputs};
pub use scene_plan::{Costs, SceneEquations, ScenePlan, Taylor, scene_costs};
pub use taylor_plan::TaylorPlan;
pub use tripos_derive::algebra::text::display_tree::{constant_and_factors, is_sum_free_formula};
pub use variable_names::{
    Allocator, Language, SymbolVariableNames, TermVariableNames, module_name, type_name, variable_name_without_primes,
    variable_word_of_formula,
};
