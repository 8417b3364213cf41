//! Functions of time as `SymPy` prints them: `q(t)`, `q(t).diff(t)`, `Derivative(q(t), (t, 2))`.

use super::function_names::name_without_module;
use super::kind::Notation;
use super::program::Program;
use super::translation_errors::{translation_error, untranslatable_symbol_error};
use crate::algebra::text::parse::ParseError;

impl Program<'_, '_> {
    /// Reads a time derivative as `SymPy` prints it, after the word `Derivative` or `diff`. `(q(t),
    /// t)` becomes q', and `(q(t), (t, 2))` becomes q''. `None` if `word` is neither of these
    /// words. Error if it is not the time derivative of a symbol.
    pub(super) fn derivative(&mut self, word: &str) -> Result<Option<String>, ParseError> {
        if self.notation != Notation::Python || !matches!(word, "Derivative" | "diff") {
            return Ok(None);
        }
        self.at += 1;
        self.skip();
        let (name, place) = self.word();
        let name = name_without_module(&name).to_owned();
        self.skip_time_argument();
        let name = self.spell.name_of_variable(&name).map_err(|why| untranslatable_symbol_error(place, why))?;
        let primes = self.derivative_order()?;
        Ok(Some(name + &"'".repeat(primes)))
    }

    /// Reads what `SymPy` appends to the name of a function of time: the argument `(t)`, and
    /// `.diff(t)`. Returns the name with one prime for each derivative. Error for a derivative with
    /// respect to another variable.
    pub(super) fn read_derivative_suffix(&mut self, name: String) -> Result<String, ParseError> {
        if self.notation != Notation::Python {
            return Ok(name);
        }
        self.skip_time_argument();
        if !self.rest(0).starts_with(".diff(") {
            return Ok(name);
        }
        let begin = self.at;
        self.at += ".diff(".len();
        let inside = self.rest(0);
        let Some(end) = inside.find(')') else { return Err(self.not_a_time_derivative(begin)) };
        let arguments = inside[..end].replace(' ', "");
        self.at += end + 1;
        let primes = match arguments.as_str() {
            "t" => 1,
            "t,2" | "t,t" => 2,
            _ => return Err(self.not_a_time_derivative(begin)),
        };
        Ok(name + &"'".repeat(primes))
    }

    /// Skips the argument `(t)` of a function of time, if it comes next.
    fn skip_time_argument(&mut self) {
        for written in ["(t)", "( t )"] {
            if self.rest(0).starts_with(written) {
                self.at += written.len();
            }
        }
    }

    /// Reads the end of a derivative, `, t)`, `, t, t)`, `, t, 2)` or `, (t, 2))`, and returns its
    /// order, 1 or 2. Error for any other end.
    fn derivative_order(&mut self) -> Result<usize, ParseError> {
        let begin = self.at;
        // The parenthesis of (t, 2) is the only one that may be open inside.
        let mut depth = 1_usize;
        let end = self.rest(0).char_indices().find_map(|(at, c)| {
            match c {
                '(' => depth += 1,
                ')' => depth -= 1,
                _ => {}
            }
            (depth == 0).then_some(at)
        });
        let Some(end) = end else { return Err(self.not_a_time_derivative(begin)) };
        let inside = self.rest(0)[..end].replace([' ', '(', ')'], "");
        self.at += end + 1;
        match inside.as_str() {
            ",t" => Ok(1),
            ",t,2" | ",t,t" => Ok(2),
            _ => Err(self.not_a_time_derivative(begin)),
        }
    }

    /// Creates the error for a derivative that is not the time derivative of a symbol.
    fn not_a_time_derivative(&self, begin: usize) -> ParseError {
        let place = begin..self.at.max(begin);
        translation_error(
            place,
            "this is not a derivative of one symbol by time",
            "write Derivative(q(t), t) or Derivative(q(t), (t, 2))",
        )
    }
}
