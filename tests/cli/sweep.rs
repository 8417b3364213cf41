//! Sweeps: rows are runs, files do not depend on how they were made, and no input breaks one.

use crate::support::{command, root, status, stderr, tripos};
use expect_test::expect;
use std::path::Path;
use std::process::Stdio;
use std::time::Duration;

const REPORT: &str = "models/disk/scenes/report-10s.toml";

fn text_of(path: impl AsRef<Path>) -> String {
    std::fs::read_to_string(path).unwrap()
}

/// A sweep's table, whatever its exit status, which is checked.
fn sweep(expected: i32, scene: &str, arguments: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.csv");
    let output = tripos(&[&["sweep", scene, "--out", out.to_str().unwrap()], arguments].concat());
    assert_eq!(status(&output), expected, "{}", stderr(&output));
    let files: Vec<_> = std::fs::read_dir(folder.path()).unwrap().collect();
    assert_eq!(files.len(), 1, "nothing is left beside the table");
    text_of(out)
}

/// A table by the names of its columns.
fn table(text: &str) -> Vec<std::collections::HashMap<String, String>> {
    csv::Reader::from_reader(text.as_bytes()).deserialize().map(Result::unwrap).collect()
}

/// A scene in a folder, for a model of the workspace.
fn scene(folder: &Path, model: &str, text: &str) -> String {
    let path = folder.join("scene.toml");
    std::fs::write(&path, format!("model = '{}'\n{text}", root().join(model).display())).unwrap();
    path.to_str().unwrap().to_owned()
}

/// Holds rows of a sweep against `simulate` of the same scene with the numbers of each row written into its text, to
/// the bit. `edit` writes the numbers that it is given.
fn rows_are_runs(
    model: &str,
    text: &str,
    over: &[&str],
    more: &[&str],
    rows: &[usize],
    edit: &dyn Fn(&str, &[String]) -> String,
) {
    let axes: Vec<&str> = over.iter().flat_map(|axis| ["--over", axis]).collect();
    let swept: Vec<String> = over.iter().map(|axis| format!("over:{}", axis.split('=').next().unwrap())).collect();
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.csv");
    let path = scene(folder.path(), model, text);
    tripos(&[&["sweep", &path, "--out", out.to_str().unwrap()], axes.as_slice(), more].concat());
    let table = table(&text_of(&out));
    for row in rows.iter().map(|at| &table[*at]) {
        let values: Vec<String> = swept.iter().map(|name| row[name].clone()).collect();
        let path = scene(folder.path(), model, &edit(text, &values));
        let run = tripos(&[&["simulate", &path, "--json"], more].concat());
        let json: serde_json::Value =
            serde_json::from_slice(&run.stdout).unwrap_or_else(|_| panic!("{}", stderr(&run)));
        for name in ["steps", "rejected"] {
            assert_eq!(row[name], json[name].to_string(), "{name} of {values:?}");
        }
        assert_eq!(row["stop"], json["stop"].as_str().unwrap());
        assert_eq!(row["reason"].is_empty(), status(&run) == 0);
        // Not the parsed JSON: its reader may miss the last bit of a double.
        let text = String::from_utf8(run.stdout.clone()).unwrap();
        let same = |name: &str, column: &str| {
            let key = format!("\"{name}\": ");
            let line = text.lines().find_map(|line| line.trim().strip_prefix(&key)).unwrap();
            let bits = |text: &str| text.parse::<f64>().unwrap().to_bits();
            assert_eq!(bits(line.trim_end_matches(',')), bits(&row[column]), "{name} of {values:?}");
        };
        same("t", "t_end");
        json["state"].as_object().unwrap().keys().for_each(|name| same(name, name));
    }
}

/// The text with the line that states `name` saying another value.
fn stating(text: &str, name: &str, value: &str) -> String {
    let mut found = 0;
    let state = |line: &str| {
        let matches = line.split('=').next().is_some_and(|key| key.trim() == name);
        found += usize::from(matches);
        if matches { format!("{name} = {value}\n") } else { format!("{line}\n") }
    };
    let text: String = text.lines().map(state).collect();
    assert_eq!(found, 1, "{name}");
    text
}

