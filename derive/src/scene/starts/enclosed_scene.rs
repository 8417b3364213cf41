//! Numbers of a scene as balls that provably contain them, for rigorous runs.

use super::start::EnclosedStart;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::Model;
use crate::scene::Scene;
use crate::scene::numbers::number_reader::{ParsedFormulas, ValueReader};
use crate::scene::numbers::scene_number::Number;
use crate::toml_reader::TomlReader;
use tripos_traits::Ball;

/// Start and span of a scene as balls that contain the numbers of its file, such as π/3 or 0.1.
#[derive(Clone, Debug)]
pub struct EnclosedScene {
    /// Parameters and start of the scene.
    pub start: EnclosedStart,
    /// First and last instant of the span, s.
    pub span: (Ball, Ball),
}

/// Reads the numbers of a scene again, as balls. The numbers `set`, as (name, value), replace those of the scene's
/// file. A number that is solved for has a ball with infinite radius if the solution is not proved.
///
/// # Errors
/// Returns [`Diagnostics`] if a name is no parameter and no start value of the scene.
pub fn enclosed_scene(scene: &Scene, model: &Model, set: &[(String, f64)]) -> Result<EnclosedScene, Diagnostics> {
    let mut model = model.clone();
    let (_, table) = TomlReader::parse(&scene.source)?;
    let mut given = Vec::new();
    for (name, value) in set {
        let mut names = ValueReader::new(TomlReader::new(&scene.source), &mut model);
        given.extend(names.varied_number(name, 0..0, scene).map(|place| (place, Number::from_double(*value))));
        names.reader.finish()?;
    }
    let mut values = ValueReader {
        reader: TomlReader::new(&scene.source),
        model: &mut model,
        terms: ParsedFormulas::default(),
        given: &given,
        instant: None,
        names: Vec::new(),
        is_wide: true,
    };
    let numbers = values.scene_numbers(table.get_ref());
    values.reader.finish()?;
    let missing = || Diagnostics::new(scene.source.clone(), vec![Diagnostic::of_file("no span", "give one")]);
    let span = numbers.enclosed_span.ok_or_else(missing)?;
    Ok(EnclosedScene { start: numbers.start.enclosed, span })
}
