//! Forms of the solids that represent a body.

use super::inertia::Homogeneous;
use super::solid::{Form, Place};
use super::space::{Rotation, Triple, along, dot, length, minus, plus, quaternion, transposed, unit};

/// Greatest distance of points from a line, relative to the length of the line, at which they count
/// as on one rod.
pub const STRAIGHT: f64 = 0.15;

/// Rods that join the points of a body: a single rod if all points lie on a line, else a rod from
/// the mass centre to each.
/// `centre` and `points` are indices of points. `places` are the points' positions from the mass
/// centre, m.
pub fn rods(centre: usize, points: &[usize], places: &[Triple], radius: f64) -> Vec<Form> {
    let all: Vec<(usize, Triple)> =
        points.iter().copied().zip(places.iter().copied()).chain([(centre, [0.0; 3])]).collect();
    let pairs = all.iter().enumerate().flat_map(|(i, a)| all[i + 1..].iter().map(move |b| (a, b)));
    let longest = pairs.max_by(|(a, b), (c, d)| length(minus(a.1, b.1)).total_cmp(&length(minus(c.1, d.1))));
    let Some((a, b)) = longest else { return Vec::new() };
    let way = minus(b.1, a.1);
    let off = |r: Triple| {
        let line = unit(way).unwrap_or_default();
        let from = minus(r, a.1);
        length(plus(from, -dot(from, line), line))
    };
    if all.iter().all(|(_, r)| off(*r) <= STRAIGHT * length(way)) {
        return vec![Form::Rod { ends: [a.0, b.0], radius }];
    }
    points.iter().map(|point| Form::Rod { ends: [centre, *point], radius }).collect()
}

/// Form of a homogeneous solid whose principal axes are the columns of `axes`; it is at least
/// `thin` (m) thick.
pub fn homogeneous_form(at: Place, like: &Homogeneous, axes: &Rotation, thin: f64) -> Form {
    match *like {
        Homogeneous::Sphere { radius } => Form::Sphere { at, radius },
        Homogeneous::Cylinder { axis, radius, length } => {
            let at = Place { turned: quaternion(&along(transposed(axes)[axis])), ..at };
            Form::Cylinder { at, radius: radius.max(thin), length: length.max(0.06 * radius) }
        }
        Homogeneous::Box { size } => {
            let most = size.iter().copied().fold(0.0, f64::max);
            Form::Box { at: Place { turned: quaternion(axes), ..at }, size: size.map(|edge| edge.max(0.03 * most)) }
        }
    }
}
