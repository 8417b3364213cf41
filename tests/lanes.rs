//! Every compiled formulation in lanes computes what it computes in doubles.

use crate::support;

use support::Random;
use tripos_traits::{CompiledSystem, InLanes, Integrands, Lanes, Lengths, Rates, Series, System};

/// The derivative at these states, one in each lane.
fn rates<const N: usize>(
    equations: &(dyn Rates<Lanes<N>> + Sync),
    Lengths { parameters, coordinates, variables: speeds, .. }: Lengths,
    states: &[Vec<f64>],
) -> Vec<Vec<f64>> {
    let of = |i: usize| Lanes::<N>(std::array::from_fn(|l| states[l][i]));
    let (all, n) = ((0..states[0].len()).map(of).collect::<Vec<_>>(), coordinates + speeds);
    let (p, y) = all.split_at(parameters);
    let mut out = vec![Lanes([0.0; N]); n];
    let (q_dot, v_dot) = out.split_at_mut(coordinates);
    equations.rates(p, &y[..coordinates], &y[coordinates..], q_dot, v_dot);
    (0..N).map(|l| out.iter().map(|x| x.0[l]).collect()).collect()
}

/// Goal: one text, one meaning. Method: derivatives at random states, in doubles and in both widths, which agree to the
/// bit. In doubles products are not fused, and sines round otherwise: 1e-9 of the largest rate, since states at which
/// cos q2 is near 0.01 lose up to six digits.
/// Long functions have no width of eight, and are not tried.
fn agrees(name: &str, system: &CompiledSystem, InLanes { four, eight, .. }: InLanes<'_>) -> bool {
    let Some(eight) = eight else { return false };
    let lengths = four.lengths();
    assert_eq!(lengths, eight.lengths());
    let (np, nq, nv) = (lengths.parameters, lengths.coordinates, lengths.variables);
    let mut random = Random(3);
    for _ in 0..100 {
        let mut state = || -> Vec<f64> {
            let p = (0..np).map(|_| random.between(0.1, 10.0)).collect::<Vec<_>>();
            let y = (0..nq + nv).map(|_| random.between(0.1, 1.4)).collect::<Vec<_>>();
            [p, y].concat()
        };
        let states: Vec<Vec<f64>> = (0..8).map(|_| state()).collect();
        let wide = rates::<8>(eight, lengths, &states);
        let narrow = [rates::<4>(four, lengths, &states[..4]), rates::<4>(four, lengths, &states[4..])].concat();
        for ((state, wide), narrow) in states.iter().zip(wide).zip(narrow) {
            let bits = |values: &[f64]| values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            assert_eq!(bits(&wide), bits(&narrow), "{name}");
            let (p, y) = state.split_at(np);
            let mut double = vec![0.0; nq + nv];
            let (q_dot, v_dot) = double.split_at_mut(nq);
            system.double.derivative(p, &y[..nq], &y[nq..], q_dot, v_dot);
            let scale = double.iter().fold(1.0, |m: f64, x| m.max(x.abs()));
            for (found, expected) in wide.iter().zip(&double) {
                assert!((found - expected).abs() <= 1e-9 * scale, "{name}: {wide:?} is not {double:?}");
            }
        }
    }
    true
}

#[test]
fn compiled_formulations_are_the_same_in_lanes() {
    let mut tried = 0;
    for model in tripos_models::MODELS {
        for system in model.systems {
            assert_eq!(system.lanes.is_some(), system.double.has_accelerations(), "{} {}", model.name, system.name);
            if let Some(lanes) = system.lanes {
                tried += usize::from(agrees(&format!("{} {}", model.name, system.name), system, lanes));
            }
        }
    }
    assert!(tried >= 50, "{tried}");
}

