//! Stretch of a motion by quadrature, integrated once: the time and the other coordinates as Legendre series on panels
//! (subintervals).
//!
//! The variable w of a stretch is chosen so that the motion is smooth in w at turning points. With T = (dq/dw)² G the
//! speed is |dq/dw| √(2 G/m), and dt/dw = 1/(|k| √(2 G/m)). G never vanishes, and is computed as a divided difference
//! of V, so that it keeps its digits near a turning point.

use super::energy::Energy;
use super::integrand_sampler::{Panel, Sampler, Samples, integrand_sampler};
use super::legendre_rule::{LegendreRule, LegendreValues, POINTS, Series, dot_of_legendre_series, integrated_series};
use super::quadrature_error::StretchObstacle;
use super::stretch_variable::{Anchor, Place, StretchVariable};
use tripos_traits::largest;

/// Relative size of the last terms up to which a Legendre series counts as resolved; the largest term is 1. It is the
/// rounding error of the integrand.
const RESOLVED: f64 = 16.0 * f64::EPSILON;
/// Relative rounding error of an integrand that is accepted without a narrower panel. Such errors have both signs and
/// hardly add up.
const HARMLESS: f64 = 1e-14;
/// Distance of a singularity from the middle of a panel, in half-widths, from which on a series of [`POINTS`] terms is
/// resolved. The terms fall like ρ^−k, with ρ = z + √(z² − 1) at the distance z.
const FAR_ENOUGH: f64 = 2.7;

/// Number of panels for which a stretch reserves memory.
const ROOM: usize = 12;

/// Point up to which a stretch is integrated.
#[derive(Clone, Copy, Debug)]
pub(super) enum Goal {
    /// Integrates exactly to this value of the variable w, at which the stretch ends.
    End(f64),
    /// Integrates the stretch at least to this value of its variable w.
    Variable(f64),
    /// Integrates the stretch by at least this many further panels (subintervals).
    Panels(usize),
    /// Integrates at least to this time from the start of the stretch, s.
    Time(f64),
}

/// Stretch of a motion by quadrature with its panels, the subintervals of the variable w.
///
/// Several functions of w are integrated, and have an index. Index 0 is the time. Then come the integrals of the other
/// coordinates' rates while q rises, then those while q falls.
#[derive(Clone, Debug)]
pub(super) struct Stretch {
    /// Map from the variable w of the stretch to the coordinate q.
    pub(super) chart: StretchVariable,
    /// Number of functions that are integrated along the stretch.
    functions: usize,
    /// Relative error of the integrands that is caused by the rounding of the turning points.
    noise: f64,
    /// Values of w at which panels meet, with the start and the end of the stretch.
    ends: Vec<f64>,
    /// Times from the start of the stretch at the values in `ends`, s.
    pub(super) times: Vec<f64>,
    /// Values of all functions at the values in `ends`, one end after the other.
    sums: Vec<f64>,
    /// Legendre series of each panel: first that of dt/dξ, with ξ from −1 to 1 in the panel, then those of all
    /// functions.
    series: Vec<f64>,
    /// Point from which the kinetic energy is computed: the end of the last panel. `None` at the start, and for
    /// stretches of the kinds line and crest.
    ///
    /// Far from a turning point that is near a pole, V\[end, q\] is a difference of large terms. The difference from
    /// panel to panel is not.
    anchor: Option<Anchor>,
    /// Width of the next panel to try, in the variable w of the stretch.
    width: f64,
    /// Two numbers for each function: the relative rounding error that narrower panels did not reduce, and the error
    /// level at which a panel was last rejected.
    floors: Vec<[f64; 2]>,
    /// Number of panels (subintervals of the stretch) that were tried.
    pub(super) attempts: u32,
    /// Number of panels (subintervals of the stretch) that were rejected as too wide.
    pub(super) rejected: u32,
}

/// Working space for panels: the evaluator of the integrands, with their values and their series.
pub(super) struct Scratch<'a> {
    /// Evaluator of the integrands.
    sampler: Box<dyn Sampler + 'a>,
    /// Values of the integrands at the points of the panel.
    samples: Samples,
    /// Legendre series of each integrand on the panel.
    series: Vec<Series>,
}

impl<'a> Scratch<'a> {
    /// Creates the working space for a motion whose coordinates are `q` at the start.
    pub(super) fn new(energy: &'a Energy<'_>, q: &[f64]) -> Self {
        let samples = Samples::new(q.len());
        let series = samples.values.clone();
        Self { sampler: integrand_sampler(energy, q), samples, series }
    }
}

