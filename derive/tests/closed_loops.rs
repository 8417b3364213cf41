//! Loops with fewer independent equations in closed poses than elsewhere, and the speeds that determine them best.
//!
//! Truth: spatial linkages of pins that are known to move, by R. Bricard 1897 and G. T. Bennett 1903, the latter with
//! its angles in closed form.

use crate::common;

use common::read;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::derive_all;
use tripos_derive::model::{Model, MotionConstraintKind};
use tripos_derive::prove::prove;

const BRICARD: &str = include_str!("../../models/bricard/model.toml");
const BENNETT: &str = include_str!("loops/bennett.toml");

fn load(text: &str) -> Model {
    read(text).unwrap_or_else(|e| panic!("{e}"))
}

fn proved(model: &Model) {
    let mut derivations = derive_all(model).unwrap();
    let proof = prove(model, &mut derivations);
    assert_eq!(proof.pairs.len(), 3);
    assert!(proof.pairs.iter().all(|e| e.verdict.is_equal()), "{:?}", proof.pairs);
}

/// Goal: six pins that fix six bars in all poses but the closed ones leave one freedom in these. Method: five
/// equations, four of them independent; the circuit of the dependent ones; three derivations. Near the cube's edges,
/// where all angles are 0, the scaled rows with the factors 1, −1, 1, −1 and 1 add up to 0: all five equations are
/// dependent. P6_3 has no slope on a further branch, where the bars have two freedoms.
#[test]
fn bricards_linkage_moves() {
    let model = load(BRICARD);
    assert_eq!((model.coordinates.len(), model.speeds.len(), model.motion_constraints.len()), (5, 1, 4));
    let [dependent] = model.dependent.as_slice() else { panic!("{:?}", model.dependent) };
    let mut circuit = dependent.of.clone();
    circuit.push(dependent.name.clone());
    circuit.sort();
    assert_eq!(circuit, ["P6_1", "P6_2", "P6_3", "P6_turn12", "P6_turn13"]);
    assert!(dependent.poses > 50, "{dependent:?}");
    assert_eq!(model.closed.iter().map(|c| &c.name).collect::<Vec<_>>(), [&dependent.name]);
    proved(&model);
}

/// Goal: an overdetermined loop starts where all of its equations hold. Method: with one angle given, tan(q1/2)
/// tan(q2/2) = sin((β + α)/2)/sin((β − α)/2) and q3 = −q1, whichever equations were left out.
#[test]
fn bennetts_linkage_closes_and_moves() {
    let mut model = load(BENNETT);
    assert_eq!((model.loops.len(), model.closed.len(), model.dependent.len()), (2, 3, 3));
    let ties: Vec<_> = model.motion_constraints.iter().map(|c| c.kind).collect();
    assert_eq!(ties, [MotionConstraintKind::Loop(0), MotionConstraintKind::Loop(1)]);
    proved(&model);
    let speed = model.speeds[0].name.clone();
    let (alpha, beta): (f64, f64) = (std::f64::consts::PI / 6.0, 0.75_f64.asin());
    let ratio = f64::midpoint(beta, alpha).sin() / ((beta - alpha) / 2.0).sin();
    for q1 in [0.3, 1.0, 2.5] {
        let text = format!(
            "model = \"model.toml\"\nspan = [0, 1]\n[start]\nq_P1 = {q1}\n{speed} = 0\n[guess]\nq_P2 = 2\nq_P3 = -1\n"
        );
        let scene = tripos_derive::scene::load(&Source::from_text("scene.toml", &text), &mut model)
            .unwrap_or_else(|e| panic!("{e}"));
        let q2 = 2.0 * (ratio / (q1 / 2.0_f64).tan()).atan();
        assert!((scene.q[1] - q2).abs() < 1e-12 && (scene.q[2] + q1).abs() < 1e-12, "{:?}, {q2}", scene.q);
    }
}

