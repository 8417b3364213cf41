//! Numbers that once were others than their names said, or were none, and inputs that no model can have.

use crate::support::{answer, answer_in_json, root};
use serde_json::Value;

/// A file of `tests/data/repro`.
fn given(file: &str) -> String {
    root().join("tests/data/repro").join(file).to_str().unwrap().to_owned()
}

/// A scene in a folder of its own.
fn scene(text: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    std::fs::write(&path, text).unwrap();
    let path = path.to_str().unwrap().to_owned();
    (folder, path)
}

/// A scene of a model of the library.
fn scene_of(model: &str, text: &str) -> (tempfile::TempDir, String) {
    let model = root().join("models").join(model).join("model.toml");
    scene(&format!("model = {:?}\n{text}", model.to_str().unwrap()))
}

/// Kane's equations of this mechanism at 1e-13, solved at each state: see `random_scenes`.
#[test]
fn an_acceleration_among_the_outputs_is_that_acceleration() {
    let right = [("u1'", -13.947_255_287_69), ("u1", -0.463_036_791_49), ("th", -2.728_875_867_18)];
    for way in [&[][..], &["--by", "kane"], &["--by", "lagrange", "--solve", "numeric"], &["--method", "taylor"]] {
        let found = answer_in_json(&[&["simulate", &given("outputs/s.toml"), "--json"], way].concat());
        for (name, value) in right {
            let x = found["state"][name].as_f64().unwrap();
            assert!((x - value).abs() < 1e-8, "{way:?}: {name} = {x}, not {value}");
        }
    }
}

/// A reaction in the domain is found beside the equations: they stay eliminated, and methods that need that can run
/// them.
#[test]
fn a_watched_reaction_leaves_the_way_to_accelerations_alone() {
    for method in ["taylor", "gauss6", "radau5", "dop853"] {
        let run = answer_in_json(&[
            "simulate",
            &given("reaction_domain/s.toml"),
            "--method",
            method,
            "--rtol",
            "1e-9",
            "--atol",
            "1e-9",
            "--json",
        ]);
        assert_eq!((run["solve"].as_str(), run["stop"].as_str()), (Some("eliminated"), Some("end")), "{method}");
    }
}

#[test]
fn a_start_where_a_momentum_loses_its_hold_is_run_without_it() {
    let (status, out, err) = answer(&["simulate", &given("pole_start/s.toml"), "--json"]);
    assert_eq!(status, 0, "{err}");
    assert!(
        err.contains("no momentum is held, since the rate of `phi` has no value at the start, where sin("),
        "{err}"
    );
    let run: Value = serde_json::from_str(&out).unwrap();
    // From the top with 0.3 rad/s: theta″ = g/l sin(theta) about the pole, nothing turns.
    let fall = |t: f64| std::f64::consts::PI + 0.3 / 9.81_f64.sqrt() * (9.81_f64.sqrt() * t).sin();
    assert_eq!(run["state"]["phi"], 0.4);
    assert!((run["state"]["theta"].as_f64().unwrap() - fall(1.0)).abs() < 1e-3, "small about the lowest point: {out}");
}

#[test]
fn what_a_run_shows_without_a_value_is_no_result() {
    // In a plane through the axis the azimuth has no rate at the lowest point: 0/0 of the held momentum.
    let text = "span = [0, 5]\n[start]\ntheta = 1\nphi = 0\n\"theta'\" = 0\n\"phi'\" = 0\n[integration]\nmethod = \"dop853\"\n";
    let (_folder, path) = scene_of("spherical_pendulum", text);
    let (status, out, err) = answer(&["simulate", &path, "--json"]);
    assert_eq!(status, 3, "{out}{err}");
    assert!(err.contains("`u2` has no value at t = 0.53") && err.contains("where sin(theta) = 0"), "{err}");
    let run: Value = serde_json::from_str(&out).unwrap();
    assert!(run["state"]["u2"].is_null() && run["failure"].as_str().unwrap().contains("u2"), "{out}");

    let text = "span = [0, 5]\noutputs = [\"sqrt(theta)\"]\n[start]\ntheta = 1\nomega = 0\n";
    let (_folder, path) = scene_of("pendulum", text);
    for way in [&[][..], &["--by", "kane"]] {
        let (status, _, err) = answer(&[&["simulate", path.as_str()], way].concat());
        assert!(status == 3 && err.contains("`sqrt(theta)` has no value at t = "), "{way:?}: {err}");
    }
}

