//! Basis from which reductions start: a model's equations, momenta and energy. Parameters may be
//! replaced by the numbers of a scene.

use super::moving_frame::{FrameSymmetry, PinnedFrame};
use super::reaction_balance::ReactionBalance;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Rational};
use crate::flow::symmetry_candidates;
use crate::mechanics::{
    Derivations, DeriveError, EquationForm, Equations, Formulation, Kinematics, derive_all_with, has_reducible_form,
    kinematic_rates, rates_to_speeds,
};
use crate::model::{Model, Unit};
use crate::prove::{Integral, IntegralKind, IntegralSearchBasis, VectorField};
use crate::scene::Scene;

/// Largest number of coordinates of a model whose first integrals are searched.
const MOST_COORDINATES: usize = 12;
/// Largest number of momenta for which every subset is tried as the set of constant momenta.
const MOST_TRIED: usize = 5;

/// Conserved momentum of a symmetry, linear in the speeds: row · u + rest.
#[derive(Clone)]
pub struct Momentum {
    /// Kinds of the first integral to which the momentum belongs.
    pub kinds: Vec<IntegralKind>,
    /// True if a function of q is added to the momentum of the symmetry to make it constant.
    pub has_place: bool,
    /// Description of the integral in words, by the first of its kinds.
    pub about: String,
    /// Value of the momentum as a term in q and u.
    pub value: Expr,
    /// Coefficients of the speeds in the momentum, one for each speed, as terms in q.
    pub row: Vec<Expr>,
    /// Part of the momentum that does not depend on the speeds, as a term in q.
    pub rest: Expr,
    /// Components of the symmetry q′ = ξ(q), one for each coordinate, as terms in q.
    pub field: Vec<Expr>,
    /// Components J ξ of the symmetry along the speeds, one for each speed. J is the matrix of
    /// ∂u/∂q̇.
    pub direction: Vec<Expr>,
    /// Unit of the value of the momentum.
    pub unit: Unit,
    /// Function of q whose rate is the momentum: a mass times a coordinate of a mass centre. `None` if
    /// there is no such function.
    pub position: Option<Expr>,
    /// Unit of `position`; without meaning if `position` is `None`.
    pub position_unit: Unit,
}

/// Variable that is replaced by the difference of the variable and a multiple of another variable,
/// the pivot.
#[derive(Clone, Copy, Debug)]
pub struct VariableDifference {
    /// Symbol of the variable that is replaced.
    pub variable: Expr,
    /// Symbol of the pivot variable whose multiple is subtracted.
    pub pivot: Expr,
    /// Symbol of the difference, which replaces the variable.
    pub symbol: Expr,
}

/// Basis of reductions: a model's equations by Kane's method, with its first integrals and
/// symmetries.
#[derive(Clone)]
pub struct ReductionBasis {
    /// Model of the equations; its terms are in `arena`.
    pub model: Model,
    /// Arena that contains the terms of all fields.
    pub arena: Arena,
    /// Simplifier of terms; it keeps the terms that were already simplified.
    pub simplifier: Simplifier,
    /// Symbols of the equations' coordinates. One of them may be the distance from a singular surface.
    pub q: Vec<Expr>,
    /// Values of the coordinates `q`, as terms in the coordinates of the model. There is one for
    /// each coordinate.
    pub q_start: Vec<Expr>,
    /// Values of the equations' speeds, as terms in the speeds of the model.
    pub u_start: Vec<Expr>,
    /// Variables that were replaced by differences from a multiple of another variable.
    pub relatives: Vec<VariableDifference>,
    /// Equations by Kane's method, in the current variables.
    pub kane: Equations,
    /// Linear system that determines the reactions. The error is the reason why it could not be
    /// derived.
    pub balance: Result<ReactionBalance, DeriveError>,
    /// First integrals of the motion, as proved for the model.
    pub integrals: Vec<Integral>,
    /// Momenta of symmetries: those first integrals that are linear in the speeds.
    pub momenta: Vec<Momentum>,
    /// Energy T + V as a term in q and u, J; `None` if it is not conserved.
    pub energy: Option<Expr>,
    /// Parameters that were replaced by numbers, as pairs of name and value.
    pub folded: Vec<(String, Rational)>,
    /// Vector fields on the coordinates that may be symmetries, such as a translation of the whole
    /// system.
    pub(in crate::reduce) fields: Vec<VectorField>,
    /// Symmetries of the equations that leave a scene's wanted quantities unchanged. Empty until a
    /// moving frame is searched.
    pub turns: Vec<FrameSymmetry>,
    /// Descriptions of symmetries that leave every shown quantity unchanged but change a condition
    /// of the model's domain. They are not used for moving frames.
    pub kept_by_domain: Vec<String>,
    /// Moving frame in which the equations are written; `None` for the inertial frame.
    pub frame: Option<PinnedFrame>,
    /// Data for the search for first integrals. `None` after numbers have replaced parameters, or
    /// if the model has more than 12 coordinates.
    search: Option<ReductionBasisIntegrals>,
}

