//! Zeros of functions with a proof: balls that contain exactly one common zero.
//!
//! Method: R. Krawczyk, "Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken", Computing 4 (1969)
//! 187–201. If x − C F(x) + (1 − C F′(X)) (X − x) lies inside of X, then X contains exactly one zero of F.

use nalgebra::DMatrix;
use tripos_traits::{Ball, Centre, DoubleDouble};

/// Number of times that the ball around an approximate zero is enlarged.
const TRIALS: usize = 4;

/// Balls that contain exactly one common zero of as many functions as unknowns. `None` if this is not proved.
///
/// `middle` is an approximate zero, `residuals` are the values of the functions in balls, and `slopes` their
/// derivatives, row by row: a row for each function, a column for each unknown.
pub fn enclose_zero(
    middle: &[DoubleDouble],
    residuals: impl Fn(&[Ball]) -> Vec<Ball>,
    slopes: impl Fn(&[Ball<f64>]) -> Vec<Ball<f64>>,
) -> Option<Vec<Ball>> {
    let n = middle.len();
    let points: Vec<Ball> = middle.iter().map(|x| Ball::point(*x)).collect();
    let narrow = |x: &[Ball]| x.iter().map(|x| Ball::narrowed(*x)).collect::<Vec<Ball<f64>>>();
    let open = residuals(&points);
    let rows = slopes(&narrow(&points));
    if open.len() != n || rows.len() != n * n {
        return None;
    }
    let inverse = DMatrix::from_fn(n, n, |row, column| rows[row * n + column].centre).try_inverse()?;
    let steps: Vec<f64> = (0..n).map(|row| product(&inverse, row, |k| open[k]).size()).collect();
    let mut radii: Vec<f64> = steps.iter().map(|step| 2.0 * step + f64::MIN_POSITIVE).collect();
    for _ in 0..TRIALS {
        let found: Vec<Ball> = middle.iter().zip(&radii).map(|(x, radius)| Ball::around(*x, *radius)).collect();
        let rows = slopes(&narrow(&found));
        let moved = |row: usize| {
            let rest = (0..n).map(|column| {
                let unit = Ball::point(f64::from(u8::from(column == row)));
                let entry = unit - product(&inverse, row, |k| rows[k * n + column]);
                Ball::point(entry.size()) * Ball::point(radii[column])
            });
            rest.fold(Ball::point(steps[row]), |sum, term| sum + term).high()
        };
        let needed: Vec<f64> = (0..n).map(moved).collect();
        if needed.iter().zip(&radii).all(|(needed, radius)| needed < radius) {
            return Some(found);
        }
        radii = needed.iter().map(|needed| 2.0 * needed).collect();
    }
    None
}

/// Ball of Σ_k C_row,k b_k for the entries b of a column.
fn product<C: Centre>(matrix: &DMatrix<f64>, row: usize, entry: impl Fn(usize) -> Ball<C>) -> Ball<C> {
    let terms = (0..matrix.ncols()).map(|k| Ball::point(C::from_f64(matrix[(row, k)])) * entry(k));
    terms.fold(Ball::point(C::from_f64(0.0)), |sum, term| sum + term)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tripos_traits::Scalar;

    /// Ball of x² − a, and its derivative, for the unknown x.
    fn square_less(a: Ball, middle: f64) -> Option<Vec<Ball>> {
        let residuals = |x: &[Ball]| vec![x[0] * x[0] - a];
        enclose_zero(&[middle.into()], residuals, |x| vec![x[0] + x[0]])
    }

    /// Goal: the ball contains the zero and is narrow. Method: √2 and the square roots of a wider ball.
    #[test]
    fn simple_zeros_are_enclosed() {
        let middle = DoubleDouble::from(2.0).sqrt();
        let two = Ball::point(DoubleDouble::from(2.0));
        let found = enclose_zero(&[middle], |x| vec![x[0] * x[0] - two], |x| vec![x[0] + x[0]]).unwrap();
        let square = found[0] * found[0];
        assert!(square.contains(two) && found[0].radius < 1e-30, "{found:?}");
        let found = square_less(two.widened(1e-3), 1.414).unwrap();
        assert!(found[0].low() < 1.9991_f64.sqrt() && found[0].high() > 2.0009_f64.sqrt(), "{found:?}");
        assert!(found[0].radius < 5e-3, "{found:?}");
    }

    /// Goal: nothing is claimed of zeros that may not exist. Method: a double zero, none, and too many functions.
    #[test]
    fn doubtful_zeros_are_not_enclosed() {
        let zero = Ball::point(DoubleDouble::from(0.0));
        assert!(square_less(zero, 0.0).is_none());
        assert!(square_less(Ball::point(DoubleDouble::from(-1.0)), 0.1).is_none());
        let twice = |x: &[Ball]| vec![x[0], x[0]];
        assert!(enclose_zero(&[0.0.into()], twice, |_| vec![Ball::point(1.0); 2]).is_none());
    }
}
