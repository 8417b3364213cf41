//! `tripos sweep --resume`: what was interrupted goes on, and ends as if it had not been.

#![cfg(unix)]

use crate::support::{command, root, status, stderr, tripos};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

const DISK: &str = "models/disk/scenes/report-10s.toml";
/// Points of every kind: some have no start, and the last take long.
const GRID: [&str; 6] = ["--over", "l=-1,0,0.5,1,2,150", "--over", "theta=0.1,2,4", "--threads", "1"];
const SCENE: &str = "span = [0, \"1000*l\"]\n[start]\ntheta = 0.5\nomega = 0\n[integration]\nmethod = \"dop853\"\nrtol = 1e-12\n\
                     atol = 1e-12\nstep_limit = 100000000\n";

fn bytes(path: &Path) -> Vec<u8> {
    std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A sweep in a folder that was killed: its table that is not whole, with the record of what it was begun with.
struct Killed {
    folder: tempfile::TempDir,
    out: PathBuf,
    part: PathBuf,
    record: Vec<u8>,
}

impl Killed {
    fn new(scene: &str, grid: &[&str]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("out.csv");
        let [part, beside] = [".part", ".part.json"].map(|end| folder.path().join(format!("out.csv{end}")));
        // Points that take long, so that it does not come to its end; what it was begun with is written first.
        let arguments = [&["sweep", scene, "--out", out.to_str().unwrap()], grid].concat();
        let mut child = command(&root(), &arguments).stderr(Stdio::null()).spawn().unwrap();
        while !std::fs::read_to_string(&beside).is_ok_and(|text| text.ends_with("}\n")) {
            assert!(child.try_wait().unwrap().is_none(), "it has a long way to go");
            std::thread::sleep(Duration::from_millis(2));
        }
        child.kill().unwrap();
        child.wait().unwrap();
        assert!(part.exists() && !out.exists());
        let record = bytes(&beside);
        Self { folder, out, part, record }
    }

    /// Leaves so much, as another kill would have.
    fn leave(&self, table: &[u8]) {
        let _ = std::fs::remove_file(&self.out);
        std::fs::write(&self.part, table).unwrap();
        std::fs::write(self.folder.path().join("out.csv.part.json"), &self.record).unwrap();
    }

    fn resume(&self, scene: &str, grid: &[&str]) -> (i32, String) {
        let arguments = [&["sweep", scene, "--resume", "--out", self.out.to_str().unwrap()], grid].concat();
        let output = tripos(&arguments);
        (status(&output), stderr(&output))
    }
}

/// Goal: the table of a killed and continued sweep is that of an uninterrupted one. Method: a sweep killed at once,
/// whose part is set to every kind of beginning of the whole table: nothing, half a header, a header, whole rows, a row
/// cut within a number, within quotes and before its end of line, and all rows.
#[test]
fn a_table_that_goes_on_is_that_of_an_uninterrupted_sweep() {
    let home = tempfile::tempdir().unwrap();
    let scene = home.path().join("scene.toml");
    std::fs::write(&scene, format!("model = '{}'\n{SCENE}", root().join("models/pendulum").display())).unwrap();
    let scene = scene.to_str().unwrap();
    let killed = Killed::new(scene, &GRID);
    let whole = {
        let out = home.path().join("whole.csv");
        let output = tripos(&[&["sweep", scene, "--out", out.to_str().unwrap()], &GRID[..]].concat());
        assert_eq!(status(&output), 3, "{}", stderr(&output));
        bytes(&out)
    };
    let lines: Vec<usize> =
        whole.iter().enumerate().filter(|(_, byte)| **byte == b'\n').map(|(at, _)| at + 1).collect();
    assert_eq!(lines.len(), 19);
    let cuts = [0, lines[0] / 2, lines[0], lines[5], lines[9] + 1, lines[11] + 20, lines[15] - 1, lines[18]];
    for (cut, kept) in cuts.into_iter().zip([0, 0, 0, 5, 9, 11, 14, 18]) {
        killed.leave(&whole[..cut]);
        let (status, said) = killed.resume(scene, &GRID);
        assert_eq!(status, 3, "{cut}: {said}");
        assert!(bytes(&killed.out) == whole, "cut at {cut}");
        let beside = if kept == 0 { String::new() } else { format!(" beside {kept} that were there") };
        let told = format!("{} points{beside} in ", 18 - kept);
        assert!(said.contains(&told) && said.contains("\n  6 no-start, first at point 0: "), "{told}: {said}");
        let left: Vec<_> = std::fs::read_dir(killed.folder.path()).unwrap().collect();
        assert_eq!(left.len(), 1, "the table, and no record");
    }
    let (status, said) = killed.resume(scene, &GRID);
    assert!(status == 2 && said.contains("is there already"), "{said}");
}

/// Goal: a refused command destroys no work. Method: the unfinished table of an earlier sweep beside a finished one.
#[test]
fn a_refused_sweep_leaves_the_unfinished_table() {
    let folder = tempfile::tempdir().unwrap();
    let (out, part) = (folder.path().join("out.csv"), folder.path().join("out.csv.part"));
    std::fs::write(&out, "finished\n").unwrap();
    std::fs::write(&part, "rows of an earlier sweep\n").unwrap();
    let scene = "models/pendulum/scenes/over.toml";
    let output = tripos(&["sweep", scene, "--over", "l=1,2", "--out", out.to_str().unwrap()]);
    assert!(status(&output) == 2 && stderr(&output).contains("is there already"), "{}", stderr(&output));
    assert_eq!((bytes(&out), bytes(&part)), (b"finished\n".to_vec(), b"rows of an earlier sweep\n".to_vec()));
}

/// Goal: rows of two sweeps never stand in one table. Method: each input that a row depends on is changed, and refused
/// with its reason; the unfinished table stays unchanged.
#[test]
fn another_sweep_does_not_go_on_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let model = std::fs::read_to_string(root().join("models/pendulum/model.toml")).unwrap();
    std::fs::write(folder.path().join("model.toml"), &model).unwrap();
    let scene = folder.path().join("scene.toml");
    let text = "model = \"model.toml\"\nspan = [0, 500]\n[start]\ntheta = 0.5\nomega = 0\n[integration]\nmethod = \"dop853\"\nrtol = 1e-12\natol = 1e-12\n";
    std::fs::write(&scene, text).unwrap();
    let name = scene.to_str().unwrap();
    let grid = ["--over", "theta=0.1:1:1000"];
    let killed = Killed::new(name, &grid);
    let left = bytes(&killed.part);
    let header = {
        let out = folder.path().join("short.csv");
        let output = tripos(&["sweep", name, "--over", "theta=0.1", "--until", "0.1", "--out", out.to_str().unwrap()]);
        assert_eq!(status(&output), 0, "{}", stderr(&output));
        bytes(&out).split_inclusive(|byte| *byte == b'\n').next().unwrap().to_vec()
    };
    let refused = |grid: &[&str], reason: &str| {
        let (status, said) = killed.resume(name, grid);
        assert!(
            status == 2 && said.contains(reason) && said.contains("--resume out to start anew"),
            "{reason}: {said}"
        );
        assert!(!killed.out.exists() && bytes(&killed.part) == left);
    };
    refused(&["--over", "theta=0.1:1:1001"], "values: `theta=0.1:1:1000` then, `theta=0.1:1:1001` now");
    refused(
        &[&grid[..], &["--rtol", "1e-9"]].concat(),
        "method: `dop853 with rtol 1e-12, atol 1e-12` then, `dop853 with rtol 1e-9",
    );
    refused(&[&grid[..], &["--method", "ode45"]].concat(), "then, `ode45 with ");
    refused(&[&grid[..], &["--by", "lagrange"]].concat(), "equations: `reduced` then, `lagrange` now");
    refused(&[&grid[..], &["--until", "400"]].concat(), "span: `0 s to 500 s` then, `0 s to 400 s` now");
    refused(&[&grid[..], &["--shard", "1/2"]].concat(), "part of the points: `1/1` then, `1/2` now");
    refused(&[&grid[..], &["--digits"]].concat(), "column of digits: `no` then, `yes` now");
    std::fs::write(&scene, text.replace("omega = 0", "omega = 0.1")).unwrap();
    refused(&grid, "text of the scene: ");
    std::fs::write(&scene, text).unwrap();
    std::fs::write(folder.path().join("model.toml"), format!("{model}# more\n")).unwrap();
    refused(&grid, "text of the model: ");
    std::fs::write(folder.path().join("model.toml"), &model).unwrap();
    // Tables that no such sweep has left.
    for (table, reason) in [
        ([&header[..], b"1,0.1,500,end,0,0,1,1,1,0,,\n"].concat(), "row 1 is not that of point 0"),
        ([&header[..], b"0,0.1\n"].concat(), "row 1 is not that of point 0"),
        ([&header[..], b"0,0.1,5.0.0,end,0,0,1,1,1,0,,\n"].concat(), "row 1 has no number in the column `t_end`"),
        (b"index,other\n".to_vec(), "its columns are others"),
    ] {
        killed.leave(&table);
        let (status, said) = killed.resume(name, &grid);
        assert!(status == 2 && said.contains(reason) && bytes(&killed.part) == table, "{reason}: {said}");
    }
    std::fs::remove_file(killed.folder.path().join("out.csv.part.json")).unwrap();
    let (status, said) = killed.resume(name, &grid);
    assert!(status == 2 && said.contains("cannot be resumed: its record `"), "{said}");
}

