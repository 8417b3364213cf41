//! The notations that formulas may be written in.

/// Notation in which formulas are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Notation {
    /// The language of model files.
    #[default]
    Tripos,
    /// LaTeX in math mode.
    Latex,
    /// Python, and the output of `SymPy`.
    Python,
    /// MATLAB and Octave.
    Matlab,
    /// C and C++.
    C,
}

impl Notation {
    /// All notations, in the order of every list of them.
    pub const ALL: [Self; 5] = [Self::Tripos, Self::Latex, Self::Python, Self::Matlab, Self::C];

    /// Name of the notation in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Tripos => "tripos",
            Self::Latex => "latex",
            Self::Python => "python",
            Self::Matlab => "matlab",
            Self::C => "c",
        }
    }

    /// Notation of this name; `sympy` is Python. `None` for an unknown name.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let name = if name == "sympy" { "python" } else { name };
        Self::ALL.into_iter().find(|notation| notation.name() == name)
    }
}
