//! Actions of forces and torques in the Newton–Euler equations of bodies. They are evaluated in a random pose and
//! motion, as residues modulo a prime.
//!
//! Each body has six equations (balances). The first three are m a − ΣF, the last three dH/dt − ΣM about the mass
//! centre. Components are in the frame in which the body's inertia is given. The equations of a particle are in the
//! inertial frame, and its last three are 0.

use super::random_pose::{RandomModel, VectorResidues};
use crate::algebra::term::calculus::Substitution;
use crate::algebra::{Arena, Expr, Function, Node};
use crate::model::{Model, ReactionKind};

impl RandomModel {
    /// Residues of m a − ΣF and dH/dt − ΣM of all bodies, without the reactions. Each body has six, with components
    /// in the frame of its inertia. `None` if a term has no value in the random pose.
    pub fn newton_euler_balances(&self, model: &Model, arena: &mut Arena) -> Option<Vec<u64>> {
        let mut terms: Vec<Expr> = model.gravity.as_ref().map_or([Expr::ZERO; 3], |g| g.acceleration).to_vec();
        for body in &model.bodies {
            terms.push(body.mass);
            terms.extend(body.rigid.iter().flat_map(|(_, inertia)| inertia.tensor.iter().flatten().copied()));
        }
        terms.extend(model.added_masses.iter().flat_map(|added| added.tensor.as_flattened().iter().copied()));
        let loads = model.forces.iter().map(|f| f.vector).chain(model.torques.iter().map(|t| t.vector));
        terms.extend(loads.chain(model.efforts.iter().map(|e| e.vector)).flatten());
        let mut values = match self.values(model, arena, &terms) {
            Some(values) => values,
            None => {
                let named = replace_roots_in_actions(arena, &terms);
                self.values(model, arena, &named)?
            }
        };
        let RandomModel { space, frames, points, .. } = self;
        let (f, gravity) = (space.0, values.triple());
        let gravity = model.gravity.as_ref().map_or([0; 3], |g| space.along(&frames[g.frame].axes, gravity));
        let mut all = vec![0; 6 * model.bodies.len()];
        let mut loads = Vec::new();
        for (at, body) in model.bodies.iter().enumerate() {
            let mass = values.one();
            let force = space.scale(mass, space.sub(points[body.centre].acceleration, gravity));
            loads.push((at, body.centre, force, [0; 3]));
            let Some((own, inertia)) = &body.rigid else { continue };
            let tensor = [values.triple(), values.triple(), values.triple()];
            let (frame, turned) = (&frames[inertia.frame], &frames[*own]);
            let into = |v: VectorResidues| [0, 1, 2].map(|i: usize| space.dot(frame.axes[i], v));
            let times =
                |v: VectorResidues| space.along(&frame.axes, [0, 1, 2].map(|i: usize| space.dot(tensor[i], into(v))));
            // dH/dt = I (α − ω_F × ω) + ω_F × I ω, where F is a frame in which I is constant.
            let seen = space.sub(turned.acceleration, space.cross(frame.velocity, turned.velocity));
            let moment = space.add(times(seen), space.cross(frame.velocity, times(turned.velocity)));
            loads.push((at, body.centre, [0; 3], moment));
        }
        for added in &model.added_masses {
            let blocks: [VectorResidues; 12] = std::array::from_fn(|_| values.triple());
            let (force, moment) = self.added_mass_action(model, added.body, &blocks);
            loads.push((added.body, model.bodies[added.body].centre, force, moment));
        }
        let back = |v: VectorResidues| space.sub([0; 3], v);
        for force in &model.forces {
            let vector = space.along(&frames[force.frame].axes, values.triple());
            loads.push((force.on.body, force.on.point, back(vector), [0; 3]));
            loads.extend(force.against.map(|place| (place.body, place.point, vector, [0; 3])));
        }
        for torque in &model.torques {
            let vector = space.along(&frames[torque.frame].axes, values.triple());
            loads.extend(torque.on.1.map(|body| (body, model.bodies[body].centre, [0; 3], back(vector))));
            let against = torque.against.and_then(|(_, body)| body);
            loads.extend(against.map(|body| (body, model.bodies[body].centre, [0; 3], vector)));
        }
        for effort in &model.efforts {
            let action =
                self.reaction_action(model, effort.kind, space.along(&frames[effort.frame].axes, values.triple()));
            for (sum, x) in all.iter_mut().zip(action) {
                *sum = f.sub(*sum, x);
            }
        }
        for (body, point, force, moment) in loads {
            for (sum, x) in all.iter_mut().zip(self.action_on_body(model, body, point, force, moment)) {
                *sum = f.add(*sum, x);
            }
        }
        Some(all)
    }

