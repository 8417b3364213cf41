//! Judgement of printed numbers (parameters and initial values) by the definitions of the speeds and by other printed
//! numbers.
//!
//! All numbers of one set count as rounded to the same decimal: the last decimal of the set's longest number, ± half a
//! unit. Formulas without decimals are exact. Two numbers contradict each other only if they differ by more than this
//! rounding.

use super::finding::{Finding, Judgement, TracedFinding};
use crate::diff::equations::claim::Claim;

use crate::algebra::Expr;
use crate::algebra::meaning::compare::Witness;
use crate::algebra::term::calculus::Differential;
use crate::algebra::text::print::print_text;
use crate::algebra::value::tape::Tape;
use crate::model::Model;
use crate::publication::{Entry, EntryKind, Initial, Publication};

/// Value of a judged quantity from another place in the publication, with its uncertainty.
struct OtherValue {
    /// Value of the quantity, in its SI unit.
    value: f64,
    /// Uncertainty of the value by rounding, in the same unit.
    slack: f64,
    /// Origin of the value, in words.
    from: String,
    /// Names and values of the printed numbers from which the value was computed; empty if the value itself is printed.
    at: Vec<(String, f64)>,
    /// Ids of the entries that give the value.
    entries: Vec<String>,
}

/// Judges a printed number of a parameter or of an initial value. The claim in the result lists the entries that
/// contradict the number.
pub fn judge_printed_number(model: &Model, publication: &Publication, entry: &Entry) -> TracedFinding {
    let EntryKind::Initial(initial) = &entry.kind else { unreachable!("asked for numbers only") };
    let mut finding = Finding::new(&entry.id, &entry.section, Judgement::Stated, &initial.text);
    let own = printed_number_value(model, initial.value);
    let slack = printed_number_uncertainty(publication, initial);
    let others: Vec<OtherValue> = speed_from_printed_numbers(model, publication, initial)
        .into_iter()
        .chain(repeated_printed_numbers(model, publication, entry))
        .collect();
    let (mut contradicted, mut against) = (false, Vec::new());
    for other in &others {
        let difference = own - other.value;
        // Rounding errors of the arithmetic are far below the rounding of the printed numbers.
        let allowed = slack + other.slack + 1e-9 * own.abs().max(other.value.abs());
        if difference.abs() <= allowed {
            finding.remarks.push(format!("agrees with {} = {}", other.from, number_text(other.value)));
        } else {
            contradicted = true;
            against.extend(other.entries.iter().cloned());
            finding.remarks.push(format!(
                "{} gives {}, printed − that = {}",
                other.from,
                number_text(other.value),
                number_text(difference)
            ));
            finding.witness.get_or_insert(Witness { at: other.at.clone(), left: own, right: other.value, difference });
        }
    }
    if contradicted {
        finding.judgement = Judgement::Different;
    } else if !others.is_empty() {
        finding.judgement = Judgement::Equal;
    }
    finding.with_claim(Claim::Number { against })
}

/// Text of a number, rounded to six significant digits.
fn number_text(x: f64) -> String {
    let rounded: f64 = format!("{x:.5e}").parse().unwrap_or(x);
    rounded.to_string()
}

/// Value of a term without symbols; NaN if the term has no numerical value.
fn printed_number_value(model: &Model, e: Expr) -> f64 {
    Tape::new(&model.arena, &[], &[e]).map_or(f64::NAN, |tape| tape.evaluate(&[])[0])
}

/// Entries of a publication that state a number of a parameter or an initial value.
pub(super) fn printed_number_entries(publication: &Publication) -> impl Iterator<Item = (&Entry, &Initial)> {
    publication.entries.iter().filter_map(|entry| match &entry.kind {
        EntryKind::Initial(initial) => Some((entry, initial)),
        _ => None,
    })
}

/// Entries whose numbers belong to one set, such as the initial values of one example.
fn printed_numbers_of_set<'a>(
    publication: &'a Publication,
    set: &'a str,
) -> impl Iterator<Item = (&'a Entry, &'a Initial)> {
    publication.entries.iter().filter_map(move |entry| match &entry.kind {
        EntryKind::Initial(initial) if initial.set == set => Some((entry, initial)),
        _ => None,
    })
}

/// Uncertainty of a printed number: half a unit in the last decimal of its set; 0 for exact formulas.
fn printed_number_uncertainty(publication: &Publication, initial: &Initial) -> f64 {
    if initial.decimals.is_none() {
        return 0.0;
    }
    let most = printed_numbers_of_set(publication, &initial.set).filter_map(|(_, i)| i.decimals).max().unwrap_or(0);
    0.5 * 10_f64.powi(-i32::try_from(most).unwrap_or(0))
}

/// Value of a generalized speed by its definition, computed from the coordinates and rates of the same set of numbers.
/// Returns `None` if the quantity is no speed, or if a needed number is not stated.
fn speed_from_printed_numbers(model: &Model, publication: &Publication, initial: &Initial) -> Option<OtherValue> {
    let speed = model.speeds.iter().find(|s| s.symbol == initial.quantity)?;
    let mut arena = model.arena.clone();
    let symbols: Vec<Expr> =
        arena.reachable(&[speed.definition]).into_iter().filter(|e| arena.symbol_name(*e).is_some()).collect();
    let (mut values, mut entries) = (Vec::new(), Vec::new());
    for symbol in &symbols {
        let (entry, stated) = printed_numbers_of_set(publication, &initial.set).find(|(_, i)| i.quantity == *symbol)?;
        entries.push(entry.id.clone());
        values.push((printed_number_value(model, stated.value), printed_number_uncertainty(publication, stated)));
    }
    let slopes: Vec<Expr> =
        symbols.iter().map(|s| Differential::partial(*s).apply(&mut arena, speed.definition)).collect();
    let outputs = [vec![speed.definition], slopes].concat();
    let point: Vec<f64> = values.iter().map(|(value, _)| *value).collect();
    let found = Tape::new(&arena, &symbols, &outputs).ok()?.evaluate(&point);
    let slack = found[1..].iter().zip(&values).map(|(slope, (_, slack))| slope.abs() * slack).sum();
    let names = symbols.iter().filter_map(|s| arena.symbol_name(*s)).map(str::to_owned);
    Some(OtherValue {
        value: found[0],
        slack,
        from: format!("{} = {}", speed.name, print_text(&arena, speed.definition)),
        at: names.zip(point).collect(),
        entries,
    })
}

/// Values that other entries print for the quantity of `entry`.
fn repeated_printed_numbers(model: &Model, publication: &Publication, entry: &Entry) -> Vec<OtherValue> {
    let EntryKind::Initial(initial) = &entry.kind else { return Vec::new() };
    let others = publication.entries.iter().filter_map(|other| match &other.kind {
        EntryKind::Initial(i) if i.quantity == initial.quantity && other.id != entry.id => Some((other, i)),
        _ => None,
    });
    others
        .map(|(other, i)| OtherValue {
            value: printed_number_value(model, i.value),
            slack: printed_number_uncertainty(publication, i),
            from: format!("entry {}", other.id),
            at: Vec::new(),
            entries: vec![other.id.clone()],
        })
        .collect()
}
