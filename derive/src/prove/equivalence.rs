//! Equivalence Kane ⇔ Lagrange ⇔ Newton–Euler: each pair by linear combination of rows.
//!
//! With q̇ = W u + w and u = J q̇ + d:  Kane = Wᵀ · Lagrange and Lagrange = Jᵀ · Kane, so both vanish together where
//! det J ≠ 0. With the partial velocities P (of mass centres for forces, of frames for moments):  Kane = P ·
//! (Newton–Euler), in which the reactions cancel. P and as many further rows D as there are reactions form a regular
//! matrix. So Kane's equations and the rows D, which give the reactions, are equivalent to Newton–Euler.

use super::verdicts::{all, all_equal};
use crate::algebra::meaning::compare::{Comparer, Verdict};
use crate::algebra::solve::linear::solve;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::value::rank::rank;
use crate::algebra::{Arena, Expr};
use crate::mechanics::{
    Balance, Derivations, Equations, Formulation, Kinematics, RowName, along_reactions, balances, partial_velocities,
    rates_to_speeds, speeds_to_rates,
};
use crate::model::Model;

/// Two formulations with the proof that they are equivalent.
#[derive(Clone, Debug)]
pub struct Pair {
    /// First formulation, in the order of [`Formulation::ALL`].
    pub left: Formulation,
    /// Second formulation, in the order of [`Formulation::ALL`].
    pub right: Formulation,
    /// Verdict on the claim that each set of rows is the stated combination of the other.
    pub verdict: Verdict,
    /// Combination that leads from one formulation to the other, in words and symbols.
    pub map: String,
}

/// A reaction with the equation that gives it: a Newton–Euler row that Kane's method does not use.
#[derive(Clone, Debug)]
pub struct ReactionEquation {
    /// Name of the reaction.
    pub name: String,
    /// Value of the reaction in q, u and u̇.
    pub value: Expr,
}

type Matrix = Vec<Vec<Expr>>;

/// Proves all pairs of the formulations that were derived, and gives the equations for the reactions.
pub fn prove(
    model: &Model,
    derivations: &mut Derivations,
    comparer: &mut Comparer,
) -> (Vec<Pair>, Vec<ReactionEquation>) {
    let list: Vec<Equations> = Formulation::ALL.into_iter().filter_map(|f| derivations.get(f).cloned()).collect();
    let kinematics = &mut derivations.kinematics;
    let maps = Maps::new(model, &mut kinematics.arena);
    let mut prover = Prover { model, kinematics, comparer, maps, reactions: None };
    let mut pairs = Vec::new();
    for (at, left) in list.iter().enumerate() {
        for right in &list[at + 1..] {
            let found = prover.one_from_the_other(left, right).or_else(|| prover.one_from_the_other(right, left));
            let both = (left.formulation, right.formulation);
            pairs.extend(found.map(|(verdict, map)| Pair { left: both.0, right: both.1, verdict, map }));
        }
    }
    (pairs, prover.reactions.unwrap_or_default())
}

/// Verdict on two formulations, and the combination that leads from one to the other, in words.
type FormulationVerdict = (Verdict, String);

struct Prover<'a> {
    model: &'a Model,
    kinematics: &'a mut Kinematics,
    comparer: &'a mut Comparer,
    maps: Maps,
    /// Equations for the reactions; `None` until a system in speeds is proved to be a combination of balances.
    reactions: Option<Vec<ReactionEquation>>,
}

