//! A derivation as a document, in no language yet: the meanings of symbols, all formulas of the text, and the conserved
//! quantities.
//!
//! Invariant: nothing here is in a language of documents. Formulas are trees of marks and left sides data; words are as
//! the model has them.

use crate::words::NAMED;
use tripos_derive::Model;
use tripos_derive::algebra::solve::elimination::Elimination;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::text::definitions::glossary;
use tripos_derive::algebra::text::print::{symbol_view, view_of};
use tripos_derive::algebra::text::view::View;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{
    DerivationInSteps, Equations, LineName, MovingPlace, QuantityKind, Stage, Step, VectorName,
};
use tripos_derive::prove::Integral;

/// A document about a model.
pub struct Document {
    /// The model's name.
    pub title: String,
    /// Paragraphs about the model.
    pub about: Vec<String>,
    /// Meanings of the symbols.
    pub symbols: Vec<Meaning>,
    /// The rest, in order.
    pub blocks: Vec<Block>,
}

/// Meaning of a symbol.
pub struct Meaning {
    /// The symbol.
    pub symbol: View,
    /// Its description, in words; often empty.
    pub about: String,
    /// Its unit; empty where there is none to say.
    pub unit: String,
}

/// A piece of a document.
pub enum Block {
    /// A heading.
    Heading(Level, Vec<Run>),
    /// A paragraph.
    Words(String),
    /// Equations below one another; none where there is nothing to list.
    Equations(Vec<Equation>),
    /// Equations of motion.
    System(System),
}

/// Extent of the text under a heading.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// A formulation, or all that is conserved.
    Section,
    /// A step of a derivation.
    Step,
    /// One thing that is conserved.
    Item,
}

/// A stretch of a heading.
pub enum Run {
    /// Plain words.
    Words(String),
    /// A formula.
    Formula(Left),
}

/// Left and right side of an equation.
pub type Equation = (Left, View);

/// The left side of an equation.
pub enum Left {
    /// A symbol.
    Symbol(View),
    /// The number 0.
    Zero,
    /// d(T + V)/dt.
    EnergyRate,
    /// An entry of what a letter stands for, by its places from 1: f₁, M₁₂.
    Entry(char, Vec<usize>),
    /// The part of a force along a motion variable.
    Along(char, View),
    /// A vector.
    Vector(Vector),
    /// A component of a vector.
    Component(Vector, Axis),
    /// A component of the partial derivative of a vector by a speed.
    Partial(Vector, View, Axis),
}

/// A vector of a point, frame or body in a frame.
pub struct Vector {
    pub name: VectorName,
    /// The frame's name.
    pub frame: String,
    /// The name of the point, frame or body.
    pub of: String,
}

/// A basis vector of a frame.
pub struct Axis {
    /// The frame's name in small letters.
    pub frame: String,
    /// 1, 2 or 3.
    pub number: usize,
}

/// The linear system M x = f.
pub struct System {
    /// Names of the rows: the speed or the equation that each belongs to.
    pub rows: Vec<String>,
    /// The unknowns x.
    pub unknowns: Vec<View>,
    /// M, row by row.
    pub matrix: Vec<Vec<View>>,
    /// The places of its entries that are not 0, from 0.
    pub filled: Vec<(usize, usize)>,
    /// The right side f.
    pub forcing: Vec<View>,
}

impl Document {
    /// A document without its derivations.
    pub fn new(model: &Model, moving: &[MovingPlace]) -> Self {
        let about = std::iter::once(format!("{}.", model.count()));
        let about = about.chain(moving.iter().map(|place| place.text(model))).collect();
        Self { title: model.title.clone(), about, symbols: symbols(model), blocks: Vec::new() }
    }

    /// Adds one formulation: steps, equations of motion, accelerations, energies, and where the kinematic equations are
    /// singular.
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

    /// Adds what is conserved.
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
                words(&format!(", components in {}", model.frames[frame].name)),
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
    /// A vector of a point, frame or body in the inertial frame.
    fn new(model: &Model, name: VectorName, of: usize) -> Self {
        Self { name, frame: model.frames[0].name.clone(), of: name.owner_name(model, of).to_owned() }
    }
}

impl Left {
    /// The name of a line of a derivation.
    fn of_line(model: &Model, name: &LineName) -> Self {
        let basis =
            |frame: usize, axis: usize| Axis { frame: model.frames[frame].name.to_lowercase(), number: axis + 1 };
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
        }
    }
}
