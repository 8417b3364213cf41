//! Formulas as Rust tokens, and formatted text with comments.

use crate::program::{Line, Program, Statement};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use std::fmt::Write;
use tripos_derive::algebra::Rational;
use tripos_derive::algebra::view::View;
use tripos_derive::plain::{one_line, visible};

/// What a piece of generated code costs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Additions, subtractions, multiplications, divisions and sign changes.
    pub operations: usize,
    /// The divisions among them.
    pub divisions: usize,
    /// Pairs of sine and cosine.
    pub sincos: usize,
    /// Other function values.
    pub functions: usize,
}

impl Cost {
    /// What one division costs in additions, roughly: on current processors it holds its unit that much longer.
    const DIVISION: usize = 4;
    /// The same for a sine and a cosine, or another function.
    const FUNCTION: usize = 30;

    /// The price of a call by which programs for the same values are compared.
    #[must_use]
    pub fn weight(&self) -> usize {
        self.operations + (Self::DIVISION - 1) * self.divisions + Self::FUNCTION * (self.sincos + self.functions)
    }
}

impl std::fmt::Display for Cost {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let plural = |n: usize, one: &str, many: &str| if n == 1 { format!("1 {one}") } else { format!("{n} {many}") };
        f.write_str(&plural(self.operations, "operation", "operations"))?;
        if self.sincos > 0 {
            write!(f, ", {}", plural(self.sincos, "sine and cosine", "sines and cosines"))?;
        }
        if self.functions > 0 {
            write!(f, ", {}", plural(self.functions, "other function", "other functions"))?;
        }
        Ok(())
    }
}