impl Prover<'_> {
    /// Compares two systems by the combination that leads from `left` to `right`. `None` if only the other direction is
    /// known.
    fn one_from_the_other(&mut self, left: &Equations, right: &Equations) -> Option<FormulationVerdict> {
        let (from, to) = (left.formulation, right.formulation);
        match (from.carries_reactions(), to.carries_reactions()) {
            (false, false) if from.is_in_rates() == to.is_in_rates() => Some(self.row_by_row(left, right)),
            (false, false) if to.is_in_rates() => Some(self.speeds_and_rates(left, right)),
            (false, true) if from.is_in_rates() => Some(self.rates_and_balances(left, right)),
            (false, true) => Some(self.speeds_and_balances(left, right)),
            _ => None,
        }
    }

    /// Compares two systems of the same kind row by row.
    fn row_by_row(&mut self, left: &Equations, right: &Equations) -> FormulationVerdict {
        let rows = Combined { matrix: left.matrix.clone(), right: left.forcing.clone() };
        let verdict = equal_systems(&mut self.kinematics.arena, self.comparer, &rows, right, 0);
        (verdict, format!("{} = {}, row by row", label(left), label(right)))
    }

    /// Proves Speeds = Wᵀ · Rates and Rates = Jᵀ · Speeds.
    fn speeds_and_rates(&mut self, speeds: &Equations, rates: &Equations) -> FormulationVerdict {
        if !self.model.motion_constraints.is_empty() {
            return self.speeds_and_multipliers(speeds, rates);
        }
        let Self { model, kinematics, comparer, maps, .. } = self;
        let arena = &mut kinematics.arena;
        let in_speeds = maps.to_speeds(model, arena, rates);
        let forward = combine(arena, &transposed(&maps.w), &in_speeds);
        let forward = equal_systems(arena, comparer, &forward, speeds, 0);
        let in_rates = maps.to_rates(model, arena, speeds);
        let mut to_rates = speeds_to_rates(model);
        let j: Matrix =
            transposed(&maps.j).iter().map(|row| row.iter().map(|e| to_rates.apply(arena, *e)).collect()).collect();
        let backward = combine(arena, &j, &in_rates);
        let backward = equal_systems(arena, comparer, &backward, rates, 0);
        // A speed that is not homogeneous in q̇ has an offset at q̇ = 0.
        let pairs: Vec<_> = model.q_dot().into_iter().map(|rate| (rate, Expr::ZERO)).collect();
        let mut at_rest = Substitution::new(&pairs);
        let homogeneous = model.speeds.iter().all(|s| at_rest.apply(arena, s.definition) == Expr::ZERO);
        let with = if homogeneous { "q' = W u and u = J q'" } else { "q' = W u + w and u = J q' + d" };
        let (u, q) = (label(speeds), label(rates));
        (all([forward, backward]), format!("{u} = Wᵀ · {q} and {q} = Jᵀ · {u}, with {with}"))
    }

    /// Proves Speeds = Wᵀ · Rates, which cancels the multipliers; the rows of the constraints vanish.
    fn speeds_and_multipliers(&mut self, speeds: &Equations, rates: &Equations) -> FormulationVerdict {
        let Self { model, kinematics, comparer, maps, .. } = self;
        let arena = &mut kinematics.arena;
        let (n, m) = (model.coordinates.len(), model.motion_constraints.len());
        let in_speeds = maps.to_speeds(model, arena, rates);
        let forward = combine(arena, &transposed(&maps.w), &in_speeds);
        let forward = equal_systems(arena, comparer, &forward, speeds, m);
        let of_constraints = in_speeds.matrix[n..].iter().flatten().chain(&in_speeds.forcing[n..]);
        let vanish: Vec<_> = of_constraints.map(|e| (*e, Expr::ZERO)).collect();
        let vanish = all_equal(arena, comparer, &vanish);
        let (u, q) = (label(speeds), label(rates));
        let map = format!(
            "{u} = Wᵀ · {q}, the multipliers cancel, and the rows of the constraints vanish, with q' = W u + w; what {q} has \
             beside {u} gives the multipliers"
        );
        (all([forward, vanish]), map)
    }

    /// Proves Speeds = P · Balances; rows of the balances that P does not use give the reactions.
    fn speeds_and_balances(&mut self, speeds: &Equations, balances: &Equations) -> FormulationVerdict {
        let Self { model, kinematics, comparer, .. } = self;
        let combined = combine(&mut kinematics.arena, &balances.projection, balances);
        let identity = equal_systems(&mut kinematics.arena, comparer, &combined, speeds, model.reactions.len());
        let (back, equations) = reactions_from(model, kinematics, balances);
        self.reactions.get_or_insert(equations);
        let names: Vec<&str> = model.reactions.iter().map(|r| r.name.as_str()).collect();
        let given = match names.as_slice() {
            [] => "both have the same number of rows".to_owned(),
            [one] => format!("the remaining equation gives {one}"),
            _ => format!("the remaining equations give {}", names.join(", ")),
        };
        let (u, b) = (label(speeds), label(balances));
        (all([identity, back]), format!("{u} = (partial velocities) · {b}, the reactions cancel; {given}"))
    }

    /// Proves Rates = P · Balances, with the partial velocities with respect to q̇.
    fn rates_and_balances(&mut self, rates: &Equations, balances: &Equations) -> FormulationVerdict {
        let Self { model, kinematics, comparer, maps, .. } = self;
        let rows = rows_of(model, kinematics, balances);
        let velocities = kinematics.in_rates.clone();
        let mut partial = partial_velocities(model, kinematics, &velocities, &rows, &model.q_dot());
        if !model.motion_constraints.is_empty() {
            return self.multipliers_and_balances(&partial, rates, balances);
        }
        // Jᵀ turns rows along u into rows along q̇.
        let of_powers: Matrix = balances.projection.iter().map(|row| row[rows.len()..].to_vec()).collect();
        for (at, row) in partial.iter_mut().enumerate() {
            let along: Vec<Expr> = maps.j.iter().map(|row| row[at]).collect();
            for column in transposed(&of_powers) {
                row.push(dot(&mut kinematics.arena, &along, &column));
            }
        }
        let in_rates = maps.to_rates(model, &mut kinematics.arena, balances);
        let combined = combine(&mut kinematics.arena, &partial, &in_rates);
        let identity = equal_systems(&mut kinematics.arena, comparer, &combined, rates, model.reactions.len());
        let (q, b) = (label(rates), label(balances));
        (identity, format!("{q} = (partial velocities with respect to q') · {b}, the reactions cancel"))
    }

    /// Proves Rates = P · Balances up to the forces of the constraints. Wᵀ cancels these forces on both sides. So the
    /// reactions along q̇ are Aᵀλ for exactly one λ.
    fn multipliers_and_balances(
        &mut self,
        partial: &Matrix,
        rates: &Equations,
        balances: &Equations,
    ) -> FormulationVerdict {
        let Self { model, kinematics, comparer, maps, .. } = self;
        let arena = &mut kinematics.arena;
        let p = model.speeds.len();
        let in_speeds = maps.to_speeds(model, arena, rates);
        let Combined { matrix, right } = combine(arena, partial, balances);
        let mut pairs = Vec::new();
        for (at, (row, value)) in matrix.iter().zip(&right).enumerate() {
            pairs.extend(row[..p].iter().copied().zip(in_speeds.matrix[at].iter().copied()).take(p));
            pairs.push((*value, in_speeds.forcing[at]));
        }
        // The power of shared reactions along a speed is cancelled by the rows that set their total power to zero.
        let is_power = |row: &RowName| matches!(row, RowName::Power(_) | RowName::Law { .. });
        let powers = balances.rows.iter().position(is_power).unwrap_or(balances.rows.len());
        for (column, multipliers) in transposed(&maps.w).into_iter().zip(&balances.projection) {
            for reaction in p..balances.unknowns.len() {
                let along: Vec<Expr> = matrix.iter().map(|row| row[reaction]).collect();
                let shared: Vec<Expr> = balances.matrix[powers..].iter().map(|row| row[reaction]).collect();
                let (alone, others) = (dot(arena, &column, &along), dot(arena, &multipliers[powers..], &shared));
                pairs.push((arena.add(alone, others), Expr::ZERO));
            }
        }
        let (q, b) = (label(rates), label(balances));
        let map = format!(
            "{q} = (partial velocities with respect to q') · {b}, the reactions being Aᵀλ along q', which W cancels on both sides"
        );
        (all_equal(arena, comparer, &pairs), map)
    }
}

