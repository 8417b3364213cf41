//! Inertial parameters that real bodies can have, nearest to measured forces.
//!
//! A body can have a mass m, a first moment s and second moments Σ = ∫ r rᵀ dm if and only if its pseudo-inertia [Σ s;
//! sᵀ m] is positive definite (P. M. Wensing, S. Kim & J.-J. E. Slotine, "Linear matrix inequalities for physically
//! consistent inertial parameter identification", IEEE Robotics and Automation Letters 3 (2018) 60–67). Here the
//! pseudo-inertia is L Lᵀ with a lower triangular L whose diagonal is exp(d), so that no constraint remains (C. Rucker
//! & P. M. Wensing, "Smooth parameterization of rigid-body inertia", ibid. 7 (2022) 2771–2778). The sum of squares is
//! convex in the parameters. So the smooth change of unknowns brings no local minimum.
//!
//! Combinations that the data do not tell stay near the values of the model.

use super::force_fit::{ForceEquations, ForceFit, MeasuredMotion};
use super::levenberg_marquardt::{Residuals, WithJacobian, minimize};
use crate::{Error, Mechanism};
use nalgebra::{DMatrix, DVector, Matrix4};
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::identify::{BaseParameter, Identification};
use tripos_derive::mechanics::{ColumnParameter, InertialParameter};

/// Weight of a relative change of a parameter from its value in the model, in standard deviations. The data outweigh it
/// for every combination that they tell to better than this number of its size.
const TOWARDS_MODEL: f64 = 1e-3;
/// Part of the square of a body's length that is added to its second moments at the start of the search. A flat body
/// lies on the boundary of the possible ones, where the search would not move.
const THICKER: f64 = 0.05;
/// Largest number of steps of the search.
const STEPS: usize = 5000;
/// Number of unknowns of the pseudo-inertia of a rigid body.
const UNKNOWNS: usize = 10;

/// Inertial parameters that real bodies can have, fitted to measured forces.
pub struct PossibleInertia {
    /// Name, unit and value of each inertial parameter and load parameter, in the order of the regressor's columns.
    pub parameters: Vec<(String, String, f64)>,
    /// Root of the mean square of all residuals of the forces, in standard deviations.
    pub residual: f64,
    /// The same root for the base parameters without conditions.
    pub free_residual: f64,
    /// True if the search came to an end by itself.
    pub has_converged: bool,
}

/// Part of the unknowns: the columns of a rigid body, of a particle, or of a parameter of loads.
enum Part {
    /// Rigid body: the column of each of its parameters.
    Rigid(Vec<(usize, InertialParameter)>),
    /// Particle: the column of its mass, which is the exponential of the unknown.
    Particle(usize),
    /// Parameter of loads: its column. The unknown is its value.
    Free(usize),
}

/// Residuals R π − d of the forces, and the distances of the parameters π from the model, as functions of the unknowns.
struct PossibleResiduals {
    /// Parts of the unknowns, in their order.
    parts: Vec<Part>,
    /// Triangular factor R of the equations in standard deviations.
    triangle: DMatrix<f64>,
    /// Sides d in the axes of R.
    side: DVector<f64>,
    /// Values of the parameters in the model.
    stated: Vec<f64>,
    /// Sizes of the parameters, by which changes are relative.
    sizes: Vec<f64>,
}

/// Finds inertial parameters that real bodies can have, nearest to the measured forces of a fit of base parameters.
///
/// # Errors
/// [`Error::Request`] if a column of the regressor or a stated value contains a symbol without a value.
pub fn possible_inertia(
    model: &Mechanism,
    found: &Identification,
    experiments: &[Vec<MeasuredMotion>],
    fit: &ForceFit,
) -> Result<PossibleInertia, Error> {
    let columns = found.regressor.columns.len();
    let motions: Vec<&MeasuredMotion> = experiments.iter().flatten().collect();
    let each = (0..columns).map(|column| BaseParameter { column, with: Vec::new() }).collect::<Vec<_>>();
    let equations = ForceEquations::new(model, found, &each, &motions)?;
    let rows: Vec<usize> = (0..equations.side.len()).collect();
    let (matrix, mut side) = equations.weighted(&rows, &fit.weights);
    let whole = side.norm_squared();
    let triangle = if matrix.nrows() > columns {
        let qr = matrix.qr();
        qr.q_tr_mul(&mut side);
        side = side.rows(0, columns).into_owned();
        qr.r()
    } else {
        matrix
    };
    // What no parameters can explain.
    let beyond = (whole - side.norm_squared()).max(0.0);
    let stated = stated_values(model, found, motions[0])?;
    let mut residuals = PossibleResiduals { parts: parts_of_columns(found), triangle, side, sizes: Vec::new(), stated };
    let start = residuals.start();
    let bounds = vec![f64::NEG_INFINITY..=f64::INFINITY; start.len()];
    let minimum = minimize(&mut residuals, &start, &bounds, STEPS)?;
    let values = residuals.parameters(&minimum.x).0;
    let left = (&residuals.triangle * &values - &residuals.side).norm_squared() + beyond;
    let named = found.regressor.columns.iter().zip(values.iter());
    Ok(PossibleInertia {
        parameters: named.map(|(column, value)| (column.name.clone(), column.unit.to_string(), *value)).collect(),
        residual: (left / rows.len() as f64).sqrt(),
        free_residual: (fit.sum_of_squares / rows.len() as f64).sqrt(),
        has_converged: minimum.has_converged,
    })
}

