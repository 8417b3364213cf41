//! Full equations of a mechanism for the points of a sweep: a formulation, or printed equations.

use super::point_problem::PointProblem;
use crate::code::{Code, CodePreparation, runnable_code};
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use crate::simulation::shown_quantities::ShownQuantities;
use crate::simulation::simulate::{equations_in_all_rates, simulate_with_changing_speeds};
use crate::trust::watched_functions::{WatchedFunctions, watched_events};
use tripos_derive::mechanics::{EquationsOrigin, InertiaCheck};
use tripos_derive::scene::{AccelerationSolution, Scene};
use tripos_sim::{Options, Solution};

/// Full equations that all points of a sweep share, ready to run.
pub struct FullEquations {
    /// Origin of the equations: a formulation, or a publication.
    pub by: EquationsOrigin,
    /// Equations of motion ready to run, which all threads share.
    pub code: Code,
    /// Method that finds the accelerations: eliminated beforehand, or solved for numerically at each
    /// state.
    pub solve: AccelerationSolution,
    /// Equations in the rates of all coordinates, for poses in which the speeds of a constrained
    /// mechanism fail. `None` if there are no such poses.
    rates: Option<Code>,
    /// Events and domain conditions that each run watches.
    pub balance: WatchedFunctions,
    /// Functions that compute the shown quantities.
    pub shown: ShownQuantities,
}

impl FullEquations {
    /// Prepares the equations `by` for the points of a sweep of this scene.
    ///
    /// # Errors
    /// [`Error`] if the model has no such equations, or if they cannot run the scene.
    pub fn new(
        model: &Mechanism,
        scene: &Scene,
        by: EquationsOrigin,
        inertia: &InertiaCheck<'_>,
    ) -> Result<Self, Error> {
        let code = runnable_code(model, &by, scene.integration.distance, CodePreparation::preparation_for_runs(scene))?;
        let balance = WatchedFunctions::new(model, model, scene, &by)?;
        let (solve, rates) = {
            let problem = Problem::for_scene_of_many(inertia, model, scene, &by, &code, None)?;
            (problem.solve, equations_in_all_rates(&problem)?)
        };
        let shown = ShownQuantities::new(model, scene)?;
        Ok(Self { by, code, solve, rates, balance, shown })
    }

    /// Makes the problem of a point: its scene with these equations.
    ///
    /// # Errors
    /// [`Error`] if a moving body has no mass at the point's parameters.
    pub fn problem<'s>(
        &'s self,
        model: &'s Mechanism,
        scene: &'s Scene,
        inertia: &InertiaCheck<'_>,
    ) -> Result<Problem<'s>, Error> {
        Problem::for_scene_of_many(inertia, model, scene, &self.by, &self.code, Some(self.solve))
    }

    /// Prepares the problem of a point for its run, and returns the result of `finish` for it. The prepared problem
    /// has these equations, or the equations in all rates if the chosen speeds fail on the way.
    ///
    /// # Errors
    /// [`Error`] if the run cannot start, or an error of `finish`.
    pub fn run<T>(
        &self,
        problem: &Problem<'_>,
        options: &Options,
        finish: impl FnOnce(&PointProblem<'_, '_>) -> Result<T, Error>,
    ) -> Result<T, Error> {
        let Some(rates) = &self.rates else { return finish(&self.point(problem, None)) };
        let mut watched = watched_events(problem, &self.balance);
        let alone = problem.run_in_chosen_speeds_alone(rates, options, &mut watched, None)?;
        drop(watched);
        match alone {
            Some(solution) => finish(&self.point(problem, Some(solution))),
            None => simulate_with_changing_speeds(problem, rates, |problem| finish(&self.point(problem, None))),
        }
    }
    /// Problem of a point with the functions of these equations. `solution` is its solution if it is known.
    pub fn point<'b, 'p>(&'b self, problem: &'b Problem<'p>, solution: Option<Solution>) -> PointProblem<'b, 'p> {
        PointProblem { problem, balance: &self.balance, shown: Some(&self.shown), solution }
    }
}
