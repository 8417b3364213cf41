//! A scene's own equations, as data.

use super::one_degree::Slope;
use super::proof::Proof;
use super::prose::Prose;
use crate::algebra::steps::Definition;
use crate::algebra::{Arena, Expr, Rational, print};
use crate::mechanics::Derivation;
use crate::model::{Model, Unit, text_hash};

/// Something that stands among the variables or parameters of a reduced system, and its value at the start.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Its name in the reduced system.
    pub name: String,
    /// Its symbol there.
    pub symbol: Expr,
    /// What it is.
    pub about: Prose,
    /// Its unit.
    pub unit: Unit,
    /// Its value in parameters, coordinates and speeds of the whole model.
    pub of_start: Expr,
}

/// What a scene asks for, as the reduced system gives it.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its name in the scene.
    pub name: String,
    /// Its value in parameters, constants, time and states of the reduced system.
    pub value: Expr,
}

/// What was left out of a system.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// What is not there.
    pub what: Prose,
    /// Why it need not be.
    pub why: Prose,
    /// How that is known.
    pub proof: String,
}

/// The moving frame of a reduction: from a start of the whole model its symmetries lead to where the pins are zero, and the
/// variables of the reduction are those of the model there.
#[derive(Clone, Debug)]
pub struct Turned {
    /// Along what the frame moves, in words.
    pub about: Vec<String>,
    /// For each symmetry its components, in parameters, coordinates and speeds of the whole model: one a coordinate, then one a
    /// speed.
    pub fields: Vec<Vec<Expr>>,
    /// What is zero in the frame, in coordinates and speeds of the whole model.
    pub pins: Vec<Expr>,
    /// For each pin how it changes along each symmetry.
    pub slopes: Vec<Vec<Expr>>,
}

/// A scene's own equations.
#[derive(Clone)]
pub struct Reduction {
    /// The variables and parameters of the reduced system, the momenta among the latter; its store holds all terms.
    pub model: Model,
    /// Its equations, with the same store.
    pub derivation: Derivation,
    /// What is integrated and depends on nothing else than these.
    pub states: Vec<Quantity>,
    /// What is integrated along with them, since the outputs need it; no state depends on it.
    pub quadratures: Vec<Quantity>,
    /// What stays as it is at the start.
    pub constants: Vec<Quantity>,
    /// Those of the constants that stand for products of parameters and other constants.
    pub products: Vec<Definition>,
    /// What the scene wants to see.
    pub outputs: Vec<Output>,
    /// The functions of the scene's events, in its order.
    pub events: Vec<Expr>,
    /// The moving frame that it is written in, if it is.
    pub frame: Option<Turned>,
    /// Symmetries that change nothing that is shown, in words, along which there is no frame since the domain names what they turn.
    pub kept_by_domain: Vec<String>,
    /// Parameters that stand as numbers.
    pub folded: Vec<(String, Rational)>,
    /// What was left out.
    pub omitted: Vec<Omission>,
    /// What the reduction divides by: where one of these is zero, it says nothing.
    pub divisors: Vec<Expr>,
    /// Whether the energy is a function of what is kept; otherwise the energies of the equations are 0.
    pub has_energy: bool,
    /// For quadrature, if there is one degree of freedom.
    pub slope: Option<Slope>,
    /// The time since the start, in outputs that are linear in it.
    pub time: Expr,
    /// That it gives what the whole model gives: nothing else is returned.
    pub proof: Proof,
}

impl Reduction {
    /// A hash of everything that the reduced equations depend on: the model's text, what the scene asks for, the
    /// numbers that it fixes, and what was chosen to hold and to measure from.
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
