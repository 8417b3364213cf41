//! Reads the text of a model file into a checked [`Model`].
//!
//! Invariant: every error is reported once, at its cause. An item that depends on an item with a reported error fails
//! silently. So `None` always means that an error is recorded in the reader.

use super::bodies::elements::Elements;
use super::bodies::input_signals::InputSignals;
use super::bodies::joints::Joints;
use super::bodies::mechanism_motion::MechanismMotion;
use super::constraints::configuration_constraints::{
    Closure, SolvedConfiguration, StatedConstraint, solve_configuration_constraints,
};
use super::constraints::constant_loops::KnownParameters;
use super::constraints::loop_closures::LoopMechanism;
use super::constraints::motion_constraints::{ConstraintParts, MotionConstraints};
use super::constraints::openings::joint_opening_motions;
use super::impossible_bodies::default_parameter_values;
use super::input::InputBinding;
use super::reading::declared_names::{NameKind, Names};
use super::reading::loading::Loading;
use super::reading::repetition::expand_repetition;
use super::{
    ComparedBodies, Coordinate, DomainCondition, HeldOrientation, JointReaction, Model, NamedVelocity, Parameter,
    RedundantEquation, SlipComponent,
};
use crate::algebra::solve::pivot_values::PivotValues;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::{Arena, Expr};
use crate::diagnostic::{Diagnostic, Diagnostics, Source, shortened_for_message};
use crate::toml_reader::{Entry, Located, TomlReader};
use rustc_hash::FxHashMap;
use std::ops::Range;
use toml::de::DeTable;

/// Keys of a model file at its top level.
const KEYS: [&str; 27] = [
    "schema",
    "name",
    "source",
    "expressions",
    "joints",
    "parameters",
    "coordinates",
    "speeds",
    "inertial",
    "frames",
    "points",
    "bodies",
    "particles",
    "gravity",
    "forces",
    "torques",
    "springs",
    "friction",
    "potentials",
    "inputs",
    "reactions",
    "constraints",
    "assembly",
    "rolling",
    "domain",
    "shapes",
    "notation",
];

impl Model {
    /// Reads and checks the model file at a path.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] with every error of the model file.
    #[cfg(feature = "files")]
    pub fn read(path: &std::path::Path) -> Result<Self, Diagnostics> {
        load(&Source::read(path)?)
    }
}

/// True if a text is a model file. It then has a section that only model files have, such as `[bodies]`, or the
/// section `[coordinates]` without the entries of a publication, such as `[equation]`.
#[must_use]
pub fn is_model(source: &Source) -> bool {
    const OWN: [&str; 6] = ["inertial", "joints", "bodies", "particles", "frames", "points"];
    const ENTRIES: [&str; 6] = ["equation", "matrix", "definition", "system", "listing", "initial"];
    TomlReader::parse(source).is_ok_and(|(_, table)| {
        let has = |keys: &[&str]| keys.iter().any(|key| table.get_ref().contains_key(*key));
        has(&OWN) || has(&["coordinates"]) && !has(&ENTRIES)
    })
}

/// Reads and checks the text of a model file.
///
/// # Errors
/// Returns [`Diagnostics`] with every error of the model text.
///
/// # Panics
/// Never: a model text without errors gives a complete model.
pub fn load(source: &Source) -> Result<Model, Diagnostics> {
    load_with_inputs(source, Vec::new(), &[])
}

/// Reads and checks the text of a model file. `bindings` are formulas that replace inputs. A parameter is added to
/// the formula of each input in `varied`. Returns `Diagnostics` with every error of the text.
pub fn load_with_inputs(source: &Source, bindings: Vec<InputBinding>, varied: &[String]) -> Result<Model, Diagnostics> {
    let (mut reader, table) = TomlReader::parse(source)?;
    let table = table.get_ref();
    if table.is_empty() {
        let empty = source.text.trim_start_matches('\u{feff}').trim().is_empty();
        let message = if empty { "the model file is empty" } else { "the model file holds nothing but comments" };
        reader.errors.push(Diagnostic::of_file(message, "docs/model.md describes the format"));
    }
    reader.schema(table);
    reader.finish()?;
    let written = expand_repetition(&mut reader, table);
    let table = written.as_ref().unwrap_or(table);
    reader.finish()?;
    reader.report_unknown_keys(table, "a model file", &KEYS);
    let varied = varied.to_vec();
    let mut loading = Loading {
        reader,
        arena: Arena::new(),
        names: Names::default(),
        units: FxHashMap::default(),
        bindings,
        varied,
        literals: Vec::new(),
        stated_numbers: Vec::new(),
    };
    let mut model = loading.model(table, source);
    if let Some(model) = &mut model {
        loading.notation(table, model);
    }
    loading.reader.finish()?;
    Ok(model.expect("a model without errors is complete"))
}

