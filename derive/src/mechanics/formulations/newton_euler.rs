//! Newton–Euler equations: the force and moment balance of each body, with the reactions among the
//! unknowns.
//!
//! Forces: m a_C = ΣF. Moments about the mass centre: dH/dt = ΣM. Components are along the frame of
//! the body's inertia, or the inertial frame for a particle. Components that read 0 = 0 are left
//! out. H. Goldstein, C. Poole & J. Safko, *Classical Mechanics*, 3rd edition (2002), §§ 1.2, 5.5.

use crate::algebra::solve::linear::{LinearForm, solve_linear};
use crate::algebra::term::calculus::Gradient;
use crate::algebra::value::rank::pivot_rows_and_columns;
use crate::algebra::{Arena, Expr};
use crate::geometry::{Components, Vector};
use crate::mechanics::derive_error::DeriveError;
use crate::mechanics::motion::kinematics::{Kinematics, Velocities, kinematic_rates, rates_to_speeds};
use crate::mechanics::motion::tree_accelerations::AlphaTerms;
use crate::mechanics::quantity::VectorName;
use crate::mechanics::rows::{BalanceName, RowName, Rows, Stage, Step, component_lines, kinematic_step};
use crate::model::{Body, ForcePlace, Model, Reaction, ReactionKind};

/// Derives the Newton–Euler equations A(q, u) (u̇, reactions) = b(q, u).
///
/// # Errors
/// Returns an error in these cases:
/// - [`DeriveError::ReactionCount`]: the model does not have exactly the reactions that its bodies feel.
/// - [`DeriveError::ReactionNotShown`]: it cannot be shown that a reaction which the program found does no work.
/// - [`DeriveError::TorqueOnNothing`]: a torque acts on a frame without a body.
/// - [`DeriveError::PotentialOnNothing`]: a potential cannot be written as forces and torques between bodies.
pub fn derive_newton_euler(model: &Model, kinematics: &mut Kinematics) -> Result<Rows, DeriveError> {
    if let Some(torque) = model.torques.iter().find(|t| t.on.1.is_none() || t.against.is_some_and(|(_, b)| b.is_none()))
    {
        return Err(DeriveError::TorqueOnNothing { torque: torque.name.clone() });
    }
    if let (Some(potential), true) = (model.potentials.first(), model.efforts.is_empty()) {
        return Err(DeriveError::PotentialOnNothing { potential: potential.name.clone() });
    }
    for found in model.reactions[model.stated_reactions().len()..].iter().filter(|r| !r.is_shared) {
        let shown = kinematics.check_reactions_do_no_work(model, std::slice::from_ref(found));
        shown.map_err(|_| DeriveError::ReactionNotShown { reaction: found.name.clone() })?;
    }
    let velocities = kinematics.in_speeds(model);
    let mut unknowns: Vec<Expr> = model.speeds.iter().map(|s| s.rate).collect();
    unknowns.extend(model.reactions.iter().map(|r| r.symbol));
    let mut form = LinearForm::new(&unknowns);
    let (mut rows, mut matrix, mut forcing) = (Vec::<Balance>::new(), Vec::new(), Vec::new());
    for balance in newton_euler_balances(model, kinematics, &velocities, None) {
        let Kinematics { arena, simplifier, .. } = kinematics;
        let (row, rest) = form.coefficients(arena, balance.residual).map_err(|_| DeriveError::NotLinear)?;
        let row: Vec<Expr> = row.into_iter().map(|e| simplifier.simplify(arena, e)).collect();
        let right = arena.neg(rest);
        let right = simplifier.simplify(arena, right);
        if row.iter().all(|e| *e == Expr::ZERO) && right == Expr::ZERO {
            continue;
        }
        rows.push(balance);
        matrix.push(row);
        forcing.push(right);
    }
    let powers = newton_euler_power_rows(model, kinematics)?;
    if matrix.len() + powers.rows.len() != unknowns.len() {
        return Err(DeriveError::ReactionCount {
            equations: matrix.len(),
            speeds: model.speeds.len(),
            reactions: model.reactions.len(),
            all: model.bodies.iter().map(|body| if body.rigid.is_some() { 6 } else { 3 }).sum(),
            felt: loaded_newton_euler_components(model, &rows),
        });
    }
    let mut projection = newton_euler_partial_velocities(model, kinematics, &velocities, &rows, &model.u());
    let mut names: Vec<RowName> = rows.iter().map(|row| RowName::Balance(row.name)).collect();
    for (name, row) in powers.rows {
        names.push(name);
        matrix.push(row);
        forcing.push(Expr::ZERO);
    }
    for (multipliers, of_powers) in projection.iter_mut().zip(powers.projection) {
        multipliers.extend(of_powers);
    }
    Ok(Rows {
        names,
        matrix,
        forcing,
        projection,
        embedding: None,
        required: None,
        gauss: None,
        kinetic_energy: kinematics.kinetic_energy(model, &velocities, &model.u()),
    })
}

