//! Conditions for rest, or for steady motion along the symmetries of a mechanism, with symbolic parameters, and their
//! solutions in closed form.
//!
//! In a motion Σ c ζ along symmetries ζ = (ξ, η), the coordinates have the rates q̇ = Σ c ξ. So the speeds u = J q̇ +
//! d are formulas in q and c. The remaining conditions are W u + w = Σ c ξ, M Σ c η = F, and the loops φ(q) = 0. The
//! first condition is satisfied by itself unless motions are constrained.

use super::Flow;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::closed::{Solutions, solve_in_closed_form};
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Rational};
use crate::model::Model;
use crate::prove::IntegralKind;

/// Velocity of a steady motion along a single symmetry of the flow.
#[derive(Clone, Debug)]
pub struct SymmetryVelocity {
    /// Symbol of the velocity. It is the symbol of the coordinate's rate if `is_rate` is true.
    pub symbol: Expr,
    /// Index of the symmetry in [`Flow::symmetries`].
    pub symmetry: usize,
    /// True if the velocity is the rate of a coordinate that no other symmetry changes.
    pub is_rate: bool,
}

/// Kind of a motion in which all variables are constant, except those that symmetries shift.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steadiness {
    /// Rest: nothing moves except drives at a constant rate.
    Rest,
    /// Steady motion at constant velocities along the symmetries.
    SteadyMotion,
}

/// Conditions of rest, or of steady motion along the symmetries, as terms that must vanish.
#[derive(Clone, Debug, Default)]
pub struct Balance {
    /// Velocities along symmetries, which are unknowns of the conditions; empty for rest.
    pub along: Vec<SymmetryVelocity>,
    /// Generalized speeds u as terms in coordinates and velocities along symmetries.
    pub speeds: Vec<Expr>,
    /// Terms that must vanish: forces, kinematic equations and loops, in parameters, coordinates and
    /// velocities along symmetries.
    pub rows: Vec<Expr>,
    /// Divisors of the kinematic equations, as terms in coordinates and velocities along symmetries.
    pub divisors: Vec<Expr>,
}

impl Flow {
    /// Derives the conditions of rest, or of steady motion along the symmetries. In both, drives at a constant rate
    /// continue.
    pub fn steady_balance(&mut self, model: &Model, steadiness: Steadiness) -> Balance {
        let along = match steadiness {
            Steadiness::Rest => Vec::new(),
            Steadiness::SteadyMotion => self.steady_velocities_along_symmetries(model),
        };
        let q_count = model.coordinates.len();
        // Time always advances. Rest at any time is stated at time 0.
        let by_time = self.time_shift_symmetry(model);
        let now: Vec<(Expr, Expr)> = model.time().map(|at| (self.states[at], Expr::ZERO)).into_iter().collect();
        let arena = &mut self.arena;
        let mut simplifier = Simplifier::default();
        let carried = |arena: &mut Arena, at: usize| {
            let of_letters = along.iter().map(|a| arena.mul(a.symbol, self.symmetries[a.symmetry].along[at]));
            let mut terms: Vec<Expr> = of_letters.collect();
            terms.extend(by_time.map(|symmetry| self.symmetries[symmetry].along[at]));
            arena.sum(&terms)
        };
        // q̇ = Σ c ξ, then u = J q̇ + d.
        let rates: Vec<Expr> = (0..q_count).map(|at| carried(arena, at)).collect();
        let mut put: Vec<(Expr, Expr)> = model.q_dot().into_iter().zip(rates.iter().copied()).collect();
        put.extend(&now);
        let mut put = Substitution::new(&put);
        let speeds: Vec<Expr> = model.speeds.iter().map(|speed| put.apply(arena, speed.definition)).collect();
        let speeds: Vec<Expr> = speeds.into_iter().map(|u| simplifier.simplify(arena, u)).collect();
        let mut put: Vec<(Expr, Expr)> = model.u().into_iter().zip(speeds.iter().copied()).collect();
        put.extend(&now);
        let mut put = Substitution::new(&put);
        let mut rows = Vec::new();
        for (row, forcing) in self.balances.iter().enumerate() {
            // F − M Σ c η.
            let mut terms = vec![(*forcing, Rational::ONE)];
            for (at, inertia) in self.inertia[row].iter().enumerate() {
                let eta = carried(arena, q_count + at);
                terms.push((arena.mul(*inertia, eta), Rational::MINUS_ONE));
            }
            rows.push(arena.linear_combination(&terms));
        }
        for (rate, carried) in self.rates.iter().zip(&rates) {
            rows.push(arena.sub(*rate, *carried));
        }
        rows.extend(self.loops.iter().chain(&self.closed));
        let mut at = |arena: &mut Arena, e: &Expr| {
            let value = put.apply(arena, *e);
            simplifier.simplify(arena, value)
        };
        let rows = rows.iter().map(|row| at(arena, row)).collect();
        let divisors = self.divisors.iter().map(|e| at(arena, e)).collect();
        Balance { along, speeds, rows, divisors }
    }

