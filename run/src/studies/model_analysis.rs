//! Analysis of a model without a run: its derivation, its proofs, and the judgement of its
//! publication.
//!
//! The expressions of proofs and verdicts are in a separate arena, apart from the expressions of the
//! equations that are shown and run. So the contents of a publication can never change the derivation.

use crate::code::{Code, CodePreparation, compiled_code, interpreted_code};
use crate::error::Error;
use crate::mechanism::Mechanism;
use tripos_derive::diagnostic::Diagnostics;
use tripos_derive::diff::{Difference, judge_publication, printed_equations};
use tripos_derive::mechanics::{Derivation, Derivations, EquationsOrigin, derive_all};
use tripos_derive::prove::{Proof, Singularity, prove, singularity, singularity_of_determinant};
use tripos_derive::publication::{Publication, load_publication_of_model};
use tripos_derive::{Equations, Formulation, Model};

/// Results of the analysis of a model without a run: equations, proofs, singular configurations and
/// publication.
pub struct ModelAnalysis {
    /// Derived equations of the model, with the arena that contains all expressions of the analysis.
    pub derivations: Derivations,
    /// Proved statements about the model, such as the equivalence of formulations.
    pub proof: Proof,
    /// Singular configurations of the mass matrix of each formulation. Formulations whose matrix is too
    /// large are left out.
    pub singular: Vec<(Formulation, Singularity)>,
    /// Publication beside the model file, with its judgement. `None` if there is no publication file, or if
    /// it has errors.
    pub published: Option<JudgedPublication>,
}

/// Origin of a printed system of equations, with its runnable code or the reason why it cannot run.
pub type PrintedSystem = (EquationsOrigin, Result<Code, Error>);

/// Publication with the judgement of its printed equations and formulas.
pub struct JudgedPublication {
    /// Contents of the publication file.
    pub publication: Publication,
    /// Comparison of the printed formulas and equations with the derived ones.
    pub difference: Difference,
    /// Singular configurations of the matrix of each printed system, in the order of
    /// `difference.consequences`. `None` if the determinant of the matrix is not known, as for large
    /// matrices.
    pub singular: Vec<Option<Singularity>>,
    /// Printed systems as equations of motion that can be run, in the order of the publication.
    pub printed: Vec<Equations>,
}

impl ModelAnalysis {
    /// Derives the model by the standard formulations and by the formulations in `also`, and proves
    /// statements about it. Judges the publication beside the model file, if there is one.
    ///
    /// A publication file with errors is left out. The second value then has its errors; otherwise it is
    /// `None`.
    ///
    /// # Errors
    /// [`Error`] if the model cannot be derived.
    pub fn new(model: &Model, also: &[Formulation]) -> Result<(Self, Option<Diagnostics>), Error> {
        let mut with_publication = model.clone();
        let (publication, broken) = match load_publication_of_model(&model.source.path, &mut with_publication) {
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
        let published =
            publication.map(|publication| JudgedPublication::new(model, &mut derivations, &proof, publication));
        match &published {
            Some(published) => published.difference.write_names(&proof, &mut derivations),
            None => proof.write_names(&mut derivations),
        }
        Ok((Self { derivations, proof, singular, published }, broken))
    }

    /// Prepares the code of the printed systems, in the order of the publication. An error says why a
    /// system cannot run.
    #[must_use]
    pub fn printed_systems(&self, model: &Mechanism) -> Vec<PrintedSystem> {
        let Some(published) = &self.published else { return Vec::new() };
        let mut list = Vec::new();
        // The arena of expressions is copied only once, and only if equations have to be interpreted.
        let mut derivation: Option<Derivation> = None;
        for equations in &published.printed {
            let by = equations.by.clone();
            let code = match compiled_code(model, &by, None, CodePreparation::Solved) {
                Some(code) => Ok(code),
                None => {
                    let arena = || self.derivations.kinematics.arena.clone();
                    let derivation =
                        derivation.get_or_insert_with(|| Derivation { arena: arena(), equations: equations.clone() });
                    derivation.equations = equations.clone();
                    interpreted_code(model, &by, derivation, CodePreparation::AsDerived)
                }
            };
            list.push((by, code));
        }
        list
    }
}

impl JudgedPublication {
    /// Compares a publication with the derived equations of its model, and judges it.
    fn new(model: &Model, derivations: &mut Derivations, proof: &Proof, publication: Publication) -> Self {
        let difference = judge_publication(model, derivations, &publication, proof);
        let equations = printed_equations(model, derivations, &publication);
        let singular = difference.consequences.iter().map(|c| {
            let (printed, ..) = c.determinant.as_ref()?;
            let matrix = &printed_equations_of(&equations, &c.system)?.matrix;
            Some(singularity_of_determinant(model, &mut derivations.kinematics, matrix, *printed))
        });
        let singular = singular.collect();
        Self { publication, difference, singular, printed: equations }
    }

    /// Id of the first printed system that is proved to give the same accelerations as the system `id`. It
    /// is `id` itself if there is no earlier system with the same accelerations.
    #[must_use]
    pub fn first_equivalent_system<'a>(&'a self, id: &'a str) -> &'a str {
        let agreements = &self.difference.agreements;
        agreements.iter().find(|a| a.right == id && a.verdict.is_equal()).map_or(id, |a| &a.left)
    }
}

/// Finds the printed equations of the system with the given id; `None` if no system has it.
fn printed_equations_of<'a>(list: &'a [Equations], id: &str) -> Option<&'a Equations> {
    list.iter().find(|equations| equations.by.printed_id() == Some(id))
}
