//! Furuta pendulum: The pendulum falls from upright.
//!
//! Generated from `models/furuta/scenes/swing.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar, System,
    by_columns,
};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// length of the arm, m
    pub L1: S,
    /// from the shaft to the mass centre of the arm, m
    pub l1: S,
    /// mass of the arm, kg
    pub m1: S,
    /// moment of inertia of the arm, across it, kg*m^2
    pub J1: S,
    /// from the joint to the mass centre of the pendulum, m
    pub l2: S,
    /// mass of the pendulum, kg
    pub m2: S,
    /// moment of inertia of the pendulum, across it, kg*m^2
    pub J2: S,
    /// damping of the motor, kg*m^2/s
    pub b1: S,
    /// damping of the joint, kg*m^2/s
    pub b2: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// momentum p_theta1 + b1*theta1, where p_theta1 = ∂L/∂theta1', kg*m^2/s
    pub p_theta1_total: S,
    /// l2^2, m^2
    pub l2_squared: S,
    /// l1^2*m1, kg*m^2
    pub l1_squared_m1: S,
    /// L1*l2*m2, kg*m^2
    pub L1_l2_m2: S,
    /// l2^2*m2, kg*m^2
    pub l2_squared_m2: S,
    /// l2*m2, kg*m
    pub l2_m2: S,
    /// L1^2*m2, kg*m^2
    pub L1_squared_m2: S,
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
            L1: p[0], l1: p[1], m1: p[2], J1: p[3], l2: p[4], m2: p[5], J2: p[6], b1: p[7],
            b2: p[8], g: p[9], p_theta1_total: p[10], l2_squared: p[11], l1_squared_m1: p[12],
            L1_l2_m2: p[13], l2_squared_m2: p[14], l2_m2: p[15], L1_squared_m2: p[16],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 17] {
        let Self {
            L1, l1, m1, J1, l2, m2, J2, b1, b2, g, p_theta1_total, l2_squared, l1_squared_m1,
            L1_l2_m2, l2_squared_m2, l2_m2, L1_squared_m2,
            ..
        } = self;
        [
            L1, l1, m1, J1, l2, m2, J2, b1, b2, g, p_theta1_total, l2_squared, l1_squared_m1,
            L1_l2_m2, l2_squared_m2, l2_m2, L1_squared_m2,
        ]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 17] = [
    "L1", "l1", "m1", "J1", "l2", "m2", "J2", "b1", "b2", "g", "p_theta1_total", "l2_squared",
    "l1_squared_m1", "L1_l2_m2", "l2_squared_m2", "l2_m2", "L1_squared_m2",
];

