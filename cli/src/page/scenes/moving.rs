//! Section of the page with the moving figure of one scene, and commands that show the motions of
//! the other scenes.

use crate::page::content::{Moving, Page, SceneSection};
use crate::page::markup::html::{anchor, count, each, escape, folded, link};
use crate::page::scenes::outcome::title;
use std::fmt::Write;

/// Returns the HTML section on the motion, with the moving figure or the reason why there is none.
pub fn section(page: &Page, moving: &Moving) -> String {
    let mut out = String::from("<section id=\"motion\">\n<h2>The motion</h2>\n");
    match &moving.viewer {
        Ok(viewer) => {
            let scene = &page.scenes[moving.scene];
            let link = link(&anchor(moving.scene), &title(scene));
            let _ = match &viewer.doubt {
                Some(doubt) => writeln!(out, "<p class=\"missing\">{link}: {}</p>", escape(doubt)),
                None => writeln!(out, "<p>{link}</p>"),
            };
            out += &viewer.figure;
        }
        Err(why) => {
            let _ = writeln!(out, "<p class=\"missing\">The motion cannot be shown: {}.</p>", escape(why));
        }
    }
    out + &others(page, moving) + "</section>\n"
}

/// Returns the HTML of commands that show the motions of scenes without a moving figure. Empty if
/// there are no such scenes.
fn others(page: &Page, moving: &Moving) -> String {
    let shown = moving.viewer.is_ok().then_some(moving.scene);
    let list: Vec<&SceneSection> =
        page.scenes.iter().enumerate().filter(|(at, _)| Some(*at) != shown).map(|(_, scene)| scene).collect();
    if list.is_empty() {
        return String::new();
    }
    let command = |scene: &&SceneSection| {
        format!("<li>{}: <code>tripos view {}</code></li>\n", title(scene), escape(&scene.file))
    };
    folded(
        &format!("In files of their own: {}", count(list.len(), "other scene")),
        &format!("<ul>\n{}</ul>\n", each(&list, command)),
    )
}
