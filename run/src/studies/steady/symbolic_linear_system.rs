//! Linear system near a steady motion in which some numbers stay symbols, called letters. An example is
//! the speed of a bicycle.

use super::SteadyProblem;
use super::linear_system::SteadyLinearSystem;
use super::quotient_system::quotient_pivots;
use super::spectra::wide_matrix::WideMatrix;
use crate::{Error, Mechanism};
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::text::display_tree::DisplayTree;
use tripos_derive::algebra::text::print::{print_view, text_of};
use tripos_derive::flow::{LinearSystemError, OperatingPoint, StateElimination, SymbolicLinearSystem};
use tripos_derive::scene::StateWithUnknowns;
use tripos_traits::DoubleDouble;

/// Relative change of an unknown state up to which its guess counts as exact. The guess then holds for
/// every value of the letters (numbers that stay symbols).
const AS_GUESSED: f64 = 1e-12;

/// Entry of a matrix of the linear system, as a function of the letters (numbers that stay symbols).
#[derive(Clone, Debug, PartialEq)]
pub enum SymbolicEntry {
    /// Polynomial in the only letter. The coefficients are in ascending powers, from power 0.
    Polynomial(Vec<f64>),
    /// Formula in the parameters and the letters (numbers that stay symbols).
    Formula(DisplayTree),
}

/// Matrices A, B, C and D of a linear system, as functions of the letters (numbers that stay symbols).
#[derive(Clone, Debug)]
pub struct SymbolicLinearForm {
    /// Names of the letters (numbers that stay symbols).
    pub names: Vec<String>,
    /// Entries of the matrices A, B, C and D, in this order, each row by row.
    pub matrices: [Vec<Vec<SymbolicEntry>>; 4],
}

/// Computes the linear system near a steady motion with some numbers as letters (symbols). `letters` are
/// names of parameters, or of numbers in the state file. The motion is proved to be steady for all values
/// of the letters.
///
/// # Errors
/// [`Error`] if a letter is unknown, if the motion is steady only for some values of the letters, or if
/// an unknown state is known only as a number.
pub fn symbolic_linear_system(
    model: &Mechanism,
    asked: &StateWithUnknowns,
    found: &SteadyLinearSystem,
    letters: &[String],
) -> Result<SymbolicLinearForm, Error> {
    let question = SteadyProblem::new(model, asked, &found.inputs)?;
    let symbols =
        letters.iter().map(|name| find_letter_symbol(model, asked, name)).collect::<Result<Vec<Expr>, Error>>()?;
    for at in &asked.sought {
        let moved = (found.steady.x[*at] - asked.x[*at]).hi().abs();
        if moved.is_nan() || moved > AS_GUESSED * asked.x[*at].hi().abs().max(1.0) {
            let what = format!("`{}` was solved for, and is no formula of {}", question.names[*at], letters.join(", "));
            return Err(Error::request(what, "state it as a formula, or leave the letters out"));
        }
    }
    let parameters = model.parameters.iter().zip(&asked.rational).zip(&asked.parameters);
    let (mut numbers, mut known) = (Vec::new(), Vec::new());
    for ((parameter, exact), value) in parameters {
        // An input has a value too. The derivative by the input is taken before its value is inserted.
        if let (false, Some(exact)) = (symbols.contains(&parameter.symbol), exact) {
            numbers.push((parameter.symbol, exact.clone()));
        }
        if !symbols.contains(&parameter.symbol) {
            known.push((parameter.symbol, *value));
        }
    }
    known.extend(asked.names.iter().filter(|own| !symbols.contains(&own.symbol)).map(|own| (own.symbol, own.value)));
    let inputs = model.parameters.iter().filter(|p| found.inputs.contains(&p.name)).map(|p| p.symbol).collect();
    let outputs = question.output_terms.clone();
    let stated = OperatingPoint { numbers, states: asked.formulas.clone(), inputs, outputs };
    let chosen = question.symbolic_elimination_choices(found);
    let mut system = question
        .flow
        .symbolic_linear_system(&stated, &chosen)
        .map_err(|why| no_symbolic_system_error(&why, letters))?;
    let matrices = system.matrices.clone();
    let matrices = matrices.map(|matrix| {
        matrix
            .iter()
            .map(|row| row.iter().map(|e| symbolic_entry(&mut system, *e, &symbols, &known)).collect())
            .collect()
    });
    Ok(SymbolicLinearForm { names: letters.to_vec(), matrices })
}

