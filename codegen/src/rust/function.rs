//! Rust function for a planned function, generic over the scalar type `S`.

use super::expression::{expression, ident, receiver};
use super::names::LANGUAGE;
use super::text::comment;
use crate::plan::{
    Allocator, Argument, Entry, Explanation, Function, Language, Line, Parts, Program, Returns, Statement,
};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use tripos_derive::Model;

/// Most entries of an array argument that a pattern skips. With more, the entries that are read are taken one by one.
const MOST_SKIPPED: usize = 20;

/// Names of the functions in which runs spend their time; `System` calls them through `Scalar::dispatch`.
const DISPATCHED: [&str; 2] = ["accelerations", "derivative"];

/// Names of the functions in which quadrature spends its time, if equations have one degree of freedom.
const INTEGRANDS: [&str; 4] = ["coordinate_rates", "kinetic_energy", "half_differences", "potential_slope"];

/// Struct in which functions get the parameters.
pub struct Parameters {
    /// Path of the struct, as seen from the functions.
    pub path: TokenStream,
    /// Name of the struct's field for each parameter.
    pub fields: Vec<String>,
}

impl Parameters {
    /// Struct `Parameters` of a model, in scope of the functions.
    pub fn of(model: &Model) -> Self {
        Self { path: quote!(Parameters), fields: fields(model) }
    }
}

/// Names of the struct's fields for the parameters: their own names, escaped if they are keywords.
pub fn fields(model: &Model) -> Vec<String> {
    let mut allocator = Allocator::new(&Language { in_scope: &[], ..LANGUAGE });
    model.parameters.iter().map(|p| allocator.unique(&p.name)).collect()
}

/// Rust function for a planned function, which gets its parameters in this struct.
pub fn function(planned: &Function, parameters: &Parameters) -> TokenStream {
    let inlining = if DISPATCHED.contains(&planned.name) { Inlining::Always } else { Inlining::AsNeeded };
    written(planned, parameters, inlining)
}

/// Rust function for equations that quadrature may integrate, which gets its parameters in this struct.
pub fn function_at_points(planned: &Function, parameters: &Parameters) -> TokenStream {
    let is_dispatched = DISPATCHED.iter().chain(&INTEGRANDS).any(|name| *name == planned.name);
    written(planned, parameters, if is_dispatched { Inlining::Always } else { Inlining::AsNeeded })
}

/// Inlining of a generated function.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Inlining {
    /// The function is inlined, because only inlined code is compiled again for the instructions of the processor.
    Always,
    /// The compiler decides.
    AsNeeded,
}

