//! Statements that `prove` proves, and false ones that it does not.

use tripos_derive::algebra::Arena;
use tripos_derive::algebra::meaning::compare::{Engine, Verdict};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::{Derivations, derive_all};
use tripos_derive::prove::{IntegralKind, Proof, prove};
use tripos_derive::{Equations, Formulation, Model, model};

fn read(path: &str) -> Model {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path);
    Model::read(&path).unwrap()
}

fn proof_of(path: &str) -> (Derivations, Proof) {
    let model = read(path);
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    (derivations, proof)
}

const MODELS: [&str; 13] = [
    "models/disk/model.toml",
    "models/cart_pendulum_3/model.toml",
    "models/chaotic_pendulum/model.toml",
    "models/heavy_top/model.toml",
    "models/pendulum/model.toml",
    "derive/tests/models/dragged_disk.toml",
    "derive/tests/models/free_body.toml",
    "derive/tests/models/k01.toml",
    "derive/tests/models/k02.toml",
    "derive/tests/models/k06a.toml",
    "derive/tests/models/k06b.toml",
    "derive/tests/models/k11.toml",
    "derive/tests/models/k17a.toml",
];

#[test]
fn every_model_is_proved_by_the_normal_form() {
    for path in MODELS {
        let (_, proof) = proof_of(path);
        assert_eq!(proof.pairs.len(), if proof.missing.is_empty() { 3 } else { 1 }, "{path}");
        for pair in &proof.pairs {
            assert_eq!(pair.verdict, Verdict::Equal(Engine::NormalForm), "{path}: {:?}", (pair.left, pair.right));
        }
        for integral in &proof.integrals {
            assert_eq!(integral.verdict, Verdict::Equal(Engine::NormalForm), "{path}: {:?}", integral.kinds);
        }
    }
}

#[test]
fn the_disk_has_its_six_integrals() {
    let (derivations, proof) = proof_of("models/disk/model.toml");
    let model = read("models/disk/model.toml");
    let names = proof.integrals.iter().map(|i| i.full_name(&model, &derivations.kinematics.arena));
    assert_eq!(
        names.collect::<Vec<_>>(),
        [
            "energy T + V",
            "momentum p_q3 = ∂L/∂q3'",
            "momentum p_q4 = ∂L/∂q4' (also linear momentum along a1)",
            "momentum p_q5 = ∂L/∂q5' (also linear momentum along a2)",
            "angular momentum about a3 through the mass centre",
            "angular momentum about a3 through O",
        ]
    );
    let arena = &derivations.kinematics.arena;
    // H·a3 with H = M R²/4 (u1, u2, 2 u3) and a3 = cos q2 b2 + sin q2 b3.
    assert_eq!(print_text(arena, proof.integrals[4].expression), "M*R^2*(u2*cos(q2) + 2*u3*sin(q2))/4");
    assert_eq!(print_text(arena, proof.integrals[1].expression), "M*R^2*u3/2");
    // Vertical balance of the mass centre, whose height is R cos q2: N = M (g + d²/dt² R cos q2), u1 = −q2'.
    assert_eq!(print_text(arena, proof.reactions[0].value), "M*(g + R*(u1'*sin(q2) - u1^2*cos(q2)))");
    assert_eq!(proof.singular_where.iter().map(|e| print_text(arena, *e)).collect::<Vec<_>>(), ["cos(q2)"]);
}

#[test]
fn a_free_body_keeps_energy_and_both_momenta() {
    let (_, proof) = proof_of("derive/tests/models/free_body.toml");
    // Weightless: energy, momentum and angular momentum, and the angular momentum about O, of which one
    // component follows from the rest.
    assert_eq!(proof.integrals.len(), 9, "{:?}", proof.integrals.iter().map(|i| &i.kinds).collect::<Vec<_>>());
}

/// Damped or driven motion keeps no energy, and nothing is claimed.
#[test]
fn nothing_is_conserved_where_a_force_works() {
    for path in ["derive/tests/models/k01.toml", "derive/tests/models/k17a.toml"] {
        let (_, proof) = proof_of(path);
        assert!(
            proof.integrals.is_empty(),
            "{path}: {:?}",
            proof.integrals.iter().map(|i| &i.kinds).collect::<Vec<_>>()
        );
    }
}