/// Ctrl-C keeps what is finished, and says how to go on; a sweep that has left nothing is run from its first point.
#[test]
fn an_interrupted_sweep_says_how_it_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let (out, part) = (folder.path().join("out.csv"), folder.path().join("out.csv.part"));
    let arguments =
        ["sweep", DISK, "--resume", "--until", "0.5", "--over", "q2=0.1:1:1000000000", "--out", out.to_str().unwrap()];
    let child = command(&root(), &arguments).stderr(Stdio::piped()).spawn().unwrap();
    let rows = || std::fs::read_to_string(&part).map_or(0, |text| text.lines().count());
    while rows() < 10 {
        std::thread::sleep(Duration::from_millis(10));
    }
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    let said = stderr(&output);
    assert_eq!(status(&output), 130, "{said}");
    assert!(said.contains("all points of this sweep are already run"), "{said}");
    let told =
        format!("the first {} of 1000000000 rows are in {}; --resume goes on from there", rows() - 1, part.display());
    assert!(said.contains(&told) && std::fs::read(&part).unwrap().ends_with(b"\n"), "{said}");
}

/// Goal: rows of two drives never stand in one file. Method: the table of an input is changed while a sweep is
/// interrupted.
#[test]
fn a_sweep_whose_input_has_another_table_does_not_go_on() {
    let folder = tempfile::tempdir().unwrap();
    let model = r#"
name = "Driven mass"
[parameters]
m = "2 kg"
[inputs]
F = { unit = "N", value = 0, about = "drive" }
[coordinates]
x = { unit = "m" }
[speeds]
v = "x'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", 0, 0] }
[particles]
body = { point = "P", mass = "m" }
[forces.drive]
on = "body"
frame = "N"
vector = ["F", 0, 0]
"#;
    std::fs::write(folder.path().join("model.toml"), model).unwrap();
    let table = folder.path().join("drive.csv");
    std::fs::write(&table, "t,F\n0,0\n1,1\n2,0\n3,1\n500,0\n").unwrap();
    let scene = folder.path().join("scene.toml");
    let text = "model = \"model.toml\"\nspan = [0, 500]\n[inputs]\nF = { table = \"drive.csv\", column = \"F\" }\n\
                [start]\nx = 0.5\nv = 0\n[integration]\nmethod = \"rk4\"\nstep = 1e-4\nstep_limit = 100000000\n";
    std::fs::write(&scene, text).unwrap();
    let (name, grid) = (scene.to_str().unwrap(), ["--over", "x=0.1:1:1000"]);
    let killed = Killed::new(name, &grid);
    std::fs::write(&table, "t,F\n0,0\n1,1\n2,0\n3,2\n500,0\n").unwrap();
    let (status, said) = killed.resume(name, &grid);
    assert!(status == 2 && said.contains("signals of the inputs: "), "{said}");
}
