//! States of models at an instant, for motions that are known in closed form: `exact` of a scene, `motion` of any
//! start.
//!
//! The closed forms are those of `tripos_sim::exact`; here they get the angles, the speeds and the start of a model.

use super::compiled;
use super::stability::Start;
use std::path::Path;
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::{InitialMotion, Scene, load};
use tripos_sim::exact::{
    BodyStart, FreeSymmetricBody, HeavyTop, Pendulum, SphericalPendulum, Top as Inertia, TopStart,
};
use tripos_traits::{DoubleDouble, Real, Scalar};

type Dd = DoubleDouble;

/// (q, u) at a time after the start, s, in the order of the model.
pub type Motion = Box<dyn Fn(Dd) -> Vec<Dd>>;

/// The scenes with a closed form.
pub const CLOSED_FORMS: [(&str, &str); 10] = [
    ("pendulum", "swing"),
    ("pendulum", "over"),
    ("spherical_pendulum", "wide"),
    ("spherical_pendulum", "narrow"),
    ("heavy_top", "looping"),
    ("euler_top", "looping"),
    ("euler_top", "cusps"),
    ("free_body", "steady"),
    ("free_body", "tumbling"),
    ("floating_chain", "straight"),
];

/// The names of a model's coordinates and speeds, each with its value t seconds after the start of the scene; nothing
/// where no closed form is known.
pub fn exact(model: &str, scene: &str, t: f64) -> Option<Vec<(String, f64)>> {
    let at = motion(model, &start_of(model, scene))?;
    let (model, _) = read(model, scene);
    let names = model.coordinates.iter().map(|c| c.name.clone()).chain(model.speeds.iter().map(|s| s.name.clone()));
    Some(names.zip(at(Dd::from_f64(t)).iter().map(|x| x.to_f64())).collect())
}

/// Parameters and start of a scene, to the digits that its file has.
pub fn start_of(model: &str, scene: &str) -> Start {
    let (_, scene) = read(model, scene);
    let (p, q) = (scene.exact.parameters, scene.exact.q);
    let u = match &scene.exact.motion {
        InitialMotion::Speeds(u) => u.clone(),
        InitialMotion::Rates(rates) => {
            let mut u = vec![Dd::int(0); rates.len()];
            // Lagrange's equations have the definitions of the speeds.
            compiled(model, "lagrange").extended.generalized_speeds(&p, &q, rates, &mut u);
            u
        }
    };
    Start { p, q, u }
}

/// A model of the library and one of its scenes.
pub fn read(model: &str, scene: &str) -> (Model, Scene) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(model);
    let mut model = Model::read(&folder.join("model.toml")).unwrap();
    let source = Source::read(&folder.join(format!("scenes/{scene}.toml"))).unwrap();
    let scene = load(&source, &mut model).unwrap();
    (model, scene)
}

/// The motion of a model from a start; nothing where no closed form is known.
pub fn motion(model: &str, start: &Start) -> Option<Motion> {
    let Start { p, q, u } = start.clone();
    match model {
        "pendulum" => Some(pendulum(&p, &q, &u)),
        "spherical_pendulum" => spherical_pendulum(&p, &q, &u),
        "euler_top" => euler_top(&p, &q, &u),
        "heavy_top" => heavy_top(&p, &q, &u),
        "free_body" => free_body(&p, &q, &u),
        "floating_chain" => straight_chain(&p, &q, &u),
        _ => None,
    }
}

fn pendulum(p: &[Dd], q: &[Dd], u: &[Dd]) -> Motion {
    let exact = Pendulum::new(p[2] / p[1], q[0], u[0]);
    Box::new(move |t| vec![exact.angle(t), exact.rate(t)])
}

/// θ is π less the angle from the upward vertical.
fn spherical_pendulum(p: &[Dd], q: &[Dd], u: &[Dd]) -> Option<Motion> {
    let sin = q[0].sin_cos().0;
    let azimuth = q[1];
    let exact = SphericalPendulum::new(p[2] / p[1], Dd::pi() - q[0], -u[0], u[1] / sin);
    let at = move |t| {
        let theta = Dd::pi() - exact.angle(t);
        let across = exact.azimuth_rate(t) * theta.sin_cos().0;
        vec![theta, azimuth + exact.azimuth(t), -exact.angle_rate(t), across]
    };
    (sin > Dd::int(0)).then(|| Box::new(at) as Motion)
}

/// A top with parameters m, l, I1, I3, g.
fn top(p: &[Dd], nutation: Dd, nutation_rate: Dd, precession_rate: Dd, spin: Dd) -> HeavyTop<Dd> {
    let inertia = Inertia { mass: p[0], arm: p[1], transverse: p[2], axial: p[3], gravity: p[4] };
    HeavyTop::new(inertia, TopStart { nutation, nutation_rate, precession_rate, spin })
}

fn euler_top(p: &[Dd], q: &[Dd], u: &[Dd]) -> Option<Motion> {
    let ((sin, _), precession, spin_angle, spin) = (q[1].sin_cos(), q[0], q[2], u[2]);
    let exact = top(p, q[1], u[0], u[1] / sin, spin);
    let at = move |t| {
        let theta = exact.nutation(t);
        let angles = [precession + exact.precession(t), theta, spin_angle + exact.spin_angle(t)];
        [angles, [exact.nutation_rate(t), exact.precession_rate(t) * theta.sin_cos().0, spin]].concat()
    };
    (sin > Dd::int(0)).then(|| Box::new(at) as Motion)
}

