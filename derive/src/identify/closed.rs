//! Relations between columns of a regressor that hold only where the loops of a mechanism are closed. They are found in
//! doubles, at the parameter values of the model file, since closed poses are known in numbers only.

use super::{Base, Factor, Identification};
use crate::algebra::Expr;
use crate::algebra::value::evaluate::Tape;
use crate::model::Model;
use crate::model::constraints::closed_poses::{Chance, Poses, reach};
use nalgebra::{DMatrix, DVector};

/// Number of closed poses. `STATES` is the number of states in each pose: half of these find the relations, half
/// confirm them.
const POSES: usize = 12;
const STATES: usize = 16;
/// Largest absolute value of the speeds and accelerations of the states, 1/s and 1/s² for angles.
const FAST: f64 = 3.0;
/// Remainder of a column of length 1 above which it is independent, after earlier columns are projected out. Below
/// `DEPENDENT` it is dependent.
const INDEPENDENT: f64 = 1e-6;
const DEPENDENT: f64 = 1e-9;
/// Fraction of the largest factor below which a factor counts as zero.
const NONE: f64 = 1e-8;

/// Sample of closed states by which relations on loops were found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnLoops {
    /// Number of closed poses in the sample, at the parameter values of the model file.
    pub poses: usize,
    /// Smallest remainder of an independent column of length 1, after earlier columns are projected out.
    pub independent: f64,
    /// Largest remainder of a dependent column of length 1, after independent columns are projected out.
    pub dependent: f64,
}

/// Groups base parameters that act as one in closed poses. Returns the sample of closed states. `None`, with unchanged
/// base parameters, if no closed pose is found, a parameter has no value, or a dependence is unclear.
pub fn close(model: &Model, found: &mut Identification) -> Option<OnLoops> {
    let ([rows, elsewhere], poses) = rows(model, found)?;
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut kept: Vec<usize> = Vec::new();
    let mut seen = OnLoops { poses, independent: f64::INFINITY, dependent: 0.0 };
    let mut given: Vec<(usize, DVector<f64>)> = Vec::new();
    for at in 0..found.base.len() {
        let column: DVector<f64> = rows.column(at).into_owned();
        let mut left = column.clone();
        // The second pass removes the rounding errors of the first.
        for _ in 0..2 {
            for other in &basis {
                left -= other * other.dot(&left);
            }
        }
        let size = left.norm() / column.norm();
        if size > INDEPENDENT {
            seen.independent = seen.independent.min(size);
            basis.push(left.normalize());
            kept.push(at);
        } else if size < DEPENDENT {
            seen.dependent = seen.dependent.max(size);
            given.push((at, column));
        } else {
            return None;
        }
    }
    let columns = rows.select_columns(&kept);
    let svd = columns.svd(true, true);
    let mut shares = Vec::new();
    let beside = elsewhere.select_columns(&kept);
    for (at, column) in given {
        let factors = svd.solve(&column, 0.0).ok()?;
        let there = elsewhere.column(at);
        // A dependence that holds only at the states where it was found is accidental.
        if (&beside * &factors - there).norm() > INDEPENDENT * there.norm() {
            return None;
        }
        shares.push((at, factors));
    }
    regroup(found, &kept, &shares);
    Some(seen)
}

/// Adds the dependent base parameters to those that are kept.
fn regroup(found: &mut Identification, kept: &[usize], shares: &[(usize, DVector<f64>)]) {
    let mut base: Vec<Base> = kept.iter().map(|at| found.base[*at].clone()).collect();
    for (at, factors) in shares {
        let Base { column, .. } = found.base[*at];
        let largest = factors.amax();
        for (place, factor) in factors.iter().enumerate().filter(|(_, factor)| factor.abs() > NONE * largest) {
            base[place].with.push((column, Factor::Number(*factor)));
        }
    }
    // A dependent base parameter keeps its own combination: its name stands for the whole combination.
    let given: Vec<Base> = shares.iter().map(|(at, _)| found.base[*at].clone()).collect();
    found.grouped = given.into_iter().filter(|base| !base.with.is_empty()).collect();
    found.base = base;
}

/// Values of the base columns in closed poses, for two samples of states: a row for each speed of each state. Also the
/// number of poses. `None` if a parameter has no value or no closed pose is found.
fn rows(model: &Model, found: &mut Identification) -> Option<([DMatrix<f64>; 2], usize)> {
    let regressor = &mut found.regressor;
    let time = model.time();
    let (places, coordinates): (Vec<usize>, Vec<Expr>) =
        model.q().into_iter().enumerate().filter(|(at, _)| Some(*at) != time).unzip();
    let mut known: Vec<(Expr, f64)> = Vec::new();
    for parameter in &model.parameters {
        let value = parameter.value.as_ref().map(crate::algebra::Rational::to_f64);
        known.push((parameter.symbol, if parameter.is_input { 0.0 } else { value? }));
    }
    let lengths =
        model.parameters.iter().filter(|p| p.unit.is_length()).filter_map(|p| Some(p.value.as_ref()?.to_f64()));
    let reach = reach(places.iter().map(|at| model.coordinates[*at].unit.is_plain()), lengths);
    let instant = time.map(|at| (model.coordinates[at].symbol, 0.0));
    let of_poses: Vec<(Expr, f64)> = known.iter().copied().chain(instant).collect();
    let loops: Vec<Expr> = model.loops.iter().chain(&model.closed).map(|c| c.equation).collect();
    let poses = Poses { known: &of_poses, coordinates: &coordinates, reach: &reach, loops: &loops, flat: 0.0 };
    let poses = poses.some(&mut regressor.arena, POSES)?;
    if poses.is_empty() {
        return None;
    }
    let rates: Vec<Expr> = model.speeds.iter().map(|s| s.rate).collect();
    let inputs = [of_poses.iter().map(|(s, _)| *s).collect(), coordinates, model.u(), rates].concat();
    let terms: Vec<Expr> = found.base.iter().flat_map(|base| regressor.columns[base.column].forces.clone()).collect();
    let tape = Tape::new(&regressor.arena, &inputs, &terms).ok()?;
    let speeds = model.speeds.len();
    let columns = found.base.len();
    let mut samples = [Vec::new(), Vec::new()];
    let mut chance = Chance::new();
    for q in &poses {
        for state in 0..STATES {
            // All speeds and accelerations are independent numbers: a pattern among them would look like a relation.
            let moving: Vec<f64> = (0..2 * speeds).map(|_| FAST * chance.draw()).collect();
            let known = of_poses.iter().map(|(_, x)| *x).chain(q.iter().copied());
            let forces = tape.evaluate(&known.chain(moving).collect::<Vec<f64>>());
            if forces.iter().all(|x| x.is_finite()) {
                let row = |r: usize| (0..columns).map(move |column| column * speeds + r);
                samples[state % 2].extend((0..speeds).flat_map(row).map(|at| forces[at]));
            }
        }
    }
    let matrix = |flat: Vec<f64>| DMatrix::from_row_slice(flat.len() / columns.max(1), columns, &flat);
    samples.iter().all(|flat| !flat.is_empty()).then(|| (samples.map(matrix), poses.len()))
}
