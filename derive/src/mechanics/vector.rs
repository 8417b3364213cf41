//! Vectors as components in several frames at once, and rotations between frames.
//!
//! A vector keeps each contribution in the frame where it is short; frames are joined only by a dot
//! product, through the one rotation that lies between them. Turns about a common axis add their
//! angles first, so a planar chain has cosines of sums, not sums of products.

use crate::algebra::calculus::{Differential, Substitution};
use crate::algebra::simplify::Simplifier;
use crate::algebra::{Arena, Expr};
use crate::model::Frame;
use rustc_hash::FxHashMap;

/// Components in one frame.
pub type Components = [Expr; 3];

/// A vector: components by frame, frames ascending, no frame with all components zero.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Vector {
    /// (frame, components)
    pub parts: Vec<(usize, Components)>,
}

const NOTHING: Components = [Expr::ZERO; 3];

impl Vector {
    /// Components in one frame.
    #[must_use]
    pub fn in_frame(frame: usize, components: Components) -> Self {
        let parts = if components == NOTHING { Vec::new() } else { vec![(frame, components)] };
        Self { parts }
    }

    /// Whether every component is the literal 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.parts.is_empty()
    }

    /// Sum.
    #[must_use]
    pub fn add(&self, arena: &mut Arena, other: &Self) -> Self {
        let mut parts = self.parts.clone();
        for (frame, components) in &other.parts {
            match parts.iter_mut().find(|(f, _)| f == frame) {
                Some((_, mine)) => {
                    for (sum, term) in mine.iter_mut().zip(components) {
                        *sum = arena.add(*sum, *term);
                    }
                }
                None => parts.push((*frame, *components)),
            }
        }
        parts.retain(|(_, components)| *components != NOTHING);
        parts.sort_by_key(|(frame, _)| *frame);
        Self { parts }
    }

    /// Every component mapped.
    #[must_use]
    pub fn map(&self, mut f: impl FnMut(Expr) -> Expr) -> Self {
        let mut parts: Vec<_> = self.parts.iter().map(|(frame, c)| (*frame, c.map(&mut f))).collect();
        parts.retain(|(_, components)| *components != NOTHING);
        Self { parts }
    }

    /// Times a scalar.
    #[must_use]
    pub fn scale(&self, arena: &mut Arena, k: Expr) -> Self {
        self.map(|e| arena.mul(k, e))
    }

    /// The opposite vector.
    #[must_use]
    pub fn neg(&self, arena: &mut Arena) -> Self {
        self.map(|e| arena.neg(e))
    }

    /// Symbols replaced in every component.
    #[must_use]
    pub fn substitute(&self, arena: &mut Arena, substitution: &mut Substitution) -> Self {
        self.map(|e| substitution.apply(arena, e))
    }

    /// Every component differentiated, basis vectors held fixed: a partial derivative, or the time
    /// derivative of a vector whose components all are in the frame it is observed from.
    #[must_use]
    pub fn differentiate(&self, arena: &mut Arena, along: &mut Differential) -> Self {
        self.map(|e| along.apply(arena, e))
    }

    /// Every component simplified.
    #[must_use]
    pub fn simplify(&self, arena: &mut Arena, simplifier: &mut Simplifier) -> Self {
        self.map(|e| simplifier.simplify(arena, e))
    }
}

/// Frames as a tree, with the rotations between them.
pub struct Frames {
    frames: Vec<Frame>,
    rotations: FxHashMap<(usize, usize), [[Expr; 3]; 3]>,
}

impl Frames {
    /// The frames of a model.
    #[must_use]
    pub fn new(frames: &[Frame]) -> Self {
        Self { frames: frames.to_vec(), rotations: FxHashMap::default() }
    }

    /// From `frame` up to the inertial frame, itself first.
    fn ancestors(&self, frame: usize) -> Vec<usize> {
        let mut path = vec![frame];
        while let Some((parent, _, _)) = self.frames[path[path.len() - 1]].rotation {
            path.push(parent);
        }
        path
    }

    /// The simple turns (axis, angle) that lead from the axes of `from` to those of `to`, adjacent turns
    /// about one axis merged.
    fn turns(&self, arena: &mut Arena, from: usize, to: usize) -> Vec<(usize, Expr)> {
        let (up, down) = (self.ancestors(from), self.ancestors(to));
        let mut shared = 0;
        while shared < up.len().min(down.len()) && up[up.len() - 1 - shared] == down[down.len() - 1 - shared] {
            shared += 1;
        }
        let mut turns: Vec<(usize, Expr)> = Vec::new();
        let mut push = |arena: &mut Arena, axis: usize, angle: Expr| match turns.last_mut() {
            Some((last, sum)) if *last == axis => {
                *sum = arena.add(*sum, angle);
                if *sum == Expr::ZERO {
                    turns.pop();
                }
            }
            _ => turns.push((axis, angle)),
        };
        for frame in &up[..up.len() - shared] {
            let (_, axis, angle) = self.frames[*frame].rotation.expect("not the inertial frame");
            let back = arena.neg(angle);
            push(arena, axis, back);
        }
        for frame in down[..down.len() - shared].iter().rev() {
            let (_, axis, angle) = self.frames[*frame].rotation.expect("not the inertial frame");
            push(arena, axis, angle);
        }
        turns
    }

