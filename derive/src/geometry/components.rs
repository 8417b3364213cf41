//! Components of vectors in one frame, and products of such vectors.

use crate::algebra::{Arena, Expr};

/// Components of a vector along the three axes of one frame.
pub type Components = [Expr; 3];

/// Cross product a × b of two vectors with components in one frame.
pub fn cross_components(arena: &mut Arena, a: &Components, b: &Components) -> Components {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k)| {
        let (plus, minus) = (arena.mul(a[j], b[k]), arena.mul(a[k], b[j]));
        arena.sub(plus, minus)
    })
}

/// Product A · v of a 3 × 3 tensor A and a vector v, both with components in one frame.
pub fn apply_tensor(arena: &mut Arena, tensor: &[[Expr; 3]; 3], v: &Components) -> Components {
    tensor.map(|row| dot_components(arena, &row, v))
}

/// Scalar product Σ row_i v_i of a matrix row and a vector of three components.
pub(crate) fn dot_components(arena: &mut Arena, row: &[Expr; 3], v: &Components) -> Expr {
    let products = [0, 1, 2].map(|i| arena.mul(row[i], v[i]));
    arena.sum(&products)
}

/// Transpose of a 3 × 3 matrix, given by its rows.
pub fn transposed(rows: &[Components; 3]) -> [Components; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| rows[j][i]))
}
