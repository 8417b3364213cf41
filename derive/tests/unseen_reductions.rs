//! Reductions of mechanisms that the library does not have: what they must find, and what they must leave alone.

use crate::reduced;

use expect_test::expect;
use reduced::{integrated, names, output, reduced, show};

/// A model: its parameters and coordinates as `name:unit`, a speed for each rate, and what its tables say beside the
/// inertial frame. All parameters are positive but `c`.
fn model(parameters: &str, coordinates: &str, rest: &str) -> String {
    let table = |title: &str, list: &str, line: &dyn Fn(&str) -> String| {
        format!("[{title}]\n{}\n", list.split_whitespace().map(line).collect::<Vec<_>>().join("\n"))
    };
    let parameter = |entry: &str| {
        let (name, unit) = entry.split_once(':').unwrap();
        let sign = if name == "c" { "" } else { ", positive = true" };
        format!("{name} = {{ unit = \"{unit}\", value = 0.5{sign} }}")
    };
    let coordinate = |entry: &str| {
        let (name, unit) = entry.split_once(':').unwrap();
        format!("{name} = {{ unit = \"{unit}\" }}")
    };
    let speed = |entry: &str| {
        let name = entry.split(':').next().unwrap();
        format!("v{name} = \"{name}'\"")
    };
    let name = "name = \"M\"\n".to_owned();
    let inertial = "[inertial]\nframe = \"N\"\norigin = \"O\"\n";
    let text = [
        name,
        table("parameters", parameters, &parameter),
        table("coordinates", coordinates, &coordinate),
        table("speeds", coordinates, &speed),
        inertial.to_owned(),
        rest.to_owned(),
    ];
    text.concat()
}

/// Two masses on a line, held together by a spring.
fn two_masses() -> String {
    let rest = r#"
        [points]
        A = { from = "O", frame = "N", position = ["x", 0, 0] }
        B = { from = "O", frame = "N", position = ["y", 0, 0] }
        [particles]
        a = { point = "A", mass = "m" }
        b = { point = "B", mass = "M" }
        [forces.spring]
        on = "a"
        against = "b"
        frame = "N"
        vector = ["k*(y - x)", 0, 0]
    "#;
    model("m:kg M:kg k:N/m", "x:m y:m", rest)
}

/// A bead on an arm that turns freely about the vertical, pulled back by a spring.
fn bead_on_an_arm() -> String {
    let rest = r#"
        [frames]
        A = { from = "N", axis = 3, angle = "turn" }
        [points]
        P = { from = "O", frame = "A", position = ["r", 0, 0] }
        [particles]
        bead = { point = "P", mass = "m" }
        [forces.spring]
        on = "bead"
        frame = "A"
        vector = ["-k*r", 0, 0]
    "#;
    model("m:kg k:N/m", "turn:rad r:m", rest)
}

/// Two arms of a mechanism in a plane without gravity, damped between them and, by c, against the ground.
fn damped_arms() -> String {
    let rest = r#"
        [frames]
        A = { from = "N", axis = 3, angle = "a" }
        B = { from = "N", axis = 3, angle = "b" }
        [points]
        P = { from = "O", frame = "A", position = ["l", 0, 0] }
        Q = { from = "P", frame = "B", position = ["l", 0, 0] }
        [particles]
        p = { point = "P", mass = "m" }
        q = { point = "Q", mass = "m" }
        [forces.ground]
        on = "p"
        frame = "A"
        vector = [0, "-c*va", 0]
    "#;
    model("m:kg l:m c:N*s", "a:rad b:rad", rest)
}

