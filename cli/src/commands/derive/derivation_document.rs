//! Document about a derivation, independent of a document language: meanings of symbols, all formulas, and first
//! integrals.
//!
//! Invariant: nothing here depends on the syntax of LaTeX, Markdown or Typst. Formulas are trees, left sides of
//! equations are data, and names are those of the model.

use crate::phrases::NAMED_TERMS_HEADING;
use tripos_derive::Model;
use tripos_derive::algebra::solve::elimination::Elimination;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::text::definitions::definitions_shown;
use tripos_derive::algebra::text::display_tree::DisplayTree;
use tripos_derive::algebra::text::print::{print_symbol_view, print_view, printed_name};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{
    DerivationInSteps, Equations, LineName, MovingLoadPlace, QuantityKind, Stage, Step, VectorName,
};
use tripos_derive::model::{Body, Inertia};
use tripos_derive::prove::Integral;

/// Document about the derivation of a model's equations, before it is written in a document
/// language.
pub struct Document {
    /// Title of the model, as the document's title.
    pub title: String,
    /// Paragraphs about the model that come before the list of symbols.
    pub about: Vec<String>,
    /// Symbols of the model with their meanings and units.
    pub symbols: Vec<Meaning>,
    /// Bodies of the model, in the order of the model file.
    pub bodies: Vec<BodyEntry>,
    /// Headings, paragraphs and equations that follow the list of bodies, in order.
    pub blocks: Vec<Block>,
}

/// Entry of a body in the document's list of bodies.
pub struct BodyEntry {
    /// Name of the body as a formula to be typeset.
    pub name: DisplayTree,
    /// Mass, mass centre and inertia of the body, in words and formulas.
    pub about: Vec<InlineContent>,
}

/// Symbol of the model with its meaning and unit.
pub struct Meaning {
    /// Symbol as a formula to be typeset.
    pub symbol: DisplayTree,
    /// Description of the symbol in words; empty if there is none.
    pub about: String,
    /// Unit of the symbol; empty if it has none.
    pub unit: String,
}

/// Block of a document: a heading, a paragraph, equations or a linear system.
pub enum Block {
    /// Heading with its level and its words and formulas.
    Heading(Level, Vec<InlineContent>),
    /// Paragraph of plain words.
    Words(String),
    /// Equations, one below the other; the list may be empty.
    Equations(Vec<Equation>),
    /// Equations of motion as a linear system.
    System(System),
}

/// Level of a heading in a document.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// Heading above a formulation, or above all first integrals.
    Section,
    /// Heading above a stage of a derivation, such as velocities.
    Step,
    /// Heading above a single first integral.
    Item,
}

/// Part of a heading or of an entry: words or a formula.
pub enum InlineContent {
    /// Plain words in a heading or an entry.
    Words(String),
    /// Formula within a heading or an entry.
    Formula(LeftSide),
}

/// Equation: its left side and its right side.
pub type Equation = (LeftSide, DisplayTree);

/// Left side of an equation in the document.
pub enum LeftSide {
    /// Left side that is a symbol of the model or of the derivation.
    Symbol(DisplayTree),
    /// Left side that is the number 0.
    Zero,
    /// Left side that is the rate d(T + V)/dt of the energy.
    EnergyRate,
    /// Entry of a vector or matrix: its letter, and its indices from 1, such as f₁ or M₁₂.
    Entry(char, Vec<usize>),
    /// Component of a generalized force: its letter, and the coordinate or speed to which it
    /// belongs.
    Along(char, DisplayTree),
    /// Vector of a point, frame or body, such as a velocity.
    Vector(Vector),
    /// Component of a vector along an axis of a frame.
    Component(Vector, Axis),
    /// Component, along an axis, of the partial derivative of a vector with respect to a generalized speed.
    Partial(Vector, DisplayTree, Axis),
}

/// Vector of a point, frame or body relative to a frame, such as a velocity.
pub struct Vector {
    /// Kind of the vector, such as velocity or angular acceleration.
    pub name: VectorName,
    /// Name of the frame relative to which the vector is measured.
    pub frame: String,
    /// Name of the point, frame or body to which the vector belongs.
    pub of: String,
}

