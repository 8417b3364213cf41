//! Sheet of a sketch, with its marks and the labels that are requested for it.

use super::drawing_elements::{DrawingPoint, LabelWord, Mark, MarkRole};
use super::label_placement::LabelRequest;

/// Sheet of a sketch: its marks, and the labels that are still to be placed.
#[derive(Default)]
pub struct Sheet {
    /// Marks on the sheet, from back to front.
    pub marks: Vec<Mark>,
    /// Labels that are still to be placed. Needed labels choose their places first, then optional labels in
    /// the order of the list.
    pub wishes: Vec<LabelRequest>,
}

impl Sheet {
    /// Adds marks in front of all marks on the sheet.
    pub fn add(&mut self, marks: impl IntoIterator<Item = Mark>) {
        self.marks.extend(marks);
    }

    /// Requests a label that must be placed. `anchor` is the named place on the sheet, and `gap` the least
    /// distance from it, px. `towards` is a preferred direction; `None` allows any.
    pub fn request_label(
        &mut self,
        role: MarkRole,
        words: Vec<LabelWord>,
        anchor: DrawingPoint,
        towards: Option<DrawingPoint>,
        gap: f64,
    ) {
        self.wishes.push(LabelRequest { role, words, anchor, towards, gap, is_needed: true });
    }

    /// Requests a label that is placed only if there is room. `anchor` is the named place on the sheet, and
    /// `gap` the least distance from it, px. `towards` is a preferred direction; `None` allows any.
    pub fn request_optional_label(
        &mut self,
        role: MarkRole,
        words: Vec<LabelWord>,
        anchor: DrawingPoint,
        towards: Option<DrawingPoint>,
        gap: f64,
    ) {
        self.wishes.push(LabelRequest { role, words, anchor, towards, gap, is_needed: false });
    }
}
