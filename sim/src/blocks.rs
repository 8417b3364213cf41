//! State vectors in blocks of a fixed number of components, padded with zeros.
//!
//! A loop over the components of a block has a known length and no bounds to check. The compiler turns such a loop into
//! vector instructions. The stages of a block lie next to one another in memory.

use tripos_traits::Real;

/// Number of components in a block: the number of doubles in a register of every x86-64 and ARM processor.
pub(crate) const LANES: usize = 2;

/// Block of `LANES` neighbouring components of a state vector.
pub(crate) type Block<S> = [S; LANES];

/// Vector of n components, stored in blocks; the last block is padded with zeros.
#[derive(Clone, Debug)]
pub(crate) struct Blocks<S> {
    /// Blocks of the vector, in order.
    pub(crate) blocks: Vec<Block<S>>,
    /// Number of components of the vector, without padding.
    n: usize,
}

impl<S: Real> Blocks<S> {
    /// Creates a vector of `n` zeros.
    pub(crate) fn zeros(n: usize) -> Self {
        Self { blocks: vec![[S::from_f64(0.0); LANES]; n.div_ceil(LANES)], n }
    }

    /// Returns the n components of the vector, without padding.
    pub(crate) fn components_of_blocks(&self) -> &[S] {
        &self.blocks.as_flattened()[..self.n]
    }

    /// Returns the n components of the vector, without padding, for writing.
    pub(crate) fn components_mut(&mut self) -> &mut [S] {
        &mut self.blocks.as_flattened_mut()[..self.n]
    }
}

/// Test that all examined numbers are finite, at the cost of two operations for each number. It stores sums of x − x,
/// which are 0 for finite numbers.
#[derive(Clone, Copy)]
pub(crate) struct FiniteTest(Block<f64>);

impl FiniteTest {
    /// Creates a test for finite numbers that has examined no number yet.
    pub(crate) const fn new() -> Self {
        Self([0.0; LANES])
    }

    /// Examines the numbers of a block; [`FiniteTest::is_finite`] tells the result.
    #[inline]
    pub(crate) fn examine_block<S: Real>(&mut self, block: &Block<S>) {
        // x − x is 0, or not a number if x is infinite or not a number.
        let rest = block.map(|x| x.to_f64() - x.to_f64());
        for (sum, rest) in self.0.iter_mut().zip(rest) {
            *sum += rest;
        }
    }

    /// True if every number examined so far is finite.
    #[inline]
    pub(crate) fn is_finite(self) -> bool {
        !self.0.into_iter().sum::<f64>().is_nan()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_number_that_is_not_finite_is_enough() {
        for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut finite = FiniteTest::new();
            finite.examine_block(&[f64::MAX, -f64::MAX]);
            assert!(finite.is_finite());
            finite.examine_block(&[1e-320, odd]);
            finite.examine_block(&[1.0; LANES]);
            assert!(!finite.is_finite(), "{odd}");
        }
    }

    #[test]
    fn components_are_what_was_asked_for() {
        for n in 0..10 {
            let mut vector = Blocks::<f32>::zeros(n);
            vector.components_mut().fill(1.0);
            assert_eq!(vector.components_of_blocks(), vec![1.0; n]);
            assert_eq!(vector.blocks.as_flattened().iter().sum::<f32>(), n as f32);
        }
    }
}
