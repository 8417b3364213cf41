//! Marks for a submission by its root mistakes: an entry that is wrong only because of an earlier mistake loses no
//! points.

use super::{Difference, Finding, Judgement, MistakeKind, RootMistake};
use crate::diagnostic::{Diagnostics, Source, nearest_name_advice, shortened_for_message};
use crate::toml_reader::TomlReader;
use toml::Spanned;
use toml::de::DeValue;

/// Amount of detail in the feedback on a mistake.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FeedbackLevel {
    /// Names the entry and the kind of its mistake.
    #[default]
    Hint,
    /// Names the entry, the kind of its mistake, and the place within the entry, such as "the right-hand side".
    Place,
    /// Names the entry and shows the wrong term with the right term of the mistake.
    Term,
}

impl FeedbackLevel {
    /// All levels, each with its name in rubrics and on the command line.
    pub const ALL: [(Self, &'static str); 3] = [(Self::Hint, "hint"), (Self::Place, "place"), (Self::Term, "term")];

    /// Returns the level with the name `name`; `None` for an unknown name.
    #[must_use]
    pub fn feedback_level_by_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|(_, own)| *own == name).map(|(level, _)| level)
    }
}

/// Rubric for marking: points of each entry, ids of required entries, and the feedback level.
#[derive(Clone, Debug, PartialEq)]
pub struct Rubric {
    /// Points for an entry that is not in the list `points`.
    pub default: f64,
    /// Pairs of an entry's id and its points.
    pub points: Vec<(String, f64)>,
    /// Ids of entries that a submission must have.
    pub required: Vec<String>,
    /// Amount of detail in feedback; `None` if the rubric does not state a level.
    pub level: Option<FeedbackLevel>,
}

impl Default for Rubric {
    fn default() -> Self {
        Self { default: 1.0, points: Vec::new(), required: Vec::new(), level: None }
    }
}

/// Largest number of points that a rubric may give to one entry.
const MOST_POINTS: f64 = 1e6;

impl Rubric {
    /// Reads a rubric from a TOML file with the keys `default`, `points`, `required` and `level`.
    ///
    /// # Errors
    /// [`Diagnostics`] with every error of the file.
    pub fn load(source: &Source) -> Result<Self, Diagnostics> {
        let (mut reader, table) = TomlReader::parse(source)?;
        let table = table.get_ref();
        reader.report_unknown_keys(table, "a rubric", &["default", "points", "required", "level"]);
        let mut rubric = Self::default();
        if let Some(value) = reader.get(table, "default") {
            rubric.default = read_rubric_points(&mut reader, value, "`default`").unwrap_or(1.0);
        }
        let list = reader.get(table, "points");
        let example = "[points] with lines such as row1 = 2";
        if let Some(list) = list.and_then(|value| reader.table(value, "`points`", example)) {
            for (id, value) in reader.entries(list) {
                let found = read_rubric_points(&mut reader, value, &format!("`{}`", shortened_for_message(&id.text)));
                rubric.points.extend(found.map(|points| (id.text, points)));
            }
        }
        if let Some(value) = reader.get(table, "required") {
            if let DeValue::Array(list) = value.get_ref() {
                for value in list {
                    rubric.required.extend(reader.string(value, "an id").map(|id| id.text));
                }
            } else {
                reader.error(value.span(), "`required` must be a list of ids", "write required = [\"row1\"]");
            }
        }
        let name = reader.get(table, "level");
        if let Some(name) = name.and_then(|value| reader.string(value, "`level`")) {
            rubric.level = FeedbackLevel::feedback_level_by_name(&name.text);
            if rubric.level.is_none() {
                let help = nearest_name_advice(&name.text, FeedbackLevel::ALL.map(|(_, name)| name));
                reader.error(name.span, format!("there is no level `{}`", shortened_for_message(&name.text)), help);
            }
        }
        reader.finish()?;
        Ok(rubric)
    }

    /// Points for the entry with the id `id`: its own points if the rubric gives any, else the default.
    #[must_use]
    pub fn points_of(&self, id: &str) -> f64 {
        self.points.iter().find(|(own, _)| own == id).map_or(self.default, |(_, points)| *points)
    }
}

/// Reads a number of points from 0 to 1 000 000; reports an error and returns `None` for any other
/// value.
fn read_rubric_points(reader: &mut TomlReader<'_>, value: &Spanned<DeValue<'_>>, what: &str) -> Option<f64> {
    let number = match value.get_ref() {
        DeValue::Integer(n) => n.as_str().parse::<f64>().ok(),
        DeValue::Float(n) => n.as_str().parse::<f64>().ok(),
        _ => None,
    };
    let number = number.filter(|n| (0.0..=MOST_POINTS).contains(n));
    if number.is_none() {
        let message = format!("{what} must be a number of points, from 0 to {MOST_POINTS}");
        reader.error(value.span(), message, "write points as in row1 = 2");
    }
    number
}

