//! Equilibria, steady motions and linear systems near them.
//!
//! Truth: J. P. Meijaard, J. M. Papadopoulos, A. Ruina & A. L. Schwab, Proc. R. Soc. A 463 (2007) 1955-1982, recomputed
//! with more digits than printed; closed forms.

use std::path::Path;
use tripos::Mechanism;
use tripos::studies::steady::{
    Continuation, CrossingKind, LinearisationOptions, Stability, SteadyLinearSystem, SymbolicEntry,
    continue_steady_motion, find_equilibria, linearise, symbolic_linear_system,
};
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::{StateWithUnknowns, load_state_with_unknowns};

fn read(model: &str) -> Mechanism {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(model).join("model.toml");
    Mechanism::read(&path).unwrap_or_else(|e| panic!("{e}"))
}

fn loaded(model: &mut Mechanism, state: &str, given: &[(&str, f64)]) -> StateWithUnknowns {
    let given: Vec<(String, f64)> = given.iter().map(|(name, x)| ((*name).to_owned(), *x)).collect();
    load_state_with_unknowns(&Source::from_text("state.toml", state), model, &given).unwrap_or_else(|e| panic!("{e}"))
}

fn about(model: &str, state: &str, given: &[(&str, f64)]) -> SteadyLinearSystem {
    let mut model = read(model);
    let asked = loaded(&mut model, state, given);
    linearise(&model, &asked, &LinearisationOptions::default()).unwrap_or_else(|e| panic!("{e}"))
}

fn over(model: &str, state: &str, name: &str, values: &[f64]) -> Continuation {
    let mut model = read(model);
    let of = model.clone();
    continue_steady_motion(&of, &mut |value| Ok(loaded(&mut model, state, &[(name, value)])), values)
        .unwrap_or_else(|e| panic!("{e}"))
}

fn values(found: &SteadyLinearSystem) -> Vec<[f64; 2]> {
    found.modes.iter().map(|mode| mode.value).collect()
}

/// Checks that each of these is among the eigenvalues.
fn are_among(found: &SteadyLinearSystem, wanted: &[[f64; 2]], tolerance: f64) {
    let all = values(found);
    for [re, im] in wanted {
        let off = all.iter().map(|[a, b]| (a - re).hypot(b - im)).fold(f64::INFINITY, f64::min);
        assert!(off <= tolerance * re.hypot(*im).max(1.0), "{re} {im}: off by {off:e} in {all:?}");
    }
}

const BICYCLE: &str = include_str!("../../models/whipple_bicycle/steady/v5.toml");

/// Goal: a nonholonomic mechanism with a loop is linearised about a steady motion as published. Method: the four
/// eigenvalues of lean and steer from 1 to 10 m/s, and the eigenvalue 0 of the family of speeds.
#[test]
fn eigenvalues_of_the_bicycle_are_the_published_ones() {
    type Row = (f64, [[f64; 2]; 4]);
    let table: [Row; 4] = [
        (
            1.0,
            [
                [-7.110_080_146_374_408, 0.0],
                [-3.134_231_250_665_784, 0.0],
                [3.526_961_709_900_694_2, 0.807_740_275_199_310_1],
                [3.526_961_709_900_694_2, -0.807_740_275_199_310_1],
            ],
        ),
        (
            4.0,
            [
                [-12.158_614_265_764_44, 0.0],
                [-1.429_444_273_613_257_5, 0.0],
                [0.413_253_315_211_241_3, 3.079_108_186_032_053_6],
                [0.413_253_315_211_241_3, -3.079_108_186_032_053_6],
            ],
        ),
        (
            5.0,
            [
                [-14.078_389_692_798_247, 0.0],
                [-0.322_866_429_004_087_1, 0.0],
                [-0.775_341_882_195_841_9, 4.464_867_713_788_225],
                [-0.775_341_882_195_841_9, -4.464_867_713_788_225],
            ],
        ),
        (
            10.0,
            [
                [-24.624_596_350_174, 0.0],
                [0.161_053_386_531_715_54, 0.0],
                [-3.720_168_404_372_875_7, 10.906_811_394_762_882],
                [-3.720_168_404_372_875_7, -10.906_811_394_762_882],
            ],
        ),
    ];
    for (v, expected) in table {
        let found = about("whipple_bicycle", BICYCLE, &[("v", v)]);
        are_among(&found, &expected, 1e-14);
        assert!(values(&found).contains(&[0.0, 0.0]), "{:?}", values(&found));
        assert!(found.steady.residual < 1e-28, "{:e}", found.steady.residual);
        assert_eq!(found.family, ["u3"]);
        let grows = expected.iter().any(|[re, _]| *re > 0.0);
        assert_eq!(found.stability, if grows { Stability::Unstable } else { Stability::AttractingInFamily });
        let forward = found.moves.iter().find(|(along, _)| along == "a shift of x").map(|(_, rate)| *rate);
        assert!((forward.unwrap() - v).abs() < 1e-15 * v, "{:?}", found.moves);
    }
}

