//! Sketch of a mechanism as in textbooks: bodies, frames, coordinates, gravity and supports, on one sheet.
//!
//! ```
//! use tripos::Scene;
//! use tripos::pictures::sketch::Sketch;
//!
//! let scene = Scene::read("../models/pendulum/scenes/swing.toml")?;
//! let sketch = Sketch::of_scene(scene.mechanism(), scene.description())?;
//! assert!(sketch.about.contains("theta (rod from hanging) turns B about n3"));
//! # Ok::<(), tripos::Error>(())
//! ```
//!
//! Invariant: the same numbers give the same sheet. Values that could depend on the last digits of a machine are
//! rounded before they decide anything. The renderer chooses colours, fonts and file formats.

mod angles;
mod axes;
mod body_outlines;
mod camera;
mod dimension_lines;
mod drawing_elements;
mod drawn_pose;
mod label_placement;
mod model_start;
mod pose_formulas;
mod sheet;
mod sketch_description;
mod sketch_subject;
mod supports;

pub use drawing_elements::{DrawingPoint, Label, LabelWord, Mark, MarkRole, PaintKind, Path, PathPart};
pub use drawn_pose::ChangedCoordinate;

use super::view::space::dot;
use super::view::{Configuration, Pose, Poses, SolidForm, View};
use crate::error::Error;
use crate::mechanism::Mechanism;
use angles::{Angle, Arcs};
use camera::Camera;
use dimension_lines::Length;
use model_start::start_without_scene;
use pose_formulas::PoseFormulas;
use sheet::Sheet;
use sketch_description::{CoordinateMark, MarkedCoordinate};
use sketch_subject::SketchSubject;
use tripos_derive::model::TIME;
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::scene::{Scene, State};

/// Greatest width and height of the bodies on the sheet of a sketch, px.
const ROOM: (f64, f64) = (340.0, 280.0);
/// Width of the empty margin around a sketch, px.
const MARGIN: f64 = 8.0;
/// Number of poses, far from the drawn pose, that serve to find the fixed points.
const FAR: usize = 5;

/// Sketch of a mechanism in one pose: marks and labels on a sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Sketch {
    /// Title of the sketched mechanism.
    pub title: String,
    /// Text that describes the drawing, in sentences.
    pub about: String,
    /// Values of the coordinates in the drawn pose, as a sentence.
    pub drawn: String,
    /// Width and height of the sheet, px. All marks and labels lie within the sheet.
    pub size: DrawingPoint,
    /// Lines and areas of the sketch, from back to front.
    pub marks: Vec<Mark>,
    /// Labels in front of the marks. No label covers another.
    pub labels: Vec<Label>,
    /// Coordinates that are drawn at other values than at the start, because their marks could not be seen
    /// there.
    pub changed: Vec<ChangedCoordinate>,
}

/// Values of the parameters and coordinates in the drawn pose.
struct DrawnState<'a> {
    /// Values of the parameters, in the order of the model.
    parameters: &'a [f64],
    /// Values of the coordinates, in the order of the model.
    q: Vec<f64>,
    /// Coordinates whose values were changed to make their marks visible.
    changed: Vec<ChangedCoordinate>,
    /// Name of the pose for the description, such as `the start of swing.toml`.
    of: String,
}

impl Sketch {
    /// Draws a mechanism at the start of a scene. Angles and lengths that could not be seen at the start
    /// are drawn at other values, unless the mechanism has loops.
    ///
    /// # Errors
    /// [`Error::Request`] if a shape has a length that is not positive, or if the place of a frame or point
    /// is not a finite number at this start.
    pub fn of_scene(mechanism: &Mechanism, scene: &Scene) -> Result<Self, Error> {
        let name = path_as_plain_text(&scene.source.path);
        let of = if name.is_empty() {
            "the start of the scene".to_owned()
        } else {
            format!("the start of {}", file_name_of_path(&name))
        };
        Self::at_visible_pose(mechanism, Configuration { parameters: &scene.parameters, q: &scene.q }, of)
    }