/// Names of the outputs.
pub const OUTPUTS: [&str; 4] = ["theta1", "theta2", "u_theta1", "u_theta2"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 20 operations, 1 sine and cosine.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> [S; 17] {
    let super::super::super::Parameters { L1, l1, m1, J1, l2, m2, J2, b1, b2, g, .. } = *p;
    let [theta1, theta2] = *q;
    let [u_theta1, u_theta2] = *u;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Shared terms.
    let l2_m2_2 = l2 * m2;
    let l1_l2_m2_2 = L1 * l2_m2_2;
    let l1_sq_m1 = l1 * l1 * m1;
    let l1_sq_m2 = L1 * L1 * m2;
    let l2_l2_m2_2 = l2 * l2_m2_2;
    // J1 + sin(theta2)^2*(J2 + l2_l2_m2_2)
    let p_theta1_total_value_of_place = J1 + sin_theta2 * sin_theta2 * (J2 + l2_l2_m2_2);
    // l1_sq_m2 + p_theta1_total_value_of_place
    let p_theta1_total_value_of_place_2 = l1_sq_m2 + p_theta1_total_value_of_place;
    // Values.
    // L1
    let L1_value = L1;
    // l1
    let l1_value = l1;
    // m1
    let m1_value = m1;
    // J1
    let J1_value = J1;
    // l2
    let l2_value = l2;
    // m2
    let m2_value = m2;
    // J2
    let J2_value = J2;
    // b1
    let b1_value = b1;
    // b2
    let b2_value = b2;
    // g
    let g_value = g;
    // p_theta1_total = b1*theta1 + u_theta1*(l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(L1^2 +
    //   l2^2*sin(theta2)^2)) + L1*l2*m2*u_theta2*cos(theta2)
    let p_theta1_total_value = b1 * theta1 + u_theta2 * l1_l2_m2_2 * cos_theta2
        + u_theta1 * (l1_sq_m1 + p_theta1_total_value_of_place_2);
    // l2_squared = l2^2
    let l2_squared_value = l2 * l2;
    // l1_squared_m1 = l1^2*m1
    let l1_squared_m1_value = l1_sq_m1;
    // L1_l2_m2 = L1*l2*m2
    let L1_l2_m2_value = l1_l2_m2_2;
    // l2_squared_m2 = l2^2*m2
    let l2_squared_m2_value = l2_l2_m2_2;
    // l2_m2 = l2*m2
    let l2_m2_value = l2_m2_2;
    // L1_squared_m2 = L1^2*m2
    let L1_squared_m2_value = l1_sq_m2;
    [
        L1_value, l1_value, m1_value, J1_value, l2_value, m2_value, J2_value, b1_value, b2_value,
        g_value, p_theta1_total_value, l2_squared_value, l1_squared_m1_value, L1_l2_m2_value,
        l2_squared_m2_value, l2_m2_value, L1_squared_m2_value,
    ]
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
    let [theta1, theta2] = *q;
    let [_, u_theta2] = *u;
    // Values.
    // theta1
    let theta1_value = theta1;
    // theta2
    let theta2_value = theta2;
    // u_theta2
    let u_theta2_value = u_theta2;
    ([theta1_value, theta2_value], [u_theta2_value])
}

/// The accelerations (u_theta2'), solved for when this code was generated.
///
/// 43 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> [S; 1] {
    let Parameters {
        L1, J1, l2, m2, J2, b1, b2, g, p_theta1_total, l2_squared, l1_squared_m1, L1_l2_m2,
        l2_squared_m2, l2_m2, L1_squared_m2,
        ..
    } = *p;
    let [theta1, theta2] = *q;
    let [u_theta2] = *u;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta2_sq = sin_theta2 * sin_theta2;
    // 1/(J1 + l1_squared_m1 + J2*sin_theta2_sq + m2*(L1^2 + l2_squared*sin_theta2_sq))
    let u_theta1_of_place = S::int(1)
        / (J1 + l1_squared_m1 + J2 * sin_theta2_sq
            + m2 * l2_squared.mul_add(sin_theta2_sq, L1 * L1));
    let u_theta1_of_place_2 = u_theta1_of_place * cos_theta2;
    let u_theta2_l1_l2_m2 = u_theta2 * L1_l2_m2;
    // u_theta1 = (p_theta1_total - b1*theta1 - u_theta2*L1_l2_m2*cos(theta2))/(J1 + J2*sin(theta2)^2 +
    //   m2*(L1^2 + l2_squared*sin(theta2)^2) + l1_squared_m1)
    let u_theta1 = u_theta1_of_place * (-b1).mul_add(theta1, p_theta1_total)
        - u_theta1_of_place_2 * u_theta2_l1_l2_m2;
    // J2 + l2_squared_m2
    let j2_plus_l2_squared_m2 = J2 + l2_squared_m2;
    let u_theta1_cos_theta2 = u_theta1 * cos_theta2;
    // b2*u_theta2 - L1_l2_m2*u_theta1_of_place_2*(b1*u_theta1 +
    //   u_theta2*sin(theta2)*(2*j2_plus_l2_squared_m2*u_theta1_cos_theta2 - u_theta2_l1_l2_m2))
    let u_theta2_dot_of_u_theta2 = -L1_l2_m2 * u_theta1_of_place_2
        * (u_theta2 * sin_theta2
            * (j2_plus_l2_squared_m2 * u_theta1_cos_theta2)
                .mul_add(S::int(2), -u_theta2_l1_l2_m2) + b1 * u_theta1) + b2 * u_theta2;
    // u_theta2' = (sin(theta2)*(J2*u_theta1^2*cos(theta2) + l2_m2*(l2*u_theta1^2*cos(theta2) - g)) -
    //   b2*u_theta2 - L1_l2_m2*cos(theta2)*(u_theta2^2*L1_l2_m2*sin(theta2) - u_theta1*(b1 +
    //   2*u_theta2*sin(theta2)*cos(theta2)*(J2 + l2_squared_m2)))/(J1 + J2*sin(theta2)^2 + m2*(L1^2 +
    //   l2_squared*sin(theta2)^2) + l1_squared_m1))/(J2 + l2_squared_m2*(1 - L1_squared_m2*cos(theta2)^2/(J1
    //   + J2*sin(theta2)^2 + m2*(L1^2 + l2_squared*sin(theta2)^2) + l1_squared_m1)))
    let u_theta2_dot = (sin_theta2
        * (-u_theta1 * u_theta1_cos_theta2 * l2.mul_add(l2_m2, J2) + g * l2_m2)
        + u_theta2_dot_of_u_theta2)
        / (l2_squared_m2 * L1_squared_m2 * u_theta1_of_place_2)
            .mul_add(cos_theta2, -j2_plus_l2_squared_m2);
    [u_theta2_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 15 operations, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> [S; 2] {
    let Parameters {
        L1, J1, m2, J2, b1, p_theta1_total, l2_squared, l1_squared_m1, L1_l2_m2,
        ..
    } = *p;
    let [theta1, theta2] = *q;
    let [u_theta2] = *u;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta2_sq = sin_theta2 * sin_theta2;
    // u_theta1 = (p_theta1_total - b1*theta1 - u_theta2*L1_l2_m2*cos(theta2))/(J1 + J2*sin(theta2)^2 +
    //   m2*(L1^2 + l2_squared*sin(theta2)^2) + l1_squared_m1)
    let u_theta1 = ((-b1).mul_add(theta1, p_theta1_total) - u_theta2 * L1_l2_m2 * cos_theta2)
        / (J1 + l1_squared_m1 + J2 * sin_theta2_sq
            + m2 * l2_squared.mul_add(sin_theta2_sq, L1 * L1));
    // Values.
    // theta2' = u_theta2
    let theta2_dot_value = u_theta2;
    [u_theta1, theta2_dot_value]
}

/// Kinetic energy T.
///
/// 0 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 2], _u: &[S; 1]) -> S {
    let zero = S::int(0);
    zero
}

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// 0 operations.
#[must_use]
pub fn potential_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 2]) -> S {
    let zero = S::int(0);
    zero
}

