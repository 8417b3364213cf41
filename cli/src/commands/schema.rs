//! Command `tripos schema`: prints JSON Schemas of the file formats, for editors.

use crate::terminal::failure::{Failure, print};
use tripos_derive::schema::SchemaFormat;

/// Prints the JSON Schema of a file format, or nothing for an unknown format. Returns the exit status.
///
/// # Errors
/// [`Failure`] if the schema cannot be printed.
pub fn schema(format: &str) -> Result<u8, Failure> {
    for known in SchemaFormat::ALL.into_iter().filter(|known| known.name() == format) {
        print(&format!("{:#}\n", known.schema()))?;
    }
    Ok(0)
}
