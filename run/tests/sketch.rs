//! Sketches, against closed forms and against properties of every sketch.

use std::path::{Path, PathBuf};
use tripos::pictures::sketch::{DrawingPoint, Label, LabelWord, Mark, MarkRole, PaintKind, PathPart, Sketch};
use tripos::{Mechanism, Scene};
use tripos_derive::diagnostic::Source;
use tripos_derive::model::{TIME, load};
use tripos_derive::scene::load_state;

fn mechanism(name: &str) -> Mechanism {
    Mechanism::read(&Path::new("../models").join(name).join("model.toml")).unwrap()
}

/// Sketch of a model of the library in a state.
fn at_state(name: &str, state: &str) -> Sketch {
    let mut mechanism = mechanism(name);
    let state = load_state(&Source::from_text("state.toml", state), &mut mechanism.model).unwrap();
    Sketch::at_state(&mechanism, &state).unwrap()
}

fn library() -> Vec<PathBuf> {
    let mut all: Vec<PathBuf> = std::fs::read_dir("../models").unwrap().map(|entry| entry.unwrap().path()).collect();
    all.sort();
    assert!(all.len() > 20);
    all
}

/// The scenes of a model, in the order of their names.
fn scenes(model: &Path) -> Vec<Scene> {
    let folder = std::fs::read_dir(model.join("scenes")).unwrap();
    let mut all: Vec<PathBuf> = folder.map(|entry| entry.unwrap().path()).collect();
    all.sort();
    all.iter().map(|path| Scene::read(path).unwrap()).collect()
}

/// Marks with this role and this paint.
fn of(sketch: &Sketch, role: MarkRole, paint: PaintKind) -> Vec<&Mark> {
    sketch.marks.iter().filter(|mark| mark.role == role && mark.paint == paint).collect()
}

/// The middle of a closed path.
fn middle(mark: &Mark) -> DrawingPoint {
    let spots = mark.path.points_along_path(0.2);
    [0, 1].map(|i| {
        let all = spots.iter().map(|spot| spot[i]);
        0.5 * (all.clone().fold(f64::MAX, f64::min) + all.fold(f64::MIN, f64::max))
    })
}

fn end(mark: &Mark) -> DrawingPoint {
    match mark.path.parts.last().unwrap() {
        PathPart::Line(to) | PathPart::Curve([.., to]) => *to,
    }
}

fn label<'a>(sketch: &'a Sketch, word: &LabelWord) -> &'a Label {
    sketch.labels.iter().find(|label| label.words.contains(word)).unwrap_or_else(|| panic!("no {word:?}"))
}

fn basis(frame: &str, axis: usize) -> LabelWord {
    LabelWord::Basis(frame.to_owned(), axis)
}

/// Goal: marks are where geometry puts them. Method: a pendulum at θ. The bob is in the direction (sin θ, cos θ) to the
/// right and down from the pin. The arc of θ goes from straight down to the rod, in its plane and in the sense in which
/// θ grows.
#[test]
fn a_pendulum_hangs_at_its_angle_and_the_arc_leads_to_it() {
    for theta in [0.7_f64, -1.1, 2.4] {
        let sketch = at_state("pendulum", &format!("[state]\ntheta = {theta}\nomega = 0\n"));
        let pin = middle(of(&sketch, MarkRole::Joint, PaintKind::Solid)[0]);
        let bob = middle(of(&sketch, MarkRole::Mass, PaintKind::Solid)[0]);
        let way = [bob[0] - pin[0], bob[1] - pin[1]];
        assert!((way[0].atan2(way[1]) - theta).abs() < 1e-3, "{theta}: {way:?}");
        let arc = of(&sketch, MarkRole::Coordinate, PaintKind::Line)[0];
        let of_arc = |spot: DrawingPoint| (spot[0] - pin[0]).atan2(spot[1] - pin[1]);
        assert!(of_arc(arc.path.from).abs() < 1e-3 && (of_arc(end(arc)) - theta).abs() < 1e-3, "{theta}");
        // All spots of the arc are on a circle about the pin.
        let radii: Vec<f64> =
            arc.path.points_along_path(1.0).iter().map(|at| (at[0] - pin[0]).hypot(at[1] - pin[1])).collect();
        assert!(radii.iter().all(|r| (r - radii[0]).abs() < 0.05), "{radii:?}");
        assert!(sketch.changed.is_empty());
    }
}

