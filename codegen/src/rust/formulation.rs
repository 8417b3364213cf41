//! Rust files of one formulation of one model: a file of equations for people, and a file of code.

use super::jacobian_product::{JACOBIAN_PRODUCT, Rates, jacobian_product};
use super::rust_function::{Parameters, function, function_documentation};
use super::rust_text::{escape_doc_comment, format, reexport, rust_file_header};
use super::sorted_functions::WrittenFunctions;
use super::system_methods::{self, SystemMethods};
use super::taylor::{self, TaylorText};
use crate::plan::{FormulationPlan, module_name, type_name};
use quote::{format_ident, quote};
use tripos_derive::algebra::Expr;

/// Texts of the two Rust files of one formulation.
pub struct FormulationFiles {
    /// Text of the file for people, such as `kane.rs`. It states the formulas of mass matrix,
    /// forcing, accelerations, kinematic equations and energies, each above the re-export of its
    /// function.
    pub equations: String,
    /// Text of the file with code, such as `code/kane.rs`: all functions, and the implementation of
    /// `System`.
    pub code: String,
}

/// Writes the Rust files of a formulation. `origin` is the header sentence on their origin. A function that another
/// formulation of the model already has is imported, not written again.
#[must_use]
pub fn rust_formulation_files(
    plan: &FormulationPlan<'_>,
    origin: &str,
    written: &mut WrittenFunctions,
) -> FormulationFiles {
    let (model, equations) = (plan.planner.model, plan.planner.equations);
    let (parameters, module) = (Parameters::of(model), module_name(&equations.name(model)));
    let taylor = plan.taylor.as_ref().map(|plan| ("taylor", taylor::function(plan, &parameters)));
    let planned =
        plan.equations.iter().chain(&plan.machine).map(|planned| (planned.name, function(planned, &parameters)));
    let sorted = written.sort(&module, planned.chain(taylor));

    let has = |name: &str| plan.machine.iter().any(|planned| planned.name == name);
    let linear = SystemMethods::LinearSystem { together: has("linear_system") };
    let mut parts = vec![linear, SystemMethods::WholeState(model.coordinates.len() + model.speeds.len())];
    let is_solved = plan.solved_cost.is_some();
    let (product, together) = (is_solved && !has("jacobian"), has("derivative"));
    parts.extend(is_solved.then_some(SystemMethods::Eliminated { product, together }));
    parts.extend((plan.planner.equations.power != Expr::ZERO).then_some(SystemMethods::Power));
    parts.extend(plan.taylor.as_ref().map(|plan| SystemMethods::Taylor(plan.width())));
    parts.extend((!plan.divisors.is_empty()).then(|| SystemMethods::Divisors(plan.divisors.clone())));
    parts.extend((!plan.constraints.is_empty()).then(|| SystemMethods::Constraints(plan.constraints.clone())));
    // The function `jacobian_product` is never shared, because equal texts of it call different functions.
    let rates = if together { Rates::Together } else { Rates::Apart };
    let differentiated = product.then(|| jacobian_product(equations, rates));
    let (dual, by_columns) = (product.then(|| quote!(Dual,)), product.then(|| quote!(, by_columns)));
    let system = system_methods::system(model, equations, &parts);
    let text = if sorted.has("taylor") { TaylorText::Here } else { TaylorText::Elsewhere };
    let series = plan.taylor.as_ref().map(|plan| taylor::imports(plan, text));
    let (own, imports) = (&sorted.own, sorted.imports());
    let title = format!(
        "{}: {}, {}.",
        escape_doc_comment(&model.title),
        escape_doc_comment(&equations.title(model)),
        equations.formulation.equation(model)
    );
    let code = format(
        &rust_file_header(title.clone(), origin, &[]),
        quote! {
            use super::super::Parameters;
            #(#imports)*
            #series
            use tripos_traits::{#dual Lengths, Scalar, System #by_columns};
            #(#own)*
            #differentiated
            #system
        },
    );

    let own = plan.equations.iter().filter(|planned| sorted.has(planned.name));
    let shown = own.map(|planned| {
        let (docs, module, name) =
            (function_documentation(planned), format_ident!("{module}"), format_ident!("{}", planned.name));
        quote!(#docs #[doc(inline)] pub use super::code::#module::#name;)
    });
    // A function that is shared with another formulation is documented in that formulation's file.
    let is_shown = |name: &&str| plan.equations.iter().any(|planned| planned.name == *name);
    let shared = sorted.others.iter().map(|(module, names)| (module, names.iter().copied().filter(is_shown)));
    let shared = shared.filter(|(_, names)| names.clone().next().is_some());
    let shared = shared.map(|(module, names)| reexport(&quote!(super), module, names));
    let unit = type_name(&equations.name(model));
    let machine = plan.machine.iter().map(|planned| planned.name).chain(plan.taylor.as_ref().map(|_| "taylor"));
    let machine = machine.chain(product.then_some(JACOBIAN_PRODUCT));
    let rest = reexport(&quote!(super::code), &module, machine.chain([unit.as_str()]));
    let equations = format(&rust_file_header(title, origin, &plan.facts), quote!(#rest #(#shared)* #(#shown)*));
    FormulationFiles { equations, code }
}
