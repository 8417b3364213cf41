//! Range of values of a number, read from an option `NAME=FROM:TO:COUNT`.

use tripos::{Error, Mechanism};
use tripos_derive::diagnostic::nearest_name_advice;
use tripos_derive::scene::StateWithUnknowns;

/// Range of values of a number, along which a steady motion is followed.
pub struct Range {
    /// Name of the number: a parameter, a state with a given value, or a number of the state file.
    pub name: String,
    /// Values of the number, in order and at equal distances, in its unit.
    pub values: Vec<f64>,
}

impl Range {
    /// Reads a range from the text `NAME=FROM:TO:COUNT` of an option, such as `v=0:10:11`.
    ///
    /// # Errors
    /// [`Error::Request`] if the text has another form, the count is not 2 to 100000, or there is
    /// no such number.
    pub fn new(model: &Mechanism, asked: &StateWithUnknowns, over: &str) -> Result<Self, Error> {
        let how = "write NAME=FROM:TO:COUNT, such as v=0:10:11";
        let wrong = || Error::request(format!("`{over}` are no values to follow"), how);
        let (name, range) = over.split_once('=').ok_or_else(wrong)?;
        let parts: Vec<&str> = range.split(':').collect();
        let [from, to, count] = parts.as_slice() else { return Err(wrong()) };
        let number = |text: &str| text.trim().parse::<f64>().ok().filter(|x| x.is_finite()).ok_or_else(wrong);
        let (from, to) = (number(from)?, number(to)?);
        let count: u32 = count.trim().parse().map_err(|_| wrong())?;
        if !(2..=100_000).contains(&count) {
            return Err(Error::request(format!("{count} values are none to follow"), "give from 2 to 100000 values"));
        }
        let name = name.trim();
        let held = |at: usize| !asked.sought.contains(&at);
        let states = model.coordinates.iter().map(|c| &c.name).chain(model.speeds.iter().map(|s| &s.name)).enumerate();
        let states = states.filter(|(at, _)| held(*at)).map(|(_, name)| name.as_str());
        let known =
            model.parameters.iter().map(|p| p.name.as_str()).chain(asked.names.iter().map(|own| own.name.as_str()));
        let known: Vec<&str> = known.chain(states).collect();
        if !known.contains(&name) {
            return Err(Error::request(
                format!("there is no `{name}` to follow along"),
                nearest_name_advice(name, known),
            ));
        }
        let value = |at: u32| from + (to - from) * f64::from(at) / f64::from(count - 1);
        Ok(Self { name: name.to_owned(), values: (0..count).map(value).collect() })
    }
}
