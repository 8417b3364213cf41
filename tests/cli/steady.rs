//! `tripos equilibria` and `tripos linearise`.

use crate::support::{root, tripos_in};
use serde_json::Value;

const V5: &str = "models/whipple_bicycle/steady/v5.toml";

fn tripos(arguments: &[&str]) -> (i32, String, String) {
    tripos_in(&root(), arguments)
}

/// Goal: programs read a linear system by the names of its parts. Method: the bicycle at 5 m/s, with an output; the
/// eigenvalues are the published ones (Meijaard and others 2007), printed to every digit of a double.
#[test]
fn a_linear_system_is_json() {
    let arguments =
        ["linearise", "models/whipple_bicycle", "--about", V5, "--output", "phi + delta", "--symbolic", "v", "--json"];
    let (status, out, err) = tripos(&arguments);
    assert!(status == 0 && err.is_empty(), "{out}{err}");
    let value: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(value["states"], serde_json::json!(["phi", "delta", "u1", "u2", "u3"]));
    assert_eq!(value["C"], serde_json::json!([[1.0, 1.0, 0.0, 0.0, 0.0]]));
    assert_eq!((value["A"].as_array().unwrap().len(), value["observable"].as_u64()), (5, Some(4)));
    let eigenvalues: Vec<(f64, f64)> = value["eigenvalues"]
        .as_array()
        .unwrap()
        .iter()
        .map(|v| (v[0].as_f64().unwrap(), v[1].as_f64().unwrap()))
        .collect();
    let published = [
        (-0.322_866_429_004_087_1, 0.0),
        (-0.775_341_882_195_841_9, 4.464_867_713_788_225),
        (-14.078_389_692_798_247, 0.0),
    ];
    for (re, im) in published {
        assert!(eigenvalues.iter().any(|(a, b)| (a - re).hypot(b - im) < 1e-13), "{re} {im} {eigenvalues:?}");
    }
    assert!(value["residual"].as_f64().unwrap() < 1e-25, "{}", value["residual"]);
    let slope = value["symbolic"]["A"][3][1].as_str().unwrap();
    assert!(slope.starts_with("30.9087533932") && slope.ends_with("*v^2"), "{slope}");
}

/// Goal: changes of stability with speed are printed. Method: the bicycle from 4 to 7 m/s passes its weave and its
/// capsize speed.
#[test]
fn a_steady_motion_is_followed_along_a_number() {
    let (status, out, err) = tripos(&["equilibria", "models/whipple_bicycle", "--from", V5, "--over", "v=4:7:4"]);
    assert!(status == 0 && err.is_empty(), "{out}{err}");
    assert!(out.contains("v = 4: unstable; 0.413253315 ± 3.079108186i"), "{out}");
    assert!(out.contains("v = 4.29238253634") && out.contains("v = 6.02426201538"), "{out}");
}

/// Goal: people read conditions in closed form, and the documentation shows what the command prints. Method: the
/// commands of docs/steady.md with a `$` in blocks for consoles, run; what follows each is all that it prints.
#[test]
fn closed_forms_are_printed_as_documented() {
    let page = root().join("docs/steady.md");
    let text = std::fs::read_to_string(&page).unwrap();
    let mut parts: Vec<String> = text.split("```console\n$ tripos ").map(str::to_owned).collect();
    assert_eq!(parts.len(), 3);
    for part in &mut parts[1..] {
        let (command, rest) = part.split_once('\n').unwrap();
        let (_, after) = rest.split_once("\n```").unwrap();
        let (status, out, err) = tripos(&command.split_whitespace().collect::<Vec<_>>());
        assert!(status == 0 && err.is_empty(), "{out}{err}");
        *part = format!("{command}\n{}\n```{after}", out.trim_end());
    }
    let printed = parts.join("```console\n$ tripos ");
    if std::env::var_os("UPDATE_EXPECT").is_some_and(|value| value == "1") {
        std::fs::write(&page, &printed).unwrap();
        return;
    }
    assert!(printed == text, "docs/steady.md should read\n{printed}");
}

