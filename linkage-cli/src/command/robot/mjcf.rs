//! A mechanism as MJCF, the format of MuJoCo.

use linkage_language::syntax::JointKind;

use super::bars::{bar_radius, bars};
use super::coordinates::{Coordinate, origin_on_parent};
use super::coupling::Coupling;
use super::heading::Heading;
use super::inertial::{Inertials, block_mass};
use super::joint_relations::{Relations, write_polynomials};
use super::jointed_links::{Closure, Freedom};
use super::skeleton::Skeleton;
use super::space_vectors::{AXES, Vector, difference, scaled, sum};
use super::wheel_relations::{write_equations, write_tendons};
use super::xml::{Lines, number, numbers};

/// The second point on the axis of a pin in space, as a part of the size.
const ALONG_AXIS: f64 = 0.25;

/// The equations between joints or bodies.
pub(super) enum Equations {
    /// Loops as constraints between bodies, and relations between joints.
    Loops(Relations),
    /// Joints as polynomials of the driving one.
    Polynomials(Vec<Coupling>),
}

/// A description that is being written.
struct Model<'a> {
    skeleton: &'a Skeleton<'a>,
    heading: &'a Heading,
    inertials: &'a Inertials,
    closing: &'a Equations,
    coordinates: &'a [Coordinate],
    lines: Lines,
}

/// The highest power of the equality between two joints (MuJoCo's XML reference, `equality/joint`).
pub(super) const DEGREE: usize = 4;

/// Returns the text of the model.
pub(super) fn text(
    skeleton: &Skeleton,
    heading: &Heading,
    inertials: &Inertials,
    closing: &Equations,
    coordinates: &[Coordinate],
) -> String {
    let mut model = Model {
        skeleton,
        heading,
        inertials,
        closing,
        coordinates,
        lines: Lines::default(),
    };
    model.write();
    model.lines.finish()
}

