//! Linear conditions in a metric: the least vector that meets them, what they leave of another, and which of them follow from
//! others.
//!
//! A metric M = L Lᵀ makes x into z = Lᵀ x, of which the length is that of x. Rows G of conditions G x = d are then the
//! columns of L⁻¹ Gᵀ; orthonormal axes for them are found by Gram and Schmidt, always next the row of which, by its own length, most is left
//! (P. Businger & G. H. Golub, Numer. Math. 7 (1965) 269–276). So no unit of a row matters, and what is left of a row tells how far it is from following
//! from those before it.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// What is left of a row of length 1, if it counts as following from others.
pub(crate) const DEPENDENT: f64 = 1e-8;

/// What must be left of a diagonal entry of a mass matrix that is definite.
const CLEAR: f64 = 1e-13;

/// How long vectors are.
pub(crate) enum Metric {
    /// By components, each over its weight.
    Weights(DVector<f64>),
    /// By a mass matrix, factored.
    Inertia(Cholesky<f64, Dyn>),
}

impl Metric {
    /// A mass matrix, which need not resist what the rows prevent: massless links are given an inertia there, which changes
    /// nothing of what the rows let move. `None` if something that they let move has none.
    pub(crate) fn of_inertia(mut matrix: DMatrix<f64>, rows: &DMatrix<f64>) -> Option<Self> {
        if let Some(factor) = definite(&matrix) {
            return Some(Self::Inertia(factor));
        }
        let scale = matrix.diagonal().amax();
        for row in rows.row_iter() {
            let size = row.norm_squared();
            if size > 0.0 {
                matrix += row.transpose() * row * (scale / size);
            }
        }
        definite(&matrix).map(Self::Inertia)
    }

    /// L⁻¹ times columns, which are linear forms such as forces or rows of conditions.
    pub(crate) fn raise(&self, mut forms: DMatrix<f64>) -> DMatrix<f64> {
        match self {
            Self::Weights(weights) => {
                for mut column in forms.column_iter_mut() {
                    column.component_mul_assign(weights);
                }
            }
            Self::Inertia(factor) => {
                factor.l_dirty().solve_lower_triangular_mut(&mut forms);
            }
        }
        forms
    }

    /// x = L⁻ᵀ z.
    pub(crate) fn vector(&self, mut z: DVector<f64>) -> DVector<f64> {
        match self {
            Self::Weights(weights) => z.component_mul_assign(weights),
            Self::Inertia(factor) => {
                factor.l_dirty().tr_solve_lower_triangular_mut(&mut z);
            }
        }
        z
    }
}

/// The factor of a matrix that is definite by more than rounding.
fn definite(matrix: &DMatrix<f64>) -> Option<Cholesky<f64, Dyn>> {
    let factor = matrix.clone().cholesky()?;
    let diagonal = factor.l_dirty().diagonal();
    let is_clear = diagonal.iter().zip(matrix.diagonal().iter()).all(|(l, m)| l * l > CLEAR * m);
    is_clear.then_some(factor)
}

/// Rows of conditions in a metric.
pub(crate) struct Conditions {
    /// Orthonormal, a column for each row that is kept.
    axes: DMatrix<f64>,
    /// The rows that are kept, in the order in which they were taken.
    kept: Vec<usize>,
    /// Each of them along the axes up to its own.
    along: Vec<Vec<f64>>,
    /// The length of each row.
    pub(crate) sizes: Vec<f64>,
    /// What is left of each row beside those taken before it.
    pub(crate) left: Vec<f64>,
}

impl Conditions {
    /// These rows; those of which no more than `dependent` is left are not kept.
    pub(crate) fn new(metric: &Metric, rows: &DMatrix<f64>, dependent: f64) -> Self {
        let forms = metric.raise(rows.transpose());
        let mut left = forms.clone();
        let sizes: Vec<f64> = left.column_iter().map(|column| column.norm()).collect();
        let mut open: Vec<usize> = (0..rows.nrows()).collect();
        let mut found = Self {
            axes: DMatrix::zeros(forms.nrows(), 0),
            kept: Vec::new(),
            along: Vec::new(),
            left: sizes.clone(),
            sizes,
        };
        let mut axes: Vec<DVector<f64>> = Vec::new();
        loop {
            for row in &open {
                found.left[*row] = left.column(*row).norm();
            }
            let part = |row: usize| found.left[row] / found.sizes[row];
            let best = open.iter().enumerate().map(|(place, row)| (place, part(*row)));
            let Some((place, most)) = best.max_by(|a, b| a.1.total_cmp(&b.1)) else { break };
            // A row of zeros is no condition: 0/0 is not a number.
            if most.is_nan() || most <= dependent {
                break;
            }
            let row = open.remove(place);
            let mut axis: DVector<f64> = left.column(row).into_owned();
            // Again, for what rounding left.
            for other in &axes {
                let share = other.dot(&axis);
                axis.axpy(-share, other, 1.0);
            }
            axis.normalize_mut();
            for other in &open {
                let share = axis.dot(&left.column(*other));
                left.column_mut(*other).axpy(-share, &axis, 1.0);
            }
            axes.push(axis);
            found.kept.push(row);
            found.along.push(axes.iter().map(|axis| axis.dot(&forms.column(row))).collect());
        }
        if !axes.is_empty() {
            found.axes = DMatrix::from_columns(&axes);
        }
        found
    }

    /// Whether no row follows from others.
    pub(crate) fn is_independent(&self) -> bool {
        self.kept.len() == self.sizes.len()
    }

