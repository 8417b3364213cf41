//! One motion in several descriptions: by joints, by frames and points, and in other coordinates.
//!
//! Truth: each other, and frames turned by hand.

use tripos::{Mechanism, Overrides, Run, Scene};
use tripos_derive::diagnostic::Source;
use tripos_derive::{Formulation, Model, model};

fn load(text: &str) -> Model {
    model::load(&Source::from_text("described.toml", text)).unwrap_or_else(|e| panic!("{e}"))
}

fn run(model_text: &str, start: &str, by: Formulation) -> Run {
    let text = format!(
        "model = \"described.toml\"\nspan = [0, 2]\n{start}\n[integration]\nmethod = \"dop853\"\nrtol = 1e-13\natol = 1e-13\nsamples = 101\n"
    );
    let scene = Scene::parse(Mechanism::new(load(model_text)), &text).unwrap_or_else(|e| panic!("{e}"));
    let how = Overrides { by: Some(by.name().into()), ..Overrides::default() };
    let run = scene.simulate(&how).unwrap_or_else(|e| panic!("{}: {e}", by.name()));
    assert!(run.failure().is_none(), "{}: {:?}", by.name(), run.objections());
    run
}

fn column(run: &Run, name: &str) -> Vec<f64> {
    run.column_of_quantity(name).unwrap_or_else(|e| panic!("{e}")).clone()
}

const FOUR_BAR: &str = include_str!("../models/four_bar/model.toml");

const BARS: &str = "name = \"bars\"\n[parameters]\na = \"30 cm\"\nb = \"800 mm\"\nc = \"0.6 m\"\nd = \"0.7 m\"\nma = \"1 kg\"\nmb = \"2 kg\"\nmc = \
                    \"1500 g\"\ng = \"9.81 m/s^2\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[gravity]\nframe = \"N\"\nacceleration = [0, \
                    \"-g\", 0]\n[bodies]\ncrank = { mass = \"ma\", inertia = \"ma*a^2/12\" }\ncoupler = { mass = \"mb\", inertia = \
                    \"mb*b^2/12\" }\nrocker = { mass = \"mc\", inertia = \"mc*c^2/12\" }\n[joints]\n";

