//! `tripos prove --certificate`: programs that share no code with Tripos accept true certificates and refuse others.

use crate::left_out::is_left_out;
use crate::support::{command, root, tripos_in};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Runs a program of `tests/certificate` with Python. Returns whether it ended with status 0, and what it printed.
pub fn run_checker(program: &str, arguments: &[&str]) -> (bool, String) {
    let (status, text) = status_of_checker(program, arguments);
    (status == Some(0), text)
}

/// Runs a program of `tests/certificate` with Python. Returns its exit status, and what it printed.
pub fn status_of_checker(program: &str, arguments: &[&str]) -> (Option<i32>, String) {
    let output = Command::new(python()).arg(root().join("tests/certificate").join(program)).args(arguments).output();
    let output = output.unwrap();
    let text = [output.stdout, output.stderr].concat();
    (output.status.code(), String::from_utf8_lossy(&text).into_owned())
}

/// The Python with which checkers run.
fn python() -> std::ffi::OsString {
    std::env::var_os("TRIPOS_PYTHON").filter(|p| !p.is_empty()).unwrap_or_else(|| "python3".into())
}

/// True if there is no Python 3.11; the test is then left out and counted.
pub fn is_without_python() -> bool {
    let found = Command::new(python()).args(["-c", "import tomllib"]).output().is_ok_and(|run| run.status.success());
    is_left_out("python", found, "certificates are checked by Python 3.11 or newer")
}

/// Writes the certificate of a model into a folder, and returns its path.
fn certificate(folder: &Path, model: &str) -> String {
    let path = folder.join(format!("{}.cert", model.trim_start_matches('/').replace('/', "_")));
    let output = command(&root(), &["prove", model, "--certificate"]).arg(&path).output().unwrap();
    assert!(output.status.success(), "{model}: {}", String::from_utf8_lossy(&output.stderr));
    path.to_str().unwrap().to_owned()
}

/// Lists the folders in a folder of the workspace that have a model.
fn models_in(folder: &str) -> Vec<String> {
    let entries = std::fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap().path());
    let models = entries.filter(|path: &PathBuf| path.join("model.toml").is_file());
    let mut names: Vec<String> =
        models.map(|path| format!("{folder}/{}", path.file_name().unwrap().to_string_lossy())).collect();
    names.sort();
    names
}

/// Goal: the proofs of every model of the library and of the shelf can be checked without Tripos. Method: `check.py`
/// checks each certificate, bound to the model's file and to the output of `tripos derive --json`.
#[test]
fn all_certificates_are_accepted() {
    if is_without_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let models: Vec<String> = ["models", "publications"].into_iter().flat_map(models_in).collect();
    assert!(models.len() > 40, "{models:?}");
    for model in models {
        let certificate = certificate(folder.path(), &model);
        let derivation = folder.path().join("derivation.json");
        std::fs::write(&derivation, command(&root(), &["derive", &model, "--json"]).output().unwrap().stdout).unwrap();
        let place = root().join(&model);
        let files = [place.to_str().unwrap(), derivation.to_str().unwrap()];
        let (holds, text) = run_checker("check.py", &[&certificate, "--model", files[0], "--derivation", files[1]]);
        assert!(holds && text.contains("identities hold"), "{model}: {text}");
    }
}

/// Goal: no certificate with an error is accepted. Method: a forger changes formulas, multipliers, divisors, hashes,
/// primes, names and lines in the certificates of five models, and renews all hashes and primes.
#[test]
fn tampered_certificates_are_refused() {
    if is_without_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let models = ["disk", "knife_edge", "driven_pendulum", "heavy_top", "slider_crank"];
    let files: Vec<String> = models.iter().map(|name| certificate(folder.path(), &format!("models/{name}"))).collect();
    let arguments: Vec<&str> = std::iter::once("60").chain(files.iter().map(String::as_str)).collect();
    let (holds, text) = run_checker("tamper.py", &arguments);
    assert!(holds && text.contains("300 tampered certificates are refused, 0 accepted"), "{text}");
    let pushed =
        small_model(folder.path(), "pushed", &with_torque("T", "[inputs]\nT = { unit = \"N*m\", value = 2 }\n"));
    let files = ["models/euler_top", "models/furuta", pushed.as_str()].map(|model| certificate(folder.path(), model));
    let (holds, text) = run_checker("tamper.py", &["0", &files[0], &files[1], &files[2]]);
    assert!(holds && text.contains("0 accepted"), "{text}");
    for reason in
        ["contains speeds", "it holds only", "the model lacks", "kane, power, rate", "the sides", "parameter "]
    {
        assert!(text.contains(reason), "{reason}: {text}");
    }
}

