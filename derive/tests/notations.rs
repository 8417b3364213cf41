//! Formulas as people have them: LaTeX, Python, MATLAB and C, against the language of model files.

use crate::publications;

use publications::{base, edited, load_text};
use std::path::Path;
use tripos_derive::algebra::text::notation::{LatexSymbol, Notation, SymbolNames, Unknown, translate};
use tripos_derive::algebra::text::parse::{ParseError, parse_primed};
use tripos_derive::algebra::text::print::{latex, print_text};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::{Finding, judge_publication};
use tripos_derive::mechanics::derive_all;
use tripos_derive::prove::prove;
use tripos_derive::{Model, publication};

/// Every symbol has a name: its letters, its subscript, and primes for its dots. `I^B` and `F^*` are symbols.
struct Anything;

impl SymbolNames for Anything {
    fn knows(&self, symbol: &LatexSymbol) -> bool {
        ["", "B", "*"].contains(&symbol.mark.as_str()) && symbol.base != "\\pi"
    }

    fn name_of_latex_symbol(&mut self, symbol: &LatexSymbol, _: &str) -> Result<String, Unknown> {
        let letters = |text: &str| text.chars().filter(char::is_ascii_alphanumeric).collect::<String>();
        let mark = if symbol.mark.is_empty() { "" } else { "_on" };
        Ok(format!("{}{}{mark}{}", letters(&symbol.base), letters(&symbol.subscript), "'".repeat(symbol.dots)))
    }

    fn name_of_variable(&mut self, name: &str) -> Result<String, Unknown> {
        let inside: String = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
        Ok(inside.trim_end_matches('_').to_owned())
    }
}

/// Reads a formula in which every name is a symbol.
fn read(arena: &mut Arena, formula: &str, notation: Notation) -> Result<Expr, ParseError> {
    let plain = translate(formula, notation, &mut Anything)?;
    let read = parse_primed(arena, plain.text(), 2, &mut |arena, name| Ok(arena.symbol(name)));
    read.map_err(|error| ParseError { span: plain.source_range(error.span), ..error })
}

/// Each formula is the plain one beside it, as a term.
fn check(notation: Notation, pairs: &[(&str, &str)]) {
    for (written, plain) in pairs {
        let mut arena = Arena::new();
        let expected = read(&mut arena, plain, Notation::Tripos).unwrap();
        let found = read(&mut arena, written, notation).unwrap_or_else(|e| panic!("{written}: {e:?}"));
        assert_eq!(found, expected, "{written} is {}, not {plain}", print_text(&arena, found));
    }
}

/// Each formula is refused at a part of it, with words of the message and of the help.
fn refuse(notation: Notation, cases: &[(&str, &str, &str, &str)]) {
    for (written, part, message, help) in cases {
        let error = read(&mut Arena::new(), written, notation).expect_err(written);
        assert_eq!(&written[error.span.clone()], *part, "{written}: {error:?}");
        assert!(error.message.contains(message), "{written}: {error:?}");
        assert!(error.help.as_deref().unwrap_or_default().contains(help), "{written}: {error:?}");
    }
}

