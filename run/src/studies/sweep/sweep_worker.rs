//! Runs of a sweep in blocks of points. Each block is run by one thread.

use super::full_equations::FullEquations;
use super::lanes::{self, LaneRequest, lane_equations};
use super::own_equations::OwnPoint;
use super::point_problem::PointProblem;
use super::sweep_row::{RunEnd, SweepRow};
use super::swept_scene::Sweep;
use crate::error::Error;
use crate::integration_options::{integration_options, integration_options_for_ends};
use crate::preparation::problem::Problem;
use crate::simulation::simulate::reaches_as_far;
use crate::trust::watched_functions::WatchedFunctions;
use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use tripos_derive::scene::{Family, Scene};
use tripos_sim::{Options, Solution, Stop};
use tripos_traits::InLanes;

/// Worker of one thread, which runs its share of the points of a sweep.
pub struct SweepWorker<'a> {
    /// Data that all threads share.
    sweep: &'a Sweep<'a>,
    /// Reader that makes the scene of each point from the scene and the grid.
    family: Family<'a>,
}

/// Scene of a point with the equations by which it runs.
struct SweptPoint<'s> {
    /// Scene of the point as a file would state it.
    scene: &'s Scene,
    /// Scene in the variables of its reduced equations; `None` if the point runs by full equations.
    own: Option<OwnPoint>,
}

/// Equations in lanes for some points of a block.
struct Lanes<'s> {
    /// Equations that compute several runs at once in vector registers (lanes).
    equations: InLanes<'static>,
    /// Events and domain conditions that each run watches.
    balance: &'s WatchedFunctions,
    /// Indices of the points in the block, counted from 0.
    places: Vec<usize>,
    /// Requests of these points, in the same order.
    requests: Vec<LaneRequest<'s>>,
}

impl<'a> Sweep<'a> {
    /// Makes a worker, which has the data that one thread needs for itself.
    ///
    /// # Errors
    /// [`Error`] if the text of the scene cannot be read again.
    pub fn make_worker(&'a self) -> Result<SweepWorker<'a>, Error> {
        Ok(SweepWorker { sweep: self, family: Family::new(&self.scene, self.model, self.grid)? })
    }
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
        let (mut rows, mut scenes) = (Vec::new(), Vec::new());
        for (point, values, scene) in points.map(read) {
            rows.push((point, values));
            scenes.push(scene);
        }
        let scenes = scenes.iter().map(|scene| scene.as_ref().map_err(Error::clone));
        let swept: Vec<_> = scenes.map(|scene| self.swept_point(scene?)).collect();
        let solutions = self.solve_in_lanes(&swept);
        let mut done_rows = Vec::new();
        for (((point, values), swept), solution) in rows.into_iter().zip(&swept).zip(solutions) {
            if self.sweep.stop.load(Ordering::Relaxed) {
                break;
            }
            let outcome = match swept {
                Ok(swept) => self.run_point(swept, solution).map_err(|failure| failure_reason(&failure)),
                Err(error) => Err(failure_reason(error)),
            };
            if self.sweep.model.follow.is_interrupted() {
                // The last run may have been cut short.
                break;
            }
            done_rows.push(SweepRow { point, values, outcome });
            done();
        }
        done_rows
    }

