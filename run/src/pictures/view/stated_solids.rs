//! Solids of a mechanism that the model file states in the table `[shapes]`.

use super::evaluate_parameters_only;
use super::solid::{Solid, SolidForm, SolidPlace};
use super::space::{Rotation, quaternion};
use crate::error::Error;
use crate::mechanism::Mechanism;
use tripos_derive::algebra::Expr;
use tripos_derive::model::{Shape, ShapeForm};

/// Thickness of a disk whose thickness is not stated, as a fraction of its radius.
const THIN: f64 = 0.04;

/// Makes the solids of the table `[shapes]` of the model file, at the given parameters.
///
/// # Errors
/// [`Error::Request`] if a length of a shape is not positive at these parameters.
pub fn stated_solids(mechanism: &Mechanism, parameters: &[f64]) -> Result<Vec<Solid>, Error> {
    let mut list = Vec::new();
    for shape in &mechanism.shapes {
        check_shape_lengths(mechanism, parameters, shape)?;
        let position = evaluate_parameters_only(mechanism, parameters, &shape.position, "a shape")?;
        let place = SolidPlace {
            position: [position[0], position[1], position[2]],
            ..SolidPlace::at(shape.frame, shape.point)
        };
        for form in forms_of_shape(mechanism, parameters, shape, place)? {
            list.push(Solid { label: shape.name.clone(), body: shape.body, touches: None, form });
        }
    }
    Ok(list)
}

/// Lists the expressions for the position and size of each solid in the table `[shapes]`, each with its key.
/// The keys `position` and `size` occur three times, `radius` and `length` once. Values that the model
/// file does not state are left out.
#[must_use]
pub fn stated_solid_lengths(mechanism: &Mechanism) -> Vec<Vec<(&'static str, Expr)>> {
    let of = |shape: &Shape| {
        let position = shape.position.iter().map(|component| ("position", *component));
        // In this list, the thickness of a disk is the length of a cylinder.
        let of_cylinder = |key| match key {
            "thickness" => "length",
            other => other,
        };
        let said = shape.form.lengths().into_iter().map(|(key, e)| (of_cylinder(key), e));
        let one: Vec<(&'static str, Expr)> = position.chain(said).collect();
        let count = if let ShapeForm::Line { through, .. } = &shape.form { through.len().saturating_sub(1) } else { 1 };
        vec![one; count]
    };
    mechanism.shapes.iter().flat_map(of).collect()
}

/// Checks that every length of a shape is positive and finite.
///
/// # Errors
/// `Error::Request` if a length is not positive and finite.
fn check_shape_lengths(mechanism: &Mechanism, parameters: &[f64], shape: &Shape) -> Result<(), Error> {
    for (key, length) in shape.form.lengths() {
        let value = evaluate_parameters_only(mechanism, parameters, &[length], "a shape")?[0];
        if value.is_nan() || value <= 0.0 || value.is_infinite() {
            let what = format!("the {key} of shape `{}` is {value} at the parameters of this scene", shape.name);
            return Err(Error::request(what, "what can be seen is longer than 0".to_owned()));
        }
    }
    Ok(())
}

/// Makes the forms of a shape at the given parameters: a rod for each piece of a line, otherwise one form.
///
/// # Errors
/// `Error::Request` if a size of the shape cannot be evaluated.
fn forms_of_shape(
    mechanism: &Mechanism,
    parameters: &[f64],
    shape: &Shape,
    at: SolidPlace,
) -> Result<Vec<SolidForm>, Error> {
    let number = |e: Expr| Ok::<f64, Error>(evaluate_parameters_only(mechanism, parameters, &[e], "a shape")?[0]);
    Ok(match &shape.form {
        ShapeForm::Sphere { radius } => vec![SolidForm::Sphere { at, radius: number(*radius)? }],
        ShapeForm::Disk { axis, radius, thickness } => {
            let radius = number(*radius)?;
            let length = thickness.map(number).transpose()?.unwrap_or(THIN * radius);
            vec![SolidForm::Cylinder { at: place_with_axis(at, *axis), radius, length }]
        }
        ShapeForm::Cylinder { axis, radius, length } => {
            vec![SolidForm::Cylinder {
                at: place_with_axis(at, *axis),
                radius: number(*radius)?,
                length: number(*length)?,
            }]
        }
        ShapeForm::Box { size } => {
            vec![SolidForm::Box { at, size: [number(size[0])?, number(size[1])?, number(size[2])?] }]
        }
        ShapeForm::Line { through, radius } => {
            let radius = radius.map(number).transpose()?.unwrap_or_default();
            through.windows(2).map(|ends| SolidForm::Rod { ends: [ends[0], ends[1]], radius }).collect()
        }
        ShapeForm::Ground { axis } => vec![SolidForm::Ground { at: place_with_axis(at, *axis) }],
    })
}

/// Turns a place so that its axis 3 lies along an axis (0 to 2) of the frame. The axes keep their cyclic
/// order.
fn place_with_axis(at: SolidPlace, axis: usize) -> SolidPlace {
    let mut columns: Rotation = [[0.0; 3]; 3];
    for (column, row) in [(0, (axis + 1) % 3), (1, (axis + 2) % 3), (2, axis)] {
        columns[row][column] = 1.0;
    }
    SolidPlace { turned: quaternion(&columns), ..at }
}
