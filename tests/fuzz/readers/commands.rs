//! Command lines: options, values of `--set` and `--claim`, state files, and saved tables of sweeps.

use crate::campaign::{Answer, Random, Share, campaign, tried};
use crate::grammar::formula;
use crate::mutation::{mutated, spoilt, spoilt_bytes};
use crate::refusal::check_text;
use crate::seeds::{quoted_text, root};
use crate::slider::SLIDER;
use serde_json::Value;
use std::ffi::OsString;
use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;
use tripos_cli::{CommandOutput, interrupt_command, run_command};
use tripos_derive::algebra::text::notation::Notation;
use tripos_derive::plain_text::is_forbidden;

/// Short scene of [`SLIDER`].
pub const SCENE: &str = "model = \"model.toml\"\ntitle = \"Slide\"\nspan = [0, 0.1]\noutputs = [\"x\", \"u\", { name = \"p\", value = \"m*u\" }]\n[start]\nx = 1\nu = 0\n";
/// State of [`SLIDER`].
const STATE: &str = "[state]\nx = 0.5\nu = 1\n";

/// Time after which a command is interrupted, as its user would do.
const LONGEST: Duration = Duration::from_secs(5);

/// Runs a command, and interrupts it if it takes longer than [`LONGEST`].
pub fn run(words: &[String]) -> CommandOutput {
    let (done, waits) = channel::<()>();
    let watch = std::thread::spawn(move || {
        while waits.recv_timeout(LONGEST) == Err(RecvTimeoutError::Timeout) {
            interrupt_command();
        }
    });
    let output = std::panic::catch_unwind(|| run_command(words.iter().map(OsString::from)));
    drop(done);
    watch.join().unwrap();
    output.unwrap_or_else(|panic| std::panic::resume_unwind(panic))
}

/// Checks the answer of a command: a documented status, and a reason if the status says that the input is bad.
pub fn checked(words: &[String], output: &CommandOutput) -> Answer {
    let input = words.join(" ");
    for text in [&output.output, &output.messages] {
        if let Some(c) = text.chars().find(|c| *c != '\n' && is_forbidden(*c)) {
            panic!("an output has a forbidden character {c:?} | {text}");
        }
    }
    let is_help = words.iter().any(|word| ["--help", "-h", "-V", "--version", "help"].contains(&word.as_str()));
    let is_json = words.iter().any(|word| word == "--json") && !is_help && !output.output.is_empty();
    let json: Option<Value> = is_json.then(|| {
        let json = serde_json::from_str(&output.output);
        json.unwrap_or_else(|error| panic!("the output is no JSON | {error}: {}", output.output))
    });
    match output.status {
        0 | 1 | 3 | 130 => Answer::Read,
        2 => {
            let has_reason = json.as_ref().is_some_and(|_| output.output.contains("\"error\""));
            assert!(!output.messages.trim().is_empty() || has_reason, "a refusal without a reason | {input}");
            if let Some(json) = json.filter(|json| json.get("error").is_some()) {
                let error = &json["error"];
                let text = |key: &str| error[key].as_str().unwrap_or_default().to_owned();
                let message = text("message").replace('\n', " ");
                check_text("message", &message, &format!("{input} {}", output.messages));
                assert!(!text("help").is_empty(), "a refusal without a hint | {message}");
            }
            Answer::Refused
        }
        status => panic!("the status is {status} | {input}"),
    }
}

/// Folder with a model, a scene and a state. The program works in it, so that random names of outputs stay inside.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    write_files(folder.path());
    std::env::set_current_dir(folder.path()).unwrap();
    folder
}

/// Writes the files of the commands anew.
fn write_files(folder: &Path) {
    let disk = std::fs::read_to_string(root().join("models/pendulum/model.toml")).unwrap();
    for (name, text) in [("model.toml", SLIDER), ("scene.toml", SCENE), ("state.toml", STATE), ("other.toml", &disk)] {
        std::fs::write(folder.join(name), text).unwrap();
    }
}

