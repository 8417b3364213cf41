//! Gyroscope in gimbals: Nutation makes the outer ring walk.
//!
//! Generated from `models/gimbals/scenes/nutation.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    AtPoints, CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar,
    System, by_columns,
};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// outer ring, about its axis, kg*m^2
    pub Iz: S,
    /// inner ring, about the axis that it turns about in the outer, kg*m^2
    pub Ax: S,
    /// inner ring, across, kg*m^2
    pub Ay: S,
    /// inner ring, about the axis of the rotor, kg*m^2
    pub Az: S,
    /// rotor, across its axis, kg*m^2
    pub B: S,
    /// rotor, about its axis, kg*m^2
    pub C: S,
    /// momentum p_psi = ∂L/∂psi', kg*m^2/s
    pub p_psi: S,
    /// momentum p_phi = ∂L/∂phi', kg*m^2/s
    pub p_phi: S,
    /// p_phi/C, 1
    pub p_phi_per_C: S,
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
            Iz: p[0], Ax: p[1], Ay: p[2], Az: p[3], B: p[4], C: p[5], p_psi: p[6], p_phi: p[7],
            p_phi_per_C: p[8],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 9] {
        let Self { Iz, Ax, Ay, Az, B, C, p_psi, p_phi, p_phi_per_C, .. } = self;
        [Iz, Ax, Ay, Az, B, C, p_psi, p_phi, p_phi_per_C]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 9] = [
    "Iz", "Ax", "Ay", "Az", "B", "C", "p_psi", "p_phi", "p_phi_per_C",
];

/// Names of the outputs.
pub const OUTPUTS: [&str; 6] = ["psi", "theta", "phi", "u_psi", "u_theta", "u_phi"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 11 operations, 1 sine and cosine.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
) -> [S; 9] {
    let super::super::super::Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta, _] = *q;
    let [u_psi, _, u_phi] = *u;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Shared terms.
    // Ay + B
    let ay_plus_b = Ay + B;
    let u_psi_cos_theta = u_psi * cos_theta;
    // u_phi + u_psi_cos_theta
    let p_psi_value_of_place = u_phi + u_psi_cos_theta;
    let c_p_psi_value_of_place = C * p_psi_value_of_place;
    // Values.
    // Iz
    let Iz_value = Iz;
    // Ax
    let Ax_value = Ax;
    // Ay
    let Ay_value = Ay;
    // Az
    let Az_value = Az;
    // B
    let B_value = B;
    // C
    let C_value = C;
    // p_psi = u_psi*(Iz + sin(theta)^2*(Ay + B) + cos(theta)^2*(Az + C)) + C*u_phi*cos(theta)
    let p_psi_value = u_psi * (Iz + ay_plus_b)
        + cos_theta * (u_psi_cos_theta * (Az - ay_plus_b) + c_p_psi_value_of_place);
    // p_phi = C*(u_psi*cos(theta) + u_phi)
    let p_phi_value = c_p_psi_value_of_place;
    // p_phi_per_C = u_psi*cos(theta) + u_phi
    let p_phi_per_C_value = p_psi_value_of_place;
    [
        Iz_value, Ax_value, Ay_value, Az_value, B_value, C_value, p_psi_value, p_phi_value,
        p_phi_per_C_value,
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
    let [_, u_theta, _] = *u;
    // Values.
    // theta
    let theta_value = theta;
    // phi
    let phi_value = phi;
    // psi
    let psi_value = psi;
    // u_theta
    let u_theta_value = u_theta;
    ([theta_value, phi_value, psi_value], [u_theta_value])
}

