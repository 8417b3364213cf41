//! Chain of three rods floating in a plane: Folding.
//!
//! Generated from `models/floating_chain/scenes/folding.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: x, y, theta1, theta2, theta3, u1, u2, u3, u4, u5.
//! States: theta2_from_theta1, theta3_from_theta1, u4_from_u3, u5_from_u3. Quadratures: theta1.
//! p_x = m*(6*u1 - l*(2*u3*sin(theta1) + 3*u4*sin(theta2) + u5*sin(theta3)))/2: momentum p_x = ∂L/∂x'.
//! p_y = m*(6*u2 + l*(2*u3*cos(theta1) + 3*u4*cos(theta2) + u5*cos(theta3)))/2: momentum p_y = ∂L/∂y'.
//! H_n3_scaled = m*l^2*(u3*(3 + 3*cos(theta1 - theta2) + cos(theta1 - theta3)) + u4*(7 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + 3*cos(theta1 - theta2)*(1 + cos(theta1 - theta3))) + u5*(3 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + cos(theta1 - theta3)*(1 + 3*cos(theta1 - theta2)))): 12 times the angular momentum about n3 through the mass centre.
//! centre_x = m*(6*x + l*(2*cos(theta1) + 3*cos(theta2) + cos(theta3)))/2: m*(6*x + l*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 + theta3_from_theta1)))/2 at the start.
//! centre_y = m*(6*y + l*(2*sin(theta1) + 3*sin(theta2) + sin(theta3)))/2: m*(6*y + l*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 + theta3_from_theta1)))/2 at the start.
//! H_n3_scaled_per_m_per_l_squared = u3*(3 + 3*cos(theta1 - theta2) + cos(theta1 - theta3)) + u4*(7 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + 3*cos(theta1 - theta2)*(1 + cos(theta1 - theta3))) + u5*(3 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + cos(theta1 - theta3)*(1 + 3*cos(theta1 - theta2))): H_n3_scaled/(m*l^2).
//! l_by_6 = l/6.
//! p_y_per_m_by_3 = u2 + l*(2*u3*cos(theta1) + 3*u4*cos(theta2) + u5*cos(theta3))/6: p_y/(3*m).
//! p_x_per_m_by_3 = u1 - l*(2*u3*sin(theta1) + 3*u4*sin(theta2) + u5*sin(theta3))/6: p_x/(3*m).
//! m_l_squared_by_12 = m*l^2/12.
//! Singular where 13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) = 0.

pub use super::code::folding::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, divisors,
    energy_gradient, jacobian_product,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// m
/// l
/// p_x = m*(6*u1 - l*(2*u3*sin(theta1) + 3*u4*sin(theta2) + u5*sin(theta3)))/2
/// p_y = m*(6*u2 + l*(2*u3*cos(theta1) + 3*u4*cos(theta2) + u5*cos(theta3)))/2
/// H_n3_scaled = m*l^2*(u3*(3 + 3*cos(theta1 - theta2) + cos(theta1 - theta3)) + u4*(7 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + 3*cos(theta1 - theta2)*(1 +
///     cos(theta1 - theta3))) + u5*(3 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + cos(theta1 - theta3)*(1 + 3*cos(theta1 - theta2))))
/// centre_x = m*(6*x + l*(2*cos(theta1) + 3*cos(theta2) + cos(theta3)))/2
/// centre_y = m*(6*y + l*(2*sin(theta1) + 3*sin(theta2) + sin(theta3)))/2
/// H_n3_scaled_per_m_per_l_squared = u3*(3 + 3*cos(theta1 - theta2) + cos(theta1 - theta3)) + u4*(7 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + 3*cos(theta1 -
///     theta2)*(1 + cos(theta1 - theta3))) + u5*(3 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + cos(theta1 - theta3)*(1 + 3*cos(theta1 - theta2)))
/// l_by_6 = l/6
/// p_y_per_m_by_3 = u2 + l*(2*u3*cos(theta1) + 3*u4*cos(theta2) + u5*cos(theta3))/6
/// p_x_per_m_by_3 = u1 - l*(2*u3*sin(theta1) + 3*u4*sin(theta2) + u5*sin(theta3))/6
/// m_l_squared_by_12 = m*l^2/12
/// ```
#[doc(inline)]
pub use super::code::folding::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// theta2_from_theta1 = theta2 - theta1
/// theta3_from_theta1 = theta3 - theta1
/// theta1
/// u4_from_u3 = u4 - u3
/// u5_from_u3 = u5 - u3
/// ```
#[doc(inline)]
pub use super::code::folding::start;

