//! Stiff problems of the literature in any scalar, each with its Jacobian and its published solution.
//!
//! F. Mazzia & C. Magherini, *Test Set for Initial Value Problem Solvers*, release 2.4 (2008), problems VDPOL, ROBER
//! and HIRES, whose reference solutions RADAU and RADAU5 found with tolerances of 1.1e-18; E. Hairer & G. Wanner,
//! *Solving Ordinary Differential Equations II*, §IV.1 and §IV.10.

use tripos_sim::{Failure, RightHandSide};
use tripos_traits::Real;

/// Writes f(y), or its slopes row by row.
type Function<S> = fn(&[S], &mut [S]);

/// y' = f(y) with its Jacobian, from t = 0.
pub struct Stiff<S> {
    pub name: &'static str,
    rhs: Function<S>,
    jacobian: Function<S>,
    y0: &'static [&'static str],
    pub span: f64,
    pub end: &'static [f64],
    /// Absolute tolerances in units of the relative one, by the sizes of the components.
    pub sizes: &'static [f64],
}

impl<S: Real> Stiff<S> {
    pub fn all() -> [Self; 3] {
        [
            Self {
                name: "van der Pol, mu = 1e6",
                rhs: van_der_pol,
                jacobian: van_der_pol_slopes,
                y0: &["2", "0"],
                span: 2.0,
                end: &[1.706_167_732_170_483, -0.892_809_701_024_797_5],
                sizes: &[1.0, 1.0],
            },
            Self {
                name: "Robertson",
                rhs: robertson,
                jacobian: robertson_slopes,
                y0: &["1", "0", "0"],
                span: 1e11,
                end: &[0.208_334_014_970_125_5e-7, 0.833_336_077_033_471_3e-13, 0.999_999_979_166_505],
                sizes: &[1e-8, 1e-13, 1.0],
            },
            Self {
                name: "HIRES",
                rhs: hires,
                jacobian: hires_slopes,
                y0: &["1", "0", "0", "0", "0", "0", "0", "0.0057"],
                span: 321.8122,
                end: &[
                    0.737_131_257_332_566_8e-3,
                    0.144_248_572_631_618_5e-3,
                    0.588_872_974_096_757_5e-4,
                    0.117_565_134_328_314_9e-2,
                    0.238_635_619_883_133_1e-2,
                    0.623_896_825_274_279_6e-2,
                    0.284_999_839_518_576_9e-2,
                    0.285_000_160_481_423_1e-2,
                ],
                sizes: &[1e-4; 8],
            },
        ]
    }

    pub fn start(&self) -> Vec<S> {
        self.y0.iter().map(|text| S::decimal(text)).collect()
    }

    /// The largest error of a component, relative to its published value.
    pub fn error(&self, y: &[S]) -> f64 {
        y.iter().zip(self.end).map(|(y, end)| (y.to_f64() / end - 1.0).abs()).fold(0.0, f64::max)
    }
}

impl<S: Real> RightHandSide<S> for &Stiff<S> {
    fn rhs(&mut self, _t: f64, y: &[S], dydt: &mut [S]) -> Result<(), Failure> {
        (self.rhs)(y, dydt);
        Ok(())
    }
    fn jacobian(&mut self, _t: f64, y: &[S], out: &mut [S]) -> Option<Result<(), Failure>> {
        out.fill(S::int(0));
        (self.jacobian)(y, out);
        Some(Ok(()))
    }
}

/// In the time in which a relaxation takes a unit: ε = 1/μ² = 1e-6.
fn van_der_pol<S: Real>(y: &[S], out: &mut [S]) {
    out[0] = y[1];
    out[1] = ((S::int(1) - y[0] * y[0]) * y[1] - y[0]) * S::int(1_000_000);
}

fn van_der_pol_slopes<S: Real>(y: &[S], out: &mut [S]) {
    let (one, million) = (S::int(1), S::int(1_000_000));
    out[1] = one;
    out[2] = (S::int(-2) * y[0] * y[1] - one) * million;
    out[3] = (one - y[0] * y[0]) * million;
}

fn robertson<S: Real>(y: &[S], out: &mut [S]) {
    let [first, second, third] =
        [S::ratio(1, 25) * y[0], S::int(10_000) * y[1] * y[2], S::int(30_000_000) * y[1] * y[1]];
    out.copy_from_slice(&[second - first, first - second - third, third]);
}

fn robertson_slopes<S: Real>(y: &[S], out: &mut [S]) {
    let (slow, by_second, by_third) = (S::ratio(1, 25), S::int(10_000) * y[2], S::int(10_000) * y[1]);
    let square = S::int(60_000_000) * y[1];
    let zero = S::int(0);
    out.copy_from_slice(&[-slow, by_second, by_third, slow, -by_second - square, -by_third, zero, square, zero]);
}

/// The linear part of HIRES row by row, in thousandths. The other terms are 0.0007 and the product of the sixth and the
/// last component.
const HIRES: [[i64; 8]; 8] = [
    [-1_710, 430, 8_320, 0, 0, 0, 0, 0],
    [1_710, -8_750, 0, 0, 0, 0, 0, 0],
    [0, 0, -10_030, 430, 35, 0, 0, 0],
    [0, 8_320, 1_710, -1_120, 0, 0, 0, 0],
    [0, 0, 0, 0, -1_745, 430, 430, 0],
    [0, 0, 0, 690, 1_710, -430, 690, 0],
    [0, 0, 0, 0, 0, 0, -1_810, 0],
    [0, 0, 0, 0, 0, 0, 1_810, 0],
];
/// The sign of 280 y₆ y₈ in each equation.
const PRODUCT: [i64; 8] = [0, 0, 0, 0, 0, -1, 1, -1];

fn hires<S: Real>(y: &[S], out: &mut [S]) {
    for (i, out) in out.iter_mut().enumerate() {
        let linear = HIRES[i].iter().zip(y).fold(S::int(0), |sum, (a, y)| sum + S::ratio(*a, 1000) * *y);
        *out = linear + S::int(280 * PRODUCT[i]) * y[5] * y[7];
    }
    out[0] = out[0] + S::ratio(7, 10_000);
}

fn hires_slopes<S: Real>(y: &[S], out: &mut [S]) {
    for i in 0..8 {
        for j in 0..8 {
            out[8 * i + j] = S::ratio(HIRES[i][j], 1000);
        }
        let product = S::int(280 * PRODUCT[i]);
        out[8 * i + 5] = out[8 * i + 5] + product * y[7];
        out[8 * i + 7] = out[8 * i + 7] + product * y[5];
    }
}
