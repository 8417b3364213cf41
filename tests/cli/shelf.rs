//! `tripos shelf`: every publication of the shelf has the verdict that its README states.

use crate::support::{answer, tripos_in};
use expect_test::expect_file;
use serde_json::Value;
use tempfile::TempDir;

/// Goal: no verdict of the shelf changes unseen. Method: the whole output is a snapshot.
#[test]
fn every_publication_keeps_its_verdict() {
    let (status, out, err) = answer(&["shelf"]);
    assert_eq!((status, err.as_str()), (0, ""), "{out}");
    expect_file!["shelf.txt"].assert_eq(&out);
}

/// Goal: each README says the verdict of its publication, and each is on the page.
#[test]
fn readmes_say_what_the_verdict_is() {
    let folder = TempDir::new().unwrap();
    let page = folder.path().join("shelf.html");
    let (_, out, _) = answer(&["shelf", "--json", "--out", page.to_str().unwrap()]);
    let found: Value = serde_json::from_str(&out).unwrap();
    let list = found["publications"].as_array().unwrap();
    assert!(list.len() >= 15, "{} publications", list.len());
    let html = std::fs::read_to_string(page).unwrap();
    for one in list {
        let name = one["name"].as_str().unwrap();
        assert!(html.contains(&format!("<article id=\"{name}\">")), "{name} is not on the page");
        let readme = crate::support::root().join("publications").join(name).join("README.md");
        let readme = std::fs::read_to_string(&readme).unwrap_or_else(|e| panic!("{}: {e}", readme.display()));
        let is_right = one["verdict"] == "right";
        let said: &[&str] = if is_right { &["right", "equal"] } else { &["different"] };
        let unsaid = if is_right { "is different" } else { "Verdict: right" };
        let says = said.iter().any(|word| readme.contains(word));
        assert!(says && !readme.contains(unsaid), "the README of {name} and its verdict");
    }
}

#[test]
fn what_cannot_be_judged_is_told() {
    let folder = TempDir::new().unwrap();
    let (status, _, err) = tripos_in(folder.path(), &["shelf", "."]);
    assert!(status == 2 && err.contains("has no folder with model.toml"), "{err}");
    std::fs::create_dir(folder.path().join("spoilt")).unwrap();
    for name in ["model.toml", "publication.toml"] {
        std::fs::write(folder.path().join("spoilt").join(name), "name = 1").unwrap();
    }
    let (status, out, _) = tripos_in(folder.path(), &["shelf", "."]);
    assert!(status == 1 && out.contains("spoilt: not judged"), "{out}");
}
