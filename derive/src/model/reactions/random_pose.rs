//! A mechanism in one random pose and motion, in residues modulo a prime. A term whose residue is zero is identically
//! zero, except with a chance below 2⁻⁵⁰.
//!
//! Frames and points are visited once, parents first. Each frame costs few multiplications, where a symbolic derivation
//! would multiply out all turns.

use crate::algebra::term::calculus::{Differential, Gradient, Substitution};
use crate::algebra::text::parse::VelocityOf;
use crate::algebra::value::field::Field;
use crate::algebra::value::points::Drawn;
use crate::algebra::{Arena, Expr, Function, Rational};
use crate::geometry::Turn;
use crate::model::{AddedVelocity, Model, Placement};
use std::collections::BTreeMap;

/// Residues of three components of a vector, along inertial axes if nothing else is said.
pub type Triple = [u64; 3];

/// Arithmetic of vectors whose components are residues modulo a prime.
#[derive(Clone, Copy)]
pub struct Space(pub Field);

impl Space {
    pub fn add(self, a: Triple, b: Triple) -> Triple {
        std::array::from_fn(|i| self.0.add(a[i], b[i]))
    }

    pub fn sub(self, a: Triple, b: Triple) -> Triple {
        std::array::from_fn(|i| self.0.sub(a[i], b[i]))
    }

    pub fn scale(self, k: u64, a: Triple) -> Triple {
        a.map(|x| self.0.mul(k, x))
    }

    pub fn dot(self, a: Triple, b: Triple) -> u64 {
        (0..3).fold(0, |sum, i| self.0.add(sum, self.0.mul(a[i], b[i])))
    }

    pub fn cross(self, a: Triple, b: Triple) -> Triple {
        let f = self.0;
        std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            f.sub(f.mul(a[j], b[k]), f.mul(a[k], b[j]))
        })
    }

    /// Vector with these components along these axes: Σ components[i] · axes[i].
    pub fn along(self, axes: &[Triple; 3], components: Triple) -> Triple {
        (0..3).fold([0; 3], |sum, i| self.add(sum, self.scale(components[i], axes[i])))
    }
}

/// Residues of terms, read one after another in the order of the terms.
pub struct Residues(std::vec::IntoIter<u64>);

impl Residues {
    pub fn new(list: Vec<u64>) -> Self {
        Self(list.into_iter())
    }

    /// Reads the residue of the next term.
    pub fn one(&mut self) -> u64 {
        self.0.next().expect("each term that was asked for has a residue")
    }

    /// Reads the residues of the next three terms, as a vector.
    pub fn triple(&mut self) -> Triple {
        std::array::from_fn(|_| self.one())
    }
}

/// A frame in a random pose: axes, angular velocity along each q̇ and then along each of [`Model::openings`], in total,
/// and angular acceleration.
#[derive(Clone)]
pub struct DrawnFrame {
    pub axes: [Triple; 3],
    pub along: Vec<Triple>,
    pub velocity: Triple,
    pub acceleration: Triple,
}

/// A point in a random pose: position, velocity along each q̇ and then along each of [`Model::openings`], in total, and
/// acceleration.
#[derive(Clone)]
pub struct DrawnPoint {
    pub place: Triple,
    pub along: Vec<Triple>,
    pub velocity: Triple,
    pub acceleration: Triple,
}

/// A model in a random pose and motion, in residues modulo a prime.
pub struct DrawnModel {
    pub space: Space,
    pub frames: Vec<DrawnFrame>,
    pub points: Vec<DrawnPoint>,
    /// Slopes ∂q̇/∂u: a row for each coordinate, a column for each speed.
    pub partial_rates: Vec<Vec<u64>>,
    drawn: Drawn,
}

/// Terms of a quantity that depends on coordinates: its value, its slopes along coordinates, and its first two time
/// derivatives.
struct Followed {
    value: Expr,
    slopes: Vec<(usize, Expr)>,
    rate: Expr,
    second: Expr,
}

/// Residues of the terms of a `Followed` quantity.
#[derive(Clone, Default)]
struct FollowedResidues {
    value: u64,
    slopes: Vec<(usize, u64)>,
    rate: u64,
    second: u64,
}

