//! Cases of a work-precision chart: equations of motion with the method that finds their accelerations,
//! and the integrators that can run them.

pub use super::method_at_tolerance::MethodAtTolerance;

use crate::code::{Code, CodePreparation, runnable_code};
use crate::equations_name::list_printed_equations;
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use crate::preparation::reduced_equations::ReducedScene;
use std::sync::Arc;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::reduce::Reduction;
use tripos_derive::scene::{AccelerationSolution, Scene};
use tripos_sim::Method;

/// Integrators that also run reduced equations with an absolute tolerance alone. These equations can be
/// so accurate that the finest relative tolerance is too coarse.
const FINE: [Method; 2] = [Method::Dop853, Method::Taylor];

/// Case of a work-precision chart: equations of motion, with the method that finds their
/// accelerations.
pub struct ChartCase {
    /// Origin of the equations of motion: a formulation, a publication or the scene's reduction.
    pub by: EquationsOrigin,
    /// Compiled or interpreted equations. They use the distance of a coordinate from a singular surface if
    /// the scene asks for it.
    pub code: Code,
    /// Method that finds the accelerations: eliminated beforehand, or solved for numerically at each
    /// state.
    pub solve: AccelerationSolution,
    /// Reduction that gave the scene's reduced equations; `None` for equations of the whole model.
    pub reduction: Option<Arc<Reduction>>,
}

impl ChartCase {
    /// True if an integrator can run the case. Implicit integrators need a Jacobian. Taylor's method
    /// needs eliminated accelerations and their series.
    #[must_use]
    pub fn can_run_with(&self, method: Method) -> bool {
        let system = self.code.system();
        let series = self.solve == AccelerationSolution::Eliminated && system.has_taylor();
        (!method.needs_jacobian() || system.has_accelerations()) && (!method.needs_series() || series)
    }

    /// Lists the integrators that can run the case, each at every tolerance in `tolerances`, whose last is
    /// the finest. Quadrature follows if it can compute the motion.
    #[must_use]
    pub fn integrators_and_tolerances(&self, tolerances: &[f64]) -> Vec<MethodAtTolerance> {
        let mut list = Vec::new();
        for method in Method::ALL.into_iter().filter(|method| self.can_run_with(*method)) {
            list.extend(tolerances.iter().map(|tolerance| MethodAtTolerance::Steps(method, *tolerance)));
            if let (true, Some(finest)) = (self.reduction.is_some() && FINE.contains(&method), tolerances.last()) {
                list.extend([10.0, 100.0].map(|times| MethodAtTolerance::Absolute(method, finest / times)));
            }
        }
        if self.has_quadrature() {
            list.push(MethodAtTolerance::Quadrature);
        }
        list
    }

    /// True if quadrature can compute the motion of the case. This needs reduced equations with a potential
    /// of one coordinate.
    #[must_use]
    pub fn has_quadrature(&self) -> bool {
        self.reduction.is_some() && self.code.system().has_potential_slope()
    }

    /// Prepares the case for the start of a scene. The scene must have the model and the outputs of the
    /// case.
    ///
    /// # Errors
    /// [`Error`] if the reduced equations have no value at the scene's start, or if this start cannot be
    /// moved to the section of their moving frame.
    pub fn prepare<'a>(&'a self, model: &'a Mechanism, scene: &'a Scene) -> Result<PreparedCase<'a>, Error> {
        let reduction = self.reduction.clone();
        let mut reduced =
            reduction.map(|reduction| ReducedScene::from_reduction(reduction, model, scene)).transpose()?;
        if let Some(reduced) = &mut reduced {
            // The reduced equations have only the case's method for the accelerations.
            reduced.scene.integration.solve = Some(self.solve);
        }
        Ok(PreparedCase { case: self, model, scene, reduced })
    }
}

