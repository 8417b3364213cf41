//! Isolation of an unknown: solution of one factor of an equation for one unknown.

use super::relation::{FactorSolutions, Relation, RelationCondition, RelationKind, Solution};
use super::workspace::{Role, Workspace};
use crate::algebra::form::ring_polynomial::RingPolynomial;
use crate::algebra::meaning::signs::Sign;
use crate::algebra::{Expr, Function, Rational};

/// Roots y of a y² + b y + d = 0, or of b y + d = 0 if a is 0; a, b and d are terms.
struct Roots {
    /// Values of the roots of the equation, one or two.
    values: Vec<Expr>,
    /// Coefficient by which the roots divide: a, or b if a is 0.
    divisor: Expr,
    /// Term under the square root, which must not be negative; `None` for a linear equation.
    root: Option<Expr>,
    /// Complexity of the roots: 0 for a linear equation, 1 with a square root.
    degree: u8,
}

impl Workspace<'_> {
    /// Solves the equation factor = 0 for the unknown `x`; `None` if the factor has none of the
    /// forms that can be solved.
    pub fn isolate(&mut self, factor: Expr, x: Expr) -> Option<FactorSolutions> {
        let (p, _) = self.fraction(factor)?;
        if let Some(found) = self.solve_waves(&p, x) {
            return Some(found);
        }
        let generators = self.generators_of(&p, x);
        let roles: Vec<Role> = generators
            .iter()
            .map(|at| self.normalizer.expression_of(*at))
            .collect::<Vec<_>>()
            .into_iter()
            .map(|e| self.role(e, x))
            .collect();
        match (roles.as_slice(), generators.as_slice()) {
            ([Role::Plain], [at]) => self.isolate_power(&p, *at, x),
            ([Role::Cosine(angle)], [at]) => self.isolate_sine_or_cosine(&p, *at, x, *angle, RelationKind::Cosine),
            ([Role::Sine(angle)], [at]) => self.isolate_sine_or_cosine(&p, *at, x, *angle, RelationKind::Sine),
            ([Role::Sine(a), Role::Cosine(b)], [sine, cosine]) if a == b => {
                self.isolate_sine_and_cosine(&p, [*sine, *cosine], x, *a)
            }
            ([Role::Cosine(b), Role::Sine(a)], [cosine, sine]) if a == b => {
                self.isolate_sine_and_cosine(&p, [*sine, *cosine], x, *a)
            }
            _ => None,
        }
    }

    /// Coefficients of a polynomial in one generator, the constant first, and the step between
    /// powers. `at` is the number of the generator. The step is 2 if only even powers occur, else 1.
    /// `None` if the degree exceeds two steps.
    fn powers(&mut self, p: &RingPolynomial, at: usize) -> Option<(Vec<Expr>, usize)> {
        let list = Self::coefficients(p, &[at]);
        let powers: Vec<usize> = list.keys().map(|powers| usize::from(powers.exponent_of(at))).collect();
        let step = if powers.iter().all(|n| n % 2 == 0) { 2 } else { 1 };
        let most = powers.iter().max()? / step;
        if most > 2 {
            return None;
        }
        let mut coefficients = vec![Expr::ZERO; 3];
        for (n, c) in powers.into_iter().zip(list.values()) {
            coefficients[n / step] = self.term(c);
        }
        Some((coefficients, step))
    }

    /// Roots of a polynomial of degree 2 at most, from its three coefficients, the constant first.
    /// `None` if the polynomial does not depend on the variable.
    fn quadratic_roots(&mut self, coefficients: &[Expr]) -> Option<Roots> {
        let [d, b, a] = *coefficients else { return None };
        if a == Expr::ZERO {
            let minus = self.arena.neg(d);
            return Some(Roots { values: vec![self.quotient(minus, b)?], divisor: b, root: None, degree: 0 });
        }
        let two = self.arena.integer(2);
        if b == Expr::ZERO {
            let minus = self.arena.neg(d);
            let square = self.quotient(minus, a)?;
            let root = self.root_of(square);
            let other = self.arena.neg(root);
            return Some(Roots { values: vec![root, other], divisor: a, root: Some(square), degree: 1 });
        }
        // (−b ± √(b² − 4 a d))/(2 a).
        let squared = self.arena.square(b);
        let product = self.arena.mul(a, d);
        let under = self.arena.linear_combination(&[(squared, Rational::ONE), (product, Rational::integer(-4))]);
        let under = self.short(under);
        let root = self.root_of(under);
        let below = self.arena.mul(two, a);
        let mut values = Vec::new();
        for sign in [Rational::ONE, Rational::MINUS_ONE] {
            let above = self.arena.linear_combination(&[(b, Rational::MINUS_ONE), (root, sign)]);
            let value = self.arena.div(above, below)?;
            values.push(self.short(value));
        }
        Some(Roots { values, divisor: a, root: Some(under), degree: 1 })
    }

    /// Solves a polynomial in the unknown, or in its square, for the unknown `x`. `None` if the
    /// degree in it exceeds 2.
    fn isolate_power(&mut self, p: &RingPolynomial, at: usize, x: Expr) -> Option<FactorSolutions> {
        let (coefficients, step) = self.powers(p, at)?;
        // If only even powers of x occur, the relation gives x², not two roots.
        if step == 2 {
            let Roots { values, divisor, root, degree } = self.quadratic_roots(&coefficients)?;
            let solutions = values.into_iter().filter_map(|value| {
                let solution = Solution {
                    relations: vec![Relation { unknown: x, kind: RelationKind::Square, angle: x, value }],
                    needs: root
                        .iter()
                        .map(|e| RelationCondition::NotNegative(*e))
                        .chain([RelationCondition::NotNegative(value)])
                        .collect(),
                };
                self.possible_isolation(solution)
            });
            return Some(FactorSolutions { solutions: solutions.collect(), divisor: Some(divisor), degree });
        }
        let Roots { values, divisor, root, degree } = self.quadratic_roots(&coefficients)?;
        let solutions = values.into_iter().filter_map(|value| {
            let needs = root.iter().map(|e| RelationCondition::NotNegative(*e)).collect();
            self.possible_isolation(Solution { relations: vec![Relation::value(x, value)], needs })
        });
        Some(FactorSolutions { solutions: solutions.collect(), divisor: Some(divisor), degree })
    }

    /// Solves a polynomial that contains only the sine, or only the cosine, of an angle for the
    /// unknown. `None` if the degree exceeds 2.
    fn isolate_sine_or_cosine(
        &mut self,
        p: &RingPolynomial,
        at: usize,
        x: Expr,
        angle: Expr,
        kind: RelationKind,
    ) -> Option<FactorSolutions> {
        let list = Self::coefficients(p, &[at]);
        let mut coefficients = vec![Expr::ZERO; 3];
        for (powers, c) in &list {
            *coefficients.get_mut(usize::from(powers.exponent_of(at)))? = self.term(c);
        }
        self.isolate_in_function(&coefficients, x, angle, kind)
    }

    /// Solves a polynomial in a sine or cosine, given by its coefficients, the constant first. The
    /// values −1, 0 and 1 of the sine or cosine give the unknown itself. `None` if the polynomial
    /// does not depend on the sine or cosine.
    fn isolate_in_function(
        &mut self,
        coefficients: &[Expr],
        x: Expr,
        angle: Expr,
        kind: RelationKind,
    ) -> Option<FactorSolutions> {
        let Roots { values, mut divisor, root, degree } = self.quadratic_roots(coefficients)?;
        // The angle is k x, with k = factor.
        let factor = self.arena.div(angle, x)?;
        let mut solutions = Vec::new();
        for value in values {
            let needs: Vec<RelationCondition> = root.iter().map(|e| RelationCondition::NotNegative(*e)).collect();
            let Some(quarters) = Self::isolate_quarter_turns(kind, value) else {
                let relations = vec![Relation { unknown: x, kind, angle, value }];
                let needs = needs.into_iter().chain([RelationCondition::Unit(value)]).collect();
                solutions.extend(self.possible_isolation(Solution { relations, needs }));
                continue;
            };
            divisor = self.arena.mul(divisor, factor);
            for quarter in quarters {
                let pi = self.arena.pi();
                let turn = self.arena.scale(pi, &Rational::fraction(*quarter, 2)?);
                let value = self.arena.div(turn, factor)?;
                solutions.extend(
                    self.possible_isolation(Solution {
                        relations: vec![Relation::value(x, value)],
                        needs: needs.clone(),
                    }),
                );
            }
        }
        Some(FactorSolutions { solutions, divisor: Some(divisor), degree })
    }

    /// Angles, in units of π/2, at which a sine or cosine has the value −1, 0 or 1; `None` for
    /// other values.
    fn isolate_quarter_turns(kind: RelationKind, value: Expr) -> Option<&'static [i64]> {
        match (kind, value) {
            (RelationKind::Sine, Expr::ZERO) => Some(&[0, 2]),
            (RelationKind::Sine, Expr::ONE) => Some(&[1]),
            (RelationKind::Sine, Expr::MINUS_ONE) => Some(&[-1]),
            (RelationKind::Cosine, Expr::ZERO) => Some(&[1, -1]),
            (RelationKind::Cosine, Expr::ONE) => Some(&[0]),
            (RelationKind::Cosine, Expr::MINUS_ONE) => Some(&[2]),
            _ => None,
        }
    }

    /// Solves an equation in the sine and cosine of one angle for the unknown. Its form is b sin +
    /// a cos + d = 0 or b sin + A₂ cos² + A₀ = 0. `None` for other forms.
    fn isolate_sine_and_cosine(
        &mut self,
        p: &RingPolynomial,
        [sine, cosine]: [usize; 2],
        x: Expr,
        angle: Expr,
    ) -> Option<FactorSolutions> {
        let [mut a, mut b, mut d, mut square] = [Expr::ZERO; 4];
        for (powers, c) in Self::coefficients(p, &[sine, cosine]) {
            let place = match (powers.exponent_of(sine), powers.exponent_of(cosine)) {
                (0, 0) => &mut d,
                (0, 1) => &mut a,
                (1, 0) => &mut b,
                (0, 2) => &mut square,
                _ => return None,
            };
            *place = self.term(&c);
        }
        if square != Expr::ZERO {
            // cos² = 1 − sin².
            let (sum, minus) = (self.arena.add(d, square), self.arena.neg(square));
            return if a == Expr::ZERO {
                self.isolate_in_function(&[sum, b, minus], x, angle, RelationKind::Sine)
            } else {
                None
            };
        }
        let relation = |kind: RelationKind, value: Expr| Relation { unknown: x, kind, angle, value };
        if d == Expr::ZERO {
            let minus = self.arena.neg(a);
            let value = self.quotient(minus, b)?;
            let relations = vec![relation(RelationKind::Tangent, value)];
            let solutions = vec![Solution { relations, needs: Vec::new() }];
            return Some(FactorSolutions { solutions, divisor: Some(b), degree: 0 });
        }
        // With r² = a² + b² and R = √(r² − d²): cos = (−a d ∓ b R)/r², sin = (−b d ± a R)/r².
        let [aa, bb, dd] = [a, b, d].map(|e| self.arena.square(e));
        let length = self.arena.add(aa, bb);
        let under = self.arena.sub(length, dd);
        let under = self.short(under);
        let root = self.arena.apply(Function::Sqrt, under);
        let mut solutions = Vec::new();
        for sign in [Rational::ONE, Rational::MINUS_ONE] {
            let [ad, bd, ar, br] = [(a, d), (b, d), (a, root), (b, root)].map(|(x, y)| self.arena.mul(x, y));
            let cos = self.arena.linear_combination(&[(ad, Rational::MINUS_ONE), (br, sign.neg())]);
            let sin = self.arena.linear_combination(&[(bd, Rational::MINUS_ONE), (ar, sign)]);
            let (cos, sin) = (self.quotient(cos, length)?, self.quotient(sin, length)?);
            let relations = vec![relation(RelationKind::Sine, sin), relation(RelationKind::Cosine, cos)];
            solutions.extend(
                self.possible_isolation(Solution { relations, needs: vec![RelationCondition::NotNegative(under)] }),
            );
        }
        Some(FactorSolutions { solutions, divisor: Some(length), degree: 2 })
    }

    /// Removes the conditions that always hold from a solution. `None` if a condition of the
    /// solution can never hold.
    fn possible_isolation(&mut self, solution: Solution) -> Option<Solution> {
        let needs = self.open_conditions(&solution.needs)?;
        Some(Solution { needs, ..solution })
    }

    /// Filters conditions: returns those that are not known to hold always. `None` if a condition
    /// can never hold.
    pub fn open_conditions(&mut self, needs: &[RelationCondition]) -> Option<Vec<RelationCondition>> {
        let mut list: Vec<RelationCondition> = Vec::new();
        for need in needs {
            let holds = match *need {
                RelationCondition::NotNegative(e) => match self.sign(e) {
                    Sign::Positive | Sign::NotNegative => Some(true),
                    Sign::Negative => Some(false),
                    _ => None,
                },
                RelationCondition::Unit(e) => self.arena.as_number(e).map(|value| {
                    let value = if value.is_negative() { value.neg() } else { value.clone() };
                    !Rational::ONE.add(&value.neg()).is_negative()
                }),
            };
            match holds {
                Some(true) => {}
                Some(false) => return None,
                None if list.contains(need) => {}
                None => list.push(*need),
            }
        }
        Some(list)
    }
}
