//! Comparison of a reference (equations by another program) with the derived equations, entry by
//! entry.

use super::{Reference, ReferenceError, ReferenceSystem};
use crate::algebra::Expr;
use crate::algebra::meaning::compare::{Comparer, Verdict};
use crate::algebra::text::parse::parse_primed;
use crate::diagnostic::nearest_name_advice;
use crate::diff::equations::row_judgement::{Row as Entries, RowMatchResult, TermTools, judge_row};
use crate::mechanics::{
    Derivations, EnergyQuantity, Formulation, Kinematics, MotionVariables, Quantities, Quantity, QuantityKind,
    RowQuantity, VectorName,
};
use crate::model::Model;
use rustc_hash::{FxHashMap, FxHashSet};

/// Entry of a reference, with the derived value and the verdict.
#[derive(Clone, Debug)]
pub struct ComparedEntry {
    /// Name of the quantity, or position of the entry in a system of equations, such as `kane
    /// matrix[1,2]`.
    pub name: String,
    /// Value in the reference, as a term; `None` if the reference does not contain the entry.
    pub reference: Option<Expr>,
    /// Value that Tripos derived, as a term; `None` if it cannot be derived.
    pub derived: Option<Expr>,
    /// Verdict on the claim that both values are equal; undecided if a value is missing.
    pub verdict: Verdict,
}

/// Compares every entry of a reference with the derived value. The result has the quantities first,
/// then the systems of equations in the order of the formulations. It also has entries that the
/// reference should contain but does not.
///
/// Kane's and Lagrange's equations must agree entry by entry, including signs and factors. A row of
/// Newton–Euler may have another position or a factor. The terms of the result are in the arena of
/// the derivations.
///
/// # Errors
/// [`ReferenceError`] if the reference was derived from another model text, is empty, or uses names
/// that the model does not have.
pub fn compare_reference(
    model: &Model,
    derivations: &mut Derivations,
    reference: &Reference,
) -> Result<Vec<ComparedEntry>, ReferenceError> {
    reference.check_text(&model.source.text)?;
    if let Some(why) = &reference.not_derived {
        return Err(ReferenceError::NotDerived { file: reference.file.clone(), why: why.clone() });
    }
    let names = compared_reference_names(model);
    let quantities = Quantities::new(model, derivations);
    let mut judge =
        ReferenceComparison { reference, names, quantities, comparer: Comparer::default(), found: Vec::new() };
    let mut stated = FxHashSet::default();
    for (name, formula) in &reference.quantities {
        let wrong = |error| ReferenceError::Quantity { file: reference.file.clone(), name: name.clone(), error };
        let quantity = Quantity::parse(name, model).map_err(wrong)?;
        judge.judge_quantity(&quantity, formula)?;
        stated.insert(quantity);
    }
    for quantity in expected_reference_quantities(model) {
        if !stated.contains(&quantity) {
            judge.record_missing_entry(quantity.name(), "the reference leaves it out");
        }
    }
    for formulation in Formulation::STANDARD {
        judge.judge_formulation(formulation)?;
    }
    Ok(judge.found)
}

/// State of a comparison of a reference with derived equations.
struct ReferenceComparison<'a, 'b> {
    /// Reference (equations by another program) that is compared.
    reference: &'a Reference,
    /// Symbols of all names that formulas of the reference may contain.
    names: FxHashMap<String, Expr>,
    /// Quantities as Tripos derives them, for comparison.
    quantities: Quantities<'b>,
    /// Comparer of terms; it decides each verdict.
    comparer: Comparer,
    /// Entries of the reference that were compared so far.
    found: Vec<ComparedEntry>,
}

impl ReferenceComparison<'_, '_> {
    /// Parses a formula of the reference. `name` is the entry that contains the formula, for error
    /// messages.
    fn read(&mut self, name: &str, formula: &str) -> Result<Expr, ReferenceError> {
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let names = &self.names;
        let result = parse_primed(arena, formula, 2, &mut |_, word| {
            let unknown = || {
                (format!("unknown name `{word}`"), Some(nearest_name_advice(word, names.keys().map(String::as_str))))
            };
            names.get(word).copied().ok_or_else(unknown)
        });
        let wrong = |error| ReferenceError::Formula { file: self.reference.file.clone(), name: name.to_owned(), error };
        result.map_err(wrong)
    }

