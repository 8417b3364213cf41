//! Motions given by formulas in the time t. Closed poses, speeds and accelerations are computed from the
//! formulas.
//!
//! The equations q̇ = W u + w for the coordinates with formulas give the speeds u. The equations
//! q̈ = W u̇ + (Ẇ u + ẇ) give u̇. If there are more such coordinates than speeds, the motion must satisfy
//! the constraints. Otherwise it is refused.

use super::least_squares::{LeastSquaresSolver, round_to_doubles};
use crate::{Error, Mechanism};
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::calculus::Gradient;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::mechanics::kinematic_rates;
use tripos_derive::plain_text::{with_reliable_digits, with_significant_digits};
use tripos_derive::scene::{Formulas, Loops, Motion, MotionForm, MotionSample};
use tripos_traits::DoubleDouble;

/// Residual of the constraints up to which a given motion is accepted, relative to the largest given
/// rate or to 1, whichever is larger.
const BROKEN: f64 = 1e-9;

/// Values of parameters, coordinates and generalized speeds at one instant, to 32 digits.
#[derive(Clone, Copy)]
struct MotionState<'a> {
    /// Values of the parameters, in the order of the model.
    p: &'a [DoubleDouble],
    /// Generalized coordinates q, in the order of the model.
    q: &'a [DoubleDouble],
    /// Generalized speeds u, in the order of the model.
    u: &'a [DoubleDouble],
}

/// Computes the coordinates, speeds and accelerations of a given motion at each of its instants. A motion
/// that is given by states is returned unchanged.
///
/// # Errors
/// [`Error::Stopped`] if a formula has no value at an instant, if the formulas do not determine the
/// motion or break a constraint, or if a loop cannot be closed. `Error::Request` if a formula
/// contains a symbol without a value.
pub fn motion_samples(model: &Mechanism, motion: &Motion) -> Result<Vec<MotionSample>, Error> {
    let formulas = match &motion.given {
        MotionForm::Samples(list) => return Ok(list.clone()),
        MotionForm::Formulas(formulas) => formulas,
    };
    let course = PrescribedMotion::new(model, formulas)?;
    let mut q: Vec<DoubleDouble> = formulas.guesses.iter().map(|x| DoubleDouble::from(*x)).collect();
    let mut list = Vec::with_capacity(formulas.instants.len());
    for t in &formulas.instants {
        let moving = course.sample_at(&motion.parameters, *t, &q)?;
        q.clone_from(&moving.q);
        list.push(moving);
    }
    Ok(list)
}

/// Motion that is given by formulas in the time, compiled to tapes.
struct PrescribedMotion {
    /// Names of all coordinates, in the order of the model.
    names: Vec<String>,
    /// Number of generalized speeds of the model.
    speeds: usize,
    /// Indices of the coordinates that have formulas.
    given: Vec<usize>,
    /// Indices of the coordinates without formulas, which the closed loops determine.
    free: Vec<usize>,
    /// Tape of q, q̇ and q̈ of each coordinate with a formula. Inputs: parameters, then the time t.
    formulas: Tape<DoubleDouble>,
    /// Tape of q̇ and dq̇/dt of every coordinate, followed by W row by row. Inputs: parameters, q, u
    /// and u̇.
    rates: Tape<DoubleDouble>,
    /// Loops of the model, which close the poses.
    loops: Loops,
}

impl PrescribedMotion {
    /// Compiles the formulas of a motion, and the rates of all coordinates of the model.
    ///
    /// # Errors
    /// `Error::Request` if a formula contains a symbol without a value.
    fn new(model: &Mechanism, formulas: &Formulas) -> Result<Self, Error> {
        let (given, free): (Vec<usize>, Vec<usize>) =
            (0..model.coordinates.len()).partition(|at| formulas.coordinates[*at].is_some());
        let terms: Vec<Expr> = formulas.coordinates.iter().flatten().flatten().copied().collect();
        let of_time = [model.p(), vec![formulas.time]].concat();
        let of_formulas = crate::code::compile_tape(&model.arena, &of_time, &terms, "the motion")?;
        let mut arena = model.arena.clone();
        let rates = &model.kinematic_equations.rates;
        let mut d_dt = kinematic_rates(model);
        let mut gradient = Gradient::new(&model.u());
        let seconds: Vec<Expr> = rates.iter().map(|rate| d_dt.apply(&mut arena, *rate)).collect();
        let mut outputs = [rates.clone(), seconds].concat();
        for rate in rates {
            let mut row = vec![Expr::ZERO; model.speeds.len()];
            for (at, slope) in gradient.apply(&mut arena, *rate).iter() {
                row[*at] = *slope;
            }
            outputs.extend(row);
        }
        let known = [model.p(), model.q(), model.u(), model.speeds.iter().map(|s| s.rate).collect()].concat();
        Ok(Self {
            names: model.coordinates.iter().map(|c| c.name.clone()).collect(),
            speeds: model.speeds.len(),
            given,
            free,
            formulas: of_formulas.to(),
            rates: crate::code::compile_tape(&arena, &known, &outputs, "a rate")?.to(),
            loops: Loops::new(model),
        })
    }

