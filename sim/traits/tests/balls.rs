//! Balls against an arbitrary-precision library: every number of the operands gives a number of the result.

use crate::random::Random;
use astro_float_num::{BigFloat, Consts, RoundingMode};
use tripos_traits::{Ball, Centre, DoubleDouble, Scalar};

const BITS: usize = 320;
const NEAREST: RoundingMode = RoundingMode::ToEven;
/// Number of balls that each function is tried with.
const COUNT: usize = 1_000;

fn exactly(x: DoubleDouble) -> BigFloat {
    BigFloat::from_f64(x.hi(), BITS).add(&BigFloat::from_f64(x.lo(), BITS), BITS, NEAREST)
}

/// True if the exact number is in the ball. The oracle's own rounding, 2⁻³²⁰, is allowed for.
fn has<C: Centre>(ball: Ball<C>, number: &BigFloat) -> bool {
    let distance = number.sub(&exactly(ball.centre.widen()), BITS, NEAREST).abs();
    let slack = number.abs().mul(&BigFloat::from_f64(1e-90, BITS), BITS, NEAREST);
    ball.is_defined() && distance.sub(&slack, BITS, NEAREST) <= BigFloat::from_f64(ball.radius, BITS)
}

/// Random ball with a relative radius of 0, or between 1e-30 and 0.1, and a number in it, often at its edge.
fn drawn<C: Centre>(random: &mut Random, low: f64, high: f64) -> (Ball<C>, BigFloat) {
    let middle = low + (high - low) * random.unit();
    let wide = DoubleDouble::sum(middle, middle * (random.unit() - 0.5) * f64::EPSILON);
    let (centre, _) = C::narrow(wide);
    let radius = if random.unit() < 0.3 { 0.0 } else { random.of_size(-30.0, -1.0).abs() * middle.abs() };
    // The ball must stay in the domain of the function.
    let room = (middle - low).min(high - middle).max(0.0) * 0.99;
    let radius = radius.min(room);
    let edge = random.unit();
    let part = if edge < 0.3 {
        -1.0
    } else if edge < 0.6 {
        1.0
    } else {
        2.0 * random.unit() - 1.0
    };
    let offset = BigFloat::from_f64(part, BITS).mul(&BigFloat::from_f64(radius, BITS), BITS, NEAREST);
    (Ball::around(centre, radius), exactly(centre.widen()).add(&offset, BITS, NEAREST))
}

