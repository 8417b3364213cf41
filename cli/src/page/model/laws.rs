//! Laws of the formulations, such as Lagrange's equation, as formulas of the page.

use tripos_derive::{Formulation, Model};

/// Law of a formulation, such as `F_r + F*_r = 0`, as MathML.
struct Law {
    /// Name of the formulation with this law, such as `kane`.
    formulation: &'static str,
    /// MathML of the law without constraints.
    formula: &'static str,
    /// MathML of the terms that motion constraints add to the law; empty if they add none.
    of_constraints: &'static str,
}

/// Laws of the formulations that have a law as a formula. The other formulations are described only in words.
const LAWS: [Law; 3] = [
    Law {
        formulation: "kane",
        formula: "<msub><mi>F</mi><mi>r</mi></msub><mo>+</mo><msubsup><mi>F</mi><mi>r</mi><mo>⋆</mo></msubsup><mo>=</mo>\
          <mn>0</mn>",
        of_constraints: "",
    },
    Law {
        formulation: "lagrange",
        formula: "<mfrac><mi mathvariant=\"normal\">d</mi><mrow>\
              <mi mathvariant=\"normal\">d</mi><mi>t</mi></mrow></mfrac><mfrac><mrow><mo form=\"prefix\">∂</mo><mi>T</mi>\
              </mrow><mrow><mo form=\"prefix\">∂</mo><msub><mover accent=\"true\"><mi>q</mi><mo>˙</mo></mover><mi>i</mi>\
              </msub></mrow></mfrac><mo>−</mo><mfrac><mrow><mo form=\"prefix\">∂</mo><mi>T</mi></mrow><mrow>\
              <mo form=\"prefix\">∂</mo><msub><mi>q</mi><mi>i</mi></msub></mrow></mfrac><mo>+</mo><mfrac><mrow>\
              <mo form=\"prefix\">∂</mo><mi>V</mi></mrow><mrow><mo form=\"prefix\">∂</mo><msub><mi>q</mi><mi>i</mi>\
              </msub></mrow></mfrac><mo>=</mo><msub><mi>Q</mi><mi>i</mi></msub>",
        of_constraints: "<mo>+</mo><munder><mo>∑</mo><mi>k</mi></munder><msub><mi>λ</mi><mi>k</mi></msub><mfrac><mrow>\
              <mo form=\"prefix\">∂</mo><msub><mi>c</mi><mi>k</mi></msub></mrow><mrow><mo form=\"prefix\">∂</mo><msub>\
              <mover accent=\"true\"><mi>q</mi><mo>˙</mo></mover><mi>i</mi></msub></mrow></mfrac>",
    },
    Law {
        formulation: "gibbs-appell",
        formula: "<mfrac><mrow><mo form=\"prefix\">∂</mo><mi>S</mi></mrow><mrow><mo form=\"prefix\">∂</mo><msub>\
              <mover accent=\"true\"><mi>u</mi><mo>˙</mo></mover><mi>r</mi></msub></mrow></mfrac><mo>=</mo><msub><mi>F</mi>\
              <mi>r</mi></msub>",
        of_constraints: "",
    },
];

/// Returns the MathML of a formulation's law for a model. Empty if the formulation has no formula. The letters c in the
/// formula are the motion constraints, functions of q and q̇ that are zero.
pub fn law(formulation: Formulation, model: &Model) -> String {
    let law = LAWS.iter().find(|law| law.formulation == formulation.name());
    law.map_or_else(String::new, |Law { formula, of_constraints, .. }| {
        let of_constraints = if model.motion_constraints.is_empty() { "" } else { of_constraints };
        format!("<mrow>{formula}{of_constraints}</mrow>")
    })
}
