//! Large models: growing terms are named, keep their meaning, grow at the expected rate, and are proved at full size.

use crate::arm::{Reactions, arm, tree};
use crate::chain::{chain, relative_chain};
use std::collections::HashSet;
use std::path::Path;
use tripos_derive::algebra::form::simplify::{Simplifier, operation_count};
use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::algebra::solve::quadratic_minimum::minimize_quadratic_form;
use tripos_derive::algebra::term::adjoint::adjoint_product;
use tripos_derive::algebra::term::calculus::{Differential, Gradient, Substitution};
use tripos_derive::algebra::term::steps::{Definition, needed_steps};
use tripos_derive::algebra::text::definitions::write_definitions;
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Arena, Expr, Node};
use tripos_derive::mechanics::{
    Derivation, Divisors, EquationForm, Kinematics, SolvedAccelerations, derive_all, derive_all_with,
};
use tripos_derive::prove::prove;
use tripos_derive::{Equations, Formulation, Model, derive};

fn entries(e: &Equations) -> Vec<Expr> {
    let lists = [&e.matrix.concat(), &e.forcing, &e.required];
    lists.into_iter().flatten().copied().chain([e.kinetic_energy, e.potential_energy]).collect()
}

/// Goal: trees with branches and slides have their equations. Method: named and written out, every formulation, entry
/// by entry, by meaning.
#[test]
fn trees_have_the_same_equations_with_names_and_without() {
    let slide = |i: usize| i == 2;
    for model in [
        arm(2, Reactions::All),
        arm(3, Reactions::All),
        tree(3, |i| i / 2, slide, Reactions::All),
        tree(4, |i| i / 3, slide, Reactions::None),
    ] {
        let mut named = derive_all_with(&model, Kinematics::in_form(&model, EquationForm::Steps).unwrap()).unwrap();
        named.add(&model, Formulation::GibbsAppell).unwrap();
        let again = Model { arena: named.kinematics.arena.clone(), ..model.clone() };
        let mut plain = derive_all_with(&again, Kinematics::in_form(&again, EquationForm::Closed).unwrap()).unwrap();
        plain.add(&again, Formulation::GibbsAppell).unwrap();
        let mut arena = plain.kinematics.arena.clone();
        for f in Formulation::ALL.into_iter().filter(|f| !f.has_reactions() || !model.reactions.is_empty()) {
            let [a, b] = [&named, &plain]
                .map(|all| all.result(f).unwrap().clone().with_certified_inverse_dynamics(&mut arena).unwrap());
            for (x, y) in entries(&a).into_iter().zip(entries(&b)) {
                let difference = arena.sub(x, y);
                assert_eq!(zero_test(&arena, difference), ZeroTest::Zero, "{} {f:?}", model.title);
            }
        }
    }
}

/// Goal: what is short stays as a person writes it. Method: no term of the models that textbooks have gets a name.
#[test]
fn small_models_are_written_out() {
    for model in [chain(1), chain(3), chain(6), arm(2, Reactions::All)] {
        assert_eq!(EquationForm::computed(&model), EquationForm::Closed, "{}", model.title);
        let Derivation { arena, equations } = derive(&model, Formulation::Kane).unwrap();
        let parts = arena.reachable(&entries(&equations));
        assert!(parts.iter().all(|e| arena.named_term_value(*e).is_none()), "{}", model.title);
    }
    assert!(
        [arm(3, Reactions::None), chain(20)].iter().all(|model| EquationForm::computed(model) == EquationForm::Steps)
    );
}

/// Operations of these values and of the steps that they need, one for each + − × ÷: (with what moves, of parameters
/// alone). Sines and cosines are counted apart.
fn operations(arena: &Arena, model: &Model, steps: &[Definition], values: &[Expr]) -> (usize, usize) {
    let mut constant: HashSet<Expr> = model.parameters.iter().map(|p| p.symbol).collect();
    let functions = |e: Expr| {
        let parts = arena.reachable(&[e]).into_iter();
        parts.filter(|e| matches!(arena.node(*e), Node::Apply(..))).count()
    };
    let (mut moving, mut fixed) = (0, 0);
    for step in needed_steps(arena, steps, values) {
        let parts = arena.reachable(&[step.value]);
        let own = operation_count(arena, step.value) - 4 * functions(step.value);
        if parts.iter().all(|e| arena.symbol_name(*e).is_none() || constant.contains(e)) {
            constant.insert(step.symbol);
            fixed += own;
        } else {
            moving += own;
        }
    }
    (moving + values.iter().map(|e| operation_count(arena, *e) - 4 * functions(*e)).sum::<usize>(), fixed)
}

