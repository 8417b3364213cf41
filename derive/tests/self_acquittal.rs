//! Self-acquittal: what Tripos derives for random mechanisms, printed and read as a publication, is judged as right.

use crate::mechanisms::{ELEMENTS, Mechanism};
use crate::random::Random;
use std::collections::BTreeMap;
use std::fmt::Write;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::algebra::solve::linear::{linear_row_term, solve_linear};
use tripos_derive::algebra::text::print::print_whole_text;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::{Difference, Judgement, judge_publication};
use tripos_derive::mechanics::{Derivations, Kinematics, Quantities, Quantity, derive_all};
use tripos_derive::model::MotionConstraintKind;
use tripos_derive::prove::prove;
use tripos_derive::{Formulation, Model, model, publication};

/// Number of mechanisms that are judged: `TRIPOS_RANDOM_MECHANISMS`, else 300.
fn count() -> usize {
    std::env::var("TRIPOS_RANDOM_MECHANISMS").ok().and_then(|text| text.parse().ok()).unwrap_or(300)
}

/// Longest publication that is judged, in characters.
const LONGEST: usize = 9_000;

/// Publication of what is derived for a model: energies and systems by each formulation, M and f, rates and
/// accelerations.
fn printed(model: &Model, derivations: &mut Derivations) -> String {
    let mut file = String::new();
    let mut count = 0;
    let mut entry = |file: &mut String, quantity: &str, value: String| {
        count += 1;
        let _ = writeln!(
            file,
            "[[equation]]\nid = \"e{count}\"\nsection = \"1\"\nquantity = \"{quantity}\"\nprinted = \"{value}\""
        );
    };
    for formulation in Formulation::ALL {
        let Some(e) = derivations.get(formulation) else { continue };
        let arena = &derivations.kinematics.arena;
        let shown = |e: Expr| print_whole_text(arena, e);
        entry(&mut file, "T", shown(e.kinetic_energy));
        entry(&mut file, "V", shown(e.potential_energy));
        entry(&mut file, "L", format!("{} - ({})", shown(e.kinetic_energy), shown(e.potential_energy)));
        let list = |row: &[Expr]| row.iter().map(|e| format!("\"{}\"", shown(*e))).collect::<Vec<_>>().join(", ");
        let rows: Vec<String> = e.matrix.iter().map(|row| format!("[{}]", list(row))).collect();
        let unknowns: Vec<String> =
            formulation.unknowns(model).into_iter().map(|(name, _)| format!("\"{name}\"")).collect();
        if unknowns.is_empty() {
            continue;
        }
        let frame = if formulation.has_reactions() { "frame = \"N\"\n" } else { "" };
        let _ = writeln!(
            file,
            "[[system]]\nid = \"{0}\"\nsection = \"1\"\nformulation = \"{0}\"\n{frame}unknowns = [{1}]\nmatrix = [{2}]\nright = [{3}]",
            formulation.name(),
            unknowns.join(", "),
            rows.join(", "),
            list(&e.forcing)
        );
    }
    let n = model.speeds.len();
    let mut names: Vec<String> = (1..=n).map(|i| format!("f[{i}]")).collect();
    names.extend((1..=n).flat_map(|i| (1..=n).map(move |j| format!("M[{i},{j}]"))));
    names.extend(model.coordinates.iter().filter(|c| c.name != "t").map(|c| format!("{}'", c.name)));
    if n == 1 {
        names.push(format!("{}'", model.speeds[0].name));
    }
    for name in names {
        let mut quantities = Quantities::new(model, derivations);
        let Ok(quantity) = Quantity::parse(&name, model) else { continue };
        let Ok(value) = quantities.value(&quantity) else { continue };
        entry(&mut file, &name, print_whole_text(&derivations.kinematics.arena, value));
    }
    file
}

/// Verdicts on a publication about a mechanism.
fn verdicts(model: &mut Model, file: &str, mechanism: &Mechanism) -> Difference {
    let publication = publication::load_publication(&Source::from_text("publication.toml", file), model)
        .unwrap_or_else(|e| panic!("{e}\n{}", mechanism.text));
    let mut derivations = derive_all(model).unwrap();
    let proof = prove(model, &mut derivations);
    judge_publication(model, &mut derivations, &publication, &proof)
}

