//! First integrals of a model: the energy, and the momenta of symmetries.
//!
//! Candidates come from a stated search (see [`find_first_integrals`]). Each integral I is proved
//! by the identity dI/dt − λᵀ (M u̇ − f) = 0. It holds for all q, u and free u̇, with the known
//! multipliers λ = J ξ.

use super::integral_kind::IntegralKind;
use super::noether::{NoetherTerms, VectorField};
use super::rigid_motions;
use super::verdicts::{Compared, verdict_on_pairs};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::meaning::compare::{Comparer, Verdict};
use crate::algebra::meaning::identity::Identity;
use crate::algebra::solve::antiderivative::antiderivative;
use crate::algebra::solve::elimination::divisors;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::text::print::print_text;
use crate::algebra::value::range::range_excludes_zero;
use crate::algebra::value::rank::rank;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::mechanics::{
    Derivations, Equations, Formulation, Kinematics, kinematic_rates, potential_at_rest, rates_to_speeds,
};
use crate::model::Model;

/// Quantity that is constant along every motion of a model.
#[derive(Clone, Debug)]
pub struct Integral {
    /// Kinds of the integral. It has several kinds if candidates of different kinds are the same
    /// function or its negative.
    pub kinds: Vec<IntegralKind>,
    /// Value of the integral, as a term in q and u.
    pub expression: Expr,
    /// Vector field ξ of the symmetry q′ = ξ(q) whose momentum the integral is; `None` for energies.
    pub field: Option<Vec<Expr>>,
    /// Functions of q that are added to the momentum in the integral, one for each kind. Such a
    /// function compensates for forces that depend on velocities, such as drag. It is 0 if the
    /// momentum itself is constant.
    pub of_places: Vec<Expr>,
    /// Verdict on the identity that proves the integral: its rate is zero along Kane's equations.
    pub verdict: Verdict,
    /// Multipliers λ of Kane's rows in dI/dt = λᵀ (M u̇ − f), one for each speed.
    pub multipliers: Vec<Expr>,
    /// Identities that together prove dI/dt = λᵀ (M u̇ − f): one for the coefficient of each u̇,
    /// then one for the remaining terms.
    pub identities: Vec<Identity>,
}

impl Integral {
    /// Descriptions of the integral in words, one for each kind. `arena` contains its terms.
    #[must_use]
    pub fn names(&self, model: &Model, arena: &Arena) -> Vec<String> {
        let xi = self.field.as_deref().unwrap_or_default();
        let kinds = self.kinds.iter().zip(&self.of_places);
        kinds.map(|(kind, place)| kind.integral_description(model, arena, xi, *place)).collect()
    }

    /// Name of the integral in all results: the description of its first kind. `arena` contains the
    /// integral's terms.
    #[must_use]
    pub fn name(&self, model: &Model, arena: &Arena) -> String {
        self.names(model, arena).swap_remove(0)
    }

    /// Descriptions of all kinds of the integral in one text. `arena` contains the integral's terms.
    #[must_use]
    pub fn full_name(&self, model: &Model, arena: &Arena) -> String {
        let names = self.names(model, arena);
        let (name, others) = (&names[0], &names[1..]);
        if others.is_empty() { name.clone() } else { format!("{name} (also {})", others.join(", ")) }
    }

    /// True if a kind of the integral is the energy T + V; false for momenta and Jacobi's integral.
    #[must_use]
    pub fn is_energy(&self) -> bool {
        self.kinds.iter().any(|kind| kind.is_energy())
    }

    /// Formulas of the integral that documents show: its value and its divisors. For a symmetry
    /// without a name, also the components of its field.
    #[must_use]
    pub fn shown_formulas_of_integral(&self, arena: &Arena) -> Vec<Expr> {
        let mut list = vec![self.expression];
        list.extend(self.divisors(arena));
        if self.kinds.contains(&IntegralKind::Symmetry) {
            list.extend(self.field.iter().flatten());
        }
        list
    }

    /// Divisors of the integral that may be zero; the integral has no value where a divisor is 0.
    /// Divisors that are proved never to be zero are left out. A parameter that is not stated to be
    /// positive may be zero.
    #[must_use]
    pub fn divisors(&self, arena: &Arena) -> Vec<Expr> {
        let all = divisors(arena, &[self.expression]);
        all.into_iter().filter(|e| !range_excludes_zero(arena, *e)).collect()
    }
}