#[test]
fn two_masses_on_a_spring_move_by_their_distance() {
    let r = reduced(&two_masses(), "outputs = [\"y - x\"]\nfree = [\"m\", \"M\", \"k\"]");
    expect![[r"
        states: y_from_x, vy_from_vx
        k_per_m_per_M [1/kg/s^2] = k/(m*M)
        y_from_x' = vy_from_vx
        vy_from_vx' = -y_from_x*k_per_m_per_M*(m + M)
        y - x -> y_from_x
        energy known; divided by: nothing
    "]]
    .assert_eq(&show(&r));
    let r = reduced(&two_masses(), "outputs = [\"x\", \"vy\"]");
    assert_eq!(integrated(&r).0.len(), 2);
    assert!(integrated(&r).1.is_empty(), "the mass centre gives x: {:?}", integrated(&r));
}

#[test]
fn a_bead_on_an_arm_feels_its_angular_momentum() {
    let r = reduced(&bead_on_an_arm(), "outputs = [\"r\"]\nfree = [\"m\", \"k\"]");
    expect![[r"
        states: r, vr
        p_turn [kg*m^2/s] = m*r^2*vturn
        k_per_m [1/s^2] = k/m
        vturn = p_turn/(m*r^2)
        r' = vr
        vr' = r*(vturn^2 - k_per_m)
        energy known; divided by: r
    "]]
    .assert_eq(&show(&r));
    let r = reduced(&bead_on_an_arm(), "outputs = [\"turn\"]");
    assert_eq!(integrated(&r), (vec!["r", "vr"], vec!["turn"]));
}

/// Drag that depends on a speed alone gives its momentum to the place: m l² va + c l² a and its like are conserved.
#[test]
fn a_damped_joint_keeps_no_energy_but_what_its_drag_gives_to_the_place() {
    let r = reduced(&damped_arms(), "outputs = [\"a\", \"b\"]\nfree = [\"c\"]");
    expect![[r"
        states: a, b_from_a, vb_from_va
        H_n3_total_scaled [kg*m^2/s] = 4*c*a + va*(2 + cos(a - b)) + vb*(1 + cos(a - b))
        c_times_4 [kg*m/s] = 4*c
        va = (H_n3_total_scaled - vb_from_va*(1 + cos(b_from_a)) - a*c_times_4)/(3 + 2*cos(b_from_a))
        a' = va
        b_from_a' = vb_from_va
        vb_from_va' = (vb_from_va^2*sin(b_from_a)*(1 + cos(b_from_a)) + va*(sin(b_from_a)*(va*(3 + 2*cos(b_from_a)) + 2*vb_from_va*(1 + cos(b_from_a))) - c_times_4*(1 + cos(b_from_a))))/(cos(b_from_a)^2 - 2)
        b -> a + b_from_a
        energy unknown; divided by: nothing
    "]].assert_eq(&show(&r));
    assert!(!r.has_energy);
}

/// A number of the scene has symmetries that the letter has not.
#[test]
fn a_damping_of_zero_restores_the_energy_and_the_momentum() {
    let r = reduced(&damped_arms(), "outputs = [\"b - a\"]\n[parameters]\nc = 0");
    assert_eq!(integrated(&r), (vec!["b_from_a", "vb_from_va"], vec![]));
    assert!(r.has_energy);
    assert_eq!(names(&r.constants).len(), 1);
    assert_eq!(r.constants[0].unit.to_string(), "kg*m^2/s");
}

/// A parameter that is a divisor keeps its letter if its value is 0; the other parameters become numbers.
#[test]
fn a_parameter_that_is_zero_is_not_divided_by() {
    let spring = two_masses().replace("k*(y - x)", "(y - x)/c");
    let spring =
        spring.replace("k = { unit = \"N/m\", value = 0.5, positive = true }", "c = { unit = \"m/N\", value = 0.5 }");
    let r = reduced(&spring, "outputs = [\"y - x\"]\n[parameters]\nc = 0");
    assert_eq!(r.folded.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), ["m", "M"]);
    assert!(r.model.parameters.iter().any(|p| p.name == "c"));
}

#[test]
fn a_free_parameter_stays_a_letter() {
    let letters = |scene: &str| {
        let r = reduced(&two_masses(), scene);
        r.model.parameters.iter().map(|p| p.name.clone()).filter(|n| n.len() == 1).collect::<Vec<_>>()
    };
    assert_eq!(letters("outputs = [\"y - x\"]\nfree = [\"M\"]"), ["M"]);
    assert_eq!(letters("outputs = [\"y - x\"]"), Vec::<String>::new());
}

/// A formula, an energy, rates and accelerations, of which the reduced system has less than the model.
#[test]
fn outputs_may_be_formulas_energies_rates_and_accelerations() {
    let outputs = r#"outputs = [
        { name = "square", value = "(r*turn')^2" }, "turn''", "vr'", "r'", "total_energy", "kinetic_energy", "potential_energy",
    ]
    free = ["m", "k"]"#;
    let r = reduced(&bead_on_an_arm(), &outputs.replace("\"turn''\"", "\"vturn'\""));
    assert_eq!(integrated(&r), (vec!["r", "vr"], vec![]));
    expect![[r"
        states: r, vr
        p_turn [kg*m^2/s] = m*r^2*vturn
        k_per_m [1/s^2] = k/m
        vturn = p_turn/(m*r^2)
        r' = vr
        vr' = r*(vturn^2 - k_per_m)
        square -> r^2*vturn^2
        vturn' -> -2*vturn*vr/r
        vr' -> r*(vturn^2 - k/m)
        r' -> vr
        total_energy -> k*r^2/2 + m*(r^2*vturn^2 + vr^2)/2
        kinetic_energy -> m*(r^2*vturn^2 + vr^2)/2
        potential_energy -> k*r^2/2
        energy known; divided by: r
    "]]
    .assert_eq(&show(&r));
}

/// Two pendulums side by side: the output of one needs nothing of the other.
#[test]
fn a_decoupled_subsystem_is_left_out() {
    let pendulum = |n: u32| {
        format!(
            "[points.P{n}]\nfrom = \"O\"\nframe = \"A{n}\"\nposition = [0, \"-l\", 0]\n[particles.b{n}]\npoint = \"P{n}\"\nmass = \"m\"\n"
        )
    };
    let rest = format!(
        "[frames]\nA1 = {{ from = \"N\", axis = 3, angle = \"a\" }}\nA2 = {{ from = \"N\", axis = 3, angle = \"b\" }}\n{}{}[gravity]\nframe = \"N\"\nacceleration = [0, \"-g\", 0]\n",
        pendulum(1),
        pendulum(2)
    );
    let text = model("m:kg l:m g:m/s^2", "a:rad b:rad", &rest);
    let r = reduced(&text, "outputs = [\"b\"]");
    assert_eq!(integrated(&r), (vec!["b", "vb"], vec![]));
    assert!(!r.has_energy, "the energy of both is no function of one");
    assert_eq!(output(&r, "b"), "b");
    let r = reduced(&text, "outputs = [\"a - b\"]");
    assert_eq!(integrated(&r).0.len(), 4);
}

/// Dependence is by meaning, not by symbols: the force mentions the angle in sin² + cos², and inside a function without
/// rules.
#[test]
fn what_a_formula_mentions_and_does_not_depend_on_is_left_out() {
    for hidden in
        ["(sin(turn)^2 + cos(turn)^2)", "exp(1 - sin(turn)^2 - cos(turn)^2)", "(tan(turn)*cos(turn)/sin(turn))"]
    {
        let text = bead_on_an_arm().replace("-k*r", &format!("-k*r*{hidden}"));
        let r = reduced(&text, "outputs = [\"r\"]");
        assert_eq!(integrated(&r).0, ["r", "vr"], "{hidden}");
        assert!(integrated(&r).1.is_empty(), "{hidden}");
        let angle = r.arena().find_symbol("turn").unwrap();
        assert!(r.derivation.equations.forcing.iter().all(|f| !r.arena().mentions(*f, angle)), "{hidden}");
    }
}

/// exp and asin have no rules: what is shown through them needs what they mention.
#[test]
fn functions_without_rules_are_shown_as_they_stand() {
    let r = reduced(&bead_on_an_arm(), "outputs = [\"exp(-r)\", \"asin(sin(turn))\"]");
    assert_eq!(integrated(&r), (vec!["r", "vr"], vec!["turn"]));
    assert_eq!(output(&r, "asin(sin(turn))"), "asin(sin(turn))");
    let r = reduced(&bead_on_an_arm().replace("-k*r", "-k*r*exp(r*k/k/r)"), "outputs = [\"r\"]");
    assert_eq!(integrated(&r), (vec!["r", "vr"], vec![]));
}

/// The pull of the arm on the bead, m(r ω' + 2 r' ω), is zero: the arm has no inertia.
#[test]
fn a_reaction_is_computed_from_what_is_kept() {
    let text = bead_on_an_arm() + "[reactions.side]\non = \"bead\"\nframe = \"N\"\ndirection = [0, 0, 1]\n";
    let r = reduced(&text, "outputs = [\"side\"]");
    assert_eq!((integrated(&r), output(&r, "side").as_str()), ((vec![], vec![]), "0"));
}

#[test]
fn a_reaction_that_nothing_determines_is_refused_with_the_reason() {
    use tripos_derive::{model, reduce::reduce};
    let side = |name: &str| format!("[reactions.{name}]\non = \"a\"\nframe = \"N\"\ndirection = [0, 0, 1]\n");
    let text = two_masses() + &side("side") + &side("also");
    let source = tripos_derive::diagnostic::Source::from_text("model.toml", &text);
    let mut model = model::load(&source).unwrap();
    let scene = reduced::with_start(&model, "outputs = [\"side\"]");
    let scene = reduced::scene_of(&mut model, &scene);
    let error = reduce(&model, &scene).err().expect("one equation for two of them").to_string();
    assert!(error.contains("newton-euler"), "{error}");
}

/// One particle goes along the rail, driven by a massless crank on the cart x, the other across with the crank's angle:
/// no rigid motion of the whole moves the second alone, and its coordinate stands in the kinetic energy.
#[test]
fn a_symmetry_that_is_no_rigid_motion_is_found() {
    let rest = r#"
        [points]
        A = { from = "O", frame = "N", position = ["x + l*sin(turn)", 0, 0] }
        B = { from = "O", frame = "N", position = [0, "l*turn", 0] }
        [particles]
        a = { point = "A", mass = "m" }
        b = { point = "B", mass = "M" }
    "#;
    let text = model("m:kg M:kg l:m", "x:m turn:rad", rest);
    let r = reduced(&text, "outputs = [\"turn\", \"x\"]\nfree = [\"m\", \"M\", \"l\"]");
    expect![[r"
        p_x [kg*m/s] = m*(vx + l*vturn*cos(turn))
        momentum2 [kg*m/s] = M*l*vturn
        centre_x [kg*m] = m*(x + l*sin(turn))
        centre_turn [kg*m] = M*l*turn
        vturn = momentum2/(M*l)
        turn -> (momentum2*t + centre_turn)/(M*l)
        x -> (p_x*t + centre_x)/m - l*sin((momentum2*t + centre_turn)/(M*l))
        energy known; divided by: nothing
    "]]
    .assert_eq(&show(&r));
}

/// The pendulum is singular at each half turn; from which the distance is taken the start decides.
#[test]
fn the_distance_is_from_the_singular_surface_next_to_the_start() {
    let text = include_str!("../../models/spherical_pendulum/model.toml");
    for (start, state) in
        [("0.3", "theta"), ("3", "theta_minus_180deg"), ("-6", "theta_plus_360deg"), ("2*pi + 3", "theta_minus_540deg")]
    {
        let source = tripos_derive::diagnostic::Source::from_text("model.toml", text);
        let mut model = tripos_derive::model::load(&source).unwrap();
        let scene =
            format!("span = [0, 1]\noutputs = [\"theta\"]\n[start]\ntheta = \"{start}\"\nphi = 0\nu1 = 0\nu2 = 1");
        let scene = reduced::scene_of(&mut model, &scene);
        let r = tripos_derive::reduce::reduce(&model, &scene).unwrap();
        assert_eq!(integrated(&r), (vec![state, "u1"], vec![]), "{start}");
    }
}
