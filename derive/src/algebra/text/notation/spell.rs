//! Names, in the language of model files, of the symbols in formulas of other notations.

use super::symbol::Symbol;

/// Reason why a symbol has no name: (message, help).
pub type Unknown = (String, Option<String>);

/// Source of the names, in the language of model files, of the symbols in a text, primes for derivatives included.
pub trait Spell {
    /// True if a symbol of LaTeX, its dots aside, has a name.
    fn knows(&self, symbol: &Symbol) -> bool;

    /// True if a symbol of LaTeX stands for a coordinate.
    fn is_coordinate(&self, _symbol: &Symbol) -> bool {
        false
    }

    /// The name of a symbol of LaTeX.
    ///
    /// `run` is the word that the symbol forms with the letters around it, empty if they form none.
    ///
    /// # Errors
    /// Reason why the symbol has no name.
    fn latex(&mut self, symbol: &Symbol, run: &str) -> Result<String, Unknown>;

    /// The name of a variable of a program, such as `q1`, `p.m`, `z(6)` or `z[5]`.
    ///
    /// # Errors
    /// Reason why the variable has no name.
    fn variable(&mut self, name: &str) -> Result<String, Unknown>;
}
