//! The reduced equations of one scene as a Rust file.

use crate::formulation::{Solved, derivative, eliminated, kinematics_and_energies};
use crate::function::{Arguments, Function, Returns, Value, Writer};
use crate::identifiers::{Variables, module_name, spelled, type_name};
use crate::module::parameters;
use crate::system::{self, Part};
use crate::taylor;
use crate::tokens::{Cost, format, prose};
use proc_macro2::Literal;
use quote::{format_ident, quote};
use tripos_derive::Model;
use tripos_derive::algebra::linear::Singular;
use tripos_derive::algebra::print::text;
use tripos_derive::algebra::simplify::Simplifier;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{DeriveError, accelerations, energy_gradient as energy_gradient_of};
use tripos_derive::reduce::{Quantity, Reduction, Slope};
use tripos_derive::{Equations, Formulation, derive};

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
    let usable = syn::parse_str::<syn::Ident>(&stem).is_ok() && stem != "_" && stem != "gen";
    let stem = if usable { stem } else { format!("scene_{stem}") };
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
    let mut arena = reduction.terms().clone();
    let equations = &reduction.derivation.equations;
    let solved = Solved::new(&mut arena, equations)?;
    let gradient = energy_gradient_of(&mut arena, &mut Simplifier::default(), equations);
    let writer = writer(&reduction.model, &arena, equations);
    let mut functions = eliminated(&writer, &solved);
    functions.extend(kinematics_and_energies(&writer));
    functions.push(outputs(&writer, reduction));
    if reduction.has_energy {
        functions.push(energy_gradient(&writer, &gradient));
    }
    if let Some(slope) = &reduction.slope {
        functions.extend(potential_slope(&writer, slope));
    }
    let (name, header) = (named.name, header(reduction, named, &functions));
    let recurrences = solved.recurrences.as_ref();
    functions.extend(recurrences.map(|list| taylor::function::taylor(&writer, list)));
    let functions = functions.into_iter().map(|f| f.tokens);
    let parts: Vec<Part> = [Part::Outputs(reduction.outputs.len()), Part::Eliminated]
        .into_iter()
        .chain(reduction.has_energy.then_some(Part::EnergyGradient))
        .chain(reduction.slope.as_ref().map(|_| Part::PotentialSlope))
        .chain(recurrences.map(|list| Part::Taylor(taylor::function::width(list))))
        .collect();
    let system = system::system(&reduction.model, equations, &parts);
    let series = recurrences.map(taylor::function::imports);
    let parameters = parameters(&reduction.model);
    let names = |list: Vec<&str>| {
        let count = Literal::usize_unsuffixed(list.len());
        (quote!([&str; #count]), quote!([#(#list),*]))
    };
    let (parameter_type, parameter_names) = names(reduction.model.parameters.iter().map(|p| p.name.as_str()).collect());
    let (output_type, output_names) = names(reduction.outputs.iter().map(|o| o.name.as_str()).collect());
    let text = format(
        &header,
        quote! {
            #series
            use tripos_traits::{CompiledScene, CompiledSystem, Lengths, Scalar, System};

            #parameters

            #[doc = " Names of the parameters: those that stay free, then what the start of a motion fixes."]
            pub const PARAMETERS: #parameter_type = #parameter_names;
            #[doc = " Names of the outputs."]
            pub const OUTPUTS: #output_type = #output_names;

            #(#functions)*
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

fn writer<'a>(model: &'a Model, arena: &'a Arena, equations: &'a Equations) -> Writer<'a> {
    let variables = Variables::new(arena, &type_name(&equations.name));
    Writer { model, arena, equations, variables, shares: true }
}

fn outputs(writer: &Writer<'_>, reduction: &Reduction) -> Function {
    let values: Vec<Value> = reduction
        .outputs
        .iter()
        .enumerate()
        .map(|(at, o)| {
            let word = o.name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '\'');
            let wanted = if word { format!("{}_value", spelled(&o.name)) } else { format!("output{}", at + 1) };
            (wanted, o.name.clone(), o.value)
        })
        .collect();
    let about = "What the scene asks for, a time t after the start.";
    let arguments = Arguments::Shown { time: reduction.time };
    let definitions = &writer.equations.definitions;
    writer.stepwise("outputs", about, arguments, Returns::Vector, definitions, &values)
}

/// T + V, then its slopes.
fn energy_gradient(writer: &Writer<'_>, gradient: &[Expr]) -> Function {
    let e = writer.equations;
    let mut arena = writer.arena.clone();
    let energy = arena.add(e.kinetic_energy, e.potential_energy);
    let writer = Writer { arena: &arena, variables: writer.variables.clone(), ..*writer };
    let mut values: Vec<Value> = vec![("energy".to_owned(), "T + V".to_owned(), energy)];
    for (symbol, slope) in e.coordinates.iter().chain(&e.variables).zip(gradient) {
        let name = writer.arena.symbol_name(*symbol).unwrap_or_default();
        values.push((format!("energy_by_{}", spelled(name)), format!("d(T + V)/d({name})"), *slope));
    }
    let about = "The energy, then its derivatives by the state.";
    writer.stepwise("energy_gradient", about, Arguments::State, Returns::Vector, &e.definitions, &values)
}

/// The slope of the potential energy between two places `q`, as it stands: what would be gained by rewriting it would bring
/// back the differences that it avoids. `u` holds sin z/z of the angles z that the other function gives.
fn potential_slope(writer: &Writer<'_>, slope: &Slope) -> Vec<Function> {
    let (symbols, angles): (Vec<Expr>, Vec<Expr>) = slope.sincs.iter().copied().unzip();
    let equations = Equations {
        coordinates: slope.ends.to_vec(),
        variables: symbols,
        definitions: Vec::new(),
        ..writer.equations.clone()
    };
    let writer = Writer { equations: &equations, variables: writer.variables.clone(), shares: false, ..*writer };
    let name = |at: usize| (format!("z{}", at + 1), format!("z{}", at + 1), angles[at]);
    let values: Vec<Value> = (0..angles.len()).map(name).collect();
    let value = [("slope".to_owned(), "(V(b) - V(a))/(b - a)".to_owned(), slope.value)];
    vec![
        writer.function(
            "half_differences",
            "The angles z whose sin z/z the slope of the potential needs.",
            Arguments::Configuration,
            Returns::Vector,
            &values,
        ),
        writer.function(
            "potential_slope",
            "The slope of the potential energy between two places `q`, without cancellation; `u` holds sin z/z.",
            Arguments::State,
            Returns::Number,
            &value,
        ),
    ]
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

fn header(reduction: &Reduction, named: &Named<'_>, functions: &[Function]) -> Vec<String> {
    let arena = reduction.terms();
    let names = |list: &[Quantity]| match list {
        [] => "none".to_owned(),
        list => list.iter().map(|q| q.name.clone()).collect::<Vec<_>>().join(", "),
    };
    let shown: Vec<&str> = reduction.outputs.iter().map(|o| o.name.as_str()).collect();
    let mut lines = vec![
        first_line(reduction, named),
        String::new(),
        named.origin.to_owned(),
        format!("Outputs: {}.", prose(&shown.join(", "))),
        format!("States: {}. Quadratures: {}.", names(&reduction.states), names(&reduction.quadratures)),
    ];
    for constant in &reduction.constants {
        lines.push(format!("{} = {}: {}.", constant.name, text(arena, constant.of_start), prose(&constant.about)));
    }
    let folded: Vec<String> =
        reduction.folded.iter().map(|(name, value)| format!("{name} = {}", value.to_f64())).collect();
    if !folded.is_empty() {
        lines.push(format!("Parameters that the scene fixes: {}.", folded.join(", ")));
    }
    let costs: Vec<String> = functions.iter().take(2).map(|f| format!("{} {}", f.name, f.cost)).collect();
    lines.push(format!("Cost: {}.", costs.join("; ")));
    let divisors: Vec<String> = reduction.divisors.iter().map(|d| format!("{} = 0", text(arena, *d))).collect();
    lines.push(match divisors.as_slice() {
        [] => "Singular nowhere.".to_owned(),
        list => format!("Singular where {}.", list.join(" and where ")),
    });
    lines
}

/// What one call of the derivative of the state costs: of all equations by Kane's method, and of a scene's own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Costs {
    /// Of the whole model.
    pub full: Cost,
    /// Of the scene.
    pub scene: Cost,
}

/// Counts operations as generated code has them.
///
/// # Errors
/// [`DeriveError`] if Kane's equations cannot be had, or accelerations are determined in no configuration.
pub fn costs(model: &Model, reduction: &Reduction) -> Result<Costs, DeriveError> {
    let of = |model: &Model, arena: &Arena, equations: &Equations| {
        let mut arena = arena.clone();
        let solved =
            accelerations(&mut arena, &mut Simplifier::default(), equations).map_err(|_| DeriveError::NotLinear)?;
        Ok(derivative(&writer(model, &arena, equations), &solved.steps).cost)
    };
    let kane = derive(model, Formulation::Kane)?;
    let full = of(model, &kane.arena, &kane.equations)?;
    let scene = of(&reduction.model, reduction.terms(), &reduction.derivation.equations)?;
    Ok(Costs { full, scene })
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
