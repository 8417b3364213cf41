//! Settings of a scene's integration: integrator, solution for the accelerations, tolerances, steps, and integrated
//! variables.

use crate::algebra::Rational;
use crate::algebra::value::rational_value::rational_value_of_pi;
use crate::diagnostic::{UnknownName, nearest_name_advice};
use crate::mechanics::SingularDistance;
use crate::scene::numbers::number_reader::ValueReader;
use crate::scene::numbers::scene_number::Number;
use std::fmt;
use std::ops::RangeInclusive;
use std::str::FromStr;
use toml::de::{DeTable, DeValue};
use tripos_traits::{ATOL, AbsoluteTolerance, Method, RTOL};

/// Names of the methods that solve for accelerations, in the order of [`AccelerationSolution::ALL`].
pub(crate) const SOLVES: [&str; AccelerationSolution::ALL.len()] =
    [AccelerationSolution::ALL[0].name(), AccelerationSolution::ALL[1].name()];

/// Integrator of a run: a stepping method or quadrature.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Integrator {
    /// Stepping method, such as a Runge–Kutta method.
    Steps(Method),
    /// Quadrature: evaluates the integrals of reduced equations with one degree of freedom, exact to rounding,
    /// without steps.
    Quadrature,
}

impl Integrator {
    /// Names of all integrators: the stepping methods in the order of [`Method::ALL`], then quadrature.
    pub const NAMES: [&str; Method::ALL.len() + 1] = {
        let mut names = [Self::Quadrature.name(); Method::ALL.len() + 1];
        let mut at = 0;
        while at < Method::ALL.len() {
            names[at] = Method::ALL[at].name();
            at += 1;
        }
        names
    };

    /// Name of the integrator on the command line and in scene files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Steps(method) => method.name(),
            Self::Quadrature => "quadrature",
        }
    }

    /// Stepping method of a run; `None` for quadrature.
    #[must_use]
    pub const fn method(self) -> Option<Method> {
        match self {
            Self::Steps(method) => Some(method),
            Self::Quadrature => None,
        }
    }
}

impl Default for Integrator {
    fn default() -> Self {
        Self::Steps(Method::default())
    }
}

impl From<Method> for Integrator {
    fn from(method: Method) -> Self {
        Self::Steps(method)
    }
}

impl fmt::Display for Integrator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Integrator {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let methods = Method::ALL.into_iter().map(Self::Steps);
        let found = methods.chain([Self::Quadrature]).find(|integrator| integrator.name() == name);
        found.ok_or_else(|| UnknownName::new(format!("there is no method `{name}`"), name, Self::NAMES))
    }
}

/// Method that solves the equations of motion for the accelerations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum AccelerationSolution {
    /// Formulas in closed form, from an elimination when the equations are derived.
    #[default]
    Eliminated,
    /// Numeric solution of the linear system M u̇ = f in each state of the run.
    Numeric,
}

impl AccelerationSolution {
    /// Both methods that solve for accelerations, in the order in which users see them.
    pub const ALL: [Self; 2] = [Self::Eliminated, Self::Numeric];

    /// Name of the solution method on the command line and in scene files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Eliminated => "eliminated",
            Self::Numeric => "numeric",
        }
    }
}

impl FromStr for AccelerationSolution {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        Self::ALL.into_iter().find(|solve| solve.name() == name).ok_or_else(|| {
            UnknownName::new(format!("accelerations are not found by `{name}`"), name, Self::ALL.map(Self::name))
        })
    }
}

/// Invariant of the motion onto which each step of a run is projected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProjectionTarget {
    /// Total energy, which projection keeps at its value at the start of the run.
    Energy,
}

impl ProjectionTarget {
    /// All invariants onto which runs can be projected, in the order in which users see them.
    pub const ALL: [Self; 1] = [Self::Energy];

    /// Name of the invariant on the command line and in scene files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Energy => "energy",
        }
    }
}

