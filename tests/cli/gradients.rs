//! `tripos simulate --gradient`: what it prints, and what does not go together with it.

use crate::support::{SLIDER, tripos_in};
use expect_test::expect;
use serde_json::Value;

const SCENE: &str = r#"
model = "model.toml"
span = [0, 2]
[start]
x = 1
u = 0
[integration]
method = "dop853"
rtol = 1e-12
atol = 1e-12
[[events]]
name = "centre"
zero = "x"
terminal = true
"#;

fn slider(scene: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.toml"), SLIDER).unwrap();
    std::fs::write(folder.path().join("scene.toml"), scene).unwrap();
    folder
}

/// The lines of the gradient, with nine decimals of each derivative and without its error, of which only the size is
/// reproducible.
fn gradient(text: &str) -> String {
    let lines = text.lines().skip_while(|line| !line.starts_with("gradient of")).map(|line| {
        let Some((before, rest)) = line.split_once(" ± ") else { return line.to_owned() };
        let (error, unit) = rest.split_once(' ').unwrap_or((rest, ""));
        assert!(error.parse::<f64>().unwrap() < 1e-10, "{line}");
        let (name, value) = before.rsplit_once(' ').unwrap();
        format!("{name} {:.9} ± … {unit}", value.parse::<f64>().unwrap() + 0.0).trim_end().to_owned()
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// Goal: the gradient is printed, a line for each number. Truth: x = x₀ cos ω t + u₀/ω sin ω t with ω = √(k/m) meets 0
/// at t = π/(2 ω) + u₀/(x₀ ω²) to first order, with the rate −x₀ ω: closed forms at x₀ = ω = m = 1.
#[test]
fn a_gradient_is_printed_a_line_for_each_number() {
    let folder = slider(SCENE);
    let (status, out, err) = tripos_in(folder.path(), &["simulate", "scene.toml", "--gradient", "t"]);
    assert_eq!(status, 0, "{err}");
    // π/2.
    assert!(out.contains("gradient of t at t = 1.5708 s"), "{out}");
    let text = gradient(&out).split_once('\n').unwrap().1.to_owned();
    // π/4, −π/4, 0 and 1.
    expect![[r"
          by m  0.785398163 ± … s/kg
          by k  -0.785398163 ± … s^3/kg
          by x  0.000000000 ± … s/m
          by u  1.000000000 ± … s^2/m
        errors of the derivatives, by comparison with dop853 at a tenth of the tolerances"]]
    .assert_eq(&text);
    let (_, plain, _) = tripos_in(folder.path(), &["simulate", "scene.toml", "--by", "kane"]);
    assert!(out.starts_with(plain.trim_end()), "the run is that without:\n{plain}\n{out}");
}

/// Goal: a gradient through an impact is printed. Truth: with a wall at 0 and restitution ½, x = −x₀/2 cos ω t until 3
/// π/(2 ω): closed forms at 2.5 s. From a start on the wall there is no derivative by the place.
#[test]
fn a_gradient_through_an_impact_is_printed_and_what_has_none_says_why() {
    let scene = SCENE.split("[[events]]").next().unwrap().replace("[0, 2]", "[0, 2.5]");
    let wall = "[impacts.wall]\ngap = \"x\"\nrestitution = 0.5\n";
    let folder = slider(&(scene.clone() + wall));
    let (status, out, err) = tripos_in(folder.path(), &["simulate", "scene.toml", "--gradient", "x"]);
    assert_eq!(status, 0, "{err}");
    // −t sin(t)/4, its opposite, −cos(t)/2 and −sin(t)/2.
    expect![[r"
        gradient of x at t = 2.5 s, at that instant
          by m  -0.374045090 ± … m/kg
          by k  0.374045090 ± … m*s^2/kg
          by x  0.400571808 ± …
          by u  -0.299236072 ± … s
        errors of the derivatives, by comparison with dop853 at a tenth of the tolerances"]]
    .assert_eq(&gradient(&out));
    let folder = slider(&(scene.replace("x = 1\nu = 0", "x = 0\nu = -1") + wall));
    let (status, out, err) = tripos_in(folder.path(), &["simulate", "scene.toml", "--gradient", "x"]);
    let why = "from t = 0 s on: the contact `wall` is closed at the start, and `x` opens it";
    assert!(status == 0 && out.contains(&format!("by x  no value: {why}")), "{out}");
    assert!(err.contains(&format!("there is no derivative by `x`: {why}")), "{err}");
}

#[test]
fn a_gradient_is_a_list_in_json() {
    let folder = slider(&SCENE.replace("terminal = true", ""));
    let (status, out, err) =
        tripos_in(folder.path(), &["simulate", "scene.toml", "--gradient", "x", "--method", "gauss6", "--json"]);
    let run: Value = serde_json::from_str(&out).unwrap_or_else(|_| panic!("{status} {err}"));
    assert!((&run["gradient_of"], &run["gradient_is_total"]) == (&Value::from("x"), &Value::from(false)), "{run}");
    assert_eq!(run["method"], "dop853", "what was run");
    assert!(err.contains("the method gauss6 has no gradient: the run is by dop853, to the same tolerances"), "{err}");
    let (s, c) = 2_f64.sin_cos();
    let list = run["gradient"].as_array().unwrap();
    assert_eq!(list.len(), 4);
    // dx/dω = −t sin ω t, dω/dm = −1/2, dω/dk = 1/2.
    for (slope, (name, truth)) in list.iter().zip([("m", s), ("k", -s), ("x", c), ("u", s)]) {
        let (value, error) = (slope["value"].as_f64().unwrap(), slope["error"].as_f64().unwrap());
        assert_eq!((slope["name"].as_str(), &slope["missing"]), (Some(name), &Value::Null));
        assert!((value - truth).abs() <= 30.0 * error && error < 1e-9, "{name}: {value} ± {error}, not {truth}");
    }
    assert!(run["gradient_assessed_by"].as_str().unwrap().starts_with("dop853"), "{run}");
}

#[test]
fn what_does_not_go_together_with_a_gradient_is_refused_with_its_reason() {
    let folder = slider(SCENE);
    let refused = |more: &[&str]| {
        let (status, out, err) =
            tripos_in(folder.path(), &[&["simulate", "scene.toml", "--gradient", "x"], more].concat());
        assert!(out.is_empty(), "{out}");
        format!("{status}: {err}")
    };
    expect![[r"
        2: error: --gradient and --sensitivity are two runs
        help: give one of the two: --gradient differentiates one value with respect to all numbers, --sensitivity all shown values with respect to one
    "]]
    .assert_eq(&refused(&["--sensitivity", "m"]));
    expect![[r"
        2: error: a gradient belongs to the end of a run, and --csv writes samples along the run
        help: leave --csv out, or give --sensitivity, whose derivatives are known at each sample
    "]]
    .assert_eq(&refused(&["--csv", "out.csv"]));
    let (_, _, err) = tripos_in(folder.path(), &["simulate", "scene.toml", "--gradient", "xx"]);
    expect![[r"
        error: the scene shows no `xx`
        help: did you mean `x`?
    "]]
    .assert_eq(&err);
}
