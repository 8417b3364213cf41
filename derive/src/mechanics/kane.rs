//! Kane's method: F_r + F*_r = 0 for each generalized speed.
//!
//! Kane & Levinson, *Dynamics: Theory and Applications* (1985), §§ 4.4, 4.11, 6.1.

use super::kinematics::{Kinematics, Velocities, motion_rates, rates_to_speeds};
use super::vector::Vector;
use super::{DeriveError, Equations, Formulation, Step};
use crate::algebra::Expr;
use crate::algebra::calculus::Differential;
use crate::algebra::linear::LinearForm;
use crate::model::Model;

/// M(q) u̇ = f(q, u).
///
/// # Errors
/// [`DeriveError::NoInertia`] if a speed moves no mass.
pub fn derive(model: &Model, kinematics: &mut Kinematics) -> Result<Equations, DeriveError> {
    let velocities = kinematics.in_speeds(model);
    let active = generalized_active_forces(model, kinematics, &velocities);
    let inertia = generalized_inertia_forces(model, kinematics, &velocities);
    let arena = &mut kinematics.arena;
    let rates: Vec<Expr> = model.speeds.iter().map(|s| s.rate).collect();
    let mut form = LinearForm::new(&rates);
    let (mut matrix, mut forcing) = (Vec::new(), Vec::new());
    for ((speed, f), f_star) in model.speeds.iter().zip(&active).zip(&inertia) {
        // F + F* = 0 with F* = −(M u̇ + rest):  M u̇ = F − rest.
        let (row, rest) = form.coefficients(arena, *f_star).map_err(|_| DeriveError::NotLinear)?;
        let row: Vec<Expr> = row.into_iter().map(|e| arena.neg(e)).collect();
        if row.iter().all(|e| *e == Expr::ZERO) {
            return Err(DeriveError::NoInertia { speed: speed.name.clone() });
        }
        matrix.push(row);
        forcing.push(arena.add(*f, rest));
    }
    let mut equations = Equations {
        name: Formulation::Kane.name().to_owned(),
        title: Formulation::Kane.title().to_owned(),
        formulation: Formulation::Kane,
        coordinates: model.q(),
        variables: model.u(),
        unknowns: rates.clone(),
        rows: model.speeds.iter().map(|s| s.name.clone()).collect(),
        matrix,
        forcing,
        symmetric: true,
        projection: Vec::new(),
        coordinate_rates: model.kinematic_equations.rates.clone(),
        generalized_speeds: model.u(),
        generalized_speed_rates: rates,
        motion_variables: model.u(),
        kinetic_energy: kinematics.kinetic_energy(model, &velocities, &model.u()),
        potential_energy: kinematics.potential_energy(model)?,
        divisors: model.kinematic_equations.divisors.clone(),
        steps: Vec::new(),
    };
    equations.steps = steps(model, kinematics, &velocities, &active);
    kinematics.simplify_equations(&mut equations);
    Ok(equations)
}

/// ∂v/∂u_r for each speed.
fn partials(model: &Model, kinematics: &mut Kinematics, v: &Vector) -> Vec<Vector> {
    let arena = &mut kinematics.arena;
    model.speeds.iter().map(|s| v.differentiate(arena, &mut Differential::partial(s.symbol))).collect()
}

/// F_r = Σ_P (∂v_P/∂u_r)·R_P + Σ_B (∂ω_B/∂u_r)·T_B, weights among the forces; reactions do not contribute.
///
/// Entry r has the unit of power over u_r.
pub(super) fn generalized_active_forces(
    model: &Model,
    kinematics: &mut Kinematics,
    velocities: &Velocities,
) -> Vec<Expr> {
    let mut to_speeds = rates_to_speeds(model);
    let mut forces = vec![Expr::ZERO; model.speeds.len()];
    for (velocity, load) in kinematics.loads(model, velocities, true) {
        let load = load.substitute(&mut kinematics.arena, &mut to_speeds);
        for (sum, partial) in forces.iter_mut().zip(partials(model, kinematics, &velocity)) {
            let power = kinematics.frames.dot(&mut kinematics.arena, &partial, &load);
            *sum = kinematics.arena.add(*sum, power);
        }
    }
    forces.into_iter().map(|e| kinematics.simplifier.simplify(&mut kinematics.arena, e)).collect()
}

/// F*_r = −Σ_B [(∂v_C/∂u_r)·m a_C + (∂ω_B/∂u_r)·dH_B/dt], linear in u̇.
pub(super) fn generalized_inertia_forces(
    model: &Model,
    kinematics: &mut Kinematics,
    velocities: &Velocities,
) -> Vec<Expr> {
    let mut rates = motion_rates(model);
    let mut forces = vec![Vec::new(); model.speeds.len()];
    for body in &model.bodies {
        let v = &velocities.linear[body.centre];
        let Kinematics { arena, frames, .. } = kinematics;
        let a = frames.time_derivative(arena, v, &velocities.angular, &mut rates);
        let inertia_force = a.scale(arena, body.mass).neg(arena);
        let mut pairs = vec![(v.clone(), inertia_force)];
        if let Some((frame, _)) = &body.rigid {
            let h = kinematics.angular_momentum(body, velocities);
            let Kinematics { arena, frames, .. } = kinematics;
            let h_dot = frames.time_derivative(arena, &h, &velocities.angular, &mut rates);
            pairs.push((velocities.angular[*frame].clone(), h_dot.neg(arena)));
        }
        for (velocity, load) in pairs {
            for (terms, partial) in forces.iter_mut().zip(partials(model, kinematics, &velocity)) {
                terms.push(kinematics.frames.dot(&mut kinematics.arena, &partial, &load));
            }
        }
    }
    forces.iter().map(|terms| kinematics.arena.sum(terms)).collect()
}

fn steps(model: &Model, kinematics: &mut Kinematics, velocities: &Velocities, active: &[Expr]) -> Vec<Step> {
    let mut steps = vec![super::kinematic_step(model)];
    for body in &model.bodies {
        let frame = body.rigid.as_ref().map_or(0, |(_, inertia)| inertia.frame);
        let basis = &model.frames[frame].name;
        let mut vectors =
            vec![(format!("v({}) @ {basis}", model.points[body.centre].name), velocities.linear[body.centre].clone())];
        if let Some((own, _)) = &body.rigid {
            vectors
                .insert(0, (format!("omega({}) @ {basis}", model.frames[*own].name), velocities.angular[*own].clone()));
        }
        for (name, vector) in vectors {
            let mut lines = Vec::new();
            let Kinematics { arena, frames, simplifier, .. } = kinematics;
            let total = frames.express(arena, &vector, frame).map(|e| simplifier.simplify(arena, e));
            lines.extend(total.iter().enumerate().map(|(i, e)| (format!("{name} [{}]", i + 1), *e)));
            for speed in &model.speeds {
                let mut partial = Differential::partial(speed.symbol);
                for (i, e) in total.iter().enumerate() {
                    let slope = partial.apply(arena, *e);
                    let slope = simplifier.simplify(arena, slope);
                    if slope != Expr::ZERO {
                        lines.push((format!("d {name} [{}]/d {}", i + 1, speed.name), slope));
                    }
                }
            }
            steps.push(Step { title: format!("Velocity and partial velocities: {name}"), lines });
        }
    }
    let lines = model.speeds.iter().zip(active).map(|(s, f)| (format!("F[{}]", s.name), *f)).collect();
    steps.push(Step { title: "Generalized active forces".to_owned(), lines });
    steps
}
