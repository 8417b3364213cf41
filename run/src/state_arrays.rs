//! Functions of the equations of motion at many states. Several states are computed at once in lanes of vector
//! registers, and on all cores.
//!
//! Invariant: in an array, the value at a state does not depend on the other states, on their number or on the
//! cores. A state outside an array has the same value for interpreted equations. For compiled equations it
//! agrees up to rounding.

#[cfg(feature = "threads")]
mod threads;

use crate::code::Code;
use tripos_traits::{CompiledSystem, Lanes, Rates, Scalar, System};

/// Function of the equations of motion that has a value at each state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StateFunction {
    /// Matrix M of the linear system M x = f, where x are the accelerations v̇ and the reactions.
    MassMatrix,
    /// Right-hand side f of the linear system M x = f, where x are the accelerations v̇ and the reactions.
    Forcing,
    /// Accelerations v̇: the rates of the motion variables.
    Accelerations,
    /// Rates q̇ of the generalized coordinates.
    CoordinateRates,
    /// Rates (q̇, v̇) of the state (q, v).
    Derivative,
    /// Derivatives of the rates (q̇, v̇) by the state (q, v).
    Jacobian,
    /// Kinetic energy T, J.
    KineticEnergy,
    /// Potential energy V, J.
    PotentialEnergy,
    /// Power of the loads that have no potential, W.
    Power,
    /// Residuals of the constraints, which are zero where the constraints hold.
    Constraints,
    /// Generalized forces M v̇ − f that a motion needs in addition to the loads of the model.
    InverseDynamics,
}

/// Shape of the value of a function at one state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ValueShape {
    /// A single number.
    Number,
    /// Vector with this number of components.
    Vector(usize),
    /// Square matrix with this number of rows, stored row by row.
    Matrix(usize),
}

impl ValueShape {
    /// Number of entries of the value: 1 for a number, n for a vector, and n² for a matrix.
    #[must_use]
    pub const fn count(self) -> usize {
        match self {
            Self::Number => 1,
            Self::Vector(n) => n,
            Self::Matrix(n) => n * n,
        }
    }
}

impl StateFunction {
    /// All functions, in the order of their declaration.
    pub const ALL: [Self; 11] = [
        Self::MassMatrix,
        Self::Forcing,
        Self::Accelerations,
        Self::CoordinateRates,
        Self::Derivative,
        Self::Jacobian,
        Self::KineticEnergy,
        Self::PotentialEnergy,
        Self::Power,
        Self::Constraints,
        Self::InverseDynamics,
    ];

    /// Name of the function in programs, such as `mass_matrix`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::MassMatrix => "mass_matrix",
            Self::Forcing => "forcing",
            Self::Accelerations => "accelerations",
            Self::CoordinateRates => "coordinate_rates",
            Self::Derivative => "derivative",
            Self::Jacobian => "jacobian",
            Self::KineticEnergy => "kinetic_energy",
            Self::PotentialEnergy => "potential_energy",
            Self::Power => "power",
            Self::Constraints => "constraints",
            Self::InverseDynamics => "inverse_dynamics",
        }
    }

    /// Finds the function with the given name, such as `mass_matrix`. `None` if no function has it.
    #[must_use]
    pub fn of_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|function| function.name() == name)
    }

    /// True if the function needs accelerations in addition to the state.
    #[must_use]
    pub const fn takes_accelerations(self) -> bool {
        matches!(self, Self::InverseDynamics)
    }

    /// Shape of the value at one state; `None` if the equations do not have this function.
    #[must_use]
    pub fn shape(self, code: &Code) -> Option<ValueShape> {
        let system = code.system();
        let lengths = system.lengths();
        let solved = system.has_accelerations();
        let (shape, exists) = match self {
            Self::MassMatrix => (ValueShape::Matrix(lengths.unknowns()), true),
            Self::Forcing => (ValueShape::Vector(lengths.unknowns()), true),
            Self::Accelerations => (ValueShape::Vector(lengths.variables), solved),
            Self::CoordinateRates => (ValueShape::Vector(lengths.coordinates), true),
            Self::Derivative => (ValueShape::Vector(lengths.state()), solved),
            Self::Jacobian => (ValueShape::Matrix(lengths.state()), solved),
            Self::KineticEnergy | Self::PotentialEnergy => (ValueShape::Number, true),
            Self::Power => (ValueShape::Number, system.has_power()),
            Self::Constraints => (ValueShape::Vector(system.constraint_count()), system.constraint_count() > 0),
            Self::InverseDynamics => (ValueShape::Vector(lengths.variables), lengths.reactions == 0),
        };
        exists.then_some(shape)
    }

    /// Writes the value of the function at one state, or at one state in each lane, to `out`. `scratch` is
    /// working memory that is kept between calls.
    fn write<S: Scalar>(self, system: &dyn System<S>, at: Arguments<'_, S>, scratch: &mut Vec<S>, out: &mut [S]) {
        let Arguments { p, q, v, v_dot } = at;
        match self {
            Self::MassMatrix => system.mass_matrix(p, q, v, out),
            Self::Forcing => system.forcing(p, q, v, out),
            Self::Accelerations => system.accelerations(p, q, v, out),
            Self::CoordinateRates => system.coordinate_rates(p, q, v, out),
            Self::Derivative => {
                let (q_dot, v_dot) = out.split_at_mut(q.len());
                system.derivative(p, q, v, q_dot, v_dot);
            }
            Self::Jacobian => system.jacobian(p, q, v, out),
            Self::KineticEnergy => out[0] = system.kinetic_energy(p, q, v),
            Self::PotentialEnergy => out[0] = system.potential_energy(p, q),
            Self::Power => out[0] = system.power(p, q, v),
            Self::Constraints => system.constraints(p, q, v, out),
            Self::InverseDynamics => {
                let n = out.len();
                scratch.resize(n * n, S::int(0));
                system.mass_matrix(p, q, v, scratch);
                system.forcing(p, q, v, out);
                for (row, out) in scratch.chunks_exact(n).zip(out) {
                    let product = row.iter().zip(v_dot).fold(S::int(0), |sum, (m, v_dot)| sum + *m * *v_dot);
                    *out = product - *out;
                }
            }
        }
    }
}

