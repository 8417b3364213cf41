//! Fuzzing: random input for every reader, and hostile texts in every written format.
//!
//! `cargo test -p tripos-cli --test fuzz` takes a few seconds. `TRIPOS_FUZZ=10000000` spreads ten million cases over
//! the readers; `.ci/full` does so. `TRIPOS_FUZZ_SEED` selects other cases. `TRIPOS_FUZZ_FIRST=N`
//! begins at case N of each reader, `TRIPOS_FUZZ_COUNT` limits the cases, and `TRIPOS_FUZZ_SHOW=1` prints their inputs.
//! docs/fuzzing.md has the table of the results.

mod campaign;
mod grammar;
mod mutation;
mod readers;
mod refusal;
mod seeds;
#[path = "../support/slider.rs"]
mod slider;
mod texts;
