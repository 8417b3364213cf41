//! Certificate of the verdicts on a publication: a text from which another program decides whether they hold.
//!
//! Each line is a JSON value. The certificate contains that of the model's proofs, the text of the publication, and a
//! line for each verdict. The checker reads the publication by itself. Only formulas in other notations than that of
//! model files are stated as Tripos reads them. `docs/certificate.md` states the format.

use crate::files::judged_publication::JudgedPublication;
use crate::terminal::failure::Failure;
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use tripos::Mechanism;
use tripos_derive::algebra::text::notation::Notation;
use tripos_derive::algebra::text::print::{print_text, print_whole_text};
use tripos_derive::algebra::value::proved_prime::proved_prime_after;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::{Finding, Judgement};
use tripos_derive::mechanics::{EnergyQuantity, QuantityKind, RowQuantity, VectorName};
use tripos_derive::model::text_digest;
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::publication::{Entry, EntryKind, Publication};

/// Version of the format of certificates of verdicts.
const VERSION: u32 = 1;

/// Difference of energies that the checker permits: another zero of the potential energy.
const UP_TO_A_CONSTANT: &str = "up to a constant";

/// Formula of a printed entry that has a verdict of its own.
enum PrintedPart {
    /// Value of a quantity of this kind.
    Value(QuantityKind, Expr),
    /// Whole row of a system, as pairs of an entry and the name of its unknown, and the right-hand side.
    Row(Vec<(Expr, String)>, Expr),
    /// Single entry of a row.
    RowEntry(Expr),
    /// Derivative that a program computes.
    Derivative(Expr),
    /// Text or number without a formula.
    Plain,
}

/// Refuses a certificate that would replace the publication.
///
/// # Errors
/// `Failure` if both are the same file.
pub fn refuse_overwriting_publication(source: &Source, path: &Path) -> Result<(), Failure> {
    let same = |a: &Path, b: &Path| a.canonicalize().ok().zip(b.canonicalize().ok()).is_some_and(|(a, b)| a == b);
    if same(&source.path, path) {
        let what = format!("`{}` is the publication, which would be replaced", path_as_plain_text(path));
        return Err(Failure::request(what, "name another file for the certificate"));
    }
    Ok(())
}

/// Returns the certificate of the verdicts on a publication. `proof` is the certificate of the proofs about its model.
pub fn certificate_of_verdicts(proof: &str, judged: &JudgedPublication) -> String {
    let JudgedPublication { model, publication, derivations, difference, .. } = judged;
    let reader = FormulaWriter { model, publication };
    let text = &publication.source.text;
    let mut lines = vec![
        json!({ "tripos_verdicts": VERSION, "model": model.title, "publication": publication.title }),
        json!({ "proof": proof, "sha256": text_digest(proof) }),
        json!({ "publication_text": text, "sha256": text_digest(text) }),
    ];
    for (name, file) in &publication.files {
        lines.push(json!({ "file": name, "text": file.text, "sha256": text_digest(&file.text) }));
    }
    lines.push(json!({ "abbreviations": reader.abbreviations() }));
    let (parts, arena) = (printed_parts(publication), &derivations.kinematics.arena);
    let mut left_out = Map::new();
    for finding in &difference.findings {
        let Some((entry, part)) = parts.get(&finding.id) else {
            left_out.insert(finding.id.clone(), json!("it could not be judged"));
            continue;
        };
        match reason_to_leave_out(model, arena, publication, entry, part, finding) {
            Some(reason) => {
                left_out.insert(finding.id.clone(), json!(reason));
            }
            None => lines.push(reader.verdict_line(arena, entry, part, finding)),
        }
    }
    lines.push(json!({ "not_certified": left_out }));
    let mut out = String::new();
    for line in &lines {
        let _ = writeln!(out, "{line}");
    }
    let prime = proved_prime_after(&text_digest(&out));
    let _ = writeln!(out, "{}", json!({ "prime": prime.cofactor, "witness": prime.witness }));
    out
}

