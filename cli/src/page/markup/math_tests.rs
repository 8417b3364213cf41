//! Tests of the page's formulas: where lines may be broken, and the replacement of formulas that are too long.

use crate::page::markup::formula_mathml::{
    MathmlSide, aligned_mathml_equations, breakable_mathml, formula, formula_mathml_in_sentence,
    vector_components_html, widest, zero_formula_mathml,
};
use crate::page::markup::typeset::typeset;
use crate::page::tests::unbalanced;
use tripos_derive::algebra::Arena;
use tripos_derive::algebra::text::parse::parse_free;

#[test]
fn long_sums_may_stand_on_several_lines() {
    let sum = typeset("-a + (b - c)").unwrap().remove(0);
    assert_eq!(widest(&sum), 6, "+(b−c)");
    let side = || MathmlSide::Whole("<mi>I</mi>".to_owned());
    let pieces = breakable_mathml(&[side(), MathmlSide::Marks(sum)]);
    assert_eq!(pieces.matches("<math>").count(), 2, "what is narrow stays whole: {pieces}");
    let sum = typeset("-alpha_long + m*(beta_long - gamma_long*(delta_long + 1))").unwrap().remove(0);
    let pieces = breakable_mathml(&[side(), MathmlSide::Marks(sum.clone())]);
    assert_eq!(pieces.matches("<math>").count(), 4, "{pieces}");
    assert_eq!(unbalanced(&pieces), None);
    assert!(
        pieces.contains("<mi>I</mi><mo form=\"infix\" rspace=\"0\">=</mo></math> <math><mo form=\"prefix\">−</mo>"),
        "{pieces}"
    );
    let rows = aligned_mathml_equations(&[(side(), MathmlSide::Marks(sum.clone())), (MathmlSide::Marks(sum), side())]);
    assert_eq!(unbalanced(&rows), None);
    assert!(rows.contains("<td class=\"wide\"><math><mo form=\"infix\">=</mo>"), "{rows}");
    assert!(rows.contains("<td class=\"wide\" colspan=\"2\">"), "a wide left side pushes no equals signs: {rows}");
}

/// Goal: no formula that is too long to read is printed. Method: sums of many different sines, with one operation for
/// each term except the first, and four operations for each sine.
#[test]
fn what_nobody_would_read_is_told_by_its_number_of_operations() {
    let mut arena = Arena::new();
    let mut sum = |terms: usize| {
        let text: Vec<String> = (0..terms).map(|k| format!("sin(q{k})")).collect();
        parse_free(&mut arena, &text.join(" + ")).unwrap()
    };
    let (short, medium, long) = (sum(10), sum(100), sum(300));
    let zero = |e| zero_formula_mathml(&arena, e);
    assert!(
        zero(short).ends_with("<mo form=\"infix\" rspace=\"0\">=</mo></math> <math><mn>0</mn></math>"),
        "{}",
        zero(short)
    );
    assert_eq!(zero(medium), "a term of 499 operations vanishes", "too long for a sentence");
    assert_eq!(formula_mathml_in_sentence(&arena, long), "a term of 1499 operations");
    assert!(formula(&arena, medium).contains("<msub><mi>q</mi><mn>99</mn></msub>"), "but not for a line of its own");
    assert_eq!(formula(&arena, long), "<mtext>a term of 1499 operations</mtext>");
}

#[test]
fn components_that_are_wide_stand_on_several_lines() {
    let mut arena = Arena::new();
    let [x, long] = ["x", "stiffness*(first_place - second_place) - damping*first_speed"]
        .map(|text| parse_free(&mut arena, text).unwrap());
    let short = vector_components_html(&arena, &[x, x, x]);
    assert_eq!(short.matches("<math>").count(), 1, "{short}");
    let wide = vector_components_html(&arena, &[x, long, x]);
    assert_eq!(unbalanced(&wide), None);
    assert!(
        wide.matches("<math>").count() > 3 && wide.matches("<mo separator=\"true\">,</mo></math>").count() == 2,
        "{wide}"
    );
}
