//! Interruption and progress of long commands: the user can end a command, and sees its progress.
//!
//! Invariant: a command that was interrupted ends soon, with [`status::INTERRUPTED`], and keeps its finished results. A
//! second interruption ends it at once. Commands that would lose no results do not listen for interruptions, and end at
//! the first.
//!
//! Signals belong to the process, not to a call. The state in this module and the shown progress are therefore global.
//! An interruption never changes numbers: the steps of an interrupted run equal those of the whole run.

use super::console::is_captured;
use super::failure::{print_to_stderr, status};
use indicatif::{ProgressBar, ProgressStyle};
use std::ops::ControlFlow;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use tripos::observer::{Observer, Progress};
use tripos_sim::Poll;

/// True after the user has asked the command to end.
static INTERRUPTION_ASKED: AtomicBool = AtomicBool::new(false);
/// Progress bar of the current run, updated at each step of the run.
static RUN_PROGRESS_BAR: OnceLock<SpanProgress> = OnceLock::new();

/// Number of parts of a span that a progress bar distinguishes.
const PARTS: u32 = 1000;

/// Starts to listen for interruptions by the keyboard and for requests of the system to end. If signals cannot be
/// caught, they end the process. Inside another program, signals are left to that program.
pub fn listen_for_interruption() {
    if is_captured() {
        return;
    }
    let on_interrupt = || {
        if INTERRUPTION_ASKED.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(status::INTERRUPTED));
        }
        print_to_stderr(
            "interrupted: finished results are kept, and running ones end soon; interrupt again to stop at once",
        );
    };
    // If signals cannot be caught, they end the process as usual.
    let _ = ctrlc::set_handler(on_interrupt);
}

/// Asks the running command to end soon.
pub fn ask_for_interruption() {
    INTERRUPTION_ASKED.store(true, Ordering::Relaxed);
}

/// Resets the interruption of an earlier command.
pub fn forget_interruption() {
    INTERRUPTION_ASKED.store(false, Ordering::Relaxed);
}

/// True if the user has asked the command to end.
pub fn is_interrupted() -> bool {
    INTERRUPTION_ASKED.load(Ordering::Relaxed)
}

/// Returns an observer for the runs of this command. It checks for interruptions and shows progress.
pub fn run_follower() -> Observer {
    Observer::new(Poll::new(poll_interruption), is_interrupted)
}

/// Progress bar of a run, with the span of time that the run covers.
struct SpanProgress {
    /// Progress bar of the run on the terminal.
    bar: ProgressBar,
    /// First and last time of the span, s.
    span: (f64, f64),
}

/// Shows a progress bar on the terminal for a run over the span (first, last), s. Inside another program, no bar is
/// shown.
pub fn show_progress_bar(span: (f64, f64)) {
    if is_captured() {
        return;
    }
    let bar = ProgressBar::new(u64::from(PARTS));
    let style = ProgressStyle::with_template("{bar:30} {percent} % of the span, {eta} left");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    RUN_PROGRESS_BAR.get_or_init(|| SpanProgress { bar, span });
}

/// Removes the progress bar of the run from the terminal.
pub fn hide_progress_bar() {
    if let Some(shown) = RUN_PROGRESS_BAR.get() {
        shown.bar.finish_and_clear();
    }
}

/// Updates the progress bar at time `t`, s. Returns `Break` if the user has interrupted the run.
fn poll_interruption(t: f64) -> ControlFlow<()> {
    if let Some(SpanProgress { bar, span: (from, to) }) = RUN_PROGRESS_BAR.get() {
        let part = (f64::from(PARTS) * (t - from) / (to - from)).clamp(0.0, f64::from(PARTS));
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to a thousand")]
        let part = part as u64;
        if part > bar.position() && !bar.is_finished() {
            bar.set_position(part);
        }
    }
    if is_interrupted() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// Progress of work in many parts, shown by a progress bar.
pub struct ProgressBarReporter<'a>(pub &'a ProgressBar);

impl Progress for ProgressBarReporter<'_> {
    fn set_length(&self, parts: u64) {
        self.0.set_length(parts);
    }
    fn add_finished_parts(&self, parts: u64) {
        self.0.inc(parts);
    }
    fn set_message(&self, what: &str) {
        self.0.set_message(what.to_owned());
    }
}

/// Returns a progress bar with a number of finished parts and a message.
pub fn counting_progress_bar() -> ProgressBar {
    let bar = ProgressBar::new(1);
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar
}
