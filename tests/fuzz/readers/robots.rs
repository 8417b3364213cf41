//! Robot descriptions: URDF, MJCF, files of loops, and meshes.

use crate::campaign::{Answer, Random, Share, campaign, tried};
use crate::mutation::{spoilt, spoilt_bytes};
use crate::refusal::check_errors;
use crate::seeds::{Seed, files_with, quoted_text};
use std::fmt::Write as _;
use tripos_derive::diagnostic::Source;
use tripos_derive::plain_text::is_forbidden;
use tripos_robots::{Options, import};

/// Reads a description. If it is accepted, the written model file must be TOML without forbidden characters.
fn imported(source: &Source, loops: Option<&Source>, random: &mut Random) -> Answer {
    let options = Options { is_floating: random.chance(30), is_as_written: random.chance(50) };
    match import(source, loops, options) {
        Ok(import) => {
            for text in [&import.model, &import.scene] {
                if let Err(error) = toml::from_str::<toml::Table>(text) {
                    panic!("the written file is no TOML | {error}\n{text}");
                }
                assert!(!text.contains(|c| c != '\n' && is_forbidden(c)), "a forbidden character is written | {text}");
            }
            if random.chance(4)
                && let Err(errors) = tripos_derive::model::load(&Source::from_text("model.toml", &import.model))
            {
                check_errors(&errors, &|_| true);
            }
            Answer::Read
        }
        Err(errors) => {
            check_errors(&errors, &|message| message.contains("no body") || message.contains("states its loops"));
            Answer::Refused
        }
    }
}

/// A spoilt description, with parts of other descriptions.
fn spoilt_description(seeds: &[Seed], random: &mut Random) -> Source {
    let seed = random.one(seeds);
    let other = if random.chance(70) { &random.one(seeds).text } else { quoted_text(random) };
    let text = spoilt(&seed.text, other, random);
    tried(&text);
    Source { path: seed.path.clone(), ..Source::from_text("", &text) }
}

#[test]
fn descriptions_in_urdf() {
    let seeds = files_with(&["urdf"]);
    let share = Share { short: 1000, long: 60_000 };
    campaign("URDF", &share, move |random| {
        let source = spoilt_description(&seeds, random);
        imported(&source, None, random)
    });
}

#[test]
fn descriptions_in_mjcf() {
    let seeds = files_with(&["xml"]);
    let share = Share { short: 1000, long: 20_000 };
    campaign("MJCF", &share, move |random| {
        let source = spoilt_description(&seeds, random);
        imported(&source, None, random)
    });
}

#[test]
fn files_of_loops() {
    let tree = files_with(&["urdf"]).into_iter().find(|seed| seed.path.ends_with("leg_fourbar_tree.urdf")).unwrap();
    let of_tree = |seed: &Seed| seed.path.to_string_lossy().contains("leg_fourbar_tree");
    let seeds: Vec<Seed> = files_with(&["toml"]).into_iter().filter(of_tree).collect();
    let share = Share { short: 500, long: 15_000 };
    campaign("files of loops", &share, move |random| {
        let source = Source { path: tree.path.clone(), text: tree.text.clone() };
        let loops = spoilt_description(&seeds, random);
        imported(&source, Some(&loops), random)
    });
}

/// A binary STL file of a few triangles.
fn binary_stl(random: &mut Random) -> Vec<u8> {
    let count = random.below(6);
    let mut bytes = vec![b' '; 80];
    bytes.extend(u32::try_from(count).unwrap().to_le_bytes());
    for _ in 0..count {
        for _ in 0..12 {
            let eighth = i8::try_from(random.below(200)).unwrap_or(0);
            bytes.extend((f32::from(eighth) / 8.0).to_le_bytes());
        }
        bytes.extend([0, 0]);
    }
    bytes
}

/// An STL file in text form, or an OBJ file.
fn mesh_text(is_obj: bool, random: &mut Random) -> String {
    let mut text = String::from(if is_obj { "# mesh\no part\n" } else { "solid part\n" });
    for _ in 0..random.below(5) {
        let mut point = || [0; 3].map(|_| random.decimal(-1.0, 1.0).to_string()).join(" ");
        if is_obj {
            let _ = writeln!(text, "v {}\nvn {}", point(), point());
        } else {
            let corners = [(); 3].map(|()| format!("vertex {}\n", point())).concat();
            let _ = writeln!(text, "facet normal {}\nouter loop\n{corners}endloop\nendfacet", point());
        }
    }
    text + if is_obj { "f 1 2 3\n" } else { "endsolid part\n" }
}

#[test]
fn meshes() {
    let folder = tempfile::tempdir().unwrap();
    let share = Share { short: 800, long: 50_000 };
    campaign("STL and OBJ", &share, move |random| {
        let is_obj = random.chance(30);
        let bytes = if is_obj || random.chance(50) {
            let text = mesh_text(is_obj, random);
            if random.chance(60) { spoilt(&text, quoted_text(random), random) } else { text }.into_bytes()
        } else {
            binary_stl(random)
        };
        let bytes = if random.chance(50) { spoilt_bytes(&bytes, random) } else { bytes };
        tried(&String::from_utf8_lossy(&bytes));
        let file = if is_obj { "part.obj" } else { "part.stl" };
        std::fs::write(folder.path().join(file), &bytes).unwrap();
        let scale = ["1 1 1", "-1 2 1", "1e-3 1e-3 1e-3", "0 0 0", "1e300 1 1"][random.below(5)];
        let text = format!(
            "<robot name=\"r\"><link name=\"base\"/><link name=\"arm\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" \
             iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial><visual><geometry><mesh filename=\"{file}\" \
             scale=\"{scale}\"/></geometry></visual></link><joint name=\"j\" type=\"revolute\"><parent link=\"base\"/>\
             <child link=\"arm\"/><limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint></robot>"
        );
        let source = Source { path: folder.path().join("robot.urdf"), text };
        let import =
            import(&source, None, Options::default()).unwrap_or_else(|e| panic!("a mesh stops an import | {e}"));
        if let Err(error) = toml::from_str::<toml::Table>(&import.model) {
            panic!("the written file is no TOML | {error}\n{}", import.model);
        }
        let without = import.omissions.iter().any(|omission| omission.text.contains("part"));
        import.omissions.iter().for_each(|omission| {
            assert!(!omission.text.contains(is_forbidden), "a forbidden character is listed | {}", omission.text);
        });
        if without { Answer::Refused } else { Answer::Read }
    });
}
