//! Rigid motions of the whole system, or of a single body, that the constraints permit.
//!
//! A field ξ(q) is the rotation of a set of bodies about an axis e through a point S if, with q̇ =
//! ξ: every moved frame has ω = e, every moved mass centre has v = e × (r − r_S), and all other
//! bodies are at rest. This is a linear system for ξ with more rows than unknowns. The motion is
//! permitted if and only if the system is consistent.

use super::integral_kind::{IntegralKind, Pivot};
use super::noether::VectorField;
use crate::algebra::solve::block_systems::solve_blocks;
use crate::algebra::term::calculus::Differential;
use crate::algebra::value::rank::independent_rows;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Expr, Rational};
use crate::geometry::Vector;
use crate::mechanics::Kinematics;
use crate::model::Model;

/// Rigid motion, given by the velocities of all bodies at unit rate.
struct Motion {
    /// Kind of the momentum that belongs to the motion.
    kind: IntegralKind,
    /// Angular velocity ω of each body and velocity v of its mass centre; `None` for a body at rest.
    of_body: Vec<Option<(Vector, Vector)>>,
}

/// Largest number of bodies of a model for which motions of single bodies are also tried.
const MOST_BODIES: usize = 8;

/// Vector fields of all permitted rigid motions. The whole system translates along the inertial
/// axes, or rotates about them through the mass centre or the origin. Each single body translates
/// along the inertial axes, rotates about them through its mass centre, or rotates about its own
/// axes.
pub fn rigid_motion_fields(model: &Model, kinematics: &mut Kinematics) -> Vec<VectorField> {
    let mut candidates = rigid_motions_of_system(model, kinematics);
    if (2..=MOST_BODIES).contains(&model.bodies.len()) {
        candidates.extend((0..model.bodies.len()).flat_map(|body| rigid_motions_of_body(model, body)));
    }
    let rows = Rows::new(model, kinematics);
    candidates.iter().filter_map(|motion| rows.rigid_motion_field(model, kinematics, motion)).collect()
}

/// Unit vector along axis 0, 1 or 2 of the inertial frame.
fn rigid_motion_axis(i: usize) -> Vector {
    let mut components = [Expr::ZERO; 3];
    components[i] = Expr::ONE;
    Vector::in_frame(0, components)
}

/// Candidate rigid motions of the whole system: three translations, three rotations about axes
/// through the mass centre, and three about axes through the origin.
fn rigid_motions_of_system(model: &Model, kinematics: &mut Kinematics) -> Vec<Motion> {
    let mut list = Vec::new();
    for i in 0..3 {
        let of_body = vec![Some((Vector::default(), rigid_motion_axis(i))); model.bodies.len()];
        list.push(Motion { kind: IntegralKind::Linear(i), of_body });
    }
    let centre = mass_centre(model, kinematics);
    for (through, about) in [(Pivot::MassCentre, centre), (Pivot::Origin, Vector::default())] {
        for at in 0..3 {
            let back = about.neg(&mut kinematics.arena);
            let mut of_body = Vec::new();
            for body in &model.bodies {
                let arm = kinematics.positions[body.centre].add(&mut kinematics.arena, &back);
                let velocity = kinematics.frames.cross(&mut kinematics.arena, &rigid_motion_axis(at), &arm);
                of_body.push(Some((rigid_motion_axis(at), velocity)));
            }
            list.push(Motion { kind: IntegralKind::Angular { axis: at, through }, of_body });
        }
    }
    list
}

/// Candidate rigid motions of a single body, while all other bodies are at rest.
fn rigid_motions_of_body(model: &Model, body: usize) -> Vec<Motion> {
    let only = |moved: (Vector, Vector)| {
        (0..model.bodies.len()).map(|b| (b == body).then(|| moved.clone())).collect::<Vec<_>>()
    };
    let mut list = Vec::new();
    for i in 0..3 {
        let kind = IntegralKind::LinearOfBody { body, axis: i };
        list.push(Motion { kind, of_body: only((Vector::default(), rigid_motion_axis(i))) });
        let kind = IntegralKind::AngularOfBody { body, axis: i };
        list.push(Motion { kind, of_body: only((rigid_motion_axis(i), Vector::default())) });
    }
    if let Some((_, inertia)) = &model.bodies[body].rigid {
        for i in 0..3 {
            let mut own = [Expr::ZERO; 3];
            own[i] = Expr::ONE;
            let own = Vector::in_frame(inertia.frame, own);
            let kind = IntegralKind::Spin { body, axis: i };
            list.push(Motion { kind, of_body: only((own, Vector::default())) });
        }
    }
    list
}

/// Mass centre r_S = Σ m r / Σ m of the whole system, from the origin, m.
fn mass_centre(model: &Model, kinematics: &mut Kinematics) -> Vector {
    let masses: Vec<Expr> = model.bodies.iter().map(|b| b.mass).collect();
    let arena = &mut kinematics.arena;
    let total = arena.sum(&masses);
    let mut sum = Vector::default();
    for body in &model.bodies {
        let share = arena.div(body.mass, total).unwrap_or(Expr::ZERO);
        let share = kinematics.simplifier.simplify(arena, share);
        let term = kinematics.positions[body.centre].scale(arena, share);
        sum = sum.add(arena, &term);
    }
    sum
}

