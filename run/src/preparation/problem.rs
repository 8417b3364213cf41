//! A scene together with one set of equations of motion, ready to be integrated.
//!
//! A coordinate may be integrated as its distance from a singular surface, such as an angle minus
//! 90°. The integrated state then contains this distance. States shown to the user contain the
//! coordinate itself.

mod chosen_speeds;
mod contacts;
mod extended_precision;

use super::initial_state::InitialState;
use super::near_divisors::near_divisors;
use super::reduced_equations::ReducedScene;
use super::speed_changes::ChosenSpeedEquations;
use crate::code::Code;
use crate::error::{Error, refused_scene_error};
use crate::mechanism::Mechanism;
use tripos_derive::mechanics::{EquationsOrigin, InertiaCheck};
use tripos_derive::scene::{AccelerationSolution, InitialMotion, Integrator, ProjectionTarget, Scene};
use tripos_derive::{Formulation, Model};
use tripos_sim::projection::Invariants;
use tripos_sim::quadrature::{self, NoQuadrature};
use tripos_sim::{
    AccompaniedRightHandSide, Corner, Dynamics, EliminatedDynamics, Event, LentRightHandSide, Options, RightHandSide,
    SimError, Solution, integrate, integrate_projected,
};
use tripos_traits::{DoubleDouble, Real, Scalar, System};

/// Function that computes the power of the loads, W, at the time t, s, in the integrated state y.
pub type Power<'a> = Box<dyn FnMut(f64, &[f64]) -> f64 + 'a>;

/// Scene with the equations of motion to run it by, and the method that finds the accelerations.
pub struct Problem<'a> {
    /// Mechanism of the scene: its model with the compiled equations.
    pub mechanism: &'a Mechanism,
    /// Model to which the equations belong: the mechanism's model, or the reduced model of the scene.
    pub model: &'a Model,
    /// Scene in the variables of the equations, which are reduced variables for reduced equations.
    pub scene: &'a Scene,
    /// Scene as its file states it, in the variables of the mechanism's model.
    pub shown: &'a Scene,
    /// Origin of the equations of motion, such as Kane's method or a publication.
    pub by: &'a EquationsOrigin,
    /// Compiled or interpreted equations of motion. They are in the distance from a singular surface if
    /// the scene asks for it.
    pub code: &'a Code,
    /// Method that finds the accelerations: eliminated beforehand, or solved for numerically at each
    /// state.
    pub solve: AccelerationSolution,
    /// Additional equations in chosen speeds, which are used wherever these speeds determine the motion.
    /// `None` unless the problem's own equations are in the rates of all coordinates.
    pub chosen: Option<ChosenSpeedEquations<'a>>,
    /// Coordinate that is integrated as its distance from a singular surface; `None` if there is no
    /// such coordinate.
    origin: Option<DistanceOrigin>,
}

/// Largest number of convolutions per component of the state at which Taylor's method costs no more
/// than DOP853.
///
/// Measured: with 2.4 convolutions (a disk) a run costs 0.9 to 1.1 times as much. With 6.5
/// convolutions (a cart with three pendulums) it costs 2.3 times as much.
const MOST_CONVOLUTIONS: usize = 4;

/// Values of the parameters, and the integrated state at the start, both to 32 digits.
pub type ExtendedStart = (Vec<DoubleDouble>, Vec<DoubleDouble>);

/// Coordinate that is integrated as its difference from a fixed value, so that no digits are lost near
/// a singular surface.
#[derive(Clone, Copy)]
struct DistanceOrigin {
    /// Index of the coordinate, from 0.
    at: usize,
    /// Value of the coordinate on the singular surface, rad. The integrated variable is the coordinate
    /// minus this value.
    value: DoubleDouble,
}

impl<'a> Problem<'a> {
    /// Makes a problem from a scene and equations. If the scene integrates a distance from a singular
    /// surface, the equations must be in this distance. `solve` is the method that finds the
    /// accelerations. If it is `None`, the scene decides. If the scene does not say either,
    /// accelerations are eliminated wherever the equations allow it.
    ///
    /// # Errors
    /// [`Error::Request`] if eliminated accelerations are required but the equations have none, or if
    /// the scene has contacts that these equations do not allow. [`Error::Input`] if a moving body has
    /// no mass at these parameters.
    pub fn new(
        mechanism: &'a Mechanism,
        scene: &'a Scene,
        by: &'a EquationsOrigin,
        code: &'a Code,
        solve: Option<AccelerationSolution>,
    ) -> Result<Self, Error> {
        Self::for_scene_of_many(&InertiaCheck::new(mechanism), mechanism, scene, by, code, solve)
    }

