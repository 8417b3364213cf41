//! Names in generated code for variables, modules and types.
//!
//! Invariant: different symbols get different variables. No variable is a word of the target's language, an argument
//! of the generated functions, or a name in their scope. The target states these words and names.

use rustc_hash::{FxHashMap, FxHashSet};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::{Arena, Expr, Function, Node, Rational};

/// Largest number of bytes of a variable name that spells out its term's formula.
const LONGEST: usize = 24;
/// Largest number of bytes that a list of variables may have in the name of a term. A longer list becomes the word
/// `motion` or `place`.
const LONGEST_LIST: usize = 12;

/// Rules of a target language for names of variables.
pub struct Language {
    /// Test of a word of letters, digits and underscores: true if it may be the name of a variable.
    pub is_name: fn(&str) -> bool,
    /// Names that generated functions use for other purposes, so that no variable may have them.
    pub in_scope: &'static [&'static str],
    /// Largest number of bytes of a variable's name in the language.
    pub longest: usize,
}

impl Language {
    /// Rules that forbid no name. They serve plans of which only the operations are counted, and no text is written.
    pub const NONE: Self = Self { is_name: |_| true, in_scope: &[], longest: usize::MAX };
}

/// Allocator of variable names, which gives out each name only once.
#[derive(Clone)]
pub struct Allocator {
    /// Test of a word: true if it may be the name of a variable in the language.
    is_name: fn(&str) -> bool,
    /// Largest number of bytes of a variable's name in the language.
    longest: usize,
    /// Names that the allocator has already given out, and names that are forbidden.
    taken: FxHashSet<String>,
}

impl Allocator {
    /// Returns an allocator in which the names in the scope of generated functions are already in
    /// use.
    #[must_use]
    pub fn new(language: &Language) -> Self {
        let Language { is_name, longest, .. } = *language;
        Self { is_name, longest, taken: language.in_scope.iter().copied().map(str::to_owned).collect() }
    }

    /// True if the name is still free: neither given out by the allocator nor forbidden.
    #[must_use]
    pub fn is_free(&self, name: &str) -> bool {
        !self.taken.contains(name)
    }

    /// Releases names, so that the allocator can give them out again.
    pub fn release<'n>(&mut self, names: impl Iterator<Item = &'n String>) {
        for name in names {
            self.taken.remove(name);
        }
    }

    /// Returns a free name like `wanted` and marks it as used. A reserved word gets an underscore, and a used name
    /// gets a number. A name that is too long is cut. A word that no underscore makes valid gets `v_` at its front.
    pub fn unique(&mut self, wanted: &str) -> String {
        // Eight bytes are left for an underscore or a number.
        let room = self.longest.saturating_sub(8);
        let cut = if wanted.len() > room { wanted.chars().take(room - 2).collect() } else { wanted.to_owned() };
        let letters = |c: char| if c.is_ascii_alphanumeric() { c } else { ' ' };
        let words = || cut.chars().map(letters).collect::<String>().split_whitespace().collect::<Vec<_>>().join("_");
        let underscored = format!("{cut}_");
        let (stem, first) = match [(self.is_name)(&cut), (self.is_name)(&underscored)] {
            [true, _] => (cut.clone(), cut),
            [false, true] => (cut, underscored),
            [false, false] => (format!("v_{}", words()), format!("v_{}", words())),
        };
        let candidates = std::iter::once(first).chain((2..).map(|n| format!("{stem}_{n}")));
        let found = candidates.into_iter().find(|name| !self.taken.contains(name)).expect("numbers do not end");
        self.taken.insert(found.clone());
        found
    }
}

