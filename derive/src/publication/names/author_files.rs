//! Files to which a publication refers: their names, texts and parsed contents.

use super::program_variables::ProgramVariables;
use crate::algebra::text::notation::Notation;
use crate::diagnostic::{Diagnostics, Source};
use crate::publication::printed::{LatexFile, Macros};
use crate::toml_reader::Located;
use rustc_hash::FxHashMap;
use std::path::Path;
use std::sync::Arc;

/// Endings of file names, each with the notation of the formulas in files with this ending.
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

/// Cache of the files to which a publication refers. In each map, `None` marks a file with a reported error.
pub struct AuthorFiles<'r> {
    /// Function that reads a file by its name, or returns the reason why it cannot be read.
    pub read: &'r dyn Fn(&str) -> Result<Source, Diagnostics>,
    /// Name of the file for entries that name no file; `None` if the publication has none.
    pub usual: Option<Located>,
    /// LaTeX macros for formulas that are written in the publication file itself.
    pub macros: Macros,
    /// Texts of the files read so far, by name; `None` for a file with a reported error.
    pub sources: FxHashMap<String, Option<Arc<Source>>>,
    /// LaTeX files read so far, by name; `None` for a file with a reported error.
    pub papers: FxHashMap<String, Option<Arc<LatexFile>>>,
    /// Names of abbreviations whose formulas are taken from the file at the top.
    pub defined: Vec<String>,
    /// Variables of the programs read so far, by file, part of the file, and notation; `None` after
    /// a reported error.
    pub programs: FxHashMap<(String, String, &'static str), Option<Arc<ProgramVariables>>>,
}

impl<'r> AuthorFiles<'r> {
    /// Creates an empty cache. The function `read` reads a file by its name, or returns the reason why it cannot.
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

/// Notation of the formulas in a file, from the ending of its name; `None` for an unknown ending.
pub fn notation_of_author_file(name: &str) -> Option<Notation> {
    let (_, ending) = name.rsplit_once('.')?;
    ENDINGS.iter().find(|(known, _)| *known == ending).map(|(_, notation)| *notation)
}

/// Reads a file in the folder of a publication. Symbolic links are refused: a name means a file in
/// this folder.
///
/// # Errors
/// `Diagnostics` if the path is a link, or if the file cannot be read.
#[cfg(feature = "files")]
pub fn read_file_beside_publication(path: &Path) -> Result<crate::diagnostic::Source, Diagnostics> {
    if std::fs::symlink_metadata(path).is_ok_and(|found| found.file_type().is_symlink()) {
        let source = crate::diagnostic::Source::from_text(&path.to_string_lossy(), "");
        let link =
            crate::diagnostic::Diagnostic::of_file("this is a link", "put the file itself beside the publication");
        return Err(Diagnostics::new(source, vec![link]));
    }
    crate::diagnostic::Source::read(path)
}

/// Returns an error, because the program is built without access to files.
///
/// # Errors
/// Always `Diagnostics` that no files can be read.
#[cfg(not(feature = "files"))]
pub fn read_file_beside_publication(path: &Path) -> Result<crate::diagnostic::Source, Diagnostics> {
    let source = crate::diagnostic::Source::from_text(&path.to_string_lossy(), "");
    let why = crate::diagnostic::Diagnostic::of_file("this program reads no files", "copy the formulas");
    Err(Diagnostics::new(source, vec![why]))
}
