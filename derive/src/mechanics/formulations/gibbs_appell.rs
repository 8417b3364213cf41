//! Gibbs–Appell equations: ∂S/∂u̇_r = F_r for each generalized speed. S = Σ ½ m a_C·a_C + ½ α·I·α + α·(ω × I·ω) is
//! the acceleration energy, summed over the bodies.
//!
//! S is quadratic in u̇, so its derivative is M u̇ + rest. Terms of S without u̇ have no derivative and are left out.
//! Motion constraints may leave fewer speeds than coordinates. Then a_C and α are those of permitted motions.
//!
//! J. W. Gibbs, "On the fundamental formulae of dynamics", American Journal of Mathematics 2 (1879) 49–64; P. Appell,
//! "Sur une forme générale des équations de la dynamique", J. reine angew. Math. 121 (1900) 310–319.

use super::tree_recursion::symmetric_derivative_matrix;
use crate::algebra::solve::quadratic_minimum::QuadraticBlock;
use crate::algebra::term::adjoint::adjoint_product;
use crate::algebra::term::calculus::{Gradient, Substitution};
use crate::algebra::{Arena, Expr, Rational};
use crate::geometry::{Dots, SymmetricDots, Vector, apply_tensor, cross_components};
use crate::mechanics::derive_error::DeriveError;
use crate::mechanics::motion::energy::Impulse;
use crate::mechanics::motion::kinematics::{
    Kinematics, Velocities, kinematic_rates, kinematic_rates_without_acceleration,
};
use crate::mechanics::motion::loads::{Load, active_forces_of_loads};
use crate::mechanics::rows::{LineName, RowName, Rows, Stage, Step, kinematic_step};
use crate::model::Model;

/// Derives the Gibbs–Appell equations M(q) u̇ = f(q, u).
///
/// # Errors
/// Never returns an error. The rank of the matrix shows later if a speed moves no mass.
#[expect(clippy::unnecessary_wraps, reason = "a row of the table of formulations, of which others may fail")]
pub fn derive_gibbs_appell(model: &Model, kinematics: &mut Kinematics) -> Result<Rows, DeriveError> {
    let velocities = kinematics.in_speeds(model);
    let forces = active_forces_of_loads(model, kinematics, &velocities);
    let AccelerationEnergy { matrix, rest } = AccelerationEnergy::new(model, kinematics, &velocities);
    let gauss = kinematics.frames.carries.then(|| {
        let loads: Vec<Load> = kinematics.loads(model, &velocities).into_iter().flatten().collect();
        kinematics.gauss_function_along_tree(model, &velocities, &loads)
    });
    // M u̇ + rest = F:  M u̇ = F − rest.
    let forcing = forces.iter().zip(&rest).map(|(force, rest)| kinematics.arena.sub(*force, *rest)).collect();
    Ok(Rows {
        names: (0..model.speeds.len()).map(RowName::Speed).collect(),
        matrix,
        forcing,
        projection: Vec::new(),
        embedding: None,
        required: None,
        gauss,
        kinetic_energy: kinematics.kinetic_energy(model, &velocities, &model.u()),
    })
}

/// Acceleration energy S = ½ u̇ · M u̇ + rest · u̇, without the terms that do not contain u̇.
struct AccelerationEnergy {
    /// Symmetric matrix M = ∂²S/∂u̇∂u̇, one row and one column for each speed.
    matrix: Vec<Vec<Expr>>,
    /// Derivative ∂S/∂u̇ at u̇ = 0, one entry for each speed.
    rest: Vec<Expr>,
}

/// Summand of the acceleration energy S: scale (½ acceleration · inertial + acceleration · gyroscopic). It belongs to
/// a mass centre, a rotation or an added mass.
struct AccelerationEnergyPart {
    /// Mass of the body for the summand of a mass centre; 1 for that of a rotation or an added mass.
    scale: Expr,
    /// Acceleration a_C of the mass centre (m/s²), or angular acceleration α (rad/s²).
    acceleration: Vector,
    /// Vector that is linear in u̇: a_C for a mass centre, I · α for a rotation, and the rate of the fluid's impulse
    /// for an added mass.
    inertial: Vector,
    /// Vector without u̇: zero for a mass centre, ω × I · ω for a rotation, and v × p for the angular impulse of an
    /// added mass.
    gyroscopic: Vector,
}

