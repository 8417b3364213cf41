//! The `mod.rs` of one model: its parameters, its names, its formulations.

use super::function::fields;
use super::text::{format, prose};
use crate::plan::{module_name, type_name};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use tripos_derive::Model;

/// Equations that a model's module lists.
pub struct Entry {
    /// Their name, such as `kane` or `printed:ID`.
    pub name: String,
    /// Whether their accelerations were solved for.
    pub solved: bool,
}

/// Emits `mod.rs` for these equations and scenes; `origin` is the sentence of its header that says where it comes from.
#[must_use]
pub fn file(
    model: &Model,
    folder: &str,
    origin: &str,
    report_hash: &str,
    equations: &[Entry],
    scenes: &[String],
) -> String {
    let header =
        vec![format!("{}.", prose(&model.title)), String::new(), origin.to_owned(), format!("{}.", model.count())];
    let modules = equations.iter().map(|entry| {
        let name = format_ident!("{}", module_name(&entry.name));
        quote!(#[rustfmt::skip] pub mod #name;)
    });
    let list_of = |list: Vec<&str>| {
        let count = Literal::usize_unsuffixed(list.len());
        (quote!([&str; #count]), quote!([#(#list),*]))
    };
    let structure = parameters(model);
    let (parameter_type, parameters) = list_of(model.parameters.iter().map(|p| p.name.as_str()).collect());
    let (coordinate_type, coordinates) = list_of(model.coordinates.iter().map(|c| c.name.as_str()).collect());
    let (speed_type, speeds) = list_of(model.speeds.iter().map(|s| s.name.as_str()).collect());
    let any_solved = equations.iter().any(|entry| entry.solved);
    let in_lanes = if any_solved { quote!(Derivative, InLanes,) } else { quote!() };
    let systems = equations.iter().map(|entry| {
        let name = &entry.name;
        let (module, unit) = (format_ident!("{}", module_name(name)), format_ident!("{}", type_name(name)));
        let system = quote!(&#module::#unit);
        let lanes = if entry.solved { quote!(Some(InLanes::of(&Derivative(#module::#unit)))) } else { quote!(None) };
        quote!(CompiledSystem { name: #name, double: #system, extended: #system, lanes: #lanes })
    });
    let own = format_ident!("scenes");
    let scene_module = (!scenes.is_empty()).then(|| quote!(#[rustfmt::skip] pub mod #own;));
    let scenes = if scenes.is_empty() { quote!(&[]) } else { quote!(scenes::SCENES) };
    let hash = model.text_hash();
    let items = quote! {
        #(#modules)*
        #scene_module

        use tripos_traits::{CompiledModel, CompiledSystem, #in_lanes Scalar};

        #structure

        #[doc = " Names of the parameters."]
        pub const PARAMETERS: #parameter_type = #parameters;
        #[doc = " Names of the generalized coordinates."]
        pub const COORDINATES: #coordinate_type = #coordinates;
        #[doc = " Names of the generalized speeds."]
        pub const SPEEDS: #speed_type = #speeds;

        #[doc = " What a program needs to find these equations and to trust them."]
        pub const MODEL: CompiledModel = CompiledModel {
            name: #folder,
            text_hash: #hash,
            report_hash: #report_hash,
            systems: &[#(#systems),*],
            scenes: #scenes,
        };
    };
    format(&header, items)
}

/// The struct of the parameters of a model.
pub fn parameters(model: &Model) -> TokenStream {
    let count = model.parameters.len();
    let names = fields(model);
    let fields = model.parameters.iter().zip(&names).map(|(p, name)| {
        let name = format_ident!("{name}");
        let about = if p.about.is_empty() { "parameter" } else { &p.about };
        let text = format!(" {}, {}", prose(about), p.unit);
        quote!(#[doc = #text] pub #name: S)
    });
    let from = names.iter().enumerate().map(|(at, name)| {
        let (name, at) = (format_ident!("{name}"), Literal::usize_unsuffixed(at));
        quote!(#name: p[#at])
    });
    let unused = if count == 0 { quote!(_p) } else { quote!(p) };
    let phantom = if count == 0 {
        quote!(#[doc = " A model without parameters."] pub none: core::marker::PhantomData<S>)
    } else {
        quote!()
    };
    let phantom_value = if count == 0 { quote!(none: core::marker::PhantomData) } else { quote!() };
    quote! {
        #[doc = " The parameters, in the order of the model file."]
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Parameters<S> {
            #(#fields,)*
            #phantom
        }

        impl<S: Scalar> Parameters<S> {
            #[doc = " From values in the order of [`PARAMETERS`]."]
            #[doc = ""]
            #[doc = " # Panics"]
            #[doc = " If `p` has fewer values than there are parameters."]
            #[must_use]
            #[inline(always)]
            pub fn from_slice(#unused: &[S]) -> Self {
                Self { #(#from,)* #phantom_value }
            }
        }
    }
}
