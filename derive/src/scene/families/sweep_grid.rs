//! Grid of a sweep: axes such as `q2=0.01:1.5:100`, each with the values of a number of a scene, in every
//! combination.
//!
//! Invariant: the values at a point of the grid depend only on the index of the point. Evenly spaced values are
//! rounded once if both ends are exact.

use crate::algebra::Rational;
use crate::diagnostic::{Diagnostic, Diagnostics, Source, nearest_name_advice};
use crate::model::Model;
use crate::scene::numbers::number_reader::{ValueReader, VariedNumber};
use crate::scene::numbers::scene_number::Number;
use crate::scene::{InitialMotion, Scene};
use crate::toml_reader::{Located, TomlReader};

/// Largest number of points of a sweep's grid.
pub const MOST_POINTS: u64 = 1_000_000_000;

/// Advice in error messages: the forms in which an axis can be written.
const HOW: &str = "write NAME=FROM:TO:COUNT, such as q2=0.01:1.5:100, NAME=FROM:TO:COUNT:log, or a list NAME=a,b,c";

/// Grid of a sweep: every combination of the values of its axes. The last axis varies fastest.
#[derive(Clone, Debug)]
pub struct Grid {
    /// Axes of the grid, the slowest first.
    axes: Vec<Axis>,
}

/// Axis of a grid: the values of one number (parameter or start value) of a scene.
#[derive(Clone, Debug)]
struct Axis {
    /// Name of the number that varies, as the user wrote it.
    name: String,
    /// Number of the scene that varies, by its index in the model.
    place: VariedNumber,
    /// Number of values of the axis.
    count: u64,
    /// Values of the axis, as a list or by their spacing.
    values: Spacing,
}

/// Values of an axis: evenly spaced, spaced by logarithms, or a list.
#[derive(Clone, Debug)]
enum Spacing {
    /// Evenly spaced values, as (first value, last value, exact difference of neighbours). The difference is `None`
    /// if an end is not exact.
    Even(Number, Number, Option<Rational>),
    /// Values with a constant ratio of neighbours, as (first value, last value).
    Logarithmic(Number, Number),
    /// Values listed one by one.
    List(Vec<Number>),
}

impl Grid {
    /// Reads a grid, with an axis from each text, such as `q2=0:1:5`. Errors call the source of the texts `named`.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] for each wrong text. A text is wrong if it is no axis, or if its name is no parameter
    /// and no start value of the scene. It is wrong if its name has an axis already, or its count is 0. Ends must be
    /// finite and must not contain a swept parameter; with logarithmic spacing they must be positive. A further error
    /// reports a grid of more than [`MOST_POINTS`] points.
    pub fn read(texts: &[String], named: &str, scene: &Scene, model: &mut Model) -> Result<Self, Vec<Diagnostics>> {
        let sources: Vec<Source> = texts.iter().map(|text| Source::from_text(named, text)).collect();
        let (mut axes, mut errors) = (Vec::<Axis>::new(), Vec::new());
        // Names are read first, since no value may depend on a parameter that is swept itself.
        let split = |text: &str| text.find('=').unwrap_or(text.len());
        let swept = sources.iter().filter_map(|s| {
            let name = s.text[..split(&s.text)].trim();
            model.parameters.iter().position(|p| p.name == name)
        });
        let swept: Vec<usize> = swept.collect();
        let parameters = stated_parameters(scene, model).map_err(|error| vec![error])?;
        for source in &sources {
            let mut values = ValueReader::new(TomlReader::new(source), model);
            let axis = values.axis(&AxisContext { scene, parameters: &parameters, swept: &swept });
            if let Some(axis) = &axis
                && axes.iter().any(|other| other.place == axis.place)
            {
                let message = format!("`{}` is swept twice", axis.name);
                let help = "give all its values at once, as a list NAME=a,b,c if need be";
                values.reader.error(0..axis.name.len(), message, help);
            }
            match (values.reader.finish(), axis) {
                (Ok(()), Some(axis)) => axes.push(axis),
                (Err(error), _) => errors.push(error),
                (Ok(()), None) => {}
            }
        }
        let count = axes.iter().fold(1_u128, |n, axis| n.saturating_mul(u128::from(axis.count)));
        if errors.is_empty() && count > u128::from(MOST_POINTS) {
            let message = format!("the grid has {count} points, more than {MOST_POINTS}");
            let error = Diagnostic::of_file(message, "give fewer values, or sweep parts of the grid one by one");
            errors.push(Diagnostics::new(Source::from_text(named, &texts.join(" ")), vec![error]));
        }
        if errors.is_empty() { Ok(Self { axes }) } else { Err(errors) }
    }

