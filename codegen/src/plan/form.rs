//! Form of a formula for computation: the order of a sum's terms, and products and sums that can be
//! fused.

use tripos_derive::algebra::text::view::View;

/// Returns the terms of a sum in the order of computation. A leading product of names and numbers
/// is moved to the second place, where it can be fused with the term before it.
#[must_use]
pub fn led(terms: &[(bool, View)]) -> Vec<&(bool, View)> {
    let mut order: Vec<&(bool, View)> = terms.iter().collect();
    if let [first, second, ..] = order.as_slice()
        && is_plain_product(&first.1)
        && !is_plain_product(&second.1)
    {
        order.swap(0, 1);
    }
    order
}

/// True if a formula is a product of only names and numbers, or the square of a name or number.
#[must_use]
pub fn is_plain_product(view: &View) -> bool {
    match view {
        View::Product(factors) => factors.iter().all(is_plain),
        View::Power(base, 2) => is_plain(base),
        _ => false,
    }
}

/// True if a formula is a single name or number.
fn is_plain(view: &View) -> bool {
    matches!(view, View::Name(_) | View::Shared(_) | View::Number(_))
}

/// True if a formula contains no sum.
#[must_use]
pub fn is_flat(view: &View) -> bool {
    match view {
        View::Sum(_) => false,
        View::Product(factors) => factors.iter().all(is_flat),
        View::Fraction(above, below) => is_flat(above) && is_flat(below),
        View::Power(inner, _) | View::Call(_, inner) | View::Root(inner) => is_flat(inner),
        View::Number(_) | View::Name(_) | View::Word(_) | View::Shared(_) | View::Pi | View::Cut => true,
    }
}

/// Splits a product into its leading whole number, `1` if there is none, and its remaining factors.
#[must_use]
pub fn constant_and_factors(view: &View) -> (String, Vec<View>) {
    match view {
        View::Number(text) => (text.clone(), Vec::new()),
        View::Product(factors) => match &factors[0] {
            View::Number(text) => (text.clone(), factors[1..].to_vec()),
            _ => ("1".to_owned(), factors.clone()),
        },
        other => ("1".to_owned(), vec![other.clone()]),
    }
}
