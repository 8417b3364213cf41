//! Slopes beside values.

use tripos_traits::{DoubleDouble, Dual, Real, Scalar};

type Digits = DoubleDouble;

/// Goal: every function of a [`Scalar`] has its slope. Method: central differences with 32 digits at points of its domain;
/// what is computed of two numbers is differentiated along each.
#[test]
fn slopes_are_those_of_central_differences() {
    type Of<S> = fn(S, S) -> S;
    fn list<S: Scalar>() -> Vec<(&'static str, Of<S>)> {
        vec![
            ("+", |x, y| x + y),
            ("-", |x, y| x - y),
            ("*", |x, y| x * y),
            ("/", |x, y| x / y),
            ("neg", |x, y| -x * y),
            ("mul_add", |x, y| x.mul_add(y, x * x)),
            ("mul_add last", |x, y| y.mul_add(y, x)),
            ("sin", |x, y| (x * y).sin_cos().0),
            ("cos", |x, y| (x * y).sin_cos().1),
            ("sinc", |x, y| (x * y).sinc()),
            ("sqrt", |x, y| (x * x + y).sqrt()),
            ("asin", |x, y| (x / (y + y)).asin()),
            ("acos", |x, y| (x / (y + y)).acos()),
            ("atan", |x, y| (x * y).atan()),
            ("exp", |x, y| (x * y).exp()),
            ("ln", |x, y| (x * x + y).ln()),
            ("sinh", |x, y| (x * y).sinh()),
            ("cosh", |x, y| (x * y).cosh()),
            ("tanh", |x, y| (x * y).tanh()),
            ("abs", |x, y| (x * y).abs() * x),
            ("sign", |x, y| x.sign() * y),
            ("powi", |x, y| (x * y).powi(-3)),
            ("ratio", |x, y| x * S::ratio(3, 7) + S::decimal("0.25") * y * S::pi()),
        ]
    }
    for ((name, of), (_, dual)) in list::<Digits>().into_iter().zip(list::<Dual<Digits>>()) {
        for (x, y) in [(0.3, 0.7), (-0.4, 1.1), (0.9, 0.6)] {
            let [x, y] = [x, y].map(Digits::from_f64);
            for (along_x, along_y) in [(1.0, 0.0), (0.0, 1.0), (0.6, -1.7)] {
                let [dx, dy] = [along_x, along_y].map(Digits::from_f64);
                let found = dual(Dual { value: x, slope: dx }, Dual { value: y, slope: dy });
                let step = Digits::from_f64(1e-8);
                let (up, down) = (of(x + dx * step, y + dy * step), of(x - dx * step, y - dy * step));
                let slope = (up - down) / (step + step);
                let off = (found.slope - slope).abs().to_f64();
                assert!(off < 1e-13 * (1.0 + slope.abs().to_f64()), "{name} at {x:?}, {y:?}: off by {off}");
                assert!((found.value - of(x, y)).abs().to_f64() < 1e-28, "{name}: the value is the function's");
            }
        }
    }
}

/// Goal: what stands for a removable singularity has its slope there. Method: sin x/x at 0.
#[test]
fn the_slope_of_sinc_at_zero_is_zero() {
    let found = Dual { value: 0.0, slope: 1.0 }.sinc();
    assert_eq!(found, Dual { value: 1.0, slope: 0.0 });
}
