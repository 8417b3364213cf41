//! No circles of files: whoever changes a file can read what it stands on from the bottom up.
//!
//! A file uses another if a path in it, an import or one written out, ends at an item that is defined there; re-exports
//! are followed to the definition. Tests are left out, and so is what shows in no path: methods, and macros.

use crate::crate_files::{Names, is_test, leaves, modules};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use syn::visit::{self, Visit};

/// Items, imports and paths of a file.
#[derive(Default)]
struct Module {
    /// Names of what it defines.
    items: BTreeSet<String>,
    /// Names that it imports, and what they stand for.
    imports: Vec<(String, Names)>,
    /// Paths that its code writes out.
    paths: Vec<Names>,
}

/// The modules of a crate, by their path from its root.
#[derive(Default)]
struct Crate(BTreeMap<Names, Module>);

impl Crate {
    fn read(root: &Path) -> Self {
        let visited = modules(root).into_iter().map(|(at, tree)| {
            let mut module = Module::default();
            module.visit_file(&tree);
            (at, module)
        });
        Self(visited.collect())
    }

    /// The module in which what a path from `module` leads to is defined.
    fn definition(&self, module: &[String], path: &[String], depth: usize) -> Option<Names> {
        let (mut here, mut rest) = (module.to_vec(), path);
        while let Some(first) = rest.first() {
            match first.as_str() {
                "crate" => here.clear(),
                "self" => {}
                "super" => drop(here.pop()?),
                _ => break,
            }
            rest = &rest[1..];
        }
        let Some((name, further)) = rest.split_first() else { return self.0.contains_key(&here).then_some(here) };
        let child = [&here[..], std::slice::from_ref(name)].concat();
        if self.0.contains_key(&child) {
            return if further.is_empty() { Some(child) } else { self.definition(&child, further, depth) };
        }
        let found = self.0.get(&here)?;
        if found.items.contains(name) {
            return Some(here);
        }
        // Imports of imports end; a name that stands for itself would not.
        let (_, target) = found.imports.iter().find(|(import, _)| import == name).filter(|_| depth < 8)?;
        self.definition(&here, &[target, further].concat(), depth + 1)
    }

    /// In each folder, which of the modules side by side use which. A module and what is inside it are one here: a
    /// folder's own file hands out what its children define, and they use the nouns of their folder.
    fn arrows(&self) -> BTreeMap<Names, Arrows> {
        let mut folders: BTreeMap<Names, Arrows> = BTreeMap::new();
        for (at, module) in &self.0 {
            let imports = module.imports.iter().map(|(_, path)| path);
            for to in imports.chain(&module.paths).filter_map(|path| self.definition(at, path, 0)) {
                let common = at.iter().zip(&to).take_while(|(a, b)| a == b).count();
                if let (Some(from), Some(to)) = (at.get(common), to.get(common)) {
                    let folder = folders.entry(at[..common].to_vec()).or_default();
                    folder.entry(from.clone()).or_default().insert(to.clone());
                }
            }
        }
        folders
    }
}

/// Modules that each module of a folder uses.
type Arrows = BTreeMap<String, BTreeSet<String>>;

impl<'a> Visit<'a> for Module {
    fn visit_item(&mut self, item: &'a syn::Item) {
        use syn::Item;
        let (attributes, name) = match item {
            Item::Const(i) => (&i.attrs, Some(&i.ident)),
            Item::Enum(i) => (&i.attrs, Some(&i.ident)),
            Item::Fn(i) => (&i.attrs, Some(&i.sig.ident)),
            Item::Mod(i) => (&i.attrs, None),
            Item::Static(i) => (&i.attrs, Some(&i.ident)),
            Item::Struct(i) => (&i.attrs, Some(&i.ident)),
            Item::Trait(i) => (&i.attrs, Some(&i.ident)),
            Item::Type(i) => (&i.attrs, Some(&i.ident)),
            Item::Impl(i) => (&i.attrs, None),
            Item::Use(i) => (&i.attrs, None),
            _ => return visit::visit_item(self, item),
        };
        if !is_test(attributes) {
            self.items.extend(name.map(ToString::to_string));
            visit::visit_item(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'a syn::ItemUse) {
        // What is only passed on is not used here.
        self.imports.extend(leaves(&item.tree));
    }

    fn visit_path(&mut self, path: &'a syn::Path) {
        let names: Names = path.segments.iter().map(|s| s.ident.to_string()).collect();
        if names.len() > 1 {
            self.paths.push(names);
        }
        visit::visit_path(self, path);
    }
}

/// Everything that can be reached from a module, itself only if it is on a circle.
fn reachable(from: &str, arrows: &Arrows) -> BTreeSet<String> {
    let (mut found, mut open) = (BTreeSet::new(), vec![from.to_owned()]);
    while let Some(module) = open.pop() {
        open.extend(arrows.get(&module).into_iter().flatten().filter(|next| found.insert((*next).clone())).cloned());
    }
    found
}

/// The circles of a crate: where, and the modules on them.
fn circles(root: &Path) -> BTreeSet<String> {
    let mut list = BTreeSet::new();
    for (folder, arrows) in Crate::read(root).arrows() {
        let reach: BTreeMap<&String, BTreeSet<String>> = arrows.keys().map(|m| (m, reachable(m, &arrows))).collect();
        for (module, to) in reach.iter().filter(|(module, to)| to.contains(**module)) {
            let circle: Vec<&str> =
                to.iter().filter(|m| reach.get(m).is_some_and(|r| r.contains(*module))).map(String::as_str).collect();
            list.insert(format!("{}: {}", folder.join("/"), circle.join(", ")));
        }
    }
    list
}

#[test]
fn no_files_use_one_another_in_a_circle() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let roots = [
        "derive/src/lib.rs",
        "codegen/src/lib.rs",
        "sim/traits/src/lib.rs",
        "sim/src/lib.rs",
        "run/src/lib.rs",
        "cli/src/lib.rs",
    ];
    let of = |of: &&str| circles(&root.join(of)).into_iter().map(|c| format!("{of}, {c}")).collect::<Vec<_>>();
    let found: Vec<String> = roots.iter().flat_map(of).collect();
    assert!(found.is_empty(), "circles of files:\n{}", found.join("\n"));
}

/// Goal: the scan sees what it is for. Method: a crate of three files, with an arrow through a re-export, with and
/// without the way back.
#[test]
fn a_circle_through_a_re_export_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("lib.rs", "mod a;\nmod b;\npub use b::B;\n");
    write("a.rs", "use crate::B;\npub struct A(B);\n");
    write("b.rs", "pub struct B;\n#[cfg(test)]\nmod tests { use crate::a::A; }\n");
    assert!(circles(&folder.path().join("lib.rs")).is_empty());
    write("b.rs", "pub struct B;\nfn back() { crate::a::A::new(); }\n");
    assert_eq!(circles(&folder.path().join("lib.rs")), BTreeSet::from([": a, b".to_owned()]));
}
