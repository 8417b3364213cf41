//! Search for branches of solutions: it splits products, solves equations for unknowns, and inserts
//! the solutions into the other equations. Equations are called rows here.

use super::factors::Factors;
use super::relation::{FactorSolutions, Relation, RelationCondition, RelationKind};
use super::workspace::Workspace;
use super::{MOST_BRANCHES, MOST_STEPS, Solutions};
use crate::algebra::form::ring_polynomial::RingPolynomial;
use crate::algebra::{Expr, Function, Node, Rational};

/// Partly solved system of equations in a search.
#[derive(Clone, Default)]
pub(super) struct Case {
    /// Equations of the case that remain to be solved: numerators that must be 0.
    rows: Vec<Expr>,
    /// Relations found so far in the case, which give unknowns.
    pub(super) relations: Vec<Relation>,
    /// Conditions under which the solutions of the case are real.
    pub(super) needs: Vec<RelationCondition>,
    /// Divisors of the solutions found so far in the case.
    pub(super) divided: Vec<Expr>,
    /// Terms that are not 0 in this case, because they were split off as factors or divided by.
    excluded: Vec<Expr>,
}

/// Equation of a case: a term that must be 0. Its factors that cannot be 0 are left out.
pub(super) struct Row {
    /// Whole term of the equation, which must be 0.
    pub(super) whole: Expr,
    /// Factors of the term that contain unknowns; empty if the term could not be factored.
    factors: Vec<Expr>,
}

/// Choice of the next step in a case: an equation, and its solutions for one unknown.
struct Choice {
    /// Index of the chosen equation among the equations of the case.
    row: usize,
    /// Solutions of the chosen equation for the unknown.
    isolated: FactorSolutions,
    /// Factors of the solutions' divisor that contain unknowns and are not proved different from 0.
    open: Vec<Expr>,
}

/// Rank of a way to solve an equation for an unknown; the least rank is chosen. Its entries are:
///
/// 1. false if the caller prefers the unknown
/// 2. true if the divisor may be 0
/// 3. degree of the roots
/// 4. position of the unknown
/// 5. size of the equation
type Rank = (bool, bool, u8, usize, usize);

/// Search for all solutions of a system of equations.
pub struct BranchSearch<'w, 'a> {
    /// Workspace: arena, algebraic tools and unknowns.
    pub(super) work: &'w mut Workspace<'a>,
    /// Equations of the system: numerators, which must be 0.
    pub(super) rows: Vec<Expr>,
    /// Divisors of the equations that contain unknowns. They are assumed not to be 0.
    divisors: Vec<Expr>,
    /// Branches of solutions found so far, with further results of the search.
    pub(super) found: Solutions,
}

impl<'w, 'a> BranchSearch<'w, 'a> {
    /// Prepares the search: reads the numerators of the equations, and the factors of all divisors.
    pub fn new(work: &'w mut Workspace<'a>, equations: &[Expr], divisors: &[Expr]) -> Self {
        let (mut rows, mut below, mut found) = (Vec::new(), divisors.to_vec(), Solutions::default());
        for equation in equations {
            match work.fraction(*equation) {
                None => found.too_large += 1,
                Some((above, factors)) => {
                    if !above.is_zero() {
                        rows.push(work.term(&above));
                    }
                    below.extend(factors.iter().map(|(factor, _)| work.term(factor)));
                }
            }
        }
        let mut search = Self { work, rows, divisors: Vec::new(), found };
        search.divisors = search.open_factors(&below);
        search
    }

    /// Runs the search and returns all branches of solutions that it finds.
    pub fn run(mut self) -> Solutions {
        self.reduce();
        self.found.equations = self.rows.clone().into_iter().map(|row| self.factored_row(row)).collect();
        self.found.divided_by = self.divisors.clone().into_iter().map(|e| self.work.short(e)).collect();
        if self.found.too_large > 0 {
            self.found.is_cut = true;
            return self.found;
        }
        let mut open = vec![Case { rows: self.rows.clone(), excluded: self.divisors.clone(), ..Case::default() }];
        let mut steps = 0;
        while let Some(case) = open.pop() {
            steps += 1;
            let is_last = steps > MOST_STEPS || self.found.branches.len() >= MOST_BRANCHES;
            if is_last {
                self.found.is_cut = true;
                break;
            }
            let next = self.step(case);
            open.extend(next.into_iter().rev());
        }
        self.without_verified_special_cases();
        self.found
    }

