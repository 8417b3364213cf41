//! Messages, failures and interruptions of a running command, as the user sees them.

pub(super) mod console;
pub(super) mod failure;
pub(super) mod interruption;
