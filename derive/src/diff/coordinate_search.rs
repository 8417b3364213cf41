//! Search for the coordinates that a publication uses. They may differ from the model's in signs, zeros and order, and
//! be absolute angles instead of relative angles.
//!
//! The search compares numbers and proves nothing. The publication is afterwards read and judged in the coordinates
//! found.

mod coordinate_changes;

use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr};
use crate::mechanics::{Derivations, EnergyQuantity, Quantities, Quantity, QuantityKind};
use crate::model::{Coordinate, Model, TIME};
use crate::publication::{EntryKind, Listing, Publication, System};
use coordinate_changes::{CoordinateChange, coordinate_changes, coordinate_table};

/// Largest number of coordinate choices that are reported if several are equally good.
const LISTED: usize = 8;
/// Number of random states at which printed and derived formulas are compared.
const STATES: usize = 3;
/// Relative difference below which two numbers count as equal.
const NEAR: f64 = 1e-9;

/// Coordinates of a publication as pairs (name, formula in the model's coordinates), as in its table `[coordinates]`.
pub type CoordinateTable = Vec<(String, String)>;

/// Result of a search for the coordinates of a publication.
#[derive(Clone, Debug)]
pub struct CoordinateSearch {
    /// Number of the publication's formulas that were compared.
    pub compared: usize,
    /// Number of formulas that are right in the coordinates that the publication states.
    pub as_stated: usize,
    /// Number of formulas that are right in the best coordinates found.
    pub most: usize,
    /// Best choices of coordinates, with the fewest changes first. Of choices that differ only by a symmetry of the
    /// model, one is listed. Empty if the coordinates that the publication states are as good.
    pub best: Vec<CoordinateTable>,
    /// Number of coordinate choices that were tried.
    pub tried: usize,
}

/// Numerical test of a printed formula against a derived value, or of a printed equation against
/// zero.
enum FormulaTest {
    /// Printed value and its derived value. If `up_to_constant` is true, the two may differ by a constant.
    Value { printed: Tape, expected: ExpectedValue, up_to_constant: bool },
    /// Residual of a printed equation, left side − right side. The equation is right if the
    /// residual is zero.
    Zero(Tape),
}

/// Value that a printed formula must have: the value of a publication's variable, or of a derived quantity.
enum ExpectedValue {
    /// Variable of the publication itself; the number is its index among the inputs of the tapes.
    Variable(usize),
    /// Quantity that does not depend on the choice of coordinates, as a function of the model's
    /// state.
    Derived(Tape),
}

/// Searches for the coordinates in which the most formulas of a publication are right.
///
/// # Errors
/// Reason why no search is possible: loop equations tie the coordinates together, no formula can be compared, or a
/// speed is not the rate of one coordinate.
pub fn find_coordinates(
    model: &Model,
    derivations: &mut Derivations,
    publication: &Publication,
) -> Result<CoordinateSearch, String> {
    if !model.loops.is_empty() || !model.closed.is_empty() {
        return Err("equations tie the coordinates of the model together".to_owned());
    }
    let mut quantities = Quantities::new(model, derivations);
    let numbers = CoordinateSearchStates::new(&mut quantities)?;
    let checks = numbers.formula_tests(&mut quantities, publication);
    if checks.is_empty() {
        return Err("no formula of the publication can be compared in numbers".to_owned());
    }
    let moving = mentioned_coordinates(
        model,
        &quantities.derivations.kinematics.arena,
        &printed_terms_for_search(model, publication),
    )?;
    let changes = coordinate_changes(model, &moving);
    let counts: Vec<usize> = changes.iter().map(|change| numbers.count_right_formulas(&checks, change)).collect();
    let most = counts.iter().copied().max().unwrap_or(0);
    let as_stated = counts.first().copied().unwrap_or(0);
    let best = if as_stated == most {
        Vec::new()
    } else {
        let found = changes.iter().zip(&counts).filter(|(_, count)| **count == most);
        let found = numbers.changes_distinct_by_symmetry(&changes, found.map(|(change, _)| change));
        let arena = &mut quantities.derivations.kinematics.arena;
        found.into_iter().map(|change| coordinate_table(model, arena, publication, change)).collect::<Result<_, _>>()?
    };
    Ok(CoordinateSearch { compared: checks.len(), as_stated, most, best, tried: changes.len() })
}

