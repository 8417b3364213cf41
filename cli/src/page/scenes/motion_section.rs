//! Section of the page with the moving figure of one scene, and commands that show the motions of
//! the other scenes.

use crate::page::content::{MotionFigure, Page, SceneSection};
use crate::page::markup::html::{escape, folded_html, join_html, link};
use crate::page::scenes::outcome::title;
use crate::page::scenes::scene::scene_anchor;
use crate::phrases::counted_noun;
use std::fmt::Write;

/// Returns the HTML section about the motion, with the moving figure or the reason why there is none.
pub fn section(page: &Page, moving: &MotionFigure) -> String {
    let mut out = String::from("<section id=\"motion\">\n<h2>The motion</h2>\n");
    match &moving.viewer {
        Ok(viewer) => {
            let scene = &page.scenes[moving.scene];
            let link = link(&scene_anchor(moving.scene), &title(scene));
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
    out + &other_scenes_commands(page, moving) + "</section>\n"
}

/// Returns the HTML of commands that show the motions of scenes without a moving figure. Empty if there are no such
/// scenes.
fn other_scenes_commands(page: &Page, moving: &MotionFigure) -> String {
    let shown = moving.viewer.is_ok().then_some(moving.scene);
    let list: Vec<&SceneSection> =
        page.scenes.iter().enumerate().filter(|(at, _)| Some(*at) != shown).map(|(_, scene)| scene).collect();
    if list.is_empty() {
        return String::new();
    }
    let command = |scene: &&SceneSection| {
        format!("<li>{}: <code>tripos view {}</code></li>\n", title(scene), escape(&scene.file))
    };
    folded_html(
        &format!("In files of their own: {}", counted_noun(list.len(), "other scene")),
        &format!("<ul>\n{}</ul>\n", join_html(&list, command)),
    )
}
