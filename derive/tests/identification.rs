//! Base parameters: number, combinations, minimality and completeness.
//!
//! Truth: W. Khalil & E. Dombre, *Modeling, Identification and Control of Robots* (2002), § 9.4, whose grouping
//! relations are typed in and carried out here in numbers; M. Gautier & W. Khalil, IEEE Trans. Robotics and
//! Automation 6 (1990) 368-373; M. Gautier, J. Robotic Systems 8 (1991) 485-506, for the rank in numbers.

use nalgebra::DMatrix;
use std::fmt::Write;
use std::path::Path;
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::diagnostic::Source;
use tripos_derive::identify::{BaseParameterFactor, Completeness, Identification};
use tripos_derive::mechanics::{ColumnParameter, InertialParameter, RegressorParameters};

fn library(model: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(model).join("model.toml");
    Model::read(&path).unwrap_or_else(|e| panic!("{e}"))
}

fn model(text: &str) -> Model {
    tripos_derive::model::load(&Source::from_text("model.toml", text)).unwrap_or_else(|e| panic!("{e}"))
}

fn identify(model: &Model, varied: RegressorParameters) -> Identification {
    Identification::new(model, varied).unwrap_or_else(|e| panic!("{e:?}"))
}

/// The base parameters as sums.
fn sums(found: &Identification) -> Vec<String> {
    let name = |at: usize| found.regressor.columns[at].name.clone();
    let factor = |factor: &BaseParameterFactor| match factor {
        BaseParameterFactor::Exact(e) => print_text(&found.regressor.arena, *e),
        other => format!("{other:?}"),
    };
    let sum = |base: &tripos_derive::identify::BaseParameter| {
        let with: Vec<String> = base.with.iter().map(|(at, k)| format!(" + ({}) {}", factor(k), name(*at))).collect();
        name(base.column) + &with.concat()
    };
    found.base.iter().map(sum).collect()
}

fn is_proved(found: &Identification) -> bool {
    matches!(found.complete, Completeness::Proved(bound) if bound >= 32.0)
}

const ARM: &str = r#"
name = "Two links"
[parameters]
g = { unit = "m/s^2", value = 9.81 }
L1 = { unit = "m", value = 0.5 }
c1 = { unit = "m", value = 0.2 }
c2 = { unit = "m", value = 0.3 }
m1 = { unit = "kg", value = 2, positive = true }
m2 = { unit = "kg", value = 1, positive = true }
I1 = { unit = "kg*m^2", value = 0.1, positive = true }
I2 = { unit = "kg*m^2", value = 0.05, positive = true }
d1 = { unit = "N*m*s", value = 0.3 }
k2 = { unit = "N*m", value = 7 }
[inputs]
tau1 = { unit = "N*m" }
[coordinates]
q1 = { unit = "rad" }
q2 = { unit = "rad" }
[speeds]
u1 = "q1'"
u2 = "q2'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "q1" }
B = { from = "A", axis = 3, angle = "q2" }
[points]
E = { from = "O", frame = "A", position = ["L1", 0, 0] }
C1 = { from = "O", frame = "A", position = ["c1", 0, 0] }
C2 = { from = "E", frame = "B", position = ["c2", 0, 0] }
[bodies]
one = { frame = "A", centre = "C1", mass = "m1", inertia = "I1" }
two = { frame = "B", centre = "C2", mass = "m2", inertia = "I2" }
[torques]
damper = { on = "one", frame = "N", vector = [0, 0, "tau1 - d1*u1"] }
spring = { on = "two", against = "one", frame = "A", vector = [0, 0, "-k2*sin(q2)"] }
"#;

const GRAVITY: &str = "[gravity]\nframe = \"N\"\nacceleration = [0, \"-g\", 0]\n";

/// Goal: the base parameters of the textbook's planar arm of two links, with and without gravity in its plane. Method:
/// its closed form, by hand: the second mass acts as if it were at the end of the first link, and a first moment about
/// a joint that stands still shows in weight alone (Khalil & Dombre, § 9.4.2.4).
#[test]
fn a_planar_arm_has_the_base_parameters_of_the_textbook() {
    let falling = identify(&model(&format!("{ARM}{GRAVITY}")), RegressorParameters::Bodies);
    assert_eq!(
        sums(&falling),
        ["Izz_one + (L1^2) m_two", "mx_one + (L1) m_two", "my_one", "Izz_two", "mx_two", "my_two", "d1", "k2"]
    );
    assert!(is_proved(&falling), "{:?}", falling.complete);
    assert_eq!(falling.without_effect.len(), 7 + 6);
    let level = identify(&model(ARM), RegressorParameters::Bodies);
    assert_eq!(sums(&level), ["Izz_one + (L1^2) m_two", "Izz_two", "mx_two", "my_two", "d1", "k2"]);
    assert!(is_proved(&level), "{:?}", level.complete);
}

