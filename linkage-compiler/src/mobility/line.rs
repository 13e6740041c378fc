//! Links as lines: how those lie that hold a body no better than fewer would.

use crate::vector::{Vector, cross, dot, minus, norm};

use super::null_space::{LITTLE, largest};
use super::{Mover, Position, Rows};

/// Where a link pulls a body: a direction of length 1, and the moment about the body's origin.
struct Line {
    along: Vector,
    moment: Vector,
}

impl Line {
    fn point(&self) -> Vector {
        cross(self.along, self.moment)
    }
}

/// What is special about these rows, if each is a link between one and the same body and what is known.
pub(super) fn shape_of_links(
    position: &Position<'_, '_>,
    rows: &Rows,
    bound: &[usize],
) -> Option<&'static str> {
    let lines: Vec<Line> = bound
        .iter()
        .map(|&row| line(position, rows, row))
        .collect::<Option<_>>()?;
    let [first, second, .., _] = &lines[..] else {
        return None;
    };
    let parallel = |line: &Line| norm(cross(first.along, line.along)) < LITTLE;
    let normal = match lines.iter().find(|line| !parallel(line)) {
        Some(other) => cross(first.along, other.along),
        None => cross(first.along, minus(second.point(), first.point())),
    };
    let offset = |line: &Line| minus(line.point(), first.point());
    let in_plane = |line: &Line| {
        dot(normal, line.along).abs() < LITTLE * norm(normal)
            && dot(normal, offset(line)).abs() < LITTLE * norm(normal)
    };
    if lines.iter().all(in_plane) {
        return Some("lie in one plane");
    }
    lines.iter().all(parallel).then_some("are parallel")
}

/// A row as a line, if it is one of a body alone.
fn line(position: &Position<'_, '_>, rows: &Rows, row: usize) -> Option<Line> {
    let own = &rows.matrix[row];
    let most = largest(own);
    let used = (0..own.len()).filter(|&k| own[k].abs() > LITTLE * most);
    let mut movers: Vec<usize> = used.map(|k| rows.columns[k].0).collect();
    movers.dedup();
    let [mover] = movers[..] else { return None };
    let Mover::Body { .. } = position.movers[mover] else {
        return None;
    };
    let first = rows
        .columns
        .iter()
        .position(|column| *column == (mover, 0))?;
    let along: Vector = [0, 1, 2].map(|k| own[first + k]);
    let moment: Vector = [0, 1, 2].map(|k| own[first + 3 + k]);
    let size = norm(along);
    let is_line = size > LITTLE * most && dot(along, moment).abs() <= LITTLE * size * most;
    is_line.then(|| Line {
        along: along.map(|x| x / size),
        moment: moment.map(|x| x / size),
    })
}
