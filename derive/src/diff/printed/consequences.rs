//! Effects of errors in printed systems on the motion: determinants, drift of first integrals, and differences of
//! accelerations.

use super::judged_system::MatchedMotion;
use super::motion_system::{MotionSystem, SolvedMotion};
use crate::algebra::Expr;
use crate::algebra::meaning::compare::{Comparer, Verdict};
use crate::algebra::solve::linear::determinant;
use crate::diff::equations::row_judgement::RowMatchResult;
use crate::mechanics::{Derivations, Formulation, Kinematics};
use crate::model::Model;
use crate::prove::{Integral, Proof};

/// Time derivative of a first integral of the derived equations along printed equations.
#[derive(Clone, Debug)]
pub struct IntegralRate {
    /// First integral of the derived equations, constant in the true motion.
    pub integral: Integral,
    /// Time derivative of the integral along the printed equations, in q and u; 0 if they conserve
    /// the integral.
    pub rate: Expr,
    /// Verdict on the claim that this time derivative is zero.
    pub verdict: Verdict,
}

/// Consequences of a printed system's errors for the motion: its determinant, first integrals and accelerations.
#[derive(Clone, Debug)]
pub struct Consequences {
    /// Id of the printed system in the publication.
    pub system: String,
    /// Determinant of the printed matrix, expected determinant, and verdict on their equality; `None` if not compared.
    /// The expected determinant is that of the matched derived rows times their factors.
    pub determinant: Option<(Expr, Expr, Verdict)>,
    /// Time derivatives of the first integrals; empty if the system is singular everywhere or too
    /// large to solve.
    pub rates: Vec<IntegralRate>,
    /// Verdict on the claim that the printed system gives the derived accelerations.
    pub accelerations: Verdict,
}

impl Consequences {
    /// Determinants and integral rates that documents show.
    pub fn shown_formulas(&self) -> impl Iterator<Item = Expr> {
        let determinants = self.determinant.iter().flat_map(|(printed, derived, _)| [*printed, *derived]);
        determinants.chain(self.rates.iter().map(|rate| rate.rate))
    }
}

/// Comparison of the accelerations from two printed systems of one publication.
#[derive(Clone, Debug)]
pub struct Agreement {
    /// Id of the first printed system.
    pub left: String,
    /// Id of the second printed system.
    pub right: String,
    /// Verdict on the claim that both systems give equal accelerations.
    pub verdict: Verdict,
}

/// Largest number of unknowns of a system that is solved symbolically.
const MOST_UNKNOWNS: usize = 12;

/// Finds the consequences of every printed system for the motion, and compares the accelerations of every pair of
/// systems.
pub fn find_consequences(
    model: &Model,
    derivations: &mut Derivations,
    comparer: &mut Comparer,
    proof: &Proof,
    motions: &[MatchedMotion],
) -> (Vec<Consequences>, Vec<Agreement>) {
    let truth = derivations.get(Formulation::Kane).cloned();
    let Kinematics { arena, simplifier, .. } = &mut derivations.kinematics;
    let truth = truth.and_then(|kane| {
        let motion = MotionSystem {
            id: Formulation::Kane.name().to_owned(),
            in_rates: false,
            coordinate_rates: kane.coordinate_rates.clone(),
            matrix: kane.matrix.clone(),
            right: kane.forcing.clone(),
        };
        motion.solve(model, arena, simplifier)
    });
    let mut list = Vec::new();
    let mut solutions: Vec<(String, SolvedMotion)> = Vec::new();
    for matched in motions {
        let motion = &matched.motion;
        let derivations = &mut *derivations;
        let determinant = judge_determinant(derivations, comparer, matched);
        let Kinematics { arena, simplifier, .. } = &mut derivations.kinematics;
        let small = motion.matrix.len() <= MOST_UNKNOWNS;
        let solved = if small { motion.solve(model, arena, simplifier) } else { None };
        let Some(solved) = solved else {
            let why = if small { "its matrix is singular everywhere" } else { "it is too large to be solved" };
            let accelerations = Verdict::Undecided(why.to_owned());
            list.push(Consequences { system: motion.id.clone(), determinant, rates: Vec::new(), accelerations });
            continue;
        };
        let mut rates = Vec::new();
        for integral in &proof.integrals {
            let rate = solved.rate(model, arena, simplifier, integral.expression);
            let verdict = comparer.is_zero(arena, rate);
            rates.push(IntegralRate { integral: integral.clone(), rate, verdict });
        }
        let accelerations = match &truth {
            Some(truth) => same_motion(derivations, comparer, &solved, truth),
            None => Verdict::Undecided("there are no derived accelerations".to_owned()),
        };
        list.push(Consequences { system: motion.id.clone(), determinant, rates, accelerations });
        solutions.push((motion.id.clone(), solved));
    }
    let mut agreements = Vec::new();
    for (i, (left, a)) in solutions.iter().enumerate() {
        for (right, b) in &solutions[i + 1..] {
            let verdict = same_motion(derivations, comparer, a, b);
            agreements.push(Agreement { left: left.clone(), right: right.clone(), verdict });
        }
    }
    (list, agreements)
}

/// Verdict on the claim that two solved systems give the same rates q̇ and u̇ and the same
/// violation of constraints.
fn same_motion(derivations: &mut Derivations, comparer: &mut Comparer, a: &SolvedMotion, b: &SolvedMotion) -> Verdict {
    let arena = &mut derivations.kinematics.arena;
    let pairs = a.coordinate_rates.iter().zip(&b.coordinate_rates).chain(a.speed_rates.iter().zip(&b.speed_rates));
    let mut verdicts: Vec<Verdict> = pairs.map(|(x, y)| comparer.compare(arena, *x, *y)).collect();
    let count = a.off_constraints.len().max(b.off_constraints.len());
    for at in 0..count {
        let [x, y] = [a, b].map(|solved| solved.off_constraints.get(at).copied().unwrap_or(Expr::ZERO));
        verdicts.push(comparer.compare(arena, x, y));
    }
    crate::prove::combined_verdict(verdicts)
}

/// Compares the determinant of the printed matrix with that of the matched derived rows times their factors. Returns
/// (printed, expected, verdict). `None` unless the printed rows match different single derived rows.
fn judge_determinant(
    derivations: &mut Derivations,
    comparer: &mut Comparer,
    matched: &MatchedMotion,
) -> Option<(Expr, Expr, Verdict)> {
    let motion = &matched.motion;
    if matched.matrix.len() != motion.matrix.len() || motion.matrix.len() > MOST_UNKNOWNS {
        return None;
    }
    let Kinematics { arena, simplifier, .. } = &mut derivations.kinematics;
    // Derived rows in the order of the matches, each with its factor. If two printed rows match the same derived row,
    // another derived row is missing.
    let mut rows = Vec::new();
    let mut taken = vec![false; matched.matrix.len()];
    for by in &matched.rows {
        let RowMatchResult::Row { at, factor } = by else { return None };
        if std::mem::replace(&mut taken[*at], true) {
            return None;
        }
        rows.push(matched.matrix[*at].iter().map(|e| arena.mul(*factor, *e)).collect::<Vec<_>>());
    }
    let printed = determinant(arena, simplifier, &motion.matrix);
    let expected = determinant(arena, simplifier, &rows);
    let verdict = comparer.compare(arena, printed, expected);
    Some((printed, expected, verdict))
}