    /// The shortest z that meets the kept conditions with these right-hand sides, one for each row.
    pub(crate) fn least(&self, sides: &[f64]) -> DVector<f64> {
        let mut shares: Vec<f64> = Vec::with_capacity(self.kept.len());
        for (row, along) in self.kept.iter().zip(&self.along) {
            let known: f64 = along.iter().zip(&shares).map(|(a, share)| a * share).sum();
            shares.push((sides[*row] - known) / along[shares.len()]);
        }
        &self.axes * DVector::from_vec(shares)
    }

    /// What the kept conditions leave of vectors z: their parts across all axes.
    pub(crate) fn free(&self, z: DMatrix<f64>) -> DMatrix<f64> {
        let shares = self.axes.tr_mul(&z);
        z - &self.axes * shares
    }
}

/// What to take from (q, q̇) to meet constraints with this drift and these gradients, a row each: M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁻¹ drift of coordinates, by the
/// constraints between them, then of their rates, by the others, whose drift the first has changed. `clock` is the coordinate that
/// stays. `None` if the mass matrix, row by row, is not definite on what the constraints leave.
pub(crate) fn correction(
    inertia: &[f64],
    gradients: &DMatrix<f64>,
    drift: &[f64],
    clock: Option<usize>,
) -> Option<Vec<f64>> {
    let n = gradients.ncols() / 2;
    let moved: Vec<usize> = (0..n).filter(|i| Some(*i) != clock).collect();
    let inertia = DMatrix::from_row_slice(n, n, inertia).select_rows(&moved).select_columns(&moved);
    let rates: Vec<usize> = moved.iter().map(|i| n + i).collect();
    let of_rates = gradients.select_columns(&rates);
    let (second, first): (Vec<usize>, Vec<usize>) =
        (0..gradients.nrows()).partition(|k| of_rates.row(*k).iter().any(|x| *x != 0.0));
    let least = |rows: &DMatrix<f64>, sides: &[f64]| {
        let metric = Metric::of_inertia(inertia.clone(), rows)?;
        Some(metric.vector(Conditions::new(&metric, rows, DEPENDENT).least(sides)))
    };
    let drift = |rows: &[usize]| DVector::from_iterator(rows.len(), rows.iter().map(|k| drift[*k]));
    let along = gradients.select_columns(&moved);
    let q = least(&along.select_rows(&first), drift(&first).as_slice())?;
    let left = drift(&second) - along.select_rows(&second) * &q;
    let v = least(&of_rates.select_rows(&second), left.as_slice())?;
    let mut correction = vec![0.0; 2 * n];
    for (place, i) in moved.iter().enumerate() {
        (correction[*i], correction[n + i]) = (q[place], v[place]);
    }
    Some(correction)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(list: &[[f64; 3]]) -> DMatrix<f64> {
        DMatrix::from_row_slice(list.len(), 3, list.as_flattened())
    }

    /// Truth: of all corrections that meet G x = d the one with the least xᵀ M x is M⁻¹ Gᵀ (G M⁻¹ Gᵀ)⁻¹ d.
    #[test]
    fn the_least_correction_is_that_of_the_multipliers() {
        let m = rows(&[[4.0, 1.0, 0.0], [1.0, 3.0, -1.0], [0.0, -1.0, 2.0]]);
        let g = rows(&[[1.0, 2.0, 0.5], [0.0, 1.0, -1.0]]);
        let d = DVector::from_vec(vec![0.3, -0.7]);
        let inverse = m.clone().try_inverse().unwrap();
        let compliance = (&g * &inverse * g.transpose()).try_inverse().unwrap();
        let truth = &inverse * g.transpose() * compliance * &d;
        let metric = Metric::of_inertia(m, &g).unwrap();
        let conditions = Conditions::new(&metric, &g, DEPENDENT);
        let found = metric.vector(conditions.least(d.as_slice()));
        assert!(conditions.is_independent() && (found - truth).norm() < 1e-15);
    }

    /// A third row that is a sum of two others, in another unit, changes nothing.
    #[test]
    fn a_row_that_follows_from_others_is_left_out() {
        let g = rows(&[[1.0, 2.0, 0.5], [0.0, 1.0, -1.0], [1e6, 1e6, 1.5e6]]);
        let metric = Metric::Weights(DVector::from_vec(vec![1.0, 2.0, 0.5]));
        let all = Conditions::new(&metric, &g, DEPENDENT);
        let two = Conditions::new(&metric, &g.rows(0, 2).into_owned(), DEPENDENT);
        let (d, more) = ([0.3, -0.7], [0.3, -0.7, 1e6]);
        assert!(!all.is_independent() && all.left.iter().any(|left| *left < 1e-8) && two.is_independent());
        assert!((all.least(&more) - two.least(&d)).norm() < 1e-14);
        let z = DMatrix::from_column_slice(3, 1, &[1.0, 1.0, 1.0]);
        assert!((all.free(z.clone()) - two.free(z)).norm() < 1e-14);
    }

    /// A mass of zero along what a row prevents is no hindrance, one along what none prevents is.
    #[test]
    fn a_massless_link_is_held_by_its_row() {
        let m = rows(&[[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 0.0]]);
        let held = rows(&[[1.0, 0.0, -1.0]]);
        let metric = Metric::of_inertia(m.clone(), &held).unwrap();
        let x = metric.vector(Conditions::new(&metric, &held, DEPENDENT).least(&[1.0]));
        // All of it is the link's, which nothing resists.
        assert!((x[0] - x[2] - 1.0).abs() < 1e-14 && x[0].abs() < 1e-14, "{x}");
        assert!(Metric::of_inertia(m, &rows(&[[1.0, 0.0, 0.0]])).is_none());
    }
}
