//! Warnings about a run, such as a tolerance below rounding. A warning does not stop the run.

use std::fmt;

/// Warning about a run, with the numbers that its text shows. A warning does not stop the run.
#[derive(Clone, Debug, PartialEq)]
pub enum Warning {
    /// The relative tolerance was below 100 ε, where ε is that of the run's scalar type, and was raised to 100 ε.
    RtolRaised {
        /// Relative tolerance that the options ask for.
        from: f64,
        /// Relative tolerance that the run used instead: 100 ε.
        to: f64,
    },
    /// The run has no relative tolerance, and a component's absolute tolerance is finer than the rounding
    /// of the component. Step sizes then follow rounding errors: the run takes many steps, which do not
    /// make the result better.
    ToleranceBelowRounding {
        /// Index in the state, from 0, of the component whose tolerance is below its rounding.
        component: usize,
        /// Time at which the tolerance was farthest below rounding, s.
        t: f64,
        /// Absolute value of the component at time `t`, in its unit.
        size: f64,
        /// Spacing of floating-point numbers of the component's size, in its unit.
        spacing: f64,
        /// Largest error that the absolute tolerance allows in the component, in its unit.
        allowed: f64,
        /// Number of attempted steps in which this component had the largest weighted error.
        attempts: u64,
    },
    /// Shorter steps often did not reduce the error. The right-hand side f jumps, has kinks, or contains noise of the
    /// size of the tolerance.
    NotSmooth {
        /// Time at which a shorter step first did not help, s.
        t: f64,
        /// Number of shorter retries of a step whose error did not fall.
        retries: u64,
        /// Number of all attempted steps of the run.
        attempts: u64,
    },
    /// The right-hand side has no value at a point that only the dense output of a step needs. Events and output inside
    /// this step are taken from a cubic through the states and slopes at its ends.
    CoarseInside {
        /// Start time of the first step whose dense output is a cubic for this reason, s.
        t: f64,
    },
    /// The search could not decide if an event function that ends runs crossed zero. The run went on.
    EventUndecided {
        /// Name of the undecided event.
        name: String,
        /// Time of the first place at which the event is undecided, s.
        t: f64,
        /// Number of further undecided places of this event.
        more: usize,
    },
}

impl Warning {
    /// Returns the text of the warning. `names` names the components of the state, in order; a component
    /// without a name is shown by its index.
    #[must_use]
    pub fn warning_text(&self, names: &[String]) -> String {
        let who = |at: usize| names.get(at).map_or_else(|| format!("component {at}"), |name| format!("`{name}`"));
        let mut out = String::new();
        self.write_warning(&mut out, &who).expect("memory takes everything");
        out
    }

    /// Writes the text of the warning to `f`. `who` returns the name of a component of the state from its index.
    fn write_warning(&self, f: &mut impl fmt::Write, who: &dyn Fn(usize) -> String) -> fmt::Result {
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
        self.write_warning(f, &|at| format!("component {at}"))
    }
}
