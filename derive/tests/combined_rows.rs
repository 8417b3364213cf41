//! Rows that combine others, written with angles that are equal only by meaning.

use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::meaning::compare::Comparer;
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diff::equations::row_judgement::{RowMatchResult, TermTools, judge_row};

fn row(arena: &mut Arena, texts: [&str; 3]) -> Vec<Expr> {
    texts.map(|text| parse_free(arena, text).unwrap_or_else(|e| panic!("{text}: {e:?}"))).to_vec()
}

/// The sum of both rows; the angle in it is q.
#[test]
fn a_combination_is_seen_through_a_composed_angle() {
    let mut arena = Arena::new();
    let derived = [row(&mut arena, ["1", "cos(q)", "a"]), row(&mut arena, ["m", "1", "b"])];
    let printed = row(&mut arena, ["1 + m", "1 + cos(q*cos(p)^2 + q*sin(p)^2)", "a + b"]);
    let (mut simplifier, mut comparer) = (Simplifier::default(), Comparer::default());
    let mut terms = TermTools { arena: &mut arena, simplifier: &mut simplifier, comparer: &mut comparer };
    let judged = judge_row(&mut terms, &[], &printed, &derived, 0);
    assert!(judged.is_right() && matches!(judged.by, RowMatchResult::Combination { .. }), "{judged:?}");
}
