//! Rearrangements of equations of random mechanisms: right work is acquitted, however it is written.
//!
//! The rearrangements are made in the text, by rules of this file: sums and multiples of rows, sides swapped, products
//! multiplied out, half angles and other identities of trigonometry, angles of the author.

use crate::mechanisms::Mechanism;
use crate::mutations::{equations, judged_as_right, tokens};
use crate::random::Random;
use std::collections::BTreeMap;
use std::fmt::Write;
use tripos_derive::algebra::Arena;
use tripos_derive::algebra::form::normal_form::Normalizer;
use tripos_derive::algebra::text::parse::parse_primed;
use tripos_derive::algebra::text::print::print_whole_text;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::derive_all;
use tripos_derive::{Formulation, Model, model};

/// Number of rearranged systems.
const SYSTEMS: usize = 220;
/// Longest system that is rearranged, in characters.
const LONGEST: usize = 1500;

/// Kinds of rearrangements.
const KINDS: [&str; 8] =
    ["sums of rows", "scaled", "swapped", "expanded", "half angles", "shifted", "tangents", "own coordinate"];

/// A text in which each sine and cosine, with its argument in parentheses, is rewritten by a rule.
fn rewritten(text: &str, rule: &dyn Fn(&str, &str) -> String) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = ["sin(", "cos("].iter().filter_map(|name| rest.find(name)).min() {
        out += &rest[..at];
        let (name, inside) = (&rest[at..at + 3], &rest[at + 4..]);
        let mut depth = 1;
        let end = inside
            .char_indices()
            .find_map(|(i, c)| {
                depth += i32::from(c == '(') - i32::from(c == ')');
                (depth == 0).then_some(i)
            })
            .expect("a closing parenthesis");
        let _ = write!(out, "({})", rule(name, &inside[..end]));
        rest = &inside[end + 1..];
    }
    out + rest
}

/// Numerator of a formula, multiplied out; `None` if it is too long.
fn expanded(formula: &str) -> Option<String> {
    let mut arena = Arena::new();
    let e = parse_primed(&mut arena, formula, 2, &mut |arena, name| Ok(arena.symbol(name))).ok()?;
    let mut normalizer = Normalizer::new(20_000);
    let form = normalizer.normal_form(&mut arena, e)?;
    let numerator = normalizer.polynomial(&form.numerator).expand(&mut arena);
    Some(print_whole_text(&arena, numerator))
}

/// Rows of a system, rearranged.
fn rearranged(rows: &[String], kind: &str, model: &Model, random: &mut Random) -> Option<Vec<String>> {
    let sides = |row: &String| {
        let (left, right) = row.split_once(" = ").expect("an equation");
        (left.to_owned(), right.to_owned())
    };
    let both = |rule: &dyn Fn(&str) -> Option<String>| -> Option<Vec<String>> {
        rows.iter().map(sides).map(|(left, right)| Some(format!("{} = {}", rule(&left)?, rule(&right)?))).collect()
    };
    match kind {
        "sums of rows" => {
            let mut list = Vec::new();
            for i in 0..rows.len() {
                let (mut left, mut right) = sides(&rows[i]);
                for row in &rows[i + 1..] {
                    let k = *random.one(&["1", "-1", "2", "0", "1/2"]);
                    let (a, b) = sides(row);
                    let _ = write!(left, " + ({k})*({a})");
                    let _ = write!(right, " + ({k})*({b})");
                }
                list.push(format!("{left} = {right}"));
            }
            Some(list)
        }
        "scaled" => {
            let factor = random.one(&model.parameters).name.clone();
            both(&|side| Some(format!("({side})*{factor}^2/3")))
        }
        "swapped" => Some(rows.iter().map(sides).map(|(a, b)| format!("0 = {a} - ({b})")).collect()),
        "expanded" => {
            let zero = |row: &String| {
                let (left, right) = sides(row);
                Some(format!("{} = 0", expanded(&format!("{left} - ({right})"))?))
            };
            rows.iter().map(zero).collect()
        }
        "half angles" => both(&|side| {
            Some(rewritten(side, &|name, x| match name {
                "sin" => format!("2*sin(({x})/2)*cos(({x})/2)"),
                _ => format!("1 - 2*sin(({x})/2)^2"),
            }))
        }),
        "shifted" => both(&|side| {
            Some(rewritten(side, &|name, x| match name {
                "sin" => format!("-cos({x} + pi/2)"),
                _ => format!("sin({x} + pi/2)"),
            }))
        }),
        "tangents" => both(&|side| {
            Some(rewritten(side, &|name, x| match name {
                "sin" => format!("tan({x})*cos({x})"),
                _ => format!("1/sec({x})"),
            }))
        }),
        _ => unreachable!(),
    }
}

