//! Equations of motion in the form matrix · unknowns = forcing. They come from a formulation, a publication or a
//! reduction.

use super::derive_error::DeriveError;
use super::equations_origin::EquationsOrigin;
use super::formulations::formulation::Formulation;
use super::motion::kinematics::{Kinematics, MotionVariables};
use super::rows::{AccelerationEmbedding, RowName, Rows};
use super::singular_distance::SingularDistance;
use crate::algebra::solve::quadratic_minimum::QuadraticForm;
use crate::algebra::term::calculus::{Differential, Gradient};
use crate::algebra::term::steps::Definition;
use crate::algebra::text::definitions::write_definitions;
use crate::algebra::{Arena, Expr};
use crate::model::{Model, MotionConstraintKind};

/// Largest number of definitions of equations that are solved in closed form.
const MOST_WRITTEN_OUT: usize = 40;

/// Equations of motion: matrix · unknowns = forcing, and q̇ = `coordinate_rates`.
#[derive(Clone, Debug)]
pub struct Equations {
    /// Origin of the equations: a formulation, a publication or a reduction.
    pub by: EquationsOrigin,
    /// Distance of a coordinate from a fixed value, if this distance replaces the coordinate. `None` if all
    /// coordinates are the model's own.
    pub distance: Option<SingularDistance>,
    /// Formulation that chose the motion variables v (speeds u or rates q̇) and the unknowns of these
    /// equations.
    pub formulation: Formulation,
    /// Definitions symbol = term, in parameters, q and v, whose symbols occur in the other fields. A definition comes
    /// after the definitions that its term contains. Empty except in reduced equations and after
    /// [`Self::with_definitions`].
    pub definitions: Vec<Definition>,
    /// Symbols of the generalized coordinates q. A distance may replace one of them
    /// ([`super::equations_in_distance`]).
    pub coordinates: Vec<Expr>,
    /// Symbols of the motion variables v, which are integrated together with q: u, or q̇ for Lagrange.
    pub variables: Vec<Expr>,
    /// Symbols of the unknowns: first the accelerations v̇, then the reactions or the constraint multipliers.
    pub unknowns: Vec<Expr>,
    /// Names of the rows. A row belongs to a speed, a coordinate, a constraint or a balance of a body.
    pub rows: Vec<RowName>,
    /// Square matrix of the equations, one column for each unknown; in parameters, q and v.
    pub matrix: Vec<Vec<Expr>>,
    /// Right-hand side of the equations, one entry for each row, in parameters, q and v.
    pub forcing: Vec<Expr>,
    /// True if the matrix is symmetric by construction, and positive definite wherever it is regular.
    pub symmetric: bool,
    /// Multipliers of the rows: one list for each generalized speed, with one entry for each row. They are the
    /// partial velocities. With them, the rows add up to a symmetric, positive definite system without reactions and
    /// multipliers of constraints. Empty if the equations have none of these.
    pub projection: Vec<Vec<Expr>>,
    /// Map from the free accelerations to v̇; the projected system determines the free accelerations. `None` unless
    /// motion constraints leave fewer free accelerations than v has entries.
    pub embedding: Option<AccelerationEmbedding>,
    /// Rates q̇ of the generalized coordinates as terms in q and the motion variables v, one for each coordinate.
    pub coordinate_rates: Vec<Expr>,
    /// Inverse dynamics M v̇ − f: the generalized forces that accelerations v̇ require in addition to the loads, as
    /// terms in parameters, q, v and v̇. Empty if not computed, or if reactions or multipliers are among the
    /// unknowns.
    pub required: Vec<Expr>,
    /// Function of the bodies' accelerations that is smallest at the actual v̇ (Gauss's principle). For large systems
    /// it is a second way to compute v̇. `None` if not derived.
    pub gauss: Option<QuadraticForm>,
    /// Symbols of the generalized speeds u. Constraints may make them fewer than the motion variables v.
    pub speeds: Vec<Expr>,
    /// Generalized speeds u as terms in q and the motion variables v, one for each speed.
    pub generalized_speeds: Vec<Expr>,
    /// Rates u̇ of the generalized speeds as terms in q, v and v̇.
    pub generalized_speed_rates: Vec<Expr>,
    /// Motion variables v (u, or q̇ for Lagrange) as terms in q and u, one for each variable.
    pub motion_variables: Vec<Expr>,
    /// Kinetic energy T of all bodies, J, as a term in q and the motion variables v.
    pub kinetic_energy: Expr,
    /// Potential energy V of gravity and of all applied loads that have a potential, as a term in q, J.
    pub potential_energy: Expr,
    /// Power d(T + V)/dt of the forces without a potential in V, W, as a term in q and v. It is 0 in reduced
    /// equations, which have their own T and V.
    pub power: Expr,
    /// Divisors of the kinematic equations q̇ = W u + w, as terms in q. The equations are singular in a configuration
    /// in which a divisor is zero.
    pub divisors: Vec<Expr>,
    /// Constraints that hold in every exact motion but drift in a numeric run. They are the loops of the model, and
    /// its motion constraints if v can violate them.
    pub constraints: Vec<Constrained>,
}