#[test]
fn latex_is_read_as_it_is_printed() {
    check(
        Notation::Latex,
        &[
            (r"\dot{q}_1 + \dot q_1 + \dot{q_1} + \dot{q}_{1} + {\dot q}_1 + q_1'", "6*q1'"),
            (r"\ddot{\theta} - \theta'' + \theta^{\prime\prime} - \dot{\dot \theta}", "0"),
            (r"\frac{M R^2}{4}\left(\dot u_1 - 2u_2 u_3\right)", "M*R^2/4*(u1' - 2*u2*u3)"),
            (r"\tfrac12 m v^2 + \frac 1 2 m v^2 - \frac{1}{2}m v^{2}", "m*v^2/2"),
            (r"\sin^2 q_2 + \sin^{2}(q_2) + \sin^2\left(q_2\right)", "3*sin(q2)^2"),
            (r"\cos q_1 \sin q_2 \tan\theta", "cos(q1)*sin(q2)*tan(theta)"),
            (
                r"\sin 2 q_1 + \cos\frac{q_1}{2} + \sin{2\pi f} + \tan(q_1)^2",
                "sin(2*q1) + cos(q1/2) + sin(2*pi*f) + tan(q1)^2",
            ),
            (r"u_1 \, \cos q_2 \, \left(a + b\right)", "u1*cos(q2)*(a + b)"),
            (r"\sqrt{x^2 + y^2} + \sqrt 2 + \left|x - y\right| - |x - y|", "sqrt(x^2 + y^2) + sqrt(2)"),
            (
                r"\operatorname{sgn}(v) + \operatorname{sign} v + \arcsin x + \ln x + \exp(-x)",
                "2*sign(v) + asin(x) + log(x) + exp(-x)",
            ),
            (r"\max(a, b) + \operatorname{atan2}(y, x)", "max(a, b) + atan2(y, x)"),
            (r"x^{-1} y^{1/2} z^{\frac{3}{2}} + a_1^2", "x^-1*y^(1/2)*z^(3/2) + a1^2"),
            (r"I_{xx} + I_{\mathrm{xx}} + I_{x x}", "3*Ixx"),
            (r"I^B_{11} + I_{11}^{B} + F^*_1 F_1^*", "2*I11_on + F1_on^2"),
            (r"(a + b)(a - b) + [a + b]\{a - b\}", "2*(a + b)*(a - b)"),
            (r"a \cdot b \times c / d", "a*b*c/d"),
            ("$\\displaystyle a \\quad &+ \\; b$ % and so on", "a + b"),
            (r"a \\ &\qquad {} - b", "a - b"),
            (r"-\left(-a\right) − b.", "a - b"),
            (r"mgR\,\bar{x} - 1.5 \times 10^{-3}", "m*g*R*barx - 15/10000"),
            (r"\mathrm{den}^2", "den^2"),
        ],
    );
}

#[test]
fn latex_that_may_be_read_in_two_ways_is_refused_where_it_may() {
    refuse(
        Notation::Latex,
        &[
            (r"a + \dots + b", r"\dots", r"`\dots` is not known", "write out"),
            (r"\sin q u", "u", "the end of the argument of `sin` is not clear", r"\sin(…)"),
            (r"\sin \omega \, t", "t", "the end of the argument of `sin` is not clear", r"\sin(…)"),
            (r"\cos\omega(t - s)", "(", "the end of the argument of `cos` is not clear", r"\cos(…)"),
            (r"\sin\theta/2", "/", "the end of the argument of `sin` is not clear", r"\sin(…)"),
            (r"\sin x^2", "^", "the end of the argument of `sin` is not clear", r"\sin(…)"),
            (r"\sin^{-1} x", "^{-1}", "power of a function", r"\arcsin"),
            (r"a/2 b", "b", "slash divide", r"\frac"),
            (r"q_12", "12", "is `12` all below", "{12}"),
            (r"x^10", "10", "is `10` all", "{10}"),
            (r"q 2", "2", "a number stands behind a factor", r"\cdot"),
            (r"\frac{d q}{d t} + \partial x", r"\partial", "is not known", r"\dot{q}_1"),
            (r"\dot{(a + b)}", r"\dot", "stands on no symbol", "single symbols"),
            (r"\sqrt[3]{x}", "[", "square roots", r"\sqrt"),
            (r"a \cdot / b", "/", "unexpected `/`", "operand is missing"),
            (r"\left(a + b", "(", "never closed", ")"),
            (r"a + {b", "{", "never closed", "}"),
            (r"a + b)", ")", "unexpected `)`", "nothing is open"),
            (r"x = y", "=", "unexpected `=`", "the right side alone"),
            (r"a^2_1", "_", "unexpected `_`", "at symbols only"),
            (r"x^2^3", "^", "second exponent", "braces"),
            (r"\dddot{q}", r"\dddot{q}", "more than 2 primes", "second derivative"),
            (r"\frac{a}{b - b}", "b - b", "division by zero", "zero"),
            (r"a + ж", "ж", "unexpected `ж`", r"\theta"),
            (r"\begin{split} a \end{split}", r"\begin", "is not known", "environment"),
            (r"a + ", "", "ends too early", "operand"),
            ("", "", "empty", "write 0"),
        ],
    );
}

