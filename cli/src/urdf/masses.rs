//! Masses and inertias of links.

use super::builder::LinkBuilder;
use super::refusals::place_of;
use super::tree::NodeMotion;
use nalgebra::{Matrix3, Vector3};
use tripos_derive::diagnostic::Diagnostic;
use tripos_robots::{Inertia, Pose};

impl LinkBuilder<'_> {
    /// Mass and inertia tensor of each body about its mass centre, in the axes of the body. `Err` with an error for
    /// each body whose mass or inertia is no number.
    pub(super) fn inertias(&self) -> Result<Vec<(f64, Matrix3<f64>)>, Vec<Diagnostic>> {
        let mut errors = Vec::new();
        let mut list = Vec::new();
        for body in &self.model.bodies {
            let tensor = body.rigid.as_ref().map_or(Some(Matrix3::zeros()), |(frame, inertia)| {
                let [first, second, third] = &inertia.tensor;
                let rows = [first, second, third].map(|row| self.numbers.constants(row));
                let [Some(first), Some(second), Some(third)] = rows else { return None };
                let tensor = Matrix3::from_rows(&[first, second, third].map(|row| Vector3::from(row).transpose()));
                if *frame == inertia.frame {
                    return Some(tensor);
                }
                // The tensor is constant as seen from the body, so that one pose tells it for all.
                let rotation = self.places.rotation_between(*frame, inertia.frame);
                Some(rotation * tensor * rotation.transpose())
            });
            match self.numbers.constant(body.mass).zip(tensor) {
                Some(found) => list.push(found),
                None => errors.push(Diagnostic::new(
                    place_of(self.model, &body.name),
                    format!("the mass or the inertia of `{}` is no number at the default values", body.name),
                    "give values for which both are numbers",
                )),
            }
        }
        if errors.is_empty() { Ok(list) } else { Err(errors) }
    }

    /// Mass properties of a body in the axes of its link, which have the pose `link` on the node of the body. `None`
    /// for a body without mass and inertia.
    pub(super) fn inertia_on(&self, body: usize, (mass, tensor): &(f64, Matrix3<f64>), link: &Pose) -> Option<Inertia> {
        let centre = link.inverse().transform(&self.centres[body].position);
        if *mass == 0.0 && tensor.amax() == 0.0 {
            return None;
        }
        let own = self.possible(body, Inertia { mass: *mass, centre, tensor: *tensor });
        let frame = self.model.bodies[body].rigid.as_ref().map(|(frame, _)| *frame);
        let rotation = frame.map_or_else(Matrix3::identity, |frame| self.places.frames[frame].in_group);
        if rotation == link.rotation || frame.is_none() {
            return Some(own);
        }
        let turned = own.moved(&Pose { position: Vector3::zeros(), rotation: link.rotation.transpose() * rotation });
        Some(Inertia { centre, ..turned })
    }

    /// Mass properties with all three moments. If the model states one moment alone, since the body turns about one
    /// axis, the other moments become those of a flat disk. They have no effect.
    fn possible(&self, body: usize, own: Inertia) -> Inertia {
        let only = (0..3).find(|axis| {
            let others = (0..3).flat_map(|row| (0..3).map(move |column| (row, column)));
            others.filter(|at| *at != (*axis, *axis)).all(|at| own.tensor[at] == 0.0)
        });
        let Some(axis) = only.filter(|axis| self.turns_about(body, *axis)) else { return own };
        let moment = own.tensor[(axis, axis)];
        let mut tensor = Matrix3::from_diagonal_element(moment / 2.0);
        tensor[(axis, axis)] = moment;
        Inertia { tensor, ..own }
    }

    /// True if a body turns about no axis but one of its own.
    fn turns_about(&self, body: usize, axis: usize) -> bool {
        let Some((frame, _)) = self.model.bodies[body].rigid else { return false };
        let mut at = self.centres[body].node;
        while at != 0 {
            let node = &self.tree.nodes[at];
            match node.motion {
                NodeMotion::Turn { axis: other, .. } | NodeMotion::Planar { axis: other, .. } => {
                    let direction = self.places.rotation_between(frame, node.group) * Vector3::ith(other, 1.0);
                    if (direction.abs() - Vector3::ith(axis, 1.0)).norm() > 1e-12 {
                        return false;
                    }
                }
                NodeMotion::Slide { .. } | NodeMotion::Ground => {}
                NodeMotion::Free(_) | NodeMotion::EulerParameters(_) => return false,
            }
            at = node.carrier;
        }
        true
    }
}