    /// Rates dp/dt and dh/dt + v × p for the impulse (p, h) = M_A (v, ω) of the fluid that moves with a body.
    /// `blocks` are the rows of M_A, each as two halves of three.
    fn added_mass_action(
        &self,
        model: &Model,
        body: usize,
        blocks: &[VectorResidues; 12],
    ) -> (VectorResidues, VectorResidues) {
        let RandomModel { space, frames, points, .. } = self;
        let stated = &model.bodies[body];
        let (centre, frame) = (&points[stated.centre], &frames[stated.rigid.as_ref().map_or(0, |(own, _)| *own)]);
        let into = |v: VectorResidues| frame.axes.map(|axis| space.dot(axis, v));
        let times = |first: usize, v: VectorResidues, omega: VectorResidues| {
            let row = |i: usize| {
                let at = 2 * (first + i);
                space.0.add(space.dot(blocks[at], into(v)), space.dot(blocks[at + 1], into(omega)))
            };
            space.along(&frame.axes, [0, 1, 2].map(row))
        };
        // M_A is constant in the body's frame. Seen from that frame, the rate of v is a − ω × v.
        let (v, omega) = (centre.velocity, frame.velocity);
        let within = space.sub(centre.acceleration, space.cross(omega, v));
        let rate = |first: usize| {
            let carried = space.cross(omega, times(first, v, omega));
            space.add(times(first, within, frame.acceleration), carried)
        };
        (rate(0), space.add(rate(3), space.cross(v, times(0, v, omega))))
    }

    /// Contribution to the Newton–Euler equations of a force through a point of one body and of a moment on that
    /// body. The result has six residues for each body of the model.
    fn action_on_body(
        &self,
        model: &Model,
        body: usize,
        point: usize,
        force: VectorResidues,
        moment: VectorResidues,
    ) -> Vec<u64> {
        let RandomModel { space, frames, points, .. } = self;
        let mut all = vec![0; 6 * model.bodies.len()];
        let stated = &model.bodies[body];
        let axes = &frames[stated.rigid.as_ref().map_or(0, |(_, inertia)| inertia.frame)].axes;
        let arm = space.sub(points[point].place, points[stated.centre].place);
        let moment = space.add(moment, space.cross(arm, force));
        for (i, axis) in axes.iter().enumerate() {
            all[6 * body + i] = space.dot(*axis, force);
            if stated.rigid.is_some() {
                all[6 * body + 3 + i] = space.dot(*axis, moment);
            }
        }
        all
    }

    /// Contribution to the Newton–Euler equations of a reaction of size 1 along `direction`. The result has six
    /// residues for each body of the model.
    pub fn reaction_action(&self, model: &Model, kind: ReactionKind, direction: VectorResidues) -> Vec<u64> {
        let back = self.space.sub([0; 3], direction);
        let centre = |body: usize| model.bodies[body].centre;
        let (on, against) = match kind {
            ReactionKind::Force { on, against } => (
                self.action_on_body(model, on.body, on.point, direction, [0; 3]),
                against.map(|place| self.action_on_body(model, place.body, place.point, back, [0; 3])),
            ),
            ReactionKind::Torque { on, against } => (
                self.action_on_body(model, on, centre(on), [0; 3], direction),
                against.map(|body| self.action_on_body(model, body, centre(body), [0; 3], back)),
            ),
        };
        let Some(against) = against else { return on };
        on.iter().zip(against).map(|(a, b)| self.space.0.add(*a, b)).collect()
    }
}

/// Replaces each square root in the terms by a new symbol, since a residue need not have a square root modulo the
/// prime. The roots are then independent of all other parts of the equations.
fn replace_roots_in_actions(arena: &mut Arena, terms: &[Expr]) -> Vec<Expr> {
    let is_root = |part: &Expr| matches!(arena.node(*part), Node::Apply(Function::Sqrt, _));
    let roots: Vec<Expr> = arena.reachable(terms).into_iter().filter(is_root).collect();
    let named = |(at, root)| (root, arena.symbol(&format!("root {at}")));
    let pairs: Vec<(Expr, Expr)> = roots.into_iter().enumerate().map(named).collect();
    let mut put = Substitution::new(&pairs);
    terms.iter().map(|e| put.apply(arena, *e)).collect()
}
