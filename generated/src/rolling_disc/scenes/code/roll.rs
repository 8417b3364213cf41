//! Thin disc rolling on a plane: Rolling in curves.
//!
//! Generated from `models/rolling_disc/scenes/roll.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar, System,
    by_columns,
};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// radius, m
    pub r: S,
    /// mass, kg
    pub m: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// 4*g, m/s^2
    pub g_times_4: S,
    /// r*m/4, kg*m
    pub r_m_by_4: S,
    /// r^2*m, kg*m^2
    pub r_squared_m: S,
    /// r^2*m/4, kg*m^2
    pub r_squared_m_by_4: S,
    /// 5*r^2*m/4, kg*m^2
    pub r_squared_m_times_5_by_4: S,
    /// 3*r^2*m/2, kg*m^2
    pub r_squared_m_times_3_by_2: S,
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
            r: p[0], m: p[1], g: p[2], g_times_4: p[3], r_m_by_4: p[4], r_squared_m: p[5],
            r_squared_m_by_4: p[6], r_squared_m_times_5_by_4: p[7], r_squared_m_times_3_by_2: p[8],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 9] {
        let Self {
            r, m, g, g_times_4, r_m_by_4, r_squared_m, r_squared_m_by_4, r_squared_m_times_5_by_4,
            r_squared_m_times_3_by_2,
            ..
        } = self;
        [
            r, m, g, g_times_4, r_m_by_4, r_squared_m, r_squared_m_by_4, r_squared_m_times_5_by_4,
            r_squared_m_times_3_by_2,
        ]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 9] = [
    "r", "m", "g", "g_times_4", "r_m_by_4", "r_squared_m", "r_squared_m_by_4",
    "r_squared_m_times_5_by_4", "r_squared_m_times_3_by_2",
];

/// Names of the outputs.
pub const OUTPUTS: [&str; 8] = ["q1", "q2", "q3", "x", "y", "u1", "u2", "u3"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 7 operations.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    _q: &[S; 5],
    _u: &[S; 3],
) -> [S; 9] {
    let super::super::super::Parameters { r, m, g } = *p;
    // Shared terms.
    let r_m = r * m;
    let r_r_m = r * r_m;
    // Values.
    // r
    let r_value = r;
    // m
    let m_value = m;
    // g
    let g_value = g;
    // g_times_4 = 4*g
    let g_times_4_value = S::int(4) * g;
    // r_m_by_4 = r*m/4
    let r_m_by_4_value = S::ratio(1, 4) * r_m;
    // r_squared_m = r^2*m
    let r_squared_m_value = r_r_m;
    // r_squared_m_by_4 = r^2*m/4
    let r_squared_m_by_4_value = S::ratio(1, 4) * r_r_m;
    // r_squared_m_times_5_by_4 = 5*r^2*m/4
    let r_squared_m_times_5_by_4_value = S::ratio(5, 4) * r_r_m;
    // r_squared_m_times_3_by_2 = 3*r^2*m/2
    let r_squared_m_times_3_by_2_value = S::ratio(3, 2) * r_r_m;
    [
        r_value, m_value, g_value, g_times_4_value, r_m_by_4_value, r_squared_m_value,
        r_squared_m_by_4_value, r_squared_m_times_5_by_4_value, r_squared_m_times_3_by_2_value,
    ]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 5],
    u: &[S; 3],
) -> ([S; 5], [S; 3]) {
    let [q1, q2, q3, x, y] = *q;
    let [u1, u2, u3] = *u;
    // Values.
    // q2
    let q2_value = q2;
    // q1
    let q1_value = q1;
    // y
    let y_value = y;
    // x
    let x_value = x;
    // q3
    let q3_value = q3;
    // u1
    let u1_value = u1;
    // u2
    let u2_value = u2;
    // u3
    let u3_value = u3;
    ([q2_value, q1_value, y_value, x_value, q3_value], [u1_value, u2_value, u3_value])
}