    /// Shortens equations: a multiple of another equation is subtracted if fewer terms remain.
    fn reduce(&mut self) {
        let mut forms: Vec<Option<RingPolynomial>> =
            self.rows.clone().into_iter().map(|row| self.work.fraction(row).map(|f| f.0)).collect();
        let pairs: Vec<(usize, usize)> =
            (0..forms.len()).flat_map(|i| (0..forms.len()).map(move |j| (i, j))).filter(|(i, j)| i != j).collect();
        for _ in 0..forms.len() {
            let mut changed = false;
            for (i, j) in &pairs {
                let (Some(a), Some(b)) = (&forms[*i], &forms[*j]) else { continue };
                if let Some(less) = self.shorter_difference(a, b) {
                    (forms[*i], changed) = (Some(less), true);
                }
            }
            if !changed {
                break;
            }
        }
        for (row, form) in self.rows.iter_mut().zip(&forms) {
            if let Some(form) = form {
                *row = self.work.term(form);
            }
        }
        self.rows.retain(|row| *row != Expr::ZERO);
    }

    /// Difference a − k b with fewer terms than a, for a number k; `None` if no k gives fewer
    /// terms.
    fn shorter_difference(&mut self, a: &RingPolynomial, b: &RingPolynomial) -> Option<RingPolynomial> {
        for (powers, k) in &b.terms {
            let Some((_, c)) = a.terms.iter().find(|(other, _)| other == powers) else { continue };
            let factor = c.mul(&k.reciprocal()?).neg();
            let sum = self.work.normalizer.ring().sum([(a, Rational::ONE), (b, factor)].into_iter())?;
            if sum.terms.len() < a.terms.len() {
                return Some(sum);
            }
        }
        None
    }

    /// Writes an equation as a product of factors in short form, for the reader. An equation that
    /// cannot be factored is returned unchanged.
    pub(super) fn factored_row(&mut self, row: Expr) -> Expr {
        let Some(factors) = self.work.factors(row) else { return row };
        let mut list = Vec::new();
        for (e, n) in factors.known.into_iter().chain(factors.unknown) {
            let is_negative = self.work.arena.as_number(e).is_some_and(Rational::is_negative);
            let e = if is_negative { self.work.arena.neg(e) } else { e };
            list.push((self.work.short(e), n));
        }
        self.work.arena.try_product(&list).unwrap_or(row)
    }

    /// Factors of the given terms that contain an unknown, each once. A term that cannot be
    /// factored counts as a factor.
    fn open_factors(&mut self, terms: &[Expr]) -> Vec<Expr> {
        let mut list = Vec::new();
        for term in terms {
            let factors = match self.work.factors(*term) {
                Some(Factors { unknown, .. }) => unknown.into_iter().map(|(e, _)| e).collect(),
                None => vec![*term],
            };
            list.extend(factors.into_iter().filter(|e| !self.work.unknowns_in(*e).is_empty()));
        }
        list.sort_unstable();
        list.dedup();
        list
    }

    /// Performs one step of a case (a partly solved system): solves an equation, splits a product,
    /// or removes a square root. Returns the cases that follow. The list is empty if the case has
    /// no solution. It is also empty if the case cannot be solved further; its branch is then
    /// checked and recorded.
    fn step(&mut self, mut case: Case) -> Vec<Case> {
        let Some(rows) = self.factored_rows(&mut case) else { return Vec::new() };
        let choice = self.best_choice(&case, &rows);
        let product = self.most_shared(&rows);
        match (choice, product) {
            (Some(choice), None) => self.cases_of_solution(&case, &rows, choice),
            (Some(choice), _) if choice.open.is_empty() => self.cases_of_solution(&case, &rows, choice),
            (_, Some(factor)) => {
                let holds = |row: &&Row| row.factors.contains(&factor);
                let mut zero = case.clone();
                zero.rows = rows.iter().filter(|row| !holds(row)).map(|row| row.whole).chain([factor]).collect();
                let mut other = case;
                other.rows = Vec::new();
                for row in &rows {
                    let rest: Vec<Expr> = row.factors.iter().copied().filter(|e| *e != factor).collect();
                    let whole = if row.factors.is_empty() { row.whole } else { self.work.arena.product(&rest) };
                    other.rows.push(whole);
                }
                other.excluded.push(factor);
                vec![zero, other]
            }
            (None, None) => match self.without_root(&rows) {
                Some(rows) => vec![Case { rows, ..case }],
                None => {
                    self.verify_case(&case, &rows);
                    Vec::new()
                }
            },
        }
    }

