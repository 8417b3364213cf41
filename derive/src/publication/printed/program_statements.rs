//! Reading of the assignments of a printed program: of a function, of numbered lines, or between
//! two marks.

use super::traced_text::TracedText;
use crate::algebra::text::notation::Notation;
use std::ops::Range;

/// Largest number of assignments that are read from one part of a program.
const MAX_STATEMENTS: usize = 5000;
/// Largest number of characters in the list of arguments of a function.
const LONGEST: usize = 2000;
/// Largest number of variables that one chained assignment sets.
const MAX_CHAIN: usize = 20;
/// Words that begin a statement other than an assignment.
const KEYWORDS: [&str; 19] = [
    "if",
    "elif",
    "else",
    "elseif",
    "for",
    "while",
    "try",
    "except",
    "with",
    "switch",
    "case",
    "otherwise",
    "do",
    "parfor",
    "def",
    "class",
    "function",
    "assert",
    "goto",
];

/// Assignment in a printed program.
#[derive(Clone, Debug)]
pub struct Statement {
    /// Assigned variables, without spaces; several if a tuple is assigned.
    pub targets: Vec<String>,
    /// Operator of an assignment such as `+=`; `None` for a plain `=`.
    pub operator: Option<char>,
    /// Formula on the right side, with its place in the file.
    pub right: TracedText,
    /// True if a condition or a loop decides whether the statement is run.
    pub is_nested: bool,
    /// Byte range of the statement in the program's file.
    pub place: Range<usize>,
}

/// First and last line, counted from 1, of a text such as 12-40; `None` if the text is a name.
fn line_numbers_of_program_part(part: &str) -> Option<(usize, usize)> {
    let (first, last) = part.split_once('-')?;
    Some((first.trim().parse().ok()?, last.trim().parse().ok()?))
}

/// Assignments of a part of a program, or of the whole program if `part` is `None`.
/// Returns `None` if the part is not found, or if it has too many statements.
pub fn statements(text: &str, notation: Notation, part: Option<&str>) -> Option<Vec<Statement>> {
    let range = match part {
        None => 0..text.len(),
        Some(part) => match line_numbers_of_program_part(part) {
            Some((first, last)) => program_line_range(text, first, last)?,
            None => program_part_between_marks(text, part)
                .or_else(|| program_function_body(&program_without_comments(text, notation), notation, part))?,
        },
    };
    let clear = program_without_comments(text, notation);
    let mut list = Vec::new();
    for (range, is_nested) in program_statements_in_range(&clear, range, notation) {
        let first = list.len();
        read_program_statement(&clear, range, notation, &mut list);
        list[first..].iter_mut().for_each(|statement| statement.is_nested = is_nested);
        if list.len() > MAX_STATEMENTS {
            return None;
        }
    }
    Some(list)
}

/// True if a formula only copies a value: a name with members, indices, strings and numbers,
/// without arithmetic.
pub fn statement_copies_value(text: &str) -> bool {
    let mut depth = 0_usize;
    let mut quote = None;
    for c in text.trim().chars() {
        match (quote, c) {
            (Some(open), c) => {
                if c == open {
                    quote = None;
                }
            }
            (None, '\'' | '"') => quote = Some(c),
            (None, '(' | '[') => depth += 1,
            (None, ')' | ']') => depth = depth.saturating_sub(1),
            (None, '-') if depth > 0 => {}
            (None, '=' | ':' | ',' | ' ' | '.') => {}
            (None, c) if depth > 0 && c.is_ascii_digit() => {}
            (None, c) if depth == 0 && (c.is_alphanumeric() || c == '_' || c == '>' || c == '-') => {}
            _ => return false,
        }
    }
    // A minus sign outside of indices belongs to an arrow `->`.
    let bare = text.replace("->", "");
    depth == 0 && !bare.split(['[', '(']).next().unwrap_or_default().contains(['-', '>'])
}

/// True if a text is a decimal number, possibly with the suffix `f`.
pub fn is_program_number(text: &str) -> bool {
    let text = text.trim().trim_end_matches(['f', 'F']);
    !text.is_empty() && text.parse::<f64>().is_ok()
}

