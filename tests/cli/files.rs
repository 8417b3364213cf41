//! Files that commands write: whole or not there, never over what is read, never elsewhere than they were called for.

#![cfg(unix)]

use crate::support::{SLIDER, command, root, status, stderr};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

fn run_in(folder: &Path, arguments: &[&str]) -> Output {
    command(folder, arguments).output().unwrap()
}

fn text(path: impl AsRef<Path>) -> String {
    std::fs::read_to_string(path).unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap();
    let mut list: Vec<String> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    list.sort();
    list
}

const SCENE: &str = "model = \"model.toml\"\nspan = [0, 2]\n[start]\nx = 1\nu = 0\n";

/// A scene that takes hours: by fixed steps, so that every one of them is kept.
const LONG: &str = "model = \"model.toml\"\nspan = [0, 100000]\n[start]\nx = 1\nu = 0\n[integration]\nmethod = \"rk4\"\n\
                    step = 0.0001\nstep_limit = 1000000000\nsamples = 100000\n";

/// A slider and a scene of it, in one folder.
fn slider(scene: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.toml"), SLIDER).unwrap();
    std::fs::write(folder.path().join("run.toml"), scene).unwrap();
    folder
}

/// Starts a command, and interrupts it after a while: exit status, standard output, standard error.
fn interrupted(mut command: Command, after: Duration) -> (i32, String, String) {
    let child = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    std::thread::sleep(after);
    signal(&child, "INT");
    let begun = Instant::now();
    let output = child.wait_with_output().unwrap();
    assert!(begun.elapsed() < Duration::from_secs(20), "it ends soon");
    (status(&output), String::from_utf8(output.stdout.clone()).unwrap(), stderr(&output))
}

fn signal(child: &Child, name: &str) {
    let sent = Command::new("kill").args([&format!("-{name}"), &child.id().to_string()]).status();
    assert!(sent.unwrap().success(), "it is still running");
}

/// The checkout that the program was built from is not its own: only the folder that it is called in, and those above,
/// are.
#[test]
fn no_command_writes_to_a_workspace_that_it_was_not_called_in() {
    let folder = tempfile::tempdir().unwrap();
    for arguments in [&["regenerate"][..], &["regenerate", "--check"]] {
        let output = run_in(folder.path(), arguments);
        let message = stderr(&output);
        assert_eq!(status(&output), 2, "{arguments:?}: {message}");
        assert!(message.contains("no workspace: neither `") && message.contains("help: "), "{message}");
        assert!(message.contains(&*folder.path().to_string_lossy()), "where it looked: {message}");
        assert!(output.stdout.is_empty() && names(folder.path()).is_empty());
    }
    let output = run_in(folder.path(), &["page"]);
    let message = stderr(&output);
    assert!(status(&output) == 2 && message.contains("no model is given"), "{message}");
    assert!(message.contains("help: give a model file") && names(folder.path()).is_empty(), "{message}");
    let output = run_in(folder.path(), &["page", "models/disk"]);
    assert!(stderr(&output).contains("there is no model at `models/disk`"), "{}", stderr(&output));
    // A model of a workspace is known from anywhere.
    let model = root().join("models/pendulum");
    let output = run_in(folder.path(), &["simulate", model.join("scenes/swing.toml").to_str().unwrap(), "--json"]);
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(json["compiled"], true);
}

/// From a folder inside a workspace it is found, and only there is anything written.
#[test]
fn a_workspace_is_found_from_the_folders_in_it() {
    let folder = tempfile::tempdir().unwrap();
    for inside in ["models/slider", "generated/src", "deep/down"] {
        std::fs::create_dir_all(folder.path().join(inside)).unwrap();
    }
    std::fs::write(folder.path().join("models/slider/model.toml"), SLIDER).unwrap();
    let output =
        command(&folder.path().join("deep/down"), &["regenerate"]).env("TRIPOS_PYTHON", "none").output().unwrap();
    assert_eq!(status(&output), 0, "{}", stderr(&output));
    assert!(folder.path().join("generated/src/slider/kane.rs").is_file());
    assert!(names(&folder.path().join("deep/down")).is_empty());
}

