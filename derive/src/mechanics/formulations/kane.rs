//! Kane's method: F_r + F*_r = 0 for each generalized speed.
//!
//! Kane & Levinson, *Dynamics: Theory and Applications* (1985), §§ 4.4, 4.11, 6.1.

use super::tree_recursion::{FORCE, symmetric_derivative_matrix};
use crate::algebra::Expr;
use crate::algebra::term::adjoint::adjoint_product;
use crate::algebra::term::calculus::{Differential, Gradient, expand_names};
use crate::geometry::{Dots, SymmetricDots, Vector};
use crate::mechanics::derive_error::DeriveError;
use crate::mechanics::motion::energy::VelocityMomentum;
use crate::mechanics::motion::kinematics::{
    Kinematics, Velocities, kinematic_rates, kinematic_rates_without_acceleration, rates_to_speeds,
};
use crate::mechanics::motion::loads::{Load, active_forces_of_loads};
use crate::mechanics::motion::placed_inertia::PlacedInertia;
use crate::mechanics::motion::tree_accelerations::AlphaTerms;
use crate::mechanics::quantity::{QuantityKind, VectorName};
use crate::mechanics::rows::{LineName, RowName, Rows, Stage, Step, component_lines, kinematic_step};
use crate::model::Model;

/// Derives Kane's equations M(q) u̇ = f(q, u).
///
/// # Errors
/// Never returns an error. The rank of the matrix shows later if a speed moves no mass.
#[expect(clippy::unnecessary_wraps, reason = "a row of the table of formulations, of which others may fail")]
pub fn derive_kane(model: &Model, kinematics: &mut Kinematics) -> Result<Rows, DeriveError> {
    let velocities = kinematics.in_speeds(model);
    if kinematics.frames.carries {
        let loads: Vec<Load> = kinematics.loads(model, &velocities).into_iter().flatten().collect();
        let fall = Kinematics::fall(model);
        let (matrix, forcing) = kinematics.kane_system_by_recursion(model, &velocities, &loads, &fall);
        let mut moving = kinematic_rates(model);
        let along = kinematics.forces_of_velocity_pairs(model, &velocities, &loads, &fall, &mut moving);
        let required = along.into_iter().map(|e| kinematics.arena.neg(e)).collect();
        // The accelerations of dependent speeds are not linear in few names, which a recursion would need.
        let is_tree = !model.kinematic_equations.has_dependent_speeds;
        let gauss = is_tree.then(|| kinematics.gauss_function_along_tree(model, &velocities, &loads));
        let momenta = kinematics.momentum_pairs(model, &velocities);
        return Ok(Rows {
            names: (0..model.speeds.len()).map(RowName::Speed).collect(),
            matrix,
            forcing,
            projection: Vec::new(),
            embedding: None,
            required: Some(required),
            gauss,
            kinetic_energy: kinematics.kinetic_energy_of_momentum_pairs(&momenta),
        });
    }
    let active = active_forces_of_loads(model, kinematics, &velocities);
    let inertia = GeneralizedInertia::new(model, kinematics, &velocities);
    let Kinematics { arena, simplifier, .. } = kinematics;
    // F + F* = 0 with F* = −(M u̇ + rest):  M u̇ = F − rest.
    let matrix = inertia.matrix.iter().map(|row| row.iter().map(|e| simplifier.simplify(arena, *e)).collect());
    let matrix: Vec<Vec<Expr>> = matrix.collect();
    let forcing = active.iter().zip(&inertia.rest).map(|(force, rest)| arena.sub(*force, *rest)).collect();
    Ok(Rows {
        names: (0..model.speeds.len()).map(RowName::Speed).collect(),
        // M is also the matrix of the kinetic energy.
        kinetic_energy: kinematics.kinetic_energy_of_matrix(model, &velocities, &model.u(), &matrix),
        matrix,
        forcing,
        projection: Vec::new(),
        embedding: None,
        required: None,
        gauss: None,
    })
}

impl Kinematics {
    /// Kane's equations M u̇ = f as (M, f), by recursion along the tree. `loads` are the applied loads, and `fall` is
    /// the acceleration of free fall. Partial velocities are never written out.
    fn kane_system_by_recursion(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        loads: &[Load],
        fall: &Vector,
    ) -> (Vec<Vec<Expr>>, Vec<Expr>) {
        let mut resting = kinematic_rates_without_acceleration(model);
        let forcing = self.forces_of_velocity_pairs(model, velocities, loads, fall, &mut resting);
        let matrix = match self.composite_mass_matrix(model, velocities, &model.u()) {
            Some(form) => form,
            None => self.kinetic_energy_matrix(model, velocities, &model.u()),
        };
        (matrix, forcing)
    }
}

