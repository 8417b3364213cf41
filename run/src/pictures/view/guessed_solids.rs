//! Solids guessed from bodies, points and joints, for models whose file gives no shapes.
//!
//! Points that are fixed in a body are found numerically, in configurations far from one another.
//! The way in which the model file places them does not matter: a point belongs to every body in
//! which it does not move. Rods join the points that are fixed in a body. The inertia decides
//! between disks and boxes. A body rolls at a point that moves round it at a constant distance.

use super::View;
use super::body_forms::{STRAIGHT, homogeneous_form, rods};
use super::inertia::{Homogeneous, homogeneous, principal};
use super::pose::{Configuration, Pose, Poses};
use super::solid::{Form, Place, Solid};
use super::space::{Rotation, Triple, along, dot, length, minus, plus, product, quaternion, rotated_back, transposed};
use super::swept;
use super::values;
use crate::error::Error;
use crate::mechanism::Mechanism;
use tripos_derive::model::{Body, Place as Of, ReactionKind};

/// Radius of a guessed rod, relative to the size of the mechanism.
const ROD: f64 = 0.016;
/// Tolerance up to which positions count as equal, m, for lengths of about 1 m.
const SAME: f64 = 1e-9;
/// Greatest number of points whose paths are shown by default.
const MOST_TRACED: usize = 3;

/// Geometry of a mechanism's bodies, found numerically from poses.
pub struct Guess<'a> {
    mechanism: &'a Mechanism,
    /// Poses far from one another; the first is the start.
    poses: Vec<Pose>,
    /// Mass, homogeneous solid, fixed points and contact of each body.
    bodies: Vec<Known>,
}

/// Mass, homogeneous solid, fixed points and contact of a body.
struct Known {
    /// Mass of the body, kg.
    mass: f64,
    /// Homogeneous solid with the body's mass and inertia, and its principal axes as columns in the
    /// body's frame.
    /// `None` for a particle, and if no such solid exists.
    like: Option<(Homogeneous, Rotation)>,
    /// Indices of the points that are fixed in the body, other than its mass centre.
    attached: Vec<usize>,
    /// Contact of a rolling or sliding body; `None` if no point runs round the body.
    rim: Option<Rim>,
}

/// Contact of a rolling or sliding body with the ground.
#[derive(Clone, Copy)]
struct Rim {
    /// Index of the point at which the body touches the ground.
    point: usize,
    /// Distance of the contact from the body's axis, or from its centre for a ball, m.
    radius: f64,
    /// Position of the contact along the body's axis, from the mass centre, m.
    beside: f64,
}

impl<'a> Guess<'a> {
    /// Guesses the solids of a mechanism at the parameters of the configuration `at`; `moves` are
    /// poses of its motion.
    ///
    /// # Errors
    /// `Error::Request` if a mass or an inertia cannot be evaluated.
    pub fn new(mechanism: &'a Mechanism, at: Configuration<'_>, poses: &Poses, moves: &[Pose]) -> Result<Self, Error> {
        let mut far: Vec<Pose> = moves.first().cloned().into_iter().collect();
        far.extend((0..4).map(|away| poses.of(at.parameters, &configuration(at.q, away))));
        let mut guess = Self { mechanism, poses: far, bodies: Vec::new() };
        for body in &mechanism.bodies {
            let known = guess.known(at.parameters, body)?;
            guess.bodies.push(known);
        }
        for at in 0..mechanism.bodies.len() {
            guess.leave_out_axle(at);
        }
        for (at, body) in mechanism.bodies.iter().enumerate() {
            guess.bodies[at].rim = guess.rim(at, body);
        }
        Ok(guess)
    }

