//! Table of the formulations, with one row of properties for each method of derivation.

use super::gibbs_appell;
use super::kane;
use super::lagrange;
use super::newton_euler;
use crate::algebra::Expr;
use crate::mechanics::derive_error::DeriveError;
use crate::mechanics::motion::kinematics::{Kinematics, MotionVariables};
use crate::mechanics::rows::{Rows, Step};
use crate::model::{Model, MotionConstraint};

/// Method to derive equations of motion, such as Kane's. Each variant has a row in the table of
/// methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Formulation {
    /// Kane's method, in generalized speeds: F + F* = 0.
    Kane,
    /// Lagrange's equations, in coordinates q and rates q̇, with multipliers for motion constraints.
    Lagrange,
    /// Newton–Euler equations: force and moment balance of each body, with reactions.
    NewtonEuler,
    /// Gibbs–Appell equations, from the acceleration energy. They are derived only on request.
    GibbsAppell,
}

/// Properties of a method of derivation: its names, its variables, and the functions that derive
/// it.
pub struct FormulationProperties {
    /// Name of the method on the command line and in files, such as `kane`.
    pub name: &'static str,
    /// Name of the method in a heading, such as `Kane's method`.
    pub title: &'static str,
    /// Name of the method in a formula, such as `Kane = Wᵀ · Lagrange`.
    pub label: &'static str,
    /// Principle of the method in words, for the page. A formula may follow these words.
    pub principle: &'static str,
    /// System of equations of the method, in plain text. Index 0 is without motion constraints, index 1 with motion
    /// constraints.
    equation: [&'static str; 2],
    /// Kind of the motion variables that are integrated together with q: speeds u or rates q̇.
    pub variables: MotionVariables,
    /// True if the constraint reactions are among the unknowns of the equations.
    pub carries_reactions: bool,
    /// True if the matrix is symmetric by construction, and positive definite wherever it is regular.
    pub symmetric: bool,
    /// Function that derives the equations' rows (matrix, forcing, energy) from a model and its
    /// kinematics.
    pub derive: fn(&Model, &mut Kinematics) -> Result<Rows, DeriveError>,
    /// Function that derives the intermediate steps of the method, for display.
    pub steps: fn(&Model, &mut Kinematics) -> Result<Vec<Step>, DeriveError>,
}

/// Properties of all formulations, indexed by the order of the variants of `Formulation`.
static TABLE: [FormulationProperties; Formulation::ALL.len()] = [
    FormulationProperties {
        name: "kane",
        title: "Kane's method",
        label: "Kane",
        principle: "For each generalized speed the generalized active force and the generalized inertia force add to zero:",
        equation: ["M(q) u' = f(q, u)"; 2],
        variables: MotionVariables::Speeds,
        carries_reactions: false,
        symmetric: true,
        derive: kane::derive_kane,
        steps: kane::kane_steps,
    },
    FormulationProperties {
        name: "lagrange",
        title: "Lagrange's equations",
        label: "Lagrange",
        principle: "For each generalized coordinate",
        equation: ["E(q) q'' = A(q, q')", "[E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q'))"],
        variables: MotionVariables::Rates,
        carries_reactions: false,
        symmetric: true,
        derive: lagrange::derive_lagrange,
        steps: lagrange::lagrange_steps,
    },
    FormulationProperties {
        name: "newton-euler",
        title: "Newton–Euler equations",
        label: "Newton–Euler",
        principle: "For each body the forces give its mass times the acceleration of its mass centre, and the moments about \
                    the mass centre give the rate of its angular momentum; the reactions are unknowns beside the accelerations",
        equation: ["A(q, u) (u', reactions) = b(q, u)"; 2],
        variables: MotionVariables::Speeds,
        carries_reactions: true,
        symmetric: false,
        derive: newton_euler::derive_newton_euler,
        steps: newton_euler::newton_euler_steps,
    },
    FormulationProperties {
        name: "gibbs-appell",
        title: "Gibbs–Appell equations",
        label: "Gibbs–Appell",
        principle: "For each generalized speed the slope of the acceleration energy S along the rate of the speed is the \
                    generalized active force:",
        equation: ["M(q) u' = f(q, u)"; 2],
        variables: MotionVariables::Speeds,
        carries_reactions: false,
        symmetric: true,
        derive: gibbs_appell::derive_gibbs_appell,
        steps: gibbs_appell::gibbs_appell_steps,
    },
];

impl Formulation {
    /// All formulations, in the order in which every list shows them.
    pub const ALL: [Self; 4] = [Self::Kane, Self::Lagrange, Self::NewtonEuler, Self::GibbsAppell];

    /// Formulations that are derived if the user names none: the first entries of [`Self::ALL`]. Gibbs–Appell, the
    /// last, is derived only on request.
    pub const STANDARD: [Self; 3] = [Self::Kane, Self::Lagrange, Self::NewtonEuler];

    /// Properties of the formulation: its row in the table of methods.
    #[must_use]
    pub fn method(self) -> &'static FormulationProperties {
        &TABLE[self as usize]
    }

    /// System of equations that the formulation gives for this model, in plain text such as `M(q) u' = f(q, u)`.
    #[must_use]
    pub fn equation(self, model: &Model) -> &'static str {
        self.method().equation[usize::from(!model.motion_constraints.is_empty())]
    }

    /// Name of the formulation on the command line and in files, such as `kane`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.method().name
    }

    /// Name of the formulation in a heading, such as `Kane's method`.
    #[must_use]
    pub fn title(self) -> &'static str {
        self.method().title
    }

    /// Formulation with the given name on the command line; `None` if the name is unknown.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|f| f.name() == name)
    }

    /// True if the motion variables are the rates q̇; false if they are the generalized speeds u.
    #[must_use]
    pub fn is_in_rates(self) -> bool {
        self.method().variables == MotionVariables::Rates
    }

    /// True if the constraint reactions are among the unknowns of the equations.
    #[must_use]
    pub fn has_reactions(self) -> bool {
        self.method().carries_reactions
    }

    /// Formulation in the same motion variables and without reactions, to which this formulation leads if its
    /// reactions are eliminated. Returns `self` if this formulation has no reactions.
    #[must_use]
    pub fn without_reactions(self) -> Self {
        let alike = |f: &Self| f.method().variables == self.method().variables && !f.has_reactions();
        if self.has_reactions() { Self::ALL.into_iter().find(alike).unwrap_or(self) } else { self }
    }

    /// Symbols of the motion variables v of this formulation: the speeds u, or the rates q̇.
    #[must_use]
    pub fn variables(self, model: &Model) -> Vec<Expr> {
        match self.method().variables {
            MotionVariables::Speeds => model.u(),
            MotionVariables::Rates => model.q_dot(),
        }
    }

    /// Unknowns of the equations, as pairs of name and symbol. First come the accelerations v̇. Then come the
    /// reactions or, if v = q̇, the multipliers of the motion constraints.
    #[must_use]
    pub fn unknowns(self, model: &Model) -> Vec<(String, Expr)> {
        let rates = model.speeds.iter().map(|s| (format!("{}'", s.name), s.rate));
        let second = model.coordinates.iter().map(|c| (format!("{}''", c.name), c.second_rate));
        let mut unknowns: Vec<_> = match self.method().variables {
            MotionVariables::Speeds => rates.collect(),
            MotionVariables::Rates => second.collect(),
        };
        if self.has_reactions() {
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