/// Kane's equations of bodies whose inertias are given about points that are fixed in the bodies.
pub(in crate::mechanics) struct KaneSystem {
    /// Symmetric mass matrix M, one row and one column for each speed.
    pub matrix: Vec<Vec<Expr>>,
    /// Forcing f of M u̇ = f, one entry for each speed.
    pub forcing: Vec<Expr>,
    /// Inverse dynamics M u̇ − f, one entry for each speed.
    pub required: Vec<Expr>,
}

impl Kinematics {
    /// Kane's equations by recursion along the tree, for bodies with the given inertias instead of the model's. The
    /// kinematics must have named subterms.
    pub(in crate::mechanics) fn kane_system_of(&mut self, model: &Model, bodies: &[PlacedInertia]) -> KaneSystem {
        let velocities = self.in_speeds(model);
        let loads: Vec<Load> = self.loads(model, &velocities).into_iter().flatten().collect();
        let required = self.required_forces_of(model, &velocities, &loads, bodies, &mut kinematic_rates(model));
        let mut resting = kinematic_rates_without_acceleration(model);
        let bias = self.required_forces_of(model, &velocities, &loads, bodies, &mut resting);
        let matrix = self.composite_mass_matrix_of(bodies, model, &velocities, &model.u()).unwrap_or_else(|| {
            let rates: Vec<Expr> = model.speeds.iter().map(|speed| speed.rate).collect();
            symmetric_derivative_matrix(&mut self.arena, &required, &rates)
        });
        let forcing = bias.into_iter().map(|e| self.arena.neg(e)).collect();
        KaneSystem { matrix, forcing, required }
    }

    /// Generalized forces that bodies with the given inertias require, less the loads, one for each speed. They hold in
    /// a motion in which the state has the given `rates`.
    fn required_forces_of(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        loads: &[Load],
        bodies: &[PlacedInertia],
        rates: &mut Differential,
    ) -> Vec<Expr> {
        let fall = Self::fall(model);
        let accelerations = self.accelerations(model, velocities, rates, &fall, AlphaTerms::InMatrix);
        let mut pairs = Vec::new();
        for body in bodies {
            pairs.extend(body.inertia_pairs(self, model, velocities, &accelerations));
        }
        let of_loads = self.forces_of_load_pairs(loads, &mut rates_to_speeds(model), &model.u());
        // Torques between neighbours act along one speed each, and need no sums along the tree.
        let are_short = of_loads.iter().all(|e| expand_names(&mut self.arena, *e) == *e);
        if !are_short {
            pairs.extend(self.load_pairs(loads, &mut rates_to_speeds(model)));
        }
        let forces = adjoint_product(&mut self.arena, &pairs, &model.u(), FORCE);
        let sum = |(force, load): (Expr, Expr)| {
            let whole = if are_short { self.arena.add(force, load) } else { force };
            self.arena.neg(whole)
        };
        forces.into_iter().zip(of_loads).map(sum).collect()
    }
}

/// Generalized active forces F_r = Σ_P (∂v_P/∂u_r)·R_P + Σ_B (∂ω_B/∂u_r)·T_B, one entry for each
/// speed. Weights are included; reactions do not contribute.
///
/// Entry r has the unit of power divided by the unit of u_r.
pub(in crate::mechanics) fn kane_active_forces(
    model: &Model,
    kinematics: &mut Kinematics,
    velocities: &Velocities,
) -> Vec<Expr> {
    let forces = active_forces_of_loads(model, kinematics, velocities);
    forces.into_iter().map(|e| kinematics.simplifier.simplify(&mut kinematics.arena, e)).collect()
}

/// Generalized inertia forces F*_r = −Σ_B [(∂v_C/∂u_r)·m a_C + (∂ω_B/∂u_r)·dH_B/dt] as −(matrix · u̇ + rest).
///
/// The coefficient of u̇_s is ∂v_C/∂u_s in a_C, and ∂H/∂u_s = I·∂ω/∂u_s in dH/dt. So the matrix is computed from
/// these derivatives, not read from a long expression.
struct GeneralizedInertia {
    /// Symmetric mass matrix M, one row and one column for each speed.
    matrix: Vec<Vec<Expr>>,
    /// Value of −F* at u̇ = 0 (inertia terms that depend on velocities), one entry for each speed.
    rest: Vec<Expr>,
}

