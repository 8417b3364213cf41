//! Slice of reduced equations: the smallest set of variables on which the outputs depend by
//! meaning.
//!
//! A zero test of the derivative decides if, for example, u̇₁ depends on q₁. If it does not, any
//! value may replace q₁, and terms that contain q₁ only by form disappear.

use super::dependence::Dependence;
use super::wanted_outputs::WantedOutputs;
use crate::algebra::form::simplify::operation_count_of_all;
use crate::algebra::solve::elimination::{LinearSystem, eliminate};
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::term::steps::Definition;
use crate::algebra::value::zero_test::{ZeroTest, bounded_zero_test};
use crate::algebra::{Arena, Expr};
use crate::reduce::basis::reduction_basis::ReductionBasis;
use crate::reduce::levels::momentum_level::Level;
use rustc_hash::{FxHashMap, FxHashSet};

/// Coordinate or speed of reduced equations, with its rate.
#[derive(Clone, Copy, Debug)]
pub struct Variable {
    /// Symbol of the coordinate or speed in the reduced equations.
    pub symbol: Expr,
    /// Rate of the variable, as a term in variables, constant momenta and parameters.
    pub rate: Expr,
    /// True if the variable is a speed, false if it is a coordinate.
    pub is_speed: bool,
    /// Index of the variable among the model's coordinates, or among its speeds.
    pub place: usize,
}

/// Coordinate that follows from the uniform motion of a mass centre. A constant momentum is the
/// rate of a position of this centre.
#[derive(Clone, Copy, Debug)]
pub struct UniformMassCentre {
    /// Symbol of the coordinate that need not be integrated.
    pub coordinate: Expr,
    /// Value of the coordinate in other variables, time, constant momenta and the position at the
    /// start.
    pub value: Expr,
    /// Symbol of the position at the start of the motion.
    pub symbol: Expr,
    /// Position of the mass centre as a function of q: a mass times a coordinate of the mass
    /// centre, kg m.
    pub position: Expr,
    /// Index, in `Level::held`, of the constant momentum that is the rate of the position.
    pub held: usize,
}

/// Slice: the smallest set of variables on which the wanted values depend and whose rates contain
/// no other variable.
#[derive(Clone)]
pub struct Slice {
    /// States: variables on which the rates of other variables depend. Coordinates come first, then
    /// speeds.
    pub core: Vec<Variable>,
    /// Variables found by quadrature: outputs depend on them, but the rates of states do not. Each
    /// comes after the quadrature variables that its rate needs.
    pub quadratures: Vec<Variable>,
    /// Variables of the model that the reduced equations leave out.
    pub dropped: Vec<Variable>,
    /// Definitions of longer terms, with the test on which variables terms depend.
    pub dependence: Dependence,
    /// Wanted outputs, conditions and events, as terms in the remaining variables.
    pub wanted: WantedOutputs,
    /// Energy T + V, J; `None` if it is not conserved or depends on variables that are left out.
    pub energy: Option<Expr>,
    /// Coordinates that are computed from the uniform motion of a mass centre.
    pub carried: Vec<UniformMassCentre>,
    /// Symbol of the time t since the start, s.
    pub time: Expr,
    /// Matrix and right-hand side of the linear system for the rates of the remaining speeds; `None` if
    /// the solved rates are used.
    pub system: Option<(Vec<Vec<Expr>>, Vec<Expr>)>,
    /// Pairs (symbol, full rate) for all variables. Full rates have all definitions written out and
    /// are not shortened.
    pub raw: Vec<(Expr, Expr)>,
}

impl Slice {
    /// Finds the variables of a level set that the wanted values need. `None` if the equations of
    /// the level set do not determine the accelerations.
    pub(in crate::reduce) fn new(basis: &mut ReductionBasis, level: &Level, wanted: &WantedOutputs) -> Option<Self> {
        let (mut variables, definitions) = basis.slice_variables(level)?;
        let symbols: Vec<Expr> = variables.iter().map(|v| v.symbol).collect();
        let solved: Vec<(Expr, Expr)> = level
            .kept
            .iter()
            .map(|k| basis.kane.unknowns[*k])
            .zip(variables[basis.q.len()..].iter().map(|v| v.rate))
            .collect();
        let mut solved = Substitution::new(&solved);
        let accelerations: Vec<(Expr, Expr)> =
            basis.kane.unknowns.iter().copied().zip(level.accelerations.iter().copied()).collect();
        let mut accelerations = Substitution::new(&accelerations);
        let time = basis.slice_time_symbol();
        let (arena, simplifier, energy) = (&mut basis.arena, &mut basis.simplifier, basis.energy);
        let mut dependence = Dependence::new(arena, definitions);
        let mut put = |e: Expr| {
            let moved = accelerations.apply(arena, e);
            let moved = solved.apply(arena, moved);
            let short = simplifier.simplify(arena, moved);
            let short = dependence.without_independent_variables(arena, simplifier, short, &symbols);
            // If the equality is not proved, for example because of roots or functions without
            // rules, the term is not rewritten.
            let (before, after) =
                (dependence.without_definitions(arena, moved), dependence.without_definitions(arena, short));
            let difference = arena.sub(before, after);
            if bounded_zero_test(arena, difference).0 == ZeroTest::Zero { short } else { moved }
        };
        let wanted = wanted.map(&mut put);
        let energy = energy.map(&mut put);
        let mut raw = Vec::new();
        for variable in &mut variables {
            raw.push((variable.symbol, dependence.without_definitions(arena, variable.rate)));
            variable.rate = dependence.without_independent_variables(arena, simplifier, variable.rate, &symbols);
        }
        let (core, quadratures, carried) = Default::default();
        let mut flow = Self {
            core,
            quadratures,
            dropped: variables,
            dependence,
            wanted,
            energy,
            carried,
            time,
            raw,
            system: None,
        };
        flow.sort_slice_variables(&basis.arena);
        flow.remove_uniform_coordinates(basis, level);
        let present: Vec<Expr> = flow.core.iter().chain(&flow.quadratures).map(|v| v.symbol).collect();
        let others: Vec<Expr> = symbols.into_iter().filter(|s| !present.contains(s)).collect();
        flow.energy = flow.energy.filter(|e| {
            let mentioned = flow.dependence.mentioned_symbols(&basis.arena, &[*e]);
            !others.iter().any(|s| mentioned.contains(s))
        });
        Some(flow)
    }

