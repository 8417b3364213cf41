//! Symmetric rigid body free of forces: Steady precession.
//!
//! Generated from `models/free_body/scenes/steady.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    AtPoints, CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar,
    System, by_columns,
};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// across the axis, about the mass centre, kg*m^2
    pub I1: S,
    /// momentum p_x = ∂L/∂x', kg*m/s
    pub p_x: S,
    /// momentum p_y = ∂L/∂y', kg*m/s
    pub p_y: S,
    /// momentum p_z = ∂L/∂z', kg*m/s
    pub p_z: S,
    /// momentum p_psi = ∂L/∂psi', what is left of it on the singular surface, kg*m^2/s
    pub p_psi_there: S,
    /// generalized speed, constant with the momentum p_phi = ∂L/∂phi', 1/s
    pub w3: S,
    /// 2*x at the start, kg*m
    pub centre_x: S,
    /// 2*y at the start, kg*m
    pub centre_y: S,
    /// 2*z at the start, kg*m
    pub centre_z: S,
    /// p_z/2, 1
    pub p_z_by_2: S,
    /// p_y/2, 1
    pub p_y_by_2: S,
    /// p_x/2, 1
    pub p_x_by_2: S,
    /// w3/I1, 1/kg/m^2/s
    pub w3_per_I1: S,
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
            I1: p[0], p_x: p[1], p_y: p[2], p_z: p[3], p_psi_there: p[4], w3: p[5], centre_x: p[6],
            centre_y: p[7], centre_z: p[8], p_z_by_2: p[9], p_y_by_2: p[10], p_x_by_2: p[11],
            w3_per_I1: p[12],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 13] {
        let Self {
            I1, p_x, p_y, p_z, p_psi_there, w3, centre_x, centre_y, centre_z, p_z_by_2, p_y_by_2,
            p_x_by_2, w3_per_I1,
            ..
        } = self;
        [
            I1, p_x, p_y, p_z, p_psi_there, w3, centre_x, centre_y, centre_z, p_z_by_2, p_y_by_2,
            p_x_by_2, w3_per_I1,
        ]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 13] = [
    "I1", "p_x", "p_y", "p_z", "p_psi_there", "w3", "centre_x", "centre_y", "centre_z", "p_z_by_2",
    "p_y_by_2", "p_x_by_2", "w3_per_I1",
];

/// Names of the outputs.
pub const OUTPUTS: [&str; 12] = [
    "x", "y", "z", "psi", "theta", "phi", "v1", "v2", "v3", "w1", "w2", "w3",
];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 13 operations, 1 sine and cosine.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    q: &[S; 6],
    u: &[S; 6],
) -> [S; 13] {
    let super::super::super::Parameters { I1, .. } = *p;
    let [x, y, z, _, theta, _] = *q;
    let [v1, v2, v3, _, w2, w3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Values.
    // I1
    let I1_value = I1;
    // p_x = 2*v1
    let p_x_value = S::int(2) * v1;
    // p_y = 2*v2
    let p_y_value = S::int(2) * v2;
    // p_z = 2*v3
    let p_z_value = S::int(2) * v3;
    // p_psi_there = I1*w2*sin(theta) + w3*(cos(theta) - 1)/2
    let p_psi_there_value = S::ratio(1, 2) * w3 * (cos_theta - S::int(1)) + I1 * w2 * sin_theta;
    // w3
    let w3_value = w3;
    // centre_x = 2*x
    let centre_x_value = S::int(2) * x;
    // centre_y = 2*y
    let centre_y_value = S::int(2) * y;
    // centre_z = 2*z
    let centre_z_value = S::int(2) * z;
    // p_z_by_2 = v3
    let p_z_by_2_value = v3;
    // p_y_by_2 = v2
    let p_y_by_2_value = v2;
    // p_x_by_2 = v1
    let p_x_by_2_value = v1;
    // w3_per_I1 = w3/I1
    let w3_per_I1_value = w3 / I1;
    [
        I1_value, p_x_value, p_y_value, p_z_value, p_psi_there_value, w3_value, centre_x_value,
        centre_y_value, centre_z_value, p_z_by_2_value, p_y_by_2_value, p_x_by_2_value,
        w3_per_I1_value,
    ]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 6],
    u: &[S; 6],
) -> ([S; 3], [S; 1]) {
    let [_, _, _, psi, theta, phi] = *q;
    let [_, _, _, w1, _, _] = *u;
    // Values.
    // theta
    let theta_value = theta;
    // phi
    let phi_value = phi;
    // psi
    let psi_value = psi;
    // w1
    let w1_value = w1;
    ([theta_value, phi_value, psi_value], [w1_value])
}

