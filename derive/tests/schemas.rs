//! JSON Schemas of the files beside the readers of these files.

use boon::{Compiler, Schemas};
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use toml::de::{DeTable, DeValue};
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::model::load;
use tripos_derive::publication;
use tripos_derive::scene::{self, load_state_with_unknowns};
use tripos_derive::schema::SchemaFormat;

/// Content of a TOML value, as JSON.
fn as_json(value: &DeValue<'_>) -> Value {
    match value {
        DeValue::String(text) => json!(text),
        DeValue::Integer(n) => n.as_str().parse::<i64>().map_or(json!(n.as_str()), |n| json!(n)),
        DeValue::Float(x) => x.as_str().replace('_', "").parse::<f64>().map_or(Value::Null, |x| json!(x)),
        DeValue::Boolean(b) => json!(b),
        DeValue::Datetime(_) => Value::Null,
        DeValue::Array(list) => list.iter().map(|value| as_json(value.get_ref())).collect(),
        DeValue::Table(table) => table_as_json(table),
    }
}

fn table_as_json(table: &DeTable<'_>) -> Value {
    let entries = table.iter().map(|(key, value)| (key.get_ref().to_string(), as_json(value.get_ref())));
    Value::Object(entries.collect::<Map<String, Value>>())
}

/// Objection of the schema of a format to a text; `None` if it accepts the text.
fn objection(format: SchemaFormat, text: &str) -> Option<String> {
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    compiler.add_resource("format.json", format.schema()).unwrap();
    let index = compiler.compile("format.json", &mut schemas).unwrap();
    let value = table_as_json(DeTable::parse(text).unwrap().get_ref());
    schemas.validate(&value, index).err().map(|error| format!("{error:#}"))
}

/// Every TOML file below a folder of the project.
fn files(folder: &Path, list: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, list);
        } else if path.extension().is_some_and(|extension| extension == "toml") {
            list.push(path);
        }
    }
}

/// The format of a file of the library, by what is in it.
fn format(text: &str) -> Option<SchemaFormat> {
    let table = DeTable::parse(text).ok()?;
    let has = |key: &str| table.get_ref().contains_key(key);
    let marks = [
        ("inertial", SchemaFormat::Model),
        ("span", SchemaFormat::Scene),
        ("state", SchemaFormat::State),
        ("equation", SchemaFormat::Publication),
        ("system", SchemaFormat::Publication),
    ];
    marks.into_iter().find(|(key, _)| has(key)).map(|(_, format)| format)
}

/// Goal: editors find no fault with what is right. Method: all files of the library, and every model that tests read.
#[test]
fn the_schemas_take_every_file_of_the_library() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let mut list = Vec::new();
    for folder in ["models", "derive/tests", "tests/data", "benches", "cli/src/commands/new"] {
        files(&root.join(folder), &mut list);
    }
    let mut seen = BTreeMap::new();
    for path in list {
        let text = std::fs::read_to_string(&path).unwrap();
        let Some(format) = format(&text) else { continue };
        *seen.entry(format.name()).or_insert(0) += 1;
        assert_eq!(objection(format, &text), None, "{}", path.display());
    }
    assert!(seen["model"] > 30 && seen["scene"] > 30 && seen["publication"] > 0 && seen["state"] > 0, "{seen:?}");
}

/// A model with an entry of every kind, and of every kind that its keys depend on.
const MODEL: &str = include_str!("forms/every_section.toml");
const SCENE: &str = include_str!("forms/every_section_scene.toml");
/// Model of the scene and of the publication below.
const PENDULUM: &str = "name = \"Pendulum\"\n[parameters]\nm = \"1 kg\"\nl = \"1 m\"\n[coordinates]\nq = { unit = \"rad\" }\n\
                        [speeds]\nu = \"q'\"\n[inertial]\nframe = \"N\"\norigin = \"O\"\n\
                        [points]\nP = { from = \"O\", frame = \"N\", position = [\"l*cos(q)\", \"l*sin(q)\", 0] }\n\
                        [particles]\nbob = { point = \"P\", mass = \"m\" }\n[inputs]\nF = { unit = \"N\" }\n\
                        [forces.push]\non = \"bob\"\nframe = \"N\"\nvector = [\"F\", 0, 0]\n";
