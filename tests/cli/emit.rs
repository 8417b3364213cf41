//! `tripos emit`: the module of any model file, and what it leaves alone.

use crate::arm::{Reactions, tree_text};
use crate::left_out::is_left_out;
use crate::support::{cargo, make_crate, root, tripos_in};
use crate::sympy;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// (exit status, standard output, standard error)
fn emit(model: &Path, out: &Path, more: &[&str]) -> (i32, String, String) {
    let arguments = ["emit", model.to_str().unwrap(), "--out", out.to_str().unwrap()];
    tripos_in(&root(), &[&arguments, more].concat())
}

/// The files of a module, those of its code among them. The equations of scenes stand in a folder of their own.
fn files(folder: &Path) -> BTreeMap<String, String> {
    let of = |inside: &str| {
        let entries = std::fs::read_dir(folder.join(inside)).unwrap().map(|entry| entry.unwrap());
        let entries: Vec<_> = entries.filter(|entry| entry.path().is_file()).collect();
        let text = |path: &Path| std::fs::read_to_string(path).unwrap();
        let name = |entry: &std::fs::DirEntry| format!("{inside}{}", entry.file_name().into_string().unwrap());
        entries.into_iter().map(|entry| (name(&entry), text(&entry.path()))).collect::<Vec<_>>()
    };
    of("").into_iter().chain(of("code/")).collect()
}

/// A copy of a model of the library under another name, without its report.
fn pendulum(folder: &Path) -> PathBuf {
    let path = folder.join("swing.toml");
    std::fs::copy(root().join("models/pendulum/model.toml"), &path).unwrap();
    path
}

/// Goal: one text, whoever asks for it. Method: the module of each model of the library, its printed equations
/// included, against the committed one, file by file.
#[test]
fn a_module_is_what_regenerate_writes_but_for_its_origin() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["disk", "pendulum"] {
        let out = folder.path().join(name);
        let (status, _, err) = emit(&root().join("models").join(name), &out, &[]);
        assert_eq!(status, 0, "{err}");
        let mut committed = files(&root().join("generated/src").join(name));
        // The model that they were derived from lies beside the equations of the workspace only.
        committed.remove("derived_from.toml");
        let emitted = files(&out);
        assert_eq!(emitted.keys().collect::<Vec<_>>(), committed.keys().collect::<Vec<_>>());
        for (file, text) in &emitted {
            // A module for another crate has no scenes.
            let scenes = "/// The equations of its scenes.\n#[rustfmt::skip]\npub mod scenes;\n";
            let committed = committed[file].replace(&format!("\n{scenes}"), "");
            let committed = committed.replace("scenes: scenes::SCENES", "scenes: &[]");
            let committed = committed.replace("`models/", "`").replace("`tripos regenerate`", "`tripos emit`");
            assert_eq!(*text, committed, "{name}/{file}");
        }
    }
}

#[test]
fn only_the_formulations_asked_for_are_emitted_and_what_went_is_removed() {
    let folder = tempfile::tempdir().unwrap();
    let (model, out) = (pendulum(folder.path()), folder.path().join("swing"));
    let (status, said, err) = emit(&model, &out, &[]);
    assert!(status == 0 && err.contains("pub mod swing"), "{err}");
    let written =
        |names: &[&str]| names.iter().map(|name| format!("written    {name}.rs\n")).collect::<Vec<_>>().concat();
    let code = ["code/kane", "code/lagrange", "code/mod", "code/newton_euler"];
    assert_eq!(said, written(&[&code[..], &["kane", "lagrange", "mod", "newton_euler"]].concat()));
    let all = files(&out);
    assert!(all["kane.rs"].contains("Generated from `swing.toml`. Do not edit; run `tripos emit`."));

    std::fs::write(out.join("mine.rs"), "// Mine.\n").unwrap();
    let (status, said, _) = emit(&model, &out, &["--formulation", "kane"]);
    assert_eq!(status, 0);
    let gone = "removed    code/lagrange.rs\nremoved    code/newton_euler.rs\nremoved    lagrange.rs\nremoved    newton_euler.rs\n";
    let kept = "unchanged  code/kane.rs\nwritten    code/mod.rs\nunchanged  kane.rs\nwritten    mod.rs\n";
    assert_eq!(said, format!("{kept}{gone}"));
    let one = files(&out);
    assert_eq!(one.keys().collect::<Vec<_>>(), ["code/kane.rs", "code/mod.rs", "kane.rs", "mine.rs", "mod.rs"]);
    assert_eq!(one["kane.rs"], all["kane.rs"]);
    assert!(one["mod.rs"].contains("pub mod kane;") && !one["mod.rs"].contains("lagrange"), "{}", one["mod.rs"]);

    let (status, _, _) = emit(&model, &out, &["--formulation", "newton-euler", "--formulation", "lagrange"]);
    assert_eq!(status, 0);
    let names = [
        "code/lagrange.rs",
        "code/mod.rs",
        "code/newton_euler.rs",
        "lagrange.rs",
        "mine.rs",
        "mod.rs",
        "newton_euler.rs",
    ];
    assert_eq!(files(&out).keys().collect::<Vec<_>>(), names);
}

