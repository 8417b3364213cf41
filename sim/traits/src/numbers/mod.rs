//! Numbers of the equations, from doubles to double doubles, duals, intervals and lanes.

pub(super) mod ball;
pub(super) mod circular;
pub(super) mod double_double;
pub(super) mod dual;
pub(super) mod enclosure;
pub(super) mod interval;
pub(super) mod lanes;
pub(super) mod maxima;
pub(super) mod scalar;
pub(super) mod tangent;