/// Goal: dimension lines have the right ends and ratio. Method: a pendulum in Cartesian coordinates at (0.6, −0.8). The
/// two dimension lines are in the ratio 3 to 4, one level and one upright.
#[test]
fn lengths_are_measured_by_lines_as_long_as_they_are() {
    let sketch = at_state("elastic_pendulum", "[state]\nx = 0.6\ny = -0.8\nu = 0\nv = 0\n");
    let lines = of(&sketch, MarkRole::Coordinate, PaintKind::Line);
    let long: Vec<DrawingPoint> = lines.iter().map(|line| [0, 1].map(|i| end(line)[i] - line.path.from[i])).collect();
    assert_eq!(long.len(), 2);
    assert!(long[0][1].abs() < 1e-9 && long[1][0].abs() < 1e-9 && long[0][0] > 0.0 && long[1][1] > 0.0, "{long:?}");
    assert!((long[0][0] / long[1][1] - 0.75).abs() < 1e-9, "{long:?}");
}

/// Spots of the names of the inertial axes, relative to that of the origin.
fn axes(name: &str) -> [DrawingPoint; 3] {
    let folder = Path::new("../models").join(name);
    let scene = &scenes(&folder)[0];
    let sketch = Sketch::of_scene(scene.mechanism(), scene.description()).unwrap();
    let origin = label(&sketch, &LabelWord::Name("O".to_owned())).at;
    let from = |label: &Label| [label.at[0] - origin[0], label.at[1] - origin[1]];
    [0, 1, 2].map(|axis| {
        let words = [basis(&scene.mechanism().frames[0].name, axis)];
        // Reference lines elsewhere may have the same name.
        let all = sketch.labels.iter().filter(|label| label.words == words).map(from);
        all.min_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1]))).unwrap()
    })
}

/// Goal: oblique views are right-handed and show upwards as up. Method: the places of the names of a disk's inertial
/// axes. The third points against gravity, so from above the turn from the first to the second is counterclockwise. For
/// a bicycle, whose third axis points down, it is clockwise.
#[test]
fn axes_are_right_handed_and_up_is_up() {
    let turn = |a: DrawingPoint, b: DrawingPoint| a[0] * b[1] - a[1] * b[0];
    let [a1, a2, a3] = axes("disk");
    assert!(a3[1] < a1[1].min(a2[1]) && turn(a1, a2) < 0.0, "{a1:?} {a2:?} {a3:?}");
    let [n1, n2, n3] = axes("whipple_bicycle");
    assert!(n3[1] > n1[1].max(n2[1]) && turn(n1, n2) > 0.0, "{n1:?} {n2:?} {n3:?}");
}