#[test]
fn what_another_wrote_is_never_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    let (model, out) = (pendulum(folder.path()), folder.path().join("swing"));
    // Text that mentions the header without having it, the committed equations, bytes that are no text, a folder.
    let mention = "//! Mine.\n\n/// Not //! Generated from `x`. Do not edit; run `tripos emit`.\nfn f() {}\n";
    let committed = std::fs::read(root().join("generated/src/pendulum/lagrange.rs")).unwrap();
    for text in [mention.as_bytes(), &committed, &[0xff, 0xfe]] {
        std::fs::create_dir_all(&out).unwrap();
        std::fs::write(out.join("lagrange.rs"), text).unwrap();
        let (status, said, err) = emit(&model, &out, &[]);
        assert!(status == 2 && said.is_empty(), "{said}");
        assert!(err.contains("lagrange.rs` was not written by `tripos emit`\nhelp: "), "{err}");
        assert_eq!(std::fs::read(out.join("lagrange.rs")).unwrap(), text);
        assert_eq!(std::fs::read_dir(&out).unwrap().count(), 1, "nothing is written if anything is refused");
    }
    std::fs::remove_file(out.join("lagrange.rs")).unwrap();
    std::fs::create_dir(out.join("lagrange.rs")).unwrap();
    assert_eq!(emit(&model, &out, &[]).0, 2);
}

/// Goal: a module is written whole or not at all. Method: a second model whose name is the same word, and a read-only
/// file, the last of three. The folder keeps its bytes.
#[test]
fn a_folder_in_which_one_file_cannot_be_replaced_keeps_all() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let text = std::fs::read_to_string(root().join("models/pendulum/model.toml")).unwrap();
    for (file, text) in [("a-b.toml", text.clone()), ("a_b.toml", text.replace("9.81", "1.62"))] {
        std::fs::write(folder.path().join(file), text).unwrap();
    }
    let python = ["--language", "python"];
    assert_eq!(emit(&folder.path().join("a-b.toml"), &out, &python).0, 0);
    let before = files_in(&out);
    let (status, _, err) = emit(&folder.path().join("a_b.toml"), &out, &python);
    assert_eq!(status, 2, "{err}");
    assert!(err.contains("was written from another model, `") && err.contains("a-b.toml`\nhelp: "), "{err}");
    assert_eq!(files_in(&out), before);

    std::fs::write(folder.path().join("a-b.toml"), text.replace("9.81", "3.7")).unwrap();
    let last = before.keys().rfind(|name| name.starts_with("a_b")).unwrap();
    let locked = out.join(last);
    let mut permissions = std::fs::metadata(&locked).unwrap().permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&locked, permissions).unwrap();
    let (status, _, err) = emit(&folder.path().join("a-b.toml"), &out, &python);
    assert_eq!(status, 2, "{err}");
    assert!(err.contains("cannot write `") && err.contains(last.as_str()), "{err}");
    assert_eq!(files_in(&out), before);
}

/// All files of a folder, with their texts.
fn files_in(folder: &Path) -> BTreeMap<String, String> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap());
    let text = |path: &Path| std::fs::read_to_string(path).unwrap();
    entries.map(|entry| (entry.file_name().into_string().unwrap(), text(&entry.path()))).collect()
}