/// Text of a pendulum whose rod turns by the formula `angle` of q, with further entries of the model file.
fn pendulum(angle: &str, entries: &str) -> String {
    format!(
        r#"name = "Pendulum"
[parameters]
m = {{ unit = "kg", value = 1, positive = true }}
l = {{ unit = "m", value = 1, positive = true }}
k = {{ unit = "N/m", value = 10 }}
g = {{ unit = "m/s^2", value = 9.81, positive = true }}
J = {{ unit = "kg*m^2", value = 0.1, positive = true }}
w = {{ unit = "rad/s", value = 2 }}
alpha = {{ unit = "rad", value = 1 }}
[inertial]
frame = "N"
origin = "O"
[coordinates]
q = {{ unit = "rad" }}
[speeds]
u = "q'"
[frames]
B = {{ from = "N", axis = 3, angle = "{angle}" }}
[points]
P = {{ from = "O", frame = "B", position = [0, "-l", 0] }}
[bodies.b]
frame = "B"
centre = "P"
mass = "m"
inertia = "J"
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
{entries}"#
    )
}

/// Text of a pendulum with the torque `formula` on its rod.
fn with_torque(formula: &str, entries: &str) -> String {
    let torque = format!("[torques.drive]\non = \"b\"\nframe = \"N\"\nvector = [0, 0, \"{formula}\"]\n{entries}");
    pendulum("q", &torque)
}

/// Text of a model of rigid bodies on joints, from its bodies and joints.
fn jointed(entries: &str) -> String {
    format!(
        r#"name = "Joints"
[parameters]
m = {{ unit = "kg", value = 1, positive = true }}
l = {{ unit = "m", value = 1, positive = true }}
g = {{ unit = "m/s^2", value = 9.81, positive = true }}
J = {{ unit = "kg*m^2", value = 0.1, positive = true }}
[inertial]
frame = "N"
origin = "O"
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
{entries}"#
    )
}

/// Text of a model with one rigid body on a joint with the given keys.
fn on_joint(keys: &str) -> String {
    let inertia = "{ diagonal = [\"J\", \"2*J\", \"2*J\"] }";
    jointed(&format!(
        "[bodies]\nb = {{ mass = \"m\", inertia = {inertia} }}\n[joints]\nj = {{ body = \"b\", {keys} }}\n"
    ))
}

/// Writes a model into a folder of its own, and returns the folder's path.
fn small_model(folder: &Path, name: &str, text: &str) -> String {
    let place = folder.join(name);
    std::fs::create_dir(&place).unwrap();
    std::fs::write(place.join("model.toml"), text).unwrap();
    place.to_str().unwrap().to_owned()
}