/// The accelerations (w1'), solved for when this code was generated.
///
/// 13 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], _u: &[S; 1]) -> [S; 1] {
    let Parameters { I1, p_psi_there, w3, w3_per_I1, .. } = *p;
    let [theta, _, _] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta_inv = S::int(1) / sin_theta;
    let (sin_theta_by_2, _) = (S::ratio(1, 2) * theta).sin_cos();
    // w2 = (w3*sin(theta/2)^2 + p_psi_there)/(I1*sin(theta))
    let w2 = sin_theta_inv * (w3 * sin_theta_by_2 * sin_theta_by_2 + p_psi_there) / I1;
    // w1' = w2*(2*w2/tan(theta) - w3_per_I1)/2
    let w1_dot = S::ratio(1, 2) * w2
        * (w2 * sin_theta_inv * cos_theta).mul_add(S::int(2), -w3_per_I1);
    [w1_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 10 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 3] {
    let Parameters { I1, p_psi_there, w3, .. } = *p;
    let [theta, _, _] = *q;
    let [w1] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta_inv = S::int(1) / sin_theta;
    let (sin_theta_by_2, _) = (S::ratio(1, 2) * theta).sin_cos();
    // w2 = (w3*sin(theta/2)^2 + p_psi_there)/(I1*sin(theta))
    let w2 = sin_theta_inv * (w3 * sin_theta_by_2 * sin_theta_by_2 + p_psi_there) / I1;
    let w2_sin_theta_inv = w2 * sin_theta_inv;
    // Values.
    // theta' = w1
    let theta_dot_value = w1;
    // phi' = w3 - w2/tan(theta)
    let phi_dot_value = (-w2_sin_theta_inv).mul_add(cos_theta, w3);
    // psi' = w2/sin(theta)
    let psi_dot_value = w2_sin_theta_inv;
    [theta_dot_value, phi_dot_value, psi_dot_value]
}

