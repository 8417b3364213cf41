//! Eigenvalues that coincide, growth like powers of t, and statements on stability.
//!
//! Truth: matrices with a planted Jordan form, in whole numbers; the growth of their exponentials; equations of motion
//! written down here.

mod neutral_motions;

use crate::random_trees::times;
use nalgebra::DMatrix;
use tripos::studies::steady::{Mode, WideMatrix, eigenvalue_modes};
use tripos_traits::{DoubleDouble, Scalar};

/// Random numbers that are the same on every machine.
pub struct Random(pub u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    pub fn below(&mut self, n: u64) -> u64 {
        self.next() % n
    }

    fn whole(&mut self, most: i64) -> i64 {
        let span = u64::try_from(2 * most + 1).unwrap();
        i64::try_from(self.below(span)).unwrap() - most
    }
}

/// Planted Jordan block: its eigenvalue, in halves, and its number of rows.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Block {
    re: i64,
    im: i64,
    rows: usize,
}

/// Real Jordan form with these blocks, times two, so that all numbers are whole.
fn form(blocks: &[Block]) -> DMatrix<i64> {
    let size: usize = blocks.iter().map(|b| if b.im == 0 { b.rows } else { 2 * b.rows }).sum();
    let mut form = DMatrix::zeros(size, size);
    let mut at = 0;
    for block in blocks {
        let wide = if block.im == 0 { 1 } else { 2 };
        for row in 0..block.rows {
            let place = at + row * wide;
            for k in 0..wide {
                form[(place + k, place + k)] = block.re;
                if row + 1 < block.rows {
                    form[(place + k, place + wide + k)] = 2;
                }
            }
            if wide == 2 {
                (form[(place, place + 1)], form[(place + 1, place)]) = (block.im, -block.im);
            }
        }
        at += block.rows * wide;
    }
    form
}

/// Similar matrix S form S⁻¹ with a random S of determinant 1 in whole numbers: rows and columns are added to one
/// another.
pub fn mixed(random: &mut Random, form: DMatrix<i64>) -> DMatrix<i64> {
    let mut a = form;
    let size = a.nrows();
    for _ in 0..3 * size {
        let (i, j) = (random.below(size as u64), random.below(size as u64));
        let (i, j) = (usize::try_from(i).unwrap(), usize::try_from(j).unwrap());
        let k = random.whole(1);
        if i == j || k == 0 {
            continue;
        }
        // Adds k times row j to row i, then subtracts k times column i from column j.
        for column in 0..size {
            let add = k * a[(j, column)];
            a[(i, column)] += add;
        }
        for row in 0..size {
            let take = k * a[(row, i)];
            a[(row, j)] -= take;
        }
    }
    a
}

fn wide(a: &DMatrix<i64>) -> WideMatrix {
    let half = DoubleDouble::from_f64(0.5);
    WideMatrix { rows: a.row_iter().map(|row| row.iter().map(|x| DoubleDouble::int(*x) * half).collect()).collect() }
}

fn draw(random: &mut Random) -> Vec<Block> {
    let count = 1 + random.below(4);
    let block = |random: &mut Random| {
        let rows = 1 + usize::try_from([0, 0, 0, 1, 1, 2, 3][usize::try_from(random.below(7)).unwrap()]).unwrap();
        let (re, im) = match random.below(6) {
            0 | 1 => (0, 0),
            2 | 3 => (0, 1 + i64::try_from(random.below(3)).unwrap()),
            4 => (-1 - i64::try_from(random.below(2)).unwrap(), 0),
            _ => (-1, 2 + i64::try_from(random.below(2)).unwrap()),
        };
        Block { re, im, rows }
    };
    (0..count).map(|_| block(random)).collect()
}

/// Power of t with which the exponential of a matrix grows, from its size at two late times. It is found by squaring,
/// in 32 digits, since doubles would separate blocks of four rows by 1e-4.
pub fn grown(a: &WideMatrix) -> f64 {
    // The series gives exp(A/2^k), which is then squared until the highest power is the largest term.
    let n = a.rows.len();
    let times = |a: &WideMatrix, b: &WideMatrix| WideMatrix::zeros(n, n).plus_product(1.0, a, b);
    let mut term = WideMatrix::zeros(n, n);
    term.rows.iter_mut().enumerate().for_each(|(at, row)| row[at] = DoubleDouble::int(1));
    let mut exponential = term.clone();
    for k in 1..20 {
        let scale = DoubleDouble::from_f64(1.0 / 1024.0) / DoubleDouble::int(k);
        term = times(&term, a);
        term.rows.iter_mut().flatten().for_each(|x| *x = *x * scale);
        let sum = exponential.rows.iter_mut().flatten().zip(term.rows.iter().flatten());
        sum.for_each(|(sum, x)| *sum = *sum + *x);
    }
    let doubled = |from: &WideMatrix, count: u32| (0..count).fold(from.clone(), |e, _| times(&e, &e));
    let step = doubled(&exponential, 10);
    // Largest sizes from t = 256 to 268, and from 1024 to 1036.
    let at = |doublings: u32| {
        let mut e = doubled(&exponential, doublings);
        let mut most = 0.0_f64;
        for _ in 0..12 {
            most = most.max(e.rounded().norm());
            e = times(&e, &step);
        }
        most
    };
    let (early, late) = (at(18), at(20));
    (late / early).ln() / 4.0_f64.ln()
}