/// Goal: a run whose steps are limited by stability gets advice. Method: m x″ = −c x′ − k x with c/m = 10⁴ 1/s: after
/// the first millisecond x creeps back in a second, and an explicit method still steps by 3·10⁻⁴ s. Runs of few steps,
/// and methods that stability does not limit, get no advice.
#[test]
fn steps_that_stability_keeps_short_are_said_to_be() {
    let folder = tempfile::tempdir().unwrap();
    let model = "name = \"Damped\"\n[parameters]\nm = { unit = \"kg\", value = 1, positive = true }\nc = { unit = \"N*s/m\", value = 1e4 }\n\
                 k = { unit = \"N/m\", value = 1e4 }\n[coordinates]\nx = { unit = \"m\" }\n[speeds]\nv = \"x'\"\n\
                 [inertial]\nframe = \"N\"\norigin = \"O\"\n[points]\nP = { from = \"O\", frame = \"N\", position = [\"x\", 0, 0] }\n\
                 [particles]\nb = { point = \"P\", mass = \"m\" }\n[forces.f]\non = \"b\"\nframe = \"N\"\nvector = [\"-c*v - k*x\", 0, 0]\n";
    std::fs::write(folder.path().join("model.toml"), model).unwrap();
    let scene = folder.path().join("s.toml");
    std::fs::write(&scene, "model = \"model.toml\"\nspan = [0, 10]\n[start]\nx = 1\nv = 0\n").unwrap();
    let scene = scene.to_str().unwrap();
    let (status, _, err) = answer(&["simulate", scene]);
    assert!(
        status == 0 && err.contains("note: explicit steps are limited by stability here, not by accuracy: 3"),
        "{err}"
    );
    for way in [&["--method", "gauss6"][..], &["--method", "radau5"], &["--until", "0.3"]] {
        let (status, _, err) = answer(&[&["simulate", scene], way].concat());
        assert!(status == 0 && !err.contains("stability"), "{way:?}: {err}");
    }
    // What is said is what a run by that method takes, also where the explicit one is given up.
    for limit in ["", "step_limit = 3000\n"] {
        let text = std::fs::read_to_string(scene).unwrap();
        std::fs::write(scene, format!("{text}[integration]\nmethod = \"dop853\"\n{limit}")).unwrap();
        let (_, out, err) = answer(&["simulate", scene, "--json"]);
        let run: Value = serde_json::from_str(&out).unwrap_or_else(|_| panic!("{err}"));
        let notes: Vec<&str> = run["notes"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
        let implicit: Value =
            serde_json::from_str(&answer(&["simulate", scene, "--method", "radau5", "--json"]).1).unwrap();
        let said = format!("radau5 takes {} at the same tolerances", implicit["steps"]);
        let to = if limit.is_empty() { "" } else { " to t = 10 s" };
        assert!(notes.iter().any(|note| note.ends_with(&format!("{said}{to}"))), "{said}{to}: {notes:?}");
        assert_eq!(run["stop"] == "step-limit", !limit.is_empty(), "{run}");
        std::fs::write(scene, text).unwrap();
    }
}

#[test]
fn a_sweep_shows_what_its_scene_asks_for() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("rows.csv");
    let table = table.to_str().unwrap();
    let (status, _, err) = answer(&["sweep", &given("outputs/s.toml"), "--over", "m=0.5,0.6", "--out", table]);
    assert_eq!(status, 0, "{err}");
    let mut rows = csv::Reader::from_path(table).unwrap();
    let headers = rows.headers().unwrap().clone();
    let at = headers.iter().position(|name| name == "u1'").expect("a column for the acceleration");
    let first = rows.records().next().unwrap().unwrap();
    let found: f64 = first[at].parse().unwrap();
    assert!((found + 13.947_255_287_69).abs() < 1e-8, "{found}");
}

