//! Time to decide whether an expression is zero: by exact evaluation, and by a proof.
//!
//! `cargo bench -p tripos-benches --features measure --bench algebra`

#![allow(missing_docs, reason = "`criterion_group!` makes a public function")]

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use std::path::Path;
use std::time::Duration;
use tripos_derive::Model;
use tripos_derive::algebra::form::normal_form::{Normalizer, Zero};
use tripos_derive::algebra::meaning::compare::{Comparer, Engine, Verdict};
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{Quantities, Quantity, derive_all};

/// An expression that is zero, though no one can see it.
struct Case {
    name: &'static str,
    arena: Arena,
    zero: Expr,
}

/// F_r + F*_r − (f_r − Σ M_rs u̇_s): a row of Kane's equations as they are defined, against the row as it is printed.
fn kane_row(name: &'static str, model: &str, row: usize) -> Case {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(model).join("model.toml");
    let model = Model::read(&path).unwrap_or_else(|e| panic!("{e}"));
    let mut derivations = derive_all(&model).unwrap_or_else(|e| panic!("{e}"));
    let mut quantities = Quantities::new(&model, &mut derivations);
    let mut value = |name: String| {
        let quantity = Quantity::parse(&name, &model).unwrap_or_else(|e| panic!("{name}: {e:?}"));
        quantities.value(&quantity).unwrap_or_else(|e| panic!("{name}: {e}"))
    };
    let n = model.speeds.len();
    let entries: Vec<Expr> = (1..=n).map(|column| value(format!("M[{row},{column}]"))).collect();
    let [active, inertia, forcing] = ["F", "Fstar", "f"].map(|of| value(format!("{of}[{row}]")));
    let mut arena = derivations.kinematics.arena.clone();
    let mut terms = vec![active, inertia, arena.neg(forcing)];
    terms.extend(entries.iter().zip(&model.speeds).map(|(entry, speed)| arena.mul(*entry, speed.rate)));
    let zero = arena.sum(&terms);
    Case { name, arena, zero }
}

fn identity(name: &'static str, left: &str, right: &str) -> Case {
    let mut arena = Arena::new();
    let left = parse_free(&mut arena, left).expect("it is right");
    let right = parse_free(&mut arena, right).expect("it is right");
    let zero = arena.sub(left, right);
    Case { name, arena, zero }
}

fn cases() -> Vec<Case> {
    vec![
        kane_row("disk, Kane row 2", "disk", 2),
        kane_row("K07, Kane row 2", "cart_pendulum_3", 2),
        // Angles in halves and thirds, a quotient of sums, and nothing that cancels before all is expanded.
        identity(
            "hard identity",
            "(sin(a + b/2 - c/3)^4 + tan(b)*cos(a)^3)/(1 + sin(a - c)) - x/(cos(b) + y)",
            "((1 - cos(a + b/2 - c/3)^2)^2*(cos(b) + y) + sin(b)*(cos(3*a) + 3*cos(a))/4*(1 + y/cos(b)) \
             - x*(1 + sin(a)*cos(c) - cos(a)*sin(c)))/((cos(b) + y)*(1 + sin(a - c)))",
        ),
    ]
}

/// Shows what most decisions cost: every pivot, every "is it zero?" on the way to the equations is one of these.
fn modular(c: &mut Criterion) {
    let mut group = c.benchmark_group("zero test, modular");
    for Case { name, arena, zero } in cases() {
        assert_eq!(zero_test(&arena, zero), ZeroTest::Zero, "{name}");
        group.bench_function(name, |b| b.iter(|| zero_test(black_box(&arena), black_box(zero))));
    }
}

/// Shows what a proof costs beyond that: the normal form from nothing, without what it remembers of other terms.
fn normal_form(c: &mut Criterion) {
    let mut group = c.benchmark_group("zero test, normal form");
    for Case { name, arena, zero } in cases() {
        assert_eq!(Normalizer::default().zero_by_normal_form(&mut arena.clone(), zero), Zero::Yes, "{name}");
        let prove = |mut arena: Arena| Normalizer::default().zero_by_normal_form(&mut arena, black_box(zero));
        group.bench_function(name, |b| b.iter_batched(|| arena.clone(), prove, BatchSize::SmallInput));
    }
}

/// Shows the worst case of one comparison: a product of forty sums, which no budget expands, so that the modular test
/// decides.
fn too_large_to_expand(c: &mut Criterion) {
    let sums = |part: fn(usize) -> String| (0..40).map(part).collect::<Vec<_>>().join("*");
    let left = sums(|i| format!("(a{i} + b{i}*sin(q)^2)"));
    let right = sums(|i| format!("(a{i} + b{i} - b{i}*cos(q)^2)"));
    let Case { arena, zero, .. } = identity("forty sums", &left, &right);
    let compare = |mut arena: Arena| Comparer::default().is_zero(&mut arena, black_box(zero));
    assert!(matches!(compare(arena.clone()), Verdict::Equal(Engine::Modular { .. })));
    let mut group = c.benchmark_group("compare");
    group.sample_size(10);
    group.bench_function("forty sums", |b| b.iter_batched(|| arena.clone(), compare, BatchSize::SmallInput));
}

criterion_group! {
    name = benches;
    config = Criterion::default().warm_up_time(Duration::from_secs(1)).measurement_time(Duration::from_secs(3));
    targets = modular, normal_form, too_large_to_expand
}
criterion_main!(benches);
