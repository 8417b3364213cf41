//! Added mass of a body, as a model file states it under the key `added_mass`.
//!
//! The fluid around a body moves with it and adds the kinetic energy T = ½ νᵀ M_A ν. Here ν = (v, ω) has components
//! in the body's frame, and v is the velocity of a point fixed in the body.
//!
//! The matrix M_A is stored about the mass centre C. Let r be the vector from C to the point, so that v = v_C + ω ×
//! r. Then ν = S ν_C with `S = [1, −r×; 0, 1]`, and the matrix about C is Sᵀ M_A S.

use super::elements::Elements;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::model::reading::declared_names::{NameKind, PARAMETERS};
use crate::model::reading::loading::Loading;
use crate::model::units::Unit;
use crate::model::{AddedMass, Parameter, impossible_bodies};
use crate::toml_reader::Located;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Number of rows and columns of an added mass matrix: three for v, then three for ω.
const SIZE: usize = 6;
/// Advice for an added mass that is stated in a wrong form.
const FORM: &str =
    "write { diagonal = [\"X\", \"Y\", \"Z\", \"K\", \"M\", \"N\"] }, or matrix = six rows of six formulas";

/// Added mass matrix, 6 × 6, in kg, kg m and kg m².
type Matrix = [[Expr; SIZE]; SIZE];

impl Elements {
    /// Reads the added mass of a body, if its entry has the key `added_mass`, and transforms the matrix to the mass
    /// centre. `frame` is the index of the body's frame. Errors are recorded in the reader.
    pub(super) fn read_added_mass<'a>(
        &mut self,
        loading: &mut Loading<'a>,
        entry: &'a DeTable<'a>,
        body: usize,
        frame: usize,
    ) {
        let Some(value) = loading.reader.get(entry, "added_mass") else { return };
        let what = "an added mass";
        let Some(table) = loading.reader.table(value, what, "{ diagonal = […] }") else { return };
        loading.reader.report_unknown_keys(table, what, &["diagonal", "matrix", "about_point"]);
        let matrix = match (loading.reader.get(table, "diagonal"), loading.reader.get(table, "matrix")) {
            (Some(diagonal), None) => diagonal_added_mass(loading, diagonal),
            (None, Some(matrix)) => full_added_mass(loading, matrix),
            (Some(_), Some(second)) => {
                loading.reader.error(second.span(), "`matrix` beside `diagonal`", FORM);
                None
            }
            (None, None) => {
                loading.reader.error(value.span(), "an added mass without `diagonal` and `matrix`", FORM);
                None
            }
        };
        let arm = match loading.reader.get(table, "about_point") {
            None => Some([Expr::ZERO; 3]),
            Some(at) => {
                let point = self.point(loading, table, "about_point", what, &value.span());
                point.and_then(|point| {
                    let arm = self.vector_between_points(&mut loading.arena, self.bodies[body].centre, point, frame);
                    let fixed = arm.filter(|arm| is_added_mass_arm_constant(loading, arm));
                    if fixed.is_none() {
                        let help = "the mass centre must be placed from that point, or that point from it, in the \
                                    body's frame, at a constant place";
                        loading.reader.error(at.span(), "the added mass cannot be moved to the mass centre", help);
                    }
                    fixed
                })
            }
        };
        if let (Some(matrix), Some(arm)) = (matrix, arm) {
            let tensor = added_mass_about_centre(&mut loading.arena, &matrix, arm);
            self.added_masses.push(AddedMass { body, tensor });
        }
    }

    /// Reports added masses whose kinetic energy can be negative at the default values of the
    /// parameters.
    pub(super) fn check_added_masses(&self, loading: &mut Loading<'_>, parameters: &[Parameter]) {
        let known = impossible_bodies::default_parameter_values(parameters);
        for added in &self.added_masses {
            let name = &self.bodies[added.body].name;
            if let Some((message, help)) =
                impossible_bodies::impossible_added_mass_message(&loading.arena, &known, added, name, "the default")
            {
                let span = loading.names.span(name).unwrap_or_default();
                loading.reader.error(span, message, help);
            }
        }
    }
}

/// True if three components contain no symbols other than parameters. A vector with such components is constant in
/// its frame.
fn is_added_mass_arm_constant(loading: &Loading<'_>, components: &[Expr; 3]) -> bool {
    let (arena, names) = (&loading.arena, &loading.names);
    let parts = arena.reachable(components);
    parts.iter().filter_map(|e| arena.symbol_name(*e)).all(|name| names.kind(name) == Some(NameKind::Parameter))
}

/// Unit of the entry in row i and column j of an added mass matrix: kg, kg m or kg m².
fn added_mass_unit(i: usize, j: usize) -> Unit {
    Unit::new(i64::from(i >= 3) + i64::from(j >= 3), 1, 0)
}

