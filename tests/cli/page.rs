//! The page of `tripos page` as a whole: proofs, errata and printed runs beside the derived ones.

use crate::support::{SLIDER, answer, browser, page, root, status, stderr, tripos, without_scripts};
use std::process::{Command, Output};

/// The JSON of standard output, whatever the exit status is.
fn parsed(output: &Output) -> serde_json::Value {
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Exit status and page of a model of one's own.
fn made(model: &str) -> (Option<i32>, String, Output) {
    let folder = tempfile::tempdir().unwrap();
    let output = tripos(&["page", model, "--out", folder.path().to_str().unwrap()]);
    let page = std::fs::read_to_string(folder.path().join("index.html")).unwrap_or_default();
    (output.status.code(), page, output)
}

/// Goal: the page of any mechanism begins with an abstract whose sentences lead to their evidence, and a motion.
/// Method: one with a report, one with loops, one without a scene. Every link has its place, no place has two names,
/// and no other element has a name of the viewer.
#[test]
fn every_page_begins_with_an_abstract_that_leads_to_its_evidence() {
    let bare = tempfile::tempdir().unwrap();
    std::fs::write(bare.path().join("model.toml"), SLIDER).unwrap();
    for model in ["models/disk", "models/four_bar", "models/pendulum", bare.path().to_str().unwrap()] {
        let (page, _) = page(model);
        let shown = without_scripts(&page);
        let of =
            |mark: &str| shown.split(mark).skip(1).filter_map(|rest| Some(rest.split_once('"')?.0)).collect::<Vec<_>>();
        let (mut places, links) = (of(" id=\""), of("href=\"#"));
        let lost: Vec<&&str> = links.iter().filter(|link| !places.contains(link)).collect();
        assert!(lost.is_empty() && links.len() > 8, "{model}: {lost:?}");
        let all = places.len();
        places.sort_unstable();
        places.dedup();
        assert_eq!(places.len(), all, "{model}: {places:?}");
        let (_, summary) = shown.split_once("<section id=\"abstract\"").unwrap();
        let (summary, _) = summary.split_once("</section>").unwrap();
        for row in ["Mechanism", "Proved"] {
            assert!(summary.contains(&format!("<dt>{row}</dt><dd><a href=\"#")), "{model}: {summary}");
        }
        let moves = model.starts_with("models/");
        assert_eq!(page.matches("<figure class=\"view").count(), usize::from(moves), "{model}");
        assert_eq!(page.matches("<script").count(), if moves { 3 } else { 1 }, "{model}: what opens; data and viewer");
        let classes = of(" class=\"");
        assert!(!classes.iter().any(|class| class.starts_with("view")) || moves);
        for (foreign, what) in
            [("<link", "files"), (" src=", "files"), ("url(", "files"), ("@import", "styles"), ("https://", "places")]
        {
            assert!(!page.contains(foreign), "{model} needs no other {what}: {foreign}");
        }
        // 12 screens of 1.5 MB at most, which the browser measures.
        assert!(page.len() < 1_500_000, "{model}: {} bytes", page.len());
    }
}

/// Goal: the publication beside a model is judged on its page.
#[test]
fn a_publication_beside_a_model_is_judged() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name);
    std::fs::write(place("model.toml"), SLIDER).unwrap();
    let publication = "[[equation]]\nid = \"odd-one\"\nsection = \"1\"\nquantity = \"T\"\nprinted = 0\n";
    std::fs::write(place("publication.toml"), publication).unwrap();
    let out = place("out");
    let output = tripos(&["page", folder.path().to_str().unwrap(), "--out", out.to_str().unwrap()]);
    assert_eq!(status(&output), 0, "{}", stderr(&output));
    let page = std::fs::read_to_string(out.join("index.html")).unwrap();
    assert!(page.contains("A publication without a title") && page.contains("1 of 1 printed entry is wrong"));
}

/// Goal: the page works where people open it. Method: `tests/browser/page.mjs` drives a real browser over that of the
/// disk, which is the longest. It is no longer than 12 screens, plays, follows a slider, unfolds the targets of links,
/// and complains of nothing.
#[test]
fn a_browser_shows_the_page_and_its_motion() {
    let Some(modules) = browser() else { return };
    for (model, screens) in [("models/disk", "12"), ("models/four_bar", "12")] {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("index.html"), page(model).0.as_bytes()).unwrap();
        let mut node = Command::new("node");
        node.arg(root().join("tests/browser/page.mjs")).arg(folder.path().join("index.html"));
        let output = node.current_dir(modules.join("..")).env("SCREENS", screens).output().unwrap();
        assert!(output.status.success(), "{model}: {}", String::from_utf8_lossy(&output.stderr));
        let said = String::from_utf8_lossy(&output.stdout).into_owned();
        assert_eq!(said.matches(": held").count(), 5, "{model}: {said}");
    }
}

