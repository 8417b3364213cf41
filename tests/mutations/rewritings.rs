//! The same formula, written differently.

use super::printed::{Printed, System};
use super::tree::{call, edits_within, minus, name, number, power, product, quotient, sum, text};
use crate::support::Random;
use tripos_derive::algebra::text::display_tree::DisplayTree;

/// An identity: what a node may be replaced by. `a`, `b` are symbols and `y` an angle to write it with.
struct Rule {
    name: &'static str,
    rewrite: fn(node: &DisplayTree, a: &DisplayTree, b: &DisplayTree, y: &DisplayTree) -> Option<DisplayTree>,
}

const RULES: [Rule; 19] = [
    Rule { name: "sin^2 = 1 - cos^2", rewrite: |node, _, _, _| square("sin", node, |x| minus_square("cos", x)) },
    Rule { name: "cos^2 = 1 - sin^2", rewrite: |node, _, _, _| square("cos", node, |x| minus_square("sin", x)) },
    Rule { name: "sin^2 = (1 - cos 2x)/2", rewrite: |node, _, _, _| square("sin", node, |x| half_turn(true, x)) },
    Rule { name: "cos^2 = (1 + cos 2x)/2", rewrite: |node, _, _, _| square("cos", node, |x| half_turn(false, x)) },
    Rule { name: "cos^2 = 1/(1 + tan^2)", rewrite: |node, _, _, _| square("cos", node, over_tangents) },
    Rule { name: "1/cos^2 = 1 + tan^2", rewrite: |node, _, _, _| below_a_square(node) },
    Rule { name: "tan = sin/cos", rewrite: |node, _, _, _| wave("tan", node, tangent) },
    Rule { name: "tan = sin 2x/(1 + cos 2x)", rewrite: |node, _, _, _| wave("tan", node, tangent_of_half) },
    Rule { name: "sin x = 2 sin x/2 cos x/2", rewrite: |node, _, _, _| wave("sin", node, sine_of_halves) },
    Rule { name: "cos x = 1 - 2 sin^2 x/2", rewrite: |node, _, _, _| wave("cos", node, cosine_of_half) },
    Rule { name: "sin x = sin 2x/(2 cos x)", rewrite: |node, _, _, _| wave("sin", node, sine_of_double) },
    Rule { name: "sin x = 3 sin x/3 - 4 sin^3 x/3", rewrite: |node, _, _, _| wave("sin", node, sine_of_thirds) },
    Rule { name: "angle sum, by y", rewrite: |node, _, _, y| turned(node, y) },
    Rule { name: "angle sum, its own", rewrite: |node, _, _, _| parted(node) },
    Rule { name: "product of a sum, expanded", rewrite: |node, _, _, _| expanded(node) },
    Rule { name: "factor taken out", rewrite: |node, a, _, _| taken_out(node, a) },
    Rule { name: "over a common denominator", rewrite: |node, _, b, y| over_common(node, b, y) },
    Rule { name: "plus a - a", rewrite: |node, a, b, y| Some(plus_nothing(node, a, b, y)) },
    Rule { name: "times (1 + tan^2) cos^2", rewrite: |node, _, _, y| Some(times_one(node, y)) },
];

/// A formula that is right, written in another way.
pub struct Rewriting {
    /// The rules, in the order in which they were used.
    pub rules: Vec<&'static str>,
    /// The position of the quantity in [`Printed::equations`].
    pub equation: usize,
    pub original: String,
    pub rewritten: String,
}

/// Rewritings of quantities, each by one to three rules at random places. The first rule is each in turn.
pub fn of_equations(printed: &Printed, wanted: usize, random: &mut Random) -> Vec<Rewriting> {
    let mut list = Vec::new();
    let mut tries = 0;
    while list.len() < wanted && tries < 100 * wanted {
        // A rule that finds no place makes way for the next one.
        let mut rules = vec![&RULES[tries % RULES.len()]];
        tries += 1;
        let equation = random.below(printed.equations.len());
        let original = &printed.equations[equation].1;
        rules.extend((0..random.below(3)).map(|_| &RULES[random.below(RULES.len())]));
        let Some((used, new)) = rewritten(original, &rules, |_| true, printed, random) else { continue };
        let (original, rewritten) = (text(original), text(&new));
        list.push(Rewriting { rules: used, equation, original, rewritten });
    }
    list
}

/// A tree after some rules, used at nodes that may be entered, and the names of those that found a place; nothing if
/// the first found none.
fn rewritten(
    tree: &DisplayTree,
    rules: &[&Rule],
    enter: fn(&DisplayTree) -> bool,
    printed: &Printed,
    random: &mut Random,
) -> Option<(Vec<&'static str>, DisplayTree)> {
    let (mut used, mut tree) = (Vec::new(), tree.clone());
    for (at, rule) in rules.iter().enumerate() {
        let [a, b] = [0, 0].map(|_: usize| name(&random.one_of(&printed.model.parameters).expect("some").name));
        let y = name(random.one_of(&printed.angles).expect("every model here turns"));
        let outcomes = edits_within(&tree, &enter, &|node| (rule.rewrite)(node, &a, &b, &y).into_iter().collect());
        match random.one_of(&outcomes) {
            Some(new) => {
                used.push(rule.name);
                tree = new.clone();
            }
            None if at == 0 => return None,
            None => {}
        }
    }
    Some((used, tree))
}

