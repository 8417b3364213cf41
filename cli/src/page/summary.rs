//! Abstract of the page: the mechanism, the proofs, the mistakes in print, the outcome of the runs, and the recommended
//! way to run it.
//!
//! Invariant: every sentence is made of values and links to its evidence on the page. Absent on purpose: sentences that
//! only one model could need.

use crate::chart::sentences::{TARGETS, seconds};
use crate::page::content::{Choice, Page, SceneSection};
use crate::page::markup::html::{anchor, count, escape, link, listed, number, rounded};
use crate::page::markup::math::{length, vanishing};
use crate::page::print::verdict::abstract_of_verdict;
use crate::page::scenes::outcome::{self, Grade, title};
use std::cmp::Reverse;
use tripos_derive::Formulation;
use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::prove::{Singularity, There};

/// Largest number of scenes with troubles that the abstract names.
const MOST_SCENES: usize = 3;
/// Largest number of characters of a formula in a sentence.
const SHORT: usize = 40;

/// Pair of the id of a sentence's evidence on the page, and the sentence as HTML.
type Sentence = (String, String);

/// HTML of the abstract.
pub fn section(page: &Page) -> String {
    let verdict = page.study.published.iter().flat_map(|published| {
        let title = escape(published.publication.heading());
        let said = abstract_of_verdict(&published.difference).into_iter();
        said.enumerate()
            .map(move |(at, (place, said))| (place.to_owned(), if at == 0 { format!("{title}. {said}") } else { said }))
    });
    let rows = [
        ("Mechanism", vec![mechanism(page)]),
        (
            "Proved",
            [equality(page), Some(integrals(page)), Some(validity(page)), determinants(page)]
                .into_iter()
                .flatten()
                .collect(),
        ),
        ("In print", verdict.collect()),
        ("Simulated", simulated(page)),
        ("To run it", recommended(page)),
    ];
    let row = |(what, sentences): &(&str, Vec<Sentence>)| {
        let said: Vec<String> = sentences.iter().map(|(place, said)| link(place, said)).collect();
        format!("<div><dt>{what}</dt><dd>{}</dd></div>\n", said.join(" "))
    };
    let rows: String = rows.iter().filter(|(_, sentences)| !sentences.is_empty()).map(row).collect();
    format!("<section id=\"abstract\" aria-label=\"Abstract\">\n{}<dl>\n{rows}</dl>\n</section>\n", drawing(page))
}

/// HTML of the sketch of the mechanism, or of the reason why there is none.
fn drawing(page: &Page) -> String {
    match &page.sketch {
        Ok(drawing) => {
            format!("<figure>\n{}\n<figcaption>{}</figcaption>\n</figure>\n", drawing.svg, escape(&drawing.caption))
        }
        Err(why) => format!("<p class=\"missing\">There is no sketch of it: {}.</p>\n", escape(why)),
    }
}

fn mechanism(page: &Page) -> Sentence {
    let model = page.model;
    let clock = usize::from(model.time().is_some());
    let holonomic = model.constraints.len() + model.loops.len() + model.closed.len();
    let others = model.motion_constraints.len() - model.loops.len() - clock;
    let particles = model.bodies.iter().filter(|body| body.rigid.is_none()).count();
    let some = |n: usize, one: &str| Some(count(n, one)).filter(|_| n > 0);
    let rigid = match model.bodies.len() - particles {
        0 => None,
        1 => Some("1 rigid body".to_owned()),
        n => Some(format!("{n} rigid bodies")),
    };
    let bodies = [rigid, some(particles, "particle")];
    let bodies: Vec<String> = bodies.into_iter().flatten().collect();
    let numbers = [
        Some(count(model.coordinates.len() - clock, "coordinate")),
        Some(count(model.speeds.len(), "generalized speed")),
        some(holonomic, "holonomic constraint"),
        some(others, "nonholonomic constraint"),
    ];
    let numbers: Vec<String> = numbers.into_iter().flatten().collect();
    let freedom = match model.speeds.len() {
        1 => "one degree of freedom".to_owned(),
        n => format!("{n} degrees of freedom"),
    };
    ("mechanism".to_owned(), format!("{} with {freedom}: {}.", capital(&listed(&bodies)), listed(&numbers)))
}

fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn titles(list: impl IntoIterator<Item = Formulation>) -> String {
    listed(&list.into_iter().map(|formulation| escape(formulation.title())).collect::<Vec<_>>())
}

/// Sentence on the equivalence of the formulations; `None` if no formulation could be derived.
fn equality(page: &Page) -> Option<Sentence> {
    let proof = &page.study.proof;
    let all = proof.pairs.len();
    let proved = proof.pairs.iter().filter(|pair| pair.verdict.is_equal()).count();
    let said = if all == 0 {
        let only = page.derivations.iter().find(|(_, result)| result.is_ok())?.0;
        format!("Derived by {} alone.", titles([only]))
    } else if proof.is_equivalent() {
        let derived =
            Formulation::ALL.into_iter().filter(|f| proof.pairs.iter().any(|p| p.left == *f || p.right == *f));
        format!("{} give the same equations of motion.", titles(derived))
    } else {
        let different = proof.pairs.iter().filter(|pair| matches!(pair.verdict, Verdict::Different(_))).count();
        let open = all - proved - different;
        format!(
            "Of {} of formulations {proved} are proved to say the same, {different} differ, {open} are undecided.",
            count(all, "pair")
        )
    };
    Some(("equality".to_owned(), said))
}

fn integrals(page: &Page) -> Sentence {
    let list = &page.study.proof.integrals;
    let energies = list.iter().filter(|integral| integral.is_energy()).count();
    let momenta = list.len() - energies;
    let kinds = [
        (energies > 0).then(|| "the energy".to_owned()),
        match momenta {
            0 => None,
            1 => Some("a momentum".to_owned()),
            n => Some(format!("{n} momenta")),
        },
    ];
    let kinds: Vec<String> = kinds.into_iter().flatten().collect();
    let said = match list.len() {
        0 => "No first integral is found.".to_owned(),
        n => format!("{}: {}.", capital(&count(n, "first integral")), listed(&kinds)),
    };
    ("integrals".to_owned(), said)
}

/// HTML of words for the places where one of several terms is zero; long terms are only counted.
fn where_zero(arena: &Arena, terms: &[Expr]) -> String {
    let is_short = |e: &Expr| length(arena, *e).is_some_and(|characters| characters <= SHORT);
    let mut places: Vec<String> = terms.iter().filter(|e| is_short(e)).map(|e| vanishing(arena, *e)).collect();
    match terms.len() - places.len() {
        0 => {}
        1 => places.push("a long term vanishes".to_owned()),
        n => places.push(format!("one of {n} long terms vanishes")),
    }
    places.join(" or ")
}

fn validity(page: &Page) -> Sentence {
    let proof = &page.study.proof;
    let arena = &page.study.derivations.kinematics.arena;
    let said = if proof.singular_where.is_empty() {
        "The equations hold everywhere.".to_owned()
    } else {
        format!("The equations hold except where {}.", where_zero(arena, &proof.singular_where))
    };
    ("equality".to_owned(), said)
}

/// Sentence on where the matrix of each formulation is singular; `None` if that is known for no formulation.
fn determinants(page: &Page) -> Option<Sentence> {
    let arena = &page.study.derivations.kinematics.arena;
    let mut groups: Vec<(String, Vec<Formulation>)> = Vec::new();
    for (formulation, singularity) in &page.study.singular {
        let Some(place) = zeros(arena, singularity) else { continue };
        match groups.iter_mut().find(|(known, _)| *known == place) {
            Some((_, list)) => list.push(*formulation),
            None => groups.push((place, vec![*formulation])),
        }
    }
    let group = |(place, list): (String, Vec<Formulation>)| format!("{place} by {}", titles(list));
    let said: Vec<String> = groups.into_iter().map(group).collect();
    (!said.is_empty())
        .then(|| ("singular".to_owned(), format!("The matrix of the accelerations is singular {}.", said.join(", "))))
}

/// HTML of words for the proved zeros of a determinant: everywhere, nowhere, or where terms vanish; `None` if no zero
/// is known.
fn zeros(arena: &Arena, singularity: &Singularity) -> Option<String> {
    if singularity.determinant == Expr::ZERO {
        return Some("everywhere".to_owned());
    }
    if singularity.never {
        return Some("nowhere".to_owned());
    }
    let zero = singularity.at.iter().filter(|place| place.determinant == There::Zero);
    let terms: Vec<Expr> = zero.map(|place| place.divisor).collect();
    (!terms.is_empty()).then(|| format!("where {}", where_zero(arena, &terms)))
}