/// The operations by Kane's method of M with f, of f, of the accelerations and of inverse dynamics.
fn counts(model: &Model) -> [usize; 4] {
    let Derivation { mut arena, equations } = derive(model, Formulation::Kane).unwrap();
    let e = equations.with_definitions(&mut arena);
    let upper: Vec<Expr> = e.matrix.iter().enumerate().flat_map(|(i, row)| row[i..].to_vec()).collect();
    let both = operations(&arena, model, &e.definitions, &[upper, e.forcing.clone()].concat()).0;
    let forcing = operations(&arena, model, &e.definitions, &e.forcing).0;
    let solved = SolvedAccelerations::new(&mut arena, &equations).unwrap();
    let rates = &e.unknowns[..e.variables.len()];
    let inverse = operations(&arena, model, &e.definitions, &e.required).0;
    [both, forcing, operations(&arena, model, &solved.accelerations.steps, rates).0, inverse]
}

/// Goal: an arm of full inertias takes about what generators made for arms need. Method: counted operations of its M, f
/// and accelerations, work of parameters alone apart.
#[test]
fn an_arm_of_six_joints_takes_few_operations() {
    let [both, forcing, accelerations, inverse] = counts(&arm(6, Reactions::None));
    assert!(both <= 1400 && forcing <= 760 && accelerations <= 1650, "{both}, {forcing}, {accelerations}");
    assert!(inverse <= 800, "{inverse}");
}

/// Goal: where rates of joints follow from angular accelerations, no term that cancels is computed. Method: links whose
/// angles are from the link before. Their accelerations took 40 % more when a pivot was divided by itself.
#[test]
fn links_with_relative_angles_take_no_more_than_from_one_frame() {
    let [relative, absolute] = [relative_chain(20), chain(20)].map(|model| counts(&model)[2]);
    assert!(relative <= 1200 && relative <= absolute, "{relative}, {absolute}");
}

/// Goal: no run of an arm or a chain watches for zeros of pivots, which a positive definite form has not. Method: what
/// the accelerations of long ones divide by, and Newton's and Euler's of a short one.
#[test]
fn arms_and_chains_divide_by_nothing_that_vanishes() {
    let list = [
        (arm(6, Reactions::None), Formulation::Kane),
        (chain(10), Formulation::Kane),
        (chain(10), Formulation::Lagrange),
    ];
    for (model, formulation) in list.into_iter().chain([(arm(3, Reactions::All), Formulation::NewtonEuler)]) {
        let Derivation { mut arena, equations } = derive(&model, formulation).unwrap();
        let solved = SolvedAccelerations::new(&mut arena, &equations).unwrap();
        let found = Divisors::of(&arena, &equations.with_definitions(&mut arena.clone()), Some(&solved.accelerations));
        assert!(found.values.is_empty(), "{} {formulation:?}: {:?}", model.title, found.names(&arena));
    }
}

/// Goal: forces and the accelerations of long arms and chains grow with their length, matrices with its square. Method:
/// exponents between two lengths, of arms, of chains whose angles are all from one frame, and of those whose angles are
/// from the link before.
#[test]
fn operations_grow_as_they_must() {
    for (what, [short, long]) in [
        ("arms", [20, 40].map(|n| counts(&arm(n, Reactions::None)))),
        ("chains", [20, 40].map(|n| counts(&chain(n)))),
        ("chains with relative angles", [20, 40].map(|n| counts(&relative_chain(n)))),
    ] {
        println!("{what}: {short:?}, {long:?}");
        let exponent = |at: usize| (long[at] as f64 / short[at] as f64).log2();
        let found = [exponent(0), exponent(1), exponent(2), exponent(3)];
        assert!(
            found[0] < 2.05 && found[1..].iter().all(|grows| *grows < 1.1),
            "{what}: {found:?}, {short:?}, {long:?}"
        );
    }
}

