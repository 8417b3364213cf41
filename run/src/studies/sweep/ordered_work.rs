//! Work on many threads, whose results are handed over in order.
//!
//! Invariant: the results of blocks are handed over one by one, in the order of the blocks. A block does
//! not begin if it is more than a fixed number ahead of the next block to hand over. So the number of
//! waiting results is bounded. The division into blocks depends on the clock, but no result depends on
//! this division.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Greatest number of points in a block of a sweep.
const LONGEST: u64 = 1024;
/// Number of points in a block of a sweep until the first results arrive. Before that, the duration of a
/// point is unknown.
const FIRST: u64 = 1;
/// Intended duration of a block of points, at most. It is short, so that rows of the table appear soon,
/// and an interrupted sweep loses few rows.
const LASTING: Duration = Duration::from_secs(1);
/// Largest number of blocks per thread that are computed or wait to be handed over.
const AHEAD: usize = 4;

/// Calls `work` on blocks of the range `all`, with one worker per thread. Hands the results to `take` in
/// the order of the blocks. An error of `take` ends all work: it sets `stop`, which `work` should watch.
///
/// # Errors
/// The error of `take`.
///
/// # Panics
/// If `work` panics.
pub fn work_in_order<W: Send, T: Send, E>(
    all: Range<u64>,
    workers: Vec<W>,
    stop: &AtomicBool,
    work: &(impl Fn(&mut W, Range<u64>) -> T + Sync),
    mut take: impl FnMut(T) -> Result<(), E>,
) -> Result<(), E> {
    let threads = workers.len();
    let mut cutter = BlockCutter { rest: all, threads: threads as u64, begun: Instant::now(), done: 0 };
    let (give, tickets) = channel::<(usize, Range<u64>)>();
    let tickets = Mutex::new(tickets);
    let (send, results) = channel();
    std::thread::scope(|scope| {
        for mut worker in workers {
            let (tickets, send) = (&tickets, send.clone());
            scope.spawn(move || {
                loop {
                    // The lock is held during the wait. Other workers that wait for the lock have no block to compute
                    // either.
                    let ticket = tickets.lock().unwrap_or_else(PoisonError::into_inner).recv();
                    let Ok((number, block)) = ticket else { return };
                    let points = block.end - block.start;
                    let lost = PanicGuard(&send);
                    let result = work(&mut worker, block);
                    if lost.0.send(Some((number, points, result))).is_err() {
                        return;
                    }
                }
            });
        }
        drop(send);
        let (mut given, mut next, mut waiting) = (0, 0, BTreeMap::new());
        let outcome = loop {
            while given - next < AHEAD * threads
                && let Some(block) = cutter.cut_block()
            {
                // Workers listen until the sender `give` is dropped.
                let _ = give.send((given, block));
                given += 1;
            }
            if next == given {
                break Ok(());
            }
            // A missing result means that a worker has panicked; the scope then panics too.
            let Ok(Some((number, points, result))) = results.recv() else {
                stop.store(true, Ordering::Relaxed);
                break Ok(());
            };
            cutter.done += points;
            waiting.insert(number, result);
            let mut taken = Ok(());
            while taken.is_ok()
                && let Some(result) = waiting.remove(&next)
            {
                next += 1;
                taken = take(result);
            }
            if let Err(error) = taken {
                stop.store(true, Ordering::Relaxed);
                break Err(error);
            }
        };
        // No more blocks are given, so the workers end.
        drop(give);
        outcome
    })
}

/// Guard of a worker that reports its panic to the receiver. Without it, the other threads would wait
/// forever.
struct PanicGuard<'s, T>(&'s Sender<Option<T>>);

impl<T> Drop for PanicGuard<'_, T> {
    fn drop(&mut self) {
        if std::thread::panicking() {
            let _ = self.0.send(None);
        }
    }
}

/// Cutter of a range of points into blocks of a suitable duration.
struct BlockCutter {
    /// Points that are not yet in a block.
    rest: Range<u64>,
    /// Number of worker threads.
    threads: u64,
    /// Instant at which the whole computation began.
    begun: Instant,
    /// Number of points whose results have arrived.
    done: u64,
}

impl BlockCutter {
    /// Cuts off the next block; `None` if no points are left. Blocks become shorter towards the end, so
    /// that no thread works alone for long.
    fn cut_block(&mut self) -> Option<Range<u64>> {
        let left = self.rest.end - self.rest.start;
        if left == 0 {
            return None;
        }
        let lasting = if self.done == 0 {
            FIRST
        } else {
            let each = self.begun.elapsed().as_secs_f64() * self.threads as f64 / self.done as f64;
            let points = (LASTING.as_secs_f64() / each).min(LONGEST as f64);
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and the longest")]
            let points = points as u64;
            points
        };
        let fair = left.div_ceil(AHEAD as u64 * self.threads);
        let start = self.rest.start;
        self.rest.start += fair.min(lasting).clamp(1, LONGEST);
        Some(start..self.rest.start)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(threads: usize, count: u64, work: impl Fn(u64) + Sync) -> Vec<u64> {
        let mut list = Vec::new();
        let work = |(): &mut (), block: Range<u64>| block.inspect(|at| work(*at)).collect::<Vec<u64>>();
        let take = |mut block: Vec<u64>| {
            list.append(&mut block);
            Ok::<(), ()>(())
        };
        work_in_order(5..5 + count, vec![(); threads], &AtomicBool::new(false), &work, take).unwrap();
        list
    }

    #[test]
    fn every_result_is_taken_once_and_in_order() {
        for threads in [1, 2, 7] {
            for count in [0, 1, 2, 1000, 100_000] {
                assert_eq!(run(threads, count, |_| ()), (5..5 + count).collect::<Vec<u64>>(), "{threads}, {count}");
            }
        }
        // Some points take long: those after them wait, and are not lost.
        let uneven = |at: u64| {
            if at.is_multiple_of(97) {
                std::thread::sleep(Duration::from_millis(3));
            }
        };
        assert_eq!(run(4, 2000, uneven), (5..2005).collect::<Vec<u64>>());
    }

    /// Goal: the number of waiting results is bounded. Method: count the points that run while the first
    /// point still runs.
    #[test]
    fn no_thread_runs_far_ahead() {
        let (threads, first_done, furthest) = (4, AtomicBool::new(false), Mutex::new(0));
        run(threads, 1_000_000, |at| {
            if at == 5 {
                std::thread::sleep(Duration::from_millis(200));
                first_done.store(true, Ordering::SeqCst);
            } else if !first_done.load(Ordering::SeqCst) {
                let mut furthest = furthest.lock().unwrap();
                *furthest = at.max(*furthest);
            }
        });
        let bound = 5 + AHEAD as u64 * threads as u64 * LONGEST;
        assert!(*furthest.lock().unwrap() < bound);
    }

    #[test]
    fn an_error_of_the_taker_ends_it_all() {
        let stop = AtomicBool::new(false);
        let work = |(): &mut (), block: Range<u64>| block.end;
        let take = |end: u64| if end > 50 { Err(end) } else { Ok(()) };
        let error = work_in_order(0..MANY, vec![(); 3], &stop, &work, take).unwrap_err();
        assert!(error > 50 && error < MANY && stop.load(Ordering::Relaxed));
    }

    const MANY: u64 = 1 << 60;

    #[test]
    #[should_panic(expected = "a scoped thread panicked")]
    fn a_panic_is_passed_on_and_hangs_nothing() {
        run(3, 1000, |at| assert!(at != 500, "on purpose"));
    }
}