    /// Splits the equations of a case into factors. Equations that already hold are left out, and
    /// so are factors that cannot be 0. `None` if an equation cannot hold or an excluded factor is 0.
    fn factored_rows(&mut self, case: &mut Case) -> Option<Vec<Row>> {
        let mut excluded = Vec::new();
        for e in &case.excluded {
            if self.work.is_zero(*e) {
                return None;
            }
            excluded.push(*e);
        }
        case.excluded = self.open_factors(&excluded);
        let mut rows: Vec<Row> = Vec::new();
        for whole in case.rows.clone() {
            let Some(factors) = self.work.factors(whole) else {
                rows.push(Row { whole, factors: Vec::new() });
                continue;
            };
            if factors.known.is_empty() {
                continue;
            }
            let known: Vec<Expr> = factors.known.iter().map(|(e, _)| *e).collect();
            let doubtful: Vec<Expr> = known.into_iter().filter(|e| !self.work.sign(*e).is_strict()).collect();
            if factors.unknown.is_empty() {
                if doubtful.is_empty() {
                    return None;
                }
                rows.push(Row { whole: self.work.arena.product(&doubtful), factors: Vec::new() });
                continue;
            }
            let left: Vec<Expr> =
                factors.unknown.iter().map(|(e, _)| *e).filter(|e| !case.excluded.contains(e)).collect();
            // A factor whose sign is known to be positive or negative is never 0.
            let left: Vec<Expr> = left.into_iter().filter(|e| !self.work.sign(*e).is_strict()).collect();
            if left.is_empty() {
                return None;
            }
            case.divided.extend(doubtful);
            let whole = self.work.arena.product(&left);
            if !rows.iter().any(|row| row.whole == whole) {
                rows.push(Row { whole, factors: left });
            }
        }
        Some(rows)
    }

    /// Removes a square root from one of the equations. Returns all equations, one of them
    /// replaced. `None` if no equation has a square root with unknowns. Extra solutions of the new
    /// equation are rejected later, when they are inserted into the given equations.
    fn without_root(&mut self, rows: &[Row]) -> Option<Vec<Expr>> {
        let (at, norm) = rows.iter().enumerate().find_map(|(at, row)| {
            let [factor] = row.factors.as_slice() else { return None };
            Some((at, self.work.without_root(*factor)?))
        })?;
        Some(rows.iter().enumerate().map(|(k, row)| if k == at { norm } else { row.whole }).collect())
    }

    /// Factor to split off next: the factor of a product that most equations contain. Among equals
    /// the shortest is taken. `None` if no equation is a product.
    fn most_shared(&mut self, rows: &[Row]) -> Option<Expr> {
        let products = rows.iter().filter(|row| row.factors.len() > 1);
        let factors: Vec<Expr> = products.flat_map(|row| row.factors.iter().copied()).collect();
        let count = |e: &Expr| rows.iter().filter(|row| row.factors.contains(e)).count();
        let size = |e: &Expr| self.work.arena.reachable(&[*e]).len();
        factors.into_iter().min_by_key(|e| (std::cmp::Reverse(count(e)), size(e), *e))
    }

