//! Inertia of a body about any point that is fixed in the body: mass, first moment and inertia tensor.
//!
//! The kinetic energy, the weight and the inertia force of a body are linear in these ten numbers, even if no body can
//! have them: a base parameter may leave a first moment without a mass.

use super::inertial_anchor::Anchor;
use super::inertial_parameter::InertialParameter;
use super::kinematics::{Kinematics, Velocities};
use super::tree_accelerations::Accelerations;
use crate::algebra::term::calculus::{Substitution, expand_names};
use crate::algebra::{Arena, Expr, Rational};
use crate::geometry::{Components, cross_components};
use crate::model::{Body, Model};

/// Components of the zero vector.
const NOTHING: Components = [Expr::ZERO; 3];

/// Inertia of a body about a point, along the axes of a frame. Both are fixed in the body.
#[derive(Clone, Debug)]
pub(in crate::mechanics) struct PlacedInertia {
    /// Index of the reference point P in the model's list of points.
    pub point: usize,
    /// Index of the frame of the axes in the model's list of frames; `None` for a particle.
    pub frame: Option<usize>,
    /// Mass m of the body, kg.
    pub mass: Expr,
    /// First moment s = m p_PC of the body about the reference point, kg m.
    pub moment: Components,
    /// Inertia tensor J of the body about the reference point, kg m².
    pub tensor: [Components; 3],
    /// True if the tensor was given by second moments, in which inertia forces are then written.
    pub has_second_moments: bool,
}

impl PlacedInertia {
    /// Inertia of a body about its mass centre, along the frame of its stated inertia. `None` if this frame turns
    /// relative to the body.
    pub(in crate::mechanics) fn about_centre(body: &Body) -> Option<Self> {
        let (frame, tensor) = match &body.rigid {
            Some((own, inertia)) if *own == inertia.frame => (Some(*own), inertia.tensor),
            Some(_) => return None,
            None => (None, [NOTHING; 3]),
        };
        Some(Self { point: body.centre, frame, mass: body.mass, moment: NOTHING, tensor, has_second_moments: false })
    }

    /// Inertia of a body without mass at its anchor, to which inertial parameters can be added.
    pub(in crate::mechanics) fn empty_at(anchor: &Anchor) -> Self {
        let frame = anchor.turns.map(|_| anchor.frame);
        let (moment, tensor) = (NOTHING, [NOTHING; 3]);
        Self { point: anchor.point, frame, mass: Expr::ZERO, moment, tensor, has_second_moments: false }
    }