/// Values of the regressor's parameters in the model, at the parameter values of a measured motion.
///
/// # Errors
/// [`Error::Request`] if a value contains a symbol without a value.
fn stated_values(model: &Mechanism, found: &Identification, moving: &MeasuredMotion) -> Result<Vec<f64>, Error> {
    let regressor = &found.regressor;
    let terms: Vec<_> = regressor.columns.iter().map(|column| column.stated).collect();
    let tape: Tape<f64> = crate::code::compile_tape(&regressor.arena, &model.p(), &terms, "an inertial parameter")?;
    Ok(tape.evaluate(&moving.p))
}

/// Groups the columns of the regressor by bodies.
fn parts_of_columns(found: &Identification) -> Vec<Part> {
    let mut parts: Vec<(Option<usize>, Part)> = Vec::new();
    for (at, column) in found.regressor.columns.iter().enumerate() {
        match column.of {
            ColumnParameter::Parameter(_) => parts.push((None, Part::Free(at))),
            ColumnParameter::Body(body, parameter) => match parts.iter_mut().find(|(of, _)| *of == Some(body)) {
                Some((_, Part::Rigid(list))) => list.push((at, parameter)),
                _ => parts.push((Some(body), Part::Rigid(vec![(at, parameter)]))),
            },
        }
    }
    let single = |part: Part| match part {
        Part::Rigid(list) if list.len() == 1 => Part::Particle(list[0].0),
        other => other,
    };
    parts.into_iter().map(|(_, part)| single(part)).collect()
}

/// Row and column in L of the unknown with this index: the diagonal first, then the entries below it, row by row.
const PLACES: [(usize, usize); UNKNOWNS] =
    [(0, 0), (1, 1), (2, 2), (3, 3), (1, 0), (2, 0), (2, 1), (3, 0), (3, 1), (3, 2)];

/// Factor L of a pseudo-inertia from its unknowns.
fn factor(x: &[f64]) -> Matrix4<f64> {
    let mut l = Matrix4::zeros();
    for (at, (i, j)) in PLACES.iter().enumerate() {
        l[(*i, *j)] = if i == j { x[at].exp() } else { x[at] };
    }
    l
}

/// Value of an inertial parameter in a pseudo-inertia. The value is linear in the pseudo-inertia.
fn value_in(pseudo: &Matrix4<f64>, parameter: InertialParameter) -> f64 {
    match parameter {
        InertialParameter::Mass => pseudo[(3, 3)],
        InertialParameter::FirstMoment(i) => pseudo[(i, 3)],
        InertialParameter::SecondMoment(i) => pseudo[(i, i)],
        InertialParameter::Inertia(i, j) if i == j => {
            pseudo[((i + 1) % 3, (i + 1) % 3)] + pseudo[((i + 2) % 3, (i + 2) % 3)]
        }
        InertialParameter::Inertia(i, j) => -pseudo[(i, j)],
    }
}

/// Pseudo-inertia of the stated parameters of a body.
fn stated_pseudo_inertia(list: &[(usize, InertialParameter)], stated: &[f64]) -> Matrix4<f64> {
    let of = |wanted: InertialParameter| {
        list.iter().find(|(_, parameter)| *parameter == wanted).map_or(0.0, |(at, _)| stated[*at])
    };
    let about = |i: usize| of(InertialParameter::Inertia(i, i));
    let off = |i: usize, j: usize| {
        of(InertialParameter::Inertia(i, j)) + if i == j { 0.0 } else { of(InertialParameter::Inertia(j, i)) }
    };
    Matrix4::from_fn(|i, j| match (i, j) {
        (3, 3) => of(InertialParameter::Mass),
        (3, k) | (k, 3) => of(InertialParameter::FirstMoment(k)),
        _ if i == j => 0.5 * (about((i + 1) % 3) + about((i + 2) % 3) - about(i)),
        _ => -off(i, j),
    })
}

