//! A long program in parts: compilers take a function of n lines in a time that grows with n², and fill its registers
//! no better than those of a short one.

use super::arguments::{Argument, Entry};
use super::program::Program;
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;

/// Lines up to which a program stays whole.
const MOST_WHOLE: usize = 1500;

/// Lines of a part.
const PART: usize = 1000;

/// A part of a program.
#[derive(Clone, Debug)]
pub struct Part {
    /// The function's arguments that it reads.
    pub arguments: Vec<Argument>,
    /// Places whose values it needs, with their variables.
    pub reads: Vec<(usize, String)>,
    /// Its lines and outputs.
    pub program: Program,
    /// Places that it fills for later parts and for the result, with the variables of their values.
    pub writes: Vec<(usize, String)>,
}

/// A program in parts, each of which hands what later ones need to them by places in an array.
#[derive(Clone, Debug)]
pub struct Parts {
    /// The parts, in the order of computation.
    pub list: Vec<Part>,
    /// The length of the array.
    pub places: usize,
    /// Places of the array that hold the returned values, with their variables.
    pub results: Vec<(usize, String)>,
    /// Arguments that the return value takes directly.
    pub arguments: Vec<Argument>,
}

impl Parts {
    /// The parts of a program, if it is too long to stay whole.
    #[must_use]
    pub fn of(program: &Program, arguments: &[Argument], entries: &[Entry]) -> Option<Self> {
        let lines = program.lines.len();
        let length = lines + program.outputs.len();
        if length <= MOST_WHOLE {
            return None;
        }
        let ranges: Vec<Range<usize>> = (0..length).step_by(PART).map(|at| at..length.min(at + PART)).collect();
        let returned = entries.iter().filter_map(|entry| match entry {
            Entry::Variable(name) => Some(name.as_str()),
            Entry::Zero => None,
        });
        // What each part needs; the result counts as one behind all.
        let mut needed: Vec<FxHashSet<&str>> = ranges.iter().map(|range| program.names_read(range.clone())).collect();
        needed.push(returned.collect());
        let mut last: FxHashMap<&str, usize> = FxHashMap::default();
        for (at, names) in needed.iter().enumerate() {
            last.extend(names.iter().map(|name| (*name, at)));
        }
        let (mut places, mut free): (usize, Vec<usize>) = (0, Vec::new());
        // The variables that are held for later, with their places.
        let mut held: Vec<(&str, usize)> = Vec::new();
        let mut list = Vec::with_capacity(ranges.len());
        for (at, range) in ranges.into_iter().enumerate() {
            let reads = owned(held.iter().filter(|(name, _)| needed[at].contains(name)));
            let (stays, done): (Vec<_>, Vec<_>) = held.into_iter().partition(|(name, _)| last[name] > at);
            free.extend(done.into_iter().map(|(_, place)| place));
            held = stays;
            let before = held.len();
            for name in program.names_set(range.clone()) {
                if last.get(name).is_some_and(|last| *last > at) {
                    held.push((name, free.pop().unwrap_or(places)));
                    places = places.max(held[held.len() - 1].1 + 1);
                }
            }
            let writes = owned(held[before..].iter());
            let program = Program {
                lines: program.lines[range.start.min(lines)..range.end.min(lines)].to_vec(),
                outputs: program.outputs[range.start.max(lines) - lines..range.end.max(lines) - lines].to_vec(),
                ..Program::default()
            };
            list.push(Part { arguments: restricted(arguments, &needed[at]), reads, program, writes });
        }
        let mut results = owned(held.iter());
        scatter(
            list.iter_mut().flat_map(|part| part.reads.iter_mut().chain(&mut part.writes)).chain(&mut results),
            places,
        );
        let arguments = restricted(arguments, &needed[list.len()]);
        Some(Self { list, places, results, arguments })
    }
}

fn owned<'v>(held: impl Iterator<Item = &'v (&'v str, usize)>) -> Vec<(usize, String)> {
    held.map(|(name, place)| (*place, (*name).to_owned())).collect()
}

/// Sends each place elsewhere, so that a part seldom fills two neighbours: compilers would look for operations to do in
/// pairs behind every such pair of stores, and find none.
fn scatter<'p>(list: impl Iterator<Item = &'p mut (usize, String)>, places: usize) {
    let shares_factor = |a: usize| (2..=a).any(|d| a.is_multiple_of(d) && places.is_multiple_of(d));
    let stride = (places * 3 / 8..places).find(|stride| *stride > 0 && !shares_factor(*stride)).unwrap_or(1);
    for (place, _) in list {
        *place = *place * stride % places;
    }
}

/// Arguments of which no more is read than these variables.
fn restricted(arguments: &[Argument], needed: &FxHashSet<&str>) -> Vec<Argument> {
    let kept = |variable: &String| needed.contains(variable.as_str());
    let restrict = |argument: &Argument| match argument {
        Argument::Parameters { read } => {
            Argument::Parameters { read: read.iter().filter(|(_, variable)| kept(variable)).cloned().collect() }
        }
        Argument::Array { name, entries } => {
            let entries = entries.iter().map(|entry| entry.clone().filter(kept)).collect();
            Argument::Array { name, entries }
        }
        Argument::Number(variable) => Argument::Number(variable.clone().filter(kept)),
    };
    arguments.iter().map(restrict).collect()
}
