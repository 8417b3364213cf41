//! Files that a publication names beside it: their names, their texts, and what was read of them.

use super::locals::Locals;
use super::printed::{Macros, Paper};
use crate::algebra::text::notation::Notation;
use crate::diagnostic::{Diagnostics, Source};
use crate::read::Located;
use rustc_hash::FxHashMap;
use std::path::Path;
use std::sync::Arc;

/// Endings of the names of files, each with the notation of their formulas.
const ENDINGS: [(&str, Notation); 10] = [
    ("tex", Notation::Latex),
    ("ltx", Notation::Latex),
    ("py", Notation::Python),
    ("m", Notation::Matlab),
    ("c", Notation::C),
    ("h", Notation::C),
    ("cc", Notation::C),
    ("cpp", Notation::C),
    ("cxx", Notation::C),
    ("hpp", Notation::C),
];

/// Files that a publication names, as far as they were read. `None` marks a file with a reported error.
pub struct Files<'r> {
    pub read: &'r dyn Fn(&str) -> Result<Source, Diagnostics>,
    /// Name of the file for entries that name none.
    pub usual: Option<Located>,
    /// Macros for formulas that are copied into the publication file.
    pub macros: Macros,
    pub sources: FxHashMap<String, Option<Arc<Source>>>,
    pub papers: FxHashMap<String, Option<Arc<Paper>>>,
    /// Names of abbreviations whose formulas are taken from the file at the top.
    pub defined: Vec<String>,
    /// Variables of programs by the file, the part of it and the notation.
    pub programs: FxHashMap<(String, String, &'static str), Option<Arc<Locals>>>,
}

impl<'r> Files<'r> {
    pub fn new(read: &'r dyn Fn(&str) -> Result<Source, Diagnostics>) -> Self {
        Self {
            read,
            usual: None,
            macros: Macros::default(),
            sources: FxHashMap::default(),
            papers: FxHashMap::default(),
            defined: Vec::new(),
            programs: FxHashMap::default(),
        }
    }
}

/// Notation of the formulas of a file, by the ending of its name; `None` for another ending.
pub fn notation_of_file(name: &str) -> Option<Notation> {
    let (_, ending) = name.rsplit_once('.')?;
    ENDINGS.iter().find(|(known, _)| *known == ending).map(|(_, notation)| *notation)
}

/// Reads a file that a publication names beside it. Links are refused: a name means a file of this folder.
#[cfg(feature = "files")]
pub fn read_named(path: &Path) -> Result<crate::diagnostic::Source, Diagnostics> {
    if std::fs::symlink_metadata(path).is_ok_and(|found| found.file_type().is_symlink()) {
        let source = crate::diagnostic::Source::from_text(&path.to_string_lossy(), "");
        let link =
            crate::diagnostic::Diagnostic::of_file("this is a link", "put the file itself beside the publication");
        return Err(Diagnostics::new(source, vec![link]));
    }
    crate::diagnostic::Source::read(path)
}

/// No file, since the program has no access to files.
#[cfg(not(feature = "files"))]
pub fn read_named(path: &Path) -> Result<crate::diagnostic::Source, Diagnostics> {
    let source = crate::diagnostic::Source::from_text(&path.to_string_lossy(), "");
    let why = crate::diagnostic::Diagnostic::of_file("this program reads no files", "copy the formulas");
    Err(Diagnostics::new(source, vec![why]))
}