/// Data for the search for first integrals. It includes units, which are lost when numbers replace
/// parameters.
#[derive(Clone)]
struct ReductionBasisIntegrals {
    /// Equations and vector fields from which the search starts.
    basis: IntegralSearchBasis,
    /// First moment Σ m r of the whole system along each inertial axis.
    centre: Vec<Expr>,
    /// Units of the three components of `centre`.
    centre_units: Vec<Unit>,
    /// Units of the generalized momenta ∂L/∂q̇, one for each coordinate.
    units: Vec<Unit>,
}

impl ReductionBasis {
    /// Derives the equations of a model by Kane's method, and finds its first integrals.
    ///
    /// # Errors
    /// [`DeriveError`] if Kane's equations cannot be derived.
    pub fn new(model: &Model) -> Result<Self, DeriveError> {
        let form = if has_reducible_form(model) { EquationForm::Closed } else { EquationForm::Steps };
        let mut derivations = derive_all_with(model, Kinematics::in_form(model, form)?)?;
        let kane = derivations.result(Formulation::Kane)?.clone();
        let balance = derivations.result(Formulation::NewtonEuler).cloned();
        let balance = balance.map(|equations| ReactionBalance::new(model, &mut derivations.kinematics, &equations));
        let (search, fields) = match model.coordinates.len() {
            0..=MOST_COORDINATES => (
                ReductionBasisIntegrals::new(model, &mut derivations),
                symmetry_candidates(model, &mut derivations.kinematics),
            ),
            _ => (None, Vec::new()),
        };
        let Kinematics { arena, simplifier, .. } = derivations.kinematics;
        let (q, q_start, u_start) = (model.q(), model.q(), model.u());
        let (relatives, folded, integrals, momenta, energy, turns, frame, kept_by_domain) = Default::default();
        let model = model.clone();
        let mut basis = Self {
            model,
            arena,
            simplifier,
            q,
            q_start,
            u_start,
            relatives,
            kane,
            balance,
            integrals,
            momenta,
            energy,
            folded,
            fields,
            turns,
            kept_by_domain,
            frame,
            search,
        };
        basis.find_integrals();
        Ok(basis)
    }

    /// Finds the first integrals of the model, and sets the momenta and the energy. Nothing changes
    /// if there is no search data.
    fn find_integrals(&mut self) {
        let Some(search) = &self.search else { return };
        let (arena, simplifier) = (&mut self.arena, &mut self.simplifier);
        let (integrals, _) = search.basis.search(&self.model, arena, simplifier, &mut Comparer::default());
        self.energy = integrals.iter().find(|i| i.is_energy()).map(|i| i.expression);
        self.momenta = integrals.iter().filter_map(|i| search.momentum(&self.model, arena, simplifier, i)).collect();
        self.integrals = integrals;
    }

    /// Replaces parameters by the numbers of a scene. A parameter remains a symbol if the scene
    /// leaves it free, if its number is not short and exact, or if its number would make a divisor
    /// zero.
    pub(in crate::reduce) fn fix_parameters_of_basis(&mut self, scene: &Scene) {
        let parameters = self.model.parameters.iter().enumerate();
        let fixed = parameters.filter(|(at, _)| !scene.free.contains(at)).filter_map(|(at, p)| {
            let value = scene.exact.rational.get(at)?.clone()?;
            is_short_number(&value).then(|| (p.name.clone(), p.symbol, value))
        });
        let mut values: Vec<(String, Expr, Rational)> = fixed.collect();
        // If a number makes a divisor zero, its parameter remains a symbol.
        loop {
            let mut trial = self.clone();
            let pairs: Vec<_> = values.iter().map(|(_, p, x)| (*p, trial.arena.number(x.clone()))).collect();
            let mut put = Substitution::new(&pairs);
            trial.rewrite_basis_terms(&mut |arena, _, e| put.apply(arena, e));
            if put.undefined.is_none() {
                trial.folded = values.into_iter().map(|(name, _, value)| (name, value)).collect();
                trial.rewrite_basis_terms(&mut |arena, simplifier, e| simplifier.simplify(arena, e));
                trial.search_integrals_with_numbers(&mut put);
                *self = trial;
                return;
            }
            let zero = values.iter().position(|(_, _, value)| value.is_zero()).unwrap_or(values.len() - 1);
            values.remove(zero);
        }
    }

