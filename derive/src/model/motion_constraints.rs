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
use super::joints::Joints;
use super::loading::Loading;
use super::moving::Moving;
use super::names::{Kind, TIME};
use super::physics::defaults;
use super::{Branch, Coordinate, DependentConstraint, Loop, MotionConstraint, Parameter, Repeated, Rolled, Speed, Tie};
use crate::algebra::calculus::{Differential, Substitution};
use crate::algebra::linear::LinearForm;
use crate::algebra::modular::{ZeroTest, zero_test};
use crate::algebra::rank::rank;
use crate::algebra::simplify::Simplifier;
use crate::algebra::{Arena, Expr};
use crate::diagnostic::shown;
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
    may_repeat: bool,
}

/// What motion constraints are made of, in what is left of the coordinates.
pub struct Tied<'m> {
    pub coordinates: &'m [Coordinate],
    pub speeds: &'m [(Speed, Range<usize>)],
    pub joints: &'m Joints<'m>,
    pub parameters: &'m [Parameter],
    /// Equations between coordinates that were not solved.
    pub kept: Vec<Stated>,
    /// Equations between velocities.
    pub stated: Vec<Stated>,
    /// Components of velocities of bodies that roll.
    pub rolling: Vec<(Stated, Rolled)>,
}

/// What is left of candidates.
struct Independent {
    motion: Vec<(MotionConstraint, Range<usize>)>,
    repeated: Vec<Repeated>,
    /// Loops of joints whose rates follow from the others: they may be closed or open where the others are closed.
    also: Vec<(MotionConstraint, Range<usize>)>,
}

/// Motion constraints, with their places in the file, and the equations between coordinates that some are of.
#[derive(Default)]
pub struct Ties {
    pub motion: Vec<(MotionConstraint, Range<usize>)>,
    pub loops: Vec<Loop>,
    /// Components of rolling that follow from the rest.
    pub repeated: Vec<Repeated>,
    /// Equations between coordinates whose rates follow from those of the others wherever all of them hold.
    pub closed: Vec<Loop>,
    /// What follows from what there.
    pub dependent: Vec<DependentConstraint>,
    /// Where that was asked.
    pub branch: Option<Branch>,
    /// Which speeds of joints to take, by their places among all speeds, where closed poses were found.
    pub speeds: Option<Vec<usize>>,
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

    /// The components of the velocities at which bodies would slip that roll, as equations.
    pub fn slips(
        &mut self,
        moving: &mut Moving,
        elements: &Elements,
        rolling: Vec<StatedRolling>,
    ) -> Vec<(Stated, Rolled)> {
        let mut list = Vec::new();
        for StatedRolling { name, body, point, against, frame } in rolling {
            let span = name.span.clone();
            let mut slip = moving.material(&mut self.arena, elements, body, point);
            if let Some(other) = against {
                let back = moving.material(&mut self.arena, elements, other, point).neg(&mut self.arena);
                slip = slip.add(&mut self.arena, &back);
            }
            for axis in 0..3 {
                let equation = moving.component(&mut self.arena, &slip, frame, axis);
                let name = format!("{}_{}", name.text, axis + 1);
                let stated = Stated { name, equation, enforced_by: None, span: span.clone(), may_repeat: true };
                list.push((stated, Rolled { body, against, point, frame, axis }));
            }
        }
        list
    }

    /// The motion constraints of a mechanism, each independent of those before it; reports what contradicts or repeats
    /// others.
    pub fn ties(&mut self, tied: Tied<'_>) -> Option<Ties> {
        let Tied { coordinates, speeds, joints, parameters, kept, stated, rolling } = tied;
        let clock = coordinates.iter().any(|c| c.name == TIME);
        if !clock && kept.is_empty() && stated.is_empty() && rolling.is_empty() {
            return Some(Ties::default());
        }
        let before = self.reader.errors.len();
        if before > 0 {
            return None;
        }
        let (mut loops, mut candidates) = (Vec::new(), Vec::new());
        let rates: Vec<_> = coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        let mut d_dt = Differential::along(&rates);
        let mut simplifier = Simplifier::default();
        for Stated { name, equation, enforced_by, span, may_repeat } in kept {
            let rate = d_dt.apply(&mut self.arena, equation);
            let rate = simplifier.simplify(&mut self.arena, rate);
            let tie = Tie::Loop(loops.len());
            candidates.push(Candidate { name: name.clone(), equation: rate, tie, enforced_by, span, may_repeat });
            let unit = self.unit_of_difference(equation);
            loops.push(Loop { name, equation, unit, prescribes: false });
        }
        let definitions: Vec<_> = speeds.iter().map(|(s, _)| (s.symbol, s.definition)).collect();
        let mut put = Substitution::new(&definitions);
        let stated = stated.into_iter().map(|c| (c, Tie::Stated));
        for (Stated { name, equation, enforced_by, span, may_repeat }, tie) in
            stated.chain(rolling.into_iter().map(|(c, rolled)| (c, Tie::Rolling(rolled))))
        {
            let equation = put.apply(&mut self.arena, equation);
            candidates.push(Candidate { name, equation, tie, enforced_by, span, may_repeat });
        }
        if let Some(time) = coordinates.iter().find(|c| c.name == TIME) {
            let equation = self.arena.sub(time.rate, Expr::ONE);
            let name = TIME.to_owned();
            candidates.push(Candidate {
                name,
                equation,
                tie: Tie::Clock,
                enforced_by: None,
                span: 0..0,
                may_repeat: false,
            });
        }
        let Independent { mut motion, repeated, also } = self.independent(coordinates, candidates);
        if self.reader.errors.len() > before {
            return None;
        }
        // Loops come first.
        let place = motion.iter().take_while(|(c, _)| matches!(c.tie, Tie::Loop(_))).count();
        let also_at = place..place + also.len();
        motion.splice(place..place, also);
        let mut ties = Ties { motion, loops, repeated, ..Ties::default() };
        let brought: Vec<bool> = speeds.iter().map(|(speed, _)| joints.brings(speed)).collect();
        let speeds: Vec<Expr> = speeds.iter().map(|(speed, _)| speed.definition).collect();
        self.when_closed(coordinates, (&speeds, &brought), (&defaults(parameters), also_at), &mut ties);
        Some(ties)
    }

