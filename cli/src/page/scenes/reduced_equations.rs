//! Part of the page about a scene's reduced equations: the kept states, the omitted states, and proofs.

use crate::page::content::{Page, ReducedEquationsContent, SceneSection};
use crate::page::markup::formula_mathml::{
    MathmlSide, aligned_mathml_equations, breakable_mathml, formula, inline_mathml, is_short_formula_mathml, length,
    long_formulas_note, symbol_mathml, zero_formula_mathml,
};
use crate::page::markup::html::{escape, folded_html, number, rounded_number_html, scrolling_box, table};
use crate::page::markup::typeset::typeset;
use std::fmt::Write;
use tripos_codegen::plan::Costs;
use tripos_derive::algebra::text::print::{mathml_of, print_text};
use tripos_derive::algebra::{Arena, Expr, Node};
use tripos_derive::reduce::{Omission, Piece, Prose, ReducedOutput, ReducedQuantity};

/// Returns the HTML about a scene's reduced equations, or about the reason why there are none.
pub fn section(page: &Page, scene: &SceneSection) -> String {
    let needs = match &scene.needs {
        Ok(needs) => needs,
        Err(why) => {
            return format!("<p class=\"missing\">The scene has no equations of its own: {}.</p>\n", escape(why));
        }
    };
    let omitted = &needs.reduced.reduction.omitted;
    let mut out =
        format!("<p class=\"formula\">{}</p>\n{}", reduction_summary(page, needs), kept_quantities_table(needs));
    out += &equations(needs);
    if !is_read(needs) {
        out += &long_formulas_note(&format!("tripos scene {} --json", scene.file));
    }
    out += &folded_html("What it shows, from these", &outputs(needs));
    if !omitted.is_empty() {
        out += &folded_html(
            &format!("What is left out, and why ({})", omitted.len()),
            &omitted_parts_table(needs.reduced.reduction.arena(), omitted),
        );
    }
    out
}

/// Returns the HTML of a summary of the reduced equations: numbers of kept states, quadratures, constants, and
/// operations.
fn reduction_summary(page: &Page, needs: &ReducedEquationsContent) -> String {
    let reduction = &needs.reduced.reduction;
    let states = page.model.coordinates.len() + page.model.speeds.len();
    let count = |n: usize, one: &str| format!("{n} {one}{}", if n == 1 { "" } else { "s" });
    let mut out = format!("Of {} {} are kept", count(states, "state"), reduction.states.len());
    if !reduction.quadratures.is_empty() {
        let _ = write!(out, ", and {}", count(reduction.quadratures.len(), "integral"));
        out += " along them on which no state depends";
    }
    if !reduction.constants.is_empty() {
        let _ = write!(out, "; {} from the start stand for the rest", count(reduction.constants.len(), "constant"));
    }
    out += ".";
    let Costs { full, scene } = &needs.costs;
    let _ = write!(
        out,
        " A call of the derivative takes {} operations instead of {} by Kane's method, with {} instead of {} and {} of sine \
         and cosine instead of {}.",
        scene.operations,
        full.operations,
        count(scene.divisions, "division"),
        full.divisions,
        count(scene.sincos, "pair"),
        full.sincos
    );
    if !reduction.divisors.is_empty() {
        let arena = reduction.arena();
        let zero = |e: &Expr| zero_formula_mathml(arena, reduced_term_without_number(arena, *e));
        let mut places: Vec<String> = reduction.divisors.iter().map(zero).collect();
        places.dedup();
        let _ = write!(out, " Singular where {}.", places.join(" or "));
    }
    out
}

/// True if all formulas of the reduced equations are short enough to be shown.
fn is_read(needs: &ReducedEquationsContent) -> bool {
    let reduction = &needs.reduced.reduction;
    let (arena, e) = (reduction.arena(), &reduction.derivation.equations);
    let values = e.definitions.iter().map(|d| d.value).chain(e.coordinate_rates.iter().copied());
    let values = values.chain(e.matrix.iter().flatten().chain(&e.forcing).copied());
    let mut values = values.chain(reduction.outputs.iter().map(|o| o.value));
    let mut divisors = reduction.divisors.iter().map(|e| reduced_term_without_number(arena, *e));
    values.all(|e| length(arena, e).is_some()) && divisors.all(|e| is_short_formula_mathml(arena, e))
}

