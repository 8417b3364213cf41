//! Names of the identities that a certificate claims, in the order in which its checker proves them.
//!
//! The checker finds the same list from the derivation alone, and refuses a certificate with another list.

use serde_json::Value;
use std::collections::BTreeSet;

/// Name of an identity in parts: formulation, row and column, such as `lagrange`, `u1`, `u2'`.
pub type IdentityName = Vec<String>;

/// Lists the identities about the formulations of a derivation in JSON, of which Kane's equations are the first. If
/// drives move the mechanism (`is_driven`), the rate of T + V is not among them.
pub fn derivation_identities(derivation: &Value, is_driven: bool) -> Vec<IdentityName> {
    let empty = Vec::new();
    let list = derivation["formulations"].as_array().unwrap_or(&empty);
    let Some(kane) = list.first() else { return Vec::new() };
    let kane = System::new(kane);
    let mut out = Vec::new();
    for value in list {
        let system = System::new(value);
        let is_kane = system.name == kane.name;
        let in_rates = system.unknowns.first() != kane.unknowns.first();
        let (columns, count) = if in_rates {
            let others = system.unknowns.iter().skip(system.rate_count);
            (kane.unknowns.iter().chain(others).cloned().collect(), system.rate_count)
        } else {
            (system.unknowns.clone(), system.rows.len())
        };
        if !is_kane {
            for row in kane.rows.iter().chain(system.rows.iter().skip(count)) {
                out.extend(columns.iter().map(|column| system.identity(&[row, column])));
                out.push(system.identity(&[row, "right"]));
            }
            out.extend(["kinetic_energy", "potential_energy", "power"].map(|what| system.identity(&[what])));
        }
        if !system.solved.is_empty() {
            let is_complete = is_kane || system.unknowns.iter().all(|unknown| system.solved.contains(unknown));
            let (multiplied, count) = if is_complete { (&[][..], 0) } else { (kane.rows.as_slice(), count) };
            let rows = multiplied.iter().chain(system.rows.iter().skip(count));
            out.extend(rows.map(|row| system.identity(&["accelerations", row])));
        }
        if is_kane && !is_driven {
            out.push(system.identity(&["power", "rate"]));
        }
    }
    out
}

/// Lists the identities that the values of the reactions in the formulation `name` solve its rows along the motion.
/// Empty unless the derivation has the accelerations of its first formulation, Kane's.
pub fn reaction_identities(derivation: &Value, name: &str) -> Vec<IdentityName> {
    let mut systems = derivation["formulations"].as_array().into_iter().flatten().map(System::new).peekable();
    if systems.peek().is_none_or(|kane| kane.solved.is_empty()) {
        return Vec::new();
    }
    let Some(system) = systems.find(|system| system.name == name) else { return Vec::new() };
    system.rows.iter().map(|row| system.identity(&["reactions", row])).collect()
}

/// Lists the identities that Kane's rows do not change with a parameter. The certificate calls the parameter `name`.
pub fn parameter_identities(derivation: &Value, name: &str) -> Vec<IdentityName> {
    let kane = derivation["formulations"].as_array().into_iter().flatten().map(System::new).next();
    kane.into_iter().flat_map(|kane| kane.rows).map(|row| vec![name.to_owned(), row]).collect()
}

/// Names in the equations of one formulation.
struct System {
    /// Name of the formulation.
    name: String,
    /// Names of the rows.
    rows: Vec<String>,
    /// Names of the unknowns.
    unknowns: Vec<String>,
    /// Number of coordinates, each of which has a rate.
    rate_count: usize,
    /// Names that the accelerations in closed form define.
    solved: BTreeSet<String>,
}

impl System {
    /// Reads the names from the JSON object of a formulation.
    fn new(value: &Value) -> Self {
        let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
        let texts = |key: &str| value[key].as_array().into_iter().flatten().map(text).collect::<Vec<_>>();
        let solved = value["accelerations"].as_array().into_iter().flatten();
        Self {
            name: text(&value["formulation"]),
            rows: texts("rows"),
            unknowns: texts("unknowns"),
            rate_count: texts("coordinate_rates").len(),
            solved: solved.map(|step| text(&step["name"])).collect(),
        }
    }

    /// Returns the name of an identity about these equations.
    fn identity(&self, parts: &[&str]) -> IdentityName {
        std::iter::once(self.name.as_str()).chain(parts.iter().copied()).map(str::to_owned).collect()
    }
}