/// Reads the entry in row i and column j of an added mass matrix as a term. `None` after an error is reported.
fn added_mass_entry(loading: &mut Loading<'_>, formula: &Located, i: usize, j: usize) -> Option<Expr> {
    let what = format!("entry {}, {} of an added mass", i + 1, j + 1);
    loading.quantity(formula, PARAMETERS, &added_mass_unit(i, j), &what)
}

/// Reads a list of six values, which the error message calls `what`. `None` after reporting a value that is no list
/// of six.
fn six_values<'a>(
    loading: &mut Loading<'a>,
    value: &'a Spanned<DeValue<'a>>,
    what: &str,
) -> Option<Vec<&'a Spanned<DeValue<'a>>>> {
    match value.get_ref() {
        DeValue::Array(array) if array.len() == SIZE => Some(array.iter().collect()),
        DeValue::Array(array) => {
            loading.reader.error(value.span(), format!("{what} has {} entries for 6", array.len()), FORM);
            None
        }
        _ => {
            loading.reader.error(value.span(), format!("{what} must be an array"), FORM);
            None
        }
    }
}

/// Reads a diagonal added mass matrix from six formulas; `None` after an error is reported.
fn diagonal_added_mass<'a>(loading: &mut Loading<'a>, value: &'a Spanned<DeValue<'a>>) -> Option<Matrix> {
    let mut matrix = [[Expr::ZERO; SIZE]; SIZE];
    for (i, value) in six_values(loading, value, "the diagonal of an added mass")?.into_iter().enumerate() {
        let formula = loading.reader.formula(value, "an entry of `diagonal`")?;
        matrix[i][i] = added_mass_entry(loading, &formula, i, i)?;
    }
    Some(matrix)
}

/// Reads a full, symmetric added mass matrix from six rows of six formulas; `None` after an error
/// is reported.
fn full_added_mass<'a>(loading: &mut Loading<'a>, value: &'a Spanned<DeValue<'a>>) -> Option<Matrix> {
    let mut matrix = [[Expr::ZERO; SIZE]; SIZE];
    let mut texts: Vec<Vec<String>> = Vec::new();
    for (i, row) in six_values(loading, value, "the matrix of an added mass")?.into_iter().enumerate() {
        texts.push(Vec::new());
        for (j, value) in six_values(loading, row, "a row of an added mass")?.into_iter().enumerate() {
            let formula = loading.reader.formula(value, "an entry of `matrix`")?;
            // A number with a unit that occurs on both sides of the diagonal is a single parameter.
            let is_repeated = i > j && texts[j][i] == formula.text;
            matrix[i][j] = if is_repeated { matrix[j][i] } else { added_mass_entry(loading, &formula, i, j)? };
            texts[i].push(formula.text.clone());
            let difference = loading.arena.sub(matrix[i][j], matrix[j][i]);
            if i > j && zero_test(&loading.arena, difference) != ZeroTest::Zero {
                let message = format!(
                    "the added mass is not symmetric: entries {}, {} and {}, {} differ",
                    i + 1,
                    j + 1,
                    j + 1,
                    i + 1
                );
                loading.reader.error(formula.span, message, "an added mass is the matrix of a kinetic energy: M = Mᵀ");
                return None;
            }
        }
    }
    Some(matrix)
}

/// Added mass matrix Sᵀ M S about the mass centre C, computed from the matrix M about a point. `arm` is the vector
/// from C to that point, m.
fn added_mass_about_centre(arena: &mut Arena, matrix: &Matrix, arm: [Expr; 3]) -> Matrix {
    if arm == [Expr::ZERO; 3] {
        return *matrix;
    }
    let [x, y, z] = arm;
    let [back_x, back_y, back_z] = arm.map(|e| arena.neg(e));
    // ω × r = −r × ω.
    let cross = [[Expr::ZERO, z, back_y], [back_z, Expr::ZERO, x], [y, back_x, Expr::ZERO]];
    let shift: Matrix = std::array::from_fn(|i| {
        std::array::from_fn(|j| match (i < 3, j < 3) {
            (true, false) => cross[i][j - 3],
            _ if i == j => Expr::ONE,
            _ => Expr::ZERO,
        })
    });
    let transposed: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| shift[j][i]));
    let right = added_mass_product(arena, matrix, &shift);
    added_mass_product(arena, &transposed, &right)
}

/// Product of two 6 × 6 matrices.
fn added_mass_product(arena: &mut Arena, a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let terms: Vec<Expr> = (0..SIZE).map(|k| arena.mul(a[i][k], b[k][j])).collect();
            arena.sum(&terms)
        })
    })
}
