//! Sweep of a scene over a grid, prepared once for all points and threads.

use super::full_equations::FullEquations;
use super::own_equations::OwnEquations;
use super::point_problem::ConservedColumns;
use crate::code::{Code, CodePreparation, compiled_code};
use crate::equations_name::{EquationsName, find_equations_or_first};
use crate::error::{Error, refused_scene_error};
use crate::integration_options::integration_options_for_ends;
use crate::mechanism::Mechanism;
use crate::overrides::Overrides;
use crate::preparation::problem::Problem;
use crate::simulation::run_problem::{are_integrals_proved, prove_integrals_to_watch};
use crate::simulation::simulate::{ReducedRun, reason_to_simulate_full_equations};
use crate::trust::watched_invariants::WatchedInvariants;
use std::sync::OnceLock;
use std::sync::atomic::AtomicBool;
use tripos_derive::Formulation;
use tripos_derive::mechanics::{EquationsOrigin, InertiaCheck};
use tripos_derive::reduce::ReductionBasis;
use tripos_derive::scene::{AccelerationSolution, Family, Grid, Integrator, Scene};
use tripos_sim::{Options, SimError, Warning};

/// Data of a sweep that all its points and threads share.
pub struct Sweep<'a> {
    /// Mechanism of the scene, the same for all points.
    pub model: &'a Mechanism,
    /// Scene as its file states it, changed by the overrides. The parameters that the grid varies are free.
    pub scene: Scene,
    /// Grid of the quantities that vary, with their values.
    pub grid: &'a Grid,
    /// Overrides that replace integration settings of each point's scene.
    pub how: &'a Overrides,
    /// Check that all moving bodies have mass at the parameters of a point.
    pub(super) inertia: InertiaCheck<'a>,
    /// Origin of the equations by which points run: a formulation, a publication, or the scene's reduced equations.
    pub by: EquationsOrigin,
    /// Method that finds the accelerations: eliminated beforehand, or solved for numerically at each
    /// state.
    pub solve: AccelerationSolution,
    /// Code of the equations at the start of the scene file.
    pub code: Code,
    /// Reduced equations of the scene; `None` if points run by full equations alone.
    pub(super) own: Option<OwnEquations<'a>>,
    /// Full equations by which points run. Beside reduced equations, they run the points that reduced equations
    /// cannot run, and are prepared when the first such point needs them.
    pub(super) full: Vec<PreparedOnce>,
    /// First integrals whose changes are reported for each run. `None` if they were not proved, or if a run does not
    /// show all states, or if the scene has impacts.
    watch: Option<WatchedInvariants>,
    /// True if the change of the energy T + V is reported for each run, because first integrals are not.
    reports_energy: bool,
    /// Names of the quantities that the table shows at the end of each run.
    pub names: Vec<String>,
    /// Warnings that hold for the run of every point.
    pub warnings: Vec<String>,
    /// Reason why points run by full equations although no equations were named; `None` otherwise.
    pub note: Option<String>,
    /// True if a second run of each point determines the number of its correct digits.
    pub tells_digits: bool,
    /// Flag that is set when no more rows are wanted; the threads then stop.
    pub stop: AtomicBool,
}

/// Full equations that are prepared when they are first needed.
pub(super) struct PreparedOnce {
    /// Origin of the equations.
    by: EquationsOrigin,
    /// Prepared equations. The inner value is `None` if the model has no such equations, or they cannot be run.
    prepared: OnceLock<Option<FullEquations>>,
}

impl<'a> Sweep<'a> {
    /// Prepares the sweep of a scene over a grid, which was read for this scene. The overrides `how` must
    /// already be applied to the scene.
    ///
    /// Points run by the equations that `how` names. If it names none, they run by the scene's reduced equations if
    /// these have an advantage, and otherwise by the first formulation that the model supports.
    ///
    /// # Errors
    /// [`Error`] if these equations and the scene's integrator cannot run any point.
    pub fn new(model: &'a Mechanism, scene: &Scene, grid: &'a Grid, how: &'a Overrides) -> Result<Self, Error> {
        let is_own_way = scene.integration.method == Integrator::Quadrature || scene.integration.project.is_some();
        let asked = match &how.by {
            None if is_own_way => ReducedRun::Asked,
            None => ReducedRun::IfGain,
            Some(EquationsName::Reduced) => ReducedRun::Asked,
            Some(_) if is_own_way => {
                let what = "quadrature and projection need the scene's reduced equations".to_owned();
                return Err(Error::request(what, "leave --by out, or give a stepping method without projection"));
            }
            Some(name) => return Self::by_full_equations(model, scene, grid, how, Some(name)),
        };
        match Self::by_own_equations(model, scene, grid, how, asked)? {
            Ok(sweep) => Ok(sweep),
            Err(why) => {
                let sweep = Self::by_full_equations(model, scene, grid, how, None)?;
                Ok(Self { note: Some(why), ..sweep })
            }
        }
    }

