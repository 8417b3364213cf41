//! Motion of a mechanism for a view: poses and forces at enough instants that no difference from the run is
//! visible.

use super::force_arrows::{ForceArrows, ForceFunctions};
use super::pose::{Pose, Poses};
use super::space::{Quaternion, Triple, interpolate_place, length, quaternion, subtract_vectors};
use crate::equations_name::{EquationsName, find_equations_or_first};
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::simulation::run::Run;
use crate::simulation::simulate::simulate;
use std::f64::consts::FRAC_PI_2;
use tripos_derive::scene::{Integrator, Scene};
use tripos_sim::Method;

/// Number of evenly spaced instants of a run for a view, before unneeded instants are left out.
const SAMPLES: usize = 6000;
/// Greatest number of samples from one kept instant to the next.
const LONGEST: usize = 60;
/// Greatest error of a position between two instants that cannot be seen, relative to the size of the
/// mechanism.
const UNSEEN_PLACE: f64 = 5e-4;
/// Greatest error of an orientation between two instants that cannot be seen, rad.
const UNSEEN_ANGLE: f64 = 4e-3;
/// Greatest error of a force between two instants that cannot be seen, relative to the usual force.
const UNSEEN_FORCE: f64 = 2e-2;
/// Angle between drawn and true orientation from which on a rotation looks wrong, rad.
const UNTRUE: f64 = 0.2;
/// Greatest angle between two orientations for which the shortest rotation is unique despite rounding
/// errors, rad.
const ONE_WAY: f64 = 3.0;

/// Motion of a mechanism for a view: poses and forces at a list of instants.
#[derive(Clone, Debug)]
pub struct ViewMotion {
    /// Title of the equations that were integrated, for a heading.
    pub title: String,
    /// Instants of the poses, s, in the order of the run.
    pub t: Vec<f64>,
    /// Pose of the mechanism at each instant of `t`.
    pub poses: Vec<Pose>,
    /// Forces on the bodies at each instant of `t`, N.
    pub forces: ForceArrows,
    /// Least and greatest value of each coordinate, followed by those of each generalized speed.
    pub ranges: Vec<(f64, f64)>,
    /// Sentence that says when, after how many steps and why the run ended.
    pub ending: String,
    /// Reasons not to trust the run to its end, one text for each; empty if the run can be trusted.
    pub objections: Vec<String>,
    /// True if the run stopped before its planned end because it could not go on.
    pub failed: bool,
}

impl ViewMotion {
    /// Runs a scene by full equations, and converts the run to a motion for a view. `by` names the equations;
    /// `None` takes the first formulation of the model.
    ///
    /// # Errors
    /// Errors of [`crate::simulate()`].
    pub fn of_scene(mechanism: &Mechanism, scene: &Scene, by: Option<&EquationsName>) -> Result<Self, Error> {
        let mut scene = scene.clone();
        let how = &mut scene.integration;
        how.samples = Some(SAMPLES);
        how.project = None;
        if how.method == Integrator::Quadrature {
            how.method = Method::Dop853.into();
        }
        let by = find_equations_or_first(mechanism, by)?;
        let run = simulate(mechanism, &scene, Some(&EquationsName::from(&by)))?;
        Self::of_run(mechanism, &scene, &run)
    }

