//! Units of measurement in SI, and a check that all terms of a sum have the same unit.
//!
//! Quantities are declared in coherent SI units, so that no conversion can be forgotten. A radian counts as 1. A
//! plain number may be stated in other units, and is converted when it is read.

use crate::algebra::{Arena, Expr, Function, Node, Rational};
use crate::diagnostic::{nearest_name_advice, shortened_for_message};
use crate::toml_reader::Located;
use rustc_hash::FxHashMap;
use std::fmt;

/// Unit of measurement as rational exponents of metre, kilogram and second.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Unit {
    /// Exponents of the unit, in the order metre, kilogram, second.
    exponents: [Rational; 3],
}

/// Names of the base units, in the order of the exponents.
const BASE: [&str; 3] = ["m", "kg", "s"];
/// Names of SI units that declarations may state, each with its exponents of m, kg and s.
const NAMED: [(&str, [i64; 3]); 11] = [
    ("1", [0, 0, 0]),
    ("rad", [0, 0, 0]),
    ("m", [1, 0, 0]),
    ("kg", [0, 1, 0]),
    ("s", [0, 0, 1]),
    ("N", [1, 1, -2]),
    ("J", [2, 1, -2]),
    ("W", [2, 1, -3]),
    ("Pa", [-1, 1, -2]),
    ("Hz", [0, 0, -1]),
    ("sr", [0, 0, 0]),
];

/// Further units in which a plain number may be stated: name, exponents of m, kg and s, and factor to SI as a
/// fraction. The factors of the last three also contain π.
const NON_SI_UNITS: [(&str, [i64; 3], (i64, i64)); 16] = [
    ("mm", [1, 0, 0], (1, 1000)),
    ("cm", [1, 0, 0], (1, 100)),
    ("km", [1, 0, 0], (1000, 1)),
    ("g", [0, 1, 0], (1, 1000)),
    ("t", [0, 1, 0], (1000, 1)),
    ("ms", [0, 0, 1], (1, 1000)),
    ("min", [0, 0, 1], (60, 1)),
    ("h", [0, 0, 1], (3600, 1)),
    ("kN", [1, 1, -2], (1000, 1)),
    ("kJ", [2, 1, -2], (1000, 1)),
    ("kW", [2, 1, -3], (1000, 1)),
    ("kPa", [-1, 1, -2], (1000, 1)),
    ("MPa", [-1, 1, -2], (1_000_000, 1)),
    ("deg", [0, 0, 0], (1, 180)),
    ("rev", [0, 0, 0], (2, 1)),
    ("rpm", [0, 0, -1], (1, 30)),
];
/// Names of the units in [`NON_SI_UNITS`] whose factor to SI contains π.
const OF_TURNS: [&str; 3] = ["deg", "rev", "rpm"];

/// Unit that follows a number in a text, such as in `0.1 m`, `90 deg` and `3 rev/min`.
pub struct StatedUnit {
    /// The unit without its factor to SI, as exponents of metre, kilogram and second.
    pub unit: Unit,
    /// Factor to SI. The SI value is the number times this factor, times π to the power `turns`.
    pub factor: Rational,
    /// Exponent of π in the conversion to SI.
    pub turns: i32,
    /// Byte offset in the text at which the number ends.
    pub end: usize,
}

impl StatedUnit {
    /// Reads the unit at the end of a text, after a number and a space. `None` if the text does not end with a number
    /// and a unit.
    pub fn of(text: &str) -> Option<Self> {
        let (number, name) = text.trim_end().rsplit_once(char::is_whitespace)?;
        let end = number.trim_end().len();
        number.trim_end().ends_with(|c: char| c.is_ascii_digit() || c == '.' || c == ')').then_some(())?;
        let (mut unit, mut factor, mut turns) = (Unit::default(), Rational::ONE, 0);
        let mut sign = 1;
        for part in name.split_inclusive(['*', '/']) {
            let plain = part.trim_end_matches(['*', '/']);
            let (plain, power) = match plain.split_once('^') {
                Some((plain, power)) => (plain, power.parse::<i64>().ok().filter(|n| n.abs() <= 12)?),
                None => (plain, 1),
            };
            let power = sign * power;
            let (exponents, (above, below)) = match NAMED.iter().find(|(known, _)| *known == plain) {
                Some((_, exponents)) => (exponents, (1, 1)),
                None => NON_SI_UNITS
                    .iter()
                    .find(|(known, ..)| *known == plain)
                    .map(|(_, exponents, scale)| (exponents, *scale))?,
            };
            let [metre, kilogram, second] = exponents.map(|e| e * power);
            unit = unit.times(&Unit::new(metre, kilogram, second));
            let step = if power < 0 { Rational::fraction(below, above)? } else { Rational::fraction(above, below)? };
            for _ in 0..power.abs() {
                factor = factor.mul(&step);
            }
            if OF_TURNS.contains(&plain) {
                turns += i32::try_from(power).ok()?;
            }
            sign = if part.ends_with('/') { -1 } else { 1 };
        }
        Some(Self { unit, factor, turns, end })
    }

