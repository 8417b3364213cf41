//! Public interface of each library crate, as a list of signatures: a change of it is a change of a snapshot.
//!
//! An item counts if a path of public modules or re-exports leads to it from the root of its crate. It is listed under
//! that path, with its signature, public fields, variants, and public methods.

use crate::sympy::root;
use quote::ToTokens;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use syn::{Attribute, Fields, ImplItem, Item, ItemImpl, TraitItem, UseTree, Visibility};

/// Path of a module or an item from the root of its crate.
type Names = Vec<String>;

/// Modules of a crate with their items, by path.
#[derive(Default)]
struct Modules(BTreeMap<Names, Vec<Item>>);

impl Modules {
    /// Reads a file as the module `at`, with the modules below it, which are in `folder`.
    fn read(&mut self, file: &Path, at: &Names, folder: &Path) {
        let text = std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        let tree = syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        self.insert(tree.items, at, folder);
    }

    fn insert(&mut self, items: Vec<Item>, at: &Names, folder: &Path) {
        for item in &items {
            let Item::Mod(child) = item else { continue };
            if is_test(&child.attrs) {
                continue;
            }
            let name = child.ident.to_string();
            let (path, inside) = ([at.as_slice(), std::slice::from_ref(&name)].concat(), folder.join(&name));
            let beside = folder.join(format!("{name}.rs"));
            match &child.content {
                Some((_, items)) => self.insert(items.clone(), &path, &inside),
                None if beside.exists() => self.read(&beside, &path, &inside),
                None => self.read(&inside.join("mod.rs"), &path, &inside),
            }
        }
        self.0.insert(at.clone(), items);
    }

    /// Lists the public items of a module, and of the public modules in it, under the path `shown`.
    fn list(&self, at: &Names, shown: &str, open: &mut BTreeSet<Names>, lines: &mut BTreeSet<String>) {
        let Some(items) = self.0.get(at) else { return };
        if !open.insert(at.clone()) {
            return;
        }
        for item in items.iter().filter(|item| !is_test(attributes(item))) {
            match item {
                Item::Mod(child) if is_public(&child.vis) => {
                    let name = child.ident.to_string();
                    let path = [at.as_slice(), std::slice::from_ref(&name)].concat();
                    self.list(&path, &format!("{shown}{name}::"), open, lines);
                }
                Item::Use(used) if is_public(&used.vis) => {
                    self.follow(&used.tree, at, &mut Vec::new(), shown, open, lines);
                }
                item => self.show(item, None, shown, lines),
            }
        }
        open.remove(at);
    }

    /// Lists the items to which a re-export in the module `at` leads. `path` is the path up to `tree`.
    fn follow(
        &self,
        tree: &UseTree,
        at: &Names,
        path: &mut Names,
        shown: &str,
        open: &mut BTreeSet<Names>,
        lines: &mut BTreeSet<String>,
    ) {
        match tree {
            UseTree::Path(part) => {
                path.push(part.ident.to_string());
                self.follow(&part.tree, at, path, shown, open, lines);
                path.pop();
            }
            UseTree::Group(group) => {
                group.items.iter().for_each(|tree| self.follow(tree, at, path, shown, open, lines));
            }
            UseTree::Glob(_) => self.list(&self.place(at, path), shown, open, lines),
            UseTree::Name(name) => self.take(&name.ident.to_string(), None, at, path, shown, open, lines),
            UseTree::Rename(new) => {
                let alias = new.rename.to_string();
                self.take(&new.ident.to_string(), Some(&alias), at, path, shown, open, lines);
            }
        }
    }

    /// Path of a module that a path in the module `at` means.
    fn place(&self, at: &Names, path: &[String]) -> Names {
        match path.split_first() {
            Some((first, rest)) if first == "crate" => rest.to_vec(),
            Some((first, rest)) if first == "self" => [at.as_slice(), rest].concat(),
            Some((first, rest)) if first == "super" => self.place(&at[..at.len().saturating_sub(1)].to_vec(), rest),
            _ => {
                let inside = [at.as_slice(), path].concat();
                if self.0.contains_key(&inside) { inside } else { path.to_vec() }
            }
        }
    }