    /// True if the variable with this symbol is a state: the rate of another variable depends on
    /// it.
    pub fn is_slice_state(&self, symbol: Expr) -> bool {
        self.core.iter().any(|v| v.symbol == symbol)
    }

    /// Cost for comparisons of reductions, as (number of states, number of integrated variables,
    /// number of operations in their rates).
    pub(in crate::reduce) fn slice_cost(&self, basis: &ReductionBasis) -> (usize, usize, usize) {
        let rates = self.core.iter().chain(&self.quadratures).map(|v| v.rate).collect::<Vec<_>>();
        let used = self.definitions_used_in_slice(&basis.arena, &rates);
        let rates: Vec<Expr> = rates.into_iter().chain(used.iter().map(|d| d.value)).collect();
        let integrated = self.core.len() + self.quadratures.len();
        (self.core.len(), integrated, operation_count_of_all(&basis.arena, &rates))
    }

    /// Sorts all variables into states, quadrature variables and dropped variables, by what the
    /// wanted values need at present.
    pub(in crate::reduce) fn sort_slice_variables(&mut self, arena: &Arena) {
        let mut all: Vec<Variable> =
            self.core.drain(..).chain(self.quadratures.drain(..)).chain(self.dropped.drain(..)).collect();
        all.sort_by_key(|v| (v.is_speed, v.place));
        let mut needed = vec![false; all.len()];
        let of_rates: Vec<FxHashSet<Expr>> =
            all.iter().map(|v| self.dependence.mentioned_symbols(arena, &[v.rate])).collect();
        let mut open = vec![self.dependence.mentioned_symbols(arena, &self.wanted.values())];
        while let Some(mentioned) = open.pop() {
            for (at, variable) in all.iter().enumerate() {
                if !needed[at] && mentioned.contains(&variable.symbol) {
                    needed[at] = true;
                    open.push(of_rates[at].clone());
                }
            }
        }
        let mut of_rates: FxHashMap<Expr, FxHashSet<Expr>> = all.iter().map(|v| v.symbol).zip(of_rates).collect();
        let (mut kept, dropped): (Vec<_>, Vec<_>) = all.into_iter().zip(needed).partition(|(_, needed)| *needed);
        self.dropped = dropped.into_iter().map(|(v, _)| v).collect();
        let mut peeled = Vec::new();
        while let Some(at) = (0..kept.len()).find(|at| {
            let symbol = kept[*at].0.symbol;
            !kept.iter().any(|(other, _)| of_rates[&other.symbol].contains(&symbol))
        }) {
            let gone = kept.remove(at).0;
            of_rates.remove(&gone.symbol);
            peeled.push(gone);
        }
        peeled.reverse();
        self.quadratures = peeled;
        self.core = kept.into_iter().map(|(v, _)| v).collect();
    }

    /// Definitions that the given terms use, in the order of computation.
    pub(in crate::reduce) fn definitions_used_in_slice(&self, arena: &Arena, terms: &[Expr]) -> Vec<Definition> {
        let mentioned = self.dependence.mentioned_symbols(arena, terms);
        self.dependence.definitions.iter().copied().filter(|d| mentioned.contains(&d.symbol)).collect()
    }

