//! Options of `tripos fit` that contain names and numbers.

use super::Fit;
use crate::terminal::failure::Failure;
use std::ops::RangeInclusive;
use tripos::fit::Unknown;

impl Fit {
    /// Reads the standard deviations of measured quantities, each given as `NAME=DEVIATION`.
    ///
    /// # Errors
    /// `Failure` for the first text that is not of this form.
    pub fn named_deviations(&self) -> Result<Vec<(String, f64)>, Failure> {
        let read = |text: &String| {
            let (name, rest) = split_option(text, "--noise", "NAME=DEVIATION, such as theta=0.01")?;
            Ok((name.to_owned(), deviation_of_option(rest, "--noise")?))
        };
        self.noise.iter().map(read).collect()
    }

    /// Reads the unknowns with their bounds and priors.
    ///
    /// # Errors
    /// `Failure` for the first option that is not understood, for a prior of a number that is not fitted, and for a
    /// name that is given twice.
    pub fn unknowns(&self) -> Result<Vec<Unknown>, Failure> {
        let mut list: Vec<Unknown> = Vec::new();
        for text in &self.unknowns {
            let (name, bounds) = match text.split_once('=') {
                None => (text.trim(), f64::NEG_INFINITY..=f64::INFINITY),
                Some((name, bounds)) => (name.trim(), bounds_of_option(text, bounds)?),
            };
            if list.iter().any(|known| known.name == name) {
                return Err(Failure::request(format!("`{name}` is named twice"), "leave one of them out"));
            }
            list.push(Unknown { name: name.to_owned(), bounds, prior: None });
        }
        for text in &self.priors {
            let form = "NAME=VALUE:DEVIATION, such as m=2:0.1";
            let (name, rest) = split_option(text, "--prior", form)?;
            let Some((value, deviation)) = rest.split_once(':') else {
                return Err(Failure::request(
                    format!("`--prior {text}` has no standard deviation"),
                    format!("write --prior {form}"),
                ));
            };
            let Some(unknown) = list.iter_mut().find(|unknown| unknown.name == name) else {
                let help = format!("add `--for {name}`, or leave the prior out");
                return Err(Failure::request(format!("`{name}` has a prior and is not fitted"), help));
            };
            if unknown.prior.is_some() {
                return Err(Failure::request(format!("`{name}` has two priors"), "leave one of them out"));
            }
            unknown.prior = Some((number_of_option(value, "--prior")?, deviation_of_option(deviation, "--prior")?));
        }
        Ok(list)
    }
}

/// Splits an option `NAME=REST`.
///
/// # Errors
/// `Failure` with the form of the option if there is no name or no rest.
pub(super) fn split_option<'a>(text: &'a str, option: &str, form: &str) -> Result<(&'a str, &'a str), Failure> {
    let parts = text.split_once('=').map(|(name, rest)| (name.trim(), rest.trim()));
    parts.filter(|(name, rest)| !name.is_empty() && !rest.is_empty()).ok_or_else(|| {
        Failure::request(format!("`{option} {text}` is not understood"), format!("write {option} {form}"))
    })
}

/// Reads a number of an option.
///
/// # Errors
/// `Failure` if the text is no finite number.
pub(super) fn number_of_option(text: &str, option: &str) -> Result<f64, Failure> {
    text.trim().parse().ok().filter(|x: &f64| x.is_finite()).ok_or_else(|| {
        Failure::request(format!("`{}` in `{option}` is no number", text.trim()), "give a number in SI units")
    })
}

/// Reads a standard deviation of an option.
///
/// # Errors
/// `Failure` if the text is no finite number above 0.
pub(super) fn deviation_of_option(text: &str, option: &str) -> Result<f64, Failure> {
    let deviation = number_of_option(text, option)?;
    if deviation > 0.0 {
        return Ok(deviation);
    }
    Err(Failure::request(
        format!("the standard deviation `{}` in `{option}` is not above 0", text.trim()),
        "give a number above 0",
    ))
}

/// Reads bounds `LOW:HIGH` of an unknown. An empty side has no bound.
///
/// # Errors
/// `Failure` if the text has another form, or if the lower bound is not below the upper one.
fn bounds_of_option(text: &str, bounds: &str) -> Result<RangeInclusive<f64>, Failure> {
    let Some((low, high)) = bounds.split_once(':') else {
        let help = "write --for NAME=LOW:HIGH, such as d=0:1, or d=0: for one bound";
        return Err(Failure::request(format!("`--for {text}` is not understood"), help));
    };
    let side = |text: &str, none: f64| if text.trim().is_empty() { Ok(none) } else { number_of_option(text, "--for") };
    let (low, high) = (side(low, f64::NEG_INFINITY)?, side(high, f64::INFINITY)?);
    if low < high {
        return Ok(low..=high);
    }
    Err(Failure::request(format!("the bounds of `--for {text}` leave no room"), "give the lower bound first"))
}