/// A bead on a line, drawn by a spring to the origin, with a constant force: x'' = −k/m x + F/m.
const BEAD: &str = r#"
name = "Bead"
[parameters]
m = { unit = "kg", positive = true }
k = { unit = "N/m", positive = true }
F = { unit = "N" }
[coordinates]
x = { unit = "m" }
[speeds]
u = "x'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", 0, 0] }
[particles]
bead = { point = "P", mass = "m" }
[forces.spring]
on = "bead"
frame = "N"
vector = ["F - k*x", 0, 0]
"#;

#[test]
fn forces_with_a_potential_join_the_energy() {
    let model = model::load(&Source::from_text("bead.toml", BEAD)).unwrap();
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    let arena = &derivations.kinematics.arena;
    assert_eq!(print_text(arena, proof.integrals[0].expression), "k*x^2/2 - F*x + m*u^2/2");
    assert!(proof.integrals[0].verdict.is_equal());
}

/// A symmetry with a coefficient that depends on a parameter: of two particles joined by a spring along a
/// line, x1' = 1, x2' = 1; and with x2 measured in another length, x2' = 1/s.
#[test]
fn affine_symmetries_are_found_over_the_field_of_the_parameters() {
    let text_of = r#"
name = "Two beads"
[parameters]
m = { unit = "kg", positive = true }
k = { unit = "N/m", positive = true }
s = { unit = "1", positive = true }
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
[speeds]
u = "x'"
v = "y'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", 0, 0] }
Q = { from = "O", frame = "N", position = ["s*y", 0, 0] }
[particles]
left = { point = "P", mass = "m" }
right = { point = "Q", mass = "m" }
[forces.spring]
on = "left"
against = "right"
frame = "N"
vector = ["k*(s*y - x)", 0, 0]
"#;
    let model = model::load(&Source::from_text("beads.toml", text_of)).unwrap();
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    assert!(proof.search.covered.contains("1 of them"), "{}", proof.search.covered);
    let momentum = proof.integrals.iter().find(|i| i.kinds.contains(&IntegralKind::Linear(0))).unwrap();
    assert_eq!(print_text(&derivations.kinematics.arena, momentum.expression), "m*(u + s*v)");
}

fn change(derivations: &mut Derivations, formulation: Formulation, edit: impl Fn(&mut Arena, &mut Equations)) {
    let arena = &mut derivations.kinematics.arena;
    for (f, equations) in &mut derivations.list {
        if *f == formulation
            && let Ok(equations) = equations
        {
            edit(arena, equations);
        }
    }
}

/// Goal: a proof must be able to fail. Method: one sign changed in one row of one formulation.
#[test]
fn equations_that_differ_in_a_sign_are_not_proved() {
    let model = read("models/disk/model.toml");
    for formulation in Formulation::ALL {
        let mut derivations = derive_all(&model).unwrap();
        derivations.add(&model, Formulation::GibbsAppell).unwrap();
        change(&mut derivations, formulation, |arena, e| e.forcing[1] = arena.neg(e.forcing[1]));
        let proof = prove(&model, &mut derivations);
        for pair in &proof.pairs {
            let touched = pair.left == formulation || pair.right == formulation;
            assert_eq!(pair.verdict.is_equal(), !touched, "{formulation:?}: {:?}", (pair.left, pair.right));
            if let Verdict::Different(witness) = &pair.verdict {
                assert!((witness.left - witness.right).abs() > 1e-9, "{witness:?}");
            }
        }
    }
}

/// Integrals are proved along the equations as they are: a wrong force in Kane's equations breaks the energy.
#[test]
fn an_integral_of_other_equations_is_not_proved() {
    let model = read("models/disk/model.toml");
    let mut derivations = derive_all(&model).unwrap();
    change(&mut derivations, Formulation::Kane, |arena, e| {
        let twice = arena.scale(e.forcing[0], &tripos_derive::algebra::Rational::integer(2));
        e.forcing[0] = twice;
    });
    let proof = prove(&model, &mut derivations);
    let kept: Vec<_> = proof.integrals.iter().flat_map(|i| i.kinds.clone()).collect();
    assert!(!kept.contains(&IntegralKind::Energy), "{kept:?}");
    assert!(kept.contains(&IntegralKind::Coordinate(2)), "its equation is untouched");
    assert!(!proof.pairs[0].verdict.is_equal());
}