impl AccelerationEnergy {
    /// Differentiates the acceleration energy S with respect to u̇. If the kinematics has named terms, it
    /// differentiates through them, otherwise summand by summand.
    fn new(model: &Model, kinematics: &mut Kinematics, velocities: &Velocities) -> Self {
        let rates: Vec<Expr> = model.speeds.iter().map(|speed| speed.rate).collect();
        if kinematics.frames.carries {
            Self::of_blocks(model, kinematics, velocities, &rates)
        } else {
            let parts = acceleration_energy_parts(model, kinematics, velocities);
            Self::of_parts(kinematics, &parts, &rates)
        }
    }

    /// Differentiates the summands of S by the product rule. `inertial` is linear and symmetric in the acceleration,
    /// so ∂S/∂u̇_r = Σ scale ∂acceleration/∂u̇_r · (inertial + gyroscopic).
    fn of_parts(kinematics: &mut Kinematics, parts: &[AccelerationEnergyPart], rates: &[Expr]) -> Self {
        let Kinematics { arena, frames, simplifier, .. } = kinematics;
        let zeros: Vec<(Expr, Expr)> = rates.iter().map(|rate| (*rate, Expr::ZERO)).collect();
        let mut without_rates = Substitution::new(&zeros);
        let mut gradient = Gradient::new(rates);
        let mut products = SymmetricDots::new(rates.len());
        let mut rest: Vec<Dots> = rates.iter().map(|_| Dots::default()).collect();
        for AccelerationEnergyPart { scale, acceleration, inertial, gyroscopic } in parts {
            let slopes = acceleration.partial_derivatives(arena, &mut gradient);
            products.add(*scale, &slopes, &inertial.partial_derivatives(arena, &mut gradient));
            let at_zero = inertial.substitute(arena, &mut without_rates).add(arena, gyroscopic);
            for (r, slope) in &slopes {
                rest[*r].add(*scale, slope, &at_zero);
            }
        }
        let mut matrix = products.sum(arena, frames);
        matrix.iter_mut().flatten().for_each(|e| *e = simplifier.simplify(arena, *e));
        Self { matrix, rest: rest.iter().map(|dots| dots.sum(arena, frames)).collect() }
    }

    /// Differentiates S backwards (adjoint method) through the named terms of the accelerations. A
    /// block ½ e · K e + b · e contributes Σ ∂e/∂u̇ · (K e + b).
    fn of_blocks(model: &Model, kinematics: &mut Kinematics, velocities: &Velocities, rates: &[Expr]) -> Self {
        let none = Vector::default();
        let moving = kinematics.acceleration_energy_along_tree(model, velocities, &mut kinematic_rates(model), &none);
        let mut coasting = kinematic_rates_without_acceleration(model);
        let coasting = kinematics.acceleration_energy_along_tree(model, velocities, &mut coasting, &none);
        let arena = &mut kinematics.arena;
        let (mut quadratic, mut linear) = (Vec::new(), Vec::new());
        for (block, at_zero) in moving.iter().zip(&coasting) {
            let [along, known] = [block, at_zero]
                .map(|QuadraticBlock { components, tensor, .. }| apply_tensor(arena, tensor, components));
            for (i, e) in block.components.into_iter().enumerate() {
                quadratic.push((e, along[i]));
                linear.push((e, arena.add(known[i], at_zero.linear[i])));
            }
        }
        let slopes = adjoint_product(arena, &quadratic, rates, SLOPE);
        Self {
            matrix: symmetric_derivative_matrix(arena, &slopes, rates),
            rest: adjoint_product(arena, &linear, rates, SLOPE),
        }
    }

    /// Acceleration energy S as a single term, without the terms that do not contain u̇.
    fn formula(&self, arena: &mut Arena, rates: &[Expr]) -> Expr {
        let half = Rational::fraction(1, 2).expect("not zero");
        let mut terms = Vec::new();
        for (r, row) in self.matrix.iter().enumerate() {
            for (s, entry) in row.iter().enumerate().skip(r) {
                let product = arena.product(&[*entry, rates[r], rates[s]]);
                terms.push((product, if r == s { half.clone() } else { Rational::ONE }));
            }
            terms.push((arena.mul(self.rest[r], rates[r]), Rational::ONE));
        }
        arena.linear_combination(&terms)
    }
}