/// Constraint that rounding may violate in a run, so that each step must correct the state.
#[derive(Clone, Debug)]
pub struct Constrained {
    /// Name of the constraint in the model file, with a prime for the rate of a loop.
    pub name: String,
    /// Residual of the constraint as a term in q and v. It is zero if the constraint holds.
    pub value: Expr,
    /// Partial derivatives of the residual with respect to each q, then to each v. Those with respect to time and its
    /// rate are set to 0.
    pub slopes: Vec<Expr>,
}

impl Equations {
    /// Name of the equations on the command line and in files, such as `kane`, `kane@q2-90deg` or `printed:ID`.
    #[must_use]
    pub fn name(&self, model: &Model) -> String {
        self.by.name_in(self.distance, model)
    }

    /// Title of the equations for a heading, such as `Kane's method`. If a distance replaces a coordinate, the title
    /// names it.
    #[must_use]
    pub fn title(&self, model: &Model) -> String {
        let title = self.by.title();
        self.distance.map_or_else(|| title.clone(), |distance| format!("{title} in {}", distance.title(model)))
    }

    /// Names of the rows in plain text. A name is for example that of a speed or of a balance.
    #[must_use]
    pub fn row_names(&self, model: &Model) -> Vec<String> {
        self.rows.iter().map(|row| row.text(model)).collect()
    }

    /// True if the equations have more than 40 definitions, which is too many to solve them in closed
    /// form.
    pub(super) fn is_large(&self) -> bool {
        self.definitions.len() > MOST_WRITTEN_OUT
    }

    /// Equations in the form that is solved, differentiated and written as code. A symbol replaces every named term,
    /// and `definitions` lists each symbol with its term.
    #[must_use]
    pub fn with_definitions(&self, arena: &mut Arena) -> Self {
        let mut result = self.clone();
        let values = self.terms(arena);
        let (steps, values) =
            write_definitions(arena, &self.definitions, &values[..values.len() - self.definitions.len()]);
        let mut values = values.into_iter();
        result.definitions.clear();
        result.change_terms(&mut |e, _| *e = values.next().expect("as many as were read"), arena);
        result.definitions = steps;
        result.gauss.clone_from(&self.gauss);
        result
    }

    /// All terms of the equations in a fixed order, with the definitions last.
    pub(super) fn terms(&self, arena: &mut Arena) -> Vec<Expr> {
        let mut terms = Vec::new();
        self.clone().change_terms(&mut |e, _| terms.push(*e), arena);
        terms
    }

    /// Applies `change` to every term of the equations in place. Drops [`Self::gauss`], which would no longer match.
    pub(crate) fn change_terms(&mut self, change: &mut dyn FnMut(&mut Expr, &mut Arena), arena: &mut Arena) {
        self.gauss = None;
        let vectors = [
            &mut self.forcing,
            &mut self.coordinate_rates,
            &mut self.generalized_speeds,
            &mut self.generalized_speed_rates,
            &mut self.motion_variables,
            &mut self.divisors,
            &mut self.required,
        ];
        let embedded = self.embedding.iter_mut().flat_map(|e| e.matrix.iter_mut().chain([&mut e.rest]));
        let matrices = self.matrix.iter_mut().chain(&mut self.projection).chain(embedded);
        let scalars = [&mut self.kinetic_energy, &mut self.potential_energy, &mut self.power];
        let definitions = self.definitions.iter_mut().map(|d| &mut d.value);
        let constraints = self.constraints.iter_mut().flat_map(|c| c.slopes.iter_mut().chain([&mut c.value]));
        for value in vectors.into_iter().chain(matrices).flatten().chain(scalars).chain(constraints).chain(definitions)
        {
            change(value, arena);
        }
    }
}

