//! Printed programs (listings) that compute the time derivative of a state, and the reading of them.

use crate::algebra::Expr;
use crate::algebra::text::print::print_text;
use crate::mechanics::{Formulation, MotionVariables};
use crate::publication::entries::EntryTable;
use crate::publication::publication_reader::PublicationReader;
use crate::publication::systems::printed_system::{Matrix, MatrixRequirements, count_with_noun};
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::DeValue;

/// Printed program that computes the time derivative of a state.
/// The state has coordinates q and motion variables in any order. The motion variables are u, or q̇
/// for Lagrange.
#[derive(Clone, Debug)]
pub struct Listing {
    /// Formulation whose derived equations the printed program is compared with.
    pub formulation: Formulation,
    /// Variables of the state, z(1), z(2), …, each once: coordinates and generalized speeds. For
    /// Lagrange, rates replace speeds.
    pub state: Vec<Expr>,
    /// Names of the state's variables, in the order of `state`.
    pub state_names: Vec<String>,
    /// Assigned derivatives dz(1), dz(2), …; if the program has a matrix, before they are divided
    /// by it.
    pub derivative: Vec<Expr>,
    /// Printed texts of the assigned derivatives.
    pub derivative_texts: Vec<String>,
    /// Indices, in the state, of the motion variables u or q̇.
    pub moving: Vec<usize>,
    /// Square matrix E of dz = E \ dz, with a row and a column for each motion variable; `None` if
    /// the program has none.
    pub matrix: Option<Vec<Vec<Expr>>>,
    /// Printed texts of the matrix entries, row by row; `None` if the program has no matrix.
    pub matrix_texts: Option<Vec<Vec<String>>>,
}

impl Listing {
    /// Id of the program's assigned derivative with the index `at`, from 0; `id` is the id of the
    /// program's entry.
    #[must_use]
    pub fn derivative_id(&self, id: &str, at: usize) -> String {
        format!("{id}-dz{}", at + 1)
    }

    /// Id of the program's matrix entry in `row` and `column`, from 0; `id` is the id of the
    /// program's entry.
    #[must_use]
    pub fn matrix_id(&self, id: &str, row: usize, column: usize) -> String {
        // With more than nine rows, the pairs (1, 11) and (11, 1) would read the same without a
        // comma.
        let comma = if self.state.len() > 18 { "," } else { "" };
        format!("{id}-E{}{comma}{}", row + 1, column + 1)
    }

    /// Ids of all derivatives and matrix entries that the program assigns; `id` is the id of its
    /// entry.
    pub(in crate::publication) fn ids(&self, id: &str) -> Vec<String> {
        let mut ids: Vec<String> = (0..self.derivative.len()).map(|at| self.derivative_id(id, at)).collect();
        for (i, row) in self.matrix.iter().flatten().enumerate() {
            ids.extend((0..row.len()).map(|j| self.matrix_id(id, i, j)));
        }
        ids
    }
}

