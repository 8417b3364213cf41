//! Runs by equations in chosen generalized speeds. Where these speeds do not determine the motion, the
//! equations in the rates of all coordinates run instead.

use super::{Power, Problem};
use crate::code::Code;
use crate::error::{Error, refused_scene_error};
use crate::preparation::initial_state::InitialState;
use crate::preparation::speed_changes::{self, ChosenSpeedEquations, EnergyBalance, SpeedAndRateEquations};
use tripos_sim::{Event, Options, Solution};

impl<'a> Problem<'a> {
    /// Adds equations in chosen generalized speeds, which are used wherever these speeds determine the
    /// motion. Elsewhere the problem's own equations are used. These must be in the rates of all
    /// coordinates, with multipliers.
    #[must_use]
    pub fn with_chosen_speeds(self, chosen: ChosenSpeedEquations<'a>) -> Self {
        Self { chosen: Some(chosen), ..self }
    }

    /// Runs the scene by the problem's own equations, in chosen speeds, alone. `None` if these speeds
    /// fail on the way, or hardly determine the motion somewhere. `rates` are the equations in the rates
    /// of all coordinates. They serve to test the speeds.
    ///
    /// # Errors
    /// `Error::Request` if the options or the start do not fit the equations.
    pub(crate) fn run_in_chosen_speeds_alone(
        &self,
        rates: &Code,
        options: &Options,
        events: &mut [Event<'_>],
        power: Option<Power<'_>>,
    ) -> Result<Option<Solution>, Error> {
        let Ok(y0) = self.start() else { return Ok(None) };
        let run = self.right_hand_side().and_then(|mut rhs| {
            let systems = SpeedAndRateEquations {
                rates: rates.system(),
                speeds: self.system(),
                parameters: &self.scene.parameters,
            };
            let start = InitialState { span: self.scene.span, y: &y0 };
            speed_changes::run_in_speeds_alone(systems, rhs.as_mut(), start, &self.run_options(options), events, power)
        });
        run.map_err(|error| refused_scene_error(self.scene, &error))
    }

    /// Runs the scene from `y0` = (q, q̇). The equations in chosen speeds are used wherever the speeds
    /// determine the motion. Elsewhere the problem's own equations, in the rates of all coordinates,
    /// are used. Stores the parts of the run in all rates in `chosen.changes`.
    ///
    /// # Errors
    /// `Error::Request` if the options or the start do not fit the equations.
    pub(super) fn run_with_speed_changes(
        &self,
        chosen: ChosenSpeedEquations<'_>,
        y0: &[f64],
        options: &Options,
        events: &mut [Event<'_>],
        power: Option<Power<'_>>,
    ) -> Result<Solution, Error> {
        let speeds = Problem { by: chosen.by, code: chosen.code, solve: chosen.solve, chosen: None, ..*self };
        let run = speeds.right_hand_side().and_then(|mut rhs| {
            let systems = SpeedAndRateEquations {
                rates: self.system(),
                speeds: speeds.system(),
                parameters: &self.scene.parameters,
            };
            let start = InitialState { span: self.scene.span, y: y0 };
            // Without a given power, energy is kept only if all forces have a potential.
            let keeps_energy = !self.mechanism.is_driven() && (power.is_some() || !self.system().has_power());
            let energy = EnergyBalance { power, is_kept: keeps_energy };
            speed_changes::run_with_speed_changes(
                systems,
                rhs.as_mut(),
                start,
                &self.run_options(options),
                events,
                energy,
            )
        });
        let (solution, list) = run.map_err(|error| refused_scene_error(self.scene, &error))?;
        if let Ok(mut changes) = chosen.changes.lock() {
            *changes = list;
        }
        Ok(solution)
    }
}
