//! Named terms: a term that grows with the model gets a name, and larger terms mention the name.
//! Rewriting treats a named term as an atom and does not look inside it. Evaluation looks inside:
//! values, residues, ranges, derivatives and bounds pass through names. So code that asks about the
//! meaning of a term need not know of names.
//!
//! Kane's and Autolev's Z's are such names: T. R. Kane & D. A. Levinson, *Dynamics: Theory and
//! Applications* (1985), § 4.9.
//!
//! Invariants: a term has one name. Numbers, symbols and multiples of named terms get no name.
//! Terms that are equal up to a numerical factor share a name. A name becomes a symbol, distinct
//! from all others, when a document defines it ([`crate::algebra::text::definitions`]). A name that
//! is never written blocks no other name, and its term is shown in full.

use super::arena::Names;
use crate::algebra::{Arena, Expr, Node, Rational};

impl Names {
    /// Appends an underscore and the part of the document that is being written to the name
    /// `wanted`. Without a part, the name is returned unchanged.
    pub(in crate::algebra) fn name_in_part(&self, wanted: &str) -> String {
        self.part.as_ref().map_or_else(|| wanted.to_owned(), |part| format!("{wanted}_{part}"))
    }
}

impl Arena {
    /// Gives the term `e` a name with the label `wanted`. Returns the named term, times the
    /// numerical factor of `e`. Returns `e` itself if it is neither a sum nor a product, since a
    /// name would then save nothing.
    pub fn name(&mut self, e: Expr, wanted: &str) -> Expr {
        let (content, bare) = self.split_for_name(e);
        if !matches!(self.node(bare), Node::Sum(..) | Node::Product(_)) {
            return e;
        }
        let stands = match self.names.stands.get(&bare) {
            Some(known) => *known,
            None => {
                let label = self.add_name_label(wanted);
                let stands = self.intern(Node::Named(label, bare));
                self.names.stands.insert(bare, stands);
                stands
            }
        };
        self.scale(stands, &content)
    }

    /// Number of a label of named terms; a new label is added.
    fn add_name_label(&mut self, wanted: &str) -> u32 {
        if let Some(known) = self.names.label_index.get(wanted) {
            return *known;
        }
        let label = u32::try_from(self.names.labels.len()).expect("fewer labels than terms");
        self.names.labels.push(wanted.to_owned());
        self.names.label_index.insert(wanted.to_owned(), label);
        label
    }

    /// Names the term `e` like the named term `before`, which it replaces: with the same label.
    /// Returns `e` unchanged if `before` has no name.
    pub fn name_like(&mut self, before: Expr, e: Expr) -> Expr {
        let wanted = self.name_of(before).map(str::to_owned);
        wanted.map_or(e, |wanted| self.name(e, &wanted))
    }

    /// Splits `e` into a rational factor and a term without a numerical factor; their product is
    /// `e`.
    fn split_for_name(&mut self, e: Expr) -> (Rational, Expr) {
        if let Node::Sum(constant, terms) = self.node(e)
            && constant.is_zero()
            && let [(term, k)] = &**terms
        {
            return (k.clone(), *term);
        }
        self.split_content(e)
    }

    /// Expression that the named term `e` abbreviates; `None` if `e` is not a named term.
    #[must_use]
    pub fn named_term_value(&self, e: Expr) -> Option<Expr> {
        match self.node(e) {
            Node::Named(_, term) => Some(*term),
            _ => None,
        }
    }

    /// True if the arena has any named terms.
    #[must_use]
    pub fn has_names(&self) -> bool {
        !self.names.stands.is_empty()
    }

    /// Name of a named term: the unique name that a document gave it, else its label, which several
    /// terms may share. `None` if `e` is not a named term.
    #[must_use]
    pub fn name_of(&self, e: Expr) -> Option<&str> {
        self.written_name(e).or_else(|| self.label_of(e))
    }

    /// Label of a named term: the name that was requested when the term was named. Several terms
    /// may share a label. `None` if `e` is not a named term.
    pub(in crate::algebra) fn label_of(&self, e: Expr) -> Option<&str> {
        let Node::Named(label, _) = self.node(e) else { return None };
        Some(&self.names.labels[*label as usize])
    }

    /// Name with which a document has defined a named term; no other term of the arena has this
    /// name. `None` if `e` is not a named term, or if no document has defined it: then `e` is shown
    /// in full.
    #[must_use]
    pub fn written_name(&self, e: Expr) -> Option<&str> {
        self.symbol_name(self.names.symbols.get(&e)?.symbol)
    }
}
