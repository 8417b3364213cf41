//! Elements, numbers and texts of `modelDescription.xml` that FMI 2.0 and FMI 3.0 share.

use super::variables::Variable;
use std::collections::BTreeMap;
use std::fmt::Write;
use tripos_derive::model::Unit;
use tripos_derive::plain_text::{one_line, with_visible_characters};
use tripos_derive::scene::Scene;

/// Writes the XML element `DefaultExperiment`: the scene's start and stop time in s, its relative tolerance, and a
/// step of 1/500 of the span.
pub fn write_default_experiment_element(out: &mut String, scene: &Scene) {
    let (start, stop) = scene.span;
    let _ = writeln!(
        out,
        "  <DefaultExperiment startTime=\"{start:?}\" stopTime=\"{stop:?}\" tolerance=\"{:?}\" stepSize=\"{:?}\"/>",
        scene.integration.rtol,
        (stop - start) / 500.0
    );
}

/// Writes the XML definitions of the units that the variables have. A unit is defined by its exponents of m, kg and
/// s. For a unit with fractional exponents only the name is written.
pub fn write_unit_definitions_element(out: &mut String, list: &[Variable]) {
    let units: BTreeMap<String, &Unit> =
        list.iter().filter_map(|v| Some((v.unit.as_ref()?.to_string(), v.unit.as_ref()?))).collect();
    out.push_str("  <UnitDefinitions>\n");
    for (name, unit) in units {
        let _ = write!(out, "    <Unit name=\"{}\"", escape_xml_attribute(&name));
        match unit.whole_exponents() {
            Some(exponents) => {
                let base: String = (["m", "kg", "s"].iter().zip(exponents))
                    .filter(|(_, exponent)| *exponent != 0)
                    .fold(String::new(), |text, (base, exponent)| text + &format!(" {base}=\"{exponent}\""));
                let _ = writeln!(out, "><BaseUnit{base}/></Unit>");
            }
            None => out.push_str("/>\n"),
        }
    }
    out.push_str("  </UnitDefinitions>\n");
}

/// Returns a number in the notation of XML schemas: `NaN`, `INF`, `-INF` or a decimal number.
pub fn xml_number(value: f64) -> String {
    if value.is_nan() {
        "NaN".to_owned()
    } else if value.is_infinite() {
        if value > 0.0 { "INF".to_owned() } else { "-INF".to_owned() }
    } else {
        format!("{value:?}")
    }
}

/// Returns a text as the value of an XML attribute: on one line, with `&`, `<`, `>` and quotes
/// escaped.
pub fn escape_xml_attribute(text: &str) -> String {
    let mut out = String::new();
    for c in with_visible_characters(&one_line(text)).trim().chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c => out.push(c),
        }
    }
    out
}
