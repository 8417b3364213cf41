//! Every wrong model gets one error, at the right line and column, with the culprit's name and a hint.

use crate::common;

use common::{BASE, errors, place};

/// An edit of the base: the text to be replaced (empty: the new text is added at the end), the new text, the text in it
/// at which the error must stand, and a part of the message.
type Wrong = (&'static str, &'static str, &'static str, &'static str);

const FORCE: &str = "[forces.f]\non = \"rod\"\nframe = \"N\"\nvector = ";

const WRONG: &[Wrong] = &[
    // Names and structure.
    ("from = \"N\", axis", "from = \"A\", axis", "A", "A -> A"),
    ("from = \"O\"", "from = \"C\"", "C", "P -> C -> P"),
    ("from = \"N\", axis", "from = \"M\", axis", "M", "no frame `M`"),
    ("from = \"P\"", "from = \"A\"", "A", "`A` is a frame, not a point"),
    ("centre = \"C\"", "centre = \"D\"", "D", "no point `D`"),
    ("I = {", "sin = { unit = \"m\" }\nI = {", "sin", "`sin` is reserved"),
    ("I = {", "\"I 1\" = { unit = \"m\" }\nI = {", "\"I 1\"", "cannot be a name"),
    ("I = {", "\"Δ\" = { unit = \"m\" }\nI = {", "\"Δ\"", "cannot be a name"),
    ("I = {", "_I = { unit = \"m\" }\nI = {", "_I", "cannot be a name"),
    ("A = {", "x = { from = \"N\", axis = 1, angle = 0 }\nA = {", "x", "declared twice"),
    ("u2 =", "x =", "x", "declared twice"),
    ("name = ", "nmae = 3\nname = ", "nmae", "unknown key `nmae`"),
    ("\"m\" }", "\"m\", masss = 1 }", "masss", "unknown key `masss`"),
    ("name = \"Pendulum on a cart\"", "name = 3", "3", "`name` must be a string"),
    ("axis = 3", "axis = 4", "4", "axis"),
    ("axis = 3", "axis = \"3\"", "\"3\"", "axis"),
    ("[0, \"-length\", 0]", "[0, \"-length\"]", "[", "2 components, not 3"),
    ("[0, \"-length\", 0]", "[0, 0, 0, 0]", "[", "4 components, not 3"),
    ("[0, \"-length\", 0]", "\"-length\"", "\"", "must be an array"),
    ("[0, \"-length\", 0]", "[0, [0], 0]", "[0]", "must be a number"),
    ("A = { from = \"N\", axis = 3, angle = \"q\" }", "A = 3", "3", "frame `A` must be a table"),
    ("[bodies.rod]", "[[bodies]]", "[[", "`bodies` must be a table"),
    ("frame = \"A\"\n", "", "rod", "body `rod` has no `frame`"),
    ("inertia = { diagonal = [\"I\", 0, \"I\"] }\n", "", "rod", "body `rod` has no `inertia`"),
    ("x = { unit = \"m\" }", "x = {}", "x", "`x` has no `unit`"),
    ("positive = true", "positive = \"yes\"", "\"yes\"", "true or false"),
    ("acceleration", "about = 3\nacceleration", "about", "unknown key `about`"),
    ("\"m\" }", "\"m\", about = 3 }", "3", "`about` must be a string"),
    // Values and units.
    ("value = 2", "value = true", "true", "must be a number"),
    ("value = 2", "value = nan", "nan", "nan"),
    ("value = 2", "value = inf", "inf", "inf"),
    ("value = 2", "value = -2", "-2", "the parameter `m` is declared positive"),
    ("value = 2", "value = 0", "0", "the parameter `m` is declared positive"),
    ("9.81", "1e400", "1e400", "double precision"),
    ("9.81", "\"10^400\"", "10^400", "double precision"),
    ("9.81", "\"1e-400\"", "1e-400", "double precision"),
    ("9.81", "\"9.81 m/parsec^2\"", "m/parsec", "operator is missing"),
    ("9.81", "\"9.81 m/s\"", "\"9.81 m/s\"", "is in m/s, not in m/s^2"),
    ("9.81", "\"length\"", "length", "cannot stand in a parameter's value"),
    ("unit = \"kg\"", "unit = \"g\"", "g", "`g` is not a unit"),
    ("unit = \"kg\"", "unit = \"kg^x\"", "kg^x", "`x` is not a whole exponent"),
    ("unit = \"rad\"", "unit = \"deg\"", "deg", "`deg` is not a unit"),
    ("\"-length\"", "\"-length*sin(x)\"", "-length", "sin(x)"),
    ("mass = \"m\"", "mass = \"I\"", "I", "mass of particle `cart` must be in kg"),
    ("mass = \"m\"", "mass = 2", "2", "must be in kg"),
    ("mass = \"m\"", "mass = \"m*cos(q)\"", "q", "the coordinate `q` cannot stand in the mass"),
    ("\"I\", 0, \"I\"]", "\"I*cos(q)\", 0, \"I\"]", "q", "cannot stand in the diagonal"),
    ("\"I\", 0, \"I\"]", "\"I\", 0, \"I\"], about_point = \"O\"", "\"O\"", "cannot be moved"),
    ("\"I\", 0, \"I\"]", "\"I\", 0, \"I\"], about_point = \"Z\"", "Z", "no point `Z`"),
    // Speeds.
    ("\"q'\"", "0", "0", "not independent"),
    ("\"q'\"", "\"u1\"", "u1", "the speed `u1` cannot stand in the definition of a speed"),
    ("\"q'\"", "\"q''\"", "q''", "more than one prime"),
    ("\"q'\"", "\"q'*x'\"", "q'*x'", "not linear"),
    ("\"q'\"", "\"1/q'\"", "1/q'", "not linear"),
    ("\"q'\"", "\"q' + x'\"", "q' + x'", "cannot be added"),
    ("\"q'\"", "\"q' + m'\"", "m'", "`m` is a parameter"),
    ("\"q'\"", "[1]", "[1]", "speed `u2`"),
    // Loads.
    ("frame = \"N\"\nacceleration", "frame = \"A\"\nacceleration", "\"A\"", "not in the inertial frame `N`"),
    ("\"-g\"", "\"-g*cos(q)\"", "q", "the coordinate `q` cannot stand in the acceleration"),
    ("", "zero_at = { qq = 0 }\n", "qq", "no coordinate `qq`"),
    ("", "[forces.f]\non = \"P\"\nframe = \"N\"\nvector = [0, 0, 0]\n", "P", "`P` is a point, not a body"),
    ("", "[forces.f]\nframe = \"N\"\nvector = [0, 0, 0]\n", "f]", "force `f` has no `on`"),
    (
        "",
        "[forces.f]\non = \"cart\"\nat = \"C\"\nframe = \"N\"\nvector = [0, 0, 0]\n",
        "\"C\"",
        "`cart` is not at this point",
    ),
    (
        "",
        "[forces.f]\non = \"rod\"\nagainst_at = \"P\"\nframe = \"N\"\nvector = [0, 0, 0]\n",
        "\"P\"",
        "without `against`",
    ),
    ("", "[torques.T]\non = \"moon\"\nframe = \"N\"\nvector = [0, 0, 0]\n", "moon", "no body `moon`"),
    (
        "",
        "[reactions.R]\non = \"rod\"\nkind = \"moment\"\nframe = \"N\"\ndirection = [0, 1, 0]\n",
        "moment",
        "`moment`",
    ),
    (
        "",
        "[reactions.R]\non = \"rod\"\nframe = \"N\"\ndirection = [0, 0, 0]\n",
        "[0,",
        "direction of reaction `R` is zero",
    ),
    (
        "",
        "[reactions.R]\non = \"rod\"\nkind = \"torque\"\nat = \"C\"\nframe = \"N\"\ndirection = [0, 1, 0]\n",
        "at",
        "unknown key `at`",
    ),
    ("", "[reactions.R]\non = \"rod\"\nframe = \"N\"\ndirection = [0, \"length\", 0]\n", "length", "must be in 1"),
    // Constraints and domain.
    ("", "[constraints]\nc = { equation = \"x\" }\n", "x\"", "exactly one `=`"),
    ("", "[constraints]\nc = { equation = \"x = = 0\" }\n", "x =", "exactly one `=`"),
    ("", "[constraints]\nc = { equation = \"x = q\" }\n", "x =", "in m"),
    ("", "[constraints]\nc = { equation = \"x'^2 = 0\" }\n", "x'^2", "`c` is not linear in velocities"),
    ("", "[constraints]\nc = { equation = \"abs(x') = 0\" }\n", "abs", "`c` is not linear in velocities"),
    ("", "[constraints]\nc = { equation = \"v(P) @ N [2] = 0\" }\n", "v(P)", "`c` is always fulfilled"),
    ("", "[constraints]\nc = { equation = \"v(P) @ N [1] = length\" }\n", "v(P)", "the right side in m"),
    ("", "[constraints]\nc = { equation = \"v(Z) @ N [1] = 0\" }\n", "Z", "no point `Z`"),
    ("", "[constraints]\nc = { equation = \"omega(cart) @ N [3] = 0\" }\n", "cart", "has no angular velocity"),
    ("", "[constraints]\nc = { equation = \"omega(A) @ N [4] = 0\" }\n", "4", "no component `4`"),
    ("", "[rolling.r]\nbody = \"cart\"\nat = \"P\"\n", "cart", "the particle `cart` cannot roll"),
    ("", "[rolling.r]\nbody = \"rod\"\nat = \"Z\"\n", "Z", "no point `Z`"),
    ("", "[rolling.r]\nbody = \"rod\"\nat = \"P\"\non = \"cart\"\n", "on =", "unknown key `on`"),
    ("", "[constraints]\nc = { equation = \"length = 2*length\" }\n", "length", "no coordinate"),
    ("", "[constraints]\nc = { equation = \"x = length\", enforced_by = \"Q\" }\n", "Q", "no reaction `Q`"),
    (
        "",
        "[constraints]\nc = { equation = \"x = length\" }\nd = { equation = \"x = 0\" }\n",
        "x = 0",
        "`d` contradicts",
    ),
    ("", "[constraints]\nc = { equation = \"x = 0\" }\nd = { equation = \"2*x = 0\" }\n", "2*x", "`d` follows"),
    ("", "[domain]\nd = \"q <= 1\"\n", "<=", "strict inequality"),
    ("", "[domain]\nd = \"q < length\"\n", "q <", "right side in m"),
    ("", "[domain]\nd = \"1 < 0\"\n", "1 <", "`d` is never fulfilled"),
    ("", "[domain]\nd = 3\n", "3", "must be a string"),
    // TOML.
    ("[gravity]", "[gravity", "\n", "unclosed table"),
    ("\"-length\"", "-length", "-length", "quoted"),
    ("\"-length\"", "\"-length\\q\"", "q", "escape"),
];

