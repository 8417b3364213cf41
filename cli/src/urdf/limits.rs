//! Limits of coordinates from the domain of a model.

use super::numbers::Numbers;
use super::tree::{NodeMotion, Tree};
use tripos_derive::Model;

/// Limits of the coordinates, as (smallest, largest) value in rad or m, infinite without a limit. The second result has
/// the names of the conditions that are no limit of one joint's coordinate, or that exclude one another.
pub fn coordinate_limits<'m>(model: &'m Model, tree: &Tree, numbers: &mut Numbers) -> (Vec<(f64, f64)>, Vec<&'m str>) {
    let mut limits = vec![(f64::NEG_INFINITY, f64::INFINITY); numbers.coordinates.len()];
    let (mut others, mut used) = (Vec::new(), Vec::new());
    for condition in &model.domain {
        let found = numbers.positive_range(condition.positive);
        let Some((coordinate, (low, high))) = found.filter(|(coordinate, _)| has_limits(tree, *coordinate)) else {
            others.push(condition.name.as_str());
            continue;
        };
        let (lower, upper) = &mut limits[coordinate];
        (*lower, *upper) = (lower.max(low), upper.min(high));
        used.push((condition.name.as_str(), coordinate));
    }
    let is_empty = |coordinate: usize| limits[coordinate].0 > limits[coordinate].1;
    let empty: Vec<usize> = (0..limits.len()).filter(|coordinate| is_empty(*coordinate)).collect();
    others.extend(used.iter().filter(|(_, coordinate)| empty.contains(coordinate)).map(|(name, _)| *name));
    for coordinate in empty {
        limits[coordinate] = (f64::NEG_INFINITY, f64::INFINITY);
    }
    (limits, others)
}

/// True if a coordinate is that of a joint with one coordinate, which can have limits.
fn has_limits(tree: &Tree, coordinate: usize) -> bool {
    tree.owner(coordinate)
        .is_some_and(|owner| matches!(tree.nodes[owner].motion, NodeMotion::Slide { .. } | NodeMotion::Turn { .. }))
}
