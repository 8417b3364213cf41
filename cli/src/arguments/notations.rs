//! Notations and forms in which commands print formulas.

use clap::ValueEnum;

/// Notation of formulas in a document.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// The language of model files
    Text,
    /// A document of LaTeX
    Latex,
    /// Markdown, with formulas as GitHub shows them
    Markdown,
    /// A document of Typst
    Typst,
    /// A program in Python that defines the equations for SymPy
    Sympy,
    /// `MathML` for web pages
    Mathml,
    /// Text inside JSON
    Json,
}

/// Form of printed equations.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Form {
    /// Every formula written out
    Closed,
    /// Terms that grow have names, and each formula contains the names before it
    Steps,
}

/// Language of a printed linear system.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Notation {
    /// Words and tables
    Text,
    /// `NumPy` arrays
    Python,
    /// Matrices, and a model of the Control System Toolbox where there are inputs and outputs
    Matlab,
    /// Matrices for a document with amsmath
    Latex,
}

/// Format of a certificate of proofs.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum CertificateFormat {
    /// Lines of JSON, which the checkers in `tests/certificate` read
    Lines,
    /// Lemmas for Coq, as far as their identities are short
    Coq,
    /// The same lemmas for Lean 4 with Mathlib; Tripos's tests do not run Lean
    Lean,
}
