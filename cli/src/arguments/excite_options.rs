//! Options of `tripos excite` that contain names and numbers.

use super::Excite;
use super::fit_options::{deviation_of_option, number_of_option, split_option};
use crate::terminal::failure::Failure;
use tripos::fit::excitation::{ExcitationOptions, QuantityLimit};

/// Number of samples for each period of the highest harmonic, if the user states none.
const SAMPLES: usize = 20;

impl Excite {
    /// Reads the options of the design.
    ///
    /// # Errors
    /// `Failure` for the first text that is not understood, and for a name that is given twice.
    pub fn design_options(&self) -> Result<ExcitationOptions, Failure> {
        let limits = self.limits.iter().map(|text| limit_of_option(text)).collect::<Result<Vec<_>, Failure>>()?;
        check_twice("--limit", limits.iter().map(|limit| limit.name.as_str()))?;
        let home = self.home.iter().map(|text| {
            let (name, value) = split_option(text, "--home", "NAME=VALUE, such as q1=0")?;
            Ok((name.to_owned(), number_of_option(value, "--home")?))
        });
        let home = home.collect::<Result<Vec<_>, Failure>>()?;
        check_twice("--home", home.iter().map(|(name, _)| name.as_str()))?;
        let noise = self.noise.iter().map(|text| {
            let (name, value) = split_option(text, "--noise", "NAME=DEVIATION, such as \"force(u1)=0.1\"")?;
            Ok((name.to_owned(), deviation_of_option(value, "--noise")?))
        });
        let noise = noise.collect::<Result<Vec<_>, Failure>>()?;
        check_twice("--noise", noise.iter().map(|(name, _)| name.as_str()))?;
        Ok(ExcitationOptions {
            period: self.period,
            harmonics: self.harmonics,
            samples: self.samples.unwrap_or_else(|| self.harmonics.saturating_mul(SAMPLES).saturating_add(1)),
            starts: self.starts,
            seed: self.seed,
            limits,
            is_at_rest: self.rest,
            home,
            noise,
        })
    }
}

/// Reads a limit `NAME=LOW:HIGH`, or `NAME=MAX` for a range from −MAX to MAX. An empty side has no limit.
///
/// # Errors
/// `Failure` if the text has another form, or if the lower limit is above the upper one.
fn limit_of_option(text: &str) -> Result<QuantityLimit, Failure> {
    let form = "NAME=LOW:HIGH or NAME=MAX, such as q1=-1:1 or \"q1'=2\"";
    let (name, range) = split_option(text, "--limit", form)?;
    let side =
        |text: &str, none: f64| if text.trim().is_empty() { Ok(none) } else { number_of_option(text, "--limit") };
    let (low, high) = match range.split_once(':') {
        Some((low, high)) => (side(low, f64::NEG_INFINITY)?, side(high, f64::INFINITY)?),
        None => {
            let largest = number_of_option(range, "--limit")?;
            (-largest, largest)
        }
    };
    if low > high {
        let what = format!("the limits of `--limit {text}` exclude one another: {low} is above {high}");
        return Err(Failure::request(what, "give the lower limit first, and a largest size that is not negative"));
    }
    Ok(QuantityLimit { name: name.to_owned(), low, high })
}

/// Checks that no name is given twice to an option.
///
/// # Errors
/// `Failure` for the first name that is.
fn check_twice<'a>(option: &str, names: impl Iterator<Item = &'a str>) -> Result<(), Failure> {
    let mut known = Vec::new();
    for name in names {
        if known.contains(&name) {
            return Err(Failure::request(format!("`{option}` names `{name}` twice"), "leave one of them out"));
        }
        known.push(name);
    }
    Ok(())
}
