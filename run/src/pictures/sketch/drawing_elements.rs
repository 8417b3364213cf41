//! Elements of a drawn sheet: labels, and marks. A mark is a path with a role.

/// Point on the sheet: distance to the right and distance down, px.
pub type DrawingPoint = [f64; 2];

/// Straight or curved part of a path. It begins at the end of the part before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PathPart {
    /// Straight line to the given point of the sheet.
    Line(DrawingPoint),
    /// Cubic Bézier curve: its two control points and its end.
    Curve([DrawingPoint; 3]),
}

/// Path on the sheet, made of straight and curved parts.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// First point of the path on the sheet.
    pub from: DrawingPoint,
    /// Parts of the path. Each part begins at the end of the part before.
    pub parts: Vec<PathPart>,
    /// True if a straight line joins the end of the path to its beginning.
    pub is_closed: bool,
}

/// Meaning of a mark or label. The renderer decides how each role looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MarkRole {
    /// Plane on which a body rolls or slides.
    Ground,
    /// Line of the ground, or its hatching.
    Support,
    /// Rigid body of the mechanism.
    Body,
    /// Particle, or a ball that represents a particle.
    Mass,
    /// Spring or damper between two points.
    Spring,
    /// Pin that joins bodies, or joins a body to the ground.
    Joint,
    /// Line from which an angle or a length is measured.
    Reference,
    /// Axis of a frame, drawn as an arrow.
    Axis,
    /// Generalized coordinate, drawn as an arc, a dimension line or an arrow.
    Coordinate,
    /// Direction of gravity, drawn as an arrow.
    Gravity,
    /// Named point of the model.
    Point,
    /// Line from a label to the item that it names.
    Leader,
}

impl MarkRole {
    /// All roles, in the order of their declaration.
    pub const ALL: [Self; 12] = [
        Self::Ground,
        Self::Support,
        Self::Body,
        Self::Mass,
        Self::Spring,
        Self::Joint,
        Self::Reference,
        Self::Axis,
        Self::Coordinate,
        Self::Gravity,
        Self::Point,
        Self::Leader,
    ];
}

/// Way of drawing a path of the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PaintKind {
    /// The line is drawn. The enclosed area stays empty.
    Line,
    /// The enclosed area is filled with the colour of the line.
    Filled,
    /// The line is drawn, and the enclosed area has the shade of the role. The area hides marks behind it.
    Solid,
}

/// Path on the sheet, with its role and its way of drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Role of the mark. It decides the colour and the line of the mark.
    pub role: MarkRole,
    /// Way in which the path is drawn: as a line, filled, or solid.
    pub paint: PaintKind,
    /// Line or outline of the mark on the sheet.
    pub path: Path,
}

/// Part of the text of a label.
#[derive(Clone, Debug, PartialEq)]
pub enum LabelWord {
    /// Name in the model, written as mathematics: `q1` becomes q with the subscript 1.
    Name(String),
    /// Basis vector of a frame, as the name of the frame and the index of the axis, from 0.
    Basis(String, usize),
    /// Plain text, not written as mathematics.
    Plain(String),
    /// Minus sign before a basis vector.
    Minus,
}

/// Label: a text at a place on the sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// Role of the item that the label names.
    pub role: MarkRole,
    /// Text of the label, as a list of parts.
    pub words: Vec<LabelWord>,
    /// Middle of the label's box on the sheet, px.
    pub at: DrawingPoint,
    /// Width and height of the label's box, px. They are estimates, because no font is available.
    pub size: DrawingPoint,
}

/// Distance of the control points from the ends of a Bézier curve that is a quarter of a circle of
/// radius 1.
const QUARTER: f64 = 0.552_284_749_830_793_4;

impl Path {
    /// Makes a path of straight lines through the given points.
    pub(super) fn line(spots: &[DrawingPoint]) -> Self {
        let from = spots.first().copied().unwrap_or_default();
        Self { from, parts: spots.iter().skip(1).map(|spot| PathPart::Line(*spot)).collect(), is_closed: false }
    }

    /// Makes the closed path of a polygon with the given corners.
    pub(super) fn polygon(corners: &[DrawingPoint]) -> Self {
        Self { is_closed: true, ..Self::line(corners) }
    }

