//! `tripos plot`, and what the command says of itself: `schema`, `completions`, `man`.

use crate::support::{root, tripos_in};
use std::path::Path;
use tempfile::tempdir;

fn tripos(arguments: &[&str]) -> (i32, String, String) {
    tripos_in(&root(), arguments)
}

/// The rows of the data of a figure: panel, curve, what it is against, x and y.
fn rows(path: &Path) -> Vec<(String, String, String, f64, f64)> {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let number = |text: &str| text.parse::<f64>().unwrap();
    let row = |row: csv::StringRecord| {
        (row[0].to_owned(), row[1].to_owned(), row[2].to_owned(), number(&row[3]), number(&row[4]))
    };
    reader.records().map(|record| row(record.unwrap())).collect()
}

const SCENE: &str = "models/heavy_top/scenes/looping.toml";

/// Goal: a phase portrait has the points of the run. Method: q₁' against q₁ of the top, the nutation; at each point the
/// total energy is that of the start.
#[test]
fn a_phase_portrait_has_the_points_of_the_run() {
    let folder = tempdir().unwrap();
    let out = folder.path().join("portrait.svg");
    let place = out.to_str().unwrap();
    let (status, said, err) =
        tripos(&["plot", SCENE, "--what", "q1'", "--against", "q1", "--what", "total_energy", "--out", place]);
    assert!(status == 0 && said.contains("portrait.svg") && said.contains("portrait.csv"), "{said}{err}");
    let svg = std::fs::read_to_string(&out).unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("<path fill=\"none\""), "{}", &svg[..200.min(svg.len())]);
    let all = rows(&out.with_extension("csv"));
    let speeds: Vec<_> = all.iter().filter(|row| row.0.contains('\u{307}')).collect();
    let energies: Vec<_> = all.iter().filter(|row| row.0.contains("energy")).collect();
    assert!(speeds.len() > 50 && speeds.len() == energies.len(), "{} {}", speeds.len(), energies.len());
    for (speed, energy) in speeds.iter().zip(&energies) {
        assert!(speed.3.total_cmp(&energy.3).is_eq() && speed.2.contains("q1"), "{speed:?} {energy:?}");
        assert!((energy.4 - energies[0].4).abs() < 1e-6 * energies[0].4.abs(), "{energy:?}");
    }
}

/// Goal: several ways and quantities stand in one panel, told apart. Method: two quantities by two methods make four
/// curves, which agree where both have samples.
#[test]
fn ways_and_quantities_are_told_apart_in_a_panel() {
    let folder = tempdir().unwrap();
    let out = folder.path().join("both.csv");
    let arguments =
        ["plot", SCENE, "--what", "q1, 2*q1", "--also", "method=dop853,rtol=1e-9", "--out", out.to_str().unwrap()];
    let (status, said, err) = tripos(&arguments);
    assert!(status == 0 && !said.contains("figure"), "{said}{err}");
    let all = rows(&out);
    let mut curves: Vec<&str> = all.iter().map(|row| row.1.as_str()).collect();
    curves.dedup();
    assert_eq!(curves.len(), 4, "{curves:?}");
    let of = |curve: &str| all.iter().filter(|row| row.1 == curve).map(|row| row.4).collect::<Vec<f64>>();
    for pair in [[curves[0], curves[1]], [curves[2], curves[3]]] {
        let [one, two] = pair.map(of);
        assert!(!one.is_empty() && one.iter().zip(&two).all(|(a, b)| (2.0 * a - b).abs() < 1e-12), "{pair:?}");
    }
    assert!(curves[2].contains("method=dop853,rtol=1e-9") && curves[0].contains("q1"), "{curves:?}");
}

/// Goal: all first integrals are drawn on their own scales. Method: the momenta and the energy of the top, which change
/// by little.
#[test]
fn the_first_integrals_are_drawn_as_changes() {
    let folder = tempdir().unwrap();
    let out = folder.path().join("kept.svg");
    let place = out.to_str().unwrap();
    // Outputs beside the states are no part of what integrals are computed from.
    let (status, _, err) = tripos(&["plot", SCENE, "--what", "integrals", "--what", "total_energy", "--out", place]);
    assert!(status == 0, "{err}");
    let all = rows(&out.with_extension("csv"));
    let mut panels: Vec<&str> = all.iter().map(|row| row.0.as_str()).collect();
    panels.dedup();
    let changes = all.iter().filter(|row| row.0 != "total_energy");
    assert!(panels.len() >= 4 && changes.into_iter().all(|row| row.4 < 1e-3), "{panels:?}");
}

/// Goal: what cannot be drawn is said before anything runs, with a way out.
#[test]
fn wrong_figures_are_refused() {
    for (arguments, what) in [
        (["plot", SCENE, "--what", "qq1"], "did you mean `q1`?"),
        (["plot", SCENE, "--out", "figure.docx"], "ends in .svg"),
        (["plot", SCENE, "--also", "colour=red"], "method=taylor,rtol=1e-9"),
        (["plot", SCENE, "--against", "nothing"], "unknown name `nothing`"),
    ] {
        let (status, out, err) = tripos(&arguments);
        assert!(status == 2 && out.is_empty() && err.contains(what), "{arguments:?}: {out}{err}");
    }
}