#[test]
fn bad_requests_are_answered_with_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let (model, out) = (pendulum(folder.path()), folder.path().join("swing"));
    let refused = |model: &Path, out: &Path, more: &[&str], part: &str| {
        let (status, said, err) = emit(model, out, more);
        assert!(status == 2 && said.is_empty() && err.contains("help: "), "{more:?}: {said}{err}");
        assert!(err.contains(part), "{part}: {err}");
    };
    refused(&model, &out, &["--formulation", "kan"], "did you mean `kane`?");
    refused(&model, &out, &["--with", "tailor"], "there is no function `tailor`");
    refused(&model, &out, &["--language", "js", "--with", "taylor"], "written in Rust alone");
    refused(&model, &out, &["--language", "C++"], "equations are not written in `C++`");
    refused(&model, &out, &["--language", "c", "--with", "taylor"], "written in Rust alone");
    refused(&model, &out, &["--functions", "forcing"], "functions can be chosen in C, Python, MATLAB and for CasADi");
    refused(&model, &out, &["--language", "c", "--functions", "forcings"], "did you mean `forcing`?");
    refused(&model, &out, &["--language", "python", "--functions", "constraints"], "have no function `constraints`");
    refused(&model, &out, &["--language", "c", "--functions", "outputs"], "give a scene file in place of the model");
    let kane = ["--language", "matlab", "--formulation", "kane", "--functions", "reactions"];
    refused(&model, &out, &kane, "reactions are unknowns of `--formulation newton-euler`");
    refused(&model, &folder.path().join("a-b"), &[], "`a-b` cannot be a Rust module");
    refused(&model, Path::new("/"), &[], "cannot be a module's name");
    refused(&folder.path().join("none.toml"), &out, &[], "cannot read the file");
    refused(&model, &model.join("swing"), &[], "cannot write");
    let elbow = root().join("derive/tests/models/k06a.toml");
    refused(&elbow, &out, &["--formulation", "newton-euler"], "acts on a frame without a body");
    assert!(!out.exists(), "nothing was written");

    // Not asked for by name, what cannot be had is said and left out.
    let (status, said, err) = emit(&elbow, &out, &[]);
    let names = ["code/kane", "code/lagrange", "code/mod", "kane", "lagrange", "mod"];
    assert_eq!((status, said), (0, names.map(|name| format!("written    {name}.rs\n")).concat()));
    assert!(err.contains("not emitted: newton-euler is not possible: "), "{err}");
}