/// Goal: the recurrences in lanes are those in doubles. Method: coefficients up to order 9 at random states, one in
/// each lane, to 1e-9 of the largest of their order, as rates agree; products are fused in lanes alone.
fn series_agree(name: &str, system: &CompiledSystem, series: &(dyn Series<Lanes<4>> + Sync)) {
    const ORDER: usize = 9;
    let Lengths { parameters: np, .. } = system.double.lengths();
    let n = system.double.lengths().state();
    let mut random = Random(5);
    for _ in 0..20 {
        let mut state = || -> Vec<f64> {
            let p = (0..np).map(|_| random.between(0.5, 2.0)).collect::<Vec<_>>();
            [p, (0..n).map(|_| random.between(0.4, 1.1)).collect()].concat()
        };
        let states: Vec<Vec<f64>> = (0..4).map(|_| state()).collect();
        let of = |i: usize| Lanes::<4>(std::array::from_fn(|l| states[l][i]));
        let p: Vec<Lanes<4>> = (0..np).map(of).collect();
        let mut x = (np..np + n).map(of).collect::<Vec<_>>().repeat(ORDER + 1);
        series.taylor(&p, ORDER, &mut x, &mut vec![Lanes([0.0; 4]); series.taylor_work(ORDER)]);
        for (l, state) in states.iter().enumerate() {
            let mut alone = state[np..].repeat(ORDER + 1);
            system.double.taylor(&state[..np], ORDER, &mut alone, &mut vec![0.0; system.double.taylor_work(ORDER)]);
            for (order, (found, expected)) in x.chunks(n).zip(alone.chunks(n)).enumerate() {
                let scale = expected.iter().fold(1.0, |m: f64, x| m.max(x.abs()));
                let near = |(a, b): (&Lanes<4>, &f64)| (a.0[l] - b).abs() <= 1e-9 * scale;
                assert!(found.iter().zip(expected).all(near), "{name}, order {order}: {found:?} {expected:?}");
            }
        }
    }
}

#[test]
fn compiled_recurrences_are_the_same_in_lanes() {
    let mut tried = 0;
    for model in tripos_models::MODELS {
        for system in model.systems {
            if let Some(series) = system.lanes.and_then(|lanes| lanes.series) {
                series_agree(&format!("{} {}", model.name, system.name), system, series);
                tried += 1;
            }
        }
    }
    assert!(tried >= 8, "{tried}");
}

/// Integrands of quadrature, at a value of the coordinate in each lane: V[a, b], then T and q̇ at b, in one list.
fn at_points<const N: usize>(
    integrands: &dyn Integrands<Lanes<N>>,
    p: &[f64],
    q: &[f64],
    ends: &[[f64; 2]],
) -> Vec<Lanes<N>> {
    let all = |values: &[f64]| values.iter().map(|x| Lanes([*x; N])).collect::<Vec<_>>();
    let (p, mut q, mut rates) = (all(p), all(q), all(q));
    let [a, b] = [0, 1].map(|end| Lanes::<N>(std::array::from_fn(|l| ends[l][end])));
    q[0] = b;
    let v = Lanes(std::array::from_fn(|l| 0.5 + ends[l][0]));
    integrands.coordinate_rates(&p, &q, v, &mut rates);
    [vec![integrands.potential_slope(&p, a, b), integrands.kinetic_energy(&p, &q, v)], rates].concat()
}

/// Goal: quadrature at several points at once has the values of one point at a time. Method: divided differences of V,
/// T and q̇ of every scene at random places, also with both ends equal, in doubles and in both widths, which agree to
/// the bit; 1e-12 of the largest of each.
fn integrands_agree(name: &str, system: &dyn System<f64>) -> bool {
    let Some(points) = system.at_points() else { return false };
    let Lengths { parameters, coordinates, .. } = system.lengths();
    let mut random = Random(11);
    for round in 0..50 {
        let mut draw = |n: usize| (0..n).map(|_| random.between(0.3, 1.2)).collect::<Vec<f64>>();
        let (p, mut q, places) = (draw(parameters), draw(coordinates), draw(16));
        let ends: Vec<[f64; 2]> = (0..8).map(|l| [places[l], places[if round == 0 { l } else { l + 8 }]]).collect();
        let wide = at_points::<8>(points.eight, &p, &q, &ends);
        let narrow = [&ends[..4], &ends[4..]].map(|ends| at_points::<4>(points.four, &p, &q, ends));
        for (l, [a, b]) in ends.iter().enumerate() {
            q[0] = *b;
            let (v, mut rates) = ([0.5 + a], q.clone());
            system.coordinate_rates(&p, &q, &v, &mut rates);
            let alone = [vec![system.potential_slope(&p, *a, *b), system.kinetic_energy(&p, &q, &v)], rates].concat();
            for (at, expected) in alone.iter().enumerate() {
                let found = wide[at].0[l];
                assert_eq!(found.to_bits(), narrow[l / 4][at].0[l % 4].to_bits(), "{name}, value {at}");
                assert!(
                    (found - expected).abs() <= 1e-12 * expected.abs().max(1.0),
                    "{name}, value {at}: {found} {expected}"
                );
            }
        }
    }
    true
}

