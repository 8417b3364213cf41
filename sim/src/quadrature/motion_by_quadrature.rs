//! Motion of a system with one degree of freedom by quadrature: its kind, its state at any time, and a check that
//! quadrature applies to the equations.

use tripos_traits::{Lengths, System};

use super::energy::Energy;
use super::legendre_rule::POINTS;
use super::motion_kind::{MotionKind, add_far_turning_point_of_motion};
use super::quadrature_error::NoQuadrature;
use super::stretch::Scratch;
use crate::error::SimError;

/// Motion by quadrature of equations with one speed, from one start.
///
/// ```
/// # use tripos_traits::{Lengths, System};
/// # struct Oscillator;
/// # impl System<f64> for Oscillator {
/// #     fn lengths(&self) -> Lengths { Lengths { coordinates: 1, variables: 1, speeds: 1, ..Lengths::default() } }
/// #     fn symmetric(&self) -> bool { true }
/// #     fn coordinate_rates(&self, _: &[f64], _: &[f64], v: &[f64], out: &mut [f64]) { out[0] = v[0]; }
/// #     fn mass_matrix(&self, _: &[f64], _: &[f64], _: &[f64], out: &mut [f64]) { out[0] = 1.0; }
/// #     fn forcing(&self, _: &[f64], q: &[f64], _: &[f64], out: &mut [f64]) { out[0] = -q[0]; }
/// #     fn output_count(&self) -> usize { 2 }
/// #     fn outputs(&self, p: &[f64], _: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
/// #         self.whole_state(p, q, v, out);
/// #     }
/// #     fn generalized_speeds(&self, _: &[f64], _: &[f64], v: &[f64], out: &mut [f64]) { out[0] = v[0]; }
/// #     fn generalized_speed_rates(&self, _: &[f64], _: &[f64], _: &[f64], a: &[f64], out: &mut [f64]) {
/// #         out[0] = a[0];
/// #     }
/// #     fn motion_variables(&self, _: &[f64], _: &[f64], u: &[f64], out: &mut [f64]) { out[0] = u[0]; }
/// #     fn kinetic_energy(&self, _: &[f64], _: &[f64], v: &[f64]) -> f64 { 0.5 * v[0] * v[0] }
/// #     fn potential_energy(&self, _: &[f64], q: &[f64]) -> f64 { 0.5 * q[0] * q[0] }
/// #     fn has_potential_slope(&self) -> bool { true }
/// #     fn potential_slope(&self, _: &[f64], a: f64, b: f64) -> f64 { 0.5 * (a + b) }
/// # }
/// use tripos_sim::quadrature::MotionByQuadrature;
///
/// // q″ = −q, V = q²/2, so V[a, b] = (a + b)/2.
/// let motion = MotionByQuadrature::new(&Oscillator, &[], &[1.0], 0.0)?;
/// assert!((motion.period().unwrap() - std::f64::consts::TAU).abs() < 1e-15);
/// assert!((motion.state(1000.0)?[0] - 1000_f64.cos()).abs() < 1e-13);
/// # Ok::<(), tripos_sim::quadrature::NoQuadrature>(())
/// ```
#[derive(Clone, Debug)]
pub struct MotionByQuadrature<'a> {
    /// Equations of motion with the energy of the start.
    energy: Energy<'a>,
    /// State (q, v) at the start: n coordinates and the speed.
    start: Vec<f64>,
    /// Rates q′ of the n coordinates at the start.
    rates: Vec<f64>,
    /// Coordinates of the turning points below and above the start; `None` if no turning point is known.
    turns: [Option<f64>; 2],
    /// Kind of the motion, with its integrated stretches.
    pub(super) course: MotionKind,
    /// Time τ of the start, s, counted from the turning point at which the first stretch begins.
    pub(super) lead: f64,
    /// Integrals of the rates of all coordinates from τ = 0 to the start.
    sums: Vec<f64>,
}

