//! Identification of inertial parameters from motion. The generalized force M u̇ − f is linear in
//! the inertial parameters. Some parameters have no effect. The base parameters are the smallest
//! set of combinations of the other parameters that determines all motions and all forces.
//!
//! The dependent columns of the regressor Y are found at random states modulo a prime, with all
//! other parameters as symbols. The zero test ([`crate::algebra::value::zero_test`]) then proves
//! the relations, and that no force is left out. The rank proves that no smaller set suffices: a
//! minor that is not 0 modulo a prime is not 0. In closed poses of a mechanism with loops, a
//! smaller set may suffice. It is found in double precision ([`LoopSample`]), and is used only if
//! the sample decides clearly.
//!
//! H. Mayeda, K. Yoshida & K. Osuka, "Base parameters of manipulator dynamic models", IEEE Trans.
//! Robotics and Automation 6 (1990) 312–321; M. Gautier & W. Khalil, "Direct calculation of minimum
//! set of inertial parameters of serial robots", ibid. 368–373; W. Khalil & E. Dombre, *Modeling,
//! Identification and Control of Robots* (2002), § 9.4.

mod base_equations;
mod column_relations;
mod completeness_proof;
mod factor_formula;
mod known_parameters;
mod loop_relations;

pub use base_equations::BaseEquations;
pub use loop_relations::LoopSample;

use crate::algebra::Expr;
use crate::mechanics::{DeriveError, Regressor, RegressorParameters};
use crate::model::Model;
use column_relations::ColumnRelations;
use known_parameters::KnownParameters;

/// Base parameter: a linear combination of inertial parameters that is determined by motions,
/// although the single parameters may not be.
#[derive(Clone, Debug, PartialEq)]
pub struct BaseParameter {
    /// Index of the regressor's column whose parameter has the factor 1 in the combination. This
    /// parameter names the base parameter.
    pub column: usize,
    /// Further parameters in the combination, as pairs (index of the column, factor).
    pub with: Vec<(usize, BaseParameterFactor)>,
}

/// Factor with which an inertial parameter is added to another in a base parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BaseParameterFactor {
    /// Proved formula in parameters other than those that are identified.
    Exact(Expr),
    /// Number that holds only in closed poses, at the parameter values of the model file.
    Number(f64),
    /// Unknown factor: no formula for it was found.
    Unknown,
}

/// Certainty that the base parameters π_b determine all forces: Σ Y_b π_b equals M u̇ − f.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Completeness {
    /// Proved: M u̇ − f − Σ Y_b π_b is identically zero. The value k is the exponent of the error
    /// bound: the statement is wrong with a probability below 2^−k.
    Proved(f64),
    /// Tested only: M u̇ − f − Σ Y_b π_b is zero at every tested random state modulo a prime. There
    /// is no proof, because a factor has no formula.
    AtPoints,
    /// Undecided: M u̇ − f − Σ Y_b π_b contains functions that the zero test does not know.
    Undecided,
    /// Refuted: M u̇ − f − Σ Y_b π_b is not zero, so two derivations disagree. This is a defect of
    /// the program.
    No,
}

/// Identifiable parameters of a model, with the regressor from which they were found.
pub struct Identification {
    /// Regressor of M u̇ − f, with a column for each parameter.
    pub regressor: Regressor,
    /// Base parameters, which together determine all motions and forces.
    pub base: Vec<BaseParameter>,
    /// Indices of the regressor's columns whose parameters have no effect on forces.
    pub without_effect: Vec<usize>,
    /// Number of random states at which the columns of the regressor were evaluated.
    pub states: usize,
    /// Certainty that the base parameters are complete. It is about the base parameters before they
    /// were grouped in closed poses ([`Self::before_grouping`]).
    pub complete: Completeness,
    /// Base parameters that act in closed poses only as parts of other base parameters, each with
    /// its own combination.
    pub grouped: Vec<BaseParameter>,
    /// Sample of closed states from which relations in closed poses were found. `None` without
    /// loops, or if no sample was found.
    pub on_loops: Option<LoopSample>,
    /// True if the mechanism of the model has loops.
    has_loops: bool,
    /// Base parameters before they were grouped in closed poses.
    before_loops: Vec<BaseParameter>,
}

