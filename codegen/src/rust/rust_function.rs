//! Text of a Rust function for a planned function, generic over the scalar type `S`.

use super::expression::{expression, method_receiver_expression};
use super::names::{parameter_field_names, rust_identifier};
use super::rust_text::comment;
use crate::lines::wrap;
use crate::plan::{Argument, Entry, Function, LineComments, Parts, Program, ProgramLine, Returns, Statement};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use tripos_derive::Model;
use tripos_derive::plain_text::with_visible_characters;

/// Largest number of unread entries of an array argument that a pattern skips. If there are more, the entries are
/// read by index.
const MOST_SKIPPED: usize = 20;

/// Names of the functions in which runs spend their time. `System` calls them through
/// `Scalar::dispatch`, compiled for the processor's instructions.
const DISPATCHED_FUNCTIONS: [&str; 2] = ["accelerations", "derivative"];

/// Names of the functions in which quadrature spends its time, for equations with one degree of
/// freedom.
const INTEGRANDS: [&str; 4] = ["coordinate_rates", "kinetic_energy", "half_differences", "potential_slope"];

/// Largest number of bytes in a line of equations in generated documentation.
const EQUATION: usize = 160;

/// Rust struct in which generated functions receive the parameters.
pub struct Parameters {
    /// Path of the struct in Rust, as the functions see it.
    pub path: TokenStream,
    /// Name of the struct's field for each parameter, in the order of the model.
    pub fields: Vec<String>,
}

impl Parameters {
    /// Returns the struct `Parameters` of a model, as functions in the same module see it.
    pub fn of(model: &Model) -> Self {
        Self { path: quote!(Parameters), fields: parameter_field_names(model) }
    }
}

/// Returns the Rust function for a planned function. The functions in which runs spend their time are always inlined.
pub fn function(planned: &Function, parameters: &Parameters) -> TokenStream {
    let inlining = if DISPATCHED_FUNCTIONS.contains(&planned.name) { Inlining::Always } else { Inlining::AsNeeded };
    rust_function_with_inlining(planned, parameters, inlining)
}

/// Returns the Rust function for a planned function of equations with one degree of freedom. The functions in which
/// runs and quadrature spend their time are always inlined.
pub fn function_at_points(planned: &Function, parameters: &Parameters) -> TokenStream {
    let is_dispatched = DISPATCHED_FUNCTIONS.iter().chain(&INTEGRANDS).any(|name| *name == planned.name);
    rust_function_with_inlining(planned, parameters, if is_dispatched { Inlining::Always } else { Inlining::AsNeeded })
}

/// Choice of the inlining of a generated Rust function.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Inlining {
    /// The function is always inlined, because only inlined code is compiled again for the
    /// instructions of the processor.
    Always,
    /// The compiler decides about inlining.
    AsNeeded,
}

