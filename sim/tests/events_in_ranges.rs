//! Events that bring ranges: none is missed, and none is counted twice.
//!
//! The state is a clock x = ±t and its square, which every method integrates to rounding, so that all zeros of
//! functions of x are known.
#![allow(clippy::float_cmp, reason = "exact answers are compared exactly")]

use tripos_sim::Kind::{AtStart, Falling, Pole, Rising, Touch, Undecided};
use tripos_sim::{
    Direction, Effect, Event, Failure, Kind, Method, Options, OutputOption, RightHandSide, Solution, Stop, Warning,
    integrate,
};
use tripos_traits::Scalar;

/// A function of the clock and of its square, for numbers and for ranges.
trait Function {
    fn at<S: Scalar>(&self, x: S, square: S) -> S;
}

fn watch(function: &impl Function, effect: Effect) -> Event<'_> {
    let event = Event::recorded("zero", Direction::Either, |_, y: &[f64]| function.at(y[0], y[1]));
    Event { effect, ..event.with_ranges(|_, y| function.at(y[0], y[1])) }
}

/// x' = way, s' = 2 way x.
struct Clock {
    way: f64,
}

impl RightHandSide for Clock {
    fn rhs(&mut self, _t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
        (dydt[0], dydt[1]) = (self.way, 2.0 * self.way * y[0]);
        Ok(())
    }

    fn jacobian(&mut self, _t: f64, _y: &[f64], out: &mut [f64]) -> Option<Result<(), Failure>> {
        out.copy_from_slice(&[0.0, 0.0, 2.0 * self.way, 0.0]);
        Some(Ok(()))
    }

    fn taylor(&mut self, _t: f64, _order: usize, x: &mut [f64]) -> Option<Result<(), Failure>> {
        (x[2], x[3]) = (self.way, 2.0 * self.way * x[0]);
        x[4..].fill(0.0);
        x[5] = 1.0;
        Some(Ok(()))
    }
}

/// Equal steps of length `step` from 0 to `way` · `span`, s; `way` is 1 or −1.
#[derive(Clone, Copy)]
struct Steps {
    span: f64,
    step: f64,
    way: f64,
}

/// The clock from 0 to `span` in equal steps.
fn run(event: Event<'_>, steps: Steps, method: Method) -> Solution {
    let Steps { span, step, way } = steps;
    let options = Options { method, step: Some(step), output: OutputOption::Ends, ..Options::default() };
    integrate(Clock { way }, (0.0, way * span), &[0.0, 0.0], &options, &mut [event]).unwrap()
}

fn seen(solution: &Solution) -> Vec<(Kind, f64)> {
    solution.events.iter().map(|e| (e.kind, e.y[0])).collect()
}

fn kinds(solution: &Solution) -> Vec<Kind> {
    solution.events.iter().map(|e| e.kind).collect()
}

/// One step from 0 to 1 by a method of each degree of dense output, and both ways.
fn in_one_step(function: &impl Function, effect: Effect) -> Vec<Solution> {
    let methods = [Method::Rk4, Method::Ode45, Method::Dop853, Method::Gauss6, Method::Radau5, Method::Taylor];
    let runs = methods.into_iter().flat_map(|method| [1.0, -1.0].map(|way| (method, way)));
    runs.map(|(method, way)| run(watch(function, effect), Steps { span: 1.0, step: 1.0, way }, method)).collect()
}

fn number<S: Scalar>(x: f64) -> S {
    S::from_f64(x)
}

/// Factor of an event function.
#[derive(Clone, Copy, Debug)]
enum Factor {
    /// Line x − a
    Line(f64),
    /// x³ − (a + b + c) x² + (a b + b c + c a) x − a b c, as it stands
    Cubic([f64; 3]),
    /// sin(k (x − a))
    Wave { k: f64, a: f64 },
    /// exp(−(w (x − a))²) − exp(−¼): zeros ½/w to both sides of a
    Gate { w: f64, a: f64 },
    /// √(x + 3) − √(a + 3)
    Root(f64),
    /// |x − a| − d
    Fold { a: f64, d: f64 },
    /// The square of the clock, by the clock and by the state, in turn: x² (1 + s)/(1 + x²) − a²
    Square(f64),
    /// 1.5 + sin(20 x) exp(−x), positive
    Positive,
}