/// Kinetic energy T.
///
/// 3 operations.
#[must_use]
#[inline(always)]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 3], u: &[S; 1]) -> S {
    let Parameters { I1, .. } = *p;
    let [w1] = *u;
    // Values.
    // T = I1*w1^2/2
    let energy = S::ratio(1, 2) * I1 * w1 * w1;
    energy
}

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// 18 operations, 2 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { I1, p_psi_there, w3, p_z_by_2, p_y_by_2, p_x_by_2, .. } = *p;
    let [theta, _, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    let (sin_theta_by_2, _) = (S::ratio(1, 2) * theta).sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w2 = (w3*sin(theta/2)^2 + p_psi_there)/(I1*sin(theta))
    let w2 = (w3 * sin_theta_by_2 * sin_theta_by_2 + p_psi_there) / (I1 * sin_theta);
    // v3 = p_z_by_2
    let v3 = p_z_by_2;
    // v2 = p_y_by_2
    let v2 = p_y_by_2;
    // v1 = p_x_by_2
    let v1 = p_x_by_2;
    // Values.
    // V = v1^2 + v2^2 + v3^2 + I1*w2^2/2 + w3^2/4
    let energy = v2.mul_add(v2, v1 * v1) + v3 * v3 + S::ratio(1, 2) * I1 * w2 * w2
        + S::ratio(1, 4) * w3 * w3;
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 16 operations, 2 sines and cosines.
#[must_use]
pub fn outputs<S: Scalar>(p: &Parameters<S>, t: S, q: &[S; 3], u: &[S; 1]) -> [S; 12] {
    let Parameters {
        I1, p_x, p_y, p_z, p_psi_there, w3, centre_x, centre_y, centre_z, p_z_by_2, p_y_by_2,
        p_x_by_2,
        ..
    } = *p;
    let [theta, phi, psi] = *q;
    let [w1] = *u;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    let (sin_theta_by_2, _) = (S::ratio(1, 2) * theta).sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w2 = (w3*sin(theta/2)^2 + p_psi_there)/(I1*sin(theta))
    let w2 = (w3 * sin_theta_by_2 * sin_theta_by_2 + p_psi_there) / (I1 * sin_theta);
    // v3 = p_z_by_2
    let v3 = p_z_by_2;
    // v2 = p_y_by_2
    let v2 = p_y_by_2;
    // v1 = p_x_by_2
    let v1 = p_x_by_2;
    let t_halved = S::ratio(1, 2) * t;
    // Values.
    // x = p_x*t/2 + centre_x/2
    let x_value = p_x.mul_add(t_halved, S::ratio(1, 2) * centre_x);
    // y = p_y*t/2 + centre_y/2
    let y_value = p_y.mul_add(t_halved, S::ratio(1, 2) * centre_y);
    // z = p_z*t/2 + centre_z/2
    let z_value = p_z.mul_add(t_halved, S::ratio(1, 2) * centre_z);
    // psi
    let psi_value = psi;
    // theta
    let theta_value = theta;
    // phi
    let phi_value = phi;
    // w1
    let w1_value = w1;
    // w3
    let w3_value = w3;
    [
        x_value, y_value, z_value, psi_value, theta_value, phi_value, v1, v2, v3, w1_value, w2,
        w3_value,
    ]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 14 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 1],
) -> ([S; 3], [S; 1]) {
    let Parameters { I1, p_psi_there, w3, w3_per_I1, .. } = *p;
    let [theta, _, _] = *q;
    let [w1] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta_inv = S::int(1) / sin_theta;
    let (sin_theta_by_2, _) = (S::ratio(1, 2) * theta).sin_cos();
    // w2 = (w3*sin(theta/2)^2 + p_psi_there)/(I1*sin(theta))
    let w2 = sin_theta_inv * (w3 * sin_theta_by_2 * sin_theta_by_2 + p_psi_there) / I1;
    let w2_sin_theta_inv = w2 * sin_theta_inv;
    let w1_dot_of_theta_w2 = w2_sin_theta_inv * cos_theta;
    // w1' = w2*(2*w2/tan(theta) - w3_per_I1)/2
    let w1_dot = S::ratio(1, 2) * w2 * w1_dot_of_theta_w2.mul_add(S::int(2), -w3_per_I1);
    // Values.
    // theta' = w1
    let theta_dot_value = w1;
    // phi' = w3 - w2/tan(theta)
    let phi_dot_value = w3 - w1_dot_of_theta_w2;
    // psi' = w2/sin(theta)
    let psi_dot_value = w2_sin_theta_inv;
    ([theta_dot_value, phi_dot_value, psi_dot_value], [w1_dot])
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
/// 31 operations, 2 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 5] {
    let Parameters { I1, p_psi_there, w3, p_z_by_2, p_y_by_2, p_x_by_2, .. } = *p;
    let [theta, _, _] = *q;
    let [w1] = *u;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let theta_halved = S::ratio(1, 2) * theta;
    let (sin_theta_by_2, cos_theta_by_2) = theta_halved.sin_cos();
    let sin_theta_by_2_sq = sin_theta_by_2 * sin_theta_by_2;
    let w3_sin_theta_by_2_sq = w3 * sin_theta_by_2_sq;
    // w2 = (w3*sin(theta/2)^2 + p_psi_there)/(I1*sin(theta))
    let w2 = (p_psi_there + w3_sin_theta_by_2_sq) / (I1 * sin_theta);
    // v3 = p_z_by_2
    let v3 = p_z_by_2;
    // v2 = p_y_by_2
    let v2 = p_y_by_2;
    // v1 = p_x_by_2
    let v1 = p_x_by_2;
    let energy_by_theta_of_theta = S::int(1) / (sin_theta_by_2 * cos_theta_by_2);
    // Values.
    // T + V = v1^2 + v2^2 + v3^2 + I1*w1^2/2 + I1*w2^2/2 + w3^2/4
    let energy = v1 * v1 + v2 * v2 + v3 * v3
        + S::ratio(1, 2) * I1 * w2.mul_add(w2, w1 * w1) + S::ratio(1, 4) * w3 * w3;
    // d(T + V)/d(theta) = w2*(w3*sin(theta/2)^2 + p_psi_there*(2*sin(theta/2)^2 -
    //   1))/(4*sin(theta/2)^2*cos(theta/2)^2)
    let energy_by_theta = S::ratio(1, 4) * w2 * energy_by_theta_of_theta * energy_by_theta_of_theta
        * (p_psi_there * sin_theta_by_2_sq.mul_add(S::int(2), -S::int(1)) + w3_sin_theta_by_2_sq);
    // d(T + V)/d(w1) = I1*w1
    let energy_by_w1 = I1 * w1;
    let zero = S::int(0);
    [energy, energy_by_theta, zero, zero, energy_by_w1]
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
/// 37 operations, 6 sines and cosines.
#[must_use]
#[inline(always)]
pub fn potential_slope<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> S {
    let Parameters { I1, p_psi_there, w3, .. } = *p;
    let [theta_from, theta_to] = *q;
    let [sinc1, sinc2] = *u;
    // Sines and cosines.
    let (sin_theta_from, _) = theta_from.sin_cos();
    let (sin_theta_to, _) = theta_to.sin_cos();
    let (_, cos_angle) = (S::ratio(1, 2) * theta_from + S::ratio(1, 2) * theta_to)
        .sin_cos();
    let (_, cos_angle_2) = (S::ratio(1, 4) * theta_from + S::ratio(1, 4) * theta_to)
        .sin_cos();
    let (sin_theta_from_by_2, _) = (S::ratio(1, 2) * theta_from).sin_cos();
    let (sin_theta_to_by_2, _) = (S::ratio(1, 2) * theta_to).sin_cos();
    // Shared terms.
    let w3_sin_theta_to_by_2_sq = w3 * sin_theta_to_by_2 * sin_theta_to_by_2;
    // Values.
    // (V(b) - V(a))/(b - a) = w3*sinc2*cos(theta_from/4 + theta_to/4)*(sin(theta_from/2) +
    //   sin(theta_to/2))*(2*p_psi_there + w3*sin(theta_from/2)^2 +
    //   w3*sin(theta_to/2)^2)/(4*I1*sin(theta_from)^2) - sinc1*cos(theta_from/2 +
    //   theta_to/2)*(sin(theta_from) + sin(theta_to))*(p_psi_there +
    //   w3*sin(theta_to/2)^2)^2/(2*I1*sin(theta_from)^2*sin(theta_to)^2)
    let slope = S::ratio(1, 4) * w3 * sinc2 * cos_angle_2
        * (sin_theta_from_by_2 + sin_theta_to_by_2)
        * (p_psi_there.mul_add(S::int(2), w3 * sin_theta_from_by_2 * sin_theta_from_by_2)
            + w3_sin_theta_to_by_2_sq) / (I1 * sin_theta_from * sin_theta_from)
        - S::ratio(1, 2) * sinc1 * cos_angle * (sin_theta_from + sin_theta_to)
            * (p_psi_there + w3_sin_theta_to_by_2_sq).powi(2)
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
            parameters: 13,
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
        12
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
    name: "steady",
    key: "3d6489c9e2742a90",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
