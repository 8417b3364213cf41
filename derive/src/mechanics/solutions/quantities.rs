//! Values of the quantities in a textbook derivation: velocities, loads, generalized forces, energies.
//!
//! Every value is computed from the kinematics that the formulations share, or read from their equations. Values are
//! kept. Equations are solved only in [`Quantities::solved`]. All other values keep u̇ and the reactions as symbols.

mod lagrangian;
#[cfg(test)]
mod name_tests;
mod parse_quantity;
#[cfg(test)]
mod tests;
mod vectors;
mod velocity_terms;

pub use parse_quantity::QuantityError;

use super::accelerations::accelerations;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::{Expr, Rational};
use crate::geometry::{Components, Vector, apply_tensor};
use crate::mechanics::derivation::Derivations;
use crate::mechanics::equations::Equations;
use crate::mechanics::formulations::formulation::Formulation;
use crate::mechanics::formulations::kane;
use crate::mechanics::motion::kinematics::{Kinematics, Velocities, kinematic_rates};
use crate::mechanics::quantity::{EnergyQuantity, Quantity, QuantityKind, RowQuantity, VectorName};
use crate::model::{ForcePlace, Model, TIME};
use rustc_hash::FxHashMap;

/// Components of a 3 × 3 tensor along a frame, row by row.
type Tensor = [[Expr; 3]; 3];

/// Values of a model's quantities, such as velocities and energies, as terms in the arena of its
/// derivations.
pub struct Quantities<'a> {
    /// Model whose quantities are derived.
    pub model: &'a Model,
    /// Derivations of the model; the arena `derivations.kinematics.arena` contains every value.
    pub derivations: &'a mut Derivations,
    /// Velocities of all frames and points as terms in q and the generalized speeds u.
    velocities: Velocities,
    /// Operator of the time derivative of terms in q and u, along the motion.
    d_dt: Differential,
    /// Substitution that replaces u and u̇ by terms in q, q̇ and q̈.
    to_rates: Substitution,
    /// Substitution that replaces q̇ and q̈ by terms in q, u and u̇.
    to_speeds: Substitution,
    /// Vectors computed so far, by kind and by index of the owner.
    vectors: FxHashMap<(VectorName, usize), Vector>,
    /// Components of vectors computed so far, by kind, index of the owner, and frame.
    components: FxHashMap<(VectorName, usize, usize), Components>,
    /// Central inertia tensors computed so far, by body and frame.
    inertias: FxHashMap<(usize, usize), Tensor>,
    /// Kane's generalized active forces; `None` until first computed.
    active_forces: Option<Vec<Expr>>,
    /// Kane's generalized inertia forces; `None` until first computed.
    inertia_forces: Option<Vec<Expr>>,
    /// Substitution that replaces u̇ by the solved accelerations, as terms in q and u. `None` until first computed.
    accelerations: Option<Substitution>,
}

impl<'a> Quantities<'a> {
    /// Creates the quantities of a model; no value is derived yet.
    pub fn new(model: &'a Model, derivations: &'a mut Derivations) -> Self {
        let velocities = derivations.kinematics.in_speeds(model);
        let arena = &mut derivations.kinematics.arena;
        let mut d_dt = kinematic_rates(model);
        let mut to_speeds = Vec::new();
        for (c, rate) in model.coordinates.iter().zip(&model.kinematic_equations.rates) {
            to_speeds.push((c.rate, *rate));
            to_speeds.push((c.second_rate, d_dt.apply(arena, *rate)));
        }
        let mut rates: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        rates.extend(model.coordinates.iter().map(|c| (c.rate, c.second_rate)));
        let mut along_rates = Differential::along(&rates);
        let mut to_rates = Vec::new();
        for speed in &model.speeds {
            to_rates.push((speed.symbol, speed.definition));
            to_rates.push((speed.rate, along_rates.apply(arena, speed.definition)));
        }
        Self {
            model,
            derivations,
            velocities,
            d_dt,
            to_rates: Substitution::new(&to_rates),
            to_speeds: Substitution::new(&to_speeds),
            vectors: FxHashMap::default(),
            components: FxHashMap::default(),
            inertias: FxHashMap::default(),
            active_forces: None,
            inertia_forces: None,
            accelerations: None,
        }
    }

