//! `tripos chart` and `tripos stability`: the committed figures are current, show what they must, and hostile requests
//! are answered.

use crate::support::{root, stderr, tripos};
use std::collections::BTreeMap;
use std::path::Path;

const CHARTED: &str = "models/disk/scenes/report-10s.toml";
const PASSED: &str = "models/disk/scenes/near-flat.toml";
const FORMULATIONS: [&str; 3] = ["kane", "lagrange", "newton-euler"];
const SOLVES: [&str; 2] = ["eliminated", "numeric"];

/// One line of a table, by column.
struct Line(BTreeMap<String, String>);

impl Line {
    fn text(&self, column: &str) -> &str {
        &self.0[column]
    }

    fn number(&self, column: &str) -> f64 {
        self.text(column).parse().unwrap_or_else(|_| panic!("{column} is `{}`", self.text(column)))
    }

    /// The error, which is there exactly if the run arrived.
    fn error(&self) -> Option<f64> {
        assert_eq!(self.text("error").is_empty(), self.text("stop") != "end", "{:?}", self.0);
        (!self.text("error").is_empty()).then(|| self.number("error"))
    }
}

/// The header and the lines by their first columns.
fn table(path: &Path, keys: usize) -> (String, BTreeMap<String, Line>) {
    let text = std::fs::read_to_string(path).unwrap();
    let header = text.lines().next().unwrap().to_owned();
    let names: Vec<&str> = header.split(',').collect();
    let mut lines = BTreeMap::new();
    for line in text.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        assert_eq!(cells.len(), names.len(), "{line}");
        let line = names.iter().zip(&cells).map(|(name, cell)| ((*name).to_owned(), (*cell).to_owned())).collect();
        assert!(lines.insert(cells[..keys].join(" "), Line(line)).is_none(), "{} twice", cells[..keys].join(" "));
    }
    (header, lines)
}

