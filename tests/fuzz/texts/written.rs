//! Files with hostile words, written in every format, and read by a reader of that format.

use super::html::{MARK, fault};
use crate::campaign::{Answer, Random, Share, campaign, tried};
use crate::readers::commands::run;
use proc_macro2::{TokenStream, TokenTree};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use tripos_derive::plain_text::is_forbidden;

/// Words that are code, markup or an escape in one of the formats. The mark `zz` is a name that no output may define.
const WORDS: [&str; 52] = [
    "\"",
    "'",
    "\\",
    "*/",
    "/*",
    "//",
    "{{",
    "}}",
    "{",
    "}",
    "]]>",
    "<![CDATA[",
    "<script>zz()</script>",
    "</script><zz>",
    "<zz>",
    "</title>",
    "<!--",
    "-->",
    "%",
    "%s",
    "%}",
    "&",
    "&amp;",
    "&#0;",
    "\"\"\"",
    "'''",
    "`",
    "```",
    "~~~",
    "#",
    "$",
    "$(zz)",
    "${zz}",
    "\\end{document}",
    "\\input{zz}",
    "\\\\",
    "\\u{zz}",
    "\\x1b",
    "??/",
    "\n",
    "\r\n",
    "*/ fn zz() {} /*",
    "*/ int zz @; /*",
    "\"; zz = 1 #",
    "\"\"\"\nzz = 1\n\"\"\"",
    "Ünïcödé θ̇ — 🎢",
    "مرحبا",
    "a",
    "mass of",
    "1",
    "=cmd|zz",
    "\\",
];

/// A random text of a few hostile words. Prose may have line breaks, names have none.
fn hostile(is_prose: bool, random: &mut Random) -> String {
    let mut words = String::new();
    for _ in 0..=random.below(5) {
        words += random.one::<&str>(&WORDS[..]);
        words += if random.chance(50) { " " } else { "" };
    }
    let text = if is_prose { words } else { words.replace(['\n', '\r'], "") };
    if text.trim().is_empty() { "x".to_owned() } else { text }
}

/// A TOML string with this text.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c.is_control() => {
                let _ = write!(out, "\\u{:04X}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out + "\""
}

/// Writes a model, its scene and its publication with hostile texts into a folder.
fn write_files(folder: &Path, has_joint: bool, random: &mut Random) {
    let mut prose = || quoted(&hostile(true, random));
    let (source, of_mass, of_angle, of_input) = (prose(), prose(), prose(), prose());
    let (about, caption, note, printed) = (prose(), prose(), prose(), prose());
    let mut name = || quoted(hostile(false, random).trim());
    let (title, scene, event, output, id, section) = (name(), name(), name(), name(), name(), name());
    let id = id.replace(' ', "_");
    let parts = format!(
        "name = {title}\nsource = {source}\n[parameters]\nm = {{ unit = \"kg\", value = 1, positive = true, about = {of_mass} }}\n\
         l = {{ unit = \"m\", value = 1, positive = true }}\ng = {{ unit = \"m/s^2\", value = 9.81, positive = true }}\n\
         [inputs]\ntau = {{ unit = \"N*m\", about = {of_input} }}\n[inertial]\nframe = \"N\"\norigin = \"O\"\n\
         [gravity]\nframe = \"N\"\nacceleration = [0, \"-g\", 0]\n"
    );
    // The same pendulum by frames, and by a joint, whose coordinate has a name of its own.
    let by_frames = format!(
        "[coordinates]\ntheta = {{ unit = \"rad\", about = {of_angle} }}\n[speeds]\nomega = \"theta'\"\n[frames]\nB = {{ from \
         = \"N\", axis = 3, angle = \"theta\" }}\n[points]\nP = {{ from = \"O\", frame = \"B\", position = [0, \"-l\", 0] }}\n\
         [particles]\nbob = {{ point = \"P\", mass = \"m\" }}\n[forces]\ndrive = {{ on = \"bob\", at = \"P\", frame = \"B\", \
         vector = [\"tau/l\", 0, 0] }}\n"
    );
    let by_joint = "[bodies]\nbob = { mass = \"m\", inertia = { diagonal = [\"m*l^2\", \"m*l^2\", \"m*l^2\"] } }\n[joints]\npin = { kind \
                    = \"pin\", body = \"bob\" }\n[torques]\ndrive = { on = \"bob\", frame = \"N\", vector = [0, 0, \"tau\"] }\n";
    let model = format!("{parts}{}", if has_joint { by_joint } else { &by_frames });
    let scene = format!(
        "model = \"model.toml\"\ntitle = {scene}\nabout = {about}\nspan = [0, 0.05]\noutputs = [{{ name = {output}, value = \
         \"theta\" }}, \"omega\"]\n[inputs]\ntau = 0.1\n[start]\ntheta = 0.5\nomega = 0\n[[events]]\nname = {event}\nzero = \
         \"theta - 0.4999\"\n[[figures]]\nkind = \"energy\"\ncaption = {caption}\n"
    );
    let publication = format!(
        "title = {title}\nsource = {printed}\n[[equation]]\nid = {id}\nsection = {section}\nquantity = \"T\"\nprinted = \
         \"m*l^2*omega^2/2\"\nnote = {note}\n"
    );
    let named = |text: String| {
        if has_joint { text.replace("theta", "q_pin").replace("omega", "u_pin") } else { text }
    };
    let (scene, publication) = (named(scene), named(publication));
    for (file, text) in [("model.toml", model), ("scene.toml", scene), ("publication.toml", publication)] {
        std::fs::write(folder.join(file), text).unwrap();
    }
}

