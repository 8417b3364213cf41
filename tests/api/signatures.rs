//! Signatures of items as text, without bodies and documentation.

use quote::ToTokens;
use syn::{Attribute, Fields, ImplItem, Item, TraitItem, Type, Visibility};

/// Signature, with the name of the field, variant or function inside the item that it belongs to.
pub type Line = (Option<String>, String);

/// Text of a syntax tree with the spaces that people write.
pub fn text(tree: &impl ToTokens) -> String {
    const SPACES: [(&str, &str); 26] = [
        (" :: ", "::"),
        (":: ", "::"),
        (" < ", "<"),
        ("< ", "<"),
        (" >", ">"),
        ("& ", "&"),
        (" , ", ", "),
        (" ,", ","),
        (" ; ", "; "),
        (" ( ", "("),
        ("( ", "("),
        (" (", "("),
        (" )", ")"),
        ("[ ", "["),
        (" ]", "]"),
        (" : ", ": "),
        ("- >", "->"),
        ("->(", "-> ("),
        (")->", ") ->"),
        (",(", ", ("),
        (":(", ": ("),
        ("=(", "= ("),
        ("! ", "!"),
        ("? ", "?"),
        ("mut(", "mut ("),
        (",)", ")"),
    ];
    let mut text = tree.to_token_stream().to_string().replace('\n', " ");
    for (from, to) in SPACES {
        text = text.replace(from, to);
    }
    text
}

/// Conditions and marks that other crates see: features and `non_exhaustive`.
pub fn conditions(attributes: &[Attribute]) -> String {
    let shown = attributes.iter().filter(|a| a.path().is_ident("cfg") || a.path().is_ident("non_exhaustive"));
    shown.map(|a| text(a).replace("# [", "#[") + " ").collect()
}

/// Lines of an item that is shown with this name, and of its public parts.
pub fn of_item(item: &Item, name: &str) -> Vec<Line> {
    match item {
        Item::Const(i) => whole(&i.attrs, &format!("pub const {name}: {}", text(&i.ty))),
        Item::Static(i) => whole(&i.attrs, &format!("pub static {name}: {}", text(&i.ty))),
        Item::Type(i) => whole(&i.attrs, &format!("pub type {name}{} = {}", text(&i.generics), text(&i.ty))),
        Item::Fn(i) => whole(&i.attrs, &format!("pub {}", signature(&i.sig, name))),
        Item::Struct(i) => {
            let mut lines = whole(&i.attrs, &of_struct(i, name));
            lines.extend(i.fields.iter().filter(|field| is_public(&field.vis)).filter_map(|field| {
                let name = field.ident.as_ref()?.to_string();
                let line = format!("{}pub {name}: {}", conditions(&field.attrs), text(&field.ty));
                Some((Some(name), line))
            }));
            lines.extend(derived(&i.attrs));
            lines
        }
        Item::Enum(i) => {
            let head = format!("pub enum {name}{}{}", text(&i.generics), text(&i.generics.where_clause));
            let mut lines = whole(&i.attrs, &head);
            lines.extend(i.variants.iter().map(|variant| {
                let name = variant.ident.to_string();
                let line = format!("{}{name}{}", conditions(&variant.attrs), of_variant(&variant.fields));
                (Some(name), line)
            }));
            lines.extend(derived(&i.attrs));
            lines
        }
        Item::Trait(i) => of_trait(i, name),
        _ => Vec::new(),
    }
}

