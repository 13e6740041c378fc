//! The roles of points in a suspension, and the kinds of suspensions that they make.

use std::collections::BTreeMap;

use super::axes::Meaning;
use super::point_table::{Table, word};
use crate::error::ImportError;
use crate::names::shown;
use crate::number::half_digit;
use crate::options::Options;
use crate::placement::Vector;

/// All roles, each with its meaning.
pub(super) const ROLES: [(&str, &str); 34] = [
    ("wheel_centre", "the middle of the wheel"),
    ("spindle", "another point on the axis of the wheel"),
    ("contact", "the middle of the contact of the tyre"),
    (
        "lower_front",
        "front pivot of the lower wishbone on the chassis",
    ),
    (
        "lower_rear",
        "rear pivot of the lower wishbone on the chassis",
    ),
    (
        "lower_ball",
        "ball joint of the lower wishbone on the carrier",
    ),
    (
        "upper_front",
        "front pivot of the upper wishbone on the chassis",
    ),
    (
        "upper_rear",
        "rear pivot of the upper wishbone on the chassis",
    ),
    (
        "upper_ball",
        "ball joint of the upper wishbone on the carrier",
    ),
    ("strut_top", "upper mount of the strut on the chassis"),
    (
        "strut_bottom",
        "lower end of the strut, fixed on the carrier",
    ),
    ("tie_inner", "inner ball joint of the tie rod"),
    ("tie_outer", "outer ball joint of the tie rod"),
    ("rod1_inner", "first rod on the chassis"),
    ("rod1_outer", "first rod on the carrier"),
    ("rod2_inner", "second rod on the chassis"),
    ("rod2_outer", "second rod on the carrier"),
    ("rod3_inner", "third rod on the chassis"),
    ("rod3_outer", "third rod on the carrier"),
    ("rod4_inner", "fourth rod on the chassis"),
    ("rod4_outer", "fourth rod on the carrier"),
    ("rod5_inner", "fifth rod on the chassis"),
    ("rod5_outer", "fifth rod on the carrier"),
    ("push_carrier", "push rod on the carrier"),
    ("push_lower", "push rod on the lower wishbone"),
    ("push_upper", "push rod on the upper wishbone"),
    ("push_rocker", "push rod on the rocker"),
    ("rocker_pivot", "a point on the axis of the rocker"),
    ("rocker_axis", "another point on the axis of the rocker"),
    ("damper_chassis", "damper on the chassis"),
    ("damper_rocker", "damper on the rocker"),
    ("damper_carrier", "damper on the carrier"),
    ("damper_lower", "damper on the lower wishbone"),
    ("damper_upper", "damper on the upper wishbone"),
];

/// Kinds by the roles that they need.
const KINDS: [(&str, &[&str]); 3] = [
    (
        "double wishbone",
        &[
            "lower_front",
            "lower_rear",
            "lower_ball",
            "upper_front",
            "upper_rear",
            "upper_ball",
            "tie_inner",
            "tie_outer",
        ],
    ),
    (
        "strut",
        &[
            "lower_front",
            "lower_rear",
            "lower_ball",
            "strut_top",
            "strut_bottom",
            "tie_inner",
            "tie_outer",
        ],
    ),
    (
        "five rods",
        &[
            "rod1_inner",
            "rod1_outer",
            "rod2_inner",
            "rod2_outer",
            "rod3_inner",
            "rod3_outer",
            "rod4_inner",
            "rod4_outer",
            "rod5_inner",
            "rod5_outer",
        ],
    ),
];

/// Points by their roles: forward, left, up.
pub(super) struct Points {
    /// Double wishbone, strut or five rods.
    pub(super) kind: &'static str,
    pub(super) by_role: BTreeMap<&'static str, Vector>,
    /// Names in the file that are not the role.
    pub(super) names: BTreeMap<&'static str, String>,
    /// The largest rounding error of a coordinate.
    pub(super) band: f64,
    /// Points without a role, and what is no point.
    pub(super) others: Vec<String>,
}

