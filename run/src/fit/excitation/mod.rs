//! Motions from which the base parameters of a mechanism can be estimated well.
//!
//! Each coordinate is a finite Fourier series (J. Swevers, C. Ganseman, D. B. Tükel, J. De Schutter & H. Van Brussel,
//! "Optimal robot excitation and identification", IEEE Trans. Robotics and Automation 13 (1997) 730–740). A search
//! maximizes the determinant of the information matrix Wᵀ Σ⁻¹ W, with the regressor W of the base parameters and the
//! covariance Σ of the forces. Limits of single quantities hold at every instant, since a
//! bound of each series is known ([`FourierSeries::bounds`]). Other conditions of the domain hold on a fine grid.

mod candidate;
mod design;
mod evolution_strategy;
mod fourier_series;
mod information;
mod motion_limits;
mod motion_regressor;

pub use design::design_excitation;
pub use fourier_series::FourierSeries;
pub use information::Information;
pub use motion_regressor::information_of_samples;

use tripos_derive::scene::MotionSample;

/// Range in which a quantity has to stay.
#[derive(Clone, Debug, PartialEq)]
pub struct QuantityLimit {
    /// Name of a coordinate `q1`, a rate `q1'`, a second rate `q1''`, a generalized speed `u1`, or its rate `u1'`.
    pub name: String,
    /// Least value, in SI units.
    pub low: f64,
    /// Largest value, in SI units.
    pub high: f64,
}

/// Options of the design of a motion.
#[derive(Clone, Debug)]
pub struct ExcitationOptions {
    /// Period of the motion, s.
    pub period: f64,
    /// Number of harmonics of each coordinate.
    pub harmonics: usize,
    /// Number of instants at which forces are measured, from the start to the end of a period, both included.
    pub samples: usize,
    /// Number of searches, each from its own random start.
    pub starts: usize,
    /// Seed of the random numbers. Equal seeds give equal motions.
    pub seed: u64,
    /// Limits beside those of the domain of the model.
    pub limits: Vec<QuantityLimit>,
    /// True if rates and second rates are zero at the start and at the end.
    pub is_at_rest: bool,
    /// Names of coordinates with their values at the start and at the end.
    pub home: Vec<(String, f64)>,
    /// Names of forces, such as `force(u1)`, with their standard deviations in SI units; 1 for the others.
    pub noise: Vec<(String, f64)>,
}

impl Default for ExcitationOptions {
    fn default() -> Self {
        Self {
            period: 10.0,
            harmonics: 5,
            samples: 101,
            starts: 4,
            seed: 1,
            limits: Vec::new(),
            is_at_rest: false,
            home: Vec::new(),
            noise: Vec::new(),
        }
    }
}

/// Extreme values of a coordinate or of one of its derivatives, with the limits.
#[derive(Clone, Debug, PartialEq)]
pub struct Extremes {
    /// Name of the quantity, such as `q1` or `q1'`.
    pub name: String,
    /// Least value over a period.
    pub least: f64,
    /// Largest value over a period.
    pub largest: f64,
    /// Lower limit. `None` without a limit.
    pub low: Option<f64>,
    /// Upper limit. `None` without a limit.
    pub high: Option<f64>,
}

/// Motion that determines the base parameters of a mechanism well.
#[derive(Clone, Debug)]
pub struct Excitation {
    /// Series of each coordinate, in the order of the model.
    pub series: Vec<FourierSeries>,
    /// Coordinates, generalized speeds and their rates at evenly spaced instants from the start to the end.
    pub samples: Vec<MotionSample>,
    /// Information that forces at these instants give about the base parameters.
    pub information: Information,
    /// Extreme values of each coordinate, of its rate and of its second rate.
    pub extremes: Vec<Extremes>,
    /// Conditions of the domain for several quantities, each with the least value of its term, which must be positive.
    pub conditions: Vec<(String, f64)>,
    /// Names of conditions of the domain that the design does not check, since they contain reactions or inputs.
    pub unchecked: Vec<String>,
    /// Number of motions that the searches tried.
    pub tried: usize,
}