/// Conditions that shared reactions together do no work. Each shared reaction does work by itself, but the powers of
/// all of them cancel.
struct SharedPowers {
    /// Conditions that a power is zero, as rows over the unknowns (u̇, reactions), each with its name. First come
    /// those of connections with their own law (such as a screw), along rates q̇. Then come those of all shared
    /// reactions, along speeds. Dependent rows are left out.
    rows: Vec<(RowName, Vec<Expr>)>,
    /// Factors of [`Self::rows`] with which the rows add up to the power along a speed: one list for each speed, one
    /// factor for each row.
    projection: Vec<Vec<Expr>>,
}

/// Derives the conditions Σ R (direction · ∂v/∂u_s) = 0 over the shared reactions R, where v is the velocity on which
/// a reaction does work. For each connection with its own law, adds Σ R (direction · ∂v/∂q̇_j) = 0 over the reactions
/// of this connection.
///
/// # Errors
/// Returns `DeriveError::ReactionsDependent` if the independence of the conditions cannot be decided.
fn newton_euler_power_rows(model: &Model, kinematics: &mut Kinematics) -> Result<SharedPowers, DeriveError> {
    let (speeds, first) = (model.speeds.len(), model.speeds.len());
    let shared: Vec<usize> = (0..model.reactions.len()).filter(|at| model.reactions[*at].is_shared).collect();
    if shared.is_empty() {
        return Ok(SharedPowers { rows: Vec::new(), projection: vec![Vec::new(); speeds] });
    }
    let mut slopes = vec![vec![Expr::ZERO; shared.len()]; speeds];
    let mut to_speeds = rates_to_speeds(model);
    let mut along = Gradient::new(&model.u());
    let undriven = model.undriven_coordinates();
    let mut along_rates = Gradient::new(&model.q_dot());
    let mut candidates: Vec<(RowName, Vec<Expr>)> = Vec::new();
    for (column, at) in shared.iter().enumerate() {
        let power = kinematics.reaction_power(model, &model.reactions[*at]);
        let Kinematics { arena, simplifier, .. } = kinematics;
        if let Some(body) = model.reactions[*at].law {
            for (rate, slope) in along_rates.apply(arena, power).iter().filter(|(rate, _)| undriven.contains(rate)) {
                let name = RowName::Law { body, coordinate: *rate };
                let at = candidates.iter().position(|(known, _)| *known == name).unwrap_or_else(|| {
                    candidates.push((name, vec![Expr::ZERO; shared.len()]));
                    candidates.len() - 1
                });
                candidates[at].1[column] = simplifier.simplify(arena, *slope);
            }
        }
        let power = to_speeds.apply(arena, power);
        for (speed, slope) in along.apply(arena, power).iter() {
            slopes[*speed][column] = simplifier.simplify(arena, *slope);
        }
    }
    let Kinematics { arena, simplifier, .. } = kinematics;
    candidates.extend(slopes.iter().enumerate().map(|(speed, row)| (RowName::Power(speed), row.clone())));
    let matrix: Vec<Vec<Expr>> = candidates.iter().map(|(_, row)| row.clone()).collect();
    let (chosen, pivots) = pivot_rows_and_columns(arena, &matrix).ok_or(DeriveError::ReactionsDependent)?;
    let row = |at: &usize| {
        let mut row = vec![Expr::ZERO; first + model.reactions.len()];
        let (name, slopes) = &candidates[*at];
        for (slope, at) in slopes.iter().zip(&shared) {
            row[first + at] = *slope;
        }
        (name.clone(), row)
    };
    let rows = chosen.iter().map(row).collect();
    // The powers along the speeds are multiples of these rows. Columns in which the chosen rows are independent give
    // the factors.
    let matrix: Vec<Vec<Expr>> =
        pivots.iter().map(|column| chosen.iter().map(|at| candidates[*at].1[*column]).collect()).collect();
    let right: Vec<Vec<Expr>> =
        pivots.iter().map(|column| (0..speeds).map(|speed| slopes[speed][*column]).collect()).collect();
    let (multiples, _) =
        solve_linear(arena, simplifier, &matrix, &right).map_err(|_| DeriveError::ReactionsDependent)?;
    let projection = (0..speeds).map(|speed| multiples.iter().map(|row| row[speed]).collect()).collect();
    Ok(SharedPowers { rows, projection })
}

