//! Flights between impacts that become far shorter than the steps.

use crate::impacts::{BALL, scene};
use tripos::Overrides;

/// Goal: no flight is too short for its step. Method: a ball with e = 0.99 is dropped from 1 m, until it rests, by
/// every kind of method. Checked are all instants tₖ = √(2 h/g) (1 + 2 (e + … + eᵏ)), rest from √(2 h/g) (1 + e)/(1 −
/// e) on, and the loss of the whole energy in impacts. The ball is also thrown up by 1e-6 m/s from the floor with 30 s
/// to go. The first step of a method that follows smoothness is then a million times as long as the flight.
#[test]
fn flights_far_shorter_than_steps_are_seen_by_every_method() {
    let (e, fall) = (0.99_f64, 0.2_f64.sqrt());
    for method in ["taylor", "dop853", "ode45", "radau5"] {
        let ball = scene(
            BALL,
            "span = [0, 120]\nstart = { z = 1, w = 0 }\nimpacts.floor = { gap = \"z\", restitution = 0.99 }\n",
        );
        let how = Overrides {
            method: Some(method.parse().unwrap()),
            rtol: Some(1e-11),
            atol: Some(1e-12),
            ..Overrides::default()
        };
        let run = ball.simulate(&how).unwrap();
        assert_eq!(run.solution.stop, tripos_sim::Stop::End, "{method}: {}", run.ending);
        let instants: Vec<f64> = run.solution.impacts.iter().map(|record| record.t).collect();
        assert!(instants.len() > 2000, "{method}: {}", instants.len());
        let (mut wanted, mut flight) = (fall, 2.0 * fall);
        for (k, t) in instants.iter().enumerate() {
            assert!((t - wanted).abs() < 1e-7, "{method}: impact {k} at {t}, {wanted}");
            flight *= e;
            wanted += flight;
        }
        let rest = fall * (1.0 + e) / (1.0 - e);
        assert!((wanted - rest).abs() < 1e-6 && run.end.iter().all(|x| x.abs() < 1e-9), "{method}: {:?}", run.end);

        let ball = scene(
            BALL,
            "span = [0, 30]\nstart = { z = 0, w = 1e-6 }\nimpacts.floor = { gap = \"z\", restitution = 0.5 }\n",
        );
        let run = ball.simulate(&how).unwrap();
        assert_eq!(run.solution.stop, tripos_sim::Stop::End, "{method}: {}", run.ending);
        let first = run.solution.impacts[0].t;
        assert!(
            (first - 2e-7).abs() < 1e-12 && run.end.iter().all(|x| x.abs() < 1e-9),
            "{method}: {first:e} {:?}",
            run.end
        );
    }
}
