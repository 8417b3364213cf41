//! One formulation of one model as a Rust file.

use super::function::{fields, function};
use super::system::{self, Part};
use super::taylor;
use super::text::{format, prose};
use crate::plan::FormulationPlan;
use quote::quote;

/// The file of one formulation, such as `kane.rs`; `origin` is the sentence of its header that says where it comes from.
#[must_use]
pub fn file(plan: &FormulationPlan<'_>, origin: &str) -> String {
    let (model, equations) = (plan.planner.model, plan.planner.equations);
    let fields = fields(model);
    let functions = plan.functions.iter().map(|planned| function(planned, &fields));
    let state = model.coordinates.len() + model.speeds.len();
    let mut parts = vec![Part::LinearSystem, Part::WholeState(state)];
    parts.extend(plan.solved.then_some(Part::Eliminated));
    parts.extend(plan.taylor.as_ref().map(|plan| Part::Taylor(plan.width())));
    let system = system::system(model, equations, &parts);
    let series = plan.taylor.as_ref().map(taylor::imports);
    let taylor = plan.taylor.as_ref().map(|plan| taylor::function(plan, &fields));
    let first = format!(
        "{}: {}, {}.",
        prose(&model.title),
        prose(&equations.title(model)),
        equations.formulation.method().equation
    );
    format(
        &header(first, origin, &plan.facts),
        quote! {
            use super::Parameters;
            #series
            use tripos_traits::{Lengths, Scalar, System};
            #(#functions)*
            #taylor
            #system
        },
    )
}

/// The lines of a header: what it is, where it comes from, and what is known of it.
pub fn header(first: String, origin: &str, facts: &[String]) -> Vec<String> {
    let mut lines = vec![first, String::new(), origin.to_owned()];
    lines.extend(facts.iter().map(|fact| prose(fact)));
    lines
}
