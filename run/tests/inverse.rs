//! Inverse dynamics: forces and inputs of given motions.
//!
//! Truth: closed forms; P. I. Corke, *Robotics, Vision and Control* (2011), section 9.1.

use std::path::Path;
use tripos::inverse::{Forces, Inverse, moments};
use tripos::{Error, Mechanism};
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::{Moving, load_motion, load_samples};

fn read(model: &str) -> Mechanism {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(model).join("model.toml");
    Mechanism::read(&path).unwrap_or_else(|e| panic!("{e}"))
}

fn parse(text: &str) -> Mechanism {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", text)).unwrap_or_else(|e| panic!("{e}"));
    Mechanism::new(model)
}

fn run(mut model: Mechanism, motion: &str, inputs: &[&str]) -> Result<Vec<(Moving, Forces)>, Error> {
    let motion = load_motion(&Source::from_text("motion.toml", motion), &mut model).unwrap_or_else(|e| panic!("{e}"));
    let inputs: Vec<String> = inputs.iter().map(|name| (*name).to_owned()).collect();
    let inverse = Inverse::new(&model, &inputs)?;
    moments(&model, &motion)?
        .into_iter()
        .map(|moving| inverse.at(&motion.parameters, &moving).map(|forces| (moving, forces)))
        .collect()
}

const PENDULUM: &str = r#"
name = "Driven pendulum"
[parameters]
m = { unit = "kg", value = 2, positive = true }
l = { unit = "m", value = 0.5, positive = true }
g = { unit = "m/s^2", value = 9.81, positive = true }
c = { unit = "N*m*s", value = 0.125 }
[inputs]
tau = { unit = "N*m" }
more = { unit = "N*m" }
[coordinates]
q = { unit = "rad" }
[speeds]
u = "q'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "q" }
[points]
P = { from = "O", frame = "A", position = [0, "-l", 0] }
[bodies]
rod = { frame = "A", centre = "P", mass = "m", inertia = 0 }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[torques]
drive = { on = "rod", frame = "N", vector = [0, 0, "tau - c*u"] }
other = { on = "rod", frame = "N", vector = [0, 0, "2*more"] }
"#;

const SWING: &str = "[motion]\nq = \"sin(3*t)\"\n[times]\nfrom = 0\nto = 2\ncount = 9\n";

/// Goal: the torque of a motion that is given by a formula. Method: m l² q'' + c q' + m g l sin q in closed form, to rounding.
#[test]
fn a_driven_pendulum_needs_its_closed_form() {
    for (moving, forces) in run(parse(PENDULUM), SWING, &["tau"]).unwrap() {
        let t = moving.t.unwrap();
        let (q, u, rate) = ((3.0 * t).sin(), 3.0 * (3.0 * t).cos(), -9.0 * (3.0 * t).sin());
        let torque = 0.5 * rate + 0.125 * u + 9.81 * q.sin();
        assert!((moving.u[0].hi() - u).abs() < 1e-14 && (moving.rates[0].hi() - rate).abs() < 1e-13);
        assert!((forces.along[0].hi() - torque).abs() < 1e-13, "{t}");
        assert!((forces.inputs.unwrap()[0] - torque).abs() < 1e-13, "{t}");
    }
}

/// Goal: of inputs that are more than freedoms the least is given. Method: τ₁ + 2 τ₂ = f by (f, 2 f)/5.
#[test]
fn inputs_that_are_too_many_are_the_least() {
    for (_, forces) in run(parse(PENDULUM), SWING, &[]).unwrap() {
        let (f, inputs) = (forces.along[0].hi(), forces.inputs.unwrap());
        assert!((inputs[0] - f / 5.0).abs() < 1e-14 && (inputs[1] - 2.0 * f / 5.0).abs() < 1e-14, "{inputs:?}");
        assert_eq!(forces.reached, 1);
    }
}