    /// Creates a grid of one point from pairs (name, value) in SI units. Each value is taken as the shortest decimal
    /// that rounds to the double. Errors call the source of the list `named`.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] for each value that is not finite, and for each name that is no parameter and no start
    /// value of the scene.
    pub fn of_values(
        list: &[(String, f64)],
        named: &str,
        scene: &Scene,
        model: &mut Model,
    ) -> Result<Self, Vec<Diagnostics>> {
        let (mut axes, mut errors) = (Vec::new(), Vec::new());
        for (name, value) in list {
            let source = Source::from_text(named, name);
            let mut values = ValueReader::new(TomlReader::new(&source), model);
            let place = values.varied_number(name, 0..name.len(), scene);
            let decimal = Rational::shortest_decimal(*value);
            if decimal.is_none() {
                values.reader.error(0..name.len(), format!("`{name}` is {value}"), "give a finite number");
            }
            if let Err(error) = values.reader.finish() {
                errors.push(error);
            }
            axes.extend(place.zip(decimal).map(|(place, decimal)| {
                let values = Spacing::List(vec![Number::exact(decimal)]);
                Axis { name: name.clone(), place, count: 1, values }
            }));
        }
        if errors.is_empty() { Ok(Self { axes }) } else { Err(errors) }
    }

    /// Names of the varied numbers, in the order of the axes.
    #[must_use]
    pub fn names(&self) -> Vec<&str> {
        self.axes.iter().map(|axis| axis.name.as_str()).collect()
    }

    /// Warnings about angles of the grid that were probably meant in degrees, one line each. These
    /// angles exceed one turn and have at most two decimals.
    #[must_use]
    pub fn hints(&self, model: &Model) -> Vec<String> {
        let of = |axis: &Axis| {
            let VariedNumber::Coordinate(at) = axis.place else { return None };
            let ends = [axis.value(0).double, axis.value(axis.count - 1).double];
            let q = ends.into_iter().find(|q| model.coordinates[at].looks_like_degrees(*q))?;
            Some(format!("`{}` goes to {q} rad: if degrees are meant, write {q}*deg", axis.name))
        };
        self.axes.iter().filter_map(of).collect()
    }

    /// Number of points of the grid: the product of the axes' counts, at most [`MOST_POINTS`].
    #[must_use]
    pub fn count(&self) -> u64 {
        self.axes.iter().map(|axis| axis.count).product()
    }

    /// Values of the varied numbers at the grid point with the given index, in SI units and in the order of the axes.
    /// The index must be below [`Grid::count`].
    #[must_use]
    pub fn values(&self, point: u64) -> Vec<f64> {
        self.numbers(point).into_iter().map(|(_, number)| number.double).collect()
    }

    /// Varied numbers with their exact values at the grid point with the given index, in the order of the axes.
    pub(in crate::scene) fn numbers(&self, point: u64) -> Vec<(VariedNumber, Number)> {
        let mut rest = point;
        let mut list: Vec<_> = self
            .axes
            .iter()
            .rev()
            .map(|axis| {
                let value = axis.value(rest % axis.count);
                rest /= axis.count;
                (axis.place, value)
            })
            .collect();
        list.reverse();
        list
    }
}

/// Values of a scene's parameters as its file states them, exact if they are rational. Returns `Diagnostics` if the
/// file can no longer be read.
fn stated_parameters(scene: &Scene, model: &mut Model) -> Result<Vec<Number>, Diagnostics> {
    let (reader, table) = TomlReader::parse(&scene.source)?;
    let mut values = ValueReader::new(reader, model);
    let parameters = values.parameters(table.get_ref());
    values.reader.finish()?;
    Ok(parameters.expect("reported if missing"))
}

/// Scene to which an axis belongs, with the parameter values that formulas of the axis may use.
struct AxisContext<'c> {
    /// Scene whose numbers vary.
    scene: &'c Scene,
    /// Values of all parameters of the scene, as its file states them.
    parameters: &'c [Number],
    /// Indices of the parameters that the sweep varies.
    swept: &'c [usize],
}

