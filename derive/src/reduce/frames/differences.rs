//! Differences that replace variables which a symmetry moves together.
//!
//! If a floating chain is turned as a whole, all of its angles change at equal rates. With ψ_i =
//! q_i − r_i q_g, and similarly for speeds, only q_g and u_g move along the symmetry. The momentum
//! determines u_g. Its divisor is the inertia of the whole chain as a rigid body, which is never
//! zero. The coordinate q_g is needed only for outputs that depend on it.

use crate::algebra::Expr;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::fresh_symbol;
use crate::reduce::basis::reduction_basis::{Momentum, ReductionBasis, VariableDifference};
use crate::reduce::slices::wanted_outputs::WantedOutputs;

/// Component of a symmetry along a single coordinate or speed, with a constant value.
#[derive(Clone, Copy)]
struct DirectionComponent {
    /// Index of the coordinate or speed along which the symmetry moves.
    at: usize,
    /// Constant value of the component, a number.
    number: Expr,
}

impl ReductionBasis {
    /// Replaces coordinates and speeds by differences, for each of the given momenta. Those
    /// variables are replaced that its symmetry moves at constant ratios and that no other symmetry
    /// moves. Returns the wanted quantities in the new variables.
    pub(in crate::reduce) fn replace_by_differences(
        &mut self,
        momenta: &[usize],
        wanted: WantedOutputs,
    ) -> WantedOutputs {
        let mut wanted = wanted;
        for at in momenta {
            let others = |direction: fn(&Momentum) -> &Vec<Expr>| -> Vec<Vec<Expr>> {
                momenta.iter().filter(|m| *m != at).map(|m| direction(&self.momenta[*m]).clone()).collect()
            };
            let (of_fields, of_directions) = (others(|m| &m.field), others(|m| &m.direction));
            if let Some(moved) = self.jointly_moved_components(&self.momenta[*at].field, &of_fields) {
                wanted = self.replace_coordinates_by_differences(&moved, &wanted);
            }
            if let Some(moved) = self.jointly_moved_components(&self.momenta[*at].direction, &of_directions) {
                wanted = self.replace_speeds_by_differences(&moved, &wanted);
            }
        }
        wanted
    }

    /// Components of a symmetry that are not zero while those of all other symmetries are zero.
    /// `None` unless there are at least two such components and all are numbers.
    fn jointly_moved_components(&self, direction: &[Expr], others: &[Vec<Expr>]) -> Option<Vec<DirectionComponent>> {
        let alone = |at: usize| others.iter().all(|other| other[at] == Expr::ZERO);
        let components = direction.iter().enumerate().filter(|(at, e)| **e != Expr::ZERO && alone(*at));
        let moved: Vec<DirectionComponent> =
            components.map(|(at, number)| DirectionComponent { at, number: *number }).collect();
        let numbers = moved.iter().all(|component| self.arena.as_number(component.number).is_some());
        (numbers && moved.len() > 1).then_some(moved)
    }

    /// Replaces coordinates by their differences from a multiple of the first coordinate in
    /// `moved`. Returns the wanted quantities in the new variables.
    fn replace_coordinates_by_differences(
        &mut self,
        moved: &[DirectionComponent],
        wanted: &WantedOutputs,
    ) -> WantedOutputs {
        let DirectionComponent { at: pivot, number: of_pivot } = moved[0];
        let mut pairs = Vec::new();
        for &DirectionComponent { at, number } in &moved[1..] {
            let (ratio, symbol) = self.difference(self.q[at], self.q[pivot], number, of_pivot);
            pairs.push((self.q[at], self.plus_multiple(symbol, ratio, self.q[pivot])));
            let back = self.arena.neg(ratio);
            let (rate, of_pivot) = (self.kane.coordinate_rates[at], self.kane.coordinate_rates[pivot]);
            self.kane.coordinate_rates[at] = self.plus_multiple(rate, back, of_pivot);
            self.q_start[at] = self.plus_multiple(self.q_start[at], back, self.q_start[pivot]);
            for field in
                self.momenta.iter_mut().map(|m| &mut m.field).chain(self.turns.iter_mut().map(|t| &mut t.along))
            {
                let taken = self.arena.mul(ratio, field[pivot]);
                field[at] = self.arena.sub(field[at], taken);
            }
            self.q[at] = symbol;
            self.kane.coordinates[at] = symbol;
        }
        self.rewrite_in_differences(&pairs, wanted)
    }