/// Random states of the model, with programs (tapes) that evaluate the variables of a publication in these states.
struct CoordinateSearchStates {
    /// Symbols that are the inputs of every tape: parameters; q, q' and q'' of each coordinate; u
    /// and u' of each speed.
    inputs: Vec<Expr>,
    /// Number of model parameters, the first inputs of every tape.
    parameters: usize,
    /// Number of generalized coordinates, whose q, q' and q'' follow the parameters among the
    /// inputs.
    coordinates: usize,
    /// Values of the inputs in the model's own variables, one list for each state.
    states: Vec<Vec<f64>>,
    /// Generalized speeds u and their derivatives u', in turn for each speed, from q, q' and q''.
    speeds: Tape,
    /// Accelerations q'' followed by the kinetic energy, from q and u.
    motion: Tape,
}

impl CoordinateSearchStates {
    /// Draws random parameters, coordinates and speeds; computes rates and accelerations from the derived equations.
    ///
    /// # Errors
    /// Reason why a formula of the motion has no numerical value.
    fn new(quantities: &mut Quantities<'_>) -> Result<Self, String> {
        let model = quantities.model;
        let mut inputs = model.p();
        let parameters = inputs.len();
        inputs.extend(model.coordinates.iter().flat_map(|c| [c.symbol, c.rate, c.second_rate]));
        inputs.extend(model.speeds.iter().flat_map(|s| [s.symbol, s.rate]));
        let rates = model.kinematic_equations.rates.clone();
        let mut motion = rates;
        for c in &model.coordinates {
            motion.push(quantities.solved(c.second_rate)?);
        }
        for s in &model.speeds {
            motion.push(quantities.solved(s.rate)?);
        }
        let kinetic = Quantity::new(QuantityKind::Energy(EnergyQuantity::Kinetic), model);
        let kinetic = quantities.value(&kinetic)?;
        let accelerations = motion[model.coordinates.len()..2 * model.coordinates.len()].to_vec();
        let symmetric: Vec<Expr> = accelerations.into_iter().chain([kinetic]).collect();
        let mut speeds = Vec::new();
        for s in &model.speeds {
            speeds.extend([quantities.in_rates(s.symbol), quantities.in_rates(s.rate)]);
        }
        let arena = &quantities.derivations.kinematics.arena;
        let unknown = "a formula of the motion has a symbol without a value";
        let motion = Tape::new(arena, &inputs, &motion).map_err(|_| unknown.to_owned())?;
        let symmetric = Tape::new(arena, &inputs, &symmetric).map_err(|_| unknown.to_owned())?;
        let speeds = Tape::new(arena, &inputs, &speeds).map_err(|_| unknown.to_owned())?;
        let coordinates = model.coordinates.len();
        let mut seed = 1_u64;
        let mut random = |from: f64, to: f64| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let part = u32::try_from(seed >> 32).unwrap_or(0);
            from + (to - from) * f64::from(part) / f64::from(u32::MAX)
        };
        let values: Vec<f64> = (0..parameters).map(|_| random(0.5, 2.0)).collect();
        let mut states = Vec::new();
        for _ in 0..STATES {
            let mut state = values.clone();
            state.extend((0..3 * coordinates).map(|_| random(0.2, 1.3)));
            state.extend((0..2 * model.speeds.len()).map(|_| random(0.4, 1.6)));
            let motion = motion.evaluate(&state);
            for at in 0..coordinates {
                state[parameters + 3 * at + 1] = motion[at];
                state[parameters + 3 * at + 2] = motion[coordinates + at];
            }
            for at in 0..model.speeds.len() {
                state[parameters + 3 * coordinates + 2 * at + 1] = motion[2 * coordinates + at];
            }
            states.push(state);
        }
        Ok(Self { inputs, parameters, coordinates, states, speeds, motion: symmetric })
    }

    /// Index of a symbol among the tapes' inputs; `None` if the symbol is no input.
    fn input(&self, symbol: Expr) -> Option<usize> {
        self.inputs.iter().position(|input| *input == symbol)
    }

    /// Values of all inputs at a state, converted by `change` from the model's variables to the
    /// publication's.
    fn state_in_changed_coordinates(&self, state: &[f64], change: &CoordinateChange) -> Vec<f64> {
        let mut own = state.to_vec();
        let place = |at: usize, order: usize| self.parameters + 3 * at + order;
        for (at, row) in change.rows.iter().enumerate() {
            for order in 0..3 {
                let terms = row.iter().enumerate().filter(|(_, factor)| **factor != 0);
                let sum: f64 = terms.map(|(from, factor)| f64::from(*factor) * state[place(from, order)]).sum();
                let turn = f64::from(change.quarters[at]) * std::f64::consts::FRAC_PI_2;
                own[place(at, order)] = if order == 0 { sum + turn } else { sum };
            }
        }
        let speeds = self.speeds.evaluate(&own);
        let first = self.parameters + 3 * self.coordinates;
        own[first..].copy_from_slice(&speeds);
        own
    }

    /// Number of checks that pass in all states if the publication uses the coordinates of `change`.
    fn count_right_formulas(&self, checks: &[FormulaTest], change: &CoordinateChange) -> usize {
        let own: Vec<Vec<f64>> =
            self.states.iter().map(|state| self.state_in_changed_coordinates(state, change)).collect();
        let is_right = |check: &&FormulaTest| match check {
            FormulaTest::Zero(tape) => own.iter().all(|own| {
                let scale = tape.largest_terms(own)[0].abs().max(NEAR);
                tape.evaluate(own)[0].abs() <= NEAR * scale
            }),
            FormulaTest::Value { printed, expected, up_to_constant } => {
                let mut zero = None;
                own.iter().zip(&self.states).all(|(own, state)| {
                    let value = printed.evaluate(own)[0];
                    let right = match expected {
                        ExpectedValue::Variable(at) => own[*at],
                        ExpectedValue::Derived(tape) => tape.evaluate(state)[0],
                    };
                    let zero = if *up_to_constant { *zero.get_or_insert(value - right) } else { 0.0 };
                    let scale = printed.largest_terms(own)[0].abs().max(right.abs()).max(NEAR);
                    (value - right - zero).abs() <= NEAR * scale
                })
            }
        };
        checks.iter().filter(is_right).count()
    }

    /// Changes of coordinates from `found` that differ by more than a symmetry of the model; at most eight.
    fn changes_distinct_by_symmetry<'c>(
        &self,
        all: &'c [CoordinateChange],
        found: impl Iterator<Item = &'c CoordinateChange>,
    ) -> Vec<&'c CoordinateChange> {
        let symmetries: Vec<&CoordinateChange> = all.iter().filter(|change| self.is_symmetry(change)).collect();
        let mut list: Vec<&CoordinateChange> = Vec::new();
        for change in found {
            if list.len() < LISTED
                && !list.iter().any(|first| symmetries.iter().any(|s| first.composed_after(s) == *change))
            {
                list.push(change);
            }
        }
        list
    }

    /// True if a change of coordinates maps motions of the model to motions with the same kinetic
    /// energy.
    fn is_symmetry(&self, change: &CoordinateChange) -> bool {
        self.states.iter().all(|state| {
            let own = self.state_in_changed_coordinates(state, change);
            let (before, after) = (self.motion.evaluate(state), self.motion.evaluate(&own));
            let mut wanted: Vec<f64> = (0..self.coordinates).map(|at| own[self.parameters + 3 * at + 2]).collect();
            wanted.extend(before.last().copied());
            after.iter().zip(&wanted).all(|(a, b)| (a - b).abs() <= NEAR * a.abs().max(b.abs()).max(NEAR))
        })
    }

    /// Numerical tests for all formulas of a publication that can be evaluated. Entries that hold only near a point are
    /// left out.
    fn formula_tests(&self, quantities: &mut Quantities<'_>, publication: &Publication) -> Vec<FormulaTest> {
        let mut list = Vec::new();
        for entry in publication.entries.iter().filter(|entry| entry.near.is_none()) {
            match &entry.kind {
                EntryKind::Equation { quantity, printed, .. } => {
                    list.extend(self.expected_value(quantities, quantity.kind(), *printed).and_then(|expected| {
                        let arena = &quantities.derivations.kinematics.arena;
                        let printed = Tape::new(arena, &self.inputs, &[*printed]).ok()?;
                        let up_to_constant = matches!(quantity.kind(), QuantityKind::Energy(e) if e.has_a_zero());
                        Some(FormulaTest::Value { printed, expected, up_to_constant })
                    }));
                }
                EntryKind::System(system) => list.extend(self.system_row_tests(quantities, system)),
                EntryKind::Listing(listing) => list.extend(self.listing_rate_tests(quantities, listing)),
                EntryKind::Definition { .. } | EntryKind::Initial(_) => {}
            }
        }
        list
    }

    /// Value that a printed formula `printed` must have for a quantity of this kind. `None` for rows, matrices and
    /// partial velocities, which change with the coordinates.
    fn expected_value(
        &self,
        quantities: &mut Quantities<'_>,
        kind: &QuantityKind,
        printed: Expr,
    ) -> Option<ExpectedValue> {
        let model = quantities.model;
        let variable = match kind {
            QuantityKind::SecondRate(at) => model.coordinates[*at].second_rate,
            QuantityKind::SpeedRate(at) => model.speeds[*at].rate,
            QuantityKind::Rate(at) => model.coordinates[*at].rate,
            QuantityKind::Speed(at) => model.speeds[*at].symbol,
            QuantityKind::Row(..)
            | QuantityKind::MassMatrix(..)
            | QuantityKind::LagrangeMatrix(..)
            | QuantityKind::Partial { .. } => return None,
            other => {
                let derived = quantities.value(&Quantity::new(other.clone(), model)).ok()?;
                let kept = matches!(other, QuantityKind::Energy(EnergyQuantity::Kinetic | EnergyQuantity::Lagrangian));
                let derived = if kept && quantities.mentions_rates(printed) {
                    quantities.before_constraints(other, derived)
                } else {
                    derived
                };
                let arena = &quantities.derivations.kinematics.arena;
                return Some(ExpectedValue::Derived(Tape::new(arena, &self.inputs, &[derived]).ok()?));
            }
        };
        self.input(variable).map(ExpectedValue::Variable)
    }

    /// Residuals matrix · unknowns − right side of the rows of a printed system. Rows with reactions or multipliers are
    /// left out.
    fn system_row_tests(&self, quantities: &mut Quantities<'_>, system: &System) -> Vec<FormulaTest> {
        let arena = &mut quantities.derivations.kinematics.arena;
        let mut list = Vec::new();
        for (row, right) in system.matrix.iter().zip(&system.right) {
            let mut terms: Vec<Expr> = row.iter().zip(&system.unknowns).map(|(a, x)| arena.mul(*a, *x)).collect();
            terms.push(arena.neg(*right));
            let residual = arena.sum(&terms);
            list.extend(Tape::new(arena, &self.inputs, &[residual]).ok().map(FormulaTest::Zero));
        }
        list
    }

    /// Residuals of a printed program (listing): derivative of a state − printed formula. If the program has a matrix,
    /// the residuals of its matrix rows.
    fn listing_rate_tests(&self, quantities: &mut Quantities<'_>, listing: &Listing) -> Vec<FormulaTest> {
        let model = quantities.model;
        let rate = |symbol: Expr| {
            let coordinate = model.coordinates.iter().find_map(|c| {
                let pairs = [(c.symbol, c.rate), (c.rate, c.second_rate)];
                pairs.into_iter().find(|(of, _)| *of == symbol).map(|(_, rate)| rate)
            });
            coordinate.or_else(|| model.speeds.iter().find(|s| s.symbol == symbol).map(|s| s.rate))
        };
        let arena = &mut quantities.derivations.kinematics.arena;
        let mut list = Vec::new();
        for (at, (symbol, derivative)) in listing.state.iter().zip(&listing.derivative).enumerate() {
            let row = listing.moving.iter().position(|moving| *moving == at);
            let left = match (&listing.matrix, row) {
                (Some(matrix), Some(row)) => {
                    let terms = matrix[row].iter().zip(&listing.moving);
                    let terms: Option<Vec<Expr>> =
                        terms.map(|(e, at)| Some(arena.mul(*e, rate(listing.state[*at])?))).collect();
                    terms.map(|terms| arena.sum(&terms))
                }
                _ => rate(*symbol),
            };
            let Some(left) = left else { continue };
            let residual = arena.sub(left, *derivative);
            list.extend(Tape::new(arena, &self.inputs, &[residual]).ok().map(FormulaTest::Zero));
        }
        list
    }
}