/// Goal: rows of the disk are those of `simulate`. Method: compiled equations with a domain: some of these starts leave
/// it at once, some later, some never. The methods do not run in lanes, where rows agree to rounding
/// (`sweep_lanes.rs`).
#[test]
fn rows_of_the_disk_are_what_simulate_gives() {
    let edit = |text: &str, values: &[String]| {
        let text = stating(text, "q2", &values[0]);
        let text = stating(&text, "g", &values[1]);
        stating(&text, "\"q2'\"", &values[2])
    };
    let over = ["q2=0.03:1.6:4", "g=1.62,9.81", "q2'=-9:1:2"];
    let more = ["--by", "kane", "--method", "dopri5", "--rtol", "1e-6", "--until", "2"];
    let text = text_of(root().join(REPORT));
    let disk = "models/disk/model.toml";
    rows_are_runs(disk, &text, &over, &more, &[0, 3, 6, 9, 15], &edit);
    // By the scene's reduced equations, in the distance from each of the two flat poses.
    let own = [&more[2..], &["--atol", "1e-8"]].concat();
    rows_are_runs(disk, &text, &["q2=-1.55:1.6:4", "q2'=-0.1:1:2"], &own, &[0, 1, 2, 5, 6], &|text, values| {
        stating(&stating(text, "q2", &values[0]), "\"q2'\"", &values[1])
    });
    // The scene's own method, its own tolerances, and the other formulations with the other solve.
    rows_are_runs(disk, &text, &over, &["--until", "1", "--by", "lagrange"], &[1, 8], &edit);
    rows_are_runs(disk, &text, &over, &["--until", "1", "--by", "newton-euler", "--solve", "numeric"], &[5], &edit);
}

/// Goal: runs in sweeps are kept on their constraints as single runs are. Method: the norm of Euler parameters, whose
/// equations divide by nothing and were once swept in lanes, which lost 3e-7 of it at these tolerances.
#[test]
fn rows_of_a_mechanism_with_constraints_are_kept_on_them() {
    let edit = |text: &str, values: &[String]| stating(text, "w1", &values[0]);
    let text = text_of(root().join("models/satellite/scenes/spin_up.toml"));
    let more = ["--method", "dop853", "--rtol", "1e-6", "--atol", "1e-8", "--until", "20"];
    rows_are_runs("models/satellite/model.toml", text.as_str(), &["w1=0.1:0.3:3"], &more, &[0, 2], &edit);
}

/// A model of the user's own, interpreted, with a terminal event, a distance, samples, and formulas that follow the
/// swept parameter.
#[test]
fn rows_of_an_interpreted_model_are_what_simulate_gives() {
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("model.toml");
    std::fs::write(&model, format!("# another text\n{}", text_of(root().join("models/pendulum/model.toml")))).unwrap();
    let text = "span = [0, \"5*sqrt(l/g)\"]\n[parameters]\nl = 1\n[start]\ntheta = 0.5\n\
                omega = \"1.01*2*sqrt(g/l)\"\n[integration]\nsamples = 17\ndistance = { theta = \"180*deg\" }\n\
                [[events]]\nname = \"top\"\nzero = \"cos(theta/2)\"\nterminal = true\n";
    let edit = |text: &str, values: &[String]| stating(&stating(text, "l", &values[0]), "theta", &values[1]);
    let over = ["l=0.1:10:3:log", "theta=0.25,3,-4"];
    rows_are_runs(model.to_str().unwrap(), text, &over, &["--by", "kane"], &[0, 1, 2, 4, 5, 8], &edit);
}

