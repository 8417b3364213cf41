//! Symmetric heavy top in Euler's angles: Let go.
//!
//! Generated from `models/euler_top/scenes/cusps.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    AtPoints, CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar,
    System, by_columns,
};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// mass, kg
    pub m: S,
    /// fixed point to the mass centre, m
    pub l: S,
    /// across the axis, about the fixed point, kg*m^2
    pub I1: S,
    /// about the axis, kg*m^2
    pub I3: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// momentum p_psi = ∂L/∂psi', what is left of it on the singular surface, kg*m^2/s
    pub p_psi_there: S,
    /// momentum p_phi = ∂L/∂phi', kg*m^2/s
    pub p_phi: S,
    /// 2*p_phi, 1
    pub p_phi_times_2: S,
    /// m*l*g, kg*m^2/s^2
    pub m_l_g: S,
}

impl<S: Scalar> Parameters<S> {
    /// From values in the order of [`PARAMETERS`].
    ///
    /// # Panics
    /// If `p` has fewer values than there are parameters.
    #[must_use]
    #[inline(always)]
    pub fn from_slice(p: &[S]) -> Self {
        Self {
            m: p[0], l: p[1], I1: p[2], I3: p[3], g: p[4], p_psi_there: p[5], p_phi: p[6],
            p_phi_times_2: p[7], m_l_g: p[8],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 9] {
        let Self { m, l, I1, I3, g, p_psi_there, p_phi, p_phi_times_2, m_l_g, .. } = self;
        [m, l, I1, I3, g, p_psi_there, p_phi, p_phi_times_2, m_l_g]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 9] = [
    "m", "l", "I1", "I3", "g", "p_psi_there", "p_phi", "p_phi_times_2", "m_l_g",
];

/// Names of the outputs.
pub const OUTPUTS: [&str; 6] = ["psi", "theta", "phi", "u1", "u2", "u3"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 9 operations, 1 sine and cosine.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
) -> [S; 9] {
    let super::super::super::Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [_, u2, u3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let i3_u3 = I3 * u3;
    // Values.
    // m
    let m_value = m;
    // l
    let l_value = l;
    // I1
    let I1_value = I1;
    // I3
    let I3_value = I3;
    // g
    let g_value = g;
    // p_psi_there = I1*u2*sin(theta) + I3*u3*(cos(theta) - 1)
    let p_psi_there_value = i3_u3 * (cos_theta - S::int(1)) + I1 * u2 * sin_theta;
    // p_phi = I3*u3
    let p_phi_value = i3_u3;
    // p_phi_times_2 = 2*I3*u3
    let p_phi_times_2_value = S::int(2) * i3_u3;
    // m_l_g = m*l*g
    let m_l_g_value = m * l * g;
    [
        m_value, l_value, I1_value, I3_value, g_value, p_psi_there_value, p_phi_value,
        p_phi_times_2_value, m_l_g_value,
    ]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
) -> ([S; 3], [S; 1]) {
    let [psi, theta, phi] = *q;
    let [u1, _, _] = *u;
    // Values.
    // theta
    let theta_value = theta;
    // phi
    let phi_value = phi;
    // psi
    let psi_value = psi;
    // u1
    let u1_value = u1;
    ([theta_value, phi_value, psi_value], [u1_value])
}

/// The accelerations (u1'), solved for when this code was generated.
///
/// 18 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], _u: &[S; 1]) -> [S; 1] {
    let Parameters { I1, I3, p_psi_there, p_phi, p_phi_times_2, m_l_g, .. } = *p;
    let [theta, _, _] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let i1_inv = S::int(1) / I1;
    let sin_theta_inv = S::int(1) / sin_theta;
    let (sin_theta_by_2, _) = (S::ratio(1, 2) * theta).sin_cos();
    // u2 = (p_psi_there + p_phi_times_2*sin(theta/2)^2)/(I1*sin(theta))
    let u2 = i1_inv * sin_theta_inv
        * (p_psi_there + p_phi_times_2 * sin_theta_by_2 * sin_theta_by_2);
    // u3 = p_phi/I3
    let u3 = p_phi / I3;
    // u1' = (m_l_g*sin(theta) - u2*(I3*u3 - I1*u2/tan(theta)))/I1
    let u1_dot = i1_inv
        * (u2 * (-I3).mul_add(u3, I1 * u2 * sin_theta_inv * cos_theta) + m_l_g * sin_theta);
    [u1_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 11 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 3] {
    let Parameters { I1, I3, p_psi_there, p_phi, p_phi_times_2, .. } = *p;
    let [theta, _, _] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta_inv = S::int(1) / sin_theta;
    let (sin_theta_by_2, _) = (S::ratio(1, 2) * theta).sin_cos();
    // u2 = (p_psi_there + p_phi_times_2*sin(theta/2)^2)/(I1*sin(theta))
    let u2 = sin_theta_inv * (p_psi_there + p_phi_times_2 * sin_theta_by_2 * sin_theta_by_2) / I1;
    // u3 = p_phi/I3
    let u3 = p_phi / I3;
    let u2_sin_theta_inv = u2 * sin_theta_inv;
    // Values.
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u3 - u2/tan(theta)
    let phi_dot_value = (-u2_sin_theta_inv).mul_add(cos_theta, u3);
    // psi' = u2/sin(theta)
    let psi_dot_value = u2_sin_theta_inv;
    [theta_dot_value, phi_dot_value, psi_dot_value]
}

/// Kinetic energy T.
///
/// 3 operations.
#[must_use]
#[inline(always)]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 3], u: &[S; 1]) -> S {
    let Parameters { I1, .. } = *p;
    let [u1] = *u;
    // Values.
    // T = I1*u1^2/2
    let energy = S::ratio(1, 2) * I1 * u1 * u1;
    energy
}

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// 17 operations, 2 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { m, l, I1, I3, g, p_psi_there, p_phi, p_phi_times_2, .. } = *p;
    let [theta, _, _] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_theta_by_2, _) = (S::ratio(1, 2) * theta).sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u2 = (p_psi_there + p_phi_times_2*sin(theta/2)^2)/(I1*sin(theta))
    let u2 = (p_psi_there + p_phi_times_2 * sin_theta_by_2 * sin_theta_by_2) / (I1 * sin_theta);
    // u3 = p_phi/I3
    let u3 = p_phi / I3;
    // I1*u2^2 + I3*u3^2
    let i1_u2_sq_plus_i3_u3_sq = I1 * u2 * u2 + I3 * u3 * u3;
    // Values.
    // V = m*l*g*cos(theta) + I1*u2^2/2 + I3*u3^2/2
    let energy = (m * l * g).mul_add(cos_theta, S::ratio(1, 2) * i1_u2_sq_plus_i3_u3_sq);
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 7 operations, 2 sines and cosines.
#[must_use]
pub fn outputs<S: Scalar>(p: &Parameters<S>, _t: S, q: &[S; 3], u: &[S; 1]) -> [S; 6] {
    let Parameters { I1, I3, p_psi_there, p_phi, p_phi_times_2, .. } = *p;
    let [theta, phi, psi] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    let (sin_theta_by_2, _) = (S::ratio(1, 2) * theta).sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u2 = (p_psi_there + p_phi_times_2*sin(theta/2)^2)/(I1*sin(theta))
    let u2 = (p_psi_there + p_phi_times_2 * sin_theta_by_2 * sin_theta_by_2) / (I1 * sin_theta);
    // u3 = p_phi/I3
    let u3 = p_phi / I3;
    // Values.
    // psi
    let psi_value = psi;
    // theta
    let theta_value = theta;
    // phi
    let phi_value = phi;
    // u1
    let u1_value = u1;
    [psi_value, theta_value, phi_value, u1_value, u2, u3]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 19 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 1],
) -> ([S; 3], [S; 1]) {
    let Parameters { I1, I3, p_psi_there, p_phi, p_phi_times_2, m_l_g, .. } = *p;
    let [theta, _, _] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let i1_inv = S::int(1) / I1;
    let sin_theta_inv = S::int(1) / sin_theta;
    let (sin_theta_by_2, _) = (S::ratio(1, 2) * theta).sin_cos();
    // u2 = (p_psi_there + p_phi_times_2*sin(theta/2)^2)/(I1*sin(theta))
    let u2 = i1_inv * sin_theta_inv
        * (p_psi_there + p_phi_times_2 * sin_theta_by_2 * sin_theta_by_2);
    // u3 = p_phi/I3
    let u3 = p_phi / I3;
    let u2_sin_theta_inv = u2 * sin_theta_inv;
    let u1_dot_of_theta_u2 = u2_sin_theta_inv * cos_theta;
    // u1' = (m_l_g*sin(theta) - u2*(I3*u3 - I1*u2/tan(theta)))/I1
    let u1_dot = i1_inv * (u2 * (-I3).mul_add(u3, I1 * u1_dot_of_theta_u2) + m_l_g * sin_theta);
    // Values.
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u3 - u2/tan(theta)
    let phi_dot_value = u3 - u1_dot_of_theta_u2;
    // psi' = u2/sin(theta)
    let psi_dot_value = u2_sin_theta_inv;
    ([theta_dot_value, phi_dot_value, psi_dot_value], [u1_dot])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], _u: &[S; 1]) -> [S; 1] {
    let [theta, _, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = sin(theta)
    let divisor1 = sin_theta;
    [divisor1]
}

/// The energy, then its derivatives by the state.
///
/// 37 operations, 2 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 5] {
    let Parameters { m, l, I1, I3, g, p_psi_there, p_phi, p_phi_times_2, .. } = *p;
    let [theta, _, _] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let theta_halved = S::ratio(1, 2) * theta;
    let (sin_theta_by_2, cos_theta_by_2) = theta_halved.sin_cos();
    let sin_theta_by_2_sq = sin_theta_by_2 * sin_theta_by_2;
    // u2 = (p_psi_there + p_phi_times_2*sin(theta/2)^2)/(I1*sin(theta))
    let u2 = p_phi_times_2.mul_add(sin_theta_by_2_sq, p_psi_there) / (I1 * sin_theta);
    // u3 = p_phi/I3
    let u3 = p_phi / I3;
    let m_l_g_2 = m * l * g;
    // I1*(u1^2 + u2^2) + I3*u3^2
    let energy_of_u1 = I1 * u2.mul_add(u2, u1 * u1) + I3 * u3 * u3;
    let energy_by_theta_of_theta = S::int(1) / (sin_theta_by_2 * cos_theta_by_2);
    // Values.
    // T + V = m*l*g*cos(theta) + I1*u1^2/2 + I1*u2^2/2 + I3*u3^2/2
    let energy = m_l_g_2.mul_add(cos_theta, S::ratio(1, 2) * energy_of_u1);
    // d(T + V)/d(theta) = (sin(theta/2)^2*(8*m*l*g*sin(theta/2)*cos(theta/2)*(sin(theta/2)^2 - 1) +
    //   u2*(2*p_psi_there + p_phi_times_2)) - u2*p_psi_there)/(4*sin(theta/2)^2*cos(theta/2)^2)
    let energy_by_theta = S::ratio(1, 4) * energy_by_theta_of_theta * energy_by_theta_of_theta
        * (sin_theta_by_2_sq
            * (u2 * p_psi_there.mul_add(S::int(2), p_phi_times_2)
                + S::int(8) * m_l_g_2 * sin_theta_by_2 * cos_theta_by_2
                    * (sin_theta_by_2_sq - S::int(1))) - u2 * p_psi_there);
    // d(T + V)/d(u1) = I1*u1
    let energy_by_u1 = I1 * u1;
    let zero = S::int(0);
    [energy, energy_by_theta, zero, zero, energy_by_u1]
}

