//! Proof that reduced equations agree with the whole model on each level set of momenta.
//!
//! No intermediate step is trusted. The coordinates and speeds of the model are written in the
//! variables of the reduced equations and differentiated along their rates. They must satisfy the
//! kinematic equations and every row of Kane's M u̇ = f of the whole model, for all values of the
//! constants.
//!
//! The wanted outputs, the shortened formulas, the constants and the energy are each compared with
//! their values in the whole model. Every identity is proved by its form, or tested at random
//! points of random prime fields with a stated error bound.

use crate::algebra::Expr;
use crate::algebra::meaning::compare::Engine;
use crate::algebra::meaning::identity::Identity;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::value::zero_test::{ZeroTest, bounded_zero_test};
use crate::mechanics::Equations;
use crate::reduce::basis::moving_frame::{FrameSymmetry, solved_rates};
use crate::reduce::basis::reduction_basis::ReductionBasis;
use crate::reduce::basis::solved_rows::solve_rows;
use crate::reduce::levels::momentum_level::Level;
use crate::reduce::slices::slice::Slice;
use crate::reduce::slices::wanted_outputs::WantedOutputs;

/// Proof that reduced equations give the outputs of the whole model: a list of identities.
#[derive(Clone, Debug, PartialEq)]
pub struct ReductionProof {
    /// Identities that were tested and hold, with terms in the reduction's arena.
    pub identities: Vec<Identity>,
    /// Motion of the whole model, from which the identities were made.
    pub reconstruction: Reconstruction,
}

/// Motion of the whole model as a function of all variables on a level set of momenta, also of those that reduced
/// equations omit. All terms are in the reduction's arena.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reconstruction {
    /// Variables on the level set, as pairs (symbol, rate). A rate is a term in these variables, the constants `held`
    /// and parameters.
    pub variables: Vec<(Expr, Expr)>,
    /// Coordinates and then speeds of the whole model, as pairs (symbol, value). A value is a term like a rate.
    pub states: Vec<(Expr, Expr)>,
    /// Conserved momenta that are constants of the reduced equations, as pairs (symbol, value in coordinates and speeds
    /// of the whole model).
    pub held: Vec<(Expr, Expr)>,
    /// Positions of mass centres at the start that outputs contain, as pairs (symbol, symbol of the momentum that is
    /// the rate of the position).
    pub positions: Vec<(Expr, Expr)>,
}

impl ReductionProof {
    /// Exponent of the error bound of the proof: the probability that an identity is wrong is below
    /// 2^−exponent. Infinite if all identities hold by form.
    #[must_use]
    pub fn exponent(&self) -> f64 {
        self.identities.iter().fold(f64::INFINITY, |least, identity| match identity.engine {
            Engine::NormalForm => least,
            Engine::Modular { exponent } => least.min(exponent),
        })
    }

    /// Text of the error bound of the proof, such as ` (in doubt by less than 2^-95)`. Empty if all
    /// identities hold by form.
    pub(in crate::reduce) fn proof_bound_text(&self) -> String {
        match self.exponent() {
            e if e.is_finite() => format!(" (in doubt by less than 2^-{})", e.floor().min(9999.0)),
            _ => String::new(),
        }
    }
}

impl std::fmt::Display for ReductionProof {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (n, doubt) = (self.identities.len(), self.proof_bound_text());
        let what = "the kinematic equations and Kane's of the whole model, its constants and outputs, along the reduced motion";
        write!(f, "{n} identities hold: {what}{doubt}")
    }
}

/// Equations and wanted values of the whole model, which a reduction must reproduce.
pub struct WholeModel {
    /// Kane's equations of the whole model, in its own q and u.
    pub kane: Equations,
    /// Wanted outputs, conditions and events, as terms in the model's own q, u and u̇.
    pub wanted: WantedOutputs,
}

