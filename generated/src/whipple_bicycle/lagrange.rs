//! Whipple bicycle: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/whipple_bicycle/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (x'', y'', psi'', phi'', theta'', delta'', thR'', thF'', lambda_contact, lambda_rear_1, lambda_rear_2, lambda_front_1, lambda_front_2).
//! The kinematic equations are singular where cos(phi)*cos(lam + theta)*(rR*sin(lam) - cos(lam)*(w + c)) + cos(phi)*cos(lam + theta)*cos(delta)*(c*cos(lam) - rF*sin(lam) - rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) - cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) + cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) = 0 and where sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta))) = 0 and where sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c)))) = 0.
//! The accelerations divide by 3 pivots, which are positive where the mass matrix is.

pub use super::code::lagrange::{
    Lagrange, constraint_slopes, constraints, divisors, jacobian_product,
};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows x, y, psi, phi, theta, delta, thR, thF, constraint contact, constraint rear_1, constraint rear_2, constraint front_1, constraint front_2. Entries that are not listed are 0.
///
/// 872 operations, 6 sines and cosines, 2 other functions, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (x'', y'', psi'', phi'', theta'', delta'', thR'', thF'', lambda_contact, lambda_rear_1, lambda_rear_2, lambda_front_1, lambda_front_2).
///
/// 924 operations, 6 sines and cosines, 1 other function, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (x'', y'', psi'', phi'', theta'', delta'', thR'', thF''), solved for when this code was generated.
///
/// 2311 operations, 6 sines and cosines, 2 other functions, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x'
/// y'
/// psi'
/// phi'
/// theta'
/// delta'
/// thR'
/// thF'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// 185 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 89 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::potential_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u1 = phi'
/// u2 = delta'
/// u3 = thR'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u1' = phi''
/// u2' = delta''
/// u3' = thR''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// ratio_theta_u1 = (rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + (cos(phi)*sin(delta) + sin(phi)*sin(lam +
///     theta)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta)
///     - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) - sin(phi)*cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) +
///     rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
///     rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1)^2) + cos(phi)*cos(lam + theta)*(rF*sin(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))*(cos(phi)*cos(delta) - sin(phi)*sin(lam +
///     theta)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) +
///     cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + cos(phi)*sin(lam + theta)*(w*sin(lam) +
///     cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam +
///     theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
///     theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) -
///     cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))
/// ratio_psi_u1 = cos(lam + theta)*sin(delta)*(cos(lam + theta)*sin(delta)*(sin(lam + theta)*(rF*sin(lam) - c*cos(lam)) - cos(lam + theta)*cos(delta)*(w*sin(lam) +
///     cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam + theta)^2*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam
///     + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + cos(lam + theta)*cos(delta)*(cos(lam +
///     theta)*sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) - sin(lam + theta)*(cos(lam + theta)*sin(delta)*(rF*sin(lam) -
///     c*cos(lam)) + rF*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + (rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) -
///     rR*sin(lam)) + (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) -
///     sin(phi)*cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
///     theta)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) +
///     cos(phi)*cos(lam + theta)*(rF*sin(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))*(cos(phi)*cos(delta) - sin(phi)*sin(lam +
///     theta)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(lam +
///     theta)*cos(delta)*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) - cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF))) - cos(lam + theta)*sin(delta)*(sin(delta)*(w*sin(lam) +
///     cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(lam + theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1)))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) +
///     rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam +
///     theta)*(rF*cos(phi)*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
///     1)^2)))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
///     cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c))))) + (cos(phi)*cos(delta) -
///     sin(phi)*sin(lam + theta)*sin(delta))*(rR*cos(phi) + cos(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + (cos(phi)*cos(delta) - sin(phi)*sin(lam +
///     theta)*sin(delta))*(sin(lam + theta)*(rF*sin(lam) - c*cos(lam)) - cos(lam + theta)*cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
///     theta)^2*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
///     1) + rF*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) - (cos(phi)*sin(delta) + sin(phi)*sin(lam +
///     theta)*cos(delta))*(cos(lam + theta)*sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) - sin(phi)*cos(lam + theta)*(cos(lam +
///     theta)*sin(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
///     (rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(rF*sin(lam) -
///     c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) - sin(phi)*cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) +
///     rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
///     rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1)^2) + cos(phi)*cos(lam + theta)*(rF*sin(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))*(cos(phi)*cos(delta) - sin(phi)*sin(lam +
///     theta)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(sin(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) +
///     (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) - rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + (sin(phi)*sin(lam +
///     theta)*sin(delta) - cos(phi)*cos(delta))*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(phi)*cos(lam +
///     theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) -
///     rR*sin(lam)) + cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
///     cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam + theta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam +
///     theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2)))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) -
///     cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam
///     + theta)*(rR - rF) + cos(lam + theta)*(w + c)))))
/// ratio_theta_u2 = (rF*cos(phi)^2*cos(lam + theta)^2*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1)^2 + (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1)) + (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
///     rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))^2*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) -
///     rR*sin(lam)) + cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
///     cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam + theta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam +
///     theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))
/// ratio_psi_u2 = cos(lam + theta)*sin(delta)*(cos(lam + theta)*sin(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
///     (rF*cos(phi)^2*cos(lam + theta)^2*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2 +
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
///     (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))^2*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(lam +
///     theta)*cos(delta)*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) - cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF))) - cos(lam + theta)*sin(delta)*(sin(delta)*(w*sin(lam) +
///     cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(lam + theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1)))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) +
///     rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam +
///     theta)*(rF*cos(phi)*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
///     1)^2)))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
///     cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c))))) + (sin(phi)*sin(lam +
///     theta)*sin(delta) - cos(phi)*cos(delta))*((rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
///     1))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta)) + (rF*cos(phi)^2*cos(lam + theta)^2*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2 + (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + (cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))^2*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(sin(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) +
///     (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) - rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + (sin(phi)*sin(lam +
///     theta)*sin(delta) - cos(phi)*cos(delta))*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(phi)*cos(lam +
///     theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)))/(cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam
///     + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
///     rF*cos(phi)^2*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) -
///     cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) - cos(phi)*sin(lam + theta)*(w*sin(lam) +
///     cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)) - (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam +
///     theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
///     theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
///     1)^2)))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
///     cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c)))))
/// ratio_psi_u3 = rR*cos(lam + theta)*sin(delta)/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam +
///     theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w
///     + c)))))
/// ratio_thF_u1 = sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(sin(lam
///     + theta)*(w*sin(lam) + cos(lam)*(rR - rF)) + cos(lam + theta)*(cos(lam)*(w + c*(1 - cos(delta))) - rR*sin(lam) + rF*(sin(lam)*cos(delta) + sin(delta)*sqrt(1 -
///     sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
///     2*sin(phi)*cos(delta))))))*(cos(lam + theta)*sin(delta)*(sin(lam + theta)*(rF*sin(lam) - c*cos(lam)) - cos(lam + theta)*cos(delta)*(w*sin(lam) + cos(lam)*(rR -
///     rF)) + rF*cos(phi)*cos(lam + theta)^2*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta)
///     + sin(phi)*cos(delta))^2 - 1) + rF*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + cos(lam + theta)*cos(delta)*(cos(lam +
///     theta)*sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) - sin(lam + theta)*(cos(lam + theta)*sin(delta)*(rF*sin(lam) -
///     c*cos(lam)) + rF*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + (rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) -
///     rR*sin(lam)) + (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) -
///     sin(phi)*cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
///     theta)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) +
///     cos(phi)*cos(lam + theta)*(rF*sin(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))*(cos(phi)*cos(delta) - sin(phi)*sin(lam +
///     theta)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(lam +
///     theta)*cos(delta)*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) - cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF))) - cos(lam + theta)*sin(delta)*(sin(delta)*(w*sin(lam) +
///     cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(lam + theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1)))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) +
///     rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam +
///     theta)*(rF*cos(phi)*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
///     1)^2)))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
///     cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c)))))) + sqrt(1 -
///     sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(cos(lam +
///     theta)*cos(delta)*((w*sin(lam) + cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)) - rR*sin(phi) - sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) - cos(lam +
///     theta)*sin(delta)*(cos(phi)*cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + (w*sin(lam) + cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))) - sin(lam + theta)*((rF*sin(lam) - c*cos(lam))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) + rF*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)))*(rR*cos(phi) + cos(phi)*sin(lam +
///     theta)*(cos(lam)*(w + c) - rR*sin(lam)) + (cos(phi)*cos(delta) - sin(phi)*sin(lam + theta)*sin(delta))*(sin(lam + theta)*(rF*sin(lam) - c*cos(lam)) - cos(lam +
///     theta)*cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam + theta)^2*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1)) - (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(cos(lam + theta)*sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) +
///     rF*cos(phi)*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)) - sin(phi)*cos(lam + theta)*(cos(lam + theta)*sin(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(lam + theta)*sin(delta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + (rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + (cos(phi)*sin(delta) +
///     sin(phi)*sin(lam + theta)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam
///     + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) - sin(phi)*cos(lam + theta)*(w*sin(lam) +
///     cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
///     rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1)^2) + cos(phi)*cos(lam + theta)*(rF*sin(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))*(cos(phi)*cos(delta) - sin(phi)*sin(lam +
///     theta)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(sin(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) +
///     (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) - rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + (sin(phi)*sin(lam +
///     theta)*sin(delta) - cos(phi)*cos(delta))*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(phi)*cos(lam +
///     theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) -
///     rR*sin(lam)) + cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
///     cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam + theta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam +
///     theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2)))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam)
///     - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) +
///     cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c))))))
/// ratio_thF_u2 = sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(sin(lam
///     + theta)*(w*sin(lam) + cos(lam)*(rR - rF)) + cos(lam + theta)*(cos(lam)*(w + c*(1 - cos(delta))) - rR*sin(lam) + rF*(sin(lam)*cos(delta) + sin(delta)*sqrt(1 -
///     sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
///     2*sin(phi)*cos(delta))))))*(cos(lam + theta)*sin(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
///     (rF*cos(phi)^2*cos(lam + theta)^2*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2 +
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
///     (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))^2*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(lam +
///     theta)*cos(delta)*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) - cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF))) - cos(lam + theta)*sin(delta)*(sin(delta)*(w*sin(lam) +
///     cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(lam + theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1)))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) +
///     rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam +
///     theta)*(rF*cos(phi)*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
///     1)^2)))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
///     cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c)))))) + sqrt(1 -
///     sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(rR*sin(phi) + sin(phi)*sin(lam +
///     theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(lam + theta)*sin(delta)*(cos(phi)*cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + (w*sin(lam) + cos(lam)*(rR -
///     rF))*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))) - cos(lam + theta)*cos(delta)*((w*sin(lam) + cos(lam)*(rR - rF))*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta)) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) +
///     sin(lam + theta)*((rF*sin(lam) - c*cos(lam))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)))*((rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2 - 1))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta)) + (rF*cos(phi)^2*cos(lam + theta)^2*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2 + (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + (cos(phi)*sin(lam + theta)*cos(delta) -
///     sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))^2*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(sin(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) +
///     (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) - rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + (sin(phi)*sin(lam +
///     theta)*sin(delta) - cos(phi)*cos(delta))*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(phi)*cos(lam +
///     theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)))/(cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam
///     + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
///     rF*cos(phi)^2*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
///     sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) -
///     cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
///     theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) - cos(phi)*sin(lam + theta)*(w*sin(lam) +
///     cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))^2)) - (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 -
///     (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam +
///     theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
///     theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
///     1)^2)))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
///     cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c))))))
/// ratio_thF_u3 = rR*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
///     2*sin(phi)*cos(delta)))*(sin(lam + theta)*((w*sin(lam) + rR*cos(lam))/rF - cos(lam)) + cos(lam + theta)*(sin(lam)*cos(delta) + sin(delta)*sqrt(1 -
///     sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(cos(phi)*sin(lam +
///     theta)*sin(delta) + sin(phi)*cos(delta))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
///     2*sin(phi)*cos(delta))) + (cos(lam)*(w + c*(1 - cos(delta))) - rR*sin(lam))/rF))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam +
///     theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam +
///     theta)*(rR - rF) + cos(lam + theta)*(w + c)))))
/// x' = -rR*u3*cos(psi)
/// y' = -rR*u3*sin(psi)
/// psi' = -u1*ratio_psi_u1 - u2*ratio_psi_u2 - u3*ratio_psi_u3
/// phi' = u1
/// theta' = u1*ratio_theta_u1 + u2*ratio_theta_u2
/// delta' = u2
/// thR' = u3
/// thF' = u1*ratio_thF_u1 + u2*ratio_thF_u2 + u3*ratio_thF_u3
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
