//! Schema of model files: their keys, with kinds of values and descriptions.

use super::Kind::{Axis, Either, Flag, Formula, List, Named, Table, Text, Vector, Word};
use super::{ABOUT, Key, Kind, VERSION, optional_key, required_key};
use crate::model::{JOINT_KINDS, SHAPE_KINDS};

/// Keys of a model file at its top level.
pub(crate) const KEYS: &[Key] = &[
    VERSION,
    required_key("name", Text, "the title of the model"),
    optional_key("source", Text, "where the problem comes from"),
    optional_key("counts", Named(&Formula), "names of whole numbers, for repeated entries"),
    optional_key("parameters", Named(&PARAMETER), "quantities that stay fixed during a motion"),
    optional_key("expressions", Named(&WITH_VALUE), "formulas that have names"),
    optional_key("coordinates", Named(&Table(&[UNIT, ABOUT])), "the configuration variables q"),
    optional_key("speeds", Named(&Formula), "the generalized speeds u, linear in the q'"),
    required_key(
        "inertial",
        Table(&[required_key("frame", Text, "the inertial frame"), required_key("origin", Text, "the fixed point")]),
        "what everything is placed from",
    ),
    optional_key("frames", Named(&FRAME), "frames, each turned from another"),
    optional_key("points", Named(&POINT), "points, each placed from another"),
    optional_key("bodies", Named(&BODY), "rigid bodies"),
    optional_key("joints", Named(&JOINT), "connections of bodies, which bring frames, coordinates and speeds"),
    optional_key("particles", Named(&PARTICLE), "what has mass at a point"),
    optional_key("gravity", GRAVITY, "the acceleration of free fall"),
    optional_key("forces", Named(&FORCE), "applied forces, N"),
    optional_key("torques", Named(&TORQUE), "applied torques, N m"),
    optional_key("springs", Named(&SPRING), "springs and dampers between two points"),
    optional_key("friction", Named(&FRICTION), "dry friction at a point or about an axis"),
    optional_key("potentials", Named(&WITH_VALUE), "energies that depend on the configuration, J"),
    optional_key("inputs", Named(&INPUT), "signals that drive loads"),
    optional_key("reactions", Named(&REACTION), "unknown forces and torques of constraints and joints"),
    optional_key("constraints", Named(&CONSTRAINT), "equations that hold at all times"),
    optional_key("assembly", Named(&Formula), "values of coordinates near which the loops are closed"),
    optional_key("rolling", Named(&ROLLING), "what does not slip at a point"),
    optional_key("domain", Named(&Formula), "strict inequalities where the model holds"),
    optional_key("shapes", Named(&SHAPE), "appearance of bodies in views; equations do not depend on it"),
    optional_key("notation", Named(&Text), "the symbols by which documents show names, such as `omega_1` or `psi'`"),
];

/// Key `unit` of a declared quantity: the unit, as a product of powers of SI units.
const UNIT: Key = required_key("unit", Text, "a product of powers of SI units, such as \"kg*m^2\"");
/// Key `frame` of an entry with a vector: the frame in which the vector's components are given.
const FRAME_OF: Key = required_key("frame", Text, "the frame of the components");
/// Key `vector` of a load: its three components.
const VECTOR: Key = required_key("vector", Vector, "the components");
/// Key `on` of a load: the body or particle on which the load acts.
const ON: Key = required_key("on", Text, "the body or particle that it acts on");
/// Key `at` of a load: its point of application.
const AT: Key = optional_key("at", Text, "point of application; by default the mass centre");
/// Key `against` of a load: the body on which the opposite load acts.
const AGAINST: Key = optional_key("against", Text, "what feels the opposite");
/// Key `against_at` of a load: the point of application of the opposite load.
const AGAINST_AT: Key = optional_key("against_at", Text, "where the opposite acts");

/// Value of an entry in the section `parameters`: a text such as a unit, or a table.
const PARAMETER: Kind = Either(&[
    Text,
    Table(&[
        optional_key("unit", Text, "its unit; a value may carry it instead"),
        optional_key("value", Formula, "the default; a scene may override it"),
        optional_key("positive", Flag, "whether it is stated to be positive"),
        ABOUT,
    ]),
]);

