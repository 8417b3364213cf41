//! `tripos view`: the file that it writes, and the browser that shows it.

use crate::support::{SLIDER, browser, root, status, stderr, tripos, tripos_in};
use serde_json::{Value, json};
use std::path::Path;
use std::process::Command;

/// The view of a scene with further arguments: exit status, page, standard error.
fn view(scene: &str, arguments: &[&str]) -> (i32, String, String) {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("view.html");
    let output = tripos(&[&["view", scene, "--out", out.to_str().unwrap()], arguments].concat());
    (status(&output), std::fs::read_to_string(&out).unwrap_or_default(), stderr(&output))
}

/// The JSON data of the viewer in a page.
fn data(page: &str) -> Value {
    let (_, rest) = page.split_once("<script type=\"application/json\">").expect("there are data");
    serde_json::from_str(rest.split_once("</script>").unwrap().0).unwrap()
}

/// The vectors of a list of differences, added up.
fn sums(list: &Value, width: usize, step: f64) -> Vec<Vec<f64>> {
    let mut sum = vec![0_i64; width];
    let rows = list.as_array().unwrap().chunks(width).map(|row| {
        sum.iter_mut().zip(row).for_each(|(sum, change)| *sum += change.as_i64().unwrap());
        sum.iter().map(|k| *k as f64 * step).collect()
    });
    rows.collect()
}

/// Goal: the data of the viewer are the motion. Method: the bob of a pendulum, added up as the viewer does: on its
/// circle at all instants, and over the top at the end, with energy ½ l² ω² − g l cos θ kept from one instant to the
/// next within the steps' size.
#[test]
fn the_viewer_is_given_the_bob_on_its_circle() {
    let (status, page, error) = view("models/pendulum/scenes/over.toml", &[]);
    assert_eq!((status, error.as_str()), (0, ""));
    let data = data(&page);
    let names: Vec<&str> = data["points"].as_array().unwrap().iter().map(|name| name.as_str().unwrap()).collect();
    assert_eq!(names, ["O", "P"]);
    let (motion, step) = (&data["motions"][0], data["place"].as_f64().unwrap());
    let t = sums(&motion["t"], 1, motion["dt"].as_f64().unwrap());
    let bob = sums(&motion["points"][1], 3, step);
    assert_eq!((t.len(), motion["points"][0].as_array().unwrap().len()), (bob.len(), 3), "the origin rests");
    assert!(t.len() > 50 && t[0] == [0.0] && (t[t.len() - 1][0] - 5.0).abs() < 1e-9);
    for place in &bob {
        assert!((place[0].hypot(place[1]) - 1.0).abs() < 2.0 * step && place[2] == 0.0, "{place:?}");
    }
    let highest = bob.iter().map(|place| place[1]).fold(f64::MIN, f64::max);
    assert!(highest > 0.999, "it went over the top: {highest}");
    assert!(page.contains("The model states no shapes"), "it says so");
}

/// Goal: one file, and nothing of another. Method: what could fetch something, in the page of a view.
#[test]
fn a_view_needs_nothing_but_itself() {
    let (_, page, _) = view("models/four_bar/scenes/turning.toml", &[]);
    for foreign in ["http:", "https:", "src=", "url(", "@import", "import(", "fetch(", "XMLHttp", "innerHTML", "eval("]
    {
        assert!(!page.contains(foreign), "{foreign}");
    }
    assert_eq!(page.matches("<link").count(), 1, "an icon that is none");
    for part in
        ["aria-live=\"polite\"", "role=\"application\"", "aria-label=\"Play\"", "<kbd>space</kbd>", "lang=\"en\""]
    {
        assert!(page.contains(part), "{part}");
    }
    assert!(page.len() < 1_000_000, "{}", page.len());
}

