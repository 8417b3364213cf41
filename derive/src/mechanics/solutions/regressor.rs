//! Regressor: generalized forces that a motion requires, split by parameters π: M u̇ − f = Σ π_k Y_k + rest. No
//! column Y_k contains a parameter π.
//!
//! A rigid body moves with the velocity v of its point P and rotates with ω. Its weight counts as an inertia force.
//! The force on the body and the moment about P are linear in its mass m, its first moments s = m p_PC and its
//! inertia J about P:
//!
//! ```text
//! F = m b + α × s + ω × (ω × s),    N = s × b + J α + ω × J ω,    b = a_P − g
//! ```
//!
//! C. G. Atkeson, C. H. An & J. M. Hollerbach, "Estimation of inertial parameters of manipulator loads and links",
//! Int. J. Robotics Research 5(3) (1986) 101–119. The columns use nothing from Kane's equations, with which the
//! regressor is compared.

use crate::algebra::term::calculus::Gradient;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::geometry::{Components, Vector, apply_tensor, cross_components};
use crate::mechanics::derivation::derive_with;
use crate::mechanics::derive_error::DeriveError;
use crate::mechanics::formulations::formulation::Formulation;
use crate::mechanics::motion::equation_form::EquationForm;
use crate::mechanics::motion::inertial_anchor::Anchor;
use crate::mechanics::motion::inertial_parameter::InertialParameter;
use crate::mechanics::motion::kinematics::{Kinematics, Velocities, kinematic_rates, rates_to_speeds};
use crate::mechanics::motion::loads::Load;
use crate::mechanics::motion::placed_inertia::PlacedInertia;
use crate::mechanics::motion::tree_accelerations::{Accelerations, AlphaTerms};
use crate::model::{Model, Unit};

/// Choice of the parameters for which a regressor has columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RegressorParameters {
    /// All ten inertial parameters of every rigid body, the mass of every particle, and the mass-like parameters of
    /// loads. The values that the model file states do not matter.
    Bodies,
    /// Parameters of the model file whose unit contains kg to the first power.
    Declared,
}

/// Parameter to which a regressor's column belongs: an inertial parameter of a body, or a parameter of the model
/// file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnParameter {
    /// Inertial parameter of the body with this index.
    Body(usize, InertialParameter),
    /// Parameter of the model file with this index.
    Parameter(usize),
}

/// Column of a regressor: the generalized forces that the motion requires per unit of a parameter.
#[derive(Clone, Debug)]
pub struct Column {
    /// Parameter to which the column belongs.
    pub of: ColumnParameter,
    /// Name of the parameter and its body, such as `mx_rod`.
    pub name: String,
    /// Unit of the parameter of the column.
    pub unit: Unit,
    /// Generalized forces Y_k per unit of the parameter, one for each speed, as terms in geometry, q, u
    /// and u̇.
    pub forces: Vec<Expr>,
    /// Value of the parameter in the model, as a term in the model file's parameters.
    pub stated: Expr,
}

/// Regressor of a model: columns Y_k of M u̇ − f = Σ π_k Y_k + rest, for the parameters π_k.
pub struct Regressor {
    /// Arena of the terms of all fields.
    pub arena: Arena,
    /// Columns Y_k of the regressor, for bodies from the ground outward. The columns of a body are in the order in
    /// which base parameters should keep them.
    pub columns: Vec<Column>,
    /// Required generalized forces from loads that belong to no column, one for each speed.
    pub rest: Vec<Expr>,
    /// Required generalized forces M u̇ − f by Kane's method, one for each speed, in parameters, q, u
    /// and u̇.
    pub required: Vec<Expr>,
    /// Anchor of each body: the reference point and axes of its inertial parameters. Empty for
    /// [`RegressorParameters::Declared`].
    pub anchors: Vec<Anchor>,
}

