//! Symmetric heavy top about a fixed point: Looping.
//!
//! Generated from `models/heavy_top/scenes/looping.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar, System,
    by_columns,
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
    /// momentum p_q3 = ∂L/∂q3', kg*m^2/s
    pub p_q3: S,
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
            m: p[0], l: p[1], I1: p[2], I3: p[3], g: p[4], p_q3: p[5], m_l_g: p[6],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 7] {
        let Self { m, l, I1, I3, g, p_q3, m_l_g, .. } = self;
        [m, l, I1, I3, g, p_q3, m_l_g]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 7] = ["m", "l", "I1", "I3", "g", "p_q3", "m_l_g"];

/// Names of the outputs.
pub const OUTPUTS: [&str; 6] = ["q1", "q2", "q3", "u1", "u2", "u3"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 3 operations.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    _q: &[S; 3],
    u: &[S; 3],
) -> [S; 7] {
    let super::super::super::Parameters { m, l, I1, I3, g } = *p;
    let [_, _, u3] = *u;
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
    // p_q3 = I3*u3
    let p_q3_value = I3 * u3;
    // m_l_g = m*l*g
    let m_l_g_value = m * l * g;
    [m_value, l_value, I1_value, I3_value, g_value, p_q3_value, m_l_g_value]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
) -> ([S; 3], [S; 2]) {
    let [q1, q2, q3] = *q;
    let [u1, u2, _] = *u;
    // Values.
    // q1
    let q1_value = q1;
    // q2
    let q2_value = q2;
    // q3
    let q3_value = q3;
    // u1
    let u1_value = u1;
    // u2
    let u2_value = u2;
    ([q1_value, q2_value, q3_value], [u1_value, u2_value])
}