fn label(equations: &Equations) -> &'static str {
    equations.formulation.method().label
}

/// Maps between speeds and rates: q̇ = W u + w, q̈ = W u̇ + x, and u = J q̇ + d, u̇ = J q̈ + y.
struct Maps {
    w: Matrix,
    j: Matrix,
    /// Accelerations q̈ for u̇ = 0, in q and u.
    x: Vec<Expr>,
    /// Accelerations u̇ for q̈ = 0, in q and q̇.
    y: Vec<Expr>,
}

impl Maps {
    fn new(model: &Model, arena: &mut Arena) -> Self {
        let jacobian = |arena: &mut Arena, rows: &[Expr], by: &[Expr]| -> Matrix {
            let partials: Vec<Differential> = by.iter().map(|s| Differential::partial(*s)).collect();
            rows.iter().map(|row| partials.clone().iter_mut().map(|d| d.apply(arena, *row)).collect()).collect()
        };
        let rates = &model.kinematic_equations.rates;
        let definitions: Vec<Expr> = model.speeds.iter().map(|s| s.definition).collect();
        // Time derivatives along the motion, without the terms in accelerations.
        let along_speeds: Vec<_> = model.q().into_iter().zip(rates.iter().copied()).collect();
        let along_rates: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        let mut by_speeds = Differential::along(&along_speeds);
        let mut by_rates = Differential::along(&along_rates);
        Self {
            w: jacobian(arena, rates, &model.u()),
            j: jacobian(arena, &definitions, &model.q_dot()),
            x: rates.iter().map(|e| by_speeds.apply(arena, *e)).collect(),
            y: definitions.iter().map(|e| by_rates.apply(arena, *e)).collect(),
        }
    }