const PUBLICATION: &str = "[[equation]]\nid = \"1\"\nsection = \"1\"\nquantity = \"T\"\nprinted = \"0\"\n\
                      [[definition]]\nid = \"2\"\nsection = \"1\"\nprinted = \"words\"\n\
                      [[system]]\nid = \"3\"\nsection = \"1\"\nformulation = \"kane\"\nunknowns = []\nmatrix = []\nright = []\n\
                      [[listing]]\nid = \"4\"\nsection = \"1\"\nformulation = \"kane\"\nstate = []\nderivative = []\n\
                      [[initial]]\nid = \"5\"\nsection = \"1\"\nset = \"a\"\nquantity = \"m\"\nprinted = \"1\"\n";

/// A key that is like none.
const ODD: &str = "zzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzz";

/// The keys that a reader knows where an odd one stands.
fn known(errors: &Diagnostics) -> BTreeSet<String> {
    let odd = errors.list.iter().find(|error| error.message.contains(ODD));
    let help =
        odd.unwrap_or_else(|| panic!("nothing is said of an odd key: {errors}")).help.clone().unwrap_or_default();
    let list = help.strip_prefix("known here: ").unwrap_or_else(|| panic!("{help}"));
    list.split(", ").map(|key| key.trim_matches('`').to_owned()).collect()
}

/// The keys that a schema knows at a place.
fn stated(format: SchemaFormat, place: &str) -> BTreeSet<String> {
    let mut schema = format.schema();
    for part in place.split('/').filter(|part| !part.is_empty()) {
        let of_kind = |schema: &Value| schema["anyOf"].as_array().and_then(|kinds| kinds.last().cloned());
        schema = of_kind(&schema).unwrap_or(schema);
        schema = match part {
            "*" => schema["additionalProperties"].clone(),
            "[]" => schema["items"].clone(),
            key => schema["properties"][key].clone(),
        };
        schema = of_kind(&schema).unwrap_or(schema);
    }
    let keys = schema["properties"].as_object().unwrap_or_else(|| panic!("no table at {place}: {schema}"));
    keys.keys().cloned().collect()
}

/// An odd key in each table of a text that a place of the schema is of: the keys that the reader knows in any of them.
fn known_at(text: &str, marks: &[&str], read: &dyn Fn(&str) -> Diagnostics) -> BTreeSet<String> {
    let mut all = BTreeSet::new();
    for mark in marks {
        assert!(text.contains(mark), "{mark}");
        let odd = if mark.ends_with('{') { format!("{mark} {ODD} = 1, ") } else { format!("{mark}\n{ODD} = 1\n") };
        all.extend(known(&read(&text.replacen(mark, &odd, 1))));
    }
    all
}

