//! Family of scenes: a scene file, read again for many values of its numbers.
//!
//! Invariant: a member equals the scene of a file that states the member's values, including formulas in swept
//! parameters. The same code reads both, and the file is parsed only once.

use super::sweep_grid::Grid;
use crate::diagnostic::Diagnostics;
use crate::model::Model;
use crate::scene::numbers::number_reader::{ParsedFormulas, ValueReader, VariedNumber};
use crate::scene::numbers::scene_number::{Number, double_values};
use crate::scene::starts::state::Start;
use crate::scene::{Integration, Scene, SceneNumbers};
use crate::toml_reader::TomlReader;
use toml::Spanned;
use toml::de::DeTable;

/// Family of scenes: a scene for every point of a sweep's grid.
pub struct Family<'a> {
    /// Scene from which all members derive.
    scene: &'a Scene,
    /// Grid of the numbers that vary, a point for each member.
    grid: &'a Grid,
    /// Parsed TOML table of the scene file.
    table: Spanned<DeTable<'a>>,
    /// Model of the scene; its arena receives the terms of formulas.
    model: Model,
    /// Parsed formulas of the scene file, kept for the next member.
    terms: ParsedFormulas,
}

impl<'a> Family<'a> {
    /// Creates the family of a scene of this model, over a grid that was read for this scene.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] if the text of the scene is not TOML. The text of a scene that was loaded always is.
    pub fn new(scene: &'a Scene, model: &Model, grid: &'a Grid) -> Result<Self, Diagnostics> {
        let (_, table) = TomlReader::parse(&scene.source)?;
        Ok(Self { scene, grid, table, model: model.clone(), terms: ParsedFormulas::default() })
    }

    /// Values of the varied numbers at a grid point, as [`Grid::values`] gives them, and the scene with these values.
    /// The scene has no ladder. It is an error if no scene with these values exists, for example because a mass is
    /// negative. The index `point` must be below [`Grid::count`].
    pub fn point(&mut self, point: u64) -> (Vec<f64>, Result<Scene, Diagnostics>) {
        let given = self.grid.numbers(point);
        (given.iter().map(|(_, number)| number.double).collect(), self.scene(&given))
    }

    /// Reads the scene with the given numbers in place of the file's numbers. Returns `Diagnostics` if no such scene
    /// exists.
    fn scene(&mut self, given: &[(VariedNumber, Number)]) -> Result<Scene, Diagnostics> {
        let mut values = ValueReader {
            reader: TomlReader::new(&self.scene.source),
            model: &mut self.model,
            terms: std::mem::take(&mut self.terms),
            given,
            instant: None,
            names: Vec::new(),
            is_wide: false,
        };
        let numbers = values.scene_numbers(self.table.get_ref());
        self.terms = values.terms;
        values.reader.finish()?;
        let SceneNumbers { p, start: Start { q, u, exact, closed, .. }, span, integration, coefficients, .. } = numbers;
        let span = span.expect("reported if missing");
        let parameters = double_values(&p);
        let impacts =
            self.scene.impacts.iter().zip(&coefficients).map(|(impact, of)| impact.with_coefficients(of)).collect();
        // Instants are set by a program, and stand in no file.
        let integration = Integration { instants: self.scene.integration.instants.clone(), ..integration };
        Ok(Scene { parameters, q, u, exact, closed, span, integration, impacts, ladder: None, ..self.scene.clone() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Source;
    use crate::scene::load;

    const MODEL: &str = include_str!("../../model/pendulum.toml");
    const SCENE: &str = "span = [0, \"10*sqrt(l/g)\"]\n[parameters]\nl = 2\n[start]\ntheta = \"90*deg\"\n\
                         omega = \"sqrt(g/l)\"\n[integration]\nrtol = \"l/1000\"\ndistance = { theta = \"90*deg\" }\n";

    /// Goal: a member is the scene with the member's numbers. Method: the same file, edited, is read as any scene.
    #[test]
    fn a_member_is_the_scene_that_says_its_values() {
        let mut model = crate::model::load(&Source::from_text("model.toml", MODEL)).unwrap();
        let scene = load(&Source::from_text("scene.toml", SCENE), &mut model).unwrap();
        let over = ["l=1:3:4".to_owned(), "theta=80*deg,90*deg-1e-9,sqrt(2)".to_owned()];
        let grid = Grid::read(&over, "--over", &scene, &mut model).unwrap();
        let mut family = Family::new(&scene, &model, &grid).unwrap();
        let lengths = ["1", "1 + 2*1/3", "1 + 2*2/3", "3"];
        let angles = ["80*deg", "90*deg-1e-9", "sqrt(2)"];
        for (at, (length, angle)) in lengths.iter().flat_map(|l| angles.map(|a| (l, a))).enumerate() {
            let text = SCENE.replace("l = 2", &format!("l = \"{length}\"")).replacen("90*deg", angle, 1);
            let edited = load(&Source::from_text("scene.toml", &text), &mut model).unwrap();
            let member = family.point(at as u64).1.unwrap();
            assert_eq!((member.parameters, member.q, member.u), (edited.parameters, edited.q, edited.u), "point {at}");
            assert_eq!((member.exact, member.span), (edited.exact, edited.span), "point {at}");
            assert_eq!(member.integration, edited.integration, "point {at}");
        }
    }

    /// Goal: no member depends on the members that were read before it. Method: points are read in other orders.
    #[test]
    fn points_may_be_read_in_any_order() {
        let mut model = crate::model::load(&Source::from_text("model.toml", MODEL)).unwrap();
        let scene = load(&Source::from_text("scene.toml", SCENE), &mut model).unwrap();
        let grid =
            Grid::read(&["l=-1:1:3".to_owned(), "omega=1:2:5".to_owned()], "--over", &scene, &mut model).unwrap();
        let mut family = Family::new(&scene, &model, &grid).unwrap();
        let numbers = |scene: Result<Scene, Diagnostics>| scene.map(|s| (s.parameters, s.u, s.span));
        let forward: Vec<_> = (0..15).map(|at| numbers(family.point(at).1)).collect();
        for at in (0..15).rev() {
            let fresh = Family::new(&scene, &model, &grid).unwrap().point(at).1;
            let at = usize::try_from(at).unwrap();
            assert_eq!(numbers(family.point(at as u64).1), forward[at]);
            assert_eq!(numbers(fresh), forward[at]);
        }
        assert!(forward[..5].iter().all(|p| p.as_ref().is_err_and(|e| e.list[0].message.contains("positive"))));
        assert!(forward[10..].iter().all(Result::is_ok));
    }
}
