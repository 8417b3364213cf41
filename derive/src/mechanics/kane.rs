//! Kane's method: F_r + F*_r = 0 for each generalized speed.
//!
//! Kane & Levinson, *Dynamics: Theory and Applications* (1985), §§ 4.4, 4.11, 6.1.

use super::energy::Momentum;
use super::kinematics::{Kinematics, Load, Velocities, motion_rates_without_acceleration, rates_to_speeds};
use super::vector::Dots;
use super::{DeriveError, Equations, Formulation, Step};
use crate::algebra::Expr;
use crate::algebra::calculus::{Differential, Gradient};
use crate::model::Model;

/// M(q) u̇ = f(q, u).
///
/// # Errors
/// [`DeriveError::NoZeroOfPotential`]; a speed that moves no mass is found by the rank of the matrix.
pub fn derive(model: &Model, kinematics: &mut Kinematics) -> Result<Equations, DeriveError> {
    let velocities = kinematics.in_speeds(model);
    let active = active_forces(model, kinematics, &velocities);
    let inertia = Inertia::new(model, kinematics, &velocities);
    let Kinematics { arena, simplifier, .. } = kinematics;
    let rates: Vec<Expr> = model.speeds.iter().map(|s| s.rate).collect();
    // F + F* = 0 with F* = −(M u̇ + rest):  M u̇ = F − rest.
    let matrix = inertia.matrix.iter().map(|row| row.iter().map(|e| simplifier.simplify(arena, *e)).collect());
    let matrix: Vec<Vec<Expr>> = matrix.collect();
    let forcing = active.iter().zip(&inertia.rest).map(|(force, rest)| arena.sub(*force, *rest)).collect();
    let mut equations = Equations {
        name: Formulation::Kane.name().to_owned(),
        title: Formulation::Kane.title().to_owned(),
        formulation: Formulation::Kane,
        definitions: Vec::new(),
        coordinates: model.q(),
        variables: model.u(),
        unknowns: rates.clone(),
        rows: model.speeds.iter().map(|s| s.name.clone()).collect(),
        // M is the matrix of the kinetic energy, too.
        kinetic_energy: kinematics.energy_with_form(model, &velocities, &model.u(), &matrix),
        matrix,
        forcing,
        symmetric: true,
        projection: Vec::new(),
        coordinate_rates: model.kinematic_equations.rates.clone(),
        generalized_speeds: model.u(),
        generalized_speed_rates: rates,
        motion_variables: model.u(),
        potential_energy: kinematics.potential_energy(model)?,
        divisors: model.kinematic_equations.divisors.clone(),
    };
    kinematics.simplify_equations(&mut equations);
    Ok(equations)
}

/// F_r = Σ_P (∂v_P/∂u_r)·R_P + Σ_B (∂ω_B/∂u_r)·T_B, weights among the forces; reactions do not contribute.
///
/// Entry r has the unit of power over u_r.
pub(super) fn generalized_active_forces(
    model: &Model,
    kinematics: &mut Kinematics,
    velocities: &Velocities,
) -> Vec<Expr> {
    let forces = active_forces(model, kinematics, velocities);
    forces.into_iter().map(|e| kinematics.simplifier.simplify(&mut kinematics.arena, e)).collect()
}

/// The same as they come.
fn active_forces(model: &Model, kinematics: &mut Kinematics, velocities: &Velocities) -> Vec<Expr> {
    let mut to_speeds = rates_to_speeds(model);
    let mut gradient = Gradient::new(&model.u());
    let mut forces: Vec<Dots> = model.speeds.iter().map(|_| Dots::default()).collect();
    let mut loads = kinematics.weights(model, velocities);
    loads.extend(kinematics.loads(model, velocities));
    for Load { velocity, scale, load } in loads {
        let load = load.substitute(&mut kinematics.arena, &mut to_speeds);
        for (r, partial) in velocity.slopes(&mut kinematics.arena, &mut gradient) {
            forces[r].add(scale, &partial, &load);
        }
    }
    forces.iter().map(|dots| dots.sum(&mut kinematics.arena, &mut kinematics.frames)).collect()
}

/// The generalized inertia forces F*_r = −Σ_B [(∂v_C/∂u_r)·m a_C + (∂ω_B/∂u_r)·dH_B/dt] as −(matrix · u̇ + rest).
///
/// u̇_s enters a_C with ∂v_C/∂u_s and dH/dt with ∂H/∂u_s = I·∂ω/∂u_s, and the rest is what is left for u̇ = 0; so nothing
/// has to be read out of a long expression.
struct Inertia {
    /// Symmetric.
    matrix: Vec<Vec<Expr>>,
    rest: Vec<Expr>,
}

impl Inertia {
    fn new(model: &Model, kinematics: &mut Kinematics, velocities: &Velocities) -> Self {
        let n = model.speeds.len();
        let mut gradient = Gradient::new(&model.u());
        let mut rates = motion_rates_without_acceleration(model);
        let mut products: Vec<Vec<Dots>> = (0..n).map(|r| (r..n).map(|_| Dots::default()).collect()).collect();
        let mut rest: Vec<Dots> = (0..n).map(|_| Dots::default()).collect();
        for Momentum { scale, velocity, momentum } in kinematics.momenta(model, velocities) {
            let Kinematics { arena, frames, .. } = kinematics;
            let rate = frames.time_derivative(arena, &momentum, &velocities.angular, &mut rates);
            let slopes = momentum.slopes(arena, &mut gradient);
            for (r, partial) in velocity.slopes(arena, &mut gradient) {
                rest[r].add(scale, &partial, &rate);
                for (s, slope) in slopes.iter().filter(|(s, _)| *s >= r) {
                    products[r][s - r].add(scale, &partial, slope);
                }
            }
        }
        let Kinematics { arena, frames, .. } = kinematics;
        let mut matrix = vec![vec![Expr::ZERO; n]; n];
        for (r, row) in products.iter().enumerate() {
            for (above, dots) in row.iter().enumerate() {
                let entry = dots.sum(arena, frames);
                matrix[r][r + above] = entry;
                matrix[r + above][r] = entry;
            }
        }
        Self { matrix, rest: rest.iter().map(|dots| dots.sum(arena, frames)).collect() }
    }
}

/// F*_r = −Σ_B [(∂v_C/∂u_r)·m a_C + (∂ω_B/∂u_r)·dH_B/dt], linear in u̇.
pub(super) fn generalized_inertia_forces(
    model: &Model,
    kinematics: &mut Kinematics,
    velocities: &Velocities,
) -> Vec<Expr> {
    let Inertia { matrix, rest } = Inertia::new(model, kinematics, velocities);
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

/// Velocities, partial velocities and generalized active forces, to be shown.
pub(super) fn steps(model: &Model, kinematics: &mut Kinematics) -> Vec<Step> {
    let velocities = kinematics.in_speeds(model);
    let active = generalized_active_forces(model, kinematics, &velocities);
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
    let lines = model.speeds.iter().zip(&active).map(|(s, f)| (format!("F[{}]", s.name), *f)).collect();
    steps.push(Step { title: "Generalized active forces".to_owned(), lines });
    steps
}
