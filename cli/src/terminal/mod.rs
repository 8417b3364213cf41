//! Messages, failures and interruptions of a running command, as people see them.

pub(super) mod console;
pub(super) mod failure;
pub(super) mod interruption;
