//! Forces and torques between bodies, named by the bodies; and forces that lie along no axis of a frame.
//!
//! Truth: closed forms, three formulations that are proved equal, and mechanisms that are overdetermined.

use crate::common::read;
use std::fmt::Write;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::text::parse::parse;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::mechanics::derive_all;
use tripos_derive::model::Model;
use tripos_derive::prove::prove;
use tripos_derive::scene::load_output;

fn loaded(text: &str) -> Model {
    read(text).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// Checks that all three formulations are there and equal.
fn proved(model: &Model, what: &str) {
    let mut derivations = derive_all(model).unwrap_or_else(|e| panic!("{what}: {e}"));
    let proof = prove(model, &mut derivations);
    assert!(proof.is_equivalent() && proof.pairs.len() == 3, "{what}: {:?} {:?}", proof.missing, proof.pairs);
}

fn value(model: &mut Model, text: &str) -> Expr {
    load_output(text, model).unwrap_or_else(|e| panic!("{e}")).value
}

fn refused(model: &mut Model, text: &str) -> String {
    load_output(text, model).err().unwrap_or_else(|| panic!("{text} must be refused")).to_string()
}

/// True if two terms are proved equal; the second is in names of the model.
fn means(model: &mut Model, e: Expr, text: &str) -> bool {
    let other = parse(&mut model.arena, text, &mut |arena, name| Ok(arena.symbol(name))).unwrap();
    let difference = model.arena.sub(e, other);
    zero_test(&model.arena, difference) == ZeroTest::Zero
}

const WORLD: &str = r#"
name = "two rods"
[parameters]
m = "1 kg"
l = "1 m"
r = "0.3 m"
I = "1 kg*m^2"
g = "9.81 m/s^2"
[inertial]
frame = "N"
origin = "O"
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

fn two_rods() -> Model {
    loaded(&format!(
        "{WORLD}[bodies]\nupper = {{ mass = \"m\", inertia = \"I\" }}\nlower = {{ mass = \"m\", inertia = \"I\" }}\n[joints]\nA = {{ kind = \
         \"pin\", body = \"upper\", centre = [\"l/2\", 0, 0], coordinates = [\"q1\"] }}\nB = {{ kind = \"pin\", body = \"lower\", to = \"upper\", at \
         = [\"l\", 0, 0], centre = [\"l/2\", 0, 0], coordinates = [\"q2\"] }}\n"
    ))
}

/// Goal: the name states the two bodies, the place and the direction of a force. Method: a double pendulum, whose
/// reactions are `lower_force_…` on the lower rod at B from the upper one; by hand turned, reversed, and with the arm
/// from A to B.
#[test]
fn a_force_between_two_bodies_is_the_sum_of_their_reactions() {
    let model = &mut two_rods();
    let names: Vec<String> = model.reactions.iter().map(|r| r.name.clone()).collect();
    assert_eq!(names, ["lower_force_upper_frame1", "lower_force_upper_frame2", "upper_force_n1", "upper_force_n2"]);
    let (x, y) = ("lower_force_upper_frame1", "lower_force_upper_frame2");
    for (name, expected) in [
        ("force(upper on lower) @ upper_frame [1]".to_owned(), x.to_owned()),
        ("force( upper  on lower )@N[2]".to_owned(), format!("{x}*sin(q1) + {y}*cos(q1)")),
        ("force(lower on upper) @ lower_frame [1]".to_owned(), format!("-{x}*cos(q2) - {y}*sin(q2)")),
        ("force(upper on lower) @ N [3]".to_owned(), "0".to_owned()),
        ("torque(upper on lower) @ N [3]".to_owned(), "0".to_owned()),
        ("torque(upper on lower about A) @ N [3]".to_owned(), format!("l*{y}")),
        (
            "torque(lower on upper about lower_centre) @ N [3]".to_owned(),
            format!("-(-l/2)*(-{x}*sin(q2) + {y}*cos(q2))"),
        ),
        ("2*force(ground on upper) @ N [1] - force(upper on N) @ N [1]".to_owned(), "3*upper_force_n1".to_owned()),
    ] {
        let e = value(model, &name);
        assert!(means(model, e, &expected), "{name} is not {expected}");
    }
}

#[test]
fn what_acts_nowhere_is_refused_by_name() {
    let model = &mut two_rods();
    for (name, message) in [
        ("force(ground on lower) @ N [1]", "no reaction acts between `ground` and `lower`"),
        ("force(upper on rod) @ N [1]", "the model has no body `rod`"),
        ("force(upper on upper) @ N [1]", "names one body twice"),
        ("force(upper on lower) @ M [1]", "the model has no frame `M`"),
        ("torque(upper on lower about Q) @ N [1]", "the model has no point `Q`"),
        ("force(upper on lower) @ N [4]", "there is no component `4`"),
        ("force(upper, lower) @ N [1]", "`on` is missing here"),
        ("force(upper on lower about A) @ N [1]", "`)` is missing here"),
        ("force(upper on lower)", "`@` is missing here"),
        ("force", "unknown name `force`"),
    ] {
        let errors = refused(model, name);
        assert!(errors.contains(message), "{name}: {errors}");
    }
    let errors = refused(model, "force(ground on lower) @ N [1]");
    assert!(errors.contains("reactions are of upper on lower, ground on upper"), "{errors}");
}

/// Goal: a torque is refused without the name of its point if the reactions between the bodies act at several points.
/// Method: a rod with a pin at O and a force at P, both in the file.
#[test]
fn a_torque_about_several_points_asks_which() {
    let text = format!(
        "{WORLD}[coordinates]\nq = {{ unit = \"rad\" }}\n[speeds]\nu = \"q'\"\n[frames]\nB = {{ from = \"N\", axis = 3, angle = \"q\" \
         }}\n[points]\nP = {{ from = \"O\", frame = \"N\", position = [\"l\", 0, 0] }}\nC = {{ from = \"O\", frame = \"B\", position = \
         [\"l/2\", 0, 0] }}\n[bodies.rod]\nframe = \"B\"\ncentre = \"C\"\nmass = \"m\"\ninertia = \"I\"\n[reactions]\nX = {{ on = \"rod\", at = \
         \"O\", frame = \"N\", direction = [1, 0, 0] }}\nY = {{ on = \"rod\", at = \"O\", frame = \"N\", direction = [0, 1, 0] \
         }}\nW = {{ on = \"rod\", at = \"P\", frame = \"N\", direction = [0, 0, 1] }}\n"
    );
    let model = &mut loaded(&text);
    let errors = refused(model, "torque(ground on rod) @ N [2]");
    assert!(errors.contains("at several points, `O`, `P`") && errors.contains("about O) @ N [2]"), "{errors}");
    let e = value(model, "torque(ground on rod about O) @ N [2]");
    assert!(means(model, e, "-l*W"));
    let e = value(model, "force(ground on rod) @ N [3]");
    // The pin holds what it holds without W as well.
    assert!(means(model, e, "W + rod_force_n3"));
}

/// A four-bar linkage of spatial pins, all about axis 3.
const FOUR_BAR: &str = r#"
[bodies]
crank = { mass = "m", inertia = "I" }
coupler = { mass = "m", inertia = "I" }
rocker = { mass = "m", inertia = "I" }
[joints]
A = { kind = "pin", body = "crank" }
B = { kind = "pin", body = "coupler", to = "crank", at = ["r", 0, 0] }
D = { kind = "pin", body = "rocker", at = ["0.7*l", 0, 0] }
Q = { kind = "pin", body = "rocker", to = "coupler", at = ["0.8*l", 0, 0], body_at = ["0.6*l", 0, 0] }
"#;

/// Goal: forces that equilibrium does not determine are refused, and those that it determines are not. Method:
/// spatial pins hold a plane four-bar linkage three times more than necessary, across its plane and against tilting.
/// In the plane no force is redundant.
#[test]
fn what_pins_hold_more_than_once_is_not_determined() {
    let model = &mut loaded(&format!("{WORLD}{FOUR_BAR}"));
    for pair in ["ground on crank", "crank on coupler", "coupler on rocker", "rocker on ground"] {
        for axis in 1..=3 {
            let force = format!("force({pair}) @ N [{axis}]");
            let torque = format!("torque({pair}) @ N [{axis}]");
            if axis == 3 {
                let errors = refused(model, &force);
                assert!(
                    errors.contains("equilibrium does not determine") && errors.contains("`Q_3` more than once"),
                    "{errors}"
                );
                assert!(errors.contains("ground–crank, ") || errors.contains(", ground–crank"), "{errors}");
                value(model, &torque);
            } else {
                value(model, &force);
                assert!(refused(model, &torque).contains("does not determine"), "{torque}");
            }
        }
    }
    assert!(refused(model, "Q_force3").contains("equilibrium does not determine `Q_force3`"));
    value(model, "Q_force1");
}

/// Goal: forces that equations of a loop leave open are not shown as the forces of the tree of pins. Method: the
/// library's four-bar linkage, whose loop is closed by two equations in its plane. With no reaction named, the
/// coupler and the rocker may hold across the plane as well; with the pins' forces named, they do not. In the plane
/// the pins are determined.
#[test]
fn what_equations_of_a_loop_may_hold_is_not_determined() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/four_bar/model.toml");
    let named = std::fs::read_to_string(path).unwrap();
    let unnamed = named[..named.find("[reactions.").unwrap()]
        .replace(", enforced_by = \"pin_qx\"", "")
        .replace(", enforced_by = \"pin_qy\"", "");
    // Along n3 as well.
    let across = "acceleration = [0, \"-g\", \"g/3\"]";
    let unnamed = unnamed.replace("acceleration = [0, \"-g\", 0]", across);
    let model = &mut loaded(&unnamed);
    for text in ["force(ground on rocker) @ N [3]", "torque(crank on coupler about P) @ N [1]"] {
        let error = refused(model, text);
        assert!(error.contains(&format!("equilibrium does not determine `{text}`: equations keep `")), "{error}");
        assert!(
            error.contains("do not say what else holds there") && error.contains("close the loop by [joints]"),
            "{error}"
        );
    }
    value(model, "force(ground on rocker) @ N [1]");
    value(model, "force(rocker on coupler) @ N [2]");
    let model = &mut loaded(&named);
    for text in ["force(rocker on coupler) @ N [1]", "force(ground on rocker) @ N [3]"] {
        value(model, text);
    }
}