/// Byte range of the lines `first` to `last`, counted from 1; `None` if there are no such lines.
fn program_line_range(text: &str, first: usize, last: usize) -> Option<Range<usize>> {
    let mut starts = vec![0];
    starts.extend(text.match_indices('\n').map(|(at, _)| at + 1));
    let start = *starts.get(first.checked_sub(1)?)?;
    (last >= first).then(|| start..starts.get(last).copied().unwrap_or(text.len()))
}

/// Byte range between the comments `begin NAME` and `end NAME`; `None` if they do not exist.
fn program_part_between_marks(text: &str, name: &str) -> Option<Range<usize>> {
    let (mut start, mut at) = (None, 0);
    for line in text.split_inclusive('\n') {
        let next = at + line.len();
        let comment = line.trim().trim_start_matches(['#', '%', '/', '*', ' ']).trim_end_matches(['*', '/', ' ']);
        match (start, comment.split_once(' ')) {
            (None, Some(("begin", of))) if of.trim() == name => start = Some(next),
            (Some(start), Some(("end", of))) if of.trim() == name => return Some(start..at),
            _ => {}
        }
        at = next;
    }
    None
}

/// Byte range of the statements of the function `name`; `None` if it is not found.
fn program_function_body(text: &str, notation: Notation, name: &str) -> Option<Range<usize>> {
    if notation == Notation::C {
        for (at, _) in text.match_indices(name) {
            let whole = !text[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
            let behind = text[at + name.len()..].trim_start();
            let near = |rest: &str| rest.char_indices().take(LONGEST).find(|(_, c)| *c == ')').map(|(at, _)| at);
            let Some(close) = behind.strip_prefix('(').and_then(near) else { continue };
            let after = text.len() - behind.len() + 1 + close + 1;
            if whole && text[after..].trim_start().starts_with('{') {
                let open = after + text[after..].find('{')?;
                return Some(open + 1..super::latex_macros::group_end_within(text, open, text.len())? - 1);
            }
        }
        return None;
    }
    let (mut at, mut start) = (0, None);
    for line in text.split_inclusive('\n') {
        let next = at + line.len();
        let trimmed = line.trim_start();
        let indent = line.len() - trimmed.len();
        match start {
            None => {
                let called = if notation == Notation::Python {
                    trimmed.strip_prefix("def ").map(|rest| rest.split('(').next().unwrap_or_default().trim())
                } else {
                    let head = trimmed.strip_prefix("function ").map(|rest| rest.split_once('=').map_or(rest, |p| p.1));
                    head.map(|head| head.split(['(', ';']).next().unwrap_or_default().trim())
                };
                if called == Some(name) {
                    start = Some((next, indent));
                }
            }
            Some((start, _)) if notation != Notation::Python => {
                if trimmed.starts_with("function ") {
                    return Some(start..at);
                }
            }
            Some((start, outer)) if indent <= outer && !trimmed.trim().is_empty() => {
                // The closing parenthesis of a long list of arguments does not end the function.
                if !trimmed.starts_with(')') {
                    return Some(start..at);
                }
            }
            Some(_) => {}
        }
        at = next;
    }
    start.map(|(start, _)| start..text.len())
}

/// Text of equal length in which spaces replace comments and triple-quoted strings.
fn program_without_comments(text: &str, notation: Notation) -> String {
    let mut out = String::with_capacity(text.len());
    let mut at = 0;
    let blank = |out: &mut String, part: &str| out.extend(part.bytes().map(|b| if b == b'\n' { '\n' } else { ' ' }));
    while let Some(c) = text[at..].chars().next() {
        let rest = &text[at..];
        let line = || rest.find('\n').unwrap_or(rest.len());
        let until = |mark: &str, from: usize| rest[from..].find(mark).map_or(rest.len(), |end| from + end + mark.len());
        let starts_line = || out.trim_end_matches([' ', '\t']).chars().next_back().is_none_or(|c| c == '\n');
        let hidden = match notation {
            Notation::Python if c == '#' => line(),
            Notation::Python if rest.starts_with("\"\"\"") => until("\"\"\"", 3),
            Notation::Python if rest.starts_with("'''") => until("'''", 3),
            Notation::Matlab if c == '%' => line(),
            Notation::C if rest.starts_with("//") || (c == '#' && starts_line()) => line(),
            Notation::C if rest.starts_with("/*") => until("*/", 2),
            _ => 0,
        };
        if hidden > 0 {
            blank(&mut out, &rest[..hidden]);
            at += hidden;
            continue;
        }
        if notation == Notation::Matlab && rest.starts_with("...") {
            // The statement continues in the next line.
            out.extend(std::iter::repeat_n(' ', (line() + 1).min(rest.len())));
            at += (line() + 1).min(rest.len());
            continue;
        }
        let before = || out.trim_end_matches(' ').chars().next_back();
        let transposes = notation == Notation::Matlab
            && c == '\''
            && before().is_some_and(|c| c.is_alphanumeric() || matches!(c, '_' | ')' | ']' | '}' | '\'' | '.'));
        if matches!(c, '"' | '\'') && !transposes {
            let end = rest[1..line().max(1)].find(c).map_or(1, |end| end + 2);
            out.push_str(&rest[..end]);
            at += end;
            continue;
        }
        out.push(c);
        at += c.len_utf8();
    }
    out
}

/// Byte ranges of the statements in a range; the second value is true for a statement nested in a
/// condition or a loop.
fn program_statements_in_range(text: &str, range: Range<usize>, notation: Notation) -> Vec<(Range<usize>, bool)> {
    let mut list = Vec::new();
    let (mut depth, mut blocks, mut from, mut base) = (0_usize, 0_usize, range.start, None);
    let mut was_nested = false;
    let mut end = |from: usize, to: usize, blocks: &mut usize| {
        let part = &text[from..to];
        let start = from + part.len() - part.trim_start().len();
        let statement = from.max(start)..start.max(from + part.trim_end().len());
        if statement.is_empty() {
            return;
        }
        let word = text[statement.clone()].split(|c: char| !(c.is_alphanumeric() || c == '_')).next().unwrap_or("");
        let line = text[from..start].rfind('\n').map(|line| from + line + 1);
        let line = line.or((from == range.start).then_some(from)).or(text[..from].ends_with('\n').then_some(from));
        let mut nested = *blocks > 0 || KEYWORDS.contains(&word);
        if notation == Notation::Python {
            nested |= match line {
                Some(line) => start - line > *base.get_or_insert(start - line),
                // Statements on one line are run together.
                None => was_nested,
            };
        }
        was_nested = nested;
        if notation == Notation::Matlab {
            match word {
                "if" | "for" | "while" | "switch" | "try" | "parfor" => *blocks += 1,
                "end" => *blocks = blocks.saturating_sub(1),
                _ => {}
            }
        }
        list.push((statement, nested));
    };
    for (at, c) in text[range.clone()].char_indices() {
        let at = range.start + at;
        let is_c = notation == Notation::C;
        match c {
            '{' | '}' if is_c => {
                end(from, at, &mut blocks);
                from = at + 1;
                blocks = if c == '{' { blocks + 1 } else { blocks.saturating_sub(1) };
                depth = 0;
            }
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            ';' if depth == 0 => {
                end(from, at, &mut blocks);
                from = at + 1;
            }
            ',' if depth == 0 && notation == Notation::Matlab => {
                end(from, at, &mut blocks);
                from = at + 1;
            }
            '\n' if depth == 0 && !is_c && !text[from..at].trim_end().ends_with('\\') => {
                end(from, at, &mut blocks);
                from = at + 1;
            }
            _ => {}
        }
    }
    end(from, range.end, &mut blocks);
    list
}

/// Byte positions of these characters outside of parentheses, brackets and braces.
pub fn marks_outside_brackets(text: &str, marks: &[char]) -> Vec<usize> {
    let (mut depth, mut list) = (0_usize, Vec::new());
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            c if depth == 0 && marks.contains(&c) => list.push(at),
            _ => {}
        }
    }
    list
}

