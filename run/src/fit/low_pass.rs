//! Low-pass filter without delay, and central differences, for evenly sampled signals.

use std::f64::consts::{PI, SQRT_2};

/// Low-pass filter of Butterworth of order 2 that runs forwards and backwards, so that it delays nothing. Both ways
/// together halve the amplitude at the cut-off frequency.
pub struct LowPass {
    /// Factors of the last three inputs, the newest first.
    inputs: [f64; 3],
    /// Factors of the last two outputs, the newer first.
    outputs: [f64; 2],
}

impl LowPass {
    /// Filter with a cut-off frequency, Hz, for samples at a distance, s. `None` unless the frequency is above 0 and
    /// below half of the sampling frequency.
    ///
    /// The filter is the bilinear transform of the analogue one (A. V. Oppenheim & R. W. Schafer, *Discrete-Time Signal
    /// Processing* (2010), § 7.2).
    pub fn new(cut_off: f64, distance: f64) -> Option<Self> {
        if !(cut_off > 0.0 && 2.0 * cut_off * distance < 1.0) {
            return None;
        }
        let w = (PI * cut_off * distance).tan();
        let whole = 1.0 + SQRT_2 * w + w * w;
        let gain = w * w / whole;
        Some(Self {
            inputs: [gain, 2.0 * gain, gain],
            outputs: [2.0 * (w * w - 1.0) / whole, (1.0 - SQRT_2 * w + w * w) / whole],
        })
    }

    /// Number of neighbouring samples of filtered white noise that share an error, at least 1. The noise bandwidth of
    /// both passes is 3 π/(8 √2) of the cut-off frequency.
    pub fn rows_for_each_error(cut_off: f64, distance: f64) -> f64 {
        let bandwidth = 3.0 * PI / (8.0 * SQRT_2) * cut_off;
        (1.0 / (2.0 * bandwidth * distance)).max(1.0)
    }

    /// Filters a signal forwards and backwards. The signal is continued beyond its ends by point reflection.
    pub fn filter(&self, signal: &[f64]) -> Vec<f64> {
        let Some((first, last)) = signal.first().zip(signal.last()) else { return Vec::new() };
        let beyond = signal.len() - 1;
        let before = (1..=beyond).rev().map(|at| 2.0 * first - signal[at]);
        let after = (0..beyond).rev().map(|at| 2.0 * last - signal[at]);
        let mut whole: Vec<f64> = before.chain(signal.iter().copied()).chain(after).collect();
        for _ in 0..2 {
            self.pass(&mut whole);
            whole.reverse();
        }
        whole[beyond..beyond + signal.len()].to_vec()
    }

    /// Filters a signal in place, forwards. Before the signal, both its input and its output are its first value.
    fn pass(&self, signal: &mut [f64]) {
        let start = signal.first().copied().unwrap_or(0.0);
        let (mut x, mut y) = ([start; 2], [start; 2]);
        for value in signal {
            let new = self.inputs[0] * *value + self.inputs[1] * x[0] + self.inputs[2] * x[1]
                - self.outputs[0] * y[0]
                - self.outputs[1] * y[1];
            (x, y) = ([*value, x[0]], [new, y[0]]);
            *value = new;
        }
    }
}

/// Derivative of an evenly sampled signal by central differences, of order 4 inside and of order 2 at the second and
/// the last but one sample. The ends have one-sided differences of order 2.
pub fn central_differences(signal: &[f64], distance: f64) -> Vec<f64> {
    let n = signal.len();
    let slope = |at: usize| match at {
        _ if n < 3 => (signal[n - 1] - signal[0]) / (distance * (n - 1).max(1) as f64),
        0 => (-3.0 * signal[0] + 4.0 * signal[1] - signal[2]) / (2.0 * distance),
        _ if at == n - 1 => (3.0 * signal[at] - 4.0 * signal[at - 1] + signal[at - 2]) / (2.0 * distance),
        _ if at == 1 || at == n - 2 => (signal[at + 1] - signal[at - 1]) / (2.0 * distance),
        _ => (8.0 * (signal[at + 1] - signal[at - 1]) - (signal[at + 2] - signal[at - 2])) / (12.0 * distance),
    };
    (0..n).map(slope).collect()
}

#[cfg(test)]
mod tests {
    use super::{LowPass, central_differences};
    use std::f64::consts::TAU;

    /// Goal: the filter passes slow waves without delay, halves those at its cut-off frequency, and stops fast ones.
    /// Method: waves whose periods fit the record; the gain of two passes is 1/(1 + tan(π f d)⁴/tan(π f_c d)⁴).
    #[test]
    fn gains_are_those_of_two_passes() {
        let (distance, cut_off) = (0.001, 20.0);
        let filter = LowPass::new(cut_off, distance).unwrap();
        for frequency in [2.0, 20.0, 100.0] {
            let wave: Vec<f64> = (0..4001).map(|at| (TAU * frequency * distance * f64::from(at)).sin()).collect();
            let found = filter.filter(&wave);
            let ratio = ((TAU / 2.0 * frequency * distance).tan() / (TAU / 2.0 * cut_off * distance).tan()).powi(4);
            for at in 1000..3000 {
                assert!((found[at] - wave[at] / (1.0 + ratio)).abs() < 1e-9, "{frequency} Hz, {at}: {}", found[at]);
            }
        }
    }

    /// Goal: a cut-off that the samples cannot show is refused.
    #[test]
    fn cut_offs_lie_below_half_of_the_sampling_frequency() {
        assert!(LowPass::new(500.0, 0.001).is_none() && LowPass::new(0.0, 0.001).is_none());
        assert!(LowPass::new(499.0, 0.001).is_some() && LowPass::new(f64::NAN, 0.001).is_none());
    }

    /// Goal: differences are exact for polynomials of their order. Method: a parabola, and a quartic inside.
    #[test]
    fn differences_are_exact_for_polynomials() {
        let at = |k: usize| 0.1 * k as f64;
        let parabola: Vec<f64> = (0..9).map(|k| 3.0 * at(k) * at(k) - at(k)).collect();
        for (k, slope) in central_differences(&parabola, 0.1).iter().enumerate() {
            assert!((slope - (6.0 * at(k) - 1.0)).abs() < 1e-12);
        }
        let quartic: Vec<f64> = (0..9).map(|k| at(k).powi(4)).collect();
        for (k, slope) in central_differences(&quartic, 0.1).iter().enumerate().take(7).skip(2) {
            assert!((slope - 4.0 * at(k).powi(3)).abs() < 1e-12);
        }
    }
}
