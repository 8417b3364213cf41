//! Named terms: a term that grows gets a name, and terms that mention it show the name.
//!
//! No rewriting looks behind a name: it treats the named term as an atom. Evaluation does: values, residues, ranges,
//! derivatives and bounds pass through names, so that a question about the meaning of a term need not know of them.
//! Kane's and Autolev's Z's are such names: T. R. Kane & D. A. Levinson, *Dynamics: Theory and Applications* (1985), §
//! 4.9.
//!
//! Invariants: a term has one name. Numbers, symbols and multiples of named terms get no name, and terms that are equal
//! up to a numerical factor share one. A name becomes a symbol, unlike all others, when it is written down
//! ([`crate::algebra::text::definitions`]). A name that is never written blocks no other name, and its term is shown in
//! full.

use super::arena::Names;
use crate::algebra::{Arena, Expr, Node, Rational};

impl Names {
    /// Name with the name of the document part appended that is being written, if there is one.
    pub(in crate::algebra) fn in_part(&self, wanted: &str) -> String {
        self.part.as_ref().map_or_else(|| wanted.to_owned(), |part| format!("{wanted}_{part}"))
    }
}

impl Arena {
    /// Gives the term `e` a name with the label `wanted`, and returns the named term. Returns `e` itself if a name
    /// would save nothing.
    pub fn name(&mut self, e: Expr, wanted: &str) -> Expr {
        let (content, bare) = self.bare(e);
        if !matches!(self.node(bare), Node::Sum(..) | Node::Product(_)) {
            return e;
        }
        let stands = match self.names.stands.get(&bare) {
            Some(known) => *known,
            None => {
                let label = self.label(wanted);
                let stands = self.intern(Node::Named(label, bare));
                self.names.stands.insert(bare, stands);
                stands
            }
        };
        self.scale(stands, &content)
    }

    fn label(&mut self, wanted: &str) -> u32 {
        if let Some(known) = self.names.label_index.get(wanted) {
            return *known;
        }
        let label = u32::try_from(self.names.labels.len()).expect("fewer labels than terms");
        self.names.labels.push(wanted.to_owned());
        self.names.label_index.insert(wanted.to_owned(), label);
        label
    }

    /// Gives `e`, which replaces the named term `before`, a name of the same kind.
    pub fn name_again(&mut self, before: Expr, e: Expr) -> Expr {
        let wanted = self.name_of(before).map(str::to_owned);
        wanted.map_or(e, |wanted| self.name(e, &wanted))
    }

    /// Splits `e` into a number and a term without a numerical factor, whose product is `e`.
    fn bare(&mut self, e: Expr) -> (Rational, Expr) {
        if let Node::Sum(constant, terms) = self.node(e)
            && constant.is_zero()
            && let [(term, k)] = &**terms
        {
            return (k.clone(), *term);
        }
        self.split_content(e)
    }

    /// Term behind the name of `e`; `None` if `e` has no name.
    #[must_use]
    pub fn behind(&self, e: Expr) -> Option<Expr> {
        match self.node(e) {
            Node::Named(_, term) => Some(*term),
            _ => None,
        }
    }

    /// True if any term has a name.
    #[must_use]
    pub fn has_names(&self) -> bool {
        !self.names.stands.is_empty()
    }

    /// Name of a named term: its written name, else its label, which many terms may share. `None` for a term without a
    /// name.
    #[must_use]
    pub fn name_of(&self, e: Expr) -> Option<&str> {
        self.written_name(e).or_else(|| self.label_of(e))
    }

    /// Label of a named term: the name that was asked for it, which many terms may share. `None` for a term without a
    /// name.
    pub(in crate::algebra) fn label_of(&self, e: Expr) -> Option<&str> {
        let Node::Named(label, _) = self.node(e) else { return None };
        Some(&self.names.labels[*label as usize])
    }

    /// Name that a term was written down with: no other term of the arena has it. `None` for a term without a name, and
    /// for a term whose name was never written, which is shown in full.
    #[must_use]
    pub fn written_name(&self, e: Expr) -> Option<&str> {
        self.symbol_name(self.names.symbols.get(&e)?.symbol)
    }
}
