//! The pages of the models of the library: small enough to load, and seen in a browser as they should be.

use crate::support::{browser, root, status, stderr, tripos};
use std::path::Path;
use std::process::Command;

/// Bytes that a page may have; that of the disk has at most 1.5 MB, which `page` holds.
const LARGEST: u64 = 1_600_000;

/// The exit status where a run could not go on.
const STOPPED: i32 = 3;

/// Makes the pages of these models, each in a folder of its name, and looks at them in a browser if there is one.
fn look(models: &[String]) {
    let folder = tempfile::tempdir().unwrap();
    let mut wrong = Vec::new();
    for name in models {
        let out = folder.path().join(name);
        let model = root().join("models").join(name);
        let output = tripos(&["page", model.to_str().unwrap(), "--out", out.to_str().unwrap()]);
        // One scene of the linkage ends at a place where its equations divide by zero, as its file says.
        let expected = if name == "window_linkage" { STOPPED } else { 0 };
        assert_eq!(status(&output), expected, "{name}: {}", stderr(&output));
        let size = std::fs::metadata(out.join("index.html")).unwrap().len();
        println!("{name}: {size} bytes");
        if size > LARGEST {
            wrong.push(format!("{name}: {size} bytes"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
    let Some(modules) = browser() else { return };
    let held = in_browser(folder.path(), &modules);
    // Each on a desktop and on a phone, every fifth in the dark.
    assert_eq!(held, 2 * models.len() + models.len().div_ceil(5));
}

/// Number of looks in a browser at the pages of a folder. All succeeded, or the test fails.
fn in_browser(folder: &Path, modules: &Path) -> usize {
    let mut node = Command::new("node");
    node.arg(root().join("tests/browser/pages.mjs")).arg(folder);
    if let Some(pictures) = std::env::var_os("TRIPOS_PICTURES") {
        node.arg(pictures);
    }
    let output = node.current_dir(modules.join("..")).output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    println!("{said}");
    assert!(output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
    said.matches(": held").count()
}

/// Goal: the pages of any mechanism are readable. Method: `tests/browser/pages.mjs` opens two in a browser, as all of
/// them are opened below.
#[test]
fn a_browser_shows_pages_that_fit_their_screens() {
    look(&["furuta", "pendulum"].map(str::to_owned));
}

/// Goal: the page of every model is readable. Method: each is at most 1.6 MB. In a real browser on a desktop and a
/// phone, folded and unfolded, no element is wider than the screen, and nothing is complained of. No word of the sketch
/// is cut off or written over, no scrolling box is endless or out of reach, and the page is at most 12 screens long.
/// `TRIPOS_PICTURES=FOLDER` keeps the pictures.
#[test]
#[ignore = "makes the pages of all models, which takes minutes; .ci/full runs it"]
fn a_browser_shows_the_page_of_every_model() {
    let models = std::fs::read_dir(root().join("models")).unwrap();
    let mut names: Vec<String> = models.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort_unstable();
    assert!(names.len() >= 26, "{names:?}");
    look(&names);
}
