//! Sketch of the mechanism at the top of the page.

use crate::page::Drawing;
use crate::sketch::figure;
use tripos::Mechanism;
use tripos::pictures::sketch::Sketch;
use tripos_derive::scene::Scene;

/// Draws the sketch of a mechanism as `tripos sketch` does, in the start pose of the scene if one
/// is given. `Err` is the reason why there is no sketch.
pub fn sketched(mechanism: &Mechanism, scene: Option<&Scene>) -> Result<Drawing, String> {
    let sketch = scene.map_or_else(|| Sketch::of_model(mechanism), |scene| Sketch::of_scene(mechanism, scene));
    let sketch = sketch.map_err(|error| error.first_line())?;
    Ok(Drawing { svg: figure(&sketch), caption: sketch.drawn })
}
