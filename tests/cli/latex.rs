//! `tripos derive --format latex`: all that is derived, in LaTeX that compiles and says what JSON says.

use crate::left_out::is_left_out;
use crate::support::{library_as, root, tripos_in};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Stdio};
use tripos_derive::algebra::meaning::compare::Comparer;
use tripos_derive::algebra::text::notation::{LatexSymbol, Notation, SymbolNames, Unknown, read_symbol, translate};
use tripos_derive::algebra::text::parse::parse_primed;
use tripos_derive::algebra::text::print::latex_name;
use tripos_derive::algebra::{Arena, Expr};

/// Faults of a text that must compile in the body of a document with amsmath: braces, environments and pairs that do
/// not match, mathematics outside of formulas, formulas inside of formulas.
pub fn faults(text: &str) -> Vec<String> {
    let (mut open, mut in_formula, mut faults) = (Vec::<String>::new(), false, Vec::new());
    let lines = text.lines().filter(|line| !line.starts_with('%'));
    let is_formula = |after: &str| after.starts_with("{align}") || after.starts_with("{equation}");
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
                "\\begin" => {
                    in_formula |= is_formula(after);
                    open.push(after[..after.find('}').unwrap_or(0)].to_owned());
                }
                "\\end" => {
                    in_formula &= !is_formula(after);
                    close(&after[..after.find('}').unwrap_or(0)]);
                }
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
    for (model, text) in library_as("latex") {
        assert_eq!(faults(&text), Vec::<String>::new(), "{model}");
    }
}