/// Goal: the accelerations that the recursion gives body by body solve the equations. Method: M u' = f as an
/// identity, with every u' of the recursion, for arms, branches, slides and chains.
#[test]
fn recursions_solve_the_equations() {
    let slide = |i: usize| i == 2;
    for model in [
        arm(3, Reactions::None),
        tree(4, |i| i / 2, slide, Reactions::None),
        tree(5, |i| i / 3, slide, Reactions::None),
        chain(8),
        relative_chain(6),
    ] {
        let Derivation { mut arena, equations } = derive(&model, Formulation::Kane).unwrap();
        let gauss = equations.gauss.as_ref().unwrap();
        let recursion =
            minimize_quadratic_form(&mut arena, &mut Simplifier::default(), gauss, &equations.unknowns).unwrap();
        let solved = recursion.iter().filter(|step| equations.unknowns.contains(&step.symbol)).count();
        assert_eq!(solved, equations.variables.len(), "{}", model.title);
        let mut put = Substitution::default();
        for step in recursion {
            let value = put.apply(&mut arena, step.value);
            put.set(step.symbol, value);
        }
        for (row, right) in equations.matrix.iter().zip(&equations.forcing) {
            let mut left = arena.neg(*right);
            for (entry, rate) in row.iter().zip(&equations.unknowns) {
                let rate = put.apply(&mut arena, *rate);
                let term = arena.mul(*entry, rate);
                left = arena.add(left, term);
            }
            assert_eq!(zero_test(&arena, left), ZeroTest::Zero, "{}", model.title);
        }
    }
}

/// Goal: equivalence and conserved quantities are proved at any size, names and all. Method: a tree of thirty bodies
/// with branches, hinges and slides.
#[test]
fn a_tree_of_thirty_bodies_is_proved() {
    let model = tree(30, |i| i / 2, |i| i % 7 == 3, Reactions::None);
    let mut all = derive_all(&model).unwrap();
    let proof = prove(&model, &mut all);
    assert_eq!(proof.pairs.len(), 1);
    assert!(proof.pairs.iter().all(|pair| pair.verdict.is_equal()), "{:?}", proof.pairs);
    assert!(proof.integrals.iter().any(|integral| integral.verdict.is_equal()));
}

/// Goal: the arm that large models are measured with is derived by all methods, which say the same. Method: its file.
#[test]
fn the_arm_of_the_benchmarks_is_proved() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../benches/models/arm6.toml");
    let model = Model::read(&path).unwrap_or_else(|e| panic!("{e}"));
    let mut all = derive_all(&model).unwrap();
    assert!(all.list.iter().all(|(_, result)| result.is_ok()));
    let proof = prove(&model, &mut all);
    assert!(proof.is_equivalent() && proof.pairs.len() == 3);
    // T + V, and the momentum about the upright first axis.
    assert_eq!(proof.integrals.iter().filter(|integral| integral.verdict.is_equal()).count(), 2);
}

/// Goal: a wrong entry anywhere in a large system is seen. Method: each entry of the matrix of an arm, doubled, makes
/// the formulations differ.
#[test]
fn a_wrong_entry_of_a_large_system_is_seen() {
    let model = arm(5, Reactions::None);
    let mut all = derive_all(&model).unwrap();
    let (_, kane) = all.list.iter_mut().find(|(f, _)| *f == Formulation::Kane).unwrap();
    let entry = &mut kane.as_mut().unwrap().matrix[1][3];
    *entry = all.kinematics.arena.add(*entry, *entry);
    let proof = prove(&model, &mut all);
    assert!(matches!(proof.pairs[0].verdict, Verdict::Different(_)), "{:?}", proof.pairs[0].verdict);
}