    /// Searches first integrals again after numbers have replaced parameters. `put` is the
    /// substitution of these numbers. Equal inertias or zero damping may give more integrals.
    fn search_integrals_with_numbers(&mut self, put: &mut Substitution) {
        let Some(mut search) = self.search.take().filter(|_| !self.folded.is_empty()) else { return };
        search.basis.change(&mut self.arena, &mut |arena, e| put.apply(arena, e));
        for e in &mut search.centre {
            *e = put.apply(&mut self.arena, *e);
        }
        if put.undefined.is_none() {
            self.search = Some(search);
            self.find_integrals();
        }
        self.search = None;
    }

    /// Applies the function `rewrite` to every term of the reduction basis, in place.
    pub(in crate::reduce) fn rewrite_basis_terms(
        &mut self,
        rewrite: &mut dyn FnMut(&mut Arena, &mut Simplifier, Expr) -> Expr,
    ) {
        let Self { arena, simplifier, model, kane, balance, momenta, energy, fields, turns, .. } = self;
        kane.change_terms(&mut |e, arena| *e = rewrite(arena, simplifier, *e), arena);
        if let Ok(balance) = balance {
            balance.visit(&mut |e| *e = rewrite(arena, simplifier, *e));
        }
        let speeds = model.speeds.iter_mut().map(|s| &mut s.definition);
        let conditions = model.domain.iter_mut().map(|c| &mut c.positive);
        let fixed = model.constraints.iter_mut().map(|c| &mut c.value);
        let rates = model.kinematic_equations.rates.iter_mut().chain(&mut model.kinematic_equations.divisors);
        let of_momenta = momenta.iter_mut().flat_map(|m| {
            m.row
                .iter_mut()
                .chain(&mut m.field)
                .chain(&mut m.direction)
                .chain(&mut m.position)
                .chain([&mut m.value, &mut m.rest])
        });
        let of_turns = fields.iter_mut().flat_map(|f| &mut f.xi).chain(turns.iter_mut().flat_map(|t| &mut t.along));
        for e in speeds.chain(conditions).chain(fixed).chain(rates).chain(of_momenta).chain(of_turns).chain(energy) {
            *e = rewrite(arena, simplifier, *e);
        }
    }

    /// Substitution that replaces the variables of the equations by terms in the variables of the
    /// model.
    pub(in crate::reduce) fn basis_to_model_substitution(&self) -> Substitution {
        let coordinates = self.q.iter().copied().zip(self.q_start.iter().copied());
        let speeds = self.kane.variables.iter().copied().zip(self.u_start.iter().copied());
        Substitution::new(&coordinates.chain(speeds).collect::<Vec<_>>())
    }

    /// Sets of momenta that can be kept constant together, because their symmetries commute. Each
    /// set is a list of indices into `momenta`. Up to `MOST_TRIED` momenta give all such sets, more
    /// momenta only sets that cannot be enlarged, and the empty set.
    pub(in crate::reduce) fn commuting_momenta_of_basis(&mut self) -> Vec<Vec<usize>> {
        let count = self.momenta.len();
        let pairs = (0..count).flat_map(|a| (0..a).map(move |b| (a, b)));
        let apart: Vec<(usize, usize)> = pairs.filter(|(a, b)| !self.basis_momenta_commute(*a, *b)).collect();
        let allowed = |choice: &Vec<usize>| !apart.iter().any(|(a, b)| choice.contains(a) && choice.contains(b));
        if count <= MOST_TRIED {
            let subsets = (0..1_usize << count).map(|bits| (0..count).filter(|at| bits >> at & 1 == 1).collect());
            return subsets.filter(allowed).collect();
        }
        let mut list = vec![Vec::new()];
        for first in 0..count {
            let mut choice = Vec::new();
            for at in (first..count).chain(0..first) {
                choice.push(at);
                if !allowed(&choice) {
                    choice.pop();
                }
            }
            choice.sort_unstable();
            list.push(choice);
        }
        list.sort();
        list.dedup();
        list
    }

