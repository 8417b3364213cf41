//! Joints about oblique axes, whose directions contain roots.

use crate::common::read;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::scene::load_output;

/// Goal: components along the axes of the ground are known, although constants with roots cancel in them. Method: two
/// pins in a chain about one axis a turn the second body with (u₁ + u₂) a/|a|.
#[test]
fn components_along_the_ground_are_known() {
    for axis in [[1, 0, 2], [1, 1, 2], [2, -1, 3], [0, 1, 3], [1, 2, 2]] {
        let text = format!(
            "name = \"oblique\"\n[parameters]\nm = \"1 kg\"\nJ = \"1 kg*m^2\"\nc = \"0.3 m\"\n[inertial]\nframe = \"N\"\norigin = \
             \"O\"\n[bodies]\na = {{ mass = \"m\", inertia = {{ diagonal = [\"J\", \"J\", \"J\"] }} }}\nb = {{ mass = \"m\", inertia = {{ diagonal = [\"J\", \"J\", \"J\"] }} }}\n[joints]\nA = {{ kind = \
             \"pin\", body = \"a\", axis = {axis:?}, centre = [\"c\", 0, 0], coordinates = [\"q1\"], speeds = [\"u1\"] }}\nB = {{ kind = \
             \"pin\", body = \"b\", to = \"a\", axis = {axis:?}, coordinates = [\"q2\"], speeds = [\"u2\"] }}\n"
        );
        let mut model = read(&text).unwrap_or_else(|e| panic!("{e}"));
        let length = f64::from(axis.iter().map(|x| x * x).sum::<i32>()).sqrt();
        let e = axis.map(|x| f64::from(x) / length);
        let [u1, u2] = [1.3, -0.4];
        for at in 0..3 {
            let text = format!("omega(b) @ N [{}]", at + 1);
            let output = load_output(&text, &mut model).unwrap_or_else(|e| panic!("{axis:?}: {e}")).value;
            let inputs = [model.p(), model.q(), model.u(), model.q_dot()].concat();
            let tape = Tape::new(&model.arena, &inputs, &[output]).unwrap();
            let value = tape.evaluate(&[1.0, 1.0, 0.3, 0.2, -1.1, u1, u2, u1, u2])[0];
            let expected = (u1 + u2) * e[at];
            assert!((value - expected).abs() < 1e-14, "{text}, {axis:?}: {value}, not {expected}");
        }
    }
}
