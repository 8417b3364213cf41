//! Lengths of derived formulas beside the printed formulas of publications, as the page `docs/lengths.md`.

use crate::support::{root, tripos_in};
use serde_json::Value;
use std::fmt::Write;

/// Publications of the table, with their mechanisms.
const SHELF: [(&str, &str); 5] = [
    ("heavy_top", "heavy top"),
    ("two_link_arm", "arm of two links"),
    ("gantry_crane", "gantry crane"),
    ("double_pendulum_text", "double pendulum"),
    ("furuta_cazzolato", "Furuta pendulum"),
];

/// Commands of LaTeX that set a formula and are no symbols of it.
const SETTING: [&str; 26] = [
    "frac",
    "tfrac",
    "dfrac",
    "left",
    "right",
    "big",
    "Big",
    "bigl",
    "bigr",
    "dot",
    "ddot",
    "cdot",
    "mathrm",
    "text",
    "quad",
    "qquad",
    "displaystyle",
    "begin",
    "end",
    "label",
    "nonumber",
    "notag",
    "times",
    "hspace",
    "partial",
    "sqrt",
];

/// Number of symbols of a formula: names with their indices, dots and primes, functions, and numbers, exponents among
/// them.
fn symbols(formula: &str) -> usize {
    let is_latex = formula.contains('\\') || !formula.contains('*');
    let letters: Vec<char> = formula.replace("ca.", "").chars().collect();
    let (mut at, mut count) = (0, 0);
    let end = |from: usize, is_in: &dyn Fn(char) -> bool| {
        letters[from..].iter().position(|c| !is_in(*c)).map_or(letters.len(), |n| from + n)
    };
    while at < letters.len() {
        let c = letters[at];
        if c == '\\' {
            let stop = end(at + 1, &|c| c.is_ascii_alphabetic());
            let word: String = letters[at + 1..stop].iter().collect();
            count += usize::from(!word.is_empty() && !SETTING.contains(&word.as_str()));
            at = stop.max(at + 2);
        } else if is_latex && c == '_' {
            // An index belongs to the name before it.
            let open = at + 1 + letters[at + 1..].iter().take_while(|c| **c == ' ').count();
            at = match letters.get(open) {
                Some('{') => end(open, &|c| c != '}') + 1,
                Some('\\') => end(open + 1, &|c| c.is_ascii_alphabetic()),
                _ => open + 1,
            };
        } else if c.is_ascii_digit() {
            count += 1;
            at = end(at, &|c| c.is_ascii_digit() || c == '.');
        } else if c.is_ascii_alphabetic() {
            count += 1;
            at = if is_latex { at + 1 } else { end(at, &|c| c.is_ascii_alphanumeric() || c == '_' || c == '\'') };
        } else {
            at += 1;
        }
    }
    count
}

/// Row of the table: the right formulas of a publication, and the sums of their symbols in print and as derived.
/// Formulas that print a rate d/dt or the variable of a program are left out, since the print is not the whole formula.
fn row(folder: &str, mechanism: &str) -> String {
    let place = format!("publications/{folder}");
    let (_, said, _) = tripos_in(&root(), &["diff", &place, &format!("{place}/publication.toml"), "--json"]);
    let said: Value = serde_json::from_str(&said).unwrap();
    let entries = said["equations"].as_array().unwrap().iter().filter(|entry| entry["verdict"] == "equal");
    let text = |entry: &Value, key: &str| entry[key].as_str().unwrap_or_default().to_owned();
    let formulas: Vec<(String, String)> = entries
        .map(|entry| (text(entry, "printed"), text(entry, "derived")))
        .filter(|(printed, derived)| !printed.contains("\\frac{d}") && symbols(printed) > 1 && !derived.is_empty())
        .collect();
    let sum = |side: &dyn Fn(&(String, String)) -> usize| formulas.iter().map(side).sum::<usize>();
    let (printed, derived) = (sum(&|pair| symbols(&pair.0)), sum(&|pair| symbols(&pair.1)));
    format!("| {mechanism} | [`{folder}`](../{place}/README.md) | {} | {printed} | {derived} |\n", formulas.len())
}

/// Goal: the lengths of printed forms in docs are counted, not typed in. Method: the page is a snapshot.
#[test]
fn lengths_beside_published_forms() {
    let mut page = String::from(
        "# Lengths of derived formulas\n\nThis page compares formulas that Tripos derives with the same formulas in publications. The test\n\
         `tests/cli/lengths.rs` counts the symbols and writes this page.\n\n\
         A symbol is a name with its index and dots, a function, or a number; exponents are numbers. Both columns follow this\n\
         rule. A publication may give names to parts of a formula, such as c₁₂ for cos(θ₁ + θ₂); each such name counts as one\n\
         symbol. Only right formulas count. Formulas that print an unexpanded d/dt are left out.\n\n\
         | mechanism | publication | formulas | symbols in print | symbols as derived |\n|---|---|---|---|---|\n",
    );
    for (folder, mechanism) in SHELF {
        let _ = write!(page, "{}", row(folder, mechanism));
    }
    expect_test::expect_file!["../../docs/lengths.md"].assert_eq(&page);
}

#[test]
fn symbols_are_counted_alike_in_both_languages() {
    assert_eq!(symbols("l_2^2 m_2 + 2 l_1 l_2 m_2 c_2"), 8);
    assert_eq!(symbols("\\frac{A}{2}\\left(\\dot\\theta^2 + \\sin^2\\theta\\right)"), 7);
    assert_eq!(symbols("A*(phi'^2*sin(theta)^2)/2"), 7);
}
