//! Names of the symbols that a notation meets.

use super::symbol::Symbol;

/// Why a symbol stands for nothing: (message, help).
pub type Unknown = (String, Option<String>);

/// Names, in the language of model files, of the symbols of a text, primes for derivatives included.
pub trait Spell {
    /// True if a symbol of LaTeX, its dots aside, has a name.
    fn knows(&self, symbol: &Symbol) -> bool;

    /// The name of a symbol of LaTeX.
    ///
    /// `run` is the word that the symbol forms with the letters around it, empty if they form none.
    ///
    /// # Errors
    /// Why it has none.
    fn latex(&mut self, symbol: &Symbol, run: &str) -> Result<String, Unknown>;

    /// The name of a variable of a program, such as `q1`, `p.m`, `z(6)` or `z[5]`.
    ///
    /// # Errors
    /// Why it has none.
    fn variable(&mut self, name: &str) -> Result<String, Unknown>;
}