/// Goal: the data of the viewer have the forces. Method: the bob on a spring, added up as the viewer does: its weight m
/// g at all instants, and a pull that points to the support. The longest is as long as the words say, and a scene with
/// impacts says which forces are missing.
#[test]
fn the_viewer_is_given_the_forces() {
    let (status, page, error) = view("models/elastic_pendulum/scenes/bouncing.toml", &[]);
    assert_eq!((status, error.as_str()), (0, ""));
    let data = data(&page);
    let (arrows, motion) = (&data["arrows"], &data["motions"][0]);
    let told =
        arrows["list"].as_array().unwrap().iter().map(|a| (a["kind"].as_str().unwrap(), a["name"].as_str().unwrap()));
    assert_eq!(told.collect::<Vec<_>>(), [("weight", "bob"), ("applied", "rubber")]);
    let (step, usual) = (arrows["step"].as_f64().unwrap(), arrows["usual"].as_f64().unwrap());
    let at = usize::try_from(arrows["list"][1]["point"].as_u64().unwrap()).unwrap();
    let places = sums(&motion["points"][at], 3, data["place"].as_f64().unwrap());
    let pulls = sums(&arrows["list"][1]["values"], 3, step);
    assert!(pulls.len() > 50 && pulls.len() == places.len());
    for (place, pull) in places.iter().zip(&pulls) {
        let across = place[0] * pull[1] - place[1] * pull[0];
        assert!(across.abs() < 3e-3 * usual, "{place:?} {pull:?}");
    }
    let most = pulls.iter().map(|pull| pull[0].hypot(pull[1])).fold(0.0, f64::max);
    assert!(most >= usual && usual > 9.81, "{most} {usual}");
    let (_, words) = page.split_once("Arrows are forces, of at most ").unwrap();
    let told: f64 = words.split_once(" N").unwrap().0.parse().unwrap();
    assert!((told - most).abs() < 1e-3 * most, "{told} {most}");
    assert_eq!(sums(&arrows["list"][0]["values"], 3, step).len(), 1, "a weight never changes");
    for words in [">weights</li>", ">applied forces</li>"] {
        assert!(page.contains(words), "{words}");
    }
    assert!(!page.contains(">forces of constraints</li>"));
}

/// Goal: a divergence of motions can be seen. Method: the printed equations of the disk beside the derived ones, two
/// motions with names.
#[test]
fn printed_equations_are_seen_beside_the_derived_ones() {
    let scene = "models/disk/scenes/report.toml";
    let (_, page, _) = view(scene, &["--until", "1", "--against", "lagrange", "--against", "printed:kane-final"]);
    let data = data(&page);
    let titles: Vec<&str> = data["motions"].as_array().unwrap().iter().map(|m| m["title"].as_str().unwrap()).collect();
    assert_eq!(titles.len(), 3);
    assert!(titles[1] == "Lagrange's equations" && titles[2].contains("kane-final"), "{titles:?}");
    assert!(
        page.contains("<ul class=\"view-legend\">") && page.contains("Seen through, beside it: Lagrange's equations")
    );
    let wheel = data["solids"].as_array().unwrap().iter().find(|solid| solid["label"] == "disk").unwrap();
    assert_eq!((wheel["kind"].as_str(), wheel["radius"].as_f64()), (Some("cylinder"), Some(1.0)), "{wheel}");
    assert!(
        data["points"].as_array().unwrap().iter().position(|name| name == "P")
            == usize::try_from(data["traced"][0].as_u64().unwrap()).ok(),
        "the contact is traced"
    );
}

