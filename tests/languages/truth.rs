//! Values of functions by the compiled equations and, for functions that these do not have, by the formulas of the
//! model.

use crate::sympy;
use std::rc::Rc;
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::{Numeric, Tape};
use tripos_traits::{CompiledSystem, DoubleDouble, Real, Scalar, System};

type Dd = DoubleDouble;

/// Formulas of a model in p, q, q̇ and u.
pub struct Stated {
    /// Conditions of the domain that contain no reaction.
    conditions: Tape,
    /// Residuals of redundant loops.
    redundant: Tape,
}

impl Stated {
    pub fn read(model: &str) -> Rc<Self> {
        let model = Model::read(&sympy::root().join("models").join(model).join("model.toml")).unwrap();
        let has_reaction = |e: Expr| model.reactions.iter().any(|r| model.arena.mentions(e, r.symbol));
        let conditions: Vec<Expr> = model.domain.iter().map(|c| c.positive).filter(|e| !has_reaction(*e)).collect();
        let redundant: Vec<Expr> = model.closed.iter().map(|c| c.equation).collect();
        let inputs = [model.p(), model.q(), model.q_dot(), model.u()].concat();
        let tape = |values: &[Expr]| Tape::new(&model.arena, &inputs, values).map_err(|symbol| symbol.0).unwrap();
        Rc::new(Self { conditions: tape(&conditions), redundant: tape(&redundant) })
    }
}

/// Source of the right values for one set of equations.
#[derive(Clone)]
pub struct Truth {
    pub system: &'static CompiledSystem,
    pub stated: Rc<Stated>,
}

impl Truth {
    /// Value of a function in doubles; `None` for a function that is not known.
    pub fn double(&self, name: &str, state: &[Vec<f64>; 5]) -> Option<Vec<f64>> {
        self.formulas(self.system.double, name, state).or_else(|| value(self.system.double, name, state))
    }

    /// Value of a function to 32 digits.
    pub fn exact(&self, name: &str, state: &[Vec<Dd>; 5]) -> Option<Vec<Dd>> {
        match name {
            "parameter_jacobian" => parameter_slopes(self.system.extended, state),
            name => {
                self.formulas(self.system.extended, name, state).or_else(|| value(self.system.extended, name, state))
            }
        }
    }

    fn formulas<S: Real + Numeric>(&self, system: &dyn System<S>, name: &str, state: &[Vec<S>; 5]) -> Option<Vec<S>> {
        let tape = match name {
            "conditions" => &self.stated.conditions,
            "redundant_constraints" => &self.stated.redundant,
            _ => return None,
        };
        let [p, q, v, ..] = state;
        let lengths = system.lengths();
        let (mut q_dot, mut u) = (vec![S::int(0); lengths.coordinates], vec![S::int(0); lengths.speeds]);
        system.coordinate_rates(p, q, v, &mut q_dot);
        system.generalized_speeds(p, q, v, &mut u);
        Some(tape.to::<S>().evaluate(&[p.as_slice(), q, &q_dot, &u].concat()))
    }
}

/// Number of values of a function by the compiled equations; `None` for a function that they do not have.
pub fn length<S: Real>(system: &dyn System<S>, name: &str) -> Option<usize> {
    let lengths = system.lengths();
    let (nq, nv, n) = (lengths.coordinates, lengths.variables, lengths.variables + lengths.reactions);
    let if_solved = |count: usize| system.has_accelerations().then_some(count);
    match name {
        "mass_matrix" => Some(n * n),
        "forcing" | "residual" => Some(n),
        "linear_system" => Some(n * n + n),
        "inverse_dynamics" => (lengths.reactions == 0).then_some(n),
        "accelerations" => if_solved(nv),
        "derivative" => if_solved(nq + nv),
        "jacobian" => if_solved((nq + nv) * (nq + nv)),
        "coordinate_rates" => Some(nq),
        "kinetic_energy" | "potential_energy" => Some(1),
        "power" => system.has_power().then_some(1),
        "generalized_speeds" | "generalized_speed_rates" => Some(lengths.speeds),
        "motion_variables" => Some(nv),
        "divisors" => Some(system.divisor_count()),
        "constraints" => Some(system.constraint_count()),
        "constraint_slopes" => Some(system.constraint_count() * (nq + nv)),
        _ => None,
    }
}

