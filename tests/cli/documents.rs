//! `tripos derive --format markdown` and `typst`: the document that LaTeX is tested as, in other languages.

use crate::latex::faults;
use crate::support::{library_as, root, tripos_in};
use expect_test::expect;
use serde_json::Value;
use std::collections::BTreeSet;
use std::process::{Command, Stdio};
use tripos_derive::algebra::meaning::compare::Comparer;
use tripos_derive::algebra::text::parse::parse_primed;
use tripos_derive::algebra::text::print::typst_name;
use tripos_derive::algebra::{Arena, Expr};

fn derived(model: &str, format: &str) -> String {
    let (status, text, err) = tripos_in(&root(), &["derive", model, "--by", "kane", "--format", format]);
    assert_eq!(status, 0, "{err}");
    text
}

/// The formulas of Markdown, those of blocks and those among words, and its words.
fn parted(text: &str) -> (Vec<String>, Vec<String>, String) {
    let (mut blocks, mut inline, mut words) = (Vec::new(), Vec::new(), String::new());
    for (at, part) in text.split("```").enumerate() {
        if at % 2 == 1 {
            blocks.push(part.strip_prefix("math\n").expect("only formulas stand in blocks").to_owned());
            continue;
        }
        for line in part.replace("<span>$</span>", "").lines() {
            let pieces: Vec<&str> = line.split('$').collect();
            assert!(pieces.len() % 2 == 1, "dollars pair up: {line}");
            for (at, piece) in pieces.iter().enumerate() {
                if at % 2 == 0 {
                    words.push_str(piece);
                } else {
                    let (open, close) = (piece.starts_with('`'), piece.ends_with('`'));
                    assert!(open == close && !piece.starts_with(' ') && !piece.ends_with(' '), "{line}");
                    inline.push(piece.trim_matches('`').to_owned());
                }
            }
            words.push('\n');
        }
    }
    assert!(text.matches("```").count().is_multiple_of(2), "blocks are closed");
    (blocks, inline, words)
}

/// The lines of formulas between two marks, in their order.
fn lines<'a>(blocks: impl Iterator<Item = &'a str>) -> Vec<String> {
    let lines = blocks.flat_map(|block| block.split("\\\\\n").map(|line| line.trim().to_owned()));
    lines.filter(|line| line.contains('&')).collect()
}

/// Goal: GitHub shows the formulas of LaTeX, which other tests hold against JSON. Method: every model of the library:
/// delimiters pair up, each formula compiles, and all aligned lines are those of LaTeX, in order.
#[test]
fn markdown_has_the_formulas_of_latex() {
    let mut count = 0;
    for ((model, latex), (_, markdown)) in library_as("latex").zip(library_as("markdown")) {
        let (blocks, inline, words) = parted(&markdown);
        for formula in blocks.iter().chain(&inline) {
            assert_eq!(faults(&format!("\\[{formula}\\]")), Vec::<String>::new(), "{model}: {formula}");
        }
        assert!(!words.contains("\\text") && !words.contains("^{"), "{model}: formulas among words: {words}");
        let of_latex = latex.split("\\begin{align}\n").skip(1).filter_map(|rest| rest.split("\n\\end{align}").next());
        let of_markdown = blocks.iter().filter_map(|block| block.split_once("\\begin{aligned}\n"));
        let of_markdown = of_markdown.filter_map(|(_, rest)| rest.split("\n\\end{aligned}").next());
        let expected: Vec<String> = lines(of_latex)
            .into_iter()
            .map(|line| line.replace("\\operatorname{", "\\mathrm{").replace(" \\notag", ""))
            .collect();
        assert_eq!(lines(of_markdown), expected, "{model}");
        count += expected.len();
    }
    assert!(count > 1000, "{count}");
}

/// Words that Typst itself defines and that formulas use.
const TYPST_WORDS: [&str; 26] = [
    "frac", "sqrt", "abs", "thin", "sin", "cos", "tan", "sinh", "cosh", "tanh", "arcsin", "arccos", "arctan", "exp",
    "log", "op", "pi", "dot", "double", "mat", "vec", "delim", "attach", "bold", "upright", "partial",
];

