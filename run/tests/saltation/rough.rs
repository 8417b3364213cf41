//! Friction with slips, sticking, reversals and bounces at an angle.

use super::backwards::is_forwards;
use super::{Planted, Wide, how, largest_error, truth, wide};
use crate::friction::{BLOCK, FINE, on_plane};
use crate::impacts::{PLANE, scene as scene_of};
use crate::rough::feet;
use crate::sensitivity::near;
use tripos::{DerivativeInstants, Overrides, Scene};
use tripos_traits::{Real, Scalar};

/// Block on an incline with these parameters, from the place `x` with the velocity `vx`.
fn block(list: &[(&str, f64)], x: f64, vx: f64, span: f64) -> Scene {
    let parameters: Vec<String> = list.iter().map(|(name, value)| format!("{name} = {value:?}")).collect();
    scene_of(BLOCK, &on_plane(&parameters.join("\n"), x, vx, span))
}

/// Goal: a block that slides to rest, by all numbers that its path depends on, and the instant of its rest. Truth: x =
/// x₀ + v²/(2 a), t = v/a, with a = g (μ cos α − sin α), at 12 random points, by all formulations and most methods;
/// backwards likewise.
#[test]
fn a_block_that_slides_to_rest_is_differentiated_by_all_that_its_way_depends_on() {
    let mut planted = Planted(11);
    for case in 0..12 {
        let values = [
            planted.next(0.4, 0.8),
            planted.next(5.0, 12.0),
            planted.next(0.0, 0.25),
            planted.next(1.0, 3.0),
            planted.next(-1.0, 1.0),
        ];
        let [mu, g, alpha, v, x] = values;
        let way = if case % 3 == 2 { -1.0 } else { 1.0 };
        let scene = block(&[("mu", mu), ("g", g), ("alpha", way * alpha)], x, way * v, 4.0);
        let method = ["dop853", "ode45", "dopri5", "taylor", "gauss6", "radau5"][case % 6];
        let how = how(["kane", "lagrange", "newton-euler"][case % 3], method);
        let found = scene.sensitivities(&["mu", "g", "alpha", "vx", "x", "m"], DerivativeInstants::End, &how).unwrap();
        let closed = |numbers: &[Wide]| {
            let [mu, g, alpha, v, x, _] = numbers[..] else { panic!("six") };
            let (sine, cosine) = alpha.sin_cos();
            let a = g * (mu * cosine - wide(way) * sine);
            vec![x + wide(way) * v * v / (wide(2.0) * a), wide(0.0)]
        };
        let numbers = [mu, g, way * alpha, way * v, x, 2.0];
        let worst = largest_error(&found, &["x", "vx"], &numbers, &|numbers| {
            closed(&[&numbers[..3], &[wide(way) * numbers[3]], &numbers[4..]].concat())
        });
        assert!(worst < 1e-9, "{method}: {worst:e}");
        let rests = found.run.events().iter().position(|event| event.name == "plane sticks").expect("it rests");
        let moves = found.events[rests].as_ref().expect("the instant moves");
        let a = g * (mu * alpha.cos() - alpha.sin());
        for (at, truth) in [-v * g * alpha.cos() / (a * a), -v / (a * g)].into_iter().enumerate() {
            near(moves[at], truth, 1e-9, "the instant");
        }
        near(moves[3], way / a, 1e-9, "the instant by the speed");
        is_forwards(&scene, &["x", "vx"], &how);
    }
}

