//! Rigorous runs of the page's scenes: verdicts on the claims about their motions.

use crate::page::{ClaimOutcome, ClaimRow};
use tripos::{EnclosedInstants, EquationsName, Mechanism, RigorousRequest, enclose_scene};
use tripos_derive::scene::Scene;
use tripos_sim::rigorous_run::RigorousOptions;

/// Largest number of steps of a rigorous run for the page.
const MOST_STEPS: u64 = 5_000;

/// Judges the claims of a scene by rigorous runs, one for each set of equations that the claims are about. `set`, as
/// (name, value), replaces numbers of the scene's file.
pub fn judged_claims(model: &Mechanism, scene: &Scene, set: &[(String, f64)]) -> Vec<ClaimRow> {
    let mut origins: Vec<Option<&str>> = Vec::new();
    for claim in &scene.claims {
        if !origins.contains(&claim.by.as_deref()) {
            origins.push(claim.by.as_deref());
        }
    }
    let mut rows: Vec<ClaimRow> = Vec::new();
    for origin in origins {
        let by = origin.map(EquationsName::from);
        let options = RigorousOptions { step_limit: MOST_STEPS, ..RigorousOptions::default() };
        let request = RigorousRequest {
            by: by.as_ref(),
            set,
            instants: EnclosedInstants::Parts(1),
            claims: &[],
            operation_limit: u64::MAX,
            options,
        };
        let found = enclose_scene(model, scene, &request);
        for (at, claim) in scene.claims.iter().filter(|claim| claim.by.as_deref() == origin).enumerate() {
            let (equations, outcome) = match &found {
                Ok(found) => (found.by.title(), ClaimOutcome::from(found.claims[at].1)),
                Err(error) => (origin.unwrap_or_default().to_owned(), ClaimOutcome::NotJudged(error.first_line())),
            };
            rows.push(ClaimRow {
                claim: claim.text.clone(),
                equations,
                printed: claim.printed.clone(),
                about: claim.about.clone(),
                outcome,
            });
        }
    }
    rows
}

impl From<tripos::ClaimVerdict> for ClaimOutcome {
    fn from(verdict: tripos::ClaimVerdict) -> Self {
        match (verdict.is_proved(), verdict.refuted_by) {
            (true, _) => Self::Proved,
            (false, Some(by)) => Self::Refuted { by },
            (false, None) => Self::Open { proved_to: verdict.proved_to },
        }
    }
}
