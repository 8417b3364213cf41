//! Parser of infix formulas: `-R*u2*tan(q2) + u4*cos(q1)`, `q1'` for a time derivative, `^` for
//! powers.
//! Decimals are exact (`0.1` is 1/10). Sums and products are read in loops, so their length is
//! unlimited; nesting is limited to [`MAX_DEPTH`]. `tan`, `sec`, `csc` and `cot` are read as
//! quotients of sine and cosine. Components of velocities such as `v(P) @ A [1]` are operands only
//! if the caller can resolve them.

mod calls;
mod coefficient_size;
mod decimal;
mod error;
mod function_domain;
mod interaction;
mod quantity_cursor;
mod velocity;

pub use error::ParseError;
pub use interaction::InteractionName;
pub use velocity::{VelocityName, VelocityOf, canonical_velocity_name as velocity_name};

use crate::algebra::{Arena, Expr, Function, Node, PowerError, Rational};
use coefficient_size::{coefficient_bits, coefficient_denominator};
use decimal::decimal;
use error::error;
use rustc_hash::FxHashSet;

/// Deepest nesting of parentheses and functions that the parser accepts.
pub const MAX_DEPTH: usize = 200;

/// Largest cost of exact arithmetic in one expression, in squared bits. Arithmetic of this cost
/// takes about a second.
const MAX_WORK: u64 = 50_000_000_000;

/// Function that resolves a name: it returns the term that the name stands for. Its error is the
/// pair (message, help).
pub type Resolve<'a> = dyn FnMut(&mut Arena, &str) -> Result<Expr, (String, Option<String>)> + 'a;

/// Function that resolves a component of a velocity or position: it returns the term of that
/// component. Its error is the pair (message, help).
pub type ResolveVelocity<'a> = dyn FnMut(&mut Arena, &VelocityName<'_>) -> Result<Expr, (String, Option<String>)> + 'a;

/// Function that resolves a component of a force or torque between bodies: it returns the term of
/// that component. Its error is the pair (message, help).
pub type ResolveInteraction<'a> =
    dyn FnMut(&mut Arena, &InteractionName<'_>) -> Result<Expr, (String, Option<String>)> + 'a;

/// Parses one expression; the function `resolve` returns the term for each name.
///
/// # Errors
/// First [`ParseError`] in the text.
pub fn parse(arena: &mut Arena, text: &str, resolve: &mut Resolve<'_>) -> Result<Expr, ParseError> {
    parse_primed(arena, text, 1, resolve)
}

/// Function that returns the time derivative of a term. Its error is the pair (message, help).
pub type ResolveRate<'a> = dyn FnMut(&mut Arena, Expr) -> Result<Expr, (String, Option<String>)> + 'a;

/// Parses a formula of a publication; the function `resolve` returns the term for each name. Names
/// may end in up to `primes` primes, since published equations contain second derivatives `q1''`.
/// `ddt(…)` is the time derivative of a term, which the function `rate` returns.
///
/// # Errors
/// First [`ParseError`] in the text.
pub fn parse_published(
    arena: &mut Arena,
    text: &str,
    primes: usize,
    resolve: &mut Resolve<'_>,
    rate: &mut ResolveRate<'_>,
) -> Result<Expr, ParseError> {
    Parser { primes, rate: Some(rate), ..Parser::new(arena, text, resolve) }.parse_whole()
}

/// Parses a formula in which names may end in up to `primes` primes, such as the second derivative
/// `q1''`. The function `resolve` returns the term for each name.
///
/// # Errors
/// First [`ParseError`] in the text.
pub fn parse_primed(
    arena: &mut Arena,
    text: &str,
    primes: usize,
    resolve: &mut Resolve<'_>,
) -> Result<Expr, ParseError> {
    Parser { primes, ..Parser::new(arena, text, resolve) }.parse_whole()
}

/// Parses one expression that may contain components of velocities, and of forces and torques
/// between bodies. Three functions return terms: `resolve` for a name, `velocity` for a component
/// of a velocity, `interaction` for a component of a force or torque.
///
/// # Errors
/// First [`ParseError`] in the text.
pub fn parse_with_quantities<'a>(
    arena: &mut Arena,
    text: &str,
    resolve: &mut Resolve<'a>,
    velocity: &mut ResolveVelocity<'a>,
    interaction: &mut ResolveInteraction<'a>,
) -> Result<Expr, ParseError> {
    let (velocity, interaction) = (Some(velocity), Some(interaction));
    Parser { velocity, interaction, ..Parser::new(arena, text, resolve) }.parse_whole()
}