/// Runs a command as the README has it, into a folder of its own.
fn made(command: &str, scene: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let output = tripos(&[command, scene, "--quick", "--out", folder.path().to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    folder
}

/// Committed and fresh data agree in keys, stops and steps; in errors as far as errors repeat.
///
/// 2 % and a step: another machine rounds sines otherwise, which may move the end of a step. A factor 3: errors near
/// rounding are sums of what was rounded. An error of 1 has no digit left to compare.
fn assert_current(committed: &BTreeMap<String, Line>, fresh: &BTreeMap<String, Line>) {
    assert_eq!(committed.keys().collect::<Vec<_>>(), fresh.keys().collect::<Vec<_>>());
    for (key, old) in committed {
        let new = &fresh[key];
        assert_eq!(old.text("stop"), new.text("stop"), "{key}");
        let (a, b) = (old.number("steps"), new.number("steps"));
        assert!((a - b).abs() <= 0.02 * a.max(b) + 1.0, "{key}: {a} steps were committed, {b} are taken");
        if let (Some(a), Some(b)) = (old.error(), new.error()) {
            let (a, b) = (a.min(1.0), b.min(1.0));
            assert!(a <= 3.0 * b && b <= 3.0 * a, "{key}: an error of {a:e} was committed, it is {b:e}");
        }
    }
}

#[test]
fn the_committed_chart_is_current_and_complete() {
    let folder = made("chart", CHARTED);
    let (header, fresh) = table(&folder.path().join("work_precision.csv"), 4);
    assert_eq!(header, "formulation,solve,method,tolerance,seconds,error,steps,evaluations,stop");
    let (_, committed) = table(&root().join("docs/figures/work_precision.csv"), 4);
    assert_current(&committed, &fresh);
    let tolerances = ["1e-3", "1e-5", "1e-7", "1e-9", "1e-11", "1e-13"];
    for formulation in FORMULATIONS {
        for solve in SOLVES {
            // Taylor coefficients are known of eliminated accelerations only.
            let series = (solve == "eliminated").then_some("taylor");
            for method in ["rk4", "ode45", "dopri5", "dop853", "gauss6", "radau5"].into_iter().chain(series) {
                for tolerance in tolerances {
                    let key = format!("{formulation} {solve} {method} {tolerance}");
                    let line = fresh.get(&key).unwrap_or_else(|| panic!("no {key}"));
                    assert!(line.number("seconds") > 0.0 && line.number("evaluations") > 0.0, "{key}");
                }
            }
        }
    }
    let own = assert_has_own_equations(&fresh, &tolerances);
    assert_eq!(fresh.len(), 3 * (2 * 6 + 1) * tolerances.len() + own);
    assert_shows_what_the_readme_says(&committed);
    let svg = std::fs::read_to_string(folder.path().join("work_precision.svg")).unwrap();
    assert!(svg.starts_with("<svg") && !svg.contains("NaN"));
}

/// The scene's reduced equations stand beside the others, by every method, and by quadrature if that gives the motion:
/// so many lines.
fn assert_has_own_equations(chart: &BTreeMap<String, Line>, tolerances: &[&str]) -> usize {
    for method in ["rk4", "ode45", "dopri5", "dop853", "gauss6", "radau5", "taylor"] {
        for tolerance in tolerances {
            assert!(chart.contains_key(&format!("reduced eliminated {method} {tolerance}")), "{method} {tolerance}");
        }
    }
    // Beyond the finest tolerance that is relative, too, absolute ones alone.
    for (method, most) in [("dop853", 1e-10), ("taylor", 1e-8)] {
        for tolerance in ["1e-14", "1e-15"] {
            let error = chart[&format!("reduced eliminated {method} {tolerance}")].error().expect("arrives");
            assert!(error < most, "{method} at {tolerance}: {error:e}");
        }
    }
    // Finer tolerances never make dop853 worse here, down to 1e-8: an error of another motion would stay.
    let errors = ["1e-7", "1e-9", "1e-11", "1e-13"]
        .map(|tolerance| chart[&format!("reduced eliminated dop853 {tolerance}")].error().expect("arrives"));
    assert!(errors.windows(2).all(|e| e[1] < 0.1 * e[0]) && errors[3] < 1e-8, "{errors:?}");
    match chart.get("reduced - quadrature -") {
        Some(line) => {
            assert!(line.error().expect("arrives") < 1e-12, "by quadrature: {:?}", line.error());
            7 * tolerances.len() + 4 + 1
        }
        None => 7 * tolerances.len() + 4,
    }
}

/// Goal: runs of a scene with outputs are compared in these outputs. The same error of the lean is neither hidden nor
/// caused by other states.
#[test]
fn a_scene_that_states_its_outputs_is_charted_in_them() {
    let out = tempfile::tempdir().unwrap();
    let output = tripos(&["chart", "models/disk/scenes/lean.toml", "--quick", "--out", out.path().to_str().unwrap()]);
    let said = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0), "{said}");
    assert!(said.contains("Errors are those of the scene's outputs: q2, u1.\n"), "{said}");
    let (_, chart) = table(&out.path().join("work_precision.csv"), 4);
    for formulation in ["kane", "lagrange", "newton-euler", "reduced"] {
        // The passages near flat magnify rounding by 1e5; the tolerance is reached but for that.
        let error = chart[&format!("{formulation} eliminated dop853 1e-13")].error().expect("arrives");
        assert!(error < 1e-7, "{formulation}: {error:e}");
    }
}

