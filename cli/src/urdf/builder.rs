//! Data from which the links of a robot description are made.

use super::chains::Places;
use super::numbers::Numbers;
use super::tree::{NodePlace, Tree};
use tripos_derive::Model;

/// Makes the links of a model.
pub struct LinkBuilder<'m> {
    /// Model that is described.
    pub model: &'m Model,
    /// Evaluator of the model's terms.
    pub numbers: Numbers,
    /// Frames and points with their numbers.
    pub places: Places<'m>,
    /// Tree of joints.
    pub tree: Tree,
    /// Place of each body's mass centre.
    pub centres: Vec<NodePlace>,
}