/// The formulas of a Typst document.
fn typst_formulas(text: &str) -> Vec<String> {
    let escaped = text.replace("\\$", "");
    let pieces: Vec<&str> = escaped.split('$').collect();
    assert!(pieces.len() % 2 == 1, "dollars pair up");
    pieces.into_iter().skip(1).step_by(2).map(str::to_owned).collect()
}

/// Goal: no formula mentions a word that Typst does not know, which would be an error. Method: the words of every
/// model's formulas, except those between quotes.
#[test]
fn typst_knows_every_word_of_the_formulas() {
    let greek = "alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi rho sigma tau phi chi psi omega Gamma Delta Theta \
                 Lambda Xi Sigma Phi Psi Omega";
    let known: BTreeSet<&str> =
        TYPST_WORDS.into_iter().chain(greek.split_whitespace()).chain(["quad", "times", "tl", "tr", "dots"]).collect();
    for (model, text) in library_as("typst") {
        for formula in typst_formulas(&text) {
            let bare: String = formula.split('"').step_by(2).collect::<Vec<_>>().join(" ");
            let words = bare.split(|c: char| !c.is_ascii_alphabetic()).filter(|word| word.len() > 1);
            let unknown: Vec<&str> = words.filter(|word| !known.contains(word)).collect();
            assert!(unknown.is_empty(), "{model}: {unknown:?} in {formula}");
            let pairs = bare.replace("\\(", "(").replace("\\)", ")");
            assert_eq!(pairs.matches('(').count(), pairs.matches(')').count(), "{formula}");
        }
    }
}

/// Every model of the library, by Typst if there is one.
#[test]
fn typst_documents_compile() {
    let has_typst = Command::new("typst").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if !has_typst.is_ok_and(|status| status.success()) {
        eprintln!("not compiled: there is no `typst` here");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for (model, text) in library_as("typst") {
        std::fs::write(folder.path().join("it.typ"), &*text).unwrap();
        let out = Command::new("typst").args(["compile", "it.typ"]).current_dir(folder.path()).output().unwrap();
        assert!(out.status.success(), "{model}: {}", String::from_utf8_lossy(&out.stderr));
    }
}

/// A formula of Typst that is read back as text of model files.
struct Reading<'a> {
    rest: &'a str,
    /// Pairs of a symbol's text in a formula and its name.
    names: &'a [(String, String)],
}

impl Reading<'_> {
    fn take(&mut self, mark: &str) -> bool {
        let found = self.rest.strip_prefix(mark);
        self.rest = found.unwrap_or(self.rest);
        found.is_some()
    }

    /// Up to what closes it, or a comma.
    fn formula(&mut self) -> String {
        let mut out = String::new();
        loop {
            self.rest = self.rest.trim_start();
            if self.rest.is_empty() || self.rest.starts_with([',', ')']) || self.rest.starts_with("\\)") {
                return out;
            }
            match () {
                () if self.take("thin ") || self.take("times ") => out.push('*'),
                () if self.take("+") => out.push('+'),
                () if self.take("-") => out.push('-'),
                () if self.take("^") => out.push('^'),
                () if self.take("\\/") => out.push('/'),
                () => out += &self.factor(),
            }
        }
    }

    fn closed(&mut self) -> String {
        let inside = self.formula();
        assert!(self.take("\\)") || self.take(")"), "nothing closes: {}", self.rest);
        inside
    }

    fn factor(&mut self) -> String {
        self.rest = self.rest.trim_start();
        let digits = self.rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest.len());
        if digits > 0 {
            let (number, rest) = self.rest.split_at(digits);
            self.rest = rest;
            return number.to_owned();
        }
        if self.take("(") || self.take("\\(") {
            return format!("({})", self.closed());
        }
        if self.take("frac(") {
            let above = self.formula();
            assert!(self.take(","), "{}", self.rest);
            return format!("(({above})/({}))", self.closed());
        }
        for call in ["sqrt", "abs"] {
            if self.take(&format!("{call}(")) {
                return format!("{call}({})", self.closed());
            }
        }
        for (written, name) in [
            ("arcsin", "asin"),
            ("arctan", "atan"),
            ("sin", "sin"),
            ("cos", "cos"),
            ("tan", "tan"),
            ("op(\"sign\")", "sign"),
        ] {
            if self.take(written) {
                let power = if self.take("^") { Some(self.factor()) } else { None };
                let argument = self.factor();
                return power.map_or(format!("{name}({argument})"), |power| format!("{name}({argument})^{power}"));
            }
        }
        for (written, name) in self.names {
            if self.rest.starts_with(written.as_str()) {
                self.rest = &self.rest[written.len()..];
                return name.clone();
            }
        }
        panic!("what is `{}`?", self.rest)
    }
}

