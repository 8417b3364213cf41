//! All tests of the crate, as one program.

mod circular;
mod double_double;
mod lanes;
mod random;