/// Goal: true certificates are accepted, of whatever formulas the model has. Method: angles with factors and offsets,
/// functions in loads, names of speeds by default, constraints without spaces, and a chain of ten bodies.
#[test]
fn true_certificates_of_small_models_are_accepted() {
    if is_without_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let mut models: Vec<(String, String)> = Vec::new();
    let angles =
        ["q + pi/3", "q - pi/4", "0.3*q", "1.1*q", "q/3 + 0.2", "q + alpha/3", "70*q", "q + l*k/(m*g)", "q + pi/7"];
    models.extend(angles.iter().map(|angle| ((*angle).to_owned(), pendulum(angle, ""))));
    let functions = [
        "k*l^2*tan(q/2)",
        "k*l^2*log(2 + q)",
        "k*l^2*min(q, 1)",
        "k*l^2*max(0, q)",
        "k*l^2*atan2(sin(q), 2)",
        "k*l^2*tanh(q)",
        "k*l^2*sinh(q)",
        "k*l^2*asin(q/9)",
        "k*l^2*acos(q/9)",
        "k*l^2*cot(q)",
        "k*l^2*abs(q)*q",
        "k*l^2*cos(w*t + pi/4)",
        "k*l^2*exp(-q)",
        "k*l^2*sqrt(q^2)*q",
        "k*l^2*q^1.5",
        "k*l^2*(1 + q^2)^(1/2)",
        "k*l^2*sqrt(6)*sqrt(11)*q",
    ];
    models.extend(functions.iter().map(|formula| ((*formula).to_owned(), with_torque(formula, ""))));
    let joints = [
        "kind = \"universal\", centre = [\"l\", 0, 0]",
        "kind = \"cylinder\", axis = 2, centre = [\"l\", 0, 0]",
        "kind = \"ball\", centre = [\"l\", 0, 0]",
        "kind = \"ball\", centre = [\"l\", 0, 0], sequence = \"euler\"",
        "kind = \"free\"",
        "kind = \"pin\", axis = [1, 1, 3], centre = [\"l\", 0, 0]",
    ];
    models.extend(joints.iter().map(|keys| ((*keys).to_owned(), on_joint(keys))));
    let chain = "[bodies]\n\"b{i in 1..10}\" = { mass = \"m\", inertia = \"J\" }\n[joints]\np1 = { kind = \"pin\", \
                 body = \"b1\", centre = [\"l/2\", 0, 0] }\n\"p{i in 2..10}\" = { kind = \"pin\", body = \"b{i}\", \
                 to = \"b{i-1}\", at = [\"l\", 0, 0], centre = [\"l/2\", 0, 0] }\n";
    models.push(("ten bodies".to_owned(), jointed(chain)));
    let rod = std::fs::read_to_string(root().join("models/cartesian_pendulum/model.toml")).unwrap();
    models.push(("no spaces".to_owned(), rod.replace("x^2 + y^2 = l^2", "x^2+y^2=l^2")));
    for (at, (what, text)) in models.iter().enumerate() {
        let place = small_model(folder.path(), &format!("m{at}"), text);
        let path = certificate(folder.path(), &place);
        let (holds, said) = run_checker("check.py", &[&path, "--model", &place]);
        assert!(holds, "{what}: {said}");
        let (holds, said) = run_checker("kinematics.py", &[&path]);
        assert!(holds && said.contains("equation of"), "{what}: {said}");
    }
}

/// Goal: `prove` refuses what the checker could not check, when it writes the certificate. Method: a root of 37.
#[test]
fn roots_of_large_primes_are_refused_when_written() {
    let folder = tempfile::tempdir().unwrap();
    let place = small_model(folder.path(), "m", &on_joint("kind = \"pin\", axis = [1, 6, 0], centre = [\"l\", 0, 0]"));
    let (status, _, err) = tripos_in(folder.path(), &["prove", &place, "--certificate", "c.cert"]);
    assert!(status == 2 && err.contains("no certificate can contain sqrt(37)"), "{status} {err}");
    assert!(!folder.path().join("c.cert").exists());
}

/// Goal: a certificate never replaces its model, and needs a proof of the standard formulations. Method: the model as
/// the output file, and a further formulation.
#[test]
fn a_certificate_replaces_no_model() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::copy(root().join("models/pendulum/model.toml"), folder.path().join("model.toml")).unwrap();
    let (status, out, err) = tripos_in(folder.path(), &["prove", "model.toml", "--certificate", "model.toml"]);
    assert!(status == 2 && err.contains("would overwrite the input"), "{status} {out} {err}");
    let words = ["prove", "model.toml", "--certificate", "c.json", "--also", "gibbs-appell"];
    let (status, _, err) = tripos_in(folder.path(), &words);
    assert!(status == 2 && err.contains("cannot be used with"), "{status} {err}");
}

