//! Option `tripos simulate --rigorous`: boxes that provably contain the motion of a scene, and claims about it.

use super::write_table_file;
use crate::arguments::Simulate;
use crate::files::workspace::short_name;
use crate::terminal::failure::{Failure, print, print_json, print_to_stderr, status};
use crate::terminal::interruption;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::{Claim, ClaimVerdict, EquationsName, Mechanism, RigorousRequest, RigorousScene, enclose_scene};
use tripos_derive::model::TIME;
use tripos_derive::plain_text::with_significant_digits;
use tripos_derive::scene::Scene;
use tripos_sim::rigorous_run::{RigorousEnd, RigorousOptions};
use tripos_traits::{Ball, DoubleDouble, Scalar};

/// Encloses the motion of a scene, and prints the box at the end, the ranges and the claims. Returns the exit status:
/// 1 if a claim is not proved, 3 if the enclosure ends before the span, 130 if the user interrupts it.
///
/// # Errors
/// `Failure` if the scene cannot be enclosed, or if the output cannot be printed or written.
pub fn simulate_rigorously(
    request: &Simulate,
    model: &Mechanism,
    scene: &Scene,
    set: &[(String, f64)],
    by: Option<&EquationsName>,
) -> Result<u8, Failure> {
    let parts = scene.integration.samples.map_or(1, |samples| samples.saturating_sub(1).max(1));
    let options = RigorousOptions::default();
    interruption::listen_for_interruption();
    let found =
        enclose_scene(model, scene, &RigorousRequest { by, set, parts, claims: &request.enclosure.claim, options })?;
    found.notes.iter().for_each(|note| print_to_stderr(&format!("note: {note}")));
    if request.json {
        print_json(&enclosure_json(model, &found))?;
    } else {
        print(&enclosure_text(model, scene, &found))?;
    }
    if let Some(path) = &request.csv {
        write_boxes(path, &found)?;
    }
    let ends_early = found.run.end != RigorousEnd::Reached;
    if ends_early && request.json {
        print_to_stderr(&end_in_words(&found));
    }
    let is_proved = found.claims.iter().all(|(_, verdict)| verdict.is_proved());
    Ok(match found.run.end {
        RigorousEnd::Interrupted => status::INTERRUPTED,
        _ if ends_early => status::STOPPED,
        _ => u8::from(!is_proved) * status::NO,
    })
}

/// Indices of the quantities that are shown: all except the time.
fn shown_indices(found: &RigorousScene) -> impl Iterator<Item = usize> {
    (0..found.names.len()).filter(|at| found.names[*at] != TIME)
}

/// Returns the enclosure as JSON. Each box has the lower and the upper bound of every quantity, as doubles that are
/// rounded outwards.
fn enclosure_json(model: &Mechanism, found: &RigorousScene) -> Value {
    let bounds =
        |low: f64, high: f64| if low.is_finite() && high.is_finite() { json!([low, high]) } else { Value::Null };
    let named = |list: &dyn Fn(usize) -> Value| -> Map<String, Value> {
        shown_indices(found).map(|at| (found.names[at].clone(), list(at))).collect()
    };
    let of_box = |balls: &[Ball]| named(&|at| bounds(balls[at].low(), balls[at].high()));
    let boxes = found.t.iter().zip(&found.boxes).map(|(t, balls)| json!({ "t": t, "box": of_box(balls) }));
    let digits = |ball: &Ball| json!({ "centre": ball.centre.to_string(), "radius": ball.radius });
    let last = found.boxes.last();
    let claim = |(claim, verdict): &(Claim, ClaimVerdict)| {
        json!({
            "claim": claim.text,
            "verdict": verdict_word(*verdict),
            "proved_to": verdict.proved_to,
            "refuted_by": verdict.refuted_by,
        })
    };
    json!({
        "model": short_name(model),
        "formulation": found.by.name(),
        "t": found.run.t_end,
        "end": end_word(found.run.end),
        "box": last.map(|balls| of_box(balls)),
        "box_in_32_digits": last.map(|balls| named(&|at| digits(&balls[at]))),
        "boxes": boxes.collect::<Vec<Value>>(),
        "ranges": named(&|at| bounds(found.ranges[at].lo(), found.ranges[at].hi())),
        "claims": found.claims.iter().map(claim).collect::<Vec<Value>>(),
        "steps": found.run.steps,
        "rejected": found.run.rejected,
        "notes": found.notes,
    })
}

/// Returns the enclosure as text.
fn enclosure_text(model: &Mechanism, scene: &Scene, found: &RigorousScene) -> String {
    let mut out = format!("{}, {}, enclosed in balls of 32 digits\n", model.title, found.by.title());
    let _ = writeln!(out, "{}", end_in_words(found));
    if let (Some(t), Some(balls)) = (found.t.last(), found.boxes.last()) {
        let _ = writeln!(out, "\nproved at t = {t} s");
        for at in shown_indices(found) {
            let _ = writeln!(out, "  {} = {}", found.names[at], ball_in_words(balls[at]));
        }
    }
    let until = with_significant_digits(found.run.t_end, 6);
    let _ = writeln!(out, "\nproved for all t from {} s to {until} s", scene.span.0);
    for at in shown_indices(found) {
        let (low, high) = (found.ranges[at].lo(), found.ranges[at].hi());
        let (low, high) = (rounded_outwards(low, Side::Low), rounded_outwards(high, Side::High));
        let _ = writeln!(out, "  {} is between {low} and {high}", found.names[at]);
    }
    if !found.claims.is_empty() {
        out.push('\n');
    }
    for (claim, verdict) in &found.claims {
        let _ = writeln!(out, "{}: {}", claim.text, verdict_in_words(*verdict));
    }
    out
}

