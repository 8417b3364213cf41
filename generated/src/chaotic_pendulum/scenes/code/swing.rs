//! Chaotic pendulum: a swinging rod with a plate turning about it: Swing with a turning plate.
//!
//! Generated from `models/chaotic_pendulum/scenes/swing.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar, System,
    by_columns,
};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// mass of the rod, kg
    pub mA: S,
    /// pin to the centre of the rod, m
    pub lA: S,
    /// pin to the centre of the plate, m
    pub lB: S,
    /// rod, across its axis, kg*m^2
    pub IAxx: S,
    /// plate, about its first axis, kg*m^2
    pub IBxx: S,
    /// plate, about its second axis, kg*m^2
    pub IByy: S,
    /// plate, about the rod, kg*m^2
    pub IBzz: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// 3*lB, m
    pub lB_times_3: S,
    /// 2*mA*lA, kg*m
    pub mA_lA_times_2: S,
    /// g/2, m/s^2
    pub g_by_2: S,
    /// mA*lA^2, kg*m^2
    pub mA_lA_squared: S,
    /// 3*lB^2/2, m^2
    pub lB_squared_times_3_by_2: S,
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
            mA: p[0], lA: p[1], lB: p[2], IAxx: p[3], IBxx: p[4], IByy: p[5], IBzz: p[6], g: p[7],
            lB_times_3: p[8], mA_lA_times_2: p[9], g_by_2: p[10], mA_lA_squared: p[11],
            lB_squared_times_3_by_2: p[12],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 13] {
        let Self {
            mA, lA, lB, IAxx, IBxx, IByy, IBzz, g, lB_times_3, mA_lA_times_2, g_by_2, mA_lA_squared,
            lB_squared_times_3_by_2,
            ..
        } = self;
        [
            mA, lA, lB, IAxx, IBxx, IByy, IBzz, g, lB_times_3, mA_lA_times_2, g_by_2, mA_lA_squared,
            lB_squared_times_3_by_2,
        ]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 13] = [
    "mA", "lA", "lB", "IAxx", "IBxx", "IByy", "IBzz", "g", "lB_times_3", "mA_lA_times_2", "g_by_2",
    "mA_lA_squared", "lB_squared_times_3_by_2",
];

