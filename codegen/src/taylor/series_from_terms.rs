//! Conversion of the right-hand side of a system into Taylor series, one operation at a time.

use super::products::{FactorBase, FactorPairs, ProductFactor};
use super::recurrences::{Operand, Recurrences, Rule, Series};
use rustc_hash::{FxHashMap, FxHashSet};
use tripos_derive::algebra::term::calculus::Substitution;
use tripos_derive::algebra::term::steps::{Definition, needed_steps};
use tripos_derive::algebra::{Arena, Expr, Function, Node};

/// Converts states and their rates into recurrences. The rates are terms in states, parameters and the symbols of
/// `steps`. The form of the terms is not changed. `None` if a term contains |x| or sign x, which have no Taylor
/// series everywhere.
pub fn series_from_terms(
    arena: &mut Arena,
    states: &[Expr],
    rates: &[Expr],
    steps: &[Definition],
) -> Option<Recurrences> {
    let steps = needed_steps(arena, steps, rates);
    let roots: Vec<Expr> = steps.iter().map(|step| step.value).chain(rates.iter().copied()).collect();
    let parts = arena.reachable(&roots);
    let analytic = |e: &Expr| !matches!(arena.node(*e), Node::Apply(Function::Abs | Function::Sign, _));
    if !parts.iter().all(analytic) {
        return None;
    }
    let varying = terms_with_series(arena, states, rates, &steps);
    let mut pairs = FactorPairs::default();
    let products = products_for_series(arena, &mut pairs, &parts, &varying);
    let mut lowering = SeriesBuilder {
        arena,
        varying,
        pairs,
        products,
        series: Vec::new(),
        known: FxHashMap::default(),
        known_pairs: FxHashMap::default(),
        depths: Vec::new(),
        current: Expr::ZERO,
        constants: Substitution::default(),
    };
    for (at, state) in states.iter().enumerate() {
        if lowering.varying.contains(state) {
            lowering.current = *state;
            let x = lowering.push(*state, Rule::State(at));
            lowering.known.insert(*state, Operand::Scaled(Expr::ONE, x));
        }
    }
    let mut constants = Vec::new();
    for step in &steps {
        lowering.current = step.symbol;
        let operand = lowering.term(step.value);
        if let Operand::Constant(value) = operand {
            constants.push((step.symbol, value));
            lowering.constants = Substitution::new(&constants);
        }
        lowering.known.insert(step.symbol, operand);
    }
    let mut operands = Vec::new();
    for (state, rate) in states.iter().zip(rates) {
        lowering.current = *state;
        operands.push(lowering.term(*rate));
    }
    Some(merge_linear_series(
        Recurrences { series: lowering.series, states: states.to_vec(), rates: operands },
        lowering.arena,
    ))
}

/// Returns the terms that change in time: states whose rate is not 0, and all terms that contain such states,
/// directly or through steps.
pub fn terms_with_series(arena: &Arena, states: &[Expr], rates: &[Expr], steps: &[Definition]) -> FxHashSet<Expr> {
    let value = |rate: Expr| steps.iter().find(|step| step.symbol == rate).map_or(rate, |step| step.value);
    let mut varying: FxHashSet<Expr> =
        states.iter().zip(rates).filter(|(_, rate)| value(**rate) != Expr::ZERO).map(|(state, _)| *state).collect();
    let spread = |varying: &mut FxHashSet<Expr>, roots: &[Expr]| {
        for e in arena.reachable(roots) {
            if arena.operands(e).any(|operand| varying.contains(&operand)) {
                varying.insert(e);
            }
        }
    };
    for step in steps {
        spread(&mut varying, &[step.value]);
        if varying.contains(&step.value) {
            varying.insert(step.symbol);
        }
    }
    spread(&mut varying, rates);
    varying
}

/// Returns the factors of every product that changes in time. Pairs of factors that several
/// products share are joined.
fn products_for_series(
    arena: &Arena,
    pairs: &mut FactorPairs,
    parts: &[Expr],
    varying: &FxHashSet<Expr>,
) -> FxHashMap<Expr, Vec<ProductFactor>> {
    let mut names = Vec::new();
    let mut lists = Vec::new();
    for &e in parts.iter().filter(|e| varying.contains(*e)) {
        if let Node::Product(factors) = arena.node(e) {
            let factors = factors.iter().filter(|(base, _)| varying.contains(base));
            let mut list: Vec<ProductFactor> = factors.flat_map(|(base, n)| pairs.power(*base, *n)).collect();
            list.sort_unstable();
            names.push(e);
            lists.push(list);
        }
    }
    pairs.share(&mut lists);
    names.into_iter().zip(lists).collect()
}

