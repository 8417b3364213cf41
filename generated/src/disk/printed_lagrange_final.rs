//! Thin disk sliding on a frictionless plane: Lagrange's equations as printed (lagrange-final), E(q) q'' = A(q, q').
//!
//! Generated from `models/disk/publication.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (q1'', q2'', q3'', q4'', q5'').
//! The kinematic equations are singular where cos(q2) = 0.

pub use super::code::printed_lagrange_final::PrintedLagrangeFinal;

pub use super::lagrange::{coordinate_rates, generalized_speeds};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); rows row 1, row 2, row 3, row 4, row 5. Entries that are not listed are 0.
///
/// ```text
/// M11 = R^2*(6 - 5*cos(q2)^2)/2
/// M13 = R*sin(q2)/2
/// M14 = -cos(q1)*sin(q2)
/// M15 = -sin(q1)*sin(q2)
/// M22 = 5*R^2/4
/// M24 = -sin(q1)*cos(q2)
/// M25 = cos(q1)*cos(q2)
/// M31 = sin(q2)
/// M33 = 1
/// M41 = R*cos(q1)*sin(q2)
/// M42 = R*sin(q1)*cos(q2)
/// M44 = -1
/// M51 = R*sin(q1)*sin(q2)
/// M52 = -R*cos(q1)*cos(q2)
/// M55 = -1
/// ```
#[doc(inline)]
pub use super::code::printed_lagrange_final::mass_matrix;

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'', q4'', q5'').
///
/// ```text
/// f1 = -5*R*q1'*q2'*sin(q2)*cos(q2)/2 - R*q2'*q3'*cos(q2)/2
/// f2 = g*sin(q2) + 5*R*q1'^2*sin(q2)*cos(q2)/4 + R*q1'*q3'*cos(q2)/2
/// f3 = -q1'*q2'*cos(q2)
/// f4 = R*q1'^2*sin(q1)*sin(q2) + R*q2'^2*sin(q1)*sin(q2) - 2*R*q1'*q2'*cos(q1)*cos(q2)
/// f5 = -R*q1'^2*cos(q1)*cos(q2) - R*q2'^2*cos(q1)*sin(q2) - 2*R*q1'*q2'*sin(q1)*cos(q2)
/// ```
#[doc(inline)]
pub use super::code::printed_lagrange_final::forcing;

/// Kinetic energy T.
///
/// ```text
/// T = M*R^2*q1'^2*(6 - 5*cos(q2)^2)/8 + 5*M*R^2*q2'^2/8 + M*R^2*q3'^2/4 + M*R^2*q1'*q3'*sin(q2)/2 + M*q4'^2/2 - M*R*q1'*q4'*cos(q1)*sin(q2) -
///     M*R*q2'*q4'*sin(q1)*cos(q2) + M*q5'^2/2 - M*R*q1'*q5'*sin(q1)*sin(q2) + M*R*q2'*q5'*cos(q1)*cos(q2)
/// ```
#[doc(inline)]
pub use super::code::printed_lagrange_final::kinetic_energy;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u1' = -q2''
/// u2' = q1''*cos(q2) - q1'*q2'*sin(q2)
/// u3' = q1'*q2'*cos(q2) + q1''*sin(q2) + q3''
/// u4' = q4''
/// u5' = q5''
/// ```
#[doc(inline)]
pub use super::code::printed_lagrange_final::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// q1' = u2/cos(q2)
/// q2' = -u1
/// q3' = u3 - u2*tan(q2)
/// q4' = u4
/// q5' = u5
/// ```
#[doc(inline)]
pub use super::code::printed_lagrange_final::motion_variables;
