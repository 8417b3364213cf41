//! Singular poses of mechanisms, and their assembly branches, by the result of `tripos check`.
//!
//! Truth: closed forms. A four-bar linkage has a singular pose exactly if its bars can lie in a line, a ± b ± c ± d =
//! 0 (Grashof's equality; J. J. Uicker, G. R. Pennock & J. E. Shigley, *Theory of Machines and Mechanisms*, 5th
//! edition (2017), § 1.9).

use crate::common::read;
use nalgebra::DMatrix;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write;
use std::path::Path;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::calculus::Differential;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::check::{ModelCheck, check};
use tripos_derive::model::Model;

fn of_library(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(name).join("model.toml");
    std::fs::read_to_string(path).unwrap()
}

fn checked(text: &str) -> ModelCheck {
    let model = read(text).unwrap_or_else(|e| panic!("{e}"));
    check(&model).unwrap_or_else(|e| panic!("{}", model.diagnose(&e)))
}

/// The linkage of the library with other lengths: crank, coupler, rocker, ground.
fn four_bar(lengths: [f64; 4]) -> ModelCheck {
    let mut text = of_library("four_bar");
    for ((name, old), new) in [("a", "0.3"), ("b", "0.8"), ("c", "0.6"), ("d", "0.7")].iter().zip(lengths) {
        let stated = format!("\n{name} = {{ unit = \"m\", value = {old},");
        assert!(text.contains(&stated));
        text = text.replace(&stated, &format!("\n{name} = {{ unit = \"m\", value = {new:?},"));
    }
    checked(&text)
}

#[test]
fn linkages_that_can_lie_in_a_line_are_singular_there() {
    // A parallelogram, a kite, and a bar as long as the others together less one.
    for lengths in [[0.3, 0.7, 0.3, 0.7], [0.4, 0.4, 0.7, 0.7], [0.3, 0.8, 0.6, 0.5]] {
        let found = four_bar(lengths);
        let loss = found.rank_loss.unwrap();
        let pose = loss.pose.unwrap_or_else(|| panic!("{lengths:?}"));
        let names: Vec<&str> = pose.iter().map(|(name, _)| name.as_str()).collect();
        assert_eq!(names, ["q1", "q2", "q3"]);
        let [a, b, c, d] = lengths;
        let along = pose[0].1.cos() * a + pose[1].1.cos() * b - pose[2].1.cos() * c - d;
        assert!(along.abs() < 1e-9, "{pose:?}");
        // 1e-5: closing is of second order there.
        assert!(pose.iter().all(|(_, q)| q.sin().abs() < 1e-5), "{lengths:?}: {pose:?}");
    }
}

/// Goal: a driven linkage is singular at the instant when its coupler and its rocker lie in a line. Method: the
/// distance between the pins on the crank and on the ground, a² + d² − 2 a d cos q1 = (b ± c)², at q1 = 1.2 + w t.
/// The pose at t = 0 is not singular.
#[test]
fn a_driven_linkage_is_singular_at_some_instant() {
    let driven = |b: f64, c: f64| {
        let text = of_library("four_bar");
        let text = text
            .replace("[speeds]\nu1 = \"q1'\"\n", "")
            .replace("[constraints]\n", "[constraints]\nmotor = { equation = \"q1 = 1.2 + w*t\" }\n");
        let text =
            text.replace("\n[coordinates]", "w = { unit = \"1/s\", value = 0.5, positive = true }\n\n[coordinates]");
        let text = text.replace("a = { unit = \"m\", value = 0.3", "a = { unit = \"m\", value = 0.6");
        let text = text.replace("b = { unit = \"m\", value = 0.8", &format!("b = {{ unit = \"m\", value = {b:?}"));
        let text = text.replace("c = { unit = \"m\", value = 0.6", &format!("c = {{ unit = \"m\", value = {c:?}"));
        let reactions = text.find("[reactions.").unwrap();
        let text =
            text[..reactions].replace(", enforced_by = \"pin_qx\"", "").replace(", enforced_by = \"pin_qy\"", "");
        checked(&text)
    };
    let loss = driven(0.8, 0.3).rank_loss.unwrap();
    let pose = loss.pose.expect("the crank brings them into a line");
    let of = |name: &str| pose.iter().find(|(known, _)| known == name).unwrap_or_else(|| panic!("{name}: {pose:?}")).1;
    let square = 0.85 - 0.84 * (1.2 + 0.5 * of("t")).cos();
    assert!(of("t") >= 0.0 && (square - 1.21).abs().min((square - 0.25).abs()) < 1e-8, "{pose:?}");
    assert!((of("q2") - of("q3")).sin().abs() < 1e-4, "{pose:?}");
    // The pins are 0.1 to 1.3 apart: more than the bars differ by, less than both together.
    let free = driven(0.8, 0.75).rank_loss.unwrap();
    assert!(free.pose.is_none() && free.sought >= 3, "{:?}", free.pose);
}

