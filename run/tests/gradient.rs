//! Gradients by sweeps backwards, against closed forms, 32-digit differences, and derivatives carried forwards.

use crate::sensitivity::{FALL, GROUND, SPRING, elliptic, how, near, scene_of, spring};
use tripos::studies::sensitivity::gradient::Slope;
use tripos::{AccelerationSolution, DerivativeInstants, Gradient, Integrator, Overrides, Scene};
use tripos_sim::Method;

fn gradient(scene: &Scene, of: &str, how: &Overrides) -> Gradient {
    let found = scene.gradient(of, how).unwrap_or_else(|error| panic!("{of}: {error}"));
    assert!(found.missing().is_none() && found.run.failure().is_none(), "{:?} {:?}", found.missing(), found.slopes);
    found
}

fn by(found: &Gradient, name: &str) -> f64 {
    found.slope_by(name).unwrap().value
}

/// Truth: x = x₀ cos ω t + v₀/ω sin ω t with ω = √(k/m), where v₀ = x₀ω is a formula that k and m enter. Its
/// derivatives are taken with respect to all numbers, directly and through the start, by every method. Methods without
/// a sweep run by DOP853, and the result says so.
#[test]
fn a_spring_has_the_gradient_of_its_closed_form() {
    let (m, k, x0, t) = (2.0_f64, 8.0_f64, 0.5_f64, 3.0_f64);
    let w = (k / m).sqrt();
    let (s, c) = (w * t).sin_cos();
    let (dk, dm) = (w / (2.0 * k), -w / (2.0 * m));
    for method in Method::ALL {
        let more = if method == Method::Rk4 { "step = 1e-3" } else { "" };
        let tolerance = if method == Method::Rk4 { 1e-10 } else { 1e-9 };
        for formulation in ["kane", "lagrange"] {
            let scene = spring(method.name(), more);
            let of_x = gradient(&scene, "x", &how(Some(formulation)));
            let what = format!("{}, {formulation}", method.name());
            let names: Vec<&str> = of_x.slopes.iter().map(|slope| slope.by.as_str()).collect();
            assert_eq!(names, ["m", "k", "c", "x", "v"], "{what}");
            let dx = x0 * t * (c - s);
            for (name, truth) in [("k", dx * dk), ("m", dx * dm), ("c", 0.0), ("x", c), ("v", s / w)] {
                near(by(&of_x, name), truth, tolerance, &format!("{what}, d(x)/d({name})"));
                let slope = of_x.slope_by(name).unwrap();
                let (off, error) = ((slope.value - truth).abs(), slope.error.expect("a second run comes to the end"));
                assert!(off <= 30.0 * error + 1e-15, "{what}, {name}: {off:e} is said to be {error:e}");
            }
            assert_eq!(of_x.slope_by("k").unwrap().unit.as_deref(), Some("m*s^2/kg"));
            let is_other = of_x.run.notes.iter().any(|note| note.contains("the run is by dop853"));
            let is_swept = matches!(method, Method::Rk4 | Method::Ode45 | Method::Dopri5 | Method::Dop853);
            assert_eq!(is_other, !is_swept, "{what}: {:?}", of_x.run.notes);
            assert_eq!(of_x.scene.integration.method == method.into(), is_swept);
            assert!(!of_x.is_total);
        }
    }
    // Outputs that depend on the end directly: one that names k, an acceleration, an energy.
    let scene = spring("dop853", "");
    let (x, dx) = (x0 * (c + s), x0 * t * (c - s) * dk);
    near(by(&gradient(&scene, "k*x^2/2", &how(None)), "k"), x * x / 2.0 + k * x * dx, 1e-10, "an output");
    near(by(&gradient(&scene, "v'", &how(None)), "k"), -x / m - k / m * dx, 1e-10, "an acceleration");
    near(by(&gradient(&scene, "potential_energy", &how(None)), "x"), k * x * c, 1e-10, "an energy");
}

