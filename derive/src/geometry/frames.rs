//! Frames of a model as a tree, and rotation matrices between them.
//!
//! A dot product transforms components by a single rotation between two frames. For rotations about
//! a common axis, the angles are added first. So a planar chain has cosines of sums, not sums of
//! products.

use super::Frame;
use super::components::{Components, cross_components, dot_components, transposed};
use super::rotation::{Turn, TurnSense};
use super::vector::{Part, Vector};
use crate::algebra::term::calculus::Differential;
use crate::algebra::{Arena, Expr};
use rustc_hash::FxHashMap;

/// Tree of the model's frames, with the rotation matrices between them. Each matrix is computed
/// once.
pub struct Frames {
    /// Frames by index, each with its parent.
    tree: Vec<Frame>,
    /// Rotation matrices computed so far, by (from, to).
    rotations: FxHashMap<(usize, usize), [[Expr; 3]; 3]>,
    /// Dot products computed so far, by the pair of vector parts.
    dots: FxHashMap<(Part, Part), Expr>,
    /// True for large models: vectors are transformed frame by frame, and growing terms get names.
    /// If false, vectors are transformed by a single rotation matrix.
    pub(crate) carries: bool,
}

impl Frames {
    /// Creates the tree of the frames of a model.
    #[must_use]
    pub fn new(frames: &[Frame]) -> Self {
        Self { tree: frames.to_vec(), rotations: FxHashMap::default(), dots: FxHashMap::default(), carries: false }
    }

    /// Path from `frame` up to the inertial frame: indices of the frames, `frame` first.
    pub(crate) fn ancestors(&self, frame: usize) -> Vec<usize> {
        let mut path = vec![frame];
        while let Some((parent, _)) = &self.tree[path[path.len() - 1]].rotation {
            path.push(*parent);
        }
        path
    }

    /// Name of a frame in the model file.
    pub(crate) fn name(&self, frame: usize) -> &str {
        &self.tree[frame].name
    }

    /// Parent of a frame, by index; `None` for the inertial frame.
    pub(crate) fn parent(&self, frame: usize) -> Option<usize> {
        self.tree[frame].rotation.as_ref().map(|(parent, _)| *parent)
    }

    /// Rotation that leads from the parent frame to a frame; `None` for the inertial frame.
    pub(crate) fn turn_from_parent(&self, frame: usize) -> Option<&Turn> {
        self.tree[frame].rotation.as_ref().map(|(_, turn)| turn)
    }

    /// Number of rotations on the path between two frames, among those for which `counts` returns
    /// true. Consecutive rotations about one axis count as one, and a rotation given by direction
    /// cosines counts as three.
    pub(crate) fn axes_between(&self, from: usize, to: usize, counts: impl Fn(&Turn) -> bool) -> usize {
        let (up, down) = (self.ancestors(from), self.ancestors(to));
        let apart = |path: &[usize], other: &[usize]| -> Vec<usize> {
            path.iter().copied().take_while(|frame| !other.contains(frame)).collect()
        };
        let way = apart(&up, &down).into_iter().chain(apart(&down, &up).into_iter().rev());
        let (mut turns, mut last) = (0, None);
        for turn in way.filter_map(|frame| self.turn_from_parent(frame)).filter(|turn| counts(turn)) {
            // A rotation given by direction cosines counts as rotations about three axes.
            let axis = if let Turn::About(axis, _) = turn { Some(*axis) } else { None };
            turns += if axis.is_none() { 3 } else { usize::from(axis != last) };
            last = axis;
        }
        turns
    }

    /// True if the parent of every frame is the inertial frame. Direction cosines and their products
    /// are then short.
    pub(crate) fn are_all_children_of_inertial(&self) -> bool {
        self.tree.iter().all(|frame| frame.rotation.as_ref().is_none_or(|(parent, _)| *parent == 0))
    }

    /// Rotations that lead from frame `from` to frame `to`, each with the direction in which it is
    /// applied. Adjacent rotations about one axis are merged.
    fn turns(&self, arena: &mut Arena, from: usize, to: usize) -> Vec<(Turn, TurnSense)> {
        let (up, down) = (self.ancestors(from), self.ancestors(to));
        let mut shared = 0;
        while shared < up.len().min(down.len()) && up[up.len() - 1 - shared] == down[down.len() - 1 - shared] {
            shared += 1;
        }
        let way = up[..up.len() - shared].iter().map(|frame| (*frame, TurnSense::Back));
        let way = way.chain(down[..down.len() - shared].iter().rev().map(|frame| (*frame, TurnSense::Forward)));
        let mut turns: Vec<(Turn, TurnSense)> = Vec::new();
        for (frame, sense) in way {
            match (self.turn_from_parent(frame).expect("not the inertial frame"), turns.last_mut()) {
                (Turn::About(axis, angle), Some((Turn::About(last, sum), _))) if last == axis => {
                    let angle = if sense == TurnSense::Back { arena.neg(*angle) } else { *angle };
                    *sum = arena.add(*sum, angle);
                    if *sum == Expr::ZERO {
                        turns.pop();
                    }
                }
                (Turn::About(axis, angle), _) => {
                    let angle = if sense == TurnSense::Back { arena.neg(*angle) } else { *angle };
                    turns.push((Turn::About(*axis, angle), TurnSense::Forward));
                }
                (turn @ Turn::Oriented(_), _) => turns.push((turn.clone(), sense)),
            }
        }
        turns
    }

