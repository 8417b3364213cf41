//! Permitted states: those in which equations hold and conditions are fulfilled.
//!
//! Permitted states are described by free symbols. A *dependent* symbol has a value in terms of these, such as a rate
//! in terms of speeds, or a length in terms of the coordinates that it ties. A statement about all values of the free
//! symbols then holds in all permitted states, except where something divides by 0. It is proved by the algebra that
//! serves everywhere else, and nothing is approximated.

use super::signs::Signs;
use crate::algebra::term::calculus::{Substitution, without_names};
use crate::algebra::term::elementary::single_angles;
use crate::algebra::{Arena, Expr};
use std::ops::BitOr;

/// States in which an equality holds: all states, or permitted ones only.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Holds {
    /// It needs the equations that permitted states fulfil.
    pub on_constraints: bool,
    /// It needs the conditions that they fulfil.
    pub in_domain: bool,
}

impl Holds {
    /// In every state.
    pub const EVERYWHERE: Self = Self { on_constraints: false, in_domain: false };

    /// The place in words, for an equality that does not hold everywhere.
    #[must_use]
    pub const fn words(self) -> Option<&'static str> {
        match (self.on_constraints, self.in_domain) {
            (false, false) => None,
            (true, false) => Some("on the constraints"),
            (false, true) => Some("in the domain"),
            (true, true) => Some("on the constraints and in the domain"),
        }
    }
}

impl BitOr for Holds {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self { on_constraints: self.on_constraints | other.on_constraints, in_domain: self.in_domain | other.in_domain }
    }
}

/// The permitted states of a mechanism; by default all.
#[derive(Clone, Default)]
pub struct Permitted {
    put: Substitution,
    /// True if sines and cosines are among the dependent terms.
    has_angles: bool,
    dependent: Vec<(Expr, Expr)>,
    /// Signs that follow from the conditions, in the symbols as written.
    signs: Signs,
    /// Signs that follow from the conditions, in free symbols.
    free_signs: Signs,
    conditions: Vec<Expr>,
    free_conditions: Vec<Expr>,
    /// True if the dependent symbols are reported where an equality needs them.
    is_told: bool,
    /// Shorter terms that replace sums to which the equations make them equal.
    shorter: Substitution,
    /// Why not every equation is solved for a symbol.
    open: Option<String>,
}

/// Two sides as they are in permitted states.
pub struct View {
    /// Constraints and conditions of the permitted states that were used.
    pub holds: Holds,
    /// The sides.
    pub sides: (Expr, Expr),
}

impl Permitted {
    /// The states in which each of `dependent` has its value and `conditions` are positive. The values are in symbols
    /// that are not dependent. The sine and the cosine of a dependent angle may be given beside it.
    pub fn new(arena: &mut Arena, dependent: Vec<(Expr, Expr)>, conditions: Vec<Expr>) -> Self {
        let mut put = Substitution::new(&dependent);
        let has_angles = dependent.iter().any(|(e, _)| arena.symbol_name(*e).is_none());
        let mut free = |arena: &mut Arena, e: Expr| {
            let e = if has_angles { single_angles(arena, e) } else { e };
            put.apply(arena, e)
        };
        let mut free_conditions: Vec<Expr> = conditions.iter().map(|e| free(arena, *e)).collect();
        let (signs, free_signs) = (Signs::new(arena, &conditions), Signs::new(arena, &free_conditions));
        // A positive symbol that depends on others is positive where they permit it.
        free_conditions.extend(dependent.iter().filter(|(s, _)| arena.is_positive(*s)).map(|(_, value)| *value));
        Self {
            put,
            has_angles,
            dependent,
            signs,
            free_signs,
            conditions,
            free_conditions,
            is_told: true,
            ..Self::default()
        }
    }

    /// With a reason why some permitted states may be none: an equation that is solved for no symbol.
    #[must_use]
    pub fn with_open(self, open: Option<String>) -> Self {
        Self { open, ..self }
    }

    /// With dependent symbols that nobody needs to be told of, such as the rate of time.
    #[must_use]
    pub fn untold(self) -> Self {
        Self { is_told: false, ..self }
    }

    /// With sums that equations make equal to shorter terms.
    #[must_use]
    pub fn with_shorter(self, shorter: &[(Expr, Expr)]) -> Self {
        Self { shorter: Substitution::new(shorter), ..self }
    }

    /// A term as it may be written in permitted states, with shorter terms for sums; as it is if it has none of those.
    pub fn shortened(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        let whole = without_names(arena, e);
        let short = self.shorter.apply(arena, whole);
        if short == whole { e } else { short }
    }

    /// True if a state shows the symbols that its dependent symbols depend on.
    #[must_use]
    pub const fn is_told(&self) -> bool {
        self.is_told
    }

    /// True if every state is permitted.
    #[must_use]
    pub fn is_everything(&self) -> bool {
        self.dependent.is_empty() && self.conditions.is_empty() && self.open.is_none()
    }

    /// Why an equation is solved for no symbol, so that no difference is proved.
    #[must_use]
    pub fn open(&self) -> Option<&str> {
        self.open.as_deref()
    }

    /// A term in free symbols; as it is where a divisor would be 0.
    pub fn put(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        let e = if self.has_angles { single_angles(arena, e) } else { e };
        self.put.apply(arena, e)
    }

    /// The two sides in permitted states, as views that use more and more known facts; views that change nothing are
    /// left out. `None` if the sides divide by a term that is 0 in all permitted states.
    pub fn views(&mut self, arena: &mut Arena, left: Expr, right: Expr) -> Option<Vec<View>> {
        let mut list: Vec<View> = Vec::new();
        let told = self.is_told;
        let mut add = |sides: (Expr, Expr), on_constraints: bool, in_domain: bool| {
            if sides != (left, right) && list.iter().all(|view| view.sides != sides) {
                list.push(View { holds: Holds { on_constraints: on_constraints && told, in_domain }, sides });
            }
        };
        if !self.signs.is_empty() {
            add((self.signs.resolved(arena, left), self.signs.resolved(arena, right)), false, true);
        }
        let put = (self.put(arena, left), self.put(arena, right));
        let left_over = arena.reachable(&[put.0, put.1]);
        if self.dependent.iter().any(|(symbol, _)| left_over.binary_search(symbol).is_ok()) {
            return None;
        }
        add(put, true, false);
        let sides = (self.free_signs.resolved(arena, put.0), self.free_signs.resolved(arena, put.1));
        add(sides, true, true);
        Some(list)
    }

    /// Conditions of a state, in free symbols.
    #[must_use]
    pub fn free_conditions(&self) -> &[Expr] {
        &self.free_conditions
    }

    /// Known signs, in free symbols.
    #[must_use]
    pub(in crate::algebra) fn free_signs(&self) -> &Signs {
        &self.free_signs
    }
}