    /// Makes a problem for one of many scenes of a mechanism. `inertia` is prepared once and serves all
    /// of these scenes. See [`Self::new`] for `solve`.
    ///
    /// # Errors
    /// [`Error::Request`] if eliminated accelerations are required but the equations have none, or if
    /// the scene has contacts that these equations do not allow. [`Error::Input`] if a moving body has
    /// no mass at the scene's parameters.
    pub fn for_scene_of_many(
        inertia: &InertiaCheck<'_>,
        mechanism: &'a Mechanism,
        scene: &'a Scene,
        by: &'a EquationsOrigin,
        code: &'a Code,
        solve: Option<AccelerationSolution>,
    ) -> Result<Self, Error> {
        // Eliminated equations may have been divided by a mass that is 0.
        inertia.at(&scene.exact.rational).map_err(|error| Error::Input(mechanism.diagnose(&error)))?;
        Self::unchecked(mechanism, &mechanism.model, scene, by, code, solve)
    }

    /// Makes a problem from a scene and its reduced equations, without a check of the inertia. The
    /// reduction has already checked it. `shown` is the scene as its file states it.
    ///
    /// # Errors
    /// [`Error::Request`] if the scene asks for eliminated accelerations that the equations do not have,
    /// or if the scene has contacts.
    pub fn reduced(
        mechanism: &'a Mechanism,
        reduced: &'a ReducedScene,
        shown: &'a Scene,
        code: &'a Code,
    ) -> Result<Self, Error> {
        let ReducedScene { reduction, scene, by } = reduced;
        Ok(Self { shown, ..Self::unchecked(mechanism, &reduction.model, scene, by, code, None)? })
    }

    /// Makes a problem without a check of the inertia. `solve` is the method that finds the
    /// accelerations. If it is `None`, the scene decides.
    ///
    /// # Errors
    /// `Error::Request` if eliminated accelerations are required but the equations have none, or if the
    /// scene has contacts that these equations do not allow.
    fn unchecked(
        mechanism: &'a Mechanism,
        model: &'a Model,
        scene: &'a Scene,
        by: &'a EquationsOrigin,
        code: &'a Code,
        solve: Option<AccelerationSolution>,
    ) -> Result<Self, Error> {
        contacts::check_contacts_allowed(scene, by)?;
        let eliminated = code.system().has_accelerations();
        let wanted = solve.or(scene.integration.solve);
        if wanted == Some(AccelerationSolution::Eliminated) && !eliminated {
            let what = format!("the accelerations of {} are not eliminated", by.name());
            let help = "printed equations are solved as they stand: use solve = \"numeric\"".to_owned();
            return Err(Error::request(what, help));
        }
        let natural = if eliminated { AccelerationSolution::Eliminated } else { AccelerationSolution::Numeric };
        let origin = scene.integration.distance.map(|distance| DistanceOrigin {
            at: distance.coordinate,
            value: DoubleDouble::pi() * DoubleDouble::ratio(i64::from(distance.quarter_turns), 2),
        });
        Ok(Self {
            mechanism,
            model,
            scene,
            shown: scene,
            by,
            code,
            solve: wanted.unwrap_or(natural),
            chosen: None,
            origin,
        })
    }