/// Goal: no text of a file becomes markup or script. Method: hostile titles and names of shapes, in the page as text
/// and data.
#[test]
fn hostile_texts_stay_text() {
    let folder = tempfile::tempdir().unwrap();
    let evil = "</script><script>alert(1)</script><b onmouseover=x>\"'&";
    let model = SLIDER.replace("Slider", &evil.replace('"', "\\\""));
    let shapes = "\n[shapes.'</script><i>']\nkind = \"sphere\"\nbody = \"slider\"\nradius = \"l\"\n";
    let model = model.replace("parameters.k", "parameters.l = \"1 m\"\nparameters.k");
    std::fs::write(folder.path().join("model.toml"), model + shapes).unwrap();
    let scene = format!(
        "model = \"model.toml\"\ntitle = '''{evil}'''\nabout = '''{evil}'''\nspan = [0, 1]\nstart.x = 1\nstart.u = 0\n"
    );
    std::fs::write(folder.path().join("s.toml"), scene).unwrap();
    let (status, _, error) = tripos_in(folder.path(), &["view", "s.toml"]);
    assert_eq!((status, error.as_str()), (0, ""));
    let page = std::fs::read_to_string(folder.path().join("view.html")).unwrap();
    assert_eq!(page.matches("<script").count(), 2, "the data and the viewer");
    assert!(!page.contains("<b onmouse") && !page.contains("<i>"));
    let data = data(&page);
    assert_eq!(data["scene"], evil);
    assert_eq!(data["solids"][0]["label"], "</script><i>");
    assert!(page.contains("Shapes are those of the model file"));
}

/// Goal: a page promises only controls that it has. Method: a slider with a wall: a sentence says why nothing can be
/// changed, and there are no sliders. A linkage has none for its dependent coordinates; a pendulum has one for each
/// number, with positive parameters above 0.
#[test]
fn a_view_says_whether_its_numbers_can_be_changed() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.toml"), SLIDER).unwrap();
    let bouncing = folder.path().join("bouncing.toml");
    let walls = "model = \"model.toml\"\nspan = [0, 2]\nstart.x = 1\nstart.u = 0\n\
                 impacts.wall = { gap = \"p(P) @ A [1] + 0.5\", restitution = 0.5 }\n";
    std::fs::write(&bouncing, walls).unwrap();
    let (status, page, error) = view(bouncing.to_str().unwrap(), &["--until", "2"]);
    assert_eq!(status, 0, "{error}");
    assert!(data(&page)["live"].is_null() && !page.contains("<section class=\"view-live\""));
    let why = "bodies meet in it, and impacts are computed by the command alone";
    assert!(page.contains(&format!("nothing of it can be changed here, since {why}")), "{page}");

    let (_, page, _) = view("models/four_bar/scenes/turning.toml", &["--until", "0.1"]);
    let live = &data(&page)["live"];
    let start = live["start"].as_array().unwrap().iter().map(|slider| slider["name"].as_str().unwrap());
    assert_eq!(start.collect::<Vec<_>>(), ["q1", "u1"]);
    assert_eq!(
        (&live["closing"], &live["general"]),
        (&json!([1, 2]), &json!("Lagrange's equations, with multipliers"))
    );

    let (_, page, _) = view("models/pendulum/scenes/swing.toml", &[]);
    let live = &data(&page)["live"];
    assert!(live["general"].is_null());
    let ranges = |list: &str| {
        let each = live[list].as_array().unwrap().iter();
        let of = |slider: &Value| {
            (
                slider["name"].as_str().unwrap().to_owned(),
                ["from", "value", "to"].map(|key| slider[key].as_f64().unwrap()),
            )
        };
        each.map(of).collect::<Vec<_>>()
    };
    let names = |list: &[(String, [f64; 3])]| list.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>().join(" ");
    let (parameters, start) = (ranges("parameters"), ranges("start"));
    assert_eq!((names(&parameters).as_str(), names(&start).as_str()), ("m l g", "theta omega"));
    let units = live["start"].as_array().unwrap().iter().map(|slider| slider["unit"].as_str().unwrap());
    assert_eq!(units.collect::<Vec<_>>(), ["rad", "rad/s"]);
    assert!(parameters.iter().all(|(_, [from, value, to])| 0.0 < *from && from < value && value < to));
    let half = std::f64::consts::PI;
    assert!((start[0].1[0] - (2.0 - half)).abs() < 1e-12 && (start[0].1[2] - (2.0 + half)).abs() < 1e-12, "{start:?}");
    // As far as the motion goes: the bob falls from 2 rad, so that its rate is at most sqrt(2 g (1 - cos 2)).
    let fastest = (2.0 * 9.81 * (1.0 - 2.0_f64.cos())).sqrt();
    assert!((start[1].1[2] - fastest).abs() < 1e-3, "{start:?}");
    assert!(page.contains("const EQUATIONS = [(() => {") && page.contains("function derivative(p, q, u)"));
    assert!(page.contains("only what touches changes its size"));
}