/// The angles z whose sin z/z the slope of the potential needs.
///
/// 6 operations.
#[must_use]
#[inline(always)]
pub fn half_differences<S: Scalar>(_p: &Parameters<S>, q: &[S; 2]) -> [S; 2] {
    let [theta_from, theta_to] = *q;
    // Values.
    // z1 = theta_to/2 - theta_from/2
    let z1 = S::ratio(1, 2) * theta_to - S::ratio(1, 2) * theta_from;
    // z2 = theta_to/4 - theta_from/4
    let z2 = S::ratio(1, 4) * theta_to - S::ratio(1, 4) * theta_from;
    [z1, z2]
}

/// The slope of the potential energy between two places `q`, without cancellation; `u` holds sin z/z.
///
/// 41 operations, 6 sines and cosines.
#[must_use]
#[inline(always)]
pub fn potential_slope<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> S {
    let Parameters { m, l, I1, g, p_psi_there, p_phi, .. } = *p;
    let [theta_from, theta_to] = *q;
    let [sinc1, sinc2] = *u;
    // Sines and cosines.
    let (sin_theta_from, _) = theta_from.sin_cos();
    let (sin_theta_to, _) = theta_to.sin_cos();
    // Shared terms.
    // theta_from/2 + theta_to/2
    let slope_of_place = S::ratio(1, 2) * theta_from + S::ratio(1, 2) * theta_to;
    let (sin_angle, cos_angle) = slope_of_place.sin_cos();
    let (_, cos_angle_2) = (S::ratio(1, 4) * theta_from + S::ratio(1, 4) * theta_to)
        .sin_cos();
    let (sin_theta_from_by_2, _) = (S::ratio(1, 2) * theta_from).sin_cos();
    let (sin_theta_to_by_2, _) = (S::ratio(1, 2) * theta_to).sin_cos();
    let slope_of_place_2 = p_phi * sin_theta_to_by_2 * sin_theta_to_by_2;
    // Values.
    // (V(b) - V(a))/(b - a) = p_phi*sinc2*cos(theta_from/4 + theta_to/4)*(sin(theta_from/2) +
    //   sin(theta_to/2))*(p_psi_there + p_phi*sin(theta_from/2)^2 +
    //   p_phi*sin(theta_to/2)^2)/(I1*sin(theta_from)^2) - m*l*g*sinc1*sin(theta_from/2 + theta_to/2) -
    //   sinc1*cos(theta_from/2 + theta_to/2)*(sin(theta_from) + sin(theta_to))*(p_psi_there +
    //   2*p_phi*sin(theta_to/2)^2)^2/(2*I1*sin(theta_from)^2*sin(theta_to)^2)
    let slope = p_phi * sinc2 * cos_angle_2 * (sin_theta_from_by_2 + sin_theta_to_by_2)
        * (p_psi_there + p_phi * sin_theta_from_by_2 * sin_theta_from_by_2
            + slope_of_place_2) / (I1 * sin_theta_from * sin_theta_from)
        - m * l * g * sinc1 * sin_angle
        - S::ratio(1, 2) * sinc1 * cos_angle * (sin_theta_from + sin_theta_to)
            * slope_of_place_2.mul_add(S::int(2), p_psi_there).powi(2)
            / (I1 * sin_theta_from * sin_theta_from * sin_theta_to * sin_theta_to);
    slope
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 1],
    direction: &[S; 4],
) -> [S; 4] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[3 + i],
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
            parameters: 9,
            coordinates: 3,
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
        6
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
        Some(2.0 * core::f64::consts::TAU)
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
    name: "cusps",
    key: "573cf29a7066e328",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
