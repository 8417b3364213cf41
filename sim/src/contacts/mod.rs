//! Contacts that push and never pull: the modes of Coulomb friction, impulses and forces.

pub(crate) mod friction;
pub(crate) mod impact;
