//! Command `tripos scene`: prints the reduced equations of a scene, and the parts of the model that the scene does not
//! need.

mod certificate;

use crate::commands::prove::certificate_of_model;
use crate::files::output_files::{refuse_overwriting_inputs, write_text_file};
use crate::files::scene_file::SceneWithSetValues;
use crate::files::workspace::{read_model, short_name};
use crate::terminal::failure::{Failure, Output, print, print_json};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::{Mechanism, ReducedScene};
use tripos_codegen::plan::{Costs, OperationCount, scene_costs};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::mechanics::Derivation;
use tripos_derive::reduce::ReducedQuantity;
use tripos_derive::scene::{Scene, model_path_of_scene};

/// Runs `tripos scene`: prints the reduced equations of a scene, with the omitted parts and their
/// proofs. Writes a certificate of the reduction to the file `certificate`, if given. Returns the exit status.
///
/// # Errors
/// `Failure` if the scene has no reduced equations, if they cannot be certified, or if an output cannot be written.
pub fn scene(
    SceneWithSetValues { model, scene, .. }: &SceneWithSetValues,
    certificate: Option<&Path>,
    output: Output,
) -> Result<u8, Failure> {
    let reduced = ReducedScene::new(model, scene)?;
    if let Some(place) = certificate {
        refuse_overwriting_inputs(model, Some(scene), Some(place))?;
        // The model of the scene has the names of the scene in its arena; the proofs belong to the model file alone.
        let own = read_model(&model_path_of_scene(&scene.source)?)?;
        let Some(proof) = certificate_of_model(&own)? else {
            let what = "the formulations of the model are not proved equivalent, so that no reduction can be certified";
            return Err(Failure::request(what, "run `tripos prove` on the model to see which pair is not proved"));
        };
        let text = certificate::certificate_of_reduction(&proof, scene, &reduced.reduction)?;
        write_text_file(place, &text)?;
    }
    let costs = scene_costs(model, &reduced.reduction).map_err(|error| model.diagnose(&error))?;
    let no_gain = reduced.reason_against_reduction(model)?;
    if output == Output::Json {
        let mut value = reduced_scene_json(model, scene, &reduced, costs);
        value["runs_whole"] = json!(no_gain);
        print_json(&value)?;
    } else {
        let why = no_gain.map(|why| format!("\nrun by full equations, unless with --by reduced: {why}\n"));
        print(&(reduced_scene_text(model, scene, &reduced, costs) + &why.unwrap_or_default()))?;
    }
    Ok(0)
}

/// Returns the report on the reduced equations as JSON.
fn reduced_scene_json(model: &Mechanism, scene: &Scene, reduced: &ReducedScene, costs: Costs) -> Value {
    let reduction = &reduced.reduction;
    let arena = reduction.arena();
    let names = |list: &[ReducedQuantity]| list.iter().map(|q| q.name.clone()).collect::<Vec<_>>();
    let count = |of: fn(&OperationCount) -> usize| json!({ "full": of(&costs.full), "scene": of(&costs.scene) });
    let constants = reduced.constants().map(|(q, value)| {
        json!({ "name": q.name, "value": value, "unit": q.unit.to_string(), "about": q.about.text(arena), "is": print_text(arena, q.of_start) })
    });
    let outputs = reduction.outputs.iter().map(|o| json!({ "name": o.name, "value": print_text(arena, o.value) }));
    let omitted = reduction
        .omitted
        .iter()
        .map(|o| json!({ "what": o.what.text(arena), "why": o.why.text(arena), "proof": o.proof }));
    json!({
        "model": short_name(model),
        "title": scene.title,
        "outputs": outputs.collect::<Vec<_>>(),
        "states": names(&reduction.states),
        "quadratures": names(&reduction.quadratures),
        "constants": constants.collect::<Vec<_>>(),
        "frame": reduction.frame.as_ref().map(|frame| json!({
            "moved_by": frame.about,
            "zero": frame.pins.iter().map(|pin| print_text(arena, *pin)).collect::<Vec<_>>(),
        })),
        "equations": reduced_equation_lines(reduced),
        "kept_by_domain": reduction.kept_by_domain,
        "operations": count(|c| c.operations),
        "divisions": count(|c| c.divisions),
        "sines_and_cosines": count(|c| c.sincos),
        "singular_where": reduction.divisors.iter().map(|d| format!("{} = 0", print_text(arena, *d))).collect::<Vec<_>>(),
        "omitted": omitted.collect::<Vec<_>>(),
    })
}