/// Unit vector along an axis of a frame.
pub struct Axis {
    /// Name of the frame to which the unit vector belongs, in lower case.
    pub frame: String,
    /// Number of the axis in its frame: 1, 2 or 3.
    pub number: usize,
}

/// Equations of motion as a linear system M x = f, with formulas.
pub struct System {
    /// Names of the rows: the generalized speed or the equation to which each row belongs.
    pub rows: Vec<String>,
    /// Unknowns x of the system: accelerations, then reactions or multipliers.
    pub unknowns: Vec<DisplayTree>,
    /// Matrix M of the linear system, row by row, as formulas.
    pub matrix: Vec<Vec<DisplayTree>>,
    /// Indices (row, column), from 0, of the entries of M that are not 0.
    pub filled: Vec<(usize, usize)>,
    /// Right-hand side f of the linear system, one formula per row.
    pub forcing: Vec<DisplayTree>,
}

impl Document {
    /// Creates a document about a model: title, symbols and bodies, without derivations. `moving` describes points and
    /// frames whose motion is given.
    pub fn new(model: &Model, moving: &[MovingLoadPlace]) -> Self {
        let about = std::iter::once(format!("{}.", model.counts_in_words()));
        let about = about.chain(moving.iter().map(|place| place.text(model))).collect();
        let bodies = model.bodies.iter().map(|body| document_body_entry(model, body)).collect();
        Self { title: model.title.clone(), about, symbols: document_symbols(model), bodies, blocks: Vec::new() }
    }

