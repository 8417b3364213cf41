//! Working memory that is kept between calls, so that a call need not allocate memory.

use std::sync::Mutex;

/// Working memory that is kept between calls, and that threads share without waiting. If another thread uses
/// the memory, a call allocates its own memory.
pub struct ScratchPool<T>(Mutex<T>);

impl<T: Default> ScratchPool<T> {
    /// Calls `work` with the kept memory, or with new memory if another thread uses the kept memory. Kept memory
    /// has the contents that the last call left.
    pub fn with_scratch<R>(&self, work: impl FnOnce(&mut T) -> R) -> R {
        match self.0.try_lock() {
            Ok(mut room) => work(&mut room),
            Err(_) => work(&mut T::default()),
        }
    }
}

impl<T: Default> Default for ScratchPool<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}
