//! A disk that slides with viscous drag at its contact, where the contact point moves in the disk.

use tripos::{Mechanism, Overrides, Scene};
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;

const DISK: &str = include_str!("../derive/tests/models/dragged_disk.toml");
const SCENE: &str = "model = \"disk.toml\"\nspan = [0, 2]\noutputs = [\"total_energy\"]\n[start]\nq1 = 0.1\nq2 = 0.2\n\
                     q3 = 0\nq4 = 0\nq5 = 0\nu1 = 0.3\nu2 = 0.5\nu3 = 6\nu4 = -1\nu5 = 0.4\n[integration]\n\
                     method = \"dop853\"\nrtol = 1e-11\natol = 1e-11\n";

/// The disk with drag on this velocity at the contact, and nothing else but gravity.
fn disk(velocity: &str) -> Model {
    let (before, _) = DISK.split_once("[forces.film]").unwrap();
    let (_, after) = DISK.split_once("[reactions.N]").unwrap();
    let vector = format!("[\"-c*{velocity} @ A [1]\", \"-c*{velocity} @ A [2]\", 0]");
    let force = format!("[forces.film]\non = \"disk\"\nat = \"P\"\nframe = \"A\"\nvector = {vector}\n");
    let text = format!("{before}{force}[reactions.N]{after}");
    tripos_derive::model::load(&Source::from_text("disk.toml", &text)).unwrap_or_else(|e| panic!("{e}"))
}

/// T + V along a run.
fn energies(velocity: &str, by: &str) -> Vec<f64> {
    let scene = Scene::parse(Mechanism::new(disk(velocity)), SCENE).unwrap_or_else(|e| panic!("{e}"));
    let run = scene.simulate(&Overrides { by: Some(by.into()), ..Overrides::default() });
    run.unwrap_or_else(|e| panic!("{by}: {e}")).column_of_quantity("total_energy").unwrap().clone()
}

/// Goal: drag on the material takes energy at every instant, by every formulation. Method: T + V falls from output to
/// output, and the disk ends with less.
#[test]
fn drag_on_the_material_at_the_contact_only_takes_energy() {
    for by in ["kane", "lagrange", "newton-euler"] {
        let energies = energies("v(disk, P)", by);
        assert!(energies.len() > 20);
        let (first, last) = (energies[0], energies[energies.len() - 1]);
        assert!(energies.windows(2).all(|pair| pair[1] <= pair[0] + 1e-9 * first), "{by}: {energies:?}");
        assert!(last < 0.95 * first, "{by}: from {first} to {last}");
    }
}

/// A force proportional to the velocity of the contact point itself is no drag on the material there: it gives energy.
#[test]
fn drag_by_the_velocity_of_the_contact_point_gives_energy() {
    let energies = energies("v(P)", "kane");
    assert!(energies.windows(2).any(|pair| pair[1] > pair[0] + 1e-6), "{energies:?}");
}
