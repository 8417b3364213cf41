//! Modes of contacts with friction, against closed forms and against an elimination of all modes here.

use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use tripos_sim::{ClosedContacts, ContactMode, UndecidedContacts};

/// One contact with friction, of this compliance.
fn one(g: [f64; 3], mu: f64) -> ClosedContacts {
    let compliance = DMatrix::from_row_slice(2, 2, &[g[0], g[1], g[1], g[2]]);
    ClosedContacts { compliance, rows: vec![vec![0, 1]], friction: vec![Some(mu)] }
}

fn modes(
    closed: &ClosedContacts,
    c: [f64; 2],
    slips: Option<f64>,
) -> Result<(ContactMode, [f64; 2]), UndecidedContacts> {
    let found = closed.contact_modes(&DVector::from_column_slice(&c), &[slips])?;
    Ok((found[0].modes[0], [found[0].forces[0], found[0].forces[1]]))
}

/// Goal: a point mass m on a plane. Truth: N = m g. The mass sticks while the pull is at most μ N, else it slips along
/// the pull. While it slips, friction is against the slip.
#[test]
fn a_mass_on_a_plane_sticks_slips_and_opens() {
    let mass = one([0.5, 0.0, 0.5], 0.3);
    let g = 10.0;
    assert_eq!(modes(&mass, [-g, 2.0], None).unwrap(), (ContactMode::Sticks, [20.0, -4.0]));
    let (mode, [normal, along]) = modes(&mass, [-g, -4.0], None).unwrap();
    assert!(mode == ContactMode::Slips(-1.0) && (normal - 20.0).abs() < 1e-13 && (along - 6.0).abs() < 1e-13);
    let (mode, [_, along]) = modes(&mass, [-g, 4.0], Some(-1.0)).unwrap();
    assert!(mode == ContactMode::Slips(-1.0) && (along - 6.0).abs() < 1e-13);
    assert_eq!(modes(&mass, [1.0, 4.0], Some(1.0)).unwrap().0, ContactMode::Opens);
    // At the limit both agree and move alike; the firmest is told first.
    let found = mass.contact_modes(&DVector::from_vec(vec![-g, 3.0]), &[None]).unwrap();
    assert_eq!(
        found.iter().map(|found| found.modes[0]).collect::<Vec<_>>(),
        [ContactMode::Sticks, ContactMode::Slips(1.0)]
    );
}

/// Goal: Painlevé's cases are told apart. Truth: the rod slides forwards with G_nn − μ G_nt = 1 − 2·0.8 < 0. With c_n <
/// 0 no force keeps the contact from closing; with c_n > 0 it may open or press.
#[test]
fn sliding_without_a_force_and_with_two_is_undecided() {
    let rod = one([1.0, 0.8, 1.0], 2.0);
    assert_eq!(modes(&rod, [-1.0, 0.0], Some(1.0)), Err(UndecidedContacts::Nothing));
    let several = UndecidedContacts::Several([vec![ContactMode::Opens], vec![ContactMode::Slips(1.0)]]);
    assert_eq!(modes(&rod, [1.0, 0.0], Some(1.0)), Err(several));
    assert!(
        rod.contact_force_determinant(&[ContactMode::Slips(1.0)]) < 0.0
            && rod.contact_force_determinant(&[ContactMode::Slips(-1.0)]) > 0.0
    );
    assert_eq!(modes(&rod, [-1.0, 0.0], Some(-1.0)).unwrap().0, ContactMode::Slips(-1.0));
}

/// Goal: units of rows change nothing. Method: the rows of one contact in other units, with the coefficient of friction
/// in these.
#[test]
fn rows_in_other_units_have_the_same_forces() {
    let (a, b) = (one([0.7, 0.2, 0.9], 0.4), one([0.7e6, 0.2, 0.9e-6], 0.4e6));
    for c in [[-1.0, 0.3], [-1.0, 3.0], [-1.0, -3.0]] {
        let (mode, forces) = modes(&a, c, None).unwrap();
        let (other, scaled) = modes(&b, [1e3 * c[0], 1e-3 * c[1]], None).unwrap();
        assert_eq!(mode, other);
        assert!((forces[0] - 1e3 * scaled[0]).abs() < 1e-12 && (forces[1] - 1e-3 * scaled[1]).abs() < 1e-12);
    }
}