/// Completes the rows of a formulation to full equations: adds q̇, u, energies, power and constraints. All entries
/// are simplified.
///
/// # Errors
/// Returns [`DeriveError::NoZeroOfPotential`] if V has no value at the configuration where the model sets it to zero.
pub(super) fn equations_from_rows(
    model: &Model,
    kinematics: &mut Kinematics,
    formulation: Formulation,
    rows: Rows,
) -> Result<Equations, DeriveError> {
    let Rows { names, matrix, forcing, projection, embedding, kinetic_energy, required, gauss } = rows;
    let required = required.unwrap_or_default();
    let potential_energy = kinematics.potential_energy(model)?;
    let power = kinematics.power_without_potential(model, formulation.method().variables);
    let rates = &model.kinematic_equations.rates;
    let (generalized_speeds, generalized_speed_rates, coordinate_rates, motion_variables) = match formulation
        .method()
        .variables
    {
        MotionVariables::Speeds => (model.u(), model.speeds.iter().map(|s| s.rate).collect(), rates.clone(), model.u()),
        MotionVariables::Rates => {
            let definitions: Vec<Expr> = model.speeds.iter().map(|s| s.definition).collect();
            let speed_rates = time_derivatives_of_terms(model, &mut kinematics.arena, &definitions);
            (definitions, speed_rates, model.q_dot(), rates.clone())
        }
    };
    let mut equations = Equations {
        by: formulation.into(),
        distance: None,
        formulation,
        definitions: Vec::new(),
        coordinates: model.q(),
        variables: formulation.variables(model),
        unknowns: formulation.unknowns(model).into_iter().map(|(_, symbol)| symbol).collect(),
        rows: names,
        matrix,
        forcing,
        symmetric: formulation.method().symmetric && embedding.is_none(),
        required,
        gauss,
        projection,
        embedding,
        coordinate_rates,
        speeds: model.u(),
        generalized_speeds,
        generalized_speed_rates,
        motion_variables,
        kinetic_energy,
        potential_energy,
        power,
        divisors: model.kinematic_equations.divisors.clone(),
        constraints: enforced_constraints_of_equations(model, kinematics, formulation),
    };
    simplify_equations(kinematics, &mut equations);
    Ok(equations)
}

/// Constraints that a run by the given formulation can violate, with their derivatives: loops and, if v = q̇, motion
/// constraints.
fn enforced_constraints_of_equations(
    model: &Model,
    kinematics: &mut Kinematics,
    formulation: Formulation,
) -> Vec<Constrained> {
    let loops = model.loops.iter().map(|c| (c.name.clone(), c.equation));
    let of_motion = model
        .motion_constraints
        .iter()
        .filter(|c| formulation.is_in_rates() && c.kind != MotionConstraintKind::Clock)
        .map(|c| {
            let prime = if matches!(c.kind, MotionConstraintKind::Loop(_)) { "'" } else { "" };
            (format!("{}{prime}", c.name), c.equation)
        });
    let states = [model.q(), formulation.variables(model)].concat();
    let mut gradient = Gradient::new(&states);
    // The derivative by time is left out, so that corrections change the coordinates and not time.
    let time = model.time().map(|at| &model.coordinates[at]);
    let is_time = |state: Expr| time.is_some_and(|time| state == time.symbol || state == time.rate);
    let Kinematics { arena, simplifier, .. } = kinematics;
    let mut constrained = |(name, value)| {
        let mut slopes = vec![Expr::ZERO; states.len()];
        for &(at, slope) in gradient.apply(arena, value).iter().filter(|(at, _)| !is_time(states[*at])) {
            slopes[at] = simplifier.simplify(arena, slope);
        }
        Constrained { name, value, slopes }
    };
    loops.chain(of_motion).map(&mut constrained).collect()
}

/// Differentiates terms in q and q̇ by time. The results contain q, q̇ and q̈.
fn time_derivatives_of_terms(model: &Model, arena: &mut Arena, terms: &[Expr]) -> Vec<Expr> {
    let mut rates: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
    rates.extend(model.coordinates.iter().map(|c| (c.rate, c.second_rate)));
    let mut d_dt = Differential::along(&rates);
    terms.iter().map(|e| d_dt.apply(arena, *e)).collect()
}

/// Simplifies all entries except the energies, which were simplified when they were derived.
fn simplify_equations(kinematics: &mut Kinematics, equations: &mut Equations) {
    let Kinematics { arena, simplifier, .. } = kinematics;
    let entries = equations.matrix.iter_mut().flatten().chain(&mut equations.forcing);
    let entries = entries.chain(&mut equations.coordinate_rates).chain(&mut equations.generalized_speeds);
    for e in entries.chain(&mut equations.generalized_speed_rates).chain(&mut equations.motion_variables) {
        *e = simplifier.simplify(arena, *e);
    }
}
