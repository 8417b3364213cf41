//! Recurrences of the Taylor coefficients of a motion. They come from automatic differentiation in time of the
//! program that computes the derivative of the state.
//!
//! Steps and rates are brought into a form with few products of factors that change in time. Then they are split into
//! single operations, with shared products. The resulting [`Recurrences`] are planned and written as code, or
//! interpreted by a [`Tape`].
//!
//! A linear rule costs an operation at each order. Every other operation is a convolution, so the number of
//! convolutions is the cost. The recurrences are those of A. Jorba & M. Zou, "A software package for the numerical
//! integration of ODEs by means of high-order Taylor methods", Experimental Mathematics 14 (2005) 99–117, §2.

mod cheapest_recurrences;
mod factored_monomials;
mod products;
mod recurrences;
mod series_from_terms;
mod taylor_tape;

pub use cheapest_recurrences::{cheapest_recurrences, cheapest_recurrences_of};
pub use recurrences::{Constant, Operand, Recurrences, Rule, Series};
pub use taylor_tape::Tape;