/// Goal: a file depends on the grid alone. Method: whole and in shards, by one thread and by several, byte for byte;
/// some of the points have no run.
#[test]
fn shards_one_after_another_are_the_whole_file() {
    let grid = ["--over", "M=-1:2:4", "--over", "q2=0.1:1.7:9", "--until", "0.5"];
    let whole = sweep(3, REPORT, &grid);
    assert_eq!(whole.lines().count(), 37);
    assert_eq!(sweep(3, REPORT, &[&grid[..], &["--threads", "1"]].concat()), whole);
    assert_eq!(sweep(3, REPORT, &[&grid[..], &["--threads", "5"]].concat()), whole);
    let (header, _) = whole.split_at(whole.find('\n').unwrap() + 1);
    for of in [2, 5, 40] {
        let mut joined = header.to_owned();
        for part in 1..=of {
            let folder = tempfile::tempdir().unwrap();
            let out = folder.path().join("part.csv");
            let shard = format!("{part}/{of}");
            let own = ["sweep", REPORT, "--shard", &shard, "--out", out.to_str().unwrap()];
            tripos(&[&own[..], &grid].concat());
            let text = text_of(out);
            joined.push_str(text.strip_prefix(header).expect("every part has the header"));
        }
        assert_eq!(joined, whole, "in {of} parts");
    }
}

/// Goal: each row states its outcome, for points of every kind.
#[test]
fn a_point_without_an_answer_is_a_row_with_its_reason() {
    let rows = table(&sweep(3, REPORT, &["--over", "M=-1,0,1", "--over", "q2=0.5,2", "--until", "0.25"]));
    let column = |name: &str| rows.iter().map(|row| row[name].as_str()).collect::<Vec<&str>>();
    assert_eq!(column("index"), ["0", "1", "2", "3", "4", "5"]);
    assert_eq!(column("over:M"), ["-1", "-1", "0", "0", "1", "1"]);
    assert_eq!(column("stop")[..5], ["no-start", "no-start", "no-start", "no-start", "end"]);
    assert_eq!(column("stop")[5], "domain:upright (abs(q2) < pi/2)");
    assert_eq!(column("t_end"), ["", "", "", "", "0.25", "0"]);
    assert_eq!(column("reason")[2], "`M` is stated to be positive but is 0");
    assert_eq!(column("reason")[4..], ["", ""]);
    let run = |step: &str| {
        let folder = tempfile::tempdir().unwrap();
        let text = text_of(root().join(REPORT)).replace("rtol = 1e-3", &format!("rtol = 1e-3\nstep_limit = {step}"));
        let rows = table(&sweep(3, &scene(folder.path(), "models/disk/model.toml", &text), &["--over", "q2=0.5,0.6"]));
        let count = |name: &str| rows[1][name].parse::<u64>().unwrap();
        (rows[1]["stop"].clone(), count("steps") + count("rejected"), rows[1]["reason"].clone())
    };
    assert_eq!(run("7"), ("step-limit".into(), 7, "the limit of 7 steps is used up".into()));
    // Where the disk lies flat, exactly in the distance from there: q1' = u2/cos(q2) has no value, so that Lagrange's
    // equations have no start, Kane's no first step.
    let folder = tempfile::tempdir().unwrap();
    let distance = "[integration]\ndistance = { q2 = \"90*deg\" }";
    let text = text_of(root().join("models/disk/scenes/report.toml")).replace("[integration]", distance);
    let path = scene(folder.path(), "models/disk/model.toml", &text);
    for (by, stop, reason) in
        [("lagrange", "no-start", "the run cannot start"), ("kane", "not-finite", "is not finite")]
    {
        let rows = table(&sweep(3, &path, &["--over", "q2=90*deg,1", "--by", by]));
        assert_eq!((rows[0]["stop"].as_str(), rows[1]["stop"].as_str()), (stop, "end"));
        assert!(rows[0]["reason"].contains(reason), "{}", rows[0]["reason"]);
    }
}