/// Names of the outputs.
pub const OUTPUTS: [&str; 4] = ["theta", "phi", "omega", "alpha"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 7 operations.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    _q: &[S; 2],
    _u: &[S; 2],
) -> [S; 13] {
    let super::super::super::Parameters { mA, lA, lB, IAxx, IBxx, IByy, IBzz, g, .. } = *p;
    // Shared terms.
    let ma_la = mA * lA;
    // Values.
    // mA
    let mA_value = mA;
    // lA
    let lA_value = lA;
    // lB
    let lB_value = lB;
    // IAxx
    let IAxx_value = IAxx;
    // IBxx
    let IBxx_value = IBxx;
    // IByy
    let IByy_value = IByy;
    // IBzz
    let IBzz_value = IBzz;
    // g
    let g_value = g;
    // lB_times_3 = 3*lB
    let lB_times_3_value = S::int(3) * lB;
    // mA_lA_times_2 = 2*mA*lA
    let mA_lA_times_2_value = S::int(2) * ma_la;
    // g_by_2 = g/2
    let g_by_2_value = S::ratio(1, 2) * g;
    // mA_lA_squared = mA*lA^2
    let mA_lA_squared_value = lA * ma_la;
    // lB_squared_times_3_by_2 = 3*lB^2/2
    let lB_squared_times_3_by_2_value = S::ratio(3, 2) * lB * lB;
    [
        mA_value, lA_value, lB_value, IAxx_value, IBxx_value, IByy_value, IBzz_value, g_value,
        lB_times_3_value, mA_lA_times_2_value, g_by_2_value, mA_lA_squared_value,
        lB_squared_times_3_by_2_value,
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
) -> ([S; 2], [S; 2]) {
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Values.
    // theta
    let theta_value = theta;
    // phi
    let phi_value = phi;
    // omega
    let omega_value = omega;
    // alpha
    let alpha_value = alpha;
    ([theta_value, phi_value], [omega_value, alpha_value])
}

/// The accelerations (omega', alpha'), solved for when this code was generated.
///
/// 22 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 2] {
    let Parameters {
        IAxx, IBxx, IByy, IBzz, lB_times_3, mA_lA_times_2, g_by_2, mA_lA_squared,
        lB_squared_times_3_by_2,
        ..
    } = *p;
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // omega*sin(phi)*cos(phi)*(IBxx - IByy)
    let omega_dot_of_omega = omega * sin_phi * cos_phi * (IBxx - IByy);
    // omega' = -(2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy) + g_by_2*sin(theta)*(lB_times_3 +
    //   mA_lA_times_2))/(IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2 + mA_lA_squared + lB_squared_times_3_by_2)
    let omega_dot = -(g_by_2 * sin_theta * (lB_times_3 + mA_lA_times_2)
        + S::int(2) * alpha * omega_dot_of_omega)
        / (IAxx + IBxx * sin_phi * sin_phi + IByy * cos_phi * cos_phi + mA_lA_squared
            + lB_squared_times_3_by_2);
    // alpha' = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
    let alpha_dot = omega * omega_dot_of_omega / IBzz;
    [omega_dot, alpha_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    u: &[S; 2],
) -> [S; 2] {
    let [omega, alpha] = *u;
    // Values.
    // theta' = omega
    let theta_dot_value = omega;
    // phi' = alpha
    let phi_dot_value = alpha;
    [theta_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 19 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> S {
    let Parameters { mA, lA, lB, IAxx, IBxx, IByy, IBzz, .. } = *p;
    let [_, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (_, cos_phi) = phi.sin_cos();
    // Shared terms.
    let omega_sq = omega * omega;
    // mA*lA^2 + IAxx
    let iaxx_plus_ma_la_sq = mA * lA * lA + IAxx;
    // IBxx + cos(phi)^2*(IByy - IBxx)
    let energy_of_place = IBxx + cos_phi * cos_phi * (IByy - IBxx);
    // Values.
    // T = omega^2*(2*mA*lA^2 + 3*lB^2 + 2*IAxx + 2*IBxx*sin(phi)^2 + 2*IByy*cos(phi)^2)/4 + IBzz*alpha^2/2
    let energy = S::ratio(1, 2) * IBzz * alpha * alpha + S::ratio(3, 4) * lB * lB * omega_sq
        + S::ratio(1, 2) * omega_sq * (iaxx_plus_ma_la_sq + energy_of_place);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 7 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { mA, lA, lB, g, .. } = *p;
    let [theta, _] = *q;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Shared terms.
    let g_cos_theta = g * cos_theta;
    // Values.
    // V = -g*cos(theta)*(2*mA*lA + 3*lB)/2
    let energy = (-(mA * lA)).mul_add(g_cos_theta, -S::ratio(3, 2) * lB * g_cos_theta);
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 0 operations.
#[must_use]
pub fn outputs<S: Scalar>(_p: &Parameters<S>, _t: S, q: &[S; 2], u: &[S; 2]) -> [S; 4] {
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Values.
    // theta
    let theta_value = theta;
    // phi
    let phi_value = phi;
    // omega
    let omega_value = omega;
    // alpha
    let alpha_value = alpha;
    [theta_value, phi_value, omega_value, alpha_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 22 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters {
        IAxx, IBxx, IByy, IBzz, lB_times_3, mA_lA_times_2, g_by_2, mA_lA_squared,
        lB_squared_times_3_by_2,
        ..
    } = *p;
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // omega*sin(phi)*cos(phi)*(IBxx - IByy)
    let omega_dot_of_omega = omega * sin_phi * cos_phi * (IBxx - IByy);
    // omega' = -(2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy) + g_by_2*sin(theta)*(lB_times_3 +
    //   mA_lA_times_2))/(IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2 + mA_lA_squared + lB_squared_times_3_by_2)
    let omega_dot = -(g_by_2 * sin_theta * (lB_times_3 + mA_lA_times_2)
        + S::int(2) * alpha * omega_dot_of_omega)
        / (IAxx + IBxx * sin_phi * sin_phi + IByy * cos_phi * cos_phi + mA_lA_squared
            + lB_squared_times_3_by_2);
    // alpha' = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
    let alpha_dot = omega * omega_dot_of_omega / IBzz;
    // Values.
    // theta' = omega
    let theta_dot_value = omega;
    // phi' = alpha
    let phi_dot_value = alpha;
    ([theta_dot_value, phi_dot_value], [omega_dot, alpha_dot])
}

/// The energy, then its derivatives by the state.
///
/// 30 operations, 2 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 5] {
    let Parameters { mA, lA, lB, IAxx, IBxx, IByy, IBzz, g, .. } = *p;
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let ibzz_alpha = IBzz * alpha;
    let ma_la = mA * lA;
    // sin(phi)*(IBxx - IByy)
    let energy_of_place = sin_phi * (IBxx - IByy);
    // lA*ma_la + energy_of_place*sin(phi)
    let energy_of_place_2 = energy_of_place.mul_add(sin_phi, lA * ma_la);
    // IAxx + IByy
    let iaxx_plus_ibyy = IAxx + IByy;
    let lb_times_3 = S::int(3) * lB;
    // energy_of_place_2 + iaxx_plus_ibyy
    let energy_of_place_3 = energy_of_place_2 + iaxx_plus_ibyy;
    // lB*lb_times_3 + 2*energy_of_place_3
    let energy_of_place_4 = energy_of_place_3.mul_add(S::int(2), lB * lb_times_3);
    let omega_sq = omega * omega;
    // g*(2*ma_la + lb_times_3)/2
    let energy_of_ma_la_lb_g = S::ratio(1, 2) * g * ma_la.mul_add(S::int(2), lb_times_3);
    // Values.
    // T + V = omega^2*(2*mA*lA^2 + 3*lB^2 + 2*IAxx + 2*IBxx*sin(phi)^2 + 2*IByy*cos(phi)^2)/4 -
    //   g*cos(theta)*(2*mA*lA + 3*lB)/2 + IBzz*alpha^2/2
    let energy = (-energy_of_ma_la_lb_g)
        .mul_add(
            cos_theta,
            S::ratio(1, 2) * alpha * ibzz_alpha + S::ratio(1, 4) * energy_of_place_4 * omega_sq,
        );
    // d(T + V)/d(theta) = g*sin(theta)*(2*mA*lA + 3*lB)/2
    let energy_by_theta = energy_of_ma_la_lb_g * sin_theta;
    // d(T + V)/d(phi) = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)
    let energy_by_phi = energy_of_place * omega_sq * cos_phi;
    // d(T + V)/d(omega) = omega*(2*mA*lA^2 + 3*lB^2 + 2*IAxx + 2*IBxx*sin(phi)^2 + 2*IByy*cos(phi)^2)/2
    let energy_by_omega = S::ratio(1, 2) * omega * energy_of_place_4;
    // d(T + V)/d(alpha) = IBzz*alpha
    let energy_by_alpha = ibzz_alpha;
    [energy, energy_by_theta, energy_by_phi, energy_by_omega, energy_by_alpha]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
    direction: &[S; 4],
) -> [S; 4] {
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
            parameters: 13,
            coordinates: 2,
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
    key: "0d77bdd328746538",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
