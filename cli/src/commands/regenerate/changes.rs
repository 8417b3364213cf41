//! What changed between two generated files of equations, by the meaning of the formulas that stand in them.

use crate::words::start_of;
use std::fmt::Write;
use tripos_derive::algebra::compare::Comparer;
use tripos_derive::algebra::parse::parse_primed;
use tripos_derive::algebra::print::text;
use tripos_derive::algebra::simplify::Simplifier;
use tripos_derive::algebra::{Arena, Expr};

/// Changed equations of one file above which they are counted instead of listed: then the derivation was another one.
const MOST_LISTED: usize = 16;

/// How much is said of a file.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Detail {
    /// Each changed equation, in a line.
    Listed,
    /// How many changed.
    Counted,
}

/// The equations that differ between two files, a line each; what only reads differently is counted. Empty if only the
/// text around them changed.
pub fn equation_changes(old: &str, new: &str, detail: Detail) -> String {
    let (old, new) = (equations(old), equations(new));
    let is_same = |a: &Equation<'_>, b: &Equation<'_>| a.function == b.function && a.symbol == b.symbol;
    let (mut changed, mut rewritten) = (Vec::new(), 0);
    let mut meaning = Meaning::default();
    for equation in &new {
        let Some(before) = old.iter().find(|before| is_same(before, equation)) else { continue };
        match meaning.change(&before.value, &equation.value) {
            Change::None => rewritten += usize::from(before.value != equation.value),
            Change::By(difference) => changed.push((equation, format!("new - old = {difference}"))),
            Change::Unknown => changed.push((equation, format!("was {}, is {}", before.value, equation.value))),
        }
    }
    let added: Vec<_> = new.iter().filter(|e| !old.iter().any(|other| is_same(e, other))).collect();
    let gone: Vec<_> = old.iter().filter(|e| !new.iter().any(|other| is_same(e, other))).collect();
    let mut out = String::new();
    let all = changed.len() + added.len() + gone.len();
    if all > 0 && (all > MOST_LISTED || detail == Detail::Counted) {
        let (changed, added, gone) = (changed.len(), added.len(), gone.len());
        let _ = writeln!(out, "    equations: {changed} changed, {added} new, {gone} gone");
    } else {
        let added = added.into_iter().map(|e| (e, format!("new, {}", e.value)));
        let gone = gone.into_iter().map(|e| (e, format!("gone, {}", e.value)));
        for (Equation { function, symbol, .. }, change) in changed.into_iter().chain(added).chain(gone) {
            let _ = writeln!(out, "    {function}, {symbol}: {}", start_of(&change));
        }
    }
    if rewritten > 0 {
        let _ = writeln!(out, "    {rewritten} written in another form, with the same meaning");
    }
    out
}

/// How two formulas differ in meaning.
enum Change {
    None,
    By(String),
    Unknown,
}

#[derive(Default)]
struct Meaning {
    arena: Arena,
    comparer: Comparer,
    simplifier: Simplifier,
}

impl Meaning {
    fn change(&mut self, old: &str, new: &str) -> Change {
        if old == new {
            return Change::None;
        }
        let (Some(old), Some(new)) = (self.read(old), self.read(new)) else { return Change::Unknown };
        if self.comparer.compare(&mut self.arena, old, new).is_equal() {
            return Change::None;
        }
        let difference = self.arena.sub(new, old);
        let difference = self.simplifier.simplify(&mut self.arena, difference);
        Change::By(text(&self.arena, difference))
    }

    /// A formula as a file has it; nothing where it was cut.
    fn read(&mut self, formula: &str) -> Option<Expr> {
        parse_primed(&mut self.arena, formula, 2, &mut |arena, name| Ok(arena.symbol(name))).ok()
    }
}

/// An equation of a file.
#[derive(Debug, PartialEq, Eq)]
struct Equation<'a> {
    /// The function that computes it.
    function: &'a str,
    symbol: String,
    value: String,
}

/// The equations of a file. They stand between fences, before the line that names their function; a line that continues
/// another begins with spaces.
fn equations(text: &str) -> Vec<Equation<'_>> {
    let (mut list, mut lines, mut inside) = (Vec::new(), Vec::<String>::new(), false);
    for line in text.lines() {
        match line.strip_prefix("/// ") {
            Some("```text") => inside = true,
            Some("```") => inside = false,
            Some(equation) if inside => match (equation.strip_prefix("    "), lines.last_mut()) {
                (Some(continued), Some(last)) => *last = format!("{last} {continued}"),
                _ => lines.push(equation.to_owned()),
            },
            _ => {}
        }
        if let Some(function) = line.strip_prefix("pub use ").and_then(|path| path.strip_suffix(';')) {
            let function = function.rsplit("::").next().unwrap_or(function);
            list.extend(lines.drain(..).filter_map(|equation| {
                let (symbol, value) = equation.split_once(" = ")?;
                Some(Equation { function, symbol: symbol.to_owned(), value: value.to_owned() })
            }));
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(equations: &str) -> String {
        let lines = equations.lines().map(|line| format!("/// {line}\n")).collect::<Vec<_>>().concat();
        format!(
            "/// Right-hand side.\n///\n/// ```text\n{lines}/// ```\n#[doc(inline)]\npub use super::code::kane::forcing;\n"
        )
    }

    #[test]
    fn a_changed_term_is_named_by_function_and_entry() {
        let old = file("f1 = -M*g\nf2 = long +\n    formula");
        let new = file("f1 = M*g\nf2 = long +\n    formula\nf3 = c*u3");
        assert_eq!(
            equation_changes(&old, &new, Detail::Listed),
            "    forcing, f1: new - old = 2*M*g\n    forcing, f3: new, c*u3\n"
        );
        assert!(equation_changes(&new, &old, Detail::Listed).contains("    forcing, f3: gone, c*u3\n"));
        let same = new.replace("f1 = M*g", "f1 = g*M*sin(q1')^2 + M*g*cos(q1')^2");
        assert_eq!(
            equation_changes(&new, &same, Detail::Listed),
            "    1 written in another form, with the same meaning\n"
        );
        assert!(equation_changes(&old, &old, Detail::Listed).is_empty());
        assert_eq!(equations(&old)[1].value, "long + formula");
    }

    #[test]
    fn many_changes_are_counted() {
        let all = |sign: &str| file(&(0..20).map(|at| format!("f{at} = {sign}x{at}\n")).collect::<Vec<_>>().concat());
        let expected = "    equations: 20 changed, 0 new, 0 gone\n";
        assert_eq!(equation_changes(&all(""), &all("-"), Detail::Listed), expected);
    }
}