    /// Computes the motion at the instant `t`, s, with the parameters `p`. The search for a closed pose
    /// begins at the coordinates `near`.
    ///
    /// # Errors
    /// `Error::Stopped` if the formulas determine no motion at this instant.
    fn sample_at(&self, p: &[DoubleDouble], t: f64, near: &[DoubleDouble]) -> Result<MotionSample, Error> {
        let stopped =
            |why: String| Error::Stopped(format!("no motion at t = {} s: {why}", with_reliable_digits(t, None)));
        let values = self.formulas.evaluate(&[p, &[DoubleDouble::from(t)]].concat());
        let mut q = near.to_vec();
        for (place, at) in self.given.iter().enumerate() {
            if values[3 * place..3 * place + 3].iter().any(|x| !x.hi().is_finite()) {
                return Err(stopped(format!(
                    "the formula of `{}`, or a time derivative of the formula, has no value",
                    self.names[*at]
                )));
            }
            q[*at] = values[3 * place];
        }
        if !self.loops.openings(&round_to_doubles(p), &round_to_doubles(&q)).is_empty() {
            q = self.loops.close(p, &q, &self.free).ok_or_else(|| stopped(self.open_loops_message(p, &q)))?;
        }
        let still = vec![DoubleDouble::from(0.0); self.speeds];
        let u = self.match_rates(&stopped, 0, MotionState { p, q: &q, u: &still }, |place| values[3 * place + 1])?;
        let rates = self.match_rates(&stopped, 1, MotionState { p, q: &q, u: &u }, |place| values[3 * place + 2])?;
        Ok(MotionSample { t: Some(t), q, u, rates })
    }

    /// Message that says why the loops are not closed in the pose `q`.
    fn open_loops_message(&self, p: &[DoubleDouble], q: &[DoubleDouble]) -> String {
        let names =
            |list: &[usize]| list.iter().map(|at| format!("`{}`", self.names[*at])).collect::<Vec<_>>().join(", ");
        if !self.free.is_empty() {
            let free = names(&self.free);
            return format!("the loops are not closed near the last pose, or do not determine it: {free}");
        }
        let mut open = self.loops.openings(&round_to_doubles(p), &round_to_doubles(q));
        open.retain(|(_, by)| by.abs() > BROKEN || by.is_nan());
        let open: Vec<String> =
            open.iter().map(|(name, by)| format!("`{name}` by {}", with_significant_digits(*by, 4))).collect();
        format!(
            "the formulas of {} contradict the loops, which are open: {}; leave out the formulas of coordinates that the loops \
             determine, and put values near them under [guess]",
            names(&self.given),
            open.join(", ")
        )
    }

    /// Finds the speeds u by least squares if `order` is 0, or their rates u̇ if it is 1. The coordinates
    /// with formulas must get the derivatives `wanted`: q̇, or q̈. `at` is the pose with the speeds, which
    /// must be 0 if the speeds themselves are unknown.
    ///
    /// # Errors
    /// `Error::Stopped` if the formulas do not determine all speeds, or break the constraints.
    fn match_rates(
        &self,
        stopped: &dyn Fn(String) -> Error,
        order: usize,
        at: MotionState<'_>,
        wanted: impl Fn(usize) -> DoubleDouble,
    ) -> Result<Vec<DoubleDouble>, Error> {
        let MotionState { p, q, u } = at;
        let n = q.len();
        let still = vec![DoubleDouble::from(0.0); self.speeds];
        let values = self.rates.evaluate(&[p, q, u, &still].concat());
        if let Some(at) = values.iter().position(|x| !x.hi().is_finite()) {
            return Err(stopped(format!("a rate of `{}` has no value", self.names[(at % n).min(n - 1)])));
        }
        let row = |at: usize| &values[2 * n + at * self.speeds..2 * n + (at + 1) * self.speeds];
        let rows: Vec<&[DoubleDouble]> = self.given.iter().map(|at| row(*at)).collect();
        let right: Vec<DoubleDouble> =
            self.given.iter().enumerate().map(|(place, at)| wanted(place) - values[order * n + at]).collect();
        let found = LeastSquaresSolver::new(&rows).solve(&rows, &right);
        if found.rank < self.speeds {
            let what = format!("the formulas determine {} of {} speeds", found.rank, self.speeds);
            return Err(stopped(format!("{what}; give formulas for more coordinates")));
        }
        let size = (0..rows.len()).fold(1.0, |most: f64, place| most.max(wanted(place).hi().abs()));
        let worst = found.left.iter().map(|x| x.hi().abs()).enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        match worst.filter(|(_, left)| *left > BROKEN * size) {
            Some((place, left)) => {
                let primes = ["'", "''"][order];
                let name = &self.names[self.given[place]];
                Err(stopped(format!(
                    "the constraints are broken: {name}{primes} is off by {}",
                    with_significant_digits(left, 4)
                )))
            }
            None => Ok(found.x),
        }
    }
}