    /// Finds the mass, the homogeneous solid and the fixed points of a body.
    fn known(&self, parameters: &[f64], body: &Body) -> Result<Known, Error> {
        let mass = values(self.mechanism, parameters, &[body.mass], "a mass")?[0];
        let Some((frame, inertia)) = &body.rigid else {
            return Ok(Known { mass, like: None, attached: Vec::new(), rim: None });
        };
        let terms: Vec<_> = inertia.tensor.iter().flatten().copied().collect();
        let flat = values(self.mechanism, parameters, &terms, "an inertia")?;
        let tensor: Rotation = [0, 1, 2].map(|i| [0, 1, 2].map(|j| flat[3 * i + j]));
        let like = self.poses.first().and_then(|pose| {
            // The product `turn` converts components in the inertia's frame to components in the
            // body's frame.
            let turn = product(&transposed(&pose.rotations[*frame]), &pose.rotations[inertia.frame]);
            let (moments, axes) = principal(&product(&product(&turn, &tensor), &transposed(&turn)));
            Some((homogeneous(mass, moments)?, axes))
        });
        let points = 0..self.mechanism.points.len();
        let attached = points.filter(|point| self.is_attached(*frame, body.centre, *point)).collect();
        Ok(Known { mass, like, attached, rim: None })
    }

