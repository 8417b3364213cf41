//! JSON Schemas of the files that people write, for editors: their keys, with kinds and meanings.
//!
//! The tables beside this file state for each format what its reader accepts; a test compares their keys with those
//! that the readers know. A schema describes form. The meaning of names, units and mathematics are checked by the
//! readers.
//!
//! JSON Schema, draft 7, which editors of TOML know (<https://json-schema.org/draft-07>).

mod model;
mod publication;
mod scene;

use crate::read::SCHEMA;
use serde_json::{Map, Value, json};

/// Format of the files that people write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// A mechanism, `model.toml`.
    Model,
    /// A run of a mechanism.
    Scene,
    /// A state: one instant, given or sought.
    State,
    /// A published derivation, `publication.toml`.
    Publication,
}

impl Format {
    /// All formats, in the order of every list of them.
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

    const fn title(self) -> &'static str {
        match self {
            Self::Model => "Tripos model: a mechanism",
            Self::Scene => "Tripos scene: what to run",
            Self::State => "Tripos state: one instant, given or sought",
            Self::Publication => "Tripos publication: a printed derivation",
        }
    }

    const fn keys(self) -> &'static [Key] {
        match self {
            Self::Model => model::KEYS,
            Self::Scene => scene::KEYS,
            Self::State => scene::STATE_KEYS,
            Self::Publication => publication::KEYS,
        }
    }

    /// The JSON Schema of the format.
    #[must_use]
    pub fn schema(self) -> Value {
        let mut schema = table(self.keys());
        schema["$schema"] = json!("http://json-schema.org/draft-07/schema#");
        schema["title"] = json!(self.title());
        schema["$comment"] = json!(format!("version {SCHEMA} of the format"));
        schema
    }
}

/// Key of a TOML table, with the kind of its value and its meaning.
pub(crate) struct Key {
    name: &'static str,
    kind: Kind,
    is_needed: bool,
    about: &'static str,
}

/// Kind of value that may stand under a key.
#[derive(Clone, Copy)]
pub(crate) enum Kind {
    /// A text in words.
    Text,
    /// A number, or mathematics in quotes.
    Formula,
    /// Three formulas.
    Vector,
    /// True or false.
    Flag,
    /// A whole number that is at least this.
    Whole(u32),
    /// The number of an axis: 1, 2 or 3.
    Axis,
    /// A text that is one of these words.
    Word(&'static [&'static str]),
    /// The version number of the format.
    Version,
    /// A list of values of this kind.
    List(&'static Kind),
    /// A table whose keys are names, and whose values are of this kind.
    Named(&'static Kind),
    /// A table with these keys.
    Table(&'static [Key]),
    /// A value of one of these kinds.
    Either(&'static [Kind]),
}

/// Creates a key that may be absent.
pub(crate) const fn key(name: &'static str, kind: Kind, about: &'static str) -> Key {
    Key { name, kind, is_needed: false, about }
}

/// Creates a key that must be there.
pub(crate) const fn needed(name: &'static str, kind: Kind, about: &'static str) -> Key {
    Key { name, kind, is_needed: true, about }
}

/// Key that states the version of the format, which every format may have.
pub(crate) const VERSION: Key = key("schema", Kind::Version, "the version of the format");

/// Key for a line of text, which every entry may have.
pub(crate) const ABOUT: Key = key("about", Kind::Text, "a line of text for the reader");

fn table(keys: &[Key]) -> Value {
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
            Self::Table(keys) => table(keys),
            Self::Either(kinds) => {
                json!({ "anyOf": kinds.iter().map(|kind| kind.schema()).collect::<Vec<Value>>() })
            }
        }
    }
}
