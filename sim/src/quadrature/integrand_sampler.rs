//! Evaluation of integrands at the points of a panel: one by one, or as many at once as fit into a register of the
//! processor.
//!
//! Invariant: all register widths compute the same formulas; results differ only by the rounding of fused products.

#![allow(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]

use super::energy::{Energy, Equations};
use super::legendre_rule::{LegendreRule, POINTS, Series};
use super::quadrature_error::StretchObstacle;
use super::stretch_variable::{Anchor, StretchVariable};
use tripos_traits::{AtPoints, Integrands, Lanes, Scalar, lane_width};

/// Values of the integrands at the points of a panel (a subinterval of a stretch of the motion).
pub(super) struct Samples {
    /// Coordinate q at each point of the panel.
    places: Series,
    /// Absolute value of the generalized speed v at each point of the panel.
    speeds: Series,
    /// Values of dt/dw at the points, then the integrands of the other coordinates while q rises, then their integrands
    /// while q falls.
    pub(super) values: Vec<Series>,
}

impl Samples {
    /// Creates space for the samples of a system with this number of coordinates.
    pub(super) fn new(coordinates: usize) -> Self {
        let values = vec![[0.0; POINTS]; 2 * coordinates - 1];
        Self { places: [0.0; POINTS], speeds: [0.0; POINTS], values }
    }
}

/// Panel (a subinterval of a stretch of the motion) that is to be sampled.
#[derive(Clone, Copy)]
pub(super) struct Panel<'a> {
    /// Equations with the energy of the motion.
    pub(super) energy: &'a Energy<'a>,
    /// Map from the variable w of the stretch to the coordinate q.
    pub(super) chart: StretchVariable,
    /// Point from which the kinetic energy is computed; `None` for the start of the stretch.
    pub(super) anchor: Option<Anchor>,
    /// Variable w at which the panel begins.
    pub(super) from: f64,
    /// Half of the width of the panel, in w.
    pub(super) half: f64,
}

/// Evaluator of the integrands at the points of a panel, with its working space.
pub(super) trait Sampler {
    /// Evaluates dt/dw and the integrands while the coordinate q rises, at all points of a panel.
    ///
    /// # Errors
    /// [`StretchObstacle`] with the first point at which there is no kinetic energy, or no finite rate.
    fn integrands_while_rising(&mut self, panel: &Panel<'_>, samples: &mut Samples) -> Result<(), StretchObstacle>;
    /// Evaluates the integrands while the coordinate q falls, at the points of the last call of
    /// [`Sampler::integrands_while_rising`].
    fn integrands_while_falling(&mut self, energy: &Energy<'_>, samples: &mut Samples);
}

/// Creates the evaluator with the widest vector lanes that the equations support and that this processor handles best.
/// `q` are the coordinates at the start.
pub(super) fn integrand_sampler<'a>(energy: &'a Energy<'_>, q: &[f64]) -> Box<dyn Sampler + 'a> {
    match energy.system.0.at_points() {
        Some(AtPoints { eight, .. }) if lane_width() == 8 => Box::new(LaneSampler::<Lanes<8>>::new(eight, energy, q)),
        Some(AtPoints { four, .. }) => Box::new(LaneSampler::<Lanes<4>>::new(four, energy, q)),
        None => Box::new(LaneSampler::<f64>::new(&energy.system, energy, q)),
    }
}

/// Number type that holds a fixed number of doubles: one as a plain number, or several in vector lanes.
trait PackedSamples: Scalar {
    /// Number of doubles in a value of this type.
    const WIDTH: usize;
    /// Reads the first `WIDTH` entries of `values`.
    fn pack(values: &[f64]) -> Self;
    /// Writes the `WIDTH` doubles of this value to `to`.
    fn unpack(self, to: &mut [f64]);
}

impl PackedSamples for f64 {
    const WIDTH: usize = 1;
    #[inline(always)]
    fn pack(values: &[f64]) -> Self {
        values[0]
    }
    #[inline(always)]
    fn unpack(self, to: &mut [f64]) {
        to[0] = self;
    }
}

impl<const N: usize> PackedSamples for Lanes<N> {
    const WIDTH: usize = N;
    #[inline(always)]
    fn pack(values: &[f64]) -> Self {
        Self(std::array::from_fn(|l| values[l]))
    }
    #[inline(always)]
    fn unpack(self, to: &mut [f64]) {
        to.copy_from_slice(&self.0);
    }
}

/// Evaluates the integrands at a single point at a time.
impl Integrands<f64> for Equations<'_> {
    fn coordinate_rates(&self, p: &[f64], q: &[f64], v: f64, out: &mut [f64]) {
        self.0.coordinate_rates(p, q, &[v], out);
    }
    fn kinetic_energy(&self, p: &[f64], q: &[f64], v: f64) -> f64 {
        self.0.kinetic_energy(p, q, &[v])
    }
    fn potential_slope(&self, p: &[f64], a: f64, b: f64) -> f64 {
        self.0.potential_slope(p, a, b)
    }
}

/// Evaluator of the integrands at as many points at once as the type `S` holds.
struct LaneSampler<'a, S> {
    /// Integrands of the equations, evaluated in the number or vector type `S`.
    equations: &'a dyn Integrands<S>,
    /// Parameters of the equations, the same in all lanes.
    p: Vec<S>,
    /// Coordinates of the system at the points, a vector for each coordinate.
    q: Vec<S>,
    /// Rates q′ of the coordinates at the points, a vector for each coordinate.
    rates: Vec<S>,
}

