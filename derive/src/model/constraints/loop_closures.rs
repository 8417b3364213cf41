//! Rates of a mechanism with long loops. Each joint gives the rates of its coordinates from its own speeds, and the
//! closures of loops give some of these speeds from the others.
//!
//! The closures are differentiated as vectors: a part of a vector that is fixed in a frame has the rate ω × part. So
//! the rate of a closure is as long as the path of bodies around its loop. The derivative of the written-out closure
//! would be as long as the products of all rotations on this path.
//!
//! Source: J. Wittenburg, *Dynamics of Multibody Systems* (2008), § 5.6 (closed loops, constraints in joint variables).

use super::configuration_constraints::Closure;
use super::motion_constraints::MotionConstraints;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::block_systems::solve_blocks;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::solve::pivot_values::PivotValues;
use crate::algebra::solve::system_labels::SystemLabels;
use crate::algebra::term::calculus::{Differential, Substitution, expand_names};
use crate::algebra::term::contraction::contract_products;
use crate::algebra::text::print::length_up_to_names;
use crate::algebra::value::rank::rank;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::geometry::{Frames, Vector, angular_velocities};
use crate::model::bodies::elements::Elements;
use crate::model::reading::loading::Loading;
use crate::model::{Coordinate, KinematicEquations, Speed};

/// Length of all closures above which their derivatives are not written out, in printed nodes.
const LONG_CLOSURES: usize = 300;

/// Constraints of a mechanism with loops, split by what they determine.
struct SplitConstraints<'m> {
    /// Dependent speeds that the loops determine.
    unknowns: Vec<&'m Speed>,
    /// Indices of the constraints that complete the rates of single joints.
    of_joints: Vec<usize>,
    /// Indices of the constraints that couple joints.
    of_loops: Vec<usize>,
}

/// Mechanism whose loops are to be solved for dependent speeds.
pub struct LoopMechanism<'m> {
    /// Coordinates of the mechanism.
    pub coordinates: &'m [Coordinate],
    /// Frames and points of the mechanism.
    pub elements: &'m Elements,
    /// Generalized speeds.
    pub speeds: Vec<&'m Speed>,
    /// Speeds of joints that follow from the generalized speeds.
    pub dependent: &'m [Speed],
    /// Motion constraints of the mechanism.
    pub constraints: &'m MotionConstraints,
    /// Equations of closing joints, as components of vectors.
    pub closures: &'m [Closure],
    /// Values near which pivots are chosen; `None` if no values are known.
    pub point: Option<&'m PivotValues>,
}

impl Loading<'_> {
    /// Rates of a mechanism whose loops are long. `None` if its loops are short, or if they do not determine its
    /// dependent speeds.
    pub fn rates_of_long_loops(&mut self, mechanism: &LoopMechanism<'_>) -> Option<KinematicEquations> {
        if !mechanism.has_long_closures(&self.arena) {
            return None;
        }
        let (rates, divisors) = mechanism.rates(&mut self.arena)?;
        if !mechanism.satisfy(&mut self.arena, &rates) {
            return None;
        }
        let divisors: Vec<Expr> = divisors.into_iter().map(|e| contract_products(&mut self.arena, e)).collect();
        let divisors = self.speed_divisor_factors(&divisors, mechanism.coordinates);
        Some(KinematicEquations { rates, divisors, has_dependent_speeds: true })
    }
}