/// All files below a folder.
fn files_below(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).into_iter().flatten() {
            let path = entry.unwrap().path();
            if path.is_dir() { folders.push(path) } else { files.push(path) }
        }
    }
    files.sort();
    files
}

/// True if tokens contain the mark as a name.
fn has_mark(tokens: TokenStream) -> bool {
    tokens.into_iter().any(|token| match token {
        TokenTree::Group(group) => has_mark(group.stream()),
        TokenTree::Ident(ident) => ident == MARK,
        _ => false,
    })
}

/// Number of braces of LaTeX that stay open; `None` if one is closed that was not opened.
fn open_braces(text: &str) -> Option<usize> {
    let (mut depth, mut characters) = (0_usize, text.chars());
    let mut is_comment = false;
    while let Some(c) = characters.next() {
        match c {
            '\n' => is_comment = false,
            _ if is_comment => {}
            '\\' => drop(characters.next()),
            '%' => is_comment = true,
            '{' => depth += 1,
            '}' => depth = depth.checked_sub(1)?,
            _ => {}
        }
    }
    Some(depth)
}

/// Answer of another program about a file: its complaint, or `None` if it accepts the file or is not installed.
fn complaint(program: &str, words: &[&str], file: &Path) -> Option<String> {
    let output = Command::new(program).args(words).arg(file).output().ok()?;
    if output.status.success() { None } else { Some(String::from_utf8_lossy(&output.stderr).into_owned()) }
}

/// Program in Python that parses a file, and looks for the mark among its names.
const PYTHON: &str = "import ast, sys\nnames = [getattr(n, 'id', getattr(n, 'name', '')) for n in \
                      ast.walk(ast.parse(open(sys.argv[1], encoding='utf-8').read()))]\nassert 'zz' not in names, 'zz is defined'";

/// Invisible sign between a function and its argument, which MathML asks for.
const APPLICATION: char = '\u{2061}';

/// Checks a written text by a reader of its format. `is_sample` permits other programs, which take long to start.
fn check_text(path: &Path, text: &str, is_sample: bool) {
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let end = path.extension().unwrap_or_default().to_string_lossy().into_owned();
    let fail = |why: &str| panic!("a wrong file of kind `{end}` | {name}: {why}");
    if let Some(c) = text.chars().find(|c| !['\n', '\t', '\r', APPLICATION].contains(c) && is_forbidden(*c)) {
        fail(&format!("the character {c:?}"));
    }
    match end.as_str() {
        "rs" => {
            if let Err(error) = syn::parse_file(text) {
                fail(&error.to_string());
            }
            if text.parse().map_or(true, has_mark) {
                fail("it defines the mark");
            }
        }
        "json" => drop(serde_json::from_str::<serde_json::Value>(text).map_err(|error| fail(&error.to_string()))),
        "toml" => drop(toml::from_str::<toml::Table>(text).map_err(|error| fail(&error.to_string()))),
        "svg" | "xml" | "urdf" => match roxmltree::Document::parse(text) {
            Err(error) => fail(&error.to_string()),
            Ok(document) => {
                if document.descendants().any(|node| node.tag_name().name() == MARK || node.has_attribute(MARK)) {
                    fail("it has an element of the mark");
                }
            }
        },
        "html" => {
            if let Some(why) = fault(text) {
                fail(&why);
            }
            for name in ["svg", "math"] {
                for part in text.split(&format!("<{name}")).skip(1) {
                    let whole =
                        part.split_once(&format!("</{name}>")).map(|(inside, _)| format!("<{name}{inside}</{name}>"));
                    if let Some(Err(error)) = whole
                        .filter(|whole| !whole.contains("&nbsp;"))
                        .map(|whole| roxmltree::Document::parse(&whole).map(drop))
                    {
                        fail(&format!("its {name}: {error}"));
                    }
                }
            }
        }
        "tex" => match open_braces(text) {
            Some(0) => {}
            open => fail(&format!("open braces: {open:?}")),
        },
        "csv" => {
            for record in csv::Reader::from_reader(text.as_bytes()).records() {
                if let Err(error) = record {
                    fail(&error.to_string());
                }
            }
        }
        "py" if is_sample => {
            if let Some(why) = complaint("python3", &["-c", PYTHON], path) {
                fail(&why);
            }
        }
        "c" | "h" if is_sample => {
            let words = ["-fsyntax-only", "-std=c11", "-Wcomment", "-Werror", "-x", "c"];
            if let Some(why) = complaint("cc", &words, path) {
                fail(&why);
            }
        }
        "mjs" | "js" if is_sample && !path.to_string_lossy().contains('\\') => {
            if let Some(why) = complaint("node", &["--check"], path) {
                fail(&why);
            }
        }
        _ => {}
    }
}

