//! Commands on files that were spoilt at random: each ends by itself, with a status that it documents.
//!
//! `TRIPOS_FUZZED_COMMANDS` says how many are run.

#[path = "../support/spoilt.rs"]
mod files;

use crate::support::copy;
pub use files::Random;
use files::{corpus, count, is_model, spoilt};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// A command that takes longer than this hangs for whoever waits for it.
const PATIENCE: Duration = Duration::from_secs(120);

/// The status of a command, none if a signal ended it.
fn status_of(mut child: Child, what: &str) -> Option<i32> {
    let begun = Instant::now();
    loop {
        if let Some(status) = child.try_wait().unwrap() {
            return status.code();
        }
        if begun.elapsed() > PATIENCE {
            child.kill().unwrap();
            child.wait().unwrap();
            panic!("{what} did not end");
        }
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn commands_end_with_a_status_of_their_own() {
    // Small models: what large ones cost is not what is tried here.
    let corpus: Vec<_> = corpus().into_iter().filter(|(_, text)| text.len() < 3000).collect();
    let mut counts = [0; 4];
    for seed in 0..count("TRIPOS_FUZZED_COMMANDS", 40) {
        let mut random = Random(!seed);
        let (path, text) = &corpus[random.below(corpus.len())];
        let beside = path.parent().unwrap();
        // The folder of a model has its scenes and its report.
        let whole = if beside.ends_with("scenes") { beside.parent().unwrap() } else { beside };
        let folder = tempfile::tempdir().unwrap();
        copy(whole, folder.path());
        let file = folder.path().join(path.strip_prefix(whole).unwrap());
        let mut text = text.clone();
        for _ in 0..=random.below(3) / 2 {
            text = spoilt(&text, &mut random);
        }
        std::fs::write(&file, &text).unwrap();
        let is_publication = file.ends_with("publication.toml") && !file.parent().unwrap().ends_with("scenes");
        let command = match () {
            () if is_model(path) => random.one(&["check", "derive", "prove", "diff", "emit"]),
            () if is_publication => "diff",
            () => random.one(&["simulate", "simulate", "scene", "sweep"]),
        };
        let target = if is_publication { file.with_file_name("model.toml") } else { file.clone() };
        let ways = ["--json", "--by kane", "--method gauss6", "--solve numeric"];
        let options: Vec<&str> = match command {
            "emit" => vec!["--out", "emitted"],
            "sweep" => vec!["--over", "g=1.62,9.81", "--out", "table.csv"],
            "simulate" => random.one(&ways).split(' ').collect(),
            _ => Vec::new(),
        };
        let mut run = Command::new(env!("CARGO_BIN_EXE_tripos"));
        run.arg(command).arg(&target).args(options).current_dir(folder.path());
        run.stdout(Stdio::null()).stderr(Stdio::null());
        let what = format!("`{command} {}` of seed {seed}, which is\n{text}", target.display());
        match status_of(run.spawn().unwrap(), &what) {
            Some(status @ 0..=3) => counts[usize::try_from(status).unwrap()] += 1,
            other => panic!("{what}\nended with {other:?}"),
        }
    }
    eprintln!("statuses 0 to 3: {counts:?}");
}
