//! Vector fields on configuration space, and the momenta that belong to them.
//!
//! Noether's theorem: along the equations of motion, d/dt (ξ · ∂T/∂q̇) = ξ⁽¹⁾T − ξV + ξ·Q with
//! ξ⁽¹⁾T = ξ·∂T/∂q + ξ̇·∂T/∂q̇. The momentum is conserved if and only if the right-hand side is
//! identically zero. The right-hand side contains the forces that do work along ξ, and the forces
//! Aᵀλ of motion constraints for any λ. So a momentum that a constraint force changes is not
//! conserved.

use super::integral_kind::IntegralKind;
use crate::algebra::form::normal_form::Normalizer;
use crate::algebra::form::polynomial::monomial_expr;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::solve::linear_relations::linear_relations;
use crate::algebra::term::calculus::{Differential, Gradient};
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Function, Node};
use crate::mechanics::{Derivations, Kinematics};
use crate::model::Model;
use std::collections::BTreeSet;

/// Vector field ξ(q) on configuration space, with the kind of the momentum ξ · ∂T/∂q̇ that belongs
/// to it.
#[derive(Clone, Debug)]
pub struct VectorField {
    /// Kind of the momentum that belongs to the field.
    pub kind: IntegralKind,
    /// Components ξ of the field in q, one for each coordinate.
    pub xi: Vec<Expr>,
}

/// Summand of a vector field: a component along a single coordinate.
#[derive(Clone, Copy)]
struct FieldTerm {
    /// Index of the coordinate along which the component points.
    along: usize,
    /// Value of the component, as a term in the coordinates q.
    factor: Expr,
}

/// Partial derivatives of T and V, and the generalized forces that V does not contain, as terms in
/// q and q̇.
#[derive(Clone)]
pub struct NoetherTerms {
    /// Symbols of the generalized coordinates q.
    q: Vec<Expr>,
    /// Symbols of the rates q̇ of the coordinates.
    q_dot: Vec<Expr>,
    /// Derivatives ∂T/∂q of the kinetic energy, one for each coordinate.
    t_by_q: Vec<Expr>,
    /// Generalized momenta ∂T/∂q̇, one for each coordinate.
    pub momenta: Vec<Expr>,
    /// Derivatives ∂V/∂q of the potential energy, one for each coordinate.
    v_by_q: Vec<Expr>,
    /// Generalized forces Q that V does not contain, one for each coordinate.
    pub forces: Vec<Expr>,
    /// Generalized forces Aᵀλ of motion constraints with the multipliers λ, one for each coordinate.
    of_constraints: Vec<Expr>,
    /// True if V contains a potential of applied loads in addition to that of gravity.
    pub loads_have_potential: bool,
}

impl NoetherTerms {
    /// Differentiates the kinetic energy `t` and the potential energy `v` of a model, both in q and q̇,
    /// and collects the forces.
    pub fn new(model: &Model, derivations: &mut Derivations, t: Expr, v: Expr) -> Self {
        let loads = derivations.kinematics.load_potential(model);
        let Kinematics { arena, .. } = &mut derivations.kinematics;
        let mut by = |e: Expr, symbols: &[Expr]| -> Vec<Expr> {
            symbols.iter().map(|s| Differential::partial(*s).apply(arena, e)).collect()
        };
        let (q, q_dot) = (model.q(), model.q_dot());
        let (t_by_q, momenta, v_by_q) = (by(t, &q), by(t, &q_dot), by(v, &q));
        let (forces, loads_have_potential) = (loads.rest, loads.energy != Expr::ZERO);
        let of_constraints = noether_constraint_forces(model, arena);
        Self { q, q_dot, t_by_q, momenta, v_by_q, forces, of_constraints, loads_have_potential }
    }

    /// True if at least one generalized force is not contained in V and not zero.
    pub fn has_forces(&self) -> bool {
        self.forces.iter().any(|force| *force != Expr::ZERO)
    }

    /// All terms, for rewriting in place: ∂T/∂q, momenta, ∂V/∂q, forces and constraint forces.
    pub fn terms(&mut self) -> impl Iterator<Item = &mut Expr> {
        let Self { t_by_q, momenta, v_by_q, forces, of_constraints, .. } = self;
        t_by_q.iter_mut().chain(momenta).chain(v_by_q).chain(forces).chain(of_constraints)
    }

