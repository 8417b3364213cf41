//! Text of files stays text: in generated code, in messages, in JSON and on the page.

use crate::support::{cargo, make_crate, tripos_in};
use serde_json::Value;
use std::fmt::Write;
use tripos_codegen::Extras;
use tripos_codegen::rust::{SceneHeaderData, scene_file, scene_list};
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::plain_text::is_forbidden;
use tripos_derive::reduce::reduce;

/// Text that is code, markup or an escape somewhere else, and has a right to stand in a file.
const LEGAL: [&str; 18] = [
    "*/ compile_error!(\"escaped\"); /*",
    "\"; compile_error!(\"escaped\"); //",
    "\\\"; compile_error!(\"escaped\"); //",
    "```",
    "``` std::process::abort()",
    "~~~ rust",
    "    std::process::abort()",
    "#![feature(rustc_private)]",
    "//! # Heading",
    "[`Missing::link`] and [text](https://example.invalid)",
    "<script>alert(1)</script>",
    "<b onmouseover=\"x\">&amp;</b>",
    "{} {{}} {0} %s $(id) ${HOME}",
    "\\u{202e} \\n \\x1b[31m",
    "\\begin{document} \\input{secret} $x_1$",
    "'quoted' \"twice\" `thrice`",
    "Ünïcödé θ̇ — 🎢 中文",
    "=cmd|' /C calc'!A0",
];

/// Text that has no right to stand anywhere.
const ILLEGAL: [(&str, &str); 7] = [
    ("a\nb", "U+000A"),
    ("red \u{1b}[31m", "U+001B"),
    ("bell \u{7}", "U+0007"),
    ("next line \u{85}", "U+0085"),
    ("turned \u{202e}gnirts", "U+202E"),
    ("isolated \u{2066}x\u{2069}", "U+2066"),
    ("separated \u{2028}x", "U+2028"),
];