/// Value of a named formula: the formula alone, or a table with the key `value`.
const WITH_VALUE: Kind = Either(&[Formula, Table(&[required_key("value", Formula, "the formula"), ABOUT])]);

/// Value of an entry in the section `frames`: a table with the frame's rotation from another frame.
const FRAME: Kind = Table(&[
    required_key("from", Text, "the frame that it is turned from"),
    optional_key("axis", Either(&[Axis, Vector]), "the axis 1, 2 or 3, or a vector"),
    optional_key("angle", Formula, "the angle, rad"),
    optional_key("sequence", Text, "axes of successive turns, such as \"313\""),
    optional_key("angles", List(&Formula), "an angle for each of them"),
    optional_key("fixed", Word(&["body", "space"]), "which frame the axes of turns are of"),
    optional_key("euler_parameters", List(&Text), "four coordinates, cos θ/2 first"),
    ABOUT,
]);

/// Value of an entry in the section `points`: a table with the point's position from another point.
const POINT: Kind = Table(&[
    required_key("from", Text, "the point that it is placed from"),
    FRAME_OF,
    required_key("position", Vector, "the components, m"),
    ABOUT,
]);

/// Value of an entry in the section `bodies`: a table with frame, mass centre, mass and inertia.
const BODY: Kind = Table(&[
    optional_key("frame", Text, "frame fixed in the body; a joint brings one"),
    optional_key("centre", Text, "its mass centre; a joint brings one"),
    required_key("mass", Formula, "kg"),
    required_key(
        "inertia",
        Either(&[
            Formula,
            Table(&[
                required_key("diagonal", Vector, "moments of inertia, kg m^2"),
                optional_key("products", Vector, "entries xy, yz, zx of the tensor"),
                optional_key("frame", Text, "another frame for the components"),
                optional_key("about_point", Text, "another point than the mass centre"),
            ]),
        ]),
        "central inertia of the body; one moment is enough for a body that turns about one axis",
    ),
    optional_key(
        "added_mass",
        Table(&[
            optional_key("diagonal", List(&Formula), "six entries: kg, kg, kg, kg m^2, kg m^2, kg m^2"),
            optional_key("matrix", List(&List(&Formula)), "six rows of six entries; symmetric"),
            optional_key("about_point", Text, "another point than the mass centre"),
        ]),
        "added mass of the surrounding fluid, in the frame of the body",
    ),
    ABOUT,
]);

/// Value of a rotation in a joint: a table of successive rotations about axes.
const TURNED: Kind = Table(&[
    required_key("sequence", Text, "axes of turns that follow one another"),
    required_key("angles", List(&Formula), "an angle for each of them"),
    optional_key("fixed", Word(&["body", "space"]), "which frame the axes are of"),
]);

/// Value of a place on a body: the name of a point, or three components, m.
const PLACE: Kind = Either(&[Text, Vector]);

/// Value of an entry in the section `joints`: a table with the joint's kind, bodies, place and names.
const JOINT: Kind = Table(&[
    required_key("kind", Word(&JOINT_KINDS), "what it lets the body do"),
    required_key("body", Text, "body that the joint carries; a body placed already is tied by a loop"),
    optional_key("to", Text, "body that the joint hangs on; by default the ground"),
    optional_key("at", PLACE, "place of the joint on `to`: a point, or components"),
    optional_key("turned", TURNED, "how its axes lie on `to`"),
    optional_key("centre", Vector, "the mass centre of the body from the joint"),
    optional_key("coordinates", List(&Text), "names of its coordinates"),
    optional_key("speeds", List(&Text), "names of its speeds"),
    optional_key("body_at", PLACE, "place, on the body, of a joint that closes a loop"),
    optional_key("body_turned", TURNED, "how its axes lie there"),
    optional_key("axis", Either(&[Axis, Vector]), "its axis"),
    optional_key("axes", List(&Axis), "the two axes of a universal joint"),
    optional_key("lead", Formula, "the way of a screw in a turn, m"),
    optional_key("sequence", Text, "axes of turns, or \"euler\" for Euler parameters"),
    ABOUT,
]);

/// Value of an entry in the section `particles`: a table with point and mass.
const PARTICLE: Kind = Table(&[required_key("point", Text, "where it is"), required_key("mass", Formula, "kg"), ABOUT]);

