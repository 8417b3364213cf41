//! Derivatives through impacts, changes of friction and moving jumps, against closed forms in 32 digits, forwards and
//! backwards.

use tripos::{Overrides, Scene, Sensitivities};
use tripos_traits::{DoubleDouble, Real, Scalar};

mod backwards;
pub mod balls;
mod differences;
mod driven;
mod rods;
mod rough;
mod touched;

type Wide = DoubleDouble;

fn how(by: &str, method: &str) -> Overrides {
    Overrides { by: Some(by.into()), method: Some(method.parse().unwrap()), ..Overrides::default() }
}

fn wide(x: f64) -> Wide {
    DoubleDouble::from_f64(x)
}

/// Derivatives of a closed form by each of these numbers, as differences of order 4 in 32 digits.
fn truth(numbers: &[f64], of: &dyn Fn(&[Wide]) -> Vec<Wide>) -> Vec<Vec<f64>> {
    let by = |which: usize| {
        let step = wide(numbers[which].abs().max(1.0) / 262_144.0);
        let at = |place: i32| {
            let mut list: Vec<Wide> = numbers.iter().map(|x| wide(*x)).collect();
            list[which] = list[which] + step * wide(f64::from(place));
            of(&list)
        };
        let (list, weights) = ([at(-2), at(-1), at(1), at(2)], [1.0, -8.0, 8.0, -1.0]);
        let sum = |value: usize| {
            let terms = list.iter().zip(weights).map(|(list, weight)| list[value] * wide(weight));
            (terms.fold(wide(0.0), |sum, term| sum + term) / (step * wide(12.0))).to_f64()
        };
        (0..list[0].len()).map(sum).collect::<Vec<f64>>()
    };
    (0..numbers.len()).map(by).collect()
}

/// Largest error of the derivatives at the end, relative to their size or 1, whichever is larger, for the shown names,
/// whose closed form is given. Checks that the stated errors hold.
fn largest_error(found: &Sensitivities, shown: &[&str], numbers: &[f64], of: &dyn Fn(&[Wide]) -> Vec<Wide>) -> f64 {
    assert!(
        found.run.failure().is_none() && found.missing_derivative().is_none(),
        "{:?} {:?}",
        found.run.objections(),
        found.missing_derivative()
    );
    let errors = found.errors.as_ref().expect("a second run comes to the end");
    let mut worst = 0.0_f64;
    for (by, list) in truth(numbers, of).iter().enumerate() {
        for (name, truth) in shown.iter().zip(list) {
            let at = found.names.iter().position(|known| known == name).unwrap();
            let (own, stated) = (found.end[by][at], errors[by][at]);
            let (off, size) = ((own - truth).abs(), truth.abs().max(1.0));
            println!("d({name})/d({}) = {own:e} ± {stated:.1e}, not {truth:e}: off by {off:.1e}", found.by[by]);
            assert!(
                off <= 30.0 * stated + 1e-13 * size,
                "d({name})/d({}) = {own:e} ± {stated:.1e}, not {truth:e}",
                found.by[by]
            );
            worst = worst.max(off / size);
        }
    }
    worst
}

/// Derivative at the end by a number with this `value`, as a difference of order 4 of whole runs that differ by a part
/// of it.
fn difference(scene: &Scene, of: &str, by: &str, value: f64, part: f64, how: &Overrides) -> f64 {
    let h = part * value.abs().max(0.1);
    let at = |place: f64| {
        let mut scene = scene.clone();
        scene.set_number(by, value + place * h).unwrap();
        let run = scene.simulate(how).unwrap();
        assert!(run.failure().is_none(), "{:?}", run.failure());
        *run.column_of_quantity(of).unwrap().last().unwrap()
    };
    (at(-2.0) - 8.0 * at(-1.0) + 8.0 * at(1.0) - at(2.0)) / (12.0 * h)
}

/// Pseudorandom numbers in a range, the same on every machine.
struct Planted(u64);

impl Planted {
    fn next(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        // Twelve bits, so that texts hold the number exactly.
        low + (high - low) * (f64::from(u16::try_from(self.0 >> 52).unwrap()) / 4096.0)
    }
}

const FINE: &str = "[integration]\nmethod = \"dop853\"\nrtol = 1e-13\natol = 1e-14\n";