fn growth(list: &[Mode]) -> (bool, Option<usize>) {
    let neutral: Vec<&Mode> = list.iter().filter(|mode| mode.is_neutral()).collect();
    (list.iter().any(Mode::grows), neutral.iter().map(|mode| mode.power).max())
}

/// Goal: Jordan blocks are recognized, at 0 and elsewhere, and coinciding eigenvalues are one value. Method: random
/// matrices in whole numbers, similar to a planted Jordan form. Each eigenvalue is checked with its multiplicity, its
/// vectors and its largest block, and the growth of the exponential.
#[test]
fn planted_jordan_blocks_are_found() {
    let mut random = Random(0x5EED_1234);
    let (mut compared, mut defective) = (0, 0);
    for turn in 0..60 * times() {
        let blocks = draw(&mut random);
        let a = mixed(&mut random, form(&blocks));
        if a.iter().any(|x| x.abs() > 100_000) {
            continue;
        }
        let found = eigenvalue_modes(&wide(&a), 0.0).unwrap_or_else(|e| panic!("{e}"));
        let what = format!("turn {turn}: {blocks:?}\n{a}\n{found:?}");
        assert_eq!(found.len(), a.nrows(), "{what}");
        for block in &blocks {
            let same = || blocks.iter().filter(|other| (other.re, other.im) == (block.re, block.im));
            let (many, largest) = (same().map(|b| b.rows).sum::<usize>(), same().map(|b| b.rows).max().unwrap());
            let value = [block.re as f64 / 2.0, block.im as f64 / 2.0];
            let near = |mode: &&Mode| {
                (mode.value[0] - value[0]).abs() < 1e-12 && (mode.value[1].abs() - value[1]).abs() < 1e-12
            };
            let mode = found.iter().find(near).unwrap_or_else(|| panic!("{what}"));
            let told = (mode.multiplicity, mode.power + 1, mode.vectors, mode.is_undecided);
            assert_eq!(told, (many, largest, same().count(), false), "{what}");
            assert!(block.re != 0 || mode.is_neutral(), "{what}");
            defective += usize::from(largest > 1 && block.re == 0);
        }
        let (grows, power) = growth(&found);
        assert!(!grows, "{what}");
        let Some(power) = power else { continue };
        let truth = grown(&wide(&a));
        assert!((truth - power as f64).abs() < 0.35, "grows like t^{truth}, told t^{power}: {what}");
        compared += 1;
    }
    assert!(compared > 30 && defective > 25, "{compared} {defective}");
}

/// Goal: eigenvalues that coincide to fewer digits than are known are not merged, and undecided cases are reported.
/// Method: pairs beside a Jordan block of two rows, at distances that can be resolved, and at one that rounding also
/// causes. Likewise an eigenvalue beside the imaginary axis.
#[test]
fn what_digits_do_not_tell_is_undecided() {
    let pair = |square: f64| {
        let [zero, one] = [0.0, 1.0].map(DoubleDouble::from_f64);
        eigenvalue_modes(
            &WideMatrix { rows: vec![vec![zero, one], vec![DoubleDouble::from_f64(-square), zero]] },
            1e-20,
        )
        .unwrap()
    };
    let told = |list: &[Mode]| (list[0].multiplicity, list[0].power, list[0].is_undecided);
    assert_eq!(told(&pair(0.0)), (2, 1, false));
    assert_eq!(told(&pair(1e-9)), (1, 0, false));
    assert!((pair(1e-9)[0].value[1] - 1e-9_f64.sqrt()).abs() < 1e-14);
    assert!(pair(1e-15)[0].is_undecided, "{:?}", pair(1e-15));
    let damped = |re: f64| {
        let [re, one] = [re, 1.0].map(DoubleDouble::from_f64);
        eigenvalue_modes(&WideMatrix { rows: vec![vec![re, one], vec![-one, re]] }, 1e-20).unwrap()
    };
    assert!(damped(-1e-12).iter().all(|m| !m.is_neutral() && !m.is_undecided && m.value[0] < 0.0));
    assert!(damped(-1e-15).iter().all(|m| m.is_undecided));
    assert!(damped(-1e-19).iter().all(|m| m.is_neutral() && !m.is_undecided));
}

/// Matrix of y'' = −K y, y first.
fn swinging(k: &[&[DoubleDouble]]) -> WideMatrix {
    let n = k.len();
    let mut a = WideMatrix::zeros(2 * n, 2 * n);
    for (row, of_row) in k.iter().enumerate() {
        a.rows[row][n + row] = DoubleDouble::int(1);
        of_row.iter().enumerate().for_each(|(column, x)| a.rows[n + row][column] = -*x);
    }
    a
}

