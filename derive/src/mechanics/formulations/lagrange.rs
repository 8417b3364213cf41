//! Lagrange's equations: d/dt(∂T/∂q̇_i) − ∂T/∂q_i + ∂V/∂q_i = Q_i.
//!
//! H. Goldstein, C. Poole & J. Safko, *Classical Mechanics*, 3rd edition (2002), §1.4.

use super::tree_recursion::{FORCE, MOMENTUM, symmetric_derivative_matrix};
use crate::algebra::term::adjoint::adjoint_product;
use crate::algebra::term::calculus::{Differential, Gradient};
use crate::algebra::{Expr, Rational};
use crate::mechanics::derive_error::DeriveError;
use crate::mechanics::motion::kinematics::{Kinematics, Velocities};
use crate::mechanics::motion::loads::generalized_forces_of_loads;
use crate::mechanics::quantity::{EnergyQuantity, QuantityKind};
use crate::mechanics::rows::{LineName, RowName, Rows, Stage, Step, kinematic_step};
use crate::model::Model;

/// Derives Lagrange's equations E(q) q̈ = A(q, q̇). Each motion constraint adds a multiplier to the unknowns.
///
/// # Errors
/// Returns [`DeriveError::NoZeroOfPotential`] if V has no value at the configuration where the model sets it to zero.
/// The rank of the matrix shows later if a coordinate moves no mass.
pub fn derive_lagrange(model: &Model, kinematics: &mut Kinematics) -> Result<Rows, DeriveError> {
    let velocities = kinematics.in_rates.clone();
    if kinematics.frames.carries {
        let rows = lagrange_rows_with_named_terms(model, kinematics, &velocities)?;
        return Ok(kinematics.with_multipliers(model, rows));
    }
    // Velocities are homogeneous in q̇, so T = ½ Σ E_ij q̇_i q̇_j.
    let matrix = kinematics.kinetic_energy_matrix(model, &velocities, &model.q_dot());
    let t = kinematics.kinetic_energy_of_matrix(model, &velocities, &model.q_dot(), &matrix);
    let v = kinematics.gravity_potential(model)?;
    let mut sums = lagrange_forcing_terms(model, kinematics, &matrix);
    let loads = kinematics.loads(model, &velocities);
    let q_forces = generalized_forces_of_loads(model, kinematics, loads.iter().flatten());
    let Kinematics { arena, .. } = kinematics;
    for (sum, force) in sums.iter_mut().zip(q_forces) {
        sum.push((force, Rational::ONE));
    }
    // The generalized force −∂V/∂q is added.
    for (i, slope) in Gradient::new(&model.q()).apply(arena, v).iter() {
        sums[*i].push((*slope, Rational::MINUS_ONE));
    }
    let forcing = sums.iter().map(|terms| arena.linear_combination(terms)).collect();
    let rows = Rows {
        names: (0..model.coordinates.len()).map(RowName::Coordinate).collect(),
        matrix,
        forcing,
        projection: Vec::new(),
        embedding: None,
        required: None,
        gauss: None,
        kinetic_energy: t,
    };
    Ok(kinematics.with_multipliers(model, rows))
}

/// Derives the matrix E and the forcing A from kinematics with named terms, for large models.
///
/// # Errors
/// Returns `DeriveError::NoZeroOfPotential` if V has no value at the configuration where the model sets it to zero.
fn lagrange_rows_with_named_terms(
    model: &Model,
    kinematics: &mut Kinematics,
    velocities: &Velocities,
) -> Result<Rows, DeriveError> {
    let v = kinematics.gravity_potential(model)?;
    let (matrix, forcing, required) = kinematics.lagrange_system(model, velocities, v);
    let loads = kinematics.loads(model, velocities);
    let forces = generalized_forces_of_loads(model, kinematics, loads.iter().flatten());
    let pairs = kinematics.momentum_pairs(model, velocities);
    let arena = &mut kinematics.arena;
    let required = required.into_iter().zip(&forces).map(|(a, b)| arena.sub(a, *b)).collect();
    Ok(Rows {
        names: (0..model.coordinates.len()).map(RowName::Coordinate).collect(),
        matrix,
        forcing: forcing.into_iter().zip(forces).map(|(a, b)| arena.add(a, b)).collect(),
        projection: Vec::new(),
        embedding: None,
        required: Some(required),
        gauss: None,
        kinetic_energy: kinematics.kinetic_energy_of_momentum_pairs(&pairs),
    })
}

