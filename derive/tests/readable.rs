//! Equations for readers: written out where they are short, and equal in both forms.

use crate::chain::chain;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::form::written_out_formula::written_out_formula;
use tripos_derive::algebra::text::print::{print_text, printed_length};
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{DerivationInSteps, EquationForm, derive_all, derive_in_steps};
use tripos_derive::prove::{first_integrals, prove};
use tripos_derive::{Formulation, Model};

fn library(name: &str) -> Model {
    let models = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../models"));
    Model::read(&models.join(name).join("model.toml")).unwrap_or_else(|e| panic!("{e}"))
}

/// Formulas of a derivation that are read, by their names: M, f, T, V and every line of the steps, with named symbols
/// put in. Lines of partial velocities that are 0 are absent.
fn formulas(derivation: &DerivationInSteps) -> (Arena, BTreeMap<String, Expr>) {
    let DerivationInSteps { arena, equations: e, steps } = derivation;
    let mut arena = arena.clone();
    let mut put = tripos_derive::algebra::term::calculus::Substitution::default();
    for step in &e.definitions {
        let value = put.apply(&mut arena, step.value);
        put.set(step.symbol, value);
    }
    let lines = steps.iter().flat_map(|step| step.lines.iter().map(|(name, value)| (format!("{name:?}"), *value)));
    let all = e.matrix.iter().flatten().chain(&e.forcing).copied().chain([e.kinetic_energy, e.potential_energy]);
    let all = all.enumerate().map(|(at, value)| (at.to_string(), value)).chain(lines);
    let all = all.map(|(name, value)| (name, put.apply(&mut arena, value))).collect();
    (arena, all)
}

/// Goal: both forms are the same equations, line by line. Method: every formulation of library models of every size, by
/// meaning, modulo primes.
#[test]
fn both_forms_are_the_same_equations() {
    for name in ["gimbals", "satellite", "disk", "furuta", "four_bar", "puma560", "rolling_disc"] {
        let model = library(name);
        for f in Formulation::ALL {
            let Ok(closed) = derive_in_steps(&model, f, Some(EquationForm::Closed)) else { continue };
            // Both in one store, so that terms can be subtracted.
            let again = Model { arena: closed.arena.clone(), ..model.clone() };
            let steps = derive_in_steps(&again, f, Some(EquationForm::Steps)).unwrap();
            assert_eq!(closed.equations.rows, steps.equations.rows);
            let ((_, closed), (mut arena, steps)) = (formulas(&closed), formulas(&steps));
            let lines: BTreeSet<&String> = closed.keys().chain(steps.keys()).collect();
            for line in lines {
                let [a, b] = [&closed, &steps].map(|list| list.get(line).copied().unwrap_or(Expr::ZERO));
                let difference = arena.sub(a, b);
                assert_eq!(
                    zero_test(&arena, difference),
                    ZeroTest::Zero,
                    "{name} {f:?} {line}: {}",
                    print_text(&arena, a)
                );
            }
        }
    }
}

/// Goal: three bodies are read without names, and what would fill pages is not written out. Method: the numbers of
/// names in library models by default, and the length of the longest formula.
#[test]
fn equations_of_three_bodies_are_written_out() {
    let names =
        |name: &str, f: Formulation| derive_in_steps(&library(name), f, None).unwrap().equations.definitions.len();
    for f in Formulation::ALL {
        assert_eq!(names("gimbals", f), 0, "{f:?}");
        assert_eq!(names("furuta", f), 0, "{f:?}");
    }
    assert_eq!(names("satellite", Formulation::Kane), 0);
    for name in ["whipple_bicycle", "puma560", "bricard"] {
        assert!(names(name, Formulation::Kane) > 10, "{name}");
    }
    // A long chain of pendulums is short in each entry, but has hundreds of them.
    let long = derive_in_steps(&chain(30), Formulation::Kane, None).unwrap();
    assert!(!long.equations.definitions.is_empty());
    let gimbals = derive_in_steps(&library("gimbals"), Formulation::Kane, None).unwrap();
    let longest = gimbals.equations.matrix.iter().flatten().map(|e| printed_length(&gimbals.arena, *e)).max();
    assert!(longest < Some(40), "{longest:?}");
}

/// Goal: integrals and reactions that are short are written out, and mean the same. Method: those of the gyroscope have
/// no named term; a formula that would be long keeps its names.
#[test]
fn integrals_and_reactions_are_written_out_where_they_are_short() {
    let model = library("gimbals");
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    let arena = &derivations.kinematics.arena;
    let values = proof.integrals.iter().map(|i| i.expression).chain(proof.reactions.iter().map(|r| r.value));
    let values: Vec<Expr> = values.collect();
    assert!(values.len() > 6);
    assert!(arena.reachable(&values).into_iter().all(|part| arena.named_term_value(part).is_none()));
    assert!(proof.integrals.iter().any(|i| print_text(arena, i.expression) == "C*(u_psi*cos(theta) + u_phi)"));

    let model = library("puma560");
    let mut derivations = derive_all(&model).unwrap();
    let energy = derivations.get(Formulation::Kane).unwrap().kinetic_energy;
    let arena = &mut derivations.kinematics.arena;
    assert_eq!(written_out_formula(arena, &mut Simplifier::default(), energy), energy, "it would fill pages");
    let _ = first_integrals(&model, &mut derivations);
}
