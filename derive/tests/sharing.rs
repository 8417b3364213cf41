//! Shared sub-sums and sub-products, against what they were taken out of, by meaning.

use tripos_derive::algebra::form::sharing::{Angles, Products, SharingOptions, is_shared_symbol, share_common_parts};
use tripos_derive::algebra::form::simplify::{Simplifier, operation_count_of_all};
use tripos_derive::algebra::meaning::compare::Comparer;
use tripos_derive::algebra::term::calculus::Substitution;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{Derivation, accelerations, jacobian};
use tripos_derive::{Formulation, Model, derive};

const MODELS: [&str; 8] = [
    "models/disk/model.toml",
    "models/cart_pendulum_3/model.toml",
    "models/chaotic_pendulum/model.toml",
    "models/heavy_top/model.toml",
    "models/pendulum/model.toml",
    "derive/tests/models/k01.toml",
    "derive/tests/models/k11.toml",
    "derive/tests/models/k17a.toml",
];

/// Terms above which the normal form is not asked: zeros at random points modulo a random prime, with their bound, say
/// enough.
const LONG: usize = 150;

fn assert_equal(arena: &mut Arena, old: Expr, new: Expr, of: &str) {
    if arena.reachable(&[old, new]).len() < LONG {
        let verdict = Comparer::default().compare(arena, old, new);
        assert!(verdict.is_equal(), "{of}: {verdict:?}");
    } else {
        let difference = arena.sub(old, new);
        assert_eq!(zero_test(arena, difference), ZeroTest::Zero, "{of}");
    }
}

fn read(path: &str) -> Model {
    Model::read(&std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)).unwrap()
}

fn operations(arena: &Arena, steps: &[Definition], values: &[Expr]) -> usize {
    operation_count_of_all(
        arena,
        &steps.iter().map(|step| step.value).chain(values.iter().copied()).collect::<Vec<_>>(),
    )
}

/// Every step and value in the symbols that no step defines.
fn unfolded(arena: &mut Arena, steps: &[Definition], values: &[Expr]) -> (Vec<Definition>, Vec<Expr>) {
    let mut put = Substitution::new(&[]);
    let mut pairs: Vec<(Expr, Expr)> = Vec::new();
    for step in steps {
        pairs.push((step.symbol, put.apply(arena, step.value)));
        put = Substitution::new(&pairs);
    }
    let named = pairs.iter().filter(|(symbol, _)| !is_shared_symbol(arena, *symbol));
    let steps = named.map(|(symbol, value)| Definition { symbol: *symbol, value: *value }).collect();
    (steps, values.iter().map(|e| put.apply(arena, *e)).collect())
}

/// Proves that each reading means what it was read from and costs no more; returns the least cost.
fn proved(arena: &Arena, steps: &[Definition], values: &[Expr], of: &str) -> usize {
    let before = operations(arena, steps, values);
    let mut least = before;
    for reading in SharingOptions::ALL {
        let mut arena = arena.clone();
        let Some(shared) = share_common_parts(&mut arena, &mut Simplifier::default(), reading, steps, values) else {
            continue;
        };
        least = least.min(operations(&arena, &shared.steps, &shared.values));
        let (old_steps, old_values) = unfolded(&mut arena, steps, values);
        let (new_steps, new_values) = unfolded(&mut arena, &shared.steps, &shared.values);
        assert_eq!(new_steps.len(), steps.len(), "{of}: every step is still there");
        for old in &old_steps {
            let now = new_steps.iter().find(|s| s.symbol == old.symbol).expect("a step is not lost");
            let name = format!("{of}, {reading:?}, {}", print_text(&arena, old.symbol));
            assert_equal(&mut arena, old.value, now.value, &name);
        }
        for (value, now) in old_values.iter().zip(&new_values) {
            assert_equal(&mut arena, *value, *now, &format!("{of}, {reading:?}"));
        }
        // Each symbol is defined before it is used, and once.
        let mut known: Vec<Expr> = Vec::new();
        for (at, step) in shared.steps.iter().enumerate() {
            for later in &shared.steps[at..] {
                assert!(
                    !arena.mentions(step.value, later.symbol),
                    "{of}: {} is used too early",
                    print_text(&arena, later.symbol)
                );
            }
            assert!(!known.contains(&step.symbol), "{of}: {} is defined twice", print_text(&arena, step.symbol));
            known.push(step.symbol);
        }
    }
    least
}

/// Goal: fewer operations, the same functions. Method: the exact verdict on each step and value of every model,
/// formulation and reading.
#[test]
fn sharing_keeps_the_meaning_of_every_model() {
    for path in MODELS {
        let model = read(path);
        for formulation in [Formulation::Kane, Formulation::Lagrange] {
            let of = format!("{path} {formulation:?}");
            let Derivation { mut arena, equations: e } = derive(&model, formulation).unwrap();
            let entries = [e.matrix.concat(), e.forcing.clone()].concat();
            proved(&arena, &[], &entries, &of);
            let mut simplifier = Simplifier::default();
            let solved = accelerations(&mut arena, &mut simplifier, &e).unwrap();
            let rates = [e.coordinate_rates.clone(), e.unknowns[..e.variables.len()].to_vec()].concat();
            proved(&arena, &solved.steps, &rates, &of);
        }
    }
}