#[test]
fn programs_are_read_as_their_languages_mean_them() {
    check(
        Notation::Python,
        &[
            ("-x**2 + 2**-1*sin(q1)**2", "-x^2 + 1/2*sin(q1)^2"),
            ("sp.cos(q1) + np.arctan2(y, x) + Abs(x) - math.fabs(x)", "cos(q1) + atan2(y, x)"),
            ("Rational(1, 2)*m*v**2 + S(1)/3 + sympy.pi", "m*v^2/2 + 1/3 + pi"),
            ("Derivative(q1(t), t) + q1(t).diff(t) + q1.diff(t)", "3*q1'"),
            ("Derivative(q1(t), (t, 2))*sin(q1(t)) + diff(q1(t), t, 2)", "q1''*sin(q1) + q1''"),
            ("x[0]*p.m  # the mass\n + pow(x, 2)", "x_0*p_m + x^2"),
            ("a**2**2", "a^4"),
            ("1.5e-3*x", "0.0015*x"),
        ],
    );
    check(
        Notation::Matlab,
        &[
            ("2.*x.^2./y - z(6)*p.m", "2*x^2/y - z_6*p_m"),
            ("m*(x + ... the rest\n y);", "m*(x + y)"),
            ("deg2rad(10) + 2.5*pi % ten degrees", "10*pi/180 + 5*pi/2"),
            ("-x^2 + x^-1 + power(x, 3) + sqrt(x)", "-x^2 + 1/x + x^3 + sqrt(x)"),
            ("x^2*y^3 + (x^2)^3", "x^2*y^3 + x^6"),
            ("2...\n*x", "2*x"),
        ],
    );
    check(
        Notation::C,
        &[
            ("pow(x, 2) + std::pow(sin(q1), 3)", "x^2 + sin(q1)^3"),
            ("M_PI/180.0*x[5] + p->m", "pi/180*x_5 + p_m"),
            ("1.0/2*x /* half */ + 1.0f * x; // end", "3/2*x"),
            ("fabs(x) - fmax(x, y)", "abs(x) - max(x, y)"),
            ("x/2*3/4", "3*x/8"),
        ],
    );
}

#[test]
fn what_a_language_means_otherwise_is_refused() {
    refuse(
        Notation::Python,
        &[
            ("x^2", "^", "unexpected `^`", "x**2"),
            ("x//2", "//", "unexpected `//`", "whole number"),
            ("2x", "x", "an operator is missing", "`*`"),
            ("Derivative(q1(t), x)", ", x)", "not a derivative", "Derivative(q(t), t)"),
            ("x = 2", "=", "unexpected `=`", "right side"),
            ("f(x)", "f", "not a function", "product"),
        ],
    );
    refuse(
        Notation::Matlab,
        &[
            ("x'*y", "'", "unexpected `'`", "transposes"),
            ("x^2^3", "^", "power of a power", "parentheses"),
            ("E \\ f", "\\", "unexpected `\\`", "[[system]]"),
            ("x; y", "y", "more than one statement", "one assignment"),
        ],
    );
    refuse(
        Notation::C,
        &[
            ("1/2*m", "/", "a quotient of whole numbers", "1.0/2"),
            ("3*1/2*m", "/", "a quotient of whole numbers", "towards zero"),
            ("(1 + 2)/(3)*x", "/", "a quotient of whole numbers", "towards zero"),
            ("x^2", "^", "unexpected `^`", "pow(x, 2)"),
            ("abs(x)", "abs", "unexpected `abs`", "fabs"),
            ("pow(x)", "pow", "two arguments", "pow(x, 2)"),
            ("pow(x, 2, 3)", ",", "too many", "remove"),
        ],
    );
}

