//! Positions and velocities that formulas of scenes name, such as `p(P) @ N [3]`, `v(wheel, P) @ N [1]`, `omega(B) @
//! N [3]` and `distance(P, Q)`.

use crate::algebra::term::calculus::Differential;
use crate::algebra::text::parse::{VelocityName, VelocityOf};
use crate::algebra::{Arena, Expr};
use crate::diagnostic::nearest_name_advice;
use crate::geometry::{Frames, Motion, Vector};
use crate::model::Model;

/// Positions and velocities of a model's points and frames. They are derived once a formula contains one of them.
#[derive(Default)]
pub(in crate::scene) struct Places(Option<(Frames, Motion)>);

impl Places {
    /// Component of the position or velocity with the given name, as a term in q and q̇. Returns a message if the
    /// model lacks a point, frame or body that the name contains.
    pub fn component(
        &mut self,
        model: &Model,
        arena: &mut Arena,
        name: &VelocityName<'_>,
    ) -> Result<Expr, UnknownNameMessage> {
        let (frames, motion) = self.0.get_or_insert_with(|| {
            let mut frames = Frames::new(&model.frames);
            let rates: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
            let mut rates = Differential::along(&rates);
            let motion = Motion::new(arena, &mut frames, &model.frames, &model.points, &mut rates);
            (frames, motion)
        });
        let point = |name: &str| index_of_position_name("point", model.points.iter().map(|p| p.name.as_str()), name);
        let frame_of = |name: &str| index_of_position_name("frame", model.frames.iter().map(|f| f.name.as_str()), name);
        let body = |name: &str| index_of_position_name("body", model.bodies.iter().map(|b| b.name.as_str()), name);
        let vector: Vector = match &name.of {
            VelocityOf::Place((name, _)) => motion.positions[point(name)?].clone(),
            VelocityOf::Point((name, _)) => motion.linear[point(name)?].clone(),
            VelocityOf::Material((name, _), (at, _)) => {
                let (body, at) = (&model.bodies[body(name)?], point(at)?);
                match &body.rigid {
                    Some((frame, _)) => motion.of_material(arena, frames, *frame, body.centre, at),
                    None if at != body.centre => {
                        let message =
                            format!("the particle `{}` is not at the point `{}`", body.name, model.points[at].name);
                        return Err((message, Some(format!("write v({})", model.points[at].name))));
                    }
                    None => motion.linear[body.centre].clone(),
                }
            }
            VelocityOf::Turning((name, _)) => {
                let of_body = body(name).ok().and_then(|at| model.bodies[at].rigid.as_ref());
                motion.angular[of_body.map_or_else(|| frame_of(name), |(frame, _)| Ok(*frame))?].clone()
            }
        };
        // The axes of `distance` are those of the inertial frame, which is the first frame.
        let frame = if name.frame.0.is_empty() { 0 } else { frame_of(name.frame.0)? };
        Ok(frames.component(arena, &vector, frame, name.axis))
    }
}

/// Message about an unknown name, and advice if there is any.
type UnknownNameMessage = (String, Option<String>);

/// Index of a name in a list of known names. Returns a message if the name is unknown; `what` is the kind of the name
/// in the message.
fn index_of_position_name<'n>(
    what: &str,
    mut known: impl Iterator<Item = &'n str> + Clone,
    name: &str,
) -> Result<usize, UnknownNameMessage> {
    let found = known.clone().position(|known| known == name);
    found.ok_or_else(|| (format!("the model has no {what} `{name}`"), Some(nearest_name_advice(name, known.by_ref()))))
}
