//! Compiled equations of models: in f64, in twice that precision, in lanes (several states at
//! once), and with derivatives.
//!
//! Invariant: each trait of this module is a part of [`System`], so that a program compiles no more
//! of the equations for a kind of number than it needs.

use crate::{DoubleDouble, Integrands, Lanes, Lengths, Scalar, System, Tangent, lane_width};

/// Model whose equations are compiled into the program, with the hashes by which they are found and
/// checked.
pub struct CompiledModel {
    /// Name of the model, which is that of its folder under `models/`.
    pub name: &'static str,
    /// Hash of the model text from which the equations were derived, as the deriving crate computes it.
    pub text_hash: &'static str,
    /// Hash of the text of the publication whose printed equations are compiled; empty if there is
    /// none.
    pub publication_hash: &'static str,
    /// Equations of the model: each supported formulation (`kane`, `lagrange`, `newton-euler`), then
    /// those of the publication (`printed:ID`). A formulation may occur again with a distance from a
    /// singularity as a coordinate.
    pub systems: &'static [CompiledSystem],
    /// Reduced equations of the model's scenes, one for each scene that has them.
    pub scenes: &'static [CompiledScene],
}

/// Reduced equations of a single scene, compiled into the program.
pub struct CompiledScene {
    /// Name of the scene: its file's name without the extension.
    pub name: &'static str,
    /// Hash of everything on which the equations depend, as the deriving crate computes it: the model,
    /// the outputs of the scene, and the parameters that it fixes.
    pub key: &'static str,
    /// Reduced equations of the scene, in each kind of number.
    pub system: CompiledSystem,
}

/// Compiled equations of a single formulation, in each kind of number in which runs are made.
pub struct CompiledSystem {
    /// Name of the equations, such as `kane`. After an `@` follows the distance that replaces a
    /// coordinate, as in `kane@q2-90deg`.
    pub name: &'static str,
    /// Equations in f64, for ordinary runs.
    pub double: &'static (dyn System<f64> + Sync),
    /// Equations in [`DoubleDouble`], with twice the precision of f64, for reference runs.
    pub extended: &'static (dyn System<DoubleDouble> + Sync),
    /// Rates q̇ and v̇ of several states at once; `None` for equations whose accelerations were not
    /// solved for.
    pub lanes: Option<InLanes<'static>>,
}

/// Rates q̇ and v̇ of a state, without the other functions of a [`System`]; see [`Derivative`].
///
/// Batches of runs need only these. A program that runs a model in lanes need not compile all of
/// [`System`] for them, which would take an optimizing compiler far longer than for single numbers.
pub trait Rates<S: Scalar> {
    /// Numbers of parameters, coordinates, variables and all other quantities.
    fn lengths(&self) -> Lengths;
    /// Writes q̇ and v̇ at the state (q, v) with the parameters p, like [`System::derivative`].
    fn rates(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]);
}

/// Adapter that implements [`Rates`], [`Flow`] and [`Series`] for a [`System`];
/// [`System::has_accelerations`] must be true.
#[derive(Clone, Copy, Debug)]
pub struct Derivative<E>(
    /// Equations of motion whose accelerations were solved for.
    pub E,
);

impl<S: Scalar, E: System<S>> Rates<S> for Derivative<E> {
    fn lengths(&self) -> Lengths {
        self.0.lengths()
    }
    fn rates(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]) {
        self.0.derivative(p, q, v, q_dot, v_dot);
    }
}

/// Rates and constraints of a state, in numbers other than f64. These are the parts of a [`System`]
/// that runs with sensitivities need.
pub trait Flow<S: Scalar>: Rates<S> {
    /// Writes the residuals of the constraints, like [`System::constraints`]; they are zero where the
    /// constraints hold.
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]);
}

impl<S: Scalar, E: System<S>> Flow<S> for Derivative<E> {
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.0.constraints(p, q, v, out);
    }
}

/// Taylor coefficients of a motion, without the other functions of a [`System`]; see
/// [`Derivative`].
pub trait Series<S: Scalar> {
    /// True if [`Series::taylor`] has values, like [`System::has_taylor`].
    fn has_taylor(&self) -> bool;
    /// Length of the workspace of [`Series::taylor`] for this order, like [`System::taylor_work`].
    fn taylor_work(&self, order: usize) -> usize;
    /// Writes the Taylor coefficients of the motion, like [`System::taylor`].
    fn taylor(&self, p: &[S], order: usize, x: &mut [S], work: &mut [S]);
}