    /// Replaces speeds by their differences from a multiple of the first speed in `moved`. Returns
    /// the wanted quantities in the new variables.
    fn replace_speeds_by_differences(&mut self, moved: &[DirectionComponent], wanted: &WantedOutputs) -> WantedOutputs {
        let DirectionComponent { at: pivot, number: of_pivot } = moved[0];
        let mut pairs = Vec::new();
        for &DirectionComponent { at, number } in &moved[1..] {
            let (u, of_u) = (self.kane.variables[at], self.kane.variables[pivot]);
            let (ratio, symbol) = self.difference(u, of_u, number, of_pivot);
            let name = self.arena.symbol_name(symbol).unwrap_or_default().to_owned();
            let rate = self.arena.symbol(&format!("{name}'"));
            pairs.push((u, self.plus_multiple(symbol, ratio, of_u)));
            pairs.push((self.kane.unknowns[at], self.plus_multiple(rate, ratio, self.kane.unknowns[pivot])));
            let back = self.arena.neg(ratio);
            self.u_start[at] = self.plus_multiple(self.u_start[at], back, self.u_start[pivot]);
            // The substitution u = T w changes M and f into Tᵀ M T and Tᵀ f.
            for row in &mut self.kane.matrix {
                let moved = self.arena.mul(ratio, row[at]);
                row[pivot] = self.arena.add(row[pivot], moved);
            }
            for column in 0..self.kane.matrix.len() {
                let moved = self.arena.mul(ratio, self.kane.matrix[at][column]);
                self.kane.matrix[pivot][column] = self.arena.add(self.kane.matrix[pivot][column], moved);
            }
            let moved = self.arena.mul(ratio, self.kane.forcing[at]);
            self.kane.forcing[pivot] = self.arena.add(self.kane.forcing[pivot], moved);
            for momentum in &mut self.momenta {
                let moved = self.arena.mul(ratio, momentum.row[at]);
                momentum.row[pivot] = self.arena.add(momentum.row[pivot], moved);
                let taken = self.arena.mul(ratio, momentum.direction[pivot]);
                momentum.direction[at] = self.arena.sub(momentum.direction[at], taken);
            }
            let first = self.q.len();
            for turn in &mut self.turns {
                let taken = self.arena.mul(ratio, turn.along[first + pivot]);
                turn.along[first + at] = self.arena.sub(turn.along[first + at], taken);
            }
            self.kane.variables[at] = symbol;
            self.kane.unknowns[at] = rate;
        }
        self.rewrite_in_differences(&pairs, wanted)
    }

    /// Ratio at which a variable moves with the pivot variable, and a new symbol for the difference
    /// of the two. The replacement is recorded in `relatives`.
    fn difference(&mut self, variable: Expr, pivot: Expr, number: Expr, of_pivot: Expr) -> (Expr, Expr) {
        let ratio = self.arena.div(number, of_pivot).expect("a component that is not zero");
        let name = |e: Expr| self.arena.symbol_name(e).unwrap_or_default();
        let wanted = format!("{}_from_{}", name(variable), name(pivot));
        let symbol = fresh_symbol(&mut self.arena, &wanted);
        self.relatives.push(VariableDifference { variable, pivot, symbol });
        (ratio, symbol)
    }

    /// Computes the term e + ratio · pivot.
    fn plus_multiple(&mut self, e: Expr, ratio: Expr, pivot: Expr) -> Expr {
        let along = self.arena.mul(ratio, pivot);
        self.arena.add(e, along)
    }

    /// Applies the substitution `pairs` to every term of the basis. Returns the wanted quantities
    /// after it.
    fn rewrite_in_differences(&mut self, pairs: &[(Expr, Expr)], wanted: &WantedOutputs) -> WantedOutputs {
        let mut put = Substitution::new(pairs);
        let kept = self.q.clone();
        self.rewrite_basis_terms(&mut |arena, simplifier, e| {
            let moved = put.apply(arena, e);
            simplifier.simplify(arena, moved)
        });
        // The symbols of the coordinates are restored, because the rewriting has replaced them as
        // well.
        self.kane.coordinates.clone_from(&kept);
        wanted.map(|e| put.apply(&mut self.arena, e))
    }
}