/// The right sides of a section of a Typst document.
fn rows(text: &str, section: &str) -> Vec<String> {
    let (_, section) = text.split_once(&format!("\n=== {section}\n")).unwrap_or_else(|| panic!("no {section}"));
    let section = section.split("\n==").next().unwrap_or(section);
    let mut list: Vec<String> = Vec::new();
    for line in typst_formulas(section).iter().flat_map(|formula| formula.split("\\\n")) {
        match (line.split_once(" &= "), list.last_mut()) {
            (Some((_, right)), _) => list.push(right.to_owned()),
            (None, Some(right)) => right.push_str(line.trim_start().trim_start_matches("&quad")),
            _ => {}
        }
    }
    list
}

/// Goal: Typst shows the equations that programs get. Method: its accelerations and energies read back here, and
/// compared by algebra with JSON, of models with fractions, roots, loops and named terms.
#[test]
fn typst_says_what_json_says() {
    for model in ["disk", "pendulum", "cart_pendulum_3", "heavy_top", "four_bar", "furuta", "governor", "knife_edge"] {
        let model = format!("models/{model}");
        let (text, json) = (derived(&model, "typst"), serde_json::from_str::<Value>(&derived(&model, "json")).unwrap());
        let kane = &json["formulations"][0];
        let text_of = |value: &Value| value.as_str().unwrap().to_owned();
        let mut expected: Vec<String> =
            kane["accelerations"].as_array().unwrap().iter().map(|step| text_of(&step["value"])).collect();
        expected.extend(["kinetic_energy", "potential_energy"].map(|key| text_of(&kane[key])));
        let mut found = rows(&text, "Accelerations");
        found.extend(rows(&text, "Kinetic and potential energy").into_iter().take(2));
        assert_eq!(found.len(), expected.len(), "{model}");
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '\'';
        let words = expected.iter().flat_map(|text| text.split(|c: char| !is_word(c)));
        let words = words.filter(|word| word.starts_with(|c: char| c.is_ascii_alphabetic()));
        let mut names: Vec<(String, String)> = words.map(|name| (typst_name(name), name.to_owned())).collect();
        names.sort_by_key(|(written, _)| std::cmp::Reverse(written.len()));
        let mut arena = Arena::new();
        let read = |arena: &mut Arena, text: &str| -> Expr {
            let read = parse_primed(arena, text, 2, &mut |arena, name| Ok(arena.symbol(name)));
            read.unwrap_or_else(|error| panic!("{text}: {error:?}"))
        };
        for (found, expected) in found.iter().zip(&expected) {
            let mut reading = Reading { rest: found, names: &names };
            let plain = reading.formula();
            assert_eq!(reading.rest, "", "{model}: {found}");
            let [one, two] = [&plain, expected].map(|text| read(&mut arena, text));
            let same = Comparer::default().compare(&mut arena, one, two).is_equal();
            assert!(same, "{model}: {found}\nis not\n{expected}");
        }
    }
}

