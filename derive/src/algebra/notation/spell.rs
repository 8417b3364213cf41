//! What a notation asks of the symbols that it meets.

use super::symbol::Symbol;

/// Why a symbol stands for nothing: (message, help).
pub type Unknown = (String, Option<String>);

/// What the symbols of a text are called in the language of model files, primes for derivatives included.
pub trait Spell {
    /// Whether a symbol of LaTeX, its dots aside, has a name.
    fn knows(&self, symbol: &Symbol) -> bool;

    /// The name of a symbol of LaTeX.
    ///
    /// `run` is what the letters around it make if they are one word, empty if they are none.
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
