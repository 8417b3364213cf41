//! Schur form A = Q T Qᴴ of a real matrix in 32 digits, with its eigenvalues in any order.
//!
//! The form is computed by the shifted QR iteration on a Hessenberg matrix. A is changed only by
//! rotations. So T belongs to a matrix that differs from A by about 1e-31 of its size. Sources:
//! J. G. F. Francis, Comput. J. 4, 1961; J. H. Wilkinson, *The Algebraic Eigenvalue Problem*, 1965.

use super::wide_complex::WideComplex;
use super::wide_matrix::WideMatrix;
use tripos_traits::{DoubleDouble, Scalar};

/// Fraction of its two diagonal neighbours up to which an entry below the diagonal counts as 0.
const NOTHING: f64 = 1e-32;
/// Largest number of steps of the QR iteration for each eigenvalue.
const MOST_STEPS: usize = 200;
/// Number of steps of the QR iteration after which one exceptional shift is used.
const UNUSUAL: usize = 12;

/// Schur form A = Q T Qᴴ of a matrix, with a unitary Q and an upper triangular T.
#[derive(Clone, Debug)]
pub struct SchurForm {
    /// Upper triangular matrix T, row by row.
    pub t: Vec<Vec<WideComplex>>,
    /// Unitary matrix Q, row by row.
    pub q: Vec<Vec<WideComplex>>,
}

/// Unitary 2 × 2 matrix G, a complex plane rotation, that maps (a, b) to (r, 0).
struct Rotation([[WideComplex; 2]; 2]);

impl Rotation {
    /// Makes the rotation that maps (a, b) to (r, 0); the identity if both are 0.
    fn new(a: WideComplex, b: WideComplex) -> Self {
        let size = (a.squared_norm() + b.squared_norm()).sqrt();
        let one = WideComplex::from_f64(1.0);
        if size.hi() <= 0.0 {
            return Self([[one, WideComplex::default()], [WideComplex::default(), one]]);
        }
        let inverse = DoubleDouble::int(1) / size;
        Self([[a.conj().scaled(inverse), b.conj().scaled(inverse)], [(-b).scaled(inverse), a.scaled(inverse)]])
    }

    /// Replaces the rows k and k + 1 of a matrix M by the rows of G M, from the column `from` on.
    fn rotate_rows(&self, m: &mut [Vec<WideComplex>], k: usize, from: usize) {
        let (above, below) = m.split_at_mut(k + 1);
        for (x, y) in above[k][from..].iter_mut().zip(&mut below[0][from..]) {
            (*x, *y) = (self.0[0][0] * *x + self.0[0][1] * *y, self.0[1][0] * *x + self.0[1][1] * *y);
        }
    }

    /// Replaces the columns k and k + 1 of a matrix M by the columns of M Gᴴ, in the first `rows` rows.
    fn rotate_columns(&self, m: &mut [Vec<WideComplex>], k: usize, rows: usize) {
        let [[a, b], [c, d]] = self.0.map(|row| row.map(WideComplex::conj));
        for row in &mut m[..rows] {
            (row[k], row[k + 1]) = (row[k] * a + row[k + 1] * b, row[k] * c + row[k + 1] * d);
        }
    }
}

impl SchurForm {
    /// Computes the Schur form of a square matrix. `None` if the iteration does not converge, or if an
    /// entry is not finite.
    #[must_use]
    pub fn new(a: &WideMatrix) -> Option<Self> {
        let n = a.rows.len();
        let t: Vec<Vec<WideComplex>> =
            a.rows.iter().map(|row| row.iter().map(|x| WideComplex::real(*x)).collect()).collect();
        if t.iter().flatten().any(|x| !x.is_finite()) {
            return None;
        }
        let unit = |i| (0..n).map(|j| WideComplex::from_f64(f64::from(u8::from(i == j)))).collect();
        let mut form = Self { t, q: (0..n).map(unit).collect() };
        form.reduce_to_hessenberg();
        let size = a.rounded().norm();
        let mut last = n.saturating_sub(1);
        let mut steps = 0;
        while last > 0 {
            let first = form.active_block_start(last, size);
            if first == last {
                (last, steps) = (last - 1, 0);
                continue;
            }
            steps += 1;
            if steps > MOST_STEPS {
                return None;
            }
            let shift = if steps % UNUSUAL == 0 { form.exceptional_shift(last) } else { form.qr_shift(last) };
            form.qr_step(first, last, shift);
        }
        Some(form)
    }

    /// Reduces T to a Hessenberg matrix: rotations make all entries below its first subdiagonal 0.
    fn reduce_to_hessenberg(&mut self) {
        let n = self.t.len();
        for column in 0..n.saturating_sub(2) {
            for k in (column + 1..n - 1).rev() {
                if self.t[k + 1][column].norm() > 0.0 {
                    let rotation = Rotation::new(self.t[k][column], self.t[k + 1][column]);
                    self.apply_rotation(&rotation, k, column, n);
                    self.t[k + 1][column] = WideComplex::default();
                }
            }
        }
    }

    /// Applies a rotation G to the rows and columns k and k + 1: T becomes G T Gᴴ, and Q becomes Q Gᴴ. Only
    /// the columns of T from `from` on, and its first `rows` rows, are changed.
    fn apply_rotation(&mut self, rotation: &Rotation, k: usize, from: usize, rows: usize) {
        rotation.rotate_rows(&mut self.t, k, from);
        rotation.rotate_columns(&mut self.t, k, rows);
        let n = self.q.len();
        rotation.rotate_columns(&mut self.q, k, n);
    }