impl Factor {
    fn at<S: Scalar>(self, x: S, square: S) -> S {
        let one: S = S::int(1);
        match self {
            Self::Line(a) => x - number(a),
            Self::Cubic([a, b, c]) => {
                let sum = x.powi(3) - number::<S>(a + b + c) * x.powi(2);
                sum + number::<S>(a * b + b * c + c * a) * x - number(a * b * c)
            }
            Self::Wave { k, a } => (number::<S>(k) * (x - number(a))).sin_cos().0,
            Self::Gate { w, a } => (-(number::<S>(w) * (x - number(a))).powi(2)).exp() - number::<S>(-0.25).exp(),
            Self::Root(a) => (x + S::int(3)).sqrt() - number::<S>(a + 3.0).sqrt(),
            Self::Fold { a, d } => (x - number(a)).abs() - number(d),
            Self::Square(a) => x.powi(2) * (one + square) / (one + x.powi(2)) - number(a * a),
            Self::Positive => number::<S>(1.5) + (S::int(20) * x).sin_cos().0 * (-x).exp(),
        }
    }

    /// Its zeros from 0 to 1.
    fn zeros(self) -> Vec<f64> {
        let all = match self {
            Self::Line(a) | Self::Root(a) | Self::Square(a) => vec![a],
            Self::Cubic(zeros) => zeros.to_vec(),
            Self::Wave { k, a } => {
                let period = std::f64::consts::PI / k;
                (-1000..1000).map(|n| a + f64::from(n) * period).filter(|x| (0.0..1.0).contains(x)).collect()
            }
            Self::Gate { w, a } => vec![a - 0.5 / w, a + 0.5 / w],
            Self::Fold { a, d } => vec![a - d, a + d],
            Self::Positive => vec![],
        };
        all.into_iter().filter(|x| (0.0..1.0).contains(x)).collect()
    }
}

impl Function for Vec<Factor> {
    fn at<S: Scalar>(&self, x: S, square: S) -> S {
        self.iter().fold(S::int(1), |product, factor| product * factor.at(x, square))
    }
}

/// A generator of numbers in [0, 1): the same ones on every machine (Knuth's MMIX constants).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// One of 0 to `count` − 1.
    fn below(&mut self, count: u64) -> u64 {
        self.next();
        (self.0 >> 33) % count
    }

    /// Between these, all sizes alike.
    fn size(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.next())
    }

    fn factor(&mut self) -> Factor {
        let a = self.next();
        match self.below(8) {
            0 => Factor::Line(a),
            1 => Factor::Cubic([a, self.next(), self.next()]),
            2 => Factor::Wave { k: self.size(1.0, 200.0), a },
            3 => Factor::Gate { w: self.size(1.0, 1e4), a },
            4 => Factor::Root(a),
            5 => Factor::Fold { a, d: self.size(1e-5, 0.3) },
            6 => Factor::Square(a),
            _ => Factor::Positive,
        }
    }

    /// A product of one to three factors whose zeros are `apart`, and those zeros in order.
    fn function(&mut self, apart: f64) -> (Vec<Factor>, Vec<f64>) {
        loop {
            let count = 1 + self.below(3);
            let factors: Vec<Factor> = (0..count).map(|_| self.factor()).collect();
            let mut zeros: Vec<f64> = factors.iter().flat_map(|factor| factor.zeros()).collect();
            zeros.sort_by(f64::total_cmp);
            let edges = [&[0.0][..], &zeros, &[1.0]].concat();
            if edges.windows(2).all(|pair| pair[1] - pair[0] > apart) {
                return (factors, zeros);
            }
        }
    }
}