/// Goal: a block lies on two points whose slips are one velocity. It sticks as long as both together can bear the pull,
/// even if one alone could not bear half. Truth: N of 1 and 3, μ = ½, so that 2 can be borne: each point bears the same
/// part of its own limit.
#[test]
fn contacts_that_share_a_slip_share_what_friction_bears() {
    // Unit mass and inertia, points at ∓1 at the height of the centre: normal rows (1, ∓1), slips (1, 0) both.
    let (normal, along) = ([2.0, 0.0, 0.0, 2.0], 1.0);
    let compliance = DMatrix::from_fn(4, 4, |i, j| match (i % 2, j % 2) {
        (0, 0) => normal[i + j / 2],
        (1, 1) => along,
        _ => 0.0,
    });
    let block = ClosedContacts { compliance, rows: vec![vec![0, 1], vec![2, 3]], friction: vec![Some(0.5); 2] };
    let pulled = |pull: f64| {
        let c = DVector::from_vec(vec![-2.0, pull, -6.0, pull]);
        block.contact_modes(&c, &[None, None]).unwrap().swap_remove(0)
    };
    let holds = pulled(1.9);
    assert_eq!(holds.modes, [ContactMode::Sticks, ContactMode::Sticks]);
    assert!((holds.forces[1] + 1.9 / 4.0).abs() < 1e-12 && (holds.forces[3] + 5.7 / 4.0).abs() < 1e-12, "{holds:?}");
    assert_eq!(pulled(2.1).modes, [ContactMode::Slips(1.0), ContactMode::Slips(1.0)]);
}

/// Goal: impacts of a ball with spin. Truth: with G = diag(1/m, 1/m + R²/I) it sticks if |vt|/(1/m + R²/I) ≤ μ (1 + e)
/// m vn, else slips on, by both laws alike.
#[test]
fn a_ball_with_spin_sticks_or_slips_by_both_laws() {
    let (m, tangential) = (2.0, 0.5 * 3.5);
    for (vt, mu, e) in [(3.0, 0.4, 0.5), (-3.0, 0.4, 0.5), (30.0, 0.4, 0.5), (-30.0, 0.2, 1.0)] {
        let ball = one([1.0 / m, 0.0, tangential], mu);
        let before = DVector::from_vec(vec![-4.0, vt]);
        let normal = (1.0 + e) * m * 4.0;
        let along = -(vt / tangential).clamp(-mu * normal, mu * normal);
        for impulses in [ball.newton_impact(&before, &[e]).unwrap(), ball.poisson_impact(&before, &[e]).unwrap()] {
            assert!((impulses[0] - normal).abs() < 1e-12 && (impulses[1] - along).abs() < 1e-12, "{impulses}");
        }
    }
}

/// Goal: by Poisson's law the impulse of friction in compression comes back along the gap. Truth: sticking in
/// compression G Λ = −v; expansion with e Λn and no slip: Λt = −G_nt e Λn/G_tt.
#[test]
fn poissons_expansion_has_its_own_friction() {
    let (g, e) = ([1.0, 0.3, 0.8], 0.6);
    let rod = one(g, 5.0);
    let v = [-2.0, 0.1];
    let det = g[0] * g[2] - g[1] * g[1];
    let compression = [-(g[2] * v[0] - g[1] * v[1]) / det, -(g[0] * v[1] - g[1] * v[0]) / det];
    let back = e * compression[0];
    let impulses = rod.poisson_impact(&DVector::from_column_slice(&v), &[e]).unwrap();
    assert!((impulses[0] - compression[0] - back).abs() < 1e-13, "{impulses}");
    assert!((impulses[1] - compression[1] + g[1] * back / g[2]).abs() < 1e-13, "{impulses}");
}