/// What the scene asks for, a time t after the start.
///
/// 15 operations, 1 sine and cosine.
#[must_use]
pub fn outputs<S: Scalar>(p: &Parameters<S>, _t: S, q: &[S; 2], u: &[S; 1]) -> [S; 4] {
    let Parameters {
        L1, J1, m2, J2, b1, p_theta1_total, l2_squared, l1_squared_m1, L1_l2_m2,
        ..
    } = *p;
    let [theta1, theta2] = *q;
    let [u_theta2] = *u;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta2_sq = sin_theta2 * sin_theta2;
    // u_theta1 = (p_theta1_total - b1*theta1 - u_theta2*L1_l2_m2*cos(theta2))/(J1 + J2*sin(theta2)^2 +
    //   m2*(L1^2 + l2_squared*sin(theta2)^2) + l1_squared_m1)
    let u_theta1 = ((-b1).mul_add(theta1, p_theta1_total) - u_theta2 * L1_l2_m2 * cos_theta2)
        / (J1 + l1_squared_m1 + J2 * sin_theta2_sq
            + m2 * l2_squared.mul_add(sin_theta2_sq, L1 * L1));
    // Values.
    // theta1
    let theta1_value = theta1;
    // theta2
    let theta2_value = theta2;
    // u_theta2
    let u_theta2_value = u_theta2;
    [theta1_value, theta2_value, u_theta1, u_theta2_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 43 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
) -> ([S; 2], [S; 1]) {
    let Parameters {
        L1, J1, l2, m2, J2, b1, b2, g, p_theta1_total, l2_squared, l1_squared_m1, L1_l2_m2,
        l2_squared_m2, l2_m2, L1_squared_m2,
        ..
    } = *p;
    let [theta1, theta2] = *q;
    let [u_theta2] = *u;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta2_sq = sin_theta2 * sin_theta2;
    // 1/(J1 + l1_squared_m1 + J2*sin_theta2_sq + m2*(L1^2 + l2_squared*sin_theta2_sq))
    let u_theta1_of_place = S::int(1)
        / (J1 + l1_squared_m1 + J2 * sin_theta2_sq
            + m2 * l2_squared.mul_add(sin_theta2_sq, L1 * L1));
    let u_theta1_of_place_2 = u_theta1_of_place * cos_theta2;
    let u_theta2_l1_l2_m2 = u_theta2 * L1_l2_m2;
    // u_theta1 = (p_theta1_total - b1*theta1 - u_theta2*L1_l2_m2*cos(theta2))/(J1 + J2*sin(theta2)^2 +
    //   m2*(L1^2 + l2_squared*sin(theta2)^2) + l1_squared_m1)
    let u_theta1 = u_theta1_of_place * (-b1).mul_add(theta1, p_theta1_total)
        - u_theta1_of_place_2 * u_theta2_l1_l2_m2;
    // J2 + l2_squared_m2
    let j2_plus_l2_squared_m2 = J2 + l2_squared_m2;
    let u_theta1_cos_theta2 = u_theta1 * cos_theta2;
    // b2*u_theta2 - L1_l2_m2*u_theta1_of_place_2*(b1*u_theta1 +
    //   u_theta2*sin(theta2)*(2*j2_plus_l2_squared_m2*u_theta1_cos_theta2 - u_theta2_l1_l2_m2))
    let u_theta2_dot_of_u_theta2 = -L1_l2_m2 * u_theta1_of_place_2
        * (u_theta2 * sin_theta2
            * (j2_plus_l2_squared_m2 * u_theta1_cos_theta2)
                .mul_add(S::int(2), -u_theta2_l1_l2_m2) + b1 * u_theta1) + b2 * u_theta2;
    // u_theta2' = (sin(theta2)*(J2*u_theta1^2*cos(theta2) + l2_m2*(l2*u_theta1^2*cos(theta2) - g)) -
    //   b2*u_theta2 - L1_l2_m2*cos(theta2)*(u_theta2^2*L1_l2_m2*sin(theta2) - u_theta1*(b1 +
    //   2*u_theta2*sin(theta2)*cos(theta2)*(J2 + l2_squared_m2)))/(J1 + J2*sin(theta2)^2 + m2*(L1^2 +
    //   l2_squared*sin(theta2)^2) + l1_squared_m1))/(J2 + l2_squared_m2*(1 - L1_squared_m2*cos(theta2)^2/(J1
    //   + J2*sin(theta2)^2 + m2*(L1^2 + l2_squared*sin(theta2)^2) + l1_squared_m1)))
    let u_theta2_dot = (sin_theta2
        * (-u_theta1 * u_theta1_cos_theta2 * l2.mul_add(l2_m2, J2) + g * l2_m2)
        + u_theta2_dot_of_u_theta2)
        / (l2_squared_m2 * L1_squared_m2 * u_theta1_of_place_2)
            .mul_add(cos_theta2, -j2_plus_l2_squared_m2);
    // Values.
    // theta2' = u_theta2
    let theta2_dot_value = u_theta2;
    ([u_theta1, theta2_dot_value], [u_theta2_dot])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 15 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 1]) -> [S; 2] {
    let Parameters {
        L1, J1, m2, J2, l2_squared, l1_squared_m1, l2_squared_m2, L1_squared_m2,
        ..
    } = *p;
    let [_, theta2] = *q;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Shared terms.
    let sin_theta2_sq = sin_theta2 * sin_theta2;
    // J2*sin_theta2_sq + m2*(L1^2 + l2_squared*sin_theta2_sq)
    let divisor1_of_place = m2 * l2_squared.mul_add(sin_theta2_sq, L1 * L1) + J2 * sin_theta2_sq;
    // J1 + l1_squared_m1
    let j1_plus_l1_squared_m1 = J1 + l1_squared_m1;
    // divisor1_of_place + j1_plus_l1_squared_m1
    let divisor1_of_place_2 = divisor1_of_place + j1_plus_l1_squared_m1;
    // Values.
    // divisor1 = J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2_squared*sin(theta2)^2) + l1_squared_m1
    let divisor1 = divisor1_of_place_2;
    // divisor2 = J2 + l2_squared_m2*(1 - L1_squared_m2*cos(theta2)^2/(J1 + J2*sin(theta2)^2 + m2*(L1^2 +
    //   l2_squared*sin(theta2)^2) + l1_squared_m1))
    let divisor2 = J2
        + l2_squared_m2
            * (S::int(1) - L1_squared_m2 * cos_theta2 * cos_theta2 / divisor1_of_place_2);
    [divisor1, divisor2]
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
            parameters: 17,
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
        out.copy_from_slice(
            &coordinate_rates(&Parameters::from_slice(p), array(q), array(v)),
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
    fn divisor_count(&self) -> usize {
        2
    }
    fn divisor_name(&self, at: usize) -> &str {
        [
            "J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2_squared*sin(theta2)^2) + l1_squared_m1",
            "divisor 2 of the accelerations",
        ][at]
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
    name: "swing",
    key: "48552da903aa559d",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
