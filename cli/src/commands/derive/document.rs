//! A derivation as a document in no language: the meanings of symbols, all formulas of the text, and the conserved
//! quantities.
//!
//! Invariant: nothing here depends on a language of documents. Formulas are trees, left sides are data, and words are
//! those of the model.

use crate::phrases::NAMED;
use tripos_derive::Model;
use tripos_derive::algebra::solve::elimination::Elimination;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::text::definitions::glossary;
use tripos_derive::algebra::text::print::{printed_name, symbol_view, view_of};
use tripos_derive::algebra::text::view::View;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{
    DerivationInSteps, Equations, LineName, MovingPlace, QuantityKind, Stage, Step, VectorName,
};
use tripos_derive::model::{Body, Inertia};
use tripos_derive::prove::Integral;

/// A document about the derivation of a model's equations.
pub struct Document {
    /// Title of the model.
    pub title: String,
    /// Paragraphs about the model, before the symbols.
    pub about: Vec<String>,
    /// Meanings of the model's symbols.
    pub symbols: Vec<Meaning>,
    /// Bodies of the model, in the order of the model file.
    pub bodies: Vec<BodyEntry>,
    /// Headings, paragraphs and equations after the bodies, in order.
    pub blocks: Vec<Block>,
}

/// Entry of a body in the list of bodies.
pub struct BodyEntry {
    /// Formula that shows the body's name.
    pub name: View,
    /// Mass, mass centre and inertia of the body, as words and formulas.
    pub about: Vec<Run>,
}

/// Meaning of a symbol of the model.
pub struct Meaning {
    /// Formula that shows the symbol.
    pub symbol: View,
    /// Description of the symbol in words; often empty.
    pub about: String,
    /// Unit of the symbol; empty if it has none.
    pub unit: String,
}

/// A block of a document.
pub enum Block {
    /// A heading with its level.
    Heading(Level, Vec<Run>),
    /// A paragraph of words.
    Words(String),
    /// Equations below one another; the list may be empty.
    Equations(Vec<Equation>),
    /// Equations of motion as a linear system.
    System(System),
}

/// Level of a heading, by the extent of the text under it.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// Heading over a formulation, or over all conserved quantities.
    Section,
    /// Heading over a step of a derivation.
    Step,
    /// Heading over a single conserved quantity.
    Item,
}

/// Part of a heading: words or a formula.
pub enum Run {
    /// Plain words of a heading.
    Words(String),
    /// Formula in a heading.
    Formula(Left),
}

/// Left and right side of an equation.
pub type Equation = (Left, View);

/// Left side of an equation.
pub enum Left {
    /// Symbol of the model or of the derivation.
    Symbol(View),
    /// The number 0.
    Zero,
    /// Rate d(T + V)/dt of the energy.
    EnergyRate,
    /// Entry of a vector or matrix that the letter names, by its places from 1: f₁, M₁₂.
    Entry(char, Vec<usize>),
    /// Component of a generalized force, by its letter, along a motion variable.
    Along(char, View),
    /// Vector of a point, frame or body.
    Vector(Vector),
    /// Component of a vector along an axis.
    Component(Vector, Axis),
    /// Component, along an axis, of the partial derivative of a vector by a speed.
    Partial(Vector, View, Axis),
}

/// Vector of a point, frame or body in a frame, such as a velocity.
pub struct Vector {
    pub name: VectorName,
    /// Name of the frame in which the vector is measured.
    pub frame: String,
    /// Name of the point, frame or body whose vector it is.
    pub of: String,
}

/// Basis vector of a frame.
pub struct Axis {
    /// Name of the axis's frame, in small letters.
    pub frame: String,
    /// Number of the axis in its frame: 1, 2 or 3.
    pub number: usize,
}

/// Equations of motion as a linear system M x = f.
pub struct System {
    /// Names of the rows: the speed or the equation to which each row belongs.
    pub rows: Vec<String>,
    /// Unknowns x of the system.
    pub unknowns: Vec<View>,
    /// Matrix M, row by row.
    pub matrix: Vec<Vec<View>>,
    /// Places (row, column) of the entries of M that are not 0, from 0.
    pub filled: Vec<(usize, usize)>,
    /// Right side f of the system.
    pub forcing: Vec<View>,
}