#[test]
fn other_linkages_fail_only_by_the_choice_of_speeds() {
    let found = four_bar([0.3, 0.8, 0.6, 0.7]);
    assert_eq!(found.singular_where, ["sin(q2 - q3)"]);
    let loss = found.rank_loss.unwrap();
    assert_eq!((loss.rank, loss.nowhere, loss.pose), (2, false, None));
    assert!(loss.sought >= 10);
    let mut formulas = loss.where_all_zero.unwrap();
    formulas.sort();
    assert_eq!(loss.rank_there, None);
    assert_eq!(formulas, ["sin(q1 - q2)", "sin(q1 - q3)", "sin(q2 - q3)"]);
}

#[test]
fn rolling_is_regular_whatever_fails_of_the_speeds() {
    let found = checked(&of_library("rolling_disc"));
    assert_eq!(found.singular_where, ["cos(q2)"]);
    let loss = found.rank_loss.unwrap();
    assert_eq!((loss.rank, loss.nowhere, loss.pose), (2, true, None));
    assert_eq!(found.branch, None);
    // Nothing ties a pendulum.
    assert_eq!(checked(&of_library("pendulum")).rank_loss, None);
}

/// Goal: Bricard's mechanism, known since 1897, has one freedom. One pin of six is the ground's, so that five
/// coordinates and the five equations of the last pin are left: five of six screws are independent, four of five
/// equations.
#[test]
fn bricards_mechanism_moves_though_counting_says_that_it_does_not() {
    let found = checked(&of_library("bricard"));
    assert_eq!((found.mobility_count, found.degrees_of_freedom), (0, 1));
    let branch = found.branch.unwrap();
    assert_eq!((branch.rank, branch.constraints, branch.pose.len()), (4, 5, 5));
    assert!(branch.independent > 1e-6 && branch.dependent.unwrap() < 1e-8, "{branch:?}");
    assert_eq!(found.constraints.iter().filter(|c| c.redundant).count(), 1);
    assert!(found.notes.iter().any(|note| note.contains("follows from")), "{:?}", found.notes);
}

#[test]
fn a_rod_without_inertia_about_itself_is_named() {
    let found = checked(
        "name = \"rod\"\n[parameters]\nm = { unit = \"kg\", value = 1 }\nJ = { unit = \"kg*m^2\", value = 1 }\n[coordinates]\nq = { unit = \"rad\" }\ns = { \
         unit = \"rad\" }\n[speeds]\nu = \"q'\"\nw = \"s'\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[frames]\nA = { from = \"N\", axis = 3, angle = \
         \"q\" }\nB = { from = \"A\", axis = 1, angle = \"s\" }\n[bodies.rod]\nframe = \"B\"\ncentre = \"O\"\nmass = \"m\"\ninertia = { diagonal = [0, \
         \"J\", \"J\"] }\n",
    );
    assert_eq!(found.indeterminate, ["w"]);
    assert_eq!(found.notes[0], "the body `rod` has no inertia about the axis of `w`");
}

/// A generator of numbers that are the same on every machine.
struct Chance(u64);

impl Chance {
    fn draw(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * ((self.0 >> 33) as f64 / (1_u64 << 31) as f64)
    }
}

/// Axes along which the model text of a road train takes its contacts.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Axes {
    /// Those of the ground, which the text states.
    Stated,
    Default,
}

/// A road train: an axle with two wheels, and behind it trailers with an axle each, hitched at a distance.
struct Train {
    /// Half of the width of each axle, the radius of its wheels, and the length of the bar to the axle before.
    axles: Vec<(f64, f64, f64)>,
}

impl Train {
    fn drawn(chance: &mut Chance, axles: usize) -> Self {
        let draw = |chance: &mut Chance| (chance.draw(0.2, 0.9), chance.draw(0.05, 0.3), chance.draw(0.8, 2.0));
        Self { axles: (0..axles).map(|_| draw(chance)).collect() }
    }

