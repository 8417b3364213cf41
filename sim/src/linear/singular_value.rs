//! Smallest singular value of a set of vectors, which measures their nearness to linear dependence.
//!
//! The vectors are rotated, two at a time, until all are orthogonal: their lengths are then the singular values (M. R.
//! Hestenes, J. SIAM 6 (1958) 51–90). Small singular values are found as exactly as large ones, and nothing is
//! allocated.

use super::vector_arithmetic::dot;

/// Largest number of rounds over all pairs of vectors in the search for singular values.
const ROUNDS: usize = 30;

/// Smallest singular value of the matrix whose rows are these vectors. They lie one after another, each with `length`
/// entries, and are overwritten. NaN if an entry is NaN; infinite if there are no vectors.
pub(crate) fn least_singular_value(vectors: &mut [f64], length: usize) -> f64 {
    let count = vectors.len() / length.max(1);
    for _ in 0..ROUNDS {
        let mut is_done = true;
        for first in 0..count {
            for second in first + 1..count {
                let (a, b) = vectors.split_at_mut(second * length);
                is_done &= !rotate_to_orthogonal(&mut a[first * length..(first + 1) * length], &mut b[..length]);
            }
        }
        if is_done {
            break;
        }
    }
    let sizes = vectors.chunks_exact(length.max(1)).map(|vector| dot(vector, vector).sqrt());
    sizes.fold(f64::INFINITY, |least, size| if size < least || size.is_nan() { size } else { least })
}

/// Rotates two vectors in their plane until they are orthogonal. Returns false and changes nothing if they already were
/// orthogonal, or if an entry is NaN.
fn rotate_to_orthogonal(a: &mut [f64], b: &mut [f64]) -> bool {
    let (aa, bb, ab) = (dot(a, a), dot(b, b), dot(a, b));
    let bound = f64::EPSILON * (aa * bb).sqrt();
    // Vectors with an entry NaN are left unchanged.
    if ab.abs() <= bound || ab.is_nan() || bound.is_nan() {
        return false;
    }
    let zeta = (bb - aa) / (2.0 * ab);
    let tangent = zeta.signum() / (zeta.abs() + zeta.hypot(1.0));
    let cosine = tangent.hypot(1.0).recip();
    let sine = cosine * tangent;
    for (a, b) in a.iter_mut().zip(b) {
        (*a, *b) = (cosine * *a - sine * *b, sine * *a + cosine * *b);
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DMatrix;

    /// The smallest singular value equals that of another algorithm. Truth: √2 sin(φ/2) for two unit vectors at an
    /// angle φ.
    #[test]
    fn the_least_singular_value_is_that_of_another_algorithm() {
        let mut seed = 1_u64;
        let mut random = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 40) as f64 / 16_777_216.0 - 0.5
        };
        for (count, length) in [(1, 1), (1, 4), (2, 5), (3, 3), (4, 7)] {
            let vectors: Vec<f64> = (0..count * length).map(|_| random()).collect();
            let truth = DMatrix::from_row_slice(count, length, &vectors).singular_values().min();
            let found = least_singular_value(&mut vectors.clone(), length);
            assert!((found - truth).abs() < 1e-15, "{count} {length}: {found} {truth}");
        }
        let angle = 1e-9_f64;
        let found = least_singular_value(&mut [1.0, 0.0, angle.cos(), angle.sin()], 2);
        assert!((found / (2.0_f64.sqrt() * (0.5 * angle).sin()) - 1.0).abs() < 1e-6, "{found:e}");
        assert!(least_singular_value(&mut [1.0, f64::NAN, 0.0, 1.0], 2).is_nan());
        assert_eq!(least_singular_value(&mut [], 3), f64::INFINITY);
    }
}
