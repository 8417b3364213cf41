//! Thin disc rolling on a plane: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/rolling_disc/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (q1'', q2'', q3'', x'', y'', lambda_ground_1, lambda_ground_2).
//! The kinematic equations are singular where cos(q2) = 0.
//! The accelerations divide by r.

pub use super::code::lagrange::{
    Lagrange, constraint_slopes, constraints, derivative, divisors, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows q1, q2, q3, x, y, constraint ground_1, constraint ground_2. Entries that are not listed are 0.
///
/// ```text
/// M11 = r^2*m*(6 - 5*cos(q2)^2)/4
/// M13 = r^2*m*sin(q2)/2
/// M14 = r*m*cos(q1)*sin(q2)
/// M15 = r*m*sin(q1)*sin(q2)
/// M22 = 5*r^2*m/4
/// M24 = r*m*sin(q1)*cos(q2)
/// M25 = -r*m*cos(q1)*cos(q2)
/// M31 = r^2*m*sin(q2)/2
/// M33 = r^2*m/2
/// M36 = r*cos(q1)
/// M37 = r*sin(q1)
/// M41 = r*m*cos(q1)*sin(q2)
/// M42 = r*m*sin(q1)*cos(q2)
/// M44 = m
/// M46 = -1
/// M51 = r*m*sin(q1)*sin(q2)
/// M52 = -r*m*cos(q1)*cos(q2)
/// M55 = m
/// M57 = -1
/// M63 = -r*cos(q1)
/// M64 = 1
/// M73 = -r*sin(q1)
/// M75 = 1
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'', x'', y'', lambda_ground_1, lambda_ground_2).
///
/// ```text
/// f1 = -r^2*m*q2'*cos(q2)*(5*q1'*sin(q2) + q3')/2
/// f2 = r*m*(4*g*sin(q2) + r*q1'*cos(q2)*(5*q1'*sin(q2) + 2*q3'))/4
/// f3 = -r^2*m*q1'*q2'*cos(q2)/2
/// f4 = r*m*(q2'^2*sin(q1)*sin(q2) - q1'*(2*q2'*cos(q1)*cos(q2) - q1'*sin(q1)*sin(q2)))
/// f5 = -r*m*(q2'^2*cos(q1)*sin(q2) + q1'*(q1'*cos(q1)*sin(q2) + 2*q2'*sin(q1)*cos(q2)))
/// f6 = -r*q1'*q3'*sin(q1)
/// f7 = r*q1'*q3'*cos(q1)
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (q1'', q2'', q3'', x'', y''), solved for when this code was generated.
///
/// ```text
/// u3' = -q2'*(q1'*sin(q2) + 2*q3')
/// u2' = -2*q1'*q2'*cos(q2)/3
/// u1' = 4*g*sin(q2)/(5*r) + q1'*cos(q2)*(5*q1'*sin(q2) + 6*q3')/5
/// q1'' = q1'*q2'*tan(q2) + u3'/cos(q2)
/// q2'' = u1'
/// q3'' = u2' - q1'*q2'/cos(q2) - u3'*tan(q2)
/// x'' = r*cos(q1)*(u2' - u3'*tan(q2)) - r*q1'*(q2'*cos(q1)/cos(q2) + q3'*sin(q1))
/// y'' = r*q1'*(q3'*cos(q1) - q2'*sin(q1)/cos(q2)) + r*sin(q1)*(u2' - u3'*tan(q2))
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q1'
/// q2'
/// q3'
/// x'
/// y'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = r^2*m*q1'^2*(6 - 5*cos(q2)^2)/8 + 5*r^2*m*q2'^2/8 + r^2*m*q3'^2/4 + r^2*m*q1'*q3'*sin(q2)/2 + m*x'^2/2 + r*m*q1'*x'*cos(q1)*sin(q2) +
///     r*m*q2'*x'*sin(q1)*cos(q2) + m*y'^2/2 + r*m*q1'*y'*sin(q1)*sin(q2) - r*m*q2'*y'*cos(q1)*cos(q2)
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u1 = q2'
/// u2 = q1'*sin(q2) + q3'
/// u3 = q1'*cos(q2)
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u1' = q2''
/// u2' = q1'*q2'*cos(q2) + q1''*sin(q2) + q3''
/// u3' = q1''*cos(q2) - q1'*q2'*sin(q2)
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// q1' = u3/cos(q2)
/// q2' = u1
/// q3' = u2 - u3*tan(q2)
/// x' = r*cos(q1)*(u2 - u3*tan(q2))
/// y' = r*sin(q1)*(u2 - u3*tan(q2))
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
