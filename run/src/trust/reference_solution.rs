//! Reference solutions, which serve to measure the errors of other runs.
//!
//! The equations of motion run in numbers of 32 digits, twice the precision of a double, by DOP853
//! with eliminated accelerations. Doubles could not reach the tolerances. Two runs are made, by two
//! formulations and at two tolerances. Their difference is the uncertainty of the reference. Beside it stands what a
//! rigorous run proves of the distance from the exact motion.

use crate::code::{Code, CodePreparation, compiled_code, runnable_code};
use crate::error::{Error, refused_scene_error};
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use crate::rigorous::enclosed_run::{EnclosedInstants, RigorousRequest, enclose_scene};
use tripos_derive::Formulation;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::mechanics::SingularDistance;
use tripos_derive::scene::{
    AccelerationSolution, EnclosedStart, ExactStart, InitialMotion, Scene, default_outputs, enclosed_scene,
};
use tripos_sim::rigorous_run::RigorousOptions;
use tripos_sim::work_precision::work_precision_error;
use tripos_sim::{
    EliminatedDynamics, LentRightHandSide, Method, Options, OutputOption, RightHandSide, SimError, Solution, integrate,
};
use tripos_traits::{Ball, DoubleDouble, Real, Scalar, larger};

/// Reference solution: states at given instants, more accurate than any run in doubles.
pub struct ReferenceSolution {
    /// Instants of the reference states, s.
    pub times: Vec<f64>,
    /// State at each instant of `times`: coordinates, then generalized speeds, in SI units.
    pub states: Vec<Vec<DoubleDouble>>,
    /// Largest error between the two reference runs, measured by [`work_precision_error`]. It is without unit, relative
    /// to the size of the states.
    pub uncertainty: f64,
    /// Largest distance of the states from the exact motion of the scene, as a rigorous run proves it, measured like
    /// [`work_precision_error`]; `None` if none is proved.
    pub proved: Option<f64>,
    /// Text that describes how the reference was certified.
    pub how: String,
}

/// Relative tolerances of the two runs of a reference. The states of the first run are kept. The second
/// run checks them.
const TOLERANCES: [f64; 2] = [1e-22, 1e-20];
/// Number of steps after which the computation of a reference stops as a failure.
const MOST_STEPS: u64 = 5_000_000;
/// Largest distance that is stated as a theorem. A larger one belongs to other numbers than those of the scene's file,
/// or tells nothing of the errors of runs in doubles.
const LARGEST_PROVED: f64 = 1e-12;
/// Number of operations on balls after which no distance is proved: some seconds.
const MOST_OPERATIONS: u64 = 60_000_000;
/// Number of states near the start at which the rates by two formulations are compared.
const STATES: usize = 4;

impl ReferenceSolution {
    /// Computes the reference of a scene at the given instants, s, in the order of the run. Events of the
    /// scene are ignored.
    ///
    /// # Errors
    /// [`Error`] if a run does not reach the last instant, if no formulation has eliminated
    /// accelerations, or if the scene has impacts.
    pub fn new(model: &Mechanism, scene: &Scene, times: &[f64]) -> Result<Self, Error> {
        if !scene.impacts.is_empty() {
            let help = "use the errors that the run prints, or leave the impacts out";
            return Err(Error::request("references in 32 digits know no impacts", help));
        }
        let mut scene = scene.clone();
        scene.integration.distance = distance_for_reference(model, &scene);
        let [first, second] = reference_equations(model, &scene)?;
        let names = [&first, &second].map(|witness| witness.by.name()).into_iter().zip(TOLERANCES);
        let names: Vec<String> = names.map(|(name, rtol)| format!("{name} at {rtol:.0e}")).collect();
        let kept = first.run(model, &scene, times, TOLERANCES[0])?;
        let check = second.run(model, &scene, times, TOLERANCES[1])?;
        let difference = kept.iter().zip(&check).map(|(a, b)| work_precision_error(a, b)).fold(0.0, larger);
        let same = first.runs_the_terms_of(&second, model, &scene)?;
        let more = if same { "; both run the same terms, so that they are one witness at two tolerances" } else { "" };
        let proved = proved_distance(model, &scene, times, &kept).filter(|distance| *distance <= LARGEST_PROVED);
        let theorem = proved.map_or_else(String::new, |distance| {
            format!("; theorem: they are within {distance:.1e} of the exact motion (rigorous run)")
        });
        let how = format!(
            "DOP853 in double-double (32 digits), {}: they differ by {difference:.1e}{more}{theorem}",
            names.join(" against ")
        );
        let uncertainty = larger(difference, DoubleDouble::EPSILON);
        Ok(Self { times: times.to_vec(), states: kept, uncertainty, proved, how })
    }

