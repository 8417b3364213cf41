//! Proofs that the formulations are equivalent, and that certain quantities are constant along
//! every motion.
//!
//! Every statement is an identity between terms, decided by [`crate::algebra::meaning::compare`].
//! Nothing is integrated, sampled in floating point or solved for accelerations. Each system is
//! proved to be a linear combination of the other, with stated multipliers.

mod combination;
mod equivalence;
mod exact;
mod first_integrals;
mod integral_kind;
mod noether;
mod rigid_motions;
mod singularity;
mod speed_rate_maps;
mod verdicts;

pub use combination::{Combination, CombinationDescription, CombinationKind, CombinationPart};
pub use equivalence::{EquivalentPair, ReactionEquation};
pub use exact::{ExactCount, ProvedStatement, prove_exactly};
pub(crate) use first_integrals::IntegralSearchBasis;
pub use first_integrals::{Integral, IntegralSearch};
pub use integral_kind::{IntegralKind, Pivot};
pub(crate) use noether::VectorField;
pub(crate) use rigid_motions::rigid_motion_fields as rigid_motions;
pub use singularity::{DeterminantAtZero, Place, Singularity, singularity, singularity_of_determinant};
pub(crate) use verdicts::combined_verdict;

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::form::written_out_formula::written_out_formula;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::text::definitions::define_names_in_part;
use crate::algebra::{Arena, Expr};
use crate::mechanics::{Derivations, DeriveError, Formulation, LoadDivisor, load_divisors};
use crate::model::Model;

/// Statements that were proved about a model: equivalence of formulations, reactions, first
/// integrals and singular states.
#[derive(Clone, Debug)]
pub struct Proof {
    /// Pairs of the formulations that the model supports, each with the proof that they are equivalent.
    pub pairs: Vec<EquivalentPair>,
    /// Formulations that cannot be derived for the model, each with the reason.
    pub missing: Vec<(Formulation, DeriveError)>,
    /// Equation for each reaction of the model, as a function of the motion.
    pub reactions: Vec<ReactionEquation>,
    /// First integrals: functionally independent quantities that are constant along every motion.
    pub integrals: Vec<Integral>,
    /// Report on the search for first integrals: the symmetries that it covered.
    pub search: IntegralSearch,
    /// Divisors at whose zeros the proved equivalence of the formulations does not hold. There, the
    /// speeds do not determine q̇, or a load has no value.
    pub singular_where: Vec<Expr>,
    /// Divisors of loads that may be zero, each with its load. They are also among `singular_where`.
    pub loads: Vec<LoadDivisor>,
}

impl Proof {
    /// Assigns names to the named subterms of all proved formulas. Every document about the model
    /// uses these names.
    pub fn write_names(&self, derivations: &mut Derivations) {
        derivations.write_names();
        write_integral_names(&self.integrals, derivations);
        let reactions: Vec<Expr> = self.reactions.iter().map(|reaction| reaction.value).collect();
        define_names_in_part(&mut derivations.kinematics.arena, "reaction", &reactions);
    }

    /// True if there are at least two formulations and all pairs are proved equivalent.
    #[must_use]
    pub fn is_equivalent(&self) -> bool {
        !self.pairs.is_empty() && self.pairs.iter().all(|pair| pair.verdict.is_equal())
    }
}

/// Finds the first integrals of a model without the proof of equivalence, which takes nearly all of
/// the time in models with loops. [`prove`] finds the integrals too.
pub fn first_integrals(model: &Model, derivations: &mut Derivations) -> Vec<Integral> {
    let mut integrals = first_integrals::find_first_integrals(model, derivations, &mut Comparer::default()).0;
    write_out_proof_formulas(
        &mut derivations.kinematics.arena,
        integrals.iter_mut().map(|integral| &mut integral.expression),
    );
    integrals
}

/// Writes out named subterms in those formulas that remain short enough to read.
fn write_out_proof_formulas<'a>(arena: &mut Arena, formulas: impl Iterator<Item = &'a mut Expr>) {
    let mut simplifier = Simplifier::default();
    for formula in formulas {
        *formula = written_out_formula(arena, &mut simplifier, *formula);
    }
}

/// Assigns names to the named subterms of first integrals. Every document about the model uses
/// these names. Call [`Derivations::write_names`] first, which names the subterms of the equations.
pub fn write_integral_names(integrals: &[Integral], derivations: &mut Derivations) {
    let values: Vec<Expr> = integrals.iter().map(|integral| integral.expression).collect();
    define_names_in_part(&mut derivations.kinematics.arena, "integral", &values);
}

/// Proves the formulations of a model equivalent, and finds reactions, first integrals and singular
/// divisors.
pub fn prove(model: &Model, derivations: &mut Derivations) -> Proof {
    let mut comparer = Comparer::default();
    let (pairs, mut reactions) = equivalence::prove_equivalence(model, derivations, &mut comparer);
    let (mut integrals, mut search) = first_integrals::find_first_integrals(model, derivations, &mut comparer);
    let loads = load_divisors(&mut derivations.kinematics.arena, model);
    let mut singular_where = model.kinematic_equations.divisors.clone();
    for divisor in &loads {
        if !singular_where.contains(&divisor.value) {
            singular_where.push(divisor.value);
        }
    }
    let arena = &mut derivations.kinematics.arena;
    let shown = reactions.iter_mut().map(|reaction| &mut reaction.value);
    let shown = shown.chain(integrals.iter_mut().map(|integral| &mut integral.expression));
    write_out_proof_formulas(arena, shown.chain(&mut search.power));
    let missing = derivations.list.iter().filter_map(|(f, result)| Some((*f, result.as_ref().err()?.clone())));
    Proof { pairs, missing: missing.collect(), reactions, integrals, search, singular_where, loads }
}
