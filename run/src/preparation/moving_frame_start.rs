//! Moves the start of a run along the symmetries of a moving frame until the frame's conditions
//! hold, to 32 digits.
//!
//! A moving frame represents all motions that differ by symmetries alone by one of them. Its states
//! form the section of the frame: there, certain functions of the state, the pins, are zero. A
//! motion along symmetries changes no quantity that the scene shows. So Newton's method may choose
//! the lengths of these motions in doubles. The motions themselves are exact, and the pins end at
//! zero.

use crate::code::compile_tape;
use crate::error::Error;
use nalgebra::{DMatrix, DVector};
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::reduce::MovingFrame;
use tripos_linear::SingularValues;
use tripos_traits::DoubleDouble;

/// Greatest number of Newton steps from a start to the section of a moving frame, where its pins
/// are zero.
const STEPS: usize = 60;
/// Greatest length of one Newton step along any symmetry, in the parameter of the symmetry's flow
/// (without unit).
const FARTHEST: f64 = 0.5;
/// Greatest number of columns in the extrapolation of the midpoint rule to step length zero.
const COLUMNS: usize = 16;
/// Difference of the last two columns of an extrapolation up to which it has converged, relative to
/// the size of the state.
const EXACT: f64 = 1e-31;
/// Greatest number of times in a row that a motion along symmetries is halved because its
/// extrapolation does not converge.
const HALVINGS: usize = 6;
/// Largest value of a pin that counts as zero, relative to the size of the state. A pin is a function
/// of the state that is zero on the section of a moving frame.
const PINNED: f64 = 1e-29;
/// Lengths by which a start is moved along each symmetry before Newton's method, in the order in which
/// they are tried. The first is zero. The other lengths serve starts at which the frame is singular.
const DETOURS: [f64; 5] = [0.0, 0.7, -1.1, 1.9, -2.3];
/// Singular value of the pins' slopes that counts as zero, as a fraction of the largest singular
/// value.
const NOTHING: f64 = 1e-9;

/// Symmetries and pins of a moving frame, compiled to tapes of 32 digits. The pins are the functions of the state that
/// the frame makes zero.
pub struct SectionMotion {
    /// Directions of the symmetries, one block for each symmetry. A block has a component for each
    /// coordinate and each speed.
    fields: Tape<DoubleDouble>,
    /// Values of all pins, followed by the derivatives of the pins along the symmetries, a row for each
    /// pin.
    pins: Tape<DoubleDouble>,
    /// Number of pins, equal to the number of symmetries.
    count: usize,
}

impl SectionMotion {
    /// Compiles the symmetries and pins of a moving frame. `symbols` are the parameters, coordinates and speeds of the
    /// whole model.
    ///
    /// # Errors
    /// [`Error::Request`] if the frame contains another symbol.
    pub fn new(arena: &Arena, frame: &MovingFrame, symbols: &[Expr]) -> Result<Self, Error> {
        let what = "a moving frame";
        let of_pins = frame.pins.iter().chain(frame.slopes.iter().flatten()).copied().collect::<Vec<_>>();
        Ok(Self {
            fields: compile_tape(arena, symbols, &frame.fields.concat(), what)?.to(),
            pins: compile_tape(arena, symbols, &of_pins, what)?.to(),
            count: frame.pins.len(),
        })
    }

    /// Moves a start (q, u) of the whole model along the symmetries of the moving frame until the frame's
    /// pins are zero. Returns the moved start in the order of `start`.
    ///
    /// # Errors
    /// [`Error::Stopped`] if no motion along the symmetries makes the pins zero.
    pub fn move_to_section(
        &self,
        parameters: &[DoubleDouble],
        start: &[DoubleDouble],
    ) -> Result<Vec<DoubleDouble>, Error> {
        let turning = MovingFrameMotion { parameters, tapes: self };
        DETOURS.iter().find_map(|detour| turning.newton_to_section(start, *detour)).ok_or_else(|| {
            Error::Stopped(format!(
                "no symmetry moves the start to a place where {} zero",
                if self.count == 1 { "the state of the frame is" } else { "the states of the frame are" }
            ))
        })
    }
}

/// Symmetries and pins of a moving frame with the values of the parameters.
struct MovingFrameMotion<'a> {
    /// Values of the model's parameters, to 32 digits.
    parameters: &'a [DoubleDouble],
    /// Compiled symmetries and pins.
    tapes: &'a SectionMotion,
}

