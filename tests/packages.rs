//! Crates as packages: what a registry gets of each is whole, licensed and described.

use proc_macro2::{TokenStream, TokenTree};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Cargo in the workspace, without a network; its standard output.
fn cargo(arguments: &[&str]) -> String {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(cargo);
    let output = command.args(arguments).arg("--offline").current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// Packages of the workspace that can be published, as cargo describes them.
fn packages() -> Vec<Value> {
    let metadata: Value =
        serde_json::from_str(&cargo(&["metadata", "--no-deps", "--format-version", "1", "--locked"])).unwrap();
    let all = metadata["packages"].as_array().unwrap().clone();
    all.into_iter().filter(|package| package["publish"].is_null()).collect()
}

fn folder(package: &Value) -> PathBuf {
    Path::new(package["manifest_path"].as_str().unwrap()).parent().unwrap().to_owned()
}

/// Paths of the files of a package, relative to its folder.
fn files(package: &Value) -> BTreeSet<String> {
    let list = cargo(&["package", "--list", "--allow-dirty", "-p", package["name"].as_str().unwrap()]);
    list.lines().map(str::to_owned).collect()
}

/// Names of files in `include_str!`, `include_bytes!` and `include!` with a name alone.
fn included(tokens: TokenStream, found: &mut Vec<String>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (at, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else { continue };
        let is_include = at >= 2
            && tokens[at - 1].to_string() == "!"
            && ["include_str", "include_bytes", "include"].contains(&tokens[at - 2].to_string().as_str());
        match syn::parse2::<syn::LitStr>(group.stream()) {
            Ok(name) if is_include => found.push(name.value()),
            _ => included(group.stream(), found),
        }
    }
}

/// Path without `.` and `..`, which may not lead out of the folder that it is relative to.
fn plain(path: &Path) -> Option<String> {
    let mut names = Vec::new();
    for part in path.components() {
        match part {
            std::path::Component::CurDir => {}
            std::path::Component::ParentDir => drop(names.pop()?),
            other => names.push(other.as_os_str().to_string_lossy().into_owned()),
        }
    }
    Some(names.join("/"))
}

#[test]
fn every_package_has_its_readme_its_licences_and_a_description() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let packages = packages();
    assert_eq!(packages.len(), 9);
    for package in &packages {
        let (name, files, folder) = (&package["name"], files(package), folder(package));
        let readme = package["readme"].as_str().unwrap_or_default();
        assert!(files.contains(readme), "{name}: the package lacks its README");
        let title = std::fs::read_to_string(folder.join(readme)).unwrap();
        assert_eq!(title.lines().next(), Some(format!("# {}", name.as_str().unwrap()).as_str()));
        for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
            assert!(files.contains(licence), "{name}: the package lacks {licence}");
            let text = |folder: &Path| std::fs::read(folder.join(licence)).unwrap();
            assert!(text(&folder) == text(root), "{name}: {licence} is not that of the workspace");
        }
        assert_eq!(package["license"], "MIT OR Apache-2.0", "{name}");
        let documentation = package["documentation"].as_str().unwrap_or_default();
        assert!(documentation.starts_with("https://docs.rs/"), "{name}: {documentation}");
        assert!(!package["description"].as_str().unwrap_or_default().is_empty(), "{name}");
        for (key, longest) in [("keywords", 20), ("categories", 64)] {
            let words: Vec<&str> = package[key].as_array().unwrap().iter().filter_map(Value::as_str).collect();
            assert!((1..=5).contains(&words.len()), "{name}: a registry takes up to five {key}");
            assert!(words.iter().all(|word| word.len() <= longest && !word.contains(' ')), "{name}: {words:?}");
        }
    }
}

/// Goal: a package compiles alone. Method: every file that its sources include, in strings, bytes or code, is in it.
#[test]
fn every_file_that_a_source_includes_is_in_its_package() {
    let mut count = 0;
    for package in packages() {
        let (files, folder) = (files(&package), folder(&package));
        let sources =
            files.iter().filter(|file| Path::new(file).extension().is_some_and(|extension| extension == "rs"));
        for source in sources {
            let text = std::fs::read_to_string(folder.join(source)).unwrap();
            let mut names = Vec::new();
            included(text.parse().unwrap(), &mut names);
            for name in &names {
                let path = plain(&Path::new(source).parent().unwrap().join(name));
                let is_there = path.is_some_and(|path| files.contains(&path));
                assert!(is_there, "{}: {source} includes {name}, which is not in the package", package["name"]);
            }
            count += names.len();
        }
    }
    assert!(count > 30, "the sources include files: {count}");
}

/// Cargo makes the packages of all crates, each with the others in place of its path dependencies.
#[test]
fn all_crates_can_be_packaged_together() {
    let target = tempfile::tempdir().unwrap();
    let folder = target.path().to_str().unwrap();
    let excluded = ["--exclude", "tripos-benches", "--exclude", "tripos-python"];
    let arguments = [&["package", "--workspace"], &excluded[..], &["--no-verify", "--allow-dirty", "--quiet"]].concat();
    cargo(&[&arguments[..], &["--target-dir", folder]].concat());
    let made = std::fs::read_dir(target.path().join("package")).unwrap();
    let made = made.filter(|entry| entry.as_ref().unwrap().path().extension().is_some_and(|e| e == "crate"));
    assert_eq!(made.count(), packages().len());
}

/// Features of each library that `cargo tree` lists with the given arguments, by name and version; procedural macros
/// and what they use are left out.
fn features(arguments: &[&str]) -> BTreeMap<String, BTreeSet<String>> {
    let format = ["--prefix", "none", "--format", "{p}|{f}", "--locked"];
    let mut features = BTreeMap::new();
    for line in cargo(&[&["tree"], arguments, &format[..]].concat()).lines().filter(|line| !line.is_empty()) {
        let (package, listed) = line.trim_end_matches(" (*)").split_once('|').unwrap();
        let mut words = package.split(' ');
        let name = [words.next().unwrap(), words.next().unwrap()].join(" ");
        features.entry(name).or_insert_with(BTreeSet::new).insert(listed.to_owned());
    }
    features
}

/// Goal: the second command of the README compiles no library again that the first has compiled. Method: the tests ask
/// for the same features of each library, other than the models, of which the command compiles one alone.
#[test]
fn tests_compile_no_library_again_that_the_command_has_compiled() {
    let command = features(&["-e", "normal,no-proc-macro"]);
    let tests = features(&["--workspace", "-e", "normal,dev,no-proc-macro"]);
    assert!(command.len() > 50, "{command:?}");
    let differing: Vec<_> = command.iter().filter(|(name, features)| !features.is_subset(&tests[*name])).collect();
    let names: Vec<&str> = differing.iter().map(|(name, _)| name.split(' ').next().unwrap()).collect();
    assert_eq!(names, ["tripos-models"], "let cli/Cargo.toml ask for the features of the tests: {differing:?}");
}
