//! Random pose and motion of a mechanism, in residues modulo a prime. A term whose residue is zero is identically
//! zero, except with a probability below 2⁻⁵⁰.
//!
//! Frames and points are visited once, parents first. Each frame costs few multiplications. A symbolic derivation, in
//! contrast, would expand the products of all rotations.

use crate::algebra::term::calculus::{Differential, Gradient, Substitution};
use crate::algebra::text::parse::VelocityOf;
use crate::algebra::value::field::Field;
use crate::algebra::value::residues::PointWithResidues;
use crate::algebra::{Arena, Expr, Function, Rational};
use crate::geometry::Turn;
use crate::model::{AddedVelocity, Model, Placement};
use std::collections::BTreeMap;

/// Vector as three residues modulo a prime. Components are along inertial axes unless stated otherwise.
pub type VectorResidues = [u64; 3];

/// Arithmetic of vectors whose components are residues modulo a prime.
#[derive(Clone, Copy)]
pub struct ResidueVectors(pub Field);

impl ResidueVectors {
    pub fn add(self, a: VectorResidues, b: VectorResidues) -> VectorResidues {
        std::array::from_fn(|i| self.0.add(a[i], b[i]))
    }

    pub fn sub(self, a: VectorResidues, b: VectorResidues) -> VectorResidues {
        std::array::from_fn(|i| self.0.sub(a[i], b[i]))
    }

    pub fn scale(self, k: u64, a: VectorResidues) -> VectorResidues {
        a.map(|x| self.0.mul(k, x))
    }

    pub fn dot(self, a: VectorResidues, b: VectorResidues) -> u64 {
        (0..3).fold(0, |sum, i| self.0.add(sum, self.0.mul(a[i], b[i])))
    }

    pub fn cross(self, a: VectorResidues, b: VectorResidues) -> VectorResidues {
        let f = self.0;
        std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            f.sub(f.mul(a[j], b[k]), f.mul(a[k], b[j]))
        })
    }

    /// Vector Σ components_i axes_i with the given components along the given axes.
    pub fn along(self, axes: &[VectorResidues; 3], components: VectorResidues) -> VectorResidues {
        (0..3).fold([0; 3], |sum, i| self.add(sum, self.scale(components[i], axes[i])))
    }
}

/// Reader of the residues of a list of terms, in the order of the terms.
pub struct PoseResidues(std::vec::IntoIter<u64>);

impl PoseResidues {
    /// Creates the reader of a list of residues, one for each term.
    pub fn new(list: Vec<u64>) -> Self {
        Self(list.into_iter())
    }

    /// Reads the residue of the next term.
    pub fn one(&mut self) -> u64 {
        self.0.next().expect("each term that was asked for has a residue")
    }

    /// Reads the residues of the next three terms, as a vector.
    pub fn triple(&mut self) -> VectorResidues {
        std::array::from_fn(|_| self.one())
    }
}

/// Frame in a random pose and motion. All vectors are residues with components along inertial axes.
#[derive(Clone)]
pub struct RandomFrame {
    /// Unit vectors of the frame's three axes, with components along inertial axes.
    pub axes: [VectorResidues; 3],
    /// Angular velocity of the frame per unit rate of each coordinate, then per unit rate of each motion of an opened
    /// joint (`Model::openings`).
    pub along: Vec<VectorResidues>,
    /// Angular velocity ω of the frame in the random motion.
    pub velocity: VectorResidues,
    /// Angular acceleration of the frame in the random motion.
    pub acceleration: VectorResidues,
}

/// Point in a random pose and motion. All vectors are residues with components along inertial axes.
#[derive(Clone)]
pub struct RandomPoint {
    /// Position of the point relative to the origin.
    pub place: VectorResidues,
    /// Velocity of the point per unit rate of each coordinate, then per unit rate of each motion of an opened joint
    /// (`Model::openings`).
    pub along: Vec<VectorResidues>,
    /// Velocity of the point in the random motion.
    pub velocity: VectorResidues,
    /// Acceleration of the point in the random motion.
    pub acceleration: VectorResidues,
}

