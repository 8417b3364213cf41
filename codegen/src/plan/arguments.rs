//! Arguments and return values of a function, entry by entry.

/// An argument of a function, with the variables that its body has for what it reads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Argument {
    /// The parameters: their places in the model, and variables.
    Parameters {
        /// Those that are read.
        read: Vec<(usize, String)>,
    },
    /// An array, with a variable for each entry that is read.
    Array {
        /// Name of the array.
        name: &'static str,
        /// Its entries.
        entries: Vec<Option<String>>,
    },
    /// A number, by its variable; none if it is not read.
    Number(Option<String>),
}

impl Argument {
    /// Name of the argument in the signature.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Parameters { .. } => "p",
            Self::Array { name, .. } => name,
            Self::Number(variable) => variable.as_deref().unwrap_or("t"),
        }
    }

    /// True if the body reads any entry of it.
    #[must_use]
    pub fn is_read(&self) -> bool {
        match self {
            Self::Parameters { read } => !read.is_empty(),
            Self::Array { entries, .. } => entries.iter().any(Option::is_some),
            Self::Number(variable) => variable.is_some(),
        }
    }
}

/// An entry of what a function returns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Entry {
    /// It is 0 whatever the arguments are.
    Zero,
    /// The value of a variable.
    Variable(String),
}
