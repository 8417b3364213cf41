//! Section of the page about proofs: equivalence of the formulations, first integrals, and singular matrices.

use crate::page::content::Page;
use crate::page::markup::formula_mathml::{
    MathmlSide, breakable_mathml, formula_mathml_in_sentence, inline_mathml, is_short_formula_mathml, length,
    long_formulas_note, number_mathml, symbol_mathml, zero_formula_mathml,
};
use crate::page::markup::html::{escape, foldable_part, join_html, table, table_head, words_html};
use crate::page::model::derivation::named_terms;
use std::fmt::Write;
use tripos_derive::algebra::meaning::compare::{Verdict, Witness};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::prove::{DeterminantAtZero, EquivalentPair, Integral, IntegralKind, Singularity};
use tripos_derive::{Formulation, Model};

/// Returns the HTML section about proofs.
pub fn section(page: &Page) -> String {
    let (model, study) = (page.model, page.study);
    let arena = &study.derivations.kinematics.arena;
    let proof = &study.proof;
    let mut out = String::from(
        "<section id=\"proof\">\n<h2>Proof</h2>\n<p>Every statement here is an identity between expressions, decided by exact \
         arithmetic; nothing is sampled in floating point.</p>\n",
    );
    out += "<h3 id=\"equality\">The derivations say the same</h3>\n";
    if !proof.pairs.is_empty() {
        let rows: Vec<_> = proof.pairs.iter().map(compared_pair_row).collect();
        out += &table("Formulations, pair by pair", &["Pair", "Verdict", "How one follows from the other"], &rows);
    }
    for (formulation, why) in &proof.missing {
        let _ = writeln!(out, "<p>{}: not derived: {}.</p>", escape(formulation.title()), escape(&why.to_string()));
    }
    if proof.singular_where.is_empty() {
        out += "<p>Valid everywhere: neither the kinematic equations nor loads divide by what may be 0.</p>\n";
    } else {
        let is_of_load = |e: &Expr| proof.loads.iter().any(|load| load.value == *e);
        let speeds: Vec<_> =
            proof.singular_where.iter().filter(|e| !is_of_load(e)).map(|e| zero_formula_mathml(arena, *e)).collect();
        let loads = proof.loads.iter().map(|load| {
            format!("{} ({})", zero_formula_mathml(arena, load.value), words_html(&load.zero_divisor_meaning()))
        });
        let loads: Vec<_> = loads.collect();
        let rates = (speeds, "there the generalized speeds do not determine the rates of the coordinates");
        for (list, why) in [rates, (loads, "there loads have no value")] {
            if !list.is_empty() {
                let _ = writeln!(out, "<p class=\"formula\">Valid except where {}: {why}.</p>", list.join(" or "));
            }
        }
    }
    if !proof.reactions.is_empty() {
        let values = join_html(&proof.reactions, |reaction| {
            format!(
                "<div>{}</div>\n",
                breakable_mathml(&[
                    MathmlSide::Whole(symbol_mathml(&reaction.name)),
                    MathmlSide::of(arena, reaction.value)
                ])
            )
        });
        let values = format!(
            "<p>From the equations that Kane's method leaves over.</p>\n<div class=\"formula\">\n{values}</div>\n"
        );
        out += &foldable_part("reactions", "Reactions", &values);
    }
    out += &integrals(model, arena, &proof.integrals, &proof.search.text(arena));
    out += &proved_determinants_table(arena, &study.singular);
    let reactions = proof.reactions.iter().map(|reaction| reaction.value);
    let mut values = reactions.chain(proof.integrals.iter().map(|integral| integral.expression));
    let divisors = proof.integrals.iter().flat_map(|integral| integral.divisors(arena));
    let mut divisors = divisors.chain(proof.singular_where.iter().copied());
    let shown = proof_section_formulas(page);
    out += &named_terms(arena, &shown);
    if values.any(|e| length(arena, e).is_none()) || divisors.any(|e| !is_short_formula_mathml(arena, e)) {
        out += &long_formulas_note(&format!("tripos prove {} --json", page.file));
    }
    out + "</section>\n"
}

