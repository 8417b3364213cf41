//! A disc that rolls: fewer speeds than coordinates, through derivation, code generation and a run.
//!
//! Truth: K03 of the reference cases (SymPy's `KanesMethod` and an engine of high precision), and its closed form
//! u̇₁ = (6 u₂ u₃ r − u₃² r tan q₂ + 4 g sin q₂)/(5 r), u̇₂ = −2 u₁ u₃/3, u̇₃ = u₁ (u₃ tan q₂ − 2 u₂).

use tripos::{AccelerationSolution, Mechanism, Overrides, Scene};
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::{Derivation, SolvedAccelerations, derive, derive_all};
use tripos_derive::prove::prove;
use tripos_derive::{Formulation, Model};
use tripos_sim::{Method, Options, OutputOption, integrate};
use tripos_traits::Real;

const DISC: &str = include_str!("../models/rolling_disc/model.toml");

fn rolling() -> Model {
    load(DISC).unwrap_or_else(|e| panic!("{e}"))
}

fn load(text: &str) -> Result<Model, String> {
    tripos_derive::model::load(&Source::from_text("disc.toml", text)).map_err(|e| e.to_string())
}

/// A state, and what is known of it.
struct Known {
    /// q₁ q₂ q₃; where the disc is does not matter.
    q: [f64; 3],
    u: [f64; 3],
    u_dot: [f64; 3],
    /// With x′ and y′.
    q_dot: [f64; 5],
    kinetic: f64,
    potential: f64,
}

const STATES: [Known; 3] = [
    Known {
        q: [0.958, -0.087, 0.438],
        u: [1.409, -1.711, -2.532],
        u_dot: [3.110_810_698_252_991_7, 2.378_392, 5.132_763_623_300_128],
        q_dot: [
            -2.541_612_667_655_314_4,
            1.409,
            -1.931_841_464_371_985_5,
            -0.344_444_896_145_077_1,
            -0.489_902_044_532_145_1,
        ],
        kinetic: 0.977_410_660_65,
        potential: 7.271_035_714_914_143,
    },
    Known {
        q: [0.205, -0.756, -0.236],
        u: [2.338, 2.233, -2.288],
        u_dot: [-22.511_038_494_776_15, 3.566_229_333_333_333_3, -5.397_789_014_596_046],
        q_dot: [
            -3.144_645_917_269_301,
            2.338,
            0.075_720_707_697_196_47,
            0.022_981_909_094_224_56,
            0.004_778_417_317_688_425,
        ],
        kinetic: 1.801_410_779_34,
        potential: 5.310_387_483_784_206,
    },
    Known {
        q: [-0.836, -0.555, 0.656],
        u: [-2.852, -1.649, -2.357],
        u_dot: [-7.987_250_732_436_587, -4.481_442_666_666_666, -13.573_677_442_192_484],
        q_dot: [
            -2.773_266_006_606_239,
            -2.852,
            -3.110_353_941_862_722,
            -0.646_440_958_032_567_1,
            0.715_412_102_031_938_3,
        ],
        kinetic: 1.803_033_245_25,
        potential: 6.203_117_349_371_003,
    },
];

/// Goal: three derivations of the rolling motion. Method: u̇, q̇, T and V at the states of K03 satisfy what each gives.
#[test]
fn every_formulation_rolls() {
    let model = rolling();
    assert_eq!((model.coordinates.len(), model.speeds.len(), model.motion_constraints.len()), (5, 3, 2));
    assert!(
        model.counts_in_words().contains("5 generalized coordinates, 2 nonholonomic constraints, 3 generalized speeds")
    );
    for formulation in Formulation::ALL {
        let Derivation { mut arena, equations } = derive(&model, formulation).unwrap();
        let solved = SolvedAccelerations::new(&mut arena, &equations).unwrap().accelerations;
        let inputs = [model.p(), model.q(), equations.variables.clone()].concat();
        let v_dot = &equations.unknowns[..equations.variables.len()];
        let energies = vec![equations.kinetic_energy, equations.potential_energy];
        let values = [v_dot, &equations.coordinate_rates, &energies].concat();
        let tape = Tape::stepwise(&arena, &inputs, &solved.steps, &values).unwrap();
        let inputs = [inputs, v_dot.to_vec()].concat();
        let u_dot_of = Tape::new(&arena, &inputs, &equations.generalized_speed_rates).unwrap();
        for Known { q, u, u_dot, q_dot, kinetic, potential } in STATES {
            let v = if formulation.is_in_rates() { &q_dot[..] } else { &u[..] };
            let at = [&[0.31, 2.4, 9.81], q.as_slice(), &[0.3, -0.2], v].concat();
            let found = tape.evaluate(&at);
            let (v_dot, rest) = found.split_at(v.len());
            for (found, expected) in u_dot_of.evaluate(&[&at, v_dot].concat()).iter().zip(u_dot) {
                close("u'", *found, expected, 1e-12);
            }
            for (found, expected) in rest.iter().zip(q_dot.into_iter().chain([kinetic, potential])) {
                close("q', T or V", *found, expected, 1e-12);
            }
        }
    }
}