/// Report on a search for first integrals: what was covered, and the power if no energy is
/// conserved.
#[derive(Clone, Debug)]
pub struct IntegralSearch {
    /// Text that describes the coverage of the search: for which symmetries and momenta it is
    /// complete, and which it leaves out.
    pub covered: String,
    /// Power d(T + V)/dt as a term in q and u, W; `None` if an energy is conserved. If `Some`, no
    /// potential of the applied loads was found, or their potential jumps in time.
    pub power: Option<Expr>,
}

impl IntegralSearch {
    /// Text, in a single line, of the coverage of the search. If no energy is conserved, the power
    /// is added. `arena` contains the terms.
    #[must_use]
    pub fn text(&self, arena: &Arena) -> String {
        let Some(power) = self.power else { return self.covered.clone() };
        format!(
            "{}; no energy: d(T + V)/dt = {}, since some applied loads have no potential that was found, or one that jumps in time",
            self.covered,
            print_text(arena, power)
        )
    }
}

/// Finds first integrals of a model and proves them. The second result describes the coverage of
/// the search.
///
/// The search looks for the energy T + V, or Jacobi's integral if drives move the mechanism. The
/// energy includes the potential of forces for which the rules of [`antiderivative`] find one.
/// The search also looks for the momenta of coordinates, of rigid motions, of all fields
/// ξ = A q + b and of quasi-cyclic coordinates.
///
/// Rigid motions, of the whole and of each body, are translations along the inertial axes, and
/// rotations about them through the mass centre and the origin. A function of q may be added to a
/// momentum if forces depend on velocities. Only functionally independent momenta are kept.
pub fn find_first_integrals(
    model: &Model,
    derivations: &mut Derivations,
    comparer: &mut Comparer,
) -> (Vec<Integral>, IntegralSearch) {
    match IntegralSearchBasis::new(model, derivations) {
        Some(basis) => {
            let Kinematics { arena, simplifier, .. } = &mut derivations.kinematics;
            basis.search(model, arena, simplifier, comparer)
        }
        None => {
            let covered =
                "first integrals are not searched: the search needs Kane's and Lagrange's equations".to_owned();
            (Vec::new(), IntegralSearch { covered, power: None })
        }
    }
}

/// Equations and vector fields from which a search for first integrals starts. If parameters are
/// replaced by numbers, more integrals may exist.
#[derive(Clone)]
pub struct IntegralSearchBasis {
    /// Derivatives of T and V, and the generalized forces Q that V does not contain, in q and q̇.
    pub lagrangian: NoetherTerms,
    /// Symbols of the rates q̇. The generalized forces times these rates are the power.
    rates: Vec<Expr>,
    /// Kane's equations of the model.
    kane: Equations,
    /// Unit fields of the coordinates, and vector fields of the permitted rigid motions.
    fields: Vec<VectorField>,
}

impl IntegralSearchBasis {
    /// Collects the equations and fields of a model. `None` unless the equations by Kane and by
    /// Lagrange were derived.
    pub fn new(model: &Model, derivations: &mut Derivations) -> Option<Self> {
        let kane = derivations.get(Formulation::Kane)?.clone();
        let lagrange = derivations.get(Formulation::Lagrange)?.clone();
        let lagrangian = NoetherTerms::new(model, derivations, lagrange.kinetic_energy, lagrange.potential_energy);
        let mut fields = lagrangian.unit_fields();
        fields.extend(rigid_motions::rigid_motion_fields(model, &mut derivations.kinematics));
        Some(Self { lagrangian, rates: lagrange.variables, kane, fields })
    }

    /// Applies the function `rewrite` to every term of the equations and fields, in place.
    pub fn change(&mut self, arena: &mut Arena, rewrite: &mut dyn FnMut(&mut Arena, Expr) -> Expr) {
        self.kane.change_terms(&mut |e, arena| *e = rewrite(arena, *e), arena);
        let of_fields = self.fields.iter_mut().flat_map(|f| &mut f.xi);
        for e in self.lagrangian.terms().chain(of_fields) {
            *e = rewrite(arena, *e);
        }
    }

