//! Comparison of two scene files key by key, as written.

use crate::diagnostic::{Diagnostic, Diagnostics, Source};
use crate::toml_reader::TomlReader;
use toml::{Table, Value};

/// Key of a scene file whose value differs between an old and a new file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SettingChange {
    /// Path of the key in the file, such as `start.q1`.
    pub key: String,
    /// Old value of the key as TOML text; `None` if the key is new.
    pub old: Option<String>,
    /// New value of the key as TOML text; `None` if the key was removed.
    pub new: Option<String>,
}

/// Lists the keys whose values differ between two scene files, in alphabetical order.
/// Titles and remarks are not compared, because no number depends on them.
///
/// # Errors
/// [`Diagnostics`] if a file is not TOML.
pub fn diff_scenes(old: &Source, new: &Source) -> Result<Vec<SettingChange>, Diagnostics> {
    let (old, new) = (scene_settings(old)?, scene_settings(new)?);
    let find = |list: &[(String, String)], key: &str| list.iter().find(|(k, _)| k == key).map(|(_, v)| v.clone());
    let mut keys: Vec<&String> = old.iter().chain(&new).map(|(key, _)| key).collect();
    keys.sort();
    keys.dedup();
    let settings =
        keys.into_iter().map(|key| SettingChange { key: key.clone(), old: find(&old, key), new: find(&new, key) });
    Ok(settings.filter(|setting| setting.old != setting.new).collect())
}

/// Keys of a TOML file with their values as text. Tables are flattened to paths, and titles and remarks are left out.
///
/// # Errors
/// `Diagnostics` if the file is not TOML.
fn scene_settings(source: &Source) -> Result<Vec<(String, String)>, Diagnostics> {
    TomlReader::parse(source)?;
    let table: Table = source.text.parse().map_err(|error: toml::de::Error| {
        Diagnostics::new(source.clone(), vec![Diagnostic::of_file(error.message(), "the file must be valid TOML")])
    })?;
    let mut list = Vec::new();
    let mut open = vec![(String::new(), Value::Table(table))];
    while let Some((path, value)) = open.pop() {
        match value {
            Value::Table(table) => {
                let within = |key: String| if path.is_empty() { key } else { format!("{path}.{key}") };
                let said = table.into_iter().filter(|(key, _)| !["title", "about", "caption"].contains(&key.as_str()));
                open.extend(said.map(|(key, value)| (within(key), value)));
            }
            Value::Float(x) => list.push((path, scene_number_text(x))),
            other => list.push((path, other.to_string())),
        }
    }
    Ok(list)
}

/// Text of a number as a user would write it: 1 for 1.0, and 1e-9 for 0.000000001.
fn scene_number_text(x: f64) -> String {
    if x.fract() == 0.0 && x.abs() < 1e15 { format!("{x}") } else { format!("{x:?}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_of_tables_are_compared_each_and_numbers_by_value() {
        let of = |text: &str| Source::from_text("scene.toml", text);
        let old = of("title = \"a\"\nspan = [0, 1]\nintegration = { rtol = 1.0, step = 2 }\n");
        let new = of("title = \"b\"\nintegration = { rtol = 1, step = \"h\" }\n[start]\nq = 1e-9\n");
        let list = diff_scenes(&old, &new).unwrap();
        let said: Vec<_> = list.iter().map(|s| (s.key.as_str(), s.old.as_deref(), s.new.as_deref())).collect();
        let expected = [
            ("integration.step", Some("2"), Some("\"h\"")),
            ("span", Some("[0, 1]"), None),
            ("start.q", None, Some("1e-9")),
        ];
        assert_eq!(said, expected);
        assert!(diff_scenes(&old, &of("span = [")).is_err());
    }
}
