//! Schema of a model file: its keys, with kinds and descriptions.

use super::Kind::{Axis, Either, Flag, Formula, List, Named, Table, Text, Vector, Word};
use super::{ABOUT, Key, Kind, VERSION, key, needed};
use crate::model::{JOINT_KINDS, SHAPE_KINDS};

/// Keys of a model file at its top level.
pub(crate) const KEYS: &[Key] = &[
    VERSION,
    needed("name", Text, "the title of the model"),
    key("source", Text, "where the problem comes from"),
    key("counts", Named(&Formula), "names of whole numbers, for repeated entries"),
    key("parameters", Named(&PARAMETER), "quantities that stay fixed during a motion"),
    key("expressions", Named(&WITH_VALUE), "formulas that have names"),
    key("coordinates", Named(&Table(&[UNIT, ABOUT])), "the configuration variables q"),
    key("speeds", Named(&Formula), "the generalized speeds u, linear in the q'"),
    needed(
        "inertial",
        Table(&[needed("frame", Text, "the inertial frame"), needed("origin", Text, "the fixed point")]),
        "what everything is placed from",
    ),
    key("frames", Named(&FRAME), "frames, each turned from another"),
    key("points", Named(&POINT), "points, each placed from another"),
    key("bodies", Named(&BODY), "rigid bodies"),
    key("joints", Named(&JOINT), "connections of bodies, which bring frames, coordinates and speeds"),
    key("particles", Named(&PARTICLE), "what has mass at a point"),
    key("gravity", GRAVITY, "the acceleration of free fall"),
    key("forces", Named(&FORCE), "applied forces, N"),
    key("torques", Named(&TORQUE), "applied torques, N m"),
    key("springs", Named(&SPRING), "springs and dampers between two points"),
    key("friction", Named(&FRICTION), "dry friction at a point or about an axis"),
    key("potentials", Named(&WITH_VALUE), "energies that depend on the configuration, J"),
    key("inputs", Named(&INPUT), "signals that drive loads"),
    key("reactions", Named(&REACTION), "unknown forces and torques of constraints and joints"),
    key("constraints", Named(&CONSTRAINT), "equations that hold at all times"),
    key("rolling", Named(&ROLLING), "what does not slip at a point"),
    key("domain", Named(&Formula), "strict inequalities where the model holds"),
    key("shapes", Named(&SHAPE), "appearance of bodies in views; equations do not depend on it"),
    key("notation", Named(&Text), "the symbols by which documents show names, such as `omega_1` or `psi'`"),
];

/// Key `unit` of a declared quantity.
const UNIT: Key = needed("unit", Text, "a product of powers of SI units, such as \"kg*m^2\"");
/// Key `frame`, the frame in which a vector's components are given.
const FRAME_OF: Key = needed("frame", Text, "the frame of the components");
/// Key `vector`, the three components of a load.
const VECTOR: Key = needed("vector", Vector, "the components");
/// Key `on`, the body or particle on which a load acts.
const ON: Key = needed("on", Text, "the body or particle that it acts on");
/// Key `at`, the point of application of a load.
const AT: Key = key("at", Text, "point of application; by default the mass centre");
/// Key `against`, the body that feels the opposite load.
const AGAINST: Key = key("against", Text, "what feels the opposite");
/// Key `against_at`, the point of application of the opposite load.
const AGAINST_AT: Key = key("against_at", Text, "where the opposite acts");

/// Schema of an entry of `parameters`: a unit, or a table.
const PARAMETER: Kind = Either(&[
    Text,
    Table(&[
        key("unit", Text, "its unit; a value may carry it instead"),
        key("value", Formula, "the default; a scene may override it"),
        key("positive", Flag, "whether it is stated to be positive"),
        ABOUT,
    ]),
]);

/// Schema of a named formula: the formula alone, or a table with the key `value`.
const WITH_VALUE: Kind = Either(&[Formula, Table(&[needed("value", Formula, "the formula"), ABOUT])]);

/// Schema of an entry of `frames`.
const FRAME: Kind = Table(&[
    needed("from", Text, "the frame that it is turned from"),
    key("axis", Either(&[Axis, Vector]), "the axis 1, 2 or 3, or a vector"),
    key("angle", Formula, "the angle, rad"),
    key("sequence", Text, "axes of successive turns, such as \"313\""),
    key("angles", List(&Formula), "an angle for each of them"),
    key("fixed", Word(&["body", "space"]), "which frame the axes of turns are of"),
    key("euler_parameters", List(&Text), "four coordinates, cos θ/2 first"),
    ABOUT,
]);

/// Schema of an entry of `points`.
const POINT: Kind = Table(&[
    needed("from", Text, "the point that it is placed from"),
    FRAME_OF,
    needed("position", Vector, "the components, m"),
    ABOUT,
]);

/// Schema of an entry of `bodies`.
const BODY: Kind = Table(&[
    key("frame", Text, "frame fixed in the body; a joint brings one"),
    key("centre", Text, "its mass centre; a joint brings one"),
    needed("mass", Formula, "kg"),
    needed(
        "inertia",
        Either(&[
            Formula,
            Table(&[
                needed("diagonal", Vector, "moments of inertia, kg m^2"),
                key("products", Vector, "entries xy, yz, zx of the tensor"),
                key("frame", Text, "another frame for the components"),
                key("about_point", Text, "another point than the mass centre"),
            ]),
        ]),
        "central inertia of the body; one moment is enough for a body that turns about one axis",
    ),
    key(
        "added_mass",
        Table(&[
            key("diagonal", List(&Formula), "six entries: kg, kg, kg, kg m^2, kg m^2, kg m^2"),
            key("matrix", List(&List(&Formula)), "six rows of six entries; symmetric"),
            key("about_point", Text, "another point than the mass centre"),
        ]),
        "added mass of the surrounding fluid, in the frame of the body",
    ),
    ABOUT,
]);