impl Model<'_> {
    fn write(&mut self) {
        let name = &self.heading.name;
        self.lines.open(&format!("<mujoco model=\"{name}\">"));
        for remark in &self.heading.remarks {
            self.lines.comment(remark);
        }
        self.lines.line("<compiler angle=\"radian\"/>");
        let gravity = numbers(&self.skeleton.gravity);
        self.lines.line(&format!("<option gravity=\"{gravity}\"/>"));
        self.lines.open("<worldbody>");
        // Readers of MJCF exist that take the first body of the world only.
        self.lines.open("<body name=\"frame\">");
        self.on_body(None);
        self.lines.close("body");
        self.lines.close("worldbody");
        match self.closing {
            Equations::Loops(relations) => self.loops(relations),
            Equations::Polynomials(couplings) => self.polynomials(couplings),
        }
        self.lines.close("mujoco");
    }

    /// Sites, blocks and bodies that are fixed or hang on a body.
    fn on_body(&mut self, body: Option<usize>) {
        if matches!(self.closing, Equations::Loops(_)) {
            for closure in &self.skeleton.closures {
                self.sites(closure, body);
            }
        }
        for index in 0..self.skeleton.links.len() {
            if self.skeleton.links[index].parent == body {
                self.link(index);
            }
        }
    }

    fn link(&mut self, index: usize) {
        let link = &self.skeleton.links[index];
        let at = numbers(&origin_on_parent(self.skeleton, link));
        let name = &link.name;
        self.lines
            .open(&format!("<body name=\"{name}\" pos=\"{at}\">"));
        self.joints(index);
        let mass = &self.inertials.masses[index];
        let i = &mass.inertia;
        self.lines.line(&format!(
            "<inertial pos=\"{}\" mass=\"{}\" fullinertia=\"{}\"/>",
            numbers(&mass.centre),
            number(mass.mass),
            numbers(&[i[0][0], i[1][1], i[2][2], i[0][1], i[0][2], i[1][2]])
        ));
        self.bars(index);
        self.on_body(Some(index));
        self.lines.close("body");
    }

    fn joints(&mut self, index: usize) {
        let link = &self.skeleton.links[index];
        if link.freedoms == [Freedom::Ball] && matches!(self.closing, Equations::Loops(_)) {
            let name = &link.joint;
            self.lines
                .line(&format!("<joint name=\"{name}\" type=\"ball\"/>"));
            return;
        }
        let coordinates = self.coordinates.iter().enumerate();
        for (coordinate_index, coordinate) in coordinates.filter(|(_, c)| c.link == index) {
            let (kind, axis) = match coordinate.freedom {
                Freedom::Slide(axis) => ("slide", axis),
                Freedom::Hinge(axis) => ("hinge", axis),
                // Those of a ball are three hinges.
                Freedom::Ball => ("ball", AXES[2]),
            };
            let name = &coordinate.name;
            let axis = numbers(&axis);
            let mut text = format!("<joint name=\"{name}\" type=\"{kind}\" axis=\"{axis}\"");
            let driver = &self.heading.driver;
            if *name == driver.name {
                if driver.zero != 0.0 {
                    text += &format!(" ref=\"{}\"", number(driver.zero));
                }
                if let Some(limits) = driver.limits {
                    let limits = limits.map(|end| end + driver.zero);
                    text += &format!(" range=\"{}\"", numbers(&limits));
                }
            }
            if let Equations::Loops(relations) = self.closing
                && let Some(limits) = relations.limits(coordinate_index)
            {
                text += &format!(" range=\"{}\"", numbers(&limits));
            }
            self.lines.line(&(text + "/>"));
        }
    }

    /// Bars from the origin of a body to what is on it, which have no mass and touch nothing.
    fn bars(&mut self, index: usize) {
        let skeleton = self.skeleton;
        let radius = bar_radius(skeleton);
        for end in bars(skeleton, index) {
            self.lines.line(&format!(
                "<geom type=\"capsule\" fromto=\"0 0 0 {}\" size=\"{}\" mass=\"0\" contype=\"0\" conaffinity=\"0\"/>",
                numbers(&end),
                number(radius)
            ));
        }
    }

    /// The points of a closure that are on a body, each with the name of its number.
    fn sites(&mut self, closure: &Closure, body: Option<usize>) {
        let skeleton = self.skeleton;
        let origin = body.map_or([0.0; 3], |index| skeleton.links[index].origin);
        let local = difference(closure.at, origin);
        let name = &closure.name;
        let ends = closure_points(closure, skeleton);
        let [first, second] = closure.bodies;
        if first == body {
            for (number, offset) in ends.iter().enumerate() {
                let at = numbers(&sum(local, *offset));
                self.lines
                    .line(&format!("<site name=\"{name}_a{number}\" pos=\"{at}\"/>"));
            }
        }
        if second != body {
            return;
        }
        let at = numbers(&local);
        let block = closure.kind.slides();
        if block {
            let axis = numbers(&closure.along.unwrap_or(AXES[0]));
            let (mass, moment) = block_mass(self.inertials, skeleton.size());
            let [mass, moment] = [mass, moment].map(number);
            self.lines
                .open(&format!("<body name=\"{name}_block\" pos=\"{at}\">"));
            self.lines.line(&format!(
                "<joint name=\"{name}_slide\" type=\"slide\" axis=\"{axis}\"/>"
            ));
            self.lines.line(&format!(
                "<inertial pos=\"0 0 0\" mass=\"{mass}\" diaginertia=\"{moment} {moment} {moment}\"/>"
            ));
        }
        for (number, offset) in ends.iter().enumerate() {
            let at = match block {
                true => *offset,
                false => sum(local, *offset),
            };
            let at = numbers(&at);
            self.lines
                .line(&format!("<site name=\"{name}_b{number}\" pos=\"{at}\"/>"));
        }
        if block {
            self.lines.close("body");
        }
    }

    fn loops(&mut self, relations: &Relations) {
        if self.skeleton.closures.is_empty() && relations.is_empty() {
            return;
        }
        write_tendons(&relations.wheels, self.coordinates, &mut self.lines);
        self.lines.open("<equality>");
        for closure in &self.skeleton.closures {
            let name = &closure.name;
            let element = match closure.kind {
                JointKind::Fixed | JointKind::Slide => "weld",
                JointKind::Pin | JointKind::Ball | JointKind::Roller | JointKind::Cylinder => {
                    "connect"
                }
            };
            for number in 0..closure_points(closure, self.skeleton).len() {
                self.lines.line(&format!(
                    "<{element} site1=\"{name}_a{number}\" site2=\"{name}_b{number}\"/>"
                ));
            }
        }
        write_equations(&relations.wheels, self.coordinates, &mut self.lines);
        write_polynomials(
            &relations.polynomials,
            self.coordinates,
            DEGREE + 1,
            &mut self.lines,
        );
        self.lines.close("equality");
    }

    fn polynomials(&mut self, couplings: &[Coupling]) {
        self.lines.open("<equality>");
        for coupling in couplings {
            let coordinate = &self.coordinates[coupling.coordinate];
            self.lines
                .comment(&self.heading.remark(coordinate, coupling));
            let mut powers = coupling.coefficients.clone();
            powers.resize(DEGREE + 1, 0.0);
            let driver = match coupling.coefficients.is_empty() {
                true => String::new(),
                false => format!(" joint2=\"{}\"", self.heading.driver.name),
            };
            self.lines.line(&format!(
                "<joint joint1=\"{}\"{driver} polycoef=\"{}\"/>",
                coordinate.name,
                numbers(&powers)
            ));
        }
        self.lines.close("equality");
    }
}

/// The points that a closure joins, from its place: two on the axis of a pin in space.
fn closure_points(closure: &Closure, skeleton: &Skeleton) -> Vec<Vector> {
    let keeps_axis = matches!(closure.kind, JointKind::Pin | JointKind::Cylinder);
    match closure.along {
        Some(axis) if keeps_axis && !skeleton.is_plane => {
            vec![[0.0; 3], scaled(axis, ALONG_AXIS * skeleton.size())]
        }
        _ => vec![[0.0; 3]],
    }
}