impl LoopMechanism<'_> {
    /// True if the equations of closing joints are so long that their derivatives should not be written out.
    fn has_long_closures(&self, arena: &Arena) -> bool {
        let is_closure = |name: &String| self.closures.iter().any(|closure| closure.name == *name);
        let lengths = self
            .constraints
            .loops
            .iter()
            .filter(|c| is_closure(&c.name))
            .map(|c| length_up_to_names(arena, c.equation));
        let sum: usize = lengths.fold(0, usize::saturating_add);
        !self.dependent.is_empty() && sum > LONG_CLOSURES
    }

    /// True if the given rates, in q and the generalized speeds, fulfil every motion constraint and the definition of
    /// every generalized speed. Each equation is proved modulo random primes.
    fn satisfy(&self, arena: &mut Arena, rates: &[Expr]) -> bool {
        let pairs: Vec<(Expr, Expr)> = self.coordinates.iter().map(|c| c.rate).zip(rates.iter().copied()).collect();
        let mut put = Substitution::new(&pairs);
        let mut is_zero = |arena: &mut Arena, e: Expr| {
            let e = put.apply(arena, e);
            zero_test(arena, e) == ZeroTest::Zero
        };
        self.constraints.motion.iter().all(|(constraint, _)| is_zero(arena, constraint.equation))
            && self.speeds.iter().all(|speed| {
                let excess = arena.sub(speed.definition, speed.symbol);
                is_zero(arena, excess)
            })
    }

    /// Rates q̇ of the coordinates as terms in q and the generalized speeds, then the divisors. The loops are solved
    /// for the dependent speeds. `None` if the definitions of the speeds do not determine the rates joint by joint, or
    /// if the loops do not determine the dependent speeds.
    fn rates(&self, arena: &mut Arena) -> Option<(Vec<Expr>, Vec<Expr>)> {
        let mut simplifier = Simplifier::default();
        let SplitConstraints { unknowns: dependent, of_joints, of_loops } = self.split_constraints(arena)?;
        let all: Vec<&Speed> = self.speeds.iter().chain(&dependent).copied().collect();
        // Rates of the coordinates, joint by joint, from all speeds.
        let rates: Vec<Expr> = self.coordinates.iter().map(|c| c.rate).collect();
        let mut form = LinearForm::new(&rates);
        let (mut matrix, mut right) = (Vec::new(), Vec::new());
        for speed in &all {
            let (row, rest) = form.coefficients(arena, speed.definition).ok()?;
            matrix.push(row);
            right.push(arena.sub(speed.symbol, rest));
        }
        for at in of_joints {
            let (row, rest) = form.coefficients(arena, self.constraints.motion[at].0.equation).ok()?;
            matrix.push(row);
            right.push(arena.neg(rest));
        }
        let (by_joints, mut divisors) = solve_blocks(arena, &mut simplifier, &matrix, &right, None, None).ok()?;
        // Dependent speeds from the loops.
        let unknowns: Vec<Expr> = dependent.iter().map(|speed| speed.symbol).collect();
        let names: Vec<String> = of_loops.iter().map(|at| self.constraints.motion[*at].0.name.clone()).collect();
        let equations = self.closure_rates(arena, &of_loops, &by_joints, &unknowns);
        let mut form = LinearForm::new(&unknowns);
        let (mut matrix, mut right) = (Vec::new(), Vec::new());
        for equation in equations {
            let (row, rest) = form.coefficients(arena, equation).ok()?;
            matrix.push(row.into_iter().map(|e| simplifier.simplify(arena, e)).collect());
            right.push(arena.neg(rest));
        }
        let labels = SystemLabels {
            rows: names,
            unknowns: dependent.iter().map(|speed| speed.name.clone()).collect(),
            symbols: Vec::new(),
        };
        let (values, of_blocks) =
            solve_blocks(arena, &mut simplifier, &matrix, &right, self.point, Some(&labels)).ok()?;
        divisors.extend(of_blocks);
        let pairs: Vec<(Expr, Expr)> = unknowns.into_iter().zip(values).collect();
        let mut put = Substitution::new(&pairs);
        let rates = by_joints.into_iter().map(|e| put.apply(arena, e)).collect();
        Some((rates, divisors))
    }

    /// Splits the motion constraints into those that only complete the rates of single joints, such as the norm of
    /// Euler parameters, and those that couple joints. A dependent speed whose definition follows from the speeds
    /// before it, because a constraint determines its coordinate, is no unknown. `None` if the speeds and constraints
    /// do not determine the rates, or if the loops are not as many as the unknowns.
    fn split_constraints(&self, arena: &mut Arena) -> Option<SplitConstraints<'_>> {
        let rates: Vec<Expr> = self.coordinates.iter().map(|c| c.rate).collect();
        let mut form = LinearForm::new(&rates);
        let mut rows = Vec::new();
        for speed in &self.speeds {
            rows.push(form.coefficients(arena, speed.definition).ok()?.0);
        }
        let mut split = SplitConstraints { unknowns: Vec::new(), of_joints: Vec::new(), of_loops: Vec::new() };
        let mut is_new = |arena: &mut Arena, e: Expr| {
            rows.push(form.coefficients(arena, e).ok()?.0);
            let is_new = rank(arena, &rows)?.dependent.is_none();
            if !is_new {
                rows.pop();
            }
            Some(is_new)
        };
        for speed in self.dependent {
            if is_new(arena, speed.definition)? {
                split.unknowns.push(speed);
            }
        }
        for (at, (constraint, _)) in self.constraints.motion.iter().enumerate() {
            let is_closure = self.closures.iter().any(|closure| closure.name == constraint.name);
            let completes = !is_closure && is_new(arena, constraint.equation)?;
            (if completes { &mut split.of_joints } else { &mut split.of_loops }).push(at);
        }
        (rows.len() == rates.len() && split.of_loops.len() == split.unknowns.len()).then_some(split)
    }

    /// Rates of the given constraints, as terms in q and all speeds. `by_joints` are the rates of the coordinates in
    /// all speeds.
    ///
    /// Three components of one vector vanish along every three axes if they vanish along the joint's. They are taken
    /// in the frame in which the factors of the dependent speeds are shortest.
    fn closure_rates(&self, arena: &mut Arena, of_loops: &[usize], by_joints: &[Expr], unknowns: &[Expr]) -> Vec<Expr> {
        let pairs: Vec<(Expr, Expr)> =
            self.coordinates.iter().map(|c| c.symbol).zip(by_joints.iter().copied()).collect();
        let mut d_dt = Differential::along(&pairs);
        let pairs: Vec<(Expr, Expr)> = self.coordinates.iter().map(|c| c.rate).zip(by_joints.iter().copied()).collect();
        let mut in_speeds = Substitution::new(&pairs);
        let mut frames = Frames::new(&self.elements.frames);
        frames.carries = true;
        let angular = angular_velocities(arena, &self.elements.frames, &mut d_dt);
        let closure_of =
            |at: usize| self.closures.iter().find(|closure| closure.name == self.constraints.motion[at].0.name);
        let mut rates: Vec<Option<Expr>> = vec![None; of_loops.len()];
        for (place, at) in of_loops.iter().enumerate() {
            if rates[place].is_some() {
                continue;
            }
            let Some(closure) = closure_of(*at) else {
                rates[place] = Some(in_speeds.apply(arena, self.constraints.motion[*at].0.equation));
                continue;
            };
            let own = angular[closure.frame].neg(arena);
            let relative: Vec<Vector> = angular.iter().map(|omega| omega.add(arena, &own)).collect();
            let rate = frames.time_derivative(arena, &closure.vector, &relative, &mut d_dt);
            let group: Vec<(usize, usize)> = of_loops
                .iter()
                .enumerate()
                .filter_map(|(place, at)| closure_of(*at).map(|closure| (place, closure)))
                .filter(|(_, other)| other.is_beside(closure))
                .map(|(place, other)| (place, other.axis))
                .collect();
            let frame = if group.len() == 3 {
                frame_of_shortest_factors(arena, &frames, &rate, closure, unknowns)
            } else {
                closure.frame
            };
            let components = frames.express_frame_by_frame(arena, &rate, frame, "v", &closure.joint);
            for (place, axis) in group {
                rates[place] = Some(components[axis]);
            }
        }
        rates.into_iter().map(|rate| rate.unwrap_or(Expr::ZERO)).collect()
    }
}

/// Frame, among those of the parts of a closure's rate and the closure's own, in which the factors of the
/// unknowns are shortest.
fn frame_of_shortest_factors(
    arena: &mut Arena,
    frames: &Frames,
    rate: &Vector,
    closure: &Closure,
    unknowns: &[Expr],
) -> usize {
    let mut form = LinearForm::new(unknowns);
    let mut length = |arena: &mut Arena, frame: usize| {
        let components = frames.express_frame_by_frame(arena, rate, frame, "v", &closure.joint);
        let mut sum = 0_usize;
        for e in components {
            let Ok((row, _)) = form.coefficients(arena, e) else { return usize::MAX };
            for e in row.into_iter().filter(|e| *e != Expr::ZERO) {
                let e = expand_names(arena, e);
                sum = sum.saturating_add(length_up_to_names(arena, e));
            }
        }
        sum
    };
    let mut best = (closure.frame, length(arena, closure.frame));
    for (frame, _) in &rate.parts {
        let long = length(arena, *frame);
        if long < best.1 {
            best = (*frame, long);
        }
    }
    best.0
}
