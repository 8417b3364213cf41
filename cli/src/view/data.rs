//! Data of a view for its viewer, as JSON.
//!
//! Invariant: positions and orientations are whole multiples of a step that is too small to be visible. They are
//! written as differences from one instant to the next. The sums of the differences are exact, and the file is short.

use super::{LiveEquations, ViewContent, ViewPlace};
use serde_json::{Map, Value, json};
use tripos::pictures::view::{
    ForceArrows, ForceSource, Quaternion, Solid, SolidForm, SolidPlace, Triple, ViewMotion, quaternion,
};

/// Steps of the data: of positions, relative to the size of the mechanism, and of Euler parameters.
const STEPS: (f64, f64) = (5e-5, 1e-4);
/// Step of the data of forces, relative to the usual force of the motion.
const FORCE: f64 = 1e-4;
/// Step of the data of times, relative to the span.
const TIME: f64 = 1e-6;
/// Number of points of a mechanism up to which all points are included in the data.
const MOST_POINTS: usize = 60;
/// Estimated number of bytes that a number takes in the data.
const NUMBER: usize = 4;

/// Returns JSON as text for the content of a `<script>` element. The text cannot end the element.
pub fn as_script(value: &Value) -> String {
    value.to_string().replace('<', "\\u003c").replace('\u{2028}', "\\u2028").replace('\u{2029}', "\\u2029")
}

/// Points and frames of the mechanism that the viewer needs. The data refer to them by their index
/// in these lists.
struct ViewDataParts {
    /// Indices of the points in the model, in ascending order.
    points: Vec<usize>,
    /// Indices of the frames in the model, in ascending order.
    frames: Vec<usize>,
}

impl ViewDataParts {
    /// Collects the points and frames that the solids, traces, axes and forces of a view use.
    fn of_view(seen: &ViewContent<'_>) -> Self {
        let view = &seen.view;
        let mut points: Vec<usize> = view.solids.iter().flat_map(|solid| solid.form.points()).collect();
        points.extend(view.traced.iter().chain(view.triads.iter().map(|(_, point)| point)));
        points.extend(seen.mechanism.bodies.iter().map(|body| body.centre));
        if seen.mechanism.points.len() <= MOST_POINTS {
            points.extend(0..seen.mechanism.points.len());
        }
        let first = seen.motions.first().map(|motion| &motion.forces);
        points.extend(first.iter().flat_map(|forces| forces.list.iter().map(|arrow| arrow.point)));
        let places = view.solids.iter().filter_map(|solid| place_of_form(&solid.form));
        let mut frames: Vec<usize> = places.map(|place| place.frame).collect();
        frames.extend(view.triads.iter().map(|(frame, _)| frame));
        for list in [&mut points, &mut frames] {
            list.sort_unstable();
            list.dedup();
        }
        Self { points, frames }
    }

    /// Returns the index in the data of the model's point with index `point`.
    fn point(&self, point: usize) -> usize {
        self.points.binary_search(&point).unwrap_or_default()
    }

    /// Returns the index in the data of the model's frame with index `frame`.
    fn frame(&self, frame: usize) -> usize {
        self.frames.binary_search(&frame).unwrap_or_default()
    }
}

/// Returns the frame and position of a solid's form; `None` for a form between two points.
fn place_of_form(form: &SolidForm) -> Option<&SolidPlace> {
    match form {
        SolidForm::Sphere { at, .. }
        | SolidForm::Cylinder { at, .. }
        | SolidForm::Box { at, .. }
        | SolidForm::Ground { at } => Some(at),
        SolidForm::Rod { .. } | SolidForm::Spring { .. } => None,
    }
}

/// Returns the largest number of frames of each motion whose data have at most `bytes` bytes.
fn frames_within_bytes(seen: &ViewContent<'_>, kept: &ViewDataParts, bytes: usize) -> usize {
    let forces = seen.motions.first().map_or(0, |motion| motion.forces.list.len());
    let each = (3 * kept.points.len() + 4 * kept.frames.len() + 1) * seen.motions.len() + 3 * forces;
    (bytes / (each * NUMBER)).max(2)
}

/// True if the frames that fit into `bytes` bytes are close enough in time to show correctly how every body rotates.
pub fn turns_truly(seen: &ViewContent<'_>, bytes: usize) -> bool {
    let most = frames_within_bytes(seen, &ViewDataParts::of_view(seen), bytes);
    seen.motions.iter().all(|m| m.has_true_rotations(&m.thin_motion(seen.view.size, most).0))
}