/// Goal: a parameter stands for an input where loads are linear in it, and is refused where they are not. Method: the damper's constant
/// gives what the torque gave; the length does not stand in loads alone.
#[test]
fn parameters_stand_for_inputs_where_loads_are_linear() {
    let state = "[state]\nq = 0.5\nu = 2\n[accelerations]\n\"u'\" = 0\n";
    let (_, forces) = run(parse(PENDULUM), state, &["c"]).unwrap().remove(0);
    assert!((forces.inputs.unwrap()[0] + 9.81 * 0.5_f64.sin() / 2.0).abs() < 1e-14);
    let wrong = run(parse(PENDULUM), state, &["l"]).unwrap_err().first_line();
    assert_eq!(wrong, "forces are not linear in `l`");
}

/// Goal: an arm with a motor at each joint weighs what is published. Method: Corke's gravity load of the PUMA 560 in the pose `qn`.
#[test]
fn an_arm_at_rest_needs_its_published_gravity_load() {
    let state = "[state]\nq1 = 0\nq2 = \"pi/4\"\nq3 = \"pi\"\nq4 = 0\nq5 = \"pi/4\"\nq6 = 0\nu1 = 0\nu2 = 0\nu3 = 0\nu4 = 0\nu5 = 0\nu6 = 0\n\
                 [accelerations]\n\"u1'\" = 0\n\"u2'\" = 0\n\"u3'\" = 0\n\"u4'\" = 0\n\"u5'\" = 0\n\"u6'\" = 0\n";
    let (_, forces) = run(read("puma560"), state, &[]).unwrap().remove(0);
    let inputs = forces.inputs.expect("six motors hold six joints");
    for (torque, printed) in inputs.iter().zip([0.0, 31.6399, 6.0351, 0.0, 0.0283, 0.0]) {
        assert!((torque - printed).abs() < 1e-4, "{inputs:?}");
    }
}

/// Goal: a table of samples is read by names, and what is wrong in it is told. Method: columns in another order, and one of each error.
#[test]
fn tables_of_samples_are_read_by_names() {
    let model = parse(PENDULUM);
    let read = |text: &str| load_samples(&Source::from_text("samples.csv", text), &model);
    let list = read("u',t,q,u\n0.5,1,2,3\n1,2,3,4\n").unwrap();
    assert_eq!((list.len(), list[0].t, list[0].rates[0].hi(), list[1].q[0].hi()), (2, Some(1.0), 0.5, 3.0));
    for (text, wrong) in [
        ("q,u\n1,2\n", "the table has no column `u'`"),
        ("q,u,u'\n1,2,x\n", "row 1 has no number in `u'`: `x`"),
        ("q,u,u'\n", "the table has no rows"),
        ("q,u,u'\n1,2\n", "the file is no CSV"),
    ] {
        let error = read(text).unwrap_err();
        assert!(error.list[0].message.starts_with(wrong), "{}", error.list[0].message);
    }
}

/// Goal: every way to state a motion wrongly is told. Method: one of each.
#[test]
fn wrong_motions_are_refused() {
    for (text, wrong) in [
        ("[parameters]\n", "the file is no motion"),
        ("[motion]\nq = \"sin(3*z)\"\n[times]\nfrom = 0\nto = 1\ncount = 2\n", "`z` cannot stand in a motion"),
        ("[motion]\np = 1\n[times]\nfrom = 0\nto = 1\ncount = 2\n", "the model has no coordinate `p`"),
        ("[motion]\nq = 1\n[times]\nfrom = 0\nto = 1\ncount = 2.5\n", "`count` is 2.5"),
        ("[motion]\nq = 1\n", "the motion has no `times`"),
        ("[motion]\n[times]\nfrom = 0\nto = 1\ncount = 2\n", "no formula for q"),
        ("[state]\nq = 1\nu = 1\n", "no value for u'"),
        ("[state]\nq = 1\nu = 1\n[accelerations]\n\"w'\" = 1\n", "the model has no acceleration `w'`"),
    ] {
        let error = load_motion(&Source::from_text("motion.toml", text), &mut parse(PENDULUM)).unwrap_err();
        assert!(error.list.iter().any(|d| d.message.starts_with(wrong)), "{text}: {error}");
    }
}
