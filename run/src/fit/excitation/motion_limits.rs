//! Limits of coordinates, rates and second rates: from the domain of the model, and from the user.

use super::QuantityLimit;
use crate::code::compile_tape;
use crate::{Error, Mechanism};
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::calculus::{Substitution, expand_names};
use tripos_derive::algebra::value::positive_range::positive_range;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::diagnostic::nearest_name_advice;

/// Bound of a quantity, with the place that states it.
#[derive(Clone, Debug)]
pub struct Bound {
    /// Value of the bound, in the unit of the quantity; infinite without a bound.
    pub value: f64,
    /// Place that states the bound, in words.
    pub source: String,
}

/// Limits of a quantity: its least and its largest value.
#[derive(Clone, Debug)]
pub struct Range {
    /// Lower bound.
    pub low: Bound,
    /// Upper bound.
    pub high: Bound,
}

impl Range {
    /// Range of all numbers.
    fn everything() -> Self {
        let none = |value: f64| Bound { value, source: String::new() };
        Self { low: none(f64::NEG_INFINITY), high: none(f64::INFINITY) }
    }

    /// Restricts the range to values from `low` to `high`, which `source` states.
    fn restrict(&mut self, low: f64, high: f64, source: &str) {
        if low > self.low.value {
            self.low = Bound { value: low, source: source.to_owned() };
        }
        if high < self.high.value {
            self.high = Bound { value: high, source: source.to_owned() };
        }
    }
}

/// Limits of a coordinate, of its rate and of its second rate.
pub type CoordinateRanges = [Range; 3];

/// Limits of all motions of a mechanism.
pub struct MotionLimits {
    /// Limits of each coordinate and of its derivatives, in the order of the model.
    pub ranges: Vec<CoordinateRanges>,
    /// Conditions of the domain that are no limits of a single quantity, as (name, tape). The tape computes a number
    /// that must be positive, from parameters, coordinates and generalized speeds.
    pub conditions: Vec<(String, Tape)>,
    /// Names of conditions of the domain that a motion alone does not decide, since they contain reactions or inputs.
    pub unchecked: Vec<String>,
}

/// Meaning of a condition of the domain for motions.
enum Meaning {
    /// Limits of a coordinate or of a rate: (index of the coordinate, order of the derivative, low, high).
    Limits(usize, usize, f64, f64),
    /// Condition for several quantities.
    Condition(Tape),
    /// Condition that a motion alone does not decide.
    Unchecked,
}

impl MotionLimits {
    /// Collects the limits of the domain and of the user. `coordinate_of` has the index of the coordinate of which each
    /// generalized speed is the rate, and `p` the values of the parameters.
    ///
    /// # Errors
    /// [`Error::Request`] if a name is unknown, if a limit is NaN, if a coordinate has no limits, or if limits exclude
    /// one another.
    pub fn new(model: &Mechanism, coordinate_of: &[usize], p: &[f64], given: &[QuantityLimit]) -> Result<Self, Error> {
        let ranges = model.coordinates.iter().map(|_| [(); 3].map(|()| Range::everything())).collect();
        let mut limits = Self { ranges, conditions: Vec::new(), unchecked: Vec::new() };
        for condition in &model.domain {
            match meaning_of_condition(model, coordinate_of, p, condition.positive)? {
                Meaning::Limits(at, order, low, high) => {
                    limits.ranges[at][order].restrict(low, high, &format!("the condition `{}`", condition.name));
                }
                Meaning::Condition(tape) => limits.conditions.push((condition.name.clone(), tape)),
                Meaning::Unchecked => limits.unchecked.push(condition.name.clone()),
            }
        }
        for limit in given {
            let (at, order) = quantity_of_name(model, coordinate_of, &limit.name)?;
            check_limit(limit)?;
            limits.ranges[at][order].restrict(limit.low, limit.high, &format!("the limit of `{}`", limit.name));
        }
        limits.check(model)?;
        Ok(limits)
    }

    /// Checks that each coordinate has limits, and that the limits leave room.
    ///
    /// # Errors
    /// [`Error::Request`] for the first coordinate of which the limits are wrong.
    fn check(&self, model: &Mechanism) -> Result<(), Error> {
        for (coordinate, ranges) in model.coordinates.iter().zip(&self.ranges) {
            let name = &coordinate.name;
            for (range, primes) in ranges.iter().zip(["", "'", "''"]) {
                let (low, high) = (&range.low, &range.high);
                if low.value > high.value {
                    let what = format!(
                        "the limits of `{name}{primes}` exclude one another: at least {} by {}, at most {} by {}",
                        low.value, low.source, high.value, high.source
                    );
                    return Err(Error::request(what, "change one of the two limits"));
                }
            }
            let [position, rates @ ..] = ranges;
            let is_limited = [&position.low, &position.high].map(|bound| bound.value.is_finite());
            if !(is_limited[0] && is_limited[1]) {
                let missing = match is_limited {
                    [false, false] => "no limits",
                    [false, true] => "no lower limit",
                    _ => "no upper limit",
                };
                let what = format!("the coordinate `{name}` has {missing}");
                let help = format!("state them, as in `--limit {name}=-1:1`, or in [domain] of the model");
                return Err(Error::request(what, help));
            }
            for (range, primes) in rates.iter().zip(["'", "''"]) {
                if !(range.low.value < 0.0 && range.high.value > 0.0) {
                    let what = format!(
                        "the limits of `{name}{primes}` from {} to {} leave no room: a periodic motion needs both signs",
                        range.low.value, range.high.value
                    );
                    let help = format!("give a range that contains 0, as in `--limit \"{name}{primes}=2\"`");
                    return Err(Error::request(what, help));
                }
            }
        }
        Ok(())
    }
}