/// Model in a random pose and motion, in residues modulo a prime.
pub struct RandomModel {
    /// Vector arithmetic modulo the prime.
    pub space: ResidueVectors,
    /// Frames in the random pose, in the order of the model.
    pub frames: Vec<RandomFrame>,
    /// Points in the random pose, in the order of the model.
    pub points: Vec<RandomPoint>,
    /// Partial derivatives ∂q̇/∂u in the random pose: a row for each coordinate, a column for each speed.
    pub partial_rates: Vec<Vec<u64>>,
    /// Random values of the model's symbols.
    drawn: PointWithResidues,
}

/// Terms of a quantity that depends on coordinates: its value, partial derivatives, and first two
/// time derivatives.
struct PoseQuantityTerms {
    /// Value of the quantity.
    value: Expr,
    /// Partial derivatives of the quantity, as (index of the coordinate or of the opened joint's motion, derivative).
    slopes: Vec<(usize, Expr)>,
    /// First time derivative of the quantity.
    rate: Expr,
    /// Second time derivative of the quantity.
    second: Expr,
}

/// Residues of the terms of a quantity (`PoseQuantityTerms`).
#[derive(Clone, Default)]
struct DerivativeResidues {
    /// Residue of the quantity's value.
    value: u64,
    /// Residues of the partial derivatives, as (index of the coordinate or of the opened joint's motion, residue).
    slopes: Vec<(usize, u64)>,
    /// Residue of the quantity's first time derivative.
    rate: u64,
    /// Residue of the quantity's second time derivative.
    second: u64,
}

impl PoseQuantityTerms {
    /// All terms of the quantity, in the order in which [`Self::read`] takes their residues.
    fn terms(&self) -> impl Iterator<Item = Expr> {
        [self.value, self.rate, self.second].into_iter().chain(self.slopes.iter().map(|(_, slope)| *slope))
    }

    /// Reads the residues of the quantity's value, of its partial derivatives and of its first two time derivatives.
    fn read(&self, residues: &mut PoseResidues) -> DerivativeResidues {
        let [value, rate, second] = residues.triple();
        DerivativeResidues {
            value,
            rate,
            second,
            slopes: self.slopes.iter().map(|(at, _)| (*at, residues.one())).collect(),
        }
    }
}

/// Velocity that a motion adds to the frame or point with the index `at`; `None` if it adds none.
fn added_velocity_in_pose(list: &[AddedVelocity], at: usize) -> Option<[Expr; 3]> {
    list.iter().find(|(moved, _)| *moved == at).map(|(_, velocity)| *velocity)
}

/// Operator that differentiates quantities with respect to the coordinates, and in time along the motion of a model.
struct PoseDifferentiator {
    /// Partial derivatives with respect to the coordinates.
    slopes: Gradient,
    /// Time derivative along the motion of the model.
    d_dt: Differential,
}

impl PoseDifferentiator {
    /// Adds derivatives along the motions of opened joints (openings) to each component, at indices from `first` on.
    /// `openings` holds the velocity that each motion adds, or `None`.
    fn open(components: &mut [(usize, PoseQuantityTerms)], first: usize, openings: &[Option<[Expr; 3]>]) {
        for (axis, followed) in components {
            let along =
                openings.iter().enumerate().filter_map(|(at, velocity)| Some((first + at, (*velocity)?[*axis])));
            followed.slopes.extend(along.filter(|(_, slope)| *slope != Expr::ZERO));
        }
    }

    /// Creates the operator for the motion q̇ = W u + w of a model.
    fn new(model: &Model) -> Self {
        let rates = model.kinematic_equations.rates.iter();
        let flow = model.coordinates.iter().zip(rates).map(|(c, rate)| (c.symbol, *rate));
        let flow: Vec<_> = flow.chain(model.speeds.iter().map(|s| (s.symbol, s.rate))).collect();
        Self { slopes: Gradient::new(&model.q()), d_dt: Differential::along(&flow) }
    }

