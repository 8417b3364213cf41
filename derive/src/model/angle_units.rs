//! Angle units: decides whether a dimensionless term, or a term in 1/s, is an angle (rad, °) or its
//! rate.

use super::{Model, Unit};
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::FxHashMap;

/// Names of derived units of mechanics, by their exponents of m, kg and s.
const NAMED: [([i64; 3], &str); 3] = [([1, 1, -2], "N"), ([2, 1, -2], "N*m"), ([2, 1, -3], "W")];

/// Measure in which an angle or its rate is expressed: radians, or radians divided by π.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Measure {
    /// Angle in radians.
    Radians,
    /// Angle in radians divided by π. Multiplied by 180, it is in degrees.
    HalfTurns,
}

/// Role of a term in a unit label: a multiple of an angle, a constant, or neither.
#[derive(Clone, Debug)]
enum Kind {
    /// Multiple of an angle: the measure of the angle, and the constant factor of the multiple.
    Angle(Measure, Rational),
    /// Constant term: it contains no coordinate, no speed and no rate of one.
    Constant,
    /// Any other term: neither a multiple of an angle nor a constant.
    Other,
}

impl Model {
    /// Unit of a term as a label for an axis or a column: `rad`, `rad/s`, `°`, `m`, `N`, …. A multiple
    /// of an angle is in rad, q·180/π is in °, and sin q is a plain number. `None` if the units of the
    /// term's parts do not fit or are not known.
    #[must_use]
    pub fn unit_label(&self, arena: &Arena, e: Expr) -> Option<String> {
        let unit = self.unit_of(arena, e)?;
        if let Some((_, name)) = NAMED.iter().find(|([m, kg, s], _)| unit == Unit::new(*m, *kg, *s)) {
            return Some((*name).to_owned());
        }
        if !unit.is_of_time() {
            return Some(unit.to_string());
        }
        let word = match self.angle_role(arena, e) {
            Kind::Angle(Measure::Radians, _) => "rad",
            Kind::Angle(Measure::HalfTurns, factor) if factor == Rational::integer(180) => "°",
            _ => return Some(unit.to_string()),
        };
        // `word` (an angle's unit) replaces the 1 that a plain number has as its unit.
        Some(unit.to_string().replacen('1', word, 1))
    }

    /// Role of a term in its unit label: a multiple of an angle, a constant, or neither. The role follows from the
    /// roles of the term's operands.
    fn angle_role(&self, arena: &Arena, e: Expr) -> Kind {
        let coordinates = self.coordinates.iter().map(|c| (vec![c.symbol, c.rate, c.second_rate], c.unit.is_plain()));
        let speeds = self.speeds.iter().map(|s| (vec![s.symbol, s.rate], s.unit.is_of_time()));
        let moving: Vec<(Vec<Expr>, bool)> = coordinates.chain(speeds).collect();
        let is_angle = |e: &Expr| moving.iter().find(|(symbols, _)| symbols.contains(e)).map(|(_, is_angle)| *is_angle);
        let mut kinds: FxHashMap<Expr, Kind> = FxHashMap::default();
        for part in arena.reachable(&[e]) {
            let kind = match arena.node(part) {
                Node::Symbol(_) => match is_angle(&part) {
                    Some(true) => Kind::Angle(Measure::Radians, Rational::ONE),
                    Some(false) => Kind::Other,
                    None => Kind::Constant,
                },
                Node::Number(_) | Node::Pi => Kind::Constant,
                Node::Named(_, term) => kinds[term].clone(),
                Node::Sum(_, terms) => {
                    angle_role_of_sum(terms.iter().map(|(term, factor)| (kinds[term].clone(), factor.clone())))
                }
                Node::Product(factors) => angle_role_of_product(factors.iter().map(|(base, n)| Factor {
                    base: arena.node(*base),
                    kind: kinds[base].clone(),
                    exponent: *n,
                })),
                Node::Apply(Function::Asin | Function::Acos | Function::Atan, _) => {
                    Kind::Angle(Measure::Radians, Rational::ONE)
                }
                Node::Apply(Function::Abs, argument) => kinds[argument].clone(),
                Node::Apply(_, argument) if matches!(kinds[argument], Kind::Constant) => Kind::Constant,
                Node::Apply(..) => Kind::Other,
            };
            kinds.insert(part, kind);
        }
        kinds.remove(&e).unwrap_or(Kind::Other)
    }
}