impl Axis {
    /// Value of the axis at the index `at`, which must be below the axis' count.
    fn value(&self, at: u64) -> Number {
        let last = self.count - 1;
        match &self.values {
            Spacing::List(list) => list[usize::try_from(at).expect("below the length of a list")].clone(),
            Spacing::Even(from, _, _) | Spacing::Logarithmic(from, _) if at == 0 => from.clone(),
            Spacing::Even(_, to, _) | Spacing::Logarithmic(_, to) if at == last => to.clone(),
            Spacing::Even(from, to, step) => {
                let exact = step.as_ref().zip(from.exact.as_ref()).and_then(|(step, from)| {
                    let steps = Rational::fraction(i64::try_from(at).ok()?, 1)?;
                    Some(from.add(&step.mul(&steps)))
                });
                exact.map_or_else(
                    || Number::from_double(interpolate_ends(from.double, to.double, at, last)),
                    Number::exact,
                )
            }
            // Decimal logarithms are exact for powers of ten.
            Spacing::Logarithmic(from, to) => {
                let exponent = interpolate_ends(from.double.log10(), to.double.log10(), at, last);
                let value = 10_f64.powf(exponent);
                // Rounding must not lead out of the requested range.
                let (least, most) = (from.double.min(to.double), from.double.max(to.double));
                Number::from_double(value.clamp(least, most))
            }
        }
    }
}

/// Value between two ends, at the fraction `at`/`last` of the way. The form of the sum avoids overflow for ends of
/// any size.
fn interpolate_ends(from: f64, to: f64, at: u64, last: u64) -> f64 {
    let part = at as f64 / last as f64;
    from * (1.0 - part) + to * part
}

impl ValueReader<'_, '_> {
    /// Reads the axis `NAME=VALUES` from the source's text; `None` after an error is reported.
    fn axis(&mut self, context: &AxisContext<'_>) -> Option<Axis> {
        let text = self.reader.source.text.as_str();
        let Some(equals) = text.find('=') else {
            self.reader.error(0..text.len(), "values are missing", HOW);
            return None;
        };
        let name = text[..equals].trim();
        let place = self.varied_number(name, 0..equals, context.scene)?;
        let axis = |count, values| Some(Axis { name: name.to_owned(), place, count, values });
        match split_grid_text(text, equals + 1, ':').as_slice() {
            [_] => {
                let list = split_grid_text(text, equals + 1, ',');
                let numbers: Vec<_> = list.iter().map(|part| self.value_of(part, place, context)).collect();
                let numbers = numbers.into_iter().collect::<Option<Vec<Number>>>()?;
                axis(numbers.len() as u64, Spacing::List(numbers))
            }
            [from, to, count] => {
                let (from, to) = (self.value_of(from, place, context), self.value_of(to, place, context));
                let count = self.point_count(count);
                let (from, to, count) = (from?, to?, count?);
                axis(count, even_spacing(from, to, count))
            }
            [from, to, count, spacing] => {
                if spacing.text.trim() != "log" {
                    let message = format!("`{}` is no spacing", spacing.text.trim());
                    self.reader.error(spacing.span.clone(), message, "write `log`, or nothing for even spacing");
                    return None;
                }
                let ends = [from, to].map(|end| self.positive_end(end, place, context));
                let (count, [from, to]) = (self.point_count(count), ends);
                let (from, to, count) = (from?, to?, count?);
                axis(count, Spacing::Logarithmic(from, to))
            }
            _ => {
                self.reader.error(equals + 1..text.len(), "these are no values to sweep over", HOW);
                None
            }
        }
    }

    /// Finds the parameter or start value of a scene with the given name. `None` after reporting a name that cannot
    /// be varied.
    pub(in crate::scene) fn varied_number(
        &mut self,
        name: &str,
        span: std::ops::Range<usize>,
        scene: &Scene,
    ) -> Option<VariedNumber> {
        let model = &self.model;
        let by_rates = matches!(scene.exact.motion, InitialMotion::Rates(_));
        let rates: Vec<String> = model.coordinates.iter().map(|c| format!("{}'", c.name)).collect();
        let speed = model.speeds.iter().position(|s| s.name == name);
        let rate = rates.iter().position(|rate| rate == name);
        let found = model.parameters.iter().position(|p| p.name == name).map(VariedNumber::Parameter);
        let found =
            found.or_else(|| model.coordinates.iter().position(|c| c.name == name).map(VariedNumber::Coordinate));
        let found = found.or_else(|| rate.filter(|_| by_rates).map(VariedNumber::Rate));
        let found = found.or_else(|| speed.filter(|_| !by_rates).map(VariedNumber::Speed));
        if found.is_some() {
            return found;
        }
        let of = name.strip_suffix('\'').unwrap_or(name);
        let constraint = model.constraints.iter().find(|c| c.fixes == of);
        let (message, help) = if let Some(constraint) = constraint {
            let message = format!("`{name}` follows from the constraint `{}`", constraint.name);
            (message, "vary coordinates, rates and speeds that no constraint fixes".to_owned())
        } else if speed.is_some() || rate.is_some() {
            let stated = if by_rates { "every q'" } else { "every speed" };
            let message = format!("the start of the scene states {stated}, from which `{name}` follows");
            (message, format!("sweep the stated values, or state `{name}` and values like it in [start]"))
        } else {
            let moving = if by_rates { rates } else { model.speeds.iter().map(|s| s.name.clone()).collect() };
            let known = model.parameters.iter().map(|p| p.name.as_str());
            let known = known.chain(model.coordinates.iter().map(|c| c.name.as_str()));
            let help = nearest_name_advice(name, known.chain(moving.iter().map(String::as_str)));
            (format!("the scene has no parameter or start value `{name}`"), help)
        };
        self.reader.error(span, message, help);
        None
    }