/// Goal: a term printed in LaTeX is read as the same term. Method: terms with every kind of mark, and their print.
#[test]
fn printed_latex_is_the_term_again() {
    let formulas = [
        "-R*u2*tan(q2) + u1'*cos(q1)^2*(u1 + u2)^2/(2*R*(1 + M))",
        "sqrt(x^2 + y^2)*sin(x)*abs(x - y)*sign(u1) - 1/2*pi*x",
        "asin(x)*exp(-x)*log(y)*sinh(x)/cosh(y)",
        "theta''*I1*cos(2*theta + phi)*m_p*sin(x)^3/3",
        "(1 + 4*sin(q2)^2)*q1'^2/x^3 - 1/(x*y)",
        "cos(q1)*abs(x)*sin(q2)*sqrt(2)/tan(q2)^2",
    ];
    for formula in formulas {
        let mut arena = Arena::new();
        let term = read(&mut arena, formula, Notation::Tripos).unwrap();
        let printed = latex(&arena, term);
        let again = read(&mut arena, &printed, Notation::Latex).unwrap_or_else(|e| panic!("{printed}: {e:?}"));
        // m_p is printed as m with a subscript, and read without its underscore.
        let expected = read(&mut arena, &formula.replace("m_p", "mp"), Notation::Tripos).unwrap();
        assert_eq!(again, expected, "{printed}");
    }
}

/// Content of a finding, except the text of the entry.
fn said(arena: &Arena, f: &Finding) -> String {
    let shown = |e: Option<Expr>| e.map(|e| print_text(arena, e));
    format!(
        "{} {} {:?} derived {:?} factor {:?} difference {:?} {:?}",
        f.id,
        f.section,
        f.judgement,
        shown(f.derived),
        shown(f.factor),
        shown(f.difference),
        f.remarks
    )
}

/// All findings of a publication of the disk, and the consequences of its systems for the motion.
fn verdicts(path: &Path) -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut model = Model::read(&root.join("../models/disk/model.toml")).unwrap();
    let source = Source::read(&root.join(path)).unwrap();
    let publication = publication::load_publication(&source, &mut model).unwrap_or_else(|errors| panic!("{errors}"));
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    let difference = judge_publication(&model, &mut derivations, &publication, &proof);
    let arena = &derivations.kinematics.arena;
    let mut list: Vec<String> = difference.findings.iter().map(|f| said(arena, f)).collect();
    for system in &difference.consequences {
        let rates = system.rates.iter().map(|rate| rate.verdict.is_equal());
        list.push(format!("{}: {} {:?}", system.system, system.accelerations.is_equal(), rates.collect::<Vec<_>>()));
    }
    list
}

/// Goal: a publication is judged by its content, however it is typed. Method: the publication on the disk once more,
/// its formulas in LaTeX, its listings in MATLAB, its symbols the paper's own.
#[test]
fn the_report_on_the_disk_in_latex_has_the_same_verdicts() {
    let (plain, typeset) =
        (Path::new("../models/disk/publication.toml"), Path::new("tests/publications/disk_latex.toml"));
    let (expected, found) = (verdicts(plain), verdicts(typeset));
    assert!(expected.len() > 300, "{}", expected.len());
    for (expected, found) in expected.iter().zip(&found) {
        assert_eq!(found, expected);
    }
    assert_eq!(found.len(), expected.len());
}