impl Regressor {
    /// Derives the regressor of a model for the chosen parameters.
    ///
    /// # Errors
    /// Returns a [`DeriveError`] if the model cannot be derived, or if a body has an added mass.
    pub fn new(model: &Model, varied: RegressorParameters) -> Result<Self, DeriveError> {
        let (kinematics, required) = Self::required_by_kane(model)?;
        let candidates: Vec<usize> =
            (0..model.parameters.len()).filter(|at| is_regressor_candidate(&model.parameters[*at])).collect();
        Ok(match varied {
            RegressorParameters::Bodies => {
                Self::regressor_of_bodies(model, kinematics, required, &Anchor::parameters, &candidates)
            }
            RegressorParameters::Declared => {
                Self::regressor_of_declared_parameters(model, kinematics.arena, required, candidates)
            }
        })
    }

    /// Derives the regressor for inertial parameters of the bodies alone. Parameters of loads count as known. The
    /// function `parameters` gives the ten parameters of the body of an anchor, those first that base parameters should
    /// keep.
    ///
    /// # Errors
    /// Returns a [`DeriveError`], for the same reasons as [`Self::new`].
    pub fn of_bodies(
        model: &Model,
        parameters: &dyn Fn(&Anchor) -> Vec<InertialParameter>,
    ) -> Result<Self, DeriveError> {
        let (kinematics, required) = Self::required_by_kane(model)?;
        Ok(Self::regressor_of_bodies(model, kinematics, required, parameters, &[]))
    }

    /// Derives the required generalized forces M u̇ − f by Kane's method, with the kinematics. `Err` if the model cannot
    /// be derived, or if a body has an added mass.
    fn required_by_kane(model: &Model) -> Result<(Kinematics, Vec<Expr>), DeriveError> {
        if let Some(added) = model.added_masses.first() {
            return Err(DeriveError::AddedMass { body: model.bodies[added.body].name.clone() });
        }
        let mut kinematics = Kinematics::in_form(model, EquationForm::Steps)?;
        let equations = derive_with(model, &mut kinematics, Formulation::Kane)?;
        let proved = equations.with_certified_inverse_dynamics(&mut kinematics.arena);
        let required = proved.map_err(|why| DeriveError::Unsolved(why.into()))?.required;
        Ok((kinematics, required))
    }

    /// Builds columns for the inertial parameters of all bodies and for the mass-like parameters of
    /// loads.
    fn regressor_of_bodies(
        model: &Model,
        mut kinematics: Kinematics,
        required: Vec<Expr>,
        parameters: &dyn Fn(&Anchor) -> Vec<InertialParameter>,
        candidates: &[usize],
    ) -> Self {
        let velocities = kinematics.in_speeds(model);
        let accelerations = kinematics.accelerations(
            model,
            &velocities,
            &mut kinematic_rates(model),
            &Kinematics::fall(model),
            AlphaTerms::InMatrix,
        );
        let mut bodies: Vec<(usize, Vec<Column>)> = Vec::new();
        let mut anchors = Vec::new();
        for at in 0..model.bodies.len() {
            let anchor = Anchor::of(model, at);
            let motion = BodyRegressor::new(&mut kinematics, model, &velocities, &accelerations, &anchor);
            let deep = motion.moves_with();
            bodies.push((deep, motion.columns(&mut kinematics, model, &anchor, parameters(&anchor))));
            anchors.push(anchor);
        }
        // Bodies are in order from the ground outward, so that a base parameter shared by an outer and an inner body
        // belongs to the inner body.
        bodies.sort_by_key(|(deep, _)| *deep);
        let mut columns: Vec<Column> = bodies.into_iter().flat_map(|(_, columns)| columns).collect();
        let loads: Vec<Load> = kinematics.loads(model, &velocities).into_iter().flatten().collect();
        let forces = kinematics.forces_of_load_pairs(&loads, &mut rates_to_speeds(model), &model.u());
        let arena = &mut kinematics.arena;
        let needed: Vec<Expr> = forces.iter().map(|e| arena.neg(*e)).collect();
        let (of_loads, rest) = regressor_columns_of_parameters(model, arena, needed, candidates.to_vec());
        columns.extend(of_loads);
        Self { arena: kinematics.arena, columns, rest, required, anchors }
    }

    /// Builds columns for the mass-like parameters of the model file, in which the forces are linear.
    fn regressor_of_declared_parameters(
        model: &Model,
        mut arena: Arena,
        required: Vec<Expr>,
        candidates: Vec<usize>,
    ) -> Self {
        let (columns, rest) = regressor_columns_of_parameters(model, &mut arena, required.clone(), candidates);
        Self { arena, columns, rest, required, anchors: Vec::new() }
    }
}

