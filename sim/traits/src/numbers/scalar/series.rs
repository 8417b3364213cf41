//! Sums of products of Taylor coefficients: the part of Taylor's recurrences whose cost grows with
//! the order.
//!
//! Every operation that is not linear is a convolution Σ left_j right_{k−j}: of the factors of a
//! product, of divisor and quotient, or of j·a_j and cos a for sin a. Its terms with 0 < j < k have
//! coefficients of lower orders only. So those of all operations are summed at once, for two orders
//! together, which halves the reads from memory. The sums of an order are side by side, so there is
//! no short loop and no sum across a vector register.

use crate::Scalar;

/// Left and right factors of all convolutions at a single order. `W` is the number of convolutions,
/// rounded up to a multiple of [`LANES`]; the padding may be any finite numbers.
pub type Factors<S, const W: usize> = [[S; W]; 2];

/// Sums of all convolutions at two successive orders, the lower order first.
pub type Pair<S, const W: usize> = [[S; W]; 2];

/// Number to whose multiples the number of convolutions is rounded up.
pub const LANES: usize = 8;

/// Alignment of a row of factors, in bytes: a cache line, so that no vector register is filled from
/// two lines.
const LINE: usize = 64;

/// Largest number of entries that [`rows`] skips to reach the beginning of a cache line.
pub const SLACK: usize = LINE / 4;

/// Views a workspace as rows of factors. Rows begin at cache lines if `work` begins at a multiple
/// of the size of its entries.
#[must_use]
pub fn rows<S, const W: usize>(work: &mut [S]) -> &mut [Factors<S, W>] {
    let skip = work.as_ptr().align_offset(LINE);
    let skip = if skip <= SLACK.min(work.len()) { skip } else { 0 };
    work[skip..].as_chunks_mut().0.as_chunks_mut().0
}

/// Row of length `W` that begins with the given values; the remaining entries are zero.
#[inline(always)]
#[must_use]
#[expect(clippy::inline_always, reason = "a row is built where it is stored")]
pub fn padded<S: Scalar, const N: usize, const W: usize>(values: [S; N]) -> [S; W] {
    let mut row = [S::int(0); W];
    row[..N].copy_from_slice(&values);
    row
}

/// Sums of products for each convolution at the orders k and k + 1, where k is the length of
/// `history`. Entry `history[j]` holds the factors of order j.
///
/// The sums are Σ left_j right_{k−j} over 0 < j < k, and Σ left_j right_{k+1−j} over 1 < j < k. The
/// factors of order 0 are not read.
#[inline(always)]
#[expect(clippy::inline_always, reason = "as above")]
#[must_use]
pub fn pair_sums<S: Scalar, const W: usize>(history: &[Factors<S, W>]) -> Pair<S, W> {
    S::pair_sums(history)
}

/// Computes [`pair_sums`] in blocks of `BLOCK` sums. A block should fill half of the registers with
/// sums. The code is compiled for the vector instructions of its caller.
#[inline(always)]
#[expect(clippy::inline_always, reason = "a function that is called is compiled for what every processor has")]
pub(crate) fn sums<S: Scalar, const W: usize, const BLOCK: usize>(history: &[Factors<S, W>]) -> Pair<S, W> {
    let mut sums = [[S::from_f64(0.0); W]; 2];
    let Some((_, history)) = history.split_first() else { return sums };
    let mut at = 0;
    while at + BLOCK <= W {
        block::<S, W, BLOCK>(history, at, &mut sums);
        at += BLOCK;
    }
    // A rest of three eighths of a long block is summed together too.
    if BLOCK > 3 * LANES && at + 3 * LANES <= W {
        block::<S, W, { 3 * LANES }>(history, at, &mut sums);
        at += 3 * LANES;
    }
    if BLOCK > 2 * LANES && at + 2 * LANES <= W {
        block::<S, W, { 2 * LANES }>(history, at, &mut sums);
        at += 2 * LANES;
    }
    if at + LANES <= W {
        block::<S, W, LANES>(history, at, &mut sums);
    }
    sums
}

