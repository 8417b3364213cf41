//! Abstract of the page: mechanism, proofs, mistakes in print, outcome of the runs, and the recommended command to run
//! a scene.
//!
//! Invariant: at most eight short sentences, which can be read aloud in 40 seconds. Every sentence is made from values,
//! and links to its evidence on the page. No sentence is written for a single model, and none contains ids of printed
//! entries.

use crate::chart::sentences::TARGETS;
use crate::page::content::{ClaimOutcome, Page, RecommendedRun, SceneSection};
use crate::page::markup::formula_mathml::{length, zero_formula_mathml};
use crate::page::markup::html::{escape, link, list_names, number, rounded_number_html};
use crate::page::print::verdict::abstract_of_verdict;
use crate::page::scenes::outcome::{self, RunOutcome, title};
use crate::page::scenes::scene::scene_anchor;
use crate::phrases::{counted_noun, seconds};
use tripos_derive::Formulation;
use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::algebra::{Arena, Expr};

/// Largest number of characters of a formula in a sentence of the abstract.
const SHORT: usize = 40;

/// Sentence of the abstract: the id of its evidence on the page, then its HTML.
type Sentence = (String, String);

/// Returns the HTML section with the abstract.
pub fn section(page: &Page) -> String {
    let verdict = page.study.published.iter().flat_map(|published| {
        let title = escape(published.publication.heading());
        let said = abstract_of_verdict(&published.difference).into_iter();
        said.enumerate()
            .map(move |(at, (place, said))| (place.to_owned(), if at == 0 { format!("{title}: {said}") } else { said }))
    });
    let rows = [
        ("Mechanism", vec![mechanism(page)]),
        ("Proved", [equality(page), Some(integrals(page))].into_iter().flatten().collect()),
        ("In print", verdict.collect()),
        ("Simulated", simulation_sentence(page).into_iter().collect()),
        ("To run it", recommendation_sentence(page)),
    ];
    let row = |(what, sentences): &(&str, Vec<Sentence>)| {
        let said: Vec<String> = sentences.iter().map(|(place, said)| link(place, said)).collect();
        format!("<div><dt>{what}</dt><dd>{}</dd></div>\n", said.join(" "))
    };
    let rows: String = rows.iter().filter(|(_, sentences)| !sentences.is_empty()).map(row).collect();
    format!("<section id=\"abstract\" aria-label=\"Abstract\">\n{}<dl>\n{rows}</dl>\n</section>\n", drawing(page))
}

/// Returns the HTML of the sketch of the mechanism, or of the reason why there is none.
fn drawing(page: &Page) -> String {
    match &page.sketch {
        Ok(drawing) => {
            format!("<figure>\n{}\n<figcaption>{}</figcaption>\n</figure>\n", drawing.svg, escape(&drawing.caption))
        }
        Err(why) => format!("<p class=\"missing\">There is no sketch of it: {}.</p>\n", escape(why)),
    }
}

/// Returns the sentence about the mechanism: bodies, degrees of freedom and constraints.
fn mechanism(page: &Page) -> Sentence {
    let model = page.model;
    let clock = usize::from(model.time().is_some());
    let holonomic = model.constraints.len() + model.loops.len() + model.closed.len();
    let others = model.motion_constraints.len() - model.loops.len() - clock;
    let particles = model.bodies.iter().filter(|body| body.rigid.is_none()).count();
    let some = |n: usize, one: &str| Some(counted_noun(n, one)).filter(|_| n > 0);
    let rigid = match model.bodies.len() - particles {
        0 => None,
        1 => Some("1 rigid body".to_owned()),
        n => Some(format!("{n} rigid bodies")),
    };
    let bodies = [rigid, some(particles, "particle")];
    let bodies: Vec<String> = bodies.into_iter().flatten().collect();
    let constraints = [some(holonomic, "holonomic constraint"), some(others, "nonholonomic constraint")];
    let constraints: Vec<String> = constraints.into_iter().flatten().collect();
    let constraints =
        if constraints.is_empty() { String::new() } else { format!(" under {}", list_names(&constraints)) };
    let freedom = match model.speeds.len() {
        1 => "one degree of freedom".to_owned(),
        n => format!("{n} degrees of freedom"),
    };
    ("mechanism".to_owned(), format!("{} with {freedom}{constraints}.", capitalize(&list_names(&bodies))))
}