#[test]
fn integrands_of_scenes_are_the_same_at_several_points_at_once() {
    let scenes =
        tripos_models::MODELS.iter().flat_map(|model| model.scenes.iter().map(move |scene| (model.name, scene)));
    let tried =
        scenes.filter(|(model, scene)| integrands_agree(&format!("{model} {}", scene.name), scene.system.double));
    assert!(tried.count() >= 10);
}

/// Goal: a row of an array is the value of its state. Method: every function of every library model, by each
/// formulation, at 21 random states: bit by bit where the equations are interpreted, and up to rounding where they are
/// compiled.
#[test]
fn functions_of_arrays_are_those_of_each_state() {
    use tripos::code::{Code, CodePreparation, runnable_code};
    use tripos::equations_name::find_equations;
    use tripos::state_arrays::{Rows, StateFunction, StateRows, evaluate_states};
    let mut random = Random(11);
    let mut tried = 0;
    for model in tripos_models::MODELS {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(model.name).join("model.toml");
        let mechanism = tripos::Mechanism::read(&path).unwrap();
        for compiled in model.systems.iter().filter(|system| !system.name.contains(['@', ':'])) {
            let by = find_equations(&mechanism, &compiled.name.into()).unwrap();
            // The mechanism has no compiled equations: they are interpreted.
            let interpreted = runnable_code(&mechanism, &by, None, CodePreparation::Solved).unwrap();
            let codes = [Code::Compiled(compiled), interpreted];
            for code in codes {
                let lengths = code.system().lengths();
                let mut numbers = |count: usize| (0..count).map(|_| random.between(0.1, 1.4)).collect::<Vec<f64>>();
                let p = numbers(lengths.parameters);
                let (q, v) = (numbers(21 * lengths.coordinates), numbers(21 * lengths.variables));
                let v_dot = numbers(21 * lengths.variables);
                for function in StateFunction::ALL {
                    let Some(shape) = function.shape(&code) else { continue };
                    let width = shape.count();
                    let accelerations = if function.takes_accelerations() { lengths.variables } else { 0 };
                    let rows = |from: usize, count: usize| StateRows {
                        count,
                        q: Rows::each(
                            &q[from * lengths.coordinates..][..count * lengths.coordinates],
                            lengths.coordinates,
                        ),
                        v: Rows::each(&v[from * lengths.variables..][..count * lengths.variables], lengths.variables),
                        v_dot: Rows::each(&v_dot[from * accelerations..][..count * accelerations], accelerations),
                    };
                    let mut all = vec![0.0; 21 * width];
                    evaluate_states(function, &code, &p, rows(0, 21), &mut all);
                    for state in 0..21 {
                        let mut one = vec![0.0; width];
                        evaluate_states(function, &code, &p, rows(state, 1), &mut one);
                        let scale = one.iter().fold(1.0, |m: f64, x| m.max(x.abs()));
                        for (one, many) in one.iter().zip(&all[state * width..]) {
                            let is_same = one.to_bits() == many.to_bits() || one.is_nan() && many.is_nan();
                            let is_near = code.is_compiled() && (one - many).abs() <= 1e-9 * scale;
                            assert!(is_same || is_near, "{} {} {function:?}: {one} {many}", model.name, compiled.name);
                        }
                    }
                    tried += 1;
                }
            }
        }
    }
    assert!(tried > 1000, "{tried} functions were tried");
}