    /// Converts a run to a motion for a view. The run must show all coordinates and speeds.
    ///
    /// # Errors
    /// [`Error::Request`] if the run does not show all coordinates and speeds.
    pub fn of_run(mechanism: &Mechanism, scene: &Scene, run: &Run) -> Result<Self, Error> {
        let poses = Poses::new(mechanism)?;
        let (n, names) = (mechanism.coordinates.len(), mechanism.coordinates.iter().map(|c| &c.name));
        if run.names.len() < n + mechanism.speeds.len() || names.zip(&run.names).any(|(own, shown)| own != shown) {
            let what = format!("a run by {} shows no poses", run.by.title());
            return Err(Error::request(what, "give full equations, such as --by kane".to_owned()));
        }
        let (mut t, mut states) = (run.solution.t.clone(), run.states.clone());
        // A run that ends early has no sample at its end.
        if t.last().is_none_or(|last| last.to_bits() != run.solution.t_end.to_bits()) {
            t.push(run.solution.t_end);
            states.push(run.end.clone());
        }
        let ranges = value_ranges(&states);
        let posed = states.iter().map(|state| poses.pose_at(&scene.parameters, &state[..n]));
        let somewhere = t.into_iter().zip(&states).zip(posed).filter(|(_, pose)| pose.is_finite());
        let (at, poses): (Vec<(f64, &Vec<f64>)>, Vec<Pose>) = somewhere.unzip();
        let full = n + mechanism.speeds.len();
        let seen: Vec<(&[f64], &Pose)> =
            at.iter().zip(&poses).map(|((_, state), pose)| (&state[..full], pose)).collect();
        let forces = ForceFunctions::new(mechanism, scene)?.forces_along_motion(mechanism, scene, &seen)?;
        let t = at.into_iter().map(|(t, _)| t).collect();
        let objections = run.objections();
        let failed = run.solution.stop.is_failure();
        Ok(Self { title: run.by.title(), t, poses, forces, ranges, ending: run.ending.clone(), objections, failed })
    }

    /// Thins the motion: keeps only instants between which linear interpolation looks right, and at most `most`
    /// of them. `size` is the size of the mechanism, m. The second value is the factor by which the tolerances
    /// were widened to reach this number. It is 1 if they were not widened.
    #[must_use]
    pub fn thin_motion(&self, size: f64, most: usize) -> (Self, f64) {
        let turns = self.poses.iter().map(|pose| pose.rotations.iter().map(quaternion).collect()).collect();
        let scale = MotionScale { turns, size };
        let mut looser = 1.0;
        let mut kept = self.kept_instants(&scale, looser);
        while kept.len() > most.max(2) && looser < 1e6 {
            looser *= 2.0;
            kept = self.kept_instants(&scale, looser);
        }
        // If there are still too many instants, only every n-th instant is kept.
        let step = kept.len().div_ceil(most.max(2)).max(1);
        let last = kept.last().copied();
        let kept: Vec<usize> = kept.into_iter().step_by(step).filter(|at| Some(*at) != last).chain(last).collect();
        let t = kept.iter().map(|at| self.t[*at]).collect();
        let poses = kept.iter().map(|at| self.poses[*at].clone()).collect();
        let forces = self.forces.at(&kept);
        (Self { t, poses, forces, ..self.clone() }, looser)
    }

    /// Indices of the kept instants, with the tolerances multiplied by `looser`. The next kept instant is the last
    /// one up to which linear interpolation is close to the motion at all instants between.
    fn kept_instants(&self, scale: &MotionScale, looser: f64) -> Vec<usize> {
        let last = self.t.len().saturating_sub(1);
        let mut kept: Vec<usize> = (!self.t.is_empty()).then_some(0).into_iter().collect();
        let mut from = 0;
        while from < last {
            let mut to = from + 1;
            while to < last && to - from < LONGEST && self.is_interpolated_well(scale, from, to + 1, looser) {
                to += 1;
            }
            kept.push(to);
            from = to;
        }
        kept
    }

    /// True if linear interpolation between two instants is close to the motion at all instants between. Points,
    /// orientations and forces are compared.
    fn is_interpolated_well(
        &self,
        MotionScale { turns, size }: &MotionScale,
        from: usize,
        to: usize,
        looser: f64,
    ) -> bool {
        let (a, b) = (&self.poses[from], &self.poses[to]);
        let span = self.t[to] - self.t[from];
        let has_one_way = turns[from].iter().zip(&turns[to]).all(|(a, b)| attitude_angle(*a, *b) <= ONE_WAY);
        has_one_way
            && (from + 1..to).all(|at| {
                let share = (self.t[at] - self.t[from]) / span;
                let pose = &self.poses[at];
                let points = a.points.iter().zip(&b.points).zip(&pose.points);
                let mut ways = points.map(|((a, b), x)| length(subtract_vectors(interpolate_place(*a, *b, share), *x)));
                let mut angles = turns[from]
                    .iter()
                    .zip(&turns[to])
                    .zip(&turns[at])
                    .map(|((a, b), x)| angle_from_interpolated_attitude(*a, *b, share, *x));
                let forces = &self.forces.values;
                let grown = forces[from].iter().zip(&forces[to]).zip(&forces[at]);
                let drawn = |force: &Triple| self.forces.drawn(*force);
                let mut off = grown.map(|((a, b), x)| {
                    length(subtract_vectors(interpolate_place(drawn(a), drawn(b), share), drawn(x)))
                });
                ways.all(|off| off <= looser * UNSEEN_PLACE * size)
                    && angles.all(|off| off <= looser * UNSEEN_ANGLE)
                    && !off.any(|off| off > looser * UNSEEN_FORCE * self.forces.usual)
            })
    }