impl FromStr for ProjectionTarget {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        Self::ALL.into_iter().find(|project| project.name() == name).ok_or_else(|| {
            UnknownName::new(format!("runs are not projected onto `{name}`"), name, Self::ALL.map(Self::name))
        })
    }
}

/// Settings of a scene's integration: integrator, tolerances, steps, samples and integrated
/// variables.
#[derive(Clone, Debug, PartialEq)]
pub struct Integration {
    /// Integrator of the run: a stepping method or quadrature.
    pub method: Integrator,
    /// Method that solves for the accelerations. `None` lets the program choose it for the model.
    pub solve: Option<AccelerationSolution>,
    /// Relative tolerance for the error of a step, without unit.
    pub rtol: f64,
    /// Absolute tolerance for the error of a step, in the SI units of coordinates and speeds.
    pub atol: AbsoluteTolerance,
    /// Fixed length of every step, s; `None` if error control chooses the lengths.
    pub step: Option<f64>,
    /// Longest step that error control may choose, s. `None` leaves the limit to the method.
    pub max_step: Option<f64>,
    /// Largest number of steps that a run may attempt. A run that needs more fails.
    pub step_limit: u64,
    /// Number of equally spaced samples of the output, ends included. `None` gives four points in each step.
    pub samples: Option<usize>,
    /// Instants of the samples, s, which a program sets in place of equally spaced ones, in the order of the run. Empty
    /// for the samples that `samples` states.
    pub instants: Vec<f64>,
    /// True if the run ends at the border of the model's domain. False if the run continues and reports the crossing.
    pub domain_stops: bool,
    /// Invariant onto which each step is projected; `None` for no projection.
    pub project: Option<ProjectionTarget>,
    /// Distance of a coordinate from a right angle, which is integrated in place of the coordinate. `None` if the
    /// scene file states none.
    pub distance: Option<SingularDistance>,
    /// True if the scene's reduced equations may integrate a distance in place of a coordinate. False if the scene
    /// file has `distance = "none"`.
    pub may_measure: bool,
}

/// Permitted numbers of samples of a run, both ends included.
pub const SAMPLES: RangeInclusive<u64> = 2..=10_000_000;
/// Permitted limits on the number of attempted steps of a run.
pub const STEP_LIMITS: RangeInclusive<u64> = 1..=1_000_000_000;

/// Keys of the section `[integration]` of a scene file.
const KEYS: [&str; 11] =
    ["method", "solve", "rtol", "atol", "step", "max_step", "step_limit", "samples", "domain", "project", "distance"];