    /// State at the last instant of the reference. It is empty if the reference has no instants.
    pub fn end(&self) -> &[DoubleDouble] {
        self.states.last().map_or(&[], Vec::as_slice)
    }
}

/// Largest distance from given states of a scene to its exact motion, as a rigorous run proves it, measured like
/// [`work_precision_error`]. `None` if no distance is proved with a small number of operations, or if the states belong
/// to other numbers than those of the scene's file.
fn proved_distance(model: &Mechanism, scene: &Scene, times: &[f64], states: &[Vec<DoubleDouble>]) -> Option<f64> {
    let (first, last) = (*times.first()?, *times.last()?);
    if first < scene.span.0 || last > scene.span.1 {
        return None;
    }
    let file = enclosed_scene(scene, model, &[]).ok()?;
    if !has_numbers_of_file(&scene.exact, &file.start) {
        return None;
    }
    let outputs = default_outputs(model);
    let scene = Scene { events: Vec::new(), claims: Vec::new(), outputs, states_outputs: false, ..scene.clone() };
    let instants = EnclosedInstants::At(times);
    let options = RigorousOptions::default();
    let request =
        RigorousRequest { by: None, set: &[], instants, claims: &[], operation_limit: MOST_OPERATIONS, options };
    let found = enclose_scene(model, &scene, &request).ok()?;
    if found.boxes.len() != states.len() {
        return None;
    }
    let error = |(x, exact): (&DoubleDouble, &Ball)| {
        let distance = Ball::point(*x) - *exact;
        distance.size() / (1.0 + exact.least_size())
    };
    let errors = states.iter().zip(&found.boxes).flat_map(|(x, exact)| x.iter().zip(exact).map(error));
    Some(errors.fold(0.0, larger))
}

/// True if a start has the numbers of its scene's file: each differs from the file's by two roundings at most.
fn has_numbers_of_file(start: &ExactStart, file: &EnclosedStart) -> bool {
    let is_near = |(x, of_file): (&DoubleDouble, &Ball)| {
        let distance = (Ball::point(*x) - *of_file).size();
        distance <= 2.0 * f64::EPSILON * x.to_f64().abs()
    };
    let are_near = |numbers: &[DoubleDouble], of_file: &[Ball]| {
        numbers.len() == of_file.len() && numbers.iter().zip(of_file).all(is_near)
    };
    let motion = match (&start.motion, &file.motion) {
        (InitialMotion::Speeds(x), InitialMotion::Speeds(of_file))
        | (InitialMotion::Rates(x), InitialMotion::Rates(of_file)) => are_near(x, of_file),
        _ => false,
    };
    motion && are_near(&start.parameters, &file.parameters) && are_near(&start.q, &file.q)
}

/// Equations of one formulation from which a reference is computed.
#[derive(Clone)]
struct ReferenceEquations {
    /// Formulation that gave the equations.
    by: EquationsOrigin,
    /// Code of the equations, compiled or interpreted.
    code: Code,
}

/// Prepares the equations of two formulations for a reference. A model with only one formulation gives
/// the same equations twice.
///
/// # Errors
/// `Error::Request` if no formulation has eliminated accelerations.
fn reference_equations(model: &Mechanism, scene: &Scene) -> Result<[ReferenceEquations; 2], Error> {
    let mut list = Vec::new();
    for formulation in [Formulation::Lagrange, Formulation::Kane] {
        let by = EquationsOrigin::from(formulation);
        match runnable_code(model, &by, scene.integration.distance, CodePreparation::Solved) {
            Ok(code) if code.system().has_accelerations() => list.push(ReferenceEquations { by, code }),
            Ok(_) | Err(Error::Unsupported(_)) => {}
            Err(failure) => return Err(failure),
        }
    }
    list.extend(list.first().cloned().filter(|_| list.len() == 1));
    list.try_into().map_err(|_| {
        let help = "give a model that Kane's method or Lagrange's equations can be derived for".to_owned();
        Error::request("a reference needs two witnesses, and the scene has none".to_owned(), help)
    })
}

