//! Runs of a sweep in blocks of points. Each block is run by one thread.

use super::lanes::{self, LaneRequest};
use super::sweep_row::{RunEnd, SweepRow};
use crate::code::{Code, CodePreparation, runnable_code};
use crate::error::{Error, refused_scene_error};
use crate::integration_options::{integration_options, integration_options_for_ends};
use crate::mechanism::Mechanism;
use crate::overrides::Overrides;
use crate::preparation::problem::Problem;
use crate::simulation::run_problem::prove_integrals_to_watch;
use crate::simulation::shown_quantities::ShownQuantities;
use crate::simulation::simulate::{equations_in_all_rates, simulate_with_changing_speeds};
use crate::trust::correct_digits::estimate_digits;
use crate::trust::watched_functions::{WatchedFunctions, watched_events};
use crate::trust::watched_invariants::WatchedInvariants;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use tripos_derive::mechanics::{EquationsOrigin, InertiaCheck};
use tripos_derive::scene::{AccelerationSolution, Family, Grid, Integrator, Scene};
use tripos_sim::{Event, Options, SimError, Solution, Warning};
use tripos_traits::InLanes;

/// Data of a sweep that all its points and threads share.
pub struct Sweep<'a> {
    /// Mechanism of the scene, the same for all points.
    pub model: &'a Mechanism,
    /// Scene as its file states it, changed by the overrides.
    pub scene: &'a Scene,
    /// Grid of the quantities that vary, with their values.
    pub grid: &'a Grid,
    /// Overrides that replace the integration settings of each point's scene.
    pub by: &'a EquationsOrigin,
    /// Overrides that replace integration settings of each point's scene.
    pub how: &'a Overrides,
    /// First integrals whose changes are reported for each run. `None` if they were not proved, or if the
    /// scene has impacts.
    pub watch: Option<WatchedInvariants>,
    /// Method that finds the accelerations: eliminated beforehand, or solved for numerically at each
    /// state.
    pub solve: AccelerationSolution,
    /// Warnings that hold for the run of every point.
    pub warnings: Vec<String>,
    /// Check that all moving bodies have mass at the parameters of a point.
    inertia: InertiaCheck<'a>,
    /// Names of the quantities that the table shows at the end of each run.
    pub names: Vec<String>,
    /// Equations of motion ready to run, which all threads share.
    pub code: Code,
    /// Equations in the rates of all coordinates, for poses in which the speeds of a constrained
    /// mechanism fail. `None` if there are no such poses.
    rates: Option<Code>,
    /// Events and domain conditions that each run watches.
    balance: WatchedFunctions,
    /// Functions that compute the shown quantities.
    shown: ShownQuantities,
    /// True if a second run of each point determines the number of its correct digits.
    pub tells_digits: bool,
    /// Flag that is set when no more rows are wanted; the threads then stop.
    pub stop: AtomicBool,
}

impl<'a> Sweep<'a> {
    /// Prepares the sweep of a scene over a grid, which was read for this scene. The overrides `how` must
    /// already be applied to the scene.
    ///
    /// # Errors
    /// [`Error`] if these equations and the scene's integrator cannot run any point.
    pub fn new(
        model: &'a Mechanism,
        scene: &'a Scene,
        grid: &'a Grid,
        by: &'a EquationsOrigin,
        how: &'a Overrides,
    ) -> Result<Self, Error> {
        let how_own = scene.integration.method == Integrator::Quadrature || scene.integration.project.is_some();
        if how_own {
            let what = "a sweep runs full equations, which have neither quadrature nor projection".to_owned();
            let help = "give a stepping method, and leave `project` out of the scene".to_owned();
            return Err(Error::request(what, help));
        }
        let code = runnable_code(model, by, scene.integration.distance, CodePreparation::preparation_for_runs(scene))?;
        let balance = WatchedFunctions::new(model, model, scene, by)?;
        let inertia = InertiaCheck::new(model);
        let (solve, warnings, rates) = {
            let problem = Problem::for_scene_of_many(&inertia, model, scene, by, &code, None)?;
            let warnings = try_sweep_step(&problem)?;
            (problem.solve, warnings, equations_in_all_rates(&problem)?)
        };
        // Impacts change the conserved quantities.
        let watch = if scene.impacts.is_empty() { prove_integrals_to_watch(model)? } else { None };
        let shown = ShownQuantities::new(model, scene)?;
        let names = shown.names.clone();
        Ok(Self {
            model,
            scene,
            grid,
            by,
            how,
            watch,
            solve,
            warnings,
            inertia,
            rates,
            names,
            code,
            balance,
            shown,
            tells_digits: false,
            stop: AtomicBool::new(false),
        })
    }

    /// True if T + V is constant in every run: no force without a potential does work, no constraint is
    /// driven, and the scene has no impacts.
    fn conserves_energy(&self) -> bool {
        !self.code.system().has_power() && !self.model.is_driven() && self.scene.impacts.is_empty()
    }

