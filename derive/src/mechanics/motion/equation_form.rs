//! Form of derived equations: closed, with every term written out, or with named subterms.

use crate::geometry::{Frames, Placement, Turn};
use crate::model::Model;
use std::collections::BTreeSet;

/// Approximate number of terms in the closed form of a mass matrix, above which long subterms get names.
const MOST_TERMS: usize = 50;

/// Approximate number of terms in the closed form of a mass matrix, above which display does not even try the closed
/// form.
const MOST_TRIED: usize = 20_000;

/// Form of derived equations: closed, with every term written out, or with named subterms. Both forms have the same
/// meaning.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EquationForm {
    /// Every term is written out. Formulas need no list of definitions, but grow fast with the number
    /// of bodies.
    Closed,
    /// Long subterms have names, which later terms contain. In this form, formulas of large models are derived and
    /// computed fast.
    Steps,
}

impl EquationForm {
    /// Form in which the equations of a model are proved, computed and written as code. It is `Steps` if the closed
    /// form of the mass matrix would have more than about 50 terms.
    ///
    /// The count adds up products of two parts of velocities: the speeds that each part depends on, times the terms
    /// of the rotation between the parts. A mass matrix that is multiplied out consists of such products. The count
    /// depends only on the model's tree, so it is equal for every formulation and on every machine.
    #[must_use]
    pub fn computed(model: &Model) -> Self {
        if closed_form_exceeds(model, MOST_TERMS) { Self::Steps } else { Self::Closed }
    }

    /// True if the closed form of a model is short enough (about 20 000 terms) to be derived for
    /// display.
    pub(in crate::mechanics) fn is_closed_tried(model: &Model) -> bool {
        !closed_form_exceeds(model, MOST_TRIED)
    }
}

/// Largest approximate number of terms in the closed form of a model for which reduced equations
/// are made.
const MOST_REDUCED: usize = 400;

/// True if reduced equations of a scene may be made from the equations of this model. Reduced equations are written
/// out, replace speeds by momenta and leave out unneeded variables.
///
/// False for larger models, for models with loops, and for models whose rates q̇ have named subterms. With loops,
/// every variable is needed to keep them closed.
#[must_use]
pub fn has_reducible_form(model: &Model) -> bool {
    let rates = model.arena.reachable(&model.kinematic_equations.rates);
    let has_names = rates.iter().any(|part| model.arena.named_term_value(*part).is_some());
    !closed_form_exceeds(model, MOST_REDUCED) && model.loops.is_empty() && !has_names
}

/// True if the closed form of the mass matrix has more than about `most` terms. Counting stops at `most`, because a
/// chain of hundreds of bodies has a hundred thousand pairs of velocity parts.
fn closed_form_exceeds(model: &Model, most: usize) -> bool {
    let frames = Frames::new(&model.frames);
    let (q, arena) = (model.q(), &model.arena);
    let moves = |turn: &Turn| turn.quantities().iter().any(|e| q.iter().any(|q| arena.mentions(*e, *q)));
    // Number of turns above a frame that depend on q. It approximates the number of speeds.
    let moved = |frame: &usize| frames.turn_from_parent(*frame).is_some_and(moves);
    let depth = |frame: usize| frames.ancestors(frame).into_iter().filter(moved).count();
    // A turn that only exchanges axes, such as the frame of a joint along the first or second axis, does not lengthen
    // the closed form.
    let counts = |turn: &Turn| moves(turn) || !turn.is_axis_permutation();
    let terms = |a: usize, b: usize| {
        let speeds = depth(a).max(1).saturating_mul(depth(b).max(1));
        let turns = u32::try_from(frames.axes_between(a, b, counts)).unwrap_or(u32::MAX);
        2_usize.checked_pow(turns).map_or(usize::MAX, |terms| terms.saturating_mul(speeds))
    };
    let mut counted: BTreeSet<(usize, usize)> = BTreeSet::new();
    let mut sum = 0_usize;
    for body in &model.bodies {
        let mut parts: BTreeSet<usize> = BTreeSet::new();
        let mut point = body.centre;
        while let Some(Placement { parent, frame, .. }) = model.points[point].position {
            parts.insert(frame);
            point = parent;
        }
        for (a, b) in parts.iter().flat_map(|a| parts.range(a..).map(move |b| (*a, *b))) {
            if counted.insert((a, b)) {
                sum = sum.saturating_add(terms(a, b));
            }
            if sum > most {
                return true;
            }
        }
    }
    false
}
