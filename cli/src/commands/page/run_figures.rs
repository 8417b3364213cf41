//! Figures of a scene's runs on the page: states and energies. Their data are written as tables into a folder of the
//! page.
//!
//! Invariant: each row of a table is a point that was given to the plot, so that table and plot cannot differ.

use crate::files::output_files::{make_folder, write_table_file, write_text_file};
use crate::page::Figure;
use crate::plot::{Panel, draw};
use crate::terminal::failure::Failure;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use tripos::{Error, Mechanism};
use tripos_codegen::model_folders::scene_path_in_model_folder;
use tripos_derive::plain_text::is_forbidden;
use tripos_derive::scene::Scene;

/// Returns the folder of a scene's tables, relative to the page's folder. It has the name of the scene's file. A scene
/// in the model's own folder gets a longer name if a scene in `scenes/` has the same name.
pub fn run_figure_folder(model: &Mechanism, scene: &Scene) -> PathBuf {
    let (model, path) = (&model.source.path, &scene.source.path);
    let stem = run_figure_folder_name(&path.file_stem().unwrap_or_default().to_string_lossy());
    let is_beside = !scene_path_in_model_folder(model, path).starts_with("scenes/");
    let rival = model.with_file_name("scenes").join(path.file_name().unwrap_or_default());
    let mut name = stem;
    if is_beside && rival.is_file() {
        name.push_str(" beside the model");
    }
    name.into()
}

/// Returns a safe folder name that is made from a file name. It cannot lead out of the page's folder, is not the page's
/// own file, and contains no control character.
fn run_figure_folder_name(stem: &str) -> String {
    let plain: String = stem.chars().map(|c| if is_forbidden(c) || c == '/' || c == '\\' { '_' } else { c }).collect();
    if plain.trim_matches('.').is_empty() || plain == "index.html" { format!("scene {plain}") } else { plain }
}

/// Drawer of a scene's figures that also writes their tables.
pub struct RunFigureWriter<'a> {
    /// Path of the page's folder.
    pub out: &'a Path,
    /// Folder of the scene's tables, relative to the folder of the page.
    pub folder: PathBuf,
    /// Number of figures drawn so far with each name.
    pub names: BTreeMap<String, usize>,
}

impl RunFigureWriter<'_> {
    /// Draws panels as a figure, and writes it to `NAME.svg` and its data to `NAME.csv`. The second figure with the
    /// same name is `NAME-2`.
    ///
    /// # Errors
    /// [`Failure::Refused`] if the figure cannot be drawn, [`Failure::Output`] if a file cannot be written.
    pub fn figure(&mut self, name: &str, caption: &str, panels: &[Panel], columns: usize) -> Result<Figure, Failure> {
        let count = self.names.entry(name.to_owned()).or_default();
        *count += 1;
        let name = if *count == 1 { name.to_owned() } else { format!("{name}-{count}") };
        let figure = run_figure(caption, panels, columns)?;
        let inside = self.out.join(&self.folder);
        make_folder(&inside)?;
        let [csv, svg] = ["csv", "svg"].map(|ending| format!("{name}.{ending}"));
        write_table_file(&inside.join(&csv), &["quantity", "equations", "t", "value"], panels.iter().flat_map(rows))?;
        write_text_file(&inside.join(&svg), &figure.svg)?;
        let link = |file: String| format!("{}/{file}", self.folder.display());
        Ok(Figure { data: vec![link(csv), link(svg)], ..figure })
    }
}

/// Returns the table rows of a panel, one for each point: quantity, equations, t and value.
fn rows(panel: &Panel) -> impl Iterator<Item = Vec<String>> + '_ {
    panel.series.iter().flat_map(move |series| {
        let row = |(t, value): &(f64, f64)| {
            vec![panel.y_label.clone(), series.label.clone(), t.to_string(), value.to_string()]
        };
        series.points.iter().map(row)
    })
}

/// Draws panels as a figure of the page, without writing a table.
///
/// # Errors
/// [`Failure::Refused`] if the figure cannot be drawn.
pub fn run_figure(caption: &str, panels: &[Panel], columns: usize) -> Result<Figure, Failure> {
    let svg = draw(panels, columns)
        .map_err(|error| Error::Stopped(format!("the figure `{caption}` cannot be drawn: {error}")))?;
    Ok(Figure { caption: caption.to_owned(), svg, remark: None, data: Vec::new() })
}

/// Returns the caption of a figure: the caption in the scene file, if there is one, then the computed sentence.
pub fn run_figure_caption(own: &str, computed: &str) -> String {
    match own.trim_end_matches('.') {
        "" => computed.to_owned(),
        own => format!("{own}. {computed}"),
    }
}

#[cfg(test)]
mod tests {
    use super::run_figure_folder_name;

    #[test]
    fn no_name_leaves_the_folder_of_the_page() {
        for (stem, folder) in [
            ("fall", "fall"),
            ("..", "scene .."),
            (".", "scene ."),
            ("", "scene "),
            ("...", "scene ..."),
            ("index.html", "scene index.html"),
            ("a/../b", "a_.._b"),
            ("e\u{1b}[31m", "e_[31m"),
        ] {
            assert_eq!(run_figure_folder_name(stem), folder);
            let path = std::path::Path::new(folder);
            assert!(
                path.components().all(|c| matches!(c, std::path::Component::Normal(_)))
                    && path.components().count() == 1
            );
        }
    }
}
