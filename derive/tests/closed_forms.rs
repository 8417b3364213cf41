//! Systems of equations in closed form: solutions are found, they solve the equations, and none is missed.

use expect_test::expect;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;
use tripos_derive::algebra::solve::closed::{
    Branch, Relation, RelationCondition, RelationKind, Solutions, solve_in_closed_form,
};
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr};

/// A system with its solutions; a, b, c, d are positive, k is anything.
struct Case {
    arena: Arena,
    equations: Vec<Expr>,
    unknowns: Vec<Expr>,
    found: Solutions,
}

fn case(equations: &[&str], unknowns: &[&str], asked: usize) -> Case {
    let mut arena = Arena::new();
    for name in ["a", "b", "c", "d"] {
        let symbol = arena.symbol(name);
        arena.assume_positive(symbol);
    }
    let equations: Vec<Expr> = equations.iter().map(|e| parse_free(&mut arena, e).unwrap()).collect();
    let unknowns: Vec<Expr> = unknowns.iter().map(|name| arena.symbol(name)).collect();
    let found = solve_in_closed_form(&mut arena, &equations, &unknowns, asked, &[]);
    Case { arena, equations, unknowns, found }
}

fn told(case: &Case) -> String {
    let a = &case.arena;
    let mut out = String::new();
    for branch in &case.found.branches {
        for Relation { kind, angle, value, .. } in &branch.solved {
            let _ = write!(out, "{kind:?} {} = {}; ", print_text(a, *angle), print_text(a, *value));
        }
        for need in &branch.needs {
            let kind = if matches!(need, RelationCondition::Unit(_)) { "unit" } else { "not negative" };
            let _ = write!(out, "{kind} {}; ", print_text(a, need.term()));
        }
        branch.divided_by.iter().for_each(|e| write!(out, "not 0 {}; ", print_text(a, *e)).unwrap());
        branch.left.iter().for_each(|e| write!(out, "left {}; ", print_text(a, *e)).unwrap());
        out = out.trim_end().to_owned();
        out.push('\n');
    }
    if case.found.is_cut {
        out.push_str("cut\n");
    }
    out
}

/// Numbers in (0.3, 1.9), different for each place and turn.
fn number(place: usize, turn: usize) -> f64 {
    0.3 + 1.6 * ((place as f64 + 1.0) * 0.754_877_666 + (turn as f64 + 1.0) * 0.569_840_29).fract()
}

impl Case {
    fn at(&self, terms: &[Expr], values: &[(Expr, f64)]) -> Vec<f64> {
        let (symbols, values): (Vec<Expr>, Vec<f64>) = values.iter().copied().unzip();
        Tape::new(&self.arena, &symbols, terms).unwrap().evaluate(&values)
    }

    /// All numbers that a branch stands for at some values of its free symbols; none where a condition of the branch
    /// does not hold.
    fn numbers(&self, branch: &Branch, given: &[(Expr, f64)]) -> Vec<Vec<(Expr, f64)>> {
        let mut lists = if branch.left.is_empty() { vec![given.to_vec()] } else { Vec::new() };
        let mut seen: Vec<Expr> = Vec::new();
        // What was solved for last mentions none of the others.
        for relation in branch.solved.iter().rev() {
            // A sine and a cosine of one unknown are one angle.
            let partner = branch.solved.iter().find(|r| r.unknown == relation.unknown && r.kind != relation.kind);
            if seen.contains(&relation.unknown) {
                continue;
            }
            seen.push(relation.unknown);
            let more = |list: &Vec<(Expr, f64)>| -> Vec<Vec<(Expr, f64)>> {
                let x = self.at(&[relation.value], list)[0];
                let with = |x: f64| list.iter().copied().chain([(relation.unknown, x)]).collect::<Vec<_>>();
                let scale = |angle: f64| angle / self.at(&[relation.angle], &with(1.0))[0];
                let values = match (relation.kind, partner) {
                    (RelationKind::Sine, Some(cosine)) => vec![scale(x.atan2(self.at(&[cosine.value], list)[0]))],
                    (_, Some(sine)) => vec![scale(self.at(&[sine.value], list)[0].atan2(x))],
                    (RelationKind::Value, _) => vec![x],
                    (RelationKind::Square, _) => vec![x.sqrt(), -x.sqrt()],
                    (RelationKind::Sine, _) => vec![scale(x.asin()), scale(PI - x.asin())],
                    (RelationKind::Cosine, _) => vec![scale(x.acos()), scale(-x.acos())],
                    (RelationKind::Tangent, _) => vec![scale(x.atan()), scale(x.atan() + PI)],
                };
                values.into_iter().filter(|x| x.is_finite()).map(with).collect()
            };
            lists = lists.iter().flat_map(more).collect();
        }
        let needs: Vec<Expr> = branch.needs.iter().map(|need| need.term()).collect();
        let met = |list: &Vec<(Expr, f64)>| {
            branch.needs.iter().zip(self.at(&needs, list)).all(|(need, x)| match need {
                RelationCondition::NotNegative(_) => x >= 0.0,
                RelationCondition::Unit(_) => x.abs() <= 1.0,
            })
        };
        lists.retain(met);
        lists
    }

