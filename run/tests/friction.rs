//! Coulomb friction at contacts, against closed forms and equations written out in the tests themselves.

use crate::impacts::{PLANE, end, near, run, scene};
use tripos::{Overrides, Run};
use tripos_sim::Kind;

/// A block on a plane that is tilted by alpha, with a spring along it.
pub const BLOCK: &str = r#"
name = "Block on an incline"
[parameters]
m = { unit = "kg", value = 2, positive = true }
g = { unit = "m/s^2", value = 10 }
alpha = { unit = "rad", value = 0 }
k = { unit = "N/m", value = 0 }
mu = { unit = "1", value = 0.5 }
e = { unit = "1", value = 0 }
vb = { unit = "m/s", value = 0 }
[coordinates]
x = { unit = "m" }
z = { unit = "m" }
[speeds]
vx = "x'"
vz = "z'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", 0, "z"] }
[particles]
block = { point = "P", mass = "m" }
[gravity]
frame = "N"
acceleration = ["g*sin(alpha)", 0, "-g*cos(alpha)"]
zero_at = { x = 0, z = 0 }
[forces.spring]
on = "block"
frame = "N"
vector = ["-k*x", 0, 0]
"#;

pub const FINE: &str = "[integration]\nmethod = \"dop853\"\nrtol = 1e-12\natol = 1e-13\n";

/// A scene of the block on its plane, with these parameters, from the place `x` with the velocity `vx`.
pub fn on_plane(parameters: &str, x: f64, vx: f64, span: f64) -> String {
    format!(
        "span = [0, {span:?}]\n[parameters]\n{parameters}\n[start]\nx = {x:?}\nz = 0\nvx = {vx:?}\nvz = 0\n[impacts.plane]\ngap = \"z\"\n\
         restitution = \"e\"\nfriction = \"mu\"\nalong = \"v(P) @ N [1] - vb\"\n{FINE}"
    )
}

/// Name of an event, and its instant, s; `None` for an event that holds from the start.
type EventAt<'r> = (&'r str, Option<f64>);

/// Events of a run.
pub fn events(run: &Run) -> Vec<EventAt<'_>> {
    let of = |event: &tripos_sim::EventRecord| (event.kind != Kind::AtStart).then_some(event.t);
    run.events().iter().map(|event| (event.name.as_str(), of(event))).collect()
}

