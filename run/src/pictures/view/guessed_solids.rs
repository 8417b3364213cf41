//! Solids that are guessed from bodies, points and joints, for models whose file states no shapes.
//!
//! Points that are fixed in a body are found numerically, in configurations far from one another.
//! The way in which the model file places a point does not matter: the point belongs to every body in
//! which it does not move. Rods join the points that are fixed in a body. The inertia decides between
//! disks and boxes. A body rolls at a point that moves around it at a constant distance.

use super::View;
use super::body_forms::{STRAIGHT, body_rods, homogeneous_form};
use super::evaluate_parameters_only;
use super::homogeneous_solids::{HomogeneousSolid, homogeneous_solid, principal_axes};
use super::pose::{Configuration, Pose, Poses};
use super::pose_extent;
use super::solid::{Solid, SolidForm, SolidPlace};
use super::space::{
    Rotation, Triple, add_scaled_vector, dot, length, product, quaternion, rotate_vector_back, rotation_to_axis,
    subtract_vectors, transpose,
};
use crate::error::Error;
use crate::mechanism::Mechanism;
use tripos_derive::model::{Body, ForcePlace as Of, ReactionKind};

/// Radius of a guessed rod, relative to the size of the mechanism.
const ROD: f64 = 0.016;
/// Distance up to which two positions count as equal, m, for mechanisms of about 1 m.
const SAME: f64 = 1e-9;
/// Greatest number of points whose paths are shown by default.
const MOST_TRACED: usize = 3;

/// Geometry of the bodies of a mechanism, found numerically from poses.
pub struct SolidGuess<'a> {
    mechanism: &'a Mechanism,
    /// Poses far from one another. The first pose is the start.
    poses: Vec<Pose>,
    /// Mass, homogeneous solid, fixed points and contact of each body.
    bodies: Vec<BodyGeometry>,
}

/// Mass, homogeneous solid, fixed points and contact of a body.
struct BodyGeometry {
    /// Mass of the body, kg.
    mass: f64,
    /// Homogeneous solid with the mass and inertia of the body, and its principal axes as columns in the body's
    /// frame. `None` for a particle, or if no such solid exists.
    like: Option<(HomogeneousSolid, Rotation)>,
    /// Indices of the points that are fixed in the body, other than its mass centre.
    attached: Vec<usize>,
    /// Contact of a rolling or sliding body with the ground; `None` if no point moves around the body.
    rim: Option<BodyContact>,
}

/// Contact of a rolling or sliding body with the ground.
#[derive(Clone, Copy)]
struct BodyContact {
    /// Index of the point at which the body touches the ground.
    point: usize,
    /// Distance of the contact from the axis of the body, or from the centre of a ball, m.
    radius: f64,
    /// Position of the contact along the body's axis, from the mass centre, m.
    beside: f64,
}

impl<'a> SolidGuess<'a> {
    /// Guesses the solids of a mechanism at the parameters of the configuration `at`. `moves` are the poses of
    /// its motion.
    ///
    /// # Errors
    /// `Error::Request` if a mass or an inertia cannot be evaluated.
    pub fn new(mechanism: &'a Mechanism, at: Configuration<'_>, poses: &Poses, moves: &[Pose]) -> Result<Self, Error> {
        let mut far: Vec<Pose> = moves.first().cloned().into_iter().collect();
        far.extend((0..4).map(|away| poses.pose_at(at.parameters, &distant_configuration(at.q, away))));
        let mut guess = Self { mechanism, poses: far, bodies: Vec::new() };
        for body in &mechanism.bodies {
            let known = guess.body_geometry(at.parameters, body)?;
            guess.bodies.push(known);
        }
        for at in 0..mechanism.bodies.len() {
            guess.remove_shared_axle_points(at);
        }
        for (at, body) in mechanism.bodies.iter().enumerate() {
            guess.bodies[at].rim = guess.find_body_contact(at, body);
        }
        Ok(guess)
    }