    /// Finds the first index of the diagonal block of T that ends at `last`. The subdiagonal entry before
    /// this block is negligible, and becomes 0. `size` is the norm of the matrix.
    fn active_block_start(&mut self, last: usize, size: f64) -> usize {
        let t = &mut self.t;
        for k in (1..=last).rev() {
            let beside = t[k - 1][k - 1].norm() + t[k][k].norm();
            let beside = if beside > 0.0 { beside } else { size };
            if t[k][k - 1].norm() <= NOTHING * beside {
                t[k][k - 1] = WideComplex::default();
                return k;
            }
        }
        0
    }

    /// Shift for a step of the QR iteration. It is the eigenvalue of the last 2 × 2 block that is closest to
    /// the last entry of this block.
    fn qr_shift(&self, last: usize) -> WideComplex {
        let t = &self.t;
        let (a, b, c, d) = (t[last - 1][last - 1], t[last - 1][last], t[last][last - 1], t[last][last]);
        let half = DoubleDouble::from_f64(0.5);
        let difference = (a - d).scaled(half);
        let root = (difference * difference + b * c).sqrt();
        let [plus, minus] = [difference + root, difference - root];
        let larger = if plus.norm() >= minus.norm() { plus } else { minus };
        if larger.norm() > 0.0 { d - b * c / larger } else { d }
    }

    /// Exceptional shift for an iteration that does not converge. It is no eigenvalue of the last 2 × 2
    /// block.
    fn exceptional_shift(&self, last: usize) -> WideComplex {
        self.t[last][last] + WideComplex::from_f64(self.t[last][last - 1].norm())
    }

    /// Makes a step of the QR iteration on the rows and columns from `first` to `last`, with the given
    /// shift.
    fn qr_step(&mut self, first: usize, last: usize, shift: WideComplex) {
        let n = self.t.len();
        let mut rotations = Vec::with_capacity(last - first);
        for k in first..=last {
            self.t[k][k] = self.t[k][k] - shift;
        }
        for k in first..last {
            let rotation = Rotation::new(self.t[k][k], self.t[k + 1][k]);
            rotation.rotate_rows(&mut self.t, k, k);
            self.t[k + 1][k] = WideComplex::default();
            rotations.push(rotation);
        }
        for (k, rotation) in (first..).zip(&rotations) {
            rotation.rotate_columns(&mut self.t, k, k + 2);
            rotation.rotate_columns(&mut self.q, k, n);
        }
        for k in first..=last {
            self.t[k][k] = self.t[k][k] + shift;
        }
    }

    /// Makes the Schur form of a matrix from the forms of its diagonal blocks. `blocks` are the row indices
    /// of each block. Entries to the left of a block must be 0.
    #[must_use]
    pub fn from_diagonal_blocks(a: &WideMatrix, blocks: &[Vec<usize>], forms: &[Self]) -> Self {
        let n = a.rows.len();
        let zeros = || vec![vec![WideComplex::default(); n]; n];
        let mut whole = Self { t: zeros(), q: zeros() };
        let mut first = 0;
        for (block, form) in blocks.iter().zip(forms) {
            for (row, state) in block.iter().enumerate() {
                whole.q[*state][first..first + block.len()].copy_from_slice(&form.q[row]);
                whole.t[first + row][first..first + block.len()].copy_from_slice(&form.t[row]);
            }
            first += block.len();
        }
        // Entries to the right of the blocks: T = Qᴴ A Q.
        let mut end = 0;
        let ends = blocks.iter().flat_map(|block| {
            end += block.len();
            std::iter::repeat_n(end, block.len())
        });
        let ends: Vec<usize> = ends.collect();
        let sum = |list: &mut dyn Iterator<Item = WideComplex>| list.fold(WideComplex::default(), |sum, x| sum + x);
        for (row, end) in ends.iter().enumerate() {
            let left: Vec<WideComplex> =
                (0..n).map(|j| sum(&mut (0..n).map(|i| whole.q[i][row].conj().scaled(a.rows[i][j])))).collect();
            for column in *end..n {
                whole.t[row][column] = sum(&mut (0..n).map(|j| left[j] * whole.q[j][column]));
            }
        }
        whole
    }

    /// Eigenvalues of the matrix, in the order of the diagonal of T.
    #[must_use]
    pub fn eigenvalues(&self) -> Vec<WideComplex> {
        self.t.iter().enumerate().map(|(at, row)| row[at]).collect()
    }

    /// Reorders the Schur form so that the eigenvalues with the given indices come first.
    #[must_use]
    pub fn with_eigenvalues_first(&self, places: &[usize]) -> Self {
        let mut form = self.clone();
        let mut places = places.to_vec();
        places.sort_unstable();
        for (target, place) in places.into_iter().enumerate() {
            for k in (target..place).rev() {
                let difference = form.t[k + 1][k + 1] - form.t[k][k];
                let rotation = Rotation::new(form.t[k][k + 1], difference);
                form.apply_rotation(&rotation, k, k, k + 2);
                form.t[k + 1][k] = WideComplex::default();
            }
        }
        form
    }
}
