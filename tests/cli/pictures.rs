//! Figures as PNG and PDF: what SVG draws, with letters of our own.

use crate::support::{root, tripos_in};
use std::path::{Path, PathBuf};

const SCENE: &str = "models/heavy_top/scenes/looping.toml";

/// A figure of the top's nutation, and what the command says.
fn plotted(folder: &Path, name: &str, more: &[&str]) -> PathBuf {
    let out = folder.join(name);
    let arguments = ["plot", SCENE, "--what", "q1'", "--what", "total_energy", "--out", out.to_str().unwrap()];
    let (status, said, err) = tripos_in(&root(), &[&arguments[..], more].concat());
    assert!(status == 0 && said.contains(name) && out.with_extension("csv").exists(), "{said}{err}");
    out
}

/// The value of an attribute, a number.
fn number(element: &str, attribute: &str) -> f64 {
    let (_, rest) = element.split_once(&format!(" {attribute}=\"")).unwrap_or_else(|| panic!("{attribute}: {element}"));
    rest.split('"').next().unwrap().parse().unwrap()
}

/// Rows of grey pixels.
struct Picture {
    rows: Vec<Vec<u8>>,
    dots_of_a_metre: u32,
}

impl Picture {
    fn read(path: &Path) -> Self {
        let mut reader = png::Decoder::new(std::fs::File::open(path).unwrap()).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size()];
        let frame = reader.next_frame(&mut pixels).unwrap();
        assert_eq!((frame.color_type, frame.bit_depth), (png::ColorType::Rgb, png::BitDepth::Eight));
        let width = frame.width as usize;
        let grey = |rgb: &[u8]| rgb.iter().copied().max().unwrap();
        let rows = pixels.chunks(3 * width).map(|row| row.chunks(3).map(grey).collect()).collect();
        Self { rows, dots_of_a_metre: reader.info().pixel_dims.unwrap().xppu }
    }

    fn size(&self) -> (usize, usize) {
        (self.rows[0].len(), self.rows.len())
    }

    /// The share of pixels of a box that are as dark as letters are.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "places within a picture")]
    fn darkness(&self, [left, right, top, bottom]: [f64; 4]) -> f64 {
        let rows = &self.rows[top.max(0.0) as usize..(bottom as usize).min(self.rows.len())];
        let cut = |row: &'_ Vec<u8>| row[left.max(0.0) as usize..(right as usize).min(row.len())].to_vec();
        let pixels: Vec<u8> = rows.iter().flat_map(cut).collect();
        pixels.iter().filter(|grey| **grey < 110).count() as f64 / pixels.len().max(1) as f64
    }
}

/// Goal: a picture is the figure, of the wanted size, with its words. Method: compared with the SVG: 1000 pixels of CSS
/// are 10.4 inches; the picture is dark at the anchor of each label, and white beside the title.
#[test]
fn a_png_shows_what_the_svg_draws() {
    let folder = tempfile::tempdir().unwrap();
    let svg = std::fs::read_to_string(plotted(folder.path(), "a.svg", &[])).unwrap();
    let head = svg.split_once('>').unwrap().0;
    let height = number(head, "height");
    for (dots, more) in [(200.0, &[][..]), (96.0, &["--dpi", "96"]), (300.0, &["--dpi", "300"])] {
        let path = plotted(folder.path(), "a.png", more);
        let picture = Picture::read(&path);
        let (width, tall) = picture.size();
        let inches = |pixels: f64| (pixels / 96.0 * dots).round();
        assert!((width as f64 - inches(1000.0)).abs() < 0.5 && (tall as f64 - inches(height)).abs() < 0.5);
        assert!((f64::from(picture.dots_of_a_metre) * 0.0254 - dots).abs() < 0.02);
        let view_box = head.split_once("viewBox=\"0 0 ").unwrap().1.split(' ').next().unwrap();
        let (scale, em) = (width as f64 / view_box.parse::<f64>().unwrap(), dots / 96.0 * 12.5);
        let labels: Vec<&str> = svg
            .split("<text ")
            .skip(1)
            .filter(|label| !label.split('>').next().unwrap().contains("transform"))
            .collect();
        assert!(labels.len() > 8, "{}", labels.len());
        for label in labels {
            let label = format!(" {label}");
            let (x, y) = (number(&label, "x") * scale, number(&label, "y") * scale);
            let (left, right) = match () {
                () if label.contains("text-anchor=\"end\"") => (x - em, x),
                () if label.contains("text-anchor=\"middle\"") => (x - em / 2.0, x + em / 2.0),
                () => (x, x + em),
            };
            let dark = picture.darkness([left, right, y - 0.6 * em, y + 0.6 * em]);
            assert!(dark > 0.02 && dark < 0.6, "{dark} dark at {label}");
        }
        assert!(picture.darkness([0.0, width as f64, 0.0, tall as f64]) < 0.1, "white between curves");
        let first = std::fs::read(&path).unwrap();
        assert!(std::fs::read(plotted(folder.path(), "a.png", more)).unwrap() == first, "the same each time");
    }
}

/// Goal: a document takes the figure as it is: a page of its size whose letters are letters.
#[test]
fn a_pdf_has_its_size_and_its_fonts() {
    let folder = tempfile::tempdir().unwrap();
    let path = plotted(folder.path(), "a.pdf", &[]);
    let bytes = std::fs::read(&path).unwrap();
    let text = String::from_utf8_lossy(&bytes).into_owned();
    assert!(text.starts_with("%PDF-") && text.trim_end().ends_with("%%EOF"));
    // 1000 pixels of CSS in points.
    let page = text.split_once("/MediaBox").expect("a page has a size").1;
    let page: Vec<f64> =
        page.split(['[', ']']).nth(1).unwrap().split_whitespace().map(|x| x.parse().unwrap()).collect();
    assert!((page[2] - 750.0).abs() < 0.01 && page[3] > 100.0, "{page:?}");
    for part in ["/FontFile", "/ToUnicode", "+DejaVuSans"] {
        assert!(text.contains(part), "{part}");
    }
    assert!(std::fs::read(plotted(folder.path(), "a.pdf", &[])).unwrap() == bytes, "the same each time");
}

#[test]
fn other_kinds_and_sizes_are_refused_before_anything_runs() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |name: &str, more: &[&str]| {
        let out = folder.path().join(name);
        let (status, said, err) =
            tripos_in(&root(), &[&["plot", SCENE, "--out", out.to_str().unwrap()], more].concat());
        assert!(status == 2 && said.is_empty() && !out.exists(), "{name}: {said}{err}");
        err
    };
    for name in ["a.jpg", "a", "a.PNG"] {
        let said = refused(name, &[]);
        assert!(said.contains("names no kind of figure"), "{said}");
        assert!(said.contains("give a file that ends in .svg, .png or .pdf, or in .csv for the data alone"), "{said}");
    }
    for dots in ["0", "19", "1201"] {
        assert!(refused("a.png", &["--dpi", dots]).contains("give a number from 20 to 1200"));
    }
}