    /// Makes the arc c + cos t · a + sin t · b of an ellipse, for t between `from` and `to`, rad. Lengths are
    /// in px. The vectors a and b are conjugate semi-diameters of the ellipse, which is the projection of a
    /// circle in space.
    pub(super) fn arc(c: DrawingPoint, a: DrawingPoint, b: DrawingPoint, from: f64, to: f64) -> Self {
        let pieces = ((to - from).abs() / std::f64::consts::FRAC_PI_2).ceil().max(1.0);
        let step = (to - from) / pieces;
        // 4/3 tan(step/4): the curve differs from the ellipse by less than 3e-4 of the radius.
        let handle = 4.0 / 3.0 * (step / 4.0).tan();
        let at = |t: f64| [0, 1].map(|i| c[i] + t.cos() * a[i] + t.sin() * b[i]);
        let slope = |t: f64| [0, 1].map(|i| t.cos() * b[i] - t.sin() * a[i]);
        let piece = |k: f64| {
            let (t, s) = (from + k * step, from + (k + 1.0) * step);
            let (p, q) = (at(t), at(s));
            let first = [0, 1].map(|i| p[i] + handle * slope(t)[i]);
            PathPart::Curve([first, [0, 1].map(|i| q[i] - handle * slope(s)[i]), q])
        };
        let parts = std::iter::successors(Some(0.0), |k| Some(k + 1.0)).take_while(|k| *k < pieces).map(piece);
        Self { from: at(from), parts: parts.collect(), is_closed: false }
    }

    /// Makes the closed path of an ellipse with the centre c and the conjugate semi-diameters a and b, px.
    pub(super) fn ellipse(c: DrawingPoint, a: DrawingPoint, b: DrawingPoint) -> Self {
        Self { is_closed: true, ..Self::arc(c, a, b, 0.0, std::f64::consts::TAU) }
    }

    /// Makes the closed path of a circle with the centre c. The radius is in px.
    pub(super) fn circle(c: DrawingPoint, radius: f64) -> Self {
        Self::ellipse(c, [radius, 0.0], [0.0, radius])
    }

    /// Makes the closed path around all points whose distance from the line from a to b is at most `radius`,
    /// px.
    pub(super) fn capsule(a: DrawingPoint, b: DrawingPoint, radius: f64) -> Self {
        let way = [b[0] - a[0], b[1] - a[1]];
        let long = way[0].hypot(way[1]);
        if long < 1e-6 {
            return Self::circle(a, radius);
        }
        let along = way.map(|x| radius * x / long);
        let across = [-along[1], along[0]];
        let moved = |s: DrawingPoint, x: f64, y: f64| [0, 1].map(|i| s[i] + x * along[i] + y * across[i]);
        let end = |s: DrawingPoint, side: f64| {
            [
                PathPart::Curve([moved(s, QUARTER * side, side), moved(s, side, QUARTER * side), moved(s, side, 0.0)]),
                PathPart::Curve([
                    moved(s, side, -QUARTER * side),
                    moved(s, QUARTER * side, -side),
                    moved(s, 0.0, -side),
                ]),
            ]
        };
        let mut parts = vec![PathPart::Line(moved(b, 0.0, 1.0))];
        parts.extend(end(b, 1.0));
        parts.push(PathPart::Line(moved(a, 0.0, -1.0)));
        parts.extend(end(a, -1.0));
        Self { from: moved(a, 0.0, 1.0), parts, is_closed: true }
    }

    /// Last point of the path, or its first point if it has no parts.
    pub(super) fn end(&self) -> DrawingPoint {
        match self.parts.last() {
            None => self.from,
            Some(PathPart::Line(to) | PathPart::Curve([.., to])) => *to,
        }
    }

    /// Unit vector along the path at its end. It points to the right if the path has no length.
    pub(super) fn end_direction(&self) -> DrawingPoint {
        let end = self.end();
        let before = match self.parts.as_slice() {
            [.., PathPart::Curve([_, handle, _])] => *handle,
            [.., PathPart::Line(to) | PathPart::Curve([.., to]), PathPart::Line(_)] => *to,
            _ => self.from,
        };
        drawing_unit_vector([end[0] - before[0], end[1] - before[1]])
    }

