//! Large models on the command line: what is printed is complete, and small enough to be read.

use crate::arm::{Reactions, tree_text};
use crate::support::{root, tripos_in};
use std::collections::HashSet;

/// Goal: a printed derivation says what every name stands for, before the name is used. Method: every word of every
/// line of a tree's derivations, in text and in JSON, is a word of the model file, a symbol of it, or a name defined
/// above.
#[test]
fn every_name_of_a_large_derivation_is_defined_before_it_is_used() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.toml");
    std::fs::write(&path, tree_text(5, |i| i / 2, |i| i == 3, Reactions::All)).unwrap();
    let model = path.to_str().unwrap();
    for by in ["kane", "lagrange", "newton-euler"] {
        let (status, out, err) = tripos_in(&root(), &["derive", model, "--by", by, "--format", "json"]);
        assert_eq!(status, 0, "{err}");
        let value: serde_json::Value = serde_json::from_str(&out).unwrap();
        let found = &value["formulations"][0];
        let mut known: HashSet<String> = words(&tree_text(5, |i| i / 2, |i| i == 3, Reactions::All)).collect();
        known.extend(["sin", "cos"].map(str::to_owned));
        for i in 1..=5 {
            known.extend([format!("q{i}'"), format!("q{i}''"), format!("u{i}'")]);
        }
        let lines = |list: &serde_json::Value| -> Vec<(String, String)> {
            let one = |line: &serde_json::Value| {
                (line["name"].as_str().unwrap().to_owned(), line["value"].as_str().unwrap().to_owned())
            };
            list.as_array().unwrap().iter().map(one).collect()
        };
        let named = lines(&found["named"]);
        assert!(named.len() > 50, "{by}: {}", named.len());
        for (name, formula) in named.iter().chain(&lines(&found["accelerations"])) {
            let unknown: Vec<String> = words(formula).filter(|word| !known.contains(word)).collect();
            assert!(unknown.is_empty(), "{by}: {name} = {formula} mentions {unknown:?}");
            known.insert(name.clone());
        }
        for key in ["mass_matrix", "forcing", "kinetic_energy", "potential_energy", "steps"] {
            for formula in strings(&found[key]) {
                let unknown: Vec<String> = words(&formula).filter(|word| !known.contains(word)).collect();
                assert!(unknown.is_empty(), "{by} {key}: {formula}: {unknown:?}");
            }
        }
        let (_, text, _) = tripos_in(&root(), &["derive", model, "--by", by]);
        assert!(text.contains("\nTerms that stand by a name, each line by those before it\n"), "{text}");
        assert!(text.lines().map(str::len).max().unwrap() < 2000, "no line is longer than a person reads");
    }
}

/// The names in a formula.
fn words(text: &str) -> impl Iterator<Item = String> {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '\'';
    let starts = |word: &&str| word.starts_with(|c: char| c.is_ascii_alphabetic());
    text.split(move |c: char| !is_word(c)).filter(starts).map(str::to_owned)
}

/// All texts in a value.
fn strings(value: &serde_json::Value) -> Vec<String> {
    match value {
        serde_json::Value::String(text) => vec![text.clone()],
        serde_json::Value::Array(list) => list.iter().flat_map(strings).collect(),
        serde_json::Value::Object(map) => {
            map.get("value").into_iter().chain(map.get("lines")).flat_map(strings).collect()
        }
        _ => Vec::new(),
    }
}

/// Goal: a scene of a large model runs at once by full equations and says so; one that is small enough has its own.
/// Method: arms of three and of six joints that fall from rest; the momentum about the first, upright axis is the
/// longer arm's state and the shorter one's constant.
#[test]
fn scenes_of_large_models_run_by_whole_equations() {
    let folder = tempfile::tempdir().unwrap();
    for (n, whole) in [(3, false), (6, true)] {
        let home = folder.path().join(format!("arm{n}"));
        std::fs::create_dir_all(home.join("scenes")).unwrap();
        std::fs::write(home.join("model.toml"), tree_text(n, |i| i - 1, |_| false, Reactions::None)).unwrap();
        let start: Vec<String> = (1..=n).map(|i| format!("q{i} = 0.{i}\nu{i} = 0\n")).collect();
        let start = start.concat();
        let scene = home.join("scenes/fall.toml");
        let text = format!(
            "title = \"Falls\"\nspan = [0, 0.3]\n\n[start]\n{start}\n[integration]\nrtol = 1e-9\natol = 1e-11\n"
        );
        std::fs::write(&scene, text).unwrap();
        let (status, out, err) = tripos_in(&root(), &["simulate", scene.to_str().unwrap(), "--method", "dop853"]);
        assert_eq!(status, 0, "{err}");
        assert_eq!(err.contains("the full equations are integrated: this model is too large"), whole, "{n}: {err}");
        assert_eq!(out.contains("Kane's method"), whole, "{n}: {out}");
        assert!(out.contains("largest change of total energy") && !err.contains("warning"), "{n}: {out}{err}");
    }
}

/// Goal: what is too large is refused at once, with its counts. Method: a chain of 300 links.
#[test]
fn a_model_that_is_too_large_is_refused_with_its_counts() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.toml");
    std::fs::write(&path, tree_text(300, |i| i - 1, |_| false, Reactions::None)).unwrap();
    let (status, out, err) = tripos_in(&root(), &["derive", path.to_str().unwrap()]);
    assert_eq!((status, out.as_str()), (2, ""), "{err}");
    let wanted = "the equations are too large: 300 bodies and 300 coordinates make 91200 frames and points between its \
                  bodies and the ground, more than 25000";
    assert!(err.contains(wanted) && err.contains("help: join bodies"), "{err}");
}

/// Goal: a difference of large models tells the old terms from the new. Method: an arm with a link moved; no difference
/// that is printed is that of a name and itself.
#[test]
fn terms_of_the_old_model_are_told_from_those_of_the_new() {
    let folder = tempfile::tempdir().unwrap();
    let text = tree_text(3, |i| i - 1, |_| false, Reactions::None);
    for (side, text) in [("old", text.clone()), ("new", text.replace("\"lx3\"", "\"2*lx3\""))] {
        std::fs::create_dir(folder.path().join(side)).unwrap();
        std::fs::write(folder.path().join(side).join("model.toml"), text).unwrap();
    }
    let (status, out, err) = tripos_in(folder.path(), &["diff", "old", "new"]);
    assert_eq!(status, 1, "{err}");
    assert!(out.contains("M[u1, u1']: new - old = "), "{out}");
    for line in out.lines() {
        if let Some((minuend, subtrahend)) = line.rsplit_once(" = ").and_then(|(_, value)| value.split_once(" - ")) {
            assert_ne!(minuend, subtrahend, "{line}");
        }
    }
}
