//! Neighbours of a scene: the same scene with another value of a single number. Derivatives of a start with respect
//! to that number are computed from them.
//!
//! Invariant: everything that depends on the changed number follows it to 32 digits. This holds for formulas, for
//! speeds computed from rates, and for coordinates that close loops.

use crate::diagnostic::{Diagnostic, Diagnostics, Source};
use crate::model::{Model, Unit};
use crate::scene::numbers::number_reader::{ParsedFormulas, ValueReader, VariedNumber};
use crate::scene::numbers::scene_number::{Number, double_values};
use crate::scene::starts::state::Start;
use crate::scene::{ExactStart, InitialMotion, Scene, SceneNumbers};
use crate::toml_reader::TomlReader;
use toml::Spanned;
use toml::de::DeTable;
use tripos_traits::DoubleDouble;

/// Neighbours of a scene: reads the scene again for other values of a single number.
pub struct SceneNeighbours<'a> {
    /// Scene whose neighbours are read.
    scene: &'a Scene,
    /// Parsed TOML table of the scene file.
    table: Spanned<DeTable<'a>>,
    /// Model of the scene; its arena receives the terms of formulas.
    model: Model,
    /// Parsed formulas of the scene file, kept for the next reading.
    terms: ParsedFormulas,
    /// Numbers that replace those of the file in every neighbour, each with its value.
    set: Vec<(VariedNumber, Number)>,
    /// Number whose value changes, by its index in the model.
    place: VariedNumber,
    /// Value of the changed number in the scene itself, to 32 digits.
    value: DoubleDouble,
}

impl<'a> SceneNeighbours<'a> {
    /// Creates the neighbours of `scene` for other values of the number `name`. The numbers `set`, as (name, value),
    /// replace those of the scene's file in every neighbour.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] if a name is no parameter and no start value of the scene, or if the start value
    /// `name` is solved for.
    pub fn new(scene: &'a Scene, model: &Model, set: &[(String, f64)], name: &str) -> Result<Self, Diagnostics> {
        let mut model = model.clone();
        let source = Source::from_text("what is differentiated by", name);
        let mut values = ValueReader::new(TomlReader::new(&source), &mut model);
        let place = values.varied_number(name, 0..name.len(), scene);
        let others: Vec<_> =
            set.iter().filter_map(|(name, value)| Some((values.varied_number(name, 0..0, scene)?, *value))).collect();
        if scene.closed.iter().any(|closed| closed.name == name) {
            let help = "take a number that the start states";
            values.reader.error(0..name.len(), format!("`{name}` is solved for at the start"), help);
        }
        values.reader.finish()?;
        let place = place.expect("reported if there is none");
        let (_, table) = TomlReader::parse(&scene.source)?;
        let set = others.into_iter().filter(|(other, _)| *other != place);
        let set = set.map(|(place, value)| (place, Number::from_double(value))).collect();
        let value = exact_scene_number(&scene.exact, place);
        Ok(Self { scene, table, model, terms: ParsedFormulas::default(), set, place, value })
    }

    /// Value of the changed number in the scene itself, to 32 digits, in SI units.
    #[must_use]
    pub fn value(&self) -> DoubleDouble {
        self.value
    }

    /// Unit of the changed number.
    #[must_use]
    pub fn unit(&self) -> Unit {
        match self.place {
            VariedNumber::Parameter(at) => self.model.parameters[at].unit.clone(),
            VariedNumber::Coordinate(at) => self.model.coordinates[at].unit.clone(),
            VariedNumber::Rate(at) => self.model.coordinates[at].unit.per_second(),
            VariedNumber::Speed(at) => self.model.speeds[at].unit.clone(),
        }
    }

    /// Reads the neighbour in which the changed number has the given value. Parameters, start, span and contact
    /// coefficients that depend on it change too.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] if no scene with this value exists, for example because a mass is negative.
    pub fn at(&mut self, value: DoubleDouble) -> Result<Scene, Diagnostics> {
        let given: Vec<_> = self.set.iter().cloned().chain([(self.place, Number::from_double_double(value))]).collect();
        let mut values = ValueReader {
            reader: TomlReader::new(&self.scene.source),
            model: &mut self.model,
            terms: std::mem::take(&mut self.terms),
            given: &given,
            instant: None,
            names: Vec::new(),
            is_wide: true,
        };
        let numbers = values.scene_numbers(self.table.get_ref());
        self.terms = values.terms;
        values.reader.finish()?;
        let SceneNumbers { p, start: Start { q, u, exact, closed, .. }, span, coefficients, .. } = numbers;
        let missing = || Diagnostics::new(self.scene.source.clone(), vec![Diagnostic::of_file("no span", "give one")]);
        let span = span.ok_or_else(missing)?;
        let impacts =
            self.scene.impacts.iter().zip(&coefficients).map(|(impact, of)| impact.with_coefficients(of)).collect();
        Ok(Scene { parameters: double_values(&p), q, u, exact, closed, span, impacts, ..self.scene.clone() })
    }
}

/// Value of a parameter or start value of a scene, to 32 digits.
fn exact_scene_number(exact: &ExactStart, place: VariedNumber) -> DoubleDouble {
    match (place, &exact.motion) {
        (VariedNumber::Parameter(at), _) => exact.parameters[at],
        (VariedNumber::Coordinate(at), _) => exact.q[at],
        (
            VariedNumber::Rate(at) | VariedNumber::Speed(at),
            InitialMotion::Rates(list) | InitialMotion::Speeds(list),
        ) => list[at],
    }
}
