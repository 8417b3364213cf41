//! Contacts of bodies that the file states, beside rolling and reactions: friction, and equations that compare two
//! bodies.

use crate::algebra::text::parse::VelocityOf;

/// The velocities, places and bodies that one constraint of the file ties: between these it may act.
#[derive(Clone, Debug)]
pub struct Compared {
    /// The velocities and places that it names.
    pub named: Vec<VelocityOf<usize>>,
    /// The bodies whose own coordinates, or their rates, stand beside at most one name, in the order of the file.
    pub own: Vec<usize>,
    /// The bodies whose own coordinates, or their rates, the constraint ties once its names are put in, in the order of
    /// the file.
    pub moved: Vec<usize>,
    /// True if the constraint stays true while all that it ties moves together: then it compares bodies.
    pub is_difference: bool,
}

/// Contacts of bodies, beside rolling and reactions.
#[derive(Clone, Debug, Default)]
pub struct Contacts {
    /// Bodies that friction acts on, each with the body against which it rubs; `None` is the ground.
    pub rubbing: Vec<(usize, Option<usize>)>,
    /// The constraints of the file.
    pub compared: Vec<Compared>,
    /// Bodies on which the ground, or the body that they touch, exerts nothing except what the file names: other
    /// connections carry them.
    pub idle: Vec<usize>,
}