/// Goal: a dependence at the default values is not assumed at others. Method: the second twist is a parameter of its
/// own, so that only its value closes the linkage.
#[test]
fn what_follows_at_other_values_is_asked_again() {
    let text =
        BENNETT.replace("alpha = \"30 deg\"", "alpha = \"30 deg\"\nbeta = { unit = \"rad\", value = \"asin(0.75)\" }");
    let text = text.replace("beta = \"asin(b/a*sin(alpha))\"\n", "");
    let mut model = load(&text);
    assert_eq!(model.closed.len(), 3);
    let speed = model.speeds[0].name.clone();
    let scene = |beta: &str| {
        let parameters = format!("[parameters]\nbeta = {beta}\n");
        let text = format!(
            "model = \"model.toml\"\nspan = [0, 1]\n{parameters}[start]\nq_P1 = 1\n{speed} = 0\n[guess]\nq_P2 = 2\nq_P3 = -1\n"
        );
        Source::from_text("scene.toml", &text)
    };
    tripos_derive::scene::load(&scene("\"asin(0.75)\""), &mut model).unwrap_or_else(|e| panic!("{e}"));
    for beta in ["\"45 deg\"", "\"asin(0.7501)\""] {
        let errors =
            tripos_derive::scene::load(&scene(beta), &mut model).expect_err("a linkage that does not move").to_string();
        assert!(errors.contains("no configuration that closes the loops was found"), "{errors}");
    }
}

/// Goal: with other lengths the same bars do not move: they are a structure. Method: the second twist no longer fits.
#[test]
fn what_does_not_fit_does_not_move() {
    let text = BENNETT.replace("asin(b/a*sin(alpha))", "asin(b/a*sin(alpha)/2)");
    let model = load(&text);
    assert_eq!((model.speeds.len(), model.coordinates.len(), model.motion_constraints.len()), (0, 3, 3));
}

/// Goal: the chosen speed belongs to an angle that goes all the way round. Method: crank-rockers by pins, whose crank
/// comes first, in the middle and last. The crank turns fully against both the ground and the coupler; the rocker has
/// dead points.
#[test]
fn what_goes_round_is_chosen() {
    let head = "name = \"bars\"\n[parameters]\na = \"0.3 m\"\nb = \"0.8 m\"\nc = \"0.6 m\"\nd = \"0.7 m\"\nm = \"1 kg\"\nI = \"1 \
                kg*m^2\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[bodies]\ncrank = { mass = \"m\", inertia = \"I\" }\ncoupler = { mass = \
                \"m\", inertia = \"I\" }\nrocker = { mass = \"m\", inertia = \"I\" }\n[joints]\n";
    let of_crank = "A = { kind = \"pin\", body = \"crank\" }\n";
    let of_coupler = "B = { kind = \"pin\", body = \"coupler\", to = \"crank\", at = [\"a\", 0, 0] }\n";
    let of_rocker = "D = { kind = \"pin\", body = \"rocker\", at = [\"d\", 0, 0] }\n";
    let closing =
        "C = { kind = \"pin\", body = \"rocker\", to = \"coupler\", at = [\"b\", 0, 0], body_at = [\"c\", 0, 0] }\n";
    for order in
        [[of_crank, of_coupler, of_rocker], [of_rocker, of_crank, of_coupler], [of_rocker, of_coupler, of_crank]]
    {
        let model = load(&format!("{head}{}{closing}", order.concat()));
        let [speed] = model.speeds.as_slice() else { panic!("one freedom") };
        assert!(["u_A", "u_B"].contains(&speed.name.as_str()), "{}", speed.name);
    }
}

/// A four-bar linkage of spatial bars whose joints lie at several heights; `HEIGHT` is that of the closing ball.
const STACKED: &str = r#"
name = "stacked"
[parameters]
a = { unit = "m", value = 0.2, positive = true }
b = { unit = "m", value = 0.5, positive = true }
c = { unit = "m", value = 0.4, positive = true }
d = { unit = "m", value = 0.6, positive = true }
h1 = { unit = "m", value = 0.1 }
h2 = { unit = "m", value = 0.2 }
h3 = { unit = "m", value = HEIGHT }
m = { unit = "kg", value = 1, positive = true }
I = { unit = "kg*m^2", value = 0.01, positive = true }
[inertial]
frame = "N"
origin = "O"
[bodies]
crank = { mass = "m", inertia = "I" }
coupler = { mass = "m", inertia = "I" }
rocker = { mass = "m", inertia = "I" }
[joints]
J1 = { kind = "pin", body = "crank", centre = ["a/2", 0, 0] }
J2 = { kind = "pin", body = "coupler", to = "crank", at = ["a", 0, "h1"], centre = ["b/2", 0, 0] }
J3 = { kind = "pin", body = "rocker", at = ["d", 0, 0], centre = ["c/2", 0, 0] }
J4 = { kind = "ball", body = "rocker", to = "coupler", at = ["b", 0, "h2"], body_at = ["c", 0, "h3"] }
"#;