/// Goal: forces are refused also if equations are dependent in closed poses only. Method: Bricard's mechanism of the
/// library, one of whose six equations follows from the other five.
#[test]
fn what_bricards_pins_hold_is_not_determined() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/bricard/model.toml");
    let model = &mut loaded(&std::fs::read_to_string(path).unwrap());
    let dependent = model.dependent[0].name.clone();
    let pair = format!("ground on {}", model.bodies[0].name);
    let count = (1..=3).filter(|axis| load_output(&format!("force({pair}) @ N [{axis}]"), model).is_err()).count();
    assert!(count > 0, "forces go round");
    let errors =
        (1..=3).find_map(|axis| load_output(&format!("force({pair}) @ N [{axis}]"), model).err()).unwrap().to_string();
    assert!(errors.contains(&format!("`{dependent}` more than once")), "{errors}");
}

/// Statement of the direction in which a sled slides.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Direction {
    Formula,
    Frame,
}

/// A sled that slides along a direction turned by `alpha` from its first axis, given by a formula or by a frame.
fn sled(direction: Direction) -> Model {
    let frame = "E = { from = \"B\", axis = 3, angle = \"alpha\" }\n";
    let (frame, law) = if direction == Direction::Formula {
        ("", "v(P) @ B [2]*cos(alpha) - v(P) @ B [1]*sin(alpha) = 0")
    } else {
        (frame, "v(P) @ E [2] = 0")
    };
    loaded(&format!(
        "{}alpha = \"0.4 rad\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[coordinates]\nx = {{ unit = \"m\" }}\ny = {{ unit = \"m\" }}\nq = \
         {{ unit = \"rad\" }}\n[speeds]\nu1 = \"x'*cos(q + alpha) + y'*sin(q + alpha)\"\nu2 = \"q'\"\n[frames]\nB = {{ from = \"N\", axis = 3, angle \
         = \"q\" }}\n{frame}[points]\nC = {{ from = \"O\", frame = \"N\", position = [\"x\", \"y\", 0] }}\nP = {{ from = \"C\", frame = \"B\", \
         position = [\"-r\", \"l\", 0] }}\n[bodies.sled]\nframe = \"B\"\ncentre = \"C\"\nmass = \"m\"\ninertia = \"I\"\n[constraints]\nblade = {{ \
         equation = \"{law}\" }}\n",
        WORLD.split("[inertial]").next().unwrap()
    ))
}

