//! `tripos simulate --rigorous`: boxes, ranges, claims, exit statuses and refusals.

use crate::support::{SLIDER, tripos_in};
use expect_test::expect;
use serde_json::Value;

const SCENE: &str = r#"
model = "model.toml"
span = [0, "pi"]
[start]
x = 1
u = 0
[integration]
samples = 3
"#;

fn slider(model: &str, scene: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.toml"), model).unwrap();
    std::fs::write(folder.path().join("scene.toml"), scene).unwrap();
    folder
}

/// Truth: x = cos t, u = −sin t at m = k = 1.
#[test]
fn boxes_ranges_and_claims_are_printed() {
    let folder = slider(SLIDER, SCENE);
    let claims = ["--claim", "x < 1.001", "--claim", "u > -1/2"];
    let (status, out, err) =
        tripos_in(folder.path(), &[&["simulate", "scene.toml", "--rigorous"][..], &claims].concat());
    assert_eq!(status, 1, "a claim is false: {err}");
    let ranges: Vec<&str> = out.lines().skip_while(|line| !line.starts_with("proved for all t")).collect();
    expect![[r"
        proved for all t from 0 s to 3.14159 s
          x is between -1.00235 and 1.00034
          u is between -1.00543 and 8.88732e-4

        x < 1.001: proved at all instants
        u > -1/2: proved to be false at an instant before t = 0.523607 s, and proved up to t = 0.523592 s"]]
    .assert_eq(&ranges.join("\n"));
    assert!(out.contains("enclosed in balls of 32 digits") && out.contains("the motion exists up to t = 3.14159 s"));
}

#[test]
fn json_and_tables_have_the_bounds() {
    let folder = slider(SLIDER, SCENE);
    let args = ["simulate", "scene.toml", "--rigorous", "--claim", "x > -2", "--json", "--csv", "boxes.csv"];
    let (status, out, err) = tripos_in(folder.path(), &args);
    assert_eq!(status, 0, "{err}");
    let whole: Value = serde_json::from_str(&out).unwrap();
    let bound = |path: &str| whole.pointer(path).and_then(Value::as_f64).unwrap_or_else(|| panic!("{path} of {whole}"));
    assert!(bound("/box/x/0") <= -1.0 && bound("/box/x/1") >= -1.0 && bound("/box/x/1") < -0.999_999_999_999);
    assert!(bound("/boxes/0/box/u/0") <= -1.0 && bound("/boxes/0/box/u/1") >= -1.0);
    assert!(bound("/box_in_32_digits/x/radius") < 1e-25);
    assert_eq!((&whole["end"], &whole["claims"][0]["verdict"]), (&"reached".into(), &"proved".into()));
    let table = std::fs::read_to_string(folder.path().join("boxes.csv")).unwrap();
    assert_eq!(table.lines().next(), Some("t,x low,x high,u low,u high"));
    assert_eq!(table.lines().count(), 3);
}

#[test]
fn what_cannot_be_enclosed_is_refused_with_a_reason() {
    let contact = "\n[impacts.wall]\ngap = \"p(P) @ A [1] + 2*m/m\"\nrestitution = 0.5\n";
    for (scene, args, message) in [
        (SCENE.to_owned() + contact, &[][..], "a rigorous run has no contacts"),
        (SCENE.replace("[0, \"pi\"]", "[1, 0]"), &[][..], "a rigorous run goes forwards in time"),
        (SCENE.to_owned(), &["--claim", "y < 1"][..], "--claim:1:1"),
        (SCENE.to_owned(), &["--claim", "x <= 1"][..], "a claim has a strict sign"),
        (SCENE.to_owned(), &["--claim", "x = 1"][..], "is not understood"),
        (SCENE.to_owned() + "[[claims]]\nclaim = \"x < z\"\n", &[][..], "scene.toml:"),
        (SCENE.to_owned() + "[[claims]]\nclaim = 3\n", &[][..], "a claim must be a string"),
        (SCENE.to_owned() + "[[claims]]\nabout = \"x\"\n", &[][..], "`claim`"),
        (SCENE.to_owned(), &["--claim", "x < 1 +"][..], "--claim:1:"),
        (SCENE.to_owned(), &["--sensitivity", "x"][..], "cannot be used with"),
    ] {
        let folder = slider(SLIDER, &scene);
        let (status, _, err) =
            tripos_in(folder.path(), &[&["simulate", "scene.toml", "--rigorous"][..], args].concat());
        assert_eq!(status, 2, "{args:?}: {err}");
        assert!(err.contains(message), "{args:?}: {err}");
    }
}

/// Truth: x = cos t falls through 1/2 at π/3, and T + V = 1/2 J.
#[test]
fn events_and_claims_of_a_scene_are_printed() {
    let more = "[[events]]\nname = \"half\"\nzero = \"x - 0.5*m/m\"\ndirection = \"falling\"\nterminal = true\n\
                [[claims]]\nclaim = \"x > 0.49\"\n\
                [[claims]]\nclaim = \"determinant > 0.99*m\"\nby = \"kane\"\n";
    let folder = slider(SLIDER, &(SCENE.to_owned() + more));
    let (status, out, err) = tripos_in(folder.path(), &["simulate", "scene.toml", "--rigorous"]);
    assert_eq!(status, 0, "{err}");
    assert!(err.contains("the claim `determinant > 0.99*m` is about other equations: run with `--by kane`"), "{err}");
    assert!(out.contains("an event ends the motion by t = 1.0472 s"), "{out}");
    assert!(
        out.contains("event half: proved once at t = 1.0471975511965") && out.contains("x > 0.49: proved"),
        "{out}"
    );
    let (status, out, err) =
        tripos_in(folder.path(), &["simulate", "scene.toml", "--rigorous", "--by", "kane", "--json"]);
    assert_eq!(status, 0, "{err}");
    let whole: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&whole["end"], &whole["events"][0]["crossings"]), (&"event".into(), &"one".into()));
    let instant = |key: &str| whole["events"][0][key].as_f64().unwrap();
    let truth = std::f64::consts::FRAC_PI_3;
    assert!(instant("from") <= truth && truth <= instant("to") && instant("to") - instant("from") < 1e-14, "{whole}");
    assert_eq!(whole["claims"][0]["verdict"], "proved");
}
