//! Equations of motion in base parameters: fewer parameters than ten for each body, and so fewer operations.
//!
//! W. Khalil & J.-F. Kleinfinger, "Minimum operations and minimum parameters of the dynamic models of tree structure
//! robots", IEEE J. Robotics and Automation 3 (1987) 517–526. Here the equations come from the recursion of Kane's
//! method. Inertial parameters that name no base parameter are zero in the equations.

use super::{BaseParameter, BaseParameterFactor, Identification};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::steps::Definition;
use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr, Rational};
use crate::mechanics::{
    Anchor, ColumnParameter, Derivation, DeriveError, Formulation, InertialParameter, Regressor, certify_equal_forces,
    equations_with_inertial_parameters,
};
use crate::model::{Model, Parameter};
use std::collections::BTreeSet;

/// Equations of motion in which base parameters take the place of the bodies' masses, mass centres and inertias.
pub struct BaseEquations {
    /// Model with the base parameters behind its own parameters. Their default values follow from the model's.
    pub model: Model,
    /// Kane's equations of the model. M, f and M u̇ − f contain no inertial parameter of a body but the base
    /// parameters. T, V and the power contain the model's own parameters.
    pub derivation: Derivation,
    /// Base parameters: symbol and formula in the model's own parameters, in the order in which `model` has them.
    pub base_parameters: Vec<Definition>,
}

impl BaseEquations {
    /// Formulation by which equations in base parameters are derived.
    pub const FORMULATION: Formulation = Formulation::Kane;

    /// Derives the equations of a model in base parameters, and proves that they are Kane's equations of the model.
    ///
    /// # Errors
    /// Returns a [`DeriveError`] if the model cannot be derived, if a body has an added mass, or if the proof fails.
    pub fn new(model: &Model) -> Result<Self, DeriveError> {
        let mut found = base_parameters_with_formulas(model, &Anchor::parameters)?;
        let with_second_moments = bodies_with_second_moments(model, &mut found);
        if with_second_moments.iter().any(|chosen| *chosen) {
            found = base_parameters_with_formulas(model, &|anchor| {
                if with_second_moments[anchor.body] {
                    anchor.parameters_with_second_moments()
                } else {
                    anchor.parameters()
                }
            })?;
        }
        let regressor = found.regressor;
        let mut extended = Model { arena: regressor.arena, ..model.clone() };
        let mut simplifier = Simplifier::default();
        let mut base_parameters: Vec<Definition> = Vec::new();
        let mut inertial = Vec::new();
        for base in &found.base {
            let column = &regressor.columns[base.column];
            let ColumnParameter::Body(body, parameter) = column.of else { continue };
            let value = base_formula(&mut extended.arena, base, |at| regressor.columns[at].stated);
            let value = simplifier.simplify(&mut extended.arena, value);
            if value == Expr::ZERO {
                continue;
            }
            let name = unused_name(&extended.arena, &format!("base_{}", column.name));
            let symbol = extended.arena.symbol(&name);
            let terms = base.with.iter().map(|(at, _)| regressor.columns[*at].name.as_str());
            let others: Vec<&str> = terms.collect();
            let about = if others.is_empty() {
                format!("base parameter {}", column.name)
            } else {
                format!("base parameter {}, with parts of {}", column.name, others.join(", "))
            };
            extended.parameters.push(Parameter {
                name,
                symbol,
                unit: column.unit.clone(),
                value: None,
                positive: false,
                is_input: false,
                about,
            });
            base_parameters.push(Definition { symbol, value });
            inertial.push((body, parameter, symbol));
        }
        set_default_values(&mut extended, &base_parameters);
        let (arena, equations) = equations_with_inertial_parameters(&extended, &inertial)?;
        certify_equal_forces(&arena, &base_parameters, &equations.required, &regressor.required)
            .map_err(|why| DeriveError::Unsolved(why.into()))?;
        Ok(Self { model: extended, derivation: Derivation { arena, equations }, base_parameters })
    }
}

