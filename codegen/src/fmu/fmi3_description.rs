//! Text of the file `modelDescription.xml` of a functional mock-up unit by FMI 3.0.

use super::functions::FmuFunctions;
use super::variables::{Role, Variable, Variables};
use super::xml_elements::{
    escape_xml_attribute, write_default_experiment_element, write_unit_definitions_element, xml_number,
};
use super::{fmu_instantiation_token, fmu_title};
use crate::languages::Module;
use std::fmt::Write;
use tripos_derive::scene::Scene;

/// Name of the XML element for an unknown at the start time. Its dependencies are not written, which means that it
/// may depend on all variables.
const INITIAL: &str = "InitialUnknown";

/// Returns the text of `modelDescription.xml` by FMI 3.0 for a scene. `identifier` is the name of
/// the unit's binary.
pub fn fmi3_description_text(
    identifier: &str,
    module: &Module<'_>,
    scene: &Scene,
    functions: &FmuFunctions,
    variables: &Variables,
) -> String {
    let has_slopes = functions.has_directional_derivatives(module.plan);
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let list = &variables.list;
    let _ = writeln!(
        out,
        "<fmiModelDescription fmiVersion=\"3.0\" modelName=\"{}\" instantiationToken=\"{}\" description=\"{}\" \
         generationTool=\"Tripos\" variableNamingConvention=\"flat\">",
        escape_xml_attribute(&fmu_title(module, scene)),
        fmu_instantiation_token(module, scene),
        escape_xml_attribute(&format!("{} {}", scene.about, module.origin))
    );
    let slopes =
        if has_slopes { " providesDirectionalDerivatives=\"true\" providesAdjointDerivatives=\"true\"" } else { "" };
    let states = "canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\"";
    let completed = if module.plan.has("constraints") { " needsCompletedIntegratorStep=\"true\"" } else { "" };
    let _ = writeln!(out, "  <ModelExchange modelIdentifier=\"{identifier}\" {states}{slopes}{completed}/>");
    let _ = writeln!(
        out,
        "  <CoSimulation modelIdentifier=\"{identifier}\" {states}{slopes} canHandleVariableCommunicationStepSize=\"true\"/>"
    );
    write_unit_definitions_element(&mut out, list);
    write_default_experiment_element(&mut out, scene);
    out.push_str("  <ModelVariables>\n");
    for variable in list {
        write_fmi3_variable_element(&mut out, variable);
    }
    out.push_str("  </ModelVariables>\n  <ModelStructure>\n");
    write_fmi3_model_structure(&mut out, list);
    out.push_str("  </ModelStructure>\n</fmiModelDescription>\n");
    out
}

/// Writes the XML element of one variable: name, value reference, role, unit, description and start
/// value.
fn write_fmi3_variable_element(out: &mut String, variable: &Variable) {
    let role = match variable.role {
        Role::Time => "causality=\"independent\" variability=\"continuous\"".to_owned(),
        Role::Parameter => "causality=\"parameter\" variability=\"tunable\"".to_owned(),
        Role::Input => "causality=\"input\" variability=\"continuous\"".to_owned(),
        Role::State(true) => "causality=\"output\" variability=\"continuous\" initial=\"exact\"".to_owned(),
        Role::State(false) => "causality=\"local\" variability=\"continuous\" initial=\"exact\"".to_owned(),
        Role::Derivative(of) => format!("causality=\"local\" variability=\"continuous\" derivative=\"{of}\""),
        Role::Output => "causality=\"output\" variability=\"continuous\"".to_owned(),
        Role::Indicator => "causality=\"local\" variability=\"continuous\"".to_owned(),
    };
    let _ = write!(
        out,
        "    <Float64 name=\"{}\" valueReference=\"{}\" {role}",
        escape_xml_attribute(&variable.name),
        variable.reference
    );
    if let Some(unit) = &variable.unit {
        let _ = write!(out, " unit=\"{}\"", escape_xml_attribute(&unit.to_string()));
    }
    if !variable.about.is_empty() {
        let _ = write!(out, " description=\"{}\"", escape_xml_attribute(&variable.about));
    }
    if let Some(start) = variable.start {
        let _ = write!(out, " start=\"{}\"", xml_number(start));
    }
    out.push_str("/>\n");
}

/// Writes the XML list of outputs, state derivatives and event indicators, each with the variables
/// on which it depends.
fn write_fmi3_model_structure(out: &mut String, list: &[Variable]) {
    let mut unknown = |element: &str, variable: &Variable| {
        let _ = write!(out, "    <{element} valueReference=\"{}\"", variable.reference);
        if let Some(depends_on) = variable.depends_on.as_ref().filter(|_| element != INITIAL) {
            let names: Vec<String> = depends_on.iter().map(ToString::to_string).collect();
            let _ = write!(out, " dependencies=\"{}\"", names.join(" "));
        }
        out.push_str("/>\n");
    };
    let of = |wanted: fn(&Role) -> bool| list.iter().filter(move |variable| wanted(&variable.role));
    for output in of(|role| matches!(role, Role::Output | Role::State(true))) {
        unknown("Output", output);
    }
    for derivative in of(|role| matches!(role, Role::Derivative(_))) {
        unknown("ContinuousStateDerivative", derivative);
    }
    for computed in of(|role| matches!(role, Role::Derivative(_) | Role::Output)) {
        unknown(INITIAL, computed);
    }
    for indicator in of(|role| matches!(role, Role::Indicator)) {
        unknown("EventIndicator", indicator);
    }
}
