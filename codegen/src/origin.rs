//! Sentence in the header of generated text. It names the source file and the command that wrote the text.

use std::path::Path;

/// Subcommand of `tripos` that writes Rust and JavaScript modules of one model file. The headers of
/// these modules state it.
pub(crate) const EMIT: &str = "emit";

/// Beginning of the header sentence in files generated from a model, publication or scene.
const GENERATED_FILE_PREFIX: &str = "Generated from `";
/// Beginning of the header sentence in files that are the same for every model.
const SHARED_FILE_PREFIX: &str = "Goes with what is generated from `";

/// Name of the publication file, which lies in the folder of its model.
const PUBLICATION: &str = "publication.toml";

/// Marks with which a comment line begins in the target languages: Rust, C and JavaScript, Python, MATLAB, XML.
const COMMENT_MARKS: [&str; 5] = ["//!", "//", "#", "%", "<!--"];
/// Mark with which a comment of XML ends.
const XML_COMMENT_END: &str = "-->";

/// Source files of a generated module, and the command that generates it.
pub(crate) struct Origin {
    /// Folder of the source files as the header states it, with a `/` at its end. It may be empty.
    pub folder: String,
    /// File name of the model, without its folder.
    pub model: String,
    /// Subcommand of `tripos` that writes the module, such as `emit`.
    pub command: &'static str,
}

impl Origin {
    /// Returns the origin of modules that a command writes from the model file at `path`. If the file is
    /// `model.toml`, the name of its folder is added, because that file name alone says little. The result does not
    /// depend on the place of the folder.
    pub fn origin_of_model_file(path: &Path, command: &'static str) -> Self {
        let name = |path: Option<&std::ffi::OsStr>| path.map(|name| name.to_string_lossy().into_owned());
        let model = name(path.file_name()).unwrap_or_default();
        let full = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        let folder = full.parent().and_then(|folder| name(folder.file_name()));
        let folder = folder.filter(|_| model == "model.toml").map(|folder| format!("{folder}/"));
        Self { folder: folder.unwrap_or_default(), model, command }
    }

    /// Returns the header sentence for files that are the same for every model.
    #[cfg(any(feature = "js", feature = "languages"))]
    pub fn shared_file_origin_sentence(&self) -> String {
        self.model_origin_sentence().replacen(GENERATED_FILE_PREFIX, SHARED_FILE_PREFIX, 1)
    }

    /// Returns the header sentence for files derived from the model.
    pub fn model_origin_sentence(&self) -> String {
        self.origin_sentence(&self.model)
    }

    /// Returns the header sentence for files with the printed equations of the publication in the
    /// model's folder.
    pub fn publication_origin_sentence(&self) -> String {
        self.origin_sentence(PUBLICATION)
    }

    /// Returns the header sentence for files derived from a scene. `name` is the scene's path
    /// relative to the model's folder.
    #[cfg(feature = "rust")]
    pub fn scene_origin_sentence(&self, name: &str) -> String {
        self.origin_sentence(name)
    }

    /// True if code is also generated for scenes. This holds only for the command `regenerate`.
    #[cfg(feature = "rust")]
    pub fn has_scenes(&self) -> bool {
        self.command == "regenerate"
    }

    /// Returns the header sentence for a source file: its path in backquotes, then the advice to run the command.
    fn origin_sentence(&self, file: &str) -> String {
        // The path is in the backquotes of Markdown, which a backquote in the path would end.
        let path = format!("{}{file}", self.folder).replace('`', "'");
        format!("{GENERATED_FILE_PREFIX}{path}`. {}", origin_sentence_advice(self.command))
    }
}

/// Returns the name of the model's folder, or the name of its file without extension if the origin
/// states no folder.
#[cfg(feature = "languages")]
pub(crate) fn model_name_of_origin(origin: &Origin) -> &str {
    let stem = origin.folder.trim_end_matches('/');
    if stem.is_empty() { origin.model.trim_end_matches(".toml") } else { stem }
}

/// Returns the advice in a header: not to edit the file, and the `tripos` command that writes it.
fn origin_sentence_advice(command: &str) -> String {
    format!("Do not edit; run `tripos {command}`.")
}

/// True if the `tripos` command `command` wrote the text, so that the text's leading comment contains the header
/// sentence of that command.
pub(crate) fn is_written_by(text: &str, command: &str) -> bool {
    read_origin_source(text, command).is_some()
}

/// Source file of a generated text, as the text's header states it.
pub(crate) struct OriginSource {
    folder: String,
    file: String,
    is_shared: bool,
}

impl OriginSource {
    /// True if two generated texts come from the same model: their folders are equal, and their model files do not
    /// differ. A publication counts as part of the model in its folder.
    pub(crate) fn is_of_one_model(&self, other: &Self) -> bool {
        self.folder == other.folder && !self.is_of_other_model(other)
    }

    /// Path of the model from which `other` was generated, if the headers of the two texts name different model
    /// files. `None` if the file names agree. Folders are not compared, because a folder may have moved.
    pub(crate) fn path_of_other_model(&self, other: &Self) -> Option<String> {
        let Self { folder, file, .. } = other;
        self.is_of_other_model(other).then(|| if folder.is_empty() { file.clone() } else { format!("{folder}/{file}") })
    }

    /// True if the headers of two texts name different model files. A publication never counts as different, and
    /// neither do files that all models share.
    fn is_of_other_model(&self, other: &Self) -> bool {
        let are_shared = self.is_shared && other.is_shared;
        !are_shared && self.file != other.file && [self, other].iter().all(|source| source.file != PUBLICATION)
    }
}

/// Reads the header of a generated text and returns the source file that it states. `None` if
/// `command` did not write the text.
pub(crate) fn read_origin_source(text: &str, command: &str) -> Option<OriginSource> {
    let advice = origin_sentence_advice(command);
    let comment = |line: &'_ str| COMMENT_MARKS.iter().find_map(|mark| line.strip_prefix(mark)).map(str::to_owned);
    let origin = |line: String| {
        let line = line.trim_start();
        let line = line.strip_suffix(XML_COMMENT_END).map_or(line, str::trim_end);
        let shared = line.strip_prefix(SHARED_FILE_PREFIX);
        let rest = line.strip_prefix(GENERATED_FILE_PREFIX).or(shared)?;
        let path = rest.strip_suffix(&advice)?.trim_end_matches(['`', '.', ' ']);
        let (folder, file) = path.rsplit_once('/').unwrap_or(("", path));
        Some(OriginSource { folder: folder.to_owned(), file: file.to_owned(), is_shared: shared.is_some() })
    };
    text.lines().map_while(comment).find_map(origin)
}
