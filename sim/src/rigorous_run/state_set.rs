//! Sets of states: a centre and an orthonormal basis with a spread along each of its vectors.
//!
//! Method: R. J. Lohner, "Enclosing the solutions of ordinary initial and boundary value problems", in
//! *Computerarithmetic* (Teubner, 1987) 255–286: the basis turns with the flow, so that a set does not grow by
//! being wrapped into boxes. Unlike there, the vectors keep their order. So the products of all steps stay
//! triangular, and the spreads grow like the motions themselves. With an order by length, the box of the report's
//! disk is 10⁷ times as wide after eight seconds.

use tripos_traits::{Ball, DoubleDouble, larger};

/// Factor that bounds the rounding of a few operations on positive doubles.
const UP: f64 = 1.0 + 16.0 * f64::EPSILON;

/// Set of all states c + Q e with |e_j| ≤ spread_j: c is the centre, and Q has nearly orthonormal columns.
#[derive(Clone, Debug)]
pub(crate) struct StateSet {
    /// Centre c of the set, a point.
    pub(crate) centre: Vec<DoubleDouble>,
    /// Columns of the matrix Q of the directions.
    directions: Vec<Vec<f64>>,
    /// Largest distance along each direction, not negative.
    spread: Vec<f64>,
}

impl StateSet {
    /// Smallest set of this form that contains a box of states. `is_last` says which components get the last
    /// directions, by index. A component that moves alike in all states, such as the time, then stays alone in
    /// its direction.
    pub(crate) fn of_box(state: &[Ball], is_last: impl Fn(usize) -> bool) -> Self {
        let n = state.len();
        let mut order: Vec<usize> = (0..n).collect();
        order.sort_by_key(|at| is_last(*at));
        let unit = |at: &usize| (0..n).map(|row| f64::from(u8::from(row == *at))).collect();
        Self {
            centre: state.iter().map(|x| x.centre).collect(),
            directions: order.iter().map(unit).collect(),
            spread: order.iter().map(|at| state[*at].radius).collect(),
        }
    }

    /// Box that contains the set.
    pub(crate) fn bounds(&self) -> Vec<Ball> {
        let radius = |row: usize| {
            let terms = self.directions.iter().zip(&self.spread).map(|(direction, e)| direction[row].abs() * e);
            terms.sum::<f64>() * rounding_up(self.spread.len()) + f64::MIN_POSITIVE
        };
        self.centre.iter().enumerate().map(|(row, c)| Ball::around(*c, radius(row))).collect()
    }

    /// Image of the set under a map. `image` contains the image of the centre, and `slopes` contains the
    /// derivatives of the map in the whole set, row by row.
    ///
    /// The image is c + J Q e + d, where d is the radius of the centre's image. Its spread along the new basis B is
    /// B⁻¹ (J Q e + d), and B⁻¹ = (1 − E)⁻¹ Bᵀ with E = 1 − Bᵀ B, which is tiny.
    pub(crate) fn image(&self, image: &[Ball], slopes: &[Ball<f64>]) -> Self {
        let n = self.centre.len();
        let moved: Vec<Vec<Ball<f64>>> =
            self.directions.iter().map(|direction| slopes.chunks(n).map(|row| dot(direction, row)).collect()).collect();
        let middles = moved.iter().map(|column| column.iter().map(|x| x.centre).collect()).collect();
        let directions = orthonormal(middles);
        let up = rounding_up(2 * n);
        let mut spread = Vec::with_capacity(n);
        let mut defect = 0.0_f64;
        for (at, direction) in directions.iter().enumerate() {
            let along = moved.iter().zip(&self.spread).map(|(column, e)| dot(direction, column).size() * e);
            let of_image = direction.iter().zip(image).map(|(x, image)| x.abs() * image.radius);
            spread.push((along.sum::<f64>() + of_image.sum::<f64>()) * up);
            let row = directions.iter().enumerate().map(|(other, column)| {
                let points: Vec<Ball<f64>> = column.iter().map(|x| Ball::point(*x)).collect();
                (dot(direction, &points) - Ball::point(f64::from(u8::from(at == other)))).size()
            });
            defect = larger(defect, row.sum::<f64>() * up);
        }
        let largest = spread.iter().copied().fold(0.0, larger);
        let rest = if defect < 0.5 { largest * (defect / (1.0 - defect)) * UP } else { f64::INFINITY };
        Self {
            centre: image.iter().map(|x| x.centre).collect(),
            directions,
            spread: spread.iter().map(|e| (e + rest) * UP + f64::MIN_POSITIVE).collect(),
        }
    }
}

/// Factor that bounds the rounding of a sum of `terms` products of positive doubles.
fn rounding_up(terms: usize) -> f64 {
    UP + 2.0 * terms as f64 * f64::EPSILON
}

/// Ball of Σ a_k b_k.
fn dot(a: &[f64], b: &[Ball<f64>]) -> Ball<f64> {
    let terms = a.iter().zip(b).filter(|(x, y)| **x != 0.0 || !y.is_defined()).map(|(x, y)| Ball::point(*x) * *y);
    terms.reduce(|sum, term| sum + term).unwrap_or(Ball::point(0.0))
}

/// Orthonormal vectors that span, one after the other, the same spaces as the given vectors. Nothing depends on
/// their rounding. A component that is 0 in all vectors up to one of them stays exactly 0 there.
fn orthonormal(vectors: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let n = vectors.len();
    let mut found: Vec<Vec<f64>> = Vec::with_capacity(n);
    for vector in vectors {
        // Vectors that lie in the space of the earlier ones are replaced by any other.
        let units = (0..n).map(|at| (0..n).map(|row| f64::from(u8::from(row == at))).collect());
        let next = std::iter::once(vector).chain(units).find_map(|candidate| unit_beside(&found, candidate));
        found.extend(next);
    }
    found
}

/// Unit vector in the direction of the part of `vector` that is normal to the given unit vectors. `None` if that
/// part is too small.
fn unit_beside(found: &[Vec<f64>], mut vector: Vec<f64>) -> Option<Vec<f64>> {
    let largest = vector.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    if !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    for x in &mut vector {
        *x /= largest;
    }
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let before = product(&vector, &vector).sqrt();
    // The second pass removes what rounding left in the first.
    for _ in 0..2 {
        for other in found {
            let along = product(other, &vector);
            vector.iter_mut().zip(other).for_each(|(x, y)| *x -= along * y);
        }
    }
    let length = product(&vector, &vector).sqrt();
    (length > 1e-12 * before).then(|| vector.iter().map(|x| x / length).collect())
}