/// Goal: a module is Rust that compiles without a warning, clippy's included, wherever it stands, and gives the numbers
/// of the command's own interpreter, in a crate that has nothing but the traits. Method: the acceleration of the
/// pendulum at 90°, which is −g/l; and a model whose names, angles and constants a generator gets wrong first, by two
/// formulations, as `evaluate` has it.
#[test]
fn emitted_modules_compile_in_a_crate_of_their_own_and_give_the_same_numbers() {
    let folder = tempfile::tempdir().unwrap();
    let awkward = root().join("tests/data/awkward/model.toml");
    for (model, name) in [(pendulum(folder.path()), "swing"), (awkward.clone(), "awkward")] {
        assert_eq!(emit(&model, &folder.path().join("src").join(name), &[]).0, 0);
    }
    // A disc that rolls: three speeds for five coordinates.
    let disc = root().join("models/rolling_disc");
    assert_eq!(emit(&disc, &folder.path().join("src/disc"), &["--formulation", "kane"]).0, 0);
    // What a build script writes is included from another folder.
    std::fs::rename(folder.path().join("src/swing"), folder.path().join("swing")).unwrap();
    make_crate(folder.path());
    let main = r#"
pub mod awkward;
pub mod disc;
pub mod swing {
    include!(concat!(env!("CARGO_MANIFEST_DIR"), "/swing/mod.rs"));
}
use tripos_traits::System;
fn main() {
    let mut out = [0.0];
    let p: Vec<f64> = swing::PARAMETERS.iter().map(|name| if *name == "l" { 0.5 } else { 2.0 }).collect();
    swing::kane::Kane.accelerations(&p, &[std::f64::consts::FRAC_PI_2], &[0.0], &mut out);
    println!("{}", out[0]);
    let standard = swing::Parameters::default();
    assert_eq!(swing::kane::accelerations(&standard, &[1.0], &[0.0]), [-standard.g / standard.l * f64::sin(1.0)]);
    let p = [1.5, 0.5, 0.7, 1.3, 0.31, 0.2, 0.4, 0.05, 9.81, 0.25, 0.8, 2.0, 3.0, 1e-300];
    let (q, u) = ([0.3, -0.2, 0.4, 0.1], [0.5, -0.3, 0.2, 0.6]);
    show(&awkward::kane::Kane, &p, &q, &u);
    show(&awkward::lagrange::Lagrange, &p, &q, &u);
    let (p, q, u) = ([0.31, 2.4, 9.81], [0.958, -0.087, 0.438, 0.0, 0.0], [1.409, -1.711, -2.532]);
    let (mut q_dot, mut u_dot) = ([0.0; 5], [0.0; 3]);
    disc::kane::Kane.derivative(&p, &q, &u, &mut q_dot, &mut u_dot);
    q_dot.iter().chain(&u_dot).for_each(|x| println!("{x}"));
}
fn show(system: &dyn System, p: &[f64], q: &[f64], u: &[f64]) {
    let (mut v, mut v_dot, mut u_dot) = ([0.0; 4], [0.0; 4], [0.0; 4]);
    system.motion_variables(p, q, u, &mut v);
    system.accelerations(p, q, &v, &mut v_dot);
    system.generalized_speed_rates(p, q, &v, &v_dot, &mut u_dot);
    u_dot.iter().for_each(|x| println!("{x}"));
}
"#;
    std::fs::write(folder.path().join("src/main.rs"), main).unwrap();
    let (out, warnings) = cargo(folder.path(), &["run", "--quiet"]);
    assert!(warnings.is_empty(), "{warnings}");
    let (_, warnings) = cargo(folder.path(), &["clippy", "--quiet"]);
    assert!(warnings.is_empty(), "{warnings}");
    let numbers: Vec<f64> = out.lines().map(|line| line.parse().unwrap()).collect();
    assert!(numbers.len() == 17 && (numbers[0] + 4.0).abs() < 1e-15, "{out}");
    // K03 of the reference cases: SymPy, and an engine of high precision.
    let rates =
        [-2.541_612_667_655_314, 1.409, -1.931_841_464_371_985_4, -0.344_444_896_145_077_1, -0.489_902_044_532_145_1];
    let expected = rates.into_iter().chain([3.110_810_698_252_991_7, 2.378_392, 5.132_763_623_300_128]);
    for (found, expected) in numbers[9..].iter().zip(expected) {
        assert!((found - expected).abs() < 1e-12 * expected.abs().max(1.0), "rolling: {found}, {expected}");
    }

    let state = folder.path().join("state.toml");
    let text = "[state]\nq1 = 0.3\nq2 = -0.2\nq = 0.4\nu = 0.1\nv_ = 0.5\nv = -0.3\nout = 0.2\nzero = 0.6\n";
    std::fs::write(&state, text).unwrap();
    let arguments = ["evaluate", awkward.to_str().unwrap(), "--by", "kane", "--at", state.to_str().unwrap(), "--json"];
    let (status, out, err) = tripos_in(&root(), &arguments);
    assert_eq!(status, 0, "{err}");
    let evaluated: serde_json::Value = serde_json::from_str(&out).unwrap();
    for (at, name) in ["v_'", "v'", "out'", "zero'"].iter().enumerate() {
        let expected = evaluated["accelerations"][name].as_f64().unwrap_or_else(|| panic!("{name}: {out}"));
        for compiled in [numbers[1 + at], numbers[5 + at]] {
            assert!((compiled - expected).abs() < 1e-9 * expected.abs().max(1.0), "{name}: {compiled}, {expected}");
        }
    }
}

