//! Text of `lib.rs` in the generated package of a workspace.

use super::rust_text::format;
use quote::{format_ident, quote};

/// Returns the text of `lib.rs` for the modules of the given models.
#[must_use]
pub fn generated_library_text(models: &[String]) -> String {
    let header = [
        "Equations of motion, compiled: one module a model, one file a formulation.",
        "",
        "Generated from the files under `models/`. Do not edit; run `tripos regenerate`.",
        "`build.rs` says which are compiled: those whose features are on, and those that have none. A model that is not, or that",
        "was edited since, is run interpreted: compiled equations carry the hash of their text.",
    ];
    let modules = models.iter().map(|model| {
        let (name, about) = (format_ident!("{model}"), format!(" The model `{model}`."));
        quote!(#[cfg(compiled = #model)] #[doc = #about] #[rustfmt::skip] pub mod #name;)
    });
    let entries = models.iter().map(|model| {
        let name = format_ident!("{model}");
        quote!(#[cfg(compiled = #model)] #name::MODEL)
    });
    let items = quote! {
        #![no_std]
        #![allow(clippy::pedantic)]

        #(#modules)*

        #[doc = " Every compiled model, by name."]
        #[rustfmt::skip]
        pub static MODELS: &[tripos_traits::CompiledModel] = &[#(#entries),*];
    };
    format(&header.map(str::to_owned), items)
}