#[test]
fn nothing_is_written_over_what_is_read() {
    let folder = slider(SCENE);
    std::os::unix::fs::symlink("run.toml", folder.path().join("soft.csv")).unwrap();
    std::fs::hard_link(folder.path().join("model.toml"), folder.path().join("hard.csv")).unwrap();
    std::fs::write(folder.path().join("notes.txt"), "precious").unwrap();
    let before = names(folder.path());
    for out in ["run.toml", "./run.toml", "model.toml", "soft.csv", "hard.csv"] {
        for arguments in [
            &["simulate", "run.toml", "--csv", out][..],
            &["simulate", "run.toml", "--overwrite", "--csv", out],
            &["sweep", "run.toml", "--over", "k=1,2", "--overwrite", "--out", out],
        ] {
            let output = run_in(folder.path(), arguments);
            assert_eq!(status(&output), 2, "{arguments:?}");
            assert!(stderr(&output).contains("would overwrite the input"), "{}", stderr(&output));
        }
    }
    assert_eq!(
        (text(folder.path().join("run.toml")), text(folder.path().join("model.toml"))),
        (SCENE.into(), SLIDER.into())
    );
    let output = run_in(folder.path(), &["simulate", "run.toml", "--csv", "notes.txt"]);
    assert!(status(&output) == 2 && stderr(&output).contains("does not end in `.csv`"), "{}", stderr(&output));
    assert_eq!((text(folder.path().join("notes.txt")).as_str(), names(folder.path())), ("precious", before));
    let output = run_in(folder.path(), &["simulate", "run.toml", "--csv", "notes.txt", "--overwrite"]);
    assert_eq!(status(&output), 0, "{}", stderr(&output));
    assert!(text(folder.path().join("notes.txt")).starts_with("t,x,u,"));
    // A table of the command's own kind is replaced without a word.
    for _ in 0..2 {
        assert_eq!(status(&run_in(folder.path(), &["simulate", "run.toml", "--csv", "a.csv"])), 0);
    }
    // A page that is the model under another name.
    std::os::unix::fs::symlink("model.toml", folder.path().join("index.html")).unwrap();
    let output = run_in(folder.path(), &["page", ".", "--out", "."]);
    assert!(status(&output) == 2 && stderr(&output).contains("would overwrite the input"), "{}", stderr(&output));
    assert_eq!(text(folder.path().join("model.toml")), SLIDER);
}

/// Goal: what cannot be written to its end leaves what was there. Method: the size of files is limited, so that the
/// write fails in the middle as on a full disk.
#[test]
fn a_full_disk_leaves_the_old_file() {
    let folder = slider(&SCENE.replace("[0, 2]", "[0, 2000]"));
    let sh = |limit: &str, line: &str| {
        let script = format!("trap '' XFSZ; ulimit -f {limit}; exec \"$0\" {line}");
        let mut sh = Command::new("sh");
        sh.args(["-c", &script, env!("CARGO_BIN_EXE_tripos")]).current_dir(folder.path()).output().unwrap()
    };
    let lines = [
        ("a.csv", "simulate run.toml --csv a.csv"),
        ("out/index.html", "page . --out out"),
        ("emitted/mod.rs", "emit . --out emitted"),
    ];
    for (file, line) in lines {
        let path = folder.path().join(file);
        let inside = path.parent().unwrap().to_owned();
        std::fs::create_dir_all(&inside).unwrap();
        let old = "// Generated from `model.toml`. Do not edit; run `tripos emit`.\nold";
        if file == "emitted/mod.rs" {
            std::fs::write(&path, format!("//! {}", &old[3..])).unwrap();
        } else {
            std::fs::write(&path, old).unwrap();
        }
        let before = text(&path);
        // In blocks of 512 bytes.
        let output = sh("1", line);
        let message = stderr(&output);
        assert_eq!(status(&output), 2, "{line}: {message}");
        assert!(message.contains("cannot write `") && message.contains("help: "), "{line}: {message}");
        assert_eq!(text(&path), before, "{line}");
        let left: Vec<String> = names(&inside).into_iter().filter(|name| name.contains(".part")).collect();
        assert!(left.is_empty(), "{line}: {left:?}");
    }
    if Path::new("/dev/full").exists() {
        let output = run_in(folder.path(), &["simulate", "run.toml", "--csv", "/dev/full"]);
        assert!(status(&output) == 2 && stderr(&output).contains("cannot write `/dev/full`"), "{}", stderr(&output));
    }
}

