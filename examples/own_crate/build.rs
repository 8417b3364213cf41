//! Derives the equations of `model.toml` and writes them as a Rust module into the folder of the build.

use std::path::{Path, PathBuf};
use tripos_codegen::Extras;
use tripos_codegen::emit::{emit_rust_module, write_emission};

fn main() {
    println!("cargo::rerun-if-changed=model.toml");
    let out: PathBuf = std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR").into();
    let emission = match emit_rust_module(Path::new("model.toml"), "pendulum", &[], Extras::default()) {
        Ok(emission) => emission,
        Err(error) => return fail(&error.to_string()),
    };
    if let Err(error) = write_emission(&emission, &out.join("pendulum")) {
        fail(&error.to_string());
    }
}

/// Ends the build with a message; each line is one of the message's.
fn fail(message: &str) {
    for line in message.lines() {
        println!("cargo::error={line}");
    }
}
