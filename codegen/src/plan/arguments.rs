//! Arguments and return values of a planned function, entry by entry.

/// Argument of a planned function, with variables for the entries that the body reads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Argument {
    /// Array of all parameters.
    Parameters {
        /// Parameters that the body reads, each with its index in the model and its variable.
        read: Vec<(usize, String)>,
    },
    /// Array with a variable for each entry that the body reads.
    Array {
        /// Name of the array.
        name: &'static str,
        /// Variable of each entry; `None` for an entry that is not read.
        entries: Vec<Option<String>>,
    },
    /// Number with its variable; `None` if it is not read.
    Number(Option<String>),
}

impl Argument {
    /// Name of the argument in the function's signature.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Parameters { .. } => "p",
            Self::Array { name, .. } => name,
            Self::Number(variable) => variable.as_deref().unwrap_or("t"),
        }
    }

    /// True if the body reads an entry of the argument.
    #[must_use]
    pub fn is_read(&self) -> bool {
        match self {
            Self::Parameters { read } => !read.is_empty(),
            Self::Array { entries, .. } => entries.iter().any(Option::is_some),
            Self::Number(variable) => variable.is_some(),
        }
    }
}

/// Entry of the values that a function returns.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Entry {
    /// The entry is 0 for all arguments.
    Zero,
    /// The entry is the value of this variable.
    Variable(String),
}
