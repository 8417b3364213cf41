//! Where labels stand: near what they name, on no other label, and on as few lines as may be.
//!
//! Each label has candidates in rings about its anchor. One after another takes the cheapest, the dearest needs first; then each is
//! taken up and set down again, twice. Costs are rounded, so that machines whose last digits differ place alike.

use super::drawing::{Label, Mark, Path, Role, Spot, Word, unit};
use tripos_derive::algebra::print::name_parts;

/// How far the box of a label is from its anchor in each ring, px, beside what it asks for.
const RINGS: [f64; 10] = [0.0, 5.0, 11.0, 18.0, 27.0, 38.0, 52.0, 70.0, 92.0, 118.0];
/// Directions of candidates.
const DIRECTIONS: usize = 24;
/// What a label on another costs: more than all else.
const OVERLAP: f64 = 1e5;
/// What is left out rather than placed at more than this.
const WORTH: f64 = 24.0;
/// From how far on a line leads to what is named, px.
const LEADER: f64 = 24.0;
/// How near a label may come to another and to a line, px.
const CLEAR: (f64, f64) = (2.0, 1.0);
/// A line counts by spots this far apart, px.
const STEP: f64 = 2.5;
/// How high a line of words is, px.
const HIGH: f64 = 17.0;

/// A label that is to be placed.
#[derive(Clone, Debug)]
pub struct Wish {
    /// What it names.
    pub role: Role,
    /// What it says.
    pub words: Vec<Word>,
    /// What it stands beside.
    pub anchor: Spot,
    /// In which direction from there, if that matters.
    pub towards: Option<Spot>,
    /// How far from there at least, px.
    pub gap: f64,
    /// Whether it may be left out where there is no room.
    pub is_needed: bool,
}

/// The width of words, px: a little wide, as no font is at hand.
fn width(words: &[Word]) -> f64 {
    let of = |word: &Word| match word {
        Word::Name(name) => {
            let (letters, subscript, _) = name_parts(name);
            9.0 * letters.chars().count() as f64 + 6.5 * subscript.chars().count() as f64
        }
        Word::Basis(frame, _) => 9.5 * frame.chars().count() as f64 + 6.5,
        Word::Plain(text) => 7.6 * text.chars().count() as f64,
        Word::Minus => 8.0,
    };
    words.iter().map(of).sum::<f64>() + 1.0
}

/// Labels of all wishes that are needed and of those for which there is room, and lines to what is far from its label.
pub fn placed(wishes: &[Wish], marks: &[Mark]) -> (Vec<Label>, Vec<Mark>) {
    let ink: Vec<(Spot, f64)> = marks.iter().flat_map(ink).collect();
    let sizes: Vec<Spot> = wishes.iter().map(|wish| [width(&wish.words), HIGH]).collect();
    let mut order: Vec<usize> = (0..wishes.len()).collect();
    order.sort_by_key(|at| !wishes[*at].is_needed);
    let candidates: Vec<Vec<(Spot, f64)>> =
        wishes.iter().zip(&sizes).map(|(wish, size)| candidates(wish, *size, &ink)).collect();
    let mut chosen: Vec<Option<(Spot, f64)>> = vec![None; wishes.len()];
    for _ in 0..3 {
        for at in &order {
            chosen[*at] = None;
            let taken: Vec<(Spot, Spot)> =
                chosen.iter().zip(&sizes).filter_map(|(spot, size)| Some(((*spot)?.0, *size))).collect();
            let of = |(spot, cost): &(Spot, f64)| {
                let on = taken.iter().filter(|other| overlaps((*spot, sizes[*at]), **other)).count();
                (*spot, cost + OVERLAP * on as f64)
            };
            let best = candidates[*at].iter().map(of).min_by(|a, b| a.1.total_cmp(&b.1));
            chosen[*at] = best.filter(|(_, cost)| wishes[*at].is_needed || *cost < WORTH);
        }
    }
    let (mut labels, mut leaders) = (Vec::new(), Vec::new());
    for ((wish, size), spot) in wishes.iter().zip(&sizes).zip(&chosen) {
        let Some((spot, _)) = spot else { continue };
        labels.push(Label { role: wish.role, words: wish.words.clone(), at: *spot, size: *size });
        leaders.extend(leader(wish, *spot, *size));
    }
    (labels, leaders)
}

