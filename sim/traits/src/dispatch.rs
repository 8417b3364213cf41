//! Detection of the processor's vector instructions, and calls of code that is compiled for them.

#![allow(clippy::inline_always, reason = "the instructions of a processor reach only what is inlined")]

/// Number of lanes of [`crate::Lanes`] with which this processor is fastest: 8 if it has registers
/// of 512 bits, else 4. Results do not depend on it.
#[must_use]
pub fn lane_width() -> usize {
    if matches!(level(), Level::Avx512) { 8 } else { 4 }
}

/// Level of vector instructions for which code is compiled a second time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(not(all(feature = "std", target_arch = "x86_64")), allow(dead_code, reason = "nothing is looked for there"))]
pub(crate) enum Level {
    /// Only the instructions for which the whole program is compiled.
    Baseline,
    /// AVX2 and FMA: registers of 256 bits, and fused multiply–add.
    Avx2,
    /// AVX-512 instructions: registers of 512 bits.
    Avx512,
}

/// Runs `work`, compiled for the widest vector instructions of this processor that `N` lanes fill. If
/// the processor has none of them, `work` runs with the instructions of the rest of the program. Eight
/// lanes in registers for four cost about as much a state as four lanes.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[inline(always)]
#[allow(unsafe_code, reason = "the calls are safe where the instructions exist, which the level says")]
pub(crate) fn run<const N: usize, R>(work: impl FnOnce() -> R) -> R {
    // The whole program has these instructions, so no test is needed.
    if N <= 4 && cfg!(all(target_feature = "avx2", target_feature = "fma")) {
        return work();
    }
    match level() {
        // SAFETY: `level` has found the features of `avx512`.
        Level::Avx512 if N > 4 => unsafe { avx512(work) },
        // SAFETY: `level` has found the features of `avx2`; they are among those of `avx512`.
        Level::Avx2 | Level::Avx512 => unsafe { avx2(work) },
        Level::Baseline => work(),
    }
}

/// Runs `work` unchanged: this target has no second copy of the code.
#[cfg(not(all(feature = "std", target_arch = "x86_64")))]
#[inline(always)]
pub(crate) fn run<const N: usize, R>(work: impl FnOnce() -> R) -> R {
    work()
}

/// Runs `work`, compiled for AVX-512. The caller must make sure that the processor has it.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]
fn avx512<R>(work: impl FnOnce() -> R) -> R {
    work()
}

/// Runs `work`, compiled for AVX2 and FMA. The caller must make sure that the processor has them.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[target_feature(enable = "avx2,fma")]
fn avx2<R>(work: impl FnOnce() -> R) -> R {
    work()
}

/// Vector instructions of this processor. They are detected once and then kept.
#[cfg(all(feature = "std", target_arch = "x86_64"))]
#[inline]
pub(crate) fn level() -> Level {
    use core::sync::atomic::{AtomicU8, Ordering::Relaxed};
    static KNOWN: AtomicU8 = AtomicU8::new(UNKNOWN);
    const UNKNOWN: u8 = 3;
    #[cold]
    fn ask() -> u8 {
        let avx2 = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
        let avx512 = avx2
            && is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("avx512vl");
        let found = if avx512 {
            Level::Avx512
        } else if avx2 {
            Level::Avx2
        } else {
            Level::Baseline
        };
        KNOWN.store(found as u8, Relaxed);
        found as u8
    }
    // Threads that detect at the same moment find the same level.
    let known = match KNOWN.load(Relaxed) {
        UNKNOWN => ask(),
        known => known,
    };
    match known {
        2 => Level::Avx512,
        1 => Level::Avx2,
        _ => Level::Baseline,
    }
}

/// Vector instructions that are used on this target: only those of the whole program.
#[cfg(not(all(feature = "std", target_arch = "x86_64")))]
pub(crate) fn level() -> Level {
    Level::Baseline
}
