//! Text of the file `modelDescription.xml` of a functional mock-up unit by FMI 2.0.

use super::functions::FmuFunctions;
use super::variables::{Role, Variable, Variables};
use super::xml_elements::{
    escape_xml_attribute, write_default_experiment_element, write_unit_definitions_element, xml_number,
};
use super::{fmu_instantiation_token, fmu_title};
use crate::languages::Module;
use std::fmt::Write;
use tripos_derive::scene::Scene;

/// Returns the text of `modelDescription.xml` by FMI 2.0 for a scene. `identifier` is the name of the unit's binary.
/// Indices of variables count from 1.
pub fn fmi2_description_text(
    identifier: &str,
    module: &Module<'_>,
    scene: &Scene,
    functions: &FmuFunctions,
    variables: &Variables,
) -> String {
    let has_slopes = functions.has_directional_derivatives(module.plan);
    let list = &variables.list;
    let mut out = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let indicators = list.iter().filter(|variable| variable.role == Role::Indicator).count();
    let _ = writeln!(
        out,
        "<fmiModelDescription fmiVersion=\"2.0\" modelName=\"{}\" guid=\"{}\" description=\"{}\" generationTool=\"Tripos\" \
         variableNamingConvention=\"flat\" numberOfEventIndicators=\"{indicators}\">",
        escape_xml_attribute(&fmu_title(module, scene)),
        fmu_instantiation_token(module, scene),
        escape_xml_attribute(&format!("{} {}", scene.about, module.origin))
    );
    let slopes = if has_slopes { " providesDirectionalDerivative=\"true\"" } else { "" };
    let states = "canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"true\"";
    let sources = format!(
        "<SourceFiles><File name=\"fmi2.c\"/><File name=\"{}_{}.c\"/></SourceFiles>",
        module.model_word, module.equations_word
    );
    let _ = writeln!(
        out,
        "  <ModelExchange modelIdentifier=\"{identifier}\" {states}{slopes}>{sources}</ModelExchange>\n  \
         <CoSimulation modelIdentifier=\"{identifier}\" {states}{slopes} \
         canHandleVariableCommunicationStepSize=\"true\">{sources}</CoSimulation>"
    );
    write_unit_definitions_element(&mut out, list);
    write_default_experiment_element(&mut out, scene);
    out.push_str("  <ModelVariables>\n");
    for variable in list {
        write_fmi2_variable_element(&mut out, variable);
    }
    out.push_str("  </ModelVariables>\n  <ModelStructure>\n");
    let of = |wanted: fn(&Role) -> bool| list.iter().filter(move |variable| wanted(&variable.role));
    let outputs: Vec<_> = of(|role| matches!(role, Role::Output | Role::State(true))).collect();
    let derivatives: Vec<_> = of(|role| matches!(role, Role::Derivative(_))).collect();
    let computed: Vec<_> = of(|role| matches!(role, Role::Derivative(_) | Role::Output)).collect();
    write_fmi2_unknowns(&mut out, "Outputs", &outputs, Dependencies::Stated);
    write_fmi2_unknowns(&mut out, "Derivatives", &derivatives, Dependencies::Stated);
    write_fmi2_unknowns(&mut out, "InitialUnknowns", &computed, Dependencies::LeftOut);
    out.push_str("  </ModelStructure>\n</fmiModelDescription>\n");
    out
}

/// Writes the XML element of one variable: name, value reference, role, unit, description and start
/// value.
fn write_fmi2_variable_element(out: &mut String, variable: &Variable) {
    let (causality, variability, initial) = match variable.role {
        Role::Time => ("independent", "continuous", ""),
        Role::Parameter => ("parameter", "tunable", " initial=\"exact\""),
        Role::Input => ("input", "continuous", ""),
        Role::State(true) => ("output", "continuous", " initial=\"exact\""),
        Role::State(false) => ("local", "continuous", " initial=\"exact\""),
        Role::Derivative(_) | Role::Indicator => ("local", "continuous", " initial=\"calculated\""),
        Role::Output => ("output", "continuous", " initial=\"calculated\""),
    };
    let about = if variable.about.is_empty() {
        String::new()
    } else {
        format!(" description=\"{}\"", escape_xml_attribute(&variable.about))
    };
    let _ = write!(
        out,
        "    <ScalarVariable name=\"{}\" valueReference=\"{}\" causality=\"{causality}\" \
         variability=\"{variability}\"{initial}{about}><Real",
        escape_xml_attribute(&variable.name),
        variable.reference
    );
    if let Some(unit) = &variable.unit {
        let _ = write!(out, " unit=\"{}\"", escape_xml_attribute(&unit.to_string()));
    }
    if let Some(start) = variable.start {
        let _ = write!(out, " start=\"{}\"", xml_number(start));
    }
    if let Role::Derivative(of) = variable.role {
        let _ = write!(out, " derivative=\"{}\"", of + 1);
    }
    out.push_str("/></ScalarVariable>\n");
}

/// Choice between stating and leaving out the variables on which each unknown depends.
#[derive(Clone, Copy, PartialEq)]
enum Dependencies {
    /// The dependencies of an unknown are written if they are known.
    Stated,
    /// No dependencies are written, which means that an unknown may depend on all variables.
    LeftOut,
}

/// Writes an XML list of unknowns with the element name `name`, or nothing if the list is empty.
fn write_fmi2_unknowns(out: &mut String, name: &str, list: &[&Variable], dependencies: Dependencies) {
    if list.is_empty() {
        return;
    }
    let _ = writeln!(out, "    <{name}>");
    for variable in list {
        let _ = write!(out, "      <Unknown index=\"{}\"", variable.reference + 1);
        if let Some(depends_on) = variable.depends_on.as_ref().filter(|_| dependencies == Dependencies::Stated) {
            let places: Vec<String> = depends_on.iter().map(|reference| (reference + 1).to_string()).collect();
            let _ = write!(out, " dependencies=\"{}\"", places.join(" "));
        }
        out.push_str("/>\n");
    }
    let _ = writeln!(out, "    </{name}>");
}