/// Goal: the choice of dependent speeds changes no eigenvalue. Method: the heading's, or the front wheel's, in place of
/// the rear wheel's: another description of the same steady motion.
#[test]
fn eigenvalues_do_not_depend_on_the_choice_of_speeds() {
    let text = include_str!("../../models/whipple_bicycle/model.toml");
    let model = text.replace("u3 = \"thR'\"", "u3 = \"thF'\"");
    let source = Source::from_text("model.toml", &model);
    let mut model = Mechanism::new(tripos_derive::model::load(&source).unwrap_or_else(|e| panic!("{e}")));
    let state = loaded(&mut model, &BICYCLE.replace("-v/rR", "-v/rF"), &[]);
    let found = linearise(&model, &state, &LinearisationOptions::default()).unwrap_or_else(|e| panic!("{e}"));
    let complex = [-0.775_341_882_195_841_9, 4.464_867_713_788_225];
    are_among(&found, &[complex, [-0.322_866_429_004_087_1, 0.0], [-14.078_389_692_798_247, 0.0]], 1e-14);
}

/// Goal: the linear equations hold for every speed. Method: with v as a letter, A is polynomial in v, as published:
/// constants and squares for lean and steer, multiples of v for their rates. At 7 m/s it equals the numeric one.
#[test]
fn the_bicycle_is_linearised_with_its_speed_as_a_letter() {
    let mut model = read("whipple_bicycle");
    let state = loaded(&mut model, BICYCLE, &[]);
    let found = linearise(&model, &state, &LinearisationOptions::default()).unwrap_or_else(|e| panic!("{e}"));
    let letters = symbolic_linear_system(&model, &state, &found, &["v".to_owned()]).unwrap_or_else(|e| panic!("{e}"));
    let numeric = about("whipple_bicycle", BICYCLE, &[("v", 7.0)]).system.a.doubles();
    for (row, of) in letters.matrices[0].iter().zip(&numeric) {
        for (entry, expected) in row.iter().zip(of) {
            let SymbolicEntry::Polynomial(c) = entry else { panic!("{entry:?}") };
            let value = c.iter().rev().fold(0.0, |sum, c| 7.0 * sum + c);
            assert!((value - expected).abs() < 1e-13 * expected.abs().max(1.0), "{entry:?} {expected}");
        }
    }
    let powers = |row: usize, column: usize| {
        let SymbolicEntry::Polynomial(c) = &letters.matrices[0][row][column] else { panic!("a formula") };
        c.iter().enumerate().filter(|(_, c)| c.abs() > 0.0).map(|(power, _)| power).collect::<Vec<_>>()
    };
    assert_eq!((powers(2, 0), powers(2, 1), powers(3, 2), powers(3, 3)), (vec![0], vec![0, 2], vec![1], vec![1]));
}

