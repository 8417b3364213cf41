//! Arithmetic of vectors and rotations in three dimensions.

/// Vector with three components, in m or without unit.
pub type Triple = [f64; 3];

/// Rotation matrix by rows. Its product with components in one frame gives the components in another frame.
pub type Rotation = [Triple; 3];

/// Euler parameters of a rotation by the angle θ about a unit vector e: cos θ/2, followed by the three
/// components of e sin θ/2.
pub type Quaternion = [f64; 4];

/// Identity matrix: the rotation that changes nothing.
pub(crate) const IDENTITY: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Scalar product a · b.
pub(crate) fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Vector product a × b.
pub(crate) fn cross(a: Triple, b: Triple) -> Triple {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Vector difference a − b.
pub(crate) fn subtract_vectors(a: Triple, b: Triple) -> Triple {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Vector sum a + k b.
pub(crate) fn add_scaled_vector(a: Triple, k: f64, b: Triple) -> Triple {
    [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]]
}

/// Place on the straight line from a to b. It is a if `share` is 0, and b if `share` is 1.
pub(super) fn interpolate_place(a: Triple, b: Triple, share: f64) -> Triple {
    add_scaled_vector(a, share, subtract_vectors(b, a))
}

/// Length of a vector.
pub(crate) fn length(a: Triple) -> f64 {
    dot(a, a).sqrt()
}

/// Unit vector along a vector; `None` if the vector is zero or has a component that is not finite.
pub(crate) fn unit_vector(a: Triple) -> Option<Triple> {
    let size = length(a);
    (size > 0.0 && size.is_finite()).then(|| a.map(|x| x / size))
}

/// Product R v of a rotation matrix and a vector.
pub(crate) fn rotate_vector(r: &Rotation, v: Triple) -> Triple {
    [dot(r[0], v), dot(r[1], v), dot(r[2], v)]
}

/// Product Rᵀ v of the transpose of a rotation matrix and a vector: the inverse rotation.
pub(crate) fn rotate_vector_back(r: &Rotation, v: Triple) -> Triple {
    rotate_vector(&transpose(r), v)
}

/// Transpose of a matrix. For a rotation matrix it is the inverse.
pub(crate) fn transpose(r: &Rotation) -> Rotation {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| r[j][i]))
}

/// Product A B of two matrices.
pub(crate) fn product(a: &Rotation, b: &Rotation) -> Rotation {
    let columns = transpose(b);
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| dot(a[i], columns[j])))
}

/// Rotation matrix about a coordinate axis (0, 1 or 2) by an angle, rad. It converts components in the turned
/// frame to components in the original frame.
pub(crate) fn rotation_about_axis(axis: usize, angle: f64) -> Rotation {
    let (sin, cos) = angle.sin_cos();
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut r = IDENTITY;
    (r[j][j], r[j][k], r[k][j], r[k][k]) = (cos, -sin, sin, cos);
    r
}

/// Computes the Euler parameters of a rotation matrix. The first parameter is not negative.
///
/// The method divides by the largest of the four parameters. Source: S. W. Shepperd, Quaternion from
/// rotation matrix, *Journal of Guidance and Control* 1 (1978) 223-224.
#[must_use]
pub fn quaternion(r: &Rotation) -> Quaternion {
    let trace = r[0][0] + r[1][1] + r[2][2];
    let largest = [trace, r[0][0], r[1][1], r[2][2]];
    let which = (0..4).max_by(|a, b| largest[*a].total_cmp(&largest[*b])).unwrap_or(0);
    let mut q = [0.0; 4];
    if which == 0 {
        q = [1.0 + trace, r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]];
    } else {
        let i = which - 1;
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        q[0] = r[k][j] - r[j][k];
        q[1 + i] = 1.0 + 2.0 * r[i][i] - trace;
        q[1 + j] = r[j][i] + r[i][j];
        q[1 + k] = r[k][i] + r[i][k];
    }
    let size = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    let sign = if q[0] < 0.0 { -size } else { size };
    q.map(|x| x / sign)
}

/// Rotation matrix of the given Euler parameters, which have length 1; the first is cos θ/2.
pub(in crate::pictures) fn rotation_from_quaternion([w, x, y, z]: Quaternion) -> Rotation {
    let column = |v: Triple| {
        // v + 2 w (e × v) + 2 e × (e × v).
        let t = cross([x, y, z], v).map(|c| 2.0 * c);
        add_scaled_vector(add_scaled_vector(v, w, t), 1.0, cross([x, y, z], t))
    };
    transpose(&[column([1.0, 0.0, 0.0]), column([0.0, 1.0, 0.0]), column([0.0, 0.0, 1.0])])
}

/// Makes a rotation matrix whose third column is the unit vector `axis`.
pub(crate) fn rotation_to_axis(axis: Triple) -> Rotation {
    let least = (0..3).min_by(|a, b| axis[*a].abs().total_cmp(&axis[*b].abs())).unwrap_or(0);
    let first = unit_vector(cross(IDENTITY[least], axis)).unwrap_or(IDENTITY[0]);
    transpose(&[first, cross(axis, first), axis])
}

#[cfg(test)]
mod tests {
    use super::{product, quaternion, rotate_vector, rotation_about_axis};

    /// Goal: Euler parameters describe the same turn as their matrix, also beyond half a turn. Method: q v q* against R
    /// v, with R of three turns.
    #[test]
    fn euler_parameters_turn_as_their_rotation() {
        for step in 0..40 {
            let angle = f64::from(step) * 0.31 - 6.0;
            let r = product(
                &product(&rotation_about_axis(2, angle), &rotation_about_axis(0, 0.7 * angle + 1.0)),
                &rotation_about_axis(1, 2.0 - angle),
            );
            let [w, x, y, z] = quaternion(&r);
            let v = [0.3, -1.2, 0.8];
            let t = super::cross([x, y, z], v).map(|c| 2.0 * c);
            let turned = super::add_scaled_vector(super::add_scaled_vector(v, w, t), 1.0, super::cross([x, y, z], t));
            for (a, b) in turned.iter().zip(rotate_vector(&r, v)) {
                assert!((a - b).abs() < 1e-14 && w >= 0.0, "{step}: {a} {b}");
            }
        }
    }
}
