//! Search for a change of variables between two models of one mechanism: renamed parameters and coordinates, other
//! signs and zeros of coordinates, other speeds.
//!
//! The change is chosen by numbers and proved by algebra. The old variables are formulas in the new variables. With
//! them, the old T must equal the new T, and the old V must equal the new V up to a constant. The old constraints must
//! hold, and the accelerations of the new model must satisfy every old row of Kane's equations. Models with loops are
//! left out, because equations tie their coordinates together.

use super::derived_model::DerivedModel;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::term::transfer::Transfer;
use crate::algebra::text::print::print_text;
use crate::algebra::value::field::Generator;
use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr, Rational};
use crate::mechanics::{Formulation, Quantities, rates_to_speeds};
use crate::model::{Model, TIME, Unit};

/// Largest number of changes of variables that are tested with numbers.
const MOST: usize = 20_000;
/// Largest number of changes of variables for which a proof is tried, after the numerical test has passed.
const MOST_PROOFS: usize = 4;
/// Largest number of permutations in which renamed parameters or coordinates of one unit are
/// matched.
const MOST_ORDERS: usize = 720;
/// Number of random states at which the energies of both models are compared.
const STATES: usize = 3;
/// Relative difference below which two energies count as equal.
const NEAR: f64 = 1e-9;
/// Constants, in quarter turns of π/2 rad, by which the zero of an angle may be moved.
const QUARTERS: [i8; 4] = [0, 1, 2, -1];

/// Kind of an old variable that is expressed differently in the new model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VariableKind {
    /// Parameter of the model.
    Parameter,
    /// Generalized coordinate of the model.
    Coordinate,
    /// Generalized speed of the model.
    Speed,
}

impl VariableKind {
    /// English noun for the kind of variable, such as "coordinate".
    #[must_use]
    pub const fn noun(self) -> &'static str {
        match self {
            Self::Parameter => "parameter",
            Self::Coordinate => "coordinate",
            Self::Speed => "speed",
        }
    }
}

/// Old variable expressed as a formula in variables of the new model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VariableChange {
    /// Kind of the old variable: parameter, coordinate or speed.
    pub kind: VariableKind,
    /// Name of the variable in the old model.
    pub old: String,
    /// Formula in variables of the new model, as text.
    pub new: String,
}

/// Image of an old coordinate: plus or minus a coordinate of the new model, plus quarter turns.
#[derive(Clone, Copy, PartialEq, Eq)]
struct VariableImage {
    /// Index of the coordinate in the new model that corresponds to the old one.
    to: usize,
    /// True if the new coordinate has the factor −1; false for +1.
    is_turned: bool,
    /// Constant added to the coordinate, in quarter turns of π/2 rad.
    quarters: i8,
}

/// Proposed change of variables: a new parameter for each old parameter, and an image for each old coordinate.
#[derive(Clone)]
struct VariableChoice {
    /// Index of the new parameter for each old parameter.
    parameters: Vec<usize>,
    /// Image of each old coordinate in the new coordinates.
    images: Vec<VariableImage>,
}

/// Old variables as formulas in the new variables, if a proof shows that the motion is the same. Returns `None` if no
/// such change of variables is found, or if every variable keeps its name and meaning.
pub fn find_variable_changes(old: &mut DerivedModel<'_>, new: &mut DerivedModel<'_>) -> Option<Vec<VariableChange>> {
    let (before, after) = (old.model, new.model);
    let counts = |m: &Model| (m.parameters.len(), m.coordinates.len(), m.speeds.len(), m.motion_constraints.len());
    if counts(before) != counts(after) || !before.loops.is_empty() || !after.loops.is_empty() {
        return None;
    }
    let energies = ModelEnergies::new(old, new)?;
    let mut proofs = 0;
    for choice in variable_choices(before, after) {
        if !energies.agree(&choice) {
            continue;
        }
        proofs += 1;
        if let Some(changes) = prove_variable_change(old, new, &choice) {
            return Some(changes).filter(|list| !list.is_empty());
        }
        if proofs == MOST_PROOFS {
            break;
        }
    }
    None
}

/// Changes of variables to try, with the fewest changed signs and zeros first; at most 20 000.
fn variable_choices(old: &Model, new: &Model) -> Vec<VariableChoice> {
    let parameters = |m: &Model| m.parameters.iter().map(|p| (p.name.clone(), p.unit.clone())).collect::<Vec<_>>();
    let coordinates = |m: &Model| m.coordinates.iter().map(|c| (c.name.clone(), c.unit.clone())).collect::<Vec<_>>();
    let (parameters, coordinates) =
        (name_matches(&parameters(old), &parameters(new)), name_matches(&coordinates(old), &coordinates(new)));
    let angle = |at: usize| new.coordinates[at].unit == Unit::new(0, 0, 0) && new.coordinates[at].name != TIME;
    let mut list = Vec::new();
    for size in 0..=new.coordinates.len() {
        for order in &coordinates {
            for images in variable_images(order, size, &angle, MOST - list.len()) {
                for parameters in &parameters {
                    list.push(VariableChoice { parameters: parameters.clone(), images: images.clone() });
                    if list.len() == MOST {
                        return list;
                    }
                }
            }
        }
    }
    list
}

