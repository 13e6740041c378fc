//! The same assembly for other dimensions, followed along the straight way to them.

use super::InitialState;
use super::assembling::{MechanismPath, PlainGroups};
use super::settle::moved;
use crate::error::{AssemblyError, GroupRef};
use alloc::vec;
use alloc::vec::Vec;
use linkage_core::Level;
use linkage_core::numeric::continuation::{Correction, Grid, Range, Table, Terms};
use linkage_core::numeric::range::first_failure;

/// The longest step, and the shortest one, as parts of the path. A step is certified by small
/// changes of the states, which set the length of most steps; longer steps would only fail.
const LONGEST: f64 = 1.0 / 4.0;
const SHORTEST: f64 = 1e-7;

/// Places on the way at which slacks are looked at before dips between them are.
const SAMPLES: usize = 64;

/// A place on the way.
struct PathPoint {
    share: f64,
    /// The states of the coupled groups.
    states: Vec<Vec<f64>>,
    determinants: Vec<f64>,
    /// The slacks of all groups; 1 for coupled ones.
    slacks: Vec<f64>,
}

/// A cause why a path ends.
enum PathEnd {
    /// The group with this number.
    Group(usize),
    Error(AssemblyError),
}

impl From<AssemblyError> for PathEnd {
    fn from(error: AssemblyError) -> Self {
        Self::Error(error)
    }
}

/// Follows an assembly whose coupled groups are in these `states` from 0 to 1, and returns their
/// states there.
///
/// # Errors
///
/// [`AssemblyError::Blocked`] where it cannot be followed any further.
pub(super) fn follow_path<C: PlainGroups>(
    path: &MechanismPath<'_, C>,
    states: Vec<Vec<f64>>,
) -> Result<Vec<Vec<f64>>, AssemblyError> {
    let description = path.description();
    let blocked = |share: f64, obstacle: PathEnd| match obstacle {
        PathEnd::Error(error) => error,
        PathEnd::Group(group) => AssemblyError::Blocked {
            group: GroupRef::new(description.name, group, &description.groups[group]),
            share,
        },
    };
    if let Some((share, group)) = first_end(path) {
        return Err(blocked(share, PathEnd::Group(group)));
    }
    let unknown = vec![0.0; states.len()];
    let start = PathPoint {
        share: 0.0,
        states,
        determinants: unknown,
        slacks: Vec::new(),
    };
    let first = step(path, &start, 0.0).map_err(|obstacle| blocked(0.0, obstacle))?;
    if first.states.is_empty() {
        return Ok(first.states);
    }
    let (mut points, obstacle) = walk(path, first);
    if let Some((share, group)) = first_dip(path, &points) {
        return Err(blocked(share, PathEnd::Group(group)));
    }
    let last = points.remove(points.len() - 1);
    match obstacle {
        Some(obstacle) => Err(blocked(last.share, obstacle)),
        None => Ok(last.states),
    }
}

/// The places from the first one to the end of the way, or to an obstacle.
fn walk<C: PlainGroups>(
    path: &MechanismPath<'_, C>,
    first: PathPoint,
) -> (Vec<PathPoint>, Option<PathEnd>) {
    let mut points = vec![first];
    let mut length = LONGEST;
    while let last = &points[points.len() - 1]
        && last.share < 1.0
    {
        match step(path, last, (last.share + length).min(1.0)) {
            Ok(next) => {
                points.push(next);
                length = (2.0 * length).min(LONGEST);
            }
            Err(obstacle) if length < SHORTEST => return (points, Some(obstacle)),
            Err(_) => length *= 0.5,
        }
    }
    (points, None)
}

/// The first place between others where a group after a coupled one comes apart, and the group.
fn first_dip<C: PlainGroups>(
    path: &MechanismPath<'_, C>,
    points: &[PathPoint],
) -> Option<(f64, usize)> {
    let coupled = |group: &usize| matches!(path.levels()[*group], Level::Coupled(_));
    let behind = (0..path.levels().len()).skip_while(|group| !coupled(group));
    let behind: Vec<usize> = behind.filter(|group| !coupled(group)).collect();
    let (first, last) = (points.first()?, points.last()?);
    if behind.is_empty() {
        return None;
    }
    // The groups, by how much of its slack each has, the least first.
    let least = |share: f64| -> (f64, usize) {
        let nearest = points.partition_point(|point| point.share <= share).max(1) - 1;
        let there = reach(path, &points[nearest], share);
        let part = |&group: &usize| match &there {
            Ok(there) => there.slacks[group] / first.slacks[group],
            Err(_) => f64::NAN,
        };
        let parts = behind.iter().map(|group| (part(group), *group));
        // NaN first, which nothing is less than.
        parts.fold((f64::INFINITY, 0), |least, group_part| {
            if group_part.0 >= least.0 || least.0.is_nan() {
                least
            } else {
                group_part
            }
        })
    };
    let end = first_failure(0.0, last.share, 0.0, SAMPLES, |share| least(share).0)?;
    Some((end.at, least(end.at).1))
}

