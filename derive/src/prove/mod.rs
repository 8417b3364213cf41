//! Proofs that the formulations are equivalent, and of the quantities that every motion conserves.
//!
//! Every statement is an identity between terms, decided by [`crate::algebra::meaning::compare`].
//! Nothing is integrated, sampled in floating point or solved for accelerations. Each system is
//! proved to be a linear combination of the other, with stated multipliers.

mod combination;
mod equivalence;
mod fields;
mod integrals;
mod kind;
mod maps;
mod motions;
mod singular;
mod verdicts;

pub use combination::{Combination, Map, MapKind, Part};
pub use equivalence::{Pair, ReactionEquation};
pub(crate) use fields::Field;
pub(crate) use integrals::Basis;
pub use integrals::{Integral, Search};
pub use kind::{IntegralKind, Pivot};
pub(crate) use motions::fields as rigid_motions;
pub use singular::{Place, Singularity, There, singularity, zeros};
pub(crate) use verdicts::all;

use crate::algebra::form::readable::readable;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::text::definitions::write_down;
use crate::algebra::{Arena, Expr};
use crate::mechanics::{Derivations, DeriveError, Formulation, LoadDivisor, load_divisors};
use crate::model::Model;

/// Statements that were proved about a model: equivalence of formulations, reactions, first
/// integrals and singular places.
#[derive(Clone, Debug)]
pub struct Proof {
    /// Pairs of the formulations that the model supports, each with the proof that they are equivalent.
    pub pairs: Vec<Pair>,
    /// Formulations that cannot be derived for the model, each with the reason.
    pub missing: Vec<(Formulation, DeriveError)>,
    /// Reactions of the model, each with the equation that gives it.
    pub reactions: Vec<ReactionEquation>,
    /// First integrals: functionally independent quantities that are constant along every motion.
    pub integrals: Vec<Integral>,
    /// Report on the search for first integrals: what it covered.
    pub search: Search,
    /// Divisors at whose zeros the formulations are not equivalent, because the speeds do not determine
    /// q̇ or a load has no value.
    pub singular_where: Vec<Expr>,
    /// Divisors of loads that may be zero, each with its load. They are also among `singular_where`.
    pub loads: Vec<LoadDivisor>,
}

impl Proof {
    /// Gives the named subterms of all proved formulas the names that every document about the model
    /// uses.
    pub fn write_names(&self, derivations: &mut Derivations) {
        derivations.write_names();
        write_integral_names(&self.integrals, derivations);
        let reactions: Vec<Expr> = self.reactions.iter().map(|reaction| reaction.value).collect();
        write_down(&mut derivations.kinematics.arena, "reaction", &reactions);
    }

    /// True if there are at least two formulations and all pairs are proved equivalent.
    #[must_use]
    pub fn is_equivalent(&self) -> bool {
        !self.pairs.is_empty() && self.pairs.iter().all(|pair| pair.verdict.is_equal())
    }
}

/// Finds the first integrals of a model without the proof of equivalence. That proof takes nearly
/// all of the time in models with loops. [`prove`] finds the integrals too.
pub fn first_integrals(model: &Model, derivations: &mut Derivations) -> Vec<Integral> {
    let mut integrals = integrals::find(model, derivations, &mut Comparer::default()).0;
    write_out(&mut derivations.kinematics.arena, integrals.iter_mut().map(|integral| &mut integral.expression));
    integrals
}

/// Replaces named subterms by their values in those formulas that then remain short enough to read.
fn write_out<'a>(arena: &mut Arena, formulas: impl Iterator<Item = &'a mut Expr>) {
    let mut simplifier = Simplifier::default();
    for formula in formulas {
        *formula = readable(arena, &mut simplifier, *formula);
    }
}

/// Gives the named subterms of first integrals the names that every document about the model uses.
/// Must follow [`Derivations::write_names`], which names the equations' subterms.
pub fn write_integral_names(integrals: &[Integral], derivations: &mut Derivations) {
    let values: Vec<Expr> = integrals.iter().map(|integral| integral.expression).collect();
    write_down(&mut derivations.kinematics.arena, "integral", &values);
}

/// Proves the formulations of a model equivalent, and finds reactions, first integrals and singular
/// divisors.
pub fn prove(model: &Model, derivations: &mut Derivations) -> Proof {
    let mut comparer = Comparer::default();
    let (pairs, mut reactions) = equivalence::prove(model, derivations, &mut comparer);
    let (mut integrals, mut search) = integrals::find(model, derivations, &mut comparer);
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
    write_out(arena, shown.chain(&mut search.power));
    let missing = derivations.list.iter().filter_map(|(f, result)| Some((*f, result.as_ref().err()?.clone())));
    Proof { pairs, missing: missing.collect(), reactions, integrals, search, singular_where, loads }
}