impl Stretch {
    /// Creates a stretch without panels for this number of coordinates. `width` is the width in w of the first panel to
    /// try, and `noise` is the relative error of the integrands.
    pub(super) fn new(chart: StretchVariable, coordinates: usize, noise: f64, width: f64) -> Self {
        let functions = 2 * coordinates - 1;
        Self {
            chart,
            functions,
            noise,
            ends: vec![0.0],
            times: vec![0.0],
            sums: vec![0.0; functions],
            series: Vec::with_capacity(ROOM * (POINTS + functions * (POINTS + 1))),
            anchor: None,
            width,
            floors: vec![[0.0; 2]; functions],
            attempts: 0,
            rejected: 0,
        }
    }

    /// Values of all functions at the end of the integrated part of the stretch.
    pub(super) fn totals(&self) -> &[f64] {
        &self.sums[self.sums.len() - self.functions..]
    }

    /// Value of the variable w up to which the stretch is integrated.
    pub(super) fn end(&self) -> f64 {
        self.ends[self.ends.len() - 1]
    }

    /// Time from the start of the stretch to the end of its integrated part, s.
    pub(super) fn duration(&self) -> f64 {
        self.times[self.times.len() - 1]
    }

    /// Adds panels to the stretch until the goal is reached. Error if the integrands are not resolved within `limit`
    /// attempts in all, or if there is no kinetic energy at a point.
    pub(super) fn extend(
        &mut self,
        energy: &Energy<'_>,
        scratch: &mut Scratch<'_>,
        goal: Goal,
        limit: u32,
    ) -> Result<(), StretchObstacle> {
        loop {
            let from = self.ends[self.ends.len() - 1];
            let (reached, left) = match goal {
                Goal::End(end) => (from >= end, end - from),
                Goal::Variable(w) => (from >= w, f64::INFINITY),
                Goal::Panels(count) => (self.times.len() > count, f64::INFINITY),
                Goal::Time(t) => (self.duration() >= t, f64::INFINITY),
            };
            if reached && self.times.len() > 1 {
                return Ok(());
            }
            // A narrow last panel would cost as much as a wide panel, so that it is merged with this one.
            let width = if left < 1.25 * self.width { left } else { self.width };
            let to = if left < 1.25 * self.width { from + left } else { from + width };
            self.attempts += 1;
            if self.attempts > limit || to <= from || !to.is_finite() {
                return Err(StretchObstacle::Unresolved(self.chart.at(from).q));
            }
            self.try_panel(energy, scratch, from, to)?;
        }
    }

    /// Tries the panel from `from` to `to` of the variable w, and adds it if all functions are resolved. Error if a
    /// point has no kinetic energy or no finite rate.
    fn try_panel(
        &mut self,
        energy: &Energy<'_>,
        scratch: &mut Scratch<'_>,
        from: f64,
        to: f64,
    ) -> Result<(), StretchObstacle> {
        let rule = LegendreRule::shared_rule();
        let half = 0.5 * (to - from);
        let panel = Panel { energy, chart: self.chart, anchor: self.anchor, from, half };
        scratch.sampler.integrands_while_rising(&panel, &mut scratch.samples)?;
        // Integrands while q falls cost as much again. They are sampled only if the integrands while q rises do not
        // show that the panel is too wide.
        let rest = self.functions / 2;
        let mut nearest = f64::INFINITY;
        for function in 0..self.functions {
            if function == 1 + rest {
                scratch.sampler.integrands_while_falling(energy, &mut scratch.samples);
            }
            nearest = nearest.min(self.judge_series(rule, scratch, function, half));
            if nearest < 1.0 {
                break;
            }
        }
        if nearest < 1.0 {
            self.rejected += 1;
            self.width = (to - from) * nearest.clamp(1.0 / 32.0, 0.7);
            return Ok(());
        }
        self.width = (to - from) * nearest.min(8.0);
        let end = self.chart.at(to);
        if matches!(self.chart, StretchVariable::Arc { .. } | StretchVariable::Root { .. }) {
            let kinetic = self.chart.kinetic_energy_at(energy, self.anchor, |a, b| energy.potential_slope(a, b), &end);
            self.anchor = Some(Anchor::next_anchor(self.anchor, energy, &end, kinetic));
        }
        self.ends.push(to);
        let before = self.sums.len() - self.functions;
        self.series.extend(scratch.series[0].map(|c| c * half));
        for (function, series) in scratch.series.iter().enumerate() {
            let scaled = series.map(|c| c * half);
            self.series.extend(integrated_series(&scaled));
            self.sums.push(self.sums[before + function] + 2.0 * scaled[0]);
        }
        self.times.push(self.sums[before + self.functions]);
        Ok(())
    }

