//! Strict reading of HTML pages: every element is closed, every attribute has a quoted value, and no element or
//! attribute has the name of the mark.

/// Elements that have no end.
const VOID: [&str; 8] = ["meta", "link", "br", "hr", "img", "input", "col", "wbr"];

/// Name of elements, attributes and functions that hostile texts try to make.
pub const MARK: &str = "zz";

/// Reason why a page is no well-formed HTML; `None` if it is.
pub fn fault(page: &str) -> Option<String> {
    let mut open: Vec<&str> = Vec::new();
    let mut rest = page;
    let around = |rest: &str| rest.chars().take(80).collect::<String>();
    while let Some(at) = rest.find('<') {
        rest = &rest[at..];
        if let Some(comment) = rest.strip_prefix("<!--") {
            let Some(end) = comment.find("-->") else { return Some(format!("a comment has no end: {}", around(rest))) };
            rest = &comment[end + 3..];
            continue;
        }
        if rest.starts_with("<!") {
            let Some(end) = rest.find('>') else { return Some("a declaration has no end".to_owned()) };
            rest = &rest[end + 1..];
            continue;
        }
        if let Some(name) = rest.strip_prefix("</") {
            let Some((name, after)) = name.split_once('>') else { return Some("a tag has no end".to_owned()) };
            if open.pop() != Some(name.trim()) {
                return Some(format!("`</{name}>` closes nothing, in {open:?}"));
            }
            rest = after;
            continue;
        }
        let tag = &rest[1..];
        let length = tag.find(|c: char| !c.is_ascii_alphanumeric() && c != '-').unwrap_or(tag.len());
        let name = &tag[..length];
        if name.is_empty() || name.eq_ignore_ascii_case(MARK) {
            return Some(format!("a wrong element: {}", around(rest)));
        }
        let (closed, after) = match attributes(&tag[length..]) {
            Ok(found) => found,
            Err(why) => return Some(format!("{why}: {}", around(rest))),
        };
        rest = after;
        if closed || VOID.contains(&name) {
            continue;
        }
        if ["script", "style"].contains(&name) {
            let end = format!("</{name}>");
            let Some(at) = rest.find(&end) else { return Some(format!("`{name}` has no end")) };
            rest = &rest[at + end.len()..];
            continue;
        }
        open.push(name);
    }
    if open.is_empty() { None } else { Some(format!("never closed: {open:?}")) }
}

/// Reads the attributes of a tag up to its end. Returns if the tag closes itself, and the text after the tag.
fn attributes(mut rest: &str) -> Result<(bool, &str), &'static str> {
    loop {
        rest = rest.trim_start();
        if let Some(after) = rest.strip_prefix("/>") {
            return Ok((true, after));
        }
        if let Some(after) = rest.strip_prefix('>') {
            return Ok((false, after));
        }
        let length =
            rest.find(|c: char| !c.is_ascii_alphanumeric() && !"-_:.".contains(c)).ok_or("a tag has no end")?;
        let (name, after) = rest.split_at(length);
        if name.is_empty() || name.eq_ignore_ascii_case(MARK) {
            return Err("a wrong attribute");
        }
        rest = after;
        if let Some(value) = rest.strip_prefix('=') {
            let quote =
                value.chars().next().filter(|c| ['"', '\''].contains(c)).ok_or("an attribute without quotes")?;
            let end = value[1..].find(quote).ok_or("an attribute without end")?;
            if value[1..=end].contains('<') {
                return Err("an attribute with `<`");
            }
            rest = &value[end + 2..];
        }
    }
}

#[test]
fn faults_are_found() {
    assert_eq!(fault("<!DOCTYPE html><p class=\"a\">x &lt; y<br><svg/></p><script>a < b</script>"), None);
    for wrong in ["<p>", "</p>", "<p><zz></zz></p>", "<p zz=\"\"></p>", "<p a=b></p>", "a < b", "<p a=\"<\"></p>"] {
        assert!(fault(wrong).is_some(), "{wrong}");
    }
}
