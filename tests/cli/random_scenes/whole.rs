//! A scene's motion by the whole model: Kane's equations as terms, solved at each state with partial pivoting.

use nalgebra::{DMatrix, DVector};
use std::path::Path;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::Equations;
use tripos_derive::scene::{Scene, load};
use tripos_derive::{Formulation, Model, derive};
use tripos_sim::{Method, Options, OutputOption, integrate};

/// Instants at which event functions are looked at.
const INSTANTS: usize = 400;

pub struct Whole {
    p: Vec<f64>,
    coordinates: usize,
    /// M, f and q̇ at (p, q, u).
    rates: Tape,
    /// The matrix and the right-hand side of the Newton–Euler rows there.
    balance: Tape,
    /// T and V there.
    energies: Tape,
    /// Outputs, the event and the condition of the domain in p, q, q̇, u, u̇, reactions and energies.
    shown: Tape,
    wanted: usize,
    terminal: bool,
    has_domain: bool,
    t: Vec<f64>,
    y: Vec<Vec<f64>>,
}

impl Whole {
    pub fn new(model: &Path, scene: &Path) -> Self {
        let mut model = Model::read(model).unwrap_or_else(|e| panic!("{e}"));
        let scene = load(&Source::read(scene).unwrap(), &mut model).unwrap_or_else(|e| panic!("{e}"));
        let kane = derive(&model, Formulation::Kane).unwrap();
        let newton_euler =
            derive(&model, Formulation::NewtonEuler).unwrap_or_else(|e| panic!("{}", model.diagnose(&e)));
        let state = [model.p(), model.q(), model.u()].concat();
        let system = |e: &Equations| [e.matrix.concat(), e.forcing.clone()].concat();
        let tape = |arena, values: &[Expr]| Tape::new(arena, &state, values).unwrap();
        let rates = tape(&kane.arena, &[system(&kane.equations), kane.equations.coordinate_rates.clone()].concat());
        let balance = tape(&newton_euler.arena, &system(&newton_euler.equations));
        let energies = tape(&kane.arena, &[kane.equations.kinetic_energy, kane.equations.potential_energy]);
        let shown = shown(&model, &scene);
        let mut whole = Self {
            p: scene.parameters.clone(),
            coordinates: scene.q.len(),
            rates,
            balance,
            energies,
            shown,
            wanted: scene.outputs.len(),
            terminal: scene.events[0].terminal,
            has_domain: !model.domain.is_empty(),
            t: Vec::new(),
            y: Vec::new(),
        };
        let (from, to) = scene.span;
        let instants: Vec<f64> = (0..=INSTANTS).map(|i| from + (to - from) * i as f64 / INSTANTS as f64).collect();
        whole.y = whole.run(&[scene.q, scene.u].concat(), &instants);
        whole.t = instants;
        whole
    }

    /// The states at these instants, from the first of them.
    fn run(&self, start: &[f64], instants: &[f64]) -> Vec<Vec<f64>> {
        let rhs = |_: f64, y: &[f64], dy: &mut [f64]| {
            let (q_dot, u_dot) = self.derivative(y);
            dy[..self.coordinates].copy_from_slice(&q_dot);
            dy[self.coordinates..].copy_from_slice(&u_dot);
            Ok::<(), tripos_sim::Failure>(())
        };
        let options = Options {
            method: Method::Dop853,
            output: OutputOption::At(instants.to_vec()),
            ..Options::tolerances(1e-13, 1e-13)
        };
        let span = (instants[0], *instants.last().unwrap());
        if span.0 - span.1 == 0.0 {
            return vec![start.to_vec()];
        }
        let run = integrate(rhs, span, start, &options, &mut []).unwrap();
        assert_eq!(run.stop.code(), "end");
        run.y
    }

    fn derivative(&self, y: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let values = self.rates.evaluate(&[&self.p, y].concat());
        let n = y.len() - self.coordinates;
        let u_dot = solve(&values[..n * n], &values[n * n..n * n + n]);
        (values[n * n + n..].to_vec(), u_dot)
    }

