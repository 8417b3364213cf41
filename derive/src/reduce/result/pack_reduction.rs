//! Packing of reduced equations as an ordinary model with equations, together with the list of
//! omissions.

use super::omissions::omissions;
use super::reduction::{ReducedOutput, ReducedQuantity, Reduction};
use super::reduction_proof::{WholeModel, prove_reduction};
use super::surface_choice::SurfaceChoice;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::term::steps::Definition;
use crate::algebra::text::print::print_text;
use crate::algebra::value::range::range_excludes_zero;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Node};
use crate::mechanics::{Derivation, Equations, EquationsOrigin, Formulation, RowName};
use crate::model::{Coordinate, DomainCondition, KinematicEquations, Parameter, Speed, Unit};
use crate::reduce::basis::hoisted_constants::Hoist;
use crate::reduce::basis::prose::Prose;
use crate::reduce::basis::reduction_basis::ReductionBasis;
use crate::reduce::levels::momentum_level::Level;
use crate::reduce::slices::potential_difference::PotentialDifference;
use crate::reduce::slices::slice::{Slice, Variable};
use crate::reduce::slices::wanted_outputs::WantedOutputs;
use crate::scene::Scene;
use rustc_hash::FxHashSet;

/// Packs the reduced equations of a scene as a model with equations, constants and the list of
/// omissions. The reduced equations are proved on the way.
///
/// # Errors
/// Text of the statement that could not be proved; the reduction must then not be used.
pub fn pack_reduction(
    mut basis: ReductionBasis,
    whole: &WholeModel,
    level: &Level,
    mut flow: Slice,
    scene: &Scene,
) -> Result<Reduction, String> {
    flow.pack_without_constant_energy(&mut basis, level);
    flow.pack_linear_system(&mut basis, level);
    let proof = prove_reduction(&mut basis, whole, level, &mut flow)?;
    let states = packed_quantities(&basis, &flow.core);
    let quadratures = packed_quantities(&basis, &flow.quadratures);
    let omitted = omissions(&mut basis, level, &flow, scene, &proof);
    // Events and conditions are evaluated without the definitions of the equations, so these are
    // written out.
    let mut dependence = flow.dependence.clone();
    for e in flow.wanted.events.iter_mut().chain(&mut flow.wanted.conditions) {
        *e = dependence.without_definitions(&mut basis.arena, *e);
    }
    let mut equations = packed_equations(&mut basis, level, &flow);
    let hoisted = hoist_packed_equations(&mut basis, level, &mut equations);
    let outputs =
        flow.wanted.outputs.iter().map(|(name, value)| ReducedOutput { name: name.clone(), value: *value }).collect();
    let folded = basis.folded.clone();
    let frame = basis.start_on_section();
    let kept_by_domain = basis.kept_by_domain.clone();
    let events = flow.wanted.events.clone();
    let slope =
        flow.potential_difference_for_quadrature(&mut basis, equations.kinetic_energy, equations.potential_energy);
    let constants = packed_constants(&mut basis, level, &flow, &equations, slope.as_ref(), &hoisted);
    let mut divisors = equations.divisors.clone();
    divisors.dedup();
    let has_energy = flow.energy.is_some();
    let time = flow.time;
    let model = packed_model(basis, &flow, &constants, &equations);
    let derivation = Derivation { arena: model.arena.clone(), equations };
    let reduction = Reduction {
        model,
        derivation,
        states,
        quadratures,
        constants,
        products: hoisted
            .constants
            .iter()
            .map(|(symbol, value)| Definition { symbol: *symbol, value: *value })
            .collect(),
        outputs,
        events,
        frame,
        surface: SurfaceChoice::default(),
        kept_by_domain,
        folded,
        omitted,
        divisors,
        has_energy,
        slope,
        time,
        proof,
    };
    check_symbols_have_values(&reduction)?;
    Ok(reduction)
}

