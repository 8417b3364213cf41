//! Kinematics: positions and velocities of all frames and points, from which all formulations start.
//!
//! T. R. Kane & D. A. Levinson, *Dynamics: Theory and Applications* (1985), §§ 2.7, 2.8 (points fixed on a body, and
//! moving on it), 2.12 (generalized speeds), 2.14 (partial velocities).

use super::equation_form::EquationForm;
use crate::geometry::name_transported_components;
use crate::mechanics::derivation_limits::check_link_limit;
use crate::mechanics::derive_error::DeriveError;

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::{Differential, Gradient, Substitution};
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::geometry::{Components, Frames, Placement, Vector, angular_velocities, apply_tensor, linear_velocities};
use crate::model::{Body, Model, Reaction, ReactionKind};

/// Kinematics of a model: positions and velocities as terms in q and q̇. It also holds the arena and the applied
/// loads, from which equations are derived.
pub struct Kinematics {
    /// Arena of all terms. It starts as a copy of the model's arena.
    pub arena: Arena,
    /// Frames of the model as a tree, and the rotation matrices between them.
    pub frames: Frames,
    /// Simplifier of terms; it keeps the terms that were already simplified.
    pub simplifier: Simplifier,
    /// Position vector p_OP of each point P of the model from the origin O, m.
    pub positions: Vec<Vector>,
    /// Velocities of all frames and points as terms in q and q̇.
    pub in_rates: Velocities,
    /// Vectors of the model's applied forces, N, as terms in parameters, q, q̇ and u. Velocities that a force names
    /// are replaced by terms.
    pub forces: Vec<Vector>,
    /// Vectors of the model's applied torques, N m, as terms in parameters, q, q̇ and u. Velocities that a torque
    /// names are replaced by terms.
    pub torques: Vec<Vector>,
    /// Potential of the applied loads; `None` until it is first computed.
    pub(in crate::mechanics) potential: Option<LoadPotential>,
}

/// Potential energy U of the applied loads, and the generalized forces that U does not contain.
#[derive(Clone, Debug)]
pub struct LoadPotential {
    /// Potential energy U as a term in q, J; 0 if no load has a potential.
    pub energy: Expr,
    /// Parts Q + ∂U/∂q of the generalized forces Q that U does not give, one for each coordinate. They are simplified
    /// terms in q and q̇.
    pub rest: Vec<Expr>,
    /// Indices of the loads whose potential is not in U. The indices count forces first, then torques, then stated
    /// potentials.
    pub outside: Vec<usize>,
}

/// Angular velocities of all frames and velocities of all points. They are terms in q and either in the rates q̇ or
/// in the speeds u.
#[derive(Clone)]
pub struct Velocities {
    /// Angular velocity ω of each frame of the model relative to the inertial frame, rad/s.
    pub angular: Vec<Vector>,
    /// Velocity v of each point of the model relative to the inertial frame, m/s.
    pub linear: Vec<Vector>,
    /// Rates q̇ of the coordinates as terms in the motion variables, one for each coordinate.
    pub rates: Vec<Expr>,
}

/// Kind of the motion variables v in which velocities, forces or equations are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MotionVariables {
    /// Generalized speeds u of the model.
    Speeds,
    /// Rates q̇ of all generalized coordinates.
    Rates,
}

impl Kinematics {
    /// Computes the kinematics of a model in the form that [`EquationForm::computed`] chooses: closed, or with named
    /// subterms.
    ///
    /// # Errors
    /// Returns a [`DeriveError`] in these cases: the model is too large, a stated inertia is not constant in its
    /// body, a stated reaction does work or has no unit direction, or a load divides by a velocity that is zero.
    pub fn new(model: &Model) -> Result<Self, DeriveError> {
        Self::in_form(model, EquationForm::computed(model))
    }

