//! The face of a page: its order, its links, its abstract.

use crate::page::tests::{page, page_with_publication, part};

/// The places of a page, and where its links lead.
fn places_and_links(page: &str) -> (Vec<&str>, Vec<&str>) {
    let of = |mark: &str| page.split(mark).skip(1).filter_map(|rest| Some(rest.split_once('"')?.0)).collect::<Vec<_>>();
    (of(" id=\""), of("href=\"#"))
}

#[test]
fn every_link_has_its_place_and_every_place_one_name() {
    for page in [page(), page_with_publication()] {
        let (mut places, links) = places_and_links(&page);
        assert!(places.len() > 20 && links.len() > 15, "{places:?} {links:?}");
        for link in links {
            assert!(places.contains(&link), "{link}: {places:?}");
        }
        let all = places.len();
        places.sort_unstable();
        places.dedup();
        assert_eq!(places.len(), all, "a name twice: {places:?}");
    }
}

/// Goal: the most important parts come first.
#[test]
fn a_page_begins_with_its_abstract_and_its_motion() {
    let page = page_with_publication();
    let order = [
        "abstract",
        "motion",
        "errata",
        "simulation",
        "scene-1",
        "mechanism",
        "equations",
        "kane",
        "proof",
        "derivations",
        "kane-steps",
    ];
    let at = order.map(|place| page.find(&format!(" id=\"{place}\"")).expect(place));
    assert!(at.is_sorted(), "{at:?}");
    assert!(page.contains("</a>: it turns &lt;fast&gt;</p>"), "what is doubtful is said");
    assert!(page.contains("tripos view fall &lt;2&gt;.toml</code>"), "the other scene by its command");
    let (_, figure) = page.split_once("<section id=\"abstract\" aria-label=\"Abstract\">\n").unwrap();
    let sketch =
        "<figure>\n<svg class=\"sketch\"></svg>\n<figcaption>Drawn at &lt;rest&gt;.</figcaption>\n</figure>\n<dl>";
    assert!(figure.starts_with(sketch), "the sketch comes first");
}

/// The words of HTML.
fn text_of(html: &str) -> String {
    let html = html.replace("</dt>", ": </dt>");
    let pieces = html.split('<').skip(1).filter_map(|piece| Some(piece.split_once('>')?.1));
    pieces.collect::<String>().replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&").trim().to_owned()
}

/// Goal: every sentence of the abstract is true. Method: read by a person; the pendulum with a publication that errs in
/// a potential and in gravity.
#[test]
fn an_abstract_is_made_of_values() {
    let page = page_with_publication();
    let text = text_of(part(part(&page, "<section id=\"abstract\"", "</section>"), "<dl>", "</dl>"));
    expect_test::expect![[r"
        Mechanism: 1 particle with one degree of freedom: 1 coordinate and 1 generalized speed.
        Proved: Kane's method, Lagrange's equations and Newton–Euler equations give the same equations of motion. 1 first integral: the energy. The equations hold everywhere. The matrix of the accelerations is singular nowhere by Kane's method, Lagrange's equations and Newton–Euler equations.
        In print: A <course> report & more. Of 5 printed entries: 2 wrong, 1 right up to a factor, 1 as derived and 1 only stated. 2 root mistakes are behind them. Of 2 printed systems these do not give the derived accelerations: swing; one does not conserve the energy.
        Simulated: “Fall <1>”: 1 of 4 derived runs stops at t = 0.93123 s: component 3 < 0 is not finite. “Fall <1>”: 1 of 4 derived runs stops at t = 0.93123 s: component 3 < 0 is not finite. “Fall <1>”: As printed, 1 of 2 systems is wrong, however its run ends. printed:swing arrives, with total energy off by 1.3 × 10−9 J.
        To run it: Measured on “Fall <1>”: an error of 1 × 10−6 is reached fastest, in 250 µs, by tripos simulate fall <2>.toml --by kane & <sons> --method dop853 --rtol 1e-9 --atol 1e-9."]].assert_eq(&text);
}
