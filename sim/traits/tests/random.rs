//! Numbers that look random and are the same in each run: xorshift64*, Vigna (2016).

/// A generator that starts from this number, which is not 0.
pub struct Random(pub u64);

impl Random {
    /// In [0, 1), to 53 bits.
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / 9_007_199_254_740_992.0
    }

    /// Random number of either sign, its size between 10ᵃ and 10ᵇ.
    pub fn of_size(&mut self, a: f64, b: f64) -> f64 {
        let size = 10_f64.powf(a + (b - a) * self.unit());
        if self.unit() < 0.5 { -size } else { size }
    }
}