/// The accelerations (u1', u2', u3'), solved for when this code was generated.
///
/// 17 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 3]) -> [S; 3] {
    let Parameters {
        r, g_times_4, r_m_by_4, r_squared_m, r_squared_m_times_5_by_4, r_squared_m_times_3_by_2,
        ..
    } = *p;
    let [q2, _, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let t2 = s2 / c2;
    let u3_s2_c2_inv = u3 * t2;
    // u3' = u1*(u3*tan(q2) - 2*u2)
    let u3_dot = u1 * (-u2).mul_add(S::int(2), u3_s2_c2_inv);
    // u2' = -u1*u3*r_squared_m/r_squared_m_times_3_by_2
    let u2_dot = -u1 * u3 * r_squared_m / r_squared_m_times_3_by_2;
    // u1' = r_m_by_4*(r*u3*(6*u2 - u3*tan(q2)) + g_times_4*sin(q2))/r_squared_m_times_5_by_4
    let u1_dot = r_m_by_4 * (r * u3 * u2.mul_add(S::int(6), -u3_s2_c2_inv) + g_times_4 * s2)
        / r_squared_m_times_5_by_4;
    [u1_dot, u2_dot, u3_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 6 operations, 2 sines and cosines.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 3]) -> [S; 5] {
    let Parameters { r, .. } = *p;
    let [q2, q1, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let u3_c2_inv = u3 / c2;
    // u2 - u3_c2_inv*sin(q2)
    let u2_minus_s2_u3_c2_inv = (-u3_c2_inv).mul_add(s2, u2);
    let r_u2_minus_s2_u3_c2_inv = r * u2_minus_s2_u3_c2_inv;
    // Values.
    // q2' = u1
    let q2_dot_value = u1;
    // q1' = u3/cos(q2)
    let q1_dot_value = u3_c2_inv;
    // y' = r*sin(q1)*(u2 - u3*tan(q2))
    let y_dot_value = r_u2_minus_s2_u3_c2_inv * s1;
    // x' = r*cos(q1)*(u2 - u3*tan(q2))
    let x_dot_value = r_u2_minus_s2_u3_c2_inv * c1;
    // q3' = u2 - u3*tan(q2)
    let q3_dot_value = u2_minus_s2_u3_c2_inv;
    [q2_dot_value, q1_dot_value, y_dot_value, x_dot_value, q3_dot_value]
}

/// Kinetic energy T.
///
/// 11 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 5], u: &[S; 3]) -> S {
    let Parameters { r, m, .. } = *p;
    let [u1, u2, u3] = *u;
    // Values.
    // T = r^2*m*(5*u1^2 + 6*u2^2 + u3^2)/8
    let energy = S::ratio(1, 8) * r * r * m
        * u3.mul_add(u3, S::int(5) * u1 * u1 + S::int(6) * u2 * u2);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5]) -> S {
    let Parameters { r, m, g, .. } = *p;
    let [q2, _, _, _, _] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    // Values.
    // V = r*m*g*cos(q2)
    let energy = r * m * g * c2;
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 0 operations.
#[must_use]
pub fn outputs<S: Scalar>(_p: &Parameters<S>, _t: S, q: &[S; 5], u: &[S; 3]) -> [S; 8] {
    let [q2, q1, y, x, q3] = *q;
    let [u1, u2, u3] = *u;
    // Values.
    // q1
    let q1_value = q1;
    // q2
    let q2_value = q2;
    // q3
    let q3_value = q3;
    // x
    let x_value = x;
    // y
    let y_value = y;
    // u1
    let u1_value = u1;
    // u2
    let u2_value = u2;
    // u3
    let u3_value = u3;
    [q1_value, q2_value, q3_value, x_value, y_value, u1_value, u2_value, u3_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 21 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 3],
) -> ([S; 5], [S; 3]) {
    let Parameters {
        r, g_times_4, r_m_by_4, r_squared_m, r_squared_m_times_5_by_4, r_squared_m_times_3_by_2,
        ..
    } = *p;
    let [q2, q1, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let u3_c2_inv = u3 / c2;
    let s2_u3_c2_inv = u3_c2_inv * s2;
    // u3' = u1*(u3*tan(q2) - 2*u2)
    let u3_dot = u1 * (-u2).mul_add(S::int(2), s2_u3_c2_inv);
    // u2' = -u1*u3*r_squared_m/r_squared_m_times_3_by_2
    let u2_dot = -u1 * u3 * r_squared_m / r_squared_m_times_3_by_2;
    // u1' = r_m_by_4*(r*u3*(6*u2 - u3*tan(q2)) + g_times_4*sin(q2))/r_squared_m_times_5_by_4
    let u1_dot = r_m_by_4 * (r * u3 * u2.mul_add(S::int(6), -s2_u3_c2_inv) + g_times_4 * s2)
        / r_squared_m_times_5_by_4;
    // u2 - s2_u3_c2_inv
    let u2_minus_s2_u3_c2_inv = u2 - s2_u3_c2_inv;
    let r_u2_minus_s2_u3_c2_inv = r * u2_minus_s2_u3_c2_inv;
    // Values.
    // q2' = u1
    let q2_dot_value = u1;
    // q1' = u3/cos(q2)
    let q1_dot_value = u3_c2_inv;
    // y' = r*sin(q1)*(u2 - u3*tan(q2))
    let y_dot_value = r_u2_minus_s2_u3_c2_inv * s1;
    // x' = r*cos(q1)*(u2 - u3*tan(q2))
    let x_dot_value = r_u2_minus_s2_u3_c2_inv * c1;
    // q3' = u2 - u3*tan(q2)
    let q3_dot_value = u2_minus_s2_u3_c2_inv;
    (
        [q2_dot_value, q1_dot_value, y_dot_value, x_dot_value, q3_dot_value],
        [u1_dot, u2_dot, u3_dot],
    )
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], _u: &[S; 3]) -> [S; 1] {
    let [q2, _, _, _, _] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    // Values.
    // divisor1 = cos(q2)
    let divisor1 = c2;
    [divisor1]
}

/// The energy, then its derivatives by the state.
///
/// 22 operations, 1 sine and cosine.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 3]) -> [S; 9] {
    let Parameters { r, m, g, .. } = *p;
    let [q2, _, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let r_m = r * m;
    let r_r_m = r * r_m;
    let g_r_m = g * r_m;
    // Values.
    // T + V = r*m*g*cos(q2) + r^2*m*(5*u1^2 + 6*u2^2 + u3^2)/8
    let energy = S::ratio(1, 8) * r_r_m
        * u3.mul_add(u3, S::int(5) * u1 * u1 + S::int(6) * u2 * u2) + g_r_m * c2;
    // d(T + V)/d(q2) = -r*m*g*sin(q2)
    let energy_by_q2 = -g_r_m * s2;
    // d(T + V)/d(u1) = 5*r^2*m*u1/4
    let energy_by_u1 = S::ratio(5, 4) * u1 * r_r_m;
    // d(T + V)/d(u2) = 3*r^2*m*u2/2
    let energy_by_u2 = S::ratio(3, 2) * u2 * r_r_m;
    // d(T + V)/d(u3) = r^2*m*u3/4
    let energy_by_u3 = S::ratio(1, 4) * u3 * r_r_m;
    let zero = S::int(0);
    [
        energy, energy_by_q2, zero, zero, zero, zero, energy_by_u1, energy_by_u2, energy_by_u3,
    ]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 3],
    direction: &[S; 8],
) -> [S; 8] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[5 + i],
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
            coordinates: 5,
            variables: 3,
            speeds: 3,
            reactions: 0,
        }
    }
    fn symmetric(&self) -> bool {
        true
    }
    fn coordinate_rates(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &coordinate_rates(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn output_count(&self) -> usize {
        8
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
    fn divisor_count(&self) -> usize {
        1
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["cos(q2)"][at]
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
        kinetic_energy(&Parameters::from_slice(p), array(q), array(v))
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
    name: "roll",
    key: "5c88f531adb77930",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