    /// Chooses the equations by which the scene of a point runs.
    ///
    /// # Errors
    /// `Error` if a moving body has no mass at the point's parameters, or if the point needs reduced equations and
    /// has none.
    fn swept_point<'s>(&self, scene: &'s Scene) -> Result<SweptPoint<'s>, Error> {
        let Sweep { model, inertia, own, full, .. } = self.sweep;
        inertia.at(&scene.exact.rational).map_err(|error| Error::Input(model.diagnose(&error)))?;
        let Some(equations) = own else { return Ok(SweptPoint { scene, own: None }) };
        let own = equations.point(scene).and_then(|own| {
            let singular = own.problem(model, scene)?.reason_start_is_singular()?;
            singular.map_or(Ok(own), |why| Err(Error::Stopped(format!("the run cannot start: {why}"))))
        });
        match own {
            Ok(own) => Ok(SweptPoint { scene, own: Some(own) }),
            Err(error) if full.is_empty() => Err(error),
            Err(_) => Ok(SweptPoint { scene, own: None }),
        }
    }

    /// Computes the solutions of the points that can run together in lanes. `None` for a point that
    /// cannot.
    fn solve_in_lanes(&self, points: &[Result<SweptPoint<'_>, Error>]) -> Vec<Option<Solution>> {
        let mut solutions: Vec<Option<Solution>> = points.iter().map(|_| None).collect();
        // Correct digits need whole runs with samples, which lanes do not give.
        if self.sweep.tells_digits {
            return solutions;
        }
        let mut left: Vec<(usize, &SweptPoint<'_>)> =
            points.iter().enumerate().filter_map(|(at, point)| Some((at, point.as_ref().ok()?))).collect();
        while let Some((_, first)) = left.first().copied() {
            let (together, others) = left.into_iter().partition(|(_, point)| has_equal_equations(first, point));
            left = others;
            let Some(Lanes { equations, balance, places, requests }) = self.lanes(together) else { continue };
            for (at, solution) in places.into_iter().zip(lanes::run_lanes(equations, balance, &requests)) {
                solutions[at] = solution;
            }
        }
        solutions
    }

    /// Collects points with equal equations for a run in lanes. `None` if none of them can be run in lanes.
    fn lanes<'s>(&'s self, points: Vec<(usize, &'s SweptPoint<'s>)>) -> Option<Lanes<'s>> {
        let Sweep { model, inertia, .. } = self.sweep;
        let own = points.first()?.1.own.as_ref();
        let full = if own.is_none() { self.sweep.full_equations().next() } else { None };
        let balance = own.map(|own| &own.shared.balance).or(full.map(|full| &full.balance))?;
        let problem = |point: &'s SweptPoint<'s>| match (&point.own, full) {
            (Some(own), _) => own.problem(model, point.scene).ok(),
            (None, Some(full)) => full.problem(model, point.scene, inertia).ok(),
            (None, None) => None,
        };
        let (mut places, mut requests, mut found) = (Vec::new(), Vec::new(), None);
        for (at, point) in points {
            let Some(problem) = problem(point) else { continue };
            let Some(equations) = lane_equations(&problem) else { continue };
            let Some(request) = LaneRequest::new(problem) else { continue };
            found = Some(equations);
            places.push(at);
            requests.push(request);
        }
        Some(Lanes { equations: found?, balance, places, requests })
    }

    /// Runs a point, and returns the results for its row. If `solution` is given, it is the solution of the point's
    /// first equations.
    ///
    /// If reduced equations do not run the point to its end, full equations replace them where they do.
    ///
    /// # Errors
    /// `Error` if the run cannot start.
    fn run_point(&self, point: &SweptPoint<'_>, solution: Option<Solution>) -> Result<RunEnd, Error> {
        let (mut first, mut solution) = (None, solution);
        if let Some(own) = &point.own {
            let row = self.run_own(point.scene, own, solution.take());
            if row.as_ref().is_ok_and(|row| row.failure.is_none()) || self.sweep.model.follow.is_interrupted() {
                return row;
            }
            first = Some(row);
        }
        for full in self.sweep.full_equations() {
            let row = self.run_full(point.scene, full, solution.take());
            let reaches = |row: &RunEnd| match &first {
                Some(Ok(first)) => reaches_as_far(point.scene, row.t_end, first.t_end),
                _ => true,
            };
            if row.as_ref().is_ok_and(|row| row.failure.is_none() && reaches(row)) {
                return row;
            }
            let is_used_up = row.as_ref().is_ok_and(|row| row.stop == Stop::StepLimit { limit: 0 }.code());
            first = first.or(Some(row));
            if is_used_up || self.sweep.model.follow.is_interrupted() {
                break;
            }
        }
        first.unwrap_or_else(|| Err(Error::Stopped("no equations can run this point".to_owned())))
    }

    /// Runs a point by its reduced equations, and returns the results for its row.
    ///
    /// # Errors
    /// `Error` if the run cannot start.
    fn run_own(&self, scene: &Scene, own: &OwnPoint, solution: Option<Solution>) -> Result<RunEnd, Error> {
        let problem = own.problem(self.sweep.model, scene)?;
        let point = PointProblem { problem: &problem, balance: &own.shared.balance, shown: None, solution };
        self.run_end(&point)
    }

    /// Runs a point by full equations, and returns the results for its row.
    ///
    /// # Errors
    /// `Error` if the run cannot start.
    fn run_full(&self, scene: &Scene, full: &FullEquations, solution: Option<Solution>) -> Result<RunEnd, Error> {
        let Sweep { model, inertia, .. } = self.sweep;
        let problem = full.problem(model, scene, inertia)?;
        if solution.is_some() {
            return self.run_end(&full.point(&problem, solution));
        }
        full.run(&problem, &self.options(&problem), |point| self.run_end(point))
    }

    /// Runs a prepared problem, and returns the results for its row.
    ///
    /// # Errors
    /// `Error` if the run cannot start.
    fn run_end(&self, point: &PointProblem<'_, '_>) -> Result<RunEnd, Error> {
        let Sweep { names, tells_digits, .. } = self.sweep;
        point.run_end(names, self.sweep.conserved(), &self.options(point.problem), *tells_digits)
    }

    /// Integration options for the run of a point. Samples are kept only if the number of correct digits
    /// is wanted.
    fn options(&self, problem: &Problem<'_>) -> Options {
        let scene = problem.scene;
        if self.sweep.tells_digits { integration_options(scene) } else { integration_options_for_ends(scene) }
    }
}

/// True if two points run by the same equations.
fn has_equal_equations(a: &SweptPoint<'_>, b: &SweptPoint<'_>) -> bool {
    match (&a.own, &b.own) {
        (Some(a), Some(b)) => Arc::ptr_eq(&a.shared, &b.shared),
        (None, None) => true,
        _ => false,
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