/// Goal: a slip that reverses is differentiated. Truth: a block thrown up an incline with v slows by u = g (sin α + μ
/// cos α), and slides back by b = g (sin α − μ cos α).
#[test]
fn a_block_that_comes_back_down_is_differentiated_through_its_turn() {
    let mut planted = Planted(5);
    for case in 0..8 {
        let values = [planted.next(0.1, 0.3), planted.next(5.0, 12.0), planted.next(0.4, 0.7), -planted.next(1.0, 3.0)];
        let [mu, g, alpha, v] = values;
        let scene = block(&[("mu", mu), ("g", g), ("alpha", alpha)], 0.0, v, 1.5);
        let how = how(["kane", "lagrange"][case % 2], ["dop853", "ode45"][case % 2]);
        let found = scene.sensitivities(&["mu", "g", "alpha", "vx", "m"], DerivativeInstants::End, &how).unwrap();
        assert!(found.run.events().iter().any(|event| event.name == "plane reverses"));
        let closed = |numbers: &[Wide]| {
            let [mu, g, alpha, v, _] = numbers[..] else { panic!("five") };
            let ((sine, cosine), half) = (alpha.sin_cos(), wide(0.5));
            let (up, back) = (g * (sine + mu * cosine), g * (sine - mu * cosine));
            let left = wide(1.5) + v / up;
            vec![-half * v * v / up + half * back * left * left, back * left]
        };
        let worst = largest_error(&found, &["x", "vx"], &[&values[..], &[2.0]].concat(), &closed);
        assert!(worst < 1e-9, "{values:?}: {worst:e}");
        is_forwards(&scene, &["x", "vx"], &how);
    }
}

/// Goal: a spring with friction is differentiated through its reversals to its place of rest. Truth: each half swing
/// takes 2 μ m g/k (J. P. Den Hartog, *Mechanical Vibrations*, 1956, § 8.2).
#[test]
fn a_spring_with_friction_is_differentiated_through_all_of_its_reversals() {
    let scene = block(&[("k", 8.0), ("mu", 0.1)], 2.1, 0.0, 9.0);
    let names = ["x", "mu", "g", "k", "m"];
    let found = scene.sensitivities(&names, DerivativeInstants::End, &Overrides::default()).unwrap();
    // Four half swings, an even number, end at x₀ − 8 δ.
    let closed = |numbers: &[Wide]| {
        let [x, mu, g, k, m] = numbers[..] else { panic!("five") };
        let step = mu * m * g / k;
        vec![x - wide(8.0) * step, wide(0.0)]
    };
    let worst = largest_error(&found, &["x", "vx"], &[2.1, 0.1, 10.0, 8.0, 2.0], &closed);
    assert!(worst < 1e-9, "{worst:e}");
    is_forwards(&scene, &["x"], &how("kane", "dop853"));
}

/// Goal: a sticking contact begins to slip where friction can no longer hold its spring. Truth, with δ = μ m g/k and ω²
/// = k/m: x = δ (1 − cos ωt) until vb, then at vb until δ, then δ + vb/ω sin ω(t − t₂).
#[test]
fn a_block_that_a_belt_takes_along_is_differentiated_by_when_its_spring_pulls_it_off() {
    let mut planted = Planted(21);
    for case in 0..6 {
        let values =
            [planted.next(0.15, 0.25), planted.next(7.0, 9.0), planted.next(0.4, 0.7), planted.next(9.0, 11.0), 2.0];
        let [mu, k, vb, g, _] = values;
        let scene = block(&[("mu", mu), ("k", k), ("vb", vb), ("g", g)], 0.0, 0.0, 2.0);
        let how = how(["kane", "lagrange"][case % 2], ["dop853", "ode45"][case % 2]);
        let found = scene.sensitivities(&["mu", "k", "vb", "g", "m"], DerivativeInstants::End, &how).unwrap();
        let names: Vec<&str> = found.run.events().iter().map(|event| event.name.as_str()).collect();
        assert_eq!(names, ["plane", "plane slips", "plane sticks", "plane slips"]);
        let closed = |numbers: &[Wide]| {
            let [mu, k, vb, g, m] = numbers[..] else { panic!("five") };
            let (delta, omega) = (mu * m * g / k, (k / m).sqrt());
            let first = (vb / (delta * omega)).asin() / omega;
            let second = first + delta * (omega * first).sin_cos().1 / vb;
            let (sine, cosine) = (omega * (wide(2.0) - second)).sin_cos();
            vec![delta + vb / omega * sine, vb * cosine, first, second]
        };
        let worst = largest_error(&found, &["x", "vx"], &values, &closed);
        for (by, list) in truth(&values, &closed).iter().enumerate() {
            for (event, truth) in found.events[2..].iter().zip(&list[2..]) {
                near(event.as_ref().expect("the instant moves")[by], *truth, 1e-8, "the instant");
            }
        }
        assert!(worst < 1e-8, "{values:?}: {worst:e}");
        is_forwards(&scene, &["x", "vx"], &how);
    }
}