    /// Draws a mechanism without a scene, at the parameter values of the model file. The pose shows all
    /// marks.
    ///
    /// # Errors
    /// Errors of [`Self::of_scene`]. Also [`Error::Request`] if a parameter has no value, or if no pose
    /// closes the loops.
    pub fn of_model(mechanism: &Mechanism) -> Result<Self, Error> {
        let (parameters, q) = start_without_scene(mechanism)?;
        Self::at_visible_pose(
            mechanism,
            Configuration { parameters: &parameters, q: &q },
            "the model by itself".to_owned(),
        )
    }

    /// Draws a mechanism in exactly the given state.
    ///
    /// # Errors
    /// Errors of [`Self::of_scene`].
    pub fn at_state(mechanism: &Mechanism, state: &State) -> Result<Self, Error> {
        let (terms, poses) = (PoseFormulas::new(mechanism)?, Poses::new(mechanism)?);
        let of = "the state that was asked for".to_owned();
        let given = DrawnState { parameters: &state.parameters, q: state.q.clone(), changed: Vec::new(), of };
        Self::new(mechanism, &terms, &poses, given)
    }

    /// Draws a mechanism in a pose in which every mark is visible. Coordinates that would hide a mark are
    /// changed. `of` is the name of the original pose, for the description.
    ///
    /// # Errors
    /// Errors of `Self::of_scene`.
    fn at_visible_pose(mechanism: &Mechanism, at: Configuration<'_>, of: String) -> Result<Self, Error> {
        let (terms, poses) = (PoseFormulas::new(mechanism)?, Poses::new(mechanism)?);
        let (q, changed) = drawn_pose::drawn_coordinates(mechanism, &terms, &poses, at)?;
        Self::new(mechanism, &terms, &poses, DrawnState { parameters: at.parameters, q, changed, of })
    }

    /// Draws a mechanism in exactly the given pose.
    ///
    /// # Errors
    /// `Error::Request` if the place of a frame or point is not a finite number in this pose.
    fn new(mechanism: &Mechanism, terms: &PoseFormulas, poses: &Poses, given: DrawnState<'_>) -> Result<Self, Error> {
        let at = Configuration { parameters: given.parameters, q: &given.q };
        let pose = poses.pose_at(given.parameters, &given.q);
        if !pose.is_finite() {
            let help = "give another state by --at, or another scene";
            return Err(Error::request("the place of a frame or point is not a finite number at this start", help));
        }
        let view = View::of_poses(mechanism, at, &[std::slice::from_ref(&pose)])?;
        let far = distant_poses(poses, at);
        let camera = Camera::camera_along_normal([0.0, 0.0, 1.0], view.up);
        let mut subject = SketchSubject {
            mechanism,
            terms,
            poses,
            p: given.parameters,
            q: &given.q,
            pose: &pose,
            far: &far,
            view: &view,
            camera,
            is_planar: false,
        };
        choose_sketch_camera(&mut subject, at)?;
        let mut sheet = Sheet::default();
        body_outlines::draw_solids(&subject, &mut sheet);
        supports::draw_supports(&subject, &mut sheet);
        add_points_to_sheet(&subject, &mut sheet);
        let shown = add_coordinates_to_sheet(&subject, &mut sheet);
        axes::draw_axes(&subject, &mut sheet);
        axes::draw_gravity_arrow(&subject, &mut sheet);
        add_body_names_to_sheet(&subject, &mut sheet);
        let about = sketch_description::describe_sketch(&subject, &shown);
        let drawn = sketch_description::describe_pose_of_sketch(&subject, &given.changed, &given.of);
        let (size, marks, labels) = finish_sheet(sheet);
        Ok(Self { title: mechanism.title.clone(), about, drawn, size, marks, labels, changed: given.changed })
    }
}