/// Matches of old names with new names. Equal names match each other. Other names are matched in every order in which
/// the units are equal. Each match lists the index of the new name for each old name.
fn name_matches(old: &[(String, Unit)], new: &[(String, Unit)]) -> Vec<Vec<usize>> {
    let mut list: Vec<Vec<usize>> = vec![Vec::new()];
    for (name, unit) in old {
        let own = new.iter().position(|(n, _)| n == name);
        let renamed = |at: &usize| new[*at].1 == *unit && old.iter().all(|(n, _)| *n != new[*at].0);
        let to: Vec<usize> = own.map_or_else(|| (0..new.len()).filter(renamed).collect(), |at| vec![at]);
        let longer = list.iter().flat_map(|done| {
            to.iter().filter(|at| !done.contains(at)).map(|at| [done.as_slice(), &[*at]].concat()).collect::<Vec<_>>()
        });
        list = longer.take(MOST_ORDERS).collect();
    }
    list
}

/// Images of the coordinates that are matched in `order`. Exactly `size` coordinates of each list have another sign or
/// zero; at most `most` lists.
fn variable_images(
    order: &[usize],
    size: usize,
    is_angle: &impl Fn(usize) -> bool,
    most: usize,
) -> Vec<Vec<VariableImage>> {
    let mut list: Vec<(Vec<VariableImage>, usize)> = vec![(Vec::new(), 0)];
    for (done, to) in order.iter().enumerate() {
        let quarters: &[i8] = if is_angle(*to) { &QUARTERS } else { &[0] };
        let mut longer = Vec::new();
        for (images, changed) in &list {
            for is_turned in [false, true] {
                for quarters in quarters {
                    let own = usize::from(is_turned || *quarters != 0);
                    let left = order.len() - done - 1;
                    if changed + own <= size && changed + own + left >= size && longer.len() < most {
                        let image = VariableImage { to: *to, is_turned, quarters: *quarters };
                        longer.push(([images.as_slice(), &[image]].concat(), changed + own));
                    }
                }
            }
        }
        list = longer;
    }
    list.into_iter().map(|(images, _)| images).collect()
}

/// Energies T and V of both models in numbers, at random states of the new model.
struct ModelEnergies {
    /// Program for T and V of the old model, in J. Its inputs are the old parameters, coordinates and rates.
    old: Tape,
    /// Random values of the new model's parameters. They are equal in all states, because V may differ by a constant
    /// that depends on them.
    parameters: Vec<f64>,
    /// Random states of the new model at which the energies are compared.
    states: Vec<EnergyState>,
}

/// State of the new model with its kinetic and potential energy.
struct EnergyState {
    /// Values of the generalized coordinates at the state.
    coordinates: Vec<f64>,
    /// Rates q̇ of the coordinates, permitted by the constraints.
    rates: Vec<f64>,
    /// Kinetic energy T of the new model at the state.
    kinetic: f64,
    /// Potential energy V of the new model at the state.
    potential: f64,
}