/// Names of the variables for the symbols in generated code. For example, the symbol `q1'` has the variable `q1_dot`.
#[derive(Clone)]
pub struct SymbolVariableNames {
    /// Variable names in generated code, by symbol.
    pub of: FxHashMap<Expr, String>,
    /// Allocator that gave out the variable names.
    pub allocator: Allocator,
    /// Symbols of motion variables, rates and accelerations. The name of a term that contains such symbols mentions
    /// them.
    pub moving: FxHashSet<Expr>,
    /// Terms for which the symbols of shared operations stand, by symbol.
    pub behind: FxHashMap<Expr, Expr>,
    /// Variable names of the symbols of shared operations, by the symbols' names in formulas, such
    /// as `#1`.
    shared: FxHashMap<String, String>,
}

impl SymbolVariableNames {
    /// Creates variable names for all symbols of an arena, in the order of their declaration. No variable gets the
    /// name `type_name`.
    #[must_use]
    pub fn new(arena: &Arena, language: &Language, type_name: &str) -> Self {
        let mut allocator = Allocator::new(language);
        allocator.taken.insert(type_name.to_owned());
        let mut of = FxHashMap::default();
        for name in arena.symbol_names() {
            let Some(symbol) = arena.find_symbol(name) else { continue };
            of.insert(symbol, allocator.unique(&variable_name_without_primes(name)));
        }
        Self { of, allocator, moving: FxHashSet::default(), behind: FxHashMap::default(), shared: FxHashMap::default() }
    }

    /// Adds the variable `name` for a symbol of a shared operation.
    pub fn insert(&mut self, arena: &Arena, symbol: Expr, name: &str) {
        self.of.insert(symbol, name.to_owned());
        self.shared.insert(arena.symbol_name(symbol).unwrap_or_default().to_owned(), name.to_owned());
    }

    /// Returns a word that lists the variables on which a term depends. They are its motion variables and rates or,
    /// if there are none, its other symbols. If the list is long, the word is `motion` or `place`.
    fn dependence_word(&self, arena: &Arena, e: Expr) -> String {
        let (mut symbols, mut stack, mut seen) = (Vec::new(), vec![e], FxHashSet::default());
        while let Some(e) = stack.pop() {
            if !seen.insert(e) {
                continue;
            }
            match (self.behind.get(&e), arena.node(e)) {
                (Some(value), _) => stack.push(*value),
                (None, Node::Symbol(_)) => symbols.push(e),
                (None, _) => stack.extend(arena.operands(e)),
            }
        }
        symbols.sort_unstable();
        let moving: Vec<Expr> = symbols.iter().copied().filter(|e| self.moving.contains(e)).collect();
        let (list, many) = if moving.is_empty() { (symbols, "place") } else { (moving, "motion") };
        let names: Vec<&str> = list.iter().filter_map(|e| self.of.get(e)).map(String::as_str).collect();
        let word = names.join("_").to_lowercase();
        if word.len() > LONGEST_LIST { many.to_owned() } else { word }
    }

    /// Returns a formula in which the symbols of shared operations, spelled `#1`, `#2` and so on, are replaced by
    /// their variable names.
    #[must_use]
    pub fn write_shared_names(&self, formula: &str) -> String {
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

/// Returns the name of a symbol without primes, such as `q1_dot` for `q1'` and `q1_ddot` for `q1''`.
#[must_use]
pub fn variable_name_without_primes(symbol: &str) -> String {
    let stem = symbol.trim_end_matches('\'');
    let dots = ["", "_dot", "_ddot"][(symbol.len() - stem.len()).min(2)];
    format!("{stem}{dots}")
}

/// Returns the name of the Rust type for a set of equations, such as `NewtonEuler` for `newton-euler` and
/// `PrintedKaneFinal` for `printed:kane-final`.
#[must_use]
pub fn type_name(name: &str) -> String {
    let words = name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.map(|word| word[..1].to_ascii_uppercase() + &word[1..]).collect()
}

/// Returns the name of the module for a set of equations, such as `newton_euler` for `newton-euler`.
#[must_use]
pub fn module_name(name: &str) -> String {
    let words: Vec<&str> = name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()).collect();
    words.join("_").to_ascii_lowercase()
}

/// Returns a word made of the letters and digits of a formula. `None` if this word would be longer than `longest`
/// bytes or would not begin with a letter.
#[must_use]
pub fn variable_word_of_formula(formula: &str, longest: usize) -> Option<String> {
    let spelled = formula.replace('-', "_minus_").replace('+', "_plus_").replace('/', "_by_");
    let words: Vec<&str> =
        spelled.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|w| !w.is_empty()).collect();
    let word = words.join("_").split('_').filter(|w| !w.is_empty()).collect::<Vec<_>>().join("_").to_lowercase();
    (word.len() <= longest && word.starts_with(|c: char| c.is_ascii_alphabetic())).then_some(word)
}

