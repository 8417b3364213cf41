//! Working memory that is kept between calls, to avoid allocations.

use std::sync::Mutex;

/// Working memory that is kept between calls. A thread that calls while another thread uses the memory allocates its
/// own, so that equations can be shared and no call waits.
pub struct ScratchPool<T>(Mutex<T>);

impl<T: Default> ScratchPool<T> {
    /// Calls `work` with the kept memory, or with new memory if another thread uses it.
    pub fn with<R>(&self, work: impl FnOnce(&mut T) -> R) -> R {
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
