//! The Python package: its tests and the examples of its documentation, run by pytest over the compiled extension.

#[path = "../support/left_out.rs"]
mod left_out;
#[path = "../support/sympy.rs"]
mod sympy;

use std::path::{Path, PathBuf};
use std::process::Command;

/// The extension module, which cargo compiled beside this test.
fn extension() -> PathBuf {
    let program = std::env::current_exe().unwrap();
    let folder = program.ancestors().find(|folder| folder.ends_with("deps")).and_then(Path::parent).unwrap();
    let name = format!("{}_tripos{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    // `cargo build` copies it to the folder above, where it may be older than the one of this test.
    let written = |file: &PathBuf| file.metadata().and_then(|data| data.modified()).ok();
    let files = [folder.join(&name), folder.join("deps").join(&name)].into_iter().filter(|file| file.is_file());
    files.max_by_key(written).unwrap_or_else(|| panic!("cargo did not compile {name} in {}", folder.display()))
}

/// Runs pytest with these arguments in a folder in which the package stands as `pip` would install it.
fn pytest(arguments: &[&Path]) {
    let site = tempfile::tempdir().unwrap();
    let package = site.path().join("tripos");
    std::fs::create_dir(&package).unwrap();
    for entry in std::fs::read_dir(sympy::root().join("python/python/tripos")).unwrap() {
        let path = entry.unwrap().path();
        if path.is_file() {
            std::fs::copy(&path, package.join(path.file_name().unwrap())).unwrap();
        }
    }
    let ending = if cfg!(windows) { "pyd" } else { "abi3.so" };
    std::fs::copy(extension(), package.join(format!("_tripos.{ending}"))).unwrap();
    let python =
        sympy::python_with(&sympy::root().join("tests/python/requirements.txt"), "import numpy, pytest, scipy");
    let mut command = Command::new(python);
    command.args(["-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", "--import-mode=importlib"]);
    command.args(arguments);
    let output = command
        .current_dir(site.path())
        .env("PYTHONPATH", site.path())
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
    println!("{said}");
}

#[test]
fn the_package_passes_its_tests() {
    if !sympy::is_left_out("the Python package") {
        pytest(&[&sympy::root().join("python/tests")]);
    }
}

#[test]
fn examples_of_the_documentation_hold() {
    if !sympy::is_left_out("examples of the Python package") {
        pytest(&[Path::new("--doctest-modules"), Path::new("tripos")]);
    }
}