    /// Number in front of the unit in the text `formula`, with its place in the file.
    pub fn number_before_unit(&self, formula: &Located) -> Located {
        let range = 0..self.end;
        Located { text: formula.text[range.clone()].to_owned(), span: formula.part(range), exact: formula.exact }
    }

    /// SI value of a number that is stated in this unit, as a term.
    pub fn apply(&self, arena: &mut Arena, number: Expr) -> Expr {
        let pi = arena.pi();
        let turns = arena.pow(pi, self.turns).expect("π is not 0");
        let scaled = arena.scale(number, &self.factor);
        arena.mul(scaled, turns)
    }
}

impl Unit {
    /// Creates a unit with the given exponents of metre, kilogram and second.
    #[must_use]
    pub fn new(metre: i64, kilogram: i64, second: i64) -> Self {
        Self { exponents: [metre, kilogram, second].map(Rational::integer) }
    }

    /// Reads a unit such as `kg*m^2/s`, `N*m`, `rad` or `1`.
    ///
    /// # Errors
    /// Returns a message of one line if the text is no product or quotient of known units.
    pub fn parse(text: &str) -> Result<Self, String> {
        if text.trim().is_empty() {
            return Err("the unit is empty".to_owned());
        }
        let mut unit = Self::default();
        let mut sign = 1;
        for factor in text.split_inclusive(['*', '/']) {
            let (name, next) = match factor.chars().last() {
                Some('/') => (&factor[..factor.len() - 1], -1),
                Some('*') => (&factor[..factor.len() - 1], 1),
                _ => (factor, 1),
            };
            let (name, power) = match name.trim().split_once('^') {
                Some((name, power)) => {
                    let whole = power.trim().parse::<i64>().ok().filter(|n| n.abs() <= 12);
                    let message =
                        || format!("`{}` is not a whole exponent up to 12", shortened_for_message(power.trim()));
                    (name.trim(), whole.ok_or_else(message)?)
                }
                None => (name.trim(), 1),
            };
            let Some((_, exponents)) = NAMED.iter().find(|(n, _)| *n == name) else {
                return Err(format!("`{}` is not a unit known here", shortened_for_message(name)));
            };
            for (sum, e) in unit.exponents.iter_mut().zip(exponents) {
                *sum = sum.add(&Rational::integer(e * power * sign));
            }
            sign = next;
        }
        Ok(unit)
    }

    /// Exponents of metre, kilogram and second; `None` if an exponent is not an integer.
    #[must_use]
    pub fn whole_exponents(&self) -> Option<[i64; 3]> {
        let whole = |exponent: &Rational| exponent.small().filter(|(_, below)| *below == 1).map(|(above, _)| above);
        let [metre, kilogram, second] = &self.exponents;
        Some([whole(metre)?, whole(kilogram)?, whole(second)?])
    }

    /// Advice for a text that is not a unit. It suggests the nearest known unit.
    #[must_use]
    pub fn help(text: &str) -> String {
        let angle = ["deg", "degree", "degrees", "°"].contains(&text.trim());
        if angle {
            return "angles are in rad: write a value of 10 degrees as \"10*pi/180\"".to_owned();
        }
        let near = nearest_name_advice(text.trim(), NAMED.iter().map(|(name, _)| *name));
        let known = "units are SI: products, quotients and powers of kg, m, s, rad, N, J, W, Pa, Hz, or 1";
        if near.starts_with("did") && text.trim().len() > 1 { format!("{near} {known}") } else { known.to_owned() }
    }

