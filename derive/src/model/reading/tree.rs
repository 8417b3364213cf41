//! Tree order of frames and points: parents come before their children.

use super::declared_names::NameKind;
use super::loading::Loading;
use crate::toml_reader::Located;
use rustc_hash::FxHashMap;

/// Frame or point with its parent, as names, before it is sorted.
pub struct Node<T> {
    /// Name of the frame or point.
    pub name: Located,
    /// Name of the frame's or point's parent.
    pub parent: Located,
    /// Data of the frame or point, such as its rotation or position.
    pub payload: T,
}

/// Sorts frames or points so that parents come first. Returns each with its parent's index in the sorted list, in
/// which the root has index 0. Reports unknown parents and cycles. Descendants of these are left out without a
/// report.
pub fn sort_parents_first<T>(
    loading: &mut Loading<'_>,
    nodes: Vec<Node<T>>,
    root: Option<&str>,
    kind: NameKind,
) -> Vec<(Node<T>, usize)> {
    let mut children: FxHashMap<String, Vec<usize>> = FxHashMap::default();
    let mut left: Vec<Option<Node<T>>> = Vec::new();
    for node in nodes {
        if loading.names.expect(&mut loading.reader, &node.parent, kind) {
            children.entry(node.parent.text.clone()).or_default().push(left.len());
            left.push(Some(node));
        }
    }
    let mut ordered = Vec::new();
    let mut reached: Vec<(String, usize)> = root.map(|name| (name.to_owned(), 0)).into_iter().collect();
    let mut next = 0;
    while let Some((name, at)) = reached.get(next).cloned() {
        next += 1;
        for child in children.remove(&name).unwrap_or_default() {
            let Some(node) = left[child].take() else { continue };
            reached.push((node.name.text.clone(), reached.len()));
            ordered.push((node, at));
        }
    }
    report_cycles(loading, &left.into_iter().flatten().collect::<Vec<_>>());
    ordered
}

/// Reports each cycle once, among nodes that are not connected to the root.
fn report_cycles<T>(loading: &mut Loading<'_>, waiting: &[Node<T>]) {
    let position: FxHashMap<&str, usize> =
        waiting.iter().enumerate().map(|(at, node)| (node.name.text.as_str(), at)).collect();
    // Walks go from each remaining node to its parents. A node that occurs twice on one walk closes a cycle.
    let mut walk_of = vec![usize::MAX; waiting.len()];
    for start in 0..waiting.len() {
        let mut path = Vec::new();
        let mut at = Some(start);
        while let Some(here) = at {
            if walk_of[here] != usize::MAX {
                if walk_of[here] == start {
                    let first = path.iter().position(|n| *n == here).unwrap_or(0);
                    report_cycle(loading, waiting, &path[first..]);
                }
                break;
            }
            walk_of[here] = start;
            path.push(here);
            at = position.get(waiting[here].parent.text.as_str()).copied();
        }
    }
}

/// Reports a cycle of frames or points. The message shows at most 12 of their names.
fn report_cycle<T>(loading: &mut Loading<'_>, waiting: &[Node<T>], cycle: &[usize]) {
    const SHOWN: usize = 12;
    let first = &waiting[cycle[0]];
    let mut names: Vec<&str> = cycle.iter().take(SHOWN).map(|n| waiting[*n].name.text.as_str()).collect();
    if cycle.len() > SHOWN {
        names.push("…");
    }
    names.push(&first.name.text);
    let message = format!("`{}` is placed from itself: {}", first.name.text, names.join(" -> "));
    let help = "every frame and point must lead back to the inertial frame and the origin";
    loading.reader.error(first.parent.span.clone(), message, help);
}
