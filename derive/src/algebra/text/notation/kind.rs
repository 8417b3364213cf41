//! The notations that formulas may be written in.

/// A way to write formulas.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Notation {
    /// The language of model files.
    #[default]
    Tripos,
    /// LaTeX in math mode.
    Latex,
    /// Python, and what `SymPy` prints.
    Python,
    /// MATLAB and Octave.
    Matlab,
    /// C and C++.
    C,
}

impl Notation {
    /// All, in the order in which they are always listed.
    pub const ALL: [Self; 5] = [Self::Tripos, Self::Latex, Self::Python, Self::Matlab, Self::C];

    /// Its name in files.
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

    /// The notation of this name; `sympy` is Python.
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        let name = if name == "sympy" { "python" } else { name };
        Self::ALL.into_iter().find(|notation| notation.name() == name)
    }
}