/// The value of an output at a state, with reactions from the force balance.
fn at(model: &mut Model, text: &str, state: &[f64]) -> f64 {
    let e = value(model, text);
    let derivation =
        tripos_derive::derive(model, tripos_derive::Formulation::NewtonEuler).unwrap_or_else(|e| panic!("{e}"));
    let equations = &derivation.equations;
    let defaults: Vec<f64> = model.parameters.iter().map(|p| p.value.as_ref().unwrap().to_f64()).collect();
    let inputs = [model.p(), model.q(), model.u()].concat();
    let values = [defaults, state.to_vec()].concat();
    let n = equations.unknowns.len();
    let entries: Vec<Expr> = equations.matrix.iter().flatten().chain(&equations.forcing).copied().collect();
    let mut numbers = Tape::new(&derivation.arena, &inputs, &entries).unwrap().evaluate(&values);
    let right = numbers.split_off(n * n);
    let matrix = nalgebra::DMatrix::from_row_slice(n, n, &numbers);
    let solved = matrix.lu().solve(&nalgebra::DVector::from_vec(right)).expect("the balance is regular");
    let inputs: Vec<Expr> = inputs.into_iter().chain(equations.unknowns.iter().copied()).collect();
    let values: Vec<f64> = values.into_iter().chain(solved.iter().copied()).collect();
    Tape::new(&model.arena, &inputs, &[e]).unwrap().evaluate(&values)[0]
}

/// Goal: a direction that no frame has is held. Method: the same sled with a frame along it.
#[test]
fn a_tilted_blade_holds_as_one_along_a_frame() {
    let (mut tilted, mut framed) = (sled(Direction::Formula), sled(Direction::Frame));
    proved(&tilted, "tilted");
    proved(&framed, "framed");
    assert!(tilted.reactions.iter().all(|r| r.is_shared) && tilted.reactions.len() == 3, "{:?}", tilted.reactions);
    assert!(framed.reactions.iter().all(|r| !r.is_shared) && framed.reactions.len() == 1, "{:?}", framed.reactions);
    for state in [[0.1, -0.4, 0.7, 1.3, -2.1], [2.0, 1.0, -1.2, 0.4, 3.0], [0.0, 0.0, 2.4, -1.0, 0.5]] {
        for text in
            ["force(ground on sled) @ B [1]", "force(ground on sled) @ N [2]", "torque(ground on sled about C) @ N [3]"]
        {
            let (a, b) = (at(&mut tilted, text, &state), at(&mut framed, text, &state));
            assert!((a - b).abs() < 1e-12 * b.abs().max(1.0) && b.abs() > 1e-3, "{text} at {state:?}: {a}, not {b}");
        }
        let about = at(&mut tilted, "torque(ground on sled about P) @ N [3]", &state);
        assert!(about.abs() < 1e-12, "the blade pushes through P");
    }
}

