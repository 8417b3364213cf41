//! Division of arrays of states among the cores of the processor.

/// Number of states for each thread, at least, if more than one thread is used.
const STATES_PER_THREAD: usize = 1024;

/// Divides the states into shares, and calls `write` for each share on a thread of its own. `write` gets the index
/// of the first state of its share, and a slice with `width` values for each of its states.
pub fn share_among_cores(count: usize, width: usize, out: &mut [f64], write: &(dyn Fn(usize, &mut [f64]) + Sync)) {
    let threads = match count / STATES_PER_THREAD {
        // The system must be asked for the number of cores. This takes longer than the computation of few states.
        0 | 1 => 1,
        most => std::thread::available_parallelism().map_or(1, usize::from).min(most),
    };
    if threads == 1 {
        return write(0, out);
    }
    // A share consists of whole blocks of lanes, so that only the last block has empty lanes.
    let share = count.div_ceil(threads).next_multiple_of(8);
    std::thread::scope(|scope| {
        for (thread, out) in out.chunks_mut(share * width).enumerate() {
            scope.spawn(move || write(thread * share, out));
        }
    });
}
