//! Reduced equations of a scene, as data.

use super::proof::Proof;
use crate::algebra::term::steps::Definition;
use crate::algebra::text::print;
use crate::algebra::{Arena, Expr, Rational};
use crate::mechanics::Derivation;
use crate::model::{Model, Unit, text_hash};
use crate::reduce::basis::prose::Prose;
use crate::reduce::slices::one_degree::Slope;

/// Variable or constant of a reduced system, with its value at the start.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Name of the quantity in the reduced system.
    pub name: String,
    /// Symbol of the quantity in the reduced system.
    pub symbol: Expr,
    /// Description of the quantity, in words and terms.
    pub about: Prose,
    /// Unit of the quantity.
    pub unit: Unit,
    /// Value of the quantity at the start, in parameters, coordinates and speeds of the whole model.
    pub of_start: Expr,
}

/// Output of a scene, as a value of the reduced system.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name of the output in the scene.
    pub name: String,
    /// Value of the output in parameters, constants, time and states of the reduced system.
    pub value: Expr,
}

/// Omission of a reduced system, with reason and proof.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// Omitted quantity.
    pub what: Prose,
    /// Reason why the quantity is not needed.
    pub why: Prose,
    /// Proof that the quantity is not needed, in words.
    pub proof: String,
}

/// Moving frame of a reduction. Its symmetries lead from a start of the whole model to a state in which the pins are
/// zero. The variables of the reduction are those of the model in this state.
#[derive(Clone, Debug)]
pub struct MovingFrame {
    /// Description of the motions of the frame, in words.
    pub about: Vec<String>,
    /// Components of each symmetry, in parameters, coordinates and speeds of the whole model: one for each coordinate,
    /// then one for each speed.
    pub fields: Vec<Vec<Expr>>,
    /// Terms that are zero in the frame, in coordinates and speeds of the whole model.
    pub pins: Vec<Expr>,
    /// Slopes of each pin along each symmetry, one row for each pin.
    pub slopes: Vec<Vec<Expr>>,
}

/// Reduced equations of a scene.
#[derive(Clone)]
pub struct Reduction {
    /// Variables and parameters of the reduced system, with the momenta among the parameters. Its store contains all
    /// terms.
    pub model: Model,
    /// Equations of the reduced system, over the same store as `model`.
    pub derivation: Derivation,
    /// Integrated variables whose rates depend only on these variables.
    pub states: Vec<Quantity>,
    /// Variables that are integrated only because outputs need them; the rate of no state depends on them.
    pub quadratures: Vec<Quantity>,
    /// Quantities that keep their start value, held momenta among them.
    pub constants: Vec<Quantity>,
    /// Definitions of those constants that are products of parameters and other constants.
    pub products: Vec<Definition>,
    /// Outputs of the scene, as values of the reduced system.
    pub outputs: Vec<Output>,
    /// Functions of the scene's events, in the order of the scene.
    pub events: Vec<Expr>,
    /// Moving frame in which the system is written; `None` without a frame.
    pub frame: Option<MovingFrame>,
    /// Descriptions of symmetries that leave every shown quantity unchanged, but give no frame because they change a
    /// condition of the domain.
    pub kept_by_domain: Vec<String>,
    /// Parameters that are replaced by numbers, with name and value.
    pub folded: Vec<(String, Rational)>,
    /// Omissions of the system, each with its reason and its proof.
    pub omitted: Vec<Omission>,
    /// Divisors of the reduction, which has no value where a divisor is zero.
    pub divisors: Vec<Expr>,
    /// True if the energy is a function of the kept variables. If false, the energies of the equations are 0.
    pub has_energy: bool,
    /// Slope of the potential energy, for solution by quadrature; `None` unless the system has one degree of freedom.
    pub slope: Option<Slope>,
    /// Symbol of the time since the start, for outputs that are linear in time.
    pub time: Expr,
    /// Proof that the reduction gives the outputs of the whole model; a reduction without proof is never returned.
    pub proof: Proof,
}

impl Reduction {
    /// Hash of everything on which the reduced equations depend: model text, scene outputs, numbers of the scene, held
    /// momenta, pins of the frame, and origins of distances.
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

    /// Store of all terms of the reduction.
    #[must_use]
    pub fn terms(&self) -> &Arena {
        &self.derivation.arena
    }
}