/// Goal: nothing that `prove` and `diff` find is missing from the page. Method: their JSON against its text.
#[test]
fn the_page_of_the_disk_has_every_erratum_integral_and_printed_run() {
    let (page, _) = page("models/disk");
    let difference = parsed(&tripos(&["diff", "models/disk", "models/disk/publication.toml", "--json"]));
    let (_, errata) = page.split_once("<h3 id=\"mistakes\">Root mistakes</h3>").expect("there are errata");
    let (errata, rest) = errata.split_once("Equal up to a factor").unwrap();
    let (_, all) = rest.split_once("All entries").unwrap();
    let mut wrong = 0;
    for entry in difference["equations"].as_array().unwrap() {
        let id = entry["id"].as_str().unwrap().replace('-', "-<wbr>");
        let is_wrong = ["different", "undecided"].contains(&entry["verdict"].as_str().unwrap());
        assert_eq!(errata.contains(&format!("<code>{id}</code>")), is_wrong, "{id}");
        assert!(all.contains(&format!("<code>{id}</code>")), "{id} is listed");
        wrong += usize::from(is_wrong);
    }
    assert!(wrong >= 30 && errata.matches("<th scope=\"rowgroup\"").count() == wrong, "{wrong} errata");

    let systems = difference["systems"].as_array().unwrap();
    assert_eq!(systems.len(), 6);
    let scenes = page.matches("<article id=\"scene-").count();
    for system in systems {
        let row = format!(
            "<tr class=\"printed wrong\"><th scope=\"row\"><code>printed:{}</code> <strong class=\"standing\">wrong</strong></th>",
            system["system"].as_str().unwrap()
        );
        // In each scene: among the runs, the first integrals and the extremes.
        assert_eq!(page.matches(&row).count(), 3 * scenes, "{row}");
    }
    let proof = parsed(&tripos(&["prove", "models/disk", "--json"]));
    let integrals = proof["integrals"].as_array().unwrap().len();
    assert_eq!(integrals, 6);
    for at in 1..=integrals {
        let subscript = char::from_digit(u32::try_from(at).unwrap(), 10).unwrap();
        assert!(page.contains(&format!("<h4><math><msub><mi>I</mi><mn>{subscript}</mn></msub></math>: ")), "I{at}");
    }
    assert!(page.contains("I₆ : angular momentum about a₃ through O"), "every integral has its panel");
}

/// Goal: every scene has its own equations on the page, what they keep and why, their run, and their curves. Method:
/// one of each in each part of the page, counted by scene.
#[test]
fn the_page_of_the_disk_has_every_scenes_own_equations() {
    let (page, _) = page("models/disk");
    let articles: Vec<&str> = page.split("<article id=\"scene-").skip(1).collect();
    assert_eq!(articles.len(), 6);
    for article in articles {
        let (title, _) = article.split_once("</h3>").unwrap();
        let (_, needs) = article.split_once("<h4>What the scene needs</h4>").expect(title);
        assert!(
            needs.contains("<p class=\"formula\">Of 10 states 2 are kept")
                && needs.contains("instead of 41 by Kane's method"),
            "{needs}"
        );
        assert!(needs.contains("<summary>What is left out, and why (") && needs.contains("by identity"), "{needs}");
        let is_lean = title.contains("The lean alone");
        assert_eq!(
            needs.contains("<td>integral</td>"),
            !is_lean,
            "{title}: heading and spin are wanted but for the lean"
        );
        // Among the runs; among first integrals and extremes only where every state is shown.
        let rows = article.matches("<th scope=\"row\">Reduced equations").count();
        assert_eq!(rows, if is_lean { 1 } else { 3 }, "{title}");
        assert!(!without_scripts(article).contains("NaN"), "{title}");
    }
    let figure = |caption: &str| {
        let (before, _) = page.split_once(caption).unwrap_or_else(|| panic!("no figure {caption}"));
        before.rsplit_once("<figure>").unwrap().1
    };
    for caption in ["The lean and its speed over 10 s", "Figure 5 of the report", "Total energy over 10 s"] {
        assert!(figure(caption).contains("Reduced equations"), "{caption}");
    }
    // Two outputs, a panel each, of four runs.
    let lean = figure("The lean and its speed over 10 s");
    assert!(lean.contains("[rad]") && lean.contains("[rad/s]") && lean.contains("Kane's method"), "its panels");
    assert!(figure("Speed against accuracy over 10 s, in the lean").contains("reduced"));
}

