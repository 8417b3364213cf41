//! Sweeps backwards through the steps of a run: the transpose of forward slopes along the same steps, to rounding.

use crate::lent::integrate;
use proptest::prelude::*;
use tripos_sim::adjoint::{Adjoint, AdjointError, Gradient, MovingJump, RecordedSteps, adjoint_segments, has_adjoint};
use tripos_sim::{
    Corner, Failure, LentRightHandSide, Method, Options, OutputOption, ProductSums, RightHandSide,
    TransposedRightHandSide,
};
use tripos_traits::{Real, Scalar, Tangent};

/// Equations y′ = f(p, t, y), with their constraint functions and the slopes of these.
#[derive(Clone, Copy)]
enum Problem {
    /// Four components and three parameters, with sines, products and a drive in time; the numbers mix them.
    Free([f64; 16]),
    /// Those of [`Self::Free`] with a force that jumps at the instant p₂ and bends at 0.6.
    Driven([f64; 16]),
    /// A point on a circle of radius p₀ in Cartesian coordinates, with gravity p₁ and a drag p₂. It is kept on the
    /// circle in the metric of masses 1 and 2.
    Circle,
    /// The point on a circle, kept there in the metric of the tolerances.
    Weighted,
}

const BEND: f64 = 0.6;

impl Problem {
    fn rates<S: Real>(&self, p: &[S], t: f64, y: &[S], out: &mut [S]) {
        let a = match self {
            Self::Free(a) | Self::Driven(a) => a,
            Self::Circle | Self::Weighted => return circle(p, y, out),
        };
        for (i, out) in out.iter_mut().enumerate() {
            let row = &a[4 * i..4 * i + 4];
            let mixed = row.iter().zip(y).fold(S::from_f64(0.0), |sum, (a, y)| sum + S::from_f64(*a) * *y);
            *out = mixed.sin_cos().0 * p[i % 3] + p[(i + 1) % 3] * y[(i + 1) % 4] * S::from_f64(0.3 * t.cos());
        }
        if let Self::Driven(_) = self {
            let side = S::from_f64((t - p[2].to_f64()).signum());
            out[1] = out[1] + p[0] * side + (S::from_f64(t - BEND)).abs() * y[0];
        }
    }

    fn constraints<S: Real>(&self, p: &[S], y: &[S], values: &mut [S], slopes: &mut [S]) {
        if !self.has_constraints() {
            return;
        }
        let zero = S::from_f64(0.0);
        values.copy_from_slice(&[
            (y[0] * y[0] + y[1] * y[1] - p[0] * p[0]) * S::from_f64(0.5),
            y[0] * y[2] + y[1] * y[3],
        ]);
        slopes.copy_from_slice(&[y[0], y[1], zero, zero, y[2], y[3], y[0], y[1]]);
    }

    fn has_constraints(&self) -> bool {
        matches!(self, Self::Circle | Self::Weighted)
    }
}

fn circle<S: Real>(p: &[S], y: &[S], out: &mut [S]) {
    let (x, z, u, w) = (y[0], y[1], y[2], y[3]);
    let tension = (u * u + w * w - p[1] * z) / (p[0] * p[0]);
    let forces = [-tension * x - p[2] * u, -tension * z - p[1] - p[2] * w];
    out.copy_from_slice(&[u, w, forces[0], forces[1]]);
}

/// A problem at its parameters.
struct At<S> {
    problem: Problem,
    p: Vec<S>,
}

impl<S: Real> RightHandSide<S> for At<S> {
    fn rhs(&mut self, t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
        self.problem.rates(&self.p, t, y, dydt);
        Ok(())
    }
    fn constraint_count(&self) -> usize {
        if self.problem.has_constraints() { 2 } else { 0 }
    }
    fn constraints(&mut self, _t: f64, y: &[S], values: &mut [S], slopes: &mut [S]) {
        self.problem.constraints(&self.p, y, values, slopes);
    }
    fn inertia(&mut self, _t: f64, _y: &[S], out: &mut Vec<f64>) -> bool {
        *out = vec![1.0, 0.0, 0.0, 2.0];
        matches!(self.problem, Problem::Circle)
    }
}

