//! Tests of the page's order, links and abstract.

use crate::page::tests::{page, page_with_publication, part};

/// Returns the ids of a page, and the ids to which its links lead.
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

/// Goal: the most important parts of the page come first.
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

/// Returns the text of HTML without its tags.
fn text_of(html: &str) -> String {
    let html = html.replace("</dt>", ": </dt>");
    let pieces = html.split('<').skip(1).filter_map(|piece| Some(piece.split_once('>')?.1));
    pieces.collect::<String>().replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&").trim().to_owned()
}

/// Goal: every sentence of the abstract is true. Method: the sentences are read by a person. They are about the
/// pendulum, with a publication that has errors in a potential and in gravity.
#[test]
fn an_abstract_is_made_of_values() {
    let page = page_with_publication();
    let text = text_of(part(part(&page, "<section id=\"abstract\"", "</section>"), "<dl>", "</dl>"));
    expect_test::expect![[r"
        Mechanism: 1 particle with one degree of freedom.
        Proved: Kane's method, Lagrange's equations and Newton–Euler equations give the same equations of motion, which hold everywhere. The motion has 1 first integral: the energy.
        In print: A <course> report & more: 2 of 5 printed entries are wrong. 2 mistakes cause them. Of 2 printed systems, 1 gives right and 1 gives wrong accelerations, and one does not conserve energy.
        Simulated: Of 2 scenes, 2 have runs that fail; of 8 claims about motions, 2 are proved and 2 refuted.
        To run it: The fastest run to an error of 1 × 10−6 takes 250 µs: tripos simulate fall <2>.toml --by kane & <sons> --method dop853 --rtol 1e-9 --atol 1e-9."]].assert_eq(&text);
}

/// Goal: claims about a motion stand on the page with their verdicts, beside the words of the publication. Method: four
/// claims with all kinds of verdicts.
#[test]
fn claims_stand_beside_the_sentences_in_print() {
    let page = page();
    let table = text_of(part(&page, "<section id=\"claims\"", "</table>"));
    for text in
        ["“the angle <stays>”", "q1 < <2>", "Kane's <method>", "as x < y says", "false, at an instant before 0.25 s"]
    {
        assert!(table.contains(text), "{text} in {table}");
    }
    assert!(table.contains("proved up to 0.5 s, then open") && table.contains("not judged: no <series>"), "{table}");
}