/// Checks that every symbol in a formula has a value. The symbol must be a parameter, a variable,
/// the time, or defined by an earlier step.
///
/// # Errors
/// Text that names the first symbol without a value.
fn check_symbols_have_values(reduction: &Reduction) -> Result<(), String> {
    let (arena, e) = (reduction.arena(), &reduction.derivation.equations);
    let mut known: FxHashSet<Expr> = reduction.model.p().into_iter().collect();
    let has_value = |known: &FxHashSet<Expr>, values: &[Expr], what: &str| {
        let symbols = arena.reachable(values).into_iter().filter(|e| matches!(arena.node(*e), Node::Symbol(_)));
        let unknown = symbols.into_iter().find(|e| !known.contains(e)).and_then(|e| arena.symbol_name(e));
        unknown.map_or(Ok(()), |name| Err(format!("that `{name}`, which {what} mentions, has a value")))
    };
    if let Some(slope) = &reduction.slope {
        let (sincs, angles): (Vec<Expr>, Vec<Expr>) = slope.sincs.iter().copied().unzip();
        let mut known = known.clone();
        known.extend(slope.ends);
        has_value(&known, &angles, "the slope of the potential energy")?;
        known.extend(sincs);
        has_value(&known, &[slope.value], "the slope of the potential energy")?;
    }
    known.extend(e.coordinates.iter().chain(&e.variables));
    // Events and conditions are evaluated without the definitions.
    has_value(&known, &reduction.events, "an event")?;
    let conditions: Vec<Expr> = reduction.model.domain.iter().map(|c| c.positive).collect();
    has_value(&known, &conditions, "the domain")?;
    for definition in &e.definitions {
        has_value(&known, &[definition.value], "a step")?;
        known.insert(definition.symbol);
    }
    let rates =
        e.matrix.concat().into_iter().chain(e.forcing.iter().copied()).chain(e.coordinate_rates.iter().copied());
    has_value(&known, &rates.chain([e.kinetic_energy, e.potential_energy]).collect::<Vec<_>>(), "an equation")?;
    // Only outputs may be functions of the time.
    known.insert(reduction.time);
    reduction.outputs.iter().try_for_each(|o| has_value(&known, &[o.value], &format!("the output {}", o.name)))
}

/// Quantities for the given variables of the reduced equations. Their start values are terms in the
/// model's own variables.
fn packed_quantities(basis: &ReductionBasis, list: &[Variable]) -> Vec<ReducedQuantity> {
    let quantity = |v: &Variable| {
        let name = basis.arena.symbol_name(v.symbol).unwrap_or_default().to_owned();
        let model = &basis.model;
        let (of_start, own, about, unit) = if v.is_speed {
            let speed = &model.speeds[v.place];
            (basis.u_start[v.place], speed.symbol, "generalized speed", &speed.unit)
        } else {
            let coordinate = &model.coordinates[v.place];
            (basis.q_start[v.place], coordinate.symbol, coordinate.about.as_str(), &coordinate.unit)
        };
        let about = if of_start == own { about.into() } else { Prose::term(of_start) };
        ReducedQuantity { name, symbol: v.symbol, about, unit: unit.clone(), of_start }
    };
    list.iter().map(quantity).collect()
}

/// Lists the constants of the reduced equations: conserved momenta, positions of the mass centre at
/// the start, and products of parameters.
fn packed_constants(
    basis: &mut ReductionBasis,
    level: &Level,
    flow: &Slice,
    equations: &Equations,
    slope: Option<&PotentialDifference>,
    hoisted: &Hoist,
) -> Vec<ReducedQuantity> {
    let held = level.held.iter().map(|h| (h.symbol, h.about.clone(), h.unit.clone(), h.of_state));
    let places = flow.carried.iter().map(|c| {
        let about = Prose::term(c.position).append_prose(" at the start");
        let unit = basis.momenta[level.held[c.held].momentum].position_unit.clone();
        (c.symbol, about, unit, c.position)
    });
    let mut all: Vec<(Expr, Prose, Unit, Expr)> = held.chain(places).collect();
    let mut of_held = Substitution::new(&level.held.iter().map(|h| (h.symbol, h.of_state)).collect::<Vec<_>>());
    for (symbol, value) in &hoisted.constants {
        let unit = basis.model.unit_of(&basis.arena, *value).unwrap_or_default();
        let of_state = of_held.apply(&mut basis.arena, *value);
        all.push((*symbol, Prose::term(*value), unit, of_state));
    }
    let mentioned = packed_symbols(&basis.arena, flow, equations, slope);
    let mut back = basis.basis_to_model_substitution();
    all.into_iter()
        .filter(|(symbol, ..)| mentioned.contains(symbol))
        .map(|(symbol, about, unit, of_state)| {
            let of_start = back.apply(&mut basis.arena, of_state);
            let name = basis.arena.symbol_name(symbol).unwrap_or_default().to_owned();
            ReducedQuantity { name, symbol, about, unit, of_start }
        })
        .collect()
}