/// Proves that reduced equations reproduce the whole model.
///
/// # Errors
/// Text of the first identity that could not be proved.
pub fn prove_reduction(
    basis: &mut ReductionBasis,
    whole: &WholeModel,
    level: &Level,
    flow: &mut Slice,
) -> Result<ReductionProof, String> {
    let mut check = ReductionCheck::new(basis, whole, level, flow)
        .ok_or("the printed variables are not linear functions of the model's variables")?;
    check.check_frame(basis, whole)?;
    check.check_kinematics(basis, whole)?;
    check.check_dynamics(basis, whole)?;
    check.check_constants(basis, level, flow)?;
    check.check_rates(basis, flow)?;
    check.check_wanted(basis, whole, flow)?;
    let mut back = basis.basis_to_model_substitution();
    let held = level.held.iter().map(|h| (h.symbol, back.apply(&mut basis.arena, h.of_state))).collect();
    let positions = flow.carried.iter().map(|c| (c.symbol, level.held[c.held].symbol)).collect();
    let Reconstruction { variables, states, .. } = check.proof.reconstruction;
    let reconstruction = Reconstruction { variables, states, held, positions };
    Ok(ReductionProof { reconstruction, ..check.proof })
}

/// State of the proof that reduced equations agree with the whole model.
struct ReductionCheck {
    /// Substitution of the model's q, u and u̇ by terms in the reduced variables, the constant momenta
    /// and parameters.
    written: Substitution,
    /// Time derivative d/dt along the motion of the reduced equations, with rates that are not
    /// shortened.
    change: Differential,
    /// Rates q̇, then u̇, of the whole model along the reduced motion, as terms in the reduced
    /// variables, the constant momenta and parameters.
    rates: Vec<Expr>,
    /// Proof so far: the identities that were proved.
    proof: ReductionProof,
}

impl ReductionCheck {
    /// Writes the model's variables and their rates in the reduced variables. `None` if the
    /// relation between the two sets of variables is not linear and invertible, or if a speed has
    /// no value.
    fn new(basis: &mut ReductionBasis, whole: &WholeModel, level: &Level, flow: &mut Slice) -> Option<Self> {
        let change = Differential::along(&flow.raw);
        let (of_q, of_u) = (whole.kane.coordinates.clone(), whole.kane.variables.clone());
        let there: Vec<Expr> = basis.q.clone();
        let q = invert_variables_for_proof(basis, &of_q, &basis.q_start.clone(), &there)?;
        let mut put = basis.section_substitution();
        let q: Vec<Expr> = q.into_iter().map(|e| put.apply(&mut basis.arena, e)).collect();
        // Each speed must be a remaining variable, defined, constant or pinned.
        let held = level.definitions.iter().map(|d| d.symbol).chain(level.held.iter().map(|h| h.symbol));
        let known: Vec<Expr> = held.chain(level.kept.iter().map(|k| basis.kane.variables[*k])).collect();
        let speeds: Vec<Expr> = basis.kane.variables.clone();
        if !speeds.iter().enumerate().all(|(at, u)| known.contains(u) || basis.section_pins_speed(at)) {
            return None;
        }
        let u = invert_variables_for_proof(basis, &of_u, &basis.u_start.clone(), &speeds)?;
        let mut check = Self {
            written: Substitution::default(),
            change,
            rates: Vec::new(),
            proof: ReductionProof { identities: Vec::new(), reconstruction: Reconstruction::default() },
        };
        let u: Vec<Expr> = u.into_iter().map(|e| put.apply(&mut basis.arena, e)).collect();
        let u: Vec<Expr> = u.into_iter().map(|e| flow.dependence.without_definitions(&mut basis.arena, e)).collect();
        let states: Vec<Expr> = q.into_iter().chain(u).collect();
        let rates: Vec<Expr> = states.iter().map(|e| check.change.apply(&mut basis.arena, *e)).collect();
        let names = of_q.iter().chain(&of_u).copied();
        let states: Vec<(Expr, Expr)> = names.zip(states).collect();
        check.written = Substitution::new(&states);
        check.proof.reconstruction =
            Reconstruction { variables: flow.raw.clone(), states, ..Reconstruction::default() };
        // The rates of the whole model are the rates of the reduced state minus the rates that the
        // frame adds.
        check.rates = rates;
        if let Some(frame) = &basis.frame {
            for (turn, rate) in frame.turns.iter().zip(&frame.rates) {
                let turning = flow.dependence.without_definitions(&mut basis.arena, *rate);
                for (total, along) in check.rates.iter_mut().zip(&basis.turns[*turn].of_model) {
                    let along = check.written.apply(&mut basis.arena, *along);
                    let part = basis.arena.mul(turning, along);
                    *total = basis.arena.sub(*total, part);
                }
            }
        }
        for (unknown, rate) in whole.kane.unknowns.iter().zip(&check.rates[of_q.len()..]) {
            check.written.set(*unknown, *rate);
        }
        Some(check)
    }