    /// Finds and proves first integrals of the model. If the terms of the basis were rewritten, the
    /// speeds of the model must be rewritten in the same way.
    pub fn search(
        &self,
        model: &Model,
        arena: &mut Arena,
        simplifier: &mut Simplifier,
        comparer: &mut Comparer,
    ) -> (Vec<Integral>, IntegralSearch) {
        let affine = self.lagrangian.affine_fields(model, arena, simplifier);
        let quasi_cyclic = self.lagrangian.quasi_cyclic_fields(model, arena, simplifier);
        let (gradients, found) = Default::default();
        let mut search = IntegralSearchState {
            model,
            basis: self,
            arena,
            simplifier,
            comparer,
            gradients,
            found,
            no_potential: false,
        };
        search.energy();
        let covered = match &affine {
            Some(list) => format!(
                "complete for the momenta of symmetries q' = A q + b with constant A and b{}: {} of them{}",
                if model.motion_constraints.is_empty() { "" } else { " along which no force of a constraint works" },
                list.len(),
                if list.is_empty() { "" } else { ", among those listed or combinations of them" }
            ),
            None => "symmetries q' = A q + b were not searched: the conditions are too large".to_owned(),
        };
        let covered = if self.lagrangian.has_forces() {
            format!(
                "{covered}; momenta that are constant with a function of place beside them were looked for along coordinates and rigid motions"
            )
        } else {
            covered
        };
        let power = search.no_potential.then_some(self.kane.power);
        for field in self.fields.iter().chain(&affine.unwrap_or_default()).chain(&quasi_cyclic) {
            search.momentum(field);
        }
        (search.found, IntegralSearch { covered, power })
    }
}

/// State of a search for first integrals: tools, and the integrals found so far.
struct IntegralSearchState<'a> {
    model: &'a Model,
    basis: &'a IntegralSearchBasis,
    arena: &'a mut Arena,
    simplifier: &'a mut Simplifier,
    comparer: &'a mut Comparer,
    /// Gradients ∂I/∂(q, u) of the integrals found so far, except those of energies.
    gradients: Vec<Vec<Expr>>,
    /// First integrals that were found and proved so far.
    found: Vec<Integral>,
    /// True if forces do work and no potential was found for them.
    no_potential: bool,
}

