//! Singularity of a mass matrix: zeros of its determinant, above all at the zeros of the divisors
//! of the kinematic equations.
//!
//! A statement is made only if it is proved for every real state with positive parameters. The
//! proof uses the range of the determinant, or its value with the divisor set to zero. All other
//! cases are left open.

use crate::algebra::solve::linear::determinant;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::value::range::range_excludes_zero;
use crate::algebra::{Arena, Expr, Function, Node};
use crate::mechanics::Kinematics;
use crate::model::Model;

/// Largest number of rows of a matrix whose determinant is expanded.
const MOST_ROWS: usize = 8;

/// Determinant of a matrix, with statements that are proved about its zeros.
#[derive(Clone, Debug)]
pub struct Singularity {
    /// Determinant of the examined matrix, simplified.
    pub determinant: Expr,
    /// True if the determinant is proved never to be zero; false if this is open.
    pub never: bool,
    /// Behaviour of the matrix where a divisor of the kinematic equations is zero, for each divisor.
    pub at: Vec<Place>,
}

/// Behaviour of a matrix where a divisor of the kinematic equations is zero.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// Divisor of the kinematic equations, as a term in q.
    pub divisor: Expr,
    /// Statement about the determinant where the divisor is zero.
    pub determinant: DeterminantAtZero,
    /// True if entries of the matrix divide by zero where the divisor is zero. Near there, the entries
    /// are large, and the matrix is ill-conditioned even if its determinant is far from zero.
    pub entries_divide: bool,
}

/// Statement about a determinant at the zeros of a divisor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DeterminantAtZero {
    /// Determinant is proved to be zero wherever the divisor is zero.
    Zero,
    /// Determinant is proved not to be zero wherever the divisor is zero.
    NotZero,
    /// Undecided: the determinant is neither proved to be zero nor proved to be nonzero there.
    Open,
}

/// Determinant of a matrix, with statements that are proved about its zeros. `None` if the matrix
/// has more than 8 rows.
pub fn singularity(model: &Model, kinematics: &mut Kinematics, matrix: &[Vec<Expr>]) -> Option<Singularity> {
    if matrix.len() > MOST_ROWS {
        return None;
    }
    let determinant = determinant(&mut kinematics.arena, &mut kinematics.simplifier, matrix);
    Some(singularity_of_determinant(model, kinematics, matrix, determinant))
}

/// Proves statements about the zeros of the given determinant of a matrix.
pub fn singularity_of_determinant(
    model: &Model,
    kinematics: &mut Kinematics,
    matrix: &[Vec<Expr>],
    determinant: Expr,
) -> Singularity {
    let divisors = &model.kinematic_equations.divisors;
    let at = divisors.iter().map(|divisor| singularity_place(kinematics, matrix, determinant, *divisor)).collect();
    Singularity { determinant, never: range_excludes_zero(&kinematics.arena, determinant), at }
}

/// Examines a matrix and its determinant where a divisor of the kinematic equations is zero.
fn singularity_place(kinematics: &mut Kinematics, matrix: &[Vec<Expr>], determinant: Expr, divisor: Expr) -> Place {
    let Kinematics { arena, simplifier, .. } = kinematics;
    let mut place = Place { divisor, determinant: DeterminantAtZero::Open, entries_divide: false };
    let Some(roots) = divisor_zeros(arena, divisor) else { return place };
    let (mut zero, mut nonzero) = (true, true);
    for root in roots {
        let mut put = Substitution::new(&root);
        for entry in matrix.iter().flatten() {
            put.apply(arena, *entry);
        }
        place.entries_divide |= put.undefined.is_some();
        let mut put = Substitution::new(&root);
        let value = put.apply(arena, determinant);
        let value = simplifier.simplify(arena, value);
        zero &= put.undefined.is_none() && value == Expr::ZERO;
        nonzero &= put.undefined.is_none() && range_excludes_zero(arena, value);
    }
    place.determinant = match (zero, nonzero) {
        (true, _) => DeterminantAtZero::Zero,
        (_, true) => DeterminantAtZero::NotZero,
        _ => DeterminantAtZero::Open,
    };
    place
}

