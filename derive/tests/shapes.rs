//! Shapes of a model: their meaning, the messages for wrong ones, and equations that do not depend on them.

use crate::common;

use common::{edited, errors, place, read};
use tripos_derive::model::{ShapeForm, text_hash};

const SHAPES: &str = r#"
[shapes]
rod = { kind = "line", through = ["P", "C"], radius = "length/50" }
wheel = { kind = "disk", body = "rod", axis = 3, radius = "length/4", about = "turns with the rod" }
drum = { kind = "cylinder", frame = "N", at = "P", axis = 1, radius = "length/9", length = "length", position = [0, "-length", 0] }
cart = { kind = "box", body = "cart", size = ["length", "length/2", "length/3"] }
bob = { kind = "sphere", body = "rod", radius = "length/8" }
floor = { kind = "ground", axis = 2 }
"#;

/// Goal: every kind is read, with the places that bodies bring. Method: frames, points and axes by name.
#[test]
fn every_kind_of_shape_is_read_where_its_body_is() {
    let model = read(&edited(&[], SHAPES)).unwrap();
    let of = |name: &str| model.shapes.iter().find(|shape| shape.name == name).unwrap();
    let at = |name: &str| (model.frames[of(name).frame].name.as_str(), model.points[of(name).point].name.as_str());
    assert_eq!(model.shapes.len(), 6);
    assert_eq!(at("wheel"), ("A", "C"), "a rigid body's own");
    assert_eq!(at("cart"), ("N", "P"), "a particle does not turn");
    assert_eq!(at("drum"), ("N", "P"));
    assert_eq!(at("floor"), ("N", "O"), "the ground is at the origin");
    assert!(matches!(of("wheel").form, ShapeForm::Disk { axis: 2, thickness: None, .. }));
    assert!(matches!(of("floor").form, ShapeForm::Ground { axis: 1 }));
    let ShapeForm::Line { through, .. } = &of("rod").form else { panic!("a line") };
    assert_eq!(through.iter().map(|p| model.points[*p].name.as_str()).collect::<Vec<_>>(), ["P", "C"]);
    assert_eq!(of("wheel").about, "turns with the rod");
}

/// Goal: a length may be a number with its unit, as no equation contains it. Method: centimetres and millimetres beside
/// formulas; a number without a unit, and one in kilograms, are refused.
#[test]
fn lengths_of_shapes_are_formulas_or_numbers_with_units() {
    let shapes = "[shapes]\nbob = { kind = \"sphere\", body = \"rod\", radius = \"2 cm\", position = [\"5 mm\", \"length\", 0] }\n";
    let model = read(&edited(&[], shapes)).unwrap();
    let ShapeForm::Sphere { radius } = &model.shapes[0].form else { panic!("a sphere") };
    let number = |e| model.arena.as_number(e).map(ToString::to_string);
    assert_eq!(number(*radius).as_deref(), Some("1/50"));
    assert_eq!(number(model.shapes[0].position[0]).as_deref(), Some("1/200"));
    for wrong in ["0.02", "\"2 kg\"", "\"cm\""] {
        assert!(read(&edited(&[], &shapes.replace("\"2 cm\"", wrong))).is_err(), "{wrong}");
    }
}

/// Goal: a model whose shapes are edited keeps the equations that were compiled. Method: hashes with, without and with
/// other shapes; and of an edit outside the shapes.
#[test]
fn shapes_do_not_change_what_equations_are_derived_from() {
    let plain = read(&edited(&[], "")).unwrap();
    let shaped = read(&edited(&[], SHAPES)).unwrap();
    let other = read(&edited(&[], &SHAPES.replace("length/4", "length/3"))).unwrap();
    assert_eq!(plain.text_hash(), text_hash(common::BASE), "as it was without shapes");
    assert_eq!(plain.text_hash(), shaped.text_hash());
    assert_eq!(plain.text_hash(), other.text_hash());
    let heavier = read(&edited(&[("value = 2", "value = 3")], SHAPES)).unwrap();
    assert_ne!(plain.text_hash(), heavier.text_hash());
    // Shapes in the middle are part of the text.
    let middle = read(&edited(&[("[gravity]", &format!("{SHAPES}\n[gravity]"))], "")).unwrap();
    assert_ne!(plain.text_hash(), middle.text_hash());
}