/// Goal: emitted Jacobians and recurrences are those of the equations. Method: models with loops, momenta and many
/// angles, by two formulations, in a crate of their own and in 32 digits. Each entry of the Jacobian is compared with
/// central differences of the derivative. The polynomial of p orders satisfies the equations up to O(tᵖ): at half the
/// time the residual is 2⁻ᵖ of it. If they are not asked for, there are no recurrences, and the Jacobian is the same.
#[test]
fn jacobians_and_recurrences_that_are_asked_for_are_those_of_the_equations() {
    let folder = tempfile::tempdir().unwrap();
    let models = ["cart_pendulum_3", "four_bar", "heavy_top", "gimbals"];
    let formulations = ["--formulation", "kane", "--formulation", "lagrange"];
    let mut main = String::new();
    let mut calls = String::new();
    for model in models {
        let path = root().join("models").join(model);
        for (module, more) in [(model.to_owned(), &["--with", "jacobian,taylor"][..]), (format!("{model}_bare"), &[])] {
            let (status, _, err) =
                emit(&path, &folder.path().join("src").join(&module), &[&formulations, more].concat());
            assert_eq!(status, 0, "{err}");
            writeln!(main, "#[allow(non_snake_case)]\npub mod {module};").unwrap();
        }
        for system in ["kane::Kane", "lagrange::Lagrange"] {
            writeln!(calls, "    check(\"{model} {system}\", &{model}::{system}, &{model}_bare::{system});").unwrap();
        }
    }
    make_crate(folder.path());
    let rest = r#"
use tripos_traits::{DoubleDouble as D, Real, Scalar, System};
fn rates(system: &dyn System<D>, p: &[D], y: &[D]) -> Vec<D> {
    let n = system.lengths().coordinates;
    let mut f = vec![D::int(0); y.len()];
    let (of_q, of_v) = f.split_at_mut(n);
    system.derivative(p, &y[..n], &y[n..], of_q, of_v);
    f
}
fn jacobian(system: &dyn System<D>, p: &[D], y: &[D]) -> Vec<D> {
    let n = system.lengths().coordinates;
    let mut out = vec![D::int(0); y.len() * y.len()];
    system.jacobian(p, &y[..n], &y[n..], &mut out);
    out
}
fn check(name: &str, system: &dyn System<D>, bare: &dyn System<D>) {
    assert!(system.has_taylor() && !bare.has_taylor(), "{name}");
    let wave = |i: usize, shift: f64| (1.7 * i as f64 + shift).sin();
    let (parameters, states) = (system.lengths().parameters, system.lengths().state());
    let p: Vec<D> = (0..parameters).map(|i| D::from_f64(1.0 + 0.4 * wave(i, 0.3))).collect();
    let y: Vec<D> = (0..states).map(|i| D::from_f64(0.7 * wave(i, 1.1))).collect();
    let (entries, by_columns) = (jacobian(system, &p, &y), jacobian(bare, &p, &y));
    let size = |list: &[D]| list.iter().map(|x| x.abs().to_f64()).fold(1.0, f64::max);
    let h = D::from_f64(1e-9);
    for at in 0..states {
        let moved = |h: D| { let mut y = y.clone(); y[at] = y[at] + h; rates(system, &p, &y) };
        let (above, below) = (moved(h), moved(-h));
        for i in 0..states {
            let slope = (above[i] - below[i]) / (h + h);
            for found in [entries[i * states + at], by_columns[i * states + at]] {
                let error = (found - slope).abs().to_f64();
                assert!(error < 1e-13 * size(&entries), "{name} {i} {at}: {error:e}");
            }
        }
    }
    for order in 1..=7 {
        let mut x = y.clone();
        x.resize((order + 1) * states, D::int(0));
        system.taylor(&p, order, &mut x, &mut vec![D::int(0); system.taylor_work(order)]);
        let left = |t: D| {
            let (mut at, mut slope) = (vec![D::int(0); states], vec![D::int(0); states]);
            for k in (0..=order).rev() {
                for i in 0..states {
                    at[i] = at[i] * t + x[k * states + i];
                    if k > 0 {
                        slope[i] = slope[i] * t + D::int(k as i64) * x[k * states + i];
                    }
                }
            }
            let f = rates(system, &p, &at);
            slope.iter().zip(&f).map(|(a, b)| (*a - *b).abs().to_f64()).fold(0.0, f64::max)
        };
        let (whole, half) = (left(D::ratio(1, 4096)), left(D::ratio(1, 8192)));
        let observed = (whole / half).log2();
        assert!(whole < 1e-27 || (observed - order as f64).abs() < 0.3, "{name} {order}: {observed}");
    }
    println!("{name}");
}
fn main() {
CALLS}
"#;
    std::fs::write(folder.path().join("src/main.rs"), main + &rest.replace("CALLS", &calls)).unwrap();
    let (out, warnings) = cargo(folder.path(), &["run", "--quiet"]);
    assert!(warnings.is_empty() && out.lines().count() == 2 * models.len(), "{out}{warnings}");
}

