//! How each run of a scene stands: by the verdict on its equations, and by its error.

use super::own::wide;
use crate::page::Standing;
use tripos::compared::Compared;
use tripos::study::Study;
use tripos::{Mechanism, Reference, Run, method_words};
use tripos_derive::algebra::compare::Verdict;
use tripos_derive::scene::Scene;
use tripos_sim::work_precision::error;
use tripos_traits::DoubleDouble;

/// The standing of printed equations that are not known to give the derived accelerations.
fn of_printed(study: &Study, id: &str) -> Option<Standing> {
    let mut systems = study.published.iter().flat_map(|published| &published.difference.consequences);
    match systems.find(|system| system.system == id).map(|system| &system.accelerations) {
        Some(Verdict::Equal(_)) => None,
        Some(Verdict::Different(_)) => Some(Standing::Wrong),
        Some(Verdict::Undecided(why)) => Some(Standing::Undecided(why.clone())),
        None => Some(Standing::Undecided("they do not determine the motion".to_owned())),
    }
}

/// The standings of the runs of one scene. Its reference is made once for each end, and only if a run is loose.
pub struct Standings<'a> {
    model: &'a Mechanism,
    scene: &'a Scene,
    study: &'a Study,
    /// The instant, and what is compared there.
    known: Vec<(f64, Result<Vec<DoubleDouble>, String>)>,
}

impl<'a> Standings<'a> {
    /// Nothing is asked yet.
    pub fn new(model: &'a Mechanism, scene: &'a Scene, study: &'a Study) -> Self {
        Self { model, scene, study, known: Vec::new() }
    }

    /// How a run stands.
    pub fn of(&mut self, run: &Run) -> Standing {
        if let Some(standing) = run.by.printed_id().and_then(|id| of_printed(self.study, id)) {
            return standing;
        }
        if run.failure().is_some() {
            return Standing::Stopped;
        }
        if run.warnings.is_empty() {
            return Standing::Right;
        }
        Standing::Loose { how: method_words(self.scene), error: self.error(run) }
    }

    /// The error of a run at its end.
    fn error(&mut self, run: &Run) -> Result<f64, String> {
        let compared = Compared::new(self.model, self.scene).map_err(|failure| failure.to_string())?;
        let end = wide(&run.end);
        let found = compared.kept(if run.by.is_reduced() { end } else { compared.of_state(&end) });
        let error = error(&found, &self.reference(&compared, run.solution.t_end)?);
        if error.is_finite() { Ok(error) } else { Err("something that is shown has no value there".to_owned()) }
    }

    fn reference(&mut self, compared: &Compared, t: f64) -> Result<Vec<DoubleDouble>, String> {
        if let Some((_, known)) = self.known.iter().find(|(at, _)| at.to_bits() == t.to_bits()) {
            return known.clone();
        }
        let made = Reference::new(self.model, self.scene, &[t]);
        let made = made.map(|reference| compared.kept(compared.of_state(reference.end())));
        let made = made.map_err(|failure| failure.to_string().lines().next().unwrap_or_default().to_owned());
        self.known.push((t, made.clone()));
        made
    }
}