impl<'a> ValueReader<'a, '_> {
    /// Reads the section `[integration]` of a scene file. Settings that the file does not state have their defaults.
    /// Wrong settings are reported.
    pub fn integration(&mut self, table: &'a DeTable<'a>, p: &[Number]) -> Integration {
        let section = self.section(table, "integration");
        if let Some(section) = section {
            self.reader.report_unknown_keys(section, "`integration`", &KEYS);
        }
        let rtol = self.nonnegative_integration_number(section, "rtol", p).unwrap_or(RTOL);
        let atol = self.absolute_tolerance(section, p);
        if rtol == 0.0 && atol == AbsoluteTolerance::Uniform(0.0) {
            let help = "give at least one tolerance above zero";
            // The defaults are above zero, so that the section states both.
            let place = section.and_then(|section| self.reader.get(section, "atol")).map(toml::Spanned::span);
            self.reader.error(place.unwrap_or_default(), "rtol and atol are both zero", help);
        }
        let project = self.choice(section, "project", &ProjectionTarget::ALL.map(ProjectionTarget::name));
        let solve = self.choice(section, "solve", &SOLVES);
        let method = self.choice(section, "method", &Integrator::NAMES);
        let method = method.and_then(|name| name.parse().ok()).unwrap_or_default();
        let given = |key: &str| section.and_then(|s| s.get(key));
        if let (Some(_), Some(longest)) = (given("step"), given("max_step")) {
            let help = "leave one of the two out";
            let message = "`step` gives the length of every step: leave `max_step` out";
            self.reader.error(longest.span(), message, help);
        }
        if method == Integrator::Quadrature {
            let steps = "takes no steps";
            for (key, what) in [("step", steps), ("max_step", steps), ("project", "keeps the energy by itself")] {
                if let Some(value) = section.and_then(|s| self.reader.get(s, key)) {
                    let help = format!("leave `{key}` out, or give a stepping method");
                    self.reader.error(value.span(), format!("quadrature {what}: `{key}` means nothing"), help);
                }
            }
        }
        Integration {
            method,
            solve: solve.and_then(|name| name.parse().ok()),
            rtol,
            atol,
            step: self.step(section, "step", p),
            max_step: self.step(section, "max_step", p),
            step_limit: self.integration_count(section, "step_limit", STEP_LIMITS).unwrap_or(1_000_000),
            samples: self.integration_count(section, "samples", SAMPLES).and_then(|n| usize::try_from(n).ok()),
            instants: Vec::new(),
            domain_stops: self.choice(section, "domain", &["stop", "watch"]) != Some("watch"),
            project: project.and_then(|name| name.parse().ok()),
            may_measure: !self.refuses_distance(section),
            distance: self.distance(section),
        }
    }

    /// Reads a number under a key that must not be negative. A negative number is reported. `None` if the key is
    /// absent, or if the number has no value.
    fn nonnegative_integration_number(
        &mut self,
        section: Option<&'a DeTable<'a>>,
        key: &str,
        p: &[Number],
    ) -> Option<f64> {
        let value = section.and_then(|s| self.reader.get(s, key))?;
        let formula = self.reader.formula(value, &format!("`{key}`"))?;
        let number = self.number(&formula, p, &format!("`{key}`"))?.double;
        if number < 0.0 {
            self.reader.error(formula.span, format!("`{key}` is negative"), format!("let `{key}` be zero or above"));
        }
        Some(number)
    }

    /// Reads the length of a step under a key, s. A length that is not above zero is reported. `None` if the key is
    /// absent, or if the length has no value.
    fn step(&mut self, section: Option<&'a DeTable<'a>>, key: &str, p: &[Number]) -> Option<f64> {
        let value = section.and_then(|s| self.reader.get(s, key))?;
        let step = self.nonnegative_integration_number(section, key, p)?;
        if step == 0.0 {
            let help = "give the length of a step in seconds, above zero";
            self.reader.error(value.span(), format!("`{key}` is zero"), help);
        }
        Some(step)
    }

    /// Reads the absolute tolerance `atol`: a single number, or a table with an entry for each coordinate and speed.
    /// An entry that is left out has the default value.
    fn absolute_tolerance(&mut self, section: Option<&'a DeTable<'a>>, p: &[Number]) -> AbsoluteTolerance {
        let Some(value) = section.and_then(|s| self.reader.get(s, "atol")) else {
            return AbsoluteTolerance::default();
        };
        if !matches!(value.get_ref(), DeValue::Table(_)) {
            return AbsoluteTolerance::Uniform(self.nonnegative_integration_number(section, "atol", p).unwrap_or(ATOL));
        }
        let coordinates = self.model.coordinates.iter().map(|c| c.name.clone());
        let names: Vec<String> = coordinates.chain(self.model.speeds.iter().map(|s| s.name.clone())).collect();
        let mut each = vec![ATOL; names.len()];
        let Some(table) = self.reader.table(value, "`atol`", "atol = { q1 = 1e-9 }") else {
            return AbsoluteTolerance::Each(each);
        };
        for (name, _) in self.reader.entries(table) {
            match names.iter().position(|known| *known == name.text) {
                Some(at) => each[at] = self.nonnegative_integration_number(Some(table), &name.text, p).unwrap_or(ATOL),
                None => {
                    let (message, help) = self.model.unknown_state_name(&name.text, names.iter().map(String::as_str));
                    self.reader.error(name.span, message, help);
                }
            }
        }
        AbsoluteTolerance::Each(each)
    }

    /// True if the scene file has `distance = "none"`, so that no distance is integrated in place of a coordinate.
    fn refuses_distance(&self, section: Option<&'a DeTable<'a>>) -> bool {
        let value = section.and_then(|s| self.reader.get(s, "distance"));
        value.is_some_and(|v| v.get_ref().as_str() == Some("none"))
    }

    /// Reads `distance = { q2 = "90*deg" }`, with which q2 − 90° is integrated in place of q2. The angle must be a
    /// nonzero multiple of 90°. `None` if the key is absent, or after an error is reported.
    fn distance(&mut self, section: Option<&'a DeTable<'a>>) -> Option<SingularDistance> {
        const HOW: &str = "distance = { q2 = \"90*deg\" }";
        let value = section.and_then(|s| self.reader.get(s, "distance"))?;
        if value.get_ref().as_str() == Some("none") {
            return None;
        }
        let table = self.reader.table(value, "`distance`", HOW)?;
        let entries = self.reader.entries(table);
        let [(name, origin)] = entries.as_slice() else {
            let message = format!("`distance` names {} coordinates, not one", entries.len());
            self.reader.error(value.span(), message, format!("write {HOW}"));
            return None;
        };
        let Some(coordinate) = self.model.coordinates.iter().position(|c| c.name == name.text) else {
            let help = nearest_name_advice(&name.text, self.model.coordinates.iter().map(|c| c.name.as_str()));
            self.reader.error(name.span.clone(), format!("the model has no coordinate `{}`", name.text), help);
            return None;
        };
        let formula = self.reader.formula(origin, "the origin of a distance")?;
        let exact = self.constant(&formula)?.exact;
        // The exact value has only finitely many decimals of π. So a multiple of 90° is recognized within 1e-15 of a
        // quarter turn.
        let quarter = rational_value_of_pi().reciprocal().map(|inverse| Rational::integer(2).mul(&inverse));
        let turns = exact.zip(quarter).map(|(origin, quarter)| origin.mul(&quarter).to_f64());
        let found = (-4..=4).find(|k| *k != 0 && turns.is_some_and(|t| (t - f64::from(*k)).abs() < 1e-15));
        if found.is_none() {
            let help = "give 90, 180, 270 or 360 degrees, or their negatives: there sines or cosines vanish exactly";
            self.reader.error(formula.span, "the origin of a distance is not a multiple of a right angle", help);
        }
        found.map(|quarter_turns| SingularDistance { coordinate, quarter_turns })
    }

    /// Reads a key whose value must be one of the words `allowed`. `None` if the key is absent, or
    /// after an error is reported.
    pub fn choice(
        &mut self,
        section: Option<&'a DeTable<'a>>,
        key: &str,
        allowed: &[&'static str],
    ) -> Option<&'static str> {
        let value = section.and_then(|s| self.reader.get(s, key))?;
        let text = self.reader.string(value, &format!("`{key}`"))?;
        let found = allowed.iter().find(|a| **a == text.text).copied();
        if found.is_none() {
            let help = crate::diagnostic::nearest_name_advice(&text.text, allowed.iter().copied());
            self.reader.error(text.span, format!("`{}` is not a value of `{key}`", text.text), help);
        }
        found
    }

    /// Reads a whole number from `least` to `most` under a key. `None` if the key is absent, or after
    /// an error is reported.
    pub fn integration_count(
        &mut self,
        section: Option<&'a DeTable<'a>>,
        key: &str,
        range: RangeInclusive<u64>,
    ) -> Option<u64> {
        let value = section.and_then(|s| self.reader.get(s, key))?;
        let number = match value.get_ref() {
            DeValue::Integer(n) if n.radix() == 10 => n.as_str().replace('_', "").parse::<u64>().ok(),
            _ => None,
        };
        let number = number.filter(|n| range.contains(n));
        if number.is_none() {
            let help = format!("write a whole number from {} to {}", range.start(), range.end());
            self.reader.error(value.span(), format!("`{key}` is out of range"), help);
        }
        number
    }
}
