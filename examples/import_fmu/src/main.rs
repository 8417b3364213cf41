//! Runs a unit of `tripos fmu --fmi 2` by the crate `fmi`, and compares its ends with a run of `tripos
//! simulate --json`.
//! Version 0.8 of the crate does not read units of FMI 3.0 whose variables have the attribute `unit`.
//!
//! `import_fmu UNIT RUN`: the co-simulation takes 200 steps, the model exchange is integrated by 50 000 steps of the
//! classical method of order 4. Both must end in the state of the run within a millionth.

use fmi::fmi2::import::Fmi2Import;
use fmi::fmi2::instance::{CoSimulation, Common, Instance, ModelExchange};
use fmi::traits::FmiImport;
use fmi::{EventFlags, ME, import};
use serde_json::Value;
use std::error::Error;

const STEPS_OF_UNIT: u32 = 200;
const STEPS: u32 = 50_000;
const BOUND: f64 = 1e-6;

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [unit, run] = arguments.as_slice() else { return Err("usage: import_fmu UNIT RUN".into()) };
    let run: Value = serde_json::from_str(&std::fs::read_to_string(run)?)?;
    let end = run["t"].as_f64().ok_or("the run has no end")?;
    let state = run["state"].as_object().ok_or("the run has no state")?;
    let import: Fmi2Import = import::from_path(unit)?;
    let description = import.model_description();
    let reference = |name: &String| description.model_variable_by_name(name).map(|variable| variable.value_reference);
    let references: Vec<u32> = state.keys().map(reference).collect::<Result<_, _>>()?;
    let by_unit = co_simulation(&import, end, &references)?;
    let by_steps = model_exchange(&import, end, &references)?;
    for ((name, expected), (a, b)) in state.iter().zip(by_unit.iter().zip(&by_steps)) {
        let expected = expected.as_f64().ok_or(format!("{name} is no number"))?;
        println!(
            "{name:>16} {expected:.9e}, co-simulation {:+.1e}, model exchange {:+.1e}",
            a - expected,
            b - expected
        );
        let bound = BOUND * (1.0 + expected.abs());
        if !((a - expected).abs() < bound && (b - expected).abs() < bound) {
            return Err(format!("{name} ends elsewhere").into());
        }
    }
    Ok(())
}

/// Values of variables at the end of a co-simulation.
fn co_simulation(import: &Fmi2Import, end: f64, references: &[u32]) -> Outcome<Vec<f64>> {
    let mut unit = import.instantiate_cs("unit", false, false)?;
    unit.setup_experiment(None, 0.0, None)?;
    unit.enter_initialization_mode()?;
    unit.exit_initialization_mode()?;
    let size = end / f64::from(STEPS_OF_UNIT);
    for k in 0..STEPS_OF_UNIT {
        unit.do_step(f64::from(k) * size, size, true)?;
    }
    let mut values = vec![0.0; references.len()];
    unit.get_real(references, &mut values)?;
    Ok(values)
}

/// Values of variables at the end of a run whose steps are taken here.
fn model_exchange(import: &Fmi2Import, end: f64, references: &[u32]) -> Outcome<Vec<f64>> {
    let mut unit = import.instantiate_me("unit", false, false)?;
    unit.setup_experiment(None, 0.0, None)?;
    unit.enter_initialization_mode()?;
    unit.exit_initialization_mode()?;
    events(&mut unit)?;
    let mut y = vec![0.0; import.model_description().num_states()];
    unit.get_continuous_states(&mut y)?;
    let h = end / f64::from(STEPS);
    for k in 0..STEPS {
        let t = f64::from(k) * h;
        let mut rates = |by: f64, slope: &[f64]| -> Outcome<Vec<f64>> {
            let moved: Vec<f64> = y.iter().zip(slope).map(|(y, s)| y + by * s).collect();
            let mut out = vec![0.0; moved.len()];
            unit.set_time(t + by)?;
            unit.set_continuous_states(&moved)?;
            unit.get_derivatives(&mut out)?;
            Ok(out)
        };
        let k1 = rates(0.0, &y)?;
        let k2 = rates(h / 2.0, &k1)?;
        let k3 = rates(h / 2.0, &k2)?;
        let k4 = rates(h, &k3)?;
        for (at, y) in y.iter_mut().enumerate() {
            *y += h / 6.0 * (k1[at] + 2.0 * (k2[at] + k3[at]) + k4[at]);
        }
        unit.set_time(t + h)?;
        unit.set_continuous_states(&y)?;
        let (mut asks, mut ends) = (false, false);
        unit.completed_integrator_step(true, &mut asks, &mut ends)?;
        if ends {
            return Err(format!("the unit ends at {} s", t + h).into());
        }
        if asks {
            unit.enter_event_mode()?;
            events(&mut unit)?;
            unit.get_continuous_states(&mut y)?;
        }
    }
    let mut values = vec![0.0; references.len()];
    unit.get_real(references, &mut values)?;
    Ok(values)
}

/// Updates the discrete states until they stay, and goes on to continuous time.
fn events(unit: &mut Instance<ME>) -> Outcome<()> {
    let mut flags = EventFlags { discrete_states_need_update: true, ..EventFlags::default() };
    while flags.discrete_states_need_update {
        flags.reset();
        unit.new_discrete_states(&mut flags)?;
        if flags.terminate_simulation {
            return Err("the unit ends".into());
        }
    }
    unit.enter_continuous_time_mode()?;
    Ok(())
}