/// Returns a term without its numeric factor. Both terms vanish at the same places.
fn reduced_term_without_number(arena: &Arena, e: Expr) -> Expr {
    match arena.node(e) {
        Node::Sum(constant, terms) if constant.is_zero() && terms.len() == 1 => terms[0].0,
        _ => e,
    }
}

/// Returns the HTML table of the kept states, quadratures and constants with their meanings.
fn kept_quantities_table(needs: &ReducedEquationsContent) -> String {
    let reduction = &needs.reduced.reduction;
    let arena = reduction.arena();
    let row = |kind: &str, q: &ReducedQuantity, value: String| {
        vec![kind.to_owned(), inline_mathml(&symbol_mathml(&q.name)), value, prose_html(arena, &q.about)]
    };
    let mut rows: Vec<Vec<String>> = reduction.states.iter().map(|q| row("state", q, String::new())).collect();
    rows.extend(reduction.quadratures.iter().map(|q| row("integral", q, String::new())));
    rows.extend(needs.reduced.constants().map(|(q, x)| row("constant", q, number(&rounded_number_html(x, 10)))));
    table("Kept", &["Kind", "Symbol", "Value", "What it is"], &rows)
}

/// Returns the HTML of the reduced equations: definitions, rates and accelerations, one per line.
fn equations(needs: &ReducedEquationsContent) -> String {
    let e = &needs.reduced.reduction.derivation.equations;
    let mut arena = needs.reduced.reduction.arena().clone();
    let mut list: Vec<(MathmlSide, MathmlSide)> = Vec::new();
    for d in &e.definitions {
        list.push((MathmlSide::of(&arena, d.symbol), MathmlSide::of(&arena, d.value)));
    }
    for (q, rate) in e.coordinates.iter().zip(&e.coordinate_rates) {
        list.push((
            MathmlSide::Whole(symbol_mathml(&format!("{}'", print_text(&arena, *q)))),
            MathmlSide::of(&arena, *rate),
        ));
    }
    for (row, forcing) in e.matrix.iter().zip(&e.forcing) {
        let terms: Vec<Expr> = row.iter().zip(&e.unknowns).map(|(m, x)| arena.mul(*m, *x)).collect();
        let left = arena.sum(&terms);
        list.push((MathmlSide::of(&arena, left), MathmlSide::of(&arena, *forcing)));
    }
    scrolling_box("The scene's reduced equations", &aligned_mathml_equations(&list))
}

/// Returns the HTML of the scene's outputs as functions of the kept states.
fn outputs(needs: &ReducedEquationsContent) -> String {
    let reduction = &needs.reduced.reduction;
    let arena = reduction.arena();
    let line = |o: &ReducedOutput| {
        let name =
            typeset(&o.name).map_or_else(|| symbol_mathml(&o.name), |sides| sides.iter().map(mathml_of).collect());
        // An output that is itself a kept quantity needs no line.
        (name != formula(arena, o.value)).then(|| (MathmlSide::Whole(name), MathmlSide::of(arena, o.value)))
    };
    let list: Vec<_> = reduction.outputs.iter().filter_map(line).collect();
    scrolling_box("What the scene shows", &aligned_mathml_equations(&list))
}

/// Returns the HTML table of the omitted parts, with reasons and proofs.
fn omitted_parts_table(arena: &Arena, omitted: &[Omission]) -> String {
    let row = |o: &Omission| vec![prose_html(arena, &o.what), prose_html(arena, &o.why), escape(&o.proof)];
    table("Left out", &["What", "Why", "How that is known"], &omitted.iter().map(row).collect::<Vec<_>>())
}

/// Returns the HTML of words that contain formulas.
fn prose_html(arena: &Arena, prose: &Prose) -> String {
    let piece = |piece: &Piece| match piece {
        Piece::Words(words) => escape(words),
        Piece::Term(e) => breakable_mathml(&[MathmlSide::of(arena, *e)]),
        Piece::Equation(left, right) => breakable_mathml(&[*left, *right].map(|e| MathmlSide::of(arena, e))),
    };
    prose.0.iter().map(piece).collect()
}
