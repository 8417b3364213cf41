//! Lagrange's equations: d/dt(∂T/∂q̇_i) − ∂T/∂q_i + ∂V/∂q_i = Q_i.

use super::kinematics::{Kinematics, speeds_to_rates};
use super::{DeriveError, Equations, Formulation, Step};
use crate::algebra::Expr;
use crate::algebra::calculus::Differential;
use crate::algebra::linear::LinearForm;
use crate::model::Model;

/// E(q) q̈ = A(q, q̇).
///
/// # Errors
/// [`DeriveError::NoInertia`] if a coordinate moves no mass.
pub fn derive(model: &Model, kinematics: &mut Kinematics) -> Result<Equations, DeriveError> {
    let velocities = kinematics.in_rates.clone();
    let t = kinematics.kinetic_energy(model, &velocities, &model.q_dot());
    let v = kinematics.potential_energy(model)?;
    let q_forces = generalized_forces(model, kinematics);
    let arena = &mut kinematics.arena;
    let mut rates: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
    rates.extend(model.coordinates.iter().map(|c| (c.rate, c.second_rate)));
    let mut d_dt = Differential::along(&rates);
    let unknowns: Vec<Expr> = model.coordinates.iter().map(|c| c.second_rate).collect();
    let mut form = LinearForm::new(&unknowns);
    let (mut matrix, mut forcing) = (Vec::new(), Vec::new());
    for (c, force) in model.coordinates.iter().zip(&q_forces) {
        let momentum = Differential::partial(c.rate).apply(arena, t);
        let momentum_rate = d_dt.apply(arena, momentum);
        let mut by_position = Differential::partial(c.symbol);
        let (dt_dq, dv_dq) = (by_position.apply(arena, t), by_position.apply(arena, v));
        let (row, rest) = form.coefficients(arena, momentum_rate).map_err(|_| DeriveError::NotLinear)?;
        if row.iter().all(|e| *e == Expr::ZERO) {
            return Err(DeriveError::NoInertia { speed: format!("{}'", c.name) });
        }
        matrix.push(row);
        // E q̈ = Q + ∂T/∂q − ∂V/∂q − (terms of d/dt ∂T/∂q̇ without q̈).
        let gain = arena.add(*force, dt_dq);
        let loss = arena.add(dv_dq, rest);
        forcing.push(arena.sub(gain, loss));
    }
    let speeds: Vec<Expr> = model.speeds.iter().map(|s| s.definition).collect();
    let speed_rates = speeds.iter().map(|e| d_dt.apply(arena, *e)).collect();
    let lines = model.coordinates.iter().zip(&q_forces).map(|(c, f)| (format!("Q[{}]", c.name), *f));
    let steps = vec![
        super::kinematic_step(model),
        Step { title: "Energies".to_owned(), lines: vec![("T".to_owned(), t), ("V".to_owned(), v)] },
        Step { title: "Generalized forces other than gravity".to_owned(), lines: lines.collect() },
    ];
    let mut equations = Equations {
        name: Formulation::Lagrange.name().to_owned(),
        title: Formulation::Lagrange.title().to_owned(),
        formulation: Formulation::Lagrange,
        coordinates: model.q(),
        variables: model.q_dot(),
        unknowns,
        rows: model.coordinates.iter().map(|c| c.name.clone()).collect(),
        matrix,
        forcing,
        symmetric: true,
        projection: Vec::new(),
        coordinate_rates: model.q_dot(),
        generalized_speeds: speeds,
        generalized_speed_rates: speed_rates,
        motion_variables: model.kinematic_equations.rates.clone(),
        kinetic_energy: t,
        potential_energy: v,
        divisors: model.kinematic_equations.divisors.clone(),
        steps,
    };
    kinematics.simplify_equations(&mut equations);
    Ok(equations)
}

/// Q_i = Σ (∂v_P/∂q̇_i)·R_P + Σ (∂ω_B/∂q̇_i)·T_B of everything but gravity, which is in V.
pub fn generalized_forces(model: &Model, kinematics: &mut Kinematics) -> Vec<Expr> {
    let velocities = kinematics.in_rates.clone();
    let mut to_rates = speeds_to_rates(model);
    let mut forces = vec![Expr::ZERO; model.coordinates.len()];
    for (velocity, load) in kinematics.loads(model, &velocities, false) {
        let load = load.substitute(&mut kinematics.arena, &mut to_rates);
        for (sum, c) in forces.iter_mut().zip(&model.coordinates) {
            let arena = &mut kinematics.arena;
            let partial = velocity.differentiate(arena, &mut Differential::partial(c.rate));
            let power = kinematics.frames.dot(arena, &partial, &load);
            *sum = arena.add(*sum, power);
        }
    }
    forces.into_iter().map(|e| kinematics.simplifier.simplify(&mut kinematics.arena, e)).collect()
}