/// Marks of a whole submission: its points and the marks of its entries.
#[derive(Clone, Debug, PartialEq)]
pub struct Grade {
    /// Points that the submission earned.
    pub points: f64,
    /// Largest number of points that the submission could earn.
    pub of: f64,
    /// Marks of the entries in the order of the submission, followed by marks of required entries that it lacks.
    pub marks: Vec<Mark>,
}

/// Marks of one entry of a submission.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Id of the marked entry.
    pub id: String,
    /// Points that the entry earned.
    pub points: f64,
    /// Largest number of points that the entry could earn.
    pub of: f64,
    /// Reason for the points: right, wrong, consequence of an earlier mistake, undecided, or
    /// lacking.
    pub outcome: Outcome,
}

/// Outcome of one entry of a submission.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// The entry is right; full points.
    Right,
    /// The entry is wrong by a mistake of its own; no points.
    Mistake(Feedback),
    /// The entry is wrong only because of a mistake in an earlier entry, whose id is given; full
    /// points.
    Follows(String),
    /// The entry is proved neither right nor wrong, for the given reason; full points, and a person must look at it.
    Undecided(String),
    /// The rubric requires the entry, and the submission lacks it; no points.
    Lacking,
}

/// Feedback on one mistake: its kind, its places, and the wrong and right terms.
#[derive(Clone, Debug, PartialEq)]
pub struct Feedback {
    /// Kind of the mistake; `None` if no single slip explains it.
    pub slip: Option<MistakeKind>,
    /// Places of the mistake within the entry, such as "the right-hand side"; empty for an entry
    /// without parts.
    pub places: Vec<String>,
    /// Wrong terms with the right terms, as text.
    pub term: String,
}

impl Feedback {
    /// Creates the feedback on the root mistake `root`, found in the entry of `finding`.
    fn new(finding: &Finding, root: &RootMistake) -> Self {
        Self { slip: finding.slip, places: finding.places.clone(), term: root.mistake.clone() }
    }

    /// Text of the feedback, with as much detail as `level` allows.
    #[must_use]
    pub fn words(&self, level: FeedbackLevel) -> String {
        if level == FeedbackLevel::Term {
            return self.term.clone();
        }
        let kind = self.slip.map_or_else(|| "it is not right".to_owned(), |slip| format!("look for {}", slip.words()));
        if level == FeedbackLevel::Hint || self.places.is_empty() {
            return kind;
        }
        format!("{kind} in {}", self.places.join(" and "))
    }
}

/// Computes the marks of a submission from its comparison with the derived equations.
#[must_use]
pub fn grade(difference: &Difference, rubric: &Rubric) -> Grade {
    let mut marks = Vec::new();
    for (at, finding) in difference.findings.iter().enumerate() {
        let outcome = match &finding.judgement {
            Judgement::Stated => continue,
            Judgement::Equal | Judgement::Scaled => Outcome::Right,
            Judgement::Undecided(why) => Outcome::Undecided(why.clone()),
            Judgement::Different => grade_wrong_entry(difference, at),
        };
        let of = rubric.points_of(&finding.id);
        let points = if matches!(outcome, Outcome::Mistake(_)) { 0.0 } else { of };
        marks.push(Mark { id: finding.id.clone(), points, of, outcome });
    }
    for id in &rubric.required {
        if difference.findings.iter().all(|finding| finding.id != *id) {
            marks.push(Mark { id: id.clone(), points: 0.0, of: rubric.points_of(id), outcome: Outcome::Lacking });
        }
    }
    let sum = |of: fn(&Mark) -> f64| marks.iter().map(of).sum::<f64>();
    Grade { points: sum(|mark| mark.points), of: sum(|mark| mark.of), marks }
}

/// Outcome of the wrong entry with the index `at`: a mistake of its own, or a consequence of an earlier mistake.
fn grade_wrong_entry(difference: &Difference, at: usize) -> Outcome {
    for root in &difference.roots {
        if root.finding == at {
            return Outcome::Mistake(Feedback::new(&difference.findings[at], root));
        }
        if root.followers.iter().any(|follower| follower.finding == at) {
            return Outcome::Follows(difference.findings[root.finding].id.clone());
        }
    }
    unreachable!("each wrong entry is in one group")
}