/// Goal: the certified equations are those of the model, not only consistent. Method: `kinematics.py` derives Kane's
/// rows of every model of the library again, and refuses equations whose model has another mass, place or load.
#[test]
fn certified_equations_are_those_of_the_model() {
    if is_without_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let files: Vec<String> = models_in("models").iter().map(|model| certificate(folder.path(), model)).collect();
    // Status 3: these models are not checked as a whole.
    let unchecked = [
        ("bricard", "the loop of the joint P6"),
        ("governor", "the coordinate z, which a loop eliminates"),
        ("slider_crank", "the coordinate y, which a loop eliminates"),
    ];
    for file in &files {
        let name = Path::new(file).file_stem().unwrap().to_string_lossy();
        let left = unchecked.iter().find(|(model, _)| name.ends_with(model));
        let (status, text) = status_of_checker("kinematics.py", &[file]);
        match left {
            Some((_, what)) => assert!(status == Some(3) && text.contains(&format!("not checked: {what}")), "{text}"),
            None => assert!(status == Some(0) && text.contains("potential energy and power of the loads"), "{text}"),
        }
    }
    let chosen = ["cart_pendulum_3", "driven_pendulum", "heavy_top", "rolling_disc", "elastic_pendulum"];
    let names = chosen.map(|name| folder.path().join(format!("models_{name}.cert")).to_str().unwrap().to_owned());
    let arguments: Vec<&str> = ["models", "12"].into_iter().chain(names.iter().map(String::as_str)).collect();
    let (holds, text) = run_checker("tamper.py", &arguments);
    assert!(holds && text.contains("60 changed models are refused, 0 accepted"), "{text}");
}

/// Writes the certificate of the verdicts on a publication of a model into a folder, and returns its path.
fn certificate_of_verdicts(folder: &Path, model: &str, publication: &str) -> String {
    let path = folder.join(format!("{}.verdicts", model.trim_start_matches('/').replace('/', "_")));
    let output = command(&root(), &["diff", model, publication, "--certificate"]).arg(&path).output().unwrap();
    assert!(path.is_file(), "{model}: {}", String::from_utf8_lossy(&output.stderr));
    path.to_str().unwrap().to_owned()
}

/// Goal: the verdicts on every publication of the shelf and on the report of the disk can be checked without Tripos.
/// Method: `verdicts.py` reads each publication and derives each quantity again. All right and wrong entries that
/// Tripos prints are claimed, except those that the certificate counts.
#[test]
fn verdicts_on_publications_are_accepted() {
    if is_without_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let models: Vec<String> = std::iter::once("models/disk".to_owned()).chain(models_in("publications")).collect();
    assert!(models.len() > 20, "{models:?}");
    for model in models {
        let place = root().join(&model);
        let publication = place.join("publication.toml");
        let file = certificate_of_verdicts(folder.path(), &model, publication.to_str().unwrap());
        let place = place.to_str().unwrap();
        let (status, text) = status_of_checker("verdicts.py", &[&file, "--model", place, "--publication", place]);
        // The kinematics of the checker does not know added masses.
        let expected = if model.ends_with("marine_craft") { 3 } else { 0 };
        assert_eq!(status, Some(expected), "{model}: {text}");
        let expected = match model.rsplit('/').next() {
            Some("disk") => "378 entries are right, 43 are wrong, 15 are statements; 32 corrections",
            Some("cone_pendulum_tutorial") => "5 entries are right, 1 are wrong, 0 are statements; 1 corrections",
            Some("satellite_quaternion") => "17 entries are right, 0 are wrong",
            _ => "entries are right",
        };
        assert!(text.contains(expected), "{model}: {text}");
    }
}