/// Name of a file without its folders.
fn file_name_of_path(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

/// Makes poses at coordinates far from a configuration. A point at the same place in all of them counts as
/// fixed.
fn distant_poses(poses: &Poses, at: Configuration<'_>) -> Vec<Pose> {
    let moved = |step: usize| {
        // The shares are multiples of irrational numbers, the same on every machine.
        let share = |k: usize| ((k + 1) as f64 * 0.754_877_666 + (step + 1) as f64 * 0.569_840_291).fract();
        at.q.iter().enumerate().map(|(k, q)| q + 0.15 + 0.9 * share(k)).collect::<Vec<f64>>()
    };
    let all = (0..FAR).map(|step| poses.pose_at(at.parameters, &moved(step)));
    all.filter(Pose::is_finite).collect()
}

/// Chooses the camera of a sketch, its direction of view and its scale, and stores it in `subject`.
///
/// # Errors
/// `Error::Request` if the view of the mechanism cannot be made.
fn choose_sketch_camera(subject: &mut SketchSubject<'_>, at: Configuration<'_>) -> Result<(), Error> {
    let moving: Vec<Pose> = std::iter::once(subject.pose.clone()).chain(subject.far.iter().cloned()).collect();
    let plane = View::of_poses(subject.mechanism, at, &[&moving])?.plane;
    let angles: Vec<Angle> = (0..subject.q.len()).filter_map(|c| Angle::of(subject, c)).collect();
    let turns = angles::axes_of_angles(subject, &angles);
    let is_across = |normal: &super::view::Triple| turns.iter().all(|axis| dot(*axis, *normal).abs() > 1.0 - 1e-9);
    let plane = plane.filter(is_across);
    subject.is_planar = plane.is_some();
    subject.camera = match plane {
        Some(normal) => Camera::camera_along_normal(normal, subject.view.up),
        None => Camera::oblique_camera(subject.view.up, &turns, &body_outlines::vectors_along_rods(subject)),
    };
    let (low, high) = body_outlines::bodies_extent(subject);
    let fits = |room: f64, i: usize| if high[i] - low[i] > 1e-9 { room / (high[i] - low[i]) } else { f64::MAX };
    let scale = fits(ROOM.0, 0).min(fits(ROOM.1, 1));
    // A mechanism of a single point has no extent. Its scale comes from the size of its view.
    subject.camera.scale = if scale < f64::MAX { scale } else { 0.5 * ROOM.1 / subject.view.size };
    Ok(())
}

/// Adds the points of the model to the sheet, with their names if the model file gives names. Points at
/// the same place share a dot.
fn add_points_to_sheet(subject: &SketchSubject<'_>, sheet: &mut Sheet) {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for point in 0..subject.pose.points.len() {
        match groups.iter_mut().find(|group| subject.points_coincide(group[0], point)) {
            Some(group) => group.push(point),
            None => groups.push(vec![point]),
        }
    }
    for group in groups {
        let spot = subject.spot(group[0]);
        let is_pinned = subject.view.solids.iter().any(|solid| {
            solid.is_pin()
                && solid.form.points().iter().any(|point| group.iter().any(|p| subject.points_coincide(*p, *point)))
        });
        if !is_pinned {
            sheet.add([Mark::dot(MarkRole::Point, spot, 2.2)]);
        }
        let mut name: Vec<LabelWord> = Vec::new();
        for point in group.into_iter().filter(|point| !subject.is_named_after_joint(*point)) {
            if !name.is_empty() {
                name.push(LabelWord::Plain(", ".to_owned()));
            }
            name.push(LabelWord::Name(subject.mechanism.points[point].name.clone()));
        }
        if !name.is_empty() {
            sheet.request_label(MarkRole::Point, name, spot, None, 5.0);
        }
    }
}