    /// Computes the Legendre series of a function on a panel of half-width `half`. Returns the ratio of the next
    /// panel's width to this width. A ratio below 1 means that the panel is too wide and must be rejected.
    fn judge_series(&mut self, rule: &LegendreRule, scratch: &mut Scratch<'_>, function: usize, half: f64) -> f64 {
        let c = rule.coefficients(&scratch.samples.values[function]);
        scratch.series[function] = c;
        let size = largest(c);
        if size == 0.0 {
            return f64::INFINITY;
        }
        let last = largest(c[POINTS - 2..].iter().copied());
        let total = self.totals()[function].abs() + 2.0 * half * c[0].abs();
        let enough = (RESOLVED + self.noise) * size;
        let resolved = last <= enough || last * half <= f64::EPSILON * total;
        if !resolved
            && largest(c[POINTS - 4..].iter().copied()) > 0.2 * largest(c[POINTS - 10..POINTS - 4].iter().copied())
            && last < 1e-8 * size
        {
            return self.judge_noise(function, last / size);
        }
        let decay = -(last / size).max(1e-18).ln() / (POINTS as f64 - 1.5);
        let z = decay.cosh();
        if resolved {
            // The singularity is assumed to lie before this panel. It is farther from the next panel, by one width.
            (0.95 * (z + 1.0) / (FAR_ENOUGH - 1.0)).max(1.0)
        } else {
            (0.9 * (z - 1.0) / (FAR_ENOUGH - 1.0)).min(0.7)
        }
    }

    /// Judges a series whose terms no longer fall; `level` is the relative size of its last terms. Returns the ratio of
    /// the next panel's width to this width. A ratio below 1 means that the panel must be rejected.
    ///
    /// The terms are rounding errors of the equations, unless a narrower panel has far smaller terms, as where energies
    /// cancel.
    fn judge_noise(&mut self, function: usize, level: f64) -> f64 {
        let [floor, before] = &mut self.floors[function];
        if level <= HARMLESS.max(2.0 * *floor) {
            return 2.0;
        }
        if level > 0.125 * *before && *before > 0.0 {
            *floor = level;
            return 1.0;
        }
        *before = level;
        0.25
    }

    /// Point of the stretch at `time`, s, counted from the start of the stretch.
    pub(super) fn stretch_point_at_time(&self, time: f64) -> PanelPlace {
        let panel = self.times.partition_point(|t| *t <= time).min(self.times.len() - 1).max(1) - 1;
        let wanted = time - self.times[panel];
        let (rate, integral) = (self.rate(panel), self.integral(panel, 0));
        let rule = LegendreRule::shared_rule();
        let mut x = (wanted / rate[0] - 1.0).clamp(-1.0, 1.0);
        let (mut low, mut high) = (-1.0, 1.0);
        let mut p = rule.values(x);
        // Newton's method within a bracket; the time grows with ξ.
        for _ in 0..60 {
            let excess = dot_of_legendre_series(integral, &p) - wanted;
            if excess > 0.0 {
                high = x;
            } else {
                low = x;
            }
            let step = excess / dot_of_legendre_series(rate, &p[..POINTS]);
            if step.abs() <= 2.0 * f64::EPSILON {
                break;
            }
            let newton = x - step > low && x - step < high;
            x = if newton { x - step } else { 0.5 * (low + high) };
            p = rule.values(x);
            // The error after this step is about the square of the step.
            if newton && step.abs() <= 1e-9 {
                break;
            }
        }
        self.stretch_point_in_panel(panel, x, p)
    }

    /// Point of the stretch at the variable `w`.
    pub(super) fn stretch_point_at_variable(&self, w: f64) -> PanelPlace {
        let panel = self.ends.partition_point(|end| *end <= w).min(self.ends.len() - 1).max(1) - 1;
        let (from, to) = (self.ends[panel], self.ends[panel + 1]);
        let x = (2.0 * ((w - from) / (to - from)) - 1.0).clamp(-1.0, 1.0);
        self.stretch_point_in_panel(panel, x, LegendreRule::shared_rule().values(x))
    }

