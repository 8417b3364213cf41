//! Names in generated code: of variables, fields, modules and types.
//!
//! Invariant: different symbols get different variables, and no variable is a keyword, an argument of the
//! generated functions or a name that is in scope there.

use rustc_hash::{FxHashMap, FxHashSet};
use tripos_derive::Model;
use tripos_derive::algebra::{Arena, Expr};

/// Names in scope of the bodies of generated functions, and those that a pattern takes for something else.
const IN_SCOPE: [&str; 29] = [
    "p",
    "q",
    "u",
    "q_dot",
    "v_dot",
    "out",
    "zero",
    "S",
    "Parameters",
    "Scalar",
    "System",
    // Of the recurrences.
    "series",
    "history",
    "order",
    "count",
    "count_last",
    "over_k",
    "sums",
    "next",
    "pair",
    "pair_sums",
    "padded",
    "rows",
    "Factors",
    "SLACK",
    // Constants and variants that a name cannot hide.
    "None",
    "Some",
    "Ok",
    "Err",
];

/// Gives each name out once.
#[derive(Clone)]
pub struct Allocator {
    taken: FxHashSet<String>,
}

impl Allocator {
    /// With the names in scope already taken, that of the equations' own type among them.
    pub fn new(type_name: &str) -> Self {
        Self { taken: IN_SCOPE.iter().copied().chain([type_name]).map(str::to_owned).collect() }
    }

    /// Whether a name was not given out yet.
    pub fn is_free(&self, name: &str) -> bool {
        !self.taken.contains(name)
    }

    /// Takes names back, to be given out once more.
    pub fn release<'n>(&mut self, names: impl Iterator<Item = &'n String>) {
        for name in names {
            self.taken.remove(name);
        }
    }

    /// `wanted`, with an underscore behind it if that is a keyword, or with a number if it is taken.
    pub fn unique(&mut self, wanted: &str) -> String {
        // `gen` is a keyword since the edition of 2024.
        let usable = syn::parse_str::<syn::Ident>(wanted).is_ok() && !["_", "gen"].contains(&wanted);
        let candidates = std::iter::once(if usable { wanted.to_owned() } else { format!("{wanted}_") });
        let candidates = candidates.chain((2..).map(|n| format!("{wanted}_{n}")));
        let found = candidates.into_iter().find(|name| !self.taken.contains(name)).expect("numbers do not end");
        self.taken.insert(found.clone());
        found
    }
}

/// The variable of each symbol: `q1'` is held in `q1_dot`.
#[derive(Clone)]
pub struct Variables {
    /// By symbol.
    pub of: FxHashMap<Expr, String>,
    /// What is taken by them.
    pub allocator: Allocator,
    /// The variables of symbols that sharing introduced, by their names in formulas.
    shared: FxHashMap<String, String>,
}

impl Variables {
    /// Variables for all symbols of an arena, in order of declaration, beside a type of this name.
    pub fn new(arena: &Arena, type_name: &str) -> Self {
        let mut allocator = Allocator::new(type_name);
        let mut of = FxHashMap::default();
        for name in arena.symbol_names() {
            let Some(symbol) = arena.find_symbol(name) else { continue };
            of.insert(symbol, allocator.unique(&spelled(name)));
        }
        Self { of, allocator, shared: FxHashMap::default() }
    }

    /// Enters the variable of a symbol that sharing introduced.
    pub fn insert(&mut self, arena: &Arena, symbol: Expr, name: &str) {
        self.of.insert(symbol, name.to_owned());
        self.shared.insert(arena.symbol_name(symbol).unwrap_or_default().to_owned(), name.to_owned());
    }

    /// A formula with the variables of symbols that sharing introduced: they are spelled `#1`, `#2`, …, or `#` before what
    /// they hold.
    #[must_use]
    pub fn spell(&self, formula: &str) -> String {
        let mut parts = formula.split('#');
        let mut spelled = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            let digits = part.bytes().take_while(u8::is_ascii_digit).count();
            let name = self.shared.get(&format!("#{}", &part[..digits]));
            spelled.push_str(name.map_or(&part[..digits], String::as_str));
            spelled.push_str(&part[digits..]);
        }
        spelled
    }
}

/// A symbol's name in letters: dots for primes.
#[must_use]
pub fn spelled(symbol: &str) -> String {
    let stem = symbol.trim_end_matches('\'');
    let dots = ["", "_dot", "_ddot"][(symbol.len() - stem.len()).min(2)];
    format!("{stem}{dots}")
}

/// The struct field of each parameter: its own name, escaped where it is a keyword.
#[must_use]
pub fn fields(model: &Model) -> Vec<String> {
    let mut allocator = Allocator { taken: FxHashSet::default() };
    model.parameters.iter().map(|p| allocator.unique(&p.name)).collect()
}

/// The unit struct of equations of this name: `NewtonEuler` for `newton-euler`, `PrintedKaneFinal` for
/// `printed:kane-final`.
#[must_use]
pub fn type_name(name: &str) -> String {
    let words = name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.map(|word| word[..1].to_ascii_uppercase() + &word[1..]).collect()
}

/// The module of equations of this name: `newton_euler` for `newton-euler`.
#[must_use]
pub fn module_name(name: &str) -> String {
    let words: Vec<&str> = name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()).collect();
    words.join("_").to_ascii_lowercase()
}