/// Variable names that one program gives to its intermediate terms.
pub struct TermVariableNames {
    /// Allocator that holds all names in use.
    pub allocator: Allocator,
    /// Variables of the sine and the cosine, by angle.
    circular: FxHashMap<Expr, (String, String)>,
}

impl TermVariableNames {
    /// Prepares names for a new program. Names that the allocator has already given out are not used again.
    #[must_use]
    pub fn new(allocator: Allocator) -> Self {
        Self { allocator, circular: FxHashMap::default() }
    }

    /// Returns the variables of an angle's sine and cosine, such as `s1` and `c1` for the symbol q1, or `sin_theta`
    /// and `cos_theta`.
    pub fn sine_and_cosine_names(&mut self, arena: &Arena, angle: Expr) -> (String, String) {
        if let Some(known) = self.circular.get(&angle) {
            return known.clone();
        }
        let digits = arena.symbol_name(angle).and_then(|name| name.strip_prefix('q'));
        let digits = digits.filter(|d| !d.is_empty() && d.bytes().all(|b| b.is_ascii_digit()));
        let mut name = |long: &str, short: &str| match (digits, arena.symbol_name(angle)) {
            (Some(digits), _) => self.allocator.unique(&format!("{short}{digits}")),
            (None, Some(symbol)) => self.allocator.unique(&format!("{long}_{}", variable_name_without_primes(symbol))),
            (None, None) => {
                let word =
                    variable_word_of_formula(&print_text(arena, angle), 24).unwrap_or_else(|| "angle".to_owned());
                self.allocator.unique(&format!("{long}_{word}"))
            }
        };
        let pair = (name("sin", "s"), name("cos", "c"));
        self.circular.insert(angle, pair.clone());
        pair
    }

    /// Returns a free name that describes a term, and marks it as used.
    pub fn take_descriptive_name(
        &mut self,
        arena: &Arena,
        variables: &SymbolVariableNames,
        e: Expr,
        stem: &str,
    ) -> String {
        let wanted = self.descriptive_name(arena, variables, e, stem);
        self.allocator.unique(&wanted)
    }

    /// Returns a name that describes a term. It is the term's formula as a word, if that is short. Otherwise it is
    /// `stem` and the variables on which the term depends. The name may already be in use.
    pub fn descriptive_name(&mut self, arena: &Arena, variables: &SymbolVariableNames, e: Expr, stem: &str) -> String {
        let word = self.name_of_formula(arena, variables, e).map(|word| word.to_lowercase());
        let word = word.filter(|word| word.len() <= LONGEST && word.starts_with(|c: char| c.is_ascii_alphabetic()));
        word.unwrap_or_else(|| format!("{stem}_of_{}", variables.dependence_word(arena, e)))
    }