/// Lists the formulas of all entries and of their parts, by the ids of their verdicts.
fn printed_parts(publication: &Publication) -> BTreeMap<String, (&Entry, PrintedPart)> {
    let mut parts = BTreeMap::new();
    for entry in &publication.entries {
        match &entry.kind {
            EntryKind::Equation { quantity, printed, .. } => {
                parts.insert(entry.id.clone(), (entry, PrintedPart::Value(quantity.kind().clone(), *printed)));
            }
            EntryKind::Definition { .. } | EntryKind::Initial(_) => {
                parts.insert(entry.id.clone(), (entry, PrintedPart::Plain));
            }
            EntryKind::System(system) => {
                for (i, (row, right)) in system.matrix.iter().zip(&system.right).enumerate() {
                    let terms = row.iter().copied().zip(system.unknown_names.iter().cloned()).collect();
                    parts.insert(system.row_id(&entry.id, i), (entry, PrintedPart::Row(terms, *right)));
                    for (j, e) in row.iter().enumerate() {
                        let id = system.matrix_id(i, j);
                        parts.extend(id.map(|id| (id, (entry, PrintedPart::RowEntry(*e)))));
                    }
                    let id = system.right_id(i);
                    parts.extend(id.map(|id| (id, (entry, PrintedPart::RowEntry(*right)))));
                }
            }
            EntryKind::Listing(listing) => {
                for (at, e) in listing.derivative.iter().enumerate() {
                    let is_of_row = listing.matrix.is_some() && listing.moving.contains(&at);
                    let part = if is_of_row { PrintedPart::RowEntry(*e) } else { PrintedPart::Derivative(*e) };
                    parts.insert(listing.derivative_id(&entry.id, at), (entry, part));
                }
                for (i, row) in listing.matrix.iter().flatten().enumerate() {
                    for (j, e) in row.iter().enumerate() {
                        parts.insert(listing.matrix_id(&entry.id, i, j), (entry, PrintedPart::RowEntry(*e)));
                    }
                }
            }
        }
    }
    parts
}

/// Reason why the verdict on an entry is not certified. `None` if it is.
fn reason_to_leave_out(
    model: &Mechanism,
    arena: &Arena,
    publication: &Publication,
    entry: &Entry,
    part: &PrintedPart,
    finding: &Finding,
) -> Option<&'static str> {
    if matches!(entry.kind, EntryKind::Definition { .. }) {
        return None;
    }
    let is_wrong = matches!(finding.judgement, Judgement::Different);
    match part {
        _ if matches!(finding.judgement, Judgement::Undecided(_)) => Some("undecided"),
        _ if entry.near.is_some() => Some("it holds near a point"),
        _ if !publication.coordinates.is_empty() || !publication.redefined.is_empty() => {
            Some("coordinates of the author")
        }
        PrintedPart::Plain => Some("a printed number"),
        _ if finding.up_to.is_some_and(|words| !words.contains(UP_TO_A_CONSTANT)) => {
            Some("it is right up to a permitted difference, or a constraint")
        }
        _ if finding.holds.in_domain => Some("it holds in the domain of the model"),
        _ if (is_wrong || finding.holds.on_constraints) && relates_coordinates(model) => {
            Some("equations relate the coordinates")
        }
        PrintedPart::Value(kind, _) if !is_checked_quantity(kind) => Some("a quantity that the checker does not know"),
        PrintedPart::Value(kind, _) if is_wrong && differs_by_a_constant(model, arena, kind, finding) => {
            Some("it differs by a constant of another unit")
        }
        PrintedPart::Row(terms, _)
            if (is_wrong || finding.derived_row.is_none()) && contains_multipliers(model, terms) =>
        {
            Some("a row with multipliers, which the author may define")
        }
        PrintedPart::RowEntry(_) if finding.derived_row.is_none() => Some("an entry of no derived row"),
        _ => None,
    }
}

/// True if a printed energy differs from the derived one by parameters and numbers alone.
fn differs_by_a_constant(model: &Mechanism, arena: &Arena, kind: &QuantityKind, finding: &Finding) -> bool {
    let has_a_zero = matches!(kind, QuantityKind::Energy(energy) if energy.has_a_zero());
    let variables = model.coordinates.iter().flat_map(|c| [c.symbol, c.rate]);
    let mut variables = variables.chain(model.speeds.iter().map(|speed| speed.symbol));
    has_a_zero && finding.difference.is_some_and(|e| !variables.any(|symbol| arena.mentions(e, symbol)))
}

/// True if a row contains a multiplier of a constraint.
fn contains_multipliers(model: &Mechanism, terms: &[(Expr, String)]) -> bool {
    let name = |e: Expr| model.arena.symbol_name(e).unwrap_or_default();
    let multipliers: Vec<&str> = model.motion_constraints.iter().map(|c| name(c.multiplier)).collect();
    terms.iter().any(|(e, unknown)| *e != Expr::ZERO && multipliers.contains(&unknown.as_str()))
}

/// True if equations between coordinates alone restrict the poses, other than the norms of Euler parameters.
fn relates_coordinates(model: &Mechanism) -> bool {
    let norms: Vec<String> = model.frames.iter().map(|frame| format!("{}_norm", frame.name)).collect();
    !model.closed.is_empty() || model.loops.iter().any(|one| !norms.contains(&one.name))
}