/// Goal: every way to get a shape wrong has its message, at its place. Method: one wrong shape each: (entry, where,
/// message, help).
#[test]
fn wrong_shapes_are_told_at_their_place() {
    let cases = [
        (
            "{ kind = \"sphre\", body = \"rod\", radius = \"length\" }",
            "sphre",
            "there is no kind of shape `sphre`",
            "did you mean `sphere`?",
        ),
        ("{ body = \"rod\" }", "s ", "shape `s` has no `kind`", "add `kind = …`"),
        ("{ kind = \"sphere\", body = \"rod\" }", "s ", "shape `s` has no `radius`", "add `radius = …`"),
        (
            "{ kind = \"sphere\", body = \"rodd\", radius = \"length\" }",
            "rodd",
            "there is no body `rodd`",
            "did you mean `rod`?",
        ),
        (
            "{ kind = \"sphere\", body = \"rod\", radius = 0 }",
            "0 }",
            "the radius of shape `s` is 0 at the default values",
            "what can be seen is longer than 0",
        ),
        (
            "{ kind = \"box\", body = \"rod\", size = [\"length\", \"length - length\", \"length\"] }",
            "[",
            "the size of shape `s` is 0 at the default values",
            "longer than 0",
        ),
        (
            "{ kind = \"sphere\", body = \"rod\", radius = \"-length\" }",
            "\"-length",
            "the radius of shape `s` is -0.5 at the default values",
            "longer than 0",
        ),
        (
            "{ kind = \"sphere\", body = \"rod\", radius = \"m\" }",
            "m\"",
            "the radius of shape `s` must be in m, but `m` is in kg",
            "check the units",
        ),
        (
            "{ kind = \"sphere\", body = \"rod\", radius = \"x\" }",
            "x\"",
            "the coordinate `x` cannot stand in the radius of shape `s`",
            "allowed: parameters",
        ),
        (
            "{ kind = \"disk\", body = \"rod\", axis = 4, radius = \"length\" }",
            "4",
            "the axis of a shape is 1, 2 or 3",
            "write axis = 3",
        ),
        (
            "{ kind = \"box\", body = \"rod\", radius = \"length\", size = [\"length\", \"length\", \"length\"] }",
            "radius",
            "unknown key `radius` in a box",
            "",
        ),
        (
            "{ kind = \"sphere\", radius = \"length\" }",
            "s ",
            "shape `s` is nowhere",
            "add `body = …`, or both `frame = …` and `at = …`",
        ),
        (
            "{ kind = \"line\", through = [\"P\"] }",
            "[\"P\"]",
            "shape `s` goes through fewer than two points",
            "name two points or more",
        ),
        ("{ kind = \"line\", through = [\"P\", \"X\"] }", "X\"", "there is no point `X`", ""),
        (
            "{ kind = \"line\", through = \"P\" }",
            "\"P\"",
            "`through` must be a list of points",
            "name two points or more",
        ),
        ("{ kind = \"line\", body = \"rod\", through = [\"P\", \"C\"] }", "body", "unknown key `body` in a line", ""),
        ("{ kind = \"sphere\", frame = \"Q\", at = \"P\", radius = \"length\" }", "Q\"", "there is no frame `Q`", ""),
        ("7", "7", "shape `s` must be a table", "write it as { kind = \"sphere\""),
    ];
    for (entry, at, message, help) in cases {
        let text = edited(&[], &format!("[shapes]\ns = {entry}\n"));
        let found = errors(&text);
        let [only] = found.list.as_slice() else { panic!("{entry}: {found}") };
        assert!(only.message.contains(message), "{entry}: {found}");
        assert!(only.help.as_deref().unwrap_or_default().contains(help), "{entry}: {found}");
        let shapes = text.find("[shapes]").unwrap() + "[shapes]\n".len();
        // The name stands first; all else after `=`.
        let from = if at == "s " { shapes } else { shapes + "s = ".len() };
        let expected = from + text[from..].find(at).unwrap();
        let quote = usize::from(text[expected..].starts_with('"') && found.place(only) != Some(place(&text, expected)));
        assert_eq!(found.place(only), Some(place(&text, expected + quote)), "{entry}: {found}");
    }
}

/// All of a file's wrong shapes are told at once, beside what else is wrong.
#[test]
fn all_wrong_shapes_are_told_at_once() {
    let found = errors(&edited(
        &[("\"-g\"", "\"-gg\"")],
        "[shapes]\na = { kind = \"sphere\", body = \"rod\", radius = 0 }\nb = { kind = \"cube\", body = \"rod\" }\n",
    ));
    let messages: Vec<&str> = found.list.iter().map(|d| d.message.as_str()).collect();
    assert_eq!(messages.len(), 3, "{found}");
    assert!(messages[1].contains("shape `a`") && messages[2].contains("`cube`"), "{found}");
}