/// Goal: no certificate with a wrong verdict is accepted. Method: a forger exchanges right and wrong, and changes
/// printed formulas, readings, corrections, factors, hashes and the derivation, in the certificates of three
/// publications.
#[test]
fn tampered_verdicts_are_refused() {
    if is_without_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let models = ["models/disk", "publications/cone_pendulum_tutorial", "publications/rolling_disc_lagrange"];
    let files = models.map(|model| {
        let publication = root().join(model).join("publication.toml");
        certificate_of_verdicts(folder.path(), model, publication.to_str().unwrap())
    });
    let arguments: Vec<&str> = std::iter::once("40").chain(files.iter().map(String::as_str)).collect();
    let (holds, text) = run_checker("tamper_verdicts.py", &arguments);
    assert!(holds && text.contains("120 tampered certificates are refused, 0 accepted"), "{text}");
}

/// Goal: each kind of entry is judged by the checker as by Tripos. Method: a publication with energies up to a
/// constant, a chain, equations of motion, reactions, generalized forces, quantities that the checker does not know,
/// and rows with multipliers of the author.
#[test]
fn verdicts_on_all_kinds_of_entries_are_accepted() {
    if is_without_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let entry = |id: &str, quantity: &str, printed: &str| {
        let quantity = if quantity.is_empty() { String::new() } else { format!("quantity = \"{quantity}\"\n") };
        format!("[[equation]]\nid = \"{id}\"\nsection = \"1\"\n{quantity}printed = \"{printed}\"\n")
    };
    let pendulum = [
        "title = \"P\"\n[abbreviations]\ns = \"sin(theta)\"\n".to_owned(),
        entry("V", "V", "V = -m*g*l*cos(theta)"),
        entry("V-wrong", "V", "-m*g*cos(theta)"),
        entry("energy", "energy", "m*l^2*theta'^2/2 - m*g*l*cos(theta) + 5"),
        entry("T", "T", "T = m*l^2*omega^2/2 = m*l*theta'^2/2"),
        entry("motion", "", "ddt(m*l^2*theta') + m*g*l*s = 0"),
        entry("motion-wrong", "", "theta'' = -g*s"),
        entry("rod", "rod", "m*l*theta'^2 + m*g*cos(theta)"),
        entry("rod-wrong", "rod", "m*l*theta'^2"),
        entry("rate", "omega'", "-g*s/l"),
        entry("force", "F[1]", "-m*g*l*s"),
        entry("slope", "g[1]", "m*g*l*s"),
        entry("near", "", "theta'' + g/l*theta = 0") + "about = { theta = 0 }\n",
        entry("mass", "M[1,1]", "m*l^2"),
        entry("momentum", "ddt_dL_dqdot[theta]", "m*l^2*theta''"),
    ];
    let bob = [
        "title = \"C\"\n".to_owned(),
        entry("T", "T", "m*v^2/2"),
        entry("V", "V", "m*g*y"),
        "[[system]]\nid = \"rows\"\nsection = \"1\"\nformulation = \"lagrange\"\nequations = [\"m*x'' = \
         -x*lambda_rod\", \"m*y'' = -y*lambda_rod - m*g\", \"x*x'' + y*y'' + x'^2 + y'^2 = 0\"]\n"
            .to_owned(),
    ];
    let cases = [
        ("models/pendulum", pendulum.concat(), "8 entries are right, 4 are wrong", "3 entries are not certified"),
        ("models/cartesian_pendulum", bob.concat(), "2 entries are right, 0 are wrong", "3 entries are not certified"),
    ];
    for (model, text, verdicts, left_out) in cases {
        let place = folder.path().join("publication.toml");
        std::fs::write(&place, text).unwrap();
        let file = certificate_of_verdicts(folder.path(), model, place.to_str().unwrap());
        let (holds, said) = run_checker("verdicts.py", &[&file]);
        assert!(holds && said.contains(verdicts) && said.contains(left_out), "{said}");
    }
    let publication = folder.path().join("publication.toml");
    let publication = publication.to_str().unwrap();
    let pendulum = "models/pendulum";
    for (words, reason) in [
        (vec!["diff", pendulum, publication, "--certificate", publication], "would be replaced"),
        (vec!["diff", pendulum, pendulum, "--certificate", "c"], "this file is a model"),
        (vec!["diff", pendulum, publication, publication, "--certificate", "c"], "one publication"),
        (vec!["diff", pendulum, publication, "--certificate", "c", "--find-coordinates"], "cannot be used with"),
    ] {
        let (status, _, err) = tripos_in(&root(), &words);
        assert!(status == 2 && err.contains(reason), "{words:?}: {status} {err}");
    }
}

