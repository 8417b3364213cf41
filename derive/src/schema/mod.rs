//! JSON Schemas of the files that people write (models, scenes, states, publications), for editors.
//!
//! For each format, a table states the keys that its reader accepts, their kinds of values and their meanings. A test
//! compares the keys with those that the readers know. A schema describes only the form of a file. The readers check
//! names, units and mathematics.
//!
//! Editors of TOML support JSON Schema, draft 7 (`https://json-schema.org/draft-07`).

mod model;
mod publication;
mod scene;

use crate::toml_reader::SCHEMA;
use serde_json::{Map, Value, json};

/// Format of a file that people write: model, scene, state or publication.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SchemaFormat {
    /// Format of a mechanism, in the file `model.toml`.
    Model,
    /// Format of a scene: the parameters, start and span of a run.
    Scene,
    /// Format of a state: a single instant whose values are given or solved for.
    State,
    /// Format of a printed derivation, in the file `publication.toml`.
    Publication,
}

impl SchemaFormat {
    /// All formats, in the order in which commands list them.
    pub const ALL: [Self; 4] = [Self::Model, Self::Scene, Self::State, Self::Publication];

    /// Name of the format on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Model => "model",
            Self::Scene => "scene",
            Self::State => "state",
            Self::Publication => "publication",
        }
    }

    /// Title of the format's JSON schema.
    const fn title(self) -> &'static str {
        match self {
            Self::Model => "Tripos model: a mechanism",
            Self::Scene => "Tripos scene: what to run",
            Self::State => "Tripos state: one instant, given or sought",
            Self::Publication => "Tripos publication: a printed derivation",
        }
    }

    /// Keys that files of the format may have at their top level.
    const fn keys(self) -> &'static [Key] {
        match self {
            Self::Model => model::KEYS,
            Self::Scene => scene::KEYS,
            Self::State => scene::STATE_KEYS,
            Self::Publication => publication::KEYS,
        }
    }

    /// JSON Schema (draft 7) of the format.
    #[must_use]
    pub fn schema(self) -> Value {
        let mut schema = table_schema(self.keys());
        schema["$schema"] = json!("http://json-schema.org/draft-07/schema#");
        schema["title"] = json!(self.title());
        schema["$comment"] = json!(format!("version {SCHEMA} of the format"));
        schema
    }
}

/// Key of a TOML table: its name, the kind of its value, and its meaning.
pub(crate) struct Key {
    /// Name of the key in the file.
    name: &'static str,
    /// Kind of value that the key accepts.
    kind: Kind,
    /// True if the key is required; false if it may be absent.
    is_needed: bool,
    /// Meaning of the key, shown by editors as its description.
    about: &'static str,
}

/// Kind of value that a key of a TOML file accepts.
#[derive(Clone, Copy)]
pub(crate) enum Kind {
    /// Prose: any string.
    Text,
    /// Number, or a formula in quotes.
    Formula,
    /// Array of three formulas, such as the components of a vector.
    Vector,
    /// Boolean: true or false.
    Flag,
    /// Whole number that is at least the given minimum.
    Whole(u32),
    /// Number of an axis: 1, 2 or 3.
    Axis,
    /// Text that is one of the listed words.
    Word(&'static [&'static str]),
    /// Version number of the file format.
    Version,
    /// Array of values of the given kind.
    List(&'static Kind),
    /// Table whose keys are free names, with values of the given kind.
    Named(&'static Kind),
    /// Table that accepts only the given keys.
    Table(&'static [Key]),
    /// Value of any of the given kinds.
    Either(&'static [Kind]),
}

/// Creates an optional key: its name, the kind of its value, and its description.
pub(crate) const fn optional_key(name: &'static str, kind: Kind, about: &'static str) -> Key {
    Key { name, kind, is_needed: false, about }
}

/// Creates a required key: its name, the kind of its value, and its description.
pub(crate) const fn required_key(name: &'static str, kind: Kind, about: &'static str) -> Key {
    Key { name, kind, is_needed: true, about }
}

/// Key `schema` for the version of the file format. Every format accepts it.
pub(crate) const VERSION: Key = optional_key("schema", Kind::Version, "the version of the format");

/// Key `about` for a line of prose. Most entries accept it.
pub(crate) const ABOUT: Key = optional_key("about", Kind::Text, "a line of text for the reader");

/// JSON Schema of a TOML table that accepts only the given keys.
fn table_schema(keys: &[Key]) -> Value {
    let mut properties = Map::new();
    for key in keys {
        let mut value = key.kind.schema();
        value["description"] = json!(key.about);
        properties.insert(key.name.to_owned(), value);
    }
    let needed: Vec<&str> = keys.iter().filter(|key| key.is_needed).map(|key| key.name).collect();
    let mut schema = json!({ "type": "object", "properties": properties, "additionalProperties": false });
    if !needed.is_empty() {
        schema["required"] = json!(needed);
    }
    schema
}

impl Kind {
    /// JSON Schema of a value of this kind, as a JSON object.
    fn schema(self) -> Value {
        match self {
            Self::Text => json!({ "type": "string" }),
            Self::Formula => json!({ "type": ["number", "string"] }),
            Self::Vector => json!({ "type": "array", "items": Self::Formula.schema(), "minItems": 3, "maxItems": 3 }),
            Self::Flag => json!({ "type": "boolean" }),
            Self::Whole(least) => json!({ "type": "integer", "minimum": least }),
            Self::Axis => json!({ "enum": [1, 2, 3] }),
            Self::Word(words) => json!({ "enum": words }),
            Self::Version => json!({ "type": "integer", "minimum": 1, "maximum": SCHEMA }),
            Self::List(of) => json!({ "type": "array", "items": of.schema() }),
            Self::Named(of) => json!({ "type": "object", "additionalProperties": of.schema() }),
            Self::Table(keys) => table_schema(keys),
            Self::Either(kinds) => {
                json!({ "anyOf": kinds.iter().map(|kind| kind.schema()).collect::<Vec<Value>>() })
            }
        }
    }
}
