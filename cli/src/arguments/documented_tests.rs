//! Test that clap accepts every command that the documentation shows.

use super::Arguments;
use clap::Parser;
use std::path::Path;

/// Goal: the documentation shows only options that the command has. Method: each line of the README, of `docs/` and of
/// the tutorials that begins with the command is parsed, as a reader would type it.
#[test]
fn every_command_that_is_documented_is_understood() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let mut pages = vec![root.join("README.md"), root.join("CONTRIBUTING.md")];
    for folder in ["docs", "docs/tutorial"] {
        pages.extend(
            std::fs::read_dir(root.join(folder))
                .unwrap()
                .map(|entry| entry.unwrap().path())
                .filter(|path| path.is_file()),
        );
    }
    pages.retain(|page| page.extension().is_some_and(|end| end == "md"));
    let (mut seen, mut refused) = (0, Vec::new());
    for page in pages {
        let text = std::fs::read_to_string(&page).unwrap();
        for line in text.lines().filter_map(typed) {
            seen += 1;
            if let Err(error) = Arguments::try_parse_from(words(line)) {
                refused.push(format!("{}: {line}\n{error}", page.display()));
            }
        }
    }
    assert!(refused.is_empty(), "{}", refused.join("\n"));
    assert!(seen > 30, "{seen} commands were found");
}

/// Part of a line that a reader types after the name of the program, without a redirection to a file; `None` if the
/// line is no command.
fn typed(line: &str) -> Option<&str> {
    let line = line.split("  #").next()?.split(" > ").next()?.trim();
    let line = line.strip_prefix("$ ").unwrap_or(line).trim();
    let rest = line.strip_prefix("cargo run --release -- ").or_else(|| line.strip_prefix("target/release/tripos "));
    rest.or_else(|| line.strip_prefix("tripos "))
}

/// Words of a command, with its name first. Text between quotes is one word.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut open) = (vec!["tripos".to_owned()], false);
    for (at, part) in line.split('"').enumerate() {
        open = at % 2 == 1;
        if open {
            words.push(part.to_owned());
        } else {
            words.extend(part.split_whitespace().map(str::to_owned));
        }
    }
    assert!(!open, "a quote is left open: {line}");
    words
}