impl GeneralizedInertia {
    /// Computes the mass matrix and the rest of the generalized inertia forces from the momenta of all
    /// bodies.
    fn new(model: &Model, kinematics: &mut Kinematics, velocities: &Velocities) -> Self {
        let n = model.speeds.len();
        if kinematics.frames.carries {
            let (matrix, forces) = kinematics.kane_system_by_recursion(model, velocities, &[], &Vector::default());
            return Self { matrix, rest: forces.into_iter().map(|e| kinematics.arena.neg(e)).collect() };
        }
        let mut gradient = Gradient::new(&model.u());
        let mut rates = kinematic_rates_without_acceleration(model);
        let mut products = SymmetricDots::new(n);
        let mut rest: Vec<Dots> = (0..n).map(|_| Dots::default()).collect();
        for VelocityMomentum { scale, velocity, momentum, carried } in
            kinematics.kinetic_energy_momenta(model, velocities)
        {
            let Kinematics { arena, frames, .. } = kinematics;
            let mut rate = frames.time_derivative(arena, &momentum, &velocities.angular, &mut rates);
            if let Some(carried) = carried {
                rate = rate.add(arena, &carried);
            }
            let partials = velocity.partial_derivatives(arena, &mut gradient);
            products.add(scale, &partials, &momentum.partial_derivatives(arena, &mut gradient));
            for (r, partial) in &partials {
                rest[*r].add(scale, partial, &rate);
            }
        }
        let Kinematics { arena, frames, .. } = kinematics;
        let matrix = products.sum(arena, frames);
        Self { matrix, rest: rest.iter().map(|dots| dots.sum(arena, frames)).collect() }
    }
}

/// Generalized inertia forces F*_r = −Σ_B [(∂v_C/∂u_r)·m a_C + (∂ω_B/∂u_r)·dH_B/dt], one entry for
/// each speed, linear in u̇.
pub(in crate::mechanics) fn kane_inertia_forces(
    model: &Model,
    kinematics: &mut Kinematics,
    velocities: &Velocities,
) -> Vec<Expr> {
    let GeneralizedInertia { matrix, rest } = GeneralizedInertia::new(model, kinematics, velocities);
    let arena = &mut kinematics.arena;
    let mut forces = Vec::new();
    for (row, rest) in matrix.iter().zip(rest) {
        let mut terms = vec![rest];
        terms.extend(row.iter().zip(&model.speeds).map(|(entry, speed)| arena.mul(*entry, speed.rate)));
        let sum = arena.sum(&terms);
        forces.push(arena.neg(sum));
    }
    forces
}

/// Derives velocities, partial velocities and generalized active forces: the steps of Kane's method, for display.
///
/// # Errors
/// Never returns an error.
#[expect(clippy::unnecessary_wraps, reason = "the steps of other methods can fail")]
pub fn kane_steps(model: &Model, kinematics: &mut Kinematics) -> Result<Vec<Step>, DeriveError> {
    let velocities = kinematics.in_speeds(model);
    let active = kane_active_forces(model, kinematics, &velocities);
    let mut steps = vec![kinematic_step(model)];
    for body in &model.bodies {
        let frame = body.rigid.as_ref().map_or(0, |(_, inertia)| inertia.frame);
        let turning =
            body.rigid.as_ref().map(|(own, _)| (VectorName::AngularVelocity, *own, &velocities.angular[*own]));
        let moving = (VectorName::Velocity, body.centre, &velocities.linear[body.centre]);
        for (vector, of, value) in turning.into_iter().chain([moving]) {
            steps.push(kane_velocity_step(model, kinematics, vector, of, frame, value));
        }
    }
    let lines = active.iter().enumerate().map(|(at, force)| (LineName::ActiveForce(at), *force)).collect();
    steps.push(Step { stage: Stage::ActiveForces, lines });
    Ok(steps)
}

/// Largest number of pairs of a body and a speed for which partial velocities are listed. For more pairs the list
/// would be too long to read.
const MOST_PAIRS: usize = 1000;

/// Lists the components of a velocity along the axes of `frame`, then those of its partial
/// velocities that are not zero. A model with more than `MOST_PAIRS` pairs of body and speed lists
/// no partial velocities.
fn kane_velocity_step(
    model: &Model,
    kinematics: &mut Kinematics,
    vector: VectorName,
    of: usize,
    frame: usize,
    value: &Vector,
) -> Step {
    let Kinematics { arena, frames, simplifier, .. } = kinematics;
    let total = frames.express(arena, value, frame).map(|e| simplifier.simplify(arena, e));
    let mut lines: Vec<(LineName, Expr)> = component_lines(vector, of, frame, total).collect();
    let listed = if model.bodies.len() * model.speeds.len() > MOST_PAIRS { Vec::new() } else { model.u() };
    for (speed, symbol) in listed.into_iter().enumerate() {
        let mut partial = Differential::partial(symbol);
        for (axis, e) in total.iter().enumerate() {
            let slope = partial.apply(arena, *e);
            let slope = simplifier.simplify(arena, slope);
            if slope != Expr::ZERO {
                let kind = QuantityKind::Partial { vector, of, frame, axis, speed };
                lines.push((LineName::Quantity(kind), slope));
            }
        }
    }
    Step { stage: Stage::Velocities { vector, of, frame }, lines }
}