/// Products with transposed slopes, column by column: the test is of the sweep alone.
impl At<f64> {
    fn columns(
        &self,
        y: &[f64],
        weights: &[f64],
        (by_state, by_parameters): ProductSums<'_>,
        of: impl Fn(&[Tangent<1>], &[Tangent<1>], &mut [Tangent<1>]),
    ) {
        let n = y.len();
        for along in 0..n + self.p.len() {
            let number = |(i, x): (usize, &f64), first: usize| Tangent {
                value: *x,
                slopes: [f64::from(u8::from(first + i == along))],
            };
            let y: Vec<_> = y.iter().enumerate().map(|y| number(y, 0)).collect();
            let p: Vec<_> = self.p.iter().enumerate().map(|p| number(p, n)).collect();
            let mut out = vec![Tangent::from_f64(0.0); weights.len()];
            of(&p, &y, &mut out);
            let sum: f64 = out.iter().zip(weights).map(|(x, w)| x.slopes[0] * w).sum();
            if along < n { by_state[along] += sum } else { by_parameters[along - n] += sum }
        }
    }
}

impl TransposedRightHandSide for At<f64> {
    fn parameter_count(&self) -> usize {
        self.p.len()
    }
    fn add_transposed_product(
        &mut self,
        t: f64,
        y: &[f64],
        weights: &[f64],
        to: ProductSums<'_>,
    ) -> Result<(), Failure> {
        self.columns(y, weights, to, |p, y, out| self.problem.rates(p, t, y, out));
        Ok(())
    }
    fn add_transposed_constraint_product(
        &mut self,
        _t: f64,
        y: &[f64],
        weights: &[f64],
        to: ProductSums<'_>,
    ) -> Result<(), Failure> {
        let of = |p: &[Tangent<1>], y: &[Tangent<1>], out: &mut [Tangent<1>]| {
            self.problem.constraints(p, y, out, &mut [Tangent::from_f64(0.0); 8]);
        };
        self.columns(y, weights, to, of);
        Ok(())
    }
}

const SPAN: (f64, f64) = (0.0, 2.0);

fn options(problem: Problem, p: &[f64], method: Method, tolerance: f64) -> Options {
    let corners = match problem {
        Problem::Driven(_) => {
            vec![Corner { moves: [1.0, 0.0, 0.0, 0.0], ..Corner::jump(p[2]) }, Corner::kink(BEND)]
        }
        _ => Vec::new(),
    };
    let step = (method == Method::Rk4).then_some(0.01);
    Options {
        method,
        step,
        corners,
        output: OutputOption::Steps { refine: 1 },
        ..Options::tolerances(tolerance, tolerance)
    }
}

/// Motion of a problem with parameters `p` from the state `y0` at the start.
#[derive(Clone, Copy)]
struct Motion<'a> {
    problem: Problem,
    p: &'a [f64],
    y0: &'a [f64],
}

/// The gradient of Σ weightᵢ yᵢ at the end by a sweep in these segments, and how many steps there are.
fn backwards(
    motion: Motion<'_>,
    options: &Options,
    weights: &[f64],
    parts: impl Fn(usize) -> Vec<usize>,
) -> (Gradient, usize) {
    let Motion { problem, p, y0 } = motion;
    let mut rhs = At { problem, p: p.to_vec() };
    let run = integrate(LentRightHandSide(&mut rhs), SPAN, y0, options, &mut []).unwrap();
    assert!(!run.stop.is_failure(), "{run}");
    let moved = options.corners.iter().filter(|corner| corner.jumps);
    let moved: Vec<MovingJump> = moved.map(|corner| MovingJump { at: corner.at, by: vec![0.0, 0.0, 1.0] }).collect();
    let ends = &run.t[1..];
    let course = RecordedSteps { span: SPAN, y0, ends, options, moved: &moved };
    let adjoint = Adjoint::new(course, &mut rhs, &parts(ends.len())).unwrap();
    let apart = adjoint.end.iter().zip(&run.y_end).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
    assert!(apart < 1e-12, "the steps are those of the run: {apart:e}");
    (adjoint.gradient(&mut rhs, weights).unwrap(), ends.len())
}

