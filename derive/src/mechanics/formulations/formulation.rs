//! The formulations: each method of derivation is one row of a table.

use super::kane;
use super::lagrange;
use super::newton_euler;
use crate::algebra::Expr;
use crate::mechanics::error::DeriveError;
use crate::mechanics::motion::kinematics::Kinematics;
use crate::mechanics::rows::{Rows, Step};
use crate::model::{Model, MotionConstraint};

/// A method of derivation: a row of the table, by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Formulation {
    /// Kane's method.
    Kane,
    /// Lagrange's equations.
    Lagrange,
    /// Newton's and Euler's equations of each body.
    NewtonEuler,
}

/// Kind of the motion variables v of equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MotionVariables {
    /// The generalized speeds u.
    Speeds,
    /// The rates q̇ of the coordinates.
    Rates,
}

/// Properties of a method of derivation.
pub struct Method {
    /// The name on the command line and in files.
    pub name: &'static str,
    /// The name in a heading.
    pub title: &'static str,
    /// The name in a formula, such as `Kane = Wᵀ · Lagrange`.
    pub label: &'static str,
    /// Principle of the method, in words.
    pub principle: &'static str,
    /// Formula at the end of the principle, as presentation MathML without its row, then the addition for motion
    /// constraints. Empty if there is none.
    law: [&'static str; 2],
    /// The system that it gives, in plain text, without and with motion constraints.
    equation: [&'static str; 2],
    /// Variables that are integrated beside q.
    pub variables: MotionVariables,
    /// True if the reactions are among the unknowns.
    pub carries_reactions: bool,
    /// True if the matrix is symmetric by construction, and positive definite where it is regular.
    pub symmetric: bool,
    /// Derives the rows.
    pub derive: fn(&Model, &mut Kinematics) -> Result<Rows, DeriveError>,
    /// Derives the steps that lead to the rows, for display.
    pub steps: fn(&Model, &mut Kinematics) -> Result<Vec<Step>, DeriveError>,
}

static TABLE: [Method; Formulation::ALL.len()] = [
    Method {
        name: "kane",
        title: "Kane's method",
        label: "Kane",
        principle: "For each generalized speed the generalized active force and the generalized inertia force add to zero:",
        law: [
            "<msub><mi>F</mi><mi>r</mi></msub><mo>+</mo><msubsup><mi>F</mi><mi>r</mi><mo>⋆</mo></msubsup><mo>=</mo>\
              <mn>0</mn>",
            "",
        ],
        equation: ["M(q) u' = f(q, u)"; 2],
        variables: MotionVariables::Speeds,
        carries_reactions: false,
        symmetric: true,
        derive: kane::derive,
        steps: kane::steps,
    },
    Method {
        name: "lagrange",
        title: "Lagrange's equations",
        label: "Lagrange",
        principle: "For each generalized coordinate",
        law: [
            "<mfrac><mi mathvariant=\"normal\">d</mi><mrow>\
              <mi mathvariant=\"normal\">d</mi><mi>t</mi></mrow></mfrac><mfrac><mrow><mo form=\"prefix\">∂</mo><mi>T</mi>\
              </mrow><mrow><mo form=\"prefix\">∂</mo><msub><mover accent=\"true\"><mi>q</mi><mo>˙</mo></mover><mi>i</mi>\
              </msub></mrow></mfrac><mo>−</mo><mfrac><mrow><mo form=\"prefix\">∂</mo><mi>T</mi></mrow><mrow>\
              <mo form=\"prefix\">∂</mo><msub><mi>q</mi><mi>i</mi></msub></mrow></mfrac><mo>+</mo><mfrac><mrow>\
              <mo form=\"prefix\">∂</mo><mi>V</mi></mrow><mrow><mo form=\"prefix\">∂</mo><msub><mi>q</mi><mi>i</mi>\
              </msub></mrow></mfrac><mo>=</mo><msub><mi>Q</mi><mi>i</mi></msub>",
            "<mo>+</mo><munder><mo>∑</mo><mi>k</mi></munder><msub><mi>λ</mi><mi>k</mi></msub><mfrac><mrow>\
              <mo form=\"prefix\">∂</mo><msub><mi>c</mi><mi>k</mi></msub></mrow><mrow><mo form=\"prefix\">∂</mo><msub>\
              <mover accent=\"true\"><mi>q</mi><mo>˙</mo></mover><mi>i</mi></msub></mrow></mfrac>",
        ],
        equation: ["E(q) q'' = A(q, q')", "[E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q'))"],
        variables: MotionVariables::Rates,
        carries_reactions: false,
        symmetric: true,
        derive: lagrange::derive,
        steps: lagrange::steps,
    },
    Method {
        name: "newton-euler",
        title: "Newton–Euler equations",
        label: "Newton–Euler",
        principle: "For each body the forces give its mass times the acceleration of its mass centre, and the moments about \
                    the mass centre give the rate of its angular momentum; the reactions are unknowns beside the accelerations",
        law: [""; 2],
        equation: ["A(q, u) (u', reactions) = b(q, u)"; 2],
        variables: MotionVariables::Speeds,
        carries_reactions: true,
        symmetric: false,
        derive: newton_euler::derive,
        steps: newton_euler::steps,
    },
];

impl Formulation {
    /// All of them, in the order in which they are always listed.
    pub const ALL: [Self; 3] = [Self::Kane, Self::Lagrange, Self::NewtonEuler];

    /// Properties of the method, from the table.
    #[must_use]
    pub fn method(self) -> &'static Method {
        &TABLE[self as usize]
    }

    /// The system that it gives for this model, in plain text.
    #[must_use]
    pub fn equation(self, model: &Model) -> &'static str {
        self.method().equation[usize::from(!model.motion_constraints.is_empty())]
    }