impl PossibleResiduals {
    /// Unknowns near the stated parameters, and the sizes of all parameters. Each body is thickened a little.
    fn start(&mut self) -> Vec<f64> {
        self.sizes = self.stated.iter().map(|value| if *value == 0.0 { 1.0 } else { value.abs() }).collect();
        let mut x = Vec::new();
        for part in &self.parts {
            match part {
                Part::Free(at) => x.push(self.stated[*at]),
                Part::Particle(at) => x.push(self.sizes[*at].ln()),
                Part::Rigid(list) => {
                    let mut pseudo = stated_pseudo_inertia(list, &self.stated);
                    let mass = if pseudo[(3, 3)] > 0.0 { pseudo[(3, 3)] } else { 1.0 };
                    let second = (0..3).map(|i| pseudo[(i, i)].abs()).sum::<f64>();
                    // Square of a length of the body, m².
                    let square = if second > 0.0 { second / mass } else { 1e-2 };
                    for (at, parameter) in list {
                        self.sizes[*at] = mass
                            * match parameter {
                                InertialParameter::Mass => 1.0,
                                InertialParameter::FirstMoment(_) => square.sqrt(),
                                InertialParameter::Inertia(..) | InertialParameter::SecondMoment(_) => square,
                            };
                    }
                    // Far from the boundary, where the search moves freely.
                    let mut thicker = THICKER;
                    let l = loop {
                        for i in 0..3 {
                            pseudo[(i, i)] += thicker * mass * square;
                        }
                        if let Some(cholesky) = pseudo.cholesky() {
                            break cholesky.l();
                        }
                        pseudo[(3, 3)] += thicker * mass;
                        thicker *= 2.0;
                    };
                    x.extend(PLACES.iter().map(|(i, j)| if i == j { l[(*i, *j)].ln() } else { l[(*i, *j)] }));
                }
            }
        }
        x
    }

    /// Values of all parameters at the unknowns, with their derivatives: a row for each parameter, a column for each
    /// unknown.
    fn parameters(&self, x: &[f64]) -> (DVector<f64>, DMatrix<f64>) {
        let count = self.stated.len();
        let mut values = DVector::zeros(count);
        let mut slopes = DMatrix::zeros(count, x.len());
        let mut first = 0;
        for part in &self.parts {
            match part {
                Part::Free(at) => {
                    values[*at] = x[first];
                    slopes[(*at, first)] = 1.0;
                    first += 1;
                }
                Part::Particle(at) => {
                    values[*at] = x[first].exp();
                    slopes[(*at, first)] = values[*at];
                    first += 1;
                }
                Part::Rigid(list) => {
                    let l = factor(&x[first..first + UNKNOWNS]);
                    let pseudo = l * l.transpose();
                    for (at, parameter) in list {
                        values[*at] = value_in(&pseudo, *parameter);
                    }
                    for (k, (i, j)) in PLACES.iter().enumerate() {
                        let mut change = Matrix4::zeros();
                        change[(*i, *j)] = if i == j { l[(*i, *j)] } else { 1.0 };
                        let half = change * l.transpose();
                        let change = half + half.transpose();
                        for (at, parameter) in list {
                            slopes[(*at, first + k)] = value_in(&change, *parameter);
                        }
                    }
                    first += UNKNOWNS;
                }
            }
        }
        (values, slopes)
    }

    /// Residuals of given values of the parameters: those of the forces, then the distances from the model.
    fn of_values(&self, values: &DVector<f64>) -> DVector<f64> {
        let forces = &self.triangle * values - &self.side;
        let apart = values.iter().zip(&self.stated).zip(&self.sizes);
        let apart = apart.map(|((value, stated), size)| TOWARDS_MODEL * (value - stated) / size);
        DVector::from_vec(forces.iter().copied().chain(apart).collect())
    }
}

impl Residuals for PossibleResiduals {
    fn residuals(&mut self, x: &[f64]) -> Result<Option<DVector<f64>>, Error> {
        Ok(Some(self.of_values(&self.parameters(x).0)))
    }

    fn with_jacobian(&mut self, x: &[f64]) -> Result<WithJacobian, Error> {
        let (values, slopes) = self.parameters(x);
        let forces = &self.triangle * &slopes;
        let (above, unknowns) = (forces.nrows(), slopes.ncols());
        let jacobian = DMatrix::from_fn(above + slopes.nrows(), unknowns, |i, j| {
            if i < above { forces[(i, j)] } else { TOWARDS_MODEL * slopes[(i - above, j)] / self.sizes[i - above] }
        });
        Ok((self.of_values(&values), jacobian))
    }
}

#[cfg(test)]
mod tests {
    use super::{UNKNOWNS, factor, stated_pseudo_inertia, value_in};
    use tripos_derive::mechanics::InertialParameter;

    /// Goal: parameters and pseudo-inertia are the same thing in two forms. Method: from a factor to the parameters and
    /// back.
    #[test]
    fn parameters_give_back_their_pseudo_inertia() {
        let x: Vec<f64> = (0..UNKNOWNS).map(|at| 0.3 - 0.1 * at as f64).collect();
        let l = factor(&x);
        let pseudo = l * l.transpose();
        let list: Vec<(usize, InertialParameter)> = [
            InertialParameter::Mass,
            InertialParameter::FirstMoment(0),
            InertialParameter::FirstMoment(1),
            InertialParameter::FirstMoment(2),
            InertialParameter::Inertia(0, 0),
            InertialParameter::Inertia(1, 1),
            InertialParameter::Inertia(2, 2),
            InertialParameter::Inertia(0, 1),
            InertialParameter::Inertia(2, 0),
            InertialParameter::Inertia(1, 2),
        ]
        .into_iter()
        .enumerate()
        .collect();
        let values: Vec<f64> = list.iter().map(|(_, parameter)| value_in(&pseudo, *parameter)).collect();
        assert!((stated_pseudo_inertia(&list, &values) - pseudo).amax() < 1e-14);
    }
}