impl Document {
    /// Makes a document about a model, without derivations yet.
    pub fn new(model: &Model, moving: &[MovingPlace]) -> Self {
        let about = std::iter::once(format!("{}.", model.count()));
        let about = about.chain(moving.iter().map(|place| place.text(model))).collect();
        let bodies = model.bodies.iter().map(|body| body_entry(model, body)).collect();
        Self { title: model.title.clone(), about, symbols: symbols(model), bodies, blocks: Vec::new() }
    }

    /// Adds a formulation to the document: steps, equations of motion, accelerations, energies, and divisors of the
    /// kinematic equations.
    pub fn formulation(&mut self, model: &Model, derivation: &DerivationInSteps, solved: Option<&Elimination>) {
        let DerivationInSteps { arena, equations: e, steps } = derivation;
        self.heading(Level::Section, e.formulation.title());
        if !e.definitions.is_empty() {
            self.heading(Level::Step, NAMED);
            self.definitions(arena, &e.definitions);
        }
        for step in steps {
            self.step(model, arena, step);
        }
        self.heading(Level::Step, "Equations of motion");
        self.blocks.push(Block::System(System::new(model, arena, e)));
        if let Some(solved) = solved {
            self.heading(Level::Step, "Accelerations");
            self.definitions(arena, &solved.steps);
        }
        self.heading(Level::Step, "Kinetic and potential energy");
        let symbol = |name: &str| Left::Symbol(symbol_view(arena, name));
        let mut energies =
            vec![(symbol("T"), view_of(arena, e.kinetic_energy)), (symbol("V"), view_of(arena, e.potential_energy))];
        if e.power != Expr::ZERO {
            energies.push((Left::EnergyRate, view_of(arena, e.power)));
        }
        self.blocks.push(Block::Equations(energies));
        if !e.divisors.is_empty() {
            self.heading(Level::Step, "Where the kinematic equations are singular");
            let divisors = e.divisors.iter().map(|divisor| (Left::Zero, view_of(arena, *divisor)));
            self.blocks.push(Block::Equations(divisors.collect()));
        }
    }

    /// Adds the conserved quantities to the document.
    pub fn integrals(&mut self, model: &Model, arena: &Arena, list: &[Integral]) {
        self.heading(Level::Section, "First integrals");
        if list.is_empty() {
            self.blocks.push(Block::Words("None found.".to_owned()));
        }
        for (at, integral) in list.iter().enumerate() {
            self.heading(Level::Item, &integral.name(model, arena));
            let value = view_of(arena, integral.expression);
            self.blocks.push(Block::Equations(vec![(Left::Entry('C', vec![at + 1]), value)]));
        }
        let shown: Vec<Expr> = list.iter().flat_map(|integral| integral.shown(arena)).collect();
        let names = glossary(arena, &shown);
        if !names.is_empty() {
            self.heading(Level::Step, NAMED);
            self.definitions(arena, &names);
        }
    }

    fn heading(&mut self, level: Level, words: &str) {
        self.blocks.push(Block::Heading(level, vec![Run::Words(words.to_owned())]));
    }

    fn definitions(&mut self, arena: &Arena, list: &[Definition]) {
        self.blocks.push(Block::Words("Each by those before it.".to_owned()));
        let symbol = |e: Expr| Left::Symbol(view_of(arena, e));
        let list = list.iter().map(|step| (symbol(step.symbol), view_of(arena, step.value)));
        self.blocks.push(Block::Equations(list.collect()));
    }

    fn step(&mut self, model: &Model, arena: &Arena, step: &Step) {
        let words = |text: &str| Run::Words(text.to_owned());
        let title = match step.stage {
            Stage::Velocities { vector, of, frame } => vec![
                words("Velocity and partial velocities: "),
                Run::Formula(Left::Vector(Vector::new(model, vector, of))),
                words(&format!(", components in {}", printed_name(&model.arena, &model.frames[frame].name))),
            ],
            stage => vec![words(&stage.title(model))],
        };
        self.blocks.push(Block::Heading(Level::Step, title));
        let lines = step.lines.iter().map(|(name, value)| (Left::of_line(model, name), view_of(arena, *value)));
        self.blocks.push(Block::Equations(lines.collect()));
    }
}

