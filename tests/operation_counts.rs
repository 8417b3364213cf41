//! Cost of the generated functions: bounds for each model, as their headers state the counts.

use std::path::Path;
use tripos_codegen::plan::{FormulationPlan, Jacobian, Language, Planner, Sharing};
use tripos_derive::identify::BaseEquations;
use tripos_derive::mechanics::{Derivation, SolvedAccelerations};
use tripos_derive::{Formulation, Model, derive};

/// (model, formulation, operations of `mass_matrix`, `forcing`, `accelerations`, `derivative`). A count may fall; one
/// that grows is a defect of the simplifier, of the elimination or of the sharing.
const BOUNDS: [(&str, &str, [usize; 4]); 27] = [
    ("cart_pendulum_3", "kane", [30, 45, 126, 126]),
    ("cart_pendulum_3", "lagrange", [30, 45, 126, 126]),
    ("cart_pendulum_3", "newton_euler", [36, 30, 135, 135]),
    ("chaotic_pendulum", "kane", [11, 14, 26, 26]),
    ("chaotic_pendulum", "lagrange", [11, 14, 26, 26]),
    ("chaotic_pendulum", "newton_euler", [18, 27, 22, 22]),
    ("disk", "kane", [18, 36, 39, 41]),
    ("disk", "lagrange", [18, 35, 39, 39]),
    ("disk", "newton_euler", [18, 27, 39, 41]),
    ("euler_top", "kane", [0, 11, 13, 14]),
    ("euler_top", "lagrange", [5, 19, 20, 20]),
    ("euler_top", "newton_euler", [22, 25, 13, 14]),
    ("floating_chain", "kane", [32, 45, 128, 128]),
    ("floating_chain", "lagrange", [32, 45, 128, 128]),
    ("floating_chain", "newton_euler", [50, 26, 128, 128]),
    ("free_body", "kane", [0, 8, 8, 9]),
    ("free_body", "lagrange", [5, 16, 14, 14]),
    ("free_body", "newton_euler", [10, 8, 8, 9]),
    ("heavy_top", "kane", [0, 14, 16, 17]),
    ("heavy_top", "lagrange", [5, 23, 25, 25]),
    ("heavy_top", "newton_euler", [23, 27, 16, 17]),
    ("pendulum", "kane", [2, 4, 3, 3]),
    ("pendulum", "lagrange", [2, 4, 3, 3]),
    ("pendulum", "newton_euler", [5, 8, 3, 3]),
    ("spherical_pendulum", "kane", [2, 11, 8, 8]),
    ("spherical_pendulum", "lagrange", [4, 11, 9, 9]),
    ("spherical_pendulum", "newton_euler", [11, 20, 8, 8]),
];

/// (model, scene, operations of `derivative`) of the reduced equations of scenes.
const SCENES: [(&str, &str, usize); 8] = [
    ("cart_pendulum_3", "fall", 129),
    ("disk", "lean", 18),
    ("disk", "flat_fall", 23),
    ("euler_top", "cusps", 19),
    ("floating_chain", "folding", 295),
    ("free_body", "steady", 14),
    ("heavy_top", "looping", 16),
    ("spherical_pendulum", "narrow", 7),
];

fn count(text: &str, function: &str) -> usize {
    let signature = format!("pub fn {function}<");
    let before = text.split(&signature).next().unwrap_or_default();
    let line =
        before.lines().rev().find(|line| line.starts_with("/// ") && line.contains(" operation")).unwrap_or_default();
    line.split_whitespace().nth(1).and_then(|n| n.parse().ok()).unwrap_or_else(|| panic!("{function} states no count"))
}

/// The file that has a function of a formulation: its own, or that of the one whose function it shares.
fn text_of(model: &str, formulation: &str, function: &str) -> String {
    let code = Path::new(env!("CARGO_MANIFEST_DIR")).join("generated/src").join(model).join("code");
    let own = std::fs::read_to_string(code.join(format!("{formulation}.rs"))).unwrap();
    if own.contains(&format!("pub fn {function}<")) {
        return own;
    }
    // `pub use super::kane::{accelerations, …};`, on one line or several.
    let imports = own.split("pub use super::").skip(1).map(|rest| rest.split(';').next().unwrap_or_default());
    let from = imports.filter(|import| import.split(|c: char| !c.is_alphanumeric() && c != '_').any(|w| w == function));
    let from = from.map(|import| import.split("::").next().unwrap_or_default()).next();
    let from = from.unwrap_or_else(|| panic!("{model}/{formulation} has no {function}"));
    std::fs::read_to_string(code.join(format!("{from}.rs"))).unwrap()
}

#[test]
fn equations_of_scenes_keep_within_their_counts() {
    let at = |file: String| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("generated/src").join(file);
        std::fs::read_to_string(path).unwrap()
    };
    for (model, scene, bound) in SCENES {
        let found = count(&at(format!("{model}/scenes/code/{scene}.rs")), "derivative");
        println!("{model} {scene} {found}");
        assert!(found <= bound, "{model}, {scene}: {found} operations, more than {bound}");
    }
    // The scene that asks for the lean alone needs less than half of the equations.
    let (lean, full) = (at("disk/scenes/code/lean.rs".to_owned()), at("disk/code/kane.rs".to_owned()));
    let (lean, full) = (count(&lean, "derivative"), count(&full, "derivative"));
    assert!(100 * lean <= 45 * full, "{lean} of {full} operations");
}