/// Returns all data of a view for the viewer as JSON, with motions of about `bytes` bytes.
pub fn figure_data(seen: &ViewContent<'_>, live: &LiveEquations, home: ViewPlace, bytes: usize) -> Value {
    let kept = ViewDataParts::of_view(seen);
    let live = match live {
        LiveEquations::Runs(running) => running.shown(&kept.points, &kept.frames),
        LiveEquations::Rests(_) => Value::Null,
    };
    let (mechanism, view) = (seen.mechanism, &seen.view);
    let most = frames_within_bytes(seen, &kept, bytes);
    let thinned: Vec<ViewMotion> = seen.motions.iter().map(|m| m.thin_motion(view.size, most).0).collect();
    let motions: Vec<Value> = thinned.iter().map(|m| motion(m, &kept, view.size)).collect();
    let follow = mechanism.bodies.iter().map(|body| json!([body.name, kept.point(body.centre)]));
    let names = |list: &[usize]| list.iter().map(|at| mechanism.points[*at].name.clone()).collect::<Vec<_>>();
    json!({
        "scene": seen.title,
        "alone": home == ViewPlace::Alone,
        "stated": view.is_stated,
        "inertial": mechanism.frames.first().map_or_else(String::new, |frame| frame.name.to_lowercase()),
        "up": view.up,
        "plane": view.plane,
        "size": view.size,
        "place": STEPS.0 * view.size,
        "turn": STEPS.1,
        "points": names(&kept.points),
        "follow": follow.collect::<Vec<_>>(),
        "traced": view.traced.iter().map(|point| kept.point(*point)).collect::<Vec<_>>(),
        "triads": view.triads.iter().map(|(frame, point)| [kept.frame(*frame), kept.point(*point)]).collect::<Vec<_>>(),
        "solids": view.solids.iter().map(|each| solid(each, &kept)).collect::<Vec<_>>(),
        "arrows": thinned.first().map_or(Value::Null, |first| arrows(&first.forces, &kept)),
        "motions": motions,
        "live": live,
    })
}

/// Returns the forces of a motion as JSON: kind, name and point of each force, and its components in whole steps.
fn arrows(forces: &ForceArrows, kept: &ViewDataParts) -> Value {
    let step = FORCE * forces.usual;
    let list = forces.list.iter().enumerate().map(|(at, arrow)| {
        let values: Vec<Triple> = forces.values.iter().map(|now| now[at]).collect();
        let kind = match arrow.kind {
            ForceSource::Weight => "weight",
            ForceSource::Applied => "applied",
            ForceSource::Reaction => "reaction",
        };
        json!({ "kind": kind, "name": arrow.name, "point": kept.point(arrow.point), "values": stored_differences(&values, step) })
    });
    json!({ "usual": forces.usual, "cut": ForceArrows::CUT, "step": step, "list": list.collect::<Vec<_>>() })
}

/// Returns a solid as JSON: its form, dimensions, body and place.
fn solid(solid: &Solid, kept: &ViewDataParts) -> Value {
    let mut out = Map::new();
    let mut put = |key: &str, value: Value| out.insert(key.to_owned(), value);
    put("label", json!(solid.label));
    put("body", json!(solid.body));
    put("reach", json!(short(solid.form.reach())));
    if let Some(at) = place_of_form(&solid.form) {
        put("frame", json!(kept.frame(at.frame)));
        put("point", json!(kept.point(at.point)));
        put("position", json!(at.position.map(short)));
        put("turned", json!(at.turned.map(short)));
    }
    match &solid.form {
        SolidForm::Sphere { radius, .. } => {
            put("kind", json!("sphere"));
            put("radius", json!(short(*radius)));
        }
        SolidForm::Cylinder { radius, length, .. } => {
            put("kind", json!("cylinder"));
            put("radius", json!(short(*radius)));
            put("length", json!(short(*length)));
        }
        SolidForm::Box { size, .. } => {
            put("kind", json!("box"));
            put("size", json!(size.map(short)));
        }
        SolidForm::Rod { ends, radius } => {
            put("kind", json!("rod"));
            put("ends", json!(ends.map(|end| kept.point(end))));
            put("radius", json!(short(*radius)));
        }
        SolidForm::Spring { ends } => {
            put("kind", json!("spring"));
            put("ends", json!(ends.map(|end| kept.point(end))));
        }
        SolidForm::Ground { .. } => {
            put("kind", json!("ground"));
        }
    }
    Value::Object(out)
}