/// True if one function of the compiled equations has these values; others are made here from several.
pub fn is_one_function(name: &str) -> bool {
    !matches!(name, "residual" | "linear_system" | "inverse_dynamics")
}

/// Slices of p, q, the motion variables, u and the unknowns.
type Parts<'a, S> = [&'a [S]; 5];

/// Procedure that writes the values of a function by the compiled equations. They have this function.
pub fn procedure<S: Real>(name: &str) -> fn(&dyn System<S>, Parts<'_, S>, &mut [S]) {
    match name {
        "mass_matrix" => |system, [p, q, v, ..], out| system.mass_matrix(p, q, v, out),
        "forcing" => |system, [p, q, v, ..], out| system.forcing(p, q, v, out),
        "linear_system" => |system, [p, q, v, ..], out| {
            let n = system.lengths().variables + system.lengths().reactions;
            let (matrix, right) = out.split_at_mut(n * n);
            system.mass_matrix(p, q, v, matrix);
            system.forcing(p, q, v, right);
        },
        "residual" | "inverse_dynamics" => |system, parts, out| {
            let (n, x) = (out.len(), parts[4]);
            let mut both = vec![S::int(0); n * n + n];
            procedure("linear_system")(system, parts, &mut both);
            let (matrix, right) = both.split_at(n * n);
            for (i, out) in out.iter_mut().enumerate() {
                *out = (0..n).fold(S::int(0) - right[i], |sum, j| sum + matrix[i * n + j] * x[j]);
            }
        },
        "accelerations" => |system, [p, q, v, ..], out| system.accelerations(p, q, v, out),
        "derivative" => |system, [p, q, v, ..], out| {
            let (q_dot, v_dot) = out.split_at_mut(system.lengths().coordinates);
            system.derivative(p, q, v, q_dot, v_dot);
        },
        "jacobian" => |system, [p, q, v, ..], out| system.jacobian(p, q, v, out),
        "coordinate_rates" => |system, [p, q, v, ..], out| system.coordinate_rates(p, q, v, out),
        "kinetic_energy" => |system, [p, q, v, ..], out| out[0] = system.kinetic_energy(p, q, v),
        "potential_energy" => |system, [p, q, ..], out| out[0] = system.potential_energy(p, q),
        "power" => |system, [p, q, v, ..], out| out[0] = system.power(p, q, v),
        "generalized_speeds" => |system, [p, q, v, ..], out| system.generalized_speeds(p, q, v, out),
        "generalized_speed_rates" => |system, [p, q, v, _, x], out| {
            system.generalized_speed_rates(p, q, v, &x[..system.lengths().variables], out);
        },
        "motion_variables" => |system, [p, q, _, u, _], out| system.motion_variables(p, q, u, out),
        "divisors" => |system, [p, q, v, ..], out| system.divisors(p, q, v, out),
        "constraints" => |system, [p, q, v, ..], out| system.constraints(p, q, v, out),
        "constraint_slopes" => |system, [p, q, v, ..], out| system.constraint_slopes(p, q, v, out),
        name => unreachable!("{name} has a length"),
    }
}

/// Value of a function by the compiled equations; `None` for a function that they do not have.
fn value<S: Real>(system: &dyn System<S>, name: &str, state: &[Vec<S>; 5]) -> Option<Vec<S>> {
    let mut out = vec![S::int(0); length(system, name)?];
    procedure(name)(system, state.each_ref().map(Vec::as_slice), &mut out);
    Some(out)
}

/// Slopes of the derivative along the parameters, by central differences in 32 digits.
fn parameter_slopes(system: &dyn System<Dd>, state: &[Vec<Dd>; 5]) -> Option<Vec<Dd>> {
    let columns = state[0].iter().enumerate().map(|(at, p)| {
        let step = *p * Dd::decimal("1e-9");
        let moved = |by: Dd| {
            let mut state = state.clone();
            state[0][at] = *p + by;
            value(system, "derivative", &state)
        };
        let (above, below) = (moved(step)?, moved(-step)?);
        Some(above.iter().zip(&below).map(|(a, b)| (*a - *b) / (step + step)).collect::<Vec<_>>())
    });
    let columns: Vec<Vec<Dd>> = columns.collect::<Option<_>>()?;
    let rows = columns.first().map_or(0, Vec::len);
    Some((0..rows).flat_map(|row| columns.iter().map(move |column| column[row]).collect::<Vec<_>>()).collect())
}