impl Model {
    /// Copy of the model in which the formulas `bindings` replace inputs.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] for the file `scene`, at the byte range `place` of its inputs, if the model has errors
    /// with these formulas.
    pub fn reread_with_inputs(
        &self,
        bindings: Vec<InputBinding>,
        scene: &Source,
        place: Range<usize>,
    ) -> Result<Self, Diagnostics> {
        load_with_inputs(&self.source, bindings, &self.varied).map_err(|errors| {
            let why = errors.list.first().map_or_else(String::new, |error| error.message.clone());
            let message = format!("the model is not possible with these inputs: {}", shortened_for_message(&why));
            let help = "give formulas of t, coordinates, q', speeds and parameters";
            Diagnostics::new(scene.clone(), vec![Diagnostic::new(place, message, help)])
        })
    }

    /// Copy of the model with a parameter added to the formula of each input in `inputs`, so that derivatives with
    /// respect to the input exist. The parameter has the name of the input, and is 0 by default. Inputs that are
    /// parameters, and unknown names, change nothing.
    ///
    /// # Errors
    /// Returns the [`Diagnostics`] of the model file. The file of a model that was loaded has no errors.
    pub fn reread_with_varied_inputs(&self, inputs: &[String]) -> Result<Self, Diagnostics> {
        let is_formula = |name: &String| self.inputs.iter().any(|input| input.name == *name && !input.is_parameter);
        if inputs.iter().any(is_formula) {
            return load_with_inputs(&self.source, self.bindings.clone(), inputs);
        }
        // A scene may still give formulas to these inputs, so their names are kept.
        Ok(Self { varied: inputs.to_vec(), ..self.clone() })
    }
}

/// Connections of a mechanism as the model file states them: constraints, rolling contacts, and reactions of closing
/// joints.
struct Connections {
    /// Velocities and positions that occur by name in formulas.
    velocities: Vec<NamedVelocity>,
    /// Values of the velocities and positions that formulas name, as (symbol, term). Empty if no formula needs them.
    values: Vec<(Expr, Expr)>,
    /// Constraints that contain coordinates only, no rates.
    configuration: Vec<StatedConstraint>,
    /// Constraints that contain rates or speeds.
    motion: Vec<StatedConstraint>,
    /// Equations of rolling, each with the component of the slip velocity that it makes zero.
    slips: Vec<(StatedConstraint, SlipComponent)>,
    /// Reactions of joints that close loops, each for one equation of a joint.
    holding: Vec<JointReaction>,
    /// Equations of joints that close loops, as components of vectors.
    closures: Vec<Closure>,
    /// Orientations that joints that close loops hold.
    orientations: Vec<HeldOrientation>,
    /// True if all connections were read without errors.
    is_known: bool,
}

/// Coordinates of a model file, and definitions of its speeds as text.
struct DeclaredVariables {
    /// Coordinates, with time last if formulas contain it.
    coordinates: Vec<Coordinate>,
    /// Number of coordinates, time excluded.
    configuration_variables: usize,
    /// Speeds of the model, each as (name, definition as text).
    texts: Vec<(Located, Located)>,
}

