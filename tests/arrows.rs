//! The arrows of the design: who may know whom.

use std::path::{Path, PathBuf};
use tripos_derive::Formulation;

pub fn sources(folder: &str) -> Vec<(PathBuf, String)> {
    let mut files = Vec::new();
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let text = std::fs::read_to_string(&path).unwrap();
                files.push((path, text));
            }
        }
    }
    assert!(!files.is_empty(), "{folder} has sources");
    files
}

/// No file under `folder` mentions any of `words`.
fn knows_nothing_of(folder: &str, words: &[&str]) {
    for (path, text) in sources(folder) {
        for word in words {
            assert!(!text.contains(word), "{} mentions {word}", path.display());
        }
    }
}

#[test]
fn derive_depends_on_the_traits_alone() {
    knows_nothing_of("derive/src", &["tripos_codegen", "tripos_sim", "tripos_models", "tripos::"]);
}

/// Proofs, and tests for zero, never use rounded numbers, however many digits these have.
#[test]
fn no_verdict_reads_a_double_double() {
    for (path, text) in sources("derive/src") {
        let may =
            ["derive/src/scene", "derive/src/algebra/value/tape.rs", "derive/src/algebra/value/rational_value.rs"];
        let says = text.contains("DoubleDouble") && !may.iter().any(|place| path.to_string_lossy().contains(place));
        assert!(!says, "{} mentions DoubleDouble", path.display());
    }
}

#[test]
fn the_algebra_knows_no_mechanics() {
    knows_nothing_of("derive/src/algebra", &["crate::model", "crate::mechanics", "crate::scene"]);
}

#[test]
fn formulations_never_import_one_another() {
    let files = Formulation::ALL.map(|formulation| formulation.name().replace('-', "_"));
    for own in &files {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("derive/src/mechanics/formulations/{own}.rs"));
        let text = std::fs::read_to_string(path).unwrap();
        for other in files.iter().filter(|other| *other != own) {
            assert!(!text.contains(&format!("super::{other}")), "{own} imports {other}");
        }
    }
}

/// Properties of a formulation stand in its row of the table alone: no code asks which formulation it has.
#[test]
fn nobody_asks_which_formulation_it_is() {
    for folder in ["derive/src", "codegen/src", "run/src", "cli/src"] {
        for (path, text) in sources(folder) {
            for line in text.lines() {
                let after = line.split_once("Formulation::").map_or("", |(_, after)| after);
                let is_arm = after.trim_start_matches(char::is_alphanumeric).trim_start().starts_with("=>");
                let is_compared = line.contains("== Formulation::") || line.contains("!= Formulation::");
                assert!(!is_arm && !is_compared, "{}: {}", path.display(), line.trim());
            }
        }
    }
}

#[test]
fn generated_code_knows_only_the_traits() {
    knows_nothing_of("generated/src", &["tripos_derive", "tripos_codegen", "tripos_sim::", "nalgebra", "std::"]);
}

#[test]
fn sim_knows_neither_models_nor_derivation() {
    knows_nothing_of("sim/src", &["tripos_derive", "tripos_codegen", "tripos_models", "tripos::", "model.toml"]);
    knows_nothing_of("sim/traits/src", &["tripos_derive", "tripos_codegen", "tripos_sim", "std::"]);
}

#[test]
fn the_library_knows_neither_generated_code_nor_the_command() {
    let command =
        ["tripos_models", "tripos_cli", "clap", "indicatif", "plotters", "println!", "eprintln!", "process::exit"];
    for (path, text) in sources("run/src") {
        let code: String = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
        for word in command {
            assert!(!code.contains(word), "{} mentions {word}", path.display());
        }
    }
}

/// A robot description becomes the text of a model file; what the text means is the concern of others.
#[test]
fn robot_descriptions_know_only_diagnostics() {
    let others =
        ["tripos_codegen", "tripos_sim", "tripos_models", "tripos::", "tripos_derive::model", "tripos_derive::algebra"];
    knows_nothing_of("robots/src", &others);
}

#[test]
fn codegen_knows_only_derive() {
    knows_nothing_of("codegen/src", &["tripos_sim", "tripos_models", "tripos::"]);
}

/// A plan is for any target, and the library that runs scenes needs none: what writes Rust is the command's alone.
#[test]
fn plans_know_no_language() {
    for folder in ["codegen/src/plan", "codegen/src/taylor"] {
        knows_nothing_of(
            folder,
            &["crate::rust", "crate::js", "proc_macro2", "quote::", "quote!", "syn::", "TokenStream", "prettyplease"],
        );
    }
}

/// Packages that the library `tripos` stands on, with these features.
fn packages_of_the_library(features: &[&str]) -> Vec<String> {
    let arguments = ["tree", "--package", "tripos", "--edges", "normal", "--prefix", "none", "--offline"];
    let tree = std::process::Command::new(env!("CARGO")).args(arguments).args(features).output().unwrap();
    let tree = String::from_utf8(tree.stdout).unwrap();
    let packages: Vec<String> = tree.lines().filter_map(|line| line.split(' ').next()).map(str::to_owned).collect();
    assert!(packages.iter().any(|package| package == "tripos-codegen"), "{tree}");
    packages
}

