//! Functions of one model that are written already: what is equal byte for byte is written once.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use rustc_hash::FxHashMap;

/// The module of code where each text stands.
#[derive(Default)]
pub struct Written {
    places: FxHashMap<String, String>,
}

/// The functions of a module of code: those that stand there, and those that another has.
pub struct Sorted {
    /// The text of its own.
    pub own: Vec<TokenStream>,
    /// The names of others, by the module that has them.
    pub others: Vec<(String, Vec<&'static str>)>,
}

impl Written {
    /// Enters the functions of a module, by their names, as far as they are not there yet.
    pub fn sort(&mut self, module: &str, functions: impl IntoIterator<Item = (&'static str, TokenStream)>) -> Sorted {
        let mut sorted = Sorted { own: Vec::new(), others: Vec::new() };
        for (name, tokens) in functions {
            let there = self.places.entry(tokens.to_string()).or_insert_with(|| module.to_owned());
            if there == module {
                sorted.own.push(tokens);
                continue;
            }
            match sorted.others.iter_mut().find(|(known, _)| known == there) {
                Some((_, names)) => names.push(name),
                None => sorted.others.push((there.clone(), vec![name])),
            }
        }
        sorted
    }
}

impl Sorted {
    /// True if the module has the text of the function itself.
    pub fn has(&self, name: &str) -> bool {
        !self.others.iter().any(|(_, names)| names.contains(&name))
    }

    /// The imports of what others have.
    pub fn imports(&self) -> impl Iterator<Item = TokenStream> {
        self.others.iter().map(|(module, names)| reexport(&quote!(super), module, names.iter().copied()))
    }
}

/// `pub use` of these names of a module, in their order in the alphabet.
pub fn reexport<'n>(parent: &TokenStream, module: &str, names: impl IntoIterator<Item = &'n str>) -> TokenStream {
    let mut names: Vec<&str> = names.into_iter().collect();
    names.sort_unstable();
    let (module, names) = (format_ident!("{module}"), names.into_iter().map(|name| format_ident!("{name}")));
    quote!(pub use #parent::#module::{#(#names),*};)
}
