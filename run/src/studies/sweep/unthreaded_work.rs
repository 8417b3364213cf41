//! Work on blocks of a range in the calling thread, for programs without threads. Results are handed
//! over in order.

use std::ops::Range;
use std::sync::atomic::AtomicBool;

/// Number of points in a block of a sweep without threads.
const BLOCK: u64 = 64;

/// Calls `work` on blocks of the range `all` with the first worker, and hands the results to `take` in
/// order. An error of `take` ends the work. Without workers, nothing is computed.
///
/// # Errors
/// The error of `take`.
pub fn work_in_order<W: Send, T: Send, E>(
    all: Range<u64>,
    workers: Vec<W>,
    _stop: &AtomicBool,
    work: &(impl Fn(&mut W, Range<u64>) -> T + Sync),
    mut take: impl FnMut(T) -> Result<(), E>,
) -> Result<(), E> {
    let Some(mut worker) = workers.into_iter().next() else { return Ok(()) };
    let mut next = all.start;
    while next < all.end {
        let end = all.end.min(next + BLOCK);
        take(work(&mut worker, next..end))?;
        next = end;
    }
    Ok(())
}