/// Titles and names of whatever characters stay words in both.
#[test]
fn hostile_titles_and_names_are_words() {
    let folder = tempfile::tempdir().unwrap();
    let model = std::fs::read_to_string(root().join("models/pendulum/model.toml")).unwrap();
    let title = model.lines().find(|line| line.starts_with("name = ")).unwrap();
    let hostile = model.replace(title, "name = '- $x$ `a` *b* <i> #1 [c](d) \\e | é 世界'").replace("rod", "rod_1_");
    std::fs::write(folder.path().join("model.toml"), hostile).unwrap();
    let text = |format: &str| {
        let (status, text, err) = tripos_in(folder.path(), &["derive", "model.toml", "--format", format]);
        assert_eq!(status, 0, "{err}");
        text
    };
    let markdown = text("markdown");
    let expected = "# \\- <span>$</span>x<span>$</span> \\`a\\` \\*b\\* \\<i\\> \\#1 \\[c\\](d) \\\\e \\| é 世界\n";
    assert_eq!(markdown.lines().next(), Some(expected.trim_end()));
    parted(&markdown);
    let typst = text("typst");
    let expected = "\n= \\- \\$x\\$ \\`a\\` \\*b\\* \\<i\\> \\#1 \\[c\\](d) \\\\e | é 世界\n";
    assert!(typst.contains(expected), "{typst}");
    typst_formulas(&typst);
}