/// Sentences on the scenes with troubles, on the number of the others, and on the printed equations in the shown scene.
fn simulated(page: &Page) -> Vec<Sentence> {
    let is_troubled = |scene: &SceneSection| outcome::worst(scene) != Some(Grade::Arrived);
    let mut troubled: Vec<(usize, &SceneSection)> =
        page.scenes.iter().enumerate().filter(|(_, scene)| is_troubled(scene)).collect();
    troubled.sort_by_key(|(_, scene)| Reverse(outcome::worst(scene)));
    let said =
        |(at, scene): &(usize, &SceneSection)| (anchor(*at), format!("{}: {}", title(scene), outcome::derived(scene)));
    let mut list: Vec<Sentence> = troubled.iter().take(MOST_SCENES).map(said).collect();
    let others = page.scenes.len() - troubled.len();
    if troubled.len() > MOST_SCENES {
        let more = count(troubled.len() - MOST_SCENES, "more scene");
        list.push(("simulation".to_owned(), format!("So it is in {more}.")));
    }
    if let (true, [scene]) = (troubled.is_empty(), page.scenes.as_slice()) {
        list.push((anchor(0), format!("{}: {}", title(scene), outcome::derived(scene))));
    } else if others > 0 {
        let what = if troubled.is_empty() { "scene" } else { "other scene" };
        let verb = if others == 1 { "runs to its end" } else { "run to their ends" };
        list.push(("simulation".to_owned(), format!("{} {verb} without an objection.", capital(&count(others, what)))));
    }
    let shown = page.moving.as_ref().map_or(0, |moving| moving.scene);
    let scene = page.scenes.get(shown).filter(|_| page.study.published.is_some());
    let printed =
        scene.and_then(|scene| Some((anchor(shown), format!("{}: {}", title(scene), outcome::printed(scene)?))));
    list.extend(printed);
    list
}

/// Sentence on the equations, the method and the tolerance that were measured to be the fastest. Without a measurement:
/// the saving by a scene's reduced equations.
fn recommended(page: &Page) -> Vec<Sentence> {
    let measured = page.scenes.iter().enumerate().find_map(|(at, scene)| Some((at, scene, scene.advice.as_ref()?)));
    if let Some((at, scene, advice)) = measured {
        let chosen = |target: f64| advice.rows.iter().find(|(error, _)| error.total_cmp(&target).is_eq())?.1.as_ref();
        let best = [TARGETS[1], TARGETS[0]].into_iter().find_map(|target| Some((target, chosen(target)?)));
        if let Some((target, choice)) = best {
            return vec![(format!("{}-advice", anchor(at)), fastest(scene, target, choice))];
        }
    }
    let shown = page.moving.as_ref().map_or(0, |moving| moving.scene);
    page.scenes.get(shown).map_or_else(Vec::new, |scene| vec![(format!("{}-needs", anchor(shown)), own(page, scene))])
}

fn fastest(scene: &SceneSection, target: f64, choice: &Choice) -> String {
    let tolerance =
        choice.tolerance.map_or_else(String::new, |tolerance| format!(" --rtol {tolerance:e} --atol {tolerance:e}"));
    format!(
        "Measured on {}: an error of {} is reached fastest, in {}, by <code>tripos simulate {} --by {} --method {}{tolerance}</code>.",
        title(scene),
        number(&format!("{target:e}")),
        seconds(choice.seconds),
        escape(&scene.file),
        escape(&choice.equations),
        choice.method,
    )
}

/// HTML of the command that runs a scene, with the number of states that its reduced equations keep.
fn own(page: &Page, scene: &SceneSection) -> String {
    let command = format!("<code>tripos simulate {}</code>", escape(&scene.file));
    let Ok(needs) = &scene.needs else { return format!("{command}.") };
    let all = page.model.coordinates.len() + page.model.speeds.len();
    let gain = needs.costs.full.operations as f64 / needs.costs.scene.operations.max(1) as f64;
    let kept = needs.reduced.reduction.states.len();
    let gain =
        if gain > 1.05 { format!(", {} times fewer operations a call", rounded(gain, 2)) } else { String::new() };
    format!("{command}: the scene's reduced equations keep {kept} of {}{gain}.", count(all, "state"))
}
