//! Cases of a chart: equations of motion, ways in which accelerations are found, and methods of the runs.

use crate::code::{Code, Ready, code};
use crate::error::{Error, refused};
use crate::follow::uninterrupted;
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use crate::preparation::reduced::Reduced;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::reduce::Reduction;
use tripos_derive::scene::{Integrator, Scene, Solve};
use tripos_sim::work_precision::options;
use tripos_sim::{Method, Options, Solution, quadrature};

/// Methods that also run a scene's reduced equations with an absolute tolerance alone. Their errors are so small that
/// relative tolerances cannot be fine enough.
const FINE: [Method; 2] = [Method::Dop853, Method::Taylor];

/// Equations of motion with the way in which their accelerations are found, as one case of a chart.
pub struct Case {
    /// Name of the equations of motion.
    pub by: EquationsOrigin,
    /// Compiled or interpreted equations, in the scene's distance if it has one.
    pub code: Code,
    /// Way in which accelerations are found.
    pub solve: Solve,
    /// Reduction that gave a scene's reduced equations; `None` for those of the whole model.
    pub reduction: Option<Reduction>,
}

impl Case {
    /// True if a method can run the case. An implicit method needs a Jacobian, and Taylor's method needs eliminated
    /// accelerations.
    #[must_use]
    pub fn has(&self, method: Method) -> bool {
        let system = self.code.system();
        let series = self.solve == Solve::Eliminated && system.has_taylor();
        (!method.needs_jacobian() || system.has_accelerations()) && (!method.needs_series() || series)
    }

    /// Lists the methods that can run the case, at each of the given tolerances, and quadrature if it gives the motion.
    #[must_use]
    pub fn ways(&self, tolerances: &[f64]) -> Vec<MethodAtTolerance> {
        let mut list = Vec::new();
        for method in Method::ALL.into_iter().filter(|method| self.has(*method)) {
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

    /// True if the motion of the case can be computed by quadrature.
    #[must_use]
    pub fn has_quadrature(&self) -> bool {
        self.reduction.is_some() && self.code.system().has_potential_slope()
    }

    /// Prepares the case for the start of a scene. The scene must have the model and the outputs of the case.
    ///
    /// # Errors
    /// Errors of [`Reduced::with`].
    pub fn prepare<'a>(&'a self, model: &'a Mechanism, scene: &'a Scene) -> Result<Prepared<'a>, Error> {
        let reduction = self.reduction.clone();
        let mut reduced = reduction.map(|reduction| Reduced::with(reduction, model, scene)).transpose()?;
        if let Some(reduced) = &mut reduced {
            // The reduced equations have only the case's way of solving.
            reduced.scene.integration.solve = Some(self.solve);
        }
        Ok(Prepared { case: self, model, scene, reduced })
    }
}

/// A case of a chart that is prepared for the start of a scene.
pub struct Prepared<'a> {
    case: &'a Case,
    model: &'a Mechanism,
    scene: &'a Scene,
    /// Reduced equations from the start of the scene; `None` for equations of the whole model.
    reduced: Option<Reduced>,
}

impl Prepared<'_> {
    /// Makes the problem of the case, ready to be integrated.
    ///
    /// # Errors
    /// Errors of [`Problem::new`].
    pub fn problem(&self) -> Result<Problem<'_>, Error> {
        let Self { case, model, scene, reduced } = self;
        match reduced {
            Some(reduced) => Problem::reduced(model, reduced, scene, &case.code),
            None => Problem::new(model, scene, &case.by, &case.code, Some(case.solve)),
        }
    }
}

/// Method and tolerance of a run of a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MethodAtTolerance {
    /// Steps of a method, with one number for relative and absolute tolerance.
    Steps(Method, f64),
    /// Steps of a method at an absolute tolerance alone. It can be finer than a relative tolerance, which is at least
    /// several roundings.
    Absolute(Method, f64),
    /// Integrals over the coordinate, exact to rounding.
    Quadrature,
}

impl MethodAtTolerance {
    /// Method of the steps; `None` for quadrature.
    #[must_use]
    pub fn method(self) -> Option<Method> {
        match self {
            Self::Steps(method, _) | Self::Absolute(method, _) => Some(method),
            Self::Quadrature => None,
        }
    }