/// Commands whose work is short on a small model.
const COMMANDS: [&str; 22] = [
    "derive",
    "check",
    "prove",
    "equilibria",
    "linearise",
    "inverse",
    "identify",
    "fit",
    "excite",
    "diff",
    "grade",
    "schema",
    "completions",
    "man",
    "emit",
    "fmu",
    "evaluate",
    "simulate",
    "plot",
    "scene",
    "sketch",
    "sweep",
];
/// Options of the commands.
const OPTIONS: [&str; 46] = [
    "--json",
    "--by",
    "--set",
    "--method",
    "--project",
    "--solve",
    "--step",
    "--max-step",
    "--rtol",
    "--atol",
    "--samples",
    "--until",
    "--sensitivity",
    "--gradient",
    "--claim",
    "--csv",
    "--overwrite",
    "--strict",
    "--format",
    "--form",
    "--at",
    "--out",
    "--language",
    "--formulation",
    "--with",
    "--functions",
    "--base",
    "--over",
    "--about",
    "--inputs",
    "--outputs",
    "--find-coordinates",
    "--motion",
    "--declared",
    "--also",
    "--certificate",
    "--fmi",
    "--within",
    "--quick",
    "--shard",
    "--resume",
    "--data",
    "--parameters",
    "--help",
    "--",
    "-",
];
/// Values of options and names of files.
const VALUES: [&str; 34] = [
    "model.toml",
    "scene.toml",
    "state.toml",
    "other.toml",
    "nothing.toml",
    ".",
    "",
    "m=2",
    "k=0",
    "x=1..2 in 3",
    "m=1,2",
    "x",
    "u",
    "m",
    "x < 2",
    "u>-1",
    "0",
    "1",
    "-1",
    "1e-6",
    "3",
    "kane",
    "lagrange",
    "printed:1",
    "dop853",
    "rk4",
    "taylor",
    "quadrature",
    "json",
    "latex",
    "python",
    "c",
    "out.svg",
    "out.csv",
];

/// A word of a command line.
fn word(random: &mut Random) -> String {
    let text = match random.below(8) {
        0..3 => (*random.one(&OPTIONS[..])).to_owned(),
        3..6 => (*random.one(&VALUES[..])).to_owned(),
        6 => format!("{}={}", random.one(&OPTIONS[..]), random.one(&VALUES[..])),
        _ => format!("{}={}", ["m", "k", "x", "u", "t"][random.below(5)], formula(Notation::Tripos, 2, random)),
    };
    if random.chance(12) { mutated(&text, quoted_text(random), random) } else { text }
}

/// A random command line.
fn command_line(random: &mut Random) -> Vec<String> {
    let command = if random.chance(97) { (*random.one(&COMMANDS[..])).to_owned() } else { word(random) };
    let mut words = vec![command];
    if random.chance(80) {
        words.push(["model.toml", "scene.toml"][random.below(2)].to_owned());
    }
    for _ in 0..random.below(6) {
        words.push(word(random));
    }
    if random.chance(50) {
        words.push("--json".to_owned());
    }
    // The system passes no word with a NUL.
    words.into_iter().map(|word| word.replace('\0', "").chars().take(300).collect()).collect()
}

#[test]
fn command_lines() {
    let folder = folder();
    campaign("command lines", &Share { short: 400, long: 20_000 }, move |random| {
        let words = command_line(random);
        tried(&words.join(" "));
        let answer = checked(&words, &run(&words));
        if random.chance(10) {
            write_files(folder.path());
        }
        answer
    });
}

#[test]
fn values_of_set_and_claim() {
    let folder = folder();
    campaign("`--set` and `--claim`", &Share { short: 150, long: 8000 }, move |random| {
        let place = |name: &str| folder.path().join(name).display().to_string();
        let value = formula(Notation::Tripos, 2, random);
        let text = match random.below(3) {
            0 => format!("{} {} {value}", random.one(&VALUES[11..14]), ["<", ">", "=", "<="][random.below(4)]),
            _ => format!("{}={value}", ["m", "k", "x", "u"][random.below(4)]),
        };
        let text = if random.chance(40) { spoilt(&text, quoted_text(random), random) } else { text };
        let text = text.replace('\0', "");
        tried(&text);
        let scene = place("scene.toml");
        let words = match random.below(3) {
            0 => vec![
                "simulate".to_owned(),
                scene,
                "--rigorous".to_owned(),
                format!("--claim={text}"),
                "--json".to_owned(),
            ],
            1 => vec!["simulate".to_owned(), scene, format!("--set={text}"), "--json".to_owned()],
            _ => vec!["scene".to_owned(), scene, format!("--set={text}"), "--json".to_owned()],
        };
        checked(&words, &run(&words))
    });
}

