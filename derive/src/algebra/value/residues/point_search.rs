//! Search for points of a prime field at which all square roots in given terms exist.
//!
//! Half of all numbers in a prime field have square roots, so k roots all exist at one point in
//! 2^k. Symbols are therefore drawn group by group: a group is drawn again until all roots exist
//! that contain no later symbol. The cost is 2^k for the k roots of a single group, not for the
//! roots of all groups together.

use super::{Hashes, ResiduePoint, Residues, angle_denominators, residue_generator};
use crate::algebra::term::fold::{FoldOrder, Values};
use crate::algebra::value::field::{Field, Generator};
use crate::algebra::{Arena, Expr, Function, Node};
use rustc_hash::{FxHashMap, FxHashSet};

/// Largest number of nodes that are evaluated in the search for a point.
const MOST_WORK: usize = 4_000_000;

/// Quantities that must have residues at a point: given terms only, or also their derivatives.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Scope {
    /// Only the terms must have residues.
    Terms,
    /// Terms, and their derivatives with respect to all symbols, must have residues.
    TermsAndSlopes,
}

/// Square root that must exist at a point of a prime field, for a term to have a residue.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum RootAtPoint {
    /// The square root √x of a term x.
    Of(Expr),
    /// The square root √(1 − x²), which occurs in the derivatives of asin x and acos x.
    Complement(Expr),
}

impl RootAtPoint {
    /// Square root that must exist in the field if the term `term` is to have a residue. `None` if
    /// the term contains no root at its top level.
    fn new(arena: &Arena, term: Expr, scope: Scope) -> Option<Self> {
        match arena.node(term) {
            Node::Apply(Function::Sqrt, x) => Some(Self::Of(*x)),
            Node::Apply(Function::Asin | Function::Acos, x) if scope == Scope::TermsAndSlopes => {
                Some(Self::Complement(*x))
            }
            _ => None,
        }
    }

    /// Term x of the square root, which is √x or √(1 − x²).
    fn argument(self) -> Expr {
        match self {
            Self::Of(x) | Self::Complement(x) => x,
        }
    }

    /// True if the square root exists in the field. `argument` is the residue of x.
    fn exists(self, field: Field, argument: u64) -> bool {
        let radicand = match self {
            Self::Of(_) => argument,
            Self::Complement(_) => field.sub(1, field.mul(argument, argument)),
        };
        field.root(radicand).is_some()
    }
}

/// Group of symbols that are drawn together, with the square roots that contain these symbols and
/// no symbol drawn later.
struct Group {
    /// Symbols whose residues are drawn together.
    symbols: Vec<Expr>,
    /// Square roots of the group, each with its argument and all subterms of the argument.
    roots: Vec<(RootAtPoint, FoldOrder)>,
}

/// Search for random points at which all given terms have residues.
pub(crate) struct PointSearch<'a> {
    /// Arena of the terms.
    arena: &'a Arena,
    /// Terms for which a point is searched, with all their subterms.
    needed: FoldOrder,
    /// Least common denominator of the coefficients of each atom inside angles; an angle is a sum Σ
    /// k · atom.
    denominators: FxHashMap<Expr, i64>,
    /// Generator of primes and seeds.
    generator: Generator,
    /// Groups of symbols, in the order in which they are drawn.
    groups: Vec<Group>,
}

impl<'a> PointSearch<'a> {
    /// Creates a search for points at which the given terms have residues.
    pub fn new(arena: &'a Arena, terms: &[Expr]) -> Self {
        Self::for_scope(arena, terms, Scope::Terms)
    }

    /// Creates a search for points at which the given terms and their derivatives have residues.
    pub fn with_slopes(arena: &'a Arena, terms: &[Expr]) -> Self {
        Self::for_scope(arena, terms, Scope::TermsAndSlopes)
    }

    /// Creates a search for points at which the given terms, and also their derivatives if `scope`
    /// says so, have residues.
    fn for_scope(arena: &'a Arena, terms: &[Expr], scope: Scope) -> Self {
        let needed = FoldOrder::new(arena, terms);
        let denominators = angle_denominators(arena, needed.nodes());
        let generator = residue_generator(arena, &needed);
        let groups = groups_of_roots(arena, &needed, scope);
        Self { arena, needed, denominators, generator, groups }
    }

    /// Draws the next random point at which all square roots exist. Each point has another prime.
    /// `None` if no point was found within the limit of work.
    pub fn point(&mut self) -> Option<ResiduePoint> {
        let (arena, denominators, generator) = (self.arena, &self.denominators, &mut self.generator);
        let mut work = MOST_WORK;
        while work > 0 {
            let mut point = ResiduePoint::new(Field::random(generator), generator.next());
            if self.groups.iter().all(|group| group.draw(arena, denominators, &mut point, generator, &mut work)) {
                return Some(point);
            }
        }
        None
    }