/// Parses one expression in which every name is a symbol; new symbols are declared in the order in
/// which they occur.
///
/// # Errors
/// First [`ParseError`] in the text.
pub fn parse_free(arena: &mut Arena, text: &str) -> Result<Expr, ParseError> {
    parse(arena, text, &mut |arena, name| Ok(arena.symbol(name)))
}

/// True if `name` is a function or constant of the expression language, and so cannot name a
/// quantity.
#[must_use]
pub fn is_reserved_by_parser(name: &str) -> bool {
    name == "pi" || is_function(name)
}

/// Functions of several arguments. A name of this list without parentheses is an ordinary name.
const SEVERAL_ARGUMENTS: [&str; 3] = ["min", "max", "atan2"];

/// True if `name` is a function of one argument in the expression language.
fn is_function(name: &str) -> bool {
    ["tan", "sec", "csc", "cot"].contains(&name) || Function::ALL.iter().any(|(_, n)| *n == name)
}

/// State of the parser while it reads a text from left to right.
struct Parser<'a, 'b> {
    /// Arena in which the terms are built.
    arena: &'a mut Arena,
    /// Whole text of the expression.
    text: &'a str,
    /// Position of the next character, in bytes.
    at: usize,
    /// Number of parentheses and functions that are open.
    depth: usize,
    /// Cost of exact arithmetic so far, in squared bits.
    work: u64,
    /// Largest number of primes that a name may end in.
    primes: usize,
    /// Function values in the text that are not real for every argument, such as logarithms.
    partial: Vec<Expr>,
    /// Function that resolves a name to a term.
    resolve: &'a mut Resolve<'b>,
    /// Function that resolves velocities and positions; `None` if the text may not contain them.
    velocity: Option<&'a mut ResolveVelocity<'b>>,
    /// Function that resolves forces and torques between bodies; `None` if the text may not contain
    /// them.
    interaction: Option<&'a mut ResolveInteraction<'b>>,
    /// Function that gives time derivatives; `None` if the text may not contain `ddt(…)`.
    rate: Option<&'a mut ResolveRate<'b>>,
}

impl<'a, 'b> Parser<'a, 'b> {
    /// Creates a parser at the start of a text.
    fn new(arena: &'a mut Arena, text: &'a str, resolve: &'a mut Resolve<'b>) -> Self {
        let partial = Vec::new();
        let (velocity, interaction, rate) = (None, None, None);
        Self { arena, text, at: 0, depth: 0, work: 0, primes: 1, partial, resolve, velocity, interaction, rate }
    }
}

impl Parser<'_, '_> {
    /// Parses the whole text as one expression. Error if text is left over.
    fn parse_whole(mut self) -> Result<Expr, ParseError> {
        self.skip_space();
        if self.at == self.text.len() {
            let help = "write 0 if nothing is meant";
            return Err(error(0..self.text.len(), "the expression is empty", Some(help)));
        }
        let e = self.sum()?;
        if self.at < self.text.len() {
            return Err(ParseError::unexpected(self.text, self.at, self.primes));
        }
        // log(w) − log(w) + w becomes w, but has a value only where log(w) has one.
        let partial = std::mem::take(&mut self.partial);
        if !partial.is_empty() {
            let kept = self.arena.reachable(&[e]);
            partial.into_iter().filter(|part| !kept.contains(part)).for_each(|part| self.arena.restrict(part));
        }
        Ok(e)
    }

    /// Next byte of the text; `None` at the end.
    fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn skip_space(&mut self) {
        while self.peek().is_some_and(|b| b.is_ascii_whitespace()) {
            self.at += 1;
        }
    }

    /// Skips the given byte and the space after it, if the byte comes next. Returns true if it was
    /// skipped.
    fn take(&mut self, byte: u8) -> bool {
        let found = self.peek() == Some(byte);
        if found {
            self.at += 1;
            self.skip_space();
        }
        found
    }

    /// Adds the cost of exact arithmetic with numbers of `bits` bits to the total. Error if the
    /// total is too high.
    fn count_cost(&mut self, bits: u64, start: usize) -> Result<(), ParseError> {
        self.work = self.work.saturating_add(bits.saturating_mul(bits));
        if self.work <= MAX_WORK {
            return Ok(());
        }
        let help = "write shorter numbers, or fewer different fractions";
        Err(error(start..self.at, "the numbers in this expression grow too large", Some(help)))
    }

