//! Constraints that are solved one after the other: the solution of one contains a coordinate that a later one
//! eliminates.

use crate::common::read;
use std::fmt::Write;
use tripos_derive::diagnostic::Source;
use tripos_derive::model::Model;
use tripos_derive::scene::{Scene, load};

/// Particles on a line, whose places follow from that of the first: b = 2 a, c = a + b = 3 a, e = d − a − b − c = d −
/// 6 a.
const CHAIN: [&str; 3] = ["a + b + c + e = d", "c = a + b", "b = 2*a"];

fn chain(equations: &[&str], coordinates: &[&str]) -> Model {
    let mut text = "name = \"chain\"\n[parameters]\nm = \"1 kg\"\nd = \"3 m\"\n[coordinates]\n".to_owned();
    for name in coordinates {
        let _ = writeln!(text, "{name} = {{ unit = \"m\" }}");
    }
    text += "[speeds]\nu = \"a'\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n";
    for name in coordinates {
        let point = name.to_uppercase();
        let _ = writeln!(text, "[points.{point}]\nfrom = \"O\"\nframe = \"N\"\nposition = [\"{name}\", 0, 0]");
        let _ = writeln!(text, "[particles.p{name}]\npoint = \"{point}\"\nmass = \"m\"");
    }
    for (at, equation) in equations.iter().enumerate() {
        let _ = writeln!(text, "[constraints.k{at}]\nequation = \"{equation}\"");
    }
    read(&text).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

fn started(model: &mut Model, start: &str) -> Scene {
    let text = format!("model = \"model.toml\"\nspan = [0, 1]\noutputs = [\"a\", \"e\", \"a'\"]\n[start]\n{start}");
    load(&Source::from_text("scene.toml", &text), model).unwrap_or_else(|e| panic!("{e}"))
}

/// Goal: a start is right whatever the order of the constraints. Method: all orders of three; a and a' from each stated
/// place and rate by hand.
#[test]
fn the_order_of_constraints_does_not_matter() {
    for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        let equations = order.map(|at: usize| CHAIN[at]);
        let mut model = chain(&equations, &["a", "b", "c", "e"]);
        assert_eq!(model.coordinates.len(), 1);
        for constraint in &model.constraints {
            let fixed = model.constraints.iter().filter_map(|other| model.arena.find_symbol(&other.fixes));
            let mentions = fixed.filter(|symbol| model.arena.mentions(constraint.value, *symbol)).count();
            assert_eq!(mentions, 0, "{equations:?}: the solution for {}", constraint.fixes);
        }
        let starts = [
            ("a = 0.5\n\"e'\" = -3\n", 0.5, 0.5),
            ("e = 1.2\n\"e'\" = -3\n", 0.3, 0.5),
            ("a = 0.5\n\"c'\" = 6\n", 0.5, 2.0),
            ("a = 0.5\n\"a'\" = 1\n\"b'\" = 2\n\"c'\" = 3\n\"e'\" = -6\n", 0.5, 1.0),
            ("c = 0.75\nu = 7\n", 0.25, 7.0),
        ];
        for (start, a, rate) in starts {
            let scene = started(&mut model, start);
            let found = (scene.q[0], scene.u[0]);
            assert!((found.0 - a).abs() < 1e-14 && (found.1 - rate).abs() < 1e-14, "{equations:?}, {start}: {found:?}");
        }
    }
}

/// Goal: rates follow also from solutions that are not linear. Method: b = a², e = d − a − b, so that e' = −(1 + 2 a)
/// a', in both orders.
#[test]
fn curved_solutions_are_put_into_one_another() {
    for equations in [["a + b + e = d", "b = a^2/d*3"], ["b = a^2/d*3", "a + b + e = d"]] {
        let mut model = chain(&equations, &["a", "b", "e"]);
        let scene = started(&mut model, "a = 0.5\n\"e'\" = -3\n");
        assert!((scene.u[0] - 1.5).abs() < 1e-14, "{equations:?}: {:?}", scene.u);
    }
}

/// Goal: a solution that divides by zero once another is put in is refused. Method: e = d²/b, then b = 0.
#[test]
fn a_solution_without_a_value_is_refused() {
    let text = "name = \"none\"\n[parameters]\nm = \"1 kg\"\nd = \"3 m\"\n[coordinates]\na = { unit = \"m\" }\nb = { unit = \"m\" }\ne = { \
                unit = \"m\" }\n[speeds]\nu = \"a'\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[points.A]\nfrom = \"O\"\nframe = \
                \"N\"\nposition = [\"a\", 0, 0]\n[particles.p]\npoint = \"A\"\nmass = \"m\"\n[constraints.k1]\nequation = \"e = \
                d^2/b\"\n[constraints.k2]\nequation = \"b = 0\"\n";
    let errors = read(text).err().map(|e| e.to_string()).expect("e has no value");
    assert!(errors.contains("divides by zero wherever the constraints hold"), "{errors}");
}

/// Goal: an equation of a joint that no motion can change is refused with its value, or is a condition on parameters,
/// and counts of such models do not fail. Method: a planar joint whose plane lies 0.3 m beside the point that a ball is
/// to hold; beside it by rounding; in it.
#[test]
fn a_loop_that_no_coordinate_closes_is_refused() {
    let text = |offset: &str| {
        format!(
            "name = \"planar ball\"\n[parameters]\nm = \"1 kg\"\nd = \"{offset}\"\nk = \"0.1 m\"\nJ = \"1 kg*m^2\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n\
             [bodies]\na = {{ mass = \"m\", inertia = {{ diagonal = [\"J\", \"J\", \"J\"] }} }}\n[joints]\nJa = {{ \
             kind = \"planar\", body = \"a\", axis = [1, 2, 2] }}\nL = {{ kind = \"ball\", body = \"a\", at = [\"2*d/3\", \"-d/3\", \"d\"], \
             body_at = [\"3*k\", \"2*k\", \"-7*k/2\"] }}\n"
        )
    };
    for offset in ["0.3 m", "1e-9 m"] {
        let said = read(&text(offset)).err().map(|e| e.to_string()).expect("no pose closes");
        assert!(said.contains("the loop does not close: no coordinate changes `L_"), "{said}");
        assert!(said.contains("write the parameters as formulas of one another"), "{said}");
    }
    let model = read(&text("1e-17 m")).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((model.speeds.len(), model.conditions.len()), (1, 1));
    let inside = text("0 m").replace("[\"2*d/3\", \"-d/3\", \"d\"]", "[0, 0, 0]");
    let model = read(&inside).unwrap_or_else(|e| panic!("{e}"));
    assert!(
        model.counts_in_words().contains("0 nonholonomic constraints, 1 generalized speed"),
        "{}",
        model.counts_in_words()
    );
}