/// Makes the error for a linear system that cannot be written in the given letters.
fn no_symbolic_system_error(why: &LinearSystemError, letters: &[String]) -> Error {
    let letters = letters.join(", ");
    match why {
        LinearSystemError::NotSteady => Error::request(
            format!("the motion is not proved to be steady for every value of {letters}"),
            "state values that depend on the letters as formulas, or leave the letters out",
        ),
        LinearSystemError::Singular => {
            Error::Stopped(format!("the linear system has no value for general values of {letters}"))
        }
    }
}

/// Finds the symbol of the letter with the given name: a parameter, or a number of the state file.
///
/// # Errors
/// `Error::Request` if no parameter and no number of the state file has this name.
fn find_letter_symbol(model: &Mechanism, asked: &StateWithUnknowns, name: &String) -> Result<Expr, Error> {
    let own = asked.names.iter().map(|own| (own.name.as_str(), own.symbol));
    let all: Vec<(&str, Expr)> = own.chain(model.parameters.iter().map(|p| (p.name.as_str(), p.symbol))).collect();
    all.iter().find(|(known, _)| known == name).map(|(_, symbol)| *symbol).ok_or_else(|| {
        let help = tripos_derive::diagnostic::nearest_name_advice(name, all.iter().map(|(known, _)| *known));
        Error::request(format!("`{name}` is neither a parameter nor a name of the state file"), help)
    })
}

/// Makes an entry of a matrix from the expression `e`. It is a polynomial in the only letter if possible,
/// and otherwise a formula. `known` are the values of the other symbols.
fn symbolic_entry(
    system: &mut SymbolicLinearSystem,
    e: Expr,
    letters: &[Expr],
    known: &[(Expr, DoubleDouble)],
) -> SymbolicEntry {
    let polynomial = if let [letter] = letters { system.polynomial(e, *letter, known) } else { None };
    let polynomial = polynomial.map(|list| list.iter().map(|c| c.hi()).collect());
    polynomial.map_or_else(|| SymbolicEntry::Formula(print_view(&system.arena, e)), SymbolicEntry::Polynomial)
}

impl SymbolicEntry {
    /// True if the entry is a polynomial that is 0 for every value of the letter. Always false for a
    /// formula.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        matches!(self, Self::Polynomial(list) if list.iter().all(|c| c.abs() <= 0.0))
    }

    /// Writes the entry in the notation of model files, with numbers in their shortest decimal form.
    /// `letter` is the name of the letter in a polynomial.
    #[must_use]
    pub fn text(&self, letter: &str) -> String {
        text_of(&self.view(letter, &|x| x.to_string()))
    }

    /// Makes a tree of the entry, which can be written in any notation. `letter` is the name of the letter
    /// in a polynomial. `decimals` writes the absolute values of its coefficients.
    #[must_use]
    pub fn view(&self, letter: &str, decimals: &dyn Fn(f64) -> String) -> DisplayTree {
        let coefficients = match self {
            Self::Formula(view) => return view.clone(),
            Self::Polynomial(coefficients) => coefficients,
        };
        let term = |(power, c): (usize, &f64)| {
            let number = DisplayTree::Number(decimals(c.abs()));
            let name = DisplayTree::Name(letter.to_owned());
            let term = match i32::try_from(power) {
                Ok(0) => number,
                Ok(1) => DisplayTree::Product(vec![number, name]),
                power => {
                    DisplayTree::Product(vec![number, DisplayTree::Power(Box::new(name), power.unwrap_or(i32::MAX))])
                }
            };
            (*c < 0.0, term)
        };
        let terms: Vec<(bool, DisplayTree)> =
            coefficients.iter().enumerate().filter(|(_, c)| c.abs() > 0.0).map(term).collect();
        if terms.is_empty() { DisplayTree::Number("0".to_owned()) } else { DisplayTree::Sum(terms) }
    }
}

impl SteadyProblem {
    /// Collects the states and symmetries that the numeric linear system eliminated. The symbolic
    /// elimination must repeat the same choices.
    fn symbolic_elimination_choices(&self, found: &SteadyLinearSystem) -> StateElimination {
        let (values, _) = self.program.evaluate(&self.wide, &self.parameters, &found.steady.x, &[]);
        let carriers = found.steady.active_symmetries();
        let fields: Vec<Vec<DoubleDouble>> = carriers.iter().map(|at| values.symmetries[*at].clone()).collect();
        let all: Vec<usize> = (0..self.names.len()).collect();
        let (rows, columns) = quotient_pivots(&WideMatrix::from_columns(self.names.len(), &fields).rounded(), &[&all]);
        StateElimination {
            kept: found.system.kept.clone(),
            closed: found.system.closed.clone(),
            shifted: found.system.shifted.clone(),
            symmetries: found.system.symmetries.clone(),
            carried: (rows, columns.into_iter().map(|column| carriers[column]).collect()),
        }
    }
}