/// Set of all terms that the reduced equations compute, with their symbols and the definitions that
/// they use.
///
/// Constants replace products of momenta and parameters only in the equations. So other terms may
/// contain a momentum that the equations do not contain.
fn packed_symbols(arena: &Arena, flow: &Slice, e: &Equations, slope: Option<&PotentialDifference>) -> FxHashSet<Expr> {
    let wanted = flow.wanted.outputs_with_descriptions().into_iter().map(|(_, value)| value);
    let lists = [&e.forcing, &e.coordinate_rates].into_iter().flatten().chain(e.matrix.iter().flatten());
    let of_slope = slope.into_iter().flat_map(|slope| slope.sincs.iter().map(|(_, angle)| *angle).chain([slope.value]));
    let energies = [e.kinetic_energy, e.potential_energy];
    let all: Vec<Expr> = wanted.chain(lists.copied()).chain(energies).chain(of_slope).collect();
    let mut found: FxHashSet<Expr> = arena.reachable(&all).into_iter().collect();
    for definition in e.definitions.iter().rev() {
        if found.contains(&definition.symbol) {
            found.extend(arena.reachable(&[definition.value]));
        }
    }
    found
}

/// Replaces products of parameters in the equations by constants, because the equations are
/// evaluated at every step. Returns these constants.
fn hoist_packed_equations(basis: &mut ReductionBasis, level: &Level, e: &mut Equations) -> Hoist {
    let folded = &basis.folded;
    let free = basis.model.parameters.iter().filter(|p| folded.iter().all(|(name, _)| *name != p.name));
    let parameters: Vec<Expr> = free.map(|p| p.symbol).chain(level.held.iter().map(|h| h.symbol)).collect();
    let mut hoist = Hoist::default();
    let definitions = e.definitions.iter_mut().map(|d| &mut d.value);
    for value in definitions.chain(&mut e.forcing).chain(&mut e.coordinate_rates).chain(e.matrix.iter_mut().flatten()) {
        *value = hoist.apply(&mut basis.arena, &parameters, *value);
    }
    hoist
}

impl Slice {
    /// Removes a constant part of the energy if the reduced equations do not contain its momenta.
    /// An example is the kinetic energy of a mass centre that no output shows.
    fn pack_without_constant_energy(&mut self, basis: &mut ReductionBasis, level: &Level) {
        let Some(energy) = self.energy.take() else { return };
        let terms = self.packed_terms();
        let own = self.dependence.mentioned_symbols(&basis.arena, &terms);
        let pairs: Vec<(Expr, Expr)> =
            level.held.iter().filter(|h| !own.contains(&h.symbol)).map(|h| (h.symbol, Expr::ZERO)).collect();
        let whole = self.dependence.without_definitions(&mut basis.arena, energy);
        let mut without = Substitution::new(&pairs);
        let rest = without.apply(&mut basis.arena, whole);
        let difference = basis.arena.sub(whole, rest);
        let constant = self.core.iter().chain(&self.quadratures).all(|v| {
            let slope = Differential::partial(v.symbol).apply(&mut basis.arena, difference);
            zero_test(&basis.arena, slope) == ZeroTest::Zero
        });
        let short = without.apply(&mut basis.arena, energy);
        // If a definition that only the energy uses contains such a constant, the definition is
        // written out.
        let mentioned = self.dependence.mentioned_symbols(&basis.arena, &[short]);
        let clean = pairs.iter().all(|(symbol, _)| !mentioned.contains(symbol));
        self.energy = match (constant && without.undefined.is_none(), clean) {
            (true, true) => Some(short),
            (true, false) => Some(basis.simplifier.simplify(&mut basis.arena, rest)),
            (false, _) => Some(energy),
        };
    }

    /// Keeps the linear system matrix · u̇ = right of the level set instead of the solved rates.
    /// This requires that all of its speeds are integrated, and that it contains only variables on
    /// which the solved rates depend.
    fn pack_linear_system(&mut self, basis: &mut ReductionBasis, level: &Level) {
        let all: Vec<Variable> = self.core.iter().chain(&self.quadratures).copied().collect();
        let speeds = all.iter().filter(|v| v.is_speed).map(|v| v.place);
        if !speeds.eq(level.kept.iter().copied()) {
            return;
        }
        let variables: Vec<Expr> = self.raw.iter().map(|(symbol, _)| *symbol).collect();
        let (arena, simplifier, dependence) = (&mut basis.arena, &mut basis.simplifier, &mut self.dependence);
        let mut settle = |e: &Expr| dependence.without_independent_variables(arena, simplifier, *e, &variables);
        let matrix: Vec<Vec<Expr>> = level.matrix.iter().map(|row| row.iter().map(&mut settle).collect()).collect();
        let forcing: Vec<Expr> = level.forcing.iter().map(&mut settle).collect();
        let mentioned = self.dependence.mentioned_symbols(&basis.arena, &[matrix.concat(), forcing.clone()].concat());
        let of_rates: Vec<Expr> = all.iter().filter(|v| v.is_speed).map(|v| v.rate).collect();
        let needed = self.dependence.mentioned_symbols(&basis.arena, &of_rates);
        if variables.iter().all(|v| !mentioned.contains(v) || needed.contains(v)) {
            self.system = Some((matrix, forcing));
        }
    }