impl<'a> Loading<'a> {
    /// Builds the model from a parsed file; `None` after errors are recorded.
    #[allow(clippy::too_many_lines, reason = "one step for each section of the file, in their order")]
    fn model(&mut self, table: &'a DeTable<'a>, source: &Source) -> Option<Model> {
        let (title, reference) = (self.title(table), self.text(table, "source").unwrap_or_default());
        let mut parameters = self.parameters(table);
        let before_motion = self.reader.errors.len();
        let joints = self.joints(table);
        let DeclaredVariables { mut coordinates, configuration_variables, texts } = self.variables(table, &joints);
        let mut motion_errors = self.reader.errors.len() - before_motion;
        let reactions = self.reaction_symbols(table);
        let has_speeds = self.missing_sections(table, &joints, &coordinates);
        let mut signals = self.inputs(table, &mut parameters);
        let mut elements = Elements::read(self, table, &joints, &reactions);
        let shapes = self.shapes(table, &elements, &parameters);
        let before_constraints = self.reader.errors.len();
        let Connections {
            velocities,
            values,
            configuration,
            motion,
            slips,
            holding,
            mut closures,
            mut orientations,
            is_known,
        } = self.connections(table, &mut elements, &coordinates, &joints);
        let SolvedConfiguration {
            constraints,
            replacements,
            kept,
            constant,
            repeated: said,
            prescribing,
            opened,
            drives,
            undefined,
        } = solve_configuration_constraints(
            &mut self.reader,
            &mut self.arena,
            &mut coordinates,
            &elements.potentials,
            configuration,
            &closures,
            &KnownParameters::new(&default_parameter_values(&parameters), &self.units),
        );
        self.report_undefined(undefined);
        motion_errors += self.reader.errors.len() - before_constraints;
        let mut domain = self.domain(table);
        self.insert_number_parameters(&mut parameters);
        signals.put_in(&mut self.arena, &mut elements, &mut domain);
        let (stated_speeds, speeds) = (texts.len(), self.speeds(texts, &values, &replacements));
        let openings = joint_opening_motions(&mut self.arena, &opened, &elements, &[&kept, &motion], &replacements);
        let assembly = self.assembly(table);
        let mut fixed = Substitution::new(&replacements);
        elements.rewrite(&mut |e| fixed.apply(&mut self.arena, e));
        elements.check_elements(self, &parameters);
        for closure in &mut closures {
            closure.vector = closure.vector.substitute(&mut self.arena, &mut fixed);
        }
        for held in &mut orientations {
            held.cosines = fixed.apply(&mut self.arena, held.cosines);
        }
        let mut fix = |constraint: StatedConstraint| constraint.substitute(&mut self.arena, &mut fixed);
        let [kept, stated]: [Vec<_>; 2] = [kept, motion].map(|list| list.into_iter().map(&mut fix).collect());
        let tied = ConstraintParts {
            coordinates: &coordinates,
            elements: &elements,
            speeds: &speeds,
            joints: &joints,
            parameters: &parameters,
            assembly: assembly.as_ref(),
            drives: &drives,
            orientations: &orientations,
            kept,
            stated,
            rolling: slips.into_iter().map(|(c, rolled)| (fix(c), rolled)).collect(),
        };
        let ties = if is_known { self.motion_constraints(tied) } else { None };
        let known = ties.as_ref().filter(|_| motion_errors == 0 && speeds.len() == stated_speeds);
        let (speeds, left_out) = match known {
            Some(ties) => self.independent_speeds(&coordinates, &replacements, speeds, &joints, ties),
            None => (speeds, Vec::new()),
        };
        let stated_speeds = stated_speeds - left_out.len();
        self.report_undefined(fixed.undefined);
        let of_left_out = left_out.iter().map(|speed| (speed.symbol, speed.definition));
        let mut fixed = Substitution::new(&replacements.into_iter().chain(of_left_out).collect::<Vec<_>>());
        elements.rewrite(&mut |e| fixed.apply(&mut self.arena, e));
        // After an error in any declaration, the number and the rank of the speeds are meaningless.
        let tied = ties.as_ref().filter(|_| motion_errors == 0 && speeds.len() == stated_speeds && has_speeds);
        let branch = ties.as_ref().and_then(|ties| ties.branch.as_ref());
        let assembled = assembly.as_ref().and_then(|assembly| match branch {
            Some(branch) => Some(branch.pose.clone()),
            None => {
                let known = default_parameter_values(&parameters);
                assembly.pose(&self.arena, &coordinates, &elements.frames, &known)
            }
        });
        let home = branch.filter(|_| assembly.is_some());
        let point = home.map(|branch| {
            let poses = coordinates.iter().map(|c| c.symbol).zip(branch.pose.iter().copied());
            PivotValues::new(default_parameter_values(&parameters).into_iter().chain(poses))
        });
        let kinematic_equations = tied.and_then(|ties| {
            let loops = LoopMechanism {
                coordinates: &coordinates,
                elements: &elements,
                speeds: speeds.iter().map(|(speed, _)| speed).collect(),
                dependent: &left_out,
                constraints: ties,
                closures: &closures,
                point: point.as_ref(),
            };
            self.rates_of_long_loops(&loops)
                .or_else(|| self.kinematic_equations(table, &coordinates, &speeds, &ties.motion, point.as_ref()))
        });
        self.replace_in_conditions(&mut fixed, &mut domain, &mut signals);
        let expressions = self.named_expressions_with(&mut fixed);
        let MotionConstraints { motion, loops, repeated, conditions: unchanged, closed, dependent, branch, .. } =
            ties.filter(|_| self.reader.errors.is_empty())?;
        let without_coordinates = constant.iter().map(|one| one.name.clone());
        let said: Vec<String> = said.into_iter().chain(without_coordinates).collect();
        let conditions = constant.into_iter().map(|StatedConstraint { name, equation, .. }| (name, equation));
        let conditions = conditions.chain(unchanged).collect();
        let mut model = Model {
            title: title?,
            reference,
            source: source.clone(),
            arena: std::mem::take(&mut self.arena),
            parameters,
            coordinates,
            configuration_variables,
            speeds: speeds.into_iter().map(|(speed, _)| speed).collect(),
            dependent_speeds: left_out.into_iter().map(|speed| joints.dependent_joint_speed(speed)).collect(),
            motion_constraints: motion.into_iter().map(|(constraint, _)| constraint).collect(),
            carried: joints.jointed_bodies(&elements),
            frames: elements.frames,
            points: elements.points,
            bodies: elements.bodies,
            added_masses: elements.added_masses,
            gravity: elements.gravity,
            inputs: signals.list,
            bindings: std::mem::take(&mut self.bindings),
            varied: std::mem::take(&mut self.varied),
            forces: elements.forces,
            torques: elements.torques,
            potentials: elements.potentials,
            efforts: Vec::new(),
            velocities,
            reactions: elements.reactions,
            redundant: Vec::new(),
            contacts: elements.contacts,
            constraints,
            openings,
            loops,
            closed,
            orientations,
            assembly: assembled,
            conditions,
            dependent,
            branch,
            domain,
            shapes,
            kinematic_equations: kinematic_equations?,
            repeated: said.into_iter().map(RedundantEquation::of_loop).chain(repeated).collect(),
            unused: self.names.unused_declarations(),
            declared: self.names.places(),
            expressions,
        };
        self.complete_model(&mut model, holding, &prescribing, &mut fixed);
        Some(model)
    }

