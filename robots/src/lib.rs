//! Robot descriptions: URDF and MJCF read into model files of Tripos, and trees of links written as URDF.
//!
//! [`import`] reads a description, checks it, joins bodies that are fixed to one another, and writes a model file:
//! the text that a person would write, with joints, inertias, limits, loops, couplings, drives and shapes. Parts of
//! the description without a meaning in a model of rigid bodies are listed. The loops of a URDF file, which is a tree,
//! stand in a second file. [`urdf_text`] writes a tree of links as a URDF file.

#![cfg_attr(doctest, doc = include_str!("../README.md"))]

mod fixed_bodies;
mod inertia;
mod loops_file;
mod meshes;
mod mjcf;
mod model_text;
mod names;
mod numbers;
mod pose;
mod robot;
mod scene_text;
mod urdf;
mod urdf_text;
mod xml;

use model_text::LoopLine;
pub use pose::{Pose, axis_turn};
pub use robot::{Inertia, Omission, Shape, Solid};
use tripos_derive::diagnostic::{Diagnostic, Diagnostics, Source};
pub use urdf_text::{AxisJoint, Link, LinkJoint, LinkMotion, LinkTree, Mimic, NO_LIMIT, urdf_text};

/// A model file made from a robot description.
#[derive(Clone, Debug)]
pub struct Import {
    /// Text of the model file.
    pub model: String,
    /// Text of a scene that starts at rest in the reference configuration.
    pub scene: String,
    /// Parts of the description that were left out or simplified.
    pub omissions: Vec<Omission>,
    /// Lines of the model file that close loops, with the places of these loops.
    loops: Vec<LoopLine>,
    /// File that states the loops: the loops file, or else the description.
    stated_in: Source,
}

impl Import {
    /// Errors of the model file that concern loops, at the places of these loops in the file that states them. `None`
    /// if no error concerns a loop.
    #[must_use]
    pub fn errors_of_loops(&self, errors: &Diagnostics) -> Option<Diagnostics> {
        let place_of = |error: &Diagnostic| {
            let at = error.span.as_ref()?.start;
            self.loops.iter().find(|one| one.line.contains(&at)).map(|one| one.place.clone())
        };
        let moved = errors.list.iter().filter_map(|error| {
            let help = error.help.clone().unwrap_or_default();
            Some(Diagnostic::new(place_of(error)?, error.message.clone(), help))
        });
        let list: Vec<Diagnostic> = moved.collect();
        if list.is_empty() { None } else { Some(Diagnostics::new(self.stated_in.clone(), list)) }
    }
}

/// Options of reading a robot description.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Options {
    /// True if the root of a URDF file moves freely; false if it is fixed to the ground.
    pub is_floating: bool,
    /// True if angles keep the digits of the file; false if 1.5708 is read as π/2, which makes equations shorter.
    pub is_as_written: bool,
}

/// Reads a robot description in URDF or MJCF, and writes it as a model file. `loops` is a TOML file with the
/// connections and couplings of a URDF file, which is a tree; MJCF files state their own.
///
/// # Errors
/// All mistakes of the description, or else of the loops, each with its place in the file.
pub fn import(source: &Source, loops: Option<&Source>, options: Options) -> Result<Import, Diagnostics> {
    let document = xml::parse(source)?;
    let root = document.root_element();
    let reading = xml::Reading::new(options, &source.path);
    let read = match root.tag_name().name() {
        "robot" => urdf::read(root, options, &reading),
        "mujoco" => mjcf::read(root, &reading),
        other => {
            let message = format!("the root element is `{other}`: neither `robot` (URDF) nor `mujoco` (MJCF)");
            let advice = "give a URDF or an MJCF file";
            return Err(Diagnostics::new(source.clone(), vec![Diagnostic::new(xml::place(root), message, advice)]));
        }
    };
    let mut robot = reading.into_result(source, read)?;
    if let Some(loops) = loops {
        if !root.has_tag_name("robot") {
            let message = "this MJCF file states its loops under `<equality>`, and a further file gives loops, too";
            let error = Diagnostic::of_file(message, "leave the further file out: it is for URDF files");
            return Err(Diagnostics::new(source.clone(), vec![error]));
        }
        loops_file::read(loops, options, &mut robot)?;
    }
    fixed_bodies::join(&mut robot);
    if robot.bodies.is_empty() {
        let error = Diagnostic::of_file(
            "no body of this robot moves",
            "give a robot with a moving joint; `--floating` lets the root of a URDF file move freely",
        );
        return Err(Diagnostics::new(source.clone(), vec![error]));
    }
    let format = if root.has_tag_name("robot") { "URDF" } else { "MJCF" };
    let text = model_text::model_text(&mut robot, format, &source.path, loops.map(|loops| loops.path.as_path()));
    Ok(Import {
        scene: scene_text::scene_text(&robot, &text.coordinates),
        model: text.model,
        omissions: robot.omissions,
        loops: text.loops,
        stated_in: loops.unwrap_or(source).clone(),
    })
}
