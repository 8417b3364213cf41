//! Functions for identification: inverse dynamics as a sum over inertial parameters π_k, M u̇ − f = Σ π_k Y_k + rest.
//!
//! Two sets of parameters have functions: all inertial parameters of the bodies, and the base parameters, which
//! motion can determine. The functions of base parameters are written only if each base parameter is proved to equal
//! a formula in the model's parameters.

use super::programs::function::{Arguments, Function, Returns, Value};
use super::programs::planner::{Planner, Sharing};
use super::programs::variable_names::Language;
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::text::definitions::write_definitions;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::identify::{BaseParameter, BaseParameterFactor, Completeness, Identification};
use tripos_derive::mechanics::{Column, DeriveError, RegressorParameters};
use tripos_derive::{Equations, Model};

/// Regressor of a model's inverse dynamics, from which functions are planned.
pub struct RegressorFunctions {
    /// Arena with the terms of the regressor.
    arena: Arena,
    /// Kane's equations, from which names and arguments are taken. Their definitions are the intermediate terms of
    /// the columns.
    equations: Equations,
    /// Columns of the regressor: an inertial parameter, its formula, and a generalized force for
    /// each speed.
    columns: Vec<Column>,
    /// Part of the generalized forces that contains no inertial parameter, with an entry for each speed.
    rest: Vec<Expr>,
    /// Base parameters with their formulas. `None` unless each base parameter has a proved formula.
    base: Option<Vec<RegressorParameter>>,
}

/// Base parameter with its formula: a combination of inertial parameters that motion can determine.
struct RegressorParameter {
    /// Index of the regressor column whose parameter gives the base parameter its name.
    column: usize,
    /// Formula of the base parameter in the parameters of the model.
    value: Expr,
}

