//! Single slips in printed formulas: every one is convicted, and the slip is named.
//!
//! The slips are made in the text, by rules of this file: a sign, a number, a power, a symbol, sine for cosine, a
//! factor or a dot left out. Numbers at random states, evaluated here, tell which slips change the value.

use crate::random::Random;
use std::fmt::Write;
use std::path::Path;
use tripos_derive::algebra::text::parse::parse_primed;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::{Judgement, MistakeKind, judge_publication};
use tripos_derive::mechanics::{Quantities, Quantity, derive_all};
use tripos_derive::prove::prove;
use tripos_derive::{Formulation, Model, model, publication};

/// Models whose formulas are short enough to be printed.
const MODELS: [&str; 7] =
    ["cart_pendulum_3", "furuta", "disk", "rolling_disc", "elastic_pendulum", "satellite", "spherical_pendulum"];
/// Longest formula that is spoilt, in characters.
const LONGEST: usize = 400;
/// Number of slips in each formula.
const SLIPS: usize = 6;

/// A part of a text that is a name, a number or one other character.
pub fn tokens(text: &str) -> Vec<String> {
    let mut list: Vec<String> = Vec::new();
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '\'';
    for c in text.chars() {
        match list.last_mut() {
            Some(last) if is_word(c) && last.chars().all(is_word) => last.push(c),
            _ => list.push(c.to_string()),
        }
    }
    list
}

/// A formula with one slip at a place; `None` if the place allows none of this kind.
fn spoilt(tokens: &[String], at: usize, kind: usize, symbols: &[(String, String)]) -> Option<String> {
    let mut list = tokens.to_vec();
    let own = list[at].clone();
    let after = |text: &str| tokens.get(at + 1).is_some_and(|next| next == text);
    let before = |text: &str| at > 0 && tokens[at - 1] == text;
    match kind {
        0 if own == "+" => list[at] = "-".into(),
        0 if own == "-" => list[at] = "+".into(),
        1 if own.chars().all(|c| c.is_ascii_digit()) && !before("^") => {
            list[at] = (own.parse::<u32>().ok()? + 1).to_string();
        }
        2 if own == "^" && after("2") => drop(list.drain(at..at + 2)),
        3 if own == "sin" => list[at] = "cos".into(),
        3 if own == "cos" => list[at] = "sin".into(),
        4 => {
            let unit = &symbols.iter().find(|(name, _)| *name == own)?.1;
            let other = symbols.iter().find(|(name, its)| its == unit && *name != own)?;
            list[at].clone_from(&other.0);
        }
        5 if after("*") && symbols.iter().any(|(name, _)| *name == own) => drop(list.drain(at..at + 2)),
        6 if own.ends_with('\'') => {
            list[at].pop();
        }
        _ => return None,
    }
    Some(list.concat())
}

/// Values of a formula at three states with the same `fixed` first values, which are those of the parameters.
fn values(formula: &str, names: &[String], fixed: usize) -> Option<Vec<f64>> {
    let mut arena = Arena::new();
    let e = parse_primed(&mut arena, formula, 2, &mut |arena, name| Ok(arena.symbol(name))).ok()?;
    let symbols: Vec<_> = names.iter().map(|name| arena.symbol(name)).collect();
    let tape = Tape::new(&arena, &symbols, &[e]).ok()?;
    let value = |i: usize, k: usize| 0.37 + ((i * 7 + if i < fixed { 0 } else { k * 13 }) % 17) as f64 * 0.071;
    let state = |k: usize| (0..names.len()).map(|i| value(i, k)).collect::<Vec<_>>();
    let found: Vec<f64> = (0..3).map(|k| tape.evaluate(&state(k))[0]).collect();
    found.iter().all(|x| x.is_finite()).then_some(found)
}

fn quantities(model: &Model) -> Vec<String> {
    let mut list: Vec<String> = ["T", "V", "L"].map(str::to_owned).to_vec();
    let n = model.speeds.len();
    for i in 1..=n {
        list.push(format!("f[{i}]"));
        list.extend((1..=n).map(|j| format!("M[{i},{j}]")));
        list.push(format!("{}'", model.speeds[i - 1].name));
    }
    list
}

