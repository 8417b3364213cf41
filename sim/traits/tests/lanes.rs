//! A lane computes the same as alone, to the bit: in any company, width and compilation.

use tripos_traits::{Lanes, Scalar};

/// Every operation of the trait on three numbers, mixed so that a wrong bit anywhere shows.
#[inline(always)]
#[expect(clippy::inline_always, reason = "so that it is compiled again for each kind of processor")]
fn everything<S: Scalar>(x: S, y: S, z: S) -> Vec<S> {
    let (s, c) = x.sin_cos();
    let size = y.abs();
    let part = z / (S::int(1) + z.abs());
    let list = [x + y, x - y, x * y, x / y, -x, s, c, s.mul_add(c, z), x.mul_add(y, z), z.mul_add(z, -s)];
    let functions = [size.sqrt(), part.asin(), part.acos(), z.atan(), part.exp(), size.ln()];
    let more = [part.sinh(), part.cosh(), z.tanh(), z.abs(), z.sign(), y.powi(3), y.powi(-2), S::ratio(2, 3), S::pi()];
    [&list[..], &functions[..], &more[..], &[S::from_f64(0.1), S::decimal("0.3")]].concat()
}

/// Numbers of all sizes, some without a finite value.
fn numbers() -> Vec<[f64; 3]> {
    let mut state = 0x2545_F491_4F6C_DD1D_u64;
    let mut unit = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / 9_007_199_254_740_992.0
    };
    let mut number = || (unit() - 0.5) * 10_f64.powf(12.0 * unit() - 5.0);
    let mut list: Vec<[f64; 3]> = (0..400).map(|_| [number(), number(), number()]).collect();
    let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, 1e9, -1e300, 5e-324];
    list.extend(odd.map(|x| [x, 1.5, x]));
    list.extend(odd.map(|x| [0.5, x, -x]));
    list
}

/// Bits, with every "not a number" the same: which one an operation gives is not defined.
fn bits(x: f64) -> u64 {
    if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() }
}

/// The results of one argument in each lane, as bits: `[argument][operation]`.
fn in_lanes<const N: usize>(arguments: &[[f64; 3]], dispatched: impl Fn(&mut dyn FnMut())) -> Vec<Vec<u64>> {
    let mut results = Vec::new();
    for group in arguments.chunks(N) {
        let lane = |l: usize, i: usize| group[l.min(group.len() - 1)][i];
        let [x, y, z] = std::array::from_fn(|i| Lanes::<N>(std::array::from_fn(|l| lane(l, i))));
        let mut list = Vec::new();
        dispatched(&mut || list = everything(x, y, z));
        results.extend((0..group.len()).map(|l| list.iter().map(|v| bits(v.0[l])).collect::<Vec<_>>()));
    }
    results
}

#[test]
fn a_lane_does_not_know_its_neighbours() {
    let arguments = numbers();
    let one = in_lanes::<1>(&arguments, |work| work());
    assert_eq!(one, in_lanes::<4>(&arguments, |work| work()), "four");
    assert_eq!(one, in_lanes::<8>(&arguments, |work| work()), "eight");
    let mut shifted = arguments.clone();
    shifted.rotate_left(3);
    let mut eight = in_lanes::<8>(&shifted, |work| work());
    eight.rotate_right(3);
    assert_eq!(one, eight, "in other company");
}

/// Goal: the instructions do not change the numbers. Method: the same text compiled for this processor's own.
#[test]
fn dispatch_gives_the_same_bits() {
    let results = |x: &[f64; 3]| {
        let [x, y, z] = x.map(|x| Lanes::<8>([x; 8]));
        let plain = everything(x, y, z);
        let dispatched = Lanes::<8>::dispatch(
            #[inline(always)]
            || everything(x, y, z),
        );
        let [x, y, z] = [x, y, z].map(|x| Lanes::<4>([x.0[0]; 4]));
        let four = Lanes::<4>::dispatch(
            #[inline(always)]
            || everything(x, y, z),
        );
        let of = |list: Vec<Lanes<8>>| list.iter().map(|v| bits(v.0[5])).collect::<Vec<_>>();
        (of(plain), of(dispatched), four.iter().map(|v| bits(v.0[2])).collect::<Vec<_>>())
    };
    for x in numbers() {
        let (plain, dispatched, four) = results(&x);
        assert_eq!(plain, dispatched, "{x:?}");
        assert_eq!(plain, four, "{x:?}");
    }
}

/// 1 + 2⁻⁵² squared less 1 keeps the digits that a product rounded by itself loses.
#[test]
fn a_fused_product_is_rounded_once() {
    let x = 1.0 + f64::EPSILON;
    let got = Lanes([x; 4]).mul_add(Lanes([x; 4]), Lanes([-(1.0 + 2.0 * f64::EPSILON); 4]));
    assert_eq!(got.0.map(f64::to_bits), [(f64::EPSILON * f64::EPSILON).to_bits(); 4]);
    let apart = Lanes([x; 4]) * Lanes([x; 4]) + Lanes([-(1.0 + 2.0 * f64::EPSILON); 4]);
    assert_eq!(apart.0.map(f64::to_bits), [0; 4]);
}

#[test]
fn operations_without_rounding_rules_of_their_own_are_those_of_doubles() {
    for [x, y, z] in numbers() {
        let lanes: Vec<u64> =
            everything(Lanes([x; 4]), Lanes([y; 4]), Lanes([z; 4])).iter().map(|v| bits(v.0[1])).collect();
        let doubles: Vec<u64> = everything(x, y, z).into_iter().map(bits).collect();
        // All but sine and cosine, and the three fused products after them.
        for (i, (a, b)) in lanes.iter().zip(&doubles).enumerate().filter(|(i, _)| !(5..10).contains(i)) {
            assert_eq!(a, b, "operation {i} of {x} {y} {z}");
        }
    }
}
