//! One run of an emitted module, as a program of its user's own: the parameters, q and q̇ of the start and the
//! tolerance are arguments; prints q and q̇ at t = 10 s. A part of `benches/peers/run.py`, which puts it beside the
//! module `disk`.

#[allow(non_snake_case)]
mod disk;

use tripos_sim::{EliminatedDynamics, LentRightHandSide, Method, Options, OutputOption, Stop, integrate};

fn main() {
    let numbers: Vec<f64> = std::env::args().skip(1).map(|word| word.parse().expect("a number")).collect();
    let (parameters, rest) = numbers.split_at(disk::PARAMETERS.len());
    let (tolerance, start) = rest.split_last().expect("a tolerance");
    let options = Options {
        method: Method::Dop853,
        output: OutputOption::Ends,
        ..Options::tolerances(*tolerance, *tolerance)
    };
    let mut rhs = EliminatedDynamics::new(&disk::lagrange::Lagrange, parameters).expect("solved for");
    let run = integrate(LentRightHandSide(&mut rhs), (0.0, 10.0), start, &options, &mut []).expect("a run");
    assert_eq!(run.stop, Stop::End);
    println!("{}", run.y_end.iter().map(f64::to_string).collect::<Vec<_>>().join(" "));
}
