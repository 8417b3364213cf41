//! Names in generated code: of variables, modules and types.
//!
//! Invariant: different symbols get different variables, and no variable is a word of the target's language, an argument of the
//! generated functions or a name that is in scope there. Which these are, the target states.

use rustc_hash::{FxHashMap, FxHashSet};
use tripos_derive::algebra::print::text;
use tripos_derive::algebra::{Arena, Expr, Function, Node};

/// What a plan asks of the language that it is for.
pub struct Language {
    /// Whether a word of letters, digits and underscores may be a variable's name.
    pub is_name: fn(&str) -> bool,
    /// Names that generated functions use for other things.
    pub in_scope: &'static [&'static str],
}

impl Language {
    /// No language: every word is a name. For plans that are counted and not written.
    pub const NONE: Self = Self { is_name: |_| true, in_scope: &[] };
}

/// Gives each name out once.
#[derive(Clone)]
pub struct Allocator {
    is_name: fn(&str) -> bool,
    taken: FxHashSet<String>,
}

impl Allocator {
    /// With the names in scope already taken.
    #[must_use]
    pub fn new(language: &Language) -> Self {
        Self { is_name: language.is_name, taken: language.in_scope.iter().copied().map(str::to_owned).collect() }
    }

    /// Whether a name was not given out yet.
    #[must_use]
    pub fn is_free(&self, name: &str) -> bool {
        !self.taken.contains(name)
    }

    /// Takes names back, to be given out once more.
    pub fn release<'n>(&mut self, names: impl Iterator<Item = &'n String>) {
        for name in names {
            self.taken.remove(name);
        }
    }

    /// `wanted`, with an underscore behind it if it is a word of the language, or with a number if it is taken.
    pub fn unique(&mut self, wanted: &str) -> String {
        let candidates = std::iter::once(if (self.is_name)(wanted) { wanted.to_owned() } else { format!("{wanted}_") });
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
    #[must_use]
    pub fn new(arena: &Arena, language: &Language, type_name: &str) -> Self {
        let mut allocator = Allocator::new(language);
        allocator.taken.insert(type_name.to_owned());
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

/// Letters and digits of a formula as one word, if that is short enough.
#[must_use]
pub fn identifier(formula: &str, longest: usize) -> Option<String> {
    let spelled = formula.replace('-', "_minus_").replace('+', "_plus_").replace('/', "_by_");
    let words: Vec<&str> =
        spelled.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|w| !w.is_empty()).collect();
    let word = words.join("_").split('_').filter(|w| !w.is_empty()).collect::<Vec<_>>().join("_").to_lowercase();
    (word.len() <= longest && word.starts_with(|c: char| c.is_ascii_alphabetic())).then_some(word)
}

/// Names given so far.
pub struct Names {
    /// All that are taken.
    pub allocator: Allocator,
    /// Of the sine and the cosine of each angle.
    circular: FxHashMap<Expr, (String, String)>,
}

impl Names {
    /// Beside those that are taken.
    #[must_use]
    pub fn new(allocator: Allocator) -> Self {
        Self { allocator, circular: FxHashMap::default() }
    }

    /// The variables of an angle's sine and cosine: `s1`, `c1` for q1, `sin_theta`, `cos_theta` for others.
    pub fn circular(&mut self, arena: &Arena, angle: Expr) -> (String, String) {
        if let Some(known) = self.circular.get(&angle) {
            return known.clone();
        }
        let digits = arena.symbol_name(angle).and_then(|name| name.strip_prefix('q'));
        let digits = digits.filter(|d| !d.is_empty() && d.bytes().all(|b| b.is_ascii_digit()));
        let mut name = |long: &str, short: &str| match (digits, arena.symbol_name(angle)) {
            (Some(digits), _) => self.allocator.unique(&format!("{short}{digits}")),
            (None, Some(symbol)) => self.allocator.unique(&format!("{long}_{}", spelled(symbol))),
            (None, None) => {
                let word = identifier(&text(arena, angle), 24).unwrap_or_else(|| "angle".to_owned());
                self.allocator.unique(&format!("{long}_{word}"))
            }
        };
        let pair = (name("sin", "s"), name("cos", "c"));
        self.circular.insert(angle, pair.clone());
        pair
    }

    /// A name after what the term holds, or after the output that needs it first.
    pub fn descriptive(
        &mut self,
        arena: &Arena,
        variables: &Variables,
        e: Expr,
        needs: &FxHashMap<Expr, String>,
    ) -> String {
        let factors: Vec<(Expr, i32)> = match arena.node(e) {
            Node::Product(factors) => factors.to_vec(),
            Node::Sum(constant, terms) if constant.is_zero() && terms.len() == 1 => match arena.node(terms[0].0) {
                Node::Product(factors) => factors.to_vec(),
                _ => vec![(terms[0].0, 1)],
            },
            _ => Vec::new(),
        };
        let mut words = Vec::new();
        for (base, n) in &factors {
            let Some(word) = self.word(arena, variables, *base) else {
                words.clear();
                break;
            };
            let power = match n {
                1 => String::new(),
                2 => "_sq".to_owned(),
                n if *n > 0 => format!("_p{n}"),
                -1 => "_inv".to_owned(),
                n => format!("_inv{}", -n),
            };
            words.push(format!("{word}{power}"));
        }
        let joined = words.join("_").to_lowercase();
        if !joined.is_empty() && joined.len() <= 20 {
            let scaled = matches!(arena.node(e), Node::Sum(..));
            return self.allocator.unique(&if scaled { format!("{joined}_scaled") } else { joined });
        }
        if let Some(word) = identifier(&variables.spell(&text(arena, e)), 16) {
            return self.allocator.unique(&word);
        }
        let stem = needs.get(&e).map_or("shared", String::as_str);
        self.allocator.unique(&format!("{stem}_part"))
    }

    fn word(&mut self, arena: &Arena, variables: &Variables, base: Expr) -> Option<String> {
        match arena.node(base) {
            Node::Symbol(_) => variables.of.get(&base).cloned(),
            Node::Apply(Function::Sin, angle) => Some(self.circular(arena, *angle).0),
            Node::Apply(Function::Cos, angle) => Some(self.circular(arena, *angle).1),
            _ => None,
        }
    }
}
