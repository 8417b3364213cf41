//! Finite Fourier series as motions of coordinates, with bounds that hold at every instant.
//!
//! A series of L harmonics is a trigonometric polynomial p of degree L. Near its largest deviation ‖p‖ it falls no
//! faster than ‖p‖ cos(L θ) (M. Riesz, Jahresbericht der Deutschen Mathematiker-Vereinigung 23 (1914) 354–368). On a
//! grid of m instants for each period, the largest deviation is therefore at least ‖p‖ cos(π L/m).

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

/// Number of instants of the grid of a search, for each period of the highest harmonic.
pub const COARSE: usize = 64;
/// Number of instants of the grid by which a result is verified, for each period of the highest harmonic.
pub const FINE: usize = 1024;
/// Number of halvings by which the instant of an extreme value is refined. Each interval becomes shorter by 2⁻⁵⁰.
const HALVINGS: usize = 50;
/// Number of digits of the largest coefficient of a rounded series.
const DIGITS: i32 = 6;
/// Size of a coefficient, relative to the largest one, below which rounding makes it zero.
const TINY: f64 = 3e-5;

/// Finite Fourier series: mean + Σ s_l sin(l ω t) + c_l cos(l ω t) for l = 1 to the number of harmonics, with
/// ω = 2π/period.
///
/// In the notation of Swevers et al. (1997), s_l is a_l/(ω l) and c_l is −b_l/(ω l).
#[derive(Clone, Debug, PartialEq)]
pub struct FourierSeries {
    /// Mean value over a period.
    pub mean: f64,
    /// Amplitudes s_l of the sines, the base frequency first.
    pub sines: Vec<f64>,
    /// Amplitudes c_l of the cosines, as many as sines.
    pub cosines: Vec<f64>,
}

/// Conditions at the start of a series, which it keeps when it is rounded.
#[derive(Clone, Copy, Debug, Default)]
pub struct StartConditions {
    /// True if rate and second rate are zero at the start and after each period.
    pub is_at_rest: bool,
    /// Value at the start and after each period. `None` if any value is right.
    pub home: Option<f64>,
}

impl FourierSeries {
    /// Constant value as a series of this many harmonics.
    #[must_use]
    pub fn constant(mean: f64, harmonics: usize) -> Self {
        Self { mean, sines: vec![0.0; harmonics], cosines: vec![0.0; harmonics] }
    }

    /// Triples (l, s_l, c_l) of the harmonics.
    fn harmonics(&self) -> impl Iterator<Item = (f64, f64, f64)> + '_ {
        self.sines.iter().zip(&self.cosines).enumerate().map(|(at, (sine, cosine))| ((at + 1) as f64, *sine, *cosine))
    }

    /// Value at the phase ω t, rad.
    #[must_use]
    pub fn at_phase(&self, phase: f64) -> f64 {
        self.harmonics().fold(self.mean, |sum, (l, sine, cosine)| {
            let (sin, cos) = (l * phase).sin_cos();
            sum + sine * sin + cosine * cos
        })
    }

    /// Value at the start, where all sines are zero.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.mean + self.cosines.iter().sum::<f64>()
    }

    /// Derivative by the time, for a period in s.
    #[must_use]
    pub fn rate(&self, period: f64) -> Self {
        let omega = TAU / period;
        Self {
            mean: 0.0,
            sines: self.harmonics().map(|(l, _, cosine)| -l * omega * cosine).collect(),
            cosines: self.harmonics().map(|(l, sine, _)| l * omega * sine).collect(),
        }
    }

    /// Series whose deviations from `pivot` are multiplied by `factor`.
    #[must_use]
    pub(super) fn scaled_about(&self, pivot: f64, factor: f64) -> Self {
        let scaled = |list: &[f64]| list.iter().map(|x| factor * x).collect();
        Self { mean: pivot + factor * (self.mean - pivot), sines: scaled(&self.sines), cosines: scaled(&self.cosines) }
    }

    /// Least and largest value. The extreme values of a fine grid are refined between their neighbours on the grid.
    #[must_use]
    pub fn extremes(&self) -> (f64, f64) {
        let points = FINE * self.sines.len();
        let step = TAU / points as f64;
        let slope = self.rate(TAU);
        let (mut least, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
        let mut before = slope.at_phase(-step);
        for at in 0..=points {
            let phase = step * at as f64;
            let here = slope.at_phase(phase);
            let mut values = vec![self.at_phase(phase)];
            if before * here < 0.0 {
                values.push(self.at_phase(root_between(&slope, phase - step, phase)));
            }
            for value in values {
                (least, largest) = (least.min(value), largest.max(value));
            }
            before = here;
        }
        (least, largest)
    }

    /// Bounds that no value exceeds at any instant, from a fine grid. They are wider than the least and the largest
    /// value by up to 5 · 10⁻⁶ of half their difference.
    #[must_use]
    pub fn bounds(&self) -> (f64, f64) {
        let points = FINE * self.sines.len();
        let values = (0..points).map(|at| self.at_phase(TAU * at as f64 / points as f64));
        let (least, largest) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)));
        widened(least, largest, FINE)
    }

    /// Series with coefficients of few decimal digits, which keeps the conditions at the start exactly in decimals.
    #[must_use]
    pub(super) fn rounded(&self, start: &StartConditions) -> Self {
        let largest = self.sines.iter().chain(&self.cosines).fold(0.0_f64, |most, x| most.max(x.abs()));
        if largest == 0.0 {
            return self.clone();
        }
        let decimals = (f64::from(DIGITS) - 1.0 - largest.log10().floor()).clamp(0.0, 15.0);
        let unit = 10.0_f64.powf(decimals).round();
        // Whole numbers of units; sums of these are exact.
        let units = |x: &f64| if x.abs() < TINY * largest { 0.0 } else { (x * unit).round() };
        let whole = |list: &[f64]| list.iter().map(units).collect::<Vec<f64>>();
        let (mut sines, mut cosines) = (whole(&self.sines), whole(&self.cosines));
        if start.is_at_rest {
            sines[0] = -(2..=sines.len()).map(|l| l as f64 * sines[l - 1]).sum::<f64>();
            cosines[0] = -(2..=cosines.len()).map(|l| (l * l) as f64 * cosines[l - 1]).sum::<f64>();
        }
        let mean = match start.home {
            Some(home) => home - cosines.iter().sum::<f64>() / unit,
            None => (self.mean * unit).round() / unit,
        };
        let divided = |list: Vec<f64>| list.into_iter().map(|x| x / unit).collect();
        Self { mean, sines: divided(sines), cosines: divided(cosines) }
    }

    /// Formula of the time `t` as model, scene and motion files write it, for a period in s.
    #[must_use]
    pub fn formula(&self, period: f64) -> String {
        let mut out = String::new();
        let mut add = |amplitude: f64, factor: &str| {
            let sign = match (out.is_empty(), amplitude < 0.0) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            if amplitude != 0.0 {
                let _ = write!(out, "{sign}{}{factor}", amplitude.abs());
            }
        };
        add(self.mean, "");
        for (l, sine, cosine) in self.harmonics() {
            let angle = format!("{}*pi*t/{period}", 2.0 * l);
            add(sine, &format!("*sin({angle})"));
            add(cosine, &format!("*cos({angle})"));
        }
        if out.is_empty() { "0".to_owned() } else { out }
    }
}