impl MovingFrameMotion<'_> {
    /// Solves for a state at which all pins are zero, by Newton's method. The start is first moved by
    /// about `detour` along each symmetry. `None` if the slopes of the pins are singular or the method
    /// does not converge.
    fn newton_to_section(&self, start: &[DoubleDouble], detour: f64) -> Option<Vec<DoubleDouble>> {
        let count = self.tapes.count;
        let detours: Vec<f64> = (0..count).map(|at| detour / (1.0 + 0.3 * at as f64)).collect();
        let mut x =
            if detour == 0.0 { start.to_vec() } else { self.moved_along_symmetries(start, &detours, HALVINGS)? };
        for _ in 0..STEPS {
            let values = self.tapes.pins.evaluate(&[self.parameters, &x].concat());
            let (pins, slopes) = values.split_at(count);
            let size = x.iter().map(|x| x.hi().abs()).fold(1.0, f64::max);
            if pins.iter().all(|pin| pin.hi().abs() <= PINNED * size) {
                return Some(x);
            }
            let slopes = DMatrix::from_fn(count, count, |i, j| slopes[i * count + j].hi());
            if slopes.iter().any(|x| !x.is_finite()) {
                return None;
            }
            let found = SingularValues::new(&slopes);
            if found.values.min() <= NOTHING * found.values.max() {
                return None;
            }
            let step = found.solve(&DVector::from_fn(count, |at, _| -pins[at].hi()), 0.0);
            let shorter = (FARTHEST / step.amax()).min(1.0);
            let far: Vec<f64> = step.iter().map(|x| shorter * x).collect();
            x = self.moved_along_symmetries(&x, &far, HALVINGS)?;
        }
        None
    }

    /// Moves a state by the lengths `far` along all symmetries at once. A motion whose extrapolation does
    /// not converge is made in two halves, up to `halvings` times in a row. `None` if even the shortest
    /// part does not converge.
    fn moved_along_symmetries(
        &self,
        start: &[DoubleDouble],
        far: &[f64],
        halvings: usize,
    ) -> Option<Vec<DoubleDouble>> {
        if let Some(end) = self.extrapolated_symmetry_motion(start, far) {
            return Some(end);
        }
        let half: Vec<f64> = far.iter().map(|x| 0.5 * x).collect();
        let middle = self.moved_along_symmetries(start, &half, halvings.checked_sub(1)?)?;
        self.moved_along_symmetries(&middle, &half, halvings - 1)
    }

    /// Moves a state by the lengths `far` along all symmetries at once, without halving. It uses
    /// W. B. Gragg's modified midpoint rule with 2, 4, 6, … steps, and extrapolation in the square of
    /// the step length. `None` if the extrapolation does not converge.
    fn extrapolated_symmetry_motion(&self, start: &[DoubleDouble], far: &[f64]) -> Option<Vec<DoubleDouble>> {
        let mut columns: Vec<Vec<DoubleDouble>> = Vec::new();
        for k in 0..COLUMNS {
            let mut entry = self.midpoint_symmetry_motion(start, far, 2 * (k + 1));
            for j in 1..=k {
                let [a, b] = [k + 1, k + 1 - j].map(|n| (n * n) as f64);
                let weight = DoubleDouble::from(b) / DoubleDouble::from(a - b);
                let next: Vec<DoubleDouble> =
                    entry.iter().zip(&columns[j - 1]).map(|(new, old)| *new + weight * (*new - *old)).collect();
                columns[j - 1] = std::mem::replace(&mut entry, next);
            }
            let size = entry.iter().map(|x| x.hi().abs()).fold(1.0, f64::max);
            if !size.is_finite() {
                return None;
            }
            let close = columns
                .last()
                .is_some_and(|last| entry.iter().zip(last).all(|(a, b)| (*a - *b).hi().abs() <= EXACT * size));
            columns.push(entry.clone());
            if close {
                return Some(entry);
            }
        }
        None
    }

    /// Moves a state by the lengths `far` along all symmetries at once, by the modified midpoint rule in
    /// `steps` steps, an even number.
    fn midpoint_symmetry_motion(&self, start: &[DoubleDouble], far: &[f64], steps: usize) -> Vec<DoubleDouble> {
        let h = DoubleDouble::from(1.0) / DoubleDouble::from(steps as f64);
        let along = |from: &[DoubleDouble], at: &[DoubleDouble], h: DoubleDouble| -> Vec<DoubleDouble> {
            let rate = self.symmetry_rate(at, far);
            from.iter().zip(rate).map(|(x, rate)| *x + h * rate).collect()
        };
        let (mut before, mut now) = (start.to_vec(), along(start, start, h));
        for _ in 1..steps {
            let next = along(&before, &now, h + h);
            before = std::mem::replace(&mut now, next);
        }
        // Gragg's smoothing is not needed: the number of steps is even.
        now
    }

    /// Rate of the state `x` if it moves along all symmetries at once: Σ farᵢ ζᵢ(x), where ζᵢ is the
    /// direction of symmetry i.
    fn symmetry_rate(&self, x: &[DoubleDouble], far: &[f64]) -> Vec<DoubleDouble> {
        let values = self.tapes.fields.evaluate(&[self.parameters, x].concat());
        let mut rate = vec![DoubleDouble::from(0.0); x.len()];
        for (field, far) in values.chunks(x.len()).zip(far) {
            for (rate, along) in rate.iter_mut().zip(field) {
                *rate = *rate + DoubleDouble::from(*far) * *along;
            }
        }
        rate
    }
}