    /// Names of the quantities that are constant in each motion: the proved first integrals. If a model is
    /// too large for the proof, only the energy is named. Empty if no quantity is constant.
    pub fn conserved_names(&self) -> Vec<&str> {
        match &self.watch {
            Some(watch) => watch.integrals.iter().map(|integral| integral.name.as_str()).collect(),
            None if self.conserves_energy() => vec!["energy T + V"],
            None => Vec::new(),
        }
    }

    /// Makes a worker, which has the data that one thread needs for itself.
    ///
    /// # Errors
    /// [`Error`] if the text of the scene cannot be read again.
    pub fn make_worker(&'a self) -> Result<SweepWorker<'a>, Error> {
        let family = Family::new(self.scene, self.model, self.grid)?;
        // Correct digits need whole runs with samples, which lanes do not give.
        let lanes = if self.tells_digits {
            None
        } else {
            lanes::lane_equations(self.model, self.scene, self.solve, &self.code)
        };
        Ok(SweepWorker { sweep: self, family, lanes })
    }
}

/// Tests the integrator with one step from the scene's start. Returns the warnings that hold for every
/// point.
///
/// # Errors
/// `Error` if the integrator cannot run any point.
fn try_sweep_step(problem: &Problem<'_>) -> Result<Vec<String>, Error> {
    // The start of the scene file may be unsuitable for a run although the points of the sweep are suitable.
    let Ok(y0) = problem.start() else { return Ok(Vec::new()) };
    let options = Options { step_limit: 1, ..integration_options_for_ends(problem.scene) };
    match problem.integrate(&y0, &options, &mut []) {
        Err(error @ (SimError::NoStep { .. } | SimError::NoJacobian { .. } | SimError::NoSeries { .. })) => {
            Err(refused_scene_error(problem.scene, &error))
        }
        Err(_) => Ok(Vec::new()),
        Ok(solution) => {
            let raised = solution.warnings.iter().filter(|w| matches!(w, Warning::RtolRaised { .. }));
            Ok(raised.map(ToString::to_string).collect())
        }
    }
}

/// Worker of one thread, which runs its share of the points of a sweep.
pub struct SweepWorker<'a> {
    /// Data that all threads share.
    sweep: &'a Sweep<'a>,
    /// Reader that makes the scene of each point from the scene and the grid.
    family: Family<'a>,
    /// Equations that compute several runs at once in vector registers (lanes); `None` if the runs
    /// cannot use lanes.
    lanes: Option<InLanes<'static>>,
}

