//! Shared code of the tests of the command.

use crate::left_out::is_left_out;
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

pub use crate::slider::SLIDER;

/// The folder of the workspace.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}

/// The command, to be run in a folder.
pub fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tripos"));
    command.args(arguments).current_dir(folder);
    command
}

/// Output of the command, run in the folder of the workspace.
pub fn tripos(arguments: &[&str]) -> Output {
    command(&root(), arguments).output().unwrap()
}

/// The command in a folder: exit status, standard output, standard error.
pub fn tripos_in(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    let output = command(folder, arguments).output().unwrap();
    (status(&output), stdout(&output), stderr(&output))
}

/// The command in the folder of the workspace: exit status, standard output, standard error.
pub fn answer(arguments: &[&str]) -> (i32, String, String) {
    tripos_in(&root(), arguments)
}

/// Values that are made once, by name, for all tests that ask for them. A test that asks for another value does not
/// wait.
struct Once<T>(Mutex<BTreeMap<String, Arc<OnceLock<T>>>>);

impl<T: Clone> Once<T> {
    const fn new() -> Self {
        Self(Mutex::new(BTreeMap::new()))
    }

    fn get(&self, name: &str, make: impl FnOnce() -> T) -> T {
        let place = self.0.lock().unwrap_or_else(PoisonError::into_inner).entry(name.to_owned()).or_default().clone();
        place.get_or_init(make).clone()
    }
}

/// The page of a model of the library, which every test that reads it shares, and what the command said beside it.
pub fn page(model: &str) -> (Arc<str>, Arc<str>) {
    static PAGES: Once<(Arc<str>, Arc<str>)> = Once::new();
    PAGES.get(model, || {
        let folder = tempfile::tempdir().unwrap();
        let output = tripos(&["page", model, "--out", folder.path().to_str().unwrap()]);
        assert_eq!(status(&output), 0, "{model}: {}", stderr(&output));
        let page = std::fs::read_to_string(folder.path().join("index.html")).unwrap();
        (page.into(), stderr(&output).into())
    })
}

/// Name and derived document of each model of the library, in this format; all tests that read it share the text.
pub fn library_as(format: &str) -> impl Iterator<Item = (String, Arc<str>)> {
    static DOCUMENTS: Once<Arc<str>> = Once::new();
    let folders = std::fs::read_dir(root().join("models")).unwrap();
    let mut names: Vec<String> = folders.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names.into_iter().map(move |name| {
        let text = DOCUMENTS.get(&format!("{name} {format}"), || {
            let (status, text, err) = answer(&["derive", &format!("models/{name}"), "--format", format]);
            assert_eq!(status, 0, "{name}: {err}");
            text.into()
        });
        (name, text)
    })
}

/// The exit status of a command that was not killed.
pub fn status(output: &Output) -> i32 {
    output.status.code().expect("ended by itself, not by a signal")
}

pub fn stdout(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

pub fn stderr(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// Standard output of a command that succeeds and says nothing but JSON there.
pub fn json(output: &Output) -> Value {
    assert_eq!(status(output), 0, "{}", stderr(output));
    serde_json::from_slice(&output.stdout).expect("standard output is the JSON alone")
}

/// JSON of a command that succeeds.
pub fn answer_in_json(arguments: &[&str]) -> Value {
    json(&tripos(arguments))
}

/// Folder of the Node modules with playwright-core, if it, Node and Chromium are installed; if not, the test is counted
/// as left out.
pub fn browser() -> Option<PathBuf> {
    let found = || {
        let chromium = std::env::var_os("CHROMIUM").map_or_else(|| PathBuf::from("/usr/bin/chromium"), PathBuf::from);
        let modules = PathBuf::from(std::env::var_os("NODE_PATH")?);
        let node = Command::new("node").arg("--version").output().is_ok_and(|output| output.status.success());
        (chromium.is_file() && node && modules.join("playwright-core").is_dir()).then_some(modules)
    };
    let (modules, why) = (found(), "there is no Chromium, no Node, or no playwright-core in NODE_PATH");
    if is_left_out("browser", modules.is_some(), why) { None } else { modules }
}

/// A page without its scripts.
pub fn without_scripts(page: &str) -> String {
    let mut pieces = page.split("<script");
    let first = pieces.next().unwrap_or_default();
    let others = pieces.map(|piece| piece.split_once("</script>").map_or("", |(_, rest)| rest));
    std::iter::once(first).chain(others).collect()
}

/// Every file and folder of a folder.
pub fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let (path, name) = entry.map(|entry| (entry.path(), entry.file_name())).unwrap();
        if path.is_dir() {
            copy(&path, &to.join(name));
        } else {
            std::fs::copy(&path, to.join(name)).unwrap();
        }
    }
}

/// Makes a folder a crate that has nothing but the traits of generated code; its sources are under `src`.
pub fn make_crate(folder: &Path) {
    let manifest = format!(
        "[package]\nname = \"user\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n[profile.dev]\ndebug = 0\n[dependencies]\ntripos-traits = {{ path = '{}' }}\n",
        root().join("sim/traits").display()
    );
    std::fs::write(folder.join("Cargo.toml"), manifest).unwrap();
    std::fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock")).unwrap();
}

/// Cargo in a crate that a test has made, which succeeds: standard output, standard error. All such crates are built in
/// one folder.
pub fn cargo(folder: &Path, arguments: &[&str]) -> (String, String) {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    command.args(arguments).arg("--offline").current_dir(folder).env("RUSTDOCFLAGS", "-D warnings");
    let Output { status, stdout, stderr } =
        command.env("CARGO_TARGET_DIR", Path::new(env!("CARGO_TARGET_TMPDIR")).join("crates")).output().unwrap();
    let (out, err) = (String::from_utf8_lossy(&stdout).into_owned(), String::from_utf8_lossy(&stderr).into_owned());
    assert!(status.success(), "{arguments:?}: {err}");
    (out, err)
}
