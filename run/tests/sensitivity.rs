//! Derivatives of runs against closed forms and against differences in 32 digits.

use tripos::code::{CodePreparation, runnable_code};
use tripos::{
    AccelerationSolution, DerivativeInstants, Integrator, Mechanism, Overrides, Problem, Scene, Sensitivities,
};
use tripos_derive::Formulation;
use tripos_derive::diagnostic::Source;
use tripos_sim::{EliminatedDynamics, Method, Options, OutputOption, integrate};
use tripos_traits::{DoubleDouble, Real, Scalar};

/// A mass on a spring, started with the speed that it has where the spring is at rest.
pub const SPRING: &str = r#"
name = "Mass on a spring"
[parameters]
m = { unit = "kg", value = 2, positive = true }
k = { unit = "N/m", value = 8, positive = true }
c = { unit = "kg*m^2", value = 3 }
[coordinates]
x = { unit = "m" }
[speeds]
v = "x'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", 0, 0] }
[particles]
b = { point = "P", mass = "m" }
[forces.spring]
on = "b"
frame = "N"
vector = ["-k*x", 0, 0]
"#;

/// A body that falls until it meets the ground, pushed by an input that is a number.
pub const FALL: &str = r#"
name = "Fall"
[parameters]
m = { unit = "kg", value = 2, positive = true }
g = { unit = "m/s^2", value = 9.81, positive = true }
[inputs]
F = { unit = "N" }
[coordinates]
y = { unit = "m" }
[speeds]
v = "y'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = [0, "y", 0] }
[particles]
b = { point = "P", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
[forces.push]
on = "b"
frame = "N"
vector = [0, "F", 0]
"#;

pub const GROUND: &str = r#"
model = "model.toml"
span = [0, 10]
[start]
y = 3
v = 0
[inputs]
F = 0
[integration]
method = "dop853"
rtol = 1e-12
atol = 1e-12
[[events]]
name = "ground"
zero = "y"
direction = "falling"
terminal = true
"#;

pub fn scene_of(model: &str, scene: &str) -> Scene {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", model)).unwrap_or_else(|e| panic!("{e}"));
    Scene::parse(Mechanism::new(model), scene).unwrap_or_else(|e| panic!("{e}"))
}

pub fn spring(method: &str, more: &str) -> Scene {
    let text = format!(
        "model = \"model.toml\"\nspan = [0, 3]\noutputs = [\"x\", \"v\", \"k*x^2/2\", \"v'\"]\n[start]\nx = 0.5\nv = \"x0*sqrt(k/m)\"\n\
         [integration]\nmethod = \"{method}\"\nrtol = 1e-12\natol = 1e-12\n{more}"
    );
    scene_of(SPRING, &text.replace("x0", "0.5"))
}

pub fn how(by: Option<&str>) -> Overrides {
    Overrides { by: by.map(Into::into), ..Overrides::default() }
}

pub fn near(found: f64, truth: f64, tolerance: f64, what: &str) {
    let off = (found - truth).abs() / truth.abs().max(1.0);
    assert!(off <= tolerance, "{what}: {found:e}, not {truth:e}, off by {off:.1e}");
}

/// Truth: x = x₀ (cos ω t + sin ω t) with ω = √(k/m), where the start states v by ω. Derivatives are by k, directly and
/// through the start, by x₀ at constant v, and by numbers without effect. Every method, Kane and Lagrange.
#[test]
fn a_spring_has_the_derivatives_of_its_closed_form() {
    let (m, k, x0, t) = (2.0_f64, 8.0_f64, 0.5_f64, 3.0_f64);
    let w = (k / m).sqrt();
    let (s, c) = (w * t).sin_cos();
    for method in Method::ALL {
        let more = if method == Method::Rk4 { "step = 1e-3" } else { "" };
        // Implicit methods of order 5 and 6 run at tolerances for which they take at most a few thousand steps.
        let tolerance = match method {
            Method::Rk4 => 1e-10,
            Method::Radau5 => 1e-7,
            _ => 1e-9,
        };
        for by in ["kane", "lagrange"] {
            let found = spring(method.name(), more)
                .sensitivities(&["k", "x", "c"], DerivativeInstants::End, &how(Some(by)))
                .unwrap();
            let check = |name: &str, by: &str, truth: f64| {
                near(
                    found.derivative_of(name, by).unwrap(),
                    truth,
                    tolerance,
                    &format!("{}, d({name})/d({by})", method.name()),
                );
            };
            let dw = w / (2.0 * k);
            // Derivative dx/dk = x₀ t (cos ω t − sin ω t) dω/dk.
            let (x, dx) = (x0 * (c + s), x0 * t * (c - s) * dw);
            check("x", "k", dx);
            check("v", "k", x0 * (c - s) * dw - x0 * w * t * (c + s) * dw);
            check("k*x^2/2", "k", x * x / 2.0 + k * x * dx);
            check("v'", "k", -x / m - k / m * dx);
            check("x", "x", c);
            check("v", "x", -w * s);
            check("kinetic_energy", "x", m * x0 * w * (c - s) * -w * s);
            check("potential_energy", "x", k * x * c);
            check("x", "c", 0.0);
            assert!(found.run.notes.iter().any(|note| note.contains("depends on `c`")), "{:?}", found.run.notes);
            let errors = found.errors.as_ref().expect("a second run comes to the end");
            let off = (found.derivative_of("x", "k").unwrap() - dx).abs();
            assert!(off <= 20.0 * errors[0][0], "{}: {off:e} is said to be {:e}", method.name(), errors[0][0]);
            assert_eq!(found.units[0][0].as_deref(), Some("m*s^2/kg"), "{:?}", found.units);
        }
    }
}

/// Truth: y = h − g t²/2, so the ground is met at t = √(2h/g) with v = −√(2gh). The place of the impact depends on no
/// number.
#[test]
fn an_impact_has_the_total_derivatives_of_its_instant_and_speed() {
    let (h, g, m) = (3.0_f64, 9.81_f64, 2.0_f64);
    let found = scene_of(FALL, GROUND).sensitivities(&["g", "y", "F"], DerivativeInstants::End, &how(None)).unwrap();
    let t = (2.0 * h / g).sqrt();
    assert_eq!(found.run.solution.stop.code(), "event:ground");
    for (at, (of_t, of_v)) in [
        (-t / (2.0 * g), -(h / (2.0 * g)).sqrt()),
        (t / (2.0 * h), -(g / (2.0 * h)).sqrt()),
        (t / (2.0 * g) / m, (h / (2.0 * g)).sqrt() / m),
    ]
    .into_iter()
    .enumerate()
    {
        near(found.t_end[at], of_t, 1e-13, "the instant");
        near(found.end[at][1], of_v, 1e-13, "the speed");
        near(found.end[at][0], 0.0, 1e-13, "the place");
        assert_eq!(found.events, [Some(found.t_end.clone())]);
    }
}

/// Elliptic integrals K(k) and E(k) by arithmetic and geometric means. M. Abramowitz & I. A. Stegun (1964), §17.6.
pub fn elliptic(k: f64) -> (f64, f64) {
    let (mut a, mut b, mut c, mut sum, mut power) = (1.0_f64, (1.0 - k * k).sqrt(), k, k * k / 2.0, 0.5);
    while c.abs() > 1e-17 {
        (a, b, c) = (f64::midpoint(a, b), (a * b).sqrt(), (a - b) / 2.0);
        power *= 2.0;
        sum += power * c * c;
    }
    let whole = std::f64::consts::FRAC_PI_2 / a;
    (whole, whole * (1.0 - sum))
}

/// Truth: the n-th passage of the lowest point is at (2n + 1) √(l/g) K(sin θ₀/2). Its derivatives belong to events that
/// do not end the run.
#[test]
fn the_period_of_a_pendulum_has_the_derivatives_of_its_closed_form() {
    let model = include_str!("../../models/pendulum/model.toml");
    let text = include_str!("../../models/pendulum/scenes/swing.toml");
    let text = text.replace("rtol = 1e-9", "method = \"dop853\"\nrtol = 1e-12").replace("atol = 1e-11", "atol = 1e-13");
    let found =
        scene_of(model, &text).sensitivities(&["l", "theta", "m"], DerivativeInstants::End, &how(None)).unwrap();
    let (l, g, k) = (1.0_f64, 9.81_f64, 1.0_f64.sin());
    let (whole, second) = elliptic(k);
    let by_k = second / (k * (1.0 - k * k)) - whole / k;
    assert_eq!(found.events.len(), 8);
    for (at, list) in found.events.iter().enumerate() {
        let times = f64::from(u8::try_from(2 * at + 1).unwrap()) * (l / g).sqrt();
        let list = list.as_ref().expect("the lowest point is passed");
        near(list[0], times * whole / (2.0 * l), 1e-10, "by the length");
        near(list[1], times * by_k * 0.5 * 1.0_f64.cos(), 1e-10, "by the start");
        near(list[2], 0.0, 0.0, "by the mass");
    }
}

/// Shown values of a scene at its end in 32 digits, by Kane's equations and DOP853.
fn end(scene: &Scene, tolerance: f64) -> Vec<DoubleDouble> {
    let by = Formulation::Kane.into();
    let code = runnable_code(scene.mechanism(), &by, None, CodePreparation::Solved).unwrap();
    let problem = Problem::new(scene.mechanism(), scene.description(), &by, &code, None).unwrap();
    let (p, y0) = problem.extended_start().unwrap();
    let options =
        Options { method: Method::Dop853, output: OutputOption::Ends, ..Options::tolerances(tolerance, tolerance) };
    let rhs = EliminatedDynamics::new(code.extended(), &p).unwrap();
    let span = scene.description().span;
    let solution = integrate(rhs, span, &y0, &problem.run_options(&options), &mut []).unwrap();
    assert!(!solution.stop.is_failure(), "{solution}");
    problem.extended_state(&p, span.1, &solution.y_end)
}

/// Derivatives of the states at the end by a number with this `value`, as differences of order 4 with steps of 2⁻ᵇ.
fn differences(scene: &Scene, name: &str, value: f64, step: f64, tolerance: f64) -> Vec<f64> {
    let at = |place: f64| {
        let mut scene = scene.clone();
        // The decimal number itself is set, not the double nearest to the sum.
        scene.set_number(name, format!("{:.12e}", value + place * step).parse().unwrap()).unwrap();
        end(&scene, tolerance)
    };
    let list: Vec<_> = [(-2.0, 1), (-1.0, -8), (1.0, 8), (2.0, -1)].map(|(place, weight)| (at(place), weight)).into();
    // The set value is a decimal number, so the step is one as well.
    let twelve = DoubleDouble::decimal(&format!("{step:e}")) * DoubleDouble::int(12);
    let sum = |at: usize| {
        let terms = list.iter().map(|(values, weight)| values[at] * DoubleDouble::int(*weight));
        terms.fold(DoubleDouble::int(0), |sum, term| sum + term)
    };
    (0..list[0].0.len()).map(|at| (sum(at) / twelve).to_f64()).collect()
}

/// Largest error of derivatives, relative to their size or 1, whichever is larger, against differences of 32-digit
/// runs.
fn against_differences(scene: &Scene, numbers: &[(&str, f64)], step: f64, by: Option<&str>) -> f64 {
    let names: Vec<&str> = numbers.iter().map(|(name, _)| *name).collect();
    let found: Sensitivities = scene.sensitivities(&names, DerivativeInstants::End, &how(by)).unwrap();
    assert!(found.missing_derivative().is_none() && found.run.failure().is_none(), "{:?}", found.run.objections());
    let stated = found.errors.as_ref().expect("a second run comes to the end");
    let mut worst = 0.0_f64;
    for ((own, stated), number) in found.end.iter().zip(stated).zip(numbers) {
        let truth = differences(scene, number.0, number.1, step, 1e-21);
        for (((own, stated), truth), name) in own.iter().zip(stated).zip(&truth).zip(&found.names) {
            let (off, size) = ((own - truth).abs(), truth.abs().max(1.0));
            println!("d({name})/d({}) = {own:e} ± {stated:.1e}, by differences {truth:e}: off by {off:.1e}", number.0);
            assert!(off <= 30.0 * stated + 1e-14 * size, "d({name})/d({}) is off by {off:e}, not {stated:e}", number.0);
            worst = worst.max(off / size);
        }
    }
    worst
}

/// Goal: the disk of the course report over its ten seconds, in which it comes near lying flat five times. Derivatives
/// are by its radius, which its start does not mention, and by the rate of its lean.
///
/// On the way the derivatives of the contact point reach some 1e8, of which doubles leave a millionth at the end. The
/// error is compared with the stated one. The lean is differentiated to nine digits.
#[test]
fn ten_seconds_of_the_disk_are_differentiated_as_well_as_is_stated() {
    let model = include_str!("../../models/disk/model.toml");
    let text = include_str!("../../models/disk/scenes/report-tight.toml");
    let text = text.replace("\"ode45\"\nrtol = 1e-9\natol = 1e-11", "\"taylor\"\nrtol = 3e-14\natol = 1e-14");
    let scene = scene_of(model, &text);
    let numbers = [("R", 1.0), ("q2'", -0.1)];
    against_differences(&scene, &numbers, 1e-5, None);
    let found = scene.sensitivities(&["R", "q2'"], DerivativeInstants::End, &how(None)).unwrap();
    for (name, truths) in [("q2", [-8.785_134_948, 9.274_522_89]), ("u1", [34.774_362_43, -35.791_670_76])] {
        for (by, truth) in ["R", "q2'"].iter().zip(truths) {
            near(found.derivative_of(name, by).unwrap(), truth, 1e-9, &format!("d({name})/d({by})"));
        }
    }
}

/// Goal: a closed loop, whose start is solved for, by a length, a mass and the angle of the crank, by equations in
/// speeds and in rates.
#[test]
fn a_four_bar_linkage_is_differentiated_on_its_loop() {
    let model = include_str!("../../models/four_bar/model.toml");
    let text = include_str!("../../models/four_bar/scenes/turning.toml");
    let text = text.replace("rtol = 1e-10\natol = 1e-12", "method = \"dop853\"\nrtol = 1e-13\natol = 1e-14");
    let text = text.replace("span = [0, 3]", "span = [0, 1]");
    let scene = scene_of(model, &text);
    for by in ["kane", "lagrange"] {
        let worst = against_differences(&scene, &[("a", 0.3), ("mb", 2.0), ("q1", 0.5)], 1e-6, Some(by));
        assert!(worst < 1e-10, "{by}: {worst:e}");
    }
}

/// Goal: attitude by Euler parameters, kept at length 1.
#[test]
fn a_satellite_is_differentiated_with_euler_parameters() {
    let model = include_str!("../../models/satellite/model.toml");
    let text = include_str!("../../models/satellite/scenes/spin_up.toml");
    let text = text.replace("rtol = 1e-11\natol = 1e-13", "method = \"dop853\"\nrtol = 1e-13\natol = 1e-14");
    let scene = scene_of(model, &text.replace("span = [0, 60]", "span = [0, 10]"));
    let worst = against_differences(&scene, &[("J", 0.5), ("w1", 0.1)], 1e-5, None);
    assert!(worst < 1e-10, "{worst:e}");
}

/// Goal: explicit time is differentiated, by the frequency and the amplitude of the drive.
#[test]
fn a_driven_pendulum_is_differentiated_by_its_drive() {
    let model = include_str!("../../models/driven_pendulum/model.toml");
    let text = include_str!("../../models/driven_pendulum/scenes/upright.toml");
    let text = text.replace("rtol = 1e-10\natol = 1e-12", "rtol = 1e-13\natol = 1e-14").replace("[0, 5]", "[0, 1]");
    let scene = scene_of(model, &text.replace("\"175*deg\"", "3"));
    let worst = against_differences(&scene, &[("w", 200.0), ("a", 0.02), ("q", 3.0)], 1e-6, None);
    // Steps follow only the errors of states. A number that sets a pace changes the states more, the later it is.
    assert!(worst < 1e-9, "{worst:e}");
}

/// Goal: derivatives do not change the run. Method: all samples of the same run, bit by bit. Six numbers at once, which
/// take two passes, are compared with each alone.
#[test]
fn a_run_with_derivatives_is_the_run_without_and_each_is_what_it_is_alone() {
    let model = include_str!("../../models/four_bar/model.toml");
    let text = include_str!("../../models/four_bar/scenes/turning.toml").replace("[0, 3]", "[0, 0.5]");
    let scene = scene_of(model, &text);
    for method in ["ode45", "dop853", "taylor"] {
        let how = Overrides { method: Some(method.parse().unwrap()), by: Some("kane".into()), ..Overrides::default() };
        let names = ["a", "b", "c", "d", "ma", "q1"];
        let all = scene.sensitivities(&names, DerivativeInstants::Samples, &how).unwrap();
        let plain = scene.simulate(&how).unwrap();
        assert_eq!(all.run.states, plain.states, "{method}");
        assert_eq!(all.run.solution.t, plain.solution.t, "{method}");
        let last = all.samples.iter().map(|list| list.last().unwrap().clone()).collect::<Vec<_>>();
        assert_eq!(last, all.end, "{method}: the last sample is the end");
        for (at, name) in names.iter().enumerate() {
            let alone = scene.sensitivities(&[name], DerivativeInstants::End, &how).unwrap();
            for (one, many) in alone.end[0].iter().zip(&all.end[at]) {
                near(*one, *many, 1e-13, name);
            }
        }
    }
}

/// Goal: scenes that cannot be differentiated are refused, with advice.
#[test]
fn what_cannot_be_differentiated_is_refused() {
    let scene = scene_of(FALL, GROUND);
    let refused = |names: &[&str], how: &Overrides| match scene.sensitivities(names, DerivativeInstants::End, how) {
        Err(error) => error.to_string(),
        Ok(_) => panic!("{names:?} is differentiated by"),
    };
    let plain = Overrides::default();
    assert!(refused(&["mm"], &plain).contains("did you mean `m`"), "{}", refused(&["mm"], &plain));
    assert!(refused(&["g", "g"], &plain).contains("named twice"));
    assert!(refused(&[], &plain).contains("nothing to differentiate by"));
    let by = |by: &str| Overrides { by: Some(by.into()), ..Overrides::default() };
    assert!(refused(&["g"], &by("reduced")).contains("full equations"));
    let solve = Overrides { solve: Some(AccelerationSolution::Numeric), ..Overrides::default() };
    assert!(refused(&["g"], &solve).contains("eliminated"));
    let method = Overrides { method: Some(Integrator::Quadrature), ..Overrides::default() };
    assert!(refused(&["g"], &method).contains("stepping method"));
}