    /// Its model, with its contacts along these axes.
    fn text(&self, axes: Axes) -> String {
        let along = if axes == Axes::Stated { "\nframe = \"N\"" } else { "" };
        let (mut parameters, mut coordinates, mut speeds) = (String::new(), String::new(), String::new());
        let (mut frames, mut points, mut bodies, mut rolling) =
            (String::new(), String::new(), String::new(), String::new());
        for (at, (d, r, l)) in self.axles.iter().enumerate() {
            let before = if at == 0 { "N".to_owned() } else { format!("A{}", at - 1) };
            let _ = writeln!(parameters, "d{at} = \"{d} m\"\nr{at} = \"{r} m\"\nl{at} = \"{l} m\"");
            let _ = writeln!(
                coordinates,
                "h{at} = {{ unit = \"rad\" }}\na{at} = {{ unit = \"rad\" }}\nb{at} = {{ unit = \"rad\" }}"
            );
            if at == 0 {
                let _ = writeln!(speeds, "v = \"x'*cos(h0) + y'*sin(h0)\"\nw = \"h0'\"");
            }
            let _ = writeln!(frames, "A{at} = {{ from = \"{before}\", axis = 3, angle = \"h{at}\" }}");
            let place = if at == 0 {
                "{ from = \"O\", frame = \"N\", position = [\"x\", \"y\", \"r0\"] }".to_owned()
            } else {
                format!(
                    "{{ from = \"G{}\", frame = \"A{at}\", position = [\"-l{at}\", 0, \"r{at} - r{}\"] }}",
                    at - 1,
                    at - 1
                )
            };
            let _ = writeln!(points, "G{at} = {place}");
            let _ = writeln!(
                bodies,
                "[bodies.axle{at}]\nframe = \"A{at}\"\ncentre = \"G{at}\"\nmass = \"m\"\ninertia = {{ diagonal = [\"J\", \"J\", \"J\"] }}"
            );
            for (side, sign) in [("a", ""), ("b", "-")] {
                let _ = writeln!(frames, "W{side}{at} = {{ from = \"A{at}\", axis = 2, angle = \"{side}{at}\" }}");
                let _ = writeln!(
                    points,
                    "C{side}{at} = {{ from = \"G{at}\", frame = \"A{at}\", position = [0, \"{sign}d{at}\", 0] }}"
                );
                let _ = writeln!(
                    points,
                    "P{side}{at} = {{ from = \"C{side}{at}\", frame = \"N\", position = [0, 0, \"-r{at}\"] }}"
                );
                let _ = writeln!(
                    bodies,
                    "[bodies.wheel{side}{at}]\nframe = \"W{side}{at}\"\ncentre = \"C{side}{at}\"\nmass = \"m\"\ninertia = {{ diagonal = [\"J\", \"J\", \"J\"] }}"
                );
                let _ =
                    writeln!(rolling, "[rolling.r{side}{at}]\nbody = \"wheel{side}{at}\"\nat = \"P{side}{at}\"{along}");
            }
        }
        format!(
            "name = \"train\"\n[parameters]\nm = \"1 kg\"\nJ = \"0.1 kg*m^2\"\n{parameters}[coordinates]\nx = {{ unit = \"m\" }}\ny = {{ unit = \"m\" }}\n\
             {coordinates}[speeds]\n{speeds}[inertial]\nframe = \"N\"\norigin = \"O\"\n[frames]\n{frames}[points]\n{points}{bodies}{rolling}"
        )
    }

    /// Slips of all wheels along the axes of the ground, per unit of each rate: of x, y, then of each axle's angle
    /// and those of its wheels. A slip is r' of the axle's middle, less the velocities at the contact from the
    /// turning of the axle and of the wheel.
    fn slips(&self, q: &[f64]) -> DMatrix<f64> {
        let n = 2 + 3 * self.axles.len();
        let mut rows = Vec::new();
        let (mut middle, mut heading) = (vec![vec![0.0; n], vec![0.0; n]], 0.0);
        (middle[0][0], middle[1][1]) = (1.0, 1.0);
        for (at, (d, r, l)) in self.axles.iter().enumerate() {
            heading += q[2 + 3 * at];
            let along = [heading.cos(), heading.sin()];
            let turning: Vec<usize> = (0..=at).map(|axle| 2 + 3 * axle).collect();
            if at > 0 {
                // The middle lies l behind that of the axle before, along its own heading: its velocity has −l h' e₂.
                for column in &turning {
                    middle[0][*column] += l * along[1];
                    middle[1][*column] -= l * along[0];
                }
            }
            for (wheel, side) in [(1, 1.0), (2, -1.0)] {
                for (middle, along) in middle.iter().zip(along) {
                    let mut row = middle.clone();
                    for column in &turning {
                        row[*column] -= side * d * along;
                    }
                    row[2 + 3 * at + wheel] -= r * along;
                    rows.extend(row);
                }
            }
        }
        DMatrix::from_row_slice(4 * self.axles.len(), n, &rows)
    }
}