/// A disk of radius 0.5 that is thrown to the floor from a height, with a spin.
fn disk(values: &[f64], law: &str, span: f64) -> Scene {
    let [mu, e, height, v, om] = values[..] else { panic!("five") };
    scene_of(
        PLANE,
        &format!(
            "span = [0, {span:?}]\n[parameters]\nI = 0.375\na = 0.5\nh = {mu:?}\ne = {e:?}\n[start]\nx = 0\ny = {:?}\nth = 0\nvx = {v:?}\nvy = 0\nom = {om:?}\n\
             [impacts.floor]\ngap = \"y - a\"\nrestitution = \"e\"\nfriction = \"h/a/2\"\nalong = \"vx + a*om\"\nlaw = \"{law}\"\n{FINE}",
            height + 0.5
        ),
    )
}

/// Closed form of the disk at an instant: place, speed and spin, and the impacts that stick. Along the slip G = 1/m +
/// a²/I, uncoupled from the normal. An impact takes μ (1 + e) of the closing speed, or all of the slip.
fn rolled(numbers: &[Wide], t: f64) -> (Vec<Wide>, Vec<bool>) {
    let [h, e, y, mut v, mut om, a, inertia, m, g] = numbers[..] else { panic!("nine") };
    let (mu, compliance) = (h / a / wide(2.0), wide(1.0) / m + a * a / inertia);
    let fall = (wide(2.0) * (y - a) / g).sqrt();
    let (mut x, mut from, mut next, mut speed) = (wide(0.0), wide(0.0), fall, g * fall);
    let mut sticks = Vec::new();
    while (next - wide(t)).to_f64() < 0.0 {
        assert!(sticks.len() < 20, "bounces accumulate before the end");
        x = x + v * (next - from);
        let slip = v + a * om;
        let (most, all) = (mu * m * (wide(1.0) + e) * speed, slip / compliance);
        let is_stuck = all.to_f64().abs() <= most.to_f64();
        let impulse = if is_stuck { all } else { most * wide(slip.to_f64().signum()) };
        sticks.push(is_stuck);
        (v, om) = (v - impulse / m, om - a * impulse / inertia);
        (from, speed) = (next, e * speed);
        next = from + wide(2.0) * speed / g;
    }
    (vec![x + v * (wide(t) - from), v, om], sticks)
}

/// Goal: impacts with friction, which slip or stick, one after the other. Truth: the closed form of a disk whose normal
/// and tangential impulses are uncoupled, at random points of both kinds, by both laws.
#[test]
fn a_disk_that_bounces_with_friction_is_differentiated_through_its_impacts() {
    let (mut planted, mut seen) = (Planted(33), [0, 0]);
    for case in 0..16 {
        let values = [
            planted.next(0.02, 0.15),
            planted.next(0.6, 0.9),
            planted.next(0.8, 1.5),
            planted.next(-2.0, 2.0),
            planted.next(-6.0, 6.0),
        ];
        let law = ["newton", "poisson"][case % 2];
        let scene = disk(&values, law, 1.25);
        let how = how(["kane", "lagrange", "newton-euler"][case % 3], ["dop853", "ode45"][case % 2]);
        let names = ["h", "e", "y", "vx", "om", "a", "I", "m", "g"];
        let found = scene.sensitivities(&names, DerivativeInstants::End, &how).unwrap_or_else(|e| panic!("{e}"));
        let numbers = [&values[..2], &[values[2] + 0.5], &values[3..], &[0.5, 0.375, 3.0, 9.81]].concat();
        let (_, sticks) = rolled(&numbers.iter().map(|x| wide(*x)).collect::<Vec<_>>(), 1.25);
        assert_eq!(found.run.impacts().len(), sticks.len(), "{values:?}");
        let slips = sticks.iter().filter(|sticks| !**sticks).count();
        (seen[0], seen[1]) = (seen[0] + slips, seen[1] + sticks.len() - slips);
        let worst = largest_error(&found, &["x", "vx", "om"], &numbers, &|numbers| rolled(numbers, 1.25).0);
        assert!(worst < 1e-9, "{law} {values:?}: {worst:e}");
        is_forwards(&scene, &["x", "om"], &how);
    }
    assert!(seen[0] > 5 && seen[1] > 5, "{seen:?}");
}

