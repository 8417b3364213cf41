//! What is seen of motions, against closed forms.

use std::f64::consts::FRAC_PI_2;
use std::path::Path;
use tripos::view::{Form, Motion, Pose, Triple, View};
use tripos::{Mechanism, Overrides, Scene};
use tripos_derive::model::load;

fn scene(path: &str) -> Scene {
    Scene::read(Path::new("../models").join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn seen(scene: &Scene) -> (Motion, View) {
    let motion = Motion::of_scene(scene.mechanism(), scene.description(), None).unwrap();
    let view = View::new(scene.mechanism(), scene.description(), &[&motion]).unwrap();
    (motion, view)
}

fn point(scene: &Scene, name: &str) -> usize {
    scene.mechanism().points.iter().position(|point| point.name == name).unwrap()
}

fn apart(a: Triple, b: Triple) -> f64 {
    (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt()
}

fn value(scene: &Scene, parameter: &str) -> f64 {
    let at = scene.mechanism().parameters.iter().position(|p| p.name == parameter).unwrap();
    scene.description().parameters[at]
}

/// Goal: a bob is where geometry has it. Method: (l sin θ, −l cos θ, 0), with θ of the same run.
#[test]
fn the_bob_of_a_pendulum_is_on_its_circle() {
    let scene = scene("pendulum/scenes/over.toml");
    let (motion, view) = seen(&scene);
    let mut description = scene.description().clone();
    description.integration.samples = Some(motion.t.len());
    let run = tripos::simulate(scene.mechanism(), &description, Some("kane")).unwrap();
    let (bob, theta) = (point(&scene, "P"), run.column("theta").unwrap());
    assert!(motion.t.len() > 1000 && theta.len() == motion.t.len());
    for (pose, theta) in motion.poses.iter().zip(theta) {
        assert!(apart(pose.points[bob], [theta.sin(), -theta.cos(), 0.0]) < 1e-12);
    }
    let origin = point(&scene, "O");
    assert!(view.solids.iter().any(|solid| matches!(solid.form, Form::Rod { ends, .. } if ends == [origin, bob])));
    assert_eq!((view.traced, view.plane, view.up), (vec![bob], Some([0.0, 0.0, 1.0]), [0.0, 1.0, 0.0]));
}

/// Goal: a body on an axle reaches from it by one rod. Method: the pendulum of Furuta's, which turns about the line of its arm: all points of
/// that rest in it, and the nearest is the joint.
#[test]
fn a_body_on_an_axle_has_one_rod_to_it() {
    let scene = scene("furuta/scenes/swing.toml");
    let (_, view) = seen(&scene);
    let rods = view.solids.iter().filter(|solid| solid.label == "pendulum").filter_map(|solid| match solid.form {
        Form::Rod { ends, .. } => Some(ends),
        _ => None,
    });
    let mut rods: Vec<[usize; 2]> = rods.collect();
    for ends in &mut rods {
        ends.sort_unstable();
    }
    let mut ends = [point(&scene, "joint"), point(&scene, "pendulum_centre")];
    ends.sort_unstable();
    assert_eq!(rods, [ends]);
}

/// Goal: a wheel stands on the ground at every instant. Method: the height of its point of contact, the distance of that from the
/// centre, and the rim's lowest material, R (1 − |sin|) below it, of the cylinder that is drawn.
#[test]
fn a_rolling_disc_is_a_disc_whose_lowest_point_is_on_the_ground() {
    let scene = scene("rolling_disc/scenes/roll.toml");
    let (motion, view) = seen(&scene);
    let (contact, centre, r) = (point(&scene, "C"), point(&scene, "D"), value(&scene, "r"));
    let solid = view.solids.iter().find(|solid| solid.label == "disc").unwrap();
    let Form::Cylinder { at, radius, length } = &solid.form else { panic!("{solid:?}") };
    assert!((radius - r).abs() < 1e-9 && *length < 0.2 * r && at.position.iter().all(|x| x.abs() < 1e-12), "{solid:?}");
    assert!(view.traced.contains(&contact));
    for pose in &motion.poses {
        let axis = axis_of(pose, at.frame, at.turned);
        // The lowest point of a rim of radius r about this axis: r √(1 − a₃²) below the centre.
        let lowest = pose.points[centre][2] - r * (1.0 - axis[2] * axis[2]).sqrt();
        assert!(lowest.abs() < 1e-9 && pose.points[contact][2].abs() < 1e-12, "{lowest}");
        assert!((apart(pose.points[contact], pose.points[centre]) - r).abs() < 1e-12);
    }
    let ground = view.solids.iter().find_map(|solid| match &solid.form {
        Form::Ground { at } => Some(at.position),
        _ => None,
    });
    assert!(ground.is_some_and(|place| place[2].abs() < 1e-9), "{ground:?}");
}

/// Axis 3 of a solid, seen from the inertial frame.
fn axis_of(pose: &Pose, frame: usize, [w, x, y, z]: [f64; 4]) -> Triple {
    let own = [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), w * w - x * x - y * y + z * z];
    pose.rotations[frame].map(|row| (0..3).map(|i| row[i] * own[i]).sum())
}

/// Goal: what is closed is seen closed. Method: the two points of each closing pin, at all samples, and bars as long as the model says.
#[test]
fn the_pins_of_loops_coincide_at_all_samples() {
    let four_bar = scene("four_bar/scenes/turning.toml");
    let (motion, view) = seen(&four_bar);
    let (q, r) = (point(&four_bar, "Q"), point(&four_bar, "R"));
    let worst = motion.poses.iter().map(|pose| apart(pose.points[q], pose.points[r])).fold(0.0, f64::max);
    assert!(worst < 1e-9, "{worst}");
    // Uniform bars look as long as they are.
    for (label, length) in [("crank", "a"), ("coupler", "b"), ("rocker", "c")] {
        let is_bar = |form: &Form| matches!(form, Form::Cylinder { length: long, .. } if (long - value(&four_bar, length)).abs() < 1e-9);
        assert!(
            view.solids.iter().any(|solid| solid.label == label && is_bar(&solid.form)),
            "{label}: {:?}",
            view.solids
        );
    }
}

/// Goal: leaving instants out is not seen. Method: places on straight ways between those that stay, against the ones that were left out.
#[test]
fn what_is_left_out_of_a_motion_lies_on_the_way() {
    let scene = scene("pendulum/scenes/over.toml");
    let (motion, view) = seen(&scene);
    let (thin, looser) = motion.thinned(view.size, 100_000);
    assert!(thin.t.len() * 4 < motion.t.len() && looser < 1.5, "{} of {}", thin.t.len(), motion.t.len());
    assert!(thin.t.first() == motion.t.first() && thin.t.last() == motion.t.last());
    let bob = point(&scene, "P");
    for (t, pose) in motion.t.iter().zip(&motion.poses) {
        let at = thin.t.partition_point(|kept| kept <= t).clamp(1, thin.t.len() - 1);
        let share = (t - thin.t[at - 1]) / (thin.t[at] - thin.t[at - 1]);
        let (a, b) = (thin.poses[at - 1].points[bob], thin.poses[at].points[bob]);
        let between = [0, 1, 2].map(|i| a[i] + share * (b[i] - a[i]));
        assert!(apart(between, pose.points[bob]) < 5.1e-4 * view.size, "t = {t}");
    }
    let (few, looser) = motion.thinned(view.size, 20);
    assert!(few.t.len() <= 21 && looser > 1.0 && few.t.last() == motion.t.last(), "{}", few.t.len());
}

/// Goal: every model of the library can be seen in every scene's first second or less, its bodies all. Method: each body has a solid,
/// every number is one, and every model has a size that its points have.
#[test]
fn every_model_of_the_library_is_seen() {
    let mut folders: Vec<_> = std::fs::read_dir("../models").unwrap().map(|entry| entry.unwrap().path()).collect();
    folders.sort();
    assert!(folders.len() >= 25);
    for folder in folders {
        let mut files: Vec<_> = std::fs::read_dir(folder.join("scenes")).unwrap().map(|e| e.unwrap().path()).collect();
        files.sort();
        let scene = Scene::read(&files[0]).unwrap_or_else(|error| panic!("{}: {error}", files[0].display()));
        let mut short = scene.description().clone();
        short.span.1 = short.span.0 + 0.02 * (short.span.1 - short.span.0);
        let motion = Motion::of_scene(scene.mechanism(), &short, None)
            .unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
        let view = View::new(scene.mechanism(), &short, &[&motion]).unwrap();
        let name = folder.display();
        assert!(motion.poses.len() > 100 && view.size > 0.0 && view.size.is_finite(), "{name}");
        for at in 0..scene.mechanism().bodies.len() {
            assert!(view.solids.iter().any(|solid| solid.body == Some(at)), "{name}: body {at} is not seen");
        }
        for solid in &view.solids {
            assert!(solid.form.reach().is_finite() && solid.form.reach() < 20.0 * view.size, "{name}: {solid:?}");
        }
    }
}

const SHAPED: &str = r#"
name = "Shaped"
[parameters]
m = "2 kg"
r = "10 cm"
w = "30 cm"
[coordinates]
q = { unit = "rad" }
[speeds]
u = "q'"
[inertial]
frame = "N"
origin = "O"
[frames]
B = { from = "N", axis = 3, angle = "q" }
[points]
P = { from = "O", frame = "B", position = ["r", 0, 0] }
[bodies.arm]
frame = "B"
centre = "P"
mass = "m"
inertia = "m*r^2"
[shapes]
wheel = { kind = "disk", body = "arm", axis = 1, radius = "2*w", position = [0, "r", 0] }
"#;

/// Goal: stated shapes stand in the stead of all that is made, at the scene's parameters. Method: a disk about axis 1 of a frame that
/// has turned by a right angle, whose axis is then along n2.
#[test]
fn stated_shapes_are_drawn_at_the_parameters_of_the_scene() {
    let source = tripos_derive::diagnostic::Source::from_text("model.toml", SHAPED);
    let mechanism = Mechanism::new(load(&source).unwrap_or_else(|e| panic!("{e}")));
    let text = "span = [0, 1]\nparameters = { r = 0.2, w = 0.2 }\n[start]\nq = 0\nu = \"pi/2\"\n";
    let scene = Scene::parse(mechanism, text).unwrap_or_else(|e| panic!("{e}"));
    let (motion, view) = seen(&scene);
    let [solid] = view.solids.as_slice() else { panic!("{:?}", view.solids) };
    let Form::Cylinder { at, radius, .. } = &solid.form else { panic!("{solid:?}") };
    assert!(view.is_stated && (radius - 0.4).abs() < 1e-15 && solid.label == "wheel" && solid.body == Some(0));
    assert!(apart(at.position, [0.0, 0.2, 0.0]) < 1e-15);
    let end = motion.poses.last().unwrap();
    assert!(apart(axis_of(end, at.frame, at.turned), [FRAC_PI_2.cos(), FRAC_PI_2.sin(), 0.0]) < 1e-8);

    // What is nothing at the parameters of a scene is refused.
    let mut flat = scene.clone();
    flat.set("w", 0.0).unwrap();
    let motion = Motion::of_scene(flat.mechanism(), flat.description(), None).unwrap();
    let refused = View::new(flat.mechanism(), flat.description(), &[&motion]).unwrap_err();
    assert!(
        refused.to_string().contains("the radius of shape `wheel` is 0 at the parameters of this scene"),
        "{refused}"
    );
}

/// A run that shows outputs of its own alone has no poses, and says so.
#[test]
fn a_reduced_run_is_refused_with_a_way_out() {
    let scene = scene("disk/scenes/lean.toml");
    let run = scene.simulate(&Overrides::default()).unwrap();
    let refused = Motion::of_run(scene.mechanism(), scene.description(), &run).unwrap_err();
    assert!(refused.to_string().contains("shows no poses"), "{refused}");
}
