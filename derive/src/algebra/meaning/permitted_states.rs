//! Permitted states: states of a mechanism in which its equations hold and its conditions are
//! fulfilled.
//!
//! Permitted states are described by free symbols. A *dependent* symbol has a value in terms of the
//! free symbols. Examples are a rate in terms of speeds, or a length that a constraint ties to
//! coordinates.
//! A statement about all values of the free symbols then holds in all permitted states, except
//! where a divisor is 0. It is proved by exact algebra, and nothing is approximated.

use super::signs::Signs;
use crate::algebra::term::calculus::{Substitution, expand_names};
use crate::algebra::term::elementary::expand_multiple_angles;
use crate::algebra::{Arena, Expr};
use std::ops::BitOr;

/// States in which an equality holds: all states, or permitted states only.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StatesOfValidity {
    /// True if the equality holds only where the constraint equations of permitted states hold.
    pub on_constraints: bool,
    /// True if the equality holds only where the conditions of permitted states are fulfilled.
    pub in_domain: bool,
}

impl StatesOfValidity {
    /// Value for an equality that holds in every state.
    pub const EVERYWHERE: Self = Self { on_constraints: false, in_domain: false };

    /// Describes the states in words, such as "on the constraints"; `None` for an equality in all
    /// states.
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

impl BitOr for StatesOfValidity {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self { on_constraints: self.on_constraints | other.on_constraints, in_domain: self.in_domain | other.in_domain }
    }
}

/// Permitted states of a mechanism. By default all states are permitted.
#[derive(Clone, Default)]
pub struct PermittedStates {
    /// Substitution that replaces dependent terms by their values in free symbols.
    put: Substitution,
    /// True if sines or cosines are among the terms that depend on free symbols.
    has_angles: bool,
    /// Dependent terms as pairs (term, value), with the value in free symbols.
    dependent: Vec<(Expr, Expr)>,
    /// Signs of terms that follow from the conditions on permitted states, in symbols as the model
    /// gives them.
    signs: Signs,
    /// Signs of terms that follow from the conditions on permitted states, in free (independent)
    /// symbols.
    free_signs: Signs,
    /// Terms that are positive in permitted states, in symbols as the model gives them.
    conditions: Vec<Expr>,
    /// Terms that are positive in permitted states, in free symbols.
    free_conditions: Vec<Expr>,
    /// True if results mention the constraints, and witnesses show the values of free symbols.
    /// False for symbols that readers need not know.
    is_told: bool,
    /// Substitution of shorter terms for sums to which the equations of the mechanism make them
    /// equal.
    shorter: Substitution,
    /// Message about an equation that is not solved for any symbol; `None` if all equations are
    /// solved.
    open: Option<String>,
}

/// Two sides of a comparison, rewritten with facts about permitted states.
pub struct RewrittenSides {
    /// States in which the rewritten sides equal the original sides.
    pub holds: StatesOfValidity,
    /// Left and right side of the comparison, rewritten for permitted states.
    pub sides: (Expr, Expr),
}

