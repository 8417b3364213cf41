//! Formulas as trees that can be edited and written down again.

use rustc_hash::FxHashMap;
use tripos_derive::algebra::text::display_tree::{DisplayTree, display_tree};
use tripos_derive::algebra::text::print::BUDGET;
use tripos_derive::algebra::{Arena, Expr};

/// The tree of marks of a term, as it would be printed.
pub fn tree(arena: &Arena, e: Expr) -> DisplayTree {
    display_tree(arena, e, &FxHashMap::default(), BUDGET)
}

/// A whole number.
pub fn number(n: u32) -> DisplayTree {
    DisplayTree::Number(n.to_string())
}

/// A symbol.
pub fn name(text: &str) -> DisplayTree {
    DisplayTree::Name(text.to_owned())
}

/// a + b + …
pub fn sum(terms: impl IntoIterator<Item = DisplayTree>) -> DisplayTree {
    DisplayTree::Sum(terms.into_iter().map(|term| (false, term)).collect())
}

/// The difference a − b.
pub fn minus(a: DisplayTree, b: DisplayTree) -> DisplayTree {
    DisplayTree::Sum(vec![(false, a), (true, b)])
}

/// a · b · …
pub fn product(factors: impl IntoIterator<Item = DisplayTree>) -> DisplayTree {
    DisplayTree::Product(factors.into_iter().collect())
}

/// The quotient a / b.
pub fn quotient(a: DisplayTree, b: DisplayTree) -> DisplayTree {
    DisplayTree::Fraction(Box::new(a), Box::new(b))
}

/// a to the power n, n at least 0.
pub fn power(a: DisplayTree, n: i32) -> DisplayTree {
    match n {
        0 => number(1),
        1 => a,
        _ => DisplayTree::Power(Box::new(a), n),
    }
}

/// A function of an argument.
pub fn call(function: &'static str, argument: DisplayTree) -> DisplayTree {
    DisplayTree::Call(function, Box::new(argument))
}

/// Every tree in which one node of this one is replaced by something that `edit` makes of it.
pub fn edits(tree: &DisplayTree, edit: &dyn Fn(&DisplayTree) -> Vec<DisplayTree>) -> Vec<DisplayTree> {
    edits_within(tree, &|_| true, edit)
}

/// Edited trees as of [`edits`], changed only below nodes that `enter` accepts.
pub fn edits_within(
    tree: &DisplayTree,
    enter: &dyn Fn(&DisplayTree) -> bool,
    edit: &dyn Fn(&DisplayTree) -> Vec<DisplayTree>,
) -> Vec<DisplayTree> {
    let mut list = edit(tree);
    if enter(tree) {
        for (at, child) in children(tree).into_iter().enumerate() {
            list.extend(edits_within(child, enter, edit).into_iter().map(|new| with_child(tree, at, new)));
        }
    }
    list
}

/// The nodes right below a node.
pub fn children(tree: &DisplayTree) -> Vec<&DisplayTree> {
    match tree {
        DisplayTree::Sum(terms) => terms.iter().map(|(_, term)| term).collect(),
        DisplayTree::Product(factors) => factors.iter().collect(),
        DisplayTree::Fraction(above, below) => vec![above, below],
        DisplayTree::Power(inner, _) | DisplayTree::Call(_, inner) | DisplayTree::Root(inner) => vec![inner],
        DisplayTree::Number(_)
        | DisplayTree::Name(_)
        | DisplayTree::Word(_)
        | DisplayTree::Shared(_)
        | DisplayTree::Pi
        | DisplayTree::Cut => Vec::new(),
    }
}

/// The same node with another child at a position.
fn with_child(tree: &DisplayTree, at: usize, new: DisplayTree) -> DisplayTree {
    let mut tree = tree.clone();
    let place = match &mut tree {
        DisplayTree::Sum(terms) => &mut terms[at].1,
        DisplayTree::Product(factors) => &mut factors[at],
        DisplayTree::Fraction(above, below) => [above, below].into_iter().nth(at).expect("0 or 1"),
        DisplayTree::Power(inner, _) | DisplayTree::Call(_, inner) | DisplayTree::Root(inner) => inner,
        _ => unreachable!("it has no children"),
    };
    *place = new;
    tree
}

/// The tree in the language of report files, with more parentheses than it needs.
pub fn text(tree: &DisplayTree) -> String {
    let mut out = String::new();
    write(tree, &mut out);
    out
}

fn write(tree: &DisplayTree, out: &mut String) {
    match tree {
        DisplayTree::Number(text) | DisplayTree::Name(text) | DisplayTree::Word(text) | DisplayTree::Shared(text) => {
            out.push_str(text);
        }
        DisplayTree::Pi => out.push_str("pi"),
        DisplayTree::Sum(terms) => {
            for (at, (negative, term)) in terms.iter().enumerate() {
                out.push_str(match (at, negative) {
                    (0, false) => "",
                    (0, true) => "-",
                    (_, false) => " + ",
                    (_, true) => " - ",
                });
                operand(term, Binding::Loose, out);
            }
        }
        DisplayTree::Product(factors) => {
            for (at, factor) in factors.iter().enumerate() {
                out.push_str(if at > 0 { "*" } else { "" });
                operand(factor, Binding::Tight, out);
            }
        }
        DisplayTree::Fraction(above, below) => {
            operand(above, Binding::Tight, out);
            out.push('/');
            operand(below, Binding::Tight, out);
        }
        DisplayTree::Power(base, n) => {
            operand(base, Binding::Tight, out);
            out.push('^');
            out.push_str(&n.to_string());
        }
        DisplayTree::Call(function, argument) => {
            out.push_str(function);
            enclosed(argument, out);
        }
        DisplayTree::Root(argument) => {
            out.push_str("sqrt");
            enclosed(argument, out);
        }
        DisplayTree::Cut => panic!("the formula is too long to be printed"),
    }
}

/// Binding of an operand by the operation around it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Binding {
    /// Operand of a sum.
    Loose,
    /// Operand of a product, a fraction or a power.
    Tight,
}

/// Writes an operand, in parentheses if it is a sum, or if it is composed at all and binding is tight.
fn operand(tree: &DisplayTree, binding: Binding, out: &mut String) {
    let loose = match tree {
        DisplayTree::Sum(_) => true,
        DisplayTree::Product(_) | DisplayTree::Fraction(..) | DisplayTree::Power(..) => binding == Binding::Tight,
        _ => false,
    };
    if loose { enclosed(tree, out) } else { write(tree, out) }
}

fn enclosed(tree: &DisplayTree, out: &mut String) {
    out.push('(');
    write(tree, out);
    out.push(')');
}