/// A formula as an expression of the scalar type `S`; its operations are added to `cost`.
pub fn expression(view: &View, cost: &mut Cost) -> TokenStream {
    match view {
        View::Number(text) => number(text, "1"),
        View::Name(name) | View::Shared(name) => ident(name),
        View::Pi => quote!(S::pi()),
        View::Sum(terms) => sum(terms, cost).0,
        View::Product(factors) => product(factors, cost),
        View::Fraction(above, below) => fraction(above, below, cost),
        View::Power(base, n) => power(base, *n, cost),
        View::Call(name, argument) => {
            cost.functions += 1;
            let argument = receiver(argument, cost);
            let method = format_ident!("{}", if *name == "log" { "ln" } else { name });
            quote!(#argument.#method())
        }
        View::Root(argument) => {
            cost.functions += 1;
            let argument = receiver(argument, cost);
            quote!(#argument.sqrt())
        }
        View::Cut => quote!(compile_error!("formula too large")),
    }
}

fn ident(name: &str) -> TokenStream {
    let ident = format_ident!("{name}");
    quote!(#ident)
}

/// An exact constant; whole where the denominator is 1.
fn number(numerator: &str, denominator: &str) -> TokenStream {
    match (numerator.parse::<i64>(), denominator.parse::<i64>()) {
        (Ok(n), Ok(1)) => {
            let n = proc_macro2::Literal::i64_unsuffixed(n);
            quote!(S::int(#n))
        }
        (Ok(n), Ok(d)) => {
            let (n, d) = (proc_macro2::Literal::i64_unsuffixed(n), proc_macro2::Literal::i64_unsuffixed(d));
            quote!(S::ratio(#n, #d))
        }
        // Too large for a word.
        _ => long_number(numerator, denominator),
    }
}

/// A quotient of whole numbers of any length: the nearest double, times a power of ten where no double is near.
fn long_number(numerator: &str, denominator: &str) -> TokenStream {
    let value = Rational::parse_decimal(numerator).zip(Rational::parse_decimal(denominator));
    let value = value.and_then(|(n, d)| Some(n.mul(&d.recip()?)));
    let Some(value) = value else { return quote!(compile_error!("not a number")) };
    let double = |x: f64| proc_macro2::Literal::f64_unsuffixed(x);
    let nearest = value.to_f64();
    if nearest.is_normal() {
        let nearest = double(nearest);
        return quote!(S::from_f64(#nearest));
    }
    // Whole digits less, of both: the size in powers of ten, to one.
    let size = digits(numerator) - digits(denominator);
    let ten = Rational::integer(10);
    let power = ten.pow(size).map(|power| value.mul(&power.recip().unwrap_or(Rational::ONE)).to_f64());
    match power {
        Some(mantissa) if mantissa.is_finite() => {
            let (mantissa, size) = (double(mantissa), proc_macro2::Literal::i32_unsuffixed(size));
            quote!(S::from_f64(#mantissa) * S::int(10).powi(#size))
        }
        _ => quote!(compile_error!("a number beyond all scalars")),
    }
}

/// How many digits a whole number has.
fn digits(text: &str) -> i32 {
    i32::try_from(text.trim_start_matches('-').len()).unwrap_or(i32::MAX)
}

/// Terms from left to right. A product of plain factors is fused with what stands before it, where the scalar type can:
/// one in a sum and none inside another, since nested calls are hard to read and gain little. If only the first term is a
/// product, it is fused with the second. Also whether all of it is one call, which binds as tightly as a name.
fn sum(terms: &[(bool, View)], cost: &mut Cost) -> (TokenStream, bool) {
    let mut order: Vec<&(bool, View)> = terms.iter().collect();
    if let [first, second, ..] = order.as_slice()
        && is_plain_product(&first.1)
        && !is_plain_product(&second.1)
    {
        order.swap(0, 1);
    }
    let (mut tokens, mut call) = (TokenStream::new(), false);
    let mut fused = order.iter().any(|(_, term)| !is_flat(term));
    for (at, (negative, term)) in order.into_iter().enumerate() {
        cost.operations += usize::from(at > 0 || (*negative && terms[0].0));
        if at > 0 && !fused && is_plain_product(term) {
            let (left, right) = halves(term, cost);
            let left = if *negative { quote!((- #left)) } else { left };
            tokens = quote!(#left.mul_add(#right, #tokens));
            (fused, call) = (true, true);
            continue;
        }
        call = false;
        let loose = matches!(term, View::Sum(_));
        let term = expression(term, cost);
        let term = if loose { quote!((#term)) } else { term };
        match (at, negative) {
            (0, false) => tokens.extend(term),
            (_, true) => tokens.extend(quote!(- #term)),
            (_, false) => tokens.extend(quote!(+ #term)),
        }
    }
    (tokens, call)
}

fn is_plain(view: &View) -> bool {
    matches!(view, View::Name(_) | View::Shared(_) | View::Number(_))
}

fn is_plain_product(view: &View) -> bool {
    match view {
        View::Product(factors) => factors.iter().all(is_plain),
        View::Power(base, 2) => is_plain(base),
        _ => false,
    }
}

/// Without a sum inside.
fn is_flat(view: &View) -> bool {
    match view {
        View::Sum(_) => false,
        View::Product(factors) => factors.iter().all(is_flat),
        View::Fraction(above, below) => is_flat(above) && is_flat(below),
        View::Power(inner, _) | View::Call(_, inner) | View::Root(inner) => is_flat(inner),
        View::Number(_) | View::Name(_) | View::Shared(_) | View::Pi | View::Cut => true,
    }
}

/// A plain product as what `mul_add` is called on and what it is multiplied by.
fn halves(term: &View, cost: &mut Cost) -> (TokenStream, TokenStream) {
    cost.operations += 1;
    let factors = match term {
        View::Product(factors) => factors.clone(),
        View::Power(base, _) => vec![(**base).clone(); 2],
        other => vec![other.clone()],
    };
    // A number is multiplied by, not called upon: `x.mul_add(S::int(4), y)`.
    let number = factors.iter().position(|f| matches!(f, View::Number(_)));
    let right = number.unwrap_or(factors.len() - 1);
    let mut left = factors;
    let right = expression(&left.remove(right), cost);
    let left = if left.len() == 1 { left.remove(0) } else { View::Product(left) };
    (receiver(&left, cost), right)
}

fn factor(view: &View, cost: &mut Cost) -> TokenStream {
    let (tokens, bound) = match view {
        View::Sum(terms) => sum(terms, cost),
        View::Fraction(..) => (expression(view, cost), false),
        _ => (expression(view, cost), true),
    };
    if bound { tokens } else { quote!((#tokens)) }
}

/// A formula that a method is called on.
fn receiver(view: &View, cost: &mut Cost) -> TokenStream {
    let (tokens, bound) = match view {
        View::Sum(terms) => sum(terms, cost),
        View::Name(_) | View::Shared(_) | View::Call(..) | View::Root(_) => (expression(view, cost), true),
        _ => (expression(view, cost), false),
    };
    if bound { tokens } else { quote!((#tokens)) }
}

fn product(factors: &[View], cost: &mut Cost) -> TokenStream {
    cost.operations += factors.len().saturating_sub(1);
    let factors = factors.iter().map(|f| factor(f, cost)).collect::<Vec<_>>();
    join_products(&factors)
}

fn join_products(factors: &[TokenStream]) -> TokenStream {
    let mut tokens = TokenStream::new();
    for (at, factor) in factors.iter().enumerate() {
        if at > 0 {
            tokens.extend(quote!(*));
        }
        tokens.extend(factor.clone());
    }
    tokens
}

/// above / below, with the whole numbers of both merged into one exact constant.
fn fraction(above: &View, below: &View, cost: &mut Cost) -> TokenStream {
    let (n, above) = split_number(above);
    let (d, below) = split_number(below);
    let mut factors: Vec<TokenStream> = Vec::new();
    if n != "1" || d != "1" || above.is_empty() {
        factors.push(number(&n, &d));
    }
    factors.extend(above.iter().map(|f| factor(f, cost)));
    cost.operations += factors.len() - 1;
    let numerator = join_products(&factors);
    match below.as_slice() {
        [] => numerator,
        [one] => {
            cost.operations += 1;
            cost.divisions += 1;
            let product = matches!(one, View::Power(..));
            let one = factor(one, cost);
            // A power may be written as a product, which binds no tighter than the division.
            if product { quote!(#numerator / (#one)) } else { quote!(#numerator / #one) }
        }
        many => {
            cost.operations += many.len();
            cost.divisions += 1;
            let many: Vec<TokenStream> = many.iter().map(|f| factor(f, cost)).collect();
            let denominator = join_products(&many);
            quote!(#numerator / (#denominator))
        }
    }
}

/// The leading whole number of a product, and the other factors.
fn split_number(view: &View) -> (String, Vec<View>) {
    match view {
        View::Number(text) => (text.clone(), Vec::new()),
        View::Product(factors) => match &factors[0] {
            View::Number(text) => (text.clone(), factors[1..].to_vec()),
            _ => ("1".to_owned(), factors.clone()),
        },
        other => ("1".to_owned(), vec![other.clone()]),
    }
}

/// Squares and cubes of a variable as products, other powers by `powi`.
fn power(base: &View, n: i32, cost: &mut Cost) -> TokenStream {
    let plain = matches!(base, View::Name(_) | View::Shared(_));
    let tokens = receiver(base, cost);
    if plain && (2..=3).contains(&n) {
        let count = usize::try_from(n).unwrap_or(2);
        cost.operations += count - 1;
        return join_products(&vec![tokens; count]);
    }
    let bits = n.unsigned_abs().ilog2();
    cost.operations += (bits + n.unsigned_abs().count_ones() - 1) as usize;
    let n = proc_macro2::Literal::i32_unsuffixed(n);
    quote!(#tokens.powi(#n))
}

/// The lines of a program, with comments carried as marked doc attributes.
pub fn statements(program: &Program, cost: &mut Cost) -> TokenStream {
    let mut tokens = TokenStream::new();
    let mut heading = "";
    for line in &program.lines {
        let (wanted, statement) = match line {
            Line::Circular { sine, cosine, angle } => {
                cost.sincos += 1;
                let angle = receiver(angle, cost);
                let (sine, cosine) = (pattern(sine, uses(program, sine)), pattern(cosine, uses(program, cosine)));
                ("Sines and cosines.", quote!(let (#sine, #cosine) = #angle.sin_cos();))
            }
            Line::Let(statement) | Line::Step(statement) => {
                let name = format_ident!("{}", statement.name);
                let value = expression(&statement.value, cost);
                let equation = comment(&statement.comment);
                let heading = if matches!(line, Line::Let(_)) { "Shared terms." } else { "Elimination, step by step." };
                (heading, quote!(#equation let #name = #value;))
            }
        };
        if wanted != heading {
            tokens.extend(comment(wanted));
            heading = wanted;
        }
        tokens.extend(statement);
    }
    tokens
}

/// `let` statements, the first one under a heading.
pub fn section(heading: &str, list: &[Statement], cost: &mut Cost) -> TokenStream {
    let mut tokens = TokenStream::new();
    for (at, statement) in list.iter().enumerate() {
        let heading = if at == 0 { comment(heading) } else { TokenStream::new() };
        let name = format_ident!("{}", statement.name);
        let value = expression(&statement.value, cost);
        let equation = comment(&statement.comment);
        tokens.extend(quote!(#heading #equation let #name = #value;));
    }
    tokens
}

/// Words of a file for a doc comment: on one line, and plain for Markdown, which would run fenced and indented text as examples and
/// follow brackets and addresses as links.
#[must_use]
pub fn prose(text: &str) -> String {
    let line = one_line(text);
    let mut out = String::new();
    for c in visible(&line).chars() {
        if matches!(c, '`' | '~' | '[' | ']' | '<' | '>') {
            out.push('\\');
        }
        out.push(c);
    }
    // An address is a text, too.
    out.replace("://", "\\://")
}

/// A comment on the next statement.
#[must_use]
pub fn comment(text: &str) -> TokenStream {
    let marked = format!("{MARK}{text}");
    quote!(#[doc = #marked])
}

const MARK: &str = "~";

fn pattern(name: &str, used: bool) -> TokenStream {
    if used { ident(name) } else { quote!(_) }
}

/// Whether a variable occurs in the shared terms or outputs.
fn uses(program: &Program, name: &str) -> bool {
    fn occurs(view: &View, name: &str) -> bool {
        match view {
            View::Shared(n) => n == name,
            View::Sum(terms) => terms.iter().any(|(_, t)| occurs(t, name)),
            View::Product(factors) => factors.iter().any(|f| occurs(f, name)),
            View::Fraction(a, b) => occurs(a, name) || occurs(b, name),
            View::Power(inner, _) | View::Call(_, inner) | View::Root(inner) => occurs(inner, name),
            View::Number(_) | View::Name(_) | View::Pi | View::Cut => false,
        }
    }
    let mut values = program.lines.iter().map(|line| match line {
        Line::Circular { angle, .. } => angle,
        Line::Let(statement) | Line::Step(statement) => &statement.value,
    });
    values.any(|v| occurs(v, name)) || program.outputs.iter().any(|s| occurs(&s.value, name))
}

/// Formats items and turns the marked attributes into comments.
///
/// # Panics
/// If the tokens are not a Rust file: a defect of the generator.
#[must_use]
pub fn format(header: &[String], items: TokenStream) -> String {
    let file: syn::File = syn::parse2(items).expect("generated tokens are a Rust file");
    let body = prettyplease::unparse(&file);
    // A line break in a line would end its comment: what follows would be code.
    let lines = header.iter().map(|line| one_line(&visible(line)));
    let mut out: String =
        lines.map(|line| if line.is_empty() { "//!\n".to_owned() } else { format!("//! {line}\n") }).collect();
    out.push('\n');
    let marked = format!("///{MARK}");
    let mut before = "";
    for line in body.lines() {
        // A blank line before each item, as rustfmt would keep.
        let starts = ["///", "pub ", "impl", "fn ", "use ", "#["].iter().any(|start| line.starts_with(start));
        let ended = before.starts_with('}') || before.ends_with(';') && !before.starts_with(' ');
        let group = |l: &str| l.split_whitespace().next() == Some("use") || l.starts_with("pub mod");
        if starts && ended && !(group(before) && (group(line) || line.starts_with("#[rustfmt"))) {
            out.push('\n');
        }
        before = line;
        match line.split_once(&marked) {
            Some((indent, text)) if indent.trim().is_empty() => {
                for (at, part) in wrap(&visible(text), 104 - indent.len().min(60)).iter().enumerate() {
                    let hang = if at == 0 { "" } else { "  " };
                    let _ = writeln!(out, "{indent}// {hang}{part}");
                }
            }
            _ => {
                out.push_str(line);
                out.push('\n');
            }
        }
    }
    out
}

/// Breaks a long comment at spaces.
fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let last = lines.last_mut().expect("at least one line");
        if !last.is_empty() && last.len() + 1 + word.len() > width {
            lines.push(word.to_owned());
        } else {
            if !last.is_empty() {
                last.push(' ');
            }
            last.push_str(word);
        }
    }
    lines
}
