//! Pieces of HTML from which the page is made.

use tripos_derive::plain_text::with_significant_digits;

/// Escapes a text for HTML: for the content of an element, or for an attribute in double quotes.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// Returns a relative path as a URL: characters with another meaning in a URL are percent-encoded.
pub fn address(path: &str) -> String {
    let plain = |byte: &u8| byte.is_ascii_alphanumeric() || b"/-_.".contains(byte);
    path.bytes().map(|b| if plain(&b) { char::from(b).to_string() } else { format!("%{b:02X}") }).collect()
}

/// Returns the HTML of a box that scrolls separately from the page and can be reached by keyboard. `content` is HTML,
/// and `label` describes the box.
pub fn scrolling_box(label: &str, content: &str) -> String {
    format!("<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"{}\">\n{content}</div>\n", escape(label))
}

/// Returns the HTML of content that unfolds on demand. `summary` and `content` are HTML.
pub fn folded_html(summary: &str, content: &str) -> String {
    format!("<details>\n<summary>{summary}</summary>\n{content}</details>\n")
}

/// Returns the HTML of a titled part of a section that unfolds on demand. `title` and `content` are
/// HTML.
pub fn foldable_part(id: &str, title: &str, content: &str) -> String {
    format!("<details id=\"{id}\">\n<summary><h4>{title}</h4></summary>\n{content}</details>\n")
}

/// Returns the HTML of a link to the element with the id `place` on the page. `text` is HTML.
pub fn link(place: &str, text: &str) -> String {
    format!("<a href=\"#{place}\">{text}</a>")
}

/// Lists names in the form of a sentence: `a, b and c`.
pub fn list_names<T: AsRef<str>>(names: &[T]) -> String {
    let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    match names.split_last() {
        Some((last, [])) => (*last).to_owned(),
        Some((last, others)) => format!("{} and {last}", others.join(", ")),
        None => String::new(),
    }
}

/// Returns a text as HTML. In numbers such as 1e-9 the hyphen is replaced with a minus sign, at which no line is
/// broken.
pub fn words_html(text: &str) -> String {
    let mut pieces = text.split("e-");
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let number = out.ends_with(|c: char| c.is_ascii_digit()) && piece.starts_with(|c: char| c.is_ascii_digit());
        out += if number { "e−" } else { "e-" };
        out += piece;
    }
    escape(&out)
}

/// Joins the HTML pieces that the function `shape` makes from the items.
pub fn join_html<T>(items: &[T], shape: impl Fn(&T) -> String) -> String {
    items.iter().fold(String::new(), |out, item| out + &shape(item))
}

/// Returns the HTML of a table's head. `cells` are HTML.
pub fn table_head(cells: &[&str]) -> String {
    format!("<thead><tr>{}</tr></thead>\n", join_html(cells, |cell| format!("<th scope=\"col\">{cell}</th>")))
}

/// Returns the HTML of a table with a caption and a head. `rows` and `columns` are HTML.
pub fn table(caption: &str, columns: &[&str], rows: &[Vec<String>]) -> String {
    let row = |cells: &Vec<String>| format!("<tr>{}</tr>\n", join_html(cells, |cell| format!("<td>{cell}</td>")));
    let (head, rows) = (table_head(columns), join_html(rows, row));
    scrolling_box(caption, &format!("<table>\n<caption>{caption}</caption>\n{head}<tbody>\n{rows}</tbody>\n</table>\n"))
}

/// Returns the HTML of a number in mathematical notation: `1.2e-9` becomes 1.2 × 10⁻⁹.
pub fn number(text: &str) -> String {
    let text = text.replace('-', "−");
    match text.split_once('e') {
        Some((digits, "0")) => digits.to_owned(),
        Some((digits, power)) => format!("{digits} × 10<sup>{power}</sup>"),
        None => text,
    }
}

/// Returns the HTML of an entry id. Lines may be broken after its hyphens.
pub fn breakable_id(id: &str) -> String {
    escape(id).replace('-', "-<wbr>")
}

/// Returns a number as text with `digits` significant digits, without trailing zeros.
pub fn rounded_number_html(x: f64, digits: usize) -> String {
    let text = with_significant_digits(x, digits);
    match text.split_once('e') {
        Some((digits, power)) if digits.contains('.') => {
            format!("{}e{power}", digits.trim_end_matches('0').trim_end_matches('.'))
        }
        _ => text,
    }
}