    /// Positions of a point from a body's mass centre, in the body's frame, m, one for each pose.
    fn seen_from(&self, frame: usize, centre: usize, point: usize) -> impl Iterator<Item = Triple> + '_ {
        self.poses
            .iter()
            .map(move |pose| rotated_back(&pose.rotations[frame], minus(pose.points[point], pose.points[centre])))
    }

    /// True if a point is fixed in a body and does not coincide with its mass centre.
    fn is_attached(&self, frame: usize, centre: usize, point: usize) -> bool {
        let places: Vec<Triple> = self.seen_from(frame, centre, point).collect();
        let Some(first) = places.first() else { return false };
        let apart = length(*first);
        point != centre && apart > SAME && places.iter().all(|r| length(minus(*r, *first)) <= SAME * (1.0 + apart))
    }

    /// Removes points that a body shares with the body from which it is turned, except the nearest
    /// point.
    /// All of the shared points lie on the common axle.
    fn leave_out_axle(&mut self, at: usize) {
        let frame_of = |body: &Body| body.rigid.as_ref().map(|(frame, _)| *frame);
        let Some(own) = frame_of(&self.mechanism.bodies[at]) else { return };
        let before = |frame: usize| self.mechanism.frames[frame].rotation.as_ref().map(|(parent, _)| *parent);
        let above: Vec<usize> = std::iter::successors(before(own), |frame| before(*frame)).collect();
        for (body, known) in self.mechanism.bodies.iter().zip(&self.bodies) {
            if !frame_of(body).is_some_and(|frame| above.contains(&frame)) {
                continue;
            }
            let is_shared = |point: &usize| *point == body.centre || known.attached.contains(point);
            let apart = |point: &usize| {
                let first = self.seen_from(own, self.mechanism.bodies[at].centre, *point).next();
                first.map_or(f64::MAX, length)
            };
            let shared = self.bodies[at].attached.iter().copied().filter(is_shared);
            let Some(nearest) = shared.min_by(|a, b| apart(a).total_cmp(&apart(b))) else { continue };
            let kept = self.bodies[at].attached.iter().copied().filter(|point| *point == nearest || !is_shared(point));
            self.bodies[at].attached = kept.collect();
            return;
        }
    }

    /// Finds the contact of a rolling or sliding body: a point where a force acts and that runs
    /// round the body.
    /// The point keeps its distance and its height along the axis. `None` if there is no such
    /// point.
    fn rim(&self, at: usize, body: &Body) -> Option<Rim> {
        let (frame, _) = body.rigid.as_ref()?;
        let (like, axes) = self.bodies[at].like.as_ref()?;
        let axis = match like {
            Homogeneous::Cylinder { axis, .. } => Some(transposed(axes)[*axis]),
            Homogeneous::Sphere { .. } => None,
            Homogeneous::Box { .. } => return None,
        };
        self.touched(at).into_iter().find_map(|point| {
            let places: Vec<Triple> = self.seen_from(*frame, body.centre, point).collect();
            let first = *places.first()?;
            let height = |r: &Triple| axis.map_or(0.0, |axis| dot(axis, *r));
            let keeps = |of: &dyn Fn(&Triple) -> f64| {
                places.iter().all(|r| (of(r) - of(&first)).abs() <= 1e-7 * (1.0 + length(first)))
            };
            let runs = places.iter().any(|r| length(minus(*r, first)) > 1e-6 * length(first));
            let radius = (dot(first, first) - height(&first).powi(2)).max(0.0).sqrt();
            let is_rim = radius > SAME && runs && keeps(&|r| length(*r)) && keeps(&height);
            is_rim.then(|| Rim { point, radius, beside: height(&first) })
        })
    }

    /// Indices of the points at which forces and reactions act on the body with the index `body`.
    fn touched(&self, body: usize) -> Vec<usize> {
        let reactions = self.mechanism.reactions.iter().filter_map(|reaction| match reaction.kind {
            ReactionKind::Force { on, against } => Some([Some(on), against]),
            ReactionKind::Torque { .. } => None,
        });
        let forces = self.mechanism.forces.iter().map(|force| [Some(force.on), force.against]);
        let of = |place: Of| (place.body == body).then_some(place.point);
        let mut list: Vec<usize> = reactions.chain(forces).flatten().flatten().filter_map(of).collect();
        list.dedup();
        list
    }

    /// Indices of the visible points: those of the stated solids, or if none are stated, those of
    /// bodies and springs.
    pub fn seen(&self, stated: &[Solid]) -> Vec<usize> {
        let mut list: Vec<usize> = if stated.is_empty() {
            let of_bodies = self.mechanism.bodies.iter().zip(&self.bodies).flat_map(|(body, known)| {
                known.attached.iter().copied().chain(known.rim.map(|rim| rim.point)).chain([body.centre])
            });
            let springs = self.mechanism.forces.iter().filter_map(|force| force.end);
            of_bodies.chain(springs).collect()
        } else {
            let drawn = stated.iter().filter(|solid| !matches!(solid.form, Form::Ground { .. }));
            drawn.flat_map(|solid| solid.form.points()).collect()
        };
        list.sort_unstable();
        list.dedup();
        list
    }

    /// Greatest distance from the centre of a guessed solid to its surface, m.
    pub fn reach(&self) -> f64 {
        self.solids(0.0).iter().map(|solid| solid.form.reach()).fold(0.0, f64::max)
    }

    /// Makes the guessed solids; `size` is the size of the mechanism, m.
    pub fn solids(&self, size: f64) -> Vec<Solid> {
        let mut list = Vec::new();
        for (at, (body, known)) in self.mechanism.bodies.iter().zip(&self.bodies).enumerate() {
            let forms = match &body.rigid {
                None => self.particle(body, known, size),
                Some((frame, _)) => self.body(body, *frame, known, size),
            };
            let touches = known.rim.map(|rim| rim.point);
            list.extend(forms.into_iter().map(|form| Solid {
                label: body.name.clone(),
                body: Some(at),
                touches,
                form,
            }));
        }
        list.extend(self.pins(size));
        for force in &self.mechanism.forces {
            if let Some(end) = force.end {
                let form = Form::Spring { ends: [force.on.point, end] };
                list.push(Solid { label: force.name.clone(), body: None, touches: None, form });
            }
        }
        list
    }

    /// Forms of a particle: a ball, and a rod if the particle keeps its distance from the point
    /// that places it.
    fn particle(&self, body: &Body, known: &Known, size: f64) -> Vec<Form> {
        let heaviest = self.bodies.iter().map(|known| known.mass).fold(0.0, f64::max);
        let share = if heaviest > 0.0 { (known.mass / heaviest).cbrt().clamp(0.5, 1.0) } else { 1.0 };
        let mut forms = vec![Form::Sphere { at: Place::at(0, body.centre), radius: 0.055 * size * share }];
        let parent = self.mechanism.points[body.centre].position.map(|placement| placement.parent);
        let is_held = self.bodies.iter().any(|known| known.attached.contains(&body.centre));
        if let Some(parent) = parent.filter(|parent| !is_held && self.is_rigid(*parent, body.centre)) {
            forms.push(Form::Rod { ends: [parent, body.centre], radius: 0.6 * ROD * size });
        }
        forms
    }

    /// True if two points keep a constant non-zero distance while the line between them turns.
    fn is_rigid(&self, a: usize, b: usize) -> bool {
        let ways: Vec<Triple> = self.poses.iter().map(|pose| minus(pose.points[b], pose.points[a])).collect();
        let Some(first) = ways.first() else { return false };
        let apart = length(*first);
        let turns = ways.iter().any(|way| length(minus(*way, *first)) > 1e-6 * apart);
        apart > SAME && turns && ways.iter().all(|way| (length(*way) - apart).abs() <= SAME * (1.0 + apart))
    }

    /// Forms of a rigid body: a wheel, a bar, rods between its fixed points, or the homogeneous solid of its inertia.
    fn body(&self, body: &Body, frame: usize, known: &Known, size: f64) -> Vec<Form> {
        let at = Place::at(frame, body.centre);
        let rod = ROD * size;
        if let Some(rim) = known.rim {
            return vec![wheel(at, known, rim)];
        }
        let places: Vec<Triple> =
            known.attached.iter().filter_map(|point| self.seen_from(frame, body.centre, *point).next()).collect();
        if let Some((Homogeneous::Cylinder { axis, radius, length: long }, axes)) = &known.like
            && *radius <= STRAIGHT * long
        {
            let line = transposed(axes)[*axis];
            let on_it = |r: &Triple| {
                let way = dot(*r, line);
                length(plus(*r, -way, line)) <= 0.02 * long && way.abs() <= 0.51 * long
            };
            // If a cylinder is much longer than its fixed points suggest, the body is no rod: its
            // mass is far out.
            let ends = places.iter().map(|r| length(*r)).fold(0.0, f64::max);
            let is_as_long = places.is_empty() || *long <= 2.6 * ends;
            if is_as_long && places.iter().all(on_it) {
                let at = Place { turned: quaternion(&along(line)), ..at };
                return vec![Form::Cylinder { at, radius: radius.max(rod), length: *long }];
            }
        }
        let own = || known.like.as_ref().map(|(like, axes)| homogeneous_form(at, like, axes, rod));
        if places.is_empty() {
            return own().map_or_else(|| vec![Form::Sphere { at, radius: 2.0 * rod }], |form| vec![form]);
        }
        let mut forms = rods(body.centre, &known.attached, &places, rod);
        let is_about_axle = known.like.as_ref().is_some_and(|(like, axes)| {
            let columns = transposed(axes);
            let lines = match like {
                Homogeneous::Cylinder { axis, radius, length } if *radius > STRAIGHT * length => {
                    &columns[*axis..=*axis]
                }
                Homogeneous::Sphere { .. } | Homogeneous::Cylinder { .. } => &[][..],
                Homogeneous::Box { .. } => &columns[..],
            };
            let off = |line: &Triple, r: &Triple| length(plus(*r, -dot(*r, *line), *line)) / length(*r);
            lines.iter().any(|line| places.iter().all(|r| off(line, r) <= 1e-6))
        });
        if is_about_axle {
            forms.extend(own());
        } else if known.attached.len() == 1 {
            forms.push(Form::Sphere { at, radius: 2.2 * rod });
        }
        forms
    }

    /// Pins (balls) at the points where bodies meet one another or the ground.
    fn pins(&self, size: f64) -> Vec<Solid> {
        let mut list: Vec<usize> = Vec::new();
        for point in 0..self.mechanism.points.len() {
            let on = self.bodies.iter().filter(|known| known.attached.contains(&point)).count();
            let same = |other: &usize| {
                self.poses.iter().all(|pose| length(minus(pose.points[*other], pose.points[point])) <= SAME * size)
            };
            if (on > 1 || (on == 1 && self.is_fixed(point))) && !list.iter().any(same) {
                list.push(point);
            }
        }
        let ball = |point: usize| {
            let radius = if self.is_fixed(point) { 1.9 } else { 1.45 } * ROD * size;
            let form = Form::Sphere { at: Place::at(0, point), radius };
            Solid { label: self.mechanism.points[point].name.clone(), body: None, touches: None, form }
        };
        list.into_iter().map(ball).collect()
    }

    /// True if no coordinate moves the point: it has the same place in all poses.
    fn is_fixed(&self, point: usize) -> bool {
        let first = self.poses.first().map(|pose| pose.points[point]);
        first.is_some_and(|first| self.poses.iter().all(|pose| length(minus(pose.points[point], first)) <= SAME))
    }

    /// Guesses the ground plane: bodies roll on it, or swing above it. `None` without contacts and
    /// without gravity.
    pub fn ground(&self, view: &View, motions: &[&[Pose]]) -> Option<Solid> {
        let pose = motions.first()?.first()?;
        let rims: Vec<Triple> = self.bodies.iter().filter_map(|known| Some(pose.points[known.rim?.point])).collect();
        let flat = view.plane.filter(|normal| dot(*normal, view.up).abs() > 0.5);
        let up =
            flat.map_or(view.up, |normal| if dot(normal, view.up) < 0.0 { normal.map(|x| 0.0 - x) } else { normal });
        let height = if rims.is_empty() {
            self.mechanism.gravity.as_ref()?;
            let lowest = |motion: &&[Pose]| {
                let of = |pose: &Pose| {
                    let depth = |solid: &Solid| {
                        let low = solid.form.points().into_iter().map(|point| dot(up, pose.points[point]));
                        low.fold(f64::MAX, f64::min) - solid.form.reach()
                    };
                    view.solids.iter().map(depth).filter(|low| low.is_finite()).fold(f64::MAX, f64::min)
                };
                swept::spread(motion, 400).map(of).fold(f64::MAX, f64::min)
            };
            let low = motions.iter().map(lowest).fold(f64::MAX, f64::min);
            let gap = if flat.is_some() { 0.0 } else { 0.05 * view.size };
            if low < f64::MAX { low - gap } else { return None }
        } else {
            rims.iter().map(|place| dot(up, *place)).fold(f64::MAX, f64::min)
        };
        let turned = quaternion(&along(up));
        let place = Place { position: up.map(|x| height * x), turned, ..Place::at(0, 0) };
        Some(Solid { label: "ground".to_owned(), body: None, touches: None, form: Form::Ground { at: place } })
    }

    /// Indices of the points whose paths are shown: points of contact, else moving particles, else
    /// a single mass centre.
    pub fn traced(&self) -> Vec<usize> {
        let rims = self.bodies.iter().filter_map(|known| known.rim.map(|rim| rim.point));
        let of = |is_rigid: bool| {
            let list = self.mechanism.bodies.iter().filter(move |body| body.rigid.is_some() == is_rigid);
            list.map(|body| body.centre).filter(|point| !self.is_fixed(*point))
        };
        let mut list: Vec<usize> = rims.collect();
        if list.is_empty() {
            list = of(false).collect();
        }
        if list.is_empty() {
            list = of(true).next_back().into_iter().collect();
        }
        list.truncate(MOST_TRACED);
        list
    }

    /// Pairs (frame, mass centre) of indices, one for each rigid body.
    pub fn triads(&self) -> Vec<(usize, usize)> {
        self.mechanism.bodies.iter().filter_map(|body| Some((body.rigid.as_ref()?.0, body.centre))).collect()
    }
}

/// Form of a wheel or a ball whose radius is that of its contact.
fn wheel(at: Place, known: &Known, rim: Rim) -> Form {
    match &known.like {
        Some((Homogeneous::Cylinder { axis, .. }, axes)) => {
            let line = transposed(axes)[*axis];
            let position = line.map(|x| rim.beside * x);
            let at = Place { turned: quaternion(&along(line)), position, ..at };
            Form::Cylinder { at, radius: rim.radius, length: 0.05 * rim.radius }
        }
        _ => Form::Sphere { at, radius: rim.radius },
    }
}

/// Coordinates with the number `at`, far from the start and from coordinates with other numbers.
/// They use multiples of irrational numbers, so that they are the same on every machine.
fn configuration(start: &[f64], at: usize) -> Vec<f64> {
    let step = |k: usize| ((k + 1) as f64 * 0.754_877_666 + (at + 1) as f64 * 0.569_840_291).fract();
    start.iter().enumerate().map(|(k, q)| q + 0.2 + 1.1 * step(k)).collect()
}
