//! Descriptions of a model as one file, without equations, such as a robot description in URDF.

use super::module_identifier_word;
use crate::emit::{Emission, ReplacedFiles};
use crate::origin::{EMIT, Origin, model_name_of_origin};
use std::collections::BTreeMap;
use tripos_derive::Model;

/// Generates a description of a model as one file, `NAME.EXTENSION`. The extension is the first of `extensions`. `text`
/// makes the file's text from the header sentence, which the text must contain in a comment at its head.
pub fn emit_description(
    model: &Model,
    extensions: &'static [&'static str],
    text: impl FnOnce(&str) -> String,
) -> Emission {
    let origin = Origin::origin_of_model_file(&model.source.path, EMIT);
    let name = module_identifier_word(model_name_of_origin(&origin));
    let file = format!("{name}.{}", extensions.first().copied().unwrap_or("txt"));
    let files = BTreeMap::from([(file, text(&origin.model_origin_sentence()))]);
    let replaced = ReplacedFiles::All;
    Emission { files, left_out: Vec::new(), command: EMIT, extensions, replaced }
}
