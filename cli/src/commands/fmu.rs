//! Command `tripos fmu`: writes a scene as a functional mock-up unit (FMU).

use crate::files::scene_file::read_scene_with;
use crate::terminal::failure::{Failure, Output, print_result, print_to_stderr, warn};
use serde_json::json;
use std::ffi::OsString;
use std::io::{Cursor, Write};
use std::path::{Path, PathBuf};
use std::process::Command;
use tripos_codegen::draft_file;
use tripos_codegen::fmu::{Fmu, Version};
use tripos_derive::plain_text::path_as_plain_text;
use zip::write::SimpleFileOptions;
use zip::{DateTime, ZipWriter};

/// Arguments of `tripos fmu`: the scene, the unit's path, and options.
pub struct UnitRequest {
    /// Path of the scene file.
    pub scene: PathBuf,
    /// Path of the unit, a file that ends in `.fmu`.
    pub out: PathBuf,
    /// New values of numbers of the scene, each as `NAME=VALUE`.
    pub set: Vec<String>,
    /// Version of the Functional Mock-up Interface: `2` or `3`, with or without `.0`.
    pub fmi: String,
    /// True if the unit contains only sources; false if a binary for this platform is compiled, too.
    pub only_sources: bool,
}

/// Runs `tripos fmu`: writes a scene as a functional mock-up unit, with sources and with a binary for this platform.
/// Returns the exit status.
///
/// # Errors
/// [`Failure`] if the scene cannot be written as a unit, if there is no compiler, or if the file cannot be written.
pub fn fmu(request: &UnitRequest, output: Output) -> Result<u8, Failure> {
    if request.out.extension().is_none_or(|extension| extension != "fmu") {
        let what = format!("`{}` does not end with .fmu", path_as_plain_text(&request.out));
        return Err(Failure::request(what, "importing tools know a unit by this ending: write --out disk.fmu"));
    }
    let version = match request.fmi.as_str() {
        "2" | "2.0" => Version::Two,
        "3" | "3.0" => Version::Three,
        other => {
            let what = format!("there are no units by FMI {other}");
            return Err(Failure::request(what, "write --fmi 2 or --fmi 3"));
        }
    };
    let varied = read_scene_with(&request.scene, &request.set)?;
    let unit = Fmu::new(&varied.model.model, &varied.scene, version)?;
    for name in &unit.left_out {
        warn(&format!("`{name}` is left out: it needs a reaction, which the equations of a unit do not have"));
    }
    let binary = if request.only_sources { None } else { Some(compile_fmu(&unit)?) };
    let bytes = fmu_archive(&unit, version, binary.as_deref()).map_err(|error| archive_failure(&request.out, error))?;
    draft_file::write(&request.out, &bytes)?;
    let platform = binary.as_ref().map(|_| platform(version));
    let value = json!({
        "file": path_as_plain_text(&request.out),
        "fmi": version.number(),
        "identifier": unit.identifier,
        "platform": platform,
        "directional_derivatives": unit.has_slopes,
        "left_out": unit.left_out,
    });
    let words = format!("written    {}\n", path_as_plain_text(&request.out));
    print_result(output, &words, &value)?;
    if !unit.has_slopes {
        print_to_stderr("the unit has no directional derivatives, because they would be too long");
    }
    Ok(0)
}

/// Returns the failure for an archive that could not be written to `out`.
fn archive_failure(out: &Path, error: zip::result::ZipError) -> Failure {
    Failure::Output(path_as_plain_text(out), std::io::Error::other(error))
}

/// Returns the name of this platform's folder for binaries in a unit, such as `x86_64-linux` or
/// `linux64`.
fn platform(version: Version) -> String {
    let system = match std::env::consts::OS {
        "macos" => "darwin",
        system => system,
    };
    match (version, system) {
        (Version::Three, _) => format!("{}-{system}", std::env::consts::ARCH),
        (Version::Two, "windows") => "win64".to_owned(),
        (Version::Two, _) => format!("{system}64"),
    }
}