    /// Points along the path, px, with distances of about `step` px or less.
    #[must_use]
    pub fn points_along_path(&self, step: f64) -> Vec<DrawingPoint> {
        let (mut list, mut at) = (vec![self.from], self.from);
        let closing = self.is_closed.then_some(PathPart::Line(self.from));
        for part in self.parts.iter().copied().chain(closing) {
            let (to, of): (DrawingPoint, Box<dyn Fn(f64) -> DrawingPoint>) = match part {
                PathPart::Line(to) => (to, Box::new(move |t| [0, 1].map(|i| at[i] + t * (to[i] - at[i])))),
                PathPart::Curve([a, b, to]) => {
                    let of = move |t: f64, i: usize| {
                        let s = 1.0 - t;
                        s * s * s * at[i] + 3.0 * s * s * t * a[i] + 3.0 * s * t * t * b[i] + t * t * t * to[i]
                    };
                    (to, Box::new(move |t| [of(t, 0), of(t, 1)]))
                }
            };
            let long = (to[0] - at[0]).hypot(to[1] - at[1]);
            // A quarter of a circle is 1.11 times as long as its chord.
            let count = (1.2 * long / step).ceil().clamp(1.0, 2000.0);
            let shares = std::iter::successors(Some(1.0), |k| Some(k + 1.0)).take_while(|k| *k <= count);
            list.extend(shares.map(|k| of(k / count)));
            at = to;
        }
        list
    }
}

impl Mark {
    /// Makes the mark of a line with the given role, without a filled area.
    pub(super) fn line(role: MarkRole, path: Path) -> Self {
        Self { role, paint: PaintKind::Line, path }
    }

    /// Makes the mark of an outline whose area hides the marks behind it.
    pub(super) fn solid(role: MarkRole, path: Path) -> Self {
        Self { role, paint: PaintKind::Solid, path }
    }

    /// Makes the mark of a filled circle with its centre at the point `at` of the sheet. The radius is in px.
    pub(super) fn dot(role: MarkRole, at: DrawingPoint, radius: f64) -> Self {
        Self { role, paint: PaintKind::Filled, path: Path::circle(at, radius) }
    }

    /// Makes the marks of a path and of an arrow tip at its end. `long` is the length of the tip, px.
    pub(super) fn arrow(role: MarkRole, path: Path, long: f64) -> [Self; 2] {
        let tip = arrow_tip(role, path.end(), path.end_direction(), long);
        [Self::line(role, path), tip]
    }
}

/// Makes the mark of an arrow tip that ends at `end` and points along the unit vector `heading`. `long` is
/// the length of the tip, px.
pub(super) fn arrow_tip(role: MarkRole, end: DrawingPoint, heading: DrawingPoint, long: f64) -> Mark {
    let at = |x: f64, y: f64| [end[0] - x * heading[0] - y * heading[1], end[1] - x * heading[1] + y * heading[0]];
    let corners = [end, at(long, 0.32 * long), at(0.8 * long, 0.0), at(long, -0.32 * long)];
    Mark { role, paint: PaintKind::Filled, path: Path::polygon(&corners) }
}

/// Unit vector along a vector on the sheet. It points to the right if the vector is zero.
pub(super) fn drawing_unit_vector(way: DrawingPoint) -> DrawingPoint {
    let long = way[0].hypot(way[1]);
    if long > 1e-9 { way.map(|x| x / long) } else { [1.0, 0.0] }
}

/// Box around marks and labels: its least and its greatest corner. `None` if there are no marks and labels.
pub(super) fn drawing_extent<'a>(
    marks: impl IntoIterator<Item = &'a Mark>,
    labels: &[Label],
) -> Option<(DrawingPoint, DrawingPoint)> {
    let corners = labels.iter().flat_map(|label| {
        let half = label.size.map(|x| 0.5 * x);
        [-1.0, 1.0].map(|side| [label.at[0] + side * half[0], label.at[1] + side * half[1]])
    });
    let mut all = marks.into_iter().flat_map(|mark| mark.path.points_along_path(4.0)).chain(corners);
    let first = all.next()?;
    Some(all.fold((first, first), |(low, high), spot| {
        ([0, 1].map(|i| low[i].min(spot[i])), [0, 1].map(|i| high[i].max(spot[i])))
    }))
}