/// The accelerations (u4_from_u3', u5_from_u3'), solved for when this code was generated.
///
/// ```text
/// u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
///     cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
///     6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
/// r1_ = m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 + 3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) -
///     3 - 3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
///     3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) + cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
///     9*cos(theta3_from_theta1)))*(u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15 + 2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 +
///     cos(theta3_from_theta1)) + 6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
///     2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 - cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
///     u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 - 3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 +
///     6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
///     3*cos(theta2_from_theta1)))) - 3*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(5 + cos(theta3_from_theta1)) +
///     3*cos(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) + 3*sin(theta2_from_theta1)*(u5_from_u3^2 -
///     cos(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) + 3*sin(theta2_from_theta1)*(7*u4_from_u3^2
///     + u5_from_u3^2 + cos(theta3_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(6 + cos(theta3_from_theta1)))) + sin(theta3_from_theta1)*(9*u4_from_u3^2 +
///     7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/((13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1)
///     + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(33 - 18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
///     cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) - 18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
///     cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))) + m_l_squared_by_12*(u3*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13 +
///     6*cos(theta2_from_theta1)) + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 + 2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 +
///     6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 - 3*cos(theta2_from_theta1)*(2*u3 +
///     u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)))) - sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 +
///     3*cos(theta2_from_theta1)*(3*u3*(5 + 2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 + 3*cos(theta2_from_theta1)) + 6*u5_from_u3)) - 6*sin(theta2_from_theta1)*(u3
///     + 3*u4_from_u3 + u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) + cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u4_from_u3^2*(3
///     + cos(theta2_from_theta1)) + 3*u5_from_u3^2 + cos(theta3_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 + 6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))
///     + sin(theta3_from_theta1)*(9*u4_from_u3^2 + 8*u5_from_u3^2 - 3*cos(theta2_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 + 6*cos(theta2_from_theta1)*(u4_from_u3^2
///     + u5_from_u3^2)))) - 3*sin(theta3_from_theta1)*(3*u4_from_u3^2 + u5_from_u3^2 + cos(theta2_from_theta1)*(u4_from_u3^2*(10 + 3*cos(theta2_from_theta1)) +
///     3*u5_from_u3^2)) - 3*sin(theta2_from_theta1)*(3*u4_from_u3^2 + u5_from_u3^2 + 3*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(13 +
///     6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
/// u5_from_u3' = r1_*(33 - 18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
///     18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
///     cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) - 9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
///     cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
/// u4_from_u3' = (13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
///     cos(theta3_from_theta1)))*(m_l_squared_by_12*(u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15 + 2*cos(theta3_from_theta1)) + 14*u4_from_u3 +
///     2*u5_from_u3*(6 + cos(theta3_from_theta1)) + 6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 + u4_from_u3 +
///     u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 - cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
///     u4_from_u3 + u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 - 3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3
///     + 6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
///     3*cos(theta2_from_theta1)))) - 3*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(5 + cos(theta3_from_theta1)) +
///     3*cos(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) + 3*sin(theta2_from_theta1)*(u5_from_u3^2 -
///     cos(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) + 3*sin(theta2_from_theta1)*(7*u4_from_u3^2
///     + u5_from_u3^2 + cos(theta3_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(6 + cos(theta3_from_theta1)))) + sin(theta3_from_theta1)*(9*u4_from_u3^2 +
///     7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
///     6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + u5_from_u3'*m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
///     3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 - 3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
///     6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
///     cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 - 9*cos(theta3_from_theta1)))/(13 +
///     6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
///     cos(theta3_from_theta1))))/(m_l_squared_by_12*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) - 33 - cos(theta3_from_theta1)*(14 +
///     9*cos(theta3_from_theta1) - 18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta2_from_theta1)*(1 +
///     cos(theta3_from_theta1))))))
/// ```
#[doc(inline)]
pub use super::code::folding::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
///     cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
///     6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
/// theta2_from_theta1' = u4_from_u3
/// theta3_from_theta1' = u5_from_u3
/// ```
#[doc(inline)]
pub use super::code::folding::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
///     cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
///     6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
/// T = m*l^2*(3*u5_from_u3^2 + u3*(u3*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
///     cos(theta3_from_theta1))) + 2*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
///     2*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1)))) + u4_from_u3*(7*u4_from_u3 +
///     6*u5_from_u3*(sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta2_from_theta1)*cos(theta3_from_theta1))))/24 - H_n3_scaled^2/(24*m*l^2*(13 +
///     6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))
/// ```
#[doc(inline)]
pub use super::code::folding::kinetic_energy;

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// ```text
/// V = (4*p_x^2 + 4*p_y^2 + H_n3_scaled^2/(l^2*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
///     cos(theta3_from_theta1)))))/(24*m)
/// ```
#[doc(inline)]
pub use super::code::folding::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
///     cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
///     6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
/// u2 = p_y_per_m_by_3 - l_by_6*(u3*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 + theta3_from_theta1)) + 3*u4_from_u3*cos(theta1 +
///     theta2_from_theta1) + u5_from_u3*cos(theta1 + theta3_from_theta1))
/// u1 = l_by_6*(u3*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 + theta3_from_theta1)) + 3*u4_from_u3*sin(theta1 + theta2_from_theta1) +
///     u5_from_u3*sin(theta1 + theta3_from_theta1)) + p_x_per_m_by_3
/// x = (p_x*t + centre_x)/(3*m) - l*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 + theta3_from_theta1))/6
/// y = (p_y*t + centre_y)/(3*m) - l*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 + theta3_from_theta1))/6
/// theta1
/// theta2 = theta1 + theta2_from_theta1
/// theta3 = theta1 + theta3_from_theta1
/// u4 = u3 + u4_from_u3
/// u5 = u3 + u5_from_u3
/// ```
#[doc(inline)]
pub use super::code::folding::outputs;