    /// Reads an end of an axis, or a value of its list. It is a formula that a scene may state for this number.
    /// `None` after an error is reported.
    fn value_of(&mut self, text: &Located, place: VariedNumber, context: &AxisContext<'_>) -> Option<Number> {
        if matches!(place, VariedNumber::Parameter(_)) {
            return self.constant(text);
        }
        let number = self.number(text, context.parameters, "a value at the start")?;
        if let Some(at) = context.swept.iter().find(|at| self.mentions(text, **at)) {
            let message =
                format!("a value of one axis mentions `{}`, which is another", self.model.parameters[*at].name);
            let help = "give numbers; a formula in [start] of the scene follows the swept parameter";
            self.reader.error(text.span.clone(), message, help);
            return None;
        }
        Some(number)
    }

    /// Reads an end of an axis with logarithmic spacing. `None` after an error is reported, such as a value that is
    /// not above zero.
    fn positive_end(&mut self, text: &Located, place: VariedNumber, context: &AxisContext<'_>) -> Option<Number> {
        let number = self.value_of(text, place, context)?;
        if number.double <= 0.0 {
            let message = format!("{} has no logarithm", number.double);
            self.reader.error(text.span.clone(), message, "give ends above zero");
            return None;
        }
        Some(number)
    }

    /// Reads the number of values of an axis. `None` after reporting a text that is no whole number from 1 to
    /// `MOST_POINTS`.
    fn point_count(&mut self, text: &Located) -> Option<u64> {
        let count = text.text.trim().replace('_', "").parse::<u64>().ok();
        let count = count.filter(|count| (1..=MOST_POINTS).contains(count));
        if count.is_none() {
            let message = format!("`{}` is no number of values", text.text.trim());
            self.reader.error(text.span.clone(), message, format!("write a whole number from 1 to {MOST_POINTS}"));
        }
        count
    }
}

/// Splits a text at a separator, from the byte `start` on. Each part comes with its byte range.
fn split_grid_text(text: &str, mut start: usize, separator: char) -> Vec<Located> {
    let list = text[start..].split(separator);
    let located = |part: &str| {
        let part = Located { text: part.to_owned(), span: start..start + part.len(), exact: true };
        start = part.span.end + separator.len_utf8();
        part
    };
    list.map(located).collect()
}