/// Goal: declared parameters are grouped as they enter, those of loads among them. Method: by hand. With known lengths,
/// m₁ acts by c₁² with I₁ and in weight by itself, m₂ in the first link and in the second.
#[test]
fn declared_parameters_are_grouped_as_they_enter() {
    let falling = identify(&model(&format!("{ARM}{GRAVITY}")), RegressorParameters::Declared);
    assert_eq!(sums(&falling), ["m1", "m2", "I1", "I2", "d1", "k2"]);
    let level = identify(&model(ARM), RegressorParameters::Declared);
    assert_eq!(sums(&level), ["m1 + (1/c1^2) I1", "m2", "I2", "d1", "k2"]);
    assert!(is_proved(&falling) && is_proved(&level), "{:?} {:?}", falling.complete, level.complete);
}

/// The ten parameters of a link in the order XX, XY, XZ, YY, YZ, ZZ, MX, MY, MZ, M.
type Ten = [f64; 10];

/// Joints by the notation of Khalil and Kleinfinger: α, d, r of each.
const PUMA: [(f64, &str, &str); 6] =
    [(0.0, "", ""), (1.0, "", ""), (0.0, "a2", "d3"), (-1.0, "a3", "d4"), (1.0, "", ""), (-1.0, "", "")];

/// Moves the parameters that a revolute joint's link shares with the link before into that link, by the grouping
/// relations of Khalil & Dombre, chapter 9. `turn` is α in quarter turns.
fn grouped(link: &mut Ten, before: &mut Ten, turn: f64, d: f64, r: f64) {
    let (s, c) = (turn, 1.0 - turn.abs());
    let [_, _, _, yy, _, _, _, _, mz, m] = *link;
    link[0] -= yy;
    before[0] += yy + 2.0 * r * mz + r * r * m;
    before[1] += d * s * mz + d * r * s * m;
    before[2] -= d * c * mz + d * r * c * m;
    before[3] += c * c * yy + 2.0 * r * c * c * mz + (d * d + r * r * c * c) * m;
    before[4] += c * s * yy + 2.0 * r * c * s * mz + r * r * c * s * m;
    before[5] += s * s * yy + 2.0 * r * s * s * mz + (d * d + r * r * s * s) * m;
    before[6] += d * m;
    before[7] -= s * mz + r * s * m;
    before[8] += c * mz + r * c * m;
    before[9] += m;
}

/// The ten parameters about a point r below along z.
fn lowered(link: &Ten, r: f64) -> Ten {
    let [xx, xy, xz, yy, yz, zz, mx, my, mz, m] = *link;
    let away = 2.0 * r * mz + r * r * m;
    [xx + away, xy, xz - r * mx, yy + away, yz - r * my, zz, mx, my, mz + r * m, m]
}

fn place(inertial: InertialParameter) -> usize {
    match inertial {
        InertialParameter::Inertia(i, j) => [[0, 1, 2], [1, 3, 4], [2, 4, 5]][i][j],
        InertialParameter::FirstMoment(i) => 6 + i,
        InertialParameter::Mass => 9,
        InertialParameter::SecondMoment(_) => unreachable!("the parameters of bodies are moments of inertia"),
    }
}