impl<'a> PublicationReader<'a, '_> {
    /// Reads an entry `[[listing]]`: a printed program that computes the time derivative of a
    /// state.
    /// Returns `None` if an error is reported.
    pub fn read_listing(&mut self, item: &EntryTable<'a>) -> Option<Listing> {
        let formulation = self.read_system_formulation(item);
        let state = self.required_entry_array(item, "state", "[\"q1\", \"u1\"]");
        let length = state.as_ref().map(|(array, _)| array.len());
        let state = state.and_then(|(array, span)| {
            let found = self.read_listing_state(array, &span, formulation?)?;
            self.is_listing_state_in_order(&span, &found.0).then_some(found)
        });
        let derivative = self.required_entry_array(item, "derivative", "[\"u1\", \"-g*sin(q1)\"]");
        let derivative = derivative.and_then(|(array, span)| {
            if let Some(states) = length.filter(|n| *n != array.len()) {
                let message =
                    format!("`derivative` has {} for a state of {states}", count_with_noun(array.len(), "entry"));
                self.reader.error(span, message, "one derivative for each entry of the state, 0 where it is left zero");
                return None;
            }
            self.read_system_formulas(array, "an entry of `derivative`", &[], item.notation)
        });
        let moving = state.as_ref().map(|(_, _, moving)| moving.len());
        let matrix = match self.reader.get(item.table, "matrix") {
            None => Some(None),
            Some(value) => {
                self.require_array(value, "`matrix`", "rows, as in [[\"m\", 0], [0, \"I\"]]").and_then(|array| {
                    let (span, help) = (value.span(), "one row and one column for each speed of the state");
                    if let Some(moving) = moving.filter(|moving| *moving != array.len()) {
                        let message = format!("the matrix has {}, not {moving}", count_with_noun(array.len(), "row"));
                        self.reader.error(span, message, help);
                        return None;
                    }
                    self.read_system_matrix(
                        array,
                        &span,
                        MatrixRequirements { columns: moving, help, unknowns: &[], notation: item.notation },
                    )
                    .map(Some)
                })
            }
        };
        let ((state, state_names, moving), (mut derivative, mut derivative_texts)) = (state?, derivative?);
        let mut matrix = matrix?;
        if matrix.is_none() {
            matrix = self.matrix_of_listing_solution(&moving, &mut derivative, &mut derivative_texts);
        }
        let (matrix, matrix_texts) = matrix.unzip();
        let formulation = formulation?;
        let (state, derivative, matrix) =
            self.state_in_model_coordinates(&state_names, (state, derivative, matrix), item)?;
        let moving = (0..state.len()).filter(|at| formulation.variables(self.model).contains(&state[*at])).collect();
        Some(Listing { formulation, state, state_names, derivative, derivative_texts, moving, matrix, matrix_texts })
    }

    /// Matrix of a linear system that the program solves for the derivatives of the motion variables,
    /// which are at the places `moving`, with the texts of its entries. Its right side replaces these
    /// derivatives. `None` if the program solves no such system.
    fn matrix_of_listing_solution(
        &self,
        moving: &[usize],
        derivative: &mut [Expr],
        derivative_texts: &mut [String],
    ) -> Option<Matrix> {
        let values: Vec<Expr> = moving.iter().map(|at| derivative[*at]).collect();
        let solution = self.words.locals.linear_solution(&values)?;
        let text = |e: &Expr| print_text(&self.model.arena, *e);
        for (at, right) in moving.iter().zip(&solution.right) {
            (derivative[*at], derivative_texts[*at]) = (*right, text(right));
        }
        let texts = solution.matrix.iter().map(|row| row.iter().map(text).collect()).collect();
        Some((solution.matrix.clone(), texts))
    }

    /// True unless the program unpacks the variables of the state from a vector in another order,
    /// which is reported.
    fn is_listing_state_in_order(&mut self, span: &Range<usize>, state: &[Expr]) -> bool {
        let locals = Arc::clone(&self.words.locals);
        for names in locals.unpacked_variables().iter().filter(|names| names.len() == state.len()) {
            let meanings: Option<Vec<Expr>> = names.iter().map(|name| Some(self.words.meaning(name)?.0)).collect();
            let is_other = |list: &Vec<Expr>| list != state && list.iter().all(|e| state.contains(e));
            if meanings.as_ref().is_some_and(is_other) {
                let message = format!("the program takes its state apart as `{}`, in another order", names.join(", "));
                let help = "list the state as the program does: its derivatives are judged in that order";
                self.reader.error(span.clone(), message, help);
                return false;
            }
        }
        true
    }

    /// Reads the state of a printed program (listing): coordinates and motion variables in any
    /// order.
    /// Returns their symbols, their names, and the indices of the motion variables. These are the
    /// generalized speeds, or the rates of the coordinates for Lagrange. `None` if an error is
    /// reported.
    fn read_listing_state(
        &mut self,
        array: &'a [Spanned<DeValue<'a>>],
        span: &Range<usize>,
        formulation: Formulation,
    ) -> Option<(Vec<Expr>, Vec<String>, Vec<usize>)> {
        let model = &self.model;
        let variables = formulation.variables(model);
        let named = |symbol: &Expr| (model.arena.symbol_name(*symbol).unwrap_or_default().to_owned(), *symbol);
        let known: Vec<(String, Expr)> = model.q().iter().chain(&variables).map(named).collect();
        let what = match formulation.method().variables {
            MotionVariables::Rates => "a coordinate or its derivative, as a state of Lagrange's equations has",
            MotionVariables::Speeds => "a coordinate or a speed",
        };
        let (state, names) = self.read_names_from_list(array, span, &known, what)?;
        let moving = (0..state.len()).filter(|at| variables.contains(&state[*at])).collect();
        Some((state, names, moving))
    }
}
