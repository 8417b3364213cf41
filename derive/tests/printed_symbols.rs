//! Symbols that documents show for names of a model, and what is said about wrong ones.

use crate::common;

use common::{edited, errors, place, read};
use tripos_derive::algebra::text::notation::read_symbol;
use tripos_derive::algebra::text::print::{latex, latex_name, mathml_name, name_parts, print_text, typst_name};
use tripos_derive::model::text_hash;

/// Goal: subscripts look as authors write them. Method: Greek letters, with and without an index, words and indices, in
/// each language.
#[test]
fn subscripts_are_greek_letters_words_or_indices() {
    for (name, in_latex, in_typst, in_mathml) in [
        ("u_psi", "u_{\\psi}", "u_psi", "<msub><mi>u</mi><mi>ψ</mi></msub>"),
        ("u_theta12'", "\\dot{u}_{\\theta_{12}}", "dot(u)_(theta_12)", "<msub><mi>θ</mi><mn>12</mn></msub></msub>"),
        ("q_track", "q_{\\mathrm{track}}", "q_\"track\"", "<msub><mi>q</mi><mi>track</mi></msub>"),
        ("Xi", "\\Xi", "Xi", "<mi>Ξ</mi>"),
        ("Phi_1", "\\Phi_{1}", "Phi_1", "<msub><mi>Φ</mi><mn>1</mn></msub>"),
        ("I_xx", "I_{xx}", "I_\"xx\"", "<msub><mi>I</mi><mi>xx</mi></msub>"),
        ("q123", "q_{123}", "q_123", "<msub><mi>q</mi><mn>123</mn></msub>"),
    ] {
        assert_eq!(latex_name(name), in_latex);
        assert_eq!(typst_name(name), in_typst);
        assert!(mathml_name(name).ends_with(in_mathml), "{}", mathml_name(name));
        assert!(read_symbol(&latex_name(name)).is_some(), "{name} is read back");
    }
    assert_eq!(name_parts("u_theta12'"), ("u".to_owned(), "θ12".to_owned(), 1));
}

const NOTATION: &str = "[notation]\nu2 = \"q'\"\nI = \"J_s\"\nq = \"theta\"\nlength = \"l\"\nA = \"rod\"\n";

/// Goal: documents show the stated symbols, with the dots of rates; text and equations do not change. Method: a rate of
/// a speed in each language, and hashes of the text.
#[test]
fn stated_symbols_are_shown_in_documents_alone() {
    let notation = NOTATION.replace("u2 = \"q'\"", "u2 = \"omega_2\"");
    let model = read(&edited(&[], &notation)).unwrap();
    let mut arena = model.arena.clone();
    let [length, inertia, rate] = ["length", "I", "u2'"].map(|name| arena.symbol(name));
    let square = arena.square(length);
    let product = arena.product(&[square, inertia, rate]);
    assert_eq!(latex(&arena, product), "l^{2} \\, J_{s} \\, \\dot{\\omega}_{2}");
    assert_eq!(print_text(&arena, product), "length^2*I*u2'");
    assert_eq!(model.text_hash(), text_hash(common::BASE), "compiled equations go on running");
}

/// Goal: a speed may look like the rate that it is, and like nothing else. Method: both, in the same model.
#[test]
fn a_speed_may_look_like_the_rate_that_it_is() {
    let model = read(&edited(&[], "[notation]\nu2 = \"q'\"\n")).unwrap();
    let speed = model.speeds[1].symbol;
    assert_eq!(latex(&model.arena, speed), "\\dot{q}");
    let found = errors(&edited(&[], "[notation]\nu2 = \"x'\"\n"));
    assert!(found.to_string().contains("`u2` and `x` would both be shown as `x'`"), "{found}");
    // The coordinate may have another symbol itself.
    let model = read(&edited(&[], "[notation]\nq = \"phi\"\nu2 = \"phi'\"\n")).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(latex(&model.arena, model.speeds[1].rate), "\\ddot{\\phi}");
    let found = errors(&edited(&[("u2 = \"q'\"", "u2 = \"2*q'\"")], "[notation]\nu2 = \"q'\"\n"));
    assert!(found.to_string().contains("`u2` and `q` would both be shown as `q'`"), "{found}");
}

/// Goal: each wrong entry has one message at its place, and help. Method: (entry, where, message, help).
#[test]
fn wrong_symbols_are_told_at_their_place() {
    for (entry, at, message, help) in [
        ("lenght = \"l\"", "lenght", "no symbol is named `lenght`", "did you mean `length`?"),
        ("m = \"m o\"", "m o", "`m o` is no symbol", "write a letter or the name of a Greek letter"),
        ("m = \"\\\\alpha\"", "\"\\\\alpha", "`\\alpha` is no symbol", "write a letter"),
        ("m = \"m_\"", "m_", "`m_` is no symbol", "write a letter"),
        ("m = \"m'''\"", "m'''", "`m'''` is no symbol", "write a letter"),
        ("m = \"g\"", "g\"", "`m` and `g` would both be shown as `g`", "a symbol of its own"),
        ("A = \"N\"", "N\"", "`A` and `N` would both be shown as `N`", "a symbol of its own"),
        ("P = \"c\"", "c\"", "`P` and `C` would both be shown as `c`", "a symbol of its own"),
        ("A = \"B'\"", "B'", "`B'` is no symbol", "write a letter"),
        ("m = \"V\"", "V\"", "documents write `V` for something else", "T and V are energies"),
        ("m = \"M_12\"", "M_12", "documents write `M_12` for something else", "entries of equations"),
        ("m = 7", "7", "the symbol of `m` must be a string", ""),
    ] {
        let text = edited(&[], &format!("[notation]\n{entry}\n"));
        let found = errors(&text);
        let [only] = found.list.as_slice() else { panic!("{entry}: {found}") };
        assert!(only.message.contains(message), "{entry}: {found}");
        assert!(only.help.as_deref().unwrap_or_default().contains(help), "{entry}: {found}");
        let start = text.rfind("[notation]").unwrap();
        let wanted = text[start..].find(at).map(|found| place(&text, start + found));
        assert_eq!(only.span.as_ref().map(|span| place(&text, span.start)), wanted, "{entry}");
    }
}
