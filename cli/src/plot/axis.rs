//! Axes of a panel with readable ticks, and labels with units and powers of ten.
//!
//! Invariant: no tick shows a rounding error. A tick is a whole number times a power of ten,
//! printed with the digits of that power.

use super::{Scale, figure_text_in_symbols};

/// Axis of a panel. It shows values minus `offset`, or decimal logarithms of values, from `low` to `high`.
pub struct Axis {
    /// Kind of the axis: linear or logarithmic.
    scale: Scale,
    /// Number that is subtracted from the values on a linear axis; usually 0.
    offset: f64,
    /// Lower end of the axis: a value minus `offset`, or a decimal logarithm.
    low: f64,
    /// Upper end of the axis: a value minus `offset`, or a decimal logarithm.
    high: f64,
    /// Ticks of the axis: position from 0 (lower end) to 1 (upper end), and text.
    pub ticks: Vec<(f64, String)>,
    /// Label of the axis with its unit. It includes a subtracted offset and a power of ten.
    pub label: String,
}

impl Axis {
    /// Returns a linear axis for `values` with about `count` ticks. `margin` is added at both ends, as a fraction of
    /// the range of the values.
    pub fn new(values: impl Iterator<Item = f64>, label: &str, margin: f64, count: f64) -> Self {
        let (min, max) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        let (min, max) = if min <= max { (min, max) } else { (0.0, 1.0) };
        let size = min.abs().max(max.abs());
        let range = max - min;
        // Differences of a few rounding errors are drawn as a flat curve, so that they are not magnified.
        let flat = range <= 8.0 * f64::EPSILON * size || range < 1e-290;
        let offset = if !flat && range < 1e-4 * size { short_offset(f64::midpoint(min, max), range) } else { 0.0 };
        let around = if size < 1e-290 { 1.0 } else { 0.1 * size };
        let pad = if flat { around } else { margin * range };
        let (low, high) = (min - offset - pad, max - offset + pad);
        let scale = Scale::Linear;
        let mut axis = Self { scale, offset, low, high, ticks: Vec::new(), label: String::new() };
        let power = axis.set_ticks(count);
        axis.label = scaled_label(label, offset, power);
        axis
    }

    /// Returns a logarithmic axis over whole powers of ten around the positive `values`, with about
    /// `count` ticks.
    pub fn logarithmic(values: impl Iterator<Item = f64>, label: &str, count: f64) -> Self {
        let (min, max) = values.fold((f64::INFINITY, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)));
        let (min, max) = if min <= max { (min, max) } else { (1.0, 1.0) };
        // A value that is a power of ten up to rounding lies on that power.
        let (first, last) =
            (truncate_to_integer((min.log10() + 1e-9).floor()), truncate_to_integer((max.log10() - 1e-9).ceil()));
        let first = first.min(last - 1);
        let every = truncate_to_integer((f64::from(last - first) / count).ceil()).max(1);
        let margin = 0.04 * f64::from(last - first);
        let (low, high) = (f64::from(first) - margin, f64::from(last) + margin);
        let tick = |power: i32| {
            let text = if (-3..=3).contains(&power) {
                10_f64.powi(power).to_string()
            } else {
                format!("10{}", axis_superscript_digits(&power.to_string()))
            };
            ((f64::from(power) - low) / (high - low), text)
        };
        // Ticks are counted from the top, so that the largest power has a tick.
        let ticks = (0..=(last - first) / every).map(|i| tick(last - i * every)).collect();
        Self { scale: Scale::Logarithmic, offset: 0.0, low, high, ticks, label: scaled_label(label, 0.0, 0) }
    }

    /// Sets the ticks of a linear axis at multiples of 1, 2 or 5 times a power of ten. Returns the power of ten that is
    /// shown in the label instead of the ticks.
    fn set_ticks(&mut self, count: f64) -> i32 {
        let rough = (self.high - self.low) / count;
        let decade = truncate_to_integer(rough.log10().floor());
        let digit = rough / 10_f64.powi(decade);
        let (digit, decade) = match digit {
            d if d < 1.5 => (1.0, decade),
            d if d < 3.0 => (2.0, decade),
            d if d < 7.0 => (5.0, decade),
            _ => (1.0, decade + 1),
        };
        let size = self.low.abs().max(self.high.abs());
        let power = if (1e-2..1e5).contains(&size) { 0 } else { 3 * truncate_to_integer((size.log10() / 3.0).floor()) };
        let step = digit * 10_f64.powi(decade);
        let decimals = usize::try_from(power - decade).unwrap_or(0);
        let first = truncate_to_integer((self.low / step - 1e-9).ceil());
        for i in first..=truncate_to_integer((self.high / step + 1e-9).floor()) {
            let text = format!("{:.decimals$}", f64::from(i) * digit * 10_f64.powi(decade - power));
            let at = (f64::from(i) * step - self.low) / (self.high - self.low);
            self.ticks.push((at, text.replace('-', "−")));
        }
        power
    }

    /// Returns the position of a value on the axis, from 0 at its lower end to 1 at its upper end.
    pub fn position_on_axis(&self, value: f64) -> f64 {
        let value = match self.scale {
            Scale::Linear => value - self.offset,
            Scale::Logarithmic => value.log10(),
        };
        (value - self.low) / (self.high - self.low)
    }
}

