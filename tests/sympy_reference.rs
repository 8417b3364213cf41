//! The equations derived here, compared with those that SymPy alone derives from the same model files.

use crate::sympy;

use serde_json::{Value, json};
use std::cmp::Reverse;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use tripos_derive::Model;
use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::derive_all;
use tripos_derive::reference::{Reference, ReferenceError, compare_reference};

/// The model files of the library.
fn library() -> Vec<PathBuf> {
    let folders = std::fs::read_dir(sympy::root().join("models")).unwrap();
    let mut list: Vec<PathBuf> = folders.map(|entry| entry.unwrap().path().join("model.toml")).collect();
    list.retain(|path| path.is_file());
    list.sort();
    assert!(list.len() >= 3, "the models of the library");
    list
}

/// Models that only tests use.
fn others() -> Vec<PathBuf> {
    let files = std::fs::read_dir(sympy::root().join("derive/tests/models")).unwrap();
    let mut list: Vec<PathBuf> = files.map(|entry| entry.unwrap().path()).collect();
    list.retain(|path| path.extension().is_some_and(|e| e == "toml"));
    list.sort();
    assert!(!list.is_empty(), "the models of the tests");
    list
}

fn recorded(model: &Path) -> PathBuf {
    model.with_file_name("reference.json")
}

/// Models that the script knows to be beyond it, each with the tests that hold it to something else from outside.
const BEYOND: [(&str, &str); 2] =
    [("bricard", "tests/library.rs, derive/tests/closed_loops.rs"), ("whipple_bicycle", "tests/bicycle.rs")];

/// True if a model is one of those in `BEYOND`.
fn is_beyond(model: &Path) -> bool {
    BEYOND.iter().any(|(name, _)| model.parent().is_some_and(|folder| folder.ends_with(name)))
}

/// Number of compared entries, and a line for each that does not agree.
fn judge(model: &Path, reference: &Source) -> Result<(usize, Vec<String>), ReferenceError> {
    let model = Model::read(model).unwrap();
    let reference = Reference::read(reference)?;
    let mut derivations = derive_all(&model).unwrap();
    let found = compare_reference(&model, &mut derivations, &reference)?;
    let arena = &derivations.kinematics.arena;
    let count = found.len();
    let wrong = found.into_iter().filter(|entry| !entry.verdict.is_equal()).map(|entry| {
        let shown = |e: Option<_>| e.map_or("nothing".to_owned(), |e| print_text(arena, e));
        let (name, verdict) = (&entry.name, &entry.verdict);
        format!("{name}: SymPy {} | here {} | {verdict:?}", shown(entry.reference), shown(entry.derived))
    });
    Ok((count, wrong.collect()))
}

/// The reference of a model, derived now; one line that says what is wrong otherwise.
fn live(python: &Path, model: &Path) -> Result<String, String> {
    let output = Command::new(python).arg(sympy::script("reference.py")).arg(model).output().unwrap();
    if !output.status.success() {
        return Err(format!("{}: {}", output.status, String::from_utf8_lossy(&output.stderr)));
    }
    String::from_utf8(output.stdout).map_err(|e| e.to_string())
}

/// Faults of a model's reference, derived now. A recorded reference must be unchanged;
/// [`recorded_references_are_of_the_current_text_and_agree`] judges it.
fn renewed(python: &Path, model: &Path, is_recorded: bool) -> Vec<String> {
    let text = match live(python, model) {
        Ok(text) => text,
        Err(why) => return vec![format!("reference.py {}: {why}", model.display())],
    };
    if is_recorded {
        if std::fs::read_to_string(recorded(model)).ok().as_ref() == Some(&text) {
            return Vec::new();
        }
        return vec![format!("{} is not what SymPy derives now; run `tripos regenerate`", recorded(model).display())];
    }
    let source = Source { path: model.to_owned(), text };
    match judge(model, &source) {
        Ok((_, wrong)) => wrong.into_iter().map(|line| format!("{}: {line}", model.display())).collect(),
        Err(error) => vec![error.to_string()],
    }
}

