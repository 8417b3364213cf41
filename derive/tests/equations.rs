//! The equations as people read them: short, and the same on every run.

use expect_test::{Expect, expect};
use std::fmt::Write;
use std::path::Path;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::{Formulation, Model, derive};

/// The entries that are not zero, upper triangle where symmetric.
#[allow(clippy::needless_pass_by_value, reason = "as expect! is used everywhere")]
fn check(model: &str, formulation: Formulation, expected: Expect) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(model).join("model.toml");
    let model = Model::read(&path).unwrap();
    let derivation = derive(&model, formulation).unwrap();
    let e = &derivation.equations;
    let mut out = String::new();
    for (i, row) in e.matrix.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            if *entry != Expr::ZERO && !(e.symmetric && j < i) {
                let _ = writeln!(out, "M{}{} = {}", i + 1, j + 1, print_text(&derivation.arena, *entry));
            }
        }
    }
    for (i, entry) in e.forcing.iter().enumerate() {
        let _ = writeln!(out, "f{} = {}", i + 1, print_text(&derivation.arena, *entry));
    }
    expected.assert_eq(&out);
}

#[test]
fn disk_by_kane() {
    check(
        "disk",
        Formulation::Kane,
        expect![[r"
            M11 = 5*M*R^2/4
            M14 = M*R*sin(q1)*cos(q2)
            M15 = -M*R*cos(q1)*cos(q2)
            M22 = M*R^2*(1 + 4*tan(q2)^2)/4
            M24 = -M*R*cos(q1)*tan(q2)
            M25 = -M*R*sin(q1)*tan(q2)
            M33 = M*R^2/2
            M44 = M
            M55 = M
            f1 = -M*R*(4*g*sin(q2) + R*u2*(3*u2*tan(q2) + 2*u3))/4
            f2 = M*R^2*u1*(u2*tan(q2)*(7 + 4*tan(q2)^2) + 2*u3)/4
            f3 = 0
            f4 = -M*R*(u2^2*sin(q1)*tan(q2)/cos(q2) + u1*(u1*sin(q1)*sin(q2) + u2*cos(q1)*(1 + 1/cos(q2)^2)))
            f5 = M*R*(u2^2*cos(q1)*tan(q2)/cos(q2) - u1*(u2*sin(q1)*(1 + 1/cos(q2)^2) - u1*cos(q1)*sin(q2)))
        "]],
    );
}

#[test]
fn disk_by_lagrange() {
    check(
        "disk",
        Formulation::Lagrange,
        expect![[r"
            M11 = M*R^2*(6 - 5*cos(q2)^2)/4
            M13 = M*R^2*sin(q2)/2
            M14 = -M*R*cos(q1)*sin(q2)
            M15 = -M*R*sin(q1)*sin(q2)
            M22 = 5*M*R^2/4
            M24 = -M*R*sin(q1)*cos(q2)
            M25 = M*R*cos(q1)*cos(q2)
            M33 = M*R^2/2
            M44 = M
            M55 = M
            f1 = -M*R^2*q2'*cos(q2)*(5*q1'*sin(q2) + q3')/2
            f2 = M*R*(4*g*sin(q2) + R*q1'*cos(q2)*(5*q1'*sin(q2) + 2*q3'))/4
            f3 = -M*R^2*q1'*q2'*cos(q2)/2
            f4 = -M*R*(q2'^2*sin(q1)*sin(q2) + q1'*(q1'*sin(q1)*sin(q2) - 2*q2'*cos(q1)*cos(q2)))
            f5 = M*R*(q2'^2*cos(q1)*sin(q2) + q1'*(q1'*cos(q1)*sin(q2) + 2*q2'*sin(q1)*cos(q2)))
        "]],
    );
}

#[test]
fn disk_by_newton_euler() {
    check(
        "disk",
        Formulation::NewtonEuler,
        expect![[r"
            M12 = -M*R*tan(q2)
            M14 = M*cos(q1)
            M15 = M*sin(q1)
            M24 = -M*sin(q1)*sin(q2)
            M25 = M*cos(q1)*sin(q2)
            M26 = -cos(q2)
            M31 = M*R
            M34 = M*sin(q1)*cos(q2)
            M35 = -M*cos(q1)*cos(q2)
            M36 = -sin(q2)
            M41 = M*R^2/4
            M46 = R*sin(q2)
            M52 = M*R^2/4
            M63 = M*R^2/2
            f1 = -M*R*u1*u2*(2 + tan(q2)^2)
            f2 = M*(R*(u1^2 + u2^2*tan(q2)^2) - g*cos(q2))
            f3 = -M*sin(q2)*(g + R*u2^2/cos(q2))
            f4 = M*R^2*u2*(u2*tan(q2) - 2*u3)/4
            f5 = M*R^2*u1*(2*u3 - u2*tan(q2))/4
            f6 = 0
        "]],
    );
}

#[test]
fn disk_by_gibbs_appell() {
    check(
        "disk",
        Formulation::GibbsAppell,
        expect![[r"
        M11 = 5*M*R^2/4
        M14 = M*R*sin(q1)*cos(q2)
        M15 = -M*R*cos(q1)*cos(q2)
        M22 = M*R^2*(1 + 4*tan(q2)^2)/4
        M24 = -M*R*cos(q1)*tan(q2)
        M25 = -M*R*sin(q1)*tan(q2)
        M33 = M*R^2/2
        M44 = M
        M55 = M
        f1 = -M*R*(4*g*sin(q2) + R*u2*(3*u2*tan(q2) + 2*u3))/4
        f2 = M*R^2*u1*(u2*tan(q2)*(7 + 4*tan(q2)^2) + 2*u3)/4
        f3 = 0
        f4 = -M*R*(u2^2*sin(q1)*tan(q2)/cos(q2) + u1*(u1*sin(q1)*sin(q2) + u2*cos(q1)*(1 + 1/cos(q2)^2)))
        f5 = M*R*(u2^2*cos(q1)*tan(q2)/cos(q2) - u1*(u2*sin(q1)*(1 + 1/cos(q2)^2) - u1*cos(q1)*sin(q2)))
    "]],
    );
}

#[test]
fn chaotic_pendulum_by_lagrange() {
    check(
        "chaotic_pendulum",
        Formulation::Lagrange,
        expect![[r"
            M11 = mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2
            M22 = IBzz
            f1 = 2*theta'*phi'*sin(phi)*cos(phi)*(IByy - IBxx) - g*sin(theta)*(mA*lA + mB*lB)
            f2 = theta'^2*sin(phi)*cos(phi)*(IBxx - IByy)
        "]],
    );
}

#[test]
fn heavy_top_by_kane() {
    check(
        "heavy_top",
        Formulation::Kane,
        expect![[r"
            M11 = I1
            M22 = I1
            M33 = I3
            f1 = m*l*g*sin(q1) + u2*(I1*u1*tan(q2) - I3*u3)
            f2 = m*l*g*cos(q1)*sin(q2) + u1*(I3*u3 - I1*u1*tan(q2))
            f3 = 0
        "]],
    );
}