    /// Parses a sum of terms, up to the first character that does not belong to it.
    fn sum(&mut self) -> Result<Expr, ParseError> {
        let start = self.at;
        let mut terms = Vec::new();
        let mut sign = Rational::ONE;
        let mut denominators = FxHashSet::default();
        let mut common = 0;
        loop {
            let term = self.term()?;
            let (above, below) = coefficient_bits(self.arena, term);
            // Different denominators multiply when fractions are added; numerators hardly grow.
            if below > 1 && denominators.insert(coefficient_denominator(self.arena, term)) {
                common += below;
            }
            self.count_cost(common + above, start)?;
            terms.push((term, sign));
            sign = match self.peek() {
                Some(b'+') => Rational::ONE,
                Some(b'-') => Rational::MINUS_ONE,
                _ => break,
            };
            self.at += 1;
            self.skip_space();
        }
        Ok(if terms.len() == 1 { terms[0].0 } else { self.arena.linear_combination(&terms) })
    }

    /// Parses a product or quotient of factors.
    fn term(&mut self) -> Result<Expr, ParseError> {
        let start = self.at;
        let mut factors = vec![(self.signed()?, 1)];
        let (above, below) = coefficient_bits(self.arena, factors[0].0);
        let mut bits = (above - 1) + (below - 1);
        loop {
            let exponent = match self.peek() {
                Some(b'*') if self.text.as_bytes().get(self.at + 1) == Some(&b'*') => {
                    self.at += 1;
                    return Err(ParseError::unexpected(self.text, self.at, self.primes));
                }
                Some(b'*') => 1,
                Some(b'/') => -1,
                _ => break,
            };
            self.at += 1;
            self.skip_space();
            let operand = self.at;
            let factor = self.signed()?;
            if exponent < 0 && factor == Expr::ZERO {
                return Err(error(operand..self.at, "division by zero", Some("this divisor is zero")));
            }
            factors.push((factor, exponent));
            let (above, below) = coefficient_bits(self.arena, factor);
            bits += (above - 1) + (below - 1);
            self.count_cost(bits, start)?;
        }
        if factors.len() == 1 {
            return Ok(factors[0].0);
        }
        let product = self.arena.try_product(&factors).and_then(|e| self.within_limits(e));
        product.map_err(|e| ParseError::power(start..self.at, e))
    }

    /// Returns the term `e`. Error if it is a product with an exponent beyond the limit for written
    /// formulas.
    fn within_limits(&self, e: Expr) -> Result<Expr, PowerError> {
        let product = match self.arena.node(e) {
            Node::Sum(_, terms) if terms.len() == 1 => terms[0].0,
            _ => e,
        };
        match self.arena.node(product) {
            Node::Product(factors) if factors.iter().any(|(_, n)| n.abs() > Arena::MAX_WRITTEN_EXPONENT) => {
                Err(PowerError::TooLarge)
            }
            _ => Ok(e),
        }
    }

    /// Parses any number of signs, then a power: −x² is −(x²).
    fn signed(&mut self) -> Result<Expr, ParseError> {
        let mut negative = false;
        loop {
            match self.peek() {
                Some(b'-') => negative = !negative,
                Some(b'+') => {}
                _ => break,
            }
            self.at += 1;
            self.skip_space();
        }
        let e = self.power()?;
        Ok(if negative { self.arena.neg(e) } else { e })
    }

    /// Parses an operand with its exponent, if it has one. An exponent is an integer or half an
    /// integer. Error for other exponents.
    fn power(&mut self) -> Result<Expr, ParseError> {
        let start = self.at;
        let base = self.primary()?;
        if !self.take(b'^') {
            return Ok(base);
        }
        let from = self.at;
        self.enter_nesting(from)?;
        let exponent = self.signed()?;
        self.depth -= 1;
        let halves = self.arena.as_number(exponent).map(|n| n.mul(&Rational::integer(2)));
        let Some(halves) = halves.filter(Rational::is_integer) else {
            let help = "an exponent is a number, whole or half: x^2, x^-1, x^(1/2)";
            return Err(error(from..self.at, "this exponent is not a whole or half number", Some(help)));
        };
        let too_large = |parser: &Self| ParseError::power(start..parser.at, PowerError::TooLarge);
        let halves = halves.to_i64().and_then(|n| i32::try_from(n).ok()).ok_or_else(|| too_large(self))?;
        let (base, n) = if halves % 2 == 0 {
            (base, halves / 2)
        } else {
            (self.checked_apply(Function::Sqrt, base, start)?, halves)
        };
        if n == 0 {
            return Ok(Expr::ONE);
        }
        self.arena.pow(base, n).and_then(|e| self.within_limits(e)).map_err(|e| ParseError::power(start..self.at, e))
    }