    /// Checks that each symmetry of the frame commutes with the motion of the whole model, and leaves
    /// the wanted quantities unchanged.
    ///
    /// # Errors
    /// Text of the first identity that does not hold or is not decided.
    fn check_frame(&mut self, basis: &mut ReductionBasis, whole: &WholeModel) -> Result<(), String> {
        let Some(frame) = basis.frame.clone() else { return Ok(()) };
        let flow = solved_rates(&mut basis.arena, &whole.kane)
            .ok_or("the accelerations of the whole model are not determined")?;
        let states = [whole.kane.coordinates.clone(), whole.kane.variables.clone()].concat();
        let along = |field: &[Expr]| {
            Differential::along(&states.iter().copied().zip(field.iter().copied()).collect::<Vec<_>>())
        };
        let accelerations = &flow[whole.kane.coordinates.len()..];
        let accelerations: Vec<(Expr, Expr)> =
            whole.kane.unknowns.iter().copied().zip(accelerations.iter().copied()).collect();
        let mut solved = Substitution::new(&accelerations);
        for turn in frame.turns {
            let FrameSymmetry { words, of_model, .. } = basis.turns[turn].clone();
            let (mut by_field, mut by_time) = (along(&of_model), along(&flow));
            for (rate, component) in flow.iter().zip(&of_model) {
                let a = by_field.apply(&mut basis.arena, *rate);
                let b = by_time.apply(&mut basis.arena, *component);
                self.prove_equal(basis, a, b, || format!("that {words} is a symmetry"))?;
            }
            for (about, value) in whole.wanted.outputs_with_descriptions() {
                let value = solved.apply(&mut basis.arena, value);
                let change = by_field.apply(&mut basis.arena, value);
                self.prove_zero(basis, change, || format!("that {words} leaves {about} as it is"))?;
            }
        }
        Ok(())
    }

    /// Proves the identity e = 0 and records it. `what` describes the identity; the error is this
    /// text with "does not hold" or "cannot be decided".
    fn prove_zero(&mut self, basis: &mut ReductionBasis, e: Expr, what: impl FnOnce() -> String) -> Result<(), String> {
        self.prove_equal(basis, e, Expr::ZERO, what)
    }

    /// Proves the identity left = right and records it. `what` describes the identity; the error is
    /// this text with "does not hold" or "cannot be decided".
    fn prove_equal(
        &mut self,
        basis: &mut ReductionBasis,
        left: Expr,
        right: Expr,
        what: impl FnOnce() -> String,
    ) -> Result<(), String> {
        let difference = basis.arena.sub(left, right);
        if difference == Expr::ZERO {
            self.proof.identities.push(Identity { left, right, engine: Engine::NormalForm });
            return Ok(());
        }
        let (answer, exponent) = bounded_zero_test(&basis.arena, difference);
        match answer {
            ZeroTest::Zero => {
                self.proof.identities.push(Identity { left, right, engine: Engine::Modular { exponent } });
                Ok(())
            }
            ZeroTest::NonZero => Err(format!("{} does not hold", what())),
            ZeroTest::Undecided => Err(format!("{} cannot be decided", what())),
        }
    }

    /// Checks the kinematic equations: along the reduced motion, the model's q̇ must equal W u + w.
    /// The error names the first equation that fails.
    fn check_kinematics(&mut self, basis: &mut ReductionBasis, whole: &WholeModel) -> Result<(), String> {
        let rates = whole.kane.coordinates.iter().zip(&whole.kane.coordinate_rates);
        for (at, (q, rate)) in rates.enumerate() {
            debug_assert_eq!(*q, whole.kane.coordinates[at], "a rate for each coordinate");
            let found = self.rates[at];
            let stated = self.written.apply(&mut basis.arena, *rate);
            self.prove_equal(basis, found, stated, || format!("kinematic equation {}", at + 1))?;
        }
        Ok(())
    }