/// Returns a text whose first letter is a capital.
fn capitalize(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// Returns the titles of formulations as a list within a sentence.
fn abstract_formulation_titles(list: impl IntoIterator<Item = Formulation>) -> String {
    list_names(&list.into_iter().map(|formulation| escape(formulation.title())).collect::<Vec<_>>())
}

/// Returns the sentence about the equivalence of the formulations and the states in which they hold. `None` if no
/// formulation could be derived.
fn equality(page: &Page) -> Option<Sentence> {
    let proof = &page.study.proof;
    let all = proof.pairs.len();
    let proved = proof.pairs.iter().filter(|pair| pair.verdict.is_equal()).count();
    let (said, many) = if all == 0 {
        let only = page.derivations.iter().find(|(_, result)| result.is_ok())?.0;
        (format!("{} gives the equations of motion", abstract_formulation_titles([only])), "which hold")
    } else if proof.is_equivalent() {
        let derived =
            Formulation::ALL.into_iter().filter(|f| proof.pairs.iter().any(|p| p.left == *f || p.right == *f));
        (format!("{} give the same equations of motion", abstract_formulation_titles(derived)), "which hold")
    } else {
        let different = proof.pairs.iter().filter(|pair| matches!(pair.verdict, Verdict::Different(_))).count();
        let open = all - proved - different;
        let said = format!(
            "Of {} of formulations, {proved} are proved equal, {different} differ and {open} are undecided",
            counted_noun(all, "pair")
        );
        (said, "and the equations hold")
    };
    Some(("equality".to_owned(), format!("{said}, {many} {}.", abstract_validity(page))))
}

/// Returns the sentence about the first integrals.
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
        n => format!("The motion has {}: {}.", counted_noun(n, "first integral"), list_names(&kinds)),
    };
    ("integrals".to_owned(), said)
}

/// Returns, as HTML, a description of the places where one of several terms is zero. Only the number of long terms is
/// given.
fn abstract_zero_places(arena: &Arena, terms: &[Expr]) -> String {
    let is_short = |e: &Expr| length(arena, *e).is_some_and(|characters| characters <= SHORT);
    let mut places: Vec<String> =
        terms.iter().filter(|e| is_short(e)).map(|e| zero_formula_mathml(arena, *e)).collect();
    match terms.len() - places.len() {
        0 => {}
        1 => places.push("a long term vanishes".to_owned()),
        n => places.push(format!("one of {n} long terms vanishes")),
    }
    places.join(" or ")
}

/// Returns, as HTML, a description of the configurations in which the equations hold.
fn abstract_validity(page: &Page) -> String {
    let proof = &page.study.proof;
    let arena = &page.study.derivations.kinematics.arena;
    if proof.singular_where.is_empty() {
        "everywhere".to_owned()
    } else {
        format!("except where {}", abstract_zero_places(arena, &proof.singular_where))
    }
}

/// Returns the sentence about the outcome of the scenes; `None` if the page has no scenes.
fn simulation_sentence(page: &Page) -> Option<Sentence> {
    if let [scene] = page.scenes.as_slice() {
        return Some((scene_anchor(0), format!("{}: {}", title(scene), outcome::derived_outcome(scene))));
    }
    let all = page.scenes.len();
    let of =
        |grade: RunOutcome| page.scenes.iter().filter(|scene| outcome::worst_outcome(scene) == Some(grade)).count();
    let none = page.scenes.iter().filter(|scene| outcome::worst_outcome(scene).is_none()).count();
    let said = |n: usize, one: &str, many: &str| (n > 0).then(|| format!("{n} {}", if n == 1 { one } else { many }));
    let kinds = [
        said(of(RunOutcome::Stopped), "has a run that fails", "have runs that fail"),
        said(of(RunOutcome::Loose), "needs tighter tolerances", "need tighter tolerances"),
        said(of(RunOutcome::Ended), "ends early at an event", "end early at events"),
        said(of(RunOutcome::Arrived), "runs to its end without a warning", "run to their ends without a warning"),
        said(none, "does not run", "do not run"),
    ];
    let kinds: Vec<String> = kinds.into_iter().flatten().collect();
    let said = format!("Of {}, {}{}.", counted_noun(all, "scene"), list_names(&kinds), judged_claims(page));
    (all > 0).then(|| ("simulation".to_owned(), said))
}

