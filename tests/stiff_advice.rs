//! No scene of the library is said to be kept at short steps by stability, but those whose steps it does keep short.

use std::path::{Path, PathBuf};
use tripos::{Overrides, Scene};

fn scenes() -> Vec<PathBuf> {
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("models");
    let folders = std::fs::read_dir(models).unwrap().map(|entry| entry.unwrap().path().join("scenes"));
    let files = folders.filter_map(|folder| std::fs::read_dir(folder).ok()).flatten();
    let mut list: Vec<PathBuf> = files.map(|entry| entry.unwrap().path()).collect();
    list.sort();
    list
}

/// Goal: advice is never given where it is not needed. Method: every scene by explicit methods, at tolerances from
/// coarse to fine, so that steps of some thousand are among them.
#[test]
fn no_scene_of_the_library_is_said_to_be_stiff() {
    let mut long = 0;
    for path in scenes() {
        let scene = Scene::read(&path).unwrap_or_else(|e| panic!("{e}")).with_compiled_equations(tripos_models::MODELS);
        for (method, tolerance) in [("ode45", 1e-4), ("ode45", 1e-11), ("dop853", 1e-13)] {
            let how = Overrides {
                method: Some(method.parse().unwrap()),
                rtol: Some(tolerance),
                atol: Some(tolerance),
                ..Overrides::default()
            };
            let run = scene.simulate(&how).unwrap_or_else(|e| panic!("{}, {method}: {e}", path.display()));
            long += u32::from(run.solution.steps > 2_000);
            let said = run.notes.iter().find(|note| note.contains("limited by stability"));
            assert!(said.is_none(), "{}, {method} at {tolerance:e}: {said:?}", path.display());
        }
    }
    assert!(long > 10, "only {long} runs are long enough to be asked");
}