    /// Rules that compute the residues of the terms at a point.
    pub fn residues(&self, point: ResiduePoint) -> Residues<'_> {
        Residues::new(self.arena, &self.denominators, point)
    }

    /// Terms of the search, with all their subterms, in the order of evaluation.
    pub fn needed(&self) -> &FoldOrder {
        &self.needed
    }

    /// Residues of the given terms and of all their subterms at a point; `None` if a term has no
    /// residue there.
    pub fn values(&self, point: &ResiduePoint) -> Option<Values<'_, u64>> {
        self.needed.fold(self.arena, &mut self.residues(point.clone()))
    }
}

impl Group {
    /// Draws the symbols of the group until all square roots of the group exist at the point. The
    /// cost is subtracted from `work`. False if `work` is used up, or if the group has no symbols
    /// and a root does not exist in this field.
    fn draw(
        &self,
        arena: &Arena,
        denominators: &FxHashMap<Expr, i64>,
        point: &mut ResiduePoint,
        generator: &mut Generator,
        work: &mut usize,
    ) -> bool {
        loop {
            let exists = self.roots.iter().all(|(root, needed)| {
                *work = work.saturating_sub(needed.nodes().len());
                let values = needed.fold(arena, &mut Residues::new(arena, denominators, point.clone()));
                values.is_some_and(|values| root.exists(point.field, values[root.argument()]))
            });
            if exists || self.symbols.is_empty() || *work == 0 {
                return exists;
            }
            let seed = generator.next();
            point.redrawn.extend(self.symbols.iter().map(|symbol| (*symbol, seed)));
        }
    }
}

/// Groups of the symbols and square roots in the given terms, in the order of drawing: groups with
/// few symbols first.
fn groups_of_roots(arena: &Arena, needed: &FoldOrder, scope: Scope) -> Vec<Group> {
    let roots: FxHashSet<RootAtPoint> =
        needed.nodes().iter().filter_map(|e| RootAtPoint::new(arena, *e, scope)).collect();
    if roots.is_empty() {
        return Vec::new();
    }
    let hashes = needed.fold(arena, &mut Hashes(arena));
    let hash = |e: Expr| hashes.as_ref().map_or(0, |hashes| hashes[e]);
    let mut left: Vec<(Vec<Expr>, RootAtPoint, FoldOrder)> = roots
        .into_iter()
        .map(|root| {
            let inside = FoldOrder::new(arena, &[root.argument()]);
            let symbols = inside.nodes().iter().copied().filter(|e| arena.symbol_name(*e).is_some()).collect();
            (symbols, root, inside)
        })
        .collect();
    // Roots are sorted by structure, not by handles, so that every run draws the same points. A
    // root inside another root has fewer nodes and comes first.
    left.sort_by_key(|(_, root, inside)| (inside.nodes().len(), hash(root.argument())));
    let mut groups = Vec::new();
    while let Some((next, ..)) = left.iter().min_by_key(|(symbols, ..)| symbols.len()) {
        let symbols = next.clone();
        let drawn: FxHashSet<Expr> = symbols.iter().copied().collect();
        for (symbols, ..) in &mut left {
            symbols.retain(|symbol| !drawn.contains(symbol));
        }
        let (ready, later): (Vec<_>, Vec<_>) = left.into_iter().partition(|(symbols, ..)| symbols.is_empty());
        groups.push(Group { symbols, roots: ready.into_iter().map(|(_, root, inside)| (root, inside)).collect() });
        left = later;
    }
    groups
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;

    /// A point with thirty square roots is found at the first draw, although only one random point
    /// in a thousand million has all roots.
    #[test]
    fn many_roots_exist_at_once() {
        let mut arena = Arena::new();
        let names = ["a", "b", "c", "d", "e", "f"];
        let mut terms = Vec::new();
        for (at, x) in names.iter().enumerate() {
            for y in &names[..at] {
                for text in [format!("sqrt(({x} - {y})^2 + 3)"), format!("sqrt(2 + sqrt({x}^2 + {y}^4 + {x}))")] {
                    terms.push(parse_free(&mut arena, &text).unwrap());
                }
            }
        }
        let mut draw = PointSearch::new(&arena, &terms);
        for _ in 0..3 {
            let point = draw.point().unwrap();
            let values = draw.values(&point).unwrap();
            for term in &terms {
                let Node::Apply(_, radicand) = arena.node(*term) else { panic!("a root") };
                assert_eq!(point.field.mul(values[*term], values[*term]), values[*radicand]);
            }
        }
    }

    /// The search ends if a root exists in no field. A root of a number is found in another prime
    /// field.
    #[test]
    fn roots_that_exist_nowhere_are_given_up() {
        let mut arena = Arena::new();
        let e = parse_free(&mut arena, "sqrt(-a^2)").unwrap();
        assert!(PointSearch::new(&arena, &[e]).point().is_none());
        let e = parse_free(&mut arena, "sqrt(5)*sqrt(7)*sqrt(11)*sqrt(13)*a").unwrap();
        assert!(PointSearch::new(&arena, &[e]).point().is_some());
    }
}
