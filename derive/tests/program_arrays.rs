//! Vectors and matrices of programs in publications: what changes them, and what is not read of them.
//!
//! The program solves for the accelerations of the cart with a rod, and is right as it stands. The truth about each
//! further line is what NumPy does with it.

use crate::printed_forms::CART;
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::diff::judge_publication;
use tripos_derive::mechanics::derive_all;
use tripos_derive::model::load;
use tripos_derive::prove::prove;
use tripos_derive::publication;

const PUBLICATION: &str = r#"
[[listing]]
id = "rhs"
section = "1"
file = "rhs.py"
part = "rhs"
formulation = "lagrange"
state = ["x", "theta", "x'", "theta'"]
derivative = ["return[0]", "return[1]", "return[2]", "return[3]"]
[symbols]
v = "x'"
omega = "theta'"
"#;

/// Judgement of the program with a line before the solution and a line after it.
fn judged(before: &str, after: &str) -> &'static str {
    let program = format!(
        "def rhs(z):\n    x, theta, v, omega = z\n    c, s = np.cos(theta), np.sin(theta)\n\
        \x20   A = np.array([[M + m, m*l*c], [m*l*c, J + m*l**2]])\n\
        \x20   b = np.array([F + m*l*omega**2*s, -m*g*l*s])\n    {before}\n    a = np.linalg.solve(A, b)\n    {after}\n\
        \x20   return np.concatenate([[v, omega], a])\n"
    );
    let read = |name: &str| -> Result<Source, Diagnostics> { Ok(Source::from_text(name, &program)) };
    let mut model = load(&Source::from_text("model.toml", CART)).unwrap_or_else(|e| panic!("{e}"));
    let source = Source::from_text("publication.toml", PUBLICATION);
    let Ok(publication) = publication::load_publication_with_files(&source, &mut model, &read) else {
        return "refused";
    };
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    let difference = judge_publication(&model, &mut derivations, &publication, &proof);
    let is_right = difference.findings.iter().all(|finding| finding.judgement.word() == "equal");
    if is_right { "right" } else { "wrong" }
}

/// Goal: no line leaves entries with values that NumPy would not have. A line that is not read is refused.
#[test]
fn every_change_of_an_array_is_seen() {
    for (line, expected) in [
        ("", "right"),
        ("b = b + np.array([0, 0])", "right"),
        ("A = A.T", "right"),
        ("b = -(-b)", "right"),
        ("A[1, 0] = A[0][1]", "right"),
        ("b = -b", "wrong"),
        ("b *= -1", "wrong"),
        ("b -= np.array([v, 0])", "wrong"),
        ("b[0] = 0", "wrong"),
        ("b[-1] = 0", "wrong"),
        ("b[1:] = 0", "wrong"),
        ("b[:] = 0", "wrong"),
        ("A[0] = [1, 0]", "wrong"),
        ("A[:, 0] = 1", "wrong"),
        ("A[0][1] = 0", "wrong"),
        ("A = 2*A", "wrong"),
        ("A = A + np.eye(2)", "wrong"),
        ("A = np.linalg.inv(A)", "wrong"),
        ("b = np.zeros(2)", "wrong"),
        ("K = A\n    K[0, 1] = 0", "refused"),
        ("K = A\n    K *= 2", "refused"),
        ("K = A\n    L = K\n    L[0, 1] = 0", "refused"),
        ("K = A.T\n    K[0, 0] = 1", "refused"),
        ("r = A[0]\n    r[1] = 0", "refused"),
        ("K = np.asarray(A, dtype=float)\n    K *= 2", "refused"),
        ("K = A.reshape(2, 2)\n    K *= 2", "refused"),
        ("K = np.asarray(A).reshape(2, 2)\n    K *= 2", "refused"),
        ("K = np.transpose(A).T\n    K[0, 1] = 0", "refused"),
        ("K = 1*A\n    K[0, 1] = 0", "right"),
        ("b = np.flip(b)", "refused"),
        ("b = friction(b)", "refused"),
        ("A, b = constrain(A, b)", "refused"),
        ("for i in range(2):\n        b[i] = 0", "refused"),
        ("if v > 0:\n        b = 0*b", "refused"),
    ] {
        assert_eq!(judged(line, ""), expected, "{line}");
    }
    // Indices that no array has, and brackets nested so deeply that a search from each would take minutes.
    let nested = format!("K = {}b{}", "(".repeat(200_000), ")".repeat(200_000));
    for line in ["C[] = 1\n    K = C", "C[1, 2, 3] = 1\n    K = C", "C[18446744073709551615] = 1\n    K = C", &nested] {
        assert_ne!(judged(line, ""), "wrong", "{}", &line[..12]);
    }
    for (line, expected) in [
        ("a = a + 0", "right"),
        ("a = -a", "wrong"),
        ("a *= 2", "wrong"),
        ("a[0] += 1", "wrong"),
        ("a = a - 0.1*np.array([v, omega])", "wrong"),
        ("a = np.abs(a)", "refused"),
    ] {
        assert_eq!(judged("", line), expected, "{line}");
    }
}