/// Goal: programs read conditions by the names of their parts, and the conditions that a motion satisfies. Method: the
/// governor of Watt from a state of its scene, whose speed follows from the formula.
#[test]
fn closed_forms_are_json() {
    let from = "models/governor/scenes/hunting.toml";
    let (status, out, err) = tripos(&["equilibria", "models/governor", "--from", from, "--json"]);
    assert!(status == 0 && err.is_empty(), "{out}{err}");
    let value: Value = serde_json::from_str(&out).unwrap();
    let conditions = value["conditions"].as_array().unwrap();
    assert_eq!((conditions.len(), &conditions[0]["rest"]), (2, &serde_json::json!(true)));
    assert_eq!(value["steady"][0]["on"], serde_json::json!({ "conditions": 1, "branches": [0] }));
    let branch = &conditions[1]["branches"][0];
    assert_eq!(branch["needs"][0]["formula"], "cos(theta) >= 0");
    expect_test::expect![[r#"
        {
          "name": "psi'^2",
          "formula": "3*g*(2*m + mb + ms)/(l*cos(theta)*(2*m + 3*mb))",
          "latex": "\\dot{\\psi}^{2} = \\frac{3 \\, g \\, \\left(2 \\, m + \\mathrm{mb} + \\mathrm{ms}\\right)}{l \\, \\cos \\theta \\, \\left(2 \\, m + 3 \\, \\mathrm{mb}\\right)}"
        }"#]].assert_eq(&serde_json::to_string_pretty(&branch["solved"][3]).unwrap());
    let (theta, spin) = (&value["steady"][0]["at"]["theta"], &value["steady"][0]["at"]["spin"]);
    // m, mb, ms, l and g of the model.
    let square = (0.1 + 0.25 + 0.5) * 9.81 / ((0.25 + 0.1 / 3.0) * 0.2 * theta.as_f64().unwrap().cos());
    assert!((spin.as_f64().unwrap() - square.sqrt()).abs() < 1e-12 * square.sqrt(), "{spin}");
    let (status, _, err) = tripos(&["equilibria", "models/governor", "--for", "thta"]);
    assert!(status == 2 && err.contains("`thta`") && err.contains("help:"), "{err}");
}

/// Goal: every way to be wrong is told with what to do. Method: one of each.
#[test]
fn wrong_questions_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let file = |text: &str| {
        let path = folder.path().join("state.toml");
        std::fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let cases = [
        ("[state]\ntheta = 0.5\nomega = 0\n", vec![], "is not an equilibrium"),
        ("[state]\ntheta = 0\n", vec![], "no value is given to omega"),
        ("[state]\ntheta = 0\nomega = 0\n[guess]\ntheta = 1\n", vec![], "stated and guessed"),
        ("[names]\n\"a b\" = 1\n[state]\ntheta = 0\nomega = 0\n", vec![], "`a b` cannot be a name"),
        ("[names]\nl = 1\n[state]\ntheta = 0\nomega = 0\n", vec![], "`l` is a name of the model"),
        ("[state]\ntheta = 0\nomega = 0\n", vec!["--input", "force"], "no input `force`"),
        ("[state]\ntheta = 0\nomega = 0\n", vec!["--output", "thta"], "unknown name `thta`"),
        ("[state]\ntheta = 0\nomega = 0\n", vec!["--symbolic", "x"], "`x` is neither a parameter nor a name"),
    ];
    for (text, more, expected) in cases {
        let path = file(text);
        let arguments: Vec<&str> = ["linearise", "models/pendulum", "--about", &path].into_iter().chain(more).collect();
        let (status, out, err) = tripos(&arguments);
        assert!(status == 2 && err.contains(expected) && err.contains("help:"), "{expected}: {out}{err}");
    }
    let path = file("[state]\ntheta = 0\nomega = 0\n");
    for over in ["g", "g=1:2", "g=1:2:1", "q=1:2:3", "g=a:2:3"] {
        let (status, _, err) = tripos(&["equilibria", "models/pendulum", "--from", &path, "--over", over]);
        assert!(status == 2 && err.contains("help:"), "{over}: {err}");
    }
}

/// Goal: only true changes of stability are told, however few values are asked for. Method: the bicycle below 1 m/s,
/// where two real eigenvalues meet at 0.684 m/s and become the weave (the double root of Meijaard and others 2007), and
/// from there to 10 m/s in one step.
#[test]
fn eigenvalues_that_meet_pass_nothing() {
    let over = |range: &str| {
        let (status, out, err) =
            tripos(&["equilibria", "models/whipple_bicycle", "--from", V5, "--over", range, "--json"]);
        assert!(status == 0 && err.is_empty(), "{out}{err}");
        let value: Value = serde_json::from_str(&out).unwrap();
        value["crossings"]
            .as_array()
            .unwrap()
            .iter()
            .map(|c| (c["kind"].clone(), c["value"].as_f64().unwrap()))
            .collect()
    };
    let below: Vec<(Value, f64)> = over("v=0.5:1:2");
    assert!(below.is_empty(), "{below:?}");
    let all: Vec<(Value, f64)> = over("v=0.5:10:2");
    let known = [("pair", 4.292_382_536_341_11), ("real", 6.024_262_015_388_37)];
    assert_eq!(all.len(), 2, "{all:?}");
    for ((kind, value), (its, published)) in all.iter().zip(known) {
        assert!(kind == its && (value - published).abs() < 1e-12, "{all:?}");
    }
}

/// Goal: stability is mapped over two numbers. Method: the sliding disk that spins upright is stable from u3² = g/R on,
/// and the one that pivots from u2² = 4 g/R on, at each of several radii; with a figure and its data.
#[test]
fn stability_is_mapped_over_two_numbers() {
    let folder = tempfile::tempdir().unwrap();
    let state = folder.path().join("upright.toml");
    for (moved, held, limit) in [("u3", "u2", 1.0), ("u2", "u3", 4.0)] {
        let text = format!(
            "[parameters]\nM = 1\ng = 9.81\n[state]\nq1 = 0\nq2 = 0\nq3 = 0\nq4 = 0\nq5 = 0\nu1 = 0\n{held} = 0\n{moved} = 2\nu4 = 0\nu5 = 0\n"
        );
        std::fs::write(&state, text).unwrap();
        let out = folder.path().join("map.svg");
        let range = format!("{moved}=2:12:6");
        let (status, said, err) = tripos(&[
            "equilibria",
            "models/disk",
            "--from",
            state.to_str().unwrap(),
            "--over",
            &range,
            "--over",
            "R=0.5:2:4",
            "--out",
            out.to_str().unwrap(),
            "--json",
        ]);
        assert!(status == 0 && err.contains("map.svg"), "{said}{err}");
        let value: Value = serde_json::from_str(&said).unwrap();
        let rows = value["rows"].as_array().unwrap();
        assert_eq!((rows.len(), &value["over"][1]), (4, &serde_json::json!("R")));
        for row in rows {
            let known = (limit * 9.81 / row["value"].as_f64().unwrap()).sqrt();
            let found: Vec<f64> =
                row["crossings"].as_array().unwrap().iter().map(|c| c["value"].as_f64().unwrap()).collect();
            assert!(found.len() == 1 && (found[0] - known).abs() < 1e-12 * known, "{moved}: {found:?}, not {known}");
        }
        assert!(std::fs::read_to_string(&out).unwrap().contains("a real eigenvalue passes 0"));
        assert_eq!(std::fs::read_to_string(out.with_extension("csv")).unwrap().lines().count(), 5);
    }
    for (wrong, what) in [
        (["--over", "v=1:2:3", "--over", "v=1:3:3"], "two different numbers"),
        (["--over", "v=1:2:3", "--out", "map.jpg"], "ends in .svg"),
    ] {
        let arguments = [&["equilibria", "models/whipple_bicycle", "--from", V5][..], &wrong[..]].concat();
        let (status, _, err) = tripos(&arguments);
        assert!(status == 2 && err.contains(what), "{err}");
    }
}

/// Goal: a program in Python gets the matrices to the last digit, as numbers and as functions of a symbol. Method: the
/// program is run, with as much of `NumPy` as it names, and compared with the JSON.
#[test]
fn a_linear_system_in_python_is_that_of_the_json() {
    if crate::sympy::is_left_out("a linear system in Python") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let numpy = "from math import *\ndef array(rows): return rows\ndef zeros(shape): return [[0.0] * shape[1] for _ in range(shape[0])]\n";
    std::fs::write(folder.path().join("numpy.py"), numpy).unwrap();
    let base = ["linearise", "models/whipple_bicycle", "--about", V5, "--output", "phi + delta", "--input", "g"];
    let (_, json, _) = tripos(&[&base[..], &["--json"]].concat());
    let expected: Value = serde_json::from_str(&json).unwrap();
    for (letters, call, bound) in
        [(&[][..], "A, B, C, D", 0.0), (&["--symbolic", "v"], "A(5.0), B(5.0), C(5.0), D(5.0)", 1e-11)]
    {
        let (status, out, err) = tripos(&[&base[..], letters, &["--format", "python"]].concat());
        assert!(status == 0 && err.is_empty(), "{out}{err}");
        let program = format!("{out}\nimport json\nprint(json.dumps([states, inputs, {call}]))\n");
        std::fs::write(folder.path().join("system.py"), &program).unwrap();
        let python = std::env::var_os("TRIPOS_PYTHON").filter(|p| !p.is_empty()).unwrap_or_else(|| "python3".into());
        let run = std::process::Command::new(python).arg("system.py").current_dir(folder.path()).output().unwrap();
        let found: Value = serde_json::from_slice(&run.stdout)
            .unwrap_or_else(|_| panic!("{program}\n{}", String::from_utf8_lossy(&run.stderr)));
        assert_eq!((&found[0], &found[1]), (&expected["states"], &expected["inputs"]));
        for (at, name) in ["A", "B", "C", "D"].into_iter().enumerate() {
            let entries = |value: &Value| -> Vec<f64> {
                value
                    .as_array()
                    .unwrap()
                    .iter()
                    .flat_map(|row| row.as_array().unwrap())
                    .map(|x| x.as_f64().unwrap())
                    .collect()
            };
            let (found, expected) = (entries(&found[at + 2]), entries(&expected[name]));
            assert_eq!(found.len(), expected.len(), "{name}");
            assert!(
                found.iter().zip(&expected).all(|(a, b)| (a - b).abs() <= bound * (1.0 + b.abs())),
                "{name}: {found:?} {expected:?}"
            );
        }
    }
}

/// Goal: documents and MATLAB have the same system as the text. Method: a pole on a cart with an input and an output,
/// in both.
#[test]
fn a_linear_system_is_written_for_documents_and_for_matlab() {
    let folder = tempfile::tempdir().unwrap();
    let tutorial = std::fs::read_to_string(root().join("docs/tutorial/control.md")).unwrap();
    for name in ["model.toml", "upright.toml"] {
        let block = tutorial.split(&format!("```toml cart/{name}\n")).nth(1).unwrap().split("\n```").next().unwrap();
        std::fs::write(folder.path().join(name), block).unwrap();
    }
    let ask = |format: &str| {
        let (status, out, err) = tripos_in(
            folder.path(),
            &["linearise", "model.toml", "--about", "upright.toml", "--output", "theta", "--format", format],
        );
        assert!(status == 0 && err.is_empty(), "{out}{err}");
        out.lines().skip(2).collect::<Vec<_>>().join("\n")
    };
    expect_test::expect![[r"
        % eigenvalue 5.567955608637 1/s: theta, omega
        % eigenvalue -0.142831661704 1/s: v
        % eigenvalue -5.606942128752 1/s: theta, omega
        % six significant digits; needs amsmath
        \[ \dot x = A x + B u, \qquad y = C x + D u \]
        \[ x = \begin{pmatrix} \theta \\ v \\ \omega \end{pmatrix}, \quad u = \begin{pmatrix} F \end{pmatrix}, \quad y = \begin{pmatrix} \theta \end{pmatrix} \]
        \[ A = \begin{pmatrix}
          0 & 0 & 1 \\
          2.67545 & -0.181818 & 0 \\
          31.2136 & -0.454545 & 0
        \end{pmatrix} \]
        \[ B = \begin{pmatrix}
          0 \\
          1.81818 \\
          4.54545
        \end{pmatrix} \]
        \[ C = \begin{pmatrix}
          1 & 0 & 0
        \end{pmatrix} \]
        \[ D = \begin{pmatrix}
          0
        \end{pmatrix} \]"]].assert_eq(&ask("latex"));
    expect_test::expect![[r"
        % eigenvalue 5.567955608637 1/s: theta, omega
        % eigenvalue -0.142831661704 1/s: v
        % eigenvalue -5.606942128752 1/s: theta, omega
        states = {'theta', 'v', 'omega'};
        inputs = {'F'};
        outputs = {'theta'};
        A = [0.0, 0.0, 1.0; ...
             2.6754545454545453, -0.18181818181818182, 0.0; ...
             31.213636363636365, -0.45454545454545453, 0.0];
        B = [0.0; ...
             1.8181818181818181; ...
             4.545454545454546];
        C = [1.0, 0.0, 0.0];
        D = [0.0];
        % with the Control System Toolbox:
        % sys = ss(A, B, C, D, 'StateName', states, 'InputName', inputs, 'OutputName', outputs);"]]
    .assert_eq(&ask("matlab"));
}
