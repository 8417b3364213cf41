//! Mistakes in abbreviations are named once, in the abbreviation's own formula, whatever uses it.

use super::{judge, judge_loaded};
use std::path::{Path, PathBuf};
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::Difference;
use tripos_derive::publication;

/// A publication of the shelf, judged.
fn shelf(name: &str) -> Difference {
    let publication = model_folder(name).join("publication.toml");
    slipped(name, &publication, "title", "title")
}

/// A publication on a model of the shelf with a piece replaced, judged.
fn slipped(name: &str, publication: &Path, old: &str, new: &str) -> Difference {
    let model = Model::read(&model_folder(name).join("model.toml")).unwrap();
    let text = Source::read(publication).unwrap().text;
    assert!(text.contains(old), "{name} has no `{old}`");
    judge(model, &Source::from_text("publication.toml", &text.replacen(old, new, 1)))
}

fn model_folder(name: &str) -> PathBuf {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../publications")).join(name)
}

/// The mistake of each root.
fn mistakes(difference: &Difference) -> Vec<&str> {
    difference.roots.iter().map(|root| root.mistake.as_str()).collect()
}

/// Method: single slips in the abbreviations of a right program, each of which two or more statements use, some of them
/// in products and quotients.
#[test]
fn a_slip_in_an_abbreviation_is_one_root() {
    for (old, new, name) in [
        ("2 * l1 * lc2 * np.cos(theta2)) + I1", "l1 * lc2 * np.cos(theta2)) + I1", "d1"),
        ("+ I1 + I2", "+ I1 - I2", "d1"),
        ("m2 * (lc2 ** 2 + l1 * lc2", "m2 * (lc2 ** 2 - l1 * lc2", "d2"),
        ("np.cos(theta2)) + I2", "np.cos(theta2)) + I1", "d2"),
        ("np.cos(theta1 + theta2", "np.cos(theta1 - theta2", "phi2"),
        ("- 2 * m2 * l1", "- m2 * l1", "phi1"),
        ("dtheta2 ** 2 * np.sin", "dtheta1 ** 2 * np.sin", "phi1"),
        ("lc2 * dtheta1 ** 2 * np.sin(theta2) - phi2", "lc2 * dtheta1 ** 2 * np.cos(theta2) - phi2", "ddtheta2"),
        ("(a + d2 / d1", "(a - d2 / d1", "ddtheta2"),
    ] {
        let publication = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/publications/acrobot_book.toml");
        let difference = slipped("acrobot_book", &publication, old, new);
        assert_eq!(difference.count("different"), 2, "{new}");
        let found = mistakes(&difference);
        assert!(found.len() == 1 && found[0].starts_with(&format!("in {name}, ")), "{new}: {found:?}");
    }
}

/// Method: the same slips in the program file that the publication of the shelf names, whose variables are not declared
/// as abbreviations.
#[test]
fn a_slip_in_a_variable_of_a_program_is_one_root() {
    let shelf = model_folder("acrobot_book");
    let source = Source::read(&shelf.join("publication.toml")).unwrap();
    let program = std::fs::read_to_string(shelf.join("dsdt.py")).unwrap();
    for (old, new, name) in [
        ("2 * l1 * lc2 * cos(theta2)) + I1", "l1 * lc2 * cos(theta2)) + I1", "d1"),
        ("m2 * (lc2 ** 2 + l1 * lc2", "m2 * (lc2 ** 2 - l1 * lc2", "d2"),
        ("cos(theta1 + theta2", "cos(theta1 - theta2", "phi2"),
        ("- 2 * m2 * l1", "- m2 * l1", "phi1"),
    ] {
        assert!(program.contains(old), "the program has no `{old}`");
        let slipped = program.replacen(old, new, 1);
        let mut model = Model::read(&shelf.join("model.toml")).unwrap();
        let read = |name: &str| Ok(Source::from_text(name, &slipped));
        let publication =
            publication::load_publication_with_files(&source, &mut model, &read).unwrap_or_else(|e| panic!("{e}"));
        let difference = judge_loaded(&model, &publication);
        let found = mistakes(&difference);
        assert!(found.len() == 1 && found[0].starts_with(&format!("in {name}, ")), "{new}: {found:?}");
    }
}

/// Truth: the README of each publication, by hand.
#[test]
fn abbreviations_of_published_programs_have_their_mistakes() {
    let acrobot = shelf("acrobot_sutton");
    let found = mistakes(&acrobot);
    assert_eq!(found.len(), 1, "{found:?}");
    let numerator = "in ddtheta2, in phi2 - d2*phi1/d1 - tau, the term ";
    assert_eq!(found[0], format!("{numerator}m2*l1*lc2*theta1'^2*sin(theta2) is missing"));
    let cart = shelf("cart_pole_pufferlib");
    let found = mistakes(&cart);
    assert_eq!(found.len(), 2, "{found:?}");
    assert_eq!(found[0], "in polemass_length, total_mass + m_p should be m_p*l");
}