#[test]
fn one_error_at_the_right_place() {
    for (old, new, at, needle) in WRONG {
        let (text, start) = if old.is_empty() {
            (format!("{BASE}{new}"), BASE.len())
        } else {
            (BASE.replacen(old, new, 1), BASE.find(old).expect(old))
        };
        // With something removed the error stands at the owner's name.
        let start = if new.is_empty() { text.find("bodies.").expect("there") } else { start };
        let expected = start + text[start..].find(at).expect(at);
        let found = errors(&text);
        let all = found.to_string();
        // A constraint changes the number of speeds, which is an error of its own only if it is right.
        assert_eq!(found.list.len(), 1, "`{new}`: one error, not\n{all}");
        let error = &found.list[0];
        assert!(error.message.contains(needle), "`{new}`: `{needle}` is not in\n{all}");
        assert!(error.help.as_ref().is_some_and(|h| !h.is_empty()), "`{new}`: no help in\n{all}");
        let (line, column) = place(&text, expected);
        assert!(all.contains(&format!("model.toml:{line}:{column}\n")), "`{new}`: not at {line}:{column}\n{all}");
    }
}

#[test]
fn errors_in_a_formula_stand_at_their_column() {
    for (formula, at, needle) in [
        ("1/0", 2, "division by zero"),
        ("0/0", 2, "division by zero"),
        ("log(0)", 0, "log(0)"),
        ("sqrt(-1)", 0, "sqrt(-1)"),
        ("m*acos(2)", 2, "acos(2)"),
        ("sqrt(-pi)", 0, "sqrt(-pi)"),
        ("acos(1 + 10^-30)", 0, "is not a real number"),
        ("m*10^400", 0, "beyond double precision"),
        ("tan(pi/2)", 0, "tan"),
        ("2m", 1, "operator is missing"),
        ("m g", 2, "operator is missing"),
        ("m*sin q", 2, "`sin` needs"),
        ("m*q(t)", 2, "`q` is not a function"),
        ("m*q''", 2, "`q''`"),
        ("m*q.dot", 3, "`.`"),
        ("m**2", 2, "`*`"),
        ("m*(g", 2, "never closed"),
        ("m*g)", 3, "`)`"),
        ("m*", 2, "ends too early"),
        ("*m", 0, "`*`"),
        ("m,g", 1, "`,`"),
        ("m^q", 2, "exponent"),
        ("m·g", 1, "`·`"),
        ("m−g", 1, "`−`"),
        ("m*π", 2, "`π`"),
        ("m*g²", 3, "`²`"),
        ("m*θ", 2, "`θ`"),
        ("m*g*sin(t)", 0, "quantity in s"),
        ("m*g*sin(90*deg)", 11, "`deg`"),
        ("m*unknown", 2, "`unknown`"),
        ("2^(2^20)", 0, "too large"),
        ("", 0, "empty"),
    ] {
        let text = format!("{BASE}{FORCE}[0, \"{formula}\", 0]\n");
        let found = errors(&text);
        let all = found.to_string();
        assert_eq!(found.list.len(), 1, "`{formula}`: {all}");
        assert!(found.list[0].message.contains(needle), "`{formula}`: {all}");
        assert!(found.list[0].help.as_ref().is_some_and(|h| !h.is_empty()), "`{formula}`: {all}");
        assert!(all.contains(&format!("model.toml:43:{}\n", 15 + at)), "`{formula}`: {all}");
    }
}