    /// The law of the method, for this model, as presentation MathML; empty where words say it. The constraints c are
    /// functions of q and q̇ that are zero.
    #[must_use]
    pub fn law(self, model: &Model) -> String {
        let [law, of_constraints] = self.method().law;
        let of_constraints = if model.motion_constraints.is_empty() { "" } else { of_constraints };
        if law.is_empty() { String::new() } else { format!("<mrow>{law}{of_constraints}</mrow>") }
    }

    /// The name on the command line and in files.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.method().name
    }

    /// The name in a heading.
    #[must_use]
    pub fn title(self) -> &'static str {
        self.method().title
    }

    /// The formulation of this name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|f| f.name() == name)
    }

    /// True if the motion variables are the rates q̇, and not the speeds u.
    #[must_use]
    pub fn is_in_rates(self) -> bool {
        self.method().variables == MotionVariables::Rates
    }

    /// True if the reactions are among the unknowns.
    #[must_use]
    pub fn carries_reactions(self) -> bool {
        self.method().carries_reactions
    }

    /// The formulation in the same motion variables whose equations are left when the reactions are eliminated:
    /// itself if it has none.
    #[must_use]
    pub fn without_reactions(self) -> Self {
        let alike = |f: &Self| f.method().variables == self.method().variables && !f.carries_reactions();
        if self.carries_reactions() { Self::ALL.into_iter().find(alike).unwrap_or(self) } else { self }
    }

    /// The motion variables v.
    #[must_use]
    pub fn variables(self, model: &Model) -> Vec<Expr> {
        match self.method().variables {
            MotionVariables::Speeds => model.u(),
            MotionVariables::Rates => model.q_dot(),
        }
    }

    /// Unknowns of its equations, with names: v̇, then the reactions if the method carries them, and the multipliers of
    /// motion constraints where the rates of all coordinates are variables.
    #[must_use]
    pub fn unknowns(self, model: &Model) -> Vec<(String, Expr)> {
        let rates = model.speeds.iter().map(|s| (format!("{}'", s.name), s.rate));
        let second = model.coordinates.iter().map(|c| (format!("{}''", c.name), c.second_rate));
        let mut unknowns: Vec<_> = match self.method().variables {
            MotionVariables::Speeds => rates.collect(),
            MotionVariables::Rates => second.collect(),
        };
        if self.carries_reactions() {
            unknowns.extend(model.reactions.iter().map(|r| (r.name.clone(), r.symbol)));
        }
        if self.is_in_rates() {
            let name = |c: &MotionConstraint| model.arena.symbol_name(c.multiplier).unwrap_or_default().to_owned();
            let multiplier = |c: &MotionConstraint| (name(c), c.multiplier);
            unknowns.extend(model.motion_constraints.iter().map(multiplier));
        }
        unknowns
    }
}
