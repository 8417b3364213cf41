//! Hostile sizes: an answer within seconds, never a crash.

#![allow(clippy::format_collect, reason = "texts built once, for a test")]

use crate::common;

use common::{BASE, errors, read};
use rustix::time::{ClockId, clock_gettime};
use std::time::Duration;
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::mechanics::accelerations;
use tripos_derive::{Formulation, derive};

/// Far below the 10 s that are promised, since tests may run unoptimized.
const PATIENCE: Duration = Duration::from_secs(8);

/// The processor time of this thread from here on: what else a machine has to do does not count.
struct Start(Duration);

impl Start {
    fn now() -> Self {
        let time = clock_gettime(ClockId::ThreadCPUTime);
        let parts = (u64::try_from(time.tv_sec), u32::try_from(time.tv_nsec));
        let (Ok(seconds), Ok(nanoseconds)) = parts else { panic!("a clock before its start") };
        Self(Duration::new(seconds, nanoseconds))
    }

    fn elapsed(&self) -> Duration {
        Self::now().0.saturating_sub(self.0)
    }
}

fn with_length(formula: &str) -> String {
    BASE.replace("-length", formula)
}

fn refused(text: &str) -> String {
    let start = Start::now();
    let all = errors(text).to_string();
    assert!(start.elapsed() < PATIENCE, "took {:?}", start.elapsed());
    assert!(all.len() < 20_000, "{} characters of errors", all.len());
    all
}

#[test]
fn deep_nesting_is_refused_with_its_place() {
    let n = 100_000;
    for formula in [
        format!("{}length{}", "(".repeat(n), ")".repeat(n)),
        format!("length*{}q{}", "sin(".repeat(n), ")".repeat(n)),
        format!("length*{}", "q^".repeat(n)),
    ] {
        let all = refused(&with_length(&formula));
        assert!(all.contains("nesting deeper than 200") && all.contains("model.toml:26:"), "{all}");
    }
    for text in [format!("a = {}", "[".repeat(n)), format!("a = {}", "{a=".repeat(n)), format!("[{}a]", "a.".repeat(n))]
    {
        assert!(refused(&text).contains("model.toml:1:"));
    }
}

#[test]
fn a_hundred_thousand_signs_and_a_million_terms_are_read() {
    let start = Start::now();
    let sum = vec!["length"; 500_000].join("+");
    for formula in [format!("{}length", "-".repeat(100_001)), sum] {
        let model = read(&with_length(&formula)).unwrap_or_else(|e| panic!("{e}"));
        derive(&model, Formulation::Kane).expect("an ordinary mechanism");
    }
    assert!(start.elapsed() < PATIENCE, "took {:?}", start.elapsed());
}

#[test]
fn an_error_behind_a_million_terms_keeps_its_column() {
    let all = refused(&with_length(&format!("{}k", "g+".repeat(1_000_000))));
    assert!(all.contains("model.toml:26:2000048"), "{all}");
}

#[test]
fn numbers_that_would_grow_without_bound_are_refused() {
    let harmonic: Vec<String> = (1..100_000).map(|k| format!("length/{k}")).collect();
    let thousand: Vec<String> = (1..=1000).map(|k| format!("length/{k}")).collect();
    read(&with_length(&thousand.join("+"))).unwrap_or_else(|e| panic!("{e}"));
    for formula in [
        harmonic.join("+"),
        format!("length*({})", vec!["1e4000"; 100_000].join("+")),
        format!("length*{}", vec!["9"; 1_000_000].join("*")),
    ] {
        assert!(refused(&with_length(&formula)).contains("grow too large"));
    }
    assert!(refused(&with_length(&format!("length*{}", "9".repeat(1_000_000)))).contains("more than 4000 digits"));
    assert!(refused(&BASE.replace("9.81", &"9".repeat(1_000_000))).contains("more than 4000 digits"));
}