impl<'a, S: PackedSamples> LaneSampler<'a, S> {
    /// Creates the evaluator from equations and the coordinates `q` at the start.
    fn new(equations: &'a dyn Integrands<S>, energy: &Energy<'_>, q: &[f64]) -> Self {
        let all = |values: &[f64]| values.iter().map(|x| S::from_f64(*x)).collect::<Vec<_>>();
        Self { equations, p: all(&energy.p), q: all(q), rates: all(q) }
    }

    /// Evaluates the integrands while q rises, at the points of the panel from index `at` on.
    #[inline(always)]
    fn rising_integrands_at(&mut self, panel: &Panel<'_>, samples: &mut Samples, at: usize) {
        let Panel { energy, chart, anchor, from, half } = *panel;
        let Self { equations, p, q, rates } = self;
        let points = S::pack(&LegendreRule::shared_rule().points[at..]);
        let place = chart.at(S::from_f64(from) + S::from_f64(half) * (S::from_f64(1.0) + points));
        let kinetic = chart.kinetic_energy_at(energy, anchor, |a, b| equations.potential_slope(p, a, b), &place);
        q[0] = place.q;
        let one = equations.kinetic_energy(p, q, S::from_f64(1.0));
        // T = ½ m v², and ½ m is T at v = 1.
        let speed = (kinetic / one).sqrt();
        equations.coordinate_rates(p, q, S::from_f64(energy.orientation) * speed, rates);
        // dt/dw = reach/q′.
        let rate = place.reach / rates[0];
        let here = at..at + S::WIDTH;
        place.q.unpack(&mut samples.places[here.clone()]);
        speed.unpack(&mut samples.speeds[here.clone()]);
        rate.unpack(&mut samples.values[0][here.clone()]);
        for (values, x) in samples.values[1..].iter_mut().zip(&rates[1..]) {
            (rate * *x).unpack(&mut values[here.clone()]);
        }
    }

    /// Evaluates the integrands while q falls, at the points from index `at` on.
    #[inline(always)]
    fn falling_integrands_at(&mut self, energy: &Energy<'_>, samples: &mut Samples, at: usize) {
        let here = at..at + S::WIDTH;
        self.q[0] = S::pack(&samples.places[here.clone()]);
        let speed = S::from_f64(-energy.orientation) * S::pack(&samples.speeds[here.clone()]);
        self.equations.coordinate_rates(&self.p, &self.q, speed, &mut self.rates);
        let rate = S::pack(&samples.values[0][here.clone()]);
        let rest = self.q.len() - 1;
        for (values, x) in samples.values[1 + rest..].iter_mut().zip(&self.rates[1..]) {
            (rate * *x).unpack(&mut values[here.clone()]);
        }
    }
}

impl<S: PackedSamples> Sampler for LaneSampler<'_, S> {
    fn integrands_while_rising(&mut self, panel: &Panel<'_>, samples: &mut Samples) -> Result<(), StretchObstacle> {
        for at in (0..POINTS).step_by(S::WIDTH) {
            S::dispatch(
                #[inline(always)]
                || self.rising_integrands_at(panel, samples, at),
            );
            for i in at..at + S::WIDTH {
                let (q, rate, moves) = (samples.places[i], samples.values[0][i], samples.speeds[i] > 0.0);
                if !moves {
                    return Err(StretchObstacle::Barrier(q));
                }
                if rate.is_nan() || rate <= 0.0 || rate.is_infinite() {
                    return Err(StretchObstacle::Unresolved(q));
                }
            }
        }
        Ok(())
    }

    fn integrands_while_falling(&mut self, energy: &Energy<'_>, samples: &mut Samples) {
        for at in (0..POINTS).step_by(S::WIDTH) {
            S::dispatch(
                #[inline(always)]
                || self.falling_integrands_at(energy, samples, at),
            );
        }
    }
}
