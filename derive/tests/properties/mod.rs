//! Laws of the algebra on random formulas.
//!
//! Every law is an identity that nobody wrote down before: two formulas that must mean the same, or must not.

mod divided;
mod rewrites;
mod slopes;
mod terms;

use proptest::prelude::*;
use rewrites::{rewritten, steps};
use slopes::slope;
use terms::{SYMBOLS, angle, arena, divided, divides, factor, short_term, sum_of, term, term_with_functions};
use tripos_derive::algebra::form::normal_form::{Normalizer, Zero};
use tripos_derive::algebra::form::sharing::{SharingOptions, share_common_parts};
use tripos_derive::algebra::form::simplify::{Simplifier, operation_count};
use tripos_derive::algebra::meaning::compare::{Comparer, Verdict};
use tripos_derive::algebra::term::calculus::{Differential, Substitution};
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Arena, Expr, Rational};

/// Fails, naming both sides, unless they mean the same.
fn equal(arena: &mut Arena, left: Expr, right: Expr) -> Result<(), TestCaseError> {
    let verdict = Comparer::default().compare(arena, left, right);
    prop_assert!(verdict.is_equal(), "{} = {}: {verdict:?}", print_text(arena, left), print_text(arena, right));
    Ok(())
}

fn derivative(arena: &mut Arena, e: Expr, by: &str) -> Expr {
    let by = arena.symbol(by);
    Differential::partial(by).apply(arena, e)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn sums_and_products_obey_the_laws_of_a_ring(a in factor(), b in factor(), c in factor()) {
        let arena = &mut arena();
        let [a, b, c] = [a, b, c].map(|t| t.build(arena));
        let (ab, ba) = (arena.add(a, b), arena.add(b, a));
        prop_assert_eq!(ab, ba);
        let (ab, ba) = (arena.mul(a, b), arena.mul(b, a));
        prop_assert_eq!(ab, ba);
        let sum = arena.add(b, c);
        let (left, ac) = (arena.mul(a, sum), arena.mul(a, c));
        let right = arena.add(ab, ac);
        equal(arena, left, right)?;
        let (plus, minus) = (arena.add(a, b), arena.sub(a, b));
        let (left, a2, b2) = (arena.mul(plus, minus), arena.square(a), arena.square(b));
        let right = arena.sub(a2, b2);
        equal(arena, left, right)?;
    }

    /// Goal: common parts are taken out of anything without changing it. Method: the values with what was taken out put
    /// back; sums of products of the same factors, so that there is much to take out.
    #[test]
    fn sharing_keeps_the_meaning(
        parts in prop::collection::vec(factor(), 3),
        picks in prop::collection::vec((0..3_usize, 0..3_usize, 0..3_usize, -3..4_i64), 6),
        reading in prop::sample::select(&SharingOptions::ALL[..]),
    ) {
        let arena = &mut arena();
        let parts: Vec<Expr> = parts.iter().map(|t| t.build(arena)).collect();
        let products: Vec<Expr> = picks
            .iter()
            .map(|(i, j, k, n)| {
                let number = arena.integer(*n);
                arena.product(&[number, parts[*i], parts[*j], parts[*k]])
            })
            .collect();
        let values: Vec<Expr> = products.chunks(2).map(|pair| arena.sum(pair)).chain([parts[0]]).collect();
        let Some(shared) = share_common_parts(arena, &mut Simplifier::default(), reading, &[], &values) else { return Ok(()) };
        let mut pairs: Vec<(Expr, Expr)> = Vec::new();
        for step in &shared.steps {
            let value = Substitution::new(&pairs).apply(arena, step.value);
            pairs.push((step.symbol, value));
        }
        let mut put = Substitution::new(&pairs);
        for (old, new) in values.iter().zip(&shared.values) {
            let new = put.apply(arena, *new);
            let difference = arena.sub(*old, new);
            prop_assert_ne!(zero_test(arena, difference), ZeroTest::NonZero, "{}", print_text(arena, *old));
        }
    }

    #[test]
    fn derivatives_obey_the_product_and_quotient_rules(a in factor(), b in factor()) {
        let arena = &mut arena();
        let [a, b] = [a, b].map(|t| t.build(arena));
        prop_assume!(divides(arena, b));
        let (da, db) = (derivative(arena, a, "q"), derivative(arena, b, "q"));
        let product = arena.mul(a, b);
        let left = derivative(arena, product, "q");
        let (first, second) = (arena.mul(da, b), arena.mul(a, db));
        let right = arena.add(first, second);
        equal(arena, left, right)?;
        let quotient = divided(arena, a, b);
        let left = derivative(arena, quotient, "q");
        let (above, below) = (arena.sub(first, second), arena.square(b));
        let right = divided(arena, above, below);
        equal(arena, left, right)?;
    }

    /// 1e-9 of the largest terms: some hundred operations, each with an error of 1e-16, divided by a hundredth at most.
    #[test]
    fn derivatives_are_slopes(
        f in term(),
        by in prop::sample::select(&SYMBOLS[..]),
        at in prop::collection::vec(-2.0..2.0_f64, 6),
    ) {
        let arena = &mut arena();
        let symbols: Vec<Expr> = arena.symbol_names().to_vec().iter().map(|name| arena.symbol(name)).collect();
        let value = |name: &str| at[symbols.iter().position(|s| arena.symbol_name(*s) == Some(name)).unwrap()];
        let Some(expected) = slope(&f, &value, by) else { return Ok(()) };
        let f = f.build(arena);
        let derivative = derivative(arena, f, by);
        let found = Tape::new(arena, &symbols, &[f, derivative]).unwrap().evaluate(&at);
        let shown = format!("{}: {found:?} {expected:?}", print_text(arena, f));
        let (of_value, of_rate) = (expected.sizes.0, expected.sizes.0.max(expected.sizes.1));
        prop_assert!((found[0] - expected.value).abs() <= 1e-9 * of_value, "{}", shown);
        prop_assert!((found[1] - expected.rate).abs() <= 1e-9 * of_rate, "{}", shown);
    }

    #[test]
    fn printed_formulas_parse_back_to_the_same_term(e in term_with_functions()) {
        let arena = &mut arena();
        let e = e.build(arena);
        let printed = print_text(arena, e);
        let parsed = parse_free(arena, &printed);
        prop_assert_eq!(parsed.map_err(|e| format!("{printed}: {e:?}")), Ok(e), "{}", printed);
    }

    /// A part in a million millions is seen; one of a seventh is shown at a state, and there it is what it is.
    #[test]
    fn small_differences_are_seen_and_shown(
        e in term(),
        steps in steps(),
        by in prop::sample::select(&SYMBOLS[..]),
    ) {
        let arena = &mut arena();
        let e = e.build(arena);
        let other = rewritten(arena, e, &steps);
        let x = arena.symbol(by);
        let mut plus = |k: i64| {
            arena.linear_combination(&[(other, Rational::ONE), (x, Rational::fraction(1, k).expect("not zero"))])
        };
        let (tiny, small) = (plus(1_000_000_000_000), plus(7));
        let verdict = Comparer::default().compare(arena, e, tiny);
        prop_assert!(
            matches!(verdict, Verdict::Different(_)),
            "{} and {}: {verdict:?}", print_text(arena, e), print_text(arena, tiny)
        );
        let verdict = Comparer::default().compare(arena, e, small);
        let shown = format!("{} and {}: {verdict:?}", print_text(arena, e), print_text(arena, small));
        let Verdict::Different(witness) = verdict else { return Err(TestCaseError::fail(shown)) };
        let (inputs, values): (Vec<Expr>, Vec<f64>) =
            witness.at.iter().map(|(name, x)| (arena.symbol(name), *x)).unzip();
        let out = Tape::new(arena, &inputs, &[e, small, x]).unwrap().evaluate(&values);
        prop_assert_eq!((out[0], out[1]), (witness.left, witness.right));
        // Rounding is held below a hundredth of what is shown.
        let expected = -out[2] / 7.0;
        prop_assert!((witness.difference - expected).abs() <= 0.02 * expected.abs(), "{}", shown);
        prop_assert!((out[0] - out[1] - expected).abs() <= 0.02 * expected.abs(), "{}", shown);
    }
}