/// Goal: the multipliers are the friction. Method: the rows of x and y, in which they stand alone, against the engine's
/// own multipliers of K03's first state.
#[test]
fn multipliers_are_the_forces_of_the_constraints() {
    let model = rolling();
    let Derivation { mut arena, equations } = derive(&model, Formulation::Lagrange).unwrap();
    let solved = SolvedAccelerations::new(&mut arena, &equations).unwrap().accelerations;
    let inputs = [model.p(), model.q(), model.q_dot()].concat();
    let n = model.coordinates.len();
    let rows: Vec<_> =
        [3, 4].into_iter().flat_map(|i| [&equations.matrix[i][..], &equations.forcing[i..=i]].concat()).collect();
    let values = [&equations.unknowns[..n], &rows].concat();
    let tape = Tape::stepwise(&arena, &inputs, &solved.steps, &values).unwrap();
    let Known { q, q_dot, .. } = &STATES[0];
    let found = tape.evaluate(&[&[0.31, 2.4, 9.81], q.as_slice(), &[0.3, -0.2], q_dot].concat());
    let (rates, rows) = found.split_at(n);
    let expected = [-1.164_457_840_739_669_7, -0.262_841_338_394_531_17];
    for (at, (row, expected)) in rows.chunks(n + 3).zip(expected).enumerate() {
        assert_eq!((row[n + at], row[n + 1 - at]), (-1.0, 0.0));
        let left: f64 = row[..n].iter().zip(rates).map(|(a, x)| a * x).sum();
        close("a multiplier", left - row[n + 2], expected, 1e-12);
    }
}

/// Goal: first integrals of a sliding disc are not claimed of a rolling one. Method: proofs of both, from one file by
/// its rolling.
#[test]
fn a_rolling_disc_keeps_its_energy_alone() {
    let integrals = |model: &Model| {
        let mut derivations = derive_all(model).unwrap();
        let proof = prove(model, &mut derivations);
        assert!(proof.is_equivalent() && proof.pairs.len() == 3 && proof.pairs.iter().all(|p| p.verdict.is_equal()));
        // Translations and turns are symmetries of its energies, and along each of them some friction works.
        assert!(
            model.motion_constraints.is_empty() || proof.search.covered.contains("of a constraint works: 0 of them"),
            "{}",
            proof.search.covered
        );
        proof.integrals.len()
    };
    assert_eq!(integrals(&rolling()), 1);
    let sliding = DISC
        .replace("u3 = \"q1'*cos(q2)\"", "u3 = \"q1'*cos(q2)\"\nu4 = \"x'\"\nu5 = \"y'\"")
        .replace("[rolling.ground]\nbody = \"disc\"\nat = \"C\"\nabout = \"the ground is rough enough\"\n", "");
    let friction = sliding.find("[reactions.friction_x]").unwrap()..sliding.find("[reactions.normal]").unwrap();
    let sliding = load(&sliding.replace(&sliding[friction], "")).unwrap();
    assert_eq!(sliding.motion_constraints.len(), 0);
    assert_eq!(integrals(&sliding), 6);
}

const ROLL: &str = "model = \"disc.toml\"\nspan = [0, 3]\n[start]\nq1 = 0.1\nq2 = 0.2\nq3 = 0\nx = 1\ny = -1\nu1 = 0.3\nu2 = 4\n\
                    u3 = -1.2\n[integration]\nmethod = \"dop853\"\nrtol = 1e-12\natol = 1e-12\n";

