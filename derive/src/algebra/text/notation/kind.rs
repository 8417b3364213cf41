//! Kinds of notation in which formulas may be written.

/// Notation in which the formulas of a file are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Notation {
    /// Formulas in the language of Tripos's model files.
    #[default]
    Tripos,
    /// Formulas in LaTeX math mode.
    Latex,
    /// Formulas in Python, including the output of `SymPy`.
    Python,
    /// Formulas in MATLAB and Octave.
    Matlab,
    /// Formulas in C and C++.
    C,
}

impl Notation {
    /// All notations, in the order in which they are listed everywhere.
    pub const ALL: [Self; 5] = [Self::Tripos, Self::Latex, Self::Python, Self::Matlab, Self::C];

    /// Name of the notation as files write it.
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

    /// Notation with the given name in files; `sympy` means Python. `None` for an unknown name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        let name = if name == "sympy" { "python" } else { name };
        Self::ALL.into_iter().find(|notation| notation.name() == name)
    }
}
