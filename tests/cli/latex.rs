//! `tripos derive --format latex`: all that is derived, in LaTeX that compiles.

use crate::support::{root, tripos_in};

/// What is wrong with a text that must compile in the body of a document with amsmath: braces, environments and pairs
/// that do not match, mathematics outside of formulas, formulas inside of formulas.
fn faults(text: &str) -> Vec<String> {
    let (mut open, mut in_formula, mut faults) = (Vec::<String>::new(), false, Vec::new());
    let lines = text.lines().filter(|line| !line.starts_with('%'));
    for (number, line) in lines.enumerate() {
        let mut rest = line;
        while let Some(c) = rest.chars().next() {
            let word: usize = match c {
                '\\' if rest[1..].starts_with(|c: char| c.is_ascii_alphabetic()) => {
                    1 + rest[1..].find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len() - 1)
                }
                '\\' => 1 + rest[1..].chars().next().map_or(0, char::len_utf8),
                c => c.len_utf8(),
            };
            let (token, after) = rest.split_at(word);
            let mut close = |what: &str| {
                if open.pop().as_deref() != Some(what) {
                    faults.push(format!("line {number}: `{token}` closes nothing: {line}"));
                }
            };
            match token {
                "{" | "\\left" => open.push(token.to_owned()),
                "}" => close("{"),
                "\\right" => close("\\left"),
                "\\begin" => open.push(after[..after.find('}').unwrap_or(0)].to_owned()),
                "\\end" => close(&after[..after.find('}').unwrap_or(0)]),
                "\\(" | "\\[" => in_formula = true,
                "\\)" | "\\]" => in_formula = false,
                "$" => in_formula = !in_formula,
                "\\ensuremath" => {}
                "_" | "^" | "&" | "\\frac" | "\\sin" | "\\cos" if !in_formula => {
                    faults.push(format!("line {number}: `{token}` outside of a formula: {line}"));
                }
                "#" | "%" | "~" => faults.push(format!("line {number}: `{token}`: {line}")),
                other if !other.is_ascii() && !('\u{c0}'..='\u{ff}').contains(&c) => {
                    faults.push(format!("line {number}: TeX has no `{other}`: {line}"));
                }
                _ => {}
            }
            rest = after;
        }
        if in_formula && line.is_empty() {
            faults.push(format!("line {number}: an empty line in a formula"));
        }
    }
    faults.extend(open.iter().map(|what| format!("`{what}` stays open")));
    faults
}

#[test]
fn every_model_of_the_library_becomes_latex_that_compiles() {
    for entry in std::fs::read_dir(root().join("models")).unwrap() {
        let model = entry.unwrap().path();
        let (status, text, err) = tripos_in(&root(), &["derive", model.to_str().unwrap(), "--format", "latex"]);
        assert_eq!(status, 0, "{err}");
        assert_eq!(faults(&text), Vec::<String>::new(), "{}", model.display());
    }
}

/// What stands in the text stands in LaTeX, for each formulation: the steps, M and f, accelerations, energies, singular
/// places; and what is conserved.
#[test]
fn latex_has_all_that_the_text_has() {
    let text = |by: &str| tripos_in(&root(), &["derive", "models/disk", "--by", by, "--format", "latex"]).1;
    for by in ["kane", "lagrange", "newton-euler"] {
        let text = text(by);
        for needed in [
            "\\subsection{Generalized speeds and kinematic equations}",
            "\\(\\dot{q}_{1} = \\frac{u_{2}}{\\cos q_{2}}\\)",
            "\\subsection{Equations of motion}",
            "\\subsection{Accelerations}",
            "\\subsection{Kinetic and potential energy}",
            "\\(V = M \\, R \\, g \\, \\left(\\cos q_{2} - 1\\right)\\)",
            "\\(\\cos q_{2} = 0\\)",
            "\\section{First integrals}",
            "\\paragraph{energy T + V}",
        ] {
            assert!(text.contains(needed), "{by}: {needed}\n{text}");
        }
    }
    assert!(text("kane").contains("{}^{A}\\boldsymbol{\\omega}^{C} \\cdot \\mathbf{b}_{1} = u_{1}\\)"));
    assert!(text("kane").contains("\\begin{bmatrix}") && text("lagrange").contains("\\ddot{q}_{1}"));
}

#[test]
fn hostile_titles_and_names_are_text() {
    let folder = tempfile::tempdir().unwrap();
    let model = std::fs::read_to_string(root().join("models/pendulum/model.toml")).unwrap();
    let title = model.lines().find(|line| line.starts_with("name = ")).unwrap();
    let hostile = model.replace(title, "name = '100% \\input{x} $_# {θ} ~ ^ & é 世界'").replace("rod", "rod_1_");
    std::fs::write(folder.path().join("model.toml"), hostile).unwrap();
    let (status, text, err) = tripos_in(folder.path(), &["derive", "model.toml", "--format", "latex"]);
    assert_eq!(status, 0, "{err}");
    assert_eq!(faults(&text), Vec::<String>::new(), "{text}");
    assert!(text.contains("\\section*{100\\% \\textbackslash{}input\\{x\\} \\$\\_\\# \\{[U+03B8]\\}"), "{text}");
}
