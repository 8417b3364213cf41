//! Files spoilt at random, for the tests of what reads them.

#[path = "random.rs"]
mod random;

pub use random::Random;
use std::path::{Path, PathBuf};

/// Replacements for words of a file.
pub const PIECES: [&str; 40] = [
    "0",
    "-1",
    "1e999",
    "-1e999",
    "1e-999",
    "10^400",
    "10^-4000",
    "1/0",
    "0/0",
    "9223372036854775808",
    "1e308*10",
    "pi",
    "nan",
    "inf",
    "''",
    "\"\"",
    "[]",
    "{}",
    "true",
    "sin(",
    ")",
    "^",
    "^2",
    "^(1/2)",
    "^-1",
    "sqrt(-1)",
    "log(0)",
    "acos(2)",
    "abs(q)",
    "sign(0)",
    "exp(1000)",
    "(((((((((",
    "t",
    "deg",
    "'",
    "''",
    "\u{1b}",
    "\u{202e}",
    "θ",
    "\u{0}",
];

/// One change to a text.
pub fn spoilt(text: &str, random: &mut Random) -> String {
    let lines: Vec<&str> = text.lines().collect();
    let words: Vec<&str> = text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|w| !w.is_empty()).collect();
    let boundary = |at: usize| (at..=text.len()).find(|at| text.is_char_boundary(*at)).unwrap_or(text.len());
    match random.below(9) {
        // A line goes, comes twice, or changes places with another.
        0 | 1 => {
            let (place, times) = (random.below(lines.len()), 2 * random.below(2));
            let repeated =
                lines.iter().enumerate().flat_map(|(at, line)| vec![*line; if at == place { times } else { 1 }]);
            repeated.collect::<Vec<_>>().join("\n")
        }
        2 if !lines.is_empty() => {
            let mut lines = lines;
            let (a, b) = (random.below(lines.len()), random.below(lines.len()));
            lines.swap(a, b);
            lines.join("\n")
        }
        // A word stands for another, everywhere or once.
        3 | 4 if !words.is_empty() => {
            let (old, new) = (random.one(&words), random.one(&words));
            if random.below(2) == 0 { text.replace(old, new) } else { text.replacen(old, new, 1) }
        }
        // A word becomes a number, a sign, or what no file should have.
        5 | 6 if !words.is_empty() => {
            let (old, new) = (random.one(&words), random.one(&PIECES));
            text.replacen(old, new, 1 + random.below(3))
        }
        7 => {
            let at = boundary(random.below(text.len() + 1));
            format!("{}{}{}", &text[..at], random.one(&PIECES), &text[at..])
        }
        _ => text[..boundary(random.below(text.len() + 1))].to_owned(),
    }
}

/// True if a file of the corpus is a model.
pub fn is_model(path: &Path) -> bool {
    path.file_name().is_some_and(|n| n == "model.toml")
        || path.parent().is_some_and(|p| p.ends_with("derive/tests/models"))
}

/// Every TOML file under the folders of models and of tests, by name.
pub fn corpus() -> Vec<(PathBuf, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let mut folders: Vec<PathBuf> = ["models", "derive/tests/models", "tests/data"].map(|f| root.join(f)).to_vec();
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "toml") {
                let text = std::fs::read_to_string(&path).unwrap();
                files.push((path, text));
            }
        }
    }
    files.sort();
    files
}

/// Number of trials: that of the environment variable, or else `otherwise`.
pub fn count(variable: &str, otherwise: u64) -> u64 {
    std::env::var(variable).map_or(otherwise, |text| text.parse().expect("a number"))
}