    /// Name of the unit for error messages, such as `N*m` or `1 or rad`.
    #[must_use]
    pub fn unit_words(&self) -> String {
        match self {
            _ if self.is_plain() => "1 or rad".to_owned(),
            _ if *self == Self::new(1, 1, -2) => "N".to_owned(),
            _ if *self == Self::new(2, 1, -2) => "N*m".to_owned(),
            _ => self.to_string(),
        }
    }

    /// Unit with all exponents multiplied by k: that of the kth power of a quantity.
    fn unit_power(&self, k: &Rational) -> Self {
        Self { exponents: self.exponents.clone().map(|e| e.mul(k)) }
    }

    /// Unit of the product of two quantities that have the two units.
    #[must_use]
    pub fn times(&self, other: &Self) -> Self {
        let mut result = self.clone();
        for (sum, e) in result.exponents.iter_mut().zip(&other.exponents) {
            *sum = sum.add(e);
        }
        result
    }

    /// Unit of the quotient of two quantities that have the two units. It is also that of a derivative of the first
    /// quantity with respect to the second.
    #[must_use]
    pub fn divided_by(&self, other: &Self) -> Self {
        self.times(&other.unit_power(&Rational::integer(-1)))
    }

    /// Unit of the time derivative of a quantity with this unit.
    #[must_use]
    pub fn per_second(&self) -> Self {
        self.times(&Self::new(0, 0, -1))
    }

    /// Exponent of the kilogram in the unit.
    #[must_use]
    pub fn kilogram_exponent(&self) -> &Rational {
        &self.exponents[1]
    }

    /// Unit of the nth power of a quantity with this unit.
    #[must_use]
    pub fn to_power(&self, n: i32) -> Self {
        self.unit_power(&Rational::integer(i64::from(n)))
    }

    /// True if the unit is 1, the unit of plain numbers and angles.
    #[must_use]
    pub fn is_plain(&self) -> bool {
        *self == Self::default()
    }

    /// True if the unit is 1 or a power of a second. A term with such a unit may be an angle or a time derivative of
    /// one.
    #[must_use]
    pub(in crate::model) fn is_of_time(&self) -> bool {
        self.exponents[..2].iter().all(Rational::is_zero)
    }

    /// True if the unit is that of a length.
    #[must_use]
    pub fn is_length(&self) -> bool {
        *self == Self::new(1, 0, 0)
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let show = |name: &str, e: &Rational| if e.is_one() { name.to_owned() } else { format!("{name}^{e}") };
        let order = [1, 0, 2];
        let above: Vec<_> = order.iter().filter(|i| self.exponents[**i] > Rational::ZERO).collect();
        let below: Vec<_> = order.iter().filter(|i| self.exponents[**i] < Rational::ZERO).collect();
        let join = |list: &[&usize], sign: &Rational| {
            list.iter().map(|i| show(BASE[**i], &self.exponents[**i].mul(sign))).collect::<Vec<_>>().join("*")
        };
        let numerator = if above.is_empty() { "1".to_owned() } else { join(&above, &Rational::ONE) };
        f.write_str(&numerator)?;
        for i in below {
            write!(f, "/{}", show(BASE[*i], &self.exponents[*i].neg()))?;
        }
        Ok(())
    }
}