/// Goal: wheels whose angles are tied by a formula have the torques that hold them. Method: gears, θ₂ = −θ₁ r₁/r₂
/// with a torque M on the first: θ₁″ = M/(I₁ + I₂ (r₁/r₂)²). The tooth exerts −I₂ θ₁″ (r₁/r₂)² on the first and I₂
/// θ₂″ on the second.
#[test]
fn gears_hold_one_another() {
    let text = format!(
        "{WORLD}[bodies]\na = {{ mass = \"m\", inertia = \"2*I\" }}\nb = {{ mass = \"m\", inertia = \"3*I\" }}\n[joints]\nA = {{ kind = \"pin\", body \
         = \"a\", coordinates = [\"q1\"], speeds = [\"u1\"] }}\nB = {{ kind = \"pin\", body = \"b\", at = [\"l\", 0, 0], coordinates = [\"q2\"], speeds = [] \
         }}\n[constraints]\nteeth = {{ equation = \"q2 = -q1*r/l\" }}\n[torques.M]\non = \"a\"\nframe = \"N\"\nvector = [0, 0, \"m*g*l\"]\n"
    );
    let mut model = loaded(&text);
    proved(&model, "gears");
    let shared: Vec<&str> = model.reactions.iter().filter(|r| r.is_shared).map(|r| r.name.as_str()).collect();
    assert_eq!(shared, ["b_torque_n3", "a_torque_n3"]);
    let state = [0.3, -0.7];
    let acceleration = 9.81 / (2.0 + 3.0 * 0.09);
    let second = at(&mut model, "torque(ground on b) @ N [3]", &state);
    assert!((second - 3.0 * -0.3 * acceleration).abs() < 1e-12, "{second}");
    let first = at(&mut model, "torque(ground on a) @ N [3]", &state);
    assert!((first - (2.0 * acceleration - 9.81)).abs() < 1e-12, "{first}");
}

/// Goal: teeth of gears press along the tooth, in every pose. Method: two pinned gears that roll on one another with
/// a torque M on the first: θ₁″ = M/(I₁ + I₂ (r₁/r₂)²). The tooth presses with I₂ θ₁″ r₁/r₂² on the second across the
/// line of centres, over a turn. Along an axis that turns with a gear the force would have poles each half turn.
#[test]
fn teeth_of_pinned_gears_press_along_the_tooth() {
    for (rolls, on) in [("b", "a"), ("a", "b")] {
        let text = format!(
            "{WORLD}[bodies]\na = {{ mass = \"m\", inertia = \"2*I\" }}\nb = {{ mass = \"m\", inertia = \"3*I\" }}\n[joints]\nA = {{ kind = \"pin\", \
             body = \"a\", coordinates = [\"q1\"], speeds = [\"u1\"] }}\nB = {{ kind = \"pin\", body = \"b\", at = [\"l\", 0, 0], coordinates = \
             [\"q2\"], speeds = [] }}\n[points]\nP = {{ from = \"O\", frame = \"N\", position = [\"r\", 0, 0] }}\n[rolling.teeth]\nbody = \
             \"{rolls}\"\nagainst = \"{on}\"\nat = \"P\"\n[torques.M]\non = \"a\"\nframe = \"N\"\nvector = [0, 0, \"m*g*l\"]\n"
        );
        let mut model = loaded(&text);
        proved(&model, "gears that roll");
        assert!(model.reactions.iter().all(|r| r.frame == 0 && !r.is_shared), "{:?}", model.reactions);
        let ratio: f64 = 0.3 / 0.7;
        let press = 3.0 * ratio / 0.7 * 9.81 / (2.0 + 3.0 * ratio * ratio);
        for step in 0..=24 {
            let turned = f64::from(step) * std::f64::consts::PI / 12.0;
            let state = [turned, -ratio * turned, 0.4];
            let force = at(&mut model, "force(a on b) @ N [2]", &state);
            assert!((force - press).abs() < 1e-12, "{turned}: {force}, not {press}");
        }
        // Two pins and a contact do not determine what goes along the line of centres.
        let said = refused(&mut model, "force(a on b) @ N [1]");
        assert!(said.contains("equilibrium does not determine") && said.contains("teeth_1"), "{said}");
    }
}