/// Goal: bounces with friction that accumulate, and then a slip that ends in rolling. Truth: the momentum that friction
/// takes is μ m g times the time of slipping, with or without bounces. So the disk rolls with the speed that its spin
/// about the place of contact had.
#[test]
fn a_disk_that_comes_to_roll_after_its_bounces_keeps_the_derivatives_of_its_spin() {
    let scene = disk(&[0.1, 0.5, 0.5, 4.0, 1.0], "newton", 6.0);
    let names = ["vx", "om", "h", "e", "y", "g"];
    let found = scene.sensitivities(&names, DerivativeInstants::End, &how("kane", "dop853")).unwrap();
    assert!(found.run.events().iter().any(|event| event.name == "floor sticks"), "{:?}", found.run.events());
    let share = 0.375 / (0.375 + 3.0 * 0.25);
    // Here v − I ω/(m a) is constant, and at the end v + a ω = 0.
    let of_v = 1.0 - share;
    let of_om = -share * 0.5;
    for (by, truth) in [("vx", of_v), ("om", of_om), ("h", 0.0), ("e", 0.0), ("y", 0.0), ("g", 0.0)] {
        near(found.derivative_of("vx", by).unwrap(), truth, 1e-8, by);
    }
    is_forwards(&scene, &["x", "vx"], &how("kane", "dop853"));
}

/// Goal: two feet of a block, which slip at one velocity, stop at one instant and then share the forces that hold the
/// block. Truth: a point mass, v²/(2 a) with a = g (μ cos α − sin α). There is no derivative by numbers that move one
/// foot away from the floor.
#[test]
fn a_block_on_two_feet_is_differentiated_to_its_rest_as_a_point_is() {
    let (model, text) = feet(0.5, 1.5, 1.5);
    let scene = scene_of(&model, &text);
    let how = how("kane", "dop853");
    let found = scene.sensitivities(&["vx", "g", "alpha", "m", "I", "x"], DerivativeInstants::End, &how).unwrap();
    assert!(found.run.events().iter().any(|event| event.name == "B sticks"), "{:?}", found.run.events());
    let closed = |numbers: &[Wide]| {
        let [v, g, alpha, _, _, x] = numbers[..] else { panic!("six") };
        let (sine, cosine) = alpha.sin_cos();
        vec![x + v * v / (wide(2.0) * g * (wide(0.5) * cosine - sine)), wide(0.0)]
    };
    let worst = largest_error(&found, &["x", "vx"], &[1.5, 9.81, 0.3, 3.0, 0.05, 0.0], &closed);
    assert!(worst < 1e-9, "{worst:e}");
    let lifted =
        scene.sensitivities(&["th"], DerivativeInstants::End, &how).unwrap().missing_derivative().unwrap_or_default();
    assert!(lifted.contains("is closed at the start, and `th` opens it"), "{lifted}");
    is_forwards(&scene, &["x", "vx"], &how);
}

