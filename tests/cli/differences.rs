//! `tripos diff OLD NEW`: equations, declarations and scenes told apart, in a screenful.

use crate::support::{answer, copy, root, tripos_in};
use expect_test::expect;
use serde_json::Value;
use std::path::Path;

/// A library model in a folder `old` and, edited, in a folder `new`, with their scenes.
fn edited(name: &str, edit: impl Fn(String) -> String) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for side in ["old", "new"] {
        copy(&root().join("models").join(name), &folder.path().join(side));
    }
    let path = folder.path().join("new/model.toml");
    std::fs::write(&path, edit(std::fs::read_to_string(&path).unwrap())).unwrap();
    folder
}

/// Status and text of the comparison of `old` with `new`.
fn diff(folder: &Path) -> (i32, String) {
    let (status, text, _) = tripos_in(folder, &["diff", "old", "new"]);
    (status, text)
}

/// The comparison as JSON, which has the same status.
fn diff_json(folder: &Path) -> Value {
    let (status, text, _) = tripos_in(folder, &["diff", "old", "new", "--json"]);
    let value: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(status == 0, value["same"].as_bool().unwrap());
    value
}

/// Remarks, titles, order and other ways to write the same are no difference.
#[test]
fn what_no_number_depends_on_is_no_difference() {
    let folder = edited("disk", |text| {
        let text =
            text.replace("about = \"heading\"", "about = \"the heading\"").replace("abs(q2) < pi/2", "pi/2 > abs(q2)");
        text.replace("Thin disk", "Disk")
            .replace("\"M*R^2/2\"", "\"0.5*M*R^2\"")
            .replace("value = 9.81", "value = \"981/100\"")
    });
    let (status, text) = diff(folder.path());
    expect![[r"
        old/model.toml -> new/model.toml
        equations of motion: the same, 114 entries compared by algebra
        defaults, units, domain, elements and scenes: the same
    "]]
    .assert_eq(&text);
    assert_eq!(status, 0);
    assert_eq!(diff_json(folder.path())["declarations"], serde_json::json!([]));
}

#[test]
fn defaults_signs_and_domain_differ_where_the_equations_are_the_same() {
    let folder = edited("disk", |text| {
        let text = text.replace("R = { unit = \"m\", value = 1, positive = true", "R = { unit = \"m\", value = 2");
        let text = text.replace("abs(q2) < pi/2", "abs(q2) < pi/3").replace("contact = \"N > 0\"\n", "");
        format!("{text}low = \"q4 < R\"\n")
    });
    let (status, text) = diff(folder.path());
    expect![[r"
        old/model.toml -> new/model.toml
        equations of motion: the same, 114 entries compared by algebra
        added: condition low
        removed: condition contact
        defaults differ: R 1 -> 2
        stated to be positive differs: R yes -> not stated
        domain differs: upright abs(q2) < pi/2 -> abs(q2) < pi/3
    "]]
    .assert_eq(&text);
    assert_eq!(status, 1);
    let value = diff_json(folder.path());
    assert_eq!((&value["same_equations"], &value["declarations"][0]["new"]), (&true.into(), &"2".into()));
}

#[test]
fn scenes_are_compared_key_by_key() {
    let folder = edited("pendulum", |text| text);
    let scenes = folder.path().join("new/scenes");
    let swing = std::fs::read_to_string(scenes.join("swing.toml")).unwrap();
    std::fs::write(scenes.join("swing.toml"), swing.replace("rtol = 1e-9", "rtol = 1e-8")).unwrap();
    std::fs::rename(scenes.join("over.toml"), scenes.join("around.toml")).unwrap();
    let (status, text) = diff(folder.path());
    expect![[r"
        old/model.toml -> new/model.toml
        equations of motion: the same, 20 entries compared by algebra
        scenes differ:
          scenes/around.toml: added
          scenes/swing.toml: integration.rtol 1e-9 -> 1e-8
          scenes/over.toml: removed
    "]]
    .assert_eq(&text);
    assert_eq!(status, 1);
}

/// A model file alone, as an older version is taken out of a repository, is no model whose scenes were removed.
#[test]
fn a_file_without_scenes_is_compared_by_its_model_alone() {
    let folder = edited("pendulum", |text| text);
    std::fs::remove_dir_all(folder.path().join("old/scenes")).unwrap();
    assert_eq!(diff(folder.path()).0, 0);
}

#[test]
fn a_changed_inertia_is_a_changed_entry() {
    let folder = edited("disk", |text| text.replace("\"M*R^2/2\"", "\"M*R^2/3\""));
    let value = diff_json(folder.path());
    let change = value["equations"].as_array().unwrap().iter().find(|e| e["id"] == "kane M[u3, u3']").unwrap().clone();
    assert_eq!(change["difference"], "-M*R^2/6");
    assert_eq!(value["declarations"][0]["name"], "disk");
}

/// An added force is a screenful: at most 40 lines, in them every entry that it works in, and what it takes away.
#[test]
fn an_added_force_is_told_in_a_screenful() {
    let folder = edited("disk", |text| {
        let drag =
            "[forces.drag]\non = \"disk\"\nat = \"Cstar\"\nframe = \"A\"\nvector = [\"-c*q4'\", \"-c*q5'\", 0]\n";
        text.replace("[coordinates]", "c = { unit = \"N*s/m\" }\n\n[coordinates]") + drag
    });
    let (status, text) = diff(folder.path());
    expect![[r"
        old/model.toml -> new/model.toml
        equations of motion: 11 of 114 entries changed
          kane f[u1]: new - old = R*c*cos(q2)*(u5*cos(q1) - u4*sin(q1))
          kane f[u2]: new - old = R*c*tan(q2)*(u4*cos(q1) + u5*sin(q1))
          kane f[u4]: new - old = -c*u4
          kane f[u5]: new - old = -c*u5
          lagrange f[q1]: new - old = R*c*sin(q2)*(q4'*cos(q1) + q5'*sin(q1))
          lagrange f[q2]: new - old = R*c*cos(q2)*(q4'*sin(q1) - q5'*cos(q1))
          lagrange f[q4]: new - old = -c*q4'
          lagrange f[q5]: new - old = -c*q5'
          newton-euler f[disk force b1]: new - old = -c*(u4*cos(q1) + u5*sin(q1))
          newton-euler f[disk force b2]: new - old = c*sin(q2)*(u4*sin(q1) - u5*cos(q1))
          newton-euler f[disk force b3]: new - old = c*cos(q2)*(u5*cos(q1) - u4*sin(q1))
        no longer found conserved:
          energy T + V
          momentum p_q4 = ∂L/∂q4'
          momentum p_q5 = ∂L/∂q5'
          angular momentum about a3 through O
        now conserved:
          momentum p_q4 + c*q4, where p_q4 = ∂L/∂q4'
          momentum p_q5 + c*q5, where p_q5 = ∂L/∂q5'
        added: parameter c; force drag
    "]]
    .assert_eq(&text);
    assert_eq!(status, 1);
    assert!(text.lines().count() <= 40, "{text}");
}

#[test]
fn a_formulation_that_was_lost_is_named_with_its_reason() {
    let folder = edited("chaotic_pendulum", |text| {
        text.replace(
            "direction = [0, 0, 1]\nabout = \"force of the pin along the rod",
            "direction = [1, 0, 0]\nabout = \"force of the pin along the rod",
        )
    });
    let (status, text) = diff(folder.path());
    assert_eq!(status, 1);
    let lost = "  no longer derived: newton-euler: newton-euler is not possible: its equations do not determine the reactions one by one";
    assert!(text.contains(lost), "{text}");
    assert!(text.contains("equations of motion: 0 of ") && text.contains("otherwise: pin3"), "{text}");
    assert_eq!(diff_json(folder.path())["formulations"]["lost"][0]["formulation"], "newton-euler");
    let (status, text, _) = tripos_in(folder.path(), &["diff", "new", "old"]);
    assert!(status == 1 && text.contains("  now derived: newton-euler\n"), "{text}");
}

/// Goal: a loop that closes at another place is another mechanism, though its rate is the same. Method: the ground of
/// the four-bar linkage made longer.
#[test]
fn a_loop_closed_elsewhere_is_a_difference() {
    let folder = edited("four_bar", |text| text.replace("= d + c*cos(q3)", "= 2*d + c*cos(q3)"));
    let (status, out) = diff(folder.path());
    assert_eq!(status, 1, "{out}");
    assert!(out.contains("loop_x"), "{out}");
}

/// Goal: models are compared by what they declare, whatever their names and files. Method: a crane whose coordinates
/// come from its joints, in files of other names.
#[test]
fn models_of_joints_are_compared_whatever_their_files_are_called() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(root().join("cli/src/commands/new/model.toml")).unwrap();
    std::fs::write(folder.path().join("one.toml"), &text).unwrap();
    std::fs::write(folder.path().join("two.toml"), text.replace("-c*q_track'", "-2*c*q_track'")).unwrap();
    let (status, said, err) = tripos_in(folder.path(), &["diff", "one.toml", "two.toml"]);
    assert!(status == 1 && said.contains("c*u_track"), "{said}{err}");
    assert_eq!(tripos_in(folder.path(), &["diff", "one.toml", "one.toml"]).0, 0);
}

/// Goal: a derivation with another zero of an angle is right in its own coordinates, which can be copied.
#[test]
fn the_coordinates_of_a_publication_are_found() {
    let folder = tempfile::tempdir().unwrap();
    let model = root().join("publications/gantry_crane/model.toml");
    std::fs::copy(model, folder.path().join("model.toml")).unwrap();
    let potential = "[[equation]]\nid = \"V\"\nsection = \"1\"\nquantity = \"V\"\nprinted = \"m*g*l*cos(theta)\"\n";
    let row = "[[equation]]\nid = \"1\"\nsection = \"1\"\n\
               printed = \"(M + m)*x'' - m*l*theta''*cos(theta) + m*l*theta'^2*sin(theta) = F\"\n";
    let find = |text: &str, other: &str| {
        std::fs::write(folder.path().join("publication.toml"), text).unwrap();
        tripos_in(folder.path(), &["diff", "model.toml", other, "--find-coordinates"])
    };
    let both = format!("{potential}{row}");
    let (status, out, err) = find(&both, "publication.toml");
    assert_eq!((status, err.as_str()), (0, ""), "{out}");
    let table = "[coordinates]\ntheta = \"pi + theta\"\n";
    assert!(out.contains(table) && out.contains("2 of 2 are right, 0 before"), "{out}");
    // The table in the publication gives the same verdict.
    let (status, out, _) = find(&format!("{table}{both}"), "publication.toml");
    assert!(status == 0 && out.contains("No other choice of coordinates makes more formulas right"), "{out}");
    // The potential alone does not tell the sign of the angle.
    let (status, out, _) = find(potential, "publication.toml");
    assert!(status == 1 && out.contains("in each of 2 choices") && out.contains("None of them is better"), "{out}");
    let (status, _, err) = find(potential, "model.toml");
    assert!(status == 2 && err.contains("this file is a model"), "{err}");
}

/// Goal: several submissions in one call. Method: the same verdicts as one by one, and a file that is not there between
/// them.
#[test]
fn several_publications_are_judged_in_one_call() {
    let (model, printed) = ("models/disk", "models/disk/publication.toml");
    let alone: Value = serde_json::from_str(&answer(&["diff", model, printed, "--json"]).1).unwrap();
    let (status, text, _) = answer(&["diff", model, printed, "nowhere.toml", printed, "--json"]);
    let value: Value = serde_json::from_str(&text).unwrap();
    let list = value["comparisons"].as_array().unwrap();
    assert_eq!((status, list.len()), (2, 3), "{text}");
    for at in [0, 2] {
        assert_eq!(list[at]["file"], printed);
        assert_eq!(list[at]["equations"], alone["equations"]);
    }
    assert_eq!(
        (&list[1]["file"], &list[1]["error"]["places"][0]["file"]),
        (&"nowhere.toml".into(), &"nowhere.toml".into())
    );
    let (status, text, said) = answer(&["diff", model, printed, "nowhere.toml"]);
    assert_eq!(status, 2);
    assert!(
        text.starts_with("models/disk/publication.toml\n") && text.contains("nowhere.toml\nnot compared: "),
        "{text}"
    );
    assert!(said.contains("nowhere.toml"), "{said}");
}

/// Goal: a model in other variables is recognised, with proof, and a wrong one is not. Method: a double pendulum with
/// renamed masses and angles, another zero and sense of one angle and another speed; then with a longer rod too.
#[test]
fn other_variables_are_recognised_and_a_longer_rod_is_not() {
    let folder = tempfile::tempdir().unwrap();
    let old = std::fs::read_to_string(root().join("examples/own_crate/model.toml")).unwrap();
    let new = old.replace("omega2 = \"theta2'\"", "omega2 = \"2*beta' - alpha'\"");
    let new = new.replace("angle = \"theta2\"", "angle = \"pi/2 - beta\"").replace("theta2", "beta");
    let new = new.replace("theta1", "alpha").replace("m1", "mu").replace("m2", "nu");
    let longer = new.replace("\"-l2\"", "\"-2*l2\"");
    assert!(new != old && longer != new);
    for (name, text) in [("old", &old), ("new", &new), ("longer", &longer)] {
        std::fs::create_dir(folder.path().join(name)).unwrap();
        std::fs::write(folder.path().join(name).join("model.toml"), text).unwrap();
    }
    let (status, text) = diff(folder.path());
    expect![[r"
        old/model.toml -> new/model.toml
        equations of motion: proved the same in other variables; 42 of 46 entries read otherwise
          old parameter m1 is mu
          old parameter m2 is nu
          old coordinate theta1 is alpha
          old coordinate theta2 is pi/2 - beta
          old speed omega2 is -omega1/2 - omega2/2
        added: parameter mu; parameter nu; coordinate alpha; coordinate beta
        removed: parameter m1; parameter m2; coordinate theta1; coordinate theta2
        defined otherwise: omega1 theta1' -> alpha'; omega2 theta2' -> 2*beta' - alpha'; A from N about axis 3 (theta1) -> from N about axis 3 (alpha); B from N about axis 3 (theta2) -> from N about axis 3 (pi/2 - beta); upper particle at P (m1) -> particle at P (mu); lower particle at Q (m2) -> particle at Q (nu)
    "]].assert_eq(&text);
    assert_eq!(status, 1);
    let value = diff_json(folder.path());
    assert_eq!(value["same"], false, "the declarations differ: {value}");
    let (status, text, _) = tripos_in(folder.path(), &["diff", "old", "longer"]);
    assert!(status == 1 && text.contains("entries changed") && !text.contains("proved the same"), "{text}");
}
