//! Recurrences of Taylor coefficients: generated, interpreted, and against derivatives taken in the algebra.

use crate::support;

use std::path::Path;
use support::{compiled, system};
use tripos::Mechanism;
use tripos::code::{CodePreparation, runnable_code};
use tripos_codegen::taylor::{Tape, cheapest_recurrences, cheapest_recurrences_of};
use tripos_derive::algebra::term::calculus::Differential;
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::value::tape::Tape as Values;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{EquationsOrigin, SolvedAccelerations};
use tripos_derive::{Formulation, Model, derive};
use tripos_sim::{EliminatedDynamics, Method, Options, OutputOption, integrate};
use tripos_traits::{DoubleDouble, Real, Scalar, System};

type Dd = DoubleDouble;

const MODELS: [&str; 9] = [
    "disk",
    "cart_pendulum_3",
    "chaotic_pendulum",
    "heavy_top",
    "pendulum",
    "spherical_pendulum",
    "free_body",
    "floating_chain",
    "euler_top",
];

/// A state and parameters without a pattern, the parameters from 0.6 to 1.4, angles and rates within ±0.7.
fn numbers(system: &dyn System<Dd>) -> (Vec<Dd>, Vec<Dd>) {
    let wave = |i: usize, shift: f64| (1.7 * i as f64 + shift).sin();
    let p = (0..system.lengths().parameters).map(|i| Dd::from_f64(1.0 + 0.4 * wave(i, 0.3))).collect();
    let n = system.lengths().state();
    (p, (0..n).map(|i| Dd::from_f64(0.7 * wave(i, 1.1))).collect())
}

fn coefficients<S: Real>(system: &dyn System<S>, p: &[S], start: &[S], order: usize) -> Vec<S> {
    let mut x = start.to_vec();
    x.resize((order + 1) * start.len(), S::int(0));
    system.taylor(p, order, &mut x, &mut vec![S::int(0); system.taylor_work(order)]);
    x
}

/// |d/dt of the polynomial − f(the polynomial)| at the time t, the largest of the components.
fn defect(system: &dyn System<Dd>, p: &[Dd], x: &[Dd], order: usize, t: Dd) -> f64 {
    let (n, speeds) = (system.lengths().coordinates, system.lengths().variables);
    let states = n + speeds;
    let (mut y, mut slope, mut f) = (vec![Dd::int(0); states], vec![Dd::int(0); states], vec![Dd::int(0); states]);
    for k in (0..=order).rev() {
        for i in 0..states {
            y[i] = y[i] * t + x[k * states + i];
            if k > 0 {
                slope[i] = slope[i] * t + Dd::int(i64::try_from(k).unwrap()) * x[k * states + i];
            }
        }
    }
    let (q_dot, v_dot) = f.split_at_mut(n);
    system.derivative(p, &y[..n], &y[n..], q_dot, v_dot);
    slope.iter().zip(&f).map(|(a, b)| (*a - *b).abs().to_f64()).fold(0.0, f64::max)
}

/// Goal: every coefficient of every derived system. Method: with p orders the polynomial satisfies the equations up to
/// O(tᵖ), which the generated derivative judges; a wrong coefficient of a lower order k would leave O(tᵏ⁻¹). In 32
/// digits, t = 2⁻⁸ and half of it, where the next term changes the order by less than 0.3 and rounding is far below.
#[test]
fn the_series_of_every_model_satisfies_its_equations_to_its_order() {
    let mut seen = 0;
    for model in MODELS {
        let found = tripos_models::MODELS.iter().find(|m| m.name == model).unwrap();
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(model);
        let mechanism = Mechanism::new(Model::read(&folder.join("model.toml")).unwrap());
        let tape = |formulation| {
            runnable_code(&mechanism, &EquationsOrigin::from(formulation), None, CodePreparation::WithSeries).unwrap()
        };
        for named in found.systems.iter().filter(|s| !s.name.starts_with("printed:")) {
            // Few have their recurrences compiled; those of all other formulations are interpreted.
            let interpreted = Formulation::from_name(named.name).filter(|_| !named.extended.has_taylor()).map(tape);
            let system: &dyn System<Dd> = match &interpreted {
                Some(code) => code.extended(),
                None if named.extended.has_taylor() => named.extended,
                None => continue,
            };
            assert!(system.has_taylor(), "{model} {}", named.name);
            let (p, start) = numbers(system);
            for order in 1..=9 {
                let x = coefficients(system, &p, &start, order);
                let t = Dd::ratio(1, 256);
                let (whole, half) =
                    (defect(system, &p, &x, order, t), defect(system, &p, &x, order, t * Dd::ratio(1, 2)));
                let observed = (whole / half).log2();
                let tiny = whole < 1e-28;
                assert!(tiny || (observed - order as f64).abs() < 0.3, "{model} {} {order}: {observed}", named.name);
                seen += 1;
            }
        }
    }
    assert!(seen >= 9 * 30, "{seen}");
}