impl<'a> MotionByQuadrature<'a> {
    /// Computes the motion of a system with one degree of freedom from coordinates `q` and speed `v`, with
    /// parameters `p`.
    ///
    /// The equations must have a single speed v and [`System::potential_slope`]. Coordinate 0 is the degree
    /// of freedom: q₀′ = k(q₀) v, T = ½ m(q₀) v² and V(q₀). The rates of all other coordinates must depend
    /// on q₀ and v only, which is tested at the start.
    ///
    /// # Errors
    /// [`NoQuadrature`] if the equations are not of this kind, if the motion approaches an equilibrium for
    /// ever, or if its integrals are not resolved.
    pub fn new(system: &'a dyn System<f64>, p: &[f64], q: &[f64], v: f64) -> Result<Self, NoQuadrature> {
        check_one_degree(system, p, q, v)?;
        let energy = Energy::new(system, p, q, v)?;
        let mut rates = vec![0.0; q.len()];
        energy.rates(q, v, &mut rates);
        let still = energy.motion_rests();
        let mut turns = [None; 2];
        if !still {
            turns = [energy.turning_point(-1.0)?, energy.turning_point(1.0)?];
        }
        let start = [q, &[v]].concat();
        let sums = vec![0.0; q.len()];
        let mut motion = Self { energy, start, rates, turns, course: MotionKind::Rest, lead: 0.0, sums };
        if !still {
            motion.follow_motion(&[0.0])?;
        }
        Ok(motion)
    }

    /// Determines the kind of the motion, and integrates the motion up to these times from the start, s. Error if the
    /// integrals are not resolved.
    fn follow_motion(&mut self, times: &[f64]) -> Result<(), NoQuadrature> {
        let n = self.start.len() - 1;
        let (q, v) = (&self.start[..n], self.start[n]);
        let mut scratch = Scratch::new(&self.energy, q);
        // Each round either meets a turning point that the searches missed, or is the last.
        loop {
            self.course = MotionKind::new(&self.energy, q, v, &mut self.turns, &mut scratch)?;
            let mut follow = || {
                self.course.search_missed_turning_point(&self.energy, &mut scratch)?;
                let lead = self.course.time_of_start(&self.energy, v, &mut scratch)?;
                for t in times {
                    self.course.integrate_to_time(&self.energy, lead + t, &mut scratch)?;
                }
                Ok(lead)
            };
            let known = self.turns;
            match follow() {
                Ok(lead) => {
                    self.lead = lead;
                    break;
                }
                Err(obstacle) => add_far_turning_point_of_motion(&self.energy, &mut self.turns, obstacle)?,
            }
            if self.turns == known {
                return Err(NoQuadrature::Asymptotic { at: self.start[0] });
            }
        }
        if let Some(spot) = self.course.point_of_motion(self.lead) {
            for i in 1..n {
                self.sums[i] = spot.integral_along_motion(i, n - 1);
            }
        }
        Ok(())
    }

    /// Integrates an unbounded motion from the earlier to the later of the times `t0` and `t1`, s from the start. A
    /// motion between two turning points, or a rotation ([`System::coordinate_period`]), is known at all times without
    /// this call.
    ///
    /// # Errors
    /// [`NoQuadrature`] if the integrals are not resolved up to these times.
    pub fn cover(&mut self, t0: f64, t1: f64) -> Result<(), NoQuadrature> {
        match self.course {
            MotionKind::Rest | MotionKind::Swing { .. } | MotionKind::Rotation { .. } => Ok(()),
            _ => self.follow_motion(&[t0, t1]),
        }
    }

    /// Values of coordinate 0 at the turning points below and above the start; `None` if there is none. Turning points
    /// of an unbounded motion are known only within the integrated part.
    #[must_use]
    pub fn turning_points(&self) -> (Option<f64>, Option<f64>) {
        let [low, high] = self.turns;
        (low, high)
    }

