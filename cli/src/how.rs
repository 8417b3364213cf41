//! What the command line may change of the way a scene is run.

use crate::How;
use crate::failure::Failure;
use crate::run::method;
use tripos_derive::scene::{AbsoluteTolerance, Project, QUADRATURE, Scene, Solve};

impl How {
    /// Puts the options of the command line in place of the scene's values.
    ///
    /// # Errors
    /// [`Failure::Request`] for a name that there is not, and for numbers that make no run.
    pub fn change(&self, scene: &mut Scene) -> Result<(), Failure> {
        if let Some(name) = &self.method {
            let known = if name == QUADRATURE { QUADRATURE } else { method(name)?.name() };
            known.clone_into(&mut scene.integration.method);
        }
        if let Some(name) = &self.solve {
            scene.integration.solve = Some(solve(name)?);
        }
        if let Some(name) = &self.project {
            scene.integration.project = Some(project(name)?);
        }
        if let Some(step) = self.step {
            if !(step.is_finite() && step > 0.0) {
                let help = "give the length of a step in seconds, above zero";
                return Err(Failure::Request(format!("--step is {step}"), help.to_owned()));
            }
            scene.integration.step = Some(step);
        }
        if self.step.is_some() && scene.integration.method == QUADRATURE {
            let help = "leave --step out, or give a stepping method";
            return Err(Failure::Request("quadrature takes no steps".to_owned(), help.to_owned()));
        }
        let tolerances = [("--rtol", self.rtol), ("--atol", self.atol)];
        for (option, value) in tolerances {
            if let Some(value) = value {
                if !value.is_finite() || value < 0.0 {
                    let help = "give a finite number, zero or above";
                    return Err(Failure::Request(format!("{option} is {value}"), help.to_owned()));
                }
                match option {
                    "--rtol" => scene.integration.rtol = value,
                    _ => scene.integration.atol = AbsoluteTolerance::Uniform(value),
                }
            }
        }
        if scene.integration.rtol == 0.0 && scene.integration.smallest_atol() == 0.0 {
            let help = "give at least one tolerance above zero";
            return Err(Failure::Request("rtol and atol are both zero".to_owned(), help.to_owned()));
        }
        if let Some(until) = self.until {
            if !until.is_finite() || until - scene.span.0 == 0.0 {
                let help = format!("the run starts at {}: give another instant", scene.span.0);
                return Err(Failure::Request(format!("--until is {until}"), help));
            }
            scene.span.1 = until;
        }
        Ok(())
    }
}

/// What steps are projected onto, by this name.
fn project(name: &str) -> Result<Project, Failure> {
    Project::ALL.into_iter().find(|project| project.name() == name).ok_or_else(|| {
        let help = tripos_derive::diagnostic::nearest(name, Project::ALL.map(Project::name));
        Failure::Request(format!("runs are not projected onto `{name}`"), help)
    })
}

/// How accelerations are found, by this name.
fn solve(name: &str) -> Result<Solve, Failure> {
    Solve::ALL.into_iter().find(|solve| solve.name() == name).ok_or_else(|| {
        let help = tripos_derive::diagnostic::nearest(name, Solve::ALL.map(Solve::name));
        Failure::Request(format!("accelerations are not found by `{name}`"), help)
    })
}
