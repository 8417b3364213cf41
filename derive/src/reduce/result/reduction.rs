//! Reduced equations of a scene, as data.

use super::proof::Proof;
use crate::algebra::term::steps::Definition;
use crate::algebra::text::print;
use crate::algebra::{Arena, Expr, Rational};
use crate::mechanics::Derivation;
use crate::model::{Model, Unit, text_hash};
use crate::reduce::basis::prose::Prose;
use crate::reduce::slices::one_degree::Slope;

/// A variable or parameter of a reduced system, and its value at the start.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Its name in the reduced system.
    pub name: String,
    /// Its symbol there.
    pub symbol: Expr,
    /// Description of the quantity, in words.
    pub about: Prose,
    /// Its unit.
    pub unit: Unit,
    /// Its value in parameters, coordinates and speeds of the whole model.
    pub of_start: Expr,
}

/// Output of a scene, as a value of the reduced system.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its name in the scene.
    pub name: String,
    /// Its value in parameters, constants, time and states of the reduced system.
    pub value: Expr,
}

/// Omission of a reduced system, with reason and proof.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// Omitted quantity.
    pub what: Prose,
    /// Reason why it is not needed.
    pub why: Prose,
    /// Proof that it is not needed, in words.
    pub proof: String,
}

/// Moving frame of a reduction. From a start of the whole model its symmetries lead to a state where the pins are zero;
/// the variables of the reduction are those of the model in that state.
#[derive(Clone, Debug)]
pub struct Turned {
    /// Description of the motions of the frame, in words.
    pub about: Vec<String>,
    /// For each symmetry its components, in parameters, coordinates and speeds of the whole model: one for each
    /// coordinate, then one for each speed.
    pub fields: Vec<Vec<Expr>>,
    /// Terms that are zero in the frame, in coordinates and speeds of the whole model.
    pub pins: Vec<Expr>,
    /// For each pin its slope along each symmetry.
    pub slopes: Vec<Vec<Expr>>,
}

/// Reduced equations of a scene.
#[derive(Clone)]
pub struct Reduction {
    /// The variables and parameters of the reduced system, the momenta among the latter; its store holds all terms.
    pub model: Model,
    /// Its equations, with the same store.
    pub derivation: Derivation,
    /// Integrated variables that depend on one another alone.
    pub states: Vec<Quantity>,
    /// Variables that are integrated along with the states since the outputs need them; no state depends on them.
    pub quadratures: Vec<Quantity>,
    /// Quantities that keep their value at the start.
    pub constants: Vec<Quantity>,
    /// Those of the constants that stand for products of parameters and other constants.
    pub products: Vec<Definition>,
    /// Outputs of the scene.
    pub outputs: Vec<Output>,
    /// The functions of the scene's events, in its order.
    pub events: Vec<Expr>,
    /// The moving frame in which it is written; `None` without one.
    pub frame: Option<Turned>,
    /// Symmetries that leave every shown quantity unchanged, in words, but give no frame since the domain depends on
    /// states that they turn.
    pub kept_by_domain: Vec<String>,
    /// Parameters that are replaced by numbers.
    pub folded: Vec<(String, Rational)>,
    /// Omissions, each with its reason and its proof.
    pub omitted: Vec<Omission>,
    /// Divisors of the reduction: where one is zero, the reduction has no value.
    pub divisors: Vec<Expr>,
    /// True if the energy is a function of the kept variables; otherwise the energies of the equations are 0.
    pub has_energy: bool,
    /// For quadrature, if there is one degree of freedom.
    pub slope: Option<Slope>,
    /// The time since the start, in outputs that are linear in it.
    pub time: Expr,
    /// Proof that the reduction gives the outputs of the whole model; a reduction without proof is never returned.
    pub proof: Proof,
}

impl Reduction {
    /// A hash of everything that the reduced equations depend on: the model's text, the scene's outputs, the numbers
    /// that it fixes, the held momenta, and the origins of distances.
    #[must_use]
    pub fn key(&self) -> String {
        let arena = self.terms();
        let mut text = self.model.text_hash();
        let quantities = self.states.iter().chain(&self.quadratures).chain(&self.constants);
        let names = quantities.map(|q| format!("{} = {}", q.name, print::text(arena, q.of_start)));
        let outputs = self.outputs.iter().map(|o| format!("{}: {}", o.name, print::whole_text(arena, o.value)));
        let folded = self.folded.iter().map(|(name, value)| format!("{name} = {}", value.to_big()));
        let pins =
            self.frame.iter().flat_map(|frame| &frame.pins).map(|pin| format!("{} = 0", print::text(arena, *pin)));
        for line in names.chain(outputs).chain(folded).chain(pins) {
            text.push('\n');
            text.push_str(&line);
        }
        text_hash(&text)
    }

    /// The store of all terms.
    #[must_use]
    pub fn terms(&self) -> &Arena {
        &self.derivation.arena
    }
}
