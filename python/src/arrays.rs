//! Functions of the equations over many states, on all cores.

use tripos::code::Code;
use tripos_traits::System;

/// Arguments of a function at one state: parameters, coordinates, motion variables and accelerations.
type Arguments<'a> = [&'a [f64]; 4];

/// Function of the equations: the number of its values, and the procedure that writes them.
pub struct Quantity {
    /// Number of values of the function.
    pub count: usize,
    /// True if the function takes accelerations.
    pub takes_accelerations: bool,
    write: fn(&dyn System<f64>, Arguments<'_>, &mut [f64]),
}

/// Names of the functions that [`Quantity::of`] knows.
pub const NAMES: [&str; 11] = [
    "mass_matrix",
    "forcing",
    "accelerations",
    "coordinate_rates",
    "derivative",
    "jacobian",
    "kinetic_energy",
    "potential_energy",
    "power",
    "constraints",
    "inverse_dynamics",
];

impl Quantity {
    /// Function of this name; `None` if the equations do not have it.
    pub fn of(system: &dyn System<f64>, name: &str) -> Option<Self> {
        let lengths = system.lengths();
        let (nq, nv, n) = (lengths.coordinates, lengths.variables, lengths.variables + lengths.reactions);
        let solved = |count: usize| system.has_accelerations().then_some(count);
        let count = match name {
            "mass_matrix" => Some(n * n),
            "forcing" => Some(n),
            "accelerations" => solved(nv),
            "coordinate_rates" => Some(nq),
            "derivative" => solved(nq + nv),
            "jacobian" => solved((nq + nv) * (nq + nv)),
            "kinetic_energy" | "potential_energy" => Some(1),
            "power" => system.has_power().then_some(1),
            "constraints" => Some(system.constraint_count()).filter(|count| *count > 0),
            "inverse_dynamics" => (lengths.reactions == 0).then_some(nv),
            _ => None,
        }?;
        let write: fn(&dyn System<f64>, Arguments<'_>, &mut [f64]) = match name {
            "mass_matrix" => |system, [p, q, v, _], out| system.mass_matrix(p, q, v, out),
            "forcing" => |system, [p, q, v, _], out| system.forcing(p, q, v, out),
            "accelerations" => |system, [p, q, v, _], out| system.accelerations(p, q, v, out),
            "coordinate_rates" => |system, [p, q, v, _], out| system.coordinate_rates(p, q, v, out),
            "derivative" => |system, [p, q, v, _], out| {
                let (rates, accelerations) = out.split_at_mut(q.len());
                system.derivative(p, q, v, rates, accelerations);
            },
            "jacobian" => |system, [p, q, v, _], out| system.jacobian(p, q, v, out),
            "kinetic_energy" => |system, [p, q, v, _], out| out[0] = system.kinetic_energy(p, q, v),
            "potential_energy" => |system, [p, q, ..], out| out[0] = system.potential_energy(p, q),
            "power" => |system, [p, q, v, _], out| out[0] = system.power(p, q, v),
            "constraints" => |system, [p, q, v, _], out| system.constraints(p, q, v, out),
            _ => |system, [p, q, v, a], out| {
                let n = out.len();
                let mut matrix = vec![0.0; n * n];
                let mut forcing = vec![0.0; n];
                system.mass_matrix(p, q, v, &mut matrix);
                system.forcing(p, q, v, &mut forcing);
                for (i, out) in out.iter_mut().enumerate() {
                    *out = (0..n).map(|j| matrix[i * n + j] * a[j]).sum::<f64>() - forcing[i];
                }
            },
        };
        Some(Self { count, takes_accelerations: name == "inverse_dynamics", write })
    }

    /// Values at `states` states, state by state. Coordinates, motion variables and accelerations are the rows of
    /// arrays, each with the length of its rows.
    pub fn values(&self, code: &Code, p: &[f64], states: usize, arguments: [(&[f64], usize); 3]) -> Vec<f64> {
        let mut out = vec![0.0; states * self.count];
        let threads = std::thread::available_parallelism().map_or(1, usize::from).min(states / 256 + 1);
        let share = states.div_ceil(threads).max(1);
        let row = |at: usize, state: usize| {
            let (values, width) = arguments[at];
            &values[state * width..(state + 1) * width]
        };
        std::thread::scope(|scope| {
            for (thread, out) in out.chunks_mut((share * self.count).max(1)).enumerate() {
                let mut work = move || {
                    for (k, out) in out.chunks_mut(self.count.max(1)).enumerate() {
                        let state = thread * share + k;
                        (self.write)(code.system(), [p, row(0, state), row(1, state), row(2, state)], out);
                    }
                };
                if threads == 1 { work() } else { drop(scope.spawn(work)) }
            }
        });
        out
    }
}
