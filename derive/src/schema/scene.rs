//! Schema of scene files and state files: their keys, with kinds and descriptions.

use super::Kind::{Either, Flag, Formula, List, Named, Table, Text, Whole, Word};
use super::{ABOUT, Key, Kind, VERSION, key, needed};
use crate::scene::{FIGURES, ImpactLaw, Integrator, SOLVES};

/// Key `model`, the path of the model file.
const MODEL: Key = key("model", Text, "path of the model file, relative to this file; by default ../model.toml");
/// Key `title` of a scene or state.
const TITLE: Key = key("title", Text, "a title for the page");
/// Key `parameters`, the values of parameters.
const PARAMETERS: Key = key("parameters", NUMBERS, "values that differ from the model's defaults");
/// Key `inputs`, the signals of the model's inputs.
const INPUTS: Key = key("inputs", Named(&INPUT), "what the model's inputs are");
/// Key `outputs`, the quantities to show.
const OUTPUTS: Key = key("outputs", List(&OUTPUT), "what to show");
/// Key `free`, the parameters that stay symbols in the reduced equations.
const FREE: Key = key("free", List(&Text), "parameters that stay letters in the scene's reduced equations");
/// Key `ladder`, further values of a number of the start.
const LADDER: Key = key("ladder", Named(&List(&Formula)), "other values of one number of the start");
/// Key `span`, the first and the last instant of a run.
const SPAN: Key = key("span", List(&Formula), "first and last instant, s");
/// Key `integration`, the settings of the integrator.
const INTEGRATION: Key = key("integration", Table(INTEGRATION_KEYS), "how to integrate");
/// Key `events`, the events of a run.
const EVENTS: Key = key("events", List(&Table(EVENT)), "what to notice");
/// Key `impacts`, the contacts of bodies that can meet.
const IMPACTS: Key = key("impacts", Named(&Table(IMPACT)), "contacts, where bodies meet");
/// Key `figures`, the figures of the page.
const FIGURE_LIST: Key = key("figures", List(&Table(FIGURE)), "figures of the page");
/// Schema of a table of formulas by name.
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
    needed("start", NUMBERS, "every coordinate, and every speed or every q'"),
    key("guess", NUMBERS, "guesses of the coordinates that close the loops"),
    LADDER,
    Key { is_needed: true, ..SPAN },
    INTEGRATION,
    OUTPUTS,
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
    key("source", Text, "where the numbers come from"),
    key("names", NUMBERS, "numbers that the file names for itself"),
    PARAMETERS,
    INPUTS,
    key("state", NUMBERS, "every coordinate, and every speed or every q', that is held"),
    key("start", NUMBERS, "the same, of a scene"),
    key("guess", NUMBERS, "values near those of what is sought"),
    OUTPUTS,
    FREE,
    LADDER,
    SPAN,
    INTEGRATION,
    IMPACTS,
    EVENTS,
    FIGURE_LIST,
];

/// Schema of an entry of `inputs`: a formula, or a column of a CSV file.
const INPUT: Kind = Either(&[
    Formula,
    Table(&[
        needed("table", Text, "a CSV file"),
        key("time", Text, "the column of the instants"),
        key("column", Text, "the column of the values"),
        key("interpolation", Word(&["linear", "cubic"]), "between rows"),
    ]),
]);

/// Schema of an entry of `outputs`: a name, or a name with its formula.
const OUTPUT: Kind =
    Either(&[Text, Table(&[needed("name", Text, "what it is called"), needed("value", Formula, "the formula")])]);

/// Keys of the table `integration`.
const INTEGRATION_KEYS: &[Key] = &[
    key("method", Word(&Integrator::NAMES), "the method"),
    key("solve", Word(&SOLVES), "how accelerations are found"),
    key("rtol", Formula, "relative tolerance"),
    key("atol", Either(&[Formula, NUMBERS]), "absolute tolerance: one, or by coordinate and speed"),
    key("step", Formula, "the length of every step, s"),
    key("max_step", Formula, "the longest step, s"),
    key("step_limit", Whole(1), "largest number of attempted steps of a run"),
    key("samples", Whole(2), "number of equally spaced samples"),
    key("domain", Word(&["stop", "watch"]), "whether leaving the domain ends the run"),
    key("project", Word(&["energy"]), "what each step is moved back onto"),
    key("distance", Either(&[Word(&["none"]), NUMBERS]), "coordinate whose distance from a right angle is integrated"),
];

/// Keys of an entry of `impacts`.
const IMPACT: &[Key] = &[
    needed("gap", Formula, "gap, m: positive if the bodies are apart, 0 if they touch"),
    needed("restitution", Formula, "from 0 to 1"),
    key("law", Word(&ImpactLaw::NAMES), "Newton's law or Poisson's"),
    key("no_slip", List(&Formula), "velocities along the contact that are 0 while the contact is closed"),
    key("friction", Formula, "the coefficient of Coulomb friction, 0 or more"),
    key("along", Formula, "the velocity at which a contact with friction slips, m/s"),
    ABOUT,
];

/// Keys of an entry of `events`.
const EVENT: &[Key] = &[
    needed("name", Text, "how it is reported"),
    needed("zero", Formula, "it is where this crosses zero"),
    key("direction", Word(&["rising", "falling", "either"]), "which crossings count"),
    key("terminal", Flag, "whether it ends the run"),
    ABOUT,
];

/// Keys of an entry of `figures`.
const FIGURE: &[Key] = &[needed("kind", Word(&FIGURES), "what is drawn"), key("caption", Text, "its text")];