/// Truth: y = h − g t²/2 meets the ground at t = √(2h/g) with v = −√(2gh). The instant and the speed have total
/// derivatives; those of the place are zero.
#[test]
fn an_event_at_the_end_moves_with_every_number() {
    let (h, g, m) = (3.0_f64, 9.81_f64, 2.0_f64);
    let scene = scene_of(FALL, GROUND);
    let t = (2.0 * h / g).sqrt();
    let of_t = gradient(&scene, "t", &how(None));
    let of_v = gradient(&scene, "v", &how(None));
    let of_y = gradient(&scene, "y", &how(None));
    assert!(of_t.is_total && of_t.run.solution.stop.code() == "event:ground");
    assert_eq!(of_t.slope_by("y").unwrap().unit.as_deref(), Some("s/m"));
    for (name, in_t, in_v) in [
        ("g", -t / (2.0 * g), -(h / (2.0 * g)).sqrt()),
        ("y", t / (2.0 * h), -(g / (2.0 * h)).sqrt()),
        ("F", t / (2.0 * g) / m, (h / (2.0 * g)).sqrt() / m),
        ("v", 1.0 / g, 0.0),
        ("m", 0.0, 0.0),
    ] {
        near(by(&of_t, name), in_t, 1e-13, "the instant");
        near(by(&of_v, name), in_v, 1e-13, "the speed");
        near(by(&of_y, name), 0.0, 1e-13, "the place");
    }
}

/// Truth: from rest at θ₀ the lowest point is met at √(l/g) K(sin θ₀/2) with the rate −2 √(g/l) sin θ₀/2.
#[test]
fn a_quarter_of_the_period_of_a_pendulum_has_the_gradient_of_its_closed_form() {
    let model = include_str!("../../models/pendulum/model.toml");
    let text = include_str!("../../models/pendulum/scenes/swing.toml");
    let text = text.replace("rtol = 1e-9", "method = \"dop853\"\nrtol = 1e-12").replace("atol = 1e-11", "atol = 1e-13");
    let scene = scene_of(model, &text.replace("zero = \"sin(theta/2)\"", "zero = \"sin(theta/2)\"\nterminal = true"));
    let (l, g, half) = (1.0_f64, 9.81_f64, 1.0_f64);
    let k = half.sin();
    let (whole, second) = elliptic(k);
    let by_k = second / (k * (1.0 - k * k)) - whole / k;
    let found = gradient(&scene, "t", &how(None));
    let pace = (l / g).sqrt();
    for (name, truth) in [
        ("l", pace * whole / (2.0 * l)),
        ("g", -pace * whole / (2.0 * g)),
        ("theta", pace * by_k * 0.5 * half.cos()),
        ("m", 0.0),
    ] {
        near(by(&found, name), truth, 1e-11, name);
    }
    near(by(&gradient(&scene, "omega", &how(None)), "l"), k / (pace * l), 1e-11, "the rate there");
}

/// Goal: the disk over its ten seconds, in which it comes near lying flat five times. Truth: the derivatives in 32
/// digits that the forward ones are compared with. On the way derivatives reach some 1e8, so DOP853 leaves errors of
/// 2e-9 at the end.
#[test]
fn ten_seconds_of_the_disk_are_swept_to_eight_digits() {
    let model = include_str!("../../models/disk/model.toml");
    let text = include_str!("../../models/disk/scenes/report-tight.toml");
    let text = text.replace("\"ode45\"\nrtol = 1e-9\natol = 1e-11", "\"dop853\"\nrtol = 3e-14\natol = 1e-15");
    let scene = scene_of(model, &text);
    for (name, truths) in [("q2", [-8.785_134_948, 9.274_522_89]), ("u1", [34.774_362_43, -35.791_670_76])] {
        let found = gradient(&scene, name, &how(None));
        for (by, truth) in ["R", "q2'"].iter().zip(truths) {
            let slope = found.slope_by(by).unwrap();
            println!("d({name})/d({by}) = {} ± {:?}, {} states", slope.value, slope.error, found.states);
            near(slope.value, truth, 1e-8, &format!("d({name})/d({by})"));
            assert!((slope.value - truth).abs() <= slope.error.unwrap(), "{slope:?} {truth}");
        }
        assert!(found.states < 200, "{}", found.states);
    }
}