    /// Name of the method, or of quadrature.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.method().map_or(Integrator::Quadrature, Integrator::Steps).name()
    }

    /// Tolerance of the steps; `None` for quadrature.
    #[must_use]
    pub fn tolerance(self) -> Option<f64> {
        match self {
            Self::Steps(_, tolerance) | Self::Absolute(_, tolerance) => Some(tolerance),
            Self::Quadrature => None,
        }
    }

    /// Name of the way in which accelerations are found; `-` for quadrature, which needs none.
    #[must_use]
    pub fn solve(self, solve: Solve) -> &'static str {
        match self {
            Self::Steps(..) | Self::Absolute(..) => solve.name(),
            Self::Quadrature => "-",
        }
    }

    /// Integration options for a span of the given length, s.
    #[must_use]
    pub fn options(self, length: f64, step_limit: u64) -> Options {
        match self {
            Self::Steps(method, tolerance) => options(method, tolerance, length, step_limit),
            Self::Absolute(method, tolerance) => {
                Options { rtol: 0.0, ..options(method, tolerance, length, step_limit) }
            }
            // Only the step limit matters for quadrature.
            Self::Quadrature => options(Method::Dop853, 1e-12, length, step_limit),
        }
    }

    /// Integrates a problem over a span from the integrated state `y0`.
    ///
    /// # Errors
    /// [`Error::Request`] if the request is invalid, or quadrature does not give the motion.
    pub fn run(
        self,
        problem: &Problem<'_>,
        span: (f64, f64),
        y0: &[f64],
        options: &Options,
    ) -> Result<Solution, Error> {
        match self {
            Self::Steps(..) | Self::Absolute(..) => {
                let run = problem.integrate_over(span, y0, options, &mut []);
                uninterrupted(run.map_err(|error| refused(problem.scene, &error))?)
            }
            Self::Quadrature => {
                let p = &problem.scene.parameters;
                quadrature::solve(problem.system(), p, span, y0, options, &mut []).map_err(|error| {
                    Error::request(format!("no motion by quadrature: {error}"), "integrate step by step".to_owned())
                })
            }
        }
    }
}

/// Treatment of the equations of a publication beside the derived ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Printed {
    /// The printed equations are run as they stand.
    Included,
    /// Only derived equations are run.
    LeftOut,
}

/// Lists every formulation of the model with each way to find its accelerations. Printed equations follow, as they
/// stand, if `printed` includes them, and then the scene's reduced equations. Also returns the reasons why cases are
/// missing.
///
/// # Errors
/// [`Error`] if no equations can be run.
pub fn cases(model: &Mechanism, scene: &Scene, printed: Printed) -> Result<(Vec<Case>, Vec<String>), Error> {
    let (mut list, mut left_out) = whole(model, scene, printed)?;
    match own(model, scene) {
        Ok(case) => list.push(case),
        Err(failure) => left_out.push(format!("the scene's reduced equations: {}", failure.first_line())),
    }
    Ok((list, left_out))
}

/// Lists the cases with equations of the whole model. Also returns the reasons why cases are missing.
///
/// # Errors
/// Errors of [`cases`].
pub fn whole(model: &Mechanism, scene: &Scene, printed: Printed) -> Result<(Vec<Case>, Vec<String>), Error> {
    let (mut list, mut left_out) = (Vec::new(), Vec::new());
    let mut why = None;
    let mut names: Vec<EquationsOrigin> = tripos_derive::Formulation::STANDARD.map(EquationsOrigin::from).to_vec();
    if printed == Printed::Included {
        names.extend(crate::code::printed(model)?);
    }
    for by in names {
        match code(model, &by, scene.integration.distance, Ready::Solved) {
            Ok(code) => {
                let can = |solve: &Solve| *solve == Solve::Numeric || code.system().has_accelerations();
                let solves = Solve::ALL.into_iter().filter(can);
                list.extend(solves.map(|solve| Case { by: by.clone(), code: code.clone(), solve, reduction: None }));
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

/// Makes the case of a scene's reduced equations.
///
/// # Errors
/// [`Error`] if the scene has no reduced equations; the other cases can still be charted.
pub fn own(model: &Mechanism, scene: &Scene) -> Result<Case, Error> {
    let reduced = Reduced::new(model, scene)?;
    let code = reduced.code(model)?;
    Ok(Case { by: reduced.by, code, solve: Solve::Eliminated, reduction: Some(reduced.reduction) })
}