/// Goal: speeds at which stability changes are found to all their digits. Method: the published weave and capsize
/// speeds.
#[test]
fn weave_and_capsize_speeds_are_found() {
    let course = over("whipple_bicycle", BICYCLE, "v", &[3.0, 4.0, 5.0, 6.0, 7.0]);
    let [weave, capsize] = course.crossings.as_slice() else { panic!("{:?}", course.crossings) };
    assert_eq!((weave.kind, capsize.kind), (CrossingKind::Pair, CrossingKind::Real));
    assert!((weave.value - 4.292_382_536_341_104).abs() < 1e-14, "{}", weave.value);
    assert!((weave.frequency - 3.435_033_848_661_436).abs() < 1e-11, "{}", weave.frequency);
    assert!((capsize.value - 6.024_262_015_388_359).abs() < 1e-12, "{}", capsize.value);
}

fn disc(lean: &str, u: [&str; 3], guess: &str) -> String {
    let [u1, u2, u3] = u.map(|u| if u.is_empty() { String::new() } else { u.to_owned() });
    format!(
        "[parameters]\nr = 0.31\ng = 9.81\n[state]\nq1 = 0\nq3 = 0\nx = 0.3\ny = -0.2\n{lean}\n{u1}\n{u2}\n{u3}\n{guess}\n"
    )
}

/// Goal: limits of a rolling disc are found from its model. Method: closed forms. Rolling straight it is stable above a
/// spin of sqrt(g/(3 r)). A steady turn is found from a rough guess, with its rate of growth.
#[test]
fn a_rolling_disc_turns_and_falls_as_in_closed_form() {
    let straight = disc("q2 = 0", ["u1 = 0", "u2 = 3", "u3 = 0"], "");
    let course = over("rolling_disc", &straight, "u2", &[2.0, 3.0, 4.0]);
    assert!(
        course.crossings.iter().any(|c| (c.value - 3.247_828_058_375_965_4).abs() < 1e-11),
        "{:?}",
        course.crossings
    );
    let rough = disc("q2 = 0.25", ["u1 = 0", "", "u3 = \"2*cos(0.25)\""], "[guess]\nu2 = -1");
    let turn = about("rolling_disc", &rough, &[]);
    let (lean, u2) = (turn.steady.x[1].hi(), turn.steady.x[6].hi());
    assert!((lean - 0.25).abs() < 1e-16 && (u2 + 2.610_977_440_655_337).abs() < 1e-13, "{lean} {u2}");
    let growth = 1.681_893_544_635_91_f64.sqrt();
    are_among(&turn, &[[growth, 0.0], [-growth, 0.0]], 1e-12);
    assert_eq!((turn.stability, turn.family.len()), (Stability::Unstable, 2));
}

/// Goal: all rest positions are found, and the stable ones are marked. Method: a pendulum hangs or stands.
#[test]
fn a_pendulum_hangs_or_stands() {
    let mut model = read("pendulum");
    let names: Vec<String> = model.coordinates.iter().map(|c| c.name.clone()).collect();
    let speeds: Vec<String> = model.speeds.iter().map(|s| s.name.clone()).collect();
    let text = format!("[state]\n{} = 0\n[guess]\n{} = 0.3\n", speeds[0], names[0]);
    let state = loaded(&mut model, &text, &[]);
    let found = find_equilibria(&model, &state, 12).unwrap_or_else(|e| panic!("{e}"));
    let told: Vec<(f64, Stability)> = found
        .iter()
        .map(|f| (f.steady.x[0].hi().cos(), f.about.as_ref().unwrap_or_else(|e| panic!("{e}")).stability))
        .collect();
    println!("{told:?}");
    assert_eq!(found.len(), 2);
    assert!(told.contains(&(1.0, Stability::Energy)) && told.contains(&(-1.0, Stability::Unstable)), "{told:?}");
}

