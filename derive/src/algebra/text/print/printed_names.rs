//! Printed names of symbols: the names that documents show, which may differ from the names in
//! files. Names are also split into letters, subscript and dots for printing.

use crate::algebra::Arena;

impl Arena {
    /// Sets the name of a symbol in documents: `printed` is shown in LaTeX, Typst, Markdown and
    /// `MathML` in place of `name`. Primes after the name are kept. Plain text and programs keep
    /// the name of the model file.
    pub fn set_printed_name(&mut self, name: &str, printed: &str) {
        self.names.printed.insert(name.to_owned(), printed.to_owned());
    }

    /// Removes all printed names that were set by [`Arena::set_printed_name`], so that documents
    /// show symbols by their own names.
    pub fn clear_printed_names(&mut self) {
        self.names.printed.clear();
    }
}

/// Name with which documents show a symbol: the name given to [`Arena::set_printed_name`], else the
/// symbol's own. Primes are kept.
#[must_use]
pub fn printed_name(arena: &Arena, name: &str) -> String {
    let stem = name.trim_end_matches('\'');
    match arena.names.printed.get(stem) {
        Some(printed) => format!("{printed}{}", &name[stem.len()..]),
        None => name.to_owned(),
    }
}

/// Splits a symbol's name into (letters, subscript, number of primes): `q12'` is (q, 12, 1), `m_p`
/// is (m, p, 0).
pub(super) fn split_name(name: &str) -> (&str, &str, usize) {
    // `v(my_disk, P) @ A [1]` is the name of a quantity, which has no subscript.
    if name.contains('(') {
        return (name, "", 0);
    }
    let stem = name.trim_end_matches('\'');
    let primes = name.len() - stem.len();
    if let Some((letters, subscript)) = stem.split_once('_')
        && !letters.is_empty()
        && !subscript.is_empty()
    {
        return (letters, subscript, primes);
    }
    // mA is m with the subscript A.
    if let Some(rest) = stem.get(1..)
        && stem.starts_with(|c: char| c.is_ascii_lowercase())
        && rest.starts_with(|c: char| c.is_ascii_uppercase())
    {
        return (&stem[..1], rest, primes);
    }
    let letters = stem.trim_end_matches(|c: char| c.is_ascii_digit());
    if letters.len() == 1 || letters.len() < stem.len() {
        return (letters, &stem[letters.len()..], primes);
    }
    // Ixx is I with the subscript xx: a capital letter and the letters after it, unless the word is
    // the name of a Greek letter.
    if !GREEK.iter().any(|(greek, _)| *greek == letters)
        && letters.len() <= 4
        && letters.starts_with(|c: char| c.is_ascii_uppercase())
    {
        return (&letters[..1], &letters[1..], primes);
    }
    (letters, "", primes)
}

/// Name without an underscore that would be printed in the same way as `name`: `l1` for `l_1`.
/// `None` if there is no such name.
pub(super) fn name_printed_alike(name: &str) -> Option<String> {
    let (letters, subscript, _) = split_name(name);
    let other = format!("{letters}{subscript}");
    let is_split = name.contains('_') && !subscript.is_empty();
    (is_split && split_name(&other) == (letters, subscript, 0)).then_some(other)
}

/// Greek letters, each as its name and its character.
pub(super) const GREEK: [(&str, &str); 33] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("iota", "ι"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("upsilon", "υ"),
    ("phi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Xi", "Ξ"),
    ("Pi", "Π"),
    ("Sigma", "Σ"),
    ("Upsilon", "Υ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
];

/// Reads a word that is a Greek letter's name with digits: `theta12` gives the name and character
/// of θ, and the digits 12. `None` for any other word.
pub(super) fn greek_index(word: &str) -> Option<((&'static str, &'static str), &str)> {
    let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let greek = GREEK.iter().find(|(name, _)| *name == letters)?;
    Some((*greek, &word[letters.len()..]))
}

/// Name of a Greek letter, given its character in any of its forms. `None` for any other character.
pub(in crate::algebra::text) fn greek_name(letter: char) -> Option<&'static str> {
    /// Alternative forms of Greek letters.
    const VARIANTS: [(char, &str); 3] = [('ϵ', "epsilon"), ('ϑ', "theta"), ('ϕ', "phi")];
    let variant = VARIANTS.iter().find(|(other, _)| *other == letter).map(|(_, name)| *name);
    variant.or_else(|| GREEK.iter().find(|(_, text)| text.chars().eq([letter])).map(|(name, _)| *name))
}

/// True if a subscript is printed as a word in roman type: it has letters and at least three
/// characters, such as `track`. False for indices such as `xy` and `12`.
pub(super) fn is_word(subscript: &str) -> bool {
    subscript.len() > 2 && subscript.bytes().any(|b| b.is_ascii_alphabetic())
}

/// Splits a symbol's name into its letters, its subscript and its number of dots. Greek letters
/// become characters.
///
/// ```
/// use tripos_derive::algebra::text::print::name_parts;
///
/// assert_eq!(name_parts("theta1'"), ("θ".to_owned(), "1".to_owned(), 1));
/// assert_eq!(name_parts("u_psi"), ("u".to_owned(), "ψ".to_owned(), 0));
/// assert_eq!(name_parts("m_p"), ("m".to_owned(), "p".to_owned(), 0));
/// ```
#[must_use]
pub fn name_parts(name: &str) -> (String, String, usize) {
    let (letters, subscript, primes) = split_name(name);
    let letters = GREEK.iter().find(|(n, _)| *n == letters).map_or(letters, |(_, greek)| greek);
    let subscript =
        greek_index(subscript).map_or_else(|| subscript.to_owned(), |((_, c), index)| format!("{c}{index}"));
    (letters.to_owned(), subscript, primes)
}
