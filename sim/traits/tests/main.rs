//! All tests of the crate, as one program.

mod balls;
mod circular;
mod double_double;
mod lanes;
mod random;
