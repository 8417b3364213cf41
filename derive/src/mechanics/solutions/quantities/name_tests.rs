//! Goal: every name in the table of docs/publication.md is read. Every other name is refused, with the error at its
//! place.

use super::tests::{disk, pendulum};
use crate::mechanics::quantity::Quantity;

#[test]
fn a_name_reads_back_as_itself() {
    let model = disk();
    for (text, canonical) in [
        (" rotation( A ,H )[1 , 2] ", "rotation(A, H) [1,2]"),
        ("v(Cstar)@B[1]", "v(Cstar) @ B [1]"),
        ("v(disk,P)@A[2]", "v(disk, P) @ A [2]"),
        ("d   omega(C) @ B [3] / d u5", "d omega(C) @ B [3]/d u5"),
        ("d v(P) @ A [1]/d 2", "d v(P) @ A [1]/d u2"),
        ("I(disk) @ B [1,2]", "I(disk) @ B [1,2]"),
        ("Hdot(disk) @ B [1]", "Hdot(disk) @ B [1]"),
        ("F[u1]", "F[1]"),
        ("Fstar[ 5 ]", "Fstar[5]"),
        ("M[u1, 2]", "M[1,2]"),
        ("E[q1, q5]", "E[1,5]"),
        ("A[q3]", "A[3]"),
        ("T_translation", "T_translation"),
        ("energy", "energy"),
        ("u1", "u1"),
        ("q1'", "q1'"),
    ] {
        let quantity = Quantity::parse(text, &model).unwrap_or_else(|e| panic!("{text}: {}", e.message));
        assert_eq!(quantity.to_string(), canonical);
        assert_eq!(Quantity::parse(canonical, &model), Ok(quantity));
    }
}

#[test]
fn a_wrong_name_says_what_and_where() {
    let model = disk();
    for (text, part, message, help) in [
        ("v(Cstr) @ B [1]", "Cstr", "the model has no point `Cstr`", "did you mean `Cstar`?"),
        ("omega(X) @ B [1]", "X", "the model has no frame `X`", "known here: `A`, `H`, `B`, `C`"),
        ("v(Cstar) @ B [4]", "4", "there is no component `4`", "components are 1, 2 and 3"),
        ("v(dsk, P) @ A [1]", "dsk", "the model has no body `dsk`", "did you mean `disk`?"),
        ("v(disk, B) @ A [1]", "B", "the model has no point `B`", "known here"),
        ("v(disk, P) @ A", "", "`[` is missing here", "the form is `v(BODY, POINT) @ FRAME [COMPONENT]`"),
        ("v(Cstar) @ B", "", "`[` is missing here", "the form is `v(POINT) @ FRAME [COMPONENT]`"),
        ("v Cstar @ B", "Cstar", "", "did you mean"),
        ("weight(dsk) @ B [1]", "dsk", "the model has no body `dsk`", "did you mean `disk`?"),
        ("F[6]", "6", "the model has no speed `6`", "it has 5 speeds"),
        ("F[v1]", "v1", "the model has no speed `v1`", "did you mean `u1`?"),
        ("A[u1]", "u1", "the model has no coordinate `u1`", "did you mean `q1`?"),
        ("M[1]", "]", "`,` is missing here", "the form is `M[SPEED,SPEED]`"),
        ("omga(B) @ B [1]", "omga", "unknown quantity `omga`", "did you mean `omega`?"),
        ("q6'", "q6'", "unknown quantity `q6'`", "did you mean `q1'`?"),
        ("d a(Cstar) @ B [1]/d u1", "a", "partial velocities are of `v` or `omega`, not of `a`", "the form is"),
        ("T + V", "+ V", "`+ V` does not belong to the name of a quantity", "write the name of one quantity"),
        ("", "", "the name of a quantity is missing here", "write the name of one quantity"),
        ("é", "é", "the name of a quantity is missing here", "write the name of one quantity"),
    ] {
        let Err(error) = Quantity::parse(text, &model) else { panic!("{text} must be refused") };
        if message.is_empty() {
            continue;
        }
        assert_eq!((error.message.as_str(), &text[error.range.clone()]), (message, part), "{text}");
        assert!(error.help.starts_with(help), "{text}: {}", error.help);
    }
    assert!(Quantity::parse("H(cart) @ N [1]", &pendulum()).is_err_and(|e| e.message.contains("particle")));
    assert!(Quantity::parse(&"v(".repeat(100_000), &model).is_err());
}
