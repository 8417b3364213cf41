//! Warnings about a run. They do not stop the run.

use std::fmt;

/// Warning about a run. It does not stop the run.
#[derive(Clone, Debug, PartialEq)]
pub enum Warning {
    /// The relative tolerance was below 100 ε and was raised to 100 ε.
    RtolRaised {
        /// Relative tolerance of the options.
        from: f64,
        /// Relative tolerance that was used instead.
        to: f64,
    },
    /// There is no relative tolerance, and the absolute one of a component is finer than the component's rounding. The
    /// steps follow rounding errors: they are many, and do not make the result better.
    ToleranceBelowRounding {
        /// Index of the component, from 0.
        component: usize,
        /// Time at which the tolerance was farthest below rounding, s.
        t: f64,
        /// Size of the component at that time.
        size: f64,
        /// Spacing of floating-point numbers of that size.
        spacing: f64,
        /// Error of the component that was allowed.
        allowed: f64,
        /// Number of attempted steps that this component decided.
        attempts: u64,
    },
    /// Shorter steps often did not make the error smaller: f jumps, has kinks, or is noise at the size of the
    /// tolerance.
    NotSmooth {
        /// Time at which a shorter step first did not help, s.
        t: f64,
        /// Number of shorter steps that did not help.
        retries: u64,
        /// Number of all attempted steps.
        attempts: u64,
    },
    /// The equations have no value at a point that only the solution inside a step needs: events and output in that
    /// step are those of a cubic through its ends.
    CoarseInside {
        /// Start of the first step that needed a point without a value, s.
        t: f64,
    },
    /// It is not known if an event happened that would have ended the run.
    EventUndecided {
        /// Name of the event.
        name: String,
        /// Time of the first undecided place, s.
        t: f64,
        /// Number of undecided places after the first.
        more: usize,
    },
}

impl Warning {
    /// Text of the warning, with these names for the components of the state.
    #[must_use]
    pub fn described(&self, names: &[String]) -> String {
        let who = |at: usize| names.get(at).map_or_else(|| format!("component {at}"), |name| format!("`{name}`"));
        let mut out = String::new();
        self.say(&mut out, &who).expect("memory takes everything");
        out
    }

    fn say(&self, f: &mut impl fmt::Write, who: &dyn Fn(usize) -> String) -> fmt::Result {
        match self {
            Self::RtolRaised { from, to } => {
                write!(f, "relative tolerance {from:e} is below rounding; raised to {to:e}")
            }
            Self::ToleranceBelowRounding { component, t, size, spacing, allowed, attempts } => write!(
                f,
                "{} is {size:.1e} at t = {t:.6} s, where numbers are {spacing:.1e} apart, yet its error \
                 was to stay below {allowed:.1e}: rounding decided {attempts} steps; raise the absolute tolerance, or \
                 give a relative one",
                who(*component)
            ),
            Self::NotSmooth { t, retries, attempts } => write!(
                f,
                "in {retries} of {attempts} attempted steps, first at t = {t:.6} s, a shorter step did not make the error \
                 smaller: the equations jump there, or are noise at the size of the tolerance"
            ),
            Self::CoarseInside { t } => write!(
                f,
                "the equations have no value at some point of the step from t = {t:.6} s: events and output inside it \
                 are less exact than its ends"
            ),
            Self::EventUndecided { name, t, more } => {
                let rest = if *more == 0 { String::new() } else { format!(", and at {more} places after it") };
                write!(
                    f,
                    "whether `{name}` crosses zero at t = {t} s{rest} is not known: it comes too close to zero, or \
                     varies too fast; the run went on"
                )
            }
        }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.say(f, &|at| format!("component {at}"))
    }
}