#[test]
fn an_absolute_tolerance_alone_raises_no_false_alarm() {
    let text =
        "span = [0, 5]\n[start]\ntheta = 1\nomega = 0\n[integration]\nmethod = \"dop853\"\nrtol = 0\natol = 1e-14\n";
    let (_folder, path) = scene_of("pendulum", text);
    let (status, _, err) = answer(&["simulate", &path]);
    assert!(status == 0 && !err.contains("do not trust"), "{err}");
    // An energy of 5e-16 J is what is left of 10 J and −10 J: it is not known better than to their rounding.
    let text = "span = [0, 10]\n[start]\ntheta = 1e-8\nomega = 0\n[integration]\nmethod = \"dop853\"\nrtol = 1e-10\natol = 1e-18\n";
    let (_folder, path) = scene_of("pendulum", text);
    let (status, _, err) = answer(&["simulate", &path]);
    assert!(status == 0 && !err.contains("do not trust"), "{err}");
}

#[test]
fn no_run_has_a_body_that_cannot_be() {
    // Without mass nothing resists: no way to accelerations may say otherwise.
    for way in [&[][..], &["--by", "kane"], &["--by", "lagrange"], &["--by", "newton-euler", "--solve", "numeric"]] {
        let (status, out, err) = answer(&[&["simulate", &given("massless/s.toml")], way].concat());
        assert_eq!(status, 2, "{way:?}: {out}{err}");
        assert!(err.contains("`omega` moves no mass of its own where m = 0"), "{way:?}: {err}");
    }
    // Of a parameter that may have any sign, where the scene states it.
    let folder = tempfile::tempdir().unwrap();
    let model = std::fs::read_to_string(given("massless/model.toml")).unwrap().replace("value = 0,", "value = 1,");
    std::fs::write(folder.path().join("model.toml"), model).unwrap();
    let (scene, state) = (folder.path().join("s.toml"), folder.path().join("state.toml"));
    std::fs::write(
        &scene,
        "model = \"model.toml\"\nspan = [0, 1]\n[parameters]\nm = -1\n[start]\ntheta = 1\nomega = 0\n",
    )
    .unwrap();
    let (status, _, err) = answer(&["simulate", scene.to_str().unwrap()]);
    assert!(status == 2 && err.contains("the mass of `bob` is -1") && err.contains("s.toml:4:5"), "{err}");
    std::fs::write(&state, "[parameters]\nm = -1\n[state]\ntheta = 1\nomega = 0\n").unwrap();
    let model = folder.path().join("model.toml");
    let evaluate = ["evaluate", model.to_str().unwrap(), "--by", "kane", "--at", state.to_str().unwrap()];
    let (status, _, err) = answer(&evaluate);
    assert!(status == 2 && err.contains("the mass of `bob` is -1"), "{err}");
    // Each point of a sweep is a scene.
    let table = folder.path().join("rows.csv");
    std::fs::write(&scene, "model = \"model.toml\"\nspan = [0, 1]\n[start]\ntheta = 1\nomega = 0\n").unwrap();
    let sweep = ["sweep", scene.to_str().unwrap(), "--over", "m=-1,0,1", "--out", table.to_str().unwrap()];
    let (status, _, err) = answer(&sweep);
    let rows = std::fs::read_to_string(&table).unwrap();
    assert_eq!(status, 3, "{err}");
    assert_eq!(rows.matches("no-start").count(), 2, "{rows}");
    assert!(
        rows.contains("the mass of `bob` is -1") && rows.contains("moves no mass of its own where m = 0"),
        "{rows}"
    );
}