/// Goal: an arm of six joints has the published number and combinations of base parameters. Method: the number is 36
/// for this geometry (Gautier & Khalil 1990; for the same geometry Khalil & Dombre, table 9.4, 36 and 4 of rotors): 1
/// of the first link and 7 of each of the others. For random numbers, the book's recursion gives the values of the
/// formulas found here for the same bodies. The book takes a link about the end of its offset along the joint, the
/// model about the joint before it. This matters for the forearm alone.
#[test]
fn the_puma_has_its_published_base_parameters() {
    let model = library("puma560");
    let mut found = identify(&model, RegressorParameters::Bodies);
    let of_link = |at: usize| {
        found
            .base
            .iter()
            .filter(|b| matches!(found.regressor.columns[b.column].of, ColumnParameter::Body(of, _) if of == at))
            .count()
    };
    assert_eq!((0..6).map(of_link).collect::<Vec<_>>(), [1, 7, 7, 7, 7, 7]);
    assert_eq!(found.base.len(), 36);
    assert!(is_proved(&found), "{:?}", found.complete);
    let value = |name: &str| {
        model.parameters.iter().find(|p| p.name == name).map_or(0.0, |p| p.value.as_ref().unwrap().to_f64())
    };
    let mut links: Vec<Ten> = Vec::new();
    for link in 0..6_u32 {
        links.push(std::array::from_fn(|k| (1.0 + f64::from(10 * link) + k as f64).sin() + 1.5));
    }
    let mut published = links.clone();
    for joint in (0..6).rev() {
        let (turn, d, r) = PUMA[joint];
        let (d, r) = (value(d), value(r));
        let mut before = if joint == 0 { [0.0; 10] } else { published[joint - 1] };
        grouped(&mut published[joint], &mut before, turn, d, r);
        if joint > 0 {
            published[joint - 1] = before;
        }
    }
    let offset = value("d3");
    links[2] = lowered(&links[2], offset);
    let (mx, my) = (published[2][6], published[2][7]);
    published[2][2] -= offset * mx;
    published[2][4] -= offset * my;
    let factors: Vec<Expr> = found
        .base
        .iter()
        .flat_map(|base| &base.with)
        .map(|(_, k)| if let BaseParameterFactor::Exact(e) = k { *e } else { panic!("{k:?}") })
        .collect();
    let tape = Tape::new(&found.regressor.arena, &model.p(), &factors).unwrap();
    let p: Vec<f64> = model
        .parameters
        .iter()
        .map(|p| p.value.as_ref().map_or(0.0, tripos_derive::algebra::Rational::to_f64))
        .collect();
    let mut factors = tape.evaluate(&p).into_iter();
    let of = |column: usize, list: &[Ten]| match found.regressor.columns[column].of {
        ColumnParameter::Body(body, inertial) => list[body][place(inertial)],
        ColumnParameter::Parameter(_) => panic!("no load has one"),
    };
    for base in std::mem::take(&mut found.base) {
        let sum = base
            .with
            .iter()
            .fold(of(base.column, &links), |sum, (at, _)| sum + factors.next().unwrap() * of(*at, &links));
        let name = &found.regressor.columns[base.column].name;
        let wanted = of(base.column, &published);
        assert!((sum - wanted).abs() < 1e-12, "{name}: {sum} {wanted}");
    }
}

/// Goal: the number of base parameters is the rank, in numbers too. Method: all columns, and those of the base
/// parameters, in doubles at random states and at the values of the file (Gautier 1991); their singular values are
/// far from one another.
#[test]
fn ranks_in_numbers_are_those_of_exact_algebra() {
    for name in ["puma560", "furuta", "rolling_disc", "heavy_top", "cart_with_spring", "gimbals"] {
        let model = library(name);
        let found = identify(&model, RegressorParameters::Bodies);
        let rates: Vec<Expr> = model.speeds.iter().map(|s| s.rate).collect();
        let known = [model.p(), model.q(), model.u(), rates].concat();
        let columns = &found.regressor.columns;
        let terms: Vec<Expr> = columns.iter().flat_map(|column| column.forces.clone()).collect();
        let tape = Tape::new(&found.regressor.arena, &known, &terms).unwrap();
        let p: Vec<f64> = model
            .parameters
            .iter()
            .map(|p| p.value.as_ref().map_or(0.7, tripos_derive::algebra::Rational::to_f64))
            .collect();
        let (speeds, states) = (model.speeds.len(), 60);
        let mut matrix = DMatrix::zeros(states * speeds, columns.len());
        for state in 0..states {
            let draw = |k: usize| (1.7 + 12.9898 * (k + 97 * state) as f64).sin() * 2.0;
            let values: Vec<f64> = p.iter().copied().chain((0..known.len() - p.len()).map(draw)).collect();
            let forces = tape.evaluate(&values);
            for column in 0..columns.len() {
                for speed in 0..speeds {
                    matrix[(state * speeds + speed, column)] = forces[column * speeds + speed];
                }
            }
        }
        let rank = |matrix: DMatrix<f64>| {
            let values = matrix.singular_values();
            values.iter().filter(|x| **x > 1e-9 * values.max()).count()
        };
        let base: Vec<usize> = found.base.iter().map(|base| base.column).collect();
        assert_eq!(rank(matrix.select_columns(&base)), base.len(), "{name}");
        assert_eq!(rank(matrix), base.len(), "{name}");
        assert!(is_proved(&found), "{name}: {:?}", found.complete);
    }
}