/// Goal: the tooth presses across the arm also on a gear that goes round another. Method: a planet on an arm, on a
/// sun that stands still. With e = l − r the planet turns with l u/e, and (I₁ + m l² + I₂ (l/e)²) u′ = M − m g l cos
/// q. The sun presses with −I₂ l u′/e² across the arm, over a turn of the arm.
#[test]
fn a_sun_presses_on_a_planet_across_the_arm() {
    let text = format!(
        "{WORLD}[bodies]\narm = {{ mass = \"m\", inertia = \"2*I\" }}\nplanet = {{ mass = \"m\", inertia = \"3*I\" }}\n[joints]\nA = {{ kind = \
         \"pin\", body = \"arm\", coordinates = [\"q1\"], speeds = [\"u1\"] }}\nB = {{ kind = \"pin\", body = \"planet\", to = \
         \"arm\", at = [\"l\", 0, 0], coordinates = [\"q2\"], speeds = [] }}\n[points]\nP = {{ from = \"O\", frame = \"arm_frame\", position = [\"r\", 0, \
         0] }}\n[rolling.teeth]\nbody = \"planet\"\nat = \"P\"\nframe = \"arm_frame\"\n[torques.M]\non = \"arm\"\nframe = \"N\"\nvector = [0, 0, \
         \"m*g*l\"]\n"
    );
    let mut model = loaded(&text);
    proved(&model, "planet");
    for step in 0..=24 {
        let q = f64::from(step) * std::f64::consts::PI / 12.0;
        let gain = 9.81 * (1.0 - q.cos()) / (3.0 + 3.0 / 0.49);
        let press = -3.0 / 0.49 * gain;
        let state = [q, 0.3 / 0.7 * q, 0.4];
        let force = at(&mut model, "force(ground on planet) @ arm_frame [2]", &state);
        assert!((force - press).abs() < 1e-12, "{q}: {force}, not {press}");
    }
}

/// A bus on two wheels of one axle, each driven by a torque m g l against the bus.
fn axle() -> String {
    let wheel = |name: &str, side: &str, frame: &str| {
        format!(
            "[points.C{name}]\nfrom = \"C\"\nframe = \"A\"\nposition = [0, \"{side}l\", 0]\n[points.P{name}]\nfrom = \"C{name}\"\nframe = \"N\"\nposition = [0, 0, \
             \"-r\"]\n[bodies.{name}]\nframe = \"{frame}\"\ncentre = \"C{name}\"\nmass = \"m\"\ninertia = {{ frame = \"{frame}\", diagonal = [\"I\", \"I\", \
             \"I\"] }}\n[rolling.{name}s]\nbody = \"{name}\"\nat = \"P{name}\"\nframe = \"A\"\n[torques.on_{name}]\non = \"{name}\"\nagainst = \"bus\"\nframe = \
             \"A\"\nvector = [0, \"m*g*l\", 0]\n"
        )
    };
    format!(
        "{}[coordinates]\nx = {{ unit = \"m\" }}\ny = {{ unit = \"m\" }}\npsi = {{ unit = \"rad\" }}\na = {{ unit = \"rad\" }}\nb = {{ unit = \"rad\" }}\n[speeds]\nv \
         = \"x'*cos(psi) + y'*sin(psi)\"\nw = \"psi'\"\n[frames]\nA = {{ from = \"N\", axis = 3, angle = \"psi\" }}\nL = {{ from = \"A\", axis = 2, angle = \"a\" }}\nR = \
         {{ from = \"A\", axis = 2, angle = \"b\" }}\n[points.C]\nfrom = \"O\"\nframe = \"N\"\nposition = [\"x\", \"y\", \"r\"]\n[bodies.bus]\nframe = \"A\"\ncentre = \
         \"C\"\nmass = \"m\"\ninertia = {{ frame = \"A\", diagonal = [\"I\", \"I\", \"I\"] }}\n{}{}",
        WORLD.split("[gravity]").next().unwrap(),
        wheel("left", "", "L"),
        wheel("right", "-", "R")
    )
}

/// Goal: a force that two contacts share is not split between them. Method: two wheels on one axle. Each keeps the
/// other from slipping sideways, so that the force of neither along the axle is determined. The forward forces are
/// determined: both wheels drive, each with (M − I v'/r)/r.
#[test]
fn what_two_contacts_hold_together_is_not_told_apart() {
    let text = axle();
    let mut model = loaded(&text);
    proved(&model, "axle");
    for body in ["left", "right"] {
        let said = refused(&mut model, &format!("force(ground on {body}) @ A [2]"));
        assert!(
            said.contains("equilibrium does not determine") && said.contains("rights_2") && said.contains("give way"),
            "{said}"
        );
    }
    // 3 m v' + 2 I v'/r² = 2 M/r with M = m g l; each wheel: I v'/r = M − r F.
    let state = [0.1, 0.2, 0.7, 0.3, 0.4, 0.5, 0.6];
    let rate = 2.0 * 9.81 / 0.3 / (3.0 + 2.0 / 0.09);
    let forward = (9.81 - rate / 0.3) / 0.3;
    for body in ["left", "right"] {
        let found = at(&mut model, &format!("force(ground on {body}) @ A [1]"), &state);
        assert!((found - forward).abs() < 1e-11, "{body}: {found}, not {forward}");
    }
}

