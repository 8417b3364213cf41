//! Sweeps in lanes: the runs of a scene on which nothing is watched share the registers of the processor, and nothing
//! else.

use crate::support::{root, tripos};
use std::collections::HashMap;
use std::path::Path;

type Row = HashMap<String, String>;

/// A pendulum without events; the span follows the length, so that points differ in it.
const SCENE: &str = "span = [0, \"10*sqrt(l/g)\"]\n[start]\ntheta = 2\nomega = 0\n[integration]\nmethod = \"dop853\"\nrtol = 1e-9\natol = 1e-11\n";

fn scene(folder: &Path, text: &str) -> String {
    let path = folder.join("scene.toml");
    std::fs::write(&path, format!("model = '{}'\n{text}", root().join("models/pendulum").display())).unwrap();
    path.to_str().unwrap().to_owned()
}

fn sweep(folder: &Path, text: &str, more: &[&str]) -> String {
    let (path, out) = (scene(folder, text), folder.join("out.csv"));
    let output = tripos(&[&["sweep", &path, "--overwrite", "--out", out.to_str().unwrap()], more].concat());
    assert!(output.status.success() || output.status.code() == Some(3), "{}", String::from_utf8_lossy(&output.stderr));
    std::fs::read_to_string(out).unwrap()
}

fn rows(text: &str) -> Vec<Row> {
    csv::Reader::from_reader(text.as_bytes()).deserialize().map(Result::unwrap).collect()
}

fn number(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap()
}

/// Goal: lanes make the runs of the scalar method. Method: the same sweep with digits asked for, which keeps runs out
/// of lanes, by both methods, without events and with one that is recorded and one that ends runs. 1e-9: a hundred
/// times the tolerance on rounding, which a pendulum at 2 rad multiplies by less than 50 in 10 s; both take the same
/// steps.
#[test]
fn rows_in_lanes_are_the_runs_to_rounding() {
    let folder = tempfile::tempdir().unwrap();
    let over = ["--over", "l=0.2:3:23", "--over", "theta=-1,0.5,2,3.1"];
    let events = "\n[[events]]\nname = \"low\"\nzero = \"theta\"\n[[events]]\nname = \"fast\"\nzero = \"omega - 4\"\nterminal = true\n";
    for method in ["dop853", "taylor"] {
        let scene = SCENE.replace("dop853", method);
        for text in [scene.clone(), format!("{scene}{events}")] {
            let alone = sweep(folder.path(), &text, &[over.as_slice(), &["--digits"]].concat());
            let (lanes, alone) = (rows(&sweep(folder.path(), &text, &over)), rows(&alone));
            assert_eq!((lanes.len(), alone.len()), (92, 92));
            let mut differing = 0;
            for (a, b) in lanes.iter().zip(&alone) {
                assert_eq!((&a["stop"], &a["steps"], &a["rejected"]), (&b["stop"], &b["steps"], &b["rejected"]));
                for column in ["t_end", "theta", "omega"] {
                    let (a, b) = (number(a, column), number(b, column));
                    assert!((a - b).abs() <= 1e-9, "{method} {column}: {a} and {b}");
                    differing += usize::from(a.to_bits() != b.to_bits());
                }
            }
            assert!(differing > 0, "without a difference in the last digits these runs were not made in lanes");
            assert_eq!(text.contains("fast"), lanes.iter().any(|row| row["stop"] == "event:fast"), "{method}");
        }
    }
}

/// Goal: runs that need a reaction, and equations that divide, agree in lanes as well. Method: the disk, whose domain
/// requires a positive normal force and whose speeds fail where it lies flat, from leans some of which leave the plane;
/// compared with single runs. 1e-6: a tolerance of 1e-9, near flat.
#[test]
fn rows_with_a_normal_force_and_with_divisors_are_the_runs_alone() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scene.toml");
    let text = "span = [0, 2]\n[start]\nq1 = 0\nq2 = 0.5\nq3 = 0\nq4 = 0\nq5 = 0\nu1 = 0\nu2 = 0.2\nu3 = 0.1\nu4 = 0\nu5 = 0\n\
                [integration]\nmethod = \"taylor\"\nrtol = 1e-9\natol = 1e-11\n";
    std::fs::write(&path, format!("model = '{}'\n{text}", root().join("models/disk").display())).unwrap();
    let run = |more: &[&str]| {
        let out = folder.path().join("out.csv");
        let over = ["--over", "q2=0.1:1.4:9", "--over", "u1=-9:9:7", "--over", "u2=0,0.2"];
        let line = [
            &["sweep", path.to_str().unwrap(), "--by", "kane", "--overwrite", "--out", out.to_str().unwrap()],
            &over[..],
            more,
        ];
        let output = tripos(&line.concat());
        assert!(
            output.status.code().is_some_and(|code| code == 0 || code == 3),
            "{}",
            String::from_utf8_lossy(&output.stderr)
        );
        rows(&std::fs::read_to_string(out).unwrap())
    };
    let (lanes, alone) = (run(&[]), run(&["--digits"]));
    assert_eq!((lanes.len(), alone.len()), (126, 126));
    let (mut stops, mut differing) = (std::collections::BTreeSet::new(), 0);
    for (a, b) in lanes.iter().zip(&alone) {
        assert_eq!(a["stop"], b["stop"], "{a:?}\n{b:?}");
        stops.insert(a["stop"].clone());
        for column in ["t_end", "q2", "u1", "u3"] {
            let (a, b) = (number(a, column), number(b, column));
            assert!((a - b).abs() <= 1e-6 * (1.0 + b.abs()), "{column}: {a} and {b}");
            differing += usize::from(a.to_bits() != b.to_bits());
        }
    }
    assert!(differing > 0 && stops.len() >= 2, "{stops:?}");
}

/// Goal: a row is the same whichever rows share its registers. Method: shards of sizes that are no multiple of the
/// lanes, with points that cannot start among them.
#[test]
fn rows_in_lanes_do_not_depend_on_their_neighbours() {
    let folder = tempfile::tempdir().unwrap();
    let over = ["--over", "l=-0.2:3:37", "--threads"];
    let whole = sweep(folder.path(), SCENE, &[over.as_slice(), &["2"]].concat());
    assert!(whole.contains("no-start"), "{whole}");
    let mut joined: Vec<String> = whole.lines().take(1).map(str::to_owned).collect();
    for shard in 1..=5 {
        let part = sweep(folder.path(), SCENE, &[over.as_slice(), &["1", "--shard", &format!("{shard}/5")]].concat());
        joined.extend(part.lines().skip(1).map(str::to_owned));
    }
    assert_eq!(whole.lines().collect::<Vec<_>>(), joined);
}
