//! Derivation and proofs of a model, and judgement of its publication, for its page.
//!
//! The terms of proofs and verdicts are held in one store, apart from the terms of the equations that are shown and
//! run. So the contents of a publication can never change the derivation.

use crate::code::{Code, Ready, code_of, compiled_code};
use crate::error::Error;
use crate::mechanism::Mechanism;
use tripos_derive::diagnostic::Diagnostics;
use tripos_derive::diff::{Difference, diff, printed_equations};
use tripos_derive::mechanics::{Derivation, Derivations, EquationsOrigin, derive_all};
use tripos_derive::prove::{Proof, Singularity, prove, singularity, zeros};
use tripos_derive::publication::{Publication, load_beside};
use tripos_derive::{Equations, Formulation, Model};

/// Results of the analysis of a model that need no run.
pub struct Study {
    /// Derived equations, with the store of all terms of the study.
    pub derivations: Derivations,
    /// Proved statements on the model.
    pub proof: Proof,
    /// Singular configurations of the matrix of each formulation; a formulation with a too large matrix is left out.
    pub singular: Vec<(Formulation, Singularity)>,
    /// Publication file beside the model, with its judgement; `None` if there is none.
    pub published: Option<Published>,
}

/// Name of a printed system, with its code or the reason why it cannot run.
pub type Printed = (EquationsOrigin, Result<Code, Error>);

/// Publication with the judgement of its printed equations.
pub struct Published {
    /// Publication file with the printed equations.
    pub publication: Publication,
    /// Comparison of the printed equations with the derived ones.
    pub difference: Difference,
    /// Singular configurations of the matrix of each printed system, in the order of `difference.consequences`; `None`
    /// if the matrix is too large.
    pub singular: Vec<Option<Singularity>>,
    /// Printed systems as equations of motion, in the order of the publication.
    pub printed: Vec<Equations>,
}

impl Study {
    /// Derives the model by the standard formulations and by those of `also`, proves statements on it, and judges the
    /// publication beside it, if there is one.
    ///
    /// A publication file with errors is left out; its errors are returned beside the study.
    ///
    /// # Errors
    /// [`Error`] if the model cannot be derived.
    pub fn new(model: &Model, also: &[Formulation]) -> Result<(Self, Option<Diagnostics>), Error> {
        let mut with_publication = model.clone();
        let (publication, broken) = match load_beside(&model.source.path, &mut with_publication) {
            Ok(publication) => (publication, None),
            Err(diagnostics) => (None, Some(diagnostics)),
        };
        let model = if broken.is_some() { model } else { &with_publication };
        let mut derivations = derive_all(model).map_err(|error| model.diagnose(&error))?;
        for formulation in also {
            derivations.add(model, *formulation).map_err(|error| model.diagnose(&error))?;
        }
        let proof = prove(model, &mut derivations);
        let matrices = derivations.list.iter().filter_map(|(f, e)| Some((*f, e.as_ref().ok()?.matrix.clone())));
        let matrices: Vec<_> = matrices.collect();
        let kinematics = &mut derivations.kinematics;
        let singular =
            matrices.into_iter().filter_map(|(f, matrix)| Some((f, singularity(model, kinematics, &matrix)?)));
        let singular = singular.collect();
        let published = publication.map(|publication| Published::new(model, &mut derivations, &proof, publication));
        match &published {
            Some(published) => published.difference.write_names(&proof, &mut derivations),
            None => proof.write_names(&mut derivations),
        }
        Ok((Self { derivations, proof, singular, published }, broken))
    }

    /// Makes the printed systems of the publication ready to run; an error says why one cannot run.
    #[must_use]
    pub fn printed(&self, model: &Mechanism) -> Vec<Printed> {
        let Some(published) = &self.published else { return Vec::new() };
        let mut list = Vec::new();
        // The store of terms is copied once, and only if equations have to be interpreted.
        let mut derivation: Option<Derivation> = None;
        for equations in &published.printed {
            let by = equations.by.clone();
            let code = match compiled_code(model, &by, None, Ready::Solved) {
                Some(code) => Ok(code),
                None => {
                    let arena = || self.derivations.kinematics.arena.clone();
                    let derivation =
                        derivation.get_or_insert_with(|| Derivation { arena: arena(), equations: equations.clone() });
                    derivation.equations = equations.clone();
                    code_of(model, &by, derivation, Ready::AsDerived)
                }
            };
            list.push((by, code));
        }
        list
    }
}

impl Published {
    fn new(model: &Model, derivations: &mut Derivations, proof: &Proof, publication: Publication) -> Self {
        let difference = diff(model, derivations, &publication, proof);
        let equations = printed_equations(model, derivations, &publication);
        let singular = difference.consequences.iter().map(|c| {
            let (printed, ..) = c.determinant.as_ref()?;
            let matrix = &printed_of(&equations, &c.system)?.matrix;
            Some(zeros(model, &mut derivations.kinematics, matrix, *printed))
        });
        let singular = singular.collect();
        Self { publication, difference, singular, printed: equations }
    }

    /// Id of the first printed system that is proved to give the same motion as the system `id`; `id` itself if no
    /// system before it does.
    #[must_use]
    pub fn first_alike<'a>(&'a self, id: &'a str) -> &'a str {
        let agreements = &self.difference.agreements;
        agreements.iter().find(|a| a.right == id && a.verdict.is_equal()).map_or(id, |a| &a.left)
    }
}

/// Printed equations of the system with the given id.
fn printed_of<'a>(list: &'a [Equations], id: &str) -> Option<&'a Equations> {
    list.iter().find(|equations| equations.by.printed_id() == Some(id))
}