/// Arguments of a function at one state, or at one state in each lane.
#[derive(Clone, Copy)]
pub(crate) struct Arguments<'a, S> {
    /// Values of the parameters, in the order of the model.
    pub p: &'a [S],
    /// Values of the generalized coordinates.
    pub q: &'a [S],
    /// Values of the motion variables: generalized speeds or rates of the coordinates.
    pub v: &'a [S],
    /// Rates of the motion variables; empty for functions that do not need them.
    pub v_dot: &'a [S],
}

/// Rows of numbers, such as coordinates: one row for each state, or one row for all states.
#[derive(Clone, Copy, Debug)]
pub struct Rows<'a> {
    /// Entries of the rows, row by row.
    values: &'a [f64],
    /// Number of entries in each row.
    width: usize,
    /// True if all states have the same row, which is stored once.
    is_shared: bool,
}

impl<'a> Rows<'a> {
    /// Makes rows of `width` numbers from `values`, one row for each state.
    #[must_use]
    pub const fn each(values: &'a [f64], width: usize) -> Self {
        Self { values, width, is_shared: false }
    }

    /// Makes a single row that belongs to all states.
    #[must_use]
    pub const fn shared(values: &'a [f64]) -> Self {
        Self { values, width: values.len(), is_shared: true }
    }

    /// Row of the state with the index `state`.
    fn row(&self, state: usize) -> &'a [f64] {
        let first = if self.is_shared { 0 } else { state * self.width };
        &self.values[first..first + self.width]
    }

    /// True if there is a row for each of `count` states.
    fn has_states(&self, count: usize) -> bool {
        self.is_shared || self.values.len() == count * self.width
    }
}

/// States at which a function of the equations of motion is evaluated.
#[derive(Clone, Copy, Debug)]
pub struct StateRows<'a> {
    /// Number of states.
    pub count: usize,
    /// Generalized coordinates of each state.
    pub q: Rows<'a>,
    /// Motion variables of each state.
    pub v: Rows<'a>,
    /// Rates of the motion variables of each state. Rows have no entries for functions that do not need them.
    pub v_dot: Rows<'a>,
}

/// Evaluates a function at each state, and writes the values to `out`, state by state. Arrays of many states are
/// shared among all cores.
///
/// # Panics
/// If the equations do not have the function, or if a length is wrong. `p` and the rows must have the lengths of
/// the equations. For each state, `out` must have as many entries as [`StateFunction::shape`] says.
pub fn evaluate_states(function: StateFunction, code: &Code, p: &[f64], states: StateRows<'_>, out: &mut [f64]) {
    let width = function.shape(code).expect("the equations have the function").count();
    let lengths = code.system().lengths();
    let v_dot = if function.takes_accelerations() { lengths.variables } else { 0 };
    assert_eq!(p.len(), lengths.parameters, "one value for each parameter");
    assert_eq!(
        [states.q.width, states.v.width, states.v_dot.width],
        [lengths.coordinates, lengths.variables, v_dot],
        "rows of the equations' lengths"
    );
    assert!(
        [states.q, states.v, states.v_dot].iter().all(|rows| rows.has_states(states.count)),
        "a row for each state"
    );
    assert_eq!(out.len(), states.count * width, "one place for each value");
    let evaluation = Evaluation { function, code, p, states, width };
    share_states(states.count, width, out, &|first, out| evaluation.write_range(first, out));
}

