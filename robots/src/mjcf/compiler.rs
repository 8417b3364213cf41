//! Settings of `<compiler>` of MJCF files.

use super::element::Angles;
use crate::xml::{Reading, elements, fixed_numbers, place};
use roxmltree::Node;

/// Part of the file that gives a body its mass.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum InertiaSource {
    /// `<inertial>` if the body has it, else its geoms.
    Auto,
    /// Geoms if the body has any, else `<inertial>`.
    Geoms,
    /// `<inertial>` alone.
    Inertial,
}

/// Settings of `<compiler>`.
pub struct Compiler {
    /// Unit and sequence of angles.
    pub angles: Angles,
    /// True if a range alone limits a joint.
    pub has_automatic_limits: bool,
    /// Part of the file that gives a body its mass.
    pub inertia_source: InertiaSource,
    /// Smallest and largest group of geoms that give mass.
    pub mass_groups: [f64; 2],
    /// Smallest mass of a body, kg.
    pub least_mass: f64,
    /// Smallest principal moment of inertia, kg m².
    pub least_moment: f64,
    /// True if moments that no body has are replaced by their mean.
    pub balances_moments: bool,
    /// Mass of the whole robot, kg, to which all masses are scaled.
    pub total_mass: Option<f64>,
}

/// Reads the settings of all `<compiler>` elements; the last value of a setting counts.
pub fn read(root: Node<'_, '_>, reading: &Reading) -> Compiler {
    let mut compiler = Compiler {
        angles: Angles { unit: 1.0_f64.to_radians(), sequence: "xyz".to_owned() },
        has_automatic_limits: true,
        inertia_source: InertiaSource::Auto,
        mass_groups: [0.0, 5.0],
        least_mass: 0.0,
        least_moment: 0.0,
        balances_moments: false,
        total_mass: None,
    };
    for node in elements(root).filter(|node| node.has_tag_name("compiler")) {
        match node.attribute("angle") {
            Some("radian") => compiler.angles.unit = 1.0,
            Some("degree") => compiler.angles.unit = 1.0_f64.to_radians(),
            _ => {}
        }
        if let Some(sequence) = node.attribute("eulerseq") {
            if sequence.chars().count() == 3 && sequence.chars().all(|axis| "xyzXYZ".contains(axis)) {
                sequence.clone_into(&mut compiler.angles.sequence);
            } else {
                let message = format!("`eulerseq` is `{sequence}`");
                reading.add(place(node), message, "give three letters of x, y, z, X, Y and Z");
            }
        }
        match node.attribute("inertiafromgeom") {
            Some("true") => compiler.inertia_source = InertiaSource::Geoms,
            Some("false") => compiler.inertia_source = InertiaSource::Inertial,
            _ => {}
        }
        if let Some(range) = fixed_numbers::<2>(node, "inertiagrouprange", reading) {
            compiler.mass_groups = range;
        }
        let number = |name: &str| fixed_numbers::<1>(node, name, reading).map(|[number]| number);
        compiler.has_automatic_limits &= node.attribute("autolimits") != Some("false");
        compiler.balances_moments |= node.attribute("balanceinertia") == Some("true");
        compiler.least_mass = number("boundmass").unwrap_or(compiler.least_mass);
        compiler.least_moment = number("boundinertia").unwrap_or(compiler.least_moment);
        compiler.total_mass = number("settotalmass").filter(|mass| *mass > 0.0).or(compiler.total_mass);
        if node.attribute("coordinate") == Some("global") {
            reading.add(place(node), "poses in axes of the ground are no longer part of MJCF", "give local poses");
        }
    }
    compiler
}