    /// Outputs, event, domain at a state.
    fn values(&self, y: &[f64]) -> Vec<f64> {
        let (q, u) = y.split_at(self.coordinates);
        let (q_dot, u_dot) = self.derivative(y);
        let state = [&self.p, y].concat();
        let balance = self.balance.evaluate(&state);
        // n² + n entries.
        let n = (0..=balance.len()).find(|n| n * n + n == balance.len()).unwrap();
        let unknowns = solve(&balance[..n * n], &balance[n * n..]);
        let energies = self.energies.evaluate(&state);
        let energies = [energies[0], energies[1], energies[0] + energies[1]];
        self.shown.evaluate(&[&self.p, q, &q_dot, u, &u_dot, &unknowns[u.len()..], &energies].concat())
    }

    /// The state at any instant of the span.
    fn state(&self, t: f64) -> Vec<f64> {
        let at = self.t.partition_point(|x| *x <= t).max(1) - 1;
        self.run(&self.y[at], &[self.t[at], t]).pop().unwrap()
    }

    /// Outputs of the scene at an instant.
    pub fn outputs(&self, t: f64) -> Vec<f64> {
        self.values(&self.state(t))[..self.wanted].to_vec()
    }

    /// When the run must end.
    pub fn ends_at(&self, stops_in_domain: bool) -> f64 {
        let last = *self.t.last().unwrap();
        let first = |which| self.crossings(last, which).first().copied();
        let event = first(0).filter(|_| self.terminal);
        let domain = first(1).filter(|_| stops_in_domain);
        event.into_iter().chain(domain).fold(last, f64::min)
    }

    /// True if the event function is zero throughout, so that rounding decides its sign.
    pub fn event_is_noise(&self) -> bool {
        self.y.iter().all(|y| self.values(y)[self.wanted].abs() < 1e-9)
    }

    /// When the event crosses zero (0), or the condition of the domain from above (1), up to an instant.
    pub fn crossings(&self, until: f64, which: usize) -> Vec<f64> {
        if which == 1 && !self.has_domain {
            return Vec::new();
        }
        let value = |y: &[f64]| self.values(y)[self.wanted + which];
        let values: Vec<f64> = self.y.iter().map(|y| value(y)).collect();
        let mut found = Vec::new();
        for at in 1..values.len() {
            let falls = values[at - 1] > 0.0 && values[at] <= 0.0;
            let rises = values[at - 1] < 0.0 && values[at] >= 0.0;
            if falls || (rises && which == 0) {
                let (mut low, mut high) = (self.t[at - 1], self.t[at]);
                for _ in 0..40 {
                    let middle = 0.5 * (low + high);
                    let before = (value(&self.state(middle)) > 0.0) == falls;
                    (low, high) = if before { (middle, high) } else { (low, middle) };
                }
                found.push(high);
            }
        }
        found.retain(|t| *t <= until + 1e-6);
        found
    }
}

/// Outputs of the scene, its events and the domain, as functions of all named quantities.
fn shown(model: &Model, scene: &Scene) -> Tape {
    let arena = &model.arena;
    let u_dot: Vec<Expr> = model.speeds.iter().map(|s| s.rate).collect();
    let reactions: Vec<Expr> = model.reactions.iter().map(|r| r.symbol).collect();
    let mut inputs = [model.p(), model.q(), model.q_dot(), model.u(), u_dot, reactions].concat();
    let mut arena = arena.clone();
    inputs.extend(["kinetic_energy", "potential_energy", "total_energy"].map(|name| arena.symbol(name)));
    let outputs = scene.outputs.iter().map(|o| o.value);
    let events = scene.events.iter().map(|e| e.function);
    let domain = model.domain.iter().map(|c| c.positive);
    Tape::new(&arena, &inputs, &outputs.chain(events).chain(domain).collect::<Vec<_>>()).unwrap()
}

/// A x = b by elimination with partial pivoting.
fn solve(matrix: &[f64], right: &[f64]) -> Vec<f64> {
    let n = right.len();
    let matrix = DMatrix::from_row_slice(n, n, matrix);
    let solution = matrix.lu().solve(&DVector::from_column_slice(right)).expect("regular");
    solution.as_slice().to_vec()
}