/// The first place where a group that no coupled one stands before comes apart, and the group.
fn first_end<C: PlainGroups>(path: &MechanismPath<'_, C>) -> Option<(f64, usize)> {
    let coupled = |level: &Level| matches!(level, Level::Coupled(_));
    let count = path
        .levels()
        .iter()
        .position(coupled)
        .unwrap_or(path.levels().len());
    let nothing =
        vec![InitialState::Nothing; path.levels().iter().filter(|level| coupled(level)).count()];
    let ends = (0..count).filter_map(|group| {
        let slack = |share: f64| path.survey(share, &nothing).as_ref()[1 + group];
        let first = slack(0.0);
        // A group with one solution goes through infinity where its slack changes the sign.
        let sign = match path.levels()[group] {
            Level::Single => first.signum(),
            Level::Modes(_) | Level::Coupled(_) => 1.0,
        };
        let along = |share: f64| sign * slack(share) / first.abs();
        let end = first_failure(0.0, 1.0, 0.0, SAMPLES, along)?;
        Some((if end.above { end.at } else { 0.0 }, group))
    });
    ends.min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The place at another share of the way, if one step leads there and all groups are assembled.
fn step<C: PlainGroups>(
    path: &MechanismPath<'_, C>,
    from: &PathPoint,
    share: f64,
) -> Result<PathPoint, PathEnd> {
    let next = reach(path, from, share)?;
    for (group, level) in path.levels().iter().enumerate() {
        let slack = next.slacks[group];
        let works = match (level, from.slacks.get(group)) {
            (Level::Single, Some(before)) => before * slack > 0.0,
            (Level::Single, None) => true,
            (Level::Modes(_) | Level::Coupled(_), _) => slack > 0.0,
        };
        if !works {
            return Err(PathEnd::Group(group));
        }
    }
    Ok(next)
}

/// The place at another share of the way, if one step of the coupled groups leads there. Other
/// groups may have come apart.
fn reach<C: PlainGroups>(
    path: &MechanismPath<'_, C>,
    from: &PathPoint,
    share: f64,
) -> Result<PathPoint, PathEnd> {
    let mut next = PathPoint {
        share,
        states: from.states.clone(),
        determinants: from.determinants.clone(),
        slacks: Vec::new(),
    };
    let mut initial_states = vec![InitialState::Nothing; from.states.len()];
    for (group, level) in path.levels().iter().enumerate() {
        let slack = match *level {
            Level::Coupled(number) => {
                let Some(programs) = path.coupled(share, &initial_states, number) else {
                    return Err(PathEnd::Group(group));
                };
                let (description, mut programs) = programs?;
                let x = description.inputs_among(path.inputs());
                let before = &from.states[number];
                let sign = from.determinants[number];
                let found = moved(&mut programs, description.variables, &x, before, sign);
                let (state, determinant) = found.ok_or(PathEnd::Group(group))?;
                next.determinants[number] = determinant;
                // Only groups after it would read that.
                if group + 1 < path.levels().len() {
                    initial_states[number] =
                        state_here(&mut programs, &x, &state).ok_or(PathEnd::Group(group))?;
                }
                next.states[number] = state;
                1.0
            }
            Level::Modes(_) | Level::Single => {
                path.survey(share, &initial_states).as_ref()[1 + group]
            }
        };
        next.slacks.push(slack);
    }
    Ok(next)
}

/// Prepares a solution at its group's inputs alone; `None` where it cannot be certified.
pub(super) fn state_here(
    programs: &mut dyn Correction,
    x: &[f64],
    state: &[f64],
) -> Option<InitialState> {
    let range = |&x: &f64| Range {
        low: x,
        high: x,
        turn: false,
    };
    match *x {
        [only] => Table::build(programs, only, state, range(&only), true)
            .map(InitialState::Table)
            .ok(),
        _ => {
            let ranges: Vec<Range> = x.iter().map(range).collect();
            Grid::build(programs, x, state, &ranges, Terms::Slopes)
                .map(InitialState::Grid)
                .ok()
        }
    }
}