impl IntegralSearchState<'_> {
    /// Adds the energy T + V if it is conserved, then Jacobi's integral if that is conserved. Sets
    /// `no_potential` if forces without a potential do work.
    fn energy(&mut self) {
        let (model, IntegralSearchBasis { lagrangian, rates, kane, .. }) = (self.model, self.basis);
        let arena = &mut *self.arena;
        let mut kind =
            if lagrangian.loads_have_potential { IntegralKind::EnergyOfForces } else { IntegralKind::Energy };
        let mut potential = kane.potential_energy;
        let power: Vec<Expr> = lagrangian.forces.iter().zip(rates).map(|(f, v)| arena.mul(*f, *v)).collect();
        let power = arena.sum(&power);
        if zero_test(arena, power) != ZeroTest::Zero {
            let Some(of_forces) = potential_of_remaining_forces(arena, self.simplifier, model, lagrangian) else {
                self.no_potential = true;
                return;
            };
            potential = arena.add(potential, of_forces);
            kind = IntegralKind::EnergyOfForces;
        }
        let energy = arena.add(kane.kinetic_energy, potential);
        let multipliers = self.energy_integral_multipliers(None);
        self.keep_integral(kind, None, Expr::ZERO, energy, &multipliers);
        self.jacobi(energy);
    }

    /// Multipliers J q̇ of Kane's equations: each speed minus its value at rest. With these
    /// multipliers, q̇ᵀ Lagrange = (J q̇)ᵀ Kane.
    ///
    /// `time` is the index of the time coordinate, whose rate t' is then 1 at rest. If it is
    /// `None`, all rates are 0 at rest.
    fn energy_integral_multipliers(&mut self, time: Option<usize>) -> Vec<Expr> {
        let (model, arena) = (self.model, &mut *self.arena);
        let rate_at_rest = |at: usize| if time == Some(at) { Expr::ONE } else { Expr::ZERO };
        let at_rest: Vec<(Expr, Expr)> =
            model.q_dot().into_iter().enumerate().map(|(at, rate)| (rate, rate_at_rest(at))).collect();
        let mut at_rest = Substitution::new(&at_rest);
        let speeds = model.speeds.iter().map(|s| {
            let offset = at_rest.apply(arena, s.definition);
            arena.sub(s.symbol, offset)
        });
        speeds.collect()
    }

    /// Adds Jacobi's integral T + V − ∂T/∂t' with t' = 1, if it is conserved. It can be conserved
    /// although drives do work, if no term depends on time explicitly.
    fn jacobi(&mut self, energy: Expr) {
        let Some(time) = self.model.time() else { return };
        let momentum = self.basis.lagrangian.momenta[time];
        let mut in_speeds = rates_to_speeds(self.model);
        let momentum = in_speeds.apply(self.arena, momentum);
        let value = self.arena.sub(energy, momentum);
        let value = self.simplifier.simplify(self.arena, value);
        let multipliers = self.energy_integral_multipliers(Some(time));
        self.keep_integral(IntegralKind::Jacobi, None, Expr::ZERO, value, &multipliers);
    }

    /// Adds the momentum of a vector field if it is conserved. If it is conserved only after a
    /// function of q is added, the sum is added.
    fn momentum(&mut self, field: &VectorField) {
        let (arena, lagrangian) = (&mut *self.arena, &self.basis.lagrangian);
        let rate = lagrangian.rate(arena, &field.xi);
        let momentum = lagrangian.momentum(arena, &field.xi);
        let of_place = if zero_test(arena, rate) == ZeroTest::Zero {
            Expr::ZERO
        } else {
            // With magnetic forces, gyroscopic forces or drag, the rate of a momentum may be the
            // rate of a function of q. Then the difference of the momentum and this function is
            // constant.
            let Some(of_place) = integral_of_rate(arena, self.simplifier, self.model, rate) else { return };
            arena.neg(of_place)
        };
        let momentum = arena.add(momentum, of_place);
        let mut in_speeds = rates_to_speeds(self.model);
        let momentum = in_speeds.apply(arena, momentum);
        let momentum = self.simplifier.simplify(arena, momentum);
        let mut form = LinearForm::new(&self.model.q_dot());
        let mut multipliers = Vec::new();
        for speed in &self.model.speeds {
            let Ok((coefficients, _)) = form.coefficients(arena, speed.definition) else { return };
            let terms: Vec<Expr> = coefficients.iter().zip(&field.xi).map(|(j, x)| arena.mul(*j, *x)).collect();
            multipliers.push(arena.sum(&terms));
        }
        self.keep_integral(field.kind, Some(&field.xi), of_place, momentum, &multipliers);
    }

    /// Proves an integral and adds it to the list. If it is a function of earlier integrals, it is
    /// dropped. If it equals a known integral or its negative, only its kind is added to that
    /// integral.
    fn keep_integral(
        &mut self,
        kind: IntegralKind,
        field: Option<&[Expr]>,
        of_place: Expr,
        value: Expr,
        multipliers: &[Expr],
    ) {
        let arena = &mut *self.arena;
        for known in &mut self.found {
            let (difference, sum) = (arena.sub(value, known.expression), arena.add(value, known.expression));
            if [difference, sum].iter().any(|e| zero_test(arena, *e) == ZeroTest::Zero) {
                if kind != IntegralKind::Symmetry {
                    known.kinds.push(kind);
                    known.of_places.push(of_place);
                }
                return;
            }
        }
        let variables = [self.model.q(), self.model.u()].concat();
        let gradient = variables.iter().map(|x| Differential::partial(*x).apply(arena, value)).collect();
        let mut gradients = self.gradients.clone();
        gradients.push(gradient);
        if rank(arena, &gradients).is_none_or(|found| found.dependent.is_some()) {
            return;
        }
        let Compared { verdict, identities } = self.prove(value, multipliers);
        if !verdict.is_equal() {
            return;
        }
        // The energy of a free body is a function of its momenta, but is listed as an integral as
        // well.
        if !kind.is_energy() {
            self.gradients = gradients;
        }
        self.found.push(Integral {
            kinds: vec![kind],
            expression: value,
            field: field.map(<[Expr]>::to_vec),
            of_places: vec![of_place],
            verdict,
            multipliers: multipliers.to_vec(),
            identities,
        });
    }

    /// Proves dI/dt − λᵀ (M u̇ − f) = 0 for an integral I with multipliers λ, coefficient by
    /// coefficient of u̇.
    fn prove(&mut self, value: Expr, multipliers: &[Expr]) -> Compared {
        let (arena, comparer, kane) = (&mut *self.arena, &mut *self.comparer, &self.basis.kane);
        let rate = kinematic_rates(self.model).apply(arena, value);
        let Ok((coefficients, rest)) = LinearForm::new(&kane.unknowns).coefficients(arena, rate) else {
            let verdict =
                Verdict::Undecided("the rate of the first integral is not linear in the accelerations".to_owned());
            return Compared { verdict, identities: Vec::new() };
        };
        let mut pairs = Vec::new();
        for (column, coefficient) in coefficients.iter().enumerate() {
            let rows = kane.matrix.iter().zip(multipliers);
            let terms: Vec<Expr> = rows.map(|(row, by)| arena.mul(row[column], *by)).collect();
            let combined = arena.sum(&terms);
            pairs.push((*coefficient, combined));
        }
        let terms: Vec<Expr> = kane.forcing.iter().zip(multipliers).map(|(f, by)| arena.mul(*f, *by)).collect();
        let combined = arena.sum(&terms);
        let combined = arena.neg(combined);
        pairs.push((rest, combined));
        verdict_on_pairs(arena, comparer, &pairs)
    }
}