    /// Rewrites equations in u̇ and further unknowns as equations in q̈ and the further unknowns: A u̇ = A J q̈ + A y.
    fn to_rates(&self, model: &Model, arena: &mut Arena, equations: &Equations) -> Equations {
        let mut to_rates = speeds_to_rates(model);
        let n = model.speeds.len();
        let mut result = equations.clone();
        for (row, right) in result.matrix.iter_mut().zip(&mut result.forcing) {
            for entry in &mut *row {
                *entry = to_rates.apply(arena, *entry);
            }
            let shift = dot(arena, &row[..n], &self.y);
            let known = to_rates.apply(arena, *right);
            *right = arena.sub(known, shift);
            let moved: Vec<Expr> = (0..n).map(|i| dot(arena, &row[..n], &column(&self.j, i))).collect();
            row[..n].copy_from_slice(&moved);
        }
        result
    }

    /// Rewrites equations in q̈ and further unknowns as equations in u̇ and the further unknowns.
    fn to_speeds(&self, model: &Model, arena: &mut Arena, equations: &Equations) -> Equations {
        let mut to_speeds = rates_to_speeds(model);
        let mut result = equations.clone();
        for (row, right) in result.matrix.iter_mut().zip(&mut result.forcing) {
            for entry in &mut *row {
                *entry = to_speeds.apply(arena, *entry);
            }
            let n = self.w.len();
            let shift = dot(arena, &row[..n], &self.x);
            let known = to_speeds.apply(arena, *right);
            *right = arena.sub(known, shift);
            let others = row[n..].to_vec();
            *row = (0..model.speeds.len()).map(|i| dot(arena, &row[..n], &column(&self.w, i))).chain(others).collect();
        }
        result.unknowns.splice(..model.coordinates.len(), model.speeds.iter().map(|s| s.rate));
        result
    }
}

fn transposed(matrix: &Matrix) -> Matrix {
    (0..matrix.first().map_or(0, Vec::len)).map(|at| column(matrix, at)).collect()
}

fn column(matrix: &Matrix, at: usize) -> Vec<Expr> {
    matrix.iter().map(|row| row[at]).collect()
}

fn dot(arena: &mut Arena, a: &[Expr], b: &[Expr]) -> Expr {
    let products: Vec<Expr> = a.iter().zip(b).map(|(a, b)| arena.mul(*a, *b)).collect();
    arena.sum(&products)
}

/// Linear system: its matrix and its right-hand side.
struct Combined {
    matrix: Matrix,
    right: Vec<Expr>,
}

