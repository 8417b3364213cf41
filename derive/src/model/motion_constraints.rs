//! Motion constraints: what ties velocities together.
//!
//! With p generalized speeds u = J q̇ + d and m motion constraints A q̇ + a = 0, p + m = n, the rates of the n coordinates
//! follow from
//!
//! ```text
//! [ A ]        [  −a   ]
//! [ J ] q̇  =  [ u − d ]
//! ```
//!
//! as q̇ = W u + w. An equation between coordinates that none can be solved from ties their rates by its time derivative.

use super::constraint::Stated;
use super::elements::Elements;
use super::loading::Loading;
use super::names::Kind;
use super::velocities::NamedVelocity;
use super::{Coordinate, Loop, MotionConstraint, Speed, Tie};
use crate::algebra::calculus::{Differential, Substitution};
use crate::algebra::linear::LinearForm;
use crate::algebra::modular::{ZeroTest, zero_test};
use crate::algebra::parse::VelocityOf;
use crate::algebra::rank::rank;
use crate::algebra::simplify::Simplifier;
use crate::algebra::{Arena, Expr};
use crate::diagnostic::shown;
use crate::geometry::{Frames, Motion, Vector};
use crate::read::Located;
use std::ops::Range;
use toml::de::DeTable;

/// That a body rolls, as the file states it.
pub struct StatedRolling {
    name: Located,
    body: usize,
    point: usize,
    against: Option<usize>,
    frame: usize,
}

/// An equation A q̇ + a = 0 before it is known to say something new.
struct Candidate {
    name: String,
    equation: Expr,
    tie: Tie,
    enforced_by: Option<usize>,
    span: Range<usize>,
}

/// What motion constraints are made of.
pub struct Tied<'m> {
    pub coordinates: &'m [Coordinate],
    pub speeds: &'m [Speed],
    pub velocities: &'m [NamedVelocity],
    /// Equations between coordinates that were not solved.
    pub kept: Vec<Stated>,
    /// Equations between velocities.
    pub stated: Vec<Stated>,
    pub rolling: Vec<StatedRolling>,
}

/// Motion constraints, with their places in the file, and the equations between coordinates that some are of.
#[derive(Default)]
pub struct Ties {
    pub motion: Vec<(MotionConstraint, Range<usize>)>,
    pub loops: Vec<Loop>,
}

impl<'a> Loading<'a> {
    /// Reads `[rolling.NAME]`.
    pub fn rolling(&mut self, table: &'a DeTable<'a>, elements: &Elements) -> Vec<StatedRolling> {
        let mut list = Vec::new();
        for (name, value) in self.section(table, "rolling", &[]) {
            let example = "[rolling.NAME] with body = \"wheel\" and at = \"P\"";
            let Some((entry, what)) = self.entry(&name, value, Kind::Constraint, None, example) else { continue };
            self.reader.allow(entry, &what, &["body", "at", "against", "frame", "about"]);
            let mut named = |key: &str, needed: bool| {
                let value =
                    if needed { self.reader.need(entry, key, &what, &name.span) } else { self.reader.get(entry, key) };
                let stated = self.reader.string(value?, &format!("`{key}`"))?;
                let body = elements.body(self, &stated)?;
                if elements.bodies[body].rigid.is_none() {
                    let message = format!("the particle `{}` cannot roll", shown(&stated.text));
                    self.reader.error(
                        stated.span,
                        message,
                        "name a rigid body, or hold a velocity under [constraints]",
                    );
                    return None;
                }
                Some(body)
            };
            let (body, against) = (named("body", true), named("against", false));
            let point = elements.point(self, entry, "at", &what, &name.span);
            let frame = match self.reader.get(entry, "frame") {
                Some(_) => elements.frame(self, entry, &what, &name.span),
                None => Some(0),
            };
            if let (Some(body), Some(point), Some(frame)) = (body, point, frame) {
                list.push(StatedRolling { name, body, point, against, frame });
            }
        }
        list
    }

    /// The motion constraints of a mechanism whose frames and points are without errors, each independent of those before
    /// it; reports what contradicts or repeats others.
    pub fn ties(&mut self, elements: &Elements, tied: Tied<'_>) -> Option<Ties> {
        let before = self.reader.errors.len();
        let Tied { coordinates, speeds, velocities, kept, stated, rolling } = tied;
        let mut loops = Vec::new();
        let mut candidates = Vec::new();
        let rates: Vec<_> = coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        let mut d_dt = Differential::along(&rates);
        let mut simplifier = Simplifier::default();
        for Stated { name, equation, enforced_by, span } in kept {
            let rate = d_dt.apply(&mut self.arena, equation);
            let rate = simplifier.simplify(&mut self.arena, rate);
            candidates.push(Candidate {
                name: name.clone(),
                equation: rate,
                tie: Tie::Loop(loops.len()),
                enforced_by,
                span,
            });
            let unit = self.unit_of_difference(equation);
            loops.push(Loop { name, equation, unit });
        }
        if !stated.is_empty() || !rolling.is_empty() {
            let mut tree = Frames::new(&elements.frames);
            let motion = Motion::new(&mut self.arena, &mut tree, &elements.frames, &elements.points, &mut d_dt);
            let mut slips = Slips { elements, frames: tree, motion, simplifier };
            let values: Vec<_> = velocities.iter().map(|v| (v.symbol, slips.velocity(&mut self.arena, v))).collect();
            let definitions = speeds.iter().map(|s| (s.symbol, s.definition));
            let mut put = Substitution::new(&values.into_iter().chain(definitions).collect::<Vec<_>>());
            for Stated { name, equation, enforced_by, span } in stated {
                let equation = put.apply(&mut self.arena, equation);
                candidates.push(Candidate { name, equation, tie: Tie::Stated, enforced_by, span });
            }
            for rolling in rolling {
                for (axis, equation) in slips.of(&mut self.arena, &rolling).into_iter().enumerate() {
                    let name = format!("{}_{}", rolling.name.text, axis + 1);
                    let span = rolling.name.span.clone();
                    candidates.push(Candidate { name, equation, tie: Tie::Rolling, enforced_by: None, span });
                }
            }
        }
        let motion = self.independent(coordinates, candidates);
        (self.reader.errors.len() == before).then_some(Ties { motion, loops })
    }