/// Goal: backward and forward derivatives agree. Method: models with loops, without, that roll, with Euler parameters,
/// in speeds and in rates, with time. One or two numbers at the end of each are differentiated by all numbers of its
/// scene. They agree within the stated errors, and within a part of the largest derivative relative to its number.
#[test]
fn library_models_have_the_gradients_that_derivatives_forwards_are() {
    for (folder, scene, span, of, formulation) in [
        ("four_bar", "turning", "span = [0, 1]", &["q1", "kinetic_energy"][..], "kane"),
        ("four_bar", "turning", "span = [0, 1]", &["q3"], "lagrange"),
        ("cartesian_pendulum", "released", "span = [0, 2]", &["x"], "lagrange"),
        ("satellite", "spin_up", "span = [0, 5]", &["w2"], "kane"),
        ("heavy_top", "looping", "", &["q1"], "kane"),
        ("furuta", "swing", "span = [0, 2]", &["theta2"], "kane"),
        ("knife_edge", "cycloid", "span = [0, 5]", &["x"], "kane"),
        ("rolling_disc", "roll", "span = [0, 2]", &["q2"], "kane"),
        ("driven_pendulum", "falling", "span = [0, 1]", &["q"], "kane"),
        ("puma560", "collapse", "span = [0, 0.3]", &["q3"], "kane"),
    ] {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(folder);
        let read = |path: String| std::fs::read_to_string(root.join(path)).unwrap();
        let text = read(format!("scenes/{scene}.toml"));
        let text: Vec<&str> =
            text.lines().map(|line| if line.starts_with("span") && !span.is_empty() { span } else { line }).collect();
        let scene = scene_of(&read("model.toml".to_owned()), &text.join("\n"));
        let how = Overrides {
            method: Some(Method::Dop853.into()),
            rtol: Some(1e-11),
            atol: Some(1e-12),
            ..how(Some(formulation))
        };
        for of in of {
            let found = gradient(&scene, of, &how);
            // If the start of a loop is not solved for, one number alone takes it off its constraints; forwards refuses
            // that.
            let (slopes, without): (Vec<&Slope>, Vec<&Slope>) = found.slopes.iter().partition(|s| s.missing.is_none());
            assert!(slopes.len() >= 4, "{folder}");
            assert!(
                without.iter().all(|slope| scene.sensitivities(&[&slope.by], DerivativeInstants::End, &how).is_err()),
                "{folder}"
            );
            let names: Vec<&str> = slopes.iter().map(|slope| slope.by.as_str()).collect();
            let forwards = scene.sensitivities(&names, DerivativeInstants::End, &how).unwrap();
            let place = forwards.names.iter().position(|name| name == of).unwrap();
            let errors = forwards.errors.as_ref().expect("a second run comes to the end");
            let largest = forwards.end.iter().fold(1.0, |most: f64, list| most.max(list[place].abs()));
            for (at, slope) in slopes.iter().enumerate() {
                let (truth, stated) = (forwards.end[at][place], errors[at][place] + slope.error.unwrap());
                let off = (slope.value - truth).abs();
                let what = format!("{folder}, {formulation}: d({of})/d({}) = {} and {truth}", slope.by, slope.value);
                assert!(off <= 10.0 * stated + 1e-13 * largest, "{what}: off by {off:e}, not {stated:e}");
                assert!(off <= 1e-7 * largest && stated <= 1e-6 * largest, "{what}: off by {off:e} ± {stated:e}");
                assert_eq!(slope.unit, forwards.units[at][place], "{what}");
            }
            assert_eq!(found.run.states, forwards.run.states, "{folder}: a run with a gradient is the run without");
        }
    }
}

