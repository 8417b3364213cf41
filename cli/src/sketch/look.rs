//! Looks of the marks and labels in a sketch, by their meaning: class name, stroke and colours.

use tripos::pictures::sketch::MarkRole;

/// Look of all marks and labels with the same meaning, such as a body or a spring.
pub struct Look {
    /// Name of the look: a class in SVG, and a style in `TikZ`.
    pub name: &'static str,
    /// Width of the lines of marks, in pixels.
    pub wide: f64,
    /// Lengths of dashes and gaps, in pixels; `None` for a solid line.
    pub dashes: Option<(f64, f64)>,
    /// Colour (red, green, blue) of lines and words on a white background.
    pub ink: [u8; 3],
    /// Colour (red, green, blue) inside outlines on a white background.
    pub shade: [u8; 3],
    /// Two colours on a dark background: the colour of lines and words, and the colour inside outlines.
    pub dark: [[u8; 3]; 2],
}

const BLACK: [u8; 3] = [0x22, 0x22, 0x22];
const GREY: [u8; 3] = [0x6b, 0x6b, 0x70];
const WHITE: [u8; 3] = [0xff, 0xff, 0xff];
const PALE: [u8; 3] = [0xe6, 0xe4, 0xdf];
const PALE_GREY: [u8; 3] = [0x9a, 0x98, 0x95];
const NIGHT: [u8; 3] = [0x17, 0x18, 0x1a];

/// Returns a look with solid lines from its name, line width (px) and colours.
const fn solid_look(name: &'static str, wide: f64, ink: [u8; 3], shade: [u8; 3], dark: [[u8; 3]; 2]) -> Look {
    Look { name, wide, dashes: None, ink, shade, dark }
}

/// Returns the look of the marks and labels with the meaning `role`.
pub fn look_of_role(role: MarkRole) -> Look {
    match role {
        MarkRole::Ground => solid_look("ground", 0.8, GREY, [0xf4, 0xf3, 0xee], [PALE_GREY, [0x20, 0x22, 0x26]]),
        MarkRole::Support => solid_look("support", 1.0, BLACK, WHITE, [PALE, NIGHT]),
        MarkRole::Body => solid_look("body", 1.4, BLACK, [0xdf, 0xe7, 0xee], [PALE, [0x2d, 0x38, 0x42]]),
        MarkRole::Mass => solid_look("mass", 1.4, BLACK, [0x9f, 0xb3, 0xc4], [PALE, [0x5d, 0x73, 0x86]]),
        MarkRole::Spring => solid_look("spring", 1.3, BLACK, WHITE, [PALE, NIGHT]),
        MarkRole::Joint => solid_look("joint", 1.4, BLACK, WHITE, [PALE, NIGHT]),
        MarkRole::Reference => {
            Look { dashes: Some((3.0, 3.0)), ..solid_look("reference", 0.8, GREY, WHITE, [PALE_GREY, NIGHT]) }
        }
        MarkRole::Axis => solid_look("axis", 1.2, [0x1b, 0x6e, 0x4a], WHITE, [[0x74, 0xd1, 0xa4], NIGHT]),
        MarkRole::Coordinate => solid_look("coordinate", 1.4, [0xa8, 0x2c, 0x1a], WHITE, [[0xff, 0x9d, 0x86], NIGHT]),
        MarkRole::Gravity => solid_look("gravity", 1.8, BLACK, WHITE, [PALE, NIGHT]),
        MarkRole::Point => solid_look("point", 1.0, BLACK, WHITE, [PALE, NIGHT]),
        MarkRole::Leader => solid_look("leader", 0.6, GREY, WHITE, [PALE_GREY, NIGHT]),
    }
}
