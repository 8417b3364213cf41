//! Common divisors of all sums of a network, taken out one at a time, the one that saves most operations first.

use super::network::{Atom, Factors, Network, Term, Value, is_unit};
use crate::algebra::Rational;
use rustc_hash::{FxHashMap, FxHashSet};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Number of terms of a sum above which its pairs of terms are not examined: pairs grow with the square.
const LONGEST: usize = 300;
/// Largest number of places of two-term sums that are examined. Later sums share products only.
const MOST_PLACES: usize = 100_000;

/// Largest number of factors that are weighed in pairs, each pair with all factors of its term. Later terms share no
/// products. A product of n factors would take n⁴ of them: n³ at once, and again for each pair that is taken out.
const MOST_WEIGHED: usize = 20_000_000;

/// A divisor that several terms may have in common.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Divisor {
    /// A sum of two terms with coprime integer coefficients, the first positive, and without a common factor.
    Sum(Box<[Term; 2]>),
    /// A product of two atoms, which may be equal.
    Product(Atom, Atom),
    /// An atom times a positive number other than 1.
    Scaled(Rational, Atom),
}

impl std::hash::Hash for Term {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.k.hash(state);
        self.factors.hash(state);
    }
}

/// Place at which a divisor may be taken out.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Place {
    sum: Atom,
    /// Positions of two terms in the sum; equal if only one term is meant.
    i: usize,
    j: usize,
}

#[derive(Default)]
struct Candidate {
    places: Vec<Place>,
    /// Upper bound of the operations saved: the sum over all places, also those that are gone.
    most: usize,
    /// Number of operations that compute the divisor itself.
    cost: usize,
    /// Atom that holds the divisor; `None` until it is taken out.
    defined: Option<Atom>,
    /// Savings with which the candidate stands in the queue, 0 if it is not there. Queue entries with other savings are
    /// outdated.
    queued: usize,
}

/// Common divisors of a network, kept up to date while they are taken out.
pub(super) struct Extraction {
    network: Network,
    index: FxHashMap<Divisor, usize>,
    divisors: Vec<Divisor>,
    candidates: Vec<Candidate>,
    /// Number of places of two-term sums examined so far.
    pairs: usize,
    /// Number of factors weighed in pairs so far.
    weighed: usize,
    /// Number of the divisor that each defining sum computes.
    definition_of: FxHashMap<Atom, usize>,
    /// Candidates as (upper bound of the operations saved, number), the largest and then the oldest first. A bound is
    /// computed again when its entry comes up.
    queue: BinaryHeap<(usize, Reverse<usize>)>,
}

impl Extraction {
    pub fn new(network: Network) -> Self {
        let mut new = Self {
            network,
            index: FxHashMap::default(),
            divisors: Vec::new(),
            candidates: Vec::new(),
            pairs: 0,
            weighed: 0,
            definition_of: FxHashMap::default(),
            queue: BinaryHeap::new(),
        };
        for sum in 0..new.network.atoms.len() {
            let sum = Atom::try_from(sum).expect("atoms are numbered");
            let places: Vec<usize> = new.network.terms(sum).map(|(at, _)| at).collect();
            for (i, at) in places.iter().enumerate() {
                new.register(sum, *at, &places[..i], None);
            }
        }
        new
    }

    /// Takes common divisors out of the network until no divisor saves an operation.
    pub fn run(mut self) -> Network {
        while let Some((saved, Reverse(id))) = self.queue.pop() {
            if self.candidates[id].queued != saved {
                continue;
            }
            self.candidates[id].queued = 0;
            let now = self.saving(id);
            if now == saved {
                self.take_out(id);
            } else {
                self.enqueue(id, now);
            }
        }
        self.network
    }

    /// Adds to the table the divisors that a new term has in common with each of the terms `others` of its sum. The
    /// divisor `own` is left out: the sum itself defines it.
    fn register(&mut self, sum: Atom, at: usize, others: &[usize], own: Option<usize>) {
        let term = self.term(sum, at).clone();
        self.register_products(&term, Place { sum, i: at, j: at }, own);
        if others.len() <= LONGEST && self.pairs < MOST_PLACES {
            self.pairs += others.len();
            for other in others {
                let (divisor, _) = split(self.term(sum, *other), &term);
                self.enter(divisor, Place { sum, i: *other, j: at }, own);
            }
        }
    }

    /// Enters the products of two factors that occur in a term at a place.
    fn register_products(&mut self, term: &Term, place: Place, own: Option<usize>) {
        let count = term.factors.len();
        self.weighed = self.weighed.saturating_add(count.saturating_pow(3) / 2);
        if self.weighed > MOST_WEIGHED {
            return;
        }
        for (i, (a, n)) in term.factors.iter().enumerate() {
            if *n > 1 {
                self.enter(Divisor::Product(*a, *a), place, own);
            }
            for (b, _) in &term.factors[i + 1..] {
                self.enter(Divisor::Product(*a, *b), place, own);
            }
            if !is_unit(&term.k) {
                self.enter(Divisor::Scaled(magnitude(&term.k), *a), place, own);
            }
        }
    }