/// Goal: every crossing found, each once, in order, of the right direction, at its place. Method: 1 000 functions drawn
/// at random whose zeros are at least 1e-6 apart, by every method, in one step to fifty, both ways in time. Tolerance:
/// 1e-7; what cubics and products of three cancel near close zeros is 1e-16 by their slope there.
#[test]
fn every_zero_of_random_functions_is_found_once() {
    let mut numbers = Numbers(7);
    let mut total = 0;
    for trial in 0..1000 {
        let (factors, zeros) = numbers.function(1e-6);
        let method = Method::ALL[trial % Method::ALL.len()];
        let way = if trial % 2 == 0 { 1.0 } else { -1.0 };
        let step = numbers.size(0.02, 1.0);
        let solution = run(watch(&factors, Effect::Record), Steps { span: 1.0, step, way }, method);
        let found = seen(&solution);
        let what = format!("{trial} {} {step} {factors:?}: {found:?} {zeros:?}", method.name());
        assert_eq!(found.len(), zeros.len(), "{what}");
        for ((kind, x), zero) in found.iter().zip(&zeros) {
            let after = factors.at(zero + 5e-7, (zero + 5e-7).powi(2));
            assert_eq!(*kind, if after > 0.0 { Rising } else { Falling }, "{what}");
            assert!((x - zero).abs() < 1e-7, "{what}");
        }
        total += zeros.len();
    }
    assert!(total > 3000, "{total}");
}

/// Goal: both crossings of a pair within a step, down to 1e-11 of it. Method: a fold, whose branches have slope 1, so
/// that rounding of 1e-16 does not hide a pair that is further apart.
#[test]
fn both_crossings_of_a_close_pair_are_found() {
    for d in [0.1, 1e-3, 1e-6, 5e-9, 1e-11] {
        for a in [0.123_456, 0.5, 0.77] {
            for solution in in_one_step(&vec![Factor::Fold { a, d }], Effect::Record) {
                assert_eq!(kinds(&solution), [Falling, Rising], "{a} {d}: {:?}", seen(&solution));
                for (event, zero) in solution.events.iter().zip([a - d, a + d]) {
                    assert!((event.y[0] - zero).abs() < 4e-15, "{a} {d}: {:?}", seen(&solution));
                }
            }
        }
    }
}

/// The product (x − a) (x − b) of zeros 1e-8 apart stays within 2.5e-17 of zero between them: that is a touch.
#[test]
fn a_pair_that_rounding_hides_is_a_touch_or_found() {
    for a in [0.2, 0.5, 0.7] {
        for gap in [1e-8, 3e-8, 1e-7] {
            for solution in in_one_step(&vec![Factor::Line(a), Factor::Line(a + gap)], Effect::Terminal) {
                let kinds = kinds(&solution);
                assert!(kinds == [Touch] || kinds == [Falling], "{a} {gap}: {kinds:?}");
                assert_eq!(solution.stop == Stop::End, kinds == [Touch]);
                assert!((solution.events[0].y[0] - a).abs() < 2.0 * gap + 1e-7);
            }
        }
    }
}

#[test]
fn touches_are_recorded_once_and_end_nothing() {
    for a in [0.1, 0.5, 0.501, 0.875] {
        for factors in [
            vec![Factor::Line(a), Factor::Line(a)],
            vec![Factor::Fold { a, d: 0.0 }],
            vec![Factor::Fold { a, d: 0.0 }, Factor::Positive],
            vec![Factor::Wave { k: 3.0, a }, Factor::Wave { k: 3.0, a }],
        ] {
            for solution in in_one_step(&factors, Effect::Terminal) {
                assert_eq!((kinds(&solution), solution.stop.clone()), (vec![Touch], Stop::End), "{factors:?}");
                assert!((solution.events[0].y[0] - a).abs() < 1e-7);
            }
            for way in [1.0, -1.0] {
                let solution =
                    run(watch(&factors, Effect::Record), Steps { span: 1.0, step: 0.125, way }, Method::Dopri5);
                assert_eq!(kinds(&solution), [Touch], "{factors:?} {:?}", seen(&solution));
            }
        }
    }
}

#[test]
fn passing_close_by_is_nothing() {
    for d in [-1e-3, -1e-9, -1e-13] {
        for solution in in_one_step(&vec![Factor::Fold { a: 0.43, d }], Effect::Record) {
            assert_eq!(kinds(&solution), [], "{d}");
        }
    }
}