    /// Prepares a sweep by full equations with the given name, or by the first formulation that the model supports.
    fn by_full_equations(
        model: &'a Mechanism,
        scene: &Scene,
        grid: &'a Grid,
        how: &'a Overrides,
        name: Option<&EquationsName>,
    ) -> Result<Self, Error> {
        let by = find_equations_or_first(model, name)?;
        let inertia = InertiaCheck::new(model);
        let equations = FullEquations::new(model, scene, by.clone(), &inertia)?;
        let warnings = try_sweep_step(&equations.problem(model, scene, &inertia)?)?;
        // Impacts change the conserved quantities.
        let watch = if scene.impacts.is_empty() { prove_integrals_to_watch(model)? } else { None };
        let conserves = !equations.code.system().has_power() && !model.is_driven() && scene.impacts.is_empty();
        Ok(Self {
            model,
            scene: scene.clone(),
            grid,
            how,
            inertia,
            by,
            solve: equations.solve,
            code: equations.code.clone(),
            own: None,
            reports_energy: watch.is_none() && conserves,
            watch,
            names: equations.shown.names.clone(),
            full: vec![PreparedOnce::from(equations)],
            warnings,
            note: None,
            tells_digits: false,
            stop: AtomicBool::new(false),
        })
    }

    /// Prepares a sweep by the scene's reduced equations. The inner error is the reason why full equations are used.
    ///
    /// # Errors
    /// [`Error`] if reduced equations are asked for, and cannot run any point.
    fn by_own_equations(
        model: &'a Mechanism,
        scene: &Scene,
        grid: &'a Grid,
        how: &'a Overrides,
        asked: ReducedRun,
    ) -> Result<Result<Self, String>, Error> {
        if let Some(why) = reason_to_simulate_full_equations(model, scene, asked) {
            return Ok(Err(why.to_owned()));
        }
        let is_asked = asked == ReducedRun::Asked;
        let refused = |error: Error| {
            let why = format!("the reduced equations cannot simulate this scene ({})", error.first_line());
            if is_asked { Err(error) } else { Ok(Err(why)) }
        };
        let basis = match ReductionBasis::new(model) {
            Ok(basis) => basis,
            Err(error) => return refused(model.diagnose(&error).into()),
        };
        let watch = (are_integrals_proved(model) && !scene.states_outputs)
            .then(|| WatchedInvariants::of_basis(model, &basis))
            .transpose()?;
        let scene = scene_with_free_parameters(model, scene, grid)?;
        let own = OwnEquations::new(model, basis);
        let point = match own.point(&scene) {
            Ok(point) => point,
            Err(error) => return refused(error),
        };
        if !is_asked && let Some(why) = point.reason_against_reduction(model)? {
            return Ok(Err(format!("the full equations are integrated: {why}")));
        }
        let code = point.shared.code.clone();
        let warnings = try_sweep_step(&point.problem(model, &scene)?)?;
        let reports_energy = watch.is_none() && code.system().has_energy_gradient() && !model.is_driven();
        let full = [Formulation::Kane, Formulation::Lagrange].map(PreparedOnce::from);
        let sweep = Self {
            model,
            grid,
            how,
            inertia: InertiaCheck::new(model),
            by: point.by().clone(),
            solve: AccelerationSolution::Eliminated,
            code,
            own: Some(own),
            full: if is_asked { Vec::new() } else { full.into() },
            watch,
            reports_energy,
            names: scene.outputs.iter().map(|output| output.name.clone()).collect(),
            warnings,
            note: None,
            tells_digits: false,
            stop: AtomicBool::new(false),
            scene,
        };
        Ok(Ok(if is_asked || sweep.code.is_compiled() { sweep } else { sweep.with_compiled_equations()? }))
    }

