//! Every wrong scene gets one error, at the right line and column, with the culprit's name and a hint.

use crate::common;

use common::place;
use expect_test::{Expect, expect};
use tripos_derive::diagnostic::Source;
use tripos_derive::model::load;
use tripos_derive::scene::{self, FigureKind};

const MODEL: &str = include_str!("../../models/disk/model.toml");

const SCENE: &str = r#"span = [0, 2]
[start]
q1 = 0.2
q2 = 0.3
q3 = 0.1
q4 = 0
q5 = 0
u1 = -0.1
u2 = 0.7
u3 = 0.5
u4 = 0.2
u5 = -0.1
[ladder]
u2 = [1.6, 0.8]
[integration]
method = "dop853"
solve = "eliminated"
rtol = 3e-14
atol = { q1 = 1e-14 }
step = 0.01
distance = { q2 = "90*deg" }
[[figures]]
kind = "passages"
"#;

/// An edit of the scene: the text to be replaced, the new text, the text in it at which the error must stand, and a
/// part of the message.
type Wrong = (&'static str, &'static str, &'static str, &'static str);

const WRONG: &[Wrong] = &[
    // The ladder.
    ("u2 = [1.6, 0.8]", "u9 = [1.6, 0.8]", "u9", "no `u9`"),
    ("u2 = [1.6, 0.8]", "u2 = [1.6]\nu3 = [1]", "", "`ladder` varies 2 numbers, not one"),
    ("u2 = [1.6, 0.8]", "", "", "`ladder` varies 0 numbers, not one"),
    ("u2 = [1.6, 0.8]", "u2 = []", "[]", "the ladder has no values"),
    ("u2 = [1.6, 0.8]", "u2 = 1.6", "1.6", "must be a list"),
    ("u2 = [1.6, 0.8]", "u2 = [1.6, nan]", "nan", "`nan`"),
    ("u2 = [1.6, 0.8]", "u2 = [1.6, \"q1\"]", "q1", "`q1`"),
    ("u2 = [1.6, 0.8]", "\"q2'\" = [1.6]", "\"q2'\"", "no `q2'`"),
    // How it is integrated.
    ("\"dop853\"", "\"ode23\"", "ode23", "`ode23` is not a value of `method`"),
    ("\"eliminated\"", "\"magic\"", "magic", "`magic` is not a value of `solve`"),
    ("step = 0.01", "step = 0", "0", "`step` is zero"),
    ("step = 0.01", "step = -1", "-1", "`step` is negative"),
    ("step = 0.01", "max_step = 0", "0", "`max_step` is zero"),
    ("step = 0.01", "max_step = -1", "-1", "`max_step` is negative"),
    ("step = 0.01", "max_step = \"q1\"", "q1", "`q1`"),
    ("step = 0.01", "max_step = true", "true", "`max_step`"),
    ("step = 0.01", "step = 0.01\nmax_step = 0.1", "0.1", "leave `max_step` out"),
    (
        "\"dop853\"\nsolve = \"eliminated\"\nrtol = 3e-14\natol = { q1 = 1e-14 }\nstep = 0.01",
        "\"quadrature\"\nmax_step = 0.5",
        "0.5",
        "quadrature takes no steps: `max_step` means nothing",
    ),
    ("q1 = 1e-14", "q7 = 1e-14", "q7", "no coordinate or speed `q7`"),
    ("q1 = 1e-14", "q1 = -1", "-1", "`q1` is negative"),
    ("{ q1 = 1e-14 }", "[1e-14]", "[", "`atol`"),
    ("3e-14\natol = { q1 = 1e-14 }", "0\natol = 0.0", "0.0", "rtol and atol are both zero"),
    ("{ q2 = \"90*deg\" }", "{ q7 = \"90*deg\" }", "q7", "no coordinate `q7`"),
    ("{ q2 = \"90*deg\" }", "{ u2 = \"90*deg\" }", "u2", "no coordinate `u2`"),
    ("\"90*deg\"", "\"45*deg\"", "45*deg", "not a multiple of a right angle"),
    ("\"90*deg\"", "0", "0", "not a multiple of a right angle"),
    ("\"90*deg\"", "\"pi/2 + 1/100000000000\"", "pi/2", "not a multiple of a right angle"),
    ("{ q2 = \"90*deg\" }", "{ q1 = \"90*deg\", q2 = \"90*deg\" }", "{", "names 2 coordinates, not one"),
    ("{ q2 = \"90*deg\" }", "\"q2\"", "\"q2\"", "`distance`"),
    // Contacts.
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 1.5\n[[figures]]",
        "1.5",
        "the restitution of `rim` is 1.5, not from 0 to 1",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = -0.1\n[[figures]]",
        "-0.1",
        "the restitution of `rim` is -0.1",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = \"q1\"\n[[figures]]",
        "q1",
        "`q1` cannot stand in `restitution`",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\n\n[[figures]]",
        "rim",
        "the contact `rim` has no `restitution`",
    ),
    ("[[figures]]", "[impacts.rim]\nrestitution = 0.5\n[[figures]]", "rim", "the contact `rim` has no `gap`"),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"M*g\"\nrestitution = 0.5\n[[figures]]",
        "M*g",
        "no coordinate changes this gap",
    ),
    ("[[figures]]", "[impacts.rim]\ngap = \"q9\"\nrestitution = 0.5\n[[figures]]", "q9", "`q9` cannot stand in a gap"),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"q1 - u1\"\nrestitution = 0.5\n[[figures]]",
        "u1",
        "`u1` cannot stand in a gap",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"q1 - t\"\nrestitution = 0.5\n[[figures]]",
        "t\"",
        "`t` cannot stand in a gap",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(ZZ) @ A [3]\"\nrestitution = 0.5\n[[figures]]",
        "p(ZZ)",
        "the model has no point `ZZ`",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ ZZ [3]\"\nrestitution = 0.5\n[[figures]]",
        "p(P)",
        "the model has no frame `ZZ`",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"v(P) @ A [3]\"\nrestitution = 0.5\n[[figures]]",
        "v(P)",
        "the velocity `v(P) @ A [3]` cannot stand in a gap",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nlaw = \"hertz\"\n[[figures]]",
        "hertz",
        "`hertz` is not a value of `law`",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nmu = 0.3\n[[figures]]",
        "mu",
        "unknown key `mu`",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nno_slip = \"u1\"\n[[figures]]",
        "\"u1\"",
        "`no_slip` must be a list",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nno_slip = [\"q1\"]\n[[figures]]",
        "q1",
        "this formula must be a velocity",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nlaw = \"poisson\"\nno_slip = [\"u1\"]\n[[figures]]",
        "rim",
        "Poisson",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\n[impacts.edge]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nlaw = \"poisson\"\n[[figures]]",
        "edge",
        "another law",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nfriction = -0.1\nalong = \"u1\"\n[[figures]]",
        "-0.1",
        "the friction of `rim` is -0.1, below 0",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nfriction = 0.3\n[[figures]]",
        "0.3",
        "the friction of `rim` needs the velocity along which it acts",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nalong = \"u1\"\n[[figures]]",
        "\"u1\"",
        "`along` of the contact `rim` has no friction",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nfriction = 0.3\nalong = \"u1\"\nno_slip = [\"u1\"]\n[[figures]]",
        "0.3",
        "has friction of a coefficient, and does not slip",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nfriction = 0.3\nalong = \"q1\"\n[[figures]]",
        "q1",
        "this formula must be a velocity",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nfriction = 0.3\nalong = \"u1*u2\"\n[[figures]]",
        "u1*u2",
        "a velocity along a contact must be linear in speeds",
    ),
    (
        "[[figures]]",
        "[impacts.rim]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nfriction = \"cof\"\nalong = \"u1\"\n[[figures]]",
        "cof",
        "cof",
    ),
    (
        "[[figures]]",
        "[impacts.r0]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nfriction = 0.3\nalong = \"u1\"\n[impacts.r1]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nfriction = 0.3\nalong = \"u1\"\n[impacts.r2]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nfriction = 0.3\nalong = \"u1\"\n[impacts.r3]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nfriction = 0.3\nalong = \"u1\"\n[impacts.r4]\ngap = \"p(P) @ A [1]\"\nrestitution = 0.5\nfriction = 0.3\nalong = \"u1\"\n[[figures]]",
        "r4",
        "more than 4 contacts have friction",
    ),
    ("[[figures]]", "[impacts]\nrim = 3\n[[figures]]", "3", "the contact `rim` must be a table"),
    // Figures.
    ("\"passages\"", "\"passage\"", "passage", "`passage` is not a value of `kind`"),
    ("kind = \"passages\"", "caption = \"x\"", "", "a figure has no `kind`"),
];

