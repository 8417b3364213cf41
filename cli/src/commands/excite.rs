//! Command `tripos excite`: designs a motion from which base parameters can be estimated well.

use super::identify::combination;
use crate::arguments::Excite as Request;
use crate::files::output_files::{refuse_overwriting_inputs, write_table_file, write_text_file};
use crate::files::workspace::{read_model, short_name};
use crate::terminal::failure::{Failure, print, print_json, status, warn};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::Mechanism;
use tripos::fit::excitation::{Excitation, ExcitationOptions, design_excitation};
use tripos::studies::identification::identify;
use tripos_derive::identify::Identification;
use tripos_derive::mechanics::RegressorParameters;
use tripos_derive::plain_text::with_reliable_digits;

/// Design of a motion, with all that its words need.
struct Answer<'a> {
    /// Model of the mechanism.
    model: &'a Mechanism,
    /// Base parameters of the model.
    found: &'a Identification,
    /// Options of the design.
    options: &'a ExcitationOptions,
    /// Designed motion.
    motion: &'a Excitation,
}

/// Runs `tripos excite`: designs a motion, prints it, and writes its table. Returns the exit status: 1 if the motion
/// leaves a combination of base parameters open.
///
/// # Errors
/// `Failure` if the model or an option has errors, or if no motion is found.
pub fn excite(request: &Request) -> Result<u8, Failure> {
    let model = read_model(&request.model)?;
    refuse_overwriting_inputs(&model, None, request.write.as_deref())?;
    let options = request.design_options()?;
    let varied = if request.declared { RegressorParameters::Declared } else { RegressorParameters::Bodies };
    let found = identify(&model, varied)?;
    let motion = design_excitation(&model, &found, &options)?;
    if !motion.unchecked.is_empty() {
        warn(&format!(
            "conditions of the domain that a motion alone does not decide are not checked: {}",
            motion.unchecked.join(", ")
        ));
    }
    let answer = Answer { model: &model, found: &found, options: &options, motion: &motion };
    if let Some(path) = &request.write {
        answer.write(path)?;
    }
    if request.json {
        print_json(&answer.json())?;
    } else {
        print(&answer.text())?;
    }
    Ok(if motion.information.untold.is_empty() { 0 } else { status::NO })
}

