//! Kinds of joints, and the motions that they permit.

/// Kind of a joint, which determines how its body may move: see [`JointKind::freedoms`].
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum JointKind {
    Pin,
    Slider,
    Cylinder,
    Screw,
    Universal,
    Ball,
    Planar,
    Weld,
    Free,
}

/// Kinds of joints by name, in the order in which a message lists them.
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

/// Names of the kinds of joints, in the order of [`KINDS`].
pub const JOINT_KINDS: [&str; KINDS.len()] = {
    let mut names = [""; KINDS.len()];
    let mut at = 0;
    while at < names.len() {
        names[at] = KINDS[at].0;
        at += 1;
    }
    names
};

/// A coordinate of a joint: a displacement along or a turn about an axis, 0, 1 or 2.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Freedom {
    /// A displacement along an axis of the joint's frame on the body that carries.
    Along(usize),
    /// A turn about an axis of the frame to which the turns before it lead.
    About(usize),
    /// A turn about an axis with a displacement along it: one lead for each full turn.
    Screwed(usize),
    /// An Euler parameter. The first of the four is the scalar.
    Parameter,
}

impl JointKind {
    /// Motion of each coordinate of a joint of this kind, in the order of the coordinates. `axes` are those of its
    /// turns; empty for Euler parameters.
    pub fn freedoms(self, axes: &[usize]) -> Vec<Freedom> {
        let turns = axes.iter().map(|axis| Freedom::About(*axis));
        let parameters = if axes.is_empty() { 4 } else { 0 };
        let turns_or_parameters = turns.clone().chain(std::iter::repeat_n(Freedom::Parameter, parameters));
        let axis = axes.first().copied().unwrap_or(2);
        match self {
            Self::Pin | Self::Universal => turns.collect(),
            Self::Ball => turns_or_parameters.collect(),
            Self::Slider => vec![Freedom::Along(axis)],
            Self::Cylinder => vec![Freedom::About(axis), Freedom::Along(axis)],
            Self::Screw => vec![Freedom::Screwed(axis)],
            Self::Planar => {
                vec![Freedom::Along((axis + 1) % 3), Freedom::Along((axis + 2) % 3), Freedom::About(axis)]
            }
            Self::Weld => Vec::new(),
            Self::Free => [0, 1, 2].map(Freedom::Along).into_iter().chain(turns_or_parameters).collect(),
        }
    }

    /// Keys that a joint of this kind may have in addition to those of every joint.
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

/// Components of ω by Euler parameters, in the turned frame, as formulas: 2 (ε₀ ε' − ε₀' ε − ε × ε')/|ε|². The scalar
/// ε₀ comes first.
pub fn by_euler_parameters(names: [&str; 4]) -> [String; 3] {
    let [w, x, y, z] = names;
    let length = names.map(|name| format!("{name}^2")).join(" + ");
    [(x, y, z), (y, z, x), (z, x, y)]
        .map(|(i, j, k)| format!("2*({w}*{i}' - {w}'*{i} - {j}*{k}' + {k}*{j}')/({length})"))
}

/// Components of ω after turns about body-fixed axes, in the last frame, as formulas.
///
/// Each turn's axis is expressed in the last frame by the turns after it. A frame turned by q about axis b sees the
/// unit vector e_a as e_a cos q ∓ (third axis) sin q.
pub fn angular_velocity(axes: &[usize], angles: &[&str]) -> Vec<String> {
    let mut sums: [Vec<String>; 3] = Default::default();
    for (first, (axis, angle)) in axes.iter().zip(angles).enumerate() {
        // Each part of the turn's axis as (axis, sign, factors).
        let mut parts = vec![(*axis, 1, String::new())];
        for (about, by) in axes.iter().zip(angles).skip(first + 1) {
            let turned = |(axis, sign, factors): &(usize, i32, String)| {
                if axis == about {
                    return vec![(*axis, *sign, factors.clone())];
                }
                let third = 3 - axis - about;
                // Seen from the turned frame, the axis turns back, towards axis × about.
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
    use super::angular_velocity;

    #[test]
    fn angular_velocity_of_turns_about_1_2_and_3() {
        // T. R. Kane, P. W. Likins & D. A. Levinson, Spacecraft Dynamics (1983), appendix II, body-three 1-2-3.
        let [a, b, c] = <[String; 3]>::try_from(angular_velocity(&[0, 1, 2], &["a", "b", "c"])).expect("three");
        assert_eq!(a, "+ a'*cos(b)*cos(c) + b'*sin(c)");
        assert_eq!(b, "- a'*cos(b)*sin(c) + b'*cos(c)");
        assert_eq!(c, "+ a'*sin(b) + c'");
    }
}
