//! Comparison of the declarations of two models: parameters, units, signs, the domain, and all
//! elements of the mechanism.
//!
//! Invariant: terms are compared by algebra, so that `pi/2 > abs(q)` equals `abs(q) < pi/2`.
//! Titles, remarks and the order of a file are not compared, because no number depends on them.

use crate::algebra::meaning::compare::Comparer;
use crate::algebra::term::transfer::Transfer;
use crate::algebra::text::print::print_text;
use crate::algebra::{Arena, Expr};
use crate::geometry::Turn;
use crate::model::{ForcePlace, Model, MotionConstraintKind, Parameter, ReactionKind};

/// Section of model files that contains declarations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the sections of a model file, by their names there")]
pub enum Section {
    Parameters,
    Coordinates,
    Speeds,
    Frames,
    Points,
    Bodies,
    Gravity,
    Forces,
    Torques,
    Potentials,
    Reactions,
    Constraints,
    Domain,
}

impl Section {
    /// English noun for one entry of the section, such as "parameter" or "force".
    #[must_use]
    pub const fn noun(self) -> &'static str {
        match self {
            Self::Parameters => "parameter",
            Self::Coordinates => "coordinate",
            Self::Speeds => "speed",
            Self::Frames => "frame",
            Self::Points => "point",
            Self::Bodies => "body",
            Self::Gravity => "gravity",
            Self::Forces => "force",
            Self::Torques => "torque",
            Self::Potentials => "potential",
            Self::Reactions => "reaction",
            Self::Constraints => "constraint",
            Self::Domain => "condition",
        }
    }
}

/// Property of a declaration that can differ between two models.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeclaredProperty {
    /// The default value of a parameter differs.
    Default,
    /// The unit of a parameter or generalized coordinate differs.
    Unit,
    /// Only one model declares the parameter as positive.
    Positive,
    /// The definition of an element differs: its place, the points where it acts, its components, or its condition.
    Definition,
}

impl DeclaredProperty {
    /// Name of the property in JSON output, such as "default".
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Default => "default",
            Self::Unit => "unit",
            Self::Positive => "positive",
            Self::Definition => "definition",
        }
    }
}

/// Difference between the declarations of one element in an old and a new model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Edit {
    /// The declaration exists only in the new model.
    Added,
    /// The declaration exists only in the old model.
    Removed,
    /// The declaration is in both models, but a property differs.
    Changed {
        /// Property of the declaration that differs between the models.
        property: DeclaredProperty,
        /// Text of the property in the old model, for messages.
        old: String,
        /// Text of the property in the new model, for messages.
        new: String,
    },
}

/// Declaration that differs between an old and a new model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Declaration {
    /// Section of the model file that contains the declaration.
    pub section: Section,
    /// Name of the declared element, such as a parameter, body or force.
    pub name: String,
    /// Difference between the old and the new declaration.
    pub edit: Edit,
}

/// Element that a model declares: properties compared as text, terms compared by algebra, and a text for messages.
struct DeclaredElement {
    /// Section of the model file that declares the element.
    section: Section,
    name: String,
    /// Properties of the element that are compared as text, each with its text.
    properties: Vec<(DeclaredProperty, String)>,
    /// Frames, points and bodies that the element refers to, as text: parents, axes, and points where the element acts.
    place: String,
    /// Formulas of the element, such as components, compared by algebra.
    terms: Vec<Expr>,
    /// Definition as written in the model file; `None` unless it is a single formula.
    written: Option<String>,
}

impl DeclaredElement {
    /// Creates an element without properties and without a written definition.
    fn new(section: Section, name: &str, place: String, terms: Vec<Expr>) -> Self {
        Self { section, name: name.to_owned(), properties: Vec::new(), place, terms, written: None }
    }

    /// Copy of the element with the given properties.
    fn with(self, properties: Vec<(DeclaredProperty, String)>) -> Self {
        Self { properties, ..self }
    }

    /// Definition of the element as a line of text for messages.
    fn definition(&self, arena: &Arena) -> String {
        if let Some(written) = &self.written {
            return written.clone();
        }
        let terms: Vec<String> = self.terms.iter().map(|e| print_text(arena, *e)).collect();
        match (self.place.as_str(), terms.as_slice()) {
            ("", [one]) => one.clone(),
            (place, []) => place.to_owned(),
            (place, terms) => format!("{place} ({})", terms.join(", ")).trim_start().to_owned(),
        }
    }
}

