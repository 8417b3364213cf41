//! Reactions as outputs of a scene's reduced equations, where a division on the way to them would be by zero.

use tripos::{Mechanism, Overrides, Scene};
use tripos_derive::diagnostic::Source;

/// A cart with two rods that hang from it, the lower one on a pin along the upper one's axis AXIS.
const MODEL: &str = r#"
name = "Cart with rods"
parameters.M = { unit = "kg", value = 2, positive = true }
parameters.m = { unit = "kg", value = 0.5, positive = true }
parameters.l = { unit = "m", value = 0.6, positive = true }
parameters.g = { unit = "m/s^2", value = 9.81, positive = true }
inertial = { frame = "N", origin = "O" }
bodies.cart = { mass = "M", inertia = { diagonal = [0, 0, 0] } }
bodies.upper = { mass = "m", inertia = { diagonal = ["m*l^2/12", "m*l^2/400", "m*l^2/12"] } }
bodies.lower = { mass = "m", inertia = { diagonal = ["m*l^2/12", "m*l^2/400", "m*l^2/12"] } }
gravity = { frame = "N", acceleration = [0, "-g", 0] }
[joints]
track = { kind = "slider", axis = 1, body = "cart", coordinates = ["x"], speeds = ["v"] }
pivot = { kind = "pin", axis = 3, body = "upper", to = "cart", centre = [0, "-l/2", 0], coordinates = ["a"], speeds = ["w"] }
hook = { kind = "pin", axis = AXIS, body = "lower", to = "upper", at = [0, "-l/2", 0], centre = [0, "-l/2", 0], coordinates = ["b"], speeds = ["z"] }
"#;

/// Goal: a reaction has its value in every pose. Method: each component between the bodies by the scene's reduced
/// equations, in planes along and across one another. Poses are those where sines and cosines are 0, and one where none
/// is. Compared are Kane's equations with the balances solved in numbers. At rest, hanging, the reactions are the
/// weights.
#[test]
fn reactions_of_a_scenes_own_equations_have_values_in_every_pose() {
    let components = ["cart on upper", "upper on lower"]
        .map(|pair| [1, 2, 3].map(|axis| format!("force({pair}) @ N [{axis}]")))
        .concat();
    let names = components.iter().map(|name| format!("{name:?}")).collect::<Vec<_>>().join(", ");
    for axis in [3, 1] {
        let model = MODEL.replace("AXIS", &axis.to_string());
        for (a, b, spin) in
            [("0", "0", 0), ("90*deg", "0", 2), ("0", "90*deg", 2), ("180*deg", "-90*deg", 1), ("0.3", "0.4", 1)]
        {
            let text = format!(
                "span = [0, 0.05]\noutputs = [{names}]\n[start]\nx = 0\na = \"{a}\"\nb = \"{b}\"\nv = 0\nw = {spin}\nz = {spin}\n[integration]\nmethod = \"dop853\"\nrtol = 1e-10\natol = 1e-12\n"
            );
            let found = [None, Some("kane")].map(|by| ends(&model, &text, by, &components));
            for (name, (own, whole)) in components.iter().zip(found[0].iter().zip(&found[1])) {
                assert!((own - whole).abs() < 1e-7, "axis {axis}, a = {a}, b = {b}: {name} is {own}, by Kane {whole}");
            }
            if (a, b) == ("0", "0") {
                // Weight of two rods, and of one.
                assert!((found[0][1] - 9.81).abs() < 1e-9 && (found[0][4] - 4.905).abs() < 1e-9, "{:?}", found[0]);
            }
        }
    }
}

/// Components at the end of a run.
fn ends(model: &str, scene: &str, by: Option<&str>, components: &[String]) -> Vec<f64> {
    let model =
        tripos_derive::model::load(&Source::from_text("model.toml", model)).unwrap_or_else(|error| panic!("{error}"));
    let scene = Scene::parse(Mechanism::new(model), scene).unwrap_or_else(|error| panic!("{error}"));
    let run = scene
        .simulate(&Overrides { by: by.map(Into::into), ..Overrides::default() })
        .unwrap_or_else(|error| panic!("{error}"));
    components.iter().map(|name| *run.column_of_quantity(name).unwrap().last().unwrap()).collect()
}