/// Byte ranges of the parts of a text between commas outside of parentheses, brackets and braces.
pub fn comma_parts(text: &str) -> Vec<Range<usize>> {
    let (mut list, mut from) = (Vec::new(), 0);
    for at in marks_outside_brackets(text, &[',']) {
        list.push(from..at);
        from = at + 1;
    }
    list.push(from..text.len());
    list
}

/// Adds the assignments of one statement to `list`, marked as not nested.
fn read_program_statement(text: &str, range: Range<usize>, notation: Notation, list: &mut Vec<Statement>) {
    let own = &text[range.clone()];
    let traced = |part: Range<usize>| {
        let part = TracedText::text_at_place(
            &text[range.start + part.start..range.start + part.end],
            range.start + part.start,
        );
        let line = match notation {
            // The mark that continues a line is not part of the formula.
            Notation::Python => part.text.replace("\\\n", " \n"),
            // In a MATLAB matrix, each line is a row.
            Notation::Matlab => part.text.replace('\n', ";"),
            _ => part.text,
        };
        TracedText { text: line, places: part.places }.in_one_line()
    };
    if let Some(rest) = own.strip_prefix("return ") {
        let right = traced(own.len() - rest.len()..own.len());
        let targets = vec!["return".to_owned()];
        list.push(Statement { targets, operator: None, right, is_nested: false, place: range });
        return;
    }
    let bytes = own.as_bytes();
    let is_comparison = |at: usize| {
        bytes.get(at + 1) == Some(&b'=') || (at > 0 && matches!(bytes[at - 1], b'=' | b'<' | b'>' | b'!' | b'~'))
    };
    let signs: Vec<usize> = marks_outside_brackets(own, &['=']).into_iter().filter(|at| !is_comparison(*at)).collect();
    if signs.len() > MAX_CHAIN && notation != Notation::C {
        return;
    }
    let (Some(first), Some(last)) = (signs.first().copied(), signs.last().copied()) else { return };
    // A declaration in C may contain several variables.
    let declares = own[..first].trim().contains(' ') && notation == Notation::C;
    if declares && marks_outside_brackets(own, &[',']).iter().any(|comma| *comma > first) {
        for part in comma_parts(own) {
            read_program_statement(text, range.start + part.start..range.start + part.end, notation, list);
        }
        return;
    }
    let operator = own[..first].chars().next_back().filter(|c| matches!(c, '+' | '-' | '*' | '/'));
    let left = own[..first - operator.map_or(0, char::len_utf8)].trim();
    // A type may follow a name in Python. A colon in brackets belongs to an index.
    let colon = marks_outside_brackets(left, &[':']).first().copied().unwrap_or(left.len());
    let left = if notation == Notation::Python { &left[..colon] } else { left };
    let left = if notation == Notation::C { left.rsplit([' ', '*', '&']).next().unwrap_or(left) } else { left };
    let left = left.rsplit('\n').next().unwrap_or(left);
    let tuple = left.trim().trim_start_matches(['[', '(']).trim_end_matches(',');
    let is_tuple = !marks_outside_brackets(tuple, &[',']).is_empty() || left.starts_with('[');
    let shown = |text: &str| text.replace("->", ".").replace(char::is_whitespace, "").replace('"', "'");
    let right = last + 1..own.len();
    if is_tuple {
        let names: Vec<String> =
            comma_parts(tuple).into_iter().map(|p| shown(tuple[p].trim_end_matches(')'))).collect();
        let values = comma_parts(&own[right.clone()]);
        if values.len() == names.len() && notation == Notation::Python {
            for (name, value) in names.into_iter().zip(values) {
                let right = traced(right.start + value.start..right.start + value.end);
                list.push(Statement {
                    targets: vec![name],
                    operator: None,
                    right,
                    is_nested: false,
                    place: range.clone(),
                });
            }
            return;
        }
        let names = names.into_iter().map(|name| name.trim_end_matches(']').to_owned()).collect();
        list.push(Statement { targets: names, operator: None, right: traced(right), is_nested: false, place: range });
        return;
    }
    let mut targets = vec![shown(left)];
    for pair in signs.windows(2) {
        targets.push(shown(own[pair[0] + 1..pair[1]].trim()));
    }
    // Each variable of a = b = c gets its own statement.
    for target in targets {
        let right = traced(right.clone());
        list.push(Statement { targets: vec![target], operator, right, is_nested: false, place: range.clone() });
    }
}