    /// Finds the mass, the homogeneous solid and the fixed points of a body.
    fn body_geometry(&self, parameters: &[f64], body: &Body) -> Result<BodyGeometry, Error> {
        let mass = evaluate_parameters_only(self.mechanism, parameters, &[body.mass], "a mass")?[0];
        let Some((frame, inertia)) = &body.rigid else {
            return Ok(BodyGeometry { mass, like: None, attached: Vec::new(), rim: None });
        };
        let terms: Vec<_> = inertia.tensor.iter().flatten().copied().collect();
        let flat = evaluate_parameters_only(self.mechanism, parameters, &terms, "an inertia")?;
        let tensor: Rotation = [0, 1, 2].map(|i| [0, 1, 2].map(|j| flat[3 * i + j]));
        let like = self.poses.first().and_then(|pose| {
            // `turn` converts components in the frame of the inertia to components in the frame of the body.
            let turn = product(&transpose(&pose.rotations[*frame]), &pose.rotations[inertia.frame]);
            let (moments, axes) = principal_axes(&product(&product(&turn, &tensor), &transpose(&turn)));
            Some((homogeneous_solid(mass, moments)?, axes))
        });
        let points = 0..self.mechanism.points.len();
        let attached = points.filter(|point| self.is_attached(*frame, body.centre, *point)).collect();
        Ok(BodyGeometry { mass, like, attached, rim: None })
    }

