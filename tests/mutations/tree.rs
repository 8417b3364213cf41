//! Formulas as trees that can be edited and written down again.

use rustc_hash::FxHashMap;
use tripos_derive::algebra::text::print::BUDGET;
use tripos_derive::algebra::text::view::{View, view};
use tripos_derive::algebra::{Arena, Expr};

/// The tree of marks of a term, as it would be printed.
pub fn tree(arena: &Arena, e: Expr) -> View {
    view(arena, e, &FxHashMap::default(), BUDGET)
}

/// A whole number.
pub fn number(n: u32) -> View {
    View::Number(n.to_string())
}

/// A symbol.
pub fn name(text: &str) -> View {
    View::Name(text.to_owned())
}

/// a + b + …
pub fn sum(terms: impl IntoIterator<Item = View>) -> View {
    View::Sum(terms.into_iter().map(|term| (false, term)).collect())
}

/// The difference a − b.
pub fn minus(a: View, b: View) -> View {
    View::Sum(vec![(false, a), (true, b)])
}

/// a · b · …
pub fn product(factors: impl IntoIterator<Item = View>) -> View {
    View::Product(factors.into_iter().collect())
}

/// The quotient a / b.
pub fn quotient(a: View, b: View) -> View {
    View::Fraction(Box::new(a), Box::new(b))
}

/// a to the power n, n at least 0.
pub fn power(a: View, n: i32) -> View {
    match n {
        0 => number(1),
        1 => a,
        _ => View::Power(Box::new(a), n),
    }
}

/// A function of an argument.
pub fn call(function: &'static str, argument: View) -> View {
    View::Call(function, Box::new(argument))
}

/// Every tree in which one node of this one is replaced by something that `edit` makes of it.
pub fn edits(tree: &View, edit: &dyn Fn(&View) -> Vec<View>) -> Vec<View> {
    edits_within(tree, &|_| true, edit)
}

/// Edited trees as of [`edits`], changed only below nodes that `enter` accepts.
pub fn edits_within(tree: &View, enter: &dyn Fn(&View) -> bool, edit: &dyn Fn(&View) -> Vec<View>) -> Vec<View> {
    let mut list = edit(tree);
    if enter(tree) {
        for (at, child) in children(tree).into_iter().enumerate() {
            list.extend(edits_within(child, enter, edit).into_iter().map(|new| with_child(tree, at, new)));
        }
    }
    list
}

/// The nodes right below a node.
pub fn children(tree: &View) -> Vec<&View> {
    match tree {
        View::Sum(terms) => terms.iter().map(|(_, term)| term).collect(),
        View::Product(factors) => factors.iter().collect(),
        View::Fraction(above, below) => vec![above, below],
        View::Power(inner, _) | View::Call(_, inner) | View::Root(inner) => vec![inner],
        View::Number(_) | View::Name(_) | View::Word(_) | View::Shared(_) | View::Pi | View::Cut => Vec::new(),
    }
}

/// The same node with another child at a position.
fn with_child(tree: &View, at: usize, new: View) -> View {
    let mut tree = tree.clone();
    let place = match &mut tree {
        View::Sum(terms) => &mut terms[at].1,
        View::Product(factors) => &mut factors[at],
        View::Fraction(above, below) => [above, below].into_iter().nth(at).expect("0 or 1"),
        View::Power(inner, _) | View::Call(_, inner) | View::Root(inner) => inner,
        _ => unreachable!("it has no children"),
    };
    *place = new;
    tree
}

/// The tree in the language of report files, with more parentheses than it needs.
pub fn text(tree: &View) -> String {
    let mut out = String::new();
    write(tree, &mut out);
    out
}

fn write(tree: &View, out: &mut String) {
    match tree {
        View::Number(text) | View::Name(text) | View::Word(text) | View::Shared(text) => out.push_str(text),
        View::Pi => out.push_str("pi"),
        View::Sum(terms) => {
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
        View::Product(factors) => {
            for (at, factor) in factors.iter().enumerate() {
                out.push_str(if at > 0 { "*" } else { "" });
                operand(factor, Binding::Tight, out);
            }
        }
        View::Fraction(above, below) => {
            operand(above, Binding::Tight, out);
            out.push('/');
            operand(below, Binding::Tight, out);
        }
        View::Power(base, n) => {
            operand(base, Binding::Tight, out);
            out.push('^');
            out.push_str(&n.to_string());
        }
        View::Call(function, argument) => {
            out.push_str(function);
            enclosed(argument, out);
        }
        View::Root(argument) => {
            out.push_str("sqrt");
            enclosed(argument, out);
        }
        View::Cut => panic!("the formula is too long to be printed"),
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
fn operand(tree: &View, binding: Binding, out: &mut String) {
    let loose = match tree {
        View::Sum(_) => true,
        View::Product(_) | View::Fraction(..) | View::Power(..) => binding == Binding::Tight,
        _ => false,
    };
    if loose { enclosed(tree, out) } else { write(tree, out) }
}

fn enclosed(tree: &View, out: &mut String) {
    out.push('(');
    write(tree, out);
    out.push(')');
}