    /// Best way to solve an equation that has only one factor, for one unknown. `None` if no
    /// equation can be solved.
    fn best_choice(&mut self, case: &Case, rows: &[Row]) -> Option<Choice> {
        let mut best: Option<(Rank, Choice)> = None;
        for (at, row) in rows.iter().enumerate() {
            let [factor] = row.factors.as_slice() else { continue };
            for x in self.work.unknowns_in(*factor) {
                if case.relations.iter().any(|known| known.unknown == x) {
                    continue;
                }
                let Some(isolated) = self.work.isolate(*factor, x) else { continue };
                let is_alone = rows.iter().enumerate().all(|(k, r)| k == at || !self.work.arena.mentions(r.whole, x));
                if !is_alone && isolated.solutions.iter().any(|s| self.leaves_open(&s.relations)) {
                    continue;
                }
                let divisor: Vec<Expr> = isolated.divisor.into_iter().collect();
                let open: Vec<Expr> =
                    self.open_factors(&divisor).into_iter().filter(|e| !case.excluded.contains(e)).collect();
                let open: Vec<Expr> = open.into_iter().filter(|e| !self.work.sign(*e).is_strict()).collect();
                // A value must not depend on an unknown that another relation already gives.
                let is_told = |e: Expr| case.relations.iter().any(|r| self.work.arena.mentions(e, r.unknown));
                if isolated.solutions.iter().flat_map(|s| &s.relations).any(|r| is_told(r.value)) {
                    continue;
                }
                // The divisor would be 0 if another equation consists of factors of the divisor
                // alone.
                let is_zero = |r: &Row| !r.factors.is_empty() && r.factors.iter().all(|e| open.contains(e));
                if rows.iter().any(is_zero) {
                    continue;
                }
                let place = self.work.unknowns.iter().position(|known| *known == x).unwrap_or(usize::MAX);
                let size = self.work.arena.reachable(&[*factor]).len();
                let rank = (place >= self.work.asked, !open.is_empty(), isolated.degree, place, size);
                if best.as_ref().is_none_or(|(least, _)| rank < *least) {
                    best = Some((rank, Choice { row: at, isolated, open }));
                }
            }
        }
        best.map(|(_, choice)| choice)
    }

    /// True if a relation gives a sine, cosine or, if tangents are not kept, a tangent in terms of
    /// sines or cosines of other unknowns. Inserting such a relation does not help to solve other
    /// equations.
    fn leaves_open(&mut self, relations: &[Relation]) -> bool {
        let keeps_tangents = self.work.keeps_tangents;
        let is_circular = |relation: &&Relation| match relation.kind {
            RelationKind::Sine | RelationKind::Cosine => true,
            RelationKind::Tangent => !keeps_tangents,
            RelationKind::Value | RelationKind::Square => false,
        };
        relations.iter().filter(is_circular).any(|relation| {
            let parts = self.work.arena.reachable(&[relation.value]);
            let circular = parts.into_iter().filter(|e| is_function(self.work, *e));
            circular.collect::<Vec<_>>().into_iter().any(|e| !self.work.unknowns_in(e).is_empty())
        })
    }

    /// Cases (partly solved systems) that follow from solving an equation: one for each solution,
    /// and one in which the divisor is 0.
    fn cases_of_solution(&mut self, case: &Case, rows: &[Row], choice: Choice) -> Vec<Case> {
        let mut list = Vec::new();
        for solution in choice.isolated.solutions {
            let mut next = case.clone();
            next.divided.extend(choice.isolated.divisor);
            next.excluded.extend(&choice.open);
            next.needs.extend(&solution.needs);
            let others = rows.iter().enumerate().filter(|(at, _)| *at != choice.row).map(|(_, row)| row.whole);
            let put = |work: &mut Workspace, terms: &[Expr]| -> Option<Vec<Expr>> {
                terms.iter().map(|e| work.substitute_relations(&solution.relations, *e)).collect()
            };
            let (rows, excluded) = (put(self.work, &others.collect::<Vec<_>>()), put(self.work, &next.excluded));
            next.relations.extend(&solution.relations);
            match (rows, excluded) {
                (Some(rows), Some(excluded)) => {
                    (next.rows, next.excluded) = (rows, excluded);
                    list.push(next);
                }
                _ => self.found.is_cut = true,
            }
        }
        if !choice.open.is_empty() {
            let mut zero = case.clone();
            zero.rows = rows.iter().map(|row| row.whole).collect();
            zero.rows.push(self.work.arena.product(&choice.open));
            list.push(zero);
        }
        list
    }
}

/// True if the term is a sine or a cosine.
fn is_function(work: &Workspace, e: Expr) -> bool {
    matches!(work.arena.node(e), Node::Apply(Function::Sin | Function::Cos, _))
}
