//! Linear system near a steady motion whose loops are closed. States that symmetries shift are left out.

use super::SteadyProblem;
use super::spectra::wide_matrix::{WideMatrix, least_squares, null_space};
use super::steady_state::SteadyState;
use crate::Error;
use nalgebra::{DMatrix, DVector};
use tripos_derive::flow::FlowProgramResults;
use tripos_traits::{DoubleDouble, Scalar};

/// Pivot up to which columns count as dependent, as a fraction of the largest entry of a column.
const DEPENDENT: f64 = 1e-9;

/// Linear system d' = A d + B r, y = C d + D r near a steady motion. d are the differences of the kept
/// states, r the inputs and y the outputs.
#[derive(Clone, Debug)]
pub struct QuotientSystem {
    /// Indices of the states that remain in the linear system.
    pub kept: Vec<usize>,
    /// Indices of the states that are determined by closed loops, and left out of the linear system.
    pub closed: Vec<usize>,
    /// Indices of the states that symmetries shift and that are left out. No kept state depends on
    /// them.
    pub shifted: Vec<usize>,
    /// Indices of the symmetries that shift the states in `shifted`. No output depends on these shifts.
    pub(super) symmetries: Vec<usize>,
    /// Matrix A, square, with rows and columns in the order of `kept`.
    pub a: WideMatrix,
    /// Matrix B, with a row for each kept state and a column for each input.
    pub b: WideMatrix,
    /// Matrix C, with a row for each output and a column for each kept state.
    pub c: WideMatrix,
    /// Matrix D, with a row for each output and a column for each input.
    pub d: WideMatrix,
}

/// Choice if the states that symmetries shift stay in the linear system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShiftedStates {
    /// States that a symmetry shifts, such as cyclic coordinates, stay in the linear system.
    Kept,
    /// Shifted states are left out of the linear system, unless an output depends on them.
    LeftOut,
}

impl SteadyProblem {
    /// Computes the linear system near a steady motion. `shifted` tells if states that symmetries shift
    /// stay in it.
    ///
    /// # Errors
    /// `Error::Stopped` if a slope is not finite, or if the loops are dependent in this pose.
    pub(super) fn quotient(&self, steady: &SteadyState, shifted: ShiftedStates) -> Result<QuotientSystem, Error> {
        let sizes = self.program.sizes;
        let (values, slopes) = self.program.all_slopes(&self.wide, &self.parameters, &steady.x);
        let (by_state, by_input) = slopes.split_at(sizes.states);
        let moving = |slope: &FlowProgramResults<DoubleDouble>| {
            let mut column = slope.flow.clone();
            for (c, zeta) in steady.along.iter().zip(&slope.symmetries) {
                column.iter_mut().zip(zeta).for_each(|(rate, component)| *rate = *rate - *c * *component);
            }
            column
        };
        let columns = |list: &[FlowProgramResults<DoubleDouble>]| list.iter().map(moving).collect::<Vec<_>>();
        let outputs = |list: &[FlowProgramResults<DoubleDouble>]| {
            let list: Vec<_> = list.iter().map(|slope| slope.outputs.clone()).collect();
            WideMatrix::from_columns(sizes.outputs, &list)
        };
        let loops = |list: &[FlowProgramResults<DoubleDouble>]| {
            let list: Vec<_> = list.iter().map(|slope| slope.loops[..sizes.ties].to_vec()).collect();
            WideMatrix::from_columns(sizes.ties, &list)
        };
        let all = QuotientSystem {
            kept: (0..sizes.states).collect(),
            closed: Vec::new(),
            shifted: Vec::new(),
            symmetries: Vec::new(),
            a: WideMatrix::from_columns(sizes.states, &columns(by_state)),
            b: WideMatrix::from_columns(sizes.states, &columns(by_input)),
            c: outputs(by_state),
            d: outputs(by_input),
        };
        let is_finite = |wide: &WideMatrix| wide.rows.iter().flatten().all(|x| x.is_finite());
        if ![&all.a, &all.b, &all.c, &all.d].into_iter().all(is_finite) {
            return Err(Error::Stopped("a slope is not a finite number at this state".to_owned()));
        }
        let (closed, symmetries) = all.with_closed_loops(&loops(by_state), &loops(by_input), &values.symmetries)?;
        // A shift of time is no difference from the motion. It is left out even if shifted states are kept.
        let left_out: Vec<usize> =
            (0..sizes.symmetries).filter(|at| shifted == ShiftedStates::LeftOut || Some(*at) == self.by_time).collect();
        Ok(closed.without_shifted_states(&symmetries, &left_out, self.coordinates))
    }
}

