//! Origin of generated text, as stated in its header.

use std::path::Path;

/// Command that writes Rust and JavaScript modules of one model file, as stated in their headers.
pub(crate) const EMIT: &str = "emit";

/// Beginning of the origin sentence in files generated from a model, publication or scene.
const GENERATED: &str = "Generated from `";
/// Beginning of the origin sentence in files that are the same for every model.
const BESIDE: &str = "Goes with what is generated from `";

/// Name of the file of a publication beside a model.
const PUBLICATION: &str = "publication.toml";

/// Characters that begin a comment in one of the languages.
const MARKS: [&str; 4] = ["//!", "//", "#", "%"];

/// Files from which a module is generated, and the command that generates it.
pub(crate) struct Origin {
    /// Folder of the files as the header states it, with a `/` at its end; may be empty.
    pub folder: String,
    /// Name of the model file.
    pub model: String,
    /// Command of `tripos` that writes the text.
    pub command: &'static str,
}

impl Origin {
    /// Origin of the modules that a command writes from one model file. If the file is `model.toml`, the name of its
    /// folder is added, because the file name alone would say little. The origin does not depend on where the folder
    /// is.
    pub fn emitted(path: &Path, command: &'static str) -> Self {
        let name = |path: Option<&std::ffi::OsStr>| path.map(|name| name.to_string_lossy().into_owned());
        let model = name(path.file_name()).unwrap_or_default();
        let full = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        let folder = full.parent().and_then(|folder| name(folder.file_name()));
        let folder = folder.filter(|_| model == "model.toml").map(|folder| format!("{folder}/"));
        Self { folder: folder.unwrap_or_default(), model, command }
    }

    /// Origin sentence in files that are the same for every model.
    #[cfg(any(feature = "js", feature = "languages"))]
    pub fn of_shared_files(&self) -> String {
        self.of_model().replacen(GENERATED, BESIDE, 1)
    }

    /// Origin sentence in files derived from the model.
    pub fn of_model(&self) -> String {
        self.of(&self.model)
    }

    /// Origin sentence in files with the printed equations of the publication beside the model.
    pub fn of_publication(&self) -> String {
        self.of(PUBLICATION)
    }

    /// Origin sentence in files derived from a scene, whose path is relative to the folder of the model.
    #[cfg(feature = "rust")]
    pub fn of_scene(&self, name: &str) -> String {
        self.of(name)
    }

    /// True if the equations of scenes are also written, as for a workspace.
    #[cfg(feature = "rust")]
    pub fn has_scenes(&self) -> bool {
        self.command == "regenerate"
    }

    fn of(&self, file: &str) -> String {
        // The path is in Markdown's quotes, which a backquote in the path would end.
        let path = format!("{}{file}", self.folder).replace('`', "'");
        format!("{GENERATED}{path}`. {}", advice(self.command))
    }
}

fn advice(command: &str) -> String {
    format!("Do not edit; run `tripos {command}`.")
}

/// True if a command wrote the text: its header has the origin sentence in a comment before the first item.
pub(crate) fn is_written_by(text: &str, command: &str) -> bool {
    source_in(text, command).is_some()
}

/// Place of the file from which a text was generated, as the text's header states it.
pub(crate) struct StatedSource {
    folder: String,
    file: String,
}

impl StatedSource {
    /// True if two texts were generated from one model, or from the publication beside it.
    pub(crate) fn is_of_one_model(&self, other: &Self) -> bool {
        self.folder == other.folder && !self.differs(other)
    }

    /// Path of the other text's model if it has another file name than this one's: a folder may have moved.
    pub(crate) fn other_model(&self, other: &Self) -> Option<String> {
        let Self { folder, file } = other;
        self.differs(other).then(|| if folder.is_empty() { file.clone() } else { format!("{folder}/{file}") })
    }

    /// True if the names of the files are those of different models.
    fn differs(&self, other: &Self) -> bool {
        self.file != other.file && [self, other].iter().all(|source| source.file != PUBLICATION)
    }
}

/// File from which a command generated the text, as its header states it; `None` if the command did not write the text.
pub(crate) fn source_in(text: &str, command: &str) -> Option<StatedSource> {
    let advice = advice(command);
    let comment = |line: &'_ str| MARKS.iter().find_map(|mark| line.strip_prefix(mark)).map(str::to_owned);
    let origin = |line: String| {
        let line = line.trim_start();
        let rest = line.strip_prefix(GENERATED).or_else(|| line.strip_prefix(BESIDE))?;
        let path = rest.strip_suffix(&advice)?.trim_end_matches(['`', '.', ' ']);
        let (folder, file) = path.rsplit_once('/').unwrap_or(("", path));
        Some(StatedSource { folder: folder.to_owned(), file: file.to_owned() })
    };
    text.lines().map_while(comment).find_map(origin)
}