/// Checks that both ends of a limit are numbers, and that the lower end is not above the upper one. Infinite ends stand
/// for no limit.
///
/// # Errors
/// [`Error::Request`] otherwise.
fn check_limit(limit: &QuantityLimit) -> Result<(), Error> {
    let QuantityLimit { name, low, high } = limit;
    if low.is_nan() || high.is_nan() {
        let what = format!("the limits of `{name}`, {low} and {high}, are not both numbers");
        return Err(Error::request(what, "give numbers, and an infinite one for a side without a limit"));
    }
    if low > high {
        let what = format!("the limits of `{name}` exclude one another: {low} is above {high}");
        return Err(Error::request(what, "give the lower limit first"));
    }
    Ok(())
}

/// Index of the coordinate, and order of the derivative, that a name of a limit means: `q1`, `q1'`, `q1''`, or a
/// generalized speed `u1` or its rate `u1'`.
///
/// # Errors
/// [`Error::Request`] if there is no such quantity.
fn quantity_of_name(model: &Mechanism, coordinate_of: &[usize], name: &str) -> Result<(usize, usize), Error> {
    let of_coordinates = model.coordinates.iter().enumerate().flat_map(|(at, coordinate)| {
        [(0, ""), (1, "'"), (2, "''")].map(|(order, primes)| (format!("{}{primes}", coordinate.name), (at, order)))
    });
    let of_speeds = model.speeds.iter().zip(coordinate_of).flat_map(|(speed, at)| {
        [(1, ""), (2, "'")].map(|(order, primes)| (format!("{}{primes}", speed.name), (*at, order)))
    });
    let known: Vec<(String, (usize, usize))> = of_coordinates.chain(of_speeds).collect();
    known.iter().find(|(known, _)| *known == name).map(|(_, quantity)| *quantity).ok_or_else(|| {
        let help = nearest_name_advice(name, known.iter().map(|(name, _)| name.as_str()));
        Error::request(format!("there is no coordinate, speed or rate `{name}` to limit"), help)
    })
}

/// Finds the meaning of a condition of the domain, of which the term `positive` must be positive.
///
/// # Errors
/// [`Error::Request`] if a term contains a symbol without a value.
fn meaning_of_condition(
    model: &Mechanism,
    coordinate_of: &[usize],
    p: &[f64],
    positive: Expr,
) -> Result<Meaning, Error> {
    let mut arena = model.arena.clone();
    let positive = expand_names(&mut arena, positive);
    // Rates of coordinates become the speeds that are equal to them.
    let rates: Vec<(Expr, Expr)> =
        model.speeds.iter().zip(coordinate_of).map(|(speed, at)| (model.coordinates[*at].rate, speed.symbol)).collect();
    let positive = Substitution::new(&rates).apply(&mut arena, positive);
    let known = [model.p(), model.q(), model.u()].concat();
    let inputs: Vec<Expr> = model.parameters.iter().filter(|p| p.is_input).map(|p| p.symbol).collect();
    let parts = arena.reachable(&[positive]);
    let mut symbols = parts.iter().filter(|part| arena.symbol_name(**part).is_some());
    if symbols.any(|symbol| !known.contains(symbol) || inputs.contains(symbol)) {
        return Ok(Meaning::Unchecked);
    }
    let coordinates = model.coordinates.iter().enumerate().map(|(at, c)| (c.symbol, at, 0));
    let speeds = model.speeds.iter().zip(coordinate_of).map(|(speed, at)| (speed.symbol, *at, 1));
    let mentioned: Vec<(Expr, usize, usize)> =
        coordinates.chain(speeds).filter(|(symbol, ..)| parts.binary_search(symbol).is_ok()).collect();
    let values: Vec<(Expr, f64)> = model.p().into_iter().zip(p.iter().copied()).collect();
    if let [(symbol, at, order)] = mentioned.as_slice()
        && let Some((low, high)) = positive_range(&mut arena, &values, positive, *symbol)
    {
        return Ok(Meaning::Limits(*at, *order, low, high));
    }
    let what = "a condition of the domain";
    Ok(Meaning::Condition(compile_tape(&arena, &known, &[positive], what)?))
}
