//! Arithmetic of vectors of any length: dot product, sum and scaling.

/// Dot product of two vectors.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Adds a · x to the vector y in place.
pub(super) fn axpy(a: f64, x: &[f64], y: &mut [f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += a * x;
    }
}

/// Scales a vector to the length 1, in place. A vector of zeros becomes NaN.
pub(super) fn normalize_vector(x: &mut [f64]) {
    let size = dot(x, x).sqrt();
    for x in x {
        *x /= size;
    }
}

/// Multiplies each component of `x` by the same component of `by`, in place.
pub(super) fn scale_vector_components(x: &mut [f64], by: &[f64]) {
    for (x, by) in x.iter_mut().zip(by) {
        *x *= by;
    }
}