/// True if the unit of a parameter contains kg to the first power, and the parameter is not an input. Forces are
/// linear in all such parameters together, unless they form ratios.
fn is_regressor_candidate(parameter: &crate::model::Parameter) -> bool {
    !parameter.is_input && parameter.unit.kilogram_exponent().is_one()
}

/// Splits forces into Σ θ Y_θ + rest, for those candidate parameters θ in which the forces are
/// linear. Other candidates count as known. Returns the columns Y_θ and the rest.
fn regressor_columns_of_parameters(
    model: &Model,
    arena: &mut Arena,
    forces: Vec<Expr>,
    mut candidates: Vec<usize>,
) -> (Vec<Column>, Vec<Expr>) {
    let (slopes, kept) = loop {
        let symbols: Vec<Expr> = candidates.iter().map(|at| model.parameters[*at].symbol).collect();
        let slopes = regressor_slope_rows(arena, &forces, &symbols);
        let bent = is_nonlinear_in_parameters(arena, &slopes, &symbols);
        if bent.iter().all(|bent| !bent) {
            break (slopes, candidates);
        }
        let mut bent = bent.into_iter();
        candidates.retain(|_| !bent.next().unwrap_or(false));
    };
    let mut rest = forces;
    let mut columns = Vec::new();
    for (k, at) in kept.into_iter().enumerate() {
        let parameter = &model.parameters[at];
        let forces: Vec<Expr> = slopes.iter().map(|row| row[k]).collect();
        if forces.iter().all(|e| *e == Expr::ZERO) {
            continue;
        }
        for (left, force) in rest.iter_mut().zip(&forces) {
            let part = arena.mul(*force, parameter.symbol);
            *left = arena.sub(*left, part);
        }
        let (name, unit, stated) = (parameter.name.clone(), parameter.unit.clone(), parameter.symbol);
        columns.push(Column { of: ColumnParameter::Parameter(at), name, unit, forces, stated });
    }
    (columns, rest)
}

/// Partial derivatives of each term with respect to each symbol, one row for each term.
fn regressor_slope_rows(arena: &mut Arena, terms: &[Expr], symbols: &[Expr]) -> Vec<Vec<Expr>> {
    let mut gradient = Gradient::new(symbols);
    let row = |term: &Expr| {
        let mut row = vec![Expr::ZERO; symbols.len()];
        for &(at, slope) in gradient.apply(arena, *term).iter() {
            row[at] = slope;
        }
        row
    };
    terms.iter().map(row).collect()
}

/// For each symbol: true if a derivative with respect to it still contains any of the symbols. `slopes` has a row of
/// derivatives for each force.
fn is_nonlinear_in_parameters(arena: &mut Arena, slopes: &[Vec<Expr>], symbols: &[Expr]) -> Vec<bool> {
    let mut gradient = Gradient::new(symbols);
    let mut bent = vec![false; symbols.len()];
    for row in slopes {
        for (at, slope) in row.iter().enumerate() {
            let seconds = gradient.apply(arena, *slope);
            bent[at] |= seconds.iter().any(|(_, second)| zero_test(arena, *second) != ZeroTest::Zero);
        }
    }
    bent
}

/// Motion of a body, with components along the axes of its anchor: accelerations, angular velocity and partial
/// velocities.
struct BodyRegressor {
    /// Acceleration b = a_P − g of the anchor's point P less that of free fall, m/s².
    b: Components,
    /// Angular velocity ω of the body, rad/s.
    omega: Components,
    /// Angular acceleration α of the body, rad/s².
    alpha: Components,
    /// Partial velocities ∂v_P/∂u_r and ∂ω/∂u_r of the body, a pair for each speed u_r.
    along: Vec<[Components; 2]>,
}

