//! Proof that the formulations of Kane, Lagrange and Newton–Euler are equivalent. Each pair is
//! related by linear combinations of rows.
//!
//! With q̇ = W u + w and u = J q̇ + d: Kane = Wᵀ · Lagrange and Lagrange = Jᵀ · Kane, so both hold
//! together where det J ≠ 0. P are the partial velocities, of mass centres for forces and of frames
//! for moments. Then Kane = P · (Newton–Euler), in which the reactions cancel.
//!
//! P and as many further rows D as there are reactions form a regular matrix. So Kane's equations
//! and the rows D, which give the reactions, are equivalent to Newton–Euler.

use super::combination::{Combination, CombinationDescription, CombinationKind, CombinationPart};
use super::speed_rate_maps::{CombinedSystem, Maps, Matrix, combine_rows, dot, transposed};
use super::verdicts::{Compared, combined_verdict, verdict_on_pairs};
use crate::algebra::Expr;
use crate::algebra::meaning::compare::{Comparer, Verdict};
use crate::algebra::solve::linear::solve_linear;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::value::rank::rank;
use crate::mechanics::{
    Balance, Derivations, Equations, Formulation, Kinematics, RowName, balance_multipliers_along_reactions,
    newton_euler_balances, newton_euler_partial_velocities, speeds_to_rates,
};
use crate::model::Model;

/// Pair of formulations, with the proof that their equations are equivalent.
#[derive(Clone, Debug)]
pub struct EquivalentPair {
    /// First formulation, in the order of [`Formulation::ALL`].
    pub left: Formulation,
    /// Second formulation, in the order of [`Formulation::ALL`].
    pub right: Formulation,
    /// Verdict on the claim that the rows of each formulation are linear combinations of the
    /// other's rows, as stated in `map`.
    pub verdict: Verdict,
    /// Description of the linear combinations that lead from one formulation to the other.
    pub map: CombinationDescription,
    /// Combinations of rows that were proved, with their multipliers and identities. A combination
    /// whose proof failed has no identities.
    pub combinations: Vec<Combination>,
}

/// Reaction as a function of the motion. It comes from a Newton–Euler row that is independent of
/// Kane's rows.
#[derive(Clone, Debug)]
pub struct ReactionEquation {
    /// Name of the reaction in the model file.
    pub name: String,
    /// Value of the reaction as a term in q, u and u̇.
    pub value: Expr,
}

/// Proves that all derived formulations are pairwise equivalent, and solves for the reactions.
/// Returns the pairs and one equation for each reaction. There are no such equations if
/// Newton–Euler was not derived.
pub fn prove_equivalence(
    model: &Model,
    derivations: &mut Derivations,
    comparer: &mut Comparer,
) -> (Vec<EquivalentPair>, Vec<ReactionEquation>) {
    let list: Vec<Equations> = Formulation::ALL.into_iter().filter_map(|f| derivations.get(f).cloned()).collect();
    let kinematics = &mut derivations.kinematics;
    let maps = Maps::new(model, &mut kinematics.arena);
    let mut prover = Prover { model, kinematics, comparer, maps, reactions: None };
    let mut pairs = Vec::new();
    for (at, left) in list.iter().enumerate() {
        for right in &list[at + 1..] {
            let found =
                prover.prove_equivalence_between(left, right).or_else(|| prover.prove_equivalence_between(right, left));
            pairs.extend(found.map(|EquivalenceResult { verdict, map, combinations }| EquivalentPair {
                left: left.formulation,
                right: right.formulation,
                verdict,
                map,
                combinations,
            }));
        }
    }
    let reactions = prover.reactions.unwrap_or_default();
    prove_pairs_through_others(&mut pairs);
    (pairs, reactions)
}

/// Completes the verdicts by transitivity: if a ⇔ b and b ⇔ c are proved, then a ⇔ c holds with the weaker of both
/// bounds, and is neither different nor undecided. The direct claim about a and c may be too strong: a potential along
/// a prescribed motion and its forces need not give the same row there, but only the multiplier of the drive differs.
fn prove_pairs_through_others(pairs: &mut [EquivalentPair]) {
    while let Some((at, middle, verdict)) = provable_pair(pairs) {
        pairs[at].verdict = verdict;
        pairs[at].map.kind = CombinationKind::Through(middle);
        pairs[at].combinations.clear();
    }
}