impl Followed {
    fn terms(&self) -> impl Iterator<Item = Expr> {
        [self.value, self.rate, self.second].into_iter().chain(self.slopes.iter().map(|(_, slope)| *slope))
    }

    fn read(&self, residues: &mut Residues) -> FollowedResidues {
        let [value, rate, second] = residues.triple();
        FollowedResidues {
            value,
            rate,
            second,
            slopes: self.slopes.iter().map(|(at, _)| (*at, residues.one())).collect(),
        }
    }
}

/// Velocity that a motion adds at a frame or a point; `None` if it adds none.
fn added(list: &[AddedVelocity], at: usize) -> Option<[Expr; 3]> {
    list.iter().find(|(moved, _)| *moved == at).map(|(_, velocity)| *velocity)
}

/// Differentiates quantities along the coordinates, and along the motion of a model.
struct Follower {
    slopes: Gradient,
    d_dt: Differential,
}

impl Follower {
    /// Adds motions along coordinates that closed joints fix to the slopes of each component, at indices from `first`
    /// on. `openings` has the velocity that each motion adds.
    fn open(components: &mut [(usize, Followed)], first: usize, openings: &[Option<[Expr; 3]>]) {
        for (axis, followed) in components {
            let along =
                openings.iter().enumerate().filter_map(|(at, velocity)| Some((first + at, (*velocity)?[*axis])));
            followed.slopes.extend(along.filter(|(_, slope)| *slope != Expr::ZERO));
        }
    }

    fn new(model: &Model) -> Self {
        let rates = model.kinematic_equations.rates.iter();
        let flow = model.coordinates.iter().zip(rates).map(|(c, rate)| (c.symbol, *rate));
        let flow: Vec<_> = flow.chain(model.speeds.iter().map(|s| (s.symbol, s.rate))).collect();
        Self { slopes: Gradient::new(&model.q()), d_dt: Differential::along(&flow) }
    }

    fn follow(&mut self, arena: &mut Arena, value: Expr) -> Followed {
        let rate = self.d_dt.apply(arena, value);
        let second = self.d_dt.apply(arena, rate);
        Followed { value, slopes: self.slopes.apply(arena, value).iter().copied().collect(), rate, second }
    }

    /// Angular velocity that a turn adds: an axis, 0, 1 or 2, and the component along it.
    fn spins(&mut self, arena: &mut Arena, turn: &Turn) -> Vec<(usize, Followed)> {
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
            (axis, Followed { value: Expr::ZERO, slopes: slopes.into_iter().collect(), rate: spin[axis], second })
        };
        [0, 1, 2].map(component).into()
    }
}

/// Terms of a turned frame: its cosines (cosine and sine for a turn about one axis), and the angular velocity that its
/// turn adds.
struct Turning {
    cosines: Vec<Expr>,
    spins: Vec<(usize, Followed)>,
}