/// Meanings of the symbols of a model, with their units.
fn symbols(model: &Model) -> Vec<Meaning> {
    let meaning = |name: &str, about: &str, unit: &str| Meaning {
        symbol: symbol_view(&model.arena, name),
        about: about.to_owned(),
        unit: if unit == "1" { String::new() } else { unit.to_owned() },
    };
    let parameters = model.parameters.iter().map(|p| meaning(&p.name, &p.about, &p.unit.to_string()));
    let coordinates = model.coordinates.iter().map(|c| meaning(&c.name, &c.about, &c.unit.to_string()));
    let speeds = model.speeds.iter().map(|s| meaning(&s.name, "generalized speed", &s.unit.to_string()));
    let stated = model.reactions.iter().filter(|reaction| reaction.is_stated);
    let reactions = stated.map(|reaction| meaning(&reaction.name, "reaction", ""));
    parameters.chain(coordinates).chain(speeds).chain(reactions).collect()
}

/// Entry of a body: its mass, its mass centre, and its inertia about the mass centre.
fn body_entry(model: &Model, body: &Body) -> BodyEntry {
    let words = |text: &str| Run::Words(text.to_owned());
    let value = |e: Expr| Run::Formula(Left::Symbol(view_of(&model.arena, e)));
    let name = |name: &str| Run::Formula(Left::Symbol(symbol_view(&model.arena, name)));
    let mut about =
        vec![words("mass "), value(body.mass), words(", mass centre "), name(&model.points[body.centre].name)];
    let Some((_, Inertia { frame, tensor })) = &body.rigid else {
        let about =
            vec![words("particle of mass "), value(body.mass), words(" at "), name(&model.points[body.centre].name)];
        return BodyEntry { name: symbol_view(&model.arena, &body.name), about };
    };
    let axes = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
    let filled = axes.into_iter().filter(|(i, j)| tensor[*i][*j] != Expr::ZERO);
    let mut before = ", inertia about the mass centre ";
    for (i, j) in filled {
        let entry = Left::Entry('I', vec![i + 1, j + 1]);
        about.extend([words(before), Run::Formula(entry), words(" = "), value(tensor[i][j])]);
        before = ", ";
    }
    let frame = printed_name(&model.arena, &model.frames[*frame].name);
    let end = if before == ", " { format!(" in {frame}") } else { ", no inertia about the mass centre".to_owned() };
    about.push(words(&end));
    BodyEntry { name: symbol_view(&model.arena, &body.name), about }
}

impl System {
    fn new(model: &Model, arena: &Arena, equations: &Equations) -> Self {
        let views = |list: &[Expr]| list.iter().map(|e| view_of(arena, *e)).collect::<Vec<_>>();
        let places = equations.matrix.iter().enumerate().flat_map(|(i, row)| (0..row.len()).map(move |j| (i, j)));
        Self {
            filled: places.filter(|(i, j)| equations.matrix[*i][*j] != Expr::ZERO).collect(),
            rows: equations.row_names(model),
            unknowns: views(&equations.unknowns),
            matrix: equations.matrix.iter().map(|row| views(row)).collect(),
            forcing: views(&equations.forcing),
        }
    }
}

impl Vector {
    /// Vector of a point, frame or body in the inertial frame; `of` is its index in the model.
    fn new(model: &Model, name: VectorName, of: usize) -> Self {
        let printed = |name: &str| printed_name(&model.arena, name);
        Self { name, frame: printed(&model.frames[0].name), of: printed(name.owner_name(model, of)) }
    }
}

impl Left {
    /// Left side for the name of a line of a derivation.
    fn of_line(model: &Model, name: &LineName) -> Self {
        let basis = |frame: usize, axis: usize| Axis {
            frame: printed_name(&model.arena, &model.frames[frame].name).to_lowercase(),
            number: axis + 1,
        };
        let named = |name: &str| symbol_view(&model.arena, name);
        match name {
            LineName::Quantity(QuantityKind::Component { vector, of, frame, axis }) => {
                Self::Component(Vector::new(model, *vector, *of), basis(*frame, *axis))
            }
            LineName::Quantity(QuantityKind::Partial { vector, of, frame, axis, speed }) => {
                let speed = named(&model.speeds[*speed].name);
                Self::Partial(Vector::new(model, *vector, *of), speed, basis(*frame, *axis))
            }
            LineName::Quantity(kind) => Self::Symbol(named(&kind.name(model))),
            LineName::ActiveForce(at) => Self::Along('F', named(&model.speeds[*at].name)),
            LineName::GeneralizedForce(at) => Self::Along('Q', named(&model.coordinates[*at].name)),
            LineName::Symbol(symbol) => Self::Symbol(named(symbol)),
        }
    }
}
