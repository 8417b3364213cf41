//! Root mistakes of a publication (wrong entries that cause other wrong entries), as text and as
//! JSON.

use crate::phrases::{entry_count_words, shorten_formula};
use serde_json::{Value, json};
use std::fmt::Write;
use tripos_derive::diff::{DependenceKind, DependentEntry, Difference, Finding, RootMistake};

/// Largest number of characters in a line of entry ids.
const WIDTH: usize = 120;
/// Kinds of dependence on a root mistake, in the order of the list, each with the words before the ids of the dependent
/// entries.
const LINKS: [(DependenceKind, &str); 3] = [
    (DependenceKind::Repeated, "repeated in "),
    (DependenceKind::Follows, "follows     "),
    (DependenceKind::Contradicts, "contradicts "),
];

/// Lists the root mistakes of a publication, each with the wrong entries that it causes. Empty if there are none.
pub fn root_mistake_list(difference: &Difference) -> String {
    let Difference { findings, roots, .. } = difference;
    if roots.is_empty() {
        return String::new();
    }
    let noun = if roots.len() == 1 { "root mistake" } else { "root mistakes" };
    let wrong = entry_count_words(difference.count("different"));
    let mut out = format!("\n{} {noun} behind {wrong} that differ\n", roots.len());
    for (at, root) in roots.iter().enumerate() {
        let id = &findings[root.finding].id;
        let _ = writeln!(
            out,
            "  {:2}. {id}, {}\n      {}",
            at + 1,
            entry_count_words(root.entries()),
            shorten_formula(&root.mistake)
        );
        for (link, words) in LINKS {
            let items: Vec<String> =
                root.followers_by_link(link).map(|f| wrong_entry_item(findings, root, f)).collect();
            for (line, ids) in wrap_root_mistake_ids(&items).into_iter().enumerate() {
                let words = if line == 0 { words } else { "            " };
                let _ = writeln!(out, "      {words} {ids}");
            }
        }
    }
    out
}

/// Returns the id of a wrong entry. The entries from which it follows are added, unless it follows from the root
/// itself. Further root mistakes are added, too.
fn wrong_entry_item(findings: &[Finding], root: &RootMistake, follower: &DependentEntry) -> String {
    let ids = |list: &[usize]| list.iter().map(|at| findings[*at].id.as_str()).collect::<Vec<_>>().join(" and ");
    let mut out = findings[follower.finding].id.clone();
    if follower.link == DependenceKind::Follows && follower.from != [root.finding] {
        let _ = write!(out, " (from {})", ids(&follower.from));
    }
    if !follower.also.is_empty() {
        let _ = write!(out, " (and of {})", ids(&follower.also));
    }
    out
}

/// Joins items with commas, in lines of at most `WIDTH` characters.
fn wrap_root_mistake_ids(items: &[String]) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for (at, item) in items.iter().enumerate() {
        let comma = if at + 1 < items.len() { "," } else { "" };
        match lines.last_mut().filter(|line| line.len() + item.len() + 2 <= WIDTH) {
            Some(line) => {
                let _ = write!(line, " {item}{comma}");
            }
            None => lines.push(format!("{item}{comma}")),
        }
    }
    lines
}

/// Returns words for the entries from which a wrong entry follows, and for its root mistake. `None` for an entry that
/// no root mistake causes.
pub fn cause_of_entry(difference: &Difference, finding: usize) -> Option<String> {
    let (at, follower) = difference.roots.iter().enumerate().find_map(|(at, root)| {
        let follower = root.followers.iter().find(|f| f.finding == finding)?;
        Some((at, follower))
    })?;
    let ids: Vec<&str> = follower.from.iter().map(|at| difference.findings[*at].id.as_str()).collect();
    let words = match follower.link {
        DependenceKind::Repeated => "repeats",
        DependenceKind::Follows => "follows from",
        DependenceKind::Contradicts => "contradicts",
    };
    Some(format!("{words} {}, of root mistake {}", ids.join(" and "), at + 1))
}