    /// Point at ξ = `x`, from −1 to 1, in the panel with this index. `polynomials` are the Legendre polynomials at ξ.
    fn stretch_point_in_panel(&self, panel: usize, x: f64, polynomials: LegendreValues) -> PanelPlace {
        let (from, to) = (self.ends[panel], self.ends[panel + 1]);
        PanelPlace { panel, w: from + 0.5 * (1.0 + x) * (to - from), polynomials }
    }

    /// Rate |dw/dt| at a point of the stretch, 1/s.
    pub(super) fn rate_of_variable(&self, at: &PanelPlace) -> f64 {
        let half = 0.5 * (self.ends[at.panel + 1] - self.ends[at.panel]);
        half / dot_of_legendre_series(self.rate(at.panel), &at.polynomials[..POINTS])
    }

    /// Value of an integrated function at a point of the stretch; it is 0 at the start of the stretch.
    pub(super) fn value(&self, at: &PanelPlace, function: usize) -> f64 {
        self.sums[at.panel * self.functions + function]
            + dot_of_legendre_series(self.integral(at.panel, function), &at.polynomials)
    }

    /// Time at the point with the variable `w`, s, counted from the start of the stretch.
    pub(super) fn time_at(&self, w: f64) -> f64 {
        self.value(&self.stretch_point_at_variable(w), 0)
    }

    /// True if the coordinate q rises with the variable w of the stretch.
    pub(super) fn coordinate_rises_along_stretch(&self) -> bool {
        self.chart.start().1 > 0.0
    }

    /// Variable w of the motion's start on this stretch; `None` if the start lies on the other half of the motion.
    ///
    /// Near the turning point, w is computed from T₀ = (dq/dw)² G. The difference of coordinates would keep only half
    /// of its digits.
    pub(super) fn variable_of_start(&self, energy: &Energy<'_>) -> Option<f64> {
        let (end, side) = self.chart.start();
        let offset = (side * (energy.start - end)).max(0.0);
        let close = offset < 0.125 * energy.start.abs().max(end.abs());
        let here = Place { q: energy.start, offset, reach: 1.0 };
        let level = || self.chart.kinetic_energy_over_slope_squared(energy, |a, b| energy.potential_slope(a, b), &here);
        let reach = close.then(|| (energy.kinetic / level()).sqrt());
        let reach = reach.filter(|reach| reach.is_finite());
        match self.chart {
            StretchVariable::Arc { length, .. } => {
                let cos = 1.0 - 2.0 * (offset / length);
                if cos < 0.0 {
                    return None;
                }
                let sin = 2.0 * reach.unwrap_or_else(|| (offset * (length - offset)).sqrt()) / length;
                Some(sin.atan2(cos).min(std::f64::consts::FRAC_PI_2))
            }
            StretchVariable::Root { .. } => Some(reach.unwrap_or_else(|| (2.0 * offset).sqrt())),
            StretchVariable::Line { .. } => Some(0.0),
            StretchVariable::Crest { width, .. } => {
                // The start, in the middle of a period, must belong to at least one half in spite of rounding.
                let half = self.chart.at(self.end()).offset;
                (offset <= half * (1.0 + 1e-9)).then(|| (offset / width).asinh().min(self.end()))
            }
        }
    }

    /// Coefficients of all Legendre series of the panel with this index: first of dt/dξ, then of the integrated
    /// functions.
    fn panel_series(&self, panel: usize) -> &[f64] {
        let length = POINTS + self.functions * (POINTS + 1);
        &self.series[panel * length..(panel + 1) * length]
    }

    /// Coefficients of the Legendre series of dt/dξ in the panel with this index.
    fn rate(&self, panel: usize) -> &[f64] {
        &self.panel_series(panel)[..POINTS]
    }

    /// Coefficients of the Legendre series of an integrated function in a panel. There is one coefficient more than for
    /// the integrand.
    fn integral(&self, panel: usize, function: usize) -> &[f64] {
        &self.panel_series(panel)[POINTS + function * (POINTS + 1)..][..=POINTS]
    }
}

/// Point of a stretch: its panel, its variable w, and the Legendre polynomials there.
pub(super) struct PanelPlace {
    /// Index of the panel of the stretch in which the point lies, from 0.
    panel: usize,
    /// Variable w of the stretch at the point.
    pub(super) w: f64,
    /// Values of the Legendre polynomials at the point, in the variable ξ of its panel.
    polynomials: LegendreValues,
}
