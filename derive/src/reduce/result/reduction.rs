//! Reduced equations of a scene, as data: model, equations, constants, outputs, omissions and
//! proof.

use super::reduction_proof::ReductionProof;
use super::surface_choice::SurfaceChoice;
use crate::algebra::term::steps::Definition;
use crate::algebra::text::print;
use crate::algebra::{Arena, Expr, Rational};
use crate::mechanics::Derivation;
use crate::model::{Model, Unit, text_hash};
use crate::reduce::basis::prose::Prose;
use crate::reduce::slices::potential_difference::PotentialDifference;

/// Variable or constant of reduced equations, with its value at the start.
#[derive(Clone, Debug)]
pub struct ReducedQuantity {
    /// Name of the quantity in the reduced equations.
    pub name: String,
    /// Symbol of the quantity in the reduced equations.
    pub symbol: Expr,
    /// Description of the quantity for people, in words and terms.
    pub about: Prose,
    /// Unit of the quantity's value.
    pub unit: Unit,
    /// Value of the quantity at the start, as a term in parameters, coordinates and speeds of the whole
    /// model.
    pub of_start: Expr,
}

/// Output of a scene, as a term of the reduced equations.
#[derive(Clone, Debug)]
pub struct ReducedOutput {
    /// Name of the output in the scene.
    pub name: String,
    /// Value of the output as a term in parameters, constants, time and states of the reduced
    /// equations.
    pub value: Expr,
}

/// Quantity of the model that reduced equations omit, with reason and proof.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// Omitted quantity, in words and terms.
    pub what: Prose,
    /// Reason why the quantity is not needed, in words and terms.
    pub why: Prose,
    /// Proof that the quantity can be omitted, in words.
    pub proof: String,
}

/// Moving frame of reduced equations. Its symmetries move a start of the whole model to a state at
/// which the pinned terms are zero. The start of the reduced equations is this moved state.
#[derive(Clone, Debug)]
pub struct MovingFrame {
    /// Descriptions of the frame's motions in words, one for each symmetry.
    pub about: Vec<String>,
    /// Components of each symmetry, as terms in the whole model's states. The inner list has an
    /// entry for each coordinate, then for each speed.
    pub fields: Vec<Vec<Expr>>,
    /// Terms that are zero in the frame (pins), in coordinates and speeds of the whole model.
    pub pins: Vec<Expr>,
    /// Derivatives of the pinned terms along the symmetries, with a row for each pinned term and a
    /// column for each symmetry.
    pub slopes: Vec<Vec<Expr>>,
}

/// Reduced equations of a scene, with all data that is needed to run and to explain them.
#[derive(Clone)]
pub struct Reduction {
    /// Variables and parameters of the reduced equations, as an ordinary model. The constant momenta
    /// are among the parameters. Its arena contains all terms.
    pub model: Model,
    /// Reduced equations, with their terms in an arena equal to that of `model`.
    pub derivation: Derivation,
    /// Integrated variables whose rates depend only on variables in this list.
    pub states: Vec<ReducedQuantity>,
    /// Variables that are integrated only because outputs need them. No rate of a state depends on
    /// these variables.
    pub quadratures: Vec<ReducedQuantity>,
    /// Quantities that keep their start value during a motion, such as momenta.
    pub constants: Vec<ReducedQuantity>,
    /// Definitions of those constants that are products of parameters and other constants.
    pub products: Vec<Definition>,
    /// Outputs of the scene, as terms of the reduced equations.
    pub outputs: Vec<ReducedOutput>,
    /// Functions of the scene's events, in the order of the scene. An event occurs where its function
    /// is zero.
    pub events: Vec<Expr>,
    /// Moving frame in which the equations are written; `None` without a frame.
    pub frame: Option<MovingFrame>,
    /// Singular surface from which the equations measure a coordinate. It depends on the start of the scene.
    pub surface: SurfaceChoice,
    /// Descriptions of symmetries that leave every shown quantity unchanged but change a condition
    /// of the model's domain. So they are not used for a moving frame.
    pub kept_by_domain: Vec<String>,
    /// Parameters that were replaced by numbers, as pairs of name and value.
    pub folded: Vec<(String, Rational)>,
    /// Quantities of the model that the equations omit, each with its reason and its proof.
    pub omitted: Vec<Omission>,
    /// Divisors of the reduced equations. The equations have no value at states where a divisor is
    /// zero.
    pub divisors: Vec<Expr>,
    /// True if the energy is a function of the remaining variables. If false, the kinetic and the
    /// potential energy of the equations are set to 0.
    pub has_energy: bool,
    /// Divided difference of the potential energy, for solution by quadrature. `None` unless there is
    /// one degree of freedom.
    pub slope: Option<PotentialDifference>,
    /// Symbol of the time since the start, s, for outputs that are linear in time.
    pub time: Expr,
    /// Proof that the reduced equations give the outputs of the whole model. A reduction without proof
    /// is never returned.
    pub proof: ReductionProof,
}

impl Reduction {
    /// Hash of everything on which the reduced equations depend. This is the model text, the
    /// scene's outputs and numbers, the constant momenta, the pins of the frame, and the origins of
    /// distances.
    #[must_use]
    pub fn reduction_hash(&self) -> String {
        let arena = self.arena();
        let mut text = self.model.text_hash();
        let quantities = self.states.iter().chain(&self.quadratures).chain(&self.constants);
        let names = quantities.map(|q| format!("{} = {}", q.name, print::print_text(arena, q.of_start)));
        let outputs = self.outputs.iter().map(|o| format!("{}: {}", o.name, print::print_whole_text(arena, o.value)));
        let folded = self.folded.iter().map(|(name, value)| format!("{name} = {}", value.to_big()));
        let pins = self
            .frame
            .iter()
            .flat_map(|frame| &frame.pins)
            .map(|pin| format!("{} = 0", print::print_text(arena, *pin)));
        for line in names.chain(outputs).chain(folded).chain(pins) {
            text.push('\n');
            text.push_str(&line);
        }
        text_hash(&text)
    }

    /// Arena that holds all terms of the reduction.
    #[must_use]
    pub fn arena(&self) -> &Arena {
        &self.derivation.arena
    }
}