    /// Named expressions of the model file, as (name, term). The variables that constraints determine are replaced by
    /// their values.
    fn named_expressions_with(&mut self, fixed: &mut Substitution) -> Vec<(String, Expr)> {
        let put = |(name, e)| (name, fixed.apply(&mut self.arena, e));
        self.names.expressions().into_iter().map(put).collect()
    }

    /// Inserts the parameters for numbers with units into the list of parameters, before the inputs.
    fn insert_number_parameters(&mut self, parameters: &mut Vec<Parameter>) {
        let inputs_at = parameters.iter().position(|parameter| parameter.is_input).unwrap_or(parameters.len());
        parameters.splice(inputs_at..inputs_at, std::mem::take(&mut self.stated_numbers));
    }

    /// Reads the coordinates, including those of joints and time. Also reads the definitions of the speeds as text.
    fn variables(&mut self, table: &'a DeTable<'a>, joints: &Joints<'a>) -> DeclaredVariables {
        let mut coordinates = self.coordinates(table, joints);
        let configuration_variables = coordinates.len();
        self.time(table, &mut coordinates);
        let texts = self.speed_symbols(table, joints);
        for c in &mut coordinates {
            c.second_rate = self.arena.symbol(&format!("{}''", c.name));
        }
        DeclaredVariables { coordinates, configuration_variables, texts }
    }

    /// Replaces the variables that constraints determine in the conditions of the domain and in the inputs. Reports a
    /// replacement that divides by zero.
    fn replace_in_conditions(
        &mut self,
        fixed: &mut Substitution,
        domain: &mut [DomainCondition],
        signals: &mut InputSignals,
    ) {
        let positives = domain.iter_mut().map(|condition| &mut condition.positive);
        let values = positives.chain(signals.list.iter_mut().map(|input| &mut input.value));
        values.for_each(|value| *value = fixed.apply(&mut self.arena, *value));
        self.report_undefined(fixed.undefined);
    }

    /// Completes a model: finds its reactions, and replaces the names of reactions in conditions of the domain.
    fn complete_model(
        &mut self,
        model: &mut Model,
        holding: Vec<JointReaction>,
        prescribing: &[String],
        fixed: &mut Substitution,
    ) {
        model.loops.iter_mut().for_each(|one| one.prescribes = prescribing.contains(&one.name));
        model.add_joint_reactions(holding, fixed);
        model.add_potential_forces_and_reactions();
        let open = model.name_reactions(std::mem::take(&mut self.names.reactions));
        self.reader.errors.extend(open);
    }