impl PermittedStates {
    /// Creates the states in which each term of `dependent` equals its value and all `conditions`
    /// are positive. `dependent` has pairs (term, value); the values must not contain dependent
    /// symbols. If an angle is dependent, its sine and cosine may be given as terms too.
    pub fn new(arena: &mut Arena, dependent: Vec<(Expr, Expr)>, conditions: Vec<Expr>) -> Self {
        let mut put = Substitution::new(&dependent);
        let has_angles = dependent.iter().any(|(e, _)| arena.symbol_name(*e).is_none());
        let mut free = |arena: &mut Arena, e: Expr| {
            let e = if has_angles { expand_multiple_angles(arena, e) } else { e };
            put.apply(arena, e)
        };
        let mut free_conditions: Vec<Expr> = conditions.iter().map(|e| free(arena, *e)).collect();
        let (signs, free_signs) = (Signs::new(arena, &conditions), Signs::new(arena, &free_conditions));
        // A positive dependent symbol restricts the free symbols: its value must be positive.
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

    /// Sets the message about an equation that is not solved for any symbol. States that violate
    /// this equation are then counted as permitted, although they are not.
    #[must_use]
    pub fn with_unsolved_equation(self, open: Option<String>) -> Self {
        Self { open, ..self }
    }

    /// Hides the constraints and the free symbols from results and witnesses. This suits symbols
    /// that readers need not know, such as the rate of time.
    #[must_use]
    pub fn hide_free_symbols(self) -> Self {
        Self { is_told: false, ..self }
    }

    /// Sets pairs (sum, shorter term) that the equations of the mechanism make equal.
    #[must_use]
    pub fn with_shorter_terms(self, shorter: &[(Expr, Expr)]) -> Self {
        Self { shorter: Substitution::new(shorter), ..self }
    }

    /// Replaces sums in a term by shorter terms that are equal to them in permitted states. The
    /// term is returned unchanged if no sum can be replaced.
    pub fn replace_by_shorter_terms(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        let whole = expand_names(arena, e);
        let short = self.shorter.apply(arena, whole);
        if short == whole { e } else { short }
    }

    /// True if a witness also shows the free symbols on which its dependent symbols depend.
    #[must_use]
    pub const fn shows_free_symbols(&self) -> bool {
        self.is_told
    }

    /// True if every state of the mechanism is permitted: there are no equations and no conditions.
    #[must_use]
    pub fn is_everything(&self) -> bool {
        self.dependent.is_empty() && self.conditions.is_empty() && self.open.is_none()
    }

    /// Message about an equation that is not solved for any symbol, so that no difference can be
    /// proved. `None` if all equations are solved.
    #[must_use]
    pub fn unsolved_equation(&self) -> Option<&str> {
        self.open.as_deref()
    }

    /// Writes a term in the free (independent) symbols of permitted states. A quotient stays
    /// unchanged if its divisor becomes 0 in permitted states.
    pub fn write_in_free_symbols(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        let e = if self.has_angles { expand_multiple_angles(arena, e) } else { e };
        self.put.apply(arena, e)
    }

    /// Rewritten forms of the two sides of a comparison in permitted states. Each form uses more
    /// facts than the form before it; forms that change nothing are left out. `None` if a side
    /// divides by a term that is 0 in all permitted states.
    pub fn rewritten_sides(&mut self, arena: &mut Arena, left: Expr, right: Expr) -> Option<Vec<RewrittenSides>> {
        let mut list: Vec<RewrittenSides> = Vec::new();
        let told = self.is_told;
        let mut add = |sides: (Expr, Expr), on_constraints: bool, in_domain: bool| {
            if sides != (left, right) && list.iter().all(|view| view.sides != sides) {
                list.push(RewrittenSides {
                    holds: StatesOfValidity { on_constraints: on_constraints && told, in_domain },
                    sides,
                });
            }
        };
        if !self.signs.is_empty() {
            add(
                (self.signs.resolve_roots_and_signs(arena, left), self.signs.resolve_roots_and_signs(arena, right)),
                false,
                true,
            );
        }
        let put = (self.write_in_free_symbols(arena, left), self.write_in_free_symbols(arena, right));
        let left_over = arena.reachable(&[put.0, put.1]);
        if self.dependent.iter().any(|(symbol, _)| left_over.binary_search(symbol).is_ok()) {
            return None;
        }
        add(put, true, false);
        let sides = (
            self.free_signs.resolve_roots_and_signs(arena, put.0),
            self.free_signs.resolve_roots_and_signs(arena, put.1),
        );
        add(sides, true, true);
        Some(list)
    }

    /// Terms in free symbols that are positive in permitted states.
    #[must_use]
    pub fn free_conditions(&self) -> &[Expr] {
        &self.free_conditions
    }

    /// Signs of terms that follow from the conditions, in free symbols.
    #[must_use]
    pub(in crate::algebra) fn free_signs(&self) -> &Signs {
        &self.free_signs
    }
}