fn rank(matrix: &DMatrix<f64>) -> usize {
    let values = matrix.clone().singular_values();
    values.iter().filter(|value| **value > 1e-9 * values.max()).count()
}

/// The slopes of the model's own constraints along rates, in a pose.
fn slopes(model: &Model, q: &[f64]) -> DMatrix<f64> {
    let mut arena = model.arena.clone();
    let equations: Vec<Expr> = model.motion_constraints.iter().map(|c| c.equation).collect();
    let mut entries = Vec::new();
    for equation in &equations {
        for rate in model.q_dot() {
            entries.push(Differential::partial(rate).apply(&mut arena, *equation));
        }
    }
    let known: Vec<f64> = model.parameters.iter().map(|p| p.value.as_ref().unwrap().to_f64()).collect();
    let tape = Tape::new(&arena, &[model.p(), model.q()].concat(), &entries).unwrap();
    DMatrix::from_row_slice(equations.len(), q.len(), &tape.evaluate(&[known.as_slice(), q].concat()))
}

/// Goal: no heading is a singular pose. Method: the slips of all wheels, written out in the test, whose rank is found
/// by singular values, at random headings and at quarter turns; the model's own constraints must span the same there.
#[test]
fn wheels_on_axles_are_regular_at_every_heading() {
    let mut chance = Chance(7);
    for axles in [1, 2, 2, 3] {
        let train = Train::drawn(&mut chance, axles);
        let model = read(&train.text(Axes::Default)).unwrap_or_else(|e| panic!("{e}"));
        let found = check(&model).unwrap_or_else(|e| panic!("{}", model.diagnose(&e)));
        let loss = found.rank_loss.unwrap();
        assert_eq!((loss.rank, loss.pose.as_ref()), (3 * axles, None));
        assert!(axles > 1 || loss.nowhere && !loss.proof.is_empty(), "{loss:?}");
        assert!(found.singular_where.is_empty() || axles > 1, "{:?}", found.singular_where);
        for turn in 0..8 {
            let q: Vec<f64> = (0..2 + 3 * axles)
                .map(|_| if turn < 4 { FRAC_PI_2 * f64::from(turn) } else { chance.draw(-PI, PI) })
                .collect();
            let (all, own) = (train.slips(&q), slopes(&model, &q));
            let both = DMatrix::from_fn(all.nrows() + own.nrows(), all.ncols(), |row, column| {
                if row < all.nrows() { all[(row, column)] } else { own[(row - all.nrows(), column)] }
            });
            assert_eq!((rank(&all), rank(&own), rank(&both)), (3 * axles, 3 * axles, 3 * axles), "{q:?}");
        }
    }
}

/// Goal: axes along which a file states contacts make no heading singular, although slips along them follow from each
/// other in most headings only. Method: one axle with two wheels, which has rank 3 in every heading.
#[test]
fn axes_of_contacts_make_no_heading_singular() {
    let mut chance = Chance(8);
    let loss = checked(&Train::drawn(&mut chance, 1).text(Axes::Stated)).rank_loss.unwrap();
    assert_eq!((loss.rank, loss.nowhere, loss.pose), (3, true, None));
}

/// Goal: formulas that are never zero together give no pose, and the proof is stated. Closed forms: the edge of a
/// sleigh has slopes of length 1, the norm of Euler parameters slopes of length 2.
#[test]
fn formulas_that_are_never_all_zero_are_a_proof_and_no_place() {
    for model in ["knife_edge", "rolling_disc", "satellite"] {
        let Some(loss) = checked(&of_library(model)).rank_loss else { continue };
        assert!(loss.nowhere && !loss.proof.is_empty(), "{model}: {loss:?}");
        assert_eq!((loss.where_all_zero, loss.pose), (Some(Vec::new()), None), "{model}");
    }
}