/// Goal: a linkage moves alike however it is described. Method: angles from the ground; pins, the last of which closes
/// the loop; and each bar by three coordinates of its own, tied by four pins.
#[test]
fn a_four_bar_linkage_in_three_descriptions() {
    let by_pins = format!(
        "{BARS}O1 = {{ kind = \"pin\", body = \"crank\", centre = [\"a/2\", 0, 0] }}\nP = {{ kind = \"pin\", body = \"coupler\", to = \
         \"crank\", at = [\"a\", 0, 0], centre = [\"b/2\", 0, 0] }}\nD = {{ kind = \"pin\", body = \"rocker\", at = [\"d\", 0, 0], centre = \
         [\"c/2\", 0, 0] }}\nQ = {{ kind = \"pin\", body = \"rocker\", to = \"coupler\", at = [\"b\", 0, 0], body_at = [\"c\", 0, 0] }}\n"
    );
    let loose = |bar: &str| {
        let (speeds, names) = if bar == "crank" { ("", "x1\", \"y1\", \"q1") } else { ("speeds = [], ", "") };
        let names = if names.is_empty() { format!("x_{bar}\", \"y_{bar}\", \"q_{bar}") } else { names.to_owned() };
        format!("{bar}_moves = {{ kind = \"planar\", body = \"{bar}\", {speeds}coordinates = [\"{names}\"] }}\n")
    };
    let by_places = format!(
        "{BARS}{}{}{}O1 = {{ kind = \"pin\", body = \"crank\", body_at = [\"-a/2\", 0, 0] }}\nP = {{ kind = \"pin\", body = \"coupler\", to = \
         \"crank\", at = [\"a/2\", 0, 0], body_at = [\"-b/2\", 0, 0] }}\nD = {{ kind = \"pin\", body = \"rocker\", at = [\"d\", 0, 0], body_at \
         = [\"-c/2\", 0, 0] }}\nQ = {{ kind = \"pin\", body = \"rocker\", to = \"coupler\", at = [\"b/2\", 0, 0], body_at = [\"c/2\", 0, 0] }}\n",
        loose("crank").replace("coordinates", "speeds = [\"v\", \"w\", \"u1\"], coordinates"),
        loose("coupler"),
        loose("rocker"),
    );
    let by_places = by_places
        .replace("speeds = [\"v\", \"w\", \"u1\"], ", "speeds = [], ")
        .replace("[joints]", "[speeds]\nu1 = \"q1'\"\n[joints]");
    let absolute = (FOUR_BAR, "[start]\nq1 = 0.5\nu1 = 20\n[guess]\nq2 = 0.6\nq3 = 1.2");
    let pinned = (by_pins.as_str(), "[start]\nq_O1 = \"0.5 rad\"\nu_O1 = 20\n[guess]\nq_P = 0.1\nq_D = 1.2");
    let placed = (by_places.as_str(), "[start]\nq1 = 0.5\nu1 = 20\n[guess]\nq_coupler = 0.6\nq_rocker = 1.2");
    for by in Formulation::ALL {
        let [one, two, three] = [absolute, pinned, placed].map(|(model, start)| run(model, start, by));
        let truth = column(&one, "q1");
        assert!(truth.last().unwrap() > &10.0);
        for (run, name) in [(&two, "q_O1"), (&three, "q1")] {
            for (a, b) in truth.iter().zip(column(run, name)) {
                assert!((a - b).abs() < 1e-10, "{} {name}: {a}, {b}", by.name());
            }
        }
        for ((coupler, crank), joint) in column(&one, "q2").iter().zip(truth).zip(column(&two, "q_P")) {
            assert!((coupler - crank - joint).abs() < 1e-10);
        }
    }
}

