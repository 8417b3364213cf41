//! Calls that the language of model files writes otherwise: `pow(x, 2)`, `Rational(1, 2)`, `deg2rad(10)`.

use super::kind::Notation;
use super::plain::Plain;
use super::refusal::wrong;
use crate::algebra::text::parse::ParseError;
use std::ops::Range;

/// Rewriting of a call into the language of model files.
#[derive(Clone, Copy)]
struct Form {
    /// Name of the function; `of` lists the notations that have it.
    name: &'static str,
    of: &'static [Notation],
    /// Tokens that replace the name with its parenthesis; `comma` and `close` replace the comma and the closing
    /// parenthesis.
    open: &'static [&'static str],
    comma: Option<&'static [&'static str]>,
    close: &'static [&'static str],
}

const POWER: (&[&str], Option<&[&str]>, &[&str]) = (&["(", "("], Some(&[")", "^", "("]), &[")", ")"]);

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

/// Open parentheses, each with the tokens that replace its commas and its end.
#[derive(Default)]
pub(super) struct Calls(Vec<Call>);

struct Call {
    form: Option<&'static Form>,
    /// Number of commas still to come; 0 for an ordinary call, whose commas are not counted.
    commas: usize,
    place: Range<usize>,
}

impl Calls {
    pub(super) fn is_open(&self) -> bool {
        !self.0.is_empty()
    }

    /// Opens an ordinary parenthesis.
    pub(super) fn open(&mut self, out: &mut Plain, tokens: &[&str], place: &Range<usize>) {
        out.push_all(tokens, place);
        self.0.push(Call { form: None, commas: 0, place: place.clone() });
    }

    /// Opens a call that model files write otherwise, such as `pow(x, 2)`; false if the word is no such function.
    pub(super) fn rewritten(&mut self, out: &mut Plain, word: &str, notation: Notation, place: &Range<usize>) -> bool {
        let Some(form) = FORMS.iter().find(|form| form.name == word && form.of.contains(&notation)) else {
            return false;
        };
        out.push_all(form.open, place);
        self.0.push(Call { form: Some(form), commas: usize::from(form.comma.is_some()), place: place.clone() });
        true
    }

    pub(super) fn comma(&mut self, out: &mut Plain, place: &Range<usize>) -> Result<(), ParseError> {
        let Some(Call { form: Some(form), commas, .. }) = self.0.last_mut() else {
            out.push(",", place.clone());
            return Ok(());
        };
        let Some(tokens) = form.comma.filter(|_| *commas > 0) else {
            let message = format!("`{}` has too many arguments", form.name);
            return Err(wrong(place.clone(), message, "remove what follows, or write it as a product or sum"));
        };
        *commas -= 1;
        out.push_all(tokens, place);
        Ok(())
    }

    pub(super) fn close(&mut self, out: &mut Plain, place: &Range<usize>) -> Result<(), ParseError> {
        let Some(call) = self.0.pop() else { return Ok(()) };
        let Some(form) = call.form else {
            out.push(")", place.clone());
            return Ok(());
        };
        // S(1) and Rational(3) are whole.
        if call.commas > 0 && form.name != "Rational" {
            let message = format!("`{}` has two arguments", form.name);
            return Err(wrong(call.place, message, &format!("write {}(x, 2)", form.name)));
        }
        out.push_all(form.close, place);
        Ok(())
    }
}
