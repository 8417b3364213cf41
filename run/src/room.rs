//! Room that is kept between calls.

use std::sync::Mutex;

/// Working space that is kept between calls. A thread that comes while another has it allocates its own, so that
/// equations can be shared and no call waits.
pub struct Room<T>(Mutex<T>);

impl<T: Default> Room<T> {
    /// Works in the room.
    pub fn with<R>(&self, work: impl FnOnce(&mut T) -> R) -> R {
        match self.0.try_lock() {
            Ok(mut room) => work(&mut room),
            Err(_) => work(&mut T::default()),
        }
    }
}

impl<T: Default> Default for Room<T> {
    fn default() -> Self {
        Self(Mutex::default())
    }
}