    /// Makes a problem with the same equations for another scene, which differs only in its numbers.
    #[must_use]
    pub fn with_scene<'b>(&self, scene: &'b Scene) -> Problem<'b>
    where
        'a: 'b,
    {
        let Self { mechanism, model, shown, by, code, solve, chosen, origin, .. } = *self;
        Problem { mechanism, model, scene, shown, by, code, solve, chosen, origin }
    }

    /// True if the recurrences of the Taylor coefficients are so short that Taylor's method costs no
    /// more than DOP853. Always false without eliminated accelerations or recurrences. Convolutions of
    /// interpreted equations are not counted.
    #[must_use]
    pub fn has_short_series(&self) -> bool {
        let system = self.system();
        let an_order = system.taylor_work(2) - system.taylor_work(1);
        // Each convolution has two factors.
        let is_short = an_order <= 2 * MOST_CONVOLUTIONS * system.lengths().state();
        self.solve == AccelerationSolution::Eliminated && system.has_taylor() && is_short
    }

    /// Equations of motion in double precision.
    #[must_use]
    pub fn system(&self) -> &'a dyn System<f64> {
        self.code.system()
    }

    /// Coordinates q at an integrated state `y`. A distance from a singular surface is converted to its
    /// coordinate. Only the leading components of `y`, as many as coordinates, are read.
    #[must_use]
    pub fn coordinates(&self, y: &[f64]) -> Vec<f64> {
        let mut q = y[..self.system().lengths().coordinates].to_vec();
        if let Some(DistanceOrigin { at, value }) = self.origin {
            q[at] += value.to_f64();
        }
        q
    }

    /// Quantities that the scene shows at time `t`, s, in the integrated state `y`. For reduced
    /// equations they are the outputs of the scene. Otherwise they are the coordinates, followed by the
    /// generalized speeds.
    #[must_use]
    pub fn shown_state(&self, t: f64, y: &[f64]) -> Vec<f64> {
        let system = self.system();
        if self.by.is_reduced() {
            let (q, v) = y.split_at(system.lengths().coordinates);
            let mut out = vec![f64::NAN; system.output_count()];
            system.outputs(&self.scene.parameters, t - self.scene.span.0, q, v, &mut out);
            return out;
        }
        let (q, v) = y.split_at(system.lengths().coordinates);
        let mut u = vec![0.0; system.lengths().speeds];
        system.generalized_speeds(&self.scene.parameters, q, v, &mut u);
        [self.coordinates(y), u].concat()
    }

    /// Integrated state (q, v) at the start of the run, in double precision.
    ///
    /// # Errors
    /// [`Error::Stopped`] if the generalized speeds do not determine the motion variables v at the
    /// start.
    pub fn start(&self) -> Result<Vec<f64>, Error> {
        let (system, scene) = (self.system(), self.scene);
        let mut q = scene.q.clone();
        if let Some(DistanceOrigin { at, value }) = self.origin {
            // The exact number of the scene file is used. Its nearest double has lost digits that the
            // distance needs.
            q[at] = (scene.exact.q[at] - value).to_f64();
        }
        let mut v = vec![0.0; system.lengths().variables];
        match &scene.exact.motion {
            // In some poses, such as dead points, the generalized speeds do not determine the rates.
            InitialMotion::Rates(rates) if self.is_constrained_in_rates() => {
                v = rates.iter().map(|rate| rate.to_f64()).collect();
            }
            _ => system.motion_variables(&scene.parameters, &q, &scene.u, &mut v),
        }
        if let Some(at) = v.iter().position(|x| !x.is_finite()) {
            let name = &self.variable_names()[system.lengths().coordinates + at];
            return Err(Error::Stopped(format!(
                "the run cannot start: the speeds do not determine `{name}` there{}",
                self.near_divisors(&q)?
            )));
        }
        Ok([q, v].concat())
    }

    /// True if the motion variables are the rates q̇ of the coordinates, and motion constraints
    /// restrict them.
    fn is_constrained_in_rates(&self) -> bool {
        !self.model.motion_constraints.is_empty() && self.by.formulation().is_some_and(Formulation::is_in_rates)
    }

    /// Names of the components of the integrated state: the coordinates, followed by the speeds or by
    /// the rates, such as `q1'`.
    #[must_use]
    pub fn variable_names(&self) -> Vec<String> {
        let coordinates = self.model.coordinates.iter().map(|c| c.name.clone());
        let is_rate = self.by.formulation().is_some_and(Formulation::is_in_rates);
        let speeds = self.model.speeds.iter().map(|s| s.name.clone());
        let speeds: Vec<String> =
            if is_rate { coordinates.clone().map(|name| format!("{name}'")).collect() } else { speeds.collect() };
        coordinates.chain(speeds).collect()
    }

    /// Names the divisors of the equations that are nearly zero at an integrated state. The text is the
    /// end of a sentence, such as ", where sin(theta) = 1.2e-16". It is empty if no divisor is.
    ///
    /// # Errors
    /// [`Error::Request`] if a divisor contains a symbol without a value during a run.
    pub fn near_divisors(&self, y: &[f64]) -> Result<String, Error> {
        near_divisors(self.model, &self.scene.parameters, &self.coordinates(y))
    }

    /// Returns the reason why the run cannot start: a rate or an output has no finite value at the
    /// start. `None` if all values are finite, or if the accelerations are not eliminated.
    ///
    /// # Errors
    /// [`Error`] if the speeds do not determine the motion variables at the start.
    pub fn reason_start_is_singular(&self) -> Result<Option<String>, Error> {
        let Some(mut rhs) = EliminatedDynamics::new(self.system(), &self.scene.parameters) else { return Ok(None) };
        let y0 = self.start()?;
        let mut rates = vec![0.0; y0.len()];
        let failed = rhs.rhs(self.scene.span.0, &y0, &mut rates).is_err();
        let shown = self.shown_state(self.scene.span.0, &y0);
        if !failed && rates.iter().chain(&shown).all(|x| x.is_finite()) {
            return Ok(None);
        }
        let which = rates.iter().zip(self.variable_names()).find(|(rate, _)| !rate.is_finite());
        let what = which.map(|(_, name)| format!("the rate of `{name}`")).or_else(|| {
            let at = shown.iter().position(|x| !x.is_finite())?;
            let names = self.by.is_reduced().then(|| self.shown.outputs.iter().map(|output| &output.name));
            names.and_then(|mut names| names.nth(at)).map(|name| format!("the output `{name}`"))
        });
        let what = what.unwrap_or_else(|| "an output".to_owned());
        Ok(Some(format!("{what} has no value at the start{}", self.near_divisors(&y0)?)))
    }

    /// Integrates over the span of the scene, from the integrated state `y0` at its first instant.
    ///
    /// # Errors
    /// [`SimError`] if the options or the start do not fit the equations.
    pub fn integrate(&self, y0: &[f64], options: &Options, events: &mut [Event<'_>]) -> Result<Solution, SimError> {
        self.integrate_over(self.scene.span, y0, options, events)
    }

    /// Integrates over a given span, s, instead of the scene's, from the integrated state `y0`.
    ///
    /// # Errors
    /// [`SimError`] if the options or the start do not fit the equations.
    pub fn integrate_over(
        &self,
        span: (f64, f64),
        y0: &[f64],
        options: &Options,
        events: &mut [Event<'_>],
    ) -> Result<Solution, SimError> {
        if !self.scene.impacts.is_empty() {
            return self.run_with_contacts(InitialState { span, y: y0 }, &self.run_options(options), events, None);
        }
        let mut rhs = self.right_hand_side()?;
        integrate(LentRightHandSide(rhs.as_mut()), span, y0, &self.run_options(options), events)
    }

    /// Returns integration options with the observer of the run and the corners added. Corners are the
    /// instants at which prescribed motions or forces have kinks or jumps. A step ends at each corner.
    #[must_use]
    pub fn run_options(&self, options: &Options) -> Options {
        let corners = self.model.corner_instants(&self.scene.parameters).into_iter();
        let corners = corners.map(|(at, jumps)| if jumps { Corner::jump(at) } else { Corner::kink(at) }).collect();
        Options { corners, clock: self.model.time(), ..self.mechanism.follow.observed_options(options) }
    }

    /// Right-hand side of the equations of motion, with the problem's method for the accelerations:
    /// eliminated, or solved for numerically.
    ///
    /// # Errors
    /// [`SimError`] if the number of parameters does not fit the equations.
    pub(crate) fn right_hand_side(&self) -> Result<Box<dyn RightHandSide<f64> + '_>, SimError> {
        Ok(match EliminatedDynamics::new(self.system(), &self.scene.parameters) {
            Some(rhs) if self.solve == AccelerationSolution::Eliminated => Box::new(rhs),
            _ => Box::new(self.dynamics()?),
        })
    }

    /// Runs the problem over the scene's span from the integrated state `y0`, in the way the scene asks
    /// for: by steps, by projected steps or by quadrature. If a power is given, its integral, the work,
    /// is computed too. Quadrature and projection ignore the power.
    ///
    /// # Errors
    /// [`Error::Request`] if the options are invalid, or if the equations do not allow the scene's way
    /// of integration.
    pub fn solve(
        &self,
        y0: &[f64],
        options: &Options,
        events: &mut [Event<'_>],
        power: Option<Power<'_>>,
    ) -> Result<Solution, Error> {
        let (how, system, p) = (&self.scene.integration, self.system(), self.scene.parameters.as_slice());
        if !self.scene.impacts.is_empty() {
            let start = InitialState { span: self.scene.span, y: y0 };
            let run = self.run_with_contacts(start, &self.run_options(options), events, power);
            return run.map_err(|error| refused_scene_error(self.scene, &error));
        }
        if how.method == Integrator::Quadrature {
            if self.by.is_reduced() && system.lengths().variables == 0 {
                let what = "quadrature is not possible: no equation is left to integrate".to_owned();
                return Err(Error::request(
                    what,
                    "choose any other method: the remaining equations are algebraic".to_owned(),
                ));
            }
            return quadrature::run_by_quadrature(system, p, self.scene.span, y0, &self.run_options(options), events)
                .map_err(|error| match error {
                    NoQuadrature::Question(error) => refused_scene_error(self.scene, &error),
                    error => {
                        Error::request(format!("no motion by quadrature: {error}"), self.quadrature_advice().to_owned())
                    }
                });
        }
        let Some(ProjectionTarget::Energy) = how.project else {
            if let Some(chosen) = self.chosen {
                return self.run_with_speed_changes(chosen, y0, options, events, power);
            }
            let mut rhs = self.right_hand_side().map_err(|error| refused_scene_error(self.scene, &error))?;
            let (span, options) = (self.scene.span, self.run_options(options));
            let run = match power {
                Some(mut power) => {
                    let mut with = AccompaniedRightHandSide {
                        rhs: rhs.as_mut(),
                        power: Some(power.as_mut()),
                        over: None,
                        yields: None,
                    };
                    integrate(LentRightHandSide(&mut with as &mut dyn RightHandSide<f64>), span, y0, &options, events)
                }
                None => integrate(LentRightHandSide(rhs.as_mut()), span, y0, &options, events),
            };
            return run.map_err(|error| refused_scene_error(self.scene, &error));
        };
        if !system.has_energy_gradient() {
            let what = format!("{} cannot be projected onto their energy", self.by.title());
            let help = if self.by.is_reduced() {
                "the remaining states have no known conserved energy: leave the projection out"
            } else {
                "projection needs the scene's reduced equations: leave --by out"
            };
            return Err(Error::request(what, help.to_owned()));
        }
        let n = system.lengths().coordinates;
        let function = |_t: f64, y: &[f64], values: &mut [f64], gradient: &mut [f64]| {
            values[0] = system.energy_gradient(p, &y[..n], &y[n..], gradient);
        };
        let mut invariants = Invariants { count: 1, function: Box::new(function) };
        let mut rhs = EliminatedDynamics::new(system, p).ok_or_else(|| {
            Error::request("accelerations are not eliminated".to_owned(), "leave `solve` out".to_owned())
        })?;
        let rhs = LentRightHandSide(&mut rhs as &mut dyn RightHandSide<f64>);
        let run = integrate_projected(rhs, self.scene.span, y0, &self.run_options(options), events, &mut invariants);
        run.map_err(|error| refused_scene_error(self.scene, &error))
    }

    /// True if the equations allow the scene's integrator for some motions: quadrature needs one degree of freedom with
    /// a potential, and projection needs an energy.
    #[must_use]
    pub fn allows_integrator(&self) -> bool {
        let (how, system) = (&self.scene.integration, self.system());
        let allows_quadrature = system.lengths().variables == 1 && system.has_potential_slope();
        let is_quadrature_allowed = how.method != Integrator::Quadrature || allows_quadrature;
        is_quadrature_allowed && (how.project.is_none() || system.has_energy_gradient())
    }

    /// Advice for equations that do not allow quadrature: names the condition that they do not meet.
    fn quadrature_advice(&self) -> &'static str {
        let system = self.system();
        if !self.by.is_reduced() {
            "quadrature needs reduced equations with one degree of freedom, as `tripos scene` shows"
        } else if system.lengths().variables != 1 {
            "quadrature needs one degree of freedom; `tripos scene` shows how many are left: give a stepping method"
        } else if !system.has_potential_slope() {
            "the remaining states have no conserved energy with a potential in closed form: give a stepping method"
        } else {
            "give a stepping method for this motion"
        }
    }

    /// Linear system for the accelerations v̇ and the reactions. It is solved numerically at each state.
    ///
    /// # Errors
    /// [`SimError`] if the number of parameters does not fit the equations.
    pub fn dynamics(&self) -> Result<Dynamics<'a>, SimError> {
        let label = format!("{}, {}", self.model.title, self.by.name());
        Ok(Dynamics::new(self.system(), &self.scene.parameters)?.with_label(label))
    }
}
