//! Counts the requests for memory of a thread.
#![expect(
    unsafe_code,
    reason = "an allocator is unsafe to write; this one counts, and leaves all else to that of the system"
)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

thread_local! {
    static ASKED: Cell<u64> = const { Cell::new(0) };
}

struct Counting;

// SAFETY: every call goes to the system's allocator as it came.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        note();
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        unsafe { System.dealloc(at, layout) }
    }
    unsafe fn realloc(&self, at: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        note();
        unsafe { System.realloc(at, layout, size) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

/// A thread that ends may free and ask after its counter is gone.
fn note() {
    let _ = ASKED.try_with(|asked| asked.set(asked.get() + 1));
}

/// Number of requests for memory that this thread makes in a call, and the value of the call.
pub(crate) fn allocations<T>(call: impl FnOnce() -> T) -> (u64, T) {
    let before = ASKED.get();
    let value = call();
    (ASKED.get() - before, value)
}