    /// Compares a quantity with its formula in the reference, and records the verdict.
    fn judge_quantity(&mut self, quantity: &Quantity, formula: &str) -> Result<(), ReferenceError> {
        let stated = self.read(quantity.name(), formula)?;
        match self.quantities.value(quantity) {
            Ok(derived) => {
                let has_rates = self.quantities.mentions_rates(derived);
                let variables = if has_rates { MotionVariables::Rates } else { MotionVariables::Speeds };
                self.compare(quantity.name().to_owned(), stated, derived, variables);
            }
            Err(why) => self.record_missing_entry(quantity.name(), &why),
        }
        Ok(())
    }

    /// Rewrites two terms in the given motion variables, compares them, and records the verdict.
    fn compare(&mut self, name: String, stated: Expr, derived: Expr, variables: MotionVariables) {
        let stated = self.rewrite(stated, variables);
        let derived = self.rewrite(derived, variables);
        let verdict = self.comparer.compare(&mut self.quantities.derivations.kinematics.arena, stated, derived);
        self.found.push(ComparedEntry { name, reference: Some(stated), derived: Some(derived), verdict });
    }

    /// Rewrites a term in q and the motion variables `variables`: speeds u or rates q̇, with their
    /// time derivatives.
    fn rewrite(&mut self, e: Expr, variables: MotionVariables) -> Expr {
        match variables {
            MotionVariables::Rates => self.quantities.in_rates(e),
            MotionVariables::Speeds => self.quantities.in_speeds(e),
        }
    }

    /// Records an undecided verdict for an entry that is missing, with the reason.
    fn record_missing_entry(&mut self, name: &str, why: &str) {
        let verdict = Verdict::Undecided(why.to_owned());
        self.found.push(ComparedEntry { name: name.to_owned(), reference: None, derived: None, verdict });
    }

    /// Compares the equations by a formulation, or records that the reference does not contain
    /// them.
    fn judge_formulation(&mut self, formulation: Formulation) -> Result<(), ReferenceError> {
        let reference = self.reference;
        let stated = reference.systems.iter().find(|system| system.formulation == formulation);
        let derived = self.quantities.derivations.list.iter().find(|(f, _)| *f == formulation);
        match (stated, derived.map(|(_, result)| result.clone())) {
            (Some(system), Some(Ok(equations))) => {
                let mut rows = equations.matrix;
                rows.iter_mut().zip(equations.forcing).for_each(|(row, right)| row.push(right));
                self.judge_system(system, &rows)?;
            }
            (Some(_), Some(Err(why))) => {
                self.record_missing_entry(formulation.name(), &format!("not derived here: {why}"));
            }
            // Another program cannot know reactions that Tripos introduced itself.
            (None, Some(Ok(_))) if self.quantities.model.reactions.iter().all(|r| r.is_stated) => {
                self.record_missing_entry(formulation.name(), "the reference leaves it out");
            }
            (None, _) | (_, None) => {}
        }
        Ok(())
    }

    /// Compares a system of equations entry by entry. Each row of `derived` has the right-hand side
    /// as its last entry.
    ///
    /// # Errors
    /// `ReferenceError` if the unknowns differ from those of Tripos, or if a formula cannot be
    /// read.
    fn judge_system(&mut self, system: &ReferenceSystem, derived: &[Entries]) -> Result<(), ReferenceError> {
        let (name, variables) = (system.formulation.name(), system.formulation.method().variables);
        let unknowns = system.formulation.unknowns(self.quantities.model);
        let unknowns: Vec<String> = unknowns.into_iter().map(|(name, _)| name).collect();
        if system.unknowns != unknowns {
            let expected = format!("{}, in this order", unknowns.join(", "));
            return Err(super::form_error(&self.reference.file, &format!("unknowns of {name}"), &expected));
        }
        let first = self.found.len();
        let mut stated = Vec::new();
        for (i, (formulas, right)) in system.matrix.iter().zip(&system.forcing).enumerate() {
            let mut row = Entries::new();
            for (j, formula) in formulas.iter().chain([right]).enumerate() {
                let entry = if j == unknowns.len() {
                    format!("{name} forcing[{}]", i + 1)
                } else {
                    format!("{name} matrix[{},{}]", i + 1, j + 1)
                };
                let e = self.read(&entry, formula)?;
                self.compare(entry, e, derived[i][j], variables);
                row.push(self.rewrite(e, variables));
            }
            stated.push(row);
        }
        // Newton–Euler balances have no fixed order, so their rows may be in another order.
        if system.formulation.has_reactions() {
            self.match_rows(first, &stated, derived);
        }
        Ok(())
    }