/// Case of a work-precision chart that is prepared for the start of a scene.
pub struct PreparedCase<'a> {
    /// Case with its equations, and the method that finds their accelerations.
    case: &'a ChartCase,
    /// Mechanism of the scene.
    model: &'a Mechanism,
    /// Scene whose start and span are used.
    scene: &'a Scene,
    /// Reduced equations for the start of the scene; `None` if the case has equations of the whole
    /// model.
    reduced: Option<ReducedScene>,
}

impl PreparedCase<'_> {
    /// Makes the problem of the case: the scene with its equations, ready to be integrated.
    ///
    /// # Errors
    /// [`Error`] if eliminated accelerations are required but the equations have none, or if a moving body
    /// has no mass.
    pub fn problem(&self) -> Result<Problem<'_>, Error> {
        let Self { case, model, scene, reduced } = self;
        match reduced {
            Some(reduced) => Problem::reduced(model, reduced, scene, &case.code),
            None => Problem::new(model, scene, &case.by, &case.code, Some(case.solve)),
        }
    }
}

/// Choice if the equations of a publication are run in addition to the derived equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PrintedEquationsChoice {
    /// The printed equations are run as they stand.
    Included,
    /// Only derived equations are run.
    LeftOut,
}

/// Lists the cases of a work-precision chart: every standard formulation with each method for its
/// accelerations. Printed equations follow if `printed` includes them, then the scene's reduced
/// equations. The second list gives the reason for each missing case.
///
/// # Errors
/// [`Error`] if no equations of the whole model can be run.
pub fn cases(
    model: &Mechanism,
    scene: &Scene,
    printed: PrintedEquationsChoice,
) -> Result<(Vec<ChartCase>, Vec<String>), Error> {
    let (mut list, mut left_out) = full_equation_cases(model, scene, printed)?;
    match reduced_equation_case(model, scene) {
        Ok(case) => list.push(case),
        Err(failure) => left_out.push(format!("the scene's reduced equations: {}", failure.first_line())),
    }
    Ok((list, left_out))
}

/// Lists the cases with equations of the whole model: derived equations, and printed equations if
/// `printed` includes them. The second list gives the reason for each case that is missing.
///
/// # Errors
/// [`Error`] if no equations can be run, or if the printed equations cannot be listed.
pub fn full_equation_cases(
    model: &Mechanism,
    scene: &Scene,
    printed: PrintedEquationsChoice,
) -> Result<(Vec<ChartCase>, Vec<String>), Error> {
    let (mut list, mut left_out) = (Vec::new(), Vec::new());
    let mut why = None;
    let mut names: Vec<EquationsOrigin> = tripos_derive::Formulation::STANDARD.map(EquationsOrigin::from).to_vec();
    if printed == PrintedEquationsChoice::Included {
        names.extend(list_printed_equations(model)?);
    }
    for by in names {
        match runnable_code(model, &by, scene.integration.distance, CodePreparation::Solved) {
            Ok(code) => {
                let can = |solve: &AccelerationSolution| {
                    *solve == AccelerationSolution::Numeric || code.system().has_accelerations()
                };
                let solves = AccelerationSolution::ALL.into_iter().filter(can);
                list.extend(solves.map(|solve| ChartCase {
                    by: by.clone(),
                    code: code.clone(),
                    solve,
                    reduction: None,
                }));
            }
            Err(failure) => {
                left_out.push(format!("{}: {}", by.name(), failure.first_line()));
                why = Some(failure);
            }
        }
    }
    match why {
        Some(failure) if list.is_empty() => Err(failure),
        _ => Ok((list, left_out)),
    }
}

/// Makes the case of a scene's reduced equations, whose accelerations are eliminated.
///
/// # Errors
/// [`Error`] if the scene has no reduced equations. Other cases may still exist.
pub fn reduced_equation_case(model: &Mechanism, scene: &Scene) -> Result<ChartCase, Error> {
    let reduced = ReducedScene::new(model, scene)?;
    let code = reduced.code(model)?;
    Ok(ChartCase { by: reduced.by, code, solve: AccelerationSolution::Eliminated, reduction: Some(reduced.reduction) })
}