/// Indices of the coordinates that printed formulas mention, directly or through their rates or speeds.
///
/// # Errors
/// Message with the name of a mentioned speed that is not the rate of one coordinate.
fn mentioned_coordinates(model: &Model, arena: &Arena, printed: &[Expr]) -> Result<Vec<usize>, String> {
    let mentions = |symbol| printed.iter().any(|e| arena.mentions(*e, symbol));
    let mut rates = Vec::new();
    for s in model.speeds.iter().filter(|s| mentions(s.symbol) || mentions(s.rate)) {
        if !model.coordinates.iter().any(|c| c.rate == s.definition) {
            return Err(format!("the speed `{}` is not the rate of one coordinate", s.name));
        }
        rates.push(s.definition);
    }
    let is_used =
        |c: &Coordinate| [c.symbol, c.rate, c.second_rate].into_iter().any(mentions) || rates.contains(&c.rate);
    let used = model.coordinates.iter().enumerate().filter(|(_, c)| c.name != TIME && is_used(c));
    Ok(used.map(|(at, _)| at).collect())
}

/// Terms of all printed formulas, with the coordinates, speeds, unknowns and states to which the formulas give values.
fn printed_terms_for_search(model: &Model, publication: &Publication) -> Vec<Expr> {
    let mut list = Vec::new();
    for entry in &publication.entries {
        match &entry.kind {
            EntryKind::Equation { quantity, printed, .. } => {
                list.push(*printed);
                match quantity.kind() {
                    QuantityKind::SecondRate(at) | QuantityKind::Rate(at) => list.push(model.coordinates[*at].symbol),
                    QuantityKind::SpeedRate(at) | QuantityKind::Speed(at) => list.push(model.speeds[*at].symbol),
                    _ => {}
                }
            }
            EntryKind::System(system) => {
                for (row, right) in system.matrix.iter().zip(&system.right) {
                    list.push(*right);
                    let used = row.iter().zip(&system.unknowns).filter(|(e, _)| **e != Expr::ZERO);
                    list.extend(used.flat_map(|(e, x)| [*e, *x]));
                }
            }
            EntryKind::Listing(listing) => {
                list.extend(listing.state.iter().chain(&listing.derivative).copied());
                list.extend(listing.matrix.iter().flatten().flatten().copied());
            }
            EntryKind::Definition { .. } | EntryKind::Initial(_) => {}
        }
    }
    list
}