/// The accelerations (u_theta'), solved for when this code was generated.
///
/// 20 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], _u: &[S; 1]) -> [S; 1] {
    let Parameters { Iz, Ax, Ay, Az, B, C, p_psi, p_phi, p_phi_per_C } = *p;
    let [theta, _, _] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // Ay - Az
    let ay_minus_az = Ay - Az;
    // B + ay_minus_az
    let b_plus_ay_minus_az = B + ay_minus_az;
    // u_psi = (p_psi - p_phi*cos(theta))/(Iz + Az + sin(theta)^2*(Ay - Az + B))
    let u_psi = (-p_phi).mul_add(cos_theta, p_psi)
        / (Iz + Az + b_plus_ay_minus_az * sin_theta * sin_theta);
    let u_psi_cos_theta = u_psi * cos_theta;
    // u_phi = p_phi_per_C - u_psi*cos(theta)
    let u_phi = p_phi_per_C - u_psi_cos_theta;
    // u_theta' = u_psi*sin(theta)*(u_psi*cos(theta)*(Ay - Az + B - C) - C*u_phi)/(Ax + B)
    let u_theta_dot = -u_psi * sin_theta
        * (u_psi_cos_theta * (C - b_plus_ay_minus_az) + C * u_phi) / (Ax + B);
    [u_theta_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 11 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 3] {
    let Parameters { Iz, Ay, Az, B, p_psi, p_phi, p_phi_per_C, .. } = *p;
    let [theta, _, _] = *q;
    let [u_theta] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u_psi = (p_psi - p_phi*cos(theta))/(Iz + Az + sin(theta)^2*(Ay - Az + B))
    let u_psi = (-p_phi).mul_add(cos_theta, p_psi)
        / (Iz + Az + sin_theta * sin_theta * (Ay - Az + B));
    // u_phi = p_phi_per_C - u_psi*cos(theta)
    let u_phi = (-u_psi).mul_add(cos_theta, p_phi_per_C);
    // Values.
    // theta' = u_theta
    let theta_dot_value = u_theta;
    [theta_dot_value, u_phi, u_psi]
}