/// Goal: a block that slips on one contact hits another, and slides back to rest. Truth: v₁² = v² − 2 μ g L at the
/// wall, and e² v₁²/(2 μ g) back from it, by all of them.
#[test]
fn a_block_that_slides_to_a_wall_and_back_is_differentiated() {
    let numbers = "k = { unit = \"1\", value = 0.75 }\nL = { unit = \"m\", value = 0.5 }";
    let model = BLOCK.replace("-k*x", "0").replace("k = { unit = \"N/m\", value = 0 }", numbers);
    for law in ["newton", "poisson"] {
        let contact = |name: &str, gap: &str, e: &str, more: &str| {
            format!("[impacts.{name}]\ngap = \"{gap}\"\nrestitution = \"{e}\"\nlaw = \"{law}\"\n{more}")
        };
        let plane = contact("plane", "z", "e", "friction = \"mu\"\nalong = \"vx\"\n");
        let wall = contact("wall", "L - x", "k", "");
        let text = format!(
            "span = [0, 2.5]\n[parameters]\nmu = 0.25\n[start]\nx = 0\nz = 0\nvx = 3\nvz = 0\n{plane}{wall}{FINE}"
        );
        let scene = scene_of(&model, &text);
        let how = how("kane", "dop853");
        let found = scene.sensitivities(&["mu", "g", "L", "k", "vx", "m"], DerivativeInstants::End, &how).unwrap();
        assert!(found.run.impacts().len() == 1 && found.run.events().iter().any(|event| event.name == "plane sticks"));
        let closed = |numbers: &[Wide]| {
            let [mu, g, length, e, v, _] = numbers[..] else { panic!("six") };
            let twice = wide(2.0) * mu * g;
            vec![length - e * e * (v * v - twice * length) / twice]
        };
        let worst = largest_error(&found, &["x"], &[0.25, 10.0, 0.5, 0.75, 3.0, 2.0], &closed);
        assert!(worst < 1e-9, "{law}: {worst:e}");
        is_forwards(&scene, &["x", "vx"], &how);
    }
}

/// Goal: where a contact is undecided there is no derivative by the deciding numbers, and the reason is given. Other
/// numbers have one.
#[test]
fn where_friction_is_undecided_there_is_no_derivative_by_what_decides_it() {
    let why = |scene: &Scene, by: &str| {
        let found = scene
            .sensitivities(&[by], DerivativeInstants::End, &Overrides::default())
            .unwrap_or_else(|e| panic!("{e}"));
        found.missing_derivative().unwrap_or_default()
    };
    let limit = scene_of(BLOCK, &on_plane("alpha = \"atan(0.5)\"\nmu = 0.5", 0.0, 0.0, 2.0));
    assert!(
        why(&limit, "mu").contains("at t = 0 s")
            || why(&limit, "mu").contains(
                "from t = 0 s on: whether the contact `plane` sticks or slips there depends on a small change of `mu`"
            ),
        "{}",
        why(&limit, "mu")
    );
    assert_eq!(why(&limit, "g"), "", "whatever g is, friction just suffices");
    let steep = block(&[("alpha", 0.5), ("mu", 0.2)], 0.0, 0.0, 1.0);
    let back = why(&steep, "vx");
    assert!(back.contains("the contact `plane` begins to slip from rest, at an instant that `vx` changes"), "{back}");
    assert_eq!(why(&steep, "mu"), "");
    // A slip that ends where friction just holds.
    let thrown = scene_of(BLOCK, &on_plane("alpha = \"atan(0.5)\"\nmu = 0.5", 0.0, -1.0, 2.0));
    let stops = why(&thrown, "alpha");
    assert!(
        stops.contains("from t = 0.1118")
            && stops.contains("`plane` sticks or slips there depends on a small change of `alpha`"),
        "{stops}"
    );
    let smooth = block(&[("mu", 0.0)], 0.0, 1.0, 1.0);
    let refused = smooth
        .sensitivities(&["mu"], DerivativeInstants::End, &Overrides::default())
        .err()
        .expect("0 has two sides")
        .to_string();
    assert!(refused.contains("changes the friction of the contact `plane` from 0 on"), "{refused}");
    is_forwards(&limit, &["x"], &Overrides::default());
    is_forwards(&steep, &["x"], &Overrides::default());
    is_forwards(&thrown, &["x"], &Overrides::default());
    is_forwards(&smooth, &["x"], &Overrides::default());
}

