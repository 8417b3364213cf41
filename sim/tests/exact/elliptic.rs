//! Elliptic functions: against tabulated values, identities, and known limits.

use super::{Dd, assert_close, dd};
use tripos_sim::exact::Elliptic;
use tripos_traits::{Real, Scalar};

/// Functions of m, with 1 − m rounded from its own decimals where m is next to 1 and its rounding counts.
fn elliptic(m: &str) -> Elliptic<Dd> {
    match m {
        "0.999999" => Elliptic::with_complement(dd(m), dd("1e-6")),
        "0.9999999999999999999999" => Elliptic::with_complement(dd(m), dd("1e-22")),
        _ => Elliptic::new(dd(m)),
    }
}

/// (m, K). mpmath 1.3 at 60 digits: `ellipk(mpf(m))`.
const COMPLETE: [(&str, &str); 6] = [
    ("0", "1.570796326794896619231321691639751"),
    ("0.1", "1.612441348720219398229916363085374"),
    ("0.5", "1.85407467730137191843385034719526"),
    ("0.9", "2.578092113348173188202570771816506"),
    ("0.999999", "8.294051463615439985315519278799438"),
    ("0.9999999999999999999999", "26.71473038405439314303301311270396"),
];

/// (u, m, [sn, cn, dn]). mpmath 1.3 at 60 digits: `ellipfun('sn', mpf(u), m=mpf(m))` and so on.
const JACOBI: [(&str, &str, [&str; 3]); 8] = [
    (
        "0.3",
        "0.1",
        [
            "0.2950981243043688437144878149158265",
            "0.9554669523495008219901360286918044",
            "0.9956363340613902723592891126835569",
        ],
    ),
    (
        "-1.1",
        "0.5",
        [
            "-0.8486654795097635587773481689753615",
            "0.5289299612316011439872436606970322",
            "0.7999271541485709213475921085109245",
        ],
    ),
    (
        "5.7",
        "0.9",
        [
            "-0.4980162186920401858179403993835384",
            "-0.8671677149892528162391453023325957",
            "0.8813522912704736385683792976494495",
        ],
    ),
    (
        "1000",
        "0.7",
        [
            "0.3156315169623128071146727645630704",
            "-0.9488818395880855104955117560019009",
            "0.9645017998169046806714597609833391",
        ],
    ),
    (
        "-31.25",
        "0.03",
        [
            "0.3942798418125034678509578238100113",
            "0.9189904277740368510434203592731869",
            "0.9976654259771705736461496386395213",
        ],
    ),
    (
        "2.5",
        "0.999999",
        [
            "0.9866145281838537016724858725827494",
            "0.1630698401806776462779643525344246",
            "0.16307282478935284949154128513227",
        ],
    ),
    (
        "14",
        "0.999999",
        [
            "0.9887649046993529342525565861288084",
            "-0.1494789725509227258088675317596804",
            "0.1494822427277443373678095131004429",
        ],
    ),
    (
        "20",
        "0.9999999999999999999999",
        [
            "0.9999999999999999915033164893984326",
            "4.122301180312173016042523070581843e-9",
            "4.122313309442058260799317706272815e-9",
        ],
    ),
];

/// 1e-30: some 20 roundings.
#[test]
fn complete_integrals_have_30_digits() {
    for (m, k) in COMPLETE {
        assert_close(elliptic(m).quarter_period(), dd(k), 1e-30, m);
    }
}

/// 1e-30 for arguments of a few units; that of 1000 carries 1000 EPSILON.
#[test]
fn jacobi_functions_have_30_digits() {
    for (u, m, values) in JACOBI {
        let tolerance = 1e-30 * dd(u).to_f64().abs().max(1.0);
        let got = elliptic(m).jacobi_functions(dd(u));
        for (got, wanted) in [got.sn, got.cn, got.dn].into_iter().zip(values) {
            assert_close(got, dd(wanted), tolerance, &format!("u = {u}, m = {m}"));
        }
    }
}

#[test]
fn f64_follows_to_its_own_rounding() {
    for (u, m, values) in JACOBI {
        let (u, m): (f64, f64) = (u.parse().unwrap(), m.parse().unwrap());
        // Next to m = 1 rounding of 1 − m counts, and next to K it is enlarged.
        if m > 0.999 {
            continue;
        }
        let got = Elliptic::new(m).jacobi_functions(u);
        for (got, wanted) in [got.sn, got.cn, got.dn].into_iter().zip(values) {
            assert!((got - dd(wanted).to_f64()).abs() < 8e-16 * u.abs().max(1.0), "u = {u}, m = {m}");
        }
    }
}

/// The amplitude grows by π over 2 K, is odd, and its sine and cosine are sn and cn.
#[test]
fn amplitude_counts_its_turns() {
    for m in ["0", "0.3", "0.9", "0.999999"] {
        let elliptic = Elliptic::new(dd(m));
        let half_period = elliptic.quarter_period() * Dd::int(2);
        for u in ["0.1", "-1.3", "2.9", "17"].map(dd) {
            let at = elliptic.jacobi_functions(u);
            assert_close(elliptic.jacobi_functions(u + half_period).am, at.am + Dd::pi(), 1e-29, m);
            assert_close(elliptic.jacobi_functions(-u).am, -at.am, 1e-29, m);
            let (sin, cos) = at.am.sin_cos();
            assert_close(sin, at.sn, 1e-29, m);
            assert_close(cos, at.cn, 1e-29, m);
        }
    }
}

/// F and am are inverse over several turns. Near m = 1 and odd multiples of π/2, dF/dφ = 1/dn enlarges rounding.
#[test]
fn incomplete_integral_inverts_the_amplitude() {
    for m in ["0", "1e-20", "0.5", "0.99"] {
        let elliptic = Elliptic::new(dd(m));
        for u in ["0", "0.3", "-1.7", "2.5", "40"].map(dd) {
            assert_close(elliptic.incomplete_integral(elliptic.jacobi_functions(u).am), u, 1e-28, m);
        }
    }
}

/// m = 0: circular functions. m = 1: hyperbolic ones.
#[test]
fn limits_are_circular_and_hyperbolic() {
    let (circular, hyperbolic) = (Elliptic::new(dd("0")), Elliptic::new(dd("1")));
    for u in ["-2", "0.4", "3"].map(dd) {
        let at = circular.jacobi_functions(u);
        assert_close(at.am, u, 1e-31, "am");
        assert_close(at.sn, u.sin_cos().0, 1e-31, "sn");
        assert_eq!(at.dn, Dd::int(1));
        let at = hyperbolic.jacobi_functions(u);
        assert_close(at.sn, u.tanh(), 1e-31, "sn");
        assert_close(at.cn, Dd::int(1) / u.cosh(), 1e-31, "cn");
        assert_close(hyperbolic.incomplete_integral(at.am), u, 1e-29, "F");
    }
    assert_eq!(hyperbolic.quarter_period(), Dd::INFINITY);
}

#[test]
fn parameters_out_of_range_give_no_number() {
    for m in [-0.1, 1.1, f64::NAN, f64::INFINITY] {
        let elliptic = Elliptic::new(m);
        assert!(elliptic.quarter_period().is_nan(), "{m}");
        assert!(elliptic.jacobi_functions(0.5).sn.is_nan() && elliptic.jacobi_functions(0.5).am.is_nan(), "{m}");
        assert!(elliptic.incomplete_integral(0.5).is_nan(), "{m}");
    }
    assert!(Elliptic::new(0.5).jacobi_functions(f64::INFINITY).sn.is_nan());
    assert!(Elliptic::new(0.5).jacobi_functions(f64::NAN).sn.is_nan());
}