#[test]
fn a_pendulum_in_markdown() {
    expect![[r"
        # Pendulum

        1 configuration variable, 0 holonomic constraints, 1 generalized coordinate, 0 nonholonomic constraints, 1 generalized speed.

        ## Symbols

        | symbol | meaning | unit |
        |---|---|---|
        | $m$ | mass of the bob | kg |
        | $l$ | length of the massless rod | m |
        | $g$ | acceleration of free fall | m/s<sup>2</sup> |
        | $\theta$ | rod from hanging |  |
        | $\omega$ | generalized speed | 1/s |
        | $\mathrm{rod}$ | reaction |  |
        | $\mathrm{plane}$ | reaction |  |

        ## Bodies

        | body | mass and inertia |
        |---|---|
        | $\mathrm{bob}$ | particle of mass $m$ at $P$ |

        ## Kane's method

        ### Generalized speeds and kinematic equations

        ```math
        \begin{aligned}
        \omega &= \dot{\theta} \\
        \dot{\theta} &= \omega
        \end{aligned}
        ```

        ### Velocity and partial velocities: ${}^{N}\mathbf{v}^{P}$, components in N

        ```math
        \begin{aligned}
        {}^{N}\mathbf{v}^{P} \cdot \mathbf{n}_{1} &= l \, \omega \, \cos \theta \\
        {}^{N}\mathbf{v}^{P} \cdot \mathbf{n}_{2} &= l \, \omega \, \sin \theta \\
        {}^{N}\mathbf{v}^{P} \cdot \mathbf{n}_{3} &= 0 \\
        \frac{\partial {}^{N}\mathbf{v}^{P}}{\partial \omega} \cdot \mathbf{n}_{1} &= l \, \cos \theta \\
        \frac{\partial {}^{N}\mathbf{v}^{P}}{\partial \omega} \cdot \mathbf{n}_{2} &= l \, \sin \theta
        \end{aligned}
        ```

        ### Generalized active forces

        ```math
        \begin{aligned}
        F_{\omega} &= -m \, l \, g \, \sin \theta
        \end{aligned}
        ```

        ### Equations of motion

        One row for each of omega.

        ```math
        \begin{bmatrix}
        m \, l^{2}
        \end{bmatrix}
        \begin{bmatrix}
        \dot{\omega}
        \end{bmatrix}
        =
        \begin{bmatrix}
        -m \, l \, g \, \sin \theta
        \end{bmatrix}
        ```

        ### Accelerations

        Each by those before it.

        ```math
        \begin{aligned}
        \dot{\omega} &= -\frac{g \, \sin \theta}{l}
        \end{aligned}
        ```

        ### Kinetic and potential energy

        ```math
        \begin{aligned}
        T &= \frac{m \, l^{2} \, \omega^{2}}{2} \\
        V &= m \, l \, g \, \left(1 - \cos \theta\right)
        \end{aligned}
        ```

        ## First integrals

        #### energy T + V

        ```math
        \begin{aligned}
        C_{1} &= m \, l \, g \, \left(1 - \cos \theta\right) + \frac{m \, l^{2} \, \omega^{2}}{2}
        \end{aligned}
        ```
    "]]
    .assert_eq(&derived("models/pendulum", "markdown"));
}

#[test]
fn a_pendulum_in_typst() {
    expect![[r#"
        #set page(paper: "a4", margin: 25mm)
        #show math.equation: set block(breakable: true)
        #set math.equation(numbering: "(1)")

        = Pendulum

        1 configuration variable, 0 holonomic constraints, 1 generalized coordinate, 0 nonholonomic constraints, 1 generalized speed.

        == Symbols

        / $m$: mass of the bob, kg
        / $l$: length of the massless rod, m
        / $g$: acceleration of free fall, m/s#super[2]
        / $theta$: rod from hanging
        / $omega$: generalized speed, 1/s
        / $"rod"$: reaction
        / $"plane"$: reaction

        == Bodies

        / $"bob"$: particle of mass $m$ at $P$

        == Kane's method

        === Generalized speeds and kinematic equations

        $ omega &= dot(theta) \
          dot(theta) &= omega $

        === Velocity and partial velocities: $attach(bold(upright(v)), tl: N, tr: P)$, components in N

        $ attach(bold(upright(v)), tl: N, tr: P) dot bold(upright(n))_1 &= l thin omega thin cos theta \
          attach(bold(upright(v)), tl: N, tr: P) dot bold(upright(n))_2 &= l thin omega thin sin theta \
          attach(bold(upright(v)), tl: N, tr: P) dot bold(upright(n))_3 &= 0 \
          frac(partial attach(bold(upright(v)), tl: N, tr: P), partial omega) dot bold(upright(n))_1 &= l thin cos theta \
          frac(partial attach(bold(upright(v)), tl: N, tr: P), partial omega) dot bold(upright(n))_2 &= l thin sin theta $

        === Generalized active forces

        $ F_(omega) &= -m thin l thin g thin sin theta $

        === Equations of motion

        One row for each of omega.

        $ mat(delim: "[",
          m thin l^2)
          vec(delim: "[", dot(omega))
          = vec(delim: "[", -m thin l thin g thin sin theta) $

        === Accelerations

        Each by those before it.

        $ dot(omega) &= -frac(g thin sin theta, l) $

        === Kinetic and potential energy

        $ T &= frac(m thin l^2 thin omega^2, 2) \
          V &= m thin l thin g thin (1 - cos theta) $

        == First integrals

        ==== energy T + V

        $ C_(1) &= m thin l thin g thin (1 - cos theta) + frac(m thin l^2 thin omega^2, 2) $
    "#]].assert_eq(&derived("models/pendulum", "typst"));
}

/// Goal: long terms are printed in steps. Method: a tree of five bodies: named terms are listed, and no line is much
/// longer than a page is wide.
#[test]
fn large_models_come_out_in_steps() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.toml");
    std::fs::write(&path, crate::arm::tree_text(5, |i| i / 2, |i| i == 3, crate::arm::Reactions::All)).unwrap();
    for (format, heading) in
        [("markdown", "\n### Terms that stand by a name\n"), ("typst", "\n=== Terms that stand by a name\n")]
    {
        let text = derived(path.to_str().unwrap(), format);
        assert!(text.contains(heading), "{format}");
        let longest = text.lines().map(str::len).max().unwrap();
        assert!(longest < 2000 && !text.contains("too long to print"), "{format}: {longest}");
    }
}