/// Goal: a pose that is reported as singular is singular. Method: fewer rows are independent there, by singular
/// values of slopes that the test computes itself.
#[test]
fn a_claimed_pose_loses_rank() {
    for lengths in [[0.3, 0.7, 0.3, 0.7], [0.4, 0.4, 0.7, 0.7], [0.3, 0.8, 0.6, 0.5]] {
        let loss = four_bar(lengths).rank_loss.unwrap();
        let [a, b, c, _] = lengths;
        let q: Vec<f64> = loss.pose.unwrap().iter().map(|(_, q)| *q).collect();
        let rows =
            [[-a * q[0].sin(), -b * q[1].sin(), c * q[2].sin()], [a * q[0].cos(), b * q[1].cos(), -c * q[2].cos()]];
        let values = DMatrix::from_row_slice(2, 3, rows.as_flattened()).singular_values();
        assert!(values.min() < 1e-4 * values.max(), "{lengths:?}: {values}");
        assert_eq!(loss.rank_there, Some(1));
    }
}

/// Goal: rows that are nearly parallel count as independent. Closed form: two edges 0.1 rad apart hold a disc in place
/// in every pose, so that only the third constraint is lost, where sin p = 0: rank 2 of 3.
#[test]
fn nearly_parallel_rows_count_in_the_rank_of_a_pose() {
    let text = r#"
name = "Two edges"
[parameters]
m = "2 kg"
I = "1 kg*m^2"
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
z = { unit = "m" }
p = { unit = "rad" }
[speeds]
w = "p'"
[constraints]
first = { equation = "x'*cos(p) + y'*sin(p) = 0" }
second = { equation = "x'*cos(p + 0.1) + y'*sin(p + 0.1) = 0" }
third = { equation = "z'*sin(p) = 0" }
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "p" }
[points]
P = { from = "O", frame = "N", position = ["x", "y", "z"] }
[bodies]
disc = { frame = "A", centre = "P", mass = "m", inertia = { diagonal = ["I", "I", "I"] } }
"#;
    let loss = checked(text).rank_loss.unwrap();
    let pose = loss.pose.unwrap();
    let p = pose.iter().find(|(name, _)| name == "p").unwrap().1;
    assert!(p.sin().abs() < 1e-6, "{pose:?}");
    assert_eq!((loss.rank, loss.rank_there), (3, Some(2)));
}

/// A scissor lift: each stage crosses two bars, and is pinned to the one below.
fn scissor(stages: usize) -> String {
    format!(
        r#"
name = "Scissor lift"
[counts]
n = {stages}
[parameters]
L = "1 m"
m = "2 kg"
g = "9.81 m/s^2"
[expressions]
J = "m*L^2/12"
[inertial]
frame = "N"
origin = "O"
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[bodies]
"a{{i in 1..n}}" = {{ mass = "m", inertia = {{ diagonal = [0,"J","J"] }} }}
"b{{i in 1..n}}" = {{ mass = "m", inertia = {{ diagonal = [0,"J","J"] }} }}
shoe = {{ mass = "m", inertia = {{ diagonal = [0,0,0] }} }}
[joints]
A1 = {{ kind = "pin", body = "a1", centre = ["L/2",0,0], coordinates = ["q1"], speeds = ["u1"] }}
B1 = {{ kind = "pin", body = "b1", to = "a1", at = ["L/2",0,0], coordinates = ["p1"], speeds = [] }}
S = {{ kind = "pin", body = "shoe", to = "b1", at = ["-L/2",0,0], coordinates = ["s"], speeds = [] }}
G = {{ kind = "slider", axis = 1, body = "shoe" }}
A2 = {{ kind = "pin", body = "a2", to = "b1", at = ["L/2",0,0], centre = ["L/2",0,0], coordinates = ["q2"], speeds = [] }}
"A{{i in 3..n}}" = {{ kind = "pin", body = "a{{i}}", to = "b{{i-1}}", at = ["L",0,0], centre = ["L/2",0,0], coordinates = ["q{{i}}"], speeds = [] }}
"B{{i in 2..n}}" = {{ kind = "pin", body = "b{{i}}", to = "a{{i-1}}", at = ["L",0,0], centre = ["L/2",0,0], coordinates = ["p{{i}}"], speeds = [] }}
"X{{i in 2..n}}" = {{ kind = "pin", body = "b{{i}}", to = "a{{i}}", at = ["L/2",0,0], body_at = ["L/2",0,0] }}
"#
    )
}