/// Lists every declaration that differs between two models. The terms of the new model are in `arena`. Declarations of
/// the new model come first, in the order of its file, then declarations that only the old model has.
pub fn changed_declarations(
    old: &Model,
    old_arena: &Arena,
    new: &Model,
    arena: &mut Arena,
    comparer: &mut Comparer,
) -> Vec<Declaration> {
    let mut transfer = Transfer::to_other_model(old_arena, "_old");
    let (old, new) = (declared_elements(old), declared_elements(new));
    let mut list = Vec::new();
    let same = |a: &DeclaredElement, b: &DeclaredElement| a.section == b.section && a.name == b.name;
    let declaration = |of: &DeclaredElement, edit| Declaration { section: of.section, name: of.name.clone(), edit };
    for element in &new {
        let Some(former) = old.iter().find(|e| same(e, element)) else {
            list.push(declaration(element, Edit::Added));
            continue;
        };
        for ((property, old), (_, new)) in former.properties.iter().zip(&element.properties) {
            if old != new {
                let edit = Edit::Changed { property: *property, old: old.clone(), new: new.clone() };
                list.push(declaration(element, edit));
            }
        }
        let terms: Vec<Expr> = former.terms.iter().map(|e| transfer.transfer_term(arena, *e)).collect();
        let is_same = former.place == element.place
            && terms.len() == element.terms.len()
            && terms.iter().zip(&element.terms).all(|(a, b)| comparer.compare(arena, *a, *b).is_equal());
        if !is_same {
            let (old, new) = (former.definition(old_arena), element.definition(arena));
            list.push(declaration(element, Edit::Changed { property: DeclaredProperty::Definition, old, new }));
        }
    }
    let removed = old.iter().filter(|former| !new.iter().any(|e| same(e, former)));
    list.extend(removed.map(|former| declaration(former, Edit::Removed)));
    list
}

/// Elements that a model declares, in the order of the sections of a model file.
fn declared_elements(model: &Model) -> Vec<DeclaredElement> {
    let mut list = declared_variables(model);
    list.extend(declared_frames_and_points(model));
    list.extend(declared_bodies(model));
    list.extend(declared_loads(model));
    list.extend(declared_conditions(model));
    list
}

/// Parameters, generalized coordinates and generalized speeds as elements.
fn declared_variables(model: &Model) -> Vec<DeclaredElement> {
    let bare = |section, name: &str| DeclaredElement::new(section, name, String::new(), Vec::new());
    let parameters = model.parameters.iter().map(|p| {
        let positive = if p.positive { "yes" } else { "not stated" };
        bare(Section::Parameters, &p.name).with(vec![
            (DeclaredProperty::Default, declared_default_text(p)),
            (DeclaredProperty::Unit, p.unit.to_string()),
            (DeclaredProperty::Positive, positive.to_owned()),
        ])
    });
    let coordinates = model
        .coordinates
        .iter()
        .map(|c| bare(Section::Coordinates, &c.name).with(vec![(DeclaredProperty::Unit, c.unit.to_string())]));
    let speeds =
        model.speeds.iter().map(|s| DeclaredElement::new(Section::Speeds, &s.name, String::new(), vec![s.definition]));
    parameters.chain(coordinates).chain(speeds).collect()
}

/// Default value of a parameter as text: a decimal or a fraction, whichever is shorter; "none"
/// without a default.
fn declared_default_text(parameter: &Parameter) -> String {
    let Some(value) = &parameter.value else { return "none".to_owned() };
    let (decimal, fraction) = (value.to_f64().to_string(), value.to_string());
    if fraction.len() < decimal.len() { fraction } else { decimal }
}

/// Frames and points as elements, each with its parent and its rotation or position.
fn declared_frames_and_points(model: &Model) -> Vec<DeclaredElement> {
    let frames = model.frames.iter().map(|frame| match &frame.rotation {
        None => DeclaredElement::new(Section::Frames, &frame.name, "inertial".to_owned(), Vec::new()),
        Some((parent, turn)) => {
            let from = &model.frames[*parent].name;
            let place = match turn {
                Turn::About(axis, _) => format!("from {from} about axis {}", axis + 1),
                Turn::Oriented(_) => format!("from {from} by cosines"),
            };
            DeclaredElement::new(Section::Frames, &frame.name, place, turn.terms())
        }
    });
    let points = model.points.iter().map(|point| match point.position {
        None => DeclaredElement::new(Section::Points, &point.name, "origin".to_owned(), Vec::new()),
        Some(placement) => {
            let (parent, frame, components) = (placement.parent, placement.frame, placement.components);
            let place = format!("from {} in {}", model.points[parent].name, model.frames[frame].name);
            DeclaredElement::new(Section::Points, &point.name, place, components.to_vec())
        }
    });
    frames.chain(points).collect()
}