/// Label of a row: the velocity component of a body that it computes.
#[derive(Clone, Copy)]
struct RowLabel {
    /// Index of the body in the model.
    body: usize,
    /// True for the angular velocity ω, false for the velocity v of the mass centre.
    is_angular: bool,
    /// Index of the frame along whose axis the component is taken.
    frame: usize,
    /// Axis of the frame: 0, 1 or 2.
    axis: usize,
}

/// Rows of linear forms in the rates q̇: components of ω and v of all bodies, and the rates of the
/// loop equations.
struct Rows {
    /// Velocity component of each row; `None` for the row of a loop.
    labels: Vec<Option<RowLabel>>,
    /// Coefficients of q̇, a row for each velocity component or loop.
    matrix: Vec<Vec<Expr>>,
    /// Indices of independent rows, as many as there are coordinates. There are fewer if the rows
    /// do not determine q̇.
    chosen: Vec<usize>,
}

impl Rows {
    /// Computes the rows as derivatives of the bodies' velocities and of the loop equations, and
    /// selects independent rows.
    fn new(model: &Model, kinematics: &mut Kinematics) -> Self {
        let velocities = kinematics.in_rates.clone();
        let mut partials: Vec<Differential> = model.q_dot().into_iter().map(Differential::partial).collect();
        let (mut labels, mut matrix) = (Vec::new(), Vec::new());
        for (at, body) in model.bodies.iter().enumerate() {
            let turning = body.rigid.as_ref().map(|(own, inertia)| (&velocities.angular[*own], inertia.frame, true));
            let moving = (&velocities.linear[body.centre], 0, false);
            for (vector, frame, is_angular) in turning.into_iter().chain([moving]) {
                let Kinematics { arena, frames, simplifier, .. } = &mut *kinematics;
                let components = frames.express(arena, vector, frame);
                for (axis, e) in components.into_iter().enumerate() {
                    let row: Vec<Expr> = partials
                        .iter_mut()
                        .map(|partial| {
                            let slope = partial.apply(arena, e);
                            simplifier.simplify(arena, slope)
                        })
                        .collect();
                    labels.push(Some(RowLabel { body: at, is_angular, frame, axis }));
                    matrix.push(row);
                }
            }
        }
        // There are more coordinates than motions of the bodies if loops tie coordinates, as for
        // Euler parameters.
        for of_loop in &model.loops {
            let Kinematics { arena, simplifier, .. } = &mut *kinematics;
            let row = model.q().into_iter().map(|q| {
                let slope = Differential::partial(q).apply(arena, of_loop.equation);
                simplifier.simplify(arena, slope)
            });
            labels.push(None);
            matrix.push(row.collect());
        }
        // Short rows are preferred, so that the solution is short.
        let arena = &kinematics.arena;
        let mut order: Vec<usize> = (0..matrix.len()).collect();
        order.sort_by_key(|at| arena.reachable(&matrix[*at]).len());
        let sorted: Vec<Vec<Expr>> = order.iter().map(|at| matrix[*at].clone()).collect();
        let chosen = independent_rows(arena, &sorted).unwrap_or_default();
        Self { labels, matrix, chosen: chosen.into_iter().map(|at| order[at]).collect() }
    }

    /// Vector field ξ of a rigid motion. `None` if the constraints do not permit the motion, if ξ
    /// is zero, or if the rows do not determine q̇.
    fn rigid_motion_field(&self, model: &Model, kinematics: &mut Kinematics, motion: &Motion) -> Option<VectorField> {
        let n = model.coordinates.len();
        if self.chosen.len() != n {
            return None;
        }
        let mut wanted = Vec::new();
        for label in &self.labels {
            let of_body = label.and_then(|label| Some((label, motion.of_body[label.body].as_ref()?)));
            let value = of_body.map_or(Expr::ZERO, |(label, (omega, v))| {
                let vector = if label.is_angular { omega } else { v };
                kinematics.frames.express(&mut kinematics.arena, vector, label.frame)[label.axis]
            });
            wanted.push(kinematics.simplifier.simplify(&mut kinematics.arena, value));
        }
        let Kinematics { arena, simplifier, .. } = kinematics;
        let a: Vec<Vec<Expr>> = self.chosen.iter().map(|at| self.matrix[*at].clone()).collect();
        let b: Vec<Expr> = self.chosen.iter().map(|at| wanted[*at]).collect();
        let (xi, _) = solve_blocks(arena, simplifier, &a, &b, None, None).ok()?;
        let consistent = self.matrix.iter().zip(&wanted).enumerate().all(|(at, (row, value))| {
            if self.chosen.contains(&at) {
                return true;
            }
            let mut terms: Vec<(Expr, Rational)> =
                row.iter().zip(&xi).map(|(a, x)| (arena.mul(*a, *x), Rational::ONE)).collect();
            terms.push((*value, Rational::MINUS_ONE));
            let residual = arena.linear_combination(&terms);
            zero_test(arena, residual) == ZeroTest::Zero
        });
        (consistent && xi.iter().any(|e| *e != Expr::ZERO)).then_some(VectorField { kind: motion.kind, xi })
    }
}
