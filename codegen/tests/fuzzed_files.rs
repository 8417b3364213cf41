//! Files that were spoilt at random: read, derived and emitted without a panic, each in its time.
//!
//! `TRIPOS_FUZZED_FILES` and `TRIPOS_FUZZED_MODELS` say how many are read, and how many that are still models are emitted.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use tripos_derive::Model;
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::{model, report, scene};

/// A file that takes longer than this hangs for whoever waits for it.
const PATIENCE: Duration = Duration::from_secs(60);

/// A seeded generator (SplitMix64): the same files on every machine.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, count: usize) -> usize {
        usize::try_from(self.next() % count.max(1) as u64).expect("small")
    }

    fn one<'a>(&mut self, list: &[&'a str]) -> &'a str {
        list[self.below(list.len())]
    }
}

/// What words are replaced by.
const PIECES: [&str; 40] = [
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
fn spoilt(text: &str, random: &mut Random) -> String {
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

fn is_model(path: &Path) -> bool {
    path.file_name().is_some_and(|n| n == "model.toml")
        || path.parent().is_some_and(|p| p.ends_with("derive/tests/models"))
}

/// Every TOML file under the folders of models and of tests, by name.
fn corpus() -> Vec<(PathBuf, String)> {
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

/// The model that a scene or report of the corpus belongs to.
fn owner(path: &Path) -> Option<Model> {
    let beside = path.with_file_name("model.toml");
    let above = path.parent()?.with_file_name("model.toml");
    [beside, above].iter().find(|path| path.exists()).and_then(|path| Model::read(path).ok())
}

/// How many, by the environment or else this.
fn count(variable: &str, otherwise: u64) -> u64 {
    std::env::var(variable).map_or(otherwise, |text| text.parse().expect("a number"))
}

/// A piece of work that must neither panic nor take long.
fn guarded<T>(what: &str, text: &str, work: impl FnOnce() -> T) -> T {
    let begun = Instant::now();
    let done = catch_unwind(AssertUnwindSafe(work));
    let took = begun.elapsed();
    assert!(took < PATIENCE, "{what} took {took:?}:\n{text}");
    done.unwrap_or_else(|_| panic!("{what} panicked:\n{text}"))
}

/// What is refused is shown, too.
fn shown(diagnostics: &Diagnostics) {
    assert!(!diagnostics.to_string().is_empty());
}

#[test]
fn spoilt_files_are_read_or_refused() {
    let corpus = corpus();
    let owners: Vec<Option<Model>> = corpus.iter().map(|(path, _)| owner(path)).collect();
    let mut read = 0;
    for seed in 0..count("TRIPOS_FUZZED_FILES", 3000) {
        let mut random = Random(seed);
        let at = random.below(corpus.len());
        let (path, text) = &corpus[at];
        let mut text = text.clone();
        for _ in 0..=random.below(3) {
            text = spoilt(&text, &mut random);
        }
        let source = Source { path: path.clone(), text };
        let is_report = path.file_name().is_some_and(|n| n == "report.toml")
            && path.parent().is_some_and(|p| !p.ends_with("scenes"));
        let answer = guarded(&format!("seed {seed} of {}", path.display()), &source.text, || match &owners[at] {
            _ if is_model(path) => model::load(&source).map(drop),
            Some(model) if is_report => report::load(&source, &mut model.clone()).map(drop),
            Some(model) => scene::load(&source, &mut model.clone()).map(drop),
            None => scene::model_path(&source).map(drop),
        });
        match answer {
            Ok(()) => read += 1,
            Err(diagnostics) => guarded(&format!("the message of seed {seed}"), &source.text, || shown(&diagnostics)),
        }
    }
    eprintln!("{read} of the spoilt files are still right");
}

#[test]
fn spoilt_models_are_emitted_or_refused() {
    let folder = tempfile::tempdir().unwrap();
    // Small ones: the elimination of large systems is not what is tried here.
    let corpus: Vec<_> = corpus().into_iter().filter(|(path, text)| is_model(path) && text.len() < 1100).collect();
    let path = folder.path().join("spoilt.toml");
    let (mut seed, mut emitted) = (1 << 40, 0);
    while emitted < count("TRIPOS_FUZZED_MODELS", 25) {
        let mut random = Random(seed);
        seed += 1;
        let mut text = corpus[random.below(corpus.len())].1.clone();
        for _ in 0..=random.below(2) {
            text = spoilt(&text, &mut random);
        }
        let what = format!("seed {seed}");
        if !guarded(&what, &text, || model::load(&Source::from_text("spoilt.toml", &text)).is_ok()) {
            continue;
        }
        std::fs::write(&path, &text).unwrap();
        emitted += 1;
        guarded(&what, &text, || match tripos_codegen::emit::emit(&path, "spoilt", &[]) {
            Ok(emission) => assert!(emission.files.contains_key("mod.rs")),
            Err(diagnostics) => shown(&diagnostics),
        });
    }
}