    /// Computes the kinematics of a model in a given form, closed or with named subterms. Equations that are derived
    /// from it have the same form.
    ///
    /// # Errors
    /// Returns a [`DeriveError`], for the same reasons as [`Self::new`].
    pub fn in_form(model: &Model, form: EquationForm) -> Result<Self, DeriveError> {
        check_link_limit(model)?;
        let mut arena = model.arena.clone();
        let mut frames = Frames::new(&model.frames);
        // Impulses of added masses are always written out, so models with added masses get no named subterms.
        frames.carries = form == EquationForm::Steps && model.added_masses.is_empty();
        let rates: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        let mut rates = Differential::along(&rates);
        let angular = angular_velocities(&mut arena, &model.frames, &mut rates);
        name_in_own_frames(&mut arena, &mut frames, &angular);
        let (positions, linear) = linear_velocities(&mut arena, &mut frames, &model.points, &angular, &mut rates);
        let in_rates = Velocities { angular, linear, rates: model.q_dot() };
        let (simplifier, forces, torques) = (Simplifier::default(), Vec::new(), Vec::new());
        let mut kinematics = Self { arena, frames, simplifier, positions, in_rates, forces, torques, potential: None };
        kinematics.apply_loads(model)?;
        kinematics.check_inertias(model)?;
        kinematics.check_reactions_do_no_work(model, model.stated_reactions())?;
        Ok(kinematics)
    }

    /// Computes the velocities of all frames and points as terms in q and the generalized speeds u.
    pub fn in_speeds(&mut self, model: &Model) -> Velocities {
        if self.frames.carries {
            let mut rates = kinematic_rates_without_acceleration(model);
            let angular = angular_velocities(&mut self.arena, &model.frames, &mut rates);
            name_in_own_frames(&mut self.arena, &mut self.frames, &angular);
            let (_, linear) = linear_velocities(&mut self.arena, &mut self.frames, &model.points, &angular, &mut rates);
            return Velocities { angular, linear, rates: model.kinematic_equations.rates.clone() };
        }
        let mut to_speeds = rates_to_speeds(model);
        let Self { arena, simplifier, .. } = self;
        let mut convert = |v: &Vector| v.substitute(arena, &mut to_speeds).simplify(arena, simplifier);
        Velocities {
            angular: self.in_rates.angular.iter().map(&mut convert).collect(),
            linear: self.in_rates.linear.iter().map(&mut convert).collect(),
            rates: model.kinematic_equations.rates.clone(),
        }
    }

    /// Angular momentum H = I · ω of a body about its mass centre, kg m²/s, along the frame of its
    /// inertia; zero for a particle.
    pub fn angular_momentum(&mut self, body: &Body, velocities: &Velocities) -> Vector {
        let Some((_, inertia)) = &body.rigid else { return Vector::default() };
        let omega = self.angular_velocity_in(body, velocities).unwrap_or([Expr::ZERO; 3]);
        Vector::in_frame(inertia.frame, apply_tensor(&mut self.arena, &inertia.tensor, &omega))
    }

    /// Components of a rigid body's angular velocity ω along the frame of its inertia, rad/s; `None`
    /// for a particle.
    pub fn angular_velocity_in(&mut self, body: &Body, velocities: &Velocities) -> Option<Components> {
        let (frame, inertia) = body.rigid.as_ref()?;
        let omega = self.frames.express(&mut self.arena, &velocities.angular[*frame], inertia.frame);
        Some(omega.map(|e| self.simplifier.simplify(&mut self.arena, e)))
    }

    /// Angular velocity ω (rad/s) and angular momentum H (kg m²/s) of a rigid body, as named components
    /// along the frame of its inertia; `None` for a particle.
    pub(in crate::mechanics) fn angular_velocity_and_momentum(
        &mut self,
        body: &Body,
        velocities: &Velocities,
    ) -> Option<(Components, Components)> {
        let (own, inertia) = body.rigid.as_ref()?;
        let name = self.frames.name(*own);
        let omega =
            self.frames.express_frame_by_frame(&mut self.arena, &velocities.angular[*own], inertia.frame, "w", name);
        let momentum = apply_tensor(&mut self.arena, &inertia.tensor, &omega);
        Some((omega, name_transported_components(&mut self.arena, momentum, &format!("H_{}", body.name))))
    }

