//! Threads share equations.

use tripos::Mechanism;
use tripos::code::{Code, CodePreparation, runnable_code};
use tripos_derive::Formulation;
use tripos_derive::diagnostic::Source;

const MODEL: &str = include_str!("../../models/disk/model.toml");

/// Goal: a thread that computes while another one does gets the same numbers, and waits for nobody. Method: four
/// threads evaluate one set of interpreted equations at states of their own. Each is compared with the numbers of a
/// thread alone, to the bit.
#[test]
fn interpreted_equations_are_shared_by_threads() {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", MODEL)).unwrap_or_else(|e| panic!("{e}"));
    let mechanism = Mechanism::new(model);
    let equations = runnable_code(&mechanism, &Formulation::Kane.into(), None, CodePreparation::Solved).unwrap();
    assert!(!equations.is_compiled());
    let rates = |equations: &Code, at: u32| {
        let x = 0.1 + f64::from(at) / 5000.0;
        let (mut q_dot, mut v_dot) = ([0.0; 5], [0.0; 5]);
        let p = vec![1.5; mechanism.parameters.len()];
        equations.system().derivative(&p, &[x; 5], &[1.0 - x; 5], &mut q_dot, &mut v_dot);
        [q_dot, v_dot].concat().into_iter().map(f64::to_bits).collect::<Vec<_>>()
    };
    let alone: Vec<_> = (0..4000).map(|at| rates(&equations, at)).collect();
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| (0..4000).for_each(|at| assert_eq!(rates(&equations, at), alone[at as usize])));
        }
    });
}