/// Lists every formula in the section about proofs, so that the names in them can be defined.
fn proof_section_formulas(page: &Page) -> Vec<Expr> {
    let (proof, arena) = (&page.study.proof, &page.study.derivations.kinematics.arena);
    let reactions = proof.reactions.iter().map(|reaction| reaction.value);
    let integrals = proof.integrals.iter().flat_map(|integral| integral.shown_formulas_of_integral(arena));
    let singular = page.study.singular.iter();
    let singular =
        singular.flat_map(|(_, s)| [s.determinant].into_iter().chain(s.at.iter().map(|place| place.divisor)));
    let all = reactions.chain(integrals).chain(proof.search.power).chain(proof.singular_where.iter().copied());
    all.chain(singular).collect()
}

/// Returns the HTML of the first integrals: a list of names with verdicts, and formulas that can be unfolded.
fn integrals(model: &Model, arena: &Arena, list: &[Integral], search: &str) -> String {
    let mut out = String::from("<h3 id=\"integrals\">First integrals</h3>\n");
    out += if list.is_empty() { "<p>None found.</p>\n" } else { "<p>Constant along every motion.</p>\n" };
    let search = format!("<p class=\"quiet\">Search: {}.</p>\n", proof_text_html(search));
    if list.is_empty() {
        return out + &search;
    }
    let name = |(at, integral): (usize, &Integral)| {
        let (name, symbol) = (proved_integral_name(model, arena, integral), inline_mathml(&proved_integral_symbol(at)));
        format!("<li>{symbol}: {name}, {}</li>\n", proof_verdict_html(&integral.verdict))
    };
    let names: String = list.iter().enumerate().map(name).collect();
    let formulas: String =
        list.iter().enumerate().map(|(at, integral)| proved_integral_html(model, arena, at, integral)).collect();
    let _ = writeln!(out, "<ul class=\"plain\">\n{names}</ul>");
    out + &foldable_part("integral-formulas", "As formulas", &(formulas + &search))
}

/// Returns the table cells for the comparison of a pair of formulations.
fn compared_pair_row(pair: &EquivalentPair) -> Vec<String> {
    let (left, right) = (escape(pair.left.title()), escape(pair.right.title()));
    vec![format!("{left} ⇔ {right}"), proof_verdict_html(&pair.verdict), proof_text_html(&pair.map.text())]
}

/// Returns the HTML of a verdict in words: the method of proof, a state in which the sides differ, or the reason why
/// there is no decision.
fn proof_verdict_html(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Equal(engine) => format!("proved <span class=\"quiet\">({})</span>", escape(&engine.to_string())),
        Verdict::Different(found) => {
            format!("<strong class=\"wrong\">different</strong>: {}", proof_witness_html(found, ["left", "right"]))
        }
        Verdict::Undecided(why) => format!("<strong class=\"wrong\">undecided</strong>: {}", escape(why)),
    }
}

/// Returns the HTML of a witness: the state in which two values differ, and the values with the labels `left` and
/// `right`.
pub fn proof_witness_html(witness: &Witness, [left, right]: [&str; 2]) -> String {
    let last = witness.at.len().saturating_sub(1);
    let at = witness.at.iter().enumerate().map(|(at, (name, x))| {
        let comma = if at < last { "," } else { "" };
        format!(
            "<span class=\"keep\">{}{comma}</span>",
            inline_mathml(&format!("{}<mo>=</mo>{}", symbol_mathml(name), number_mathml(*x)))
        )
    });
    let at: Vec<String> = at.collect();
    let place = if at.is_empty() { String::new() } else { format!(" at {}", at.join(" ")) };
    let value = |x: f64| inline_mathml(&number_mathml(x));
    format!("{left} {}, {right} {}{place}", value(witness.left), value(witness.right))
}

/// Returns the HTML of a plain text, in which rates such as q' become q̇.
fn proof_text_html(text: &str) -> String {
    escape(text).replace("q'", "q̇")
}