/// Finds a pair that is not proved although both of its formulations are proved equivalent to a third one. Returns the
/// pair's index, the third formulation, and the verdict that follows.
fn provable_pair(pairs: &[EquivalentPair]) -> Option<(usize, Formulation, Verdict)> {
    let proved = |a: Formulation, b: Formulation| {
        let pair = pairs.iter().find(|pair| (pair.left, pair.right) == (a, b) || (pair.left, pair.right) == (b, a));
        pair.map(|pair| pair.verdict.clone()).filter(Verdict::is_equal)
    };
    let open = pairs.iter().enumerate().filter(|(_, pair)| !pair.verdict.is_equal());
    open.flat_map(|(at, pair)| Formulation::ALL.into_iter().map(move |middle| (at, pair, middle))).find_map(
        |(at, pair, middle)| {
            let steps = [proved(pair.left, middle)?, proved(middle, pair.right)?];
            Some((at, middle, combined_verdict(steps)))
        },
    )
}

/// Result of the proof for a pair of formulations: verdict, proved combinations and their
/// description.
struct EquivalenceResult {
    /// Verdict on the claim that both formulations are equivalent.
    verdict: Verdict,
    /// Description of the linear combination of rows.
    map: CombinationDescription,
    /// Combinations that were proved, one for each direction.
    combinations: Vec<Combination>,
}

/// Model and tools with which pairs of formulations are proved equivalent.
struct Prover<'a> {
    model: &'a Model,
    kinematics: &'a mut Kinematics,
    comparer: &'a mut Comparer,
    maps: Maps,
    /// Equations for the reactions; `None` until Newton–Euler has been compared with a formulation
    /// in speeds.
    reactions: Option<Vec<ReactionEquation>>,
}