/// A row of a system, in a form that means the same.
pub struct Row {
    /// Description of the change.
    pub change: String,
    pub entries: Vec<String>,
}

/// The rows of a system in another order, each with a factor, plus a multiple of another row, or rewritten entry by
/// entry.
pub fn of_rows(printed: &Printed, system: &System, random: &mut Random) -> Vec<Row> {
    let n = system.rows.len();
    let turn = random.below(n);
    let mut list = Vec::new();
    for at in 0..n {
        let own = (at + turn) % n;
        let (factor, other) = (factor(printed, random), (own + 1 + random.below(n - 1)) % n);
        let second = if random.below(2) == 0 { Some(self::factor(printed, random)) } else { None };
        let mut entries = Vec::new();
        let mut rules = Vec::new();
        for (entry, added) in system.rows[own].iter().zip(&system.rows[other]) {
            let rule = &RULES[random.below(RULES.len())];
            let entry = match rewritten(entry, &[rule], |_| true, printed, random) {
                Some((used, new)) => {
                    rules.extend(used);
                    new
                }
                _ => entry.clone(),
            };
            let scaled = product([factor.clone(), entry]);
            let combined = match &second {
                Some(k) => sum([scaled, product([k.clone(), added.clone()])]),
                None => scaled,
            };
            entries.push(text(&combined));
        }
        let plus = second.map_or(String::new(), |k| format!(" + ({}) row {}", text(&k), other + 1));
        let change = format!("({}) row {}{plus}, entries by {rules:?}", text(&factor), own + 1);
        list.push(Row { change, entries });
    }
    list
}

/// A number, a parameter, cos y, 1 + sin² y or one over it.
fn factor(printed: &Printed, random: &mut Random) -> DisplayTree {
    let y = name(random.one_of(&printed.angles).expect("every model here turns"));
    let a = name(&random.one_of(&printed.model.parameters).expect("some").name);
    let one_and_square = sum([number(1), power(call("sin", y.clone()), 2)]);
    match random.below(6) {
        0 => number(3),
        1 => DisplayTree::Sum(vec![(true, quotient(number(2), number(7)))]),
        2 => a,
        3 => call("cos", y),
        4 => one_and_square,
        _ => quotient(a, one_and_square),
    }
}

fn double(x: &DisplayTree) -> DisplayTree {
    product([number(2), x.clone()])
}

fn share(x: &DisplayTree, n: u32) -> DisplayTree {
    quotient(x.clone(), number(n))
}

fn square_of(function: &'static str, x: &DisplayTree) -> DisplayTree {
    power(call(function, x.clone()), 2)
}

/// f(x)^n, n ≥ 2, with f(x)² replaced.
fn square(function: &str, node: &DisplayTree, by: impl Fn(&DisplayTree) -> DisplayTree) -> Option<DisplayTree> {
    let DisplayTree::Power(base, n) = node else { return None };
    let DisplayTree::Call(f, x) = &**base else { return None };
    (*f == function).then(|| product([by(x), power((**base).clone(), n - 2)]))
}

fn minus_square(function: &'static str, x: &DisplayTree) -> DisplayTree {
    minus(number(1), square_of(function, x))
}

fn half_turn(subtracted: bool, x: &DisplayTree) -> DisplayTree {
    quotient(DisplayTree::Sum(vec![(false, number(1)), (subtracted, call("cos", double(x)))]), number(2))
}

fn over_tangents(x: &DisplayTree) -> DisplayTree {
    quotient(number(1), sum([number(1), square_of("tan", x)]))
}

/// a/cos(x)^n, n ≥ 2.
fn below_a_square(node: &DisplayTree) -> Option<DisplayTree> {
    let DisplayTree::Fraction(above, below) = node else { return None };
    let DisplayTree::Power(base, n) = &**below else { return None };
    let DisplayTree::Call("cos", x) = &**base else { return None };
    let square = sum([number(1), square_of("tan", x)]);
    Some(product([(**above).clone(), square, quotient(number(1), power((**base).clone(), n - 2))]))
}

fn wave(function: &str, node: &DisplayTree, by: fn(&DisplayTree) -> DisplayTree) -> Option<DisplayTree> {
    let DisplayTree::Call(f, x) = node else { return None };
    (*f == function).then(|| by(x))
}

fn tangent(x: &DisplayTree) -> DisplayTree {
    quotient(call("sin", x.clone()), call("cos", x.clone()))
}

