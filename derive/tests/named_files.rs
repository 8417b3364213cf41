//! Publications that name files of authors: LaTeX with labels and macros, and programs with their assignments.
//!
//! The equations of the cart with a rod are written by hand. They are right where a test says `equal`, and have one
//! slip where it says `different`.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::printed_forms::CART;
use expect_test::{Expect, expect};
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::diff::judge_publication;
use tripos_derive::mechanics::derive_all;
use tripos_derive::model::load;
use tripos_derive::prove::prove;
use tripos_derive::publication::{self, Publication};

const PAPER: &str = r"\documentclass{article}
\newcommand{\dd}[2][]{\frac{d^{#1} #2}{dt^{#1}}}
\newcommand\half{\tfrac12}
\renewcommand{\th}{\theta} % the angle
\def\Jp{(J + m l^2)}
\newcommand{\be}{\begin{equation}} \newcommand{\ee}{\end{equation}}
\DeclareMathOperator{\sn}{sin}
\begin{document}
We derive, for $100\%$ rigid rods,
% \begin{equation} T = 1 \label{eq:T} \end{equation}
\be
  T = \half (M + m) \dot x^2 + m l \dot x \dot\th \cos\th
    + \half \Jp \dot\th^2 . \label{eq:T}
\ee
\begin{align}
  (M + m)\dd[2]{x} + m l\ddot\th \cos\th & \nonumber \\
    \quad {} - m l \dot\th^2 \sn\th &= F, \label{eq:cart} \\[2pt]
  \Jp \ddot\th + m l \cos\th (\ddot x) + m g l \sin\th &= 0. \tag{2.3}
\end{align}
\begin{equation} \label{eq:both}
  \left\{ \begin{aligned}
    (M + m)\ddot x + m l\ddot\th\cos\th - m l \dot\th^2\sin\th &= F \\
    \Jp\ddot\th + m l\cos\th\,\ddot x &= m g l\sin\th
  \end{aligned} \right.
\end{equation}
\[ M = \begin{bmatrix} M + m & m l \cos\th \\ m l\cos\th & \Jp \end{bmatrix} \label{eq:M} \]
\begin{equation} V = - m g l \bad{\th} \label{eq:V} \end{equation}
\begin{equation} \label{eq:short}
  J_0 = J + m l^2, \qquad h(\th) = m l \cos\th, \quad d = J_0 (M + m) - h^2 = 1
\end{equation}
\begin{equation}
  T = \half (M + m) \dot x^2 + h \dot x \dot\th + \half J_0 \dot\th^2 = \half M \dot x^2, \quad h = m l \cos\th
  \label{eq:chain}
\end{equation}
\begin{align} (M + m)\ddot x + h \ddot\th = m l \dot\th^2\sn\th + F, & \quad J_0 \ddot\th + h \ddot x = m g l\sn\th
  \label{eq:side} \end{align}
\newcommand{\loopy}{\loopy x}
\begin{equation} L = \loopy \label{eq:L} \end{equation}
\end{document}
";

const PYTHON: &str = r#"import numpy as np

def rhs(state, force, p):
    """x = 1"""
    M, m, l, J, g = p
    x, theta, v, omega = state
    F = force  # the push
    s, c = np.sin(theta), np.cos(theta)
    mass = np.array([[M + m, m*l*c],
                     [m*l*c, J + m*l**2]])
    if x > 0:
        c = 0
    det = mass[0, 0]*mass[1, 1] - mass[0, 1]**2
    right = F + m*l*omega**2*s
    turn = -m*g*l*s
    a = (mass[1, 1]*right - mass[0, 1]*turn)/det
    alpha = (mass[0, 0]*turn
             - mass[0, 1]*right)/det
    return np.array([v, omega, a, alpha])

def energy(v, omega):
    T = (M + m)*v**2/2
    T += m*l*v*omega*np.cos(theta)
    T += (J + m*l**2)*omega**2/2
    w = np.linalg.norm(v)
    if w > 1:
        U = 1
    return T
"#;

const MATLAB: &str = "function dz = cart(t, z, p)\n M = p.M; m = p.m; l = p.l; J = p.J; g = 9.81;\n\
    x = z(1); theta = z(2); % z is the state\n v = z(3); omega = z(4);\n F = p.F;\n c = cos(theta); s = sin(theta);\n\
    A = [M + m, m*l*c\n m*l*c, J + m*l^2];\n b = [F + m*l*omega^2*s; -m*g*l*s];\n\
    dz = zeros(4, 1);\n dz(1) = v; dz(2) = omega;\n\
    dz(3) = (A(2,2)*b(1) - A(1,2)*b(2))/ ...\n (A(1,1)*A(2,2) - A(1,2)^2);\n\
    dz(4) = (A(1,1)*b(2) + A(1,2)*b(1))/(A(1,1)*A(2,2) - A(1,2)^2);\nend\n";

/// Programs that solve the linear system of the accelerations, in the ways that people write this.
const SOLVED_MATLAB: &str = "function dz = solved(t, z, p)\n x = z(1); theta = z(2);\n omega = z(4); l = p.l;\n\
    Mm = [p.M + p.m, p.m*l*cos(theta); p.m*l*cos(theta), p.J + p.m*l^2];\n\
    f = [p.F + p.m*l*omega^2*sin(theta); -p.m*p.g*l*sin(theta)];\n\
    dz = zeros(4,1);\n dz(1:2) = z(3:4);\n dz(3:4) = Mm\\f;\nend\n\
    function dz = inverse(t, z, p)\n theta = z(2);\n omega = z(4); l = p.l;\n\
    a = inv([p.M + p.m, p.m*l*sin(theta); p.m*l*cos(theta), p.J + p.m*l^2])*[p.F + p.m*l*omega^2*sin(theta); -p.m*p.g*l*sin(theta)];\n\
    dz = [z(3); z(4); a(1); a(2)];\nend\n";

const SOLVED_PYTHON: &str = "import numpy as np\ndef solved(t, z, p):\n    x, theta, v, omega = z\n\
    \x20   A = np.array([[M + m, m*l*np.cos(theta)], [m*l*np.cos(theta), J + m*l**2]])\n\
    \x20   b = np.array([F + m*l*omega**2*np.sin(theta), m*g*l*np.sin(theta)])\n\
    \x20   a = np.linalg.solve(A, b)\n    return [v, omega, a[0], a[1]]\n";

const C: &str = "/* rates */\nvoid rates(const double *z, const params *p, double *dz) {\n\
    const double c = cos(z[1]), s = sin(z[1]);\n double row = (p->M + p->m)*x_ddot\n + p->m*p->l*(c*thetaddot - s*dtheta*theta_dot);\n\
    dz[0] = row; // x\n}\n";

fn read(name: &str) -> Result<Source, Diagnostics> {
    let text = match name {
        "paper.tex" => PAPER,
        "cart.py" => PYTHON,
        "cart.m" => MATLAB,
        "cart.c" => C,
        "solved.m" => SOLVED_MATLAB,
        "solved.py" => SOLVED_PYTHON,
        _ => return Source::read(std::path::Path::new("/no/such/folder").join(name).as_path()),
    };
    Ok(Source::from_text(name, text))
}

fn loaded(text: &str) -> Result<(tripos_derive::Model, Publication), Diagnostics> {
    let mut model = load(&Source::from_text("model.toml", CART)).unwrap_or_else(|e| panic!("{e}"));
    let source = Source::from_text("publication.toml", text);
    let publication = publication::load_publication_with_files(&source, &mut model, &read)?;
    Ok((model, publication))
}

/// Goal: formulas of files are judged as if they were copied. Method: a line for each verdict.
fn check(text: &str, expected: &Expect) {
    let (model, publication) = loaded(text).unwrap_or_else(|e| panic!("{e}"));
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    let difference = judge_publication(&model, &mut derivations, &publication, &proof);
    let line = |f: &tripos_derive::diff::Finding| {
        let mistake = f.wrong.as_ref().map_or(String::new(), |wrong| format!(": {wrong}"));
        format!("{} {}{mistake}", f.id, f.judgement.word())
    };
    expected.assert_eq(&difference.findings.iter().map(line).collect::<Vec<_>>().join("\n"));
}

fn check_error(text: &str, expected: &Expect) {
    expected.assert_eq(&loaded(text).map(|_| ()).unwrap_err().to_string());
}

fn equation(id: &str, rest: &str) -> String {
    format!("[[equation]]\nid = \"{id}\"\nsection = \"1\"\n{rest}\n")
}

/// Goal: definitions, chains and equations side by side are judged as the paper prints them.
#[test]
fn definitions_and_chains_of_a_paper_are_read_by_their_labels() {
    let text = [
        "file = \"paper.tex\"\nnotation = \"latex\"\n".to_owned(),
        "[abbreviations]\nJ_0 = { label = \"eq:short\" }\nh = { label = \"eq:chain\" }\n".to_owned(),
        equation("T", "quantity = \"T\"\nlabel = \"eq:chain\""),
        "[[system]]\nid = \"two\"\nsection = \"1\"\nformulation = \"lagrange\"\nlabel = \"eq:side\"\n".to_owned(),
        equation("second", "label = \"eq:side\"\nline = 2"),
    ];
    check(
        &text.concat(),
        &expect![[r#"
        T-1 equal
        T-2 different
        two-row1 equal
        two-row2 different: in the right-hand side, m*l*g*sin(theta) should be -m*l*g*sin(theta)
        second different: in the right-hand side, m*l*g*sin(theta) should be -m*l*g*sin(theta)"#]],
    );
    let one = |line: &str| {
        format!("file = \"paper.tex\"\n[abbreviations]\n{line}\n{}", equation("V", "quantity = \"V\"\nprinted = \"0\""))
    };
    let texts = [
        "d = { label = \"eq:short\" }",
        "k = { label = \"eq:chain\" }",
        "h = { lable = \"eq:chain\" }",
        "h = { label = \"eq:chains\" }",
    ];
    let errors: Vec<String> =
        texts.into_iter().map(|line| loaded(&one(line)).map(|_| ()).unwrap_err().to_string()).collect();
    expect![[r#"
        error: `d` is equal to more than one formula
          --> paper.tex:29:55
           |
        29 |   J_0 = J + m l^2, \qquad h(\th) = m l \cos\th, \quad d = J_0 (M + m) - h^2 = 1
           |                                                       ^^^^^^^^^^^^^^^^^^^^^^^^^
           |
           = help: copy the formula that is meant
        error: no equation of `eq:chain` has `k` alone on its left side
         --> publication.toml:3:16
          |
        3 | k = { label = "eq:chain" }
          |                ^^^^^^^^
          |
          = help: say in [symbols] which symbol stands for the abbreviation, or copy its formula
        error: an abbreviation has no `label`
         --> publication.toml:3:5
          |
        3 | h = { lable = "eq:chain" }
          |     ^^^^^^^^^^^^^^^^^^^^^^
          |
          = help: add `label = …`

        error: unknown key `lable` in an abbreviation
         --> publication.toml:3:7
          |
        3 | h = { lable = "eq:chain" }
          |       ^^^^^
          |
          = help: did you mean `label`?
        error: no equation of `paper.tex` has the label `eq:chains`
         --> publication.toml:3:16
          |
        3 | h = { label = "eq:chains" }
          |                ^^^^^^^^^
          |
          = help: did you mean `eq:chain`?"#]]
    .assert_eq(&errors.join("\n"));
}

#[test]
fn equations_of_a_paper_are_found_by_their_labels() {
    let text = [
        "file = \"paper.tex\"\nnotation = \"latex\"\n".to_owned(),
        equation("T", "quantity = \"T\"\nlabel = \"eq:T\""),
        equation("cart", "label = \"eq:cart\""),
        equation("rod", "label = \"2.3\""),
        equation("second", "label = \"eq:both\"\nline = 2"),
        equation("copied", r"printed = '\Jp \ddot\th + m l \cos\th \ddot x + m g l \sn\th = 0'"),
        "[[matrix]]\nid = \"M\"\nsection = \"1\"\nquantity = \"M\"\nlabel = \"eq:M\"\n".to_owned(),
        "[[system]]\nid = \"both\"\nsection = \"1\"\nformulation = \"lagrange\"\nunknowns = [\"theta''\", \"x''\"]\n\
         label = \"eq:both\"\n"
            .to_owned(),
        "[[system]]\nid = \"two\"\nsection = \"1\"\nformulation = \"lagrange\"\nlabels = [\"2.3\", \"eq:cart\"]\n"
            .to_owned(),
    ];
    check(
        &text.concat(),
        &expect![[r"
        T equal
        cart equal
        rod equal
        second different: in the right-hand side, m*l*g*sin(theta) should be -m*l*g*sin(theta)
        copied equal
        M-11 equal
        M-12 equal
        M-21 equal
        M-22 equal
        both-row1 equal
        both-row2 different: in the right-hand side, m*l*g*sin(theta) should be -m*l*g*sin(theta)
        two-row1 equal
        two-row2 equal"]],
    );
}

#[test]
fn assignments_of_a_program_are_its_abbreviations() {
    let listing = |id: &str, file: &str, state: &str, derivative: &str| {
        format!(
            "[[listing]]\nid = \"{id}\"\nsection = \"1\"\nfile = \"{file}\"\npart = \"{id}\"\nformulation = \"kane\"\n\
             state = [{state}]\nderivative = [{derivative}]\n"
        )
    };
    let state = "\"x\", \"theta\", \"v\", \"omega\"";
    let text = [
        "[symbols]\n\"p.M\" = \"M\"\n\"p.m\" = \"m\"\n\"p.l\" = \"l\"\n\"z[1]\" = \"theta\"\n".to_owned(),
        equation("energy", "file = \"cart.py\"\npart = \"energy\"\nquantity = \"T\"\nprinted = \"return\""),
        equation(
            "lines",
            "file = \"cart.py\"\npart = \"22-22\"\nquantity = \"T\"\nprinted = \"T + m*l*v*omega*cos(theta) + (J + m*l**2)*omega**2/2\"",
        ),
        equation("c", "file = \"cart.c\"\npart = \"rates\"\nquantity = \"0\"\nprinted = \"dz[0] - F\""),
        listing("cart", "cart.m", state, "\"dz(1)\", \"dz(2)\", \"dz(3)\", \"dz(4)\""),
    ];
    check(
        &text.concat(),
        &expect![[r"
        energy equal
        lines equal
        c equal
        cart-dz1 equal
        cart-dz2 equal
        cart-dz3 equal
        cart-dz4 different: -m*l*cos(theta)*(m*l*omega^2*sin(theta) + F) should be m*l*cos(theta)*(m*l*omega^2*sin(theta) + F)"]],
    );
}

#[test]
fn what_a_condition_decides_is_not_taken() {
    check_error(
        &equation("1", "file = \"cart.py\"\npart = \"rhs\"\nquantity = \"T\"\nprinted = \"c + return[0]\""),
        &expect![[r"
            error: the assignment of `c` was not read: a condition or a loop decides about it
              --> cart.py:12:9
               |
            12 |         c = 0
               |         ^^^^^
               |
               = help: name the part of the program that decides"]],
    );
    check_error(
        &equation("1", "file = \"cart.py\"\npart = \"energy\"\nquantity = \"T\"\nprinted = \"w\""),
        &expect![[r#"
            error: the assignment of `w` was not read: unknown name `linalg.norm`
              --> cart.py:25:9
               |
            25 |     w = np.linalg.norm(v)
               |         ^^^^^^^^^^^^^^
               |
               = help: give the meaning of the symbol in [symbols], as in "linalg.norm" = "u1""#]],
    );
}

#[test]
fn errors_of_a_paper_are_shown_in_the_paper() {
    let text = [
        "file = \"paper.tex\"\n".to_owned(),
        equation("V", "notation = \"latex\"\nquantity = \"V\"\nlabel = \"eq:V\""),
        equation("L", "notation = \"latex\"\nquantity = \"L\"\nlabel = \"eq:L\""),
        equation("none", "notation = \"latex\"\nlabel = \"eq:cat\""),
        equation("two", "notation = \"latex\"\nlabel = \"eq:both\""),
    ];
    check_error(
        &text.concat(),
        &expect![[r#"
            error: no equation of `paper.tex` has the label `eq:cat`
              --> publication.toml:18:10
               |
            18 | label = "eq:cat"
               |          ^^^^^^
               |
               = help: did you mean `eq:cart`?

            error: the label `eq:both` has 2 equations
              --> publication.toml:23:10
               |
            23 | label = "eq:both"
               |          ^^^^^^^
               |
               = help: choose one: line = 1 to line = 2

            error: `\bad` is not known
              --> paper.tex:27:30
               |
            27 | \begin{equation} V = - m g l \bad{\th} \label{eq:V} \end{equation}
               |                              ^^^^
               |
               = help: known are symbols, \frac, \sqrt, \cdot, \left( \right), \dot and functions such as \sin; a symbol of the paper's own is declared in [symbols]

            error: the macros make this text too long: `\loopy` may call itself
              --> paper.tex:38:22
               |
            38 | \begin{equation} L = \loopy \label{eq:L} \end{equation}
               |                      ^^^^^^
               |
               = help: write the formula without this macro"#]],
    );
}

#[test]
fn only_files_beside_the_publication_are_read() {
    for name in ["../paper.tex", "/etc/passwd", "a/b.tex", ".hidden.tex", "paper.doc", "C:\\\\x.tex", "", "none.tex"] {
        let text = equation("1", &format!("file = \"{name}\"\nlabel = \"x\"\nnotation = \"latex\""));
        let errors = loaded(&text).map(|_| ()).unwrap_err();
        assert!(errors.list[0].span.is_some(), "{errors}");
    }
    let text = equation("1", "file = \"paper.tex\"\npart = \"f\"\nlabel = \"eq:T\"\nquantity = \"T\"");
    assert!(loaded(&text).is_err());
}

/// Goal: a program that solves the linear system is judged by its matrix and its right side, entry by entry. Method:
/// one right program, one with a wrong entry of the matrix, and one with a wrong sign on the right.
#[test]
fn solved_linear_systems_of_programs_are_judged_by_their_entries() {
    let listing = |id: &str, file: &str, derivative: &str| {
        format!(
            "[[listing]]\nid = \"{file}-{id}\"\nsection = \"1\"\nfile = \"{file}\"\npart = \"{id}\"\n\
             formulation = \"lagrange\"\nstate = [\"x\", \"theta\", \"x'\", \"theta'\"]\nderivative = [{derivative}]\n"
        )
    };
    let own = "\"p.M\" = \"M\"\n\"p.m\" = \"m\"\n\"p.l\" = \"l\"\n\"p.J\" = \"J\"\n\"p.g\" = \"g\"\n\"p.F\" = \"F\"\n";
    let names = "\"z(1)\" = \"x\"\n\"z(2)\" = \"theta\"\n\"z(3)\" = \"x'\"\n\"z(4)\" = \"theta'\"\n\
                 v = \"x'\"\nomega = \"theta'\"\n";
    let dz = "\"dz(1)\", \"dz(2)\", \"dz(3)\", \"dz(4)\"";
    let text = [
        format!("[symbols]\n{own}{names}"),
        listing("solved", "solved.m", dz),
        listing("inverse", "solved.m", dz),
        listing("solved", "solved.py", "\"return[0]\", \"return[1]\", \"return[2]\", \"return[3]\""),
    ];
    check(
        &text.concat(),
        &expect![[r#"
        solved.m-solved-dz1 equal
        solved.m-solved-dz2 equal
        solved.m-solved-E11 equal
        solved.m-solved-E12 equal
        solved.m-solved-dz3 equal
        solved.m-solved-E21 equal
        solved.m-solved-E22 equal
        solved.m-solved-dz4 equal
        solved.m-inverse-dz1 equal
        solved.m-inverse-dz2 equal
        solved.m-inverse-E11 equal
        solved.m-inverse-E12 different: m*l*sin(theta) should be m*l*cos(theta)
        solved.m-inverse-dz3 equal
        solved.m-inverse-E21 equal
        solved.m-inverse-E22 equal
        solved.m-inverse-dz4 equal
        solved.py-solved-dz1 equal
        solved.py-solved-dz2 equal
        solved.py-solved-E11 equal
        solved.py-solved-E12 equal
        solved.py-solved-dz3 equal
        solved.py-solved-E21 equal
        solved.py-solved-E22 equal
        solved.py-solved-dz4 different: m*l*g*sin(theta) should be -m*l*g*sin(theta)"#]],
    );
}
