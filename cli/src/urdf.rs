//! A model as a robot description in URDF: links, joints, limits, losses and shapes, with a list of what URDF cannot
//! say.
//!
//! URDF states numbers, and a tree of joints. Parameters have the default values of the model file. A coordinate of the
//! model is the coordinate of one joint, with the same zero and sign.

mod builder;
mod chains;
mod joint_numbers;
mod limits;
mod links;
mod losses;
mod masses;
mod names;
mod numbers;
mod refusals;
mod remarks;
mod shapes;
mod tree;

use builder::LinkBuilder;
use chains::{Chain, Places};
use numbers::Numbers;
use refusals::{check_loops, check_tree, check_values, diagnostic_of_chain};
use tree::{NodePlace, Tree};
use tripos_derive::Model;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics};
use tripos_robots::LinkTree;

/// Robot description made from a model.
pub struct Description {
    /// Links and joints.
    pub robot: LinkTree,
    /// Coordinates of each joint whose name is not that of its coordinate, one sentence each.
    pub coordinates: Vec<String>,
    /// Parts of the model that the description does not have, one sentence each.
    pub remarks: Vec<String>,
    /// Sentences on links that readers may refuse.
    pub notes: Vec<String>,
}

/// Makes the robot description of a model.
///
/// # Errors
/// Diagnostics if a parameter has no value, if the model has a loop, or if its bodies are no tree of joints whose
/// coordinates are those of the model.
pub fn describe_robot(model: &Model) -> Result<Description, Diagnostics> {
    let failed = |errors: Vec<Diagnostic>| {
        if errors.is_empty() { Ok(()) } else { Err(Diagnostics::new(model.source.clone(), errors)) }
    };
    failed(check_values(model))?;
    let mut numbers = Numbers::new(model);
    let places = Places::new(model, &mut numbers);
    failed(check_loops(model, &places, &numbers))?;
    let mut errors = Vec::new();
    let mut chains: Vec<Chain> = Vec::new();
    for body in &model.bodies {
        let frame = body.rigid.as_ref().map(|(frame, _)| *frame);
        match places.chain(&mut numbers, frame, body.centre) {
            Ok(chain) => chains.push(chain),
            Err(reason) => errors.push(diagnostic_of_chain(model, body, reason)),
        }
    }
    failed(errors)?;
    let mut tree = Tree::new(chains.iter(), numbers.coordinates.len());
    let centres: Vec<NodePlace> = chains.iter().map(|chain| tree.add(&places, chain)).collect();
    let taken: Vec<usize> = centres.iter().map(|place| place.node).collect();
    tree.join(|node| taken.contains(&node));
    failed(check_tree(model, &tree))?;
    LinkBuilder { model, numbers, places, tree, centres }
        .description()
        .map_err(|errors| Diagnostics::new(model.source.clone(), errors))
}