/// Goal: an equation of a closing joint without coordinates is a condition on parameters, not a constraint. Method: the
/// ball of a planar loop; heights that agree, in the model and in the scene, and heights that do not.
#[test]
fn a_planar_loop_closed_by_a_ball_needs_heights_that_agree() {
    let mut model = load(&STACKED.replace("HEIGHT", "0.3"));
    assert_eq!((model.loops.len(), model.speeds.len(), model.conditions.len()), (2, 1, 1));
    assert!(model.repeated.iter().any(|repeated| repeated.name == "J4_3"), "{:?}", model.repeated);
    let flat = load(
        &STACKED
            .replace("0.1 }\nh2", "0 }\nh2")
            .replace("h2 = { unit = \"m\", value = 0.2 }", "h2 = { unit = \"m\", value = 0 }")
            .replace("HEIGHT", "0"),
    );
    assert_eq!((flat.loops.len(), flat.conditions.len()), (2, 1));
    let mut scene = |parameters: &str| {
        let speed = model.speeds[0].name.clone();
        let text = format!(
            "model = \"model.toml\"\nspan = [0, 1]\n[parameters]\n{parameters}\n[start]\nq_J1 = 1\n{speed} = 0\n[guess]\nq_J2 = -0.5\nq_J3 = 1.5\n"
        );
        tripos_derive::scene::load(&Source::from_text("scene.toml", &text), &mut model)
    };
    assert!(scene("").is_ok() && scene("h1 = 0.15\nh2 = 0.15").is_ok());
    let error = scene("h1 = 0.15").unwrap_err().to_string();
    assert!(error.contains("at the values of this scene `J4_3` is open by 0.05"), "{error}");

    let error = read(&STACKED.replace("HEIGHT", "0.25")).err().unwrap().to_string();
    assert!(error.contains("the joint cannot close its loop: `J4_3` is open by 0.05"), "{error}");
}

/// Goal: a model states on which branch its loops are closed. Method: the two assemblies of a four-bar linkage, in
/// scenes without a guess; values from which no pose closes the loop.
#[test]
fn an_assembly_decides_the_branch() {
    for (coupler, rocker) in [(-0.5, 1.7), (-2.1, -2.3)] {
        let text = STACKED.replace("HEIGHT", "0.3")
            + &format!("[assembly]\nq_J1 = 1\nq_J2 = {coupler}\nq_J3 = \"{rocker}\"\n");
        let mut model = load(&text);
        let pose = model.assembly.clone().unwrap();
        assert!((pose[2] - rocker).abs() < 0.2, "{pose:?}");
        let scene = format!("model = \"model.toml\"\nspan = [0, 1]\n[start]\nq_J1 = {}\n\"q_J1'\" = 0\n", pose[0]);
        let scene = tripos_derive::scene::load(&Source::from_text("scene.toml", &scene), &mut model)
            .unwrap_or_else(|e| panic!("{e}"));
        assert!((scene.q[2] - pose[2]).abs() < 1e-9, "{pose:?}");
    }
    let open = STACKED.replace("HEIGHT", "0.3").replace("value = 0.6", "value = 6") + "[assembly]\nq_J1 = 1\n";
    let error = read(&open).err().unwrap().to_string();
    assert!(error.contains("no pose with closed loops is near the values under `assembly`"), "{error}");
    let unknown = STACKED.replace("HEIGHT", "0.3") + "[assembly]\nq_J9 = 1\n";
    assert!(read(&unknown).err().unwrap().to_string().contains("q_J9"));
}