/// Unit of a term, from the units of its symbols. `Ok(None)` if the unit is indefinite: for the number 0, which fits
/// every unit, and for terms that contain a symbol without a unit. Such a symbol was reported when it was declared.
///
/// # Errors
/// Returns a message of one line, and advice, if the units of the term's parts do not fit.
pub fn unit_of(arena: &Arena, e: Expr, symbols: &FxHashMap<Expr, Unit>) -> Result<Option<Unit>, (String, String)> {
    let check = "check the units of the parameters and coordinates".to_owned();
    let show = |e: Expr| shortened_for_message(&crate::algebra::text::print::print_text(arena, e));
    let mut units: FxHashMap<Expr, Option<Unit>> = FxHashMap::default();
    for part in arena.reachable(&[e]) {
        let unit = match arena.node(part) {
            Node::Number(value) if value.is_zero() => None,
            Node::Number(_) | Node::Pi | Node::Apply(Function::Sign, _) => Some(Unit::default()),
            Node::Symbol(_) => symbols.get(&part).cloned(),
            Node::Named(_, term) => units[term].clone(),
            Node::Sum(constant, terms) => {
                let mut known = terms.iter().filter_map(|(term, _)| Some((*term, units[term].as_ref()?)));
                match known.next() {
                    None => None,
                    Some((first, unit)) => {
                        if let Some((term, other)) = known.find(|(_, other)| *other != unit) {
                            let (a, b) = (show(first), show(term));
                            let (unit, other) = (unit.unit_words(), other.unit_words());
                            let plain = [term, first].into_iter().find(|e| has_no_symbol(arena, *e));
                            let help = plain.map_or(check, |_| {
                                bare_number_advice(if other == "1 or rad" { &unit } else { &other })
                            });
                            return Err((
                                format!("`{a}` is in {unit} but `{b}` in {other}: they cannot be added"),
                                help,
                            ));
                        }
                        if !constant.is_zero() && !unit.is_plain() {
                            let words = unit.unit_words();
                            let message = format!("a bare number is added to `{}`, which is in {words}", show(first));
                            return Err((message, bare_number_advice(&words)));
                        }
                        Some(unit.clone())
                    }
                }
            }
            Node::Product(factors) => factors.iter().try_fold(Unit::default(), |product, (base, n)| {
                Some(product.times(&units[base].as_ref()?.unit_power(&Rational::integer(i64::from(*n)))))
            }),
            Node::Apply(Function::Sqrt, argument) => {
                let half = Rational::fraction(1, 2).expect("not zero");
                units[argument].as_ref().map(|unit| unit.unit_power(&half))
            }
            Node::Apply(Function::Abs, argument) => units[argument].clone(),
            Node::Apply(f, argument) => {
                if let Some(unit) = units[argument].as_ref().filter(|unit| !unit.is_plain()) {
                    let (f, inner) = (f.name(), show(*argument));
                    return Err((
                        format!("{f}({inner}) is the function of a quantity in {}", unit.unit_words()),
                        check,
                    ));
                }
                Some(Unit::default())
            }
        };
        units.insert(part, unit);
    }
    Ok(units.remove(&e).flatten())
}

/// True if a term contains no symbol.
fn has_no_symbol(arena: &Arena, e: Expr) -> bool {
    arena.reachable(&[e]).iter().all(|part| arena.symbol_name(*part).is_none())
}

/// Advice for a bare number in place of a quantity with the unit `unit`.
pub fn bare_number_advice(unit: &str) -> String {
    format!(
        "a bare number has no unit: declare a parameter such as `x0 = {{ unit = \"{unit}\", value = 0.1 }}` and use its name"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_multiply_and_print() {
        assert_eq!(Unit::parse("N*m").unwrap(), Unit::parse("kg*m^2/s^2").unwrap());
        assert_eq!(Unit::parse("N*s/m").unwrap().to_string(), "kg/s");
        assert_eq!(Unit::parse("m/s/s").unwrap(), Unit::parse("m/s^2").unwrap());
        assert!(Unit::parse("cm").is_err());
        assert!(Unit::parse("").is_err());
        assert!(Unit::parse("m^x").is_err());
    }

    #[test]
    fn numbers_are_converted() {
        let known = |text: &str| {
            let stated = StatedUnit::of(text)?;
            let mut arena = Arena::new();
            let one = arena.integer(1);
            let value = stated.apply(&mut arena, one);
            Some((
                text[..stated.end].to_owned(),
                crate::algebra::text::print::print_text(&arena, value),
                stated.unit.to_string(),
            ))
        };
        let of = |number: &str, value: &str, unit: &str| Some((number.to_owned(), value.to_owned(), unit.to_owned()));
        assert_eq!(known("90 deg"), of("90", "pi/180", "1"));
        assert_eq!(known("3 rpm"), of("3", "pi/30", "1/s"));
        assert_eq!(known("3 rev/min"), of("3", "pi/30", "1/s"));
        assert_eq!(known("7.8 g/cm^3"), of("7.8", "1000", "kg/m^3"));
        assert_eq!(known("(1/3) m "), of("(1/3)", "1", "m"));
        assert_eq!(known("2 * m"), None);
        assert_eq!(known("l + m"), None);
        assert_eq!(known("0.5"), None);
        assert_eq!(known("2 furlong"), None);
    }
}