#[test]
fn sharing_keeps_the_meaning_of_a_jacobian() {
    let Derivation { mut arena, equations: e } = derive(&read("models/disk/model.toml"), Formulation::Kane).unwrap();
    let mut simplifier = Simplifier::default();
    let solved = accelerations(&mut arena, &mut simplifier, &e).unwrap();
    let slopes = jacobian(&mut arena, &mut simplifier, &e, &solved);
    let before = operations(&arena, &slopes.steps, &slopes.entries.concat());
    let least = proved(&arena, &slopes.steps, &slopes.entries.concat(), "Jacobian of the disk");
    assert!(5 * least < 4 * before, "{least} of {before} operations");
}

fn shared(input: &[&str], products: Products, angles: Angles) -> Vec<String> {
    let mut arena = Arena::new();
    let values: Vec<Expr> = input.iter().map(|text| parse_free(&mut arena, text).unwrap()).collect();
    let reading = SharingOptions { products, angles };
    let shared = share_common_parts(&mut arena, &mut Simplifier::default(), reading, &[], &values).unwrap();
    let steps =
        shared.steps.iter().map(|s| format!("{} = {}", print_text(&arena, s.symbol), print_text(&arena, s.value)));
    steps.chain(shared.values.iter().map(|e| print_text(&arena, *e))).collect()
}

#[test]
fn common_parts_are_what_a_person_would_take_out() {
    for (input, expected) in [
        // A product of two.
        (&["a*b*c", "a*b*d"][..], &["#1 = a*b", "c*#1", "d*#1"][..]),
        // A sum of two, up to its sign and a factor.
        (&["x*(a + b)", "3*a*y + 3*b*y", "-a - b"], &["#1 = a + b", "x*#1", "3*y*#1", "-#1"]),
        // The same sum in longer ones.
        (&["a + b + c", "a + b + d"], &["#1 = a + b", "c + #1", "d + #1"]),
        // Horner's rule.
        (&["1 + 2*x + 3*x^2 + 4*x^3"], &["1 + x*(2 + x*(3 + 4*x))"]),
        // One reciprocal for several divisions.
        (&["a/x", "b/x"], &["#1 = 1/x", "a*#1", "b*#1"]),
        // A number and a factor.
        (&["2*a*b", "2*a*c"], &["#1 = 2*a", "b*#1", "c*#1"]),
        // Powers.
        (&["x^4", "x^2*y"], &["#1 = x^2", "#1^2", "y*#1"]),
        // A value that is part of another.
        (&["a + b", "c*(a + b)"], &["#1 = a + b", "#1", "c*#1"]),
        // Nothing in common.
        (&["a + b", "c*d"], &["a + b", "c*d"]),
        (&["0", "5", "a"], &["0", "5", "a"]),
    ] {
        assert_eq!(shared(input, Products::Expanded, Angles::Kept), expected, "{input:?}");
    }
}

/// Goal: what grows along a chain is added up once along it. Method: sums over all later links, as in a chain's forces:
/// n (n − 1)/2 terms become about n.
#[test]
fn sums_along_a_chain_grow_as_its_length() {
    let count = |n: usize| {
        let mut arena = Arena::new();
        let values: Vec<Expr> = (0..n)
            .map(|i| {
                let terms: Vec<String> = (i..n).map(|j| format!("x{i}*y{j}")).collect();
                parse_free(&mut arena, &terms.join(" + ")).unwrap()
            })
            .collect();
        let reading = SharingOptions { products: Products::Factored, angles: Angles::Kept };
        let shared = share_common_parts(&mut arena, &mut Simplifier::default(), reading, &[], &values).unwrap();
        operations(&arena, &shared.steps, &shared.values)
    };
    for n in [4, 8, 16, 32] {
        // n products, and n − 1 sums that each add one term to another.
        assert_eq!(count(n), 2 * n - 1, "{n}");
    }
}

#[test]
fn sines_of_sums_come_from_those_of_the_parts() {
    let composed = |input: &[&str]| shared(input, Products::Factored, Angles::Composed);
    assert_eq!(
        composed(&["sin(p)*cos(q)", "sin(p - q)"]),
        ["#1 = sin(p)*cos(q)", "#sin(p - q) = #1 - cos(p)*sin(q)", "#1", "#sin(p - q)"]
    );
    // Of three differences of three angles one is the sum of the others.
    let angles = ["sin(p - q)", "sin(q - r)", "sin(p - r)"];
    let lines = composed(&angles);
    assert_eq!(lines.iter().filter(|line| line.contains(" = ")).count(), 1, "{lines:?}");
    // Six of four angles need three of them.
    let angles = ["sin(p - q)", "sin(q - r)", "sin(p - r)", "sin(p - s)", "sin(q - s)", "sin(r - s)"];
    let lines = composed(&angles);
    assert_eq!(lines.iter().filter(|line| line.starts_with("#sin(") && line.contains(" = ")).count(), 3, "{lines:?}");
    // Two angles are no cheaper than one sum of them.
    let mut arena = Arena::new();
    let alone = parse_free(&mut arena, "sin(p + q)*cos(p + q)").unwrap();
    let reading = SharingOptions { products: Products::Factored, angles: Angles::Composed };
    assert!(share_common_parts(&mut arena, &mut Simplifier::default(), reading, &[], &[alone]).is_none());
    // Inside another function they are defined before it.
    let lines = composed(&["sin(p)*cos(q)*sqrt(2 - cos(p - q))"]);
    let (cosine, root) = ("#cos(p - q) = ", "sqrt(2 - #cos(p - q))");
    let at = |what: &str| lines.iter().position(|line| line.contains(what)).expect(what);
    assert!(at(cosine) < at(root), "{lines:?}");
}
