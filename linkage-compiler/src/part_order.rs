//! The order of the mechanisms of a call: each one after its parts. Circles are reported.

use crate::diagnostic::{Diagnostics, SourceSpan};
use crate::syntax::{Item, MechanismDef, PartItem};

/// Returns the order, and for each mechanism the messages about circles that begin with it.
///
/// Mechanisms of circles, and those that contain them, come last: their other mistakes are
/// reported, too.
pub(crate) fn part_order(definitions: &[MechanismDef]) -> (Vec<usize>, Vec<Diagnostics>) {
    let mut order = Vec::new();
    let mut open: Vec<usize> = (0..definitions.len()).collect();
    loop {
        let before = open.len();
        let is_ready =
            |index: usize| parts(definitions, index).all(|(_, part)| !open.contains(&part));
        let ready: Vec<usize> = open
            .iter()
            .copied()
            .filter(|&index| is_ready(index))
            .collect();
        open.retain(|index| !ready.contains(index));
        order.extend(ready);
        if open.len() == before {
            break;
        }
    }
    let circles = report_circles(definitions, &open);
    order.extend(open);
    (order, circles)
}

/// Reports each circle once, with the mechanism that is written first.
fn report_circles(definitions: &[MechanismDef], open: &[usize]) -> Vec<Diagnostics> {
    let mut messages: Vec<Diagnostics> = Vec::new();
    messages.resize_with(definitions.len(), Diagnostics::default);
    let mut reported: Vec<usize> = Vec::new();
    for &start in open {
        let Some(circle) = circle(definitions, start) else {
            continue;
        };
        if circle.iter().any(|(index, _)| reported.contains(index)) {
            continue;
        }
        let names: Vec<String> = circle
            .iter()
            .map(|(index, item)| {
                format!(
                    "`{}` has the part `{}: {}`",
                    definitions[*index].name, item.name, item.mechanism
                )
            })
            .collect();
        let fact = match &names[..] {
            [_] => format!("`{}` is a part of itself", definitions[start].name),
            _ => format!(
                "`{}` is a part of itself: {}",
                definitions[start].name,
                names.join(", ")
            ),
        };
        let help = "a mechanism that contains itself never ends: take one of these parts out";
        let item = circle[0].1;
        let span = SourceSpan::from(&item.name).to((&item.mechanism).into());
        messages[start].error_with_help(span, fact, help);
        reported.extend(circle.iter().map(|(index, _)| index));
    }
    messages
}

/// Returns the parts of a mechanism that are mechanisms of the call, with their numbers.
fn parts(definitions: &[MechanismDef], index: usize) -> impl Iterator<Item = (&PartItem, usize)> {
    let items = definitions[index].items.iter();
    items.filter_map(|item| match item {
        Item::Part(item) => {
            let mut names = definitions.iter();
            let part = names.position(|definition| definition.name == item.mechanism)?;
            Some((item, part))
        }
        _ => None,
    })
}

/// Returns the shortest path from a mechanism through its parts back to it: each mechanism with the
/// part that is next.
fn circle(definitions: &[MechanismDef], start: usize) -> Option<Vec<(usize, &PartItem)>> {
    let mut paths: Vec<(Vec<(usize, &PartItem)>, usize)> = vec![(Vec::new(), start)];
    let mut seen = Vec::new();
    while !paths.is_empty() {
        let mut longer = Vec::new();
        for (path, end) in paths {
            for (item, part) in parts(definitions, end) {
                let next: Vec<_> = path.iter().copied().chain([(end, item)]).collect();
                if part == start {
                    return Some(next);
                }
                if !seen.contains(&part) {
                    seen.push(part);
                    longer.push((next, part));
                }
            }
        }
        paths = longer;
    }
    None
}