    /// All terms that the reduced equations compute: rates, outputs, conditions, events and the energy.
    pub(in crate::reduce) fn packed_terms(&self) -> Vec<Expr> {
        let rates = self.core.iter().chain(&self.quadratures).map(|v| v.rate);
        rates.chain(self.packed_shown_values()).collect()
    }

    /// Values that are shown or monitored: outputs, conditions, events, and the energy if it is
    /// known.
    fn packed_shown_values(&self) -> impl Iterator<Item = Expr> {
        let WantedOutputs { outputs, conditions, events } = &self.wanted;
        let outputs = outputs.iter().map(|(_, e)| *e);
        outputs.chain(conditions.iter().copied()).chain(events.iter().copied()).chain(self.energy)
    }
}

/// Builds the reduced equations: the solved rates v̇, or the linear system of the level set if it
/// was kept.
fn packed_equations(basis: &mut ReductionBasis, level: &Level, flow: &Slice) -> Equations {
    let all = || flow.core.iter().chain(&flow.quadratures);
    let speeds: Vec<&Variable> = all().filter(|v| v.is_speed).collect();
    let coordinates: Vec<&Variable> = all().filter(|v| !v.is_speed).collect();
    let variables: Vec<Expr> = speeds.iter().map(|v| v.symbol).collect();
    let unknowns: Vec<Expr> = speeds.iter().map(|v| basis.kane.unknowns[v.place]).collect();
    let n = speeds.len();
    let identity = |i: usize| (0..n).map(|j| if i == j { Expr::ONE } else { Expr::ZERO }).collect();
    // The matrix is the identity, with the solved accelerations on the right. If the linear system
    // was kept, it is used instead, and code generation eliminates it.
    let (mut matrix, mut forcing): (Vec<Vec<Expr>>, Vec<Expr>) =
        ((0..n).map(identity).collect(), speeds.iter().map(|v| v.rate).collect());
    if let Some((whole_matrix, whole_forcing)) = flow.system.as_ref().filter(|_| n > 1) {
        (matrix, forcing) = (whole_matrix.clone(), whole_forcing.clone());
    }
    // Solved accelerations may be needed for outputs, even if the equations are a linear system.
    let rates = coordinates.iter().map(|v| v.rate);
    let terms: Vec<Expr> =
        flow.packed_shown_values().chain(rates).chain(matrix.concat()).chain(forcing.iter().copied()).collect();
    let arena = &mut basis.arena;
    let (kinetic_energy, potential_energy) = flow.energy.map_or((Expr::ZERO, Expr::ZERO), |energy| {
        let at_rest: Vec<(Expr, Expr)> = variables.iter().map(|u| (*u, Expr::ZERO)).collect();
        let through = flow.dependence.mentioned_symbols(arena, &[energy]);
        let definitions = flow.dependence.definitions.iter().filter(|d| through.contains(&d.symbol));
        // A momentum may determine a speed only together with other speeds. Its definition is then
        // written out, to be evaluated at rest.
        let moving = definitions.into_iter().any(|d| variables.iter().any(|u| arena.mentions(d.value, *u)));
        let form = if moving { flow.dependence.clone().without_definitions(arena, energy) } else { energy };
        let potential = Substitution::new(&at_rest).apply(arena, form);
        let potential = basis.simplifier.simplify(arena, potential);
        let kinetic = arena.sub(energy, potential);
        (basis.simplifier.simplify(arena, kinetic), potential)
    });
    let present: Vec<Expr> = all().map(|v| v.symbol).collect();
    let divides = |d: &&Expr| present.iter().any(|s| arena.mentions(**d, *s));
    let definitions = flow.definitions_used_in_slice(arena, &terms);
    let divisors: Vec<Expr> = level.divisors.iter().chain(&basis.kane.divisors).filter(divides).copied().collect();
    let mut divisors: Vec<Expr> = divisors.into_iter().filter_map(|d| packed_divisor(arena, d)).collect();
    divisors.sort_unstable();
    divisors.dedup();
    Equations {
        definitions,
        required: Vec::new(),
        gauss: None,
        by: EquationsOrigin::Reduced,
        distance: None,
        formulation: Formulation::Kane,
        coordinates: coordinates.iter().map(|v| v.symbol).collect(),
        unknowns: unknowns.clone(),
        rows: variables.iter().map(|u| RowName::Along(print_text(arena, *u))).collect(),
        matrix,
        forcing,
        symmetric: true,
        projection: Vec::new(),
        embedding: None,
        coordinate_rates: coordinates.iter().map(|v| v.rate).collect(),
        speeds: variables.clone(),
        generalized_speeds: variables.clone(),
        generalized_speed_rates: unknowns,
        motion_variables: variables.clone(),
        variables,
        kinetic_energy,
        potential_energy,
        power: Expr::ZERO,
        divisors,
        constraints: Vec::new(),
    }
}