    /// Inertia of a body about its anchor as the model states it, by the parallel axis theorem.
    pub(in crate::mechanics) fn about_anchor(kinematics: &mut Kinematics, body: &Body, anchor: &Anchor) -> Self {
        let back = kinematics.positions[anchor.point].neg(&mut kinematics.arena);
        let arm = kinematics.positions[body.centre].add(&mut kinematics.arena, &back);
        let Kinematics { arena, frames, simplifier, .. } = kinematics;
        let r = frames.express(arena, &arm, anchor.frame).map(|e| expand_names(arena, e));
        let r = r.map(|e| simplifier.simplify(arena, e));
        let mut tensor = [NOTHING; 3];
        if let Some((_, own)) = &body.rigid {
            // The tensor R I Rᵀ is constant in the body.
            let turn = frames.rotation(arena, own.frame, anchor.frame);
            for i in 0..3 {
                for j in 0..3 {
                    let terms: Vec<Expr> = (0..9)
                        .map(|k| arena.product(&[turn[i][k / 3], own.tensor[k / 3][k % 3], turn[j][k % 3]]))
                        .collect();
                    tensor[i][j] = arena.sum(&terms);
                }
            }
        }
        let squares = r.map(|e| arena.square(e));
        for (i, row) in tensor.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                let away = if i == j {
                    arena.add(squares[(i + 1) % 3], squares[(i + 2) % 3])
                } else {
                    let product = arena.mul(r[i], r[j]);
                    arena.neg(product)
                };
                let shift = arena.mul(body.mass, away);
                let sum = arena.add(*entry, shift);
                let sum = value_at_zero(arena, sum, &anchor.moved);
                *entry = simplifier.simplify(arena, sum);
            }
        }
        let moment = r.map(|e| arena.mul(body.mass, e));
        Self { mass: body.mass, moment, tensor, ..Self::empty_at(anchor) }
    }

    /// Value of an inertial parameter of the body.
    pub(in crate::mechanics) fn value(&self, arena: &mut Arena, parameter: InertialParameter) -> Expr {
        match parameter {
            InertialParameter::Mass => self.mass,
            InertialParameter::FirstMoment(axis) => self.moment[axis],
            InertialParameter::Inertia(i, j) => self.tensor[i][j],
            InertialParameter::SecondMoment(axis) => self.second_moment(arena, axis),
        }
    }

    /// Second moment ∫ x² dm along an axis: half of the moments of inertia about the other axes less that about this
    /// axis, kg m².
    fn second_moment(&self, arena: &mut Arena, axis: usize) -> Expr {
        let half = Rational::fraction(1, 2).expect("not zero");
        let minus = half.neg();
        let about = |at: usize| self.tensor[at % 3][at % 3];
        arena.linear_combination(&[(about(axis + 1), half.clone()), (about(axis + 2), half), (about(axis), minus)])
    }

    /// Adds a value to an inertial parameter of the body.
    pub(in crate::mechanics) fn add(&mut self, arena: &mut Arena, parameter: InertialParameter, value: Expr) {
        match parameter {
            InertialParameter::Mass => self.mass = arena.add(self.mass, value),
            InertialParameter::FirstMoment(axis) => self.moment[axis] = arena.add(self.moment[axis], value),
            InertialParameter::Inertia(i, j) => {
                let sum = arena.add(self.tensor[i][j], value);
                (self.tensor[i][j], self.tensor[j][i]) = (sum, sum);
            }
            InertialParameter::SecondMoment(axis) => {
                self.has_second_moments = true;
                for about in [(axis + 1) % 3, (axis + 2) % 3] {
                    self.tensor[about][about] = arena.add(self.tensor[about][about], value);
                }
            }
        }
    }

    /// Velocity components of the body, each paired with the inertia force and weight along it. The given
    /// accelerations must be relative to free fall, so that inertia forces include the weights.
    ///
    /// With b = a_P − g and A = α× + ω×ω×, the required force is m b + A s, and the required moment about P is s × b +
    /// J α + ω × J ω.
    pub(in crate::mechanics) fn inertia_pairs(
        &self,
        kinematics: &mut Kinematics,
        model: &Model,
        velocities: &Velocities,
        accelerations: &Accelerations,
    ) -> Vec<(Expr, Expr)> {
        let (v, a) = (&velocities.linear[self.point], &accelerations.linear[self.point]);
        let home = self.frame.unwrap_or_else(|| kinematics.frames.common_transport_frame([v, a]));
        let point = &model.points[self.point].name;
        let Kinematics { arena, frames, .. } = kinematics;
        let v = frames.express_frame_by_frame(arena, v, home, "v", point);
        let b = frames.express_frame_by_frame(arena, a, home, "a", point);
        let mut force = b.map(|e| arena.mul(self.mass, e));
        let mut pairs = Vec::new();
        if let Some(frame) = self.frame {
            let name = &model.frames[frame].name;
            let omega = frames.express_frame_by_frame(arena, &velocities.angular[frame], frame, "w", name);
            let alpha = frames.express_frame_by_frame(arena, &accelerations.angular[frame], frame, "alpha", name);
            let turn = kinematics.relative_acceleration_matrix(model, frame, &alpha, &omega);
            let squares = kinematics.named_angular_velocity_products(model, frame, &omega);
            let arena = &mut kinematics.arena;
            for (i, force) in force.iter_mut().enumerate() {
                let along: [Expr; 3] = std::array::from_fn(|j| arena.mul(turn[i][j], self.moment[j]));
                *force = arena.sum(&[*force, along[0], along[1], along[2]]);
            }
            let of_moment = cross_components(arena, &self.moment, &b);
            let moment: Components = std::array::from_fn(|i| {
                let turning = self.required_moment_about_axis(arena, i, &alpha, &turn, &squares);
                arena.add(of_moment[i], turning)
            });
            pairs.extend(omega.into_iter().zip(moment));
        }
        pairs.extend(v.into_iter().zip(force));
        pairs.into_iter().map(|(along, needed)| (along, kinematics.arena.neg(needed))).collect()
    }

    /// Component i of J α + ω × J ω, from α, the entries of A = α× + ω×ω× and the products ω_i ω_j. Points of the body
    /// need the entries of A as well.
    ///
    /// With the axes j and k that follow i in cyclic order, the component is D − A_ki J_ij + A_ji J_ik + (ω_j² − ω_k²)
    /// J_jk. Here D = J_ii α_i + (J_kk − J_jj) ω_j ω_k. In the second moments S_j and S_k along the axes, D = A_kj S_j
    /// − A_jk S_k.
    fn required_moment_about_axis(
        &self,
        arena: &mut Arena,
        i: usize,
        alpha: &Components,
        turn: &[Components; 3],
        squares: &[Components; 3],
    ) -> Expr {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let (plus, minus) = (Rational::ONE, Rational::integer(-1));
        let diagonal = if self.has_second_moments {
            let [along_j, along_k] = [j, k].map(|axis| self.second_moment(arena, axis));
            [(turn[k][j], along_j, plus.clone()), (turn[j][k], along_k, minus.clone())]
        } else {
            let difference = arena.sub(self.tensor[k][k], self.tensor[j][j]);
            [(alpha[i], self.tensor[i][i], plus.clone()), (squares[j][k], difference, plus.clone())]
        };
        let products = [self.tensor[i][j], self.tensor[i][k], self.tensor[j][k]];
        let difference = if products[2] == Expr::ZERO { Expr::ZERO } else { arena.sub(squares[j][j], squares[k][k]) };
        let beside = [
            (turn[k][i], products[0], minus),
            (turn[j][i], products[1], plus.clone()),
            (difference, products[2], plus),
        ];
        let terms: Vec<(Expr, Rational)> = diagonal
            .into_iter()
            .chain(beside)
            .map(|(motion, inertia, sign)| (arena.mul(motion, inertia), sign))
            .collect();
        arena.linear_combination(&terms)
    }
}

/// Value of a term with all coordinates zero, for a term that contains coordinates but does not depend on them.
/// Returns the term itself if it has no value there.
fn value_at_zero(arena: &mut Arena, e: Expr, coordinates: &[Expr]) -> Expr {
    let e = expand_names(arena, e);
    let mut put = Substitution::new(&coordinates.iter().map(|q| (*q, Expr::ZERO)).collect::<Vec<_>>());
    let value = put.apply(arena, e);
    if put.undefined.is_some() { e } else { value }
}