/// Goal: 100 % of slips are convicted, 90 % are named as a term and the right term in its place.
#[test]
fn single_slips_are_convicted_and_named() {
    let (mut made, mut convicted, mut named) = (0, 0, 0);
    let mut unnamed = String::new();
    for name in MODELS {
        let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../models")).join(name).join("model.toml");
        let mut model = model::load(&Source::read(&path).unwrap()).unwrap();
        let mut derivations = derive_all(&model).unwrap();
        let mut symbols: Vec<(String, String)> =
            model.parameters.iter().map(|p| (p.name.clone(), p.unit.to_string())).collect();
        let fixed = symbols.len();
        symbols.extend(model.coordinates.iter().map(|c| (c.name.clone(), c.unit.to_string())));
        symbols.extend(model.speeds.iter().map(|s| (s.name.clone(), s.unit.to_string())));
        let rates = model.coordinates.iter().map(|c| format!("{}'", c.name));
        let names: Vec<String> = symbols.iter().map(|(name, _)| name.clone()).chain(rates).collect();
        let mut generator = Random(41 + name.len() as u64);
        let mut file = String::new();
        let mut count = 0;
        for quantity in quantities(&model) {
            let mut derived = Quantities::new(&model, &mut derivations);
            let Ok(parsed) = Quantity::parse(&quantity, &model) else { continue };
            let Ok(value) = derived.value(&parsed) else { continue };
            let value = derived.in_speeds(value);
            let formula = print_text(&derivations.kinematics.arena, value);
            if formula.len() > LONGEST || formula == "0" {
                continue;
            }
            let (tokens, right) = (tokens(&formula), values(&formula, &names, fixed));
            let mut known = vec![formula.clone()];
            for _ in 0..40 * SLIPS {
                let (at, kind) = (generator.below(tokens.len()), generator.below(7));
                let Some(wrong) = spoilt(&tokens, at, kind, &symbols) else { continue };
                let (Some(right), Some(found)) = (&right, values(&wrong, &names, fixed)) else { continue };
                let differs = found.iter().zip(right).any(|(a, b)| (a - b).abs() > 1e-6 * b.abs().max(1e-3));
                if !differs || known.contains(&wrong) || known.len() > SLIPS {
                    continue;
                }
                // A potential that is wrong by a constant alone has another zero.
                let constant = found.iter().zip(right).map(|(a, b)| a - b).collect::<Vec<_>>();
                if ["V", "L"].contains(&quantity.as_str()) && constant.iter().all(|d| (d - constant[0]).abs() < 1e-9) {
                    continue;
                }
                count += 1;
                let _ = writeln!(
                    file,
                    "[[equation]]\nid = \"e{count}\"\nsection = \"1\"\nquantity = \"{quantity}\"\nprinted = \"{wrong}\"\nnote = \"{formula}\""
                );
                known.push(wrong);
            }
        }
        let publication = publication::load_publication(&Source::from_text("publication.toml", &file), &mut model)
            .unwrap_or_else(|e| panic!("{name}: {e}"));
        let mut derivations = derive_all(&model).unwrap();
        let proof = prove(&model, &mut derivations);
        let difference = judge_publication(&model, &mut derivations, &publication, &proof);
        for finding in &difference.findings {
            made += 1;
            convicted += usize::from(finding.judgement == Judgement::Different);
            assert_eq!(finding.judgement, Judgement::Different, "{name}: {} {finding:?}", finding.printed);
            // A formula that is set against the right one as a whole names nothing, unless it is one term whose slip is
            // known.
            let is_part = finding.change.is_some_and(|(_, right)| Some(right) != finding.derived);
            let is_term = finding.slip.is_some_and(|slip| slip != MistakeKind::LostTerm || finding.change.is_none());
            if is_part || is_term || finding.factor.is_some() {
                named += 1;
            } else {
                let _ = writeln!(unnamed, "{name}: {}\n    {:?}", finding.printed, finding.remarks);
            }
        }
    }
    println!("{made} slips, {convicted} convicted, {named} named");
    assert!(made >= 300, "{made} slips only");
    assert!(10 * named >= 9 * made, "{named} of {made} named:\n{unnamed}");
}