/// Rounds a number to six significant decimal digits, to shorten the data.
fn short(x: f64) -> f64 {
    format!("{x:.5e}").parse().unwrap_or(x)
}

/// Returns a motion as JSON: times, positions of points and orientations of frames, in whole steps. `size` is the size
/// of the mechanism, m.
fn motion(motion: &ViewMotion, kept: &ViewDataParts, size: f64) -> Value {
    let (from, to) = (motion.t.first().copied().unwrap_or_default(), motion.t.last().copied().unwrap_or_default());
    let span = (to - from).abs();
    let dt = if span > 0.0 { TIME * span } else { TIME };
    let points = kept.points.iter().map(|point| {
        let places: Vec<Triple> = motion.poses.iter().map(|pose| pose.points[*point]).collect();
        stored_differences(&places, STEPS.0 * size)
    });
    let frames = kept.frames.iter().map(|frame| {
        let mut turns: Vec<Quaternion> = motion.poses.iter().map(|pose| quaternion(&pose.rotations[*frame])).collect();
        for at in 1..turns.len() {
            // Euler parameters of opposite signs describe the same rotation. The nearer sign is chosen, so that
            // differences are small.
            let same: f64 = turns[at].iter().zip(&turns[at - 1]).map(|(a, b)| a * b).sum();
            if same < 0.0 {
                turns[at] = turns[at].map(|x| -x);
            }
        }
        stored_differences(&turns, STEPS.1)
    });
    let t: Vec<[f64; 1]> = motion.t.iter().map(|t| [t - from]).collect();
    json!({
        "title": motion.title,
        "ending": motion.ending,
        "objections": motion.objections,
        "from": from,
        "dt": dt,
        "t": differences_in_steps(&t, dt),
        "points": points.collect::<Vec<_>>(),
        "frames": frames.collect::<Vec<_>>(),
    })
}

/// Returns values as differences in whole steps. Values that never change are written only once.
fn stored_differences<const N: usize>(values: &[[f64; N]], step: f64) -> Vec<i64> {
    let mut list = differences_in_steps(values, step);
    if list.iter().skip(N).all(|change| *change == 0) {
        list.truncate(N);
    }
    list
}

/// Returns values as differences in whole steps from one instant to the next.
#[allow(clippy::cast_possible_truncation, reason = "some 1e5 steps, and a place beyond all of them stays at the edge")]
fn differences_in_steps<const N: usize>(values: &[[f64; N]], step: f64) -> Vec<i64> {
    let mut before = [0; N];
    let mut list = Vec::with_capacity(N * values.len());
    for value in values {
        let now = value.map(|x| (x / step).round() as i64);
        list.extend(now.iter().zip(before).map(|(now, before)| now - before));
        before = now;
    }
    list
}

#[cfg(test)]
mod tests {
    use super::{as_script, differences_in_steps, stored_differences};
    use serde_json::json;

    /// Goal: sums of differences equal the positions to half a step. Method: the differences of a path there and back
    /// are added up.
    #[test]
    fn differences_add_up_to_what_was_written() {
        let places: Vec<[f64; 2]> = (0..500).map(|k| [(f64::from(k) * 0.1).sin(), 3.0 - f64::from(k)]).collect();
        let (step, mut sum) = (1e-3, [0_i64; 2]);
        for (pair, place) in differences_in_steps(&places, step).chunks(2).zip(&places) {
            for axis in 0..2 {
                sum[axis] += pair[axis];
                assert!((sum[axis] as f64 * step - place[axis]).abs() <= 0.5 * step * (1.0 + 1e-9));
            }
        }
        assert_eq!(stored_differences(&[[1.0, 2.0]; 9], 0.5), [2, 4]);
    }

    #[test]
    fn data_cannot_end_their_script() {
        let text = as_script(&json!({ "title": "</script><script>alert(1)</script><!--" }));
        assert!(!text.contains('<'), "{text}");
        assert_eq!(
            serde_json::from_str::<serde_json::Value>(&text).unwrap()["title"],
            "</script><script>alert(1)</script><!--"
        );
    }
}
