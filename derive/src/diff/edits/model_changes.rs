//! Comparison of two models: changes of the equations of motion, entry by entry, and of the
//! declarations.

use super::declaration_changes::{Declaration, changed_declarations};
use super::derived_model::DerivedModel;
use super::variable_changes::{VariableChange, find_variable_changes};
use crate::algebra::Expr;
use crate::algebra::meaning::compare::{Comparer, Verdict};
use crate::algebra::term::transfer::Transfer;
use crate::algebra::text::definitions::define_names_in_part;
use crate::mechanics::{Derivations, Formulation};

/// Entry of the equations of motion that differs between an old and a new model.
#[derive(Clone, Debug)]
pub struct EntryChange {
    /// Name of the entry, such as `kane M[u1, u2']`, `T` or `u1`.
    pub name: String,
    /// Value in the old model, as a term in the new model's arena; `None` if the entry is missing in the old model.
    pub old: Option<Expr>,
    /// Value in the new model; `None` if the entry is missing in the new model.
    pub new: Option<Expr>,
    /// Difference new − old, simplified; `None` if the entry is missing in a model.
    pub difference: Option<Expr>,
    /// Verdict on the equality of the two values; `None` if the entry is missing in a model.
    pub verdict: Option<Verdict>,
}

/// Differences between an old model and its edited version.
#[derive(Clone, Debug)]
pub struct ModelDifference {
    /// Entries that differ, in the order of the equations.
    pub changes: Vec<EntryChange>,
    /// Number of compared entries; entries that only one of the models has count, too.
    pub compared: usize,
    /// Formulations that only the old model has, with the reason why the new model lacks them. Their entries are not
    /// compared.
    pub formulations_lost: Vec<(Formulation, String)>,
    /// Formulations that only the new model has; their entries are not compared.
    pub formulations_gained: Vec<Formulation>,
    /// Names of first integrals that only the old model has.
    pub integrals_lost: Vec<String>,
    /// Names of first integrals that only the new model has.
    pub integrals_gained: Vec<String>,
    /// Old variables as formulas in the new variables, if a proof shows that the motion is unchanged; else empty.
    pub variables: Vec<VariableChange>,
    /// Declarations that differ: defaults, units, the domain, elements of the mechanism.
    pub declarations: Vec<Declaration>,
}

impl ModelDifference {
    /// Formulas of the changed entries for documents: old value, new value and difference.
    #[must_use]
    pub fn shown(&self) -> Vec<Expr> {
        self.changes.iter().flat_map(|change| [change.old, change.new, change.difference]).flatten().collect()
    }

    /// Gives written names to the named terms of the comparison, for use in documents. `derivations` belong to the new
    /// model. Terms of the new model get the names that all documents about it use. Terms that only the old model or a
    /// difference has get their own names.
    pub fn write_names(&self, derivations: &mut Derivations) {
        derivations.write_names();
        define_names_in_part(&mut derivations.kinematics.arena, "diff", &self.shown());
    }

    /// True if the equations of motion of both models are equal.
    #[must_use]
    pub fn has_same_equations(&self) -> bool {
        self.changes.is_empty() && self.formulations_lost.is_empty() && self.formulations_gained.is_empty()
    }

    /// True if the models do not differ in anything that can change a number.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.has_same_equations() && self.declarations.is_empty()
    }
}

/// Compares two models. Terms of the old model are copied to the new model's arena, with symbols
/// matched by name.
pub fn diff_models(old: &mut DerivedModel<'_>, new: &mut DerivedModel<'_>) -> ModelDifference {
    let (lost, gained) =
        (formulations_lost(old.derivations, new.derivations), formulations_lost(new.derivations, old.derivations));
    let before = compared_entries(old, &lost);
    let after = compared_entries(new, &gained);
    let why = |formulation| {
        let found = new.derivations.list.iter().find(|(f, _)| *f == formulation);
        found.and_then(|(_, equations)| equations.as_ref().err()).map_or_else(String::new, ToString::to_string)
    };
    let formulations_lost = lost.into_iter().map(|formulation| (formulation, why(formulation))).collect();
    let mut comparer = Comparer::default();
    let changes = entry_changes(old.derivations, &before, new.derivations, &after, &mut comparer);
    let arena = &mut new.derivations.kinematics.arena;
    let declarations =
        changed_declarations(old.model, &old.derivations.kinematics.arena, new.model, arena, &mut comparer);
    let gone = before.iter().filter(|(name, _)| !after.iter().any(|(n, _)| n == name)).count();
    let compared = after.len() + gone;
    let (known, found) = (integral_names(old), integral_names(new));
    let variables = if changes.is_empty() { None } else { find_variable_changes(old, new) };
    ModelDifference {
        variables: variables.unwrap_or_default(),
        changes,
        compared,
        formulations_lost,
        formulations_gained: gained,
        integrals_lost: known.iter().filter(|name| !found.contains(name)).cloned().collect(),
        integrals_gained: found.into_iter().filter(|name| !known.contains(name)).collect(),
        declarations,
    }
}