/// The accelerations (u1', u2'), solved for when this code was generated.
///
/// 15 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 2] {
    let Parameters { I1, I3, p_q3, m_l_g, .. } = *p;
    let [q1, q2, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u3 = p_q3/I3
    let u3 = p_q3 / I3;
    let i1_inv = S::int(1) / I1;
    let t2 = s2 / c2;
    // I3*u3*i1_inv - u1*tan(q2)
    let u2_dot_of_u1 = (-u1).mul_add(t2, I3 * u3 * i1_inv);
    let m_l_g_i1_inv = m_l_g * i1_inv;
    // u2' = (u1*(I3*u3 - I1*u1*tan(q2)) + m_l_g*cos(q1)*sin(q2))/I1
    let u2_dot = (m_l_g_i1_inv * c1).mul_add(s2, u1 * u2_dot_of_u1);
    // u1' = (m_l_g*sin(q1) - u2*(I3*u3 - I1*u1*tan(q2)))/I1
    let u1_dot = (-u2).mul_add(u2_dot_of_u1, m_l_g_i1_inv * s1);
    [u1_dot, u2_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 3] {
    let Parameters { I3, p_q3, .. } = *p;
    let [_, q2, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u3 = p_q3/I3
    let u3 = p_q3 / I3;
    let u1_c2_inv = u1 / c2;
    // Values.
    // q1' = u1/cos(q2)
    let q1_dot_value = u1_c2_inv;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3 - u1*tan(q2)
    let q3_dot_value = (-u1_c2_inv).mul_add(s2, u3);
    [q1_dot_value, q2_dot_value, q3_dot_value]
}

/// Kinetic energy T.
///
/// 5 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 3], u: &[S; 2]) -> S {
    let Parameters { I1, .. } = *p;
    let [u1, u2] = *u;
    // Values.
    // T = I1*(u1^2 + u2^2)/2
    let energy = S::ratio(1, 2) * I1 * u2.mul_add(u2, u1 * u1);
    energy
}

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// 9 operations, 2 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { m, l, I3, g, p_q3, .. } = *p;
    let [q1, q2, _] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    let (_, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u3 = p_q3/I3
    let u3 = p_q3 / I3;
    // Values.
    // V = m*l*g*cos(q1)*cos(q2) + I3*u3^2/2
    let energy = (m * l * g * c1).mul_add(c2, S::ratio(1, 2) * I3 * u3 * u3);
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 1 operation.
#[must_use]
pub fn outputs<S: Scalar>(p: &Parameters<S>, _t: S, q: &[S; 3], u: &[S; 2]) -> [S; 6] {
    let Parameters { I3, p_q3, .. } = *p;
    let [q1, q2, q3] = *q;
    let [u1, u2] = *u;
    // Elimination, step by step, each after the terms that it shares.
    // u3 = p_q3/I3
    let u3 = p_q3 / I3;
    // Values.
    // q1
    let q1_value = q1;
    // q2
    let q2_value = q2;
    // q3
    let q3_value = q3;
    // u1
    let u1_value = u1;
    // u2
    let u2_value = u2;
    [q1_value, q2_value, q3_value, u1_value, u2_value, u3]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 16 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 2],
) -> ([S; 3], [S; 2]) {
    let Parameters { I1, I3, p_q3, m_l_g, .. } = *p;
    let [q1, q2, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u3 = p_q3/I3
    let u3 = p_q3 / I3;
    let i1_inv = S::int(1) / I1;
    let u1_c2_inv = u1 / c2;
    let s2_u1_c2_inv = u1_c2_inv * s2;
    // I3*u3*i1_inv - s2_u1_c2_inv
    let u2_dot_of_u1 = (I3 * u3).mul_add(i1_inv, -s2_u1_c2_inv);
    let m_l_g_i1_inv = m_l_g * i1_inv;
    // u2' = (u1*(I3*u3 - I1*u1*tan(q2)) + m_l_g*cos(q1)*sin(q2))/I1
    let u2_dot = (m_l_g_i1_inv * c1).mul_add(s2, u1 * u2_dot_of_u1);
    // u1' = (m_l_g*sin(q1) - u2*(I3*u3 - I1*u1*tan(q2)))/I1
    let u1_dot = (-u2).mul_add(u2_dot_of_u1, m_l_g_i1_inv * s1);
    // Values.
    // q1' = u1/cos(q2)
    let q1_dot_value = u1_c2_inv;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3 - u1*tan(q2)
    let q3_dot_value = u3 - s2_u1_c2_inv;
    ([q1_dot_value, q2_dot_value, q3_dot_value], [u1_dot, u2_dot])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], _u: &[S; 2]) -> [S; 1] {
    let [_, q2, _] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    // Values.
    // divisor1 = cos(q2)
    let divisor1 = c2;
    [divisor1]
}

/// The energy, then its derivatives by the state.
///
/// 21 operations, 2 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 6] {
    let Parameters { m, l, I1, I3, g, p_q3, .. } = *p;
    let [q1, q2, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u3 = p_q3/I3
    let u3 = p_q3 / I3;
    let m_l_g_2 = m * l * g;
    let c2_m_l_g_2 = m_l_g_2 * c2;
    // I1*(u1^2 + u2^2) + I3*u3^2
    let energy_of_u1_u2 = I1 * u2.mul_add(u2, u1 * u1) + I3 * u3 * u3;
    // Values.
    // T + V = m*l*g*cos(q1)*cos(q2) + I1*(u1^2 + u2^2)/2 + I3*u3^2/2
    let energy = c2_m_l_g_2.mul_add(c1, S::ratio(1, 2) * energy_of_u1_u2);
    // d(T + V)/d(q1) = -m*l*g*sin(q1)*cos(q2)
    let energy_by_q1 = -c2_m_l_g_2 * s1;
    // d(T + V)/d(q2) = -m*l*g*cos(q1)*sin(q2)
    let energy_by_q2 = -m_l_g_2 * c1 * s2;
    // d(T + V)/d(u1) = I1*u1
    let energy_by_u1 = I1 * u1;
    // d(T + V)/d(u2) = I1*u2
    let energy_by_u2 = I1 * u2;
    let zero = S::int(0);
    [energy, energy_by_q1, energy_by_q2, zero, energy_by_u1, energy_by_u2]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 2],
    direction: &[S; 5],
) -> [S; 5] {
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
            parameters: 7,
            coordinates: 3,
            variables: 2,
            speeds: 2,
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
    name: "looping",
    key: "36b00938617f9a76",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
