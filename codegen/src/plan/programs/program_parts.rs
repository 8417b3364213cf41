//! Division of a long program into parts, each a function of its own. The compile time of a function of n lines grows
//! with n², and a single long function runs no faster than short ones.

use super::arguments::{Argument, Entry};
use super::program::Program;
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;

/// Largest number of lines of a program that is not divided into parts.
const MOST_WHOLE: usize = 1500;

/// Number of lines in each part of a divided program. The last part may have fewer.
const PART: usize = 1000;

/// Part of a long program, which becomes a generated function.
#[derive(Clone, Debug)]
pub struct Part {
    /// Arguments of the part's function, with the variables that the part reads.
    pub arguments: Vec<Argument>,
    /// Indices in the exchange array that the part reads. Each comes with the variable that receives the value.
    pub reads: Vec<(usize, String)>,
    /// Lines and outputs of the program that the part computes.
    pub program: Program,
    /// Indices in the exchange array that the part fills for later parts or for the result. Each comes with the
    /// variable that holds the value.
    pub writes: Vec<(usize, String)>,
}

/// Division of a long program into parts. A part passes values to later parts in an exchange array.
#[derive(Clone, Debug)]
pub struct Parts {
    /// Parts of the program, in the order of computation.
    pub list: Vec<Part>,
    /// Length of the array in which parts exchange values.
    pub places: usize,
    /// Indices in the exchange array of the values that the function returns, each with its variable.
    pub results: Vec<(usize, String)>,
    /// Arguments with the entries that the return value contains unchanged.
    pub arguments: Vec<Argument>,
}

impl Parts {
    /// Divides a program into parts; `None` if it is short enough to stay whole.
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
        // Variables that each part reads; the result counts as a last part.
        let mut needed: Vec<FxHashSet<&str>> = ranges.iter().map(|range| program.names_read(range.clone())).collect();
        needed.push(returned.collect());
        let mut last: FxHashMap<&str, usize> = FxHashMap::default();
        for (at, names) in needed.iter().enumerate() {
            last.extend(names.iter().map(|name| (*name, at)));
        }
        let (mut places, mut free): (usize, Vec<usize>) = (0, Vec::new());
        // Variables whose values later parts need, with their indices in the exchange array.
        let mut held: Vec<(&str, usize)> = Vec::new();
        let mut list = Vec::with_capacity(ranges.len());
        for (at, range) in ranges.into_iter().enumerate() {
            let reads = copied_exchange_slots(held.iter().filter(|(name, _)| needed[at].contains(name)));
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
            let writes = copied_exchange_slots(held[before..].iter());
            let program = Program {
                lines: program.lines[range.start.min(lines)..range.end.min(lines)].to_vec(),
                outputs: program.outputs[range.start.max(lines) - lines..range.end.max(lines) - lines].to_vec(),
                ..Program::default()
            };
            list.push(Part { arguments: part_arguments(arguments, &needed[at]), reads, program, writes });
        }
        let mut results = copied_exchange_slots(held.iter());
        spread_exchange_slots(
            list.iter_mut().flat_map(|part| part.reads.iter_mut().chain(&mut part.writes)).chain(&mut results),
            places,
        );
        let arguments = part_arguments(arguments, &needed[list.len()]);
        Some(Self { list, places, results, arguments })
    }
}

/// Copies pairs (variable, index in the exchange array) as pairs (index, variable).
fn copied_exchange_slots<'v>(held: impl Iterator<Item = &'v (&'v str, usize)>) -> Vec<(usize, String)> {
    held.map(|(name, place)| (*place, (*name).to_owned())).collect()
}

/// Permutes the indices in the exchange array, so that a part seldom stores to two neighbours. After such stores,
/// compilers search in vain for operations to do in pairs.
fn spread_exchange_slots<'p>(list: impl Iterator<Item = &'p mut (usize, String)>, places: usize) {
    let shares_factor = |a: usize| (2..=a).any(|d| a.is_multiple_of(d) && places.is_multiple_of(d));
    let stride = (places * 3 / 8..places).find(|stride| *stride > 0 && !shares_factor(*stride)).unwrap_or(1);
    for (place, _) in list {
        *place = *place * stride % places;
    }
}

/// Returns the arguments with only those variables that are in `needed`. All other variables are dropped.
fn part_arguments(arguments: &[Argument], needed: &FxHashSet<&str>) -> Vec<Argument> {
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