impl BodyRegressor {
    /// Computes the motion of a body. Each long subterm gets a name.
    fn new(
        kinematics: &mut Kinematics,
        model: &Model,
        velocities: &Velocities,
        accelerations: &Accelerations,
        anchor: &Anchor,
    ) -> Self {
        let name = regressor_body_name(model, anchor);
        let Kinematics { arena, frames, .. } = kinematics;
        let mut carry =
            |vector: &Vector, letter: &str| frames.express_frame_by_frame(arena, vector, anchor.frame, letter, &name);
        let v = carry(&velocities.linear[anchor.point], "v");
        let b = carry(&accelerations.linear[anchor.point], "a");
        let (omega, alpha) = match anchor.turns {
            Some(frame) => (carry(&velocities.angular[frame], "w"), carry(&accelerations.angular[frame], "alpha")),
            None => ([Expr::ZERO; 3], [Expr::ZERO; 3]),
        };
        let rows = regressor_slope_rows(arena, &[v, omega].concat(), &model.u());
        let along = (0..model.speeds.len())
            .map(|r| [[rows[0][r], rows[1][r], rows[2][r]], [rows[3][r], rows[4][r], rows[5][r]]])
            .collect();
        Self { b, omega, alpha, along }
    }

    /// Number of generalized speeds that move the body.
    fn moves_with(&self) -> usize {
        self.along.iter().filter(|pair| pair.iter().flatten().any(|e| *e != Expr::ZERO)).count()
    }

    /// Builds the regressor's columns for the inertial parameters of the body.
    fn columns(
        &self,
        kinematics: &mut Kinematics,
        model: &Model,
        anchor: &Anchor,
        parameters: Vec<InertialParameter>,
    ) -> Vec<Column> {
        let body = &model.bodies[anchor.body];
        let stated = PlacedInertia::about_anchor(kinematics, body, anchor);
        parameters
            .into_iter()
            .map(|inertial| {
                let arena = &mut kinematics.arena;
                let [force, moment] = self.wrench(arena, inertial);
                let forces = self.along.iter().map(|[v, w]| {
                    let products = v.iter().zip(&force).chain(w.iter().zip(&moment));
                    let terms: Vec<Expr> = products.map(|(a, b)| arena.mul(*a, *b)).collect();
                    arena.sum(&terms)
                });
                Column {
                    of: ColumnParameter::Body(anchor.body, inertial),
                    forces: forces.collect(),
                    name: format!("{}_{}", inertial.parameter_symbol(), body.name),
                    unit: inertial.unit(),
                    stated: stated.value(arena, inertial),
                }
            })
            .collect()
    }

    /// Force F on the body and moment N about P that the motion requires per unit of an inertial parameter.
    fn wrench(&self, arena: &mut Arena, inertial: InertialParameter) -> [Components; 2] {
        let zero = [Expr::ZERO; 3];
        match inertial {
            InertialParameter::Mass => [self.b, zero],
            InertialParameter::FirstMoment(axis) => {
                let mut e = zero;
                e[axis] = Expr::ONE;
                let turning = cross_components(arena, &self.alpha, &e);
                let within = cross_components(arena, &self.omega, &e);
                let inward = cross_components(arena, &self.omega, &within);
                let force = std::array::from_fn(|i| arena.add(turning[i], inward[i]));
                [force, cross_components(arena, &e, &self.b)]
            }
            InertialParameter::Inertia(i, j) => {
                let mut unit = [zero; 3];
                (unit[i][j], unit[j][i]) = (Expr::ONE, Expr::ONE);
                [zero, self.moment_of_tensor(arena, &unit)]
            }
            InertialParameter::SecondMoment(axis) => {
                let mut unit = [zero; 3];
                (0..3).filter(|i| *i != axis).for_each(|i| unit[i][i] = Expr::ONE);
                [zero, self.moment_of_tensor(arena, &unit)]
            }
        }
    }

    /// Moment J α + ω × J ω on the body that the motion requires for an inertia tensor J.
    fn moment_of_tensor(&self, arena: &mut Arena, tensor: &[Components; 3]) -> Components {
        let rate = apply_tensor(arena, tensor, &self.alpha);
        let momentum = apply_tensor(arena, tensor, &self.omega);
        let gyroscopic = cross_components(arena, &self.omega, &momentum);
        std::array::from_fn(|k| arena.add(rate[k], gyroscopic[k]))
    }
}

/// Name of the body to which an anchor belongs.
fn regressor_body_name(model: &Model, anchor: &Anchor) -> String {
    model.bodies[anchor.body].name.clone()
}
