//! Values of functions by the compiled equations and, for functions that these do not have, by the formulas of the
//! model.

use crate::sympy;
use std::rc::Rc;
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::evaluate::{Numeric, Tape};
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

/// Value of a function by the compiled equations; `None` for a function that they do not have.
fn value<S: Real>(system: &dyn System<S>, name: &str, [p, q, v, u, x]: &[Vec<S>; 5]) -> Option<Vec<S>> {
    let lengths = system.lengths();
    let (nq, nv, n) = (lengths.coordinates, lengths.variables, lengths.variables + lengths.reactions);
    let zeros = |count: usize| vec![S::int(0); count];
    let filled = |count: usize, fill: &dyn Fn(&mut [S])| {
        let mut out = zeros(count);
        fill(&mut out);
        Some(out)
    };
    let product = |x: &[S]| {
        let (mut matrix, mut right) = (zeros(n * n), zeros(n));
        system.mass_matrix(p, q, v, &mut matrix);
        system.forcing(p, q, v, &mut right);
        let row = |(i, f): (usize, &S)| (0..n).fold(S::int(0) - *f, |sum, j| sum + matrix[i * n + j] * x[j]);
        right.iter().enumerate().map(row).collect::<Vec<S>>()
    };
    match name {
        "mass_matrix" => filled(n * n, &|out| system.mass_matrix(p, q, v, out)),
        "forcing" => filled(n, &|out| system.forcing(p, q, v, out)),
        "linear_system" => {
            let parts = ["mass_matrix", "forcing"].map(|part| value(system, part, &[p, q, v, u, x].map(Clone::clone)));
            parts.into_iter().collect::<Option<Vec<_>>>().map(|parts| parts.concat())
        }
        "residual" => Some(product(x)),
        "inverse_dynamics" => (lengths.reactions == 0).then(|| product(&x[..nv])),
        "accelerations" => system.has_accelerations().then(|| filled(nv, &|out| system.accelerations(p, q, v, out)))?,
        "derivative" => system.has_accelerations().then(|| {
            let (mut q_dot, mut v_dot) = (zeros(nq), zeros(nv));
            system.derivative(p, q, v, &mut q_dot, &mut v_dot);
            [q_dot, v_dot].concat()
        }),
        "jacobian" => {
            let count = (nq + nv) * (nq + nv);
            system.has_accelerations().then(|| filled(count, &|out| system.jacobian(p, q, v, out)))?
        }
        "coordinate_rates" => filled(nq, &|out| system.coordinate_rates(p, q, v, out)),
        "kinetic_energy" => Some(vec![system.kinetic_energy(p, q, v)]),
        "potential_energy" => Some(vec![system.potential_energy(p, q)]),
        "power" => system.has_power().then(|| vec![system.power(p, q, v)]),
        "generalized_speeds" => filled(lengths.speeds, &|out| system.generalized_speeds(p, q, v, out)),
        "generalized_speed_rates" => {
            filled(lengths.speeds, &|out| system.generalized_speed_rates(p, q, v, &x[..nv], out))
        }
        "motion_variables" => filled(nv, &|out| system.motion_variables(p, q, u, out)),
        "divisors" => filled(system.divisor_count(), &|out| system.divisors(p, q, v, out)),
        "constraints" => filled(system.constraint_count(), &|out| system.constraints(p, q, v, out)),
        "constraint_slopes" => {
            filled(system.constraint_count() * (nq + nv), &|out| system.constraint_slopes(p, q, v, out))
        }
        _ => None,
    }
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