    /// Checks Kane's equations M u̇ − f = 0 along the reduced motion, row by row. The error names the
    /// first row that fails.
    fn check_dynamics(&mut self, basis: &mut ReductionBasis, whole: &WholeModel) -> Result<(), String> {
        for (at, (row, right)) in whole.kane.matrix.iter().zip(&whole.kane.forcing).enumerate() {
            let products = row.iter().zip(&whole.kane.unknowns);
            let products: Vec<Expr> = products.map(|(m, x)| basis.arena.mul(*m, *x)).collect();
            let left = basis.arena.sum(&products);
            let difference = basis.arena.sub(left, *right);
            let residual = self.written.apply(&mut basis.arena, difference);
            self.prove_zero(basis, residual, || format!("Kane's equation {}", at + 1))?;
        }
        Ok(())
    }

    /// Checks that each constant equals the function of the state that it stands for, and that mass
    /// centres move with their momenta. The error names the first constant that fails.
    fn check_constants(&mut self, basis: &mut ReductionBasis, level: &Level, flow: &mut Slice) -> Result<(), String> {
        let mut back = basis.basis_to_model_substitution();
        for held in &level.held {
            let of_start = back.apply(&mut basis.arena, held.of_state);
            let value = self.written.apply(&mut basis.arena, of_start);
            let about = held.about.text(&basis.arena);
            self.prove_equal(basis, value, held.symbol, || format!("that {about} is constant"))?;
        }
        for carried in &flow.carried {
            let change = self.change.apply(&mut basis.arena, carried.position);
            let change = flow.dependence.without_definitions(&mut basis.arena, change);
            self.prove_equal(basis, change, level.held[carried.held].symbol, || {
                "the motion of the mass centre".to_owned()
            })?;
        }
        Ok(())
    }

    /// Checks that shortened rates equal full rates, that the full rates solve the equations of the
    /// level set, and that the energy is constant. The error names the first identity that fails.
    fn check_rates(&mut self, basis: &mut ReductionBasis, flow: &mut Slice) -> Result<(), String> {
        for variable in flow.core.iter().chain(&flow.quadratures) {
            let (_, raw) =
                *flow.raw.iter().find(|(symbol, _)| *symbol == variable.symbol).ok_or("a variable without a rate")?;
            let shed = flow.dependence.without_definitions(&mut basis.arena, variable.rate);
            self.prove_equal(basis, shed, raw, || "a rate without what it does not depend on".to_owned())?;
        }
        let accelerations: Vec<Expr> = flow.raw[basis.q.len()..].iter().map(|(_, rate)| *rate).collect();
        let (matrix, forcing) = flow.system.clone().unwrap_or_default();
        for (row, right) in matrix.iter().zip(forcing) {
            let products: Vec<Expr> = row.iter().zip(&accelerations).map(|(m, x)| basis.arena.mul(*m, *x)).collect();
            let left = basis.arena.sum(&products);
            let difference = basis.arena.sub(left, right);
            let residual = flow.dependence.without_definitions(&mut basis.arena, difference);
            self.prove_zero(basis, residual, || "a row of the equations on the level".to_owned())?;
        }
        if let Some(energy) = flow.energy {
            let energy = flow.dependence.without_definitions(&mut basis.arena, energy);
            let change = self.change.apply(&mut basis.arena, energy);
            self.prove_zero(basis, change, || "that the energy is constant".to_owned())?;
        }
        Ok(())
    }

    /// Checks the wanted values against those of the whole model. A coordinate that is computed
    /// from the time is traced back to the position at the start. The error names the first value
    /// that fails.
    fn check_wanted(&mut self, basis: &mut ReductionBasis, whole: &WholeModel, flow: &mut Slice) -> Result<(), String> {
        let mut started = Vec::new();
        for carried in &flow.carried {
            // Position at the start: the present position minus its displacement since the start.
            let momentum = self.change.apply(&mut basis.arena, carried.position);
            let moved = basis.arena.mul(momentum, flow.time);
            started.push((carried.symbol, basis.arena.sub(carried.position, moved)));
        }
        let mut started = Substitution::new(&started);
        let stated = whole.wanted.outputs_with_descriptions();
        for ((about, stated), (_, found)) in stated.into_iter().zip(flow.wanted.outputs_with_descriptions()) {
            let stated = self.written.apply(&mut basis.arena, stated);
            let found = started.apply(&mut basis.arena, found);
            let found = flow.dependence.without_definitions(&mut basis.arena, found);
            self.prove_equal(basis, found, stated, || about)?;
        }
        Ok(())
    }
}

