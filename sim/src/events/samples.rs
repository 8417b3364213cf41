//! Samples of an event function in a step, and tests for zeros that lie between the samples.

use std::iter::once;

/// Sign of an event function: −1 below zero, 0 within rounding of zero, 1 above zero.
pub(crate) type Sign = i8;

/// Sign of the value `g` of an event function: −1, 0 or 1. Absolute values up to `tolerance` count as zero.
pub(crate) fn sign_of_sample(g: f64, tolerance: f64) -> Sign {
    if g.abs() <= tolerance {
        0
    } else if g > 0.0 {
        1
    } else {
        -1
    }
}

/// Sign of the value `g` of an event function; 0 if `g` is not a number, or if |g| is at most `tolerance`.
pub(super) fn sign_or_zero(g: f64, tolerance: f64) -> Sign {
    if g.is_nan() { 0 } else { sign_of_sample(g, tolerance) }
}

/// Sample of an event function in a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Node {
    /// Fraction of the step at which the sample is taken.
    pub(crate) theta: f64,
    /// Value of the event function at the sample.
    pub(crate) g: f64,
    /// Sign with which the sample counts; 0 if the value is zero within rounding.
    pub(crate) sign: Sign,
}

/// Fraction of the step of the sample with the smallest |g|; `None` without samples.
pub(super) fn sample_nearest_to_zero(nodes: &[Node]) -> Option<f64> {
    nodes.iter().min_by(|a, b| a.g.abs().total_cmp(&b.g.abs())).map(|n| n.theta)
}

/// True if all samples of an event function have the same sign, and their distance from zero is more than 4 times their
/// variation. This is a shortcut for the usual case.
pub(super) fn samples_are_far_from_zero(nodes: &[Node]) -> bool {
    let low = nodes.iter().map(|n| n.g).fold(f64::INFINITY, f64::min);
    let high = nodes.iter().map(|n| n.g).fold(f64::NEG_INFINITY, f64::max);
    low.max(-high) > 4.0 * (high - low)
}

/// True if |g| may reach zero between samples k − 1 and k: it has a minimum there, and both samples are
/// on the same side of zero.
pub(crate) fn samples_may_hide_zero(nodes: &[Node], k: usize) -> bool {
    let (a, b) = (nodes[k - 1], nodes[k]);
    if a.sign == 0 || a.sign != b.sign {
        return false;
    }
    let side = f64::from(a.sign);
    let (slope_a, slope_b) = (side * slope_at_sample(nodes, k - 1), side * slope_at_sample(nodes, k));
    // A convex function stays above its tangents. The factor 4 leaves a margin for functions that are not convex.
    let fall = slope_b.max(-slope_a) * (b.theta - a.theta);
    slope_a <= 0.0 && slope_b >= 0.0 && a.g.abs().min(b.g.abs()) <= 4.0 * fall
}

/// Fractions of the step between samples k − 1 and k at which the polynomial through the samples has extrema, with the
/// midpoints between neighbouring extrema. Empty if there are fewer than two extrema: the slopes at the two samples
/// reveal a single extremum.
pub(crate) fn hidden_extrema(nodes: &[Node], k: usize) -> Vec<f64> {
    const PARTS: u32 = 8;
    let (a, b) = (nodes[k - 1].theta, nodes[k].theta);
    let width = (b - a) / f64::from(PARTS);
    let points = (0..=PARTS).map(|i| a + width * f64::from(i));
    let values: Vec<f64> = points.map(|theta| interpolate_samples(samples_near(nodes, k), theta)).collect();
    let rises = values.windows(2).map(|v| v[1] - v[0]);
    let slopes: Vec<f64> =
        once(slope_at_sample(nodes, k - 1)).chain(rises).chain(once(slope_at_sample(nodes, k))).collect();
    // Slope 0 is the slope at sample a, slope i is that in the middle of part i, and the last slope is that at sample
    // b.
    let turns = slopes.windows(2).enumerate().filter(|(_, s)| s[0] * s[1] < 0.0);
    let extrema: Vec<f64> = turns.map(|(i, _)| a + width * (i as f64).clamp(0.25, f64::from(PARTS) - 0.25)).collect();
    // At the midpoint of two extrema the function is between the values at the two.
    extrema.windows(2).flat_map(|e| [e[0], f64::midpoint(e[0], e[1]), e[1]]).collect()
}

/// Five samples around sample i. If g is linear in the state and does not depend on t, the polynomial through them is g
/// itself, since the dense output of `ode45` has degree 4.
fn samples_near(nodes: &[Node], i: usize) -> &[Node] {
    let low = i.saturating_sub(2).min(nodes.len().saturating_sub(5));
    &nodes[low..(low + 5).min(nodes.len())]
}

/// Value of the polynomial through the samples at the fraction `theta` of the step, by Lagrange's formula.
fn interpolate_samples(nodes: &[Node], theta: f64) -> f64 {
    let others = |j: usize| nodes.iter().enumerate().filter(move |(m, _)| *m != j).map(|(_, n)| n.theta);
    let term = |(j, n): (usize, &Node)| n.g * others(j).map(|x| (theta - x) / (n.theta - x)).product::<f64>();
    nodes.iter().enumerate().map(term).sum()
}

/// Slope dg/dθ at sample i of the polynomial through the samples near it, by the fraction θ of the step.
fn slope_at_sample(nodes: &[Node], i: usize) -> f64 {
    let at = nodes[i];
    // Σ over the other samples j of (g_j − g_i) / (x_j − x_i) · Π over the remaining m of (x_i − x_m) / (x_j − x_m)
    let others = || samples_near(nodes, i).iter().filter(|n| n.theta.total_cmp(&at.theta).is_ne());
    let term = |j: &Node| {
        let rest = others().filter(|m| m.theta.total_cmp(&j.theta).is_ne());
        let weight: f64 = rest.map(|m| (at.theta - m.theta) / (j.theta - m.theta)).product();
        weight * (j.g - at.g) / (j.theta - at.theta)
    };
    others().map(term).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slope_of_a_quartic_is_exact_at_every_sample() {
        let p = |x: f64| x.powi(4) - 3.0 * x.powi(3) + x;
        let thetas = [0.0, 1e-8, 0.125, 0.25, 0.5, 0.75, 0.875];
        let nodes = thetas.map(|theta| Node { theta, g: p(theta), sign: 1 });
        for i in 0..nodes.len() {
            let x = nodes[i].theta;
            let exact = 4.0 * x.powi(3) - 9.0 * x * x + 1.0;
            // Neighbouring samples 1e-8 apart lose half of the digits.
            assert!((slope_at_sample(&nodes, i) - exact).abs() < 1e-6, "{i}");
        }
    }
}
