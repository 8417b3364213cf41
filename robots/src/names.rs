//! Names of a model file, made from names of a robot description.

use std::collections::BTreeSet;

/// Words of formulas, which cannot be names.
const WORDS: [&str; 26] = [
    "sin", "cos", "tan", "sec", "csc", "cot", "sqrt", "exp", "log", "asin", "acos", "atan", "sinh", "cosh", "tanh",
    "abs", "sign", "min", "max", "atan2", "distance", "pi", "t", "deg", "ground", "rad",
];
/// Largest number of characters of a name from the description; affixes come in addition.
const LONGEST: usize = 36;

/// Names that are in use.
#[derive(Default)]
pub struct Names(BTreeSet<String>);

impl Names {
    /// Creates a set of names with those that every model made from a description has.
    pub fn new() -> Self {
        Self(["N", "O", "g"].map(str::to_owned).into())
    }

    /// Makes a name from `wanted` such that the name with each affix is unused, and reserves these names. In an affix
    /// `*` stands for the name. Letters outside ASCII and other characters become `_`.
    pub fn reserve(&mut self, wanted: &str, affixes: &[&str]) -> String {
        let mut base: String = wanted.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
        if !base.starts_with(|c: char| c.is_ascii_alphabetic()) {
            base.insert(0, 'x');
        }
        base.truncate(LONGEST);
        let base = base.trim_end_matches('_');
        let with_affixes =
            |name: &str| -> Vec<String> { affixes.iter().map(|affix| affix.replace('*', name)).collect() };
        let is_free = |name: &str| {
            let names = with_affixes(name);
            names.iter().all(|name| !self.0.contains(name) && !WORDS.contains(&name.as_str()))
        };
        let mut name = base.to_owned();
        let mut count = 1;
        while !is_free(&name) {
            count += 1;
            name = format!("{base}_{count}");
        }
        self.0.extend(with_affixes(&name));
        name
    }
}
