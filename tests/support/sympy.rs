//! SymPy for the tests: a Python environment of their own, pinned by `tests/sympy/requirements.txt`, made once.
//!
//! It stands in cargo's folder for tests, so `cargo clean` removes it. Making it takes Python 3.11 or newer with
//! `venv`, and a network the first time. What is missing fails the test that asks; only `TRIPOS_WITHOUT_SYMPY=1` leaves
//! such tests out.

#![allow(dead_code, reason = "each test uses its part")]

use std::ffi::{OsStr, OsString};
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;
use tripos_derive::reference::reference_environment_name;

/// The workspace.
pub fn root() -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = here.ancestors().find(|folder| folder.join("tests/sympy/reference.py").is_file());
    root.expect("tests/sympy/reference.py in the workspace").to_owned()
}

/// A script of `tests/sympy`, such as `reference.py` or `judge.py`.
pub fn script(name: &str) -> PathBuf {
    root().join("tests/sympy").join(name)
}

/// True if a test that needs SymPy is left out of this run, which is then printed and counted.
pub fn is_left_out(what: &str) -> bool {
    let left_out = std::env::var_os("TRIPOS_WITHOUT_SYMPY").is_some_and(|value| value == "1");
    crate::left_out::is_left_out("python", !left_out, &format!("{what}, because of TRIPOS_WITHOUT_SYMPY=1"))
}

/// The Python of the environment, which is made if it is not there.
///
/// # Panics
/// If it cannot be made, saying why and what to do.
pub fn python() -> PathBuf {
    static PYTHON: OnceLock<PathBuf> = OnceLock::new();
    PYTHON.get_or_init(|| python_with(&script("requirements.txt"), "import sympy, tomllib")).clone()
}

/// The Python of an environment with the packages of a list, in which a statement runs. It is made if it is not there.
///
/// # Panics
/// If it cannot be made, saying why and what to do.
pub fn python_with(requirements: &Path, import: &str) -> PathBuf {
    environment(requirements, import).unwrap_or_else(|why| {
        panic!(
            "\nthe reference cannot be renewed: {why}\n\
             help: install Python 3.11 or newer with its `venv` (Debian: python3 and python3-venv), name it by TRIPOS_PYTHON if it \
             is not `python3`, and allow pip to fetch {} once;\n      \
             or set TRIPOS_WITHOUT_SYMPY=1 to leave out every comparison with Python\n",
            requirements.display()
        )
    })
}

fn environment(requirements: &Path, import: &str) -> Result<PathBuf, String> {
    let text = std::fs::read_to_string(requirements).map_err(|e| format!("{}: {e}", requirements.display()))?;
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(reference_environment_name(&text));
    let python = folder.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" });
    // Tests of other programs wait here until it is whole.
    let lock = File::create(folder.with_extension("lock")).map_err(|e| e.to_string())?;
    lock.lock().map_err(|e| e.to_string())?;
    let whole = folder.join("whole");
    let import = ["-c", import];
    if whole.is_file() && run(python.as_os_str(), &import).is_ok() {
        return Ok(python);
    }
    if folder.exists() {
        std::fs::remove_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    }
    let base = std::env::var_os("TRIPOS_PYTHON").filter(|p| !p.is_empty()).unwrap_or_else(|| "python3".into());
    run(&base, &["-c", "import sys; sys.exit(0 if sys.version_info >= (3, 11) else 'it is older than Python 3.11')"])?;
    run(&base, &[OsStr::new("-m"), OsStr::new("venv"), folder.as_os_str()])?;
    let mut install: Vec<OsString> = ["-m", "pip", "install", "--quiet", "--no-input", "--disable-pip-version-check"]
        .iter()
        .map(OsString::from)
        .collect();
    if text.contains("--hash") {
        install.push("--require-hashes".into());
    }
    install.extend(["-r".into(), requirements.as_os_str().to_owned()]);
    run(python.as_os_str(), &install)?;
    run(python.as_os_str(), &import)?;
    std::fs::write(&whole, "").map_err(|e| e.to_string())?;
    Ok(python)
}

/// Runs a program to its end; what it wrote is part of the error.
fn run<S: AsRef<OsStr>>(program: &OsStr, arguments: &[S]) -> Result<(), String> {
    let line = || {
        let words = std::iter::once(program).chain(arguments.iter().map(AsRef::as_ref));
        words.map(|word| word.to_string_lossy().into_owned()).collect::<Vec<_>>().join(" ")
    };
    let output = Command::new(program).args(arguments).output();
    let output = output.map_err(|e| format!("`{}` cannot be run: {e}", program.to_string_lossy()))?;
    if output.status.success() {
        return Ok(());
    }
    let said = [output.stdout, output.stderr].concat();
    Err(format!("`{}` ended with {}\n{}", line(), output.status, String::from_utf8_lossy(&said).trim_end()))
}