/// Goal: short claims hold exactly, by a computer algebra system that parses and differentiates for itself. Method:
/// `check_sympy.py` on six models, one with time and one with a loop.
#[test]
fn sympy_proves_short_claims() {
    if crate::sympy::is_left_out("certificates") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let names = ["disk", "knife_edge", "driven_pendulum", "four_bar", "satellite", "slider_crank"];
    let files = names.map(|name| certificate(folder.path(), &format!("models/{name}")));
    let program = root().join("tests/certificate/check_sympy.py");
    let output = Command::new(crate::sympy::python()).arg(program).args(&files).output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(text.matches("SymPy proves").count(), names.len(), "{text}");
    assert!(!text.contains("DOES NOT HOLD"), "{text}");
}

/// Goal: people read the lemmas that Coq checks. Method: the file of a pendulum for Coq; `.ci/full` runs Coq.
#[test]
fn lemmas_for_coq_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pendulum.v");
    let words = ["prove", "models/pendulum", "--format", "coq", "--certificate"];
    let output = command(&root(), &words).arg(&path).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains("8 lemmas; 0 identities are left out"), "{text}");
    assert_eq!(text.matches("Qed.").count(), 8, "{text}");
    assert!(!["Admitted", "Axiom", "admit"].iter().any(|word| text.contains(word)), "{text}");
    let (status, _, err) = tripos_in(&root(), &["prove", "models/pendulum", "--format", "coq"]);
    assert!(status == 2 && err.contains("--certificate"), "{status} {err}");
}

/// Goal: people read the same lemmas in the syntax of Lean 4. Method: the file of a pendulum has as many lemmas as that
/// for Coq, with their premises. No test runs Lean.
#[test]
fn lemmas_for_lean_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pendulum.lean");
    let words = ["prove", "models/pendulum", "--format", "lean", "--certificate"];
    let output = command(&root(), &words).arg(&path).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains("8 lemmas; 0 identities are left out") && text.contains("import Mathlib"), "{text}");
    assert_eq!(text.matches("\ntheorem ").count(), 8, "{text}");
    assert_eq!(text.matches(":= by ").count(), 8, "{text}");
    assert!(text.contains("sin_1 ^ 2 = 1 - cos_1 ^ 2)") && text.contains("variable (x_m : ℝ)"), "{text}");
    assert!(!["sorry", "axiom", "Qed"].iter().any(|word| text.contains(word)), "{text}");
}

/// Goal: with `--exact`, every identity is proved by its normal form, or named. Method: the disk, whose 166 identities
/// are short, as text and as JSON.
#[test]
fn identities_of_the_disk_are_proved_exactly() {
    let (status, out, err) = tripos_in(&root(), &["prove", "models/disk", "--exact"]);
    assert!(status == 0 && out.contains("kane from lagrange: all 30 identities"), "{status} {out} {err}");
    assert!(!out.contains("NOT PROVED EXACTLY"), "{out}");
    let (_, out, _) = tripos_in(&root(), &["prove", "models/disk", "--exact", "--json"]);
    let value: serde_json::Value = serde_json::from_str(&out).unwrap();
    let counts = value["exact"].as_array().unwrap();
    let total = |key: &str| counts.iter().map(|count| count[key].as_u64().unwrap()).sum::<u64>();
    assert_eq!((counts.len(), total("exact"), total("not_proved_exactly")), (10, 166, 0), "{out}");
    let (_, out, _) = tripos_in(&root(), &["prove", "models/disk", "--json"]);
    assert!(!out.contains("not_proved_exactly"), "{out}");
}