impl Points {
    /// The point of a role.
    pub(super) fn point(&self, role: &str) -> Option<Vector> {
        self.by_role.get(role).copied()
    }

    /// True if there are points for all roles.
    pub(super) fn has(&self, roles: &[&str]) -> bool {
        roles.iter().all(|role| self.by_role.contains_key(role))
    }
}

/// Gives each point its role: that of its name, or of an option `ROLE=NAME`.
pub(super) fn points(
    table: Table,
    meaning: &Meaning,
    options: &Options,
) -> Result<Points, ImportError> {
    let mut roles: BTreeMap<String, &'static str> = BTreeMap::new();
    for (role, _) in ROLES {
        roles.insert(role.to_owned(), role);
    }
    for given in &options.roles {
        let Some((role, name)) = given.split_once('=') else {
            return Err(ImportError::new(format!(
                "`--role {}`: write `--role ROLE=NAME`",
                shown(given)
            )));
        };
        let Some((role, _)) = ROLES.iter().find(|known| known.0 == word(role)) else {
            return Err(ImportError::new(format!(
                "there is no role `{}`; there are\n{}",
                shown(role),
                list()
            )));
        };
        roles.insert(word(name), role);
    }
    let mut by_role = BTreeMap::new();
    let mut names = BTreeMap::new();
    let mut others = table.others;
    for point in table.points {
        match roles.get(&point.name) {
            Some(role) => {
                if by_role.insert(*role, meaning.point(point.at)).is_some() {
                    return Err(ImportError::new(format!(
                        "two points have the role `{role}`"
                    )));
                }
                if point.name != *role {
                    names.insert(*role, point.name);
                }
            }
            None => others.push(shown(&point.name)),
        }
    }
    let has = |roles: &[&str]| roles.iter().all(|role| by_role.contains_key(role));
    let found: Vec<&(&str, &[&str])> = KINDS.iter().filter(|(_, roles)| has(roles)).collect();
    let kind = match found[..] {
        [only] => only.0,
        [] => return Err(incomplete(&by_role, &others)),
        [first, second, ..] => {
            return Err(ImportError::new(format!(
                "the points make a {} and a {}: leave one out",
                first.0, second.0
            )));
        }
    };
    if !by_role.contains_key("wheel_centre") {
        return Err(ImportError::new(
            "there is no point with the role `wheel_centre`, whose height is the input",
        ));
    }
    Ok(Points {
        kind,
        by_role,
        names,
        band: half_digit(table.decimals),
        others,
    })
}

/// The message for a table that makes no suspension: what is missing in the nearest kind.
fn incomplete(by_role: &BTreeMap<&'static str, Vector>, others: &[String]) -> ImportError {
    let missing = |roles: &[&'static str]| -> Vec<&'static str> {
        let roles = roles.iter().copied();
        roles.filter(|role| !by_role.contains_key(role)).collect()
    };
    let nearest = KINDS.iter().min_by_key(|(_, roles)| missing(roles).len());
    let (kind, roles) = nearest.unwrap_or(&KINDS[0]);
    let names = others[..others.len().min(20)].join(", ");
    if by_role.is_empty() {
        return ImportError::new(format!(
            "no point has a role: {names}\nhelp: rename the points, or give each its role by `--role ROLE=NAME`; roles are\n{}",
            list()
        ));
    }
    let without = match others.len() {
        0 => String::new(),
        _ => format!("; points without a role: {names}"),
    };
    ImportError::new(format!(
        "the points make no suspension: a {kind} needs also {}{without}\nhelp: rename the points, or give each its role by `--role ROLE=NAME`; roles are\n{}",
        missing(roles).join(", "),
        list()
    ))
}

fn list() -> String {
    let lines: Vec<String> = ROLES
        .iter()
        .map(|(role, meaning)| format!("  {role}: {meaning}"))
        .collect();
    lines.join("\n")
}