/// Returns the end of the sentence about scenes: how many claims about motions are proved, and how many are refuted.
/// Empty if no scene has a claim.
fn judged_claims(page: &Page) -> String {
    let outcomes = || page.scenes.iter().flat_map(|scene| &scene.claims).map(|claim| &claim.outcome);
    let proved = outcomes().filter(|outcome| matches!(outcome, ClaimOutcome::Proved)).count();
    let refuted = outcomes().filter(|outcome| matches!(outcome, ClaimOutcome::Refuted { .. })).count();
    match outcomes().count() {
        0 => String::new(),
        all => format!("; of {} about motions, {proved} are proved and {refuted} refuted", counted_noun(all, "claim")),
    }
}

/// Returns the sentences about the fastest measured equations, method and tolerance. Without a measurement, they say
/// how much a scene's reduced equations save.
fn recommendation_sentence(page: &Page) -> Vec<Sentence> {
    let measured = page.scenes.iter().enumerate().find_map(|(at, scene)| Some((at, scene, scene.advice.as_ref()?)));
    if let Some((at, scene, advice)) = measured {
        let chosen = |target: f64| advice.rows.iter().find(|(error, _)| error.total_cmp(&target).is_eq())?.1.as_ref();
        let best = [TARGETS[1], TARGETS[0]].into_iter().find_map(|target| Some((target, chosen(target)?)));
        if let Some((target, choice)) = best {
            return vec![(format!("{}-advice", scene_anchor(at)), abstract_fastest_run(scene, target, choice))];
        }
    }
    let shown = page.moving.as_ref().map_or(0, |moving| moving.scene);
    page.scenes.get(shown).map_or_else(Vec::new, |scene| {
        vec![(format!("{}-needs", scene_anchor(shown)), abstract_reduced_run(page, scene))]
    })
}

/// Returns the HTML of a sentence with the command for the fastest run whose error is at most `target`.
fn abstract_fastest_run(scene: &SceneSection, target: f64, choice: &RecommendedRun) -> String {
    let tolerance =
        choice.tolerance.map_or_else(String::new, |tolerance| format!(" --rtol {tolerance:e} --atol {tolerance:e}"));
    format!(
        "The fastest run to an error of {} takes {}: <code>tripos simulate {} --by {} --method {}{tolerance}</code>.",
        number(&format!("{target:e}")),
        seconds(choice.seconds),
        escape(&scene.file),
        escape(&choice.equations),
        choice.method,
    )
}

/// Returns the HTML of the command that runs a scene, with the number of states in the scene's reduced equations.
fn abstract_reduced_run(page: &Page, scene: &SceneSection) -> String {
    let command = format!("<code>tripos simulate {}</code>", escape(&scene.file));
    let Ok(needs) = &scene.needs else { return format!("{command}.") };
    let all = page.model.coordinates.len() + page.model.speeds.len();
    let gain = needs.costs.full.operations as f64 / needs.costs.scene.operations.max(1) as f64;
    let kept = needs.reduced.reduction.states.len();
    let gain = if gain > 1.05 {
        format!(" and {} times fewer operations", rounded_number_html(gain, 2))
    } else {
        String::new()
    };
    format!("{command} integrates the motion with {kept} of {}{gain}.", counted_noun(all, "state"))
}