/// Goal: requests that cannot be shown are refused with advice, and no input file is written over.
#[test]
fn wrong_requests_are_refused_with_a_way_out() {
    let scene = "models/pendulum/scenes/over.toml";
    let (status, _, error) = view(scene, &["--against", "models/disk/scenes/report.toml"]);
    assert!(status == 2 && error.contains("belongs to another model than the scene"), "{error}");
    let (status, _, error) = view(scene, &["--against", "lagrang"]);
    assert!(status == 2 && error.contains("did you mean `lagrange`?"), "{error}");
    let output = tripos(&["view", scene, "--out", "models/pendulum/model.toml"]);
    assert!(
        output.status.code() == Some(2) && stderr(&output).contains("would overwrite the input"),
        "{}",
        stderr(&output)
    );
}

/// `tests/browser/view.mjs` over a scene, sliders included: what it says.
fn driven(modules: &Path, scene: &str, more: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("view.html");
    let output = tripos(&[&["view", scene, "--out", file.to_str().unwrap()], more].concat());
    assert_eq!(status(&output), 0, "{}", stderr(&output));
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/browser/view.mjs");
    let mut node = Command::new("node");
    let output = node.arg(script).arg(&file).current_dir(modules.join("..")).env("LIVE", "1").output().unwrap();
    assert!(output.status.success(), "{scene}: {}", String::from_utf8_lossy(&output.stderr));
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(said.matches(": held").count(), 7, "{said}");
    said
}

/// Goal: sliders move linkages, which stay closed. Method: the browser over a four-bar linkage and the bicycle;
/// `tests/browser/view.mjs` reads their residuals.
#[test]
fn sliders_move_linkages_in_a_browser() {
    let Some(modules) = browser() else { return };
    for (scene, closed) in
        [("models/four_bar/scenes/crossed.toml", "q2"), ("models/whipple_bicycle/scenes/knocked.toml", "theta")]
    {
        let said = driven(&modules, scene, &[]);
        assert!(said.contains(&format!("closed by {closed} = ")), "{said}");
    }
}

/// Goal: the view works where people open it. Method: `tests/browser/view.mjs` drives a real browser over it: plays,
/// scrubs, turns, zooms, by mouse, finger and keyboard, by day, at night and on paper, without an error on its console.
#[test]
fn a_browser_plays_scrubs_and_turns_the_view() {
    let Some(modules) = browser() else { return };
    let scene = "models/rolling_disc/scenes/roll.toml";
    let said = driven(&modules, scene, &["--against", "lagrange"]);
    // The page's own run ends where a run of the command at 1e-13 does, to what steps of 1e-10 add up to.
    let line = said.lines().find_map(|line| line.strip_prefix("state: ")).unwrap();
    let state: Vec<f64> = serde_json::from_str(line).unwrap();
    let scene = tripos::Scene::read(root().join(scene)).unwrap().with_compiled_equations(tripos_models::MODELS);
    let how = tripos::Overrides {
        by: Some("kane".into()),
        method: Some(tripos::Method::Dop853.into()),
        rtol: Some(1e-13),
        atol: Some(1e-13),
        ..tripos::Overrides::default()
    };
    let run = scene.simulate(&how).unwrap();
    assert!((run.solution.t_end - state[0]).abs() < 1e-7, "{} {state:?}", run.ending);
    let apart = run.end.iter().zip(&state[1..]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(run.end.len() + 1 == state.len() && apart < 1e-7, "{apart:e}: {:?} {state:?}", run.end);
}