#[test]
fn numbers_beyond_doubles_are_refused_where_they_stand() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("swing");
    let model = given("panic/model.toml");
    for arguments in [&["emit", &model, "--out", out.to_str().unwrap()][..], &["derive", &model], &["prove", &model]] {
        let (status, _, err) = answer(arguments);
        assert_eq!(status, 2, "{arguments:?}: {err}");
        assert!(err.contains("a number of about 10^400 is beyond double precision"), "{err}");
        assert!(err.contains("model.toml:"), "{err}");
    }
}

#[test]
fn slips_of_the_pen_are_answered_with_what_to_write() {
    let degrees = "span = [0, 1]\n[start]\ntheta = \"90 degrees\"\nomega = 0\n";
    let (_folder, path) = scene_of("pendulum", degrees);
    let (status, _, err) = answer(&["simulate", &path]);
    assert!(status == 2 && err.contains("`90*deg`"), "{err}");
    for degrees in ["90", "-90.5", "7.25"] {
        let text = format!("span = [0, 1]\n[start]\ntheta = {degrees}\nomega = 0\n");
        let (_folder, path) = scene_of("pendulum", &text);
        let (status, _, err) = answer(&["simulate", &path]);
        let hint = format!("`theta` starts at {degrees} rad: if degrees are meant, write \"{degrees}*deg\"");
        assert!(status == 0 && err.contains(&hint), "{err}");
    }
    let (folder, path) = scene_of("pendulum", "span = [0, 1]\n[start]\ntheta = \"7*pi/3\"\nomega = 0\n");
    assert!(!answer(&["simulate", &path]).2.contains("degrees"));
    let out = folder.path().join("out.csv");
    let sweep = |over| answer(&["sweep", &path, "--over", over, "--out", out.to_str().unwrap(), "--overwrite"]);
    let (status, _, err) = sweep("theta=0:90:3");
    assert!(status == 0 && err.contains("`theta` goes to 90 rad: if degrees are meant, write 90*deg"), "{err}");
    assert!(!sweep("theta=0:90*deg:3").2.contains("degrees") && !sweep("omega=0:90:3").2.contains("degrees"));
    let state = folder.path().join("state.toml");
    std::fs::write(&state, "[state]\ntheta = 90\nomega = 0\n").unwrap();
    let (status, _, err) = answer(&["evaluate", "models/pendulum", "--by", "kane", "--at", state.to_str().unwrap()]);
    assert!(status == 0 && err.contains("`theta` is 90 rad: if degrees are meant, write \"90*deg\""), "{err}");
    let (_folder, path) = scene_of(
        "pendulum",
        "span = [0, 1]\n[start]\ntheta = \"10*deg\"\nomega = 0\n[integration]\nmethod = \"quadrature\"\n",
    );
    let (status, _, err) = answer(&["simulate", &path, "--step", "0.1"]);
    assert!(status == 2 && err.contains("quadrature takes no steps"), "{err}");
    let (status, _, err) = answer(&["simulate", &path, "--max-step", "0.1"]);
    assert!(status == 2 && err.contains("quadrature takes no steps: none is the longest"), "{err}");
    let (status, out, _) = answer(&["simulate", &path, "--max-step", "0.1", "--method", "dop853"]);
    assert!(status == 0 && out.contains("steps of 1e-1 s at most"), "{out}");
}

