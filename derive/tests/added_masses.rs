//! Bodies with added mass. Truth: Kirchhoff's equations, worked by hand, and the agreement of the formulations.

use crate::common::{BASE, read};
use expect_test::expect;
use tripos_derive::Model;
use tripos_derive::algebra::meaning::compare::Comparer;
use tripos_derive::algebra::text::parse::parse_primed;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::{Formulation, derive_all};
use tripos_derive::model::load;
use tripos_derive::prove::prove;

/// Hull in a plane: surge u, sway v and yaw r, with the mass centre at x_G before the origin of the added mass.
const SHIP: &str = r#"
name = "Hull in the horizontal plane"
[parameters]
m = { unit = "kg", value = 10, positive = true }
Iz = { unit = "kg*m^2", value = 2, positive = true }
xG = { unit = "m", value = 0.1 }
Ax = { unit = "kg", value = 1, positive = true }
Ay = { unit = "kg", value = 8, positive = true }
Ayr = { unit = "kg*m", value = 0.5 }
Ar = { unit = "kg*m^2", value = 1, positive = true }
X = { unit = "N", value = 3 }
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
psi = { unit = "rad" }
[speeds]
u = "x'*cos(psi) + y'*sin(psi)"
v = "-x'*sin(psi) + y'*cos(psi)"
r = "psi'"
[inertial]
frame = "N"
origin = "O"
[frames]
B = { from = "N", axis = 3, angle = "psi" }
[points]
Ob = { from = "O", frame = "N", position = ["x", "y", 0] }
G = { from = "Ob", frame = "B", position = ["xG", 0, 0] }
[bodies.hull]
frame = "B"
centre = "G"
mass = "m"
inertia = { diagonal = ["Iz/2", "Iz/2", "Iz"] }
[bodies.hull.added_mass]
about_point = "Ob"
matrix = [
    ["Ax", 0, 0, 0, 0, 0],
    [0, "Ay", 0, 0, 0, "Ayr"],
    [0, 0, 0, 0, 0, 0],
    [0, 0, 0, 0, 0, 0],
    [0, 0, 0, 0, 0, 0],
    [0, "Ayr", 0, 0, 0, "Ar"],
]
[forces.thrust]
on = "hull"
at = "Ob"
frame = "B"
vector = ["X", 0, 0]
"#;

fn ship(edits: &[(&str, &str)]) -> Result<Model, String> {
    let mut text = SHIP.to_owned();
    for (old, new) in edits {
        assert!(text.contains(old), "the model has no `{old}`");
        text = text.replacen(old, new, 1);
    }
    load(&Source::from_text("model.toml", &text)).map_err(|e| e.to_string())
}

/// Truth: T. I. Fossen, Handbook of Marine Craft Hydrodynamics and Motion Control (2011), (6.40) and (6.53), with
/// M = M_RB + M_A and C = C_RB + C_A: the Coriolis terms of a mass m + Ax in surge and m + Ay in sway.
#[test]
fn a_hull_in_a_plane_has_the_equations_of_the_handbook() {
    let model = ship(&[]).unwrap();
    let mut derivations = derive_all(&model).unwrap();
    let kane = derivations.get(Formulation::Kane).unwrap().clone();
    let arena = &mut derivations.kinematics.arena;
    let mut formula = |text: &str| {
        let resolve = &mut |arena: &mut tripos_derive::algebra::Arena, name: &str| {
            arena.find_symbol(name).ok_or_else(|| (format!("no {name}"), None))
        };
        parse_primed(arena, text, 2, resolve).unwrap_or_else(|e| panic!("{text}: {}", e.message))
    };
    let matrix = [["m + Ax", "0", "0"], ["0", "m + Ay", "m*xG + Ayr"], ["0", "m*xG + Ayr", "Iz + m*xG^2 + Ar"]]
        .map(|row| row.map(&mut formula));
    let forcing =
        ["X + (m + Ay)*v*r + (m*xG + Ayr)*r^2", "-(m + Ax)*u*r", "-(m*xG + Ayr)*u*r - (Ay - Ax)*u*v"].map(formula);
    let mut comparer = Comparer::default();
    for (i, row) in matrix.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            assert!(comparer.compare(arena, kane.matrix[i][j], *entry).is_equal(), "M[{i}, {j}]");
        }
        assert!(comparer.compare(arena, kane.forcing[i], forcing[i]).is_equal(), "f[{i}]");
    }
}