impl Prover<'_> {
    /// Proves two systems equivalent. `None` if the proof is implemented only for the opposite
    /// order of the arguments.
    fn prove_equivalence_between(&mut self, left: &Equations, right: &Equations) -> Option<EquivalenceResult> {
        let (from, to) = (left.formulation, right.formulation);
        match (from.has_reactions(), to.has_reactions()) {
            (false, false) if from.is_in_rates() == to.is_in_rates() => Some(self.prove_equal_row_by_row(left, right)),
            (false, false) if to.is_in_rates() => Some(self.speeds_and_rates(left, right)),
            (false, true) if from.is_in_rates() => Some(self.rates_and_balances(left, right)),
            (false, true) => Some(self.speeds_and_balances(left, right)),
            _ => None,
        }
    }

    /// Proves that two systems in the same motion variables, without reactions, are equal row by row.
    fn prove_equal_row_by_row(&mut self, left: &Equations, right: &Equations) -> EquivalenceResult {
        let rows = CombinedSystem { matrix: left.matrix.clone(), right: left.forcing.clone() };
        let claims = equivalence_claims(&rows, right, 0);
        let proved = self.prove_proposal(Proposal {
            of: left,
            gives: right,
            relations: Vec::new(),
            multipliers: Vec::new(),
            claims,
        });
        EquivalenceResult::new(CombinationKind::RowByRow, left, right, [proved])
    }

    /// Proves the claims of a proposed combination. Returns the verdict, and the combination with
    /// the proved identities.
    fn prove_proposal(&mut self, proposal: Proposal<'_>) -> (Verdict, Combination) {
        let Proposal { of, gives, relations, multipliers, claims } = proposal;
        let pairs: Vec<(Expr, Expr)> = claims.iter().map(|claim| claim.sides).collect();
        let Compared { verdict, identities } = verdict_on_pairs(&mut self.kinematics.arena, self.comparer, &pairs);
        let identities = claims.iter().map(|claim| claim.part).zip(identities).collect();
        let (of, gives) = (of.formulation, gives.formulation);
        (verdict, Combination { of, gives, relations, multipliers, identities })
    }

    /// Proves that equations along speeds u and equations along rates q̇ are equivalent: Speeds =
    /// Wᵀ · Rates and Rates = Jᵀ · Speeds.
    fn speeds_and_rates(&mut self, speeds: &Equations, rates: &Equations) -> EquivalenceResult {
        if !self.model.motion_constraints.is_empty() {
            return self.speeds_and_multipliers(speeds, rates);
        }
        let Self { model, kinematics, maps, .. } = self;
        let arena = &mut kinematics.arena;
        let in_speeds = maps.to_speeds(model, arena, rates);
        let multipliers = transposed(&maps.w);
        let claims_of_speeds = equivalence_claims(&combine_rows(arena, &multipliers, &in_speeds), speeds, 0);
        let relations = maps.rates_in_speeds(model, arena);
        let forward = Proposal { of: rates, gives: speeds, relations, multipliers, claims: claims_of_speeds };
        let in_rates = maps.to_rates(model, arena, speeds);
        let mut to_rates = speeds_to_rates(model);
        let multipliers: Matrix =
            transposed(&maps.j).iter().map(|row| row.iter().map(|e| to_rates.apply(arena, *e)).collect()).collect();
        let claims_of_rates = equivalence_claims(&combine_rows(arena, &multipliers, &in_rates), rates, 0);
        let relations = maps.speeds_in_rates(model, arena);
        let backward = Proposal { of: speeds, gives: rates, relations, multipliers, claims: claims_of_rates };
        // If a speed has a value other than 0 at q̇ = 0, the map from rates to speeds is affine.
        let pairs: Vec<_> = model.q_dot().into_iter().map(|rate| (rate, Expr::ZERO)).collect();
        let mut at_rest = Substitution::new(&pairs);
        let homogeneous = model.speeds.iter().all(|s| at_rest.apply(arena, s.definition) == Expr::ZERO);
        let kind = if homogeneous { CombinationKind::LinearSpeeds } else { CombinationKind::AffineSpeeds };
        let proved = [self.prove_proposal(forward), self.prove_proposal(backward)];
        EquivalenceResult::new(kind, speeds, rates, proved)
    }

    /// Proves Speeds = Wᵀ · Rates, in which the constraint multipliers cancel. In terms of speeds,
    /// the rows of the constraints are 0 = 0.
    fn speeds_and_multipliers(&mut self, speeds: &Equations, rates: &Equations) -> EquivalenceResult {
        let Self { model, kinematics, maps, .. } = self;
        let arena = &mut kinematics.arena;
        let (n, m) = (model.coordinates.len(), model.motion_constraints.len());
        let in_speeds = maps.to_speeds(model, arena, rates);
        let relations = maps.rates_in_speeds(model, arena);
        let multipliers = transposed(&maps.w);
        let mut claims = equivalence_claims(&combine_rows(arena, &multipliers, &in_speeds), speeds, m);
        let of_constraints = in_speeds.matrix[n..].iter().flatten().chain(&in_speeds.forcing[n..]);
        claims.extend(of_constraints.map(|e| Claim { part: CombinationPart::Constraint, sides: (*e, Expr::ZERO) }));
        let proved = self.prove_proposal(Proposal { of: rates, gives: speeds, relations, multipliers, claims });
        EquivalenceResult::new(CombinationKind::Multipliers, speeds, rates, [proved])
    }

    /// Proves Speeds = P · Balances with the partial velocities P. The reactions follow from
    /// further combinations of the balances.
    fn speeds_and_balances(&mut self, speeds: &Equations, balances: &Equations) -> EquivalenceResult {
        let Self { model, kinematics, .. } = self;
        let multipliers = balances.projection.clone();
        let combined = combine_rows(&mut kinematics.arena, &multipliers, balances);
        let claims = equivalence_claims(&combined, speeds, model.reactions.len());
        let names = model.reactions.iter().map(|reaction| reaction.name.clone()).collect();
        let proved =
            self.prove_proposal(Proposal { of: balances, gives: speeds, relations: Vec::new(), multipliers, claims });
        let (back, equations) = prove_reaction_equivalence(self.model, self.kinematics, balances);
        self.reactions.get_or_insert(equations);
        let found = EquivalenceResult::new(CombinationKind::PartialVelocities(names), speeds, balances, [proved]);
        EquivalenceResult { verdict: combined_verdict([found.verdict, back]), ..found }
    }

    /// Proves Rates = P · Balances, with the partial velocities P with respect to q̇.
    fn rates_and_balances(&mut self, rates: &Equations, balances: &Equations) -> EquivalenceResult {
        let Self { model, kinematics, maps, .. } = self;
        let rows = balances_for_equivalence(model, kinematics, balances);
        let velocities = kinematics.in_rates.clone();
        let mut partial = newton_euler_partial_velocities(model, kinematics, &velocities, &rows, &model.q_dot());
        if !model.motion_constraints.is_empty() {
            return self.multipliers_and_balances(partial, rates, balances);
        }
        // The rows of powers are along speeds u; Jᵀ converts them to rows along rates q̇.
        let of_powers: Matrix = balances.projection.iter().map(|row| row[rows.len()..].to_vec()).collect();
        for (at, row) in partial.iter_mut().enumerate() {
            let along: Vec<Expr> = maps.j.iter().map(|row| row[at]).collect();
            for column in transposed(&of_powers) {
                row.push(dot(&mut kinematics.arena, &along, &column));
            }
        }
        let in_rates = maps.to_rates(model, &mut kinematics.arena, balances);
        let relations = maps.speeds_in_rates(model, &mut kinematics.arena);
        let combined = combine_rows(&mut kinematics.arena, &partial, &in_rates);
        let claims = equivalence_claims(&combined, rates, model.reactions.len());
        let proved =
            self.prove_proposal(Proposal { of: balances, gives: rates, relations, multipliers: partial, claims });
        EquivalenceResult::new(CombinationKind::PartialVelocitiesOfRates, rates, balances, [proved])
    }

    /// Proves Rates = P · Balances, except for the constraint forces. Wᵀ cancels these forces on
    /// both sides, so the reactions along q̇ are Aᵀλ with unique multipliers λ.
    fn multipliers_and_balances(
        &mut self,
        partial: Matrix,
        rates: &Equations,
        balances: &Equations,
    ) -> EquivalenceResult {
        let Self { model, kinematics, maps, .. } = self;
        let arena = &mut kinematics.arena;
        let p = model.speeds.len();
        let in_speeds = maps.to_speeds(model, arena, rates);
        let relations = maps.rates_in_speeds(model, arena);
        let CombinedSystem { matrix, right } = combine_rows(arena, &partial, balances);
        let mut claims = Vec::new();
        for (at, (row, value)) in matrix.iter().zip(&right).enumerate() {
            let pairs = row[..p].iter().copied().zip(in_speeds.matrix[at].iter().copied()).take(p);
            let part = |unknown| CombinationPart::Coefficient { row: at, unknown };
            claims.extend(pairs.enumerate().map(|(unknown, sides)| Claim { part: part(unknown), sides }));
            claims.push(Claim { part: CombinationPart::Right { row: at }, sides: (*value, in_speeds.forcing[at]) });
        }
        // Rows that set the total power of shared reactions to zero cancel the power of these
        // reactions along each speed.
        let is_power = |row: &RowName| matches!(row, RowName::Power(_) | RowName::Law { .. });
        let powers = balances.rows.iter().position(is_power).unwrap_or(balances.rows.len());
        for (speed, (column, multipliers)) in transposed(&maps.w).iter().zip(&balances.projection).enumerate() {
            for unknown in p..balances.unknowns.len() {
                let along: Vec<Expr> = matrix.iter().map(|row| row[unknown]).collect();
                let shared: Vec<Expr> = balances.matrix[powers..].iter().map(|row| row[unknown]).collect();
                let (alone, others) = (dot(arena, column, &along), dot(arena, &multipliers[powers..], &shared));
                let part = CombinationPart::Power { speed, reaction: unknown - p };
                claims.push(Claim { part, sides: (arena.add(alone, others), Expr::ZERO) });
            }
        }
        let proved =
            self.prove_proposal(Proposal { of: balances, gives: rates, relations, multipliers: partial, claims });
        EquivalenceResult::new(CombinationKind::ConstraintForces, rates, balances, [proved])
    }
}