/// Adds a mark of every coordinate to the sheet. Returns the kind of mark of each coordinate.
fn add_coordinates_to_sheet(subject: &SketchSubject<'_>, sheet: &mut Sheet) -> Vec<MarkedCoordinate> {
    let mut arcs = Arcs::default();
    let (mut shown, mut alone) = (Vec::new(), Vec::new());
    let mut together: Vec<(usize, Vec<usize>)> = Vec::new();
    let named = |c: usize| LabelWord::Name(subject.mechanism.coordinates[c].name.clone());
    for c in (0..subject.q.len()).filter(|c| subject.mechanism.coordinates[*c].name != TIME) {
        let oriented = (0..subject.pose.rotations.len())
            .find(|f| subject.terms.turn(*f).is_none() && subject.terms.turns_by(subject.mechanism, *f, c));
        let mark = if let Some(angle) = Angle::of(subject, c) {
            let is_open = angles::draw_angle_arc(subject, sheet, &mut arcs, &angle);
            CoordinateMark::Arc(angle, is_open)
        } else if let Some(frame) = oriented {
            match together.iter_mut().find(|(f, _)| *f == frame) {
                Some((_, list)) => list.push(c),
                None => together.push((frame, vec![c])),
            }
            CoordinateMark::Together(frame)
        } else if let Some(length) = Length::of(subject, c) {
            let is_open = dimension_lines::draw_dimension_line(subject, sheet, &length);
            CoordinateMark::Line(length, is_open)
        } else if dimension_lines::draw_motion_arrow(subject, sheet, c) {
            CoordinateMark::Arrow
        } else {
            alone.push(c);
            CoordinateMark::Name
        };
        shown.push(MarkedCoordinate { coordinate: c, mark });
    }
    for (frame, list) in together {
        let mut names = Vec::new();
        for c in list {
            if !names.is_empty() {
                names.push(LabelWord::Plain(", ".to_owned()));
            }
            names.push(named(c));
        }
        angles::draw_common_arc(subject, sheet, &mut arcs, frame, names);
    }
    if let (false, Some((low, high))) = (alone.is_empty(), drawing_elements::drawing_extent(&sheet.marks, &[])) {
        // These names are placed below all marks.
        for c in &alone {
            sheet.request_label(MarkRole::Coordinate, vec![named(*c)], [low[0], high[1]], Some([0.0, 1.0]), 12.0);
        }
    }
    shown
}

/// Adds the names of bodies beside their solids, if there is room.
fn add_body_names_to_sheet(subject: &SketchSubject<'_>, sheet: &mut Sheet) {
    for (at, body) in subject.mechanism.bodies.iter().enumerate() {
        let own = subject.view.solids.iter().filter(|solid| solid.body == Some(at));
        // The name of a particle stands at the particle, not along a rod.
        let is_rigid = body.rigid.is_some();
        let rods = own.clone().filter_map(|solid| match solid.form {
            SolidForm::Rod { ends, .. } if is_rigid => Some(ends.map(|end| subject.spot(end))),
            _ => None,
        });
        // The longest rod is taken. Lengths are compared in steps of 4 px. The first of equal rods is taken.
        let long = |[a, b]: &[DrawingPoint; 2]| ((b[0] - a[0]).hypot(b[1] - a[1]) / 4.0).round();
        let longest = rods.fold(None, |best: Option<[DrawingPoint; 2]>, rod| match best {
            Some(best) if long(&best) >= long(&rod) => Some(best),
            _ => Some(rod),
        });
        if own.count() == 0 {
            continue;
        }
        let middle = longest.map_or(subject.spot(body.centre), |[a, b]| [0, 1].map(|i| 0.5 * (a[i] + b[i])));
        let words = vec![LabelWord::Plain(body.name.replace('_', " "))];
        sheet.request_optional_label(MarkRole::Body, words, middle, None, if is_rigid { 10.0 } else { 14.0 });
    }
}

/// Places the labels of a sheet. Moves the origin of the sheet so that all marks and labels lie on it.
/// Returns the size of the sheet, px, its marks and its labels.
fn finish_sheet(sheet: Sheet) -> (DrawingPoint, Vec<Mark>, Vec<Label>) {
    let (mut labels, leaders) = label_placement::place_labels(&sheet.wishes, &sheet.marks);
    let mut marks = sheet.marks;
    marks.extend(leaders);
    let (low, high) = drawing_elements::drawing_extent(&marks, &labels).unwrap_or_default();
    let moved = |spot: DrawingPoint| [0, 1].map(|i| spot[i] - low[i] + MARGIN);
    for mark in &mut marks {
        mark.path.from = moved(mark.path.from);
        for part in &mut mark.path.parts {
            *part = match *part {
                PathPart::Line(to) => PathPart::Line(moved(to)),
                PathPart::Curve(spots) => PathPart::Curve(spots.map(moved)),
            };
        }
    }
    for label in &mut labels {
        label.at = moved(label.at);
    }
    let size = [0, 1].map(|i| (high[i] - low[i] + 2.0 * MARGIN).ceil());
    (size, marks, labels)
}