/// All zeros of a divisor, each as a list of substitutions (term, value). `None` unless every
/// factor that may be zero is a sine, a cosine or a symbol.
fn divisor_zeros(arena: &mut Arena, divisor: Expr) -> Option<Vec<Vec<(Expr, Expr)>>> {
    let (_, divisor) = arena.split_content(divisor);
    let factors: Vec<Expr> = match arena.node(divisor) {
        Node::Product(factors) if factors.iter().all(|(_, n)| *n > 0) => {
            factors.iter().map(|(base, _)| *base).collect()
        }
        _ => vec![divisor],
    };
    let mut roots = Vec::new();
    for factor in factors.into_iter().filter(|factor| !range_excludes_zero(arena, *factor)).collect::<Vec<_>>() {
        match *arena.node(factor) {
            Node::Symbol(_) => roots.push(vec![(factor, Expr::ZERO)]),
            Node::Apply(f @ (Function::Sin | Function::Cos), angle) => {
                let other = arena.apply(if f == Function::Sin { Function::Cos } else { Function::Sin }, angle);
                for sign in [Expr::ONE, Expr::MINUS_ONE] {
                    roots.push(vec![(factor, Expr::ZERO), (other, sign)]);
                }
            }
            _ => return None,
        }
    }
    (!roots.is_empty()).then_some(roots)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::print::print_text;
    use crate::diagnostic::Source;
    use crate::mechanics::{Formulation, derive_all};

    /// A ball on an arm with the heading q1 and the elevation q2. Its speeds are body components,
    /// which do not determine q1' where cos q2 = 0.
    const GIMBAL: &str = r#"
name = "Gimbal"
[parameters]
m = { unit = "kg", positive = true }
l = { unit = "m", positive = true }
[coordinates]
q1 = { unit = "rad" }
q2 = { unit = "rad" }
[speeds]
u1 = "q1'*cos(q2)"
u2 = "q2'"
[inertial]
frame = "A"
origin = "O"
[frames]
H = { from = "A", axis = 3, angle = "q1" }
B = { from = "H", axis = 2, angle = "-q2" }
[points]
P = { from = "O", frame = "B", position = ["l", 0, 0] }
[particles.ball]
point = "P"
mass = "m"
"#;

    #[test]
    fn a_singular_matrix_is_told_from_singular_kinematic_equations() {
        let model = crate::model::load(&Source::from_text("gimbal.toml", GIMBAL)).unwrap();
        let mut derivations = derive_all(&model).unwrap();
        let [kane, lagrange] = [Formulation::Kane, Formulation::Lagrange].map(|f| {
            let matrix = derivations.get(f).unwrap().matrix.clone();
            singularity(&model, &mut derivations.kinematics, &matrix).unwrap()
        });
        let arena = &derivations.kinematics.arena;
        assert_eq!(print_text(arena, kane.determinant), "m^2*l^4");
        assert_eq!((kane.never, kane.at[0].determinant), (true, DeterminantAtZero::NotZero));
        assert_eq!(print_text(arena, lagrange.determinant), "m^2*l^4*cos(q2)^2");
        assert_eq!((lagrange.never, lagrange.at[0].determinant), (false, DeterminantAtZero::Zero));
        assert_eq!(print_text(arena, lagrange.at[0].divisor), "cos(q2)");
    }

    #[test]
    fn nothing_is_said_of_divisors_whose_zeros_are_not_known() {
        let mut arena = Arena::new();
        let e = crate::algebra::text::parse::parse_free(&mut arena, "cos(q) - 1/2").unwrap();
        assert_eq!(divisor_zeros(&mut arena, e), None);
    }
}