/// Components of the balances that are not 0 = 0, one text for each body and kind: `disk force b1, b2`.
fn loaded_newton_euler_components(model: &Model, rows: &[Balance]) -> Vec<String> {
    let mut list: Vec<(String, Vec<String>)> = Vec::new();
    for Balance { name, .. } in rows {
        let subject = RowName::Balance(*name).balance_name_without_axis(model);
        let direction = format!("{}{}", model.frames[name.frame].name.to_lowercase(), name.axis + 1);
        match list.last_mut().filter(|(last, _)| *last == subject) {
            Some((_, axes)) => axes.push(direction),
            None => list.push((subject, vec![direction])),
        }
    }
    list.into_iter().map(|(subject, axes)| format!("{subject} {}", axes.join(", "))).collect()
}

/// Single component of the force balance (Newton) or moment balance (Euler) of a body.
#[derive(Clone, Debug)]
pub struct Balance {
    /// Name of the component: the body, force or moment, the frame and the axis.
    pub name: BalanceName,
    /// Residual m a − ΣF (N) or dH/dt − ΣM (N m), as a term in q, u, u̇ and the reactions.
    pub residual: Expr,
}

/// Derives the force and moment balances of all bodies, component by component along the axes of
/// `frame`. With `None`, each body uses the frame of its inertia. A particle has no moment balance.
pub fn newton_euler_balances(
    model: &Model,
    kinematics: &mut Kinematics,
    velocities: &Velocities,
    frame: Option<usize>,
) -> Vec<Balance> {
    let mut list = Vec::new();
    let carried = kinematics.frames.carries.then(|| {
        let mut rates = kinematic_rates(model);
        kinematics.accelerations(model, velocities, &mut rates, &Kinematics::fall(model), AlphaTerms::InMatrix)
    });
    for (at, body) in model.bodies.iter().enumerate() {
        let frame = frame.or(body.rigid.as_ref().map(|(_, inertia)| inertia.frame)).unwrap_or(0);
        let (force, moment) = match &carried {
            Some(accelerations) => kinematics.momentum_rates_along_tree(model, velocities, accelerations, body),
            None => momentum_rates(model, kinematics, velocities, at),
        };
        let (force, moment) = newton_euler_residuals(model, kinematics, force, moment, at, body);
        for (moments, vector) in [Some((false, force)), moment.map(|m| (true, m))].into_iter().flatten() {
            let components = kinematics.frames.express(&mut kinematics.arena, &vector, frame);
            let entries = components.into_iter().enumerate();
            let name = |axis| BalanceName { body: at, moments, frame, axis };
            list.extend(entries.map(|(axis, residual)| Balance { name: name(axis), residual }));
        }
    }
    list
}