impl EquivalenceResult {
    /// Combines the verdicts of the proved combinations, and describes the relation between `left`
    /// and `right`.
    fn new(
        kind: CombinationKind,
        left: &Equations,
        right: &Equations,
        proved: impl IntoIterator<Item = (Verdict, Combination)>,
    ) -> Self {
        let (verdicts, combinations): (Vec<_>, Vec<_>) = proved.into_iter().unzip();
        let map = CombinationDescription { left: left.formulation, right: right.formulation, kind };
        Self { verdict: combined_verdict(verdicts), map, combinations }
    }
}

/// Claim that two terms are equal, with the part of the linear system to which it belongs.
struct Claim {
    /// Part of the linear system to which the claim belongs, such as a coefficient.
    part: CombinationPart,
    /// Two terms that are claimed to be equal.
    sides: (Expr, Expr),
}

/// Proposed combination of rows, before its claims are proved.
struct Proposal<'a> {
    /// Equations whose rows are combined.
    of: &'a Equations,
    /// Equations whose rows the combination should give.
    gives: &'a Equations,
    /// Substitutions before the combination, as pairs (symbol, value).
    relations: Vec<(Expr, Expr)>,
    /// Multipliers of the rows, one list for each row of the result.
    multipliers: Matrix,
    /// Equalities of terms that must hold for the combination to be right.
    claims: Vec<Claim>,
}

