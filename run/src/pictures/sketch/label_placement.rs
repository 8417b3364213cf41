//! Placement of labels: close to the items that they name, apart from other labels, and across as few lines
//! as possible.
//!
//! Each label has candidate places in rings around its anchor. The labels choose in turn, needed labels
//! first, and take the place of lowest cost. Then each label chooses again, twice. Costs are rounded, so
//! that machines whose last digits differ choose the same places.

use super::drawing_elements::{DrawingPoint, Label, LabelWord, Mark, MarkRole, Path, drawing_unit_vector};
use tripos_derive::algebra::text::print::name_parts;

/// Additional distance of a label's box from its anchor, px, for each ring of candidate places.
const RINGS: [f64; 10] = [0.0, 5.0, 11.0, 18.0, 27.0, 38.0, 52.0, 70.0, 92.0, 118.0];
/// Number of candidate places in each ring, in equally spaced directions.
const DIRECTIONS: usize = 24;
/// Cost of a label that covers another label. It is larger than all other costs together.
const OVERLAP: f64 = 1e5;
/// Cost from which on an optional label is left out, even at its best place.
const WORTH: f64 = 24.0;
/// Distance between a label and its item from which on a leader line joins them, px.
const LEADER: f64 = 24.0;
/// Least distance of a label from another label, px, and least distance from a line, px.
const CLEAR: (f64, f64) = (2.0, 1.0);
/// Distance between the points by which a line is represented, px.
const STEP: f64 = 2.5;
/// Height of a line of text, px.
const HIGH: f64 = 17.0;

/// Request for a label on the sheet, before its place is chosen.
#[derive(Clone, Debug)]
pub struct LabelRequest {
    /// Role of the item that the label names.
    pub role: MarkRole,
    /// Text of the label, as a list of parts.
    pub words: Vec<LabelWord>,
    /// Point of the sheet beside which the label is placed.
    pub anchor: DrawingPoint,
    /// Preferred direction from the anchor, a unit vector on the sheet; `None` for any direction.
    pub towards: Option<DrawingPoint>,
    /// Least distance of the label from the anchor, px.
    pub gap: f64,
    /// True if the label must be placed; false if it may be left out for lack of room.
    pub is_needed: bool,
}

/// Estimated width of a text, px. It is slightly too wide, because no font is available.
fn label_width(words: &[LabelWord]) -> f64 {
    let of = |word: &LabelWord| match word {
        LabelWord::Name(name) => {
            let (letters, subscript, _) = name_parts(name);
            9.0 * letters.chars().count() as f64 + 6.5 * subscript.chars().count() as f64
        }
        LabelWord::Basis(frame, _) => 9.5 * frame.chars().count() as f64 + 6.5,
        LabelWord::Plain(text) => 7.6 * text.chars().count() as f64,
        LabelWord::Minus => 8.0,
    };
    words.iter().map(of).sum::<f64>() + 1.0
}