impl SweepWorker<'_> {
    /// Runs the points of a block. Returns one row for each point, in order, or fewer rows if the sweep is
    /// stopped. `done` is called after each point.
    ///
    /// The runs of a block may be computed together in lanes, but they share no results.
    pub fn run_block(&mut self, points: Range<u64>, done: &(impl Fn() + ?Sized)) -> Vec<SweepRow> {
        let read = |point: u64| {
            let (values, scene) = self.family.point(point);
            let scene = scene.map_err(Error::from).and_then(|mut scene| {
                self.sweep.how.apply_to_scene(&mut scene)?;
                Ok(scene)
            });
            (point, values, scene)
        };
        let scenes: Vec<_> = points.map(read).collect();
        let solutions = self.solve_in_lanes(scenes.iter().map(|(.., scene)| scene.as_ref().ok()));
        let mut rows = Vec::new();
        for ((point, values, scene), solution) in scenes.into_iter().zip(solutions) {
            if self.sweep.stop.load(Ordering::Relaxed) {
                break;
            }
            let outcome = scene.and_then(|scene| self.run_point(&scene, solution));
            if self.sweep.model.follow.is_interrupted() {
                // The last run may have been cut short.
                break;
            }
            rows.push(SweepRow { point, values, outcome: outcome.map_err(|failure| failure_reason(&failure)) });
            done();
        }
        rows
    }

    /// Computes the solutions of the scenes that can run together in lanes. `None` for a scene that
    /// cannot.
    fn solve_in_lanes<'s>(&self, scenes: impl ExactSizeIterator<Item = Option<&'s Scene>>) -> Vec<Option<Solution>> {
        let mut solutions: Vec<Option<Solution>> = (0..scenes.len()).map(|_| None).collect();
        let Some(equations) = self.lanes else { return solutions };
        let problem = |scene| self.problem(scene).ok();
        let requests = scenes.enumerate().filter_map(|(at, scene)| Some((at, LaneRequest::new(problem(scene?)?)?)));
        let (places, requests): (Vec<usize>, Vec<LaneRequest<'_>>) = requests.unzip();
        for (at, solution) in places.into_iter().zip(lanes::run_lanes(equations, &self.sweep.balance, &requests)) {
            solutions[at] = solution;
        }
        solutions
    }

    /// Makes the problem of a point: its scene with the equations of the sweep.
    ///
    /// # Errors
    /// `Error` if a moving body has no mass at the point's parameters.
    fn problem<'s>(&'s self, scene: &'s Scene) -> Result<Problem<'s>, Error> {
        let Sweep { inertia, model, by, solve, .. } = self.sweep;
        Problem::for_scene_of_many(inertia, model, scene, by, &self.sweep.code, Some(*solve))
    }

    /// Runs the scene of a point, and returns the results for its row. If `solution` is given, it is used
    /// and the scene is not run again.
    ///
    /// # Errors
    /// `Error` if the run cannot start.
    fn run_point(&self, scene: &Scene, solution: Option<Solution>) -> Result<RunEnd, Error> {
        let problem = self.problem(scene)?;
        if let Some(solution) = solution {
            return self.row_results(&problem, &solution, None);
        }
        let Some(rates) = &self.sweep.rates else {
            return self.run_point_with(&problem, |y0, options, events| {
                problem.integrate(y0, options, events).map_err(|error| refused_scene_error(scene, &error))
            });
        };
        let mut watched = watched_events(&problem, &self.sweep.balance);
        match problem.run_in_chosen_speeds_alone(rates, &self.options(scene), &mut watched, None)? {
            Some(solution) => self.run_point_with(&problem, |_, _, _| Ok(solution)),
            None => simulate_with_changing_speeds(&problem, rates, |problem| {
                self.run_point_with(problem, |y0, options, events| problem.solve(y0, options, events, None))
            }),
        }
    }

    /// Integration options for the run of a point. Samples are kept only if the number of correct digits
    /// is wanted.
    fn options(&self, scene: &Scene) -> Options {
        if self.sweep.tells_digits { integration_options(scene) } else { integration_options_for_ends(scene) }
    }

    /// Runs a problem from its start by the function `solve`, and returns the results for its row.
    ///
    /// # Errors
    /// `Error` if the run cannot start, or the errors of `solve`.
    fn run_point_with(
        &self,
        problem: &Problem<'_>,
        solve: impl FnOnce(&[f64], &Options, &mut [Event<'_>]) -> Result<Solution, Error>,
    ) -> Result<RunEnd, Error> {
        let y0 = problem.start()?;
        let Sweep { balance, shown, tells_digits, .. } = self.sweep;
        let options = self.options(problem.scene);
        let mut watched = watched_events(problem, balance);
        let solution = solve(&y0, &options, &mut watched)?;
        drop(watched);
        let values = |problem: &Problem<'_>, t: f64, y: &[f64]| shown.of(problem, t, y);
        let digits =
            if *tells_digits { estimate_digits(problem, &y0, &options, &solution, &values, balance)? } else { None };
        self.row_results(problem, &solution, digits.and_then(|digits| digits.digits_at_end_least()))
    }

    /// Collects the results of a point's run at its end: shown quantities, changes of conserved quantities,
    /// counts and failures. `digits` is the number of correct digits, if known.
    fn row_results(&self, problem: &Problem<'_>, solution: &Solution, digits: Option<f64>) -> Result<RunEnd, Error> {
        let changes = match &self.sweep.watch {
            Some(watch) => watch.changes(problem, solution),
            None if self.sweep.conserves_energy() => {
                let dynamics = problem.dynamics().map_err(|error| refused_scene_error(problem.scene, &error))?;
                vec![dynamics.energy_drift(solution)]
            }
            None => Vec::new(),
        };
        let shown = self.sweep.shown.of(problem, solution.t_end, &solution.y_end)?;
        let failed = solution.stop.is_failure().then(|| solution.stop.described(&problem.variable_names()));
        let without = shown.iter().position(|x| !x.is_finite());
        let missing = || without.map(|at| format!("`{}` has no value at the end", self.sweep.shown.names[at]));
        let exist = |at: usize| {
            let watch = self.sweep.watch.as_ref();
            watch.is_none_or(|watch| watch.integrals_exist(&problem.scene.parameters)[at])
        };
        let lost = changes.iter().enumerate().any(|(at, change)| change.is_nan() && exist(at));
        let unkept = || lost.then(|| "a conserved quantity of this motion is not a finite number".to_owned());
        Ok(RunEnd {
            t_end: solution.t_end,
            stop: solution.stop.code(),
            failure: failed.or_else(missing).or_else(unkept),
            shown,
            steps: solution.steps,
            rejected: solution.rejected,
            evaluations: solution.evaluations,
            changes,
            digits,
        })
    }
}

/// Reason why a point has no run, as text for its row. The texts of several errors are joined by
/// semicolons.
fn failure_reason(failure: &Error) -> String {
    match failure {
        Error::Input(diagnostics) => {
            let messages: Vec<&str> = diagnostics.list.iter().map(|d| d.message.as_str()).collect();
            messages.join("; ")
        }
        Error::Request { what, .. } => what.clone(),
        Error::Stopped(why) => why.clone(),
        other => other.to_string(),
    }
}
