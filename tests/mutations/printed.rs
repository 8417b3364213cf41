//! The derived equations of a model, as if somebody had printed them.

use super::tree::tree;
use std::path::Path;
use tripos_derive::algebra::solve::linear::LinearForm;
use tripos_derive::algebra::text::display_tree::DisplayTree;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{Derivations, Quantities, Quantity, derive_all, newton_euler_balances};
use tripos_derive::model::Unit;
use tripos_derive::{Formulation, Model};

/// A linear system: rows of entries, the right-hand side last.
pub struct System {
    pub formulation: Formulation,
    /// The frame of the components: for Newton–Euler.
    pub frame: Option<String>,
    pub unknowns: Vec<String>,
    pub rows: Vec<Vec<DisplayTree>>,
    /// The same rows as terms of the arena of [`Printed::derivations`].
    pub terms: Vec<Vec<Expr>>,
}

/// Formulas of a publication about a model, all of them right.
pub struct Printed {
    pub model: Model,
    pub derivations: Derivations,
    /// Named quantities that are more than a number, each value once.
    pub equations: Vec<(String, DisplayTree)>,
    pub systems: Vec<System>,
    /// Names of one kind: coordinates, speeds, parameters of one unit, …
    pub families: Vec<Vec<String>>,
    /// Coordinates that are angles.
    pub angles: Vec<String>,
}

/// The folder of a model of this workspace.
pub fn read(model: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(model).join("model.toml");
    Model::read(&path).unwrap_or_else(|errors| panic!("{errors}"))
}

impl Printed {
    /// Derives a model of this workspace and prints it.
    pub fn new(model: &str) -> Self {
        let model = read(model);
        let mut derivations = derive_all(&model).unwrap_or_else(|e| panic!("{}", model.diagnose(&e)));
        let equations = equations(&model, &mut derivations);
        let systems = systems(&model, &mut derivations);
        let (families, angles) = (families(&model), angles(&model));
        Self { model, derivations, equations, systems, families, angles }
    }

    /// Parameters that are stated to be positive.
    pub fn positive(&self) -> Vec<String> {
        self.model.parameters.iter().filter(|p| p.positive).map(|p| p.name.clone()).collect()
    }
}

/// Quantities of every kind that docs/publication.md lists.
fn equations(model: &Model, derivations: &mut Derivations) -> Vec<(String, DisplayTree)> {
    let mut quantities = Quantities::new(model, derivations);
    let mut found: Vec<(Expr, String)> = Vec::new();
    for name in names(model) {
        let quantity = Quantity::parse(&name, model).unwrap_or_else(|e| panic!("{name}: {e:?}"));
        let value = quantities.value(&quantity).unwrap_or_else(|e| panic!("{name}: {e}"));
        let is_number = quantities.derivations.kinematics.arena.as_number(value).is_some();
        if !is_number && found.iter().all(|(known, _)| *known != value) {
            found.push((value, name));
        }
    }
    let arena = &quantities.derivations.kinematics.arena;
    found.into_iter().map(|(value, name)| (name, tree(arena, value))).collect()
}

fn names(model: &Model) -> Vec<String> {
    let mut names = Vec::new();
    let inertial = model.frames[0].name.as_str();
    let axes = |names: &mut Vec<String>, vectors: &[&str], of: &str, frame: &str, end: &str| {
        for vector in vectors {
            names.extend((1..=3).map(|axis| format!("{vector}({of}) @ {frame} [{axis}]{end}")));
        }
    };
    for point in &model.points {
        let own = point.position.map_or(inertial, |placement| model.frames[placement.frame].name.as_str());
        for frame in [inertial, own] {
            axes(&mut names, &["p", "v", "a"], &point.name, frame, "");
        }
        for speed in &model.speeds {
            axes(&mut names, &["d v"], &point.name, own, &format!("/d {}", speed.name));
        }
    }
    for frame in &model.frames[1..] {
        axes(&mut names, &["omega", "alpha"], &frame.name, &frame.name, "");
        let entries = (1..=3).flat_map(|i| (1..=3).map(move |j| (i, j)));
        names.extend(entries.map(|(i, j)| format!("rotation({inertial}, {}) [{i},{j}]", frame.name)));
    }
    for body in &model.bodies {
        let rigid = body.rigid.as_ref().map(|(own, inertia)| (&model.frames[*own], &model.frames[inertia.frame]));
        let frame = rigid.map_or(inertial, |(_, stated)| stated.name.as_str());
        axes(&mut names, &["pdot", "Rstar", "weight", "force"], &body.name, frame, "");
        if let Some((own, _)) = rigid {
            axes(&mut names, &["H", "Hdot", "Tstar", "moment"], &body.name, frame, "");
            names.extend((1..=3).map(|i| format!("I({}) @ {} [{i},{i}]", body.name, own.name)));
        }
    }
    let n = model.speeds.len();
    for i in 1..=n {
        names.extend(["F", "Fstar", "f", "A"].map(|row| format!("{row}[{i}]")));
        names.extend((1..=n).flat_map(|j| [format!("M[{i},{j}]"), format!("E[{i},{j}]")]));
    }
    names.extend(["T", "T_translation", "T_rotation", "V", "L", "energy"].map(str::to_owned));
    names.extend(model.speeds.iter().map(|s| s.name.clone()));
    names.extend(model.coordinates.iter().map(|c| format!("{}'", c.name)));
    names
}