/// Role of a sum: an angle if all terms that are not constant are angles in the same measure. For degrees, these
/// terms must also have the same factor.
fn angle_role_of_sum(terms: impl Iterator<Item = (Kind, Rational)>) -> Kind {
    let mut found = Kind::Constant;
    for (kind, factor) in terms {
        found = match (found, kind) {
            (found, Kind::Constant) => found,
            (Kind::Constant, Kind::Angle(measure, own)) => Kind::Angle(measure, own.mul(&factor)),
            (Kind::Angle(measure, first), Kind::Angle(other, own)) if measure == other => {
                let is_same = own.mul(&factor) == first;
                Kind::Angle(measure, if is_same { first } else { Rational::ONE })
            }
            _ => return Kind::Other,
        };
    }
    found
}

/// Factor of a product: a base with an integer exponent.
struct Factor<'a> {
    /// Base of the power.
    base: &'a Node,
    /// Role of the base: a multiple of an angle, a constant, or neither.
    kind: Kind,
    /// Exponent of the power.
    exponent: i32,
}

/// Role of a product: an angle if exactly one factor is an angle and all other factors are constant.
fn angle_role_of_product<'a>(factors: impl Iterator<Item = Factor<'a>>) -> Kind {
    let (mut angle, mut per_pi) = (None, false);
    for Factor { base, kind, exponent } in factors {
        match kind {
            Kind::Constant if matches!(base, Node::Pi) && exponent == -1 => per_pi = true,
            Kind::Constant => {}
            Kind::Angle(Measure::Radians, factor) if exponent == 1 && angle.is_none() => angle = Some(factor),
            Kind::Angle(..) | Kind::Other => return Kind::Other,
        }
    }
    let measure = if per_pi { Measure::HalfTurns } else { Measure::Radians };
    angle.map_or(Kind::Constant, |factor| Kind::Angle(measure, factor))
}

#[cfg(test)]
mod tests {
    use crate::algebra::text::parse::parse;
    use crate::diagnostic::Source;
    use crate::model::load;

    const MODEL: &str = include_str!("pendulum.toml");

    /// Goal: the unit label is an angle unit only for angles. Method: formulas of the pendulum, in the model's names.
    #[test]
    fn angles_are_told_from_numbers() {
        let mut model = load(&Source::from_text("model.toml", MODEL)).unwrap_or_else(|e| panic!("{e}"));
        let q = model.coordinates.iter().find(|c| c.unit.to_string() == "1").expect("an angle").name.clone();
        let mut label = |formula: &str| {
            let text = formula.replace('Q', &q);
            let mut arena = std::mem::take(&mut model.arena);
            let e = parse(&mut arena, &text, &mut |arena, name| Ok(arena.symbol(name))).unwrap();
            let label = model.unit_label(&arena, e);
            model.arena = arena;
            label.unwrap_or_default()
        };
        for (formula, expected) in [
            ("Q", "rad"),
            ("2*Q + 1", "rad"),
            ("Q'", "rad/s"),
            ("Q*180/pi", "°"),
            ("Q'*180/pi", "°/s"),
            ("Q*90/pi", "1"),
            ("Q/pi", "1"),
            ("sin(Q)", "1"),
            ("Q^2", "1"),
            ("atan(Q)", "rad"),
            ("abs(Q)", "rad"),
            ("m*g", "N"),
            ("m*l", "kg*m"),
        ] {
            assert_eq!(label(formula), expected, "{formula}");
        }
    }
}