    /// True if the symmetries ξ and η of the momenta with the indices `a` and `b` commute. Then all
    /// components ξ·∂η_i − η·∂ξ_i of their bracket are zero.
    fn basis_momenta_commute(&mut self, a: usize, b: usize) -> bool {
        let arena = &mut self.arena;
        let along = |field: &[Expr]| {
            Differential::along(&self.q.iter().copied().zip(field.iter().copied()).collect::<Vec<_>>())
        };
        let (one, other) = (&self.momenta[a].field, &self.momenta[b].field);
        let (mut by_one, mut by_other) = (along(one), along(other));
        one.iter().zip(other).all(|(x, y)| {
            let (first, second) = (by_one.apply(arena, *y), by_other.apply(arena, *x));
            let bracket = arena.sub(first, second);
            zero_test(arena, bracket) == ZeroTest::Zero
        })
    }
}

impl ReductionBasisIntegrals {
    /// Collects the search data of a model. `None` unless the equations by Kane and by Lagrange were
    /// derived.
    fn new(model: &Model, derivations: &mut Derivations) -> Option<Self> {
        let basis = IntegralSearchBasis::new(model, derivations)?;
        let kinematics = &mut derivations.kinematics;
        let mut centre = Vec::new();
        for axis in 0..3 {
            let mut terms = Vec::new();
            for body in &model.bodies {
                let place = kinematics.positions[body.centre].clone();
                let component = kinematics.frames.component(&mut kinematics.arena, &place, 0, axis);
                terms.push(kinematics.arena.mul(body.mass, component));
            }
            centre.push(kinematics.arena.sum(&terms));
        }
        let arena = &mut kinematics.arena;
        let mut in_speeds = rates_to_speeds(model);
        let momenta: Vec<Expr> = basis.lagrangian.momenta.iter().map(|p| in_speeds.apply(arena, *p)).collect();
        let momenta: Vec<Expr> = momenta.into_iter().map(|p| kinematics.simplifier.simplify(arena, p)).collect();
        let units = |list: &[Expr]| list.iter().map(|e| model.unit_of(arena, *e).unwrap_or_default()).collect();
        let (centre_units, of_momenta) = (units(&centre), units(&momenta));
        Some(Self { basis, centre, centre_units, units: of_momenta })
    }

    /// Builds the momentum of a first integral. `None` unless the integral belongs to a symmetry
    /// and is linear in the speeds.
    fn momentum(
        &self,
        model: &Model,
        arena: &mut Arena,
        simplifier: &mut Simplifier,
        integral: &Integral,
    ) -> Option<Momentum> {
        let field = integral.field.clone()?;
        let (row, rest) = LinearForm::new(&model.u()).coefficients(arena, integral.expression).ok()?;
        let row: Vec<Expr> = row.into_iter().map(|e| simplifier.simplify(arena, e)).collect();
        let mut form = LinearForm::new(&model.q_dot());
        let mut direction = Vec::new();
        for speed in &model.speeds {
            let (coefficients, _) = form.coefficients(arena, speed.definition).ok()?;
            let terms: Vec<Expr> = coefficients.iter().zip(&field).map(|(j, x)| arena.mul(*j, *x)).collect();
            let sum = arena.sum(&terms);
            let short = simplifier.simplify(arena, sum);
            direction.push(if zero_test(arena, short) == ZeroTest::Zero { Expr::ZERO } else { short });
        }
        let (kinds, value) = (integral.kinds.clone(), integral.expression);
        let about = integral.names(model, arena).swap_remove(0);
        // If the component of the symmetry along a coordinate is a number, the momentum has the
        // unit of ∂L/∂q̇ of this coordinate.
        let plain = field.iter().position(|x| arena.as_number(*x).is_some_and(|k| !k.is_zero()));
        let unit = plain.map_or_else(|| model.unit_of(arena, value).unwrap_or_default(), |at| self.units[at].clone());
        let axis = (0..3).find(|axis| {
            let rate = kinematic_rates(model).apply(arena, self.centre[*axis]);
            let difference = arena.sub(rate, value);
            zero_test(arena, difference) == ZeroTest::Zero
        });
        let position = axis.map(|axis| simplifier.simplify(arena, self.centre[axis]));
        let position_unit = axis.map(|axis| self.centre_units[axis].clone()).unwrap_or_default();
        let has_place = integral.of_places.iter().any(|e| *e != Expr::ZERO);
        Some(Momentum { kinds, has_place, about, value, row, rest, field, direction, unit, position, position_unit })
    }
}

/// True for a short number, which makes formulas shorter: n, n/2 or n/4 with |n| ≤ 12. For other
/// numbers, the symbol of the parameter reads better.
fn is_short_number(value: &Rational) -> bool {
    value.small().is_some_and(|(n, d)| n.abs() <= 12 && [1, 2, 4].contains(&d))
}