/// Symbols of the paper stand for names of the model in every notation, also where they change places.
#[test]
fn symbols_of_the_paper_stand_for_names_of_the_model() {
    let symbols = "[symbols]\n'\\ell' = \"length\"\nJ = \"I\"\n'\\varphi' = \"q\"\n'\\dot{\\varphi}' = \"u2\"\n\"z(1)\" = \"u1\"\nu1 = \"u2\"\nu2 = \"u1\"\n";
    for (notation, printed) in [
        ("tripos", "u2 + length*cos(q)*u1"),
        ("latex", r"u_2 + \\ell \\cos(\\varphi) \\dot\\varphi"),
        ("matlab", "z(1) + length.*cos(q).*u1 + 0*J"),
        ("sympy", "u2 + length*cos(q)*u1"),
    ] {
        let text = edited(&[
            ("[abbreviations]", &format!("{symbols}[abbreviations]")),
            ("u1 + length*cos(q)*u2\"", &format!("{printed}\"\nnotation = \"{notation}\"")),
        ]);
        let mut model = base();
        let publication = load_text(&text, &mut model).unwrap_or_else(|errors| panic!("{errors}"));
        let publication::EntryKind::Equation { printed, .. } = &publication.entries[0].kind else {
            panic!("an equation")
        };
        assert_eq!(
            tripos_derive::algebra::text::print::print_text(&model.arena, *printed),
            "u1 + length*u2*cos(q)",
            "{notation}"
        );
    }
}

/// Pieces of every notation, right and wrong.
const PIECES: [&str; 44] = [
    r"\frac",
    r"\frac12",
    "{",
    "}",
    "_",
    "^",
    "'",
    r"\dot",
    r"\ddot{q}",
    r"\left(",
    r"\right)",
    r"\left|",
    r"\right|",
    "|",
    r"\sin",
    r"\sin^2",
    r"\sqrt",
    r"\mathrm{den}",
    r"\mathrm{",
    r"\,",
    r"\\",
    "&",
    r"\theta",
    "θ",
    "é",
    "−",
    "**",
    ".*",
    "...",
    "pow(",
    "Derivative(",
    "(t)",
    ".diff(",
    "Rational(",
    "z(6)",
    "z[5]",
    "p->m",
    "/*",
    "1/2",
    "%",
    ";",
    ",",
    "\u{0}",
    "1e999",
];

/// Goal: no text of any notation does harm. Method: formulas of the disk's publication cut, doubled and mixed at
/// random; every refusal marks a place of the text.
#[test]
fn no_formula_however_wrong_does_harm() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let file = std::fs::read_to_string(root.join("tests/publications/disk_latex.toml")).unwrap();
    let formulas: Vec<&str> = file.lines().filter_map(|line| line.split('\'').nth(1)).collect();
    let mut state = 1_u64;
    let mut below = |n: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(state >> 33).unwrap() % n.max(1)
    };
    let mut counts = [0; 2];
    for _ in 0..6000 {
        let mut formula = formulas[below(formulas.len())].to_owned();
        for _ in 0..=below(3) {
            let boundary = |at: usize| (at..=formula.len()).find(|at| formula.is_char_boundary(*at)).unwrap_or(0);
            let (from, to) = (boundary(below(formula.len() + 1)), boundary(below(formula.len() + 1)));
            let piece = PIECES[below(PIECES.len())];
            formula = match below(3) {
                0 => format!("{}{piece}{}", &formula[..from], &formula[from..]),
                1 => format!("{}{piece}{}", &formula[..from.min(to)], &formula[from.max(to)..]),
                _ => format!("{}{}", &formula[..from], &formula[to..]),
            };
        }
        let notation = Notation::ALL[below(5)];
        match read(&mut Arena::new(), &formula, notation) {
            Ok(_) => counts[0] += 1,
            Err(error) => {
                assert!(formula.get(error.span.clone()).is_some(), "{formula}: {error:?}");
                counts[1] += 1;
            }
        }
    }
    assert!(counts.iter().all(|n| *n > 300), "{counts:?}");
}
