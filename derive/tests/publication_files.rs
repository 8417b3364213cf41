//! Publication files: what is read from a right one, and that no file, however wrong, does harm.

use crate::publications;

use publications::{PUBLICATION, base, edited, errors, load_text};
use std::path::Path;
use tripos_derive::algebra::meaning::compare::{Comparer, Verdict};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::{Derivations, Quantities, derive_all};
use tripos_derive::publication::{EntryKind, Publication, QuantityNames, load_publication};
use tripos_derive::{Formulation, Model};

#[test]
fn a_report_is_read_entry_by_entry() {
    let mut model = base();
    let publication = load_text(PUBLICATION, &mut model).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((publication.title.as_str(), publication.reference.as_str()), ("A pendulum", "a blackboard"));
    let ids: Vec<String> = publication.entries.iter().flat_map(tripos_derive::publication::Entry::ids).collect();
    let expected = "1-vx 1-text 2-T 3-row1 3-row2 3-E11 3-E12 3-E21 3-E22 3-A1 3-A2 \
                    code-dz1 code-dz2 code-dz3 code-dz4 code-E11 code-E12 code-E21 code-E22 4-q 4-x'";
    assert_eq!(ids.join(" "), expected);
    let entry = &publication.entries[0];
    assert_eq!((entry.section.as_str(), entry.note.as_deref(), entry.repaired.as_deref()), ("1", Some("a note"), None));
    assert_eq!(&PUBLICATION[entry.span.clone()], "1-vx");
    assert_eq!(publication.entries[2].repaired.as_deref(), Some("a stain, read as 0"));
    let EntryKind::Equation { quantity, printed, text: source } = &entry.kind else { panic!("an equation") };
    assert_eq!((quantity.to_string().as_str(), source.as_str()), ("v(C) @ N [1]", "u1 + length*cos(q)*u2"));
    assert_eq!(print_text(&model.arena, *printed), "u1 + length*u2*cos(q)");
    let EntryKind::Definition { text } = &publication.entries[1].kind else { panic!("a definition") };
    assert_eq!(text, "F = m a");
}

#[test]
fn systems_listings_and_numbers_are_read_with_their_names() {
    let mut model = base();
    let publication = load_text(PUBLICATION, &mut model).unwrap_or_else(|e| panic!("{e}"));
    let EntryKind::System(system) = &publication.entries[3].kind else { panic!("a system") };
    assert_eq!((system.formulation, system.frame), (Formulation::Lagrange, None));
    assert_eq!(system.unknowns, [model.coordinates[0].second_rate, model.coordinates[1].second_rate]);
    assert_eq!(system.matrix[0][1], system.matrix[1][0]);
    assert_eq!(print_text(&model.arena, system.right[1]), "-m*length*g*sin(q)");
    assert_eq!((system.matrix_texts[1][1].as_str(), system.right_texts[0].as_str()), ("I + m*length^2", "bob*q'^2"));
    let EntryKind::Listing(listing) = &publication.entries[4].kind else { panic!("a listing") };
    assert_eq!(listing.state_names, ["q", "x", "u2", "u1"]);
    assert_eq!(listing.state[2], model.speeds[1].symbol);
    assert_eq!(listing.matrix.as_ref().map(|m| print_text(&model.arena, m[1][1])), Some("m".to_owned()));
    let initial = |at: usize| {
        let EntryKind::Initial(initial) = &publication.entries[at].kind else { panic!("an initial value") };
        (initial.set.as_str(), initial.quantity, print_text(&model.arena, initial.value), initial.decimals)
    };
    assert_eq!(initial(5), ("text", model.coordinates[1].symbol, "pi/18".to_owned(), None));
    assert_eq!(initial(6), ("text", model.coordinates[0].rate, "-1/4".to_owned(), Some(3)));
}

/// Resolves the names of a publication and compares an equation with the derived value of its quantity.
fn verdict(publication: &Publication, model: &Model, derivations: &mut Derivations, id: &str) -> Verdict {
    let mut quantities = Quantities::new(model, derivations);
    let names = QuantityNames::new(publication, &mut quantities);
    let entry = publication.entries.iter().find(|e| e.id == id).unwrap_or_else(|| panic!("no entry {id}"));
    let EntryKind::Equation { quantity, printed, .. } = &entry.kind else { panic!("{id} is no equation") };
    let derived = quantities.value(quantity).unwrap_or_else(|e| panic!("{id}: {e}"));
    let printed = names.resolve_quantity_names(&mut quantities, *printed).unwrap_or_else(|e| panic!("{id}: {e}"));
    let rates = quantities.mentions_rates(printed) || quantities.mentions_rates(derived);
    let both = [printed, derived].map(|e| if rates { quantities.in_rates(e) } else { quantities.in_speeds(e) });
    Comparer::default().compare(&mut quantities.derivations.kinematics.arena, both[0], both[1])
}

/// Goal: names are symbols of their own until they are resolved. Method: `T` as printed is the derived T, and the
/// model's names keep their meaning.
#[test]
fn names_stand_for_what_is_derived() {
    let mut model = base();
    let publication = load_text(PUBLICATION, &mut model).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(publication.names[1].0, "vx");
    assert_ne!(Some(publication.names[0].2), model.arena.find_symbol("T"));
    let mut derivations = derive_all(&model).unwrap_or_else(|e| panic!("{e}"));
    for id in ["1-vx", "2-T"] {
        assert!(verdict(&publication, &model, &mut derivations, id).is_equal(), "{id}");
    }
}