#[test]
fn one_error_at_the_right_place() {
    for (old, new, at, needle) in WRONG {
        let text = SCENE.replacen(old, new, 1);
        let mut model = load(&Source::from_text("model.toml", MODEL)).unwrap_or_else(|e| panic!("{e}"));
        let Err(found) = scene::load(&Source::from_text("scene.toml", &text), &mut model) else {
            panic!("`{new}` is taken");
        };
        let all = found.to_string();
        assert_eq!(found.list.len(), 1, "`{new}`: one error, not\n{all}");
        let error = &found.list[0];
        assert!(error.message.contains(needle), "`{new}`: `{needle}` is not in\n{all}");
        assert!(error.help.as_ref().is_some_and(|h| !h.is_empty()), "`{new}`: no help in\n{all}");
        // Where no word is to blame the table is.
        let start = SCENE.find(old).unwrap_or_else(|| panic!("{old}"));
        let expected =
            if at.is_empty() { text[..start].rfind('[').unwrap() } else { start + text[start..].find(at).unwrap() };
        let (line, column) = place(&text, expected);
        let near = if at.is_empty() { format!("scene.toml:{line}:") } else { format!("scene.toml:{line}:{column}\n") };
        assert!(all.contains(&near), "`{new}`: not at {line}:{column}\n{all}");
    }
}