    /// Differentiates a term: returns its partial derivatives and its first two time derivatives.
    fn follow(&mut self, arena: &mut Arena, value: Expr) -> PoseQuantityTerms {
        let rate = self.d_dt.apply(arena, value);
        let second = self.d_dt.apply(arena, rate);
        PoseQuantityTerms { value, slopes: self.slopes.apply(arena, value).iter().copied().collect(), rate, second }
    }

    /// Angular velocity that a rotation adds, as (axis 0, 1 or 2, component along this axis).
    fn spins(&mut self, arena: &mut Arena, turn: &Turn) -> Vec<(usize, PoseQuantityTerms)> {
        let oriented = match turn {
            Turn::About(axis, angle) => return vec![(*axis, self.follow(arena, *angle))],
            Turn::Oriented(oriented) => oriented,
        };
        let of: Vec<Vec<(usize, Expr)>> =
            oriented.spins.iter().map(|(of, _)| self.slopes.apply(arena, *of).iter().copied().collect()).collect();
        let spin = turn.spin(arena, &mut self.d_dt);
        let component = |axis: usize| {
            let mut slopes: BTreeMap<usize, Expr> = BTreeMap::new();
            for (slopes_of, (_, along)) in of.iter().zip(&oriented.spins) {
                for (at, slope) in slopes_of {
                    let share = arena.mul(*slope, along[axis]);
                    let sum = slopes.entry(*at).or_insert(Expr::ZERO);
                    *sum = arena.add(*sum, share);
                }
            }
            let second = self.d_dt.apply(arena, spin[axis]);
            (
                axis,
                PoseQuantityTerms { value: Expr::ZERO, slopes: slopes.into_iter().collect(), rate: spin[axis], second },
            )
        };
        [0, 1, 2].map(component).into()
    }
}

/// Terms of a rotated frame: its direction cosines, and the angular velocity that its rotation adds.
struct RotatedFrameTerms {
    /// Direction cosines of the frame. For a rotation about one axis, only the cosine and the sine of the angle.
    cosines: Vec<Expr>,
    /// Angular velocity that the rotation adds, as (axis 0, 1 or 2, component along this axis).
    spins: Vec<(usize, PoseQuantityTerms)>,
}

