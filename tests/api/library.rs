//! The modules of a crate, and the places at which other crates reach its items.
//!
//! An item is listed once: where it is defined if that place can be reached, and else at the first of its re-exports.
//! The other places are `pub use`. Items that macros make are not seen.

use super::signatures;
use crate::crate_files::{Names, is_test, joined, leaves, modules};
use quote::ToTokens;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use syn::{Attribute, Item, Visibility};

/// Imports of imports that are followed before a search gives up.
const DEEPEST: usize = 16;

/// Source of a crate, with its modules written inside files too.
pub struct Library {
    name: String,
    modules: BTreeMap<Names, Vec<Item>>,
}

/// Target of a path inside the crate.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Place {
    Module(Names),
    /// Module and name of an item.
    Item(Names, String),
}

/// Public places of a crate: for each item the paths at which it can be reached, and the lines that need no item.
#[derive(Default)]
struct Reached {
    items: BTreeMap<Place, BTreeSet<Names>>,
    lines: Vec<String>,
    /// Modules and paths that were walked, because globs may lead back.
    walked: BTreeSet<(Names, Names)>,
}

impl Library {
    /// Reads the crate `name` from its root file.
    pub fn read(name: &str, root: &Path) -> Self {
        let mut library = Self { name: name.to_owned(), modules: BTreeMap::new() };
        for (at, tree) in modules(root) {
            library.enter(at, tree.items);
        }
        library
    }

    fn enter(&mut self, at: Names, items: Vec<Item>) {
        let kept: Vec<Item> = items.into_iter().filter(|item| !is_test(attributes(item))).collect();
        for item in &kept {
            if let Item::Mod(child) = item
                && let Some((_, items)) = &child.content
            {
                self.enter(joined(&at, &child.ident.to_string()), items.clone());
            }
        }
        self.modules.insert(at, kept);
    }

    /// Everything public, one signature a line, sorted by path.
    pub fn listing(&self) -> Vec<String> {
        let mut reached = Reached::default();
        self.walk(&[], &[], &mut reached);
        let mut lines = std::mem::take(&mut reached.lines);
        let mut main_paths = BTreeMap::new();
        for (place, paths) in &reached.items {
            let Place::Item(module, name) = place else { continue };
            let own = joined(module, name);
            let main = if paths.contains(&own) { own } else { paths.first().cloned().unwrap_or_default() };
            for path in paths.iter().filter(|path| **path != main) {
                lines.push(format!("{}: pub use {}", self.path(path), self.path(&main)));
            }
            lines.extend(self.signatures(module, name, &main));
            main_paths.insert(place.clone(), main);
        }
        lines.extend(self.implementations(&main_paths));
        lines.sort();
        lines.dedup();
        lines
    }

    fn path(&self, names: &[String]) -> String {
        [std::slice::from_ref(&self.name), names].concat().join("::")
    }

    /// Enters the public items of a module that can be reached at `path`.
    fn walk(&self, module: &[String], path: &[String], reached: &mut Reached) {
        if !reached.walked.insert((module.to_vec(), path.to_vec())) {
            return;
        }
        for item in self.modules.get(module).into_iter().flatten().filter(|item| is_public(item)) {
            match item {
                Item::Use(import) => self.walk_import(module, path, &import.tree, reached),
                Item::Mod(child) => {
                    let name = child.ident.to_string();
                    let conditions = signatures::conditions(&child.attrs);
                    reached.lines.push(format!("{}: {conditions}pub mod {name}", self.path(&joined(path, &name))));
                    self.walk(&joined(module, &name), &joined(path, &name), reached);
                }
                _ => {
                    if let Some(name) = name_of(item) {
                        let place = Place::Item(module.to_vec(), name.clone());
                        reached.items.entry(place).or_default().insert(joined(path, &name));
                    }
                }
            }
        }
    }

    fn walk_import(&self, module: &[String], path: &[String], tree: &syn::UseTree, reached: &mut Reached) {
        for (name, target) in leaves(tree) {
            let (at, place) = (joined(path, &name), self.resolve(module, &target, 0));
            match place {
                Some(Place::Module(target)) if name == "*" => self.walk(&target, path, reached),
                Some(Place::Module(target)) => {
                    reached.lines.push(format!("{}: pub mod {name}", self.path(&at)));
                    self.walk(&target, &at, reached);
                }
                Some(place) => {
                    reached.items.entry(place).or_default().insert(at);
                }
                None => reached.lines.push(format!("{}: pub use {}", self.path(&at), target.join("::"))),
            }
        }
    }

