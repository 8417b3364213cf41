//! Shared code of the tests of the whole pipeline.

#![allow(dead_code, reason = "each test uses its part")]

pub mod exact;
mod random;
pub mod reduced;
pub mod stability;

pub use random::Random;
use rustc_hash::FxHashMap;
use tripos_derive::algebra::value::tape::Numeric;
use tripos_derive::algebra::{Arena, Expr, Function, Node};
use tripos_sim::Dynamics;
use tripos_traits::{CompiledSystem, System};

/// The compiled equations of a model.
pub fn system(model: &str, formulation: &str) -> &'static (dyn System<f64> + Sync) {
    compiled(model, formulation).double
}

/// The compiled equations of a model, in each kind of number.
pub fn compiled(model: &str, formulation: &str) -> &'static CompiledSystem {
    let model = tripos_models::MODELS.iter().find(|m| m.name == model).expect("a compiled model");
    model.systems.iter().find(|system| system.name == formulation).expect("a compiled formulation")
}

/// u̇ at a state, by any formulation.
pub fn accelerations(system: &dyn System<f64>, p: &[f64], q: &[f64], u: &[f64]) -> Vec<f64> {
    let mut v = vec![0.0; u.len()];
    system.motion_variables(p, q, u, &mut v);
    let x = Dynamics::new(system, p).unwrap().unknowns(q, &v).unwrap().to_vec();
    let mut u_dot = vec![0.0; u.len()];
    system.generalized_speed_rates(p, q, &v, &x[..u.len()], &mut u_dot);
    u_dot
}

/// For each output the largest term that is added or multiplied on the way to it: the interpreter with
/// absolute values, so that nothing cancels.
pub fn largest_terms(arena: &Arena, inputs: &[Expr], values: &[f64], outputs: &[Expr]) -> Vec<f64> {
    let mut plain: FxHashMap<Expr, f64> = FxHashMap::default();
    let mut largest: FxHashMap<Expr, f64> = FxHashMap::default();
    for e in arena.reachable(outputs) {
        let (value, magnitude) = match arena.node(e) {
            Node::Number(k) => (k.to_f64(), k.to_f64().abs()),
            Node::Pi => (std::f64::consts::PI, std::f64::consts::PI),
            Node::Named(_, term) => (plain[term], largest[term]),
            Node::Symbol(_) => {
                let x = values[inputs.iter().position(|i| *i == e).expect("an input")];
                (x, x.abs())
            }
            Node::Sum(c, terms) => {
                let c = c.to_f64();
                let value = terms.iter().fold(c, |s, (t, k)| s + k.to_f64() * plain[t]);
                let magnitude = terms.iter().fold(c.abs(), |s, (t, k)| s.max((k.to_f64() * largest[t]).abs()));
                (value, magnitude)
            }
            Node::Product(factors) => {
                let value = factors.iter().fold(1.0, |s, (b, n)| s * plain[b].powi(*n));
                // A divisor is as small as it is; a factor counts with its largest term.
                let magnitude = factors
                    .iter()
                    .fold(1.0_f64, |s, (b, n)| s * if *n > 0 { largest[b].powi(*n) } else { plain[b].abs().powi(*n) });
                (value, magnitude)
            }
            Node::Apply(f, x) => {
                let value = plain[x].apply(*f);
                // The sum of two angles is rounded as 1 is, however small its sine; so is the sine that an
                // addition theorem gives.
                let wave = matches!(f, Function::Sin | Function::Cos) && matches!(arena.node(*x), Node::Sum(..));
                (value, if wave { value.abs().max(1.0) } else { value.abs() })
            }
        };
        plain.insert(e, value);
        largest.insert(e, magnitude);
    }
    outputs.iter().map(|e| largest[e]).collect()
}