/// Goal: right work is acquitted, whatever the mechanism is. Method: T, V, L, M, f, rates and the equations of motion
/// by every formulation, as they are derived, are read as a publication of the same model.
#[test]
fn random_mechanisms_are_acquitted_of_their_own_equations() {
    let (mut judged, mut entries, mut refused, mut long) = (0, 0, 0, 0);
    let mut elements: BTreeMap<&str, usize> = ELEMENTS.iter().map(|name| (*name, 0)).collect();
    let mut wrong = String::new();
    for seed in 0.. {
        if judged == count() {
            break;
        }
        assert!(refused < count(), "too many mechanisms are refused");
        let mechanism = Mechanism::new(&mut Random(seed));
        let Ok(mut model) = model::load(&Source::from_text("model.toml", &mechanism.text)) else {
            refused += 1;
            continue;
        };
        let Ok(mut derivations) = derive_all(&model) else {
            refused += 1;
            continue;
        };
        let file = printed(&model, &mut derivations);
        if file.len() > LONGEST {
            long += 1;
            continue;
        }
        let difference = verdicts(&mut model, &file, &mechanism);
        for finding in &difference.findings {
            entries += 1;
            // Balances have components in frames of their own, and are combinations of those in one frame.
            let is_right = match finding.judgement {
                Judgement::Equal => true,
                Judgement::Scaled => finding.id.starts_with("newton-euler"),
                _ => false,
            };
            if !is_right {
                let _ = writeln!(
                    wrong,
                    "{seed} {:?}: {}: {:?} {}",
                    mechanism.elements,
                    finding.id,
                    finding.judgement,
                    &finding.printed[..finding.printed.len().min(300)]
                );
            }
        }
        for system in &difference.consequences {
            let is_large = matches!(&system.accelerations, Verdict::Undecided(why) if why.contains("too large"));
            if !system.accelerations.is_equal() && !is_large {
                let _ =
                    writeln!(wrong, "{seed} {:?}: {}: {:?}", mechanism.elements, system.system, system.accelerations);
            }
        }
        judged += 1;
        for element in &mechanism.elements {
            *elements.get_mut(element).unwrap() += 1;
        }
    }
    println!("{judged} mechanisms, {entries} entries; {refused} refused, {long} too long; {elements:?}");
    assert!(wrong.is_empty(), "{wrong}");
    if count() >= 300 {
        let rare: Vec<_> = elements.iter().filter(|(_, count)| **count < 3).collect();
        assert!(rare.is_empty(), "{rare:?}");
    }
}

/// Most unknowns of a system that is solved for each of them.
const MOST_UNKNOWNS: usize = 4;

/// A printed equation `unknown = value`.
struct Solved {
    id: String,
    text: String,
    is_right: bool,
}

/// Equations that are solved for each unknown, by each formulation: right ones, and those with the other sign. The
/// values are checked in the derived rows, which the solution has no part in.
fn solved(model: &Model, derivations: &mut Derivations) -> Vec<Solved> {
    let mut list = Vec::new();
    let time = model.time().map(|at| model.coordinates[at].second_rate);
    let clocks = model.motion_constraints.iter().filter(|c| c.kind == MotionConstraintKind::Clock);
    let of_time: Vec<Expr> = time.into_iter().chain(clocks.map(|c| c.multiplier)).collect();
    for formulation in Formulation::STANDARD {
        let Some(e) = derivations.get(formulation).cloned() else { continue };
        if e.unknowns.len() > MOST_UNKNOWNS || e.matrix.len() != e.unknowns.len() {
            continue;
        }
        let Kinematics { arena, simplifier, .. } = &mut derivations.kinematics;
        let right: Vec<Vec<Expr>> = e.forcing.iter().map(|right| vec![*right]).collect();
        let Ok((values, _)) = solve_linear(arena, simplifier, &e.matrix, &right) else { continue };
        let values: Vec<Expr> = values.into_iter().map(|value| value[0]).collect();
        for (row, right) in e.matrix.iter().zip(&e.forcing) {
            let residual = linear_row_term(arena, &values, &[&row[..], &[*right]].concat());
            assert_ne!(zero_test(arena, residual), ZeroTest::NonZero, "{}", formulation.name());
        }
        for ((name, unknown), value) in formulation.unknowns(model).iter().zip(values) {
            if value == Expr::ZERO || of_time.contains(unknown) {
                continue;
            }
            let value = print_whole_text(arena, value);
            for (is_right, value) in [(true, value.clone()), (false, format!("-({value})"))] {
                let (id, by) = (format!("e{}", list.len()), formulation.name());
                let text = format!(
                    "[[equation]]\nid = \"{id}\"\nsection = \"1\"\nformulation = \"{by}\"\nprinted = \"{name} = {value}\"\n"
                );
                list.push(Solved { id, text, is_right });
            }
        }
    }
    list
}

/// Goal: equations that are solved for one unknown are judged by the value of this unknown. Method: accelerations,
/// reactions and multipliers of random mechanisms, solved for, and the same with the other sign.
#[test]
fn solved_equations_of_random_mechanisms_are_judged_rightly() {
    let (mut judged, mut entries, mut wrong) = (0, 0, String::new());
    for seed in 5000.. {
        if judged >= count() / 5 {
            break;
        }
        let mechanism = Mechanism::new(&mut Random(seed));
        let Ok(mut model) = model::load(&Source::from_text("model.toml", &mechanism.text)) else { continue };
        let Ok(mut derivations) = derive_all(&model) else { continue };
        let list = solved(&model, &mut derivations);
        let file: String = list.iter().map(|one| one.text.as_str()).collect();
        if list.is_empty() || file.len() > LONGEST {
            continue;
        }
        for finding in &verdicts(&mut model, &file, &mechanism).findings {
            entries += 1;
            let printed = list.iter().find(|one| one.id == finding.id).unwrap();
            let is_right = matches!(finding.judgement, Judgement::Equal | Judgement::Scaled);
            let is_named = finding.factor == Some(Expr::MINUS_ONE) || finding.wrong.is_some();
            if is_right != printed.is_right || !(is_right || is_named) {
                let (elements, text) = (&mechanism.elements, &printed.text);
                let (judgement, remarks) = (&finding.judgement, &finding.remarks);
                let _ = writeln!(wrong, "{seed} {elements:?}: {judgement:?} {remarks:?}\n{text}");
            }
        }
        judged += 1;
    }
    println!("{judged} mechanisms, {entries} entries");
    assert!(wrong.is_empty(), "{wrong}");
}
