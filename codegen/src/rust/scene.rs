//! Rust files for the reduced equations of one scene: a file of equations for people, and a file of code.

use super::jacobian_product::{JACOBIAN_PRODUCT, Rates, jacobian_product};
use super::module::{lanes_expression, rust_code_module_declaration, rust_parameter_struct};
use super::names::{LANGUAGE, is_name, parameter_field_names};
use super::rust_function::{Parameters, function, function_at_points, function_documentation};
use super::rust_target::has_short_series;
use super::rust_text::{escape_doc_comment, format, reexport, rust_file_header, rust_name_array};
use super::system_methods::{self, SystemMethods};
use super::taylor::{self, TaylorText};
use crate::optional_functions::Extras;
use crate::plan::{Jacobian, SceneEquations, ScenePlan, Taylor, TaylorPlan, module_name};
use quote::{format_ident, quote};
use tripos_derive::Model;
use tripos_derive::mechanics::Unsolved;
use tripos_derive::reduce::Reduction;

/// Texts of the Rust files of one scene, with the module's name and the key of its equations.
pub struct SceneFile {
    /// Name of the scene's Rust module.
    pub module: String,
    /// Key of the scene's equations. Scenes with equal keys have equal equations.
    pub key: String,
    /// Text of the file of equations for people.
    pub text: String,
    /// Text of the file of code. `None` if an earlier scene has equal equations, so that its code is used.
    pub code: Option<String>,
}

/// Name, title and origin of a scene, for the header of its Rust file.
pub struct SceneHeaderData<'a> {
    /// Name of the scene's file, without its extension.
    pub name: &'a str,
    /// Title of the scene; empty if it has none.
    pub title: &'a str,
    /// Sentence of the header on the origin of the file.
    pub origin: &'a str,
}

/// Writes the Rust files of a scene of the model `whole`, such as `report_10s.rs`. If an earlier scene in `before`
/// has equal equations, the new file refers to that scene's code.
///
/// # Errors
/// Returns [`Unsolved`] if the accelerations are not determined in any configuration, or are not proved.
pub fn rust_scene_file(
    whole: &Model,
    reduction: &Reduction,
    named: &SceneHeaderData<'_>,
    extras: Extras,
    before: &[SceneFile],
) -> Result<SceneFile, Unsolved> {
    let (module, key) = (rust_scene_module_name(named.name, before), reduction.reduction_hash());
    let (text, code) = match before.iter().find(|file| file.key == key) {
        Some(same) => (rust_scene_reference(reduction, named, &same.module), None),
        None => {
            let (text, code) = rust_scene_texts(whole, reduction, named, extras, &module, &key)?;
            (text, Some(code))
        }
    };
    Ok(SceneFile { module, key, text, code })
}

/// Returns a module name for a scene that no earlier scene in `before` has, such as `scene_10s` for `10s`.
fn rust_scene_module_name(name: &str, before: &[SceneFile]) -> String {
    let stem = module_name(name);
    let stem = if is_name(&stem) { stem } else { format!("scene_{stem}") };
    let taken = |candidate: &String| candidate == "code" || before.iter().any(|file| file.module == *candidate);
    let candidates = std::iter::once(stem.clone()).chain((2..).map(|n| format!("{stem}_{n}")));
    candidates.into_iter().find(|candidate| !taken(candidate)).unwrap_or(stem)
}