/// Goal: arithmetic with constants is exact, or refused. Method: a spring whose stiffness hides in a constant; x = 0.5
/// cos(2 t) where it is 4.
#[test]
fn constants_are_exact_or_refused() {
    let model = |force: &str| {
        format!(
            "name = \"b\"\n[parameters]\nm = {{ unit = \"kg\", value = 1 }}\nk = {{ unit = \"N/m\", value = 4 }}\n[coordinates]\nx = {{ unit = \"m\" }}\n\
             [speeds]\nv = \"x'\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[points]\nP = {{ from = \"O\", frame = \"N\", position = [\"x\", 0, 0] }}\n\
             [particles]\nb = {{ point = \"P\", mass = \"m\" }}\n[forces.f]\non = \"b\"\nframe = \"N\"\nvector = [\"{force}\", 0, 0]\n"
        )
    };
    let scene = "model = \"model.toml\"\nspan = [0, 2]\n[start]\nx = 0.5\nv = 0\n[integration]\nmethod = \"dop853\"\nrtol = 1e-10\natol = 1e-12\n";
    let run = |force: &str| {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("model.toml"), model(force)).unwrap();
        std::fs::write(folder.path().join("s.toml"), scene).unwrap();
        answer(&["simulate", folder.path().join("s.toml").to_str().unwrap(), "--json"])
    };
    for force in
        ["-k*x*cos(pi*10^20)", "-k*x*sin(pi*10^20 + pi/2)", "-k*x*2*sin(10^20*pi + 5*pi/6)", "-k*x*sin(10^-9)*10^9"]
    {
        let (status, out, err) = run(force);
        assert_eq!(status, 0, "{force}: {err}");
        let run: Value = serde_json::from_str(&out).unwrap();
        let x = run["state"]["x"].as_f64().unwrap();
        assert!((x - 0.5 * 4_f64.cos()).abs() < 1e-8, "{force}: {x}");
    }
    for force in ["-k*x*sin(10^30)", "-k*x*(exp(10^-20)-1)*10^20", "-k*x*(sqrt(1+10^-30)-1)*2*10^30"] {
        let (status, _, err) = run(force);
        assert!(
            status == 2
                && err.contains("double precision does not know the constant `")
                && err.contains("model.toml:19:12"),
            "{force}: {err}"
        );
    }
}

#[test]
fn constants_of_scenes_are_known_or_refused_too() {
    let run = |start: &str, output: &str| {
        let text = format!("span = [0, 1e-6]\noutputs = [\"{output}\"]\n[start]\ntheta = \"{start}\"\nomega = 0\n");
        let (_folder, path) = scene_of("pendulum", &text);
        answer(&["simulate", &path, "--json"])
    };
    for (start, output) in [("sin(10^30)", "theta"), ("(exp(10^-40) - 1)*10^40", "theta"), ("1", "theta*sin(10^30)")] {
        let (status, _, err) = run(start, output);
        assert!(
            status == 2 && err.contains("double precision does not know the constant `"),
            "{start}, {output}: {err}"
        );
    }
    // Without functions everything is exact, whatever cancels.
    for start in ["(1 + 10^-40 - 1)*10^40", "cos(pi*10^20)", "10^17*(pi/2 - pi*(1/2 - 10^-17))/pi", "acos(1/2)*3/pi"] {
        let (status, out, err) = run(start, "theta");
        assert_eq!(status, 0, "{start}: {err}");
        let run: Value = serde_json::from_str(&out).unwrap();
        assert!((run["state"]["theta"].as_f64().unwrap() - 1.0).abs() < 1e-9, "{start}: {out}");
    }
}

#[test]
fn settings_that_a_method_ignores_are_refused() {
    for (more, what) in [("step = 0.1", "`step` means nothing"), ("project = \"energy\"", "`project` means nothing")] {
        let text =
            format!("span = [0, 5]\n[start]\ntheta = 1\nomega = 0\n[integration]\nmethod = \"quadrature\"\n{more}\n");
        let (_folder, path) = scene_of("pendulum", &text);
        let (status, _, err) = answer(&["simulate", &path]);
        assert!(status == 2 && err.contains(what), "{err}");
    }
    let (_folder, path) = scene_of("pendulum", "span = [0, 5]\n[start]\ntheta = 1\nomega = 0\n");
    for more in [["--step", "0.1"], ["--project", "energy"]] {
        let (status, _, err) = answer(&[&["simulate", &path, "--method", "quadrature"][..], &more].concat());
        assert!(status == 2 && err.contains("quadrature"), "{err}");
    }
}