    /// Those that say something new. Of a body that rolls, what follows from the others is left out: that the ground is not
    /// penetrated is often built into the coordinates.
    fn independent(&mut self, coordinates: &[Coordinate], candidates: Vec<Candidate>) -> Independent {
        let rates: Vec<Expr> = coordinates.iter().map(|c| c.rate).collect();
        let mut form = LinearForm::new(&rates);
        let mut rows: Vec<Vec<Expr>> = Vec::new();
        let (mut constraints, mut repeated, mut also) = (Vec::new(), Vec::new(), Vec::new());
        for Candidate { name, equation, tie, enforced_by, span, may_repeat } in candidates {
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
            let is_of_loop = matches!(tie, Tie::Loop(_));
            let is_zero = |arena: &Arena, e: &Expr| zero_test(arena, *e) == ZeroTest::Zero;
            let says_nothing = row.iter().all(|e| is_zero(&self.arena, e));
            let augmented: Vec<Expr> = row.iter().copied().chain([rest]).collect();
            if says_nothing {
                match (may_repeat, is_zero(&self.arena, &rest)) {
                    (true, true) => repeated.push(Repeated::of(name, tie)),
                    (_, true) => self.repeated(&name, span, "is always fulfilled"),
                    (_, false) => self.repeated(&name, span, "is never fulfilled"),
                }
                continue;
            }
            rows.push(augmented);
            let of_rates: Vec<Vec<Expr>> = rows.iter().map(|row| row[..rates.len()].to_vec()).collect();
            let Some(found) = rank(&self.arena, &of_rates) else {
                self.undecided(&name, span);
                rows.pop();
                continue;
            };
            let is_new = found.dependent.is_none();
            let of_loop = may_repeat && is_of_loop;
            if is_new || of_loop {
                let unit = self.unit_of_difference(equation);
                let drive = if is_zero(&self.arena, &rest) { Expr::ZERO } else { rest };
                let stated = Located { text: format!("lambda_{name}"), span: span.clone(), exact: false };
                let multiplier = self.arena.symbol(&stated.text);
                self.names.declare(&mut self.reader, &stated, Kind::Multiplier, Some(multiplier));
                let list = if is_new { &mut constraints } else { &mut also };
                list.push((MotionConstraint { name, equation, drive, unit, multiplier, tie, enforced_by }, span));
                if !is_new {
                    rows.pop();
                }
                continue;
            }
            let all = rank(&self.arena, &rows).map(|found| found.dependent.is_some());
            rows.pop();
            match (may_repeat, all) {
                (_, None) => self.undecided(&name, span),
                (_, Some(false)) => self.repeated(&name, span, "contradicts those before it"),
                (true, Some(true)) => repeated.push(Repeated::of(name, tie)),
                (_, Some(true)) => self.repeated(&name, span, "follows from those before it"),
            }
        }
        Independent { motion: constraints, repeated, also }
    }

    fn undecided(&mut self, name: &str, span: Range<usize>) {
        let message = format!("it cannot be decided whether the constraint `{name}` follows from those before it");
        self.reader.error(
            span,
            message,
            "none of the random points at which it was asked gives it a value: state it otherwise",
        );
    }

    fn repeated(&mut self, name: &str, span: Range<usize>, how: &str) {
        self.reader.error(span, format!("the constraint `{name}` {how}"), "remove it, or correct one of the others");
    }

    /// The unit of what is zero, in which sums were checked when they were read.
    fn unit_of_difference(&self, e: Expr) -> super::Unit {
        super::units::unit_of(&self.arena, e, &self.units).ok().flatten().unwrap_or_default()
    }
}