fn systems(model: &Model, derivations: &mut Derivations) -> Vec<System> {
    let mut list = Vec::new();
    for formulation in Formulation::ALL {
        let Some(equations) = derivations.get(formulation) else { continue };
        let unknowns = equations.unknowns.clone();
        let (frame, terms) = if formulation == Formulation::NewtonEuler {
            let frame = model.bodies.iter().find_map(|b| b.rigid.as_ref()).map_or(0, |(_, inertia)| inertia.frame);
            (Some(model.frames[frame].name.clone()), balance_rows(model, derivations, frame, &unknowns))
        } else {
            let rows = equations.matrix.iter().zip(&equations.forcing);
            (None, rows.map(|(row, right)| [row.as_slice(), &[*right]].concat()).collect())
        };
        let arena = &derivations.kinematics.arena;
        let unknowns = unknowns.iter().map(|u| arena.symbol_name(*u).expect("a symbol").to_owned()).collect();
        let row = |row: &Vec<Expr>| row.iter().map(|e| tree(arena, *e)).collect();
        list.push(System { formulation, frame, unknowns, rows: terms.iter().map(row).collect(), terms });
    }
    list
}

/// Newton's and Euler's equations with components in one frame, solved for nothing.
fn balance_rows(model: &Model, derivations: &mut Derivations, frame: usize, unknowns: &[Expr]) -> Vec<Vec<Expr>> {
    let kinematics = &mut derivations.kinematics;
    let velocities = kinematics.in_speeds(model);
    let mut form = LinearForm::new(unknowns);
    let mut rows = Vec::new();
    for balance in newton_euler_balances(model, kinematics, &velocities, Some(frame)) {
        let arena = &mut kinematics.arena;
        let (mut row, rest) = form.coefficients(arena, balance.residual).expect("balances are linear");
        row.push(arena.neg(rest));
        let simplifier = &mut kinematics.simplifier;
        let row: Vec<Expr> = row.into_iter().map(|e| simplifier.simplify(arena, e)).collect();
        if row.iter().any(|e| *e != Expr::ZERO) {
            rows.push(row);
        }
    }
    rows
}

fn families(model: &Model) -> Vec<Vec<String>> {
    let named = |arena: &Arena, list: Vec<Expr>| -> Vec<String> {
        list.into_iter().filter_map(|e| arena.symbol_name(e)).map(str::to_owned).collect()
    };
    let arena = &model.arena;
    let mut families = vec![
        named(arena, model.q()),
        named(arena, model.q_dot()),
        named(arena, model.u()),
        named(arena, model.speeds.iter().map(|s| s.rate).collect()),
        named(arena, model.coordinates.iter().map(|c| c.second_rate).collect()),
        model.reactions.iter().map(|r| r.name.clone()).collect(),
    ];
    for parameter in &model.parameters {
        let alike = model.parameters.iter().filter(|p| p.unit == parameter.unit);
        let family: Vec<String> = alike.map(|p| p.name.clone()).collect();
        if !families.contains(&family) {
            families.push(family);
        }
    }
    families.retain(|family| family.len() > 1);
    families
}

fn angles(model: &Model) -> Vec<String> {
    model.coordinates.iter().filter(|c| c.unit == Unit::default()).map(|c| c.name.clone()).collect()
}
