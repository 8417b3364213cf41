//! Equations whose terms are named are those written out: random mechanisms derived both ways.

use crate::arm::{Reactions, arm};
use crate::mechanism::Mechanism;
use crate::spoilt::Random;
use tripos::code::{CodePreparation, runnable_code};
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::solve::quadratic_minimum::minimize_quadratic_form;
use tripos_derive::algebra::term::calculus::Substitution;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::mechanics::{EquationForm, Kinematics, derive_all_with};
use tripos_derive::{Equations, Formulation, Model, model};
use tripos_traits::{DoubleDouble, Real, Scalar};

/// Every entry, what is required for accelerations, the energies and the power.
fn entries(arena: &mut Arena, e: &Equations) -> Vec<Expr> {
    let e = e.clone().with_certified_inverse_dynamics(arena).unwrap();
    let scalars = [e.kinetic_energy, e.potential_energy, e.power];
    let lists = [&e.matrix.concat(), &e.forcing, &e.required];
    lists.into_iter().flatten().copied().chain(scalars).collect()
}

/// The places where the two ways differ by meaning, with the formulations.
fn differences(model: &Model) -> Vec<(Formulation, usize)> {
    let mut named = derive_all_with(model, Kinematics::in_form(model, EquationForm::Steps).unwrap()).unwrap();
    named.add(model, Formulation::GibbsAppell).unwrap();
    // Both in one store, so that terms can be subtracted.
    let again = Model { arena: named.kinematics.arena.clone(), ..model.clone() };
    let mut written = derive_all_with(&again, Kinematics::in_form(&again, EquationForm::Closed).unwrap()).unwrap();
    written.add(&again, Formulation::GibbsAppell).unwrap();
    let mut arena = written.kinematics.arena.clone();
    let mut found = Vec::new();
    for f in Formulation::ALL {
        let (Ok(a), Ok(b)) = (named.result(f), written.result(f)) else {
            assert_eq!(named.result(f).is_err(), written.result(f).is_err(), "{f:?}");
            continue;
        };
        assert_eq!(a.rows, b.rows, "{f:?}");
        let (left, right) = (entries(&mut arena, a), entries(&mut arena, b));
        for (at, (x, y)) in left.into_iter().zip(right).enumerate() {
            let difference = arena.sub(x, y);
            if zero_test(&arena, difference) != ZeroTest::Zero {
                found.push((f, at));
            }
        }
    }
    found
}

/// True if the minimum of Gauss's form solves Kane's equations: its u' satisfy M u' = f by meaning.
fn is_solved(arena: &mut Arena, kane: &Equations) -> bool {
    let Some(gauss) = &kane.gauss else { return false };
    let Some(recursion) = minimize_quadratic_form(arena, &mut Simplifier::default(), gauss, &kane.unknowns) else {
        return false;
    };
    let mut put = Substitution::default();
    for step in recursion {
        let value = put.apply(arena, step.value);
        put.set(step.symbol, value);
    }
    kane.matrix.iter().zip(&kane.forcing).all(|(row, right)| {
        let mut terms: Vec<Expr> = vec![arena.neg(*right)];
        for (entry, rate) in row.iter().zip(&kane.unknowns) {
            let rate = put.apply(arena, *rate);
            terms.push(arena.mul(*entry, rate));
        }
        let left = arena.sum(&terms);
        zero_test(arena, left) == ZeroTest::Zero
    })
}

/// Goal: names do not change the equations. Method: mechanisms with hinges and slides, mixed speeds, springs, dampers,
/// drag at points that move in their links and all reactions, derived with names and without. Every entry of every
/// formulation, T, V and the power are equal by meaning, and the accelerations found body by body solve M u' = f. A
/// defect that both ways share would escape.
#[test]
fn random_mechanisms_have_the_same_equations_with_names_and_without() {
    let count = std::env::var("TRIPOS_NAMED").ok().and_then(|n| n.parse().ok()).unwrap_or(60);
    for seed in 0..count {
        let text = Mechanism::new(&mut Random(seed)).text();
        let model = model::load(&Source::from_text("model.toml", &text)).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(differences(&model), [], "seed {seed}:\n{text}");
        let mut named = derive_all_with(&model, Kinematics::in_form(&model, EquationForm::Steps).unwrap()).unwrap();
        let kane = named.get(Formulation::Kane).unwrap().clone();
        assert!(is_solved(&mut named.kinematics.arena, &kane), "seed {seed}:\n{text}");
    }
}

type Dd = DoubleDouble;

/// Goal: what runs of a large model are made of is right without being compiled: the Jacobian from its products with
/// directions, the recurrences over named steps. Method: an arm of five joints by two formulations, in 32 digits; the
/// Jacobian against central differences, and the second derivative of the motion from it against the recurrences.
#[test]
fn large_models_run_interpreted() {
    let n = 5;
    let mechanism = tripos::Mechanism::new(arm(n, Reactions::None));
    let p: Vec<Dd> = (0..mechanism.parameters.len()).map(|i| Dd::from_f64(1.0 + 0.07 * i as f64)).collect();
    let state: Vec<Dd> =
        (0..2 * n).map(|i| Dd::from_f64(0.3 + 0.4 * i as f64 - if i < n { 0.0 } else { 2.5 })).collect();
    let mut both = Vec::new();
    for formulation in [Formulation::Kane, Formulation::Lagrange] {
        let code =
            runnable_code(&mechanism, &EquationsOrigin::from(formulation), None, CodePreparation::Solved).unwrap();
        let system = code.extended();
        let derivative = |y: &[Dd]| {
            let (mut q_dot, mut v_dot) = (vec![Dd::int(0); n], vec![Dd::int(0); n]);
            system.derivative(&p, &y[..n], &y[n..], &mut q_dot, &mut v_dot);
            [q_dot, v_dot].concat()
        };
        let rates = derivative(&state);
        let mut jacobian = vec![Dd::int(0); 4 * n * n];
        system.jacobian(&p, &state[..n], &state[n..], &mut jacobian);
        let step = Dd::from_f64(1e-9);
        for column in 0..2 * n {
            let moved = |by: Dd| {
                let mut y = state.clone();
                y[column] = y[column] + by;
                derivative(&y)
            };
            let (up, down) = (moved(step), moved(-step));
            for row in 0..2 * n {
                let slope = (up[row] - down[row]) / (step + step);
                let off = (slope - jacobian[row * 2 * n + column]).to_f64().abs();
                assert!(off < 1e-13 * (1.0 + slope.to_f64().abs()), "{formulation:?} {row} {column}: {off:e}");
            }
        }
        let mut series = [state.as_slice(), &vec![Dd::int(0); 4 * n]].concat();
        system.taylor(&p, 2, &mut series, &mut vec![Dd::int(0); system.taylor_work(2)]);
        for row in 0..2 * n {
            let second = (0..2 * n).fold(Dd::int(0), |sum, at| sum + jacobian[row * 2 * n + at] * rates[at]);
            let off = (series[4 * n + row] + series[4 * n + row] - second).to_f64().abs();
            assert!(off < 1e-26 * (1.0 + second.to_f64().abs()), "{formulation:?} {row}: {off:e}");
        }
        both.push(rates);
    }
    for (a, b) in both[0].iter().zip(&both[1]) {
        assert!((*a - *b).to_f64().abs() < 1e-27 * (1.0 + a.to_f64().abs()));
    }
}
