//! Initial value problems that the literature tests methods on.
#![allow(clippy::unnecessary_wraps, reason = "the signature of a right-hand side")]

use tripos_sim::Failure;

/// A right-hand side as a plain function, so that two integrators can be given the same one.
pub type Function = fn(f64, &[f64], &mut [f64]) -> Result<(), Failure>;

/// y' = f(t, y) on a span.
pub struct Problem {
    pub name: &'static str,
    pub rhs: Function,
    pub y0: &'static [f64],
    pub span: f64,
}

/// A pendulum of 1 m from 3 rad: nearly upside down.
pub const PENDULUM: Problem = Problem { name: "pendulum", rhs: pendulum, y0: &[3.0, 0.0], span: 20.0 };

/// Kepler's problem with eccentricity 0.6, three revolutions.
pub const KEPLER: Problem =
    Problem { name: "Kepler", rhs: kepler, y0: &[0.4, 0.0, 0.0, 2.0], span: 18.849_555_921_538_76 };

/// The restricted problem of three bodies on a closed orbit of four loops, one revolution. R. F. Arenstorf, Amer. J.
/// Math. 85 (1963) 27–35; the figures are those of Hairer, Nørsett & Wanner, §II.0, equation (0.1).
pub const ARENSTORF: Problem = Problem {
    name: "Arenstorf",
    rhs: arenstorf,
    y0: &[0.994, 0.0, 0.0, -2.001_585_106_379_082_5],
    span: 17.065_216_560_157_96,
};

/// Van der Pol's oscillator with a ratio of rates near 20.
pub const VAN_DER_POL: Problem = Problem { name: "van der Pol", rhs: van_der_pol, y0: &[2.0, 0.0], span: 20.0 };

/// A free rigid body with moments 1, 2, 3 near its unstable axis, with its attitude as a quaternion.
pub const RIGID_BODY: Problem =
    Problem { name: "rigid body", rhs: rigid_body, y0: &[0.01, 2.0, 0.02, 1.0, 0.0, 0.0, 0.0], span: 20.0 };

fn pendulum(_t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
    dydt[0] = y[1];
    dydt[1] = -9.81 * y[0].sin();
    Ok(())
}

fn kepler(_t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
    let r2 = y[0] * y[0] + y[1] * y[1];
    let r3 = r2 * r2.sqrt();
    dydt.copy_from_slice(&[y[2], y[3], -y[0] / r3, -y[1] / r3]);
    Ok(())
}

fn arenstorf(_t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
    let moon = 0.012_277_471;
    let earth = 1.0 - moon;
    let cube = |x: f64| {
        let r2 = x * x + y[1] * y[1];
        r2 * r2.sqrt()
    };
    let (d1, d2) = (cube(y[0] + moon), cube(y[0] - earth));
    dydt[0] = y[2];
    dydt[1] = y[3];
    dydt[2] = y[0] + 2.0 * y[3] - earth * (y[0] + moon) / d1 - moon * (y[0] - earth) / d2;
    dydt[3] = y[1] - 2.0 * y[2] - earth * y[1] / d1 - moon * y[1] / d2;
    Ok(())
}

fn van_der_pol(_t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
    dydt[0] = y[1];
    dydt[1] = 20.0 * (1.0 - y[0] * y[0]) * y[1] - y[0];
    Ok(())
}

fn rigid_body(_t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
    let [w1, w2, w3, e0, e1, e2, e3] = [y[0], y[1], y[2], y[3], y[4], y[5], y[6]];
    dydt[0] = -w2 * w3;
    dydt[1] = w3 * w1;
    dydt[2] = -w1 * w2 / 3.0;
    dydt[3] = 0.5 * (-e1 * w1 - e2 * w2 - e3 * w3);
    dydt[4] = 0.5 * (e0 * w1 + e2 * w3 - e3 * w2);
    dydt[5] = 0.5 * (e0 * w2 + e3 * w1 - e1 * w3);
    dydt[6] = 0.5 * (e0 * w3 + e1 * w2 - e2 * w1);
    Ok(())
}