/// Distance from a singular surface that the reference integrates in place of a coordinate. `None` if
/// neither the model nor the scene has one, or if compiled equations exist only without it.
fn distance_for_reference(model: &Mechanism, scene: &Scene) -> Option<SingularDistance> {
    tripos_derive::mechanics::singular_distances(model).first().copied().or(scene.integration.distance).filter(
        |distance| {
            // Interpreted equations in 32 digits resolve a small distance well enough.
            let is_compiled = |distance| {
                compiled_code(model, &EquationsOrigin::from(Formulation::Lagrange), distance, CodePreparation::Solved)
                    .is_some()
            };
            !is_compiled(None) || is_compiled(Some(*distance))
        },
    )
}

impl ReferenceEquations {
    /// Integrates the equations at a relative tolerance. Returns the coordinates and generalized
    /// speeds at the given instants, s.
    ///
    /// # Errors
    /// `Error` if the run cannot start or does not reach the last instant.
    fn run(&self, model: &Mechanism, scene: &Scene, times: &[f64], rtol: f64) -> Result<Vec<Vec<DoubleDouble>>, Error> {
        let problem = Problem::new(model, scene, &self.by, &self.code, Some(AccelerationSolution::Eliminated))?;
        let (p, y0) = problem.extended_start()?;
        let system = self.code.extended();
        let mut rhs =
            EliminatedDynamics::new(system, &p).expect("checked to be eliminated, with the model's parameters");
        let options = problem.run_options(&reference_options(rtol));
        let walk = |t0: f64, t1: f64, y: &[DoubleDouble]| {
            let rhs = LentRightHandSide(&mut rhs as &mut dyn RightHandSide<DoubleDouble>);
            integrate(rhs, (t0, t1), y, &options, &mut [])
        };
        let states = integrate_between_instants(scene, times, y0, walk)?;
        Ok(times.iter().zip(&states).map(|(t, y)| problem.extended_state(&p, *t, y)).collect())
    }

    /// True if two formulations compute with identical terms: their rates at states near the start agree
    /// in every bit.
    ///
    /// Different terms for the same rates would differ in at least one of 106 bits at one of the tested
    /// states. The result is only stated with the reference, and changes nothing else.
    fn runs_the_terms_of(&self, other: &Self, model: &Mechanism, scene: &Scene) -> Result<bool, Error> {
        if self.code.system().lengths().state() != other.code.system().lengths().state() {
            return Ok(false);
        }
        let problem = Problem::new(model, scene, &self.by, &self.code, Some(AccelerationSolution::Eliminated))?;
        let (p, y0) = problem.extended_start()?;
        let rates = |witness: &Self, y: &[DoubleDouble]| {
            let (q, v) = y.split_at(witness.code.system().lengths().coordinates);
            let (mut q_dot, mut v_dot) = (q.to_vec(), v.to_vec());
            witness.code.extended().derivative(&p, q, v, &mut q_dot, &mut v_dot);
            [q_dot, v_dot].concat()
        };
        let beside = |k: usize| {
            let offset =
                |at: usize| DoubleDouble::ratio(1, 7) * DoubleDouble::from_f64((1 + at + k) as f64).sin_cos().0;
            y0.iter().enumerate().map(|(at, y)| *y + offset(at)).collect::<Vec<_>>()
        };
        Ok((0..STATES).map(beside).all(|y| rates(self, &y) == rates(other, &y)))
    }
}

/// Options for a reference run: DOP853 with `rtol` as relative and absolute tolerance.
fn reference_options(rtol: f64) -> Options {
    let method = Method::Dop853;
    Options { method, step_limit: MOST_STEPS, output: OutputOption::Ends, ..Options::tolerances(rtol, rtol) }
}

/// Integrates by `walk` from each instant to the next, and returns the states at the instants. Each
/// instant is the end of an integration, so its state is as accurate as the tolerance.
///
/// # Errors
/// `Error` if an integration fails or stops before its end.
fn integrate_between_instants(
    scene: &Scene,
    times: &[f64],
    start: Vec<DoubleDouble>,
    mut walk: impl FnMut(f64, f64, &[DoubleDouble]) -> Result<Solution<DoubleDouble>, SimError>,
) -> Result<Vec<Vec<DoubleDouble>>, Error> {
    let (mut t, mut y) = (scene.span.0, start);
    let mut states = Vec::new();
    for &next in times {
        if next - t != 0.0 {
            let solution = walk(t, next, &y).map_err(|error| refused_scene_error(scene, &error))?;
            if solution.stop.is_failure() {
                return Err(Error::Stopped(format!("the reference run {solution}")));
            }
            (t, y) = (next, solution.y_end);
        }
        states.push(y.clone());
    }
    Ok(states)
}