    /// True if every frame rotates correctly in the motion `thin`, which has only some instants of this motion.
    ///
    /// Between two instants of this motion, no frame may rotate by more than a quarter turn. The orientations
    /// at left-out instants must be close to a uniform rotation between the kept instants.
    #[must_use]
    pub fn has_true_rotations(&self, thin: &Self) -> bool {
        let turns: Vec<Vec<Quaternion>> =
            self.poses.iter().map(|pose| pose.rotations.iter().map(quaternion).collect()).collect();
        let is_slow =
            |pair: &[Vec<Quaternion>]| pair[0].iter().zip(&pair[1]).all(|(a, b)| attitude_angle(*a, *b) <= FRAC_PI_2);
        let mut from = 0;
        turns.windows(2).all(is_slow)
            && thin.t.iter().skip(1).all(|t| {
                let to = (from + 1..self.t.len()).find(|at| self.t[*at].total_cmp(t).is_eq()).unwrap_or(from);
                let span = self.t[to] - self.t[from];
                let is_near = (from + 1..to).all(|at| {
                    let share = (self.t[at] - self.t[from]) / span;
                    let frames = turns[from].iter().zip(&turns[to]).zip(&turns[at]);
                    frames.into_iter().all(|((a, b), x)| angle_from_interpolated_attitude(*a, *b, share, *x) <= UNTRUE)
                });
                from = to;
                is_near
            })
    }
}

/// Scales for the comparison of motions: the orientations of the frames, and the size of the mechanism.
struct MotionScale {
    /// Orientation of each frame at each instant, as Euler parameters: one list for each instant.
    turns: Vec<Vec<Quaternion>>,
    /// Size of the mechanism, m. Errors of positions are relative to it.
    size: f64,
}

/// Least and greatest finite value of each component in a list of states.
fn value_ranges(states: &[Vec<f64>]) -> Vec<(f64, f64)> {
    let count = states.first().map_or(0, Vec::len);
    let of = |at: usize| {
        let values = states.iter().filter_map(|state| state.get(at).copied()).filter(|x| x.is_finite());
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)))
    };
    (0..count).map(of).collect()
}

/// Angle between two orientations, rad.
fn attitude_angle(a: Quaternion, b: Quaternion) -> f64 {
    let cos: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
    2.0 * cos.abs().min(1.0).acos()
}

/// Angle, rad, between the orientation x and an interpolated orientation. The latter is at the fraction `share`
/// (0 to 1) of the uniform rotation from a to b.
///
/// Source: K. Shoemake, Animating rotation with quaternion curves, *Computer Graphics* 19 (1985)
/// 245-254, § 3.3.
fn angle_from_interpolated_attitude(a: Quaternion, b: Quaternion, share: f64, x: Quaternion) -> f64 {
    let cos: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
    let b = if cos < 0.0 { b.map(|x| -x) } else { b };
    let whole = cos.abs().min(1.0).acos();
    let (from, to) = if whole < 1e-6 {
        (1.0 - share, share)
    } else {
        ((whole * (1.0 - share)).sin() / whole.sin(), (whole * share).sin() / whole.sin())
    };
    let way: Vec<f64> = a.iter().zip(b).map(|(a, b)| from * a + to * b).collect();
    attitude_angle([way[0], way[1], way[2], way[3]], x)
}
