//! Elementary rotations (turns) that lead from a frame to the next frame.

use super::components::{Components, dot_components, transposed};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::Differential;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Rational};

/// Rotation that leads from a frame to the next frame of the chain.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Turn {
    /// Rotation about an axis that both frames share: the axis (0, 1 or 2) and the angle, rad.
    About(usize, Expr),
    /// General rotation, given by its direction cosines.
    Oriented(Box<Oriented>),
}

/// A general rotation from an old frame to a new frame, given by its direction cosines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Oriented {
    /// Direction cosines, a 3 × 3 matrix C. Components in the new frame are C times the components
    /// in the old frame.
    pub cosines: [Components; 3],
    /// Angular velocity of the new frame relative to the old frame, as pairs (quantity, factor).
    /// The angular velocity, rad/s, is the sum of rate of the quantity times factor, with
    /// components in the new frame. Empty for a constant rotation.
    pub spins: Vec<(Expr, Components)>,
}

/// Direction in which a rotation between two frames is applied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TurnSense {
    /// From the frame before the rotation to the frame after the rotation.
    Forward,
    /// From the frame after the rotation to the frame before the rotation.
    Back,
}

impl Turn {
    /// True if the rotation only permutes components and changes their signs: all its direction cosines
    /// are 0, 1 or −1.
    pub(crate) fn is_axis_permutation(&self) -> bool {
        let is_unit = |e: &Expr| [Expr::ZERO, Expr::ONE, Expr::MINUS_ONE].contains(e);
        matches!(self, Self::Oriented(turn) if turn.cosines.iter().flatten().all(is_unit))
    }

    /// Rotation by four Euler parameters of any nonzero length, the scalar ε₀ first. For a rotation by
    /// θ about the unit vector e they are ε₀ = cos θ/2 and ε = e sin θ/2.
    ///
    /// Source: T. R. Kane, P. W. Likins & D. A. Levinson, *Spacecraft Dynamics* (1983), §§ 1.3 and
    /// 1.13. Their cosines for parameters of length 1 are divided by the square of the length. So the
    /// result is a rotation for any length, with ω = 2 (ε₀ ε' − ε₀' ε − ε × ε')/|ε|² in the new
    /// frame.
    ///
    /// # Panics
    /// If all four Euler parameters are 0.
    #[must_use]
    pub fn by_euler_parameters(arena: &mut Arena, [w, x, y, z]: [Expr; 4]) -> Self {
        let squares = [w, x, y, z].map(|e| arena.square(e));
        let length = arena.sum(&squares);
        let [ww, xx, yy, zz] = squares;
        let over = |arena: &mut Arena, factor: i64, terms: &[(bool, Expr)]| {
            let signed: Vec<Expr> = terms.iter().map(|(plus, e)| if *plus { *e } else { arena.neg(*e) }).collect();
            let sum = arena.sum(&signed);
            let scaled = arena.scale(sum, &Rational::integer(factor));
            arena.div(scaled, length).expect("Euler parameters are not all 0")
        };
        let twice = |arena: &mut Arena, (a, b): (Expr, Expr), plus: bool, (c, d): (Expr, Expr)| {
            let (first, second) = (arena.mul(a, b), arena.mul(c, d));
            over(arena, 2, &[(true, first), (plus, second)])
        };
        let off = [
            [twice(arena, (x, y), true, (w, z)), twice(arena, (x, z), false, (w, y))],
            [twice(arena, (x, y), false, (w, z)), twice(arena, (y, z), true, (w, x))],
            [twice(arena, (x, z), true, (w, y)), twice(arena, (y, z), false, (w, x))],
        ];
        let on = [
            [(true, ww), (true, xx), (false, yy), (false, zz)],
            [(true, ww), (false, xx), (true, yy), (false, zz)],
            [(true, ww), (false, xx), (false, yy), (true, zz)],
        ];
        let [c11, c22, c33] = on.map(|terms| over(arena, 1, &terms));
        let cosines = [[c11, off[0][0], off[0][1]], [off[1][0], c22, off[1][1]], [off[2][0], off[2][1], c33]];
        let mut spin = |of: Expr, along: [(bool, Expr); 3]| (of, along.map(|term| over(arena, 2, &[term])));
        let spins = vec![
            spin(w, [(false, x), (false, y), (false, z)]),
            spin(x, [(true, w), (false, z), (true, y)]),
            spin(y, [(true, z), (true, w), (false, x)]),
            spin(z, [(false, y), (true, x), (true, w)]),
        ];
        Self::Oriented(Box::new(Oriented { cosines, spins }))
    }