    /// Target of a path that stands in `module`; `None` if it leads out of the crate.
    pub fn resolve(&self, module: &[String], path: &[String], depth: usize) -> Option<Place> {
        let Some((first, rest)) = path.split_first().filter(|_| depth < DEEPEST) else {
            return self.modules.contains_key(module).then(|| Place::Module(module.to_vec()));
        };
        match first.as_str() {
            "crate" => return self.resolve(&[], rest, depth + 1),
            "self" => return self.resolve(module, rest, depth + 1),
            "super" => return self.resolve(module.split_last()?.1, rest, depth + 1),
            _ => {}
        }
        let items = self.modules.get(module)?;
        if rest.is_empty() && items.iter().any(|item| name_of(item).is_some_and(|name| name == *first)) {
            return Some(Place::Item(module.to_vec(), first.clone()));
        }
        let child = joined(module, first);
        if self.modules.contains_key(&child) {
            return self.resolve(&child, rest, depth + 1);
        }
        let imports =
            items.iter().filter_map(|item| if let Item::Use(import) = item { Some(&import.tree) } else { None });
        imports.flat_map(leaves).find_map(|(name, target)| {
            let further = match name.as_str() {
                "*" => path,
                name if name == first => rest,
                _ => return None,
            };
            self.resolve(module, &[&target[..], further].concat(), depth + 1)
        })
    }

    /// Lines of an item and of the fields, variants or functions that it declares.
    fn signatures(&self, module: &[String], name: &str, path: &[String]) -> Vec<String> {
        let items = self.modules[module].iter().filter(|item| name_of(item).is_some_and(|found| found == *name));
        let shown = path.last().map_or(name, String::as_str);
        let lines = items.flat_map(|item| signatures::of_item(item, shown));
        lines.map(|(inner, line)| self.line(path, inner, &line)).collect()
    }

    fn line(&self, path: &[String], inner: Option<String>, line: &str) -> String {
        let path = inner.map_or_else(|| path.to_vec(), |inner| joined(path, &inner));
        format!("{}: {line}", self.path(&path))
    }

    /// Lines of all implementations for items, or of traits, that have a public path.
    fn implementations(&self, main_paths: &BTreeMap<Place, Names>) -> Vec<String> {
        let mut lines = Vec::new();
        let all = self.modules.iter().flat_map(|(module, items)| items.iter().map(move |item| (module, item)));
        for (module, item) in all {
            let Item::Impl(item) = item else { continue };
            let main_path = |path: &syn::Path| {
                let names: Names = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
                main_paths.get(&self.resolve(module, &names, 0)?)
            };
            let of_type = signatures::path_of(&item.self_ty).and_then(&main_path);
            let of_trait = item.trait_.as_ref().map(|(path, _)| main_path(path));
            let Some(path) = of_type.or(of_trait.flatten()) else { continue };
            let found = signatures::of_implementation(item);
            lines.extend(found.into_iter().map(|(inner, line)| self.line(path, inner, &line)));
        }
        lines
    }
}

/// Attributes of an item of one of the kinds that a crate can export.
fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(i) => &i.attrs,
        Item::Enum(i) => &i.attrs,
        Item::Fn(i) => &i.attrs,
        Item::Impl(i) => &i.attrs,
        Item::Macro(i) => &i.attrs,
        Item::Mod(i) => &i.attrs,
        Item::Static(i) => &i.attrs,
        Item::Struct(i) => &i.attrs,
        Item::Trait(i) => &i.attrs,
        Item::Type(i) => &i.attrs,
        Item::Use(i) => &i.attrs,
        _ => &[],
    }
}

/// Name of an item that is neither a module nor an import.
fn name_of(item: &Item) -> Option<String> {
    let name = match item {
        Item::Const(i) => &i.ident,
        Item::Enum(i) => &i.ident,
        Item::Fn(i) => &i.sig.ident,
        Item::Static(i) => &i.ident,
        Item::Struct(i) => &i.ident,
        Item::Trait(i) => &i.ident,
        Item::Type(i) => &i.ident,
        _ => return None,
    };
    Some(name.to_string())
}

/// True if an item is `pub` and not hidden from the documentation.
fn is_public(item: &Item) -> bool {
    let visibility = match item {
        Item::Const(i) => &i.vis,
        Item::Enum(i) => &i.vis,
        Item::Fn(i) => &i.vis,
        Item::Mod(i) => &i.vis,
        Item::Static(i) => &i.vis,
        Item::Struct(i) => &i.vis,
        Item::Trait(i) => &i.vis,
        Item::Type(i) => &i.vis,
        Item::Use(i) => &i.vis,
        _ => return false,
    };
    let is_hidden = attributes(item).iter().any(|a| a.to_token_stream().to_string().contains("hidden"));
    matches!(visibility, Visibility::Public(_)) && !is_hidden
}