#[cfg(test)]
mod tests {
    use super::{statement_copies_value, statements};
    use crate::algebra::text::notation::Notation;

    fn read(text: &str, notation: Notation, part: Option<&str>) -> Vec<(String, String, bool)> {
        let list = statements(text, notation, part).unwrap();
        list.into_iter().map(|s| (s.targets.join("|"), s.right.text, s.is_nested)).collect()
    }

    fn row(target: &str, right: &str, nested: bool) -> (String, String, bool) {
        (target.to_owned(), right.to_owned(), nested)
    }

    #[test]
    fn assignments_are_found_in_each_language() {
        let text = "import x\ndef f(s, a):\n    '''a = 1'''\n    q, u = s[:-1]\n    b = (1 + # no\n      2)\n    if b == 1:\n        c = 3\n    d, e = b, 4\n    return (d, e)\ndef g(): pass\n";
        let expected = [
            row("q|u", "s[:-1]", false),
            row("b", "(1 + 2)", false),
            row("c", "3", true),
            row("d", "b", false),
            row("e", "4", false),
            row("return", "(d, e)", false),
        ];
        assert_eq!(read(text, Notation::Python, Some("f")), expected);
        let text = "function dz = rhs(t, z)\n a = z(1); b = a' ... on\n + 2; % c = 3\nif a\n b = 3;\nend\ndz(1,1) = [1, 2\n 3, 4];\nend\nfunction other\nq = 1;";
        let expected = [
            row("a", "z(1)", false),
            row("b", "a' + 2", false),
            row("b", "3", true),
            row("dz(1,1)", "[1, 2; 3, 4]", false),
        ];
        assert_eq!(read(text, Notation::Matlab, Some("rhs")), expected);
        let text = "#define A 1\nvoid f(double *x, P *p) {\n const double a = p->m * x[0], b = 2; /* c = 3; */\n if (a > 1) { b += 1; }\n dx[1] = a;\n}";
        let expected =
            [row("a", "p->m * x[0]", false), row("b", "2", false), row("b", "1", true), row("dx[1]", "a", false)];
        assert_eq!(read(text, Notation::C, Some("f")), expected);
        assert_eq!(read("a = 1\nb = 2\nc = 3", Notation::Python, Some("2-2")), [row("b", "2", false)]);
        assert_eq!(
            read("a = 1\n# begin x\nb = 2\n# end x\nc = 3", Notation::Python, Some("x")),
            [row("b", "2", false)]
        );
    }

