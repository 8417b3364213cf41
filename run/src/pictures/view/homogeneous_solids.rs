//! Homogeneous solids that have a given mass and given principal moments of inertia.

use super::space::{IDENTITY, Rotation, Triple, product, transpose};

/// Computes the principal moments of a symmetric inertia tensor in ascending order, kg m², and its principal
/// axes as the columns of a rotation matrix.
///
/// The method is Jacobi's rotations. Source: G. H. Golub & C. F. Van Loan, *Matrix Computations*, 4th edition
/// (2013), § 8.5.
pub fn principal_axes(tensor: &Rotation) -> (Triple, Rotation) {
    let (mut a, mut axes) = (*tensor, IDENTITY);
    for _ in 0..30 {
        let pairs = [(0, 1), (0, 2), (1, 2)];
        let Some((p, q)) = pairs.into_iter().max_by(|x, y| a[x.0][x.1].abs().total_cmp(&a[y.0][y.1].abs())) else {
            break;
        };
        if a[p][q] == 0.0 {
            break;
        }
        let theta = 0.5 * (2.0 * a[p][q]).atan2(a[q][q] - a[p][p]);
        let (sin, cos) = theta.sin_cos();
        let mut turn = IDENTITY;
        (turn[p][p], turn[p][q], turn[q][p], turn[q][q]) = (cos, sin, -sin, cos);
        a = product(&product(&transpose(&turn), &a), &turn);
        axes = product(&axes, &turn);
    }
    let mut order = [0, 1, 2];
    order.sort_by(|x, y| a[*x][*x].total_cmp(&a[*y][*y]));
    let columns = transpose(&axes);
    let mut sorted = order.map(|at| columns[at]);
    // The third axis is reversed if needed, so that the axes are right-handed.
    if super::space::dot(super::space::cross(sorted[0], sorted[1]), sorted[2]) < 0.0 {
        sorted[2] = sorted[2].map(|x| -x);
    }
    (order.map(|at| a[at][at].max(0.0)), transpose(&sorted))
}

/// Homogeneous solid that has a given mass and given principal moments of inertia. Lengths are in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HomogeneousSolid {
    /// Homogeneous sphere, for three equal principal moments.
    Sphere {
        /// Radius of the sphere, m.
        radius: f64,
    },
    /// Cylinder about a principal axis, for two equal principal moments.
    Cylinder {
        /// Index of the principal axis along the cylinder, 0, 1 or 2.
        axis: usize,
        /// Radius of the cylinder, m.
        radius: f64,
        /// Length of the cylinder along its axis, m.
        length: f64,
    },
    /// Box along the principal axes, for three different principal moments.
    Box {
        /// Lengths of the box's edges along the three principal axes, m.
        size: Triple,
    },
}

/// Finds the homogeneous solid with a given mass, kg, and given principal moments in ascending order, kg m².
/// `None` for a body without mass or moments.
///
/// The moments are 2/5 m r² for a sphere. For a cylinder they are ½ m r² about its axis, and
/// m (3 r² + l²)/12 across it. They are m (b² + c²)/12 for a box.
pub fn homogeneous_solid(mass: f64, [a, b, c]: Triple) -> Option<HomogeneousSolid> {
    if !(mass > 0.0 && c > 0.0 && c.is_finite() && mass.is_finite()) {
        return None;
    }
    let alike = |x: f64, y: f64| (x - y).abs() <= 1e-6 * c;
    let cylinder = |axis: usize, about: f64, across: f64| {
        let radius = (2.0 * about / mass).sqrt();
        let length = (12.0 * across / mass - 3.0 * radius * radius).max(0.0).sqrt();
        HomogeneousSolid::Cylinder { axis, radius, length }
    };
    Some(match (alike(a, b), alike(b, c)) {
        (true, true) => HomogeneousSolid::Sphere { radius: (2.5 * c / mass).sqrt() },
        (true, false) => cylinder(2, c, a),
        (false, true) => cylinder(0, a, c),
        (false, false) => {
            let edge = |own: f64, other: f64, third: f64| (6.0 * (other + third - own).max(0.0) / mass).sqrt();
            HomogeneousSolid::Box { size: [edge(a, b, c), edge(b, c, a), edge(c, a, b)] }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::{HomogeneousSolid, homogeneous_solid, principal_axes};

    /// Goal: a body looks like the solid whose inertia it has. Method: moments of a rod, a disk, a ball and a box by
    /// their formulas.
    #[test]
    fn inertia_tells_rods_disks_balls_and_boxes() {
        let (m, l, r) = (2.0, 3.0, 0.5);
        let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
        let rod = homogeneous_solid(m, [0.0, m * l * l / 12.0, m * l * l / 12.0]);
        assert!(
            matches!(rod, Some(HomogeneousSolid::Cylinder { axis: 0, radius, length }) if radius == 0.0 && near(length, l)),
            "{rod:?}"
        );
        let disk = homogeneous_solid(m, [m * r * r / 4.0, m * r * r / 4.0, m * r * r / 2.0]);
        assert!(
            matches!(disk, Some(HomogeneousSolid::Cylinder { axis: 2, radius, length }) if near(radius, r) && length < 1e-7),
            "{disk:?}"
        );
        let ball = homogeneous_solid(m, [0.4 * m * r * r; 3]);
        assert!(matches!(ball, Some(HomogeneousSolid::Sphere { radius }) if near(radius, r)), "{ball:?}");
        let edges = [3.0_f64, 2.0, 1.0];
        let moment = |i: usize, j: usize| m * (edges[i] * edges[i] + edges[j] * edges[j]) / 12.0;
        let cuboid = homogeneous_solid(m, [moment(1, 2), moment(0, 2), moment(0, 1)]);
        assert!(
            matches!(cuboid, Some(HomogeneousSolid::Box { size }) if (0..3).all(|i| near(size[i], edges[i]))),
            "{cuboid:?}"
        );
        assert_eq!(homogeneous_solid(0.0, [1.0; 3]), None);
    }

    /// Goal: principal axes are found. Method: a tensor turned by a known rotation, whose axes come back.
    #[test]
    fn principal_axes_of_a_turned_tensor_come_back() {
        use crate::pictures::view::space::{product, rotation_about_axis, transpose};
        let turn = product(&rotation_about_axis(2, 0.6), &rotation_about_axis(0, -1.1));
        let tensor = product(&product(&turn, &[[1.0, 0.0, 0.0], [0.0, 2.5, 0.0], [0.0, 0.0, 3.0]]), &transpose(&turn));
        let (moments, axes) = principal_axes(&tensor);
        for (at, expected) in [1.0, 2.5, 3.0].into_iter().enumerate() {
            assert!((moments[at] - expected).abs() < 1e-12, "{moments:?}");
            let along: f64 = (0..3).map(|i| axes[i][at] * turn[i][at]).sum();
            assert!((along.abs() - 1.0).abs() < 1e-12, "axis {at}");
        }
    }
}