/// sin kx/cos kx, or 1/(x − a)², less 5.
struct Fraction {
    k: f64,
    even: bool,
}

impl Function for Fraction {
    fn at<S: Scalar>(&self, x: S, _square: S) -> S {
        let (sin, cos) = (number::<S>(self.k) * x).sin_cos();
        if self.even { number::<S>(1.0) / cos.powi(2) - S::int(5) } else { sin / cos }
    }
}

/// tan 20x has zeros at multiples of π/20 and poles halfway; 1/cos² 20x − 5 crosses zero twice around each pole.
#[test]
fn a_pole_is_no_crossing() {
    let quarter = std::f64::consts::PI / 40.0;
    let places = |remainder: u32| (1..=12).filter(move |n| n % 2 == remainder).map(|n| f64::from(n) * quarter);
    for solution in in_one_step(&Fraction { k: 20.0, even: false }, Effect::Terminal) {
        assert_eq!(kinds(&solution), [AtStart, Pole, Rising]);
    }
    for solution in in_one_step(&Fraction { k: 20.0, even: false }, Effect::Record) {
        let times = |wanted: Kind| seen(&solution).into_iter().filter(move |(kind, _)| *kind == wanted).map(|(_, x)| x);
        for (kind, wanted) in [(Rising, places(0).collect::<Vec<_>>()), (Pole, places(1).collect())] {
            let found: Vec<f64> = times(kind).collect();
            assert_eq!(found.len(), wanted.len(), "{kind:?} {:?}", seen(&solution));
            assert!(found.iter().zip(&wanted).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} {wanted:?}");
        }
    }
    for solution in in_one_step(&Fraction { k: 20.0, even: true }, Effect::Record) {
        // The seventh pole lies beyond the end, at x = 1.02.
        let crossings = [[Rising, Falling].repeat(6), vec![Rising]].concat();
        assert_eq!(kinds(&solution), crossings, "{:?}", seen(&solution));
    }
}

/// 1/(0.3 − x) leaves the domain through infinity; 1/(x − 0.3) comes into it, which ends nothing.
struct Inverse(f64);

impl Function for Inverse {
    fn at<S: Scalar>(&self, x: S, _square: S) -> S {
        number::<S>(self.0) / (number::<S>(0.3) - x)
    }
}

#[test]
fn a_domain_that_is_left_through_a_pole_ends_the_run() {
    for solution in in_one_step(&Inverse(1.0), Effect::Domain) {
        assert_eq!(solution.stop, Stop::LeftDomain { name: "zero".into() });
        assert_eq!(kinds(&solution), [Pole]);
        assert!(solution.events[0].terminal && (solution.y_end[0] - 0.3).abs() < 1e-15, "{solution}");
    }
    for solution in in_one_step(&Inverse(1.0), Effect::Terminal) {
        assert_eq!((kinds(&solution), solution.stop), (vec![Pole], Stop::End));
    }
}

/// sin(c x² + ½)
struct Chirp(f64);

impl Function for Chirp {
    fn at<S: Scalar>(&self, x: S, _square: S) -> S {
        (number::<S>(self.0) * x.powi(2) + number(0.5)).sin_cos().0
    }
}

/// sin² φ + cos² φ − 1 + 1e-6 with φ = 1e6 x²: positive, which no range shows that holds more than 1e-12 of the step.
struct Hidden;

impl Function for Hidden {
    fn at<S: Scalar>(&self, x: S, _square: S) -> S {
        let (sin, cos) = (number::<S>(1e6) * x.powi(2)).sin_cos();
        sin.powi(2) + cos.powi(2) - number(1.0 - 1e-6)
    }
}

