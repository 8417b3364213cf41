//! Standing (trustworthiness) of a run on the page: words, remarks and colours for right, loose, stopped, wrong and
//! undecided runs.
//!
//! Wrong and loose runs have different words and colours everywhere. A run is wrong if its equations are wrong, however
//! it ends. A loose run has right equations.

use crate::page::content::{RunRow, Standing};
use crate::page::markup::html::escape;
use tripos_derive::plain_text::with_significant_digits;

impl Standing {
    /// Returns a short word for the standing; `None` for a good run with right equations.
    pub fn standing_word(&self) -> Option<&'static str> {
        match self {
            Self::Right => None,
            Self::Loose { .. } => Some("loose"),
            Self::Stopped => Some("stopped"),
            Self::Wrong => Some("wrong"),
            Self::Undecided(_) => Some("undecided"),
        }
    }

    /// Returns the remark below the row of a run; `None` if no remark is needed. `t_end` is the time at the end of the
    /// run, s.
    pub fn standing_remark(&self, t_end: f64) -> Option<String> {
        match self {
            // Wrong equations are mentioned once, above the printed equations.
            Self::Right | Self::Stopped | Self::Wrong => None,
            Self::Loose { how, error: Ok(error) } => Some(format!(
                "right equations, loosely integrated: {how} leaves an error of {} at t = {t_end} s, the largest \
                 |e| / (1 + |value|) of what is shown, by comparison with a second run",
                with_significant_digits(*error, 2)
            )),
            Self::Loose { how, error: Err(why) } => Some(format!(
                "right equations, loosely integrated by {how}; the error at t = {t_end} s is not known: {why}"
            )),
            Self::Undecided(why) => {
                Some(format!("whether these equations give the derived accelerations is not known: {why}"))
            }
        }
    }
}

/// Returns the HTML attribute with the classes of a run's table row. `more` is an additional class; it may be empty.
pub fn standing_row_class(run: &RunRow, more: &str) -> String {
    let printed = run.printed.as_ref().map(|_| "printed");
    let standing = run.standing.standing_word();
    let list: Vec<&str> = [more].into_iter().filter(|more| !more.is_empty()).chain(printed).chain(standing).collect();
    if list.is_empty() { String::new() } else { format!(" class=\"{}\"", list.join(" ")) }
}

/// Returns the HTML name of a run, with the word for its standing.
pub fn run_name_with_standing(run: &RunRow) -> String {
    let name = match &run.printed {
        Some(id) => format!("<code>printed:{}</code>", escape(id)),
        None => escape(&run.title),
    };
    match run.standing.standing_word() {
        Some(word) => format!("{name} <strong class=\"standing\">{word}</strong>"),
        None => name,
    }
}