/// Three momenta are independent, and the energy, which is a function of them, is listed all the same. A force that
/// acts on one side only, through |x| and |v|, takes energy out of it: random signs must not hide that.
#[test]
fn a_free_particle_keeps_three_momenta_and_one_sided_forces_take_their_share() {
    let free = BEAD
        .replace("x = { unit = \"m\" }", "x = { unit = \"m\" }\ny = { unit = \"m\" }\nz = { unit = \"m\" }")
        .replace("u = \"x'\"", "u = \"x'\"\nv = \"y'\"\nw = \"z'\"")
        .replace("[\"x\", 0, 0] }", "[\"x\", \"y\", \"z\"] }");
    let integrals = |force: &str| {
        let text = free.replace("F - k*x", force);
        let model = model::load(&Source::from_text("particle.toml", &text)).unwrap_or_else(|e| panic!("{e}"));
        let mut derivations = derive_all(&model).unwrap();
        prove(&model, &mut derivations).integrals.into_iter().flat_map(|i| i.kinds).collect::<Vec<_>>()
    };
    let free = integrals("0*F");
    for at in 0..3 {
        assert!(free.contains(&IntegralKind::Coordinate(at)), "{at}: {free:?}");
    }
    assert!(free.contains(&IntegralKind::Energy), "{free:?}");
    let sided = integrals("F*(abs(x)/x-1)*(abs(u)/u-1)");
    assert!(!sided.iter().any(|kind| kind.is_energy() || *kind == IntegralKind::Coordinate(0)), "{sided:?}");
    assert!(sided.contains(&IntegralKind::Coordinate(1)), "{sided:?}");
}

/// A bob on a rod without mass, whose force nobody named: it lies along no axis of a frame, and is found.
#[test]
fn a_force_along_no_axis_is_found_and_proved() {
    let swing = BEAD
        .replace("x = { unit = \"m\" }", "x = { unit = \"rad\" }")
        .replace("[\"x\", 0, 0] }", "[\"L*cos(x)\", \"L*sin(x)\", 0] }")
        .replace("[parameters]", "[parameters]\nL = { unit = \"m\", value = 1, positive = true }")
        .replace("F - k*x", "F - k*L*x");
    let model = model::load(&Source::from_text("swing.toml", &swing)).unwrap_or_else(|e| panic!("{e}"));
    let proof = prove(&model, &mut derive_all(&model).unwrap());
    assert!(proof.missing.is_empty() && proof.pairs.len() == 3 && proof.is_equivalent());
}

/// Thirteen rods that hang on one another are more bodies than reactions are found for, so all missing reactions are
/// counted at once: three equations for each body in the plane, less one for each angle.
#[test]
fn missing_reactions_are_counted_at_once() {
    const COUNT: usize = 13;
    let section = |name: &str, entry: &dyn Fn(usize) -> String| {
        let entries: String = (1..=COUNT).map(|at| entry(at) + "\n").collect();
        format!("[{name}]\n{entries}")
    };
    let before =
        |at: usize, first: &str, name: &str| if at == 1 { first.to_owned() } else { format!("{name}{}", at - 1) };
    let text = [
        "name = \"Rods\"\n[parameters]\nm = { unit = \"kg\", value = 1 }\nl = { unit = \"m\", value = 1 }\n".to_owned(),
        section("coordinates", &|at| format!("q{at} = {{ unit = \"rad\" }}")),
        section("speeds", &|at| format!("u{at} = \"q{at}'\"")),
        "[inertial]\nframe = \"N\"\norigin = \"O\"\n".to_owned(),
        section("frames", &|at| format!("B{at} = {{ from = \"N\", axis = 3, angle = \"q{at}\" }}")),
        section("points", &|at| {
            let hangs = before(at, "O", "P");
            format!("P{at} = {{ from = \"{hangs}\", frame = \"B{at}\", position = [\"l\", 0, 0] }}")
        }),
        section("bodies", &|at| {
            format!("rod{at} = {{ frame = \"B{at}\", centre = \"P{at}\", mass = \"m\", inertia = \"m*l^2/12\" }}")
        }),
    ];
    let model = model::load(&Source::from_text("rods.toml", &text.concat())).unwrap_or_else(|e| panic!("{e}"));
    let proof = prove(&model, &mut derive_all(&model).unwrap());
    let (formulation, why) = &proof.missing[0];
    assert_eq!(*formulation, Formulation::NewtonEuler);
    let said = why.to_string();
    assert!(said.contains("26 reactions are needed"), "{said}");
}

/// Nothing is proved where there is nothing to compare.
#[test]
fn one_formulation_alone_is_not_proved_equivalent() {
    let (_, mut proof) = proof_of("models/disk/model.toml");
    assert!(proof.is_equivalent());
    proof.pairs.clear();
    assert!(!proof.is_equivalent());
}
