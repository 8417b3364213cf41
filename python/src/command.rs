//! Commands of the program `tripos`, run inside Python.

use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use std::ffi::OsString;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;
use tripos_cli::{CommandOutput, interrupt_command, run_command};

/// Time between two checks for signals of Python.
const BETWEEN_SIGNALS: Duration = Duration::from_millis(50);

/// Runs a command with these words. Returns its exit status and the texts that the program prints to standard output
/// and to standard error. Ctrl-C ends the command, which keeps its finished results, and raises `KeyboardInterrupt`.
#[pyfunction]
pub fn command(py: Python<'_>, words: Vec<OsString>) -> PyResult<(u8, String, String)> {
    let (sender, receiver) = channel();
    // A mutex shares the receiver with the closure that waits without the lock of the interpreter.
    let receiver = Mutex::new(receiver);
    // The command runs on its own thread, with a stack as large as that of a main thread. This thread checks for
    // signals.
    let work = std::thread::Builder::new().stack_size(8 << 20).spawn(move || {
        // The receiver exists until the thread has ended, so that sending cannot fail.
        let _ = sender.send(run_command(words));
    })?;
    let mut interruption = None;
    let result: Option<CommandOutput> = loop {
        match py.detach(|| receiver.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(BETWEEN_SIGNALS)) {
            Ok(output) => break Some(output),
            Err(RecvTimeoutError::Disconnected) => break None,
            Err(RecvTimeoutError::Timeout) => {
                if let Err(signal) = py.check_signals() {
                    interrupt_command();
                    interruption = Some(signal);
                }
            }
        }
    };
    let ended = py.detach(|| work.join());
    if let Some(signal) = interruption {
        let kept = result.map(|output| output.messages).unwrap_or_default();
        let is_interrupt = signal.is_instance_of::<PyKeyboardInterrupt>(py);
        return Err(if is_interrupt { PyKeyboardInterrupt::new_err(kept) } else { signal });
    }
    match (result, ended) {
        (Some(output), Ok(())) => Ok((output.status, output.output, output.messages)),
        (_, Err(panic)) => std::panic::resume_unwind(panic),
        (None, Ok(())) => unreachable!("the command sends its output before its thread ends"),
    }
}