/// Combination of rows of a system, one for each row of `multipliers`.
fn combine(arena: &mut Arena, multipliers: &Matrix, system: &Equations) -> Combined {
    let width = system.unknowns.len();
    let matrix =
        multipliers.iter().map(|by| (0..width).map(|c| dot(arena, by, &column(&system.matrix, c))).collect()).collect();
    Combined { matrix, right: multipliers.iter().map(|by| dot(arena, by, &system.forcing)).collect() }
}

/// Compares combined rows with the rows of `expected`. The coefficients of `extra` further unknowns must vanish.
fn equal_systems(
    arena: &mut Arena,
    comparer: &mut Comparer,
    combined: &Combined,
    expected: &Equations,
    extra: usize,
) -> Verdict {
    let mut pairs = Vec::new();
    for (at, (row, value)) in combined.matrix.iter().zip(&combined.right).enumerate() {
        let wanted = expected.matrix[at].iter().copied().chain(std::iter::repeat_n(Expr::ZERO, extra));
        pairs.extend(row.iter().copied().zip(wanted));
        pairs.push((*value, expected.forcing[at]));
    }
    all_equal(arena, comparer, &pairs)
}

/// Balances that are rows of the Newton–Euler equations, because they are not 0 = 0.
fn rows_of(model: &Model, kinematics: &mut Kinematics, newton_euler: &Equations) -> Vec<Balance> {
    let velocities = kinematics.in_speeds(model);
    let mut rows = balances(model, kinematics, &velocities, None);
    rows.retain(|row| newton_euler.rows.contains(&RowName::Balance(row.name)));
    rows
}

/// Proves that Kane's rows and one further row for each reaction are equivalent to Newton–Euler. Solves the further
/// rows for the reactions.
fn reactions_from(
    model: &Model,
    kinematics: &mut Kinematics,
    newton_euler: &Equations,
) -> (Verdict, Vec<ReactionEquation>) {
    let mut basis = newton_euler.projection.clone();
    let mut further: Matrix = Vec::new();
    let count = newton_euler.rows.len();
    let unit = |at: usize| (0..count).map(|k| if k == at { Expr::ONE } else { Expr::ZERO }).collect::<Vec<_>>();
    let directions = along_reactions(model, kinematics, &newton_euler.rows);
    // The balance along each reaction is the natural further row. If it depends on earlier rows, plain rows are used.
    for candidate in directions.into_iter().chain((0..count).map(unit)) {
        if further.len() == model.reactions.len() {
            break;
        }
        basis.push(candidate.clone());
        if rank(&kinematics.arena, &basis).is_some_and(|found| found.dependent.is_none()) {
            further.push(candidate);
        } else {
            basis.pop();
        }
    }
    if basis.len() != count {
        let why = format!("Kane's rows and the balances along the reactions have rank {}, not {count}", basis.len());
        return (Verdict::Undecided(why), Vec::new());
    }
    let n = model.speeds.len();
    let Combined { matrix, right } = combine(&mut kinematics.arena, &further, newton_euler);
    let Kinematics { arena, simplifier, .. } = kinematics;
    let mut known = Vec::new();
    for (row, right) in matrix.iter().zip(&right) {
        let moving = dot(arena, &row[..n], &newton_euler.unknowns[..n]);
        let rest = arena.sub(*right, moving);
        known.push(vec![simplifier.simplify(arena, rest)]);
    }
    let unknown: Matrix =
        matrix.iter().map(|row| row[n..].iter().map(|e| simplifier.simplify(arena, *e)).collect()).collect();
    let Ok((values, _)) = solve(arena, simplifier, &unknown, &known) else {
        return (Verdict::Undecided("the further rows do not determine the reactions".to_owned()), Vec::new());
    };
    let named = model.reactions.iter().zip(values);
    let equations = named.map(|(r, value)| ReactionEquation { name: r.name.clone(), value: value[0] }).collect();
    (Verdict::Equal(crate::algebra::meaning::compare::Engine::NormalForm), equations)
}
