//! Relations between columns of a regressor that hold only if the loops of a mechanism are closed.
//! They are found in double precision, at the parameter values of the model file, because closed
//! poses are known only as numbers.

use super::{BaseParameter, BaseParameterFactor, Identification};
use crate::algebra::term::calculus::Gradient;
use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr};
use crate::model::Model;
use crate::model::constraints::closed_pose_search::{
    ClosedPoseSearch, RandomNumbers, orientation_program, random_coordinate_ranges,
};
use nalgebra::{DMatrix, DVector};
use tripos_linear::{SingularValues, singular_values};

/// Numbers of random closed poses in a sample. They are tried in turn until dependent and
/// independent columns of the regressor differ clearly.
const POSES: [usize; 4] = [12, 24, 48, 96];
/// Smallest number of regular poses for which relations are accepted.
const FEWEST: usize = 8;
/// Number of random states (speeds and accelerations) in each pose of the sample.
const STATES: usize = 16;
/// Limit on the smallest singular value of the matrix of constraints and speeds, whose rows have at
/// most length 1. Below the limit, a pose is singular: the speeds do not determine q̇ there, and
/// the columns of the regressor are quotients of rounding errors. The limit allows for the rounding
/// error of a double root.
const SINGULAR: f64 = 1e-5;
/// Fraction of the median of the smallest singular values, below which a pose counts as near a
/// singular pose.
const NEAR_SINGULAR: f64 = 0.01;
/// Size of a force relative to its largest intermediate term, below which the force counts as zero:
/// it is a rounding error.
const CANCELLED: f64 = 1e-12;
/// Largest factor between columns of length 1. Larger factors come from columns that consist of
/// rounding errors.
const LARGEST: f64 = 1e6;
/// Largest denominator of the fractions to which factors are rounded.
const DENOMINATORS: u32 = 360;
/// Relative distance from a fraction below which a factor is replaced by the fraction.
const CLOSE: f64 = 1e-10;
/// Multiple of the median forces above which a pose counts as near a dead point, at which the
/// generalized speeds do not determine q̇. Such a pose is left out, because its rounding errors
/// would be larger than the values in other poses.
const NEAR_DEAD: f64 = 10.0;
/// Largest absolute value of the speeds (1/s for angles) and accelerations (1/s²) of the sampled
/// states.
const FAST: f64 = 3.0;
/// Length of the remainder of a unit column above which the column counts as independent. The
/// remainder is the column minus its projection on earlier columns.
const INDEPENDENT: f64 = 1e-6;
/// Length of the remainder of a unit column below which the column counts as dependent. The
/// remainder is the column minus its projection on earlier columns.
const DEPENDENT: f64 = 1e-9;
/// Smallest ratio between the remainders of independent and dependent columns for which the two are
/// clearly different.
const GAP: f64 = 1e6;
/// Length of the remainder of a unit column that rounding errors may always cause.
const ROUNDING: f64 = 1e-15;
/// Fraction of the largest factor of a column below which a factor counts as zero.
const NONE: f64 = 1e-8;

/// Sample of closed states, from which relations between base parameters of a mechanism with loops
/// were found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoopSample {
    /// Number of closed poses in the sample, at the parameter values of the model file.
    pub poses: usize,
    /// Smallest remainder of an independent column of length 1. The remainder is the column minus
    /// its projection on earlier independent columns.
    pub independent: f64,
    /// Largest remainder of a dependent column of length 1. The remainder is the column minus its
    /// projection on earlier independent columns.
    pub dependent: f64,
    /// True if the remainders of dependent and independent columns differ clearly. If false, base
    /// parameters are not grouped, and their number may be too large.
    pub is_clear: bool,
}

/// Linear relations between base parameters in closed poses: the independent parameters, and the
/// dependent parameters with their factors.
struct Relations {
    /// Indices of the independent base parameters, which are kept.
    kept: Vec<usize>,
    /// Dependent base parameters, as pairs (index, factors). There is a factor for each kept
    /// parameter.
    shares: Vec<(usize, DVector<f64>)>,
}

/// Groups base parameters that act only together in closed poses. Returns the sample of closed
/// states. The base parameters stay unchanged if the sample shows no clear difference between
/// dependent and independent columns.
///
/// `None`, with unchanged base parameters, if too few closed poses are found or a parameter has no
/// value.
pub fn group_by_loop_relations(model: &Model, found: &mut Identification) -> Option<LoopSample> {
    let mut seen = None;
    for most in POSES {
        let Some((samples, poses)) = sample_rows_on_loops(model, found, most) else { continue };
        let (mut relations, mut sample) = loop_relations_of_sample(&samples, poses);
        // Relations that hold in few poses may not hold in others.
        if poses < FEWEST {
            (relations, sample.is_clear) = (None, false);
        }
        let before = seen.replace(sample);
        if let Some(relations) = relations {
            group_parameters_on_loops(found, &relations);
            break;
        }
        // More poses were requested, but no more were found.
        if before.is_some_and(|before: LoopSample| before.poses == poses) {
            break;
        }
    }
    seen
}