/// Goal: a large model, whose terms are named, whose long functions are in parts and whose Jacobian is a product with a
/// direction, compiles without a warning and is right. Method: a tree of 20 bodies with full inertias, by two
/// formulations that share neither steps nor names: equal accelerations, which solve M u' = f, and Jacobians against
/// central differences.
#[test]
fn large_modules_compile_and_agree() {
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("arm.toml");
    std::fs::write(&model, tree_text(20, |i| i / 2, |i| i % 5 == 4, Reactions::None)).unwrap();
    assert_eq!(emit(&model, &folder.path().join("src/arm"), &[]).0, 0);
    make_crate(folder.path());
    let main = r#"
pub mod arm;
use tripos_traits::System;
const N: usize = 20;
fn main() {
    let p = arm::Parameters::<f64>::default().to_array();
    let (q, v): (Vec<f64>, Vec<f64>) = (0..N).map(|i| (0.3 + 0.4 * i as f64, 0.9 - 0.5 * i as f64)).unzip();
    let all = [&arm::kane::Kane as &dyn System, &arm::lagrange::Lagrange];
    let found = all.map(|system| check(system, &p, &q, &v));
    for (a, b) in found[0].iter().zip(&found[1]) {
        assert!((a - b).abs() < 1e-10 * (1.0 + a.abs()), "{found:?}");
    }
    // Inverse dynamics is M u' - f, by both.
    let q = std::array::from_fn(|i| (1.7 * i as f64).sin());
    let a = std::array::from_fn(|i| 2.0 * (0.3 + 2.3 * i as f64).cos());
    let (standard, u) = (arm::Parameters::default(), [0.5; N]);
    let (matrix, forcing) = (arm::kane::mass_matrix(&standard, &q, &u), arm::kane::forcing(&standard, &q, &u));
    let by_kane = arm::kane::inverse_dynamics(&standard, &q, &u, &a);
    let by_lagrange = arm::lagrange::inverse_dynamics(&standard, &q, &u, &a);
    for i in 0..N {
        let wanted: f64 = (0..N).map(|j| matrix[i][j] * a[j]).sum::<f64>() - forcing[i];
        let off = (by_kane[i] - wanted).abs().max((by_lagrange[i] - wanted).abs());
        assert!(off < 1e-11 * (1.0 + wanted.abs()), "{i}: {wanted}, {by_kane:?}, {by_lagrange:?}");
    }
}
fn check(system: &dyn System, p: &[f64], q: &[f64], v: &[f64]) -> Vec<f64> {
    let derivative = |q: &[f64], v: &[f64]| {
        let (mut q_dot, mut v_dot) = ([0.0; N], [0.0; N]);
        system.derivative(p, q, v, &mut q_dot, &mut v_dot);
        [q_dot, v_dot].concat()
    };
    let (mut matrix, mut forcing) = ([0.0; N * N], [0.0; N]);
    system.mass_matrix(p, q, v, &mut matrix);
    system.forcing(p, q, v, &mut forcing);
    let rates = derivative(q, v);
    for (row, f) in matrix.chunks(N).zip(forcing) {
        let left: f64 = row.iter().zip(&rates[N..]).map(|(m, a)| m * a).sum();
        assert!((left - f).abs() < 1e-10 * (1.0 + f.abs()), "{left} and {f}");
    }
    let mut jacobian = [0.0; 4 * N * N];
    system.jacobian(p, q, v, &mut jacobian);
    for column in 0..2 * N {
        let moved = |by: f64| {
            let mut y = [q, v].concat();
            y[column] += by;
            derivative(&y[..N], &y[N..])
        };
        let (up, down) = (moved(1e-5), moved(-1e-5));
        for row in 0..2 * N {
            let slope = (up[row] - down[row]) / 2e-5;
            let entry = jacobian[row * 2 * N + column];
            assert!((slope - entry).abs() < 1e-6 * (1.0 + entry.abs()), "{row} {column}: {slope} and {entry}");
        }
    }
    rates
}
"#;
    std::fs::write(folder.path().join("src/main.rs"), main).unwrap();
    let text = std::fs::read_to_string(folder.path().join("src/arm/code/kane.rs")).unwrap();
    assert!(text.contains("pub fn jacobian_product") && !text.contains("pub fn jacobian<"), "a product stands for it");
    assert!(text.contains("fn part_2<"), "long functions are in parts");
    let (_, warnings) = cargo(folder.path(), &["run", "--quiet"]);
    assert!(warnings.is_empty(), "{warnings}");
    let (_, warnings) = cargo(folder.path(), &["clippy", "--quiet"]);
    assert!(warnings.is_empty(), "{warnings}");
}

