//! Views of motions, against closed forms.

use std::f64::consts::FRAC_PI_2;
use std::path::Path;
use tripos::pictures::view::{ForceSource, Pose, SolidForm, Triple, View, ViewMotion};
use tripos::{Mechanism, Overrides, Scene};
use tripos_derive::model::load;

fn scene(path: &str) -> Scene {
    Scene::read(Path::new("../models").join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn seen(scene: &Scene) -> (ViewMotion, View) {
    let motion = ViewMotion::of_scene(scene.mechanism(), scene.description(), None).unwrap();
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

/// Goal: a bob is where geometry puts it. Method: (l sin θ, −l cos θ, 0), with θ of the same run.
#[test]
fn the_bob_of_a_pendulum_is_on_its_circle() {
    let scene = scene("pendulum/scenes/over.toml");
    let (motion, view) = seen(&scene);
    let mut description = scene.description().clone();
    description.integration.samples = Some(motion.t.len());
    let run = tripos::simulate(scene.mechanism(), &description, Some(&"kane".into())).unwrap();
    let (bob, theta) = (point(&scene, "P"), run.column_of_quantity("theta").unwrap());
    assert!(motion.t.len() > 1000 && theta.len() == motion.t.len());
    for (pose, theta) in motion.poses.iter().zip(theta) {
        assert!(apart(pose.points[bob], [theta.sin(), -theta.cos(), 0.0]) < 1e-12);
    }
    let origin = point(&scene, "O");
    assert!(view.solids.iter().any(|solid| matches!(solid.form, SolidForm::Rod { ends, .. } if ends == [origin, bob])));
    assert_eq!((view.traced, view.plane, view.up), (vec![bob], Some([0.0, 0.0, 1.0]), [0.0, 1.0, 0.0]));
}

/// Goal: a body on an axle is joined to it by one rod. Method: Furuta's pendulum, which turns about the line of its
/// arm. All points of the arm rest in it, and the nearest is the joint.
#[test]
fn a_body_on_an_axle_has_one_rod_to_it() {
    let scene = scene("furuta/scenes/swing.toml");
    let (_, view) = seen(&scene);
    let rods = view.solids.iter().filter(|solid| solid.label == "pendulum").filter_map(|solid| match solid.form {
        SolidForm::Rod { ends, .. } => Some(ends),
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

/// Goal: a wheel stands on the ground at every instant. Method: the height of its point of contact, the distance of
/// that from the centre, and the lowest material of the rim, R (1 − |sin|) below it, of the drawn cylinder.
#[test]
fn a_rolling_disc_is_a_disc_whose_lowest_point_is_on_the_ground() {
    let scene = scene("rolling_disc/scenes/roll.toml");
    let (motion, view) = seen(&scene);
    let (contact, centre, r) = (point(&scene, "C"), point(&scene, "D"), value(&scene, "r"));
    let solid = view.solids.iter().find(|solid| solid.label == "disc").unwrap();
    let SolidForm::Cylinder { at, radius, length } = &solid.form else { panic!("{solid:?}") };
    assert!((radius - r).abs() < 1e-9 && *length < 0.2 * r && at.position.iter().all(|x| x.abs() < 1e-12), "{solid:?}");
    assert!(view.traced.contains(&contact));
    for pose in &motion.poses {
        let axis = axis_of(pose, at.frame, at.turned);
        // The lowest point of a rim of radius r about this axis is r √(1 − a₃²) below the centre.
        let lowest = pose.points[centre][2] - r * (1.0 - axis[2] * axis[2]).sqrt();
        assert!(lowest.abs() < 1e-9 && pose.points[contact][2].abs() < 1e-12, "{lowest}");
        assert!((apart(pose.points[contact], pose.points[centre]) - r).abs() < 1e-12);
    }
    let ground = view.solids.iter().find_map(|solid| match &solid.form {
        SolidForm::Ground { at } => Some(at.position),
        _ => None,
    });
    assert!(ground.is_some_and(|place| place[2].abs() < 1e-9), "{ground:?}");
}

/// Axis 3 of a solid, seen from the inertial frame.
fn axis_of(pose: &Pose, frame: usize, [w, x, y, z]: [f64; 4]) -> Triple {
    let own = [2.0 * (x * z + w * y), 2.0 * (y * z - w * x), w * w - x * x - y * y + z * z];
    pose.rotations[frame].map(|row| (0..3).map(|i| row[i] * own[i]).sum())
}

/// Goal: closed loops are seen closed. Method: the two points of each closing pin, at all samples, and bars as long as
/// in the model.
#[test]
fn the_pins_of_loops_coincide_at_all_samples() {
    let four_bar = scene("four_bar/scenes/turning.toml");
    let (motion, view) = seen(&four_bar);
    let (q, r) = (point(&four_bar, "Q"), point(&four_bar, "R"));
    let worst = motion.poses.iter().map(|pose| apart(pose.points[q], pose.points[r])).fold(0.0, f64::max);
    assert!(worst < 1e-9, "{worst}");
    // Uniform bars have their length from the model.
    for (label, length) in [("crank", "a"), ("coupler", "b"), ("rocker", "c")] {
        let is_bar = |form: &SolidForm| matches!(form, SolidForm::Cylinder { length: long, .. } if (long - value(&four_bar, length)).abs() < 1e-9);
        assert!(
            view.solids.iter().any(|solid| solid.label == label && is_bar(&solid.form)),
            "{label}: {:?}",
            view.solids
        );
    }
}

/// Goal: left-out instants cannot be noticed. Method: places on straight paths between the kept instants, against the
/// left-out ones.
#[test]
fn what_is_left_out_of_a_motion_lies_on_the_way() {
    let scene = scene("pendulum/scenes/over.toml");
    let (motion, view) = seen(&scene);
    let (thin, looser) = motion.thin_motion(view.size, 100_000);
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
    for (t, forces) in motion.t.iter().zip(&motion.forces.values) {
        let at = thin.t.partition_point(|kept| kept <= t).clamp(1, thin.t.len() - 1);
        let share = (t - thin.t[at - 1]) / (thin.t[at] - thin.t[at - 1]);
        let (a, b) = (thin.forces.values[at - 1][1], thin.forces.values[at][1]);
        let between = [0, 1, 2].map(|i| a[i] + share * (b[i] - a[i]));
        assert!(apart(between, forces[1]) < 2.02e-2 * motion.forces.usual, "t = {t}");
    }
    let (few, looser) = motion.thin_motion(view.size, 20);
    assert!(few.t.len() <= 21 && looser > 1.0 && few.t.last() == motion.t.last(), "{}", few.t.len());
}

/// Goal: the warning about turning that looks wrong is right. Method: a wheel at a constant rate, whose even turns are
/// right while no two pictures are half a turn apart, however few there are. Also a wheel that 6000 instants cannot
/// follow.
#[test]
fn turning_is_true_where_even_turns_between_pictures_are() {
    let wheel = "name = \"Wheel\"\n[parameters]\nJ = \"1 kg*m^2\"\n[coordinates]\nq = { unit = \"rad\" }\n[speeds]\nw = \"q'\"\n[inertial]\nframe = \"N\"\n\
                 origin = \"O\"\n[frames]\nB = { from = \"N\", axis = 3, angle = \"q\" }\n[bodies.d]\nframe = \"B\"\ncentre = \"O\"\nmass = 0\ninertia = \"J\"\n";
    let spun = |rate: f64| motion_of(wheel, &format!("span = [0, 7]\nstart = {{ q = 0, w = {rate} }}\n")).1;
    // The wheel turns by 350 rad, which is 111 half turns.
    let slow = spun(50.0);
    for (most, is_true) in [(100_000, true), (150, true), (90, false), (20, false)] {
        let (thin, _) = slow.thin_motion(1.0, most);
        assert_eq!(slow.has_true_rotations(&thin), is_true, "{most}: {} pictures", thin.t.len());
    }
    let fast = spun(2000.0);
    assert!(!fast.has_true_rotations(&fast), "2.3 rad from one instant to the next");
}

/// Goal: the change of forces at left-out instants cannot be noticed either. Method: a force that swings while nothing
/// moves, at all left-out instants.
#[test]
fn forces_between_the_instants_that_stay_are_on_the_way() {
    let model =
        PULLED.replace("frame = \"B\"\nvector = [0, \"-c*l*q'\", 0]", "frame = \"N\"\nvector = [\"c*cos(f*t)\", 0, 0]");
    let model = model.replace("c = \"3 N*s/m\"", "c = \"3 N\"\nf = \"20 1/s\"");
    let start =
        "span = [0, 1]\nparameters = { m = 1e12, c = 3, l = 0.5, f = 20 }\nstart = { q = 0, x = 1, w = 0, v = 0 }\n";
    let (_, motion) = motion_of(&model, start);
    let (thin, _) = motion.thin_motion(1.0, 100_000);
    assert!(thin.t.len() * 4 < motion.t.len() && thin.t.len() > 20, "{} of {}", thin.t.len(), motion.t.len());
    for (t, forces) in motion.t.iter().zip(&motion.forces.values) {
        let at = thin.t.partition_point(|kept| kept <= t).clamp(1, thin.t.len() - 1);
        let share = (t - thin.t[at - 1]) / (thin.t[at] - thin.t[at - 1]);
        let (a, b) = (thin.forces.values[at - 1][0], thin.forces.values[at][0]);
        let between = [0, 1, 2].map(|i| a[i] + share * (b[i] - a[i]));
        assert!(apart(forces[0], [3.0 * (20.0 * t).cos(), 0.0, 0.0]) < 1e-9, "{forces:?}");
        assert!(apart(between, forces[0]) < 2.02e-2 * motion.forces.usual, "t = {t}");
    }
}

/// Goal: every model of the library can be seen in the first second or less of every scene, with all its bodies.
/// Method: each body has a solid, every number is finite, and every model has a size that its solids do not exceed by
/// much.
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
        let motion = ViewMotion::of_scene(scene.mechanism(), &short, None)
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

/// A motion by Kane's method of a scene as text.
fn motion_of(model: &str, scene: &str) -> (Scene, ViewMotion) {
    let source = tripos_derive::diagnostic::Source::from_text("model.toml", model);
    let mechanism = Mechanism::new(load(&source).unwrap_or_else(|e| panic!("{e}")));
    let scene = Scene::parse(mechanism, scene).unwrap_or_else(|e| panic!("{e}"));
    let motion = ViewMotion::of_scene(scene.mechanism(), scene.description(), None).unwrap();
    (scene, motion)
}

fn arrows_of(motion: &ViewMotion) -> Vec<(ForceSource, &str, usize, bool)> {
    motion.forces.list.iter().map(|a| (a.kind, a.name.as_str(), a.point, a.is_opposite)).collect()
}

/// Goal: arrows show the forces. Method: a bob on a spring at every instant of a run: its weight (0, −m g, 0), and the
/// pull k (r − l) along the line to the support, both at the bob.
#[test]
fn arrows_are_the_weight_and_the_pull_of_the_spring() {
    let scene = scene("elastic_pendulum/scenes/bouncing.toml");
    let (motion, _) = seen(&scene);
    let bob = point(&scene, "P");
    assert_eq!(
        arrows_of(&motion),
        [(ForceSource::Weight, "bob", bob, false), (ForceSource::Applied, "rubber", bob, false)]
    );
    let [m, k, l, g] = ["m", "k", "l", "g"].map(|name| value(&scene, name));
    assert!(motion.poses.len() > 1000 && motion.forces.values.len() == motion.poses.len());
    for (pose, forces) in motion.poses.iter().zip(&motion.forces.values) {
        let [x, y, _] = pose.points[bob];
        let r = x.hypot(y);
        let pull = k * (r - l) / r;
        assert!(apart(forces[0], [0.0, -m * g, 0.0]) < 1e-12, "{forces:?}");
        assert!(apart(forces[1], [-pull * x, -pull * y, 0.0]) < 1e-11 * k, "{forces:?}");
    }
}

const PULLED: &str = r#"
name = "Pulled"
[parameters]
m = "2 kg"
c = "3 N*s/m"
l = "0.5 m"
[coordinates]
q = { unit = "rad" }
x = { unit = "m" }
[speeds]
w = "2*q'"
v = "x'"
[inertial]
frame = "N"
origin = "O"
[frames]
B = { from = "N", axis = 3, angle = "q" }
[points]
P = { from = "O", frame = "B", position = ["l", 0, 0] }
S = { from = "O", frame = "N", position = ["x", 0, 0] }
[particles]
first = { point = "P", mass = "m" }
second = { point = "S", mass = "m" }
[forces.drag]
on = "first"
against = "second"
frame = "B"
vector = [0, "-c*l*q'", 0]
"#;

/// Goal: components in a turning frame, rates where speeds are not rates, and opposites are right. Method: a drag along
/// b2 = (−sin q, cos q, 0), with q' = w/2, and its opposite on the other body, at the start q = 0.7, w = 4.
#[test]
fn arrows_turn_with_their_frame_and_have_opposites() {
    let start = "span = [0, 0.5]\nparameters = { m = 2, c = 3, l = 0.5 }\nstart = { q = 0.7, x = 1, w = 4, v = 0.3 }\n";
    let (scene, motion) = motion_of(PULLED, start);
    let (first, second) = (point(&scene, "P"), point(&scene, "S"));
    let forces = [(ForceSource::Applied, "drag", first, false), (ForceSource::Applied, "drag", second, true)];
    assert_eq!(arrows_of(&motion)[..2], forces, "no gravity, no weights");
    let drag = -3.0 * 0.5 * 2.0;
    let at_start = &motion.forces.values[0];
    assert!(apart(at_start[0], [-drag * 0.7_f64.sin(), drag * 0.7_f64.cos(), 0.0]) < 1e-14, "{at_start:?}");
    for forces in &motion.forces.values {
        assert!(apart(forces[1], forces[0].map(|x| -x)) == 0.0, "{forces:?}");
    }
}

/// Goal: reactions are shown with their sign, and no other force acts. Method: Newton's law for a body whose forces are
/// all arrows: their sum is m a of its mass centre, by second differences of its places.
#[test]
fn arrows_on_a_body_add_up_to_its_mass_times_acceleration() {
    let scenes = [
        ("pendulum/scenes/over.toml", "m"),
        ("disk/scenes/lean.toml", "M"),
        ("spherical_pendulum/scenes/wide.toml", "m"),
        ("rolling_disc/scenes/roll.toml", "m"),
        ("heavy_top/scenes/looping.toml", "m"),
    ];
    for (path, mass) in scenes {
        let scene = scene(path);
        let mut description = scene.description().clone();
        description.integration.rtol = 1e-12;
        description.span.1 = description.span.0 + 0.6;
        let motion = ViewMotion::of_scene(scene.mechanism(), &description, None).unwrap();
        let [body] = scene.mechanism().bodies.as_slice() else { panic!("{path}: more than one body") };
        let arrows = arrows_of(&motion);
        assert!(arrows.iter().any(|(kind, ..)| *kind == ForceSource::Reaction), "{path}: {arrows:?}");
        let mass = value(&scene, mass);
        let h = motion.t[1] - motion.t[0];
        let mut most = 0.0_f64;
        for at in 1..1000 {
            let centre = |at: usize| motion.poses[at].points[body.centre];
            let [a, b, c] = [centre(at - 1), centre(at), centre(at + 1)];
            let newton = [0, 1, 2].map(|i| mass * (a[i] - 2.0 * b[i] + c[i]) / (h * h));
            let acts =
                motion.forces.values[at].iter().fold([0.0; 3], |sum, f| [sum[0] + f[0], sum[1] + f[1], sum[2] + f[2]]);
            most = most.max(apart(newton, acts));
        }
        let scale = motion.forces.largest();
        assert!(most < 2e-6 * scale, "{path}: {most:e} of {scale}");
    }
}

const MEETS: &str = "[impacts.floor]\ngap = \"p(P) @ N [2] + 2\"\nrestitution = 0.5\n";

/// Goal: the force in a closed contact has no arrow, and the view says so. Method: a pendulum that meets a floor has
/// only its weight.
#[test]
fn reactions_of_scenes_with_impacts_are_said_to_be_missing() {
    let scene = scene("pendulum/scenes/over.toml");
    let text = std::fs::read_to_string("../models/pendulum/model.toml").unwrap();
    let start = format!(
        "span = [0, 0.2]\nparameters = {{ m = 1, l = 1, g = 9.81 }}\nstart = {{ theta = 0, omega = 1 }}\n{MEETS}"
    );
    let (_, motion) = motion_of(&text, &start);
    assert_eq!(arrows_of(&motion), [(ForceSource::Weight, "bob", point(&scene, "P"), false)]);
    assert_eq!(motion.forces.without.as_deref(), Some("the forces of closed contacts are not part of the equations"));
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

/// Goal: stated shapes replace all guessed solids, at the scene's parameters. Method: a disk about axis 1 of a frame
/// that has turned by a right angle, whose axis is then along n2.
#[test]
fn stated_shapes_are_drawn_at_the_parameters_of_the_scene() {
    let source = tripos_derive::diagnostic::Source::from_text("model.toml", SHAPED);
    let mechanism = Mechanism::new(load(&source).unwrap_or_else(|e| panic!("{e}")));
    let text = "span = [0, 1]\nparameters = { r = 0.2, w = 0.2 }\n[start]\nq = 0\nu = \"pi/2\"\n";
    let scene = Scene::parse(mechanism, text).unwrap_or_else(|e| panic!("{e}"));
    let (motion, view) = seen(&scene);
    let [solid] = view.solids.as_slice() else { panic!("{:?}", view.solids) };
    let SolidForm::Cylinder { at, radius, .. } = &solid.form else { panic!("{solid:?}") };
    assert!(view.is_stated && (radius - 0.4).abs() < 1e-15 && solid.label == "wheel" && solid.body == Some(0));
    assert!(apart(at.position, [0.0, 0.2, 0.0]) < 1e-15);
    let end = motion.poses.last().unwrap();
    assert!(apart(axis_of(end, at.frame, at.turned), [FRAC_PI_2.cos(), FRAC_PI_2.sin(), 0.0]) < 1e-8);

    // A length that is zero at the parameters of a scene is refused.
    let mut flat = scene.clone();
    flat.set_number("w", 0.0).unwrap();
    let motion = ViewMotion::of_scene(flat.mechanism(), flat.description(), None).unwrap();
    let refused = View::new(flat.mechanism(), flat.description(), &[&motion]).unwrap_err();
    assert!(
        refused.to_string().contains("the radius of shape `wheel` is 0 at the parameters of this scene"),
        "{refused}"
    );
}

/// Goal: a run that shows only outputs of its own has no poses, and says so.
#[test]
fn a_reduced_run_is_refused_with_a_way_out() {
    let scene = scene("disk/scenes/lean.toml");
    let run = scene.simulate(&Overrides::default()).unwrap();
    let refused = ViewMotion::of_run(scene.mechanism(), scene.description(), &run).unwrap_err();
    assert!(refused.to_string().contains("shows no poses"), "{refused}");
}