impl DrawnModel {
    /// Draws a pose and motion. New terms go to `arena`, a copy of the model's store. `None` if no pose was found in
    /// which every term has a value.
    pub fn new(model: &Model, arena: &mut Arena) -> Option<Self> {
        let mut follower = Follower::new(model);
        let mut terms = Vec::new();
        let first = model.coordinates.len();
        let turns: Vec<Option<Turning>> = model
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
                let openings: Vec<_> = model.openings.iter().map(|opening| added(&opening.turns, at)).collect();
                Follower::open(&mut spins, first, &openings);
                Some(Turning { cosines, spins })
            })
            .collect();
        let places: Vec<Option<Vec<(usize, Followed)>>> = model
            .points
            .iter()
            .enumerate()
            .map(|(at, point)| {
                let components = point.position?.components.into_iter().enumerate();
                let mut place = components.map(|(axis, e)| (axis, follower.follow(arena, e))).collect::<Vec<_>>();
                let openings: Vec<_> = model.openings.iter().map(|opening| added(&opening.moves, at)).collect();
                Follower::open(&mut place, first, &openings);
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
        let (drawn, residues) = Drawn::new(arena, &terms)?;
        let mut residues = Residues::new(residues);
        let space = Space(drawn.field());
        let (n, p) = (model.coordinates.len(), model.speeds.len());
        let all = n + model.openings.len();
        let mut frames: Vec<DrawnFrame> = Vec::new();
        for (frame, turning) in model.frames.iter().zip(&turns) {
            let (Some((parent, turn)), Some(turning)) = (&frame.rotation, turning) else {
                frames.push(DrawnFrame::still(all));
                continue;
            };
            let before: &DrawnFrame = &frames[*parent];
            let axes = match turn {
                Turn::About(axis, _) => before.about(space, *axis, [residues.one(), residues.one()]),
                Turn::Oriented(_) => [0, 1, 2].map(|_| space.along(&before.axes, residues.triple())),
            };
            let spins: Vec<(usize, FollowedResidues)> =
                turning.spins.iter().map(|(axis, followed)| (*axis, followed.read(&mut residues))).collect();
            frames.push(before.turned(space, axes, &spins));
        }
        let mut points: Vec<DrawnPoint> = Vec::new();
        for (point, place) in model.points.iter().zip(&places) {
            let (Some(Placement { parent, frame, .. }), Some(followed)) = (point.position, place) else {
                points.push(DrawnPoint::still(all));
                continue;
            };
            let place = [0, 1, 2].map(|i: usize| followed[i].1.read(&mut residues));
            points.push(points[parent].moved(space, &frames[frame], &place));
        }
        let mut partial_rates = vec![vec![0; p]; n];
        for (row, slopes) in partial_rates.iter_mut().zip(&partial) {
            for (at, _) in slopes {
                row[*at] = residues.one();
            }
        }
        Some(Self { space, frames, points, partial_rates, drawn })
    }

    /// Residues of further terms in the same pose; residues replace the velocities that the terms name. `None` if a
    /// term has no value.
    pub fn values(&self, model: &Model, arena: &mut Arena, terms: &[Expr]) -> Option<Residues> {
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
        self.drawn.values(arena, &terms).map(Residues::new)
    }

    /// Velocity of the material of a body at a point, along q̇ of one coordinate or, with `None`, in total.
    pub fn material(&self, model: &Model, body: usize, point: usize, along: Option<usize>) -> Triple {
        let body = &model.bodies[body];
        let centre = &self.points[body.centre];
        let velocity = along.map_or(centre.velocity, |at| centre.along[at]);
        let Some((frame, _)) = &body.rigid else { return velocity };
        let turning = along.map_or(self.frames[*frame].velocity, |at| self.frames[*frame].along[at]);
        let arm = self.space.sub(self.points[point].place, centre.place);
        self.space.add(velocity, self.space.cross(turning, arm))
    }
}

impl DrawnFrame {
    fn still(n: usize) -> Self {
        let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
        Self { axes, along: vec![[0; 3]; n], velocity: [0; 3], acceleration: [0; 3] }
    }

    /// Axes of a frame that is turned from this frame about one of its axes, given cosine and sine of the angle.
    fn about(&self, space: Space, axis: usize, [cos, sin]: [u64; 2]) -> [Triple; 3] {
        let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut axes = self.axes;
        axes[j] = space.add(space.scale(cos, self.axes[j]), space.scale(sin, self.axes[k]));
        axes[k] = space.sub(space.scale(cos, self.axes[k]), space.scale(sin, self.axes[j]));
        axes
    }

    /// A frame turned from this frame to these axes, given the components of the angular velocity that the turn adds.
    fn turned(&self, space: Space, axes: [Triple; 3], spins: &[(usize, FollowedResidues)]) -> Self {
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

impl DrawnPoint {
    fn still(n: usize) -> Self {
        Self { place: [0; 3], along: vec![[0; 3]; n], velocity: [0; 3], acceleration: [0; 3] }
    }

    /// A point placed from this point in a frame, given the components of its position.
    fn moved(&self, space: Space, frame: &DrawnFrame, place: &[FollowedResidues; 3]) -> Self {
        let of =
            |part: fn(&FollowedResidues) -> u64| space.along(&frame.axes, [0, 1, 2].map(|i: usize| part(&place[i])));
        let (arm, slip, second) = (of(|v| v.value), of(|v| v.rate), of(|v| v.second));
        let mut along: Vec<Triple> =
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
