//! The joints that close loops, and relations between joints, as equations.

use linkage_engine::Mechanism;
use linkage_language::syntax::JointKind;

use super::coordinates::{Coordinate, built};
use super::joint_relations::Relations;
use super::jointed_links::{Closure, Pose, pose_of};
use super::skeleton::Skeleton;
use super::space_vectors::{
    Vector, across, cross, difference, dot, product, scaled, transposed, turned,
};

/// Steps of the coordinates for derivatives, in radians or parts of the size.
const STEP: f64 = 1e-5;

/// Pivots below this are zero, in equations divided by the size.
const PIVOT: f64 = 1e-7;

/// Two unit vectors across an axis.
fn normals(axis: Vector) -> [Vector; 2] {
    let first = across(axis);
    [first, cross(axis, first)]
}

/// The number of independent motions that joints, closures and relations leave at the reference.
pub(super) fn freedoms_left(
    skeleton: &Skeleton,
    relations: &Relations,
    coordinates: &[Coordinate],
) -> usize {
    let size = skeleton.size();
    let count = coordinates.len();
    let equations = |values: &[f64]| {
        let poses = built(skeleton, values);
        let closures = skeleton.closures.iter();
        let all = closures.flat_map(|closure| residuals(skeleton, closure, &poses, size));
        all.chain(relations.sums(values)).collect::<Vec<f64>>()
    };
    let mut columns: Vec<Vec<f64>> = (0..count)
        .map(|index| {
            let is_length = coordinates[index].is_length();
            let step = STEP * if is_length { size } else { 1.0 };
            let [ahead, behind] = [step, -step].map(|step| {
                let mut values = vec![0.0; count];
                values[index] = step;
                equations(&values)
            });
            let pairs = ahead.iter().zip(&behind);
            pairs.map(|(a, b)| (a - b) / (2.0 * STEP)).collect()
        })
        .collect();
    count - rank(&mut columns)
}

/// Returns the number of independent motions of the mechanism, idle turns of rods among them.
pub(super) fn motions(mechanism: &Mechanism, skeleton: &Skeleton) -> usize {
    let spins = (0..skeleton.links.len()).filter(|index| skeleton.spins(*index));
    mechanism.inputs().len() + spins.count()
}

/// What a closure keeps at zero, lengths as parts of the size.
fn residuals(skeleton: &Skeleton, closure: &Closure, poses: &[Pose], size: f64) -> Vec<f64> {
    let [a, b] = closure.bodies;
    let apart = difference(
        skeleton.carried(poses, a, closure.at),
        skeleton.carried(poses, b, closure.at),
    );
    let apart = scaled(apart, 1.0 / size);
    let [of_a, of_b] = [a, b].map(|body| pose_of(poses, body).rotation);
    let across = || {
        let axis = closure.along.unwrap_or([0.0, 0.0, 1.0]);
        normals(axis).map(|normal| turned(&of_b, normal))
    };
    let off_guide = || across().map(|normal| dot(normal, apart)).to_vec();
    let turned_apart = || {
        let relative = product(&transposed(&of_b), &of_a);
        vec![relative[0][1], relative[0][2], relative[1][2]]
    };
    let off_axis = || {
        let axis = closure.along.map(|axis| turned(&of_a, axis));
        let axis = axis.into_iter();
        axis.flat_map(|axis| across().map(|normal| dot(normal, axis)))
            .collect()
    };
    match closure.kind {
        JointKind::Ball => apart.to_vec(),
        JointKind::Pin if skeleton.is_plane => apart.to_vec(),
        JointKind::Pin => [apart.to_vec(), off_axis()].concat(),
        JointKind::Fixed => [apart.to_vec(), turned_apart()].concat(),
        JointKind::Slide => [off_guide(), turned_apart()].concat(),
        JointKind::Roller => off_guide(),
        JointKind::Cylinder => [off_guide(), off_axis()].concat(),
    }
}

/// The rank of a matrix; its columns are eliminated.
fn rank(columns: &mut [Vec<f64>]) -> usize {
    let rows = columns.first().map_or(0, Vec::len);
    let mut used = vec![false; columns.len()];
    let mut rank = 0;
    let mut open: Vec<usize> = (0..rows).collect();
    loop {
        let places = open
            .iter()
            .flat_map(|row| (0..columns.len()).map(move |column| (*row, column)));
        let places = places.filter(|(_, column)| !used[*column]);
        let size = |(row, column): &(usize, usize)| columns[*column][*row].abs();
        let Some((row, column)) = places.max_by(|a, b| size(a).total_cmp(&size(b))) else {
            return rank;
        };
        if columns[column][row].abs() < PIVOT {
            return rank;
        }
        used[column] = true;
        open.retain(|other| *other != row);
        rank += 1;
        let pivot = columns[column].clone();
        for (other, is_used) in columns.iter_mut().zip(&used) {
            if !is_used {
                let factor = other[row] / pivot[row];
                for (number, pivot) in other.iter_mut().zip(&pivot) {
                    *number -= factor * pivot;
                }
            }
        }
    }
}