    /// Adds a formulation to the document: its stages, equations of motion, accelerations,
    /// energies, and the divisors of the kinematic equations.
    pub fn formulation(&mut self, model: &Model, derivation: &DerivationInSteps, solved: Option<&Elimination>) {
        let DerivationInSteps { arena, equations: e, steps } = derivation;
        self.heading(Level::Section, e.formulation.title());
        if !e.definitions.is_empty() {
            self.heading(Level::Step, NAMED_TERMS_HEADING);
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
        let symbol = |name: &str| LeftSide::Symbol(print_symbol_view(arena, name));
        let mut energies = vec![
            (symbol("T"), print_view(arena, e.kinetic_energy)),
            (symbol("V"), print_view(arena, e.potential_energy)),
        ];
        if e.power != Expr::ZERO {
            energies.push((LeftSide::EnergyRate, print_view(arena, e.power)));
        }
        self.blocks.push(Block::Equations(energies));
        if !e.divisors.is_empty() {
            self.heading(Level::Step, "Where the kinematic equations are singular");
            let divisors = e.divisors.iter().map(|divisor| (LeftSide::Zero, print_view(arena, *divisor)));
            self.blocks.push(Block::Equations(divisors.collect()));
        }
    }

    /// Adds the first integrals of the motion to the document, with definitions of the names in the integrals.
    pub fn integrals(&mut self, model: &Model, arena: &Arena, list: &[Integral]) {
        self.heading(Level::Section, "First integrals");
        if list.is_empty() {
            self.blocks.push(Block::Words("None found.".to_owned()));
        }
        for (at, integral) in list.iter().enumerate() {
            self.heading(Level::Item, &integral.full_name(model, arena));
            let value = print_view(arena, integral.expression);
            self.blocks.push(Block::Equations(vec![(LeftSide::Entry('C', vec![at + 1]), value)]));
        }
        let shown: Vec<Expr> = list.iter().flat_map(|integral| integral.shown_formulas_of_integral(arena)).collect();
        let names = definitions_shown(arena, &shown);
        if !names.is_empty() {
            self.heading(Level::Step, NAMED_TERMS_HEADING);
            self.definitions(arena, &names);
        }
    }

    /// Adds a heading of plain words to the document.
    fn heading(&mut self, level: Level, words: &str) {
        self.blocks.push(Block::Heading(level, vec![InlineContent::Words(words.to_owned())]));
    }

    /// Adds definitions as equations, with a sentence about their order.
    fn definitions(&mut self, arena: &Arena, list: &[Definition]) {
        self.blocks.push(Block::Words("Each by those before it.".to_owned()));
        let symbol = |e: Expr| LeftSide::Symbol(print_view(arena, e));
        let list = list.iter().map(|step| (symbol(step.symbol), print_view(arena, step.value)));
        self.blocks.push(Block::Equations(list.collect()));
    }

    /// Adds a stage of the derivation: a heading and its equations.
    fn step(&mut self, model: &Model, arena: &Arena, step: &Step) {
        let words = |text: &str| InlineContent::Words(text.to_owned());
        let title = match step.stage {
            Stage::Velocities { vector, of, frame } => vec![
                words("Velocity and partial velocities: "),
                InlineContent::Formula(LeftSide::Vector(Vector::new(model, vector, of))),
                words(&format!(", components in {}", printed_name(&model.arena, &model.frames[frame].name))),
            ],
            stage => vec![words(&stage.title(model))],
        };
        self.blocks.push(Block::Heading(Level::Step, title));
        let lines = step.lines.iter().map(|(name, value)| (LeftSide::of_line(model, name), print_view(arena, *value)));
        self.blocks.push(Block::Equations(lines.collect()));
    }
}

/// Returns the meanings and units of the model's parameters, coordinates, speeds and stated
/// reactions.
fn document_symbols(model: &Model) -> Vec<Meaning> {
    let meaning = |name: &str, about: &str, unit: &str| Meaning {
        symbol: print_symbol_view(&model.arena, name),
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

/// Returns the document's entry for a body: its mass, its mass centre, and its inertia about the
/// mass centre.
fn document_body_entry(model: &Model, body: &Body) -> BodyEntry {
    let words = |text: &str| InlineContent::Words(text.to_owned());
    let value = |e: Expr| InlineContent::Formula(LeftSide::Symbol(print_view(&model.arena, e)));
    let name = |name: &str| InlineContent::Formula(LeftSide::Symbol(print_symbol_view(&model.arena, name)));
    let mut about =
        vec![words("mass "), value(body.mass), words(", mass centre "), name(&model.points[body.centre].name)];
    let Some((_, Inertia { frame, tensor })) = &body.rigid else {
        let about =
            vec![words("particle of mass "), value(body.mass), words(" at "), name(&model.points[body.centre].name)];
        return BodyEntry { name: print_symbol_view(&model.arena, &body.name), about };
    };
    let axes = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
    let filled = axes.into_iter().filter(|(i, j)| tensor[*i][*j] != Expr::ZERO);
    let mut before = ", inertia about the mass centre ";
    for (i, j) in filled {
        let entry = LeftSide::Entry('I', vec![i + 1, j + 1]);
        about.extend([words(before), InlineContent::Formula(entry), words(" = "), value(tensor[i][j])]);
        before = ", ";
    }
    let frame = printed_name(&model.arena, &model.frames[*frame].name);
    let end = if before == ", " { format!(" in {frame}") } else { ", no inertia about the mass centre".to_owned() };
    about.push(words(&end));
    BodyEntry { name: print_symbol_view(&model.arena, &body.name), about }
}

impl System {
    /// Returns the linear system of equations with its terms as formulas.
    fn new(model: &Model, arena: &Arena, equations: &Equations) -> Self {
        let views = |list: &[Expr]| list.iter().map(|e| print_view(arena, *e)).collect::<Vec<_>>();
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
    /// Returns a vector of the point, frame or body with index `of`, relative to the inertial
    /// frame.
    fn new(model: &Model, name: VectorName, of: usize) -> Self {
        let printed = |name: &str| printed_name(&model.arena, name);
        Self { name, frame: printed(&model.frames[0].name), of: printed(name.owner_name(model, of)) }
    }
}

impl LeftSide {
    /// Returns the left side of a line of a derivation, from the name of the line.
    fn of_line(model: &Model, name: &LineName) -> Self {
        let basis = |frame: usize, axis: usize| Axis {
            frame: printed_name(&model.arena, &model.frames[frame].name).to_lowercase(),
            number: axis + 1,
        };
        let named = |name: &str| print_symbol_view(&model.arena, name);
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