/// Rows in a coordinate of the author, which is a sum or a multiple of the model's, and its declaration.
fn in_own_coordinate(rows: &[String], model: &Model, random: &mut Random) -> Option<(String, Vec<String>)> {
    let plain: Vec<&String> = model.coordinates.iter().map(|c| &c.name).filter(|name| *name != "t").collect();
    let q = (*random.one_of(&plain)?).clone();
    let unit = |name: &str| model.coordinates.iter().find(|c| c.name == name).map(|c| c.unit.to_string());
    let other = plain.iter().find(|name| ***name != q && unit(name) == unit(&q));
    let (own, back) = match other {
        Some(other) if random.chance(60) => (format!("{q} + {other}"), format!("own - {other}")),
        _ => (format!("-2*{q}"), "-own/2".to_owned()),
    };
    let primed = |back: &str, primes: &str| {
        tokens(back)
            .into_iter()
            .map(
                |token| if token == "own" || plain.iter().any(|name| **name == token) { token + primes } else { token },
            )
            .collect::<String>()
    };
    let list = rows.iter().map(|row| {
        tokens(row)
            .into_iter()
            .map(|token| match token.strip_prefix(q.as_str()) {
                Some(primes) if primes.chars().all(|c| c == '\'') => format!("({})", primed(&back, primes)),
                _ => token,
            })
            .collect::<String>()
    });
    Some((format!("[coordinates]\nown = \"{own}\"\n"), list.collect()))
}

/// Goal: right work is acquitted, however it is arranged. Method: equations of random mechanisms by Kane's method and
/// by Lagrange's equations, each system rearranged by one rule.
#[test]
fn rearranged_equations_of_random_mechanisms_are_acquitted() {
    let mut made: BTreeMap<&str, usize> = BTreeMap::new();
    let mut total = 0;
    for seed in 1000.. {
        if total >= SYSTEMS {
            break;
        }
        let mut random = Random(seed);
        let mechanism = Mechanism::new(&mut random);
        let read = || model::load(&Source::from_text("model.toml", &mechanism.text));
        let Ok(model) = read() else { continue };
        let Ok(derivations) = derive_all(&model) else { continue };
        for by in [Formulation::Kane, Formulation::Lagrange] {
            let rows = equations(&model, &derivations, by);
            if rows.is_empty() || rows.concat().len() > LONGEST {
                continue;
            }
            let kind = KINDS[total % KINDS.len()];
            let (head, list) = if kind == "own coordinate" {
                let Some(own) = in_own_coordinate(&rows, &model, &mut random) else { continue };
                own
            } else {
                let Some(list) = rearranged(&rows, kind, &model, &mut random) else { continue };
                (String::new(), list)
            };
            let list: Vec<String> = list.iter().map(|row| format!("\"{row}\"")).collect();
            let file = format!(
                "{head}[[system]]\nid = \"s\"\nsection = \"1\"\nformulation = \"{}\"\nequations = [{}]\n",
                by.name(),
                list.join(", ")
            );
            let mut model = read().unwrap();
            judged_as_right(&format!("{seed}, {}, {kind}", by.name()), &mut model, &file);
            *made.entry(kind).or_default() += 1;
            total += 1;
        }
    }
    println!("{made:?}");
    assert!(KINDS.iter().all(|kind| made.get(kind).is_some_and(|count| *count >= 20)), "{made:?}");
}
