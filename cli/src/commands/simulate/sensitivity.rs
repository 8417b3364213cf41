//! Option `tripos simulate --sensitivity`: derivatives of a run with respect to chosen numbers, in text, JSON and CSV.

use serde_json::{Map, Value, json};
use std::fmt::Write;
use tripos::Sensitivities;
use tripos_derive::model::TIME;
use tripos_derive::plain_text::{with_reliable_digits, with_significant_digits};
use tripos_sim::Stop;

/// Returns the indices of the values whose derivatives are shown: all except the time.
fn shown_value_indices(of: &Sensitivities) -> impl Iterator<Item = usize> {
    (0..of.names.len()).filter(|at| of.names[*at] != TIME)
}

/// Adds the sensitivities to the JSON of a run.
pub fn add_sensitivity_json(whole: &mut Value, of: &Sensitivities) {
    let Value::Object(whole) = whole else { return };
    let list = |value: &dyn Fn(usize, usize) -> Value| -> Value {
        let by = of.by.iter().enumerate().map(|(k, by)| {
            let values: Map<String, Value> =
                shown_value_indices(of).map(|at| (of.names[at].clone(), value(k, at))).collect();
            (by.clone(), Value::Object(values))
        });
        Value::Object(by.collect())
    };
    let instants = |list: &[f64]| -> Value {
        Value::Object(of.by.iter().zip(list).map(|(by, x)| (by.clone(), json!(x))).collect())
    };
    whole.insert("sensitivity".to_owned(), list(&|k, at| json!(of.end[k][at])));
    let errors = of.errors.as_ref().map_or(Value::Null, |errors| list(&|k, at| json!(errors[k][at])));
    whole.insert("sensitivity_uncertainty".to_owned(), errors);
    whole.insert("sensitivity_units".to_owned(), list(&|k, at| json!(of.units[k][at])));
    whole.insert("sensitivity_of_t".to_owned(), instants(&of.t_end));
    whole.insert("sensitivity_assessed_by".to_owned(), json!(of.assessed_by));
    if let Some(Value::Array(events)) = whole.get_mut("events") {
        for (event, list) in events.iter_mut().zip(&of.events) {
            event["sensitivity"] = list.as_ref().map_or(Value::Null, |list| instants(list));
        }
    }
}

/// Returns the derivatives at the end of the run as text, one per line.
pub fn sensitivity_text(of: &Sensitivities) -> String {
    let mut out = String::new();
    for (k, by) in of.by.iter().enumerate() {
        let is_event = matches!(of.run.solution.stop, Stop::Event { .. } | Stop::LeftDomain { .. });
        let what = if is_event { "in all, as that instant moves" } else { "at that instant" };
        let _ = writeln!(
            out,
            "\nderivatives with respect to {by} at t = {} s, {what}",
            with_reliable_digits(of.run.solution.t_end, None)
        );
        if is_event {
            let _ = writeln!(out, "  d(t)/d({by}) = {}", of.t_end[k]);
        }
        for at in shown_value_indices(of) {
            let error = of
                .errors
                .as_ref()
                .map_or_else(String::new, |errors| format!(" ± {}", with_significant_digits(errors[k][at], 1)));
            let unit = sensitivity_unit_suffix(of.units[k][at].as_ref());
            if !of.end[k][at].is_finite() {
                let _ = writeln!(out, "  d({})/d({by}) has no value", of.names[at]);
                continue;
            }
            let _ = writeln!(out, "  d({})/d({by}) = {}{error}{unit}", of.names[at], of.end[k][at]);
        }
    }
    let why = match &of.assessed_by {
        Some(words) => format!("errors of the derivatives, by comparison with {words}\n"),
        None => "the errors of the derivatives are not known: no second run came to the same end\n".to_owned(),
    };
    out + &why
}

/// Returns a unit as text to be placed after a number. Empty if the quantity has no unit, or if the unit is not known.
pub fn sensitivity_unit_suffix(unit: Option<&String>) -> String {
    unit.filter(|unit| *unit != "1").map_or_else(String::new, |unit| format!(" {unit}"))
}

/// Returns the names of the derivative columns in the CSV file of samples, such as `d(q1)/d(m)`.
pub fn sensitivity_header(of: &Sensitivities) -> impl Iterator<Item = String> {
    of.by.iter().flat_map(move |by| shown_value_indices(of).map(move |at| format!("d({})/d({by})", of.names[at])))
}

/// Returns the derivatives at a sample, in the order of the columns of [`sensitivity_header`].
pub fn sensitivity_row(of: &Sensitivities, sample: usize) -> impl Iterator<Item = f64> {
    of.samples.iter().flat_map(move |list| shown_value_indices(of).map(move |at| list[sample][at]))
}