    /// Matches stated rows that differ from the derived row of the same index with other derived
    /// rows, up to a factor. A derived row matches at most one stated row. `first` is the index in
    /// `found` of the system's first entry.
    fn match_rows(&mut self, first: usize, stated: &[Entries], derived: &[Entries]) {
        let width = stated.len() + 1;
        let place = |i: usize| first + i * width..first + (i + 1) * width;
        let is_own = |judge: &Self, i: usize| judge.found[place(i)].iter().all(|entry| entry.verdict.is_equal());
        let (mut taken, others): (FxHashSet<usize>, Vec<usize>) = {
            let (own, others): (Vec<_>, Vec<_>) = (0..stated.len()).partition(|i| is_own(self, *i));
            (own.into_iter().collect(), others)
        };
        for i in others {
            let parameters = self.quantities.model.p();
            let Kinematics { arena, simplifier, .. } = &mut self.quantities.derivations.kinematics;
            let mut terms = TermTools { arena, simplifier, comparer: &mut self.comparer };
            let judged = judge_row(&mut terms, &parameters, &stated[i], derived, i);
            let RowMatchResult::Row { at, .. } = judged.by else { continue };
            if !judged.is_right() || !taken.insert(at) {
                continue;
            }
            for (entry, (verdict, expected)) in
                self.found[place(i)].iter_mut().zip(judged.entries.into_iter().zip(judged.expected))
            {
                entry.verdict = verdict;
                entry.derived = Some(expected);
            }
        }
    }
}

/// Symbols of all names that a formula of a reference may contain, by name.
fn compared_reference_names(model: &Model) -> FxHashMap<String, Expr> {
    let mut names = FxHashMap::default();
    names.extend(model.parameters.iter().map(|p| (p.name.clone(), p.symbol)));
    for c in &model.coordinates {
        let all =
            [(c.name.clone(), c.symbol), (format!("{}'", c.name), c.rate), (format!("{}''", c.name), c.second_rate)];
        names.extend(all);
    }
    for s in &model.speeds {
        names.extend([(s.name.clone(), s.symbol), (format!("{}'", s.name), s.rate)]);
    }
    names.extend(model.reactions.iter().map(|r| (r.name.clone(), r.symbol)));
    names
}

/// Lists the quantities that every reference of a model must contain; `tests/sympy/README.md`
/// describes them.
fn expected_reference_quantities(model: &Model) -> Vec<Quantity> {
    let mut kinds = Vec::new();
    for (to, frame) in model.frames.iter().enumerate() {
        if let Some((from, _)) = frame.rotation {
            let entries = (0..9).map(|n| QuantityKind::Rotation { from, to, entry: (n / 3, n % 3) });
            kinds.extend(entries);
        }
    }
    for (at, body) in model.bodies.iter().enumerate() {
        let frame = body.rigid.as_ref().map_or(0, |(_, inertia)| inertia.frame);
        let mut vectors = vec![
            (VectorName::Velocity, body.centre),
            (VectorName::Acceleration, body.centre),
            (VectorName::InertiaForce, at),
        ];
        if let Some((own, _)) = body.rigid {
            vectors.push((VectorName::AngularVelocity, own));
            vectors.push((VectorName::AngularAcceleration, own));
            vectors.push((VectorName::InertiaTorque, at));
        }
        for (vector, of) in vectors {
            kinds.extend((0..3).map(|axis| QuantityKind::Component { vector, of, frame, axis }));
            if matches!(vector, VectorName::Velocity | VectorName::AngularVelocity) {
                let speeds = (0..model.speeds.len()).flat_map(|speed| (0..3).map(move |axis| (speed, axis)));
                let partial = |(speed, axis)| QuantityKind::Partial { vector, of, frame, axis, speed };
                kinds.extend(speeds.map(partial));
            }
        }
    }
    for at in 0..model.speeds.len() {
        kinds.extend([
            QuantityKind::Row(RowQuantity::ActiveForce, at),
            QuantityKind::Row(RowQuantity::InertiaForce, at),
        ]);
    }
    kinds.extend([QuantityKind::Energy(EnergyQuantity::Kinetic), QuantityKind::Energy(EnergyQuantity::Gravity)]);
    kinds.extend((0..model.coordinates.len()).map(QuantityKind::Rate));
    kinds.into_iter().map(|kind| Quantity::new(kind, model)).collect()
}
