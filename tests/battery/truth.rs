//! The motion in 32 digits.

use super::problem::Problem;
use tripos::code::{CodePreparation, runnable_code};
use tripos_derive::Formulation;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::scene::AccelerationSolution;
use tripos_sim::{
    EliminatedDynamics, LentRightHandSide, Method, Options, OutputOption, RightHandSide, Stop, integrate,
};
use tripos_traits::{DoubleDouble, Real};

/// The tolerances of the run that is kept, and of the one that it is checked by.
const TOLERANCES: [f64; 2] = [1e-23, 1e-21];
/// Steps after which a motion is given up.
const STEPS: u64 = 3_000;
/// Largest permitted difference of the kept run and its check.
const KNOWN: f64 = 1e-17;

pub struct Truth {
    pub names: Vec<String>,
    t: Vec<f64>,
    states: Vec<Vec<f64>>,
}

impl Truth {
    /// The motion at the instants of its scene's samples, as far as it is known; nothing if none is.
    pub fn new(problem: &Problem) -> Option<Self> {
        let times = problem.times();
        let [kept, check] = TOLERANCES.map(|tolerance| run(problem, tolerance, &times));
        let (kept, check) = (kept?, check?);
        let apart = |(a, b): (&Vec<f64>, &Vec<f64>)| {
            a.iter().zip(b).all(|(a, b)| (a - b).abs() <= KNOWN.max(f64::EPSILON * a.abs()))
        };
        let known = kept.iter().zip(&check).take_while(|pair| apart(*pair)).count();
        (known == times.len()).then(|| Self { names: tripos::state_names(&problem.mechanism), t: times, states: kept })
    }

    /// The state at an instant of the samples.
    pub fn at(&self, t: f64) -> Option<&Vec<f64>> {
        self.t.iter().position(|known| known.total_cmp(&t).is_eq()).map(|at| &self.states[at])
    }

    /// The largest size of a component.
    pub fn size(&self, of: usize) -> f64 {
        self.states.iter().map(|state| state[of].abs()).fold(0.0, f64::max)
    }
}

fn run(problem: &Problem, tolerance: f64, times: &[f64]) -> Option<Vec<Vec<f64>>> {
    let by = EquationsOrigin::from(Formulation::Kane);
    let code = runnable_code(&problem.mechanism, &by, None, CodePreparation::Solved).ok()?;
    let ready =
        tripos::Problem::new(&problem.mechanism, &problem.scene, &by, &code, Some(AccelerationSolution::Eliminated))
            .ok()?;
    let (p, start) = ready.extended_start().ok()?;
    let mut rhs = EliminatedDynamics::<DoubleDouble>::new(code.extended(), &p)?;
    let options = Options {
        method: Method::Taylor,
        output: OutputOption::At(times.to_vec()),
        step_limit: STEPS,
        ..Options::tolerances(tolerance, tolerance)
    };
    let rhs = LentRightHandSide(&mut rhs as &mut dyn RightHandSide<DoubleDouble>);
    let solution = integrate(rhs, problem.scene.span, &start, &options, &mut []).ok()?;
    let state = |(t, y): (&f64, &Vec<DoubleDouble>)| -> Vec<f64> {
        ready.extended_state(&p, *t, y).iter().map(|x| x.to_f64()).collect()
    };
    (solution.stop == Stop::End).then(|| solution.t.iter().zip(&solution.y).map(state).collect())
}
