//! Crates as packages: each manifest states what a registry shows.

use crate::sympy::root;
use serde_json::Value;
use std::process::Command;

/// Goal: a user of a crate finds its purpose, licence, front page and documentation. Method: the manifests as cargo
/// reads them, of all crates except the benchmarks, and the files that they name.
#[test]
fn every_crate_states_what_a_registry_shows() {
    let arguments = ["metadata", "--no-deps", "--offline", "--format-version", "1"];
    let output = Command::new(env!("CARGO")).current_dir(root()).args(arguments).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let metadata: Value = serde_json::from_slice(&output.stdout).unwrap();
    let packages = metadata["packages"].as_array().unwrap();
    let published = packages.iter().filter(|package| package["publish"].is_null());
    let mut count = 0;
    for package in published {
        let name = package["name"].as_str().unwrap();
        count += 1;
        assert!(package["description"].as_str().is_some_and(|text| text.len() > 10), "{name}: description");
        assert_eq!(package["documentation"].as_str(), Some(format!("https://docs.rs/{name}").as_str()), "{name}");
        let folder = std::path::Path::new(package["manifest_path"].as_str().unwrap()).parent().unwrap();
        assert!(package["readme"].as_str().is_some_and(|file| folder.join(file).is_file()), "{name}: readme");
        for licence in package["license"].as_str().unwrap_or_default().split(" OR ") {
            let file = format!("LICENSE-{}", licence.split('-').next().unwrap_or_default().to_uppercase());
            assert!(root().join(&file).is_file(), "{name}: {licence}");
        }
        // A package has no paths: what it uses from the workspace also has a version.
        for used in package["dependencies"].as_array().unwrap().iter().filter(|used| used["kind"].is_null()) {
            assert!(used["req"].as_str() != Some("*"), "{name}: {} has no version", used["name"]);
        }
    }
    assert_eq!(count, 7, "library crates and the command");
}
