//! Mass properties of bodies: whether they are possible, and of bodies that are fixed to one another.

use crate::pose::Pose;
use crate::robot::Inertia;
use nalgebra::{Matrix3, Vector3};

/// Part of the largest moment below which a principal moment may miss zero or the triangle inequality, as rounding of
/// printed digits.
const ROUNDING: f64 = 1e-12;

impl Inertia {
    /// Mass properties of a body in the axes in which the body has the pose `pose`.
    #[must_use]
    pub fn moved(&self, pose: &Pose) -> Self {
        Self {
            mass: self.mass,
            centre: pose.transform(&self.centre),
            tensor: symmetric(&(pose.rotation * self.tensor * pose.rotation.transpose())),
        }
    }

    /// Mass properties of two bodies that are fixed to one another, both in the same axes.
    #[must_use]
    pub fn joined(&self, other: &Self) -> Self {
        let mass = self.mass + other.mass;
        if mass <= 0.0 {
            return Self { mass, centre: self.centre, tensor: self.tensor + other.tensor };
        }
        let centre = (self.centre * self.mass + other.centre * other.mass) / mass;
        let about_centre = |one: &Self| one.tensor + steiner(one.mass, &(one.centre - centre));
        Self { mass, centre, tensor: about_centre(self) + about_centre(other) }
    }

    /// Reason why no body has this inertia; `None` if one can have it.
    #[must_use]
    pub fn impossibility(&self) -> Option<String> {
        if self.mass < 0.0 {
            return Some(format!("the mass {} is negative", self.mass));
        }
        let mut moments: Vec<f64> = self.tensor.symmetric_eigenvalues().iter().copied().collect();
        moments.sort_by(f64::total_cmp);
        let [small, middle, large] = moments[..] else { return None };
        let slack = ROUNDING * large.abs().max(small.abs());
        if small < -slack {
            return Some(format!("the principal moment of inertia {small:.6} is negative"));
        }
        (large > small + middle + slack).then(|| {
            format!("the largest principal moment {large:.6e} exceeds the sum of the others, {:.6e}", small + middle)
        })
    }
}

/// Inertia of a point mass at `place` about the origin, kg m².
fn steiner(mass: f64, place: &Vector3<f64>) -> Matrix3<f64> {
    (Matrix3::identity() * place.norm_squared() - place * place.transpose()) * mass
}

/// Matrix with the means of its off-diagonal pairs.
fn symmetric(matrix: &Matrix3<f64>) -> Matrix3<f64> {
    (matrix + matrix.transpose()) / 2.0
}
