//! Equations that are compiled in: in doubles and in twice their precision, at several states at once, and with slopes.
//!
//! Invariant: each of these traits is a part of [`System`] alone, so that a program compiles no more of the equations
//! for a kind of number than it needs.

use crate::{DoubleDouble, Integrands, Lanes, Lengths, Scalar, System, Tangent, lane_width};

/// A model whose equations are compiled in, with the hashes by which a program finds and trusts them.
pub struct CompiledModel {
    /// The folder's name under `models/`.
    pub name: &'static str,
    /// Hash of the model text the equations were derived from, as the deriving crate computes it.
    pub text_hash: &'static str,
    /// Hash of the text of the publication whose printed equations are compiled in; empty if there is none.
    pub publication_hash: &'static str,
    /// Equations: each supported formulation (`kane`, `lagrange`, `newton-euler`), also in the distances that are
    /// worth having, then those of the publication (`printed:ID`).
    pub systems: &'static [CompiledSystem],
    /// The equations of its scenes.
    pub scenes: &'static [CompiledScene],
}

/// The reduced equations of one scene, compiled in.
pub struct CompiledScene {
    /// The name of the scene's file without its ending.
    pub name: &'static str,
    /// A hash of everything that the equations depend on, as the deriving crate computes it: the model, the outputs
    /// that the scene asks for, and the parameters that it fixes.
    pub key: &'static str,
    /// The equations.
    pub system: CompiledSystem,
}

/// One set of compiled equations, ready for each kind of number that runs are made in.
pub struct CompiledSystem {
    /// Its name; behind an `@` the distance that stands for a coordinate, as in `kane@q2-90deg`.
    pub name: &'static str,
    /// In doubles.
    pub double: &'static (dyn System<f64> + Sync),
    /// In twice that precision, for reference runs.
    pub extended: &'static (dyn System<DoubleDouble> + Sync),
    /// The derivative of several states at once; `None` for equations whose accelerations were not solved for.
    pub lanes: Option<InLanes<'static>>,
}

/// The derivative of the state alone, as [`Derivative`] takes it from a [`System`].
///
/// Batches are integrated with it. A program that runs a model in lanes need not compile all of [`System`] for them,
/// which takes an optimizing compiler far longer than for single numbers.
pub trait Rates<S: Scalar> {
    /// Lengths of the arguments and results.
    fn lengths(&self) -> Lengths;
    /// q̇ and v̇, as [`System::derivative`] writes them.
    fn rates(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]);
}

/// The derivative of a [`System`] whose [`System::has_accelerations`] holds.
#[derive(Clone, Copy, Debug)]
pub struct Derivative<E>(
    /// The equations.
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

/// The derivative of the state, and the constraints, for runs in other numbers than doubles. These are the parts of a
/// [`System`] that runs with sensitivities need.
pub trait Flow<S: Scalar>: Rates<S> {
    /// Writes the constraint functions, as [`System::constraints`] does: they are zero where the constraints hold.
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]);
}

impl<S: Scalar, E: System<S>> Flow<S> for Derivative<E> {
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.0.constraints(p, q, v, out);
    }
}

/// The Taylor coefficients of the motion alone, as [`Derivative`] takes them from a [`System`].
pub trait Series<S: Scalar> {
    /// True if there are coefficients: [`System::has_taylor`].
    fn has_taylor(&self) -> bool;
    /// The length of the workspace: [`System::taylor_work`].
    fn taylor_work(&self, order: usize) -> usize;
    /// Writes the coefficients: [`System::taylor`].
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
/// would take compilers as long again as all the rest.
#[derive(Clone, Copy)]
pub struct InTangents<'a> {
    /// Slopes along one direction.
    pub one: &'a (dyn Flow<Tangent<1>> + Sync),
    /// Slopes along four directions at once.
    pub four: &'a (dyn Flow<Tangent<4>> + Sync),
}

/// Equations in one or both widths of lanes, and with slopes.
#[derive(Clone, Copy)]
pub struct InLanes<'a> {
    /// Four states at once.
    pub four: &'a (dyn Rates<Lanes<4>> + Sync),
    /// Eight states at once; none of long equations, which leave no register for them.
    pub eight: Option<&'a (dyn Rates<Lanes<8>> + Sync)>,
    /// The Taylor coefficients of four motions at once; none of equations that have none, or very many.
    pub series: Option<&'a (dyn Series<Lanes<4>> + Sync)>,
    /// One state with its slopes.
    pub tangents: Option<InTangents<'a>>,
}

impl<'a> InLanes<'a> {
    /// Equations that are written for every scalar.
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

    /// Rates alone, in both widths.
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
