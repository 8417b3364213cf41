//! Files of models, scenes, states, motions and publications.

use crate::campaign::{Answer, Random, Share, campaign, tried};
use crate::grammar::formula;
use crate::mutation::spoilt;
use crate::refusal::check_errors;
use crate::seeds::{Seed, is_model, is_publication, quoted_text, toml_files};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use tripos_derive::Model;
use tripos_derive::algebra::text::notation::Notation;
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::{model, publication, scene};

/// True if an error may concern a file as a whole, because the file lacks something.
fn is_of_file(message: &str) -> bool {
    message.contains(" has no ")
        || message == "the file is no motion"
        || message.starts_with("no value ")
        || message.starts_with("no formula ")
        || message.ends_with(" is empty")
        || message.ends_with(" but comments")
}

/// Checks the answer of a reader of files.
pub fn checked<T>(answer: Result<T, Diagnostics>) -> Answer {
    match answer {
        Ok(_) => Answer::Read,
        Err(errors) => {
            check_errors(&errors, &is_of_file);
            Answer::Refused
        }
    }
}

/// A seed with the model that it belongs to.
pub struct OwnedSeed {
    /// The seed.
    pub seed: Seed,
    /// Model of the scene or publication.
    pub model: Model,
}

/// Bytes of the largest model whose scenes and publications are mutated: a model is copied for each case.
const LARGEST_MODEL: usize = 4000;

/// Model beside or above a file.
fn model_of(path: &Path) -> Option<Model> {
    let candidates = [path.with_file_name("model.toml"), path.parent()?.with_file_name("model.toml")];
    let place: &PathBuf = candidates.iter().find(|path| path.exists())?;
    let size = std::fs::metadata(place).ok()?.len();
    if size > LARGEST_MODEL as u64 { None } else { Model::read(place).ok() }
}

/// Seeds that pass a test, with their models.
fn owned_seeds(is_wanted: impl Fn(&Path) -> bool) -> Vec<OwnedSeed> {
    let wanted = toml_files().iter().filter(|seed| is_wanted(&seed.path));
    wanted.filter_map(|seed| Some(OwnedSeed { seed: seed.clone(), model: model_of(&seed.path)? })).collect()
}

/// Scenes with their models.
pub fn scenes() -> &'static [OwnedSeed] {
    static SCENES: OnceLock<Vec<OwnedSeed>> = OnceLock::new();
    SCENES.get_or_init(|| owned_seeds(|path| path.parent().is_some_and(|folder| folder.ends_with("scenes"))))
}

/// Publications with their models.
fn publications() -> &'static [OwnedSeed] {
    static PUBLICATIONS: OnceLock<Vec<OwnedSeed>> = OnceLock::new();
    PUBLICATIONS.get_or_init(|| owned_seeds(is_publication))
}

/// Models whose reading is cheap.
fn models() -> &'static [Seed] {
    static MODELS: OnceLock<Vec<Seed>> = OnceLock::new();
    MODELS.get_or_init(|| {
        let models = toml_files().iter().filter(|seed| is_model(&seed.path));
        models.filter(|seed| seed.text.len() < 1500).cloned().collect()
    })
}

/// A text with changes, some of which put a random formula in the place of a quoted text.
pub fn spoilt_file(text: &str, random: &mut Random) -> String {
    let mut text = text.to_owned();
    if random.chance(30) {
        let notation = *random.one(&Notation::ALL);
        let new = formula(notation, 3, random);
        let quotes: Vec<usize> = text.match_indices('"').map(|(at, _)| at).collect();
        if quotes.len() > 1 {
            let first = random.below(quotes.len() - 1);
            text = format!("{}{}{}", &text[..=quotes[first]], new.replace('\\', "\\\\"), &text[quotes[first + 1]..]);
        }
        if random.chance(50) {
            return text;
        }
    }
    let other = if random.chance(50) { &random.one(toml_files()).text } else { quoted_text(random) };
    spoilt(&text, other, random)
}

/// A spoilt file at the place of its seed.
fn spoilt_source(seed: &Seed, random: &mut Random) -> Source {
    let text = spoilt_file(&seed.text, random);
    tried(&text);
    Source { path: seed.path.clone(), ..Source::from_text("", &text) }
}

#[test]
fn files_of_models() {
    let share = Share { short: 1500, long: 150_000 };
    campaign("model.toml", &share, |random| {
        let seed = random.one(models());
        checked(model::load(&spoilt_source(seed, random)))
    });
}

#[test]
fn files_of_scenes() {
    let share = Share { short: 1000, long: 120_000 };
    campaign("scene.toml", &share, |random| {
        let owned = random.one(scenes());
        let source = spoilt_source(&owned.seed, random);
        let mut model = owned.model.clone();
        if random.chance(10) {
            return checked(scene::model_path_of_scene(&source));
        }
        if random.chance(50) {
            checked(scene::load(&source, &mut model))
        } else {
            checked(scene::load_scene_with_inputs(&source, &mut model))
        }
    });
}

#[test]
fn files_of_publications() {
    let share = Share { short: 800, long: 100_000 };
    campaign("publication.toml", &share, |random| {
        let owned = random.one(publications());
        let source = spoilt_source(&owned.seed, random);
        checked(publication::load_publication(&source, &mut owned.model.clone()))
    });
}

/// Text of a state or motion file for a model, before changes.
fn state_text(model: &Model, random: &mut Random) -> String {
    let value = |random: &mut Random| match random.below(4) {
        0 => format!("\"{}\"", formula(Notation::Tripos, 2, random)),
        1 => "\"30*deg\"".to_owned(),
        _ => random.decimal(-2.0, 2.0).to_string(),
    };
    let mut text = String::from("[state]\n");
    for c in &model.coordinates {
        let _ = writeln!(text, "{} = {}", c.name, value(random));
    }
    for u in &model.speeds {
        let _ = writeln!(text, "{} = {}", u.name, value(random));
    }
    if random.chance(40) {
        text += "[accelerations]\n";
        for u in &model.speeds {
            let _ = writeln!(text, "\"{}'\" = {}", u.name, value(random));
        }
    } else if random.chance(50) {
        text = text.replace("[state]", "[motion]") + "[times]\nfrom = 0\nto = 1\ncount = 3\n";
    }
    if random.chance(40) {
        text += "[parameters]\n";
        for p in &model.parameters {
            let _ = writeln!(text, "{} = {}", p.name, value(random));
        }
    }
    text
}

#[test]
fn files_of_states_and_motions() {
    let share = Share { short: 1500, long: 120_000 };
    campaign("states and motions (`--at`)", &share, |random| {
        let owned = random.one(scenes());
        let mut model = owned.model.clone();
        let text = state_text(&model, random);
        let text = if random.chance(70) { spoilt_file(&text, random) } else { text };
        tried(&text);
        let source = Source { path: owned.seed.path.with_file_name("state.toml"), text };
        match random.below(3) {
            0 => checked(scene::load_state(&source, &mut model)),
            1 => checked(scene::load_motion(&source, &mut model)),
            _ => checked(scene::load_state_with_unknowns(&source, &mut model, &[])),
        }
    });
}
