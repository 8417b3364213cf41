//! The form of comments and Markdown: a first sentence that is understood alone, and lines that fit a screen.

use crate::arrows::sources;
use std::path::{Path, PathBuf};

/// Folders of sources whose comments are checked.
const FOLDERS: [&str; 8] = ["linear", "derive", "codegen", "sim", "robots", "run", "cli", "tests"];

/// Words that begin a clause in place of a noun, or that point at a neighbour which rustdoc does not show.
const ELLIPTIC: [&str; 10] = ["What", "Which", "Where", "How", "Whether", "Of", "As", "That", "By", "The same,"];

/// Characters of the shortest first line.
const SHORTEST: usize = 9;

/// Columns of a line.
const WIDEST: usize = 120;

/// Number of columns that a line takes: marks over a letter take none.
fn columns(line: &str) -> usize {
    line.chars().filter(|c| !('\u{300}'..='\u{36f}').contains(c)).count()
}

/// True if a doc comment may begin with this line.
fn is_understood_alone(line: &str) -> bool {
    let begins = |word: &str| line.strip_prefix(word).is_some_and(|rest| !rest.starts_with(char::is_alphanumeric));
    !ELLIPTIC.iter().any(|word| begins(word)) && line.chars().count() >= SHORTEST
}

/// First lines of the doc comments of a text, each with its number from 1.
fn first_lines(text: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let mut before = None;
    for (at, line) in text.lines().enumerate() {
        let line = line.trim_start();
        let mark = ["///", "//!"].into_iter().find(|mark| line.starts_with(mark) && !line.starts_with("////"));
        if let Some(mark) = mark.filter(|mark| before != Some(*mark)) {
            found.push((at + 1, line[mark.len()..].trim()));
        }
        before = mark;
    }
    found
}

/// Goal: a reader of one item's documentation, who sees nothing above it, learns what the item is.
#[test]
fn documentation_names_its_subject() {
    for folder in FOLDERS {
        for (path, text) in sources(folder) {
            let unclear = first_lines(&text).into_iter().find(|(_, line)| !is_understood_alone(line));
            assert!(unclear.is_none(), "{}: {unclear:?}", path.display());
        }
    }
}

/// Goal: comments fit a screen.
#[test]
fn comments_are_at_most_120_columns_wide() {
    for folder in FOLDERS {
        for (path, text) in sources(folder) {
            let comments = text.lines().enumerate().filter(|(_, line)| line.trim_start().starts_with("//"));
            let wide = comments.map(|(at, line)| (at + 1, line)).find(|(_, line)| columns(line) > WIDEST);
            assert!(wide.is_none(), "{}: {wide:?}", path.display());
        }
    }
}

/// Markdown that people write: files at the top and all in `docs`.
fn written_pages() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut pages = Vec::new();
    for folder in [root.to_path_buf(), root.join("docs"), root.join("docs/tutorial")] {
        let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        pages.extend(entries.filter(|path| path.extension().is_some_and(|extension| extension == "md")));
    }
    assert!(pages.len() > 10);
    pages
}

/// Goal: Markdown fits a screen, except tables and code, which have no other form. Code is fenced or indented.
#[test]
fn markdown_is_at_most_120_columns_wide() {
    for path in written_pages() {
        let text = std::fs::read_to_string(&path).unwrap();
        let mut is_fenced = false;
        for (at, line) in text.lines().enumerate() {
            is_fenced ^= line.trim_start().starts_with("```");
            let is_other = is_fenced || line.starts_with("    ") || line.trim_start().starts_with('|');
            // A long name or formula is not broken.
            let longest = line.split(' ').map(columns).max().unwrap_or(0);
            let is_whole = line.matches('`').count() == 2 && line.trim_start().starts_with('`') || longest > WIDEST / 2;
            assert!(is_other || is_whole || columns(line) <= WIDEST, "{}:{}: {line}", path.display(), at + 1);
        }
    }
}

#[test]
fn clauses_and_riddles_are_refused() {
    let refused =
        ["What does.", "One.", "Whether a body moves", "Of the first of them", "The same, backwards", "By name"];
    for line in refused {
        assert!(!is_understood_alone(line), "{line}");
    }
    for line in ["Offset of a step, s.", "Asks for a state", "Bytes of a file", "Howland's current source"] {
        assert!(is_understood_alone(line), "{line}");
    }
}
