//! Mutations of texts and bytes.

use crate::campaign::Random;

/// Tokens that a mutation inserts or puts in the place of others.
const TOKENS: [&str; 84] = [
    "0",
    "-1",
    "1e999",
    "-1e999",
    "1e-999",
    "10^400",
    "10^-4000",
    "1/0",
    "0/0",
    "9223372036854775808",
    "1e308*10",
    "18446744073709551616",
    "-9223372036854775809",
    "4294967296",
    "0x10",
    "1_000",
    "1e",
    ".",
    "..",
    "1.2.3",
    "+",
    "-",
    "--",
    "*",
    "**",
    "/",
    "//",
    "^",
    "^2",
    "^(1/2)",
    "^-1",
    "^x",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    "[[",
    "]]",
    "<",
    ">",
    "=",
    "==",
    ",",
    ";",
    ":",
    "#",
    "%",
    "'",
    "''",
    "\"",
    "\"\"\"",
    "'''",
    "\\",
    "\\\\",
    "\\u0000",
    "\\frac",
    "\\left(",
    "_",
    "&",
    "&amp;",
    "<!--",
    "-->",
    "/*",
    "*/",
    "pi",
    "nan",
    "inf",
    "true",
    "sin(",
    "sqrt(-1)",
    "log(0)",
    "atan2(0,0)",
    "t",
    "deg",
    "\u{1b}",
    "\u{202e}",
    "θ",
    "\u{301}",
    "🎢",
    "\u{0}",
    "\u{feff}",
    "\u{a0}",
];

/// Place in a text at which a character begins, at or after `at`.
fn boundary(text: &str, at: usize) -> usize {
    (at..=text.len()).find(|at| text.is_char_boundary(*at)).unwrap_or(text.len())
}

/// A random part of a text, as a byte range of at most `longest` bytes or a few more.
fn part(text: &str, longest: usize, random: &mut Random) -> std::ops::Range<usize> {
    let start = boundary(text, random.below(text.len() + 1));
    let end = boundary(text, (start + random.below(longest + 1)).min(text.len()));
    start..end
}

/// Words of a text: names and numbers.
fn words(text: &str) -> Vec<&str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty()).collect()
}

/// A number that is too large, too long or too precise for somebody.
fn huge_number(random: &mut Random) -> String {
    let digits = [1, 17, 19, 20, 40, 310, 400, 2000][random.below(8)];
    let nines: String = (0..digits).map(|_| char::from(b'0' + u8::try_from(random.below(10)).unwrap())).collect();
    match random.below(5) {
        0 => nines,
        1 => format!("0.{nines}"),
        2 => format!("{nines}e{nines}"),
        3 => format!("1e-{nines}"),
        _ => format!("-{nines}.5"),
    }
}

/// Brackets nested deeply around a part of a text.
fn nested(text: &str, random: &mut Random) -> String {
    const PAIRS: [(&str, &str); 10] = [
        ("(", ")"),
        ("[", "]"),
        ("{", "}"),
        ("-", ""),
        ("sin(", ")"),
        ("\\frac{1}{", "}"),
        ("{a=", "}"),
        ("<a>", "</a>"),
        ("2^", ""),
        ("\\left(", "\\right)"),
    ];
    let (open, close) = *random.one(&PAIRS);
    let depth = [3, 50, 199, 201, 3000, 20_000][random.below(6)];
    let inside = part(text, 40, random);
    let close = if random.chance(80) { close } else { "" };
    format!(
        "{}{}{}{}{}",
        &text[..inside.start],
        open.repeat(depth),
        &text[inside.clone()],
        close.repeat(depth),
        &text[inside.end..]
    )
}

/// One change to a text. `other` is a text from which parts are taken.
pub fn mutated(text: &str, other: &str, random: &mut Random) -> String {
    let at = boundary(text, random.below(text.len() + 1));
    match random.below(16) {
        0 => {
            let gone = part(text, 8, random);
            format!("{}{}", &text[..gone.start], &text[gone.end..])
        }
        1 => {
            let copied = part(text, 30, random);
            format!("{}{}{}", &text[..at], &text[copied], &text[at..])
        }
        2 | 3 => format!("{}{}{}", &text[..at], random.one(&TOKENS[..]), &text[at..]),
        4 | 5 => {
            let words = words(text);
            let Some(old) = random.one_of(&words) else { return (*random.one(&TOKENS[..])).to_owned() };
            text.replacen(old, random.one::<&str>(&TOKENS[..]), 1 + random.below(3))
        }
        6 => {
            let words = words(text);
            let (Some(old), Some(new)) = (random.one_of(&words), random.one_of(&words)) else {
                return other.to_owned();
            };
            if random.chance(50) { text.replace(old, new) } else { text.replacen(old, new, 1) }
        }
        7 | 8 => {
            // A part of another text stands for a part of this one.
            let (gone, come) = (part(text, 60, random), part(other, 120, random));
            format!("{}{}{}", &text[..gone.start], &other[come], &text[gone.end..])
        }
        9 if random.chance(20) => nested(text, random),
        10 if random.chance(50) => {
            let words = words(text);
            let numbers: Vec<&str> =
                words.into_iter().filter(|w| w.starts_with(|c: char| c.is_ascii_digit())).collect();
            let new = huge_number(random);
            match random.one_of(&numbers) {
                Some(old) => text.replacen(old, &new, 1),
                None => format!("{}{new}{}", &text[..at], &text[at..]),
            }
        }
        11 => match random.below(4) {
            0 => text.replace('\n', "\r\n"),
            1 => text.replace('\n', "\r"),
            2 => format!("\u{feff}{text}"),
            _ => text[..at].to_owned(),
        },
        12 => {
            // A character becomes any other.
            let mut random_char =
                || char::from_u32(u32::try_from(random.below(0x11_0000)).unwrap()).unwrap_or('\u{fffd}');
            let new = random_char();
            let next = text[at..].chars().next().map_or(at, |c| at + c.len_utf8());
            format!("{}{new}{}", &text[..at], &text[next..])
        }
        _ => {
            // A line goes, comes twice, or changes places with another.
            let mut lines: Vec<&str> = text.lines().collect();
            if lines.is_empty() {
                return (*random.one(&TOKENS[..])).to_owned();
            }
            let (a, b) = (random.below(lines.len()), random.below(lines.len()));
            match random.below(3) {
                0 => drop(lines.remove(a)),
                1 => lines.insert(b, lines[a]),
                _ => lines.swap(a, b),
            }
            lines.join("\n")
        }
    }
}

/// Between one and four changes to a text.
pub fn spoilt(text: &str, other: &str, random: &mut Random) -> String {
    let mut text = mutated(text, other, random);
    for _ in 0..random.below(4) {
        text = mutated(&text, other, random);
    }
    text
}

/// Changes to bytes: bits turned, bytes removed, copied or replaced, or the end cut off.
pub fn spoilt_bytes(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len());
        let any = u8::try_from(random.below(256)).unwrap();
        match random.below(7) {
            0 => bytes.truncate(at),
            1 if !bytes.is_empty() => bytes[at] ^= 1 << random.below(8),
            2 if !bytes.is_empty() => bytes[at] = any,
            3 if !bytes.is_empty() => drop(bytes.remove(at)),
            4 => bytes.insert(at, any),
            5 => {
                let end = (at + 4).min(bytes.len());
                bytes[at.min(end)..end].fill([0xff, 0x7f, 0x80, 0][random.below(4)]);
            }
            _ => {
                let copied = bytes[at..(at + 16).min(bytes.len())].to_vec();
                bytes.splice(at..at, copied);
            }
        }
    }
    bytes
}