/// A momentum that divides by a parameter that is 0 is none: it is no reason to distrust a run.
#[test]
fn an_integral_that_is_not_there_raises_no_alarm() {
    let model = "name = \"two beads\"\n[parameters]\nm = { unit = \"kg\", value = 1 }\nM = { unit = \"kg\", value = 2 }\nk = { unit = \"N/m\", value = 4 }\n\
                 a = { unit = \"1\", value = 0 }\nb = { unit = \"1\", value = 3 }\n[coordinates]\nx = { unit = \"m\" }\ny = { unit = \"m\" }\n\
                 [speeds]\nu = \"x'\"\nw = \"y'\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[points]\nP = { from = \"O\", frame = \"N\", position = [\"x\", 0, 0] }\n\
                 Q = { from = \"O\", frame = \"N\", position = [\"y\", 0, 0] }\n[particles]\np = { point = \"P\", mass = \"m\" }\nq = { point = \"Q\", mass = \"M\" }\n\
                 [forces.f]\non = \"p\"\nframe = \"N\"\nvector = [\"-k*a*(a*x-b*y)\", 0, 0]\n[forces.g]\non = \"q\"\nframe = \"N\"\nvector = [\"k*b*(a*x-b*y)\", 0, 0]\n";
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.toml"), model).unwrap();
    let text = "model = \"model.toml\"\nspan = [0, 2]\n[start]\nx = 1\ny = 0.2\nu = 0.1\nw = 0\n[integration]\nmethod = \"dop853\"\nrtol = 1e-9\natol = 1e-12\n";
    let path = folder.path().join("s.toml");
    std::fs::write(&path, text).unwrap();
    let (status, out, err) = answer(&["simulate", path.to_str().unwrap(), "--by", "kane", "--json"]);
    assert!(status == 0 && err.is_empty(), "{err}");
    let run: Value = serde_json::from_str(&out).unwrap();
    assert!((run["state"]["y"].as_f64().unwrap() - 0.2 * (18_f64.sqrt() * 2.0).cos()).abs() < 1e-6, "{out}");
    assert!(run["drift"].as_object().unwrap().values().all(Value::is_number), "{}", run["drift"]);
}

/// Goal: what no double holds is no result. Method: an energy beyond their range, and a chart of an output that has no
/// value.
#[test]
fn what_overflows_or_has_no_value_is_a_failure() {
    let folder = tempfile::tempdir().unwrap();
    let table = folder.path().join("t.csv");
    let scene = root().join("models/pendulum/scenes/swing.toml");
    let (scene, out) = (scene.to_str().unwrap(), table.to_str().unwrap());
    let (status, _, err) = answer(&["sweep", scene, "--over", "l=1,1e200", "--out", out]);
    let rows = std::fs::read_to_string(&table).unwrap();
    assert!(status == 3 && rows.contains("is not a finite number"), "{err}{rows}");

    let text = "span = [0, 5]\noutputs = [\"sqrt(theta)\"]\n[start]\ntheta = 1\nomega = 0\n";
    let (_folder, path) = scene_of("pendulum", text);
    let charts = folder.path().join("charts");
    let (status, _, err) = answer(&["chart", &path, "--quick", "--out", charts.to_str().unwrap()]);
    assert!(status == 3 && err.contains("have no value at t = 5 s: there is nothing to compare"), "{err}");
}