/// Goal: frequencies that differ by 1e-19 are told apart if their oscillators do not act on one another in a circle,
/// and a Jordan block is one whatever stands beside it. Method: x0'' = −x0 − x1, x1'' = −(1 + δ) x1 is bounded, with
/// the frequencies 1 and 1 + δ/2. x0'' = −x0 − x1, x1'' = −x1, x2'' = −(1 + δ) x2 grows like t.
#[test]
fn frequencies_near_a_jordan_block_are_told_apart() {
    let [zero, one] = [0, 1].map(DoubleDouble::int);
    for exponent in 3..20 {
        let d = 10.0_f64.powi(-exponent);
        let near = one + DoubleDouble::from_f64(d);
        let bounded = eigenvalue_modes(&swinging(&[&[one, one], &[zero, near]]), 0.0).unwrap();
        let what = format!("1e-{exponent}: {bounded:?}");
        assert!(
            bounded.iter().all(|m| m.is_neutral() && !m.is_undecided && (m.multiplicity, m.power) == (1, 0)),
            "{what}"
        );
        assert!(bounded.iter().all(|m| (m.value[1].abs() - 1.0).abs() <= d), "{what}");
        let grows =
            eigenvalue_modes(&swinging(&[&[one, one, zero], &[zero, one, zero], &[zero, zero, near]]), 0.0).unwrap();
        let what = format!("1e-{exponent}: {grows:?}");
        assert_eq!(growth(&grows), (false, Some(1)), "{what}");
        assert!(grows.iter().all(|m| !m.is_undecided && m.condition < 10.0), "{what}");
        for (frequency, many) in [(1.0, 2), (1.0 + d / 2.0, 1)] {
            let is_it = |m: &&Mode| m.multiplicity == many && (m.value[1] - frequency).abs() <= d * d + 1e-15;
            assert_eq!(grows.iter().filter(is_it).count(), many, "{what}");
        }
    }
}

/// Goal: eigenvalues that are told satisfy the matrix, and no block on the imaginary axis is called stable or bounded.
/// Method: a Jordan block of two rows at ±i beside a frequency 1 + δ, and a frequency pair 1, 1 + δ with a coupling, in
/// random mixtures whose entries are exact. The eigenvalues are counted near ±i, and lie no farther apart than √ε
/// explains.
#[test]
fn mixtures_near_a_jordan_block_are_never_called_bounded() {
    let mut random = Random(0xB10C);
    let (mut decided, mut told) = (0, 0);
    for turn in 0..48 * times() {
        let d = 2.0_f64.powi(-i32::try_from(6 + turn % 54).unwrap());
        let is_block = turn % 2 == 0;
        let [zero, one] = [0, 1].map(DoubleDouble::int);
        let near = one + DoubleDouble::from_f64(d);
        let plain = if is_block {
            swinging(&[&[one, one, zero], &[zero, one, zero], &[zero, zero, near]])
        } else {
            swinging(&[&[one, one, zero], &[zero, near, zero], &[zero, zero, one + one + one]])
        };
        // S A S⁻¹ by sums of rows and columns, in exact numbers.
        let mut a = plain.rows;
        for _ in 0..12 {
            let [i, j] = [random.below(6), random.below(6)].map(|x| usize::try_from(x).unwrap());
            if i != j {
                let from = a[j].clone();
                a[i].iter_mut().zip(from).for_each(|(x, y)| *x = *x + y);
                for row in &mut a {
                    row[j] = row[j] - row[i];
                }
            }
        }
        let found = eigenvalue_modes(&WideMatrix { rows: a }, 0.0).unwrap();
        let what = format!("turn {turn}, {d:e}: {found:?}");
        assert_eq!(found.len(), 6, "{what}");
        let wide = |value: f64| (value - 1.0).abs() < 1e-6 + d;
        assert_eq!(found.iter().filter(|m| wide(m.value[1].abs())).count(), if is_block { 6 } else { 4 }, "{what}");
        assert!(!found.iter().any(|m| m.grows() && !m.is_undecided), "{what}");
        let is_undecided = found.iter().any(|m| m.is_undecided);
        let (_, power) = growth(&found);
        if is_block {
            // Frequencies within rounding of a block of three rows may be told as that block.
            let is_told = power == Some(1) || (d < 1e-13 && power == Some(2));
            assert!(is_undecided || is_told, "a block is called bounded: {what}");
        } else {
            // Rounding alone splits a block by 1e-14.
            assert!(is_undecided || power == Some(0) || d < 1e-13, "distinct frequencies are called a block: {what}");
        }
        decided += usize::from(!is_undecided);
        told += 1;
    }
    assert!(5 * decided > told, "{decided} of {told}");
}
