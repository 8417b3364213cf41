//! Starts and states of a problem in twice the precision of a double, about 32 digits.

use super::{DistanceOrigin, ExtendedStart, Problem};
use crate::error::Error;
use crate::preparation::exact_start::exact_start_speeds;
use tripos_derive::Formulation;
use tripos_derive::scene::InitialMotion;
use tripos_traits::{DoubleDouble, Scalar};

impl Problem<'_> {
    /// Values of the parameters, and the integrated state at the start, both to 32 digits. No number is
    /// rounded to a double.
    ///
    /// # Errors
    /// [`Error::Request`] if the definition of a speed contains a symbol that has no value at the
    /// start.
    pub fn extended_start(&self) -> Result<ExtendedStart, Error> {
        let (system, exact) = (self.code.extended(), &self.scene.exact);
        let (p, mut q) = (exact.parameters.clone(), exact.q.clone());
        if let Some(DistanceOrigin { at, value }) = self.origin {
            q[at] = q[at] - value;
        }
        let mut v = vec![DoubleDouble::int(0); system.lengths().variables];
        match &exact.motion {
            InitialMotion::Rates(rates) if self.by.formulation().is_some_and(Formulation::is_in_rates) => {
                v.clone_from(rates);
            }
            _ => system.motion_variables(&p, &q, &exact_start_speeds(self.model, exact.into())?, &mut v),
        }
        Ok((p, [q, v].concat()))
    }

    /// Quantities that the scene shows at time `t`, s, in the integrated state `y`, to 32 digits. For
    /// reduced equations they are the outputs of the scene. Otherwise they are the coordinates, followed
    /// by the generalized speeds. `p` are the parameters.
    #[must_use]
    pub fn extended_state(&self, p: &[DoubleDouble], t: f64, y: &[DoubleDouble]) -> Vec<DoubleDouble> {
        let system = self.code.extended();
        let (q, v) = y.split_at(system.lengths().coordinates);
        if self.by.is_reduced() {
            let mut out = vec![DoubleDouble::int(0); system.output_count()];
            let elapsed = DoubleDouble::from_f64(t) - DoubleDouble::from_f64(self.scene.span.0);
            system.outputs(p, elapsed, q, v, &mut out);
            return out;
        }
        let mut u = vec![DoubleDouble::int(0); system.lengths().speeds];
        system.generalized_speeds(p, q, v, &mut u);
        let mut q = q.to_vec();
        if let Some(DistanceOrigin { at, value }) = self.origin {
            q[at] = q[at] + value;
        }
        [q, u].concat()
    }

    /// Quantities that the scene shows at time `t`, s, in an integrated state `y` given in doubles. A
    /// coordinate that is integrated as a distance from a singular surface keeps all digits of this
    /// distance. See [`Self::shown_state`].
    #[must_use]
    pub fn precise_state(&self, t: f64, y: &[f64]) -> Vec<DoubleDouble> {
        let wide = |list: Vec<f64>| list.into_iter().map(DoubleDouble::from_f64).collect::<Vec<_>>();
        if self.by.is_reduced() {
            return self.extended_state(&self.scene.exact.parameters, t, &wide(y.to_vec()));
        }
        let mut state = wide(self.shown_state(t, y));
        if let Some(DistanceOrigin { at, value }) = self.origin {
            state[at] = DoubleDouble::from_f64(y[at]) + value;
        }
        state
    }
}
