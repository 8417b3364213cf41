//! Fields on configuration space and the momenta that belong to them.
//!
//! Noether: along the equations of motion d/dt (ξ · ∂T/∂q̇) = ξ⁽¹⁾T − ξV + ξ·Q with ξ⁽¹⁾T = ξ·∂T/∂q + ξ̇·∂T/∂q̇. The
//! momentum is conserved iff the right-hand side is zero identically; forces that work along ξ are in it.

use crate::algebra::calculus::Differential;
use crate::algebra::normal::Normalizer;
use crate::algebra::relations::relations;
use crate::algebra::simplify::Simplifier;
use crate::algebra::{Arena, Expr};
use crate::mechanics::{Derivations, Kinematics, generalized_forces};
use crate::model::Model;

/// ξ(q), one component for each coordinate, and what its momentum is called.
#[derive(Clone, Debug)]
pub struct Field {
    /// The name of the momentum.
    pub name: String,
    /// Components in q.
    pub xi: Vec<Expr>,
}

/// T, V and Q in q and q̇, with their partial derivatives.
#[derive(Clone)]
pub struct Lagrangian {
    q: Vec<Expr>,
    q_dot: Vec<Expr>,
    t_by_q: Vec<Expr>,
    /// ∂T/∂q̇: the generalized momenta.
    pub momenta: Vec<Expr>,
    v_by_q: Vec<Expr>,
    /// Q: generalized forces of everything but gravity.
    pub forces: Vec<Expr>,
}

impl Lagrangian {
    /// Of a model whose Lagrange equations were derived.
    pub fn new(model: &Model, derivations: &mut Derivations, t: Expr, v: Expr) -> Self {
        let forces = generalized_forces(model, &mut derivations.kinematics);
        let Kinematics { arena, .. } = &mut derivations.kinematics;
        let mut by = |e: Expr, symbols: &[Expr]| -> Vec<Expr> {
            symbols.iter().map(|s| Differential::partial(*s).apply(arena, e)).collect()
        };
        let (q, q_dot) = (model.q(), model.q_dot());
        let (t_by_q, momenta, v_by_q) = (by(t, &q), by(t, &q_dot), by(v, &q));
        Self { q, q_dot, t_by_q, momenta, v_by_q, forces }
    }

    /// Every term.
    pub fn terms(&mut self) -> impl Iterator<Item = &mut Expr> {
        let Self { t_by_q, momenta, v_by_q, forces, .. } = self;
        t_by_q.iter_mut().chain(momenta).chain(v_by_q).chain(forces)
    }

    /// ξ · ∂T/∂q̇.
    pub fn momentum(&self, arena: &mut Arena, xi: &[Expr]) -> Expr {
        let terms: Vec<Expr> = xi.iter().zip(&self.momenta).map(|(x, p)| arena.mul(*x, *p)).collect();
        arena.sum(&terms)
    }

    /// d/dt (ξ · ∂T/∂q̇) along the equations of motion, in q and q̇.
    pub fn rate(&self, arena: &mut Arena, xi: &[Expr]) -> Expr {
        let along: Vec<_> = self.q.iter().copied().zip(self.q_dot.iter().copied()).collect();
        let mut d_dt = Differential::along(&along);
        let mut terms = Vec::new();
        for (i, x) in xi.iter().enumerate() {
            let x_dot = d_dt.apply(arena, *x);
            let gain = arena.add(self.t_by_q[i], self.forces[i]);
            let gain = arena.sub(gain, self.v_by_q[i]);
            terms.push(arena.mul(*x, gain));
            terms.push(arena.mul(x_dot, self.momenta[i]));
        }
        arena.sum(&terms)
    }

    /// The fields ∂/∂q_i whose momenta are conserved: those of cyclic coordinates; all units are returned.
    pub fn units(&self, model: &Model) -> Vec<Field> {
        let n = self.q.len();
        let unit = |i: usize| (0..n).map(|k| if k == i { Expr::ONE } else { Expr::ZERO }).collect();
        let fields = model.coordinates.iter().enumerate();
        fields.map(|(i, c)| Field { name: format!("momentum p_{} = ∂L/∂{}'", c.name, c.name), xi: unit(i) }).collect()
    }

    /// All fields ξ = A q + b with constant A and b whose momenta are conserved: a basis of the null space of
    /// conditions linear in A and b, over the field of the parameters. `None` if it is too large to decide.
    pub fn affine(&self, model: &Model, arena: &mut Arena, simplifier: &mut Simplifier) -> Option<Vec<Field>> {
        let n = self.q.len();
        let mut unknowns: Vec<(usize, Expr)> = Vec::new();
        for i in 0..n {
            unknowns.push((i, Expr::ONE));
            unknowns.extend(self.q.iter().map(|q| (i, *q)));
        }
        let mut conditions = Vec::new();
        for (i, factor) in &unknowns {
            let xi: Vec<Expr> = (0..n).map(|k| if k == *i { *factor } else { Expr::ZERO }).collect();
            conditions.push(self.rate(arena, &xi));
        }
        let mut normalizer = Normalizer::new(Normalizer::BUDGET);
        let basis = relations(arena, simplifier, &mut normalizer, &conditions, &model.p())?;
        let mut fields = Vec::new();
        for coefficients in basis {
            let mut xi = vec![Vec::new(); n];
            for ((i, factor), c) in unknowns.iter().zip(&coefficients) {
                xi[*i].push(arena.mul(*factor, *c));
            }
            let xi: Vec<Expr> = xi.iter().map(|terms| arena.sum(terms)).collect();
            let text = |e: Expr| crate::algebra::print::text(arena, e);
            let parts = model.coordinates.iter().zip(&xi).filter(|(_, e)| **e != Expr::ZERO);
            let parts: Vec<String> = parts.map(|(c, e)| format!("{}' = {}", c.name, text(*e))).collect();
            fields.push(Field { name: format!("momentum of the symmetry {}", parts.join(", ")), xi });
        }
        Some(fields)
    }
}
