//! Files that publications name: programs in MATLAB, Python and C, and LaTeX with macros.

use super::files::checked;
use crate::campaign::{Random, Share, campaign, tried};
use crate::grammar::formula;
use crate::mutation::spoilt;
use crate::seeds::{Seed, files_with, quoted_text};
use tripos_derive::Model;
use tripos_derive::algebra::text::notation::Notation;
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::publication::load_publication_with_files;

/// A program or LaTeX file, with the publication that names it and the model of the publication.
struct NamedFile {
    /// The file.
    file: Seed,
    /// Text of the publication.
    publication: String,
    /// Model of the publication.
    model: Model,
}

/// All files that publications beside them name.
fn named_files() -> Vec<NamedFile> {
    let named = |file: Seed| {
        let publication = std::fs::read_to_string(file.path.with_file_name("publication.toml")).ok()?;
        let model = Model::read(&file.path.with_file_name("model.toml")).ok()?;
        let name = file.path.file_name()?.to_str()?;
        publication.contains(name).then_some(NamedFile { file, publication, model })
    };
    files_with(&["c", "m", "py", "tex"]).into_iter().filter_map(named).collect()
}

/// A random statement of a program, in one of the languages.
fn statement(random: &mut Random) -> String {
    let notation = *random.one(&[Notation::Python, Notation::Matlab, Notation::C, Notation::Latex][..]);
    let value = formula(notation, 3, random);
    match random.below(7) {
        0 => format!("x = {value}\n"),
        1 => format!("x = {value};\n"),
        2 => format!("double y = {value};\n"),
        3 => format!("def f(x):\n    return {value}\n"),
        4 => format!("function y = f(x)\ny = {value};\nend\n"),
        5 => format!("\\begin{{align}}\\label{{a}} x &= {value} \\\\ \\end{{align}}\n"),
        _ => format!("\\newcommand{{\\m}}[2]{{#1 {value} #2}}\n"),
    }
}

#[test]
fn printed_programs_and_latex() {
    let seeds = named_files();
    assert!(seeds.len() > 5, "publications name files");
    campaign("programs and LaTeX files", &Share { short: 800, long: 60_000 }, move |random| {
        let at = random.below(seeds.len());
        let (seed, other) = (&seeds[at], &seeds[random.below(seeds.len())]);
        let other = match random.below(3) {
            0 => other.file.text.clone(),
            1 => quoted_text(random).to_owned(),
            _ => statement(random),
        };
        let text = spoilt(&seed.file.text, &other, random);
        tried(&text);
        let read = |name: &str| -> Result<Source, Diagnostics> { Ok(Source::from_text(name, &text)) };
        let source = Source::from_text("publication.toml", &seed.publication);
        checked(load_publication_with_files(&source, &mut seed.model.clone(), &read))
    });
}
