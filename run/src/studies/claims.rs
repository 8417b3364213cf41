//! Claims about a motion, such as `N > 0`, judged by a rigorous run.

use crate::error::Error;
use tripos_derive::diagnostic::nearest_name_advice;
use tripos_traits::Ball;

/// Claim that a shown quantity stays on one side of a bound.
#[derive(Clone, Debug)]
pub struct Claim {
    /// Claim as it was written.
    pub text: String,
    /// Name of the quantity.
    name: String,
    /// Formula of the bound, as it was written.
    pub(super) bound_text: String,
    /// True for `<`, false for `>`.
    is_below: bool,
    /// Index of the quantity among the shown ones.
    pub(super) quantity: usize,
    /// Bound, in the SI unit of the quantity.
    bound: Ball<f64>,
}

/// Verdict of a rigorous run on a claim.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ClaimVerdict {
    /// Instant up to which the claim is proved, s; `None` if it is not proved at the start.
    pub proved_to: Option<f64>,
    /// Instant by which the claim is proved to be false, s; `None` if it is not proved to be false.
    pub refuted_by: Option<f64>,
    /// True once the claim was not proved over some time, or if the enclosure ended before the span.
    pub(super) is_open: bool,
}

impl ClaimVerdict {
    /// True if the claim is proved over the whole span of the scene.
    #[must_use]
    pub fn is_proved(&self) -> bool {
        !self.is_open && self.proved_to.is_some()
    }
}

impl Claim {
    /// Reads a claim of the form `NAME < FORMULA` or `NAME > FORMULA`, before its names are known.
    ///
    /// # Errors
    /// [`Error::Request`] if the text has another form.
    pub(super) fn parse(text: &str) -> Result<Self, Error> {
        let sign = text.find(['<', '>']).filter(|at| !text[at + 1..].contains(['<', '>', '=']));
        let Some(at) = sign else {
            let help = "write NAME < NUMBER or NAME > NUMBER, such as --claim \"q2 < 90*deg\"";
            return Err(Error::request(format!("the claim `{text}` is not understood"), help));
        };
        Ok(Self {
            text: text.to_owned(),
            name: text[..at].trim().to_owned(),
            bound_text: text[at + 1..].trim().to_owned(),
            is_below: text[at..].starts_with('<'),
            quantity: 0,
            bound: Ball::point(0.0),
        })
    }

    /// The claim about one of the shown quantities, with the value of its bound.
    ///
    /// # Errors
    /// [`Error::Request`] if no quantity has the claim's name.
    pub(super) fn about(self, names: &[String], bound: Ball) -> Result<Self, Error> {
        let Some(quantity) = names.iter().position(|name| *name == self.name) else {
            let advice = nearest_name_advice(&self.name, names.iter().map(String::as_str));
            let help = format!("{advice}; add another quantity to `outputs` of the scene");
            return Err(Error::request(format!("the claim `{}` is about no shown quantity", self.text), help));
        };
        Ok(Self { quantity, bound: Ball::narrowed(bound), ..self })
    }

    /// Ball of the distance by which a value keeps the claim; negative if it breaks the claim.
    fn distance(&self, value: Ball<f64>) -> Ball<f64> {
        if self.is_below { self.bound - value } else { value - self.bound }
    }

    /// True if a value in the ball may keep or break a claim that was proved until now.
    pub(super) fn is_undecided(&self, verdict: ClaimVerdict, value: Ball<f64>) -> bool {
        let distance = self.distance(value);
        !verdict.is_open && distance.low() <= 0.0 && distance.high() > 0.0
    }

    /// Goes on with a verdict: the quantity is in the ball `value` from the last instant to `t`, s.
    pub(super) fn judge(&self, verdict: &mut ClaimVerdict, value: Ball<f64>, t: f64) {
        let distance = self.distance(value);
        if distance.low() > 0.0 && distance.is_defined() {
            if !verdict.is_open {
                verdict.proved_to = Some(t);
            }
            return;
        }
        verdict.is_open = true;
        if distance.is_defined() && distance.high() <= 0.0 && verdict.refuted_by.is_none() {
            verdict.refuted_by = Some(t);
        }
    }
}