/// Schema of a rotation given by successive turns about axes, in a joint.
const TURNED: Kind = Table(&[
    needed("sequence", Text, "axes of turns that follow one another"),
    needed("angles", List(&Formula), "an angle for each of them"),
    key("fixed", Word(&["body", "space"]), "which frame the axes are of"),
]);

/// Schema of a place on a body: the name of a point, or three components, m.
const PLACE: Kind = Either(&[Text, Vector]);

/// Schema of an entry of `joints`.
const JOINT: Kind = Table(&[
    needed("kind", Word(&JOINT_KINDS), "what it lets the body do"),
    needed("body", Text, "body that the joint carries; a body placed already is tied by a loop"),
    key("to", Text, "body that the joint hangs on; by default the ground"),
    key("at", PLACE, "place of the joint on `to`: a point, or components"),
    key("turned", TURNED, "how its axes lie on `to`"),
    key("centre", Vector, "the mass centre of the body from the joint"),
    key("coordinates", List(&Text), "names of its coordinates"),
    key("speeds", List(&Text), "names of its speeds"),
    key("body_at", PLACE, "place, on the body, of a joint that closes a loop"),
    key("body_turned", TURNED, "how its axes lie there"),
    key("axis", Either(&[Axis, Vector]), "its axis"),
    key("axes", List(&Axis), "the two axes of a universal joint"),
    key("lead", Formula, "the way of a screw in a turn, m"),
    key("sequence", Text, "axes of turns, or \"euler\" for Euler parameters"),
    ABOUT,
]);

/// Schema of an entry of `particles`.
const PARTICLE: Kind = Table(&[needed("point", Text, "where it is"), needed("mass", Formula, "kg"), ABOUT]);

/// Schema of the table `gravity`.
const GRAVITY: Kind = Table(&[
    FRAME_OF,
    needed("acceleration", Vector, "m/s^2"),
    key("zero_at", Named(&Formula), "a configuration at which the potential energy is 0"),
]);

/// Schema of an entry of `forces`.
const FORCE: Kind = Table(&[ON, AT, AGAINST, AGAINST_AT, FRAME_OF, VECTOR, ABOUT]);

/// Schema of an entry of `torques`.
const TORQUE: Kind =
    Table(&[needed("on", Text, "the rigid body or frame that it acts on"), AGAINST, FRAME_OF, VECTOR, ABOUT]);

/// Schema of an entry of `springs`.
const SPRING: Kind = Table(&[
    ON,
    AT,
    AGAINST,
    AGAINST_AT,
    key("stiffness", Formula, "N/m"),
    key("free_length", Formula, "m"),
    key("damping", Formula, "N s/m"),
    ABOUT,
]);

/// Schema of an entry of `friction`.
const FRICTION: Kind = Table(&[
    ON,
    AT,
    AGAINST,
    key("frame", Text, "the frame of `normal` or `axis`"),
    key("normal", Axis, "the axis along which nothing slips"),
    key("coefficient", Formula, "of friction"),
    key("normal_force", Formula, "N"),
    key("axis", Axis, "about which it turns"),
    key("torque", Formula, "of friction about an axis, N m"),
    key("static", Formula, "the coefficient at rest, or the torque"),
    key("stribeck", Formula, "the slip at which the excess at rest has fallen to 1/e"),
    needed("smoothing", Formula, "the slip below which it is linear"),
    ABOUT,
]);

/// Schema of an entry of `inputs`.
const INPUT: Kind = Table(&[UNIT, key("value", Formula, "a number, or a formula of t, q, q' and u"), ABOUT]);

/// Schema of an entry of `reactions`.
const REACTION: Kind = Table(&[
    key("kind", Word(&["force", "torque"]), "a force if it is left out"),
    ON,
    AT,
    AGAINST,
    AGAINST_AT,
    FRAME_OF,
    needed("direction", Vector, "a unit vector"),
    ABOUT,
]);

/// Schema of an entry of `constraints`: the text of an equation, or a table.
const CONSTRAINT: Kind = Either(&[
    Text,
    Table(&[
        needed("equation", Text, "between coordinates, or linear in velocities"),
        key("enforced_by", Text, "the reaction that enforces it"),
        ABOUT,
    ]),
]);

/// Schema of an entry of `rolling`.
const ROLLING: Kind = Table(&[
    needed("body", Text, "the rigid body that rolls"),
    needed("at", Text, "the point of contact"),
    key("against", Text, "rigid body on which the wheel rolls; by default the ground"),
    key("frame", Text, "the frame whose components make the constraints"),
    ABOUT,
]);

/// Schema of an entry of `shapes`.
const SHAPE: Kind = Table(&[
    needed("kind", Word(&SHAPE_KINDS), "what it is like"),
    key("body", Text, "body that the shape belongs to; it gives frame, mass centre and colour"),
    key("frame", Text, "the frame that it is fixed in"),
    key("at", Text, "the point that its middle is told from"),
    key("position", Vector, "where its middle is from there, m"),
    key("axis", Axis, "its axis, 3 if it is left out"),
    key("radius", Formula, "m"),
    key("length", Formula, "of a cylinder, m"),
    key("thickness", Formula, "of a disk, m"),
    key("size", Vector, "three edges of a box, m"),
    key("through", List(&Text), "the points of a line, one after the other"),
    ABOUT,
]);
