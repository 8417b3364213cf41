//! Schema of scene files and state files: their keys, with kinds of values and descriptions.

use super::Kind::{Either, Flag, Formula, List, Named, Table, Text, Whole, Word};
use super::{ABOUT, Key, Kind, VERSION, optional_key, required_key};
use crate::scene::{FIGURES, ImpactLaw, Integrator, SOLVES};

/// Key `model` of a scene or state: the path of the model file.
const MODEL: Key =
    optional_key("model", Text, "path of the model file, relative to this file; by default ../model.toml");
/// Key `title` of a scene or state: a title for the page.
const TITLE: Key = optional_key("title", Text, "a title for the page");
/// Key `parameters` of a scene or state: the values of parameters.
const PARAMETERS: Key = optional_key("parameters", NUMBERS, "values that differ from the model's defaults");
/// Key `inputs` of a scene or state: the signals of the model's inputs.
const INPUTS: Key = optional_key("inputs", Named(&INPUT), "what the model's inputs are");
/// Key `outputs` of a scene or state: the quantities to show.
const OUTPUTS: Key = optional_key("outputs", List(&OUTPUT), "what to show");
/// Key `free` of a scene: the parameters that stay symbols in the reduced equations.
const FREE: Key = optional_key("free", List(&Text), "parameters that stay letters in the scene's reduced equations");
/// Key `ladder` of a scene: further values of a single number of the start.
const LADDER: Key = optional_key("ladder", Named(&List(&Formula)), "other values of one number of the start");
/// Key `span` of a scene: the first and the last instant of a run, s.
const SPAN: Key = optional_key("span", List(&Formula), "first and last instant, s");
/// Key `integration` of a scene: the settings of the integrator.
const INTEGRATION: Key = optional_key("integration", Table(INTEGRATION_KEYS), "how to integrate");
/// Key `events` of a scene: the events that a run detects.
const EVENTS: Key = optional_key("events", List(&Table(EVENT)), "what to notice");
/// Key `claims` of a scene: what rigorous runs prove or refute.
const CLAIMS: Key = optional_key("claims", List(&Table(CLAIM)), "what rigorous runs prove or refute");
/// Key `impacts` of a scene: the contacts of bodies that can meet.
const IMPACTS: Key = optional_key("impacts", Named(&Table(IMPACT)), "contacts, where bodies meet");
/// Key `figures` of a scene: the figures of the page.
const FIGURE_LIST: Key = optional_key("figures", List(&Table(FIGURE)), "figures of the page");
/// Value that is a table of formulas by name.
const NUMBERS: Kind = Named(&Formula);

/// Keys of a scene file at its top level.
pub(crate) const KEYS: &[Key] = &[
    VERSION,
    MODEL,
    TITLE,
    ABOUT,
    PARAMETERS,
    INPUTS,
    FREE,
    required_key("start", NUMBERS, "every coordinate, and every speed or every q'"),
    optional_key("guess", NUMBERS, "guesses of the coordinates that close the loops"),
    LADDER,
    Key { is_needed: true, ..SPAN },
    INTEGRATION,
    OUTPUTS,
    CLAIMS,
    IMPACTS,
    EVENTS,
    FIGURE_LIST,
];

/// Keys of a state file at its top level. They include all keys of a scene file, since a scene file
/// may be read as a state.
pub(crate) const STATE_KEYS: &[Key] = &[
    VERSION,
    MODEL,
    TITLE,
    ABOUT,
    optional_key("source", Text, "where the numbers come from"),
    optional_key("names", NUMBERS, "numbers that the file names for itself"),
    PARAMETERS,
    INPUTS,
    optional_key("state", NUMBERS, "every coordinate, and every speed or every q', that is held"),
    optional_key("start", NUMBERS, "the same, of a scene"),
    optional_key("guess", NUMBERS, "values near those of what is sought"),
    OUTPUTS,
    FREE,
    LADDER,
    SPAN,
    INTEGRATION,
    CLAIMS,
    IMPACTS,
    EVENTS,
    FIGURE_LIST,
];

/// Value of an entry in the section `inputs`: a formula, or a column of a CSV file.
const INPUT: Kind = Either(&[
    Formula,
    Table(&[
        required_key("table", Text, "a CSV file"),
        optional_key("time", Text, "the column of the instants"),
        optional_key("column", Text, "the column of the values"),
        optional_key("interpolation", Word(&["linear", "cubic"]), "between rows"),
    ]),
]);

/// Value of an entry in the list `outputs`: a name, or a name with its formula.
const OUTPUT: Kind = Either(&[
    Text,
    Table(&[required_key("name", Text, "what it is called"), required_key("value", Formula, "the formula")]),
]);

/// Keys of the section `integration` of a scene.
const INTEGRATION_KEYS: &[Key] = &[
    optional_key("method", Word(&Integrator::NAMES), "the method"),
    optional_key("solve", Word(&SOLVES), "how accelerations are found"),
    optional_key("rtol", Formula, "relative tolerance"),
    optional_key("atol", Either(&[Formula, NUMBERS]), "absolute tolerance: one, or by coordinate and speed"),
    optional_key("step", Formula, "the length of every step, s"),
    optional_key("max_step", Formula, "the longest step, s"),
    optional_key("step_limit", Whole(1), "largest number of attempted steps of a run"),
    optional_key("samples", Whole(2), "number of equally spaced samples"),
    optional_key("domain", Word(&["stop", "watch"]), "whether leaving the domain ends the run"),
    optional_key("project", Word(&["energy"]), "what each step is moved back onto"),
    optional_key(
        "distance",
        Either(&[Word(&["none"]), NUMBERS]),
        "coordinate whose distance from a right angle is integrated",
    ),
];

/// Keys of an entry in the section `impacts` of a scene: a contact of two bodies.
const IMPACT: &[Key] = &[
    required_key("gap", Formula, "gap, m: positive if the bodies are apart, 0 if they touch"),
    required_key("restitution", Formula, "from 0 to 1"),
    optional_key("law", Word(&ImpactLaw::NAMES), "Newton's law or Poisson's"),
    optional_key("no_slip", List(&Formula), "velocities along the contact that are 0 while the contact is closed"),
    optional_key("friction", Formula, "the coefficient of Coulomb friction, 0 or more"),
    optional_key("along", Formula, "the velocity at which a contact with friction slips, m/s"),
    ABOUT,
];

/// Keys of an entry in the list `claims` of a scene.
const CLAIM: &[Key] = &[
    required_key("claim", Text, "FORMULA < FORMULA or FORMULA > FORMULA, at all instants"),
    optional_key("by", Text, "the equations whose motion is meant, such as kane or printed:ID"),
    optional_key("printed", Text, "the words of a publication on which the claim decides"),
    ABOUT,
];

/// Keys of an entry in the list `events` of a scene.
const EVENT: &[Key] = &[
    required_key("name", Text, "how it is reported"),
    required_key("zero", Formula, "it is where this crosses zero"),
    optional_key("direction", Word(&["rising", "falling", "either"]), "which crossings count"),
    optional_key("terminal", Flag, "whether it ends the run"),
    ABOUT,
];

/// Keys of an entry in the list `figures` of a scene.
const FIGURE: &[Key] =
    &[required_key("kind", Word(&FIGURES), "what is drawn"), optional_key("caption", Text, "its text")];