/// Goal: a state that is no equilibrium is refused with the unbalanced force. Method: a pendulum held aside.
#[test]
fn what_is_not_balanced_is_said() {
    let mut model = read("pendulum");
    let (q, u) = (model.coordinates[0].name.clone(), model.speeds[0].name.clone());
    let state = loaded(&mut model, &format!("[state]\n{q} = 0.5\n{u} = 0\n"), &[]);
    let error =
        linearise(&model, &state, &LinearisationOptions::default()).err().map(|e| e.to_string()).unwrap_or_default();
    assert!(error.contains("not an equilibrium") && error.contains(&format!("{u}'")), "{error}");
    let as_is = LinearisationOptions { as_is: true, ..LinearisationOptions::default() };
    assert!(linearise(&model, &state, &as_is).is_ok());
}

/// Goal: limits of a sliding disc and its steady turns. Method: closed forms for M = R = 1. Upright it spins in place
/// stably above n² = g/R, and turns about its diameter stably above Ω² = 4 g/R. Leaning by θ it turns about the
/// vertical through its mass centre with A Ω² sin θ cos θ − C n Ω cos θ = M g R sin θ (signs of n as in the model).
#[test]
fn the_sliding_disk_has_its_limits_and_its_steady_turns() {
    let text = |rates: &str, guess: &str| {
        format!(
            "[parameters]\nM = 1\nR = 1\ng = 9.81\n[state]\nq1 = 0.2\nq3 = 0\nq4 = 0.4\nq5 = -0.3\n{rates}\n{guess}"
        )
    };
    let spinning = text("q2 = 0\nu1 = 0\nu2 = 0\nu3 = 3\nu4 = 0\nu5 = 0", "");
    let turning = text("q2 = 0\nu1 = 0\nu2 = 6\nu3 = 0\nu4 = 0\nu5 = 0", "");
    for (start, name, values, limit) in
        [(spinning, "u3", [2.0, 3.0, 4.0], 9.81_f64.sqrt()), (turning, "u2", [5.0, 6.0, 7.0], 39.24_f64.sqrt())]
    {
        let course = over("disk", &start, name, &values);
        assert!(course.crossings.iter().any(|c| (c.value - limit).abs() < 1e-11), "{:?} {limit}", course.crossings);
    }
    // The disc leans with its mass centre at rest; the contact point goes around below it.
    let (theta, turn) = (0.4_f64, 7.0_f64);
    let leaning =
        text(&format!("q2 = {theta}\nu1 = 0\nu2 = {:?}", turn * theta.cos()), "[guess]\nu3 = 1\nu4 = 0\nu5 = 0\n");
    let found = about("disk", &leaning, &[]);
    let n = found.steady.x[7].hi();
    let balance = 0.25 * turn * turn * theta.sin() * theta.cos() - 9.81 * theta.sin();
    let expected = balance / (0.5 * turn * theta.cos());
    assert!((n.abs() - expected.abs()).abs() < 1e-13, "{n} {expected}");
    assert!(found.steady.is_steady() && !found.steady.is_rest());
}

/// Goal: a sleeping top stays up if it spins fast enough, and wakes at the right rate. Method: I₃² ω₃² = 4 m g l I₁; s
/// = i (I₃ ω₃ ± sqrt(I₃² ω₃² − 4 m g l I₁))/(2 I₁) in a frame that does not turn, whose real part is the rate of growth
/// below the threshold.
#[test]
fn a_sleeping_top_wakes_below_its_threshold() {
    let state = "[state]\nq1 = 0\nq2 = 0\nq3 = 0\nu1 = 0\nu2 = 0\nu3 = 55\n";
    let (four, i3, i1) = (4.0 * 1.3 * 9.81 * 0.22 * 0.095, 0.021, 0.095);
    let limit = f64::sqrt(four) / i3;
    let course = over("heavy_top", state, "u3", &[40.0, 45.0, 50.0, 55.0]);
    assert!(course.crossings.iter().any(|c| (c.value - limit).abs() < 1e-10), "{:?} {limit}", course.crossings);
    for spin in [40.0, 55.0] {
        let found = about("heavy_top", state, &[("u3", spin)]);
        let inside = i3 * i3 * spin * spin - four;
        let (turn, root) = (i3 * spin / (2.0 * i1), inside.abs().sqrt() / (2.0 * i1));
        let expected =
            if inside < 0.0 { [[root, turn], [-root, turn]] } else { [[0.0, turn + root], [0.0, turn - root]] };
        are_among(&found, &expected, 1e-13);
    }
}