/// Number of independent rows of the regressor that a pose gives for each degree of freedom.
const ROWS_OF_POSE: usize = 3;

/// Finds the columns of the first matrix that depend on earlier columns, and checks these relations
/// in the second matrix. The relations are `None` if dependent and independent columns do not
/// differ clearly, or if the second matrix refutes them.
fn loop_relations_of_sample([rows, elsewhere]: &[DMatrix<f64>; 2], poses: usize) -> (Option<Relations>, LoopSample) {
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut kept: Vec<usize> = Vec::new();
    let mut seen = LoopSample { poses, independent: f64::INFINITY, dependent: 0.0, is_clear: false };
    let mut given: Vec<(usize, DVector<f64>)> = Vec::new();
    for at in 0..rows.ncols() {
        let column: DVector<f64> = rows.column(at).into_owned();
        let mut left = column.clone();
        // The second pass removes the rounding errors of the first pass.
        for _ in 0..2 {
            for other in &basis {
                left -= other * other.dot(&left);
            }
        }
        // A column of zeros is dependent; its norm must not divide.
        let size = if column.norm() > 0.0 { left.norm() / column.norm() } else { 0.0 };
        // If it is unclear that a column is dependent, its remainder counts on both sides of the
        // gap.
        if size < INDEPENDENT {
            seen.dependent = seen.dependent.max(size);
        }
        if size > DEPENDENT {
            seen.independent = seen.independent.min(size);
            basis.push(left.normalize());
            kept.push(at);
        } else {
            given.push((at, column));
        }
    }
    if seen.independent < INDEPENDENT.max(GAP * seen.dependent.max(ROUNDING)) {
        return (None, seen);
    }
    let found = SingularValues::new(&rows.select_columns(&kept));
    let beside = elsewhere.select_columns(&kept);
    let mut shares = Vec::new();
    for (at, column) in given {
        let factors = found.solve(&column, 0.0);
        let length = column.norm();
        let is_huge =
            |(place, factor): (usize, &f64)| factor.abs() * rows.column(kept[place]).norm() > LARGEST * length;
        if factors.iter().enumerate().any(is_huge) {
            return (None, seen);
        }
        let factors = factors.map(nearest_fraction);
        let there = elsewhere.column(at);
        // A relation that holds only in the poses in which it was found is accidental.
        if (&beside * &factors - there).norm() > INDEPENDENT * there.norm().max(length) {
            return (None, seen);
        }
        shares.push((at, factors));
    }
    seen.is_clear = true;
    (Some(Relations { kept, shares }), seen)
}

/// Nearest fraction with a small denominator, if the number `x` equals it within rounding; else `x`
/// itself.
fn nearest_fraction(x: f64) -> f64 {
    let mut fractions = (1..=DENOMINATORS).map(f64::from).map(|below| (x * below).round() / below);
    fractions.find(|near| (near - x).abs() <= CLOSE * x.abs()).unwrap_or(x)
}

/// Adds each dependent base parameter, with its factors, to the kept parameters. A dependent
/// parameter whose factors are all zero has no effect in closed poses.
fn group_parameters_on_loops(found: &mut Identification, Relations { kept, shares }: &Relations) {
    let mut base: Vec<BaseParameter> = kept.iter().map(|at| found.base[*at].clone()).collect();
    let mut used: Vec<usize> = Vec::new();
    for (at, factors) in shares {
        let BaseParameter { column, .. } = found.base[*at];
        let largest = factors.amax();
        if largest > 0.0 {
            used.push(*at);
        } else {
            found.without_effect.push(column);
        }
        for (place, factor) in factors.iter().enumerate().filter(|(_, factor)| factor.abs() > NONE * largest) {
            base[place].with.push((column, BaseParameterFactor::Number(*factor)));
        }
    }
    found.without_effect.sort_unstable();
    // A dependent base parameter keeps its own combination, since its name stands for this whole
    // combination.
    let given: Vec<BaseParameter> = used.iter().map(|at| found.base[*at].clone()).collect();
    found.grouped = given.into_iter().filter(|base| !base.with.is_empty()).collect();
    found.base = base;
}