/// Goal: written down, every step stands after what it needs and has a symbol of its own. Method: an arm's equations.
#[test]
fn steps_stand_after_what_they_need() {
    let model = arm(4, Reactions::All);
    for f in Formulation::ALL {
        let Derivation { mut arena, equations } = derive(&model, f).unwrap();
        let e = equations.with_definitions(&mut arena);
        let steps: HashSet<Expr> = e.definitions.iter().map(|d| d.symbol).collect();
        assert_eq!(steps.len(), e.definitions.len());
        let mut known: HashSet<Expr> = HashSet::new();
        let check = |known: &HashSet<Expr>, e: Expr| {
            for part in arena.reachable(&[e]) {
                assert!(arena.named_term_value(part).is_none(), "no name is left");
                assert!(!steps.contains(&part) || known.contains(&part), "{}", print_text(&arena, part));
            }
        };
        for step in &e.definitions {
            check(&known, step.value);
            known.insert(step.symbol);
        }
        for entry in entries(&e) {
            check(&known, entry);
        }
        // The same symbols whenever it is written.
        assert_eq!(equations.with_definitions(&mut arena).definitions, e.definitions);
    }
}

/// A store with three variables, and terms by names that go back to them.
fn sample() -> (Arena, Vec<Expr>, Vec<Expr>) {
    let mut arena = Arena::new();
    let variables = ["x", "y", "z"].map(|name| arena.symbol(name)).to_vec();
    let mut terms = Vec::new();
    for (at, formula) in ["x*y + sin(z)", "x - 2*y*z", "cos(x*z) + y^2"].into_iter().enumerate() {
        let e = parse_free(&mut arena, formula).unwrap();
        terms.push(arena.name(e, &format!("a{at}")));
    }
    for at in 0..6 {
        let (a, b, c) = (terms[at], terms[at + 1], terms[at + 2]);
        let product = arena.mul(a, b);
        let sum = arena.sub(product, c);
        terms.push(arena.name(sum, &format!("b{at}")));
    }
    (arena, variables, terms)
}

/// Goal: names are transparent to meaning and walls to rewriting. Method: multiples share a name, what needs none gets
/// none; values and derivatives are those of the terms written out.
#[test]
fn a_name_changes_no_value() {
    let (mut arena, variables, terms) = sample();
    let e = parse_free(&mut arena, "3*x - 3*y").unwrap();
    let minus = arena.neg(e);
    let (one, other) = (arena.name(e, "d"), arena.name(minus, "other"));
    assert_eq!(other, arena.neg(one));
    assert_eq!(print_text(&arena, one), "3*(x - y)", "a name that is not written is shown as its term");
    assert_eq!(arena.name(variables[0], "x2"), variables[0]);
    assert_eq!(arena.name(one, "again"), one);

    let last = *terms.last().unwrap();
    let (steps, values) = write_definitions(&mut arena, &[], &[last]);
    let mut out = Substitution::default();
    for step in &steps {
        let value = out.apply(&mut arena, step.value);
        out.set(step.symbol, value);
    }
    let plain = out.apply(&mut arena, values[0]);
    assert!(arena.reachable(&[plain]).iter().all(|e| arena.named_term_value(*e).is_none()));
    let difference = arena.sub(plain, last);
    assert_eq!(zero_test(&arena, difference), ZeroTest::Zero);
    let slopes = [plain, last].map(|e| Differential::partial(variables[1]).apply(&mut arena, e));
    let tape = Tape::new(&arena, &variables, &[plain, last, slopes[0], slopes[1]]).unwrap();
    let found = tape.evaluate(&[0.3, -1.2, 0.7]);
    assert!((found[0] - found[1]).abs() < 1e-9 && (found[2] - found[3]).abs() < 1e-9 * found[2].abs(), "{found:?}");
}

/// Goal: backward and forward derivatives are one. Method: weights times slopes, summed term by term along each
/// variable, against the transposed product.
#[test]
fn a_transposed_product_is_the_sum_of_weighted_slopes() {
    let (mut arena, variables, terms) = sample();
    let pairs: Vec<(Expr, Expr)> = terms.iter().rev().take(4).enumerate().map(|(at, e)| (*e, terms[at])).collect();
    let backward = adjoint_product(&mut arena, &pairs, &variables, "to");
    let mut gradient = Gradient::new(&variables);
    let mut forward = vec![Expr::ZERO; variables.len()];
    for (e, weight) in pairs {
        for (at, slope) in gradient.apply(&mut arena, e).iter() {
            let share = arena.mul(*slope, weight);
            forward[*at] = arena.add(forward[*at], share);
        }
    }
    for (a, b) in backward.into_iter().zip(forward) {
        let difference = arena.sub(a, b);
        assert_eq!(zero_test(&arena, difference), ZeroTest::Zero);
    }
}