/// Forces of two contacts in these modes by elimination, if they agree with the laws by a margin. `None` if they miss a
/// law by a margin; an error if that is too close to call.
fn tried(
    g: &DMatrix<f64>,
    c: &DVector<f64>,
    mu: [f64; 2],
    modes: [ContactMode; 2],
) -> Result<Option<DVector<f64>>, ()> {
    const CLOSE: f64 = 1e-6;
    let (mut a, mut b) = (DMatrix::<f64>::identity(4, 4), DVector::zeros(4));
    for (at, mode) in modes.into_iter().enumerate() {
        let (n, t) = (2 * at, 2 * at + 1);
        if mode != ContactMode::Opens {
            a.set_row(n, &g.row(n));
            b[n] = -c[n];
        }
        match mode {
            ContactMode::Sticks => {
                a.set_row(t, &g.row(t));
                b[t] = -c[t];
            }
            ContactMode::Slips(way) => a[(t, n)] = mu[at] * way,
            _ => {}
        }
    }
    let lu = a.clone().lu();
    if lu.determinant().abs() < CLOSE {
        return Err(());
    }
    let forces = lu.solve(&b).ok_or(())?;
    let after = g * &forces + c;
    let mut margins = Vec::new();
    for (at, mode) in modes.into_iter().enumerate() {
        let (n, t) = (2 * at, 2 * at + 1);
        match mode {
            ContactMode::Opens => margins.push(after[n]),
            ContactMode::Sticks => margins.extend([forces[n], mu[at] * forces[n] - forces[t].abs()]),
            ContactMode::Slips(way) => margins.extend([forces[n], way * after[t]]),
            ContactMode::Pushes => return Err(()),
        }
    }
    let least = margins.iter().copied().fold(f64::INFINITY, f64::min);
    if least.abs() < CLOSE { Err(()) } else { Ok((least > 0.0).then_some(forces)) }
}

proptest! {
    /// Goal: all modes of two contacts with friction are found, none is chosen where several move differently, and
    /// impacts without restitution take energy. Method: sixteen eliminations of 4 × 4 systems.
    #[test]
    fn two_contacts_do_what_elimination_of_all_modes_has(
        w in prop::array::uniform20(-1.0..1.0_f64),
        u in prop::array::uniform5(-1.0..1.0_f64),
        mu in prop::array::uniform2(0.0..1.5_f64),
    ) {
        let of_u = DMatrix::from_row_slice(4, 5, &w);
        let g = &of_u * of_u.transpose();
        let c = &of_u * DVector::from_column_slice(&u);
        prop_assume!(g.determinant() > 1e-4 && c.amax() > 1e-2);
        let all = [ContactMode::Opens, ContactMode::Sticks, ContactMode::Slips(1.0), ContactMode::Slips(-1.0)];
        let mut found = Vec::new();
        for modes in all.iter().flat_map(|a| all.iter().map(|b| [*a, *b])) {
            match tried(&g, &c, mu, modes) {
                Ok(Some(forces)) => found.push((modes, forces)),
                Ok(None) => {}
                Err(()) => return Err(TestCaseError::reject("too close to call")),
            }
        }
        let closed = ClosedContacts { compliance: g.clone(), rows: vec![vec![0, 1], vec![2, 3]], friction: mu.map(Some).to_vec() };
        match closed.contact_modes(&c, &[None, None]) {
            Ok(ways) => {
                prop_assert!(found.len() == 1 && ways.len() == 1, "{found:?} {ways:?}");
                prop_assert_eq!(&ways[0].modes[..], &found[0].0[..]);
                let forces = &ways[0].forces;
                prop_assert!((forces - &found[0].1).amax() < 1e-7 * forces.amax().max(1.0));
                // As impulses on velocities c they take energy: ½ Λ (2 c + G Λ).
                let gained = 0.5 * forces.dot(&(2.0 * &c + &g * forces));
                prop_assert!(gained <= 1e-9, "{gained}");
                prop_assert_eq!(closed.contact_impulses(&c).unwrap(), forces.clone());
            }
            Err(UndecidedContacts::Nothing) => prop_assert!(found.is_empty(), "{found:?}"),
            Err(UndecidedContacts::Several(pair)) => {
                prop_assert!(found.len() > 1, "{found:?}");
                for modes in pair {
                    prop_assert!(found.iter().any(|(own, _)| own[..] == modes[..]), "{modes:?} {found:?}");
                }
            }
        }
    }
}
