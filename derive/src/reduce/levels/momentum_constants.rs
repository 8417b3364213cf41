//! Constants of a motion, chosen so that the equations cost least.
//!
//! Any multiple of a conserved momentum may be used as the constant. If a momentum alone determines
//! a speed, the speed is constant and replaces the momentum. A numeric factor of a momentum is
//! included in its constant.

use super::held_momenta::HeldMomentum;
use crate::algebra::Expr;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::fresh_symbol;
use crate::reduce::basis::prose::Prose;
use crate::reduce::basis::reduction_basis::ReductionBasis;
use crate::reduce::basis::solved_rows::SolvedRows;

impl ReductionBasis {
    /// Replaces constant momenta by multiples of them, if that saves operations. A momentum that is
    /// the rate of a mass centre's position is kept.
    pub(in crate::reduce) fn choose_momentum_constants(&mut self, solved: &mut SolvedRows, held: &mut [HeldMomentum]) {
        for k in 0..solved.pivots.len() {
            let (row, column) = solved.pivots[k];
            if self.momenta[held[row].momentum].position.is_some() {
                continue;
            }
            let symbols: Vec<Expr> = held.iter().map(|h| h.symbol).collect();
            let value = solved.right[row][0];
            let Ok((coefficients, rest)) = LinearForm::new(&symbols).coefficients(&mut self.arena, value) else {
                continue;
            };
            let alone = rest == Expr::ZERO
                && coefficients.iter().enumerate().all(|(at, c)| at == row || *c == Expr::ZERO)
                && solved.rows[row].iter().enumerate().all(|(at, e)| at == column || *e == Expr::ZERO);
            let coefficient = self.simplifier.simplify(&mut self.arena, coefficients[row]);
            let (content, _) = self.arena.split_content(coefficient);
            if content.is_zero() {
                continue;
            }
            let factor = self.arena.number(content);
            let is_number = self.arena.as_number(coefficient).is_some();
            let new = if alone && is_number {
                let speed = self.kane.variables[column];
                held[row].about =
                    Prose::from("generalized speed, constant with the ").append_prose(held[row].about.clone());
                held[row].of_state = speed;
                held[row].unit = self.model.speeds[column].unit.clone();
                speed
            } else if factor == Expr::ONE {
                continue;
            } else {
                let name = self.arena.symbol_name(held[row].symbol).unwrap_or_default().to_owned();
                let scaled = self.arena.mul(factor, held[row].of_state);
                held[row].of_state = self.simplifier.simplify(&mut self.arena, scaled);
                held[row].about = Prose::term(factor).append_prose(" times the ").append_prose(held[row].about.clone());
                fresh_symbol(&mut self.arena, &format!("{name}_scaled"))
            };
            let instead = self.arena.div(new, factor).expect("not zero");
            let mut put = Substitution::new(&[(held[row].symbol, instead)]);
            held[row].symbol = new;
            for right in &mut solved.right {
                let moved = put.apply(&mut self.arena, right[0]);
                right[0] = self.simplifier.simplify(&mut self.arena, moved);
            }
        }
    }
}
