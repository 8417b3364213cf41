//! Keeps the compiled equations fresh: derives every model again, in memory, and compares.
//!
//! Equal: the committed text under `generated/` is compiled. Different: the fresh text goes to the
//! build directory, `cfg(stale)` makes the library include it from there, and cargo warns. Nothing is
//! ever written to the source tree, and neither Python nor a network is needed.

fn main() {
    println!("cargo::rustc-check-cfg=cfg(stale)");
    println!("cargo::rerun-if-changed=build.rs");
    #[cfg(feature = "fresh")]
    fresh::check();
}

#[cfg(feature = "fresh")]
mod fresh {
    use std::path::{Path, PathBuf};
    use tripos_codegen::files::write;
    use tripos_codegen::workspace::{Freshness, freshness, stale_library};

    pub fn check() {
        println!("cargo::rerun-if-changed=models");
        println!("cargo::rerun-if-changed=generated/src");
        let committed = Path::new("generated/src");
        match freshness(Path::new("models"), committed) {
            Ok(found) => report(&found, committed),
            Err(error) => println!("cargo::warning=the models could not be read, so nothing was checked: {error}"),
        }
    }

    fn report(found: &Freshness, committed: &Path) {
        for (name, diagnostics) in &found.generated.broken {
            let first = diagnostics.list.first().map_or("", |d| d.message.as_str());
            println!(
                "cargo::warning=models/{name}/model.toml has errors ({first}); `tripos derive models/{name}` shows them"
            );
        }
        for (name, diagnostics) in &found.generated.broken_scenes {
            let first = diagnostics.list.first().map_or("", |d| d.message.as_str());
            println!("cargo::warning=models/{name} has errors ({first}); `tripos scene models/{name}` shows them");
        }
        if found.differences.is_empty() {
            return;
        }
        let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
        let folder = out.join("fresh");
        let mut modules = Vec::new();
        for (file, text) in &found.generated.files {
            let path = folder.join(file);
            std::fs::create_dir_all(path.parent().expect("a file has a folder")).expect("OUT_DIR can be written");
            write(&path, text).expect("OUT_DIR can be written");
        }
        for name in &found.generated.models {
            modules.push((name.clone(), folder.join(name)));
        }
        write(&out.join("stale.rs"), stale_library(&modules)).expect("OUT_DIR can be written");
        println!("cargo::rustc-cfg=stale");
        let files = found.differences.len();
        println!(
            "cargo::warning=generated/ is stale in {files} file(s), for example {} of {}; this build uses fresh equations, `tripos regenerate` commits them",
            found.differences[0].file(),
            committed.display()
        );
    }
}
