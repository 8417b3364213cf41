//! Check of a model before its equations are used: degrees of freedom, kinds of constraints, loads
//! that create energy, unused names.
//!
//! It is decided for all motion constraints together if they are integrable. The permitted motions
//! span the columns of W and, with drives, the drift w of q̇ = W u + w. These vector fields, their
//! Lie brackets and the brackets of the brackets span all directions in which the mechanism can
//! move. If all these fields satisfy a constraint, the constraint keeps a function of the
//! coordinates constant.
//!
//! Sources: G. Frobenius 1877; V. Jurdjevic, *Geometric Control Theory* (1997), chapter 2; R. L.
//! Bryant et al., *Exterior Differential Systems* (1991), chapter II §4 (derived flag).

mod created_energy;
mod rank_loss;
mod reachable_directions;

pub use created_energy::{EnergyEffect, LoadEffect};
pub use rank_loss::RankLoss;

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::antiderivative::antiderivative;
use crate::algebra::term::calculus::Gradient;
use crate::algebra::term::steps::Definition;
use crate::algebra::text::definitions::definitions_shown;
use crate::algebra::text::print::{print_text, print_whole_text, printed_length};
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::geometry::{Vector, apply_tensor};
use crate::mechanics::{Derivation, DeriveError, EquationForm, Formulation, Kinematics, derive, load_divisors};
use crate::model::{AssemblyBranch, Model, MotionConstraint, MotionConstraintKind, RedundantConstraint};
use reachable_directions::ReachableDirections;

/// Kind of a constraint: an equation between coordinates or between velocities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConstraintKind {
    /// An equation between coordinates.
    Configuration,
    /// An equation between velocities.
    Motion,
}

/// Constraint of a model with the results of its check: if it is integrable, and if it is
/// redundant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CheckedConstraint {
    /// Name of the constraint in the model file.
    pub name: String,
    /// Kind of the constraint: between coordinates or between velocities.
    pub kind: ConstraintKind,
    /// True if the constraint, together with all other constraints of the model, keeps a function
    /// of the coordinates constant. False if it restricts velocities only; `None` if undecided.
    pub integrable: Option<bool>,
    /// Function of the coordinates that the constraint keeps constant, as the text of a formula; `None`
    /// if none was found.
    pub integral: Option<String>,
    /// True if the constraint follows from the other constraints: it restricts the motion no
    /// further.
    pub redundant: bool,
}

/// Result of a check of a model: its degrees of freedom, constraints, singular poses, loads and
/// notes.
#[derive(Clone, Debug)]
pub struct ModelCheck {
    /// Number of generalized coordinates, without time.
    pub coordinates: usize,
    /// Number of generalized speeds.
    pub speeds: usize,
    /// All constraints of the model, with the results of their checks.
    pub constraints: Vec<CheckedConstraint>,
    /// Number of degrees of freedom: independent generalized speeds under all constraints.
    pub degrees_of_freedom: usize,
    /// Mobility by counting: number of coordinates minus number of constraints, redundant
    /// constraints included. It may be negative.
    pub mobility_count: i64,
    /// Dimension of the set of poses that can be reached from one pose; `None` if undecided.
    pub configuration_freedom: Option<usize>,
    /// Assembly branch (way to close the loops) for which all results about loops were found, with
    /// the rank of the constraints there. `None` if the model has no such branch.
    pub branch: Option<AssemblyBranch>,
    /// Formulas whose zeros are the poses in which the chosen generalized speeds do not determine the
    /// motion.
    pub singular_where: Vec<String>,
    /// Poses in which the constraints lose rank for every choice of speeds; `None` if the model has no
    /// constraints.
    pub rank_loss: Option<RankLoss>,
    /// Names of generalized speeds whose rates the equations of motion do not determine: the bodies
    /// that these speeds move have no inertia.
    pub indeterminate: Vec<String>,
    /// Effect of each applied load on the energy, in the order of the model file. Empty for large
    /// models, which are not checked.
    pub loads: Vec<LoadEffect>,
    /// Further facts about the model, one sentence each.
    pub notes: Vec<String>,
    /// Named terms that occur in the notes, as (name, formula). A name comes after the names that
    /// its formula contains.
    pub names: Vec<(String, String)>,
}

