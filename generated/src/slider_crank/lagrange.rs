//! Slider-crank: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/slider_crank/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (q'', p'', lambda_wrist_1).
//! The kinematic equations are singular where cos(q + p) = 0.
//! The accelerations divide by l, by cos(q + p), by sin(q)*sin(p) - cos(q)*cos(p), by I*(cos(q)*cos(p) - sin(q)*sin(p)) + r^2*(cos(q)*(mr*cos(p)*(1 - b/l) + (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l - b*mr*cos(p)^2)/l + mp*(1 - cos(p)^2)))/cos(q + p)) - sin(q)*sin(p)*(mr + mp)).

pub use super::code::lagrange::{
    Lagrange, constraint_slopes, constraints, derivative, divisors, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows q, p, constraint wrist_1. Entries that are not listed are 0.
///
/// ```text
/// M11 = I + r^2*mr + b^2*mr + Ir + 2*r*b*mr*cos(p) + mp*(r*sin(q) + l*sin(q + p))^2
/// M12 = b^2*mr + Ir + r*b*mr*cos(p) + l*mp*sin(q + p)*(r*sin(q) + l*sin(q + p))
/// M13 = -r*cos(q) - l*cos(q + p)
/// M21 = b^2*mr + Ir + r*b*mr*cos(p) + l*mp*sin(q + p)*(r*sin(q) + l*sin(q + p))
/// M22 = b^2*mr + Ir + l^2*mp*sin(q + p)^2
/// M23 = -l*cos(q + p)
/// M31 = r*cos(q) + l*cos(q + p)
/// M32 = l*cos(q + p)
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (q'', p'', lambda_wrist_1).
///
/// ```text
/// f1 = b*mr*g*sin(q + p) - mp*(r^2*q'^2*sin(q)*cos(q) + l*(sin(q + p)*(r*q'^2*cos(q) - g) + cos(q + p)*(p'^2*(r*sin(q) + l*sin(q + p)) + q'*(r*sin(q)*(q' + 2*p')
///     + l*sin(q + p)*(q' + 2*p'))))) + r*(g*sin(q)*(mr + mp) + b*mr*p'*sin(p)*(2*q' + p'))
/// f2 = sin(q + p)*(b*mr*g + l*mp*(g - r*q'^2*cos(q) - l*cos(q + p)*(p'^2 + q'*(q' + 2*p')))) - r*b*mr*q'^2*sin(p)
/// f3 = r*q'^2*sin(q) + l*sin(q + p)*(q' + p')^2
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (q'', p''), solved for when this code was generated.
///
/// ```text
/// u' = (sin(q)*sin(p) - cos(q)*cos(p))*(r^2*q'^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))*(cos(q)*(b^2*mr + Ir) + l*(l*mp*cos(q) +
///     cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) + l*mp*(sin(q)*sin(p) - cos(q)*cos(p)))))/(l^2*cos(q + p)*(sin(q)*sin(p) - cos(q)*cos(p))) +
///     r*(mr*g*sin(q)*cos(q)*cos(p)*(l - b) + sin(p)*(b*mr*cos(q)*(r*q'^2 - g*cos(q)) + l*(q'*(mp*(r*q'*cos(q) - l*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) +
///     2*p'*(sin(q)*sin(p) - cos(q)*cos(p)))) - b*mr*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) - cos(q)*cos(p)))) - mr*(g*(1 - cos(q)^2) +
///     b*p'^2*(sin(q)*sin(p) - cos(q)*cos(p))) - mp*(g + l*p'^2*(sin(q)*sin(p) - cos(q)*cos(p))))))/(l*(sin(q)*sin(p) - cos(q)*cos(p))))/(I*(cos(q)*cos(p) -
///     sin(q)*sin(p)) + r^2*(cos(q)*(mr*cos(p)*(1 - b/l) + (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l - b*mr*cos(p)^2)/l + mp*(1 -
///     cos(p)^2)))/cos(q + p)) - sin(q)*sin(p)*(mr + mp)))
/// q'' = u'
/// p'' = r*q'^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))/(l*cos(q + p)) - u'*(1 + r*cos(q)/(l*cos(q + p)))
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q'
/// p'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = q'^2*(I + r^2*mr + b^2*mr + Ir + 2*r*b*mr*cos(p) + mp*(r*sin(q) + l*sin(q + p))^2)/2 + p'^2*(b^2*mr + Ir + l^2*mp*sin(q + p)^2)/2 + q'*p'*(b^2*mr + Ir +
///     r*b*mr*cos(p) + l*mp*sin(q + p)*(r*sin(q) + l*sin(q + p)))
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
/// p' = -u*(1 + r*cos(q)/(l*cos(q + p)))
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
