//! A motion as it is seen: poses at some instants, as many as it takes to see no difference.

use super::arrows::{Arrows, Forces};
use super::pose::{Pose, Poses};
use super::space::{Quaternion, Triple, length, minus, plus, quaternion};
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::run::Run;
use crate::simulate::simulate;
use std::f64::consts::FRAC_PI_2;
use tripos_derive::scene::{QUADRATURE, Scene};
use tripos_sim::Method;

/// Instants of a run for a view, evenly spaced, before those that nobody misses are left out.
const SAMPLES: usize = 6000;
/// Samples from one to the next that is kept, at most.
const LONGEST: usize = 60;
/// How far what is seen between two instants may be from where it is: of the size of the mechanism, in rad, and of the usual force.
const NOT_SEEN: (f64, f64, f64) = (5e-4, 4e-3, 2e-2);
/// An angle from where a frame is drawn to where it is that is seen as another turning, rad.
const UNTRUE: f64 = 0.2;
/// Turns up to which there is one shortest way from an attitude to another, in rounded numbers too, rad.
const ONE_WAY: f64 = 3.0;

/// What is seen of a run.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Which equations ran, as in a heading.
    pub title: String,
    /// The instants, s, in the order of the run.
    pub t: Vec<f64>,
    /// Where everything is at each.
    pub poses: Vec<Pose>,
    /// The forces at each.
    pub forces: Forces,
    /// The least and the largest that each coordinate and each generalized speed was, as they are shown.
    pub ranges: Vec<(f64, f64)>,
    /// When, after how many steps and why it ended, in a sentence.
    pub ending: String,
    /// Why it must not be trusted to its end, a reason a line; nothing if it can be.
    pub objections: Vec<String>,
    /// Whether it could not go on to its end.
    pub failed: bool,
}

impl Motion {
    /// Runs a scene by whole equations, the first formulation that the model has if none is named.
    ///
    /// # Errors
    /// As [`crate::simulate()`].
    pub fn of_scene(mechanism: &Mechanism, scene: &Scene, by: Option<&str>) -> Result<Self, Error> {
        let mut scene = scene.clone();
        let how = &mut scene.integration;
        how.samples = Some(SAMPLES);
        how.project = None;
        if how.method == QUADRATURE {
            Method::Dop853.name().clone_into(&mut how.method);
        }
        let by = crate::code::by_or_first(mechanism, by)?;
        let run = simulate(mechanism, &scene, Some(&by.name()))?;
        Self::of_run(mechanism, &scene, &run)
    }

    /// What is seen of a run that shows every state.
    ///
    /// # Errors
    /// [`Error::Request`] if the run does not show every state.
    pub fn of_run(mechanism: &Mechanism, scene: &Scene, run: &Run) -> Result<Self, Error> {
        let poses = Poses::new(mechanism)?;
        let (n, names) = (mechanism.coordinates.len(), mechanism.coordinates.iter().map(|c| &c.name));
        if run.names.len() < n + mechanism.speeds.len() || names.zip(&run.names).any(|(own, shown)| own != shown) {
            let what = format!("a run by {} shows no poses", run.by.title());
            return Err(Error::request(what, "give whole equations, such as --by kane".to_owned()));
        }
        let (mut t, mut states) = (run.solution.t.clone(), run.states.clone());
        // Where a run ends early its end is no sample.
        if t.last().is_none_or(|last| last.to_bits() != run.solution.t_end.to_bits()) {
            t.push(run.solution.t_end);
            states.push(run.end.clone());
        }
        let ranges = ranges(&states);
        let posed = states.iter().map(|state| poses.of(&scene.parameters, &state[..n]));
        let somewhere = t.into_iter().zip(&states).zip(posed).filter(|(_, pose)| is_somewhere(pose));
        let (at, poses): (Vec<(f64, &Vec<f64>)>, Vec<Pose>) = somewhere.unzip();
        let full = n + mechanism.speeds.len();
        let seen: Vec<(&[f64], &Pose)> =
            at.iter().zip(&poses).map(|((_, state), pose)| (&state[..full], pose)).collect();
        let forces = Arrows::new(mechanism, scene)?.along(mechanism, scene, &seen)?;
        let t = at.into_iter().map(|(t, _)| t).collect();
        let objections = run.objections();
        let failed = run.solution.stop.is_failure();
        Ok(Self { title: run.by.title(), t, poses, forces, ranges, ending: run.ending.clone(), objections, failed })
    }

    /// Only those instants between which nobody sees a difference to straight ways and even turns, of a mechanism of this size, and
    /// at most so many; with how many times more than that differs where there would be more.
    #[must_use]
    pub fn thinned(&self, size: f64, most: usize) -> (Self, f64) {
        let turns = self.poses.iter().map(|pose| pose.rotations.iter().map(quaternion).collect()).collect();
        let scale = Scale { turns, size };
        let mut looser = 1.0;
        let mut kept = self.kept(&scale, looser);
        while kept.len() > most.max(2) && looser < 1e6 {
            looser *= 2.0;
            kept = self.kept(&scale, looser);
        }
        // What even that does not make few enough is thinned evenly.
        let step = kept.len().div_ceil(most.max(2)).max(1);
        let last = kept.last().copied();
        let kept: Vec<usize> = kept.into_iter().step_by(step).filter(|at| Some(*at) != last).chain(last).collect();
        let t = kept.iter().map(|at| self.t[*at]).collect();
        let poses = kept.iter().map(|at| self.poses[*at].clone()).collect();
        let forces = self.forces.at(&kept);
        (Self { t, poses, forces, ..self.clone() }, looser)
    }

