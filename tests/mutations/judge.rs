//! SymPy's word on whether two formulas mean the same.

use crate::sympy::{is_left_out, python, script};
use std::io::Write;
use std::process::{Command, Stdio};

/// Answers of `judge.py` to each pair: `equal`, `different` or `unknown`; `None` if the environment has
/// `TRIPOS_WITHOUT_SYMPY=1`.
pub fn judge(pairs: &[(String, String)], positive: &[String]) -> Option<Vec<String>> {
    if pairs.is_empty() {
        return Some(Vec::new());
    }
    if is_left_out("SymPy's word on a mutant that is not called different") {
        return None;
    }
    let mut child = Command::new(python())
        .arg(script("judge.py"))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("this Python has run before");
    let line = |(left, right): &(String, String)| {
        serde_json::json!({ "left": left, "right": right, "positive": positive }).to_string() + "\n"
    };
    let lines: String = pairs.iter().map(line).collect();
    // Dropped at once, which ends the input. The answers, a word each, fit into the pipe.
    child.stdin.take().expect("piped").write_all(lines.as_bytes()).expect("it reads");
    let output = child.wait_with_output().expect("it ends");
    let answers: Vec<String> = String::from_utf8_lossy(&output.stdout).lines().map(str::to_owned).collect();
    assert_eq!(answers.len(), pairs.len(), "one answer for each pair: {answers:?}");
    Some(answers)
}