    /// Velocities along the symmetries, one for each symmetry except the shift of time, with their symbols.
    fn steady_velocities_along_symmetries(&mut self, model: &Model) -> Vec<SymmetryVelocity> {
        let n = model.coordinates.len();
        let rates = model.q_dot();
        let mut list: Vec<SymmetryVelocity> = Vec::new();
        let by_time = self.time_shift_symmetry(model);
        for (symmetry, field) in self.symmetries.iter().enumerate().filter(|(at, _)| Some(*at) != by_time) {
            // The velocity c is q' if no other symmetry changes the coordinate.
            let others = || self.symmetries.iter().enumerate().filter(|(at, _)| *at != symmetry).map(|(_, s)| s);
            let own = (0..n).find(|at| {
                let left = self.arena.sub(field.along[*at], Expr::ONE);
                zero_test(&self.arena, left) == ZeroTest::Zero && others().all(|other| other.along[*at] == Expr::ZERO)
            });
            let symbol = match own {
                Some(at) => rates[at],
                None => fresh_symbol(&mut self.arena, &symmetry_velocity_name(model, field.kind)),
            };
            list.push(SymmetryVelocity { symbol, symmetry, is_rate: own.is_some() });
        }
        list
    }

    /// Solves the conditions in closed form for velocities along symmetries and for coordinates. The symbols `asked`,
    /// which may be parameters, are solved for first. Returns the list of unknowns in the order of solving, and the
    /// solutions.
    pub fn steady_balance_in_closed_form(
        &mut self,
        model: &Model,
        balance: &Balance,
        asked: &[Expr],
    ) -> (Vec<Expr>, Solutions) {
        let mentioned = self.arena.reachable(&balance.rows);
        let is_new = |e: &Expr| mentioned.binary_search(e).is_ok() && !asked.contains(e);
        let first: Vec<Expr> = asked.iter().copied().filter(|e| mentioned.binary_search(e).is_ok()).collect();
        let others = balance.along.iter().map(|a| a.symbol).chain(model.q()).filter(is_new);
        let unknowns: Vec<Expr> = first.iter().copied().chain(others).collect();
        let found = solve_in_closed_form(&mut self.arena, &balance.rows, &unknowns, first.len(), &balance.divisors);
        (unknowns, found)
    }
}

/// Name of a velocity along a symmetry that is not the rate of a coordinate, such as `Omega_n3`.
fn symmetry_velocity_name(model: &Model, kind: IntegralKind) -> String {
    let axis = |frame: usize, axis: usize| format!("{}{}", model.frames[frame].name.to_lowercase(), axis + 1);
    let of = |body: usize| &model.bodies[body].name;
    match kind {
        IntegralKind::Coordinate(at) => {
            let letter = if model.coordinates[at].unit.is_plain() { "Omega" } else { "V" };
            format!("{letter}_{}", model.coordinates[at].name)
        }
        IntegralKind::Linear(at) => format!("V_{}", axis(0, at)),
        IntegralKind::Angular { axis: at, .. } => format!("Omega_{}", axis(0, at)),
        IntegralKind::LinearOfBody { body, axis: at } => format!("V_{}_{}", of(body), axis(0, at)),
        IntegralKind::AngularOfBody { body, axis: at } => format!("Omega_{}_{}", of(body), axis(0, at)),
        IntegralKind::Spin { body, axis: at } => {
            let frame = model.bodies[body].rigid.as_ref().map_or(0, |(_, inertia)| inertia.frame);
            format!("Omega_{}_{}", of(body), axis(frame, at))
        }
        IntegralKind::Energy | IntegralKind::EnergyOfForces | IntegralKind::Jacobi | IntegralKind::Symmetry => {
            "c".to_owned()
        }
    }
}
