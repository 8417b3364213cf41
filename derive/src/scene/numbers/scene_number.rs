//! Number in a scene or state file, with all its known digits.

use crate::algebra::Rational;
use crate::algebra::value::tape::Numeric;
use tripos_traits::DoubleDouble;

/// Number in a scene or state file: rounded to a double, to 32 digits, and exact if known.
#[derive(Clone, Debug)]
pub struct Number {
    /// The number rounded to a double.
    pub double: f64,
    /// Exact value. `None` if the number is not known as a rational number, such as √2.
    pub exact: Option<Rational>,
    /// Value to 32 digits; the double itself if no more digits are known.
    extended: DoubleDouble,
}

impl Number {
    /// Creates a number whose value is known exactly.
    pub fn exact(value: Rational) -> Self {
        Self { double: value.to_f64(), extended: DoubleDouble::from_rational(&value), exact: Some(value) }
    }

    /// Creates a number whose value is known only as a double.
    pub fn from_double(double: f64) -> Self {
        Self { double, exact: None, extended: double.into() }
    }

    /// Creates a number whose value is known to 32 digits.
    pub fn from_double_double(extended: DoubleDouble) -> Self {
        Self { double: extended.hi(), exact: None, extended }
    }

    /// Value to 32 digits; the double itself if no more digits are known.
    pub fn extended(&self) -> DoubleDouble {
        self.extended
    }
}

/// Values of numbers as doubles.
pub fn double_values(numbers: &[Number]) -> Vec<f64> {
    numbers.iter().map(|n| n.double).collect()
}

/// Values of numbers to 32 digits. A number with no more known digits than its double gives the double.
pub fn extended_values(numbers: &[Number]) -> Vec<DoubleDouble> {
    numbers.iter().map(Number::extended).collect()
}
