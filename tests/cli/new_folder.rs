//! `tripos new`.

use crate::support::{root, tripos_in};

/// Goal: what is written can be used at once, and nothing that is there is touched. Method: prove and run it.
#[test]
fn a_new_folder_is_proved_and_runs() {
    let folder = tempfile::tempdir().unwrap();
    let call = |arguments: &[&str]| tripos_in(folder.path(), arguments);
    let (status, out, err) = call(&["new", "a \"cart\""]);
    assert!(status == 0 && out.contains("tripos simulate a \"cart\"/scenes/first.toml"), "{out}{err}");
    let (status, out, err) = call(&["prove", "a \"cart\"/model.toml"]);
    assert!(status == 0 && out.matches("proved").count() >= 4 && err.is_empty(), "{out}{err}");
    let (status, out, err) = call(&["simulate", "a \"cart\"/scenes/first.toml"]);
    assert!(status == 0 && out.contains("digits are right at the end"), "{out}{err}");

    std::fs::write(folder.path().join("a \"cart\"/scenes/first.toml"), "mine").unwrap();
    for place in ["a \"cart\"", ".", "a \"cart\"/model.toml"] {
        let (status, _, err) = call(&["new", place]);
        assert!(status == 2 && err.contains("help:"), "{place}: {err}");
    }
    assert_eq!(std::fs::read_to_string(folder.path().join("a \"cart\"/scenes/first.toml")).unwrap(), "mine");
}

/// Goal: a model of the library, or any other, to begin from. Method: the text is that of the model, with all scenes.
#[test]
fn a_new_folder_is_like_another() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().join("mine");
    let place = place.to_str().unwrap();
    let (status, _, err) = tripos_in(&root(), &["new", place, "--like", "four_bar"]);
    assert_eq!(status, 0, "{err}");
    let read = |path: &std::path::Path| std::fs::read_to_string(path).unwrap();
    for file in ["model.toml", "scenes/turning.toml", "scenes/crossed.toml"] {
        assert_eq!(read(&folder.path().join("mine").join(file)), read(&root().join("models/four_bar").join(file)));
    }
    let (status, _, err) = tripos_in(folder.path(), &["new", "other", "--like", "mine/model.toml"]);
    assert!(status == 0 && folder.path().join("other/scenes/turning.toml").is_file(), "{err}");
    let (status, _, err) = tripos_in(folder.path(), &["new", "third", "--like", "nothing"]);
    assert!(status == 2 && err.contains("nothing") && !folder.path().join("third").exists(), "{err}");
}