    /// Replaces interpreted reduced equations by compiled full equations, if there are any and they are faster. The
    /// table keeps its columns, so that they do not depend on what is compiled.
    fn with_compiled_equations(self) -> Result<Self, Error> {
        let by = find_equations_or_first(self.model, None)?;
        let ready = CodePreparation::preparation_for_runs(&self.scene);
        if compiled_code(self.model, &by, self.scene.integration.distance, ready).is_none() {
            return Ok(self);
        }
        let equations = FullEquations::new(self.model, &self.scene, by.clone(), &self.inertia)?;
        // Full equations find reactions by a numeric solve at each sample, reduced equations by formulas.
        if equations.balance.needs_reactions() {
            return Ok(self);
        }
        let why = "the full equations are integrated: they are compiled, and the reduced equations are not";
        Ok(Self {
            by,
            solve: equations.solve,
            code: equations.code.clone(),
            own: None,
            full: vec![PreparedOnce::from(equations)],
            note: Some(why.to_owned()),
            ..self
        })
    }

    /// Quantities that are constant in each motion, whose changes the rows state.
    pub(super) fn conserved(&self) -> ConservedColumns<'_> {
        match &self.watch {
            Some(watch) => ConservedColumns::Integrals(watch),
            None if self.reports_energy => ConservedColumns::Energy,
            None => ConservedColumns::Nothing,
        }
    }

    /// Names of the quantities that are constant in each motion: the proved first integrals. If a model is
    /// too large for the proof, or if the scene states outputs, only the energy is named. Empty if no quantity is
    /// constant.
    pub fn conserved_names(&self) -> Vec<&str> {
        self.conserved().names()
    }

    /// Full equations of the sweep, prepared, in the order in which points try them.
    pub(super) fn full_equations(&self) -> impl Iterator<Item = &FullEquations> {
        self.full.iter().filter_map(|full| {
            let prepare = || FullEquations::new(self.model, &self.scene, full.by.clone(), &self.inertia).ok();
            full.prepared.get_or_init(prepare).as_ref()
        })
    }
}

impl From<FullEquations> for PreparedOnce {
    fn from(equations: FullEquations) -> Self {
        Self { by: equations.by.clone(), prepared: OnceLock::from(Some(equations)) }
    }
}

impl From<Formulation> for PreparedOnce {
    fn from(formulation: Formulation) -> Self {
        Self { by: formulation.into(), prepared: OnceLock::new() }
    }
}

/// Number of points of a grid that are read to find the parameters that vary, beside the first and the last.
const PROBES: u64 = 16;

/// Returns a scene in which the parameters that a grid varies are free, so that they stay symbols in reduced
/// equations. These are the swept parameters and the parameters whose formulas contain them.
///
/// # Errors
/// [`Error`] if the text of the scene cannot be read again.
fn scene_with_free_parameters(model: &Mechanism, scene: &Scene, grid: &Grid) -> Result<Scene, Error> {
    let mut family = Family::new(scene, model, grid)?;
    let last = grid.count() - 1;
    let mut free = scene.free.clone();
    for probe in 0..=PROBES {
        // Two halves, as the product of a probe and the last index may be too large.
        let point = last / PROBES * probe + last % PROBES * probe / PROBES;
        let Ok(other) = family.point(point).1 else { continue };
        let differs = |at: &usize| other.exact.parameters[*at] != scene.exact.parameters[*at];
        free.extend((0..scene.parameters.len()).filter(differs));
    }
    free.sort_unstable();
    free.dedup();
    Ok(Scene { free, ..scene.clone() })
}

/// Tests the integrator with one step from the scene's start. Returns the warnings that hold for every
/// point.
///
/// # Errors
/// `Error` if the integrator cannot run any point.
fn try_sweep_step(problem: &Problem<'_>) -> Result<Vec<String>, Error> {
    // The start of the scene file may be unsuitable for a run although the points of the sweep are suitable.
    let Ok(y0) = problem.start() else { return Ok(Vec::new()) };
    let options = Options { step_limit: 1, ..integration_options_for_ends(problem.scene) };
    if !problem.allows_integrator() {
        return problem.solve(&y0, &options, &mut [], None).map(|_| Vec::new());
    }
    match problem.integrate(&y0, &options, &mut []) {
        Err(error @ (SimError::NoStep { .. } | SimError::NoJacobian { .. } | SimError::NoSeries { .. })) => {
            Err(refused_scene_error(problem.scene, &error))
        }
        Err(_) => Ok(Vec::new()),
        Ok(solution) => {
            let raised = solution.warnings.iter().filter(|w| matches!(w, Warning::RtolRaised { .. }));
            Ok(raised.map(ToString::to_string).collect())
        }
    }
}
