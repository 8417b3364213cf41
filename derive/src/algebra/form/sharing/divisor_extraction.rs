//! Common divisors of all sums of a network, taken out in sequence, the divisor that saves most
//! operations first.

use super::network::{Atom, Factors, Network, NetworkTerm, Value, is_unit};
use crate::algebra::Rational;
use rustc_hash::{FxHashMap, FxHashSet};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Number of terms of a sum above which its pairs of terms are not examined. The number of pairs
/// grows with the square of the number of terms.
const LONGEST: usize = 300;
/// Largest number of pairs of terms that are examined in one network. Once it is reached, later
/// sums share products only.
const MOST_PLACES: usize = 100_000;

/// Largest amount of work for pairs of factors in one network. Once it is exceeded, later terms
/// share no products.
///
/// A pair of factors is compared with all factors of its term. So a product of n factors takes n³
/// operations at first and after each pair that is taken out, about n⁴ in total.
const MOST_WEIGHED: usize = 20_000_000;

/// Divisor that several terms of a network may have in common.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Divisor {
    /// A divisor that is a sum of two terms without a common factor, with coprime integer
    /// coefficients, the first of them positive.
    Sum(Box<[NetworkTerm; 2]>),
    /// A divisor that is a product of two atoms, which may be equal.
    Product(Atom, Atom),
    /// A divisor that is an atom times a positive number other than 1.
    Scaled(Rational, Atom),
}

impl std::hash::Hash for NetworkTerm {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.k.hash(state);
        self.factors.hash(state);
    }
}

/// Position of a divisor in the network: a sum, and the one or two terms in it that the divisor
/// divides.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Place {
    /// Sum of the network that contains the terms, as the number of its atom.
    sum: Atom,
    /// Position, in the sum, of the first term that the divisor divides.
    i: usize,
    /// Position, in the sum, of the second term that the divisor divides; equal to `i` if the
    /// divisor divides a single term.
    j: usize,
}

/// Divisor that may be taken out of the network, with its positions and the operations that this
/// saves.
#[derive(Default)]
struct Candidate {
    /// Positions at which the divisor was found. Some may no longer exist.
    places: Vec<Place>,
    /// Upper bound of the operations saved: the sum over all positions, including those that no
    /// longer exist.
    most: usize,
    /// Number of operations that compute the divisor itself.
    cost: usize,
    /// Atom whose value is the divisor; `None` until the divisor is taken out of the sums.
    defined: Option<Atom>,
    /// Upper bound of the savings with which the divisor is in the queue; 0 if it is not in the
    /// queue. A queue entry with another bound is outdated.
    queued: usize,
}

/// Table of the common divisors of a network. It is updated whenever a divisor is taken out of the
/// sums.
pub(super) struct Extraction {
    /// Network from which divisors are taken out.
    network: Network,
    /// Index, in `divisors`, of each common divisor found so far.
    index: FxHashMap<Divisor, usize>,
    /// Common divisors, in the order in which they were found.
    divisors: Vec<Divisor>,
    /// Positions and savings of each common divisor, by its index in `divisors`.
    candidates: Vec<Candidate>,
    /// Number of pairs of terms that the search for divisors has examined so far.
    pairs: usize,
    /// Amount of work for pairs of factors so far, counted as n³/2 for a term with n factors.
    weighed: usize,
    /// Index, in `divisors`, of the divisor whose value a sum of the network is. The key is the
    /// atom of the sum.
    definition_of: FxHashMap<Atom, usize>,
    /// Queue of divisors as (upper bound of the operations saved, index in `divisors`). The largest
    /// bound comes first; among equal bounds, the divisor found first. When an entry comes up, its
    /// savings are computed again.
    queue: BinaryHeap<(usize, Reverse<usize>)>,
}

impl Extraction {
    /// Reads a network and finds the common divisors of all its sums. None is taken out yet.
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

    /// Adds to the table the divisors that a new term has in common with each of the terms `others`
    /// of the same sum. The divisor `own` is left out, because this sum defines it.
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