/// Goal: all kinds of mechanisms have proved base parameters. Method: models with rolling, time, Euler parameters,
/// springs and loops, with the parameters of bodies and with the declared ones. The result is proved against Kane's
/// equations, which share only velocities with it.
#[test]
fn base_parameters_are_proved_for_all_kinds_of_mechanisms() {
    for name in [
        "pendulum",
        "driven_pendulum",
        "elastic_pendulum",
        "rolling_disc",
        "knife_edge",
        "satellite",
        "euler_top",
        "four_bar",
    ] {
        let model = library(name);
        for varied in [RegressorParameters::Bodies, RegressorParameters::Declared] {
            let found = identify(&model, varied);
            assert!(is_proved(&found), "{name}: {:?}", found.complete);
            assert!(!found.base.is_empty(), "{name}");
        }
    }
}

/// Goal: loops leave fewer parameters that act apart. Method: four bars, by hand. A mass at the far pin of the
/// coupler acts like one at the end of the rocker, so that m_b + b mx_b + b² I_b of the coupler and c mx_c + c² I_c
/// of the rocker belong to the same motion. An open chain and a rocker have nine parameters, of which eight are left.
/// Closed poses, in doubles, show no more.
#[test]
fn loops_group_what_acts_as_one() {
    let found = identify(&library("four_bar"), RegressorParameters::Bodies);
    let seen = found.on_loops.expect("closed poses are found");
    assert!(seen.dependent < 1e-9 && seen.independent > 1e-6, "{seen:?}");
    let name = |at: usize| found.regressor.columns[at].name.as_str();
    let names: Vec<&str> = found.base.iter().map(|base| name(base.column)).collect();
    let wanted =
        ["Izz_crank", "mx_crank", "my_crank", "Izz_coupler", "mx_coupler", "my_coupler", "Izz_rocker", "my_rocker"];
    assert_eq!(names, wanted);
    let all = sums(&found);
    let factors = ["(a^2/c)", "(a/c)", "", "(b^2/c)", "(b/c)", "", "(-c)", ""];
    for (sum, factor) in all.iter().zip(factors) {
        assert_eq!(sum.contains(&format!("{factor} mx_rocker")), !factor.is_empty(), "{sum}");
    }
    assert!(is_proved(&found), "{:?}", found.complete);
}

/// Four-bar linkage with these lengths of crank, coupler, rocker and ground, and this generalized speed.
fn four_bars([a, b, c, d]: [f64; 4], speed: &str) -> Model {
    model(&format!(
        r#"
name = "Four bars"
[parameters]
g = {{ unit = "m/s^2", value = 9.81 }}
m = {{ unit = "kg", value = 1.2 }}
I = {{ unit = "kg*m^2", value = 0.1 }}
a = {{ unit = "m", value = {a:?} }}
b = {{ unit = "m", value = {b:?} }}
c = {{ unit = "m", value = {c:?} }}
d = {{ unit = "m", value = {d:?} }}
[coordinates]
q1 = {{ unit = "rad" }}
q2 = {{ unit = "rad" }}
q3 = {{ unit = "rad" }}
[speeds]
u1 = "{speed}"
[inertial]
frame = "N"
origin = "O"
[frames]
B1 = {{ from = "N", axis = 3, angle = "q1" }}
B2 = {{ from = "N", axis = 3, angle = "q2" }}
B3 = {{ from = "N", axis = 3, angle = "q3" }}
[points]
A = {{ from = "O", frame = "B1", position = ["a", 0, 0] }}
E = {{ from = "O", frame = "N", position = ["d", 0, 0] }}
C1 = {{ from = "O", frame = "B1", position = ["a/2", 0, 0] }}
C2 = {{ from = "A", frame = "B2", position = ["b/2", 0, 0] }}
C3 = {{ from = "E", frame = "B3", position = ["c/2", 0, 0] }}
[bodies]
b1 = {{ frame = "B1", centre = "C1", mass = "m", inertia = "I" }}
b2 = {{ frame = "B2", centre = "C2", mass = "m", inertia = "I" }}
b3 = {{ frame = "B3", centre = "C3", mass = "m", inertia = "I" }}
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[constraints]
lx = {{ equation = "a*cos(q1) + b*cos(q2) = d + c*cos(q3)" }}
ly = {{ equation = "a*sin(q1) + b*sin(q2) = c*sin(q3)" }}
"#
    ))
}

