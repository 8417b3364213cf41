//! Where generated text comes from, as its header says it.

/// The start of every sentence that [`Origin`] gives.
const GENERATED: &str = "Generated from `";

/// The files that a module is generated from, and the command that does it.
pub(crate) struct Origin {
    /// The folder of the files as the header states it, with the `/` behind it.
    pub folder: String,
    /// The name of the model file.
    pub model: String,
    /// The command of `tripos` that writes the text.
    pub command: &'static str,
}

impl Origin {
    /// The sentence in files derived from the model.
    pub fn of_model(&self) -> String {
        self.of(&self.model)
    }

    /// The sentence in files of what the report beside the model prints.
    pub fn of_report(&self) -> String {
        self.of("report.toml")
    }

    /// The sentence in files derived from a scene of the model, named as it is seen from there.
    pub fn of_scene(&self, name: &str) -> String {
        self.of(name)
    }

    /// Whether the equations of scenes are written, too: those of a workspace are.
    pub fn has_scenes(&self) -> bool {
        self.command == "regenerate"
    }

    fn of(&self, file: &str) -> String {
        // The quotes of the path are Markdown's: one of its own would end them.
        let path = format!("{}{file}", self.folder).replace('`', "'");
        format!("{GENERATED}{path}`. {}", advice(self.command))
    }
}

fn advice(command: &str) -> String {
    format!("Do not edit; run `tripos {command}`.")
}

/// Whether a text has the header of what this command writes: an origin in a comment before the first item.
pub(crate) fn is_written_by(text: &str, command: &str) -> bool {
    let advice = advice(command);
    let mut header = text.lines().map_while(|line| line.strip_prefix("//!").or_else(|| line.strip_prefix("//")));
    header.any(|line| line.trim_start().starts_with(GENERATED) && line.ends_with(&advice))
}