pub fn happens(run: &Run, truth: &[EventAt<'_>]) {
    let found = events(run);
    let alike = |(a, b): (&EventAt<'_>, &EventAt<'_>)| {
        a.0 == b.0 && a.1.is_some() == b.1.is_some() && near(a.1.unwrap_or(0.0), b.1.unwrap_or(0.0), 1e-10)
    };
    assert!(found.len() == truth.len() && found.iter().zip(truth).all(alike), "{found:?} for {truth:?}");
}

pub fn keeps_energy(run: &Run, within: f64) {
    assert!(run.energy_drift.unwrap() < within, "{:?}", run.energy_drift);
}

/// Goal: a block slides where tan α > μ, and else stops and stays. Truth: x'' = g (sin α − μ cos α) down the plane; by
/// every kind of equations and method.
#[test]
fn a_block_slides_on_a_steep_plane_and_stops_on_a_flat_one() {
    let (alpha, g) = (0.3_f64, 10.0);
    let along = |mu: f64| g * (alpha.sin() - mu * alpha.cos());
    for by in ["kane", "lagrange", "newton-euler"] {
        for method in ["dop853", "gauss6", "taylor", "ode45"] {
            let how = Overrides { by: Some(by.into()), method: Some(method.parse().unwrap()), ..Overrides::default() };
            let go = |mu: f64, vx: f64| {
                let text = on_plane(&format!("alpha = 0.3\nmu = {mu:?}"), 0.0, vx, 2.0);
                let run = scene(BLOCK, &text).simulate(&how).unwrap_or_else(|e| panic!("{by} {method}: {e}"));
                assert!(run.objections().is_empty(), "{by} {method}: {:?}", run.objections());
                keeps_energy(&run, 1e-10);
                run
            };
            let slides = go(0.2, 0.0);
            happens(&slides, &[("plane", None), ("plane slips", None)]);
            assert!(near(end(&slides, "x"), 2.0 * along(0.2), 1e-10) && end(&slides, "z").abs() < 1e-14);
            let stays = go(0.5, 0.0);
            happens(&stays, &[("plane", None), ("plane sticks", None)]);
            assert!(end(&stays, "x").abs() < 1e-15 && end(&stays, "vx").abs() < 1e-15, "{:?}", stays.end);
            let stops = go(0.5, 3.0);
            happens(&stops, &[("plane", None), ("plane slips", None), ("plane sticks", Some(-3.0 / along(0.5)))]);
            assert!(near(end(&stops, "x"), -4.5 / along(0.5), 1e-10) && end(&stops, "vx").abs() < 1e-15);
            // All of its kinetic energy, and that of its fall, becomes work of friction.
            let fallen = 2.0 * g * alpha.sin() * end(&stops, "x");
            assert!(near(stops.solution.work_end, -9.0 - fallen, 1e-9), "{}", stops.solution.work_end);
        }
    }
}

/// Goal: thrown up a plane, a block stops where friction holds it, and comes back where it does not. Truth: on the way
/// up it slows by g (sin α + μ cos α).
#[test]
fn a_block_thrown_up_stops_or_comes_back() {
    let (alpha, g) = (0.3_f64, 10.0);
    for (mu, word) in [(0.5, "plane sticks"), (0.2, "plane reverses")] {
        let run = run(BLOCK, &on_plane(&format!("alpha = 0.3\nmu = {mu:?}"), 0.0, -3.0, 1.5));
        let up = g * (alpha.sin() + mu * alpha.cos());
        let top = 3.0 / up;
        happens(&run, &[("plane", None), ("plane slips", None), (word, Some(top))]);
        let back = if mu < alpha.tan() { g * (alpha.sin() - mu * alpha.cos()) } else { 0.0 };
        let left = 1.5 - top;
        assert!(near(end(&run, "x"), -4.5 / up + 0.5 * back * left * left, 1e-10), "{mu}: {:?}", run.end);
        assert!(near(end(&run, "vx"), back * left, 1e-10));
        keeps_energy(&run, 1e-10);
        assert!(
            run.digits.as_ref().unwrap().digits_at_end_least().unwrap() > 8.0,
            "{:?}",
            run.digits.as_ref().unwrap().digits_at_end_least()
        );
    }
}

/// Goal: friction holds where it can just bear a force. Truth: μ = tan α, to the rounding of both.
#[test]
fn friction_that_just_suffices_holds() {
    let run = run(BLOCK, &on_plane("alpha = \"atan(0.5)\"\nmu = 0.5", 0.0, 0.0, 2.0));
    happens(&run, &[("plane", None), ("plane sticks", None)]);
    assert!(end(&run, "x").abs() < 1e-15, "{:?}", run.end);
}

/// Goal: the amplitude of a spring with Coulomb friction shrinks by 2 μ m g/k each half period. It stays where the
/// spring no longer overcomes friction. Truth: half periods of π √(m/k) about ± μ m g/k (J. P. Den Hartog, *Mechanical
/// Vibrations*, 1956, § 8.2).
#[test]
fn a_spring_with_friction_swings_less_by_equal_parts_and_stays() {
    let (k, mu) = (8.0, 0.1);
    let step = mu * 2.0 * 10.0 / k;
    let half = std::f64::consts::PI / 2.0;
    let run = run(BLOCK, &on_plane("k = 8\nmu = 0.1", 2.1, 0.0, 9.0));
    let (mut x, mut t, mut truth) = (2.1_f64, 0.0, vec![("plane", None), ("plane slips", None)]);
    while x.abs() > step {
        (x, t) = (-(x - 2.0 * step * x.signum()), t + half);
        truth.push((if x.abs() > step { "plane reverses" } else { "plane sticks" }, Some(t)));
    }
    assert_eq!(truth.len(), 6);
    happens(&run, &truth);
    assert!(near(end(&run, "x"), x, 1e-10) && end(&run, "vx").abs() < 1e-14, "{:?} for {x}", run.end);
    keeps_energy(&run, 1e-9);
}

/// Goal: a block on a moving belt slips until it has the belt's speed, and sticks until its spring pulls it off. The
/// belt's work is accounted for. Truth, with δ = μ m g/k and ω² = k/m: x = δ (1 − cos ωt) until vb, then at vb until δ,
/// then δ + vb/ω sin ω(t − t₂).
#[test]
fn a_block_on_a_belt_slips_sticks_and_slips_again() {
    let (delta, omega, vb) = (0.5_f64, 2.0_f64, 0.6_f64);
    let first = (vb / (delta * omega)).asin() / omega;
    let second = first + delta * (omega * first).cos() / vb;
    let span = second + 1.5;
    let run = run(BLOCK, &on_plane("k = 8\nmu = 0.2\nvb = 0.6", 0.0, 0.0, span));
    happens(
        &run,
        &[("plane", None), ("plane slips", None), ("plane sticks", Some(first)), ("plane slips", Some(second))],
    );
    assert!(near(end(&run, "x"), delta + vb / omega * (omega * 1.5).sin(), 1e-10), "{:?}", run.end);
    keeps_energy(&run, 1e-10);
}

/// A disk of radius a on the floor, thrown with a spin.
fn disk(inertia: f64, vx: f64, om: f64, span: f64) -> String {
    format!(
        "span = [0, {span:?}]\n[parameters]\nI = {inertia:?}\na = 0.5\n[start]\nx = 0\ny = 0.5\nth = 0\nvx = {vx:?}\nvy = 0\nom = {om:?}\n\
         [impacts.floor]\ngap = \"y - a\"\nrestitution = 0\nfriction = 0.25\nalong = \"vx + a*om\"\n{FINE}"
    )
}

/// Goal: a disk that is thrown with backspin slips, then rolls. Truth: the slip s = v + R ω shrinks by μ g (1 + m
/// R²/I). So a disk rolls after s/(3 μ g), a sphere after 2 s/(7 μ g), and v has then lost μ g t. Enough backspin
/// brings it back.
#[test]
fn a_disk_with_backspin_slips_then_rolls() {
    for (part, vx, om) in [(0.5, 4.0, 0.0), (0.5, 2.0, 14.0), (0.4, 4.0, 3.0)] {
        let slip = vx + 0.5 * om;
        let t = slip / (0.25 * 9.81 * (1.0 + 1.0 / part));
        let run = run(PLANE, &disk(part * 3.0 * 0.25, vx, om, t + 1.0));
        happens(&run, &[("floor", None), ("floor slips", None), ("floor sticks", Some(t))]);
        let rolls = vx - 0.25 * 9.81 * t;
        assert!(near(end(&run, "vx"), rolls, 1e-11) && near(end(&run, "om"), -rolls / 0.5, 1e-10), "{:?}", run.end);
        assert!(near(end(&run, "x"), vx * t - 0.125 * 9.81 * t * t + rolls, 1e-10), "{:?}", run.end);
        keeps_energy(&run, 1e-10);
    }
}

/// A rod of half length 1 that leans on the floor with its end A, at an angle, moving.
fn rod(th: f64, vx: f64, om: f64, mu: f64, span: f64) -> String {
    let (sin, cos) = th.sin_cos();
    format!(
        "span = [0, {span:?}]\n[parameters]\nI = 1\n[start]\nx = 0\ny = {sin:?}\nth = {th:?}\nvx = {vx:?}\nvy = {:?}\nom = {om:?}\n[impacts.A]\ngap = \"p(A) @ N [2]\"\n\
         restitution = 0\nfriction = {mu:?}\nalong = \"v(A) @ N [1]\"\n{FINE}",
        cos * om
    )
}

/// Goal: the normal force of a contact depends on its friction. Truth: a rod that slides on its end, with N (1/m + a²
/// cos θ (cos θ + μ s sin θ)/I) = g − a sin θ ω² from the two laws of motion, integrated here by equal steps of the
/// classical method of Runge.
#[test]
fn a_leaning_rod_slides_as_its_own_equations_have_it() {
    let (m, i, g, mu) = (3.0, 1.0, 9.81, 0.4);
    for way in [1.0, -1.0] {
        let rates = |y: [f64; 4]| {
            let (sin, cos) = y[1].sin_cos();
            let n = (g - sin * y[3] * y[3]) / (1.0 / m + cos * (cos + mu * way * sin) / i);
            [y[2], y[3], -mu * way * n / m, -n * (cos + mu * way * sin) / i]
        };
        let mut y = [0.0, 1.0, 2.0 * way, 0.0];
        let h = 0.25 / 2000.0;
        for _ in 0..2000 {
            let at = |k: [f64; 4], part: f64| -> [f64; 4] { std::array::from_fn(|j| y[j] + part * h * k[j]) };
            let a = rates(y);
            let b = rates(at(a, 0.5));
            let c = rates(at(b, 0.5));
            let d = rates(at(c, 1.0));
            y = std::array::from_fn(|j| y[j] + h / 6.0 * (a[j] + 2.0 * b[j] + 2.0 * c[j] + d[j]));
        }
        let run = run(PLANE, &rod(1.0, 2.0 * way, 0.0, mu, 0.25));
        happens(&run, &[("A", None), ("A slips", None)]);
        for (name, truth) in ["x", "th", "vx", "om"].into_iter().zip(y) {
            assert!(near(end(&run, name), truth, 1e-10), "{way} {name}: {} for {truth}", end(&run, name));
        }
        keeps_energy(&run, 1e-10);
    }
}

/// Goal: a rod that tips over begins to slip where friction can no longer hold its end. Truth: tipped from upright by φ
/// with ω² = 3 g (1 − cos φ)/L, L = 2, the end needs F = ¾ m g sin φ (3 cos φ − 2) and N = ¼ m g (3 cos φ − 1)² (J. L.
/// Meriam & L. G. Kraige, *Dynamics*, chapter 6).
#[test]
fn a_rod_that_tips_over_begins_to_slip_where_friction_ends() {
    let (mu, tipped) = (0.3, 0.1_f64);
    let ratio = |phi: f64| 3.0 * phi.sin() * (3.0 * phi.cos() - 2.0) - mu * (3.0 * phi.cos() - 1.0).powi(2);
    let (mut low, mut high) = (tipped, 0.6);
    assert!(ratio(low) < 0.0 && ratio(high) > 0.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if ratio(middle) > 0.0 { high = middle } else { low = middle }
    }
    let om = -(1.5 * 9.81 * (1.0 - tipped.cos())).sqrt();
    let th = std::f64::consts::FRAC_PI_2 - tipped;
    let run = run(PLANE, &rod(th, -th.sin() * om, om, mu, 1.1));
    let found = events(&run);
    assert_eq!(found.iter().map(|event| event.0).collect::<Vec<_>>()[..3], ["A", "A sticks", "A slips"], "{found:?}");
    let phi = std::f64::consts::FRAC_PI_2 - run.events()[2].y[2];
    assert!(near(phi, low, 1e-9), "{phi} for {low}");
    keeps_energy(&run, 1e-9);
}

/// A body that falls on its point A with a spin, from 0.2 m.
pub fn falls(th: f64, vx: f64, om: f64, of: &str) -> String {
    let height = th.sin() + 0.2;
    let later = (0.4_f64 / 9.81).sqrt();
    let th = th - om * later;
    format!(
        "span = [0, 0.21]\n[parameters]\nI = 1\n[start]\nx = 0\ny = {height:?}\nth = {th:?}\nvx = {vx:?}\nvy = 0\nom = {om:?}\n[impacts.A]\ngap = \"p(A) @ N [2]\"\n\
         {of}\nalong = \"v(A) @ N [1]\"\n{FINE}"
    )
}

/// Goal: an impact with friction sticks or slips by Coulomb's law for impulses. Truth: G = [[1/m + a² c²/I, a² s c/I],
/// [., 1/m + a² s²/I]] in (normal, along) up to signs. A contact that sticks takes the slip and turns the normal
/// velocity. One that slips has Λt = ∓ μ Λn and turns only the normal velocity.
#[test]
fn an_impact_with_friction_sticks_or_slips() {
    let (m, i, th, om) = (3.0, 1.0, 0.9_f64, 0.5);
    let (s, c) = th.sin_cos();
    let v = (2.0_f64 * 9.81 * 0.2).sqrt();
    for (vx, mu, e, sticks) in [(0.3, 0.9, 0.0, true), (4.0, 0.3, 0.4, false), (-4.0, 0.3, 0.4, false)] {
        let run = run(PLANE, &falls(th, vx, om, &format!("restitution = {e:?}\nfriction = {mu:?}")));
        // Of the point (−a c, −a s) from the centre: vn = vy − c ω, vt = vx + s ω.
        let (nn, nt, tt) = (1.0 / m + c * c / i, -s * c / i, 1.0 / m + s * s / i);
        let (vn, vt) = (-v - c * om, vx + s * om);
        let (normal, along): (f64, f64) = if sticks {
            let (a, b, det) = (-(1.0 + e) * vn, -vt, nn * tt - nt * nt);
            ((tt * a - nt * b) / det, (nn * b - nt * a) / det)
        } else {
            let normal = -(1.0 + e) * vn / (nn - mu * vt.signum() * nt);
            (normal, -mu * vt.signum() * normal)
        };
        assert!(along.abs() <= mu * normal + 1e-12, "the case is what it is meant to be");
        let impact = &run.impacts()[0];
        assert!(near(impact.impulses[0].1, normal, 1e-9), "{impact:?} for {normal}");
        let at = run.solution.t.iter().position(|t| t.total_cmp(&impact.t).is_eq()).unwrap();
        let after = |name: &str| run.column_of_quantity(name).unwrap()[at];
        assert!(near(after("vx"), vx + along / m, 1e-9) && near(after("vy"), -v + normal / m, 1e-9), "{vx}");
        assert!(near(after("om"), om + (-c * normal + s * along) / i, 1e-9), "{}", after("om"));
        keeps_energy(&run, 1e-10);
    }
}

/// Goal: the run stops with its reason where rigid bodies with friction have no motion, or several. Truth: a uniform
/// rod has 1/m + a² c (c − μ s)/I < 0 for tan θ = 2, μ = 2 sliding towards its lean (P. Painlevé 1895). At rest no
/// force keeps it from the floor. At a spin that lifts the end it may open or press on.
#[test]
fn painleves_rod_stops_with_its_reason() {
    let th = 2.0_f64.atan();
    for (om, what) in [(0.0, "agrees with Coulomb's law"), (5.0, "`A` slips backwards, or `A` opens")] {
        let text = rod(th, -3.0 - th.sin() * om, om, 2.0, 0.2);
        let run = scene(PLANE, &text).simulate(&Overrides::default()).unwrap_or_else(|e| panic!("{e}"));
        let why = run.failure().unwrap_or_else(|| panic!("{om}: {:?}", events(&run)));
        assert!(why.contains(what) && why.contains("Painlevé") || om > 0.0 && why.contains("more than one"), "{why}");
        assert_eq!(run.solution.stop.code(), "friction");
    }
}