    /// Lists the item `name` of the module that a path means; an item of another crate by its path alone.
    #[expect(clippy::too_many_arguments, reason = "the arguments of `follow`, with a name")]
    fn take(
        &self,
        name: &str,
        alias: Option<&str>,
        at: &Names,
        path: &[String],
        shown: &str,
        open: &mut BTreeSet<Names>,
        lines: &mut BTreeSet<String>,
    ) {
        let place = self.place(at, path);
        let module = [place.as_slice(), &[name.to_owned()]].concat();
        if self.0.contains_key(&module) {
            self.list(&module, &format!("{shown}{}::", alias.unwrap_or(name)), open, lines);
        }
        let items = self.0.get(&place).map_or(&[][..], Vec::as_slice);
        let mut is_found = self.0.contains_key(&module);
        for item in items {
            match item {
                Item::Use(used) => {
                    // An item may be re-exported several times on its way.
                    if let Some(path) = leading_to(&used.tree, name, &mut Vec::new()) {
                        is_found = true;
                        let (last, before) = path.split_last().expect("a path has a name");
                        self.take(last, alias.or(Some(name)), &place, before, shown, open, lines);
                    }
                }
                item if named(item).is_some_and(|own| own == name) => {
                    is_found = true;
                    self.show(item, alias, shown, lines);
                }
                _ => {}
            }
        }
        if !is_found {
            lines.insert(format!("{shown}{} = {}::{name}", alias.unwrap_or(name), path.join("::")));
        }
    }

    /// Lists an item if it is public, with its public methods.
    fn show(&self, item: &Item, alias: Option<&str>, shown: &str, lines: &mut BTreeSet<String>) {
        let Some(name) = named(item) else { return };
        let full = format!("{shown}{}", alias.unwrap_or(&name));
        let mut add = |text: String| lines.insert(format!("{full}{text}"));
        let is_type = match item {
            Item::Fn(f) if is_public(&f.vis) => {
                add(format!(": {}", text(&f.sig)));
                false
            }
            Item::Const(c) if is_public(&c.vis) => {
                add(format!(": const {}", text(&c.ty)));
                false
            }
            Item::Static(c) if is_public(&c.vis) => {
                add(format!(": static {}", text(&c.ty)));
                false
            }
            Item::Type(t) if is_public(&t.vis) => {
                add(format!(": type{} = {}", text(&t.generics), text(&t.ty)));
                false
            }
            Item::Struct(s) if is_public(&s.vis) => {
                add(format!(": struct{}", text(&s.generics)));
                for (at, field) in s.fields.iter().enumerate().filter(|(_, field)| is_public(&field.vis)) {
                    let name = field.ident.as_ref().map_or_else(|| at.to_string(), ToString::to_string);
                    add(format!(".{name}: {}", text(&field.ty)));
                }
                true
            }
            Item::Enum(e) if is_public(&e.vis) => {
                add(format!(": enum{}", text(&e.generics)));
                for variant in &e.variants {
                    add(format!("::{}{}", variant.ident, fields(&variant.fields)));
                }
                true
            }
            Item::Trait(t) if is_public(&t.vis) => {
                add(format!(": trait{}: {}", text(&t.generics), text(&t.supertraits)));
                for item in &t.items {
                    match item {
                        TraitItem::Fn(f) => add(format!("::{}", text(&f.sig))),
                        TraitItem::Const(c) => add(format!("::{}: const {}", c.ident, text(&c.ty))),
                        TraitItem::Type(t) => add(format!("::type {}", t.ident)),
                        _ => false,
                    };
                }
                false
            }
            _ => return,
        };
        if is_type {
            let own = self.0.values().flatten().filter_map(|item| match item {
                Item::Impl(block) if block.trait_.is_none() && is_for(block, &name) => Some(block),
                _ => None,
            });
            for item in own.flat_map(|block| &block.items) {
                match item {
                    ImplItem::Fn(f) if is_public(&f.vis) => lines.insert(format!("{full}::{}", text(&f.sig))),
                    ImplItem::Const(c) if is_public(&c.vis) => {
                        lines.insert(format!("{full}::{}: const {}", c.ident, text(&c.ty)))
                    }
                    _ => false,
                };
            }
        }
    }
}

