//! Calls in program text that model files write in another form: `pow(x, 2)`, `Rational(1, 2)`,
//! `deg2rad(10)`.

use super::kind::Notation;
use super::translation::Translation;
use super::translation_errors::translation_error;
use crate::algebra::text::parse::ParseError;
use std::ops::Range;

/// Rule that rewrites the call of a function of a program into the language of model files.
#[derive(Clone, Copy)]
struct Form {
    /// Name of the function in programs.
    name: &'static str,
    /// Notations (programming languages) that have the function.
    of: &'static [Notation],
    /// Tokens that replace the name and its opening parenthesis.
    open: &'static [&'static str],
    /// Tokens that replace the comma between two arguments; `None` if the function has one
    /// argument.
    comma: Option<&'static [&'static str]>,
    /// Tokens that replace the closing parenthesis of the call.
    close: &'static [&'static str],
}

/// Tokens of a power, (base)^(exponent): for the opening parenthesis, the comma and the closing
/// parenthesis.
const POWER: (&[&str], Option<&[&str]>, &[&str]) = (&["(", "("], Some(&[")", "^", "("]), &[")", ")"]);

/// Rules for all functions whose calls are rewritten.
const FORMS: [Form; 8] = [
    Form { name: "pow", of: &[Notation::C, Notation::Python], open: POWER.0, comma: POWER.1, close: POWER.2 },
    Form { name: "powf", of: &[Notation::C], open: POWER.0, comma: POWER.1, close: POWER.2 },
    Form { name: "Pow", of: &[Notation::Python], open: POWER.0, comma: POWER.1, close: POWER.2 },
    Form { name: "power", of: &[Notation::Matlab, Notation::Python], open: POWER.0, comma: POWER.1, close: POWER.2 },
    Form {
        name: "Rational",
        of: &[Notation::Python],
        open: &["(", "("],
        comma: Some(&[")", "/", "("]),
        close: &[")", ")"],
    },
    Form { name: "S", of: &[Notation::Python], open: &["("], comma: None, close: &[")"] },
    Form { name: "Integer", of: &[Notation::Python], open: &["("], comma: None, close: &[")"] },
    Form {
        name: "deg2rad",
        of: &[Notation::Matlab, Notation::Python],
        open: &["(", "("],
        comma: None,
        close: &[")", "*", "pi", "/", "180", ")"],
    },
];

/// Stack of open parentheses, each with the rule that rewrites its commas and its end.
#[derive(Default)]
pub(super) struct Calls(Vec<Call>);

/// An open parenthesis in the stack: of a function call or of a group.
struct Call {
    /// Rule that rewrites the call; `None` for an ordinary parenthesis.
    form: Option<&'static Form>,
    /// Number of commas that must still follow; 0 for an ordinary parenthesis, whose commas are not
    /// counted.
    commas: usize,
    /// Place of the call in the original text, in bytes.
    place: Range<usize>,
}

impl Calls {
    /// True if at least one parenthesis of the formula is open.
    pub(super) fn is_open(&self) -> bool {
        !self.0.is_empty()
    }

    /// Appends the opening `tokens` of an ordinary parenthesis to `out` and puts the parenthesis on
    /// the stack.
    pub(super) fn open(&mut self, out: &mut Translation, tokens: &[&str], place: &Range<usize>) {
        out.push_all(tokens, place);
        self.0.push(Call { form: None, commas: 0, place: place.clone() });
    }

    /// Opens a call that model files write in another form, such as `pow(x, 2)`. False if `word` is
    /// not a function with a rewriting rule.
    pub(super) fn open_rewritten_call(
        &mut self,
        out: &mut Translation,
        word: &str,
        notation: Notation,
        place: &Range<usize>,
    ) -> bool {
        let Some(form) = FORMS.iter().find(|form| form.name == word && form.of.contains(&notation)) else {
            return false;
        };
        out.push_all(form.open, place);
        self.0.push(Call { form: Some(form), commas: usize::from(form.comma.is_some()), place: place.clone() });
        true
    }

    /// Translates a comma between arguments. Error if a rewritten function has too many arguments.
    pub(super) fn comma(&mut self, out: &mut Translation, place: &Range<usize>) -> Result<(), ParseError> {
        let Some(Call { form: Some(form), commas, .. }) = self.0.last_mut() else {
            out.push(",", place.clone());
            return Ok(());
        };
        let Some(tokens) = form.comma.filter(|_| *commas > 0) else {
            let message = format!("`{}` has too many arguments", form.name);
            return Err(translation_error(
                place.clone(),
                message,
                "remove what follows, or write it as a product or sum",
            ));
        };
        *commas -= 1;
        out.push_all(tokens, place);
        Ok(())
    }

    /// Translates a closing parenthesis. Error if a rewritten function has too few arguments.
    pub(super) fn close(&mut self, out: &mut Translation, place: &Range<usize>) -> Result<(), ParseError> {
        let Some(call) = self.0.pop() else { return Ok(()) };
        let Some(form) = call.form else {
            out.push(")", place.clone());
            return Ok(());
        };
        // Rational(3) is complete without a comma: it is the integer 3, like S(3).
        if call.commas > 0 && form.name != "Rational" {
            let message = format!("`{}` has two arguments", form.name);
            return Err(translation_error(call.place, message, &format!("write {}(x, 2)", form.name)));
        }
        out.push_all(form.close, place);
        Ok(())
    }
}
