//! Measures over many poses: the greatest distance between points, and the plane in which points stay.

use super::pose::Pose;
use super::space::{IDENTITY, Triple, length, subtract_vectors};

/// Greatest distance between two of the given points at one instant, m. At most 16 evenly spaced poses are
/// examined.
pub(super) fn diameter_over_poses(poses: &[Pose], points: &[usize]) -> f64 {
    let mut most: f64 = 0.0;
    for pose in evenly_spaced_poses(poses, 16) {
        for (at, a) in points.iter().enumerate() {
            for b in &points[at + 1..] {
                let apart = length(subtract_vectors(pose.points[*a], pose.points[*b]));
                most = if apart.is_finite() { most.max(apart) } else { most };
            }
        }
    }
    most
}

/// Selects at most `count` evenly spaced poses. The first pose is always selected.
pub(super) fn evenly_spaced_poses(poses: &[Pose], count: usize) -> impl Iterator<Item = &Pose> {
    poses.iter().step_by(poses.len().div_ceil(count).max(1))
}

/// Finds a coordinate plane of the inertial frame parallel to which all given points move, and returns its
/// unit normal. `None` if there is no such plane. `size` is the size of the mechanism, m.
pub(super) fn plane_of_motion(poses: &[Pose], points: &[usize], size: f64) -> Option<Triple> {
    let stays = |axis: usize| {
        let moves = |point: &usize| {
            let of = |pose: &Pose| pose.points[*point][axis];
            let (low, high) =
                poses.iter().map(of).fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
            high - low > 1e-6 * size
        };
        // Every frame must turn about the normal only, or keep its orientation.
        let turns = |frame: &usize| poses.iter().any(|pose| pose.rotations[*frame][axis][axis].abs() < 1.0 - 1e-6);
        let frames: Vec<usize> = (0..poses.first().map_or(0, |pose| pose.rotations.len())).collect();
        let still = frames.iter().filter(|frame| turns(frame)).all(|frame| keeps_attitude(poses, *frame));
        !points.iter().any(moves) && still
    };
    let axes: Vec<usize> = [2, 1, 0].into_iter().filter(|axis| stays(*axis)).collect();
    match axes.as_slice() {
        [] => None,
        [axis, ..] => Some(IDENTITY[*axis]),
    }
}

/// True if a frame keeps its orientation in all poses.
fn keeps_attitude(poses: &[Pose], frame: usize) -> bool {
    let Some(first) = poses.first() else { return true };
    let apart = |pose: &Pose| {
        let pairs = pose.rotations[frame].iter().flatten().zip(first.rotations[frame].iter().flatten());
        pairs.fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()))
    };
    poses.iter().all(|pose| apart(pose) < 1e-9)
}