/// Partial velocities that belong to the balance rows: one list for each motion variable, one entry for each row. A
/// force row has the partial velocity of the mass centre, a moment row that of the body's frame. As multipliers of
/// the rows, they cancel every reaction.
pub fn newton_euler_partial_velocities(
    model: &Model,
    kinematics: &mut Kinematics,
    velocities: &Velocities,
    rows: &[Balance],
    variables: &[Expr],
) -> Vec<Vec<Expr>> {
    let mut gradient = Gradient::new(variables);
    let mut result = vec![vec![Expr::ZERO; rows.len()]; variables.len()];
    for (place, row) in rows.iter().map(|row| row.name).enumerate() {
        let body = &model.bodies[row.body];
        let velocity = match &body.rigid {
            Some((frame, _)) if row.moments => &velocities.angular[*frame],
            _ => &velocities.linear[body.centre],
        };
        let Kinematics { arena, frames, simplifier, .. } = kinematics;
        if frames.carries {
            let component = frames.component(arena, velocity, row.frame, row.axis);
            for (at, slope) in gradient.apply(arena, component).iter() {
                result[*at][place] = *slope;
            }
            continue;
        }
        for (at, slope) in velocity.partial_derivatives(arena, &mut gradient) {
            let component = frames.component(arena, &slope, row.frame, row.axis);
            result[at][place] = simplifier.simplify(arena, component);
        }
    }
    result
}

/// Derives the vectors m a − weight (N) and dH/dt (N m) of the body with the index `at`. The momentum rates of its
/// added mass are included.
fn momentum_rates(model: &Model, kinematics: &mut Kinematics, velocities: &Velocities, at: usize) -> (Vector, Vector) {
    let body = &model.bodies[at];
    let mut rates = kinematic_rates(model);
    let Kinematics { arena, frames, .. } = kinematics;
    let a = frames.time_derivative(arena, &velocities.linear[body.centre], &velocities.angular, &mut rates);
    let mut force = a.scale(arena, body.mass);
    if let Some(gravity) = &model.gravity {
        let weight = Vector::in_frame(gravity.frame, gravity.acceleration).scale(arena, body.mass).neg(arena);
        force = force.add(arena, &weight);
    }
    let h = kinematics.angular_momentum(body, velocities);
    let Kinematics { arena, frames, .. } = kinematics;
    let mut moment = frames.time_derivative(arena, &h, &velocities.angular, &mut rates);
    for added in model.added_masses.iter().filter(|added| added.body == at) {
        let impulse = kinematics.added_mass_impulse(model, velocities, added);
        let Kinematics { arena, frames, .. } = kinematics;
        // The fluid's reaction is −dp/dt, and −(dh/dt + v × p) about the mass centre.
        let linear = frames.time_derivative(arena, &impulse.linear, &velocities.angular, &mut rates);
        let angular = frames.time_derivative(arena, &impulse.angular, &velocities.angular, &mut rates);
        force = force.add(arena, &linear);
        moment = moment.add(arena, &angular).add(arena, &impulse.carried);
    }
    (force, moment)
}

/// Subtracts all forces, torques and reactions on a body from its momentum rates. Returns the
/// residuals m a − ΣF and dH/dt − ΣM; the second is `None` for a particle.
fn newton_euler_residuals(
    model: &Model,
    kinematics: &mut Kinematics,
    mut force: Vector,
    mut moment: Vector,
    at: usize,
    body: &Body,
) -> (Vector, Option<Vector>) {
    for (point, load) in newton_euler_forces(model, kinematics, &model.reactions, at) {
        let back = load.neg(&mut kinematics.arena);
        force = force.add(&mut kinematics.arena, &back);
        let arm = kinematics.load_arm(body, point);
        let turning = kinematics.frames.cross(&mut kinematics.arena, &arm, &back);
        moment = moment.add(&mut kinematics.arena, &turning);
    }
    for load in newton_euler_torques(model, kinematics, &model.reactions, at) {
        let back = load.neg(&mut kinematics.arena);
        moment = moment.add(&mut kinematics.arena, &back);
    }
    (force, body.rigid.is_some().then_some(moment))
}

/// Lists the applied forces and the given reaction forces on a body, each with the index of its
/// point. Weights are left out.
pub(in crate::mechanics) fn newton_euler_forces(
    model: &Model,
    kinematics: &mut Kinematics,
    reactions: &[Reaction],
    body: usize,
) -> Vec<(usize, Vector)> {
    let mut to_speeds = rates_to_speeds(model);
    let mut loads: Vec<(ForcePlace, Vector)> = Vec::new();
    let Kinematics { arena, forces, .. } = kinematics;
    for (force, vector) in model.forces.iter().zip(forces) {
        let vector = vector.substitute(arena, &mut to_speeds);
        loads.extend(force.against.map(|place| (place, vector.neg(arena))));
        loads.push((force.on, vector));
    }
    for (kind, vector) in loads_of_potentials_and_reactions(model, arena, reactions) {
        if let ReactionKind::Force { on, against } = kind {
            loads.extend(against.map(|place| (place, vector.neg(arena))));
            loads.push((on, vector));
        }
    }
    loads.into_iter().filter(|(place, _)| place.body == body).map(|(place, v)| (place.point, v)).collect()
}