/// Rust function for a planned function.
fn written(planned: &Function, parameters: &Parameters, inlining: Inlining) -> TokenStream {
    let (name, about, cost) = (ident(planned.name), format!(" {}", planned.about), format!(" {}.", planned.cost));
    let inline = (inlining == Inlining::Always).then(|| quote!(#[inline(always)]));
    let arguments = planned.arguments.iter().map(|argument| signature(argument, parameters));
    let body = match &planned.parts {
        Some(parts) => in_parts(planned, parts, parameters),
        None => whole(planned, parameters),
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

/// Body of a function up to its result, with its whole program.
fn whole(planned: &Function, parameters: &Parameters) -> TokenStream {
    let unpack = planned.arguments.iter().map(|argument| unpack(argument, parameters));
    let body = lines(planned, &planned.program, &[]);
    quote!(#(#unpack)* #body)
}

/// Body of a function up to its result: calls of the parts of its program, each in a function of its own.
fn in_parts(planned: &Function, parts: &Parts, parameters: &Parameters) -> TokenStream {
    let length = Literal::usize_unsuffixed(parts.places);
    let given: Vec<usize> = (0..planned.arguments.len()).filter(|at| planned.arguments[*at].is_read()).collect();
    let names = given.iter().map(|at| ident(planned.arguments[*at].name())).collect::<Vec<_>>();
    let functions = parts.list.iter().enumerate().map(|(at, part)| {
        let name = format_ident!("part_{}", at + 1);
        let arguments = given.iter().map(|at| signature(&part.arguments[*at], parameters));
        let unpack = part.arguments.iter().map(|argument| unpack(argument, parameters));
        let body = lines(planned, &part.program, &part.writes);
        let (takes, hands_on) = (taken("values", &part.reads), handed_on(&part.writes));
        let work = quote!(#(#unpack)* #takes #body #hands_on);
        // Code for the processor's instructions must be inlined, so a part, which is not, dispatches its own work.
        let work = if DISPATCHED.contains(&planned.name) {
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
    let takes = taken("values", &parts.results);
    quote! {
        #(#functions)*
        let mut values = [S::int(0); #length];
        #(#calls)*
        #(#unpack)*
        #takes
    }
}

/// Lines and outputs of a program. The code after the program reads the variables in `more`.
fn lines(planned: &Function, program: &Program, more: &[(usize, String)]) -> TokenStream {
    let mut read = program.names_read(0..usize::MAX);
    read.extend(more.iter().map(|(_, name)| name.as_str()));
    let head = statements(&program.lines, &|name| read.contains(name), planned.explanation);
    let body = section(planned.returns.heading(), &program.outputs, planned.explanation);
    quote!(#head #body)
}

/// Statement that takes variables from their places in an array.
fn taken(array: &str, list: &[(usize, String)]) -> TokenStream {
    let (places, names) = sides(array, list);
    if list.is_empty() { TokenStream::new() } else { quote!(let [#(#names),*] = [#(#places),*];) }
}

/// Statement that stores variables at their places in the array `values`.
fn handed_on(list: &[(usize, String)]) -> TokenStream {
    let (places, names) = sides("values", list);
    if list.is_empty() { TokenStream::new() } else { quote!([#(#places),*] = [#(#names),*];) }
}

fn sides(array: &str, list: &[(usize, String)]) -> (Vec<TokenStream>, Vec<TokenStream>) {
    let array = ident(array);
    let place = |place: usize| Literal::usize_unsuffixed(place);
    list.iter().map(|(at, name)| (place(*at), ident(name))).map(|(at, name)| (quote!(#array[#at]), name)).unzip()
}

/// Argument in a function's signature, with an underscore before its name if the body does not read it.
pub fn signature(argument: &Argument, parameters: &Parameters) -> TokenStream {
    let name = ident(&format!("{}{}", if argument.is_read() { "" } else { "_" }, argument.name()));
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

/// Statement that declares variables for the entries that the body reads of an argument.
pub fn unpack(argument: &Argument, parameters: &Parameters) -> TokenStream {
    match argument {
        Argument::Parameters { read } if !read.is_empty() => {
            let (path, fields) = (&parameters.path, &parameters.fields);
            let patterns = read.iter().map(|(place, variable)| {
                let (field, name) = (ident(&fields[*place]), ident(variable));
                if fields[*place] == *variable { field } else { quote!(#field: #name) }
            });
            let rest = (read.len() < fields.len()).then(|| quote!(, ..));
            quote!(let #path { #(#patterns),* #rest } = *p;)
        }
        Argument::Array { name, entries } if entries.iter().flatten().count() + MOST_SKIPPED < entries.len() => {
            let read = entries.iter().enumerate().filter_map(|(at, entry)| Some((at, entry.clone()?)));
            taken(name, &read.collect::<Vec<_>>())
        }
        Argument::Array { name, entries } if entries.iter().any(Option::is_some) => {
            let (name, patterns) = (ident(name), entries.iter().map(|entry| ident(entry.as_deref().unwrap_or("_"))));
            quote!(let [#(#patterns),*] = *#name;)
        }
        _ => TokenStream::new(),
    }
}

/// Return type of a function, and the expression that it returns.
fn result(returns: Returns, entries: &[Entry]) -> (TokenStream, TokenStream) {
    let names: Vec<TokenStream> = entries
        .iter()
        .map(|entry| match entry {
            Entry::Zero => quote!(zero),
            Entry::Variable(name) => ident(name),
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

/// Type and value of an array of rows with this number of columns.
fn rows(entries: &[TokenStream], columns: usize) -> (TokenStream, TokenStream) {
    let rows = entries.chunks(columns.max(1)).map(|row| quote!([#(#row),*]));
    let [count, columns] = [rows.len(), columns].map(Literal::usize_unsuffixed);
    (quote!([[S; #columns]; #count]), quote!([#(#rows),*]))
}

/// Lines of a program, with one heading for each kind of line. Comments are written as marked doc attributes.
pub fn statements(lines: &[Line], is_read: &dyn Fn(&str) -> bool, explanation: Explanation) -> TokenStream {
    let is_elimination = lines.iter().any(|line| matches!(line, Line::Step(_)));
    let shared = if explanation == Explanation::Names {
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
            Line::Circular { sine, cosine, angle } => {
                let name = |name: &str| if is_read(name) { ident(name) } else { quote!(_) };
                let (sine, cosine, angle) = (name(sine), name(cosine), receiver(angle));
                ("Sines and cosines.", quote!(let (#sine, #cosine) = #angle.sin_cos();))
            }
            Line::Let(step) | Line::Step(step) => (shared, statement(step, explanation)),
        };
        if !headings.contains(&wanted) {
            headings.push(wanted);
            tokens.extend(comment(wanted));
        }
        tokens.extend(written);
    }
    tokens
}

/// `let` statements with a heading above the first.
pub fn section(heading: &str, list: &[Statement], explanation: Explanation) -> TokenStream {
    let heading = if list.is_empty() { TokenStream::new() } else { comment(heading) };
    let statements = list.iter().map(|one| statement(one, explanation));
    quote!(#heading #(#statements)*)
}

/// `let` statement, with the equation that it computes above it if equations are comments.
fn statement(statement: &Statement, explanation: Explanation) -> TokenStream {
    let equation = explanation.of(statement).map(comment);
    let (name, value) = (ident(&statement.name), expression(&statement.value));
    quote!(#equation let #name = #value;)
}
