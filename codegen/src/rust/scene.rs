//! The reduced equations of one scene as a Rust file.

use super::formulation::header;
use super::function::{fields, function};
use super::module::parameters;
use super::names::{LANGUAGE, is_name};
use super::system::{self, Part};
use super::taylor;
use super::text::{format, prose};
use crate::plan::{SceneEquations, ScenePlan, module_name};
use proc_macro2::Literal;
use quote::{format_ident, quote};
use tripos_derive::algebra::linear::Singular;
use tripos_derive::reduce::Reduction;

/// A scene's file.
pub struct SceneFile {
    /// Its module.
    pub module: String,
    /// The key of its equations.
    pub key: String,
    /// Its text.
    pub text: String,
}

/// What a scene's file is called by.
pub struct Named<'a> {
    /// The name of the scene's file, without its ending.
    pub name: &'a str,
    /// Its title, or nothing.
    pub title: &'a str,
    /// The sentence of the header that says where the text comes from.
    pub origin: &'a str,
}

/// Emits the file of a scene, such as `report_10s.rs`, beside those that are there. Where one of them has the same equations, the
/// file refers to it.
///
/// # Errors
/// [`Singular`] if the accelerations are determined in no configuration.
pub fn file(reduction: &Reduction, named: &Named<'_>, before: &[SceneFile]) -> Result<SceneFile, Singular> {
    let (module, key) = (module_of(named.name, before), reduction.key());
    let text = match before.iter().find(|file| file.key == key) {
        Some(same) => reference(reduction, named, &same.module),
        None => equations_of(reduction, named, &key)?,
    };
    Ok(SceneFile { module, key, text })
}

/// A module name for a scene of any name, such as `scene_10s` for `10s`, that none of these has yet.
fn module_of(name: &str, before: &[SceneFile]) -> String {
    let stem = module_name(name);
    let stem = if is_name(&stem) { stem } else { format!("scene_{stem}") };
    let taken = |candidate: &String| before.iter().any(|file| file.module == *candidate);
    let candidates = std::iter::once(stem.clone()).chain((2..).map(|n| format!("{stem}_{n}")));
    candidates.into_iter().find(|candidate| !taken(candidate)).unwrap_or(stem)
}

/// The file of a scene whose equations another one has.
fn reference(reduction: &Reduction, named: &Named<'_>, same: &str) -> String {
    let header = vec![
        first_line(reduction, named),
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

fn first_line(reduction: &Reduction, named: &Named<'_>) -> String {
    let title = if named.title.is_empty() { named.name } else { named.title };
    format!("{}: {}.", prose(&reduction.model.title), prose(title))
}

/// The file of a scene with equations of its own.
fn equations_of(reduction: &Reduction, named: &Named<'_>, key: &str) -> Result<String, Singular> {
    let (model, equations) = (&reduction.model, SceneEquations::new(reduction)?);
    let planner = equations.planner(&LANGUAGE);
    let plan = ScenePlan::new(&planner, &equations);
    let fields = fields(model);
    let functions = plan.functions.iter().map(|planned| function(planned, &fields));
    let mut parts = vec![Part::Outputs(reduction.outputs.len()), Part::Eliminated];
    parts.extend(reduction.has_energy.then_some(Part::EnergyGradient));
    parts.extend(reduction.slope.as_ref().map(|_| Part::PotentialSlope));
    parts.extend(plan.taylor.as_ref().map(|plan| Part::Taylor(plan.width())));
    let system = system::system(model, &reduction.derivation.equations, &parts);
    let series = plan.taylor.as_ref().map(taylor::imports);
    let taylor = plan.taylor.as_ref().map(|plan| taylor::function(plan, &fields));
    let parameters = parameters(model);
    let names = |list: Vec<&str>| {
        let count = Literal::usize_unsuffixed(list.len());
        (quote!([&str; #count]), quote!([#(#list),*]))
    };
    let (parameter_type, parameter_names) = names(model.parameters.iter().map(|p| p.name.as_str()).collect());
    let (output_type, output_names) = names(reduction.outputs.iter().map(|o| o.name.as_str()).collect());
    let name = named.name;
    let text = format(
        &header(first_line(reduction, named), named.origin, &plan.facts),
        quote! {
            #series
            use tripos_traits::{CompiledScene, CompiledSystem, Lengths, Scalar, System};

            #parameters

            #[doc = " Names of the parameters: those that stay free, then what the start of a motion fixes."]
            pub const PARAMETERS: #parameter_type = #parameter_names;
            #[doc = " Names of the outputs."]
            pub const OUTPUTS: #output_type = #output_names;

            #(#functions)*
            #taylor
            #system

            #[doc = " What a program needs to find these equations and to trust them."]
            pub const SCENE: CompiledScene = CompiledScene {
                name: #name,
                key: #key,
                system: CompiledSystem { name: "reduced", double: &Reduced, extended: &Reduced, lanes: None },
            };
        },
    );
    Ok(text)
}

/// The `mod.rs` of the scenes of a model.
#[must_use]
pub fn list(title: &str, origin: &str, modules: &[String]) -> String {
    let header = vec![format!("{}: the equations of its scenes.", prose(title)), String::new(), origin.to_owned()];
    let modules: Vec<_> = modules.iter().map(|name| format_ident!("{name}")).collect();
    format(
        &header,
        quote! {
            #(#[rustfmt::skip] pub mod #modules;)*

            #[doc = " The equations of every scene."]
            pub const SCENES: &[tripos_traits::CompiledScene] = &[#(#modules::SCENE),*];
        },
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Goal: a scene may be called as its author likes. Method: names that are no modules, and names that give the same one.
    #[test]
    fn every_scene_has_a_module_of_its_own() {
        let mut files: Vec<SceneFile> = Vec::new();
        for name in ["report-10s", "report_10s", "10s", "loop", "mod", "my run", "-"] {
            let module = module_of(name, &files);
            assert!(syn::parse_str::<syn::Ident>(&module).is_ok(), "{name} gives {module}");
            files.push(SceneFile { module, key: String::new(), text: String::new() });
        }
        let modules: Vec<&str> = files.iter().map(|file| file.module.as_str()).collect();
        assert_eq!(modules, ["report_10s", "report_10s_2", "scene_10s", "scene_loop", "scene_mod", "my_run", "scene_"]);
    }
}
