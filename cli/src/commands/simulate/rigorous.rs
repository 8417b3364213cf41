//! Option `tripos simulate --rigorous`: boxes that provably contain the motion of a scene, and claims about it.

use super::write_table_file;
use crate::arguments::Simulate;
use crate::files::workspace::short_name;
use crate::terminal::failure::{Failure, print, print_json, print_to_stderr, status};
use crate::terminal::interruption;
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::{
    ClaimVerdict, Crossing, CrossingCount, EnclosedInstants, EquationsName, Mechanism, RigorousRequest, RigorousScene,
    enclose_scene,
};
use tripos_derive::model::TIME;
use tripos_derive::plain_text::with_significant_digits;
use tripos_derive::scene::{Scene, SceneClaim};
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
    let parts = scene.integration.samples.map_or(1, |samples| samples.saturating_sub(1));
    let instants = EnclosedInstants::Parts(parts);
    let options = RigorousOptions::default();
    interruption::listen_for_interruption();
    let claims = &request.enclosure.claim;
    let operation_limit = u64::MAX;
    let found = enclose_scene(model, scene, &RigorousRequest { by, set, instants, claims, operation_limit, options })?;
    found.notes.iter().for_each(|note| print_to_stderr(&format!("note: {note}")));
    if request.json {
        print_json(&enclosure_json(model, scene, &found))?;
    } else {
        print(&enclosure_text(model, scene, &found))?;
    }
    if let Some(path) = &request.csv {
        write_boxes(path, &found)?;
    }
    let ends_early = !found.is_whole();
    if ends_early && request.json {
        print_to_stderr(&end_in_words(&found));
    }
    let is_proved = found.claims.iter().all(|(_, verdict)| verdict.is_proved());
    Ok(match found.run.end {
        RigorousEnd::Interrupted if found.last_event().is_none() => status::INTERRUPTED,
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
fn enclosure_json(model: &Mechanism, scene: &Scene, found: &RigorousScene) -> Value {
    let bounds =
        |low: f64, high: f64| if low.is_finite() && high.is_finite() { json!([low, high]) } else { Value::Null };
    let named = |list: &dyn Fn(usize) -> Value| -> Map<String, Value> {
        shown_indices(found).map(|at| (found.names[at].clone(), list(at))).collect()
    };
    let of_box = |balls: &[Ball]| named(&|at| bounds(balls[at].low(), balls[at].high()));
    let boxes = found.t.iter().zip(&found.boxes).map(|(t, balls)| json!({ "t": t, "box": of_box(balls) }));
    let digits = |ball: &Ball| json!({ "centre": ball.centre.to_string(), "radius": ball.radius });
    let narrow = |balls: &[Ball<f64>]| named(&|at| bounds(balls[at].low(), balls[at].high()));
    let event = |crossing: &Crossing| {
        json!({
            "name": scene.events[crossing.event].name,
            "from": crossing.from,
            "to": crossing.to,
            "crossings": crossing_word(crossing.count),
            "box": narrow(&crossing.shown),
        })
    };
    let last = found.boxes.last().filter(|_| found.last_event().is_none());
    let claim = |(claim, verdict): &(SceneClaim, ClaimVerdict)| {
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
        "t": end_instant(found),
        "end": end_word(found),
        "box": match found.last_event() {
            Some(crossing) => Some(narrow(&crossing.shown)),
            None => last.map(|balls| of_box(balls)),
        },
        "box_in_32_digits": last.map(|balls| named(&|at| digits(&balls[at]))),
        "boxes": boxes.collect::<Vec<Value>>(),
        "ranges": named(&|at| bounds(found.ranges[at].lo(), found.ranges[at].hi())),
        "events": found.crossings.iter().map(event).collect::<Vec<Value>>(),
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
    for crossing in &found.crossings {
        let _ = writeln!(out, "\nevent {}: {}", scene.events[crossing.event].name, crossing_in_words(crossing));
        for at in shown_indices(found) {
            let _ = writeln!(out, "  {} = {}", found.names[at], ball_in_words(crossing.shown[at].wide()));
        }
    }
    if let (Some(t), Some(balls), None) = (found.t.last(), found.boxes.last(), found.last_event()) {
        let _ = writeln!(out, "\nproved at t = {t} s");
        for at in shown_indices(found) {
            let _ = writeln!(out, "  {} = {}", found.names[at], ball_in_words(balls[at]));
        }
    }
    let until = with_significant_digits(end_instant(found), 6);
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
    let nearest = ball.centre.hi();
    let is_determined = |digit: &i32| ball.radius * 10f64.powi(*digit) < nearest.abs();
    let determined = (0..32).take_while(is_determined).count();
    // The printed digits are exact decimals, so their distance from the centre is bounded like any other number.
    let printed = match determined {
        0 => "0".to_owned(),
        1..15 => with_significant_digits(nearest, determined + 1),
        _ => {
            let all = ball.centre.to_string();
            let plain = all.strip_suffix("e0").unwrap_or(&all);
            let (digits, power) = plain.split_at(plain.find('e').unwrap_or(plain.len()));
            // A sign and a point stand beside the digits.
            digits.chars().take(determined + 3).chain(power.chars()).collect()
        }
    };
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

/// Last instant about which something is proved, s.
fn end_instant(found: &RigorousScene) -> f64 {
    found.last_event().map_or(found.run.t_end, |crossing| crossing.to)
}

/// Word for the proved number of crossings between two instants, for JSON.
fn crossing_word(count: CrossingCount) -> &'static str {
    match count {
        CrossingCount::One => "one",
        CrossingCount::AtLeastOne => "at_least_one",
        CrossingCount::Open => "open",
    }
}

/// Words for the proved number of crossings between two instants, and for the instants.
fn crossing_in_words(crossing: &Crossing) -> String {
    let t = Ball::<DoubleDouble>::between(crossing.from, crossing.to);
    let instant = ball_in_words(t);
    match crossing.count {
        CrossingCount::One => format!("proved once at t = {instant} s, where"),
        CrossingCount::AtLeastOne => format!("proved at least once at t = {instant} s, where"),
        CrossingCount::Open => format!("may occur at t = {instant} s, where"),
    }
}

/// Word for the end of an enclosure, for JSON.
fn end_word(found: &RigorousScene) -> &'static str {
    if let Some(crossing) = found.last_event() {
        return if crossing.count == CrossingCount::Open { "open_event" } else { "event" };
    }
    match found.run.end {
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
    if let Some(crossing) = found.last_event() {
        let t = with_significant_digits(crossing.to, 6);
        return match crossing.count {
            CrossingCount::Open => format!("an event may end the motion by t = {t} s; {steps} steps"),
            _ => format!("an event ends the motion by t = {t} s; {steps} steps"),
        };
    }
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