impl QuotientSystem {
    /// Restricts the system and the symmetries to states with closed loops. `slopes` are the derivatives
    /// of the loops by the states, and `by_input` those by the inputs. Returns the restricted system and
    /// symmetries.
    ///
    /// # Errors
    /// `Error::Stopped` if the loops are dependent in this pose.
    fn with_closed_loops(
        self,
        slopes: &WideMatrix,
        by_input: &WideMatrix,
        symmetries: &[Vec<DoubleDouble>],
    ) -> Result<(Self, WideMatrix), Error> {
        let fields = WideMatrix::from_columns(self.kept.len(), symmetries);
        if slopes.rows.is_empty() {
            return Ok((self, fields));
        }
        let columns: Vec<usize> = (0..slopes.columns()).collect();
        let (found, rows) = quotient_pivots(&slopes.rounded().transpose(), &[&columns]);
        if rows.len() < slopes.rows.len() {
            let why =
                "this pose is singular: the gradients of its loops are dependent, so that its motion is not determined";
            return Err(Error::Stopped(why.to_owned()));
        }
        let rest: Vec<usize> = columns.iter().copied().filter(|at| !found.contains(at)).collect();
        let all: Vec<usize> = (0..slopes.rows.len()).collect();
        let singular = || Error::Stopped("this pose is singular: the loops cannot be solved for".to_owned());
        // The closed states depend on the kept states, and on inputs that move the loops.
        let follow = |open: &WideMatrix| {
            let open =
                WideMatrix::zeros(open.rows.len(), open.columns()).plus_product(-1.0, &identity(open.rows.len()), open);
            slopes.submatrix(&all, &found).solve(&open).ok_or_else(singular)
        };
        let (follows, follows_inputs) = (follow(&slopes.submatrix(&all, &rest))?, follow(by_input)?);
        let inputs: Vec<usize> = (0..self.b.columns()).collect();
        let outputs: Vec<usize> = (0..self.c.rows.len()).collect();
        let every: Vec<usize> = (0..fields.columns()).collect();
        let on = Self {
            a: self.a.submatrix(&rest, &rest).plus_product(1.0, &self.a.submatrix(&rest, &found), &follows),
            b: self.b.submatrix(&rest, &inputs).plus_product(1.0, &self.a.submatrix(&rest, &found), &follows_inputs),
            c: self.c.submatrix(&outputs, &rest).plus_product(1.0, &self.c.submatrix(&outputs, &found), &follows),
            d: self.d.plus_product(1.0, &self.c.submatrix(&outputs, &found), &follows_inputs),
            kept: rest.clone(),
            closed: found,
            shifted: self.shifted,
            symmetries: self.symmetries,
        };
        Ok((on, fields.submatrix(&rest, &every)))
    }

    /// Removes the states that symmetries shift, unless an output depends on them. `left_out` are the
    /// indices of these symmetries. `coordinates` is the number of coordinates among all states.
    fn without_shifted_states(self, symmetries: &WideMatrix, left_out: &[usize], coordinates: usize) -> Self {
        let every: Vec<usize> = (0..self.kept.len()).collect();
        let symmetries = &symmetries.submatrix(&every, left_out);
        let hidden = self.unobserved_symmetries(&symmetries.rounded());
        let fields = combine_columns(symmetries, &hidden);
        let (places, speeds): (Vec<usize>, Vec<usize>) =
            (0..self.kept.len()).partition(|at| self.kept[*at] < coordinates);
        let (out, columns) = quotient_pivots(&fields.rounded(), &[&places, &speeds]);
        if out.is_empty() {
            return self;
        }
        let rest: Vec<usize> = (0..self.kept.len()).filter(|at| !out.contains(at)).collect();
        let size = out.len();
        // H G_out = G_rest, by rows: G_outᵀ Hᵀ = G_restᵀ.
        let transposed = |rows: &[usize]| {
            let part = fields.submatrix(rows, &columns);
            WideMatrix { rows: (0..size).map(|c| part.rows.iter().map(|row| row[c]).collect()).collect() }
        };
        let Some(shares) = transposed(&out).solve(&transposed(&rest)) else { return self };
        let shares =
            WideMatrix { rows: (0..rest.len()).map(|r| shares.rows.iter().map(|row| row[r]).collect()).collect() };
        let inputs: Vec<usize> = (0..self.b.columns()).collect();
        let outputs: Vec<usize> = (0..self.c.rows.len()).collect();
        Self {
            a: self.a.submatrix(&rest, &rest).plus_product(-1.0, &shares, &self.a.submatrix(&out, &rest)),
            b: self.b.submatrix(&rest, &inputs).plus_product(-1.0, &shares, &self.b.submatrix(&out, &inputs)),
            c: self.c.submatrix(&outputs, &rest),
            d: self.d,
            shifted: out.iter().map(|at| self.kept[*at]).collect(),
            symmetries: columns.iter().map(|column| left_out[*column]).collect(),
            kept: rest.iter().map(|at| self.kept[*at]).collect(),
            closed: self.closed,
        }
    }