#[test]
fn line_breaks_and_byte_order_marks_do_not_shift_the_place() {
    let wrong = BASE.replace("-length", "-legnth");
    for text in [wrong.replace('\n', "\r\n"), format!("\u{feff}{wrong}"), wrong.replace("Pendulum", "Pëndülüm 🎢")]
    {
        assert!(errors(&text).to_string().contains("model.toml:26:49\n"));
    }
    let first = format!("\u{feff}{}", BASE.replace("name =", "nmae ="));
    assert!(errors(&first).to_string().contains("model.toml:1:"));
    let escaped = errors(&BASE.replace("\"-length\"", "\"-\\u006begnth\"")).to_string();
    assert!(escaped.contains("model.toml:26:47\n") && escaped.contains("`kegnth`"), "the whole string:\n{escaped}");
    let block = errors(&BASE.replace("\"-length\"", "'''\n-legnth'''")).to_string();
    assert!(block.contains("model.toml:27:2\n"), "{block}");
}

#[test]
fn all_errors_of_a_file_come_at_once_in_order() {
    let text = common::edited(
        &[("axis = 3", "axis = 7"), ("value = 2", "value = inf"), ("\"q'\"", "\"q'^2\""), ("-g", "-gg")],
        "[moments]\n",
    );
    let found = errors(&text);
    let starts: Vec<usize> = found.list.iter().map(|d| d.span.as_ref().map_or(0, |s| s.start)).collect();
    assert_eq!(starts.len(), 5, "{found}");
    assert!(starts.is_sorted(), "{found}");
}

/// Goal: a file of a later format is refused for that alone, and one that states the present version is read. Method:
/// versions at the head of a model whose rest is right, and of one whose rest is unknown.
#[test]
fn the_version_of_the_format_is_looked_at_first() {
    common::read(&format!("schema = 1\n{BASE}")).unwrap();
    for (version, said) in [
        ("2", "the file is of version 2 of the format, and this program knows 1 to 1"),
        ("0", "`schema` must be a version of the format"),
        ("\"1\"", "`schema` must be a version of the format"),
    ] {
        for rest in [BASE, "[quaternions]\nq = 1\n"] {
            let found = errors(&format!("schema = {version}\n{rest}"));
            assert_eq!(found.list.len(), 1, "{found}");
            assert!(found.to_string().contains(said) && found.to_string().contains("model.toml:1:10"), "{found}");
        }
    }
}
