//! Runs a double pendulum for ten seconds by two libraries of integrators. The build script derived its equations.

/// Equations of the double pendulum.
#[allow(dead_code, unused_imports, reason = "a module has more functions than one program calls")]
mod pendulum {
    include!(concat!(env!("OUT_DIR"), "/pendulum/mod.rs"));
}

use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, SVector};
use pendulum::Parameters;
use pendulum::kane::{self, Kane};
use tripos_sim::{Dynamics, Method, Options, integrate};

type State = SVector<f64, 4>;

const SPAN: f64 = 10.0;
const START: [f64; 4] = [1.2, 0.7, 0.0, 0.0];
const TOLERANCE: f64 = 1e-12;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let parameters = Parameters::default();
    let by_tripos = by_tripos(&parameters)?;
    let by_ode_solvers = by_ode_solvers(parameters)?;
    println!("tripos-sim   {by_tripos:?}");
    println!("ode_solvers  {by_ode_solvers:?}");
    let difference = by_tripos.iter().zip(&by_ode_solvers).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let lost = (energy(&parameters, &by_tripos) - energy(&parameters, &START)).abs();
    println!("difference   {difference:.1e}");
    println!("energy lost  {lost:.1e} J");
    if difference < 1e-7 && lost < 1e-9 { Ok(()) } else { Err("the two runs are not of one pendulum".into()) }
}

/// State after the run, by the integrators of Tripos.
fn by_tripos(parameters: &Parameters<f64>) -> Result<Vec<f64>, tripos_sim::SimError> {
    let dynamics = Dynamics::new(&Kane, &parameters.to_array())?;
    let options = Options { method: Method::Dop853, ..Options::tolerances(TOLERANCE, TOLERANCE) };
    Ok(integrate(dynamics, (0.0, SPAN), &START, &options, &mut [])?.y_end)
}

/// The pendulum, as `ode_solvers` takes it.
struct Pendulum(Parameters<f64>);

impl ode_solvers::System<f64, State> for Pendulum {
    fn system(&self, _t: f64, y: &State, dy: &mut State) {
        let (q, u) = ([y[0], y[1]], [y[2], y[3]]);
        let rates = kane::coordinate_rates(&self.0, &q, &u);
        let accelerations = kane::accelerations(&self.0, &q, &u);
        dy.as_mut_slice().copy_from_slice(&[rates, accelerations].concat());
    }
}

/// State after the run, by the crate `ode_solvers`.
fn by_ode_solvers(parameters: Parameters<f64>) -> Result<Vec<f64>, Box<dyn std::error::Error>> {
    let mut stepper = Dop853::new(Pendulum(parameters), 0.0, SPAN, 0.0, State::from(START), TOLERANCE, TOLERANCE);
    // The steps themselves; the interval of output above is then not used.
    stepper.set_output(OutputType::Sparse);
    stepper.integrate()?;
    Ok(stepper.y_out().last().ok_or("the run has no end")?.as_slice().to_vec())
}

/// Energy T + V of a state.
fn energy(parameters: &Parameters<f64>, y: &[f64]) -> f64 {
    let (q, u) = ([y[0], y[1]], [y[2], y[3]]);
    kane::kinetic_energy(parameters, &q, &u) + kane::potential_energy(parameters, &q)
}