/// Commands whose outputs are checked: words after the name of the file, and the kind of the printed text.
const COMMANDS: [(&str, &str, &[&str], &str); 29] = [
    ("derive", "model.toml", &["--format", "latex"], "tex"),
    ("derive", "model.toml", &["--format", "latex", "--fragment"], "tex"),
    ("derive", "model.toml", &["--format", "json"], "json"),
    ("derive", "model.toml", &["--format", "sympy"], "py"),
    ("derive", "model.toml", &["--format", "markdown"], "md"),
    ("derive", "model.toml", &["--format", "typst"], "typ"),
    ("derive", "model.toml", &[], "txt"),
    ("check", "model.toml", &["--json"], "json"),
    ("diff", "model.toml", &["publication.toml", "--json"], "json"),
    ("diff", "model.toml", &["publication.toml"], "txt"),
    ("prove", "model.toml", &["--json"], "json"),
    ("prove", "model.toml", &["--certificate", "out/proof.cert"], "txt"),
    ("simulate", "scene.toml", &["--json", "--csv", "out/run.csv"], "json"),
    ("scene", "scene.toml", &["--json"], "json"),
    ("sweep", "scene.toml", &["--over", "m=1,2", "--out", "out/table.csv"], "txt"),
    ("identify", "model.toml", &["--json"], "json"),
    ("emit", "model.toml", &["--out", "out", "--language", "rust"], "txt"),
    ("emit", "model.toml", &["--out", "out", "--language", "js"], "txt"),
    ("emit", "model.toml", &["--out", "out", "--language", "c"], "txt"),
    ("emit", "model.toml", &["--out", "out", "--language", "python"], "txt"),
    ("emit", "model.toml", &["--out", "out", "--language", "casadi"], "txt"),
    ("emit", "model.toml", &["--out", "out", "--language", "matlab"], "txt"),
    ("emit", "model.toml", &["--out", "out", "--language", "urdf"], "txt"),
    ("fmu", "scene.toml", &["--out", "out/unit.fmu", "--only-sources"], "txt"),
    ("sketch", "model.toml", &["--out", "out/sketch.svg"], "txt"),
    ("sketch", "model.toml", &["--out", "out/sketch.tex"], "txt"),
    ("plot", "scene.toml", &["--out", "out/plot.svg"], "txt"),
    ("view", "scene.toml", &["--out", "out/view.html"], "txt"),
    ("page", "model.toml", &["--out", "out"], "txt"),
];

/// Number of the cases of a command among the cases of all, in parts: a page takes as long as thirty other commands.
fn command(random: &mut Random) -> &'static (&'static str, &'static str, &'static [&'static str], &'static str) {
    let chosen = random.one(&COMMANDS[..]);
    if chosen.0 == "page" && random.chance(80) { random.one(&COMMANDS[..28]) } else { chosen }
}

#[test]
fn hostile_texts_in_every_format() {
    let folder = tempfile::tempdir().unwrap();
    campaign("texts that leave", &Share { short: 60, long: 3000 }, move |random| {
        let place = folder.path().join(format!("m{}", random.below(1_000_000)));
        let place = if random.chance(30) {
            folder.path().join(hostile(false, random).replace('/', "").trim_start_matches('-'))
        } else {
            place
        };
        let _ = std::fs::remove_dir_all(&place);
        std::fs::create_dir_all(&place).unwrap();
        std::fs::create_dir_all(place.join("out")).unwrap();
        let (command, file, rest, kind) = command(random);
        write_files(&place, rest.contains(&"urdf") || random.chance(20), random);
        let mut words = vec![(*command).to_owned(), place.join(file).display().to_string()];
        let is_toml = |word: &str| std::path::Path::new(word).extension().is_some_and(|end| end == "toml");
        let is_place = |word: &str| word.starts_with("out") || is_toml(word);
        words.extend(
            rest.iter().map(
                |word| {
                    if is_place(word) { place.join(word).display().to_string() } else { (*word).to_owned() }
                },
            ),
        );
        let of_file = |name: &str| std::fs::read_to_string(place.join(name)).unwrap();
        tried(&format!("{} | {} | {}", words.join(" "), of_file("model.toml"), of_file("scene.toml")));
        let output = run(&words);
        let refused = || format!("hostile texts are refused by {command} {} | {}", rest.join(" "), output.messages);
        assert!(output.status <= 1, "{}", refused());
        let is_sample = random.chance(50);
        let printed = place.join(format!("printed.{kind}"));
        std::fs::write(&printed, &output.output).unwrap();
        check_text(&printed, &output.output, is_sample);
        for path in files_below(&place.join("out")) {
            if let Ok(text) = std::fs::read_to_string(&path) {
                check_text(&path, &text, is_sample);
            }
        }
        std::fs::remove_dir_all(&place).unwrap();
        Answer::Read
    });
}
