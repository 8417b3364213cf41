//! Loads that can create energy, by the result of `tripos check`.
//!
//! Truth: textbook forces. A viscous damper takes energy, a follower force gives it on a closed path (H. Ziegler,
//! *Principles of Structural Stability*, 1968, § 2.3), a magnetic force does no work.

use crate::common::read;
use tripos_derive::check::{EnergyEffect, LoadEffect, check};

/// Effects of loads on a particle in a plane, in Cartesian coordinates.
fn particle(loads: &str) -> Vec<LoadEffect> {
    effects(&format!(
        "name = \"particle\"\n[parameters]\nm = {{ unit = \"kg\", value = 2, positive = true }}\nc = {{ unit = \"N*s/m\", value = 0.5 }}\n\
         e = {{ unit = \"N*s/m\", value = -0.5 }}\nk = {{ unit = \"N/m\", value = 3 }}\nF = {{ unit = \"N\", value = 1 }}\n\
         s0 = {{ unit = \"m/s\", value = \"1 mm/s\", positive = true }}\n\
         [coordinates]\nx = {{ unit = \"m\" }}\ny = {{ unit = \"m\" }}\n[speeds]\nu = \"x'\"\nv = \"y'\"\n[inertial]\nframe = \"N\"\n\
         origin = \"O\"\n[points]\nP = {{ from = \"O\", frame = \"N\", position = [\"x\", \"y\", 0] }}\n[particles]\np = {{ point = \"P\", \
         mass = \"m\" }}\n{loads}"
    ))
}

fn effects(text: &str) -> Vec<LoadEffect> {
    let model = read(text).unwrap_or_else(|e| panic!("{e}"));
    check(&model).unwrap_or_else(|e| panic!("{}", model.diagnose(&e))).loads
}

/// Effect of the only load of a particle, with these components.
fn effect(x: &str, y: &str) -> (EnergyEffect, String) {
    let list = particle(&format!("[forces.load]\non = \"p\"\nframe = \"N\"\nvector = [\"{x}\", \"{y}\", 0]\n"));
    assert_eq!(list.len(), 1);
    (list[0].effect, list[0].why.clone())
}

#[test]
fn dampers_dissipate_in_any_direction() {
    for (x, y) in [
        ("-c*u", "-c*v"),
        ("-c*u", "-4*c*v"),
        ("0", "-c*v"),
        // Cross terms within what u² and v² leave: 1·1 − ¼(1 + ½)² > 0; and at the very edge, −c (u + v)².
        ("-c*u - c*v", "-c*v/2"),
        ("-c*(u + v)", "-c*(u + v)"),
        ("-c*u + 3*c*v", "-c*v - 3*c*u"),
        ("-c*(k*x/F)^2*u", "-c*(1 + cos(k*x/F)^2)*v"),
    ] {
        assert_eq!(effect(x, y), (EnergyEffect::Dissipates, String::new()), "{x}, {y}");
    }
}

#[test]
fn negative_dampers_are_found_with_a_state_in_which_they_work() {
    assert_eq!(effect("-e*u", "0"), (EnergyEffect::Creates, "it adds energy at u = 1".to_owned()));
    assert_eq!(effect("0", "c*v").0, EnergyEffect::Creates);
    // −c (u² + 3 u v + v²) is positive at u = −v.
    assert_eq!(effect("-c*u - 3*c*v", "-c*v").0, EnergyEffect::Creates);
    // Negative beyond x = 1 alone, as van der Pol's inside.
    let (effect, why) = effect("c*(1 - (k*x/F)^2)*u", "0");
    assert_eq!((effect, why.as_str()), (EnergyEffect::Creates, "it adds energy at u = 1"));
}

#[test]
fn potentials_and_loads_without_power_keep_energy() {
    for (x, y) in [("-k*x", "-k*y"), ("F", "2*F"), ("-k*y", "-k*x"), ("c*v", "-c*u"), ("c*v - k*x", "-c*u")] {
        assert_eq!(effect(x, y), (EnergyEffect::Keeps, String::new()), "{x}, {y}");
    }
}

#[test]
fn circulatory_forces_are_found_by_their_curl() {
    assert_eq!(effect("-k*y", "k*x"), (EnergyEffect::Creates, "its work depends on the way".to_owned()));
    // A damper beside it does not hide it.
    assert_eq!(effect("-k*y - c*u", "k*x - c*v").0, EnergyEffect::Creates);
}