/// Gradient by runs that carry a slope forwards, one for each component of the start and each parameter.
fn forwards(motion: Motion<'_>, options: &Options, weights: &[f64]) -> Vec<f64> {
    let Motion { problem, p, y0 } = motion;
    let along = |along: usize| {
        let slope = |at: usize| [f64::from(u8::from(at == along))];
        let y: Vec<_> = y0.iter().enumerate().map(|(i, y)| Tangent { value: *y, slopes: slope(i) }).collect();
        let p: Vec<_> = p.iter().enumerate().map(|(j, p)| Tangent { value: *p, slopes: slope(y0.len() + j) }).collect();
        let mut options = options.clone();
        // The jump is at the last parameter.
        for corner in &mut options.corners {
            corner.moves[0] *= p[2].slopes[0];
        }
        let run = integrate(At { problem, p }, SPAN, &y, &options, &mut []).unwrap();
        run.y_end.iter().zip(weights).map(|(y, w)| y.slopes[0] * w).sum()
    };
    (0..y0.len() + p.len()).map(along).collect()
}

/// The largest difference of the two by the size of the gradient.
fn apart(motion: Motion<'_>, options: &Options) -> f64 {
    let weights = [1.0, -0.4, 0.7, 0.2];
    let (found, steps) = backwards(motion, options, &weights, adjoint_segments);
    assert!(found.states as f64 <= (2.0 * steps as f64).sqrt() + 2.0, "{} states for {steps} steps", found.states);
    let truth = forwards(motion, options, &weights);
    let size = truth.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
    let found = found.state.iter().chain(&found.parameters);
    found.zip(&truth).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / size
}

const METHODS: [Method; 4] = [Method::Rk4, Method::Ode45, Method::Dopri5, Method::Dop853];

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// Rounding of some hundred steps.
    #[test]
    fn a_sweep_is_the_transpose_of_slopes_carried_forwards(
        a in prop::array::uniform16(-1.5..1.5_f64),
        p in prop::array::uniform3(0.4..1.6_f64),
        y0 in prop::array::uniform4(-1.0..1.0_f64),
    ) {
        for method in METHODS {
            let problem = Problem::Free(a);
            let off = apart(Motion { problem, p: &p, y0: &y0 }, &options(problem, &p, method, 1e-7));
            prop_assert!(off < 1e-12, "{:?}: {:e}", method, off);
        }
    }

    /// At the instant p₂ the force jumps, and how that moves counts; equal steps go across, and do not.
    #[test]
    fn so_it_is_across_jumps_that_move_and_bends(
        a in prop::array::uniform16(-1.0..1.0_f64),
        at in 0.8..1.8_f64,
        y0 in prop::array::uniform4(-1.0..1.0_f64),
    ) {
        for method in &METHODS[1..] {
            let (problem, p) = (Problem::Driven(a), [0.9, 0.5, at]);
            let off = apart(Motion { problem, p: &p, y0: &y0 }, &options(problem, &p, *method, 1e-7));
            prop_assert!(off < 1e-12, "{:?}: {:e}", method, off);
        }
    }

    /// Loose tolerances, so that each step is moved back onto the constraints by much.
    #[test]
    fn so_it_is_where_steps_are_moved_onto_constraints(
        angle in -3.0..3.0_f64,
        rate in -2.0..2.0_f64,
        p in prop::array::uniform3(0.5..1.5_f64),
    ) {
        for problem in [Problem::Circle, Problem::Weighted] {
            for method in METHODS {
                let (s, c) = angle.sin_cos();
                let y0 = [p[0] * c, p[0] * s, -p[0] * s * rate, p[0] * c * rate];
                let off = apart(Motion { problem, p: &p, y0: &y0 }, &options(problem, &p, method, 1e-4));
                prop_assert!(off < 1e-11, "{:?}: {:e}", method, off);
            }
        }
    }
}

