//! Every section of `benches/peers` runs, as small as it can be and without other people's packages.
//!
//! What is seen here: the workers answer, all of them compute the same numbers (`run.py` measures nothing otherwise),
//! and each row of Tripos has figures. Absent on purpose: any judgement of speed, and the peers; nothing is installed,
//! and no result is written.

use std::path::Path;
use std::process::Command;
use std::sync::{Mutex, PoisonError};

/// The printed text of a section of the comparison with other programs.
///
/// None if there is no Python and the tests that need it are left out.
fn printed(section: &str) -> Option<String> {
    // They share programs and files.
    static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
    let _turn = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
    let python = std::env::var_os("TRIPOS_PYTHON").filter(|p| !p.is_empty()).unwrap_or_else(|| "python3".into());
    let output = Command::new(&python)
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/peers/run.py"))
        .args(["--small", "--packages", "none", "--only", section])
        // What this run of the tests has built is used again.
        .env("CARGO_TARGET_DIR", Path::new(env!("CARGO_TARGET_TMPDIR")).parent().expect("cargo's own folder"))
        .env("CARGO_NET_OFFLINE", "true")
        .env_remove("CARGO_MANIFEST_DIR")
        .output();
    let output = match output {
        Err(_) if std::env::var_os("TRIPOS_WITHOUT_SYMPY").is_some_and(|value| value == "1") => {
            let why = format!("there is none for benches/peers, {section}");
            assert!(crate::left_out::is_left_out("python", false, &why));
            return None;
        }
        Err(error) => panic!("{} cannot be run: {error}; install Python 3.11 or newer", python.display()),
        Ok(output) => output,
    };
    assert!(output.status.success(), "{section}: {}", String::from_utf8_lossy(&output.stderr));
    Some(String::from_utf8(output.stdout).unwrap())
}

/// The cells of the rows of Tripos.
fn rows_of_tripos(text: &str) -> Vec<Vec<&str>> {
    let rows = text.lines().filter(|line| line.starts_with("| Tripos") && !line.contains('÷'));
    rows.map(|line| line.trim_matches('|').split('|').map(str::trim).collect()).collect()
}

/// True if a cell starts with a finite number.
fn is_figure(cell: &str) -> bool {
    let number = cell.split_whitespace().next().and_then(|word| word.parse::<f64>().ok());
    number.is_some_and(f64::is_finite)
}

/// The section has a table with each of these rows, every row of Tripos has figures, and none of them is missing or not
/// a number.
fn has_figures_of(section: &str, wanted: &[&str]) {
    let Some(text) = printed(section) else { return };
    let rows = rows_of_tripos(&text);
    for name in wanted {
        assert!(rows.iter().any(|row| row[0] == *name), "{section} has no row `{name}`:\n{text}");
    }
    // The head of a table names its column, as `Tripos, not in the times above` does.
    for row in rows.iter().filter(|row| !row[0].contains("not in the times above")) {
        let is_missing = |cell: &&str| ["nan", "inf", "not reached"].iter().any(|word| cell.contains(word));
        assert!(row[1..].iter().any(|cell| is_figure(cell)), "{section}: no figure in {row:?}");
        assert!(!row[1..].iter().any(is_missing), "{section}: {row:?}");
    }
    assert!(text.contains("- Left out, since packages of Python were not asked for: "), "{text}");
}

#[test]
fn derivations_are_measured() {
    has_figures_of("derivation", &["Tripos, kane", "Tripos, lagrange", "Tripos, newton-euler"]);
}

#[test]
fn mechanisms_with_loops_are_derived() {
    has_figures_of("mechanisms", &["Tripos, kane", "Tripos, lagrange"]);
}

#[test]
fn right_hand_sides_are_measured() {
    let rows = ["Tripos, default build", "Tripos, default build, 8 lanes", "Tripos, `tripos emit`"];
    has_figures_of("rhs", &rows);
}

#[test]
fn arms_are_measured() {
    has_figures_of("arms", &["Tripos, default build", "Tripos, C"]);
}

#[test]
fn whole_runs_are_measured_by_all_equations_and_by_those_of_the_scenes() {
    let rows = [
        "Tripos, Lagrange, default build",
        "Tripos, Kane, default build",
        "Tripos, Lagrange, taylor, default build",
        "Tripos, all equations, Kane, taylor, default build",
        "Tripos, reduced, dop853, default build",
        "Tripos, reduced, taylor on the energy, default build",
        "Tripos, reduced, quadrature, default build",
    ];
    has_figures_of("runs", &rows);
}

#[test]
fn batches_are_measured() {
    let rows = [
        "Tripos, DOP853, one by one, default build",
        "Tripos, DOP853 in lanes, default build",
        "Tripos, Taylor in lanes, default build",
    ];
    has_figures_of("batches", &rows);
}

#[test]
fn growth_is_measured() {
    has_figures_of("growth", &["Tripos, kane: derivation", "Tripos, kane: operations", "Tripos, kane: a state"]);
}

#[test]
fn an_edited_model_is_followed_to_its_first_result() {
    let emitted = "Tripos, `tripos emit` of one formulation and `cargo build` of a crate of one's own";
    has_figures_of("first-result", &["Tripos, interpreted", emitted]);
}