    /// Finds the combinations of symmetries on which no output depends at any time, as columns. They are
    /// the largest subspace of ker C that A maps into itself.
    fn unobserved_symmetries(&self, fields: &DMatrix<f64>) -> DMatrix<f64> {
        let count = fields.ncols();
        let seen = self.c.rounded();
        let mut basis = DMatrix::identity(count, count);
        if count == 0 || seen.nrows() == 0 {
            return basis;
        }
        let moved = self.a.rounded() * fields;
        // A G = G L.
        let l: Vec<DVector<f64>> =
            moved.column_iter().filter_map(|column| least_squares(fields, &-column, DEPENDENT)).collect();
        if l.len() < count {
            return DMatrix::zeros(count, 0);
        }
        let l = DMatrix::from_columns(&l);
        basis = &basis * null_space(&(seen * fields * &basis), DEPENDENT);
        loop {
            let outside = &l * &basis - &basis * (basis.transpose() * &l * &basis);
            let next = &basis * null_space(&outside, DEPENDENT.sqrt());
            if next.ncols() == basis.ncols() {
                return basis;
            }
            basis = next;
        }
    }
}

/// Identity matrix with n rows and columns.
fn identity(n: usize) -> WideMatrix {
    let mut one = WideMatrix::zeros(n, n);
    for (at, row) in one.rows.iter_mut().enumerate() {
        row[at] = DoubleDouble::int(1);
    }
    one
}

/// Product of the matrix `fields` and `hidden`, which combines its columns. A column that is not combined
/// with others keeps all of its digits.
fn combine_columns(fields: &WideMatrix, hidden: &DMatrix<f64>) -> WideMatrix {
    let wide = WideMatrix {
        rows: hidden.row_iter().map(|row| row.iter().map(|x| DoubleDouble::from_f64(*x)).collect()).collect(),
    };
    WideMatrix::zeros(fields.rows.len(), hidden.ncols()).plus_product(1.0, fields, &wide)
}

/// Chooses rows and columns of the largest regular square submatrix, after columns are scaled to equal
/// size. Rows of a group are chosen only after the rows of earlier groups. Returns the indices of the
/// rows, and the index of the column that belongs to each of them.
pub fn quotient_pivots(matrix: &DMatrix<f64>, groups: &[&[usize]]) -> (Vec<usize>, Vec<usize>) {
    let mut left = matrix.clone();
    for mut column in left.column_iter_mut() {
        let size = column.amax();
        if size > 0.0 {
            column /= size;
        }
    }
    let (mut rows, mut columns): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
    for group in groups {
        loop {
            let mut best = (DEPENDENT, None);
            for column in (0..left.ncols()).filter(|column| !columns.contains(column)) {
                for row in group.iter().filter(|row| !rows.contains(row)) {
                    // Of entries that are equal up to rounding, the first is chosen.
                    if left[(*row, column)].abs() > best.0 * (1.0 + 1e-6) {
                        best = (left[(*row, column)].abs(), Some((*row, column)));
                    }
                }
            }
            let Some((row, column)) = best.1 else { break };
            rows.push(row);
            columns.push(column);
            let pivot = left.column(column).into_owned();
            for other in (0..left.ncols()).filter(|other| !columns.contains(other)) {
                let factor = left[(row, other)] / pivot[row];
                for at in 0..left.nrows() {
                    left[(at, other)] -= factor * pivot[at];
                }
            }
        }
    }
    (rows, columns)
}