    /// Declares the names and symbols of the reactions that the model file states.
    fn reaction_symbols(&mut self, table: &'a DeTable<'a>) -> Vec<Entry<'a>> {
        let reactions = self.section(table, "reactions", &[NameKind::Reaction]);
        for (name, _) in &reactions {
            let symbol = self.arena.symbol(&name.text);
            self.names.declare(&mut self.reader, name, NameKind::Reaction, Some(symbol));
        }
        reactions
    }

    /// Title of the model; `None` after an error is reported.
    fn title(&mut self, table: &'a DeTable<'a>) -> Option<String> {
        if !table.contains_key("name") {
            self.reader.errors.push(Diagnostic::of_file("the model has no `name`", "add `name = \"…\"` at the top"));
        }
        let title = self.reader.get(table, "name").and_then(|v| self.reader.name(v, "`name`"));
        title.map(|title| title.text)
    }

    /// Reports a term that divides by zero in every pose in which the constraints hold. `None` reports nothing.
    fn report_undefined(&mut self, term: Option<Expr>) {
        if let Some(term) = term {
            let term = crate::algebra::text::print::print_text(&self.arena, term);
            let message = format!("`{term}` divides by zero wherever the constraints hold");
            self.reader.errors.push(Diagnostic::of_file(message, "a constrained variable must not divide"));
        }
    }

    /// Reads constraints, rolling contacts, springs, friction and potentials. Named velocities and positions are
    /// replaced by terms, and springs become forces.
    fn connections(
        &mut self,
        table: &'a DeTable<'a>,
        elements: &mut Elements,
        coordinates: &[Coordinate],
        joints: &Joints<'a>,
    ) -> Connections {
        let mut stated = self.constraints(table, elements);
        stated.extend(self.euler_parameter_norms(&elements.frames));
        let rolling = self.rolling_constraints(table, elements);
        let springs = self.springs(table, elements);
        let friction = self.friction(table, elements);
        let potentials = self.potentials(table);
        let closings = joints.closing_joints(elements);
        let names: Vec<Expr> = self.names.velocities.iter().map(|v| v.symbol).collect();
        let velocities = elements.velocities(self);
        let mut compared: Vec<ComparedBodies> = stated
            .iter()
            .map(|c| self.compare_bodies(elements, coordinates, &velocities, &c.name, c.equation))
            .collect();
        let names_motion =
            |c: &StatedConstraint| self.arena.reachable(&[c.equation]).iter().any(|part| names.contains(part));
        let needs_motion = !closings.is_empty()
            || !rolling.is_empty()
            || !springs.is_empty()
            || !friction.is_empty()
            || !potentials.is_empty()
            || self.names.speeds_name_velocities
            || stated.iter().any(names_motion);
        // After an error in frames or points, velocities are not computed.
        let is_known = !needs_motion || self.reader.errors.is_empty();
        let (mut slips, mut holding, mut values) = (Vec::new(), Vec::new(), Vec::new());
        let (mut closures, mut orientations) = (Vec::new(), Vec::new());
        if !is_known {
            stated.clear();
        } else if needs_motion {
            let mut moving = MechanismMotion::new(&mut self.arena, elements, coordinates);
            let forces = self.spring_forces(&mut moving, elements, springs);
            elements.contacts.rolling = rolling.iter().map(|rolling| rolling.name.text.clone()).collect();
            slips = self.rolling_constraint_equations(&mut moving, elements, rolling);
            let value = |v: &NamedVelocity| (v.symbol, moving.named_component(&mut self.arena, elements, v));
            values = velocities.iter().map(value).collect::<Vec<_>>();
            let mut put = Substitution::new(&values);
            for constraint in &mut stated {
                constraint.equation = put.apply(&mut self.arena, constraint.equation);
            }
            elements.potentials = self.potentials_with_positions(&mut put, potentials);
            let closing = self.closing_joint_equations(&mut moving, &closings);
            stated.extend(closing.equations);
            (holding, closures, orientations) = (closing.reactions, closing.closures, closing.orientations);
            elements.forces.extend(forces);
            self.friction_loads(&mut moving, elements, friction);
        }
        // Equations of joints are no contacts. They come after the constraints of the model file, so `zip` leaves
        // them out.
        for (compared, constraint) in compared.iter_mut().zip(&stated) {
            compared.moved = self.compared_bodies_in_equation(elements, coordinates, constraint.equation);
        }
        elements.contacts.compared = compared;
        let (configuration, motion) = stated.into_iter().partition(|c| self.is_of_configuration(c.equation));
        Connections { velocities, values, configuration, motion, slips, holding, closures, orientations, is_known }
    }

    /// True if an equation contains no rates and no speeds, so that it restricts the configuration and not
    /// velocities.
    fn is_of_configuration(&self, equation: Expr) -> bool {
        let moves = self.names.symbols_of(&[NameKind::Rate, NameKind::Speed]);
        !self.arena.reachable(&[equation]).iter().any(|part| moves.contains(part))
    }

    /// Reports missing sections of a model file. Returns true if the model has speeds, or if
    /// constraints may leave it without speeds.
    fn missing_sections(&mut self, table: &'a DeTable<'a>, joints: &Joints<'a>, coordinates: &[Coordinate]) -> bool {
        let moves = !coordinates.is_empty();
        let empty = |key: &str| {
            self.reader.get(table, key).is_none_or(|v| v.get_ref().as_table().is_some_and(DeTable::is_empty))
        };
        let no_bodies = empty("bodies") && empty("particles");
        let is_told = joints.coordinates().is_empty() && !joints.is_short && empty("coordinates");
        let no_coordinates = is_told && !moves;
        // Constraints may leave no speed: the mechanism then moves as prescribed, or not at all.
        let is_tied = is_told && moves
            || joints.list.iter().any(|joint| !joint.carries)
            || !empty("constraints")
            || !empty("rolling");
        let no_speeds = joints.speeds.is_empty() && !joints.is_short && !is_tied && empty("speeds");
        let mut missing = |message: &str, help: &str| self.reader.errors.push(Diagnostic::of_file(message, help));
        if no_bodies {
            missing("the model has no bodies", "add [bodies.NAME] or [particles.NAME]");
            self.names.mark_unread_kinds(&[NameKind::Body]);
        }
        if no_coordinates {
            let help = "add [coordinates]; a problem without them is statics, which is not derived here";
            missing("the model has no coordinates", help);
        }
        if no_speeds && !no_coordinates {
            missing("the model has no speeds", "add [speeds], such as u1 = \"q1'\"");
        }
        if no_speeds {
            self.names.mark_unread_kinds(&[NameKind::Speed]);
        }
        if !table.contains_key("inertial") {
            missing("the model has no inertial frame", "add [inertial] with frame = \"N\" and origin = \"O\"");
        }
        !no_speeds
    }

    /// Reads the coordinates of the model file, followed by those of its joints. Errors are recorded in the reader.
    fn coordinates(&mut self, table: &'a DeTable<'a>, joints: &Joints<'a>) -> Vec<Coordinate> {
        let mut coordinates = Vec::new();
        for (name, value) in self.section(table, "coordinates", &[NameKind::Coordinate, NameKind::Rate]) {
            let symbol = self.arena.symbol(&name.text);
            let entry = self.entry(&name, value, NameKind::Coordinate, Some(symbol), "{ unit = \"rad\" }");
            let Some((entry, _)) = entry else { continue };
            self.reader.report_unknown_keys(entry, "a coordinate", &["unit", "about"]);
            let unit = self.read_unit_key(entry, &name);
            let about = self.about(entry);
            coordinates.push((name, symbol, unit, about));
        }
        for (name, unit, about) in joints.coordinates() {
            let symbol = self.arena.symbol(&name.text);
            self.names.declare(&mut self.reader, &name, NameKind::Coordinate, Some(symbol));
            coordinates.push((name, symbol, Some(unit), about));
        }
        coordinates
            .into_iter()
            .map(|(name, symbol, unit, about)| {
                let dotted = format!("{}'", name.text);
                let rate = self.arena.symbol(&dotted);
                self.names.insert(&dotted, NameKind::Rate, name.span, Some(rate));
                if let Some(unit) = &unit {
                    self.units.insert(symbol, unit.clone());
                    self.units.insert(rate, unit.per_second());
                }
                let unit = unit.unwrap_or_default();
                Coordinate { name: name.text, symbol, rate, second_rate: rate, unit, about }
            })
            .collect()
    }
}