/// Cardan's angles from Euler's, for an axis that is never vertical at the start nor ever horizontal. The axis is
/// (sin q2, −sin q1 cos q2, cos q1 cos q2) = (sin θ sin φ, −sin θ cos φ, cos θ).
fn heavy_top(p: &[Dd], q: &[Dd], u: &[Dd]) -> Option<Motion> {
    let ((sin_1, cos_1), (sin_2, cos_2)) = (q[0].sin_cos(), q[1].sin_cos());
    let axis = [sin_2, -sin_1 * cos_2, cos_1 * cos_2];
    let rate = [cos_2 * u[1], sin_1 * sin_2 * u[1] - cos_1 * u[0], -sin_1 * u[0] - cos_1 * sin_2 * u[1]];
    let sin = (axis[0] * axis[0] + axis[1] * axis[1]).sqrt();
    if sin == Dd::int(0) {
        return None;
    }
    let precession_rate = (axis[0] * rate[1] - axis[1] * rate[0]) / (sin * sin);
    let (precession, spin_angle, spin) = (angle_of(axis[0], -axis[1]), q[2], u[2]);
    let exact = top(p, angle_of(sin, axis[2]), -rate[2] / sin, precession_rate, spin);
    let above = exact.extremes()[1] < Dd::pi() / Dd::int(2);
    let node_at_start = cardan(precession, exact.nutation(Dd::int(0))).1;
    let at = move |t| {
        let (theta, phi) = (exact.nutation(t), precession + exact.precession(t));
        let ([q_1, q_2], node) = cardan(phi, theta);
        let ((sin, cos), (sin_phi, cos_phi)) = (theta.sin_cos(), phi.sin_cos());
        let (theta_rate, across) = (exact.nutation_rate(t), exact.precession_rate(t) * sin);
        // The rate of the axis, along N1 and along what is tilted by q1.
        let rate = [
            cos * sin_phi * theta_rate + cos_phi * across,
            -cos * cos_phi * theta_rate + sin_phi * across,
            -sin * theta_rate,
        ];
        let ((sin_1, cos_1), (_, cos_2)) = (q_1.sin_cos(), q_2.sin_cos());
        let q_3 = spin_angle + exact.spin_angle(t) + (node - node_at_start);
        vec![q_1, q_2, q_3, -(cos_1 * rate[1] + sin_1 * rate[2]), rate[0] / cos_2, spin]
    };
    above.then(|| Box::new(at) as Motion)
}

/// q1 and q2 of an axis above the horizontal plane, and the angle from B1 to the line of nodes, continuous in φ: it
/// never differs from φ by a right angle.
fn cardan(phi: Dd, theta: Dd) -> ([Dd; 2], Dd) {
    let ((sin, cos), (sin_phi, cos_phi)) = (theta.sin_cos(), phi.sin_cos());
    let (q_1, q_2) = ((sin * cos_phi / cos).atan(), (sin * sin_phi).asin());
    let ((sin_1, cos_1), (sin_2, cos_2)) = (q_1.sin_cos(), q_2.sin_cos());
    let node = angle_of(sin_phi * cos_1, cos_phi * cos_2 + sin_phi * sin_1 * sin_2);
    let turn = Dd::int(2) * Dd::pi();
    let turns = ((phi - node) / turn).to_f64().round();
    ([q_1, q_2], node + turn * Dd::from_f64(turns))
}

fn free_body(p: &[Dd], q: &[Dd], u: &[Dd]) -> Option<Motion> {
    let (place, velocity) = ([q[0], q[1], q[2]], [u[0], u[1], u[2]]);
    let angular_velocity = [u[3], u[4], u[5]];
    let start = BodyStart { precession: q[3], nutation: q[4], spin_angle: q[5], angular_velocity };
    let exact = FreeSymmetricBody::new(p[1], p[2], start);
    let at = move |t| {
        let place = [0, 1, 2].map(|k| place[k] + velocity[k] * t);
        [place, exact.angles(t), velocity, exact.angular_velocity(t)].concat()
    };
    (q[4].sin_cos().0 > Dd::int(0)).then(|| Box::new(at) as Motion)
}

/// All rods in one line and at one rate: the chain turns about its mass centre, in the middle of the second rod.
fn straight_chain(p: &[Dd], q: &[Dd], u: &[Dd]) -> Option<Motion> {
    let (length, angle, rate) = (p[1], q[2], u[2]);
    let straight = [3, 4].iter().all(|&k| q[k] == angle && u[k] == rate);
    let (sin, cos) = angle.sin_cos();
    let centre = [q[0] + length * cos, q[1] + length * sin];
    let velocity = [u[0] - length * rate * sin, u[1] + length * rate * cos];
    let at = move |t| {
        let angle = angle + rate * t;
        let (sin, cos) = angle.sin_cos();
        let place = [centre[0] + velocity[0] * t - length * cos, centre[1] + velocity[1] * t - length * sin];
        let speed = [velocity[0] + length * rate * sin, velocity[1] - length * rate * cos];
        [place.to_vec(), vec![angle; 3], speed.to_vec(), vec![rate; 3]].concat()
    };
    straight.then(|| Box::new(at) as Motion)
}

/// The angle of the point (x, y) from the axis of x, in (−π, π].
fn angle_of(y: Dd, x: Dd) -> Dd {
    let radius = (x * x + y * y).sqrt();
    let two = Dd::int(2);
    if x < Dd::int(0) {
        let half_turn = if y < Dd::int(0) { -Dd::pi() } else { Dd::pi() };
        return half_turn - two * (y / (radius - x)).atan();
    }
    two * (y / (radius + x)).atan()
}