impl RandomModel {
    /// Draws a random pose and motion. New terms go to `arena`, a copy of the model's arena. `None` if
    /// no pose was found in which every term has a value.
    pub fn new(model: &Model, arena: &mut Arena) -> Option<Self> {
        let mut follower = PoseDifferentiator::new(model);
        let mut terms = Vec::new();
        let first = model.coordinates.len();
        let turns: Vec<Option<RotatedFrameTerms>> = model
            .frames
            .iter()
            .enumerate()
            .map(|(at, frame)| {
                let (_, turn) = frame.rotation.as_ref()?;
                let cosines = match turn {
                    Turn::About(_, angle) => [Function::Cos, Function::Sin].map(|f| arena.apply(f, *angle)).to_vec(),
                    Turn::Oriented(oriented) => oriented.cosines.concat(),
                };
                let mut spins = follower.spins(arena, turn);
                let openings: Vec<_> =
                    model.openings.iter().map(|opening| added_velocity_in_pose(&opening.turns, at)).collect();
                PoseDifferentiator::open(&mut spins, first, &openings);
                Some(RotatedFrameTerms { cosines, spins })
            })
            .collect();
        let places: Vec<Option<Vec<(usize, PoseQuantityTerms)>>> = model
            .points
            .iter()
            .enumerate()
            .map(|(at, point)| {
                let components = point.position?.components.into_iter().enumerate();
                let mut place = components.map(|(axis, e)| (axis, follower.follow(arena, e))).collect::<Vec<_>>();
                let openings: Vec<_> =
                    model.openings.iter().map(|opening| added_velocity_in_pose(&opening.moves, at)).collect();
                PoseDifferentiator::open(&mut place, first, &openings);
                Some(place)
            })
            .collect();
        for turning in turns.iter().flatten() {
            let spins = turning.spins.iter().flat_map(|(_, followed)| followed.terms());
            terms.extend(turning.cosines.iter().copied().chain(spins));
        }
        terms.extend(places.iter().flatten().flatten().flat_map(|(_, followed)| followed.terms()));
        let mut along_speeds = Gradient::new(&model.speeds.iter().map(|s| s.symbol).collect::<Vec<_>>());
        let mut partial = Vec::new();
        for rate in &model.kinematic_equations.rates {
            partial.push(along_speeds.apply(arena, *rate).iter().copied().collect::<Vec<(usize, Expr)>>());
        }
        terms.extend(partial.iter().flatten().map(|(_, slope)| *slope));
        let (drawn, residues) = PointWithResidues::new(arena, &terms)?;
        let mut residues = PoseResidues::new(residues);
        let space = ResidueVectors(drawn.field());
        let (n, p) = (model.coordinates.len(), model.speeds.len());
        let all = n + model.openings.len();
        let mut frames: Vec<RandomFrame> = Vec::new();
        for (frame, turning) in model.frames.iter().zip(&turns) {
            let (Some((parent, turn)), Some(turning)) = (&frame.rotation, turning) else {
                frames.push(RandomFrame::fixed_frame(all));
                continue;
            };
            let before: &RandomFrame = &frames[*parent];
            let axes = match turn {
                Turn::About(axis, _) => before.about(space, *axis, [residues.one(), residues.one()]),
                Turn::Oriented(_) => [0, 1, 2].map(|_| space.along(&before.axes, residues.triple())),
            };
            let spins: Vec<(usize, DerivativeResidues)> =
                turning.spins.iter().map(|(axis, followed)| (*axis, followed.read(&mut residues))).collect();
            frames.push(before.rotated_frame(space, axes, &spins));
        }
        let mut points: Vec<RandomPoint> = Vec::new();
        for (point, place) in model.points.iter().zip(&places) {
            let (Some(Placement { parent, frame, .. }), Some(followed)) = (point.position, place) else {
                points.push(RandomPoint::origin_in_pose(all));
                continue;
            };
            let place = [0, 1, 2].map(|i: usize| followed[i].1.read(&mut residues));
            points.push(points[parent].placed_point(space, &frames[frame], &place));
        }
        let mut partial_rates = vec![vec![0; p]; n];
        for (row, slopes) in partial_rates.iter_mut().zip(&partial) {
            for (at, _) in slopes {
                row[*at] = residues.one();
            }
        }
        Some(Self { space, frames, points, partial_rates, drawn })
    }

    /// Residues of further terms in the same pose, in which named velocities have their residues of the random
    /// motion. `None` if a term has no value.
    pub fn values(&self, model: &Model, arena: &mut Arena, terms: &[Expr]) -> Option<PoseResidues> {
        let symbols = model.q_dot().into_iter().zip(model.kinematic_equations.rates.iter().copied());
        let mut known: Vec<(Expr, Expr)> = symbols.collect();
        for name in &model.velocities {
            let vector = match name.of {
                VelocityOf::Material(body, point) => self.material(model, body, point, None),
                VelocityOf::Point(point) => self.points[point].velocity,
                VelocityOf::Place(point) => self.points[point].place,
                VelocityOf::Turning(frame) => self.frames[frame].velocity,
            };
            let residue = self.space.dot(vector, self.frames[name.frame].axes[name.axis]);
            let number = Rational::integer(i64::try_from(residue).ok()?);
            known.push((name.symbol, arena.number(number)));
        }
        let mut put = Substitution::new(&known);
        let terms: Vec<Expr> = terms.iter().map(|e| put.apply(arena, *e)).collect();
        self.drawn.values(arena, &terms).map(PoseResidues::new)
    }