/// Goal: editors get schemas, and nothing else stands on standard output.
#[test]
fn schemas_of_all_formats_are_printed() {
    for format in ["model", "scene", "state", "publication"] {
        let (status, out, err) = tripos(&["schema", format]);
        assert!(status == 0 && err.is_empty(), "{err}");
        let value: serde_json::Value = serde_json::from_str(&out).unwrap();
        assert!(
            value["properties"]["schema"].is_object() && value["title"].as_str().unwrap().contains(format),
            "{out}"
        );
    }
    assert_eq!(tripos(&["schema", "page"]).0, 2);
}

/// Goal: all commands read the same format of state files. Method: a state for `linearise`, with names of its own, is
/// evaluated, with a number for each guess.
#[test]
fn states_with_names_of_their_own_are_evaluated() {
    let at = "models/whipple_bicycle/steady/v5.toml";
    let (status, out, err) = tripos(&["evaluate", "models/whipple_bicycle", "--by", "kane", "--at", at, "--json"]);
    assert!(status == 0, "{err}");
    let value: serde_json::Value = serde_json::from_str(&out).unwrap();
    let accelerations = value["accelerations"].as_object().unwrap();
    assert!(accelerations.values().all(|a| a.as_f64().unwrap().abs() < 1e-10), "{out}");
}

/// Goal: shells and `man` know every command. Method: each name that the help lists, in the completions of every shell
/// and among the pages.
#[test]
fn shells_and_manual_know_every_command() {
    let (_, help, _) = tripos(&["--help"]);
    let list = help.split("Commands:\n").nth(1).unwrap().split("\n\n").next().unwrap();
    let names: Vec<&str> = list.lines().filter_map(|line| line.split_whitespace().next()).collect();
    assert!(names.len() > 15 && names.contains(&"simulate"), "{names:?}");
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let (status, out, err) = tripos(&["completions", shell]);
        assert!(status == 0 && err.is_empty(), "{err}");
        assert!(names.iter().all(|name| out.contains(name)), "{shell}");
    }
    let folder = tempdir().unwrap();
    let (status, _, err) = tripos(&["man", "--out", folder.path().to_str().unwrap()]);
    assert!(status == 0, "{err}");
    for name in names.iter().filter(|name| **name != "help") {
        let page = std::fs::read_to_string(folder.path().join(format!("tripos-{name}.1"))).unwrap();
        assert!(page.contains(".TH") && page.contains("DESCRIPTION"), "{name}");
    }
    assert!(tripos(&["man"]).1.contains("simulate"));
}

/// Goal: places, velocities and turns are shown by name. Method: the centre of the sliding disk is R cos q2 above the
/// plane and rises at the derivative of that, and the disk turns about its lateral axis at u3; an unknown name is
/// refused.
#[test]
fn places_and_velocities_are_drawn_by_name() {
    let folder = tempdir().unwrap();
    let out = folder.path().join("zeros.csv");
    let what = "p(Cstar) @ A [3] - R*cos(q2), v(Cstar) @ A [3] + R*sin(q2)*q2', omega(C) @ B [3] - u3";
    let scene = "models/disk/scenes/report.toml";
    let arguments = ["plot", scene, "--what", what, "--by", "kane", "--out", out.to_str().unwrap()];
    let (status, _, err) = tripos(&arguments);
    assert!(status == 0, "{err}");
    let all = rows(&out);
    assert!(
        all.len() > 100 && all.iter().all(|row| row.4.abs() < 1e-12),
        "{:?}",
        all.iter().find(|row| row.4.abs() >= 1e-12)
    );
    let (status, _, err) = tripos(&["plot", scene, "--what", "p(Cstart) @ A [3]"]);
    assert!(status == 2 && err.contains("no point `Cstart`") && err.contains("did you mean `Cstar`?"), "{err}");
}

/// Goal: a scene's name of a quantity is its name in figures, too. Method: an output with a formula by its name, and by
/// its formula.
#[test]
fn outputs_of_a_scene_are_plotted_by_their_names() {
    let folder = tempdir().unwrap();
    let scene = std::fs::read_to_string(root().join(SCENE)).unwrap();
    let model = root().join("models/heavy_top/model.toml");
    let own = folder.path().join("own.toml");
    let outputs = "outputs = [{ name = \"height\", value = \"cos(q1)\" }]";
    let kept: Vec<&str> = scene.lines().filter(|line| !line.starts_with("outputs")).collect();
    std::fs::write(&own, format!("model = {model:?}\n{outputs}\n{}", kept.join("\n"))).unwrap();
    let out = folder.path().join("height.csv");
    let (own, place) = (own.to_str().unwrap(), out.to_str().unwrap());
    let (status, said, err) = tripos(&["plot", own, "--what", "height", "--what", "cos(q1)", "--out", place]);
    assert!(status == 0, "{said}{err}");
    let all = rows(&out);
    let of = |panel: &str| all.iter().filter(|row| row.0.contains(panel)).map(|row| row.4).collect::<Vec<f64>>();
    assert!(of("height").len() > 50 && of("height") == of("cos"), "{said}");
}