/// Returns the root mistakes of a publication as JSON, in the order of the publication file.
pub fn json_of(difference: &Difference) -> Vec<Value> {
    let ids = |list: &[usize]| list.iter().map(|at| difference.findings[*at].id.clone()).collect::<Vec<_>>();
    let follower = |f: &DependentEntry| {
        json!({
            "id": difference.findings[f.finding].id,
            "link": f.link.words(),
            "from": ids(&f.from),
            "also": ids(&f.also),
        })
    };
    let root = |root: &RootMistake| {
        json!({
            "id": difference.findings[root.finding].id,
            "mistake": root.mistake,
            "entries": root.entries(),
            "followers": root.followers.iter().map(follower).collect::<Vec<_>>(),
        })
    };
    difference.roots.iter().map(root).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::expect;
    use tripos_derive::diagnostic::Source;

    const PENDULUM: &str = r#"
name = "Pendulum"
[parameters]
m = { unit = "kg", positive = true }
l = { unit = "m", positive = true }
g = { unit = "m/s^2", positive = true }
[coordinates]
q = { unit = "rad" }
[speeds]
u = "q'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "q" }
[points]
P = { from = "O", frame = "A", position = [0, "-l", 0] }
[particles]
bob = { point = "P", mass = "m" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

    /// Truth: v is wrong, and T is wrong because of it. V is wrong by itself, and L has both mistakes. q is two
    /// numbers.
    const PUBLICATION: &str = r#"
[[equation]]
id = "v"
section = "1"
quantity = "v(P) @ A [1]"
printed = "2*l*u"
[[equation]]
id = "T"
section = "1"
quantity = "T"
printed = "2*m*l^2*u^2"
[[equation]]
id = "V"
section = "1"
quantity = "V"
printed = "m*g*l*(sin(q) - cos(q))"
[[equation]]
id = "L"
section = "1"
quantity = "L"
printed = "2*m*l^2*u^2 - m*g*l*(sin(q) - cos(q))"
[[equation]]
id = "L-again"
section = "2"
quantity = "L"
printed = "2*m*l^2*u^2 - m*g*l*(sin(q) - cos(q))"
[[initial]]
id = "q-text"
section = "3"
set = "text"
quantity = "q"
printed = "0.525"
[[initial]]
id = "q-program"
section = "3"
set = "program"
quantity = "q"
printed = "0.675"
"#;

    fn judged() -> Difference {
        let mut model = tripos_derive::model::load(&Source::from_text("pendulum.toml", PENDULUM)).unwrap();
        let publication = tripos_derive::publication::load_publication(
            &Source::from_text("publication.toml", PUBLICATION),
            &mut model,
        )
        .unwrap();
        let mut derivations = tripos_derive::mechanics::derive_all(&model).unwrap();
        let proof = tripos_derive::prove::prove(&model, &mut derivations);
        tripos_derive::diff::judge_publication(&model, &mut derivations, &publication, &proof)
    }

    #[test]
    fn root_mistakes_are_listed_with_what_comes_of_each() {
        expect![[r"

            3 root mistakes behind 7 entries that differ
               1. v, 4 entries
                  it is off by the factor 2
                  repeated in  L-again (and of V)
                  follows      T, L (from T and V) (and of V)
               2. V, 1 entry
                  the term m*l*g*sin(q) should not be there
               3. q-text, 2 entries
                  it contradicts other printed numbers
                  contradicts  q-program
        "]]
        .assert_eq(&root_mistake_list(&judged()));
    }

    #[test]
    fn root_mistakes_are_data() {
        let text = serde_json::to_string_pretty(&json_of(&judged())).unwrap();
        expect![[r#"
            [
              {
                "id": "v",
                "mistake": "it is off by the factor 2",
                "entries": 4,
                "followers": [
                  {
                    "id": "T",
                    "link": "follows",
                    "from": [
                      "v"
                    ],
                    "also": []
                  },
                  {
                    "id": "L",
                    "link": "follows",
                    "from": [
                      "T",
                      "V"
                    ],
                    "also": [
                      "V"
                    ]
                  },
                  {
                    "id": "L-again",
                    "link": "repeated",
                    "from": [
                      "L"
                    ],
                    "also": [
                      "V"
                    ]
                  }
                ]
              },
              {
                "id": "V",
                "mistake": "the term m*l*g*sin(q) should not be there",
                "entries": 1,
                "followers": []
              },
              {
                "id": "q-text",
                "mistake": "it contradicts other printed numbers",
                "entries": 2,
                "followers": [
                  {
                    "id": "q-program",
                    "link": "contradicts",
                    "from": [
                      "q-text"
                    ],
                    "also": []
                  }
                ]
              }
            ]"#]]
        .assert_eq(&text);
    }

    #[test]
    fn an_entry_names_what_it_hangs_on() {
        let difference = judged();
        let words: Vec<String> =
            (0..difference.findings.len()).filter_map(|at| cause_of_entry(&difference, at)).collect();
        expect![[r"
            follows from v, of root mistake 1
            follows from T and V, of root mistake 1
            repeats L, of root mistake 1
            contradicts q-text, of root mistake 3"]]
        .assert_eq(&words.join("\n"));
    }
}
