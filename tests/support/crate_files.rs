//! The source files of a crate as syntax trees, for tests that read the crate's own text.

use std::collections::BTreeMap;
use std::path::Path;

/// Path of a name: modules from the root of the crate, then the name.
pub type Names = Vec<String>;

/// A path, longer by one name.
pub fn joined(names: &[String], name: &str) -> Names {
    [names, &[name.to_owned()]].concat()
}

/// True if an item belongs to the tests of its crate.
pub fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|a| a.path().is_ident("cfg") && a.parse_args::<syn::Path>().is_ok_and(|p| p.is_ident("test")))
}

/// Syntax trees of the modules of a crate that are files, by their path from its root; test modules are left out.
pub fn modules(root: &Path) -> BTreeMap<Names, syn::File> {
    let mut all = BTreeMap::new();
    read(root, Names::new(), root.parent().unwrap(), &mut all);
    all
}

/// Reads a file as the module `at`; its children are in `folder`.
fn read(file: &Path, at: Names, folder: &Path, all: &mut BTreeMap<Names, syn::File>) {
    let text = std::fs::read_to_string(file).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    let tree = syn::parse_file(&text).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    for item in &tree.items {
        if let syn::Item::Mod(child) = item
            && child.content.is_none()
            && !is_test(&child.attrs)
        {
            let name = child.ident.to_string();
            let inside = folder.join(&name);
            let beside = folder.join(format!("{name}.rs"));
            let path = if beside.exists() { beside } else { inside.join("mod.rs") };
            read(&path, joined(&at, &name), &inside, all);
        }
    }
    all.insert(at, tree);
}

/// The leaves of a tree of imports: the name in this module, and the path. A glob has the name `*`.
pub fn leaves(tree: &syn::UseTree) -> Vec<(String, Names)> {
    let mut found = Vec::new();
    collect(tree, &mut Names::new(), &mut found);
    found
}

fn collect(tree: &syn::UseTree, before: &mut Names, leaves: &mut Vec<(String, Names)>) {
    match tree {
        syn::UseTree::Path(path) => {
            before.push(path.ident.to_string());
            collect(&path.tree, before, leaves);
            before.pop();
        }
        syn::UseTree::Group(group) => group.items.iter().for_each(|tree| collect(tree, before, leaves)),
        syn::UseTree::Glob(_) => leaves.push(("*".to_owned(), before.clone())),
        syn::UseTree::Name(name) if name.ident == "self" => {
            leaves.push((before.last().cloned().unwrap_or_default(), before.clone()));
        }
        syn::UseTree::Name(name) => leaves.push((name.ident.to_string(), joined(before, &name.ident.to_string()))),
        syn::UseTree::Rename(name) => leaves.push((name.rename.to_string(), joined(before, &name.ident.to_string()))),
    }
}
