//! Tests that need a program which is not there.
//!
//! They are left out and counted: each writes a line to `tmp/left_out.txt` in cargo's folder, which `.ci/run` adds up
//! in its last line. Where `TRIPOS_NEEDS` names the program, as in `TRIPOS_NEEDS="python node"`, they fail instead.

use std::fs::OpenOptions;
use std::io::Write;
use std::path::Path;

/// The programs that tests need beside Rust, as `TRIPOS_NEEDS` names them.
const PROGRAMS: [&str; 7] = ["python", "node", "latex", "browser", "gcc", "octave", "arm"];

/// True if this test is left out since its program was not found. Prints the reason then, and counts the test.
///
/// # Panics
/// If the program was not found and `TRIPOS_NEEDS` names it, or if that names what no test needs.
pub fn is_left_out(program: &str, is_found: bool, why: &str) -> bool {
    let needed = std::env::var("TRIPOS_NEEDS").unwrap_or_default();
    let unknown = needed.split_whitespace().find(|name| !PROGRAMS.contains(name));
    assert!(unknown.is_none(), "TRIPOS_NEEDS names {unknown:?}, and programs are {PROGRAMS:?}");
    if is_found {
        return false;
    }
    assert!(!needed.split_whitespace().any(|name| name == program), "TRIPOS_NEEDS names {program}: {why}");
    let test = std::thread::current().name().unwrap_or("a test").to_owned();
    let line = format!("{program}: {test}: {why}\n");
    // Not `eprint`, whose text the test harness keeps to itself.
    let _ = write!(std::io::stderr(), "LEFT OUT, {line}");
    let place = Path::new(env!("CARGO_TARGET_TMPDIR")).join("left_out.txt");
    let list = OpenOptions::new().create(true).append(true).open(place);
    list.and_then(|mut list| list.write_all(line.as_bytes())).expect("cargo's folder can be written");
    true
}
