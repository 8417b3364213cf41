//! Form of a formula for computation: the order of the terms in a sum, and products that can be fused with additions.

use tripos_derive::algebra::text::display_tree::DisplayTree;

/// Returns the terms of a sum in the order of computation. A leading product of names and numbers
/// is moved to the second place, where it can be fused with the term before it.
#[must_use]
pub fn order_sum_for_fusion(terms: &[(bool, DisplayTree)]) -> Vec<&(bool, DisplayTree)> {
    let mut order: Vec<&(bool, DisplayTree)> = terms.iter().collect();
    if let [first, second, ..] = order.as_slice()
        && is_fusible_product(&first.1)
        && !is_fusible_product(&second.1)
    {
        order.swap(0, 1);
    }
    order
}

/// True if a formula is a product of only names and numbers, or the square of a name or number.
#[must_use]
pub fn is_fusible_product(view: &DisplayTree) -> bool {
    match view {
        DisplayTree::Product(factors) => factors.iter().all(is_fusible_factor),
        DisplayTree::Power(base, 2) => is_fusible_factor(base),
        _ => false,
    }
}

/// True if a formula is a single name or number.
fn is_fusible_factor(view: &DisplayTree) -> bool {
    matches!(view, DisplayTree::Name(_) | DisplayTree::Shared(_) | DisplayTree::Number(_))
}