fn whole(attributes: &[Attribute], text: &str) -> Vec<Line> {
    vec![(None, conditions(attributes) + text)]
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

fn signature(signature: &syn::Signature, name: &str) -> String {
    let own = format!("fn {}", signature.ident);
    text(signature).replacen(&own, &format!("fn {name}"), 1)
}

/// First line of a structure. Two dots stand for fields that nobody can name.
fn of_struct(item: &syn::ItemStruct, name: &str) -> String {
    let head = format!("pub struct {name}{}", text(&item.generics));
    let places = |fields: &syn::FieldsUnnamed| {
        let shown =
            |field: &syn::Field| if is_public(&field.vis) { format!("pub {}", text(&field.ty)) } else { "_".into() };
        fields.unnamed.iter().map(shown).collect::<Vec<_>>().join(", ")
    };
    let body = match &item.fields {
        Fields::Named(fields) if fields.named.iter().all(|field| is_public(&field.vis)) => String::new(),
        Fields::Named(_) => " { .. }".to_owned(),
        Fields::Unnamed(fields) => format!("({})", places(fields)),
        Fields::Unit => ";".to_owned(),
    };
    head + &body + &text(&item.generics.where_clause)
}

fn of_variant(fields: &Fields) -> String {
    let of = |field: &syn::Field| {
        let name = field.ident.as_ref().map_or(String::new(), |name| format!("{name}: "));
        name + &text(&field.ty)
    };
    let all = fields.iter().map(of).collect::<Vec<_>>().join(", ");
    match fields {
        Fields::Named(_) => format!(" {{ {all} }}"),
        Fields::Unnamed(_) => format!("({all})"),
        Fields::Unit => String::new(),
    }
}

fn of_trait(item: &syn::ItemTrait, name: &str) -> Vec<Line> {
    let bounds = if item.supertraits.is_empty() { String::new() } else { format!(": {}", text(&item.supertraits)) };
    let head = format!("pub trait {name}{}{bounds}{}", text(&item.generics), text(&item.generics.where_clause));
    let mut lines = whole(&item.attrs, &head);
    lines.extend(item.items.iter().filter_map(|item| match item {
        TraitItem::Fn(i) => {
            // A function with a body need not be implemented.
            let given = if i.default.is_some() { " { .. }" } else { "" };
            Some((Some(i.sig.ident.to_string()), format!("{}{given}", text(&i.sig))))
        }
        TraitItem::Const(i) => Some((Some(i.ident.to_string()), shortened(&text(i)))),
        TraitItem::Type(i) => Some((Some(i.ident.to_string()), shortened(&text(i)))),
        _ => None,
    }));
    lines
}

/// Declaration without its documentation and its last semicolon.
fn shortened(text: &str) -> String {
    let start = ["const ", "type "].iter().filter_map(|word| text.rfind(&format!(" {word}")).map(|at| at + 1)).max();
    text[start.unwrap_or(0)..].trim_end_matches([' ', ';']).to_owned()
}

/// Traits that an item derives.
fn derived(attributes: &[Attribute]) -> Vec<Line> {
    let lists = attributes.iter().filter(|a| a.path().is_ident("derive"));
    let names = lists.flat_map(|a| {
        let mut names = Vec::new();
        let _ = a.parse_nested_meta(|meta| {
            names.push(text(&meta.path));
            Ok(())
        });
        names
    });
    names.map(|name| (None, format!("impl {name}"))).collect()
}

/// Path of the type that an implementation is for; `None` for slices, tuples and the like.
pub fn path_of(item: &Type) -> Option<&syn::Path> {
    match item {
        Type::Path(path) => Some(&path.path),
        Type::Reference(reference) => path_of(&reference.elem),
        _ => None,
    }
}

/// Line of an implementation of a trait, or lines of the public functions and constants of one without a trait.
pub fn of_implementation(item: &syn::ItemImpl) -> Vec<Line> {
    if let Some((path, _)) = &item.trait_ {
        let generics = text(&item.generics);
        return whole(&item.attrs, &format!("impl{generics} {} for {}", text(path), text(&item.self_ty)));
    }
    let conditions_of_all = conditions(&item.attrs);
    let lines = item.items.iter().filter_map(|item| match item {
        ImplItem::Fn(i) if is_public(&i.vis) => {
            Some((Some(i.sig.ident.to_string()), format!("{}pub {}", conditions(&i.attrs), text(&i.sig))))
        }
        ImplItem::Const(i) if is_public(&i.vis) => {
            let line = format!("{}pub const {}: {}", conditions(&i.attrs), i.ident, text(&i.ty));
            Some((Some(i.ident.to_string()), line))
        }
        _ => None,
    });
    lines.map(|(name, line)| (name, format!("{conditions_of_all}{line}"))).collect()
}
