//! Derivatives in floating point, from the formula alone: a second opinion on symbolic ones.

use super::terms::{Angle, Term};

/// A value and its derivative by one symbol, each with the size of the largest terms that were added on the way.
#[derive(Clone, Copy, Debug)]
pub struct Slope {
    pub value: f64,
    pub rate: f64,
    pub sizes: (f64, f64),
}

impl Slope {
    fn new(value: f64, rate: f64) -> Self {
        Self { value, rate, sizes: (value.abs(), rate.abs()) }
    }

    fn add(self, other: Self) -> Self {
        let sizes = (self.sizes.0 + other.sizes.0, self.sizes.1 + other.sizes.1);
        Self { value: self.value + other.value, rate: self.rate + other.rate, sizes }
    }

    fn mul(self, other: Self) -> Self {
        let size = self.sizes.1 * other.sizes.0 + self.sizes.0 * other.sizes.1;
        Self {
            value: self.value * other.value,
            rate: self.rate * other.value + self.value * other.rate,
            sizes: (self.sizes.0 * other.sizes.0, size),
        }
    }

    /// 1/x; nothing where x is small, or small beside what it was added from.
    fn inverse(self) -> Option<Self> {
        let size = self.value.abs();
        if size < 0.01 || size < 0.01 * self.sizes.0 {
            return None;
        }
        let sizes = (self.sizes.0 / size.powi(2), self.sizes.1 * self.sizes.0 / size.powi(3));
        Some(Self { value: 1.0 / self.value, rate: -self.rate / self.value.powi(2), sizes })
    }
}

/// The value and the derivative by a symbol, at a state; nothing where a divisor is small.
pub fn slope(term: &Term, at: &dyn Fn(&str) -> f64, by: &str) -> Option<Slope> {
    let symbol = |name: &str| Slope::new(at(name), f64::from(u8::from(name == by)));
    let turn = |angle: &Angle| {
        let parts = angle.iter().map(|(name, n, d)| symbol(name).mul(Slope::new(*n as f64 / *d as f64, 0.0)));
        parts.fold(Slope::new(0.0, 0.0), Slope::add)
    };
    let sine = |x: Slope| Slope { sizes: (1.0, x.sizes.1), ..Slope::new(x.value.sin(), x.value.cos() * x.rate) };
    let cosine = |x: Slope| Slope { sizes: (1.0, x.sizes.1), ..Slope::new(x.value.cos(), -x.value.sin() * x.rate) };
    Some(match term {
        Term::Number(n, d) => Slope::new(*n as f64 / *d as f64, 0.0),
        Term::Symbol(name) => symbol(name),
        Term::Sine(angle) => sine(turn(angle)),
        Term::Cosine(angle) => cosine(turn(angle)),
        Term::Tangent(angle) => sine(turn(angle)).mul(cosine(turn(angle)).inverse()?),
        Term::Sum(terms) => {
            let mut sum = Slope::new(0.0, 0.0);
            for term in terms {
                sum = sum.add(slope(term, at, by)?);
            }
            sum
        }
        Term::Product(factors) => {
            let mut product = Slope::new(1.0, 0.0);
            for factor in factors {
                product = product.mul(slope(factor, at, by)?);
            }
            product
        }
        Term::Quotient(above, below) => slope(above, at, by)?.mul(slope(below, at, by)?.inverse()?),
        Term::Power(base, n) => {
            let base = slope(base, at, by)?;
            let base = if *n < 0 { base.inverse()? } else { base };
            (0..n.unsigned_abs()).fold(Slope::new(1.0, 0.0), |power, _| power.mul(base))
        }
        Term::Apply(..) => return None,
    })
}