/// Computes [`pair_sums`] in blocks of `BLOCK` sums, for numbers that fill a vector register each.
/// The factors for order k + 1 are read twice, because a register that is kept would have to be
/// assembled from its parts.
#[inline(always)]
#[expect(clippy::inline_always, reason = "as above")]
pub(crate) fn read_twice<S: Scalar, const W: usize, const BLOCK: usize>(history: &[Factors<S, W>]) -> Pair<S, W> {
    let mut sums = [[S::from_f64(0.0); W]; 2];
    let [_, first @ .., last] = history else { return sums };
    for at in (0..W).step_by(BLOCK) {
        let (mut now, mut next) = ([S::from_f64(0.0); BLOCK], [S::from_f64(0.0); BLOCK]);
        for i in 0..BLOCK.min(W - at) {
            // The term with j = 1 of order k, whose counterpart in order k + 1 is not known yet.
            let [left, _] = first.first().unwrap_or(last);
            now[i] = left[at + i] * last[1][at + i];
        }
        let lefts = history[2.min(history.len())..].iter();
        for ([left, _], rights) in lefts.zip(history[1..].windows(2).rev()) {
            for i in 0..BLOCK.min(W - at) {
                next[i] = left[at + i].mul_add(rights[1][1][at + i], next[i]);
                now[i] = left[at + i].mul_add(rights[0][1][at + i], now[i]);
            }
        }
        for i in 0..BLOCK.min(W - at) {
            (sums[0][at + i], sums[1][at + i]) = (now[i], next[i]);
        }
    }
    sums
}

/// Computes `N` of the [`pair_sums`], from sum number `at` on, and writes them to `sums`.
#[inline(always)]
#[expect(clippy::inline_always, reason = "as above")]
fn block<S: Scalar, const W: usize, const N: usize>(history: &[Factors<S, W>], at: usize, sums: &mut Pair<S, W>) {
    let zero = [S::from_f64(0.0); N];
    let (mut now, mut next) = (zero, zero);
    // right_{k+1−j}, which order k has read one term earlier; at j = 1 it is not known yet.
    let mut before = zero;
    for ([left, _], [_, right]) in history.iter().zip(history.iter().rev()) {
        let (Some(left), Some(right)) = (left[at..].first_chunk::<N>(), right[at..].first_chunk::<N>()) else { break };
        for i in 0..N {
            next[i] = left[i].mul_add(before[i], next[i]);
        }
        for i in 0..N {
            now[i] = left[i].mul_add(right[i], now[i]);
        }
        before = *right;
    }
    sums[0][at..at + N].copy_from_slice(&now);
    sums[1][at..at + N].copy_from_slice(&next);
}

/// Computes [`pair_sums`] with the widest vector registers that the processor has. The results do
/// not depend on the processor: wider registers only hold more numbers, and no further product is
/// fused.
#[inline]
pub(crate) fn widest<S: Scalar, const W: usize>(history: &[Factors<S, W>]) -> Pair<S, W> {
    #[cfg(all(feature = "std", target_arch = "x86_64"))]
    {
        use crate::dispatch::{Level, level};
        #[allow(unsafe_code, reason = "called only where the processor has what it is compiled for")]
        match level() {
            // SAFETY: the level says that the processor has AVX-512.
            Level::Avx512 => return unsafe { with_avx512(history) },
            // SAFETY: the level says that the processor has AVX2.
            Level::Avx2 => return unsafe { with_avx2(history) },
            Level::Baseline => {}
        }
    }
    sums::<S, W, LANES>(history)
}

/// Computes [`pair_sums`] with AVX-512 instructions: 32 registers of 8 f64. The processor must have
/// them.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx512f")]
fn with_avx512<S: Scalar, const W: usize>(history: &[Factors<S, W>]) -> Pair<S, W> {
    sums::<S, W, { 4 * LANES }>(history)
}

/// Computes [`pair_sums`] with AVX2 instructions: 16 registers of 4 f64. The processor must have
/// them.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx2")]
fn with_avx2<S: Scalar, const W: usize>(history: &[Factors<S, W>]) -> Pair<S, W> {
    sums::<S, W, { 2 * LANES }>(history)
}