/// Shares states among all cores, if the crate is built with threads. `write` gets the index of its first state,
/// and a slice for the values of its states. Each state has `width` values.
pub(crate) fn share_states(count: usize, width: usize, out: &mut [f64], write: &(dyn Fn(usize, &mut [f64]) + Sync)) {
    if out.is_empty() {
        return;
    }
    #[cfg(feature = "threads")]
    threads::share_among_cores(count, width, out, write);
    #[cfg(not(feature = "threads"))]
    {
        let _ = (count, width);
        write(0, out);
    }
}

/// Evaluation of one function at many states.
struct Evaluation<'a> {
    /// Function that is evaluated.
    function: StateFunction,
    /// Equations of motion that have the function.
    code: &'a Code,
    /// Values of the parameters, in the order of the model.
    p: &'a [f64],
    /// States at which the function is evaluated.
    states: StateRows<'a>,
    /// Number of values at each state.
    width: usize,
}

impl Evaluation<'_> {
    /// Writes the values at the states from the index `first` on, as many as fit into `out`.
    fn write_range(&self, first: usize, out: &mut [f64]) {
        use StateFunction::{Accelerations, Derivative};
        let Self { function, code, p, states, width } = *self;
        let is_array = states.count > 1;
        match code {
            Code::Interpreted(system) if is_array => {
                let (system, mut scratch) = (system.lanes(), Vec::new());
                write_in_lanes::<8>(p, states, width, first, out, |at, out| {
                    function.write(system, at, &mut scratch, out);
                });
            }
            Code::Compiled(CompiledSystem { lanes: Some(lanes), .. })
                if is_array && matches!(function, Accelerations | Derivative) =>
            {
                match lanes.widest() {
                    Some(eight) => write_in_lanes(p, states, width, first, out, rates_writer(function, eight)),
                    None => write_in_lanes(p, states, width, first, out, rates_writer(function, lanes.four)),
                }
            }
            _ => self.write_one_by_one(first, out),
        }
    }

    /// Writes the values at the states from the index `first` on, one state after the other.
    fn write_one_by_one(&self, first: usize, out: &mut [f64]) {
        let Self { function, code, p, states, width } = *self;
        let mut scratch = Vec::new();
        for (state, out) in (first..).zip(out.chunks_exact_mut(width)) {
            let at = Arguments { p, q: states.q.row(state), v: states.v.row(state), v_dot: states.v_dot.row(state) };
            function.write(code.system(), at, &mut scratch, out);
        }
    }
}

/// Writes the values at the states from the index `first` on, as many as fit into `out`. The function `write`
/// computes `N` states at once. Empty lanes of the last block repeat the last state.
pub(crate) fn write_in_lanes<const N: usize>(
    p: &[f64],
    states: StateRows<'_>,
    width: usize,
    first: usize,
    out: &mut [f64],
    mut write: impl FnMut(Arguments<'_, Lanes<N>>, &mut [Lanes<N>]),
) {
    let end = first + out.len() / width;
    let p: Vec<Lanes<N>> = p.iter().map(|p| Lanes([*p; N])).collect();
    let room = |count: usize| vec![Lanes([0.0; N]); count];
    let (mut q, mut v, mut v_dot) = (room(states.q.width), room(states.v.width), room(states.v_dot.width));
    let mut values = room(width);
    for (begin, out) in (first..).step_by(N).zip(out.chunks_mut(N * width)) {
        fill_lanes(states.q, begin, end, &mut q);
        fill_lanes(states.v, begin, end, &mut v);
        fill_lanes(states.v_dot, begin, end, &mut v_dot);
        write(Arguments { p: &p, q: &q, v: &v, v_dot: &v_dot }, &mut values);
        for (lane, out) in out.chunks_exact_mut(width).enumerate() {
            for (out, value) in out.iter_mut().zip(&values) {
                *out = value.0[lane];
            }
        }
    }
}

/// Fills the lanes with the rows of the states from the index `begin` on. Lanes from the index `end` on repeat the
/// last row.
fn fill_lanes<const N: usize>(rows: Rows<'_>, begin: usize, end: usize, lanes: &mut [Lanes<N>]) {
    for lane in 0..N {
        let row = rows.row((begin + lane).min(end - 1));
        for (place, value) in lanes.iter_mut().zip(row) {
            place.0[lane] = *value;
        }
    }
}

/// Makes a function that writes the rates (q̇, v̇) of states, or only v̇, as `function` says.
fn rates_writer<const N: usize>(
    function: StateFunction,
    rates: &(dyn Rates<Lanes<N>> + Sync),
) -> impl FnMut(Arguments<'_, Lanes<N>>, &mut [Lanes<N>]) {
    let mut unused = vec![Lanes([0.0; N]); rates.lengths().coordinates];
    move |Arguments { p, q, v, .. }, out| {
        let (q_dot, v_dot) = match function {
            StateFunction::Derivative => out.split_at_mut(q.len()),
            _ => (&mut unused[..], out),
        };
        rates.rates(p, q, v, q_dot, v_dot);
    }
}