    /// R with (components in `to`) = R · (components in `from`).
    pub fn rotation(&mut self, arena: &mut Arena, from: usize, to: usize) -> [[Expr; 3]; 3] {
        if let Some(done) = self.rotations.get(&(from, to)) {
            return *done;
        }
        let (i, o) = (Expr::ONE, Expr::ZERO);
        let mut matrix = [[i, o, o], [o, i, o], [o, o, i]];
        for (axis, angle) in self.turns(arena, from, to) {
            matrix = turn(arena, axis, angle, &matrix);
        }
        self.rotations.insert((from, to), matrix);
        matrix
    }

    /// All of a vector in one frame.
    pub fn express(&mut self, arena: &mut Arena, v: &Vector, frame: usize) -> Components {
        let mut sums: [Vec<Expr>; 3] = Default::default();
        for (from, components) in &v.parts {
            let r = self.rotation(arena, *from, frame);
            for (row, sum) in r.iter().zip(&mut sums) {
                for (factor, component) in row.iter().zip(components) {
                    let product = arena.mul(*factor, *component);
                    sum.push(product);
                }
            }
        }
        sums.map(|terms| arena.sum(&terms))
    }

    /// a · b.
    pub fn dot(&mut self, arena: &mut Arena, a: &Vector, b: &Vector) -> Expr {
        let mut terms = Vec::new();
        for (f, x) in &a.parts {
            for (g, y) in &b.parts {
                let y = self.express(arena, &Vector::in_frame(*g, *y), *f);
                for (x, y) in x.iter().zip(&y) {
                    let product = arena.mul(*x, *y);
                    terms.push(product);
                }
            }
        }
        arena.sum(&terms)
    }

    /// a × b, each part of b in its own frame.
    pub fn cross(&mut self, arena: &mut Arena, a: &Vector, b: &Vector) -> Vector {
        let mut result = Vector::default();
        for (frame, y) in &b.parts {
            let x = self.express(arena, a, *frame);
            let product = Vector::in_frame(*frame, cross_components(arena, &x, y));
            result = result.add(arena, &product);
        }
        result
    }

    /// The time derivative seen from the inertial frame: ᴺdv/dt = Σ_F (ᶠdv/dt + ω_F × v), part by part.
    pub fn time_derivative(
        &mut self,
        arena: &mut Arena,
        v: &Vector,
        angular_velocities: &[Vector],
        rates: &mut Differential,
    ) -> Vector {
        let mut result = v.differentiate(arena, rates);
        for (frame, components) in &v.parts {
            let turning = self.cross(arena, &angular_velocities[*frame], &Vector::in_frame(*frame, *components));
            result = result.add(arena, &turning);
        }
        result
    }
}

/// a × b in common components.
pub fn cross_components(arena: &mut Arena, a: &Components, b: &Components) -> Components {
    [(1, 2), (2, 0), (0, 1)].map(|(j, k)| {
        let (plus, minus) = (arena.mul(a[j], b[k]), arena.mul(a[k], b[j]));
        arena.sub(plus, minus)
    })
}

/// A · v.
pub fn apply_tensor(arena: &mut Arena, tensor: &[[Expr; 3]; 3], v: &Components) -> Components {
    tensor.map(|row| {
        let products: Vec<Expr> = row.iter().zip(v).map(|(a, b)| arena.mul(*a, *b)).collect();
        arena.sum(&products)
    })
}

/// (simple rotation about `axis`) · matrix: the frame is turned, so components turn back.
fn turn(arena: &mut Arena, axis: usize, angle: Expr, matrix: &[[Expr; 3]; 3]) -> [[Expr; 3]; 3] {
    let (s, c) = (arena.sin(angle), arena.cos(angle));
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut result = *matrix;
    for column in 0..3 {
        let (y, z) = (matrix[j][column], matrix[k][column]);
        let (cy, sz, sy, cz) = (arena.mul(c, y), arena.mul(s, z), arena.mul(s, y), arena.mul(c, z));
        result[j][column] = arena.add(cy, sz);
        result[k][column] = arena.sub(cz, sy);
    }
    result
}
