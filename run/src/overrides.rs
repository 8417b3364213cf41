//! Settings of one run that replace the settings of its scene file.

use crate::equations_name::EquationsName;
use crate::error::Error;
use std::ops::RangeInclusive;
use tripos_derive::scene::{AccelerationSolution, Integrator, ProjectionTarget, SAMPLES, STEP_LIMITS, Scene};

/// Settings of one run that replace the integration settings of its scene. `None` keeps the value of the
/// scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overrides {
    /// Name of the equations of motion to run: `kane`, `lagrange`, `newton-euler`, `printed:ID` or `reduced`.
    /// `None` takes the scene's reduced equations if they have an advantage, and otherwise full equations.
    pub by: Option<EquationsName>,
    /// Method of integration: a stepping method, or quadrature.
    pub method: Option<Integrator>,
    /// Conserved quantity onto which the state is projected after each step, such as the energy.
    pub project: Option<ProjectionTarget>,
    /// Method that finds the accelerations: eliminated beforehand, or solved for numerically in each
    /// step.
    pub solve: Option<AccelerationSolution>,
    /// Constant length of every step, s. The error of the steps is then not controlled.
    pub step: Option<f64>,
    /// Longest step that error control may choose, s.
    pub max_step: Option<f64>,
    /// Relative tolerance of the error of each step, without unit.
    pub rtol: Option<f64>,
    /// Absolute tolerance of the error of each step. It applies to every component of the state, in its own
    /// unit.
    pub atol: Option<f64>,
    /// Largest number of attempted steps.
    pub step_limit: Option<u64>,
    /// Number of equally spaced samples, both ends included.
    pub samples: Option<usize>,
    /// Last instant of the run, s. If it is before the first instant of the scene, the run goes backwards in
    /// time.
    pub until: Option<f64>,
}

impl Overrides {
    /// Replaces settings of the scene by all overrides that are not `None`.
    ///
    /// # Errors
    /// [`Error::Request`] if a step, a tolerance or the end makes a run impossible, or if settings exclude one
    /// another. The scene may then be partly changed.
    pub fn apply_to_scene(&self, scene: &mut Scene) -> Result<(), Error> {
        let how = &mut scene.integration;
        how.method = self.method.unwrap_or(how.method);
        how.solve = self.solve.or(how.solve);
        how.project = self.project.or(how.project);
        for (option, length, place) in
            [("step", self.step, &mut how.step), ("max-step", self.max_step, &mut how.max_step)]
        {
            let Some(length) = length else { continue };
            if !(length.is_finite() && length > 0.0) {
                let help = "give the length of a step in seconds, above zero";
                return Err(Error::request(format!("{option} is {length}"), help.to_owned()));
            }
            *place = Some(length);
        }
        if how.step.is_some() && how.max_step.is_some() {
            let help = "leave the longest step out, or the length of every step";
            return Err(Error::request("where every step has one length, none is longer", help));
        }
        if scene.integration.method == Integrator::Quadrature {
            if scene.integration.step.is_some() {
                let help = "leave the step out, or give a stepping method";
                return Err(Error::request("quadrature takes no steps", help));
            }
            if scene.integration.max_step.is_some() {
                let help = "leave the longest step out, or give a stepping method";
                return Err(Error::request("quadrature takes no steps: none is the longest", help));
            }
            if scene.integration.project.is_some() {
                let help = "leave the projection out, or give a stepping method";
                return Err(Error::request("quadrature keeps the energy by itself: there is nothing to project", help));
            }
        }
        let tolerances = [("rtol", self.rtol), ("atol", self.atol)];
        for (option, value) in tolerances {
            if let Some(value) = value {
                if !value.is_finite() || value < 0.0 {
                    let help = "give a finite number, zero or above";
                    return Err(Error::request(format!("{option} is {value}"), help.to_owned()));
                }
                match option {
                    "rtol" => scene.integration.rtol = value,
                    _ => scene.integration.atol = value.into(),
                }
            }
        }
        if scene.integration.rtol == 0.0 && scene.integration.atol.smallest() == 0.0 {
            let help = "give at least one tolerance above zero";
            return Err(Error::request("rtol and atol are both zero".to_owned(), help.to_owned()));
        }
        if let Some(limit) = self.step_limit {
            check_count("step limit", limit, &STEP_LIMITS)?;
            scene.integration.step_limit = limit;
        }
        if let Some(samples) = self.samples {
            check_count("number of samples", u64::try_from(samples).unwrap_or(u64::MAX), &SAMPLES)?;
            scene.integration.samples = Some(samples);
        }
        if let Some(until) = self.until {
            if !until.is_finite() || until - scene.span.0 == 0.0 {
                let help = format!("the run starts at {}: give another instant", scene.span.0);
                return Err(Error::request(format!("until is {until}"), help));
            }
            scene.span.1 = until;
        }
        Ok(())
    }
}

/// Checks that a number of steps or samples is in its permitted range.
///
/// # Errors
/// [`Error::Request`] if the number is outside the range.
fn check_count(name: &str, count: u64, range: &RangeInclusive<u64>) -> Result<(), Error> {
    if range.contains(&count) {
        return Ok(());
    }
    let help = format!("give a whole number from {} to {}", range.start(), range.end());
    Err(Error::request(format!("the {name} is {count}"), help))
}