    #[test]
    fn only_access_is_taken_as_declared() {
        for text in ["s[0]", "SX.sym('x')", "p->m", "z(1)", "state", "s[:-1]", "self.m", "z[0:2]"] {
            assert!(statement_copies_value(text), "{text}");
        }
        for text in ["-x", "2*x", "s[0] + a", "wrap(theta)", "f(x)", "a-b", "f(-x)"] {
            assert!(!statement_copies_value(text), "{text}");
        }
    }

    #[test]
    fn statements_of_one_line_share_its_condition() {
        let text = "a = 1; b = 2\nif a: c = 3; d = 4\ne = 5\nif b:\n    f = 6; g = 7\nh = 8";
        let nested = read(text, Notation::Python, None).into_iter().filter(|s| s.2).map(|s| s.0).collect::<Vec<_>>();
        // The line `if a: c = 3` reads as an assignment of its last name.
        assert_eq!(nested[1..], ["d", "f", "g"], "{nested:?}");
    }

    #[test]
    fn large_texts_cost_bounded_time() {
        let begun = std::time::Instant::now();
        for part in ["a;", "a(", "a = ", "{", "'", " ", "#", "a,", "a = 1;", "if ", "\n"] {
            let text = part.repeat(200_000 / part.len());
            for notation in [Notation::Python, Notation::Matlab, Notation::C] {
                let _ = statements(&text, notation, None);
                let _ = statements(&text, notation, Some("a"));
            }
        }
        assert!(begun.elapsed().as_secs() < 20, "{:?}", begun.elapsed());
    }

    #[test]
    fn odd_texts_do_no_harm() {
        for text in [
            "=", "a=", "=a", "[=]", "((", "'", "\"\"\"", "é = ö", "a, = b", "return ", "[a] = f", "x ==", "...", "{",
            "/*",
        ] {
            for notation in [Notation::Python, Notation::Matlab, Notation::C] {
                let _ = statements(text, notation, None);
                let _ = statements(text, notation, Some("a"));
            }
        }
    }
}