/// Compiles the sources of a unit into a shared library, and returns its bytes. The compiler is
/// named by the environment variable `CC`; otherwise it is `cc`.
///
/// # Errors
/// [`Failure`] if the compiler cannot be run or refuses the sources.
fn compile_fmu(unit: &Fmu) -> Result<Vec<u8>, Failure> {
    let failed = |error: std::io::Error| Failure::Output("sources of the unit".to_owned(), error);
    let folder = tempfile::tempdir().map_err(failed)?;
    for (name, text) in &unit.sources {
        std::fs::write(folder.path().join(name), text).map_err(failed)?;
    }
    let compiler = std::env::var_os("CC").filter(|name| !name.is_empty()).unwrap_or_else(|| OsString::from("cc"));
    // The variable may contain arguments after the name of the compiler, as in `CC="ccache gcc"`.
    let name = compiler.to_string_lossy().into_owned();
    let mut words = name.split_whitespace();
    let mut command = Command::new(words.next().unwrap_or("cc"));
    command.args(words);
    command.current_dir(folder.path()).args(["-std=c99", "-O2", "-fPIC", "-shared", "-fvisibility=hidden"]);
    command.args(unit.sources.iter().map(|(name, _)| name).filter(|name| is_fmu_source(name)));
    command.args(["-lm", "-o", "unit"]);
    let help = "install a C compiler, name it by the environment variable CC, or give --only-sources";
    let result = command
        .output()
        .map_err(|error| Failure::request(format!("the C compiler `{name}` cannot be run: {error}"), help))?;
    if !result.status.success() {
        let said = String::from_utf8_lossy(&result.stderr).into_owned();
        let first = said.lines().next().map_or_else(|| result.status.to_string(), str::to_owned);
        return Err(Failure::request(format!("the C compiler `{name}` refuses the sources: {first}"), help));
    }
    std::fs::read(folder.path().join("unit")).map_err(failed)
}

/// True for sources that are passed to the compiler, which have the extension `.c`. Other sources are included by them.
fn is_fmu_source(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|extension| extension == "c")
}

/// Returns the bytes of the unit's ZIP archive: description, sources and binary. Equal units have
/// equal bytes.
/// `Err` if the archive cannot be made.
fn fmu_archive(unit: &Fmu, version: Version, binary: Option<&[u8]>) -> zip::result::ZipResult<Vec<u8>> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().last_modified_time(DateTime::default());
    let mut add = |name: String, bytes: &[u8]| {
        zip.start_file(name, options)?;
        Ok::<(), zip::result::ZipError>(zip.write_all(bytes)?)
    };
    add("modelDescription.xml".to_owned(), unit.description.as_bytes())?;
    if let Some(binary) = binary {
        let ending = std::env::consts::DLL_EXTENSION;
        add(format!("binaries/{}/{}.{ending}", platform(version), unit.identifier), binary)?;
    }
    for (name, text) in &unit.sources {
        add(format!("sources/{name}"), text.as_bytes())?;
    }
    if version == Version::Three {
        add("sources/buildDescription.xml".to_owned(), build_description(unit).as_bytes())?;
    }
    Ok(zip.finish()?.into_inner())
}

/// Returns the text of `buildDescription.xml`, by which importing tools compile the sources of a
/// unit by FMI 3.0.
fn build_description(unit: &Fmu) -> String {
    let sources = unit.sources.iter().map(|(name, _)| name).filter(|name| is_fmu_source(name));
    let list: Vec<String> = sources.map(|name| format!("      <SourceFile name=\"{name}\"/>\n")).collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiBuildDescription fmiVersion=\"3.0\">\n  <BuildConfiguration \
         modelIdentifier=\"{}\">\n    <SourceFileSet language=\"C99\">\n{}    </SourceFileSet>\n  \
         </BuildConfiguration>\n</fmiBuildDescription>\n",
        unit.identifier,
        list.concat()
    )
}
