//! Motions within limits from any numbers: the unknowns of the search.
//!
//! The unknowns of a coordinate are the amplitudes of its series, relative to half of its range and divided by the
//! number of the harmonic, and the place of the series within the range. A series that exceeds a limit is made smaller
//! until it touches the limit. All motions of the search therefore keep the limits of single quantities.

use super::fourier_series::{FourierSeries, PhaseTable, StartConditions};
use super::motion_limits::{CoordinateRanges, Range};

/// Weight of the logarithm by which amplitudes exceed a limit. It keeps the unknowns from growing without an effect.
pub const TOO_LARGE: f64 = 1e-3;
/// Weight of the square of a place outside the range.
const OUTSIDE: f64 = 1e-1;

/// Map from the unknowns of the search to motions within the limits.
pub struct CandidateSpace {
    /// Period of the motions, s.
    period: f64,
    /// Number of harmonics of each coordinate.
    harmonics: usize,
    /// Sines and cosines on the grid on which limits are checked.
    table: PhaseTable,
    /// Limits of each coordinate and of its derivatives.
    ranges: Vec<CoordinateRanges>,
    /// Conditions at the start of each coordinate.
    starts: Vec<StartConditions>,
}

impl CandidateSpace {
    /// Space of motions for a period in s, with limits and conditions at the start for each coordinate.
    #[must_use]
    pub fn new(period: f64, harmonics: usize, ranges: Vec<CoordinateRanges>, starts: Vec<StartConditions>) -> Self {
        Self { period, harmonics, table: PhaseTable::coarse(harmonics), ranges, starts }
    }

    /// True if a coordinate moves. A coordinate whose lower limit is its upper limit rests.
    fn moves(&self, coordinate: usize) -> bool {
        let [position, ..] = &self.ranges[coordinate];
        position.low.value < position.high.value
    }

    /// Number of unknowns of a coordinate.
    fn unknowns_of(&self, coordinate: usize) -> usize {
        let place = usize::from(self.starts[coordinate].home.is_none());
        if self.moves(coordinate) { 2 * self.harmonics + place } else { 0 }
    }

    /// Number of unknowns.
    #[must_use]
    pub fn unknowns(&self) -> usize {
        (0..self.ranges.len()).map(|coordinate| self.unknowns_of(coordinate)).sum()
    }

    /// Motion of given unknowns, and a penalty for unknowns that have no effect because of limits.
    #[must_use]
    pub fn motion(&self, x: &[f64]) -> (Vec<FourierSeries>, f64) {
        let mut first = 0;
        let mut penalty = 0.0;
        let series = (0..self.ranges.len()).map(|coordinate| {
            let count = self.unknowns_of(coordinate);
            let own = &x[first..first + count];
            first += count;
            let (series, more) = self.series(coordinate, own);
            penalty += more;
            series
        });
        (series.collect(), penalty)
    }

    /// Series of a coordinate within its limits, and the penalty of its unknowns.
    fn series(&self, coordinate: usize, x: &[f64]) -> (FourierSeries, f64) {
        let start = &self.starts[coordinate];
        let [position, rate_range, second_range] = &self.ranges[coordinate];
        let (low, high) = (position.low.value, position.high.value);
        if x.is_empty() {
            return (FourierSeries::constant(low, self.harmonics), 0.0);
        }
        let whole = self.amplitudes(x, 0.5 * (high - low), start.is_at_rest);
        let (least, largest) = self.table.bounds(&whole);
        let rate = whole.rate(self.period);
        let excess = match start.home {
            Some(home) => {
                let first = whole.start();
                ratio(least - first, largest - first, low - home, high - home)
            }
            None => (largest - least) / (high - low),
        };
        let excess = excess.max(self.excess(&rate, rate_range)).max(self.excess(&rate.rate(self.period), second_range));
        let factor = 1.0 / excess.max(1.0);
        let mut series = whole.scaled_about(0.0, factor);
        let mut penalty = TOO_LARGE * excess.max(1.0).ln().powi(2);
        match start.home {
            Some(home) => series.mean = home - series.start(),
            None => {
                let place = 0.5 + 0.5 * x[2 * self.harmonics];
                let within = place.clamp(0.0, 1.0);
                penalty += OUTSIDE * (place - within).powi(2);
                let room = (high - low) - factor * (largest - least);
                series.mean = low - factor * least + within * room.max(0.0);
            }
        }
        (series, penalty)
    }