/// Claims that the combined rows equal the rows of `expected`. The combined rows have `extra`
/// further unknowns; their coefficients must be zero.
fn equivalence_claims(combined: &CombinedSystem, expected: &Equations, extra: usize) -> Vec<Claim> {
    let mut claims = Vec::new();
    for (at, (row, value)) in combined.matrix.iter().zip(&combined.right).enumerate() {
        let wanted = expected.matrix[at].iter().copied().chain(std::iter::repeat_n(Expr::ZERO, extra));
        let part = |unknown| CombinationPart::Coefficient { row: at, unknown };
        let coefficients = row.iter().copied().zip(wanted).enumerate();
        claims.extend(coefficients.map(|(unknown, sides)| Claim { part: part(unknown), sides }));
        claims.push(Claim { part: CombinationPart::Right { row: at }, sides: (*value, expected.forcing[at]) });
    }
    claims
}

/// Balances of the bodies that are rows of the Newton–Euler equations. Balances that read 0 = 0 are
/// no rows.
fn balances_for_equivalence(model: &Model, kinematics: &mut Kinematics, newton_euler: &Equations) -> Vec<Balance> {
    let velocities = kinematics.in_speeds(model);
    let mut rows = newton_euler_balances(model, kinematics, &velocities, None);
    rows.retain(|row| newton_euler.rows.contains(&RowName::Balance(row.name)));
    rows
}

/// Proves that Newton–Euler is equivalent to Kane's rows and one further row for each reaction. The
/// further rows are solved for the reactions. On failure, the verdict is undecided and the list is
/// empty.
fn prove_reaction_equivalence(
    model: &Model,
    kinematics: &mut Kinematics,
    newton_euler: &Equations,
) -> (Verdict, Vec<ReactionEquation>) {
    let mut basis = newton_euler.projection.clone();
    let mut further: Matrix = Vec::new();
    let count = newton_euler.rows.len();
    let unit = |at: usize| (0..count).map(|k| if k == at { Expr::ONE } else { Expr::ZERO }).collect::<Vec<_>>();
    let directions = balance_multipliers_along_reactions(model, kinematics, &newton_euler.rows);
    // The balance along each reaction is tried first as the further row. If it depends on earlier
    // rows, single Newton–Euler rows are tried.
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
    let CombinedSystem { matrix, right } = combine_rows(&mut kinematics.arena, &further, newton_euler);
    let Kinematics { arena, simplifier, .. } = kinematics;
    let mut known = Vec::new();
    for (row, right) in matrix.iter().zip(&right) {
        let moving = dot(arena, &row[..n], &newton_euler.unknowns[..n]);
        let rest = arena.sub(*right, moving);
        known.push(vec![simplifier.simplify(arena, rest)]);
    }
    let unknown: Matrix =
        matrix.iter().map(|row| row[n..].iter().map(|e| simplifier.simplify(arena, *e)).collect()).collect();
    let Ok((values, _)) = solve_linear(arena, simplifier, &unknown, &known) else {
        return (Verdict::Undecided("the further rows do not determine the reactions".to_owned()), Vec::new());
    };
    let named = model.reactions.iter().zip(values);
    let equations = named.map(|(r, value)| ReactionEquation { name: r.name.clone(), value: value[0] }).collect();
    (Verdict::Equal(crate::algebra::meaning::compare::Engine::NormalForm), equations)
}
