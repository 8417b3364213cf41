//! Cost of watching an event: runs of the disk with an event in ranges, with a sampled event, and with none.
//!
//! `cargo bench -p tripos-benches --features measure --bench events`. Each figure is the median of short turns, taken
//! alternately; an event is a tape, as those of scenes are, in the parameters and the integrated state.

use std::hint::black_box;
use std::time::Instant;

use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::value::tape::{Numeric, Tape};
use tripos_derive::algebra::{Arena, Expr};
use tripos_models::disk::kane::Kane;
use tripos_sim::{
    Direction, EliminatedDynamics, Event, InRanges, LentRightHandSide, Method, Options, OutputOption, integrate,
};
use tripos_traits::Enclosure;

const P: [f64; 3] = [1.0, 1.0, 9.81];
const START: [f64; 10] = [0.17, 0.035, 0.78, 5.0, 1.0, 0.01, -0.1, 0.02, 0.4, 0.1];
const TURNS: usize = 41;

/// An event function of the state, in numbers and in ranges.
struct Watched {
    tape: Tape,
    ranges: Tape<Enclosure>,
}

impl Watched {
    fn new(text: &str) -> Self {
        let mut arena = Arena::new();
        let names = ["q1", "q2", "q3", "q4", "q5", "u1", "u2", "u3", "u4", "u5"];
        let inputs: Vec<Expr> = names.iter().map(|name| arena.symbol(name)).collect();
        let e = parse_free(&mut arena, text).unwrap_or_else(|e| panic!("{text}: {e:?}"));
        let tape = Tape::new(&arena, &inputs, &[e]).unwrap_or_else(|e| panic!("{text}: {e:?}"));
        Self { ranges: tape.to(), tape }
    }

    fn event(&self, in_ranges: bool) -> Event<'_> {
        let (mut value, mut range) = (of(&self.tape), of(&self.ranges));
        let event = Event::recorded("watched", Direction::Either, move |_, y: &[f64]| value(y));
        let components = Some(self.tape.used_inputs());
        let ranges = InRanges { function: Box::new(move |_, y| range(y)), components };
        Event { ranges: Some(ranges).filter(|_| in_ranges), ..event }
    }
}

fn of<S: Numeric>(tape: &Tape<S>) -> impl FnMut(&[S]) -> S + '_ {
    let mut scratch = Vec::new();
    move |y| {
        let mut out = [S::int(0)];
        tape.evaluate_into(y, &mut scratch, &mut out);
        out[0]
    }
}

/// Steps and records of a run.
fn run(method: Method, tolerance: f64, events: &mut [Event<'_>]) -> (u64, usize) {
    let mut rhs = EliminatedDynamics::new(&Kane, &P).expect("the disk's accelerations are eliminated");
    let options = Options { method, output: OutputOption::Ends, ..Options::tolerances(tolerance, tolerance) };
    let solution =
        integrate(LentRightHandSide(&mut rhs), (0.0, 5.0), &START, &options, events).expect("the question makes sense");
    (solution.steps, solution.events.len())
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn main() {
    let functions = [
        ("far from zero", "q2 + 10"),
        ("crossed at times", "q2 - 1/2"),
        ("a condition", "1 - cos(q2)*(u2^2 + u1^2)/20 + sin(q2)*u1*u3/20"),
        ("a gate", "exp(-((q1 - 1)*10)^2) - 1/2"),
        ("a wave", "sin(10*q1)"),
    ];
    println!("function, method, tolerance: µs a run without, sampled, in ranges; their ratio; records of each");
    for (method, tolerance) in
        [(Method::Ode45, 1e-6), (Method::Dop853, 1e-6), (Method::Dop853, 1e-10), (Method::Taylor, 1e-10)]
    {
        for (what, text) in functions {
            let watched = Watched::new(text);
            let mut times: [Vec<f64>; 3] = Default::default();
            let mut records = [0; 3];
            for _ in 0..TURNS {
                for (at, (times, records)) in times.iter_mut().zip(&mut records).enumerate() {
                    let begin = Instant::now();
                    let mut events = [watched.event(at == 2)];
                    *records = black_box(run(method, tolerance, &mut events[..usize::from(at > 0)])).1;
                    times.push(begin.elapsed().as_secs_f64() * 1e6);
                }
            }
            let [bare, sampled, ranges] = times.map(median);
            println!(
                "{what}, {}, {tolerance:e}: {bare:.1} {sampled:.1} {ranges:.1}; run {:.2}, watching alone {:.2}; {} {}",
                method.name(),
                ranges / sampled,
                (ranges - bare) / (sampled - bare),
                records[1],
                records[2]
            );
        }
    }
}