/// Goal: a run of the library is the rolling motion. Method: against the closed form, by every way to accelerations.
#[test]
fn a_run_is_the_rolling_motion() {
    let start = [0.1, 0.2, 0.0, 1.0, -1.0, 0.3, 4.0, -1.2];
    let how = Options { method: Method::Dop853, output: OutputOption::Ends, ..Options::tolerances(1e-13, 1e-13) };
    // The closed form, with the kinematic equations by hand.
    let by_hand = |_t: f64, y: &[f64], out: &mut [f64]| {
        let (r, g) = (0.31, 9.81);
        let ([q1, q2], [u1, u2, u3]) = ([y[0], y[1]], [y[5], y[6], y[7]]);
        let yaw = u3 / q2.cos();
        let spin = u2 - yaw * q2.sin();
        out[..5].copy_from_slice(&[yaw, u1, spin, r * spin * q1.cos(), r * spin * q1.sin()]);
        out[5] = (6.0 * u2 * u3 * r - u3 * u3 * r * q2.tan() + 4.0 * g * q2.sin()) / (5.0 * r);
        out[6] = -2.0 * u1 * u3 / 3.0;
        out[7] = u1 * (u3 * q2.tan() - 2.0 * u2);
        Ok(())
    };
    let truth = integrate(by_hand, (0.0, 3.0), &start, &how, &mut []).unwrap().y_end;
    let scene = Scene::parse(Mechanism::new(rolling()), ROLL).unwrap_or_else(|e| panic!("{e}"));
    let names = Formulation::ALL.map(|f| Some(f.name()));
    let solves = [None, Some(AccelerationSolution::Numeric)];
    let ways = names.into_iter().chain([None]).flat_map(|by| solves.map(|solve| (by, solve)));
    for (by, solve) in ways {
        let run = scene.simulate(&Overrides { by: by.map(Into::into), solve, ..Overrides::default() });
        let run = run.unwrap_or_else(|e| panic!("{by:?}: {e}"));
        assert!(run.failure().is_none(), "{:?}", run.objections());
        for (name, expected) in ["q1", "q2", "q3", "x", "y", "u1", "u2", "u3"].iter().zip(&truth) {
            let found = *run.column_of_quantity(name).unwrap().last().unwrap();
            close(&format!("{name} by {by:?}, {solve:?}"), found, *expected, 1e-9);
        }
        assert!(run.energy_drift.unwrap() < 1e-9, "{:?}", run.energy_drift);
    }
}

/// Goal: runs with fewer speeds than coordinates have a reference, too. Method: a tight run against it; its own two
/// runs are by Kane's method and by Lagrange's equations.
#[test]
fn a_reference_knows_the_rolling_motion() {
    let scene = Scene::parse(Mechanism::new(rolling()), ROLL).unwrap_or_else(|e| panic!("{e}"));
    let reference = scene.reference(&[3.0]).unwrap();
    assert!(reference.uncertainty < 1e-17 && reference.end().len() == 8, "{}", reference.uncertainty);
    let run = scene.simulate(&Overrides { by: Some("kane".into()), ..Overrides::default() }).unwrap();
    for (found, exact) in run.end.iter().zip(reference.end()) {
        close("the end", *found, exact.to_f64(), 1e-9);
    }
}

/// Goal: no run starts with a motion that the constraints forbid. Method: rates at which the disc slips, and those at
/// which it rolls.
#[test]
fn a_start_with_rates_that_slip_is_refused() {
    let start = |x_dot: f64| {
        let rates =
            format!("\"q1'\" = 0\n\"q2'\" = 0\n\"q3'\" = 2\n\"x'\" = {x_dot}\n\"y'\" = {}\n", 0.62 * 0.1_f64.sin());
        let text = ROLL.replace("u1 = 0.3\nu2 = 4\nu3 = -1.2\n", &rates);
        Scene::parse(Mechanism::new(rolling()), &text)
    };
    let refused = start(1.0).err().unwrap().to_string();
    assert!(refused.contains("ground_1"), "{refused}");
    if let Err(refused) = start(0.62 * 0.1_f64.cos()) {
        panic!("{refused}");
    }
}

fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance * expected.abs().max(1.0), "{what}: {found}, expected {expected}");
}
