//! Kinds of joints and the relative motions that they permit.

/// Kind of a joint, which determines the relative motion of the two bodies: see
/// [`JointKind::freedoms`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum JointKind {
    /// Rotation about one axis.
    Pin,
    /// Displacement along one axis.
    Slider,
    /// Rotation about an axis and an independent displacement along it.
    Cylinder,
    /// Rotation about an axis with a proportional displacement along it.
    Screw,
    /// Rotations about two axes, one after the other.
    Universal,
    /// Three rotations, by angles or by Euler parameters.
    Ball,
    /// Two displacements in a plane and a rotation about its normal.
    Planar,
    /// No relative motion.
    Weld,
    /// Three displacements and three rotations.
    Free,
}

/// Kinds of joints by their names in model files, in the order in which messages list them.
pub const KINDS: [(&str, JointKind); 9] = [
    ("pin", JointKind::Pin),
    ("slider", JointKind::Slider),
    ("cylinder", JointKind::Cylinder),
    ("screw", JointKind::Screw),
    ("universal", JointKind::Universal),
    ("ball", JointKind::Ball),
    ("planar", JointKind::Planar),
    ("weld", JointKind::Weld),
    ("free", JointKind::Free),
];

/// Names of the kinds of joints in model files, in the order of [`KINDS`].
pub const JOINT_KINDS: [&str; KINDS.len()] = {
    let mut names = [""; KINDS.len()];
    let mut at = 0;
    while at < names.len() {
        names[at] = KINDS[at].0;
        at += 1;
    }
    names
};

/// Degree of freedom of a joint: a displacement along, or a rotation about, an axis 0, 1 or 2.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum JointFreedom {
    /// Displacement along an axis of the joint's frame. This frame is fixed on the body to which the joint is
    /// attached.
    Along(usize),
    /// Rotation about an axis of the frame that the joint's earlier rotations produce.
    About(usize),
    /// Rotation about an axis together with a displacement along it. A full turn displaces by the lead of the screw.
    Screwed(usize),
    /// Euler parameter: one of four coordinates that describe a rotation. The first of the four is the scalar.
    Parameter,
}

impl JointKind {
    /// Degree of freedom of each coordinate of a joint of the given kind, in the order of the coordinates. `axes` are
    /// the axes of the joint's rotations; an empty list means Euler parameters.
    pub fn freedoms(self, axes: &[usize]) -> Vec<JointFreedom> {
        let turns = axes.iter().map(|axis| JointFreedom::About(*axis));
        let parameters = if axes.is_empty() { 4 } else { 0 };
        let turns_or_parameters = turns.clone().chain(std::iter::repeat_n(JointFreedom::Parameter, parameters));
        let axis = axes.first().copied().unwrap_or(2);
        match self {
            Self::Pin | Self::Universal => turns.collect(),
            Self::Ball => turns_or_parameters.collect(),
            Self::Slider => vec![JointFreedom::Along(axis)],
            Self::Cylinder => vec![JointFreedom::About(axis), JointFreedom::Along(axis)],
            Self::Screw => vec![JointFreedom::Screwed(axis)],
            Self::Planar => {
                vec![
                    JointFreedom::Along((axis + 1) % 3),
                    JointFreedom::Along((axis + 2) % 3),
                    JointFreedom::About(axis),
                ]
            }
            Self::Weld => Vec::new(),
            Self::Free => [0, 1, 2].map(JointFreedom::Along).into_iter().chain(turns_or_parameters).collect(),
        }
    }

    /// Keys that a joint of the given kind may have in a model file, in addition to the keys that every joint has.
    pub fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Pin | Self::Slider | Self::Cylinder | Self::Planar => &["axis"],
            Self::Screw => &["axis", "lead"],
            Self::Universal => &["axes"],
            Self::Ball | Self::Free => &["sequence"],
            Self::Weld => &[],
        }
    }
}

/// Formulas, as text, of the angular velocity ω of a rotation that Euler parameters ε₀, ε describe. The three
/// components are in the rotated frame: 2 (ε₀ ε' − ε₀' ε − ε × ε')/|ε|². `names` are the four coordinates, the scalar
/// ε₀ first.
pub fn angular_velocity_by_euler_parameters(names: [&str; 4]) -> [String; 3] {
    let [w, x, y, z] = names;
    let length = names.map(|name| format!("{name}^2")).join(" + ");
    [(x, y, z), (y, z, x), (z, x, y)]
        .map(|(i, j, k)| format!("2*({w}*{i}' - {w}'*{i} - {j}*{k}' + {k}*{j}')/({length})"))
}

/// Formulas, as text, of the angular velocity ω after successive rotations about body-fixed axes. The three
/// components are in the last frame.
///
/// The later rotations express the axis of each rotation in the last frame. A frame rotated by q about axis b sees
/// the unit vector e_a as e_a cos q ∓ (third axis) sin q.
pub fn angular_velocity_formulas(axes: &[usize], angles: &[&str]) -> Vec<String> {
    let mut sums: [Vec<String>; 3] = Default::default();
    for (first, (axis, angle)) in axes.iter().zip(angles).enumerate() {
        // Terms of the rotation's axis in the last frame, each as (axis, sign, factors).
        let mut parts = vec![(*axis, 1, String::new())];
        for (about, by) in axes.iter().zip(angles).skip(first + 1) {
            let turned = |(axis, sign, factors): &(usize, i32, String)| {
                if axis == about {
                    return vec![(*axis, *sign, factors.clone())];
                }
                let third = 3 - axis - about;
                // Seen from the rotated frame, the axis rotates backwards, towards axis × about.
                let side = if (axis + 1) % 3 == *about { 1 } else { -1 };
                vec![
                    (*axis, *sign, format!("{factors}*cos({by})")),
                    (third, sign * side, format!("{factors}*sin({by})")),
                ]
            };
            parts = parts.iter().flat_map(turned).collect();
        }
        for (axis, sign, factors) in parts {
            sums[axis].push(format!("{} {angle}'{factors}", if sign > 0 { "+" } else { "-" }));
        }
    }
    sums.map(|terms| terms.join(" ")).into()
}

#[cfg(test)]
mod tests {
    use super::angular_velocity_formulas;

    #[test]
    fn angular_velocity_of_turns_about_1_2_and_3() {
        // T. R. Kane, P. W. Likins & D. A. Levinson, Spacecraft Dynamics (1983), appendix II, body-three 1-2-3.
        let [a, b, c] =
            <[String; 3]>::try_from(angular_velocity_formulas(&[0, 1, 2], &["a", "b", "c"])).expect("three");
        assert_eq!(a, "+ a'*cos(b)*cos(c) + b'*sin(c)");
        assert_eq!(b, "- a'*cos(b)*sin(c) + b'*cos(c)");
        assert_eq!(c, "+ a'*sin(b) + c'");
    }
}