/// Spots of a line with how much a label on each costs.
fn ink(mark: &Mark) -> Vec<(Spot, f64)> {
    let weight = match mark.role {
        Role::Ground => 0.2,
        Role::Support => 0.8,
        Role::Reference | Role::Leader => 1.0,
        Role::Body | Role::Spring => 1.2,
        Role::Mass | Role::Joint | Role::Point => 3.0,
        Role::Axis | Role::Coordinate | Role::Gravity => 2.0,
    };
    mark.path.spots(STEP).into_iter().map(|spot| (spot, weight)).collect()
}

/// Where a label may stand, and what that costs beside other labels.
fn candidates(wish: &Wish, size: Spot, ink: &[(Spot, f64)]) -> Vec<(Spot, f64)> {
    let half = size.map(|x| 0.5 * x);
    let mut list = Vec::with_capacity(RINGS.len() * DIRECTIONS);
    for (ring, further) in RINGS.iter().enumerate() {
        for direction in 0..DIRECTIONS {
            let angle = std::f64::consts::TAU * direction as f64 / DIRECTIONS as f64;
            let way = [angle.cos(), -angle.sin()];
            let gap = wish.gap + further;
            // The box touches the circle of this radius from outside.
            let reach = gap + half[0] * way[0].abs() + half[1] * way[1].abs() - 0.3 * half[1].min(half[0]);
            let spot = [0, 1].map(|i| wish.anchor[i] + reach * way[i]);
            let turned = wish.towards.map_or(0.0, |to| 1.0 - to[0] * way[0] - to[1] * way[1]);
            // Along the sides of a box there is more room than at its corners.
            let slanted = 0.4 * (way[0] * way[1]).abs();
            let on: f64 = ink.iter().filter(|(at, _)| holds(spot, half, *at)).map(|(_, weight)| weight).sum();
            // The name of a body that is far from it would be taken for that of another.
            let further_cost = if wish.role == Role::Body { 4.0 } else { 2.2 };
            let cost = on + further_cost * ring as f64 + 0.12 * further + 5.0 * turned + slanted;
            list.push((spot, (cost * 1e3).round() / 1e3));
        }
    }
    list
}

fn holds(middle: Spot, half: Spot, at: Spot) -> bool {
    (0..2).all(|i| (at[i] - middle[i]).abs() <= half[i] + CLEAR.1)
}

/// Whether two boxes, by middle and size, lie on one another.
fn overlaps(a: (Spot, Spot), b: (Spot, Spot)) -> bool {
    (0..2).all(|i| (a.0[i] - b.0[i]).abs() < 0.5 * (a.1[i] + b.1[i]) + CLEAR.0)
}

/// A line to what is named, where the label is far from it.
fn leader(wish: &Wish, spot: Spot, size: Spot) -> Option<Mark> {
    let way = [wish.anchor[0] - spot[0], wish.anchor[1] - spot[1]];
    let towards = unit(way);
    let long = way[0].hypot(way[1]);
    // From the edge of the box to just beside the anchor.
    let edge = (0..2).map(|i| 0.5 * size[i] / towards[i].abs().max(1e-9)).fold(f64::MAX, f64::min) + 1.0;
    let gap = long - edge - 3.0_f64.max(wish.gap - 4.0);
    if gap < LEADER {
        return None;
    }
    let at = |t: f64| [0, 1].map(|i| spot[i] + t * towards[i]);
    Some(Mark::line(Role::Leader, Path::line(&[at(edge), at(edge + gap)])))
}