/// Returns the Rust function for a planned function, with its description, cost and inlining.
fn rust_function_with_inlining(planned: &Function, parameters: &Parameters, inlining: Inlining) -> TokenStream {
    let (name, about, cost) =
        (rust_identifier(planned.name), format!(" {}", planned.about), format!(" {}.", planned.cost));
    let inline = (inlining == Inlining::Always).then(|| quote!(#[inline(always)]));
    let arguments = planned.arguments.iter().map(|argument| signature(argument, parameters));
    let body = match &planned.parts {
        Some(parts) => divided_function_body(planned, parts, parameters),
        None => whole_function_body(planned, parameters),
    };
    let zero = planned.entries.contains(&Entry::Zero).then(|| quote!(let zero = S::int(0);));
    let (kind, result) = result(planned.returns, &planned.entries);
    quote! {
        #[doc = #about]
        #[doc = ""]
        #[doc = #cost]
        #[must_use]
        #inline
        pub fn #name<S: Scalar>(#(#arguments),*) -> #kind {
            #body
            #zero
            #result
        }
    }
}

/// Returns the doc attributes of a planned function: a description of its result, and the equations that it computes.
#[must_use]
pub fn function_documentation(planned: &Function) -> TokenStream {
    let mut lines = vec![format!(" {}", planned.about), String::new()];
    if planned.program.equations().next().is_none() {
        lines.push(" All entries are 0.".to_owned());
        return quote!(#(#[doc = #lines])*);
    }
    if planned.entries.contains(&Entry::Zero) {
        lines[0].push_str(" Entries that are not listed are 0.");
    }
    if planned.explanation == LineComments::Names {
        lines.push(format!(" {}, step by step: the code names every term.", planned.cost));
        return quote!(#(#[doc = #lines])*);
    }
    lines.push(" ```text".to_owned());
    for equation in planned.program.equations() {
        let wrapped = wrap(&with_visible_characters(equation), EQUATION).into_iter().enumerate();
        lines.extend(wrapped.map(|(at, part)| format!(" {}{part}", if at == 0 { "" } else { "    " })));
    }
    lines.push(" ```".to_owned());
    quote!(#(#[doc = #lines])*)
}

/// Returns the body of a function whose program stays whole, without the result at its end.
fn whole_function_body(planned: &Function, parameters: &Parameters) -> TokenStream {
    let unpack = planned.arguments.iter().map(|argument| unpack(argument, parameters));
    let body = lines(planned, &planned.program, &[]);
    quote!(#(#unpack)* #body)
}

/// Returns the body of a function whose program is divided, without the result at its end. The body declares a
/// function for each part and calls these functions in order.
fn divided_function_body(planned: &Function, parts: &Parts, parameters: &Parameters) -> TokenStream {
    let length = Literal::usize_unsuffixed(parts.places);
    let given: Vec<usize> = (0..planned.arguments.len()).filter(|at| planned.arguments[*at].is_read()).collect();
    let names = given.iter().map(|at| rust_identifier(planned.arguments[*at].name())).collect::<Vec<_>>();
    let functions = parts.list.iter().enumerate().map(|(at, part)| {
        let name = format_ident!("part_{}", at + 1);
        let arguments = given.iter().map(|at| signature(&part.arguments[*at], parameters));
        let unpack = part.arguments.iter().map(|argument| unpack(argument, parameters));
        let body = lines(planned, &part.program, &part.writes);
        let (takes, hands_on) = (load_from_array("values", &part.reads), store_to_array(&part.writes));
        let work = quote!(#(#unpack)* #takes #body #hands_on);
        // Code for the instructions of the processor must be inlined. A part is not inlined, so it dispatches its own
        // work.
        let work = if DISPATCHED_FUNCTIONS.contains(&planned.name) {
            quote!(S::dispatch(#[inline(always)] || { #work });)
        } else {
            work
        };
        quote! {
            #[inline(never)]
            fn #name<S: Scalar>(#(#arguments,)* values: &mut [S; #length]) { #work }
        }
    });
    let calls = (1..=parts.list.len()).map(|at| {
        let name = format_ident!("part_{at}");
        quote!(#name(#(#names,)* &mut values);)
    });
    let unpack = parts.arguments.iter().map(|argument| unpack(argument, parameters));
    let takes = load_from_array("values", &parts.results);
    quote! {
        #(#functions)*
        let mut values = [S::int(0); #length];
        #(#calls)*
        #(#unpack)*
        #takes
    }
}

/// Returns the Rust statements of a program. `more` lists variables that later code reads, in addition to those that
/// the program reads itself.
fn lines(planned: &Function, program: &Program, more: &[(usize, String)]) -> TokenStream {
    let mut read = program.names_read(0..usize::MAX);
    read.extend(more.iter().map(|(_, name)| name.as_str()));
    let head = statements(&program.lines, &|name| read.contains(name), planned.explanation);
    let body = section(planned.returns.heading(), &program.outputs, planned.explanation);
    quote!(#head #body)
}

/// Returns the statement that reads variables from an array. `list` holds the index of each variable. The statement
/// is empty for an empty list.
fn load_from_array(array: &str, list: &[(usize, String)]) -> TokenStream {
    let (places, names) = assignment_sides(array, list);
    if list.is_empty() { TokenStream::new() } else { quote!(let [#(#names),*] = [#(#places),*];) }
}

/// Returns the statement that stores variables in the array `values`. `list` holds the index of each variable. The
/// statement is empty for an empty list.
fn store_to_array(list: &[(usize, String)]) -> TokenStream {
    let (places, names) = assignment_sides("values", list);
    if list.is_empty() { TokenStream::new() } else { quote!([#(#places),*] = [#(#names),*];) }
}

/// Returns the array elements and the variables of a list, as the two sides of an assignment.
fn assignment_sides(array: &str, list: &[(usize, String)]) -> (Vec<TokenStream>, Vec<TokenStream>) {
    let array = rust_identifier(array);
    let place = |place: usize| Literal::usize_unsuffixed(place);
    list.iter()
        .map(|(at, name)| (place(*at), rust_identifier(name)))
        .map(|(at, name)| (quote!(#array[#at]), name))
        .unzip()
}

/// Returns an argument as it is declared in a function's signature. An unread argument gets an
/// underscore before its name.
pub fn signature(argument: &Argument, parameters: &Parameters) -> TokenStream {
    let name = rust_identifier(&format!("{}{}", if argument.is_read() { "" } else { "_" }, argument.name()));
    match argument {
        Argument::Parameters { .. } => {
            let path = &parameters.path;
            quote!(#name: &#path<S>)
        }
        Argument::Array { entries, .. } => {
            let count = Literal::usize_unsuffixed(entries.len());
            quote!(#name: &[S; #count])
        }
        Argument::Number(_) => quote!(#name: S),
    }
}

/// Returns the statement that declares variables for those entries of an argument that the body
/// reads.
pub fn unpack(argument: &Argument, parameters: &Parameters) -> TokenStream {
    match argument {
        Argument::Parameters { read } if !read.is_empty() => {
            let (path, fields) = (&parameters.path, &parameters.fields);
            let patterns = read.iter().map(|(place, variable)| {
                let (field, name) = (rust_identifier(&fields[*place]), rust_identifier(variable));
                if fields[*place] == *variable { field } else { quote!(#field: #name) }
            });
            let rest = (read.len() < fields.len()).then(|| quote!(, ..));
            quote!(let #path { #(#patterns),* #rest } = *p;)
        }
        Argument::Array { name, entries } if entries.iter().flatten().count() + MOST_SKIPPED < entries.len() => {
            let read = entries.iter().enumerate().filter_map(|(at, entry)| Some((at, entry.clone()?)));
            load_from_array(name, &read.collect::<Vec<_>>())
        }
        Argument::Array { name, entries } if entries.iter().any(Option::is_some) => {
            let (name, patterns) =
                (rust_identifier(name), entries.iter().map(|entry| rust_identifier(entry.as_deref().unwrap_or("_"))));
            quote!(let [#(#patterns),*] = *#name;)
        }
        _ => TokenStream::new(),
    }
}

/// Returns the return type of a function and the expression that it returns.
fn result(returns: Returns, entries: &[Entry]) -> (TokenStream, TokenStream) {
    let names: Vec<TokenStream> = entries
        .iter()
        .map(|entry| match entry {
            Entry::Zero => quote!(zero),
            Entry::Variable(name) => rust_identifier(name),
        })
        .collect();
    let count = Literal::usize_unsuffixed(names.len());
    match returns {
        Returns::Number => (quote!(S), quote!(#(#names)*)),
        Returns::Vector => (quote!([S; #count]), quote!([#(#names),*])),
        Returns::Pair(_) | Returns::System(_) => {
            let first = returns.first().unwrap_or_default();
            let (front, back) = names.split_at(first);
            let [one, two] = [front.len(), back.len()].map(Literal::usize_unsuffixed);
            (quote!(([S; #one], [S; #two])), quote!(([#(#front),*], [#(#back),*])))
        }
        Returns::Matrix { .. } => rows(&names, names.len().isqrt()),
        Returns::Table { columns } => rows(&names, columns),
    }
}

/// Returns the Rust type and value of a matrix whose entries are given row by row. `columns` is the number of
/// columns.
fn rows(entries: &[TokenStream], columns: usize) -> (TokenStream, TokenStream) {
    let rows = entries.chunks(columns.max(1)).map(|row| quote!([#(#row),*]));
    let [count, columns] = [rows.len(), columns].map(Literal::usize_unsuffixed);
    (quote!([[S; #columns]; #count]), quote!([#(#rows),*]))
}

/// Returns the Rust statements of a program's lines, with a heading for each kind of line. Comments are doc
/// attributes, which formatting turns into plain comments.
pub fn statements(lines: &[ProgramLine], is_read: &dyn Fn(&str) -> bool, explanation: LineComments) -> TokenStream {
    let is_elimination = lines.iter().any(|line| matches!(line, ProgramLine::Step(_)));
    let shared = if explanation == LineComments::Names {
        "Step by step, each after the terms that it needs."
    } else if is_elimination {
        "Elimination, step by step, each after the terms that it shares."
    } else {
        "Shared terms."
    };
    let mut tokens = TokenStream::new();
    let mut headings = Vec::new();
    for line in lines {
        let (wanted, written) = match line {
            ProgramLine::Circular { sine, cosine, angle } => {
                let name = |name: &str| if is_read(name) { rust_identifier(name) } else { quote!(_) };
                let (sine, cosine, angle) = (name(sine), name(cosine), method_receiver_expression(angle));
                ("Sines and cosines.", quote!(let (#sine, #cosine) = #angle.sin_cos();))
            }
            ProgramLine::Let(step) | ProgramLine::Step(step) => (shared, statement(step, explanation)),
        };
        if !headings.contains(&wanted) {
            headings.push(wanted);
            tokens.extend(comment(wanted));
        }
        tokens.extend(written);
    }
    tokens
}

/// Returns `let` statements with a heading above the first one. The result is empty for an empty list.
pub fn section(heading: &str, list: &[Statement], explanation: LineComments) -> TokenStream {
    let heading = if list.is_empty() { TokenStream::new() } else { comment(heading) };
    let statements = list.iter().map(|one| statement(one, explanation));
    quote!(#heading #(#statements)*)
}

/// Returns a `let` statement. If `explanation` asks for formulas, its equation is above it as a comment.
fn statement(statement: &Statement, explanation: LineComments) -> TokenStream {
    let equation = explanation.of(statement).map(comment);
    let (name, value) = (rust_identifier(&statement.name), expression(&statement.value));
    quote!(#equation let #name = #value;)
}