    /// Those that say something new. Of a body that rolls, what follows from the others is left out: that the ground is not
    /// penetrated is often built into the coordinates.
    fn independent(
        &mut self,
        coordinates: &[Coordinate],
        candidates: Vec<Candidate>,
    ) -> Vec<(MotionConstraint, Range<usize>)> {
        let rates: Vec<Expr> = coordinates.iter().map(|c| c.rate).collect();
        let mut form = LinearForm::new(&rates);
        let mut rows: Vec<Vec<Expr>> = Vec::new();
        let mut constraints = Vec::new();
        for Candidate { name, equation, tie, enforced_by, span } in candidates {
            let (row, rest) = match form.coefficients(&mut self.arena, equation) {
                Ok(linear) => linear,
                Err(not_linear) => {
                    let of = self.arena.symbol_name(not_linear.symbol).unwrap_or_default();
                    let message = format!(
                        "the constraint `{name}` is not linear in velocities: its slope along {of} depends on them"
                    );
                    self.reader.error(span, message, "a motion constraint must read  Σ a_i(q) q_i' + a(q) = 0");
                    continue;
                }
            };
            let is_zero = |arena: &Arena, e: &Expr| zero_test(arena, *e) == ZeroTest::Zero;
            let says_nothing = row.iter().all(|e| is_zero(&self.arena, e));
            let augmented: Vec<Expr> = row.iter().copied().chain([rest]).collect();
            if says_nothing {
                match (tie, is_zero(&self.arena, &rest)) {
                    (Tie::Rolling, true) => {}
                    (_, true) => self.repeated(&name, span, "is always fulfilled"),
                    (_, false) => self.repeated(&name, span, "is never fulfilled"),
                }
                continue;
            }
            rows.push(augmented);
            let of_rates: Vec<Vec<Expr>> = rows.iter().map(|row| row[..rates.len()].to_vec()).collect();
            let is_new = rank(&self.arena, &of_rates).is_some_and(|found| found.dependent.is_none());
            if is_new {
                let unit = self.unit_of_difference(equation);
                let stated = Located { text: format!("lambda_{name}"), span: span.clone(), exact: false };
                let multiplier = self.arena.symbol(&stated.text);
                self.names.declare(&mut self.reader, &stated, Kind::Multiplier, Some(multiplier));
                constraints.push((MotionConstraint { name, equation, unit, multiplier, tie, enforced_by }, span));
                continue;
            }
            let contradicts = rank(&self.arena, &rows).is_some_and(|found| found.dependent.is_none());
            rows.pop();
            match (tie, contradicts) {
                (_, true) => self.repeated(&name, span, "contradicts those before it"),
                (Tie::Rolling, false) => {}
                (_, false) => self.repeated(&name, span, "follows from those before it"),
            }
        }
        constraints
    }

    fn repeated(&mut self, name: &str, span: Range<usize>, how: &str) {
        self.reader.error(span, format!("the constraint `{name}` {how}"), "remove it, or correct one of the others");
    }

    /// The unit of what is zero, in which sums were checked when they were read.
    fn unit_of_difference(&self, e: Expr) -> super::Unit {
        super::units::unit_of(&self.arena, e, &self.units).ok().flatten().unwrap_or_default()
    }
}

/// Velocities of material on material.
struct Slips<'e> {
    elements: &'e Elements,
    frames: Frames,
    motion: Motion,
    simplifier: Simplifier,
}

impl Slips<'_> {
    /// A velocity that a formula names, in q and q̇.
    fn velocity(&mut self, arena: &mut Arena, name: &NamedVelocity) -> Expr {
        let velocity = match name.of {
            VelocityOf::Material(body, point) => self.material(arena, body, point),
            VelocityOf::Point(point) => self.motion.linear[point].clone(),
            VelocityOf::Turning(frame) => self.motion.angular[frame].clone(),
        };
        self.component(arena, &velocity, name.frame, name.axis)
    }

    fn component(&mut self, arena: &mut Arena, velocity: &Vector, frame: usize, axis: usize) -> Expr {
        let component = self.frames.component(arena, velocity, frame, axis);
        self.simplifier.simplify(arena, component)
    }

    /// The velocity of the material of a body at a point.
    fn material(&mut self, arena: &mut Arena, body: usize, point: usize) -> Vector {
        let body = &self.elements.bodies[body];
        match &body.rigid {
            Some((frame, _)) => self.motion.of_material(arena, &mut self.frames, (*frame, body.centre), point),
            None => self.motion.linear[body.centre].clone(),
        }
    }

    /// The velocity at which a body slips on another or on the ground, by components.
    fn of(&mut self, arena: &mut Arena, rolling: &StatedRolling) -> [Expr; 3] {
        let mut slip = self.material(arena, rolling.body, rolling.point);
        if let Some(other) = rolling.against {
            let back = self.material(arena, other, rolling.point).neg(arena);
            slip = slip.add(arena, &back);
        }
        [0, 1, 2].map(|axis| self.component(arena, &slip, rolling.frame, axis))
    }
}