    /// Period of an oscillation between two turning points or of a rotation, s; `None` for other motions.
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        self.course.period()
    }

    /// State (q, v) of the motion `t` seconds after the start, or before it if `t` is negative.
    ///
    /// # Errors
    /// [`NoQuadrature::Uncovered`] for an unbounded motion that is not integrated up to this time by [`Self::cover`].
    pub fn state(&self, t: f64) -> Result<Vec<f64>, NoQuadrature> {
        let mut y = vec![0.0; self.start.len()];
        self.state_into(t, &mut y)?;
        Ok(y)
    }

    /// Writes the state (q, v) of the motion `t` seconds after the start to `y`. It has one entry more than there are
    /// coordinates.
    ///
    /// # Errors
    /// [`NoQuadrature::Uncovered`] for an unbounded motion that is not integrated up to this time by [`Self::cover`].
    pub fn state_into(&self, t: f64, y: &mut [f64]) -> Result<(), NoQuadrature> {
        y.copy_from_slice(&self.start);
        if t == 0.0 {
            return Ok(());
        }
        let n = self.start.len() - 1;
        let Some(spot) = self.course.point_of_motion(self.lead + t) else {
            if !matches!(self.course, MotionKind::Rest) {
                return Err(NoQuadrature::Uncovered { t });
            }
            for (y, rate) in y[1..n].iter_mut().zip(&self.rates[1..]) {
                *y += t * rate;
            }
            return Ok(());
        };
        let place = spot.track.chart.at(spot.found.w);
        y[0] = place.q + spot.shift;
        // v = q′/k, with k = q₀′ at v = 1.
        let mut rates = vec![0.0; n];
        self.energy.rates(&y[..n], 1.0, &mut rates);
        let speed = place.reach * spot.track.rate_of_variable(&spot.found) / rates[0];
        y[n] = if spot.rising { speed } else { -speed };
        for (i, y) in y.iter_mut().enumerate().take(n).skip(1) {
            *y += spot.integral_along_motion(i, n - 1) - self.sums[i];
        }
        Ok(())
    }

    /// Number of points at which the integrands of the quadrature were evaluated.
    #[must_use]
    pub fn evaluations(&self) -> u64 {
        let attempts: u64 = self.course.stretches_of_motion().iter().map(|track| u64::from(track.attempts)).sum();
        attempts * POINTS as u64
    }
}

/// Refuses equations and starts to which quadrature does not apply, and lists of the wrong length.
fn check_one_degree(system: &dyn System<f64>, p: &[f64], q: &[f64], v: f64) -> Result<(), NoQuadrature> {
    let Lengths { parameters, coordinates, variables: speeds, .. } = system.lengths();
    if speeds != 1 || q.is_empty() {
        return Err(NoQuadrature::NotOneDegree { speeds });
    }
    for (what, expected, found) in [("parameters", parameters, p.len()), ("coordinates", coordinates, q.len())] {
        if expected != found {
            return Err(SimError::Length { what, expected, found }.into());
        }
    }
    if !(p.iter().chain(q).all(|x| x.is_finite()) && v.is_finite()) {
        return Err(SimError::NotFinite { what: "a parameter, or a component of the initial state,".to_owned() }.into());
    }
    if !system.has_potential_slope() {
        return Err(NoQuadrature::NoPotentialSlope);
    }
    // Rates that do not depend on a coordinate have the same bits for any value of it.
    let rates = |q: &[f64]| {
        let mut out = vec![0.0; q.len()];
        system.coordinate_rates(p, q, &[if v == 0.0 { 1.0 } else { v }], &mut out);
        out.into_iter().map(f64::to_bits).collect::<Vec<_>>()
    };
    let here = rates(q);
    for coordinate in 1..q.len() {
        let mut moved = q.to_vec();
        moved[coordinate] += 0.7 + 0.3 * moved[coordinate].abs();
        if rates(&moved) != here {
            return Err(NoQuadrature::NotQuadrature { coordinate });
        }
    }
    Ok(())
}