    /// Derives the value of a quantity as a simplified term.
    ///
    /// Most values are terms in parameters, q and u. Values with accelerations are also linear in u̇, and loads
    /// contain reactions. Other values are in q and q̇: speeds, Lagrange's E and A, derivatives of L, and terms of M
    /// q̈ + C q̇ + g = τ.
    ///
    /// # Errors
    /// Returns the reason, as text, why the formulation of the quantity cannot be derived.
    pub fn value(&mut self, quantity: &Quantity) -> Result<Expr, String> {
        let value = match *quantity.kind() {
            QuantityKind::Rotation { from, to, entry: (i, j) } => {
                let Kinematics { arena, frames, .. } = &mut self.derivations.kinematics;
                frames.rotation(arena, from, to)[i][j]
            }
            QuantityKind::Component { vector, of, frame, axis } => self.component(vector, of, frame)[axis],
            QuantityKind::MaterialVelocity { body, point, frame, axis } => {
                let (model, kinematics) = (self.model, &mut self.derivations.kinematics);
                let velocity = kinematics.load_place_velocity(model, &self.velocities, ForcePlace { body, point });
                kinematics.frames.component(&mut kinematics.arena, &velocity, frame, axis)
            }
            QuantityKind::Partial { vector, of, frame, axis, speed } => {
                let component = self.component(vector, of, frame)[axis];
                let mut partial = Differential::partial(self.model.speeds[speed].symbol);
                partial.apply(&mut self.derivations.kinematics.arena, component)
            }
            QuantityKind::Inertia { body, frame, entry: (i, j) } => self.inertia(body, frame)[i][j],
            QuantityKind::Row(RowQuantity::ActiveForce, at) => self.active_forces()[at],
            QuantityKind::Row(RowQuantity::InertiaForce, at) => self.inertia_forces()[at],
            QuantityKind::Row(RowQuantity::Forcing, at) => self.equations(Formulation::Kane)?.forcing[at],
            QuantityKind::Row(RowQuantity::LagrangeForcing, at) => self.equations(Formulation::Lagrange)?.forcing[at],
            QuantityKind::Row(RowQuantity::VelocityTerms, at) => self.velocity_terms(at)?,
            QuantityKind::Row(RowQuantity::PotentialSlope, at) => self.potential_slope(at)?,
            QuantityKind::Row(RowQuantity::Momentum, at) => self.momentum(at)?,
            QuantityKind::Row(RowQuantity::MomentumRate, at) => self.momentum_rate(at)?,
            QuantityKind::Row(RowQuantity::HeldMomentumRate, at) => self.partial_time_derivative_of_momentum(at)?,
            QuantityKind::Row(RowQuantity::LagrangianSlope, at) => self.lagrangian_slope(at)?,
            QuantityKind::Christoffel(i, j) => self.christoffel(i, j)?,
            QuantityKind::MassRate(i, j) => self.mass_rate(i, j)?,
            QuantityKind::MassMatrix(i, j) => self.equations(Formulation::Kane)?.matrix[i][j],
            QuantityKind::LagrangeMatrix(i, j) => self.equations(Formulation::Lagrange)?.matrix[i][j],
            QuantityKind::Energy(energy) => self.energy(energy)?,
            QuantityKind::Speed(at) => self.model.speeds[at].definition,
            QuantityKind::Rate(at) => self.model.kinematic_equations.rates[at],
            QuantityKind::SpeedRate(at) => {
                let rate = self.model.speeds[at].rate;
                self.solved(rate)?
            }
            QuantityKind::SecondRate(at) => {
                let rate = self.model.kinematic_equations.rates[at];
                let second = self.d_dt.apply(&mut self.derivations.kinematics.arena, rate);
                self.solved(second)?
            }
        };
        Ok(self.simplify(value))
    }

    /// Replaces every u̇ and q̈ in a term by its value from the solved Kane equations, in q and u.
    ///
    /// # Errors
    /// Returns the reason, as text, why Kane's equations cannot be derived or do not determine the accelerations.
    pub fn solved(&mut self, e: Expr) -> Result<Expr, String> {
        let e = self.to_speeds.apply(&mut self.derivations.kinematics.arena, e);
        if self.accelerations.is_none() {
            let kane = self.equations(Formulation::Kane)?.clone();
            let Kinematics { arena, simplifier, .. } = &mut self.derivations.kinematics;
            let steps = accelerations(arena, simplifier, &kane).map_err(|why| why.to_string())?.steps;
            let mut written = Substitution::default();
            for step in steps {
                let value = written.apply(arena, step.value);
                written.set(step.symbol, value);
            }
            self.accelerations = Some(written);
        }
        let written = self.accelerations.as_mut().expect("made above");
        Ok(written.apply(&mut self.derivations.kinematics.arena, e))
    }