    fn given(&self, branch: &Branch, turn: usize) -> Vec<(Expr, f64)> {
        let parts = self.arena.reachable(&self.equations);
        let symbols = parts.into_iter().filter(|e| self.arena.symbol_name(*e).is_some());
        let free = symbols.filter(|e| !branch.solved.iter().any(|r| r.unknown == *e));
        free.enumerate().map(|(place, e)| (e, number(place, turn))).collect()
    }
}

const SYSTEMS: [(&[&str], &[&str]); 21] = [
    (&["a*sin(x)"], &["x"]),
    (&["a*b*sin(x)*cos(x)*c - sin(x)*d*k^2"], &["x"]),
    (&["a*cos(x) + b*sin(x)"], &["x"]),
    (&["a*cos(x) + b*sin(x) - k"], &["x"]),
    (&["a*cos(2*x) + b*sin(x)"], &["x"]),
    (&["cos(x)^2 - 1/4*k^2"], &["x"]),
    (&["a*x^2 + k*x - d"], &["x"]),
    (&["a*x^4 - b*x^2 - c"], &["x"]),
    (&["x^2 - 2*k*x + k^2 - a^2"], &["x"]),
    (&["a*x*y - b", "x + y - k"], &["x", "y"]),
    (&["a*sin(x) + b*sin(x + y)", "b*sin(x + y)"], &["x", "y"]),
    (&["sin(x) + sin(x + y)", "cos(x) - k*cos(y)"], &["x", "y"]),
    (&["cos(x) - cos(y)", "x*k - 1"], &["x", "y"]),
    (&["a*sqrt(x^2) - x^2"], &["x"]),
    (&["k*x*(sqrt(x^2 + y^2) - a)", "b*y*(sqrt(x^2 + y^2) - a) - c*sqrt(x^2 + y^2)"], &["x", "y"]),
    (&["b*sin(k*x)"], &["x"]),
    (&["sin(k*x) - 1/2"], &["x"]),
    (&["a^2 + b*x^2"], &["x"]),
    (&["2*cos(x) - 3"], &["x"]),
    (&["exp(x) - a*x"], &["x"]),
    (&["w*(a*w*cos(x) - b*n) + c"], &["n", "w", "x"]),
];

