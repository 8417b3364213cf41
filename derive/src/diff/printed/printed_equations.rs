//! Printed systems and programs (listings) of a publication, as equations of motion that can be emitted as code and
//! run.

use crate::diff::printed_motions;
use crate::mechanics::{Derivations, Equations, EquationsOrigin, RowName};
use crate::model::Model;
use crate::publication::{EntryKind, Publication};

/// Converts every printed system and listing of a publication to equations of motion.
///
/// The equations stay exactly as printed, except for the order of the unknowns. Energies and the conversions between q̇
/// and u are derived from the model, so that the error of a run with the printed equations can be measured. An
/// incomplete system, such as one that lacks unknowns, is left out.
pub fn printed_equations(model: &Model, derivations: &mut Derivations, publication: &Publication) -> Vec<Equations> {
    let mut list = Vec::new();
    for motion in printed_motions(model, derivations, publication) {
        let Some(entry) = publication.entries.iter().find(|entry| entry.id == motion.id) else { continue };
        let formulation = match &entry.kind {
            EntryKind::System(system) => system.formulation,
            EntryKind::Listing(listing) => listing.formulation,
            _ => continue,
        };
        // A program that eliminates the reactions has as many unknowns as equations without reactions.
        let eliminated = motion.right.len() == model.speeds.len();
        let alike = if eliminated { formulation.without_reactions() } else { formulation };
        let Some(derived) = derivations.get(alike) else { continue };
        if derived.unknowns.len() != motion.right.len() {
            continue;
        }
        list.push(Equations {
            by: EquationsOrigin::Printed { id: motion.id, formulation },
            formulation: alike,
            rows: (0..motion.right.len()).map(RowName::Printed).collect(),
            matrix: motion.matrix,
            forcing: motion.right,
            symmetric: false,
            definitions: Vec::new(),
            required: Vec::new(),
            gauss: None,
            projection: Vec::new(),
            embedding: None,
            coordinate_rates: motion.coordinate_rates,
            ..derived.clone()
        });
    }
    list
}
