//! Divided differences of random formulas.

use super::terms::{arena, divides, short_term};
use proptest::prelude::*;
use tripos_derive::algebra::term::calculus::Substitution;
use tripos_derive::algebra::term::divided_difference::divided_difference;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// Goal: nothing is lost by the rules. Method: (b − a) e[a, b] = e(b) − e(a) with sin z/z for each sinc, exactly.
    #[test]
    fn divided_differences_are_quotients_of_differences(term in short_term(), by_angle in any::<bool>()) {
        let arena = &mut arena();
        let e = term.build(arena);
        let [a, b] = ["a", "b"].map(|name| arena.symbol(name));
        let x = arena.symbol(if by_angle { "q" } else { "x" });
        let [low, high] = [a, b].map(|end| Substitution::new(&[(x, end)]).apply(arena, e));
        let divided = divided_difference(arena, e, x, a, b);
        let divided = divided.ok_or_else(|| TestCaseError::fail(format!("{} has rules", print_text(arena, e))))?;
        let sincs: Vec<_> = divided
            .sincs
            .iter()
            .map(|(symbol, z)| {
                let sine = arena.sin(*z);
                (*symbol, arena.div(sine, *z).expect("a and b differ"))
            })
            .collect();
        let value = Substitution::new(&sincs).apply(arena, divided.value);
        let width = arena.sub(b, a);
        let rise = arena.sub(high, low);
        let product = arena.mul(width, value);
        let rest = arena.sub(product, rise);
        prop_assert_eq!(zero_test(arena, rest), ZeroTest::Zero, "{} by {}", print_text(arena, e), print_text(arena, x));
        prop_assert_eq!(divides(arena, rise), divides(arena, value));
    }
}