/// Rows of a system as equations `left = right`, in the names of the model.
pub fn equations(model: &Model, derivations: &tripos_derive::mechanics::Derivations, by: Formulation) -> Vec<String> {
    let Some(equations) = derivations.get(by) else { return Vec::new() };
    let arena = &derivations.kinematics.arena;
    let names: Vec<String> = by.unknowns(model).into_iter().map(|(name, _)| name).collect();
    let row = |(entries, right): (&Vec<Expr>, &Expr)| {
        let terms = entries.iter().zip(&names).filter(|(e, _)| **e != Expr::ZERO);
        let left: Vec<String> = terms.map(|(e, name)| format!("({})*{name}", print_text(arena, *e))).collect();
        format!("{} = {}", left.join(" + "), print_text(arena, *right))
    };
    equations.matrix.iter().zip(&equations.forcing).map(row).collect()
}

/// Goal: right work is acquitted, however it is arranged. Method: random whole combinations of rows in a random order;
/// rows times a parameter; an author's angle that is the sum of two of the model's.
#[test]
fn rearranged_systems_are_acquitted() {
    let mut rows = 0;
    for name in ["cart_pendulum_3", "furuta", "rolling_disc", "elastic_pendulum", "spherical_pendulum", "heavy_top"] {
        let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../models")).join(name).join("model.toml");
        let mut model = model::load(&Source::read(&path).unwrap()).unwrap();
        let derivations = derive_all(&model).unwrap();
        let mut random = Random(97 + name.len() as u64);
        let mut file = String::new();
        for (at, by) in [Formulation::Kane, Formulation::Lagrange].into_iter().enumerate() {
            let plain = equations(&model, &derivations, by);
            for turn in 0..6 {
                // An upper triangular matrix of whole numbers with ones on its diagonal is regular.
                let mut list: Vec<String> = (0..plain.len())
                    .map(|i| {
                        let mut sides = [String::new(), String::new()];
                        for (j, row) in plain.iter().enumerate().skip(i) {
                            let k = if i == j { "1" } else { *random.one(&["-1", "0", "1", "2"]) };
                            let (left, right) = row.split_once(" = ").unwrap();
                            for (side, part) in sides.iter_mut().zip([left, right]) {
                                let _ = write!(side, " + ({k})*({part})");
                            }
                        }
                        let factor = if turn % 2 == 0 { "3" } else { model.parameters[0].name.as_str() };
                        format!("{factor}*(0{}) = {factor}*(0{})", sides[0], sides[1])
                    })
                    .collect();
                list.rotate_left(random.below(plain.len()));
                let list: Vec<String> = list.iter().map(|row| format!("\"{row}\"")).collect();
                let _ = writeln!(
                    file,
                    "[[system]]\nid = \"s{at}{turn}\"\nsection = \"1\"\nformulation = \"{}\"\nequations = [{}]",
                    by.name(),
                    list.join(", ")
                );
            }
        }
        rows += judged_as_right(name, &mut model, &file);
    }
    assert!(rows >= 200, "{rows} rows only");
    // θ₂ of the model is the angle between two arms; the author measures both arms from the upright.
    let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../models/cart_pendulum_3/model.toml"));
    let mut model = model::load(&Source::read(path).unwrap()).unwrap();
    let derivations = derive_all(&model).unwrap();
    let [first, second] = [1, 2].map(|at| model.coordinates[at].name.clone());
    let mut file = format!("[coordinates]\nsum = \"{first} + {second}\"\n");
    for (at, row) in equations(&model, &derivations, Formulation::Lagrange).iter().enumerate() {
        let own = tokens(row).into_iter().map(|token| match token.strip_prefix(second.as_str()) {
            Some(primes) if primes.chars().all(|c| c == '\'') => format!("(sum{primes} - {first}{primes})"),
            _ => token,
        });
        let _ =
            writeln!(file, "[[equation]]\nid = \"r{at}\"\nsection = \"1\"\nprinted = \"{}\"", own.collect::<String>());
    }
    judged_as_right("sum", &mut model, &file);
}

/// Number of rows of a publication, all of which are judged as right.
pub fn judged_as_right(name: &str, model: &mut Model, file: &str) -> usize {
    let publication = publication::load_publication(&Source::from_text("publication.toml", file), model)
        .unwrap_or_else(|e| panic!("{name}: {e}"));
    let mut derivations = derive_all(model).unwrap();
    let proof = prove(model, &mut derivations);
    let difference = judge_publication(model, &mut derivations, &publication, &proof);
    for finding in &difference.findings {
        let is_right = matches!(finding.judgement, Judgement::Equal | Judgement::Scaled);
        assert!(is_right, "{name} {}: {:?} {}", finding.id, finding.judgement, finding.printed);
    }
    difference.findings.len()
}