// What takes a normal form or two.
proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn quotients_undo_products_and_add_over_a_common_denominator(
        a in factor(),
        b in factor(),
        c in factor(),
        d in factor(),
    ) {
        let arena = &mut arena();
        let [a, b, c, d] = [a, b, c, d].map(|t| t.build(arena));
        prop_assume!(divides(arena, b) && divides(arena, d));
        let (ab, cd) = (divided(arena, a, b), divided(arena, c, d));
        let back = arena.mul(ab, b);
        equal(arena, back, a)?;
        let left = arena.add(ab, cd);
        let (ad, bc, bd) = (arena.mul(a, d), arena.mul(b, c), arena.mul(b, d));
        let above = arena.add(ad, bc);
        let right = divided(arena, above, bd);
        equal(arena, left, right)?;
    }

    /// d/dp f(g) = ∂f/∂g dg/dp + ∂f/∂p, with g an angle, a square or a fraction, inside sines and outside.
    #[test]
    fn derivatives_obey_the_chain_rule(
        f in short_term(),
        turn in angle(),
        inner in prop::sample::select(&["q", "x"][..]),
        kind in 0..3,
    ) {
        let arena = &mut arena();
        let f = f.build(arena);
        let (inner, y, sum) = (arena.symbol(inner), arena.symbol("y"), sum_of(arena, &turn));
        let g = match kind {
            0 => sum,
            1 => arena.square(sum),
            _ => arena.mul(y, sum),
        };
        let (outer, rest) = (Differential::partial(inner).apply(arena, f), derivative(arena, f, "p"));
        let mut put = Substitution::new(&[(inner, g)]);
        let [composed, outer, rest] = [f, outer, rest].map(|e| put.apply(arena, e));
        prop_assume!(put.undefined.is_none());
        let (left, slope) = (derivative(arena, composed, "p"), derivative(arena, g, "p"));
        let product = arena.mul(outer, slope);
        let right = arena.add(product, rest);
        equal(arena, left, right)?;
    }

    /// The derivative of a formula is that of its normal form.
    #[test]
    fn normal_forms_have_the_same_derivative(e in short_term()) {
        let arena = &mut arena();
        let e = e.build(arena);
        let mut normalizer = Normalizer::new(200_000);
        let Some(form) = normalizer.normal_form(arena, e) else { return Ok(()) };
        let normal = normalizer.expression(arena, &form);
        equal(arena, e, normal)?;
        for by in ["q", "p", "x"] {
            let (left, right) = (derivative(arena, e, by), derivative(arena, normal, by));
            equal(arena, left, right)?;
        }
    }

    #[test]
    fn what_identities_rewrite_is_equal(e in short_term(), steps in steps()) {
        let arena = &mut arena();
        let e = e.build(arena);
        let other = rewritten(arena, e, &steps);
        equal(arena, e, other)?;
    }

    /// Two engines, never two answers: on what is zero, on what is not, and on anything.
    #[test]
    fn normal_form_and_modular_test_agree(a in short_term(), b in short_term(), steps in steps()) {
        let arena = &mut arena();
        let [a, b] = [a, b].map(|t| t.build(arena));
        let other = rewritten(arena, a, &steps);
        let zero = arena.sub(a, other);
        let near = arena.linear_combination(&[(zero, Rational::ONE), (b, Rational::fraction(1, 1_000_000).unwrap())]);
        let any = arena.sub(a, b);
        for e in [zero, near, any] {
            let both = (Normalizer::new(200_000).zero_by_normal_form(arena, e), zero_test(arena, e));
            let contrary = matches!(both, (Zero::Yes, ZeroTest::NonZero) | (Zero::No, ZeroTest::Zero));
            prop_assert!(!contrary, "{}: {both:?}", print_text(arena, e));
        }
        // Of formulas as they are drawn, with nothing but symbols in angles, both have an answer.
        let both = (Normalizer::new(200_000).zero_by_normal_form(arena, any), zero_test(arena, any));
        let decided = matches!(both, (Zero::Yes, ZeroTest::Zero) | (Zero::No, ZeroTest::NonZero) | (Zero::TooLarge, _));
        prop_assert!(decided, "{}: {both:?}", print_text(arena, any));
    }

    #[test]
    fn simplifying_keeps_the_meaning_and_is_never_longer(e in short_term(), steps in steps()) {
        let arena = &mut arena();
        let e = e.build(arena);
        let long = rewritten(arena, e, &steps);
        let short = Simplifier::default().simplify(arena, long);
        equal(arena, short, e)?;
        prop_assert!(operation_count(arena, short) <= operation_count(arena, long), "{} from {}", print_text(arena, short), print_text(arena, long));
    }
}
