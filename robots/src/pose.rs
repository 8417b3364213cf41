//! Poses of frames, and turns as sequences of angles about the axes 1, 2 and 3.

use nalgebra::{Matrix3, Quaternion, Rotation3, Unit, UnitQuaternion, Vector3};

/// Position and orientation of a frame in another frame.
#[derive(Clone, Debug)]
pub struct Pose {
    /// Position of the origin, m.
    pub position: Vector3<f64>,
    /// Rotation matrix; its columns are the axes of the frame in the other frame.
    pub rotation: Matrix3<f64>,
}

impl Default for Pose {
    fn default() -> Self {
        Self { position: Vector3::zeros(), rotation: Matrix3::identity() }
    }
}

impl Pose {
    /// Creates a pose without a turn.
    #[must_use]
    pub fn at(position: Vector3<f64>) -> Self {
        Self { position, ..Self::default() }
    }

    /// Pose in the outer frame of a frame that has the pose `inner` in this frame.
    #[must_use]
    pub fn compose(&self, inner: &Self) -> Self {
        Self { position: self.transform(&inner.position), rotation: self.rotation * inner.rotation }
    }

    /// Pose of the outer frame in this frame.
    #[must_use]
    pub fn inverse(&self) -> Self {
        let rotation = self.rotation.transpose();
        Self { position: -(rotation * self.position), rotation }
    }

    /// Position in the outer frame of a point given in this frame.
    #[must_use]
    pub fn transform(&self, point: &Vector3<f64>) -> Vector3<f64> {
        self.position + self.rotation * point
    }
}

/// Rotation matrix of a turn by `angle` (rad) about one of the axes 0, 1 and 2, exact for multiples of a right angle.
#[must_use]
pub fn axis_turn(axis: usize, angle: f64) -> Matrix3<f64> {
    let (sin, cos) = exact_sin_cos(angle);
    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut matrix = Matrix3::identity();
    matrix[(next, next)] = cos;
    matrix[(next, last)] = -sin;
    matrix[(last, next)] = sin;
    matrix[(last, last)] = cos;
    matrix
}

/// Sine and cosine of an angle, rad: exactly 0 and ±1 at multiples of a right angle.
fn exact_sin_cos(angle: f64) -> (f64, f64) {
    let quarters = angle / std::f64::consts::FRAC_PI_2;
    let whole = quarters.round();
    if (quarters - whole).abs() < 4e-16 * whole.abs().max(1.0) && whole.abs() < 1e6 {
        return match whole.rem_euclid(4.0) {
            0.0 => (0.0, 1.0),
            1.0 => (1.0, 0.0),
            2.0 => (0.0, -1.0),
            _ => (-1.0, 0.0),
        };
    }
    angle.sin_cos()
}

/// Rotation matrix of URDF's roll, pitch and yaw (rad): turns about the fixed axes 1, 2 and 3, in this order.
pub fn roll_pitch_yaw(angles: &Vector3<f64>) -> Matrix3<f64> {
    axis_turn(2, angles.z) * axis_turn(1, angles.y) * axis_turn(0, angles.x)
}

/// Rotation matrix of a turn by `angle` (rad) about `axis`, a vector of any length but zero.
pub fn turn_about(axis: &Vector3<f64>, angle: f64) -> Matrix3<f64> {
    let along: Vec<usize> = (0..3).filter(|k| axis[*k] != 0.0).collect();
    if let [only] = along[..] {
        return axis_turn(only, angle * axis[only].signum());
    }
    *Rotation3::from_axis_angle(&Unit::new_normalize(*axis), angle).matrix()
}

/// Rotation matrix of a quaternion (w, x, y, z) of any length but zero.
pub fn quaternion_turn(w: f64, x: f64, y: f64, z: f64) -> Matrix3<f64> {
    let matrix = *UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z)).to_rotation_matrix().matrix();
    // The entries of turns by right angles differ from 0 and ±1 by rounding alone.
    matrix.map(|entry| if (entry - entry.round()).abs() < 4e-16 { entry.round() } else { entry })
}

/// Angles (rad) about axes 3, 2 and 1, each of the turned frame, whose turns make a rotation matrix.
pub fn yaw_pitch_roll(rotation: &Matrix3<f64>) -> [f64; 3] {
    let (across, along) = (rotation[(0, 0)].hypot(rotation[(1, 0)]), -rotation[(2, 0)]);
    if across < 1e-15 {
        // Axis 1 is along axis 3 of the outer frame: one angle about it is enough.
        let roll = (-rotation[(1, 2)]).atan2(rotation[(1, 1)]);
        return [0.0, along.atan2(across), roll];
    }
    let yaw = rotation[(1, 0)].atan2(rotation[(0, 0)]);
    // Near a pitch of ±π/2, the yaw is uncertain. The roll of the matrix turned back by this yaw makes up for it.
    let (sine, cosine) = yaw.sin_cos();
    let turned_back = |column: usize| cosine * rotation[(1, column)] - sine * rotation[(0, column)];
    let roll = (-turned_back(2)).atan2(turned_back(1));
    [yaw, along.atan2(across), roll]
}

/// Signed permutation of a rotation matrix whose entries are 0 and ±1: for each axis of the turned frame, the index
/// of the outer axis along which it lies. `None` for other matrices.
pub fn axis_permutation(rotation: &Matrix3<f64>) -> Option<[usize; 3]> {
    let mut axes = [0; 3];
    for (column, axis) in axes.iter_mut().enumerate() {
        *axis = (0..3).find(|row| (rotation[(*row, column)].abs() - 1.0).abs() < 1e-14)?;
    }
    Some(axes)
}

/// Quaternion (w, x, y, z) of a rotation matrix, with w ≥ 0.
pub fn quaternion(rotation: &Matrix3<f64>) -> [f64; 4] {
    let found = UnitQuaternion::from_matrix(rotation);
    let sign = if found.w < 0.0 { -1.0 } else { 1.0 };
    [found.w, found.i, found.j, found.k].map(|part| if part == 0.0 { 0.0 } else { part * sign })
}

/// Smallest turn that brings axis 3 along a direction.
pub fn turn_to(direction: &Vector3<f64>) -> Matrix3<f64> {
    match Rotation3::rotation_between(&Vector3::z(), direction) {
        Some(rotation) => *rotation.matrix(),
        None => axis_turn(0, std::f64::consts::PI),
    }
}