impl<S: Scalar, E: System<S>> Series<S> for Derivative<E> {
    fn has_taylor(&self) -> bool {
        self.0.has_taylor()
    }
    fn taylor_work(&self, order: usize) -> usize {
        self.0.taylor_work(order)
    }
    fn taylor(&self, p: &[S], order: usize, x: &mut [S], work: &mut [S]) {
        self.0.taylor(p, order, x, work);
    }
}

impl<S: Scalar, E: System<S>> Integrands<S> for Derivative<E> {
    fn coordinate_rates(&self, p: &[S], q: &[S], v: S, out: &mut [S]) {
        self.0.coordinate_rates(p, q, &[v], out);
    }
    fn kinetic_energy(&self, p: &[S], q: &[S], v: S) -> S {
        self.0.kinetic_energy(p, q, &[v])
    }
    fn potential_slope(&self, p: &[S], a: S, b: S) -> S {
        self.0.potential_slope(p, a, b)
    }
}

/// Equations with derivatives along one direction, and along four directions at once. Taylor
/// coefficients with derivatives are left out, because they would double the compile time.
#[derive(Clone, Copy)]
pub struct InTangents<'a> {
    /// Equations with derivatives along a single direction.
    pub one: &'a (dyn Flow<Tangent<1>> + Sync),
    /// Equations with derivatives along four directions at once.
    pub four: &'a (dyn Flow<Tangent<4>> + Sync),
}

/// Equations for several states at once: in four lanes and, if worthwhile, in eight lanes, as
/// Taylor coefficients, and with derivatives.
#[derive(Clone, Copy)]
pub struct InLanes<'a> {
    /// Rates q̇ and v̇ of four states at once.
    pub four: &'a (dyn Rates<Lanes<4>> + Sync),
    /// Rates of eight states at once; `None` for long equations, for which eight lanes leave no free
    /// register.
    pub eight: Option<&'a (dyn Rates<Lanes<8>> + Sync)>,
    /// Taylor coefficients of four motions at once; `None` if the equations have none, or too many
    /// operations.
    pub series: Option<&'a (dyn Series<Lanes<4>> + Sync)>,
    /// Equations of a single state with derivatives; `None` for long equations.
    pub tangents: Option<InTangents<'a>>,
}

impl<'a> InLanes<'a> {
    /// Wraps equations that are generic over the scalar: four lanes, eight lanes and derivatives,
    /// without Taylor coefficients.
    #[must_use]
    pub const fn of<E>(equations: &'a Derivative<E>) -> Self
    where
        E: System<Lanes<4>> + System<Lanes<8>> + System<Tangent<1>> + System<Tangent<4>> + Sync,
    {
        let tangents = InTangents { one: equations, four: equations };
        Self { four: equations, eight: Some(equations), series: None, tangents: Some(tangents) }
    }

    /// Wraps long equations, in four lanes only. Eight lanes and derivatives would take compilers
    /// several times as long and run no faster. Derivatives of long equations are interpreted.
    #[must_use]
    pub const fn of_four<E: Rates<Lanes<4>> + Sync>(equations: &'a E) -> Self {
        Self { four: equations, eight: None, series: None, tangents: None }
    }

    /// Wraps rates only, in four and in eight lanes, without derivatives and Taylor coefficients.
    #[must_use]
    pub const fn of_rates<E: Rates<Lanes<4>> + Rates<Lanes<8>> + Sync>(equations: &'a E) -> Self {
        Self { four: equations, eight: Some(equations), series: None, tangents: None }
    }

    /// Adds Taylor coefficients, in four lanes only. Their recurrences keep more values than any
    /// processor has registers, and take compilers longest of all.
    #[must_use]
    pub const fn with_series(self, series: &'a (dyn Series<Lanes<4>> + Sync)) -> Self {
        Self { series: Some(series), ..self }
    }

    /// Rates in eight lanes if this processor is fastest with eight; `None` if it is not, or if there
    /// are none.
    #[must_use]
    pub fn widest(self) -> Option<&'a (dyn Rates<Lanes<8>> + Sync)> {
        self.eight.filter(|_| lane_width() == 8)
    }
}