/// Kinetic energy T.
///
/// 4 operations.
#[must_use]
#[inline(always)]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 3], u: &[S; 1]) -> S {
    let Parameters { Ax, B, .. } = *p;
    let [u_theta] = *u;
    // Values.
    // T = u_theta^2*(Ax + B)/2
    let energy = S::ratio(1, 2) * u_theta * u_theta * (Ax + B);
    energy
}

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// 24 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { Iz, Ay, Az, B, C, p_psi, p_phi, p_phi_per_C, .. } = *p;
    let [theta, _, _] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // Ay + B
    let ay_plus_b = Ay + B;
    // Az - ay_plus_b
    let az_minus_ay_plus_b = Az - ay_plus_b;
    // u_psi = (p_psi - p_phi*cos(theta))/(Iz + Az + sin(theta)^2*(Ay - Az + B))
    let u_psi = (-p_phi).mul_add(cos_theta, p_psi)
        / (Iz + Az - az_minus_ay_plus_b * sin_theta * sin_theta);
    let u_psi_cos_theta = u_psi * cos_theta;
    // u_phi = p_phi_per_C - u_psi*cos(theta)
    let u_phi = p_phi_per_C - u_psi_cos_theta;
    let c_u_phi = C * u_phi;
    // u_psi^2*(Iz + ay_plus_b) + u_psi_cos_theta^2*(C + az_minus_ay_plus_b)
    let energy_of_place = u_psi * u_psi * (Iz + ay_plus_b)
        + u_psi_cos_theta * u_psi_cos_theta * (C + az_minus_ay_plus_b);
    // u_phi*c_u_phi + energy_of_place
    let energy_of_place_2 = u_phi.mul_add(c_u_phi, energy_of_place);
    // Values.
    // V = u_psi^2*(Iz + sin(theta)^2*(Ay + B) + cos(theta)^2*(Az + C))/2 + C*u_phi^2/2 +
    //   C*u_psi*u_phi*cos(theta)
    let energy = u_psi_cos_theta.mul_add(c_u_phi, S::ratio(1, 2) * energy_of_place_2);
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 11 operations, 1 sine and cosine.
#[must_use]
pub fn outputs<S: Scalar>(p: &Parameters<S>, _t: S, q: &[S; 3], u: &[S; 1]) -> [S; 6] {
    let Parameters { Iz, Ay, Az, B, p_psi, p_phi, p_phi_per_C, .. } = *p;
    let [theta, phi, psi] = *q;
    let [u_theta] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u_psi = (p_psi - p_phi*cos(theta))/(Iz + Az + sin(theta)^2*(Ay - Az + B))
    let u_psi = (-p_phi).mul_add(cos_theta, p_psi)
        / (Iz + Az + sin_theta * sin_theta * (Ay - Az + B));
    // u_phi = p_phi_per_C - u_psi*cos(theta)
    let u_phi = (-u_psi).mul_add(cos_theta, p_phi_per_C);
    // Values.
    // psi
    let psi_value = psi;
    // theta
    let theta_value = theta;
    // phi
    let phi_value = phi;
    // u_theta
    let u_theta_value = u_theta;
    [psi_value, theta_value, phi_value, u_psi, u_theta_value, u_phi]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 20 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 1],
) -> ([S; 3], [S; 1]) {
    let Parameters { Iz, Ax, Ay, Az, B, C, p_psi, p_phi, p_phi_per_C } = *p;
    let [theta, _, _] = *q;
    let [u_theta] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // Ay - Az
    let ay_minus_az = Ay - Az;
    // B + ay_minus_az
    let b_plus_ay_minus_az = B + ay_minus_az;
    // u_psi = (p_psi - p_phi*cos(theta))/(Iz + Az + sin(theta)^2*(Ay - Az + B))
    let u_psi = (-p_phi).mul_add(cos_theta, p_psi)
        / (Iz + Az + b_plus_ay_minus_az * sin_theta * sin_theta);
    let u_psi_cos_theta = u_psi * cos_theta;
    // u_phi = p_phi_per_C - u_psi*cos(theta)
    let u_phi = p_phi_per_C - u_psi_cos_theta;
    // u_theta' = u_psi*sin(theta)*(u_psi*cos(theta)*(Ay - Az + B - C) - C*u_phi)/(Ax + B)
    let u_theta_dot = -u_psi * sin_theta
        * (u_psi_cos_theta * (C - b_plus_ay_minus_az) + C * u_phi) / (Ax + B);
    // Values.
    // theta' = u_theta
    let theta_dot_value = u_theta;
    ([theta_dot_value, u_phi, u_psi], [u_theta_dot])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 6 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(p: &Parameters<S>, q: &[S; 3], _u: &[S; 1]) -> [S; 1] {
    let Parameters { Iz, Ay, Az, B, .. } = *p;
    let [theta, _, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = Iz + Az + sin(theta)^2*(Ay - Az + B)
    let divisor1 = Iz + Az + sin_theta * sin_theta * (Ay - Az + B);
    [divisor1]
}

/// The energy, then its derivatives by the state.
///
/// 53 operations, 1 sine and cosine.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 5] {
    let Parameters { Iz, Ax, Ay, Az, B, C, p_psi, p_phi, p_phi_per_C } = *p;
    let [theta, _, _] = *q;
    let [u_theta] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // Iz + Az
    let iz_plus_az = Iz + Az;
    // Ay + B
    let ay_plus_b = Ay + B;
    // Az - ay_plus_b
    let az_minus_ay_plus_b = Az - ay_plus_b;
    let sin_theta_sq = sin_theta * sin_theta;
    let u_psi_of_place = az_minus_ay_plus_b * sin_theta_sq;
    // 1/(iz_plus_az - az_minus_ay_plus_b*sin_theta_sq)
    let u_psi_of_place_2 = S::int(1) / (iz_plus_az - u_psi_of_place);
    // u_psi = (p_psi - p_phi*cos(theta))/(Iz + Az + sin(theta)^2*(Ay - Az + B))
    let u_psi = u_psi_of_place_2 * (-p_phi).mul_add(cos_theta, p_psi);
    let u_psi_cos_theta = u_psi * cos_theta;
    // u_phi = p_phi_per_C - u_psi*cos(theta)
    let u_phi = p_phi_per_C - u_psi_cos_theta;
    let c_u_phi = C * u_phi;
    let u_psi_sin_theta = u_psi * sin_theta;
    // u_theta*(Ax + B)
    let energy_of_u_theta = u_theta * (Ax + B);
    // u_psi^2*(C + iz_plus_az) - u_psi_sin_theta^2*(C + az_minus_ay_plus_b)
    let energy_of_place = u_psi * u_psi * (C + iz_plus_az)
        - u_psi_sin_theta * u_psi_sin_theta * (C + az_minus_ay_plus_b);
    // u_phi*c_u_phi + u_theta*energy_of_u_theta
    let energy_of_u_theta_2 = u_theta.mul_add(energy_of_u_theta, u_phi * c_u_phi);
    // energy_of_place + energy_of_u_theta_2
    let energy_of_u_theta_3 = energy_of_place + energy_of_u_theta_2;
    // Az - 2*ay_plus_b
    let energy_by_theta_of_ay_az_b = (-ay_plus_b).mul_add(S::int(2), Az);
    // B^2 + Az*energy_by_theta_of_ay_az_b
    let energy_by_theta_of_ay_az_b_2 = Az.mul_add(energy_by_theta_of_ay_az_b, B * B);
    // Iz + az_minus_ay_plus_b*sin_theta_sq
    let energy_by_theta_of_place = Iz + u_psi_of_place;
    // Values.
    // T + V = u_psi^2*(Iz + sin(theta)^2*(Ay + B) + cos(theta)^2*(Az + C))/2 + u_theta^2*(Ax + B)/2 +
    //   C*u_phi^2/2 + C*u_psi*u_phi*cos(theta)
    let energy = u_psi_cos_theta.mul_add(c_u_phi, S::ratio(1, 2) * energy_of_u_theta_3);
    // d(T + V)/d(theta) = -u_psi*sin(theta)*(cos(theta)*(u_psi*(Az*(Iz - Ay + Az - B + sin(theta)^2*(2*Ay
    //   - Az + 2*B)) - Ay*(Iz + sin(theta)^2*(Ay + 2*B)) - B*(Iz + B*sin(theta)^2)) + 2*p_psi*(Ay - Az + B))
    //   + p_phi*(Az - Iz - 2*Ay - 2*B - sin(theta)^2*(Az - Ay - B)))/(Iz + Az + sin(theta)^2*(Ay - Az + B))
    let energy_by_theta = u_psi_of_place_2 * u_psi_sin_theta
        * (cos_theta
            * (az_minus_ay_plus_b * (-u_psi).mul_add(iz_plus_az, S::int(2) * p_psi)
                + u_psi_sin_theta * sin_theta
                    * (Ay * B.mul_add(S::int(2), Ay) + energy_by_theta_of_ay_az_b_2))
            + p_phi * (energy_by_theta_of_place - energy_by_theta_of_ay_az_b));
    // d(T + V)/d(u_theta) = u_theta*(Ax + B)
    let energy_by_u_theta = energy_of_u_theta;
    let zero = S::int(0);
    [energy, energy_by_theta, zero, zero, energy_by_u_theta]
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
/// 118 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn potential_slope<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> S {
    let Parameters { Iz, Ay, Az, B, C, p_psi, p_phi, .. } = *p;
    let [theta_from, theta_to] = *q;
    let [sinc1] = *u;
    // Sines and cosines.
    let (sin_theta_from, cos_theta_from) = theta_from.sin_cos();
    let (sin_theta_to, cos_theta_to) = theta_to.sin_cos();
    // Shared terms.
    // Ay + B
    let ay_plus_b = Ay + B;
    // Az + C
    let az_plus_c = Az + C;
    let c_inv_p_phi = p_phi / C;
    // Ay - Az + B
    let ay_minus_az_plus_b = Ay - Az + B;
    // theta_from/2 + theta_to/2
    let slope_of_place = S::ratio(1, 2) * theta_from + S::ratio(1, 2) * theta_to;
    let (sin_angle, cos_angle) = slope_of_place.sin_cos();
    // sin(theta_from) + sin(theta_to)
    let slope_of_place_2 = sin_theta_from + sin_theta_to;
    let p_phi_cos_theta_from = p_phi * cos_theta_from;
    let p_phi_cos_theta_to = p_phi * cos_theta_to;
    let slope_of_place_3 = sin_theta_from * sin_theta_from * ay_minus_az_plus_b;
    let slope_of_place_4 = sin_theta_to * sin_theta_to * ay_minus_az_plus_b;
    // p_psi - p_phi*cos(theta_from)
    let slope_of_place_5 = p_psi - p_phi_cos_theta_from;
    // p_psi - p_phi*cos(theta_to)
    let slope_of_place_6 = p_psi - p_phi_cos_theta_to;
    // Iz + Az + sin(theta_from)^2*(Ay - Az + B)
    let slope_of_place_7 = Iz + Az + slope_of_place_3;
    // Iz + Az + sin(theta_to)^2*(Ay - Az + B)
    let slope_of_place_8 = Iz + Az + slope_of_place_4;
    let slope_of_place_9 = cos_theta_to * slope_of_place_6 / slope_of_place_8;
    // sinc1*cos(theta_from)*cos(theta_from/2 + theta_to/2)*(Ay - Az + B)*(p_psi -
    //   p_phi*cos(theta_from))*(sin(theta_from) + sin(theta_to))/((Iz + Az + sin(theta_from)^2*(Ay - Az +
    //   B))*(Iz + Az + sin(theta_to)^2*(Ay - Az + B))) + (sinc1*sin(theta_from/2 + theta_to/2)*(p_psi -
    //   p_phi*cos(theta_to)) - p_phi*sinc1*cos(theta_from)*sin(theta_from/2 + theta_to/2))/(Iz + Az +
    //   sin(theta_to)^2*(Ay - Az + B))
    let slope_of_place_10 = sinc1 * cos_theta_from * cos_angle * ay_minus_az_plus_b
        * slope_of_place_5 * slope_of_place_2 / (slope_of_place_7 * slope_of_place_8)
        + (-(p_phi * sinc1 * cos_theta_from))
            .mul_add(sin_angle, sinc1 * sin_angle * slope_of_place_6) / slope_of_place_8;
    // Iz + sin(theta_from)^2*(Ay + B) + cos(theta_from)^2*(Az + C)
    let slope_of_place_11 = Iz + sin_theta_from * sin_theta_from * ay_plus_b
        + cos_theta_from * cos_theta_from * az_plus_c;
    // Values.
    // (V(b) - V(a))/(b - a) = sinc1*cos(theta_from/2 + theta_to/2)*(Az - Ay - B)*(p_psi -
    //   p_phi*cos(theta_from))^2*(Iz + sin(theta_from)^2*(Ay + B) + cos(theta_from)^2*(Az +
    //   C))*(sin(theta_from) + sin(theta_to))*(2*Iz + 2*Az + sin(theta_from)^2*(Ay - Az + B) +
    //   sin(theta_to)^2*(Ay - Az + B))/(2*(Iz + Az + sin(theta_from)^2*(Ay - Az + B))^2*(Iz + Az +
    //   sin(theta_to)^2*(Ay - Az + B))^2) + C*cos(theta_from)*(p_psi -
    //   p_phi*cos(theta_from))*(sinc1*cos(theta_from)*cos(theta_from/2 + theta_to/2)*(Ay - Az + B)*(p_psi -
    //   p_phi*cos(theta_from))*(sin(theta_from) + sin(theta_to))/((Iz + Az + sin(theta_from)^2*(Ay - Az +
    //   B))*(Iz + Az + sin(theta_to)^2*(Ay - Az + B))) + (sinc1*sin(theta_from/2 + theta_to/2)*(p_psi -
    //   p_phi*cos(theta_to)) - p_phi*sinc1*cos(theta_from)*sin(theta_from/2 + theta_to/2))/(Iz + Az +
    //   sin(theta_to)^2*(Ay - Az + B)))/(Iz + Az + sin(theta_from)^2*(Ay - Az + B)) + C*(2*p_phi/C +
    //   cos(theta_from)*(p_phi*cos(theta_from) - p_psi)/(Iz + Az + sin(theta_from)^2*(Ay - Az + B)) +
    //   cos(theta_to)*(p_phi*cos(theta_to) - p_psi)/(Iz + Az + sin(theta_to)^2*(Ay - Az +
    //   B)))*(sinc1*cos(theta_from)*cos(theta_from/2 + theta_to/2)*(Ay - Az + B)*(p_psi -
    //   p_phi*cos(theta_from))*(sin(theta_from) + sin(theta_to))/((Iz + Az + sin(theta_from)^2*(Ay - Az +
    //   B))*(Iz + Az + sin(theta_to)^2*(Ay - Az + B))) + (sinc1*sin(theta_from/2 + theta_to/2)*(p_psi -
    //   p_phi*cos(theta_to)) - p_phi*sinc1*cos(theta_from)*sin(theta_from/2 + theta_to/2))/(Iz + Az +
    //   sin(theta_to)^2*(Ay - Az + B)))/2 + (p_phi*sinc1*sin(theta_from/2 + theta_to/2)*(Iz +
    //   sin(theta_from)^2*(Ay + B) + cos(theta_from)^2*(Az + C))*(2*p_psi - p_phi*cos(theta_from) -
    //   p_phi*cos(theta_to)) + (p_psi - p_phi*cos(theta_to))^2*(sinc1*cos(theta_from/2 + theta_to/2)*(Ay +
    //   B)*(sin(theta_from) + sin(theta_to)) - sinc1*sin(theta_from/2 + theta_to/2)*(Az +
    //   C)*(cos(theta_from) + cos(theta_to))))/(2*(Iz + Az + sin(theta_to)^2*(Ay - Az + B))^2) - (p_phi/C +
    //   cos(theta_to)*(p_phi*cos(theta_to) - p_psi)/(Iz + Az + sin(theta_to)^2*(Ay - Az +
    //   B)))*(C*sinc1*cos(theta_from)*cos(theta_from/2 + theta_to/2)*(Ay - Az + B)*(p_psi -
    //   p_phi*cos(theta_from))*(sin(theta_from) + sin(theta_to))/((Iz + Az + sin(theta_from)^2*(Ay - Az +
    //   B))*(Iz + Az + sin(theta_to)^2*(Ay - Az + B))) + (C*sinc1*sin(theta_from/2 + theta_to/2)*(p_psi -
    //   p_phi*cos(theta_to)) - C*p_phi*sinc1*cos(theta_from)*sin(theta_from/2 + theta_to/2))/(Iz + Az +
    //   sin(theta_to)^2*(Ay - Az + B)))
    let slope = C * cos_theta_from * slope_of_place_5 * slope_of_place_10 / slope_of_place_7
        - S::ratio(1, 2) * sinc1 * cos_angle * ay_minus_az_plus_b * slope_of_place_5
            * slope_of_place_5 * slope_of_place_11 * slope_of_place_2
            * (Az.mul_add(S::int(2), S::int(2) * Iz) + slope_of_place_3 + slope_of_place_4)
            / (slope_of_place_7 * slope_of_place_7 * slope_of_place_8 * slope_of_place_8)
        + S::ratio(1, 2) * C
            * (c_inv_p_phi
                .mul_add(
                    S::int(2),
                    -cos_theta_from * slope_of_place_5 / slope_of_place_7,
                ) - slope_of_place_9) * slope_of_place_10
        + S::ratio(1, 2)
            * (p_phi * sinc1 * sin_angle * slope_of_place_11
                * (p_psi.mul_add(S::int(2), -p_phi_cos_theta_from) - p_phi_cos_theta_to)
                + slope_of_place_6 * slope_of_place_6
                    * (-sinc1 * sin_angle * az_plus_c * (cos_theta_from + cos_theta_to)
                        + sinc1 * cos_angle * ay_plus_b * slope_of_place_2))
            / (slope_of_place_8 * slope_of_place_8)
        + (slope_of_place_9 - c_inv_p_phi)
            * (C * sinc1 * cos_theta_from * cos_angle * ay_minus_az_plus_b
                * slope_of_place_5 * slope_of_place_2 / (slope_of_place_7 * slope_of_place_8)
                + (-(C * p_phi * sinc1 * cos_theta_from))
                    .mul_add(sin_angle, C * sinc1 * sin_angle * slope_of_place_6)
                    / slope_of_place_8);
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
        Some(core::f64::consts::TAU)
    }
    fn at_points(&self) -> Option<AtPoints<'_>> {
        Some(AtPoints::of(&Derivative(Reduced)))
    }
    fn divisor_count(&self) -> usize {
        1
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["Iz + Az + sin(theta)^2*(Ay - Az + B)"][at]
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
    name: "nutation",
    key: "e98e6488f93b4ecf",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
