//! Record of the functions already written for a model, so that functions with equal text are
//! written only once.

use super::rust_text::reexport;
use proc_macro2::TokenStream;
use quote::quote;
use rustc_hash::FxHashMap;

/// Record of the functions already written for a model, from which later modules import functions.
#[derive(Default)]
pub struct WrittenFunctions {
    /// Name of the code module that contains each function, by the function's text.
    places: FxHashMap<String, String>,
}

/// Functions of one code module: those that it contains, and those that it imports.
pub struct SortedFunctions {
    /// Texts of the functions that the module contains itself.
    pub own: Vec<TokenStream>,
    /// Names of the functions that the module imports, by the module that contains them.
    pub others: Vec<(String, Vec<&'static str>)>,
}

impl WrittenFunctions {
    /// Sorts the functions of a module into new functions, and functions that an earlier module already contains. New
    /// functions are recorded.
    pub fn sort(
        &mut self,
        module: &str,
        functions: impl IntoIterator<Item = (&'static str, TokenStream)>,
    ) -> SortedFunctions {
        let mut sorted = SortedFunctions { own: Vec::new(), others: Vec::new() };
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

impl SortedFunctions {
    /// True if the module itself contains the function `name`, so that it is not imported.
    pub fn has(&self, name: &str) -> bool {
        !self.others.iter().any(|(_, names)| names.contains(&name))
    }

    /// Returns the import items for the functions that other modules contain.
    pub fn imports(&self) -> impl Iterator<Item = TokenStream> {
        self.others.iter().map(|(module, names)| reexport(&quote!(super), module, names.iter().copied()))
    }
}
