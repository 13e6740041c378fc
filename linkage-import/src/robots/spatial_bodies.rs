//! Bodies of space with their masses: the axes of a body are those of the drawing, turned with it.

use super::model::{Mass, Motion};
use super::spatial::Writer;
use super::wording::digits;
use crate::placement::{AXES, Vector, difference, dot, length, scaled};

/// A rod is slender if its centre is on its line, up to this part of its length.
const ON_LINE: f64 = 1e-6;

impl Writer<'_, '_> {
    /// Writes the bodies with their masses, if none of them floats.
    pub(super) fn masses(&mut self) {
        let robot = self.wording.chain.robot;
        let joints = robot.bodies.iter().filter_map(|body| body.joint.as_ref());
        if joints.clone().any(|joint| joint.motion == Motion::Free) {
            if robot.bodies.iter().any(|body| body.mass().is_some()) {
                let warning = "masses are left out, because a body floats";
                self.sections.warnings.push(warning.to_owned());
            }
            return;
        }
        if let Some(gravity) = robot.gravity {
            let [x, y, z] = gravity.map(digits);
            self.sections
                .bodies
                .push(format!("gravity = ({x}m/s^2, {y}m/s^2, {z}m/s^2);"));
        }
        for index in 1..robot.bodies.len() {
            self.body_with_mass(index);
        }
        self.sections.bodies.append(&mut self.closing_joints);
    }

    fn body_with_mass(&mut self, index: usize) {
        let body = &self.wording.chain.robot.bodies[index];
        let Some(joint) = &body.joint else { return };
        let on = self.wording.bodies[joint.parent].clone();
        let pivot = self.wording.pivots[index].clone();
        let name = self.wording.joint_name(index);
        let mut line = format!("body {} = ", self.wording.bodies[index]);
        let mass = body.mass();
        if self.is_rod(index) {
            line += &self.rod(index, &on, &pivot, mass, joint.at);
            self.sections.bodies.push(line + ";");
            return;
        }
        let turns = match joint.motion {
            Motion::Ball | Motion::Free => self.wording.joints[index].clone(),
            Motion::Hinge(_) | Motion::Slide(_) | Motion::Fixed => {
                let [x, _, z] = AXES.map(|axis| self.direction(index, axis));
                format!("frame({pivot}, {x}, {z})")
            }
        };
        line += &match joint.motion {
            Motion::Hinge(axis) => {
                let axis = self.direction(joint.parent, axis);
                format!("pin{name} on {on} at {pivot} about {axis}, turns {turns}")
            }
            Motion::Slide(axis) => {
                let axis = self.direction(joint.parent, axis);
                format!("slide{name} on {on} at {pivot} along {axis}, turns {turns}")
            }
            Motion::Fixed => format!("fixed{name} on {on} at {pivot}, turns {turns}"),
            Motion::Ball | Motion::Free => format!("ball{name} on {on} at {pivot}, turns {turns}"),
        };
        if let Some(mass) = mass {
            let centre = self.carried(index, mass.centre, "centre");
            line += &format!(", mass {}kg at {centre}", digits(mass.mass));
            if mass.inertia.iter().flatten().any(|number| *number != 0.0) {
                line += &format!(", inertia {}", tensor(mass.inertia));
            }
        }
        self.sections.bodies.push(line + ";");
    }

    /// Returns the item of a rod between two balls after its name. Its spin has no effect.
    fn rod(
        &mut self,
        index: usize,
        on: &str,
        pivot: &str,
        mass: Option<Mass>,
        at: Vector,
    ) -> String {
        let end = self.rod_ends[&index].clone();
        let name = self.wording.joint_name(index);
        let mut line = format!("ball{name} on {on} at {pivot}, turns {end} - {pivot}");
        let Some(mass) = mass else { return line };
        let mut rods = self.wording.chain.rods.iter();
        let rod = rods.find(|rod| rod.body == index);
        let rod = rod.copied().expect("the body is a rod");
        let closure = &self.wording.chain.robot.closures[rod.closure];
        let near = usize::from(closure.bodies[1] == index);
        let along = difference(closure.at[near], at);
        let to_centre = difference(mass.centre, at);
        let share = dot(to_centre, along) / dot(along, along);
        let beside = length(difference(to_centre, scaled(along, share)));
        if beside.is_nan() || beside > ON_LINE * rod.length {
            let name = &self.wording.bodies[index];
            self.sections.warnings.push(format!(
                "the mass of the rod `{name}` is left out: its centre is beside its line"
            ));
            return line;
        }
        let unit = scaled(along, 1.0 / length(along));
        let axial = dot(unit, mass.inertia.map(|row| dot(row, unit)));
        let trace = mass.inertia[0][0] + mass.inertia[1][1] + mass.inertia[2][2];
        let across = (trace - axial) / 2.0;
        line += &format!(
            ", mass {}kg at {pivot} + {} * ({end} - {pivot})",
            digits(mass.mass),
            digits(share)
        );
        if across > 0.0 {
            line += &format!(", inertia {}kg*m^2", digits(across));
        }
        line
    }
}

/// Returns a tensor as text.
fn tensor(rows: [Vector; 3]) -> String {
    let rows = rows.map(|row| {
        let numbers = row.map(|number| format!("{}kg*m^2", digits(number)));
        format!("({})", numbers.join(", "))
    });
    format!("({})", rows.join(", "))
}