/// Product of the factors of a divisor that may be zero. Numbers and factors that are proved never
/// to be zero, such as an inertia, are left out. `None` if no factor remains.
fn packed_divisor(arena: &mut Arena, divisor: Expr) -> Option<Expr> {
    let (_, divisor) = arena.split_content(divisor);
    let factors = match arena.node(divisor) {
        Node::Product(factors) => factors.to_vec(),
        _ => vec![(divisor, 1)],
    };
    let above = factors.into_iter().filter(|(_, n)| *n > 0).map(|(base, _)| base);
    let open: Vec<Expr> = above.filter(|base| !range_excludes_zero(arena, *base)).collect();
    (!open.is_empty()).then(|| arena.product(&open))
}

/// Builds the model of the reduced equations from the free parameters, the constants, the remaining
/// variables and the conditions of the domain.
fn packed_model(
    basis: ReductionBasis,
    flow: &Slice,
    constants: &[ReducedQuantity],
    equations: &Equations,
) -> crate::Model {
    let ReductionBasis { model: whole, mut arena, folded, kane, .. } = basis;
    let free = whole.parameters.iter().filter(|p| folded.iter().all(|(name, _)| *name != p.name)).cloned();
    let held = constants.iter().map(|c| Parameter {
        name: c.name.clone(),
        symbol: c.symbol,
        unit: c.unit.clone(),
        value: None,
        positive: false,
        is_input: false,
        about: c.about.text(&arena),
    });
    let parameters = free.chain(held).collect();
    let all = || flow.core.iter().chain(&flow.quadratures);
    let coordinates = all().filter(|v| !v.is_speed).map(|v| {
        let old = &whole.coordinates[v.place];
        let name = arena.symbol_name(v.symbol).unwrap_or_default().to_owned();
        if v.symbol == old.symbol {
            return old.clone();
        }
        let (rate, second_rate) = (arena.symbol(&format!("{name}'")), arena.symbol(&format!("{name}''")));
        Coordinate { name, symbol: v.symbol, rate, second_rate, unit: old.unit.clone(), about: old.about.clone() }
    });
    let coordinates = coordinates.collect();
    let speeds: Vec<Speed> = all()
        .filter(|v| v.is_speed)
        .map(|v| {
            let (old, name) = (&whole.speeds[v.place], arena.symbol_name(v.symbol).unwrap_or_default().to_owned());
            Speed { name, symbol: v.symbol, rate: kane.unknowns[v.place], definition: v.symbol, unit: old.unit.clone() }
        })
        .collect();
    let conditions = whole.domain.iter().zip(&flow.wanted.conditions);
    let domain = conditions.map(|(c, e)| DomainCondition { positive: *e, ..c.clone() }).collect();
    let kinematic_equations = KinematicEquations {
        rates: equations.coordinate_rates.clone(),
        divisors: equations.divisors.clone(),
        has_dependent_speeds: false,
    };
    crate::Model {
        arena,
        parameters,
        coordinates,
        speeds,
        bodies: Vec::new(),
        gravity: None,
        forces: Vec::new(),
        torques: Vec::new(),
        reactions: Vec::new(),
        constraints: Vec::new(),
        motion_constraints: Vec::new(),
        loops: Vec::new(),
        domain,
        kinematic_equations,
        ..whole
    }
}