fn tangent_of_half(x: &DisplayTree) -> DisplayTree {
    quotient(call("sin", double(x)), sum([number(1), call("cos", double(x))]))
}

fn sine_of_halves(x: &DisplayTree) -> DisplayTree {
    product([number(2), call("sin", share(x, 2)), call("cos", share(x, 2))])
}

fn cosine_of_half(x: &DisplayTree) -> DisplayTree {
    minus(number(1), product([number(2), square_of("sin", &share(x, 2))]))
}

fn sine_of_double(x: &DisplayTree) -> DisplayTree {
    quotient(call("sin", double(x)), product([number(2), call("cos", x.clone())]))
}

fn sine_of_thirds(x: &DisplayTree) -> DisplayTree {
    let sine = call("sin", share(x, 3));
    minus(product([number(3), sine.clone()]), product([number(4), power(sine, 3)]))
}

/// sin or cos of (x ∓ y) ± y.
fn turned(node: &DisplayTree, y: &DisplayTree) -> Option<DisplayTree> {
    let DisplayTree::Call(f, x) = node else { return None };
    let (sine, cosine) = (|x: &DisplayTree| call("sin", x.clone()), |x: &DisplayTree| call("cos", x.clone()));
    let rest = minus((**x).clone(), y.clone());
    match *f {
        "sin" => Some(sum([product([sine(&rest), cosine(y)]), product([cosine(&rest), sine(y)])])),
        "cos" => Some(minus(product([cosine(&rest), cosine(y)]), product([sine(&rest), sine(y)]))),
        _ => None,
    }
}

/// sin or cos of a sum, by its first term and the rest.
fn parted(node: &DisplayTree) -> Option<DisplayTree> {
    let DisplayTree::Call(f, x) = node else { return None };
    let DisplayTree::Sum(terms) = &**x else { return None };
    let (first, rest) = terms.split_first().filter(|(_, rest)| !rest.is_empty())?;
    let (a, b) = (DisplayTree::Sum(vec![first.clone()]), DisplayTree::Sum(rest.to_vec()));
    let of = |f: &'static str, x: &DisplayTree| call(f, x.clone());
    match *f {
        "sin" => Some(sum([product([of("sin", &a), of("cos", &b)]), product([of("cos", &a), of("sin", &b)])])),
        "cos" => Some(minus(product([of("cos", &a), of("cos", &b)]), product([of("sin", &a), of("sin", &b)]))),
        _ => None,
    }
}

/// a (b + c) = a b + a c, and (b + c)² likewise.
fn expanded(node: &DisplayTree) -> Option<DisplayTree> {
    let (factors, terms) = match node {
        DisplayTree::Product(factors) => {
            let at = factors.iter().position(|factor| matches!(factor, DisplayTree::Sum(_)))?;
            let mut others = factors.clone();
            let DisplayTree::Sum(terms) = others.remove(at) else { return None };
            (others, terms)
        }
        DisplayTree::Power(base, n) => {
            let DisplayTree::Sum(terms) = &**base else { return None };
            (vec![power((**base).clone(), n - 1)], terms.clone())
        }
        _ => return None,
    };
    let term = |term: DisplayTree| product(factors.iter().cloned().chain([term]));
    Some(DisplayTree::Sum(terms.into_iter().map(|(sign, inner)| (sign, term(inner))).collect()))
}

/// b + c = a (b/a + c/a).
fn taken_out(node: &DisplayTree, a: &DisplayTree) -> Option<DisplayTree> {
    let DisplayTree::Sum(terms) = node else { return None };
    let shares = terms.iter().map(|(sign, term)| (*sign, quotient(term.clone(), a.clone()))).collect();
    Some(product([a.clone(), DisplayTree::Sum(shares)]))
}

/// b + c = (b d + c d)/d with d = a (3 + cos y).
fn over_common(node: &DisplayTree, a: &DisplayTree, y: &DisplayTree) -> Option<DisplayTree> {
    let DisplayTree::Sum(terms) = node else { return None };
    let d = product([a.clone(), sum([number(3), call("cos", y.clone())])]);
    let raised = terms.iter().map(|(sign, term)| (*sign, product([term.clone(), d.clone()]))).collect();
    Some(quotient(DisplayTree::Sum(raised), d))
}

/// x + a (b + sin y) − a b − a sin y.
fn plus_nothing(node: &DisplayTree, a: &DisplayTree, b: &DisplayTree, y: &DisplayTree) -> DisplayTree {
    let sine = call("sin", y.clone());
    DisplayTree::Sum(vec![
        (false, node.clone()),
        (false, product([a.clone(), sum([b.clone(), sine.clone()])])),
        (true, product([a.clone(), b.clone()])),
        (true, product([a.clone(), sine])),
    ])
}

fn times_one(node: &DisplayTree, y: &DisplayTree) -> DisplayTree {
    product([node.clone(), sum([number(1), square_of("tan", y)]), square_of("cos", y)])
}