/// Goal: only the shared force of two contacts is refused, whatever else the model has. Method: the axle with a bead
/// that has no place in half of all poses, whose forward forces are read and sideways forces are refused still; and
/// with a parameter that has the name of a possible contact force.
#[test]
fn what_contacts_share_hides_nothing_else() {
    let spot = "[points.S]\nfrom = \"O\"\nframe = \"N\"\nposition = [0, 0, \"sqrt(l^2 - (2*l*psi)^2)\"]\n[particles]\nspot = { point = \"S\", mass = \"m\" }\n";
    let mut model = loaded(&format!("{}{spot}", axle()));
    assert!(refused(&mut model, "force(ground on left) @ A [2]").contains("rights_2"));
    let state = [0.1, 0.2, 0.2, 0.3, 0.4, 0.5, 0.6];
    assert!(at(&mut model, "force(ground on left) @ A [1]", &state).is_finite());
    let named = axle().replacen("[inertial]", "rights_2_force = { unit = \"N\", value = 3 }\n[inertial]", 1);
    let domain = "[domain]\nholds = \"rights_2_force > m*g*psi\"\n";
    let mut model = loaded(&format!("{named}{domain}"));
    assert!(refused(&mut model, "force(ground on left) @ A [2]").contains("rights_2"));
}

/// A chain of 13 bodies has 78 equations: too many to find what acts between them, and the refusal says so.
#[test]
fn reactions_of_many_bodies_are_to_be_named() {
    let links = "[counts]\nn = 13\n[bodies.\"b{i in 1..n}\"]\nmass = \"m\"\ninertia = { diagonal = [\"I\", \"I\", \"I\"] }\n[joints.J1]\nkind = \"pin\"\nbody = \
                 \"b1\"\ncoordinates = [\"q1\"]\n[joints.\"J{i in 2..n}\"]\nkind = \"pin\"\nbody = \"b{i}\"\nto = \"b{i-1}\"\nat = [\"l\", 0, 0]\ncoordinates = \
                 [\"q{i}\"]\n";
    let mut model = loaded(&format!("{WORLD}{links}"));
    let said = refused(&mut model, "force(b1 on b2) @ N [1]");
    assert!(said.contains("up to 72 equations") && said.contains("have 78") && said.contains("[reactions]"), "{said}");
}

/// Goal: a rod without mass pulls along itself. Method: a particle with x² + y² = l², whose rod pulls with m v²/l + m
/// g sin of its angle below the horizontal; and two particles at a fixed distance in free flight, with the pull m₁
/// m₂/(m₁ + m₂) v²/l.
#[test]
fn a_rod_without_mass_pulls_along_itself() {
    let head = WORLD;
    let text = format!(
        "{head}[coordinates]\nx = {{ unit = \"m\" }}\ny = {{ unit = \"m\" }}\n[speeds]\nu = \"(x*y' - y*x')/l\"\n[points]\nP = {{ from = \"O\", \
         frame = \"N\", position = [\"x\", \"y\", 0] }}\n[particles]\nbob = {{ point = \"P\", mass = \"m\" }}\n[constraints]\nrod = {{ equation = \
         \"x^2 + y^2 = l^2\" }}\n"
    );
    let mut model = loaded(&text);
    proved(&model, "bob");
    assert_eq!(model.reactions.iter().map(|r| r.name.as_str()).collect::<Vec<_>>(), ["bob_force_to_o"]);
    let pull = at(&mut model, "bob_force_to_o", &[0.6, -0.8, 1.5]);
    assert!((pull - (1.5 * 1.5 + 9.81 * 0.8)).abs() < 1e-12, "{pull}");
    let text = format!(
        "{}{}[coordinates]\nx = {{ unit = \"m\" }}\ny = {{ unit = \"m\" }}\na = {{ unit = \"m\" }}\nb = {{ unit = \"m\" }}\n[speeds]\nu1 = \"x'\"\nu2 = \
         \"y'\"\nu3 = \"((a - x)*(b' - y') - (b - y)*(a' - x'))/l\"\n[points]\nP = {{ from = \"O\", frame = \"N\", position = [\"x\", \"y\", 0] }}\nQ = {{ from \
         = \"O\", frame = \"N\", position = [\"a\", \"b\", 0] }}\n[particles]\none = {{ point = \"P\", mass = \"m\" }}\ntwo = {{ point = \"Q\", mass = \
         \"3*m\" }}\n[constraints]\nrod = {{ equation = \"distance(P, Q) = l\" }}\n",
        head.split("[gravity]").next().unwrap(),
        "[gravity]\nframe = \"N\"\nacceleration = [0, \"-g\", 0]\n"
    );
    let mut model = loaded(&text);
    proved(&model, "dumb-bell");
    let state = [0.2, 0.1, 0.8, 0.9, 0.4, -0.3, 2.0];
    let pull = [1, 2].map(|axis| at(&mut model, &format!("force(two on one) @ N [{axis}]"), &state));
    for (found, along) in pull.into_iter().zip([0.6, 0.8]) {
        assert!((found - 0.75 * 4.0 * along).abs() < 1e-12, "{pull:?}");
    }
}