impl ModelEnergies {
    /// Energies of two models at random states; `None` if a model has no Kane equations, or if no
    /// states have finite values.
    fn new(old: &mut DerivedModel<'_>, new: &mut DerivedModel<'_>) -> Option<Self> {
        let of = |derived: &mut DerivedModel<'_>| {
            let model = derived.model;
            let kane = derived.derivations.get(Formulation::Kane)?;
            let energies = [kane.kinetic_energy, kane.potential_energy];
            let speeds: Vec<_> = model.speeds.iter().map(|s| (s.symbol, s.definition)).collect();
            let arena = &mut derived.derivations.kinematics.arena;
            let mut in_rates = Substitution::new(&speeds);
            let energies = energies.map(|e| in_rates.apply(arena, e));
            let inputs = [model.p(), model.q(), model.q_dot()].concat();
            Tape::new(arena, &inputs, &energies).ok()
        };
        let (before, after) = (of(old)?, of(new)?);
        let model = new.model;
        // The random rates satisfy the constraints of the new model.
        let inputs = [model.p(), model.q(), model.u()].concat();
        let rates = Tape::new(&new.derivations.kinematics.arena, &inputs, &model.kinematic_equations.rates).ok()?;
        let mut generator = Generator(1);
        let parameters: Vec<f64> =
            model.parameters.iter().map(|_| random_variable_value(&mut generator).abs()).collect();
        let mut states = Vec::new();
        for _ in 0..20 * STATES {
            let mut draw =
                |count: usize| (0..count).map(|_| random_variable_value(&mut generator)).collect::<Vec<f64>>();
            let (coordinates, speeds) = (draw(model.coordinates.len()), draw(model.speeds.len()));
            let rates = rates.evaluate(&[parameters.as_slice(), &coordinates, &speeds].concat());
            let found = after.evaluate(&[parameters.as_slice(), &coordinates, &rates].concat());
            if rates.iter().chain(&found).all(|x| x.is_finite()) {
                let (kinetic, potential) = (found[0], found[1]);
                states.push(EnergyState { coordinates, rates, kinetic, potential });
            }
            if states.len() == STATES {
                return Some(Self { old: before, parameters, states });
            }
        }
        None
    }

    /// True if, after the change of variables, T of both models is equal in all states, and V is equal up to a
    /// constant.
    fn agree(&self, choice: &VariableChoice) -> bool {
        let mut zero: Option<f64> = None;
        self.states.iter().all(|state| {
            let mut inputs: Vec<f64> = choice.parameters.iter().map(|at| self.parameters[*at]).collect();
            let sign = |image: &VariableImage| if image.is_turned { -1.0 } else { 1.0 };
            let turned = |image: &VariableImage| {
                sign(image) * state.coordinates[image.to] + f64::from(image.quarters) * std::f64::consts::FRAC_PI_2
            };
            inputs.extend(choice.images.iter().map(turned));
            inputs.extend(choice.images.iter().map(|image| sign(image) * state.rates[image.to]));
            let found = self.old.evaluate(&inputs);
            let own = found[1] - state.potential;
            let size = NEAR * [found[1], state.potential, 1.0].map(f64::abs).into_iter().fold(0.0, f64::max);
            let is_shifted = (own - *zero.get_or_insert(own)).abs() <= size;
            is_shifted && (found[0] - state.kinetic).abs() <= NEAR * state.kinetic.abs().max(1.0)
        })
    }
}

/// Random number with an absolute value from 0.3 to 1.7, of either sign.
fn random_variable_value(generator: &mut Generator) -> f64 {
    let size = 0.3 + f64::from(u32::try_from(generator.next() % 1_400_000).unwrap_or(0)) * 1e-6;
    if generator.next().is_multiple_of(2) { size } else { -size }
}

/// Old variables that change under a proposed change of variables, if algebra proves the change; `None` without a
/// proof.
fn prove_variable_change(
    old: &mut DerivedModel<'_>,
    new: &mut DerivedModel<'_>,
    choice: &VariableChoice,
) -> Option<Vec<VariableChange>> {
    let (before, after) = (old.model, new.model);
    let mut put = OldVariables::new(old, new, choice);
    let own = old.derivations.get(Formulation::Kane)?;
    let mut quantities = Quantities::new(after, new.derivations);
    let mut comparer = Comparer::default();
    let kane = quantities.derivations.get(Formulation::Kane)?;
    let (t, v) = (kane.kinetic_energy, kane.potential_energy);
    let from = &old.derivations.kinematics.arena;
    let mut is_zero = |quantities: &mut Quantities<'_>, e: Expr| {
        comparer.is_zero(&mut quantities.derivations.kinematics.arena, e).is_equal()
    };
    let kinetic = put.term(&mut quantities, from, own.kinetic_energy);
    let off = quantities.derivations.kinematics.arena.sub(kinetic, t);
    if !is_zero(&mut quantities, off) {
        return None;
    }
    let potential = put.term(&mut quantities, from, own.potential_energy);
    let off = quantities.derivations.kinematics.arena.sub(potential, v);
    for c in &after.coordinates {
        let slope = Differential::partial(c.symbol).apply(&mut quantities.derivations.kinematics.arena, off);
        if !is_zero(&mut quantities, slope) {
            return None;
        }
    }
    // Constraints are formulas in q and q̇, or in q and u.
    for constraint in &before.motion_constraints {
        let equation = put.term(&mut quantities, from, constraint.equation);
        if !is_zero(&mut quantities, equation) {
            return None;
        }
    }
    for (row, right) in own.matrix.iter().zip(&own.forcing) {
        let right = put.term(&mut quantities, from, *right);
        let mut residual = quantities.derivations.kinematics.arena.neg(right);
        for (entry, unknown) in row.iter().zip(&own.unknowns) {
            let (entry, unknown) = (put.term(&mut quantities, from, *entry), put.term(&mut quantities, from, *unknown));
            let arena = &mut quantities.derivations.kinematics.arena;
            let product = arena.mul(entry, unknown);
            residual = arena.add(residual, product);
        }
        let solved = quantities.solved(residual).ok()?;
        if !is_zero(&mut quantities, solved) {
            return None;
        }
    }
    Some(put.changed_variable_list(&mut quantities))
}

