//! Symmetries of the flow of a mechanism: motions that leave its equations unchanged.

use std::path::Path;
use tripos_derive::Model;
use tripos_derive::flow::Flow;

fn symmetries(model: &str) -> Vec<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(model).join("model.toml");
    let model = Model::read(&path).unwrap_or_else(|e| panic!("{e}"));
    let flow = Flow::new(&model).unwrap_or_else(|e| panic!("{e:?}"));
    flow.symmetries.iter().map(|symmetry| symmetry.words(&model)).collect()
}

/// Goal: the symmetries that a textbook names are found, and no others. Method: models whose symmetries are known. A
/// rolling disc may be moved on its plane though no momentum along the plane is kept; a pendulum may not be turned.
#[test]
fn symmetries_are_those_of_the_textbook() {
    assert_eq!(symmetries("pendulum"), [""; 0]);
    assert_eq!(symmetries("four_bar"), [""; 0]);
    assert_eq!(
        symmetries("rolling_disc"),
        ["a shift of q3", "a shift of x", "a shift of y", "a rotation about n3 through O"]
    );
    assert_eq!(
        symmetries("disk"),
        ["a shift of q3", "a shift of q4", "a shift of q5", "a rotation about a3 through O"]
    );
    assert_eq!(symmetries("heavy_top"), ["a shift of q3", "a rotation about n3 through O"]);
    assert_eq!(symmetries("free_body").len(), 8, "{:?}", symmetries("free_body"));
}

/// Goal: attitudes by Euler parameters have the symmetries of attitudes by angles. Method: a free satellite may be
/// turned about any axis, and its wheel about its own.
#[test]
fn euler_parameters_hide_no_symmetry() {
    let found = symmetries("satellite");
    for axis in 1..=3 {
        assert!(found.iter().any(|words| words.starts_with(&format!("a rotation about n{axis}"))), "{found:?}");
    }
    assert!(found.contains(&"a shift of phi".to_owned()), "{found:?}");
}
