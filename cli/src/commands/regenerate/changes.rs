//! What changed between two generated files, by the meaning of the equations that stand beside their lines.

use std::fmt::Write;
use tripos_derive::algebra::compare::Comparer;
use tripos_derive::algebra::parse::parse_primed;
use tripos_derive::algebra::print::text;
use tripos_derive::algebra::simplify::Simplifier;
use tripos_derive::algebra::{Arena, Expr};

/// The equations that differ between two generated files, function by function; what only reads differently is counted.
pub fn equation_changes(old: &str, new: &str) -> String {
    let (old, new) = (equations(old), equations(new));
    let (mut out, mut rewritten) = (String::new(), 0);
    let mut meaning = Meaning::default();
    for (key, value) in &new {
        match old.iter().find(|(k, _)| k == key) {
            Some((_, before)) if before == value => {}
            Some((_, before)) => match meaning.change(before, value) {
                Change::None => rewritten += 1,
                Change::By(difference) => {
                    let _ =
                        writeln!(out, "    {key}\n      - {before}\n      + {value}\n      new - old = {difference}");
                }
                Change::Unknown => {
                    let _ = writeln!(out, "    {key}\n      - {before}\n      + {value}");
                }
            },
            None => {
                let _ = writeln!(out, "    {key}\n      + {value}");
            }
        }
    }
    for (key, before) in old.iter().filter(|(key, _)| !new.iter().any(|(k, _)| k == key)) {
        let _ = writeln!(out, "    {key}\n      - {before}");
    }
    if rewritten > 0 {
        let _ = writeln!(out, "    {rewritten} written in another form, with the same meaning");
    }
    if out.is_empty() { "    the equations are the same; only the text around them changed\n".to_owned() } else { out }
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
        let (Some(old), Some(new)) = (self.read(old), self.read(new)) else { return Change::Unknown };
        if self.comparer.compare(&mut self.arena, old, new).is_equal() {
            return Change::None;
        }
        let difference = self.arena.sub(new, old);
        let difference = self.simplifier.simplify(&mut self.arena, difference);
        Change::By(text(&self.arena, difference))
    }

    /// A formula as a comment has it; nothing where the comment was cut.
    fn read(&mut self, formula: &str) -> Option<Expr> {
        parse_primed(&mut self.arena, formula, 2, &mut |arena, name| Ok(arena.symbol(name))).ok()
    }
}

/// ("function: symbol", "value") for each equation that stands in a comment beside its line.
fn equations(text: &str) -> Vec<(String, String)> {
    let mut list: Vec<(String, String)> = Vec::new();
    let mut function = "";
    for line in text.lines() {
        if let Some(rest) = line.strip_prefix("pub fn ") {
            function = rest.split(['<', '(']).next().unwrap_or("");
        }
        let Some(comment) = line.trim_start().strip_prefix("// ") else { continue };
        if let (Some(continued), Some(last)) = (comment.strip_prefix("  "), list.last_mut()) {
            last.1.push(' ');
            last.1.push_str(continued);
        } else if let Some((symbol, value)) = comment.split_once(" = ") {
            list.push((format!("{function}: {symbol}"), value.to_owned()));
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_changed_term_is_named_by_function_and_entry() {
        let old = "pub fn forcing<S>(\n    // f1 = -M*g\n    let f1 = 0;\n    // f2 = long\n    //   formula\n";
        let new = "pub fn forcing<S>(\n    // f1 = M*g\n    let f1 = 0;\n    // f2 = long\n    //   formula\n";
        let expected = "    forcing: f1\n      - -M*g\n      + M*g\n      new - old = 2*M*g\n";
        assert_eq!(equation_changes(old, new), expected);
        let same = new.replace("f1 = M*g", "f1 = g*M*sin(q1')^2 + M*g*cos(q1')^2");
        assert!(equation_changes(new, &same).contains("1 written in another form"));
        assert!(equation_changes(old, old).contains("the same"));
        assert_eq!(equations(old)[1].1, "long formula");
    }
}