/// Base parameters of the inertial parameters that `parameters` lists for each body. They hold in all poses, and all
/// their factors have formulas. An inertial parameter that has a factor without a formula becomes a base parameter of
/// its own; the base parameters are then not the fewest possible.
///
/// # Errors
/// Returns a [`DeriveError`] if the model cannot be derived, or if a body has an added mass.
fn base_parameters_with_formulas(
    model: &Model,
    parameters: &dyn Fn(&Anchor) -> Vec<InertialParameter>,
) -> Result<Identification, DeriveError> {
    let regressor = Regressor::of_bodies(model, parameters)?;
    let mut found = Identification::of_regressor(model, regressor);
    found.ungroup();
    if found.base.is_empty() {
        // No relations between the columns were found.
        found.base =
            (0..found.regressor.columns.len()).map(|column| BaseParameter { column, with: Vec::new() }).collect();
    }
    let mut alone = BTreeSet::new();
    for (column, factor) in found.base.iter().flat_map(|base| &base.with) {
        if !matches!(factor, BaseParameterFactor::Exact(_)) {
            alone.insert(*column);
        }
    }
    for base in &mut found.base {
        base.with.retain(|(column, _)| !alone.contains(column));
    }
    found.base.extend(alone.into_iter().map(|column| BaseParameter { column, with: Vec::new() }));
    Ok(found)
}

/// For each body: true if its inertia force takes fewer operations with second moments than with moments of inertia.
/// This holds if the entries of α× + ω×ω× are needed anyhow, for a first moment or a product of inertia, and if the
/// body is not symmetric about its axis.
fn bodies_with_second_moments(model: &Model, found: &mut Identification) -> Vec<bool> {
    let regressor = &mut found.regressor;
    let mut simplifier = Simplifier::default();
    let mut present: Vec<Vec<InertialParameter>> = vec![Vec::new(); model.bodies.len()];
    for base in &found.base {
        if let ColumnParameter::Body(body, parameter) = regressor.columns[base.column].of {
            let value = base_formula(&mut regressor.arena, base, |at| regressor.columns[at].stated);
            if simplifier.simplify(&mut regressor.arena, value) != Expr::ZERO {
                present[body].push(parameter);
            }
        }
    }
    let is_chosen = |anchor: &Anchor| {
        let of_body = &present[anchor.body];
        let across = (anchor.axis + 1) % 3;
        let needs_entries = |p: &InertialParameter| match p {
            InertialParameter::FirstMoment(_) => true,
            InertialParameter::Inertia(i, j) => i != j,
            InertialParameter::Mass | InertialParameter::SecondMoment(_) => false,
        };
        of_body.iter().any(needs_entries) && of_body.contains(&InertialParameter::Inertia(across, across))
    };
    let mut chosen = vec![false; model.bodies.len()];
    regressor.anchors.iter().for_each(|anchor| chosen[anchor.body] = is_chosen(anchor));
    chosen
}

/// Sets the default values of the base parameters from those of the model's own parameters, rounded to doubles. A base
/// parameter stays without a value if it needs a parameter without a value.
fn set_default_values(model: &mut Model, base_parameters: &[Definition]) {
    let own = model.parameters.len() - base_parameters.len();
    let known = &model.parameters[..own];
    let symbols: Vec<Expr> = known.iter().map(|parameter| parameter.symbol).collect();
    let numbers: Vec<f64> = known.iter().map(|p| p.value.as_ref().map_or(f64::NAN, Rational::to_f64)).collect();
    let formulas: Vec<Expr> = base_parameters.iter().map(|base| base.value).collect();
    let Ok(tape) = Tape::<f64>::new(&model.arena, &symbols, &formulas) else { return };
    let values = tape.evaluate(&numbers);
    for (parameter, value) in model.parameters[own..].iter_mut().zip(values) {
        parameter.value = Rational::from_f64_exact(value);
    }
}

/// Formula of a base parameter in the model's parameters. `stated` gives the value of a column's parameter.
fn base_formula(arena: &mut Arena, base: &BaseParameter, stated: impl Fn(usize) -> Expr) -> Expr {
    let mut terms = vec![stated(base.column)];
    for (column, factor) in &base.with {
        if let BaseParameterFactor::Exact(factor) = factor {
            terms.push(arena.mul(*factor, stated(*column)));
        }
    }
    arena.sum(&terms)
}

/// Name that no symbol of the arena has: the wanted name, with underscores appended if it is taken.
fn unused_name(arena: &Arena, wanted: &str) -> String {
    let mut name = wanted.to_owned();
    while arena.find_symbol(&name).is_some() {
        name.push('_');
    }
    name
}