    /// Rotation matrix R, 3 × 3. Components in frame `to` are R times the components in frame
    /// `from`.
    pub fn rotation(&mut self, arena: &mut Arena, from: usize, to: usize) -> [[Expr; 3]; 3] {
        if let Some(done) = self.rotations.get(&(from, to)) {
            return *done;
        }
        let (i, o) = (Expr::ONE, Expr::ZERO);
        let mut matrix = [[i, o, o], [o, i, o], [o, o, i]];
        for (turn, sense) in self.turns(arena, from, to) {
            let columns = transposed(&matrix).map(|column| turn.apply(arena, &column, sense));
            matrix = transposed(&columns);
        }
        self.rotations.insert((from, to), matrix);
        matrix
    }

    /// Components of a vector in one frame, from all parts of the vector.
    pub fn express(&mut self, arena: &mut Arena, v: &Vector, frame: usize) -> Components {
        if self.carries {
            return self.express_frame_by_frame(arena, v, frame, "x", &self.tree[frame].name);
        }
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

    /// Component of a vector along the axis 0, 1 or 2 of one frame, from all parts of the vector.
    pub fn component(&mut self, arena: &mut Arena, v: &Vector, frame: usize, axis: usize) -> Expr {
        if self.carries {
            return self.express_frame_by_frame(arena, v, frame, "x", &self.tree[frame].name)[axis];
        }
        let mut products = Vec::new();
        for (from, components) in &v.parts {
            let row = self.rotation(arena, *from, frame)[axis];
            products.push(dot_components(arena, &row, components));
        }
        arena.sum(&products)
    }

    /// Dot product a · b of two vectors, as one term.
    pub fn dot(&mut self, arena: &mut Arena, a: &Vector, b: &Vector) -> Expr {
        if self.carries {
            let home = self.common_transport_frame([a, b]);
            let [a, b] = [a, b].map(|v| self.express_frame_by_frame(arena, v, home, "x", &self.tree[home].name));
            return dot_components(arena, &a, &b);
        }
        let mut terms = Vec::new();
        for x in &a.parts {
            for y in &b.parts {
                terms.push(self.dot_of_parts(arena, *x, *y));
            }
        }
        arena.sum(&terms)
    }

    /// Dot product of two vector parts, each in its own frame. Results are stored, because the
    /// velocities of bodies of a chain have common parts.
    pub(super) fn dot_of_parts(&mut self, arena: &mut Arena, a: Part, b: Part) -> Expr {
        // With a fixed order, half as many rotations are needed, and equal products become the same
        // term.
        let (a, b) = if b.0 < a.0 { (b, a) } else { (a, b) };
        if let Some(known) = self.dots.get(&(a, b)) {
            return *known;
        }
        if self.carries && a.0 != b.0 {
            let [x, y] = [a, b].map(|(frame, components)| Vector::in_frame(frame, components));
            let product = self.dot(arena, &x, &y);
            self.dots.insert((a, b), product);
            return product;
        }
        let rotation = (a.0 != b.0).then(|| self.rotation(arena, b.0, a.0));
        let mut products = Vec::with_capacity(3);
        for (axis, x) in a.1.into_iter().enumerate().filter(|(_, x)| *x != Expr::ZERO) {
            let y = match rotation {
                Some(rows) => dot_components(arena, &rows[axis], &b.1),
                None => b.1[axis],
            };
            products.push(arena.mul(x, y));
        }
        let product = arena.sum(&products);
        self.dots.insert((a, b), product);
        product
    }

    /// Cross product a × b of two vectors. Each part of the result is in the frame of a part of b.
    pub fn cross(&mut self, arena: &mut Arena, a: &Vector, b: &Vector) -> Vector {
        let mut result = Vector::default();
        for (frame, y) in &b.parts {
            let x = self.express(arena, a, *frame);
            let product = Vector::in_frame(*frame, cross_components(arena, &x, y));
            result = result.add(arena, &product);
        }
        result
    }

    /// Time derivative of a vector in the inertial frame: ᴺdv/dt = Σ_F (ᶠdv/dt + ω_F × v_F), where
    /// v_F is the part of v in frame F. `angular_velocities` has the ω_F by index of the frame.
    /// `rates` differentiates components with respect to time.
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