/// State of the conversion of terms into series.
struct SeriesBuilder<'a> {
    /// Arena that stores the terms of the system.
    arena: &'a mut Arena,
    /// Terms that change in time: states and terms that contain them.
    varying: FxHashSet<Expr>,
    /// Pairs of factors that several products share.
    pairs: FactorPairs,
    /// Factors of each product that changes in time, with shared pairs joined.
    products: FxHashMap<Expr, Vec<ProductFactor>>,
    /// Series converted so far. Each comes after the series that its rule reads.
    series: Vec<Series>,
    /// Series or constant of each term that is converted.
    known: FxHashMap<Expr, Operand>,
    /// Series of each pair of factors that is converted, by the index of the pair.
    known_pairs: FxHashMap<usize, Operand>,
    /// Approximate number of successive operations at one order before the coefficient of each
    /// series is known.
    depths: Vec<usize>,
    /// State or step whose value is being converted.
    current: Expr,
    /// Replacement of each step that is constant in time by its value.
    constants: Substitution,
}

impl SeriesBuilder<'_> {
    /// Adds a series for a term with the rule of its coefficients. Returns the index of the series.
    fn push(&mut self, term: Expr, rule: Rule) -> usize {
        let cost = match &rule {
            Rule::State(_) => 0,
            Rule::Linear { .. } => 1,
            Rule::Product(..) | Rule::Forward { .. } => 2,
            Rule::Quotient(..) | Rule::Root(_) | Rule::Backward { .. } => 3,
        };
        let before = rule.reads().iter().map(|x| self.depths[*x]).max().unwrap_or(0);
        self.depths.push(before + cost);
        self.series.push(Series { term, rule, needed_by: self.current });
        self.series.len() - 1
    }

    /// Converts a term and all its subterms. Returns the term's series or constant.
    fn term(&mut self, e: Expr) -> Operand {
        for part in self.arena.reachable(&[e]) {
            if !self.known.contains_key(&part) {
                let operand = self.series_of_term(part);
                self.known.insert(part, operand);
            }
        }
        self.known[&e]
    }

    /// Converts a term whose operands are already converted. Returns its series or constant.
    fn series_of_term(&mut self, e: Expr) -> Operand {
        if !self.varying.contains(&e) {
            return Operand::Constant(self.constants.apply(self.arena, e));
        }
        match self.arena.node(e).clone() {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => Operand::Constant(e),
            Node::Sum(constant, terms) => {
                let mut sum = vec![self.arena.number(constant)];
                let mut list = Vec::new();
                for (term, k) in &terms {
                    match self.known[term] {
                        Operand::Constant(value) => sum.push(self.arena.scale(value, k)),
                        Operand::Scaled(weight, x) => list.push((self.arena.scale(weight, k), x)),
                    }
                }
                let constant = self.arena.sum(&sum);
                match list.as_slice() {
                    [(weight, x)] if constant == Expr::ZERO => Operand::Scaled(*weight, *x),
                    _ => Operand::Scaled(Expr::ONE, self.push(e, Rule::Linear { constant, terms: list })),
                }
            }
            Node::Product(factors) => self.product(e, &factors),
            Node::Named(_, term) => self.known[&term],
            Node::Apply(f, argument) => {
                let x = self.series_without_factor(argument);
                Operand::Scaled(Expr::ONE, self.function(e, f, argument, x))
            }
        }
    }

    /// Returns the index of a series without a constant factor for a converted term. The term must change in time.
    fn series_without_factor(&mut self, e: Expr) -> usize {
        match self.known[&e] {
            Operand::Scaled(Expr::ONE, x) => x,
            Operand::Scaled(weight, x) => {
                let x = self.push(e, Rule::Linear { constant: Expr::ZERO, terms: vec![(weight, x)] });
                self.known.insert(e, Operand::Scaled(Expr::ONE, x));
                x
            }
            Operand::Constant(_) => unreachable!("only what changes is a series"),
        }
    }

    /// Converts a product. Its constant factors become the weight of the series. Its other factors are joined two by
    /// two.
    fn product(&mut self, e: Expr, factors: &[(Expr, i32)]) -> Operand {
        let mut weight = Expr::ONE;
        for (base, n) in factors {
            if !self.varying.contains(base) {
                let constant = self.constants.apply(self.arena, *base);
                let power = self.arena.pow(constant, *n).expect("a divisor is not 0");
                weight = self.arena.mul(weight, power);
            }
        }
        let mut atoms: Vec<(ProductFactor, usize)> = Vec::new();
        for atom in self.products[&e].clone() {
            let (constant, x) = self.series_of_factor(atom);
            weight = self.arena.mul(weight, constant);
            atoms.push((atom, x));
        }
        // Factors whose coefficients are known early are joined early.
        while atoms.len() > 1 {
            atoms.sort_by_key(|(atom, x)| (std::cmp::Reverse(self.depths[*x]), *atom));
            let (Some((a, _)), Some((b, _))) = (atoms.pop(), atoms.pop()) else { break };
            let joined = self.pairs.join_factors(a, b);
            // The variable `weight` already contains the weights of both factors.
            let (_, x) = self.series_of_factor(joined);
            atoms.push((joined, x));
        }
        let (atom, x) = atoms[0];
        if !atom.inverse {
            return Operand::Scaled(weight, x);
        }
        let term = self.arena.div(Expr::ONE, self.series[x].term).expect("a divisor is not 0");
        let reciprocal = match self.known.get(&term) {
            Some(Operand::Scaled(Expr::ONE, known)) => *known,
            _ => self.push(term, Rule::Quotient(None, x)),
        };
        self.known.insert(term, Operand::Scaled(Expr::ONE, reciprocal));
        Operand::Scaled(weight, reciprocal)
    }

    /// Returns the constant factor and the index of the series for a factor or divisor. For a divisor, the constant
    /// factor is the reciprocal of the constant factor of its series.
    fn series_of_factor(&mut self, atom: ProductFactor) -> (Expr, usize) {
        let operand = match atom.base {
            FactorBase::Term(e) => self.known[&e],
            FactorBase::Pair(place) => self.pair(place),
        };
        let Operand::Scaled(weight, x) = operand else { unreachable!("only what changes is a factor") };
        let weight = if atom.inverse { self.arena.div(Expr::ONE, weight).expect("weights are not 0") } else { weight };
        (weight, x)
    }

    /// Converts a pair of factors, after the pairs inside it. The nesting depth is at most the number of factors in a
    /// product.
    fn pair(&mut self, place: usize) -> Operand {
        if let Some(known) = self.known_pairs.get(&place) {
            return *known;
        }
        let [a, b] = self.pairs.atoms(place);
        let ((weight_a, x), (weight_b, y)) = (self.series_of_factor(a), self.series_of_factor(b));
        let [s, t] = [x, y].map(|x| self.series[x].term);
        let n = if b.inverse { -1 } else { 1 };
        let term = self.arena.try_product(&[(s, 1), (t, n)]).expect("a divisor is not 0");
        let rule = if b.inverse { Rule::Quotient(Some(x), y) } else { Rule::Product(x, y) };
        let weight = self.arena.mul(weight_a, weight_b);
        let operand = Operand::Scaled(weight, self.push(term, rule));
        self.known_pairs.insert(place, operand);
        operand
    }

    /// Converts a function value f(x), and adds the further series that its recurrence needs. `x` is the index of the
    /// argument's series. Returns the index of the new series.
    fn function(&mut self, e: Expr, f: Function, argument: Expr, x: usize) -> usize {
        match f {
            Function::Sin | Function::Sinh => self.sine_cosine_series(f, argument, x).0,
            Function::Cos | Function::Cosh => self.sine_cosine_series(f, argument, x).1,
            Function::Sqrt => self.push(e, Rule::Root(x)),
            Function::Exp => {
                let z = self.series.len();
                self.push(e, Rule::Forward { value: f, of: x, slope: z, negative: false })
            }
            Function::Tanh => {
                // z' = x' (1 − z²)
                let z = self.series.len();
                self.push(e, Rule::Forward { value: f, of: x, slope: z + 2, negative: false });
                let square = self.arena.square(e);
                let square_at = self.push(square, Rule::Product(z, z));
                let slope = self.arena.sub(Expr::ONE, square);
                let terms = vec![(Expr::MINUS_ONE, square_at)];
                self.push(slope, Rule::Linear { constant: Expr::ONE, terms });
                z
            }
            Function::Log => self.push(e, Rule::Backward { value: f, of: x, slope: x, negative: false }),
            Function::Atan | Function::Asin | Function::Acos => {
                // z' (1 + x²) = x', or ±z' √(1 − x²) = x'
                let square = self.arena.square(argument);
                let square_at = self.push(square, Rule::Product(x, x));
                let root = f != Function::Atan;
                let signed = if root { self.arena.neg(square) } else { square };
                let sum = self.arena.add(Expr::ONE, signed);
                let sign = if root { Expr::MINUS_ONE } else { Expr::ONE };
                let mut slope = self.push(sum, Rule::Linear { constant: Expr::ONE, terms: vec![(sign, square_at)] });
                if root {
                    let term = self.arena.apply(Function::Sqrt, sum);
                    slope = self.push(term, Rule::Root(slope));
                }
                self.push(e, Rule::Backward { value: f, of: x, slope, negative: f == Function::Acos })
            }
            Function::Abs | Function::Sign => unreachable!("refused before"),
        }
    }

    /// Converts a sine with its cosine, or a hyperbolic sine with its cosine. Each of the two is the derivative of
    /// the other, up to sign. Returns the indices of both series.
    fn sine_cosine_series(&mut self, f: Function, argument: Expr, x: usize) -> (usize, usize) {
        let round = matches!(f, Function::Sin | Function::Cos);
        let (one, other) = if round { (Function::Sin, Function::Cos) } else { (Function::Sinh, Function::Cosh) };
        let sine = self.arena.apply(one, argument);
        if let Some(Operand::Scaled(_, at)) = self.known.get(&sine) {
            return (*at, *at + 1);
        }
        let cosine = self.arena.apply(other, argument);
        let at = self.series.len();
        self.push(sine, Rule::Forward { value: one, of: x, slope: at + 1, negative: false });
        self.push(cosine, Rule::Forward { value: other, of: x, slope: at, negative: round });
        self.known.insert(sine, Operand::Scaled(Expr::ONE, at));
        self.known.insert(cosine, Operand::Scaled(Expr::ONE, at + 1));
        (at, at + 1)
    }
}

