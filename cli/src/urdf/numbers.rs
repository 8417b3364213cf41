//! Numbers of a model's terms: values at the default parameters, and slopes along coordinates.

use tripos_derive::Model;
use tripos_derive::algebra::term::calculus::{Gradient, Substitution};
use tripos_derive::algebra::value::positive_range::positive_range;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr};

/// Evaluator of a model's terms. Parameters have their default values, and coordinates and rates are 0.
pub struct Numbers {
    /// Copy of the model's arena, with the terms that the evaluator makes.
    pub arena: Arena,
    /// Symbols of the coordinates, without time.
    pub coordinates: Vec<Expr>,
    /// Symbols of the rates of these coordinates.
    pub rates: Vec<Expr>,
    /// Symbols of the parameters that have a default value; inputs are left out.
    parameters: Vec<Expr>,
    /// Default values of these parameters, in SI units.
    values: Vec<f64>,
    /// Replacement of the generalized speeds by their definitions.
    speeds: Substitution,
}

/// Term as a number plus numbers times coordinates.
#[derive(Clone, Debug)]
pub struct Affine {
    /// Coordinates with a slope other than 0, each with its slope.
    pub slopes: Vec<(usize, f64)>,
    /// Value where all coordinates are 0.
    pub constant: f64,
}

impl Numbers {
    /// Creates the evaluator of a model.
    pub fn new(model: &Model) -> Self {
        let count = model.coordinates.len() - usize::from(model.time().is_some());
        let coordinates = &model.coordinates[..count];
        let known = model.parameters.iter().filter(|parameter| !parameter.is_input);
        let known = known.filter_map(|parameter| Some((parameter.symbol, parameter.value.as_ref()?.to_f64())));
        let (parameters, values) = known.unzip();
        let definitions: Vec<(Expr, Expr)> =
            model.speeds.iter().map(|speed| (speed.symbol, speed.definition)).collect();
        Self {
            arena: model.arena.clone(),
            coordinates: coordinates.iter().map(|coordinate| coordinate.symbol).collect(),
            rates: coordinates.iter().map(|coordinate| coordinate.rate).collect(),
            parameters,
            values,
            speeds: Substitution::new(&definitions),
        }
    }

    /// Value of a term in parameters alone. `None` if the term contains another symbol or a parameter without value, or
    /// if it has no finite value.
    pub fn constant(&self, e: Expr) -> Option<f64> {
        self.value(e, &[])
    }

    /// Value of a term in parameters and in further symbols with these values. `None` as for [`Self::constant`].
    pub fn value(&self, e: Expr, others: &[(Expr, f64)]) -> Option<f64> {
        let symbols: Vec<Expr> = self.parameters.iter().copied().chain(others.iter().map(|(e, _)| *e)).collect();
        let values: Vec<f64> = self.values.iter().copied().chain(others.iter().map(|(_, value)| *value)).collect();
        let tape = Tape::new(&self.arena, &symbols, &[e]).ok()?;
        tape.evaluate(&values).first().copied().filter(|value| value.is_finite())
    }

    /// Values of terms in parameters alone. `None` as for [`Self::constant`].
    pub fn constants<const N: usize>(&self, terms: &[Expr; N]) -> Option<[f64; N]> {
        let mut values = [0.0; N];
        for (value, term) in values.iter_mut().zip(terms) {
            *value = self.constant(*term)?;
        }
        Some(values)
    }

    /// Term with generalized speeds replaced by their definitions.
    pub fn without_speeds(&mut self, e: Expr) -> Expr {
        self.speeds.apply(&mut self.arena, e)
    }

    /// Derivative of a term along a symbol.
    pub fn slope(&mut self, e: Expr, along: Expr) -> Expr {
        let slopes = Gradient::new(&[along]).apply(&mut self.arena, e);
        slopes.first().map_or(Expr::ZERO, |(_, slope)| *slope)
    }

    /// Only coordinate of a term, with the range in which the term is positive, rad or m. `None` if the term has
    /// another number of coordinates, or is no limit of its coordinate.
    pub fn positive_range(&mut self, positive: Expr) -> Option<(usize, (f64, f64))> {
        let mentioned = |coordinate: &Expr| self.arena.mentions(positive, *coordinate);
        let mut own = (0..self.coordinates.len()).filter(|at| mentioned(&self.coordinates[*at]));
        let (Some(at), None) = (own.next(), own.next()) else { return None };
        let known: Vec<(Expr, f64)> = self.parameters.iter().copied().zip(self.values.iter().copied()).collect();
        let range = positive_range(&mut self.arena, &known, positive, self.coordinates[at])?;
        Some((at, range))
    }

    /// Term as a number plus numbers times coordinates. `None` if it is no such sum, for example because its slopes
    /// depend on coordinates, or because it contains the time or a parameter without value.
    pub fn affine(&mut self, e: Expr) -> Option<Affine> {
        let found = Gradient::new(&self.coordinates).apply(&mut self.arena, e);
        let mut slopes = Vec::new();
        for (at, slope) in found.iter() {
            let slope = self.constant(*slope)?;
            if slope != 0.0 {
                slopes.push((*at, slope));
            }
        }
        // The slopes are constant, so that the term is known from its value at one place.
        let zeros: Vec<(Expr, f64)> = found.iter().map(|(at, _)| (self.coordinates[*at], 0.0)).collect();
        Some(Affine { slopes, constant: self.value(e, &zeros)? })
    }
}