    /// Velocity of the material of a body at a point. It is per unit rate of the motion `along`, or in the random
    /// motion if `along` is `None`.
    pub fn material(&self, model: &Model, body: usize, point: usize, along: Option<usize>) -> VectorResidues {
        let body = &model.bodies[body];
        let centre = &self.points[body.centre];
        let velocity = along.map_or(centre.velocity, |at| centre.along[at]);
        let Some((frame, _)) = &body.rigid else { return velocity };
        let turning = along.map_or(self.frames[*frame].velocity, |at| self.frames[*frame].along[at]);
        let arm = self.space.sub(self.points[point].place, centre.place);
        self.space.add(velocity, self.space.cross(turning, arm))
    }
}

impl RandomFrame {
    /// Creates the inertial frame. It does not move along any of the n motions.
    fn fixed_frame(n: usize) -> Self {
        let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
        Self { axes, along: vec![[0; 3]; n], velocity: [0; 3], acceleration: [0; 3] }
    }

    /// Axes of a frame that is rotated from this frame about one of its axes. `[cos, sin]` are the cosine and sine of
    /// the angle.
    fn about(&self, space: ResidueVectors, axis: usize, [cos, sin]: [u64; 2]) -> [VectorResidues; 3] {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut axes = self.axes;
        axes[j] = space.add(space.scale(cos, self.axes[j]), space.scale(sin, self.axes[k]));
        axes[k] = space.sub(space.scale(cos, self.axes[k]), space.scale(sin, self.axes[j]));
        axes
    }

    /// Frame that is rotated from this frame so that it has the given axes. `spins` are the components of the angular
    /// velocity that the rotation adds.
    fn rotated_frame(
        &self,
        space: ResidueVectors,
        axes: [VectorResidues; 3],
        spins: &[(usize, DerivativeResidues)],
    ) -> Self {
        let mut along = self.along.clone();
        let (mut spin, mut second) = ([0; 3], [0; 3]);
        for (axis, values) in spins {
            let e = axes[*axis];
            for (at, slope) in &values.slopes {
                along[*at] = space.add(along[*at], space.scale(*slope, e));
            }
            spin = space.add(spin, space.scale(values.rate, e));
            second = space.add(second, space.scale(values.second, e));
        }
        let carried = space.cross(self.velocity, spin);
        let own = space.add(carried, second);
        Self { axes, along, velocity: space.add(self.velocity, spin), acceleration: space.add(self.acceleration, own) }
    }
}

impl RandomPoint {
    /// Creates the origin. It does not move along any of the n motions.
    fn origin_in_pose(n: usize) -> Self {
        Self { place: [0; 3], along: vec![[0; 3]; n], velocity: [0; 3], acceleration: [0; 3] }
    }

    /// Point that is placed from this point, with the components `place` of its position vector in `frame`.
    fn placed_point(&self, space: ResidueVectors, frame: &RandomFrame, place: &[DerivativeResidues; 3]) -> Self {
        let of =
            |part: fn(&DerivativeResidues) -> u64| space.along(&frame.axes, [0, 1, 2].map(|i: usize| part(&place[i])));
        let (arm, slip, second) = (of(|v| v.value), of(|v| v.rate), of(|v| v.second));
        let mut along: Vec<VectorResidues> =
            self.along.iter().zip(&frame.along).map(|(v, turn)| space.add(*v, space.cross(*turn, arm))).collect();
        for (axis, component) in frame.axes.iter().zip(place) {
            for (at, slope) in &component.slopes {
                along[*at] = space.add(along[*at], space.scale(*slope, *axis));
            }
        }
        let turning = space.cross(frame.velocity, arm);
        // a = a₀ + α × r + ω × (ω × r + 2 v_rel) + a_rel.
        let twice = space.add(turning, space.add(slip, slip));
        let centripetal = space.cross(frame.velocity, twice);
        let own = space.add(space.cross(frame.acceleration, arm), space.add(centripetal, second));
        Self {
            place: space.add(self.place, arm),
            along,
            velocity: space.add(self.velocity, space.add(turning, slip)),
            acceleration: space.add(self.acceleration, own),
        }
    }
}