/// Goal: the scene that is spoilt above is right, and figures of every kind are read.
#[test]
fn every_kind_of_figure_is_read() {
    let kinds = FigureKind::ALL.map(|kind| format!("[[figures]]\nkind = \"{}\"\n", kind.name()));
    let text = SCENE.replace("[[figures]]\nkind = \"passages\"\n", &kinds.concat());
    let mut model = load(&Source::from_text("model.toml", MODEL)).unwrap();
    let scene = scene::load(&Source::from_text("scene.toml", &text), &mut model).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(scene.figures.iter().map(|f| f.kind).collect::<Vec<_>>(), FigureKind::ALL);
    assert_eq!(scene.ladder_scenes().len(), 2);
}

/// Checks the message for a wrong `outputs` line.
#[allow(clippy::needless_pass_by_value, reason = "as expect! is used everywhere")]
fn check_outputs(line: &str, expected: Expect) {
    let text = format!("{line}\n{SCENE}");
    let mut model = load(&Source::from_text("model.toml", MODEL)).unwrap_or_else(|e| panic!("{e}"));
    let found = scene::load(&Source::from_text("scene.toml", &text), &mut model).err();
    expected.assert_eq(&found.map_or("taken".to_owned(), |e| e.to_string()));
}

#[test]
fn an_output_that_the_model_does_not_know() {
    check_outputs(
        "outputs = [\"q2\", \"q7\"]",
        expect![[r#"
        error: unknown name `q7`
         --> scene.toml:1:19
          |
        1 | outputs = ["q2", "q7"]
          |                   ^^
          |
          = help: did you mean `q1`?"#]],
    );
}

#[test]
fn empty_outputs() {
    check_outputs(
        "outputs = []",
        expect![[r"
        error: `outputs` is empty
         --> scene.toml:1:11
          |
        1 | outputs = []
          |           ^^
          |
          = help: name what the scene shall show, or leave `outputs` out to see every coordinate and speed"]],
    );
}

#[test]
fn an_impact_is_not_in_the_equations() {
    check_outputs(
        "outputs = [\"impact\"]",
        expect![[r#"
        error: no output `impact` can be had
         --> scene.toml:1:13
          |
        1 | outputs = ["impact"]
          |             ^^^^^^
          |
          = help: an impact cannot be an output: state the contact under [impacts], and the run lists all impacts with impulses and losses"#]],
    );
}

#[test]
fn a_bounce_is_not_in_the_equations() {
    check_outputs(
        "outputs = [{ name = \"after\", value = \"bounce\" }]",
        expect![[r#"
        error: no output `bounce` can be had
         --> scene.toml:1:39
          |
        1 | outputs = [{ name = "after", value = "bounce" }]
          |                                       ^^^^^^
          |
          = help: an impact cannot be an output: state the contact under [impacts], and the run lists all impacts with impulses and losses"#]],
    );
}

#[test]
fn slip_is_not_in_the_equations() {
    check_outputs(
        "outputs = [\"Slip\"]",
        expect![[r#"
        error: no output `Slip` can be had
         --> scene.toml:1:13
          |
        1 | outputs = ["Slip"]
          |             ^^^^
          |
          = help: a change between sticking and slipping is not in the equations: they hold for one kind of contact. Model the friction as an applied force"#]],
    );
}

#[test]
fn the_same_output_twice() {
    check_outputs(
        "outputs = [\"q2\", \"q2\"]",
        expect![[r#"
        error: the output `q2` is listed twice
         --> scene.toml:1:19
          |
        1 | outputs = ["q2", "q2"]
          |                   ^^
          |
          = help: leave one of them out"#]],
    );
}

#[test]
fn a_free_parameter_that_the_model_does_not_have() {
    check_outputs(
        "outputs = [\"q2\"]\nfree = [\"m\"]",
        expect![[r#"
        error: the model has no parameter `m`
         --> scene.toml:2:10
          |
        2 | free = ["m"]
          |          ^
          |
          = help: did you mean `M`?"#]],
    );
}

/// Goal: a user who takes a speed of a free body for the rate of an angle learns the right speeds. Method: a start
/// value for `u_psi`, a name made from that of the angle `psi`.
#[test]
fn a_speed_called_after_an_angle_of_a_free_body() {
    let model = "name = \"Brick\"\n[parameters]\nm = { unit = \"kg\", value = 1 }\nJ = { unit = \"kg*m^2\", value = 0.1 }\n[joints]\n\
                 fly = { kind = \"free\", body = \"brick\", sequence = \"321\", coordinates = [\"x\", \"y\", \"z\", \"psi\", \"theta\", \"phi\"] }\n\
                 [inertial]\nframe = \"N\"\norigin = \"O\"\n[bodies.brick]\nmass = \"m\"\ninertia = { diagonal = [\"J\", \"J\", \"J\"] }\n";
    let mut model = load(&Source::from_text("model.toml", model)).unwrap();
    let start = "x = 0\ny = 0\nz = 0\npsi = 0\ntheta = 0\nphi = 0\nu_psi = 1\n";
    let text = format!("span = [0, 1]\n[start]\n{start}");
    let said = scene::load(&Source::from_text("scene.toml", &text), &mut model).err().unwrap().to_string();
    let help =
        "help: the rate of `psi` is `psi'`, and the speeds are `u_x`, `u_y`, `u_z`, `u_fly_4`, `u_fly_5`, `u_fly_6`";
    assert!(said.contains("no coordinate or speed `u_psi`") && said.contains(help), "{said}");
}