    /// Shortest constant rotation that takes the unit vector a along axis `axis` to the unit vector
    /// e, and the inverse of this rotation.
    ///
    /// The rotation is `R = 1 + [a × e] + [a × e]²/(1 + a · e)`. If e is −a, it is half a turn
    /// about the axis that follows a cyclically.
    ///
    /// # Panics
    /// Never: the function tests if 1 + a · e is zero before it divides.
    #[must_use]
    pub fn shortest_turn_to(arena: &mut Arena, axis: usize, unit: &Components) -> [Self; 2] {
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let beside = arena.add(Expr::ONE, unit[axis]);
        let mut rows = [[Expr::ZERO; 3]; 3];
        if zero_test(arena, beside) == ZeroTest::Zero {
            let back = arena.neg(Expr::ONE);
            rows[i][i] = Expr::ONE;
            (rows[j][j], rows[axis][axis]) = (back, back);
            return [rows, rows].map(|cosines| Self::Oriented(Box::new(Oriented { cosines, spins: Vec::new() })));
        }
        rows[axis] = *unit;
        for (row, other) in [(i, j), (j, i)] {
            let square = arena.square(unit[row]);
            let part = arena.div(square, beside).expect("the vector is not opposite to the axis");
            rows[row][row] = arena.sub(Expr::ONE, part);
            let product = arena.mul(unit[row], unit[other]);
            let part = arena.div(product, beside).expect("the vector is not opposite to the axis");
            rows[row][other] = arena.neg(part);
            rows[row][axis] = arena.neg(unit[row]);
        }
        let back = transposed(&rows);
        [rows, back].map(|cosines| Self::Oriented(Box::new(Oriented { cosines, spins: Vec::new() })))
    }

    /// All terms of the rotation. These are its angle, or its direction cosines with the quantities
    /// and factors of its angular velocity.
    #[must_use]
    pub fn terms(&self) -> Vec<Expr> {
        match self {
            Self::About(_, angle) => vec![*angle],
            Self::Oriented(turn) => {
                let spins = turn.spins.iter().flat_map(|(of, along)| [*of].into_iter().chain(*along));
                turn.cosines.iter().flatten().copied().chain(spins).collect()
            }
        }
    }

    /// Replaces every term of the rotation by the term that the function `map` returns for it.
    pub fn rewrite(&mut self, map: &mut impl FnMut(Expr) -> Expr) {
        match self {
            Self::About(_, angle) => *angle = map(*angle),
            Self::Oriented(turn) => {
                turn.cosines = turn.cosines.map(|row| row.map(&mut *map));
                for (of, along) in &mut turn.spins {
                    *of = map(*of);
                    *along = along.map(&mut *map);
                }
            }
        }
    }

    /// Quantities whose time derivatives rotate the new frame relative to the old one: the angle, or
    /// the quantities of a general rotation.
    #[must_use]
    pub fn quantities(&self) -> Vec<Expr> {
        match self {
            Self::About(_, angle) => vec![*angle],
            Self::Oriented(turn) => turn.spins.iter().map(|(of, _)| *of).collect(),
        }
    }

    /// Angular velocity of the new frame relative to the old frame, rad/s, with components in the new
    /// frame. `rates` gives the time derivative of each quantity.
    pub fn spin(&self, arena: &mut Arena, rates: &mut Differential) -> Components {
        let mut components = [Expr::ZERO; 3];
        match self {
            Self::About(axis, angle) => components[*axis] = rates.apply(arena, *angle),
            Self::Oriented(turn) => {
                for (of, along) in &turn.spins {
                    let rate = rates.apply(arena, *of);
                    components = std::array::from_fn(|i| {
                        let share = arena.mul(rate, along[i]);
                        arena.add(components[i], share)
                    });
                }
                // For Euler parameters, the rates may be formulas in the components of the angular
                // velocity. Simplification then gives back these components.
                let mut simplifier = Simplifier::default();
                components = components.map(|e| simplifier.simplify(arena, e));
            }
        }
        components
    }

    /// Components of a vector in one frame of the rotation, from its components `v` in the other
    /// frame. With `sense` = `Forward`, `v` has components in the old frame and the result has
    /// components in the new frame. `Back` is the inverse.
    pub fn apply(&self, arena: &mut Arena, v: &Components, sense: TurnSense) -> Components {
        match self {
            Self::About(axis, angle) => {
                let (mut s, c) = (arena.sin(*angle), arena.cos(*angle));
                if sense == TurnSense::Back {
                    s = arena.neg(s);
                }
                let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
                let (cj, sk, sj, ck) = (arena.mul(c, v[j]), arena.mul(s, v[k]), arena.mul(s, v[j]), arena.mul(c, v[k]));
                let mut result = *v;
                result[j] = arena.add(cj, sk);
                result[k] = arena.sub(ck, sj);
                result
            }
            Self::Oriented(turn) => {
                let rows = match sense {
                    TurnSense::Forward => turn.cosines,
                    TurnSense::Back => transposed(&turn.cosines),
                };
                rows.map(|row| dot_components(arena, &row, v))
            }
        }
    }
}
