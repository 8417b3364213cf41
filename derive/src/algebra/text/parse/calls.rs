//! Parsing of calls: functions of one and of several arguments, and components of velocities and
//! interactions.

use super::error::{ParseError, error};
use super::function_domain::{has_limited_domain, is_outside_domain};
use super::{InteractionName, Parser, VelocityName};
use crate::algebra::{Expr, Function, Rational};

impl Parser<'_, '_> {
    /// Parses a component of a velocity or position, after its keyword `v`, `omega` or `p`. The
    /// keyword begins at byte `start`. Error if the syntax is wrong or a name is unknown.
    pub(super) fn component_call(&mut self, word: &str, start: usize) -> Result<Expr, ParseError> {
        let (name, end) = VelocityName::read(word, self.text, self.at)?;
        self.at = end;
        let resolve = self.velocity.as_mut().expect("asked before");
        resolve(self.arena, &name).map_err(|(message, help)| ParseError { span: start..end, message, help })
    }

    /// Parses a component of a force or torque between bodies, after its keyword `force` or
    /// `torque`. The keyword begins at byte `start`. Error if the syntax is wrong or a name is
    /// unknown.
    pub(super) fn interaction_call(&mut self, word: &str, start: usize) -> Result<Expr, ParseError> {
        let (name, end) = InteractionName::read(word, self.text, self.at)?;
        self.at = end;
        let resolve = self.interaction.as_mut().expect("asked before");
        resolve(self.arena, &name).map_err(|(message, help)| ParseError { span: start..end, message, help })
    }

    /// Parses the distance of two points, `distance(P, Q)`, after its keyword, which begins at byte
    /// `start`. The result is the square root of a sum of squares. Error if the syntax is wrong or
    /// a point is unknown.
    pub(super) fn distance_call(&mut self, start: usize) -> Result<Expr, ParseError> {
        let (ends, end) = VelocityName::distance_ends(self.text, self.at)?;
        self.at = end;
        let resolve = self.velocity.as_mut().expect("asked before");
        let mut squares = Vec::new();
        for pair in ends {
            let mut places = [Expr::ZERO; 2];
            for (place, name) in places.iter_mut().zip(&pair) {
                *place = resolve(self.arena, name).map_err(|(message, help)| ParseError {
                    span: start..end,
                    message,
                    help,
                })?;
            }
            let way = self.arena.sub(places[1], places[0]);
            squares.push(self.arena.square(way));
        }
        let square = self.arena.sum(&squares);
        Ok(self.arena.apply(Function::Sqrt, square))
    }

    /// Parses a call of `min`, `max` or `atan2` after its name. The result is written with
    /// functions of one argument. Error if the number of arguments is wrong.
    pub(super) fn of_several(&mut self, name: &str, start: usize) -> Result<Expr, ParseError> {
        let open = self.at;
        self.take(b'(');
        self.enter_nesting(open)?;
        let mut arguments = vec![self.sum()?];
        while self.take(b',') {
            arguments.push(self.sum()?);
        }
        self.depth -= 1;
        if !self.take(b')') {
            if self.at < self.text.len() {
                return Err(ParseError::unexpected(self.text, self.at, self.primes));
            }
            return Err(error(open..open + 1, "this `(` is never closed", Some("add `)`")));
        }
        if name == "atan2" {
            let &[y, x] = arguments.as_slice() else {
                return Err(error(start..self.at, "`atan2` takes two arguments", Some("write atan2(y, x)")));
            };
            return self.atan2_call(y, x, start);
        }
        if arguments.len() < 2 {
            let help = format!("write {name}(a, b)");
            return Err(error(start..self.at, format!("`{name}` takes two arguments or more"), Some(&help)));
        }
        let half = Rational::fraction(1, 2).expect("not zero");
        let mut result = arguments[0];
        for argument in &arguments[1..] {
            // min and max are (a + b ∓ |a − b|)/2.
            let apart = self.arena.sub(result, *argument);
            let apart = self.arena.apply(Function::Abs, apart);
            let both = self.arena.add(result, *argument);
            let sum = if name == "max" { self.arena.add(both, apart) } else { self.arena.sub(both, apart) };
            result = self.arena.scale(sum, &half);
        }
        Ok(result)
    }

    /// Angle of the direction (x, y) from the positive x axis, rad, as the term 2 arctan(y/(x +
    /// √(x² + y²))). It has no value on the negative x axis. Error if x and y are certainly there.
    fn atan2_call(&mut self, y: Expr, x: Expr, start: usize) -> Result<Expr, ParseError> {
        let squares = [self.arena.square(x), self.arena.square(y)];
        let square = self.arena.sum(&squares);
        let length = self.arena.apply(Function::Sqrt, square);
        let below = self.arena.add(x, length);
        let quotient = self.arena.div(y, below).filter(|_| below != Expr::ZERO).ok_or_else(|| {
            error(
                start..self.at,
                "atan2 has no value here",
                Some("the result is undefined along the negative first axis"),
            )
        })?;
        let half = self.arena.apply(Function::Atan, quotient);
        Ok(self.arena.scale(half, &Rational::integer(2)))
    }

    /// Applies the function with the name `name` to an argument; `tan`, `cot`, `sec` and `csc`
    /// become quotients. Error if the argument is a constant at which the function has no value.
    pub(super) fn function(&mut self, name: &str, argument: Expr, start: usize) -> Result<Expr, ParseError> {
        let quotient = |parser: &mut Self, above: Expr, below: Expr| {
            parser.arena.div(above, below).ok_or_else(|| {
                let message = format!("{name} has no value here");
                error(start..parser.at, message, Some("it divides by zero at this constant angle"))
            })
        };
        match name {
            "tan" | "cot" | "sec" | "csc" => {
                let (sine, cosine) = (self.arena.sin(argument), self.arena.cos(argument));
                match name {
                    "tan" => quotient(self, sine, cosine),
                    "cot" => quotient(self, cosine, sine),
                    "sec" => quotient(self, Expr::ONE, cosine),
                    _ => quotient(self, Expr::ONE, sine),
                }
            }
            _ => {
                let (f, _) = *Function::ALL.iter().find(|(_, n)| *n == name).expect("is_function said so");
                self.checked_apply(f, argument, start)
            }
        }
    }

    /// Applies a function to an argument. Error if the argument is a constant outside the
    /// function's domain.
    pub(super) fn checked_apply(&mut self, f: Function, argument: Expr, start: usize) -> Result<Expr, ParseError> {
        if is_outside_domain(self.arena, f, argument) {
            let shown = crate::diagnostic::shortened_for_message(&crate::algebra::text::print::print_text(
                self.arena, argument,
            ));
            let message = format!("{}({shown}) is not a real number", f.name());
            return Err(error(start..self.at, message, Some("the argument is outside the function's domain")));
        }
        let e = self.arena.apply(f, argument);
        if has_limited_domain(f) && self.arena.as_number(argument).is_none() {
            self.partial.push(e);
        }
        Ok(e)
    }
}
