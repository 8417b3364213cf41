//! Derivatives of runs whose contacts close, open, stick, slip or have impacts.

pub(super) mod contact_history;
pub(super) mod contact_zeros;
pub(super) mod crossing_derivatives;
pub(super) mod grazing_contacts;
pub(super) mod held_contact_forces;
pub(super) mod held_directions;
pub(super) mod impact_strikes;
pub(super) mod motion_before_crossing;
pub(super) mod precise_contacts;