/// Quotes a text as a TOML string.
fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if is_forbidden(c) => {
                let _ = write!(out, "\\u{:04X}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out + "\""
}

/// A pendulum with these texts for its name, its source, and what its parts are about.
fn model(texts: [&str; 4]) -> String {
    let [name, source, of_mass, of_angle] = texts.map(quoted);
    format!(
        "name = {name}\nsource = {source}\n[parameters]\nm = {{ unit = \"kg\", value = 1, positive = true, about = {of_mass} }}\n\
         l = {{ unit = \"m\", value = 1, positive = true }}\ng = {{ unit = \"m/s^2\", value = 9.81, positive = true }}\n\
         [coordinates]\ntheta = {{ unit = \"rad\", about = {of_angle} }}\n[speeds]\nomega = \"theta'\"\n\
         [inertial]\nframe = \"N\"\norigin = \"O\"\n[frames]\nB = {{ from = \"N\", axis = 3, angle = \"theta\" }}\n\
         [points]\nP = {{ from = \"O\", frame = \"B\", position = [0, \"-l\", 0] }}\n[particles]\nbob = {{ point = \"P\", mass = \"m\" }}\n\
         [gravity]\nframe = \"N\"\nacceleration = [0, \"-g\", 0]\n"
    )
}

/// A scene with these texts for its title, an output, an event, and a caption.
fn scene(texts: [&str; 4]) -> String {
    let [title, output, event, caption] = texts.map(quoted);
    format!(
        "model = \"model.toml\"\ntitle = {title}\nspan = [0, 0.1]\noutputs = [{{ name = {output}, value = \"theta\" }}, \"omega\"]\n\
         [start]\ntheta = 0.5\nomega = 0\n[[events]]\nname = {event}\nzero = \"theta - 0.49\"\n\
         [[figures]]\nkind = \"energy\"\ncaption = {caption}\n"
    )
}

/// Goal: whatever a file is called and says, the code made from it is the same code. Method: crates of modules from
/// every text in every place, compiled without a warning, their documentation built without one, and no example found
/// in it to run.
#[test]
fn generated_code_of_hostile_texts_compiles_and_runs_nothing_of_theirs() {
    let folder = tempfile::tempdir().unwrap();
    let (sources, mut modules) = (folder.path().join("src"), String::new());
    for (at, text) in LEGAL.iter().enumerate() {
        let other = |k: usize| LEGAL[(at + k) % LEGAL.len()];
        // A file name may have everything but a slash.
        let stem: String = text.replace('/', "∕");
        let path = folder.path().join(format!("{stem}.toml"));
        std::fs::write(&path, model([text, other(5), other(7), other(11)])).unwrap();
        let name = format!("m{at}");
        let arguments = ["emit", path.to_str().unwrap(), "--out", &format!("src/{name}"), "--formulation", "lagrange"];
        let (status, _, err) = tripos_in(folder.path(), &arguments);
        assert_eq!(status, 0, "{text}: {err}");
        let _ = writeln!(modules, "pub mod {name};");
        let mut read = Model::read(&path).unwrap();
        let stated = Source::from_text("scene.toml", &scene([other(1), other(2), other(3), other(4)]));
        let loaded = tripos_derive::scene::load(&stated, &mut read).unwrap_or_else(|e| panic!("{e}"));
        let reduction = reduce(&read, &loaded).unwrap();
        let named = SceneHeaderData { name: &stem, title: other(1), origin: "Generated from a scene." };
        let file = scene_file(&read, &reduction, &named, Extras::ALL, &[]).unwrap();
        let scenes = sources.join(&name).join("scenes");
        std::fs::create_dir_all(scenes.join("code")).unwrap();
        std::fs::write(scenes.join(format!("{}.rs", file.module)), &file.text).unwrap();
        std::fs::write(scenes.join(format!("code/{}.rs", file.module)), file.code.as_ref().unwrap()).unwrap();
        let [list, code] = scene_list(&read.title, "Generated from a scene.", &[file]);
        std::fs::write(scenes.join("mod.rs"), list).unwrap();
        std::fs::write(scenes.join("code/mod.rs"), code).unwrap();
        let module = sources.join(&name).join("mod.rs");
        let text = std::fs::read_to_string(&module).unwrap();
        std::fs::write(&module, format!("{text}\n/// Scenes.\npub mod scenes;\n")).unwrap();
    }
    std::fs::write(sources.join("lib.rs"), format!("//! Hostile.\n#![allow(non_snake_case)]\n{modules}")).unwrap();
    make_crate(folder.path());
    let (_, warnings) = cargo(folder.path(), &["build", "--quiet"]);
    assert!(warnings.is_empty(), "{warnings}");
    cargo(folder.path(), &["doc", "--quiet", "--no-deps"]);
    let (examples, _) = cargo(folder.path(), &["test", "--doc"]);
    assert!(examples.contains("running 0 tests"), "{examples}");
}

/// Goal: what steers a terminal, turns a line or ends a comment is refused where it stands. Method: each such text in
/// each place.
#[test]
fn control_and_bidirectional_characters_are_refused_with_their_place() {
    let folder = tempfile::tempdir().unwrap();
    let (model_file, scene_file) = (folder.path().join("model.toml"), folder.path().join("scene.toml"));
    let fine = ["plain"; 4];
    for (text, name) in ILLEGAL {
        for place in 0..8 {
            let with = |own: usize| {
                let mut texts = fine;
                if place / 4 == own {
                    texts[place % 4] = text;
                }
                texts
            };
            std::fs::write(&model_file, model(with(0))).unwrap();
            std::fs::write(&scene_file, scene(with(1))).unwrap();
            let (status, out, err) = tripos_in(folder.path(), &["simulate", "scene.toml", "--json"]);
            assert!(!out.chars().chain(err.chars()).any(|c| c != '\n' && is_forbidden(c)), "{text:?}: {out}{err}");
            // A line break in prose is a space.
            if text.contains('\n') && [1, 2, 3, 7].contains(&place) {
                assert_eq!(status, 0, "{text:?} in place {place}: {err}");
                continue;
            }
            assert_eq!(status, 2, "{text:?} in place {place}: {out}{err}");
            assert!(err.contains(name) && err.contains(".toml:"), "{text:?} in place {place}: {err}");
        }
    }
    // Keys and names of folders are text, too.
    std::fs::write(&model_file, model(fine).replace("theta = {", "\"th\\u001Beta\" = {")).unwrap();
    let (status, _, err) = tripos_in(folder.path(), &["derive", "model.toml"]);
    assert!(status == 2 && !err.contains('\u{1b}'), "{err:?}");
    let strange = folder.path().join("a\u{1b}[31m\u{202e}b");
    std::fs::create_dir(&strange).unwrap();
    std::fs::write(strange.join("model.toml"), model(fine)).unwrap();
    let (status, out, err) =
        tripos_in(folder.path(), &["prove", strange.join("model.toml").to_str().unwrap(), "--json"]);
    assert_eq!(status, 0, "{err}");
    assert!(!out.chars().any(|c| c != '\n' && is_forbidden(c)), "{out:?}");
    let back: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(back["model"], "a\u{1b}[31m\u{202e}b", "JSON reads back what it was");
}

/// Goal: legal texts reach people as they are. Method: a page, a table and JSON of each, read back.
#[test]
fn hostile_texts_are_shown_as_they_stand() {
    let folder = tempfile::tempdir().unwrap();
    for (at, text) in LEGAL.iter().enumerate() {
        let place = folder.path().join(at.to_string());
        std::fs::create_dir(&place).unwrap();
        std::fs::write(place.join("model.toml"), model([text; 4])).unwrap();
        // The name of an output must be one that the model does not have.
        std::fs::write(place.join("scene.toml"), scene([text, text, text, text])).unwrap();
        let (status, out, err) = tripos_in(&place, &["simulate", "scene.toml", "--json", "--csv", "run.csv"]);
        assert_eq!(status, 0, "{text}: {err}");
        let json: Value = serde_json::from_str(&out).unwrap();
        let name = text.trim();
        assert!(json["state"][name].is_number(), "{text}: {out}");
        assert_eq!(json["events"][0]["name"], name, "{text}");
        let mut table = csv::Reader::from_path(place.join("run.csv")).unwrap();
        assert_eq!(&table.headers().unwrap()[1], name, "{text}");
        let (status, _, err) = tripos_in(&place, &["page", "model.toml", "--out", "page"]);
        assert_eq!(status, 0, "{text}: {err}");
        let page = std::fs::read_to_string(place.join("page/index.html")).unwrap();
        for markup in ["<script>alert", "<b onmouseover"] {
            assert!(!page.contains(markup), "{text}");
        }
    }
}