/// Goal: a person sees what a file in another language is. Method: the functions asked for, and the headers of the
/// pendulum, as they are read.
#[test]
fn files_of_other_languages_are_readable() {
    let folder = tempfile::tempdir().unwrap();
    let model = pendulum(folder.path());
    let written = |language: &str, functions: &str| {
        let out = folder.path().join(language);
        let (status, said, err) =
            emit(&model, &out, &["--language", language, "--formulation", "kane", "--functions", functions]);
        assert_eq!(status, 0, "{err}");
        (said, err, out)
    };
    let (said, err, out) = written("c", "mass_matrix,forcing");
    assert_eq!(said, "written    swing_kane.c\nwritten    swing_kane.h\nwritten    tripos.h\n");
    assert!(err.contains("#include \"swing_kane.h\""), "{err}");
    expect_test::expect_file!["emitted_c.txt"].assert_eq(&std::fs::read_to_string(out.join("swing_kane.c")).unwrap());
    let (_, _, out) = written("python", "forcing,state_derivative");
    expect_test::expect_file!["emitted_python.txt"]
        .assert_eq(&std::fs::read_to_string(out.join("swing_kane.py")).unwrap());
    let (_, _, out) = written("matlab", "forcing");
    expect_test::expect_file!["emitted_matlab.txt"]
        .assert_eq(&std::fs::read_to_string(out.join("swing_kane_forcing.m")).unwrap());
    let (_, _, out) = written("casadi", "accelerations,dae");
    expect_test::expect_file!["emitted_casadi.txt"]
        .assert_eq(&std::fs::read_to_string(out.join("swing_kane_casadi.py")).unwrap());

    // Asked again, nothing changes; asked for other functions, files that went are removed.
    let out = folder.path().join("matlab");
    let (_, said, _) = emit(&model, &out, &["--language", "matlab", "--formulation", "kane", "--functions", "forcing"]);
    assert!(said.lines().all(|line| line.starts_with("unchanged")), "{said}");
    let (_, said, _) = emit(&model, &out, &["--language", "matlab", "--formulation", "kane", "--functions", "power"]);
    assert!(said.is_empty(), "the pendulum has no such function: {said}");
    let (_, said, _) =
        emit(&model, &out, &["--language", "matlab", "--formulation", "kane", "--functions", "kinetic_energy"]);
    assert!(said.contains("removed    swing_kane_forcing.m"), "{said}");

    // Other equations of the model leave them alone, and say so.
    for language in ["c", "python", "matlab", "casadi"] {
        let out = folder.path().join(language);
        std::fs::create_dir(out.join("code")).unwrap();
        let before = files(&out);
        let (status, said, err) = emit(&model, &out, &["--language", language, "--formulation", "lagrange"]);
        assert_eq!(status, 0, "{err}");
        assert!(said.contains("kept       swing_kane") && !said.contains("removed"), "{language}: {said}");
        let after = files(&out);
        assert!(before.iter().all(|(name, text)| after[name] == *text), "{language}");
    }

    // Another model in the same folder leaves them alone.
    let other = root().join("models/furuta");
    let (status, ..) = emit(&other, &out, &["--language", "matlab", "--formulation", "kane", "--functions", "forcing"]);
    assert!(
        status == 0 && out.join("swing_kane_kinetic_energy.m").is_file() && out.join("furuta_kane_forcing.m").is_file()
    );

    // All languages share a folder; two of them write files with one extension.
    let out = folder.path().join("together");
    let languages = ["c", "python", "matlab", "casadi", "js", "rust"];
    for (time, word) in [("first", "written"), ("again", "unchanged")] {
        for language in languages {
            let (status, said, err) = emit(&model, &out, &["--language", language, "--formulation", "kane"]);
            assert_eq!(status, 0, "{err}");
            assert!(said.lines().all(|line| line.starts_with(word)), "{language} {time}: {said}");
        }
    }
}

