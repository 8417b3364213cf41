//! Prescribed motions: angles that are formulas of time, and potentials of coordinates that a constraint prescribes.
//!
//! Truth: closed forms, and Lagrange's equations of the coordinate that is prescribed, derived by SymPy.

use crate::driven::{G, PENDULUM, near, run, samples, scene};

/// Goal: an angle given as a formula of time moves like one that a constraint prescribes. Method: a rod at φ = w t + b
/// t²/2. Its mass centre, and the closed forms of its support and drive: J φ" + m g l/2 cos φ with J = m l²/3, and m (a
/// + g) in total.
#[test]
fn a_rod_whose_angle_is_told_shows_what_drives_it() {
    let told = PENDULUM.replace(
        "[joints]\nA = { kind = \"pin\", body = \"rod\", centre = [0, \"-l/2\", 0], coordinates = [\"q\"], speeds = [\"u\"] }\n",
        "[frames]\nA = { from = \"N\", axis = 3, angle = \"w*t + b*t^2/2\" }\n[points]\nC = { from = \"O\", frame = \"A\", position = [\"l/2\", 0, 0] }\n",
    );
    let told = told.replace("[inertial]", "w = \"3 1/s\"\nb = \"0.5 1/s^2\"\n[inertial]");
    let told = told.replace("rod = { mass", "rod = { frame = \"A\", centre = \"C\", mass");
    let outputs = "outputs = [\"p(C) @ N [1]\", { name = \"motor\", value = \"torque(ground on rod about O) @ N [3]\" }, { name = \"along\", value = \
                   \"force(ground on rod) @ A [1]\" }, { name = \"across\", value = \"force(ground on rod) @ A [2]\" }]";
    let scene = scene(&told, &format!("model = \"model.toml\"\nspan = [0.5, 2]\n{outputs}\n[start]\n"));
    let (m, l, w, b) = (2.0, 0.6, 3.0, 0.5);
    for by in ["own", "kane", "lagrange", "newton-euler"] {
        let run = run(&scene, by);
        assert!(
            run.failure().is_none() && run.solution.t_end.to_bits() == 2.0_f64.to_bits(),
            "{by}: {:?}",
            run.objections()
        );
        for (t, values) in samples(&run, &["p(C) @ N [1]", "motor", "along", "across"]) {
            let [x, motor, along, across] = values[..] else { panic!("four") };
            let (angle, rate) = (w * t + b * t * t / 2.0, w + b * t);
            near(x, l / 2.0 * angle.cos(), 1e-12, by);
            near(motor, m * l * l / 3.0 * b + m * G * l / 2.0 * angle.cos(), 1e-11, by);
            near(along, m * (G * angle.sin() - l / 2.0 * rate * rate), 1e-11, by);
            near(across, m * (G * angle.cos() + l / 2.0 * b), 1e-11, by);
        }
    }
}

/// Goal: a potential of a prescribed angle loads its motor. Method: two rods, the first turned at q1 = w t, with V = k
/// (q1 + q2)²/2 + k q1²/4. The motor's torque at the start is found by Lagrange's equations for q1, derived by SymPy.
/// Also one rod alone, in closed form: k w t + m g l/2 cos(w t).
#[test]
fn a_potential_of_a_prescribed_angle_loads_its_motor() {
    let pin = |name: &str, body: &str, to: &str, q: &str| {
        format!(
            "{name} = {{ kind = \"pin\", body = \"{body}\", {to}centre = [\"l/2\", 0, 0], coordinates = [\"{q}\"], speeds = [] }}\n"
        )
    };
    let head = |count: usize| {
        let two = if count == 2 { "two = { mass = \"m\", inertia = \"m*l^2/12\" }\n" } else { "" };
        format!(
            "name = \"rods\"\n[parameters]\nm = \"2 kg\"\nl = \"0.5 m\"\nw = \"3 1/s\"\nk = \"7 N*m\"\ng = \"9.81 m/s^2\"\n[inertial]\nframe = \
             \"N\"\norigin = \"O\"\n[gravity]\nframe = \"N\"\nacceleration = [0, \"-g\", 0]\n[bodies]\none = {{ mass = \"m\", inertia = \"m*l^2/12\" }}\n{two}\
             [constraints]\ncrank = {{ equation = \"q1 = w*t\" }}\n[joints]\n{}",
            pin("A", "one", "", "q1")
        )
    };
    let motor = "outputs = [{ name = \"motor\", value = \"torque(ground on one about A) @ N [3]\" }]";
    let lower = pin("B", "two", "to = \"one\", at = [\"l\", 0, 0], ", "q2").replace("speeds = []", "speeds = [\"u2\"]");
    let both = format!("{}{lower}[potentials]\nspring = \"k*(q1 + q2)^2/2 + k*q1^2/4\"\n", head(2));
    let both = scene(
        &both,
        &format!(
            "model = \"model.toml\"\nspan = [0, 1]\n{motor}\n[start]\nq2 = 0.3\nu2 = 0\n[integration]\nrtol = 1e-10\natol = 1e-12\n"
        ),
    );
    let alone = format!("{}[potentials]\nspring = \"k*q1^2/2\"\n", head(1));
    let alone = scene(&alone, &format!("model = \"model.toml\"\nspan = [0, 1]\n{motor}\n[start]\n"));
    for by in ["own", "kane", "lagrange", "newton-euler"] {
        let ends = samples(&run(&both, by), &["motor"]);
        near(ends[0].1[0], 3.372_982_027_063_232, 1e-12, by);
        near(ends[ends.len() - 1].1[0], 4.398_359_496, 1e-8, by);
        for (t, values) in samples(&run(&alone, by), &["motor"]) {
            near(values[0], 7.0 * 3.0 * t + 2.0 * G * 0.25 * (3.0 * t).cos(), 1e-11, by);
        }
    }
}
