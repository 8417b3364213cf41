//! Tutorials are carried out as a reader would: their files are written, their commands run, and the shown output
//! compared.
//!
//! The first line of a block gives its kind. "```toml cart/model.toml" is that file; `more` after its name means the
//! rest of a file that exists already. "```console" are commands after `$ ` with lines of their output, in order; `…`
//! stands for omitted lines, or for an omitted part of one. Other blocks are for reading, and none of them may be a
//! command.

use crate::support::{root, tripos_in};
use std::path::Path;

#[test]
fn the_disk_from_nothing() {
    carry_out("disk");
}

#[test]
fn a_mechanism_of_your_own() {
    carry_out("mechanism");
}

#[test]
fn a_controller_in_twenty_minutes() {
    carry_out("control");
}

#[test]
fn three_homeworks_graded() {
    carry_out("grading");
}

/// Goal: no command shown in the documentation has been forgotten by the program. Method: clap reads each of them,
/// beside `cli/src/arguments.rs`; here, the models and scenes that they name must exist.
#[test]
fn the_documentation_names_files_that_exist() {
    let mut missing = Vec::new();
    for (page, text) in pages() {
        let named =
            text.lines().filter(|line| line.contains("tripos ")).flat_map(|line| line.split([' ', '`', ')', '\'']));
        for name in named.filter(|name| name.starts_with("models/") && !name.contains(['*', '…', '{', '(', 'N'])) {
            if !root().join(name).exists() {
                missing.push(format!("{page}: {name}"));
            }
        }
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

/// Goal: every link of the documentation leads somewhere. Method: every relative target of every page, and every page
/// in the list of contents.
#[test]
fn links_of_the_documentation_lead_somewhere() {
    let mut broken = Vec::new();
    let listed = std::fs::read_to_string(root().join("mkdocs.yml")).unwrap();
    for (page, text) in pages() {
        let folder = root().join(&page).parent().unwrap().to_owned();
        for target in text.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let (file, part) = target.split_once('#').unwrap_or((target, ""));
            if target.contains("://") {
                continue;
            }
            let place = if file.is_empty() { root().join(&page) } else { folder.join(file) };
            if !place.exists() || !part.is_empty() && !has_part(&place, part) {
                broken.push(format!("{page}: {target}"));
            }
        }
        if let Some(name) =
            page.strip_prefix("docs/").filter(|name| !listed.lines().any(|line| line.ends_with(&format!(": {name}"))))
        {
            broken.push(format!("mkdocs.yml has no {name}"));
        }
    }
    assert!(broken.is_empty(), "{broken:#?}");
}

/// True if a page has a heading of this anchor: lower case, words with hyphens between them.
fn has_part(page: &Path, part: &str) -> bool {
    let anchor = |heading: &str| -> String {
        let kept = heading.trim().chars().filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
        kept.map(|c| if c == ' ' { '-' } else { c.to_ascii_lowercase() }).collect()
    };
    let text = std::fs::read_to_string(page).unwrap();
    text.lines().filter(|line| line.starts_with('#')).any(|line| anchor(line.trim_start_matches('#')) == part)
}

/// Every page of the documentation, by its place in the workspace, with its text.
fn pages() -> Vec<(String, String)> {
    let mut pages = vec!["README.md".to_owned(), "CONTRIBUTING.md".to_owned(), "ARCHITECTURE.md".to_owned()];
    for folder in ["docs", "docs/tutorial"] {
        let names = std::fs::read_dir(root().join(folder))
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap());
        pages.extend(
            names
                .filter(|name| Path::new(name).extension().is_some_and(|end| end == "md"))
                .map(|name| format!("{folder}/{name}")),
        );
    }
    pages.sort();
    pages.into_iter().map(|page| (page.clone(), std::fs::read_to_string(root().join(page)).unwrap())).collect()
}

/// Does what a tutorial says, in a folder of its own.
fn carry_out(tutorial: &str) {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(root().join(format!("docs/tutorial/{tutorial}.md"))).unwrap();
    let mut commands = 0;
    for block in text.split("\n```").skip(1).step_by(2) {
        let (head, body) = block.split_once('\n').unwrap();
        match head.split(' ').collect::<Vec<_>>()[..] {
            ["console"] => commands += session(folder.path(), body),
            [_, file] => write(&folder.path().join(file), body.to_owned()),
            [_, file, "more"] => {
                let place = folder.path().join(file);
                let before = std::fs::read_to_string(&place).unwrap();
                write(&place, format!("{before}\n{body}"));
            }
            _ => assert!(!body.contains("$ tripos"), "a command that is not run: {body}"),
        }
    }
    assert!(commands > 5, "{tutorial} has {commands} commands");
}

fn write(place: &Path, text: String) {
    std::fs::create_dir_all(place.parent().unwrap()).unwrap();
    std::fs::write(place, text + "\n").unwrap();
}

/// Runs the commands of a block and returns their number. Each must succeed, or end as a line `exit status N` says, and
/// print the lines that follow it.
fn session(folder: &Path, block: &str) -> usize {
    let commands: Vec<&str> = block.split("$ tripos ").skip(1).collect();
    for command in &commands {
        let mut lines = command.lines();
        let arguments: Vec<String> = words(lines.next().unwrap());
        let mut shown: Vec<&str> = lines.map(str::trim_end).filter(|line| !line.is_empty() && *line != "…").collect();
        let last =
            shown.last().and_then(|line| line.strip_prefix("exit status ")).map(|number| number.parse().unwrap());
        if last.is_some() {
            shown.pop();
        }
        let (status, out, err) = tripos_in(folder, &arguments.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!(status, last.unwrap_or(0), "tripos {arguments:?}:\n{out}\n{err}");
        let printed = out + &err;
        let mut rest = printed.lines().map(str::trim_end);
        for line in shown {
            assert!(
                rest.any(|printed| is_shown(printed, line)),
                "tripos {arguments:?} does not print `{line}` there, but:\n{printed}"
            );
        }
    }
    commands.len()
}

/// True if a printed line agrees with the shown one: the parts between `…`, in their order, from its beginning to its
/// end.
fn is_shown(printed: &str, line: &str) -> bool {
    let mut parts = line.split('…');
    let (first, last) = (parts.next().unwrap_or(""), parts.next_back());
    let Some(mut rest) = printed.strip_prefix(first) else { return false };
    let Some(last) = last else { return rest.is_empty() };
    for part in parts {
        let Some((_, behind)) = rest.split_once(part) else { return false };
        rest = behind;
    }
    rest.ends_with(last)
}

/// Words of a command line; what stands between quotes is one.
fn words(line: &str) -> Vec<String> {
    let (mut words, mut word, mut quote) = (Vec::new(), String::new(), None);
    for c in line.chars().chain([' ']) {
        match (c, quote) {
            ('\'' | '"', None) => quote = Some(c),
            (c, Some(open)) if c == open => quote = None,
            (' ', None) if !word.is_empty() => words.push(std::mem::take(&mut word)),
            (' ', None) => {}
            (c, _) => word.push(c),
        }
    }
    words
}
