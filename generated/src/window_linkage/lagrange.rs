//! N-window four-bar: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/window_linkage/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (q'', q_ground1'', q_ground2'', q_pin1'', q_pin2'', lambda_close1_1, lambda_close1_2, lambda_close2_1, lambda_close2_2).
//! The kinematic equations are singular where sin(q - q_ground1 + q_pin1) = 0 and where sin(q_ground1 - q_ground2 + q_pin2) = 0.
//! The accelerations divide by sin(q - q_ground1 + q_pin1), by sin(q_ground1 - q_ground2 + q_pin2), by sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)), by d1.

pub use super::code::lagrange::{
    Lagrange, constraint_slopes, constraints, derivative, divisors, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows q, q_ground1, q_ground2, q_pin1, q_pin2, constraint close1_1, constraint close1_2, constraint close2_1, constraint close2_2. Entries that are not listed are 0.
///
/// ```text
/// M11 = m*l^2*(5 + 3*cos(q_pin1))/3
/// M14 = m*l^2*(2 + 3*cos(q_pin1))/6
/// M16 = -l*(sin(q) + sin(q + q_pin1))
/// M17 = l*(cos(q) + cos(q + q_pin1))
/// M22 = m*l^2*(5 + 3*cos(q_pin2))/3
/// M25 = m*l^2*(2 + 3*cos(q_pin2))/6
/// M26 = l*sin(q_ground1)
/// M27 = -l*cos(q_ground1)
/// M28 = -l*(sin(q_ground1) + sin(q_ground1 + q_pin2))
/// M29 = l*(cos(q_ground1) + cos(q_ground1 + q_pin2))
/// M33 = m*l^2/3
/// M38 = l*sin(q_ground2)
/// M39 = -l*cos(q_ground2)
/// M41 = m*l^2*(2 + 3*cos(q_pin1))/6
/// M44 = m*l^2/3
/// M46 = -l*sin(q + q_pin1)
/// M47 = l*cos(q + q_pin1)
/// M52 = m*l^2*(2 + 3*cos(q_pin2))/6
/// M55 = m*l^2/3
/// M58 = -l*sin(q_ground1 + q_pin2)
/// M59 = l*cos(q_ground1 + q_pin2)
/// M61 = l*(sin(q) + sin(q + q_pin1))
/// M62 = -l*sin(q_ground1)
/// M64 = l*sin(q + q_pin1)
/// M71 = -l*(cos(q) + cos(q + q_pin1))
/// M72 = l*cos(q_ground1)
/// M74 = -l*cos(q + q_pin1)
/// M82 = l*(sin(q_ground1) + sin(q_ground1 + q_pin2))
/// M83 = -l*sin(q_ground2)
/// M85 = l*sin(q_ground1 + q_pin2)
/// M92 = -l*(cos(q_ground1) + cos(q_ground1 + q_pin2))
/// M93 = l*cos(q_ground2)
/// M95 = -l*cos(q_ground1 + q_pin2)
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (q'', q_ground1'', q_ground2'', q_pin1'', q_pin2'', lambda_close1_1, lambda_close1_2, lambda_close2_1, lambda_close2_2).
///
/// ```text
/// f1 = m*l*(l*q_pin1'*sin(q_pin1)*(2*q' + q_pin1') - g*(3*cos(q) + cos(q + q_pin1)))/2
/// f2 = m*l*(l*q_pin2'*sin(q_pin2)*(2*q_ground1' + q_pin2') - g*(3*cos(q_ground1) + cos(q_ground1 + q_pin2)))/2
/// f3 = -m*l*g*cos(q_ground2)/2
/// f4 = -m*l*(g*cos(q + q_pin1) + l*q'^2*sin(q_pin1))/2
/// f5 = -m*l*(g*cos(q_ground1 + q_pin2) + l*q_ground1'^2*sin(q_pin2))/2
/// f6 = l*(q_ground1'^2*cos(q_ground1) - q'^2*cos(q) - cos(q + q_pin1)*(q' + q_pin1')^2)
/// f7 = l*(q_ground1'^2*sin(q_ground1) - q'^2*sin(q) - sin(q + q_pin1)*(q' + q_pin1')^2)
/// f8 = l*(q_ground2'^2*cos(q_ground2) - q_ground1'^2*cos(q_ground1) - cos(q_ground1 + q_pin2)*(q_ground1' + q_pin2')^2)
/// f9 = l*(q_ground2'^2*sin(q_ground2) - q_ground1'^2*sin(q_ground1) - sin(q_ground1 + q_pin2)*(q_ground1' + q_pin2')^2)
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (q'', q_ground1'', q_ground2'', q_pin1'', q_pin2''), solved for when this code was generated.
///
/// ```text
/// d1 = m*l^2*(10 + 6*cos(q_pin1) + (2*sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - 2*cos(q_ground1)*(sin(q) + sin(q + q_pin1)) +
///     3*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))))/sin(q - q_ground1 + q_pin1))/6 +
///     m*l^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))*(2*sin(q)*cos(q_ground1) - 2*cos(q)*sin(q_ground1) -
///     3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))/(6*sin(q - q_ground1
///     + q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) +
///     m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(3*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*sin(q_pin1)^2*(10 + 6*cos(q_pin2) +
///     (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
///     3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2
///     + q_pin2))/(6*sin(q - q_ground1 + q_pin1)^2) + m*l^2*sin(q_pin1)^2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)))*(2 + 3*cos(q_pin2) + 2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
///     q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(6*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2))
/// u' = (m*l^2*(2*cos(q)*sin(q_ground1) - 2*sin(q)*cos(q_ground1) + 3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' -
///     q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
///     q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*(cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q +
///     q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))) - q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1
///     + q_pin1) - q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) + sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' +
///     q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q - q_ground1 +
///     q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
///     2*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
///     sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
///     q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
///     q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
///     q_pin1)))))/(sin(q - q_ground1 + q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) - m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
///     q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) -
///     sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))
///     - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + 3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^3 - m*l^2*sin(q_pin1)*(2 +
///     3*cos(q_pin2) + 2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 -
///     q_ground2 + q_pin2))*(q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) +
///     cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) +
///     q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q' -
///     q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
///     q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
///     cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
///     q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
///     q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + q'*sin(q_pin1)*(q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) +
///     cos(q_ground1 + q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(q'*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
///     q_pin1) + cos(q_ground1 + q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
///     sin(q_ground2)*(q'*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 + q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
///     3*m*l*(l*q_pin1'*sin(q_pin1)*(2*q' + q_pin1') - g*(3*cos(q) + cos(q + q_pin1)) + (g*cos(q + q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) -
///     sin(q_ground1)*(cos(q) + cos(q + q_pin1))) + sin(q_pin1)*(l*(q'^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) +
///     sin(q_pin2)*(q_pin2'^2 + q_ground1'*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
///     q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) + 2*q_pin2'))) - g*(3*cos(q_ground1) + cos(q_ground2)*sin(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2) +
///     cos(q_ground1 + q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
///     q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q - q_ground1 + q_pin1)))/(6*d1)
/// q'' = u'
/// q_ground1'' = q'^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 +
///     q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q -
///     q_ground1 + q_pin1)^2 + u'*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
/// q_ground2'' = q'^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
///     sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
///     q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
///     q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
///     q_pin1)))))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + u'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
///     q_ground2 + q_pin2))
/// q_pin1'' = q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
///     q_pin1)*tan(q_ground1 - q - q_pin1)) + q'*(q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1 + q_pin1) +
///     q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) - cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' +
///     q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))) - sin(q_ground1)*(q'*sin(q) + sin(q +
///     q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q - q_ground1 +
///     q_pin1) + u'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)
/// q_pin2'' = q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) +
///     cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) +
///     q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q' -
///     q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
///     q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
///     cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
///     q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
///     q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + q'*sin(q_pin1)*(q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) +
///     cos(q_ground1 + q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(q'*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
///     q_pin1) + cos(q_ground1 + q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
///     sin(q_ground2)*(q'*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 + q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
///     u'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q'
/// q_ground1'
/// q_ground2'
/// q_pin1'
/// q_pin2'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*l^2*q'^2*(5 + 3*cos(q_pin1))/6 + m*l^2*q_ground1'^2*(5 + 3*cos(q_pin2))/6 + m*l^2*q_ground2'^2/6 + m*l^2*q_pin1'^2/6 + m*l^2*q'*q_pin1'*(2 +
///     3*cos(q_pin1))/6 + m*l^2*q_pin2'^2/6 + m*l^2*q_ground1'*q_pin2'*(2 + 3*cos(q_pin2))/6
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u = q'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u' = q''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// q' = u
/// q_ground1' = u*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
/// q_ground2' = u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
/// q_pin1' = u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)
/// q_pin2' = u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
///     q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