    /// Time derivatives of a point's position components along the frame in which the model places it,
    /// m/s. Zero for the origin.
    pub(in crate::mechanics) fn point_rates_in_frame(
        &mut self,
        model: &Model,
        point: usize,
        velocities: &Velocities,
    ) -> Components {
        let Some(Placement { components, .. }) = model.points[point].position else { return [Expr::ZERO; 3] };
        let mut rates =
            Differential::along(&model.q().into_iter().zip(velocities.rates.iter().copied()).collect::<Vec<_>>());
        components.map(|e| rates.apply(&mut self.arena, e))
    }

    /// Acceleration of free fall, m/s², in the model's gravity frame; zero without gravity.
    pub(in crate::mechanics) fn fall(model: &Model) -> Vector {
        model.gravity.as_ref().map(|g| Vector::in_frame(g.frame, g.acceleration)).unwrap_or_default()
    }

    /// Checks that the inertia of each rigid body is constant in the body, if the model states it in a different
    /// frame. Returns `DeriveError::InertiaNotConstant` for the first inertia that is not.
    fn check_inertias(&mut self, model: &Model) -> Result<(), DeriveError> {
        let mut along_coordinates = Gradient::new(&model.q());
        for body in &model.bodies {
            let Some((frame, inertia)) = &body.rigid else { continue };
            if *frame == inertia.frame {
                continue;
            }
            // The inertia is constant in the body exactly if R I Rᵀ does not depend on q.
            let r = self.frames.rotation(&mut self.arena, inertia.frame, *frame);
            for (i, row) in r.iter().enumerate() {
                let column = apply_tensor(&mut self.arena, &inertia.tensor, row);
                for other in r.iter().take(i + 1) {
                    let products: Vec<_> = other.iter().zip(&column).map(|(a, b)| self.arena.mul(*a, *b)).collect();
                    let entry = self.arena.sum(&products);
                    for (_, slope) in along_coordinates.apply(&mut self.arena, entry).iter() {
                        if zero_test(&self.arena, *slope) != ZeroTest::Zero {
                            return Err(DeriveError::InertiaNotConstant {
                                body: body.name.clone(),
                                frame: model.frames[inertia.frame].name.clone(),
                                body_frame: model.frames[*frame].name.clone(),
                            });
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// Checks that the given reactions do no work in any permitted motion. The motions are along each q̇, or along
    /// each speed if motion constraints exist. Also checks that directions which the model file states are unit
    /// vectors.
    ///
    /// # Errors
    /// Returns `DeriveError::ReactionWorks` or `DeriveError::DirectionNotUnit` for the first reaction that fails.
    pub(in crate::mechanics) fn check_reactions_do_no_work(
        &mut self,
        model: &Model,
        reactions: &[Reaction],
    ) -> Result<(), DeriveError> {
        let mut to_permitted = (!model.motion_constraints.is_empty()).then(|| rates_to_speeds(model));
        let permitted: Vec<String> = match to_permitted {
            Some(_) => model.speeds.iter().map(|s| s.name.clone()).collect(),
            None => model.coordinates.iter().map(|c| format!("{}'", c.name)).collect(),
        };
        let mut along = Gradient::new(&if to_permitted.is_some() { model.u() } else { model.q_dot() });
        for reaction in reactions {
            let direction = Vector::in_frame(reaction.frame, reaction.direction);
            let square = self.frames.dot(&mut self.arena, &direction, &direction);
            let excess = self.arena.sub(square, Expr::ONE);
            // The direction of a joint that closes a loop has unit length only in poses in which the loop is closed,
            // so it is not checked.
            if reaction.is_stated && zero_test(&self.arena, excess) != ZeroTest::Zero {
                let length = crate::algebra::text::print::print_text(&self.arena, square);
                return Err(DeriveError::DirectionNotUnit { reaction: reaction.name.clone(), square: length });
            }
            let power = self.reaction_power(model, reaction);
            let power = to_permitted.as_mut().map_or(power, |put| put.apply(&mut self.arena, power));
            for (at, slope) in along.apply(&mut self.arena, power).iter() {
                if zero_test(&self.arena, *slope) != ZeroTest::Zero {
                    return Err(DeriveError::ReactionWorks {
                        reaction: reaction.name.clone(),
                        motion: permitted[*at].clone(),
                        rate: crate::algebra::text::print::print_text(&self.arena, *slope),
                    });
                }
            }
        }
        Ok(())
    }

    /// Power of a reaction of size 1 (1 N or 1 N m), as a term in q and q̇.
    pub(in crate::mechanics) fn reaction_power(&mut self, model: &Model, reaction: &Reaction) -> Expr {
        let velocities = self.in_rates.clone();
        let velocity = match reaction.kind {
            ReactionKind::Force { on, against } => {
                let v = self.load_place_velocity(model, &velocities, on);
                let opposite = against.map(|place| self.load_place_velocity(model, &velocities, place));
                self.vector_difference(v, opposite)
            }
            ReactionKind::Torque { on, against } => {
                let omega = |body: usize| {
                    let frame = model.bodies[body].rigid.as_ref().map_or(0, |(frame, _)| *frame);
                    velocities.angular[frame].clone()
                };
                self.vector_difference(omega(on), against.map(omega))
            }
        };
        let direction = Vector::in_frame(reaction.frame, reaction.direction);
        self.frames.dot(&mut self.arena, &direction, &velocity)
    }

    /// Difference a − b of two vectors. `None` for `b` means the zero vector.
    fn vector_difference(&mut self, a: Vector, b: Option<Vector>) -> Vector {
        match b {
            None => a,
            Some(b) => {
                let back = b.neg(&mut self.arena);
                a.add(&mut self.arena, &back)
            }
        }
    }
}

/// Substitution that replaces the rates q̇ of the coordinates by W u + w in the generalized speeds
/// u.
#[must_use]
pub fn rates_to_speeds(model: &Model) -> Substitution {
    let rates = model.q_dot();
    let pairs: Vec<_> = rates.into_iter().zip(model.kinematic_equations.rates.iter().copied()).collect();
    Substitution::new(&pairs)
}

/// Substitution that replaces the generalized speeds u by their definitions J q̇ + d.
#[must_use]
pub fn speeds_to_rates(model: &Model) -> Substitution {
    let pairs: Vec<_> = model.speeds.iter().map(|s| (s.symbol, s.definition)).collect();
    Substitution::new(&pairs)
}

/// Time derivative d/dt of terms in q and u along the motion: q' = W u + w, and u' is the symbol
/// u̇.
#[must_use]
pub fn kinematic_rates(model: &Model) -> Differential {
    let mut rates: Vec<_> = model.q().into_iter().zip(model.kinematic_equations.rates.iter().copied()).collect();
    rates.extend(model.speeds.iter().map(|s| (s.symbol, s.rate)));
    Differential::along(&rates)
}

/// Time derivative d/dt of terms in q and u along a motion with u̇ = 0: q' = W u + w, u' = 0.
#[must_use]
pub fn kinematic_rates_without_acceleration(model: &Model) -> Differential {
    let rates = model.q().into_iter().zip(model.kinematic_equations.rates.iter().copied());
    Differential::along(&rates.collect::<Vec<_>>())
}

/// Names the components of each frame's angular velocity along its own axes, such as `w_A_1` for frame A. It must run
/// before any other term takes these names. Does nothing in closed form.
fn name_in_own_frames(arena: &mut Arena, frames: &mut Frames, angular: &[Vector]) {
    if frames.carries {
        for (frame, omega) in angular.iter().enumerate() {
            frames.express_frame_by_frame(arena, omega, frame, "w", frames.name(frame));
        }
    }
}
