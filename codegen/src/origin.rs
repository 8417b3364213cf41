//! The origin of generated text, as its header states it.

use std::path::Path;

/// The command that writes modules of one model file, as their headers name it.
pub(crate) const EMIT: &str = "emit";

/// The start of every sentence that [`Origin`] gives.
const GENERATED: &str = "Generated from `";
/// The start of the sentence in what is the same for every model.
const BESIDE: &str = "Goes with what is generated from `";

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
    /// Origin of the modules of one model file. `model.toml` alone would say little: the name of its folder goes with
    /// it. Neither depends on where that folder is.
    pub fn emitted(path: &Path) -> Self {
        let name = |path: Option<&std::ffi::OsStr>| path.map(|name| name.to_string_lossy().into_owned());
        let model = name(path.file_name()).unwrap_or_default();
        let full = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        let folder = full.parent().and_then(|folder| name(folder.file_name()));
        let folder = folder.filter(|_| model == "model.toml").map(|folder| format!("{folder}/"));
        Self { folder: folder.unwrap_or_default(), model, command: EMIT }
    }

    /// The sentence in files that are the same for every model.
    #[cfg(feature = "js")]
    pub fn beside(&self) -> String {
        self.of_model().replacen(GENERATED, BESIDE, 1)
    }

    /// The sentence in files derived from the model.
    pub fn of_model(&self) -> String {
        self.of(&self.model)
    }

    /// The sentence in files of what the publication beside the model prints.
    pub fn of_publication(&self) -> String {
        self.of("publication.toml")
    }

    /// The sentence in files derived from a scene of the model, named as it is seen from there.
    #[cfg(feature = "rust")]
    pub fn of_scene(&self, name: &str) -> String {
        self.of(name)
    }

    /// True if the equations of scenes are written too, as they are for a workspace.
    #[cfg(feature = "rust")]
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

/// True if the text has the header that this command writes: an origin in a comment before the first item.
pub(crate) fn is_written_by(text: &str, command: &str) -> bool {
    let advice = advice(command);
    let mut header = text.lines().map_while(|line| line.strip_prefix("//!").or_else(|| line.strip_prefix("//")));
    let starts = |line: &str| line.starts_with(GENERATED) || line.starts_with(BESIDE);
    header.any(|line| starts(line.trim_start()) && line.ends_with(&advice))
}
