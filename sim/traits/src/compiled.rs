//! Equations that are compiled into a program: in doubles, in twice their precision, in lanes, and with slopes.
//!
//! Invariant: each trait of this module is a part of [`System`], so that a program compiles no more of the equations
//! for a kind of number than it needs.

use crate::{DoubleDouble, Integrands, Lanes, Lengths, Scalar, System, Tangent, lane_width};

/// A model whose equations are compiled in, with the hashes by which a program finds and trusts them.
pub struct CompiledModel {
    /// Name of the model's folder under `models/`.
    pub name: &'static str,
    /// Hash of the model text that the equations were derived from, as the deriving crate computes it.
    pub text_hash: &'static str,
    /// Hash of the text of the publication whose printed equations are compiled in; empty if there is none.
    pub publication_hash: &'static str,
    /// Equations of the model: each supported formulation (`kane`, `lagrange`, `newton-euler`), then those of the
    /// publication (`printed:ID`). A formulation may come again in variables that measure the distance from a
    /// singularity.
    pub systems: &'static [CompiledSystem],
    /// Reduced equations of the model's scenes.
    pub scenes: &'static [CompiledScene],
}

/// The reduced equations of one scene, compiled in.
pub struct CompiledScene {
    /// Name of the scene's file without its ending.
    pub name: &'static str,
    /// A hash of everything that the equations depend on, as the deriving crate computes it: the model, the outputs
    /// that the scene asks for, and the parameters that it fixes.
    pub key: &'static str,
    /// Reduced equations of the scene.
    pub system: CompiledSystem,
}

/// Compiled equations of one formulation, ready for each kind of number in which runs are made.
pub struct CompiledSystem {
    /// Name of the equations, as `kane`; behind an `@` the distance that replaces a coordinate, as in `kane@q2-90deg`.
    pub name: &'static str,
    /// Equations in doubles.
    pub double: &'static (dyn System<f64> + Sync),
    /// Equations in [`DoubleDouble`], twice the precision of doubles, for reference runs.
    pub extended: &'static (dyn System<DoubleDouble> + Sync),
    /// Rates of several states at once; `None` for equations whose accelerations were not solved for.
    pub lanes: Option<InLanes<'static>>,
}

/// Rates q̇ and v̇ of a state, without the other functions of a [`System`]; see [`Derivative`].
///
/// Batches are integrated with it. A program that runs a model in lanes need not compile all of [`System`] for them,
/// which takes an optimizing compiler far longer than for single numbers.
pub trait Rates<S: Scalar> {
    /// Lengths of parameters, coordinates and variables.
    fn lengths(&self) -> Lengths;
    /// Writes q̇ and v̇, as [`System::derivative`] does.
    fn rates(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]);
}

/// Adapter that makes [`Rates`], [`Flow`] and [`Series`] of a [`System`] with [`System::has_accelerations`].
#[derive(Clone, Copy, Debug)]
pub struct Derivative<E>(
    /// Equations whose accelerations were solved for.
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

/// Rates of a state, and constraints, for runs in other numbers than doubles. These are the parts of a [`System`] that
/// runs with sensitivities need.
pub trait Flow<S: Scalar>: Rates<S> {
    /// Writes the constraint functions, as [`System::constraints`] does: they are zero where the constraints hold.
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]);
}

impl<S: Scalar, E: System<S>> Flow<S> for Derivative<E> {
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.0.constraints(p, q, v, out);
    }
}

/// Taylor coefficients of a motion, without the other functions of a [`System`]; see [`Derivative`].
pub trait Series<S: Scalar> {
    /// True if [`Series::taylor`] has values, as [`System::has_taylor`] says.
    fn has_taylor(&self) -> bool;
    /// Length of the workspace of [`Series::taylor`] for this order, as [`System::taylor_work`] gives it.
    fn taylor_work(&self, order: usize) -> usize;
    /// Writes the Taylor coefficients of the motion, as [`System::taylor`] does.
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

/// Equations with slopes along one and along four directions. Absent on purpose: Taylor coefficients with slopes, which
/// would double the time of compilation.
#[derive(Clone, Copy)]
pub struct InTangents<'a> {
    /// Equations with slopes along one direction.
    pub one: &'a (dyn Flow<Tangent<1>> + Sync),
    /// Equations with slopes along four directions at once.
    pub four: &'a (dyn Flow<Tangent<4>> + Sync),
}

/// Equations in four lanes; where they are worth it, also in eight lanes, as Taylor coefficients, and with slopes.
#[derive(Clone, Copy)]
pub struct InLanes<'a> {
    /// Rates of four states at once.
    pub four: &'a (dyn Rates<Lanes<4>> + Sync),
    /// Rates of eight states at once; `None` for long equations, which leave no register for eight lanes.
    pub eight: Option<&'a (dyn Rates<Lanes<8>> + Sync)>,
    /// Taylor coefficients of four motions at once; `None` if the equations have none, or very many.
    pub series: Option<&'a (dyn Series<Lanes<4>> + Sync)>,
    /// Equations at one state with slopes; `None` for long equations.
    pub tangents: Option<InTangents<'a>>,
}

impl<'a> InLanes<'a> {
    /// Equations that are written for every scalar: four and eight lanes and slopes, without Taylor coefficients.
    #[must_use]
    pub const fn of<E>(equations: &'a Derivative<E>) -> Self
    where
        E: System<Lanes<4>> + System<Lanes<8>> + System<Tangent<1>> + System<Tangent<4>> + Sync,
    {
        let tangents = InTangents { one: equations, four: equations };
        Self { four: equations, eight: Some(equations), series: None, tangents: Some(tangents) }
    }

    /// Long equations, in four lanes alone. Eight lanes would take compilers several times as long and run no faster.
    /// The same holds for slopes; with them long equations are interpreted.
    #[must_use]
    pub const fn of_four<E: Rates<Lanes<4>> + Sync>(equations: &'a E) -> Self {
        Self { four: equations, eight: None, series: None, tangents: None }
    }

    /// Rates alone, in four and in eight lanes.
    #[must_use]
    pub const fn of_rates<E: Rates<Lanes<4>> + Rates<Lanes<8>> + Sync>(equations: &'a E) -> Self {
        Self { four: equations, eight: Some(equations), series: None, tangents: None }
    }

    /// Adds Taylor coefficients, in four lanes alone. The recurrences keep more values than any processor has
    /// registers, and take compilers longest of all.
    #[must_use]
    pub const fn with_series(self, series: &'a (dyn Series<Lanes<4>> + Sync)) -> Self {
        Self { series: Some(series), ..self }
    }

    /// Rates in eight lanes, if this processor computes best in them.
    #[must_use]
    pub fn widest(self) -> Option<&'a (dyn Rates<Lanes<8>> + Sync)> {
        self.eight.filter(|_| lane_width() == 8)
    }
}
