//! Stiff mechanisms by Radau's method, and the advice of explicit methods on them.

use tripos::{Overrides, Run, Scene};

/// The stiff governor of IFToMM's problem A05: couplers of 8e5 N/m and 4e4 N s/m.
fn governor() -> Scene {
    Scene::read("../tests/data/stiff_governor/s.toml").unwrap_or_else(|e| panic!("{e}"))
}

fn run(scene: &Scene, method: &str, tolerance: f64) -> Run {
    let how = Overrides {
        method: Some(method.parse().unwrap()),
        rtol: Some(tolerance),
        atol: Some(1e-2 * tolerance),
        ..Overrides::default()
    };
    scene.simulate(&how).unwrap_or_else(|e| panic!("{method}: {e}"))
}

fn advice(run: &Run) -> Option<&String> {
    run.notes.iter().find(|note| note.contains("limited by stability"))
}

/// Goal: the governor to 1e-8 in some thousand steps, by every kind of equations. Method: against DOP853 at 1e-12.
#[test]
fn a_stiff_governor_is_solved_to_eight_digits() {
    let scene = governor();
    let explicit = run(&scene, "dop853", 1e-12);
    assert!(explicit.failure().is_none(), "{:?}", explicit.failure());
    for by in [None, Some("kane"), Some("lagrange"), Some("newton-euler")] {
        let how = Overrides { by: by.map(Into::into), ..Overrides::default() };
        let implicit = scene.simulate(&how).unwrap_or_else(|e| panic!("{by:?}: {e}"));
        assert!(implicit.is_trusted() && advice(&implicit).is_none(), "{by:?}: {:?}", implicit.objections());
        assert!(implicit.solution.steps < 3_000, "{by:?}: {}", implicit.ending);
        for name in ["s", "right_angle", "left_angle", "spin", "v"] {
            let last = |run: &Run| *run.column_of_quantity(name).unwrap().last().unwrap();
            let apart = (last(&implicit) - last(&explicit)).abs();
            assert!(apart < 1e-8, "{by:?} {name}: {apart:e}");
        }
    }
}

/// Goal: the advice is measured, at the tolerances of the run. Method: the run that the advice names is made. Without
/// damping the couplers ring. Following that takes short steps by any method, so there is no advice.
#[test]
fn what_is_said_of_the_implicit_method_is_what_it_takes() {
    let mut scene = governor();
    for (method, tolerance) in [("ode45", 1e-6), ("dop853", 1e-6)] {
        let (explicit, implicit) = (run(&scene, method, tolerance), run(&scene, "radau5", tolerance));
        let said = advice(&explicit).unwrap_or_else(|| panic!("{method} {tolerance:e}: {:?}", explicit.notes));
        assert!(said.contains(&format!(": {} steps of {method}, with", explicit.solution.steps)), "{said}");
        assert!(said.contains(&format!("radau5 takes {} at the same", implicit.solution.steps)), "{said}");
        assert!(advice(&implicit).is_none() && explicit.warnings.is_empty(), "{:?}", explicit.warnings);
    }
    scene.set_number("C", 0.0).unwrap_or_else(|e| panic!("{e}"));
    let ringing = run(&scene, "dop853", 1e-6);
    assert!(ringing.solution.steps > 2_000 && advice(&ringing).is_none(), "{} {:?}", ringing.ending, ringing.notes);
}
