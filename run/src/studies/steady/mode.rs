//! Eigenvalue of a matrix, with all that is known of it.

/// Eigenvalue with its error, its multiplicity, and the shares of the states in it.
#[derive(Clone, Debug)]
pub struct Mode {
    /// Real and imaginary part of the eigenvalue, 1/s. A part that cannot be told from 0 is 0.
    pub value: [f64; 2],
    /// Factor by which an error of the matrix may grow in the eigenvalue: the size of the projector onto its vectors.
    /// For a simple eigenvalue this is 1/|yᴴ x| with its left and right vectors y and x of length 1. It is 1 at best,
    /// and large near values that nearly coincide.
    pub condition: f64,
    /// Largest error that the eigenvalue may have, 1/s.
    pub error: f64,
    /// Share of each state in the eigenvalue: |y_k x_k|, scaled to the sum 1.
    pub shares: Vec<f64>,
    /// Number of eigenvalues that coincide with this one, itself included.
    pub multiplicity: usize,
    /// Power of t by which solutions grow in addition to e^(λ t). It is 0 if the eigenvalue has as many vectors as its
    /// multiplicity, and k − 1 if its largest Jordan block has k rows.
    pub power: usize,
    /// Number of independent eigenvectors of the eigenvalue.
    pub vectors: usize,
    /// True if the digits do not tell whether the real part is 0. Also true if it is 0 and they do not tell whether the
    /// eigenvalue coincides with others, and if the eigenvalues do not satisfy the matrix.
    pub is_undecided: bool,
}

impl Mode {
    /// True if solutions of this mode grow exponentially.
    #[must_use]
    pub fn grows(&self) -> bool {
        self.value[0] > 0.0
    }

    /// True if the real part of the eigenvalue is 0.
    #[must_use]
    pub fn is_neutral(&self) -> bool {
        self.value[0].abs() <= 0.0
    }
}