/// Value of the section `gravity`: a table with frame, acceleration and zero of the potential.
const GRAVITY: Kind = Table(&[
    FRAME_OF,
    required_key("acceleration", Vector, "m/s^2"),
    optional_key("zero_at", Named(&Formula), "a configuration at which the potential energy is 0"),
]);

/// Value of an entry in the section `forces`: a table with places, frame and components.
const FORCE: Kind = Table(&[ON, AT, AGAINST, AGAINST_AT, FRAME_OF, VECTOR, ABOUT]);

/// Value of an entry in the section `torques`: a table with bodies, frame and components.
const TORQUE: Kind =
    Table(&[required_key("on", Text, "the rigid body or frame that it acts on"), AGAINST, FRAME_OF, VECTOR, ABOUT]);

/// Value of an entry in the section `springs`: a table with the two ends, stiffness and damping.
const SPRING: Kind = Table(&[
    ON,
    AT,
    AGAINST,
    AGAINST_AT,
    optional_key("stiffness", Formula, "N/m"),
    optional_key("free_length", Formula, "m"),
    optional_key("damping", Formula, "N s/m"),
    ABOUT,
]);

/// Value of an entry in the section `friction`: a table with bodies, place and law of the friction.
const FRICTION: Kind = Table(&[
    ON,
    AT,
    AGAINST,
    optional_key("frame", Text, "the frame of `normal` or `axis`"),
    optional_key("normal", Axis, "the axis along which nothing slips"),
    optional_key("coefficient", Formula, "of friction"),
    optional_key("normal_force", Formula, "N"),
    optional_key("axis", Axis, "about which it turns"),
    optional_key("torque", Formula, "of friction about an axis, N m"),
    optional_key("static", Formula, "the coefficient at rest, or the torque"),
    optional_key("stribeck", Formula, "the slip at which the excess at rest has fallen to 1/e"),
    required_key("smoothing", Formula, "the slip below which it is linear"),
    ABOUT,
]);

/// Value of an entry in the section `inputs`: a table with unit and value of the signal.
const INPUT: Kind = Table(&[UNIT, optional_key("value", Formula, "a number, or a formula of t, q, q' and u"), ABOUT]);

/// Value of an entry in the section `reactions`: a table with kind, places and direction.
const REACTION: Kind = Table(&[
    optional_key("kind", Word(&["force", "torque"]), "a force if it is left out"),
    ON,
    AT,
    AGAINST,
    AGAINST_AT,
    FRAME_OF,
    required_key("direction", Vector, "a unit vector"),
    ABOUT,
]);

/// Value of an entry in the section `constraints`: the text of an equation, or a table.
const CONSTRAINT: Kind = Either(&[
    Text,
    Table(&[
        required_key("equation", Text, "between coordinates, or linear in velocities"),
        optional_key("enforced_by", Text, "the reaction that enforces it"),
        ABOUT,
    ]),
]);

/// Value of an entry in the section `rolling`: a table with the bodies, the point of contact and the frame.
const ROLLING: Kind = Table(&[
    required_key("body", Text, "the rigid body that rolls"),
    required_key("at", Text, "the point of contact"),
    optional_key("against", Text, "rigid body on which the wheel rolls; by default the ground"),
    optional_key("frame", Text, "the frame whose components make the constraints"),
    ABOUT,
]);

/// Value of an entry in the section `shapes`: a table with the shape's kind, place and lengths.
const SHAPE: Kind = Table(&[
    required_key("kind", Word(&SHAPE_KINDS), "what it is like"),
    optional_key("body", Text, "body that the shape belongs to; it gives frame, mass centre and colour"),
    optional_key("frame", Text, "the frame that it is fixed in"),
    optional_key("at", Text, "the point that its middle is told from"),
    optional_key("position", Vector, "where its middle is from there, m"),
    optional_key("axis", Axis, "its axis, 3 if it is left out"),
    optional_key("radius", Formula, "m"),
    optional_key("length", Formula, "of a cylinder, m"),
    optional_key("thickness", Formula, "of a disk, m"),
    optional_key("size", Vector, "three edges of a box, m"),
    optional_key("through", List(&Text), "the points of a line, one after the other"),
    ABOUT,
]);