/// Lists the applied torques and the torques of the given reactions on a body.
pub(in crate::mechanics) fn newton_euler_torques(
    model: &Model,
    kinematics: &mut Kinematics,
    reactions: &[Reaction],
    body: usize,
) -> Vec<Vector> {
    let mut to_speeds = rates_to_speeds(model);
    let mut loads: Vec<(Option<usize>, Vector)> = Vec::new();
    let Kinematics { arena, torques, .. } = kinematics;
    for (torque, vector) in model.torques.iter().zip(torques) {
        let vector = vector.substitute(arena, &mut to_speeds);
        loads.extend(torque.against.map(|(_, body)| (body, vector.neg(arena))));
        loads.push((torque.on.1, vector));
    }
    for (kind, vector) in loads_of_potentials_and_reactions(model, arena, reactions) {
        if let ReactionKind::Torque { on, against } = kind {
            loads.extend(against.map(|body| (Some(body), vector.neg(arena))));
            loads.push((Some(on), vector));
        }
    }
    loads.into_iter().filter(|(on, _)| *on == Some(body)).map(|(_, v)| v).collect()
}

/// Lists the forces and torques of potentials and of the given reactions, each with the place where
/// it acts.
fn loads_of_potentials_and_reactions(
    model: &Model,
    arena: &mut Arena,
    reactions: &[Reaction],
) -> Vec<(ReactionKind, Vector)> {
    let efforts = model.efforts.iter().map(|effort| (effort.kind, Vector::in_frame(effort.frame, effort.vector)));
    let mut list: Vec<_> = efforts.collect();
    for reaction in reactions {
        let vector = Vector::in_frame(reaction.frame, reaction.direction).scale(arena, reaction.symbol);
        list.push((reaction.kind, vector));
    }
    list
}

/// Derives the accelerations of the bodies: the steps of the Newton–Euler method, for display.
///
/// # Errors
/// Never returns an error.
#[expect(clippy::unnecessary_wraps, reason = "the steps of other methods can fail")]
pub fn newton_euler_steps(model: &Model, kinematics: &mut Kinematics) -> Result<Vec<Step>, DeriveError> {
    let velocities = kinematics.in_speeds(model);
    let mut steps = vec![kinematic_step(model)];
    for (at, body) in model.bodies.iter().enumerate() {
        let frame = body.rigid.as_ref().map_or(0, |(_, inertia)| inertia.frame);
        let a = inertial_time_derivative(model, kinematics, &velocities, frame, &velocities.linear[body.centre]);
        let mut lines: Vec<_> = component_lines(VectorName::Acceleration, body.centre, frame, a).collect();
        if let Some((own, _)) = &body.rigid {
            let omega = kinematics.angular_velocity_in(body, &velocities).unwrap_or([Expr::ZERO; 3]);
            let alpha =
                inertial_time_derivative(model, kinematics, &velocities, frame, &Vector::in_frame(frame, omega));
            lines.extend(component_lines(VectorName::AngularAcceleration, *own, frame, alpha));
        }
        steps.push(Step { stage: Stage::Accelerations(at), lines });
    }
    Ok(steps)
}

/// Differentiates a vector by time in the inertial frame, and returns simplified components along
/// `frame`.
fn inertial_time_derivative(
    model: &Model,
    kinematics: &mut Kinematics,
    velocities: &Velocities,
    frame: usize,
    vector: &Vector,
) -> Components {
    let Kinematics { arena, frames, simplifier, .. } = kinematics;
    let rate = frames.time_derivative(arena, vector, &velocities.angular, &mut kinematic_rates(model));
    frames.express(arena, &rate, frame).map(|e| simplifier.simplify(arena, e))
}
