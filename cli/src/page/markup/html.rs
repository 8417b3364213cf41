//! Pieces of HTML that the page is made of.

use tripos_derive::plain::significant;

/// Escapes text for the content of an element, or for an attribute in double quotes.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Relative path as a URL: characters that could end it or have another meaning in it are encoded.
pub fn address(path: &str) -> String {
    let plain = |byte: &u8| byte.is_ascii_alphanumeric() || b"/-_.".contains(byte);
    path.bytes().map(|b| if plain(&b) { char::from(b).to_string() } else { format!("%{b:02X}") }).collect()
}

/// Id of the section of a scene in the page; scenes are counted from 0.
pub fn anchor(scene: usize) -> String {
    format!("scene-{}", scene + 1)
}

/// HTML of a box that scrolls by itself, reachable by keyboard.
pub fn scroll(label: &str, content: &str) -> String {
    format!("<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"{}\">\n{content}</div>\n", escape(label))
}

/// HTML of content that opens on demand; `summary` is HTML.
pub fn folded(summary: &str, content: &str) -> String {
    format!("<details>\n<summary>{summary}</summary>\n{content}</details>\n")
}

/// HTML of a part of a section that opens on demand, with an id; `title` is HTML.
pub fn part(id: &str, title: &str, content: &str) -> String {
    format!("<details id=\"{id}\">\n<summary><h4>{title}</h4></summary>\n{content}</details>\n")
}

/// HTML of a link to the place with this id in the page; `text` is HTML.
pub fn link(place: &str, text: &str) -> String {
    format!("<a href=\"#{place}\">{text}</a>")
}

/// Lists names as a sentence does: `a, b and c`.
pub fn listed<T: AsRef<str>>(names: &[T]) -> String {
    let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    match names.split_last() {
        Some((last, [])) => (*last).to_owned(),
        Some((last, others)) => format!("{} and {last}", others.join(", ")),
        None => String::new(),
    }
}

/// Number with its noun, in the singular or the plural.
pub fn count(n: usize, one: &str) -> String {
    format!("{n} {one}{}", if n == 1 { "" } else { "s" })
}

/// HTML of words: numbers such as 1e-9 get a minus sign that does not end a line.
pub fn words(text: &str) -> String {
    let mut pieces = text.split("e-");
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let number = out.ends_with(|c: char| c.is_ascii_digit()) && piece.starts_with(|c: char| c.is_ascii_digit());
        out += if number { "e−" } else { "e-" };
        out += piece;
    }
    escape(&out)
}

/// Joins the HTML that `shape` makes of each item.
pub fn each<T>(items: &[T], shape: impl Fn(&T) -> String) -> String {
    items.iter().fold(String::new(), |out, item| out + &shape(item))
}

/// HTML of the head of a table; cells are HTML.
pub fn head(cells: &[&str]) -> String {
    format!("<thead><tr>{}</tr></thead>\n", each(cells, |cell| format!("<th scope=\"col\">{cell}</th>")))
}

/// HTML of a table with a caption and a head; cells are HTML.
pub fn table(caption: &str, columns: &[&str], rows: &[Vec<String>]) -> String {
    let row = |cells: &Vec<String>| format!("<tr>{}</tr>\n", each(cells, |cell| format!("<td>{cell}</td>")));
    let (head, rows) = (head(columns), each(rows, row));
    scroll(caption, &format!("<table>\n<caption>{caption}</caption>\n{head}<tbody>\n{rows}</tbody>\n</table>\n"))
}

/// HTML of a number in mathematical notation: `1.2e-9` as 1.2 × 10⁻⁹.
pub fn number(text: &str) -> String {
    let text = text.replace('-', "−");
    match text.split_once('e') {
        Some((digits, "0")) => digits.to_owned(),
        Some((digits, power)) => format!("{digits} × 10<sup>{power}</sup>"),
        None => text,
    }
}

/// HTML of an id that may break over lines behind its hyphens.
pub fn breakable(id: &str) -> String {
    escape(id).replace('-', "-<wbr>")
}

/// Number for people with this many significant digits, without zeros at the end.
pub fn rounded(x: f64, digits: usize) -> String {
    let text = significant(x, digits);
    match text.split_once('e') {
        Some((digits, power)) if digits.contains('.') => {
            format!("{}e{power}", digits.trim_end_matches('0').trim_end_matches('.'))
        }
        _ => text,
    }
}