/// Goal: poses near dead points of the chosen speed hide no base parameter. Method: four bars have eight of them, by
/// hand as in `loops_group_what_acts_as_one`, for all lengths and speeds. The first lengths had a pose so near a dead
/// point that a column was lost. The gap between dependent and independent columns is clear.
#[test]
fn poses_near_dead_points_hide_no_parameter() {
    let lengths = [[0.4, 1.12, 0.81, 0.89], [0.31, 0.97, 0.74, 0.83], [0.55, 0.6, 0.7, 0.9], [0.9, 0.35, 0.8, 0.7]];
    for lengths in lengths {
        for speed in ["q1'", "q2'", "q3'"] {
            let found = identify(&four_bars(lengths, speed), RegressorParameters::Bodies);
            let seen = found.on_loops.expect("closed poses are found");
            let what = format!("{lengths:?}, {speed}: {seen:?}");
            assert_eq!(found.base.len(), 8, "{what}");
            assert!(found.is_minimal() && seen.is_clear && seen.independent > 1e6 * seen.dependent, "{what}");
            assert_eq!(found.before_grouping(), None, "{what}");
            assert!(is_proved(&found), "{what}");
        }
    }
}

/// Goal: six bars whose chosen speed fails in some poses keep all base parameters. Method: four bars, and a rod from
/// their far pin to a slider. Eleven parameters act apart, by the singular values of a regressor in 50 closed poses
/// with random rates and accelerations. For other lengths Tripos always found eleven.
#[test]
fn six_bars_keep_all_parameters() {
    let found = identify(&model(SIX_BARS), RegressorParameters::Bodies);
    let seen = found.on_loops.expect("closed poses are found");
    assert!(seen.is_clear, "{seen:?}");
    assert_eq!(found.base.len(), 11, "{:?}", sums(&found));
}

const SIX_BARS: &str = r#"
name = "six23"
[parameters]
g = { unit = "m/s^2", value = 9.81 }
m = { unit = "kg", value = 1.2 }
I = { unit = "kg*m^2", value = 0.1 }
a = { unit = "m", value = 0.47 }
b = { unit = "m", value = 0.83 }
c = { unit = "m", value = 0.94 }
d = { unit = "m", value = 0.87 }
f = { unit = "m", value = 1.27 }
h = { unit = "m", value = 0.17 }
[coordinates]
q1 = { unit = "rad" }
q2 = { unit = "rad" }
q3 = { unit = "rad" }
q4 = { unit = "rad" }
x = { unit = "m" }
[speeds]
u3 = "q4'"
[inertial]
frame = "N"
origin = "O"
[frames]
B1 = { from = "N", axis = 3, angle = "q1" }
B2 = { from = "N", axis = 3, angle = "q2" }
B3 = { from = "N", axis = 3, angle = "q3" }
B4 = { from = "N", axis = 3, angle = "q4" }
[points]
A = { from = "O", frame = "B1", position = ["a", 0, 0] }
Q = { from = "A", frame = "B2", position = ["b", 0, 0] }
E = { from = "O", frame = "N", position = ["d", 0, 0] }
R = { from = "E", frame = "B3", position = ["c", 0, 0] }
C1 = { from = "O", frame = "B1", position = ["a/2", 0, 0] }
C2 = { from = "A", frame = "B2", position = ["b/2", 0, 0] }
C3 = { from = "E", frame = "B3", position = ["c/2", 0, 0] }
C4 = { from = "R", frame = "B4", position = ["f/2", 0, 0] }
S = { from = "R", frame = "B4", position = ["f", 0, 0] }
U = { from = "O", frame = "N", position = ["x", "h", 0] }
[bodies.b1]
frame = "B1"
centre = "C1"
mass = "m"
inertia = "I"
[bodies.b2]
frame = "B2"
centre = "C2"
mass = "m"
inertia = "I"
[bodies.b3]
frame = "B3"
centre = "C3"
mass = "m"
inertia = "I"
[bodies.b4]
frame = "B4"
centre = "C4"
mass = "m"
inertia = "I"
[particles.sl]
point = "U"
mass = "m"
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[constraints]
l10 = { equation = "p(Q) @ N [1] = p(R) @ N [1]" }
l20 = { equation = "p(Q) @ N [2] = p(R) @ N [2]" }
l11 = { equation = "p(S) @ N [1] = p(U) @ N [1]" }
l21 = { equation = "p(S) @ N [2] = p(U) @ N [2]" }
"#;

