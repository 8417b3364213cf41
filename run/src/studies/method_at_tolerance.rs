//! Integrator and tolerance of a run in a work-precision chart.

use crate::error::{Error, refused_scene_error};
use crate::observer::require_uninterrupted;
use crate::preparation::problem::Problem;
use tripos_derive::scene::{AccelerationSolution, Integrator};
use tripos_sim::work_precision::work_precision_options;
use tripos_sim::{Method, Options, Solution, quadrature};

/// Integrator and tolerance of a run in a work-precision chart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MethodAtTolerance {
    /// Steps of an integrator, with the same number as relative and absolute tolerance.
    Steps(Method, f64),
    /// Steps of an integrator with an absolute tolerance alone. It may be finer than a relative tolerance,
    /// which must be several times the rounding error of a double.
    Absolute(Method, f64),
    /// Quadrature: the time as an integral over the only coordinate, exact up to rounding.
    Quadrature,
}

impl MethodAtTolerance {
    /// Integrator of the steps; `None` for quadrature.
    #[must_use]
    pub fn method(self) -> Option<Method> {
        match self {
            Self::Steps(method, _) | Self::Absolute(method, _) => Some(method),
            Self::Quadrature => None,
        }
    }

    /// Name of the integrator, or of quadrature, for tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.method().map_or(Integrator::Quadrature, Integrator::Steps).name()
    }

    /// Tolerance of the steps, relative or absolute; `None` for quadrature.
    #[must_use]
    pub fn tolerance(self) -> Option<f64> {
        match self {
            Self::Steps(_, tolerance) | Self::Absolute(_, tolerance) => Some(tolerance),
            Self::Quadrature => None,
        }
    }

    /// Name of the method that finds the accelerations, for tables; `-` for quadrature, which needs none.
    #[must_use]
    pub fn solve(self, solve: AccelerationSolution) -> &'static str {
        match self {
            Self::Steps(..) | Self::Absolute(..) => solve.name(),
            Self::Quadrature => "-",
        }
    }

    /// Integration options for a span of `length` s, with at most `step_limit` steps.
    #[must_use]
    pub fn options(self, length: f64, step_limit: u64) -> Options {
        match self {
            Self::Steps(method, tolerance) => work_precision_options(method, tolerance, length, step_limit),
            Self::Absolute(method, tolerance) => {
                Options { rtol: 0.0, ..work_precision_options(method, tolerance, length, step_limit) }
            }
            // Only the step limit matters for quadrature.
            Self::Quadrature => work_precision_options(Method::Dop853, 1e-12, length, step_limit),
        }
    }

    /// Integrates a problem over a span, s, from the integrated state `y0` at its first instant.
    ///
    /// # Errors
    /// [`Error::Request`] if the options are invalid, or if quadrature cannot compute the motion.
    /// `Error::Interrupted` if the observer of the run ended it.
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
                require_uninterrupted(run.map_err(|error| refused_scene_error(problem.scene, &error))?)
            }
            Self::Quadrature => {
                let p = &problem.scene.parameters;
                quadrature::run_by_quadrature(problem.system(), p, span, y0, options, &mut []).map_err(|error| {
                    Error::request(format!("no motion by quadrature: {error}"), "integrate step by step".to_owned())
                })
            }
        }
    }
}