/// Returns the number with the fewest digits that is within two ranges of `middle`, for use as an offset.
fn short_offset(middle: f64, range: f64) -> f64 {
    let rounded = (0..17).filter_map(|digits| format!("{middle:.digits$e}").parse::<f64>().ok());
    rounded.into_iter().find(|x| (x - middle).abs() <= 2.0 * range).unwrap_or(middle)
}

/// Returns a label such as `T + V [J]` with an offset and a power of ten: `T + V − 24.525 J [10⁻⁹ J]`.
fn scaled_label(label: &str, offset: f64, power: i32) -> String {
    let (stem, unit) = match label.trim_end().strip_suffix(']').and_then(|text| text.rsplit_once('[')) {
        Some((stem, unit)) => (figure_text_in_symbols(stem), figure_text_in_symbols(unit)),
        None => (figure_text_in_symbols(label), String::new()),
    };
    let sign = if offset < 0.0 { '+' } else { '−' };
    let stem = match offset {
        0.0 => stem,
        _ => {
            format!("{stem} {sign} {} {unit}", figure_text_in_symbols(&offset.abs().to_string())).trim_end().to_owned()
        }
    };
    match (power, unit.is_empty()) {
        (0, true) => stem,
        (0, false) => format!("{stem} [{unit}]"),
        _ => format!("{stem} [{}]", format!("10{} {unit}", axis_superscript_digits(&power.to_string())).trim_end()),
    }
}

/// Returns a whole number in superscript digits.
fn axis_superscript_digits(number: &str) -> String {
    let raise = |c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_digit(digit as u32 - '0' as u32, 10)
            .map_or(digit, |_| char::from_u32('⁰' as u32 + digit as u32 - '0' as u32).unwrap_or(digit)),
    };
    number.chars().map(raise).collect()
}

/// Returns a number rounded towards zero, as a 32-bit integer. A number out of range gives the nearest 32-bit integer.
#[expect(clippy::cast_possible_truncation, reason = "saturates, and every place in a figure is small")]
pub fn truncate_to_integer(x: f64) -> i32 {
    x as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(values: &[f64]) -> (Vec<String>, String) {
        let axis = Axis::new(values.iter().copied(), "T + V [J]", 0.06, 4.0);
        (axis.ticks.into_iter().map(|(_, text)| text).collect(), axis.label)
    }

    #[test]
    fn ticks_show_no_rounding() {
        assert_eq!(axis(&[0.0, 1.2]).0, ["0.0", "0.5", "1.0"]);
        assert_eq!(axis(&[0.0, 0.7]).0, ["0.0", "0.2", "0.4", "0.6"]);
        assert_eq!(
            axis(&[-2e5, 3e5]),
            (["−200", "−100", "0", "100", "200", "300"].map(str::to_owned).to_vec(), "T + V [10³ J]".to_owned())
        );
    }

    #[test]
    fn a_drift_is_shown_less_its_offset() {
        let (ticks, label) = axis(&[24.525, 24.525 + 3e-9, 24.525 - 1e-9]);
        assert_eq!(label, "T + V − 24.525 J [10⁻⁹ J]");
        assert_eq!(ticks, ["−1", "0", "1", "2", "3"]);
    }

    #[test]
    fn powers_of_ten_stand_evenly_on_a_logarithmic_axis() {
        let axis = Axis::logarithmic([1e-9, 2.0, 1e3].into_iter(), "|E| [J]", 4.0);
        let ticks: Vec<&str> = axis.ticks.iter().map(|(_, text)| text.as_str()).collect();
        assert_eq!(ticks, ["1000", "1", "0.001", "10⁻⁶", "10⁻⁹"]);
        for (value, at) in [(1e3, 0), (1.0, 1), (1e-6, 3)] {
            assert!((axis.position_on_axis(value) - axis.ticks[at].0).abs() < 1e-12, "{value}");
        }
        assert_eq!(axis.label, "|E| [J]");
        let narrow = Axis::logarithmic([0.2, 1.0].into_iter(), "x", 4.0);
        assert_eq!(narrow.ticks.iter().map(|(_, text)| text.as_str()).collect::<Vec<_>>(), ["1", "0.1"]);
    }

    #[test]
    fn names_are_written_as_by_hand() {
        assert_eq!(figure_text_in_symbols("q1' [m/s^2]"), "q̇₁ [m/s²]");
        assert_eq!(figure_text_in_symbols("T + V"), "T + V");
        assert_eq!(figure_text_in_symbols("p_q4 = ∂L/∂q4'  [kg*m/s]"), "p_q4 = ∂L/∂q̇₄ [kg·m/s]");
        assert_eq!(figure_text_in_symbols("|cos(q2)| 1e-12 ode45 t₀"), "|cos(q₂)| 1e-12 ode45 t₀");
    }
}