/// A plane cart on wheels that roll on the ground; `wheels` gives the place of each ahead of the mass centre, in l.
fn cart(wheels: &[i32]) -> String {
    let [mut coordinates, mut frames, mut rest] = [const { String::new() }; 3];
    for (at, ahead) in wheels.iter().enumerate() {
        let _ = writeln!(coordinates, "q{at} = {{ unit = \"rad\" }}");
        let _ = writeln!(frames, "W{at} = {{ from = \"N\", axis = 3, angle = \"q{at}\" }}");
        let _ = write!(
            rest,
            "[points.C{at}]\nfrom = \"C\"\nframe = \"N\"\nposition = [\"{ahead}*l\", 0, 0]\n[points.P{at}]\nfrom = \"C{at}\"\nframe = \"N\"\nposition = [0, \"-r\", 0]\n\
             [bodies.w{at}]\nframe = \"W{at}\"\ncentre = \"C{at}\"\nmass = \"m\"\ninertia = \"I\"\n[rolling.roll{at}]\nbody = \"w{at}\"\nat = \"P{at}\"\n"
        );
    }
    format!(
        "{WORLD}[coordinates]\nx = {{ unit = \"m\" }}\n{coordinates}[speeds]\nv = \"x'\"\n[frames]\n{frames}[points.C]\nfrom = \"O\"\nframe = \"N\"\nposition = [\"x\", \"r\", \
         0]\n[bodies.cart]\nframe = \"N\"\ncentre = \"C\"\nmass = \"m\"\ninertia = \"I\"\n{rest}"
    )
}

/// Goal: a cart presses on the ground by its wheels. Method: statics. Of two wheels at l and −2 l the first presses
/// with 5/3 m g, the other with 4/3 m g. Equilibrium does not determine the forces of three wheels in a row. The
/// ground does not touch the cart itself.
#[test]
fn a_cart_presses_on_the_ground_by_its_wheels() {
    let mut model = loaded(&cart(&[1, -2]));
    proved(&model, "cart");
    for (wheel, share) in [(0, 5.0 / 3.0), (1, 4.0 / 3.0)] {
        let found = at(&mut model, &format!("force(ground on w{wheel}) @ N [2]"), &[0.1, 0.2, 0.3, 0.4]);
        assert!((found - share * 9.81).abs() < 1e-11, "{wheel}: {found}");
    }
    assert!(refused(&mut model, "force(ground on cart) @ N [2]").contains("no reaction acts"));
    let mut model = loaded(&cart(&[1, -2, 3]));
    proved(&model, "three in a row");
    for wheel in 0..3 {
        let said = refused(&mut model, &format!("force(ground on w{wheel}) @ N [2]"));
        assert!(said.contains("equilibrium does not determine"), "{said}");
    }
}

/// Screws about axis 3, one on another, and a slider that guides the last body: a loop. Leads are 0.3 m, 0.2 m, 0.45 m.
fn screws(count: usize) -> Model {
    let names = ["a", "b", "c"];
    let mut text = "name = \"screws\"\n[parameters]\nm = \"1 kg\"\nJ = \"1 kg*m^2\"\nF = \"10 N\"\np = \"0.1 m\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n"
        .to_owned();
    for (at, name) in names[..count].iter().enumerate() {
        let (to, lead) = (if at == 0 { "" } else { names[at - 1] }, ["3*p", "2*p", "9*p/2"][at]);
        let to = if to.is_empty() { String::new() } else { format!("to = \"{to}\"\n") };
        let _ = writeln!(
            text,
            "[bodies.{name}]\nmass = \"m\"\ninertia = {{ diagonal = [\"J\", \"J\", \"J\"] }}\n[joints.J{name}]\nkind = \"screw\"\nbody = \"{name}\"\n{to}axis = 3\nlead = \
             \"{lead}\"\ncoordinates = [\"q{name}\"]"
        );
    }
    let last = names[count - 1];
    let _ = writeln!(
        text,
        "[joints.L]\nkind = \"slider\"\nbody = \"{last}\"\naxis = 3\n[forces.push]\non = \"{last}\"\nframe = \"N\"\nvector = [0, 0, \"F\"]"
    );
    loaded(&text)
}

/// Goal: a differential screw obeys the laws of both screws. Method: z = h₁ q of the nut a, (h₁ − h₂) q of the body b,
/// which does not turn: q″ = F (h₁ − h₂)/(m h₁² + m (h₁ − h₂)² + J), forces by Newton, and torque = −h force of each
/// frictionless screw.
#[test]
fn two_screws_in_a_loop_keep_their_laws() {
    let mut model = screws(2);
    proved(&model, "differential screw");
    let turn = 2.0 * std::f64::consts::PI;
    let (h1, h2) = (0.3 / turn, 0.2 / turn);
    let rate = 10.0 * (h1 - h2) / (h1 * h1 + (h1 - h2) * (h1 - h2) + 1.0);
    let on_b = (h1 - h2) * rate - 10.0;
    let on_a = h1 * rate + on_b;
    let expected = [
        ("force(ground on a) @ N [3]", on_a),
        ("torque(ground on a) @ N [3]", -h1 * on_a),
        ("force(a on b) @ N [3]", on_b),
        ("torque(a on b) @ N [3]", -h2 * on_b),
        ("torque(ground on b) @ N [3]", h2 * on_b),
    ];
    let state = vec![0.0; model.coordinates.len() + model.speeds.len()];
    for (text, right) in expected {
        let found = at(&mut model, text, &state);
        assert!((found - right).abs() < 1e-12, "{text}: {found}, not {right}");
    }
}