/// Evaluates the columns of the base parameters in about `most` closed poses. Returns two matrices
/// and the number of regular poses.
///
/// The matrices are of different poses, or of different states if there are few poses. They have a
/// row for each speed of each state. Rows are scaled to equal size, so that every state counts
/// equally. Singular poses and poses near a dead point of the speeds are left out.
///
/// Loops may close in several assemblies; a parallelogram, for example, may also be folded.
/// Relations must hold in all assemblies, because a base parameter belongs to the model, not to one
/// assembly. An assembly in which every pose is singular is left out: no motion is computed there.
///
/// `None` if a parameter has no value or too few regular closed poses are found.
fn sample_rows_on_loops(model: &Model, found: &mut Identification, most: usize) -> Option<([DMatrix<f64>; 2], usize)> {
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
    let reach = random_coordinate_ranges(places.iter().map(|at| model.coordinates[*at].unit.is_plain()), lengths);
    let instant = time.map(|at| (model.coordinates[at].symbol, 0.0));
    let of_poses: Vec<(Expr, f64)> = known.iter().copied().chain(instant).collect();
    let loops: Vec<Expr> = model.loops.iter().chain(&model.closed).map(|c| c.equation).collect();
    let sides = orientation_program(&regressor.arena, &of_poses, &coordinates, &model.orientations);
    let poses = ClosedPoseSearch {
        known: &of_poses,
        coordinates: &coordinates,
        reach: &reach,
        loops: &loops,
        flat: 0.0,
        sides: sides.as_ref(),
        home: None,
    };
    // If there are enough poses, relations are found in half of them and checked in the other half.
    let tries = 2 * poses.tries() * most / POSES[0];
    let mut poses = poses.seek_closed_poses_from(&mut regressor.arena, tries, 2 * most)?;
    keep_regular_poses(model, &mut regressor.arena, &of_poses, &coordinates, &mut poses)?;
    let rates: Vec<Expr> = model.speeds.iter().map(|s| s.rate).collect();
    let inputs = [of_poses.iter().map(|(s, _)| *s).collect(), coordinates, model.u(), rates].concat();
    let terms: Vec<Expr> = found.base.iter().flat_map(|base| regressor.columns[base.column].forces.clone()).collect();
    let tape = Tape::new(&regressor.arena, &inputs, &terms).ok()?;
    let speeds = model.speeds.len();
    let columns = found.base.len();
    let mut chance = RandomNumbers::new();
    let mut of_pose: Vec<[DMatrix<f64>; 2]> = Vec::new();
    for q in &poses {
        let mut samples = [Vec::new(), Vec::new()];
        for state in 0..STATES {
            // Speeds and accelerations are independent random numbers, because regular values could
            // look like a relation.
            let moving: Vec<f64> = (0..2 * speeds).map(|_| FAST * chance.draw()).collect();
            let known = of_poses.iter().map(|(_, x)| *x).chain(q.iter().copied());
            let inputs = known.chain(moving).collect::<Vec<f64>>();
            let mut forces = tape.evaluate(&inputs);
            for (force, term) in forces.iter_mut().zip(tape.largest_terms(&inputs)) {
                if term.is_finite() && force.abs() <= CANCELLED * term {
                    *force = 0.0;
                }
            }
            if forces.iter().all(|x| x.is_finite()) {
                let row = |r: usize| (0..columns).map(move |column| column * speeds + r);
                samples[state % 2].extend((0..speeds).flat_map(row).map(|at| forces[at]));
            }
        }
        if samples.iter().all(|flat| !flat.is_empty()) {
            let matrix = |flat: Vec<f64>| DMatrix::from_row_slice(flat.len() / columns.max(1), columns, &flat);
            of_pose.push(samples.map(matrix));
        }
    }
    let usual = median_column_sizes_on_loops(&of_pose);
    let forces = |pose: &[DMatrix<f64>; 2]| {
        let size = |column: usize| pose[0].column(column).norm() / usual[column];
        (0..columns).map(size).fold(0.0, f64::max)
    };
    of_pose.retain(|pose| forces(pose) <= NEAR_DEAD);
    // A pose gives three independent rows for each degree of freedom: of the acceleration, the
    // square of the speed, and the loads. If half of the poses are too few for all columns, each
    // matrix has half of the states of all poses.
    let independent = ROWS_OF_POSE * speeds * of_pose.len();
    let is_by_poses = independent / 2 >= 2 * columns;
    let samples = [0, 1].map(|half| {
        let parts: Vec<&DMatrix<f64>> = if is_by_poses {
            of_pose.iter().skip(half).step_by(2).flatten().collect()
        } else {
            of_pose.iter().map(|parts| &parts[half]).collect()
        };
        let mut rows: Vec<_> =
            parts.iter().flat_map(|part| part.row_iter()).map(nalgebra::Matrix::into_owned).collect();
        for row in &mut rows {
            let size = row.iter().zip(&usual).map(|(x, usual)| (x / usual).powi(2)).sum::<f64>().sqrt();
            if size > 0.0 {
                *row /= size;
            }
        }
        rows
    });
    // With too few rows, relations may hold by accident.
    let is_some = samples.iter().all(|rows| !rows.is_empty()) && 2 * independent >= 3 * columns;
    is_some.then(|| (samples.map(|rows| DMatrix::from_rows(&rows)), of_pose.len()))
}

