//! Files that were spoilt at random: read, derived and emitted without a panic, each in its time.
//!
//! `TRIPOS_FUZZED_FILES` and `TRIPOS_FUZZED_MODELS` say how many are read, and how many that are still models are
//! emitted.

#[path = "../../tests/support/spoilt.rs"]
mod files;

use files::{Random, corpus, count, is_model, spoilt};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};
use tripos_derive::Model;
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::{model, publication, scene};

/// A file that takes longer than this hangs for whoever waits for it.
const PATIENCE: Duration = Duration::from_secs(60);

/// The model that a scene or publication of the corpus belongs to.
fn owner(path: &Path) -> Option<Model> {
    let beside = path.with_file_name("model.toml");
    let above = path.parent()?.with_file_name("model.toml");
    [beside, above].iter().find(|path| path.exists()).and_then(|path| Model::read(path).ok())
}

/// A piece of work that must neither panic nor take long.
fn guarded<T>(what: &str, text: &str, work: impl FnOnce() -> T) -> T {
    let begun = Instant::now();
    let done = catch_unwind(AssertUnwindSafe(work));
    let took = begun.elapsed();
    assert!(took < PATIENCE, "{what} took {took:?}:\n{text}");
    done.unwrap_or_else(|_| panic!("{what} panicked:\n{text}"))
}

/// Asserts that refused input has a message that can be shown.
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
        let is_publication = path.file_name().is_some_and(|n| n == "publication.toml")
            && path.parent().is_some_and(|p| !p.ends_with("scenes"));
        let answer = guarded(&format!("seed {seed} of {}", path.display()), &source.text, || match &owners[at] {
            _ if is_model(path) => model::load(&source).map(drop),
            Some(model) if is_publication => publication::load_publication(&source, &mut model.clone()).map(drop),
            Some(model) => scene::load(&source, &mut model.clone()).map(drop),
            None => scene::model_path_of_scene(&source).map(drop),
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
        guarded(&what, &text, || {
            match tripos_codegen::emit::emit_rust_module(&path, "spoilt", &[], tripos_codegen::Extras::ALL) {
                Ok(emission) => assert!(emission.files.contains_key("mod.rs")),
                Err(diagnostics) => shown(&diagnostics),
            }
        });
    }
}