/// Phase between two phases at which the series, of which the values there have opposite signs, is zero.
fn root_between(series: &FourierSeries, mut low: f64, mut high: f64) -> f64 {
    let is_negative = series.at_phase(low) < 0.0;
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if (series.at_phase(middle) < 0.0) == is_negative {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// Bounds at every instant from the least and the largest value on a grid with `density` instants for each period of
/// the highest harmonic.
fn widened(least: f64, largest: f64, density: usize) -> (f64, f64) {
    let middle = 0.5 * (least + largest);
    let half = 0.5 * (largest - least) / (PI / density as f64).cos();
    (middle - half, middle + half)
}

/// Sines and cosines of all harmonics at evenly spaced phases, for many series with the same number of harmonics.
pub struct PhaseTable {
    /// Values of sin(l φ), then of cos(l φ), for each phase and each harmonic.
    rows: Vec<(Vec<f64>, Vec<f64>)>,
    /// Number of phases for each period of the highest harmonic.
    density: usize,
}

impl PhaseTable {
    /// Table of the grid of a search.
    #[must_use]
    pub fn coarse(harmonics: usize) -> Self {
        let points = COARSE * harmonics;
        Self::of_phases(harmonics, (0..points).map(|at| TAU * at as f64 / points as f64), COARSE)
    }

    /// Table of `count` instants from the start to the end of a period, both included.
    #[must_use]
    pub fn of_instants(harmonics: usize, count: usize) -> Self {
        let last = count.saturating_sub(1).max(1) as f64;
        Self::of_phases(harmonics, (0..count).map(|at| TAU * at as f64 / last), COARSE)
    }

    /// Table of the given phases.
    fn of_phases(harmonics: usize, phases: impl Iterator<Item = f64>, density: usize) -> Self {
        let row = |phase: f64| (1..=harmonics).map(|l| (l as f64 * phase).sin_cos()).unzip();
        Self { rows: phases.map(row).collect(), density }
    }

    /// Number of phases.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Values of a series at all phases of the table.
    pub fn values<'a>(&'a self, series: &'a FourierSeries) -> impl Iterator<Item = f64> + 'a {
        self.rows.iter().map(move |(sin, cos)| {
            let sines = sin.iter().zip(&series.sines);
            let cosines = cos.iter().zip(&series.cosines);
            sines.chain(cosines).fold(series.mean, |sum, (basis, amplitude)| sum + basis * amplitude)
        })
    }

    /// Bounds that no value of a series exceeds at any instant. The phases have to cover a period evenly.
    #[must_use]
    pub fn bounds(&self, series: &FourierSeries) -> (f64, f64) {
        let (least, largest) = self
            .values(series)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)));
        widened(least, largest, self.density)
    }
}