/// Goal: the page of the disk tells right from wrong. Method: in the run to 10 s at the report's tolerances every
/// derived run is loose, with its error, and every printed one is wrong, the one that ends well among them; captions
/// and legends say so.
#[test]
fn the_page_of_the_disk_tells_loose_from_wrong() {
    let (page, _) = page("models/disk");
    let (_, article) = page.split_once("<h3>The report's simulation, to t = 10 s</h3>").unwrap();
    let (article, _) = article.split_once("</article>").unwrap();
    let (before, article) = article.split_once("<table class=\"runs\">").unwrap();
    assert!(before.contains("All 4 derived runs are right but loose: ode45 with rtol 1e−3, atol 1e−5 leaves fewer than three digits from t = 1.015 s on and an error of"), "{before}");
    assert!(before.contains("As printed, all 6 systems are wrong, however their runs end; "), "{before}");
    let (runs, figures) = article.split_once("</table>\n</div>\n<figure>").unwrap();
    let (derived, printed) = runs.split_once("<tr class=\"group\">").unwrap();
    assert_eq!(derived.matches("<tr class=\"loose\">").count(), 4, "{derived}");
    assert_eq!(derived.matches("ode45 with rtol 1e−3, atol 1e−5 leaves an error of ").count(), 4, "{derived}");
    assert!(!derived.contains("wrong"), "{derived}");
    assert!(printed.contains(": all are wrong, they do not give the derived accelerations"), "{printed}");
    assert_eq!(printed.matches("<tr class=\"printed wrong\">").count(), 6, "{printed}");
    for said in [
        "Total energy over 10 s. Shown: Kane's method = Newton–Euler equations, Lagrange's equations, Reduced equations.",
        "Right, but loose: ode45 with rtol 1e−3, atol 1e−5 leaves an error at the end",
        "In red, since they do not give the derived accelerations: printed kane-final (wrong), printed lagrange-final (wrong)",
    ] {
        assert!(figures.contains(said), "{said}");
    }
    // More names in one legend tell nothing apart; each figure says twice what its curves are.
    for curves in page.split("Curves: ").skip(1) {
        let end = curves.find(['"', '<']).unwrap_or(curves.len());
        let curves = curves[..end].split(". ").next().unwrap();
        assert!(curves.split(", ").count() <= 8, "{curves}");
    }
}

/// The report's explanation of its failure, tested: Kane's determinant is never zero, Lagrange's is.
#[test]
fn the_page_of_the_disk_says_where_determinants_vanish() {
    let (page, _) = page("models/disk");
    let row = |name: &str| {
        let (_, row) = page
            .split_once(&format!("<tr><th scope=\"row\">{name}</th><td><div class=\"formula\">"))
            .unwrap_or_else(|| panic!("{name} has a determinant"));
        row.split_once("</tr>").unwrap().0.to_owned()
    };
    assert!(row("Kane's method").contains("<td>nowhere; entries of the matrix divide by"));
    assert!(row("Lagrange's equations").contains("<td>wherever <math>"));
    assert!(page.contains("Does a matrix become singular?"));
    let never = "zero in no configuration, whatever the parameters, for: Kane's method, Newton–Euler equations, \
                 <code>printed:kane-final</code>";
    assert!(page.contains(never));
}

const SCENE: &str = "span = [0, 2]\n[start]\nx = 1\nu = 0\n";

