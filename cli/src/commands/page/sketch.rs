//! Sketch of the mechanism at the top of the page.

use crate::page::SketchPicture;
use crate::sketch::sketch_svg_element;
use tripos::Mechanism;
use tripos::pictures::sketch::Sketch;
use tripos_derive::scene::Scene;

/// Draws the sketch of a mechanism as `tripos sketch` does. If a scene is given, the pose is that of its start. `Err`
/// is the reason why there is no sketch.
pub fn page_sketch(mechanism: &Mechanism, scene: Option<&Scene>) -> Result<SketchPicture, String> {
    let sketch = scene.map_or_else(|| Sketch::of_model(mechanism), |scene| Sketch::of_scene(mechanism, scene));
    let sketch = sketch.map_err(|error| error.first_line())?;
    Ok(SketchPicture { svg: sketch_svg_element(&sketch), caption: sketch.drawn })
}