/// Bodies and particles as elements, with mass, inertia and added mass.
fn declared_bodies(model: &Model) -> Vec<DeclaredElement> {
    let one = |body: &crate::model::Body| {
        let centre = &model.points[body.centre].name;
        let mut terms = vec![body.mass];
        let place = match &body.rigid {
            None => format!("particle at {centre}"),
            Some((frame, inertia)) => {
                terms.extend(inertia.tensor.iter().flatten());
                let (frame, of) = (&model.frames[*frame].name, &model.frames[inertia.frame].name);
                format!("in {frame} about {centre}, inertia in {of}")
            }
        };
        DeclaredElement::new(Section::Bodies, &body.name, place, terms)
    };
    let mut list: Vec<DeclaredElement> = model.bodies.iter().map(one).collect();
    for added in &model.added_masses {
        list[added.body].terms.extend(added.tensor.iter().flatten());
    }
    list
}

/// Gravity, forces, torques, potentials and declared reactions as elements.
fn declared_loads(model: &Model) -> Vec<DeclaredElement> {
    let frame = |index: usize| &model.frames[index].name;
    let body = |index: usize| &model.bodies[index].name;
    let place = |at: ForcePlace| format!("{} at {}", body(at.body), model.points[at.point].name);
    let pair = |on: String, against: Option<String>, of: usize| {
        let against = against.map_or_else(String::new, |other| format!(" against {other}"));
        format!("on {on}{against} in {}", frame(of))
    };
    let mut list = Vec::new();
    if let Some(gravity) = &model.gravity {
        let mut terms = gravity.acceleration.to_vec();
        terms.extend(gravity.zero_at.iter().flat_map(|(q, value)| [*q, *value]));
        list.push(DeclaredElement::new(Section::Gravity, "gravity", format!("in {}", frame(gravity.frame)), terms));
    }
    list.extend(model.forces.iter().map(|f| {
        let place = pair(place(f.on), f.against.map(place), f.frame);
        DeclaredElement::new(Section::Forces, &f.name, place, f.vector.to_vec())
    }));
    let turned = |(of, _): (usize, Option<usize>)| frame(of).clone();
    list.extend(model.torques.iter().map(|t| {
        let place = pair(turned(t.on), t.against.map(turned), t.frame);
        DeclaredElement::new(Section::Torques, &t.name, place, t.vector.to_vec())
    }));
    let potentials = model.potentials.iter();
    list.extend(potentials.map(|p| DeclaredElement::new(Section::Potentials, &p.name, String::new(), vec![p.energy])));
    list.extend(model.reactions.iter().filter(|r| r.is_stated).map(|r| {
        let place = match r.kind {
            ReactionKind::Force { on, against } => pair(place(on), against.map(place), r.frame),
            ReactionKind::Torque { on, against } => {
                format!("torque {}", pair(body(on).clone(), against.map(|b| body(b).clone()), r.frame))
            }
        };
        DeclaredElement::new(Section::Reactions, &r.name, place, r.direction.to_vec())
    }));
    list
}

/// Constraints, loops and conditions of the domain as elements.
fn declared_conditions(model: &Model) -> Vec<DeclaredElement> {
    let by = |reaction: Option<usize>| {
        reaction.map_or_else(String::new, |r| format!(", enforced by {}", model.reactions[r].name))
    };
    let constraints = model.constraints.iter().map(|c| {
        DeclaredElement::new(
            Section::Constraints,
            &c.name,
            format!("fixes {}{}", c.fixes, by(c.enforced_by)),
            vec![c.value],
        )
    });
    // The equation of a loop says more than its rate: it also gives the value at which the loop is closed.
    let loops = model
        .loops
        .iter()
        .map(|c| DeclaredElement::new(Section::Constraints, &c.name, "a loop".to_owned(), vec![c.equation]));
    let of_motion = model.motion_constraints.iter().map(|c| {
        let (name, place) = match c.kind {
            MotionConstraintKind::Loop(_) => (format!("{}'", c.name), "the rate of a loop"),
            MotionConstraintKind::Rolling(_) => (c.name.clone(), "rolling"),
            MotionConstraintKind::Stated => (c.name.clone(), "between velocities"),
            MotionConstraintKind::Clock => (c.name.clone(), "time goes on"),
        };
        DeclaredElement::new(Section::Constraints, &name, format!("{place}{}", by(c.enforced_by)), vec![c.equation])
    });
    let domain = model.domain.iter().map(|c| DeclaredElement {
        written: Some(c.text.clone()),
        ..DeclaredElement::new(Section::Domain, &c.name, String::new(), vec![c.positive])
    });
    constraints.chain(loops).chain(of_motion).chain(domain).collect()
}
