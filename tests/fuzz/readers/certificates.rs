//! Certificates of proofs, which a checker in Python reads.

use super::commands::run;
use crate::campaign::{Answer, Random, Share, campaign, tried};
use crate::mutation::{spoilt, spoilt_bytes};
use crate::seeds::{quoted_text, root};
use crate::slider::SLIDER;
use std::path::Path;
use std::process::Command;

/// Number of certificates that one process of Python checks.
const BATCH: usize = 200;

/// Text of a certificate of a small model.
fn certificate(folder: &Path) -> String {
    std::fs::write(folder.join("model.toml"), SLIDER).unwrap();
    let place = |name: &str| folder.join(name).display().to_string();
    let words = ["prove".to_owned(), place("model.toml"), "--certificate".to_owned(), place("proof.cert")];
    let output = run(&words);
    assert_eq!(output.status, 0, "{}", output.messages);
    std::fs::read_to_string(place("proof.cert")).unwrap()
}

/// Writes spoilt certificates, and lets the checker read them. Returns the number of refused ones.
fn checked_batch(certificate: &str, folder: &Path, count: usize, random: &mut Random) -> u64 {
    let _ = std::fs::remove_dir_all(folder);
    std::fs::create_dir_all(folder).unwrap();
    for at in 0..count {
        let bytes = if random.chance(85) {
            spoilt(certificate, quoted_text(random), random).into_bytes()
        } else {
            spoilt_bytes(certificate.as_bytes(), random)
        };
        std::fs::write(folder.join(format!("{at:04}.cert")), bytes).unwrap();
    }
    let script = root().join("tests/fuzz/certificates.py");
    let output =
        Command::new("python3").arg(script).arg(root().join("tests/certificate")).arg(folder).output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let (counts, wrong) = text.split_once('\n').unwrap_or((&text, ""));
    let wrong = wrong.trim();
    if !wrong.is_empty() || counts.is_empty() {
        tried(wrong);
        panic!("the checker of certificates fails | {wrong} {}", String::from_utf8_lossy(&output.stderr));
    }
    counts.split(' ').nth(1).and_then(|n| n.parse().ok()).unwrap()
}

#[test]
fn certificates() {
    if Command::new("python3").args(["-c", "import tomllib"]).output().is_ok_and(|output| output.status.success()) {
        let folder = tempfile::tempdir().unwrap();
        let text = certificate(folder.path());
        // A case is a batch, so that Python starts once for many certificates.
        campaign("certificates, 200 in a case", &Share { short: 1, long: 30 }, move |random| {
            let refused = checked_batch(&text, &folder.path().join("batch"), BATCH, random);
            if usize::try_from(refused).is_ok_and(|refused| refused == BATCH) { Answer::Refused } else { Answer::Read }
        });
    } else {
        eprintln!("certificates are not fuzzed: there is no Python 3.11");
    }
}
