//! Text of the file `mod.rs` of a model's Rust module: parameters, names of coordinates and speeds,
//! and list of formulations.

use super::expression::constant;
use super::names::parameter_field_names;
use super::rust_text::{escape_doc_comment, format, format_to_include, rust_name_array};
use crate::plan::{module_name, type_name};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use tripos_derive::Model;

/// Largest number of operations of the accelerations for which they are compiled for eight SIMD lanes. Longer code is
/// compiled for four lanes.
const MOST_IN_EIGHT: usize = 500;

/// Set of equations that the Rust module of a model lists.
pub struct ModuleEquations {
    /// Name of the equations, such as `kane` or `printed:ID`.
    pub name: String,
    /// Title of the set of equations for headings.
    pub title: String,
    /// Number of operations of the accelerations; `None` if they have no closed form.
    pub solved: Option<usize>,
    /// True if the Taylor coefficients of several states can be computed at once, in SIMD lanes.
    pub series: bool,
    /// True if there is also a file of the equations for people, in addition to the code.
    pub shown: bool,
}

impl ModuleEquations {
    /// Returns the declaration of the Rust submodule that contains these equations.
    fn rust_module_declaration(&self) -> TokenStream {
        let (name, about) =
            (format_ident!("{}", module_name(&self.name)), format!(" {}.", escape_doc_comment(&self.title)));
        quote!(#[doc = #about] #[rustfmt::skip] pub mod #name;)
    }

    /// Returns the Rust expression of a `CompiledSystem`, by which a program runs these equations.
    fn compiled_system_expression(&self) -> TokenStream {
        let (module, unit) = (format_ident!("{}", module_name(&self.name)), format_ident!("{}", type_name(&self.name)));
        let (name, system) = (&self.name, quote!(code::#module::#unit));
        let lanes = match self.solved {
            None => quote!(None),
            Some(operations) => lanes_expression(&system, &quote!(of), operations, self.series),
        };
        quote!(CompiledSystem { name: #name, double: &#system, extended: &#system, lanes: #lanes })
    }
}

/// Returns the Rust expression of the equations `system` in SIMD lanes. Code of up to [`MOST_IN_EIGHT`] operations is
/// wrapped by the function `short` of `InLanes`, longer code in four lanes.
pub fn lanes_expression(system: &TokenStream, short: &TokenStream, operations: usize, series: bool) -> TokenStream {
    let series = series.then(|| quote!(.with_series(&Derivative(#system))));
    let wrapped = if operations <= MOST_IN_EIGHT { short.clone() } else { quote!(of_four) };
    quote!(Some(InLanes::#wrapped(&Derivative(#system)) #series))
}

/// Data on a model's Rust module, for its header and its constant `MODEL`.
pub struct ModuleHeaderData<'a> {
    /// Name of the model's Rust module.
    pub module: &'a str,
    /// Sentence of the header on the origin of the module.
    pub origin: &'a str,
    /// Hash of the publication in the model's folder. Empty if there is no publication or if its equations were not
    /// written.
    pub publication_hash: &'a str,
    /// True if the module also contains reduced equations of scenes.
    pub has_scenes: bool,
}

/// Returns the texts of two files of a model: its `mod.rs`, and the `mod.rs` of the folder `code`. `equations` lists
/// all sets of equations.
#[must_use]
pub fn rust_module_files(model: &Model, about: &ModuleHeaderData<'_>, equations: &[ModuleEquations]) -> [String; 2] {
    [module_file(model, about, equations), code_file(model, about, equations)]
}

/// Returns the text of the file `mod.rs` of a model's Rust module.
fn module_file(model: &Model, about: &ModuleHeaderData<'_>, equations: &[ModuleEquations]) -> String {
    let header = [
        format!("{}.", escape_doc_comment(&model.title)),
        String::new(),
        about.origin.to_owned(),
        format!("{}.", model.counts_in_words()),
    ];
    let read = equations.iter().filter(|entry| entry.shown);
    let modules = read.map(ModuleEquations::rust_module_declaration);
    let (structure, defaults) = (rust_parameter_struct(model), rust_default_impl(model));
    let (parameter_type, parameters) = rust_name_array(model.parameters.iter().map(|p| p.name.as_str()));
    let (coordinate_type, coordinates) = rust_name_array(model.coordinates.iter().map(|c| c.name.as_str()));
    let (speed_type, speeds) = rust_name_array(model.speeds.iter().map(|s| s.name.as_str()));
    let in_lanes = equations.iter().any(|entry| entry.solved.is_some()).then(|| quote!(Derivative, InLanes,));
    let systems = equations.iter().map(ModuleEquations::compiled_system_expression);
    let code = rust_code_module_declaration();
    let scene_module = about.has_scenes.then(|| {
        quote! {
            #[doc = " The equations of its scenes."]
            #[rustfmt::skip]
            pub mod scenes;
        }
    });
    let scenes = if about.has_scenes { quote!(scenes::SCENES) } else { quote!(&[]) };
    let (name, hash, publication_hash) = (about.module, model.text_hash(), about.publication_hash);
    let items = quote! {
        #(#modules)*
        #code

        #scene_module

        use tripos_traits::{CompiledModel, CompiledSystem, #in_lanes Scalar};

        #structure
        #defaults

        #[doc = " Names of the parameters."]
        pub const PARAMETERS: #parameter_type = #parameters;
        #[doc = " Names of the generalized coordinates."]
        pub const COORDINATES: #coordinate_type = #coordinates;
        #[doc = " Names of the generalized speeds."]
        pub const SPEEDS: #speed_type = #speeds;

        #[doc = " What a program needs to find these equations and to trust them."]
        pub const MODEL: CompiledModel = CompiledModel {
            name: #name,
            text_hash: #hash,
            publication_hash: #publication_hash,
            systems: &[#(#systems),*],
            scenes: #scenes,
        };
    };
    format_to_include(&header, items)
}

/// Returns the declaration of the Rust module `code`. It switches off the lints against names that are not in snake
/// case and against a final `let`.
pub fn rust_code_module_declaration() -> TokenStream {
    quote! {
        #[doc = " The code of the equations."]
        #[rustfmt::skip]
        #[allow(non_snake_case, clippy::let_and_return)]
        pub mod code;
    }
}

/// Returns the text of the `mod.rs` in the folder `code`.
fn code_file(model: &Model, about: &ModuleHeaderData<'_>, equations: &[ModuleEquations]) -> String {
    let title = format!("{}: the code of the equations.", escape_doc_comment(&model.title));
    let modules = equations.iter().map(ModuleEquations::rust_module_declaration);
    format(&[title, String::new(), about.origin.to_owned()], quote!(#(#modules)*))
}

/// Returns the Rust implementation of `Default` with the parameter values of the model file. `None` if a parameter
/// has no value.
fn rust_default_impl(model: &Model) -> Option<TokenStream> {
    let values: Option<Vec<_>> = model.parameters.iter().map(|p| p.value.as_ref().map(constant)).collect();
    let names = parameter_field_names(model);
    let values = values?.into_iter().zip(&names).map(|(value, name)| {
        let name = format_ident!("{name}");
        quote!(#name: #value)
    });
    let none = model.parameters.is_empty().then(|| quote!(none: core::marker::PhantomData));
    Some(quote! {
        #[doc = " The values that the model file states."]
        impl<S: Scalar> Default for Parameters<S> {
            fn default() -> Self {
                Self { #(#values,)* #none }
            }
        }
    })
}

/// Returns the Rust declaration of the struct `Parameters` of a model, with conversions from a
/// slice and to an array.
pub fn rust_parameter_struct(model: &Model) -> TokenStream {
    let count = model.parameters.len();
    let names = parameter_field_names(model);
    let fields = model.parameters.iter().zip(&names).map(|(p, name)| {
        let name = format_ident!("{name}");
        let about = if p.about.is_empty() { "parameter" } else { &p.about };
        let text = format!(" {}, {}", escape_doc_comment(about), p.unit);
        quote!(#[doc = #text] pub #name: S)
    });
    let from = names.iter().enumerate().map(|(at, name)| {
        let (name, at) = (format_ident!("{name}"), Literal::usize_unsuffixed(at));
        quote!(#name: p[#at])
    });
    let list: Vec<_> = names.iter().map(|name| format_ident!("{name}")).collect();
    let length = Literal::usize_unsuffixed(count);
    let unused = if count == 0 { quote!(_p) } else { quote!(p) };
    let phantom = if count == 0 {
        quote!(#[doc = " A model without parameters."] pub none: core::marker::PhantomData<S>)
    } else {
        quote!()
    };
    let phantom_value = if count == 0 { quote!(none: core::marker::PhantomData) } else { quote!() };
    quote! {
        #[doc = " The parameters, in the order of the model file."]
        #[allow(non_snake_case)]
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

            #[doc = " The values, in the order of [`PARAMETERS`]."]
            #[must_use]
            #[inline]
            pub fn to_array(self) -> [S; #length] {
                let Self { #(#list,)* .. } = self;
                [#(#list),*]
            }
        }
    }
}
