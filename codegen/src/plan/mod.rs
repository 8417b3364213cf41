//! Plan of generated code: its functions and their programs, before they are written in a language.
//!
//! From equations, a [`Planner`] makes a [`Function`]. A function has a name, arguments, a return value, and a
//! [`Program`] of ordered, shared and named lines, each with its formula as a comment. The cost of a call is counted
//! over the program.
//!
//! A target, such as `rust`, writes the function and decides nothing about the computation. It only states a
//! [`Language`]: the names that it cannot use. The plan contains no syntax.

mod equation_functions;
mod formulation_plan;
mod module_plan;
mod motion_plan;
mod programs;
mod regressor;
mod scene_outputs;
mod scene_plan;
mod taylor_plan;

pub use equation_functions::derivative;
pub use formulation_plan::{FormulationPlan, Jacobian};
pub use module_plan::{ModulePlan, Solution};
pub use motion_plan::{MotionPlan, WatchedQuantity};
pub use programs::arguments::{Argument, Entry};
pub use programs::cost::OperationCount;
#[cfg(feature = "languages")]
pub(crate) use programs::function::result_matrix_size;
pub use programs::function::{Arguments, Function, LineComments, Returns, Value};
pub use programs::fusion::{is_fusible_product, order_sum_for_fusion};
pub use programs::planner::{Planner, Sharing};
pub use programs::program::{Output, Program, ProgramLine, Statement, program};
pub use programs::program_parts::{Part, Parts};
pub use programs::variable_names::{
    Allocator, Language, SymbolVariableNames, TermVariableNames, module_name, type_name, variable_name_without_primes,
    variable_word_of_formula,
};
pub use regressor::RegressorFunctions;
#[cfg(feature = "languages")]
pub(crate) use scene_outputs::numbered_values;
pub use scene_outputs::{MissingOutputReason, SceneOutputs};
pub use scene_plan::{Costs, SceneEquations, ScenePlan, Taylor, linear_system_cost, scene_costs};
pub use taylor_plan::TaylorPlan;
pub use tripos_derive::algebra::text::display_tree::{constant_and_factors, is_sum_free_formula};