#[test]
fn pipes_and_write_protected_files_are_respected() {
    let folder = slider(SCENE);
    let output = run_in(folder.path(), &["simulate", "run.toml", "--json", "--csv", "/dev/stdout"]);
    let answer = String::from_utf8(output.stdout.clone()).unwrap();
    assert!(status(&output) == 0 && answer.contains("\nt,x,u,kinetic_energy,potential_energy\n0,1,0,"), "{answer}");
    let path = folder.path().join("old.csv");
    std::fs::write(&path, "old").unwrap();
    std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o444)).unwrap();
    let output = run_in(folder.path(), &["simulate", "run.toml", "--csv", "old.csv"]);
    assert!(status(&output) == 2 && stderr(&output).contains("cannot write `old.csv`"), "{}", stderr(&output));
    assert_eq!(text(&path), "old");
}

/// A command that is killed while it writes leaves nothing cut under the name: the old file, or the whole new one.
#[test]
fn a_kill_leaves_no_cut_file() {
    let folder = slider(&SCENE.replace("[0, 2]", "[0, 20000]"));
    let path = folder.path().join("a.csv");
    assert_eq!(status(&run_in(folder.path(), &["simulate", "run.toml", "--csv", "a.csv"])), 0);
    let whole = text(&path);
    assert!(whole.len() > 1_000_000);
    let mut cut = 0;
    for wait in 0..12 {
        let mut command = command(folder.path(), &["simulate", "run.toml", "--csv", "a.csv"]);
        let mut child = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        // Until the writing has begun, and a little into it.
        let part = folder.path().join("a.csv.part");
        let writes = || part.exists() || path.metadata().unwrap().len() < whole.len() as u64;
        let begun = Instant::now();
        while !writes() && child.try_wait().unwrap().is_none() && begun.elapsed() < Duration::from_secs(20) {
            std::thread::sleep(Duration::from_micros(200));
        }
        std::thread::sleep(Duration::from_millis(wait));
        let _ = child.kill();
        child.wait().unwrap();
        cut += usize::from(part.exists());
        assert!(text(&path) == whole, "killed after {wait} ms of writing");
    }
    assert!(cut > 0, "some were killed while they wrote");
    assert_eq!(status(&run_in(folder.path(), &["simulate", "run.toml", "--csv", "a.csv"])), 0);
    assert_eq!(names(folder.path()), ["a.csv", "model.toml", "run.toml"], "the next one takes over the part");
}

/// Goal: a finished table is never replaced by that of another sweep. Method: pairs of sweeps with one --out, begun
/// together; one of them is whole in the end, and the other was refused.
#[test]
fn of_two_sweeps_with_one_name_one_writes_it() {
    let folder = slider(SCENE);
    for round in 0..25 {
        let out = format!("{round}.csv");
        let begin = |over: &str| {
            let mut command = command(folder.path(), &["sweep", "run.toml", "--over", over, "--out", &out]);
            command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap()
        };
        let both = [begin("k=1:2:3"), begin("m=1:2:5")].map(|child| child.wait_with_output().unwrap());
        let ends = both.each_ref().map(status);
        let lines = text(folder.path().join(&out)).lines().count();
        match ends {
            [0, 2] => assert_eq!(lines, 4, "{}", stderr(&both[1])),
            [2, 0] => assert_eq!(lines, 6, "{}", stderr(&both[0])),
            _ => panic!("{ends:?}: {} {}", stderr(&both[0]), stderr(&both[1])),
        }
    }
    assert!(names(folder.path()).iter().all(|name| !name.contains(".part")));
}

