//! Kane's equations of a model whose bodies have inertial parameters other than the stated ones, such as base
//! parameters.

use super::derivation::derive_with;
use super::derive_error::DeriveError;
use super::equations::Equations;
use super::formulations::formulation::Formulation;
use super::motion::equation_form::EquationForm;
use super::motion::inertial_anchor::Anchor;
use super::motion::inertial_parameter::InertialParameter;
use super::motion::kinematics::Kinematics;
use super::motion::placed_inertia::PlacedInertia;
use crate::algebra::{Arena, Expr};
use crate::model::Model;

/// Derives Kane's equations of a model, in named steps, for bodies with the given inertial parameters. Parameters that
/// are not given are zero. Inertial parameters refer to the bodies' anchors ([`Anchor`]). T, V and the power keep the
/// stated inertias.
///
/// # Errors
/// Returns a [`DeriveError`] if the model cannot be derived, if a body has an added mass, or if the inverse dynamics is
/// not proved.
pub(crate) fn equations_with_inertial_parameters(
    model: &Model,
    parameters: &[(usize, InertialParameter, Expr)],
) -> Result<(Arena, Equations), DeriveError> {
    if let Some(added) = model.added_masses.first() {
        return Err(DeriveError::AddedMass { body: model.bodies[added.body].name.clone() });
    }
    // Energies, power and constraints have the form in which the model is computed.
    let mut kinematics = Kinematics::new(model)?;
    let stated = derive_with(model, &mut kinematics, Formulation::Kane)?;
    let model = &Model { arena: kinematics.arena, ..model.clone() };
    let mut kinematics = Kinematics::in_form(model, EquationForm::Steps)?;
    let mut bodies: Vec<PlacedInertia> =
        (0..model.bodies.len()).map(|at| PlacedInertia::empty_at(&Anchor::of(model, at))).collect();
    for (body, parameter, value) in parameters {
        bodies[*body].add(&mut kinematics.arena, *parameter, *value);
    }
    let system = kinematics.kane_system_of(model, &bodies);
    let Kinematics { mut arena, mut simplifier, .. } = kinematics;
    let mut equations =
        Equations { matrix: system.matrix, forcing: system.forcing, required: system.required, gauss: None, ..stated };
    for e in equations.matrix.iter_mut().flatten().chain(&mut equations.forcing) {
        *e = simplifier.simplify(&mut arena, *e);
    }
    let equations =
        equations.with_certified_inverse_dynamics(&mut arena).map_err(|why| DeriveError::Unsolved(why.into()))?;
    Ok((arena, equations))
}
