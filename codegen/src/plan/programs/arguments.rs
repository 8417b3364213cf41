//! Arguments and return values of a planned function, entry by entry.

/// Argument of a planned function, with variables for the entries that the function's body reads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Argument {
    /// Array of all parameters, in the order of the model.
    Parameters {
        /// Parameters that the body reads, each with its index in the model and its variable.
        read: Vec<(usize, String)>,
    },
    /// Array such as q or u, with a variable for each entry that the body reads.
    Array {
        /// Name of the array in the signature of the function.
        name: &'static str,
        /// Variable of each entry; `None` for an entry that the body does not read.
        entries: Vec<Option<String>>,
    },
    /// The time t, as a single number. The entry is its variable; `None` if the body does not read the time.
    Number(Option<String>),
}

impl Argument {
    /// Returns the name of the argument in the function's signature, such as `p`, `q` or `t`.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Parameters { .. } => "p",
            Self::Array { name, .. } => name,
            Self::Number(variable) => variable.as_deref().unwrap_or("t"),
        }
    }

    /// True if the body of the function reads at least one entry of the argument.
    #[must_use]
    pub fn is_read(&self) -> bool {
        match self {
            Self::Parameters { read } => !read.is_empty(),
            Self::Array { entries, .. } => entries.iter().any(Option::is_some),
            Self::Number(variable) => variable.is_some(),
        }
    }
}

/// Entry in the array that a planned function returns, or the number itself.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Entry {
    /// The entry is always 0, so it is not computed.
    Zero,
    /// The entry is the value of the variable with this name.
    Variable(String),
}