#[test]
fn long_names_and_many_entries_are_refused() {
    assert!(refused(&BASE.replace("I = {", &format!("{} = {{", "I".repeat(1_000_000)))).contains("cannot be a name"));
    assert!(refused(&with_length(&"l".repeat(1_000_000))).contains("unknown name"));
    let points: String =
        (0..20_000).map(|i| format!("P{i} = {{ from = \"O\", frame = \"N\", position = [0, 0, 0] }}\n")).collect();
    assert!(refused(&BASE.replace("[points]\n", &format!("[points]\n{points}"))).contains("more than 5000"));
    let forces: String = (0..100_000).map(|i| format!("f{i} = 3\n")).collect();
    assert!(refused(&format!("{BASE}[forces]\n{forces}")).contains("more errors"));
}

#[test]
fn a_long_chain_stated_backwards_is_put_in_order() {
    let chain: String = (0..900)
        .map(|i| {
            format!(
                "F{i} = {{ from = \"{}\", axis = 3, angle = 0 }}\n",
                if i < 899 { format!("F{}", i + 1) } else { "N".into() }
            )
        })
        .collect();
    let model = read(&BASE.replace("[frames]\n", &format!("[frames]\n{chain}"))).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(model.frames.len(), 902);
    for (at, frame) in model.frames.iter().enumerate() {
        assert!(frame.rotation.as_ref().is_none_or(|(parent, _)| *parent < at), "parents come first");
    }
}

fn file_error(name: &str, bytes: &[u8]) -> Diagnostics {
    let path = std::env::temp_dir().join(format!("tripos-limits-{}-{name}", std::process::id()));
    std::fs::write(&path, bytes).expect("a writable temporary folder");
    let result = Source::read(&path);
    std::fs::remove_file(&path).expect("just written");
    result.expect_err(name)
}

#[test]
fn files_that_are_not_text_are_refused_with_the_place() {
    for (name, bytes, message, place) in [
        ("latin1.toml", &b"name = \"a\"\nangle = \"10 \xb0\"\n"[..], "not UTF-8", ":2:13"),
        ("nul.toml", &b"name = \"a\"\n\0"[..], "NUL byte", ":2:1"),
        ("utf16.toml", &b"\xff\xfen\0a\0"[..], "UTF-16", ":1:1"),
    ] {
        let all = file_error(name, bytes).to_string();
        assert!(all.contains(message) && all.contains(&format!("{name}{place}\n")) && all.contains("help: "), "{all}");
    }
    assert!(file_error("big.toml", &vec![b'#'; 5 << 20]).to_string().contains("larger than"));
}

#[test]
fn what_is_no_regular_file_is_refused() {
    assert!(Source::read(&std::env::temp_dir()).expect_err("a folder").to_string().contains("this is a folder"));
    let absent = std::env::temp_dir().join("tripos-no-such-file.toml");
    assert!(Source::read(&absent).expect_err("absent").to_string().contains("tripos-no-such-file.toml"));
}

#[cfg(unix)]
#[test]
fn devices_and_pipes_are_refused_without_reading() {
    let all = Source::read("/dev/zero".as_ref()).expect_err("a device").to_string();
    assert!(all.contains("not a regular file"), "{all}");
    let path = std::env::temp_dir().join(format!("tripos-fifo-{}", std::process::id()));
    if std::process::Command::new("mkfifo").arg(&path).status().is_ok_and(|s| s.success()) {
        let all = Source::read(&path).expect_err("a pipe").to_string();
        std::fs::remove_file(&path).expect("just made");
        assert!(all.contains("not a regular file"), "{all}");
    }
}

/// Goal: the cost of a product grows at most with the square of its number of factors. Method: a product of 299 sines
/// of sums, in which the search for common products took minutes; its equations and accelerations are found.
#[test]
fn a_product_of_hundreds_of_sines_is_derived() {
    let start = Start::now();
    let sines: String = (1..300).map(|k| format!("*sin({k}*q + x/length)")).collect();
    let force = format!("[forces.f]\non = \"rod\"\nframe = \"N\"\nvector = [\"m*g{sines}\", 0, 0]\n");
    let model = read(&format!("{BASE}{force}")).unwrap_or_else(|e| panic!("{e}"));
    let mut derivation = derive(&model, Formulation::Kane).expect("an ordinary mechanism");
    let solved = accelerations(&mut derivation.arena, &mut Simplifier::default(), &derivation.equations).unwrap();
    assert!(solved.steps.len() >= 2 && start.elapsed() < PATIENCE, "took {:?}", start.elapsed());
}