    /// The instants that are kept: from each as far as all between stay near.
    fn kept(&self, scale: &Scale, looser: f64) -> Vec<usize> {
        let last = self.t.len().saturating_sub(1);
        let mut kept: Vec<usize> = (!self.t.is_empty()).then_some(0).into_iter().collect();
        let mut from = 0;
        while from < last {
            let mut to = from + 1;
            while to < last && to - from < LONGEST && self.is_near(scale, (from, to + 1), looser) {
                to += 1;
            }
            kept.push(to);
            from = to;
        }
        kept
    }

    /// Whether everything between two instants is where straight ways and even turns lead, and forces grow evenly.
    fn is_near(&self, Scale { turns, size }: &Scale, (from, to): (usize, usize), looser: f64) -> bool {
        let (a, b) = (&self.poses[from], &self.poses[to]);
        let span = self.t[to] - self.t[from];
        let has_one_way = turns[from].iter().zip(&turns[to]).all(|(a, b)| angle(*a, *b) <= ONE_WAY);
        has_one_way
            && (from + 1..to).all(|at| {
                let share = (self.t[at] - self.t[from]) / span;
                let pose = &self.poses[at];
                let points = a.points.iter().zip(&b.points).zip(&pose.points);
                let mut ways = points.map(|((a, b), x)| length(minus(between(*a, *b, share), *x)));
                let mut angles =
                    turns[from].iter().zip(&turns[to]).zip(&turns[at]).map(|((a, b), x)| apart(*a, *b, share, *x));
                let forces = &self.forces.values;
                let grown = forces[from].iter().zip(&forces[to]).zip(&forces[at]);
                let drawn = |force: &Triple| self.forces.drawn(*force);
                let mut off = grown.map(|((a, b), x)| length(minus(between(drawn(a), drawn(b), share), drawn(x))));
                ways.all(|off| off <= looser * NOT_SEEN.0 * size)
                    && angles.all(|off| off <= looser * NOT_SEEN.1)
                    && !off.any(|off| off > looser * NOT_SEEN.2 * self.forces.usual)
            })
    }

    /// Whether the turning of every frame is seen truly in this motion with only some of its instants: the motion itself turns no frame by more than
    /// a quarter from one instant to the next, and what was left out is near the even turns between those that stay.
    #[must_use]
    pub fn turns_truly(&self, thin: &Self) -> bool {
        let turns: Vec<Vec<Quaternion>> =
            self.poses.iter().map(|pose| pose.rotations.iter().map(quaternion).collect()).collect();
        let is_slow = |pair: &[Vec<Quaternion>]| pair[0].iter().zip(&pair[1]).all(|(a, b)| angle(*a, *b) <= FRAC_PI_2);
        let mut from = 0;
        turns.windows(2).all(is_slow)
            && thin.t.iter().skip(1).all(|t| {
                let to = (from + 1..self.t.len()).find(|at| self.t[*at].total_cmp(t).is_eq()).unwrap_or(from);
                let span = self.t[to] - self.t[from];
                let is_near = (from + 1..to).all(|at| {
                    let share = (self.t[at] - self.t[from]) / span;
                    let frames = turns[from].iter().zip(&turns[to]).zip(&turns[at]);
                    frames.into_iter().all(|((a, b), x)| apart(*a, *b, share, *x) <= UNTRUE)
                });
                from = to;
                is_near
            })
    }
}

/// What a difference is measured by.
struct Scale {
    turns: Vec<Vec<Quaternion>>,
    size: f64,
}

/// The least and the largest of each component.
fn ranges(states: &[Vec<f64>]) -> Vec<(f64, f64)> {
    let count = states.first().map_or(0, Vec::len);
    let of = |at: usize| {
        let values = states.iter().filter_map(|state| state.get(at).copied()).filter(|x| x.is_finite());
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)))
    };
    (0..count).map(of).collect()
}

/// Whether every point has a place: runs may end where the formulas of some have no value.
fn is_somewhere(pose: &Pose) -> bool {
    pose.points.iter().flatten().chain(pose.rotations.iter().flatten().flatten()).all(|x| x.is_finite())
}

fn between(a: Triple, b: Triple, share: f64) -> Triple {
    plus(a, share, minus(b, a))
}

/// The angle between two attitudes, rad.
fn angle(a: Quaternion, b: Quaternion) -> f64 {
    let cos: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
    2.0 * cos.abs().min(1.0).acos()
}

/// The angle between an attitude and that on the even way from one to another, rad.
///
/// K. Shoemake, Animating rotation with quaternion curves, *Computer Graphics* 19 (1985) 245-254, § 3.3.
fn apart(a: Quaternion, b: Quaternion, share: f64, x: Quaternion) -> f64 {
    let cos: f64 = a.iter().zip(b).map(|(x, y)| x * y).sum();
    let b = if cos < 0.0 { b.map(|x| -x) } else { b };
    let whole = cos.abs().min(1.0).acos();
    let (from, to) = if whole < 1e-6 {
        (1.0 - share, share)
    } else {
        ((whole * (1.0 - share)).sin() / whole.sin(), (whole * share).sin() / whole.sin())
    };
    let way: Vec<f64> = a.iter().zip(b).map(|(a, b)| from * a + to * b).collect();
    angle([way[0], way[1], way[2], way[3]], x)
}