/// Truth: a force that switches at T = d/c: x(t) = x₀ + v₀ t + a/m (−T²/2 − T(t − T) + (t − T)²/2), by all its numbers.
/// Also a force that bends there.
#[test]
fn a_switch_that_moves_counts_in_the_gradient() {
    let model = SPRING
        .replace(
            "c = { unit = \"kg*m^2\", value = 3 }",
            "c = { unit = \"1/s\", value = 4 }\na = { unit = \"N\", value = 3 }\nd = { unit = \"1\", value = 5 }",
        )
        .replace("\"-k*x\"", "\"a*sign(c*t - d)\"")
        .replace("k = { unit = \"N/m\", value = 8, positive = true }\n", "");
    let text = "model = \"model.toml\"\nspan = [0, 3]\n[start]\nx = 0.5\nv = -0.25\n[integration]\nmethod = \"dop853\"\nrtol = 1e-10\natol = 1e-10\n";
    let (m, a, c, d, end) = (2.0_f64, 3.0_f64, 4.0_f64, 5.0_f64, 3.0_f64);
    let at = d / c;
    let rest = end - at;
    let place = |t: f64| -t * t / 2.0 - t * (end - t) + (end - t) * (end - t) / 2.0;
    // Derivative d/dT of it: −T − (t − T) + T − (t − T).
    let by_switch = a / m * (-at - rest + at - rest);
    for method in ["dop853", "ode45"] {
        let scene = scene_of(&model, &text.replace("dop853", method));
        let found = gradient(&scene, "x", &how(None));
        for (name, truth) in [
            ("c", by_switch * -at / c),
            ("d", by_switch / c),
            ("a", place(at) / m),
            ("m", -a / (m * m) * place(at)),
            ("x", 1.0),
            ("v", end),
        ] {
            near(by(&found, name), truth, 1e-11, &format!("{method}: d(x)/d({name})"));
        }
    }
    // |c t − d| instead: v′ = a/m |c t − d|, so dx/dc = a/m ∫ (t − s) s sign(c s − d) ds.
    let bent = scene_of(&model.replace("a*sign(c*t - d)", "a*abs(c*t - d)"), text);
    let primitive = |s: f64| end * s * s / 2.0 - s * s * s / 3.0;
    near(by(&gradient(&bent, "x", &how(None)), "c"), a / m * (primitive(end) - 2.0 * primitive(at)), 1e-10, "a bend");
    // The switch at the end of the span moves into it or out of it. Numbers that move it have no derivative; others do.
    let ends = scene_of(&model, &text.replace("[0, 3]", "[0, 1.25]"));
    let found = ends.gradient("x", &how(None)).unwrap();
    let slope = found.slope_by("c").unwrap();
    assert!(slope.value.is_nan() && slope.missing.as_ref().is_some_and(|why| why.contains("out of it")), "{slope:?}");
    near(by(&found, "v"), 1.25, 1e-12, "by the speed");
    assert!(found.missing().is_none() && slope.error.is_none(), "the reason is known");
    assert!(
        found.run.warnings.iter().any(|warning| warning.contains("no derivative by `c`")),
        "{:?}",
        found.run.warnings
    );
}

/// Goal: values that were set in a scene count. Method: a spring with another stiffness, by the closed form.
#[test]
fn numbers_that_were_set_are_those_of_the_gradient() {
    let mut scene = spring("dop853", "");
    scene.set_number("k", 2.0).unwrap();
    let found = gradient(&scene, "x", &how(None));
    near(by(&found, "x"), 3.0_f64.cos(), 1e-10, "ω is 1");
}

/// Goal: scenes that cannot be swept are refused, with advice.
#[test]
fn what_has_no_gradient_is_refused() {
    let scene = scene_of(FALL, GROUND);
    let refused = |scene: &Scene, of: &str, how: &Overrides| match scene.gradient(of, how) {
        Err(error) => error.to_string(),
        Ok(_) => panic!("{of} is differentiated"),
    };
    let plain = Overrides::default();
    assert!(refused(&scene, "kinetic_enery", &plain).contains("did you mean `kinetic_energy`"));
    assert!(refused(&scene, "v", &how(Some("reduced"))).contains("full equations"));
    let solve = Overrides { solve: Some(AccelerationSolution::Numeric), ..plain.clone() };
    assert!(refused(&scene, "v", &solve).contains("eliminated"));
    let method = Overrides { method: Some(Integrator::Quadrature), ..plain.clone() };
    assert!(refused(&scene, "v", &method).contains("stepping method"));
    assert!(refused(&spring("dop853", ""), "t", &plain).contains("terminal event"));
    let found = scene.gradient("v", &plain).unwrap();
    assert!(found.slope_by("mm").unwrap_err().to_string().contains("did you mean `m`"));
}