/// A search beyond the work allowed is undecided once a step, and ends nothing. The run warns if it might have ended.
#[test]
fn more_than_ranges_can_tell_is_undecided() {
    for (effect, warnings) in [(Effect::Record, 0), (Effect::Terminal, 1), (Effect::Domain, 1)] {
        for step in [1.0, 0.25] {
            let solution = run(watch(&Hidden, effect), Steps { span: 1.0, step, way: 1.0 }, Method::Dop853);
            let seen = kinds(&solution);
            assert!((1..=solution.steps).contains(&(seen.len() as u64)), "{seen:?}");
            assert!(seen.iter().all(|kind| *kind == Undecided) && solution.stop == Stop::End, "{seen:?}");
            let said = solution.warnings.iter().filter(|w| matches!(w, Warning::EventUndecided { .. }));
            assert_eq!(said.count(), warnings);
        }
    }
    // Of 318 309 zeros some thousand are found, and it is said that there may be more.
    let solution = run(watch(&Chirp(1e6), Effect::Record), Steps { span: 1.0, step: 1.0, way: 1.0 }, Method::Dop853);
    assert!(kinds(&solution).contains(&Undecided));
    // 300 x² + ½ passes 95 multiples of π.
    let solution = run(watch(&Chirp(300.0), Effect::Record), Steps { span: 1.0, step: 1.0, way: 1.0 }, Method::Rk4);
    assert_eq!(solution.events.len(), 95);
    assert!(!kinds(&solution).contains(&Undecided));
}

/// A conserved quantity less its start is rounding of either sign.
struct Nothing;

impl Function for Nothing {
    fn at<S: Scalar>(&self, x: S, square: S) -> S {
        square - x.powi(2)
    }
}

#[test]
fn rounding_around_zero_is_no_crossing() {
    for way in [1.0, -1.0] {
        for step in [1.0, 0.1] {
            let solution = run(watch(&Nothing, Effect::Terminal), Steps { span: 1.0, step, way }, Method::Dop853);
            assert_eq!((kinds(&solution), solution.stop), (vec![AtStart], Stop::End), "{step}");
        }
    }
}

#[test]
fn a_zero_at_the_start_or_at_the_end_of_a_step_is_met_once() {
    for way in [1.0, -1.0] {
        for step in [1.0, 0.5, 0.25, 0.125] {
            let factors = vec![Factor::Line(0.5)];
            let solution = run(watch(&factors, Effect::Terminal), Steps { span: 1.0, step, way }, Method::Ode45);
            assert_eq!(kinds(&solution), [Rising], "{step}");
            assert!((solution.y_end[0] - 0.5).abs() < 1e-15, "{step} {solution}");
            let factors = vec![Factor::Line(0.0), Factor::Line(0.6)];
            let solution = run(watch(&factors, Effect::Terminal), Steps { span: 1.0, step, way }, Method::Ode45);
            assert_eq!(kinds(&solution), [AtStart, Rising], "{step}");
            let factors = vec![Factor::Line(0.0)];
            let into = run(watch(&factors, Effect::Domain), Steps { span: 1.0, step, way }, Method::Ode45);
            assert_eq!((kinds(&into), into.stop), (vec![AtStart], Stop::End), "{step}");
            let factors = vec![Factor::Line(0.0), Factor::Line(1.5)];
            let out = run(watch(&factors, Effect::Domain), Steps { span: 1.0, step, way }, Method::Ode45);
            assert_eq!((out.stop.code().as_str(), out.t_end), ("domain:zero", 0.0), "{step}");
        }
    }
}

/// A square root without a value beyond 0.6 ends the run before it, unless another event comes first.
struct Beyond(f64);

impl Function for Beyond {
    fn at<S: Scalar>(&self, x: S, _square: S) -> S {
        (number::<S>(0.6) - x).sqrt() - number(self.0)
    }
}

#[test]
fn an_event_that_is_not_a_number_ends_the_run_before_it_unless_another_comes_first() {
    for way in [1.0, -1.0] {
        let solution = run(watch(&Beyond(-1.0), Effect::Record), Steps { span: 1.0, step: 0.25, way }, Method::Dop853);
        assert_eq!(solution.stop.code(), "event-not-a-number");
        assert!((solution.y_end[0] - 0.5).abs() < 1e-15, "{solution}");
        let solution =
            run(watch(&Beyond(0.1_f64.sqrt()), Effect::Terminal), Steps { span: 1.0, step: 1.0, way }, Method::Dop853);
        assert_eq!(solution.stop.code(), "event:zero");
        assert!((solution.y_end[0] - 0.5).abs() < 1e-15, "{solution}");
    }
}
