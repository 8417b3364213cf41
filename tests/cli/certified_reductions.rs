//! `tripos scene --certificate`: a program that shares no code with Tripos accepts the proofs of true reductions and
//! refuses others.

use crate::certificate::{is_without_python, run_checker, status_of_checker};
use crate::support::{command, root, tripos_in};
use std::path::{Path, PathBuf};

/// Lists the scenes of the models in a folder of the workspace.
fn scenes_in(folder: &str) -> Vec<PathBuf> {
    let models = std::fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap().path().join("scenes"));
    let scenes = models.filter(|path| path.is_dir()).flat_map(|path| std::fs::read_dir(path).unwrap());
    let mut list: Vec<PathBuf> = scenes.map(|entry| entry.unwrap().path()).collect();
    list.sort();
    list
}

/// Writes the certificate of a scene's reduction into a folder, and returns its path. `None` if the scene has no
/// reduced equations.
fn certificate_of_reduction(folder: &Path, scene: &Path) -> Option<String> {
    let names: Vec<_> = scene.iter().rev().take(3).map(|part| part.to_string_lossy().into_owned()).collect();
    let path = folder.join(format!("{}_{}.reduction", names[2], names[0]));
    let output = command(&root(), &["scene"]).arg(scene).arg("--certificate").arg(&path).output().unwrap();
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success() || error.contains("error"), "{}: {error}", scene.display());
    path.is_file().then(|| path.to_str().unwrap().to_owned())
}

/// Goal: the proof of every reduction in the library and on the shelf can be checked without Tripos. Method:
/// `reduction.py` checks each certificate, bound to the files of the model and of the scene. The models with loops, and
/// the largest one, have no reduced equations.
#[test]
fn reductions_are_accepted() {
    if is_without_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let mut accepted = 0;
    for scene in ["models", "publications"].into_iter().flat_map(scenes_in) {
        let Some(file) = certificate_of_reduction(folder.path(), &scene) else { continue };
        let model = scene.ancestors().nth(2).unwrap().to_str().unwrap();
        let (status, text) =
            status_of_checker("reduction.py", &[&file, "--model", model, "--scene", scene.to_str().unwrap()]);
        assert_eq!(status, Some(0), "{text}");
        assert!(text.contains("the reduced motion is one of the whole model"), "{text}");
        accepted += 1;
    }
    assert_eq!(accepted, 35);
}

/// Goal: no certificate of a wrong reduction is accepted. Method: a forger changes reduced equations, constants,
/// outputs, numbers, the reconstruction, hashes and the derivation, in the certificates of three scenes.
#[test]
fn tampered_reductions_are_refused() {
    if is_without_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let scenes =
        ["disk/scenes/report.toml", "spherical_pendulum/scenes/wide.toml", "floating_chain/scenes/folding.toml"];
    let files =
        scenes.map(|scene| certificate_of_reduction(folder.path(), &root().join("models").join(scene)).unwrap());
    let arguments: Vec<&str> = std::iter::once("36").chain(files.iter().map(String::as_str)).collect();
    let (holds, text) = run_checker("tamper_reduction.py", &arguments);
    assert!(holds && text.contains("108 tampered certificates are refused, 0 accepted"), "{text}");
}

/// Goal: a certificate replaces no scene, and belongs to the scene file alone. Method: the scene as the output file,
/// and a number that the command sets.
#[test]
fn a_certificate_replaces_no_scene() {
    let folder = tempfile::tempdir().unwrap();
    let from = root().join("models/pendulum");
    std::fs::copy(from.join("model.toml"), folder.path().join("model.toml")).unwrap();
    let scene = std::fs::read_to_string(from.join("scenes/swing.toml")).unwrap();
    std::fs::write(folder.path().join("scene.toml"), format!("model = \"model.toml\"\n{scene}")).unwrap();
    let (status, _, err) = tripos_in(folder.path(), &["scene", "scene.toml", "--certificate", "scene.toml"]);
    assert!(status == 2 && err.contains("would overwrite the input"), "{status} {err}");
    let words = ["scene", "scene.toml", "--certificate", "c", "--set", "m=2"];
    let (status, _, err) = tripos_in(folder.path(), &words);
    assert!(status == 2 && err.contains("cannot be used with"), "{status} {err}");
    let (status, _, err) = tripos_in(folder.path(), &["scene", "scene.toml", "--certificate", "c"]);
    assert!(status == 0, "{status} {err}");
}