/// Evenly spaced values of an axis. The difference of neighbours is exact if both ends are exact.
fn even_spacing(from: Number, to: Number, count: u64) -> Spacing {
    let intervals = i64::try_from(count - 1).ok().and_then(|n| Rational::fraction(n, 1)?.reciprocal());
    let step = from.exact.as_ref().zip(to.exact.as_ref()).zip(intervals);
    let step = step.map(|((from, to), intervals)| to.add(&from.neg()).mul(&intervals));
    Spacing::Even(from, to, step)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::load;

    const MODEL: &str = include_str!("../../model/pendulum.toml");
    const SCENE: &str = "span = [0, 1]\n[start]\ntheta = 1\nomega = 0\n";

    fn grid(over: &[&str]) -> Result<Grid, Vec<Diagnostics>> {
        let mut model = load(&Source::from_text("model.toml", MODEL)).unwrap();
        let scene = crate::scene::load(&Source::from_text("scene.toml", SCENE), &mut model).unwrap();
        Grid::read(&over.iter().map(|text| (*text).to_owned()).collect::<Vec<_>>(), "--over", &scene, &mut model)
    }

    fn values(over: &str) -> Vec<f64> {
        let grid = grid(&[over]).unwrap();
        (0..grid.count()).map(|at| grid.values(at)[0]).collect()
    }

    /// Goal: evenly spaced tenths and degrees are the nearest doubles to tenths and degrees. Method: comparison with
    /// literals.
    #[test]
    fn evenly_spaced_values_are_rounded_once() {
        assert_eq!(values("theta=0:1:11"), [0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0]);
        assert_eq!(values("theta=0:-0.3:4"), [0.0, -0.1, -0.2, -0.3]);
        assert_eq!(values("theta=0:180*deg:3"), [0.0, std::f64::consts::FRAC_PI_2, std::f64::consts::PI]);
        assert_eq!(values("theta=7:8:1"), [7.0]);
        assert_eq!(values("theta=-1e308:1e308:3"), [-1e308, 0.0, 1e308]);
        let roots = values("theta=sqrt(2):sqrt(g/l):3");
        assert_eq!((roots[0], roots[2]), (2.0_f64.sqrt(), 9.81_f64.sqrt()));
    }

    #[test]
    fn decades_are_powers_of_ten() {
        assert_eq!(values("l=1e-3:1e3:7:log"), [1e-3, 1e-2, 1e-1, 1.0, 1e1, 1e2, 1e3]);
        assert_eq!(values("l=1:1e-4:5:log"), [1.0, 1e-1, 1e-2, 1e-3, 1e-4]);
        let list = values("l=0.1:0.3:1000:log");
        assert!(list.windows(2).all(|w| w[0] < w[1]), "in order");
        assert_eq!((list[0], list[999]), (0.1, 0.3));
    }

    #[test]
    fn the_last_axis_varies_fastest() {
        let grid = grid(&["theta=1,2", "m=0.5", "omega=10:30:3"]).unwrap();
        assert_eq!((grid.count(), grid.names()), (6, vec!["theta", "m", "omega"]));
        let list: Vec<Vec<f64>> = (0..6).map(|at| grid.values(at)).collect();
        let expected = [[1.0, 0.5, 10.0], [1.0, 0.5, 20.0], [1.0, 0.5, 30.0], [2.0, 0.5, 10.0], [2.0, 0.5, 20.0]];
        assert_eq!(list[..5], expected.map(Vec::from));
    }

    /// Goal: wrong axes are refused. Method: for each, a part of its message and the place of its error.
    #[test]
    fn wrong_axes_are_refused_with_their_place() {
        for (over, needle, span) in [
            ("theta", "values are missing", 0..5),
            ("thta=0:1:3", "no parameter or start value `thta`", 0..4),
            ("theta'=0:1:3", "states every speed", 0..6),
            ("theta=0:1", "no values to sweep over", 6..9),
            ("theta=0:1:2:log:3", "no values to sweep over", 6..17),
            ("theta=0:1:0", "`0` is no number of values", 10..11),
            ("theta=0:1:-3", "`-3` is no number of values", 10..12),
            ("theta=0:1:1e3", "`1e3` is no number of values", 10..13),
            ("theta=0:1:2000000000", "is no number of values", 10..20),
            ("theta=0:nan:3", "`nan` cannot stand", 8..11),
            ("theta=0:1/0:3", "zero", 8..11),
            ("theta=sqrt(-1),2", "not a real number", 6..14),
            ("theta=exp(1000),2", "not a finite number", 6..15),
            ("theta=1,,2", "the expression is empty", 8..8),
            ("theta=", "the expression is empty", 6..6),
            ("l=0:1:3:log", "0 has no logarithm", 2..3),
            ("l=1:-1:3:log", "-1 has no logarithm", 4..6),
            ("l=1:2:3:lin", "`lin` is no spacing", 8..11),
            ("l=m:2:3", "`m` cannot stand in a parameter's value", 2..3),
        ] {
            let errors = grid(&[over]).expect_err(over);
            let error = &errors[0].list[0];
            assert_eq!(errors[0].list.len(), 1, "{over}: {}", errors[0]);
            assert!(error.message.contains(needle) && error.help.as_ref().is_some_and(|h| !h.is_empty()), "{error:?}");
            let found = error.span.clone().unwrap();
            assert!(found.start >= span.start && found.end <= span.end.max(found.start), "{over}: {found:?}");
        }
    }

    #[test]
    fn axes_must_not_depend_on_one_another() {
        let message = |over: &[&str]| grid(over).expect_err("refused")[0].list[0].message.clone();
        assert!(message(&["l=1:2:3", "omega=0:sqrt(g/l):3"]).contains("mentions `l`, which is another"));
        assert!(message(&["l=1:2:3", "l=5"]).contains("`l` is swept twice"));
        assert!(message(&["l=1:2:100000", "m=1:2:10001"]).contains("1000100000 points, more than 1000000000"));
        assert_eq!(grid(&["l=1:2:100000", "m=1:2:10000"]).unwrap().count(), MOST_POINTS);
        assert_eq!(grid(&["x=1", "y=2"]).expect_err("both").len(), 2, "every wrong axis is reported");
    }
}