/// Rod of length a between two pins at the distance d, with a second rod on its end.
const LOCKED: &str = r#"
name = "locked rod beside a free one"
[inertial]
frame = "N"
origin = "O"
[parameters]
m = "1 kg"
J = "0.01 kg*m^2"
a = "0.3 m"
d = "DISTANCE m"
g = "9.81 m/s^2"
[bodies]
b0 = { mass = "m", inertia = "J" }
b1 = { mass = "m", inertia = "J" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[joints]
j0 = { kind = "pin", body = "b0", axis = 3, centre = ["a", 0, 0] }
j1 = { kind = "pin", body = "b1", to = "b0", axis = 3, at = ["a", 0, 0], centre = ["a", 0, 0] }
c = { kind = "pin", body = "b0", axis = 3, at = ["d", 0, 0], body_at = ["a", 0, 0] }
"#;

/// Goal: of two equations that lock a rod, the one that has a slope there is kept. Method: a cos q − d = 0 and
/// a sin q = 0, whose slopes at q = 0 are 0 and a, for a distance d that equals a, also after rounding; the
/// acceleration of the free rod, −m g a/(J + m a²).
#[test]
fn an_equation_without_a_slope_locks_nothing() {
    for distance in ["0.3", "0.30000000000000004"] {
        let mut model = load(&LOCKED.replace("DISTANCE", distance));
        let names: Vec<&str> = model.motion_constraints.iter().map(|c| c.name.as_str()).collect();
        assert_eq!((names.as_slice(), model.speeds.len()), (["c_2"].as_slice(), 1));
        let [dependent] = model.dependent.as_slice() else { panic!("{:?}", model.dependent) };
        assert_eq!((dependent.name.as_str(), dependent.of.len()), ("c_1", 0));
        proved(&model);
        let text = "model = \"model.toml\"\nspan = [0, 1]\n[start]\nq_j1 = 0\n\"q_j1'\" = 0\n";
        let scene = tripos_derive::scene::load(&Source::from_text("scene.toml", text), &mut model)
            .unwrap_or_else(|e| panic!("{e}"));
        assert!(scene.q.iter().all(|q| q.abs() < 1e-12), "{:?}", scene.q);
    }
}

/// Goal: an equation without a slope that restricts finite motions is not redundant. Method: three rods that reach
/// their other pin at full length alone; Σ a cos(angle) − 3a has no slope there, and yet nothing can move.
#[test]
fn a_stretched_chain_keeps_the_equation_that_holds_it() {
    let chain = LOCKED
        .replace("DISTANCE", "0.75")
        .replace("\"0.3 m\"", "\"0.25 m\"")
        .replace("b1 = { mass", "b2 = { mass = \"m\", inertia = \"J\" }\nb1 = { mass")
        .replace("c = { kind = \"pin\", body = \"b0\"", "j2 = { kind = \"pin\", body = \"b2\", to = \"b1\", axis = 3, at = [\"a\", 0, 0] }\nc = { kind = \"pin\", body = \"b2\"");
    let model = load(&chain);
    let names: Vec<&str> = model.motion_constraints.iter().map(|c| c.name.as_str()).collect();
    assert_eq!((names.as_slice(), model.dependent.len()), (["c_1", "c_2"].as_slice(), 0));
}

/// Two bodies on cylinders and planes, so that planes fix positions along axes.
fn fixed_slides(joints: &str, parameters: &str) -> String {
    format!(
        "name = \"slides\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n[parameters]\nm = \"1 kg\"\nJ = \"0.01 kg*m^2\"\n{parameters}\n[bodies]\nb0 = {{ mass = \
         \"m\", inertia = {{ diagonal = [\"J\", \"J\", \"J\"] }} }}\n[joints]\n{joints}\n"
    )
}

/// Goal: two joints may fix one slide at the same place, at the default values and nowhere else. Method: a cylinder in
/// two planes, at heights that agree, that agree but for rounding, and that differ; a scene in which they differ.
#[test]
fn two_planes_that_fix_one_slide_agree_at_the_default_values() {
    let joints = "j0 = { kind = \"cylinder\", body = \"b0\", axis = 3 }\nc1 = { kind = \"planar\", body = \"b0\", axis = 3, at = [0, 0, \"h1\"], body_at = [0, 0, \
                  \"k1\"] }\nc2 = { kind = \"planar\", body = \"b0\", axis = 3, at = [0, 0, \"h2\"], body_at = [0, 0, \"k2\"] }";
    let text = |h1: &str, k2: &str| {
        fixed_slides(joints, &format!("h1 = \"{h1} m\"\nk1 = \"0.25 m\"\nh2 = \"0.75 m\"\nk2 = \"{k2} m\""))
    };
    for h1 in ["0.5", "0.50000000000000011"] {
        let mut model = load(&text(h1, "0.5"));
        assert_eq!((model.speeds.len(), model.conditions.len()), (1, 1));
        proved(&model);
        let mut scene = |parameters: &str| {
            let speed = model.speeds[0].name.clone();
            let text = format!(
                "model = \"model.toml\"\nspan = [0, 1]\n[parameters]\n{parameters}\n[start]\nq_j0_1 = 1\n{speed} = 0\n"
            );
            tripos_derive::scene::load(&Source::from_text("scene.toml", &text), &mut model).map_err(|e| e.to_string())
        };
        assert!(scene("").is_ok() && scene("h1 = 0.75\nk2 = 0.25").is_ok());
        let error = scene("h1 = 0.75").expect_err("two heights");
        assert!(error.contains("at the values of this scene `c2_3` is open by 0.25"), "{error}");
    }
    let error = read(&text("0.5", "0.50001")).err().unwrap().to_string();
    assert!(error.contains("the constraint `c2_3` contradicts those before it: it is open by 1.000e-5"), "{error}");
}

/// Goal: a loop whose residual is a product of a difference closes if the difference is 0 but for rounding. Method: a
/// body welded to another, closed by a cylinder whose position in axes turned by an angle is a parameter.
#[test]
fn a_loop_closes_within_the_rounding_of_its_parameters() {
    let joints = "j0 = { kind = \"pin\", body = \"b0\", axis = 3 }\nj1 = { kind = \"weld\", body = \"b1\", to = \"b0\", at = [\"L\", 0, 0] }\nc = { kind = \"cylinder\", \
                  body = \"b1\", to = \"b0\", at = [\"L\", \"y\", \"z\"], axis = 3, turned = { sequence = \"13\", angles = [\"a\", \"b\"] }, body_turned = { sequence = \"1\", angles \
                  = [\"a\"] } }";
    let text = |y: &str| {
        let parameters = format!(
            "L = \"1 m\"\na = {{ unit = \"rad\", value = 0.4 }}\nb = {{ unit = \"rad\", value = -0.7 }}\ny = \"{y} m\"\nz = \"-0.7447414589660183 m\""
        );
        fixed_slides(joints, &parameters)
            .replace("[joints]", "b1 = { mass = \"m\", inertia = { diagonal = [\"J\", \"J\", \"J\"] } }\n[joints]")
    };
    let model = load(&text("0.31487163856399747"));
    assert_eq!((model.speeds.len(), model.conditions.len()), (1, 2));
    proved(&model);
    // y = −z tan(0.4); a difference of 1e-8 m opens the loop by 1e-8 cos(0.4) times the sine or cosine of 0.7.
    let error = read(&text("0.31487164856399747")).err().unwrap().to_string();
    assert!(error.contains("`c_1` is open by 5.934e-9 in every pose"), "{error}");
    assert!(error.contains("`c_2` is open by 7.045e-9 in every pose"), "{error}");
}

/// Goal: a drive against a rigid loop is named, at its place. Method: drives that replace a coordinate and drives that
/// stay equations, of a rod that a weld, a pin or a triangle of rods holds.
#[test]
fn a_drive_against_a_rigid_loop_is_named() {
    let weld = LOCKED.replace("DISTANCE", "0.3").replace(
        "c = { kind = \"pin\", body = \"b0\", axis = 3, at = [\"d\", 0, 0], body_at = [\"a\", 0, 0] }",
        "c = { kind = \"weld\", body = \"b0\" }",
    );
    let pin = LOCKED.replace("DISTANCE", "0.3");
    let triangle = weld.replace(
        "c = { kind = \"weld\", body = \"b0\" }",
        "c = { kind = \"pin\", body = \"b1\", axis = 3, at = [\"1.5*a\", 0, 0], body_at = [\"a\", 0, 0] }\ne = { kind = \"weld\", body = \"b1\", to = \"b0\", at = \
         [\"a\", 0, 0], turned = { sequence = \"3\", angles = [\"1.0\"] } }",
    );
    for held in [&weld, &pin, &triangle] {
        for drive in ["q_j0 = w*t", "sin(q_j0) = sin(w*t)"] {
            let text = held.replace("[bodies]", "w = \"2 rad/s\"\n[bodies]");
            let error = read(&format!("{text}[constraints]\nspin = \"{drive}\"\n")).err().unwrap().to_string();
            assert!(error.contains("the drive `spin` is held: the other joints and constraints fix what"), "{error}");
            assert!(error.contains(&format!("spin = \"{drive}\"")) && !error.contains("contradicts"), "{error}");
        }
    }
}

/// Rod on a ball joint at the end of a crank, held by a ball at its other end; the pose is one in the plane of the
/// crank.
const ON_A_BALL: &str = r#"
name = "rod on a ball"
[inertial]
frame = "N"
origin = "O"
[parameters]
m = "1 kg"
L = "1 m"
J = "0.01 kg*m^2"
[bodies]
b1 = { mass = "m", inertia = { diagonal = ["J", "2*J", "2*J"] } }
b2 = { mass = "m", inertia = { diagonal = ["J", "2*J", "2*J"] } }
[joints]
j2 = { kind = "pin", body = "b2", axis = 3, centre = ["0.2*L", 0, 0] }
j1 = { kind = "ball", sequence = "SEQUENCE", body = "b1", to = "b2", at = ["0.4*L", 0, 0], centre = ["0.1*L", 0, 0] }
c = { kind = "ball", body = "b1", at = ["0.3*L", "0.4*L", 0], body_at = ["0.5*L", 0, 0] }
[assembly]
q_j2 = -0.2
"#;

/// Goal: a loop that holds the angles of a ball joint where they are singular is refused with their names. Method: with
/// the angles 313 the middle one is 0 in the plane, and the others turn about one axis; the angles 123 and Euler
/// parameters are regular there.
#[test]
fn singular_angles_of_a_joint_in_the_assembled_pose_are_named() {
    let text = |sequence: &str, values: &str| ON_A_BALL.replace("SEQUENCE", sequence) + values;
    let angles = "q_j1_1 = 1.1\nq_j1_2 = 0\nq_j1_3 = 0.8\n";
    let error = read(&text("313", angles)).err().unwrap().to_string();
    assert!(error.contains("do not determine the rates of `q_j1_1`, `q_j1_3` in the pose under `assembly`"), "{error}");
    assert!(error.contains("[assembly]") && !error.contains("not independent"), "{error}");
    for (sequence, values) in
        [("123", "q_j1_1 = 0\nq_j1_2 = 0\nq_j1_3 = 2\n"), ("euler", "q_j1_1 = 0.5\nq_j1_4 = 0.8\n")]
    {
        let model = load(&text(sequence, values));
        assert_eq!(model.speeds.len(), 1, "{sequence}");
    }
}

/// Goal: a planar loop with a pin that is tilted a little is refused with the gap that remains. Method: the pin between
/// coupler and rocker of a four-bar linkage, tilted by e = 1e-4 rad about the coupler: the end of the rocker leaves the
/// plane by a sin(e) sin(q), 1e-5 m, unless the rocker lies along the coupler.
#[test]
fn a_planar_loop_with_a_tilted_pin_tells_its_gap() {
    let joints = "j0 = { kind = \"pin\", body = \"b0\", axis = 3 }\nj1 = { kind = \"pin\", body = \"b1\", to = \"b0\", axis = 3, at = [\"a\", 0, 0] }\nj2 = { kind = \
                  \"pin\", body = \"b2\", to = \"b1\", axis = 3, at = [\"2*a\", 0, 0], turned = { sequence = \"1\", angles = [\"e\"] } }\nc = { kind = \"pin\", body = \"b2\", \
                  axis = 3, at = [\"1.8*a\", 0, 0], body_at = [\"a\", 0, 0] }\n[assembly]\nq_j0 = 1\nq_j1 = -1\nq_j2 = 1.5";
    let bodies = ["b1", "b2"]
        .map(|name| format!("{name} = {{ mass = \"m\", inertia = {{ diagonal = [\"J\", \"J\", \"J\"] }} }}\n"));
    let text = fixed_slides(joints, "a = \"0.25 m\"\ne = { unit = \"rad\", value = 1e-4 }");
    let error = read(&text.replace("[joints]", &(bodies.concat() + "[joints]"))).err().unwrap().to_string();
    assert!(error.contains("no pose with closed loops is near the values under `assembly`: `c_"), "{error}");
    assert!(
        error.contains("e-5 in the nearest pose that was found") && error.contains("do not fit exactly"),
        "{error}"
    );
}