/// Goal: two programs that share no line derive the same. Method: SymPy derives every model anew, in its own pinned
/// environment, and every velocity, load, energy and equation is compared by exact verdict: of the library's models in
/// the test below, since their text has to be the recorded one.
#[test]
fn sympy_derives_the_same_from_every_model() {
    if sympy::is_left_out("every model derived anew by SymPy") {
        return;
    }
    let python = sympy::python();
    let (models, tests) = (library(), others());
    let mut tasks: Vec<(&PathBuf, bool)> =
        models.iter().map(|m| (m, true)).chain(tests.iter().map(|m| (m, false))).collect();
    // The longest first, so that at the end no core waits for one of them.
    tasks.sort_by_key(|(model, _)| Reverse(std::fs::metadata(recorded(model)).map_or(0, |file| file.len())));
    let (next, wrong) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..workers {
            scope.spawn(|| {
                while let Some((model, is_recorded)) = tasks.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let found = renewed(&python, model, *is_recorded);
                    wrong.lock().unwrap().extend(found);
                }
            });
        }
    });
    let wrong = wrong.into_inner().unwrap();
    assert!(wrong.is_empty(), "{} disagreements:\n{}", wrong.len(), wrong.join("\n"));
}

/// Needs no Python: it holds wherever the tests run.
#[test]
fn recorded_references_are_of_the_current_text_and_agree() {
    for model in library() {
        let source = Source::read(&recorded(&model)).unwrap_or_else(|e| panic!("run `tripos regenerate`:\n{e}"));
        let judged = judge(&model, &source);
        if is_beyond(&model) {
            assert!(matches!(judged, Err(ReferenceError::NotDerived { .. })), "{}", model.display());
            continue;
        }
        let (count, wrong) = judged.unwrap_or_else(|e| panic!("run `tripos regenerate`: {e}"));
        assert!(count > 20, "{}: only {count} entries", model.display());
        assert!(wrong.is_empty(), "{}:\n{}", model.display(), wrong.join("\n"));
    }
}

/// One entry of a reference.
type Pick = fn(&mut Value) -> &mut Value;
/// An edit of a reference.
type Change = fn(&mut Value);

/// The disk's recorded reference, changed.
fn changed(change: impl FnOnce(&mut Value)) -> Result<Vec<String>, ReferenceError> {
    let model = sympy::root().join("models/disk/model.toml");
    let mut value: Value = serde_json::from_str(&std::fs::read_to_string(recorded(&model)).unwrap()).unwrap();
    change(&mut value);
    judge(&model, &Source { path: "changed.json".into(), text: value.to_string() }).map(|(_, wrong)| wrong)
}

fn negate(entry: &mut Value) {
    *entry = json!(format!("-({})", entry.as_str().expect("a formula")));
}

/// Goal: no error passes. Method: one entry of each kind with another sign; it and nothing else is named.
#[test]
fn one_changed_sign_is_named() {
    let cases: [(&str, Pick); 8] = [
        ("a(Cstar) @ B [1]", |v| &mut v["quantities"]["a(Cstar) @ B [1]"]),
        ("Fstar[2]", |v| &mut v["quantities"]["Fstar[2]"]),
        ("T", |v| &mut v["quantities"]["T"]),
        ("q3'", |v| &mut v["quantities"]["q3'"]),
        ("kane matrix[2,2]", |v| &mut v["kane"]["matrix"][1][1]),
        ("kane forcing[1]", |v| &mut v["kane"]["forcing"][0]),
        ("lagrange forcing[2]", |v| &mut v["lagrange"]["forcing"][1]),
        ("newton-euler forcing[3]", |v| &mut v["newton_euler"]["forcing"][2]),
    ];
    for (name, entry) in cases {
        let wrong = changed(|value| negate(entry(value))).unwrap();
        assert_eq!(wrong.len(), 1, "{name}: {wrong:#?}");
        assert!(wrong[0].starts_with(&format!("{name}: ")) && wrong[0].contains("Different"), "{wrong:#?}");
    }
}