impl Kinematics {
    /// Lagrange's equations E q̈ = A from the energies, as (E, A, E q̈ − A). Gravity is the only load that is
    /// included.
    fn lagrange_system(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        potential: Expr,
    ) -> (Vec<Vec<Expr>>, Vec<Expr>, Vec<Expr>) {
        let n = model.coordinates.len();
        let variables = [model.q(), model.q_dot()].concat();
        // T = ½ Σ v · p with p linear in v, so the slopes of T are those of v, weighted by p.
        let pairs = self.momentum_pairs(model, velocities);
        let slopes = adjoint_product(&mut self.arena, &pairs, &variables, MOMENTUM);
        let (along_q, momenta) = slopes.split_at(n);
        let falling = adjoint_product(&mut self.arena, &[(potential, Expr::MINUS_ONE)], &model.q(), FORCE);
        let mut along: Vec<(Expr, Expr)> = model.q().into_iter().zip(model.q_dot()).collect();
        let mut coasting = Differential::along(&along);
        along.extend(model.coordinates.iter().map(|c| (c.rate, c.second_rate)));
        let mut moving = Differential::along(&along);
        let arena = &mut self.arena;
        let (mut forcing, mut required) = (Vec::with_capacity(n), Vec::with_capacity(n));
        for i in 0..n {
            let acting = arena.add(along_q[i], falling[i]);
            let (coasting, moving) = (coasting.apply(arena, momenta[i]), moving.apply(arena, momenta[i]));
            forcing.push(arena.sub(acting, coasting));
            required.push(arena.sub(moving, acting));
        }
        let matrix = if self.frames.are_all_children_of_inertial() {
            self.kinetic_energy_matrix(model, velocities, &model.q_dot())
        } else {
            symmetric_derivative_matrix(arena, momenta, &model.q_dot())
        };
        (matrix, forcing, required)
    }
}

/// Velocity terms ∂T/∂q_i − (d/dt ∂T/∂q̇_i without its terms in q̈): one list of summands for each
/// row i.
///
/// With T = ½ Σ E_ab q̇_a q̇_b, row i is ½ Σ ∂E_ab/∂q_i q̇_a q̇_b − Σ ∂E_ib/∂q_k q̇_b q̇_k. Each
/// derivative of an entry on or above the diagonal is computed once and added to its rows. An entry
/// depends on few coordinates, so the work grows with the number of entries.
fn lagrange_forcing_terms(
    model: &Model,
    kinematics: &mut Kinematics,
    form: &[Vec<Expr>],
) -> Vec<Vec<(Expr, Rational)>> {
    let arena = &mut kinematics.arena;
    let rates = model.q_dot();
    let mut along_coordinates = Gradient::new(&model.q());
    let half = Rational::fraction(1, 2).expect("not zero");
    let mut rows = vec![Vec::new(); rates.len()];
    for a in 0..rates.len() {
        for b in a..rates.len() {
            for &(k, slope) in along_coordinates.apply(arena, form[a][b]).iter() {
                let square = arena.product(&[slope, rates[a], rates[b]]);
                // The factor is ½ for an entry of the diagonal, and 1 for E_ab and E_ba together.
                rows[k].push((square, if a == b { half.clone() } else { Rational::ONE }));
                let along_b = arena.product(&[slope, rates[b], rates[k]]);
                rows[a].push((along_b, Rational::MINUS_ONE));
                if a != b {
                    let along_a = arena.product(&[slope, rates[a], rates[k]]);
                    rows[b].push((along_a, Rational::MINUS_ONE));
                }
            }
        }
    }
    rows
}

/// Derives energies and generalized forces: the steps of Lagrange's method, for display.
///
/// # Errors
/// Returns [`DeriveError::NoZeroOfPotential`] if V has no value at the configuration where the model sets it to zero.
pub fn lagrange_steps(model: &Model, kinematics: &mut Kinematics) -> Result<Vec<Step>, DeriveError> {
    let velocities = kinematics.in_rates.clone();
    let t = kinematics.kinetic_energy(model, &velocities, &model.q_dot());
    let v = kinematics.potential_energy(model)?;
    let forces = kinematics.load_potential(model).rest;
    let energies = [(EnergyQuantity::Kinetic, t), (EnergyQuantity::Potential, v)];
    let energies = energies.map(|(energy, e)| (LineName::Quantity(QuantityKind::Energy(energy)), e));
    let forces = forces.into_iter().enumerate().map(|(at, force)| (LineName::GeneralizedForce(at), force));
    Ok(vec![
        kinematic_step(model),
        Step { stage: Stage::Energies, lines: energies.to_vec() },
        Step { stage: Stage::GeneralizedForces, lines: forces.collect() },
    ])
}