/// Goal: a force that follows its rod. Method: Ziegler's column of two rods, with a load along the last.
#[test]
fn a_follower_force_can_create_energy_and_a_dead_load_cannot() {
    let column = |frame: &str| {
        effects(&format!(
            "name = \"column\"\n[parameters]\nm = {{ unit = \"kg\", value = 1 }}\nl = {{ unit = \"m\", value = 1 }}\nF = {{ unit = \"N\", value = 1 \
             }}\n[coordinates]\nq1 = {{ unit = \"rad\" }}\nq2 = {{ unit = \"rad\" }}\n[speeds]\nu1 = \"q1'\"\nu2 = \"q2'\"\n[inertial]\nframe = \
             \"N\"\norigin = \"O\"\n[frames]\nA = {{ from = \"N\", axis = 3, angle = \"q1\" }}\nB = {{ from = \"N\", axis = 3, angle = \"q2\" \
             }}\n[points]\nP = {{ from = \"O\", frame = \"A\", position = [\"l\", 0, 0] }}\nQ = {{ from = \"P\", frame = \"B\", position = [\"l\", 0, \
             0] }}\n[particles]\np = {{ point = \"P\", mass = \"m\" }}\nq = {{ point = \"Q\", mass = \"m\" }}\n[forces.load]\non = \"q\"\nframe = \
             \"{frame}\"\nvector = [\"-F\", 0, 0]\n"
        ))
    };
    assert_eq!(column("B")[0].effect, EnergyEffect::Creates);
    assert_eq!(column("N")[0].effect, EnergyEffect::Keeps);
}

#[test]
fn friction_dissipates_and_an_input_does_what_it_is_told() {
    let list = particle(
        "[inputs]\nf = { unit = \"N\", value = 0 }\n[forces.push]\non = \"p\"\nframe = \"N\"\nvector = [\"f\", 0, 0]\n[forces.dry]\non = \
         \"p\"\nframe = \"N\"\nvector = [\"-F*u/sqrt(u^2 + v^2 + s0^2)\", \"-F*v/sqrt(u^2 + v^2 + s0^2)\", 0]\n",
    );
    let known: Vec<_> = list.iter().map(|l| (l.load.as_str(), l.effect, l.why.as_str())).collect();
    assert_eq!(
        known,
        [("push", EnergyEffect::Creates, "the input `f` drives it"), ("dry", EnergyEffect::Dissipates, "")]
    );
}

/// Goal: loads that only together dissipate are not called what each is alone.
#[test]
fn a_stronger_damper_covers_a_negative_one() {
    let force = |name: &str, x: &str| format!("[forces.{name}]\non = \"p\"\nframe = \"N\"\nvector = [\"{x}\", 0, 0]\n");
    let both = particle(&(force("fed", "c*u") + &force("damped", "-2*c*u")));
    assert_eq!(both.iter().map(|l| l.effect).collect::<Vec<_>>(), [EnergyEffect::Dissipates; 2]);
    assert_eq!(both[0].why, "together with the other loads");
    let weaker = particle(&(force("fed", "c*u") + &force("damped", "-c*u/2")));
    assert_eq!(weaker.iter().map(|l| l.effect).collect::<Vec<_>>(), [EnergyEffect::Creates, EnergyEffect::Dissipates]);
}

/// Goal: a damper between points of turning bodies takes energy, however its length depends on their angles. Truth:
/// it takes the power c ḋ² for c > 0; with c < 0 it gives it.
#[test]
fn a_spring_with_a_damper_takes_energy_between_any_points() {
    for (joint, damping, expected) in [
        ("kind = \"pin\", axis = 3", "c", EnergyEffect::Dissipates),
        ("kind = \"universal\"", "c", EnergyEffect::Dissipates),
        ("kind = \"slider\", axis = 2", "2*c", EnergyEffect::Dissipates),
        ("kind = \"pin\", axis = 1", "-c", EnergyEffect::Creates),
    ] {
        let list = effects(&format!(
            "name = \"arms\"\n[parameters]\nm = {{ unit = \"kg\", value = 2, positive = true }}\nl = {{ unit = \"m\", value = 0.4, positive = true }}\n\
             J = {{ unit = \"kg*m^2\", value = 0.1, positive = true }}\nk = {{ unit = \"N/m\", value = 30 }}\nc = {{ unit = \"N*s/m\", value = 0.37 }}\n\
             [inertial]\nframe = \"N\"\norigin = \"O\"\n[bodies]\na = {{ mass = \"m\", inertia = {{ diagonal = [\"J\", \"J\", \"J\"] }} }}\n\
             b = {{ mass = \"m\", inertia = {{ diagonal = [\"J\", \"J\", \"J\"] }} }}\n[joints]\n\
             i = {{ kind = \"pin\", axis = 3, body = \"a\", centre = [\"l\", 0, 0] }}\n\
             j = {{ {joint}, body = \"b\", to = \"a\", at = [\"l\", 0, 0], centre = [\"l\", \"l\", 0] }}\n\
             [points]\nG = {{ from = \"O\", frame = \"N\", position = [\"3*l\", \"l\", 0] }}\n\
             [springs]\ns = {{ on = \"b\", against_at = \"G\", stiffness = \"k\", free_length = \"l\", damping = \"{damping}\" }}\n"
        ));
        assert_eq!(list.iter().map(|l| l.effect).collect::<Vec<_>>(), [expected], "{joint}: {}", list[0].why);
    }
}

#[test]
fn what_is_not_proved_is_not_claimed() {
    // −c u tanh(u) takes energy, and no rule here says so.
    assert_eq!(effect("-F*tanh(u/s0)", "0").0, EnergyEffect::Undecided);
}