/// The interpreter sums convolutions one by one, the generated code by pairs of orders and in vector registers, in
/// `f64` and in 32 digits. 1e-11 of the largest coefficient of an order: both round every term of some dozens, order
/// upon order.
#[test]
fn compiled_series_equal_interpreted_ones() {
    let mut seen = 0;
    for folder in MODELS {
        let path = format!("{}/models/{folder}/model.toml", env!("CARGO_MANIFEST_DIR"));
        let model = Model::read(path.as_ref()).unwrap();
        for formulation in Formulation::STANDARD {
            let mut derivation = derive(&model, formulation).unwrap();
            let solved = SolvedAccelerations::new(&mut derivation.arena, &derivation.equations).unwrap();
            let equations = &derivation.equations;
            let list = cheapest_recurrences_of(&mut derivation.arena, equations, &solved.accelerations).unwrap();
            let tape = Tape::new(&derivation.arena, &model.p(), &list).unwrap();
            let named = compiled(folder, formulation.name());
            if !named.double.has_taylor() {
                continue;
            }
            seen += 1;
            let (p, start) = numbers(named.extended);
            let narrow = |list: &[Dd]| list.iter().map(|x| x.to_f64()).collect::<Vec<_>>();
            for order in [1, 2, 3, 4, 5, 8, 15, 22] {
                let wide = coefficients(named.extended, &p, &start, order);
                let double = coefficients(named.double, &narrow(&p), &narrow(&start), order);
                let mut interpreted = narrow(&start);
                interpreted.resize(wide.len(), 0.0);
                tape.evaluate(&narrow(&p), order, &mut interpreted);
                for k in 0..=order {
                    let row = k * start.len()..(k + 1) * start.len();
                    let scale = narrow(&wide[row.clone()]).into_iter().map(f64::abs).fold(1e-3, f64::max);
                    for i in row {
                        let exact = wide[i].to_f64();
                        let errors = [double[i] - exact, interpreted[i] - exact].map(|e| e.abs() / scale);
                        assert!(
                            errors.iter().all(|e| *e < 1e-11),
                            "{folder} {formulation:?} {k} of {order}: {errors:?}"
                        );
                    }
                }
            }
        }
    }
    assert!(seen >= 6, "{seen}");
}

/// Formulas in x and y with the operation that each is there for.
const FORMULAS: [&str; 24] = [
    "x*y",
    "x^2*y^3",
    "x^7",
    "x/y",
    "1/y",
    "1/(x*y)",
    "y/x^3",
    "sin(x)",
    "cos(x*y)",
    "tan(y)",
    "sqrt(x + y)",
    "exp(-x)",
    "log(y + 2*x)",
    "asin(x/3)",
    "acos(x*y/5)",
    "atan(x - y)",
    "sinh(y)",
    "cosh(x)",
    "tanh(x + y^2)",
    "(a*x + y)*(x - a*y)/(a + x^2)",
    "sin(x)^2*cos(x)/(2 - sin(x))",
    "exp(sin(x)) + a*sqrt(1 + cos(y)^2)",
    "a*x*y + a*x*sin(y) - x^2*y*sin(y)",
    "((x + y)^3 - a)/(x*y^2) + x*y*cos(x)",
];

/// d²/dt² and higher of a motion, by the algebra: along the rates, again and again.
fn derivatives(arena: &mut Arena, e: Expr, rates: &[(Expr, Expr)], count: usize) -> Vec<Expr> {
    let mut list = vec![e];
    for _ in 1..count {
        let last = list[list.len() - 1];
        list.push(Differential::along(rates).apply(arena, last));
    }
    list
}

