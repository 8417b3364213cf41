//! Work whose results are taken in order, on the thread that asks for it: where there are no others.

use std::ops::Range;
use std::sync::atomic::AtomicBool;

/// Points of a block.
const BLOCK: u64 = 64;

/// Does `work` on blocks of a range by the first of the workers and hands the results to `take` in order, until that
/// fails.
///
/// # Errors
/// That of `take`.
pub fn in_order<W: Send, T: Send, E>(
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
