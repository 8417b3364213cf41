//! Motion constraints: speeds that are held at zero.
//!
//! With the n definitions u = J q̇ + d some of which are held at zero, the rows of those are the constraints A q̇ + a =
//! 0, and
//!
//! ```text
//! [ J ]        [ u − d ]
//! [ A ] q̇  =  [  −a   ]
//! ```
//!
//! has the solution q̇ = W u + w of the model without constraints, with those speeds put to zero: W loses their
//! columns. So what the kinematic equations divide by stays what it was.

use super::{Model, MotionConstraint};
use crate::algebra::calculus::Substitution;
use crate::algebra::{Arena, Expr};

impl Model {
    /// The mechanism in which these speeds are zero at all times, as wheels that roll hold the velocities at which they
    /// would slip. They leave the speeds and become motion constraints; p speeds are left for n coordinates.
    ///
    /// # Errors
    /// The first name that is no speed, or all of them if no speed would be left.
    pub fn holding(mut self, names: &[&str]) -> Result<Self, String> {
        if let Some(unknown) = names.iter().find(|name| !self.speeds.iter().any(|speed| speed.name == **name)) {
            return Err(format!("there is no speed `{unknown}`"));
        }
        let (held, speeds): (Vec<_>, Vec<_>) =
            std::mem::take(&mut self.speeds).into_iter().partition(|speed| names.contains(&speed.name.as_str()));
        if speeds.is_empty() {
            return Err("no speed is left".to_owned());
        }
        let zeros: Vec<(Expr, Expr)> =
            held.iter().flat_map(|s| [(s.symbol, Expr::ZERO), (s.rate, Expr::ZERO)]).collect();
        let mut put = Substitution::new(&zeros);
        self.speeds = speeds;
        self.change(&mut |arena, e| *e = put.apply(arena, *e));
        let constraints =
            held.into_iter().map(|s| MotionConstraint { name: s.name, equation: s.definition, unit: s.unit });
        self.motion_constraints.extend(constraints);
        Ok(self)
    }

    /// Rewrites what may mention speeds: loads, the domain, and the solved kinematic equations.
    fn change(&mut self, rewrite: &mut dyn FnMut(&mut Arena, &mut Expr)) {
        let Self { arena, forces, torques, domain, kinematic_equations, .. } = self;
        let loads = forces.iter_mut().map(|f| &mut f.vector).chain(torques.iter_mut().map(|t| &mut t.vector));
        let conditions = domain.iter_mut().map(|condition| &mut condition.positive);
        for e in loads.flatten().chain(conditions).chain(&mut kinematic_equations.rates) {
            rewrite(arena, e);
        }
    }
}