/// Returns the definitions and equations of motion of the reduced system, one per line.
fn reduced_equation_lines(reduced: &ReducedScene) -> Vec<String> {
    equation_lines(&reduced.reduction.derivation)
}

/// Returns the definitions, the kinematic equations and the equations of motion, one per line.
pub fn equation_lines(Derivation { arena, equations: e }: &Derivation) -> Vec<String> {
    let text = |x| print_text(arena, x);
    let definitions = e.definitions.iter().map(|d| (text(d.symbol), text(d.value)));
    let rates = e.coordinates.iter().zip(&e.coordinate_rates).map(|(q, k)| (format!("{}'", text(*q)), text(*k)));
    let solved = (0..e.unknowns.len()).map(|i| {
        let row: Vec<String> = e.matrix[i]
            .iter()
            .zip(&e.unknowns)
            .filter(|(m, _)| **m != tripos_derive::algebra::Expr::ZERO)
            .map(|(m, x)| {
                if *m == tripos_derive::algebra::Expr::ONE { text(*x) } else { format!("({})*{}", text(*m), text(*x)) }
            })
            .collect();
        (row.join(" + "), text(e.forcing[i]))
    });
    definitions.chain(rates).chain(solved).map(|(name, value)| format!("{name} = {value}")).collect()
}

/// Returns the report on the reduced equations as text.
fn reduced_scene_text(model: &Mechanism, scene: &Scene, reduced: &ReducedScene, costs: Costs) -> String {
    let reduction = &reduced.reduction;
    let arena = reduction.arena();
    let mut out = format!("{}: {}\n", model.title, if scene.title.is_empty() { "a scene" } else { &scene.title });
    let whole = model.coordinates.len() + model.speeds.len();
    let _ = writeln!(out, "\nkept, of {whole} states");
    for (kind, list) in [("state", &reduction.states), ("quadrature", &reduction.quadratures)] {
        for q in list {
            let _ = writeln!(out, "  {kind:<11}{}: {}", q.name, q.about.text(arena));
        }
    }
    for (q, value) in reduced.constants() {
        let _ = writeln!(out, "  {:<11}{} = {value:?}: {}", "constant", q.name, q.about.text(arena));
    }
    if let Some(frame) = &reduction.frame {
        let pins: Vec<String> = frame.pins.iter().map(|pin| format!("{} = 0", print_text(arena, *pin))).collect();
        let _ = writeln!(out, "  {:<11}{}: moved by {}", "frame", pins.join(", "), frame.about.join(" and by "));
    }
    if !reduction.kept_by_domain.is_empty() {
        let words = reduction.kept_by_domain.join(" and ");
        let _ = writeln!(out, "  {:<11}none: the domain names what {words} would turn", "frame");
    }
    let _ = writeln!(out, "\nequations");
    for line in reduced_equation_lines(reduced) {
        let _ = writeln!(out, "  {line}");
    }
    let timed = reduction.outputs.iter().any(|o| arena.mentions(o.value, reduction.time));
    let _ = writeln!(out, "\noutputs{}", if timed { ", t being the time since the start" } else { "" });
    for o in &reduction.outputs {
        let _ = writeln!(out, "  {} = {}", o.name, print_text(arena, o.value));
    }
    let Costs { full, scene } = costs;
    let _ = writeln!(
        out,
        "\ncost of a call: {} operations of {} by Kane's method, divisions {} of {}, sines and cosines {} of {}",
        scene.operations, full.operations, scene.divisions, full.divisions, scene.sincos, full.sincos
    );
    if !reduction.divisors.is_empty() {
        let places: Vec<String> = reduction.divisors.iter().map(|d| format!("{} = 0", print_text(arena, *d))).collect();
        let _ = writeln!(out, "singular where {}", places.join(" and where "));
    }
    let _ = writeln!(out, "\nleft out");
    for o in &reduction.omitted {
        let _ = writeln!(out, "  {}: {}\n    proof: {}", o.what.text(arena), o.why.text(arena), o.proof);
    }
    out
}