/// Goal: angles of a ball joint are a choice. Method: a top by two sequences of its ball joint, by three pins with
/// bodies of nothing between, and by frames with the same speeds; the direction of its axis from each.
#[test]
fn a_top_in_four_descriptions() {
    let world = "name = \"top\"\n[parameters]\nl = \"0.3 m\"\nm = \"2 kg\"\nA = { unit = \"kg*m^2\", value = 0.05 }\nB = { unit = \
                 \"kg*m^2\", value = 0.06 }\nC = { unit = \"kg*m^2\", value = 0.02 }\ng = \"9.81 m/s^2\"\n[inertial]\nframe = \
                 \"N\"\norigin = \"O\"\n[gravity]\nframe = \"N\"\nacceleration = [0, 0, \"-g\"]\n";
    let body = "[bodies]\ntop = { mass = \"m\", inertia = { diagonal = [\"A\", \"B\", \"C\"] } }\n";
    let ball = |sequence: &str| {
        format!(
            "{world}{body}[joints]\nO1 = {{ kind = \"ball\", sequence = \"{sequence}\", body = \"top\", centre = [0, 0, \"l\"], \
             coordinates = [\"a\", \"b\", \"c\"], speeds = [\"u1\", \"u2\", \"u3\"] }}\n"
        )
    };
    let nothing = "inertia = { diagonal = [0, 0, 0] }";
    let pins = format!(
        "{world}[bodies]\none = {{ mass = 0, {nothing} }}\ntwo = {{ mass = 0, {nothing} }}\ntop = {{ mass = \"m\", inertia = {{ diagonal = \
         [\"A\", \"B\", \"C\"] }} }}\n[joints]\nj1 = {{ kind = \"pin\", axis = 1, body = \"one\", coordinates = [\"a\"] }}\nj2 = {{ kind = \
         \"pin\", axis = 2, body = \"two\", to = \"one\", coordinates = [\"b\"] }}\nj3 = {{ kind = \"pin\", body = \"top\", to = \"two\", \
         coordinates = [\"c\"], centre = [0, 0, \"l\"] }}\n"
    );
    let frames = format!(
        "{world}[coordinates]\na = {{ unit = \"rad\" }}\nb = {{ unit = \"rad\" }}\nc = {{ unit = \"rad\" }}\n[speeds]\nu1 = \"a'\"\nu2 = \
         \"b'\"\nu3 = \"c'\"\n[frames]\nT = {{ from = \"N\", sequence = \"321\", angles = [\"c\", \"b\", \"a\"], fixed = \"space\" \
         }}\n[points]\nG = {{ from = \"O\", frame = \"T\", position = [0, 0, \"l\"] }}\n[bodies.top]\nframe = \"T\"\ncentre = \"G\"\nmass = \
         \"m\"\ninertia = {{ diagonal = [\"A\", \"B\", \"C\"] }}\n"
    );
    let turned = "[start]\na = 0.4\nb = 0\nc = 0\n";
    let spun = format!("{turned}u1 = 1\nu2 = 2\nu3 = 30\n");
    let rates = format!("{turned}\"a'\" = 1\n\"b'\" = 2\n\"c'\" = 30\n");
    // Turned by 0.4 about axis 1, whose place in the sequence 312 is the second.
    let other = "[start]\na = 0\nb = 0.4\nc = 0\nu1 = 1\nu2 = 2\nu3 = 30\n";
    // The axis of the top from the angles of 1-2-3 and of 3-1-2.
    let axis_123 = |a: f64, b: f64| [b.sin(), -a.sin() * b.cos(), a.cos() * b.cos()];
    let axis_312 = |a: f64, b: f64, c: f64| {
        let (x, y, z) = (c.sin(), -b.sin() * c.cos(), b.cos() * c.cos());
        [a.cos() * x - a.sin() * y, a.sin() * x + a.cos() * y, z]
    };
    let [first, second] = [ball("123"), ball("312")];
    let runs = [
        (first.as_str(), spun.as_str(), true),
        (second.as_str(), other, false),
        (pins.as_str(), rates.as_str(), true),
        (frames.as_str(), rates.as_str(), true),
    ];
    let axes: Vec<Vec<[f64; 3]>> = runs
        .iter()
        .map(|(model, start, is_123)| {
            let run = run(model, start, Formulation::Kane);
            let [a, b, c] = ["a", "b", "c"].map(|name| column(&run, name));
            let each = a.iter().zip(b).zip(c);
            each.map(|((a, b), c)| if *is_123 { axis_123(*a, b) } else { axis_312(*a, b, c) }).collect()
        })
        .collect();
    for others in &axes[1..] {
        for (truth, axis) in axes[0].iter().zip(others) {
            assert!(truth.iter().zip(axis).all(|(a, b)| (a - b).abs() < 1e-10), "{truth:?}, {axis:?}");
        }
    }
    assert!(axes[0].iter().any(|axis| axis[1] > 0.1), "it goes round");
}