/// Goal: the principles agree, with every block of the added mass, and a reaction beside it. Method: a free body
/// with a full matrix about another point, and a body on a pin.
#[test]
fn the_formulations_agree() {
    let full = "[\n".to_owned()
        + &(0..6)
            .map(|i| {
                let row = (0..6).map(|j| format!("\"a{}{}\"", i.min(j) + 1, i.max(j) + 1)).collect::<Vec<_>>();
                format!("    [{}],\n", row.join(", "))
            })
            .collect::<Vec<_>>()
            .concat()
        + "]";
    let letters: String = (1..=6)
        .flat_map(|i| (i..=6).map(move |j| (i, j)))
        .map(|(i, j)| {
            let unit = ["kg", "kg*m", "kg*m^2"][usize::from(i > 3) + usize::from(j > 3)];
            format!("a{i}{j} = {{ unit = \"{unit}\", value = {} }}\n", if i == j { 4 } else { 0 })
        })
        .collect::<Vec<_>>()
        .concat();
    let free = format!(
        r#"
name = "Vehicle in six degrees of freedom"
[parameters]
m = {{ unit = "kg", value = 3, positive = true }}
I1 = {{ unit = "kg*m^2", value = 1, positive = true }}
I2 = {{ unit = "kg*m^2", value = 1, positive = true }}
I3 = {{ unit = "kg*m^2", value = 1, positive = true }}
{letters}
[inertial]
frame = "N"
origin = "O"
[bodies.vehicle]
frame = "B"
mass = "m"
inertia = {{ diagonal = ["I1", "I2", "I3"] }}
added_mass = {{ matrix = {full} }}
[joints.sea]
kind = "free"
body = "vehicle"
sequence = "321"
coordinates = ["x", "y", "z", "psi", "theta", "phi"]
speeds = ["u", "v", "w", "p", "q", "r"]
"#
    );
    let free = load(&Source::from_text("model.toml", &free)).unwrap_or_else(|e| panic!("{e}"));
    for model in [ship(&[]).unwrap(), free] {
        let mut derivations = derive_all(&model).unwrap();
        derivations.add(&model, Formulation::GibbsAppell).unwrap();
        for formulation in Formulation::ALL {
            assert!(derivations.get(formulation).is_some(), "{}: {formulation:?}", model.title);
        }
        let proof = prove(&model, &mut derivations);
        assert_eq!(proof.pairs.len(), 6, "{}", model.title);
        for pair in &proof.pairs {
            assert!(pair.verdict.is_equal(), "{}: {:?} {:?}: {:?}", model.title, pair.left, pair.right, pair.verdict);
        }
    }
}

#[test]
fn wrong_added_masses_are_refused() {
    let refused = |edits: &[(&str, &str)]| {
        let Err(error) = ship(edits) else { panic!("this must not be accepted: {edits:?}") };
        error.lines().filter(|l| l.starts_with("error") || l.starts_with("help")).collect::<Vec<_>>().join("\n")
    };
    expect![[r"
        error: the added mass is not symmetric: entries 6, 2 and 2, 6 differ
        error: entry 1, 1 of an added mass must be in kg, but `Ar` is in kg*m^2
        error: a row of an added mass has 5 entries for 6
        error: the added mass cannot be moved to the mass centre
        error: unknown key `abuot_point` in an added mass
        error: the added mass of `hull` gives motions a negative kinetic energy at the default values
        error: `matrix` beside `diagonal`"]]
    .assert_eq(
        &[
            refused(&[("[0, \"Ayr\", 0, 0, 0, \"Ar\"]", "[0, \"2*Ayr\", 0, 0, 0, \"Ar\"]")]),
            refused(&[("\"Ax\", 0, 0, 0, 0, 0", "\"Ar\", 0, 0, 0, 0, 0")]),
            refused(&[("\"Ax\", 0, 0, 0, 0, 0", "\"Ax\", 0, 0, 0, 0")]),
            refused(&[("about_point = \"Ob\"", "about_point = \"O\"")]),
            refused(&[("about_point = \"Ob\"", "abuot_point = \"Ob\"")]),
            refused(&[("Ayr = { unit = \"kg*m\", value = 0.5 }", "Ayr = { unit = \"kg*m\", value = 50 }")]),
            refused(&[("about_point = \"Ob\"", "about_point = \"Ob\"\ndiagonal = [1, 1, 1, 1, 1, 1]")]),
        ]
        .join("\n"),
    );
    assert!(read(BASE).is_ok_and(|model| model.added_masses.is_empty()));
}

/// Goal: a number with a unit that stands on both sides of the diagonal is one parameter. Method: the ship with the
/// number 0.5 kg m twice, and with two numbers that differ.
#[test]
fn equal_numbers_beside_the_diagonal_are_one() {
    let with = |second: &str| {
        ship(&[
            ("[0, \"Ay\", 0, 0, 0, \"Ayr\"]", "[0, \"Ay\", 0, 0, 0, \"0.5 kg*m\"]"),
            ("[0, \"Ayr\", 0, 0, 0, \"Ar\"]", second),
        ])
    };
    let model = with("[0, \"0.5 kg*m\", 0, 0, 0, \"Ar\"]").unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(model.parameters.iter().filter(|p| p.unit.unit_words() == "kg*m").count(), 2, "it, and Ayr");
    let Err(error) = with("[0, \"0.6 kg*m\", 0, 0, 0, \"Ar\"]") else { panic!("this must not be accepted") };
    assert!(error.contains("entries 6, 2 and 2, 6 differ"), "{error}");
}