/// Removes singular poses and poses near them. There, the speeds do not determine q̇, or only with
/// large rounding errors. `None` if a derivative of the constraints or speeds has no value.
fn keep_regular_poses(
    model: &Model,
    arena: &mut Arena,
    of_poses: &[(Expr, f64)],
    coordinates: &[Expr],
    poses: &mut Vec<Vec<f64>>,
) -> Option<()> {
    let rates = model.q_dot();
    let mut gradient = Gradient::new(&rates);
    let equations: Vec<Expr> =
        model.motion_constraints.iter().map(|c| c.equation).chain(model.speeds.iter().map(|s| s.definition)).collect();
    let mut slopes = vec![Expr::ZERO; equations.len() * rates.len()];
    for (row, equation) in equations.iter().enumerate() {
        for &(at, slope) in gradient.apply(arena, *equation).iter() {
            slopes[row * rates.len() + at] = slope;
        }
    }
    // The equations are linear in the rates, so the values of the rates do not matter.
    let inputs = [of_poses.iter().map(|(s, _)| *s).collect(), coordinates.to_vec(), rates.clone()].concat();
    let tape = Tape::new(arena, &inputs, &slopes).ok()?;
    let matrix = |q: &Vec<f64>| {
        let known = of_poses.iter().map(|(_, x)| *x).chain(q.iter().copied());
        let values = tape.evaluate(&known.chain(rates.iter().map(|_| 0.0)).collect::<Vec<f64>>());
        DMatrix::from_row_slice(equations.len(), rates.len(), &values)
    };
    let all: Vec<(DMatrix<f64>, Vec<f64>)> = poses.drain(..).map(|q| (matrix(&q), q)).collect();
    let all: Vec<_> = all.into_iter().filter(|(matrix, _)| matrix.iter().all(|x| x.is_finite())).collect();
    // Each row is scaled by the same factor in all poses, so that a row of zeros in a pose makes
    // the pose singular.
    let longest = |row: usize| all.iter().map(|(matrix, _)| matrix.row(row).norm()).fold(0.0, f64::max);
    let longest: Vec<f64> = (0..equations.len()).map(longest).collect();
    let least = |mut matrix: DMatrix<f64>| {
        for (mut row, size) in matrix.row_iter_mut().zip(&longest) {
            if *size > 0.0 {
                row /= *size;
            }
        }
        singular_values(&matrix).min()
    };
    let mut judged: Vec<(f64, Vec<f64>)> = all.into_iter().map(|(matrix, q)| (least(matrix), q)).collect();
    judged.retain(|(least, _)| *least > SINGULAR);
    let mut sizes: Vec<f64> = judged.iter().map(|(least, _)| *least).collect();
    sizes.sort_by(f64::total_cmp);
    let usual = sizes.get(sizes.len() / 2).copied().unwrap_or(0.0);
    poses.extend(judged.into_iter().filter(|(least, _)| *least >= NEAR_SINGULAR * usual).map(|(_, q)| q));
    Some(())
}

/// Median length of each column over the poses in which it is not zero. It is 1 for a column that
/// is zero in all poses. A column that is zero in most poses may be nonzero in another assembly.
fn median_column_sizes_on_loops(of_pose: &[[DMatrix<f64>; 2]]) -> Vec<f64> {
    let columns = of_pose.first().map_or(0, |pose| pose[0].ncols());
    let usual = (0..columns).map(|column| {
        let sizes = of_pose.iter().map(|pose| pose[0].column(column).norm());
        let mut sizes: Vec<f64> = sizes.filter(|size| *size > 0.0).collect();
        sizes.sort_by(f64::total_cmp);
        sizes.get(sizes.len() / 2).copied().unwrap_or(1.0)
    });
    usual.collect()
}