/// Differences between entries of equal names. Entries of only one model are differences, too, unless they are zero.
fn entry_changes(
    old: &Derivations,
    before: &[(String, Expr)],
    new: &mut Derivations,
    after: &[(String, Expr)],
    comparer: &mut Comparer,
) -> Vec<EntryChange> {
    let kinematics = &mut new.kinematics;
    let mut transfer = Transfer::to_other_model(&old.kinematics.arena, "_old");
    let mut list = Vec::new();
    let find = |list: &[(String, Expr)], name: &str| list.iter().find(|(n, _)| n == name).map(|(_, e)| *e);
    let alone = |name: &String, old, new| EntryChange { name: name.clone(), old, new, difference: None, verdict: None };
    for (name, new) in after {
        let arena = &mut kinematics.arena;
        let Some(old) = find(before, name) else {
            // A new entry that is zero changes nothing.
            if *new != Expr::ZERO {
                list.push(alone(name, None, Some(*new)));
            }
            continue;
        };
        let old = transfer.transfer_term(arena, old);
        let verdict = comparer.compare(arena, old, *new);
        if !verdict.is_equal() {
            let difference = arena.sub(*new, old);
            let difference = Some(kinematics.simplifier.simplify(arena, difference));
            list.push(EntryChange { difference, verdict: Some(verdict), ..alone(name, Some(old), Some(*new)) });
        }
    }
    for (name, old) in before.iter().filter(|(name, e)| find(after, name).is_none() && *e != Expr::ZERO) {
        list.push(alone(name, Some(transfer.transfer_term(&mut kinematics.arena, *old)), None));
    }
    list
}

/// Names of a model's first integrals, in words; empty without a proof.
fn integral_names(of: &DerivedModel<'_>) -> Vec<String> {
    of.proof
        .iter()
        .flat_map(|proof| &proof.integrals)
        .map(|i| i.name(of.model, &of.derivations.kinematics.arena))
        .collect()
}

/// Formulations whose equations exist in the derivations `one` but not in `other`.
fn formulations_lost(one: &Derivations, other: &Derivations) -> Vec<Formulation> {
    Formulation::ALL.into_iter().filter(|f| one.get(*f).is_some() && other.get(*f).is_none()).collect()
}

/// Entries of a model that are compared, with their names: speeds, kinematic equations, energies,
/// matrices and forcing.
/// Formulations in `left_out` are omitted.
fn compared_entries(of: &DerivedModel<'_>, left_out: &[Formulation]) -> Vec<(String, Expr)> {
    let (model, derivations) = (of.model, &*of.derivations);
    let arena = &derivations.kinematics.arena;
    let mut list: Vec<(String, Expr)> = model.speeds.iter().map(|s| (s.name.clone(), s.definition)).collect();
    let rates = model.coordinates.iter().zip(&model.kinematic_equations.rates);
    list.extend(rates.map(|(c, rate)| (format!("{}'", c.name), *rate)));
    let compared = Formulation::ALL.into_iter().filter(|f| !left_out.contains(f));
    for (at, (formulation, e)) in compared.filter_map(|f| Some((f, derivations.get(f)?))).enumerate() {
        let name = formulation.name();
        // The energies are compared once, because every formulation has equal ones.
        if at == 0 {
            list.extend([("T".to_owned(), e.kinetic_energy), ("V".to_owned(), e.potential_energy)]);
        }
        let rows = e.row_names(model);
        for (label, row) in rows.iter().zip(&e.matrix) {
            for (unknown, entry) in e.unknowns.iter().zip(row) {
                let unknown = arena.symbol_name(*unknown).unwrap_or_default();
                list.push((format!("{name} M[{label}, {unknown}]"), *entry));
            }
        }
        let forcing = rows.iter().zip(&e.forcing);
        list.extend(forcing.map(|(label, entry)| (format!("{name} f[{label}]"), *entry)));
    }
    list
}
