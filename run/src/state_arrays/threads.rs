//! Arrays of states shared among the cores of the processor.

/// Smallest number of states for which a further thread is started.
const STATES_PER_THREAD: usize = 1024;

/// Calls `write` for shares of the states, each on a thread of its own. It gets the number of the first
/// state of its share, and room for `width` values at each of its states.
pub fn share_among_cores(count: usize, width: usize, out: &mut [f64], write: &(dyn Fn(usize, &mut [f64]) + Sync)) {
    let threads = match count / STATES_PER_THREAD {
        // The number of cores is asked of the system, which takes longer than a few states.
        0 | 1 => 1,
        most => std::thread::available_parallelism().map_or(1, usize::from).min(most),
    };
    if threads == 1 {
        return write(0, out);
    }
    // Shares are whole blocks of lanes, so that only the last block is filled up.
    let share = count.div_ceil(threads).next_multiple_of(8);
    std::thread::scope(|scope| {
        for (thread, out) in out.chunks_mut(share * width).enumerate() {
            scope.spawn(move || write(thread * share, out));
        }
    });
}
