//! Slopes beside values.

use tripos_traits::{DoubleDouble, Dual, Real, Scalar, Tangent};

type Digits = DoubleDouble;

type BinaryFunction<S> = fn(S, S) -> S;

/// Every function of a [`Scalar`], of two numbers.
fn list<S: Scalar>() -> Vec<(&'static str, BinaryFunction<S>)> {
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

/// Goal: every function of a [`Scalar`] has its slope. Method: central differences with 32 digits at points of its
/// domain; functions of two numbers are differentiated along each.
#[test]
fn slopes_are_those_of_central_differences() {
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

/// Goal: several slopes at once are those of one, and the value has the bits of a double. Method: every function of a
/// [`Scalar`] along three directions, against the slopes with 32 digits.
#[test]
fn several_slopes_are_those_of_each_direction() {
    let duals = list::<Dual<Digits>>();
    for (((name, of), (_, double)), (_, dual)) in list::<Tangent<3>>().into_iter().zip(list::<f64>()).zip(duals) {
        for (x, y) in [(0.3, 0.7), (-0.4, 1.1), (0.9, 0.6)] {
            let (along_x, along_y) = ([1.0, 0.0, 0.6], [0.0, 1.0, -1.7]);
            let found = of(Tangent { value: x, slopes: along_x }, Tangent { value: y, slopes: along_y });
            assert_eq!(found.value.to_bits(), double(x, y).to_bits(), "{name} at {x}, {y}");
            for k in 0..3 {
                let wide = |value: f64, slope: f64| Dual { value: Digits::from(value), slope: Digits::from(slope) };
                let slope = dual(wide(x, along_x[k]), wide(y, along_y[k])).slope.to_f64();
                let off = (found.slopes[k] - slope).abs();
                assert!(off < 1e-14 * (1.0 + slope.abs()), "{name} at {x}, {y} along {k}: off by {off}");
            }
        }
    }
}