impl Identification {
    /// Finds the base parameters of a model.
    ///
    /// # Errors
    /// [`DeriveError`] if the model cannot be derived, or if a body has an added mass.
    pub fn new(model: &Model, varied: RegressorParameters) -> Result<Self, DeriveError> {
        Ok(Self::of_regressor(model, Regressor::new(model, varied)?))
    }

    /// Finds the base parameters of the parameters for which a regressor of the model has columns.
    #[must_use]
    pub fn of_regressor(model: &Model, mut regressor: Regressor) -> Self {
        let letters = KnownParameters::of(model, &mut regressor.arena, &regressor.columns);
        let arena = regressor.arena.clone();
        let mut found = Self {
            base: Vec::new(),
            without_effect: Vec::new(),
            states: 0,
            complete: Completeness::Undecided,
            grouped: Vec::new(),
            on_loops: None,
            has_loops: !model.loops.is_empty(),
            before_loops: Vec::new(),
            regressor,
        };
        let Some(mut table) = ColumnRelations::new(&arena, &found.regressor.columns, &letters) else {
            return found;
        };
        let Regressor { arena, columns, .. } = &mut found.regressor;
        let made = factor_formula::factor_formulas(&mut table, arena, &letters, columns);
        found.states = table.states;
        found.set_base_parameters(&table.pivots, made);
        found.complete = if found.has_closed_forms() {
            completeness_proof::prove_base_parameters(&mut found.regressor, &found.base)
        } else {
            Completeness::AtPoints
        };
        found.before_loops.clone_from(&found.base);
        found.on_loops =
            if found.has_loops { loop_relations::group_by_loop_relations(model, &mut found) } else { None };
        found
    }

    /// Creates a base parameter for each pivot column, and adds the dependent columns with their
    /// factors. Columns that are neither have no effect.
    fn set_base_parameters(&mut self, pivots: &[usize], made: Vec<factor_formula::DependentColumn>) {
        self.base = pivots.iter().map(|column| BaseParameter { column: *column, with: Vec::new() }).collect();
        let mut is_left: Vec<bool> = (0..self.regressor.columns.len()).map(|at| !pivots.contains(&at)).collect();
        for (column, factors) in made {
            is_left[column] = false;
            for (pivot, factor) in factors {
                self.base[pivot].with.push((column, factor));
            }
        }
        self.without_effect = (0..is_left.len()).filter(|at| is_left[*at]).collect();
    }

    /// True if no smaller set of base parameters suffices. For a mechanism with loops, the sample
    /// of closed poses must show a clear difference between dependent and independent parameters.
    #[must_use]
    pub fn is_minimal(&self) -> bool {
        !self.has_loops || self.on_loops.is_some_and(|seen| seen.is_clear)
    }

    /// Number of base parameters before they were grouped in closed poses; [`Self::complete`] is
    /// about these. `None` if none were grouped.
    #[must_use]
    pub fn before_grouping(&self) -> Option<usize> {
        let count = self.before_loops.len();
        (count > self.base.len()).then_some(count)
    }

    /// Restores the base parameters before they were grouped in closed poses. They hold in all
    /// poses and at all values of the parameters. Groups hold only in closed poses, at the
    /// parameter values of the model file. In closed poses, the columns of the restored parameters
    /// may depend on one another.
    pub fn ungroup(&mut self) {
        if self.before_grouping().is_none() {
            return;
        }
        self.base.clone_from(&self.before_loops);
        self.grouped.clear();
        self.without_effect.retain(|at| self.base.iter().all(|base| base.column != *at));
        self.on_loops = None;
    }

    /// True if every factor in the base parameters is known, as a formula or a number.
    fn has_closed_forms(&self) -> bool {
        self.base.iter().flat_map(|base| &base.with).all(|(_, factor)| *factor != BaseParameterFactor::Unknown)
    }

    /// Indices of the columns whose parameter is a base parameter by itself, without other
    /// parameters in its combination.
    pub fn single_base_parameters(&self) -> impl Iterator<Item = usize> + '_ {
        self.base.iter().filter(|base| base.with.is_empty()).map(|base| base.column)
    }
}