/// Goal: a mechanism that a motor alone turns has no speed, and is evaluated. Method: a wheel of 0.3 kg m² at 2 rad/s,
/// T = 0.6 J, by each formulation.
#[test]
fn a_mechanism_without_speeds_is_evaluated() {
    let folder = tempfile::tempdir().unwrap();
    let (model, state) = (folder.path().join("model.toml"), folder.path().join("st.toml"));
    let text = "name = \"wheel\"\n[parameters]\nI = \"0.3 kg*m^2\"\nm = \"1 kg\"\nw = \"2 rad/s\"\n[coordinates]\nq = { unit = \"rad\" }\n[inertial]\nframe = \
                \"N\"\norigin = \"O\"\n[frames]\nB = { from = \"N\", axis = 3, angle = \"q\" }\n[bodies.wheel]\nframe = \"B\"\ncentre = \"O\"\nmass = \"m\"\ninertia \
                = \"I\"\n[constraints]\nmotor = { equation = \"q = w*t\" }\n";
    std::fs::write(&model, text).unwrap();
    std::fs::write(&state, "[state]\nt = 0.3\n").unwrap();
    for by in ["kane", "lagrange", "newton-euler"] {
        let arguments = ["evaluate", model.to_str().unwrap(), "--by", by, "--at", state.to_str().unwrap(), "--json"];
        let (status, out, err) = answer(&arguments);
        assert_eq!(status, 0, "{by}: {err}");
        let values: serde_json::Value = serde_json::from_str(&out).unwrap();
        assert_eq!(values["kinetic_energy"].as_f64(), Some(0.6), "{by}: {out}");
        assert_eq!(values["accelerations"].as_object().map(serde_json::Map::len), Some(0), "{by}: {out}");
    }
}

/// Goal: all digits that `evaluate` shows are right, also where terms cancel. Method: an arm of 300 km with links of
/// 1.5 mg, by four formulations; their terms cancel differently, so that doubles lose four to eleven digits of one.
#[test]
fn evaluated_accelerations_have_sixteen_digits_by_each_formulation() {
    let folder = tempfile::tempdir().unwrap();
    let model = r#"
schema = 1
name = "arm"
[parameters]
g = { unit = "m/s^2", value = 9.81 }
l = { unit = "m", value = 300000 }
m1 = { unit = "kg", value = 1.5e-6, positive = true }
m2 = { unit = "kg", value = 2, positive = true }
I = { unit = "kg*m^2", value = 1e-3, positive = true }
c = { unit = "m", value = 0.01 }
[inertial]
frame = "N"
origin = "O"
[bodies]
a = { mass = "m1", inertia = { diagonal = ["I", "2*I", "3*I"] } }
b = { mass = "m2", inertia = { diagonal = ["I", "2*I", "2.5*I"], products = ["I/3", "I/5", "I/7"] } }
d = { mass = "m1", inertia = { diagonal = ["I", "2*I", "2.5*I"] } }
[joints]
j1 = { kind = "pin", axis = 3, body = "a", centre = ["l/2", "c", 0] }
j2 = { kind = "pin", axis = 1, body = "b", to = "a", at = ["l", 0, "c"], centre = ["c", "c/2", 0] }
j3 = { kind = "pin", axis = 2, body = "d", to = "b", at = [0, "l", "c"], centre = ["l/3", "c/2", 0] }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;
    let state = "[state]\nq_j1 = 0.3\nq_j2 = 1.1\nq_j3 = -0.4\nu_j1 = 0.7\nu_j2 = -0.2\nu_j3 = 1.3\n";
    let file = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let (model, state) = (file("model.toml", model), file("state.toml", state));
    let of = |by: &str| answer_in_json(&["evaluate", &model, "--at", &state, "--by", by, "--json"]);
    let kane = of("kane");
    for by in ["lagrange", "newton-euler", "gibbs-appell"] {
        let other = of(by);
        for name in ["u_j1'", "u_j2'", "u_j3'"] {
            let [a, b] = [&kane, &other].map(|found| found["accelerations"][name].as_f64().unwrap());
            assert!((a - b).abs() <= 4.0 * f64::EPSILON * a.abs(), "{by}: {name} is {b}, and {a} by Kane's method");
        }
    }
}
