//! What the start of a scene fixes, to 32 digits: the parameters of its generated equations, and their state.
//!
//! Invariant: no number stands here. Formulas come from the reduction of the scene as the deriving crate makes it, values from the
//! scene's file, and both meet the generated module by the names of its parameters; a module of another reduction is refused.
//! Absent on purpose: exponentials, logarithms and inverse functions, which no constant of the disk has.

use tripos_derive::Model;
use tripos_derive::algebra::{Arena, Expr, Function, Node};
use tripos_derive::reduce::{Reduction, reduce};
use tripos_derive::scene::{Extended, Scene};
use tripos_traits::{DoubleDouble, Real, Scalar};

/// The parameters and the state of a scene's generated equations, as functions of its start.
pub struct Beginning {
    values: Values,
    /// How many of the values are parameters; the others are coordinates, then speeds.
    parameters: usize,
}

impl Beginning {
    /// For a generated module with this key and parameters of these names.
    ///
    /// # Errors
    /// What is wrong, in words, if the scene cannot be reduced, or the module was generated from something else.
    pub fn new(model: &Model, scene: &Scene, key: &str, names: &[&str]) -> Result<Self, String> {
        let reduction = reduce(model, scene).map_err(|error| format!("{}", model.diagnose(&error)))?;
        if reduction.key() != key {
            return Err("the generated module is of another scene: run `tripos regenerate`".to_owned());
        }
        let missing = |what: &str| format!("the scene does not say what `{what}` is at the start");
        let parameter = |name: &&str| parameter(model, &reduction, name).ok_or_else(|| missing(name));
        let mut wanted = names.iter().map(parameter).collect::<Result<Vec<_>, _>>()?;
        let equations = &reduction.derivation.equations;
        for symbol in equations.coordinates.iter().chain(&equations.variables) {
            let mut variables = reduction.states.iter().chain(&reduction.quadratures);
            let variable = variables.find(|variable| variable.symbol == *symbol);
            wanted.push(variable.ok_or_else(|| missing("a variable"))?.of_start);
        }
        // The start is p, q and q′, and the speeds are formulas in these.
        let inputs = [model.p(), model.q(), model.q_dot()].concat();
        let speeds: Vec<_> = model.u().into_iter().zip(model.speeds.iter().map(|speed| speed.definition)).collect();
        let values = Values::new(reduction.terms(), &inputs, &speeds, &wanted)?;
        Ok(Self { values, parameters: names.len() })
    }

    /// Parameters and state for a start: p, q and q′ one after the other.
    pub fn at(&self, start: &[DoubleDouble]) -> (Vec<f64>, Vec<f64>) {
        let mut parameters = self.values.at(start);
        let state = parameters.split_off(self.parameters);
        (parameters, state)
    }
}

/// The formula of a parameter: of a constant of the motion, or the model's own.
fn parameter(model: &Model, reduction: &Reduction, name: &str) -> Option<Expr> {
    let constant = reduction.constants.iter().find(|constant| constant.name == name).map(|constant| constant.of_start);
    constant.or_else(|| model.parameters.iter().find(|own| own.name == name).map(|own| own.symbol))
}

/// Terms as a list of parts, each made from those before it: a value costs one pass.
struct Values {
    parts: Vec<Part>,
    wanted: Vec<usize>,
}

/// A part, its operands by their places.
enum Part {
    /// A number of the start, by its place there.
    Start(usize),
    Number(DoubleDouble),
    /// constant + Σ k·part
    Sum(DoubleDouble, Vec<(usize, DoubleDouble)>),
    /// Π part^n
    Product(Vec<(usize, i32)>),
    Sine(usize),
    Cosine(usize),
    Root(usize),
}

impl Values {
    /// Of these terms, in what the start states and in what is defined from it.
    fn new(arena: &Arena, inputs: &[Expr], defined: &[(Expr, Expr)], wanted: &[Expr]) -> Result<Self, String> {
        let mut parts: Vec<Part> = (0..inputs.len()).map(Part::Start).collect();
        let mut places: Vec<(Expr, usize)> = inputs.iter().copied().zip(0..).collect();
        for (symbol, term) in defined {
            append(arena, &[*term], &mut parts, &mut places)?;
            let place = place(&places, *term)?;
            places.push((*symbol, place));
        }
        append(arena, wanted, &mut parts, &mut places)?;
        let wanted = wanted.iter().map(|term| place(&places, *term)).collect::<Result<_, _>>()?;
        Ok(Self { parts, wanted })
    }

    /// For a start, rounded to doubles at the end alone.
    fn at(&self, start: &[DoubleDouble]) -> Vec<f64> {
        let mut values: Vec<DoubleDouble> = Vec::with_capacity(self.parts.len());
        for part in &self.parts {
            let value = match part {
                Part::Start(at) => start[*at],
                Part::Number(value) => *value,
                Part::Sum(constant, terms) => terms.iter().fold(*constant, |sum, (at, k)| sum + values[*at] * *k),
                Part::Product(factors) => {
                    factors.iter().fold(DoubleDouble::int(1), |product, (at, n)| product * values[*at].powi(*n))
                }
                Part::Sine(at) => values[*at].sin_cos().0,
                Part::Cosine(at) => values[*at].sin_cos().1,
                Part::Root(at) => values[*at].sqrt(),
            };
            values.push(value);
        }
        self.wanted.iter().map(|at| values[*at].to_f64()).collect()
    }
}

/// Adds the parts of these terms that are not there yet.
fn append(arena: &Arena, terms: &[Expr], parts: &mut Vec<Part>, places: &mut Vec<(Expr, usize)>) -> Result<(), String> {
    for term in arena.reachable(terms) {
        if place(places, term).is_err() {
            let part = part(arena, term, places)?;
            places.push((term, parts.len()));
            parts.push(part);
        }
    }
    Ok(())
}

fn part(arena: &Arena, term: Expr, places: &[(Expr, usize)]) -> Result<Part, String> {
    let number = |value| wide(&Extended::of(value));
    Ok(match arena.node(term) {
        Node::Number(value) => Part::Number(number(value)),
        Node::Pi => Part::Number(DoubleDouble::pi()),
        Node::Symbol(_) => return Err("a constant needs more than the start states".to_owned()),
        Node::Sum(constant, terms) => {
            let terms = terms.iter().map(|(term, k)| Ok((place(places, *term)?, number(k))));
            Part::Sum(number(constant), terms.collect::<Result<_, String>>()?)
        }
        Node::Product(factors) => {
            let factors = factors.iter().map(|(base, n)| Ok((place(places, *base)?, *n)));
            Part::Product(factors.collect::<Result<_, String>>()?)
        }
        Node::Apply(Function::Sin, argument) => Part::Sine(place(places, *argument)?),
        Node::Apply(Function::Cos, argument) => Part::Cosine(place(places, *argument)?),
        Node::Apply(Function::Sqrt, argument) => Part::Root(place(places, *argument)?),
        Node::Apply(..) => return Err("a constant has a function that is not evaluated here".to_owned()),
    })
}

fn place(places: &[(Expr, usize)], term: Expr) -> Result<usize, String> {
    let found = places.iter().find(|(known, _)| *known == term);
    found.map(|(_, at)| *at).ok_or_else(|| "a constant needs what is not defined before it".to_owned())
}

/// A number of a scene, with all its digits.
pub fn wide(number: &Extended) -> DoubleDouble {
    DoubleDouble::sum(number.high, number.low)
}