/// Goal: inputs, outputs and the reachable directions are those of the textbook. Method: a pendulum on a cart pushed by
/// a force.
#[test]
fn a_cart_with_a_pendulum_is_controlled_by_its_force() {
    let mut model = read("cart_pendulum_3");
    let names = model.coordinates.iter().map(|c| &c.name).chain(model.speeds.iter().map(|s| &s.name));
    let zeros: Vec<String> = names.map(|name| format!("{name} = 0")).collect();
    let state = loaded(&mut model, &format!("[state]\n{}\n", zeros.join("\n")), &[("F", 0.0)]);
    let wanted = LinearisationOptions { inputs: vec!["F".to_owned()], ..LinearisationOptions::default() };
    let found = linearise(&model, &state, &wanted).unwrap_or_else(|e| panic!("{e}"));
    let n = found.system.kept.len();
    assert_eq!((found.controllable, found.system.b.rows.len()), (n, n), "{:?}", found.system.kept);
}

/// Goal: the closure of loops follows the inputs on which it depends. Method: a bob hangs in Cartesian coordinates on a
/// rod whose length is the input. It hangs lower by as much as the rod is longer, in numbers and with g kept as a
/// letter, and swings as before.
#[test]
fn what_closes_loops_follows_inputs() {
    let mut model = read("cartesian_pendulum");
    let state = loaded(&mut model, "outputs = [\"y\"]\n[state]\nx = 0\ny = \"-l\"\nv = 0\n", &[]);
    let wanted = LinearisationOptions { inputs: vec!["l".to_owned()], ..LinearisationOptions::default() };
    let found = linearise(&model, &state, &wanted).unwrap_or_else(|e| panic!("{e}"));
    let [b, d] = [&found.system.b, &found.system.d].map(tripos::studies::steady::WideMatrix::doubles);
    assert_eq!((b, d), (vec![vec![0.0], vec![0.0]], vec![vec![-1.0]]));
    are_among(&found, &[[0.0, 9.81_f64.sqrt()]], 1e-14);
    let letters = symbolic_linear_system(&model, &state, &found, &["g".to_owned()]).unwrap_or_else(|e| panic!("{e}"));
    let SymbolicEntry::Polynomial(d) = &letters.matrices[3][0][0] else { panic!("{:?}", letters.matrices[3]) };
    assert_eq!((d.as_slice(), letters.matrices[1].iter().flatten().all(SymbolicEntry::is_zero)), (&[-1.0][..], true));
}

/// Goal: rest is found where loops close without a list of the unknowns, and a start of a scene serves as a guess.
/// Method: a four-bar hangs where its potential is least: a small turn either way raises it.
#[test]
fn a_linkage_that_swings_is_found_at_rest() {
    let mut model = read("four_bar");
    let scene = include_str!("../../models/four_bar/scenes/crossed.toml");
    let state = loaded(&mut model, scene, &[]);
    let found = find_equilibria(&model, &state, 8).unwrap_or_else(|e| panic!("{e}"));
    let told: Vec<Stability> = found.iter().filter_map(|f| f.about.as_ref().ok()).map(|a| a.stability).collect();
    assert!(told.contains(&Stability::Energy), "{told:?}");
    assert!(found.iter().all(|f| f.steady.residual < 1e-20 && f.steady.is_rest()));
}