/// Checks a model: integrable and redundant constraints, degrees of freedom, singular poses, effect
/// of loads on the energy.
///
/// # Errors
/// Returns [`DeriveError`] if Kane's equations cannot be derived. A speed without inertia is no
/// error: it gives a note.
#[allow(clippy::too_many_lines, reason = "one step for each part of the answer")]
pub fn check(model: &Model) -> Result<ModelCheck, DeriveError> {
    let mut arena = model.arena.clone();
    let mut reach = ReachableDirections::new(model, &mut arena);
    let is_known = reach.close_under_brackets(&mut arena);
    let configuration = model.constraints.iter().map(|c| CheckedConstraint {
        name: c.name.clone(),
        kind: ConstraintKind::Configuration,
        integrable: Some(true),
        integral: Some(print_text(&model.arena, c.equation)),
        redundant: false,
    });
    let loops = model.loops.iter().chain(&model.closed).map(|c| CheckedConstraint {
        name: c.name.clone(),
        kind: ConstraintKind::Configuration,
        integrable: Some(true),
        integral: Some(print_text(&model.arena, c.equation)),
        redundant: model.dependent.iter().any(|d| d.name == c.name),
    });
    let mut constraints: Vec<CheckedConstraint> = configuration.chain(loops).collect();
    for constraint in model
        .motion_constraints
        .iter()
        .filter(|c| matches!(c.kind, MotionConstraintKind::Stated | MotionConstraintKind::Rolling(_)))
    {
        let integrable = match reach.satisfies_constraint(model, &mut arena, constraint) {
            Some(true) if !is_known => None,
            decided => decided,
        };
        let integral = if integrable == Some(true) { integral_of(model, &mut arena, constraint) } else { None };
        let name = constraint.name.clone();
        constraints.push(CheckedConstraint {
            name,
            kind: ConstraintKind::Motion,
            integrable,
            integral,
            redundant: false,
        });
    }
    constraints.extend(model.repeated.iter().map(|repeated| CheckedConstraint {
        name: repeated.name.clone(),
        kind: if repeated.is_of_loop { ConstraintKind::Configuration } else { ConstraintKind::Motion },
        integrable: repeated.is_of_loop.then_some(true),
        integral: None,
        redundant: true,
    }));
    let mut notes: Vec<String> =
        model.unused.iter().map(|(kind, name)| format!("nothing names the {kind} `{name}`")).collect();
    notes.extend(model.dependent.iter().map(check_note_on_redundant_constraint));
    notes.extend(
        model.repeated.iter().filter(|r| r.elsewhere.is_some()).map(|r| check_note_on_dependent_rolling(&r.name)),
    );
    notes.extend(check_note_on_speeds(model));
    let mut indeterminate = Vec::new();
    let mut names = Vec::new();
    match derive(model, Formulation::Kane) {
        Ok(mut derivation) => {
            derivation.write_names();
            let Derivation { arena, equations } = &derivation;
            if let Some((note, named)) = check_note_on_power(model, arena, equations.power) {
                notes.push(note);
                names.extend(named.iter().map(|d| (print_text(arena, d.symbol), print_whole_text(arena, d.value))));
            }
        }
        Err(error @ DeriveError::NoInertia { .. }) => {
            if let DeriveError::NoInertia { speed } = &error {
                notes.extend(check_notes_on_missing_inertia(model, speed)?);
                indeterminate.push(speed.clone());
            }
            notes.push(error.to_string());
        }
        Err(error) => return Err(error),
    }
    let loads = if EquationForm::computed(model) == EquationForm::Steps {
        Vec::new()
    } else {
        created_energy::energy_effects_of_loads(model)?
    };
    if loads.is_empty() && model.forces.len() + model.torques.len() > 0 {
        notes.push("the model is too large to check its loads for created energy".to_owned());
    }
    notes.extend(load_divisors(&mut arena, model).iter().map(|divisor| {
        format!(
            "no run goes through {} = 0: {} there",
            print_text(&arena, divisor.value),
            divisor.zero_divisor_meaning()
        )
    }));
    if !is_known {
        notes.push(
            "which motion constraints are integrable could not be decided: their brackets are too many, or have no value at random points".to_owned(),
        );
    }
    Ok(ModelCheck {
        coordinates: model.coordinates.len() - usize::from(model.time().is_some()),
        speeds: model.speeds.len(),
        constraints,
        degrees_of_freedom: model.speeds.len(),
        mobility_count: mobility_count(model),
        configuration_freedom: is_known.then(|| reach.fields.len() - usize::from(reach.drifts)),
        branch: model.branch.clone(),
        rank_loss: rank_loss::rank_loss(model),
        indeterminate,
        loads,
        singular_where: model.kinematic_equations.divisors.iter().map(|e| print_text(&model.arena, *e)).collect(),
        notes,
        names,
    })
}

/// Mobility by counting: number of coordinates minus number of constraints, redundant constraints
/// included. The coordinate for time and its constraint are not counted.
fn mobility_count(model: &Model) -> i64 {
    let clock = usize::from(model.time().is_some());
    let rolling = model.dependent.iter().filter(|d| model.closed.iter().all(|c| c.name != d.name)).count();
    let constraints = model.motion_constraints.len() - clock + model.closed.len() + model.repeated.len() + rolling;
    let count = |n: usize| i64::try_from(n).unwrap_or(i64::MAX);
    count(model.coordinates.len() - clock) - count(constraints)
}

/// Writes a note about a rolling constraint: one of its components follows from the other
/// constraints, except in single poses.
fn check_note_on_dependent_rolling(name: &str) -> String {
    format!(
        "`{name}` follows from the other constraints except in single poses: in these the equations of Lagrange and of Newton and Euler \
         have no solution, though the mechanism may be regular. State `frame`, in which the body's own heading is an axis"
    )
}