/// Prefix for the names of derivatives of S with respect to named terms.
const SLOPE: &str = "S";

/// Lists the summands of the acceleration energy of all bodies and added masses, in q, u and u̇.
fn acceleration_energy_parts(
    model: &Model,
    kinematics: &mut Kinematics,
    velocities: &Velocities,
) -> Vec<AccelerationEnergyPart> {
    let mut rates = kinematic_rates(model);
    let mut parts = Vec::new();
    for body in &model.bodies {
        let Kinematics { arena, frames, .. } = kinematics;
        let a = frames.time_derivative(arena, &velocities.linear[body.centre], &velocities.angular, &mut rates);
        parts.push(AccelerationEnergyPart {
            scale: body.mass,
            acceleration: a.clone(),
            inertial: a,
            gyroscopic: Vector::default(),
        });
        if let (Some((_, inertia)), Some(omega)) = (&body.rigid, kinematics.angular_velocity_in(body, velocities)) {
            let Kinematics { arena, frames, .. } = kinematics;
            let turning = Vector::in_frame(inertia.frame, omega);
            let alpha = frames.time_derivative(arena, &turning, &velocities.angular, &mut rates);
            let alpha = frames.express(arena, &alpha, inertia.frame);
            let inertial = apply_tensor(arena, &inertia.tensor, &alpha);
            let momentum = apply_tensor(arena, &inertia.tensor, &omega);
            let gyroscopic = cross_components(arena, &omega, &momentum);
            let [acceleration, inertial, gyroscopic] =
                [alpha, inertial, gyroscopic].map(|components| Vector::in_frame(inertia.frame, components));
            parts.push(AccelerationEnergyPart { scale: Expr::ONE, acceleration, inertial, gyroscopic });
        }
    }
    for added in &model.added_masses {
        let Impulse { velocity, omega, linear, angular, carried } =
            kinematics.added_mass_impulse(model, velocities, added);
        let Kinematics { arena, frames, .. } = kinematics;
        let mut rate = |vector: &Vector| frames.time_derivative(arena, vector, &velocities.angular, &mut rates);
        let [acceleration, alpha, force, moment] = [&velocity, &omega, &linear, &angular].map(&mut rate);
        let none = Vector::default();
        parts.push(AccelerationEnergyPart { scale: Expr::ONE, acceleration, inertial: force, gyroscopic: none });
        parts.push(AccelerationEnergyPart {
            scale: Expr::ONE,
            acceleration: alpha,
            inertial: moment,
            gyroscopic: carried,
        });
    }
    parts
}

/// Derives the acceleration energy and the generalized active forces: the steps of the Gibbs–Appell method, for
/// display.
///
/// # Errors
/// Never returns an error.
#[expect(clippy::unnecessary_wraps, reason = "the steps of other methods can fail")]
pub fn gibbs_appell_steps(model: &Model, kinematics: &mut Kinematics) -> Result<Vec<Step>, DeriveError> {
    let velocities = kinematics.in_speeds(model);
    let mut energy = AccelerationEnergy::new(model, kinematics, &velocities);
    let forces = active_forces_of_loads(model, kinematics, &velocities);
    let Kinematics { arena, simplifier, .. } = kinematics;
    energy.rest.iter_mut().for_each(|e| *e = simplifier.simplify(arena, *e));
    let rates: Vec<Expr> = model.speeds.iter().map(|speed| speed.rate).collect();
    let formula = energy.formula(arena, &rates);
    let forces = forces.into_iter().enumerate();
    let forces = forces.map(|(at, e)| (LineName::ActiveForce(at), simplifier.simplify(arena, e))).collect();
    Ok(vec![
        kinematic_step(model),
        Step {
            stage: Stage::Titled("Acceleration energy, without the terms that contain no acceleration"),
            lines: vec![(LineName::Symbol("S"), formula)],
        },
        Step { stage: Stage::ActiveForces, lines: forces },
    ])
}
