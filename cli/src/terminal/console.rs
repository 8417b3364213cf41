//! Standard output and standard error of a command. For another program, both are texts in memory.

use std::cell::RefCell;
use std::io::Write;

/// Text that a command printed.
#[derive(Default)]
pub struct Printed {
    /// Text for standard output.
    pub output: String,
    /// Text for standard error.
    pub messages: String,
}

thread_local! {
    /// Text that the command of this thread has printed so far; `None` if it prints to the streams of the process.
    static PRINTED: RefCell<Option<Printed>> = const { RefCell::new(None) };
}

/// Runs a command on this thread, and returns its result with the text that it printed. Nothing is printed to the
/// streams of the process meanwhile.
pub fn captured<T>(command: impl FnOnce() -> T) -> (T, Printed) {
    /// Guard that ends the capture of this thread, also after a panic.
    struct Capture;
    impl Drop for Capture {
        fn drop(&mut self) {
            PRINTED.take();
        }
    }
    PRINTED.set(Some(Printed::default()));
    let _capture = Capture;
    let result = command();
    (result, PRINTED.take().unwrap_or_default())
}

/// True if the command of this thread runs inside another program, which gets its output as text.
pub fn is_captured() -> bool {
    PRINTED.with_borrow(Option::is_some)
}

/// Writes text to standard output and flushes it.
///
/// # Errors
/// The error of the system. Text that is kept in memory causes none.
pub fn write_output(text: &str) -> std::io::Result<()> {
    let is_kept = PRINTED.with_borrow_mut(|printed| printed.as_mut().map(|printed| printed.output.push_str(text)));
    if is_kept.is_some() {
        return Ok(());
    }
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush())
}

/// Writes a line to standard error. A failure to write it is ignored.
pub fn write_message(line: &str) {
    let is_kept = PRINTED.with_borrow_mut(|printed| {
        printed.as_mut().map(|printed| {
            printed.messages.push_str(line);
            printed.messages.push('\n');
        })
    });
    if is_kept.is_none() {
        let _ = writeln!(std::io::stderr().lock(), "{line}");
    }
}