/// True if the checker derives quantities of this kind by itself.
fn is_checked_quantity(kind: &QuantityKind) -> bool {
    !matches!(
        kind,
        QuantityKind::Component { vector: VectorName::Force | VectorName::Moment, .. }
            | QuantityKind::Christoffel(..)
            | QuantityKind::MassRate(..)
            | QuantityKind::Row(RowQuantity::VelocityTerms | RowQuantity::PotentialSlope, _)
            | QuantityKind::Energy(EnergyQuantity::Gravity)
    )
}

/// Writer of formulas as the publication prints them, in the language of model files.
struct FormulaWriter<'a> {
    /// Model, with the formulas of the publication in its arena.
    model: &'a Mechanism,
    /// Publication with its abbreviations and names.
    publication: &'a Publication,
}

impl FormulaWriter<'_> {
    /// Returns the line with the verdict on an entry.
    fn verdict_line(&self, arena: &Arena, entry: &Entry, part: &PrintedPart, finding: &Finding) -> Value {
        let mut line = json!({ "entry": finding.id, "verdict": finding.judgement.word() });
        let is_foreign = entry.notation != Notation::Tripos || !finding.printed.is_ascii();
        if is_foreign && let Some(reading) = self.reading(part) {
            line["reading"] = json!(reading);
        }
        if matches!(finding.judgement, Judgement::Stated) {
            return line;
        }
        let factor = match &finding.derived_row {
            Some((row, factor)) => {
                line["row"] = json!(row.text(self.model));
                Some(*factor)
            }
            None => finding.factor.filter(|_| matches!(part, PrintedPart::Value(..) | PrintedPart::Derivative(_))),
        };
        if let Some(factor) = factor {
            line["factor"] = json!(print_whole_text(arena, factor));
        }
        if finding.up_to.is_some_and(|words| words.contains(UP_TO_A_CONSTANT)) {
            line["up_to"] = json!("a constant");
        }
        if let Some(words) = Self::correction(part, finding) {
            line["correction"] = json!(words);
        }
        line
    }

    /// Text of the correction that makes a wrong entry right. `None` for a right entry, if the text is shortened, and
    /// for energies, whose correction may go with another zero.
    fn correction<'f>(part: &PrintedPart, finding: &'f Finding) -> Option<&'f str> {
        let has_a_zero = matches!(part, PrintedPart::Value(QuantityKind::Energy(energy), _) if energy.has_a_zero());
        let is_wrong = matches!(finding.judgement, Judgement::Different);
        let words = finding.wrong.as_deref().filter(|words| words.is_ascii())?;
        (is_wrong && !has_a_zero).then_some(words)
    }

    /// Formula of an entry, as Tripos reads it. `None` for an entry without a formula.
    fn reading(&self, part: &PrintedPart) -> Option<String> {
        match part {
            PrintedPart::Value(_, e) | PrintedPart::RowEntry(e) | PrintedPart::Derivative(e) => Some(self.text(*e)),
            PrintedPart::Row(terms, right) => {
                let terms = terms.iter().filter(|(e, _)| *e != Expr::ZERO);
                let terms = terms.map(|(e, unknown)| format!("({})*{unknown}", self.text(*e)));
                let terms: Vec<String> = terms.chain([format!("(-1)*({})", self.text(*right))]).collect();
                Some(terms.join(" + "))
            }
            PrintedPart::Plain => None,
        }
    }

    /// Text of a printed formula, in which abbreviations and names of quantities are those of the publication.
    fn text(&self, e: Expr) -> String {
        let shorthand = &self.publication.shorthand;
        match shorthand.printed_form(e) {
            Some(printed) => self.with_names(print_whole_text(shorthand.arena(), printed)),
            None => self.with_names(print_whole_text(&self.model.arena, e)),
        }
    }

    /// Replaces the symbols of derived quantities by the names that the publication gives them.
    fn with_names(&self, mut text: String) -> String {
        for (name, _, symbol) in &self.publication.names {
            text = text.replace(&print_text(&self.model.arena, *symbol), name);
        }
        text
    }

    /// Formulas of the abbreviations and of the variables of programs, by their names.
    fn abbreviations(&self) -> Map<String, Value> {
        let shorthand = &self.publication.shorthand;
        let written_out = |(name, e): &(String, Expr)| (name.clone(), print_whole_text(&self.model.arena, *e));
        let mut formulas: BTreeMap<String, String> = self.publication.abbreviations.iter().map(written_out).collect();
        for one in shorthand.abbreviations() {
            formulas.insert(one.name.clone(), print_whole_text(shorthand.arena(), one.formula));
        }
        formulas.into_iter().map(|(name, text)| (name, json!(self.with_names(text)))).collect()
    }
}