    /// Removes coordinates that the uniform motion of a mass centre determines. No rate of another
    /// variable, no event and no condition may depend on them.
    fn remove_uniform_coordinates(&mut self, basis: &mut ReductionBasis, level: &Level) {
        // With a moving frame, the mass centre need not move uniformly in the frame.
        if basis.frame.is_some() {
            return;
        }
        for (held, h) in level.held.iter().enumerate() {
            let momentum = &basis.momenta[h.momentum];
            // On a singular surface, the remaining part of a momentum is not the rate of a
            // position.
            let Some(position) = momentum.position.filter(|_| h.of_state == momentum.value) else { continue };
            // Events and conditions must not contain the time.
            let watched: Vec<Expr> = self.wanted.conditions.iter().chain(&self.wanted.events).copied().collect();
            let watched = self.dependence.mentioned_symbols(&basis.arena, &watched);
            let found = self.quadratures.iter().find_map(|v| {
                let others = self.core.iter().chain(&self.quadratures);
                let rates: Vec<Expr> = others.filter(|o| o.symbol != v.symbol).map(|o| o.rate).collect();
                let free = !self.dependence.mentioned_symbols(&basis.arena, &rates).contains(&v.symbol);
                (free && !v.is_speed && !watched.contains(&v.symbol)).then_some(())?;
                basis
                    .slice_coordinate_of_mass_centre(v.symbol, position, h.symbol, self.time)
                    .map(|(value, symbol)| UniformMassCentre { coordinate: v.symbol, value, symbol, position, held })
            });
            let Some(carried) = found else { continue };
            let mut put = Substitution::new(&[(carried.coordinate, carried.value)]);
            let (arena, simplifier) = (&mut basis.arena, &mut basis.simplifier);
            self.wanted = self.wanted.map(|e| {
                let moved = put.apply(arena, e);
                simplifier.simplify(arena, moved)
            });
            self.carried.push(carried);
            self.sort_slice_variables(&basis.arena);
        }
    }
}

impl ReductionBasis {
    /// All coordinates and the remaining speeds, with their rates, and the definitions that the
    /// rates use. `None` if the mass matrix of the level set is singular.
    fn slice_variables(&mut self, level: &Level) -> Option<(Vec<Variable>, Vec<Definition>)> {
        let mut list: Vec<Variable> = Vec::new();
        for (place, (symbol, rate)) in self.q.iter().zip(&self.kane.coordinate_rates).enumerate() {
            list.push(Variable { symbol: *symbol, rate: *rate, is_speed: false, place });
        }
        let unknowns: Vec<Expr> = level.kept.iter().map(|k| self.kane.unknowns[*k]).collect();
        let system = LinearSystem {
            matrix: &level.matrix,
            right: &level.forcing,
            unknowns: &unknowns,
            symmetric: true,
            is_large: false,
        };
        let (arena, simplifier) = (&mut self.arena, &mut self.simplifier);
        let solved = eliminate(arena, simplifier, system).ok()?;
        let (mut written, mut definitions) = (Substitution::default(), level.definitions.clone());
        for step in &solved.steps {
            let value = written.apply(arena, step.value);
            if unknowns.contains(&step.symbol) {
                written.set(step.symbol, value);
            } else {
                definitions.push(Definition { symbol: step.symbol, value });
            }
        }
        for (k, unknown) in level.kept.iter().zip(&unknowns) {
            let rate = written.apply(arena, *unknown);
            list.push(Variable { symbol: self.kane.variables[*k], rate, is_speed: true, place: *k });
        }
        Some((list, definitions))
    }

    /// Symbol of the time since the start: `t`, or a new symbol if a variable or parameter has this
    /// name.
    fn slice_time_symbol(&mut self) -> Expr {
        match self.arena.find_symbol("t") {
            Some(taken)
                if !self.model.q().contains(&taken)
                    && !self.model.u().contains(&taken)
                    && !self.model.p().contains(&taken) =>
            {
                taken
            }
            Some(_) => crate::algebra::term::steps::fresh_symbol(&mut self.arena, "elapsed"),
            None => self.arena.symbol("t"),
        }
    }

    /// Solves position = start + momentum · t for a coordinate. Returns the value of the
    /// coordinate, and the new symbol for the position at the start. `None` unless the position is
    /// linear in the coordinate, with a constant factor.
    fn slice_coordinate_of_mass_centre(
        &mut self,
        coordinate: Expr,
        position: Expr,
        momentum: Expr,
        time: Expr,
    ) -> Option<(Expr, Expr)> {
        let arena = &mut self.arena;
        let factor = Differential::partial(coordinate).apply(arena, position);
        let factor = self.simplifier.simplify(arena, factor);
        let states = [self.q.clone(), self.kane.variables.clone()].concat();
        if factor == Expr::ZERO || states.iter().any(|s| arena.mentions(factor, *s)) {
            return None;
        }
        let rest = Substitution::new(&[(coordinate, Expr::ZERO)]).apply(arena, position);
        let name = arena.symbol_name(coordinate).unwrap_or_default().to_owned();
        let symbol = crate::algebra::term::steps::fresh_symbol(arena, &format!("centre_{name}"));
        let moved = arena.mul(momentum, time);
        let there = arena.add(symbol, moved);
        let difference = arena.sub(there, rest);
        let value = arena.div(difference, factor)?;
        Some((self.simplifier.simplify(arena, value), symbol))
    }
}