#[test]
fn the_summary_counts_how_rows_ended() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.csv");
    let out = out.to_str().unwrap();
    let grid = ["--over", "M=0:2:3", "--over", "q2=0.5,2", "--until", "0.25", "--by", "kane"];
    let output = tripos(&[&["sweep", REPORT, "--json", "--threads", "2", "--out", out], &grid[..]].concat());
    assert_eq!(status(&output), 3);
    let mut json: serde_json::Value =
        serde_json::from_slice(&output.stdout).expect("standard output is the JSON alone");
    assert!(json["seconds"].as_f64().unwrap() > 0.0);
    json["seconds"] = 0.into();
    expect![[r#"
        {
          "schema": 1,
          "model": "disk",
          "formulation": "kane",
          "method": "ode45",
          "solve": "eliminated",
          "compiled": true,
          "notes": [],
          "over": [
            "M",
            "q2"
          ],
          "points": 6,
          "shard": {
            "part": 1,
            "of": 1,
            "first": 0,
            "rows": 6,
            "kept": 0
          },
          "stops": {
            "domain:upright (abs(q2) < pi/2)": {
              "rows": 2
            },
            "end": {
              "rows": 2
            },
            "no-start": {
              "rows": 2,
              "first": 0,
              "reason": "`M` is stated to be positive but is 0"
            }
          },
          "failed": 2,
          "warned": 0,
          "threads": 2,
          "seconds": 0,
          "out": "OUT"
        }
    "#]]
    .assert_eq(&format!("{json:#}\n").replace(out, "OUT"));
    let output = tripos(&[&["sweep", REPORT, "--overwrite", "--shard", "2/2", "--out", out], &grid[..]].concat());
    assert_eq!((status(&output), output.stdout.len()), (0, 0));
    let text = stderr(&output);
    assert!(text.contains("3 points (part 2 of 2, from point 3) of 6 in "), "{text}");
    assert!(text.contains("\n  2 domain:upright (abs(q2) < pi/2)\n  1 end\n"), "{text}");
}

/// Energy and momenta that a sweep says are constant: to the tolerances, for each row.
#[test]
fn what_is_conserved_changes_little() {
    let tight = ["--method", "dop853", "--rtol", "1e-12", "--atol", "1e-12", "--until", "1", "--over", "q2=0.1:1.2:5"];
    let text = sweep(0, REPORT, &tight);
    let names: Vec<&str> =
        text.lines().next().unwrap().split(',').filter(|name| name.starts_with("change of ")).collect();
    assert!(names.len() >= 5 && names[0] == "change of energy T + V", "{names:?}");
    for row in table(&text) {
        for name in &names {
            // 1e4 times the allowance of a step, as runs are judged, of quantities near 10.
            let change: f64 = row[*name].parse().unwrap();
            assert!(change < 1e-7, "{name}: {change:e}");
        }
    }
    let loose = table(&sweep(0, REPORT, &["--rtol", "1e-1", "--over", "q2=0.0349"]));
    assert!(loose[0]["change of energy T + V"].parse::<f64>().unwrap() > 1e-3, "what is not kept is seen");
}

/// Goal: a row whose numbers are wrong says so, and no other row does. Method: the report's own tolerances, by which
/// all rows lose their energy before ten seconds, and tight ones; `simulate` has such an objection at one point.
#[test]
fn rows_that_cannot_be_trusted_have_a_warning() {
    let grid = ["--over", "q2=0.1:1.4:8"];
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.csv");
    let json = |more: &[&str]| {
        let arguments = [&["sweep", REPORT, "--json", "--overwrite", "--out", out.to_str().unwrap()], &grid[..], more];
        let output = tripos(&arguments.concat());
        assert_eq!(status(&output), 0, "{}", stderr(&output));
        let text = stderr(&output);
        (serde_json::from_slice::<serde_json::Value>(&output.stdout).unwrap()["warned"].as_u64().unwrap(), text)
    };
    let (warned, text) = json(&[]);
    assert!(warned == 8 && text.contains("warning: some runs cannot be trusted"), "{warned}: {text}");
    let rows = table(&text_of(&out));
    for row in &rows {
        assert!(row["warning"].contains("energy") && row["warning"].contains("constant in this motion"), "{row:?}");
    }
    let start = format!("q2 = {}", rows[1]["over:q2"]);
    let single = text_of(root().join(REPORT)).replace("q2 = \"2*deg\"", &start);
    let single = scene(folder.path(), "models/disk/model.toml", &single);
    let run = tripos(&["simulate", &single, "--by", "kane"]);
    assert!(stderr(&run).contains("constant in this motion"), "{}", stderr(&run));
    let (warned, text) = json(&["--rtol", "1e-10", "--atol", "1e-12"]);
    assert!(warned == 0 && !text.contains("warning:"), "{warned}: {text}");
    assert!(table(&text_of(&out)).iter().all(|row| row["warning"].is_empty()));
    // Few digits, by a second run of each point.
    let digits = ["--digits", "--rtol", "1e-4", "--atol", "1e-6", "--by", "kane"];
    let (warned, _) = json(&digits);
    let few =
        table(&text_of(&out)).into_iter().filter(|row| row["digits"].parse().is_ok_and(|digits: f64| digits < 3.0));
    let few: Vec<_> = few.collect();
    assert!(!few.is_empty() && warned >= few.len() as u64, "{warned} of {few:?}");
    assert!(few.iter().all(|row| row["warning"].contains("fewer than three digits")), "{few:?}");
}

#[test]
fn wrong_requests_are_refused_before_anything_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.csv");
    let refused = |arguments: &[&str]| {
        let output = tripos(&[&["sweep", REPORT, "--out", out.to_str().unwrap()], arguments].concat());
        assert_eq!(status(&output), 2, "{arguments:?}");
        assert!(
            output.stdout.is_empty() && std::fs::read_dir(folder.path()).unwrap().next().is_none(),
            "{arguments:?}"
        );
        stderr(&output)
    };
    expect![[r"
        error: `0` is no number of values
         --> --over:1:8
          |
        1 | q2=0:1:0
          |        ^
          |
          = help: write a whole number from 1 to 1000000000

        error: the scene has no parameter or start value `q7`
         --> --over:1:1
          |
        1 | q7=1,2
          | ^^
          |
          = help: did you mean `q1`?

        error: the start of the scene states every q', from which `u1` follows
         --> --over:1:1
          |
        1 | u1=1
          | ^^
          |
          = help: sweep the stated values, or state `u1` and values like it in [start]

        error: `z` follows from the constraint `plane`
         --> --over:1:1
          |
        1 | z=1
          | ^
          |
          = help: vary coordinates, rates and speeds that no constraint fixes

        error: `M` is swept twice
         --> --over:1:1
          |
        1 | M=2
          | ^
          |
          = help: give all its values at once, as a list NAME=a,b,c if need be
    "]]
    .assert_eq(&refused(&["q2=0:1:0", "q7=1,2", "u1=1", "z=1", "M=1", "M=2"].map(|axis| ["--over", axis]).concat()));
    let one = ["--over", "q2=0.1,0.2"];
    for (more, needle) in [
        (&["--shard", "3/2"][..], "there is no part 3 of 2"),
        (&["--shard", "x"], "the shard is `x`"),
        (&["--threads", "0"], "--threads is 0"),
        (&["--method", "rk5"], "did you mean `rk4`?"),
        (&["--method", "rk4"], "give it a fixed `step`"),
        (&["--by", "printed:kane-final", "--solve", "eliminated"], "are not eliminated"),
        (&["--rtol", "nan"], "rtol is NaN"),
        (&["--over", "M=1:2:1000000000"], "the grid has 2000000000 points, more than 1000000000"),
    ] {
        let message = refused(&[&one[..], more].concat());
        assert!(message.contains(needle), "{more:?}: {message}");
        assert!(message.contains("help") || needle.contains("fixed"), "{message}");
    }
}

#[test]
fn a_file_that_is_there_is_not_lost() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.csv");
    std::fs::write(&out, "precious").unwrap();
    let arguments = ["sweep", REPORT, "--over", "q2=0.1", "--until", "0.1", "--out", out.to_str().unwrap()];
    let output = tripos(&arguments);
    assert_eq!((status(&output), text_of(&out).as_str()), (2, "precious"));
    assert!(stderr(&output).contains("is there already") && stderr(&output).contains("--overwrite"));
    let output = tripos(&[&arguments[..], &["--overwrite"]].concat());
    assert_eq!(status(&output), 0, "{}", stderr(&output));
    assert_eq!(text_of(&out).lines().count(), 2);
    let output = tripos(&[&arguments[..7], &["no/such/folder/x.csv"]].concat());
    assert_eq!(status(&output), 2);
    assert!(stderr(&output).contains("cannot write `no/such/folder/x.csv`"), "{}", stderr(&output));
    if Path::new("/dev/full").exists() {
        let output = tripos(&[&arguments[..7], &["/dev/full"]].concat());
        assert_eq!(status(&output), 2);
        assert!(stderr(&output).contains("cannot write `/dev/full`"), "{}", stderr(&output));
    }
}

/// A sweep that is killed leaves no file of the name, only its part, which the next one starts anew; while it lives, no
/// other writes the same.
#[test]
fn an_interrupted_sweep_leaves_no_file_that_looks_whole() {
    let folder = tempfile::tempdir().unwrap();
    let (out, part) = (folder.path().join("out.csv"), folder.path().join("out.csv.part"));
    let arguments = ["sweep", REPORT, "--until", "0.5", "--out", out.to_str().unwrap(), "--over"];
    let mut long = command(&root(), &[&arguments[..], &["q2=0.1:1:1000000000"]].concat());
    let mut long = long.stderr(Stdio::null()).spawn().unwrap();
    let rows = || std::fs::read_to_string(&part).map_or(0, |text| text.lines().count());
    while rows() < 10 {
        assert!(long.try_wait().unwrap().is_none(), "it has a billion points to run");
        std::thread::sleep(Duration::from_millis(20));
    }
    let output = tripos(&[&arguments[..], &["q2=0.1:1:3"]].concat());
    let other = (status(&output), stderr(&output));
    long.kill().unwrap();
    long.wait().unwrap();
    assert!(other.0 == 2 && other.1.contains("another command is writing"), "{other:?}");
    assert!(!out.exists() && rows() >= 10);
    let output = tripos(&[&arguments[..], &["q2=0.1:1:3"]].concat());
    assert_eq!((status(&output), text_of(&out).lines().count()), (0, 4), "{}", stderr(&output));
    assert!(!part.exists());
}

#[test]
fn no_two_columns_have_one_name() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["steps", "stop", "index", "over:g"] {
        let text = format!(
            "span = [0, 1]\noutputs = [{{ name = \"{name}\", value = \"theta\" }}]\n[start]\ntheta = 1\nomega = 0\n"
        );
        let path = scene(folder.path(), "models/pendulum", &text);
        let out = folder.path().join("out.csv");
        let output = tripos(&["sweep", &path, "--over", "g=1,2", "--out", out.to_str().unwrap()]);
        assert!(
            status(&output) == 2 && stderr(&output).contains(&format!("would be called `{name}`")),
            "{}",
            stderr(&output)
        );
        assert!(!out.exists());
    }
}

/// Goal: a row tells as many digits as a run of its scene. Method: at loose tolerances, where digits differ from point
/// to point, each row beside `simulate`.
#[test]
fn the_digits_of_a_row_are_those_of_its_run() {
    let text = |theta: &str| {
        format!("span = [0, 20]\n[start]\ntheta = {theta}\nomega = 0\n[integration]\nmethod = \"ode45\"\nrtol = 1e-5\n")
    };
    let folder = tempfile::tempdir().unwrap();
    let path = scene(folder.path(), "models/pendulum", &text("1"));
    let rows = table(&sweep(0, &path, &["--over", "theta=0.3,2,3.1", "--digits"]));
    let mut seen = Vec::new();
    for row in &rows {
        let path = scene(folder.path(), "models/pendulum", &text(&row["over:theta"]));
        let run = tripos(&["simulate", &path, "--json"]);
        let json: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
        assert_eq!(row["digits"], format!("{:.1}", json["digits"].as_f64().unwrap()));
        seen.push(row["digits"].clone());
    }
    seen.dedup();
    assert_eq!(seen.len(), 3, "{seen:?}");
    assert!(!table(&sweep(0, &path, &["--over", "theta=2"]))[0].contains_key("digits"));
}