/// Goal: an impact whose friction just stops the slip, and two blocks that stop at one instant. There is no derivative
/// by numbers that part them, and one by the others.
#[test]
fn what_is_decided_together_has_no_derivative_by_what_parts_it() {
    let missing = |scene: &Scene, by: &str| {
        let found = scene
            .sensitivities(&[by], DerivativeInstants::End, &Overrides::default())
            .unwrap_or_else(|e| panic!("{e}"));
        found.missing_derivative().unwrap_or_default()
    };
    // It falls at 2 m/s, and μ (1 + e) of that is all of its 1.5 m/s.
    let text = on_plane("e = 0.5", 0.0, 1.5, 0.4).replace("\nz = 0", "\nz = 0.2");
    for law in ["newton", "poisson"] {
        let just = scene_of(BLOCK, &text.replace("friction = ", &format!("law = \"{law}\"\nfriction = ")));
        for by in ["vx", "mu", "g"] {
            let why = missing(&just, by);
            assert!(
                why.contains(&format!("a small change of `{by}` decides if contacts stick or slip in the impact")),
                "{why}"
            );
        }
        assert_eq!(missing(&just, "m"), "");
        is_forwards(&just, &["x", "vx"], &Overrides::default());
    }
    let point =
        |name: &str| format!("{name} = {{ from = \"O\", frame = \"N\", position = [\"x{name}\", 0, \"z{name}\"] }}\n");
    let of = |of: &dyn Fn(&str) -> String| of("A") + &of("B");
    let model = format!(
        "name = \"Two blocks\"\n[parameters]\nm = {{ unit = \"kg\", value = 1, positive = true }}\ng = {{ unit = \"m/s^2\", value = 10 }}\nmu = {{ unit = \"1\", value = 0.5 }}\n\
         [coordinates]\n{}[speeds]\n{}[inertial]\nframe = \"N\"\norigin = \"O\"\n[points]\n{}[particles]\n{}[gravity]\nframe = \"N\"\nacceleration = [0, 0, \"-g\"]\n\
         zero_at = {{ zA = 0, zB = 0 }}\n",
        of(&|name| format!("x{name} = {{ unit = \"m\" }}\nz{name} = {{ unit = \"m\" }}\n")),
        of(&|name| format!("v{name} = \"x{name}'\"\nw{name} = \"z{name}'\"\n")),
        of(&point),
        of(&|name| format!("block{name} = {{ point = \"{name}\", mass = \"m\" }}\n")),
    );
    let contact = |name: &str| {
        format!("[impacts.{name}]\ngap = \"z{name}\"\nrestitution = 0\nfriction = \"mu\"\nalong = \"v{name}\"\n")
    };
    let start = of(&|name| format!("x{name} = 0\nz{name} = 0\nv{name} = 1\nw{name} = 0\n"));
    let two = scene_of(&model, &format!("span = [0, 1]\n[start]\n{start}{}{FINE}", of(&contact)));
    let why = missing(&two, "vA");
    assert!(why.contains("slip or stick at one instant, which `vA` moves apart"), "{why}");
    let found = two.sensitivities(&["mu", "g"], DerivativeInstants::End, &Overrides::default()).unwrap();
    near(
        found.derivative_of("xA", "mu").unwrap(),
        -1.0 / (2.0 * 10.0 * 0.25),
        1e-10,
        "the way by the friction of both",
    );
    is_forwards(&two, &["xA"], &Overrides::default());
}

/// Goal: a run with derivatives equals the one without, bit by bit, through sticking, slipping and impacts with
/// friction.
#[test]
fn a_run_with_friction_and_derivatives_is_the_run_without() {
    for (scene, names) in [
        (block(&[("k", 8.0), ("mu", 0.1)], 2.1, 0.0, 9.0), ["mu", "k"]),
        (block(&[("k", 8.0), ("mu", 0.2), ("vb", 0.6)], 0.0, 0.0, 3.0), ["mu", "vb"]),
        (disk(&[0.1, 0.5, 0.5, 4.0, 1.0], "poisson", 3.0), ["h", "e"]),
    ] {
        for method in ["dop853", "ode45", "radau5"] {
            let how = how("kane", method);
            let all = scene.sensitivities(&names, DerivativeInstants::Samples, &how).unwrap();
            let plain = scene.simulate(&how).unwrap();
            assert_eq!(all.run.states, plain.states, "{method}");
            assert_eq!(all.run.solution.work, plain.solution.work, "{method}");
            assert_eq!((all.run.impacts(), all.run.events()), (plain.impacts(), plain.events()), "{method}");
        }
    }
}
