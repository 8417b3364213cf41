//! Working memory that is kept between calls, so that a call need not allocate it.

use std::sync::Mutex;

/// Working memory that is kept between calls, and that threads share without waiting. If another
/// thread uses the memory at the moment, a call allocates memory of its own.
pub struct ScratchPool<T>(Mutex<T>);

impl<T: Default> ScratchPool<T> {
    /// Calls `work` with the kept memory, or with new memory if another thread is using the kept
    /// memory. The contents of the memory are those that the last call left.
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
