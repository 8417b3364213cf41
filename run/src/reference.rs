//! Runs that other runs are measured against, and how they were certified.
//!
//! Compiled equations run in twice the precision of a double, eliminated, by DOP853 at tolerances that no double
//! reaches: by two formulations and at two tolerances. What they differ by is how far the reference can be trusted.

use crate::code::{By, Ready, code, compiled_code};
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::problem::Problem;
use crate::run::refused;
use tripos_derive::Formulation;
use tripos_derive::mechanics::Distance;
use tripos_derive::scene::{Scene, Solve};
use tripos_sim::work_precision::{error, larger};
use tripos_sim::{AbsoluteTolerance, Eliminated, Lent, Method, Options, Output, RightHandSide, Solution, integrate};
use tripos_traits::{DoubleDouble, Real, Scalar};

/// States at some instants, known better than any run in doubles knows them.
pub struct Reference {
    /// The instants, s.
    pub times: Vec<f64>,
    /// Coordinates, then generalized speeds, at each.
    pub states: Vec<Vec<DoubleDouble>>,
    /// How far they can be off, as an error of [`error`].
    pub uncertainty: f64,
    /// How they were certified.
    pub how: String,
}

/// The tolerances of the run that is kept and of the one that it is checked by.
const EXTENDED: [f64; 2] = [1e-22, 1e-20];
/// The same in doubles, for equations that are not compiled.
const DOUBLE: [f64; 2] = [1e-13, 1e-12];
/// Steps after which a reference is given up.
const MOST_STEPS: u64 = 5_000_000;

impl Reference {
    /// Of a scene without its events, at these instants in the order of the run.
    ///
    /// # Errors
    /// [`Error`] if no formulation gets there.
    pub fn new(model: &Mechanism, scene: &Scene, times: &[f64]) -> Result<Self, Error> {
        let mut runs: Vec<(String, Vec<Vec<DoubleDouble>>)> = Vec::new();
        let mut extended = true;
        for (at, formulation) in certifiers(model)?.into_iter().enumerate() {
            let (name, states, wide) = run(model, scene, formulation, times, at)?;
            extended &= wide;
            runs.push((name, states));
        }
        let [(first, states), (second, check)] = runs.as_slice() else {
            let help = "give a model that Kane's method or Lagrange's equations can be derived for".to_owned();
            return Err(Error::request("nothing is there to certify a reference with".to_owned(), help));
        };
        let difference = states.iter().zip(check).map(|(a, b)| error(a, b)).fold(0.0, larger);
        // A run in doubles is not known better than to its own rounding, however well two of them agree.
        let floor = if extended { DoubleDouble::EPSILON } else { 1e3 * f64::EPSILON };
        let uncertainty = larger(difference, floor);
        let number = if extended { "double-double (32 digits)" } else { "double" };
        let more = if extended { "" } else { "; the model is not compiled, so errors below that are not told apart" };
        let how = format!("DOP853 in {number}, {first} against {second}: they differ by {difference:.1e}{more}");
        Ok(Self { times: times.to_vec(), states: states.clone(), uncertainty, how })
    }

    /// The last state.
    pub fn end(&self) -> &[DoubleDouble] {
        self.states.last().map_or(&[], Vec::as_slice)
    }
}

/// Two formulations, or one twice.
fn certifiers(model: &Mechanism) -> Result<Vec<Formulation>, Error> {
    let mut list = Vec::new();
    for formulation in [Formulation::Lagrange, Formulation::Kane] {
        match code(model, &By::from(formulation), None, Ready::Solved) {
            Ok(code) if code.system().has_accelerations() => list.push(formulation),
            Ok(_) | Err(Error::Unsupported(_)) => {}
            Err(failure) => return Err(failure),
        }
    }
    list.extend(list.first().copied().filter(|_| list.len() == 1));
    Ok(list)
}

/// The scene in the distance from its singular surface, where the library has one compiled.
fn near(model: &Mechanism, scene: &Scene) -> Option<Distance> {
    tripos_derive::mechanics::distances(model).first().copied().or(scene.integration.distance).filter(|distance| {
        // 32 digits leave enough of a distance that no code was generated for.
        let is_compiled = |distance| compiled_code(model, &By::from(Formulation::Lagrange), distance).is_some();
        !is_compiled(None) || is_compiled(Some(*distance))
    })
}

/// One run: its description, its states, and whether it was made in extended precision.
fn run(
    model: &Mechanism,
    scene: &Scene,
    formulation: Formulation,
    times: &[f64],
    attempt: usize,
) -> Result<(String, Vec<Vec<DoubleDouble>>, bool), Error> {
    let by = By::from(formulation);
    let mut scene = scene.clone();
    scene.integration.distance = near(model, &scene);
    let code = code(model, &by, scene.integration.distance, Ready::Solved)?;
    let problem = Problem::new(model, &scene, &by, &code, Some(Solve::Eliminated))?;
    let tolerance = |list: [f64; 2]| list[attempt.min(1)];
    match (code.extended(), problem.extended_start()) {
        (Some(system), Some((p, y0))) => {
            let mut rhs = Eliminated::new(system, &p).expect("checked to be eliminated, with the model's parameters");
            let rtol = tolerance(EXTENDED);
            let walk = |t0: f64, t1: f64, y: &[DoubleDouble]| {
                integrate(
                    Lent(&mut rhs as &mut dyn RightHandSide<DoubleDouble>),
                    (t0, t1),
                    y,
                    &model.follow.options(&options(rtol)),
                    &mut [],
                )
            };
            let states = along(&scene, times, y0, walk)?;
            let states = times.iter().zip(&states).map(|(t, y)| problem.extended_state(&p, *t, y)).collect();
            Ok((format!("{} at {rtol:.0e}", by.name), states, true))
        }
        _ => {
            let rtol = tolerance(DOUBLE);
            let walk = |t0: f64, t1: f64, y: &[f64]| problem.integrate_over((t0, t1), y, &options(rtol), &mut []);
            let states = along(&scene, times, problem.start()?, walk)?;
            let wide =
                |(t, y): (&f64, &Vec<f64>)| problem.state(*t, y).into_iter().map(DoubleDouble::from_f64).collect();
            Ok((format!("{} at {rtol:.0e}", by.name), times.iter().zip(&states).map(wide).collect(), false))
        }
    }
}

fn options(rtol: f64) -> Options {
    let method = Method::Dop853;
    let atol = AbsoluteTolerance::Uniform(rtol);
    Options { method, rtol, atol, step_limit: MOST_STEPS, output: Output::Ends, ..Options::default() }
}

/// From instant to instant: each is the end of a run, where the solution is as good as the tolerance.
fn along<S: Real>(
    scene: &Scene,
    times: &[f64],
    start: Vec<S>,
    mut walk: impl FnMut(f64, f64, &[S]) -> Result<Solution<S>, tripos_sim::SimError>,
) -> Result<Vec<Vec<S>>, Error> {
    let (mut t, mut y) = (scene.span.0, start);
    let mut states = Vec::new();
    for &next in times {
        if next - t != 0.0 {
            let solution = walk(t, next, &y).map_err(|error| refused(scene, &error))?;
            if solution.stop.is_failure() {
                return Err(Error::Stopped(format!("the reference run {solution}")));
            }
            (t, y) = (next, solution.y_end);
        }
        states.push(y.clone());
    }
    Ok(states)
}
