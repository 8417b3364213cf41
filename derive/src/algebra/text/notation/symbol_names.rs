//! Spelling of symbols: names, in the language of model files, of the symbols in formulas of other
//! notations.

use super::latex_symbol::LatexSymbol;

/// Reason why a symbol has no name in the model, as the pair (message, help) for an error.
pub type Unknown = (String, Option<String>);

/// Source of names for symbols of other notations. A returned name is in the language of model
/// files, with one prime for each time derivative.
pub trait SymbolNames {
    /// True if a LaTeX symbol, apart from its dots, has a name in the model.
    fn knows(&self, symbol: &LatexSymbol) -> bool;

    /// True if a LaTeX symbol stands for a generalized coordinate.
    fn is_coordinate(&self, _symbol: &LatexSymbol) -> bool {
        false
    }

    /// Name, in the language of model files, of a LaTeX symbol. `run` is the word that the symbol
    /// forms with adjacent letters and digits; it is empty for a single letter.
    ///
    /// # Errors
    /// Reason why the symbol has no name in the model.
    fn name_of_latex_symbol(&mut self, symbol: &LatexSymbol, run: &str) -> Result<String, Unknown>;

    /// Name, in the language of model files, of a program's variable, such as `q1`, `p.m`, `z(6)`
    /// or `z[5]`.
    ///
    /// # Errors
    /// Reason why the variable has no name.
    fn name_of_variable(&mut self, name: &str) -> Result<String, Unknown>;
}