/// Old variables as formulas in the new variables, as terms in the arena of the new model.
struct OldVariables {
    /// Substitution of the old symbols by their values in q, u and u̇ of the new model.
    values: Substitution,
    /// Old parameters, by name, as terms of the new model.
    parameters: Vec<(String, Expr)>,
    /// Old coordinates, by name, as terms of the new model.
    coordinates: Vec<(String, Expr)>,
    /// Old generalized speeds, by name, as terms of the new model.
    speeds: Vec<(String, Expr)>,
}

impl OldVariables {
    /// Formulas for the old variables under the proposed change `choice`.
    fn new(old: &mut DerivedModel<'_>, new: &mut DerivedModel<'_>, choice: &VariableChoice) -> Self {
        let (before, after) = (old.model, new.model);
        let (from, arena) = (&old.derivations.kinematics.arena, &mut new.derivations.kinematics.arena);
        let mut transfer = Transfer::to_other_model(from, "_old");
        let mut values: Vec<(Expr, Expr)> = Vec::new();
        let (mut parameters, mut coordinates, mut speeds) = (Vec::new(), Vec::new(), Vec::new());
        for (p, to) in before.parameters.iter().zip(&choice.parameters) {
            let value = after.parameters[*to].symbol;
            values.push((transfer.transfer_term(arena, p.symbol), value));
            parameters.push((p.name.clone(), value));
        }
        let mut to_speeds = rates_to_speeds(after);
        let mut moving: Vec<(Expr, Expr)> =
            after.q().into_iter().zip(after.kinematic_equations.rates.clone()).collect();
        moving.extend(after.speeds.iter().map(|s| (s.symbol, s.rate)));
        let mut d_dt = Differential::along(&moving);
        for (c, image) in before.coordinates.iter().zip(&choice.images) {
            let value = image.of(arena, after.coordinates[image.to].symbol);
            let rate = d_dt.apply(arena, value);
            let second = d_dt.apply(arena, rate);
            for (symbol, value) in [(c.symbol, value), (c.rate, rate), (c.second_rate, second)] {
                values.push((transfer.transfer_term(arena, symbol), value));
            }
            coordinates.push((c.name.clone(), value));
        }
        let mut of_definitions = Substitution::new(&values);
        for s in &before.speeds {
            let definition = transfer.transfer_term(arena, s.definition);
            let value = of_definitions.apply(arena, definition);
            let value = to_speeds.apply(arena, value);
            let rate = d_dt.apply(arena, value);
            for (symbol, value) in [(s.symbol, value), (s.rate, rate)] {
                values.push((transfer.transfer_term(arena, symbol), value));
            }
            speeds.push((s.name.clone(), value));
        }
        Self { values: Substitution::new(&values), parameters, coordinates, speeds }
    }

    /// Rewrites a term `e` of the old model, in the arena `from`, in the variables of the new model.
    fn term(&mut self, quantities: &mut Quantities<'_>, from: &Arena, e: Expr) -> Expr {
        let arena = &mut quantities.derivations.kinematics.arena;
        let e = Transfer::to_other_model(from, "_old").transfer_term(arena, e);
        let e = self.values.apply(arena, e);
        quantities.in_speeds(e)
    }

    /// Lists the old variables that differ from the new variable of the same name.
    fn changed_variable_list(self, quantities: &mut Quantities<'_>) -> Vec<VariableChange> {
        let mut list = Vec::new();
        let mut add = |quantities: &mut Quantities<'_>, kind, old: &str, value: Expr| {
            let kinematics = &mut quantities.derivations.kinematics;
            let value = kinematics.simplifier.simplify(&mut kinematics.arena, value);
            if kinematics.arena.symbol_name(value) != Some(old) {
                let new = print_text(&kinematics.arena, value);
                list.push(VariableChange { kind, old: old.to_owned(), new });
            }
        };
        for (name, value) in &self.parameters {
            add(quantities, VariableKind::Parameter, name, *value);
        }
        for (name, value) in &self.coordinates {
            add(quantities, VariableKind::Coordinate, name, *value);
        }
        for (name, value) in &self.speeds {
            add(quantities, VariableKind::Speed, name, *value);
        }
        list
    }
}

impl VariableImage {
    /// Formula for the old coordinate, where `symbol` is the new coordinate.
    fn of(self, arena: &mut Arena, symbol: Expr) -> Expr {
        let turned = if self.is_turned { arena.neg(symbol) } else { symbol };
        let pi = arena.pi();
        let quarter = Rational::fraction(i64::from(self.quarters), 2).unwrap_or(Rational::ZERO);
        let turn = arena.scale(pi, &quarter);
        arena.add(turned, turn)
    }
}