#[test]
fn generated_functions_keep_within_their_counts() {
    for (model, formulation, bounds) in BOUNDS {
        let names = ["mass_matrix", "forcing", "accelerations", "derivative"];
        let counts = names.map(|name| count(&text_of(model, formulation, name), name));
        println!("{model} {formulation} {counts:?}");
        for ((name, count), bound) in names.iter().zip(counts).zip(bounds) {
            assert!(count <= bound, "{model}, {formulation}: {name} has {count} operations, more than {bound}");
        }
    }
}

/// (model, formulation, operations of `linear_system`): matrix and forcing at once, where that is worth it.
const TOGETHER: [(&str, &str, usize); 5] = [
    ("whipple_bicycle", "kane", 1708),
    ("whipple_bicycle", "newton_euler", 1633),
    ("squeezer", "kane", 440),
    ("squeezer", "lagrange", 221),
    ("bricard", "kane", 1705),
];

/// Goal: what is computed at once costs less than apart. Method: the headers of the three functions.
#[test]
fn matrices_and_forcings_share_what_they_have_in_common() {
    for (model, formulation, bound) in TOGETHER {
        let of = |name: &str| count(&text_of(model, formulation, name), name);
        let (together, apart) = (of("linear_system"), of("mass_matrix") + of("forcing"));
        println!("{model} {formulation} {together} of {apart}");
        assert!(together <= bound, "{model}, {formulation}: {together} operations, more than {bound}");
        assert!(10 * together <= 9 * apart, "{model}, {formulation}: {together} of {apart} operations");
    }
}

/// Goal: an arm with full inertias takes no more operations than generators made for arms need. Work of parameters
/// alone, done once for all states, is counted apart. Method: the planned functions of six joints, with six numbers of
/// inertia and offsets in three directions at each. General counts of recursive Newton–Euler: 92 n − 127
/// multiplications and 81 n − 117 additions, 794 for six joints (W. Khalil & E. Dombre, *Modeling, Identification and
/// Control of Robots* (2002), ch. 9).
#[test]
fn an_arm_of_six_joints_takes_what_generators_made_for_arms_need() {
    let model = Model::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/models/arm6.toml")).unwrap();
    let Derivation { mut arena, equations } = derive(&model, Formulation::Kane).unwrap();
    let equations = equations.with_definitions(&mut arena);
    let solved = SolvedAccelerations::new(&mut arena, &equations).unwrap();
    let equations = equations.with_certified_inverse_dynamics(&mut arena).unwrap();
    let planner = Planner::new(&model, &arena, &equations, &Language::NONE, Sharing::Shared);
    let plan = FormulationPlan::new(&planner, Some(&solved), Jacobian::Planned, None);
    let of = |name: &str| {
        let found = plan.equations.iter().chain(&plan.machine).find(|function| function.name == name).unwrap();
        let (all, fixed) = (found.cost.operations, found.cost_of_parameters().operations);
        println!("{name}: {all} operations, {fixed} of parameters alone");
        all - fixed
    };
    assert!(of("mass_matrix") + of("forcing") <= 1280);
    assert!(of("accelerations") <= 1438);
    assert!(of("inverse_dynamics") <= 783);
}

/// (model file, operations of `inverse_dynamics`, `mass_matrix`, `accelerations` in base parameters).
const IN_BASE_PARAMETERS: [(&str, [usize; 3]); 3] = [
    ("models/puma560/model.toml", [328, 176, 606]),
    ("benches/models/rx90.toml", [465, 252, 851]),
    ("benches/models/rx90_symmetric.toml", [251, 167, 536]),
];

/// Goal: equations of arms in base parameters take no more operations than those of other generators: OpenSYMORO's
/// inverse dynamics take 349 for the PUMA 560, 513 for the RX-90, and 270 with symmetric links, as counted in its code.
/// Method: the planned functions; a count may fall.
#[test]
fn arms_in_base_parameters_take_fewer_operations_than_those_of_other_generators() {
    for (file, bounds) in IN_BASE_PARAMETERS {
        let model = Model::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap();
        let BaseEquations { model, derivation, .. } = BaseEquations::new(&model).unwrap();
        let Derivation { mut arena, equations } = derivation;
        let equations = equations.with_definitions(&mut arena);
        let solved = SolvedAccelerations::new(&mut arena, &equations).unwrap();
        let planner = Planner::new(&model, &arena, &equations, &Language::NONE, Sharing::Shared);
        let plan = FormulationPlan::new(&planner, Some(&solved), Jacobian::Planned, None);
        for (name, bound) in ["inverse_dynamics", "mass_matrix", "accelerations"].into_iter().zip(bounds) {
            let mut functions = plan.equations.iter().chain(&plan.machine);
            let count = functions.find(|function| function.name == name).unwrap().cost.operations;
            println!("{file} {name} {count}");
            assert!(count <= bound, "{file}: {name} has {count} operations, more than {bound}");
        }
    }
}
