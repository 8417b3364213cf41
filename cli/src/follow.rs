//! Who follows long commands: the person who may end them, and who wants to see how far they are.
//!
//! Invariant: a command that was interrupted ends soon, with [`status::INTERRUPTED`], and keeps what it had finished. A
//! second interruption ends it at once. Commands that would lose nothing do not listen, and end at the first.
//!
//! Signals are of the process, not of a call, and so are the state here and the progress of the one run that is
//! shown. Absent on purpose: any influence on numbers. A run that was interrupted has the steps that it would have had.

use crate::failure::{say, status};
use indicatif::{ProgressBar, ProgressStyle};
use std::ops::ControlFlow;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use tripos::follow::{Follow, Progress};
use tripos_sim::Poll;

/// True once the command was asked to end.
static ASKED: AtomicBool = AtomicBool::new(false);
/// Progress bar of the one run that is shown, kept up to date by the poll.
static SHOWN: OnceLock<Shown> = OnceLock::new();

/// Parts of a span that a bar tells apart.
const PARTS: u32 = 1000;

/// Listens for interruptions: of the keyboard, and polite requests to end. Where that cannot be had, they end the
/// process.
pub fn listen() {
    let asked = || {
        if ASKED.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(status::INTERRUPTED));
        }
        say("interrupted: ending what is under way, and keeping what is finished; once more to leave at once");
    };
    // Where signals cannot be had, they end the process.
    let _ = ctrlc::set_handler(asked);
}

/// True if the command was asked to end.
pub fn asked() -> bool {
    ASKED.load(Ordering::Relaxed)
}

/// For whatever runs in this command.
pub fn follow() -> Follow {
    Follow::new(Poll::new(look), asked)
}

/// Progress bar of a run, and the span that it covers.
struct Shown {
    bar: ProgressBar,
    span: (f64, f64),
}

/// Shows on a terminal how far runs over this span have come.
pub fn show(span: (f64, f64)) {
    let bar = ProgressBar::new(u64::from(PARTS));
    let style = ProgressStyle::with_template("{bar:30} {percent} % of the span, {eta} left");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    SHOWN.get_or_init(|| Shown { bar, span });
}

/// Takes the progress away.
pub fn hide() {
    if let Some(shown) = SHOWN.get() {
        shown.bar.finish_and_clear();
    }
}

fn look(t: f64) -> ControlFlow<()> {
    if let Some(Shown { bar, span: (from, to) }) = SHOWN.get() {
        let part = (f64::from(PARTS) * (t - from) / (to - from)).clamp(0.0, f64::from(PARTS));
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to a thousand")]
        let part = part as u64;
        if part > bar.position() && !bar.is_finished() {
            bar.set_position(part);
        }
    }
    if asked() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// A bar as the progress of work of many parts.
pub struct Shows<'a>(pub &'a ProgressBar);

impl Progress for Shows<'_> {
    fn set_length(&self, parts: u64) {
        self.0.set_length(parts);
    }
    fn inc(&self, parts: u64) {
        self.0.inc(parts);
    }
    fn set_message(&self, what: &str) {
        self.0.set_message(what.to_owned());
    }
}