/// A row of Newton–Euler may carry a factor and stand elsewhere; Kane's may not, and none may stand for two.
#[test]
fn only_newton_euler_rows_may_be_scaled_and_moved() {
    let negate_row = |system: &mut Value, i: usize| {
        system["matrix"][i].as_array_mut().unwrap().iter_mut().for_each(negate);
        negate(&mut system["forcing"][i]);
    };
    let swap = |system: &mut Value, i: usize, j: usize| {
        system["matrix"].as_array_mut().unwrap().swap(i, j);
        system["forcing"].as_array_mut().unwrap().swap(i, j);
    };
    let wrong = changed(|value| negate_row(&mut value["newton_euler"], 1)).unwrap();
    assert!(wrong.is_empty(), "{wrong:#?}");
    let wrong = changed(|value| swap(&mut value["newton_euler"], 0, 4)).unwrap();
    assert!(wrong.is_empty(), "{wrong:#?}");
    let wrong = changed(|value| negate_row(&mut value["kane"], 1)).unwrap();
    assert!(!wrong.is_empty() && wrong.iter().all(|line| line.starts_with("kane ")), "{wrong:#?}");
    let wrong = changed(|value| {
        for key in ["matrix", "forcing"] {
            value["newton_euler"][key][0] = value["newton_euler"][key][4].clone();
        }
    });
    let wrong = wrong.unwrap();
    assert!(!wrong.is_empty() && wrong.iter().all(|line| line.starts_with("newton-euler ")), "{wrong:#?}");
}

/// Goal: an entry that a reference leaves out does not count as agreement.
#[test]
fn a_reference_has_to_be_whole() {
    let remove = |value: &mut Value, name: &str| value.as_object_mut().unwrap().shift_remove(name).is_some();
    let wrong = changed(|value| assert!(remove(&mut value["quantities"], "V_gravity"))).unwrap();
    assert!(wrong.len() == 1 && wrong[0].starts_with("V_gravity: ") && wrong[0].contains("Undecided"), "{wrong:#?}");
    let wrong = changed(|value| assert!(remove(value, "newton_euler"))).unwrap();
    assert!(wrong.len() == 1 && wrong[0].starts_with("newton-euler: "), "{wrong:#?}");
}

/// No text of a reference panics; each error names the file and the place.
#[test]
fn wrong_references_are_errors_with_a_place() {
    let cases: [(&str, Change); 14] = [
        ("the file", |v| *v = json!([])),
        ("text_hash", |v| v["text_hash"] = json!(1)),
        ("model text 00,", |v| v["text_hash"] = json!("00")),
        ("quantities", |v| v["quantities"] = json!(null)),
        ("quantities.T", |v| v["quantities"]["T"] = json!(0)),
        ("`w(Cstar) @ B [1]`: unknown quantity", |v| v["quantities"]["w(Cstar) @ B [1]"] = json!("0")),
        ("`T`: unknown name `zeta`", |v| v["quantities"]["T"] = json!("zeta")),
        ("`T`: division by zero", |v| v["quantities"]["T"] = json!("1/0")),
        ("`T`: nesting", |v| v["quantities"]["T"] = json!("(".repeat(100_000))),
        ("kane", |v| v["kane"] = json!("M")),
        ("kane.matrix", |v| v["kane"]["matrix"][0] = json!(["1"])),
        ("lagrange.forcing", |v| v["lagrange"]["forcing"] = json!([])),
        ("unknowns of lagrange", |v| v["lagrange"]["unknowns"].as_array_mut().unwrap().reverse()),
        ("newton_euler.unknowns", |v| v["newton_euler"]["unknowns"] = json!({})),
    ];
    for (place, change) in cases {
        let message = changed(change).unwrap_err().to_string();
        assert!(message.starts_with("changed.json: ") && message.contains(place), "{place}: {message}");
    }
    for text in ["", "{", "[[[[", &"[".repeat(100_000), "\u{0}"] {
        let error = Reference::read(&Source::from_text("no.json", text)).unwrap_err();
        assert!(matches!(error, ReferenceError::NotJson { .. }), "{error}");
    }
}

/// The verdicts say what they rest on.
#[test]
fn a_disagreement_has_a_witness() {
    let model = Model::read(&sympy::root().join("models/disk/model.toml")).unwrap();
    let source = Source::read(&recorded(&model.source.path)).unwrap();
    let mut reference = Reference::read(&source).unwrap();
    let (_, energy) = reference.quantities.iter_mut().find(|(name, _)| name == "T").unwrap();
    energy.push_str(" + M");
    let mut derivations = derive_all(&model).unwrap();
    let found = compare_reference(&model, &mut derivations, &reference).unwrap();
    let entry = found.iter().find(|entry| entry.name == "T").unwrap();
    let Verdict::Different(witness) = &entry.verdict else { panic!("{:?}", entry.verdict) };
    assert!((witness.left - witness.right).abs() > 0.1, "the mass: {witness:?}");
}