/// Returns the text of a scene's file that contains no equations and only refers to the module `same`. That module
/// belongs to a scene with equal equations.
fn rust_scene_reference(reduction: &Reduction, named: &SceneHeaderData<'_>, same: &str) -> String {
    let header = vec![
        rust_scene_header_line(reduction, named),
        String::new(),
        named.origin.to_owned(),
        format!("It asks for what `{same}` asks for, with the same parameters, and has its equations."),
    ];
    let (name, same) = (named.name, format_ident!("{same}"));
    format(
        &header,
        quote! {
            pub use super::#same::*;

            #[doc = " What a program needs to find these equations and to trust them."]
            pub const SCENE: tripos_traits::CompiledScene = tripos_traits::CompiledScene { name: #name, ..super::#same::SCENE };
        },
    )
}

/// Returns the first line of the header: the titles of the model and of the scene.
fn rust_scene_header_line(reduction: &Reduction, named: &SceneHeaderData<'_>) -> String {
    let title = if named.title.is_empty() { named.name } else { named.title };
    format!("{}: {}.", escape_doc_comment(&reduction.model.title), escape_doc_comment(title))
}

/// Returns the two texts of a scene whose equations no earlier scene has: equations for people, and code. `Err` if
/// the accelerations are not determined, or are not proved.
fn rust_scene_texts(
    whole: &Model,
    reduction: &Reduction,
    named: &SceneHeaderData<'_>,
    extras: Extras,
    module: &str,
    key: &str,
) -> Result<(String, String), Unsolved> {
    let equations = SceneEquations::new(reduction)?;
    let planner = equations.planner(&LANGUAGE);
    let entries = if extras.jacobian { Jacobian::Planned } else { Jacobian::LeftOut };
    let taylor = if extras.taylor { Taylor::Planned } else { Taylor::LeftOut };
    let plan = ScenePlan::new(whole, &planner, &equations, entries, taylor);
    Ok((equations_file(&plan, named, module), code_file(whole, &plan, named, key)))
}

/// Returns the text of a scene's file of equations for people.
fn equations_file(plan: &ScenePlan<'_>, named: &SceneHeaderData<'_>, module: &str) -> String {
    let shown = plan.from_start.iter().chain(&plan.equations).map(|planned| {
        let (docs, module, name) =
            (function_documentation(planned), format_ident!("{module}"), format_ident!("{}", planned.name));
        quote!(#docs #[doc(inline)] pub use super::code::#module::#name;)
    });
    let machine = plan.machine.iter().map(|planned| planned.name).chain(plan.taylor.as_ref().map(|_| "taylor"));
    let machine = machine.chain(lacks_jacobian(plan).then_some(JACOBIAN_PRODUCT));
    let names = machine.chain(["OUTPUTS", "PARAMETERS", "Parameters", "Reduced", "SCENE"]);
    let rest = reexport(&quote!(super::code), module, names);
    format(
        &rust_file_header(rust_scene_header_line(plan.reduction, named), named.origin, &plan.facts),
        quote!(#rest #(#shown)*),
    )
}

/// True if the plan has no function `jacobian`, because that function would be long. A run then computes the Jacobian
/// by differentiating the code as it runs.
fn lacks_jacobian(plan: &ScenePlan<'_>) -> bool {
    !plan.machine.iter().any(|planned| planned.name == "jacobian")
}

/// Returns the text of a scene's file of code.
fn code_file(whole: &Model, plan: &ScenePlan<'_>, named: &SceneHeaderData<'_>, key: &str) -> String {
    let (model, reduction) = (&plan.reduction.model, plan.reduction);
    let of_whole = Parameters { path: quote!(super::super::super::Parameters), fields: parameter_field_names(whole) };
    let from_start = plan.from_start.iter().map(|planned| function(planned, &of_whole));
    let own = Parameters::of(model);
    let write = if reduction.slope.is_some() { function_at_points } else { function };
    let functions = plan.equations.iter().chain(&plan.machine).map(|planned| write(planned, &own));
    let product = lacks_jacobian(plan);
    let differentiated = product.then(|| jacobian_product(&reduction.derivation.equations, Rates::Together));
    let at_points = reduction.slope.as_ref().map(|_| quote!(AtPoints,));
    let has_series =
        |taylor: &TaylorPlan<'_>| has_short_series(taylor.list.convolutions(), &reduction.derivation.equations);
    let operations =
        plan.machine.iter().find(|planned| planned.name == "derivative").map(|planned| planned.cost.operations);
    let lanes = lanes_expression(
        &quote!(Reduced),
        &quote!(of_rates),
        operations.unwrap_or(usize::MAX),
        plan.taylor.as_ref().is_some_and(has_series),
    );
    let (dual, by_columns) = (product.then(|| quote!(Dual,)), product.then(|| quote!(, by_columns)));
    let mut parts =
        vec![SystemMethods::Outputs(reduction.outputs.len()), SystemMethods::Eliminated { product, together: true }];
    parts.extend(reduction.has_energy.then_some(SystemMethods::EnergyGradient));
    parts.extend(reduction.slope.as_ref().map(|slope| SystemMethods::PotentialSlope(slope.turns.clone())));
    parts.extend(plan.taylor.as_ref().map(|plan| SystemMethods::Taylor(plan.width())));
    parts.extend((!plan.divisors.is_empty()).then(|| SystemMethods::Divisors(plan.divisors.clone())));
    let system = system_methods::system(model, &reduction.derivation.equations, &parts);
    let series = plan.taylor.as_ref().map(|plan| taylor::imports(plan, TaylorText::Here));
    let taylor = plan.taylor.as_ref().map(|plan| taylor::function(plan, &own));
    let structure = rust_parameter_struct(model);
    let (parameter_type, parameter_names) = rust_name_array(model.parameters.iter().map(|p| p.name.as_str()));
    let (output_type, output_names) = rust_name_array(reduction.outputs.iter().map(|o| o.name.as_str()));
    let name = named.name;
    format(
        &rust_file_header(rust_scene_header_line(reduction, named), named.origin, &[]),
        quote! {
            #series
            use tripos_traits::{#at_points CompiledScene, CompiledSystem, Derivative, #dual InLanes, Lengths, Scalar, System #by_columns};

            #structure

            #[doc = " Names of the parameters: those that stay free, then what the start of a motion fixes."]
            pub const PARAMETERS: #parameter_type = #parameter_names;
            #[doc = " Names of the outputs."]
            pub const OUTPUTS: #output_type = #output_names;

            #(#from_start)*
            #(#functions)*
            #taylor
            #differentiated
            #system

            #[doc = " What a program needs to find these equations and to trust them."]
            pub const SCENE: CompiledScene = CompiledScene {
                name: #name,
                key: #key,
                system: CompiledSystem { name: "reduced", double: &Reduced, extended: &Reduced, lanes: #lanes },
            };
        },
    )
}

/// Returns the texts of the `mod.rs` that lists a model's scenes, and of the `mod.rs` of their code.
#[must_use]
pub fn rust_scene_module_files(title: &str, origin: &str, files: &[SceneFile]) -> [String; 2] {
    let header = |what: &str| vec![format!("{}: {what}.", escape_doc_comment(title)), String::new(), origin.to_owned()];
    let modules: Vec<_> = files.iter().map(|file| format_ident!("{}", file.module)).collect();
    let code = files.iter().filter(|file| file.code.is_some()).map(|file| format_ident!("{}", file.module));
    let code_module = rust_code_module_declaration();
    let scenes = format(
        &header("the equations of its scenes"),
        quote! {
            #code_module
            #(#[rustfmt::skip] pub mod #modules;)*

            #[doc = " The equations of every scene."]
            pub const SCENES: &[tripos_traits::CompiledScene] = &[#(#modules::SCENE),*];
        },
    );
    let of_code = header("the code of the equations of its scenes");
    [scenes, format(&of_code, quote!(#(#[rustfmt::skip] pub mod #code;)*))]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Goal: a scene may have any name. Method: names that are no module names, and different names that give the
    /// same module name.
    #[test]
    fn every_scene_has_a_module_of_its_own() {
        let mut files: Vec<SceneFile> = Vec::new();
        for name in ["report-10s", "report_10s", "10s", "loop", "mod", "my run", "-"] {
            let module = rust_scene_module_name(name, &files);
            assert!(syn::parse_str::<syn::Ident>(&module).is_ok(), "{name} gives {module}");
            files.push(SceneFile { module, key: String::new(), text: String::new(), code: None });
        }
        let modules: Vec<&str> = files.iter().map(|file| file.module.as_str()).collect();
        assert_eq!(modules, ["report_10s", "report_10s_2", "scene_10s", "scene_loop", "scene_mod", "my_run", "scene_"]);
    }
}