    /// Counts one more level of nesting. Error if the nesting is too deep.
    fn enter_nesting(&mut self, start: usize) -> Result<(), ParseError> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            let message = format!("nesting deeper than {MAX_DEPTH}");
            return Err(error(start..(start + 1).min(self.text.len()), message, Some("split the expression")));
        }
        Ok(())
    }

    /// Parses an expression after an opening parenthesis at byte `open`, up to its closing
    /// parenthesis. Error if the parenthesis is never closed.
    fn parenthesized(&mut self, open: usize) -> Result<Expr, ParseError> {
        self.enter_nesting(open)?;
        let e = self.sum()?;
        self.depth -= 1;
        if !self.take(b')') {
            if self.at < self.text.len() {
                return Err(ParseError::unexpected(self.text, self.at, self.primes));
            }
            return Err(error(open..open + 1, "this `(` is never closed", Some("add `)`")));
        }
        Ok(e)
    }

    /// Parses a number, a name, a call or an expression in parentheses.
    fn primary(&mut self) -> Result<Expr, ParseError> {
        let start = self.at;
        match self.peek() {
            Some(b'(') => {
                self.take(b'(');
                self.parenthesized(start)
            }
            Some(b'0'..=b'9' | b'.') => self.number(),
            Some(b'a'..=b'z' | b'A'..=b'Z' | b'_') => self.named(),
            _ => Err(ParseError::unexpected(self.text, self.at, self.primes)),
        }
    }

    /// Parses a decimal number.
    fn number(&mut self) -> Result<Expr, ParseError> {
        let (value, end) = decimal(self.text, self.at)?;
        self.at = end;
        self.skip_space();
        Ok(self.arena.number(value))
    }

    /// Parses a name or a call: a symbol, π, a function, a velocity, a force, or a time derivative.
    fn named(&mut self) -> Result<Expr, ParseError> {
        let start = self.at;
        let name_end = self.text[start..]
            .find(|c: char| !(c.is_ascii_alphanumeric() || c == '_'))
            .map_or(self.text.len(), |length| start + length);
        let primes = self.text[name_end..].bytes().take_while(|b| *b == b'\'').count();
        let end = name_end + primes;
        let text = self.text;
        let name = &text[start..end];
        self.at = end;
        self.skip_space();
        let called = self.peek() == Some(b'(');
        if is_function(name) {
            if !called {
                let help = format!("write {name}(…)");
                return Err(error(start..end, format!("`{name}` needs an argument in parentheses"), Some(&help)));
            }
            let open = self.at;
            self.take(b'(');
            let argument = self.parenthesized(open)?;
            return self.function(name, argument, start);
        }
        if called && name == "distance" && self.velocity.is_some() {
            return self.distance_call(start);
        }
        if called && SEVERAL_ARGUMENTS.contains(&name) {
            return self.of_several(name, start);
        }
        if called && velocity::is_velocity(name) && self.velocity.is_some() {
            return self.component_call(name, start);
        }
        if called && name == "ddt" && self.rate.is_some() {
            let open = self.at;
            self.take(b'(');
            let argument = self.parenthesized(open)?;
            let rate = self.rate.as_mut().expect("asked before");
            let span = start..self.at;
            return rate(self.arena, argument).map_err(|(message, help)| ParseError { span, message, help });
        }
        if called && interaction::is_interaction(name) && self.interaction.is_some() {
            return self.interaction_call(name, start);
        }
        if called {
            let help = format!("write `{name}` alone if it depends on time, `{name}*(…)` for a product");
            return Err(error(start..end, format!("`{name}` is not a function"), Some(&help)));
        }
        if primes > self.primes && self.primes > 1 {
            let message = format!("this name has more than {} primes", self.primes);
            return Err(error(start..end, message, Some("q1'' is the second derivative; there is no third here")));
        }
        if primes > self.primes {
            let help = "one prime only: second derivatives are derived, not stated";
            return Err(error(start..end, format!("`{name}` has more than one prime"), Some(help)));
        }
        if name == "pi" {
            return Ok(self.arena.pi());
        }
        (self.resolve)(self.arena, name).map_err(|(message, help)| ParseError { span: start..end, message, help })
    }
}
