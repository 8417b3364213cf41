//! Text broken into lines of a given width, for the comments and the code of any target.

/// Breaks a text at spaces into lines of at most `width` bytes. A word that is longer gets a line of its own. An
/// empty text gives one empty line.
#[must_use]
pub fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let last = lines.last_mut().expect("at least one line");
        if !last.is_empty() && last.len() + 1 + word.len() > width {
            lines.push(word.to_owned());
        } else {
            if !last.is_empty() {
                last.push(' ');
            }
            last.push_str(word);
        }
    }
    lines
}
