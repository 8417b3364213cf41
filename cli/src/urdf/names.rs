//! Names of links and joints, each used once.

use std::collections::BTreeSet;

/// Names in use.
#[derive(Default)]
pub struct Names {
    /// Names so far.
    used: BTreeSet<String>,
}

impl Names {
    /// Returns the wanted name, with a number if it is in use.
    pub fn reserve(&mut self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        let mut number = 2;
        while !self.used.insert(name.clone()) {
            name = format!("{wanted}_{number}");
            number += 1;
        }
        name
    }
}