/// Goal: a lift has one freedom, as its file declares, however many of its stages random poses find folded.
#[test]
fn a_scissor_lift_is_judged_on_the_branch_with_as_many_freedoms_as_speeds() {
    for stages in [3, 6, 9] {
        let model = read(&scissor(stages)).unwrap_or_else(|e| panic!("{stages}: {e}"));
        let branch = model.branch.as_ref().unwrap();
        assert_eq!((model.speeds.len(), model.coordinates.len() - branch.rank), (1, 1));
        // Folded flat, each stage may open alone.
        assert_eq!(branch.larger.as_ref().map(|(freedoms, _)| *freedoms), Some(stages), "{branch:?}");
    }
}

/// Goal: the branch with most freedoms is taken if the file declares as many speeds. Closed form: two stages that lie
/// flat turn and open independently.
#[test]
fn a_folded_lift_is_judged_on_its_own_branch() {
    let text = scissor(2).replace("speeds = [\"u1\"]", "speeds = []");
    let model = read(&format!("{text}[speeds]\nu1 = \"q1'\"\nu2 = \"q2'\"\n")).unwrap_or_else(|e| panic!("{e}"));
    let branch = model.branch.as_ref().unwrap();
    assert_eq!((model.speeds.len(), branch.rank, branch.larger.as_ref()), (2, 3, None));
}

/// Goal: sines and cosines of asin, acos and atan are algebraic. Method: a wheel on a wavy road does not leave it,
/// whatever the slope is.
#[test]
fn a_wheel_on_a_wavy_road_has_one_freedom() {
    let text = |slope: &str| {
        format!(
            "name = \"road\"\n[parameters]\nr = \"0.3 m\"\nm = \"1 kg\"\nA = \"0.1 m\"\nk = {{ unit = \"1/m\", value = 1 }}\n[coordinates]\nxc = {{ unit = \"m\" }}\n\
             q = {{ unit = \"rad\" }}\n[speeds]\nu = \"xc'\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[frames]\nS = {{ from = \"N\", axis = 3, angle = \"{slope}\" }}\n\
             B = {{ from = \"S\", axis = 3, angle = \"q\" }}\n[points]\nC = {{ from = \"O\", frame = \"N\", position = [\"xc\", \"A*sin(k*xc)\", 0] }}\n\
             G = {{ from = \"C\", frame = \"S\", position = [0, \"r\", 0] }}\n[bodies.wheel]\nframe = \"B\"\ncentre = \"G\"\nmass = \"m\"\ninertia = \"m*r^2/2\"\n\
             [rolling.road]\nbody = \"wheel\"\nat = \"C\"\n"
        )
    };
    for slope in ["atan(A*k*cos(k*xc))", "atan2(A*k*cos(k*xc), 1)", "asin(A*k*cos(k*xc)/sqrt(1 + A^2*k^2*cos(k*xc)^2))"]
    {
        let found = checked(&text(slope));
        assert_eq!(
            (found.degrees_of_freedom, found.singular_where.len()),
            (1, 0),
            "{slope}: {:?}",
            found.singular_where
        );
        assert_eq!(found.rank_loss.unwrap().pose, None, "{slope}");
    }
}

/// Goal: an equation whose rate follows from another's repeats it or contradicts it. Method: circles about one centre.
#[test]
fn an_equation_that_contradicts_another_is_told_from_one_that_repeats_it() {
    let circles = |second: &str| {
        let text = format!(
            "name = \"bob\"\n[parameters]\nm = \"1 kg\"\nl = \"1 m\"\n[coordinates]\nx = {{ unit = \"m\" }}\ny = {{ unit = \"m\" }}\n[speeds]\nu = \"x'\"\n[inertial]\n\
             frame = \"N\"\norigin = \"O\"\n[points]\nP = {{ from = \"O\", frame = \"N\", position = [\"x\", \"y\", 0] }}\n[particles]\nbob = {{ point = \"P\", mass = \"m\" }}\n\
             [constraints]\na = {{ equation = \"x^2 + y^2 = l^2\" }}\nb = {{ equation = \"{second}\" }}\n"
        );
        read(&text).err().map(|errors| errors.to_string()).unwrap_or_default()
    };
    let said = |second: &str, what: &str| {
        let errors = circles(second);
        assert!(errors.contains(&format!("the constraint `b` {what}")), "{second}: {errors}");
    };
    said("x^2 + y^2 = 4*l^2", "contradicts those before it");
    said("sqrt(x^2 + y^2) = 3*l", "contradicts those before it");
    said("sqrt(x^2 + y^2) = l", "follows from those before it");
    said("(x^2 + y^2)^2 = l^4", "follows from those before it");
}
