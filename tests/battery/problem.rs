//! Motions to be run: a mechanism, a start, a span.

use crate::mechanism;
use crate::spoilt::Random;
use std::path::Path;
use tripos::Mechanism;
use tripos_derive::diagnostic::Source;
use tripos_derive::scene::{InitialMotion, Scene, load};
use tripos_traits::{DoubleDouble, Scalar};

/// Samples of a run.
const SAMPLES: usize = 21;
/// The scenes of the library that are run, and what is put next to a singular surface or an unstable rest: the
/// coordinate, and where that is.
const LIBRARY: [(&str, Option<(usize, f64)>); 14] = [
    ("pendulum/scenes/swing", Some((0, std::f64::consts::PI))),
    ("pendulum/scenes/over", Some((0, std::f64::consts::PI))),
    ("disk/scenes/report-10s", Some((1, std::f64::consts::FRAC_PI_2))),
    ("disk/scenes/near-flat", Some((1, std::f64::consts::FRAC_PI_2))),
    ("disk/scenes/lean", Some((1, 0.0))),
    ("spherical_pendulum/scenes/wide", Some((0, 0.0))),
    ("spherical_pendulum/scenes/narrow", Some((0, std::f64::consts::PI))),
    ("heavy_top/scenes/looping", None),
    ("heavy_top/scenes/sleeping", None),
    ("euler_top/scenes/looping", None),
    ("free_body/scenes/tumbling", None),
    ("floating_chain/scenes/folding", None),
    ("cart_pendulum_3/scenes/fall", None),
    ("chaotic_pendulum/scenes/swing", None),
];

pub struct Problem {
    pub name: String,
    pub mechanism: Mechanism,
    pub scene: Scene,
}

impl Problem {
    /// Draws one.
    pub fn new(random: &mut Random) -> Self {
        let mut problem = if random.chance(50) { Self::random(random) } else { Self::of_library(random) };
        let scene = &mut problem.scene;
        scene.events.clear();
        scene.integration.domain_stops = false;
        scene.integration.distance = None;
        scene.integration.samples = Some(SAMPLES);
        // As many motions of each order of magnitude.
        let longest = if random.chance(20) { 3.0 } else { 1.7 };
        scene.span = (0.0, 10_f64.powf(random.between(0.0, longest)));
        problem
    }

    /// The instants of its samples.
    pub fn times(&self) -> Vec<f64> {
        let (from, to) = self.scene.span;
        let last = (SAMPLES - 1) as f64;
        (0..SAMPLES).map(|i| if i + 1 == SAMPLES { to } else { from + (to - from) * i as f64 / last }).collect()
    }

    fn random(random: &mut Random) -> Self {
        let drawn = mechanism::Mechanism::new(random);
        let model = tripos_derive::model::load(&Source::from_text("model.toml", &drawn.text())).unwrap();
        let mut mechanism = Mechanism::new(model);
        let text = drawn.scene(random).text(&drawn);
        let mut scene = load(&Source::from_text("scene.toml", &text), &mut mechanism).unwrap();
        // States are what the truth is known of.
        let names = tripos::state_names(&mechanism);
        scene.outputs.retain(|output| names.contains(&output.name));
        if scene.outputs.is_empty() {
            let plain = text.lines().filter(|line| !line.starts_with("outputs")).collect::<Vec<_>>().join("\n");
            scene = load(&Source::from_text("scene.toml", &plain), &mut mechanism).unwrap();
        }
        Self { name: "random mechanism".to_owned(), mechanism, scene }
    }

    fn of_library(random: &mut Random) -> Self {
        let (name, edge) = random.one(&LIBRARY);
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(format!("{name}.toml"));
        let source = Source::read(&path).unwrap();
        let model = Mechanism::read(&tripos_derive::scene::model_path_of_scene(&source).unwrap()).unwrap();
        let mut mechanism =
            if random.chance(70) { model.with_compiled_equations(tripos_models::MODELS) } else { model };
        let mut scene = load(&source, &mut mechanism).unwrap();
        if random.chance(60) {
            move_start(random, &mut scene, *edge);
        }
        Self { name: (*name).to_owned(), mechanism, scene }
    }
}

/// Another start: somewhere near, or next to an edge, sometimes at rest.
fn move_start(random: &mut Random, scene: &mut Scene, edge: Option<(usize, f64)>) {
    for q in &mut scene.q {
        *q += random.between(-0.3, 0.3);
    }
    if let (Some((at, place)), true) = (edge, random.chance(50)) {
        scene.q[at] = place + random.one(&[1.0, -1.0]) * 10_f64.powf(-random.between(1.0, 9.0));
    }
    let still = random.chance(30);
    for u in &mut scene.u {
        *u = if still { 0.0 } else { *u + random.between(-0.5, 0.5) };
    }
    let exact = |list: &[f64]| list.iter().map(|x| DoubleDouble::from_f64(*x)).collect::<Vec<_>>();
    scene.exact.q = exact(&scene.q);
    scene.exact.motion = InitialMotion::Speeds(exact(&scene.u));
}
