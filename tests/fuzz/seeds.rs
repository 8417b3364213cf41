//! Seeds of mutations: the files of the library, of the judged publications and of the tests.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// A seed: a file of the workspace with its text.
#[derive(Clone)]
pub struct Seed {
    /// Absolute path of the file.
    pub path: PathBuf,
    /// Text of the file.
    pub text: String,
}

/// Folder of the workspace.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap()
}

/// Largest seed, in bytes. Mutations of larger files show the same, and take longer.
const LARGEST: usize = 20_000;

/// Every text file with one of `extensions` under the folders of models, publications and tests, by path.
pub fn files_with(extensions: &[&str]) -> Vec<Seed> {
    let mut folders: Vec<PathBuf> =
        ["models", "publications", "derive/tests/models", "tests/data"].map(|folder| root().join(folder)).to_vec();
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| extensions.iter().any(|extension| e == *extension)) {
                let text = std::fs::read_to_string(&path).unwrap();
                if text.len() <= LARGEST {
                    files.push(Seed { path, text });
                }
            }
        }
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    assert!(!files.is_empty(), "no files with {extensions:?}");
    files
}

/// All TOML files.
pub fn toml_files() -> &'static [Seed] {
    static FILES: OnceLock<Vec<Seed>> = OnceLock::new();
    FILES.get_or_init(|| files_with(&["toml"]))
}

/// True if a file is a model.
pub fn is_model(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == "model.toml")
        || path.parent().is_some_and(|folder| folder.ends_with("derive/tests/models"))
}

/// True if a file is a publication.
pub fn is_publication(path: &Path) -> bool {
    let is_named = path.file_name().is_some_and(|name| name == "publication.toml");
    is_named && path.parent().is_some_and(|folder| !folder.ends_with("scenes"))
}

/// Texts between quotes in the TOML files: formulas, names, prose.
fn quoted_texts() -> &'static [String] {
    static TEXTS: OnceLock<Vec<String>> = OnceLock::new();
    TEXTS.get_or_init(|| {
        let mut found = Vec::new();
        for file in toml_files() {
            for line in file.text.lines().filter(|line| !line.trim_start().starts_with('#')) {
                let mut rest = line;
                while let Some(start) = rest.find(['"', '\'']) {
                    let quote = rest[start..].chars().next().unwrap();
                    let inside = &rest[start + 1..];
                    let Some(end) = inside.find(quote) else { break };
                    if end > 0 && end < 400 {
                        found.push(inside[..end].to_owned());
                    }
                    rest = &inside[end + 1..];
                }
            }
        }
        found.sort();
        found.dedup();
        found
    })
}

/// One of the texts between quotes.
pub fn quoted_text(random: &mut crate::campaign::Random) -> &'static str {
    let texts: &'static [String] = quoted_texts();
    random.one::<String>(texts)
}