/// Goal: factors are formulas also where angles stay as letters. Method: two links whose joints are skew by β. The
/// second link adds to the first by the sine and cosine of β (Khalil & Dombre, chapter 9, with d = 0).
#[test]
fn factors_hold_sines_of_angles_that_stay() {
    let text = ARM
        .replace(
            "B = { from = \"A\", axis = 3",
            "S = { from = \"A\", axis = 1, angle = \"beta\" }\nB = { from = \"S\", axis = 3",
        )
        .replace("inertia = \"I2\"", "inertia = { diagonal = [\"I2\", \"I2\", \"I2\"] }")
        .replace("[inputs]", "beta = { unit = \"rad\", value = 0.3 }\n[inputs]");
    let found = identify(&model(&text), RegressorParameters::Bodies);
    assert!(is_proved(&found), "{:?}", found.complete);
    let all = sums(&found);
    assert!(all[0].starts_with("Izz_one") && all[0].contains("Iyy_two") && all[0].contains("cos(beta)^2"), "{all:?}");
}

/// Goal: square roots hide no parameter. Method: a slider along an oblique axis, whose direction has √5, which exists
/// modulo every second prime; and a chain with four smoothed frictions, whose square roots rarely all exist at a random
/// state.
#[test]
fn square_roots_hide_no_parameter() {
    let slider = model(
        r#"
name = "slider along an oblique axis"
[parameters]
m = { unit = "kg", value = 1, positive = true }
g = { unit = "m/s^2", value = 9.81 }
[inertial]
frame = "N"
origin = "O"
[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
[bodies]
b1 = { mass = "m", inertia = { diagonal = [0, 0, 0] } }
[joints]
j1 = { kind = "slider", body = "b1", axis = [1, 0, 2] }
"#,
    );
    let found = identify(&slider, RegressorParameters::Bodies);
    assert_eq!(sums(&found), ["m_b1"]);
    assert!(is_proved(&found));
    let mut chain = r#"
name = "chain"
[parameters]
m = { unit = "kg", value = 1, positive = true }
l = { unit = "m", value = 1, positive = true }
f = { unit = "N*m", value = 1, positive = true }
[inertial]
frame = "N"
origin = "O"
[bodies]
"#
    .to_owned();
    let links = 4;
    for k in 1..=links {
        let _ = writeln!(chain, "b{k} = {{ mass = \"m\", inertia = \"m*l^2/12\" }}");
    }
    for (section, keys) in [
        ("joints", "kind = \"pin\", body = \"bK\", axis = 3, centre = [\"l/2\", 0, 0]"),
        ("friction", "on = \"bK\", frame = \"N\", axis = 3, torque = \"f\", smoothing = \"0.01 rad/s\""),
    ] {
        let _ = writeln!(chain, "[{section}]");
        for k in 1..=links {
            let own = keys.replace('K', &k.to_string());
            let before = match (section, k) {
                (_, 1) => String::new(),
                ("joints", _) => format!(", to = \"b{}\", at = [\"l\", 0, 0]", k - 1),
                _ => format!(", against = \"b{}\"", k - 1),
            };
            let _ = writeln!(chain, "{section}{k} = {{ {own}{before} }}");
        }
    }
    let found = identify(&model(&chain), RegressorParameters::Bodies);
    // Three of the last link and of each link before it, less what the first joint does not show without gravity.
    assert_eq!(found.base.len(), 11, "{:?}", sums(&found));
    assert!(is_proved(&found));
}