    fn enter(&mut self, divisor: Divisor, place: Place, own: Option<usize>) {
        let id = match self.index.get(&divisor) {
            Some(id) => *id,
            None => {
                let id = self.divisors.len();
                let cost = match &divisor {
                    Divisor::Sum(terms) => terms[0].multiplications() + terms[1].multiplications() + 1,
                    Divisor::Product(..) | Divisor::Scaled(..) => 1,
                };
                self.index.insert(divisor.clone(), id);
                self.divisors.push(divisor);
                self.candidates.push(Candidate { cost, ..Candidate::default() });
                id
            }
        };
        if own == Some(id) {
            return;
        }
        let gain = self.gain(id, place);
        let candidate = &mut self.candidates[id];
        candidate.places.push(place);
        candidate.most += gain;
        let once = if candidate.defined.is_some() { 0 } else { candidate.cost };
        let most = candidate.most.saturating_sub(once);
        self.enqueue(id, most);
    }

    /// Puts a divisor into the queue with an upper bound of its savings, if that exceeds its present entry.
    fn enqueue(&mut self, id: usize, most: usize) {
        if most > self.candidates[id].queued {
            self.candidates[id].queued = most;
            self.queue.push((most, Reverse(id)));
        }
    }

    fn term(&self, sum: Atom, at: usize) -> &Term {
        match &self.network.atoms[sum as usize].value {
            Value::Sum(terms) => terms[at].as_ref().expect("a term that is there"),
            Value::Leaf(_) | Value::Inverse(_) => unreachable!("only sums have terms"),
        }
    }

    fn is_there(&self, place: Place) -> bool {
        let Place { sum, i, j } = place;
        match &self.network.atoms[sum as usize].value {
            Value::Sum(terms) => terms[i].is_some() && terms[j].is_some(),
            Value::Leaf(_) | Value::Inverse(_) => false,
        }
    }

    /// Places of a divisor that still exist and do not overlap.
    fn places(&self, id: usize) -> Vec<Place> {
        let mut list: Vec<Place> = Vec::new();
        let mut taken: FxHashSet<(Atom, usize)> = FxHashSet::default();
        for place in &self.candidates[id].places {
            let Place { sum, i, j } = *place;
            if self.is_there(*place) && !taken.contains(&(sum, i)) && !taken.contains(&(sum, j)) {
                taken.extend([(sum, i), (sum, j)]);
                list.push(*place);
            }
        }
        list
    }

    /// Place where the divisor is a whole sum, which can then serve as its definition; `None` if there is none.
    fn whole(&self, id: usize, places: &[Place]) -> Option<Place> {
        places.iter().copied().find(|place| {
            let terms = self.network.terms(place.sum).count();
            let rest = self.without(id, *place);
            let once = self.times(id, *place) == 1;
            once && rest.factors.is_empty() && rest.k.is_one() && terms == if place.i == place.j { 1 } else { 2 }
        })
    }

    /// Cofactor that remains at a place when the divisor is taken out.
    fn without(&self, id: usize, place: Place) -> Term {
        let Place { sum, i, j } = place;
        let first = self.term(sum, i);
        match &self.divisors[id] {
            Divisor::Sum(_) => split(first, self.term(sum, j)).1,
            Divisor::Product(a, b) => {
                let times = fits(&first.factors, *a, *b);
                let mut rest = first.clone();
                take(&mut rest.factors, *a, times);
                take(&mut rest.factors, *b, times);
                rest
            }
            Divisor::Scaled(_, a) => {
                let mut rest = first.clone();
                take(&mut rest.factors, *a, 1);
                rest.k = if rest.k.is_negative() { Rational::MINUS_ONE } else { Rational::ONE };
                rest
            }
        }
    }

    /// Number of times that a divisor divides the terms at a place.
    fn times(&self, id: usize, place: Place) -> u32 {
        match &self.divisors[id] {
            Divisor::Product(a, b) => fits(&self.term(place.sum, place.i).factors, *a, *b),
            Divisor::Sum(_) | Divisor::Scaled(..) => 1,
        }
    }

    /// Number of operations saved at one place when the divisor is taken out there, without the cost of the divisor
    /// itself.
    fn gain(&self, id: usize, place: Place) -> usize {
        let Place { sum, i, j } = place;
        let mut before = self.term(sum, i).multiplications();
        if i != j {
            before += self.term(sum, j).multiplications() + 1;
        }
        let rest = self.without(id, place);
        let degree: u32 = rest.factors.iter().map(|(_, n)| *n).sum();
        let after = (degree + self.times(id, place)) as usize - 1 + usize::from(!is_unit(&rest.k));
        before.saturating_sub(after)
    }

