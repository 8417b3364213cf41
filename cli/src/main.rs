//! Program `tripos`. Its commands are in the library of this package.

use std::process::ExitCode;

fn main() -> ExitCode {
    tripos_cli::run_program()
}
