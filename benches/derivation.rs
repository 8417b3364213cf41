//! Time to derive a model's equations, to prove them equivalent and to judge a publication.
//!
//! `cargo bench -p tripos-benches --features measure --bench derivation`

#![allow(missing_docs, reason = "`criterion_group!` makes a public function")]

#[path = "../derive/tests/common/arm.rs"]
mod arm;
#[path = "../derive/tests/common/chain.rs"]
mod chain;

use arm::{Reactions, arm};
use chain::chain;
use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::time::Duration;
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::judge_publication;
use tripos_derive::mechanics::{Derivations, SolvedAccelerations, derive_all};
use tripos_derive::prove::{Proof, prove};
use tripos_derive::publication::{Publication, load_publication};
use tripos_derive::{Formulation, Model, derive};

fn folder(model: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(model)
}

fn read(model: &str) -> Model {
    Model::read(&folder(model).join("model.toml")).unwrap_or_else(|e| panic!("{e}"))
}

/// Shows what one build of a model costs, method by method; the kinematics, which all share, are part of each.
fn formulations(c: &mut Criterion) {
    let mut group = c.benchmark_group("derive the disk");
    let model = read("disk");
    for formulation in Formulation::STANDARD {
        group.bench_function(formulation.name(), |b| {
            b.iter(|| derive(black_box(&model), formulation).unwrap_or_else(|e| panic!("{e}")));
        });
    }
}

/// Shows how derivation grows with the length of a chain, method by method, to M and f with all checks. For 20 links
/// the aim is 12 ms by one of them.
fn chains(c: &mut Criterion) {
    let mut group = c.benchmark_group("derive a chain on a cart");
    for links in [5, 10, 20] {
        let model = chain(links);
        for formulation in Formulation::STANDARD {
            group.bench_function(format!("{links} links, {}", formulation.name()), |b| {
                b.iter(|| derive(black_box(&model), formulation).unwrap_or_else(|e| panic!("{e}")));
            });
        }
    }
}

/// Shows how derivation, elimination and proof grow with the length of an arm of full inertias: Kane's M and f, then
/// accelerations with their Jacobian, then all formulations proved. For 40 joints the aim is 2 s.
fn arms(c: &mut Criterion) {
    let mut group = c.benchmark_group("an arm");
    for joints in [6, 10, 20, 40] {
        let model = arm(joints, Reactions::None);
        let kane = || derive(&model, Formulation::Kane).unwrap_or_else(|e| panic!("{e}"));
        group.bench_function(format!("{joints} joints, M and f"), |b| b.iter(|| black_box(kane())));
        group.bench_function(format!("{joints} joints, solved"), |b| {
            b.iter_batched(
                kane,
                |mut d| SolvedAccelerations::new(&mut d.arena, &d.equations).ok(),
                BatchSize::LargeInput,
            );
        });
        if joints <= 20 {
            group.bench_function(format!("{joints} joints, proved"), |b| b.iter(|| derived_and_proved(&model)));
        }
    }
}

fn derived_and_proved(model: &Model) -> (Derivations, Proof) {
    let mut derivations = derive_all(model).unwrap_or_else(|e| panic!("{e}"));
    let proof = prove(model, &mut derivations);
    (derivations, proof)
}

/// Shows what `tripos prove` waits for: all formulations, their equivalence and the first integrals. For the disk the
/// aim is 50 ms, at which the answer seems to be there at once.
fn proofs(c: &mut Criterion) {
    let mut group = c.benchmark_group("derive_all + prove");
    for name in ["disk", "cart_pendulum_3", "chaotic_pendulum"] {
        let model = read(name);
        assert!(derived_and_proved(&model).1.is_equivalent(), "{name}");
        group.bench_function(name, |b| b.iter(|| derived_and_proved(black_box(&model))));
    }
}

fn course_report() -> (Model, Publication) {
    let mut model = read("disk");
    let source = Source::read(&folder("disk").join("publication.toml")).unwrap_or_else(|e| panic!("{e}"));
    let report = load_publication(&source, &mut model).unwrap_or_else(|e| panic!("{e}"));
    (model, report)
}

/// Shows what `tripos diff` adds to that: the verdicts on every entry of the course report, and what its systems make
/// of the motion.
fn course_report_judged(c: &mut Criterion) {
    let (model, report) = course_report();
    let judge =
        |(mut derivations, proof): (Derivations, Proof)| judge_publication(&model, &mut derivations, &report, &proof);
    assert!(!judge(derived_and_proved(&model)).is_clean(), "the report has errors");
    c.bench_function("diff the course report", |b| {
        b.iter_batched(|| derived_and_proved(&model), judge, BatchSize::PerIteration);
    });
    c.bench_function("read the course report", |b| b.iter(course_report));
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_secs(1))
        .measurement_time(Duration::from_secs(5));
    targets = formulations, chains, arms, proofs, course_report_judged
}
criterion_main!(benches);
