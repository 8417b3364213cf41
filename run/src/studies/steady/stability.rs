//! Stability of a steady motion, judged by the eigenvalues of its linear system.

use super::SteadyProblem;
use super::quotient_system::QuotientSystem;
use super::spectra::mode::Mode;
use super::steady_state::SteadyState;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};

/// Stability of a steady motion, judged by its linear system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// Small differences from the motion grow exponentially.
    Unstable,
    /// No difference from the motion grows exponentially, but some differences grow like this power of t.
    /// The cause are Jordan blocks of eigenvalues on the imaginary axis.
    Grows(usize),
    /// All small differences from the motion decay.
    Attracting,
    /// All small differences from the motion decay, except differences that lead to neighbouring
    /// steady motions. Such motions were found.
    AttractingInFamily,
    /// The state is at rest at a strict minimum of the energy. Motions near it stay near it (Lagrange,
    /// Dirichlet).
    Energy,
    /// No difference from the motion grows to first order, but some do not decay. Terms of higher order
    /// decide.
    FirstOrder,
    /// Rounding leaves open if an eigenvalue is on the imaginary axis, or if it coincides there with
    /// another eigenvalue.
    Undecided,
    /// The state is not steady, so its eigenvalues do not tell how motions near it continue.
    NotSteady,
}

impl Stability {
    /// Name of the stability, for JSON.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Unstable => "unstable",
            Self::Grows(_) => "neutral, grows like a power of t",
            Self::Attracting => "asymptotically stable",
            Self::AttractingInFamily => "stable in its family",
            Self::Energy => "stable",
            Self::FirstOrder => "stable to first order",
            Self::Undecided => "undecided to first order",
            Self::NotSteady => "not steady",
        }
    }

    /// Power of t by which differences from the motion grow; `None` if they do not grow like a power of t.
    #[must_use]
    pub const fn growth_power(self) -> Option<usize> {
        if let Self::Grows(power) = self { Some(power) } else { None }
    }

    /// Sentence for the user that describes the stability.
    #[must_use]
    pub fn stability_sentence(self) -> String {
        let text = match self {
            Self::Unstable => "unstable: small differences grow",
            Self::Grows(power) => {
                let like = if power == 1 { "t".to_owned() } else { format!("t^{power}") };
                return format!(
                    "neutral, and grows like {like}: to first order some differences grow without bound, though not exponentially \
                     (a Jordan block of {} rows on the imaginary axis)",
                    power + 1
                );
            }
            Self::Attracting => "asymptotically stable: small differences die away",
            Self::AttractingInFamily => {
                "stable: small differences die away, but for those that lead to other motions of its family"
            }
            Self::Energy => "stable: the energy is a strict minimum there",
            Self::FirstOrder => {
                "stable to first order: nothing grows, some of it does not die away, and terms of higher order decide"
            }
            Self::Undecided => {
                "undecided to first order: an eigenvalue is so near the imaginary axis, or to another one there, that its digits do not tell"
            }
            Self::NotSteady => "the state is not steady: eigenvalues do not tell where motions near it go",
        };
        text.to_owned()
    }
}

impl SteadyProblem {
    /// Judges the stability of a steady motion by its eigenvalues. `family` is the number of parameters of
    /// the family of neighbouring steady motions that were found.
    pub(super) fn judge_stability(
        &mut self,
        steady: &SteadyState,
        system: &QuotientSystem,
        modes: &[Mode],
        family: usize,
    ) -> Stability {
        if !steady.is_steady() {
            return Stability::NotSteady;
        }
        if modes.iter().any(|mode| mode.grows() && !mode.is_undecided) {
            return Stability::Unstable;
        }
        if modes.iter().any(|mode| mode.is_undecided) {
            return Stability::Undecided;
        }
        let neutral = || modes.iter().filter(|mode| mode.is_neutral());
        let power = neutral().map(|mode| mode.power).max().unwrap_or(0);
        match neutral().count() {
            0 => Stability::Attracting,
            _ if power > 0 => Stability::Grows(power),
            count if count == family => Stability::AttractingInFamily,
            _ if self.is_energy_minimum(steady, system, modes) => Stability::Energy,
            _ => Stability::FirstOrder,
        }
    }

    /// True if a mechanism without friction, drive and gyroscopic forces is at rest at a strict minimum of
    /// its potential energy. This is the case exactly if all eigenvalues are imaginary and none is 0.
    fn is_energy_minimum(&mut self, steady: &SteadyState, system: &QuotientSystem, modes: &[Mode]) -> bool {
        let [_, _, power] = self.flow.energies;
        let power = self.flow.without_definitions(&[power]);
        let is_conservative = zero_test(&self.flow.arena, power[0]) == ZeroTest::Zero;
        let speeds: Vec<usize> = (0..system.kept.len()).filter(|at| system.kept[*at] >= self.coordinates).collect();
        let among = system.a.submatrix(&speeds, &speeds);
        let size = system.a.rounded().norm();
        let gyroscopic = among.rows.iter().flatten().any(|x| x.hi().abs() > 1e-12 * size);
        let oscillates = modes.iter().all(|mode| mode.is_neutral() && mode.value[1].abs() > 0.0);
        steady.is_rest() && self.time.is_none() && is_conservative && !gyroscopic && oscillates
    }
}
