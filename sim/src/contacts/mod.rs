//! Contacts that push and never pull: the modes of Coulomb friction, the impulses of impacts and the
//! forces.

pub(crate) mod closed_contacts;
pub(crate) mod friction;