/// Writes a note about a constraint that follows from other constraints in all closed poses.
fn check_note_on_redundant_constraint(d: &RedundantConstraint) -> String {
    let poses = if d.poses == 1 { "the closed pose" } else { "each of the closed poses" };
    let names = d.of.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let of = if d.of.is_empty() { "restricts no velocity".to_owned() } else { format!("follows from {names}") };
    format!(
        "wherever the loops are closed, `{}` {of}: found in doubles, in {poses} that {} reached from random ones ({}), at the \
         default values",
        d.name,
        if d.poses == 1 { "was" } else { "were" },
        d.poses,
    )
}

/// Writes a note about speeds that joints name, although the constraints determine them from other
/// speeds. `None` if there are no such speeds.
fn check_note_on_speeds(model: &Model) -> Option<String> {
    let names =
        |list: &mut dyn Iterator<Item = &String>| list.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
    let none = names(&mut model.dependent_speeds.iter().filter(|speed| speed.is_stated).map(|speed| &speed.name));
    let independent = names(&mut model.speeds.iter().map(|speed| &speed.name));
    let independent = if independent.is_empty() { "none".to_owned() } else { independent };
    (!none.is_empty()).then(|| {
        format!("of the speeds that joints name the constraints leave {independent} independent: {none} follow, and can be outputs of scenes")
    })
}

/// Writes a note for each body that has no inertia about the axis about which the speed `speed`
/// turns it. Error if the kinematics cannot be derived.
fn check_notes_on_missing_inertia(model: &Model, speed: &str) -> Result<Vec<String>, DeriveError> {
    let Some(at) = model.speeds.iter().position(|s| s.name == speed) else { return Ok(Vec::new()) };
    let mut kinematics = Kinematics::new(model)?;
    let velocities = kinematics.in_speeds(model);
    let mut gradient = Gradient::new(&[model.speeds[at].symbol]);
    let mut notes = Vec::new();
    for body in &model.bodies {
        let Some((frame, inertia)) = &body.rigid else { continue };
        let turning = velocities.angular[*frame].partial_derivatives(&mut kinematics.arena, &mut gradient);
        let Some((_, axis)) = turning.into_iter().next() else { continue };
        let axis: Vector = axis;
        let axis = kinematics.frames.express(&mut kinematics.arena, &axis, inertia.frame);
        let momentum = apply_tensor(&mut kinematics.arena, &inertia.tensor, &axis);
        let is_zero = |e: &Expr| zero_test(&kinematics.arena, *e) == ZeroTest::Zero;
        if momentum.iter().all(is_zero) && !axis.iter().all(is_zero) {
            notes.push(format!("the body `{}` has no inertia about the axis of `{speed}`", body.name));
        }
    }
    Ok(notes)
}

/// Largest number of bytes of a formula for the power of the loads in a note.
const LONGEST_POWER: usize = 1000;
/// Largest number of printed nodes in all definitions of names in that formula together.
const LONGEST_DEFINITIONS: usize = 5000;

/// Writes a note on the power that changes the total energy T + V, with the definitions of the names that the note
/// contains. `None` if T + V is constant.
fn check_note_on_power(model: &Model, arena: &Arena, power: Expr) -> Option<(String, Vec<Definition>)> {
    if model.is_driven() {
        let note = "constraints drive the mechanism: T + V changes by the work of their forces";
        return Some((note.to_owned(), Vec::new()));
    }
    if power == Expr::ZERO {
        return None;
    }
    let named = definitions_shown(arena, &[power]);
    let length = named.iter().map(|d| printed_length(arena, d.value)).fold(0, usize::saturating_add);
    let formula = print_text(arena, power);
    if formula.len() > LONGEST_POWER || length > LONGEST_DEFINITIONS {
        let note = "T + V changes at the power of the loads, a formula too long for a note";
        return Some((note.to_owned(), Vec::new()));
    }
    Some((format!("T + V changes at the rate {formula}"), named))
}

/// Function of the coordinates that a motion constraint keeps constant, as the text of a formula.
/// `None` if no function is found whose partial derivatives are the coefficients of the constraint.
fn integral_of(model: &Model, arena: &mut Arena, constraint: &MotionConstraint) -> Option<String> {
    let mut slopes = vec![Expr::ZERO; model.coordinates.len()];
    for &(at, slope) in Gradient::new(&model.q_dot()).apply(arena, constraint.equation).iter() {
        slopes[at] = slope;
    }
    // The drive is the part of a constraint without rates. It is the coefficient of the rate of
    // time.
    match model.time() {
        Some(time) => slopes[time] = arena.add(slopes[time], constraint.drive),
        None if constraint.drive != Expr::ZERO => return None,
        None => {}
    }
    let function = antiderivative(arena, &mut Simplifier::default(), &model.q(), &slopes)?;
    Some(print_text(arena, function))
}