/// Potential energy U(q) of the forces that V does not contain. At rest these forces are −∂U/∂q,
/// and the remaining part does no work, as for a magnetic force. `None` if there is no such U, or
/// if no rule finds it.
fn potential_of_remaining_forces(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    model: &Model,
    lagrangian: &NoetherTerms,
) -> Option<Expr> {
    let energy = potential_at_rest(arena, simplifier, model, &lagrangian.forces)?;
    let mut power = Vec::new();
    for ((force, q), rate) in lagrangian.forces.iter().zip(model.q()).zip(model.q_dot()) {
        let slope = Differential::partial(q).apply(arena, energy);
        let beyond = arena.add(*force, slope);
        power.push(arena.mul(beyond, rate));
    }
    let power = arena.sum(&power);
    (zero_test(arena, power) == ZeroTest::Zero).then_some(energy)
}

/// Function F(q) with dF/dt = `rate` along every path. `None` if the rate is not linear in q̇, has
/// a part without q̇, or no rule finds F.
fn integral_of_rate(arena: &mut Arena, simplifier: &mut Simplifier, model: &Model, rate: Expr) -> Option<Expr> {
    let (slopes, rest) = LinearForm::new(&model.q_dot()).coefficients(arena, rate).ok()?;
    if zero_test(arena, rest) != ZeroTest::Zero {
        return None;
    }
    antiderivative(arena, simplifier, &model.q(), &slopes)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::derive_all;
    use std::path::Path;

    /// A symmetry is found from the Lagrangian alone: the heading q1 of the disk is quasi-cyclic.
    /// With the momenta of the contact point, p1 gives the angular momentum about the vertical
    /// through the mass centre. The rigid motions give the same integral.
    #[test]
    fn heading_of_the_disk_is_quasi_cyclic() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/disk/model.toml");
        let model = Model::read(&path).unwrap();
        let mut derivations = derive_all(&model).unwrap();
        let mut basis = IntegralSearchBasis::new(&model, &mut derivations).unwrap();
        let Kinematics { arena, simplifier, .. } = &mut derivations.kinematics;
        let fields = basis.lagrangian.quasi_cyclic_fields(&model, arena, simplifier);
        let shown: Vec<Vec<String>> =
            fields.iter().map(|f| f.xi.iter().map(|x| print_text(arena, *x)).collect()).collect();
        assert_eq!(shown, [["1", "0", "0", "R*cos(q1)*sin(q2)", "R*sin(q1)*sin(q2)"]]);
        let mut search =
            |basis: &IntegralSearchBasis| basis.search(&model, arena, simplifier, &mut Comparer::default()).0;
        let all = search(&basis);
        basis.fields.retain(|f| matches!(f.kind, IntegralKind::Coordinate(_)));
        let found = search(&basis);
        assert_eq!(found.len(), all.len());
        assert!(found.iter().all(|i| i.verdict.is_equal()));
    }
}