/// y″ = −ω² y from y₀, y′₀: all derivatives in closed form, in both directions of time.
#[test]
fn an_oscillator_has_the_gradient_of_its_closed_form() {
    struct Spring(f64);
    impl RightHandSide<f64> for Spring {
        fn rhs(&mut self, _t: f64, y: &[f64], out: &mut [f64]) -> Result<(), Failure> {
            out.copy_from_slice(&[y[1], -self.0 * self.0 * y[0]]);
            Ok(())
        }
    }
    impl TransposedRightHandSide for Spring {
        fn parameter_count(&self) -> usize {
            1
        }
        fn add_transposed_product(
            &mut self,
            _t: f64,
            y: &[f64],
            w: &[f64],
            to: ProductSums<'_>,
        ) -> Result<(), Failure> {
            to.0[0] -= self.0 * self.0 * w[1];
            to.0[1] += w[0];
            to.1[0] -= 2.0 * self.0 * y[0] * w[1];
            Ok(())
        }
    }
    let (w, y0) = (1.7_f64, [0.6, -0.3]);
    for t in [3.0, -3.0] {
        let options = Options {
            method: Method::Dop853,
            output: OutputOption::Steps { refine: 1 },
            ..Options::tolerances(1e-13, 1e-13)
        };
        let run = integrate(LentRightHandSide(&mut Spring(w)), (0.0, t), &y0, &options, &mut []).unwrap();
        let ends = &run.t[1..];
        let course = RecordedSteps { span: (0.0, t), y0: &y0, ends, options: &options, moved: &[] };
        let adjoint = Adjoint::new(course, &mut Spring(w), &adjoint_segments(ends.len())).unwrap();
        let found = adjoint.gradient(&mut Spring(w), &[1.0, 0.0]).unwrap();
        let (s, c) = (w * t).sin_cos();
        // y = y₀ cos ωt + y′₀/ω sin ωt
        let by_w = -y0[0] * t * s + y0[1] * (t * c / w - s / (w * w));
        for (found, truth) in found.state.iter().chain(&found.parameters).zip([c, s / w, by_w]) {
            assert!((found - truth).abs() < 1e-11, "{found} {truth}");
        }
    }
}

#[test]
fn how_many_states_are_kept_changes_no_bit() {
    let p = [0.9, 0.5, 1.3];
    for problem in [
        Problem::Driven([0.3, -0.8, 0.5, 0.1, 0.9, 0.2, -0.4, 0.7, 0.0, 1.0, -0.6, 0.2, 0.5, 0.5, -0.1, -0.9]),
        Problem::Circle,
    ] {
        let y0 = if problem.has_constraints() { [0.9, 0.0, 0.0, 1.2] } else { [0.4, -0.2, 0.9, 0.1] };
        let options = options(problem, &p, Method::Dopri5, 1e-11);
        let by = |parts: &dyn Fn(usize) -> Vec<usize>| {
            backwards(Motion { problem, p: &p, y0: &y0 }, &options, &[0.2, 1.0, -1.0, 0.6], parts)
        };
        let (few, steps) = by(&adjoint_segments);
        let (all, _) = by(&|steps| vec![1; steps]);
        let (one, _) = by(&|steps| vec![steps]);
        let (odd, _) = by(&|steps| vec![7, 0, 3, steps - 10]);
        assert!(steps > 30 && all.states == steps && one.states == steps && few.states < steps / 2, "{steps} {few:?}");
        for other in [&all, &one, &odd] {
            assert_eq!((&few.state, &few.parameters), (&other.state, &other.parameters));
        }
    }
}

/// √(2 N) but for the last segment, which may be cut short.
#[test]
fn segments_add_up_and_get_shorter_by_one() {
    for steps in 0..2000 {
        let list = adjoint_segments(steps);
        assert_eq!(list.iter().sum::<usize>(), steps);
        assert!(list.windows(2).all(|pair| pair[1] < pair[0]));
        let most = list.iter().enumerate().map(|(at, length)| at + length).max().unwrap_or(0);
        assert!(most as f64 <= (2.0 * steps as f64).sqrt() + 1.0, "{steps}: {most}");
    }
}

#[test]
fn what_cannot_be_swept_is_refused() {
    let (p, y0) = ([1.0, 1.0, 1.0], [1.0, 0.0, 0.0, 0.5]);
    let mut rhs = At { problem: Problem::Circle, p: p.to_vec() };
    let refused = |method: Method, segments: &[usize], rhs: &mut At<f64>| {
        let options = Options { method, ..Options::tolerances(1e-6, 1e-6) };
        let course = RecordedSteps { span: SPAN, y0: &y0, ends: &[1.0, 2.0], options: &options, moved: &[] };
        Adjoint::new(course, rhs, segments).map(|_| ())
    };
    assert_eq!(refused(Method::Radau5, &[2], &mut rhs), Err(AdjointError::Method(Method::Radau5)));
    assert_eq!(refused(Method::Dop853, &[3], &mut rhs), Err(AdjointError::Segments));
    assert_eq!(refused(Method::Dop853, &[1, 1], &mut rhs), Ok(()));
    assert!(Method::ALL.iter().all(|method| has_adjoint(*method) == METHODS.contains(method)));
}
