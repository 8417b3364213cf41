//! Number in a scene or state file, with all its known digits.

use crate::algebra::Rational;
use crate::algebra::value::tape::Numeric;
use tripos_traits::{Ball, DoubleDouble};

/// Number in a scene or state file: rounded to a double, to 32 digits, and exact if known.
#[derive(Clone, Debug)]
pub struct Number {
    /// The number rounded to a double.
    pub double: f64,
    /// Exact value. `None` if the number is not known as a rational number, such as √2.
    pub exact: Option<Rational>,
    /// Ball that contains the number. Its centre is the value to 32 digits, or the double itself if no more digits
    /// are known. Its radius is infinite if no bound on the error of the centre is known.
    enclosure: Ball,
}

impl Number {
    /// Creates a number whose value is known exactly.
    pub fn exact(value: Rational) -> Self {
        Self { double: value.to_f64(), enclosure: Ball::from_rational(&value), exact: Some(value) }
    }

    /// Creates a number that is the double itself, such as a number that a program gives.
    pub fn from_double(double: f64) -> Self {
        Self { double, exact: None, enclosure: Ball::point(double.into()) }
    }

    /// Creates a number of which only the nearest double is known.
    pub fn rounded(double: f64) -> Self {
        Self::from_double_double(double.into())
    }

    /// Creates a number whose value is known to 32 digits, without a bound on their error.
    pub fn from_double_double(extended: DoubleDouble) -> Self {
        Self::enclosed(Ball { centre: extended, radius: f64::INFINITY })
    }

    /// Creates a number that is known by a ball that contains it.
    pub fn enclosed(enclosure: Ball) -> Self {
        Self { double: enclosure.centre.hi(), exact: None, enclosure }
    }

    /// Value to 32 digits; the double itself if no more digits are known.
    pub fn extended(&self) -> DoubleDouble {
        self.enclosure.centre
    }

    /// Ball that contains the number; its radius is infinite if no bound is known.
    pub fn enclosure(&self) -> Ball {
        self.enclosure
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

/// Balls that contain numbers, each with 32 digits. The radius of a number without a known bound is infinite.
pub fn enclosed_values(numbers: &[Number]) -> Vec<Ball> {
    numbers.iter().map(Number::enclosure).collect()
}
