//! Quotients near a singular surface, rewritten so that no terms cancel.
//!
//! In a reduced equation, both terms of a quotient N(q; c)/D(q) may be zero on the surface. The
//! numerator is split into its value on the surface and a rest. This value is a constant of the
//! motion, which is computed once. In the rest, 1 − cos d is replaced by 2 sin²(d/2).

use super::held_momenta::HeldMomentum;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::{Arena, Expr, Rational};
use crate::reduce::basis::solved_rows::SolvedRows;

/// Singular surface of a reduction: all states at which a certain coordinate q equals k π/2, with
/// an integer k.
#[derive(Clone, Copy, Debug)]
pub struct SingularSurface {
    /// Symbol of the distance from the surface; the coordinate itself if k = 0.
    pub symbol: Expr,
}

/// Quotient N/D on the right-hand side of a solved row, which is split so that nothing cancels.
struct Quotient<'q> {
    /// Index of the row of the quotient.
    row: usize,
    /// Value N/D, which is replaced by its split form.
    value: &'q mut Expr,
    /// Divisor D of the quotient, which is zero on the surface.
    divisor: Expr,
}

impl SingularSurface {
    /// Splits all right-hand sides whose divisors are zero on the surface. Constant momenta are
    /// replaced by other constants where needed.
    pub(in crate::reduce) fn split_surface_quotients(
        self,
        arena: &mut Arena,
        simplifier: &mut Simplifier,
        solved: &mut SolvedRows,
        held: &mut [HeldMomentum],
    ) {
        let mut on_surface = Substitution::new(&[(self.symbol, Expr::ZERO)]);
        for k in 0..solved.pivots.len() {
            let (row, divisor) = (solved.pivots[k].0, solved.divisors[k]);
            let value = on_surface.apply(arena, divisor);
            if simplifier.simplify(arena, value) != Expr::ZERO {
                continue;
            }
            let Some((given_way, instead)) = self.split_surface_quotient(
                arena,
                simplifier,
                Quotient { row, value: &mut solved.right[row][0], divisor },
                held,
            ) else {
                continue;
            };
            let mut put = Substitution::new(&[(given_way, instead)]);
            for right in &mut solved.right {
                let moved = put.apply(arena, right[0]);
                right[0] = simplifier.simplify(arena, moved);
            }
        }
    }

    /// Splits a quotient N/D with D = 0 on the surface. N must be linear in the constant momenta. A
    /// new symbol for the value of N on the surface replaces one of the momenta. Returns the
    /// replaced symbol and its value in terms of the new symbol. `None` if no split is possible.
    fn split_surface_quotient(
        self,
        arena: &mut Arena,
        simplifier: &mut Simplifier,
        quotient: Quotient<'_>,
        held: &mut [HeldMomentum],
    ) -> Option<(Expr, Expr)> {
        let Quotient { row, value: quotient, divisor } = quotient;
        let product = arena.mul(*quotient, divisor);
        let numerator = simplifier.simplify(arena, product);
        let mut on_surface = Substitution::new(&[(self.symbol, Expr::ZERO)]);
        let left = on_surface.apply(arena, numerator);
        let left = simplifier.simplify(arena, left);
        if on_surface.undefined.is_some() || left == Expr::ZERO || left == numerator {
            return None;
        }
        let symbols: Vec<Expr> = held.iter().map(|h| h.symbol).collect();
        // Only a combination of momenta with constant coefficients is constant along a motion.
        let constant = arena
            .reachable(&[left])
            .iter()
            .all(|e| arena.symbol_name(*e).is_none() || symbols.contains(e) || arena.is_positive(*e));
        let (coefficients, rest) = LinearForm::new(&symbols).coefficients(arena, left).ok()?;
        // The momentum of this row is replaced if possible, else another one. Its coefficient in
        // the numerator must be a number.
        let alone = |at: &usize| arena.as_number(coefficients[*at]).is_some_and(|k| !k.is_zero());
        let at = std::iter::once(row).chain(0..symbols.len()).find(alone)?;
        if !constant || rest != Expr::ZERO {
            return None;
        }
        let name = arena.symbol_name(symbols[at]).unwrap_or_default().to_owned();
        let fresh = fresh_symbol(arena, &format!("{name}_there"));
        // The definition fresh = Σ coefficient · momentum is solved for the replaced momentum.
        let others: Vec<Expr> = (0..symbols.len())
            .filter(|other| *other != at)
            .map(|other| arena.mul(coefficients[other], symbols[other]))
            .collect();
        let others = arena.sum(&others);
        let difference = arena.sub(fresh, others);
        let instead = arena.div(difference, coefficients[at])?;
        let mut put = Substitution::new(&[(symbols[at], instead)]);
        let moved = put.apply(arena, numerator);
        let cosine = arena.cos(self.symbol);
        let half = arena.scale(self.symbol, &Rational::fraction(1, 2)?);
        let sine = arena.sin(half);
        let square = arena.square(sine);
        let twice = arena.scale(square, &Rational::integer(2));
        let versed = arena.sub(Expr::ONE, twice);
        let moved = Substitution::new(&[(cosine, versed)]).apply(arena, moved);
        let moved = simplifier.simplify(arena, moved);
        *quotient = arena.div(moved, divisor)?;
        let terms: Vec<Expr> = coefficients.iter().zip(held.iter()).map(|(c, h)| arena.mul(*c, h.of_state)).collect();
        let of_state = arena.sum(&terms);
        let about = held[at].about.clone().append_prose(", what is left of it on the singular surface");
        held[at] =
            HeldMomentum { symbol: fresh, of_state: simplifier.simplify(arena, of_state), about, ..held[at].clone() };
        Some((symbols[at], instead))
    }
}
