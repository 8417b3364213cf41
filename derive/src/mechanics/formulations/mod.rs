//! Formulations of the equations of motion, each in its own file. They share only
//! [`super::motion`].

pub(super) mod formulation;
pub(super) mod gibbs_appell;
pub(super) mod kane;
pub(super) mod lagrange;
pub(super) mod multipliers;
pub(super) mod newton_euler;
pub(super) mod reaction_directions;
pub(super) mod tree_recursion;