    /// Adds to the table every product of two factors of a term, and every product of a factor and
    /// the coefficient. `own` is the divisor that the term's sum defines; it is left out.
    fn register_products(&mut self, term: &NetworkTerm, place: Place, own: Option<usize>) {
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

    /// Adds a divisor at a position of the network to the table, and puts it into the queue.
    /// Nothing is added if the divisor is `own`, which the sum at this position defines.
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

    /// Puts a divisor into the queue with an upper bound of its savings. Nothing changes if the
    /// divisor is already in the queue with an equal or larger bound.
    fn enqueue(&mut self, id: usize, most: usize) {
        if most > self.candidates[id].queued {
            self.candidates[id].queued = most;
            self.queue.push((most, Reverse(id)));
        }
    }

    /// Term at a position of a sum. Panics if the term was taken out.
    fn term(&self, sum: Atom, at: usize) -> &NetworkTerm {
        match &self.network.atoms[sum as usize].value {
            Value::Sum(terms) => terms[at].as_ref().expect("a term that is there"),
            Value::Leaf(_) | Value::Inverse(_) => unreachable!("only sums have terms"),
        }
    }

    /// True if neither term of the position has been taken out of its sum.
    fn is_there(&self, place: Place) -> bool {
        let Place { sum, i, j } = place;
        match &self.network.atoms[sum as usize].value {
            Value::Sum(terms) => terms[i].is_some() && terms[j].is_some(),
            Value::Leaf(_) | Value::Inverse(_) => false,
        }
    }

    /// Positions of a divisor whose terms all still exist and that share no terms with one another.
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

    /// Position at which the divisor is a whole sum of the network, so that this sum can define it.
    /// `None` if no sum of the network equals the divisor.
    fn whole_sum(&self, id: usize, places: &[Place]) -> Option<Place> {
        places.iter().copied().find(|place| {
            let terms = self.network.terms(place.sum).count();
            let rest = self.cofactor(id, *place);
            let once = self.multiplicity_at(id, *place) == 1;
            once && rest.factors.is_empty() && rest.k.is_one() && terms == if place.i == place.j { 1 } else { 2 }
        })
    }

    /// Cofactor that remains at a position if the divisor is taken out there: the terms divided by
    /// the divisor.
    fn cofactor(&self, id: usize, place: Place) -> NetworkTerm {
        let Place { sum, i, j } = place;
        let first = self.term(sum, i);
        match &self.divisors[id] {
            Divisor::Sum(_) => split(first, self.term(sum, j)).1,
            Divisor::Product(a, b) => {
                let times = divisor_multiplicity(&first.factors, *a, *b);
                let mut rest = first.clone();
                divide_by(&mut rest.factors, *a, times);
                divide_by(&mut rest.factors, *b, times);
                rest
            }
            Divisor::Scaled(_, a) => {
                let mut rest = first.clone();
                divide_by(&mut rest.factors, *a, 1);
                rest.k = if rest.k.is_negative() { Rational::MINUS_ONE } else { Rational::ONE };
                rest
            }
        }
    }

    /// Power with which a divisor divides the terms at a position of the network.
    fn multiplicity_at(&self, id: usize, place: Place) -> u32 {
        match &self.divisors[id] {
            Divisor::Product(a, b) => divisor_multiplicity(&self.term(place.sum, place.i).factors, *a, *b),
            Divisor::Sum(_) | Divisor::Scaled(..) => 1,
        }
    }

    /// Number of operations that taking a divisor out at one position saves, without the cost of
    /// the divisor itself.
    fn gain(&self, id: usize, place: Place) -> usize {
        let Place { sum, i, j } = place;
        let mut before = self.term(sum, i).multiplications();
        if i != j {
            before += self.term(sum, j).multiplications() + 1;
        }
        let rest = self.cofactor(id, place);
        let degree: u32 = rest.factors.iter().map(|(_, n)| *n).sum();
        let after = (degree + self.multiplicity_at(id, place)) as usize - 1 + usize::from(!is_unit(&rest.k));
        before.saturating_sub(after)
    }

    /// Number of operations that taking a divisor out at all its positions saves, minus the cost of
    /// the divisor itself.
    fn saving(&self, id: usize) -> usize {
        let total: usize = self.places(id).iter().map(|place| self.gain(id, *place)).sum();
        let candidate = &self.candidates[id];
        total.saturating_sub(if candidate.defined.is_some() { 0 } else { candidate.cost })
    }

    /// Takes a divisor out at all its positions, and adds the divisors of the new terms to the
    /// table.
    fn take_out(&mut self, id: usize) {
        let places = self.places(id);
        let (atom, kept) = self.atom_of_divisor(id, &places);
        for place in places {
            if Some(place) == kept {
                continue;
            }
            let Place { sum, i, j } = place;
            let mut rest = self.cofactor(id, place);
            let times = self.multiplicity_at(id, place);
            multiply_by(&mut rest.factors, atom, times);
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

    /// Atom whose value is the divisor; a new atom is created if needed. If an existing sum defines
    /// the divisor, the position of this sum is returned too, else `None`.
    fn atom_of_divisor(&mut self, id: usize, places: &[Place]) -> (Atom, Option<Place>) {
        if let Some(atom) = self.candidates[id].defined {
            return (atom, None);
        }
        if let Some(place) = self.whole_sum(id, places) {
            self.candidates[id].defined = Some(place.sum);
            self.definition_of.insert(place.sum, id);
            return (place.sum, Some(place));
        }
        let terms: Vec<Option<NetworkTerm>> = match &self.divisors[id] {
            Divisor::Sum(terms) => terms.iter().cloned().map(Some).collect(),
            Divisor::Product(a, b) => {
                let mut factors = Factors::new();
                multiply_by(&mut factors, *a, 1);
                multiply_by(&mut factors, *b, 1);
                vec![Some(NetworkTerm { k: Rational::ONE, factors })]
            }
            Divisor::Scaled(k, a) => vec![Some(NetworkTerm { k: k.clone(), factors: vec![(*a, 1)] })],
        };
        let places: Vec<usize> = (0..terms.len()).collect();
        let atom = self.network.push_atom(Value::Sum(terms));
        self.candidates[id].defined = Some(atom);
        self.definition_of.insert(atom, id);
        for (i, at) in places.iter().enumerate() {
            self.register(atom, *at, &places[..i], Some(id));
        }
        (atom, None)
    }
}

/// Absolute value of a rational number.
fn magnitude(k: &Rational) -> Rational {
    if k.is_negative() { k.neg() } else { k.clone() }
}

/// Number of times that the product a·b divides a product of atoms.
fn divisor_multiplicity(factors: &Factors, a: Atom, b: Atom) -> u32 {
    let exponent = |atom: Atom| factors.iter().find(|(e, _)| *e == atom).map_or(0, |(_, n)| *n);
    if a == b { exponent(a) / 2 } else { exponent(a).min(exponent(b)) }
}

/// Divides a product of atoms (leaves, inverses and sums of the network) by atom^times.
fn divide_by(factors: &mut Factors, atom: Atom, times: u32) {
    for (e, n) in factors.iter_mut() {
        if *e == atom {
            *n -= times.min(*n);
        }
    }
    factors.retain(|(_, n)| *n > 0);
}

/// Multiplies a product of atoms (leaves, inverses and sums of the network) by atom^times.
fn multiply_by(factors: &mut Factors, atom: Atom, times: u32) {
    match factors.binary_search_by_key(&atom, |(e, _)| *e) {
        Ok(at) => factors[at].1 += times,
        Err(at) => factors.insert(at, (atom, times)),
    }
}

/// Splits the sum of two terms into divisor · cofactor. The divisor is a sum of two terms without a
/// common factor; the cofactor is a single term.
fn split(a: &NetworkTerm, b: &NetworkTerm) -> (Divisor, NetworkTerm) {
    let mut common = Factors::new();
    for (atom, n) in &a.factors {
        if let Some((_, m)) = b.factors.iter().find(|(e, _)| e == atom) {
            common.push((*atom, *n.min(m)));
        }
    }
    let reduced = |term: &NetworkTerm| {
        let mut factors = term.factors.clone();
        for (atom, n) in &common {
            divide_by(&mut factors, *atom, *n);
        }
        NetworkTerm { k: term.k.clone(), factors }
    };
    let mut pair = [reduced(a), reduced(b)];
    if pair[1].factors < pair[0].factors {
        pair.swap(0, 1);
    }
    let mut content = magnitude(&pair[0].k.greatest_common_divisor(&pair[1].k));
    if pair[0].k.is_negative() {
        content = content.neg();
    }
    let inverse = content.reciprocal().expect("terms are not zero");
    for term in &mut pair {
        term.k = term.k.mul(&inverse);
    }
    (Divisor::Sum(Box::new(pair)), NetworkTerm { k: content, factors: common })
}
