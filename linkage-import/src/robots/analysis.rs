//! Which joints are inputs, and which equations follow from others.

use super::chain::Chain;
use super::effort::Effort;
use super::equations::Equation;
use crate::error::ImportError;
use crate::names::shown;

/// A part of a direction that is this small is rounding: eight decimals of a file.
const RANK: f64 = 1e-6;

/// Vectors at right angles, to which others are added if they are independent.
#[derive(Default)]
struct Basis {
    vectors: Vec<Vec<f64>>,
}

impl Basis {
    /// Adds a vector; false if it depends on those that there are.
    fn add(&mut self, vector: &[f64]) -> bool {
        let size = |vector: &[f64]| vector.iter().map(|x| x * x).sum::<f64>().sqrt();
        let before = size(vector);
        let mut rest = vector.to_vec();
        // Twice, against rounding.
        for _ in 0..2 {
            for unit in &self.vectors {
                let part: f64 = unit.iter().zip(&rest).map(|(a, b)| a * b).sum();
                for (number, unit) in rest.iter_mut().zip(unit) {
                    *number -= part * unit;
                }
            }
        }
        let after = size(&rest);
        if after <= RANK * before.max(RANK) || after.is_nan() {
            return false;
        }
        rest.iter_mut().for_each(|number| *number /= after);
        self.vectors.push(rest);
        true
    }
}

/// Results for a robot.
pub(super) struct Analysis {
    /// The coordinates that are inputs, as indices.
    pub(super) inputs: Vec<usize>,
    /// For each equation, false if it follows from those before it.
    pub(super) is_needed: Vec<bool>,
    /// All equations where the robot is drawn.
    pub(super) rows: Vec<Equation>,
    /// The effort that is left for searches of ranges.
    pub(super) effort: Effort,
    /// The gap of each closure where it is drawn, as a part of the size or in radians.
    pub(super) gaps: Vec<f64>,
}

/// Chooses inputs: those of these names, else driven joints, else the first ones of the file.
pub(super) fn analyse(chain: &Chain, names: &[String]) -> Result<Analysis, ImportError> {
    let pose = chain.drawn();
    let rows = chain.rows(&pose);
    let mut basis = Basis::default();
    let is_needed: Vec<bool> = rows.iter().map(|row| basis.add(&row.changes)).collect();
    let mut gaps = vec![0.0; chain.robot.closures.len()];
    for row in &rows {
        let gap: &mut f64 = &mut gaps[row.closure];
        *gap = gap.max(row.error.abs());
    }
    let wanted = wanted(chain, names)?;
    // Those that are least wanted as inputs come first and depend on the equations.
    let rank = |index: &usize| {
        let coordinate = &chain.coordinates[*index];
        let joint = chain.robot.bodies[coordinate.body].joint.as_ref();
        let is_driven = joint.is_some_and(|joint| joint.is_driven);
        let is_wanted = wanted.contains(index);
        (coordinate.is_scalar, is_wanted, is_driven)
    };
    let mut order: Vec<usize> = (0..chain.coordinates.len()).rev().collect();
    order.retain(|index| chain.is_independent(&chain.coordinates[*index]));
    order.sort_by_key(rank);
    let mut columns = Basis::default();
    let mut inputs = Vec::new();
    for index in order {
        let column: Vec<f64> = rows.iter().map(|row| row.changes[index]).collect();
        if !columns.add(&column) {
            inputs.push(index);
        }
    }
    inputs.sort_unstable();
    for index in &inputs {
        let coordinate = &chain.coordinates[*index];
        if !coordinate.is_scalar {
            let joint = chain.robot.bodies[coordinate.body].joint.as_ref();
            return Err(ImportError::new(format!(
                "nothing determines all motions of the joint `{}`, and a ball or a floating body cannot be an input\nhelp: a rod may have one body and two balls; give other bodies a closure or a hinge",
                shown(joint.map_or("", |joint| joint.name.as_str()))
            )));
        }
    }
    if let Some(refused) = wanted.iter().find(|index| !inputs.contains(index)) {
        let body = chain.coordinates[*refused].body;
        let joint = chain.robot.bodies[body].joint.as_ref();
        return Err(ImportError::new(format!(
            "the joint `{}` cannot be an input as well: the mechanism has {} and the others determine it",
            shown(joint.map_or("", |joint| joint.name.as_str())),
            match inputs.len() {
                1 => "one freedom".to_owned(),
                count => format!("{count} freedoms"),
            }
        )));
    }
    Ok(Analysis {
        inputs,
        is_needed,
        rows,
        effort: Effort::new(),
        gaps,
    })
}

/// The coordinates of the joints with these names.
fn wanted(chain: &Chain, names: &[String]) -> Result<Vec<usize>, ImportError> {
    let find = |name: &String| {
        let body = chain.robot.joint_named(name);
        let coordinates = &chain.coordinates;
        let index = coordinates
            .iter()
            .position(|c| Some(c.body) == body && c.is_scalar);
        index.ok_or_else(|| {
            let joints = chain.robot.bodies.iter();
            let joints = joints.filter_map(|body| body.joint.as_ref());
            let names: Vec<String> = joints
                .take(20)
                .map(|joint| format!("`{}`", shown(&joint.name)))
                .collect();
            ImportError::new(format!(
                "there is no hinge or slide `{}` to be an input; there is {}",
                shown(name),
                names.join(", ")
            ))
        })
    };
    names.iter().map(find).collect()
}
