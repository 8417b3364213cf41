//! Gibbs–Appell equations: they come from the acceleration energy, and are those of the other formulations.

use crate::chain::chain;
use std::path::{Path, PathBuf};
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::calculus::{Differential, Gradient};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::geometry::Vector;
use tripos_derive::mechanics::{DeriveError, Kinematics, Stage, derive_all, derive_in_steps, kinematic_rates};
use tripos_derive::prove::prove;
use tripos_derive::{Formulation, Model, derive};

fn models() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models");
    let mut list: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path().join("model.toml")).collect();
    list.retain(|file| file.exists());
    list.sort();
    list
}

fn library(name: &str) -> Model {
    Model::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(name).join("model.toml")).unwrap()
}

/// Pairs that contain the Gibbs–Appell equations, each with its verdict in words.
fn verdicts(model: &Model) -> Vec<(Formulation, String)> {
    let mut all = derive_all(model).unwrap();
    all.add(model, Formulation::GibbsAppell).unwrap();
    let pairs = prove(model, &mut all).pairs;
    let own = pairs.into_iter().filter(|pair| pair.right == Formulation::GibbsAppell);
    own.map(|pair| (pair.left, if pair.verdict.is_equal() { String::new() } else { format!("{:?}", pair.verdict) }))
        .collect()
}

/// Goal: the formulation is right for closed forms and named terms, loops, nonholonomic constraints and given motions.
/// Method: proof of equivalence with every other formulation of every library model, and of a long chain.
#[test]
fn every_library_model_is_proved_equal() {
    let mut pairs = 0;
    for model in models().iter().map(|path| Model::read(path).unwrap()).chain([chain(12)]) {
        for (other, why) in verdicts(&model) {
            assert!(why.is_empty(), "{} by {}: {why}", model.title, other.name());
            pairs += 1;
        }
    }
    assert!(pairs > 70, "{pairs}");
}

/// Goal: the equations are the slopes of the acceleration energy. Method: an acceleration energy that shares nothing
/// with the derivation. The thin disk becomes five particles with its inertia, four on the rim and one in the middle,
/// whose positions are differentiated twice in the inertial frame; the weight adds −m g · a. One disk slides, the other
/// rolls.
#[test]
fn disks_move_as_their_particles_make_s_stationary() {
    for (name, radius, in_plane) in [("disk", "R", [0, 1]), ("rolling_disc", "r", [0, 2])] {
        let model = library(name);
        let mut kinematics = Kinematics::new(&model).unwrap();
        let body = &model.bodies[0];
        let (own, _) = body.rigid.as_ref().unwrap();
        let radius = model.parameters.iter().find(|p| p.name == radius).unwrap().symbol;
        let mut particles = vec![(1, 2, Vector::default())];
        for axis in in_plane {
            let mut arm = [Expr::ZERO; 3];
            arm[axis] = radius;
            let arm = Vector::in_frame(*own, arm);
            particles.extend([(1, 8, arm.neg(&mut kinematics.arena)), (1, 8, arm)]);
        }
        let mut along = kinematic_rates(&model);
        let mut terms = Vec::new();
        for (share, of, arm) in particles {
            let position = kinematics.positions[body.centre].add(&mut kinematics.arena, &arm);
            let Kinematics { arena, frames, .. } = &mut kinematics;
            let (share, half) = (arena.ratio(share, of), arena.ratio(1, 2));
            let mass = arena.mul(share, body.mass);
            let gravity = model.gravity.as_ref().unwrap();
            assert_eq!(gravity.frame, 0);
            for (p, g) in frames.express(arena, &position, 0).into_iter().zip(gravity.acceleration) {
                let v = along.apply(arena, p);
                let a = along.apply(arena, v);
                terms.push(arena.product(&[half, mass, a, a]));
                terms.push(arena.product(&[Expr::MINUS_ONE, mass, g, a]));
            }
        }
        let energy = kinematics.arena.sum(&terms);
        // The same symbols in both stores, so that terms can be subtracted.
        let again = Model { arena: kinematics.arena.clone(), ..model.clone() };
        let derivation = derive(&again, Formulation::GibbsAppell).unwrap();
        let (mut arena, e) = (derivation.arena, derivation.equations);
        let rates: Vec<Expr> = model.speeds.iter().map(|speed| speed.rate).collect();
        assert_eq!(e.unknowns, rates);
        let slopes = Gradient::new(&rates).apply(&mut arena, energy);
        for (r, (row, right)) in e.matrix.iter().zip(&e.forcing).enumerate() {
            let slope = slopes.iter().find(|(at, _)| *at == r).map_or(Expr::ZERO, |(_, slope)| *slope);
            let mut sum = vec![*right];
            sum.extend(row.iter().zip(&rates).map(|(entry, rate)| {
                let term = arena.mul(*entry, *rate);
                arena.neg(term)
            }));
            sum.push(slope);
            let difference = arena.sum(&sum);
            assert_eq!(zero_test(&arena, difference), ZeroTest::Zero, "{name}, row {r}");
        }
    }
}