/// A slider with this report beside it.
fn slider(report: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("scenes")).unwrap();
    for (name, text) in [("model.toml", SLIDER), ("publication.toml", report), ("scenes/run.toml", SCENE)] {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn system(id: &str, matrix: &str, right: &str) -> String {
    format!(
        "[[system]]\nid = \"{id}\"\nsection = \"1\"\nformulation = \"kane\"\nunknowns = [\"u'\"]\nmatrix = [[\"{matrix}\"]]\n\
         right = [\"{right}\"]\n"
    )
}

/// Measured figures of a model that is interpreted: a chart with its table, and a reason for the passages it cannot
/// have.
#[test]
fn measured_figures_come_with_their_table_or_a_reason() {
    let folder = slider(&format!("title = \"Right\"\n{}", system("right", "m", "-k*x")));
    let figures = "[[figures]]\nkind = \"work-precision\"\n[[figures]]\nkind = \"passages\"\n";
    std::fs::write(folder.path().join("scenes/my run.toml"), format!("{SCENE}{figures}")).unwrap();
    let out = tempfile::tempdir().unwrap();
    let output = tripos(&["page", folder.path().to_str().unwrap(), "--out", out.path().to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let page = std::fs::read_to_string(out.path().join("index.html")).unwrap();
    assert!(page.contains("<a href=\"my%20run/work_precision.csv\">"));
    assert!(page.contains(". Each point is a run") && !page.contains(". . "), "without a caption of its own");
    assert!(
        page.contains("Which equations, accelerations and method to use") && !without_scripts(&page).contains("NaN")
    );
    assert!(page.contains("<p class=\"missing\">The figure `passages` cannot be drawn: the motion does not come near"));
    assert!(stderr(&output).contains("my run.toml: The figure `passages` cannot be drawn"), "{}", stderr(&output));
    let table = std::fs::read_to_string(out.path().join("my run/work_precision.csv")).unwrap();
    assert!(table.lines().count() > 60 && !out.path().join("my run/stability.csv").exists(), "{table}");
}

/// Printed equations end as they like: that is shown, and the command succeeds.
#[test]
fn printed_equations_that_fail_do_not_fail_the_page() {
    let report = [
        "title = \"Errors\"\n".to_owned(),
        system("right", "m", "-k*x"),
        system("explodes", "m", "x^3*1000000"),
        system("singular", "0", "-k*x"),
        system("singular-later", "x", "-x^2 - x*0.1"),
        system("not-finite", "m", "1/(x - 1)"),
    ];
    let folder = slider(&report.concat());
    let (status, page, output) = made(folder.path().to_str().unwrap());
    assert_eq!(status, Some(0), "{}", stderr(&output));
    assert!(!stderr(&output).contains("warning"), "the derived runs are fine: {}", stderr(&output));
    for id in ["right", "explodes", "singular", "singular-later", "not-finite"] {
        assert!(page.contains(&format!("printed:{id}</code>")), "{id}");
    }
    for (id, standing) in [("explodes", " <strong class=\"standing\">wrong</strong>"), ("right", "")] {
        assert!(page.contains(&format!("printed:{id}</code>{standing}</th>")), "{id}");
    }
    let (_, rows) = page.split_once("<tr class=\"group\">").unwrap();
    let (rows, _) = rows.split_once("</table>").unwrap();
    assert!(rows.contains("singular"), "how runs end is said: {rows}");
    assert!(page.contains("id=\"errata\"") && !without_scripts(&page).contains("NaN"));
}

#[test]
fn a_report_with_errors_is_answered_and_the_page_goes_without_it() {
    let folder =
        slider("title = \"Errors\"\n[[equation]]\nid = \"1\"\nsection = \"1\"\nquantity = \"T\"\nprinted = \"m*y\"\n");
    let (status, page, output) = made(folder.path().to_str().unwrap());
    assert_eq!(status, Some(2));
    assert!(stderr(&output).contains("unknown name `y`"), "{}", stderr(&output));
    assert!(page.contains("id=\"proof\"") && !page.contains("id=\"errata\""));
}

/// Goal: `--set` is heard by the runs of the page. Method: a gravity of zero leaves the energy of a pendulum kinetic,
/// and its slider stands at zero.
#[test]
fn a_page_takes_other_values_for_its_scenes() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let (status, _, said) = answer(&["page", "models/pendulum", "--set", "g=1.62", "--out", out]);
    assert!(said.contains("note: g = 1.62, not the value of the scenes"), "{said}");
    assert_eq!(said.matches("note: g").count(), 1, "{said}");
    assert!(status == 0, "{said}");
    let html = std::fs::read_to_string(folder.path().join("index.html")).unwrap();
    assert!(html.contains("1.62"));
    let (status, _, said) = answer(&["page", "models/pendulum", "--set", "gg=1", "--out", out]);
    assert!(status == 2 && said.contains("the scene has no parameter or start value `gg`"), "{said}");
}