/// Solves the equations `stated` = `symbols` for the variables `model`. The terms `stated` must be
/// linear in these variables. Returns the values of the variables as terms in `symbols`. `None` if
/// the equations cannot be solved.
fn invert_variables_for_proof(
    basis: &mut ReductionBasis,
    model: &[Expr],
    stated: &[Expr],
    symbols: &[Expr],
) -> Option<Vec<Expr>> {
    let mut form = LinearForm::new(model);
    let (mut rows, mut right) = (Vec::new(), Vec::new());
    for (value, symbol) in stated.iter().zip(symbols) {
        let (row, rest) = form.coefficients(&mut basis.arena, *value).ok()?;
        rows.push(row);
        right.push(vec![basis.arena.sub(*symbol, rest)]);
    }
    let columns: Vec<usize> = (0..model.len()).collect();
    let solved = solve_rows(&mut basis.arena, &mut basis.simplifier, rows, right, &[], &columns);
    let mut values = model.to_vec();
    if solved.pivots.len() < model.len() {
        return None;
    }
    for k in (0..solved.pivots.len()).rev() {
        let value = solved.value_of_pivot_unknown(&mut basis.arena, k, 0, &values);
        values[solved.pivots[k].1] = basis.simplifier.simplify(&mut basis.arena, value);
    }
    Some(values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::Source;
    use crate::model::Model;
    use std::path::Path;

    /// Proof of the reduction of a spherical pendulum, after the function `spoil` has changed its
    /// data.
    fn spoilt(spoil: impl FnOnce(&mut ReductionBasis, &mut Level, &mut Slice)) -> Result<ReductionProof, String> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/spherical_pendulum");
        let mut model = Model::read(&folder.join("model.toml")).unwrap();
        let source = Source::read(&folder.join("scenes/wide.toml")).unwrap();
        let scene = crate::scene::load(&source, &mut model).unwrap();
        let mut basis = ReductionBasis::new(&model).unwrap();
        let wanted = basis.wanted(&scene).unwrap();
        let whole = WholeModel { kane: basis.kane.clone(), wanted: wanted.clone() };
        let mut level = basis.equations_on_momentum_level(&[0], None).unwrap();
        let mut flow = Slice::new(&mut basis, &level, &wanted).unwrap();
        spoil(&mut basis, &mut level, &mut flow);
        prove_reduction(&mut basis, &whole, &level, &mut flow)
    }

    /// Changes a term by a small part of it, so that the error is not obvious.
    fn slightly(basis: &mut ReductionBasis, e: &mut Expr) {
        let part = basis.arena.ratio(1, 1_000_000);
        let part = basis.arena.mul(part, basis.q[0]);
        *e = basis.arena.add(*e, part);
    }

    #[test]
    fn what_is_right_is_proved() {
        let proof = spoilt(|_, _, _| ()).unwrap();
        assert!(proof.identities.len() > 10 && proof.exponent() > 64.0, "{proof}");
    }

    #[test]
    fn a_wrong_acceleration_is_seen_in_kanes_equations() {
        let error = spoilt(|basis, _, flow| slightly(basis, &mut flow.raw.last_mut().unwrap().1)).unwrap_err();
        assert_eq!(error, "Kane's equation 1 does not hold");
    }

    #[test]
    fn a_wrong_rate_of_a_coordinate_is_seen_in_the_kinematic_equations() {
        let error = spoilt(|basis, _, flow| slightly(basis, &mut flow.raw[0].1)).unwrap_err();
        assert_eq!(error, "kinematic equation 1 does not hold");
    }

    #[test]
    fn a_constant_that_is_called_something_else_is_seen() {
        let error = spoilt(|basis, level, _| slightly(basis, &mut level.held[0].of_state)).unwrap_err();
        assert_eq!(error, "that momentum p_phi = ∂L/∂phi' is constant does not hold");
    }

    #[test]
    fn a_rate_that_lost_what_it_depends_on_is_seen() {
        let error = spoilt(|basis, _, flow| slightly(basis, &mut flow.core[0].rate)).unwrap_err();
        assert_eq!(error, "a rate without what it does not depend on does not hold");
    }

    #[test]
    fn a_wrong_output_is_named() {
        let error = spoilt(|basis, _, flow| slightly(basis, &mut flow.wanted.outputs[1].1)).unwrap_err();
        assert_eq!(error, "the output phi does not hold");
    }
}
