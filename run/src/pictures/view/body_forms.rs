//! Shapes of the solids that represent a body.

use super::homogeneous_solids::HomogeneousSolid;
use super::solid::{SolidForm, SolidPlace};
use super::space::{
    Rotation, Triple, add_scaled_vector, dot, length, quaternion, rotation_to_axis, subtract_vectors, transpose,
    unit_vector,
};

/// Greatest distance of points from a line at which they count as on one rod, relative to the length of the
/// line.
pub const STRAIGHT: f64 = 0.15;

/// Makes rods that join the points of a body. If all points are close to one line, it is one rod. Otherwise
/// a rod leads from the mass centre to each point. `centre` and `points` are indices of points. `places`
/// are the positions of the points from the mass centre, m.
pub fn body_rods(centre: usize, points: &[usize], places: &[Triple], radius: f64) -> Vec<SolidForm> {
    let all: Vec<(usize, Triple)> =
        points.iter().copied().zip(places.iter().copied()).chain([(centre, [0.0; 3])]).collect();
    let pairs = all.iter().enumerate().flat_map(|(i, a)| all[i + 1..].iter().map(move |b| (a, b)));
    let longest = pairs
        .max_by(|(a, b), (c, d)| length(subtract_vectors(a.1, b.1)).total_cmp(&length(subtract_vectors(c.1, d.1))));
    let Some((a, b)) = longest else { return Vec::new() };
    let way = subtract_vectors(b.1, a.1);
    let off = |r: Triple| {
        let line = unit_vector(way).unwrap_or_default();
        let from = subtract_vectors(r, a.1);
        length(add_scaled_vector(from, -dot(from, line), line))
    };
    if all.iter().all(|(_, r)| off(*r) <= STRAIGHT * length(way)) {
        return vec![SolidForm::Rod { ends: [a.0, b.0], radius }];
    }
    points.iter().map(|point| SolidForm::Rod { ends: [centre, *point], radius }).collect()
}

/// Makes the form of a homogeneous solid. Its principal axes are the columns of `axes`. Very thin solids are
/// drawn thicker; `thin` is the least radius of a cylinder, m.
pub fn homogeneous_form(at: SolidPlace, like: &HomogeneousSolid, axes: &Rotation, thin: f64) -> SolidForm {
    match *like {
        HomogeneousSolid::Sphere { radius } => SolidForm::Sphere { at, radius },
        HomogeneousSolid::Cylinder { axis, radius, length } => {
            let at = SolidPlace { turned: quaternion(&rotation_to_axis(transpose(axes)[axis])), ..at };
            SolidForm::Cylinder { at, radius: radius.max(thin), length: length.max(0.06 * radius) }
        }
        HomogeneousSolid::Box { size } => {
            let most = size.iter().copied().fold(0.0, f64::max);
            SolidForm::Box {
                at: SolidPlace { turned: quaternion(axes), ..at },
                size: size.map(|edge| edge.max(0.03 * most)),
            }
        }
    }
}