/// Goal: the recurrence of every operation, and the forms chosen for few convolutions. Method: z' = f(x, y) with x' = y
/// and y' = −x + a, whose derivatives the algebra takes by its own rules. 1e-12 of the coefficient, or of 1.
#[test]
fn every_operation_has_the_series_that_its_derivatives_give() {
    const ORDER: usize = 6;
    for text in FORMULAS {
        let mut arena = Arena::new();
        let [a, x, y, z] = ["a", "x", "y", "z"].map(|name| arena.symbol(name));
        let formula = parse_free(&mut arena, text).unwrap_or_else(|error| panic!("{text}: {error:?}"));
        let y_rate = arena.sub(a, x);
        let rates = [(x, y), (y, y_rate)];
        let list = cheapest_recurrences(&mut arena, &[x, y, z], &[y, y_rate, formula], &[]).unwrap();
        let tape = Tape::new(&arena, &[a], &list).unwrap();
        let exact = derivatives(&mut arena, formula, &rates, ORDER);
        let exact = Values::new(&arena, &[a, x, y], &exact).unwrap();
        for (x0, y0) in [(0.7, 0.9), (1.3, 0.4), (0.2, 1.6)] {
            let mut found = vec![0.0; 3 * (ORDER + 1)];
            found[..3].copy_from_slice(&[x0, y0, 0.5]);
            tape.evaluate(&[0.8], ORDER, &mut found);
            let mut factorial = 1.0;
            for (k, value) in exact.evaluate(&[0.8, x0, y0]).into_iter().enumerate() {
                factorial *= (k + 1) as f64;
                let (found, exact) = (found[3 * (k + 1) + 2], value / factorial);
                assert!(
                    (found - exact).abs() < 1e-12 * exact.abs().max(1.0),
                    "{text}, order {}: {found} {exact}",
                    k + 1
                );
            }
        }
    }
}

#[test]
fn functions_without_a_series_are_refused() {
    for text in ["abs(x)", "x*sin(abs(y))"] {
        let mut arena = Arena::new();
        let [x, y] = ["x", "y"].map(|name| arena.symbol(name));
        let formula = parse_free(&mut arena, text).unwrap();
        assert_eq!(cheapest_recurrences(&mut arena, &[x, y], &[y, formula], &[]), None, "{text}");
    }
}

/// The disk for 2 s by all formulations, in doubles by Taylor's method against DOP853 in 32 digits; 2000 times the
/// tolerance, for what the motion makes of it.
#[test]
fn every_formulation_of_the_disk_arrives_where_dop853_does() {
    for formulation in ["kane", "lagrange", "newton-euler"] {
        let named = compiled("disk", formulation);
        let p = [Dd::int(1), Dd::int(1), Dd::decimal("9.81")];
        let u = ["-0.1", "0.3", "0.2", "0.4", "0.1"].map(Dd::decimal);
        let q = ["0.1", "0.6", "0.7", "5", "1"].map(Dd::decimal);
        let mut v = [Dd::int(0); 5];
        named.extended.motion_variables(&p, &q, &u, &mut v);
        let start = [q, v].concat();
        let options = |method, tolerance| Options {
            method,
            output: OutputOption::Ends,
            ..Options::tolerances(tolerance, tolerance)
        };
        let reference = EliminatedDynamics::new(named.extended, &p).unwrap();
        let reference = integrate(reference, (0.0, 2.0), &start, &options(Method::Dop853, 1e-18), &mut []).unwrap();
        let narrow = |list: &[Dd]| list.iter().map(|x| x.to_f64()).collect::<Vec<_>>();
        for tolerance in [1e-4, 1e-7, 1e-10, 1e-13] {
            let rhs = EliminatedDynamics::new(system("disk", formulation), &narrow(&p)).unwrap();
            let run =
                integrate(rhs, (0.0, 2.0), &narrow(&start), &options(Method::Taylor, tolerance), &mut []).unwrap();
            let error = run.y_end.iter().zip(&reference.y_end).map(|(a, b)| (a - b.to_f64()).abs()).fold(0.0, f64::max);
            assert!(error < 2000.0 * tolerance, "{formulation} {tolerance:e}: {error:e}, {run}");
        }
    }
}