impl RegressorFunctions {
    /// Names of the functions for identification. These functions are long, and written only on request.
    pub const FUNCTIONS: [&'static str; 5] =
        ["regressor", "regressor_rest", "inertial_parameters", "base_regressor", "base_parameters"];

    /// Derives the regressor of a model; `equations` are the model's equations by Kane's method.
    ///
    /// # Errors
    /// Returns a [`DeriveError`] if the regressor of the model cannot be derived.
    pub fn new(model: &Model, equations: &Equations) -> Result<Self, DeriveError> {
        let found = Identification::new(model, RegressorParameters::Bodies)?;
        let is_grouped = found.before_grouping().is_some();
        let Identification { regressor, base, complete, .. } = found;
        let (mut arena, mut columns) = (regressor.arena, regressor.columns);
        // In closed poses, parameters are grouped by numbers of one model, for which there is no formula.
        let is_proved = matches!(complete, Completeness::Proved(_)) && !is_grouped;
        let base = is_proved.then(|| base_regressor_parameters(&mut arena, &columns, &base)).flatten();
        let count = columns.iter().map(|column| column.forces.len()).sum::<usize>();
        let all = columns.iter().flat_map(|column| &column.forces).chain(&regressor.rest).copied();
        let all: Vec<Expr> = all.collect();
        let (definitions, values) = write_definitions(&mut arena, &[], &all);
        let (of_columns, rest) = values.split_at(count);
        let mut of_columns = of_columns.iter();
        for force in columns.iter_mut().flat_map(|column| &mut column.forces) {
            *force = *of_columns.next().expect("a value for each force");
        }
        let equations = Equations { definitions, ..equations.clone() };
        Ok(Self { arena, equations, columns, rest: rest.to_vec(), base })
    }

    /// Plans the functions of the regressor. Names of variables follow the rules of `language`.
    #[must_use]
    pub fn functions(&self, model: &Model, language: &Language) -> Vec<Function> {
        let planner = Planner::new(model, &self.arena, &self.equations, language, Sharing::Shared);
        let all: Vec<usize> = (0..self.columns.len()).collect();
        let about = "Regressor Y of the inverse dynamics Y pi + rest, a row for each speed and a column for each inertial \
                     parameter of `inertial_parameters`.";
        let about_rest = "Part of the inverse dynamics that contains no inertial parameter.";
        let rest: Vec<Value> =
            self.rest.iter().enumerate().map(|(at, e)| entry("rest", at, model.speeds[at].name.clone(), *e)).collect();
        let about_parameters =
            "Inertial parameters of the bodies, and parameters of loads, by the parameters of the model.";
        let stated = self.columns.iter().enumerate();
        let stated: Vec<Value> = stated.map(|(at, c)| entry("inertial", at, c.name.clone(), c.stated)).collect();
        let moving = Arguments::StateAndRates;
        let definitions = &self.equations.definitions;
        let mut list = vec![
            self.plan_regressor_matrix(&planner, "regressor", about, &all),
            planner.plan_function_in_steps("regressor_rest", about_rest, moving, Returns::Vector, definitions, &rest),
            planner.plan_function(
                "inertial_parameters",
                about_parameters,
                Arguments::Parameters,
                Returns::Vector,
                &stated,
            ),
        ];
        if let Some(base) = &self.base {
            let about = "Regressor of the base parameters, which motion can determine: the inverse dynamics is this times \
                         `base_parameters`, plus `regressor_rest`.";
            let kept: Vec<usize> = base.iter().map(|base| base.column).collect();
            list.push(self.plan_regressor_matrix(&planner, "base_regressor", about, &kept));
            let about = "Base parameters by the parameters of the model.";
            let values = base.iter().enumerate();
            let name = |base: &RegressorParameter| self.columns[base.column].name.clone();
            let values: Vec<Value> = values.map(|(at, base)| entry("base", at, name(base), base.value)).collect();
            list.push(planner.plan_function("base_parameters", about, Arguments::Parameters, Returns::Vector, &values));
        }
        list
    }

    /// Plans a function that returns the given columns of the regressor as a matrix, with a row for
    /// each speed.
    fn plan_regressor_matrix(
        &self,
        planner: &Planner<'_>,
        name: &'static str,
        about: &str,
        columns: &[usize],
    ) -> Function {
        let speeds = &planner.model.speeds;
        let values = speeds.iter().enumerate().flat_map(|(row, speed)| {
            columns.iter().enumerate().map(move |(at, column)| {
                let column = &self.columns[*column];
                let label = format!("Y({}, {})", speed.name, column.name);
                entry("factor", row * columns.len() + at, label, column.forces[row])
            })
        });
        let values: Vec<Value> = values.collect();
        let returns = Returns::Table { columns: columns.len() };
        planner.plan_function_in_steps(
            name,
            about,
            Arguments::StateAndRates,
            returns,
            &self.equations.definitions,
            &values,
        )
    }

    /// Returns the names of all inertial parameters and of the base parameters, each list with its
    /// title for a header.
    #[must_use]
    pub fn names(&self) -> [(&'static str, Vec<String>); 2] {
        let all = self.columns.iter().map(|column| column.name.clone()).collect();
        let base = self.base.iter().flatten().map(|base| self.columns[base.column].name.clone()).collect();
        [("Inertial parameters", all), ("Base parameters", base)]
    }
}

/// Returns the base parameters with their formulas. `None` if a combination has a factor without a formula.
fn base_regressor_parameters(
    arena: &mut Arena,
    columns: &[Column],
    base: &[BaseParameter],
) -> Option<Vec<RegressorParameter>> {
    let mut simplifier = Simplifier::default();
    let mut list = Vec::new();
    for base in base {
        let mut value = columns[base.column].stated;
        for (column, factor) in &base.with {
            let BaseParameterFactor::Exact(factor) = factor else { return None };
            let part = arena.mul(*factor, columns[*column].stated);
            value = arena.add(value, part);
        }
        list.push(RegressorParameter { column: base.column, value: simplifier.simplify(arena, value) });
    }
    Some(list)
}

/// Returns a value to be computed, whose variable is `stem` with the number `at` + 1.
fn entry(stem: &str, at: usize, name: String, value: Expr) -> Value {
    (format!("{stem}{}", at + 1), name, value)
}
