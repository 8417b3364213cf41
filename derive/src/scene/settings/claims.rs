//! Claims about a motion, such as `N > 0`, from scene files and from other texts.

use crate::algebra::Expr;
use crate::algebra::term::calculus::Substitution;
use crate::diagnostic::{Diagnostics, Source};
use crate::model::Model;
use crate::plain_text::one_line;
use crate::scene::numbers::number_reader::ValueReader;
use crate::scene::settings::outputs::ENERGIES;
use crate::scene::{Scene, SceneOutput};
use crate::toml_reader::{Located, TomlReader};
use toml::de::DeTable;

/// Name of the determinant of a formulation's mass matrix in claims. A quantity of the model with this name takes
/// precedence.
pub const DETERMINANT: &str = "determinant";

/// Advice for a claim that is not understood.
const FORM: &str = "write a claim as FORMULA < FORMULA or FORMULA > FORMULA, such as \"q2 < 90*deg\"";

/// Claim that one quantity stays below another one at all instants of a scene's span.
#[derive(Clone, Debug)]
pub struct SceneClaim {
    /// Claim as it was written.
    pub text: String,
    /// Larger side less smaller side: a term in parameters, q, q̇, u, u̇, reactions, energies and the symbol
    /// [`DETERMINANT`], in the SI unit of the sides. The claim holds where the term is positive.
    pub distance: Expr,
    /// Name of the equations whose motion the claim is about, in the form of the option `--by`; `None` if it is about
    /// the derived equations.
    pub by: Option<String>,
    /// Words of a publication on which the claim decides; empty if the file states none.
    pub printed: String,
    /// Explanation in words; empty if the file states none.
    pub about: String,
}

impl<'a> ValueReader<'a, '_> {
    /// Reads the claims of a scene file with the given outputs. Wrong claims are left out and recorded as errors.
    pub(in crate::scene) fn scene_claims(
        &mut self,
        table: &'a DeTable<'a>,
        outputs: &[SceneOutput],
    ) -> Vec<SceneClaim> {
        let mut claims = Vec::new();
        for (entry, value) in self.scene_entries(table, "claims") {
            self.reader.report_unknown_keys(entry, "a claim", &["claim", "by", "printed", "about"]);
            let text = self.reader.required(entry, "claim", "a claim", &value.span());
            let text = text.and_then(|v| self.reader.string(v, "a claim"));
            let by = self.reader.get(entry, "by").and_then(|v| self.reader.name(v, "`by`"));
            let [printed, about] = ["printed", "about"].map(|key| self.scene_text(entry, key).unwrap_or_default());
            let Some(distance) = text.as_ref().and_then(|text| self.claimed_distance(text, outputs)) else { continue };
            let text = text.map_or_else(String::new, |text| one_line(&text.text));
            claims.push(SceneClaim { text, distance, by: by.map(|by| by.text), printed, about });
        }
        claims
    }

    /// Larger side of a claim less its smaller side. `None` after an error is reported.
    fn claimed_distance(&mut self, text: &Located, outputs: &[SceneOutput]) -> Option<Expr> {
        let signs: Vec<usize> = text.text.match_indices(['<', '>']).map(|(at, _)| at).collect();
        let [at] = signs.as_slice() else {
            self.reader.error(text.span.clone(), format!("the claim `{}` is not understood", text.text), FORM);
            return None;
        };
        if text.text[at + 1..].starts_with('=') {
            self.reader.error(
                text.part(*at..at + 2),
                "a claim has a strict sign: no rigorous run proves equality",
                FORM,
            );
            return None;
        }
        let [left, right] = [text.trimmed(0..*at), text.trimmed(at + 1..text.text.len())];
        let [left, right] = [left, right].map(|side| self.claimed_side(&side, outputs));
        let (larger, smaller) = if text.text[*at..].starts_with('<') { (right?, left?) } else { (left?, right?) };
        Some(self.model.arena.sub(larger, smaller))
    }

    /// Reads one side of a claim: a formula that an output may be, with the names of outputs. `None` after an error is
    /// reported.
    fn claimed_side(&mut self, side: &Located, outputs: &[SceneOutput]) -> Option<Expr> {
        let arena = &mut self.model.arena;
        let own: Vec<(Expr, Expr)> = outputs.iter().map(|o| (arena.symbol(&o.name), o.value)).collect();
        let names: Vec<&str> = outputs.iter().map(|output| output.name.as_str()).collect();
        let others: Vec<&str> = ENERGIES.into_iter().chain([DETERMINANT]).chain(names).collect();
        let formula = self.value_formula_with(side, &others)?;
        Some(Substitution::new(&own).apply(&mut self.model.arena, formula))
    }
}

/// Reads a claim from a text outside a file, such as the command line. The syntax is that of a scene's claims, and the
/// names of the scene's outputs are known.
///
/// # Errors
/// Returns [`Diagnostics`] if the text is no claim, or contains an unknown name.
pub fn load_claim(text: &str, scene: &Scene, model: &mut Model) -> Result<SceneClaim, Diagnostics> {
    let source = Source::from_text("--claim", text);
    let mut values = ValueReader::new(TomlReader::new(&source), model);
    let located = Located { text: text.to_owned(), span: 0..text.len(), exact: true };
    let distance = values.claimed_distance(&located, &scene.outputs);
    values.reader.finish()?;
    let distance = distance.expect("reported if missing");
    Ok(SceneClaim { text: text.to_owned(), distance, by: None, printed: String::new(), about: String::new() })
}