    /// True if a term contains q̇ or q̈. Such a term is compared in q and q̇.
    #[must_use]
    pub fn mentions_rates(&self, e: Expr) -> bool {
        let symbols = self.model.coordinates.iter().flat_map(|c| [c.rate, c.second_rate]);
        self.mentions(e, symbols)
    }

    /// True if a term contains a generalized speed u or its rate u̇.
    #[must_use]
    pub fn mentions_speeds(&self, e: Expr) -> bool {
        let symbols = self.model.speeds.iter().flat_map(|s| [s.symbol, s.rate]);
        self.mentions(e, symbols)
    }

    /// True if a term contains an acceleration q̈ or u̇.
    #[must_use]
    pub fn mentions_accelerations(&self, e: Expr) -> bool {
        let coordinates = self.model.coordinates.iter().map(|c| c.second_rate);
        self.mentions(e, coordinates.chain(self.model.speeds.iter().map(|s| s.rate)))
    }

    /// True if a term contains any of the given symbols.
    fn mentions(&self, e: Expr, mut symbols: impl Iterator<Item = Expr>) -> bool {
        let parts = self.derivations.kinematics.arena.reachable(&[e]);
        symbols.any(|s| parts.binary_search(&s).is_ok())
    }

    /// Rewrites a term in q, q̇ and q̈: replaces u by J q̇ + d, and u̇ by the time derivative of J q̇ + d.
    ///
    /// If a divisor would become the literal 0, the quotient stays unchanged. [`Self::mentions_speeds`] is then true
    /// for the result.
    pub fn in_rates(&mut self, e: Expr) -> Expr {
        self.to_rates.apply(&mut self.derivations.kinematics.arena, e)
    }

    /// Rewrites a term in q, u and u̇: replaces q̇ by W u + w, and q̈ by the time derivative of W u + w.
    ///
    /// If a divisor would become the literal 0, the quotient stays unchanged. [`Self::mentions_rates`] is then true
    /// for the result.
    pub fn in_speeds(&mut self, e: Expr) -> Expr {
        self.to_speeds.apply(&mut self.derivations.kinematics.arena, e)
    }

    /// Replaces the rate t' of time by 1 in a term, for models in which time is a coordinate.
    pub fn at_clock(&mut self, e: Expr) -> Expr {
        let clock: Vec<_> =
            self.model.coordinates.iter().filter(|c| c.name == TIME).map(|c| (c.rate, Expr::ONE)).collect();
        if clock.is_empty() { e } else { Substitution::new(&clock).apply(&mut self.derivations.kinematics.arena, e) }
    }

    /// Value of T, L or T + V without any constraint substituted, as a term in q and the rates q̇ of
    /// all coordinates. For any other quantity, returns `derived`.
    #[must_use]
    pub fn before_constraints(&mut self, kind: &QuantityKind, derived: Expr) -> Expr {
        let QuantityKind::Energy(energy) = kind else { return derived };
        let Ok(lagrange) = self.equations(Formulation::Lagrange) else { return derived };
        let (t, v) = (lagrange.kinetic_energy, lagrange.potential_energy);
        let t = self.at_clock(t);
        let arena = &mut self.derivations.kinematics.arena;
        match energy {
            EnergyQuantity::Kinetic => t,
            EnergyQuantity::Lagrangian => arena.sub(t, v),
            EnergyQuantity::Total => arena.add(t, v),
            _ => derived,
        }
    }

    /// Simplifies a term with the simplifier of the kinematics.
    fn simplify(&mut self, e: Expr) -> Expr {
        let Kinematics { arena, simplifier, .. } = &mut self.derivations.kinematics;
        simplifier.simplify(arena, e)
    }

    /// Equations by a formulation, from the list of derivations.
    ///
    /// # Errors
    /// Returns the reason, as text, why there are no such equations.
    fn equations(&self, formulation: Formulation) -> Result<&Equations, String> {
        let found = self.derivations.list.iter().find(|(f, _)| *f == formulation);
        match found {
            Some((_, Ok(equations))) => Ok(equations),
            Some((_, Err(error))) => Err(error.to_string()),
            None => Err(format!("{} was not derived", formulation.name())),
        }
    }