/// Goal: the outputs and events of a scene are functions of the state in any formulation. Method: outputs of the
/// pendulum with energies, rates and accelerations, by Kane and Lagrange in Python, against their formulas; an output
/// that needs a reaction is told and left out.
#[test]
fn outputs_of_a_scene_become_functions() {
    if sympy::is_left_out("outputs in Python") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    pendulum(folder.path());
    let scene = folder.path().join("scene.toml");
    let text = "model = \"swing.toml\"\nspan = [0, 1]\n\
        outputs = [\"theta\", \"omega'\", \"theta'\", { name = \"height\", value = \"-l*cos(theta)\" }, \"total_energy\", \"rod\"]\n\
        [parameters]\nm = 2\n[start]\ntheta = 0.3\nomega = 0\n[[events]]\nname = \"low\"\nzero = \"theta\"\n";
    std::fs::write(&scene, text).unwrap();
    let out = folder.path().join("out");
    let (status, said, err) = emit(&scene, &out, &["--language", "python"]);
    assert!(status == 0 && said.contains("written    swing_kane_simulate.py"), "{err}");
    assert!(
        err.contains("`rod` is left out of the functions of Kane's method: the function needs a reaction"),
        "{err}"
    );
    let script = "import math\n\
        import swing_kane, swing_lagrange, swing_newton_euler\n\
        for m in (swing_kane, swing_lagrange, swing_newton_euler):\n    \
            assert m.OUTPUTS == ['theta', \"omega'\", \"theta'\", 'height', 'total_energy'] and m.EVENTS == ['low'], m.OUTPUTS\n    \
            right = [0.4, -9.81/0.7*math.sin(0.4), 1.5, -0.7*math.cos(0.4), 0.49*2.25 + 2*9.81*0.7*(1 - math.cos(0.4))]\n    \
            p = [2, 0.7, 9.81]\n    \
            assert max(abs(m.outputs(p, [0.4], [1.5]) - right)) < 1e-13, m.outputs(p, [0.4], [1.5])\n    \
            assert m.events(p, [0.4], [1.5]) == [0.4]\n";
    let python =
        sympy::python_with(&root().join("tests/languages/requirements.txt"), "import numpy, casadi, scipy, fmpy");
    let output = std::process::Command::new(python).current_dir(&out).args(["-c", script]).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    // The model alone has none. Its first scene still has a script.
    let (_, said, _) = emit(&folder.path().join("swing.toml"), &out, &["--language", "python"]);
    assert!(said.contains("written    swing_kane.py") && said.contains("unchanged  swing_kane_simulate.py"), "{said}");
    assert!(!std::fs::read_to_string(out.join("swing_kane.py")).unwrap().contains("def outputs("));
}

/// Goal: the first scene of a model runs from the emitted files as it runs here. Method: the script in Python for two
/// formulations, and in MATLAB where Octave is installed, against `simulate`.
#[test]
fn scripts_run_the_first_scene_of_a_model() {
    if sympy::is_left_out("scripts in Python") {
        return;
    }
    let scene = root().join("models/furuta/scenes/swing.toml");
    let (_, run, err) = tripos_in(&root(), &["simulate", scene.to_str().unwrap(), "--json"]);
    let run: serde_json::Value = serde_json::from_str(&run).unwrap_or_else(|error| panic!("{error}: {err}"));
    let expected = run["state"]["theta2"].as_f64().unwrap();
    let folder = tempfile::tempdir().unwrap();
    let model = root().join("models/furuta");
    let python =
        sympy::python_with(&root().join("tests/languages/requirements.txt"), "import numpy, casadi, scipy, fmpy");
    for formulation in ["kane", "lagrange"] {
        let (status, _, err) = emit(&model, folder.path(), &["--language", "python", "--formulation", formulation]);
        assert_eq!(status, 0, "{err}");
        let script = format!("furuta_{formulation}_simulate.py");
        let output = std::process::Command::new(&python).current_dir(folder.path()).arg(script).output().unwrap();
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        let line = said.lines().find_map(|line| line.strip_prefix("theta2 ")).unwrap_or_else(|| panic!("{output:?}"));
        assert!((line.parse::<f64>().unwrap() - expected).abs() < 1e-8, "{line} is not {expected}");
    }
    let octave = || std::process::Command::new("octave-cli");
    let found = octave().arg("--version").output().is_ok_and(|output| output.status.success());
    if is_left_out("octave", found, "there is no octave-cli") {
        return;
    }
    let (status, _, err) = emit(&model, folder.path(), &["--language", "matlab", "--formulation", "lagrange"]);
    assert_eq!(status, 0, "{err}");
    let call = "furuta_lagrange_simulate; printf('%.12g\\n', states(end, 2));";
    let output = octave().current_dir(folder.path()).args(["--no-init-file", "--eval", call]).output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    let last: f64 = said.lines().last().and_then(|line| line.trim().parse().ok()).unwrap_or(f64::NAN);
    assert!((last - expected).abs() < 1e-8, "{last} is not {expected}: {output:?}");
}