impl Answer<'_> {
    /// Name of a base parameter as a combination of parameters.
    fn name(&self, base: usize) -> String {
        combination(self.found, &self.found.base[base])
    }

    /// Writes the motion to a file: formulas if its name ends in `.toml`, otherwise a table.
    ///
    /// # Errors
    /// `Failure` if the file cannot be written.
    fn write(&self, path: &Path) -> Result<(), Failure> {
        if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml")) {
            return write_text_file(path, &self.formulas());
        }
        let coordinates = self.model.coordinates.iter().map(|c| c.name.clone());
        let speeds = || self.model.speeds.iter().map(|speed| speed.name.clone());
        let rates = speeds().map(|speed| format!("{speed}'"));
        let heads: Vec<String> = ["t".to_owned()].into_iter().chain(coordinates).chain(speeds()).chain(rates).collect();
        let rows = self.motion.samples.iter().map(|sample| {
            let values = sample.q.iter().chain(&sample.u).chain(&sample.rates).map(|x| x.hi());
            sample.t.into_iter().chain(values).map(|x| format!("{x:?}")).collect()
        });
        write_table_file(path, &heads, rows)
    }

    /// Motion as a motion file: a formula of t for each coordinate, and the instants.
    fn formulas(&self) -> String {
        let mut out = "[motion]\n".to_owned();
        for (coordinate, series) in self.model.coordinates.iter().zip(&self.motion.series) {
            let _ = writeln!(out, "{} = \"{}\"", coordinate.name, series.formula(self.options.period));
        }
        let _ = write!(out, "[times]\nfrom = 0\nto = {}\ncount = {}\n", self.options.period, self.options.samples);
        out
    }

    /// Returns the answer as text.
    fn text(&self) -> String {
        let Self { model, options, motion, .. } = self;
        let information = &motion.information;
        let mut out = format!(
            "{}: a motion that determines its base parameters\nbest of {} motions in {} searches; a better one may exist\n\n{}\n",
            model.title,
            motion.tried,
            options.starts,
            self.formulas()
        );
        let _ = writeln!(out, "extreme values at all instants, and limits, in SI units");
        for extremes in &motion.extremes {
            let number = |x: f64| with_reliable_digits(x, None);
            let _ = write!(out, "  {}: {} to {}", extremes.name, number(extremes.least), number(extremes.largest));
            let _ = match (extremes.low, extremes.high) {
                (Some(low), Some(high)) => writeln!(out, ", limits {} to {}", number(low), number(high)),
                (Some(low), None) => writeln!(out, ", at least {}", number(low)),
                (None, Some(high)) => writeln!(out, ", at most {}", number(high)),
                (None, None) => writeln!(out, ", no limit"),
            };
        }
        for (name, least) in &motion.conditions {
            let _ = writeln!(
                out,
                "  condition {name}: its term is at least {} in SI units, and must be above 0",
                with_reliable_digits(*least, None)
            );
        }
        let counted: Vec<usize> = (0..information.is_counted.len()).filter(|at| information.is_counted[*at]).collect();
        let _ = writeln!(
            out,
            "\nregressor W of {} forces: rank {} of {} base parameters\nlog det of W' S^-1 W = {}, S the covariance of the forces, SI units{}\ncondition number of W with columns of length 1: {}",
            information.equations,
            information.rank,
            information.errors.len(),
            with_reliable_digits(information.log_determinant, None),
            if counted.len() == information.errors.len() {
                String::new()
            } else {
                format!(", of {} independent columns", counted.len())
            },
            with_reliable_digits(information.condition, None)
        );
        let forces = if options.noise.is_empty() { "of standard deviation 1" } else { "with the given noise" };
        let _ = writeln!(out, "\nstandard errors of the base parameters from forces {forces}");
        for (at, error) in information.errors.iter().enumerate() {
            let unit = &self.found.regressor.columns[self.found.base[at].column].unit;
            let _ = match error {
                Some(error) => writeln!(out, "  {}: {} {unit}", self.name(at), with_reliable_digits(*error, None)),
                None => writeln!(out, "  {}: not determined by the motion", self.name(at)),
            };
        }
        for direction in &information.untold {
            let parts: Vec<String> = direction
                .iter()
                .map(|(at, rate)| format!("{} changes by {}", self.name(*at), with_reliable_digits(*rate, None)))
                .collect();
            let _ = writeln!(out, "not determined by the motion: no force changes if {}", parts.join(" and "));
        }
        out
    }

    /// Returns the answer as JSON.
    fn json(&self) -> Value {
        let Self { model, options, motion, .. } = self;
        let information = &motion.information;
        let series = model.coordinates.iter().zip(&motion.series).map(|(coordinate, series)| {
            json!({
                "coordinate": coordinate.name, "formula": series.formula(options.period), "mean": series.mean,
                "sines": series.sines, "cosines": series.cosines,
            })
        });
        let limits = motion.extremes.iter().map(|extremes| {
            json!({
                "quantity": extremes.name, "least": extremes.least, "largest": extremes.largest,
                "low": extremes.low, "high": extremes.high,
            })
        });
        let base = information.errors.iter().enumerate().map(|(at, error)| {
            let unit = self.found.regressor.columns[self.found.base[at].column].unit.to_string();
            json!({
                "combination": self.name(at), "unit": unit, "error": error, "counted": information.is_counted[at],
            })
        });
        let untold = information
            .untold
            .iter()
            .map(|direction| direction.iter().map(|(at, rate)| json!([self.name(*at), rate])).collect::<Value>());
        let conditions = motion.conditions.iter().map(|(name, least)| json!({ "name": name, "least": least }));
        json!({
            "model": short_name(model),
            "period": options.period,
            "harmonics": options.harmonics,
            "samples": options.samples,
            "motion": series.collect::<Vec<_>>(),
            "limits": limits.collect::<Vec<_>>(),
            "conditions": conditions.collect::<Vec<_>>(),
            "unchecked": motion.unchecked,
            "equations": information.equations,
            "rank": information.rank,
            "log_determinant": information.log_determinant,
            "condition": information.condition,
            "base": base.collect::<Vec<_>>(),
            "untold": untold.collect::<Vec<_>>(),
            "tried": motion.tried,
            "starts": options.starts,
            "seed": options.seed,
        })
    }
}