/// Places all needed labels, and the optional labels for which there is room. Returns the labels and their
/// leader lines.
pub fn place_labels(wishes: &[LabelRequest], marks: &[Mark]) -> (Vec<Label>, Vec<Mark>) {
    let ink: Vec<(DrawingPoint, f64)> = marks.iter().flat_map(label_cost_of_mark).collect();
    let sizes: Vec<DrawingPoint> = wishes.iter().map(|wish| [label_width(&wish.words), HIGH]).collect();
    let mut order: Vec<usize> = (0..wishes.len()).collect();
    order.sort_by_key(|at| !wishes[*at].is_needed);
    let candidates: Vec<Vec<(DrawingPoint, f64)>> =
        wishes.iter().zip(&sizes).map(|(wish, size)| label_candidates(wish, *size, &ink)).collect();
    let mut chosen: Vec<Option<(DrawingPoint, f64)>> = vec![None; wishes.len()];
    for _ in 0..3 {
        for at in &order {
            chosen[*at] = None;
            let taken: Vec<(DrawingPoint, DrawingPoint)> =
                chosen.iter().zip(&sizes).filter_map(|(spot, size)| Some(((*spot)?.0, *size))).collect();
            let of = |(spot, cost): &(DrawingPoint, f64)| {
                let on = taken.iter().filter(|other| label_boxes_overlap((*spot, sizes[*at]), **other)).count();
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
        leaders.extend(leader_line(wish, *spot, *size));
    }
    (labels, leaders)
}

/// Points along the line of a mark, each with the cost of a label that covers this point.
fn label_cost_of_mark(mark: &Mark) -> Vec<(DrawingPoint, f64)> {
    let weight = match mark.role {
        MarkRole::Ground => 0.2,
        MarkRole::Support => 0.8,
        MarkRole::Reference | MarkRole::Leader => 1.0,
        MarkRole::Body | MarkRole::Spring => 1.2,
        MarkRole::Mass | MarkRole::Joint | MarkRole::Point => 3.0,
        MarkRole::Axis | MarkRole::Coordinate | MarkRole::Gravity => 2.0,
    };
    mark.path.points_along_path(STEP).into_iter().map(|spot| (spot, weight)).collect()
}

/// Candidate places of a label, each with its cost if there were no other labels. `size` is the size of the
/// label's box, px.
fn label_candidates(wish: &LabelRequest, size: DrawingPoint, ink: &[(DrawingPoint, f64)]) -> Vec<(DrawingPoint, f64)> {
    let half = size.map(|x| 0.5 * x);
    let mut list = Vec::with_capacity(RINGS.len() * DIRECTIONS);
    for (ring, further) in RINGS.iter().enumerate() {
        for direction in 0..DIRECTIONS {
            let angle = std::f64::consts::TAU * direction as f64 / DIRECTIONS as f64;
            let way = [angle.cos(), -angle.sin()];
            let gap = wish.gap + further;
            // At this distance, the box touches the circle of radius `gap` from outside.
            let reach = gap + half[0] * way[0].abs() + half[1] * way[1].abs() - 0.3 * half[1].min(half[0]);
            let spot = [0, 1].map(|i| wish.anchor[i] + reach * way[i]);
            let turned = wish.towards.map_or(0.0, |to| 1.0 - to[0] * way[0] - to[1] * way[1]);
            // Above, below and beside the anchor there is more room than in the diagonal directions.
            let slanted = 0.4 * (way[0] * way[1]).abs();
            let on: f64 =
                ink.iter().filter(|(at, _)| label_box_contains(spot, half, *at)).map(|(_, weight)| weight).sum();
            // The name of a body that is far from the body could be taken for the name of another
            // body.
            let further_cost = if wish.role == MarkRole::Body { 4.0 } else { 2.2 };
            let cost = on + further_cost * ring as f64 + 0.12 * further + 5.0 * turned + slanted;
            list.push((spot, (cost * 1e3).round() / 1e3));
        }
    }
    list
}

/// True if the point `at` is inside a box, or too close to it. The box has its middle at `middle` and half
/// the size `half`, px.
fn label_box_contains(middle: DrawingPoint, half: DrawingPoint, at: DrawingPoint) -> bool {
    (0..2).all(|i| (at[i] - middle[i]).abs() <= half[i] + CLEAR.1)
}

/// True if two boxes overlap or are too close. Each box is given by its middle and its size, px.
fn label_boxes_overlap(a: (DrawingPoint, DrawingPoint), b: (DrawingPoint, DrawingPoint)) -> bool {
    (0..2).all(|i| (a.0[i] - b.0[i]).abs() < 0.5 * (a.1[i] + b.1[i]) + CLEAR.0)
}

/// Leader line from a label at `spot` to its anchor; `None` if the label is close to its anchor.
fn leader_line(wish: &LabelRequest, spot: DrawingPoint, size: DrawingPoint) -> Option<Mark> {
    let way = [wish.anchor[0] - spot[0], wish.anchor[1] - spot[1]];
    let towards = drawing_unit_vector(way);
    let long = way[0].hypot(way[1]);
    // The leader runs from the edge of the box to just beside the anchor.
    let edge = (0..2).map(|i| 0.5 * size[i] / towards[i].abs().max(1e-9)).fold(f64::MAX, f64::min) + 1.0;
    let gap = long - edge - 3.0_f64.max(wish.gap - 4.0);
    if gap < LEADER {
        return None;
    }
    let at = |t: f64| [0, 1].map(|i| spot[i] + t * towards[i]);
    Some(Mark::line(MarkRole::Leader, Path::line(&[at(edge), at(edge + gap)])))
}