/// Goal: Euler parameters and pins about any axis describe the same motions. Method: an arm on a skew pin with a top on
/// a ball joint at its end; the pin by a vector, by turns of its axes on both sides, and by a frame turned about a
/// vector; the ball by three turns and by Euler parameters, by every formulation. The top passes a pose in which the
/// turns are singular.
#[test]
fn a_skew_arm_with_a_top_in_four_descriptions() {
    let world = "name = \"arm and top\"\n[parameters]\nl = \"0.3 m\"\nm = \"2 kg\"\nA = { unit = \"kg*m^2\", value = 0.05 }\nB = { unit = \
                 \"kg*m^2\", value = 0.06 }\nC = { unit = \"kg*m^2\", value = 0.02 }\ng = \"9.81 m/s^2\"\n[inertial]\nframe = \
                 \"N\"\norigin = \"O\"\n[gravity]\nframe = \"N\"\nacceleration = [0, 0, \"-g\"]\n";
    let arm =
        "arm = { mass = \"m\", inertia = { diagonal = [\"B\", \"A\", \"C\"], products = [\"C/10\", 0, \"C/5\"] } }\n";
    let top = "top = { mass = \"m\", inertia = { diagonal = [\"A\", \"B\", \"C\"] } }\n";
    let ball = |sequence: &str, names: &str| {
        format!(
            "Q = {{ kind = \"ball\", body = \"top\", to = \"arm\", at = [0, 0, \"-l\"], centre = [0, 0, \"-l\"], sequence = \"{sequence}\", \
             coordinates = [{names}], speeds = [\"w1\", \"w2\", \"w3\"] }}\n"
        )
    };
    let (turns, parameters) = (ball("123", "\"a\", \"b\", \"c\""), ball("euler", "\"e0\", \"e1\", \"e2\", \"e3\""));
    let pin = "P = { kind = \"pin\", body = \"arm\", axis = [2, -1, 2], centre = [0, 0, \"-l/2\"], coordinates = [\"q\"], speeds = [\"u\"] }\n";
    let vector = |ball: &str| format!("{world}[bodies]\n{arm}{top}[joints]\n{pin}{ball}");
    let frame = format!(
        "{world}[coordinates]\nq = {{ unit = \"rad\" }}\n[speeds]\nu = \"q'\"\n[frames]\nR = {{ from = \"N\", axis = [2, -1, 2], angle = \"q\" }}\n[points]\nG = {{ from = \"O\", frame = \"R\", position = [0, 0, \"-l/2\"] }}\nE = {{ from = \"O\", frame = \
         \"R\", position = [0, 0, \"-l\"] }}\n[bodies]\n{}{top}[joints]\n{}",
        arm.replace("{ mass", "{ frame = \"R\", centre = \"G\", mass"),
        parameters.replace("at = [0, 0, \"-l\"]", "at = \"E\"")
    );
    // An axis in a plane and then a tilt towards it: turns that were not made by the program.
    let tilted = format!(
        "{world}[bodies]\narm_before = {{ mass = 0, inertia = {{ diagonal = [0, 0, 0] }} }}\n{arm}{top}[joints]\nP = {{ kind = \"pin\", body = \
         \"arm_before\", turned = {{ sequence = \"32\", angles = [\"-atan(1/2)\", \"acos(2/3)\"] }}, coordinates = [\"q\"], speeds = [\"u\"] }}\nW = {{ kind = \
         \"weld\", body = \"arm\", to = \"arm_before\", turned = {{ sequence = \"23\", angles = [\"-acos(2/3)\", \"atan(1/2)\"] }}, centre = [0, \
         0, \"-l/2\"] }}\n{parameters}"
    );
    let turned = "[start]\na = 0.4\nb = 0\nc = 0\nq = 0.9\n";
    let whole = "[start]\ne0 = \"cos(0.2)\"\ne1 = \"sin(0.2)\"\ne2 = 0\ne3 = 0\nq = 0.9\n";
    let speeds = |pin: &str| format!("{pin} = 0.5\nw1 = 3\nw2 = 1\nw3 = 8\n");
    let models = [
        (vector(&turns), format!("{turned}{}", speeds("u"))),
        (vector(&parameters), format!("{whole}{}", speeds("u"))),
        (frame, format!("{whole}{}", speeds("u"))),
        (tilted, format!("{whole}{}", speeds("u"))),
    ];
    for by in Formulation::ALL {
        let mut truth: Option<[Vec<f64>; 4]> = None;
        for (model, start) in &models {
            let run = run(model, start, by);
            let found = ["q", "w1", "w2", "w3"].map(|name| column(&run, name));
            assert!(found[0].iter().any(|q| *q < -0.5), "it swings");
            let truth = truth.get_or_insert_with(|| found.clone());
            for (name, (one, other)) in ["q", "w1", "w2", "w3"].into_iter().zip(truth.iter().zip(&found)) {
                for (a, b) in one.iter().zip(other) {
                    assert!((a - b).abs() < 1e-10, "{} {name}: {a}, {b}", by.name());
                }
            }
        }
    }
}