/// Goal: each screw of a loop keeps its law, however many there are. Method: three screws; torque = −h force of each,
/// along its axis, at a state with other angles.
#[test]
fn three_screws_in_a_loop_keep_their_laws() {
    let mut model = screws(3);
    proved(&model, "three screws");
    assert_eq!((model.coordinates.len(), model.speeds.len()), (3, 2));
    let state = [0.4, 0.3, -0.7, 1.1, -0.6];
    for (pair, lead) in [("ground on a", 0.3), ("a on b", 0.2), ("b on c", 0.45)] {
        let force = at(&mut model, &format!("force({pair}) @ N [3]"), &state);
        let torque = at(&mut model, &format!("torque({pair}) @ N [3]"), &state);
        let law = torque + lead / (2.0 * std::f64::consts::PI) * force;
        assert!(law.abs() < 1e-12 && force.abs() > 1.0, "{pair}: {force} N, {torque} N m");
    }
}

/// A body b that slides along a body a in the plane, with a blade under each, given by the statement of its velocity:
/// that of a at its centre, that of b at a distance e before its centre. A force F acts across b at d before its
/// centre.
fn blades(of_b: &str, reactions: &str) -> Model {
    loaded(&format!(
        "name = \"blades\"\n[parameters]\nm = \"1 kg\"\nJ = \"1 kg*m^2\"\nF = \"10 N\"\nh = \"0.5 m\"\nd = \"0.3 m\"\ne = \"0.2 m\"\n[inertial]\n\
         frame = \"N\"\norigin = \"O\"\n[bodies]\na = {{ mass = \"m\", inertia = \"J\" }}\nb = {{ mass = \"m\", inertia = \"J\" }}\n[joints]\nJa = {{ \
         kind = \"planar\", body = \"a\", coordinates = [\"x\", \"y\", \"th\"] }}\nJb = {{ kind = \"slider\", axis = 1, body = \"b\", to = \"a\", at = \
         [\"h\", 0, 0], coordinates = [\"s\"] }}\n[points]\nX = {{ from = \"b_centre\", frame = \"b_frame\", position = [\"d\", 0, 0] }}\nE = {{ \
         from = \"b_centre\", frame = \"b_frame\", position = [\"e\", 0, 0] }}\n[forces.push]\nat = \"X\"\non = \"b\"\nframe = \"b_frame\"\nvector \
         = [0, \"F\", 0]\n[constraints]\nEa = {{ equation = \"v(a_centre) @ a_frame [2] = 0\" }}\nEb = {{ equation = \"{of_b}\" }}\n{reactions}"
    ))
}

/// Goal: a blade holds the body and the point that its constraint names, and no joint holds a direction that it leaves
/// free, even if two blades together stop it. Method: statics across the blades. With the blade of b at e, moments
/// about the centre of a give B = −F (h + s + d)/(h + s + e) on b, and A = −F − B on a.
#[test]
fn blades_hold_the_bodies_that_they_name() {
    let named = |at: &str| {
        format!(
            "[reactions]\nra = {{ on = \"a\", frame = \"a_frame\", direction = [0, 1, 0] }}\nrb = {{ on = \"b\", {at}frame = \"b_frame\", direction = \
             [0, 1, 0] }}\n"
        )
    };
    let cases = [
        ("v(b_centre) @ b_frame [2] = 0", String::new(), 0.0),
        ("v(E) @ b_frame [2] = 0", String::new(), 0.2),
        ("v(b, E) @ a_frame [2] = 0", String::new(), 0.2),
        ("v(b_centre) @ b_frame [2] = 0", named(""), 0.0),
        ("v(E) @ b_frame [2] = 0", named("at = \"E\", "), 0.2),
    ];
    for (equation, reactions, e) in cases {
        let mut model = blades(equation, &reactions);
        proved(&model, equation);
        let (s, h, d, load) = (0.5, 0.5, 0.3, 10.0);
        let under_b = -load * (h + s + d) / (h + s + e);
        let under_a = -load - under_b;
        let expected = [
            ("force(ground on a) @ N [2]", under_a),
            ("torque(ground on a about a_centre) @ N [3]", 0.0),
            ("force(a on b) @ N [2]", under_a),
            ("torque(a on b about b_centre) @ N [3]", -load * d - under_b * e),
            ("force(ground on b) @ N [2]", under_b),
        ];
        for (text, right) in expected {
            let found = at(&mut model, text, &[0.0, 0.0, 0.0, s, 1.0, 0.2]);
            assert!((found - right).abs() < 1e-12, "{equation}: {text} is {found}, not {right}");
        }
    }
}