    /// Series with the mean 0 from unknowns, before limits are kept. `half` is half of the range of the coordinate.
    fn amplitudes(&self, x: &[f64], half: f64, is_at_rest: bool) -> FourierSeries {
        let of = |k: usize| half * x[k] / (k % self.harmonics + 1) as f64;
        let mut sines: Vec<f64> = (0..self.harmonics).map(of).collect();
        let mut cosines: Vec<f64> = (self.harmonics..2 * self.harmonics).map(of).collect();
        if is_at_rest {
            // The rate at the start is ω Σ l s_l, and the second rate is −ω² Σ l² c_l.
            remove_share(&mut sines, 1);
            remove_share(&mut cosines, 2);
        }
        FourierSeries { mean: 0.0, sines, cosines }
    }

    /// Ratio of a series to its limits: above 1 if it exceeds them.
    fn excess(&self, series: &FourierSeries, range: &Range) -> f64 {
        let (low, high) = (range.low.value, range.high.value);
        if low.is_infinite() && high.is_infinite() {
            return 0.0;
        }
        let (least, largest) = self.table.bounds(series);
        ratio(least, largest, low, high)
    }

    /// Motion whose deviations from its start at home, or else from its mean, are multiplied by `factor`. It keeps the
    /// limits if the given motion does and if `factor` is at most 1.
    #[must_use]
    pub fn scaled(&self, series: &[FourierSeries], factor: f64) -> Vec<FourierSeries> {
        let of = |(series, start): (&FourierSeries, &StartConditions)| {
            series.scaled_about(start.home.unwrap_or(series.mean), factor)
        };
        series.iter().zip(&self.starts).map(of).collect()
    }

    /// Rounded motion that keeps all limits at every instant, which a fine grid shows. `None` if the rounded motion
    /// exceeds a limit.
    #[must_use]
    pub fn rounded(&self, series: &[FourierSeries]) -> Option<Vec<FourierSeries>> {
        let of = |(at, series): (usize, &FourierSeries)| {
            let rounded = series.rounded(&self.starts[at]);
            self.is_within(at, &rounded).then_some(rounded)
        };
        series.iter().enumerate().map(of).collect()
    }

    /// True if a series of a coordinate keeps the limits at every instant.
    fn is_within(&self, coordinate: usize, series: &FourierSeries) -> bool {
        let rate = series.rate(self.period);
        let second = rate.rate(self.period);
        let [position, ..] = &self.ranges[coordinate];
        if position.low.value >= position.high.value {
            return true;
        }
        [series, &rate, &second].into_iter().zip(&self.ranges[coordinate]).all(|(series, range)| {
            let (least, largest) = series.bounds();
            least >= range.low.value && largest <= range.high.value
        })
    }
}

/// Ratio of values from `least` to `largest` around 0 to limits around 0: above 1 if they exceed a limit.
fn ratio(least: f64, largest: f64, low: f64, high: f64) -> f64 {
    (largest / high).max(least / low)
}

/// Removes from amplitudes a_l the share along l^power, so that Σ l^power a_l = 0.
fn remove_share(amplitudes: &mut [f64], power: i32) {
    let weight = |at: usize| ((at + 1) as f64).powi(power);
    let sum: f64 = amplitudes.iter().enumerate().map(|(at, amplitude)| weight(at) * amplitude).sum();
    let squares: f64 = (0..amplitudes.len()).map(|at| weight(at).powi(2)).sum();
    amplitudes.iter_mut().enumerate().for_each(|(at, amplitude)| *amplitude -= weight(at) * sum / squares);
}