/// Merges each sum that only one other sum reads into that other sum. Removes series that no rule and no rate reads.
fn merge_linear_series(mut list: Recurrences, arena: &mut Arena) -> Recurrences {
    let count = list.series.len();
    let mut readers = vec![0_usize; count];
    for series in &list.series {
        series.rule.reads().into_iter().for_each(|x| readers[x] += 1);
        if let Rule::Forward { slope, .. } = series.rule {
            readers[slope] += 1;
        }
    }
    for rate in &list.rates {
        if let Operand::Scaled(_, x) = rate {
            readers[*x] += 1;
        }
    }
    for at in 0..count {
        let Rule::Linear { constant, terms } = list.series[at].rule.clone() else { continue };
        let (mut constants, mut merged) = (vec![constant], Vec::<(Expr, usize)>::new());
        let mut add = |arena: &mut Arena, weight: Expr, x: usize| match merged.iter_mut().find(|(_, y)| *y == x) {
            Some((sum, _)) => *sum = arena.add(*sum, weight),
            None => merged.push((weight, x)),
        };
        for (weight, x) in terms {
            match &list.series[x].rule {
                Rule::Linear { constant, terms } if readers[x] == 1 => {
                    constants.push(arena.mul(weight, *constant));
                    for (inner, y) in terms {
                        let product = arena.mul(weight, *inner);
                        add(arena, product, *y);
                    }
                    readers[x] = 0;
                }
                _ => add(arena, weight, x),
            }
        }
        let constant = arena.sum(&constants);
        list.series[at].rule = Rule::Linear { constant, terms: merged };
    }
    let live = series_needed_by_rates(&list);
    let mut place = vec![0; count];
    let mut next = 0;
    for at in 0..count {
        place[at] = next;
        next += usize::from(live[at]);
    }
    let mut at = 0;
    list.series.retain(|_| {
        at += 1;
        live[at - 1]
    });
    list.series.iter_mut().for_each(|series| series.rule.renumber_series(|x| place[x]));
    for rate in &mut list.rates {
        if let Operand::Scaled(_, x) = rate {
            *x = place[*x];
        }
    }
    list
}

/// Returns, for each series, true if the rates need it. The series of states are always needed.
fn series_needed_by_rates(list: &Recurrences) -> Vec<bool> {
    let mut live: Vec<bool> = list.series.iter().map(|s| matches!(s.rule, Rule::State(_))).collect();
    let rate = |operand: &Operand| match operand {
        Operand::Scaled(_, x) => Some(*x),
        Operand::Constant(_) => None,
    };
    let mut stack: Vec<usize> = list.rates.iter().filter_map(rate).collect();
    while let Some(x) = stack.pop() {
        if std::mem::replace(&mut live[x], true) {
            continue;
        }
        let rule = &list.series[x].rule;
        stack.extend(rule.reads());
        if let Rule::Forward { slope, .. } = rule {
            stack.push(*slope);
        }
    }
    live
}