/// Goal: the largest file we have is read whole. Its content is another's concern; here only one right and one wrong
/// entry are judged.
#[test]
fn the_report_on_the_disk_is_read() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/disk");
    let mut model = Model::read(&folder.join("model.toml")).unwrap_or_else(|e| panic!("{e}"));
    let source = Source::read(&folder.join("publication.toml")).unwrap_or_else(|e| panic!("{e}"));
    let publication = load_publication(&source, &mut model).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(publication.entries.len(), source.text.lines().filter(|line| line.starts_with("[[")).count());
    let mut derivations = derive_all(&model).unwrap_or_else(|e| panic!("{e}"));
    assert!(verdict(&publication, &model, &mut derivations, "2.9-v1").is_equal());
    assert!(verdict(&publication, &model, &mut derivations, "2.4-b3").is_equal());
    assert!(matches!(verdict(&publication, &model, &mut derivations, "kane-3.2-line2-b1"), Verdict::Different(_)));
}

/// The disk's height z is 0 by a constraint, and so are its derivatives; a publication may mention it all the same.
#[test]
fn a_constrained_variable_stands_for_its_value() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/disk");
    let mut model = Model::read(&folder.join("model.toml")).unwrap_or_else(|e| panic!("{e}"));
    let entry =
        "[[equation]]\nid = \"1\"\nsection = \"1\"\nquantity = \"p(P) @ A [3]\"\nprinted = \"z + z' + 2*z''\"\n";
    let publication = load_text(entry, &mut model).unwrap_or_else(|e| panic!("{e}"));
    let mut derivations = derive_all(&model).unwrap_or_else(|e| panic!("{e}"));
    assert!(verdict(&publication, &model, &mut derivations, "1").is_equal());
}

/// Names of the publication that equal the name of a frame or body do no harm: those cannot stand in formulas.
#[test]
fn names_of_frames_and_functions_of_time_are_free() {
    let text = edited(&[("s = \"sin(q)\"", "A = \"cos(q)\"\nt = \"tan(q)\"\ns = \"A*t\"")]);
    load_text(&text, &mut base()).unwrap_or_else(|e| panic!("{e}"));
}

/// One text for each of `count` numbers.
fn repeated(count: usize, text: impl Fn(usize) -> String) -> String {
    (0..count).map(text).collect::<Vec<_>>().concat()
}

/// Time that this thread has worked, ns, whatever else the machine does; `None` where the system does not tell.
fn worked() -> Option<u64> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    text.split_whitespace().next()?.parse().ok()
}

/// No file makes the reader panic, hang or fill the memory.
#[test]
fn hostile_files_are_refused_quickly() {
    let start = worked();
    let equation = |printed: &str| edited(&[("u1 + length*cos(q)*u2", printed)]);
    let listing = "[[listing]]\nid = \"a\"\nsection = \"1\"\nformulation = \"kane\"\n";
    let system = "[[system]]\nid = \"a\"\nsection = \"1\"\nformulation = \"kane\"\n";
    let long = repeated(20_000, |i| format!("q*x^{}*u1^{} + ", i % 900, i / 900));
    let written = |notation: &str, printed: &str| {
        edited(&[("u1 + length*cos(q)*u2\"", &format!("{printed}\"\nnotation = \"{notation}\""))])
    };
    let files = [
        written("latex", &"\\\\frac{".repeat(100_000)),
        written("latex", &("{".repeat(100_000) + "q" + &"}".repeat(100_000))),
        written("latex", &"\\\\dot".repeat(100_000)),
        written("latex", &"\\\\left|".repeat(100_000)),
        written("latex", &("\\\\left|".repeat(100_000) + &"\\\\right|".repeat(100_000))),
        written("latex", &"z".repeat(200_000)),
        written("latex", &"q_{".repeat(100_000)),
        written("latex", &"\\\\sin ".repeat(100_000)),
        written("matlab", &"z(".repeat(100_000)),
        written("c", &format!("z{}", "/1".repeat(200_000))),
        written("python", &"Derivative(".repeat(100_000)),
        written("python", &"pow(".repeat(100_000)),
        written("fortran", "q"),
        equation(&("(".repeat(100_000) + "q" + &")".repeat(100_000))),
        equation(&format!("1{}", "0".repeat(100_000))),
        equation("q^999999999999"),
        equation("1/(q - q)"),
        equation("q + é"),
        edited(&[("v(C) @ N [1]\"\nprinted", "\\u0000v(\"\nprinted")]),
        edited(&[("id = \"1-vx\"", "id = \"\\u0000\"")]),
        format!("equation = {}{}", "[".repeat(100_000), "]".repeat(100_000)),
        "\0".to_owned(),
        "{{{{".to_owned(),
        "[[equation]]\n".repeat(100_000),
        format!("{system}unknowns = [1, 2]\nmatrix = 3\nright = [[]]\n"),
        format!("{system}unknowns = [\"u1'\"]\nmatrix = [[{}]]\nright = []\n", "\"zz\",".repeat(300_000)),
        format!("{system}unknowns = []\nmatrix = [[{}]]\nright = []\n", repeated(300_000, |i| format!("\"z{i}\","))),
        format!("{listing}state = [{}]\nderivative = []", "\"q\",".repeat(300_000)),
        format!("[abbreviations]\na = \"{long}1\"\n{}", repeated(900, |i| format!("b{i} = \"a + q^{i}\"\n"))),
        format!("[names]\n{}", repeated(100_000, |i| format!("n{i} = \"T\"\n"))),
    ];
    for text in files {
        let errors = errors(&text);
        assert!(!errors.list.is_empty());
        assert!(errors.to_string().len() < 100_000);
    }
    if let Some((start, end)) = start.zip(worked()) {
        assert!(end - start < 60_000_000_000, "{} ns of work", end - start);
    }
}
