//! Mode of a linear system: an eigenvalue with its error, multiplicity and growth.

/// Mode of a linear system: an eigenvalue with its error, its multiplicity, the growth of its
/// solutions, and the share of each state.
#[derive(Clone, Debug)]
pub struct Mode {
    /// Real and imaginary part of the eigenvalue, 1/s. A part that rounding does not distinguish from 0
    /// is exactly 0.
    pub value: [f64; 2],
    /// Factor from an error of the matrix to the largest possible error of the eigenvalue. It is the norm
    /// of the projector onto its eigenvectors. For a simple eigenvalue this is 1/|yᴴ x|, with left and
    /// right eigenvectors y and x of length 1. It is at least 1, and large if eigenvalues nearly coincide.
    pub condition: f64,
    /// Largest error that the eigenvalue may have, 1/s.
    pub error: f64,
    /// Share of each state in the mode: |y_k x_k| with left and right eigenvectors y and x, scaled so that
    /// the sum is 1.
    pub shares: Vec<f64>,
    /// Number of eigenvalues that coincide in this mode; 1 for a simple eigenvalue.
    pub multiplicity: usize,
    /// Largest power of t by which solutions of this mode grow in addition to e^(λ t). It is 0 if the
    /// coinciding eigenvalues have as many independent eigenvectors. It is k − 1 if the largest Jordan
    /// block has k rows.
    pub power: usize,
    /// Number of independent eigenvectors of the eigenvalue.
    pub vectors: usize,
    /// True if rounding leaves open if the real part is 0. Also true if it leaves open if an eigenvalue
    /// with a real part of 0 coincides with others, or if the eigenvalues do not fit the matrix.
    pub is_undecided: bool,
}

impl Mode {
    /// True if solutions of this mode grow exponentially.
    #[must_use]
    pub fn grows(&self) -> bool {
        self.value[0] > 0.0
    }

    /// True if the real part of the eigenvalue is exactly 0. Solutions then neither grow nor decay
    /// exponentially.
    #[must_use]
    pub fn is_neutral(&self) -> bool {
        self.value[0].abs() <= 0.0
    }
}