/// An output that whole states do not show is left out of the comparison, by name, and the chart is drawn.
#[test]
fn outputs_that_need_accelerations_are_not_compared() {
    let folder = tempfile::tempdir().unwrap();
    let model = root().join("models/pendulum/model.toml");
    for (outputs, said) in [
        (
            "\"theta\", \"omega'\", \"total_energy\"",
            "outputs: theta, total_energy. Not compared, since whole states do not show accelerations and reactions: omega'.",
        ),
        (
            "\"omega'\"",
            "Errors are those of all states. Not compared, since whole states do not show accelerations and reactions: omega'.",
        ),
    ] {
        let text = std::fs::read_to_string(root().join("models/pendulum/scenes/swing.toml")).unwrap();
        let text =
            text.replacen("span = ", &format!("model = '{}'\noutputs = [{outputs}]\nspan = ", model.display()), 1);
        let path = folder.path().join("scene.toml");
        std::fs::write(&path, &text).unwrap();
        let output = tripos(&["chart", path.to_str().unwrap(), "--quick", "--out", folder.path().to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
        let printed = String::from_utf8(output.stdout).unwrap();
        assert!(printed.contains(said), "{printed}");
        let (_, chart) = table(&folder.path().join("work_precision.csv"), 4);
        let best = chart["kane eliminated dop853 1e-13"].error().expect("arrives");
        assert!(best < 1e-9, "{outputs}: {best:e}");
    }
}

/// Times are those of the committed data: they are not measured again.
fn assert_shows_what_the_readme_says(chart: &BTreeMap<String, Line>) {
    let least = |formulation: &str, solve: &str| {
        let own = chart.values().filter(|l| l.text("formulation") == formulation && l.text("solve") == solve);
        own.filter_map(Line::error).fold(f64::INFINITY, f64::min)
    };
    for formulation in ["kane", "lagrange"] {
        let [eliminated, numeric] = SOLVES.map(|solve| least(formulation, solve));
        assert!(eliminated < 2e-11 && numeric > 2e-9, "{formulation}: {eliminated:e} eliminated, {numeric:e} numeric");
    }
    for target in [1e-3, 1e-6, 1e-9] {
        let good = chart.values().filter(|line| line.error().is_some_and(|e| e <= target));
        let best =
            good.min_by(|a, b| a.number("seconds").total_cmp(&b.number("seconds"))).expect("something reaches it");
        assert_eq!(best.text("formulation"), "reduced", "to {target:e}");
        assert!(["taylor", "quadrature"].contains(&best.text("method")), "to {target:e}: {}", best.text("method"));
    }
}

#[test]
fn the_committed_passages_are_current_and_show_the_loss() {
    let folder = made("stability", PASSED);
    let (header, fresh) = table(&folder.path().join("passages.csv"), 5);
    assert_eq!(header, "formulation,solve,method,variable,least,error,steps,stop,t");
    let (_, committed) = table(&root().join("docs/figures/passages.csv"), 5);
    assert_current(&committed, &fresh);
    let own = fresh.values().filter(|line| line.text("formulation") == "reduced").count();
    assert_eq!(fresh.len() - own, 3 * 2 * 2 * 2 * 5, "formulation, solve, method, variable, rung");
    let by_quadrature = fresh.contains_key("reduced - quadrature distance 1.00e-1");
    assert_eq!(own, if by_quadrature { 10 } else { 5 }, "a rung each, by dop853 and perhaps by quadrature");
    for (key, line) in fresh.iter().filter(|(_, line)| line.text("formulation") == "reduced") {
        // Four to twenty times what was measured: the issue asks for 5e-13 in 1 100 steps.
        assert!(line.error().expect("arrives") < 5e-13 && line.number("steps") <= 1100.0, "{key}: {:?}", line.0);
    }

    let error = |formulation: &str, variable: &str, least: &str| {
        fresh[&format!("{formulation} eliminated dop853 {variable} {least}")].error()
    };
    for formulation in FORMULATIONS {
        // In the distance every passage is survived, at 10 to 50 times the rounding that the passage magnifies.
        let most = [("1.00e-1", 2e-12), ("1.00e-2", 1e-11), ("1.00e-3", 1e-10), ("1.00e-4", 2e-9), ("1.00e-6", 1e-7)];
        for (least, most) in most {
            let error = error(formulation, "distance", least).expect("arrives");
            assert!(error < most, "{formulation} at {least}: {error:e}");
        }
    }
    for least in ["1.00e-2", "1.00e-3", "1.00e-4"] {
        let [coordinate, distance] = ["coordinate", "distance"].map(|v| error("kane", v, least).expect("arrives"));
        assert!(coordinate > 3.0 * distance, "at {least}: {coordinate:e} in q2, {distance:e} in its distance");
    }
    for least in ["1.00e-2", "1.00e-3", "1.00e-4", "1.00e-6"] {
        let [lagrange, kane] = ["lagrange", "kane"].map(|f| error(f, "coordinate", least));
        let kept = lagrange.expect("arrives");
        assert!(kane.is_none_or(|lost| lost > 3.0 * kept), "at {least}, in q2: {kept:e} by lagrange, {kane:?} by kane");
    }
    for (key, line) in fresh.iter().filter(|(_, line)| line.text("solve") == "numeric") {
        let hard = line.text("formulation") != "newton-euler" && ["1.00e-4", "1.00e-6"].contains(&line.text("least"));
        assert!(!hard || line.error().is_none(), "{key} arrives");
    }
    // Every cell is among the numbers of the whole study, too.
    let all = std::fs::read_to_string(folder.path().join("stability.csv")).unwrap();
    assert!(all.lines().filter(|l| l.starts_with("passage,") && l.contains(",error at the end,")).count() > 60);
    for name in ["ladder.svg", "conditioning.svg"] {
        assert!(std::fs::read_to_string(folder.path().join(name)).unwrap().starts_with("<svg"), "{name}");
    }
}

/// Wrong edits of the scene: the old text, the new text, and the place of the error as line and column.
const WRONG: &[(&str, &str, &str)] = &[
    ("u2 = [1.6", "u9 = [1.6", "23:1"),
    ("u2 = [1.6", "u3 = [0.1]\nu2 = [1.6", "22:1"),
    (
        "[ladder]\nu2 = [1.60619131, 0.8279472526, 0.7465081481, 0.7383250309, 0.737424449158]",
        "[ladder]\nu2 = []",
        "23:6",
    ),
    (
        "[ladder]\nu2 = [1.60619131, 0.8279472526, 0.7465081481, 0.7383250309, 0.737424449158]",
        "[ladder]\nu2 = 1.6",
        "23:6",
    ),
    ("distance = { q2", "distance = { q7", "29:14"),
    ("\"90*deg\"", "\"45*deg\"", "29:20"),
    ("method = \"dop853\"", "method = \"dop853\"\nsolve = \"magic\"", "27:10"),
    ("method = \"dop853\"", "method = \"dop853\"\nstep = 0", "27:8"),
    ("atol = 3e-14", "atol = { q9 = 1 }", "28:10"),
    ("\"passages\"", "\"passes\"", "32:9"),
];

/// A wrong scene is an error with its file, its place and a hint, whatever is asked of it.
#[test]
fn wrong_scenes_are_refused_at_their_place() {
    let folder = tempfile::tempdir().unwrap();
    let model = root().join("models/disk/model.toml");
    let scene = std::fs::read_to_string(root().join(PASSED)).unwrap();
    let path = folder.path().join("scene.toml");
    for (old, new, place) in WRONG {
        assert!(scene.contains(old), "{old}");
        let text = scene.replacen(old, new, 1);
        // On one line with the title, so that places stay those of the scene.
        let text = text.replacen("title = ", &format!("model = '{}' # ", model.display()), 1);
        std::fs::write(&path, text).unwrap();
        for command in ["chart", "stability"] {
            let out = folder.path().join("out");
            let output = tripos(&[command, path.to_str().unwrap(), "--quick", "--out", out.to_str().unwrap()]);
            let message = stderr(&output);
            assert_eq!(output.status.code(), Some(2), "{new}: {message}");
            assert!(message.contains(&format!("scene.toml:{place}\n")), "{new}: not at {place}\n{message}");
            assert!(message.contains("= help: "), "{new}: {message}");
            assert!(!out.exists(), "nothing is written for {new}");
        }
    }
}

#[test]
fn what_is_not_there_or_cannot_be_written_is_answered() {
    for command in ["chart", "stability"] {
        let output = tripos(&[command, "models/disk/scenes/no-such.toml", "--quick"]);
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains("no-such.toml") && message.contains("help: "), "{message}");
        // A file is no folder.
        let output = tripos(&[command, PASSED, "--quick", "--out", "Cargo.toml/figures"]);
        let message = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.contains("cannot write `Cargo.toml/figures`") && message.contains("help: "), "{message}");
        let output = tripos(&[command, PASSED, "--quick", "--out", "Cargo.toml"]);
        assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    }
}
