//! Messages for unknown names where a coordinate or a speed is expected.

use crate::diagnostic::nearest_name_advice;
use crate::model::Model;

/// Largest number of speeds that a message lists.
const MOST_LISTED: usize = 12;

impl Model {
    /// Message and advice for a name that is neither a coordinate nor a generalized speed. `known` are the names that
    /// are allowed at its place.
    #[must_use]
    pub fn unknown_state_name<'n>(&self, name: &str, known: impl Iterator<Item = &'n str>) -> (String, String) {
        if !self.dependent_speeds.iter().any(|speed| speed.name == name) {
            let message = format!("the model has no coordinate or speed `{name}`");
            // Speeds of rotations about several axes are numbered by axis, and do not contain the name of a
            // coordinate.
            let of = self.coordinates.iter().find(|coordinate| format!("u_{}", coordinate.name) == name);
            let help = match of {
                Some(coordinate) => format!(
                    "the rate of `{0}` is `{0}'`, and the speeds are {1}",
                    coordinate.name,
                    self.speed_names_in_words()
                ),
                None => nearest_name_advice(name, known),
            };
            return (message, help);
        }
        let speeds: Vec<String> = self.speeds.iter().map(|speed| format!("`{}`", speed.name)).collect();
        let (count, follows) = match speeds.as_slice() {
            [] => ("no speed".to_owned(), "it is determined".to_owned()),
            [one] => ("1 speed".to_owned(), format!("it follows from {one}")),
            all => (format!("{} speeds", all.len()), format!("it follows from {}", all.join(", "))),
        };
        let message = format!("the constraints leave {count}, and `{name}` is none: {follows}");
        (message, format!("leave `{name}` out here; it can be an output of a scene"))
    }

    /// Names of the generalized speeds for an error message, at most 12.
    fn speed_names_in_words(&self) -> String {
        let speeds = self.speeds.iter().take(MOST_LISTED).map(|speed| format!("`{}`", speed.name));
        let more = if self.speeds.len() > MOST_LISTED { " and more" } else { "" };
        format!("{}{more}", speeds.collect::<Vec<_>>().join(", "))
    }
}