type Function<C> = (&'static str, fn(Ball<C>) -> Ball<C>, fn(&BigFloat, &mut Consts) -> BigFloat, f64, f64);

/// Functions with the ends of the range of their arguments.
fn functions<C: Centre>() -> [Function<C>; 15] {
    [
        ("sin", |x| x.sin_cos().0, |x, c| x.sin(BITS, NEAREST, c), -30.0, 30.0),
        ("cos", |x| x.sin_cos().1, |x, c| x.cos(BITS, NEAREST, c), -30.0, 30.0),
        ("sin near π", |x| x.sin_cos().0, |x, c| x.sin(BITS, NEAREST, c), 3.13, 3.15),
        ("sqrt", Scalar::sqrt, |x, _| x.sqrt(BITS, NEAREST), 0.0, 50.0),
        ("exp", Scalar::exp, |x, c| x.exp(BITS, NEAREST, c), -40.0, 40.0),
        ("exp near 0", Scalar::exp, |x, c| x.exp(BITS, NEAREST, c), -1.0, 1.0),
        ("ln", Scalar::ln, |x, c| x.ln(BITS, NEAREST, c), 1e-3, 50.0),
        ("asin", Scalar::asin, |x, c| x.asin(BITS, NEAREST, c), -0.999, 0.999),
        ("acos", Scalar::acos, |x, c| x.acos(BITS, NEAREST, c), -0.999, 0.999),
        ("atan", Scalar::atan, |x, c| x.atan(BITS, NEAREST, c), -40.0, 40.0),
        ("sinh", Scalar::sinh, |x, c| x.sinh(BITS, NEAREST, c), -10.0, 10.0),
        ("cosh", Scalar::cosh, |x, c| x.cosh(BITS, NEAREST, c), -10.0, 10.0),
        ("tanh", Scalar::tanh, |x, c| x.tanh(BITS, NEAREST, c), -10.0, 10.0),
        ("abs", Scalar::abs, |x, _| x.abs(), -1.0, 1.0),
        ("cube", |x| x.powi(3), |x, _| x.mul(&x.mul(x, BITS, NEAREST), BITS, NEAREST), -5.0, 5.0),
    ]
}

/// Goal: no function loses a number. Method: numbers inside and at the edges of random balls, in both kinds of centres.
fn functions_contain_their_values<C: Centre>() {
    let mut constants = Consts::new().expect("memory for constants");
    for (name, ours, oracle, low, high) in functions::<C>() {
        let mut random = Random(0x9E37_79B9_7F4A_7C15);
        let mut widest: f64 = 0.0;
        for _ in 0..COUNT {
            let (ball, member) = drawn::<C>(&mut random, low, high);
            let (result, truth) = (ours(ball), oracle(&member, &mut constants));
            assert!(has(result, &truth), "{name} of {ball:?} is {result:?}, and the truth is {truth}");
            if ball.radius == 0.0 {
                widest = widest.max(result.radius / result.centre.bound().max(1.0));
            }
        }
        assert!(widest < 2000.0 * C::ROUNDING, "{name} of a point has the relative radius {widest}");
    }
}

#[test]
fn functions_of_wide_balls_contain_their_values() {
    functions_contain_their_values::<DoubleDouble>();
}

#[test]
fn functions_of_narrow_balls_contain_their_values() {
    functions_contain_their_values::<f64>();
}

/// Goal: no operation loses a number, also where numbers cancel. Method: as above, with two operands, and with sums of
/// products.
fn operations_contain_their_results<C: Centre>() {
    let mut random = Random(7);
    for at in 0..COUNT {
        let (x, a) = drawn::<C>(&mut random, -4.0, 4.0);
        let (mut y, mut b) = drawn::<C>(&mut random, 0.2, 4.0);
        if at % 3 == 0 {
            (y, b) = (y - x, b.sub(&a, BITS, NEAREST));
        }
        assert!(has(x + y, &a.add(&b, BITS, NEAREST)), "{x:?} + {y:?}");
        assert!(has(x - y, &a.sub(&b, BITS, NEAREST)), "{x:?} - {y:?}");
        assert!(has(x * y, &a.mul(&b, BITS, NEAREST)), "{x:?} * {y:?}");
        if y.least_size() > 0.0 {
            assert!(has(x / y, &a.div(&b, BITS, NEAREST)), "{x:?} / {y:?}");
        }
        let sum = Ball::sum_of_products([(x, y), (y, y), (x, -x)].into_iter());
        let products = [a.mul(&b, BITS, NEAREST), b.mul(&b, BITS, NEAREST), a.mul(&a, BITS, NEAREST).neg()];
        let truth = products.iter().fold(BigFloat::from_f64(0.0, BITS), |sum, x| sum.add(x, BITS, NEAREST));
        assert!(has(sum, &truth), "sum of products of {x:?} and {y:?} is {sum:?}");
        assert!(x.low() <= x.centre.to_f64() && x.high() >= x.centre.to_f64());
    }
}

#[test]
fn operations_on_wide_balls_contain_their_results() {
    operations_contain_their_results::<DoubleDouble>();
}

#[test]
fn operations_on_narrow_balls_contain_their_results() {
    operations_contain_their_results::<f64>();
}

#[test]
fn what_may_not_exist_is_undefined_and_stays_so() {
    let sign = Ball::<f64>::between(-1.0, 2.0);
    let one = Ball::int(1);
    for ball in [one / sign, sign.sqrt(), sign.ln(), (sign + one).asin(), Ball::int(800).exp()] {
        assert!(!ball.is_defined(), "{ball:?}");
        assert!(!(ball * Ball::int(0)).is_defined() && !(ball + one).is_defined() && !ball.sin_cos().0.is_defined());
        assert!(!Ball::sum_of_products([(ball, Ball::int(0)), (one, one)].into_iter()).is_defined());
        assert!(!one.hull(ball).is_defined() && !one.contains(ball) && ball.high() == f64::INFINITY);
    }
    assert!(
        sign.sign().low() <= -1.0 && sign.sign().high() >= 1.0 && sign.abs().low() <= 0.0 && sign.abs().high() >= 2.0
    );
    let (sine, cosine) = Ball::<f64>::between(0.0, 10.0).sin_cos();
    assert!(sine.high() >= 1.0 && cosine.low() <= -1.0);
}

/// Goal: decimals and fractions are enclosed. Method: ten times a tenth contains one.
#[test]
fn decimals_are_enclosed() {
    for tenth in [Ball::<DoubleDouble>::decimal("0.1"), Ball::ratio(1, 10)] {
        let sum = (0..9).fold(tenth, |sum, _| sum + tenth);
        assert!(sum.contains(Ball::int(1)) && sum.radius < 1e-29, "{sum:?}");
    }
    assert!(Ball::<f64>::pi().low() < core::f64::consts::PI.next_up());
}
