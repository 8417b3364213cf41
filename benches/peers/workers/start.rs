//! The start of a scene in its generated equations, to 32 digits: their parameters and their state.
//!
//! Invariant: no number stands here. Formulas come from the reduction of the scene as the deriving crate makes it,
//! values from the scene's file, and both meet the generated module by the names of its parameters; a module of another
//! reduction is refused.

use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::reduce::{Reduction, reduce};
use tripos_derive::scene::Scene;
use tripos_traits::{DoubleDouble, Real};

/// The parameters and the state of a scene's generated equations, as functions of its start.
pub struct Beginning {
    values: Tape<DoubleDouble>,
    /// Number of parameters, which come first among the values; coordinates follow, then speeds.
    parameters: usize,
}

impl Beginning {
    /// For a generated module with this key and parameters of these names.
    ///
    /// # Errors
    /// What is wrong, in words, if the scene cannot be reduced, or the module was generated from something else.
    pub fn new(model: &Model, scene: &Scene, key: &str, names: &[&str]) -> Result<Self, String> {
        let reduction = reduce(model, scene).map_err(|error| format!("{}", model.diagnose(&error)))?;
        if reduction.reduction_hash() != key {
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
        let speeds = model.speeds.iter().map(|speed| Definition { symbol: speed.symbol, value: speed.definition });
        let values = Tape::stepwise(reduction.arena(), &inputs, &speeds.collect::<Vec<_>>(), &wanted);
        let values = values.map_err(|unknown| format!("the start does not state `{}`", unknown.0))?.to();
        Ok(Self { values, parameters: names.len() })
    }

    /// Parameters and state for a start: p, q and q′ one after the other.
    pub fn at(&self, start: &[DoubleDouble]) -> (Vec<f64>, Vec<f64>) {
        let values = self.values.evaluate(start);
        let mut parameters: Vec<f64> = values.iter().map(|x| x.to_f64()).collect();
        let state = parameters.split_off(self.parameters);
        (parameters, state)
    }
}

/// The formula of a parameter: of a constant of the motion, or the model's own.
fn parameter(model: &Model, reduction: &Reduction, name: &str) -> Option<Expr> {
    let constant = reduction.constants.iter().find(|constant| constant.name == name).map(|constant| constant.of_start);
    constant.or_else(|| model.parameters.iter().find(|own| own.name == name).map(|own| own.symbol))
}