#[test]
fn an_interrupted_chart_keeps_what_it_measured() {
    let scene = root().join("models/disk/scenes/report-10s.toml");
    let folder = tempfile::tempdir().unwrap();
    let (mut lines, mut wait) = (0, Duration::from_secs(3));
    // A slow machine has measured nothing by then.
    while lines < 2 && wait < Duration::from_secs(60) {
        let command = command(folder.path(), &["chart", scene.to_str().unwrap(), "--out", "chart"]);
        let (status, _, message) = interrupted(command, wait);
        assert_eq!(status, 130, "{message}");
        let table = folder.path().join("chart/work_precision.csv");
        lines = if table.is_file() { text(&table).lines().count() } else { 0 };
        let said = if lines == 0 { "nothing is written" } else { "are partial" };
        assert!(message.contains(said), "{message}");
        wait *= 2;
    }
    assert!(lines >= 2, "rows were kept");
    assert_eq!(
        names(&folder.path().join("chart")),
        ["drifts.csv", "times.csv", "work_precision.csv", "work_precision.svg"]
    );
}

#[test]
fn an_interrupted_run_keeps_its_samples() {
    let folder = slider(LONG);
    let command = command(folder.path(), &["simulate", "run.toml", "--csv", "a.csv", "--json"]);
    let (status, out, message) = interrupted(command, Duration::from_secs(2));
    assert_eq!(status, 130, "{message}");
    let json: serde_json::Value = serde_json::from_str(&out).unwrap_or_else(|_| panic!("{out}{message}"));
    assert_eq!(json["stop"], "interrupted");
    let table = text(folder.path().join("a.csv"));
    let last: f64 = table.lines().last().unwrap().split(',').next().unwrap().parse().unwrap();
    let end = json["t"].as_f64().unwrap();
    assert!(last > 0.0 && last <= end && end < 100_000.0, "{last} of {end}");
    assert!(message.contains("interrupted"), "{message}");
}

#[test]
fn an_interrupted_sweep_says_where_its_rows_are() {
    let folder = slider(SCENE);
    let command = command(folder.path(), &["sweep", "run.toml", "--over", "k=1:2:1000000000", "--out", "a.csv"]);
    let (status, _, message) = interrupted(command, Duration::from_secs(3));
    assert_eq!(status, 130, "{message}");
    let (_, said) = message.split_once("the first ").expect(&message);
    let rows: usize = said.split(' ').next().unwrap().parse().unwrap();
    assert!(message.contains("a.csv.part") && !folder.path().join("a.csv").exists(), "{message}");
    let table = text(folder.path().join("a.csv.part"));
    assert_eq!(table.lines().count(), rows + 1);
    assert!(table.ends_with('\n') && !table.contains("interrupted"));
}

/// Every command with JSON: a failure is an object on standard output, with what, what to do and where, and for people
/// as before.
#[test]
fn failures_are_json_where_json_was_asked_for() {
    let folder = slider(&SCENE.replace("x = 1", "x = \"1 +\""));
    std::fs::write(folder.path().join("broken.toml"), SLIDER.replace("\"x'\"", "\"y'\"")).unwrap();
    for (arguments, place) in [
        (&["prove", "broken.toml", "--json"][..], Some("broken.toml")),
        (&["diff", "broken.toml", "model.toml", "--json"], Some("broken.toml")),
        (&["evaluate", "broken.toml", "--by", "kane", "--at", "x.toml", "--json"], Some("broken.toml")),
        (&["derive", "broken.toml", "--format", "json"], Some("broken.toml")),
        (&["scene", "run.toml", "--json"], Some("run.toml")),
        (&["simulate", "run.toml", "--json"], Some("run.toml")),
        (&["sweep", "run.toml", "--over", "k=1", "--out", "a.csv", "--json"], Some("run.toml")),
        (&["prove", "none", "--json"], None),
        (&["simulate", "run.toml", "--no-such", "--json"], None),
    ] {
        let output = run_in(folder.path(), arguments);
        let message = stderr(&output);
        assert_eq!(status(&output), 2, "{arguments:?}: {message}");
        let json: serde_json::Value =
            serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{arguments:?}: {:?}", output.stdout));
        assert_eq!(json["exit_status"], 2);
        let what = json["error"]["message"].as_str().unwrap();
        assert!(!what.is_empty() && message.contains(what), "{what}: {message}");
        let places = json["error"]["places"].as_array().unwrap();
        match place {
            Some(file) => {
                assert_eq!(places[0]["file"], file, "{json:#}");
                assert!(places[0]["line"].as_u64().unwrap() > 0 && places[0]["column"].as_u64().unwrap() > 0);
                assert!(!json["error"]["help"].as_str().unwrap().is_empty(), "{json:#}");
            }
            None => assert!(places.is_empty(), "{json:#}"),
        }
    }
    let output = run_in(folder.path(), &["simulate", "run.toml"]);
    assert!(output.stdout.is_empty(), "without JSON there is none");
}