/// Goal: schemas and readers know the same keys. Method: an unknown key in a table of each kind; readers then list the
/// keys that they know.
#[test]
fn schemas_state_the_keys_that_readers_know() {
    let of_model = |text: &str| load(&Source::from_text("model.toml", text)).map(|_| ()).unwrap_err();
    load(&Source::from_text("model.toml", MODEL)).unwrap_or_else(|errors| panic!("{errors}"));
    let model: &[(&str, &[&str])] = &[
        ("", &["# the file"]),
        ("parameters/*", &["m = {"]),
        ("expressions/*", &["J = {"]),
        ("coordinates/*", &["x = {"]),
        ("inertial", &["[inertial]"]),
        ("frames/*", &["B = {", "C = {", "E = {"]),
        ("points/*", &["P = {"]),
        ("bodies/*", &["[bodies.rod]"]),
        ("bodies/*/inertia", &["inertia = {"]),
        ("joints/*", &["pin = {", "again = {", "screw = {", "cardan = {", "ball = {"]),
        ("particles/*", &["bead = {"]),
        ("gravity", &["[gravity]"]),
        ("forces/*", &["[forces.push]"]),
        ("torques/*", &["[torques.drive]"]),
        ("springs/*", &["[springs.band]"]),
        ("friction/*", &["rub = {", "turn = {"]),
        ("potentials/*", &["field = {"]),
        ("inputs/*", &["F = {"]),
        ("reactions/*", &["[reactions.rail]"]),
        ("constraints/*", &["[constraints.tie]"]),
        ("rolling/*", &["[rolling.wheel]"]),
        ("shapes/*", &["globe = {", "plate = {", "drum = {", "crate = {", "cord = {", "floor = {"]),
    ];
    for (place, marks) in model {
        let mut keys = stated(SchemaFormat::Model, place);
        // Repetition is written out before the file is read.
        keys.remove("counts");
        assert_eq!(known_at(MODEL, marks, &of_model), keys, "{place}");
    }
    let mut mechanism = load(&Source::from_text("model.toml", PENDULUM)).unwrap_or_else(|errors| panic!("{errors}"));
    let scenes: &[(&str, &[&str])] = &[
        ("", &["# the file"]),
        ("inputs/*", &["F = {"]),
        ("outputs/[]", &["outputs = [{"]),
        ("integration", &["[integration]"]),
        ("impacts/*", &["[impacts.floor]"]),
        ("events/[]", &["[[events]]"]),
        ("figures/[]", &["[[figures]]"]),
    ];
    for (place, marks) in scenes {
        let keys = known_at(SCENE, marks, &|text| {
            let source = Source::from_text("scene.toml", text);
            scene::load(&source, &mut mechanism.clone()).map(|_| ()).unwrap_err()
        });
        assert_eq!(keys, stated(SchemaFormat::Scene, place), "{place}");
    }
    let state = format!("{ODD} = 1\n[state]\n");
    let errors =
        load_state_with_unknowns(&Source::from_text("state.toml", &state), &mut mechanism.clone(), &[]).unwrap_err();
    assert_eq!(known(&errors), stated(SchemaFormat::State, ""));
    for (place, mark) in [
        ("equation", "[[equation]]"),
        ("definition", "[[definition]]"),
        ("system", "[[system]]"),
        ("listing", "[[listing]]"),
        ("initial", "[[initial]]"),
    ] {
        let text = PUBLICATION.replace(mark, &format!("{mark}\n{ODD} = 1"));
        let errors =
            publication::load_publication(&Source::from_text("publication.toml", &text), &mut mechanism).unwrap_err();
        assert_eq!(known(&errors), stated(SchemaFormat::Publication, &format!("{place}/[]")), "{place}");
    }
    let errors = publication::load_publication(
        &Source::from_text("publication.toml", &format!("{ODD} = 1\n{PUBLICATION}")),
        &mut mechanism,
    )
    .unwrap_err();
    assert_eq!(known(&errors), stated(SchemaFormat::Publication, ""));
}

/// Goal: a schema sees what is wrong in form. Method: a wrong key, kind, word and number in right files.
#[test]
fn the_schemas_refuse_wrong_forms() {
    assert_eq!(objection(SchemaFormat::Model, MODEL), None);
    assert_eq!(objection(SchemaFormat::Scene, SCENE), None);
    for (right, wrong) in [
        ("[inertial]", "[inertail]"),
        ("kind = \"screw\"", "kind = \"skrew\""),
        ("position = [0, 0, 0]", "position = [0, 0]"),
        ("# the file", "schema = 99"),
        ("mass = \"m\"\ninertia", "mass = true\ninertia"),
    ] {
        assert!(MODEL.contains(right), "{right}");
        assert!(objection(SchemaFormat::Model, &MODEL.replacen(right, wrong, 1)).is_some(), "{wrong}");
    }
    for (right, wrong) in [("span = [0, 1]", ""), ("\"dop853\"", "\"ode23\""), ("\"falling\"", "\"down\"")] {
        assert!(SCENE.contains(right), "{right}");
        assert!(objection(SchemaFormat::Scene, &SCENE.replacen(right, wrong, 1)).is_some(), "{wrong}");
    }
}
