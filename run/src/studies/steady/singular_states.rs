//! Test for states at which the equations of a mechanism are singular. There, the speeds do not
//! determine the rates of the coordinates, or a combination of speeds has no inertia.

use super::steady_state::SteadyState;
use crate::Error;
use crate::Mechanism;
use nalgebra::DMatrix;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::calculus::Differential;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::{Tape, UnknownSymbol};
use tripos_derive::flow::Flow;
use tripos_derive::plain_text::with_significant_digits;
use tripos_traits::DoubleDouble;

/// Least accepted distance of a state from a zero of a divisor, relative to the size of the state or to
/// 1, whichever is larger. At such a zero, Newton's method finds only a half or a third of the digits,
/// and slopes grow without bound.
const NEAR: f64 = 1e-7;
/// Fraction of its value in neighbouring states up to which an inertia counts as zero. The inertia is on
/// the diagonal of the mass matrix, and the neighbouring states are at the distance [`NEAR`]. An inertia
/// that vanishes in a state grows with the square of the distance from this state.
const VANISHED: f64 = 1e-2;
/// Least absolute eigenvalue of a regular mass matrix that is scaled to the diagonal 1. A matrix with a
/// smaller eigenvalue counts as singular.
const SINGULAR: f64 = 1e-12;

/// Divisors and mass matrix of a mechanism's equations, prepared to test states for singularity.
pub(super) struct SingularStateTest {
    /// Formula of each divisor as text.
    divisors: Vec<String>,
    /// Names of the generalized speeds, for messages.
    speeds: Vec<String>,
    /// Tape of the divisors, of their derivatives by all states, and of the mass matrix row by row. Inputs:
    /// parameters, then states.
    tape: Tape,
}

impl SingularStateTest {
    /// Prepares the test from the equations of a mechanism in first order.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if a divisor contains a symbol that is neither a state nor a parameter.
    pub(super) fn new(model: &Mechanism, flow: &Flow) -> Result<Self, UnknownSymbol> {
        let mut arena = flow.arena.clone();
        let mut slopes = Vec::new();
        for divisor in &flow.divisors {
            slopes.extend(flow.states.iter().map(|x| Differential::partial(*x).apply(&mut arena, *divisor)));
        }
        let inertia: Vec<Expr> = flow.inertia.iter().flatten().copied().collect();
        let symbols = [&flow.parameters[..], &flow.states].concat();
        let outputs = [flow.divisors.clone(), slopes, inertia].concat();
        Ok(Self {
            divisors: flow.divisors.iter().map(|divisor| print_text(&arena, *divisor)).collect(),
            speeds: model.speeds.iter().map(|s| s.name.clone()).collect(),
            tape: Tape::new(&arena, &symbols, &outputs)?,
        })
    }

    /// Refuses a state that is singular, or so close to a singular state that slopes have no meaning.
    ///
    /// # Errors
    /// [`Error::Request`] that names the divisor that is zero, or the speeds without inertia, if the state
    /// is refused.
    pub(super) fn refuse_singular_state(&self, parameters: &[DoubleDouble], steady: &SteadyState) -> Result<(), Error> {
        let known: Vec<f64> = parameters.iter().chain(&steady.x).map(|x| x.hi()).collect();
        let values = self.tape.evaluate(&known);
        let (divisors, rest) = values.split_at(self.divisors.len());
        let (slopes, inertia) = rest.split_at(self.divisors.len() * steady.x.len());
        let near = NEAR.max(10.0 * steady.uncertain);
        for ((name, value), slopes) in self.divisors.iter().zip(divisors).zip(slopes.chunks(steady.x.len().max(1))) {
            let reach = slopes.iter().zip(&steady.x).map(|(slope, x)| slope.abs() * x.hi().abs().max(1.0)).sum::<f64>();
            // A divisor that is NaN is refused too.
            if value.is_nan() || value.abs() <= near * reach || value.abs() <= 0.0 {
                let what = format!(
                    "the equations are singular at this state: they divide by {name}, which is {} there, and slopes have no bound",
                    with_significant_digits(*value, 2)
                );
                let help = "choose speeds that determine the rates of all coordinates there, or coordinates that have no pole there, or another \
                            state";
                return Err(Error::request(what, help));
            }
        }
        self.require_inertia(inertia, &self.neighbouring_inertia(&known, parameters.len()))
    }

    /// Largest absolute value of each diagonal entry of the mass matrix at neighbouring states. These
    /// differ in one state each, by the distance [`NEAR`]. `known` has the parameters, `first` of them,
    /// followed by the states.
    fn neighbouring_inertia(&self, known: &[f64], first: usize) -> Vec<f64> {
        let n = self.speeds.len();
        let mut largest = vec![0.0; n];
        for at in first..known.len() {
            for way in [-NEAR, NEAR] {
                let mut beside = known.to_vec();
                beside[at] += way * known[at].abs().max(1.0);
                let values = self.tape.evaluate(&beside);
                let inertia = &values[values.len() - n * n..];
                for (speed, most) in largest.iter_mut().enumerate() {
                    *most = f64::max(*most, inertia[speed * (n + 1)].abs());
                }
            }
        }
        largest
    }

    /// Refuses a singular mass matrix `inertia`, given row by row. `beside` are its diagonal entries at
    /// neighbouring states.
    ///
    /// # Errors
    /// `Error::Request` that names the speeds without inertia, if the matrix is singular.
    fn require_inertia(&self, inertia: &[f64], beside: &[f64]) -> Result<(), Error> {
        let n = self.speeds.len();
        let size = |at: usize| inertia[at * n + at].abs().sqrt();
        let vanishes = |at: usize| inertia[at * (n + 1)].abs() <= VANISHED * beside[at];
        let empty = (0..n).find(|at| size(*at) <= 0.0 || !size(*at).is_finite() || vanishes(*at));
        let moved = match empty {
            Some(at) => self.speeds[at].clone(),
            None => {
                let scaled = DMatrix::from_fn(n, n, |i, j| inertia[i * n + j] / (size(i) * size(j)));
                let symmetric = (&scaled + scaled.transpose()) / 2.0;
                if symmetric.iter().any(|x| !x.is_finite()) {
                    return Ok(());
                }
                let eigen = symmetric.symmetric_eigen();
                let least = eigen.eigenvalues.iamin();
                if eigen.eigenvalues[least].abs() > SINGULAR {
                    return Ok(());
                }
                let parts = eigen.eigenvectors.column(least);
                let taking_part = self.speeds.iter().zip(parts.iter()).filter(|(_, part)| part.abs() > 0.1);
                taking_part.map(|(name, _)| name.clone()).collect::<Vec<_>>().join(", ")
            }
        };
        let what = format!("the mass matrix is singular at this state: nothing resists a change of {moved}");
        Err(Error::request(what, "give the moving part an inertia, or choose other speeds or another state"))
    }
}