    /// Positions of a point from the mass centre of a body, in the body's frame, m: one for each pose.
    fn positions_in_body(&self, frame: usize, centre: usize, point: usize) -> impl Iterator<Item = Triple> + '_ {
        self.poses.iter().map(move |pose| {
            rotate_vector_back(&pose.rotations[frame], subtract_vectors(pose.points[point], pose.points[centre]))
        })
    }

    /// True if a point is fixed in a body, and is not at the mass centre of this body.
    fn is_attached(&self, frame: usize, centre: usize, point: usize) -> bool {
        let places: Vec<Triple> = self.positions_in_body(frame, centre, point).collect();
        let Some(first) = places.first() else { return false };
        let apart = length(*first);
        point != centre
            && apart > SAME
            && places.iter().all(|r| length(subtract_vectors(*r, *first)) <= SAME * (1.0 + apart))
    }

    /// Removes points that a body shares with a body from whose frame it is turned. The shared points lie on the
    /// common axle, and only the point closest to the mass centre is kept.
    fn remove_shared_axle_points(&mut self, at: usize) {
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
                let first = self.positions_in_body(own, self.mechanism.bodies[at].centre, *point).next();
                first.map_or(f64::MAX, length)
            };
            let shared = self.bodies[at].attached.iter().copied().filter(is_shared);
            let Some(nearest) = shared.min_by(|a, b| apart(a).total_cmp(&apart(b))) else { continue };
            let kept = self.bodies[at].attached.iter().copied().filter(|point| *point == nearest || !is_shared(point));
            self.bodies[at].attached = kept.collect();
            return;
        }
    }

    /// Finds the contact of a rolling or sliding body with the ground. It is a point at which a force acts, and
    /// which moves around the body at a constant distance and a constant height along the axis. `None` if
    /// there is no such point.
    fn find_body_contact(&self, at: usize, body: &Body) -> Option<BodyContact> {
        let (frame, _) = body.rigid.as_ref()?;
        let (like, axes) = self.bodies[at].like.as_ref()?;
        let axis = match like {
            HomogeneousSolid::Cylinder { axis, .. } => Some(transpose(axes)[*axis]),
            HomogeneousSolid::Sphere { .. } => None,
            HomogeneousSolid::Box { .. } => return None,
        };
        self.points_with_forces(at).into_iter().find_map(|point| {
            let places: Vec<Triple> = self.positions_in_body(*frame, body.centre, point).collect();
            let first = *places.first()?;
            let height = |r: &Triple| axis.map_or(0.0, |axis| dot(axis, *r));
            let keeps = |of: &dyn Fn(&Triple) -> f64| {
                places.iter().all(|r| (of(r) - of(&first)).abs() <= 1e-7 * (1.0 + length(first)))
            };
            let runs = places.iter().any(|r| length(subtract_vectors(*r, first)) > 1e-6 * length(first));
            let radius = (dot(first, first) - height(&first).powi(2)).max(0.0).sqrt();
            let is_rim = radius > SAME && runs && keeps(&|r| length(*r)) && keeps(&height);
            is_rim.then(|| BodyContact { point, radius, beside: height(&first) })
        })
    }

    /// Indices of the points at which forces or reactions act on the body with the index `body`.
    fn points_with_forces(&self, body: usize) -> Vec<usize> {
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

    /// Indices of the visible points: the points of the stated solids or, if no solids are stated, the points of
    /// bodies and springs.
    pub fn visible_points(&self, stated: &[Solid]) -> Vec<usize> {
        let mut list: Vec<usize> = if stated.is_empty() {
            let of_bodies = self.mechanism.bodies.iter().zip(&self.bodies).flat_map(|(body, known)| {
                known.attached.iter().copied().chain(known.rim.map(|rim| rim.point)).chain([body.centre])
            });
            let springs = self.mechanism.forces.iter().filter_map(|force| force.end);
            of_bodies.chain(springs).collect()
        } else {
            let drawn = stated.iter().filter(|solid| !matches!(solid.form, SolidForm::Ground { .. }));
            drawn.flat_map(|solid| solid.form.points()).collect()
        };
        list.sort_unstable();
        list.dedup();
        list
    }

    /// Greatest distance from the centre of a guessed solid to its surface, m.
    pub fn solids_reach(&self) -> f64 {
        self.guessed_solids(0.0).iter().map(|solid| solid.form.reach()).fold(0.0, f64::max)
    }

    /// Makes the guessed solids. `size` is the size of the mechanism, m.
    pub fn guessed_solids(&self, size: f64) -> Vec<Solid> {
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
                let form = SolidForm::Spring { ends: [force.on.point, end] };
                list.push(Solid { label: force.name.clone(), body: None, touches: None, form });
            }
        }
        list
    }

    /// Makes the forms of a particle: a ball, and a rod if the particle keeps its distance from the point from
    /// which it is placed.
    fn particle(&self, body: &Body, known: &BodyGeometry, size: f64) -> Vec<SolidForm> {
        let heaviest = self.bodies.iter().map(|known| known.mass).fold(0.0, f64::max);
        let share = if heaviest > 0.0 { (known.mass / heaviest).cbrt().clamp(0.5, 1.0) } else { 1.0 };
        let mut forms = vec![SolidForm::Sphere { at: SolidPlace::at(0, body.centre), radius: 0.055 * size * share }];
        let parent = self.mechanism.points[body.centre].position.map(|placement| placement.parent);
        let is_held = self.bodies.iter().any(|known| known.attached.contains(&body.centre));
        if let Some(parent) = parent.filter(|parent| !is_held && self.is_rigid(*parent, body.centre)) {
            forms.push(SolidForm::Rod { ends: [parent, body.centre], radius: 0.6 * ROD * size });
        }
        forms
    }

    /// True if two points keep a constant distance above zero while the line between them turns.
    fn is_rigid(&self, a: usize, b: usize) -> bool {
        let ways: Vec<Triple> =
            self.poses.iter().map(|pose| subtract_vectors(pose.points[b], pose.points[a])).collect();
        let Some(first) = ways.first() else { return false };
        let apart = length(*first);
        let turns = ways.iter().any(|way| length(subtract_vectors(*way, *first)) > 1e-6 * apart);
        apart > SAME && turns && ways.iter().all(|way| (length(*way) - apart).abs() <= SAME * (1.0 + apart))
    }

    /// Makes the forms of a rigid body: a wheel, a bar, rods between its fixed points, or the homogeneous solid with
    /// its
    /// inertia.
    fn body(&self, body: &Body, frame: usize, known: &BodyGeometry, size: f64) -> Vec<SolidForm> {
        let at = SolidPlace::at(frame, body.centre);
        let rod = ROD * size;
        if let Some(rim) = known.rim {
            return vec![wheel(at, known, rim)];
        }
        let places: Vec<Triple> = known
            .attached
            .iter()
            .filter_map(|point| self.positions_in_body(frame, body.centre, *point).next())
            .collect();
        if let Some((HomogeneousSolid::Cylinder { axis, radius, length: long }, axes)) = &known.like
            && *radius <= STRAIGHT * long
        {
            let line = transpose(axes)[*axis];
            let on_it = |r: &Triple| {
                let way = dot(*r, line);
                length(add_scaled_vector(*r, -way, line)) <= 0.02 * long && way.abs() <= 0.51 * long
            };
            // If the cylinder is much longer than the distance of its fixed points, the body is no rod. Its mass is
            // far from the mass centre.
            let ends = places.iter().map(|r| length(*r)).fold(0.0, f64::max);
            let is_as_long = places.is_empty() || *long <= 2.6 * ends;
            if is_as_long && places.iter().all(on_it) {
                let at = SolidPlace { turned: quaternion(&rotation_to_axis(line)), ..at };
                return vec![SolidForm::Cylinder { at, radius: radius.max(rod), length: *long }];
            }
        }
        let own = || known.like.as_ref().map(|(like, axes)| homogeneous_form(at, like, axes, rod));
        if places.is_empty() {
            return own().map_or_else(|| vec![SolidForm::Sphere { at, radius: 2.0 * rod }], |form| vec![form]);
        }
        let mut forms = body_rods(body.centre, &known.attached, &places, rod);
        let is_about_axle = known.like.as_ref().is_some_and(|(like, axes)| {
            let columns = transpose(axes);
            let lines = match like {
                HomogeneousSolid::Cylinder { axis, radius, length } if *radius > STRAIGHT * length => {
                    &columns[*axis..=*axis]
                }
                HomogeneousSolid::Sphere { .. } | HomogeneousSolid::Cylinder { .. } => &[][..],
                HomogeneousSolid::Box { .. } => &columns[..],
            };
            let off = |line: &Triple, r: &Triple| length(add_scaled_vector(*r, -dot(*r, *line), *line)) / length(*r);
            lines.iter().any(|line| places.iter().all(|r| off(line, r) <= 1e-6))
        });
        if is_about_axle {
            forms.extend(own());
        } else if known.attached.len() == 1 {
            forms.push(SolidForm::Sphere { at, radius: 2.2 * rod });
        }
        forms
    }

    /// Makes pins (balls) at the points where bodies meet one another or the ground.
    fn pins(&self, size: f64) -> Vec<Solid> {
        let mut list: Vec<usize> = Vec::new();
        for point in 0..self.mechanism.points.len() {
            let on = self.bodies.iter().filter(|known| known.attached.contains(&point)).count();
            let same = |other: &usize| {
                self.poses
                    .iter()
                    .all(|pose| length(subtract_vectors(pose.points[*other], pose.points[point])) <= SAME * size)
            };
            if (on > 1 || (on == 1 && self.is_fixed(point))) && !list.iter().any(same) {
                list.push(point);
            }
        }
        let ball = |point: usize| {
            let radius = if self.is_fixed(point) { 1.9 } else { 1.45 } * ROD * size;
            let form = SolidForm::Sphere { at: SolidPlace::at(0, point), radius };
            Solid { label: self.mechanism.points[point].name.clone(), body: None, touches: None, form }
        };
        list.into_iter().map(ball).collect()
    }

    /// True if no coordinate moves the point, so that it has the same place in all poses.
    fn is_fixed(&self, point: usize) -> bool {
        let first = self.poses.first().map(|pose| pose.points[point]);
        first.is_some_and(|first| {
            self.poses.iter().all(|pose| length(subtract_vectors(pose.points[point], first)) <= SAME)
        })
    }

    /// Guesses the ground plane. Bodies roll on it, or swing above it. `None` if there are no contacts and no
    /// gravity.
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
                pose_extent::evenly_spaced_poses(motion, 400).map(of).fold(f64::MAX, f64::min)
            };
            let low = motions.iter().map(lowest).fold(f64::MAX, f64::min);
            let gap = if flat.is_some() { 0.0 } else { 0.05 * view.size };
            if low < f64::MAX { low - gap } else { return None }
        } else {
            rims.iter().map(|place| dot(up, *place)).fold(f64::MAX, f64::min)
        };
        let turned = quaternion(&rotation_to_axis(up));
        let place = SolidPlace { position: up.map(|x| height * x), turned, ..SolidPlace::at(0, 0) };
        Some(Solid { label: "ground".to_owned(), body: None, touches: None, form: SolidForm::Ground { at: place } })
    }

    /// Indices of the points whose paths are shown. They are the points of contact, otherwise the moving
    /// particles, otherwise one mass centre.
    pub fn traced_points(&self) -> Vec<usize> {
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

    /// Axes to draw, one entry for each rigid body: the index of its frame and the index of its mass centre.
    pub fn body_axes(&self) -> Vec<(usize, usize)> {
        self.mechanism.bodies.iter().filter_map(|body| Some((body.rigid.as_ref()?.0, body.centre))).collect()
    }
}

/// Makes the form of a wheel or a ball. Its radius is the distance of its contact with the ground.
fn wheel(at: SolidPlace, known: &BodyGeometry, rim: BodyContact) -> SolidForm {
    match &known.like {
        Some((HomogeneousSolid::Cylinder { axis, .. }, axes)) => {
            let line = transpose(axes)[*axis];
            let position = line.map(|x| rim.beside * x);
            let at = SolidPlace { turned: quaternion(&rotation_to_axis(line)), position, ..at };
            SolidForm::Cylinder { at, radius: rim.radius, length: 0.05 * rim.radius }
        }
        _ => SolidForm::Sphere { at, radius: rim.radius },
    }
}

/// Makes coordinates far from the start, the same on every machine. Different numbers `at` give coordinates
/// far from one another.
fn distant_configuration(start: &[f64], at: usize) -> Vec<f64> {
    let step = |k: usize| ((k + 1) as f64 * 0.754_877_666 + (at + 1) as f64 * 0.569_840_291).fract();
    start.iter().enumerate().map(|(k, q)| q + 0.2 + 1.1 * step(k)).collect()
}