#[test]
fn states_of_evaluate() {
    let folder = folder();
    campaign("`evaluate --at`", &Share { short: 200, long: 15_000 }, move |random| {
        let text = spoilt(STATE, quoted_text(random), random);
        tried(&text);
        let place = |name: &str| folder.path().join(name).display().to_string();
        let bytes = if random.chance(80) { text.into_bytes() } else { spoilt_bytes(text.as_bytes(), random) };
        std::fs::write(place("at.toml"), bytes).unwrap();
        let words = [
            "evaluate".to_owned(),
            place("model.toml"),
            "--by=kane".to_owned(),
            "--at".to_owned(),
            place("at.toml"),
            "--json".to_owned(),
        ];
        checked(&words, &run(&words))
    });
}

/// Checks that a resumed table has a row for each point, and numbers in all columns but those of texts.
fn check_table(path: &Path) {
    let mut rows = csv::Reader::from_path(path).unwrap();
    let rows: Vec<csv::StringRecord> =
        rows.records().map(|row| row.unwrap_or_else(|e| panic!("no table | {e}"))).collect();
    assert_eq!(rows.len(), 3, "a resumed table lacks rows");
    for (at, row) in rows.iter().enumerate() {
        assert_eq!(row[0], at.to_string(), "a row of another point");
        let numbers = row.iter().enumerate().filter(|(column, _)| ![3, row.len() - 1].contains(column));
        for (column, cell) in numbers {
            assert!(cell.is_empty() || cell.parse::<f64>().is_ok(), "no number in column {column} | {cell}");
        }
    }
}

#[test]
fn saved_tables_of_sweeps() {
    let folder = folder();
    let place = |name: &str| folder.path().join(name);
    let words = |extra: &[&str]| {
        let table = place("table.csv").display().to_string();
        let fixed = ["sweep", &place("scene.toml").display().to_string(), "--over", "m=1,2,3", "--out", &table]
            .map(str::to_owned);
        fixed.into_iter().chain(extra.iter().map(|word| (*word).to_owned())).collect::<Vec<_>>()
    };
    let begun = run(&words(&[]));
    assert_eq!(begun.status, 0, "{}", begun.messages);
    let whole = std::fs::read(place("table.csv")).unwrap();
    // An unfinished table lies beside its record, which a sweep of the same words writes.
    let names = [place("table.csv.part"), place("table.csv.part.json")];
    let again = words(&["--resume", "--json"]);
    // A sweep refuses the record of another sweep, and says what its own record has.
    std::fs::remove_file(place("table.csv")).unwrap();
    std::fs::write(&names[0], &whole).unwrap();
    std::fs::write(&names[1], "{}").unwrap();
    let refused = run(&again).messages;
    let entries = refused.split('`').collect::<Vec<_>>();
    let entry = |part: &[&str]| {
        let name = part[0].strip_suffix(": ")?;
        let start = name.rfind([';', ':']).map_or(0, |at| at + 2);
        Some((name[start..].to_owned(), part[3].trim_matches('"').into()))
    };
    let record: serde_json::Map<String, Value> =
        entries[2..].windows(4).filter(|w| w[1] == "nothing").filter_map(entry).collect();
    assert!(record.len() > 8, "{refused}");
    let record = Value::Object(record).to_string();
    let folder_path = folder.path().to_owned();
    campaign("saved tables of sweeps", &Share { short: 60, long: 4000 }, move |random| {
        let _keeps = &folder;
        let cut = random.below(whole.len() + 1);
        let part = if random.chance(80) { spoilt_bytes(&whole, random) } else { whole[..cut].to_vec() };
        let record = if random.chance(20) { spoilt(&record, quoted_text(random), random) } else { record.clone() };
        tried(&String::from_utf8_lossy(&part));
        std::fs::write(&names[0], &part).unwrap();
        std::fs::write(&names[1], record).unwrap();
        let _ = std::fs::remove_file(folder_path.join("table.csv"));
        let output = run(&again);
        let answer = checked(&again, &output);
        if answer == Answer::Read {
            check_table(&folder_path.join("table.csv"));
        }
        answer
    });
}
