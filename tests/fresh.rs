//! The committed equations are what the models give, byte by byte.

use std::path::PathBuf;
use std::sync::LazyLock;
use tripos_codegen::freshness;
use tripos_codegen::generated_workspace::{Freshness, generate, model_folders};

#[path = "../build.rs"]
#[allow(dead_code, reason = "a program of its own")]
mod build;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Freshly generated files, made once for all tests here and compared with the committed ones.
static FOUND: LazyLock<Freshness> =
    LazyLock::new(|| freshness(&root().join("models"), &root().join("generated/src"), None).unwrap());

/// Fails while a model was edited and `tripos regenerate` was not run.
#[test]
fn generated_text_is_what_the_models_give() {
    for (name, diagnostics) in &FOUND.generated.broken {
        eprintln!("models/{name}:\n{diagnostics}");
    }
    assert!(FOUND.generated.broken.is_empty(), "a model of the library has errors");
    let list: Vec<String> = FOUND.differences.iter().map(ToString::to_string).collect();
    assert!(list.is_empty(), "generated/ is stale; run `tripos regenerate` and read its diff:\n{}", list.join("\n"));
}

/// The same text gives the same bytes: two derivations in one process share no state, and differ in the
/// order in which memory is handed out.
#[test]
fn generating_twice_gives_the_same_bytes() {
    let models = root().join("models");
    let folders = model_folders(&models).unwrap();
    let mut again = std::thread::spawn(move || generate(&models, &folders)).join().unwrap().files;
    let mut first = FOUND.generated.files.clone();
    // The list of all models stands beside what each gives.
    assert!(first.remove("lib.rs").is_some() && again.remove("lib.rs").is_none() && !again.is_empty());
    assert_eq!(first, again);
}

/// The build depends on nothing, so it hashes by itself.
#[test]
fn the_build_hashes_as_the_deriving_crate_does() {
    for length in 0..200_u8 {
        let text: String = (0_u8..length).map(|at| char::from(b' ' + at.wrapping_mul(length) % 95)).collect();
        assert_eq!(build::hash(&text), tripos_derive::model::text_hash(&text), "{text:?}");
    }
}

/// The build leaves the same sections out of a text.
#[test]
fn the_build_leaves_out_the_same_shapes() {
    for shapes in [
        "",
        "[shapes]\nx = 1\n",
        "\n\n[shapes.x]\ny = 1\n[notation]\n[shapes.z]\n",
        "[shapes]\nx = 1\n[points]\n",
        "[shapes]\nx = 1\n  [forces.f]\n",
    ] {
        let text = format!("name = \"a\"\n{shapes}");
        assert_eq!(build::equations_text(&text), tripos_derive::model::equations_text(&text), "{shapes}");
    }
}