/// Checks properties of any sketch: everything lies on its sheet, every coordinate has its name, and no label lies on
/// another.
fn check(name: &str, mechanism: &Mechanism, sketch: &Sketch) {
    let inside = |spot: DrawingPoint, half: DrawingPoint| {
        (0..2).all(|i| spot[i] - half[i] >= 0.0 && spot[i] + half[i] <= sketch.size[i])
    };
    assert!(sketch.size.iter().all(|x| (60.0..1200.0).contains(x)), "{name}: {:?}", sketch.size);
    for mark in &sketch.marks {
        let spots = mark.path.points_along_path(5.0);
        assert!(spots.iter().all(|spot| inside(*spot, [0.0; 2])), "{name}: {mark:?}");
    }
    for (at, label) in sketch.labels.iter().enumerate() {
        let half = label.size.map(|x| 0.5 * x);
        assert!(inside(label.at, half), "{name}: {label:?} is off the sheet");
        for other in &sketch.labels[at + 1..] {
            let is_apart = (0..2).any(|i| (label.at[i] - other.at[i]).abs() >= half[i] + 0.5 * other.size[i]);
            assert!(is_apart, "{name}: {label:?} is on {other:?}");
        }
    }
    let says = |what: &str| sketch.labels.iter().any(|label| label.words.contains(&LabelWord::Name(what.to_owned())));
    for coordinate in mechanism.coordinates.iter().filter(|c| c.name != TIME) {
        assert!(says(&coordinate.name), "{name}: no {}", coordinate.name);
        assert!(sketch.about.contains(&coordinate.name) && sketch.drawn.contains(&format!("{} = ", coordinate.name)));
    }
    for point in mechanism.points.iter().filter(|p| !p.name.ends_with("_centre") && !p.name.ends_with("_closed")) {
        assert!(says(&point.name), "{name}: no {}", point.name);
    }
    let inertial = &mechanism.frames[0].name;
    for axis in 0..3 {
        assert!(
            sketch.labels.iter().any(|label| label.words.contains(&basis(inertial, axis))),
            "{name}: {inertial}{axis}"
        );
    }
    let has_gravity = says("g") && sketch.marks.iter().any(|mark| mark.role == MarkRole::Gravity);
    assert!(mechanism.gravity.is_none() || has_gravity || sketch.about.contains("away from who looks"), "{name}");
}

/// Goal: a sketch of any mechanism is complete. Method: every scene of the library, and every model by itself.
#[test]
fn every_sketch_of_the_library_is_whole_and_the_same_each_time() {
    for folder in library() {
        let name = folder.display().to_string();
        for scene in scenes(&folder) {
            let draw = || Sketch::of_scene(scene.mechanism(), scene.description()).unwrap();
            let sketch = draw();
            check(&name, scene.mechanism(), &sketch);
            assert_eq!(sketch, draw(), "{name}");
        }
        let mechanism = Mechanism::read(&folder.join("model.toml")).unwrap();
        match Sketch::of_model(&mechanism) {
            Ok(sketch) => check(&format!("{name} by itself"), &mechanism, &sketch),
            Err(error) => {
                assert!(!mechanism.loops.is_empty(), "{name}: {error}");
                assert!(error.to_string().contains("give a scene, or --at"), "{name}: {error}");
            }
        }
    }
}

/// Goal: nobody takes a chosen value for the value at the start. Method: the words of a pendulum without a scene, whose
/// angle is chosen, and of a linkage, for which no value is chosen.
#[test]
fn what_is_drawn_otherwise_than_the_start_is_said() {
    let pendulum = mechanism("pendulum");
    let sketch = Sketch::of_model(&pendulum).unwrap();
    assert_eq!(sketch.drawn, "Drawn at theta = 30°, to be seen; the model by itself has theta = 0°.");
    assert_eq!(sketch.changed.len(), 1);
    let scene = &scenes(Path::new("../models/four_bar"))[0];
    let sketch = Sketch::of_scene(scene.mechanism(), scene.description()).unwrap();
    assert!(sketch.changed.is_empty() && sketch.drawn.ends_with(": the start of crossed.toml."), "{}", sketch.drawn);
}

/// Goal: no number is invented. Method: a model whose parameter has no value, and no scene.
#[test]
fn a_parameter_without_a_value_is_refused() {
    let text = std::fs::read_to_string("../models/pendulum/model.toml").unwrap();
    let text = text.replace("l = { unit = \"m\", value = 1,", "l = { unit = \"m\",");
    let error = Sketch::of_model(&Mechanism::new(load(&Source::from_text("model.toml", &text)).unwrap())).unwrap_err();
    assert!(error.to_string().contains("the parameter `l` has no value"), "{error}");
}