    /// Momentum ξ · ∂T/∂q̇ of a vector field ξ.
    pub fn momentum(&self, arena: &mut Arena, xi: &[Expr]) -> Expr {
        let terms: Vec<Expr> = xi.iter().zip(&self.momenta).map(|(x, p)| arena.mul(*x, *p)).collect();
        arena.sum(&terms)
    }

    /// Rate d/dt (ξ · ∂T/∂q̇) of a vector field's momentum along the equations of motion, as a term in
    /// q and q̇.
    pub fn rate(&self, arena: &mut Arena, xi: &[Expr]) -> Expr {
        let along: Vec<_> = self.q.iter().copied().zip(self.q_dot.iter().copied()).collect();
        let mut d_dt = Differential::along(&along);
        let mut terms = Vec::new();
        for (i, x) in xi.iter().enumerate() {
            let x_dot = d_dt.apply(arena, *x);
            let gain = self.momentum_rate_of_coordinate(arena, i);
            terms.push(arena.mul(*x, gain));
            terms.push(arena.mul(x_dot, self.momenta[i]));
        }
        arena.sum(&terms)
    }

    /// Unit fields ∂/∂q_i, one for each coordinate. The momentum of a unit field is conserved if the
    /// coordinate is cyclic.
    pub fn unit_fields(&self) -> Vec<VectorField> {
        let n = self.q.len();
        let unit = |i: usize| (0..n).map(|k| if k == i { Expr::ONE } else { Expr::ZERO }).collect();
        (0..n).map(|i| VectorField { kind: IntegralKind::Coordinate(i), xi: unit(i) }).collect()
    }

    /// Basis of all fields ξ = A q + b, with constant A and b, whose momenta are conserved. A and b
    /// follow from linear equations whose coefficients depend on the parameters. `None` if these
    /// equations are too large to solve.
    pub fn affine_fields(
        &self,
        model: &Model,
        arena: &mut Arena,
        simplifier: &mut Simplifier,
    ) -> Option<Vec<VectorField>> {
        let n = self.q.len();
        let mut unknowns: Vec<FieldTerm> = Vec::new();
        for along in 0..n {
            unknowns.push(FieldTerm { along, factor: Expr::ONE });
            unknowns.extend(self.q.iter().map(|q| FieldTerm { along, factor: *q }));
        }
        self.conserved_fields(model, arena, simplifier, &unknowns)
    }

    /// Basis of the fields with conserved momenta among all linear combinations of the given
    /// summands with constant coefficients. `None` if the conditions are too large to solve.
    fn conserved_fields(
        &self,
        model: &Model,
        arena: &mut Arena,
        simplifier: &mut Simplifier,
        unknowns: &[FieldTerm],
    ) -> Option<Vec<VectorField>> {
        let n = self.q.len();
        let mut conditions = Vec::new();
        for term in unknowns {
            let xi: Vec<Expr> = (0..n).map(|k| if k == term.along { term.factor } else { Expr::ZERO }).collect();
            conditions.push(self.rate(arena, &xi));
        }
        let mut normalizer = Normalizer::new(Normalizer::BUDGET);
        let basis = linear_relations(arena, simplifier, &mut normalizer, &conditions, &model.p())?;
        let mut fields = Vec::new();
        for coefficients in basis {
            let mut xi = vec![Vec::new(); n];
            for (term, c) in unknowns.iter().zip(&coefficients) {
                xi[term.along].push(arena.mul(term.factor, *c));
            }
            let xi: Vec<Expr> = xi.iter().map(|terms| arena.sum(terms)).collect();
            fields.push(VectorField { kind: IntegralKind::Symmetry, xi });
        }
        Some(fields)
    }
    /// Fields e_k + Σ m(q) e_s with conserved momenta, for quasi-cyclic coordinates q_k. The e_s
    /// are along cyclic coordinates s. Each m(q) is a sum of products of sines and cosines from the
    /// mass matrix rows of the cyclic coordinates.
    ///
    /// Since the p_s are constant, ∂L/∂q_k is the rate of f = −Σ m(q) p_s, so p_k − f is constant.
    /// Empty if there is no such field, or if the conditions are too large to solve.
    pub fn quasi_cyclic_fields(
        &self,
        model: &Model,
        arena: &mut Arena,
        simplifier: &mut Simplifier,
    ) -> Vec<VectorField> {
        let cyclic: Vec<usize> = (0..self.q.len()).filter(|s| self.is_cyclic(arena, *s)).collect();
        let products = self.trigonometric_products(arena, &cyclic);
        if products.is_empty() || cyclic.len() == self.q.len() {
            return Vec::new();
        }
        // The components along single coordinates come last; the basis of the relations is
        // normalized by its last unknowns.
        let coupled = cyclic.iter().flat_map(|s| products.iter().map(|m| FieldTerm { along: *s, factor: *m }));
        let units = (0..self.q.len()).map(|along| FieldTerm { along, factor: Expr::ONE });
        let unknowns: Vec<FieldTerm> = coupled.chain(units).collect();
        let found = self.conserved_fields(model, arena, simplifier, &unknowns).unwrap_or_default();
        let constant = |x: &Expr| !self.q.iter().any(|q| arena.mentions(*x, *q));
        found.into_iter().filter(|field| !field.xi.iter().all(constant)).collect()
    }