/// Only the command depends on the writer of Rust. Files, threads and a clock, which a browser has not, are behind
/// features.
#[test]
fn the_library_needs_no_target_and_can_do_without_threads_and_files() {
    let target = ["prettyplease", "quote", "syn", "proc-macro2", "tempfile", "clap"];
    for (features, absent) in [(&[][..], &[][..]), (&["--no-default-features"], &["rayon"])] {
        let packages = packages_of_the_library(features);
        for package in target.iter().chain(absent) {
            assert!(!packages.iter().any(|p| p == package), "tripos {features:?} depends on {package}");
        }
    }
    let gated = [
        ("run/src/studies/work_precision_chart.rs", "clock"),
        ("run/src/studies/sweep/ordered_work.rs", "threads"),
        ("run/src/state_arrays/threads.rs", "threads"),
        ("derive/src/diagnostic.rs", "files"),
        ("derive/src/publication/publication_of_model.rs", "files"),
        ("derive/src/publication/names/author_files.rs", "files"),
    ];
    for folder in ["run/src", "derive/src"] {
        for (path, text) in sources(folder) {
            let code: String = text.lines().take_while(|line| !line.contains("#[cfg(test)]")).collect();
            let platform = ["std::fs", "std::thread", "Instant::now", "rayon", "std::env", "std::process"];
            let is_gated = gated.iter().any(|(file, _)| path.ends_with(file));
            let used = platform.iter().find(|word| code.contains(**word));
            assert!(is_gated || used.is_none(), "{}: {used:?} behind no feature", path.display());
        }
    }
}

