//! Spherical pendulum: Nearly in a plane.
//!
//! Generated from `models/spherical_pendulum/scenes/narrow.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    AtPoints, CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar,
    System, by_columns,
};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// momentum p_phi = ∂L/∂phi', kg*m^2/s
    pub p_phi: S,
}

impl<S: Scalar> Parameters<S> {
    /// From values in the order of [`PARAMETERS`].
    ///
    /// # Panics
    /// If `p` has fewer values than there are parameters.
    #[must_use]
    #[inline(always)]
    pub fn from_slice(p: &[S]) -> Self {
        Self { g: p[0], p_phi: p[1] }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 2] {
        let Self { g, p_phi, .. } = self;
        [g, p_phi]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 2] = ["g", "p_phi"];

/// Names of the outputs.
pub const OUTPUTS: [&str; 4] = ["theta", "phi", "u1", "u2"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 1 operation, 1 sine and cosine.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> [S; 2] {
    let super::super::super::Parameters { g, .. } = *p;
    let [theta, _] = *q;
    let [_, u2] = *u;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // g
    let g_value = g;
    // p_phi = u2*sin(theta)
    let p_phi_value = u2 * sin_theta;
    [g_value, p_phi_value]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> ([S; 2], [S; 1]) {
    let [theta, phi] = *q;
    let [u1, _] = *u;
    // Values.
    // theta
    let theta_value = theta;
    // phi
    let phi_value = phi;
    // u1
    let u1_value = u1;
    ([theta_value, phi_value], [u1_value])
}

/// The accelerations (u1'), solved for when this code was generated.
///
/// 7 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 1]) -> [S; 1] {
    let Parameters { g, p_phi } = *p;
    let [theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta_inv = S::int(1) / sin_theta;
    // u2 = p_phi/sin(theta)
    let u2 = p_phi * sin_theta_inv;
    // u1' = u2^2/tan(theta) - g*sin(theta)
    let u1_dot = (-g).mul_add(sin_theta, u2 * u2 * sin_theta_inv * cos_theta);
    [u1_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> [S; 2] {
    let Parameters { p_phi, .. } = *p;
    let [theta, _] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta_inv = S::int(1) / sin_theta;
    // u2 = p_phi/sin(theta)
    let u2 = p_phi * sin_theta_inv;
    // Values.
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u2/sin(theta)
    let phi_dot_value = u2 * sin_theta_inv;
    [theta_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 2 operations.
#[must_use]
#[inline(always)]
pub fn kinetic_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 2], u: &[S; 1]) -> S {
    let [u1] = *u;
    // Values.
    // T = u1^2/2
    let energy = S::ratio(1, 2) * u1 * u1;
    energy
}

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// 6 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { g, p_phi } = *p;
    let [theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u2 = p_phi/sin(theta)
    let u2 = p_phi / sin_theta;
    // Values.
    // V = g*(1 - cos(theta)) + u2^2/2
    let energy = g * (S::int(1) - cos_theta) + S::ratio(1, 2) * u2 * u2;
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 1 operation, 1 sine and cosine.
#[must_use]
pub fn outputs<S: Scalar>(p: &Parameters<S>, _t: S, q: &[S; 2], u: &[S; 1]) -> [S; 4] {
    let Parameters { p_phi, .. } = *p;
    let [theta, phi] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u2 = p_phi/sin(theta)
    let u2 = p_phi / sin_theta;
    // Values.
    // theta
    let theta_value = theta;
    // phi
    let phi_value = phi;
    // u1
    let u1_value = u1;
    [theta_value, phi_value, u1_value, u2]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 7 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
) -> ([S; 2], [S; 1]) {
    let Parameters { g, p_phi } = *p;
    let [theta, _] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta_inv = S::int(1) / sin_theta;
    // u2 = p_phi/sin(theta)
    let u2 = p_phi * sin_theta_inv;
    let u2_sin_theta_inv = u2 * sin_theta_inv;
    // u1' = u2^2/tan(theta) - g*sin(theta)
    let u1_dot = (-g).mul_add(sin_theta, u2 * u2_sin_theta_inv * cos_theta);
    // Values.
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u2/sin(theta)
    let phi_dot_value = u2_sin_theta_inv;
    ([theta_dot_value, phi_dot_value], [u1_dot])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], _u: &[S; 1]) -> [S; 1] {
    let [theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = sin(theta)
    let divisor1 = sin_theta;
    [divisor1]
}

/// The energy, then its derivatives by the state.
///
/// 13 operations, 1 sine and cosine.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> [S; 4] {
    let Parameters { g, p_phi } = *p;
    let [theta, _] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta_inv = S::int(1) / sin_theta;
    // u2 = p_phi/sin(theta)
    let u2 = p_phi * sin_theta_inv;
    let u2_sq = u2 * u2;
    // u1^2 + u2_sq
    let u1_sq_plus_u2_sq = u1.mul_add(u1, u2_sq);
    // Values.
    // T + V = g*(1 - cos(theta)) + u1^2/2 + u2^2/2
    let energy = g * (S::int(1) - cos_theta) + S::ratio(1, 2) * u1_sq_plus_u2_sq;
    // d(T + V)/d(theta) = g*sin(theta) - u2*p_phi/(sin(theta)*tan(theta))
    let energy_by_theta = (-(sin_theta_inv * u2_sq)).mul_add(cos_theta, g * sin_theta);
    // d(T + V)/d(u1) = u1
    let energy_by_u1 = u1;
    let zero = S::int(0);
    [energy, energy_by_theta, zero, energy_by_u1]
}

/// The angles z whose sin z/z the slope of the potential needs.
///
/// 3 operations.
#[must_use]
#[inline(always)]
pub fn half_differences<S: Scalar>(_p: &Parameters<S>, q: &[S; 2]) -> [S; 1] {
    let [theta_from, theta_to] = *q;
    // Values.
    // z1 = theta_to/2 - theta_from/2
    let z1 = S::ratio(1, 2) * theta_to - S::ratio(1, 2) * theta_from;
    [z1]
}

/// The slope of the potential energy between two places `q`, without cancellation; `u` holds sin z/z.
///
/// 16 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn potential_slope<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> S {
    let Parameters { g, p_phi } = *p;
    let [theta_from, theta_to] = *q;
    let [sinc1] = *u;
    // Sines and cosines.
    let (sin_theta_from, _) = theta_from.sin_cos();
    let (sin_theta_to, _) = theta_to.sin_cos();
    // Shared terms.
    // theta_from/2 + theta_to/2
    let slope_of_place = S::ratio(1, 2) * theta_from + S::ratio(1, 2) * theta_to;
    let (sin_angle, cos_angle) = slope_of_place.sin_cos();
    // Values.
    // (V(b) - V(a))/(b - a) = g*sinc1*sin(theta_from/2 + theta_to/2) - p_phi^2*sinc1*cos(theta_from/2 +
    //   theta_to/2)*(sin(theta_from) + sin(theta_to))/(2*sin(theta_from)^2*sin(theta_to)^2)
    let slope = -S::ratio(1, 2) * p_phi * p_phi * sinc1 * cos_angle
        * (sin_theta_from + sin_theta_to)
        / (sin_theta_from * sin_theta_from * sin_theta_to * sin_theta_to) + g * sinc1 * sin_angle;
    slope
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
    direction: &[S; 3],
) -> [S; 3] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[2 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 2,
            coordinates: 2,
            variables: 1,
            speeds: 1,
            reactions: 0,
        }
    }
    fn symmetric(&self) -> bool {
        true
    }
    fn coordinate_rates(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        S::dispatch(
            #[inline(always)]
            || {
                out
                    .copy_from_slice(
                        &coordinate_rates(&Parameters::from_slice(p), array(q), array(v)),
                    )
            },
        );
    }
    fn output_count(&self) -> usize {
        4
    }
    fn outputs(&self, p: &[S], t: S, q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&outputs(&Parameters::from_slice(p), t, array(q), array(v)));
    }
    fn has_accelerations(&self) -> bool {
        true
    }
    fn accelerations(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        S::dispatch(
            #[inline(always)]
            || {
                out
                    .copy_from_slice(
                        &accelerations(&Parameters::from_slice(p), array(q), array(v)),
                    )
            },
        );
    }
    fn derivative(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]) {
        S::dispatch(
            #[inline(always)]
            || {
                let (of_q, of_v) = derivative(
                    &Parameters::from_slice(p),
                    array(q),
                    array(v),
                );
                q_dot.copy_from_slice(&of_q);
                v_dot.copy_from_slice(&of_v);
            },
        );
    }
    fn jacobian(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        by_columns(
            out,
            |direction| jacobian_product(
                &Parameters::from_slice(p),
                array(q),
                array(v),
                direction,
            ),
        );
    }
    fn has_energy_gradient(&self) -> bool {
        true
    }
    fn energy_gradient(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) -> S {
        let [energy, gradient @ ..] = energy_gradient(
            &Parameters::from_slice(p),
            array(q),
            array(v),
        );
        out.copy_from_slice(&gradient);
        energy
    }
    fn has_potential_slope(&self) -> bool {
        true
    }
    fn potential_slope(&self, p: &[S], a: S, b: S) -> S {
        S::dispatch(
            #[inline(always)]
            || {
                let p = Parameters::from_slice(p);
                let mut sincs = half_differences(&p, &[a, b]);
                sincs.iter_mut().for_each(|z| *z = z.sinc());
                potential_slope(&p, &[a, b], &sincs)
            },
        )
    }
    fn coordinate_period(&self) -> Option<f64> {
        Some(core::f64::consts::TAU)
    }
    fn at_points(&self) -> Option<AtPoints<'_>> {
        Some(AtPoints::of(&Derivative(Reduced)))
    }
    fn divisor_count(&self) -> usize {
        1
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["sin(theta)"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn generalized_speeds(&self, _p: &[S], _q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(v);
    }
    fn generalized_speed_rates(
        &self,
        _p: &[S],
        _q: &[S],
        _v: &[S],
        v_dot: &[S],
        out: &mut [S],
    ) {
        out.copy_from_slice(v_dot);
    }
    fn motion_variables(&self, _p: &[S], _q: &[S], u: &[S], out: &mut [S]) {
        out.copy_from_slice(u);
    }
    fn kinetic_energy(&self, p: &[S], q: &[S], v: &[S]) -> S {
        S::dispatch(
            #[inline(always)]
            || kinetic_energy(&Parameters::from_slice(p), array(q), array(v)),
        )
    }
    fn potential_energy(&self, p: &[S], q: &[S]) -> S {
        potential_energy(&Parameters::from_slice(p), array(q))
    }
}

#[inline(always)]
fn array<S, const N: usize>(slice: &[S]) -> &[S; N] {
    slice.try_into().expect("a slice of the length that `System` requires")
}

/// What a program needs to find these equations and to trust them.
pub const SCENE: CompiledScene = CompiledScene {
    name: "narrow",
    key: "36031d9149564acd",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