/// Goal: S on the page is the function whose slopes the equations have. Method: ∂S/∂u̇ less the shown forces is
/// M u̇ − f, by meaning, in both forms.
#[test]
fn the_shown_energy_has_the_equations_as_slopes() {
    for name in ["disk", "rolling_disc", "gimbals", "four_bar", "whipple_bicycle"] {
        let model = library(name);
        let shown = derive_in_steps(&model, Formulation::GibbsAppell, None).unwrap();
        let (mut arena, e) = (shown.arena, shown.equations);
        let line = |wanted: &dyn Fn(Stage) -> bool| shown.steps.iter().find(|step| wanted(step.stage)).unwrap();
        let energy = line(&|stage| matches!(stage, Stage::Titled(_))).lines[0].1;
        let forces = line(&|stage| stage == Stage::ActiveForces);
        for (r, (row, right)) in e.matrix.iter().zip(&e.forcing).enumerate() {
            let slope = Differential::partial(e.unknowns[r]).apply(&mut arena, energy);
            let mut sum = vec![slope, *right];
            sum.push(arena.neg(forces.lines[r].1));
            for (entry, rate) in row.iter().zip(&e.unknowns) {
                let term = arena.mul(*entry, *rate);
                sum.push(arena.neg(term));
            }
            let mut difference = arena.sum(&sum);
            for definition in e.definitions.iter().rev() {
                let mut put =
                    tripos_derive::algebra::term::calculus::Substitution::new(&[(definition.symbol, definition.value)]);
                difference = put.apply(&mut arena, difference);
            }
            assert_eq!(
                zero_test(&arena, difference),
                ZeroTest::Zero,
                "{name}, row {r}: {}",
                print_text(&arena, energy)
            );
        }
    }
}

/// Goal: a speed that moves no mass is an error, not a singular matrix. Method: a massless particle.
#[test]
fn a_speed_that_moves_no_mass_is_refused() {
    let text = r#"
name = "A particle without mass"
[parameters]
m = { unit = "kg", value = 2 }
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
[speeds]
u1 = "x'"
u2 = "y'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", 0, 0] }
Q = { from = "O", frame = "N", position = ["x", "y", 0] }
[particles]
heavy = { point = "P", mass = "m" }
light = { point = "Q", mass = 0 }
"#;
    let source = tripos_derive::diagnostic::Source::from_text("model.toml", text);
    let model = tripos_derive::model::load(&source).unwrap_or_else(|e| panic!("{e}"));
    let refused = derive(&model, Formulation::GibbsAppell).map(|_| ()).unwrap_err();
    assert!(matches!(&refused, DeriveError::NoInertia { speed } if speed == "u2"), "{refused:?}");
}
