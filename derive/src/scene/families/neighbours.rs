//! Neighbours of a scene, from which derivatives of its start along one of its numbers are computed.
//!
//! Invariant: every number that depends on the changed number follows it to 32 digits: formulas, speeds from rates, and
//! coordinates that close loops.

use crate::diagnostic::{Diagnostic, Diagnostics, Source};
use crate::model::{Model, Unit};
use crate::read::Reader;
use crate::scene::numbers::values::{Number, Terms, ValueReader, Varied, doubles};
use crate::scene::starts::state::Start;
use crate::scene::{Exact, InitialMotion, Numbers, Scene};
use toml::Spanned;
use toml::de::DeTable;
use tripos_traits::DoubleDouble;

/// A scene that is read again for other values of one of its numbers.
pub struct Nearby<'a> {
    scene: &'a Scene,
    table: Spanned<DeTable<'a>>,
    model: Model,
    terms: Terms,
    set: Vec<(Varied, Number)>,
    place: Varied,
    value: DoubleDouble,
}

impl<'a> Nearby<'a> {
    /// Scenes near `scene` for other values of the number `name`. The numbers `set` have other values than in the
    /// scene's file.
    ///
    /// # Errors
    /// [`Diagnostics`] for a name that is no parameter and that the start does not state.
    pub fn new(scene: &'a Scene, model: &Model, set: &[(String, f64)], name: &str) -> Result<Self, Diagnostics> {
        let mut model = model.clone();
        let source = Source::from_text("what is differentiated by", name);
        let mut values = ValueReader::new(Reader::new(&source), &mut model);
        let place = values.place(name, 0..name.len(), scene);
        let others: Vec<_> =
            set.iter().filter_map(|(name, value)| Some((values.place(name, 0..0, scene)?, *value))).collect();
        if scene.closed.iter().any(|closed| closed.name == name) {
            let help = "take a number that the start states";
            values.reader.error(0..name.len(), format!("`{name}` is solved for at the start"), help);
        }
        values.reader.finish()?;
        let place = place.expect("reported if there is none");
        let (_, table) = Reader::parse(&scene.source)?;
        let set = others.into_iter().filter(|(other, _)| *other != place);
        let set = set.map(|(place, value)| (place, Number::rounded(value))).collect();
        let value = of(&scene.exact, place);
        Ok(Self { scene, table, model, terms: Terms::default(), set, place, value })
    }

    /// Value of the number that changes in the scene itself, to 32 digits.
    #[must_use]
    pub fn value(&self) -> DoubleDouble {
        self.value
    }

    /// Unit of the number that changes.
    #[must_use]
    pub fn unit(&self) -> Unit {
        match self.place {
            Varied::Parameter(at) => self.model.parameters[at].unit.clone(),
            Varied::Coordinate(at) => self.model.coordinates[at].unit.clone(),
            Varied::Rate(at) => self.model.coordinates[at].unit.per_second(),
            Varied::Speed(at) => self.model.speeds[at].unit.clone(),
        }
    }

    /// The scene with this value of the changed number: its parameters, start, span and coefficients of contacts
    /// follow.
    ///
    /// # Errors
    /// [`Diagnostics`] if no such scene exists, for example because a mass is negative.
    pub fn at(&mut self, value: DoubleDouble) -> Result<Scene, Diagnostics> {
        let given: Vec<_> = self.set.iter().cloned().chain([(self.place, Number::wide(value))]).collect();
        let mut values = ValueReader {
            reader: Reader::new(&self.scene.source),
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
        let Numbers { p, start: Start { q, u, exact, closed }, span, coefficients, .. } = numbers;
        let missing = || Diagnostics::new(self.scene.source.clone(), vec![Diagnostic::of_file("no span", "give one")]);
        let span = span.ok_or_else(missing)?;
        let impacts = self.scene.impacts.iter().zip(&coefficients).map(|(impact, of)| impact.with(of)).collect();
        Ok(Scene { parameters: doubles(&p), q, u, exact, closed, span, impacts, ..self.scene.clone() })
    }
}

/// A parameter, or a number of a start, to 32 digits.
fn of(exact: &Exact, place: Varied) -> DoubleDouble {
    match (place, &exact.motion) {
        (Varied::Parameter(at), _) => exact.parameters[at],
        (Varied::Coordinate(at), _) => exact.q[at],
        (Varied::Rate(at) | Varied::Speed(at), InitialMotion::Rates(list) | InitialMotion::Speeds(list)) => list[at],
    }
}