    /// Number of operations saved by taking a divisor out wherever it fits, less the cost of the divisor itself.
    fn saving(&self, id: usize) -> usize {
        let total: usize = self.places(id).iter().map(|place| self.gain(id, *place)).sum();
        let candidate = &self.candidates[id];
        total.saturating_sub(if candidate.defined.is_some() { 0 } else { candidate.cost })
    }

    /// Takes a divisor out wherever it fits.
    fn take_out(&mut self, id: usize) {
        let places = self.places(id);
        let (atom, kept) = self.holder(id, &places);
        for place in places {
            if Some(place) == kept {
                continue;
            }
            let Place { sum, i, j } = place;
            let mut rest = self.without(id, place);
            let times = self.times(id, place);
            insert(&mut rest.factors, atom, times);
            let Value::Sum(terms) = &mut self.network.atoms[sum as usize].value else { continue };
            terms[i] = None;
            terms[j] = None;
            terms.push(Some(rest));
            let at = terms.len() - 1;
            let others: Vec<usize> = self.network.terms(sum).map(|(at, _)| at).filter(|other| *other != at).collect();
            let own = self.definition_of.get(&sum).copied();
            self.register(sum, at, &others, own);
        }
        self.candidates[id].places.clear();
    }

    /// Atom that holds a divisor, created if needed. The place is that of an existing sum that became the definition,
    /// if one did.
    fn holder(&mut self, id: usize, places: &[Place]) -> (Atom, Option<Place>) {
        if let Some(atom) = self.candidates[id].defined {
            return (atom, None);
        }
        if let Some(place) = self.whole(id, places) {
            self.candidates[id].defined = Some(place.sum);
            self.definition_of.insert(place.sum, id);
            return (place.sum, Some(place));
        }
        let terms: Vec<Option<Term>> = match &self.divisors[id] {
            Divisor::Sum(terms) => terms.iter().cloned().map(Some).collect(),
            Divisor::Product(a, b) => {
                let mut factors = Factors::new();
                insert(&mut factors, *a, 1);
                insert(&mut factors, *b, 1);
                vec![Some(Term { k: Rational::ONE, factors })]
            }
            Divisor::Scaled(k, a) => vec![Some(Term { k: k.clone(), factors: vec![(*a, 1)] })],
        };
        let places: Vec<usize> = (0..terms.len()).collect();
        let atom = self.network.push(Value::Sum(terms));
        self.candidates[id].defined = Some(atom);
        self.definition_of.insert(atom, id);
        for (i, at) in places.iter().enumerate() {
            self.register(atom, *at, &places[..i], Some(id));
        }
        (atom, None)
    }
}

fn magnitude(k: &Rational) -> Rational {
    if k.is_negative() { k.neg() } else { k.clone() }
}

/// Number of times that a·b divides a product.
fn fits(factors: &Factors, a: Atom, b: Atom) -> u32 {
    let exponent = |atom: Atom| factors.iter().find(|(e, _)| *e == atom).map_or(0, |(_, n)| *n);
    if a == b { exponent(a) / 2 } else { exponent(a).min(exponent(b)) }
}

fn take(factors: &mut Factors, atom: Atom, times: u32) {
    for (e, n) in factors.iter_mut() {
        if *e == atom {
            *n -= times.min(*n);
        }
    }
    factors.retain(|(_, n)| *n > 0);
}

fn insert(factors: &mut Factors, atom: Atom, times: u32) {
    match factors.binary_search_by_key(&atom, |(e, _)| *e) {
        Ok(at) => factors[at].1 += times,
        Err(at) => factors.insert(at, (atom, times)),
    }
}

/// Splits the sum of two terms into divisor · cofactor.
fn split(a: &Term, b: &Term) -> (Divisor, Term) {
    let mut common = Factors::new();
    for (atom, n) in &a.factors {
        if let Some((_, m)) = b.factors.iter().find(|(e, _)| e == atom) {
            common.push((*atom, *n.min(m)));
        }
    }
    let reduced = |term: &Term| {
        let mut factors = term.factors.clone();
        for (atom, n) in &common {
            take(&mut factors, *atom, *n);
        }
        Term { k: term.k.clone(), factors }
    };
    let mut pair = [reduced(a), reduced(b)];
    if pair[1].factors < pair[0].factors {
        pair.swap(0, 1);
    }
    let mut content = magnitude(&pair[0].k.common_content(&pair[1].k));
    if pair[0].k.is_negative() {
        content = content.neg();
    }
    let inverse = content.recip().expect("terms are not zero");
    for term in &mut pair {
        term.k = term.k.mul(&inverse);
    }
    (Divisor::Sum(Box::new(pair)), Term { k: content, factors: common })
}