/// Path in a re-export that gives an item this name; `None` if none does.
fn leading_to(tree: &UseTree, name: &str, path: &mut Names) -> Option<Names> {
    match tree {
        UseTree::Path(part) => {
            path.push(part.ident.to_string());
            let found = leading_to(&part.tree, name, path);
            path.pop();
            found
        }
        UseTree::Group(group) => group.items.iter().find_map(|tree| leading_to(tree, name, path)),
        UseTree::Name(own) if own.ident == name => Some([path.as_slice(), &[own.ident.to_string()]].concat()),
        UseTree::Rename(own) if own.rename == name => Some([path.as_slice(), &[own.ident.to_string()]].concat()),
        UseTree::Name(_) | UseTree::Rename(_) | UseTree::Glob(_) => None,
    }
}

/// True if a block has the methods of the type with this name.
fn is_for(block: &ItemImpl, name: &str) -> bool {
    matches!(&*block.self_ty, syn::Type::Path(path) if path.path.segments.last().is_some_and(|s| s.ident == name))
}

fn named(item: &Item) -> Option<String> {
    let ident = match item {
        Item::Fn(f) => &f.sig.ident,
        Item::Const(c) => &c.ident,
        Item::Static(c) => &c.ident,
        Item::Type(t) => &t.ident,
        Item::Struct(s) => &s.ident,
        Item::Enum(e) => &e.ident,
        Item::Trait(t) => &t.ident,
        _ => return None,
    };
    Some(ident.to_string())
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Fn(f) => &f.attrs,
        Item::Mod(m) => &m.attrs,
        Item::Use(u) => &u.attrs,
        Item::Impl(i) => &i.attrs,
        _ => &[],
    }
}

fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|a| a.path().is_ident("cfg") && a.parse_args::<syn::Path>().is_ok_and(|p| p.is_ident("test")))
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

/// Fields of a variant in one line.
fn fields(fields: &Fields) -> String {
    let list = |name: &dyn Fn(&syn::Field) -> String| fields.iter().map(name).collect::<Vec<_>>().join(", ");
    match fields {
        Fields::Unit => String::new(),
        Fields::Unnamed(_) => format!("({})", list(&|field| text(&field.ty))),
        Fields::Named(_) => {
            let name = |field: &syn::Field| field.ident.as_ref().map(ToString::to_string).unwrap_or_default();
            format!(" {{ {} }}", list(&|field| format!("{}: {}", name(field), text(&field.ty))))
        }
    }
}

/// Text of a part of a signature in one line, with few spaces.
fn text(part: &impl ToTokens) -> String {
    let mut stream = part.to_token_stream().to_string().replace('\n', " ");
    for (loose, close) in [
        (" :: ", "::"),
        (":: ", "::"),
        (" ::", "::"),
        (" < ", "<"),
        (" <", "<"),
        ("< ", "<"),
        (" >", ">"),
        ("- >", "->"),
        ("& ", "&"),
        (" (", "("),
        ("( ", "("),
        (" )", ")"),
        ("[ ", "["),
        (" ]", "]"),
        (" ,", ","),
        (" :", ":"),
        (" ;", ";"),
        (" ! ", "!"),
    ] {
        while stream.contains(loose) {
            stream = stream.replace(loose, close);
        }
    }
    while stream.contains("  ") {
        stream = stream.replace("  ", " ");
    }
    stream.replace(",)", ")").replace(", >", ">").replace("->(", "-> (").trim().to_owned()
}

/// Goal: nobody changes what users of a crate call without seeing it. Method: the list of the public items of each
/// library crate against the one that was looked at last.
#[test]
fn public_interfaces_are_those_that_were_looked_at() {
    for (name, file, least) in [
        ("derive", "derive/src/lib.rs", 1000),
        ("codegen", "codegen/src/lib.rs", 150),
        ("sim", "sim/src/lib.rs", 150),
        ("traits", "sim/traits/src/lib.rs", 50),
        ("run", "run/src/lib.rs", 150),
    ] {
        let file = root().join(file);
        let mut modules = Modules::default();
        modules.read(&file, &Vec::new(), file.parent().unwrap());
        let mut lines = BTreeSet::new();
        modules.list(&Vec::new(), "", &mut BTreeSet::new(), &mut lines);
        assert!(lines.len() > least, "{name} has {} public items", lines.len());
        let listing = lines.into_iter().map(|line| line + "\n").collect::<String>();
        expect_test::expect_file![root().join(format!("tests/api/{name}.txt"))].assert_eq(&listing);
    }
}