/// Goal: LaTeX has all parts of the text, for each formulation: the steps, M and f, accelerations, energies, singular
/// places, and first integrals.
#[test]
fn latex_has_all_that_the_text_has() {
    let text = |by: &str| tripos_in(&root(), &["derive", "models/disk", "--by", by, "--format", "latex"]).1;
    for by in ["kane", "lagrange", "newton-euler"] {
        let text = text(by);
        for needed in [
            "\\subsection{Generalized speeds and kinematic equations}",
            "\\dot{q}_{1} &= \\frac{u_{2}}{\\cos q_{2}} ",
            "\\subsection{Equations of motion}",
            "\\subsection{Accelerations}",
            "\\subsection{Kinetic and potential energy}",
            "V &= M \\, R \\, g \\, \\left(\\cos q_{2} - 1\\right)",
            "0 &= \\cos q_{2}",
            "\\documentclass",
            "\\item[\\(R\\)]",
            "\\section{First integrals}",
            "\\paragraph{energy T + V}",
        ] {
            assert!(text.contains(needed), "{by}: {needed}\n{text}");
        }
    }
    assert!(text("kane").contains("{}^{A}\\boldsymbol{\\omega}^{C} \\cdot \\mathbf{b}_{1} &= u_{1}"));
    assert!(text("newton-euler").contains("\\begin{bmatrix}") && text("lagrange").contains("\\ddot{q}_{1}"));
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

/// True if a LaTeX with these files is installed; if not, the test is counted as left out.
pub fn has_latex(files: &[&str]) -> bool {
    let found = |file: &str| {
        let run = Command::new("kpsewhich").arg(file).stdout(Stdio::null()).stderr(Stdio::null()).status();
        run.is_ok_and(|status| status.success())
    };
    let why = format!(
        "there is no LaTeX with {} (Debian has it as texlive-latex-base and texlive-pictures)",
        files.join(", ")
    );
    !is_left_out("latex", files.iter().copied().all(found), &why)
}

/// Width in points by which the widest line of a document stands out. The error is TeX's message if it does not
/// compile.
pub fn compiled(folder: &Path, text: &str) -> Result<f64, String> {
    std::fs::write(folder.join("it.tex"), text).unwrap();
    let options = ["-interaction=nonstopmode", "-halt-on-error", "-draftmode", "it.tex"];
    let out = Command::new("pdflatex").args(options).current_dir(folder).stdin(Stdio::null()).output().unwrap();
    let said = String::from_utf8_lossy(&out.stdout).replace('\n', " ");
    if !out.status.success() {
        return Err(said);
    }
    let wide =
        said.split("Overfull \\hbox (").skip(1).filter_map(|rest| rest.split_once("pt too wide")?.0.parse().ok());
    Ok(wide.fold(0.0, f64::max))
}

/// Goal: documents and fragments compile unchanged in a thesis. Method: every model of the library, whole and as part
/// of another document, by pdflatex if there is one. In documents of few bodies no line stands out by more than a
/// letter: 10 points.
#[test]
fn documents_and_fragments_compile() {
    if !has_latex(&["article.cls", "amsmath.sty", "geometry.sty"]) {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for (model, text) in library_as("latex") {
        let wide = compiled(folder.path(), &text).unwrap_or_else(|said| panic!("{model}: {said}"));
        let is_short = ["disk", "gimbals", "furuta", "heavy_top", "four_bar"].contains(&model.as_str());
        assert!(!is_short || wide < 10.0, "{model}: {wide} points too wide");
    }
    let (_, fragment, _) = tripos_in(&root(), &["derive", "models/disk", "--format", "latex", "--fragment"]);
    std::fs::write(folder.path().join("part.tex"), fragment).unwrap();
    let around =
        "\\documentclass{report}\\usepackage{amsmath}\\allowdisplaybreaks\\begin{document}\\input{part}\\end{document}";
    compiled(folder.path(), around).unwrap();
}

/// The names of a model, by the symbols that they are printed as.
struct Names(BTreeMap<String, String>);

impl Names {
    /// The names in formulas of JSON.
    fn of(formulas: &[&str]) -> Self {
        let words = |text: &str| {
            let parts = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).map(str::to_owned);
            parts.filter(|word| word.starts_with(|c: char| c.is_ascii_alphabetic())).collect::<Vec<_>>()
        };
        let all = formulas.iter().flat_map(|text| words(text));
        Self(all.filter_map(|name| Some((read_symbol(&latex_name(&name))?.without_dots(), name))).collect())
    }
}

impl SymbolNames for Names {
    fn knows(&self, symbol: &LatexSymbol) -> bool {
        self.0.contains_key(&symbol.without_dots())
    }

    fn name_of_latex_symbol(&mut self, symbol: &LatexSymbol, _: &str) -> Result<String, Unknown> {
        let name = self.0.get(&symbol.without_dots()).ok_or_else(|| (format!("no {symbol}"), None))?;
        Ok(format!("{name}{}", "'".repeat(symbol.dots)))
    }

    fn name_of_variable(&mut self, name: &str) -> Result<String, Unknown> {
        Ok(name.to_owned())
    }
}

fn read(arena: &mut Arena, names: &mut Names, formula: &str, notation: Notation) -> Expr {
    let plain = translate(formula, notation, names).unwrap_or_else(|e| panic!("{formula}: {e:?}"));
    let read = parse_primed(arena, plain.text(), 2, &mut |arena, name| Ok(arena.symbol(name)));
    read.unwrap_or_else(|e| panic!("{formula}: {e:?}"))
}

/// The right sides of a section, each behind its left side, in the order of the text.
fn rows(text: &str, section: &str) -> Vec<(String, String)> {
    let begin = text.find(section).unwrap_or_else(|| panic!("no {section}"));
    let section = &text[begin + section.len()..];
    let section = &section[..section.find("\\subsection").or(section.find("\\section")).unwrap_or(section.len())];
    let block = section.split("\\begin{align}").skip(1).filter_map(|rest| rest.split("\\end{align}").next());
    let mut list: Vec<(String, String)> = Vec::new();
    // A wide left side stands in a line for itself.
    let mut wide = String::new();
    for line in block.flat_map(|block| block.split("\\\\\n")).map(|line| line.trim_end_matches("\\notag ")) {
        if let Some(left) = line.strip_prefix("& ") {
            left.trim().clone_into(&mut wide);
            continue;
        }
        if let Some(right) = line.trim_start().strip_prefix("&\\quad = ") {
            list.push((wide.clone(), right.to_owned()));
            continue;
        }
        match (line.split_once(" &= "), list.last_mut()) {
            (Some((left, right)), _) => list.push((left.trim().to_owned(), right.to_owned())),
            (None, Some((_, right))) => right.push_str(line.trim_start().trim_start_matches("&\\qquad")),
            _ => {}
        }
    }
    list
}

/// The entries of the matrices of a system: M row by row, the unknowns, and f.
fn matrices(text: &str) -> Vec<String> {
    let blocks = text.split("\\begin{bmatrix}").skip(1).filter_map(|rest| rest.split("\\end{bmatrix}").next());
    let entries = blocks.flat_map(|block| block.split("\\\\\n").flat_map(|row| row.split('&')));
    entries.map(|entry| entry.trim().to_owned()).collect()
}

/// Goal: LaTeX has the equations that programs get. Method: LaTeX read back by the front end of publications, and
/// compared by algebra with `derive --json`: accelerations, energies, M and f, of models with fractions, roots, loops
/// and named terms.
#[test]
fn latex_says_what_json_says() {
    for model in ["disk", "pendulum", "cart_pendulum_3", "heavy_top", "four_bar", "furuta", "governor", "knife_edge"] {
        let path = format!("models/{model}");
        let derived = |format: &str| tripos_in(&root(), &["derive", &path, "--by", "kane", "--format", format]).1;
        let (text, json) = (derived("latex"), serde_json::from_str::<Value>(&derived("json")).unwrap());
        let kane = &json["formulations"][0];
        let strings = |value: &Value| {
            value.as_array().unwrap().iter().map(|x| x.as_str().unwrap().to_owned()).collect::<Vec<_>>()
        };
        let mut expected: Vec<String> = Vec::new();
        let solved = kane["accelerations"].as_array().unwrap();
        let steps: Vec<(String, String)> = solved
            .iter()
            .map(|s| (s["name"].as_str().unwrap().to_owned(), s["value"].as_str().unwrap().to_owned()))
            .collect();
        expected.extend(steps.iter().map(|(_, value)| value.clone()));
        expected.extend(["kinetic_energy", "potential_energy"].map(|key| kane[key].as_str().unwrap().to_owned()));
        let matrix: Vec<String> = kane["mass_matrix"].as_array().unwrap().iter().flat_map(strings).collect();
        let system = [matrix.clone(), strings(&kane["unknowns"]), strings(&kane["forcing"])].concat();
        let mut found: Vec<String> =
            rows(&text, "\\subsection{Accelerations}").into_iter().map(|(_, right)| right).collect();
        assert_eq!(found.len(), steps.len(), "{model}");
        found.extend(
            rows(&text, "\\subsection{Kinetic and potential energy}").into_iter().take(2).map(|(_, right)| right),
        );
        let printed = matrices(&text);
        let listed = rows(&text, "\\subsection{Equations of motion}").into_iter().map(|(_, right)| right);
        match printed.len() {
            // Entries one by one, without zeros.
            0 => expected.extend(matrix.iter().filter(|entry| entry.as_str() != "0").cloned()),
            n if n == matrix.len() => expected.extend(matrix.clone()),
            _ => expected.extend([matrix.clone(), strings(&kane["unknowns"])].concat()),
        }
        expected.extend(strings(&kane["forcing"]));
        found.extend(printed.into_iter().chain(listed));
        assert_eq!(found.len(), expected.len(), "{model}");
        let all: Vec<&str> = expected.iter().chain(&system).map(String::as_str).collect();
        let (mut names, mut arena) = (Names::of(&all), Arena::new());
        for (found, expected) in found.iter().zip(&expected) {
            let [found_term, term] = [(found, Notation::Latex), (expected, Notation::Tripos)]
                .map(|(text, notation)| read(&mut arena, &mut names, text, notation));
            assert!(
                Comparer::default().compare(&mut arena, found_term, term).is_equal(),
                "{model}: {found}\nis not\n{expected}"
            );
        }
    }
}