/// Scenes in `scenes/` and beside the model are on one page, and what their figures plot is beside it.
#[test]
fn the_page_has_the_scenes_beside_its_model() {
    let figures = "[[figures]]\nkind = \"states\"\n[[figures]]\nkind = \"states\"\n[[figures]]\nkind = \"energy\"\n";
    let folder = slider(&format!("title = \"Beside the model\"\n{SCENE}{figures}"));
    std::fs::create_dir(folder.path().join("scenes")).unwrap();
    let inside = SCENE.replace("model.toml", "../model.toml");
    std::fs::write(folder.path().join("scenes/run.toml"), format!("title = \"In the folder\"\n{inside}{figures}"))
        .unwrap();
    std::fs::write(folder.path().join("state.toml"), "[state]\nx = 1\nu = 0\n").unwrap();
    let output = run_in(folder.path(), &["page", ".", "--out", "page"]);
    assert_eq!(status(&output), 0, "{}", stderr(&output));
    let page = text(folder.path().join("page/index.html"));
    let places = ["In the folder", "Beside the model"].map(|title| page.find(&format!("<h3>{title}")).expect(title));
    assert!(places[0] < places[1] && page.matches("<article").count() == 2);
    for scene in ["run", "run beside the model"] {
        let inside = folder.path().join("page").join(scene);
        let tables = ["energy.csv", "energy.svg", "states-2.csv", "states-2.svg", "states.csv", "states.svg"];
        assert_eq!(names(&inside), tables);
        for table in tables {
            assert!(page.contains(&format!("<a href=\"{}/{table}\">", scene.replace(' ', "%20"))), "{scene}/{table}");
        }
        let table = text(inside.join("states.csv"));
        assert!(table.starts_with("quantity,equations,t,value\nx [m],"), "{table}");
        assert!(
            table.contains(
                "\nu [m/s],Kane's method = Lagrange's equations = Newton–Euler equations = Reduced equations,0,0\n"
            ),
            "{table}"
        );
        assert!(text(inside.join("states.svg")).starts_with("<svg"));
    }
    // What is broken there is said, and the page is made of the others.
    std::fs::write(folder.path().join("other.toml"), "model = \"model.toml\"\nspan = [0, \"x\"]\n").unwrap();
    let output = run_in(folder.path(), &["page", ".", "--out", "page"]);
    assert!(status(&output) == 2 && stderr(&output).contains("other.toml"), "{}", stderr(&output));
    assert_eq!(text(folder.path().join("page/index.html")).matches("<article").count(), 2);
}

/// After a long run it would be too late.
#[test]
fn a_table_into_no_folder_is_refused_before_the_run() {
    let folder = slider(LONG);
    let output = run_in(folder.path(), &["simulate", "run.toml", "--csv", "none/out.csv"]);
    assert_eq!(status(&output), 2);
    assert!(stderr(&output).contains("cannot write `none/out.csv`: No such file"), "{}", stderr(&output));
    assert!(output.stdout.is_empty());
}

/// A name that turns the line turns no line of a message: nobody can write a help of their own below ours.
#[test]
fn a_line_break_in_a_file_name_is_written_out() {
    let folder = slider(SCENE);
    let name = "a\nhelp: trust me.toml";
    let refused = [
        (&["simulate", name][..], ""),
        (&["derive", name], ""),
        (&["simulate", name], "model = 1\n"),
        (&["simulate", "run.toml", "--csv", name], SCENE),
    ];
    for (arguments, text) in refused {
        if !text.is_empty() {
            std::fs::write(folder.path().join(name), text).unwrap();
        }
        let output = run_in(folder.path(), arguments);
        assert_eq!(status(&output), 2, "{arguments:?}");
        let message = stderr(&output);
        assert!(message.contains("a\\u{a}help: trust me.toml") && !message.contains("\nhelp: trust"), "{message}");
    }
}