    /// Central inertia tensor R I Rᵀ of a body along a frame, kg m². R rotates from the frame in which the model
    /// states the inertia I. Zero for a particle.
    fn inertia(&mut self, body: usize, frame: usize) -> Tensor {
        if let Some(done) = self.inertias.get(&(body, frame)) {
            return *done;
        }
        // The parser refuses the inertia of a particle.
        let Some((_, inertia)) = &self.model.bodies[body].rigid else { return [[Expr::ZERO; 3]; 3] };
        let Kinematics { arena, frames, simplifier, .. } = &mut self.derivations.kinematics;
        let r = frames.rotation(arena, inertia.frame, frame);
        let columns = r.map(|row| apply_tensor(arena, &inertia.tensor, &row));
        // Entry (i, j) is rᵢ · I rⱼ, with rᵢ the i-th row of R.
        let tensor = r.map(|row| {
            columns.map(|column| {
                let products: Vec<Expr> = row.iter().zip(&column).map(|(a, b)| arena.mul(*a, *b)).collect();
                let entry = arena.sum(&products);
                simplifier.simplify(arena, entry)
            })
        });
        self.inertias.insert((body, frame), tensor);
        tensor
    }

    /// Kane's generalized active forces, one for each speed. They are computed at the first call.
    fn active_forces(&mut self) -> &[Expr] {
        let (model, kinematics, velocities) = (self.model, &mut self.derivations.kinematics, &self.velocities);
        self.active_forces.get_or_insert_with(|| kane::kane_active_forces(model, kinematics, velocities))
    }

    /// Kane's generalized inertia forces, one for each speed. They are computed at the first call.
    fn inertia_forces(&mut self) -> &[Expr] {
        let (model, kinematics, velocities) = (self.model, &mut self.derivations.kinematics, &self.velocities);
        self.inertia_forces.get_or_insert_with(|| kane::kane_inertia_forces(model, kinematics, velocities))
    }

    /// Value of an energy as a term in q and u, J.
    ///
    /// # Errors
    /// Returns the reason, as text, why Kane's equations or the potential of gravity cannot be derived.
    fn energy(&mut self, energy: EnergyQuantity) -> Result<Expr, String> {
        let kane = self.equations(Formulation::Kane)?;
        let (t, v) = (kane.kinetic_energy, kane.potential_energy);
        Ok(match energy {
            EnergyQuantity::Kinetic => t,
            EnergyQuantity::Translation => self.part_of_energy(VectorName::Velocity),
            EnergyQuantity::Rotation => self.part_of_energy(VectorName::AngularVelocity),
            EnergyQuantity::Potential => v,
            EnergyQuantity::Gravity => {
                let (model, kinematics) = (self.model, &mut self.derivations.kinematics);
                kinematics.gravity_potential(model).map_err(|error| error.to_string())?
            }
            EnergyQuantity::Lagrangian => self.derivations.kinematics.arena.sub(t, v),
            EnergyQuantity::Total => self.derivations.kinematics.arena.add(t, v),
        })
    }

    /// Kinetic energy of translation Σ ½ m v·v, J, if `name` is the velocity. Kinetic energy of rotation Σ ½ ω·H, J,
    /// if it is the angular velocity.
    fn part_of_energy(&mut self, name: VectorName) -> Expr {
        let model = self.model;
        let mut terms = Vec::new();
        for (at, body) in model.bodies.iter().enumerate() {
            let (velocity, momentum) = match (name, &body.rigid) {
                (VectorName::Velocity, _) => {
                    let v = self.vector(VectorName::Velocity, body.centre);
                    let momentum = v.scale(&mut self.derivations.kinematics.arena, body.mass);
                    (v, momentum)
                }
                (_, Some((frame, _))) => {
                    let omega = self.vector(VectorName::AngularVelocity, *frame);
                    (omega, self.vector(VectorName::AngularMomentum, at))
                }
                (_, None) => continue,
            };
            let Kinematics { arena, frames, .. } = &mut self.derivations.kinematics;
            terms.push(frames.dot(arena, &velocity, &momentum));
        }
        let arena = &mut self.derivations.kinematics.arena;
        let twice = arena.sum(&terms);
        arena.scale(twice, &Rational::fraction(1, 2).expect("not zero"))
    }
}