/// Returns the HTML of one first integral: name, verdict, formula and exceptions. `at` counts from
/// 0.
fn proved_integral_html(model: &Model, arena: &Arena, at: usize, integral: &Integral) -> String {
    let verdict = proof_verdict_html(&integral.verdict);
    let divisors = integral.divisors(arena);
    let places: Vec<String> = divisors.iter().map(|e| zero_formula_mathml(arena, *e)).collect();
    let places = if places.is_empty() {
        String::new()
    } else {
        format!("<p class=\"formula\">Except where {}.</p>\n", places.join(", "))
    };
    format!(
        "<h4>{}: {}, {verdict}</h4>\n<div class=\"formula\">{}</div>\n{places}",
        inline_mathml(&proved_integral_symbol(at)),
        proved_integral_name(model, arena, integral),
        breakable_mathml(&[MathmlSide::Whole(proved_integral_symbol(at)), MathmlSide::of(arena, integral.expression)])
    )
}

/// Returns the MathML symbol of a first integral, I with its number. The index `at` counts from 0, the number from 1.
pub fn proved_integral_symbol(at: usize) -> String {
    format!("<msub><mi>I</mi><mn>{}</mn></msub>", at + 1)
}

/// Returns the HTML of all names of a first integral. The momentum of a coordinate is defined by a
/// formula.
pub fn proved_integral_name(model: &Model, arena: &Arena, integral: &Integral) -> String {
    let kinds = integral.kinds.iter().zip(&integral.of_places).zip(integral.names(model, arena));
    let names = kinds.map(|((kind, of_place), words)| match kind {
        IntegralKind::Coordinate(at) if *of_place == Expr::ZERO => {
            format!("momentum {}", inline_mathml(&proved_momentum_mathml(&model.coordinates[*at].name)))
        }
        _ => escape(&words),
    });
    names.collect::<Vec<_>>().join("; ")
}

/// Returns the MathML of the momentum p_q = ∂L/∂q̇ of a coordinate.
fn proved_momentum_mathml(coordinate: &str) -> String {
    format!(
        "<mrow><msub><mi>p</mi><mrow>{}</mrow></msub><mo>=</mo><mfrac><mrow><mo form=\"prefix\">∂</mo><mi>L</mi></mrow><mrow>\
         <mo form=\"prefix\">∂</mo>{}</mrow></mfrac></mrow>",
        symbol_mathml(coordinate),
        symbol_mathml(&format!("{coordinate}'")),
    )
}

/// Returns the HTML table of the determinants of the matrices and their zeros; empty for an empty
/// list.
fn proved_determinants_table(arena: &Arena, list: &[(Formulation, Singularity)]) -> String {
    if list.is_empty() {
        return String::new();
    }
    let row = |(formulation, s): &(Formulation, Singularity)| {
        format!(
            "<tr><th scope=\"row\">{}</th><td><div class=\"formula\">{}</div></td><td>{}</td></tr>\n",
            escape(formulation.title()),
            formula_mathml_in_sentence(arena, s.determinant),
            proved_determinant_zeros(arena, s)
        )
    };
    format!(
        "<h3 id=\"singular\">Where the matrices are singular</h3>\n<p>A place where the matrix of the accelerations is singular is one thing, \
         a place where the kinematic equations divide by zero another.</p>\n<table class=\"effects\">\n<caption>Determinants, as \
         formulas</caption>\n<colgroup><col class=\"name\"><col><col class=\"name\"></colgroup>\n{}<tbody>\n{}</tbody>\n</table>\n",
        table_head(&["Equations", "Determinant", "Where it is zero"]),
        join_html(list, row)
    )
}

/// Returns the HTML of proved statements about the places where a determinant is zero, and where entries of its matrix
/// divide by zero.
pub fn proved_determinant_zeros(arena: &Arena, singularity: &Singularity) -> String {
    if singularity.determinant == Expr::ZERO {
        return "everywhere".to_owned();
    }
    let mut statements = Vec::new();
    if singularity.never {
        statements.push("nowhere".to_owned());
    }
    for place in &singularity.at {
        let (divisor, vanishing) =
            (formula_mathml_in_sentence(arena, place.divisor), zero_formula_mathml(arena, place.divisor));
        match place.determinant {
            DeterminantAtZero::Zero => statements.push(format!("wherever {vanishing}")),
            DeterminantAtZero::NotZero if !singularity.never => statements.push(format!("not where {vanishing}")),
            DeterminantAtZero::NotZero | DeterminantAtZero::Open => {}
        }
        if place.entries_divide {
            statements.push(format!("entries of the matrix divide by {divisor}"));
        }
    }
    if statements.is_empty() { "nothing is proved".to_owned() } else { statements.join("; ") }
}
