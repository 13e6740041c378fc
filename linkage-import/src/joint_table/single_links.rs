//! Links that a single row names: most of them are misspelt.

use std::collections::BTreeMap;

use csv::StringRecord;

use crate::csv_lines::line_number;
use crate::names::shown;

/// Names of the fixed link.
const FIXED: [&str; 2] = ["frame", "ground"];

/// More warnings than these say nothing new.
const MOST_WARNINGS: usize = 10;

/// The letters of a name that are compared.
const MOST_LETTERS: usize = 40;

/// A row of a table: a joint and its links.
pub(super) struct JointLinks<'t> {
    pub(super) row: &'t StringRecord,
    pub(super) joint: &'t str,
    pub(super) links: Vec<&'t str>,
}

/// Returns a warning of each link that one row of the text names, with the name that resembles it
/// most.
pub(super) fn warnings(joints: &[JointLinks], text: &str) -> Vec<String> {
    let mut by_link: BTreeMap<&str, Vec<&JointLinks>> = BTreeMap::new();
    for joint in joints {
        for link in &joint.links {
            by_link.entry(link).or_default().push(joint);
        }
    }
    let singles = by_link
        .iter()
        .filter_map(|(name, joints)| match joints[..] {
            [joint] if !FIXED.contains(name) => Some((*name, joint)),
            _ => None,
        });
    let warning = |(name, only): (&str, &JointLinks)| {
        // The links of one joint differ from each other.
        let others = by_link.keys().filter(|other| !only.links.contains(other));
        let nearest = others.min_by_key(|other| edits(name, other));
        let advice = nearest.map_or_else(String::new, |nearest| {
            format!("; the name next to it is `{}`", shown(nearest))
        });
        format!(
            "line {}: only the joint `{}` has the link `{}`{advice}",
            line_number(text, only.row),
            shown(only.joint),
            shown(name)
        )
    };
    singles.take(MOST_WARNINGS).map(warning).collect()
}

/// Returns the number of letters that must be added, removed or replaced between two names.
fn edits(first: &str, second: &str) -> usize {
    let second: Vec<char> = second.chars().take(MOST_LETTERS).collect();
    let mut row: Vec<usize> = (0..=second.len()).collect();
    for (above, letter) in first.chars().take(MOST_LETTERS).enumerate() {
        let mut diagonal = row[0];
        row[0] = above + 1;
        for (index, other) in second.iter().enumerate() {
            let replaced = diagonal + usize::from(letter != *other);
            diagonal = row[index + 1];
            row[index + 1] = replaced.min(diagonal + 1).min(row[index] + 1);
        }
    }
    row[second.len()]
}