/// Goal: what people read of each kind of equation. Method: a snapshot.
#[test]
fn equations_of_each_kind_are_solved() {
    let mut out = String::new();
    for (equations, unknowns) in SYSTEMS {
        let case = case(equations, unknowns, 0);
        let _ = write!(out, "{}\n{}", equations.join(", "), told(&case));
    }
    expect![[r"
        a*sin(x)
        Value x = 0;
        Value x = pi;
        a*b*sin(x)*cos(x)*c - sin(x)*d*k^2
        Value x = 0;
        Value x = pi;
        Cosine x = d*k^2/(a*b*c); unit d*k^2/(a*b*c);
        a*cos(x) + b*sin(x)
        Tangent x = -a/b;
        a*cos(x) + b*sin(x) - k
        Sine x = (b*k + a*sqrt(a^2 + b^2 - k^2))/(a^2 + b^2); Cosine x = (a*k - b*sqrt(a^2 + b^2 - k^2))/(a^2 + b^2); not negative a^2 + b^2 - k^2;
        Sine x = (b*k - a*sqrt(a^2 + b^2 - k^2))/(a^2 + b^2); Cosine x = (a*k + b*sqrt(a^2 + b^2 - k^2))/(a^2 + b^2); not negative a^2 + b^2 - k^2;
        a*cos(2*x) + b*sin(x)
        Sine x = (b - sqrt(8*a^2 + b^2))/(4*a); unit (b - sqrt(8*a^2 + b^2))/(4*a);
        Sine x = (b + sqrt(8*a^2 + b^2))/(4*a); unit (b + sqrt(8*a^2 + b^2))/(4*a);
        cos(x)^2 - 1/4*k^2
        Cosine x = k/2; unit k/2;
        Cosine x = -k/2; unit -k/2;
        a*x^2 + k*x - d
        Value x = (sqrt(4*a*d + k^2) - k)/(2*a);
        Value x = -(k + sqrt(4*a*d + k^2))/(2*a);
        a*x^4 - b*x^2 - c
        Square x = (b + sqrt(b^2 + 4*a*c))/(2*a);
        Square x = (b - sqrt(b^2 + 4*a*c))/(2*a); not negative b - sqrt(b^2 + 4*a*c);
        x^2 - 2*k*x + k^2 - a^2
        Value x = k - a;
        Value x = a + k;
        a*x*y - b, x + y - k
        Value x = (a*k - sqrt(a*(a*k^2 - 4*b)))/(2*a); Value y = (a*k + sqrt(a*(a*k^2 - 4*b)))/(2*a); not negative a*k^2 - 4*b;
        Value x = (a*k + sqrt(a*(a*k^2 - 4*b)))/(2*a); Value y = (a*k - sqrt(a*(a*k^2 - 4*b)))/(2*a); not negative a*k^2 - 4*b;
        a*sin(x) + b*sin(x + y), b*sin(x + y)
        Value x = 0; Value y = 0;
        Value x = 0; Value y = pi;
        Value x = pi; Value y = 0;
        Value x = pi; Value y = pi;
        sin(x) + sin(x + y), cos(x) - k*cos(y)
        Value y = -2*x; Cosine x = (1 + sqrt(1 + 8*k^2))/(4*k); unit (1 + sqrt(1 + 8*k^2))/(4*k); not 0 k;
        Value y = -2*x; Cosine x = (1 - sqrt(1 + 8*k^2))/(4*k); unit (1 - sqrt(1 + 8*k^2))/(4*k); not 0 k;
        Value y = -pi; Cosine x = -k; unit -k;
        cos(x) - cos(y), x*k - 1
        Value x = 1/k; Cosine y = cos(1/k); unit cos(1/k); not 0 k;
        a*sqrt(x^2) - x^2
        Value x = 0;
        Square x = a^2;
        k*x*(sqrt(x^2 + y^2) - a), b*y*(sqrt(x^2 + y^2) - a) - c*sqrt(x^2 + y^2)
        Value x = 0; Value y = 0; not 0 k;
        Value x = 0; Value y = (c - a*b)/b; not negative a*b - c; not 0 k;
        Value x = 0; Value y = (a*b + c)/b; not 0 k;
        b*sin(k*x)
        Value x = 0; not 0 k;
        Value x = pi/k; not 0 k;
        sin(k*x) - 1/2
        Sine k*x = 1/2;
        a^2 + b*x^2
        2*cos(x) - 3
        exp(x) - a*x
        left a*x - exp(x);
        w*(a*w*cos(x) - b*n) + c
        Value n = (c + a*w^2*cos(x))/(b*w); not 0 w;
    "]]
    .assert_eq(&out);
}

/// Goal: no branch is wrong. Method: all numbers that each stands for, put into the equations as they were given.
#[test]
fn every_branch_solves_its_equations() {
    let mut tried = 0;
    for asked in 0..2 {
        for (equations, unknowns) in SYSTEMS {
            let case = case(equations, unknowns, asked);
            for (branch, turn) in case.found.branches.iter().flat_map(|b| (0..20).map(move |turn| (b, turn))) {
                let given = case.given(branch, turn);
                for values in case.numbers(branch, &given) {
                    tried += 1;
                    for x in case.at(&case.equations, &values) {
                        assert!(x.abs() < 1e-11, "{equations:?}: {x:e} left at {values:?}\n{}", told(&case));
                    }
                }
            }
        }
    }
    assert!(tried > 600, "{tried}");
}

/// Goal: no solution is missed. Method: each equation with one unknown changes its sign, on a fine grid, only at
/// values of its branches.
#[test]
fn no_root_of_one_unknown_is_missed() {
    let mut roots = 0;
    for (equations, unknowns) in SYSTEMS.into_iter().filter(|(_, unknowns)| unknowns.len() == 1) {
        let case = case(equations, unknowns, 0);
        if case.found.branches.iter().any(|branch| !branch.left.is_empty()) {
            continue;
        }
        let x = case.unknowns[0];
        for turn in 0..20 {
            let given: Vec<(Expr, f64)> =
                case.given(&Branch::default(), turn).into_iter().filter(|(e, _)| *e != x).collect();
            let known: Vec<f64> = case
                .found
                .branches
                .iter()
                .flat_map(|branch| case.numbers(branch, &given))
                .map(|values| values.iter().find(|(e, _)| *e == x).unwrap().1)
                .collect();
            let value = |at: f64| case.at(&case.equations, &[&given[..], &[(x, at)]].concat())[0];
            let period = if equations[0].contains("k*x)") { TAU / number_of(&case, &given, "k") } else { TAU };
            let is_angle = equations[0].contains("sin") || equations[0].contains("cos");
            let cells: usize = 4000;
            for cell in 0..cells {
                let place = |k: usize| -3.0 + 6.0 * (k as f64 + 0.37) / (cells as f64);
                let (mut low, mut high) = (place(cell), place(cell + 1));
                if (value(low) > 0.0) == (value(high) > 0.0) {
                    continue;
                }
                for _ in 0..60 {
                    let middle = f64::midpoint(low, high);
                    if (value(middle) > 0.0) == (value(low) > 0.0) { low = middle } else { high = middle }
                }
                roots += 1;
                let off = |known: &f64| {
                    let by = known - low;
                    (if is_angle { by - period * (by / period).round() } else { by }).abs()
                };
                assert!(known.iter().any(|known| off(known) < 1e-6), "{equations:?}: {low} is none of {known:?}");
            }
        }
    }
    assert!(roots > 200, "{roots}");
}

fn number_of(case: &Case, given: &[(Expr, f64)], name: &str) -> f64 {
    given.iter().find(|(e, _)| case.arena.symbol_name(*e) == Some(name)).map_or(1.0, |(_, x)| *x)
}

/// Goal: a requested unknown is solved for, at whatever cost; two roots have their discriminant. Method: a quadratic
/// that is linear in another.
#[test]
fn what_is_asked_for_is_solved_for() {
    let equations = ["w*(a*w*cos(x) - b*n) + c"];
    expect![[r"
        Value w = (b*n + sqrt(b^2*n^2 - 4*a*c*cos(x)))/(2*a*cos(x)); not negative b^2*n^2 - 4*a*c*cos(x); not 0 cos(x);
        Value w = (b*n - sqrt(b^2*n^2 - 4*a*c*cos(x)))/(2*a*cos(x)); not negative b^2*n^2 - 4*a*c*cos(x); not 0 cos(x);
        Value x = pi/2; Value w = c/(b*n); not 0 n;
        Value x = -pi/2; Value w = c/(b*n); not 0 n;
    "]]
    .assert_eq(&told(&case(&equations, &["w", "n", "x"], 1)));
    expect![[r"
        Cosine x = (b*w*n - c)/(a*w^2); unit (b*w*n - c)/(a*w^2); not 0 w;
    "]]
    .assert_eq(&told(&case(&equations, &["x", "n", "w"], 1)));
}
