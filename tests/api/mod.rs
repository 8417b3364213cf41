//! The public items of each library crate, as snapshots: a change of what programs may call is seen in review.

mod library;
mod signatures;

use expect_test::expect_file;
use library::Library;
use std::path::Path;

/// Library crates, each with the folder of its sources.
const CRATES: [(&str, &str); 8] = [
    ("tripos-linear", "linear/src"),
    ("tripos-derive", "derive/src"),
    ("tripos-codegen", "codegen/src"),
    ("tripos-sim", "sim/src"),
    ("tripos-traits", "sim/traits/src"),
    ("tripos-robots", "robots/src"),
    ("tripos", "run/src"),
    ("tripos-cli", "cli/src"),
];

#[test]
fn the_public_items_of_each_crate_are_those_of_its_snapshot() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (name, folder) in CRATES {
        let library = Library::read(&name.replace('-', "_"), &root.join(folder).join("lib.rs"));
        let text: String = library.listing().into_iter().map(|line| line + "\n").collect();
        expect_file![root.join(format!("tests/api/{name}.txt"))].assert_eq(&text);
    }
}

/// Goal: the listing has what another crate can reach, and nothing else. Method: a crate with items behind re-exports,
/// a glob, another name, a feature and an implementation in another file, beside private and hidden ones.
#[test]
fn a_listing_has_what_can_be_reached() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    let root = "mod hidden;\npub mod open;\nmod all;\npub use hidden::{Seen, inner::Deep as Renamed};\n\
                pub use all::*;\npub use other::Foreign;\n#[cfg(feature = \"more\")]\npub mod more { pub fn f() {} }\n\
                #[cfg(test)]\nmod tests { pub fn no() {} }\n#[doc(hidden)]\npub fn no() {}\nfn no_either() {}\n\
                pub(crate) use hidden::Unseen;\n";
    write("lib.rs", root);
    let hidden = "#[derive(Clone)]\npub struct Seen { pub size: Option<Vec<f64>>, private: u8 }\npub struct Unseen;\n\
                  pub mod inner { #[non_exhaustive] pub enum Deep { One, Two(u8), Three { at: u8 } } }\n\
                  impl Seen { pub fn new(a: &'static str) -> Self { todo!() } fn no(&self) {} }\n\
                  impl Unseen { pub fn no() {} }\n";
    write("hidden.rs", hidden);
    let open = "use crate::hidden::Seen as Other;\npub use crate::Seen;\nimpl From<u8> for Other { fn from(_: u8) -> Self \
                { todo!() } }\npub trait Named: Sized { const N: usize = 1; fn name(&self) -> &str; }\n\
                impl Named for f64 { fn name(&self) -> &str { \"\" } }\n";
    write("open.rs", open);
    write("all.rs", "pub const ALL: [u8; 2] = [1, 2];\npub fn each<T>(f: impl Fn(T)) where T: Copy {}\nfn no() {}\n");
    let found = Library::read("it", &folder.path().join("lib.rs")).listing();
    let expected = [
        "it::ALL: pub const ALL: [u8; 2]",
        "it::Foreign: pub use other::Foreign",
        "it::Renamed: #[non_exhaustive] pub enum Renamed",
        "it::Renamed::One: One",
        "it::Renamed::Three: Three { at: u8 }",
        "it::Renamed::Two: Two(u8)",
        "it::Seen: impl Clone",
        "it::Seen: impl From<u8> for Other",
        "it::Seen: pub struct Seen { .. }",
        "it::Seen::new: pub fn new(a: &'static str) -> Self",
        "it::Seen::size: pub size: Option<Vec<f64>>",
        "it::each: pub fn each<T>(f: impl Fn(T)) where T: Copy",
        "it::more: #[cfg(feature = \"more\")] pub mod more",
        "it::more::f: pub fn f()",
        "it::open: pub mod open",
        "it::open::Named: impl Named for f64",
        "it::open::Named: pub trait Named: Sized",
        "it::open::Named::N: const N: usize = 1",
        "it::open::Named::name: fn name(&self) -> &str",
        "it::open::Seen: pub use it::Seen",
    ];
    assert_eq!(found, expected);
}