    /// True if the generalized momentum of the coordinate with index `s` is conserved.
    fn is_cyclic(&self, arena: &mut Arena, s: usize) -> bool {
        let gain = self.momentum_rate_of_coordinate(arena, s);
        zero_test(arena, gain) == ZeroTest::Zero
    }

    /// Rate of the generalized momentum ∂T/∂q̇_i of coordinate i along the equations of motion: ∂(T
    /// − V)/∂q_i + Q_i + (Aᵀλ)_i.
    fn momentum_rate_of_coordinate(&self, arena: &mut Arena, i: usize) -> Expr {
        let pull = arena.neg(self.v_by_q[i]);
        arena.sum(&[self.t_by_q[i], self.forces[i], self.of_constraints[i], pull])
    }

    /// Products of one or two sines and cosines in the mass matrix rows of the given coordinates, and
    /// in the derivatives of these products.
    fn trigonometric_products(&self, arena: &mut Arena, cyclic: &[usize]) -> BTreeSet<Expr> {
        let mut normalizer = Normalizer::new(Normalizer::BUDGET);
        let mut products = BTreeSet::new();
        let mut form = LinearForm::new(&self.q_dot);
        for s in cyclic {
            let Ok((row, _)) = form.coefficients(arena, self.momenta[*s]) else { continue };
            for entry in row {
                collect_noether_factors(arena, &mut normalizer, entry, &mut products);
            }
        }
        for product in products.clone() {
            for q in &self.q {
                let slope = Differential::partial(*q).apply(arena, product);
                collect_noether_factors(arena, &mut normalizer, slope, &mut products);
            }
        }
        products
    }
}

/// Generalized forces Aᵀλ of the motion constraints, one for each coordinate.
fn noether_constraint_forces(model: &Model, arena: &mut Arena) -> Vec<Expr> {
    let mut along = Gradient::new(&model.q_dot());
    let mut sums: Vec<Vec<Expr>> = vec![Vec::new(); model.coordinates.len()];
    for constraint in &model.motion_constraints {
        for &(i, slope) in along.apply(arena, constraint.equation).iter() {
            sums[i].push(arena.mul(slope, constraint.multiplier));
        }
    }
    sums.iter().map(|terms| arena.sum(terms)).collect()
}

/// Collects into `products` the products of one or two sines and cosines that occur in the term
/// `e`.
fn collect_noether_factors(arena: &mut Arena, normalizer: &mut Normalizer, e: Expr, products: &mut BTreeSet<Expr>) {
    let Some(form) = normalizer.normal_form(arena, e) else { return };
    for monomial in normalizer.polynomial(&form.numerator).terms.keys() {
        let is_wave = |e: Expr| matches!(arena.node(e), Node::Apply(Function::Sin | Function::Cos, _));
        let waves: Vec<(Expr, i32)> = monomial.iter().copied().filter(|(e, _)| is_wave(*e)).collect();
        let degree: i32 = waves.iter().map(|(_, n)| *n).sum();
        if (1..=2).contains(&degree) {
            products.insert(monomial_expr(arena, &waves));
        }
    }
}