/// Writes a bound with six digits, rounded away from the range: down for the lower bound, up for the upper one.
fn rounded_outwards(x: f64, side: Side) -> String {
    let text = |x: f64| with_significant_digits(x, 6);
    let is_outside = |text: &str| match (text.parse::<f64>(), side) {
        (Ok(shown), Side::Low) => shown <= x,
        (Ok(shown), Side::High) => shown >= x,
        (Err(_), _) => false,
    };
    let unit = 1e-5 * x.abs();
    let beside = if side == Side::Low { x - unit } else { x + unit };
    Some(text(x)).filter(|text| is_outside(text)).unwrap_or_else(|| text(beside))
}

/// Side of a range.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    /// Lower bound.
    Low,
    /// Upper bound.
    High,
}

/// Writes a ball with the digits that it determines, and a bound on the distance of the number from them.
fn ball_in_words(ball: Ball) -> String {
    if !ball.is_defined() {
        return "no bound".to_owned();
    }
    // The shortest decimals of a double differ from it by less than half a unit in its last place.
    let nearest = ball.centre.hi();
    let rest = (Ball::point(ball.centre) - Ball::from_f64(nearest)).size() + ball.radius + f64::EPSILON * nearest.abs();
    if rest > 1e-14 * nearest.abs() {
        return format!("{nearest} ± {}", rounded_up(rest * (1.0 + 4.0 * f64::EPSILON)));
    }
    // The printed decimals differ from the centre by less than one unit of the 31st digit.
    let printed = ball.centre.to_string();
    let error = Ball::<DoubleDouble>::decimal(&printed) - Ball::point(ball.centre);
    format!("{printed} ± {}", rounded_up((ball.radius + error.size()) * (1.0 + 4.0 * f64::EPSILON)))
}

/// Writes a positive number with two digits, rounded up.
fn rounded_up(x: f64) -> String {
    let text = format!("{x:.1e}");
    let is_below = text.parse::<f64>().is_ok_and(|shown| shown < x);
    if is_below { format!("{:.1e}", x * 1.06) } else { text }
}

/// Word for the verdict on a claim: `proved`, `refuted` or `open`.
fn verdict_word(verdict: ClaimVerdict) -> &'static str {
    match verdict {
        verdict if verdict.is_proved() => "proved",
        ClaimVerdict { refuted_by: Some(_), .. } => "refuted",
        _ => "open",
    }
}

/// Sentence about the verdict on a claim.
fn verdict_in_words(verdict: ClaimVerdict) -> String {
    let shown = |t: f64| with_significant_digits(t, 6);
    let to = verdict.proved_to.map_or_else(String::new, |t| format!(", and proved up to t = {} s", shown(t)));
    match (verdict.is_proved(), verdict.refuted_by) {
        (true, _) => "proved at all instants".to_owned(),
        (false, Some(t)) => format!("proved to be false at an instant before t = {} s{to}", shown(t)),
        (false, None) => format!("not proved and not refuted{to}"),
    }
}

/// Word for the end of an enclosure, for JSON.
fn end_word(end: RigorousEnd) -> &'static str {
    match end {
        RigorousEnd::Reached => "reached",
        RigorousEnd::NoEnclosure => "no_enclosure",
        RigorousEnd::TooWide => "too_wide",
        RigorousEnd::StepLimit => "step_limit",
        RigorousEnd::Interrupted => "interrupted",
    }
}

/// Sentence about the end of an enclosure.
fn end_in_words(found: &RigorousScene) -> String {
    let t = with_significant_digits(found.run.t_end, 6);
    let steps = found.run.steps;
    match found.run.end {
        RigorousEnd::Reached => format!("the motion exists up to t = {t} s; {steps} steps"),
        RigorousEnd::NoEnclosure => {
            format!(
                "nothing is proved after t = {t} s: a divisor may be 0 there, or the box is too wide; {steps} steps"
            )
        }
        RigorousEnd::TooWide => format!("the box is wider than 1 after t = {t} s; {steps} steps"),
        RigorousEnd::StepLimit => format!("the limit of {steps} steps is reached at t = {t} s"),
        RigorousEnd::Interrupted => format!("interrupted at t = {t} s; {steps} steps"),
    }
}

/// Writes the boxes to a table: the instant, then the lower and the upper bound of each quantity.
///
/// # Errors
/// `Failure` if the file cannot be written.
fn write_boxes(path: &Path, found: &RigorousScene) -> Result<(), Failure> {
    let columns = shown_indices(found).flat_map(|at| {
        let name = &found.names[at];
        [format!("{name} low"), format!("{name} high")]
    });
    let header: Vec<String> = std::iter::once("t".to_owned()).chain(columns).collect();
    let rows = found.t.iter().zip(&found.boxes).map(|(t, balls)| {
        let bounds = shown_indices(found).flat_map(|at| [balls[at].low(), balls[at].high()]);
        std::iter::once(*t).chain(bounds).map(|x| x.to_string()).collect()
    });
    write_table_file(path, &header, rows)
}