    /// Returns the formula of a term as a word, such as `u2_by_c2` or `r_s1_plus_x`. `None` if the
    /// formula is nested too deeply to be read as a word.
    fn name_of_formula(&mut self, arena: &Arena, variables: &SymbolVariableNames, e: Expr) -> Option<String> {
        match arena.node(e) {
            Node::Sum(constant, terms) => {
                let mut out = if constant.is_zero() { String::new() } else { variable_word_with_factor("", constant)? };
                for (term, k) in terms {
                    let word = variable_word_with_factor(&self.name_of_product(arena, variables, *term)?, k)?;
                    let joint = match (out.is_empty(), k.is_negative()) {
                        (true, false) => "",
                        (true, true) => "minus_",
                        (false, false) => "_plus_",
                        (false, true) => "_minus_",
                    };
                    out = format!("{out}{joint}{word}");
                }
                Some(out)
            }
            _ => self.name_of_product(arena, variables, e),
        }
    }

    /// Returns a product as a word, factor by factor, such as `m_r_sq`. `None` if a factor has no
    /// word.
    fn name_of_product(&mut self, arena: &Arena, variables: &SymbolVariableNames, e: Expr) -> Option<String> {
        let factors = match arena.node(e) {
            Node::Product(factors) => factors.to_vec(),
            _ => vec![(e, 1)],
        };
        let mut words = Vec::new();
        for (base, n) in factors {
            let sum = matches!(arena.node(base), Node::Sum(..));
            let word = if sum {
                self.name_of_denominator(arena, variables, base, n)?
            } else {
                self.name_of_atom(arena, variables, base)?
            };
            words.push(match n {
                1 => word,
                2 => format!("{word}_sq"),
                n if n > 0 => format!("{word}_p{n}"),
                -1 if sum => format!("over_{word}"),
                -1 => format!("{word}_inv"),
                n => format!("{word}_inv{}", -n),
            });
        }
        Some(words.join("_"))
    }

    /// Returns a word for a sum in a denominator. `None` for a sum elsewhere, because the product
    /// would seem to end with the sum's first term.
    fn name_of_denominator(
        &mut self,
        arena: &Arena,
        variables: &SymbolVariableNames,
        e: Expr,
        n: i32,
    ) -> Option<String> {
        let flat = |e: &Expr| arena.operands(*e).all(|part| !matches!(arena.node(part), Node::Sum(..)));
        let is_flat = flat(&e) && arena.operands(e).all(|part| flat(&part));
        if n == -1 && is_flat { self.name_of_formula(arena, variables, e) } else { None }
    }

    /// Returns a word for a symbol, π, or a function of a symbol. `None` for other terms.
    fn name_of_atom(&mut self, arena: &Arena, variables: &SymbolVariableNames, e: Expr) -> Option<String> {
        match arena.node(e) {
            Node::Symbol(_) => variables.of.get(&e).cloned(),
            Node::Apply(Function::Sin, angle) => Some(self.sine_and_cosine_names(arena, *angle).0),
            Node::Apply(Function::Cos, angle) => Some(self.sine_and_cosine_names(arena, *angle).1),
            Node::Apply(f, argument) => {
                Some(format!("{}_{}", f.name(), self.name_of_atom(arena, variables, *argument)?))
            }
            Node::Pi => Some("pi".to_owned()),
            Node::Number(_) | Node::Sum(..) | Node::Product(_) | Node::Named(..) => None,
        }
    }
}

/// Returns `word` with a rational factor, such as `x_doubled`, `x_by_4` or `x_times_3_by_2`. If `word` is empty, the
/// result is the number alone. The sign of the factor is ignored. `None` if the number is long.
fn variable_word_with_factor(word: &str, k: &Rational) -> Option<String> {
    let (n, d) = k.small()?;
    let (n, d) = (n.unsigned_abs(), d.unsigned_abs());
    if word.is_empty() {
        return Some(if d == 1 { n.to_string() } else { format!("{n}_by_{d}") });
    }
    Some(match (n, d) {
        (1, 1) => word.to_owned(),
        (2, 1) => format!("{word}_doubled"),
        (1, 2) => format!("{word}_halved"),
        (1, d) => format!("{word}_by_{d}"),
        (n, 1) => format!("{word}_times_{n}"),
        (n, d) => format!("{word}_times_{n}_by_{d}"),
    })
}