/// Files that take text apart, with the reason why that is no decision by a printed name: the text is a file, an
/// argument or a path; or the code sets letters, signs and digits.
const READS_TEXT: [(&str, &[&str]); 3] = [
    (
        "files and arguments",
        &[
            "derive/src/algebra/text/notation/calls.rs",
            "derive/src/algebra/text/notation/kind.rs",
            "derive/src/algebra/text/notation/latex/formula.rs",
            "derive/src/algebra/text/notation/latex/function.rs",
            "derive/src/algebra/text/notation/latex/tokens.rs",
            "derive/src/algebra/text/notation/latex/cursor.rs",
            "derive/src/algebra/text/notation/function_names.rs",
            "derive/src/algebra/text/notation/program.rs",
            "derive/src/algebra/text/notation/program_derivatives.rs",
            "derive/src/algebra/text/parse.rs",
            "derive/src/algebra/term/rational/text.rs",
            "derive/src/algebra/text/parse/calls.rs",
            "derive/src/algebra/text/parse/quantity_cursor.rs",
            "derive/src/algebra/text/parse/error.rs",
            "derive/src/algebra/text/parse/interaction.rs",
            "derive/src/algebra/text/parse/velocity.rs",
            "derive/src/algebra/term/rational.rs",
            "derive/src/diagnostic.rs",
            "cli/src/page/print/entry_name.rs",
            "cli/src/arguments/excite_options.rs",
            "cli/src/arguments/fit_options.rs",
            "derive/src/publication/systems/row_text.rs",
            "derive/src/diff/printed/listings.rs",
            "derive/src/mechanics/equations_origin.rs",
            "derive/src/mechanics/solutions/quantities/parse_quantity.rs",
            "derive/src/model/reading/domain.rs",
            "derive/src/model/reading/number_parameters.rs",
            "derive/src/model/reading/notation.rs",
            "derive/src/model/reactions/interactions.rs",
            "derive/src/model/bodies/joints.rs",
            "derive/src/model/reading/loading.rs",
            "derive/src/model/bodies/loads.rs",
            "derive/src/model/reading/declared_names.rs",
            "derive/src/model/read_model.rs",
            "derive/src/model/reading/repetition.rs",
            "derive/src/model/bodies/shapes.rs",
            "derive/src/model/constraints/speeds.rs",
            "derive/src/model/units.rs",
            "derive/src/toml_reader.rs",
            "derive/src/publication/entries.rs",
            "derive/src/publication/printed/equalities.rs",
            "derive/src/publication/printed/printed_matrix.rs",
            "derive/src/publication/publication_of_model.rs",
            "derive/src/publication/names/author_files.rs",
            "derive/src/publication/programs/assignments.rs",
            "derive/src/publication/programs/array_formulas.rs",
            "derive/src/publication/programs/array_functions.rs",
            "derive/src/publication/programs/indices.rs",
            "derive/src/publication/names/program_variables.rs",
            "derive/src/publication/labelled_equations.rs",
            "derive/src/publication/named_files.rs",
            "derive/src/publication/own_coordinates.rs",
            "derive/src/publication/printed/displayed_equations.rs",
            "derive/src/publication/printed/latex_macros.rs",
            "derive/src/publication/printed/program_statements.rs",
            "derive/src/publication/printed/traced_text.rs",
            "cli/src/commands/grade.rs",
            "derive/src/publication/names/name_spelling.rs",
            "derive/src/publication/names/name_meanings.rs",
            "derive/src/scene/families/sweep_grid.rs",
            "derive/src/scene/motions/prescribed_motion.rs",
            "derive/src/scene/settings/claims.rs",
            "derive/src/scene/settings/outputs.rs",
            "derive/src/scene/starts/state.rs",
            "derive/src/scene/numbers/number_reader.rs",
            "run/src/studies/sweep/shard.rs",
            "cli/src/commands/diff.rs",
            "cli/src/commands/emit.rs",
            "cli/src/commands/fmu.rs",
            "cli/src/commands/equilibria/equilibria_figure.rs",
            "cli/src/commands/equilibria/range.rs",
            "cli/src/commands/plot.rs",
            "cli/src/commands/regenerate/python.rs",
            "cli/src/lib.rs",
            "cli/src/sweep/kept_rows.rs",
            "cli/src/page/print/errata.rs",
            "cli/src/page/markup/typeset.rs",
        ],
    ),
    (
        "paths",
        &[
            "codegen/src/optional_functions.rs",
            "codegen/src/emit.rs",
            "codegen/src/draft_file.rs",
            "codegen/src/origin.rs",
            "codegen/src/model_folders.rs",
            "codegen/src/generated_workspace.rs",
            "codegen/src/rust/scene.rs",
            "cli/src/commands/new.rs",
            "cli/src/commands/regenerate.rs",
            "cli/src/commands/page.rs",
            "cli/src/commands/page/run_figures.rs",
            "cli/src/commands/simulate.rs",
            "cli/src/commands/sketch.rs",
            "cli/src/files/scene_file.rs",
            "cli/src/files/workspace.rs",
        ],
    ),
    (
        "letters, signs and digits",
        &[
            "derive/src/algebra/text/print.rs",
            "derive/src/algebra/text/print/printed_names.rs",
            "derive/src/algebra/text/print/python.rs",
            "derive/src/algebra/form/sharing/rebuild.rs",
            "derive/src/algebra/text/display_tree.rs",
            "derive/src/publication/systems/printed_system.rs",
            "codegen/src/plan/programs/cost.rs",
            "codegen/src/plan/programs/variable_names.rs",
            "codegen/src/plan/programs/program.rs",
            "codegen/src/js/javascript_strings.rs",
            "codegen/src/languages/c/names.rs",
            "codegen/src/languages/matlab/names.rs",
            "codegen/src/languages/module_contents.rs",
            "codegen/src/languages/python/names.rs",
            "codegen/src/languages/python/text.rs",
            "codegen/src/rust/expression.rs",
            "codegen/src/rust/rust_text.rs",
            "codegen/src/syntax/formula.rs",
            "codegen/src/plan/taylor_plan.rs",
            "cli/src/commands/derive/derivation_document.rs",
            "cli/src/commands/derive/markdown.rs",
            "cli/src/commands/derive/sympy.rs",
            "cli/src/commands/derive/typst.rs",
            "cli/src/commands/diff/models.rs",
            "cli/src/commands/identify.rs",
            "cli/src/commands/linearise/notations.rs",
            "cli/src/commands/simulate/rigorous.rs",
            "cli/src/commands/simulate/sensitivity.rs",
            "cli/src/run_panels.rs",
            "cli/src/page/markup/html.rs",
            "cli/src/page/markup/formula_mathml.rs",
            "cli/src/page/scenes/scene.rs",
            "cli/src/plot.rs",
            "cli/src/plot/axis.rs",
        ],
    ),
];

/// Integrals, quantities, stops, formulations and sets of equations are told apart by values: text is made from them,
/// never the other way.
#[test]
fn nothing_is_decided_by_printed_text() {
    let marks = [
        "starts_with(",
        "ends_with(",
        "strip_prefix(",
        "strip_suffix(",
        "split_once(",
        ".contains(\"",
        "== \"",
        "!= \"",
    ];
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let allowed: Vec<PathBuf> =
        READS_TEXT.iter().flat_map(|(_, files)| files.iter()).map(|file| root.join(file)).collect();
    for folder in ["derive/src", "codegen/src", "run/src", "cli/src", "sim/src"] {
        for (path, text) in sources(folder) {
            if allowed.contains(&path)
                || path.file_name().is_some_and(|name| name.to_string_lossy().ends_with("tests.rs"))
            {
                continue;
            }
            // Tests stand at the end of a file.
            let code = text
                .lines()
                .take_while(|line| !line.starts_with("#[cfg(test)]") && !line.starts_with("#[cfg(all(test"));
            for line in code.filter(|line| !line.trim_start().starts_with("//")) {
                assert!(!marks.iter().any(|mark| line.contains(mark)), "{}: {}", path.display(), line.trim());
            }
        }
    }
}
