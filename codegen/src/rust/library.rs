//! The `lib.rs` of a workspace's generated code.

use super::text::format;
use quote::{format_ident, quote};

/// `lib.rs` for these models.
#[must_use]
pub fn library(models: &[String]) -> String {
    let header = [
        "Equations of motion, compiled: one module a model, one file a formulation.",
        "",
        "Generated from the files under `models/`. Do not edit; run `tripos regenerate`.",
        "A model that was edited since is run interpreted: compiled equations carry the hash of their text.",
    ];
    let modules = models.iter().map(|name| {
        let name = format_ident!("{name}");
        let about = format!(" The model `{name}`.");
        quote!(#[doc = #about] #[rustfmt::skip] pub mod #name;)
    });
    let entries = models.iter().map(|name| {
        let name = format_ident!("{name}");
        quote!(#name::MODEL)
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
