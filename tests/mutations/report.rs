//! Report files as text, and what Tripos finds in them.

use super::printed::{System, read};
use rustc_hash::FxHashMap;
use std::fmt::Write;
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::{Difference, Finding, judge_publication};
use tripos_derive::mechanics::derive_all;
use tripos_derive::prove::prove;
use tripos_derive::publication::load_publication;

/// A report file under construction.
#[derive(Default)]
pub struct Report {
    text: String,
}

impl Report {
    /// Adds a value of a quantity.
    pub fn equation(&mut self, id: &str, quantity: &str, printed: &str) {
        let _ = write!(
            self.text,
            "[[equation]]\nid = \"{id}\"\nsection = \"1\"\nquantity = \"{quantity}\"\nprinted = \"{printed}\"\n\n"
        );
    }

    /// Adds rows, right-hand sides last, for the unknowns of a system.
    pub fn system(&mut self, id: &str, system: &System, rows: &[Vec<String>]) {
        let quoted = |list: &[String]| list.iter().map(|e| format!("\"{e}\"")).collect::<Vec<_>>().join(", ");
        let columns = system.unknowns.len();
        let _ = write!(self.text, "[[system]]\nid = \"{id}\"\nsection = \"2\"\n");
        let _ = writeln!(self.text, "formulation = \"{}\"", system.formulation.name());
        if let Some(frame) = &system.frame {
            let _ = writeln!(self.text, "frame = \"{frame}\"");
        }
        let _ = writeln!(self.text, "unknowns = [{}]\nmatrix = [", quoted(&system.unknowns));
        for row in rows {
            let _ = writeln!(self.text, "    [{}],", quoted(&row[..columns]));
        }
        let right: Vec<String> = rows.iter().map(|row| row[columns].clone()).collect();
        let _ = write!(self.text, "]\nright = [{}]\n\n", quoted(&right));
    }

    /// Judges the report, read from its text, on a model of this workspace.
    pub fn judged(&self, model: &str) -> Judged {
        let mut model = read(model);
        let report = load_publication(&Source::from_text("report.toml", &self.text), &mut model)
            .unwrap_or_else(|e| panic!("{e}"));
        let mut derivations = derive_all(&model).unwrap_or_else(|e| panic!("{}", model.diagnose(&e)));
        let proof = prove(&model, &mut derivations);
        let difference = judge_publication(&model, &mut derivations, &report, &proof);
        let findings = difference.findings.iter().map(|f| (f.id.clone(), f.clone())).collect();
        Judged { difference, findings }
    }
}

/// A judged report.
pub struct Judged {
    pub difference: Difference,
    findings: FxHashMap<String, Finding>,
}

impl Judged {
    /// The finding about an entry or row.
    pub fn finding(&self, id: &str) -> &Finding {
        self.findings.get(id).unwrap_or_else(|| panic!("nothing was found of {id}"))
    }
}
